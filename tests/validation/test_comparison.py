"""Tests of the comparison of lines on a validation plane with known offsets."""

import json

import numpy as np
import pytest
from numpy.typing import NDArray

from lispac.errors import InputError, NotComparable
from lispac.present.checking.validation import ValidationPlane
from lispac.report.validation_warnings import surface_model_warnings
from lispac.validation.line_overlap import LineOverlap
from lispac.validation.local_models import DEFAULT_MODEL, NEAREST_POINT_MODEL, SIX_POINT_PLANE
from lispac.validation.plane_comparison import (
    MAX_POINTS_PER_LINE,
    DistanceStatistics,
    PlaneComparison,
    are_reciprocal,
    comparable_pairs,
    compare_plane,
)
from lispac.value_conversion import decode_value, encode_value
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG, others_long

Array = NDArray[np.float64]
OPPOSITE = {"L1": 0.0, "L2": np.pi}


def wall(
    seed: int,
    *,
    offset: float = 0.0,
    noise: float = 0.0,
    n: int = 4000,
    low: tuple[float, float] = (0.0, 0.0),
    high: tuple[float, float] = (2.0, 3.0),
) -> Array:
    """Points on a vertical wall whose normal is (0, -1, 0), moved along it."""
    rng = np.random.default_rng(seed)
    along, height = rng.uniform(low, high, (n, 2)).T
    return np.column_stack((along, 30.0 - offset + rng.normal(0.0, noise, n), height + 10.0))


@pytest.mark.parametrize("offset", [0.0, 0.002, 0.005, 0.020])
def test_a_known_offset_is_measured(offset: float) -> None:
    before = {"L1": wall(1), "L2": wall(2, offset=0.1)}
    after = {"L1": wall(1), "L2": wall(2, offset=offset)}
    result = compare_plane("V1", before, after, OPPOSITE)
    assert result.after.median == pytest.approx(offset, abs=1e-9)
    # Where a point is opposite another one, the nearest point may be as near as the plane.
    assert result.after.rms == pytest.approx(offset, abs=1e-9)
    assert result.before.median == pytest.approx(0.1, abs=1e-9)


@pytest.mark.parametrize("offset", [0.005, 0.020])
def test_a_known_offset_is_measured_despite_noise(offset: float) -> None:
    clouds = {"L1": wall(1, noise=0.001), "L2": wall(2, offset=offset, noise=0.001)}
    result = compare_plane("V1", clouds, clouds, OPPOSITE)
    assert result.after.median == pytest.approx(offset, abs=0.0002)
    assert result.after.rms == pytest.approx(offset, abs=0.0006)


@pytest.mark.parametrize(
    ("spacing", "profile_ratio"),
    others_long(
        [(0.005, 1.0), (0.005, 5.0), (0.005, 20.0), (0.02, 1.0), (0.02, 5.0)],
        lambda value: value in ((0.005, 20.0), (0.02, 1.0)),
    ),
)
def test_the_rms_is_that_of_the_offset_on_dense_noisy_lines(
    spacing: float, profile_ratio: float
) -> None:
    """Points nearer to each other than the noise, and profiles far apart, do not reduce it."""
    offset, noise = 0.021, 0.004
    rng = np.random.default_rng(5)
    along, across = spacing / np.sqrt(profile_ratio), spacing * np.sqrt(profile_ratio)

    def line(depth: float) -> np.ndarray:
        shift = rng.uniform(0.0, across)
        grid = np.meshgrid(np.arange(0.0, 1.0, along), np.arange(shift, 1.0, across))
        points = np.column_stack([grid[0].ravel(), np.full(grid[0].size, depth), grid[1].ravel()])
        return points + noise * rng.standard_normal(points.shape)

    clouds = {"L1": line(0.0), "L2": line(offset)}
    result = compare_plane("V1", clouds, clouds, OPPOSITE)
    assert result.after.rms == pytest.approx(np.hypot(offset, noise), rel=0.05)
    assert result.pairs[0].after.signed is not None
    assert abs(result.pairs[0].after.signed.median) == pytest.approx(offset, rel=0.05)
    assert list(surface_model_warnings([ValidationPlane.of(result)])) == []


