"""Settings that are stored between runs of the program, and proposed folders."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path

from PySide6.QtCore import QByteArray, QLocale, QSettings, QStandardPaths

from lispac import caches
from lispac.gui.app.point_colours import COLOUR_SCALES, Scale
from lispac.gui.appearance.units import ANGLE_UNITS, LENGTH_UNITS
from lispac.gui.viewport.decimation import Budget
from lispac.installation_paths import home_folder
from lispac.language import LANGUAGES
from lispac.untrusted_values import json_values
from lispac.workflow.planning.sensors import user_sensors_folder

MAX_RECENT_PROJECTS = 8
MAX_COMPANIES = 20
"""Largest number of companies whose details for the report are stored."""
MAX_EXPORTED_REPORTS = 100
"""Largest number of projects whose last exported report is stored."""
THEMES = ("system", "light", "dark")
POINT_SIZES_PX = range(1, 13)
DEFAULT_POINT_SIZE_PX = 2
POINT_BUDGETS = range(100_000, 20_000_001)
"""Numbers of points that can be chosen as the largest number of drawn points."""


@dataclass(frozen=True)
class ReportChoice:
    """Options of a report as texts, as last chosen; empty if nothing was chosen."""

    template: str = ""
    page: str = ""
    convention: str = ""
    language: str = ""
    extent: str = ""


@dataclass(frozen=True)
class Appearance:
    """Settings that are applied when a window is created.

    Attributes
    ----------
    units : keys of the units of angles and lengths
    """

    language: str
    units: tuple[str, str]
    theme: str
    colour_scale: Scale


class AppSettings:
    """Recent projects, layout and preferences, stored in the user's cache folder.

    Parameters
    ----------
    file : Path or None
        INI file to use instead of the default one.
    """

    def __init__(self, file: Path | None = None) -> None:
        # These settings are convenient, but their loss is harmless, so they are in the cache
        cache = QStandardPaths.writableLocation(
            QStandardPaths.StandardLocation.GenericCacheLocation
        )
        place = caches.cache_folder_in(Path(cache))
        path = caches.writable_or_temporary_folder(place) / "window.ini" if file is None else file
        self.folder = path.parent
        # User-defined sensors must not be lost, so they are stored outside the cache
        self._config = None if file is None else path.parent
        self._sensors = user_sensors_folder() if file is None else path.parent / "sensors"
        self._store = QSettings(str(path), QSettings.Format.IniFormat)

    def recent(self) -> list[Path]:
        """Folders of the recent projects, the newest first."""
        stored = self._store.value("recent", [])
        names = [stored] if isinstance(stored, str) else list(stored or [])
        return [Path(name) for name in names if name]

    def add_recent(self, folder: Path) -> None:
        """Put a project folder first in the list of recent projects."""
        others = [known for known in self.recent() if known != folder]
        self._store.setValue("recent", [str(p) for p in [folder, *others][:MAX_RECENT_PROJECTS]])

    def clear_recent(self) -> None:
        """Clear the list of recent projects."""
        self._store.setValue("recent", [])

    @property
    def last_project(self) -> Path | None:
        """Folder of the project that is open, or was open at a crash; None after a normal end."""
        name = str(self._store.value("left_open", ""))
        return Path(name) if name else None

    @last_project.setter
    def last_project(self, folder: Path | None) -> None:
        self._store.setValue("left_open", "" if folder is None else str(folder))
        self._store.sync()

    def layout(self) -> tuple[QByteArray, QByteArray] | None:
        """Geometry and state of the window; None if it has not been open before."""
        geometry, state = self._store.value("geometry"), self._store.value("docks")
        if isinstance(geometry, QByteArray) and isinstance(state, QByteArray):
            return geometry, state
        return None

    def save_layout(self, geometry: QByteArray, state: QByteArray) -> None:
        """Store geometry and state of the window."""
        self._store.setValue("geometry", geometry)
        self._store.setValue("docks", state)

    @property
    def open_panels(self) -> list[str] | None:
        """English titles of the panels that the user wants open; None if nothing is stored."""
        try:
            stored = json_values(str(self._store.value("open_panels", "")))
        except ValueError:
            return None
        return [str(each) for each in stored] if isinstance(stored, list) else None

    @open_panels.setter
    def open_panels(self, titles: list[str]) -> None:
        self._store.setValue("open_panels", json.dumps(titles))

    @property
    def has_panel_height(self) -> bool:
        """Whether the stored layout has a height of the panels at the bottom that were shown."""
        return str(self._store.value("has_panel_height", "yes")) == "yes"

    @has_panel_height.setter
    def has_panel_height(self, has_height: bool) -> None:
        self._store.setValue("has_panel_height", "yes" if has_height else "no")

    def window_geometry(self, name: str) -> QByteArray | None:
        """Geometry of another window by its object name; None if it has not been open before."""
        stored = self._store.value(f"geometry_{name}")
        return stored if isinstance(stored, QByteArray) else None

    def save_window_geometry(self, name: str, geometry: QByteArray) -> None:
        """Store the geometry of another window."""
        self._store.setValue(f"geometry_{name}", geometry)

    def column_mappings(self) -> dict[str, str]:
        """Meaning of the columns of text files, by the layout of the file."""
        try:
            stored = json_values(str(self._store.value("columns", "{}")))
        except ValueError:
            return {}
        return {str(k): str(v) for k, v in stored.items()} if isinstance(stored, dict) else {}

    def save_column_mappings(self, mappings: dict[str, str]) -> None:
        """Store the meaning of columns for the next file with the same layout."""
        if mappings:
            all_mappings = self.column_mappings() | mappings
            self._store.setValue("columns", json.dumps(all_mappings))

    @property
    def point_size(self) -> int:
        """Size of a drawn point, pixels."""
        stored = str(self._store.value("point_size", DEFAULT_POINT_SIZE_PX))
        known = {str(size): size for size in POINT_SIZES_PX}
        return known.get(stored, DEFAULT_POINT_SIZE_PX)

    @point_size.setter
    def point_size(self, pixels: int) -> None:
        self._store.setValue("point_size", pixels)

    @property
    def point_budget(self) -> int:
        """Largest number of points drawn at rest."""
        stored = str(self._store.value("point_budget", ""))
        known = stored.isdecimal() and int(stored) in POINT_BUDGETS
        return int(stored) if known else Budget().resting

    @point_budget.setter
    def point_budget(self, points: int) -> None:
        self._store.setValue("point_budget", points)

    @property
    def has_used_mouse(self) -> bool:
        """Whether the mouse has been used in the 3D view, so that its help is not needed."""
        return str(self._store.value("has_used_mouse", "")) == "yes"

    @has_used_mouse.setter
    def has_used_mouse(self, used: bool) -> None:
        self._store.setValue("has_used_mouse", "yes" if used else "")

    @property
    def chosen_language(self) -> str:
        """Code of the chosen language; empty for the language of the system."""
        chosen = str(self._store.value("language", ""))
        return chosen if chosen in LANGUAGES else ""

    @property
    def language(self) -> str:
        """Code of the window's language: the chosen one, or the system's if available."""
        chosen = str(self._store.value("language", ""))
        system = QLocale.system().name().partition("_")[0]
        return next((code for code in (chosen, system) if code in LANGUAGES), "en")

    @language.setter
    def language(self, code: str) -> None:
        self._store.setValue("language", code)

    @property
    def theme(self) -> str:
        """Theme, one of `THEMES`: system, light or dark."""
        chosen = str(self._store.value("theme", ""))
        return chosen if chosen in THEMES else THEMES[0]

    @theme.setter
    def theme(self, choice: str) -> None:
        self._store.setValue("theme", choice)

    @property
    def colour_scale(self) -> Scale:
        """Colour scale of measured values at the points."""
        chosen = str(self._store.value("colour_scale", ""))
        return next(
            (scale for scale in COLOUR_SCALES if scale == chosen), next(iter(COLOUR_SCALES))
        )

    @colour_scale.setter
    def colour_scale(self, scale: Scale) -> None:
        self._store.setValue("colour_scale", scale)

    @property
    def appearance(self) -> Appearance:
        """Settings that require a new window."""
        return Appearance(self.language, self.units, self.theme, self.colour_scale)

    @appearance.setter
    def appearance(self, chosen: Appearance) -> None:
        self.language, self.units = chosen.language, chosen.units
        self.theme, self.colour_scale = chosen.theme, chosen.colour_scale

    @property
    def sensors(self) -> Path:
        """Folder of the user-defined sensors."""
        return self._sensors

    @property
    def default_sensors(self) -> tuple[str, str]:
        """Names of the default scanner and INS/GNSS of new projects; empty for none."""
        return str(self._store.value("scanner", "")), str(self._store.value("pos", ""))

    @default_sensors.setter
    def default_sensors(self, names: tuple[str, str]) -> None:
        for key, name in zip(("scanner", "pos"), names, strict=True):
            self._store.setValue(key, name)

    def keep_sensors(self, names: tuple[str, str]) -> None:
        """Use chosen sensors as defaults where there is none; empty for a sensor not chosen."""
        scanner, pos = self.default_sensors
        self.default_sensors = scanner or names[0], pos or names[1]

    @property
    def units(self) -> tuple[str, str]:
        """Keys of the units of angles and lengths that the window shows."""
        angles, lengths = (str(self._store.value(key, "")) for key in ("angles", "lengths"))
        return (
            angles if angles in ANGLE_UNITS else next(iter(ANGLE_UNITS)),
            lengths if lengths in LENGTH_UNITS else next(iter(LENGTH_UNITS)),
        )

    @units.setter
    def units(self, keys: tuple[str, str]) -> None:
        for name, key in zip(("angles", "lengths"), keys, strict=True):
            self._store.setValue(name, key)

    @property
    def cache_folder(self) -> Path | None:
        """Folder that contains the cache; None for the default folder of the system."""
        return caches.chosen_folder(self._config)

    @cache_folder.setter
    def cache_folder(self, folder: Path | None) -> None:
        caches.choose_folder(folder, self._config)

    def report_choice(self) -> ReportChoice:
        """Choices that were last used for a report."""
        names = [each.name for each in fields(ReportChoice)]
        return ReportChoice(*(str(self._store.value(f"report_{name}", "")) for name in names))

    def save_report_choice(self, choice: ReportChoice) -> None:
        """Store the choices for the next report."""
        for name, text in asdict(choice).items():
            self._store.setValue(f"report_{name}", text)

    @property
    def opens_report(self) -> bool:
        """Whether a report is opened after its export."""
        return str(self._store.value("opens_report", "yes")) == "yes"

    @opens_report.setter
    def opens_report(self, opens: bool) -> None:
        self._store.setValue("opens_report", "yes" if opens else "no")

    def companies(self) -> dict[str, dict[str, str]]:
        """Details for the report last used with each company, the newest company first."""
        try:
            stored = json_values(str(self._store.value("companies", "{}")))
        except ValueError:
            return {}
        if not isinstance(stored, dict):
            return {}
        return {
            str(name): {str(key): str(text) for key, text in details.items()}
            for name, details in stored.items()
            if isinstance(details, dict)
        }

    def save_company(self, name: str, details: Mapping[str, str]) -> None:
        """Store the details of a company for its next report."""
        others = {k: v for k, v in self.companies().items() if k != name}
        kept = list(others.items())[: MAX_COMPANIES - 1]
        self._store.setValue("companies", json.dumps({name: dict(details), **dict(kept)}))

    def exported_report(
        self, folder: Path
    ) -> tuple[Path, float, str, tuple[object, ...] | None] | None:
        """Report last exported from the project of a folder; None if there is none.

        Returns
        -------
        tuple of (Path, float, str, tuple or None)
            File, time of the export (seconds since 1970), digest of the project file with the
            content of the report, and its options (`ReportChoice` as a tuple). The digest is empty
            if that content was not saved; the options of older reports are not known.
        """
        stored = self._exported_reports().get(str(folder))
        match stored:
            case [str(path), (int() | float()) as exported, str(digest), *options]:
                known = options and isinstance(options[0], list)
                return Path(path), float(exported), digest, tuple(options[0]) if known else None
        return None

    def save_exported_report(
        self,
        folder: Path,
        path: Path,
        exported: float,
        file_digest: str,
        options: tuple[object, ...] | None = None,
    ) -> None:
        """Store the report last exported from the project of a folder."""
        others = [each for each in self._exported_reports().items() if each[0] != str(folder)]
        stored = {str(folder): [str(path), exported, file_digest, options]}
        stored.update(others[: MAX_EXPORTED_REPORTS - 1])
        self._store.setValue("exported_reports", json.dumps(stored))

    def _exported_reports(self) -> dict[str, object]:
        try:
            stored = json_values(str(self._store.value("exported_reports", "{}")))
        except ValueError:
            return {}
        return dict(stored) if isinstance(stored, dict) else {}

    def sync(self) -> None:
        """Write the settings now."""
        self._store.sync()


def documents_folder() -> Path:
    """Folder for the documents of the user."""
    documents = QStandardPaths.StandardLocation.DocumentsLocation
    return Path(QStandardPaths.writableLocation(documents) or home_folder())
