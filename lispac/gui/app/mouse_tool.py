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

    Esc ends the active tool; without an active tool, it rejects the detected target.
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
        actions["end_tool"].triggered.connect(lambda _=False: self.end())
        actions.set_reason("end_tool", Unavailable.NO_TOOL)

    @property
    def tool(self) -> str:
        """Name of the action of the active tool; empty for none."""
        return self._tool

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
        self._actions["reject"].setShortcut(QKeySequence())
        self._actions.set_reason("end_tool", None)
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
        self._actions.set_reason("end_tool", Unavailable.NO_TOOL)
        self._actions["reject"].setShortcut(QKeySequence("Esc"))
        self._viewport.set_mouse("navigate")
        self._ended()

    def _pass_point(self, point: PickedPoint | None) -> None:
        if point is not None:
            self._pointed(point)
