"""Tests of the conversion between scanner frame and map, against PROJ point by point."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pyproj import Transformer

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame
from lispac.geometry.rotations import rotation_matrix
from lispac.io.trajectory.sbet import read_sbet, write_sbet
from lispac.survey import point_mapping
from lispac.survey.crs import coordinate_system
from lispac.survey.georeferencing import Mounting, georeference, place_points, to_lidar
from lispac.survey.point_mapping import ScannerPointConverter
from lispac.survey.scanner_frame_recovery import RecoverySetup
from lispac.survey.smooth_map import MAP_ACCURACY_M, fit_smooth_map
from lispac.survey.trajectory import MAX_PITCH_RAD, LocalTrajectory, Trajectory
from tests.support.cloud_files import (
    GREENWICH,
    MOUNTING,
    QUEBEC,
    SYDNEY,
    folded_geoid,
    one_by_one,
    sweep,
    track,
)
from tests.support.error_codes import has_code


@pytest.mark.parametrize(
    ("code", "where", "options"),
    [
        ("EPSG:32619", QUEBEC, {}),
        ("EPSG:2949", QUEBEC, {}),
        ("EPSG:4979", QUEBEC, {}),
        ("EPSG:4326", QUEBEC, {}),
        ("EPSG:4978", QUEBEC, {}),
        ("EPSG:3857", QUEBEC, {}),
        ("EPSG:32756", SYDNEY, {}),
        ("EPSG:32630", GREENWICH, {}),
        ("EPSG:32631", GREENWICH, {}),
        ("EPSG:2264", (35.2, -80.8), {}),
        ("EPSG:3413", (83.0, -35.0), {}),
        ("EPSG:2949", QUEBEC, {"height": "grid"}),
        ("EPSG:32619", QUEBEC, {"height": "ellipsoid", "height_unit": "foot"}),
        ("EPSG:32619", QUEBEC, {"trajectory_datum": "EPSG:4979"}),
    ],
)
def test_map_agrees_with_proj_point_by_point(
    code: str,
    where: tuple[float, float],
    options: dict[str, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    if options.get("height") == "grid":
        options = {"height": str(folded_geoid(tmp_path / "folded.gtx"))}
    system, trajectory = coordinate_system(code, **options), track(where)
    points, time = sweep(trajectory)
    mapper = ScannerPointConverter(system, trajectory, MOUNTING)
    expected = one_by_one(system, trajectory, points, time)
    found = mapper.to_map(points, time)
    off = np.abs((found - expected) * np.array(system.metres)).max()
    back = np.abs(mapper.to_scanner(expected, time) - points).max()
    fit = mapper.fit_to(points)
    assert fit is not None
    with capsys.disabled():
        print(
            f"\n{code} {' '.join(options)}: off {1e3 * off:.1e} mm, back {1e3 * back:.1e} mm, "
            f"{len(fit.boxes)} cells, residual {1e3 * fit.residual:.1e} mm, "
            f"{fit.exact_share:.1%} point by point"
        )
    assert off < MAP_ACCURACY_M
    assert back < 2 * MAP_ACCURACY_M
    assert fit.residual < MAP_ACCURACY_M
    np.testing.assert_array_less(
        np.abs(mapper.to_scanner(found, time) - points), 2 * MAP_ACCURACY_M
    )


def test_utm_agrees_with_a_proj_pipeline() -> None:
    """Only the polynomials of the program lie between the local frame and the map."""
    trajectory = track()
    points, time = sweep(trajectory)
    frame = trajectory.frame
    latitude, longitude = (float(np.degrees(a)) for a in (frame.latitude, frame.longitude))
    steps = Transformer.from_pipeline(
        "+proj=pipeline +step +inv +proj=topocentric +ellps=WGS84 "
        f"+lat_0={latitude!r} +lon_0={longitude!r} "
        f"+h_0={float(frame.height)!r} +step +inv +proj=cart +ellps=WGS84 "
        "+step +proj=utm +zone=19 +ellps=WGS84"
    )
    local = place_points(points, trajectory.at(time + MOUNTING.latency), MOUNTING)
    expected = np.stack(steps.transform(-local[:, 1], local[:, 0], local[:, 2]), axis=1)
    found = ScannerPointConverter(coordinate_system("EPSG:32619"), trajectory, MOUNTING).to_map(
        points, time
    )
    np.testing.assert_allclose(found, expected, rtol=0, atol=MAP_ACCURACY_M)


def test_distant_points_are_converted_exactly() -> None:
    """A range of 20 km is beyond the region of the fitted polynomials."""
    system, trajectory = coordinate_system("EPSG:32619"), track()
    points, time = sweep(trajectory, 200)
    points[::10] *= 250
    mapper = ScannerPointConverter(system, trajectory, MOUNTING)
    expected = one_by_one(system, trajectory, points, time)
    found = mapper.to_map(points, time)
    np.testing.assert_allclose(found, expected, rtol=0, atol=MAP_ACCURACY_M)
    np.testing.assert_allclose(
        mapper.to_scanner(found, time), points, rtol=0, atol=2 * MAP_ACCURACY_M
    )


@pytest.mark.parametrize("threads", [None, 1, 3])
def test_pieces_and_threads_do_not_change_the_result(
    threads: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    trajectory = track()
    points, time = sweep(trajectory, 1000)
    points[::10] *= 250  # these are converted exactly, not by polynomials
    mapper = ScannerPointConverter(coordinate_system("EPSG:32619"), trajectory, MOUNTING)
    whole = mapper.to_map(points, time)
    back = mapper.to_scanner(whole, time)
    monkeypatch.setattr(point_mapping, "PIECE_POINTS", 128)
    np.testing.assert_array_equal(mapper.to_map(points, time, threads=threads), whole)
    np.testing.assert_array_equal(mapper.to_scanner(whole, time, threads=threads), back)


def test_a_long_survey_has_several_polynomial_cells() -> None:
    """Over 60 km along the coast one polynomial is not accurate enough."""
    system, trajectory = coordinate_system("EPSG:2949"), track(size=30_000.0)
    points, time = sweep(trajectory)
    mapper = ScannerPointConverter(system, trajectory, MOUNTING)
    expected = one_by_one(system, trajectory, points, time)
    np.testing.assert_allclose(mapper.to_map(points, time), expected, rtol=0, atol=MAP_ACCURACY_M)
    fit = mapper.fit_to(points)
    assert fit is not None
    assert len(fit.boxes) > 1
    assert fit.exact_share == 0


@settings(max_examples=25, deadline=None)
@given(
    latitude=st.floats(-79, 83),
    longitude=st.floats(-179, 179),
    size=st.floats(10, 20_000),
)
def test_utm_conversion_is_accurate_anywhere_on_earth(
    latitude: float, longitude: float, size: float
) -> None:
    zone = int((longitude + 180) // 6) + 1
    system = coordinate_system(f"EPSG:{(32600 if latitude >= 0 else 32700) + zone}")
    trajectory = track((latitude, longitude), size=size, turns=1.0)
    points, time = sweep(trajectory, 300)
    mapper = ScannerPointConverter(system, trajectory, MOUNTING)
    expected = one_by_one(system, trajectory, points, time)
    np.testing.assert_allclose(mapper.to_map(points, time), expected, rtol=0, atol=MAP_ACCURACY_M)
    np.testing.assert_allclose(
        mapper.to_scanner(expected, time), points, rtol=0, atol=2 * MAP_ACCURACY_M
    )


def test_points_at_discontinuities_are_not_mapped_by_polynomials() -> None:
    """For a step, a fold and a hole: mapped points are correct, the others are marked."""

    def exact(points: np.ndarray) -> np.ndarray:
        x, y, z = points.T
        value = np.where(x > 100.3, x + 5, x), np.abs(y - 33.3), np.where(x + y < -700, np.nan, z)
        return np.stack(value, axis=1)

    low, high = np.array([-500.0, -400, -10]), np.array([500.0, 400, 10])
    fit = fit_smooth_map(exact, low, high, metres_in=np.ones(3), metres_out=np.ones(3))
    points = np.random.default_rng(1).uniform(low, high, (50_000, 3))
    found = points.copy()
    missed = fit.apply(found)
    assert 0.01 < missed.mean() < 0.3
    np.testing.assert_array_equal(found[missed], points[missed])
    np.testing.assert_allclose(found[~missed], exact(points[~missed]), rtol=0, atol=MAP_ACCURACY_M)
    outside = np.array([[600.0, 0, 0], [0, 0, 11], [np.nan, 0, 0]])
    assert fit.apply(outside).all()


def test_times_without_a_pose_are_refused() -> None:
    trajectory = track()
    points, time = sweep(trajectory, 50)
    mapper = ScannerPointConverter(coordinate_system("EPSG:32619"), trajectory, MOUNTING)
    found = mapper.to_map(points, time)
    time[20] = trajectory.time[-1] + 1
    with pytest.raises(InputError, check=has_code("survey.outside_trajectory")):
        mapper.to_map(points, time)
    with pytest.raises(InputError, check=has_code("survey.outside_trajectory")):
        mapper.to_scanner(found, time)


def test_points_outside_the_system_are_refused(tmp_path: Path) -> None:
    system = coordinate_system("EPSG:2949", height=str(folded_geoid(tmp_path / "g.gtx")))
    trajectory = track((55.0, -71.2))
    points, time = sweep(trajectory, 50)
    with pytest.raises(InputError, check=has_code("crs.points_outside")):
        ScannerPointConverter(system, trajectory, MOUNTING).to_map(points, time)


def test_a_site_at_the_edge_of_a_geoid_grid_is_mapped(tmp_path: Path) -> None:
    """The points lie on the grid; the region of the polynomials extends beyond it."""
    system = coordinate_system("EPSG:2949", height=str(folded_geoid(tmp_path / "g.gtx")))
    trajectory = track((47.9965, -71.2), size=200.0)  # the grid ends 390 m to the north
    points, time = sweep(trajectory, 300)
    mapper = ScannerPointConverter(system, trajectory, MOUNTING)
    expected = one_by_one(system, trajectory, points, time)
    np.testing.assert_allclose(mapper.to_map(points, time), expected, rtol=0, atol=MAP_ACCURACY_M)
    np.testing.assert_allclose(
        mapper.to_scanner(expected, time), points, rtol=0, atol=2 * MAP_ACCURACY_M
    )


def test_conversion_to_the_local_frame_is_georeferencing() -> None:
    trajectory = track()
    points, time = sweep(trajectory)
    mapper = ScannerPointConverter(None, trajectory, MOUNTING)
    found = mapper.to_map(points, time)
    np.testing.assert_array_equal(found, georeference(points, time, trajectory, MOUNTING))
    np.testing.assert_allclose(mapper.to_scanner(found, time), points, rtol=0, atol=1e-10)
    other = Mounting(np.zeros(3), np.zeros(3))
    np.testing.assert_array_equal(
        mapper.with_mounting(other).to_map(points, time),
        georeference(points, time, trajectory, other),
    )


def test_compiled_inverse_equals_the_reference_formula() -> None:
    trajectory = track()
    points, time = sweep(trajectory)
    expected = to_lidar(points, trajectory.at(time + MOUNTING.latency), MOUNTING)
    found = ScannerPointConverter(None, trajectory, MOUNTING).to_scanner(points, time)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10)


def through_north(tmp_path: Path, *, clockwise: bool) -> LocalTrajectory:
    """Return a steady turn through north, stored as 359.5, 0.5 or 0.5, 359.5 degrees."""
    time = np.arange(0.0, 61.0)
    turn = np.degrees(0.1) * (time - 30) * (1 if clockwise else -1)
    attitude = np.radians(np.stack([0 * time, 0 * time, turn % 360], axis=1))
    raw = Trajectory(time, np.full(61, 0.8), np.full(61, -1.3), np.zeros(61), attitude)
    write_sbet(tmp_path / "turn.sbet", raw)
    return LocalTrajectory.of(read_sbet(tmp_path / "turn.sbet"), raw.mean_frame())


@pytest.mark.parametrize("clockwise", [True, False])
def test_points_follow_a_turn_through_north(tmp_path: Path, clockwise: bool) -> None:
    """A point 50 m ahead moves by the angle of the turn only, and is converted back."""
    trajectory = through_north(tmp_path, clockwise=clockwise)
    assert np.abs(np.diff(trajectory.attitude[:, 2])).max() < 0.11
    mounting = Mounting(np.zeros(3), np.zeros(3))
    time = np.linspace(20.0, 40.0, 20_001)
    ahead = np.tile([50.0, 0.0, 0.0], (len(time), 1))
    local = georeference(ahead, time, trajectory, mounting)
    angle = 0.1 * (time - 30) * (1 if clockwise else -1)
    expected = 50 * np.stack([np.cos(angle), -np.sin(angle), 0 * angle], axis=1)
    np.testing.assert_allclose(local, expected, rtol=0, atol=1e-6)
    system = coordinate_system("EPSG:32618")
    cloud = ScannerPointConverter(system, trajectory, mounting).to_map(ahead, time)
    back = RecoverySetup(system, trajectory, mounting).points_lidar(cloud, time)
    np.testing.assert_allclose(back, ahead, rtol=0, atol=2 * MAP_ACCURACY_M)


def tilted(pitch_deg: np.ndarray) -> Trajectory:
    time = np.arange(len(pitch_deg)) * 0.1
    zero = np.zeros(len(time))
    attitude = np.stack([zero, np.radians(pitch_deg), zero + 1.0], axis=1)
    return Trajectory(time, zero + 0.8, zero - 1.3, zero, attitude)


def test_a_trajectory_with_steep_pitch_is_refused() -> None:
    raw = tilted(np.full(100, -88.0))
    with pytest.raises(InputError, check=has_code("survey.trajectory_steep")):
        LocalTrajectory.of(raw, raw.mean_frame())


def test_states_with_steep_pitch_have_no_pose() -> None:
    """For example a drone that is carried on its side before take-off."""
    pitch = np.full(100, 5.0)
    pitch[20:30] = 86.0
    raw = tilted(pitch)
    trajectory = LocalTrajectory.of(raw, raw.mean_frame())
    time = np.array([1.0, 1.95, 2.5, 2.95, 3.05, 5.0])
    np.testing.assert_array_equal(trajectory.covers(time), [True, False, False, False, True, True])
    assert np.degrees(MAX_PITCH_RAD) == pytest.approx(80)


def test_interpolation_at_a_pitch_of_75_degrees_is_accurate() -> None:
    """At 200 Hz, linear interpolation of the angles is as accurate as that of the rotation."""
    rng = np.random.default_rng(2)
    time = np.arange(2001) / 200
    motion = np.radians(
        np.stack([5 * np.sin(time), 75 + 4 * np.sin(1.3 * time), 3 * np.cos(0.5 * time)], axis=1)
    )
    trajectory = LocalTrajectory(LocalFrame(0.8, -1.3, 0.0), time, np.zeros((2001, 3)), motion)
    times = rng.uniform(0, 10, 500)
    k = np.minimum((times * 200).astype(int), 1999)
    first, second = rotation_matrix(*motion[k].T), rotation_matrix(*motion[k + 1].T)
    turn = np.einsum("nji,njk->nik", first, second)
    axis = np.stack([turn[:, 2, 1] - turn[:, 1, 2], turn[:, 0, 2] - turn[:, 2, 0],
                     turn[:, 1, 0] - turn[:, 0, 1]], axis=1) / 2  # fmt: skip
    small = axis * (times * 200 - k)[:, None]  # angles of 1/20 degree: the sine equals the angle
    ahead = np.array([50.0, 0, 0])
    moved = ahead + np.cross(small, ahead) + np.cross(small, np.cross(small, ahead)) / 2
    expected = np.einsum("nij,nj->ni", first, moved)
    found = georeference(
        np.tile(ahead, (500, 1)), times, trajectory, Mounting(np.zeros(3), np.zeros(3))
    )
    assert np.linalg.norm(found - expected, axis=1).max() < 5e-5
