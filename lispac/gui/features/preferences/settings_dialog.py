"""Settings dialogue: preferences for all projects, and the library of sensors."""

from pathlib import Path

from PySide6.QtWidgets import QDialog, QFormLayout, QHBoxLayout, QTabWidget, QVBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.point_colours import Scale
from lispac.gui.app.settings import POINT_BUDGETS, POINT_SIZES
from lispac.gui.appearance import theme
from lispac.gui.appearance.units import ANGLES, LENGTHS
from lispac.gui.features.preferences.actions import ACTIONS
from lispac.gui.features.preferences.cache_box import CacheBox
from lispac.gui.features.preferences.preferences import Preferences
from lispac.gui.features.preferences.sensor_library import SensorLibraryPage
from lispac.gui.widgets.sensor_choice import SensorChoice
from lispac.language import LANGUAGES, N_, gettext
from lispac.survey.conventions.systems import OTHER_SYSTEMS
from lispac.workflow.planning.sensors import read_library

MILLION = 1_000_000
UNITS = {
    "degrees": N_("Degrees"),
    "milliradians": N_("Milliradians"),
    "minutes": N_("Arc minutes and seconds"),
    "metres": N_("Metres and millimetres"),
    "feet": N_("International feet (ft)"),
    "survey feet": N_("US survey feet (ftUS)"),
}
"""Names of the units by their keys."""
SYSTEM_DEFAULT = N_("System default")
THEMES = {"system": SYSTEM_DEFAULT, "light": N_("Light"), "dark": N_("Dark")}
"""Names of the themes by their keys."""
SCALES: dict[Scale, str] = {
    "viridis": N_("Viridis: uniform, suitable for colour-blind users"),
    "cividis": N_("Cividis: blue to yellow, suitable for colour-blind users"),
    "gray": N_("Greys"),
    "turbo": N_("Turbo: rainbow, not suitable for colour-blind users"),
}
"""Names of the colour scales."""


class SettingsDialog(QDialog):
    """Dialogue with a page of general preferences and one of sensors.

    Parameters
    ----------
    sensors : folder of the user's own sensors, which are written at each edit
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
            list(ANGLES)[self.angles.currentIndex()],
            list(LENGTHS)[self.lengths.currentIndex()],
            self.cache.folder,
            list(THEMES)[self.theme_box.currentIndex()],
            list(SCALES)[self.scale.currentIndex()],
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
        self.angles.setCurrentIndex(list(ANGLES).index(preferences.angles))
        self.lengths.setCurrentIndex(list(LENGTHS).index(preferences.lengths))
        self.cache.show_folder(preferences.cache)
        self.theme_box.setCurrentIndex(list(THEMES).index(preferences.theme))
        self.scale.setCurrentIndex(list(SCALES).index(preferences.scale))

    def _build(self) -> None:
        self.language = widgets.ChoiceBox(
            "settings_language", [gettext(SYSTEM_DEFAULT), *LANGUAGES.values()],
            gettext("Language of the window. The language of the report is set in step 5."),
        )  # fmt: skip
        pixels, million = gettext("pixels"), gettext("million")
        self.point_size = widgets.number(
            "settings_point_size", suffix=f" {pixels}", decimals=0, low=POINT_SIZES[0],
            high=POINT_SIZES[-1], step=1, tip=gettext("Size of a point in the 3D view"),
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
            "settings_angles", [gettext(UNITS[key]) for key in ANGLES],
            gettext(
                "Unit of the boresight angles, attitudes and their standard deviations in the "
                "window. Headings and inclinations stay in degrees. Files, reports and scripts "
                "have their own units."
            ),
        )  # fmt: skip
        self.lengths = widgets.ChoiceBox(
            "settings_lengths", [gettext(UNITS[key]) for key in LENGTHS],
            gettext("Unit of lengths in the window. Files, reports and scripts remain metric."),
        )  # fmt: skip
        self.theme_box = widgets.ChoiceBox(
            "settings_theme", [gettext(each) for each in THEMES.values()],
            gettext(
                "Light or dark colours of the window. The line colours of all themes suit "
                "colour-blind users."
            ),
        )  # fmt: skip
        self.scale = widgets.ChoiceBox(
            "settings_scale", [gettext(each) for each in SCALES.values()],
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
