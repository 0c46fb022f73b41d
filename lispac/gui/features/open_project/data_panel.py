"""Step 1: the files, the lines and the mounting."""

from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFormLayout,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QScrollArea,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.project.status import ProjectState
from lispac.gui.widgets.mounting_sketch import MountingView
from lispac.gui.widgets.number_field import EQUAL_TOLERANCE
from lispac.gui.widgets.pos_sigmas import PosSigmaFields
from lispac.language import N_, Plural, gettext
from lispac.present.survey.survey_data import WINDOW_LINES_TABLE, LineValues
from lispac.present.tables import cell_text, title_text
from lispac.project import Project, Settings, Triple
from lispac.workflow.project.survey import Survey

ASSUMED_TEXT = N_(
    "Values in grey italics are assumed, since no values were given. Enter those of the data sheet "
    "or of the processing report."
)
EMPTY_TEXT = N_(
    "A project contains a trajectory (SBET), its accuracies and one raw scan file for each line."
)
EXCLUDED_TEXT = Plural(
    "{count:n} point of {lines:names} is not used. The reason is in the messages (F12).",
    "{count:n} points of {lines:names} are not used. The reasons are in the messages (F12).",
)


NOISE_FROM_RESIDUALS_TEXT = N_("The LiDAR noise was estimated from the residuals.")
NOISE_PER_AXIS_TEXT = N_("One value for each axis, as chosen in step 3.")


