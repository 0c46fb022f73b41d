"""Tests of requests and data that the workflow refuses: which message, and nothing is lost."""

import errno
import json
import math
import os
import shutil
from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import laspy
import numpy as np
import pytest

from lispac.duplicate_targets import all_warnings
from lispac.errors import AdjustmentError, InputError, PlaneNotFound, ProjectError
from lispac.io.files import require_file
from lispac.io.project.project_file import read_project
from lispac.message_texts import message_text
from lispac.messages import Level, Message, error, note
from lispac.project import LineSource, PickedSighting, Project, Settings
from lispac.report.content import report_content
from lispac.warning_causes import Cause
from lispac.workflow.calibration import estimation as calibration
from lispac.workflow.calibration import picking
from lispac.workflow.checking.calibration_history import find_projects, read_histories
from lispac.workflow.checking.validation import validate
from lispac.workflow.planning.demo import make_demo
from lispac.workflow.project import projects
from lispac.workflow.project.project_copy import save_project_as
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.error_codes import has_code
from tests.support.message_codes import codes


def test_seed_in_empty_space_changes_nothing(copy: Project) -> None:
    survey = load_survey(copy)
    before = (copy.folder / "project.json").read_bytes()
    with pytest.raises(PlaneNotFound):
        picking.pick_target(copy, survey, (500.0, 500.0, 500.0), name="T9")
    assert (copy.folder / "project.json").read_bytes() == before


