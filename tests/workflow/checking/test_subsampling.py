"""Tests of the subsampling study, which repeats an adjustment for each distance."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.errors import InputError, ProjectError
from lispac.project import Project
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.checking.subsampling import subsampling_study
from lispac.workflow.project.survey import Survey


def test_each_row_is_an_adjustment(denser_calibrated: tuple[Project, Survey]) -> None:
    project, survey = denser_calibrated
    rows = subsampling_study(project, survey, (0.2, 0.1, 0.05))
    assert [row.distance_m for row in rows] == [0.05, 0.1, 0.2]
    points = [row.points for row in rows]
    assert points == sorted(points, reverse=True)
    settings = replace(project.settings, subsample=0.2)
    alone = estimate(project, survey, settings=settings, cross_check=False).result
    assert alone is not None
    # An estimate selects points with its own distance; here all rows share one selection.
    assert rows[-1].points == pytest.approx(alone.points, rel=0.02)
    boresight, sigma = (
        np.radians([[*each] for each in values])
        for values in ([row.boresight_deg for row in rows], [row.sigma_deg for row in rows])
    )
    assert (np.abs(boresight[-1] - alone.boresight) < 0.2 * alone.sigma).all()
    np.testing.assert_allclose(sigma[-1], alone.sigma, rtol=0.05)
    # Errors common to a sighting do not depend on density: sigmas and angles hardly change.
    for k in range(2):
        assert (np.abs(boresight[k] - boresight[-1]) < 0.5 * sigma[k]).all()
        np.testing.assert_allclose(sigma[k], sigma[-1], rtol=0.15)
    assert all(row.elapsed_s > 0.0 for row in rows)
    assert project.settings.subsample != 0.2


def test_invalid_studies_are_refused(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    for distances in ((), (-0.1,), (0.1, float("nan"))):
        with pytest.raises(InputError) as raised:
            subsampling_study(project, survey, distances)
        assert raised.value.code == "estimate.point_spacing"
    with pytest.raises(ProjectError) as raised:
        subsampling_study(replace(project, targets=()), survey)
    assert raised.value.code == "estimate.no_target"


def test_all_rows_use_the_model_of_the_result(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    assert project.result is not None
    model = replace(project.result.model, position_time=9.0, attitude_time=18.0)
    of_result = project.with_result(replace(project.result, model=model, surface=0.004))
    (row,) = subsampling_study(of_result, survey, (project.settings.subsample,))
    settings = replace(project.settings, position_time=9.0, attitude_time=18.0, surface=0.004)
    alone = estimate(project, survey, settings=settings, cross_check=False).result
    assert alone is not None
    assert alone.given_correlation_times is None
    np.testing.assert_allclose(np.radians([*row.sigma_deg]), alone.sigma, rtol=0.02)
