"""Tests that lines with a time rollover (midnight, end of week) keep all their points."""

from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.cli.main import main
from lispac.io.formats import format_of
from lispac.io.points.line_times import read_line_times
from lispac.messages import Message, note
from lispac.project import LineSource, Reading, Settings
from lispac.survey.time_base import DAY, WEEK
from lispac.survey.time_rollover import (
    find_rollover,
    resolve_rollover,
    restore_rollover,
    rollover_note,
)
from lispac.workflow.importing.input_files import InputFiles
from lispac.workflow.importing.line_import import import_lines
from lispac.workflow.output.georeferencing import georeference_project
from lispac.workflow.project.projects import new_project, open_project
from lispac.workflow.project.survey import load_survey
from tests.support.input_file_samples import (
    LEVER,
    START,
    codes_about,
    import_files,
    named,
    write_line,
)
from tests.support.message_codes import codes, is_shown
from tests.support.trajectory_files import vessel, write_records


def survey_about(folder: Path, period: float, order: str = "sorted") -> tuple[Path, Path]:
    """Write a trajectory of 40 s around the end of a period, and a line of 36 s in these times."""
    records = vessel(2000)
    records[:, 0] = np.mod(records[:, 0] - START + period - 20, period)
    write_records(folder / "pos.sbet", records)
    times = np.mod(period - 20 + np.linspace(2, 38, 3000), period)
    if order == "tiles":
        times = times[np.random.default_rng(1).permutation(len(times))]
    return folder / "pos.sbet", write_line(folder / "L.las", times)


def make_project(folder: Path, track: Path, line: Path, reading=Reading()):  # noqa: B008
    return new_project(
        folder, trajectory=track, lines=[LineSource("L", line, reading=reading)],
        settings=Settings(lever_arm=LEVER),
    )  # fmt: skip


@pytest.mark.parametrize("order", ["sorted", "tiles"])
@pytest.mark.parametrize("period", [DAY, WEEK])
def test_no_point_is_lost_in_import_and_export(period: float, order: str, tmp_path: Path) -> None:
    track, line = survey_about(tmp_path, period, order)
    project, survey = make_project(tmp_path / "p", track, line)
    times = np.sort(survey.scans["L"].time)
    assert times == pytest.approx(period - 20 + np.linspace(2, 38, 3000))
    assert ("import.times_restart", period) in [
        (each.code, each.params.get("period")) for each in survey.notes
    ]
    written = np.sort(laspy.read(line).gps_time)
    again = open_project(project.folder)
    assert len(load_survey(again).scans["L"]) == 3000
    local = {"system": "local", "ending": "las"}
    direct = georeference_project(again, tmp_path / "direct", "prior", **local)[0]
    assert (direct.points, direct.outside) == (3000, 0)
    assert (np.sort(laspy.read(direct.path).gps_time) == written).all()
    stored = import_lines(again)[0].stored
    assert np.sort(stored.time) == pytest.approx(times)
    line.unlink()
    kept = georeference_project(again, tmp_path / "kept", "prior", **local)[0]
    assert np.sort(laspy.read(kept.path).gps_time) == pytest.approx(written, abs=1e-9)
    places = [np.sort(laspy.read(one.path).x) for one in (direct, kept)]
    assert places[0] == pytest.approx(places[1], abs=2e-4)


@pytest.mark.parametrize("shift", [0.0, 18.0])
@pytest.mark.parametrize("rollover", ["midnight", "week-end", "none"])
def test_conversion_to_file_times_is_the_inverse(rollover: str, shift: float) -> None:
    reading = Reading("", (("time_rollover", rollover),), shift)
    period = {"midnight": DAY, "week-end": WEEK, "none": 0.0}[rollover]
    written = np.array([period - 0.5, 0.0, 3.0]) if period else np.array([5.0, 6.5])
    moved = reading.to_trajectory_time(written)
    counted = [period - 0.5, period, period + 3.0] if period else [5.0, 6.5]
    assert moved.tolist() == [time + shift for time in counted]
    assert reading.to_file_time(moved).tolist() == written.tolist()


def test_a_rollover_is_found_from_two_times() -> None:
    assert find_rollover(np.array([DAY - 3.0, 2.0])) == "midnight"
    assert find_rollover(np.array([2.0, WEEK - 3.0])) == "week-end"
    assert find_rollover(np.array([DAY - 3.0])) == ""
    # A line of less than half a day, most of it after midnight
    long = np.r_[np.linspace(0.95 * DAY, DAY - 1, 50), np.linspace(1, 0.4 * DAY, 200)]
    assert find_rollover(long) == "midnight"
    assert find_rollover(np.zeros(0)) == ""
    assert find_rollover(np.array([DAY - 3.0, np.nan, 2.0])) == ""


def test_an_option_sets_or_disables_the_rollover(tmp_path: Path, capsys) -> None:
    track, line = survey_about(tmp_path, WEEK)
    _, survey = make_project(
        tmp_path / "none", track, line, Reading("", (("time_rollover", "none"),))
    )
    assert survey.scans["L"].time.max() < WEEK
    assert len(survey.scans["L"]) < 2000
    later = write_line(tmp_path / "later.las", np.linspace(1, 15, 3000))
    command = ["new", str(tmp_path / "p"), str(later), "--trajectory", str(track)]
    command += ["--lever-arm", "0", "0", "0"]
    assert main(command) != 0
    assert main([*command, "--line-option", "time_rollover=week-end"]) == 0
    assert is_shown("import.times_after_restart", "".join(capsys.readouterr()))
    assert load_survey(open_project(tmp_path / "p")).scans["later"].time.min() == WEEK + 1


