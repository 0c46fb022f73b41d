"""``lispac look``: what a file is, what its reader assumes, and what to doubt."""

from argparse import Namespace
from typing import Any

from lispac.adjustment.shown import plain
from lispac.cli.console import print_json
from lispac.cli.messages import message_numbers
from lispac.message_texts import message_text
from lispac.workflow.reading import Look, looks

SWITCH = {"trajectory": "trajectory", "accuracy": "accuracy", "points": "line"}
WIDEST = 14  # characters of a cell of the preview


def look(arguments: Namespace) -> None:
    """Print what each format that knows the file finds in it, the surest first."""
    found = looks(arguments.file)
    if arguments.json:
        print_json({"file": str(arguments.file), "formats": [_numbers(item) for item in found]})
        return
    print(arguments.file)
    for item in found:
        _print(item)


def _print(item: Look) -> None:
    sure = "certainly" if item.sureness >= 1 else "probably" if item.sureness > 0.5 else "perhaps"
    print(f"\n{sure} {item.format.name} (--{SWITCH[item.format.kind]}-format {item.format.key})")
    if item.finding is None:
        print(f"  cannot be read: {item.error}")
        return
    for name, value in item.finding.facts.items():
        print(f"  {name:20s} {value}")
    settled = item.format.settled(item.finding.choice)
    for option in item.format.options:
        among = f" ({', '.join(c for c in option.choices if c)})" if option.choices else ""
        print(f"  option {option.name}={settled[option.name]}{among}: {option.meaning}")
    for assumption in item.finding.assumptions:
        print(f"  assumed: {assumption}")
    for row in item.finding.rows[:4]:
        print("  " + " ".join(f"{cell[:WIDEST]:>{WIDEST}s}" for cell in row[:8]))
    for doubt in item.finding.doubts:
        print(f"  doubt: {doubt}")
    for message in item.finding.messages:
        print(f"  {message.level}: {plain(message_text(message))}")


def _numbers(item: Look) -> dict[str, Any]:
    finding = item.finding
    return {
        "format": item.format.key,
        "name": item.format.name,
        "kind": item.format.kind,
        "sureness": item.sureness,
        "error": item.error,
        "facts": dict(finding.facts) if finding else {},
        "options": item.format.settled(finding.choice) if finding else {},
        "assumptions": list(finding.assumptions) if finding else [],
        "doubts": list(finding.doubts) if finding else [],
        "messages": [message_numbers(each) for each in finding.messages] if finding else [],
    }
