"""Tests of spatial subsampling: selected points, distances, independence of the order."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial import cKDTree

from lispac.errors import InputError
from lispac.project import Settings
from lispac.survey.georeferencing import Mounting
from lispac.targets.thinning import thin_points
from lispac.workflow.calibration.estimation import thin_observations
from tests.support.surveys import planar_survey

POINTS = arrays(
    np.float64,
    st.tuples(st.integers(0, 60), st.just(3)),
    elements=st.floats(-5, 5, allow_nan=False, width=32),
)
DISTANCES = st.floats(0.02, 3.0)


@settings(max_examples=80, deadline=None)
@given(points=POINTS, distance=DISTANCES)
def test_one_point_per_cell_is_kept_near_every_point(points, distance):
    kept = thin_points(points, distance)
    assert np.array_equal(kept, np.unique(kept))
    cells = np.floor(points / distance)
    assert len(np.unique(cells[kept], axis=0)) == len(kept) == len(np.unique(cells, axis=0))
    if len(points):
        off, _ = cKDTree(points[kept]).query(points)
        assert off.max() <= np.sqrt(3) * distance * (1 + 1e-12)


@settings(max_examples=40, deadline=None)
@given(points=POINTS, distance=DISTANCES, seed=st.integers(0, 1000))
def test_the_order_of_the_points_does_not_matter(points, distance, seed):
    order = np.random.default_rng(seed).permutation(len(points))
    kept, shuffled = (
        points[thin_points(points, distance)],
        points[order][thin_points(points[order], distance)],
    )
    # Adding zero turns -0.0 into 0.0, which differ only in their bytes.
    assert sorted(map(tuple, kept + 0.0)) == sorted(map(tuple, shuffled + 0.0))


@pytest.mark.parametrize("distance", [0.0, -1.0])
def test_zero_distance_keeps_every_finite_point(distance):
    points = np.random.default_rng(1).normal(size=(50, 3))
    points[3] = np.nan
    np.testing.assert_array_equal(thin_points(points, distance), np.delete(np.arange(50), 3))


def test_a_dense_board_is_reduced_to_about_one_point_per_cell():
    rng = np.random.default_rng(2)
    points = np.stack(
        [rng.uniform(0, 1.2, 20_000), np.full(20_000, 0.05), rng.uniform(0, 1.2, 20_000)], 1
    )
    assert len(thin_points(points, 0.1)) == 144


@pytest.mark.parametrize("distance", [np.nan, np.inf])
def test_an_invalid_distance_is_refused(distance):
    with pytest.raises(InputError):
        thin_points(np.zeros((3, 3)), distance)


@pytest.mark.parametrize("pos_errors", ["correlated", "independent"])
def test_observations_of_plane_files_are_thinned_like_a_project(pos_errors: str) -> None:
    mounting = Mounting(np.array([0.1, 0.0, 2.0]), np.radians([0.3, -0.2, 0.4]))
    whole = planar_survey(mounting, points=400)
    chosen = Settings((0.1, 0.0, 2.0), subsample=0.2, pos_errors=pos_errors)
    fewer = thin_observations(whole, mounting, chosen)
    assert fewer.sightings == whole.sightings
    assert (fewer.counts > 10).all()
    assert len(fewer) < 0.6 * len(whole)
    again = thin_observations(whole, mounting, replace(chosen, subsample=0.0))
    assert len(again) == len(whole)
