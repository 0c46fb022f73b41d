"""Alternative methods: results that do not use the targets of a project."""

from dataclasses import replace

import numpy as np

from lispac.errors import AdjustmentError
from lispac.messages import Message, as_message, error
from lispac.methods import missing
from lispac.opinions import Method, Opinion
from lispac.patchtest.answer import PatchTest
from lispac.progress import Progress, no_progress, part
from lispac.project import Project
from lispac.workflow import patch_test
from lispac.workflow.calibration import estimate
from lispac.workflow.survey import Survey
from lispac.workflow.targetless import Targetless, targetless


def natural_planes(
    project: Project, survey: Survey, *, progress: Progress = no_progress
) -> Opinion:
    """Adjust the validation planes as if they were the targets.

    Raises
    ------
    AdjustmentError
        Where there are too few of them, or they face too few ways.
    """
    planes = tuple(
        replace(plane, role="target")
        for plane in project.of_role("validation")
        if plane.used and len(plane.used_sightings) > 1
    )
    if len(planes) < 2:
        raise AdjustmentError(error("estimate.few_validation_planes", project=project.name))
    solved = estimate(
        replace(project, targets=planes, result=None), survey, cross_check=False, progress=progress
    )
    assert solved.result is not None
    return _opinion("natural planes", solved)


def of_the_scene(found: Targetless) -> Opinion:
    """Result of a targetless adjustment, without its surfaces."""
    return _opinion("targetless", found.project, found.remarks)


def of_the_patch_test(found: PatchTest) -> Opinion:
    """Result of a patch test, without its objects.

    Raises
    ------
    AdjustmentError
        If it has no sigma: it could not be compared with another result.
    """
    if found.covariance is None:
        raise AdjustmentError(error("estimate.patch_test_without_sigma"))
    return Opinion(
        "patch test",
        found.boresight,
        found.covariance,
        found.lines,
        len(found.objects),
        found.remarks,
    )


def ask(
    project: Project, survey: Survey, method: Method, *, progress: Progress = no_progress
) -> Opinion:
    """Run a method; for the patch test, objects are searched for.

    Raises
    ------
    AdjustmentError
        Where the survey gives it no answer.
    """
    if method == "natural planes":
        return natural_planes(project, survey, progress=progress)
    if method == "targetless":
        return of_the_scene(targetless(project, survey, progress=progress))
    laid = patch_test.propose(project, survey, progress=part(progress, 0.0, 0.4))
    return of_the_patch_test(
        patch_test.find(project, survey, laid, progress=part(progress, 0.4, 1.0))
    )


def ask_missing(
    project: Project, survey: Survey, *, progress: Progress = no_progress
) -> tuple[Project, dict[str, Message]]:
    """The project with the answers of all methods; and why some have none, by method.

    Methods with a result are not run again.
    """
    found, wanted = project, missing(project)
    refused: dict[str, Message] = {}
    for k, method in enumerate(wanted):
        step = part(progress, k / len(wanted), (k + 1) / len(wanted))
        try:
            found = found.with_opinion(ask(project, survey, method, progress=step))
        except AdjustmentError as failure:
            refused[method] = as_message(failure.reason)
    return found, refused


def _opinion(method: Method, solved: Project, remarks: tuple[Message, ...] = ()) -> Opinion:
    assert solved.result is not None
    seen = [each.sighting for each in solved.result.sightings]
    on = {each.line for each in seen}
    return Opinion(
        method,
        solved.result.boresight,
        np.array(solved.result.covariance),
        tuple(line.name for line in solved.lines if line.name in on),
        len({each.target for each in seen}),
        remarks,
    )
