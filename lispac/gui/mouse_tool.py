"""The tool that has the left mouse button: started by its action and ended by Esc."""

from collections.abc import Callable

from PySide6.QtCore import QObject
from PySide6.QtGui import QKeySequence

from lispac.gui.actions import Actions
from lispac.gui.viewport.base import MouseMode, PickedPoint, Viewport
from lispac.language import gettext


class MouseTool(QObject):
    """Hands the mouse to tools.

    Esc belongs to the running tool; without one it rejects the plane found, as ever.
    """

    def __init__(self, viewport: Viewport, actions: Actions) -> None:
        super().__init__(actions)
        self._viewport, self._actions = viewport, actions
        self._tool = ""
        self._pointed: Callable[[PickedPoint], None] = lambda _point: None
        self._outlined: Callable[[object], None] = lambda _corners: None
        self._ended: Callable[[], None] = lambda: None
        viewport.signals.pointed.connect(self._take)
        viewport.signals.outlined.connect(lambda corners: self._outlined(corners))
        actions["end_tool"].triggered.connect(lambda _=False: self.end())
        actions["end_tool"].setEnabled(False)

    @property
    def tool(self) -> str:
        """The action of the tool that has the mouse; "" for none."""
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
        """Give the mouse to the tool of an action; the one that had it is ended.

        Parameters
        ----------
        hint : what a click does, to be read above the picture
        pointed, outlined : takes each point, or each outline in pixels (n, 2)
        ended : called once, when the tool loses the mouse
        """
        self.end()
        self._tool, self._ended = tool, ended
        mode: MouseMode = "point"
        if pointed is not None:
            self._pointed = pointed
        if outlined is not None:
            mode, self._outlined = "outline", outlined
        self._actions["reject"].setShortcut(QKeySequence())
        self._actions["end_tool"].setEnabled(True)
        self._actions[tool].setChecked(True)
        self.hint(hint, mode)

    def hint(self, text: str, mode: MouseMode = "point") -> None:
        """Show what the next click does."""
        self._viewport.set_mouse(mode, gettext("{hint}   ·   Esc: end", hint=text))

    def end(self) -> None:
        """Give the mouse back to the view."""
        if not self._tool:
            return
        tool, self._tool = self._tool, ""
        self._pointed, self._outlined = lambda _point: None, lambda _corners: None
        self._actions[tool].setChecked(False)
        self._actions["end_tool"].setEnabled(False)
        self._actions["reject"].setShortcut(QKeySequence("Esc"))
        self._viewport.set_mouse("navigate")
        self._ended()

    def _take(self, point: PickedPoint | None) -> None:
        if point is not None:
            self._pointed(point)
