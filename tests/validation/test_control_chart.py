"""Tests of the history of a system: detection of a moved mounting, and the chart."""

import shutil
from dataclasses import replace
from datetime import date
from pathlib import Path

import numpy as np
import pytest
from matplotlib.dates import date2num

from lispac.identity import Identity
from lispac.io.project.project_file import write_project
from lispac.messages import note
from lispac.present.calibration.calibrations import DatedCalibration
from lispac.report.control_charts import control_chart_figure
from lispac.validation.control_chart import FALSE_ALARM_PROBABILITY, control_chart, control_limits
from lispac.validation.repeatability import Calibration
from lispac.workflow.checking.calibration_history import CalibratedSystem, read_histories
from tests.cli.test_cli import run, run_json
from tests.support.command_errors import command_error
from tests.support.long_runs import LONG
from tests.support.report_sample import sample_project, with_lines_of_its_own

SIGMA = np.radians([0.008, 0.010, 0.025])


def calibrations(rng: np.random.Generator, truth: np.ndarray) -> list[Calibration]:
    """One calibration for each row of ``truth`` (n, 3), with different standard deviations."""
    made = []
    for k, angles in enumerate(truth):
        turned = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        root = turned * SIGMA * rng.uniform(0.5, 2.0)
        made.append(Calibration(f"C{k}", angles + root @ rng.normal(size=3), root @ root.T))
    return made


@LONG
def test_false_alarms_have_the_given_probability() -> None:
    rng = np.random.default_rng(4)
    alarms = total = 0
    for _ in range(700):
        chart = control_chart(calibrations(rng, np.zeros((6, 3))))
        # After an alarm the new series is short, and further differences are not comparable.
        for each in chart[1:]:
            total += 1
            if each.has_moved:
                alarms += 1
                break
    # At least the probability of one test, at most the sum for the four tests.
    least, most = FALSE_ALARM_PROBABILITY * total, 4 * FALSE_ALARM_PROBABILITY * total
    assert least - 3.5 * np.sqrt(least) < alarms < most + 3.5 * np.sqrt(most), (alarms, total)


def test_an_angle_outside_its_limits_has_moved() -> None:
    """One angle outside its limits is sufficient, even if the joint test is not significant."""
    steady = np.diag(np.radians([0.01, 0.01, 0.03]) ** 2)
    first, second = (
        Calibration(name, np.radians([0.0, pitch, 0.0]), steady)
        for name, pitch in (("A", 0.0), ("B", 3.2 * 0.01 * np.sqrt(2.0)))
    )
    (_, each) = control_chart([first, second])
    assert each.change is not None
    assert each.change.probability > FALSE_ALARM_PROBABILITY
    assert each.has_moved


def test_a_mounting_that_moved_begins_a_new_series() -> None:
    truth = np.zeros((7, 3))
    truth[4:, 1] = np.radians(0.2)
    chart = control_chart(calibrations(np.random.default_rng(3), truth))
    assert [each.series for each in chart] == [0, 0, 0, 0, 1, 1, 1]
    assert [each.has_moved for each in chart] == [False] * 4 + [True] + [False] * 2
    moved = chart[4]
    assert moved.change is not None
    assert np.degrees(moved.change.angles[1]) == pytest.approx(0.2, abs=4 * 0.022)
    # The mean of the new series does not depend on the old one.
    assert chart[6].before is not None
    assert np.degrees(chart[6].before.boresight[1]) == pytest.approx(0.2, abs=4 * 0.022)
    reach = control_limits(moved)
    assert reach is not None
    assert not reach[0, 1] < moved.calibration.boresight[1] < reach[1, 1]
    assert control_limits(chart[0]) is None


def write_survey(folder: Path, day: str, pitch_deg: float = 0.0, vessel: str = "Nordlys") -> None:
    project = with_lines_of_its_own(sample_project(folder))
    result = project.result
    assert result is not None
    turned = result.boresight + np.radians([0.0, pitch_deg, 0.0])
    project = replace(
        project,
        result=replace(result, mounting=result.mounting.with_boresight(turned)),
        identity=Identity(vessel=vessel, scanner="VZ-400i", scanner_serial="S1", dates=day),
    )
    write_project(project)


