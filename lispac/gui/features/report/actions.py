"""Action of the report."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("report", N_("&Export report…"),
        N_("Write the report as PDF, HTML, JSON or tables (CSV in a ZIP file)"), ("File", 3, 1),
        toolbar=(4, 3), short=N_("Report"), icon="file-document-outline", keys="Ctrl+E",
        uses_values=True),
)  # fmt: skip
