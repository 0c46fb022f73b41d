"""The lines and the targets of a plan as tables, with what adds and removes them."""

from dataclasses import replace

from PySide6.QtWidgets import QHBoxLayout, QWidget

from lispac.design.plan import Line
from lispac.gui import units
from lispac.gui.design import edits
from lispac.gui.design.edits import Hung
from lispac.gui.design.number_table import Field, NumberTable
from lispac.gui.design.workspace import Workspace
from lispac.gui.panels import widgets
from lispac.io.plan_file import SIDES

LINE_FIELDS = (
    Field("turn", "Line", "In which turn it is sailed; the order counts", "no.", 1,
          edits.MOST_LINES, 0),
    Field("heading", "Heading", "Clockwise from north", "deg", -360.0, 360.0, 1),
    Field("distance", "Distance", "From the middle of the site, when that is abeam", "m",
          edits.NEAREST, edits.FARTHEST, 1),
    Field("side", "Site on", "On which side the site lies", choices=SIDES),
    Field("speed", "Speed", "Over ground", "m/s", 0.05, 10.0, 2),
)  # fmt: skip
TARGET_FIELDS = (
    Field("name", "Name", "As it is painted on the board", words=True),
    Field("along", "Along", "To the right on the wall, as seen from the water", "m", -500.0, 500.0),
    Field("off", "Off", "From the wall towards the water; negative is behind it", "m", -500.0,
          500.0),
    Field("up", "Up", "Of its middle above the vessel's POS", "m", -50.0, 200.0),
    Field("lean", "From level", "90 is upright, less leans back, more leans forward", "deg", 0.0,
          180.0, 0),
    Field("facing", "Faces", "Azimuth", "deg", -360.0, 360.0, 0),
    Field("width", "Width", "Of a board; diameter of a ball", "m", 0.05, 50.0),
    Field("height", "Height", "Of a board, along it", "m", 0.05, 50.0),
    Field("flatness", "Flatness", "How far one line may see it off its shape", "mm", 0.0, 100.0, 1,
          empty="plan's"),
)  # fmt: skip
BALL_LEAST = 0.04
"""Metres: smallest diameter."""


class LinesList(QWidget):
    """Numbers of every line."""

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self._work = workspace
        self.table = NumberTable("design_lines", "Lines of the plan", LINE_FIELDS)
        self.table.edited.connect(self._edit)
        self.table.chosen.connect(lambda row: workspace.select(line=row))
        buttons = _row(
            ("Add", "add_line", "Add the selected line the other way round (Insert)",
             workspace.add_line),
            ("Duplicate", "duplicate_line", "Sail the selected line again (Ctrl+D)",
             lambda: workspace.add_line(again=True)),
            ("Remove", "remove_line", "Remove the selected line (Delete)", workspace.remove_line),
            ("Earlier", "line_earlier", "Sail it one turn earlier (Alt+Up)",
             lambda: workspace.sail_line(True)),
            ("Later", "line_later", "Sail it one turn later (Alt+Down)",
             lambda: workspace.sail_line(False)),
        )  # fmt: skip
        layout = widgets.column(self, 8)
        layout.addWidget(self.table, 1)
        layout.addLayout(buttons)
        workspace.changed.connect(self._show)
        workspace.selected.connect(self._show)
        self._show()

    def _show(self) -> None:
        self.table.show_rows(
            [
                (k, line.heading_deg, line.distance, SIDES[0 if line.starboard else 1], line.speed)
                for k, line in enumerate(self._work.titled.plan.lines, start=1)
            ],
            self._work.line,
        )

    def _edit(self, row: int, name: str, value) -> None:
        titled = self._work.titled
        if name == "turn":
            turn = min(round(value), len(titled.plan.lines)) - 1
            self._work.line = turn
            self._work.edit("order of lines", edits.line_sailed(titled, row, turn))
            return
        self._work.select(line=row)
        self._work.change_line(
            f"{name} of line {row + 1}", lambda line: self._new(line, name, value)
        )

    def _new(self, line: Line, name: str, value) -> Line:
        if name == "heading":
            return edits.turned(line, self._work.titled.wall, value)
        if name == "side":
            return replace(line, starboard=value == SIDES[0])
        return replace(line, **{name: value})


class TargetsList(QWidget):
    """Numbers of every target."""

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self._work = workspace
        self.table = NumberTable("design_targets", "Targets of the plan", TARGET_FIELDS)
        self.table.edited.connect(self._edit)
        self.table.chosen.connect(lambda row: workspace.select(target=row))
        buttons = _row(
            ("Add board", "add_board",
             f"Hang one more board, {units.limit(2.0, 'm')} m to the right (Insert)",
             workspace.add_target),
            ("Add ball", "add_ball",
             f"Put up a ball of {units.limit(0.2, 'm')} m, {units.limit(2.0, 'm')} m to the right",
             lambda: workspace.add_target(ball=True)),
            ("Remove", "remove_target", "Remove the selected target (Delete)",
             workspace.remove_target),
        )  # fmt: skip
        layout = widgets.column(self, 8)
        layout.addWidget(self.table, 1)
        layout.addLayout(buttons)
        workspace.changed.connect(self._show)
        workspace.selected.connect(self._show)
        self._show()

    def _show(self) -> None:
        self.table.show_rows([_cells(each) for each in edits.hung(self._work.titled)],
                             self._work.target)  # fmt: skip

    def _edit(self, row: int, name: str, value) -> None:
        others = [t.name for k, t in enumerate(self._work.titled.plan.targets) if k != row]
        if name == "name" and value in others:
            self._work.refused.emit(f"{value}: another target has this name; give it another.")
            return
        if name == "flatness" and value is not None:
            value /= 1000.0

        def change(each: Hung) -> Hung:
            if each.ball and name == "width":
                wide = max(value, BALL_LEAST)
                return replace(each, width=wide, height=wide)
            return replace(each, **{name: value})

        self._work.select(target=row)
        self._work.change_target(f"{name} of target {row + 1}", change)


def _cells(each: Hung) -> tuple[float | str | None, ...]:
    flatness = None if each.flatness is None else 1000 * each.flatness
    place = (each.name, each.along, each.off, each.up)
    if each.ball:
        return (*place, "", "", each.width, "", flatness)
    return (*place, each.lean, each.facing, each.width, each.height, flatness)


def _row(*buttons) -> QHBoxLayout:
    row = QHBoxLayout()
    for text, name, tip, slot in buttons:
        button = widgets.button(text, name, tip=tip)
        widgets.convert_tip(button, "m")
        button.clicked.connect(lambda _=False, slot=slot: slot())
        row.addWidget(button)
    row.addStretch(1)
    return row
