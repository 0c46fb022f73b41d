"""Who, when and with what: the details that page one of the report states."""

from collections.abc import Callable

from PySide6.QtWidgets import QDialog, QFormLayout, QHBoxLayout, QLineEdit, QPlainTextEdit, QWidget

from lispac.errors import InputError
from lispac.gui import theme
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.identity import BLANK, HINTS, LABELS, NAMES, Identity
from lispac.workflow.survey_dates import NOT_TOLD


class IdentityDialog(QDialog):
    """A field for each; what is left blank is a line on paper to be filled in by hand.

    Parameters
    ----------
    dates : gives the days that the times of the lines tell, empty where they tell none
    """

    def __init__(
        self, identity: Identity, dates: Callable[[], str], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("identity_dialog")
        self.setWindowTitle(say("Details for the report"))
        self.setMinimumWidth(560)
        self._dates = dates
        self.identity: Identity = identity
        layout = widgets.column(self, 16)
        layout.addWidget(
            widgets.label(
                "What is left blank is printed as a line to be filled in by hand.", wrap=True
            )
        )
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACE)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self.fields = {name: _field(name, getattr(identity, name)) for name in NAMES}
        for name, field in self.fields.items():
            form.addRow(say(LABELS[name]), self._with_button(field) if name == "dates" else field)
        layout.addLayout(form)
        self.said = widgets.label("", "error", wrap=True, name="identity_said")
        layout.addWidget(self.said)
        self.keep = widgets.button("OK", "identity_keep", primary=True)
        self.keep.setDefault(True)
        self.keep.clicked.connect(self.accept)
        cancel = widgets.button("Cancel", "identity_cancel")
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_order(self.keep, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        for field in self.fields.values():
            field.textChanged.connect(self._judge)
        self.fields[NAMES[0]].setFocus()

    def _with_button(self, field: QWidget) -> QHBoxLayout:
        take = widgets.button(
            "From the lines", "identity_dates_of_lines",
            tip="The days (UTC) that the times of the lines tell",
        )  # fmt: skip
        take.setAutoDefault(False)
        take.clicked.connect(self._take_dates)
        row = QHBoxLayout()
        row.setSpacing(theme.SPACE)
        row.addWidget(field, 1)
        row.addWidget(take)
        return row

    def _take_dates(self) -> None:
        found = self._dates()
        if found:
            self.fields["dates"].setText(found)
        else:
            self.said.setText(say(f"{NOT_TOLD[:1].upper()}{NOT_TOLD[1:]}"))

    def _judge(self) -> None:
        """Take over what is typed, or say what is wrong with it."""
        texts = {name: _text(field) for name, field in self.fields.items()}
        try:
            self.identity = BLANK.changed(**texts)
            wrong = ""
        except InputError as error:
            wrong = str(error)
        self.said.setText(say(wrong))
        self.keep.setEnabled(not wrong)


def _field(name: str, text: str) -> QLineEdit | QPlainTextEdit:
    field: QLineEdit | QPlainTextEdit
    if name == "remarks":
        field = QPlainTextEdit(text)
        field.setTabChangesFocus(True)
        field.setFixedHeight(4 * field.fontMetrics().lineSpacing() + 12)
    else:
        field = QLineEdit(text)
    field.setObjectName(f"identity_{name}")
    field.setAccessibleName(say(LABELS[name]))
    hint = say(HINTS[name])
    field.setToolTip(f"{hint[:1].upper()}{hint[1:]}")
    return field


def _text(field: QLineEdit | QPlainTextEdit) -> str:
    return field.text() if isinstance(field, QLineEdit) else field.toPlainText()
