"""Dialogue for the file of a picture."""

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtWidgets import QFileDialog

from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions
from lispac.gui.features.inspect.actions import ACTIONS


class PictureDialogs(Questions):
    """Dialogue for the file of a picture."""

    def picture_file(self, start: Path, kinds: Sequence[str]) -> Path | None:
        """File for a picture; its suffix, or the chosen filter, sets the format."""
        filters = ";;".join(f"{kind} (*.{kind.lower()})" for kind in kinds)
        name, chosen = QFileDialog.getSaveFileName(
            self.parent, dialog_title(ACTIONS["picture"]), str(start), filters
        )
        if not name:
            return None
        path, ending = Path(name), f".{chosen.split(' ')[0].lower()}"
        known = path.suffix.lower() in {f".{kind.lower()}" for kind in kinds}
        return path if known else path.with_name(path.name + ending)
