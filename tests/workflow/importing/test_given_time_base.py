"""Tests of time bases given by the user for lines and trajectories."""

from pathlib import Path

import numpy as np
import pytest

from lispac.cli.main import main
from lispac.errors import InputError
from lispac.messages import Level, Message, error, note
from lispac.project import LineSource, Reading, Settings
from lispac.survey.known_time_base import (
    KnownTimeBase,
    base_message,
    no_overlap_error,
    shift_note,
    time_base_error,
)
from lispac.survey.time_base import WEEK, TimeMatch, base_of_key
from lispac.workflow.importing.input_files import InputFiles
from lispac.workflow.importing.line_import import assumptions_of, import_lines
from lispac.workflow.project.projects import new_project, open_project, with_lines_added
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.command_errors import command_error
from tests.support.input_file_samples import (
    LEVER,
    START,
    codes_about,
    import_files,
    named,
    write_line,
)
from tests.support.message_codes import codes
from tests.support.trajectory_files import vessel, write_records

UTC_WEEK = (("time_base", "utc-week"),)


@pytest.fixture
def track(tmp_path: Path) -> Path:
    """Return a trajectory of 100 s from ``START``, in GPS seconds of the week."""
    return write_track(tmp_path / "pos.sbet", 0.0)


def write_track(path: Path, added: float) -> Path:
    records = vessel(5000)
    records[:, 0] += added
    write_records(path, records)
    return path


def write_points(path: Path, added: float, first: float = 30.0, last: float = 60.0) -> Path:
    write_line(path, START + np.linspace(first, last, 3000) + added)
    return path


def messages_of(survey: Survey, code: str) -> list[Message]:
    """Return the notes of a survey that have this code."""
    return [each for each in survey.notes if each.code == code]


def make_project(folder: Path, track: Path, line: Path, reading=Reading(), track_reading=Reading()):  # noqa: B008
    return new_project(
        folder, trajectory=track, lines=[LineSource("L", line, reading=reading)],
        settings=Settings(lever_arm=LEVER), trajectory_reading=track_reading,
    )  # fmt: skip


def test_a_line_given_in_utc_is_shifted_to_gps_time(track, tmp_path) -> None:
    line = write_points(tmp_path / "utc.las", -18)
    project, survey = make_project(tmp_path / "p", track, line, Reading("", UTC_WEEK))
    assert survey.scans["L"].time.min() == pytest.approx(START + 30)
    assert project.lines[0].reading.time_shift == pytest.approx(18)
    (follows,) = messages_of(survey, "import.shift_follows")
    assert (follows.params["file"], follows.params["shift"]) == ("utc.las", 18.0)
    assert follows.params["base"] == note("time_base.given", base=note("time_base.utc_week"))
    assert messages_of(survey, "import.leap_seconds_assumed")[0].params["leap"] == 18
    assert "assumed.same_time_base" not in codes(survey.notes)
    assert note("assumed.time_shift", file="utc.las", shift=18.0) in survey.notes
    again = load_survey(open_project(project.folder))
    assert again.scans["L"].time.min() == pytest.approx(START + 30)
    later = write_points(tmp_path / "later.las", -18, 65, 75)
    _, both = with_lines_added(project, [LineSource("M", later, reading=Reading("", UTC_WEEK))])
    assert both.scans["M"].time.min() == pytest.approx(START + 65)
    (follows,) = messages_of(both, "import.shift_follows")
    assert (follows.params["file"], follows.params["shift"]) == ("later.las", 18.0)


def test_lines_are_shifted_to_a_trajectory_given_in_utc(tmp_path) -> None:
    track = write_track(tmp_path / "utc.sbet", -18)
    line = write_points(tmp_path / "gps.las", 0)  # its header says seconds of the GPS week
    given = Reading("", (("time", "utc-week"),))
    project, survey = make_project(tmp_path / "p", track, line, Reading(), given)
    assert survey.scans["L"].time.min() == pytest.approx(START + 12)
    (follows,) = messages_of(survey, "import.shift_follows")
    assert (follows.params["file"], follows.params["shift"]) == ("gps.las", -18.0)
    later = write_points(tmp_path / "later.las", 0, 65, 75)
    _, both = with_lines_added(project, [LineSource("M", later)])
    assert both.scans["M"].time.min() == pytest.approx(START + 47)


