"""Tables of results: values, titles and number formats of their columns."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Generic, Literal, TypeVar

from lispac.language import (
    LESS_THAN,
    N_,
    LazyText,
    decimals_apart,
    gettext,
    is_rounded_to_zero,
    nonzero_decimals,
    without_negative_zero,
)
from lispac.messages import Message
from lispac.present.text_format import (
    DEGREE_SIGN,
    UNKNOWN_TEXT,
    fixed_number,
    grouped_number,
    interval_text,
    sentence_text,
    with_unit,
)

Row = TypeVar("Row")
Unit = Literal["", "m", "cm", "mm", "deg", "mdeg", "ms", "s", "m/s", "%"]


@dataclass(frozen=True)
class Format:
    """Format of a number.

    Attributes
    ----------
    unit : displayed unit
    decimals : number of decimals in the displayed unit
    factor : number of displayed units in one unit of the value
    is_signed : whether positive numbers have a plus sign
    is_grouped : whether groups of three digits are separated
    is_half_interval : whether a plus-minus sign precedes the number
    title_unit : unit that is in the title of the table instead
    """

    unit: Unit = ""
    decimals: int = 0
    factor: float = 1.0
    is_signed: bool = False
    is_grouped: bool = True
    is_half_interval: bool = False
    title_unit: Unit = ""

    @property
    def signed(self) -> "Format":
        """Format with a plus sign before positive numbers."""
        return replace(self, is_signed=True)

    @property
    def half_interval(self) -> "Format":
        """Format with a plus-minus sign, for half the width of an interval."""
        return replace(self, is_half_interval=True)

    def apart(self, value: float, *others: float | None) -> "Format":
        """Format with enough decimals to write the value and each other value differently.

        Equal values are written equally. A value beyond its limit is never written like the limit.
        """
        known = [other for other in others if other is not None]
        shown = [decimals_apart(self.factor * value, self.factor * k, self.decimals) for k in known]
        return replace(self, decimals=max(shown, default=self.decimals))

    def nonzero(self, value: float) -> "Format":
        """Format with enough decimals that a small value is not written as zero."""
        return replace(self, decimals=nonzero_decimals(self.decimals, self.factor * value))

    def text(self, value: float) -> str:
        """The number in the language in use, without its unit."""
        shown = self.factor * value
        if self.unit == "%" and is_rounded_to_zero(shown, self.decimals):
            return LESS_THAN + fixed_number(10.0**-self.decimals, self.decimals)
        if self.is_half_interval:
            return interval_text(fixed_number(shown, nonzero_decimals(self.decimals, shown)))
        if self.is_signed or not self.is_grouped:
            return fixed_number(shown, self.decimals, sign=self.is_signed)
        return grouped_number(shown, self.decimals)

    def plain_text(self, value: float) -> str:
        """The number as Python writes it, rounded as in `text`, without unit and plus-minus."""
        shown = self.factor * value
        decimals = (
            nonzero_decimals(self.decimals, shown) if self.is_half_interval else self.decimals
        )
        shown = without_negative_zero(shown, decimals)
        sign = "+" if self.is_signed and not self.is_half_interval and shown else ""
        return f"{shown:{sign}.{decimals}f}"


COUNT = Format()
MILLIMETRES = Format("mm", 1, 1e3)
CENTIMETRES = Format("cm", 2, 1e2, is_grouped=False)
PLAIN_CENTIMETRES = Format("", 2, 1e2, is_grouped=False, title_unit="cm")
PLAIN_MILLIMETRES = Format("", 1, 1e3, title_unit="mm")
"""Formats of lengths without a unit, for tables whose title contains the unit."""
DEGREES = Format("deg", 4)
MILLIDEGREES = Format("mdeg", 1, 1e3)
PERCENT = Format("%", 0, 100.0)
SECONDS = Format("s", 3, is_grouped=False)
COMPUTING_SECONDS = Format("s", 2)
"""Format of computing times."""
ARROW = "\u2192"
"""Sign between the values before and after the calibration."""
YES_NO_TEXTS = {True: N_("yes"), False: N_("no")}
"""Texts of a column with truth values."""


def ratio(decimals: int) -> Format:
    """Format of a number without a unit, with this number of decimals."""
    return Format("", decimals)


@dataclass(frozen=True)
class Column(Generic[Row]):
    """One column: its value in a row, and its presentation.

    Attributes
    ----------
    value : str or callable
        Path of a field of the row, possibly nested as in ``effect_deg.roll``, or a function of the
        row. The values are numbers, texts or messages, or None if they are unknown.
    title : str or LazyText
        Title without the unit, in English or translated when it is shown.
    format : Format, callable or None
        Format of the numbers, or a function of the row if the rows differ; None for texts.
    tip : str
        Explanation in English, for the window.
    texts : mapping
        English text of each value, for values that are names.
    sigma : str, callable or None
        Standard deviation written beside the value, as a path or a function of the row.
    before : str or None
        Path of the value before the calibration, which is written before the value with an arrow.
    half_interval : str or None
        Path of the field with half the width of the 95 % interval, which is written after the
        value.
    has_unit_in_cells : bool
        Whether the unit is written in each cell instead of below the title.
    is_wide : bool
        Whether the texts are sentences.
    is_code : bool
        Whether the texts are digests, in a fixed-width font.
    unknown : str
        English text for an unknown value; a dash if empty.
    is_marked : callable or None
        Whether the value in a row is marked in a report, such as a value beyond its limit.
    """

    value: str | Callable[[Row], Any]
    title: str | LazyText
    format: Format | Callable[[Row], Format] | None = None
    tip: str | LazyText = ""
    texts: Mapping[Any, str] | None = None
    sigma: str | Callable[[Row], Any] | None = None
    before: str | None = None
    half_interval: str | None = None
    has_unit_in_cells: bool = False
    is_wide: bool = False
    is_code: bool = False
    unknown: str = ""
    is_marked: Callable[[Row], bool] | None = None

    @property
    def is_text(self) -> bool:
        """Whether the cells are texts."""
        return self.format is None

    @property
    def unit(self) -> Unit:
        """Unit below the title; empty if it is in the cells, or where there is none."""
        if isinstance(self.format, Format) and not self.has_unit_in_cells:
            return self.format.unit
        return ""

    def value_of(self, row: Row) -> Any:
        """Value in a row; messages and named values as text in the language in use."""
        value = _part_of(row, self.value)
        if value is not None and self.texts is not None:
            return gettext(self.texts[value])
        return sentence_text(value) if isinstance(value, Message) else value

    def before_of(self, row: Row) -> float | None:
        """Value before the calibration in a row; None if it is not known or not shown."""
        return None if self.before is None else _part_of(row, self.before)

    def sigma_of(self, row: Row) -> float | None:
        """Standard deviation of the value in a row, in the unit of the value."""
        return None if self.sigma is None else _part_of(row, self.sigma)

    def format_of(self, row: Row) -> Format | None:
        """Format of the number in a row."""
        return self.format(row) if callable(self.format) else self.format

    def unknown_text(self) -> str:
        """Text of an unknown value."""
        return gettext(self.unknown) if self.unknown else UNKNOWN_TEXT

    def with_title(self, title: str | LazyText) -> "Column[Row]":
        """Copy of the column with another title, in English."""
        return replace(self, title=title)


@dataclass(frozen=True)
class Table(Generic[Row]):
    """Table of rows of one kind: columns, and a title in English or translated when shown."""

    title: str | LazyText
    columns: tuple[Column[Row], ...]

    def without(self, title: str) -> "Table[Row]":
        """Copy of the table without the column of this English title."""
        return replace(self, columns=tuple(each for each in self.columns if each.title != title))


@dataclass(frozen=True)
class Fact:
    """Name of a value and the value: a text, a number with its format, or None if unknown."""

    name: str
    value: str | float | None
    format: Format = COUNT

    @property
    def text(self) -> str:
        """The value in the language in use."""
        if self.value is None:
            return UNKNOWN_TEXT
        return self.value if isinstance(self.value, str) else self.format.text(self.value)

    @property
    def plain_text(self) -> str:
        """The value for other programs: a number as Python writes it, empty if unknown."""
        if self.value is None:
            return ""
        return self.value if isinstance(self.value, str) else self.format.plain_text(self.value)


def title_text(title: str | LazyText) -> str:
    """Title of a table or a column, or a tooltip, in the language in use."""
    return str(title) if isinstance(title, LazyText) or not title else gettext(title)


def unit_text(unit: Unit) -> str:
    """Name of a unit in the language in use."""
    if unit == "deg":
        return DEGREE_SIGN
    return with_unit(fixed_number(0.001, 3), "deg") if unit == "mdeg" else unit


def cell_text(column: Column[Row], row: Row) -> str:
    """Text of a cell in standard units and the language in use."""
    value, form = column.value_of(row), column.format_of(row)
    if value is None:
        return column.unknown_text()
    if form is None:
        return str(value)
    text = form.text(value)
    before = column.before_of(row)
    if before is not None:
        text = f"{form.text(before)} {ARROW} {text}"
    if column.has_unit_in_cells:
        text = with_unit(text, form.unit)
    if column.half_interval is not None:
        half = form.half_interval.text(_part_of(row, column.half_interval))
        return f"{text} {half}"
    sigma = column.sigma_of(row)
    if sigma is None:
        return text
    return gettext("{error} (σ {sigma})", error=text, sigma=form.text(sigma))


def plain_cell_text(column: Column[Row], row: Row) -> str:
    """Text of a cell for other programs: numbers as Python writes them, empty if unknown."""
    value, form = column.value_of(row), column.format_of(row)
    if value is None:
        return gettext(column.unknown) if column.unknown else ""
    if form is None:
        return str(value)
    text = form.plain_text(value)
    before = column.before_of(row)
    if before is not None:
        text = f"{form.plain_text(before)} {ARROW} {text}"
    if column.has_unit_in_cells:
        text = with_unit(text, form.unit)
    if column.half_interval is not None:
        return f"{text} \u00b1 {form.half_interval.plain_text(_part_of(row, column.half_interval))}"
    sigma = column.sigma_of(row)
    return text if sigma is None else f"{text} (\u03c3 {form.plain_text(sigma)})"


def _part_of(row: Any, path: str | Callable[[Any], Any]) -> Any:
    if callable(path):
        return path(row)
    for name in path.split("."):
        if row is None:
            return None
        row = getattr(row, name)
    return row
