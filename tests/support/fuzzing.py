"""Damaged bytes and changed values for tests of readers."""

import json
import warnings
from collections.abc import Callable, Sequence
from copy import deepcopy
from time import monotonic
from typing import Any

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.errors import HypothesisWarning

MAX_SECONDS, MAX_INPUTS, MIN_INPUTS = 60, 100_000, 2_500
"""A long run ends at the first of the two limits, but not before the minimum number of inputs."""

Attempt = Callable[[bytes], bool]
"""Gives content to a reader; returns whether it was read. Foreign errors are raised."""


def damaged(content: bytes) -> st.SearchStrategy[bytes]:
    """Valid bytes with pieces changed, removed, inserted or truncated."""
    place = st.integers(0, len(content))
    length = st.sampled_from([0, 0, 1, 2, 4, 8, -1, -1, -1]) | st.integers(0, 40)
    edit = st.tuples(place, length, st.binary(max_size=9))

    def apply(edits: list[tuple[int, int, bytes]], cut: int | None) -> bytes:
        changed = bytearray(content)
        for at, removed_length, new in edits:
            changed[at : at + (len(new) if removed_length < 0 else removed_length)] = new
        return bytes(changed[:cut])

    cut = st.one_of(st.none(), st.none(), st.none(), place)
    return st.builds(apply, st.lists(edit, min_size=1, max_size=6), cut)


leaves = (
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8)
    | st.sampled_from(["", "..", "<f8", "|O", "/", "\0", -1, 0, 1, 2**63, 1e300, 0.5])
)  # fmt: skip
values = st.recursive(
    leaves,
    lambda v: st.lists(v, max_size=3) | st.dictionaries(st.text(max_size=5), v),
    max_leaves=4,
)


def places_of(content: Any, at: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Paths to all values in JSON content, as keys and numbers."""
    inner = (
        content.items() if isinstance(content, dict)
        else enumerate(content) if isinstance(content, list)
        else ()
    )  # fmt: skip
    return [at, *(place for key, value in inner for place in places_of(value, (*at, key)))]


def changed_values(content: Any) -> st.SearchStrategy[Any]:
    """JSON content with changed or missing values."""
    nothing = object()
    edit = st.tuples(st.sampled_from(places_of(content)[1:]), st.just(nothing) | values)

    def apply(edits: list[tuple[tuple[Any, ...], Any]]) -> Any:
        changed = deepcopy(content)
        for place, value in edits:
            inner = changed
            try:
                for key in place[:-1]:
                    inner = inner[key]
                if value is nothing:
                    del inner[place[-1]]
                else:
                    inner[place[-1]] = value
            except (LookupError, TypeError):  # an earlier edit has removed it
                continue
        return changed

    return st.builds(apply, st.lists(edit, min_size=1, max_size=3))


def json_like(content: bytes) -> st.SearchStrategy[bytes]:
    """Bytes of a JSON file, damaged or with changed values."""
    written = changed_values(json.loads(content)).map(lambda value: json.dumps(value).encode())
    nested = st.integers(1, 100_000).map(lambda depth: b"[" * depth)
    return st.one_of(damaged(content), written, written, nested)


TOML_VALUES = [
    "1e400", "-1e400", "nan", "inf", "9" * 5000, "-" + "9" * 30, "[" * 3000, "{a = " * 500, "[]",
    "{}", "[1, 2]", "[[1]]", "true", '""', '"x"', '"a\\u0000b"', '"a\\nb"', "'" + "y" * 5000 + "'",
    "1979-05-27", "-1", "0",
    "1e-320", "1e308", "-1e30", "[1e308, 1, 1]", '"../../etc/passwd"', '"nan"', "{b = 1}",
]  # fmt: skip


def toml_like(content: bytes) -> st.SearchStrategy[bytes]:
    """Bytes of a TOML file, damaged, with changed values or without a line."""
    lines = content.decode().splitlines()
    values = st.sampled_from(TOML_VALUES)
    edit = st.tuples(st.integers(0, len(lines) - 1), values | st.none())

    def apply(edits: list[tuple[int, str | None]]) -> bytes:
        changed: list[str] = list(lines)
        for at, value in edits:
            key, mark, _ = changed[at].partition("=")
            changed[at] = "" if value is None else f"{key}= {value}" if mark else changed[at]
        return "\n".join(changed).encode()

    written = st.builds(apply, st.lists(edit, min_size=1, max_size=3))
    return st.one_of(damaged(content), written, written)


def fuzz(made: st.SearchStrategy[bytes], attempt: Attempt, examples: int) -> tuple[int, int]:
    """Give examples to a reader; returns the number of examples and of those that were read."""
    inputs = read = 0

    @settings(
        max_examples=examples, deadline=None, database=None,
        suppress_health_check=list(HealthCheck),
    )  # fmt: skip
    @given(content=made)
    def run(content: bytes) -> None:
        nonlocal inputs, read
        inputs += 1
        read += attempt(content)

    with warnings.catch_warnings():
        # An example that is too long to print must not hide its error.
        warnings.simplefilter("ignore", HypothesisWarning)
        run()
    return inputs, read


def fuzz_long(name: str, made: Sequence[st.SearchStrategy[bytes]], attempt: Attempt) -> int:
    """Run `fuzz` for a minute or 100,000 inputs from all sources; prints the numbers."""
    inputs = read = turn = 0
    end = monotonic() + MAX_SECONDS
    while inputs < MIN_INPUTS or (inputs < MAX_INPUTS and monotonic() < end):
        counts = fuzz(made[turn % len(made)], attempt, 250)
        inputs, read, turn = inputs + counts[0], read + counts[1], turn + 1
    print(f"{name}: {inputs:,} inputs, {read:,} of them read, {inputs - read:,} refused")
    return inputs
