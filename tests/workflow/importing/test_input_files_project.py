"""Tests of adding lines to an open project, and of single rules of the list of input files."""

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.io.first_points import check_first_points
from lispac.io.format_types import FilePreview
from lispac.io.formats import format_of
from lispac.io.point_reader_common import (
    CHOOSE_SYSTEM_ACTION,
    USE_FEET_ACTIONS,
    time_base_warnings,
)
from lispac.io.points.line_times import LineTimes
from lispac.io.trajectory.ascii_trajectory import degrees_action
from lispac.io.trajectory.trajectory_facts import SWAP_COORDINATES_ACTION, time_warnings
from lispac.io.trajectory.trajectory_preview import sign_assumed_warning
from lispac.language import LANGUAGES, in_language
from lispac.message_texts import action_text, action_tip
from lispac.messages import Action, Level, Message, error, note, warning
from lispac.project import LineSource, Project, Settings
from lispac.survey.known_time_base import KnownTimeBase
from lispac.survey.time_base import base_of_key
from lispac.survey.trajectory import Trajectory
from lispac.workflow.importing import input_files as input_files_module
from lispac.workflow.importing.input_columns import (
    column_meanings,
    missing_columns,
    possible_meanings,
)
from lispac.workflow.importing.input_file import InputFile, examine_project_file, reexamine_file
from lispac.workflow.importing.input_file_messages import file_messages, option_to_choose
from lispac.workflow.importing.input_files import InputFiles, folder_problem, proposed_folder
from lispac.workflow.importing.input_times import (
    line_time_base,
    matching_shifts,
    trajectory_time_base,
)
from lispac.workflow.project.projects import new_project
from tests.support.input_file_samples import (
    LEVER,
    START,
    codes_about,
    import_files,
    named,
    write_line,
)
from tests.support.trajectory_files import vessel, write_records


@pytest.fixture(scope="module")
def project(files: Path, tmp_path_factory: pytest.TempPathFactory) -> Project:
    """Return a project with the first line of the survey only."""
    return new_project(
        tmp_path_factory.mktemp("made") / "quay", trajectory=files / "pos.sbet",
        accuracy=files / "smrmsg.out", lines=[LineSource("L1", files / "L1.laz")],
        settings=Settings(LEVER),
    )[0]  # fmt: skip


def opened(project: Project) -> InputFiles:
    """Return the input files of a project, examined, to add lines to."""
    input_files = InputFiles.of_project(project)
    for input_file in input_files.files:
        input_files = input_files.with_changed_file(examine_project_file(input_file))
    return input_files


# -- lines for an open project --------------------------------------------------------------------


def test_the_files_of_a_project_cannot_be_removed(project: Project, files: Path) -> None:
    input_files = opened(project)
    assert [input_file.role for input_file in input_files.files] == ["trajectory", "accuracy"]
    assert input_files.trajectory_content is not None
    assert input_files.accuracy_content is not None
    assert input_files.files_problem() == error("import.no_line")
    for input_file in input_files.files:
        assert input_files.without_file(input_file.path).files == input_files.files
        assert input_files.with_role(input_file.path, "points") is input_files
    without = InputFiles.of_project(replace(project, accuracy=None))
    assert [input_file.role for input_file in without.files] == ["trajectory"]
    more = import_files(input_files, files / "L2.las")
    assert more.files_problem() is None
    assert [(line.name, line.path.name) for line in more.sources()] == [("L2", "L2.las")]
    assert more.without_file(files / "L2.las").files_problem() == input_files.files_problem()


def test_a_line_of_the_project_can_only_be_skipped(project: Project, files: Path) -> None:
    input_files = import_files(opened(project), files / "L1.laz")
    (message,) = input_files.messages(named(input_files, "L1.laz"))
    assert (message.level, message.code) == (Level.ERROR, "import.already_in_project")
    assert message.params == {"file": "L1.laz", "line": "L1"}
    assert input_files.files_problem() == message
    skipped = input_files.with_action(files / "L1.laz", message.actions[0])
    assert skipped.state_of_file(skipped.file(files / "L1.laz")) == "out"


def test_bridging_gaps_is_proposed_only_for_a_new_project(
    project: Project, files: Path, tmp_path: Path
) -> None:
    """The longest gap is a setting of the project, which added lines do not change."""
    records = vessel(2000)
    time = records[:, 0] - START
    with_gap = write_records(tmp_path / "torn.sbet", records[(time < 5) | (time > 8)])
    (new,) = (
        message
        for message in (lambda i: i.messages(named(i, "L1.laz")))(
            import_files(InputFiles(), with_gap, files / "L1.laz")
        )
        if message.level is Level.WARNING
    )
    assert [action.params["gap"] for action in new.actions] == [pytest.approx(3.1, abs=0.11)]
    here = replace(project, trajectory=with_gap, lines=(), accuracy=None)
    input_files = import_files(opened(here), files / "L1.laz")
    messages = input_files.messages(named(input_files, "L1.laz"))
    assert messages == (replace(new, actions=()),)


