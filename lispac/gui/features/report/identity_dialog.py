"""Dialogue for the details of the report: client, company, persons, survey and equipment."""

from collections.abc import Callable, Mapping, Sequence

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QCompleter,
    QDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QVBoxLayout,
    QWidget,
)

from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.app.questions import Questions
from lispac.gui.app.unavailable import Unavailable, reason_text
from lispac.gui.appearance import theme
from lispac.gui.widgets.error_box import exception_text
from lispac.gui.widgets.tab_order import set_tab_order
from lispac.identity import (
    COMPANY_FIELDS,
    EMPTY_IDENTITY,
    FIELD_GROUPS,
    FIELD_LABELS,
    FIELD_NAMES,
    REQUIRED_FIELDS,
    Identity,
)
from lispac.language import N_, gettext

FIELD_TIPS = {
    "report_number": N_("Number of the report, printed on every page"),
    "revision": N_("Revision of the report, printed on every page"),
    "client": N_("Client of the calibration"),
    "contract": N_("Number of the contract or order"),
    "company": N_("Company of the surveyor; the details last used with it are proposed"),
    "surveyor": N_("Surveyor responsible for the calibration"),
    "processed_by": N_("Person who processed the data"),
    "checked_by": N_("Person who checked the result"),
    "vessel": N_("Name of the vessel"),
    "site": N_("Place where the lines were surveyed"),
    "dates": N_("Date or dates of the survey, such as 2026-03-04"),
    "datum": N_("Reference frame of the trajectory, such as NAD83(CSRS)v7"),
    "epoch": N_("Epoch of the coordinates, such as 2010.0"),
    "gnss_base": N_("GNSS base station or correction service"),
    "lever_arm_origin": N_(
        "How the lever arm was determined, such as “total station in dock, 2026-03-04”"
    ),
    "scanner": N_("Maker and model of the LiDAR"),
    "scanner_serial": N_("Serial number of the LiDAR"),
    "pos": N_("Maker and model of the INS/GNSS"),
    "pos_serial": N_("Serial number of the INS/GNSS"),
    "processing_software": N_("Program and version that computed the trajectory"),
    "remarks": N_("Other information to print in the report"),
}
"""Tips of the fields by their names."""
SURVEY_FIELDS = ("client", "contract", "vessel", "site")
"""Fields of a survey whose texts in other reports complete what is typed."""
MIN_WIDTH_PX, MARGIN_PX = 920, 16
COLUMNS = ((0, 1, 2, 5), (3, 4))
"""Indices of the groups in the left and in the right column, which are about equally high."""
MAX_NAMED_FIELDS = 6
"""Largest number of missing fields that are named; more would need a high dialogue."""
NO_DATES_TEXT = N_(
    "The lines contain only the time of the day or week, no date. Type the dates in the field "
    "Survey dates, such as 2026-03-04 or 2026-03-04 to 2026-03-06."
)
"""Reason why the dates of the lines cannot be used."""