@pytest.mark.parametrize(
    ("base", "added"),
    [
        ("utc-day", -18 - 5 * 86_400.0),
        ("gps-day", -5 * 86_400.0),
        ("gps-adjusted", 2268 * WEEK - 1e9),
        ("gps-full", 2268 * WEEK),
        ("unix", 2268 * WEEK + 315_964_800 - 18),
    ],
)
def test_every_base_is_converted_to_seconds_of_the_week(
    base: str, added: float, track, tmp_path
) -> None:
    line = write_points(tmp_path / "L.las", added)
    _, survey = make_project(tmp_path / "p", track, line, Reading("", (("time_base", base),)))
    assert survey.scans["L"].time.min() == pytest.approx(START + 30)


def test_equal_bases_need_no_shift(track, tmp_path) -> None:
    line = write_points(tmp_path / "L.las", 0)
    project, survey = make_project(
        tmp_path / "p", track, line, Reading("", (("time_base", "gps-week"),))
    )
    assert project.lines[0].reading.time_shift == 0
    assert messages_of(survey, "import.shift_follows") == []


@pytest.mark.parametrize("base", ["utc-day", "gps-adjusted"])
def test_an_impossible_time_base_is_refused(base: str, track, tmp_path) -> None:
    line = write_points(tmp_path / "L.las", 0)
    with pytest.raises(InputError) as caught:
        make_project(tmp_path / "p", track, line, Reading("", (("time_base", base),)))
    assert caught.value.message == error(
        "time_base.not_possible",
        file=str(line),
        first=486030.0,
        last=486060.0,
        base=base_message(base_of_key(base)),
        keys=["gps-week", "utc-week"],
    )
    assert not (tmp_path / "p").exists()


def test_a_given_shift_must_agree_with_the_given_base(track, tmp_path, capsys) -> None:
    line = write_points(tmp_path / "L.las", -18)
    _, survey = make_project(tmp_path / "p", track, line, Reading("", UTC_WEEK, 18.0))
    assert survey.scans["L"].time.min() == pytest.approx(START + 30)
    command = ["new", str(tmp_path / "q"), str(line), "--trajectory", str(track)]
    command += ["--lever-arm", "0", "0", "1", "--line-option", "time_base=utc-week"]
    refusal = command_error(*command, "--time-shift", "5")
    assert refusal.code == "import.shift_contradicts_base"
    assert refusal.message is not None
    assert (refusal.message.params["given"], refusal.message.params["needed"]) == (5.0, 18.0)
    assert not (tmp_path / "q").exists()
    assert main(command) == 0
    assert "+18.000 s are added" in capsys.readouterr().err


def test_a_base_without_overlap_with_the_trajectory_is_refused(track, tmp_path) -> None:
    line = write_points(tmp_path / "L.las", 50_000)
    with pytest.raises(InputError) as raised:
        make_project(tmp_path / "p", track, line, Reading("", UTC_WEEK))
    assert raised.value.code == "time_base.no_overlap"


def test_times_that_fit_no_base_are_refused() -> None:
    given = KnownTimeBase(base_of_key("gps-week"), is_given=True)
    times = np.array([5e12, 4e12])
    refusal = time_base_error(times, given, "a")
    assert refusal is not None
    assert refusal.code == "time_base.no_base_possible"
    assert (refusal.params["first"], refusal.params["last"]) == (4e12, 5e12)
    assert time_base_error(times, KnownTimeBase(base_of_key("gps-week")), "a") is None
    assert time_base_error(np.array([5.0]), given, "a") is None


