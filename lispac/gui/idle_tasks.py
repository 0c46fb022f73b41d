"""Short tasks of the event loop, run one per turn so that the window stays responsive.

Timers that are due together have one turn in Qt, and the window would hear of keys and the mouse
only after the last of them.
"""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer


class IdleTask(QTimer):
    """Timer that runs a function once, at most one such timer per turn of the event loop.

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
        self.timeout.connect(self._act_if_free)

    def _act_if_free(self) -> None:
        if IdleTask.taken:
            self.start(0)
            return
        self.setInterval(self._after)
        IdleTask.taken = True
        QTimer.singleShot(0, _allow_next)
        self._act()


def _allow_next() -> None:
    IdleTask.taken = False
