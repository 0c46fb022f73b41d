"""Texts, numbers and dates in the language of the user.

Texts come from gettext catalogues (``resources/i18n/CODE/LC_MESSAGES/lispac.po``), keyed by the
English text; ``installer/catalogues.py`` extracts and compiles them with Babel. Babel formats
numbers, lists and dates.

Placeholders of a text are named and may have a format specification ``unit[.digits][+]``:

- ``n``: a count
- ``m``, ``mm``, ``km``, ``s``, ``ms``, ``h``, ``hz``: an SI value, converted to that unit; ``deg``:
  an angle in radians, converted to degrees; ``percent``: a ratio; ``mb``: a number of bytes in
  megabytes; ``x``: a number without a unit. Without a number of decimals, three significant digits
  are written, or all digits before the decimal sign if there are more; ``+`` also writes a plus
  sign, except before a number that is rounded to zero. A positive ratio that would be rounded to
  zero is written as less than the smallest number with these decimals: ``< 0.1``. Seconds have no
  separators between groups of three digits, as in the trajectory file. The unit itself
  is part of the text. The window may show ``m``, ``mm`` and, with three or more decimals, ``deg``
  in another unit (`use_units`); the sign after the number is then replaced. Headings and
  inclinations have fewer decimals and remain in degrees. ``|other`` at the end, as in
  ``{rms:mm.1|limit}``, adds decimals until the number differs from this parameter, unless both are
  equal: a value beyond its limit is never written like the limit.
- ``names``: names joined by commas and "and"; ``choices``: names joined by commas and "or";
  ``sentences``: sentences one after the other
- ``title``: the English title of a field, which is translated
- no specification: a name or another message, inserted unchanged
"""

import gettext as gnu
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from datetime import date, datetime
from decimal import Decimal
from functools import lru_cache
from math import degrees, floor, isfinite, log10
from pathlib import Path
from string import Formatter
from typing import Any, TypeVar

LANGUAGES: Mapping[str, str] = {"en": "English", "fr": "Français"}
"""Name of each language in the language itself, by its code."""

_LOCALES: Mapping[str, str] = {"en": "en_GB", "fr": "fr_FR"}
_UNIT_FACTORS: Mapping[str, float] = {
    "m": 1.0, "mm": 1e3, "km": 1e-3, "s": 1.0, "ms": 1e3, "h": 1 / 3600, "hz": 1.0,
    "deg": degrees(1.0), "percent": 100.0, "x": 1.0, "mb": 1e-6,
}  # fmt: skip
"""Factor from the SI value to the displayed unit, by the unit of a format specification."""
_SIGNIFICANT_DIGITS = 3
_MIN_PLAIN_NUMBER, _MAX_PLAIN_NUMBER = 1e-9, 1e15
"""Limits of the absolute value of numbers written without an exponent; the lower one applies only
if no number of decimals is given."""

LESS_THAN = "<\u00a0"
"""Sign before the upper limit of a share that is too small for its number of decimals."""
_UNIT_SIGNS: Mapping[str, re.Pattern[str]] = {
    "m": re.compile("[ \u00a0\u202f]?(?:m|metres|mètres)(?![\\w²³/])"),
    "mm": re.compile("[ \u00a0\u202f]?(?:mm|millimetres|millimètres)(?![\\w²³/])"),
    "deg": re.compile("[ \u00a0\u202f]?(?:deg\\b|°)"),
}
"""Sign of a unit after a number in a template, by the unit of the specification."""
_MIN_ANGLE_DECIMALS = 3
"""Smallest number of decimals of an angle that is shown in the unit of the user."""
MAX_FURTHER_DECIMALS = 9
"""Largest number of decimals that are added to show that two values differ."""
_OTHER_PARAMETER = re.compile(r"\|(\w+)}")
"""Name of the other parameter at the end of a specification."""
_SHOWN = "shown "
"""Beginning of the specification of a number that is shown in the unit of the user."""