def test_possible_bases_of_the_trajectory_are_suggested() -> None:
    own, track = (
        KnownTimeBase(base_of_key("gps-adjusted"), is_given=True),
        START + np.arange(0.0, 100.0),
    )
    times = 2268 * WEEK - 1e9 + START + np.linspace(10, 40, 50)
    other = KnownTimeBase(base_of_key("gps-day"))
    options = "--trajectory-option time=gps-week", "--trajectory-option time=utc-week"
    refusal = no_overlap_error(own, other, times, track, "a")
    assert refusal.code == "time_base.other_trajectory_base"
    assert refusal.params == {
        "file": "a",
        "base": note("time_base.given", base=note("time_base.gps_adjusted")),
        "trajectory_base": note("time_base.of_file", base=note("time_base.gps_day")),
        "options": list(options),
    }  # fmt: skip
    # Times 5 s after the end of the trajectory: UTC is 18 s behind GPS time
    behind = 2268 * WEEK - 1e9 + START + 105.0 + np.linspace(0, 5, 50)
    assert no_overlap_error(own, other, behind, track, "a").params["options"] == [options[1]]
    assert no_overlap_error(
        own, KnownTimeBase(other.base, is_given=True), times, track, "a"
    ).code == ("time_base.no_overlap")


def test_a_shift_is_suggested_if_it_covers_five_percent_more_points() -> None:
    week, utc = base_of_key("gps-week"), base_of_key("utc-week")
    found = (TimeMatch(((utc, week),), 18.0, 0.75),)
    assert shift_note((), 0.0, "a") is None
    assert shift_note(found, 0.71, "a") is None
    assert shift_note(found, 0.5, "a") == note(
        "import.shift_possible", file="a", shift=18.0, share=0.75,
        points=note("time_base.utc_week"), trajectory=note("time_base.gps_week"),
    )  # fmt: skip


def test_an_assumed_base_is_reported(tmp_path) -> None:
    track = write_track(tmp_path / "utc.sbet", -18)
    rows = np.column_stack([START + np.linspace(30, 60, 500), np.tile([5.0, 6.0, 7.0], (500, 1))])
    path = tmp_path / "L.txt"
    np.savetxt(path, rows, fmt="%.6f", header="time x y z", comments="")
    _, survey = make_project(
        tmp_path / "p", track, path, Reading(), Reading("", (("time", "utc-week"),))
    )
    (assumed,) = messages_of(survey, "import.base_assumed")
    assert assumed.params["file"] == "L.txt"


def test_a_shift_that_covers_clearly_more_points_is_suggested(track, tmp_path) -> None:
    line = write_points(tmp_path / "early.las", -18, 0, 34.7)  # 51.9 % before the trajectory
    project, survey = make_project(tmp_path / "p", track, line)
    (possible,) = [each for each in survey.notes if each.code == "import.shift_possible"]
    assert (possible.params["shift"], possible.params["share"]) == (18.0, 1.0)
    assert possible in assumptions_of(import_lines(project)[0].stored)
    end = write_points(tmp_path / "end.las", 0, 70, 101)  # a shift would cover few more points
    _, survey = make_project(tmp_path / "q", track, end)
    assert "import.excluded_outside" in codes(survey.notes)
    assert "import.shift_possible" not in codes(survey.notes)


# -- in the import dialogue ----------------------------------------------------------------------


def test_the_dialogue_applies_and_reverts_the_base_of_a_line(track, tmp_path) -> None:
    line = write_points(tmp_path / "utc.las", -18)
    before = import_files(InputFiles(), track, line)
    assert named(before, "utc.las").shift == 0
    input_files = import_files(before.with_option(line, "time_base", "utc-week"))
    assert named(input_files, "utc.las").shift == pytest.approx(18)
    assert "import.shift_follows" in codes_about(input_files, "utc.las")
    assert input_files.state_of_file(named(input_files, "utc.las")) == "fine"
    request = input_files.request(tmp_path / "p", Settings(lever_arm=LEVER))
    _, survey = new_project(
        request.folder, trajectory=request.trajectory, lines=request.lines,
        settings=request.settings, trajectory_reading=request.trajectory_reading,
    )  # fmt: skip
    assert survey.scans["utc"].time.min() == pytest.approx(START + 30)
    follows = next(
        each for each in input_files.messages(named(input_files, "utc.las")) if each.actions
    )
    back = import_files(input_files.with_action(line, follows.actions[0]))
    assert named(back, "utc.las").shift == 0