@LONG
def test_an_rms_that_is_too_small_for_the_offset_gives_a_warning() -> None:
    """Six points that are closer together than their noise."""
    rng = np.random.default_rng(6)
    places = rng.uniform(0.0, 1.0, (2, 40_000, 3)) * [1.0, 0.0, 1.0]
    clouds = {
        f"L{k + 1}": points + [0.0, 0.02 * k, 0.0] + 0.005 * rng.standard_normal(points.shape)
        for k, points in enumerate(places)
    }
    for model, expected in (
        (SIX_POINT_PLANE, ["validation.rms_below_offset"]),
        (DEFAULT_MODEL, []),
    ):
        result = compare_plane("V1", clouds, clouds, OPPOSITE, model=model)
        found = list(surface_model_warnings([ValidationPlane.of(result)]))
        assert [each.code for each in found] == expected


def test_distances_without_offset_have_the_size_of_the_noise() -> None:
    clouds = {"L1": wall(1, noise=0.003), "L2": wall(2, noise=0.003)}
    result = compare_plane("V1", clouds, clouds, OPPOSITE)
    # Noise of a point (3 mm) and of a plane through six points: at least 3 mm x sqrt(1 + 1/6).
    assert 0.003 < result.after.rms < 0.0055


def test_a_tilt_gives_distances_that_grow() -> None:
    tilt = np.radians(0.5)
    tilted = wall(2)
    tilted[:, 1] += np.tan(tilt) * (tilted[:, 2] - 10.0)
    clouds = {"L1": wall(1), "L2": tilted}
    result = compare_plane("V1", clouds, clouds, OPPOSITE)
    # For uniform heights up to 3 m the mean is 1/2 and the RMS 1/sqrt(3) of the largest.
    largest = 3.0 * np.sin(tilt)
    assert result.after.mean == pytest.approx(largest / 2, rel=0.03)
    assert result.after.rms == pytest.approx(largest / np.sqrt(3), rel=0.03)
    assert result.after.p95 == pytest.approx(0.95 * largest, rel=0.03)


def test_parts_that_one_line_does_not_show_are_not_compared() -> None:
    left = wall(1, high=(1.2, 3.0))
    right = wall(2, offset=0.01, low=(0.8, 0.0))
    clouds = {"L1": left, "L2": right}
    result = compare_plane("V1", clouds, clouds, OPPOSITE)
    expected = np.count_nonzero(left[:, 0] > 0.8) + np.count_nonzero(right[:, 0] < 1.2)
    assert result.after.n == pytest.approx(expected, rel=0.25)
    assert result.after.maximum < 0.0101


def test_a_hole_in_one_line_is_not_compared() -> None:
    whole, pierced = wall(1, n=8000), wall(2, n=8000, offset=0.01)
    u, v = pierced[:, 0], pierced[:, 2] - 10.0
    pierced = pierced[~((abs(u - 1.0) < 0.5) & (abs(v - 1.5) < 0.5))]
    clouds = {"L1": whole, "L2": pierced}
    result = compare_plane("V1", clouds, clouds, OPPOSITE)
    in_hole = (abs(whole[:, 0] - 1.0) < 0.4) & (abs(whole[:, 2] - 11.5) < 0.4)
    assert result.after.n < len(whole) + len(pierced) - np.count_nonzero(in_hole)


def test_a_shift_within_the_plane_before_does_not_count_as_distance() -> None:
    a, b = wall(1), wall(2, offset=0.002)
    shift = np.array([0.4, -0.03, 0.3])
    before = {"L1": a + shift, "L2": b - [0.4, 0.0, 0.3]}
    result = compare_plane("V1", before, {"L1": a, "L2": b}, OPPOSITE)
    assert result.before.n == result.after.n
    assert result.before.maximum == pytest.approx(0.028, abs=1e-6)
    assert result.after.maximum == pytest.approx(0.002, abs=1e-6)


