"""Dialogue for the details on page one of the report: surveyor, vessel, instruments, dates."""

from collections.abc import Callable

from PySide6.QtWidgets import QDialog, QFormLayout, QHBoxLayout, QLineEdit, QPlainTextEdit, QWidget

from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.widgets.error_box import exception_text
from lispac.identity import EMPTY_IDENTITY, FIELD_LABELS, FIELD_NAMES, Identity
from lispac.language import N_, gettext

FIELD_TIPS = {
    "surveyor": N_("Surveyor responsible for the calibration"),
    "company": N_("Company of the surveyor"),
    "vessel": N_("Name of the vessel"),
    "site": N_("Place where the lines were surveyed"),
    "scanner": N_("Maker and model of the LiDAR"),
    "scanner_serial": N_("Serial number of the LiDAR"),
    "pos": N_("Maker and model of the INS/GNSS"),
    "pos_serial": N_("Serial number of the INS/GNSS"),
    "dates": N_("Date or dates of the survey, such as 2026-03-04"),
    "lever_arm_origin": N_(
        "How the lever arm was determined, such as “total station in dock, 2026-03-04”"
    ),
    "remarks": N_("Other information to print in the report"),
}
"""Tips of the fields by their names."""


class IdentityDialog(QDialog):
    """Dialogue with a field for each detail; empty ones are printed as lines to be filled in.

    Parameters
    ----------
    dates : function that returns the days of the survey from the times of the lines, or ""
    """

    def __init__(
        self, identity: Identity, dates: Callable[[], str], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("identity_dialog")
        self.setWindowTitle(gettext("Details for the report"))
        self.setMinimumWidth(560)
        self._dates = dates
        self.identity: Identity = identity
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(
            widgets.label(
                gettext("Empty fields are printed blank, to be filled in by hand."), wrap=True
            )
        )
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACING)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self.fields = {name: _field(name, getattr(identity, name)) for name in FIELD_NAMES}
        for name, field in self.fields.items():
            form.addRow(
                gettext(FIELD_LABELS[name]),
                self._row_with_button(field) if name == "dates" else field,
            )
        layout.addLayout(form)
        self.message_label = widgets.label("", "error", wrap=True, name="identity_message")
        layout.addWidget(self.message_label)
        self.keep = widgets.button(gettext("OK"), "identity_keep", primary=True)
        self.keep.setDefault(True)
        self.keep.clicked.connect(self.accept)
        cancel = widgets.button(gettext("Cancel"), "identity_cancel")
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_platform_order(self.keep, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        for field in self.fields.values():
            field.textChanged.connect(self._check_input)
        self.fields[FIELD_NAMES[0]].setFocus()

    def _row_with_button(self, field: QWidget) -> QHBoxLayout:
        take = widgets.button(
            gettext("Use dates of lines"), "identity_dates_of_lines",
            tip=gettext("Fill in the survey dates (UTC) from the times of the lines"),
        )  # fmt: skip
        take.setAutoDefault(False)
        take.clicked.connect(self._fill_in_dates)
        row = QHBoxLayout()
        row.setSpacing(theme.SPACING)
        row.addWidget(field, 1)
        row.addWidget(take)
        return row

    def _fill_in_dates(self) -> None:
        found = self._dates()
        if found:
            self.fields["dates"].setText(found)
        else:
            self.message_label.setText(
                gettext(
                    "The lines do not contain a date: their times are seconds of the day or week. "
                    "Enter the date of the survey."
                )
            )

    def _check_input(self) -> None:
        """Accept the typed texts, or show the error in them."""
        texts = {name: _field_text(field) for name, field in self.fields.items()}
        try:
            self.identity = EMPTY_IDENTITY.changed(**texts)
            problem = ""
        except InputError as error:
            problem = exception_text(error)
        self.message_label.setText(problem)
        self.keep.setEnabled(not problem)


def _field(name: str, text: str) -> QLineEdit | QPlainTextEdit:
    field: QLineEdit | QPlainTextEdit
    if name == "remarks":
        field = QPlainTextEdit(text)
        field.setTabChangesFocus(True)
        field.setFixedHeight(4 * field.fontMetrics().lineSpacing() + 12)
    else:
        field = QLineEdit(text)
    field.setObjectName(f"identity_{name}")
    field.setAccessibleName(gettext(FIELD_LABELS[name]))
    field.setToolTip(gettext(FIELD_TIPS[name]))
    return field


def _field_text(field: QLineEdit | QPlainTextEdit) -> str:
    return field.text() if isinstance(field, QLineEdit) else field.toPlainText()
