"""Tests of the S-44 and USGS values against sampled boresights and planes of known distance."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.result import AdjustmentResult
from lispac.geometry.rotations import rotation_matrix
from lispac.present.calibration.displacement import EFFECT_DISTANCES_M, s44_contributions
from lispac.present.checking.validation import swath_overlap
from lispac.report.html import html_text
from lispac.survey.georeferencing import Mounting
from lispac.validation.comparison_results import SignedStatistics
from lispac.validation.plane_comparison import signed_distances
from tests.report.test_report import _page
from tests.support.report_sample import FULL_REPORT, sample_content, sample_project


def _result(folder: Path, boresight_deg: tuple[float, float, float]) -> AdjustmentResult:
    result = sample_project(folder).result
    assert result is not None
    return replace(result, mounting=Mounting(np.zeros(3), np.radians(boresight_deg)))


@pytest.mark.parametrize("boresight_deg", [(0.4, -1.9, 0.4), (90.0, 35.0, -120.0)])
def test_contributions_equal_those_of_the_worst_beam(
    tmp_path: Path, boresight_deg: tuple[float, float, float]
) -> None:
    result = _result(tmp_path, boresight_deg)
    rng = np.random.default_rng(5)
    draws = rng.multivariate_normal(result.boresight, result.covariance, 4000)
    true = rotation_matrix(*result.boresight)
    turns = np.stack([rotation_matrix(*angles) for angles in draws]) @ true.T - np.eye(3)
    beams = rng.normal(size=(1500, 3))
    # Level beams move farthest vertically, so some beams are level.
    beams[:400, 2] = 0
    beams /= np.linalg.norm(beams, axis=1)[:, None]
    distance = EFFECT_DISTANCES_M[1]
    (at,) = (each for each in s44_contributions(result) if each.distance_m == distance)
    worst_height, worst_plane = 0.0, 0.0
    for beam in beams:
        moved = distance * turns @ beam
        worst_height = max(worst_height, float(moved[:, 2].std()))
        axes = np.linalg.eigvalsh(np.cov(moved[:, :2].T))
        worst_plane = max(worst_plane, float(np.sqrt(axes[-1])))
        assert np.mean(np.abs(moved[:, 2]) <= at.tvu95_m) >= 0.94
        assert np.mean(np.hypot(moved[:, 0], moved[:, 1]) <= at.thu95_m) >= 0.94
    assert at.tvu95_m == pytest.approx(1.96 * worst_height, rel=0.03)
    assert at.thu95_m == pytest.approx(2.45 * worst_plane, rel=0.03)


def test_contribution_of_roll_alone_is_distance_times_angle(tmp_path: Path) -> None:
    result = _result(tmp_path, (0.0, 0.0, 0.0))
    only_roll = replace(
        result, estimated=("roll", "pitch", "yaw"),
        covariance_all=np.diag([np.radians(0.02) ** 2, 0, 0]), parameters=(),
    )  # fmt: skip
    for at in s44_contributions(only_roll):
        # A lateral beam moves vertically and a vertical one laterally, by distance times angle.
        assert at.tvu95_m == pytest.approx(1.96 * np.radians(0.02) * at.distance_m, rel=1e-9)
        assert at.thu95_m == pytest.approx(2.45 * np.radians(0.02) * at.distance_m, rel=1e-9)


@pytest.mark.parametrize("offset", [0.0, 0.002, 0.02])
def test_rms_of_planes_of_known_distance(offset: float) -> None:
    rng = np.random.default_rng(11)
    noise = 0.001
    a, b = (np.column_stack([rng.uniform(0, 2, (6000, 2)), np.zeros(6000)]) for _ in range(2))
    a[:, 2] = offset + rng.normal(0, noise, len(a))
    b[:, 2] = rng.normal(0, noise, len(b))
    found = SignedStatistics.of(
        signed_distances(a, b, (a, b), facing=np.array([0.0, 0, 1]), spacing=0.025, reach=0.05)
    )
    assert found.rms is not None
    assert found.rms**2 == pytest.approx(found.mean**2 + _variance(found, a, b), rel=0.2)
    # The means of about a dozen points of each line have far less noise than the points.
    assert found.rms == pytest.approx(offset, abs=0.6 * noise)


def _variance(found, a: np.ndarray, b: np.ndarray) -> float:
    """Return the variance of a difference of means in a cylinder of 10 cm diameter."""
    per_cylinder = len(a) / 4 * np.pi * 0.05**2
    return 2 * 0.001**2 / per_cylinder


def test_the_value_of_all_planes_is_weighted_by_their_places(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    found = swath_overlap(project.validation)
    assert [each.plane for each in found] == ["V1", "V2", "V3", ""]
    assert [each.pairs for each in found] == [4, 4, 4, 12]
    assert found[-1].places == 12 * 400
    for each in found[:3]:
        assert each.rmsd_after_m == pytest.approx(np.hypot(0.0012, 0.002))
    scales = np.array([0.04, 0.09, 0.4])
    assert found[-1].rmsd_before_m == pytest.approx(np.sqrt(np.mean(scales**2 + 0.002**2)))


def test_a_comparison_of_an_earlier_version_has_no_table(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    plane = project.validation[0]
    pair = plane.pairs[0]
    assert pair.after.signed is not None
    old = replace(pair, after=replace(pair.after, signed=replace(pair.after.signed, rms=None)))
    assert swath_overlap([replace(plane, pairs=(old,))]) == ()
    assert swath_overlap([]) == ()
    bare = sample_content(replace(project, validation=(replace(plane, pairs=(old,)),)))
    assert "Swath overlap difference" not in html_text(bare, {}, FULL_REPORT)


def test_the_report_names_the_standards_and_their_editions(tmp_path: Path) -> None:
    words = " ".join(
        _page(html_text(sample_content(sample_project(tmp_path)), {}, FULL_REPORT)).words
    )
    assert "IHO S-44, edition 6.1.0" in words
    assert "contribution of the boresight alone" in words
    assert "USGS Lidar Base Specification (2024 rev. A)" in words
