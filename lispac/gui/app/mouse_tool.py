"""Assignment of the left mouse button to a tool, which is started by an action and ended by Esc."""

from collections.abc import Callable

from PySide6.QtCore import QObject
from PySide6.QtGui import QKeySequence

from lispac.gui.app.actions import Actions
from lispac.gui.app.unavailable import Unavailable
from lispac.gui.viewport.base import MouseMode, PickedPoint, Viewport
from lispac.language import gettext


class MouseTool(QObject):
    """Assigns the left mouse button to one tool at a time.

    Esc ends the active tool. Without an active tool, it rejects the detected target; without one,
    it ends the mode of the view.
    """

    def __init__(self, viewport: Viewport, actions: Actions) -> None:
        super().__init__(actions)
        self._viewport, self._actions = viewport, actions
        self._tool = ""
        self._pointed: Callable[[PickedPoint], None] = lambda _point: None
        self._outlined: Callable[[object], None] = lambda _corners: None
        self._ended: Callable[[], None] = lambda: None
        viewport.signals.pointed.connect(self._pass_point)
        viewport.signals.outlined.connect(lambda corners: self._outlined(corners))
        self._end_mode: Callable[[], None] | None = None
        actions["end_tool"].triggered.connect(lambda _=False: self._end_tool_or_mode())
        actions["reject"].enabledChanged.connect(lambda _on: self._assign_escape())
        self._assign_escape()

    @property
    def tool(self) -> str:
        """Name of the action of the active tool; empty for none."""
        return self._tool

    @property
    def end_mode(self) -> Callable[[], None] | None:
        """Function that ends the mode of the view, such as linked views; None without a mode."""
        return self._end_mode

    @end_mode.setter
    def end_mode(self, end: Callable[[], None] | None) -> None:
        self._end_mode = end
        self._assign_escape()

    def _end_tool_or_mode(self) -> None:
        if self._tool:
            self.end()
        elif self._end_mode is not None:
            self._end_mode()

    def _assign_escape(self) -> None:
        """Give Esc to the active tool, else to the detected target, else to the mode."""
        rejects = not self._tool and self._actions["reject"].isEnabled()
        ends = bool(self._tool) or (self._end_mode is not None and not rejects)
        self._actions["reject"].setShortcut(QKeySequence("" if self._tool else "Esc"))
        self._actions.set_reason("end_tool", None if ends else Unavailable.NO_TOOL)

    def begin(
        self,
        tool: str,
        hint: str,
        *,
        pointed: Callable[[PickedPoint], None] | None = None,
        outlined: Callable[[object], None] | None = None,
        ended: Callable[[], None],
    ) -> None:
        """Activate the tool of an action and end the former one.

        Parameters
        ----------
        tool : name of the action
        hint : effect of a click, shown above the view
        pointed, outlined : called with each point, or with each outline in pixels, shape (n, 2)
        ended : called once when the tool is ended
        """
        self.end()
        self._tool, self._ended = tool, ended
        mode: MouseMode = "point"
        if pointed is not None:
            self._pointed = pointed
        if outlined is not None:
            mode, self._outlined = "outline", outlined
        self._assign_escape()
        self._actions[tool].setChecked(True)
        # A tool may be started in another window, and is used and ended with Esc in this one
        self._viewport.widget.window().activateWindow()
        self.hint(hint, mode)

    def hint(self, text: str, mode: MouseMode = "point") -> None:
        """Show the hint for the next click."""
        self._viewport.set_mouse(mode, gettext("{hint}   ·   Esc: end", hint=text))

    def end(self) -> None:
        """End the active tool; the mouse then navigates the view."""
        if not self._tool:
            return
        tool, self._tool = self._tool, ""
        self._pointed, self._outlined = lambda _point: None, lambda _corners: None
        self._actions[tool].setChecked(False)
        self._assign_escape()
        self._viewport.set_mouse("navigate")
        self._ended()

    def _pass_point(self, point: PickedPoint | None) -> None:
        if point is not None:
            self._pointed(point)
