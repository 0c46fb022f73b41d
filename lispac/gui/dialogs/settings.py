"""Settings: what holds for all projects, and the library of sensors."""

from pathlib import Path

from PySide6.QtWidgets import QDialog, QFormLayout, QHBoxLayout, QTabWidget, QVBoxLayout, QWidget

from lispac.gui import theme
from lispac.gui.colouring import Scale
from lispac.gui.dialogs.cache_box import CacheBox
from lispac.gui.dialogs.import_files.sensor_choice import SensorChoice
from lispac.gui.dialogs.sensor_library import SensorLibraryPage
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.report import OTHERS
from lispac.gui.preferences import Preferences
from lispac.gui.settings import POINT_BUDGETS, POINT_SIZES
from lispac.gui.units import ANGLES, LENGTHS
from lispac.language import LANGUAGES, gettext
from lispac.workflow.sensors import library

MILLION = 1_000_000
UNITS = {
    "degrees": "Degrees",
    "milliradians": "Milliradians",
    "minutes": "Arc minutes and seconds",
    "metres": "Metres and millimetres",
    "feet": "International feet (ft)",
    "survey feet": "US survey feet (ftUS)",
}
"""What the units shown are called, by their keys."""
LOOKS = {"system": "System default", "light": "Light", "dark": "Dark"}
"""What the themes are called."""
SCALES: dict[Scale, str] = {
    "viridis": "Viridis: even, safe for the colour-blind",
    "cividis": "Cividis: blue to yellow, safe for the colour-blind",
    "gray": "Greys",
    "turbo": "Turbo: a rainbow, not safe for the colour-blind",
}
"""What the scales of colours are called."""