_DEGREES_IN_TEXT = re.compile("(?:(?<=[}\\d])[ \u00a0]|^)deg\\b|(?<=\\()deg(?=\\))")
"""Abbreviation of degrees after a number in a template, alone, or in brackets."""

Value = TypeVar("Value")

_program_language = "en"
_block_language: ContextVar[str | None] = ContextVar("language", default=None)
_has_degree_signs: ContextVar[bool] = ContextVar("degree_signs", default=False)
_has_minus_signs: ContextVar[bool] = ContextVar("minus_signs", default=False)
_has_advice: ContextVar[bool] = ContextVar("advice", default=True)


@dataclass(frozen=True)
class ShownUnit:
    """Unit that is shown in texts instead of a standard unit.

    Attributes
    ----------
    sign : symbol written after a number
    factor : number of these units in one standard unit
    finer : number of decimals in addition to those in the standard unit
    """

    sign: str
    factor: float
    finer: int = 0


_shown_units: Mapping[str, ShownUnit] = {}


def use_units(shown_units: Mapping[str, ShownUnit]) -> None:
    """Set the units of lengths and angles in the texts of the program.

    Texts in a block of `in_language` (reports, JSON) always have standard units.

    Parameters
    ----------
    shown_units : mapping of {"m", "mm", "deg"} to ShownUnit
        Units that are not the standard ones.
    """
    global _shown_units
    _shown_units = dict(shown_units)
    _with_shown_units.cache_clear()


@dataclass(frozen=True)
class Plural:
    """English text in the singular and the plural; the parameter ``count`` selects the form."""

    singular: str
    plural: str


@dataclass(frozen=True)
class Advised:
    """English text of a statement, and of the action that it suggests to the user of the program.

    A report for other readers omits the action of a note (`without_advice`).
    """

    statement: str | Plural
    advice: str | Plural

    @property
    def singular(self) -> str:
        """Both texts, in the singular."""
        parts = (self.statement, self.advice)
        return " ".join(each if isinstance(each, str) else each.singular for each in parts)

    @property
    def plural(self) -> str:
        """Both texts, in the plural."""
        parts = (self.statement, self.advice)
        return " ".join(each if isinstance(each, str) else each.plural for each in parts)


Template = str | Plural | Advised


def use_language(code: str) -> None:
    """Set the language of the program.

    Raises
    ------
    ValueError
        If there is no such language.
    """
    global _program_language
    if code not in LANGUAGES:
        raise ValueError(f"no language {code!r}: choose one of {', '.join(LANGUAGES)}")
    _program_language = code


def current_language() -> str:
    """Code of the current language, such as ``en``."""
    return _block_language.get() or _program_language


@contextmanager
def _value_in_block(variable: ContextVar[Value], value: Value) -> Iterator[None]:
    """Set a variable in a block of code and in this thread only."""
    token = variable.set(value)
    try:
        yield
    finally:
        variable.reset(token)


@contextmanager
def in_language(code: str) -> Iterator[None]:
    """Use another language in a block of code and in this thread only.

    Raises
    ------
    ValueError
        If there is no such language.
    """
    if code not in LANGUAGES:
        raise ValueError(f"no language {code!r}: choose one of {', '.join(LANGUAGES)}")
    with _value_in_block(_block_language, code):
        yield


@contextmanager
def degree_signs() -> Iterator[None]:
    """Write ``67°`` instead of ``67 deg`` in a block of code and in this thread only.

    The English texts have the abbreviation, which every terminal can show.
    """
    with _value_in_block(_has_degree_signs, True):
        yield


@contextmanager
def minus_signs() -> Iterator[None]:
    """Write numbers in texts with a minus sign, not a hyphen, in a block and in this thread."""
    with _value_in_block(_has_minus_signs, True):
        yield


@contextmanager
def without_advice() -> Iterator[None]:
    """Write only the statements of `Advised` texts in a block of code and in this thread only."""
    with _value_in_block(_has_advice, False):
        yield