def test_offsets_and_maps_use_the_whole_common_part_despite_a_shift_within_the_plane() -> None:
    a, b = wall(1, n=20_000), wall(2, n=20_000)
    before = {"L1": a + np.array([0.8, 0.0, 0.0]), "L2": b}
    result = compare_plane("V1", before, {"L1": a, "L2": b}, OPPOSITE)
    (pair,) = result.pairs
    assert pair.before.signed is not None
    assert pair.after.signed is not None
    # Both lines cover 2.0 m after and 1.2 m before the calibration; L2 is compared from 0.8 to 2 m.
    assert pair.after.signed.n == pair.before.signed.n
    (mapped,) = result.maps
    assert np.ptp(mapped.across) == pytest.approx(1.2, abs=2 * mapped.cell)


def test_profiles_with_different_spacings_overlap_completely() -> None:
    along, height = np.meshgrid(np.arange(0, 2, 0.12), np.arange(0, 3, 0.008), indexing="ij")
    rng = np.random.default_rng(3)
    flat = np.column_stack((along.ravel(), height.ravel())) + rng.normal(0, 0.001, (along.size, 2))
    points = np.column_stack((flat[:, 0], np.full(len(flat), 30.0), flat[:, 1]))
    clouds = {"L1": points, "L2": points + np.array([0.05, 0.004, 0.0])}
    result = compare_plane("V1", clouds, clouds, OPPOSITE)
    assert result.after.n > 0.9 * 2 * len(points)
    assert result.after.median == pytest.approx(0.004, abs=1e-6)


def test_both_directions_are_pooled_symmetrically() -> None:
    a, b = wall(1, noise=0.002), wall(2, offset=0.01, noise=0.002, n=2500)
    one = compare_plane("V1", {"L1": a, "L2": b}, {"L1": a, "L2": b}, OPPOSITE)
    other = compare_plane("V1", {"L2": b, "L1": a}, {"L2": b, "L1": a}, OPPOSITE)
    assert one.after.n == other.after.n
    assert one.after.rms == pytest.approx(other.after.rms, abs=1e-12)


def test_all_pairs_make_the_pool_and_reciprocal_ones_come_first() -> None:
    headings = np.radians([0, 45, 180, 225]).tolist()
    lines = ["L1", "L2", "L3", "L4"]
    clouds = {line: wall(i, offset=0.01 * i) for i, line in enumerate(lines)}
    result = compare_plane("V1", clouds, clouds, dict(zip(lines, headings, strict=True)))
    names = [(pair.line_a, pair.line_b) for pair in result.pairs]
    assert names[:2] == [("L1", "L3"), ("L2", "L4")]
    assert [pair.reciprocal for pair in result.pairs] == [True, True, False, False, False, False]
    assert result.pooled_from == "all pairs"
    assert result.after.n == sum(pair.after.distances.n for pair in result.pairs)
    # Offsets of the pairs: three times 10 mm, twice 20 mm, once 30 mm; all with equal weight
    assert result.after.mean == pytest.approx(0.1 / 6, rel=0.01)
    assert result.after.rms == pytest.approx(np.sqrt(2e-3 / 6), rel=0.01)


def test_a_line_without_a_reciprocal_one_is_in_the_pool() -> None:
    headings = {"L1": 0.0, "L2": np.pi, "L3": np.pi / 2}
    clouds = {"L1": wall(1), "L2": wall(2), "L3": wall(3, offset=0.03)}
    result = compare_plane("V1", clouds, clouds, headings)
    # L1 and L2 agree; L3 is 30 mm from both of them
    assert result.after.rms == pytest.approx(0.03 * np.sqrt(2 / 3), rel=0.01)
    assert result.after.p95 == pytest.approx(0.03, abs=1e-6)
    assert result.counts_after.sum() == result.after.n


