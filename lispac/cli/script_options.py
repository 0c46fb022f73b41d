"""Options of the commands that repeat: a project's script, and many projects at once."""

import argparse
from pathlib import Path

from lispac.cli.values import Commands, command, json_option


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Describe them."""
    script = command(
        commands, "script", "write the Python script that makes a project again from its raw files"
    )
    script.add_argument("project", type=Path, metavar="PROJECT")
    script.add_argument("--output", type=Path, metavar="FILE", help="default: print it")
    json_option(script)

    batch = command(
        commands, "batch", "calibrate all projects in folders, targets as picked, into a table"
    )
    batch.add_argument(
        "folders", type=Path, nargs="+", metavar="FOLDER", help="searched for projects at any depth"
    )
    batch.add_argument("--output", type=Path, metavar="TABLE", help="the table as CSV")
    batch.add_argument(
        "--save", action="store_true",
        help="save what is found in the projects (default: they stay as they are)",
    )  # fmt: skip
    batch.add_argument(
        "--reports", type=Path, metavar="DIR", help="write each project's report in this folder"
    )
    batch.add_argument(
        "--report-format", choices=("pdf", "html", "json", "zip"), help="of the reports: pdf"
    )
    batch.add_argument(
        "--template", type=Path, metavar="FILE", help="of the reports; see `lispac report --help`"
    )
    json_option(batch)
