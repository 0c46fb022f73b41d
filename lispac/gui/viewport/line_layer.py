"""Drawn lines of one placement: coarse during camera movements, detailed at rest.

This module does not import VTK: the functions of `actors` create its objects.
"""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.gui.viewport.actors import (
    clip_actors,
    darker_colour,
    point_actor,
    point_polydata,
    set_point_pixels,
    shift_depth,
)
from lispac.gui.viewport.base import SHADED_EDGE_COLOUR, Array, Colour, PointColouring
from lispac.gui.viewport.camera import Camera, ViewportSize
from lispac.gui.viewport.clipping import Box
from lispac.gui.viewport.decimation import line_budgets, lowest_ranked, points_in_view, random_ranks
from lispac.gui.viewport.frame_times import SLICE_FRACTIONS

MAX_COORDINATE_M = 1e4
"""Largest coordinate of the middle of lines that are drawn relative to the local origin.

Drawn coordinates are float32, which resolves a millimetre up to this coordinate.
"""

RIM_DEPTH_SHIFT = 0.006
"""Shift of the rims behind their points, as a share of the distance from the eye."""


class LineLayer:
    """Lines drawn by a renderer.

    Attributes
    ----------
    colours, shading : colour of each line, and colours of single points, which have priority
    visible : points (n, 3) in the clip box of each line that is not hidden, metres, local frame
    sparse : points of each line that can be drawn while the camera moves
    detail : points of each line in view that were drawn at the last rest of the camera
    origin : ndarray of shape (3,), metres, local frame
        Origin of the drawn coordinates.
    half : half space to which the drawing is limited; None for no limit
    """

    def __init__(self, renderer: Any) -> None:
        self._renderer = renderer
        self.colours: dict[str, Colour] = {}
        self.shading: PointColouring | None = None
        self._clouds: dict[str, Array] = {}
        self._indices_in_box: dict[str, NDArray[np.int64] | None] = {}
        self._box: Box | None = None
        self.half: Any = None
        self._coarse: list[tuple[int, Any]] = []  # index of the slice, and its actor
        self._ranks: dict[str, NDArray[np.float32]] = {}
        # Number of points, indices in the box, and indices of the points ordered by rank
        self._orders: dict[str, tuple[int, NDArray[np.int64] | None, NDArray[np.int64]]] = {}
        self._fine: list[Any] = []
        self._rims: list[Any] = []
        self._fine_key: tuple[Camera, int] | None = None  # camera and budget of the fine points
        self.visible: dict[str, Array] = {}
        self.sparse: dict[str, Array] = {}
        self.detail: dict[str, Array] = {}
        self.origin: Array = np.zeros(3)

    @property
    def clouds(self) -> Mapping[str, Array]:
        """All lines that have points, including hidden ones."""
        return self._clouds

    def set_lines(
        self,
        clouds: Mapping[str, Array],
        colours: Mapping[str, Colour],
        shading: PointColouring | None = None,
    ) -> None:
        """Set the lines without drawing them."""
        former = self._ranks
        self._clouds = {line: points for line, points in clouds.items() if len(points)}
        self.colours, self.shading = dict(colours), shading
        self._ranks = {}
        for line, points in self._clouds.items():
            known = former.get(line)
            is_same = known is not None and len(known) == len(points)  # perhaps placed differently
            self._ranks[line] = known if is_same else random_ranks(len(points))
        self._indices_in_box, self._box = {}, None
        self._orders = {
            line: order for line, order in self._orders.items()
            if order[1] is None and former[line] is self._ranks.get(line)
        }  # fmt: skip

    def draw(self, hidden: set[str], budget: int, box: Box | None = None) -> None:
        """Draw the lines that are not hidden coarsely, within the box.

        Parameters
        ----------
        budget : largest total number of drawn points
        """
        self.remove()
        shown = {line: p for line, p in self._clouds.items() if line not in hidden}
        if box is not self._box:
            self._indices_in_box, self._box = {}, box
        for line, points in shown.items():
            if line not in self._indices_in_box:
                self._indices_in_box[line] = None if box is None else box.inside(points)
        self.visible = {line: self._points_in_box(line, points) for line, points in shown.items()}
        share = line_budgets({line: len(points) for line, points in self.visible.items()}, budget)
        shaded = self.shading is not None
        self.sparse, self._coarse = {}, []
        for line, points in self.visible.items():
            chosen = self._ordered_points(line, share[line])
            sparse = self.sparse[line] = points.take(chosen, axis=0)
            start = 0
            for k, fraction in enumerate(SLICE_FRACTIONS):
                end = -int(-fraction * len(chosen) // 1)
                part_points, indices = sparse[start:end], chosen[start:end]
                start = end
                if len(part_points):
                    shades = self._point_colours(line, indices)
                    data = point_polydata(part_points - self.origin, shades)
                    actor = point_actor(data, self.colours[line], shaded=shaded)
                    self._coarse.append((k, actor))
        actors = [actor for _, actor in self._coarse]
        clip_actors(actors, self.half)
        for actor in actors:
            self._renderer.AddActor(actor)

    def refinement_steps(self, camera: Camera, size: ViewportSize, budget: int) -> Iterator[None]:
        """Draw the points in view with rims, at most ``budget`` in total, step by step.

        The first steps find the points in view, line by line; the next steps prepare them for
        drawing, line by line. The drawn points are replaced at the end of the iteration. There are
        no steps if camera and budget are those of the points drawn already.
        """
        drawn = self._fine_key
        if drawn is not None and drawn[0] is camera and drawn[1] == budget:
            return
        found = {}
        for line, points in self.visible.items():
            found[line] = points_in_view(points, camera, size)
            yield
        share = line_budgets({line: len(indices) for line, indices in found.items()}, budget)
        shaded = self.shading is not None
        detail: dict[str, Array] = {}
        fine: list[Any] = []
        rims: list[Any] = []
        for line, indices in found.items():
            if share[line] < len(indices):
                indices = indices[lowest_ranked(self._point_ranks(line)[indices], share[line])]
            chosen = indices
            detail[line] = self.visible[line].take(chosen, axis=0)
            data = point_polydata(detail[line] - self.origin, self._point_colours(line, chosen))
            fine.append(point_actor(data, self.colours[line], shaded=shaded))
            # Rims are the same points, larger, darker and slightly deeper. They are visible as an
            # edge where a near object is in front of a far one, and hidden within a surface.
            rims.append(
                point_actor(
                    data, SHADED_EDGE_COLOUR if shaded else darker_colour(self.colours[line])
                )
            )
            yield
        self._remove_detail()
        self._fine_key = camera, budget
        self.detail, self._fine, self._rims = detail, fine, rims
        clip_actors([*fine, *rims], self.half)
        for actor in (*fine, *rims):
            self._renderer.AddActor(actor)

    def show_detail(self, *, fine: bool, coarse: int | None) -> None:
        """Show the detailed points, slices of the coarse points, or both.

        Parameters
        ----------
        coarse : index of the last shown slice in `SLICE_FRACTIONS`; None for no slice
        """
        for k, actor in self._coarse:
            actor.SetVisibility(coarse is not None and k <= coarse)
        for actor in (*self._fine, *self._rims):
            actor.SetVisibility(fine)

    def style(self, pixels: int, scale: float) -> None:
        """Set the size of the points; the coarse points are fewer and therefore larger."""
        set_point_pixels(self._fine, pixels * scale)
        set_point_pixels((actor for _, actor in self._coarse), (pixels + 1) * scale)
        set_point_pixels(self._rims, (pixels + 2) * scale)

    def update_depth(self, camera: Camera) -> None:
        """Keep the rims behind their points."""
        for rim in self._rims:
            shift_depth(rim, camera, self.origin, RIM_DEPTH_SHIFT)

    def remove(self) -> None:
        """Remove the drawn points."""
        self._remove([actor for _, actor in self._coarse])
        self._remove_detail()
        self._coarse = []

    def clear_references(self) -> None:
        """Clear all references, after the renderer was cleared."""
        self._coarse, self._fine, self._rims = [], [], []
        self._clouds, self.visible, self.sparse, self.detail = {}, {}, {}, {}
        self._ranks, self._orders, self._indices_in_box = {}, {}, {}

    def _remove_detail(self) -> None:
        self._remove(self._fine)
        self._remove(self._rims)
        self._fine, self._rims, self._fine_key, self.detail = [], [], None, {}

    def _remove(self, actors: list[Any]) -> None:
        for actor in actors:
            self._renderer.RemoveActor(actor)

    def _ordered_points(self, line: str, count: int) -> NDArray[np.int64]:
        """Indices, among the points in the box, of ``count`` points to draw, ordered by rank."""
        order = self._orders.get(line)
        if order is None or order[0] != count or order[1] is not self._indices_in_box[line]:
            ranks = self._point_ranks(line)
            chosen = lowest_ranked(ranks, count)
            order = count, self._indices_in_box[line], chosen[np.argsort(ranks[chosen])]
            self._orders[line] = order
        return order[2]

    def _point_ranks(self, line: str) -> NDArray[np.float32]:
        """Ranks of the points of a line within the box."""
        inside = self._indices_in_box[line]
        return self._ranks[line] if inside is None else self._ranks[line].take(inside)

    def _points_in_box(self, line: str, points: Array) -> Array:
        inside = self._indices_in_box[line]
        return points if inside is None else points.take(inside, axis=0)

    def _point_colours(self, line: str, chosen: NDArray[np.int64]) -> NDArray[np.uint8] | None:
        if self.shading is None:
            return None
        inside = self._indices_in_box[line]
        return self.shading.colours[line][chosen if inside is None else inside[chosen]]


def common_origin(clouds: Mapping[str, Array]) -> Array:
    """Origin of drawn coordinates: zero, or the rounded middle of lines that are far from zero."""
    if not clouds:
        return np.zeros(3)
    middle = np.median([np.median(points[:: max(1, len(points) // 1000)], axis=0)
                        for points in clouds.values()], axis=0)  # fmt: skip
    return np.round(middle, -2) if np.abs(middle).max() > MAX_COORDINATE_M else np.zeros(3)
