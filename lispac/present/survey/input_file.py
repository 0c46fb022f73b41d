"""Contents of an input file and options of its reading, as values, facts and texts.

Field names of `FormatCheckValues` are the keys of ``formats`` in the JSON of `lispac inspect`.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from lispac.language import N_, gettext
from lispac.message_texts import fact_text, message_text
from lispac.messages import Message
from lispac.present.tables import Fact
from lispac.survey.known_time_base import base_message
from lispac.survey.time_base import TIME_BASE_KEYS, base_of_key

FileContents = Mapping[str, str | int | Message]
"""Facts about the content of a file by their keys, as the readers of the formats find them."""

OPTION_LABELS: Mapping[str, str] = {
    "attitude": N_("Unit of attitude"),
    "axes": N_("Axes"),
    "byte_order": N_("Byte order"),
    "columns": N_("Columns"),
    "crs": N_("Coordinate system"),
    "decimal": N_("Decimal separator"),
    "epoch": N_("Epoch"),
    "exclude_classes": N_("Excluded classes"),
    "frame": N_("Frame"),
    "grid_unit": N_("Unit of grid coordinates"),
    "header": N_("Header"),
    "heading": N_("Heading"),
    "height": N_("Height"),
    "height_unit": N_("Unit of heights"),
    "heights": N_("Unit of heights"),
    "hour_from": N_("Source of the full hour"),
    "max_range": N_("Maximum range (m)"),
    "only": N_("Attribute filter"),
    "order": N_("Coordinate order"),
    "origin": N_("Origin"),
    "pitch": N_("Pitch"),
    "position": N_("Unit of latitude and longitude"),
    "roll": N_("Roll"),
    "separator": N_("Column separator"),
    "time": N_("Time"),
    "time_base": N_("Time base"),
    "time_field": N_("Time field"),
    "time_rollover": N_("Time rollover (midnight or week)"),
    "time_from": N_("Time origin"),
    "time_unit": N_("Time unit"),
    "trajectory_datum": N_("Trajectory datum"),
    "unit": N_("Unit"),
    "withheld": N_("Withheld points"),
}
"""Labels of the options."""
FACT_LABELS: Mapping[str, str] = {
    "attributes": N_("Attributes"),
    "columns": N_("Columns"),
    "Columns": N_("Columns"),
    "comments": N_("Comments"),
    "coordinate system": N_("Coordinate system"),
    "Datum": N_("Datum"),
    "Date of mission": N_("Date of the survey"),
    "decimal": N_("Decimal separator"),
    "Duration": N_("Duration"),
    "End": N_("End"),
    "fields": N_("Fields"),
    "format": N_("Format"),
    "frame": N_("Frame"),
    "Header": N_("Header"),
    "Height": N_("Height"),
    "Latitude": N_("Latitude"),
    "Longitude": N_("Longitude"),
    "Made from": N_("Source file"),
    "Mapping frame": N_("Map projection frame"),
    "points": N_("Points"),
    "Position north": N_("Position north"),
    "Position west": N_("Position west"),
    "Position up": N_("Position up"),
    "Rate": N_("Rate"),
    "Records": N_("Records"),
    "resolution": N_("Resolution"),
    "returns": N_("Returns"),
    "Roll and pitch": N_("Roll and pitch"),
    "Rows": N_("Rows"),
    "separator": N_("Column separator"),
    "Sigma north": N_("Standard deviation north"),
    "Sigma east": N_("Standard deviation east"),
    "Sigma height": N_("Standard deviation of height"),
    "Sigma roll": N_("Standard deviation of roll"),
    "Sigma pitch": N_("Standard deviation of pitch"),
    "Sigma heading": N_("Standard deviation of heading"),
    "Sign of roll": N_("Sign of roll"),
    "Sign of pitch": N_("Sign of pitch"),
    "Speed": N_("Speed"),
    "Start": N_("Start"),
    "time base": N_("Time base"),
    "time from, to": N_("Time"),
    "unit": N_("Unit"),
    "Velocities": N_("Velocities"),
    "viewpoint": N_("Scanner viewpoint"),
    "Wander angle": N_("Wander angle"),
    "written by": N_("Written by software"),
    "x from, to": N_("X"),
    "y from, to": N_("Y"),
    "z from, to": N_("Z"),
}
"""Labels of the facts about a file."""
EMPTY_VALUE_TEXTS: Mapping[str, str] = {
    "time_rollover": N_("automatic"),
    "hour_from": N_("automatic"),
    "grid_unit": N_("same as the coordinate system"),
    "heights": N_("same as the coordinate system"),
}
"""Texts of an empty value, for options whose default is not the value in the file."""
OPTION_VALUE_TEXTS: Mapping[tuple[str, str], str] = {
    ("time_rollover", "none"): N_("none"),
    ("frame", "scanner"): N_("Scanner"),
    ("axes", "unknown"): N_("unknown"),
    ("header", "auto"): N_("automatic"),
    ("hour_from", "gprmc"): N_("GPRMC"),
    ("hour_from", "capture"): N_("recording computer"),
    ("hour_from", "trajectory"): N_("trajectory"),
}
"""Texts of values that differ between options, by option and value."""
VALUE_TEXTS: Mapping[str, str] = {
    "as-is": N_("as in the file"),
    "auto": N_("automatic"),
    "big-endian": N_("big-endian"),
    "blank": N_("space"),
    "bow-down": N_("positive with bow down"),
    "bow-up": N_("positive with bow up"),
    "centimetre": N_("centimetres"),
    "comma": N_("comma (,)"),
    "degrees": N_("degrees"),
    "degrees-minutes": N_("degrees and minutes"),
    "dms": N_("degrees, minutes, seconds"),
    "enu": N_("east, north, up"),
    "exclude": N_("exclude"),
    "fathom": N_("fathoms"),
    "feet": N_("feet"),
    "foot": N_("feet"),
    "full-hour": N_("at every full hour"),
    "georeferenced": N_("Georeferenced"),
    "grid": N_("grid north"),
    "header": N_("as in the header"),
    "hour": N_("hours"),
    "inch": N_("inches"),
    "international-feet": N_("international feet"),
    "keep": N_("include"),
    "kilometre": N_("kilometres"),
    "latitude-longitude": N_("latitude, longitude"),
    "little-endian": N_("little-endian"),
    "longitude-latitude": N_("longitude, latitude"),
    "metre": N_("metres"),
    "metres": N_("metres"),
    "microsecond": N_("microseconds"),
    "midnight": N_("at midnight"),
    "millimetre": N_("millimetres"),
    "millisecond": N_("milliseconds"),
    "minus-wander": N_("subtract the wander angle"),
    "minute": N_("minutes"),
    "nanosecond": N_("nanoseconds"),
    "ned": N_("north, east, down"),
    "neu": N_("north, east, up"),
    "nwu": N_("north, west, up"),
    "point": N_("point (.)"),
    "port-down": N_("positive with port side down"),
    "radians": N_("radians"),
    "second": N_("seconds"),
    "semicolon": N_("semicolon (;)"),
    "starboard-down": N_("positive with starboard side down"),
    "start": N_("start of the scan"),
    "tab": N_("tab"),
    "true": N_("true north"),
    "us-survey-feet": N_("US survey feet"),
    "us-survey-foot": N_("US survey feet"),
    "wander-ned": N_("north, east, down, rotated by the wander angle"),
    "wander-nwu": N_("north, west, up, rotated by the wander angle"),
    "week-end": N_("at the end of the week"),
    "yard": N_("yards"),
    "zero": N_("zero"),
}
"""Texts of the values that are the same for all options."""


@dataclass(frozen=True)
class FormatCheckValues:
    """Result of the check of a file in one format; ``error`` is why it cannot be read, or None.

    ``facts`` are texts in English by their keys; ``options`` are the values used by the reader.
    """

    format: str
    name: str
    kind: Literal["trajectory", "accuracy", "points"]
    confidence: float
    error: Message | None
    facts: Mapping[str, str]
    options: Mapping[str, str]
    assumptions: tuple[Message, ...]
    messages: tuple[Message, ...]


def content_texts(contents: FileContents) -> dict[str, str]:
    """Texts of the facts about a file, by their keys."""
    return {name: fact_text(value) for name, value in contents.items()}


def content_facts(contents: FileContents) -> list[Fact]:
    """Facts about a file with their labels, in the language in use."""
    return [
        Fact(gettext(FACT_LABELS.get(name, name)), text)
        for name, text in content_texts(contents).items()
    ]


def option_name(name: str) -> str:
    """Label of an option, in the language in use."""
    return gettext(OPTION_LABELS.get(name, name))


def option_value(name: str, value: str) -> str:
    """Text of a value of an option, in the language in use."""
    if not value:
        return gettext(EMPTY_VALUE_TEXTS.get(name, "as in the file"))
    if (name, value) in OPTION_VALUE_TEXTS:
        return gettext(OPTION_VALUE_TEXTS[name, value])
    if value in TIME_BASE_KEYS:
        return message_text(base_message(base_of_key(value)))
    return gettext(VALUE_TEXTS[value]) if value in VALUE_TEXTS else value
