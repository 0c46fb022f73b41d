"""``lispac inspect``: format, assumptions and warnings of a file."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.messages import console_text

if TYPE_CHECKING:
    from lispac.workflow.importing.file_reading import FileCheck

OPTION_PREFIX = {"trajectory": "trajectory", "accuracy": "accuracy", "points": "line"}
"""Beginning of the options for a file in `lispac new`, by the kind of the file."""
CELL_WIDTH = 14  # characters in a cell of the preview


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "file", type=Path, metavar="FILE", help="trajectory, trajectory accuracy or line file"
    )
    parser.add_argument("--quick", action="store_true", help="read the first points only")
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print format, options, assumptions, a preview and messages, for each possible format."""
    from lispac.workflow.importing.file_reading import check_file

    found = check_file(arguments.file)
    if not arguments.quick:
        found = _checks_with_audit(arguments.file, found)
    if arguments.json:
        from lispac.cli.json_outputs import InspectOutput

        print_json(InspectOutput(arguments.file, tuple(item.values for item in found)))
        return
    print(arguments.file)
    for item in found:
        if item.finding is not None or found[0].finding is None:  # matching formats come first
            _print_check(item)


def _checks_with_audit(path: Path, checks: Sequence[FileCheck]) -> list[FileCheck]:
    """Checks of a file; the most likely one includes an audit of all points, if it has points."""
    from lispac.workflow.importing.file_audit import audit_messages

    items = list(checks)
    if items and items[0].finding is not None and items[0].format.kind == "points":
        finding = items[0].finding
        with ConsoleProgress() as progress:
            audit = audit_messages(path, items[0].format, finding.choice, progress=progress)
        items[0] = replace(items[0], finding=finding.with_messages(audit))
    return items


def _print_check(item: FileCheck) -> None:
    from lispac.language import to_plain_text
    from lispac.present.survey.input_file import content_facts

    values = item.values
    sure = (
        "certainly" if item.confidence >= 1 else "probably" if item.confidence > 0.5 else "perhaps"
    )
    option = f"--{OPTION_PREFIX[item.format.kind]}-format {values.format}"
    print(f"\n{sure} {values.name} ({option})")
    if item.finding is None:
        assert item.error is not None
        print(f"  cannot be read: {console_text(item.error)}")
        return
    for fact in content_facts(item.finding.facts):
        print(f"  {fact.name:20s} {to_plain_text(fact.text)}")
    for each in item.format.options:
        among = f" ({', '.join(c for c in each.choices if c)})" if each.choices else ""
        print(f"  option {each.name}={values.options[each.name]}{among}: {each.meaning}")
    for assumption in values.assumptions:
        print(f"  assumed: {console_text(assumption)}")
    for row in item.finding.rows[:4]:
        print("  " + " ".join(f"{cell[:CELL_WIDTH]:>{CELL_WIDTH}s}" for cell in row[:8]))
    for message in values.messages:
        print(f"  {message.level}: {console_text(message)}")