@contextmanager
def with_advice() -> Iterator[None]:
    """Write `Advised` texts completely, in a block within one of `without_advice`."""
    with _value_in_block(_has_advice, True):
        yield


def in_english(value: object) -> str:
    """Text of a message or an error in English, independent of the current language."""
    with in_language("en"):
        return str(value)


def N_(text: str) -> str:  # noqa: N802  (the name that gettext gives it)
    """Mark a text for extraction into the catalogues; it is translated when it is shown."""
    return text


@dataclass(frozen=True)
class LazyText:
    """Text that is translated each time it is converted by ``str(text)``.

    For texts that are kept when the language changes, such as the names of undo steps.
    """

    template: Template
    params: Mapping[str, Any] = field(default_factory=dict, hash=False)

    def __str__(self) -> str:
        """Text in the current language."""
        return format_text(self.template, self.params)


def gettext_lazy(template: Template, /, **params: Any) -> LazyText:
    """Text that is translated each time it is shown."""
    return LazyText(template, params)


def join_sentences(texts: Sequence[LazyText]) -> LazyText:
    """Join sentences into one text."""
    return LazyText("{texts:sentences}", {"texts": tuple(texts)})


def gettext(template: Template, /, **params: Any) -> str:
    """Translate a text and fill its placeholders.

    Parameters
    ----------
    template : str or Plural
        English text, as in the catalogue.
    **params
        Values of the placeholders in SI units. Without any, braces in the text are kept literally.
    """
    if not params and isinstance(template, str):
        return _translated(template, 0, current_language(), _has_degree_signs.get())
    return format_text(template, params)


def format_text(template: Template, params: Mapping[str, Any]) -> str:
    """Translate a text and fill its placeholders from a mapping."""
    if isinstance(template, Advised):
        parts = [template.statement, template.advice] if _has_advice.get() else [template.statement]
        return " ".join(format_text(each, params) for each in parts)
    count = int(params["count"]) if isinstance(template, Plural) else 0
    text = _translated(template, count, current_language(), _has_degree_signs.get())
    if not params:
        return text
    if _shown_units and _block_language.get() is None:
        text = _with_shown_units(text)
    return _FORMATTER.vformat(text, (), params)


@lru_cache(maxsize=8192)
def _translated(template: str | Plural, count: int, language: str, has_degree_signs: bool) -> str:
    """Text of the catalogue for a number of things, with its placeholders."""
    catalogue = _catalogue(language)
    if isinstance(template, Plural):
        text = catalogue.ngettext(template.singular, template.plural, count)
    else:
        text = catalogue.gettext(template) if template else ""
    text = _OTHER_PARAMETER.sub(r"|{\1}}", text)  # the formatter inserts its value
    return _DEGREES_IN_TEXT.sub("°", text) if has_degree_signs else text


def number(
    value: float, decimals: int | None = None, *, sign: bool = False, is_grouped: bool = True
) -> str:
    """Number formatted for the current language; three significant digits by default.

    Parameters
    ----------
    sign : whether positive numbers have a plus sign; a number rounded to zero has no sign
    is_grouped : whether groups of three digits are separated
    """
    value = value if isinstance(value, int) else float(value)
    if isinstance(value, float) and not isfinite(value):
        return f"{value:+g}" if sign else f"{value:g}"
    # Damaged files may contain huge numbers; Babel supports only 28 digits.
    if abs(value) >= _MAX_PLAIN_NUMBER or (decimals is None and 0 < abs(value) < _MIN_PLAIN_NUMBER):
        return f"{Decimal(value):{'+' if sign else ''}.{_SIGNIFICANT_DIGITS}g}"
    if decimals is None:
        decimals = _significant_decimals(value)
    whole = "#,##0" if is_grouped else "0"
    places = f"{whole}.{'0' * decimals}" if decimals else whole
    value = without_negative_zero(value, decimals)
    pattern = f"+{places};-{places}" if sign and value else places
    return _formatted_number(value, pattern, _LOCALES[current_language()])


