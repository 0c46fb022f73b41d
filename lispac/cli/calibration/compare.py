"""``lispac compare``: agreement of calibrations of one mounting, or of methods of one survey."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, UsageError, opened_project, print_json, print_table
from lispac.cli.messages import print_messages
from lispac.errors import ProjectError
from lispac.message_texts import english_text, message_text
from lispac.messages import Message, error

if TYPE_CHECKING:
    import numpy as np

    from lispac.alternative_methods import Method
    from lispac.method_comparison import MethodResult
    from lispac.project import Project
    from lispac.validation.repeatability import (
        Calibration,
        CalibrationDifference,
        RepeatedCalibrations,
    )

EFFECT_DISTANCES_M = (10.0, 50.0, 100.0)
"""Distances from the scanner for which the effect of a difference on a point is printed."""
METHOD_TEXTS: dict[Method, str] = {
    "natural planes": "adjustment with the validation planes instead of the targets",
    "targetless": "adjustment with surfaces detected automatically in the scene",
    "patch test": "alignment of the lines on common objects",
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
    found, counted = compared.each, compared.counted
    only = len(found) > len(counted) == 1
    combined = single_calibration(counted[0]) if only else combine_calibrations(counted)
    against = [compare_calibrations(found[0], each) for each in found[1:]]
    if arguments.json:
        print_json(
            {
                "calibrations": [_calibration_values(each) for each in found],
                "differences": [_difference_values(each) for each in against],
                "combined": _combined_values(combined)
                | {"counted": [each.name for each in counted]},
                "messages": list(map(message_text, compared.messages)),
            }
        )
        return
    _print_comparison(found, against, combined, len(counted))
    sys.stdout.flush()
    print_messages(compared.messages)


def _print_comparison(
    calibrations: Sequence[Calibration],
    against: Sequence[CalibrationDifference],
    combined: RepeatedCalibrations,
    counted: int,
) -> None:
    import numpy as np

    from lispac.adjustment.result import ANGLES

    width = max(12, *(len(each.name) for each in calibrations)) + 2
    heads = "".join(f"{f'{angle}, 1 sigma':>20s}" for angle in ANGLES)
    print(f"{'calibration':{width}s}{heads}  deg")
    for each in calibrations:
        print(f"{each.name:{width}s}{_angle_cells(each.boresight, each.sigma)}")
    print(f"{'all together':{width}s}{_angle_cells(combined.boresight, combined.sigma)}")
    if combined.spread is not None:
        print(f"{'spread':{width}s}" + "".join(f"{v:20.4f}" for v in np.degrees(combined.spread)))
    print(f"\ndifference from {calibrations[0].name}, and (difference / sigma)")
    for change in against:
        cells = "".join(
            f"{np.degrees(angle):+12.4f} {f'({significance:+.1f})':>7s}"
            for angle, significance in zip(change.angles, change.significance, strict=True)
        )
        print(f"{change.second:{width}s}{cells}")
        effects = ", ".join(
            f"{100 * change.largest_displacement(far):.1f} cm at {far:.0f} m"
            for far in EFFECT_DISTANCES_M
        )
        verdict = "DIFFER" if change.differ else "agree"
        print(
            f"{'':{width}s}  {verdict} ({_probability_text(change.probability)}); "
            f"point shift {effects}"
        )
    if counted > 2:
        relation = "MORE than" if combined.differ else "as"
        words = f"scatter {relation} expected from their sigmas"
        print(f"\nall calibrations {words} ({_probability_text(combined.probability)})")


def _probability_text(probability: float) -> str:
    return f"p = {probability:.3f}" if probability >= 0.001 else "p < 0.001"


def _angle_cells(angles: np.ndarray, sigmas: np.ndarray) -> str:
    import numpy as np

    return "".join(
        f"{angle:+12.4f} {sigma:7.4f}"
        for angle, sigma in zip(np.degrees(angles), np.degrees(sigmas), strict=True)
    )


def _calibration_values(each: Calibration) -> dict[str, Any]:
    import numpy as np

    return {
        "name": each.name,
        "boresight_deg": np.degrees(each.boresight).tolist(),
        "sigma_deg": np.degrees(each.sigma).tolist(),
    }


def _difference_values(each: CalibrationDifference) -> dict[str, Any]:
    import numpy as np

    return {
        "first": each.first,
        "second": each.second,
        "angles_deg": np.degrees(each.angles).tolist(),
        "sigma_deg": np.degrees(each.sigma).tolist(),
        "significance": each.significance.tolist(),
        "significant": list(each.significant),
        "chi_square": each.statistic,
        "probability": each.probability,
        "differ": each.differ,
        "rotation_deg": float(np.degrees(each.turn)),
        "distances_m": list(EFFECT_DISTANCES_M),
        "displacement_m": [each.largest_displacement(d) for d in EFFECT_DISTANCES_M],
    }


def _combined_values(each: RepeatedCalibrations) -> dict[str, Any]:
    import numpy as np

    return {
        "boresight_deg": np.degrees(each.boresight).tolist(),
        "sigma_deg": np.degrees(each.sigma).tolist(),
        "spread_deg": None if each.spread is None else np.degrees(each.spread).tolist(),
        "chi_square": each.statistic,
        "probability": each.probability,
        "differ": each.differ,
    }


def _compare_methods(arguments: Namespace) -> None:
    """Print the results of the methods; ``--compute`` runs the missing ones.

    Raises
    ------
    ProjectError
        If no method has a result.
    """
    from lispac.method_comparison import comparison_messages, method_results, missing_methods
    from lispac.present.json_values import json_values
    from lispac.present.methods import MethodValues

    refused: dict[str, Message] = {}
    with opened_project(arguments.projects[0], change=arguments.compute) as project:
        if arguments.compute:
            project, refused = _run_missing_methods(project)
    found = method_results(project)
    if not found:
        raise ProjectError(error("cli.no_results", project=project.name))
    if arguments.json:
        print_json(
            {
                "methods": json_values([MethodValues.of(each) for each in found]),
                "messages": [english_text(each) for each in comparison_messages(found)],
                "missing": list(missing_methods(project)),
                "refused": {name: english_text(why) for name, why in refused.items()},
            }
        )
        return
    _print_methods(found)
    sys.stdout.flush()
    for method, why in refused.items():
        print(f"note: {method}: {message_text(why)}", file=sys.stderr)
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


def _print_methods(results: tuple[MethodResult, ...]) -> None:
    from lispac.method_comparison import comparison_messages
    from lispac.present.methods import METHOD_RESULTS_TABLE, MethodValues, method_differences

    rows = [MethodValues.of(each) for each in results]
    print_table(METHOD_RESULTS_TABLE, rows)
    if len(rows) > 1:
        print_table(*method_differences(rows))
    for message in comparison_messages(results):
        print(message_text(message))
    for each in results:
        for message in each.messages:
            print(f"{each.method}: {message_text(message)}")
