"""Options of the commands that repeat: a project's script, and many projects at once."""

import argparse
from pathlib import Path

from lispac.cli.argument_types import Commands, add_command, add_json_option


def add_commands(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Add the commands ``script`` and ``batch``."""
    script = add_command(
        commands, "script", "write a Python script that recreates a project from its raw files"
    )
    script.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    script.add_argument(
        "--output", type=Path, metavar="FILE", help="script file (default: print it)"
    )
    add_json_option(script)

    batch = add_command(
        commands,
        "batch",
        "calibrate all projects in folders with their picked targets and list the results",
    )
    batch.add_argument(
        "folders",
        type=Path,
        nargs="+",
        metavar="FOLDER",
        help="folder to search for projects, including its subfolders",
    )
    batch.add_argument(
        "--output", type=Path, metavar="TABLE", help="CSV file for the table of results"
    )
    batch.add_argument(
        "--save", action="store_true",
        help="save the results in the projects (default: the projects are not changed)",
    )  # fmt: skip
    batch.add_argument(
        "--reports",
        type=Path,
        metavar="DIR",
        help="write the report of each project to this folder",
    )
    batch.add_argument(
        "--report-format",
        choices=("pdf", "html", "json", "zip"),
        help="format of the reports (default pdf)",
    )
    batch.add_argument(
        "--template",
        type=Path,
        metavar="FILE",
        help="template of the reports; see `lispac report --help`",
    )
    add_json_option(batch)
