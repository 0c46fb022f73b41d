"""Options of the commands ``report`` and ``identity``."""

import argparse
from pathlib import Path

from lispac.cli.argument_types import Commands, add_command, add_json_option
from lispac.identity import HINTS, NAMES
from lispac.language import LANGUAGES


def add_commands(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Add the commands ``report`` and ``identity``."""
    _add_identity(commands)
    _add_report(commands)


def _add_identity(commands: "Commands[argparse.ArgumentParser]") -> None:
    identity = add_command(
        commands,
        "identity",
        "set or show the details of the survey for the report (surveyor, dates, instruments)",
    )
    identity.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    for name in NAMES:
        hint = HINTS[name]
        if name == "dates":
            hint += "; auto takes them from the times of the lines if these contain the date"
        identity.add_argument(f"--{name.replace('_', '-')}", metavar="TEXT", help=hint)
    add_json_option(identity)


def _add_report(commands: "Commands[argparse.ArgumentParser]") -> None:
    report = add_command(commands, "report", "write the calibration report")
    report.add_argument("project", type=Path, nargs="?", metavar="PROJECT", help="project folder")
    report.add_argument(
        "--output",
        type=Path,
        metavar="FILE",
        help="report file: .pdf, .html, .json, or .zip for all tables as CSV",
    )
    report.add_argument(
        "--language",
        choices=tuple(LANGUAGES),
        help="language of the report (default en; JSON is always English)",
    )
    report.add_argument("--page", choices=("a4", "letter"), help="paper size (default a4)")
    report.add_argument(
        "--convention", metavar="SYSTEM",
        help="also give the boresight in the convention of another program; `lispac angles` lists "
             "the programs",
    )  # fmt: skip
    report.add_argument(
        "--template", type=Path, metavar="FILE",
        help="TOML file with defaults for the report: logo (PNG or SVG file beside it), company, "
             "heading, closing, page, convention, language; options of the command line override "
             "it",
    )  # fmt: skip
    report.add_argument(
        "--schema", action="store_true", help="print the JSON schema of the report and exit"
    )
