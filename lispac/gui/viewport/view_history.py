"""Former views of a viewport, to go back and forward like in a browser."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from lispac.gui.viewport.camera import Array, Camera

REST_MS = 600
"""Time without a movement by the user after which the view is stored."""
MAX_VIEWS = 100
"""Largest number of stored views; the oldest are discarded."""


@dataclass(frozen=True, eq=False)
class StoredView:
    """Camera, and the points (n, 3) that it keeps in the picture, metres, local frame."""

    camera: Camera
    fitted: Array | None

    def shows_the_same(self, other: "StoredView") -> bool:
        """Whether both show the same picture, apart from the projection."""
        a, b = self.camera, other.camera
        if not np.allclose([a.azimuth, a.elevation], [b.azimuth, b.elevation], rtol=0, atol=1e-9):
            return False
        if self.fitted is not None and self.fitted is other.fitted:
            return True
        if a.parallel and b.parallel:  # the depth of the focal point has no effect
            places = [np.array([*(c.axes @ c.focal)[:2], c.distance]) for c in (a, b)]
        else:
            places = [c.with_projection(parallel=False).position for c in (a, b)]
        return np.allclose(*places, rtol=1e-9, atol=1e-6)


class ViewHistory(QObject):
    """Stores the present view when it has come to rest.

    Parameters
    ----------
    current : function that returns the present view
    """

    changed = Signal(bool, bool)
    """Whether there is a previous view and a next one."""

    def __init__(self, current: Callable[[], StoredView], parent: QObject) -> None:
        super().__init__(parent)
        self._current = current
        self._views: list[StoredView] = []
        self._place = -1
        self._timer = QTimer(self, singleShot=True, interval=REST_MS)
        self._timer.timeout.connect(self.store)

    def store_later(self) -> None:
        """Store the view when the user has stopped moving it."""
        self._timer.start()

    def store_pending(self) -> None:
        """Store a view that the user has moved, before another one is shown."""
        if self._timer.isActive():
            self.store()

    def store(self) -> None:
        """Store the present view after the one that was shown last; later views are discarded."""
        self._timer.stop()
        view = self._current()
        if self._views and self._views[self._place].shows_the_same(view):
            return
        self._views = [*self._views[: self._place + 1], view][-MAX_VIEWS:]
        self._place = len(self._views) - 1
        self._report()

    def step(self, steps: int) -> StoredView | None:
        """Go ``steps`` views forward, or back if negative; None if there is no such view."""
        self.store_pending()
        place = self._place + steps
        if not 0 <= place < len(self._views):
            return None
        self._place = place
        self._report()
        return self._views[place]

    def clear(self) -> None:
        """Discard all views."""
        self._timer.stop()
        self._views, self._place = [], -1
        self._report()

    def copy_from(self, other: "ViewHistory") -> None:
        """Take over the views of another viewport."""
        other.store_pending()
        self._timer.stop()
        self._views, self._place = list(other._views), other._place
        self._report()

    def _report(self) -> None:
        self.changed.emit(self._place > 0, self._place < len(self._views) - 1)
