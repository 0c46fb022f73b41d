"""Viewport that is created when it is first shown or has content.

Importing the 3D library is the slowest part of the start of the program, and the start page does
not need it.
"""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtGui import QShowEvent
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QVBoxLayout, QWidget

from lispac.gui.viewport.base import Array, Colour, PointColouring, Viewport, ViewportSignals

METHODS_BY_OBJECT = {"set_line_visible", "show_sketch"}
"""Methods whose last call is stored for each line or sketch; of others, only one call is stored."""
METHODS_WITH_RESULT = {"is_line_hidden", "drawn_near", "to_pixels", "picture"}
"""Methods that return a value and therefore need the real viewport."""


class LazyViewport:
    """`Viewport` that stores calls until the real viewport is needed.

    Parameters
    ----------
    create_viewport : function that creates the real viewport
    """

    def __init__(
        self, create_viewport: Callable[[], Viewport], parent: QWidget | None = None
    ) -> None:
        self._create_viewport = create_viewport
        self._view: Viewport | None = None
        self._stored_calls: dict[tuple[str, ...], Callable[[Viewport], None]] = {}
        self._placeholder = _Placeholder(parent)
        self._placeholder.on_shown = self._real_viewport
        self.signals = ViewportSignals(self._placeholder)

    @property
    def widget(self) -> QWidget:
        """Widget of the viewport, for the window."""
        return self._placeholder

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

    def copy_view_from(self, former: Viewport) -> None:
        """Take over the camera and the history of views of another lazy viewport."""
        assert isinstance(former, LazyViewport)
        if former._view is not None:
            self._real_viewport().copy_view_from(former._view)

    def create_empty_viewport(self) -> "LazyViewport":
        """New empty lazy viewport."""
        return LazyViewport(self._create_viewport)

    def close(self) -> None:
        """Release the graphics, if there are any."""
        self._placeholder.on_shown = None
        if self._view is not None:
            self._view.close()

    def __getattr__(self, name: str) -> Callable[..., object]:
        if self._view is not None or name in METHODS_WITH_RESULT:
            return getattr(self._real_viewport(), name)
        if name.startswith("_") or not hasattr(Viewport, name):
            raise AttributeError(name)
        return partial(self._call_or_store, name)

    def _call_or_store(self, name: str, *arguments: object, **named: object) -> None:
        """Call a method; store the call while there is no real viewport.

        Actions are connected to methods before the real viewport exists, and use them later.
        """
        if self._view is not None:
            getattr(self._view, name)(*arguments, **named)
            return
        key = (name, str(arguments[0])) if name in METHODS_BY_OBJECT else (name,)
        self._stored_calls.pop(key, None)  # keeps the order of the last calls
        self._stored_calls[key] = lambda view: getattr(view, name)(*arguments, **named)

    def _real_viewport(self) -> Viewport:
        if self._view is None:
            view = self._view = self._create_viewport()
            for name in ("seed_clicked", "missed", "pointed", "outlined", "hovered",
                         "copy_requested", "menu_requested", "help_used", "handle_moved",
                         "handle_released", "history_changed"):  # fmt: skip
                getattr(view.signals, name).connect(getattr(self.signals, name))
            self._placeholder.layout().addWidget(view.widget)
            view.widget.show()
            self._placeholder.layout().activate()  # sizes the view before `fit`
            for call in self._stored_calls.values():
                call(view)
            self._stored_calls.clear()
        return self._view


class _Placeholder(QWidget):
    """Placeholder widget for the viewport."""

    on_shown: Callable[[], object] | None = None

    def __init__(self, parent: QWidget | None) -> None:
        super().__init__(parent)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        # With the first OpenGL widget, Qt recreates the native window, which flickers and becomes
        # inactive. A hidden OpenGL widget from the start avoids this.
        QOpenGLWidget(self).hide()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self.on_shown is not None:
            self.on_shown()
