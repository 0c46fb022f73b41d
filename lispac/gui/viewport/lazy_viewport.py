"""Viewport that is created when there is first something to show.

Importing the 3D library takes longer than all else at the start of the program, and the start page
needs none of it.
"""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtGui import QShowEvent
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QVBoxLayout, QWidget

from lispac.gui.viewport.base import Array, Colour, PointColouring, Viewport, ViewportSignals

PER_WHAT = {"set_line_visible", "show_sketch"}
"""The first argument names the line or sketch; of the other calls, the last one applies."""
ANSWERED = {"hides", "drawn_near", "to_pixels", "picture"}


class LazyViewport:
    """`Viewport` that stores calls until the real viewport is needed.

    Parameters
    ----------
    make : makes the real one
    """

    def __init__(self, make: Callable[[], Viewport], parent: QWidget | None = None) -> None:
        self._make = make
        self._view: Viewport | None = None
        self._asked: dict[tuple[str, ...], Callable[[Viewport], None]] = {}
        self._place = _Placeholder(parent)
        self._place.seen = self._real_viewport
        self.signals = ViewportSignals(self._place)

    @property
    def widget(self) -> QWidget:
        """The widget to put into the window."""
        return self._place

    def show_clouds(
        self,
        clouds: Mapping[str, Array],
        colours: Mapping[str, Colour],
        shading: PointColouring | None = None,
    ) -> None:
        """Draw the lines; create the real viewport with the first of them."""
        if self._view is None and not clouds:
            return
        self._real_viewport().show_clouds(clouds, colours, shading)

    def create_empty_viewport(self) -> "LazyViewport":
        """New empty viewport, which is also created when it is needed."""
        return LazyViewport(self._make)

    def close(self) -> None:
        """Release the graphics, if there are any."""
        self._place.seen = None
        if self._view is not None:
            self._view.close()

    def __getattr__(self, name: str) -> Callable[..., object]:
        if self._view is not None or name in ANSWERED:
            return getattr(self._real_viewport(), name)
        if name.startswith("_") or not hasattr(Viewport, name):
            raise AttributeError(name)
        return partial(self._store_call, name)

    def _store_call(self, name: str, *arguments: object, **named: object) -> None:
        key = (name, str(arguments[0])) if name in PER_WHAT else (name,)
        self._asked.pop(key, None)  # in the order of the last calls
        self._asked[key] = lambda view: getattr(view, name)(*arguments, **named)

    def _real_viewport(self) -> Viewport:
        if self._view is None:
            view = self._view = self._make()
            for name in ("seed_clicked", "missed", "pointed", "outlined", "hovered",
                         "handle_moved", "handle_let_go"):  # fmt: skip
                getattr(view.signals, name).connect(getattr(self.signals, name))
            self._place.layout().addWidget(view.widget)
            view.widget.show()
            self._place.layout().activate()  # it has its size before it is asked to fit anything
            for ask in self._asked.values():
                ask(view)
            self._asked.clear()
        return self._view


class _Placeholder(QWidget):
    """Placeholder widget for the viewport."""

    seen: Callable[[], object] | None = None

    def __init__(self, parent: QWidget | None) -> None:
        super().__init__(parent)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        # With the first widget that draws by OpenGL, Qt makes the native window anew: it flickers
        # and is no longer the active one. So there is one from the start, never seen.
        QOpenGLWidget(self).hide()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self.seen is not None:
            self.seen()
