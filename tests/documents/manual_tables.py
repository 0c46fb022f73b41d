"""Write the tables of fields and formats of the manual, from the window and the readers.

``python -m tests.documents`` renews ``resources/manual/*/tables``; a test in
`tests/gui/features/help/test_gui_manual.py` holds what is there against what would be written. No
screen is needed.
"""

import os
import re
import sys
import tempfile
from collections.abc import Callable, Iterator
from itertools import chain
from pathlib import Path

from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QLineEdit,
    QWidget,
)

from lispac.gui.app.actions import Keys, menu_groups
from lispac.gui.app.language import set_language
from lispac.gui.app.settings import AppSettings
from lispac.gui.features.conventions.convention_panel import ConventionPanel
from lispac.gui.features.estimate.adjust_panel import AdjustPanel
from lispac.gui.features.help.dialogs import KEYS, keys_text
from lispac.gui.features.open_project.data_panel import DataPanel
from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.features.pick_targets.targets_panel import TargetsPanel
from lispac.gui.features.preferences.dialogs import SettingsDialog
from lispac.gui.features.preferences.preferences import Preferences
from lispac.gui.features.report.report_panel import ReportPanel
from lispac.gui.features.validate.histograms_panel import HistogramsPanel
from lispac.gui.features.validate.validate_panel import ValidatePanel
from lispac.gui.window.actions import ALL_ACTIONS
from lispac.gui.window.actions import MENUS as WINDOW_MENUS
from lispac.installation_paths import resource_path
from lispac.io.format_types import FileFormat, FormatOption
from lispac.io.formats import ACCURACY_FORMATS, POINT_FORMATS, TRAJECTORY_FORMATS
from lispac.language import LANGUAGES, Advised, Template, current_language, gettext
from lispac.message_texts import TOPIC_MODULES, message_text
from lispac.message_texts.occasions import OCCASIONS
from lispac.survey.conventions.systems import STATUS_WORDS, SYSTEMS
from tests.support import point_files, trajectory_files
from tests.support.french_catalogue import FRENCH
from tests.support.message_calls import is_part, message_levels

