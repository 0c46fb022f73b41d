"""The plan that is being designed: what all views of it show, and change by edits."""

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from lispac.design.plan import Line
from lispac.gui.design import edits
from lispac.gui.design.edits import Hung
from lispac.gui.design.history import History
from lispac.io.plan_file import TitledPlan


class Workspace(QObject):
    """One plan, its history, and what is selected in it.

    Attributes
    ----------
    line, target : int
        Places of the selected ones; -1 where there are none.
    """

    changed = Signal()
    """Another plan, or another step of a drag."""
    selected = Signal()
    refused = Signal(str)
    """Says why something was not done."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.history: History[TitledPlan] = History(edits.usual())
        self._dragged: TitledPlan | None = None
        self.line = self.target = 0

    @property
    def titled(self) -> TitledPlan:
        """The plan as it is shown: in a drag, as it would be."""
        return self._dragged or self.history.now

    @property
    def dragging(self) -> bool:
        """Whether a drag is on its way."""
        return self._dragged is not None

    def start(self, titled: TitledPlan) -> None:
        """Begin anew with a plan."""
        self.history, self._dragged = History(titled), None
        self._tell()

    def take_over(self, former: "Workspace") -> None:
        """Go on with the plan of another one that goes: its way back, and what is selected."""
        former.give_up()
        self.history, self._dragged = former.history, None
        self.line, self.target = former.line, former.target
        self._tell()

    def edit(self, words: str, titled: TitledPlan, key: str = "") -> None:
        """One undo step; edits of the same ``key`` after each other are one."""
        self._dragged = None
        self.history.push(words, titled, key)
        self._tell()

    def drag(self, titled: TitledPlan) -> None:
        """Show what a drag would do."""
        self._dragged = titled
        self.changed.emit()

    def drop(self, words: str) -> None:
        """The drag ends here: one undo step."""
        if self._dragged is not None:
            self.edit(words, self._dragged)

    def give_up(self) -> None:
        """The drag ends where it began."""
        if self._dragged is not None:
            self._dragged = None
            self.changed.emit()

    def undo(self) -> None:
        """One step back."""
        self.give_up()
        self.history.undo()
        self._tell()

    def redo(self) -> None:
        """One step forth."""
        self.give_up()
        self.history.redo()
        self._tell()

    def _tell(self) -> None:
        plan = self.history.now.plan
        self.line = min(max(self.line, 0), len(plan.lines) - 1)
        self.target = min(max(self.target, 0), len(plan.targets) - 1)
        self.changed.emit()
        self.selected.emit()

    # -- what is selected --------------------------------------------------------------------

    def select(self, *, line: int | None = None, target: int | None = None) -> None:
        """Select a line or a target."""
        if line is not None:
            self.line = line
        if target is not None:
            self.target = target
        self.selected.emit()

    def change_line(self, words: str, change: Callable[[Line], Line], key: str = "") -> None:
        """Change the selected line."""
        if self.line >= 0:
            line = change(self.titled.plan.lines[self.line])
            self.edit(words, edits.with_line(self.titled, self.line, line), key)

    def change_target(self, words: str, change: Callable[[Hung], Hung], key: str = "") -> None:
        """Change the selected target."""
        if self.target >= 0:
            target = change(edits.hung(self.titled)[self.target])
            self.edit(words, edits.with_target(self.titled, self.target, target), key)

    # -- more and less -----------------------------------------------------------------------

    def add_line(self, *, again: bool = False) -> None:
        """One more line after the selected one: the same, or the other way round."""
        lines, wall = self.titled.plan.lines, self.titled.wall
        if len(lines) >= edits.MOST_LINES:
            self.refused.emit(f"A plan has at most {edits.MOST_LINES} lines; remove one first.")
            return
        if not lines:
            line = edits.turned(Line(0.0), wall, wall.facing_deg + 90.0)
        else:
            line = lines[self.line]
            if not again:
                line = edits.turned(line, wall, line.heading_deg + 180.0)
        titled = edits.line_put_in(self.titled, self.line + 1, line)
        self.line += 1
        self.edit("duplicate line" if again else "add line", titled)

    def remove_line(self) -> None:
        """Remove the selected line."""
        if self.line >= 0:
            self.edit("remove line", edits.line_removed(self.titled, self.line))

    def sail_line(self, earlier: bool) -> None:
        """The selected line one turn earlier or later."""
        turn = self.line + (-1 if earlier else 1)
        if self.line >= 0 and 0 <= turn < len(self.titled.plan.lines):
            titled = edits.line_sailed(self.titled, self.line, turn)
            self.line = turn
            self.edit("order of lines", titled)

    def add_target(self, *, ball: bool = False, place: tuple[float, float] | None = None) -> None:
        """One more board or ball, to the right of the selected target or at a place.

        Parameters
        ----------
        place : tuple of float, metres
            Along the wall and up.
        """
        there = edits.hung(self.titled)
        if len(there) >= edits.MOST_TARGETS:
            self.refused.emit(f"A plan has at most {edits.MOST_TARGETS} targets; remove one first.")
            return
        last = there[self.target] if there else Hung("", -2.0, 0.0, 5.0)
        along, up = place or (last.along + 2.0, last.up)
        new = Hung(
            edits.free_name(self.titled, "B" if ball else "T"), along, 0.0, up,
            facing=self.titled.wall.facing_deg, ball=ball,
        )  # fmt: skip
        if ball:
            new = replace(new, width=0.2, height=0.2)
        self.target = len(there)
        self.edit("add ball" if ball else "add board", edits.with_target(
            self.titled, len(there), new
        ))  # fmt: skip

    def remove_target(self) -> None:
        """Remove the selected target."""
        if self.target >= 0:
            self.edit("remove target", edits.target_removed(self.titled, self.target))
