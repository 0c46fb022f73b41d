"""Error budget of a project's system at given distances."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.error_budget import (
    DEFAULT_DISTANCES,
    DEFAULT_INCIDENCE,
    ErrorBudget,
    SystemErrors,
    error_budget,
)
from lispac.errors import InputError, ProjectError
from lispac.messages import error
from lispac.project import Project
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

TIMES_PER_LINE = 1_000
"""Number of times of each line at which accuracies and rates are interpolated."""


def error_budget_of(
    project: Project,
    survey: Survey,
    distances: Sequence[float] = DEFAULT_DISTANCES,
    *,
    lever_sigma: Sequence[float] | None = None,
    divergence: float | None = None,
    incidence: float = DEFAULT_INCIDENCE,
) -> ErrorBudget:
    """Error budget of a point by source of error.

    Parameters
    ----------
    distances : metres from the scanner
    lever_sigma : three of float, metres, optional
        Standard deviations of the lever arm: forward, left, up; by default those of the project.
    divergence : float, radians, optional
        Full angle of the beam divergence; by default that of the project.
    incidence : float, radians
        Angle between the beam and the normal of the surface.

    Raises
    ------
    ProjectError
        If nothing has been estimated.
    InputError
        If a distance, a sigma or an angle is not valid.
    """
    result = project.result
    if result is None:
        raise ProjectError(error("estimate.needed", project=project.name))
    settings = project.settings
    if lever_sigma is None:
        lever_sigma = settings.lever_arm_sigma
    if divergence is None and settings.beam_divergence_mrad is not None:
        divergence = settings.beam_divergence_mrad / 1000
    if lever_sigma is not None and not all(0.0 <= each < np.inf for each in lever_sigma):
        raise InputError(error("estimate.lever_arm_sigma"))
    names, covariance = result.mounting_covariance(lever_sigma)
    latency = result.mounting.latency
    time = _times_on_lines(survey, latency)
    position, attitude = survey.accuracy.at(time)
    rate = survey.trajectory.rate_at(time + latency)
    lidar, of_position, of_attitude = result.sigma_factors
    beam = settings.lidar_beam_sigma
    return error_budget(
        SystemErrors(
            position=of_position * np.median(position, axis=0),
            attitude=of_attitude * np.median(attitude, axis=0),
            lidar=(lidar * beam[0], lidar * float(np.radians(beam[1])))
            if beam
            else lidar * settings.used_lidar_sigma,
            mounting=result.mounting,
            prior_boresight=result.prior_boresight,
            estimated=names,
            covariance=covariance,
            speed=float(np.median(np.linalg.norm(rate[:, :3], axis=1))),
            rates=np.sqrt(np.mean(rate[:, 3:] ** 2, axis=0)),
            divergence=divergence,
            incidence=incidence,
        ),
        distances,
    )


def _times_on_lines(survey: Survey, latency: float) -> NDArray[np.float64]:
    """Times of the lines at which the trajectory is known, seconds."""
    time = np.concatenate(
        [
            np.linspace(scan.first_time, scan.last_time, TIMES_PER_LINE + 2)[1:-1]
            for scan in survey.scans.values()
        ]
    )
    return time[survey.trajectory.covers(time + latency)]
