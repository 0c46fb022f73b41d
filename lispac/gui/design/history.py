"""States one after the other, to go back and forth between; knows no window."""

from dataclasses import dataclass, field
from typing import Generic, TypeVar

State = TypeVar("State")


@dataclass(eq=False)
class History(Generic[State]):
    """What was, what is and what was taken back.

    Attributes
    ----------
    now : the present state
    """

    now: State
    _before: list[tuple[str, State]] = field(default_factory=list)
    _after: list[tuple[str, State]] = field(default_factory=list)
    _key: str = ""
    _saved: State | None = None

    def __post_init__(self) -> None:
        self._saved = self.now

    def push(self, words: str, state: State, key: str = "") -> None:
        """A new state; one of the same ``key`` as the last takes its place."""
        if not (key and key == self._key and self._before):
            self._before.append((words, self.now))
        self._after, self._key, self.now = [], key, state

    def undo(self) -> None:
        """Go one step back, where there is one."""
        if self._before:
            words, state = self._before.pop()
            self._after.append((words, self.now))
            self.now, self._key = state, ""

    def redo(self) -> None:
        """Go one step forth again, where there is one."""
        if self._after:
            words, state = self._after.pop()
            self._before.append((words, self.now))
            self.now, self._key = state, ""

    def keep(self) -> None:
        """The present state is on the disk; what comes is a step of its own."""
        self._saved, self._key = self.now, ""

    @property
    def changed(self) -> bool:
        """Whether the present state is another than the one on the disk."""
        return self.now is not self._saved

    @property
    def to_undo(self) -> str:
        """What would be taken back; empty where nothing is."""
        return self._before[-1][0] if self._before else ""

    @property
    def to_redo(self) -> str:
        """What would be made again; empty where nothing is."""
        return self._after[-1][0] if self._after else ""
