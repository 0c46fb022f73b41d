"""Step 5: what leaves the program."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from lispac.gui.panels import widgets
from lispac.gui.status import StepStatus


class ReportPanel(QWidget):
    """Exports the report and the georeferenced lines."""

    report_asked = Signal()
    lines_asked = Signal()
    details_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        layout = widgets.column(self)
        self.advice = widgets.label("", "hint", wrap=True, name="report_advice")
        layout.addWidget(self.advice)
        self.report = widgets.button(
            "Export report…", "export_report", icon="file-document-outline", primary=True,
            tip="PDF, HTML or JSON; pictures of the view before and after go into it (Ctrl+E)",
        )  # fmt: skip
        self.lines = widgets.button(
            "Export georeferenced lines…", "export_lines", icon="export-variant",
            tip="Every line as LAZ or LAS in a coordinate system of your choice (Ctrl+Shift+E)",
        )  # fmt: skip
        self.details = widgets.button(
            "Details for the report…", "report_details", icon="card-account-details-outline",
            tip="Surveyor, vessel, instruments, dates: what page one says of who, when and with "
            "what",
        )  # fmt: skip
        self.details.clicked.connect(self.details_asked)
        self.report.clicked.connect(self.report_asked)
        self.lines.clicked.connect(self.lines_asked)
        layout.addWidget(self.details)
        layout.addWidget(self.report)
        layout.addWidget(self.lines)

    def show_status(self, status: StepStatus, data_ready: bool, busy: bool) -> None:
        """What can be exported now."""
        self.advice.setText(status.advice)
        self.details.setEnabled(data_ready)
        self.report.allow(status.ready and not busy)
        self.lines.allow(data_ready and not busy)