def test_unknown_line_is_named(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    with pytest.raises(ProjectError, check=has_code("project_line.not_found", line="L9")):
        picking.pick_target(project, survey, (0, 0, 0), name="T9", line="L9")


def test_a_target_on_only_one_line_is_not_used(
    calibrated: tuple[Project, Survey],
) -> None:
    """The result is that without the target; warnings and report name it."""
    project, survey = calibrated
    target = project.target("T1")
    for name in ("V1", "V5"):
        project = project.with_target(replace(project.target(name), role="target"))
    single = project.with_target(replace(target, sightings=target.sightings[:1]))
    found = calibration.estimate(single, survey, cross_check=False)
    project = project.with_target(replace(target, used=False))
    without = calibration.estimate(project, survey, cross_check=False)
    assert found.result is not None
    assert without.result is not None
    np.testing.assert_array_equal(found.result.boresight, without.result.boresight)
    assert "T1" not in {each.target for each in found.result.targets}
    for warnings in (all_warnings(found), all_warnings(replace(single, result=None))):
        (message,) = (each for each in warnings if each.code == "targets.single_line_targets")
        assert message.subject == Cause.of_target("T1")
    assert not any(each.code == "targets.single_line_targets" for each in all_warnings(without))
    report = report_content(
        found, headings_deg=dict.fromkeys(survey.lines, 0.0), counts={}, track_local={}, notes=(),
        generated=datetime(2026, 1, 1, tzinfo=UTC), digests=False,
    )  # fmt: skip
    assert "targets.single_line_targets" in {each.code for each in report.warnings}


def test_targets_on_one_line_each_are_refused(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    for k, target in enumerate(project.targets_of_role("target")):
        project = project.with_target(
            replace(target, sightings=target.sightings[k % 2 : k % 2 + 1])
        )
    with pytest.raises(AdjustmentError) as raised:
        calibration.estimate(project, survey)
    assert raised.value.code == "estimate.no_common_target"


def test_fewer_than_three_points_are_refused(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    target = project.target("T1")
    few = PickedSighting(target.sightings[0].line, target.sightings[0].indices[:2], 0.0)
    with pytest.raises(AdjustmentError, check=has_code("adjustment.few_points", count=2)):
        calibration.estimate(
            project.with_target(replace(target, sightings=(few, *target.sightings[1:]))), survey
        )


def test_adjustment_without_targets_is_refused(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    with pytest.raises(AdjustmentError) as raised:
        calibration.estimate(replace(project, targets=()), survey)
    assert raised.value.code == "estimate.no_target"
    with pytest.raises(ProjectError, check=lambda e: e.code == "project.not_estimated"):
        validate(replace(project, result=None), survey)
    only_targets = replace(project, targets=project.targets_of_role("target"))
    with pytest.raises(ProjectError) as raised:
        validate(only_targets, survey)
    assert raised.value.code == "validate.no_planes"


def test_moved_files_are_named_and_the_project_still_opens(copy: Project) -> None:
    before = (copy.folder / "project.json").read_bytes()
    (copy.folder / "raw").rename(copy.folder / "elsewhere")
    moved = projects.open_project(copy.folder)
    with pytest.raises(InputError) as raised:
        load_survey(moved)
    assert raised.value.code == "project_files.many_missing"
    assert "trajectory.sbet" in str(raised.value)
    assert (copy.folder / "project.json").read_bytes() == before


def test_missing_sighting_file_is_named(copy: Project) -> None:
    next((copy.folder / "sightings").glob("T1-*.npz")).unlink()
    with pytest.raises(ProjectError) as refused:
        projects.open_project(copy.folder)
    assert refused.value.code == "project.points_missing"
    assert refused.value.message.params["target"] == "T1"


def _forbidden(*_: object, **__: object) -> bool:
    raise PermissionError(errno.EACCES, "Permission denied")


def test_a_folder_without_permission_is_named(
    copy: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    project, survey = open_project(copy.folder), load_survey(copy)
    with monkeypatch.context() as patched:
        patched.setattr(Path, "is_file", _forbidden)
        with pytest.raises(ProjectError) as refused:
            read_project(copy.folder)
        assert refused.value.code == "project.unreadable"
        with pytest.raises(InputError) as denied:
            save_project_as(project, survey, tmp_path / "other")
        assert denied.value.code == "project_folder.not_writable"
    points = Path.is_file
    with monkeypatch.context() as patched:
        patched.setattr(
            Path,
            "is_file",
            lambda path: _forbidden() if path.suffix == ".npz" else points(path),
        )
        with pytest.raises(ProjectError) as refused:
            read_project(copy.folder)
        assert refused.value.code == "project.unreadable"
        assert refused.value.message is not None
        assert str(refused.value.message.params["file"]).endswith(".npz")
    with monkeypatch.context() as patched:
        patched.setattr(Path, "exists", _forbidden)
        with pytest.raises(InputError) as denied:
            require_file(tmp_path / "line.laz", "line")
        assert denied.value.code == "file.no_permission"
    with monkeypatch.context() as patched:
        patched.setattr(os, "access", lambda *_: False)
        with pytest.raises(ProjectError) as refused:
            find_projects([copy.folder])
        assert refused.value.code == "history.no_permission"


def test_folders_that_cannot_be_read_are_named(
    copy: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    closed = tmp_path / "closed"
    closed.mkdir()
    scan = os.scandir

    def scandir(path: str) -> Iterator[os.DirEntry[str]]:
        if Path(path) == closed:
            raise PermissionError(errno.EACCES, "Permission denied", str(path))
        return scan(path)

    monkeypatch.setattr(os, "scandir", scandir)
    found, unreadable = find_projects([tmp_path])
    assert found == [copy.folder]
    assert unreadable == [note("history.no_permission", folder=str(closed))]
    with pytest.raises(ProjectError) as nothing:  # the other project has no date
        read_histories([tmp_path])
    assert str(closed) in str(nothing.value)


def test_an_error_of_the_disk_names_the_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(*_: object, **__: object) -> None:
        raise OSError(errno.EIO, "Input/output error")  # an error of reading has no file name

    path = tmp_path / "line.laz"
    path.write_bytes(b"LASF")
    monkeypatch.setattr("lispac.io.files.require_uncompressed", failing)
    with pytest.raises(InputError) as refused:
        require_file(path, "line")
    assert refused.value.code == "file.not_readable"


@pytest.mark.parametrize("damage", ["{", "[]", "{}", '{"schema_version": 99}', "\x00"])
def test_damaged_project_file_is_refused(tmp_path: Path, damage: str) -> None:
    (tmp_path / "project.json").write_text(damage)
    with pytest.raises(ProjectError):
        projects.open_project(tmp_path)


def test_a_replaced_line_file_is_refused(copy: Project) -> None:
    """The stored indices are invalid for a shorter line or the points of another line."""
    first, second = copy.lines[0].path, copy.lines[1].path
    shutil.copyfile(second, first)
    with pytest.raises(InputError) as raised:
        load_survey(projects.open_project(copy.folder))
    assert raised.value.code == "import.other_points"
    assert first.name in str(raised.value)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (("settings", "lidar_sigma"), float("nan")),
        (("settings", "lidar_sigma"), "a"),
        (("settings", "pos_errors"), "foo"),
        (("result", "model", "pos_errors"), "foo"),
        (("targets", 0, "role"), "x"),
        (("targets", 0, "radius"), "q"),
        (("targets", 0, "sightings", 0, "line"), "gone"),
    ],
)
def test_implausible_values_are_refused(copy: Project, path: tuple[Any, ...], value: Any) -> None:
    file = copy.folder / "project.json"
    content = json.loads(file.read_text())
    place = content
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    file.write_text(json.dumps(content))
    with pytest.raises(ProjectError, match=r"project\.json: "):
        projects.open_project(copy.folder)


@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("", "target.invalid_name"),
        ("  ", "target.invalid_name"),
        ("a\nb", "target.invalid_name"),
        ("../x", "target.name_with_separator"),
        ("N" * 300, "target.invalid_name"),
    ],
)
def test_invalid_names_are_refused(
    calibrated: tuple[Project, Survey], name: str, code: str
) -> None:
    project, _ = calibrated
    with pytest.raises(ProjectError, check=has_code(code)):
        project.with_target(replace(project.target("T1"), name=name))


def test_points_in_a_gap_of_the_trajectory_are_skipped_and_reported(copy: Project) -> None:
    records = np.fromfile(copy.trajectory).reshape(-1, 17)
    scan = load_survey(copy).scans[copy.lines[0].name]
    middle = float(np.median(scan.time))
    records = records[np.abs(records[:, 0] - middle) > 3]
    records.tofile(copy.trajectory)
    last_before, first_after = (
        records[records[:, 0] < middle, 0].max(),
        records[records[:, 0] > middle, 0].min(),
    )
    survey = load_survey(replace(copy, targets=()))
    kept = survey.scans[copy.lines[0].name]
    assert len(kept) == np.count_nonzero((scan.time <= last_before) | (scan.time > first_after))
    assert "import.excluded_in_gaps" in codes(survey.notes)


def test_an_origin_far_from_the_survey_is_refused(copy: Project) -> None:
    far = replace(copy, settings=replace(copy.settings, origin_deg_m=(10.0, 10.0, 0.0)))
    with pytest.raises(InputError, check=has_code("import.origin_too_far")):
        load_survey(far)


def test_the_demo_does_not_overwrite_other_files(tmp_path: Path) -> None:
    (tmp_path / "raw").mkdir()
    (tmp_path / "raw" / "L1_000.laz").write_text("mine")
    with pytest.raises(ProjectError) as raised:
        make_demo(tmp_path)
    assert raised.value.code == "simulate.folder_in_use"
    assert (tmp_path / "raw" / "L1_000.laz").read_text() == "mine"


def test_a_target_cannot_change_its_role_on_one_line(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    line = survey.lines[0]
    with pytest.raises(ProjectError) as raised:
        picking.pick_target(
            project, survey, project.target("T1").seed, name="T1", line=line, role="validation"
        )
    assert raised.value.code == "pick.is_target"


def test_a_line_outside_the_trajectory_is_refused(copy: Project) -> None:
    path = copy.lines[1].path
    las = laspy.read(path)
    las.gps_time = np.asarray(las.gps_time) + 86_400
    las.write(path)
    with pytest.raises(InputError, check=has_code("import.after_trajectory")):
        load_survey(copy)


@pytest.mark.parametrize(
    ("moved", "code"), [(0.0, "import.shift_not_needed"), (86_400.0, "import.shift_wrong")]
)
def test_a_time_shift_out_of_the_trajectory_is_named(
    copy: Project, moved: float, code: str
) -> None:
    line = copy.lines[1]
    las = laspy.read(line.path)
    las.gps_time = np.asarray(las.gps_time) + moved
    las.write(line.path)
    shifted = replace(line, reading=replace(line.reading, time_shift=12_345.0))
    with pytest.raises(InputError) as refused:
        load_survey(replace(copy, lines=(copy.lines[0], shifted), targets=()))
    assert refused.value.code == code
    assert refused.value.message is not None
    assert refused.value.message.params["shift"] == 12_345.0


def test_points_partly_outside_are_skipped_and_reported(copy: Project) -> None:
    path = copy.lines[1].path
    las = laspy.read(path)
    time = np.asarray(las.gps_time).copy()
    time[:10] += 86_400
    las.gps_time = time
    las.write(path)
    survey = load_survey(replace(copy, targets=()))
    assert len(survey.scans[copy.lines[1].name]) == len(time) - 10
    (outside,) = [each for each in survey.notes if each.code == "import.excluded_outside"]
    assert outside.params["count"] == 10


def test_a_project_folder_is_not_overwritten(copy: Project) -> None:
    with pytest.raises(ProjectError) as raised:
        projects.create_project(
            copy.folder, trajectory=copy.trajectory, lines=copy.lines, settings=copy.settings
        )
    assert raised.value.code == "project_folder.exists"
    other = copy.folder.parent / "mine"
    projects.create_project(
        other, trajectory=copy.trajectory, lines=copy.lines, settings=copy.settings
    )
    with pytest.raises(ProjectError) as raised:
        make_demo(other)
    assert raised.value.code == "simulate.folder_in_use"


@pytest.mark.parametrize(
    ("change", "code", "params"),
    [
        ({"lidar_sigma": 0.0}, "settings.zero_lidar_sigma", {}),
        ({"lever_arm": (500.0, 0.0, 0.0)}, "settings.lever_arm_too_long", {"length": 500.0}),
        (
            {"lever_arm": (float("nan"), 0.0, 0.0)}, "settings.not_finite",
            {"setting": note("setting.lever_arm")},
        ),
        (
            {"boresight_deg": (-400.0, 0.0, 0.0)}, "settings.boresight_too_large",
            {"value": np.radians(400.0)},
        ),
        (
            {"origin_deg_m": (95.0, 0.0, 0.0)}, "settings.latitude_out_of_range",
            {"latitude": np.radians(95.0)},
        ),
        ({"position_sigma": (-0.01, 0.01, 0.01)}, "settings.negative", {}),
        (
            {"lidar_noise_source": "guess"}, "settings.unknown_noise_source",
            {"name": "guess", "known": ("given", "residuals")},
        ),
        (
            {"pos_errors": "white"}, "settings.unknown_pos_errors",
            {"name": "white", "known": ("correlated", "independent")},
        ),
        (
            {"lidar_sigma_xyz": (0.01, 0.01, 0.01), "lidar_beam_sigma": (0.01, 0.02)},
            "settings.two_lidar_sigmas", {},
        ),
        ({"attitude_time": 0.0}, "settings.zero_correlation_time", {}),
        ({"surface": -0.001}, "settings.negative_surface", {}),
        ({"longest_gap": 0.0}, "settings.zero_longest_gap", {}),
        (
            {"loss": "median"}, "settings.unknown_loss",
            {"name": "median", "known": ("none", "huber", "tukey")},
        ),
        ({"latency": -10.5}, "settings.latency_too_large", {"value": -10.5}),
        ({"range_offset": 11.0}, "settings.range_offset_too_large", {"value": 11.0}),
        (
            {"attitude_sigma_deg": (200.0, 0.1, 0.1)}, "settings.angle_out_of_range",
            {
                "setting": note("setting.attitude_sigma"), "value": math.radians(200.0),
                "least": math.radians(1e-9), "most": math.pi,
            },
        ),
    ],
)  # fmt: skip
def test_invalid_settings_are_refused(
    change: dict[str, object], code: str, params: dict[str, object]
) -> None:
    settings = replace(Settings(lever_arm=(0.0, 0.0, 0.0)), **change)  # type: ignore[arg-type]
    with pytest.raises(InputError) as refused:
        settings.require_sound()
    assert refused.value.message == error(code, **params)


def test_two_lines_with_the_same_name_are_refused(copy: Project, tmp_path: Path) -> None:
    line = copy.lines[0]
    with pytest.raises(InputError) as raised:
        projects.create_project(
            tmp_path / "same-names",
            trajectory=copy.trajectory,
            lines=[line, LineSource(line.name, copy.lines[1].path)],
            settings=copy.settings,
        )
    assert raised.value.code == "project_line.same_name"


def test_a_failed_adjustment_names_the_warnings_about_the_data(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    line = project.lines[0].name
    alone = replace(project, targets=tuple(
        replace(target, sightings=tuple(s for s in target.sightings if s.line == line))
        for target in project.targets
    ))  # fmt: skip
    params = {"line": line, "other": "L2", "seconds": 60.0}
    warning = Message("audit.same_time", Level.WARNING, params)
    note = Message("audit.not_checked", Level.NOTE, {"line": line})
    with pytest.raises(AdjustmentError) as refused:
        calibration.estimate(alone, replace(survey, messages=(note, warning)))
    assert str(refused.value).endswith(message_text(warning))
    assert message_text(note) not in str(refused.value)
