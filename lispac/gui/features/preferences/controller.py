"""Dialogue of the preferences, and their application to the window."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, Signal

from lispac.errors import InputError
from lispac.gui.app.actions import Actions
from lispac.gui.app.settings import AppSettings
from lispac.gui.features.preferences.actions import THEME_ACTIONS
from lispac.gui.features.preferences.dialogs import PreferenceDialogs
from lispac.gui.features.preferences.preferences import Preferences
from lispac.gui.project.controller import Controller
from lispac.gui.viewport.base import Viewport
from lispac.language import current_language


class PreferencesController(QObject):
    """Asks for preferences and applies them to the window."""

    report_choice_changed = Signal()
    """Preferences were stored, which may include options of the report."""

    def __init__(
        self,
        viewport: Viewport,
        controller: Controller,
        dialogs: PreferenceDialogs,
        settings: AppSettings,
        actions: Actions,
        rebuild_window: Callable[[], None],
    ) -> None:
        super().__init__(actions)
        self._viewport, self._controller, self._dialogs = viewport, controller, dialogs
        self._settings, self._rebuild_window = settings, rebuild_window
        self._actions = actions
        self._set_point_budget()
        self.show_choices()
        actions.connect_slots(
            {
                "settings": self.show_dialog,
                "english": partial(self._set_language, "en"),
                "french": partial(self._set_language, "fr"),
                **{name: partial(self._set_theme, theme) for theme, name in THEME_ACTIONS.items()},
            }
        )

    def show_choices(self) -> None:
        """Show the present language and theme in the menus."""
        language = "french" if current_language() == "fr" else "english"
        for name in (language, THEME_ACTIONS[self._settings.theme]):
            self._actions[name].setChecked(True)

    def show_dialog(self) -> None:
        """Show the dialogue and apply the choices.

        A new language, theme, system of units or colour scale rebuilds the window.
        """
        settings = self._settings
        before = settings.appearance
        entered = self._dialogs.preferences(Preferences.of(settings), settings)
        if entered is None:
            return
        try:
            entered.save(settings)
        except InputError as error:
            self._controller.refused.emit(error)
        self._viewport.set_point_size(entered.point_size)
        self._set_point_budget()
        self.report_choice_changed.emit()
        if settings.appearance != before:
            self._rebuild_window()

    def _set_language(self, language: str) -> None:
        if language != self._settings.language:
            self._settings.language = language
            self._rebuild_window()

    def _set_theme(self, theme: str) -> None:
        if theme != self._settings.theme:
            self._settings.theme = theme
            self._rebuild_window()

    def _set_point_budget(self) -> None:
        self._viewport.set_point_budget(self._settings.point_budget)
