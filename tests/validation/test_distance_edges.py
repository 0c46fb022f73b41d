"""Tests of edge cases of distances between clouds: no distances and invalid settings."""

import numpy as np
import pytest

from lispac.errors import InputError, NotComparable
from lispac.validation.absolute_check import AbsoluteState, SigmaSources
from lispac.validation.cloud_distance import cloud_to_cloud
from lispac.validation.comparison_results import DistanceStatistics, SignedStatistics
from lispac.validation.distance_map import distance_map
from lispac.validation.local_models import LocalModel
from lispac.validation.normal_distance import distances_along_normal
from lispac.validation.plane_comparison import compare_plane
from tests.support.error_codes import has_code
from tests.validation.test_distance_map import TO_VESSEL, wall


def test_the_share_of_the_reference_is_limited_to_one() -> None:
    known = SigmaSources(0.004, 0.0, 0.0, None)

    def state(rms: float) -> AbsoluteState:
        unsigned = DistanceStatistics(9, rms, rms, rms, rms, rms, rms, rms)
        return AbsoluteState(unsigned, SignedStatistics(9, 0, 0, rms, 0, 0), known, known)

    assert state(0.0).reference_share == 0.0
    assert state(0.008).reference_share == pytest.approx(0.25)
    assert state(0.002).reference_share == 1.0


def test_points_beyond_the_maximum_distance_are_not_measured() -> None:
    grid = np.stack(np.meshgrid(np.arange(5.0), np.arange(5.0), [0.0]), -1).reshape(-1, 3)
    far = np.array([[2.0, 2.0, 9.0], [3.0, 1.0, 8.0]])
    assert np.isnan(cloud_to_cloud(far, grid, max_distance=1.0)).all()
    near = cloud_to_cloud(np.vstack([far, [[2.2, 2.2, 0.5]]]), grid, max_distance=1.0)
    np.testing.assert_array_equal(np.isnan(near), [True, True, False])
    assert near[2] == pytest.approx(0.5)


def test_points_of_wrong_shape_are_refused() -> None:
    flat = np.zeros((50, 2))
    expected = {"plane": "V1", "line": "L1", "shape": "(50, 2)"}
    with pytest.raises(InputError, check=has_code("validation.shape_before", **expected)):
        compare_plane("V1", {"L1": flat}, {"L1": np.zeros((50, 3))}, {"L1": 0.0})


def test_a_map_needs_common_places_in_both_states() -> None:
    whole = wall(2)
    north, south = (wall(1)[side] for side in (wall(1)[:, 0] > 4.0, wall(1)[:, 0] < 2.0))
    how = {"facing": TO_VESSEL, "spacing": 0.1, "reach": (0.03, 0.03)}
    everywhere = np.ones(len(whole), dtype=bool)
    assert distance_map(("L1", "L2"), (north, south), (whole, whole), everywhere, **how) is None
    assert distance_map(("L1", "L2"), (north, north), (whole, whole), everywhere, **how) is not None
    far = whole + [0.0, 50.0, 0.0]
    assert distance_map(("L1", "L2"), (far, far), (whole, whole), everywhere, **how) is None


def test_an_unknown_local_model_is_refused() -> None:
    with pytest.raises(InputError, check=has_code("validation.unknown_model", kind="cubic")):
        LocalModel("cubic")


def test_without_points_there_is_no_distance() -> None:
    with pytest.raises(NotComparable, check=has_code("validation.no_places")):
        distances_along_normal(
            wall(1), wall(2), np.zeros((0, 3)), facing=TO_VESSEL, normal_scale=0.5, diameter=0.3,
            depth=0.3,
        )  # fmt: skip
