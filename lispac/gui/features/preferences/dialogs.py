"""Settings dialogue: preferences for all projects, the cache, and the library of sensors."""

from pathlib import Path

from PySide6.QtWidgets import (
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QMessageBox,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from lispac import caches
from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.point_colours import Scale
from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.app.settings import POINT_BUDGETS, POINT_SIZES_PX, AppSettings
from lispac.gui.appearance import theme
from lispac.gui.appearance.units import ANGLE_UNITS, LENGTH_UNITS
from lispac.gui.features.preferences.actions import ACTIONS
from lispac.gui.features.preferences.preferences import Preferences
from lispac.gui.features.preferences.sensor_library import SensorLibraryPage
from lispac.gui.widgets.error_box import exception_text
from lispac.gui.widgets.number_input import NumberDialog
from lispac.gui.widgets.sensor_choice import SensorChoice
from lispac.language import LANGUAGES, N_, gettext
from lispac.survey.conventions.systems import OTHER_SYSTEMS
from lispac.workflow.planning.sensors import read_library


class CacheBox(QWidget):
    """Box to choose the folder of the cache, and to empty the cache immediately."""

    def __init__(self) -> None:
        super().__init__()
        self._folder: Path | None = None
        self.place = widgets.label("", wrap=True, name="settings_cache")
        self.size = widgets.label("", "muted", name="settings_cache_size")
        self.message_label = widgets.label("", "error", wrap=True, name="settings_cache_message")
        self.choose = widgets.button(
            gettext("Choose…"), "settings_cache_choose",
            tip=gettext(
                "Choose another folder for compiled code, the manual and font lists. The contents "
                "of the former folder are not moved."
            ),
        )  # fmt: skip
        self.usual = widgets.button(
            gettext("Default folder"), "settings_cache_usual",
            tip=gettext("Use the cache folder of the system"),
        )  # fmt: skip
        self.empty = widgets.button(
            gettext("Clear cache…"), "settings_cache_empty",
            tip=gettext("Delete files that the program can create again"),
        )  # fmt: skip
        row = QHBoxLayout()
        for each in (self.choose, self.usual, self.empty):
            each.setAutoDefault(False)
            row.addWidget(each)
        row.addWidget(self.size)
        row.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.place)
        layout.addLayout(row)
        layout.addWidget(self.message_label)
        self.choose.clicked.connect(self._choose)
        self.usual.clicked.connect(lambda: self.show_folder(None))
        self.empty.clicked.connect(self._empty_cache)
        self.show_folder(None)

    @property
    def folder(self) -> Path | None:
        """The chosen folder; None for the default one."""
        return self._folder

    def show_folder(self, folder: Path | None) -> None:
        """Show a folder and the size of its cache; None for the default folder."""
        self._folder = folder
        place = caches.cache_folder_in(folder)
        self.place.setText(str(place))
        self.usual.setEnabled(folder is not None)
        self._show_size(place)
        self._show_problem("")

    def choose_folder(self, folder: Path) -> None:
        """Choose a folder, or show why it cannot be used."""
        try:
            caches.require_writable(folder)
        except InputError as error:
            self._show_problem(exception_text(error))
        else:
            self.show_folder(folder)

    def _choose(self) -> None:
        start = self._folder or caches.default_folder()
        found = QFileDialog.getExistingDirectory(self, gettext("Folder for the cache"), str(start))
        if found:
            self.choose_folder(Path(found))

    def _empty_cache(self) -> None:
        place = caches.cache_folder_in(self._folder)
        if not self._confirm_deletion(place):
            return
        try:
            caches.empty_cache(place)
        except InputError as error:
            self._show_problem(exception_text(error))
        else:
            self._show_problem("")
        self._show_size(place)

    def _confirm_deletion(self, place: Path) -> bool:
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC", gettext("Clear the cache?"),
            QMessageBox.StandardButton.Cancel, self,
        )  # fmt: skip
        box.setObjectName("empty_cache")
        box.setInformativeText(
            gettext(
                "This deletes compiled code, the manual and font lists, which the program creates "
                "again when needed. Projects, settings and sensors are kept."
            )
        )
        remove = box.addButton(gettext("Clear cache"), QMessageBox.ButtonRole.DestructiveRole)
        box.exec()
        chosen = box.clickedButton()
        box.deleteLater()
        return chosen is remove

    def _show_size(self, place: Path) -> None:
        found = caches.cache_size(place)
        self.size.setText(
            gettext("{size:mb.1} MB", size=found) if found else gettext("The cache is empty")
        )
        self.empty.setEnabled(found > 0)

    def _show_problem(self, text: str) -> None:
        self.message_label.setText(text)
        self.message_label.setVisible(bool(text))


