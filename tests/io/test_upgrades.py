"""Tests of opening project files of every older version; `tests/data` has one of each."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.result import AdjustmentResult, CrossChecks
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.io.project.project_upgrades import SCHEMA_VERSION
from lispac.validation.absolute_messages import absolute_check_messages
from lispac.value_conversion import decode_value, encode_value
from lispac.workflow.project.projects import open_project
from tests.support.message_codes import codes
from tests.support.report_sample import sample_project

OLDER_PROJECTS = sorted(
    (Path(__file__).parents[1] / "data").glob("project-*"),
    key=lambda folder: int(folder.name.removeprefix("project-")),
)


@pytest.mark.parametrize("folder", OLDER_PROJECTS, ids=lambda folder: folder.name)
def test_an_older_project_opens_and_is_saved_in_the_new_version(
    folder: Path, tmp_path: Path
) -> None:
    copy = tmp_path / folder.name
    shutil.copytree(folder, copy)
    before = json.loads((copy / PROJECT_FILE_NAME).read_text())
    project = read_project(copy)
    assert [t.name for t in project.targets] == [t["name"] for t in before["targets"]]
    assert project.settings.pos_errors == before["settings"]["pos_errors"]
    assert project.settings.lever_arm == tuple(before["settings"]["lever_arm"])
    counts = [len(s.indices) for t in project.targets for s in t.sightings]
    assert counts == [s["points"] for t in before["targets"] for s in t["sightings"]]
    write_project(project)
    assert json.loads((copy / PROJECT_FILE_NAME).read_text())["schema_version"] == SCHEMA_VERSION
    assert read_project(copy).settings == project.settings


def test_a_setting_missing_in_an_older_project_has_its_default(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    project = replace(project, settings=replace(project.settings, accept_single_orientation=True))
    write_project(project)
    assert read_project(project.folder).settings.accept_single_orientation
    path = project.folder / PROJECT_FILE_NAME
    content = json.loads(path.read_text())
    del content["settings"]["accept_single_orientation"]
    path.write_text(json.dumps(content))
    assert not read_project(project.folder).settings.accept_single_orientation


def test_an_older_check_marks_its_unknown_values() -> None:
    check = read_project(OLDER_PROJECTS[5]).absolute
    assert check is not None
    assert check.other_surfaces is None
    assert "absolute.former_version" in codes(absolute_check_messages(check))


def test_every_version_has_its_fixture() -> None:
    assert [folder.name for folder in OLDER_PROJECTS] == [
        f"project-{k}" for k in range(1, SCHEMA_VERSION)
    ]


def test_results_are_read_as_written(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    assert project.result is not None
    assert project.result.reliability
    again = decode_value(json.loads(json.dumps(encode_value(project.result))), AdjustmentResult)
    assert encode_value(again) == encode_value(project.result)
    np.testing.assert_array_equal(again.covariance_all, project.result.covariance_all)
    if project.cross_checks is not None:
        checks = decode_value(
            json.loads(json.dumps(encode_value(project.cross_checks))), CrossChecks
        )
        assert encode_value(checks) == encode_value(project.cross_checks)


def test_a_result_with_a_foreign_key_is_refused(tmp_path: Path) -> None:
    content = encode_value(sample_project(tmp_path).result) | {"surprise": 1}
    with pytest.raises(ValueError, match="surprise"):
        decode_value(content, AdjustmentResult)


def test_open_project_opens_older_versions(tmp_path: Path) -> None:
    shutil.copytree(OLDER_PROJECTS[0], tmp_path / "old")
    assert open_project(tmp_path / "old").result is None


def test_sigmas_stay_given_or_assumed(tmp_path: Path) -> None:
    """Standard deviations of earlier versions are given; those that nobody gave stay assumed."""
    shutil.copytree(OLDER_PROJECTS[11], tmp_path / "old")
    old = read_project(tmp_path / "old")
    assert old.settings.assumed_sigmas == ()
    made = sample_project(tmp_path / "new")
    settings = replace(
        made.settings, lidar_sigma=None, position_sigma=(0.01, 0.01, 0.02),
        attitude_sigma_deg=None, lever_arm_sigma=(0.01, 0.0, 0.02), beam_divergence_mrad=0.3,
        variance_components=None,
    )  # fmt: skip
    write_project(replace(made, settings=settings))
    read = read_project(tmp_path / "new")
    assert read.settings == settings
    assert read.settings.assumed_sigmas == ("LiDAR", "POS attitude")
