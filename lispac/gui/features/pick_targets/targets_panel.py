"""Step 2: options of the next seed, the detected target, and the list of targets."""

from html import escape
from math import radians

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QButtonGroup,
    QComboBox,
    QFormLayout,
    QGridLayout,
    QHBoxLayout,
    QHeaderView,
    QLineEdit,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.app.unavailable import Unavailable, first_reason, reason_text
from lispac.gui.appearance import quantities, theme, units
from lispac.gui.appearance.units import Base
from lispac.gui.features.pick_targets.detected_target_panel import DetectedTargetPanel
from lispac.gui.features.pick_targets.proposed_targets_panel import ProposedTargetsPanel
from lispac.gui.features.pick_targets.search_option_fields import SearchOptionFields
from lispac.gui.project.seed_options import SeedOptions
from lispac.gui.project.status import ProjectState
from lispac.gui.widgets.foldable_group import FoldableGroup
from lispac.language import N_, gettext
from lispac.project import Project, Role, Shape, Target
from lispac.targets.expected_target import ExpectedTarget
from lispac.targets.finder_settings import DEFAULT_CHOICES
from lispac.workflow.calibration.target_search import DEFAULT_RADII, TargetSearch
from lispac.workflow.project.survey import Survey

DEFAULT_BOARD_SIZE_M = (1.23, 1.22)
"""Default width and height of a board, metres."""


class ExpectedFields(widgets.TripleField):
    """Fields for width, height and tilt of the expected plane; unused while a side is 0."""

    def __init__(self) -> None:
        width, height = (units.local_amount(side, "m", ".2f") for side in DEFAULT_BOARD_SIZE_M)
        width_field = widgets.number(
            "expected_width", suffix=" m", decimals=2, low=0, high=100, step=0.1,
            tip=gettext(
                "Expected width of the target, 0 if unknown. Usual board: {width}", width=width
            ),
        )  # fmt: skip
        height_field = widgets.number(
            "expected_height", suffix=" m", decimals=2, low=0, high=100, step=0.1,
            tip=gettext(
                "Expected height of the target along its slope, 0 if unknown. Usual board: "
                "{height}",
                height=height,
            ),
        )  # fmt: skip
        tilt_field = widgets.number(
            "expected_tilt", suffix="°", decimals=0, low=0, high=90, step=5,
            tip=gettext("Expected tilt of the target from horizontal: 0 is horizontal, 90 is "
                        "vertical"),
        )  # fmt: skip
        for field in (width_field, height_field):
            field.setSpecialValueText(gettext("any"))
        titles = (gettext("Width"), gettext("Height"), gettext("Tilt"))
        super().__init__(titles, (width_field, height_field, tilt_field))
        self.reset()

    def reset(self) -> None:
        """Expect nothing."""
        self.set_value((0.0, 0.0, 90.0))

    def target(self) -> ExpectedTarget | None:
        """The expected target; None if a side is not given."""
        width, height, tilt = self.value()
        if not (width and height):
            return None
        return ExpectedTarget(width, height, radians(tilt))


SHAPE_COLUMN = 2
"""Column of the table of targets that is shown only if there is a sphere."""
ALL_LINES_TEXT = N_("All lines")


