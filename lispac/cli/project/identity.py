"""``lispac identity``: person, date and equipment for the report."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import opened_project, print_json
from lispac.errors import InputError
from lispac.identity import FIELD_HINTS, FIELD_LABELS, FIELD_NAMES
from lispac.messages import error

if TYPE_CHECKING:
    from lispac.project import Project

AUTO_DATES = "auto"
"""Value of ``--dates`` for the dates from the times of the lines."""


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    for name in FIELD_NAMES:
        hint = FIELD_HINTS[name]
        if name == "dates":
            hint += "; auto takes them from the times of the lines if these contain the date"
        parser.add_argument(f"--{name.replace('_', '-')}", metavar="TEXT", help=hint)
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Set the given fields, and print all fields."""
    from lispac.workflow.checking.calibration_history import first_date_in
    from lispac.workflow.project.projects import save_project

    values = {name: getattr(arguments, name) for name in FIELD_NAMES}
    texts = {name: text for name, text in values.items() if text is not None}
    with opened_project(arguments.project, change=bool(texts)) as project:
        if texts.get("dates") == AUTO_DATES:
            texts["dates"] = _require_survey_dates(project)
        if texts:
            project = project.with_identity(project.identity.changed(**texts))
            save_project(project)
    dates = project.identity.dates
    if texts.get("dates") and first_date_in(dates) is None:
        print(
            f"note: the survey dates ({dates}) contain no date of the form 2026-03-04; lispac "
            "history omits this calibration.", file=sys.stderr,
        )  # fmt: skip
    if arguments.json:
        print_json(project.identity)
        return
    width = max(map(len, FIELD_LABELS.values())) + 2
    for name in FIELD_NAMES:
        first, *others = getattr(project.identity, name).splitlines() or ["-"]
        print(f"{FIELD_LABELS[name]:{width}s}{first}")
        for line in others:
            print(" " * width + line)


def _require_survey_dates(project: Project) -> str:
    from lispac.workflow.project.survey_dates import survey_dates

    found = survey_dates(project)
    if not found:
        raise InputError(error("cli.no_dates", project=project.name))
    return found