class IdentityDialog(QDialog):
    """Dialogue with a field for each detail.

    Parameters
    ----------
    dates : function that returns the days of the survey from the times of the lines, or "" if they
        contain no date; None if the lines are not read yet
    companies : details last used with each company, which are proposed when its name is entered
    suggestions : texts shown in empty fields; they are not stored
    missing : names of empty fields that a signed report needs, which are named; the first has the
        focus
    continues : whether an export or a preview follows
    equipment : names of sensors that the fields of the equipment offer
    """

    def __init__(
        self,
        identity: Identity,
        dates: Callable[[], str] | None,
        companies: Mapping[str, Mapping[str, str]],
        suggestions: Mapping[str, str],
        parent: QWidget | None = None,
        *,
        missing: Sequence[str] = (),
        equipment: Mapping[str, Sequence[str]] | None = None,
        continues: bool = False,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("identity_dialog")
        self.setWindowTitle(gettext("Details for the report"))
        self.setMinimumWidth(MIN_WIDTH_PX)
        self._dates, self._companies, self._suggestions = dates, companies, suggestions
        self._proposed: dict[str, str] = {}
        self._labels: list[QWidget] = []
        self.identity: Identity = identity
        layout = widgets.vertical_layout(self, MARGIN_PX)
        inner_width = MIN_WIDTH_PX - 2 * MARGIN_PX
        layout.addWidget(
            widgets.introduction(
                gettext(
                    "Empty fields are omitted in the short report, except for the names beside the "
                    "signatures, and printed blank in the full report, to be filled in by hand."
                ),
                inner_width,
            )
        )
        self._missing_label = _missing_label(missing, inner_width)
        self._missing_label.setVisible(bool(missing))
        layout.addWidget(self._missing_label)
        self.fields = {name: _field(name, getattr(identity, name)) for name in FIELD_NAMES}
        self._initial_texts = self._texts()
        for name, text in suggestions.items():
            field = self.fields[name]
            if isinstance(field, QLineEdit):
                field.setPlaceholderText(text)
        columns = QHBoxLayout()
        columns.setSpacing(24)
        for groups in COLUMNS:
            column = QVBoxLayout()
            column.addLayout(self._form([FIELD_GROUPS[k] for k in groups]))
            column.addStretch(1)
            columns.addLayout(column, 1)
        layout.addLayout(columns)
        first, *others = [
            self.fields[name] for groups in COLUMNS for k in groups for name in FIELD_GROUPS[k][1]
        ]
        set_tab_order(first, others)
        self._align_fields()
        self._complete_texts()
        for name, texts in (equipment or {}).items():
            field = self.fields[name]
            assert isinstance(field, QLineEdit)
            _offer(field, texts)
        self.message_label = widgets.label("", "error", wrap=True, name="identity_message")
        self.message_label.hide()
        self._legend = widgets.label(gettext("* needed for a signed report"), "muted")
        accept = gettext("Continue") if continues else gettext("OK")
        self.keep = widgets.button(accept, "identity_keep", primary=True)
        self.keep.setDefault(True)
        self.keep.clicked.connect(self.accept)
        cancel = widgets.button(gettext("Cancel"), "identity_cancel")
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addWidget(self._legend, 1)
        row.addWidget(self.message_label, 1)  # in place of the legend
        # Space for two lines is reserved, so that the buttons stay under the mouse
        row.addStrut(2 * self.message_label.fontMetrics().lineSpacing())
        for each in widgets.in_platform_order(self.keep, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        for each_field in self.fields.values():
            each_field.textChanged.connect(self._check_input)
        self.fields[missing[0] if missing else FIELD_NAMES[0]].setFocus()

    def reject(self) -> None:
        """Ask before changed fields are discarded, on Escape or when the dialogue is closed."""
        if self._texts() == self._initial_texts or Questions.ask_to_discard_input(self):
            super().reject()

    def _texts(self) -> dict[str, str]:
        return {name: _field_text(field) for name, field in self.fields.items()}

    def _form(self, groups: Sequence[tuple[str, Sequence[str]]]) -> QFormLayout:
        """Fields of some groups below each other; the only field of a group is below its label."""
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACING)
        form.setHorizontalSpacing(2 * theme.SPACING)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        for title, names in groups:
            if len(names) > 1:
                form.addRow(widgets.label(gettext(title), "heading"))
            for name in names:
                label = widgets.label(_label_text(name))
                label.setBuddy(self.fields[name])
                if len(names) == 1:
                    form.addRow(label)
                    form.addRow(self.fields[name])
                    continue
                self._labels.append(label)
                form.addRow(label, self.fields[name])
                if name == "dates":
                    form.addRow(None, self._create_dates_button())
        return form

    def _align_fields(self) -> None:
        """Make all labels equally wide, so that all fields begin at the same place."""
        width = max(label.sizeHint().width() for label in self._labels)
        for label in self._labels:
            label.setMinimumWidth(width)

    def _complete_texts(self) -> None:
        """Complete texts of earlier reports, and propose the details of known companies."""
        known = {
            name: dict.fromkeys(filter(None, (each.get(name) for each in self._companies.values())))
            for name in SURVEY_FIELDS
        }
        for name, texts in {"company": self._companies, **known}.items():
            field = self.fields[name]
            assert isinstance(field, QLineEdit)
            completer = QCompleter(list(texts), self)
            completer.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
            field.setCompleter(completer)
        self.fields["company"].textChanged.connect(self._propose_details)

    def _propose_details(self, company: str) -> None:
        """Fill the details of a known company into empty fields; typed texts are kept.

        A field with a suggestion, such as the datum of the lines, gets no other text.
        """
        known = self._companies.get(company.strip(), {})
        for name in (each for each in COMPANY_FIELDS if each not in self._suggestions):
            field = self.fields[name]
            assert isinstance(field, QLineEdit)
            if field.text() == self._proposed.get(name, ""):
                self._proposed[name] = known.get(name, "")
                field.setText(self._proposed[name])

    def _create_dates_button(self) -> QWidget:
        take = widgets.button(
            gettext("Use dates of lines"), "identity_dates_of_lines",
            tip=gettext("Fill in the survey dates (UTC) from the times of the lines"),
        )  # fmt: skip
        take.setAutoDefault(False)
        if self._dates is None:
            take.set_reason(reason_text(Unavailable.READING))
        elif found := self._dates():
            take.clicked.connect(lambda: self.fields["dates"].setText(found))
        else:
            take.set_reason(gettext(NO_DATES_TEXT))
            dates = self.fields["dates"]
            assert isinstance(dates, QLineEdit)
            dates.setPlaceholderText(gettext("no date in the lines"))
        return take

    def _check_input(self) -> None:
        """Accept the typed texts, or show the error in them."""
        texts = self._texts()
        _show_missing(
            self._missing_label, [name for name in REQUIRED_FIELDS if not texts[name].strip()]
        )
        try:
            self.identity = EMPTY_IDENTITY.changed(**texts)
            problem = ""
        except InputError as error:
            problem = exception_text(error)
        self.message_label.setText(problem)
        self.message_label.setVisible(bool(problem))
        self._legend.setVisible(not problem)
        self.keep.setEnabled(not problem)


def _missing_label(missing: Sequence[str], width: int) -> QLabel:
    """Label of the missing fields, as high as the longest text that it shows while they are filled.

    Parameters
    ----------
    width : width of the texts, pixels
    """
    longest = sorted(REQUIRED_FIELDS, key=lambda name: len(gettext(FIELD_LABELS[name])))
    texts = [
        missing_details_text(missing, in_form=True),
        missing_details_text(longest[-MAX_NAMED_FIELDS:], in_form=True),
    ]
    heights = [widgets.introduction(text, width, "warning").minimumHeight() for text in texts]
    label = widgets.introduction(texts[0], width, "warning", "identity_missing")
    label.setFixedHeight(max(heights) if len(missing) > MAX_NAMED_FIELDS else heights[0])
    return label


def _show_missing(label: QLabel, missing: Sequence[str]) -> None:
    """Name or count the fields that are missing now."""
    label.setText(missing_details_text(missing, in_form=True))
    label.setProperty("role", "warning" if missing else "success")
    label.style().unpolish(label)
    label.style().polish(label)


def missing_details_text(missing: Sequence[str], *, in_form: bool) -> str:
    """Text of the fields that a signed report needs and that are empty.

    Many are not all named; ``in_form``, they are marked.
    """
    if not missing:
        return gettext("No details are missing for a signed report.")
    if len(missing) > MAX_NAMED_FIELDS:
        text = (
            N_("{count:n} details are missing for a signed report; they are marked with *.")
            if in_form
            else N_("{count:n} details are missing for a signed report.")
        )
        return gettext(text, count=len(missing))
    names = tuple(gettext(FIELD_LABELS[name]) for name in missing)
    return gettext("Missing for a signed report: {names:names}.", names=names)


def _label_text(name: str) -> str:
    """Label of a field, with an asterisk if a signed report needs it."""
    label = gettext(FIELD_LABELS[name])
    return f"{label} *" if name in REQUIRED_FIELDS else label


def _offer(field: QLineEdit, texts: Sequence[str]) -> None:
    """Complete a field with any of some texts, and list them all with its arrow or Alt+Down."""
    completer = QCompleter(list(dict.fromkeys(texts)), field)
    completer.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
    completer.setFilterMode(Qt.MatchFlag.MatchContains)
    field.setCompleter(completer)

    def show_all() -> None:
        completer.setCompletionPrefix("")
        completer.complete()

    arrow = field.addAction(theme.icon("chevron-down"), QLineEdit.ActionPosition.TrailingPosition)
    arrow.setText(gettext("Choose from the sensors"))
    arrow.setToolTip(gettext("Choose from the sensors"))
    arrow.setShortcut(QKeySequence("Alt+Down"))
    arrow.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
    arrow.triggered.connect(show_all)


def _field(name: str, text: str) -> QLineEdit | QPlainTextEdit:
    field: QLineEdit | QPlainTextEdit
    if name == "remarks":
        field = QPlainTextEdit(text)
        field.setTabChangesFocus(True)
        field.setFixedHeight(4 * field.fontMetrics().lineSpacing() + 12)
    else:
        field = QLineEdit(text)
    field.setObjectName(f"identity_{name}")
    field.setAccessibleName(_label_text(name))
    field.setToolTip(gettext(FIELD_TIPS[name]))
    return field


def _field_text(field: QLineEdit | QPlainTextEdit) -> str:
    return field.text() if isinstance(field, QLineEdit) else field.toPlainText()
