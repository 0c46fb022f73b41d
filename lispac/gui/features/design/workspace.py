"""The plan being designed, its selection, its edits and their undo history."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Generic, TypeVar

from PySide6.QtCore import QObject, Signal

from lispac.design.plan import Line
from lispac.gui.features.design import edits
from lispac.gui.features.design.edits import PlacedTarget
from lispac.io.config.plan_file import TitledPlan
from lispac.language import LazyText, gettext, gettext_lazy

State = TypeVar("State")


@dataclass(eq=False)
class UndoHistory(Generic[State]):
    """Undo history: the present state, earlier states, and undone states.

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
            Name of the edit that led to the state.
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
        """Name of the edit that `undo` would revert; None if there is none."""
        return self._before[-1][0] if self._before else None

    @property
    def redo_name(self) -> LazyText | None:
        """Name of the edit that `redo` would repeat; None if there is none."""
        return self._after[-1][0] if self._after else None


class Workspace(QObject):
    """Plan with its undo history and its selection.

    Attributes
    ----------
    line, target : int
        Indices of the selected line and target; -1 without a selection.
    """

    changed = Signal()
    """The plan was changed, also by a drag that has not ended."""
    selected = Signal()
    refused = Signal(str)
    """The reason why an edit was refused."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.history: UndoHistory[TitledPlan] = UndoHistory(edits.default_plan())
        self._dragged: TitledPlan | None = None
        self.line = self.target = 0

    @property
    def titled(self) -> TitledPlan:
        """Plan as displayed, including a drag that has not ended."""
        return self._dragged or self.history.current

    @property
    def is_dragging(self) -> bool:
        """Whether something is being dragged."""
        return self._dragged is not None

    def start(self, titled: TitledPlan) -> None:
        """Replace the plan and clear the undo history."""
        self.history, self._dragged = UndoHistory(titled), None
        self._emit_changes()

    def copy_state_from(self, former: "Workspace") -> None:
        """Take over plan, undo history and selection of another workspace."""
        former.cancel_drag()
        self.history, self._dragged = former.history, None
        self.line, self.target = former.line, former.target
        self._emit_changes()

    def edit(self, name: LazyText, titled: TitledPlan, key: str = "") -> None:
        """Make one undo step; edits of the same ``key`` in a row are one step."""
        self._dragged = None
        self.history.push(name, titled, key)
        self._emit_changes()

    def drag(self, titled: TitledPlan) -> None:
        """Show the plan as a drag changes it, without an undo step."""
        self._dragged = titled
        self.changed.emit()

    def end_drag(self, name: LazyText) -> None:
        """End the drag as one undo step."""
        if self._dragged is not None:
            self.edit(name, self._dragged)

    def cancel_drag(self) -> None:
        """Cancel the drag."""
        if self._dragged is not None:
            self._dragged = None
            self.changed.emit()

    def undo(self) -> None:
        """Undo one edit."""
        self.cancel_drag()
        self.history.undo()
        self._emit_changes()

    def redo(self) -> None:
        """Redo one edit."""
        self.cancel_drag()
        self.history.redo()
        self._emit_changes()

    def _emit_changes(self) -> None:
        plan = self.history.current.plan
        self.line = min(max(self.line, 0), len(plan.lines) - 1)
        self.target = min(max(self.target, 0), len(plan.targets) - 1)
        self.changed.emit()
        self.selected.emit()

    # -- selection ---------------------------------------------------------------------------

    def select(self, *, line: int | None = None, target: int | None = None) -> None:
        """Select a line or a target."""
        if line is not None:
            self.line = line
        if target is not None:
            self.target = target
        self.selected.emit()

    def change_line(self, name: LazyText, change: Callable[[Line], Line], key: str = "") -> None:
        """Change the selected line."""
        if self.line >= 0:
            line = change(self.titled.plan.lines[self.line])
            self.edit(name, edits.with_line(self.titled, self.line, line), key)

    def change_target(
        self, name: LazyText, change: Callable[[PlacedTarget], PlacedTarget], key: str = ""
    ) -> None:
        """Change the selected target."""
        if self.target >= 0:
            target = change(edits.placed_targets(self.titled)[self.target])
            self.edit(name, edits.with_target(self.titled, self.target, target), key)

    # -- lines and targets -------------------------------------------------------------------

    def add_line(self, *, duplicate: bool = False) -> None:
        """Add a line after the selected one: a copy of it, or in the opposite direction."""
        lines, wall = self.titled.plan.lines, self.titled.wall
        if len(lines) >= edits.MAX_LINES:
            self.refused.emit(
                gettext(
                    "A survey plan can have at most {most:n} lines. Remove a line first.",
                    most=edits.MAX_LINES,
                )
            )
            return
        if not lines:
            line = edits.with_heading(Line(0.0), wall, wall.facing_deg + 90.0)
        else:
            line = lines[self.line]
            if not duplicate:
                line = edits.with_heading(line, wall, line.heading_deg + 180.0)
        titled = edits.with_line_inserted(self.titled, self.line + 1, line)
        self.line += 1
        self.edit(gettext_lazy("Duplicate line") if duplicate else gettext_lazy("Add line"), titled)

    def remove_line(self) -> None:
        """Remove the selected line."""
        if self.line >= 0:
            self.edit(gettext_lazy("Remove line"), edits.without_line(self.titled, self.line))

    def move_line_in_order(self, earlier: bool) -> None:
        """Move the selected line one place in the order."""
        position = self.line + (-1 if earlier else 1)
        if self.line >= 0 and 0 <= position < len(self.titled.plan.lines):
            titled = edits.with_line_moved(self.titled, self.line, position)
            self.line = position
            self.edit(gettext_lazy("Order of lines"), titled)

    def add_target(self, *, ball: bool = False, place: tuple[float, float] | None = None) -> None:
        """Add a board or a sphere to the right of the selected target or at a place.

        Parameters
        ----------
        place : tuple of float, metres
            Along the wall and up.
        """
        present = edits.placed_targets(self.titled)
        if len(present) >= edits.MAX_TARGETS:
            self.refused.emit(
                gettext(
                    "A survey plan can have at most {most:n} targets. Remove a target first.",
                    most=edits.MAX_TARGETS,
                )
            )
            return
        last = present[self.target] if present else PlacedTarget("", -2.0, 0.0, 5.0)
        along, up = place or (last.along + 2.0, last.up)
        new = PlacedTarget(
            edits.free_target_name(self.titled, "B" if ball else "T"), along, 0.0, up,
            facing=self.titled.wall.facing_deg, ball=ball,
        )  # fmt: skip
        if ball:
            new = replace(new, width=0.2, height=0.2)
        self.target = len(present)
        name = gettext_lazy("Add sphere") if ball else gettext_lazy("Add board")
        self.edit(name, edits.with_target(self.titled, len(present), new))

    def remove_target(self) -> None:
        """Remove the selected target."""
        if self.target >= 0:
            self.edit(gettext_lazy("Remove target"), edits.without_target(self.titled, self.target))
