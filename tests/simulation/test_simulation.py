"""Tests of the built-in survey: exact geometry, and errors with their nominal statistics."""

import numpy as np
import pytest

from lispac.errors import Cancelled
from lispac.geometry.frames import LocalFrame
from lispac.progress import Step
from lispac.simulation.port_scene import TARGET_NAMES, VALIDATION_NAMES
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS, gauss_markov
from lispac.simulation.scene import Cylinder, Scene, tilted_rectangle, upright_rectangle
from lispac.simulation.simulated_survey import SimulatedLine, SimulatedSurvey, port_survey
from lispac.survey.georeferencing import Mounting, georeference
from lispac.survey.trajectory import LocalTrajectory, Trajectory
from tests.support.long_runs import LONG

SPARSE_PULSES = 20_000.0  # pulses per second where density does not matter


@pytest.fixture
def survey(port: SimulatedSurvey) -> SimulatedSurvey:
    return port


def placed(survey: SimulatedSurvey, line: SimulatedLine, boresight=None) -> np.ndarray:
    """Georeference a line with the data that a user reads from the files of the survey."""
    t = survey.trajectory
    attitude = np.stack([t.roll, t.pitch, t.heading], axis=1)
    reported = Trajectory(t.time, t.latitude, t.longitude, t.height, attitude)
    trajectory = LocalTrajectory.of(reported, LocalFrame(*survey.origin))
    mounting = Mounting(survey.lever_arm, survey.boresight if boresight is None else boresight)
    return georeference(line.points_lidar, line.time, trajectory, mounting)


def distances_to_surfaces(survey: SimulatedSurvey, line: SimulatedLine, points) -> np.ndarray:
    distance = np.full(len(points), np.nan)
    for label in np.unique(line.label[line.label >= 0]):
        chosen = line.label == label
        distance[chosen] = survey.scene.surfaces[label].distance(points[chosen])
    return distance


@pytest.mark.parametrize(
    "boresight_deg",
    [
        (-1.7, 0.4, -2.9),
        *(
            pytest.param(angles, marks=LONG)
            for angles in [(0.0, 0.0, 0.0), (2.0, 2.0, 2.0), (0.3, -3.1, 1.2)]
        ),
    ],
)
def test_points_without_errors_are_on_their_surfaces(boresight_deg):
    exact = port_survey(
        points_per_second=SPARSE_PULSES, boresight_deg=boresight_deg, noise=False, pos_errors=False
    )
    for line in exact.lines:
        assert line.label.min() >= 0
        points = placed(exact, line)
        # Latitude and longitude in radians are exact to about 1e-9 m.
        assert np.abs(distances_to_surfaces(exact, line, points)).max() < 1e-8
        np.testing.assert_allclose(points, line.true_points_local, atol=1e-8)


@LONG
def test_a_wrong_boresight_moves_points_off_their_surfaces():
    exact = port_survey(points_per_second=SPARSE_PULSES, noise=False, pos_errors=False)
    for angle in range(3):
        boresight = exact.boresight.copy()
        boresight[angle] += np.radians(0.001)
        worst = max(
            np.abs(distances_to_surfaces(exact, line, placed(exact, line, boresight))).max()
            for line in exact.lines
        )
        assert worst > 1e-4


def test_beams_of_the_profiler_are_in_a_plane(survey):
    for line in survey.lines:
        assert np.all(line.points_lidar[:, 0] == 0)
        assert np.all(np.diff(line.time) > 0)
        assert np.linalg.norm(line.points_lidar, axis=1).max() < 91


def test_noise_of_labelled_points_is_that_of_the_scanner(survey):
    """Georeferenced with the true states, points are off their surface by scanner noise only."""
    without_pos_errors = port_survey(pos_errors=False)
    for line in without_pos_errors.lines:
        points = placed(without_pos_errors, line)
        for name in TARGET_NAMES:
            label = without_pos_errors.surface_names.index(name)
            distance = without_pos_errors.scene[name].distance(points[line.label == label])
            assert np.abs(distance).max() < 0.02
            assert 0.0005 < distance.std() < 0.004
        mixed = line.label < 0
        assert 0 < mixed.mean() < 0.01
        off = np.linalg.norm(points - line.true_points_local, axis=1)
        assert np.median(off[mixed]) > 5 * np.median(off[~mixed])


