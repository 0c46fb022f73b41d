"""``lispac look``: what a file is, what is assumed, and any warnings."""

from argparse import Namespace
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from lispac.adjustment.shown import plain
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.messages import message_numbers
from lispac.message_texts import fact_text, message_text
from lispac.workflow.file_audit import audit_messages_of
from lispac.workflow.file_reading import FileCheck, looks

SWITCH = {"trajectory": "trajectory", "accuracy": "accuracy", "points": "line"}
WIDEST = 14  # characters of a cell of the preview


def look(arguments: Namespace) -> None:
    """Print what each format that knows the file finds in it, the surest first."""
    found = looks(arguments.file)
    if not arguments.quick:
        found = _audited(arguments.file, found)
    if arguments.json:
        print_json({"file": str(arguments.file), "formats": [_numbers(item) for item in found]})
        return
    print(arguments.file)
    for item in found:
        if item.finding is not None or found[0].finding is None:  # one that fits was found first
            _print(item)


def _audited(path: Path, found: Sequence[FileCheck]) -> list[FileCheck]:
    """The same with what all points of the file show, where the surest format has points."""
    items = list(found)
    if items and items[0].finding is not None and items[0].format.kind == "points":
        finding = items[0].finding
        with ConsoleProgress() as progress:
            audit = audit_messages_of(path, items[0].format, finding.choice, progress=progress)
        items[0] = replace(items[0], finding=replace(finding, messages=(*finding.messages, *audit)))
    return items


def _print(item: FileCheck) -> None:
    sure = "certainly" if item.sureness >= 1 else "probably" if item.sureness > 0.5 else "perhaps"
    name = message_text(item.format.name)
    print(f"\n{sure} {name} (--{SWITCH[item.format.kind]}-format {item.format.key})")
    if item.finding is None:
        reason = plain(message_text(item.error)) if item.error else ""
        print(f"  cannot be read: {reason}")
        return
    for name, value in item.finding.facts.items():
        print(f"  {name:20s} {fact_text(value)}")
    settled = item.format.settled(item.finding.choice)
    for option in item.format.options:
        among = f" ({', '.join(c for c in option.choices if c)})" if option.choices else ""
        print(f"  option {option.name}={settled[option.name]}{among}: {option.meaning}")
    for assumption in item.finding.assumptions:
        print(f"  assumed: {plain(message_text(assumption))}")
    for row in item.finding.rows[:4]:
        print("  " + " ".join(f"{cell[:WIDEST]:>{WIDEST}s}" for cell in row[:8]))
    for message in (*item.finding.doubts, *item.finding.messages):
        print(f"  {message.level}: {plain(message_text(message))}")


def _numbers(item: FileCheck) -> dict[str, Any]:
    finding = item.finding
    messages = (*finding.doubts, *finding.messages) if finding else ()
    return {
        "format": item.format.key,
        "name": message_text(item.format.name),
        "kind": item.format.kind,
        "sureness": item.sureness,
        "error": plain(message_text(item.error)) if item.error else "",
        "facts": {name: fact_text(fact) for name, fact in finding.facts.items()} if finding else {},
        "options": item.format.settled(finding.choice) if finding else {},
        "assumptions": [plain(message_text(a)) for a in finding.assumptions] if finding else [],
        "doubts": [plain(message_text(each)) for each in finding.doubts] if finding else [],
        "messages": [message_numbers(each) for each in messages],
    }
