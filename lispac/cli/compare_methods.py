"""``lispac compare PROJECT``: results of alternative methods on the same lines."""

import sys
from argparse import Namespace
from typing import Any

import numpy as np

from lispac.adjustment.result import ANGLES
from lispac.alternative_methods import Method
from lispac.cli.console import ConsoleProgress, opened_project, print_json
from lispac.errors import ProjectError
from lispac.message_texts import english_text, message_text
from lispac.messages import Message, error
from lispac.method_comparison import (
    MethodResult,
    comparison_messages,
    method_results,
    missing_methods,
)
from lispac.progress import sub_progress
from lispac.project import Project
from lispac.workflow.calibration.method_runs import run_missing_methods
from lispac.workflow.project.projects import save_project
from lispac.workflow.project.survey import load_survey

METHOD_TEXTS: dict[Method, str] = {
    "natural planes": "adjustment with the validation planes instead of the targets",
    "targetless": "adjustment with surfaces detected automatically in the scene",
    "patch test": "alignment of the lines on common objects",
}
"""Description of each method."""


def compare_methods(arguments: Namespace) -> None:
    """Print the results of the methods; ``--compute`` runs the missing ones.

    Raises
    ------
    ProjectError
        Where no method has a result.
    """
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
                "methods": [_method_values(each) for each in found],
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
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=sub_progress(progress, 0.0, 0.2))
        found, refused = run_missing_methods(
            project, survey, progress=sub_progress(progress, 0.2, 1.0)
        )
    save_project(found)
    return found, refused


def _print_methods(results: tuple[MethodResult, ...]) -> None:
    width = max(len(each.method) for each in results) + 2
    heads = "".join(f"{f'{angle}, 1 sigma':>20s}" for angle in ANGLES)
    print(f"{'method':{width}s}{'lines':>6s}{'surfaces':>10s}{heads}  deg")
    for each in results:
        calibration = each.calibration
        angles, sigmas = np.degrees(calibration.boresight), np.degrees(calibration.sigma)
        cells = "".join(f"{a:+12.4f} {s:7.4f}" for a, s in zip(angles, sigmas, strict=True))
        print(f"{each.method:{width}s}{each.lines:6d}{each.surfaces:10d}{cells}")
    if len(results) > 1:
        print(f"\ndifference from {results[0].method}, and (difference / sigma)")
    for each in results:
        if each.against is not None:
            cells = "".join(
                f"{np.degrees(angle):+12.4f} {f'({over:+.1f})':>7s}"
                for angle, over in zip(each.against.angles, each.against.significance, strict=True)
            )
            print(f"{each.method:{width + 16}s}{cells}")
    for message in comparison_messages(results):
        print(message_text(message))
    for each in results:
        for message in each.messages:
            print(f"{each.method}: {message_text(message)}")


def _method_values(each: MethodResult) -> dict[str, Any]:
    calibration, against = each.calibration, each.against
    return {
        "method": each.method,
        "boresight_deg": np.degrees(calibration.boresight).tolist(),
        "sigma_deg": np.degrees(calibration.sigma).tolist(),
        "lines": each.lines,
        "surfaces": each.surfaces,
        "messages": [english_text(message) for message in each.messages],
        "difference_deg": None if against is None else np.degrees(against.angles).tolist(),
        "significance": None if against is None else against.significance.tolist(),
        "probability": None if against is None else against.probability,
        "differ": None if against is None else against.differ,
    }
