"""Highlighted sightings, drawn over the lines in the colours of the lines, with an outline.

The points at the edge of a sighting have a halo. Halos of all points would cover the colours of the
lines in close views, in which the points are apart.

This module does not import VTK: the functions of `actors` create its objects.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.gui.viewport.actors import (
    clip_actors,
    point_actor,
    point_polydata,
    set_actor_colour,
    set_point_pixels,
    shift_depth,
)
from lispac.gui.viewport.base import Array, Highlight, sighting_style
from lispac.gui.viewport.camera import Camera
from lispac.gui.viewport.clipping import Box

POINTS_DEPTH, SELECTED_DEPTH, HALO_DEPTH = 0.006, 0.010, 0.002
"""Shifts towards the eye of the points of a sighting, of those of the selected one and of halos, as
shares of their distance. They cover their line, and a halo is behind the points of all sightings,
so that it hides none of them."""
NEAR_DEPTH_M = 0.04
"""Shift towards the eye, metres, that is added to the shifts of points, and half of it to those of
halos. Otherwise, the noise of the lines would cover the sightings in close views."""
MAX_DEPTH_SHIFT = 0.3
"""Largest shift, as a share of the distance."""
OUTLINE_CELL, CLOSED_CELLS = 2.0, 2
"""Size of the cells in which the edge of a sighting is searched for, in mean distances of points,
and number of cells by which gaps between scan lines are closed from each side."""


def outline_points(points: Array) -> NDArray[np.bool_]:
    """Mask of the points at the edge of a surface, shape (n,).

    The surface is divided into square cells in its mean plane. Holes have no edge, since they are
    mostly gaps between scan lines.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres
    """
    from scipy import ndimage  # only with the first target, since the import takes time

    if len(points) < 3:
        return np.ones(len(points), np.bool_)
    offsets = points - points.mean(axis=0)
    _, axes = np.linalg.eigh(offsets.T @ offsets)
    plane = offsets @ axes[:, 1:]  # along the directions of the two largest extents
    low, extent = plane.min(axis=0), np.ptp(plane, axis=0)
    cell = OUTLINE_CELL * float(np.sqrt(max(extent.prod(), 1e-12) / len(points)))
    # A narrow strip of points has no more cells than points
    cell = max(cell, float(extent.max()) / len(points), 1e-9)
    margin = CLOSED_CELLS + 1
    cells = np.floor((plane - low) / cell).astype(np.int64) + margin
    occupied = np.zeros(cells.max(axis=0) + margin + 1, np.bool_)
    occupied[tuple(cells.T)] = True
    square = np.ones((3, 3), np.bool_)
    surface = ndimage.binary_closing(occupied, square, iterations=CLOSED_CELLS)
    surface = ndimage.binary_fill_holes(surface)
    edge = surface & ~ndimage.binary_erosion(surface, square)
    at_edge: NDArray[np.bool_] = edge[tuple(cells.T)]
    return at_edge


class HighlightLayer:
    """Sightings drawn by a renderer.

    Attributes
    ----------
    highlights : sightings that were set last
    selected : target and line of the emphasised sighting
    """

    def __init__(self, renderer: Any) -> None:
        self._renderer = renderer
        self._drawn: list[tuple[Highlight, Any, Any]] = []
        self.highlights: tuple[Highlight, ...] = ()
        self.selected: tuple[str, str] | None = None

    def set_highlights(
        self, highlights: Sequence[Highlight], origin: Array, box: Box | None, half: Any
    ) -> None:
        """Draw sightings instead of those drawn so far.

        Parameters
        ----------
        origin : ndarray of shape (3,), metres, local frame
            Origin of the drawn coordinates.
        box, half : box and half space to which the drawing is limited; None for no limit
        """
        self.remove()
        self.highlights = tuple(highlights)
        for highlight in self.highlights:
            points, shades = highlight.points, highlight.shades
            if box is not None:
                inside = box.inside(points)
                points, shades = points[inside], None if shades is None else shades[inside]
            data = point_polydata(points - origin, shades)
            actor = point_actor(data, highlight.colour, shaded=shades is not None)
            outline = points[outline_points(points)]
            halo = point_actor(point_polydata(outline - origin, None), highlight.halo)
            clip_actors([actor, halo], half)
            self._drawn.append((highlight, actor, halo))
            self._renderer.AddActor(halo)
            self._renderer.AddActor(actor)

    def selected_points(self) -> Array:
        """Points (n, 3) of the emphasised sighting, or of all sightings of the target."""
        name, line = self.selected or ("", "")
        parts = [
            each.points
            for each in self.highlights
            if each.key[0] == name and line in ("", each.key[1])
        ]
        return np.concatenate(parts) if parts else np.empty((0, 3))

    def style(self, pixels: int, scale: float, hidden: set[str]) -> None:
        """Set size and colour of the points by selection, and hide sightings of hidden lines."""
        for highlight, actor, halo in self._drawn:
            drawn = sighting_style(highlight, self.selected)
            size = pixels + drawn.extra_pixels
            set_point_pixels([actor], size * scale)
            set_point_pixels([halo], (size + 2 * drawn.halo_pixels) * scale)
            set_actor_colour(actor, drawn.colour)
            shown = highlight.key[1] not in hidden
            actor.SetVisibility(shown)
            halo.SetVisibility(shown and drawn.halo_pixels > 0)

    def update_depth(self, camera: Camera, origin: Array) -> None:
        """Keep the sightings in front of their lines."""
        near = NEAR_DEPTH_M / camera.distance
        for highlight, actor, halo in self._drawn:
            above = sighting_style(highlight, self.selected).above
            points = min((SELECTED_DEPTH if above else POINTS_DEPTH) + near, MAX_DEPTH_SHIFT)
            shift_depth(actor, camera, origin, -points)
            shift_depth(halo, camera, origin, -min(HALO_DEPTH + 0.5 * near, 0.5 * points))

    def remove(self) -> None:
        """Remove the drawn sightings."""
        for _, *actors in self._drawn:
            for actor in actors:
                self._renderer.RemoveActor(actor)
        self._drawn = []

    def clear_references(self) -> None:
        """Clear all references, after the renderer was cleared."""
        self._drawn, self.highlights = [], ()
