"""``lispac compare``: agreement of calibrations of one mounting, or of methods of one survey."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, UsageError, opened_project, print_json, print_table
from lispac.cli.messages import console_text, print_messages
from lispac.errors import ProjectError
from lispac.messages import Message, error

if TYPE_CHECKING:
    from lispac.alternative_methods import Method
    from lispac.present.calibration.calibrations import (
        CalibrationDifferenceValues,
        CalibrationValues,
        CombinedCalibrations,
    )
    from lispac.present.calibration.methods import MethodValues
    from lispac.project import Project

METHOD_TEXTS: dict[Method, str] = {
    "natural planes": "adjustment with the validation planes instead of the targets",
    "targetless": "adjustment with surfaces detected automatically in the scene",
    "patch test": "alignment of the lines on common objects",
    "correspondences": "adjustment of pairs of points of the same place, from a file",
}
"""Description of each method."""


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "projects", type=Path, nargs="+", metavar="PROJECT",
        help="projects with the same mounting, the earliest first; with a single project its "
             "methods are compared",
    )  # fmt: skip
    parser.add_argument(
        "--compute",
        action="store_true",
        help="with a single project: run the methods without a result (natural planes, targetless, "
        "patch test) and save their results",
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Compare and combine calibrations; for a single project, compare its methods.

    Raises
    ------
    UsageError
        If options cannot be combined.
    """
    from lispac.present.calibration.calibrations import (
        CalibrationDifferenceValues,
        CalibrationValues,
        CombinedCalibrations,
    )
    from lispac.validation.repeatability import (
        combine_calibrations,
        compare_calibrations,
        single_calibration,
    )
    from lispac.workflow.checking.repeated_surveys import calibrations_of

    if len(arguments.projects) == 1:
        _compare_methods(arguments)
        return
    if arguments.compute:
        raise UsageError(
            "compare: --compute runs the other methods on a single project; give one project only."
        )
    compared = calibrations_of(arguments.projects)
    first, counted = compared.each[0], compared.counted
    only = len(compared.each) > len(counted) == 1
    found = [CalibrationValues.of(each) for each in compared.each]
    differences = [
        CalibrationDifferenceValues.of(compare_calibrations(first, each))
        for each in compared.each[1:]
    ]
    combined = CombinedCalibrations.of(
        single_calibration(counted[0]) if only else combine_calibrations(counted), counted
    )
    if arguments.json:
        from lispac.cli.json_outputs import ComparedCalibrationsOutput

        print_json(
            ComparedCalibrationsOutput(
                tuple(found), tuple(differences), combined, tuple(compared.messages)
            )
        )
        return
    _print_comparison(found, differences, combined)
    sys.stdout.flush()
    print_messages(compared.messages)


def _print_comparison(
    calibrations: Sequence[CalibrationValues],
    differences: Sequence[CalibrationDifferenceValues],
    combined: CombinedCalibrations,
) -> None:
    from lispac.present.calibration.calibrations import (
        CALIBRATIONS_TABLE,
        PROBABILITY,
        differences_table,
    )

    print_table(CALIBRATIONS_TABLE, [*calibrations, *combined.rows()])
    print_table(differences_table(calibrations[0].name), differences)
    if len(combined.counted) > 2:
        relation = "MORE than" if combined.differ else "as"
        print(
            f"All calibrations scatter {relation} expected from their sigmas "
            f"(p = {PROBABILITY.text(combined.probability)})."
        )


def _compare_methods(arguments: Namespace) -> None:
    """Print the results of the methods; ``--compute`` runs the missing ones.

    Raises
    ------
    ProjectError
        If no method has a result.
    """
    from lispac.method_comparison import comparison_messages, method_results, missing_methods
    from lispac.present.calibration.methods import MethodValues

    refused: dict[str, Message] = {}
    with opened_project(arguments.projects[0], change=arguments.compute) as project:
        if arguments.compute:
            project, refused = _run_missing_methods(project)
    found = method_results(project)
    if not found:
        raise ProjectError(error("cli.no_results", project=project.name))
    rows = [MethodValues.of(each) for each in found]
    if arguments.json:
        from lispac.cli.json_outputs import ComparedMethodsOutput

        print_json(
            ComparedMethodsOutput(
                tuple(rows), comparison_messages(found), missing_methods(project), refused
            )
        )
        return
    _print_methods(rows, comparison_messages(found))
    sys.stdout.flush()
    for method, why in refused.items():
        print(f"note: {method}: {console_text(why)}", file=sys.stderr)
    for method in missing_methods(project):
        if method not in refused:
            print(f"note: not run yet: {method} ({METHOD_TEXTS[method]})", file=sys.stderr)


def _run_missing_methods(project: Project) -> tuple[Project, dict[str, Message]]:
    """Run the missing methods, and return the project and the errors by method."""
    from lispac.progress import sub_progress
    from lispac.workflow.calibration.method_runs import run_missing_methods
    from lispac.workflow.project.projects import save_project
    from lispac.workflow.project.survey import load_survey

    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=sub_progress(progress, 0.0, 0.2))
        found, refused = run_missing_methods(
            project, survey, progress=sub_progress(progress, 0.2, 1.0)
        )
    save_project(found)
    return found, refused


def _print_methods(rows: Sequence[MethodValues], messages: Sequence[Message]) -> None:
    from lispac.present.calibration.methods import METHOD_RESULTS_TABLE, method_differences

    print_table(METHOD_RESULTS_TABLE, rows)
    if len(rows) > 1:
        print_table(*method_differences(rows))
    for message in messages:
        print(console_text(message))
    for each in rows:
        for message in each.messages:
            print(f"{each.method}: {console_text(message)}")