def test_the_dialogue_applies_the_base_of_a_trajectory(tmp_path) -> None:
    track = write_track(tmp_path / "utc.sbet", -18)
    line = write_points(tmp_path / "gps.las", 0)
    input_files = import_files(
        import_files(InputFiles(), track, line).with_option(track, "time", "utc-week")
    )
    assert named(input_files, "gps.las").shift == pytest.approx(-18)
    assert input_files.files_problem() is None
    again = import_files(input_files.with_option(track, "time", "gps-week"))
    assert named(again, "gps.las").shift == 0


@pytest.mark.parametrize("base", ["utc-day", "gps-adjusted"])
def test_the_dialogue_refuses_an_impossible_time_base(base: str, track, tmp_path) -> None:
    line = write_points(tmp_path / "L.las", 0)
    input_files = import_files(
        import_files(InputFiles(), track, line).with_option(line, "time_base", base)
    )
    error = input_files.messages(named(input_files, "L.las"))[0]
    assert input_files.files_problem() == error
    assert error.level is Level.ERROR
    assert named(input_files, "L.las").shift == 0
    assert import_files(input_files.with_action(line, error.actions[0])).files_problem() is None


def test_the_dialogue_proposes_the_shift_that_covers_more_points(track, tmp_path) -> None:
    line = write_points(tmp_path / "early.las", -18, 0, 34.7)
    input_files = import_files(InputFiles(), track, line)
    outside, proposed = input_files.time_messages(named(input_files, "early.las"))
    assert outside.code == "import.points_outside"
    assert proposed.code == "import.shift_offered"
    assert (proposed.params["shift"], proposed.params["share"]) == (pytest.approx(18), 1.0)
    assert proposed.actions[0].params["shift"] == pytest.approx(18)
    assert [shift for _, shift in input_files.proposed_shifts] == [pytest.approx(18)]
    shifted = input_files.with_shift_for_all()
    assert shifted.proposed_shifts == ()
    covered = shifted.coverage(named(shifted, "early.las"))
    assert covered is not None
    assert covered.outside == 0


def test_a_given_base_of_one_line_does_not_shift_the_others(track, tmp_path) -> None:
    utc, own = write_points(tmp_path / "utc.las", -18), write_points(tmp_path / "own.las", 0)
    lines = [LineSource("utc", utc, reading=Reading("", UTC_WEEK)), LineSource("own", own)]
    project, survey = new_project(
        tmp_path / "p", trajectory=track, lines=lines, settings=Settings(lever_arm=LEVER)
    )
    assert [line.reading.time_shift for line in project.lines] == [pytest.approx(18.0), 0.0]
    assert survey.scans["own"].time.min() == pytest.approx(START + 30)
    shifted = [each.params["file"] for each in messages_of(survey, "import.shift_follows")]
    assert shifted == ["utc.las"]


def test_a_given_shift_is_used_if_the_bases_have_no_overlap(track, tmp_path) -> None:
    """The clock of the line was wrong, and the user knows by how much."""
    line = write_points(tmp_path / "L.las", 50_000)
    project, survey = make_project(tmp_path / "p", track, line, Reading("", UTC_WEEK, -50_000.0))
    assert survey.scans["L"].time.min() == pytest.approx(START + 30)
    assert project.lines[0].reading.time_shift == -50_000.0


def test_a_given_shift_has_no_warning_of_an_unknown_base(tmp_path) -> None:
    track = write_track(tmp_path / "utc.sbet", -18)
    rows = np.column_stack([START + np.linspace(30, 60, 500), np.tile([5.0, 6.0, 7.0], (500, 1))])
    path = tmp_path / "L.txt"
    np.savetxt(path, rows, fmt="%.6f", header="time x y z", comments="")
    given = Reading("", (("time", "utc-week"),))
    _, survey = make_project(tmp_path / "p", track, path, Reading("", (), -18.0), given)
    assert survey.scans["L"].time.min() == pytest.approx(START + 12)
    assert messages_of(survey, "import.base_assumed") == []
