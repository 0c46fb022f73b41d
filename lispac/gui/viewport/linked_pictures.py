"""Pictures of the lines in parts of a viewport, with cameras that follow that of the view."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from PySide6.QtCore import QPointF, QRectF

from lispac.gui.viewport.base import Array, Direction
from lispac.gui.viewport.camera import Camera, ViewportSize
from lispac.gui.viewport.clipping import Box

WHOLE = (0.0, 0.0, 1.0, 1.0)
"""Part of the viewport: left, top, width and height, shares of its size."""


@dataclass(eq=False)
class Picture:
    """Picture of the lines in a part of a viewport.

    Attributes
    ----------
    part : left, top, width and height, shares of the size of the viewport
    direction : whether its camera is that of the view, or looks in a fixed direction
    title : text in its corner
    box : box that is drawn and fills the picture; None for all points
    clouds : points (n, 3) of the visible lines, which can be picked
    coarse : thinned points (n, 3) of the visible lines, used for navigation
    centre : point of the surface in the middle, shape (3,), found when the camera rested last; None
        if there is none
    drawn : function that returns the drawn points (n, 3) by line, for the search while hovering
    place_in_view : function that returns the position of a point of a line, shape (3,), in the
        placement of the view
    """

    part: tuple[float, float, float, float] = WHOLE
    direction: Direction = "same"
    title: str = ""
    box: Box | None = None
    clouds: Mapping[str, Array] = field(default_factory=dict)
    coarse: Mapping[str, Array] = field(default_factory=dict)
    centre: Array | None = None
    drawn: Callable[[], Mapping[str, Array]] = dict
    place_in_view: Callable[[str, Array], Array] = lambda _line, place: place
    _derived: tuple[object, Camera] | None = None
    _own: Camera | None = None

    def rect(self, widget: ViewportSize) -> QRectF:
        """Rectangle of the picture in pixels of a viewport."""
        left, top, width, height = self.part
        return QRectF(
            left * widget.width, top * widget.height, width * widget.width, height * widget.height
        )

    def size(self, widget: ViewportSize) -> ViewportSize:
        """Size of the picture in a viewport."""
        rect = self.rect(widget)
        return ViewportSize(max(rect.width(), 1.0), max(rect.height(), 1.0))

    def local(self, x: float, y: float, widget: ViewportSize) -> tuple[float, float]:
        """Pixel of the picture at a pixel of the viewport."""
        corner = self.rect(widget).topLeft()
        return x - corner.x(), y - corner.y()

    def contains(self, x: float, y: float, widget: ViewportSize) -> bool:
        """Whether a pixel of the viewport is in the picture."""
        return self.rect(widget).contains(QPointF(x, y))

    @property
    def turns(self) -> bool:
        """Whether the user can rotate the picture."""
        return self.direction == "same"

    def camera(self, main: Camera, widget: ViewportSize) -> Camera:
        """Camera of the picture; the same object for the same camera of the view."""
        if self.direction == "same":
            return main
        if self.box is not None:
            if self._own is None:
                self._own = _along_thickness(main, self.box, self.size(widget))
            return self._own
        if self._derived is None or self._derived[0] is not main:
            down = self.direction == "top"
            self._derived = (
                main,
                replace(
                    main,
                    azimuth=0.0 if down else main.azimuth,
                    elevation=0.5 * np.pi if down else 0.0,
                    parallel=True,
                ),
            )
        return self._derived[1]

    @property
    def is_separate(self) -> bool:
        """Whether the camera of the picture does not follow that of the view."""
        return self.box is not None

    def show_box(self, box: Box | None) -> None:
        """Set the box; the camera follows a box that was moved without being turned or resized."""
        former, self.box = self.box, box
        if former is None or box is None or self._own is None:
            self._own = None
        elif np.allclose(former.axes, box.axes) and np.allclose(former.half, box.half):
            self._own = replace(self._own, focal=self._own.focal + box.centre - former.centre)
        else:
            self._own = None

    def move_separately(self, camera: Camera) -> None:
        """Set the camera of a separate picture."""
        self._own = camera

    def moved_view(self, main: Camera, moved: Camera) -> Camera:
        """Camera of the view after the camera of the picture was moved."""
        if self.direction == "same":
            return moved
        return replace(main, focal=moved.focal, distance=moved.distance)


def _along_thickness(main: Camera, box: Box, size: ViewportSize) -> Camera:
    """Parallel camera whose right and up axes are the first two axes of a box, which it shows."""
    upward, forward = box.axes[1], -box.axes[2]
    camera = replace(main, parallel=True, azimuth=float(np.arctan2(-upward[1], upward[0])))
    return camera.along(forward).fitted(box.corners, size)
