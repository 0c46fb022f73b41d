"""Dialogue for the file of a picture."""

from collections.abc import Sequence
from pathlib import Path

from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions
from lispac.gui.features.inspect.actions import ACTIONS


class PictureDialogs(Questions):
    """Dialogue for the file of a picture."""

    def picture_file(self, start: Path, kinds: Sequence[str]) -> Path | None:
        """File for a picture; its suffix, or the chosen filter, sets the format."""
        filters = {f"{kind} (*.{kind.lower()})": f".{kind.lower()}" for kind in kinds}
        saved = self.file_to_save(dialog_title(ACTIONS["picture"]), start, filters)
        return None if saved is None else saved[0]
