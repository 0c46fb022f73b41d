"""Tables of the lines and the targets of a plan, with buttons to add and remove them."""

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtWidgets import QHBoxLayout, QWidget

from lispac.design.plan import Line
from lispac.gui import widgets
from lispac.gui.appearance import units
from lispac.gui.features.design import edits
from lispac.gui.features.design.edits import PlacedTarget
from lispac.gui.features.design.number_table import NumberTable, TableColumn
from lispac.gui.features.design.workspace import Workspace
from lispac.io.config.plan_file import SIDES
from lispac.language import N_, LazyText, gettext, gettext_lazy

LINE_FIELDS = (
    TableColumn(
        "turn",
        N_("Line"),
        N_("Position of the line in the survey order"),
        "",
        1,
        edits.MAX_LINES,
        0,
    ),
    TableColumn(
        "heading",
        N_("Heading"),
        N_("Heading of the line, clockwise from north"),
        "deg",
        -360.0,
        360.0,
        1,
    ),
    TableColumn(
        "distance",
        N_("Distance"),
        N_("Perpendicular distance between the line and the centre of the site"),
        "m",
        edits.MIN_LINE_DISTANCE_M,
        edits.MAX_LINE_DISTANCE_M,
        1,
    ),
    TableColumn(
        "side", N_("Side facing site"), N_("Side of the vessel that faces the site"), choices=SIDES
    ),
    TableColumn("speed", N_("Speed"), N_("Speed of the vessel over ground"), "m/s", 0.05, 10.0, 2),
)
TARGET_FIELDS = (
    TableColumn("name", N_("Name"), N_("Name of the target, as marked on it"), is_text=True),
    TableColumn(
        "along",
        N_("Position"),
        N_("Position along the wall, positive to the right as seen from the water"),
        "m",
        -500.0,
        500.0,
    ),
    TableColumn(
        "off",
        N_("Distance"),
        N_("Distance from the wall, positive towards the water"),
        "m",
        -500.0,
        500.0,
    ),
    TableColumn(
        "up",
        N_("Height"),
        N_("Height of the target centre above the POS of the vessel"),
        "m",
        -50.0,
        200.0,
    ),
    TableColumn(
        "lean",
        N_("Inclination"),
        N_(
            "Inclination from horizontal: 90° is vertical, smaller values lean back, larger "
            "values lean forward"
        ),
        "deg",
        0.0,
        180.0,
        0,
    ),
    TableColumn(
        "facing",
        N_("Azimuth"),
        N_("Azimuth of the direction that the board faces"),
        "deg",
        -360.0,
        360.0,
        0,
    ),
    TableColumn(
        "width", N_("Width"), N_("Width of the board, or diameter of the sphere"), "m", 0.05, 50.0
    ),
    TableColumn("height", N_("Length"), N_("Length of the board along its slope"), "m", 0.05, 50.0),
    TableColumn(
        "flatness",
        N_("Form error"),
        N_("Deviation of the surface from its ideal shape, 1σ"),
        "mm",
        0.0,
        100.0,
        1,
        empty=N_("plan default"),
    ),
    TableColumn(
        "control_sigma",
        N_("Control"),
        N_(
            "Standard deviation (1σ) on each axis of the surveyed corners of the board, or of the "
            "surveyed centre of the sphere; empty without surveyed control"
        ),
        "mm",
        0.1,
        1000.0,
        1,
        empty=N_("none"),
    ),
)
MILLIMETRE_FIELDS = ("flatness", "control_sigma")
"""Fields of a target that are shown in millimetres."""
EDIT_NAMES = N_("Line {line:n}: {field}"), N_("{target}: {field}")
"""Names of the edits of a line and of a target."""
MIN_BALL_DIAMETER_M = 0.04
"""Smallest diameter of a ball, metres."""


