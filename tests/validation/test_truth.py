"""Tests of distances between lines before and after calibration and with the true boresight."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.model.point_sensitivity import sensitivity
from lispac.errors import ProjectError
from lispac.geometry.planes import fit_plane, plane_axes
from lispac.project import Project, Target
from lispac.survey.trajectory import Poses
from lispac.workflow.checking.validation import validate_with_truth
from lispac.workflow.project.survey import Survey

MAX_POINTS = 2000
"""Points of a line used for its mean displacement, which varies little between points."""


def moves(project: Project, survey: Survey, plane: Target, lines: tuple[str, str]) -> np.ndarray:
    """Return derivatives (3,) of the offset between two lines by the angles, metres per radian.

    They are means over the part of the plane that both lines cover.
    """
    assert project.result is not None
    sightings = [plane.sighting(line) for line in lines]
    points = [survey.clouds[s.line][s.indices] for s in sightings]
    normal = fit_plane(np.concatenate(points)).normal
    facing = survey.trajectory.position.mean(axis=0) - np.array(plane.seed)
    normal = normal * np.sign(normal @ facing)
    placed = [each @ plane_axes(normal).T for each in points]
    low = np.max([each.min(axis=0) for each in placed], axis=0)
    high = np.min([each.max(axis=0) for each in placed], axis=0)
    found = []
    for sighting, where in zip(sightings, placed, strict=True):
        both = sighting.indices[((where >= low) & (where <= high)).all(axis=1)]
        some = both[:: max(1, len(both) // MAX_POINTS)]
        points_lidar, time = survey.scans[sighting.line].take(some)
        poses = survey.trajectory.at(time)
        moved = sensitivity(
            points_lidar, Poses(poses.position, poses.attitude), project.result.mounting,
            np.tile(normal, (len(time), 1)),
        )  # fmt: skip
        found.append(moved.by_mounting[:, :3].mean(axis=0))
    return np.asarray(found[0] - found[1])


def test_offsets_differ_from_those_of_the_truth_within_their_sigmas(
    calibrated: tuple[Project, Survey], capsys: pytest.CaptureFixture[str]
) -> None:
    """`test_reference_surveys` does the same with a survey simulated by others."""
    with capsys.disabled():
        beside_truth(*calibrated)


def beside_truth(project: Project, survey: Survey) -> None:
    """Print the RMS between lines before, after and with the truth, and compare the last two.

    The offsets between lines differ from those with the true boresight in accordance with the
    covariance; both contain the POS errors of the lines. Two boards do not determine the angles
    well enough for all planes to agree within five per cent of the RMS.
    """
    true = validate_with_truth(project, survey)
    result, truth = project.result, np.radians(project.truth_deg)
    assert [each.name for each in true] == ["V1", "V2", "V3", "V4", "V5"]
    off, pairs = result.boresight - truth, []
    print(f"\n{project.name}: RMS between lines, mm: before, after, with the truth")
    ratios = []
    for found, best in zip(project.validation, true, strict=True):
        rms = [1000 * each.rms for each in (found.before, found.after, best.after)]
        print(f"{found.name} {rms[0]:8.1f} {rms[1]:8.1f} {rms[2]:8.1f}")
        plane = project.target(found.name)
        assert rms[1] < rms[0]
        for pair, ideal in zip(found.pairs, best.pairs, strict=True):
            by_angles = moves(project, survey, plane, (pair.line_a, pair.line_b))
            assert pair.after.planes is not None
            assert ideal.after.planes is not None
            change = pair.after.planes.offset - ideal.after.planes.offset
            pairs.append((change, by_angles @ off))
            ratios.append(change / np.sqrt(by_angles @ result.covariance @ by_angles))
    largest = float(np.abs(ratios).max())
    print(f"largest change of an offset between lines: {largest:.1f} of its sigmas")
    assert largest < 3.5
    # The derivatives are means over a box, the offset that of the part both lines cover.
    changes, expected = np.transpose(pairs)
    assert np.median(np.abs(changes - expected)) < 0.5e-3, pairs
    assert np.corrcoef(changes, expected)[0, 1] > 0.98, pairs


def test_truth_of_a_survey_that_is_not_simulated_is_refused(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    with pytest.raises(ProjectError) as raised:
        validate_with_truth(replace(project, truth_deg=None), survey)
    assert raised.value.code == "validate.not_simulated"