def test_every_line_sees_both_targets(survey):
    for line in survey.lines:
        for name in TARGET_NAMES:
            label = survey.surface_names.index(name)
            assert np.count_nonzero(line.label == label) >= 400, (line.name, name)


def test_validation_planes_are_seen_from_opposite_lines(survey):
    assert set(survey.validation) == set(VALIDATION_NAMES)
    for name in VALIDATION_NAMES:
        label = survey.surface_names.index(name)
        headings = {
            x.heading_deg for x in survey.lines if np.count_nonzero(x.label == label) > 1000
        }
        pairs = [h for h in headings if (h + 180) % 360 in headings]
        assert len(pairs) >= 4, (name, headings)


def test_site_has_the_documented_layout(survey):
    scanner_height = survey.trajectory.true_position_local[:, 2].mean() + survey.lever_arm[2]
    for name, size in zip(TARGET_NAMES, [(1.23, 1.22), (1.23, 0.76)], strict=True):
        board = survey.scene[name]
        assert (board.width, board.height) == pytest.approx(size)
        assert 4 < board.centre[2] - scanner_height < 5.5
        for line in survey.lines:
            inside = (survey.trajectory.time >= line.time[0]) & (
                survey.trajectory.time <= line.time[-1]
            )
            track = survey.trajectory.true_position_local[inside]
            nearest = np.hypot(*(track - board.centre)[:, :2].T).min()
            assert 13 < nearest < 16.5
    assert survey.scene["T2"].normal == pytest.approx([0, np.sqrt(0.5), np.sqrt(0.5)])
    assert [line.heading_deg for line in survey.lines] == pytest.approx([0, 180, 45, 225, 315, 135])


def test_seeds_are_on_their_planes(survey):
    for name, seed in {**survey.targets, **survey.validation}.items():
        assert survey.scene[name].distance(seed[None])[0] == pytest.approx(0, abs=1e-12)


def test_motion_is_smooth_and_continuous(survey):
    t = survey.trajectory
    interval = np.diff(t.time)
    np.testing.assert_allclose(interval, 0.005, atol=1e-9)
    velocity = np.diff(t.true_position_local, axis=0) / 0.005
    assert np.abs(velocity).max() < 2.6
    assert np.abs(np.diff(velocity, axis=0) / 0.005).max() < 1.5
    assert np.degrees(np.abs(np.diff(t.true_attitude, axis=0) / 0.005)).max() < 15
    for line in survey.lines:
        assert t.time[0] + 10 < line.time[0] < line.time[-1] < t.time[-1] - 10


def test_heading_refers_to_north_at_the_vessel():
    exact = port_survey(points_per_second=SPARSE_PULSES, noise=False, pos_errors=False)
    t = exact.trajectory
    convergence = np.unwrap(t.heading) - t.true_attitude[:, 2]
    convergence -= 2 * np.pi * np.round(convergence / (2 * np.pi))
    expected = (t.longitude - exact.origin[1]) * np.sin(exact.origin[0])
    assert np.abs(expected).max() > 1e-6
    np.testing.assert_allclose(convergence, expected, atol=1e-7)


def test_the_nearest_surface_occludes_the_others():
    scene = Scene.of(
        [
            upright_rectangle("wall", (10.0, 0.0), 0.0, 5.0, 6.0, 180),
            upright_rectangle("board", (8.0, 0.0), 1.0, 2.0, 1.0, 180),
            Cylinder("post", 9.0, 2.0, 0.0, 4.0, 0.5),
        ]
    )
    origins = np.array([[0, 0, 1.5], [0, 0.6, 1.5], [0, 2.0, 1.5], [0, 2.0, 4.5], [0, 3.5, 1.5]])
    ranges, labels, cosines = scene.intersect(origins, np.tile([1.0, 0.0, 0.0], (5, 1)))
    assert [scene.names[label] if label >= 0 else None for label in labels] == [
        "board", "wall", "post", "wall", None,
    ]  # fmt: skip
    assert ranges[:4] == pytest.approx([8, 10, 8.5, 10])
    assert np.isinf(ranges[4])
    assert cosines[:4] == pytest.approx([1, 1, 1, 1])


