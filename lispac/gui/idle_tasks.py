"""Things that each take a tenth of a second, one in each turn of the event loop.

Timers that are due together have one turn in Qt, and the window would hear of keys and the mouse
only after the last of them.
"""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer


class IdleTask(QTimer):
    """Does something once after it is started, as the only one of its kind in its turn.

    Parameters
    ----------
    act : what it does
    after : int, ms
        Until then, at the earliest.
    """

    taken = False
    """Whether one of them has acted since the window could hear of keys and the mouse."""

    def __init__(self, act: Callable[[], object], parent: QObject, after: int = 0) -> None:
        super().__init__(parent, singleShot=True, interval=after)
        self._act, self._after = act, after
        self.timeout.connect(self._take)

    def _take(self) -> None:
        if IdleTask.taken:
            self.start(0)
            return
        self.setInterval(self._after)
        IdleTask.taken = True
        QTimer.singleShot(0, _free)
        self._act()


def _free() -> None:
    IdleTask.taken = False
