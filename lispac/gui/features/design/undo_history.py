"""Undo history of a plan."""

from dataclasses import dataclass, field
from typing import Generic, TypeVar

from lispac.language import LazyText

State = TypeVar("State")


@dataclass(eq=False)
class UndoHistory(Generic[State]):
    """Present state, the states before it and those that were undone.

    Attributes
    ----------
    current : the present state
    """

    current: State
    _before: list[tuple[LazyText, State]] = field(default_factory=list)
    _after: list[tuple[LazyText, State]] = field(default_factory=list)
    _key: str = ""
    _saved: State | None = None

    def __post_init__(self) -> None:
        self._saved = self.current

    def push(self, edit: LazyText, state: State, key: str = "") -> None:
        """Make a state the present one; edits of the same ``key`` in a row are one undo step.

        Parameters
        ----------
        edit : LazyText
            Name of the edit that led to it.
        """
        if not (key and key == self._key and self._before):
            self._before.append((edit, self.current))
        self._after, self._key, self.current = [], key, state

    def undo(self) -> None:
        """Go back one step if there is one."""
        if self._before:
            edit, state = self._before.pop()
            self._after.append((edit, self.current))
            self.current, self._key = state, ""

    def redo(self) -> None:
        """Repeat the step that was undone if there is one."""
        if self._after:
            edit, state = self._after.pop()
            self._before.append((edit, self.current))
            self.current, self._key = state, ""

    def mark_saved(self) -> None:
        """Mark the present state as saved; the next edit starts a new undo step."""
        self._saved, self._key = self.current, ""

    @property
    def is_modified(self) -> bool:
        """Whether the present state differs from the saved one."""
        return self.current is not self._saved

    @property
    def undo_name(self) -> LazyText | None:
        """Name of the edit that `undo` would revert; None where there is none."""
        return self._before[-1][0] if self._before else None

    @property
    def redo_name(self) -> LazyText | None:
        """Name of the edit that `redo` would repeat; None where there is none."""
        return self._after[-1][0] if self._after else None