@pytest.mark.parametrize(
    ("a_deg", "b_deg", "expected"),
    [
        (0, 180, True),
        (359, 178, True),
        (5, 170, True),
        (-175, 365, True),
        (340, 180, True),
        (338, 180, False),
        (0, 0, False),
        (1, 359, False),
        (90, 180, False),
        (720, -180, True),
    ],
)
def test_reciprocal_through_north(a_deg: float, b_deg: float, expected: bool) -> None:
    nudge = 1e-9 if expected else 0.0  # avoids rounding at exactly 20 degrees
    assert are_reciprocal(np.radians(a_deg) + nudge, np.radians(b_deg)) is expected
    assert are_reciprocal(np.radians(b_deg), np.radians(a_deg) + nudge) is expected


def test_histograms_share_edges_and_count_every_distance() -> None:
    before = {"L1": wall(1, noise=0.004), "L2": wall(2, noise=0.004, offset=0.08)}
    after = {"L1": wall(1, noise=0.004), "L2": wall(2, noise=0.004)}
    result = compare_plane("V1", before, after, OPPOSITE)
    assert result.bin_edges[0] == 0.0
    assert result.bin_edges[-1] >= result.before.p99
    assert (
        result.bin_edges[1] < result.after.p95 / 20
    )  # the distances after fill more than two bars
    assert result.counts_before.sum() == result.before.n == result.after.n
    assert result.counts_after.sum() == result.after.n
    assert result.counts_before[-1] > 0  # distances beyond the last edge are in the last bin


@LONG
def test_many_points_are_thinned_equally_in_both_states() -> None:
    a, b = wall(1, n=MAX_POINTS_PER_LINE + 5000), wall(2, n=2000)
    clouds = {"L1": a, "L2": b}
    moved = {"L1": a, "L2": b + np.array([0.0, 0.006, 0.0])}
    result = compare_plane("V1", moved, clouds, OPPOSITE)
    assert result.after.n <= (len(a) + 1) // 2 + len(b)
    assert result.before.median == pytest.approx(0.006, abs=1e-9)
    again = compare_plane("V1", moved, clouds, OPPOSITE)
    assert encode_value(again) == encode_value(result)


def test_lines_that_show_different_parts_are_named() -> None:
    clouds = {"L1": wall(1), "L2": wall(2), "L3": wall(3, low=(5.0, 0.0), high=(6.0, 3.0))}
    result = compare_plane("V1", clouds, clouds, {"L1": 0.0, "L2": np.pi, "L3": 1.0})
    assert len(result.pairs) == 1
    assert result.not_compared == (("L1", "L3"), ("L2", "L3"))


def test_a_plane_on_one_line_is_refused() -> None:
    nothing = np.empty((0, 3))
    with pytest.raises(
        NotComparable, check=has_code("validation.plane_in_one_line", plane="V4", line="L1")
    ):
        compare_plane("V4", {"L1": wall(1)}, {"L1": wall(1)}, OPPOSITE)
    clouds = {"L1": wall(1), "L2": nothing}
    with pytest.raises(NotComparable, check=has_code("validation.plane_in_one_line")):
        compare_plane("V4", clouds, clouds, OPPOSITE)
    with pytest.raises(NotComparable, check=has_code("validation.plane_in_no_line")):
        compare_plane("V4", {"L1": nothing}, {"L1": nothing}, OPPOSITE)


def test_lines_without_overlap_are_refused() -> None:
    clouds = {"L1": wall(1), "L2": wall(2, low=(5.0, 0.0), high=(7.0, 3.0))}
    with pytest.raises(NotComparable, check=has_code("validation.no_overlap", plane="V2")):
        compare_plane("V2", clouds, clouds, OPPOSITE)


@pytest.mark.parametrize(
    ("step", "count"), others_long([(0.0, 3), (0.9, 3), (1.2, 2), (1.9, 2), (2.1, 0)])
)
def test_comparable_pairs_agree_with_the_compared_pairs(step: float, count: int) -> None:
    """Lines that are moved along the wall by ``step`` metres before, and not after."""
    after = {line: wall(seed=k, noise=0.002) for k, line in enumerate("ABC")}
    before = {
        line: each + np.array([k * step, 0.0, 0.0]) for k, (line, each) in enumerate(after.items())
    }
    pairs = comparable_pairs(before, after)
    headings = dict.fromkeys(after, 0.0)
    if pairs:
        found = compare_plane("V1", before, after, headings)
        assert {(pair.line_a, pair.line_b) for pair in found.pairs} == set(pairs)
    else:
        with pytest.raises(NotComparable):
            compare_plane("V1", before, after, headings)
    assert len(pairs) == count


