"""Options of the commands ``report`` and ``identity``."""

import argparse
from pathlib import Path

from lispac.cli.values import Commands, command, json_option
from lispac.identity import HINTS, NAMES
from lispac.language import LANGUAGES


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Describe them."""
    _identity(commands)
    _report(commands)


def _identity(commands: "Commands[argparse.ArgumentParser]") -> None:
    identity = command(
        commands, "identity", "say who, when and with what, for the report, or show what is said"
    )
    identity.add_argument("project", type=Path, metavar="PROJECT")
    for name in NAMES:
        hint = HINTS[name]
        if name == "dates":
            hint += "; auto takes them from the times of the lines where these tell the day"
        identity.add_argument(f"--{name.replace('_', '-')}", metavar="TEXT", help=hint)
    json_option(identity)


def _report(commands: "Commands[argparse.ArgumentParser]") -> None:
    report = command(commands, "report", "write the report")
    report.add_argument("project", type=Path, nargs="?", metavar="PROJECT")
    report.add_argument(
        "--output",
        type=Path,
        metavar="FILE",
        help=".pdf, .html, .json, or .zip for all tables as CSV",
    )
    report.add_argument(
        "--language", choices=tuple(LANGUAGES), help="of the report (default en); JSON is English"
    )
    report.add_argument("--page", choices=("a4", "letter"), help="size of the paper (default a4)")
    report.add_argument(
        "--convention", metavar="SYSTEM",
        help="also state the boresight as this program has it; `lispac angles` lists them",
    )  # fmt: skip
    report.add_argument(
        "--template", type=Path, metavar="FILE",
        help="TOML file with what a company always wants: logo (PNG or SVG beside it), company, "
        "heading, closing, page, convention, language; what is chosen here goes before it",
    )  # fmt: skip
    report.add_argument(
        "--schema", action="store_true", help="print the JSON schema of the report and do no more"
    )