def test_rays_end_at_their_range_and_do_not_go_backwards():
    scene = Scene.of([tilted_rectangle("roof", (0.0, 0.0, 3.0), 2.0, 2.0, 0, 45)])
    up = np.array([[0.0, 0.0, 1.0]])
    ranges, labels, cosines = scene.intersect(np.zeros((1, 3)), up)
    assert (ranges[0], labels[0], cosines[0]) == pytest.approx((3, 0, np.sqrt(0.5)))
    assert scene.intersect(np.zeros((1, 3)), -up)[1][0] == -1
    assert scene.intersect(np.zeros((1, 3)), up, max_range=2.9)[1][0] == -1


def test_no_point_is_behind_the_pier(survey):
    """No echo comes from inside or behind the block of the pier."""
    for line in survey.lines:
        n, w, u = line.true_points_local.T
        inside = (np.abs(n) < 10.9) & (w < -15.1) & (w > -59.9) & (u < 9.3)
        assert not inside.any()


def test_gauss_markov_errors_have_their_statistics():
    sigma, tau, interval = 0.012, 300.0, 1.0
    runs = np.stack(
        [
            gauss_markov(4000, interval, sigma, tau, stream)
            for stream in np.random.default_rng(7).spawn(400)
        ]
    )
    # 400 runs determine a standard deviation to 1 / sqrt(800) = 3.5 %; the tolerance is 4 sigma
    for sample in (0, 1, 500, 3999):
        assert runs[:, sample].std() == pytest.approx(sigma, rel=0.15)
    for lag in (100, 300, 900):
        products = (runs[:, lag:] * runs[:, :-lag]).mean() / sigma**2
        assert products == pytest.approx(np.exp(-lag / tau), abs=0.06)
    steps = np.diff(runs, axis=1).std()
    assert steps == pytest.approx(sigma * np.sqrt(2 * (1 - np.exp(-interval / tau))), rel=0.01)


def test_pos_errors_have_their_sigmas():
    draws = [
        HYDROGRAPHIC_INS.draw(1, 0.005, stream) for stream in np.random.default_rng(1).spawn(2000)
    ]
    position = np.array([d[0][0] for d in draws])
    attitude = np.array([d[1][0] for d in draws])
    np.testing.assert_allclose(position.std(axis=0), [0.012, 0.012, 0.020], rtol=0.08)
    np.testing.assert_allclose(np.degrees(attitude.std(axis=0)), [0.008, 0.008, 0.012], rtol=0.08)
    correlations = np.corrcoef(np.hstack([position, attitude]).T) - np.eye(6)
    assert np.abs(correlations).max() < 0.1


def test_errors_of_the_reported_trajectory_follow_the_model(survey):
    t = survey.trajectory
    reported = LocalFrame(*survey.origin).to_local(t.latitude, t.longitude, t.height)
    error = reported - t.true_position_local
    assert 0.001 < np.abs(error).max() < 0.1
    assert np.abs(np.diff(error, axis=0)).max() < 0.001
    exact = port_survey(points_per_second=SPARSE_PULSES, pos_errors=False).trajectory
    difference = np.degrees(np.stack([t.roll - exact.roll, t.pitch - exact.pitch], axis=1))
    assert 0.0005 < np.abs(difference).max() < 0.05


@LONG
def test_the_same_seed_gives_the_same_survey():
    first, second, other = (
        port_survey(points_per_second=SPARSE_PULSES, seed=seed) for seed in (5, 5, 6)
    )
    np.testing.assert_array_equal(first.trajectory.latitude, second.trajectory.latitude)
    np.testing.assert_array_equal(first.trajectory.heading, second.trajectory.heading)
    for a, b in zip(first.lines, second.lines, strict=True):
        for field in ("time", "points_lidar", "intensity", "label", "true_points_local"):
            np.testing.assert_array_equal(getattr(a, field), getattr(b, field))
    assert not np.array_equal(first.trajectory.latitude, other.trajectory.latitude)


def test_simulation_reports_progress_and_can_be_cancelled():
    fractions: list[float] = []

    def stop_at_half(fraction: float, step: Step | None = None) -> None:
        fractions.append(fraction)
        if fraction >= 0.5:
            raise Cancelled

    with pytest.raises(Cancelled):
        port_survey(points_per_second=SPARSE_PULSES, progress=stop_at_half)
    assert fractions == pytest.approx([1 / 6, 2 / 6, 3 / 6])


def test_memory_of_the_simulation_is_limited(survey):
    t = survey.trajectory
    arrays = [v for x in (t, *survey.lines) for v in vars(x).values() if hasattr(v, "nbytes")]
    assert sum(a.nbytes for a in arrays) < 300e6