class TargetsPanel(QWidget):
    """Options of the next seed, the candidate to accept or reject, and the list of targets."""

    role_changed = Signal(str)
    accepted = Signal()
    rejected = Signal()
    renamed = Signal(str, str)
    removed = Signal(str)
    used_changed = Signal(str, bool)
    selected = Signal(str)
    activated = Signal(str)
    """A target was double-clicked beside its name, or Enter was pressed."""
    current_changed = Signal()
    """Another row was selected, by the user or by the program."""
    propose_requested = Signal()

    def __init__(self) -> None:
        super().__init__()
        layout = widgets.vertical_layout(self)
        self._project: Project | None = None
        self._survey: Survey | None = None
        self.hint = widgets.label("", "hint", wrap=True, name="seed_hint", rich=True)
        self.proposal = ProposedTargetsPanel()
        self.proposal.hide()
        layout.addWidget(self.proposal)
        layout.addWidget(self.hint)
        layout.addLayout(self._create_role_buttons())
        layout.addLayout(self._search_buttons())
        self.candidate = DetectedTargetPanel()
        self.candidate.accept.clicked.connect(self.accepted)
        self.candidate.reject.clicked.connect(self.rejected)
        self.candidate.hide()
        layout.addWidget(self.candidate)
        self.search_fields = SearchOptionFields("seed")
        self.settings = FoldableGroup(
            gettext("Search settings"), "fold_search", self._settings_fields()
        )
        layout.addWidget(self.settings)
        self.table = _targets_table()
        self.table.itemChanged.connect(self._on_item_changed)
        self.table.itemSelectionChanged.connect(self._on_selection_changed)
        self.table.activated.connect(lambda index: self.activated.emit(self._names[index.row()]))
        layout.addWidget(self.table)
        layout.addLayout(self._table_buttons())
        for field in (self._radius, self._threshold, *self._expected.fields):
            field.valueChanged.connect(self._summarise_settings)
        self._names: list[str] = []
        self._on_shape_changed()
        self._on_selection_changed()

    @property
    def role(self) -> Role:
        """Role of the next seed: target or validation plane."""
        return "validation" if self._validation.isChecked() else "target"

    @property
    def shape(self) -> Shape:
        """Shape of the next target; always a plane for the role of validation plane."""
        is_sphere = self.shape_choice.currentIndex() == 1 and self.role == "target"
        return "sphere" if is_sphere else "plane"

    @property
    def sphere_radius(self) -> float | None:
        """Radius of the sphere, metres; None if it is unknown, and for planes."""
        return self._sphere_radius.value() or None if self.shape == "sphere" else None

    @property
    def line(self) -> str | None:
        """Name of the line of the next seed; None for all lines."""
        return self.line_choice.currentText() if self.line_choice.currentIndex() > 0 else None

    @property
    def radius(self) -> float | None:
        """Search radius in metres; None for the default."""
        return self._radius.value() or None

    @property
    def threshold(self) -> float | None:
        """RANSAC threshold in metres; None for the default."""
        return self._threshold.value() / 1000 or None

    @property
    def expected(self) -> ExpectedTarget | None:
        """Expected size and tilt of the next plane; None if not given."""
        return self._expected.target() if self.shape == "plane" else None

    @property
    def seed_options(self) -> SeedOptions:
        """All options of the next seed."""
        return SeedOptions(
            self.role, self.line, self.current, self.threshold, self.radius, self.shape,
            self.sphere_radius, self.expected, self.search_fields.value,
        )  # fmt: skip

    @property
    def current(self) -> str | None:
        """Name of the selected target."""
        rows = self.table.selectionModel().selectedRows()
        return self._names[rows[0].row()] if rows else None

    def set_role(self, role: str) -> None:
        """Choose whether the next seed is for a target or a validation plane."""
        (self._validation if role == "validation" else self._target).setChecked(True)

    def reset_seed_options(self) -> None:
        """Choose the default options of the next seed, for another project."""
        self.set_role("target")
        self.shape_choice.setCurrentIndex(0)
        self.line_choice.setCurrentIndex(0)
        for field in (self._radius, self._threshold, self._sphere_radius):
            field.setValue(0.0)
        self._expected.reset()
        self.search_fields.show_value(DEFAULT_CHOICES)

    def show_state(self, state: ProjectState) -> None:
        """Show the targets and the lines of the project."""
        project = state.project
        self._project, self._survey = project, state.survey
        no_project = first_reason((project is None, Unavailable.NO_PROJECT))
        for button in (self._target, self._validation):
            button.set_reason(reason_text(no_project))
        lines = [] if project is None else [line.name for line in project.lines]
        known = [self.line_choice.itemText(k) for k in range(1, self.line_choice.count())]
        if known != lines:
            self.line_choice.clear()
            self.line_choice.addItem(gettext(ALL_LINES_TEXT))
            for line, colour in theme.line_colours(lines).items():
                self.line_choice.addItem(theme.swatch(colour), line)
        self._show_defaults()
        self._fill_table(project)

    def show_proposal(self, shown: bool) -> None:
        """Show or hide the proposed targets, above everything else."""
        self.proposal.setVisible(shown)

    def show_candidate(self, candidate: Target | None, project: Project | None) -> None:
        """Show the candidate to accept or reject; None if there is none."""
        self.candidate.setVisible(candidate is not None)
        if candidate is not None and project is not None:
            self.candidate.fill(candidate, project, self._survey)
            focused = self.window().focusWidget()
            if isinstance(focused, QAbstractButton) and self.isAncestorOf(focused):
                # Enter would press the button that has the focus after a dialogue or a search.
                self.candidate.accept.setFocus()

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the targets in the list, in its order."""
        return tuple(self._names)

    def select(self, name: str) -> None:
        """Select a target in the list without emitting `selected`."""
        if name in self._names and self.current != name:
            self.table.blockSignals(True)
            self.table.selectRow(self._names.index(name))
            self.table.blockSignals(False)
            self._on_selection_changed(emit=False)

    def _fill_table(self, project: Project | None) -> None:
        targets = () if project is None else project.targets
        selected = self.current
        self.table.blockSignals(True)
        self._names = [target.name for target in targets]
        self.table.setRowCount(len(targets))
        for row, target in enumerate(targets):
            for column, item in enumerate(_target_items(target, project)):
                self.table.setItem(row, column, item)
        has_spheres = any(target.shape == "sphere" for target in targets)
        self.table.setColumnHidden(SHAPE_COLUMN, not has_spheres)
        self.table.clearSelection()
        if selected in self._names:
            self.table.selectRow(self._names.index(selected))
        self.table.blockSignals(False)
        rows = 26 * max(len(targets), 2)  # all, as the panel scrolls
        self.table.setFixedHeight(self.table.horizontalHeader().sizeHint().height() + rows + 4)
        self._on_selection_changed(emit=False)

    def _on_item_changed(self, item: QTableWidgetItem) -> None:
        name = self._names[item.row()]
        if item.column() == 0 and item.text() != name:
            self.renamed.emit(name, item.text())
        elif item.column() == 0:
            self.used_changed.emit(name, item.checkState() == Qt.CheckState.Checked)

    def _on_selection_changed(self, emit: bool = True) -> None:
        name = self.current
        no_selection = first_reason(
            (self._project is None, Unavailable.NO_PROJECT),
            (name is None, Unavailable.NO_SELECTION),
        )
        for button in (self.rename, self.remove):
            button.set_reason(reason_text(no_selection))
        self.current_changed.emit()
        if name is not None and emit:
            self.selected.emit(name)
        self._show_click_hint()

    def _show_click_hint(self) -> None:
        """Show what the next click does."""
        line, target = escape(self.line or ""), escape(self.current or "")
        is_sphere = self.shape == "sphere"
        if self.line is None:
            text = N_("Hold <b>Ctrl</b> and click a plane in the view. All lines are searched.")
            if self.role == "validation":
                text = N_(
                    "Hold <b>Ctrl</b> and click a validation plane in the view. All lines are "
                    "searched."
                )
            if is_sphere:
                text = N_(
                    "Hold <b>Ctrl</b> and click a sphere in the view. All lines are searched."
                )
        elif self.current is not None:
            text = N_(
                "<b>Ctrl</b>+click replaces the sighting of {target} in line {line}. Its other "
                "sightings are not changed."
            )
        else:
            text = N_(
                "<b>Ctrl</b>+click picks a new plane in line {line} only. To add the line to an "
                "existing target, select the target in the list first."
            )
            if is_sphere:
                text = N_(
                    "<b>Ctrl</b>+click picks a new sphere in line {line} only. To add the line to "
                    "an existing target, select the target in the list first."
                )
        self.hint.setText(gettext(text, line=line, target=target))
        self._summarise_settings()

    def _on_shape_changed(self) -> None:
        """Enable the fields that apply to the role and the shape."""
        self.shape_choice.setEnabled(self.role == "target")
        self._sphere_radius.setEnabled(self.shape == "sphere")
        self._form.setRowVisible(self._sphere_radius, self.shape == "sphere")
        self._expected.setEnabled(self.shape == "plane")
        self._show_defaults()
        self._show_click_hint()

    def _summarise_settings(self) -> None:
        """Show settings that are not the defaults in the heading of the folded settings."""
        parts = [gettext("sphere")] if self.shape == "sphere" else []
        parts += [self.line] if self.line is not None else []
        fields = (self._radius, self._threshold)
        parts += [field.text() for field in fields if field.value()]
        parts += [gettext("expected plane")] if self.expected is not None else []
        self.settings.set_summary(", ".join(parts))

    def _show_defaults(self) -> None:
        if self._project is None:
            return
        search = TargetSearch(self.shape, self.sphere_radius)
        default = 1000 * search.threshold(self._project.settings.threshold)
        self._threshold.setSpecialValueText(
            gettext("default ({threshold})", threshold=quantities.amount(default, "mm", 0))
        )
        radius = search.search_radii(self.role)[0]
        self._radius.setSpecialValueText(
            gettext("default ({radius})", radius=quantities.amount(radius, "m", 1))
        )

    def _create_role_buttons(self) -> QHBoxLayout:
        # The space separates the text from the icon.
        self._target = widgets.button(
            " " + gettext("Target"), "role_target",
            tip=gettext("Plane or sphere used in the adjustment (F6)"),
        )  # fmt: skip
        self._validation = widgets.button(
            " " + gettext("Validation plane"), "role_validation",
            tip=gettext(
                "Plane used only to compare the lines before and after the adjustment (F7)"
            ),
        )  # fmt: skip
        group = QButtonGroup(self)
        row = QHBoxLayout()
        row.setSpacing(0)
        for each, colour in (
            (self._target, theme.TARGET_COLOUR),
            (self._validation, theme.VALIDATION_COLOUR),
        ):
            each.setCheckable(True)
            each.setProperty("segment", True)
            each.setIcon(theme.swatch(colour))
            group.addButton(each)
            row.addWidget(each)
        self._target.setChecked(True)
        self._validation.toggled.connect(self._on_shape_changed)
        self._validation.toggled.connect(lambda: self.role_changed.emit(self.role))
        return row

    def _shape_fields(self) -> None:
        self.shape_choice = QComboBox()
        self.shape_choice.setObjectName("shape_choice")
        self.shape_choice.addItems([gettext("Plane"), gettext("Sphere")])
        self.shape_choice.setToolTip(
            gettext("Shape of the target. Lines are compared on planes only.")
        )
        self.shape_choice.currentIndexChanged.connect(self._on_shape_changed)
        self._sphere_radius = widgets.number(
            "sphere_radius", suffix=" m", decimals=4, low=0, high=10, step=0.01,
            tip=gettext(
                "Radius of the sphere, not its diameter. 0: unknown; spheres with radii of "
                "{smallest} to {largest} are searched for and the radius is estimated.",
                smallest=_limit_text(0.05, "m"), largest=_limit_text(0.5, "m"),
            ),
        )  # fmt: skip
        self._sphere_radius.setSpecialValueText(gettext("unknown"))
        self._sphere_radius.valueChanged.connect(self._on_shape_changed)

    def _settings_fields(self) -> QWidget:
        body = QWidget()
        layout = QVBoxLayout(body)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(self._seed_form())
        layout.addWidget(self.search_fields)
        return body

    def _seed_form(self) -> QFormLayout:
        self._shape_fields()
        self.line_choice = QComboBox()
        self.line_choice.setObjectName("line_choice")
        self.line_choice.addItem(gettext(ALL_LINES_TEXT))
        self.line_choice.setToolTip(
            gettext("Lines to search. Choose a single line if the search in all lines failed.")
        )
        self.line_choice.currentIndexChanged.connect(self._show_click_hint)
        self._radius = widgets.number(
            "search_radius", suffix=" m", decimals=2, low=0, high=100, step=0.25,
            tip=gettext(
                "Largest distance of a point of the target from the seed. 0: the default; for a "
                "validation plane in fewer than two lines it is increased up to {largest}.",
                largest=_limit_text(DEFAULT_RADII["validation"][-1], "m"),
            ),
        )  # fmt: skip
        self._radius.setSpecialValueText(gettext("default"))
        self._threshold = widgets.number(
            "threshold", suffix=" mm", decimals=0, low=0, high=1000, step=5,
            tip=gettext(
                "Largest distance of a point from its plane or sphere (RANSAC threshold). 0: the "
                "larger of {plane} and 3 × the LiDAR noise; for spheres at least {sphere}, or 0.3 "
                "of the radius of a small sphere.",
                plane=_limit_text(10.0, "mm"), sphere=_limit_text(30.0, "mm"),
            ),
        )  # fmt: skip
        self._threshold.setSpecialValueText(gettext("default"))
        self._expected = ExpectedFields()
        self._form = form = QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)
        form.setHorizontalSpacing(10)
        form.setVerticalSpacing(6)
        form.addRow(gettext("Shape"), self.shape_choice)
        form.addRow(gettext("Sphere radius"), self._sphere_radius)
        form.addRow(gettext("Search in"), self.line_choice)
        form.addRow(gettext("Search radius"), self._radius)
        form.addRow(gettext("Threshold"), self._threshold)
        form.addRow(gettext("Expected plane"), self._expected)
        return form

    def _table_buttons(self) -> QHBoxLayout:
        self.rename = widgets.button(
            gettext("Rename"), "rename_target", icon="pencil-outline", tip=gettext("Rename (F2)")
        )
        self.remove = widgets.button(
            gettext("Remove"), "remove_target", icon="trash-can-outline",
            tip=gettext("Remove (Del)"),
        )  # fmt: skip
        self.rename.clicked.connect(lambda: self.edit_name())
        self.remove.clicked.connect(self._remove)
        delete = QShortcut(QKeySequence.StandardKey.Delete, self.table, self._remove)
        delete.setContext(Qt.ShortcutContext.WidgetShortcut)
        row = QHBoxLayout()
        row.addWidget(self.rename)
        row.addWidget(self.remove)
        return row

    def _search_buttons(self) -> QGridLayout:
        self.propose = widgets.button(
            gettext("Propose targets"), "propose_targets", icon="auto-fix",
            tip=gettext("Find planes in all lines and propose targets and validation planes"),
        )  # fmt: skip
        self.propose.clicked.connect(self.propose_requested)
        self.type_seed = widgets.button(
            gettext("Coordinates…"), "type_seed", icon="crosshairs-gps",
            tip=gettext("Enter local or map coordinates of a seed (F3)"),
        )  # fmt: skip
        self.list_seeds = widgets.button(
            gettext("From a file…"), "list_seeds", icon="format-list-bulleted",
            tip=gettext("Read seed coordinates from a file and detect their targets (Shift+F3)"),
        )  # fmt: skip
        rows = QGridLayout()
        rows.addWidget(self.propose, 0, 0, 1, 2)
        rows.addWidget(self.type_seed, 1, 0)
        rows.addWidget(self.list_seeds, 1, 1)
        return rows

    def edit_name(self, text: str = "") -> None:
        """Open the field for the name of the selected target; ``text`` replaces its name there."""
        if self.current is None:
            return
        self.table.setFocus()
        self.table.editItem(self.table.item(self._names.index(self.current), 0))
        field = self.window().focusWidget()
        if text and isinstance(field, QLineEdit):
            field.setText(text)
            field.selectAll()

    def _remove(self) -> None:
        if self.current is not None:
            self.removed.emit(self.current)


def _limit_text(value: float, base: Base) -> str:
    """Text of a limit of a range, with its unit."""
    return f"{units.localised(units.limit_text(value, base))}{quantities.unit_suffix(base)}"


def _targets_table() -> QTableWidget:
    table = QTableWidget(0, 4)
    table.setTabKeyNavigation(False)
    table.setObjectName("targets_table")
    table.setAccessibleName(gettext("Targets and validation planes"))
    table.setHorizontalHeaderLabels(
        [gettext("Name"), gettext("Role"), gettext("Shape"), gettext("Lines")]
    )
    for column in (0, 1, 2):
        table.horizontalHeaderItem(column).setTextAlignment(
            Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        )
    table.verticalHeader().hide()
    table.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    table.verticalHeader().setDefaultSectionSize(26)
    table.setShowGrid(False)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    table.setEditTriggers(
        QAbstractItemView.EditTrigger.DoubleClicked | QAbstractItemView.EditTrigger.EditKeyPressed
    )
    header = table.horizontalHeader()
    header.setHighlightSections(False)
    header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
    return table


def _target_items(target: Target, project: Project) -> list[QTableWidgetItem]:
    flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
    is_target = target.role == "target"
    colour = theme.TARGET_COLOUR if is_target else theme.VALIDATION_COLOUR
    name = QTableWidgetItem(theme.swatch(colour), target.name)
    name.setFlags(flags | Qt.ItemFlag.ItemIsUserCheckable | Qt.ItemFlag.ItemIsEditable)
    name.setCheckState(Qt.CheckState.Checked if target.used else Qt.CheckState.Unchecked)
    name.setToolTip(gettext("Tick to use the target. Double-click or press F2 to rename it."))
    role = QTableWidgetItem(gettext("target") if is_target else gettext("validation"))
    shape = QTableWidgetItem(_shape_name(target.shape))
    if target.shape == "sphere":
        radius = target.sphere_radius
        shape.setToolTip(
            gettext("Given radius: {radius}", radius=_limit_text(radius, "m"))
            if radius
            else gettext("Radius unknown")
        )
    found = gettext(
        "{used:n} of {total:n}", used=len(target.used_sightings), total=len(project.lines)
    )
    lines = QTableWidgetItem(found if target.used else gettext("excluded"))
    lines.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    for item in (role, shape, lines):
        item.setFlags(flags)
    return [name, role, shape, lines]


def _shape_name(shape: Shape) -> str:
    return gettext("sphere") if shape == "sphere" else gettext("plane")
