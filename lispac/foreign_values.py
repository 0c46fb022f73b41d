"""Values from JSON and TOML files that others may have written or damaged.

Readers of these files take values from here only, so that sizes, depths and characters that would
end in an error of Python somewhere else are refused in one place.
"""

import json
import tomllib
from typing import Any

DEEPEST = 60
"""Tables and lists inside each other; a project has about ten."""
LARGEST_INTEGER = 2**63
"""NumPy and the files of the program count with 64 bits."""


class Shape:
    """Shape of an array, in its annotation: ``Annotated[Array, Shape("k", 3)]``.

    Equal letters of one object are equal numbers; ``"k+1"`` is one more than ``"k"``. Readers of
    project files refuse arrays of another shape.
    """

    def __init__(self, *dimensions: int | str) -> None:
        self.dimensions = dimensions

    def fits(self, shape: tuple[int, ...], known: dict[str, int]) -> bool:
        """Whether an array may have a shape; letters that are not ``known`` yet become so."""
        if len(shape) != len(self.dimensions):
            return False
        for size, dimension in zip(shape, self.dimensions, strict=True):
            if isinstance(dimension, str):
                letter, _, more = dimension.partition("+")
                found = known.setdefault(letter, size - int(more or 0))
                if found + int(more or 0) != size:
                    return False
            elif size != dimension:
                return False
        return True


class Unfit(ValueError):
    """What was read cannot be used, in words for those who know the file and not the code."""


def json_values(content: bytes | str) -> Any:
    """Values of a JSON text.

    Raises
    ------
    Unfit
        Where it is not JSON, or holds what `require_usable` refuses.
    """
    try:
        text = content.decode("utf-8") if isinstance(content, bytes) else content
        values = json.loads(text)
    except UnicodeDecodeError as error:
        raise Unfit("it is not text") from error
    except json.JSONDecodeError as error:
        raise Unfit(f"it cannot be read from line {error.lineno} on") from error
    except (ValueError, RecursionError) as error:
        raise Unfit(_too_large(error)) from error
    require_usable(values)
    return values


def toml_values(content: bytes) -> dict[str, Any]:
    """Values of a TOML text.

    Raises
    ------
    Unfit
        Where it is not TOML, or holds what `require_usable` refuses.
    """
    try:
        values = tomllib.loads(content.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        raise Unfit("it is not UTF-8 text") from error
    except tomllib.TOMLDecodeError as error:
        raise Unfit(str(error).splitlines()[0]) from error
    except (ValueError, RecursionError) as error:
        raise Unfit(_too_large(error)) from error
    require_usable(values)
    return values


def _too_large(error: Exception) -> str:
    deep = isinstance(error, RecursionError)
    return "its lists or tables are nested too deeply" if deep else "a number in it is too large"


def require_usable(values: Any) -> None:
    """Refuse values that the program cannot work with.

    These are lists and tables nested deeper than `DEEPEST`, integers of more than 64 bits, and text
    with a null character or half of a pair of characters (a surrogate). Bytes of file names that
    are not UTF-8, which Python keeps as surrogates from U+DC80 on, stay.

    Raises
    ------
    Unfit
    """
    waiting = [(values, 0)]
    while waiting:
        value, depth = waiting.pop()
        if depth > DEEPEST:
            raise Unfit("its lists or tables are nested too deeply")
        if isinstance(value, dict):
            waiting += [(each, depth + 1) for pair in value.items() for each in pair]
        elif isinstance(value, list):
            waiting += [(each, depth + 1) for each in value]
        elif isinstance(value, str):
            require_usable_text(value)
        elif isinstance(value, int) and abs(value) >= LARGEST_INTEGER:
            raise Unfit("a number in it is too large")


def require_usable_text(text: str) -> None:
    """Refuse text with a null character or half of a pair of characters.

    Raises
    ------
    Unfit
    """
    if "\0" in text:
        raise Unfit("a text in it has a null character")
    try:
        text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError as error:
        raise Unfit("a text in it has a character that is cut in half") from error


FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""What a cell of a table begins with that spreadsheets take for a formula."""


def as_cell(value: object) -> str:
    """A value as a cell of CSV, with an apostrophe before what would be a formula.

    Source: OWASP, CSV injection. Numbers stay as they are.
    """
    text = "" if value is None else str(value)
    if not text.startswith(FORMULA):
        return text
    try:
        float(text.replace(",", ""))
    except ValueError:
        return f"'{text}"
    return text
