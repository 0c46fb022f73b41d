"""Fields of the acceptance criteria."""

from math import degrees, radians

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QLineEdit, QWidget

from lispac.acceptance import (
    ANGLE_LIMITS_DEG,
    LENGTH_LIMITS_M,
    LIMIT_NAMES,
    NO_CRITERIA,
    AcceptanceCriteria,
)
from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.widgets.elided_label import ElidedLabel
from lispac.gui.widgets.number_input import PanelEntry, PendingInput, handle_shortcut_override
from lispac.gui.widgets.optional_number import OptionalNumber
from lispac.gui.widgets.result_tables import local_number
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.present.checking.acceptance import (
    AcceptanceValues,
    CriterionResult,
    check_format,
    criterion_results,
    verdict_text,
)
from lispac.project import Project

NOT_JUDGED_TEXT = N_("not judged")
STORED_DECIMALS = 12
"""Decimals of a criterion in degrees, so that the conversion from radians adds no digits."""

_LIMITS = (
    ("roll_sigma_deg", N_("σ of roll"), N_("Largest σ of roll"),
     N_("Largest standard deviation of the estimated roll")),
    ("pitch_sigma_deg", N_("σ of pitch"), N_("Largest σ of pitch"),
     N_("Largest standard deviation of the estimated pitch")),
    ("yaw_sigma_deg", N_("σ of yaw"), N_("Largest σ of yaw"),
     N_("Largest standard deviation of the estimated yaw")),
    ("rms", N_("RMS"), N_("Largest RMS on a plane"),
     N_("Largest RMS of the distances between the lines on each validation plane after the "
        "calibration")),
    ("p95", N_("95 %"), N_("Largest 95 % on a plane"),
     N_("95 % of the distances between the lines on each validation plane must be smaller, after "
        "the calibration")),
    ("offset", N_("Offset"), N_("Largest offset of two lines"),
     N_("Largest median distance between any two lines on each validation plane after the "
        "calibration")),
)  # fmt: skip
"""Name of each criterion, label of its field, title in messages, and description."""
LABEL_COLUMN, LIMIT_COLUMN, RESULT_COLUMN = range(3)
VERDICT_STYLES = {"pass": ("good", "success"), "fail": ("poor", "error")}
"""Icon and role of the text of each verdict; one that is not judged has none."""
ICON_SIZE_PX = 16
MAX_NAMED_PLANES = 2
"""Largest number of planes beside a value, for whose names there is space."""


class AcceptanceForm(QWidget):
    """A field for each acceptance criterion, and the largest value of the calibration."""

    edited = Signal(object)
    """Values of the changed criterion, by its name."""

    def __init__(self) -> None:
        super().__init__()
        layout = widgets.vertical_layout(self, 0)
        layout.addWidget(widgets.label(gettext("Acceptance criteria"), "heading"))
        self.fields: dict[str, OptionalNumber] = {}
        self.results: dict[str, CriterionResultLabel] = {}
        grid = QGridLayout()
        grid.setHorizontalSpacing(6)
        grid.setVerticalSpacing(4)
        grid.setColumnStretch(LIMIT_COLUMN, 1)
        grid.setColumnStretch(RESULT_COLUMN, 2)
        for column, text in ((LIMIT_COLUMN, gettext("Limit")), (RESULT_COLUMN, gettext("Result"))):
            grid.addWidget(widgets.label(text, "muted"), 0, column)
        for row, (name, label, title, description) in enumerate(_LIMITS, 1):
            is_angle = name.endswith("_deg")
            unit, scale = ("°", degrees(1.0)) if is_angle else ("mm", 1000.0)
            limits = LENGTH_LIMITS_M
            if is_angle:
                limits = radians(ANGLE_LIMITS_DEG[0]), radians(ANGLE_LIMITS_DEG[1])
            field = OptionalNumber(
                f"acceptance_{name.removesuffix('_deg')}", gettext(title), unit, scale,
                gettext(NOT_JUDGED_TEXT), gettext(description), limits=limits,
            )  # fmt: skip
            field.setPlaceholderText(gettext("none"))  # short; the tip says what it means
            field.committed.connect(lambda name=name: self._emit_edit(name))
            self.fields[name] = field
            text = gettext("{label} ({unit})", label=gettext(label), unit=field.unit)
            head = widgets.label(text)
            head.setBuddy(field)
            result = CriterionResultLabel(f"result_{field.objectName()}", gettext(title))
            self.results[name.removesuffix("_sigma_deg")] = result
            grid.addWidget(head, row, LABEL_COLUMN)
            grid.addWidget(field, row, LIMIT_COLUMN)
            grid.addWidget(result, row, RESULT_COLUMN)
        self.source = SourceField()
        self.source.committed.connect(lambda: self.edited.emit({"source": self.source.text()}))
        source = widgets.label(gettext("Source"))
        source.setBuddy(self.source)
        grid.addWidget(source, len(_LIMITS) + 1, LABEL_COLUMN)
        grid.addWidget(self.source, len(_LIMITS) + 1, LIMIT_COLUMN, 1, 2)
        layout.addLayout(grid)

    def _emit_edit(self, name: str) -> None:
        value = self.fields[name].value()
        if value is not None and name.endswith("_deg"):
            value = round(degrees(value), STORED_DECIMALS)
        self.edited.emit({name: value})

    def show_project(self, project: Project | None) -> None:
        """Show the criteria of the project."""
        self.setEnabled(project is not None)
        self._show_criteria(NO_CRITERIA if project is None else project.acceptance)

    def _show_criteria(self, criteria: AcceptanceCriteria) -> None:
        for name in LIMIT_NAMES:
            value = getattr(criteria, name)
            is_angle = value is not None and name.endswith("_deg")
            self.fields[name].show_value(radians(value) if is_angle else value)
        self.source.show_text(criteria.source)

    def show_results(self, values: AcceptanceValues | None) -> None:
        """Show the largest value judged by each criterion; None if there is no verdict."""
        results = () if values is None else criterion_results(values)
        found: dict[str, CriterionResult] = {each.quantity: each for each in results}
        for quantity, label in self.results.items():
            label.show_result(found.get(quantity))
        # The fields keep their height while the panel has not yet got that of longer texts below
        layout = self.layout()
        assert layout is not None
        self.setMinimumHeight(layout.minimumSize().height())


