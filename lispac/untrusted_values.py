"""Checked reading of JSON and TOML files, which may come from an unknown source.

All readers of these files use this module, so that sizes, nesting and characters that would cause a
Python error elsewhere are refused in one place.
"""

import json
import tomllib
from typing import Any

from lispac.message_texts import message_text
from lispac.messages import Message, error

MAX_NESTING = 60
"""Largest depth of nested tables and lists in a file; a project has about ten levels."""
INTEGER_LIMIT = 2**63
"""Integers in files are smaller than this in absolute value: the program uses 64 bits."""
MAX_QUANTITY = 1e30
"""Largest quantity in a survey; squares of larger values could overflow."""
MIN_AMOUNT, MAX_AMOUNT = 1e-12, 1e12
"""Smallest and largest absolute value, other than zero, of a number given by the user or in a file
of settings, in any unit. Values outside are typing errors; their squares or inverses would
overflow."""
MAX_INTEGER_DIGITS = 19
"""Largest number of digits of a 64-bit integer; Python refuses to read thousands of digits."""


def is_possible_amount(value: float) -> bool:
    """True if a number is zero or lies between `MIN_AMOUNT` and `MAX_AMOUNT`."""
    return value == 0 or MIN_AMOUNT <= abs(value) <= MAX_AMOUNT


def is_whole_number(text: str, limit: int) -> bool:
    """True if a text is an integer from 0 to ``limit`` in decimal digits."""
    return text.isdecimal() and len(text) <= MAX_INTEGER_DIGITS and int(text) <= limit


class ArrayShape:
    """Shape of an array as part of a type annotation: ``Annotated[Array, ArrayShape("k", 3)]``.

    The same letter stands for the same number in all arrays of an object; ``"k+1"`` is one more
    than ``"k"``. Readers of project files refuse arrays of another shape.
    """

    def __init__(self, *dimensions: int | str) -> None:
        self.dimensions = dimensions

    def fits(self, shape: tuple[int, ...], known: dict[str, int]) -> bool:
        """True if a shape is allowed; letters that are not in ``known`` yet are added to it."""
        if len(shape) != len(self.dimensions):
            return False
        for size, dimension in zip(shape, self.dimensions, strict=True):
            if isinstance(dimension, str):
                letter, _, offset = dimension.partition("+")
                found = known.setdefault(letter, size - int(offset or 0))
                if found + int(offset or 0) != size:
                    return False
            elif size != dimension:
                return False
        return True


class InvalidContentError(ValueError):
    """The content of a file cannot be used.

    Parameters
    ----------
    reason : Message
        Description of the problem without the name of the file, used as part of another message.
    """

    def __init__(self, reason: Message) -> None:
        super().__init__(reason)
        self.reason = reason

    def __str__(self) -> str:
        """Text of the message."""
        return message_text(self.reason)


def json_values(content: bytes | str) -> Any:
    """Values of a JSON text.

    Raises
    ------
    InvalidContentError
        If the text is not JSON, or contains values that `require_usable_values` refuses.
    """
    try:
        text = content.decode("utf-8") if isinstance(content, bytes) else content
        values = json.loads(text)
    except UnicodeDecodeError as failure:
        raise InvalidContentError(error("content.not_utf8")) from failure
    except json.JSONDecodeError as failure:
        raise InvalidContentError(error("content.not_json", line=failure.lineno)) from failure
    except (ValueError, RecursionError) as failure:
        raise InvalidContentError(_number_too_large(failure)) from failure
    require_usable_values(values)
    return values


def toml_values(content: bytes) -> dict[str, Any]:
    """Values of a TOML text.

    Raises
    ------
    InvalidContentError
        If the text is not TOML, or contains values that `require_usable_values` refuses.
    """
    try:
        values = tomllib.loads(content.decode("utf-8-sig"))
    except UnicodeDecodeError as failure:
        raise InvalidContentError(error("content.not_utf8")) from failure
    except tomllib.TOMLDecodeError as failure:
        words = str(failure).splitlines()[0]
        raise InvalidContentError(error("content.not_toml", reason=words)) from failure
    except (ValueError, RecursionError) as failure:
        raise InvalidContentError(_number_too_large(failure)) from failure
    require_usable_values(values)
    return values


def _number_too_large(failure: Exception) -> Message:
    deep = isinstance(failure, RecursionError)
    return error("content.nested_too_deeply" if deep else "content.number_too_large")


def require_usable_values(values: Any) -> None:
    """Refuse values that the program cannot work with.

    These are lists and tables nested deeper than `MAX_NESTING`, integers of more than 64 bits, and
    text with a null character or an unpaired surrogate. Surrogates from U+DC80 to U+DCFF, by which
    Python represents bytes of file names that are not UTF-8, are allowed.

    Raises
    ------
    InvalidContentError
        If one of these values occurs.
    """
    waiting = [(values, 0)]
    while waiting:
        value, depth = waiting.pop()
        if depth > MAX_NESTING:
            raise InvalidContentError(error("content.nested_too_deeply"))
        if isinstance(value, dict):
            waiting += [(each, depth + 1) for pair in value.items() for each in pair]
        elif isinstance(value, list):
            waiting += [(each, depth + 1) for each in value]
        elif isinstance(value, str):
            require_usable_text(value)
        elif isinstance(value, int) and abs(value) >= INTEGER_LIMIT:
            raise InvalidContentError(error("content.number_too_large"))


def require_usable_text(text: str) -> None:
    """Refuse text with a null character or an unpaired surrogate outside U+DC80 to U+DCFF.

    Raises
    ------
    InvalidContentError
        If one of these characters occurs.
    """
    if "\0" in text:
        raise InvalidContentError(error("content.null_character"))
    try:
        text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError as failure:
        raise InvalidContentError(error("content.surrogate")) from failure


FORMULA_PREFIXES = ("=", "+", "-", "@", "\t", "\r")
"""First characters of a cell that a spreadsheet may interpret as a formula."""


def as_csv_cell(value: object) -> str:
    """Text of a CSV cell; an apostrophe is added before text that would be a formula.

    Numbers are not changed. Source: OWASP, CSV injection.
    """
    text = "" if value is None else str(value)
    if not text.startswith(FORMULA_PREFIXES):
        return text
    try:
        float(text.replace(",", ""))
    except ValueError:
        return f"'{text}"
    return text
