"""Units in column titles of files: one table for all readers."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from lispac.messages import Message, note

Kind = Literal["length", "angle", "time", "notation"]


@dataclass(frozen=True)
class Unit:
    """A unit of measurement, or a notation of numbers.

    Attributes
    ----------
    kind : {"length", "angle", "time", "notation"}
    si : float
        Metres, radians or seconds in the unit; for a notation, in the unit of the parsed number.
    name : Message
    """

    kind: Kind
    si: float
    name: Message


INTERNATIONAL_FOOT_M, US_SURVEY_FOOT_M = 0.3048, 1200 / 3937
"""Metres in a foot."""
_FULL_TURN_RAD = 2 * np.pi
UNITS = {
    "m": Unit("length", 1.0, note("unit.metres")),
    "km": Unit("length", 1000.0, note("unit.kilometres")),
    "cm": Unit("length", 0.01, note("unit.centimetres")),
    "mm": Unit("length", 0.001, note("unit.millimetres")),
    "ft": Unit("length", INTERNATIONAL_FOOT_M, note("unit.feet")),
    "int-ft": Unit("length", INTERNATIONAL_FOOT_M, note("unit.feet")),
    "us-ft": Unit("length", US_SURVEY_FOOT_M, note("unit.us_survey_feet")),
    "in": Unit("length", INTERNATIONAL_FOOT_M / 12, note("unit.inches")),
    "yd": Unit("length", 3 * INTERNATIONAL_FOOT_M, note("unit.yards")),
    "fathom": Unit("length", 6 * INTERNATIONAL_FOOT_M, note("unit.fathoms")),
    "rad": Unit("angle", 1.0, note("unit.radians")),
    "mrad": Unit("angle", 0.001, note("unit.milliradians")),
    "deg": Unit("angle", _FULL_TURN_RAD / 360, note("unit.degrees")),
    "gon": Unit("angle", _FULL_TURN_RAD / 400, note("unit.gons")),
    "arcmin": Unit("angle", _FULL_TURN_RAD / 360 / 60, note("unit.arc_minutes")),
    "arcsec": Unit("angle", _FULL_TURN_RAD / 360 / 3600, note("unit.arc_seconds")),
    "dms": Unit("notation", _FULL_TURN_RAD / 360, note("unit.dms")),
    "ddmm": Unit("notation", _FULL_TURN_RAD / 360, note("unit.ddmm")),
    "s": Unit("time", 1.0, note("unit.seconds")),
    "ms": Unit("time", 1e-3, note("unit.milliseconds")),
    "us": Unit("time", 1e-6, note("unit.microseconds")),
    "ns": Unit("time", 1e-9, note("unit.nanoseconds")),
    "min": Unit("time", 60.0, note("unit.minutes")),
    "h": Unit("time", 3600.0, note("unit.hours")),
    "clock": Unit("notation", 1.0, note("unit.clock")),
    "date": Unit("notation", 1.0, note("unit.date")),
}
"""Units by their code; ``ft`` are feet of unspecified kind."""
METRES_PER_UNIT = {code: unit.si for code, unit in UNITS.items() if unit.kind == "length"}
"""Metres in each unit of length by its code."""
LENGTH_UNIT_NAMES = {unit.si: unit.name for unit in UNITS.values() if unit.kind == "length"}
"""Names of the units of length by the metres in them."""
TIME_UNIT_NAMES = {unit.si: unit.name for unit in UNITS.values() if unit.kind == "time"}
"""Names of the units of time by the seconds in them."""
ANGLE_UNIT_CODES = tuple(
    code for code, unit in UNITS.items() if unit.kind == "angle" or code in ("dms", "ddmm")
)
UNKNOWN = "?"
"""Code of a unit that is given but not known, and of an ambiguous direction."""

_UNIT_PATTERNS = (
    (r"hh\W*mm|\bh ?m ?s\b", "clock"),
    (r"yyyy\W*mm", "date"),
    (r"arc.?min", "arcmin"),
    (r"arc.?sec", "arcsec"),
    (r"degr?[ée]?s?\W+min|\bd ?m ?s\b", "dms"),
    (r"\bddd?mm", "ddmm"),
    (r"\bgons?\b|\bgrades\b", "gon"),
    (r"\bgrads?\b|\bgrd\b", UNKNOWN),  # gon in English and French, degree in German
    (r"milli.?rad|\bmrad", "mrad"),
    (r"deg|°|\bdd\b", "deg"),
    (r"rad", "rad"),
    (r"survey[\s_-]*(feet|foot|ft)|\bu\.?s\.?[\s_-]*(feet|foot|ft)\b", "us-ft"),
    (r"\bft[\s_-]*\(?us\b|\bsft\b", "us-ft"),
    (r"\bint\w*\.?[\s_-]*(feet|foot|ft)\b|\bift\b|\bft[\s_-]*\(?int", "int-ft"),
    (r"\bfeet\b|\bfoot\b|\bft\b|\bpieds?\b|\bfu(ß|ss)\b", "ft"),
    (r"kilom[eè]t|\bkm\b", "km"),
    (r"centim[eè]t|\bcm\b", "cm"),
    (r"millim[eè]t|\bmm\b", "mm"),
    (r"\binch(es)?\b|^in\.?$", "in"),
    (r"\byards?\b|\byds?\b", "yd"),
    (r"\bfathoms?\b|\bftm\b|\bbrasses?\b", "fathom"),
    (r"m[eè]t(er|re)|\bm\b", "m"),
    (r"milli.?se[ck]|\bmse?c?\b", "ms"),
    (r"micro.?se[ck]|\b[uµμ]se?c?\b", "us"),
    (r"nano.?se[ck]|\bnse?c?\b", "ns"),
    (r"second|sekund|\bse[ck]s?\b|\bs\b", "s"),
    (r"^min(ute)?s?\.?$", "min"),
    (r"^h(ou)?rs?\.?$|^h$|^heures?$|^stunden?$", "h"),
)
"""Patterns of unit descriptions with the unit codes, in the order in which they are tried."""
_QUALIFIERS = re.compile(
    r"(true|grid|mag|wgs|nad|itrf|etrs|rgf|ellips|geoid|ortho|msl|navd|egm|utm|local|lidar|scan|body"
    r"|imu|ins|ref|vessel|frame|utc|gps|tai|unix|tow|sow|week|north|east|south|west|nord|sud|süd|est"
    r"|ost|ouest|up|down|raw|filt|pos|neg|bow|nose|port|star|left|right)\w*|[nsewxyzud]|[+-]|",
    re.IGNORECASE,
)
"""Qualifiers in brackets after a name that are not units."""

_UNIT_IN_BRACKETS = re.compile(r"\s*_?[\[({<]\s*([^\])}>]*?)\s*[\])}>]\s*$")
_UNIT_SUFFIX = re.compile(
    r"(?:_+|\s+|-)(deg(?:rees?)?|m?rad|gon|dms|m|km|cm|mm|(?:us|i)?ft|ft_?us|feet|s|secs?|ms|us|ns"
    r"|metres|meters|seconds)$",
    re.IGNORECASE,
)
_UNIT_IN_CAMEL_CASE = re.compile(r"(?<=[a-z])(Deg|Rad|DMS|M|Ft)$")
"""Pattern of a unit at the end of a title in camel case, such as ``LatDeg``."""


def split_title(title: str) -> tuple[str, str]:
    """Split a column title into name and unit: ``Height (ft)``, ``roll_deg``, ``LatDeg``."""
    text = title.strip()
    for form in (_UNIT_IN_BRACKETS, _UNIT_SUFFIX, _UNIT_IN_CAMEL_CASE):
        mark = form.search(text)
        if mark and mark.start() > 0:
            return re.sub(r"[\s_]+(in)?$", "", text[: mark.start()]), mark[1]
    return text, ""


def parse_unit(words: str) -> str:
    """Code of the unit in a description; empty if there is none."""
    return next(
        (code for form, code in _UNIT_PATTERNS if re.search(form, words.strip().lower())), ""
    )


def title_unit(title: str) -> str:
    """Code of the unit in a column title; empty without a unit, `UNKNOWN` for an unknown one."""
    words = split_title(title)[1]
    if code := _unit_before_direction(words):
        return code
    return "" if all(map(_QUALIFIERS.fullmatch, re.split(r"[\s,;/._]+", words))) else UNKNOWN


def _unit_before_direction(words: str) -> str:
    """Code of a unit that may be followed by a direction: in ``deg S`` the S means south."""
    head, _, last = words.rpartition(" ")
    return (parse_unit(head) if _parse_direction(last) else "") or parse_unit(words)


_DIRECTION_WORDS = {
    "west": ("w", "west", "ouest"),
    "south": ("s", "south", "sud", "süd", "sued"),
    "east": ("e", "east", "est", "ost"),
    "north": ("n", "north", "nord"),
    UNKNOWN: ("o",),  # ouest in French, Ost in German
}


def _parse_direction(word: str) -> str:
    bare = word.lower().strip("()[]{}.,+-")
    return next((name for name, words in _DIRECTION_WORDS.items() if bare in words), "")


def direction_of(title: str) -> str:
    """Positive direction of a column of longitudes or latitudes, from its title.

    Returns
    -------
    {"north", "south", "east", "west", `UNKNOWN`, ""}
        Empty if the title gives no direction.
    """
    name, words = split_title(title)
    for word in reversed(re.split(r"[\s,;/_+]+", words)):
        if found := _parse_direction(word):
            return found
    parts = re.split(r"[\s_.-]+", name)
    for word in (parts[-1], parts[0]) if len(parts) > 1 else ():
        if (found := _parse_direction(word)) and word.lower() not in ("s", "n", "e"):
            return found
    camel = re.search(r"(?<=[a-z])(West|South|Ouest|Sud|W|S)$", name)
    return _parse_direction(camel[1]) if camel else ""


def is_units_row(fields: Sequence[str]) -> bool:
    """True if the fields of a row are units, as in a row below the column names."""
    if any(map(_is_title_with_unit, fields)):
        return False
    unit_texts = [field.strip(" []()") for field in fields]
    known = [
        bool(_unit_before_direction(field)) for field in unit_texts if field not in NO_UNIT_TEXTS
    ]
    return len(known) >= 2 and all(known) and all(len(field) < 24 for field in unit_texts)


def _is_title_with_unit(field: str) -> bool:
    """True if a field is a column title with its unit: ``Time [s]``, but not ``US ft``."""
    name, unit = split_title(field)
    return bool(unit) and not parse_unit(name) and _WORDS_OF_UNIT.fullmatch(name.lower()) is None


_WORDS_OF_UNIT = re.compile(
    r"\W*|(u\.?s\.?|int\w*|arc|decimal|milli|micro|nano|survey|gps|utc|geodetic|ellipsoid\w*)\W*"
)
"""Pattern of words before a unit that belong to the unit and are not column names."""
NO_UNIT_TEXTS = ("", "-", "--", "none", "n/a", "1")
"""Texts in a row of units below columns without a unit."""


def titles_with_units(names: Sequence[str], units: Sequence[str]) -> list[str]:
    """Column titles from a row of names and the row of units below it."""
    unit_texts = [unit.strip(" []()") for unit in units]
    return [
        name if unit in NO_UNIT_TEXTS else f"{name} [{unit}]"
        for name, unit in zip(names, unit_texts, strict=True)
    ]
