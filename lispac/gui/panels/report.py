"""Step 5: what leaves the program."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QSizePolicy, QWidget

from lispac.errors import InputError
from lispac.gui.language import language, say
from lispac.gui.panels import widgets
from lispac.gui.status import StepStatus
from lispac.language import LANGUAGES
from lispac.report.options import PAGES, USUAL, ReportOptions
from lispac.survey.conventions.systems import LISPAC, STATUS_WORDS, SYSTEMS
from lispac.workflow.report_options import report_options

OTHERS = tuple(each for each in SYSTEMS if each.key != LISPAC.key)
NO_TEMPLATE = "None"
OF_WINDOW = "window"
"""Language of the report that goes with the window's."""
LANGUAGE_KEYS = (OF_WINDOW, *LANGUAGES)


class ReportPanel(QWidget):
    """Says how the report is wanted; exports it and the georeferenced lines."""

    report_asked = Signal()
    lines_asked = Signal()
    details_asked = Signal()
    preview_asked = Signal()
    template_asked = Signal()
    changed = Signal()
    """How the report is wanted is another."""

    def __init__(self) -> None:
        super().__init__()
        self._template: Path | None = None
        layout = widgets.column(self)
        self.advice = widgets.label("", "hint", wrap=True, name="report_advice")
        layout.addWidget(self.advice)
        self.details = widgets.button(
            "Details for the report…", "report_details", icon="card-account-details-outline",
            tip="Surveyor, vessel, instruments, dates: what page one says of who, when and with "
            "what",
        )  # fmt: skip
        layout.addWidget(self.details)
        layout.addLayout(self._choices())
        self.said = widgets.label("", "error", wrap=True, name="report_said")
        layout.addWidget(self.said)
        self.report = widgets.button(
            "Export report…", "export_report", icon="file-document-outline", primary=True,
            tip="PDF, HTML, JSON or tables (CSV in a ZIP); pictures of the view before and after "
            "go into it (Ctrl+E)",
        )  # fmt: skip
        self.preview = widgets.button(
            "Preview", "preview_report", icon="eye-outline",
            tip="Look at the pages as they will be printed, and save them as PDF",
        )  # fmt: skip
        self.lines = widgets.button(
            "Export georeferenced lines…", "export_lines", icon="export-variant",
            tip="Every line as LAZ or LAS in a coordinate system of your choice (Ctrl+Shift+E)",
        )  # fmt: skip
        self.details.clicked.connect(self.details_asked)
        self.preview.clicked.connect(self.preview_asked)
        self.report.clicked.connect(self.report_asked)
        self.lines.clicked.connect(self.lines_asked)
        layout.addWidget(self.preview)
        layout.addWidget(self.report)
        layout.addWidget(self.lines)
        self.show_template(None)

    @property
    def choice(self) -> tuple[str, str, str, str]:
        """Template, page, convention and language, to be remembered."""
        template = "" if self._template is None else str(self._template)
        options = self._chosen(USUAL)
        return template, options.page, options.convention, self._language_key

    def options(self) -> ReportOptions:
        """How the report is wanted.

        Raises
        ------
        InputError
            Where the template cannot be used any more.
        """
        return self._chosen(report_options(self._template))

    def show_choice(self, choice: tuple[str, str, str, str]) -> None:
        """Fill in what was chosen last; what is no longer there is left out."""
        template, page, convention, spoken = choice
        self.show_template(Path(template) if template else None)
        if page in PAGES:
            self.page.setCurrentIndex(list(PAGES).index(page))
        if spoken in LANGUAGE_KEYS:
            self.language.setCurrentIndex(LANGUAGE_KEYS.index(spoken))
        keys = ["", *(each.key for each in OTHERS)]
        self.convention.setCurrentIndex(keys.index(convention) if convention in keys else 0)

    def show_template(self, path: Path | None) -> None:
        """Take a template's page, convention and language over, or say what is wrong with it."""
        self._template = path
        self.template.setText(say(NO_TEMPLATE if path is None else path.name))
        self.template.setToolTip(widgets.plain_tip("" if path is None else str(path)))
        self.no_template.setVisible(path is not None)
        self.said.setText("")
        if path is not None:
            try:
                options = report_options(path)
            except InputError as error:
                self.said.setText(say(str(error)))
            else:
                self.page.setCurrentIndex(list(PAGES).index(options.page))
                self.language.setCurrentIndex(LANGUAGE_KEYS.index(options.language))
                keys = ["", *(each.key for each in OTHERS)]
                if options.convention in keys:
                    self.convention.setCurrentIndex(keys.index(options.convention))
        self.said.setVisible(bool(self.said.text()))

    def show_status(self, status: StepStatus, data_ready: bool, busy: bool) -> None:
        """What can be exported now."""
        self.advice.setText(say(status.advice))
        self.details.setEnabled(data_ready)
        self.preview.allow(status.ready and not busy)
        self.report.allow(status.ready and not busy)
        self.lines.allow(data_ready and not busy)

    def _choices(self) -> QFormLayout:
        self.page = widgets.Choice("report_page", list(PAGES.values()), "Size of the paper")
        self.language = widgets.Choice(
            "report_language", ["Same as window", *LANGUAGES.values()],
            "Language of the report; numbers keep their decimal point, JSON stays English",
        )  # fmt: skip
        names = [f"{each.name} ({STATUS_WORDS[each.status].lower()})" for each in OTHERS]
        self.convention = widgets.Choice(
            "report_convention", ["(none)", *names],
            "Also state the boresight as another program has it",
        )  # fmt: skip
        self.template = widgets.label(name="report_template")
        self.template.setTextFormat(Qt.TextFormat.PlainText)
        # A long name is cut off rather than to widen the panel; the tip has all of it.
        self.template.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        choose = widgets.button(
            "Choose…", "report_template_choose",
            tip="TOML file with logo, company, own texts, page, convention and language",
        )  # fmt: skip
        self.no_template = widgets.button("Without", "report_template_none", tip="Use no template")
        choose.clicked.connect(self.template_asked)
        self.no_template.clicked.connect(lambda: self._changed(None))
        row = QHBoxLayout()
        row.addWidget(self.template, 1)
        row.addWidget(self.no_template)
        row.addWidget(choose)
        form = QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow(say("Language"), self.language)
        form.addRow(say("Page"), self.page)
        form.addRow(say("Also give angles for"), self.convention)
        form.addRow(say("Template"), row)
        for box in (self.language, self.page, self.convention):
            box.activated.connect(lambda _index: self.changed.emit())
        return form

    def _changed(self, template: Path | None) -> None:
        self.show_template(template)
        self.changed.emit()

    def _chosen(self, options: ReportOptions) -> ReportOptions:
        keys = ["", *(each.key for each in OTHERS)]
        return replace(
            options,
            page=list(PAGES)[self.page.currentIndex()],
            convention=keys[self.convention.currentIndex()],
            language=language() if self._language_key == OF_WINDOW else self._language_key,
        )

    @property
    def _language_key(self) -> str:
        return LANGUAGE_KEYS[self.language.currentIndex()]