WORDS = {
    "en": ("Field", "Unit, range, choices", "What it is", "{} to {}", "Option", "Choices", "usual"),
    "fr": ("Champ", "Unité, étendue, choix", "Ce que c'est", "de {} à {}", "Option", "Choix",
           "habituel"),
}  # fmt: skip
STANDARD_KEYS = {
    Keys.New: "Ctrl+N", Keys.Open: "Ctrl+O", Keys.Save: "Ctrl+S",
    Keys.SaveAs: "Ctrl+Shift+S", Keys.Quit: "Ctrl+Q", Keys.Undo: "Ctrl+Z",
}  # fmt: skip
"""Shortcuts that depend on the desktop, with their usual keys."""
MENUS = {"en": ("Entry", "Keys", "What it does"), "fr": ("Entrée", "Touches", "Ce qu'elle fait")}
ASSUMED = {
    "en": "Assumed of a usual file without options:",
    "fr": "Supposé d'un fichier habituel, sans options :",
}
PROGRAMS = {
    "en": ("X, Y, Z:", "Angles:", "Product:", "Status:", "Source:", "Assumed:"),
    "fr": ("X, Y, Z :", "Angles :", "Produit :", "État :", "Source :", "Supposé :"),
}
MESSAGES = {
    "en": ("Code", "Level", "When it appears", "English", "French"),
    "fr": ("Code", "Niveau", "Quand il apparaît", "Anglais", "Français"),
}
LANGUAGE_COLUMNS = ("en", "fr")
TOPIC_TITLES = {
    "adjustment": ("Adjustment", "Compensation"),
    "adjustment_warnings": (
        "Warnings about targets and the adjustment",
        "Avertissements sur les cibles et la compensation",
    ),
    "calibration": (
        "Picking targets and estimating the boresight",
        "Désignation des cibles et estimation des angles de visée",
    ),
    "checking": ("Validation and patch test", "Validation et patch test"),
    "control": ("Surveyed control", "Points d’appui"),
    "commands": (
        "Command line, scripts, window and report",
        "Ligne de commande, scripts, fenêtre et rapport",
    ),
    "conventions": ("Conventions of other programs", "Conventions d'autres logiciels"),
    "file_checks": ("Checks of input files", "Contrôles des fichiers d'entrée"),
    "file_contents": (
        "Contents of input files and input assumptions",
        "Contenu des fichiers d'entrée et hypothèses de lecture",
    ),
    "importing": ("Files of a survey and their points", "Fichiers d'un levé et leurs points"),
    "importing_steps": ("Import of lines", "Importation des lignes"),
    "items": ("Quantities and items within messages", "Grandeurs et éléments dans les messages"),
    "output": ("Export and reports", "Exportation et rapports"),
    "planning": ("Survey planning and simulation", "Préparation et simulation d'un levé"),
    "planning_steps": (
        "Survey plans, simulations and computer clusters",
        "Projets de levé, simulations et grappes d'ordinateurs",
    ),
    "point_files": (
        "Files that cannot be read or written, and point files",
        "Fichiers illisibles ou impossibles à écrire, et fichiers de points",
    ),
    "program": ("Program and its folders", "Programme et ses dossiers"),
    "project_warnings": ("Warnings about an open project", "Avertissements sur un projet ouvert"),
    "projects": ("Projects, settings and targets", "Projets, réglages et cibles"),
    "report_warnings": ("Warnings in a report", "Avertissements d'un rapport"),
    "settings_files": ("TOML and JSON files", "Fichiers TOML et JSON"),
    "store": ("Imported lines in the project folder", "Lignes importées dans le dossier du projet"),
    "survey": ("Coordinate systems, times and points", "Systèmes de coordonnées, temps et points"),
    "targets": ("Search for targets and their quality", "Recherche des cibles et leur qualité"),
    "text_files": (
        "Text files, lists of coordinates, static scans and plane files",
        "Fichiers texte, listes de coordonnées, balayages statiques et fichiers de plans",
    ),
    "trajectories": ("Trajectory files", "Fichiers de trajectoire"),
    "workflow": (
        "Projects, checks, history and sensors",
        "Projets, contrôles, historique et capteurs",
    ),
}
"""English and French title of each topic of messages, by the name of its module."""
PANELS: dict[str, Callable[[], QWidget]] = {
    "data": DataPanel, "targets": TargetsPanel, "adjust": AdjustPanel, "validate": ValidatePanel,
    "histograms": HistogramsPanel, "report": ReportPanel, "convention": ConventionPanel,
}  # fmt: skip
FIELDS = (QAbstractSpinBox, QComboBox, QAbstractButton, QLineEdit)
MAX_CHOICES = 6
"""Maximum number of choices of a field that are listed; longer lists come from a library."""
COMMON_POINT_OPTIONS = tuple(
    option
    for option in POINT_FORMATS[0].options
    if all(option in each.options for each in POINT_FORMATS)
)
"""Options that all point formats have."""


def tables(language: str) -> dict[str, str]:
    """Text of each table by the name of its file."""
    set_language(language)
    try:
        made = {f"{name}.md": _fields(make(), language) for name, make in PANELS.items()}
        with tempfile.TemporaryDirectory() as scratch:
            settings = AppSettings(Path(scratch) / "settings.ini")
            made["import.md"] = _fields(ImportDialog(settings), language)
            made["settings.md"] = _fields(
                SettingsDialog(Preferences(cache=Path(scratch)), Path(scratch)), language
            )
        made["menus.md"] = _menus(language)
        made["keys.md"] = _keys(language)
        kinds = (
            ("trajectories", TRAJECTORY_FORMATS),
            ("accuracies", ACCURACY_FORMATS),
            ("points", POINT_FORMATS),
        )
        with tempfile.TemporaryDirectory() as scratch:
            files = _samples(Path(scratch))
            for name, formats in kinds:
                parts = [_format(each, files[each.key], language) for each in formats]
                made[f"{name}.md"] = "\n".join(parts)
        made["programs.md"] = _programs(language)
        made["points-shared.md"] = _options(list(COMMON_POINT_OPTIONS), language)
        made["messages.md"] = _messages(language)
    finally:
        set_language("en")
    return made


def _table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    lines = [head, tuple("---" for _ in head), *rows]
    return "".join(f"| {' | '.join(_cell(cell) for cell in line)} |\n" for line in lines)


