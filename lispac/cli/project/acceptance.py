"""``lispac acceptance``: acceptance criteria of a project, and its judgement by them."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option, positive_number
from lispac.cli.console import opened_project, print_json, print_table
from lispac.errors import ProjectError
from lispac.messages import error

if TYPE_CHECKING:
    from lispac.project import Project

NO_LIMIT = "none"
"""Value of an option that removes a criterion."""


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    for angle in ("roll", "pitch", "yaw"):
        parser.add_argument(
            f"--{angle}-sigma", dest=f"{angle}_sigma_deg", type=_limit, metavar="DEG",
            help=f"largest standard deviation of {angle}, degrees, or none",
        )  # fmt: skip
    parser.add_argument(
        "--rms", type=_limit, metavar="M",
        help="largest RMS of the distances between the lines on a validation plane after the "
             "calibration, metres, or none",
    )  # fmt: skip
    parser.add_argument(
        "--p95", type=_limit, metavar="M",
        help="95 %% of the distances between the lines on a validation plane after the "
             "calibration must be smaller, metres, or none",
    )  # fmt: skip
    parser.add_argument(
        "--offset", type=_limit, metavar="M",
        help="largest median distance between two lines on a validation plane after the "
             "calibration, metres, or none",
    )  # fmt: skip
    parser.add_argument(
        "--source", metavar="TEXT", help="document that gives the criteria, for the report"
    )
    parser.add_argument(
        "--require-pass", action="store_true", help="exit with code 1 unless the verdict is pass"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Set the given criteria, and print all criteria and the judgement.

    Raises
    ------
    ProjectError
        If the verdict is required to be pass, but is not.
    """
    from lispac.acceptance import FIELD_NAMES
    from lispac.present.checking.acceptance import AcceptanceValues
    from lispac.workflow.project.projects import save_project

    given = {name: getattr(arguments, name) for name in FIELD_NAMES}
    values = {
        name: None if value == NO_LIMIT and name != "source" else value
        for name, value in given.items()
        if value is not None
    }
    with opened_project(arguments.project, change=bool(values)) as project:
        if values:
            project = project.with_acceptance(project.acceptance.changed(**values))
            save_project(project)
    if arguments.json:
        print_json(AcceptanceValues.of(project.judgement))
    else:
        print_acceptance(project)
    verdict = project.judgement.verdict
    if arguments.require_pass and verdict != "pass":
        code = "cli.not_accepted" if verdict == "fail" else "cli.acceptance_not_judged"
        raise ProjectError(error(code, project=project.name))


def print_acceptance(project: Project) -> None:
    """Print all checks and the verdict."""
    from lispac.present.checking.acceptance import (
        AcceptanceValues,
        acceptance_table,
        calibration_verdict_text,
    )

    values = AcceptanceValues.of(project.judgement)
    if values.checks:
        print_table(acceptance_table(values.criteria.source), values.checks)
    verdict = calibration_verdict_text(values)
    reason = "" if values.checks else " (no acceptance criteria are given)"
    print(f"Acceptance: {verdict}{reason}")


def _limit(text: str) -> float | str:
    """Parse a limit: a positive number, or ``none``."""
    return NO_LIMIT if text == NO_LIMIT else positive_number(text)