def is_rounded_to_zero(value: float, decimals: int) -> bool:
    """Whether a positive value is zero with this number of decimals."""
    return value > 0.0 and not float(f"{value:.{decimals}f}")


def without_negative_zero(value: float, decimals: int) -> float:
    """Value, or 0.0 if it is zero with this number of decimals; zeros have no minus sign."""
    return value if float(f"{value:.{decimals}f}") else 0.0


def nonzero_decimals(decimals: int, *values: float) -> int:
    """Number of decimals, at most two more, with which small magnitudes are not written as zero."""
    further = range(decimals, decimals + 3)
    small = [abs(value) for value in values]
    return next((k for k in further if not any(is_rounded_to_zero(v, k) for v in small)), decimals)


def decimals_apart(value: float, other: float, decimals: int) -> int:
    """Number of decimals with which two magnitudes are written differently, unless they are equal.

    Small ones are not written as zero: see `nonzero_decimals`.

    Parameters
    ----------
    decimals : smallest number of decimals
    """
    decimals = nonzero_decimals(decimals, value, other)
    further = range(decimals, decimals + MAX_FURTHER_DECIMALS + 1)
    low, high = abs(value), abs(other)
    return next((k for k in further if f"{low:.{k}f}" != f"{high:.{k}f}"), decimals)


@lru_cache(maxsize=8192)
def _formatted_number(value: float, pattern: str, locale: str) -> str:
    """Number formatted by a pattern of Babel."""
    from babel.numbers import format_decimal

    return str(format_decimal(value, pattern, locale=locale))


def join_names(names: Sequence[str], *, choice: bool = False) -> str:
    """Join names as in a sentence: ``a, b and c``, or with ``choice``, ``a, b or c``."""
    from babel.lists import format_list

    locale = _LOCALES[current_language()]
    return format_list(list(names), style="or" if choice else "standard", locale=locale)


def join_items(texts: Iterable[str]) -> str:
    """Texts that may contain commas, joined by semicolons."""
    return ("; " if current_language() == "en" else "\u202f; ").join(texts)


def capitalised(text: str) -> str:
    """Text with the first letter in upper case and all others unchanged."""
    return text[:1].upper() + text[1:]


ASCII_REPLACEMENTS = {
    "\u2212": "-", "\u2013": "-", "\u03c3": "sigma", "\u00a0": " ", "\u00b1": "+/-", "\u00b2": "2",
    "(\u00b0": "(deg", "\u00b0": " deg",
}  # fmt: skip
"""ASCII texts for characters that some terminals cannot show, replaced in this order."""


def to_plain_text(text: str) -> str:
    """Text with the characters of `ASCII_REPLACEMENTS` replaced, for terminals that lack them."""
    for sign, words in ASCII_REPLACEMENTS.items():
        text = text.replace(sign, words)
    return text


def short_datetime(when: datetime) -> str:
    """Date and time of day, formatted for the current language."""
    from babel.dates import format_datetime

    if current_language() == "en":
        return f"{when:%Y-%m-%d %H:%M}"
    return format_datetime(when, "short", locale=_LOCALES[current_language()])


def short_date(day: date) -> str:
    """Date formatted for the current language."""
    from babel.dates import format_date

    if current_language() == "en":
        return day.isoformat()
    return format_date(day, "short", locale=_LOCALES[current_language()])


def duration_text(seconds: float) -> str:
    """Duration as a text: ``3 s``, ``2 min 10 s``, ``1 h 05 min``."""
    whole = max(1, round(seconds))
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02d} min"


