"""Lines on their way into an open project, and what the list of files says in rarer cases."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.io.formats import format_of
from lispac.io.line_times import LineTimes
from lispac.io.registry import Finding
from lispac.io.sight import sight
from lispac.project import LineSource, Project, Settings
from lispac.survey.time_base import base_of
from lispac.survey.time_stated import Known
from lispac.survey.trajectory import Trajectory
from lispac.workflow import intake as intake_module
from lispac.workflow.intake import Intake, folder_problem, proposed_folder
from lispac.workflow.intake_columns import column_tokens, meanings, missing_columns
from lispac.workflow.intake_entry import Entry, examined_again, examined_as_given
from lispac.workflow.intake_remarks import Remedy, remarks_of
from lispac.workflow.intake_times import fitting, line_base, trajectory_base
from lispac.workflow.projects import new_project
from tests.intake_files import LEVER, START, named, said, taken_in, write_line, write_survey
from tests.trajectory_files import vessel, write_records


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_survey(tmp_path_factory.mktemp("survey"))


@pytest.fixture(scope="module")
def project(files: Path, tmp_path_factory: pytest.TempPathFactory) -> Project:
    """Of the survey's first line alone."""
    return new_project(
        tmp_path_factory.mktemp("made") / "quay", trajectory=files / "pos.sbet",
        accuracy=files / "smrmsg.out", lines=[LineSource("L1", files / "L1.laz")],
        settings=Settings(LEVER),
    )[0]  # fmt: skip


def opened(project: Project) -> Intake:
    """For lines to be added to it, its own files looked into as it reads them."""
    intake = Intake.of_project(project)
    for entry in intake.entries:
        intake = intake.with_entry(examined_as_given(entry))
    return intake


# -- lines for an open project --------------------------------------------------------------------


def test_a_projects_own_files_are_there_and_stay(project: Project, files: Path) -> None:
    intake = opened(project)
    assert [entry.role for entry in intake.entries] == ["trajectory", "accuracy"]
    assert intake.track is not None
    assert intake.sigmas is not None
    assert intake.files_problem() == "No file is a line yet: add the scan file of at least one."
    for entry in intake.entries:
        assert intake.without(entry.path).entries == intake.entries
        assert intake.with_role(entry.path, "points") is intake
    without = Intake.of_project(replace(project, accuracy=None))
    assert [entry.role for entry in without.entries] == ["trajectory"]
    more = taken_in(intake, files / "L2.las")
    assert more.files_problem() == ""
    assert [(line.name, line.path.name) for line in more.sources()] == [("L2", "L2.las")]
    assert more.without(files / "L2.las").files_problem() == intake.files_problem()


def test_a_line_that_is_there_already_can_only_be_left_out(project: Project, files: Path) -> None:
    intake = taken_in(opened(project), files / "L1.laz")
    (remark,) = intake.remarks(named(intake, "L1.laz"))
    assert (remark.level, remark.text) == ("error", "This is the line L1 of the project already.")
    assert "L1.laz: This is the line L1 of the project already." in intake.files_problem()
    left = intake.with_remedy(files / "L1.laz", remark.remedies[0])
    assert left.state(left.entry(files / "L1.laz")) == "out"


def test_gaps_are_bridged_for_a_new_project_and_not_for_one_that_is_there(
    project: Project, files: Path, tmp_path: Path
) -> None:
    """What a project bridges is among its settings; lines that are added do not change it."""
    records = vessel(2000)
    time = records[:, 0] - START
    torn = write_records(tmp_path / "torn.sbet", records[(time < 5) | (time > 8)])
    (new,) = (
        remark
        for remark in (lambda i: i.remarks(named(i, "L1.laz")))(
            taken_in(Intake(), torn, files / "L1.laz")
        )
        if remark.level == "doubt"
    )
    assert [remedy.longest_gap for remedy in new.remedies] == [pytest.approx(3.1, abs=0.11)]
    here = replace(project, trajectory=torn, lines=(), accuracy=None)
    intake = taken_in(opened(here), files / "L1.laz")
    remarks = intake.remarks(named(intake, "L1.laz"))
    assert [remark.text for remark in remarks] == [new.text]
    assert all(remedy.longest_gap is None for each in remarks for remedy in each.remedies)


def test_a_gap_too_wide_to_be_bridged_has_no_remedy(files: Path, tmp_path: Path) -> None:
    """Ten times what is bridged usually: half a minute of the trajectory is missing."""
    records = vessel(2000)
    time = records[:, 0] - START
    torn = write_records(tmp_path / "torn.sbet", records[(time < 3) | (time > 30)])
    intake = taken_in(Intake(), torn, files / "L1.laz")
    (doubt,) = (each for each in intake.remarks(named(intake, "L1.laz")) if each.level == "doubt")
    assert not any(remedy.longest_gap for remedy in doubt.remedies)


# -- single rules of the list ---------------------------------------------------------------------