def test_points_on_one_straight_line_do_not_overlap() -> None:
    row = np.column_stack((np.linspace(0, 1, 100), np.zeros(100), np.zeros(100)))
    clouds = {"L1": row, "L2": row}
    with pytest.raises(NotComparable, check=has_code("validation.no_overlap")):
        compare_plane("V2", clouds, clouds, OPPOSITE)


def test_states_of_different_points_are_refused() -> None:
    a, b = wall(1), wall(2)
    with pytest.raises(
        InputError,
        check=has_code("validation.other_points", line="L2", plane="V1", before=4000, after=3999),
    ):
        compare_plane("V1", {"L1": a, "L2": b}, {"L1": a, "L2": b[1:]}, OPPOSITE)
    with pytest.raises(InputError, check=has_code("validation.other_lines", lines=("L3",))):
        compare_plane("V1", {"L1": a, "L2": b, "L3": b}, {"L1": a, "L2": b}, OPPOSITE)
    with pytest.raises(InputError, check=has_code("validation.no_heading", line="L2")):
        compare_plane("V1", {"L1": a, "L2": b}, {"L1": a, "L2": b}, {"L1": 0.0})
    broken = b.copy()
    broken[3, 2] = np.nan
    with pytest.raises(
        InputError, check=has_code("validation.not_finite_after", plane="V1", line="L2")
    ):
        compare_plane("V1", {"L1": a, "L2": b}, {"L1": a, "L2": broken}, OPPOSITE)


def test_statistics_of_known_numbers() -> None:
    statistics = DistanceStatistics.of(np.arange(101.0))
    assert (statistics.n, statistics.median, statistics.maximum) == (101, 50.0, 100.0)
    assert (statistics.p68, statistics.p95, statistics.p99) == (68.0, 95.0, 99.0)
    assert statistics.mean == 50.0
    assert statistics.rms == pytest.approx(np.sqrt(100 * 201 / 6))
    with pytest.raises(InputError, check=has_code("validation.no_distances")):
        DistanceStatistics.of([])
    with pytest.raises(InputError, check=has_code("validation.no_distances")):
        DistanceStatistics.of([1.0, np.nan])


def test_round_trip_through_json() -> None:
    clouds = {"L1": wall(1, noise=0.002), "L2": wall(2), "L3": wall(3, low=(9, 9), high=(10, 10))}
    headings = OPPOSITE | {"L3": 0.0}
    result = compare_plane("V1", clouds, clouds, headings)
    back = decode_value(json.loads(json.dumps(encode_value(result))), PlaneComparison)
    assert encode_value(back) == encode_value(result)
    assert back.pairs[0].after == result.pairs[0].after
    assert back.not_compared == result.not_compared
    assert back.counts_after.dtype == result.counts_after.dtype
    np.testing.assert_array_equal(back.bin_edges, result.bin_edges)


def test_signed_distances_and_planes_of_a_pair() -> None:
    """L2 is 20 mm behind L1 before and 5 mm in front of it after, seen from the south."""
    a, b = wall(1, noise=0.001), wall(2, noise=0.001)
    before = {"L1": a, "L2": b + [0.0, 0.020, 0.0]}
    after = {"L1": a, "L2": b - [0.0, 0.005, 0.0]}
    south = np.array([0.3, -1.0, 0.0])
    (pair,) = compare_plane("V1", before, after, OPPOSITE, facing=south).pairs
    for state, offset in ((pair.before, 0.020), (pair.after, -0.005)):
        assert state.signed is not None
        assert state.planes is not None
        assert state.signed.median == pytest.approx(offset, abs=0.0003)
        assert state.signed.significant == 1.0
        assert abs(state.planes.offset - offset) < 2 * state.planes.offset_95
        assert state.planes.offset_95 < 0.0001
    (back,) = compare_plane("V1", before, after, OPPOSITE, facing=-south).pairs
    assert back.after.signed is not None
    assert back.after.signed.median == pytest.approx(0.005, abs=0.0003)


