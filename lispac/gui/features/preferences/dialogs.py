"""Dialogue with the preferences of the user."""

from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.app.settings import AppSettings
from lispac.gui.features.preferences.preferences import Preferences
from lispac.gui.features.preferences.settings_dialog import SettingsDialog


class PreferenceDialogs(Questions):
    """Dialogue with the preferences of the user."""

    def preferences(self, present: Preferences, settings: AppSettings) -> Preferences | None:
        """Ask for the preferences for all projects; the dialogue also edits the sensor library."""
        dialog = SettingsDialog(present, settings.sensors, self.parent)
        return dialog.preferences if run_dialog(dialog) else None