def test_bridging_a_wide_gap_is_not_proposed(files: Path, tmp_path: Path) -> None:
    """Half a minute of the trajectory is missing, more than ten times the default limit."""
    records = vessel(2000)
    time = records[:, 0] - START
    with_gap = write_records(tmp_path / "torn.sbet", records[(time < 3) | (time > 30)])
    input_files = import_files(InputFiles(), with_gap, files / "L1.laz")
    found = input_files.messages(named(input_files, "L1.laz"))
    (message,) = (each for each in found if each.level is Level.WARNING)
    assert message.actions == ()


# -- single rules of the list ---------------------------------------------------------------------


def test_times_are_not_checked_without_a_trajectory(files: Path) -> None:
    line = import_files(InputFiles(), files / "L1.laz")
    input_file = line.file(files / "L1.laz")
    assert line.time_messages(input_file) == ()
    assert line.coverage(input_file) is None
    assert line.proposed_shifts == ()
    assert line.time_base is None
    both = import_files(line, files / "pos.sbet")
    assert both.time_messages(both.file(files / "pos.sbet")) == ()
    covered = both.coverage(both.file(files / "L1.laz"))
    assert covered is not None
    assert covered.usable == covered.count


def test_a_pending_file_has_no_messages(files: Path) -> None:
    waiting = InputFiles().with_files([files / "L1.laz"])
    input_file = waiting.files[0]
    assert waiting.state_of_file(input_file) == "pending"
    assert waiting.messages(input_file) == ()


def test_setting_the_same_role_changes_nothing(files: Path) -> None:
    input_files = import_files(InputFiles(), files / "L1.laz")
    assert input_files.with_role(files / "L1.laz", "points") is input_files
    assert input_files.with_action(files / "L1.laz", CHOOSE_SYSTEM_ACTION) is input_files


def test_a_second_accuracy_file_is_an_error(files: Path, tmp_path: Path) -> None:
    second = tmp_path / "second.out"
    second.write_bytes((files / "smrmsg.out").read_bytes())
    input_files = import_files(InputFiles(), files, second)
    assert "import.several_accuracies" in codes_about(input_files, "second.out")
    problem = input_files.files_problem()
    assert problem is not None
    assert (problem.code, problem.params["count"]) == ("import.several_errors", 1)