def test_profiles_show_where_the_distances_grow() -> None:
    """A line tilted by 0.5 degrees about the foot of the wall: 0 there, 26 mm at 3 m height."""
    leaning = wall(2)
    leaning[:, 1] += np.tan(np.radians(0.5)) * (leaning[:, 2] - 10.0)
    a, b = wall(1), wall(2)
    ranges = {"L1": np.linalg.norm(a, axis=1), "L2": np.linalg.norm(b, axis=1)}
    result = compare_plane(
        "V2", {"L1": a, "L2": leaning}, {"L1": a, "L2": b}, OPPOSITE, ranges=ranges
    )
    for profile in (result.by_height, result.by_range):
        assert profile is not None
        assert profile.n.sum() == result.before.n
        assert profile.median_after == pytest.approx(0.0, abs=1e-9)
    height = result.by_height
    assert height is not None
    middles = 0.5 * (height.edges[1:] + height.edges[:-1])
    expected = np.sin(np.radians(0.5)) * (middles - 10.0)
    assert height.median_before == pytest.approx(expected, abs=0.0003)


def test_another_model_is_used_and_stored() -> None:
    clouds = {"L1": wall(1, noise=0.002), "L2": wall(2, noise=0.002)}
    points, plane = (
        compare_plane("V1", clouds, clouds, OPPOSITE, model=model)
        for model in (NEAREST_POINT_MODEL, SIX_POINT_PLANE)
    )
    assert points.model == NEAREST_POINT_MODEL
    assert points.after.median > 3 * plane.after.median  # includes the spacing of the points


def test_outliers_are_counted_and_kept() -> None:
    statistics = DistanceStatistics.of(np.r_[np.linspace(0.001, 0.005, 401), np.full(9, 0.1)])
    assert statistics.outliers == 9
    assert statistics.maximum == 0.1
    assert statistics.robust_sigma == pytest.approx(1.4826 * 0.001, rel=0.03)


def profiles(spacing: float, step: float, scatter: float, gap: float = 0.0) -> Array:
    """Vertical profiles on a horizontal plane, with a quadratic hole of a share of the area."""
    rng = np.random.default_rng(5)
    count = 60_000
    lengths = np.sqrt(count * spacing * step) * np.array([1.0, 1.0])
    at = np.arange(0.0, lengths[0], spacing)
    along = np.arange(0.0, lengths[1], step)
    places = np.stack(np.meshgrid(at, along, indexing="ij"), axis=-1)
    places[..., 1] += rng.uniform(0.0, step, (len(at), 1))
    flat = places.reshape(-1, 2)
    flat = flat[(np.abs(flat / lengths - 0.5) > np.sqrt(gap) / 2).any(axis=1)]
    flat = flat + rng.normal(0.0, 1.0, flat.shape) * [scatter, 0.2 * scatter]
    return np.column_stack((flat, np.zeros(len(flat))))


@pytest.mark.parametrize(
    ("spacing", "step", "scatter", "gap"),
    [
        (0.05, 0.05, 0.0, 0.0),
        (0.05, 0.01, 0.0, 0.0),
        (0.1, 0.01, 0.005, 0.0),
        (0.1, 0.005, 0.005, 0.0),
        (0.2, 0.004, 0.004, 0.0),
        (0.1, 0.005, 0.005, 0.5),
        (0.05, 0.01, 0.002, 0.5),
    ],
)
def test_the_spacing_of_many_points_is_that_of_their_profiles(
    spacing: float, step: float, scatter: float, gap: float
) -> None:
    points = profiles(spacing, step, scatter, gap)
    assert len(points) > 20_000
    found = LineOverlap({"L1": points}, {"L1": points}).spacing("L1")
    # Triangles between two profiles connect points on their facing sides, which the scatter moves
    # towards each other by up to two standard deviations each.
    assert spacing - 4.0 * scatter <= found <= 1.05 * np.hypot(spacing, step)
