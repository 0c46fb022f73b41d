"""Dialogue for the file of a boresight for another program."""

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtWidgets import QFileDialog

from lispac.gui.app.questions import Questions
from lispac.language import gettext
from lispac.workflow.output.installation import InstallationFormat


class ConventionDialogs(Questions):
    """Dialogue for the file of a boresight for another program."""

    def installation_file(
        self, start: Path, formats: Sequence[InstallationFormat]
    ) -> tuple[Path, InstallationFormat] | None:
        """File without its ending as ``start``; the chosen filter sets the format."""
        by_filter = {f"{each.name} (*{each.ending})": each for each in formats}
        name, chosen = QFileDialog.getSaveFileName(
            self.parent, gettext("Save for this program"), f"{start}{formats[0].ending}",
            ";;".join(by_filter),
        )  # fmt: skip
        if not name:
            return None
        form = by_filter[chosen] if chosen in by_filter else formats[0]
        path = Path(name)
        known = path.suffix.lower() == form.ending
        return path if known else path.with_name(path.name + form.ending), form
