"""Short tasks of the event loop, run one per turn so that the window stays responsive.

Qt runs all due timers in one turn of the event loop, and events of keyboard and mouse would be
processed only after the last of them.
"""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer


class IdleTask(QTimer):
    """Timer that runs a function once, at most one such timer per turn of the event loop.

    Parameters
    ----------
    function : function that is run
    delay_ms : int
        Smallest delay, milliseconds.
    """

    turn_used = False
    """Whether an `IdleTask` has run in the current turn of the event loop."""

    def __init__(self, function: Callable[[], object], parent: QObject, delay_ms: int = 0) -> None:
        super().__init__(parent, singleShot=True, interval=delay_ms)
        self._function, self._delay_ms = function, delay_ms
        self.timeout.connect(self._run_if_free)

    def _run_if_free(self) -> None:
        if IdleTask.turn_used:
            self.start(0)
            return
        self.setInterval(self._delay_ms)
        IdleTask.turn_used = True
        QTimer.singleShot(0, _allow_next)
        self._function()


def _allow_next() -> None:
    IdleTask.turn_used = False
