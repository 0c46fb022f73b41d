"""Computation of alternative methods, which do not use the project's targets."""

from dataclasses import replace

import numpy as np

from lispac.alternative_methods import AlternativeResult, Method
from lispac.errors import AdjustmentError
from lispac.messages import Message, as_message, error
from lispac.method_comparison import missing_methods
from lispac.patchtest.patch_test_result import PatchTestResult
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project
from lispac.workflow.calibration import patch_test
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.targetless import TargetlessResult, targetless
from lispac.workflow.project.survey import Survey


def adjust_natural_planes(
    project: Project, survey: Survey, *, progress: Progress = no_progress
) -> AlternativeResult:
    """Adjust the validation planes as if they were the targets.

    Raises
    ------
    AdjustmentError
        If there are fewer than two validation planes that are used on several lines, or they do not
        determine the boresight.
    """
    planes = tuple(
        replace(plane, role="target")
        for plane in project.targets_of_role("validation")
        if plane.used and len(plane.used_sightings) > 1
    )
    if len(planes) < 2:
        raise AdjustmentError(error("estimate.few_validation_planes", project=project.name))
    solved = estimate(
        replace(project, targets=planes, result=None), survey, cross_check=False, progress=progress
    )
    assert solved.result is not None
    return _alternative_result("natural planes", solved)


def targetless_result(result: TargetlessResult) -> AlternativeResult:
    """Result of a targetless adjustment, without its surfaces."""
    return _alternative_result("targetless", result.project, result.messages)


def with_targetless_result(project: Project, found: TargetlessResult) -> Project:
    """Add a targetless result to a project.

    In a project without used targets it becomes the result, and its surfaces become the targets. In
    other projects it is stored as the result of an alternative method.

    Raises
    ------
    AdjustmentError
        If a validation plane or an excluded target has the name of a surface.
    """
    former = set(project.result.noise_factors) if project.is_targetless and project.result else ()
    own = tuple(each for each in project.targets if each.name not in former)
    if any(each.role == "target" and each.used for each in own):
        return project.with_alternative_result(targetless_result(found))
    names = {each.name for each in own}
    shared = [each.name for each in found.project.targets if each.name in names]
    if shared:
        raise AdjustmentError(error("targetless.name_taken", count=len(shared), names=shared))
    kept = replace(project, targets=(*found.project.targets, *own))
    others = tuple(each for each in kept.alternative_results if each.method != "targetless")
    result = replace(found.result, messages=found.messages)
    return replace(kept.with_result(result), alternative_results=others)


def patch_test_result(result: PatchTestResult) -> AlternativeResult:
    """Result of a patch test, without its objects.

    Raises
    ------
    AdjustmentError
        If it has no sigma, which is needed to compare it with another result.
    """
    if result.covariance is None:
        raise AdjustmentError(error("estimate.patch_test_without_sigma"))
    return AlternativeResult(
        "patch test",
        result.boresight,
        result.covariance,
        result.lines,
        len(result.objects),
        result.messages,
    )


def run_method(
    project: Project, survey: Survey, method: Method, *, progress: Progress = no_progress
) -> AlternativeResult:
    """Run an alternative method; the patch test searches for its objects.

    Raises
    ------
    AdjustmentError
        If the method finds no result in this survey.
    """
    if method == "natural planes":
        return adjust_natural_planes(project, survey, progress=progress)
    if method == "targetless":
        return targetless_result(targetless(project, survey, progress=progress))
    placed = patch_test.propose_objects(project, survey, progress=sub_progress(progress, 0.0, 0.4))
    return patch_test_result(
        patch_test.find_boresight(
            project, survey, placed, progress=sub_progress(progress, 0.4, 1.0)
        )
    )


def run_missing_methods(
    project: Project, survey: Survey, *, progress: Progress = no_progress
) -> tuple[Project, dict[str, Message]]:
    """Run all methods without a result; returns the project, and errors by method.

    Methods with a result are not run again.
    """
    found, missing = project, missing_methods(project)
    refused: dict[str, Message] = {}
    for k, method in enumerate(missing):
        step = sub_progress(progress, k / len(missing), (k + 1) / len(missing))
        try:
            found = found.with_alternative_result(
                run_method(project, survey, method, progress=step)
            )
        except AdjustmentError as failure:
            refused[method] = as_message(failure.reason)
    return found, refused


def _alternative_result(
    method: Method, solved: Project, messages: tuple[Message, ...] = ()
) -> AlternativeResult:
    assert solved.result is not None
    seen = [each.sighting for each in solved.result.sightings]
    on = {each.line for each in seen}
    return AlternativeResult(
        method,
        solved.result.boresight,
        np.array(solved.result.covariance),
        tuple(line.name for line in solved.lines if line.name in on),
        len({each.target for each in seen}),
        messages,
    )