class TextFormatter(Formatter):
    """Formatter of the placeholders in texts; the module describes the specifications."""

    def format_field(self, value: Any, format_spec: str) -> str:
        """Format one value by its specification.

        Raises
        ------
        ValueError
            If there is no such specification.
        """
        if format_spec in ("names", "choices"):
            names = [value] if isinstance(value, str) else value
            return join_names([str(each) for each in names], choice=format_spec == "choices")
        if format_spec == "sentences":
            return " ".join(map(str, value))
        if format_spec == "title":
            return gettext(str(value))
        if format_spec == "n":
            return number(int(value), 0)
        is_shown = format_spec.startswith(_SHOWN)
        format_spec, _, other = format_spec.removeprefix(_SHOWN).partition("|")
        unit, _, digits = format_spec.removesuffix("+").partition(".")
        if unit in _UNIT_FACTORS:
            factor, decimals = _UNIT_FACTORS[unit], int(digits) if digits else None
            if is_shown:
                shown = _shown_units[unit]
                factor *= shown.factor
                decimals = None if decimals is None else max(0, decimals + shown.finer)
            scaled = float(value) * factor
            if other and decimals is not None:
                decimals = decimals_apart(scaled, float(other) * factor, decimals)
            if unit == "percent" and decimals is not None and is_rounded_to_zero(scaled, decimals):
                return LESS_THAN + number(10.0**-decimals, decimals)
            # Times are written as in the trajectory file, to be searched for in it
            text = number(scaled, decimals, sign=format_spec.endswith("+"), is_grouped=unit != "s")
            return text.replace("-", "\N{MINUS SIGN}") if _has_minus_signs.get() else text
        if format_spec:
            raise ValueError(f"no format specification {format_spec!r}")
        return str(value)


_FORMATTER = TextFormatter()


@lru_cache
def _with_shown_units(template: str) -> str:
    """Template with the units of `use_units`: the specifications and the signs after the numbers.

    A number is converted if the sign of its unit follows, at once or after other numbers in the
    same unit: ``{low:m} to {high:m} m``.
    """
    literals, fields, specs = [], [], []
    for literal, name, spec, _ in _FORMATTER.parse(template):
        literals.append(literal.replace("{", "{{").replace("}", "}}"))
        fields.append(name)
        specs.append(spec or "")
    waiting: list[int] = []  # numbers in one unit whose sign has not been found yet
    for k, literal in enumerate(literals):
        if waiting and (sign := _UNIT_SIGNS[_unit_of(specs[waiting[0]])].match(literal)):
            shown = _shown_units[_unit_of(specs[waiting[0]])]
            space = "" if shown.sign in "°′″" else "\N{NO-BREAK SPACE}"
            literals[k] = f"{space}{shown.sign}{literal[sign.end() :]}"
            for number_index in waiting:
                specs[number_index] = f"{_SHOWN}{specs[number_index]}"
            waiting = []
        if not _is_convertible(specs[k]):
            waiting = []
        elif waiting and _unit_of(specs[k]) != _unit_of(specs[waiting[0]]):
            waiting = [k]
        else:
            waiting.append(k)
    return "".join(
        literal
        if name is None
        else f"{literal}{{{name}:{spec}}}"
        if spec
        else f"{literal}{{{name}}}"
        for literal, name, spec in zip(literals, fields, specs, strict=True)
    )


def _unit_of(spec: str) -> str:
    return spec.partition("|")[0].removesuffix("+").partition(".")[0]


def _is_convertible(spec: str) -> bool:
    """Whether a number with this specification may be shown in another unit."""
    unit, _, digits = spec.partition("|")[0].removesuffix("+").partition(".")
    if unit not in _shown_units:
        return False
    return unit != "deg" or (digits.isdigit() and int(digits) >= _MIN_ANGLE_DECIMALS)


@lru_cache
def _catalogue(code: str) -> gnu.NullTranslations:
    if code == "en":
        return gnu.NullTranslations()
    package = Path(__file__).parent
    # The resources are inside the package in a wheel, and beside it in a checkout.
    for folder in (package, package.parent):
        path = folder / "resources" / "i18n" / code / "LC_MESSAGES" / "lispac.mo"
        if path.exists():
            with path.open("rb") as file:
                return gnu.GNUTranslations(file)
    raise FileNotFoundError(f"the catalogue of {code!r} is missing from this installation")


def _significant_decimals(value: float) -> int:
    if value == 0:
        return 0
    return max(0, _SIGNIFICANT_DIGITS - 1 - floor(log10(abs(value))))
