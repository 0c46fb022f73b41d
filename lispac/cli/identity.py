"""``lispac identity``: person, date and equipment for the report."""

import sys
from argparse import Namespace
from dataclasses import asdict

from lispac.cli.console import opened_project, print_json
from lispac.errors import InputError
from lispac.identity import LABELS, NAMES
from lispac.messages import error
from lispac.project import Project
from lispac.workflow.checking.calibration_history import first_date_in
from lispac.workflow.project.projects import save_project
from lispac.workflow.project.survey_dates import survey_dates

AUTO = "auto"


def identity(arguments: Namespace) -> None:
    """Set the fields that are given, and show all of them."""
    values = {name: getattr(arguments, name) for name in NAMES}
    texts = {name: text for name, text in values.items() if text is not None}
    with opened_project(arguments.project, change=bool(texts)) as project:
        if texts.get("dates") == AUTO:
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
        print_json(asdict(project.identity))
        return
    width = max(map(len, LABELS.values())) + 2
    for name in NAMES:
        first, *others = getattr(project.identity, name).splitlines() or ["-"]
        print(f"{LABELS[name]:{width}s}{first}")
        for line in others:
            print(" " * width + line)


def _require_survey_dates(project: Project) -> str:
    found = survey_dates(project)
    if not found:
        raise InputError(error("cli.no_dates", project=project.name))
    return found
