"""The plan being designed, its selection and its edits."""

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from lispac.design.plan import Line
from lispac.gui.design import edits
from lispac.gui.design.edits import PlacedTarget
from lispac.gui.design.history import History
from lispac.io.plan_file import TitledPlan
from lispac.language import LazyText, gettext, gettext_lazy


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
    """The reason why an edit was refused."""

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

    def edit(self, name: LazyText, titled: TitledPlan, key: str = "") -> None:
        """Make one undo step; edits of the same ``key`` in a row are one step."""
        self._dragged = None
        self.history.push(name, titled, key)
        self._tell()

    def drag(self, titled: TitledPlan) -> None:
        """Show what a drag would do."""
        self._dragged = titled
        self.changed.emit()

    def drop(self, name: LazyText) -> None:
        """End the drag as one undo step."""
        if self._dragged is not None:
            self.edit(name, self._dragged)

    def give_up(self) -> None:
        """Cancel the drag."""
        if self._dragged is not None:
            self._dragged = None
            self.changed.emit()

    def undo(self) -> None:
        """Undo one edit."""
        self.give_up()
        self.history.undo()
        self._tell()

    def redo(self) -> None:
        """Redo one edit."""
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
            target = change(edits.hung(self.titled)[self.target])
            self.edit(name, edits.with_target(self.titled, self.target, target), key)

    # -- more and less -----------------------------------------------------------------------

    def add_line(self, *, again: bool = False) -> None:
        """Add a line after the selected one: the same, or in the opposite direction."""
        lines, wall = self.titled.plan.lines, self.titled.wall
        if len(lines) >= edits.MOST_LINES:
            self.refused.emit(
                gettext(
                    "A survey plan can have at most {most:n} lines. Remove a line first.",
                    most=edits.MOST_LINES,
                )
            )
            return
        if not lines:
            line = edits.turned(Line(0.0), wall, wall.facing_deg + 90.0)
        else:
            line = lines[self.line]
            if not again:
                line = edits.turned(line, wall, line.heading_deg + 180.0)
        titled = edits.line_put_in(self.titled, self.line + 1, line)
        self.line += 1
        self.edit(gettext_lazy("Duplicate line") if again else gettext_lazy("Add line"), titled)

    def remove_line(self) -> None:
        """Remove the selected line."""
        if self.line >= 0:
            self.edit(gettext_lazy("Remove line"), edits.line_removed(self.titled, self.line))

    def sail_line(self, earlier: bool) -> None:
        """Move the selected line one place in the order."""
        turn = self.line + (-1 if earlier else 1)
        if self.line >= 0 and 0 <= turn < len(self.titled.plan.lines):
            titled = edits.line_sailed(self.titled, self.line, turn)
            self.line = turn
            self.edit(gettext_lazy("Order of lines"), titled)

    def add_target(self, *, ball: bool = False, place: tuple[float, float] | None = None) -> None:
        """Add a board or a sphere to the right of the selected target or at a place.

        Parameters
        ----------
        place : tuple of float, metres
            Along the wall and up.
        """
        there = edits.hung(self.titled)
        if len(there) >= edits.MOST_TARGETS:
            self.refused.emit(
                gettext(
                    "A survey plan can have at most {most:n} targets. Remove a target first.",
                    most=edits.MOST_TARGETS,
                )
            )
            return
        last = there[self.target] if there else PlacedTarget("", -2.0, 0.0, 5.0)
        along, up = place or (last.along + 2.0, last.up)
        new = PlacedTarget(
            edits.free_name(self.titled, "B" if ball else "T"), along, 0.0, up,
            facing=self.titled.wall.facing_deg, ball=ball,
        )  # fmt: skip
        if ball:
            new = replace(new, width=0.2, height=0.2)
        self.target = len(there)
        name = gettext_lazy("Add sphere") if ball else gettext_lazy("Add board")
        self.edit(name, edits.with_target(self.titled, len(there), new))

    def remove_target(self) -> None:
        """Remove the selected target."""
        if self.target >= 0:
            self.edit(gettext_lazy("Remove target"), edits.target_removed(self.titled, self.target))
