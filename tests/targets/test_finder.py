"""Tests of finding planes from a seed in one line and in all lines."""

import json
from dataclasses import replace
from math import radians
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import Cancelled, InputError, PlaneNotFound
from lispac.geometry.frames import LocalFrame
from lispac.geometry.planes import plane_axes
from lispac.geometry.radius_search import PointGrid, points_within
from lispac.geometry.rotations import rotation_matrix
from lispac.io.las.las_format import read_scan
from lispac.io.trajectory.sbet import read_sbet
from lispac.message_texts import message_text
from lispac.messages import error
from lispac.progress import no_progress
from lispac.survey.georeferencing import Mounting, georeference
from lispac.survey.scan import Scan
from lispac.survey.trajectory import LocalTrajectory
from lispac.targets.line_search import ShapeSearch, search_target_in_lines
from lispac.targets.plane_finder import FinderSettings, find_plane, seed_text
from lispac.targets.planes_across_lines import find_in_lines
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG, others_long

SETTINGS = FinderSettings()
CENTRE = np.array([0.0, 20.0, 4.0])


def sheet(rng, centre, normal, width, height, *, spacing=0.025, noise=0.002):
    """Points of a flat board in scan lines, three times as dense along them as across."""
    u = np.arange(-width / 2, width / 2, spacing * 1.7)
    v = np.arange(-height / 2, height / 2, spacing / 1.7)
    placed = np.stack(np.meshgrid(u - u.mean(), v - v.mean()), axis=-1).reshape(-1, 2)
    placed = placed + rng.uniform(-0.2, 0.2, placed.shape) * spacing
    normal = np.asarray(normal, float) / np.linalg.norm(normal)
    return (
        np.asarray(centre)
        + placed @ plane_axes(normal)
        + rng.normal(0, noise, (len(placed), 1)) * normal
    )


def scene(rng, *, normal=(0, -1, 0), gap=0.3, noise=0.002, size=(1.23, 1.22)):
    """A board before a wall, with mixed pixels between their edges, as seen from the origin.

    The labels are true on the board; the occluded part of the wall is omitted.
    """
    unit = np.asarray(normal, float) / np.linalg.norm(normal)
    board = sheet(rng, CENTRE, unit, *size, noise=noise)
    wall = sheet(rng, CENTRE + [0, gap, -0.5], (0, -1, 0), 7.0, 5.0, noise=noise)
    hit = (
        wall * (CENTRE @ unit / (wall @ unit))[:, None]
    )  # intersection of the ray to the wall with the plane of the board
    beside = np.abs((hit - CENTRE) @ plane_axes(unit).T) - np.array(size) / 2
    behind = np.linalg.norm(hit, axis=1) < np.linalg.norm(wall, axis=1)
    hidden = (beside < 0).all(axis=1) & behind
    rim = hidden & (beside > -0.03).any(axis=1)
    mixed = hit[rim] + rng.uniform(0, 1, (np.count_nonzero(rim), 1)) * (wall[rim] - hit[rim])
    points = np.concatenate([board, wall[~hidden], mixed])
    return points, np.arange(len(points)) < len(board)


def precision_and_recall(indices, truth):
    right = np.count_nonzero(truth[indices])
    return right / len(indices), right / np.count_nonzero(truth)


