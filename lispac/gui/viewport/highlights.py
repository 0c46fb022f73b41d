"""The sightings as they are drawn over the lines.

Knows no 3D library but by the functions of `actors`.
"""

from collections.abc import Sequence
from typing import Any

from lispac.gui.viewport.actors import (
    EDGE,
    confine,
    dark,
    paint,
    point_actor,
    point_data,
    shift_depth,
    size_points,
)
from lispac.gui.viewport.base import Array, Highlight, emphasis
from lispac.gui.viewport.camera import Camera
from lispac.gui.viewport.clipping import Box

LIFT = 0.004
"""How far a sighting is moved towards the eye, as part of its distance, to lie over its line."""


class Highlights:
    """Sightings drawn by a renderer.

    Attributes
    ----------
    highlights : those that were put last
    selected : (target, line) of what is emphasised
    """

    def __init__(self, renderer: Any) -> None:
        self._renderer = renderer
        self._drawn: list[tuple[Highlight, Any, Any]] = []
        self.highlights: tuple[Highlight, ...] = ()
        self.selected: tuple[str, str] | None = None

    def put(
        self, highlights: Sequence[Highlight], origin: Array, box: Box | None, half: Any
    ) -> None:
        """Draw sightings, and no longer those drawn so far.

        Parameters
        ----------
        origin : ndarray of shape (3,), metres, local frame
            What the coordinates that are drawn count from.
        box, half : only what lies in both is drawn; None for everything
        """
        self.remove()
        self.highlights = tuple(highlights)
        for highlight in self.highlights:
            points, shades = highlight.points, highlight.shades
            if box is not None:
                inside = box.inside(points)
                points, shades = points[inside], None if shades is None else shades[inside]
            data = point_data(points - origin, shades)
            actor = point_actor(data, highlight.colour, shaded=shades is not None)
            outline = point_actor(data, highlight.colour)
            confine([actor, outline], half)
            self._drawn.append((highlight, actor, outline))
            self._renderer.AddActor(outline)
            self._renderer.AddActor(actor)

    def style(self, pixels: int, scale: float, hidden: set[str]) -> None:
        """Size and colour of the points by what is selected; those on hidden lines vanish."""
        for highlight, actor, outline in self._drawn:
            drawn = emphasis(highlight, self.selected)
            size = pixels + drawn.larger
            size_points([actor], size * scale)
            size_points([outline], (size + 3) * scale)
            paint(actor, drawn.colour)
            paint(outline, dark(drawn.colour) if highlight.shades is None else EDGE)
            shown = highlight.key[1] not in hidden
            actor.SetVisibility(shown)
            outline.SetVisibility(shown and drawn.outlined)

    def move(self, camera: Camera, origin: Array) -> None:
        """Keep the sightings before their lines."""
        for highlight, actor, outline in self._drawn:
            lift = LIFT * (2 if emphasis(highlight, self.selected).above else 1)
            shift_depth(actor, camera, origin, -lift)
            shift_depth(outline, camera, origin, 0.3 * LIFT - lift)

    def remove(self) -> None:
        """Take what is drawn away."""
        for _, *actors in self._drawn:
            for actor in actors:
                self._renderer.RemoveActor(actor)
        self._drawn = []

    def forget(self) -> None:
        """Release everything, after the renderer has."""
        self._drawn, self.highlights = [], ()
