"""Step 5: options and export of the report and of the georeferenced lines."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QFormLayout, QHBoxLayout, QSizePolicy, QWidget

from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.app.settings import ReportChoice
from lispac.gui.app.unavailable import Unavailable, first_reason, reason_text
from lispac.gui.features.report.identity_dialog import missing_details_text
from lispac.gui.project.status import REPORT, ProjectState
from lispac.gui.widgets.error_box import exception_text
from lispac.language import LANGUAGES, N_, current_language, gettext
from lispac.report.options import DEFAULT_OPTIONS, EXTENTS, PAGE_SIZES, ReportOptions
from lispac.survey.conventions.systems import OTHER_SYSTEMS, Status
from lispac.workflow.output.report_options import report_options

PROGRAM_STATUS_TEXTS: dict[Status, str] = {
    "verified": N_("{program} (verified)"),
    "partly": N_("{program} (partly verified)"),
    "unverified": N_("{program} (not verified)"),
}
"""Text with the name of a program, by the status of its convention."""
_TRANSLATED_PROGRAM_NAMES = (
    N_("Phoenix SpatialExplorer 6 and later"),
    N_("Phoenix SpatialExplorer 1 to 5"),
)
"""Names of programs that the catalogue translates; all others are the same in each language."""
NO_TEMPLATE_TEXT = N_("None")
WINDOW_LANGUAGE_KEY = "window"
"""Value for a report in the language of the window."""
LANGUAGE_KEYS = (WINDOW_LANGUAGE_KEY, *LANGUAGES)


class ReportPanel(QWidget):
    """Options of the report, and buttons to export it and the georeferenced lines."""

    report_requested = Signal()
    lines_requested = Signal()
    details_requested = Signal()
    preview_requested = Signal()
    template_requested = Signal()
    open_requested = Signal(object)
    """`Path` of the exported report, or of its folder, to be opened."""
    changed = Signal()
    """An option of the report was changed."""

    def __init__(self) -> None:
        super().__init__()
        self._template: Path | None = None
        self._exported: Path | None = None
        layout = widgets.vertical_layout(self)
        self.details = widgets.button(
            gettext("Details for the report…"), "report_details",
            icon="card-account-details-outline",
            tip=gettext("Enter client, company, persons, vessel, instruments and dates for the "
                        "report"),
        )  # fmt: skip
        layout.addWidget(self.details)
        layout.addLayout(self._create_choice_form())
        self.report = widgets.button(
            gettext("Export report…"), "export_report", icon="file-document-outline", primary=True,
            tip=gettext(
                "Write the report as PDF, HTML, JSON or tables (CSV in a ZIP file), with "
                "pictures of the view before and after (Ctrl+E)"
            ),
        )  # fmt: skip
        self.preview = widgets.button(
            gettext("Preview"), "preview_report", icon="eye-outline",
            tip=gettext("Show the pages of the report as they will be printed, and save them "
                        "as PDF"),
        )  # fmt: skip
        self.lines = widgets.button(
            gettext("Export georeferenced lines…"), "export_lines", icon="export-variant",
            tip=gettext(
                "Write each line as LAZ or LAS in a coordinate system of your choice "
                "(Ctrl+Shift+E)"
            ),
        )  # fmt: skip
        self.details.clicked.connect(self.details_requested)
        self.preview.clicked.connect(self.preview_requested)
        self.report.clicked.connect(self.report_requested)
        self.lines.clicked.connect(self.lines_requested)
        layout.addWidget(self.preview)
        layout.addWidget(self.report)
        self.opens = QCheckBox(gettext("Open the report after the export"))
        self.opens.setObjectName("report_opens")
        self.opens.toggled.connect(lambda _checked: self.changed.emit())
        layout.addWidget(self.opens)
        layout.addLayout(self._create_exported_row())
        layout.addWidget(self.lines)
        # Texts that change are below the controls, which then stay in place
        self.advice = widgets.label("", "hint", wrap=True, name="report_advice")
        self.missing = widgets.label("", "muted", wrap=True, name="report_missing")
        self.template_error = widgets.label("", "error", wrap=True, name="report_message")
        for each in (self.template_error, self.advice, self.missing):
            layout.addWidget(each)
        self.show_template(None)

    @property
    def choice(self) -> ReportChoice:
        """The chosen options, to be stored in the settings."""
        template = "" if self._template is None else str(self._template)
        options = self._with_choices(DEFAULT_OPTIONS)
        return ReportChoice(
            template, options.page, options.convention, self._language_key, options.extent
        )

    def options(self) -> ReportOptions:
        """Options of the report.

        Raises
        ------
        InputError
            If the template can no longer be used.
        """
        return self._with_choices(report_options(self._template))

    def show_choice(self, choice: ReportChoice) -> None:
        """Show the last choice; entries that no longer exist are ignored."""
        self.show_template(Path(choice.template) if choice.template else None)
        if choice.extent in EXTENTS:
            self.extent.setCurrentIndex(list(EXTENTS).index(choice.extent))
        if choice.page in PAGE_SIZES:
            self.page.setCurrentIndex(list(PAGE_SIZES).index(choice.page))
        if choice.language in LANGUAGE_KEYS:
            self.language.setCurrentIndex(LANGUAGE_KEYS.index(choice.language))
        keys = ["", *(each.key for each in OTHER_SYSTEMS)]
        convention = choice.convention if choice.convention in keys else ""
        self.convention.setCurrentIndex(keys.index(convention))

    def show_template(self, path: Path | None) -> None:
        """Use the options of a template, or show the error in it."""
        self._template = path
        self.template.setText(gettext(NO_TEMPLATE_TEXT) if path is None else path.name)
        self.template.setToolTip(widgets.plain_tip("" if path is None else str(path)))
        self.no_template.setVisible(path is not None)
        self.template_error.setText("")
        if path is not None:
            try:
                options = report_options(path)
            except InputError as error:
                self.template_error.setText(exception_text(error))
            else:
                self.extent.setCurrentIndex(list(EXTENTS).index(options.extent))
                self.page.setCurrentIndex(list(PAGE_SIZES).index(options.page))
                self.language.setCurrentIndex(LANGUAGE_KEYS.index(options.language))
                keys = ["", *(each.key for each in OTHER_SYSTEMS)]
                if options.convention in keys:
                    self.convention.setCurrentIndex(keys.index(options.convention))
        self.template_error.setVisible(bool(self.template_error.text()))

    def show_state(self, state: ProjectState) -> None:
        """Show the next action, and enable the exports that are possible now."""
        status = state.steps[REPORT]
        busy = first_reason((state.is_busy, Unavailable.BUSY))
        no_data = first_reason(
            (state.project is None, Unavailable.NO_PROJECT),
            (state.survey is None, Unavailable.READING),
        )
        self.advice.setText(status.advice)
        self.details.set_reason(reason_text(no_data))
        missing = () if state.project is None else state.project.identity.missing
        self.missing.setText(missing_details_text(missing, in_form=False) if missing else "")
        self.missing.setVisible(bool(missing))
        for button in (self.preview, self.report):
            button.set_reason(reason_text(status.reason or busy))
        self.lines.set_reason(reason_text(no_data or busy))
        self._exported = None if state.report is None else state.report.path
        no_report = first_reason((self._exported is None, Unavailable.NO_REPORT))
        for each in (self.open_report, self.open_folder):
            each.set_reason(reason_text(no_report))

    def _create_exported_row(self) -> QHBoxLayout:
        row = QHBoxLayout()
        self.open_report = widgets.button(
            gettext("Open report"), "report_open",
            tip=gettext("Open the report that was exported last"),
        )  # fmt: skip
        self.open_folder = widgets.button(
            gettext("Open folder"), "report_open_folder",
            tip=gettext("Open the folder of the report that was exported last"),
        )  # fmt: skip
        self.open_report.clicked.connect(lambda: self.open_requested.emit(self._exported))
        self.open_folder.clicked.connect(lambda: self.open_requested.emit(self._exported.parent))
        row.addWidget(self.open_report, 1)
        row.addWidget(self.open_folder, 1)
        return row

    def _create_choice_form(self) -> QFormLayout:
        self.extent = widgets.ChoiceBox(
            "report_extent", list(map(gettext, EXTENTS.values())),
            gettext("Extent of the report in PDF and HTML. JSON and CSV tables are complete."),
        )  # fmt: skip
        self.page = widgets.ChoiceBox(
            "report_page", list(map(gettext, PAGE_SIZES.values())), gettext("Paper size")
        )
        self.language = widgets.ChoiceBox(
            "report_language", [gettext("Same as window"), *LANGUAGES.values()],
            gettext("Language of the report. JSON is always in English."),
        )  # fmt: skip
        names = [
            gettext(PROGRAM_STATUS_TEXTS[each.status], program=gettext(each.name))
            for each in OTHER_SYSTEMS
        ]
        self.convention = widgets.ChoiceBox(
            "report_convention", [gettext("(none)"), *names],
            gettext("Give the boresight also in the convention of another program"),
        )  # fmt: skip
        self.template = widgets.label(name="report_template")
        self.template.setTextFormat(Qt.TextFormat.PlainText)
        # A long name is cut off, so that it does not widen the panel; the tip shows it whole.
        self.template.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        choose = widgets.button(
            gettext("Choose…"), "report_template_choose",
            tip=gettext("Template of the report: TOML file with logo, company, texts, page, "
                        "convention, language and extent"),
        )  # fmt: skip
        self.no_template = widgets.button(
            gettext("Clear"), "report_template_none", tip=gettext("Do not use a template")
        )
        choose.clicked.connect(self.template_requested)
        self.no_template.clicked.connect(lambda: self._on_template_changed(None))
        row = QHBoxLayout()
        row.addWidget(self.template, 1)
        row.addWidget(self.no_template)
        row.addWidget(choose)
        form = QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow(gettext("Extent"), self.extent)
        form.addRow(gettext("Language"), self.language)
        form.addRow(gettext("Paper size"), self.page)
        form.addRow(gettext("Also give angles for"), self.convention)
        form.addRow(gettext("Template"), row)
        for box in (self.extent, self.language, self.page, self.convention):
            box.activated.connect(lambda _index: self.changed.emit())
        return form

    def _on_template_changed(self, template: Path | None) -> None:
        self.show_template(template)
        self.changed.emit()

    def _with_choices(self, options: ReportOptions) -> ReportOptions:
        keys = ["", *(each.key for each in OTHER_SYSTEMS)]
        return replace(
            options,
            extent=list(EXTENTS)[self.extent.currentIndex()],
            page=list(PAGE_SIZES)[self.page.currentIndex()],
            convention=keys[self.convention.currentIndex()],
            language=current_language()
            if self._language_key == WINDOW_LANGUAGE_KEY
            else self._language_key,
        )

    @property
    def _language_key(self) -> str:
        return LANGUAGE_KEYS[self.language.currentIndex()]