@pytest.mark.parametrize(
    ("normal", "gap", "noise"),
    [
        ((0, -1, 0), 0.3, 0.002),
        ((0, -1, 0), 0.3, 0.0),
        ((0, -1, 0), 0.05, 0.002),  # mounted 5 cm before the wall
        ((0, -1, 1), 0.8, 0.003),  # 45 degrees
        ((0.5, -1, 0.2), 0.8, 0.003),
        ((0.1, 0.1, 1), 1.0, 0.003),  # nearly level
    ],
)
def test_a_board_is_separated_from_the_wall_behind_it(normal, gap, noise):
    points, truth = scene(np.random.default_rng(1), normal=normal, gap=gap, noise=noise)
    patch = find_plane(points, CENTRE + [0.2, -0.05, 0.1], SETTINGS)
    precision, recall = precision_and_recall(patch.indices, truth)
    # At this distance every sixth mixed pixel is within the noise of the board.
    assert precision > (0.99 if gap > 0.1 else 0.985), (precision, recall)
    assert recall > 0.95, (precision, recall)
    assert np.abs(patch.plane.distances(CENTRE)) < 0.001
    np.testing.assert_allclose(patch.centre, CENTRE, atol=0.02)
    np.testing.assert_allclose(patch.extent, [1.23, 1.22], atol=0.06)
    assert patch.rms == pytest.approx(noise, rel=0.1, abs=1e-9)
    np.testing.assert_array_equal(patch.indices, np.unique(patch.indices))


def test_a_wall_is_cut_at_the_radius_and_contains_no_point_of_the_board():
    points, truth = scene(np.random.default_rng(2))
    seed = CENTRE + [2.0, 0.3, -1.0]
    patch = find_plane(points, seed, FinderSettings(radius=1.0))
    assert not truth[patch.indices].any()
    reach = np.linalg.norm(points[patch.indices] - seed, axis=1)
    assert 0.95 < reach.max() <= 1.0
    np.testing.assert_allclose(patch.extent, [2.0, 2.0], atol=0.06)


def test_noise_wider_than_the_threshold_needs_a_wider_threshold():
    points, truth = scene(np.random.default_rng(3), noise=0.02, gap=0.5)
    patch = find_plane(points, CENTRE, FinderSettings(threshold=0.06))
    precision, recall = precision_and_recall(patch.indices, truth)
    # Mixed pixels within 6 cm of the board cannot be distinguished from its noise.
    assert precision > 0.97
    assert recall > 0.95


def test_result_is_reproducible_and_independent_of_the_point_order():
    points, _ = scene(np.random.default_rng(4))
    points[5] = np.nan
    first = find_plane(points, CENTRE, SETTINGS)
    again = find_plane(points.copy(), CENTRE, SETTINGS, index=PointGrid(points, 0.5))
    np.testing.assert_array_equal(first.indices, again.indices)
    np.testing.assert_array_equal(first.plane.normal, again.plane.normal)
    order = np.random.default_rng(0).permutation(len(points))
    shuffled = find_plane(points[order], CENTRE, SETTINGS)
    np.testing.assert_array_equal(np.sort(order[shuffled.indices]), first.indices)
    np.testing.assert_array_equal(first.plane.normal, shuffled.plane.normal)
    for seed in (1, 2, 3):  # the random draws differ, but the refit gives the same plane
        drawn = find_plane(points, CENTRE, replace(SETTINGS, seed=seed))
        np.testing.assert_array_equal(first.indices, drawn.indices)


def test_only_planes_near_the_expected_normal_are_taken():
    rng = np.random.default_rng(5)
    crossing = rng.uniform(-0.5, 0.5, (2, 3000, 3)) * [[[1, 0, 1]], [[1, 1, 0]]]
    points = CENTRE + crossing.reshape(-1, 3) + rng.normal(0, 0.002, (6000, 3))
    for normal in ([0.1, -1.0, 0.05], [0.0, 0.1, 1.0]):
        patch = find_plane(points, CENTRE, SETTINGS, expected_normal=np.array(normal))
        assert patch.plane.normal @ normal > 0.98
    with pytest.raises(PlaneNotFound):
        find_plane(points, CENTRE, SETTINGS, expected_normal=np.array([1.0, 0.0, 0.0]))


