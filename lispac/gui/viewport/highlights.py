"""Highlighted sightings, drawn over the lines.

This module does not import VTK: the functions of `actors` create its objects.
"""

from collections.abc import Sequence
from typing import Any

from lispac.gui.viewport.actors import (
    SHADED_EDGE_COLOUR,
    clip_actors,
    darker_colour,
    point_actor,
    point_polydata,
    set_actor_colour,
    set_point_pixels,
    shift_depth,
)
from lispac.gui.viewport.base import Array, Highlight, sighting_style
from lispac.gui.viewport.camera import Camera
from lispac.gui.viewport.clipping import Box

DEPTH_SHIFT = 0.004
"""Shift of a sighting towards the eye, as a share of its distance, so that it covers its line."""


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
            outline = point_actor(data, highlight.colour)
            clip_actors([actor, outline], half)
            self._drawn.append((highlight, actor, outline))
            self._renderer.AddActor(outline)
            self._renderer.AddActor(actor)

    def style(self, pixels: int, scale: float, hidden: set[str]) -> None:
        """Set size and colour of the points by selection, and hide sightings of hidden lines."""
        for highlight, actor, outline in self._drawn:
            drawn = sighting_style(highlight, self.selected)
            size = pixels + drawn.extra_pixels
            set_point_pixels([actor], size * scale)
            set_point_pixels([outline], (size + 3) * scale)
            set_actor_colour(actor, drawn.colour)
            set_actor_colour(
                outline,
                darker_colour(drawn.colour) if highlight.shades is None else SHADED_EDGE_COLOUR,
            )
            shown = highlight.key[1] not in hidden
            actor.SetVisibility(shown)
            outline.SetVisibility(shown and drawn.outlined)

    def update_depth(self, camera: Camera, origin: Array) -> None:
        """Keep the sightings in front of their lines."""
        for highlight, actor, outline in self._drawn:
            shift = DEPTH_SHIFT * (2 if sighting_style(highlight, self.selected).above else 1)
            shift_depth(actor, camera, origin, -shift)
            shift_depth(outline, camera, origin, 0.3 * DEPTH_SHIFT - shift)

    def remove(self) -> None:
        """Remove the drawn sightings."""
        for _, *actors in self._drawn:
            for actor in actors:
                self._renderer.RemoveActor(actor)
        self._drawn = []

    def clear_references(self) -> None:
        """Clear all references, after the renderer was cleared."""
        self._drawn, self.highlights = [], ()