class DataPanel(QWidget):
    """Panel with the files of the project, visibility of the lines, and the mounting."""

    line_shown = Signal(str, bool)
    """Name of a line, and whether it is to be shown."""
    settings_edited = Signal(object)
    """Settings with the value of the edited field."""
    details_requested = Signal()
    noise_model_requested = Signal()
    """The fields of a LiDAR noise with several values are to be shown."""

    def __init__(self) -> None:
        super().__init__()
        self._settings: Settings | None = None
        layout = widgets.vertical_layout(self)
        # The start page, beside it, has the actions
        self._empty = widgets.label(gettext(EMPTY_TEXT), "hint", wrap=True)
        layout.addWidget(self._empty)
        self._filled = QWidget()
        layout.addWidget(self._filled)
        filled = widgets.vertical_layout(self._filled, 0)

        files = QFormLayout()
        files.setLabelAlignment(Qt.AlignmentFlag.AlignLeft)
        files.setHorizontalSpacing(10)
        files.setVerticalSpacing(4)
        self._trajectory = widgets.label(name="trajectory_name")
        self._accuracy = widgets.label(name="accuracy_name")
        files.addRow(widgets.label(gettext("Trajectory"), "muted"), self._trajectory)
        files.addRow(widgets.label(gettext("Accuracy"), "muted"), self._accuracy)
        filled.addLayout(files)

        self.lines = _lines_table()
        self.lines.itemChanged.connect(self._on_line_toggled)
        filled.addWidget(self.lines)
        self.excluded = widgets.label("", "muted", wrap=True, name="excluded_points")
        filled.addWidget(self.excluded)

        self.lever_arm = widgets.lever_arm_fields("lever_arm")
        self.boresight = widgets.boresight_fields("prior")
        self.lidar_sigma = widgets.number(
            "lidar_sigma", suffix=" mm", decimals=1, low=0.1, high=1000, step=0.5,
            tip=gettext("Standard deviation of one LiDAR point on each axis"),
            title=gettext("LiDAR noise (1 σ)"),
        )  # fmt: skip
        filled.addWidget(widgets.label(gettext("Lever arm, POS to LiDAR"), "heading"))
        filled.addWidget(self.lever_arm)
        filled.addWidget(widgets.label(gettext("Prior boresight"), "heading"))
        filled.addWidget(self.boresight)
        self.mounting = MountingView("mounting")
        filled.addWidget(self.mounting)
        filled.addWidget(self._noise_block())
        self.divergence = widgets.divergence_field("divergence")
        beam = QHBoxLayout()
        beam.addWidget(widgets.label(gettext("Beam divergence")))
        beam.addStretch(1)
        beam.addWidget(self.divergence)
        filled.addLayout(beam)
        self.pos_sigmas = PosSigmaFields("sigma")
        filled.addWidget(widgets.label(gettext("Position (1 σ)"), "heading"))
        filled.addWidget(self.pos_sigmas.position)
        filled.addWidget(widgets.label(gettext("Attitude (1 σ)"), "heading"))
        filled.addWidget(self.pos_sigmas.attitude)
        self._sigma_source = widgets.label("", "muted", wrap=True, name="sigma_source")
        self._sigma_source.hide()
        filled.addWidget(self._sigma_source)
        self.lever_arm_sigma = widgets.lever_arm_sigma_fields("lever_arm_sigma")
        filled.addWidget(widgets.label(gettext("Lever arm (1 σ)"), "heading"))
        filled.addWidget(self.lever_arm_sigma)
        filled.addWidget(widgets.label(gettext(widgets.LEVER_ARM_SIGMA_HINT), "muted", wrap=True))

        self.details = widgets.button(
            gettext("Details for the report…"), "data_details",
            icon="card-account-details-outline",
            tip=gettext("Enter client, company, persons, vessel, instruments and dates for the "
                        "report"),
        )  # fmt: skip
        self.details.clicked.connect(self.details_requested)
        filled.addWidget(self.details)
        sigmas = (*self.pos_sigmas.position.fields, *self.pos_sigmas.attitude.fields)
        for field in (*self.lever_arm.fields, *self.boresight.fields, *sigmas):
            field.committed.connect(self._emit_edit)
        single = (self.lidar_sigma, self.angle_sigma, self.divergence)
        for field in single:
            field.setMinimumWidth(max(each.sizeHint().width() for each in single))
        noise = (self.lidar_sigma, *self.lidar_axes.fields, self.angle_sigma)
        for field in (*noise, self.divergence, *self.lever_arm_sigma.fields):
            field.committed.connect(self._emit_edit)
        for field in (*self.lever_arm.fields, *self.boresight.fields):
            field.valueChanged.connect(self._draw_mounting)
            # Once a new warning is laid out
            field.valueChanged.connect(
                lambda _value, field=field: QTimer.singleShot(
                    0, self, partial(self._scroll_to_warning, field)
                )
            )
        self._show_empty()

    def _noise_block(self) -> QWidget:
        """The LiDAR noise: that of the range or of each axis, and that of the beam direction."""
        block = QWidget()
        layout = widgets.vertical_layout(block, 0)
        self._noise_title = widgets.label("", name="lidar_sigma_title")
        noise = QHBoxLayout()
        noise.addWidget(self._noise_title)
        noise.addStretch(1)
        noise.addWidget(self.lidar_sigma)
        layout.addLayout(noise)
        self.lidar_axes = widgets.TripleField(
            ("X", "Y", "Z"),
            [
                widgets.number(
                    f"lidar_sigma_{axis}", suffix=" mm", decimals=1, low=0.1, high=1000, step=0.5,
                    tip=gettext("Standard deviation of one LiDAR point along this axis"),
                    title=gettext("LiDAR noise along {axis}", axis=axis.upper()),
                )
                for axis in "xyz"
            ],
        )  # fmt: skip
        layout.addWidget(self.lidar_axes)
        self.angle_sigma = widgets.angle_noise_field("lidar_angle_sigma")
        self._angle_row = QWidget()
        angle = QHBoxLayout(self._angle_row)
        angle.setContentsMargins(0, 0, 0, 0)
        angle.addWidget(widgets.label(gettext("Beam angular noise (1 σ)")))
        angle.addStretch(1)
        angle.addWidget(self.angle_sigma)
        layout.addWidget(self._angle_row)
        self._noise_model = QWidget()
        row = QHBoxLayout(self._noise_model)
        row.setContentsMargins(0, 0, 0, 0)
        text = gettext(NOISE_PER_AXIS_TEXT)
        row.addWidget(widgets.label(text, "muted", wrap=True, name="lidar_sigma_model"), 1)
        self.show_noise_model = widgets.button(
            gettext("Edit in step 3"), "edit_lidar_noise",
            tip=gettext("Open the fields of the LiDAR noise in step 3"),
        )  # fmt: skip
        self.show_noise_model.clicked.connect(self.noise_model_requested)
        row.addWidget(self.show_noise_model)
        layout.addWidget(self._noise_model)
        return block

    def _show_noise(self, settings: Settings) -> None:
        beam, axes = settings.lidar_beam_sigma, settings.lidar_sigma_xyz
        title = gettext("LiDAR range noise (1 σ)") if beam else gettext("LiDAR noise (1 σ)")
        self._noise_title.setText(title)
        self.lidar_sigma.title = title
        self.lidar_sigma.setVisible(axes is None)
        for each in (self.lidar_axes, self._noise_model):
            each.setVisible(axes is not None)
        self._angle_row.setVisible(axes is None)
        if axes is not None:
            self.lidar_axes.set_value([1000 * value for value in axes])
        self.angle_sigma.blockSignals(True)
        self.angle_sigma.setValue(beam[1] if beam else 0.0)
        self.angle_sigma.blockSignals(False)
        self.lidar_sigma.blockSignals(True)
        if "LiDAR" in settings.assumed_sigmas:
            self.lidar_sigma.show_assumed(settings.used_lidar_sigma * 1000)
        else:
            self.lidar_sigma.setValue(settings.used_lidar_sigma * 1000)
        self.lidar_sigma.blockSignals(False)

    def show_state(self, state: ProjectState) -> None:
        """Show the files, the lines and the settings of the project."""
        project = state.project
        if project is None:
            self._show_empty()
            return
        self._empty.hide()
        self._filled.show()
        _show_file_name(self._trajectory, project.trajectory, "")
        _show_file_name(
            self._accuracy, project.accuracy, gettext("no file: constant standard deviations")
        )
        self._list_lines(project, state.survey)
        if project.settings != self._settings:
            self._fill(project.settings)
        self._show_pos_sigmas(project, state.survey)

    def _show_empty(self) -> None:
        self._empty.show()
        self._filled.hide()
        self._settings = None

    def select_line(self, name: str) -> bool:
        """Select a line in the list; return whether it is in the list."""
        found = self.lines.findItems(name, Qt.MatchFlag.MatchExactly)
        for item in found:
            self.lines.setCurrentItem(item)
        return bool(found)

    def copy_hidden_lines_from(self, former: "DataPanel") -> None:
        """Hide the lines that are hidden in the panel of a former window."""
        for row in range(min(self.lines.rowCount(), former.lines.rowCount())):
            self.lines.item(row, 0).setCheckState(former.lines.item(row, 0).checkState())

    def _list_lines(self, project: Project, survey: Survey | None) -> None:
        names = [line.name for line in project.lines]
        colours = theme.line_colours(names)
        table = self.lines
        shown = {
            table.item(row, 0).text(): table.item(row, 0).checkState()
            for row in range(table.rowCount())
        }
        table.blockSignals(True)
        table.setRowCount(len(names))
        headings = {} if survey is None else survey.headings_deg
        counts = {} if survey is None else {name: len(s) for name, s in survey.scans.items()}
        for row, line in enumerate(project.lines):
            item = QTableWidgetItem(theme.swatch(colours[line.name]), line.name)
            item.setFlags(
                Qt.ItemFlag.ItemIsEnabled
                | Qt.ItemFlag.ItemIsSelectable
                | Qt.ItemFlag.ItemIsUserCheckable
            )
            item.setCheckState(shown.get(line.name, Qt.CheckState.Checked))
            use = gettext("Tick to show the line in the view")
            item.setToolTip(widgets.plain_tip(f"{line.path}\n{use}"))
            table.setItem(row, 0, item)
            values = LineValues(
                line.name, line.path.name, headings.get(line.name), counts.get(line.name), ()
            )
            for column, definition in enumerate(WINDOW_LINES_TABLE.columns[1:], start=1):
                is_angle = definition.unit == "deg" and definition.value_of(values) is not None
                text = cell_text(definition, values)
                cell = QTableWidgetItem(f"{text}°" if is_angle else text)
                if column == 2 and survey is not None and line.name in survey.excluded:
                    unused = survey.excluded[line.name]
                    cell.setToolTip(gettext(EXCLUDED_TEXT, count=unused, lines=(line.name,)))
                cell.setFlags(Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable)
                cell.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                cell.setFont(theme.tabular_font(table.font()))
                table.setItem(row, column, cell)
        table.blockSignals(False)
        height = table.horizontalHeader().sizeHint().height() + 26 * len(names) + 4
        table.setFixedHeight(height)
        excluded = {} if survey is None else survey.excluded
        self.excluded.setVisible(bool(excluded))
        if excluded:
            text = gettext(EXCLUDED_TEXT, count=sum(excluded.values()), lines=tuple(excluded))
            self.excluded.setText(text)

    def _on_line_toggled(self, item: QTableWidgetItem) -> None:
        if item.column() == 0:
            self.line_shown.emit(item.text(), item.checkState() == Qt.CheckState.Checked)

    def _fill(self, settings: Settings | None) -> None:
        self._settings = settings
        if settings is not None:
            self.lever_arm.set_value(settings.lever_arm)
            self.boresight.set_value(settings.boresight_deg)
            self.lever_arm_sigma.set_value(settings.lever_arm_sigma or (0.0, 0.0, 0.0))
            self.divergence.blockSignals(True)
            self.divergence.setValue(settings.beam_divergence_mrad or 0.0)
            self.divergence.blockSignals(False)
            self._show_noise(settings)
        self._draw_mounting()

    def _show_pos_sigmas(self, project: Project, survey: Survey | None) -> None:
        """Show the standard deviations of the POS that are used, and where they come from."""
        settings, file = project.settings, project.accuracy
        self.pos_sigmas.set_enabled(file is None)
        if file is None:
            self.pos_sigmas.show_values(settings.position_sigma, settings.attitude_sigma_deg)
        elif survey is not None:
            self.pos_sigmas.show_medians(survey.accuracy)
        texts = []
        if file is not None:
            texts.append(
                gettext(
                    "Position and attitude accuracies are taken from {file}; the medians are "
                    "shown.",
                    file=file.name,
                )
            )
        if settings.is_lidar_noise_from_residuals:
            texts.append(gettext(NOISE_FROM_RESIDUALS_TEXT))
        if project.assumed_sigmas:
            texts.append(gettext(ASSUMED_TEXT))
        text = " ".join(texts)
        if text != self._sigma_source.text():  # the same text would be laid out again
            self._sigma_source.setText(text)
            self._sigma_source.setVisible(bool(text))

    def _edited_settings(self) -> Settings | None:
        """Settings with the changed fields; None if no field was changed."""
        if self._settings is None:
            return None
        edited = self._settings
        if _is_changed(self.lever_arm.value(), edited.lever_arm):
            edited = replace(edited, lever_arm=self.lever_arm.value())
        if _is_changed(self.boresight.value(), edited.boresight_deg):
            edited = replace(edited, boresight_deg=self.boresight.value())
        edited = self._with_edited_noise(edited)
        lever_arm_sigma = self.lever_arm_sigma.value()
        edited = replace(
            edited,
            lever_arm_sigma=_unless_same(
                lever_arm_sigma if any(lever_arm_sigma) else None, edited.lever_arm_sigma
            ),
            beam_divergence_mrad=self.divergence.value() or None,
        )
        if self.pos_sigmas.position.isEnabled():
            position, attitude = self.pos_sigmas.values()
            edited = replace(
                edited,
                position_sigma=_unless_same(position, edited.position_sigma),
                attitude_sigma_deg=_unless_same(attitude, edited.attitude_sigma_deg),
            )
        return None if edited == self._settings else edited

    def _with_edited_noise(self, settings: Settings) -> Settings:
        """Settings with the changed fields of the LiDAR noise."""
        if settings.lidar_sigma_xyz is not None:
            x, y, z = (value / 1000 for value in self.lidar_axes.value())
            is_typed = _is_changed((x, y, z), settings.lidar_sigma_xyz)
            return settings.with_values(lidar_sigma_xyz=(x, y, z)) if is_typed else settings
        lidar, angle = self.lidar_sigma.value() / 1000, self.angle_sigma.value()
        is_confirmed = "LiDAR" in settings.assumed_sigmas and not self.lidar_sigma.is_assumed
        if is_confirmed or _is_changed((lidar,), (settings.used_lidar_sigma,)):
            settings = settings.with_lidar_sigma(lidar)
        beam = settings.lidar_beam_sigma
        if _is_changed((angle,), (beam[1] if beam else 0.0,)):
            settings = settings.with_values(
                lidar_sigma=settings.used_lidar_sigma,
                lidar_beam_sigma=(settings.used_lidar_sigma, angle) if angle > 0 else None,
            )
        return settings

    def _emit_edit(self) -> None:
        edited = self._edited_settings()
        if edited is not None:
            self.settings_edited.emit(edited)

    def _draw_mounting(self) -> None:
        self.mounting.show_mounting(self.lever_arm.value(), self.boresight.value())

    def _scroll_to_warning(self, field: QWidget) -> None:
        """Scroll to the focused field and the warning on its value, if there is one."""
        above, warning = self.parentWidget(), self.mounting.warnings_label
        while above is not None and not isinstance(above, QScrollArea):
            above = above.parentWidget()
        if above is not None and field.hasFocus() and not warning.isHidden():
            for each in (warning, field):
                above.ensureWidgetVisible(each, 0, 4)