@pytest.mark.parametrize(
    ("points", "seed", "code", "params"),
    [
        (np.zeros((0, 3)), CENTRE, "finder.no_points_near", {"radius": 2.0}),
        (
            np.zeros((500, 3)),
            CENTRE,
            "finder.no_points",
            {"distance": pytest.approx(20.4, abs=0.005)},
        ),
        (np.full((500, 3), np.nan), CENTRE, "finder.no_points_near", {}),
        (np.eye(3)[:2] + CENTRE, CENTRE, "finder.few_points", {"count": 2}),
        (
            CENTRE + np.random.default_rng(0).uniform(-1, 1, (400, 3)),
            CENTRE,
            "finder.plane_few_points",
            {},
        ),
        (
            CENTRE + np.outer(np.linspace(-1, 1, 300), [1, 2, 3]) / 4,
            CENTRE,
            "finder.no_plane",
            {},
        ),
        (np.zeros((500, 3)), np.array([np.nan, 0, 0]), "finder.seed", {}),
        (np.zeros((500, 3)), np.zeros(2), "finder.seed", {}),
    ],
)
def test_without_a_plane_the_reason_is_given(points, seed, code, params):
    with pytest.raises(PlaneNotFound, check=has_code(code, **params)):
        find_plane(points, seed, SETTINGS)


@pytest.mark.parametrize(
    "wrong", [{"radius": 0}, {"threshold": np.nan}, {"stop": 1.0}, {"min_points": 2}]
)
def test_invalid_settings_are_refused(wrong):
    with pytest.raises(InputError, check=has_code("finder.setting", name=next(iter(wrong)))):
        FinderSettings(**wrong)


def moved_lines(count=4, *, seed=6, tilt_deg=3.0, shift=1.2, make=scene):
    """The same scene as displaced on each line by a wrong boresight."""
    rng = np.random.default_rng(seed)
    clouds, truths = {}, {}
    for k in range(count):
        points, truth = make(rng)
        turn = rotation_matrix(*rng.uniform(-1, 1, 3) * radians(tilt_deg) * (k > 0))
        direction = rng.normal(size=3)
        step = direction / np.linalg.norm(direction) * shift * (k > 0)
        clouds[f"L{k + 1}"] = (points - CENTRE) @ turn.T + CENTRE + step
        truths[f"L{k + 1}"] = truth
    return clouds, truths


@pytest.mark.parametrize("first_line", ["L1", None])
def test_a_target_is_found_at_its_displaced_place_in_each_line(first_line):
    clouds, truths = moved_lines()
    found, missing = find_in_lines(clouds, CENTRE, SETTINGS, first_line=first_line)
    assert missing == {}
    for name, patch in found.items():
        precision, recall = precision_and_recall(patch.indices, truths[name])
        assert precision > 0.99, (name, precision, recall)
        assert recall > 0.95, (name, precision, recall)
        assert patch.plane.normal @ found["L1"].plane.normal > 0.99


def test_two_equal_neighbouring_targets_are_not_swapped():
    def equal_boards(rng):
        boards = [sheet(rng, CENTRE + [x, 0, 0], (0, -1, 0), 0.6, 0.8) for x in (0, 1.0)]
        wall = sheet(rng, CENTRE + [0, 0.5, -2.2], (0, -1, 0), 7, 3)
        points = np.concatenate([*boards, wall])
        return points, np.arange(len(points)) < len(boards[0])

    clouds, truths = moved_lines(6, shift=0.7, make=equal_boards)
    found, missing = find_in_lines(clouds, CENTRE, SETTINGS, first_line="L1")
    assert missing == {}
    for name, patch in found.items():
        assert min(precision_and_recall(patch.indices, truths[name])) > 0.95, name


def test_a_line_without_the_target_has_a_reason():
    clouds, _ = moved_lines(2)
    clouds["away"] = clouds["L1"] + [50.0, 0, 0]
    clouds["empty"] = np.empty((0, 3))
    rng = np.random.default_rng(8)
    clouds["ground"] = sheet(rng, CENTRE - [0, 0, 1.5], (0, 0, 1), 6, 6, spacing=0.05)
    found, missing = find_in_lines(clouds, CENTRE, SETTINGS, first_line="L1")
    assert set(found) == {"L1", "L2"}
    assert missing["away"].code == missing["empty"].code == "finder.line_no_points"
    assert missing["ground"].code


