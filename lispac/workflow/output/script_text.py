"""Python code for the script of a project: values, and calls wrapped to the line length."""

from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from enum import StrEnum
from pathlib import Path
from typing import Any

MAX_LINE_LENGTH = 100
"""Largest number of characters of a line of the script, if it can be wrapped."""
MAX_PIECE_LENGTH = 72
"""Largest number of characters of a piece of a long text."""


class PythonCode(str):
    """Text that is inserted into a script without quotes."""


def python_literal(value: object) -> str:
    """Python literal of a value; a dataclass as a call with only the non-default fields."""
    if isinstance(value, PythonCode):
        return str(value)
    if isinstance(value, Path):
        return f"Path({str(value)!r})"
    if isinstance(value, bool) or value is None:
        return repr(value)
    if isinstance(value, StrEnum):
        return repr(value.value)
    if isinstance(value, float):
        return repr(float(value))  # NumPy's scalars include their type
    if isinstance(value, (list, tuple)):
        inside = ", ".join(map(python_literal, value))
        if isinstance(value, list):
            return f"[{inside}]"
        return f"({inside},)" if len(value) == 1 else f"({inside})"
    if isinstance(value, Mapping):
        return (
            "{"
            + ", ".join(f"{python_literal(k)}: {python_literal(v)}" for k, v in value.items())
            + "}"
        )
    if is_dataclass(value) and not isinstance(value, type):
        return call_text(f"lispac.{type(value).__name__}", **non_default_fields(value))
    return repr(value)


def non_default_fields(value: Any, *, but: Sequence[str] = ()) -> dict[str, object]:
    """Fields of a dataclass with values other than the default, without those in ``but``."""
    return {
        field.name: found
        for field in fields(value)
        if field.name not in but and (found := getattr(value, field.name)) != field.default
    }


def call_text(function: str, *arguments: object, **named: object) -> str:
    """Code of a call in one line, or with a line for each argument if it would be too long."""
    parts = [
        *map(python_literal, arguments),
        *(f"{name}={python_literal(value)}" for name, value in named.items()),
    ]
    short = f"{function}({', '.join(parts)})"
    if len(short) <= MAX_LINE_LENGTH - 8 and "\n" not in short:
        return short
    rows = "".join(f"    {part.replace(chr(10), chr(10) + '    ')},\n" for part in parts)
    return f"{function}(\n{rows})"


def rows(values: Sequence[object]) -> PythonCode:
    """Code of a list with a row for each value."""
    inside = "".join(
        f"    {python_literal(v).replace(chr(10), chr(10) + '    ')},\n" for v in values
    )
    return PythonCode(f"[\n{inside}]")


def split_text_code(text: str) -> PythonCode:
    """Code of a long text without line breaks, split into pieces of whole words."""
    pieces = [""]
    for word in text.split(" "):
        if pieces[-1] and len(pieces[-1]) + len(word) >= MAX_PIECE_LENGTH:
            pieces.append("")
        pieces[-1] += word + " "
    pieces[-1] = pieces[-1][:-1]
    if len(pieces) == 1:
        return PythonCode(repr(text))
    return PythonCode("\n".join(map(repr, pieces)))


class FilePaths:
    """File paths of a project in a script.

    Paths of files in the folder with most of the files are relative to it, as ``data``; other paths
    are written completely.
    """

    def __init__(self, paths: Sequence[Path]) -> None:
        parents = [path.parent for path in paths]
        self.folder = max(dict.fromkeys(parents), key=parents.count)

    def __call__(self, path: Path) -> PythonCode:
        """Code of a path in the script."""
        if path.parent == self.folder:
            return PythonCode(f"data / {path.name!r}")
        return PythonCode(python_literal(path))
