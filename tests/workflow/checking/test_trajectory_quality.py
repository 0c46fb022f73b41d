"""Tests of the quality of the trajectory on each line."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.project import Project
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.output.export import trajectory_on_lines
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.few_lines import picked


@pytest.fixture(scope="module")
def survey(demo_project: Project) -> Survey:
    return load_survey(demo_project)


def test_quality_of_the_built_in_survey(survey: Survey) -> None:
    found = trajectory_on_lines(survey)
    assert [each.line for each in found] == list(survey.scans)
    for each in found:
        scan = survey.scans[each.line]
        ends = survey.trajectory.at(np.array([scan.first_time, scan.last_time])).position
        straight = np.linalg.norm(ends[1] - ends[0]) / each.duration_s
        assert each.duration_s == scan.last_time - scan.first_time
        assert (
            straight <= each.speed_m_s * 1.01 < 1.2 * straight
        )  # roll adds to the motion of the INS
        assert each.interval_s == pytest.approx(0.005, rel=1e-3)
        assert each.longest_gap_s == pytest.approx(0.005, rel=1e-2)
        # The sigmas of `make_demo`, which drift by a few per cent
        assert each.sigma_horizontal_m == pytest.approx(np.hypot(0.012, 0.012), rel=0.2)
        assert each.sigma_vertical_m == pytest.approx(0.020, rel=0.2)
        assert each.sigma_roll_pitch_deg == pytest.approx(0.008, rel=0.2)
        assert each.sigma_heading_deg == pytest.approx(0.012, rel=0.2)
        assert all(0.05 < motion < 5.0 for motion in each.motion_deg)


def test_a_gap_is_reported_on_its_line(survey: Survey) -> None:
    name, scan = next(iter(survey.scans.items()))
    middle = 0.5 * (scan.first_time + scan.last_time)
    whole = survey.trajectory
    kept = np.abs(whole.time - middle) > 0.25
    gappy = LocalTrajectory(
        whole.frame, whole.time[kept], whole.position[kept], whole.attitude[kept]
    )
    found = {each.line: each for each in trajectory_on_lines(replace(survey, trajectory=gappy))}
    assert found[name].longest_gap_s == pytest.approx(0.505, abs=0.006)
    assert all(each.longest_gap_s < 0.01 for line, each in found.items() if line != name)


def test_a_line_outside_the_trajectory_is_skipped() -> None:
    """The trajectory ends before L2, so neither speed nor interval are defined."""
    _, survey = picked()
    whole = survey.trajectory
    second = survey.scans["L2"]
    until = int(np.searchsorted(whole.time, second.first_time)) - 50
    short = LocalTrajectory(
        whole.frame, whole.time[:until], whole.position[:until], whole.attitude[:until]
    )
    assert [each.line for each in trajectory_on_lines(replace(survey, trajectory=short))] == ["L1"]