def _lines_table() -> QTableWidget:
    table = QTableWidget(0, len(WINDOW_LINES_TABLE.columns))
    table.setTabKeyNavigation(False)
    table.setObjectName("lines_table")
    table.setAccessibleName(gettext("Lines of the survey"))
    titles = [title_text(column.title) for column in WINDOW_LINES_TABLE.columns]
    table.setHorizontalHeaderLabels(titles)
    for column in (1, 2):
        table.horizontalHeaderItem(column).setTextAlignment(
            Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        )
    table.horizontalHeaderItem(0).setTextAlignment(
        Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
    )
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(26)
    table.setShowGrid(False)
    table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    header = table.horizontalHeader()
    header.setHighlightSections(False)
    header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
    header.setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
    header.setSectionResizeMode(2, QHeaderView.ResizeMode.ResizeToContents)
    return table


def _show_file_name(label: QLabel, path: Path | None, otherwise: str) -> None:
    label.setText(path.name if path is not None else otherwise)
    label.setToolTip(widgets.plain_tip(str(path) if path is not None else otherwise))


def _is_changed(shown: tuple[float, ...], stored: tuple[float, ...]) -> bool:
    # A field keeps all digits of the value that it shows.
    return any(abs(a - b) > EQUAL_TOLERANCE for a, b in zip(shown, stored, strict=True))


def _unless_same(shown: Triple | None, stored: Triple | None) -> Triple | None:
    """Values shown, or the stored ones with all their digits if they were not changed."""
    is_same = shown is not None and stored is not None and not _is_changed(shown, stored)
    return stored if is_same else shown
