"""Columns of text files: possible meanings, missing ones, and remembered layouts."""

from collections.abc import Sequence

from lispac.io.format_types import FileFormat, FilePreview
from lispac.io.text.text_layout import REQUIRED_COLUMNS
from lispac.io.trajectory.ascii_trajectory import COLUMNS_ASSUMED_CODE
from lispac.io.trajectory.trajectory_columns import ROLES_BY_COLUMN_NAME, SIGMA_ROLES
from lispac.language import N_
from lispac.messages import Message, note
from lispac.workflow.importing.file_reading import FileCheck

UNUSED_COLUMN = "-"
"""Meaning of a column that is skipped."""
_POINT_MEANINGS = (*REQUIRED_COLUMNS, "intensity")
_TRAJECTORY_MEANINGS = (
    "time", "date", "latitude", "longitude", "easting", "northing", "height", "sea_height",
    "roll", "pitch", "heading",
)  # fmt: skip
"""Meanings of the columns of a trajectory, in the order in which they are offered."""
_MEANING_LABELS = {
    "time": N_("Time"),
    "date": N_("Date"),
    "x": N_("X"),
    "y": N_("Y"),
    "z": N_("Z"),
    "intensity": N_("Intensity"),
    "latitude": N_("Latitude"),
    "longitude": N_("Longitude"),
    "easting": N_("Easting"),
    "northing": N_("Northing"),
    "height": N_("Height (ellipsoid)"),
    "sea_height": N_("Height (sea level)"),
    "roll": N_("Roll"),
    "pitch": N_("Pitch"),
    "heading": N_("Heading"),
    UNUSED_COLUMN: N_("Skip"),
}


def has_columns(format: FileFormat) -> bool:
    """True if the user may choose the meaning of each column."""
    return any(option.name == "columns" for option in format.options)


def possible_meanings(format: FileFormat) -> tuple[str, ...]:
    """Possible meanings of a column, as values of the option; `UNUSED_COLUMN` comes first."""
    if format.kind == "points":
        return (UNUSED_COLUMN, *_POINT_MEANINGS)
    return (
        UNUSED_COLUMN,
        *(role for role in _TRAJECTORY_MEANINGS if role in set(ROLES_BY_COLUMN_NAME.values())),
    )


def meaning_label(meaning: str) -> str:
    """Label of a meaning for translation; a name from the file is returned unchanged."""
    return _MEANING_LABELS.get(meaning, meaning)


def column_meanings(format: FileFormat, finding: FilePreview | None, given: str) -> tuple[str, ...]:
    """Meaning of each column of the preview, from the left."""
    if finding is None or not finding.rows:
        return tuple(given.split())
    width = max(len(row) for row in finding.rows)
    named = given or str(finding.choice.get("columns", ""))
    tokens = [token.strip() or UNUSED_COLUMN for token in named.replace(",", " ").split()]
    tokens = tokens[:width] + [UNUSED_COLUMN] * (width - len(tokens))
    if format.kind == "trajectory":
        tokens = [
            token if token in SIGMA_ROLES else ROLES_BY_COLUMN_NAME.get(token, UNUSED_COLUMN)
            for token in tokens
        ]
    return tuple(tokens)


def with_meaning(tokens: Sequence[str], column: int, meaning: str) -> tuple[str, ...]:
    """Change the meaning of one column; another column with that meaning is then skipped."""
    changed = [
        UNUSED_COLUMN if token == meaning and meaning != UNUSED_COLUMN else token
        for token in tokens
    ]
    changed[column] = meaning
    return tuple(changed)


def missing_columns(format: FileFormat, tokens: Sequence[str]) -> tuple[Message, ...]:
    """Names of required meanings that are assigned to no column."""
    if not has_columns(format) or not tokens:
        return ()
    has = set(tokens)
    if format.kind == "points":
        missing = [name for name in REQUIRED_COLUMNS if name not in has]
    else:
        missing = [name for name in ("time", "roll", "pitch", "heading") if name not in has]
        if not ({"latitude", "longitude"} <= has or {"easting", "northing"} <= has):
            missing.append("position")
        if not {"height", "sea_height"} & has:
            missing.append("height")
    return tuple(note(_MEANING_NAME_CODES[name]) for name in missing)


_MEANING_NAME_CODES = {
    "time": "column.time", "x": "column.x", "y": "column.y", "z": "column.z",
    "position": "column.position", "height": "column.height", "roll": "column.roll",
    "pitch": "column.pitch", "heading": "column.heading",
}  # fmt: skip
"""Codes of the messages that name required meanings."""


def has_column_names(check: FileCheck) -> bool:
    """True if the file names its columns."""
    if check.finding is None:
        return False
    if check.format.kind == "points":
        return bool(check.finding.choice.get("columns"))
    return not any(each.code == COLUMNS_ASSUMED_CODE for each in check.finding.file_warnings)


def layout_key(check: FileCheck) -> str:
    """Key of the layout of a text file (format, number and names of columns); else empty."""
    if not has_columns(check.format) or check.finding is None or not check.finding.rows:
        return ""
    rows = check.finding.rows
    named = " ".join(rows[0]) if has_column_names(check) else ""
    return f"{check.format.key}/{max(len(row) for row in rows)}/{named}"
