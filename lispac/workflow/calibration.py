"""From picked targets to the boresight."""

from collections.abc import Mapping
from dataclasses import replace
from time import perf_counter

import numpy as np

from lispac.adjustment.observations import Observations, Sighting
from lispac.adjustment.solver import adjust
from lispac.adjustment.stochastic import PosErrors, StochasticModel
from lispac.errors import AdjustmentError
from lispac.progress import Progress, no_progress, part
from lispac.project import Project
from lispac.targets.thinning import thin
from lispac.workflow.reselection import reselect
from lispac.workflow.survey import Survey

RESELECTIONS = 3
"""Each selection leaves about a third of the error that the smear of the one before it caused."""

SELECTION_SPACING = 0.1
"""Metres between the points that steer a selection: near a slow scanner a surface has hundreds of
points where its far end has one, and these must not decide alone."""

SETTLED = 0.1
"""Share of its sigma by which an angle may move when no further selection is worth its time."""


def observations_of(
    project: Project, survey: Survey, *, subsample: float | None = None
) -> Observations:
    """Thin the points of every used sighting and bring them into the adjustment's form.

    Parameters
    ----------
    subsample : float, metres, optional
        In place of the project's setting.

    Raises
    ------
    AdjustmentError
        Where no target, or a target on one line only, is left.
    """
    sightings: list[Sighting] = []
    indices = []
    distance = project.settings.subsample if subsample is None else subsample
    for target in project.of_role("target"):
        used = target.used_sightings
        if not target.used:
            continue
        if len(used) < 2:
            where = f"on line {used[0].line} only" if used else "on no line"
            raise AdjustmentError(
                f"Target {target.name} is seen {where}, so nothing compares it; seed it on another "
                "line or leave the target out."
            )
        for sighting in used:
            points = survey.clouds[sighting.line][sighting.indices]
            indices.append(sighting.indices[thin(points, distance)])
            sightings.append(Sighting(target.name, sighting.line))
    if not sightings:
        raise AdjustmentError(
            f"{project.name}: there is no target to adjust; pick planar targets first."
        )
    scans = [survey.scans[sighting.line] for sighting in sightings]
    points = np.concatenate([s.points_lidar[i] for s, i in zip(scans, indices, strict=True)])
    time = np.concatenate([s.time[i] for s, i in zip(scans, indices, strict=True)])
    poses = survey.trajectory.at(time)
    sigma_position, sigma_attitude = survey.accuracy.at(time)
    return Observations(
        points_lidar=points,
        position=poses.position,
        attitude=poses.attitude,
        sigma_lidar=np.full(points.shape, project.settings.lidar_sigma),
        sigma_position=sigma_position,
        sigma_attitude=sigma_attitude,
        time=time,
        sighting=np.repeat(np.arange(len(sightings)), [len(i) for i in indices]),
        sightings=tuple(sightings),
    )


def estimate(
    project: Project,
    survey: Survey,
    *,
    subsample: float | None = None,
    pos_errors: PosErrors | None = None,
    reselections: int = RESELECTIONS,
    progress: Progress = no_progress,
) -> Project:
    """Adjust the boresight on the project's targets.

    The picks were made with the prior boresight, which smears a surface that is seen from a moving
    platform. So the points of each target are selected again with the boresight found, and the
    adjustment repeated; the picks in the project stay as they were.

    Parameters
    ----------
    subsample : float, metres, optional
        Changes the project's setting; 0 keeps all points.
    pos_errors : {"correlated", "independent"}, optional
        Changes the project's setting.
    reselections : int
        How often the points are selected again; 0 takes the picks as they are.

    Raises
    ------
    AdjustmentError
        Where targets and lines cannot give an answer.
    """
    settings = project.settings
    if subsample is not None:
        settings = replace(settings, subsample=subsample)
    if pos_errors is not None:
        settings = replace(settings, pos_errors=pos_errors)
    settings.require_sound()
    if settings != project.settings:
        project = project.with_settings(settings)
    started = perf_counter()
    prior, selected = project.mounting("prior"), project
    coarse = max(settings.subsample, SELECTION_SPACING)
    angles = prior.boresight
    for k in range(reselections):
        step = part(progress, 0.9 * k / reselections, 0.9 * (k + 1) / reselections)
        step(0.0, f"Selecting the points again, round {k + 1} of {reselections}")
        # Points of another surface among the picks would be taken for POS errors by the correlated
        # model; this one leaves them to stand out.
        thinned = observations_of(selected, survey, subsample=coarse)
        result = adjust(thinned, prior, StochasticModel("independent"))
        moved = np.abs(result.boresight - angles)
        if k > 0 and (moved < SETTLED * result.sigma).all():
            break
        angles = result.boresight
        selected = reselect(selected.with_result(result), survey, progress=step)
    result = adjust(
        observations_of(selected, survey),
        prior,
        StochasticModel(settings.pos_errors),
        progress=part(progress, 0.9, 1.0),
    )
    return project.with_result(replace(result, elapsed=perf_counter() - started))


def thinned_counts(
    project: Project, survey: Survey, subsample: float
) -> Mapping[tuple[str, str], int]:
    """Points that a subsampling distance would keep, by (target, line)."""
    return {
        (target.name, sighting.line): len(
            thin(survey.clouds[sighting.line][sighting.indices], subsample)
        )
        for target in project.of_role("target")
        for sighting in target.used_sightings
    }