def test_rollovers_are_resolved_in_text_and_with_given_time_bases(tmp_path: Path) -> None:
    track, _ = survey_about(tmp_path, DAY)
    utc = np.mod(DAY - 20 - 18 + np.linspace(20, 38, 500), DAY)
    rows = "\n".join(f"{t:.6f} 0 10 {k % 7}" for k, t in enumerate(utc))
    (tmp_path / "L.txt").write_text("time x y z\n" + rows)
    in_utc = Reading("", (("time_base", "utc-day"),))
    track_reading = Reading("sbet", (("time", "gps-day"),))
    project, survey = new_project(
        tmp_path / "p", trajectory=track, trajectory_reading=track_reading,
        lines=[LineSource("L", tmp_path / "L.txt", reading=in_utc)],
        settings=Settings(lever_arm=LEVER),
    )  # fmt: skip
    assert project.lines[0].reading.time_shift == 18
    assert len(survey.scans["L"]) == 500
    assert survey.scans["L"].time.max() == pytest.approx(DAY + 18)


def test_the_import_dialog_resolves_and_reports_a_rollover(tmp_path: Path) -> None:
    track, line = survey_about(tmp_path, WEEK)
    input_files = import_files(InputFiles(), track, line)
    input_file = named(input_files, "L.las")
    assert input_files.state_of_file(input_file) == "fine"
    (rollover,) = (m for m in input_files.messages(input_file) if m.code == "import.times_restart")
    assert rollover.params["place"] == note("rollover.week_end")
    assert rollover.params["last"] == pytest.approx(WEEK, abs=0.1)
    covered = input_files.coverage(input_file)
    assert covered is not None
    assert covered.outside == 0
    assert input_file.content.end == pytest.approx(WEEK + 18)
    (ignore,) = rollover.actions
    back = import_files(input_files.with_action(line, ignore))
    assert "import.points_outside" in codes_about(back, "L.las")


def test_a_rollover_of_a_long_line_is_found_from_a_sample(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("lispac.io.points.line_times.MAX_POINTS_READ_WHOLE", 10_000)
    times = np.mod(DAY - 5000 + np.linspace(0, 5400, 60_000), DAY)
    line = write_line(tmp_path / "long.las", times)
    found = read_line_times(line, format_of("las"), {})
    assert found.rollover == "midnight"
    assert found.end == pytest.approx(DAY + 400)


@pytest.mark.parametrize(
    "times",
    [
        np.linspace(40_000, 41_000, 500)[::-1],  # backward
        np.r_[np.linspace(30_000, 30_100, 50), np.linspace(0, 100, 50)],  # an earlier line appended
        np.r_[np.linspace(DAY - 4000, DAY - 3900, 50), np.linspace(0, 10, 50)],  # a gap of an hour
        np.linspace(DAY - 50, DAY + 50, 500),  # already continuous
        np.linspace(0, DAY - 1, 5000),  # a whole day
        np.linspace(5, 50, 100),
        np.r_[-1.0, DAY - 1],
        np.r_[np.nan, DAY - 1],
    ],
)  # fmt: skip
def test_other_steps_are_not_rollovers(times: np.ndarray) -> None:
    assert find_rollover(times) == ""
    assert resolve_rollover(times, "") is times
    assert restore_rollover(times, "none") is times


MIDNIGHT = note("rollover.midnight")


@pytest.mark.parametrize(
    ("times", "rollover", "message"),
    [
        (
            [DAY - 2.5, DAY + 3.0], "midnight",
            note("import.times_restart", file="a", place=MIDNIGHT, period=DAY, last=DAY - 2.5),
        ),
        (
            [WEEK + 3.0], "week-end",
            note(
                "import.times_after_restart", file="a", place=note("rollover.week_end"),
                period=WEEK,
            ),
        ),
        (
            [DAY], "midnight",
            note("import.times_after_restart", file="a", place=MIDNIGHT, period=DAY),
        ),
    ],
)  # fmt: skip
def test_a_resolved_rollover_is_reported(
    times: list[float], rollover: str, message: Message
) -> None:
    assert rollover_note(np.array(times), rollover, "a") == message


def test_an_sbet_with_a_rollover_needs_no_options(tmp_path, capsys) -> None:
    track, line = survey_about(tmp_path, WEEK)
    main(["inspect", str(track)])
    printed = capsys.readouterr().out
    assert "40.0 s" in printed
    assert "-6047" not in printed
    main(["inspect", str(line)])
    assert not is_shown("times.decreasing", capsys.readouterr().out)
    command = ["new", str(tmp_path / "p"), str(line), "--trajectory", str(track)]
    assert main([*command, "--lever-arm", "0", "0", "0"]) == 0
    printed = "".join(capsys.readouterr())
    assert is_shown("assumed.time_rollover", printed)


def test_a_sorted_trajectory_needs_a_line_without_resolved_rollover(tmp_path: Path) -> None:
    track, line = survey_about(tmp_path, DAY)
    records = np.fromfile(track).reshape(-1, 17)
    write_records(track, records[np.argsort(records[:, 0])])
    _, survey = make_project(tmp_path / "p", track, line)
    assert "import.restart_not_needed" in codes(survey.notes)
    _, survey = make_project(tmp_path / "q", track, line, Reading("", (("time_rollover", "none"),)))
    assert len(survey.scans["L"]) > 2990