def test_the_reason_of_another_line_names_the_predicted_position_and_not_the_seed():
    def refuse(name):
        raise PlaneNotFound(error("finder.no_plane", place=seed_text(CENTRE + 4), threshold=0.015))

    shape = ShapeSearch(
        no_line="finder.no_line_for_plane",
        in_no_line="finder.no_plane_in_lines",
        error=PlaneNotFound,
        find=lambda name: "patch",
        distance=lambda name, patch: 0.0,
        follow=lambda name, patch: refuse,
    )
    clouds = {"L1": CENTRE[None], "L2": CENTRE[None]}
    found, missing = search_target_in_lines(clouds, {}, CENTRE, shape, "L1", no_progress)
    assert found == {"L1": "patch"}
    assert missing["L2"].code == "finder.no_plane"
    assert "position predicted on this line" in message_text(missing["L2"])


def test_a_seed_in_empty_space_or_an_unknown_line_is_refused():
    clouds, _ = moved_lines(2)
    with pytest.raises(PlaneNotFound, check=has_code("finder.no_plane_in_lines")):
        find_in_lines(clouds, CENTRE + [0, 0, 100], SETTINGS)
    with pytest.raises(PlaneNotFound, check=has_code("finder.no_points")):
        find_in_lines(clouds, CENTRE + [0, 0, 100], SETTINGS, first_line="L1")
    with pytest.raises(PlaneNotFound, check=has_code("finder.unknown_line", line="L9")):
        find_in_lines(clouds, CENTRE, SETTINGS, first_line="L9")


def test_the_search_reports_progress_and_can_be_cancelled():
    clouds, _ = moved_lines(3)
    calls = []
    find_in_lines(
        clouds, CENTRE, SETTINGS, first_line="L1",
        progress=lambda fraction, message="": calls.append((fraction, message)),
    )  # fmt: skip
    assert calls[-1][0] == 1.0
    assert "L3" in str(calls[-1][1])

    def cancel(fraction, message=""):
        raise Cancelled

    with pytest.raises(Cancelled):
        find_in_lines(clouds, CENTRE, SETTINGS, first_line="L1", progress=cancel)


class SharedSurvey:
    """A reference survey and its clouds for any boresight."""

    def __init__(self, folder: Path) -> None:
        self.site = json.loads((folder / "site.json").read_text())
        lat, lon, height = self.site["origin_deg_m"]
        frame = LocalFrame(radians(lat), radians(lon), height)
        self.trajectory = LocalTrajectory.of(read_sbet(folder / "trajectory.sbet"), frame)
        self.scans = {path.stem: read_scan(path) for path in sorted(folder.glob("*.laz"))}

    def clouds(self, boresight_deg):
        mounting = Mounting(np.array(self.site["lever_arm_m"]), np.radians(boresight_deg))
        return {
            name: georeference(scan.points_lidar, scan.time, self.trajectory, mounting)
            for name, scan in self.scans.items()
        }


@pytest.fixture(scope="module")
def harbour(shared_data):
    survey = SharedSurvey(shared_data / "harbour")
    truth = json.loads((shared_data / "harbour" / "truth.json").read_text())["boresight_deg"]
    places = {**survey.site["targets_nwu"], **survey.site["validation_nwu"]}
    clouds = survey.clouds(truth)
    for name, scan in survey.scans.items():  # points far from all targets only take time
        near = np.zeros(len(scan.points_lidar), dtype=bool)
        for key, place in places.items():
            reach = 22.0 if key == "V5" else 7.5
            near[points_within(clouds[name], np.array(place["centre"]), reach)] = True
        survey.scans[name] = Scan(scan.points_lidar[near], scan.time[near])
        clouds[name] = clouds[name][near]
    return survey, np.array(truth), clouds


