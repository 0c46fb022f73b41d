"""From picked targets to the boresight."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.diagnostics.failure_causes import find_wrong_value
from lispac.adjustment.diagnostics.sign_check import is_sign_assumed, sign_agreement
from lispac.adjustment.least_squares import adjust, adjust_or_explain
from lispac.adjustment.model.common_target_parts import find_common_parts
from lispac.adjustment.model.observations import CommonCoverage, Observations, Sighting
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import AdjustmentResult, EstimateWithoutControl
from lispac.computing_time import computing_time
from lispac.control_points import control_observations, controlled_targets
from lispac.design.further_line_advice import further_line_advice
from lispac.duplicate_targets import single_line_notes
from lispac.errors import AdjustmentError, NotConverged, RankDeficient, TargetDisagrees
from lispac.language import gettext_lazy
from lispac.messages import Level, Message, as_message, error
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project, Settings
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import Poses
from lispac.targets.thinning import thin_points
from lispac.workflow.calibration.orientation_check import have_targets_single_orientation
from lispac.workflow.calibration.reselection import reselect_targets
from lispac.workflow.control.control_assignment import (
    is_assignment_current,
    with_assigned_control,
)
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

MAX_RESELECTIONS = 3
"""Largest number of repeated selections of the points. Each reduces the error caused by the smeared
surfaces of the previous selection to about a third."""

MAX_DATA_WARNINGS = 3
"""Largest number of warnings about the data in the error of a failed adjustment."""

SELECTION_SPACING = 0.1
"""Spacing of the points used in the adjustments between selections, metres. The near end of a
surface may have hundreds of times the density of the far end, and would otherwise dominate."""

MAX_FORM_ERROR_M, MAX_RMS_M = 0.03, 0.1
"""Sigma of the form errors and RMS distance from which a result is implausible, metres: targets are
chosen flat, and POS errors of this size are rare."""

CONVERGENCE_LIMIT = 0.1
"""Change of an angle, as a share of its sigma, below which the selection is not repeated.
All three angles must satisfy it."""


def observations_of(
    project: Project,
    survey: Survey,
    *,
    settings: Settings | None = None,
    mounting: Mounting | None = None,
) -> Observations:
    """Thinned observations of the adjustment from the points of all used sightings.

    Neighbouring points are averaged; with independent POS errors one of them is kept, as in the
    thesis.

    Parameters
    ----------
    settings : Settings, optional
        Settings to use instead of the project's.
    mounting : Mounting, optional
        Mounting with which the points are placed to find neighbours; the prior by default.

    Raises
    ------
    AdjustmentError
        If no target has sightings on two lines, or one and control.
    RankDeficient
        If all used sightings are on one line, and there is no control.
    InputError
        If the control was imported with another origin of the local frame.
    """
    settings = settings or project.settings
    averages = settings.pos_errors == "correlated"
    _require_two_lines(project)
    # A warning names the targets that are not compared: see `lispac.duplicate_targets`
    targets = project.compared_targets
    sightings: list[Sighting] = []
    indices = []
    for target in targets:
        for sighting in target.used_sightings:
            chosen = sighting.indices
            if not averages:
                chosen = chosen[
                    thin_points(survey.clouds[sighting.line][chosen], settings.subsample)
                ]
            indices.append(chosen)
            sightings.append(Sighting(target.name, sighting.line))
    if not sightings:
        raise AdjustmentError(_no_target_message(project))
    parts = [survey.scans[s.line].take(i) for s, i in zip(sightings, indices, strict=True)]
    points = np.concatenate([points for points, _ in parts])
    time = np.concatenate([times for _, times in parts])
    poses = survey.trajectory.at(time + settings.latency)
    sigma_position, sigma_attitude = survey.accuracy.at(time)
    observations = Observations(
        points_lidar=points,
        position=poses.position,
        attitude=poses.attitude,
        sigma_lidar=settings.lidar_noise.sigmas(points),
        beam_sigmas=settings.lidar_beam_sigma is not None,
        sigma_position=sigma_position,
        sigma_attitude=sigma_attitude,
        pose_rate=survey.trajectory.rate_at(time + settings.latency),
        latency=settings.latency,
        time=time,
        sighting=np.repeat(np.arange(len(sightings)), [len(i) for i in indices]),
        sightings=tuple(sightings),
        radii={each.name: each.sphere_radius for each in targets if each.shape == "sphere"},
        control=control_observations(
            project.control, {each.name for each in targets}, survey.trajectory.frame.origin_deg_m
        ),
    )
    if not averages:
        return observations
    return thin_observations(observations, mounting or project.mounting("prior"), settings)


def _no_target_message(project: Project) -> Message:
    """Reason why no target can be used: none was picked, or none is on two lines."""
    alone = [each.name for each in project.targets_of_role("target") if each.used_sightings]
    if alone:
        return error("estimate.no_common_target", targets=alone)
    return error("estimate.no_target", project=project.name)


def thin_observations(
    observations: Observations, mounting: Mounting, settings: Settings
) -> Observations:
    """Thin observations by averaging neighbours; with independent POS errors one of them is kept.

    Parameters
    ----------
    mounting : Mounting
        Mounting with which the points are placed to find neighbours.
    settings : Settings
        Settings with the distance of neighbours and the stochastic model.
    """
    if settings.pos_errors == "correlated":
        return average_points_in_cells(
            observations,
            mounting,
            settings.subsample,
            longest=settings.stochastic_model.knot_interval,
            no_outliers=settings.stochastic_model.loss != "none",
        )
    poses = Poses(observations.position, observations.attitude)
    points = place_points(observations.points_lidar, poses, mounting)
    keep = np.zeros(len(observations), dtype=bool)
    for k in range(len(observations.sightings)):
        own = np.flatnonzero(observations.sighting == k)
        keep[own[thin_points(points[own], settings.subsample)]] = True
    return observations.where(keep)


def _used_lines(project: Project) -> set[str]:
    """Lines of the used sightings of targets."""
    return {
        sighting.line
        for target in project.targets_of_role("target")
        for sighting in target.used_sightings
    }


def _with_control_of_targets(project: Project, selected: Project, survey: Survey) -> Project:
    """Project whose control is assigned to its targets, with the surfaces of ``selected``."""
    if is_assignment_current(selected) and not is_assignment_current(project):
        project = project.with_control(selected.control)
    return with_assigned_control(project, survey, near=selected)


def _require_two_lines(project: Project) -> None:
    lines = _used_lines(project)
    if len(lines) == 1 and not controlled_targets(project.control):
        raise RankDeficient(error("estimate.one_line", line=lines.pop()))


def with_lidar_noise(observations: Observations, settings: Settings) -> Observations:
    """Observations with the given LiDAR noise, on each axis or along and across the beam."""
    return replace(
        observations,
        sigma_lidar=settings.lidar_noise.sigmas(observations.points_lidar),
        beam_sigmas=settings.lidar_beam_sigma is not None,
    )


def estimate(
    project: Project,
    survey: Survey,
    *,
    settings: Settings | None = None,
    reselections: int = MAX_RESELECTIONS,
    cross_check: bool = True,
    progress: Progress = no_progress,
) -> Project:
    """Adjust the boresight on the project's targets.

    Parameters
    ----------
    settings : Settings, optional
        Settings to use instead of the project's.
    reselections : int
        Largest number of repeated selections of the points; 0 uses the picked points.
    cross_check : bool
        Whether to adjust parts of the data, too.

    Raises
    ------
    AdjustmentError
        If the targets and lines do not determine a result.
    """
    settings = settings or project.settings
    settings.require_sound()
    if settings != project.settings:
        project = project.with_settings(settings)
    project = project.with_data_messages(survey.messages)
    started = computing_time()
    selected = reselect_points(
        project, survey, rounds=reselections, progress=sub_progress(progress, 0.0, 0.7)
    )
    solved = adjust_selected(
        project,
        selected,
        survey,
        cross_check=cross_check,
        progress=sub_progress(progress, 0.7, 1.0),
    )
    assert solved.result is not None
    result = replace(solved.result, elapsed=computing_time() - started)
    return replace(solved, result=result)


@contextmanager
def _add_failure_causes(project: Project, survey: Survey) -> Iterator[None]:
    """Add possible causes to the reason of an adjustment without a solution.

    Warnings about the files are no causes if the targets are too few anyway, or if the search for
    causes found one with which the adjustment converges.

    Raises
    ------
    NotConverged
        If the adjustment did not converge.
    RankDeficient
        If a parameter is not determined.
    TargetDisagrees
        The original error, with the causes added.
    """
    try:
        yield
    except (NotConverged, RankDeficient) as failure:
        warnings = [each for each in survey.messages if each.level is Level.WARNING]
        targets = [each for each in project.targets_of_role("target") if each.used]
        is_explained = failure.code == "estimate.possible_cause"
        if is_explained or len(targets) < 2 or have_targets_single_orientation(project, survey):
            warnings = []
        alone = single_line_notes(project)
        reason = as_message(failure.reason)
        causes: list[Message | str] = [*alone, *warnings[:MAX_DATA_WARNINGS]]
        for cause in causes:
            reason = error(
                "estimate.possible_cause", reason=reason, cause=cause, subject=reason.subject
            )
        if isinstance(failure, TargetDisagrees):
            raise TargetDisagrees(reason, failure.target) from None
        raise type(failure)(reason) from None


def reselect_points(
    project: Project,
    survey: Survey,
    *,
    rounds: int = MAX_RESELECTIONS,
    progress: Progress = no_progress,
) -> Project:
    """Select the points of the targets again with a boresight that is estimated between selections.

    The points were picked with the prior boresight, whose error smears surfaces scanned from a
    moving platform. The returned project is for `adjust_selected`; the picked points of the given
    project are not changed.
    """
    if len(_used_lines(project)) < 2:  # determined by its control only
        project = with_assigned_control(project, survey)
    settings, selected = project.settings, replace(project, result=None)
    prior = project.mounting("prior")
    coarse = replace(
        settings,
        pos_errors="independent",
        subsample=max(settings.subsample, SELECTION_SPACING),
        parameters=(),
    )
    # Everything else of the stochastic model is that of the project.
    coarse_model = replace(
        settings.stochastic_model, pos_errors="independent", loss="none", lever_arm_sigma=None
    )
    angles = prior.boresight
    for k in range(rounds):
        step = sub_progress(progress, k / rounds, (k + 1) / rounds)
        step(
            0.0,
            gettext_lazy(
                "Reselecting the points: iteration {number:n} of {count:n}",
                number=k + 1,
                count=rounds,
            ),
        )
        # The correlated model would treat points of another surface as POS errors. With
        # independent errors they remain visible as residuals.
        with _add_failure_causes(project, survey):
            thinned = observations_of(selected, survey, settings=coarse)
            result = adjust_or_explain(
                thinned, prior, coarse_model,
                accept_single_orientation=settings.accept_single_orientation, diagnostics=False,
            )  # fmt: skip
        changes = np.abs(result.boresight - angles)
        if k > 0 and (changes < CONVERGENCE_LIMIT * result.sigma).all():
            break
        angles = result.boresight
        selected = reselect_targets(selected.with_result(result), survey, progress=step)
    return selected


def adjust_selected(
    project: Project,
    selected: Project,
    survey: Survey,
    *,
    model: StochasticModel | None = None,
    cross_check: bool = True,
    advise: bool = True,
    progress: Progress = no_progress,
) -> Project:
    """Adjust the points of ``selected`` in the sightings that ``project`` uses.

    The adjustment is fast enough for interactive changes, because excluding a target or line needs
    no new selection. Without ``advise`` no additional line is recommended; `complete_result` adds
    the recommendation and the cross-checks.

    Parameters
    ----------
    model : StochasticModel, optional
        Model to use unchanged. By default, that of the settings, whose correlation times are
        shortened if the residuals require it.
    """
    project = _with_control_of_targets(project, selected, survey)
    settings, prior = project.settings, project.mounting("prior")
    with _add_failure_causes(project, survey):
        observations, parts = _selected_observations(project, selected, survey)
        result = adjust_or_explain(
            observations,
            prior,
            model or settings.stochastic_model,
            parameters=settings.parameters,
            components=settings.variance_components,
            assumed=project.assumed_sigmas,
            accept_single_orientation=settings.accept_single_orientation,
            shorten_times=model is None,
            progress=sub_progress(progress, 0.0, 0.4 if cross_check else 1.0),
        )
        result = replace(
            result, without_control=_estimate_without_control(project, result, observations)
        )
    result = replace(
        result,
        common_parts=parts,
        lidar_noise_from_residuals=settings.is_lidar_noise_from_residuals,
    )
    observations = observations.without_targets(result.excluded_targets)
    # A linear estimate of a wrong value is itself wrong if the residuals are implausibly large
    result = _with_wrong_value(project, survey, result, sub_progress(progress, 0.4, 0.7))
    if advise:
        result = _with_advice(result, observations)
    solved = project.with_result(result)
    return (
        _with_cross_checks(solved, observations, sub_progress(progress, 0.7, 1.0))
        if cross_check
        else solved
    )


def _estimate_without_control(
    project: Project, result: AdjustmentResult, observations: Observations
) -> EstimateWithoutControl | None:
    """Estimate of the same observations without the control; None if there is none."""
    if not result.control:
        return None
    settings = project.settings
    try:
        alone = adjust(
            replace(observations, control=None),
            project.mounting("prior"),
            settings.stochastic_model,
            parameters=settings.parameters,
            components=settings.variance_components,
            assumed=project.assumed_sigmas,
            accept_single_orientation=settings.accept_single_orientation,
        )
    except AdjustmentError:
        return None  # the control is needed
    return EstimateWithoutControl(alone.angles, alone.sigma, alone.parameters)


def complete_result(
    project: Project,
    selected: Project,
    survey: Survey,
    *,
    cross_check: bool = True,
    progress: Progress = no_progress,
) -> Project:
    """Complete a result with the parts omitted for speed: the additional line and cross-checks.

    Used after `adjust_selected` without ``advise``. The result is the same except for the note on
    an additional line.
    """
    assert project.result is not None
    observations, _ = _selected_observations(project, selected, survey)
    observations = observations.without_targets(project.result.excluded_targets)
    result = _with_advice(project.result, observations)
    advised = replace(project, result=result)
    return _with_cross_checks(advised, observations, progress) if cross_check else advised


def _with_advice(result: AdjustmentResult, observations: Observations) -> AdjustmentResult:
    """Result with the additional line that would improve the precision most."""
    # The additional line is assessed with the sigmas of the complete adjustment.
    scaled = observations.with_scaled_sigmas(*result.sigma_factors)
    seen = result.observability
    if seen is None or not (found := further_line_advice(scaled, result)):
        return result
    messages = (*seen.messages, *found)
    return replace(result, observability=replace(seen, messages=messages))


def _with_wrong_value(
    project: Project, survey: Survey, result: AdjustmentResult, progress: Progress
) -> AdjustmentResult:
    """Result with a wrong value of the mounting as the only cause, if it displaces the targets.

    With an error of about a metre, the points that are selected again are those of other surfaces,
    in which the error is not visible; the picked points still show it.
    """
    is_plausible = result.surface < MAX_FORM_ERROR_M and result.rms_after < MAX_RMS_M
    settings = project.settings
    if is_plausible or settings.pos_errors != "correlated":
        return result
    thinned = replace(
        settings, pos_errors="independent", subsample=max(settings.subsample, SELECTION_SPACING)
    )
    picked = observations_of(replace(project, result=None), survey, settings=thinned)
    cause = find_wrong_value(
        picked, project.mounting("prior"), settings.stochastic_model, result,
        parameters=settings.parameters, progress=progress,
    )  # fmt: skip
    return result if cause is None else replace(result, causes=((cause,),))


def _selected_observations(
    project: Project, selected: Project, survey: Survey
) -> tuple[Observations, tuple[CommonCoverage, ...]]:
    """Observations from the points of ``selected`` in the used sightings, and the removed parts.

    Raises
    ------
    AdjustmentError
        If no two lines observe a common part of any target.
    """
    near = selected.result.mounting if selected.result else project.mounting("prior")
    observations = observations_of(
        project.with_points_of(selected), survey, settings=project.settings, mounting=near
    )
    if selected.result is None:  # the prior boresight displaces the lines
        return observations, ()
    observations, parts = find_common_parts(observations, near)
    if not len(observations):
        raise AdjustmentError(error("estimate.no_common_part", targets=[p.target for p in parts]))
    return observations, parts


def _with_cross_checks(project: Project, observations: Observations, progress: Progress) -> Project:
    """Project with cross-checks, and with a check of the signs of roll and pitch if assumed."""
    result = project.result
    assert result is not None
    # The parts are adjusted with the sigmas of the complete adjustment.
    observations = observations.with_scaled_sigmas(*result.sigma_factors)
    prior, parameters = project.mounting("prior"), project.settings.parameters
    checks = cross_checks(observations, prior, result, parameters, progress=progress)
    if is_sign_assumed(project.data_messages) and (
        found := sign_agreement(observations, prior, result, parameters)
    ):
        project = replace(project, result=replace(result, messages=(*result.messages, found)))
    return project.with_cross_checks(checks)


def count_points(project: Project, survey: Survey, settings: Settings) -> int:
    """Number of points that would be used with these settings."""
    return len(observations_of(project, survey, settings=settings))