class CriterionResultLabel(QWidget):
    """Largest value judged by a criterion, with its verdict and the planes that decide it."""

    def __init__(self, name: str, title: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self._title = title
        self._shown: CriterionResult | None = None
        self.icon, self.text = QLabel(), ElidedLabel()
        self.text.setObjectName(f"{name}_text")
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(3)
        row.addWidget(self.icon)
        row.addWidget(self.text, 1)
        self.setMinimumHeight(ICON_SIZE_PX)

    def show_result(self, result: CriterionResult | None) -> None:
        """Show a result; nothing for None."""
        if result == self._shown:
            return
        self._shown = result
        icon, role = "", ""
        if result is not None:
            icon, role = VERDICT_STYLES.get(result.verdict, ("", ""))
        self.icon.setVisible(bool(icon))
        if icon:
            self.icon.setPixmap(theme.quality_icon(icon).pixmap(ICON_SIZE_PX, ICON_SIZE_PX))
        self.text.setText("" if result is None else _short_result_text(result))
        tip = ""
        if result is not None:
            tip = gettext(
                "{criterion}: {verdict}, {value}",
                criterion=self._title, verdict=verdict_text(result.verdict),
                value=_result_text(result),
            )  # fmt: skip
        self.setToolTip(tip)
        self.text.setAccessibleName(tip)
        self.text.setProperty("role", role)
        self.text.style().unpolish(self.text)
        self.text.style().polish(self.text)


def _result_text(result: CriterionResult) -> str:
    """Value in the unit of the field, and the planes."""
    if result.value is None:
        return gettext(NOT_JUDGED_TEXT)
    value = local_number(result.value, check_format(result))
    if not result.planes:
        return value
    return gettext("{value} ({planes})", value=value, planes=", ".join(result.planes))


def _short_result_text(result: CriterionResult) -> str:
    """Text as in `_result_text`, with the number of the planes instead of more than two names."""
    if result.value is None or len(result.planes) <= MAX_NAMED_PLANES:
        return _result_text(result)
    return gettext(
        "{value} ({count:n} planes)",
        value=local_number(result.value, check_format(result)), count=len(result.planes),
    )  # fmt: skip


class SourceField(PanelEntry, QLineEdit):
    """Field for the document that gives the criteria; committed like a number field."""

    committed = Signal()
    """The user changed the text."""

    def __init__(self) -> None:
        super().__init__()
        self._shown = ""
        self._pending = PendingInput(self)
        self.setObjectName("acceptance_source")
        self.setAccessibleName(gettext("Source of the criteria"))
        self.setPlaceholderText(gettext("contract or standard"))
        self.setToolTip(
            gettext(
                "Document that gives the criteria, such as “contract 4.2” or “IHO S-44 Exclusive "
                "Order”; printed in the report"
            )
        )
        self.textEdited.connect(self._pending.begin)
        self.textChanged.connect(self._mark_invalid)
        self.editingFinished.connect(self.commit)

    def show_text(self, text: str) -> None:
        """Show the text of the project; a text being typed for it is kept."""
        if text == self._shown and (self.is_typing or self.input_error is not None):
            return
        self._pending.end()
        self._shown = text
        self.setText(text)
        self.setCursorPosition(0)

    @property
    def input_error(self) -> Message | None:
        """Reason why the text cannot be printed in a report; None if it can."""
        try:
            NO_CRITERIA.changed(source=self.text())
        except InputError as failure:
            return failure.message
        return None

    def commit(self) -> bool:
        """Make the typed text the value; return whether it is accepted."""
        is_typed = self.is_typing
        self._pending.end()
        if self.input_error is not None:
            return False
        if is_typed and self.text().strip() != self._shown:
            self._shown = self.text().strip()
            self.committed.emit()
        return True

    def restore(self) -> None:
        """Discard the typed text."""
        self._pending.end()
        self.setText(self._shown)

    def copy_state_from(self, former: "SourceField") -> None:
        """Copy the text of a field of a former window, and the text that is typed in it."""
        self._pending.end()
        self._shown = former._shown
        if former.is_typing:
            self._pending.begin()
        self.setText(former.text())
        self.setCursorPosition(former.cursorPosition())

    def event(self, event: QEvent) -> bool:
        """Use the keys that concern the typed text; leave Undo to the window if there is none."""
        is_handled = handle_shortcut_override(event, self.is_typing)
        return super().event(event) if is_handled is None else is_handled

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Discard the typed text with Escape."""
        if event.key() == Qt.Key.Key_Escape and self.is_typing:
            self.restore()
            event.accept()
            return
        super().keyPressEvent(event)

    def _mark_invalid(self) -> None:
        problem = self.input_error
        self._mark(problem is not None, "" if problem is None else message_text(problem))
