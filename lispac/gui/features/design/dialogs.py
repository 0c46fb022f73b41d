"""Dialogues of the survey design."""

from pathlib import Path
from typing import TYPE_CHECKING, Literal

from PySide6.QtWidgets import QApplication, QFileDialog

from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.app.settings import AppSettings
from lispac.language import N_, gettext

if TYPE_CHECKING:
    from lispac.gui.features.design.system import Sensors

DesignFile = Literal["open", "save", "page", "site"]
DESIGN_FILE_DIALOGS: dict[DesignFile, tuple[str, str, bool]] = {
    "open": (N_("Open survey plan"), N_("Survey plan (*.toml)"), False),
    "save": (N_("Save survey plan"), N_("Survey plan (*.toml)"), True),
    "page": (N_("Save field plan"), "PDF (*.pdf)", True),
    "site": (N_("Open site file"), N_("Site file (*.toml)"), False),
}
"""Title and filter of the file dialogue, and whether the file is written."""


class DesignDialogs(Questions):
    """Dialogues of the survey design."""

    def design_file(self, what: DesignFile, start: Path) -> Path | None:
        """A file of a plan, a site or a field plan, to read or to write."""
        title, filter_, writes = DESIGN_FILE_DIALOGS[what]
        if writes:
            saved = self.file_to_save(gettext(title), start, {gettext(filter_): start.suffix})
            return None if saved is None else saved[0]
        name, _ = QFileDialog.getOpenFileName(
            self.parent, gettext(title), str(start), gettext(filter_)
        )
        return Path(name) if name else None

    def sensors_of_plan(self, settings: AppSettings) -> "Sensors | None":
        """Sensors of the library for a plan; None if the dialogue is cancelled."""
        from lispac.gui.features.design.system import PlanSensorsDialog

        dialog = PlanSensorsDialog(settings.sensors, QApplication.activeWindow() or self.parent)
        dialog.choice.choose(*settings.default_sensors)
        return dialog.sensors if run_dialog(dialog) else None