MILLION = 1_000_000
UNIT_NAMES = {
    "degrees": N_("Degrees"),
    "milliradians": N_("Milliradians"),
    "minutes": N_("Arc minutes and seconds"),
    "metres": N_("Metres and millimetres"),
    "feet": N_("International feet (ft)"),
    "survey feet": N_("US survey feet (ftUS)"),
}
"""Names of the units by their keys."""
SYSTEM_DEFAULT = N_("System default")
THEME_NAMES = {"system": SYSTEM_DEFAULT, "light": N_("Light"), "dark": N_("Dark")}
"""Names of the themes by their keys."""
SCALE_NAMES: dict[Scale, str] = {
    "viridis": N_("Viridis: uniform, suitable for colour-blind users"),
    "cividis": N_("Cividis: blue to yellow, suitable for colour-blind users"),
    "gray": N_("Greys"),
    "turbo": N_("Turbo: rainbow, not suitable for colour-blind users"),
}
"""Names of the colour scales."""


class SettingsDialog(NumberDialog):
    """Dialogue with a page of general preferences and one of sensors.

    Parameters
    ----------
    sensors : folder of the user-defined sensors, which are written at each edit
    """

    def __init__(self, present: Preferences, sensors: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("settings_dialog")
        self.setWindowTitle(dialog_title(ACTIONS["settings"]))
        self.resize(1180, 640)
        self._folder = sensors
        layout = widgets.vertical_layout(self, 16)
        self.tabs = QTabWidget()
        self.tabs.setObjectName("settings_tabs")
        self._form = QFormLayout()
        self._form.setVerticalSpacing(theme.SPACING)
        self._build()
        general = QWidget()
        outer = QVBoxLayout(general)
        outer.setContentsMargins(16, 12, 16, 12)
        outer.addLayout(self._form)
        outer.addStretch(1)
        self.library = SensorLibraryPage(sensors)
        self.library.changed.connect(self._reload_sensor_choice)
        self.tabs.addTab(general, gettext("General"))
        self.tabs.addTab(self.library, gettext("Sensors"))
        layout.addWidget(self.tabs, 1)
        layout.addLayout(self._buttons())
        self.show_preferences(present)

    @property
    def preferences(self) -> Preferences:
        """Preferences from the fields."""
        scanner, pos = self.choice.names
        return Preferences(
            ["", *LANGUAGES][self.language.currentIndex()],
            round(self.point_size.value()),
            round(self.point_budget.value() * MILLION),
            ["", *(each.key for each in OTHER_SYSTEMS)][self.convention.currentIndex()],
            scanner,
            pos,
            list(ANGLE_UNITS)[self.angles.currentIndex()],
            list(LENGTH_UNITS)[self.lengths.currentIndex()],
            self.cache.folder,
            list(THEME_NAMES)[self.theme_box.currentIndex()],
            list(SCALE_NAMES)[self.scale.currentIndex()],
        )

    def show_preferences(self, preferences: Preferences) -> None:
        """Fill in the fields."""
        self.language.setCurrentIndex(["", *LANGUAGES].index(preferences.language))
        self.point_size.setValue(preferences.point_size)
        self.point_budget.setValue(preferences.point_budget / MILLION)
        keys = ["", *(each.key for each in OTHER_SYSTEMS)]
        self.convention.setCurrentIndex(
            keys.index(preferences.convention) if preferences.convention in keys else 0
        )
        self.choice.choose(preferences.scanner, preferences.pos)
        self.angles.setCurrentIndex(list(ANGLE_UNITS).index(preferences.angles))
        self.lengths.setCurrentIndex(list(LENGTH_UNITS).index(preferences.lengths))
        self.cache.show_folder(preferences.cache)
        self.theme_box.setCurrentIndex(list(THEME_NAMES).index(preferences.theme))
        self.scale.setCurrentIndex(list(SCALE_NAMES).index(preferences.scale))

    def _build(self) -> None:
        self.language = widgets.ChoiceBox(
            "settings_language", [gettext(SYSTEM_DEFAULT), *LANGUAGES.values()],
            gettext("Language of the window. The language of the report is set in step 5."),
        )  # fmt: skip
        pixels, million = gettext("pixels"), gettext("million")
        self.point_size = widgets.number(
            "settings_point_size", suffix=f" {pixels}", decimals=0, low=POINT_SIZES_PX[0],
            high=POINT_SIZES_PX[-1], step=1, tip=gettext("Size of a point in the 3D view"),
        )  # fmt: skip
        self.point_budget = widgets.number(
            "settings_point_budget", suffix=f" {million}", decimals=1,
            low=POINT_BUDGETS[0] / MILLION, high=POINT_BUDGETS[-1] / MILLION, step=0.5,
            tip=gettext(
                "Largest number of points drawn while the 3D view does not move. Slow computers "
                "draw fewer points."
            ),
        )  # fmt: skip
        self.angles = widgets.ChoiceBox(
            "settings_angles", [gettext(UNIT_NAMES[key]) for key in ANGLE_UNITS],
            gettext(
                "Unit of the boresight angles, attitudes and their standard deviations in the "
                "window. Headings and inclinations stay in degrees. Files, reports and scripts "
                "have their own units."
            ),
        )  # fmt: skip
        self.lengths = widgets.ChoiceBox(
            "settings_lengths", [gettext(UNIT_NAMES[key]) for key in LENGTH_UNITS],
            gettext("Unit of lengths in the window. Files, reports and scripts remain metric."),
        )  # fmt: skip
        self.theme_box = widgets.ChoiceBox(
            "settings_theme", [gettext(each) for each in THEME_NAMES.values()],
            gettext(
                "Light or dark colours of the window. The line colours of all themes suit "
                "colour-blind users."
            ),
        )  # fmt: skip
        self.scale = widgets.ChoiceBox(
            "settings_scale", [gettext(each) for each in SCALE_NAMES.values()],
            gettext(
                "Colour scale of points coloured by height, intensity, range or time. Residuals "
                "have their own scale."
            ),
        )  # fmt: skip
        self.convention = widgets.ChoiceBox(
            "settings_convention", [gettext("(none)"), *(each.name for each in OTHER_SYSTEMS)],
            gettext("The report also gives the boresight angles in the convention of the chosen "
                    "program"),
        )  # fmt: skip
        self.cache = CacheBox()
        for field in (self.point_size, self.point_budget):
            field.setMaximumWidth(160)
        self._form.addRow(widgets.label(gettext("Window"), "heading"))
        self._form.addRow(gettext("Language"), self.language)
        self._form.addRow(gettext("Theme"), self.theme_box)
        self._form.addRow(gettext("Colour scale of points"), self.scale)
        self._form.addRow(gettext("Point size"), self.point_size)
        self._form.addRow(gettext("Maximum number of points drawn"), self.point_budget)
        self._form.addRow(gettext("Unit of angles"), self.angles)
        self._form.addRow(gettext("Unit of lengths"), self.lengths)
        self._form.addRow(widgets.label(gettext("Report"), "heading"))
        self._form.addRow(gettext("Also give angles for"), self.convention)
        self._form.addRow(widgets.label(gettext("Cache"), "heading"))
        self._form.addRow(gettext("Folder"), self.cache)
        self._form.addRow(widgets.label(gettext("Sensors of new projects"), "heading"))
        self._add_sensor_choice()

    def _add_sensor_choice(self) -> None:
        self.choice = SensorChoice(read_library(self._folder), "settings")
        self._form.addRow(gettext("Scanner"), self.choice.scanner)
        self._form.addRow("", self.choice.scanner_origin)
        self._form.addRow(gettext("INS/GNSS"), self.choice.pos)
        self._form.addRow("", self.choice.pos_origin)

    def _reload_sensor_choice(self) -> None:
        names = self.choice.names
        for _row in range(4):
            self._form.removeRow(self._form.rowCount() - 1)
        self.choice.deleteLater()
        self._add_sensor_choice()
        self.choice.choose(*names)

    def _buttons(self) -> QHBoxLayout:
        self.restore = widgets.button(
            gettext("Restore defaults"), "settings_restore",
            tip=gettext("Reset all settings; your own sensors are kept"),
        )  # fmt: skip
        cancel = widgets.button(gettext("Cancel"), "settings_cancel")
        self.keep = widgets.button(gettext("OK"), "settings_keep", primary=True)
        self.keep.setDefault(True)
        self.restore.clicked.connect(lambda: self.show_preferences(Preferences()))
        cancel.clicked.connect(self.reject)
        self.keep.clicked.connect(self.accept)
        row = QHBoxLayout()
        row.addWidget(self.restore)
        row.addStretch(1)
        for each in widgets.in_platform_order(self.keep, cancel):
            row.addWidget(each)
        for each in (self.restore, cancel):
            each.setAutoDefault(False)
        return row


class PreferenceDialogs(Questions):
    """Dialogue with the preferences of the user."""

    def preferences(self, present: Preferences, settings: AppSettings) -> Preferences | None:
        """Ask for the preferences for all projects; the dialogue also edits the sensor library."""
        dialog = SettingsDialog(present, settings.sensors, self.parent)
        return dialog.preferences if run_dialog(dialog) else None
