"""Dependence of the result on the subsampling distance (thesis table 4.3).

Because the points of a sighting share errors, additional points of the same sighting soon add no
information, but only computing time.
"""

from collections.abc import Sequence
from dataclasses import replace
from time import perf_counter

import numpy as np

from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.errors import InputError, ProjectError
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.present.angles import degrees
from lispac.present.calibration.subsampling import SubsamplingValues
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project
from lispac.workflow.calibration.estimation import adjust_selected, reselect_points
from lispac.workflow.project.survey import Survey

DEFAULT_DISTANCES = (0.0, 0.05, 0.10, 0.15, 0.20)
"""Default distances, metres: 0 for all points, those of the thesis, and an additional one."""


def subsampling_study(
    project: Project,
    survey: Survey,
    distances: Sequence[float] = DEFAULT_DISTANCES,
    *,
    progress: Progress = no_progress,
) -> tuple[SubsamplingValues, ...]:
    """Adjust the project's targets for each distance, without changing the project.

    All adjustments use the correlation times and form errors of the project's result, or, without a
    result, of an adjustment with the project's point spacing.

    Parameters
    ----------
    distances : metres; 0 for all points

    Raises
    ------
    InputError
        If there is no distance, or a negative one.
    ProjectError
        If no target has been picked.
    AdjustmentError
        If the targets and lines do not determine a result.
    """
    if not distances or not all(0.0 <= distance < np.inf for distance in distances):
        raise InputError(error("estimate.point_spacing"))
    if not project.targets_of_role("target"):
        raise ProjectError(error("estimate.no_target", project=project.name))
    chosen = sorted(set(distances))
    selected = reselect_points(project, survey, progress=sub_progress(progress, 0.0, 0.4))
    model = _held_model(project, selected, survey)
    found = []
    for k, distance in enumerate(chosen):
        step = sub_progress(
            progress, 0.4 + 0.6 * k / len(chosen), 0.4 + 0.6 * (k + 1) / len(chosen)
        )
        step(
            0.0, gettext_lazy("Adjusting with a point spacing of {distance:m} m", distance=distance)
        )
        settings = replace(project.settings, subsample=distance)
        started = perf_counter()
        solved = adjust_selected(
            project.with_settings(settings), selected, survey,
            model=model, cross_check=False, advise=False, progress=step,
        )  # fmt: skip
        elapsed = perf_counter() - started
        result = solved.result
        assert result is not None
        found.append(
            SubsamplingValues(
                distance, result.points, degrees(result.boresight), degrees(result.sigma), elapsed
            )
        )
    progress(1.0)
    return tuple(found)


def _held_model(project: Project, selected: Project, survey: Survey) -> StochasticModel:
    """Stochastic model of the project's result, with its form errors."""
    result = project.result
    if result is None:
        result = adjust_selected(project, selected, survey, cross_check=False, advise=False).result
    assert result is not None
    if not result.model.correlated:
        return result.model
    return replace(result.model, surface=result.surface, offset=result.offset)