@pytest.mark.parametrize(
    ("offset_deg", "seed_off"),
    others_long(
        [
            (None, (0, 0, 0)),  # the prior of the site: no boresight at all
            ((0, 0, 0), (0.3, 0.2, 0.17)),
            ((1, 1, 1), (-0.2, -0.3, -0.17)),
            ((-2, 2, 1), (0.3, 0.2, 0.17)),
            ((2, -2, -2), (0, 0, 0)),
        ],
        lambda value: value[0] in (None, (-2, 2, 1)),
    ),
)
def test_harbour_targets_are_found_in_every_line(harbour, offset_deg, seed_off):
    survey, truth, true_clouds = harbour
    prior = np.zeros(3) if offset_deg is None else truth + offset_deg
    clouds = survey.clouds(prior)
    for target in survey.site["targets_nwu"].values():
        centre, normal = np.array(target["centre"]), np.array(target["normal"])
        found, missing = find_in_lines(clouds, centre + seed_off, SETTINGS)
        assert missing == {}
        half = np.array([target["width"], target["height"]]) / 2
        for name, patch in found.items():
            # True places of the points; the POS displaces them by some centimetres.
            off = true_clouds[name] - centre
            beside = np.abs(off @ plane_axes(normal).T) - half
            on = (np.abs(off @ normal) < 0.05) & (beside < 0.03).all(axis=1)
            near = (np.abs(off @ normal) < 0.06) & (beside < 0.05).all(axis=1)
            precision = near[patch.indices].mean()
            recall = np.isin(np.flatnonzero(on), patch.indices).mean()
            assert precision > 0.99, (name, precision, recall)
            assert recall > 0.95, (name, precision, recall)


@pytest.mark.parametrize(
    ("name", "radius"),
    others_long(
        [("V1", 2), ("V2", 2), ("V3", 4), ("V4", 2), ("V5", 20)],
        lambda value: value[0] in ("V1", "V5"),
    ),
)
def test_harbour_validation_planes_are_found_on_two_lines_or_more(harbour, name, radius):
    survey, _, _ = harbour
    plane = survey.site["validation_nwu"][name]
    found, missing = find_in_lines(
        survey.clouds(np.zeros(3)), np.array(plane["centre"]), FinderSettings(radius=radius)
    )
    assert len(found) >= 2, missing
    for patch in found.values():
        # V5 faces eight degrees away from south, its documented direction.
        assert abs(patch.plane.normal @ plane["normal"]) > np.cos(radians(10))
        assert patch.rms < 0.006


@LONG
@pytest.mark.parametrize(
    "name", others_long(["lanl_truck", "lanl_tent"], lambda name: name == "lanl_tent")
)
def test_real_natural_planes_are_found_in_both_lines(shared_data, name):
    survey = SharedSurvey(shared_data / name)
    labels = np.load(shared_data / name / "labels.npz")
    reference = json.loads((shared_data / name / "reference.json").read_text())["boresight_deg"]
    settings = FinderSettings(threshold=0.06)
    seeds = {key: np.array(seed) for key, seed in survey.site["seeds_nwu_on_line1"].items()}
    prior, after = survey.clouds(np.zeros(3)), survey.clouds(reference)
    found_prior = {key: find_in_lines(prior, seed, settings)[0] for key, seed in seeds.items()}
    assert sum(len(found) == 2 for found in found_prior.values()) >= len(seeds) - 2
    # The clicked points move with the boresight, after which the lines agree.
    right = total = 0
    for key, seed in seeds.items():
        clicked = int(np.argmin(np.linalg.norm(prior["line1"] - seed, axis=1)))
        found, _ = find_in_lines(after, after["line1"][clicked], settings, first_line="line1")
        for line, patch in found.items():
            label = labels[line][patch.indices]
            share = np.mean(label == int(key[1:]) - 1)
            print(f"{name} {key} {line}: {len(label)} points, {share:.2f} of them labelled so")
            other = np.mean((label >= 0) & (label != int(key[1:]) - 1))
            right, total = right + (other < 0.3), total + 1
    assert right >= total - 2
