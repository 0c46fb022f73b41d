"""Terminal output: progress line on stderr, JSON and tables; opening of projects."""

import json
import os
import re
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

from lispac.installation_paths import resource_path

if TYPE_CHECKING:
    from lispac.present.tables import Fact, Row, Table
    from lispac.progress import Step
    from lispac.project import Project


SCHEMA_FILE = "commands.schema.json"
"""File with the JSON schema of the output of each command."""
SCHEMA_VERSION = 1
"""Version of the JSON of the commands; a key that is removed or gets another meaning raises it."""


class UsageError(Exception):
    """Error for missing or contradictory options; the exit code is 2, as for errors of argparse."""


class ConsoleProgress:
    """Progress on one line of stderr, rewritten in place; silent if stderr is no terminal."""

    def __init__(self) -> None:
        self._shown = 0.0
        self._width = 0
        self._terminal = sys.stderr.isatty()

    def __call__(self, fraction: float, step: "Step | None" = None) -> None:
        """Show fraction and step; the line is rewritten at most ten times a second."""
        now = time.monotonic()
        if not self._terminal or now - self._shown < 0.1:
            return
        self._shown = now
        text = f"{fraction:4.0%} {step or ''}"
        print("\r" + text.ljust(self._width), end="", file=sys.stderr, flush=True)
        self._width = len(text)

    def __enter__(self) -> "ConsoleProgress":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if self._width:
            print("\r" + " " * self._width + "\r", end="", file=sys.stderr, flush=True)


@contextmanager
def opened_project(path: Path, *, change: bool) -> "Iterator[Project]":
    """Open a project, locked against other programs if ``change`` is true.

    Raises
    ------
    ProjectError
        If the folder contains no valid project, or another program has locked it.
    InputError
        If the project is to be changed and its folder is not writable.
    """
    from lispac.workflow.project.projects import locked_project, open_project

    if not change:
        yield open_project(path)
        return

    def print_waiting_note() -> None:
        print(f"{path}: waiting for another program that changes this project", file=sys.stderr)

    with locked_project(path, waiting=print_waiting_note) as project:
        yield project


def has_display() -> bool:
    """True if a window can be opened."""
    if sys.platform.startswith("linux"):
        return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
    return True


def print_json(output: object) -> None:
    """Print the output of a command, one of `lispac.cli.json_outputs`, as a JSON object."""
    from lispac.present.json_values import json_values

    values = {"schema_version": SCHEMA_VERSION, **json_values(output)}
    print(json.dumps(values, indent=1, allow_nan=False))


def print_schema(command: str) -> None:
    """Print the JSON schema (draft 2020-12) of what a command prints with ``--json``."""
    published = json.loads(resource_path(SCHEMA_FILE).read_text(encoding="utf-8"))
    definitions, used = published["$defs"], {}
    schema = published["properties"][command]
    unread = [schema]
    while unread:
        for name in re.findall(r'"#/\$defs/(\w+)"', json.dumps(unread.pop())):
            if name not in used:
                used[name] = definitions[name]
                unread.append(definitions[name])
    head = {"$schema": published["$schema"], "title": f"lispac {command} --json"}
    print(json.dumps({**head, **schema, "$defs": used}, indent=1, ensure_ascii=False))


def print_table(table: "Table[Row]", rows: "Sequence[Row]") -> None:
    """Print a table of results as text: title, headings with units, rows, and a blank line."""
    from lispac.present.plain_text import table_as_text

    print(table_as_text(table, rows), end="\n\n")


def print_facts(title: str, facts: "Sequence[Fact]") -> None:
    """Print names and values below a title: one in each row, and a blank line."""
    from lispac.present.plain_text import facts_as_text

    print(facts_as_text(title, facts), end="\n\n")