class SettingsDialog(QDialog):
    """A page for what is preferred, one for the sensors.

    Parameters
    ----------
    sensors : folder of the user's own sensors, which change as they are edited
    """

    def __init__(self, present: Preferences, sensors: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("settings_dialog")
        self.setWindowTitle(say("Settings"))
        self.resize(1180, 640)
        self._folder = sensors
        layout = widgets.column(self, 16)
        self.tabs = QTabWidget()
        self.tabs.setObjectName("settings_tabs")
        self._form = QFormLayout()
        self._form.setVerticalSpacing(theme.SPACE)
        self._build()
        general = QWidget()
        outer = QVBoxLayout(general)
        outer.setContentsMargins(16, 12, 16, 12)
        outer.addLayout(self._form)
        outer.addStretch(1)
        self.library = SensorLibraryPage(sensors)
        self.library.changed.connect(self._renew_choice)
        self.tabs.addTab(general, say("General"))
        self.tabs.addTab(self.library, say("Sensors"))
        layout.addWidget(self.tabs, 1)
        layout.addLayout(self._buttons())
        self.show_preferences(present)

    @property
    def preferences(self) -> Preferences:
        """What the fields say."""
        scanner, pos = self.choice.names
        return Preferences(
            ["", *LANGUAGES][self.language.currentIndex()],
            round(self.point_size.value()),
            round(self.point_budget.value() * MILLION),
            ["", *(each.key for each in OTHERS)][self.convention.currentIndex()],
            scanner,
            pos,
            list(ANGLES)[self.angles.currentIndex()],
            list(LENGTHS)[self.lengths.currentIndex()],
            self.cache.folder,
            list(LOOKS)[self.looks.currentIndex()],
            list(SCALES)[self.scale.currentIndex()],
        )

    def show_preferences(self, given: Preferences) -> None:
        """Fill in."""
        self.language.setCurrentIndex(["", *LANGUAGES].index(given.language))
        self.point_size.setValue(given.point_size)
        self.point_budget.setValue(given.point_budget / MILLION)
        keys = ["", *(each.key for each in OTHERS)]
        self.convention.setCurrentIndex(
            keys.index(given.convention) if given.convention in keys else 0
        )
        self.choice.choose(given.scanner, given.pos)
        self.angles.setCurrentIndex(list(ANGLES).index(given.angles))
        self.lengths.setCurrentIndex(list(LENGTHS).index(given.lengths))
        self.cache.show_folder(given.cache)
        self.looks.setCurrentIndex(list(LOOKS).index(given.theme))
        self.scale.setCurrentIndex(list(SCALES).index(given.scale))

    def _build(self) -> None:
        self.language = widgets.Choice(
            "settings_language", ["System default", *LANGUAGES.values()],
            "Language of the window; the report has its own in step 5",
        )  # fmt: skip
        self.point_size = widgets.number(
            "settings_point_size", suffix=" pixels", decimals=0, low=POINT_SIZES[0],
            high=POINT_SIZES[-1], step=1, tip="Size of a drawn point",
        )  # fmt: skip
        self.point_budget = widgets.number(
            "settings_point_budget", suffix=" million", decimals=1,
            low=POINT_BUDGETS[0] / MILLION, high=POINT_BUDGETS[-1] / MILLION, step=0.5,
            tip="Points drawn while the view rests, at most; a slow computer draws fewer",
        )  # fmt: skip
        self.angles = widgets.Choice(
            "settings_angles", [UNITS[key] for key in ANGLES],
            "Unit of the boresight, of attitudes and of their sigmas in the window. Headings and "
            "inclinations stay in degrees; files, reports and scripts have their own units",
        )  # fmt: skip
        self.lengths = widgets.Choice(
            "settings_lengths", [UNITS[key] for key in LENGTHS],
            "Unit of lengths and distances in the window; files, reports and scripts stay metric",
        )  # fmt: skip
        self.looks = widgets.Choice(
            "settings_looks", list(LOOKS.values()),
            "Colours of the window; those of the lines are told apart on either ground, by the "
            "colour-blind too",
        )  # fmt: skip
        self.scale = widgets.Choice(
            "settings_scale", list(SCALES.values()),
            "Colours of the points by height, intensity, range or time; residuals have their own",
        )  # fmt: skip
        self.convention = widgets.Choice(
            "settings_convention", ["(none)", *(each.name for each in OTHERS)],
            "Reports also state the boresight as another program has it",
        )  # fmt: skip
        self.cache = CacheBox()
        for field in (self.point_size, self.point_budget):
            field.setMaximumWidth(160)
        self._form.addRow(widgets.label("Window", "heading"))
        self._form.addRow(say("Language"), self.language)
        self._form.addRow(gettext("Theme"), self.looks)
        self._form.addRow(say("Colours of measured values"), self.scale)
        self._form.addRow(say("Size of points"), self.point_size)
        self._form.addRow(say("Points drawn at most"), self.point_budget)
        self._form.addRow(say("Angles"), self.angles)
        self._form.addRow(say("Lengths"), self.lengths)
        self._form.addRow(widgets.label("Report", "heading"))
        self._form.addRow(say("Also give angles for"), self.convention)
        self._form.addRow(widgets.label("Cache", "heading"))
        self._form.addRow(say("Folder"), self.cache)
        self._form.addRow(widgets.label("New projects begin with", "heading"))
        self._place_choice()

    def _place_choice(self) -> None:
        self.choice = SensorChoice(library(self._folder), "settings")
        self._form.addRow(say("Scanner"), self.choice.scanner)
        self._form.addRow("", self.choice.scanner_origin)
        self._form.addRow(say("INS/GNSS"), self.choice.pos)
        self._form.addRow("", self.choice.pos_origin)

    def _renew_choice(self) -> None:
        names = self.choice.names
        for _row in range(4):
            self._form.removeRow(self._form.rowCount() - 1)
        self.choice.deleteLater()
        self._place_choice()
        self.choice.choose(*names)

    def _buttons(self) -> QHBoxLayout:
        self.restore = widgets.button(
            "Restore defaults", "settings_restore",
            tip="The settings of a new user; your own sensors stay",
        )  # fmt: skip
        cancel = widgets.button("Cancel", "settings_cancel")
        self.keep = widgets.button("OK", "settings_keep", primary=True)
        self.keep.setDefault(True)
        self.restore.clicked.connect(lambda: self.show_preferences(Preferences()))
        cancel.clicked.connect(self.reject)
        self.keep.clicked.connect(self.accept)
        row = QHBoxLayout()
        row.addWidget(self.restore)
        row.addStretch(1)
        for each in widgets.in_order(self.keep, cancel):
            row.addWidget(each)
        for each in (self.restore, cancel):
            each.setAutoDefault(False)
        return row