def test_before_there_is_a_trajectory_nothing_is_told_of_times(files: Path) -> None:
    line = taken_in(Intake(), files / "L1.laz")
    entry = line.entry(files / "L1.laz")
    assert line.time_remarks(entry) == ()
    assert line.coverage(entry) is None
    assert line.shifts_offered == ()
    assert line.time_base is None
    both = taken_in(line, files / "pos.sbet")
    assert both.time_remarks(both.entry(files / "pos.sbet")) == ()
    covered = both.coverage(both.entry(files / "L1.laz"))
    assert covered is not None
    assert covered.usable == covered.count


def test_a_file_that_waits_says_nothing(files: Path) -> None:
    waiting = Intake().with_files([files / "L1.laz"])
    entry = waiting.entries[0]
    assert waiting.state(entry) == "pending"
    assert waiting.remarks(entry) == ()


def test_a_role_that_a_file_has_already_keeps_what_was_found(files: Path) -> None:
    intake = taken_in(Intake(), files / "L1.laz")
    assert intake.with_role(files / "L1.laz", "points") is intake
    assert intake.with_remedy(files / "L1.laz", Remedy("Look at it", ask="crs")) is intake


def test_two_accuracies_are_one_too_many(files: Path, tmp_path: Path) -> None:
    second = tmp_path / "second.out"
    second.write_bytes((files / "smrmsg.out").read_bytes())
    intake = taken_in(Intake(), files, second)
    text = "More than one file has the role accuracy, and a project has one; leave the others out."
    assert text in said(intake, "second.out")
    assert intake.files_problem().endswith("(1 more file has errors.)")