@LONG
def test_the_history_of_a_folder(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    write_survey(tmp_path / "2024" / "spring", "2024-05-02", pitch_deg=0.001)
    write_survey(tmp_path / "2025" / "spring", "2025-05-02 to 2025-05-03")
    write_survey(tmp_path / "autumn", "2025-09-30", pitch_deg=0.3, vessel="nordlys ")
    write_survey(tmp_path / "other", "2025-07-01", vessel="Aurora")
    write_survey(tmp_path / "undated", "last summer")
    picture = tmp_path / "chart.png"
    found = run_json(capsys, "history", tmp_path, "--picture", picture)
    first, other = found["systems"]
    assert first["system"]["vessel"] == "Nordlys"
    assert [each["day"] for each in first["calibrations"]] == [
        "2024-05-02", "2025-05-02", "2025-09-30",
    ]  # fmt: skip
    names = [each["name"] for each in first["calibrations"]]
    assert names == ["2024/spring", "2025/spring", "autumn"]
    assert [each["moved"] for each in first["calibrations"]] == [False, False, True]
    difference = first["calibrations"][2]["change"]["difference_deg"]
    assert difference["pitch"] == pytest.approx(0.2995, abs=1e-6)
    assert [each["name"] for each in other["calibrations"]] == ["other"]
    assert "undated: its survey dates (last summer)" in found["messages"][0]["text"]
    # A copy of a survey does not count as another survey.
    copy = tmp_path / "a copy"
    shutil.copytree(tmp_path / "autumn", copy)
    again = run_json(capsys, "history", tmp_path)
    assert [each["day"] for each in again["systems"][0]["calibrations"]] == [
        "2024-05-02", "2025-05-02", "2025-09-30",
    ]  # fmt: skip
    codes = [each["code"] for each in again["systems"][0]["messages"]]
    assert "history.same_lines" in codes
    shutil.rmtree(copy)
    assert picture.read_bytes().startswith(b"\x89PNG")
    code, out, error = run(capsys, "history", tmp_path, "--vessel", "AURORA")
    assert code == 0
    assert "Aurora, VZ-400i S1" in out
    assert "spring" not in out
    assert "undated" not in error  # that survey is of the other vessel
    code, out, _ = run(capsys, "history", tmp_path, "--vessel", "Nordlys")
    assert "autumn differs significantly from" in out
    assert "+0.2995 deg" in out


def test_folders_without_a_history_are_refused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert command_error("history", tmp_path / "gone").code == "history.no_folder"
    (tmp_path / "empty").mkdir()
    assert command_error("history", tmp_path / "empty").code == "history.no_project"
    write_survey(tmp_path / "a", "2024-05-02")
    assert command_error("history", tmp_path, "--vessel", "Fram").code == "history.none_of_vessel"
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "project.json").write_text("{}")
    found = run_json(capsys, "history", tmp_path)
    assert [each["code"] for each in found["messages"]] == ["history.excluded"]


def test_an_open_project_replaces_its_saved_version(tmp_path: Path) -> None:
    write_survey(tmp_path / "a", "2024-05-02")
    write_survey(tmp_path / "b", "2025-05-02")
    from lispac.io.project.project_file import read_project

    opened = read_project(tmp_path / "b")
    opened = replace(opened, identity=opened.identity.changed(dates="2023-01-01"))
    (history,), _ = read_histories([tmp_path], also=[opened])
    assert [each.day for each in history.calibrations] == [date(2023, 1, 1), date(2024, 5, 2)]
    assert history.system.is_same_system(CalibratedSystem("NORDLYS", "vz-400i", "s1"))


@pytest.mark.parametrize("days", [(20, 22), (20, 20), (20,), (1, 2, 28)])
def test_the_time_axis_has_a_small_margin(days: tuple[int, ...]) -> None:
    chart = control_chart(calibrations(np.random.default_rng(5), np.zeros((len(days), 3))))
    at = [date(2025, 11, day) for day in days]
    first = note("history.first", name="first")
    axes = control_chart_figure(
        [DatedCalibration.of(day, Path(), each, first) for day, each in zip(at, chart, strict=True)]
    ).axes[-1]
    first, last = axes.get_xlim()
    dots = [x for line in axes.lines for x in line.get_xdata()]
    bands = [path.vertices[:, 0] for each in axes.collections for path in each.get_paths()]
    assert first < date2num(at[0])
    assert max(dots) < last
    assert all(first <= x.min() and x.max() <= last for x in bands)
    # The margin is at most the mean interval between calibrations, or two days
    beyond = max((days[-1] - days[0]) / max(len(days) - 1, 1), 2.0)
    assert date2num(at[0]) - first < beyond
    assert last - date2num(at[-1]) < beyond


def test_projects_without_result_or_system_name_are_reported(tmp_path: Path) -> None:
    write_survey(tmp_path / "a", "2024-05-02", vessel="")
    dated = sample_project(tmp_path / "b")
    write_project(
        replace(dated, result=None, cross_checks=None, identity=Identity(dates="2025-05-02"))
    )
    nameless = sample_project(tmp_path / "c")
    write_project(replace(nameless, identity=Identity(dates="2025-07-02")))
    found, messages = read_histories([tmp_path])
    assert messages == (note("history.excluded", reason=note("history.no_result", project="b")),)
    messages_of = {history.calibrations[0].folder.name: history.messages for history in found}
    assert note("history.unnamed_system") not in messages_of["a"]  # its scanner is named
    assert note("history.unnamed_system") in messages_of["c"]
