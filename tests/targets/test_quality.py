"""Tests of sighting quality and of the comparison with an expected target, on known shapes."""

import re

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.geometry.planes import Plane, fit_plane
from lispac.geometry.spheres import Sphere
from lispac.targets.expected_target import ExpectedTarget, deviations_from_expected
from lispac.targets.plane_finder import patch_of
from lispac.targets.rough_alignment import Alignment
from lispac.targets.sighting_quality import SightingQuality, plane_quality, sphere_quality
from lispac.workflow.calibration.picking import find_target
from lispac.workflow.calibration.sighting_assessment import assess_target
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import codes, texts
from tests.targets.test_finder_sites import clicked_point, scenery

NOISE = 0.002


def quality_of(points: np.ndarray, **also: object) -> SightingQuality:
    return plane_quality(
        points, points, np.arange(len(points)), fit_plane(points), NOISE, **also
    )  # fmt: skip


def board(shape=lambda x, z: 0 * x, *, count=3000, size=(1.2, 1.0), noise=NOISE) -> np.ndarray:
    """Return points of an upright board 20 m west of the scanner, deformed by `shape`."""
    rng = np.random.default_rng(3)
    x, z = rng.uniform(-0.5, 0.5, (2, count)) * np.array(size)[:, None]
    west = 20.0 + shape(x, z) + rng.normal(0, noise, count)
    return np.stack([x, west, z], axis=1)


def test_a_flat_board_is_good_and_its_values_are_correct():
    quality = quality_of(board(), scanner_local=np.zeros(3))
    assert quality.rating == "good"
    assert quality.reasons == ()
    assert quality.points == 3000
    assert quality.rms == pytest.approx(NOISE, rel=0.05)
    assert quality.range == pytest.approx(20.0, abs=0.02)
    assert quality.density == pytest.approx(2500, rel=0.15)
    np.testing.assert_allclose(quality.extent, [1.2, 1.0], atol=0.01)
    assert quality.coverage > 0.97
    assert np.degrees(quality.incidence) < 2.0
    assert not quality.curved
    assert quality.roughness < 0.0004


def test_curvature_is_measured_and_reported():
    sagitta = 0.004  # over 1.2 m
    quality = quality_of(board(lambda x, z: 4 * sagitta * (x / 1.2) ** 2))
    assert quality.curved
    assert quality.curvature == pytest.approx(sagitta, rel=0.1)
    assert quality.rating == "doubtful"
    assert quality.reasons[0].code == "quality.curved"
    assert quality_of(board(lambda x, z: 0.04 * (x / 1.2) ** 2)).rating == "poor"


def test_noise_alone_is_not_called_curvature():
    rng = np.random.default_rng(0)
    called = sum(
        quality_of(
            np.stack([*(rng.uniform(-0.6, 0.6, (2, 600))), rng.normal(0, NOISE, 600)], 1)
        ).curved
        for _ in range(80)
    )
    assert called <= 1


@pytest.mark.parametrize(
    ("points", "light", "code"),
    [
        (board(count=150), "doubtful", "quality.few_points"),
        (board(count=40), "poor", "quality.few_points"),
        (board(noise=0.005), "doubtful", "quality.rough"),
        (board(noise=0.008), "poor", "quality.rough"),
        (board()[np.abs(board()[:, 0]) > 0.4], "poor", "quality.sparse"),
        (board(lambda x, z: 0.004 * np.sin(20 * x)), "doubtful", "quality.uneven"),
        (board(lambda x, z: 0.006 * np.sin(20 * x)), "poor", "quality.uneven"),
    ],
)
def test_defects_of_a_surface_are_reported(points, light, code):
    quality = quality_of(points)
    assert quality.rating == light
    assert code in codes(quality.reasons)


def test_grazing_incidence_is_poor():
    points = board()
    scanner = points.mean(axis=0) + 10 * np.array(
        [np.sin(np.radians(78)), -np.cos(np.radians(78)), 0]
    )
    quality = quality_of(points, scanner_local=scanner)
    assert np.degrees(quality.incidence) == pytest.approx(78, abs=0.5)
    assert quality.rating == "poor"
    assert quality.reasons[0].code == "quality.oblique"


