"""``lispac validate``: distances between the lines on planes not used in the adjustment."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option, finite_number
from lispac.cli.console import ConsoleProgress, UsageError, opened_project, print_json, print_table
from lispac.cli.messages import console_text, print_messages

if TYPE_CHECKING:
    from lispac.messages import Message
    from lispac.project import Project
    from lispac.workflow.project.survey import Survey


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--distance-to", choices=("point", "plane", "quadric"), default="plane",
        help="distance to the nearest point of the other line, or to a plane or quadric fitted to "
             "that point and its neighbours (default plane)",
    )  # fmt: skip
    parser.add_argument(
        "--neighbours", type=int, default=None, metavar="N",
        help="number of points to which the plane or quadric is fitted (default 40 for a plane, 60 "
             "for a quadric)",
    )  # fmt: skip
    parser.add_argument(
        "--radius",
        type=finite_number,
        metavar="M",
        help="fit the plane or quadric to all points within this radius (m) instead",
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Compare the lines on the validation planes, save the result, judge and print it.

    Raises
    ------
    UsageError
        If options cannot be combined.
    """
    from lispac.validation.local_models import DEFAULT_NEIGHBOURS, LocalModel
    from lispac.workflow.checking.validation import validate as validated
    from lispac.workflow.project import projects
    from lispac.workflow.project.survey import load_survey

    kind = arguments.distance_to
    if kind == "point" and not (arguments.radius is None and arguments.neighbours is None):
        raise UsageError(
            "validate: --radius and --neighbours do not apply to --distance-to point; omit them "
            "or use --distance-to plane."
        )
    usual = DEFAULT_NEIGHBOURS[kind]
    model = LocalModel(
        kind, usual if arguments.neighbours is None else arguments.neighbours, arguments.radius
    )
    with opened_project(arguments.project, change=True) as project:
        with ConsoleProgress() as progress:
            survey = load_survey(project, progress=progress)
            project = validated(project, survey, model=model, progress=progress)
        projects.save_project(project)
    true = rms_with_truth(project, survey)
    if arguments.json:
        from lispac.cli.json_outputs import ValidateOutput
        from lispac.present.checking.acceptance import AcceptanceValues
        from lispac.present.checking.validation import ValidationPlane

        print_json(
            ValidateOutput(
                tuple(map(ValidationPlane.of, project.validation)),
                true,
                tuple(project.not_compared.values()),
                AcceptanceValues.of(project.judgement),
                _warnings(project),
            )
        )
    else:
        print_validation(project, true)


def rms_with_truth(project: Project, survey: Survey) -> dict[str, float]:
    """RMS distance between the lines with the true boresight, metres, by validation plane.

    Empty for a real survey, whose true boresight is unknown.
    """
    from lispac.workflow.checking.validation import validate_with_truth

    if project.truth_deg is None:
        return {}
    return {each.name: each.after.rms for each in validate_with_truth(project, survey)}


def print_validation(project: Project, true: Mapping[str, float]) -> None:
    """Print the distances between the lines, one row for each plane, and the acceptance."""
    from lispac.cli.project.acceptance import print_acceptance
    from lispac.present.checking.validation import PLANE_DISTANCES_TABLE, ValidationPlane
    from lispac.present.tables import PLAIN_MILLIMETRES, Column

    table = PLANE_DISTANCES_TABLE
    if true:
        with_truth = Column[ValidationPlane](
            lambda plane: true.get(plane.name), "RMS with truth", PLAIN_MILLIMETRES
        )
        table = replace(table, columns=(*table.columns, with_truth))
    print_table(table, [ValidationPlane.of(each) for each in project.validation])
    for reason in project.not_compared.values():
        print(f"not compared: {console_text(reason)}")
    print_acceptance(project)
    print_messages(_warnings(project), sys.stdout)


def _warnings(project: Project) -> tuple[Message, ...]:
    """Warnings about the project and about the validation, as in the report."""
    from lispac.adjustment.diagnostics.cause_warnings import without_explained
    from lispac.duplicate_targets import project_warnings
    from lispac.present.calibration.cross_checks import cross_check_values
    from lispac.present.checking.acceptance import AcceptanceValues
    from lispac.present.checking.validation import ValidationPlane
    from lispac.report.validation_warnings import (
        acceptance_warnings,
        distribution_warnings,
        surface_model_warnings,
    )

    planes = [ValidationPlane.of(each) for each in project.validation]
    checks = None if project.cross_checks is None else cross_check_values(project.cross_checks)
    return without_explained(
        (
            *project_warnings(project),
            *acceptance_warnings(AcceptanceValues.of(project.judgement), planes, checks),
            *distribution_warnings(planes),
            *surface_model_warnings(planes),
        )
    )
