"""Reading of TOML tables key by key; errors name the file, the key and a suggested action."""

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from difflib import get_close_matches
from pathlib import Path
from typing import Any
from unicodedata import category

from lispac.errors import InputError
from lispac.former_names import warn_of_former_key
from lispac.io.files import require_file
from lispac.messages import Level, Message, Value, error
from lispac.untrusted_values import (
    MAX_AMOUNT,
    MIN_AMOUNT,
    InvalidContentError,
    is_possible_amount,
    toml_values,
)

PRESENT_KEY_OF_FORMER = {
    "from_level_deg": "inclination_deg",
    "from_memory": "unverified",
    "hang": "board_choices",
    "sail": "line_choices",
}
"""New keys by former keys; the former keys are accepted for one version."""
REQUIRED_KEY: Any = object()
"""Marks a key without a default: the key is required."""
MAX_SHOWN_LENGTH = 60
"""Largest number of characters of a value in a message."""
CONTROL_CATEGORIES = ("Cc", "Zl", "Zp")
"""Unicode categories of control characters and line breaks, not allowed in names and titles."""


class TomlTable:
    """A TOML table that reports keys which were not read as errors."""

    def __init__(self, path: Path, values: Mapping[str, Any], place: str = "") -> None:
        self.path = path
        self._values = _with_present_keys(path, values)
        self._place = place
        self._known: set[str] = set()

    @classmethod
    @contextmanager
    def read(cls, path: Path, what: str) -> "Iterator[TomlTable]":
        """Open the whole file as a table; keys that were not read are refused at the end.

        Raises
        ------
        InputError
            If the file is not valid TOML.
        """
        path = require_file(Path(path), what)
        try:
            values = toml_values(path.read_bytes())
        except InvalidContentError as failure:
            raise InputError(
                error("toml.invalid", file=str(path), reason=failure.reason)
            ) from failure
        table = cls(path, values)
        yield table
        table.require_no_other_keys()

    def __contains__(self, key: str) -> bool:
        self._known.add(key)
        return key in self._values

    def refuse(self, key: str, code: str, /, **params: Value) -> InputError:
        """Make an error about a key; its text has the placeholders ``file`` and ``key``."""
        about = {"file": str(self.path), "key": self._key_name(key), **params}
        return InputError(Message(code, Level.ERROR, about))

    def text(self, key: str, default: Any = REQUIRED_KEY) -> str:
        """Read a non-empty string without line breaks."""
        value = self._value(key, default)
        if value is default:
            return value
        if not (isinstance(value, str) and value.strip()):
            raise self.refuse(key, "toml.not_text", value=_shortened_text(value))
        if any(category(letter) in CONTROL_CATEGORIES for letter in value):
            raise self.refuse(key, "toml.control_character", value=_shortened_text(value))
        return value

    def one_of(self, key: str, words: Sequence[str], default: Any = REQUIRED_KEY) -> str:
        """Read a string that must be one of the given words."""
        value = self._value(key, default)
        if value is not default and value not in words:
            raise self.refuse(key, "toml.not_a_choice", value=_shortened_text(value), choices=words)
        return value

    def boolean(self, key: str, default: Any = REQUIRED_KEY) -> bool:
        """Read true or false."""
        value = self._value(key, default)
        if not isinstance(value, bool):
            raise self.refuse(key, "toml.not_true_or_false", value=_shortened_text(value))
        return value

    def number(
        self, key: str, default: Any = REQUIRED_KEY, *, low: float = -math.inf,
        high: float = math.inf, over: float = -math.inf,
    ) -> float:  # fmt: skip
        """Read a number from ``low`` to ``high`` that is greater than ``over``."""
        value = self._value(key, default)
        if value is default:
            return value
        return self._sound(key, value, low, high, over)

    def numbers(
        self, key: str, count: int | None, default: Any = REQUIRED_KEY, *, low: float = -math.inf,
        high: float = math.inf,
    ) -> tuple[float, ...]:  # fmt: skip
        """Read a list of ``count`` numbers, or of any length if ``count`` is None."""
        value = self._value(key, default)
        if value is default:
            return value
        if not isinstance(value, list) or (count is not None and len(value) != count):
            if count is None:
                raise self.refuse(key, "toml.not_numbers", value=_shortened_text(value))
            raise self.refuse(
                key, "toml.wrong_number_count", value=_shortened_text(value), count=count
            )
        return tuple(self._sound(key, each, low, high, -math.inf) for each in value)

    def three_numbers(
        self, key: str, default: Any = REQUIRED_KEY, *, low: float = -math.inf,
        high: float = math.inf,
    ) -> tuple[float, float, float]:  # fmt: skip
        """Read a list of three numbers."""
        values = self.numbers(key, 3, default, low=low, high=high)
        return values[0], values[1], values[2]

    @contextmanager
    def table(self, key: str) -> "Iterator[TomlTable]":
        """Read a table inside this one; an empty one if it is missing."""
        value = self._value(key, {})
        if not isinstance(value, dict):
            raise self.refuse(key, "toml.not_a_table", value=_shortened_text(value), table=key)
        inner = TomlTable(self.path, value, f"{self._place}{key}.")
        yield inner
        inner.require_no_other_keys()

    def tables(self, key: str) -> "Iterator[TomlTable]":
        """Read the tables of a list, one after the other."""
        value = self._value(key, [])
        if not isinstance(value, list) or not all(isinstance(each, dict) for each in value):
            raise self.refuse(key, "toml.not_a_list_of_tables", table=key)
        for k, each in enumerate(value):
            inner = TomlTable(self.path, each, f"{self._place}{key}[{k + 1}].")
            yield inner
            inner.require_no_other_keys()

    def ignore_rest(self) -> None:
        """Accept all other keys of this table without reading them."""
        self._known |= set(self._values)

    def require_no_other_keys(self) -> None:
        """Refuse keys that were not read.

        Raises
        ------
        InputError
            If the table contains a key that was not read.
        """
        for key in self._values:
            if key not in self._known:
                near = get_close_matches(key, self._known, 1, 0.6) or [
                    known for known in sorted(self._known) if known.startswith(f"{key}_")
                ]
                if near:
                    raise self.refuse(key, "toml.unknown_key_similar", similar=near[0])
                raise self.refuse(key, "toml.unknown_key", known=sorted(self._known))

    def _key_name(self, key: str) -> str:
        named = f"{self._place}{key}"
        return named if len(named) <= MAX_SHOWN_LENGTH else f"{named[:MAX_SHOWN_LENGTH]}…"

    def _value(self, key: str, default: Any) -> Any:
        self._known.add(key)
        if key in self._values:
            return self._values[key]
        if default is REQUIRED_KEY:
            stem = key.split("_")[0]
            near = [k for k in self._values if k not in self._known and k.split("_")[0] == stem]
            if near:
                raise self.refuse(near[0], "toml.wrong_key", wanted=key)
            raise self.refuse(key, "toml.missing_key")
        return default

    def _sound(self, key: str, value: Any, low: float, high: float, over: float) -> float:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.refuse(key, "toml.not_a_number", value=_shortened_text(value))
        if not math.isfinite(value):
            raise self.refuse(key, "toml.not_finite", value=_shortened_text(value))
        if value < low:
            raise self.refuse(key, "toml.below_minimum", value=f"{value:g}", least=f"{low:g}")
        if value <= over:
            raise self.refuse(key, "toml.not_above", value=f"{value:g}", bound=f"{over:g}")
        if value > high:
            raise self.refuse(key, "toml.above_maximum", value=f"{value:g}", most=f"{high:g}")
        if not is_possible_amount(value):
            bound = f"{math.copysign(MAX_AMOUNT, value):g}"
            if abs(value) < MIN_AMOUNT:
                raise self.refuse(key, "toml.too_near_zero", value=f"{value:g}")
            if value > 0:
                raise self.refuse(key, "toml.above_maximum", value=f"{value:g}", most=bound)
            raise self.refuse(key, "toml.below_minimum", value=f"{value:g}", least=bound)
        return float(value)


def _with_present_keys(path: Path, values: Mapping[str, Any]) -> dict[str, Any]:
    """Replace former keys by the present ones, with a warning for each."""
    former = [
        key
        for key in values
        if key in PRESENT_KEY_OF_FORMER and PRESENT_KEY_OF_FORMER[key] not in values
    ]
    for key in former:
        warn_of_former_key(str(path), key, PRESENT_KEY_OF_FORMER[key])
    return {
        PRESENT_KEY_OF_FORMER[key] if key in former else key: each for key, each in values.items()
    }


def _shortened_text(value: Any) -> str:
    """Text of a value for a message, shortened if it is long."""
    text = repr(value)
    return text if len(text) <= MAX_SHOWN_LENGTH else f"{text[:MAX_SHOWN_LENGTH]}…"


def toml_string(text: str) -> str:
    """A text as a TOML string, which escapes control characters as JSON does."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