def test_rating_of_a_sphere_follows_its_visible_share():
    rng = np.random.default_rng(1)
    directions = rng.normal(size=(20_000, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    sphere = Sphere(np.array([0.0, 15.0, 2.0]), 0.15)
    for edge, light in ((0.2, "good"), (0.7, "doubtful"), (0.8, "poor")):
        cap = directions[-directions[:, 1] > edge][:1000]
        points = sphere.centre + cap * (sphere.radius + rng.normal(0, NOISE, (len(cap), 1)))
        quality = sphere_quality(points, points, np.arange(len(points)), sphere, NOISE)
        assert quality.coverage == pytest.approx((1 - edge) / 2, abs=0.02)
        assert quality.rating == light, quality
        assert quality.rms == pytest.approx(NOISE, rel=0.1)


HALF_OCCLUDED = {
    # The bollard occludes one half of the board, but less of it from the north-west.
    # The error of the rough boresight and the noise of the outermost points change the width by
    # a few millimetres.
    "L1": ("poor", r"0\.6[0-2] m of 1\.2[34] m in width"),
    "L2": ("poor", r"0\.6[0-2] m of 1\.2[34] m in width"),
    "L3": ("doubtful", r"0\.70 m of 1\.2[34] m in width"),
    "L4": ("doubtful", r"0\.70 m of 1\.2[34] m in width"),
    "L5": ("good", ""),
    "L6": ("good", ""),
}
LINES = tuple(HALF_OCCLUDED)


@pytest.mark.parametrize("off_deg", [pytest.param((0, 0, 0), marks=LONG), (2, -2, 2)])
@pytest.mark.parametrize(
    ("name", "expected"),
    others_long(
        [
            ("5 cm proud", dict.fromkeys(LINES, ("good", ""))),
            ("bollard", HALF_OCCLUDED),
            ("rippled", dict.fromkeys(LINES, ("poor", "The surface is not flat"))),
        ]
    ),
)
def test_ratings_on_simulated_sites(name, expected, off_deg):
    """Targets are picked as in the window, with a prior boresight that is right or 2 deg wrong."""
    scene_site = scenery(name)
    project, survey = scene_site.opened(off_deg)
    target = find_target(project, survey, clicked_point(scene_site, survey.clouds), name="T1")
    found = assess_target(project, survey, target)
    assert set(found) == set(LINES)
    for line, (light, words) in expected.items():
        quality = found[line]
        assert re.search(words, texts(quality.reasons)), (line, quality.reasons)
        assert quality.rating == light, (line, quality.reasons)
        assert quality.flatness == ("poor" if name == "rippled" else "good"), (
            line,
            texts(quality.reasons),
        )


@pytest.mark.parametrize("off_deg", [(1, -1, 1), (-2, 2, -2)])
def test_ripples_are_not_attributed_to_the_boresight(off_deg):
    """The angles may be off by two degrees, on lines that pass the sheet at 45 deg."""
    scene_site = scenery("rippled")
    project, survey = scene_site.opened(off_deg)
    clouds = survey.clouds
    survey.__dict__["alignment"] = Alignment(clouds, clouds, 0.0, 0.0)
    target = find_target(project, survey, clicked_point(scene_site, clouds), name="T1")
    for line, quality in assess_target(project, survey, target).items():
        assert quality.visible_share is None
        assert quality.rating == "poor", line
        assert "beyond the threshold of 10 mm" in texts(quality.reasons)
        assert "quality.uneven" in codes(quality.reasons), (line, quality.reasons)
        assert "curved" not in texts(quality.reasons), (line, quality.reasons)
        assert quality.smear < 0.4 * quality.rms, (line, quality)
        assert f"The residuals (RMS {1000 * quality.rms:.1f} mm) are" in texts(quality.reasons)


def test_deviations_from_the_expected_target_are_reported():
    scene_site = scenery("5 cm proud")
    cloud = scene_site.clouds()["L1"]
    patch = patch_of(cloud, np.flatnonzero(scene_site.on("L1", "T1")), np.array([0.0, 1.0, 0.0]))
    upright = np.pi / 2
    assert (
        deviations_from_expected(
            ExpectedTarget(1.23, 1.22, upright), patch.extent, patch.plane.normal
        )
        == ()
    )
    expected = ExpectedTarget(2.0, 1.22, np.radians(45))
    narrower, steeper = deviations_from_expected(expected, patch.extent, patch.plane.normal)
    assert (narrower.code, narrower.params["expected"]) == ("quality.narrower", 2.0)
    assert narrower.params["off"] == pytest.approx(0.77, abs=0.03)
    assert steeper.code == "quality.steeper"
    assert np.degrees(steeper.params["off"]) == pytest.approx(45.0, abs=0.5)
    for wrong in ({"width": 0.0}, {"height": -1.0}, {"inclination": 2.0}):
        with pytest.raises(InputError):
            ExpectedTarget(**({"width": 1.0, "height": 1.0} | wrong))


def test_direction_of_the_normal_does_not_matter():
    points = board(lambda x, z: 0.02 * (x / 1.2) ** 2)
    plane = fit_plane(points)
    turned = Plane(-plane.normal, -plane.d)
    first, second = (
        plane_quality(points, points, np.arange(len(points)), each, NOISE)
        for each in (plane, turned)
    )
    assert first.curvature == pytest.approx(second.curvature, rel=0.05)
    assert first.rating == second.rating
