"""Tests of the correction of the signs of roll and pitch of a project."""

from dataclasses import replace
from pathlib import Path

import pytest

from lispac.messages import warning
from lispac.project import Project
from lispac.survey.line_source import Reading
from lispac.workflow.project.attitude_signs import reversible_angles, with_reversed_signs
from tests.support.report_sample import sample_project

OTHER = warning("trajectory.heading_gap")


@pytest.fixture
def project(tmp_path: Path) -> Project:
    reading = Reading("ascii-trajectory", (("pitch", "bow-down"), ("time", "gps-week")))
    warnings = (
        warning("trajectory.roll_starboard_down", file="t.txt"),
        warning("trajectory.pitch_bow_down", file="t.txt"),
        OTHER,
    )
    made = sample_project(tmp_path)
    return replace(
        made,
        trajectory_reading=reading,
        reading_warnings=warnings,
        data_messages=warnings,
    )


def test_a_reversed_sign_is_read_and_is_no_longer_assumed(project: Project) -> None:
    assert reversible_angles(project) == ("roll", "pitch")
    both = with_reversed_signs(project, ("roll", "pitch"))
    assert dict(both.trajectory_reading.options) == {
        "roll": "port-down", "pitch": "bow-up", "time": "gps-week",
    }  # fmt: skip
    assert both.reading_warnings == both.data_messages == (OTHER,)
    assert both.result is None
    assert both.validation == ()
    assert both.targets == project.targets
    again = with_reversed_signs(both, ("roll", "pitch"))
    assert dict(again.trajectory_reading.options)["pitch"] == "bow-down"
    only = with_reversed_signs(project, ("pitch",))
    assert [each.code for each in only.reading_warnings] == [
        "trajectory.roll_starboard_down", OTHER.code,
    ]  # fmt: skip
    assert with_reversed_signs(project, ()) is project


def test_georeferenced_lines_and_formats_without_signs_permit_no_reversal(
    project: Project,
) -> None:
    first, *others = project.lines
    on_map = replace(first, reading=Reading(options=(("frame", "georeferenced"),)))
    assert reversible_angles(replace(project, lines=(on_map, *others))) == ()
