"""Validation: distances between lines on planes not used in the adjustment, before and after."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.result import AdjustmentResult
from lispac.errors import NotComparable, PlaneNotFound, ProjectError
from lispac.geometry.planes import fit_plane_robustly
from lispac.language import gettext_lazy
from lispac.messages import Message, as_message, error
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import PickedSighting, Project, Target
from lispac.validation.line_shifts import LineErrors, PlaneErrors
from lispac.validation.local_models import DEFAULT_MODEL, LocalModel
from lispac.validation.plane_comparison import MIN_OVERLAP_POINTS, PlaneComparison, compare_plane
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

MAX_EFFECT_POINTS = 200
"""Largest number of points of a sighting at which the effects of errors are computed."""


def validate(
    project: Project,
    survey: Survey,
    *,
    model: LocalModel = DEFAULT_MODEL,
    progress: Progress = no_progress,
) -> Project:
    """Compare the lines on every used validation plane, before and after the calibration.

    Parameters
    ----------
    model : LocalModel
        Local model of the surface between the points of a line.

    Raises
    ------
    ProjectError
        If nothing has been estimated, or no validation plane is used.
    NotComparable
        If lines can be compared on none of the planes. If this applies only to some planes, they
        are listed in ``not_compared`` instead.
    """
    placed = survey.placed(project, "estimated")
    planes = [plane for plane in project.targets_of_role("validation") if plane.used]
    if not planes:
        raise ProjectError(error("validate.no_planes", project=project.name))
    comparisons: list[PlaneComparison] = []
    not_compared: dict[str, Message] = {}
    reasons: list[Message | str] = []
    for k, plane in enumerate(planes):
        step = sub_progress(progress, k / len(planes), (k + 1) / len(planes))
        step(0.0, gettext_lazy("Comparing the lines on {target}", target=plane.name))
        before, after, ranges = {}, {}, {}
        for sighting in plane.used_sightings:
            before[sighting.line] = survey.clouds[sighting.line][sighting.indices]
            after[sighting.line] = placed[sighting.line][sighting.indices]
            points_lidar, _ = survey.scans[sighting.line].take(sighting.indices)
            ranges[sighting.line] = np.linalg.norm(points_lidar, axis=1)
        facing = survey.trajectory.position.mean(axis=0) - np.array(plane.seed)
        try:
            comparisons.append(
                compare_plane(
                    plane.name, before, after, survey.heading, model=model, facing=facing,
                    ranges=ranges, errors=_plane_errors(project, survey, plane, after, facing),
                    progress=step,
                )
            )  # fmt: skip
        except NotComparable as failure:
            not_compared[plane.name] = as_message(failure.reason)
            reasons.append(failure.reason)
    if not comparisons:
        refusal = reasons[0]
        for reason in reasons[1:]:
            refusal = error("validate.also", first=refusal, reason=reason)
        raise NotComparable(refusal)
    return project.with_validation(tuple(comparisons), not_compared)


def _plane_errors(
    project: Project, survey: Survey, plane: Target, points: Mapping[str, Array], facing: Array
) -> PlaneErrors | None:
    """Effects of POS, boresight and form errors on the distances between lines on a plane.

    None if fewer than two lines have enough points on it, or these lie on one straight line.
    """
    result = project.result
    assert result is not None
    sightings = [s for s in plane.used_sightings if len(s.indices) >= MIN_OVERLAP_POINTS]
    if len(sightings) < 2:
        return None
    try:
        fitted = fit_plane_robustly(
            np.concatenate([points[s.line] for s in sightings]), plane.threshold
        )
    except PlaneNotFound:
        return None
    normal = fitted.facing(facing).normal
    lines = {s.line: _line_errors(result, survey, s, normal) for s in sightings}
    return PlaneErrors(lines, (result.model.position_time, result.model.attitude_time))


def _line_errors(
    result: AdjustmentResult, survey: Survey, sighting: PickedSighting, normal: Array
) -> LineErrors:
    numbers = sighting.indices[:: -(-len(sighting.indices) // MAX_EFFECT_POINTS)]
    points_lidar, time = survey.scans[sighting.line].take(numbers)
    latency = result.mounting.latency
    return LineErrors.of(
        result, points_lidar, time, survey.trajectory.at(time + latency),
        survey.accuracy.at(time), normal, pose_rate=survey.trajectory.rate_at(time + latency),
    )  # fmt: skip


def validate_with_truth(
    project: Project, survey: Survey, *, progress: Progress = no_progress
) -> tuple[PlaneComparison, ...]:
    """Compare the lines on the validation planes with the simulated true boresight as "after".

    The remaining distances between the lines are due to the POS errors, which no boresight removes;
    they are the limit of what a calibration can achieve.

    Parameters
    ----------
    project : Project
        A simulated project with a validation, whose local surface model is used.

    Raises
    ------
    ProjectError
        If the survey is not simulated or has not been validated.
    """
    if project.truth_deg is None or project.result is None or not project.validation:
        raise ProjectError(error("validate.not_simulated", project=project.name))
    true = project.result.mounting.with_boresight(np.radians(project.truth_deg))
    placed = project.with_result(replace(project.result, mounting=true))
    model = project.validation[0].model
    return validate(placed, survey, model=model, progress=progress).validation