def _cell(text: str) -> str:
    bare = re.sub(r"[ \t\n]+", " ", re.sub(r"<[^>]+>", "", text)).strip(" ")
    return bare.replace("|", r"\|").replace("*", r"\*").replace("<", "&lt;")


# -- panels --------------------------------------------------------------------------------------


def _fields(panel: QWidget, language: str) -> str:
    rows = list(dict.fromkeys(_rows(panel, language)))
    panel.close()
    panel.deleteLater()
    return _table(WORDS[language][:3], rows)


def _rows(panel: QWidget, language: str) -> Iterator[tuple[str, ...]]:
    labels = _labels(panel)
    for field in panel.findChildren(QWidget):
        if not isinstance(field, FIELDS) or isinstance(field.parent(), FIELDS):
            continue
        tip = field.toolTip()
        name = _name(field, labels)
        if tip and name and tip != name:
            yield name, _range(field, language), tip


def _name(field: QWidget, labels: dict[QWidget, str]) -> str:
    if isinstance(field, QAbstractButton) and field.text():
        return re.sub(r"\s*(⏎|Esc|Échap)$", "", field.text().replace("&", "")).strip()
    holder: QWidget | None = field
    alone = re.split(r"[:,(]", field.accessibleName())[0].strip()
    while holder is not None:
        if holder in labels:
            row = [each for each in labels if labels[each] == labels[holder]]
            many = len(row) > 1 or len(holder.findChildren(QDoubleSpinBox)) > 1
            return alone if many and alone else labels[holder]
        holder = holder.parentWidget()
    return alone


def _labels(panel: QWidget) -> dict[QWidget, str]:
    """Labels of a form by their widgets."""
    found: dict[QWidget, str] = {}
    for form in panel.findChildren(QFormLayout):
        for row in range(form.rowCount()):
            label = form.itemAt(row, QFormLayout.ItemRole.LabelRole)
            item = form.itemAt(row, QFormLayout.ItemRole.FieldRole)
            if label is None or item is None or label.widget() is None:
                continue
            inside = item.layout()
            items = (
                [item.widget()]
                if inside is None
                else [inside.itemAt(k).widget() for k in range(inside.count())]
            )
            found |= {each: label.widget().text() for each in items if each is not None}
    return {widget: text.replace("&", "").strip() for widget, text in found.items()}


def _range(field: QWidget, language: str) -> str:
    if isinstance(field, QDoubleSpinBox):
        ends = [f"{value:,.10g}" for value in (field.minimum(), field.maximum())]
        if language == "fr":
            ends = [each.replace(",", "\xa0").replace(".", ",") for each in ends]
        text = WORDS[language][3].format(*ends).replace("-", "−")
        return f"{text}\xa0{field.suffix().strip()}".replace(" ", "\xa0").strip()
    if isinstance(field, QComboBox):
        items = [field.itemText(k) for k in range(field.count())]
        return "; ".join(items) if len(items) <= MAX_CHOICES else ""
    return ""


# -- menus and keys ------------------------------------------------------------------------------


def _menus(language: str) -> str:
    parts = []
    for name, menu in WINDOW_MENUS.items():
        if not menu.menu:
            rows = list(_entries(name, ""))
            parts.append(f"### {_bare(gettext(menu.title))}\n\n{_table(MENUS[language], rows)}")
    return "\n".join(parts)


def _entries(menu: str, under: str) -> Iterator[tuple[str, ...]]:
    for name in chain.from_iterable(menu_groups(menu, ALL_ACTIONS, WINDOW_MENUS)):
        if name in WINDOW_MENUS:
            yield from _entries(name, f"{under}{_bare(gettext(WINDOW_MENUS[name].title))} > ")
        else:
            keys = ALL_ACTIONS[name].keys
            text, tip = ALL_ACTIONS[name].texts
            first = keys[0] if isinstance(keys, tuple) else keys
            shown = STANDARD_KEYS.get(first, first)
            shown = shown.replace("Shift", "Maj") if current_language() == "fr" else shown
            yield f"{under}{_bare(text)}", shown, tip


def _bare(text: str) -> str:
    return text.replace("&", "")


def _keys(language: str) -> str:
    parts = []
    for title, rows in KEYS:
        described = [(keys_text(keys), gettext(what)) for keys, what in rows]
        parts.append(f"### {gettext(title)}\n\n{_table(MENUS[language][1:], described)}")
    return "\n".join(parts)


