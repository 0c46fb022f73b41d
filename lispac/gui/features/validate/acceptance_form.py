"""Fields of the acceptance criteria."""

from math import degrees, radians

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFormLayout, QGridLayout, QLineEdit, QWidget

from lispac.acceptance import (
    ANGLE_LIMITS_DEG,
    LENGTH_LIMITS_M,
    LIMIT_NAMES,
    NO_CRITERIA,
    AcceptanceCriteria,
)
from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.widgets.number_input import PanelEntry, PendingInput, handle_shortcut_override
from lispac.gui.widgets.optional_number import OptionalNumber
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.project import Project

NOT_JUDGED_TEXT = N_("not judged")
STORED_DECIMALS = 12
"""Decimals of a criterion in degrees, so that the conversion from radians adds no digits."""

_LIMITS = (
    ("roll_sigma_deg", N_("Roll"), N_("Largest σ of roll"),
     N_("Largest standard deviation of the estimated roll")),
    ("pitch_sigma_deg", N_("Pitch"), N_("Largest σ of pitch"),
     N_("Largest standard deviation of the estimated pitch")),
    ("yaw_sigma_deg", N_("Yaw"), N_("Largest σ of yaw"),
     N_("Largest standard deviation of the estimated yaw")),
    ("rms", N_("RMS on a plane"), N_("Largest RMS on a plane"),
     N_("Largest RMS of the distances between the lines on each validation plane after the "
        "calibration")),
    ("p95", N_("95 % on a plane"), N_("Largest 95 % on a plane"),
     N_("95 % of the distances between the lines on each validation plane must be smaller, after "
        "the calibration")),
    ("offset", N_("Offset of two lines"), N_("Largest offset of two lines"),
     N_("Largest median distance between any two lines on each validation plane after the "
        "calibration")),
)  # fmt: skip
"""Name of each criterion, label of its field, title in messages, and description."""


class AcceptanceForm(QWidget):
    """A field for each acceptance criterion."""

    edited = Signal(object)
    """Values of the changed criterion, by its name."""

    def __init__(self) -> None:
        super().__init__()
        layout = widgets.vertical_layout(self, 0)
        layout.addWidget(widgets.label(gettext("Acceptance criteria"), "heading"))
        self.fields: dict[str, OptionalNumber] = {}
        grid, form = QGridLayout(), QFormLayout()
        grid.setHorizontalSpacing(6)
        grid.setVerticalSpacing(2)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.setHorizontalSpacing(10)
        form.setVerticalSpacing(6)
        for column, (name, label, title, description) in enumerate(_LIMITS):
            is_angle = name.endswith("_deg")
            unit, scale = ("°", degrees(1.0)) if is_angle else ("mm", 1000.0)
            limits = LENGTH_LIMITS_M
            if is_angle:
                limits = radians(ANGLE_LIMITS_DEG[0]), radians(ANGLE_LIMITS_DEG[1])
            field = OptionalNumber(
                f"acceptance_{name.removesuffix('_deg')}", gettext(title), unit, scale,
                gettext(NOT_JUDGED_TEXT), gettext(description), limits=limits,
            )  # fmt: skip
            field.committed.connect(lambda name=name: self._emit_edit(name))
            self.fields[name] = field
            text = gettext("{label} ({unit})", label=gettext(label), unit=field.unit)
            if is_angle:
                head = widgets.label(text, "muted")
                head.setBuddy(field)
                grid.addWidget(head, 0, column)
                grid.addWidget(field, 1, column)
            else:
                form.addRow(text, field)
        self.source = SourceField()
        self.source.committed.connect(lambda: self.edited.emit({"source": self.source.text()}))
        layout.addWidget(widgets.label(gettext("Largest standard deviation of the angles")))
        layout.addLayout(grid)
        layout.addLayout(form)
        source = widgets.label(gettext("Source"))
        source.setBuddy(self.source)
        layout.addWidget(source)
        layout.addWidget(self.source)

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