class LinesList(QWidget):
    """Table of the lines."""

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self._work = workspace
        self.table = NumberTable("design_lines", gettext("Lines of the survey plan"), LINE_FIELDS)
        self.table.edited.connect(self._edit)
        self.table.row_selected.connect(lambda row: workspace.select(line=row))
        buttons = _button_row(
            (gettext("Add line"), "add_line",
             gettext("Add a line in the direction opposite to the selected line (Insert)"),
             workspace.add_line),
            (gettext("Duplicate"), "duplicate_line",
             gettext("Add a copy of the selected line (Ctrl+D)"),
             lambda: workspace.add_line(duplicate=True)),
            (gettext("Remove"), "remove_line", gettext("Remove the selected line (Delete)"),
             workspace.remove_line),
            (gettext("Move earlier"), "line_earlier",
             gettext("Move the selected line one position earlier in the survey order (Alt+Up)"),
             lambda: workspace.move_line_in_order(True)),
            (gettext("Move later"), "line_later",
             gettext("Move the selected line one position later in the survey order (Alt+Down)"),
             lambda: workspace.move_line_in_order(False)),
        )  # fmt: skip
        layout = widgets.vertical_layout(self, 8)
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
            self._work.edit(
                gettext_lazy("Order of lines"), edits.with_line_moved(titled, row, turn)
            )
            return
        self._work.select(line=row)
        self._work.change_line(
            LazyText(EDIT_NAMES[0], {"field": _field_title(LINE_FIELDS, name), "line": row + 1}),
            lambda line: self._line_with_value(line, name, value),
        )

    def _line_with_value(self, line: Line, name: str, value) -> Line:
        if name == "heading":
            return edits.with_heading(line, self._work.titled.wall, value)
        if name == "side":
            return replace(line, starboard=value == SIDES[0])
        return replace(line, **{name: value})


class TargetsList(QWidget):
    """Table of the targets."""

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self._work = workspace
        self.table = NumberTable(
            "design_targets", gettext("Targets of the survey plan"), TARGET_FIELDS
        )
        self.table.edited.connect(self._edit)
        self.table.row_selected.connect(lambda row: workspace.select(target=row))
        buttons = _button_row(
            (gettext("Add board"), "add_board",
             gettext("Add a board {distance} to the right of the selected target (Insert)",
                     distance=_length_text(2.0)),
             workspace.add_target),
            (gettext("Add sphere"), "add_ball",
             gettext("Add a sphere of diameter {diameter}, {distance} to the right of the "
                     "selected target",
                     diameter=_length_text(0.2), distance=_length_text(2.0)),
             lambda: workspace.add_target(ball=True)),
            (gettext("Remove"), "remove_target", gettext("Remove the selected target (Delete)"),
             workspace.remove_target),
        )  # fmt: skip
        layout = widgets.vertical_layout(self, 8)
        layout.addWidget(self.table, 1)
        layout.addLayout(buttons)
        workspace.changed.connect(self._show)
        workspace.selected.connect(self._show)
        self._show()

    def _show(self) -> None:
        self.table.show_rows(
            [_target_cells(each) for each in edits.placed_targets(self._work.titled)],
            self._work.target,
        )

    def _edit(self, row: int, name: str, value) -> None:
        others = [t.name for k, t in enumerate(self._work.titled.plan.targets) if k != row]
        if name == "name" and value in others:
            self._work.refused.emit(
                gettext("Another target has the name {name}. Choose another name.", name=value)
            )
            return
        if name in MILLIMETRE_FIELDS and value is not None:
            value /= 1000.0

        def change(each: PlacedTarget) -> PlacedTarget:
            if each.ball and name == "width":
                wide = max(value, MIN_BALL_DIAMETER_M)
                return replace(each, width=wide, height=wide)
            return replace(each, **{name: value})

        self._work.select(target=row)
        target = edits.placed_targets(self._work.titled)[row].name
        title = _field_title(TARGET_FIELDS, name)
        self._work.change_target(
            LazyText(EDIT_NAMES[1], {"field": title, "target": target}), change
        )


def _field_title(fields: Sequence[TableColumn], name: str) -> LazyText:
    return LazyText(next(field.title for field in fields if field.name == name), {})


def _length_text(metres: float) -> str:
    """Text of a length in the unit shown."""
    return f"{units.localised(units.limit_text(metres, 'm'))} {units.shown_unit('m').sign}"


def _target_cells(each: PlacedTarget) -> tuple[float | str | None, ...]:
    sigmas = tuple(
        None if value is None else 1000 * value for value in (each.flatness, each.control_sigma)
    )
    place = (each.name, each.along, each.off, each.up)
    if each.ball:
        return (*place, "", "", each.width, "", *sigmas)
    return (*place, each.lean, each.facing, each.width, each.height, *sigmas)


def _button_row(*buttons) -> QHBoxLayout:
    row = QHBoxLayout()
    for text, name, tip, slot in buttons:
        button = widgets.button(text, name, tip=tip)
        button.clicked.connect(lambda _=False, slot=slot: slot())
        row.addWidget(button)
    row.addStretch(1)
    return row