# -- formats -------------------------------------------------------------------------------------


def _samples(folder: Path) -> dict[str, Path]:
    """Write a valid file of each format; returns the paths by the key of the format."""
    found = {key: write(folder / key) for key, write in trajectory_files.VALID_FILES.items()}
    for name, (key, write) in point_files.VALID_FILES.items():
        if key not in found:
            found[key] = write(folder / name)
    columns = found["ascii-trajectory"]
    names = "Time Lat(deg) Lon(deg) H Roll Pitch Heading\n"
    columns.write_text(names + columns.read_text(encoding="utf-8"), encoding="utf-8")
    return found


def _format(format: FileFormat, file: Path, language: str) -> str:
    endings = ", ".join(f"`{each}`" for each in format.endings)
    text = f"### {message_text(format.name)}\n\n`{format.key}`{' · ' if endings else ''}{endings}\n"
    texts = [message_text(each) for each in format.preview(file, {}).assumptions]
    if texts:
        text += f"\n{ASSUMED[language]}\n\n" + "".join(f"- {_cell(each)}\n" for each in texts)
    own = [option for option in format.options if option not in COMMON_POINT_OPTIONS]
    return f"{text}\n{_options(own, language)}" if own else text


def _options(options: list[FormatOption], language: str) -> str:
    words = WORDS[language]
    rows = []
    for option in options:
        choices = ", ".join(f"`{each}`" for each in option.choices if each)
        colon = "\xa0: " if language == "fr" else ": "
        usual = f" ({words[6]}{colon}`{option.default}`)" if option.default else ""
        rows.append((f"`{option.name}`", f"{choices}{usual}".strip(), gettext(option.meaning)))
    return _table((words[4], words[5], words[2]), rows)


# -- conventions of other programs ---------------------------------------------------------------


def _programs(language: str) -> str:
    heads = PROGRAMS[language]
    parts = []
    for system in SYSTEMS:
        angles = ", ".join(f"{gettext(turn.name)} {gettext(turn.meaning)}" for turn in system.turns)
        order = " · ".join(f"R{'xyz'[system.turns[k].axis]}" for k in system.order)
        values = (
            ", ".join(gettext(each) for each in system.axes), angles, order,
            gettext(STATUS_WORDS[system.status]), gettext(system.source),
            gettext(system.assumption),
        )  # fmt: skip
        lines = [
            f"- {head} {_cell(value)}" for head, value in zip(heads, values, strict=True) if value
        ]
        parts.append(f"### {_cell(gettext(system.name))}\n\n" + "\n".join(lines) + "\n")
    return "\n".join(parts)


def _messages(language: str) -> str:
    """Every message code by its topic, with its levels and its texts, placeholders in brackets."""
    levels = message_levels()
    parts = []
    for topic in TOPIC_MODULES:
        rows = [
            (
                f"`{code}`",
                "part" if is_part(code) else ", ".join(sorted(levels[code])),
                gettext(OCCASIONS[code.partition(".")[0]]),
                *_shown(template),
            )
            for code, template in sorted(topic.TEXTS.items())
        ]
        title = TOPIC_TITLES[topic.__name__.rpartition(".")[2]][LANGUAGE_COLUMNS.index(language)]
        parts.append(f"## {title}\n\n{_table(MESSAGES[language], rows)}")
    return "\n".join(parts)


def _shown(template: Template) -> tuple[str, ...]:
    """The text in every language; the plural form if there are several forms."""
    parts = (template.statement, template.advice) if isinstance(template, Advised) else (template,)
    english = [each if isinstance(each, str) else each.plural for each in parts]
    texts = " ".join(english), " ".join(FRENCH[each] for each in english)
    return tuple(re.sub(r"\{(\w+)[^}]*\}", r"[\1]", each) for each in texts)


def folder(language: str) -> Path:
    """Folder of the tables of a language."""
    return resource_path("manual") / language / "tables"


def main() -> None:
    """Write all tables."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    application = QApplication(sys.argv[:1])
    for language in LANGUAGES:
        folder(language).mkdir(exist_ok=True)
        for name, text in tables(language).items():
            (folder(language) / name).write_text(text, encoding="utf-8")
    application.quit()
