"""Dialogue for the file of a boresight for another program."""

from collections.abc import Sequence
from pathlib import Path

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
        saved = self.file_to_save(
            gettext("Save for this program"),
            start.with_name(start.name + formats[0].ending),
            {text: each.ending for text, each in by_filter.items()},
            keeps_other_endings=False,
        )
        return None if saved is None else (saved[0], by_filter[saved[1]])