def test_a_free_folder_is_proposed_for_the_project(
    files: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Beside the folder of the data, with a number if needed; none without write access."""
    assert proposed_folder(InputFiles()) is None
    home = tmp_path / "home"
    home.mkdir()
    monkeypatch.setattr(Path, "home", lambda: home)
    raw = tmp_path / "quay" / "raw"
    raw.mkdir(parents=True)
    input_files = import_files(InputFiles(), write_line(raw / "L1.las", START + np.arange(50.0)))
    assert proposed_folder(input_files) == tmp_path / "quay" / "raw-boresight"
    (tmp_path / "quay" / "raw-boresight").mkdir()
    assert proposed_folder(input_files) == tmp_path / "quay" / "raw-boresight-2"
    pos = tmp_path / "quay" / "pos"
    pos.mkdir()
    both = import_files(input_files, write_line(pos / "L2.las", START + np.arange(50.0)))
    assert proposed_folder(both) == tmp_path / "quay" / "quay-boresight"
    allowed = os.access
    monkeypatch.setattr(
        input_files_module.os, "access", lambda path, mode: home in (path, *Path(path).parents)
        and allowed(path, mode),
    )  # fmt: skip
    assert proposed_folder(input_files) == home / "raw-boresight"
    monkeypatch.setattr(input_files_module.os, "access", lambda *_: False)
    assert folder_problem(str(tmp_path / "x")) == error(
        "import.folder_not_writable", folder=str(tmp_path)
    )
    assert proposed_folder(input_files) is None


# -- columns and time bases -----------------------------------------------------------------------


def test_possible_meanings_of_columns_depend_on_the_format() -> None:
    points, track = (
        possible_meanings(format_of("text")),
        possible_meanings(format_of("ascii-trajectory")),
    )
    assert points[0] == track[0] == "-"
    assert {"time", "x", "y", "z", "intensity"} == set(points[1:])
    assert {"latitude", "longitude", "roll", "pitch", "heading"} < set(track)
    assert "x" not in track
    assert column_meanings(format_of("text"), None, "time x - y") == ("time", "x", "-", "y")


@pytest.mark.parametrize(
    ("tokens", "missing"),
    [
        ("time latitude longitude height roll pitch heading", ""),
        ("time easting northing sea_height roll pitch heading", ""),
        ("time latitude longitude roll pitch heading", "height"),
        ("time latitude height roll pitch", "heading position"),
        ("date easting roll", "time pitch heading position height"),
    ],
)
def test_missing_columns_of_a_trajectory_are_named(tokens: str, missing: str) -> None:
    found = missing_columns(format_of("ascii-trajectory"), tokens.split())
    assert found == tuple(note(f"column.{name}") for name in missing.split())


def test_an_undecided_file_has_no_time_base() -> None:
    assert trajectory_time_base(None) == KnownTimeBase()
    input_file = InputFile(Path("a.sbet"), role="trajectory")
    assert trajectory_time_base(input_file) == KnownTimeBase()
    assert line_time_base(InputFile(Path("a.las"), role="points")).base is None
    assert input_file.options == {}
    assert reexamine_file(input_file).pending is False


def test_a_line_is_matched_in_all_bases_if_the_given_one_does_not_fit() -> None:
    """Times of the day fit a trajectory in seconds of the week, also if its given base is Unix."""
    track = START + np.linspace(0, 100, 400)
    zero = np.zeros(len(track))
    trajectory = Trajectory(track, zero, zero, zero, np.zeros((len(track), 3)))
    times = track[50:90] % 86_400
    line = LineTimes(
        times, times[0], times[-1], len(times), whole=True, reached_end=True, place=np.zeros(3)
    )
    for base in (None, base_of_key("unix"), base_of_key("gps-week")):
        best = matching_shifts(line, trajectory, base)[0]
        assert best.share == 1.0
        assert best.shift == pytest.approx(START - START % 86_400)


# -- actions --------------------------------------------------------------------------------------

_LARGE_VALUES = np.linspace(6_000.0, 6_650.0, 50)
_NEAR_POINTS = np.random.default_rng(5).normal(0, 10, (200, 3))
_SECONDS = 5000 + np.arange(200) / 100


def of_points(xyz: np.ndarray, crs: str = "") -> tuple[Message, ...]:
    """Return the warnings about the coordinates of points."""
    return check_first_points(xyz, _SECONDS[: len(xyz)], file="a.dat", crs=crs).file_warnings


_OPTIONS_OF_WARNINGS = [
    ("sbet", warning("trajectory.exchanged", file="a.dat", actions=(SWAP_COORDINATES_ACTION,)),
     [("order", "longitude-latitude")]),
    ("ascii-trajectory",
     warning("trajectory.position_in_radians", file="a.dat", actions=(degrees_action("position"),)),
     [("position", "degrees")]),
    ("ascii-trajectory",
     warning("trajectory.attitude_in_radians", file="a.dat", actions=(degrees_action("attitude"),)),
     [("attitude", "degrees")]),
    ("las", warning("points.feet_in_header", file="a.dat", actions=USE_FEET_ACTIONS),
     [("unit", "foot"), ("unit", "us-survey-foot")]),
    ("text", warning("points.feet_in_header", file="a.dat", actions=USE_FEET_ACTIONS),
     [("unit", "foot"), ("unit", "us-survey-foot")]),
    ("sbet", warning("trajectory.jumps", file="a.dat", speed=1.0, largest=90.0), []),
]  # fmt: skip


def input_file_with(key: str, message: Message) -> InputFile:
    """Return an input file of a format, with a warning of its reader."""
    format = format_of(key)
    radians = {a.params["name"]: "radians" for a in message.actions if a.code == "use_degrees"}
    finding = FilePreview({}, choice=radians, file_warnings=(message,))
    return InputFile(Path("a.dat"), role=format.kind, format=format, finding=finding, pending=False)


@pytest.mark.parametrize(("key", "message", "options"), _OPTIONS_OF_WARNINGS)
def test_a_warning_proposes_options_of_its_format(
    key: str, message: Message, options: list[tuple[str, str]]
) -> None:
    input_file = input_file_with(key, message)
    (shown,) = (
        each for each in file_messages(input_file, None, 1, 1, 1.5) if each.code == message.code
    )
    assert shown == message
    assert [(a.params["name"], a.params["value"]) for a in shown.actions] == options
    assert all(action.params["name"] in input_file.options for action in shown.actions)
    for name, value in options:  # not proposed if set already
        set_already = replace(input_file, given_options={name: value})
        (again,) = file_messages(set_already, None, 1, 1, 1.5)
        assert (name, value) not in [(a.params["name"], a.params["value"]) for a in again.actions]


@pytest.mark.parametrize(
    ("xyz", "crs", "code"),
    [
        (
            np.column_stack([_LARGE_VALUES, -_LARGE_VALUES, 0 * _LARGE_VALUES]),
            "",
            "points.far_from_origin",
        ),
        (_NEAR_POINTS, "EPSG:32619", "points.small_coordinates"),
        (_NEAR_POINTS * 1000, "", "points.around_origin"),
        (_NEAR_POINTS + [600, 100, 0], "", "points.away_from_origin"),
        (_NEAR_POINTS * [1e-5, 1e-5, 1] + [7, 50, 0], "", "points.degrees"),
    ],
)
def test_warnings_about_the_frame_propose_to_choose_it(
    xyz: np.ndarray, crs: str, code: str
) -> None:
    """The button depends on the action of the message, not on its text."""
    (message,) = (each for each in of_points(xyz, crs) if each.code == code)
    (shown,) = (
        each
        for each in file_messages(input_file_with("las", message), None, 1, 1, 1.5)
        if each.code == code
    )
    assert [(each.code, option_to_choose(each)) for each in shown.actions] == [
        ("choose_frame", "frame")
    ]
    assert action_text(shown.actions[0]) == "Choose the frame"
    # A trajectory has no such option.
    (other,) = file_messages(input_file_with("sbet", message), None, 1, 1, 1.5)
    assert other.actions == ()


@pytest.mark.parametrize(
    ("key", "message", "option"),
    [
        ("las", of_points(_NEAR_POINTS + [350_000, 5e6, 0])[0], "crs"),
        ("las", time_base_warnings(np.array([5e5]), "gps-adjusted", "a.dat")[0], "time_base"),
        ("sbet", time_warnings(START + 1e9 + np.arange(9.0), "unix", "a.dat")[0], "time"),
        ("ascii-trajectory", sign_assumed_warning(Path("a.dat"), "pitch", "bow-up"), "pitch"),
        ("ascii-trajectory", sign_assumed_warning(Path("a.dat"), "roll", "port-down"), "roll"),
    ],
)
def test_a_warning_has_an_action_to_choose_its_option(
    key: str, message: Message, option: str
) -> None:
    input_file = input_file_with(key, message)
    (shown,) = (
        each for each in file_messages(input_file, None, 1, 1, 1.5) if each.code == message.code
    )
    assert [option_to_choose(action) for action in shown.actions] == [option]
    assert option in input_file.options


@pytest.mark.parametrize("language", LANGUAGES)
def test_actions_and_tips_are_translated(language: str) -> None:
    shift = Action(
        "shift_times",
        {
            "shift": 18.0, "points": note("time_base.utc_week"),
            "trajectory": note("time_base.gps_week"),
        },
    )  # fmt: skip
    with in_language(language):
        assert "+18" in action_text(shift)
        assert action_tip(shift)
        assert action_tip(Action("leave_out")) == ""


def test_a_partly_read_file_is_reported() -> None:
    sample = START + np.arange(1500.0)
    times = LineTimes(
        sample, sample[0], sample[-1], None, whole=False, reached_end=False, place=np.zeros(3)
    )
    input_file = InputFile(
        Path("a.txt"), role="points", format=format_of("text"), finding=FilePreview({}),
        content=times, pending=False,
    )  # fmt: skip
    assert file_messages(input_file, None, 1, 1, 1.5) == (
        note("import.first_times", file="a.txt", count=1500),
    )


@pytest.mark.parametrize(
    ("first", "level", "code"),
    [
        (0.0, None, ""),
        (20.0, Level.WARNING, "import.accuracy_too_short"),
        (900.0, Level.ERROR, "import.accuracy_times"),
    ],
)
def test_accuracies_must_cover_the_times_of_the_trajectory(
    files: Path, tmp_path: Path, first: float, level: Level | None, code: str
) -> None:
    rows = np.tile([0, 0.01, 0.01, 0.02, 0.1, 0.1, 0.1, 0.5, 0.5, 0.7], (41, 1))
    rows[:, 0] = START + first + np.arange(41)
    path = write_records(tmp_path / "smrmsg.out", rows)
    alone = import_files(InputFiles(), path)
    assert code not in codes_about(alone, "smrmsg.out")
    input_files = import_files(alone, files / "pos.sbet")
    found = [
        each for each in input_files.messages(named(input_files, "smrmsg.out"))
        if each.code.startswith("import.accuracy_")
    ]  # fmt: skip
    assert [(each.level, each.code) for each in found] == ([(level, code)] if level else [])
    for each in found:
        assert each.params["first"] == START + first
        assert each.params["last"] == START + first + 40
    assert [action.code for each in found for action in each.actions] == (
        ["leave_out"] if level is Level.ERROR else []
    )