def test_a_folder_for_the_project_is_proposed_where_one_is_free(
    files: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Beside the data, else at home, else under the next number; and none where nothing can be."""
    assert proposed_folder(Intake()) is None
    home = tmp_path / "home"
    home.mkdir()
    monkeypatch.setattr(Path, "home", lambda: home)
    intake = taken_in(Intake(), write_line(tmp_path / "L1.las", START + np.arange(50.0)))
    assert proposed_folder(intake) == tmp_path / "boresight"
    (tmp_path / "boresight").mkdir()
    assert proposed_folder(intake) == home / f"{tmp_path.name}-boresight"
    (home / f"{tmp_path.name}-boresight").mkdir()
    assert proposed_folder(intake) == tmp_path / "boresight-2"
    monkeypatch.setattr(intake_module.os, "access", lambda *_: False)
    assert folder_problem(str(tmp_path / "x")) == (
        f"{tmp_path} cannot be written; choose another folder."
    )
    assert proposed_folder(intake) is None


# -- columns and time bases -----------------------------------------------------------------------


def test_columns_mean_what_their_kind_of_file_can_hold() -> None:
    points, track = meanings(format_of("text")), meanings(format_of("ascii-trajectory"))
    assert points[0] == track[0] == "-"
    assert {"time", "x", "y", "z", "intensity"} == set(points[1:])
    assert {"latitude", "longitude", "roll", "pitch", "heading"} < set(track)
    assert "x" not in track
    assert column_tokens(format_of("text"), None, "time x - y") == ("time", "x", "-", "y")


@pytest.mark.parametrize(
    ("tokens", "said"),
    [
        ("time latitude longitude height roll pitch heading", ""),
        ("time easting northing sea_height roll pitch heading", ""),
        ("time latitude longitude roll pitch heading", "height"),
        (
            "time latitude height roll pitch",
            "heading or latitude and longitude (or easting and northing)",
        ),
        (
            "date easting roll",
            "time, pitch, heading, latitude and longitude (or easting and northing) or height",
        ),
    ],
)
def test_what_a_trajectory_cannot_do_without_is_named(tokens: str, said: str) -> None:
    assert missing_columns(format_of("ascii-trajectory"), tokens.split()) == said


def test_what_is_not_settled_has_no_time_base() -> None:
    assert trajectory_base(None) == Known()
    entry = Entry(Path("a.sbet"), role="trajectory")
    assert trajectory_base(entry) == Known()
    assert line_base(Entry(Path("a.las"), role="points")).base is None
    assert entry.options == {}
    assert examined_again(entry).pending is False


def test_a_line_in_another_base_than_that_stated_is_sought_in_any() -> None:
    """Times of the day fit a trajectory in seconds of the week, though it is said to be Unix's."""
    track = START + np.linspace(0, 100, 400)
    zero = np.zeros(len(track))
    trajectory = Trajectory(track, zero, zero, zero, np.zeros((len(track), 3)))
    times = track[50:90] % 86_400
    line = LineTimes(
        times, times[0], times[-1], len(times), whole=True, reached_end=True, place=np.zeros(3)
    )
    for base in (None, base_of("unix"), base_of("gps-week")):
        best = fitting(line, trajectory, base)[0]
        assert best.share == 1.0
        assert best.shift == pytest.approx(START - START % 86_400)


# -- remedies -------------------------------------------------------------------------------------

EXCHANGED = "Latitude and longitude look exchanged: the course then follows the heading."
RADIANS = (
    "The first values of {} stay within a full circle of radians, so radians are taken; state "
    "degrees if they are."
)

_RANGE = np.linspace(6_000.0, 6_650.0, 50)
(FAR,) = (
    doubt
    for doubt in sight(np.column_stack([_RANGE, -_RANGE, 0 * _RANGE]), _RANGE, crs="").doubts
    if "origin" in doubt
)
"""What is said of points too far for a scanner."""


@pytest.mark.parametrize(
    ("key", "doubt", "options", "asks"),
    [
        ("sbet", EXCHANGED, [("order", "longitude-latitude")], [""]),
        ("ascii-trajectory", RADIANS.format("position"), [("position", "degrees")], [""]),
        ("ascii-trajectory", RADIANS.format("attitude"), [("attitude", "degrees")], [""]),
        ("las", "The points name no system: give its EPSG code.", [None], ["crs"]),
        (
            "las", "The resolution 0.0003048 comes from feet: check the unit.",
            [("unit", "foot"), ("unit", "us-survey-foot")], ["", ""],
        ),
        (
            "text", "The head of the file speaks of feet: check the unit.",
            [("unit", "foot"), ("unit", "us-survey-foot")], ["", ""],
        ),
        ("las", "They lie far from zero; check the frame.", [None], ["frame"]),
        ("las", FAR, [None], ["frame"]),
        ("las", "They could be two: choose the time base.", [None], ["time_base"]),
        ("sbet", "By their values alone they could also be of the day.", [None], ["time"]),
        ("sbet", "The vessel jumps by 3 m.", [], []),
    ],
)  # fmt: skip
def test_a_doubt_has_the_remedies_that_its_format_takes(
    key: str, doubt: str, options: list[tuple[str, str] | None], asks: list[str]
) -> None:
    format = format_of(key)
    entry = Entry(
        Path("a.dat"), role=format.kind, format=format, finding=Finding({}, doubts=(doubt,)),
        pending=False,
    )  # fmt: skip
    (remark,) = (each for each in remarks_of(entry, None, 1, 1, 1.5) if each.text == doubt)
    assert remark.level == "doubt"
    assert [remedy.option for remedy in remark.remedies] == options
    assert [remedy.ask for remedy in remark.remedies] == asks
    for remedy in remark.remedies:  # each of them is an option of the format, or none would do
        name = remedy.ask if remedy.option is None else remedy.option[0]
        assert name in entry.options
    other = replace(entry, stated={"order": "longitude-latitude"})
    if doubt == EXCHANGED:
        (remark,) = remarks_of(other, None, 1, 1, 1.5)
        assert remark.remedies == ()  # exchanged already


def test_of_a_long_file_it_is_said_that_the_rest_comes_later() -> None:
    sample = START + np.arange(1500.0)
    times = LineTimes(
        sample, sample[0], sample[-1], None, whole=False, reached_end=False, place=np.zeros(3)
    )
    entry = Entry(
        Path("a.txt"), role="points", format=format_of("text"), finding=Finding({}),
        content=times, pending=False,
    )  # fmt: skip
    (remark,) = remarks_of(entry, None, 1, 1, 1.5)
    assert (remark.level, remark.text) == (
        "note",
        "The file is long: the first 1,500 times looked at stand for it here, the rest is checked "
        "when the project is made.",
    )


@pytest.mark.parametrize(
    ("first", "level", "words"),
    [
        (0.0, None, ""),
        (20.0, "doubt", "It covers 486,020.0 to 486,060.0 s, not the whole trajectory"),
        (
            900.0,
            "error",
            "Its times (486,900.0 to 486,940.0 s) do not meet those of the",
        ),
    ],
)
def test_accuracies_are_held_against_the_trajectorys_times(
    files: Path, tmp_path: Path, first: float, level: str | None, words: str
) -> None:
    rows = np.tile([0, 0.01, 0.01, 0.02, 0.1, 0.1, 0.1, 0.5, 0.5, 0.7], (41, 1))
    rows[:, 0] = START + first + np.arange(41)
    path = write_records(tmp_path / "smrmsg.out", rows)
    alone = taken_in(Intake(), path)
    assert words == "" or words not in said(alone, "smrmsg.out")
    intake = taken_in(alone, files / "pos.sbet")
    told = [each for each in intake.remarks(named(intake, "smrmsg.out")) if each.text[:3] == "Its"
            or each.text.startswith("It covers")]  # fmt: skip
    assert [each.level for each in told] == ([] if level is None else [level])
    assert all(each.text.startswith(words) for each in told)
    assert [remedy.role for each in told for remedy in each.remedies] == (
        ["none"] if level == "error" else []
    )
