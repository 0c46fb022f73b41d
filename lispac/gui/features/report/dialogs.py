"""Dialogues about the report."""

from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtWidgets import QFileDialog

from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.features.report.actions import ACTIONS
from lispac.gui.features.report.identity_dialog import IdentityDialog
from lispac.gui.features.report.preview_dialog import PreviewDialog
from lispac.identity import Identity
from lispac.language import N_, gettext

REPORT_FILTERS = (
    "PDF (*.pdf)", "HTML (*.html)", N_("Results as JSON (*.json)"),
    N_("Tables as CSV in a ZIP file (*.zip)"),
)  # fmt: skip


class ReportDialogs(Questions):
    """Dialogues about the report."""

    def report_file(self, start: Path) -> Path | None:
        """Ask for the file of the report; its suffix, or the chosen filter, sets the format."""
        filters = ";;".join(map(gettext, REPORT_FILTERS))
        name, kind = QFileDialog.getSaveFileName(
            self.parent, dialog_title(ACTIONS["report"]), str(start), filters
        )
        if not name:
            return None
        path = Path(name)
        ending = kind.rpartition("*")[2].rstrip(")")  # from "PDF (*.pdf)", in any language
        return path if path.suffix else path.with_suffix(ending)

    def pdf_file(self, start: Path) -> Path | None:
        """Ask for the PDF file of the previewed report."""
        name, _ = QFileDialog.getSaveFileName(
            self.parent, gettext("Save the report as PDF"), str(start), "PDF (*.pdf)"
        )
        path = Path(name)
        return (
            path.with_name(f"{path.name}.pdf" if not path.suffix else path.name) if name else None
        )

    def preview(self, pages: Sequence[bytes], save: Callable[[], str]) -> None:
        """Show the pages of the report; ``save`` saves them and returns a text about it."""
        run_dialog(PreviewDialog(pages, save, self.parent))

    def report_template(self, start: Path) -> Path | None:
        """Ask for the report template of a company."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent, gettext("Open report template"), str(start),
            gettext("Report template (*.toml)"),
        )  # fmt: skip
        return Path(name) if name else None

    def identity(self, identity: Identity, dates: Callable[[], str]) -> Identity | None:
        """Ask for the details of the report; ``dates`` returns the days of the lines."""
        dialog = IdentityDialog(identity, dates, self.parent)
        return dialog.identity if run_dialog(dialog) else None
