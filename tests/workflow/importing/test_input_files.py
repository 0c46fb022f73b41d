"""Tests of the examination of input files: kinds, formats and agreement of their times."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.io.formats import format_of
from lispac.io.points import line_times as times_module
from lispac.io.points.line_times import read_line_times
from lispac.io.project.project_file import read_project
from lispac.messages import Action, Level, Message, error, note
from lispac.project import LineSource, Settings
from lispac.survey.trajectory import DEFAULT_LONGEST_GAP_S
from lispac.workflow.importing.input_file import examine_file
from lispac.workflow.importing.input_files import InputFiles, find_project, proposed_folder
from lispac.workflow.project.projects import new_project, open_project
from lispac.workflow.project.survey import load_survey
from tests.support.input_file_samples import (
    LEVER,
    START,
    codes_about,
    fan,
    import_files,
    message_texts,
    named,
    write_line,
)
from tests.support.message_codes import codes
from tests.support.trajectory_files import vessel, write_records

# -- kinds of files ------------------------------------------------------------------------------


def test_kinds_of_the_files_of_a_folder_are_detected(whole: InputFiles) -> None:
    roles = {input_file.path.name: input_file.role for input_file in whole.files}
    assert roles == {
        "pos.sbet": "trajectory", "smrmsg.out": "accuracy", "L1.laz": "points",
        "L2.las": "points", "letter.md": None,
    }  # fmt: skip
    assert whole.import_problem("") == note("import.no_folder")
    assert whole.time_base is not None
    assert whole.time_base.key == "gps-week"
    assert {whole.state_of_file(line) for line in whole.lines} == {"fine"}
    assert whole.state_of_file(named(whole, "letter.md")) == "out"
    assert codes_about(whole, "letter.md") == ["import.unknown_format"]


def test_assumptions_of_readers_are_distinguished_from_warnings(whole: InputFiles) -> None:
    finding = named(whole, "pos.sbet").finding
    assert finding is not None
    assert "assumed.pitch_bow_up" in codes(finding.assumptions)
    assert not set(codes(finding.assumptions)) & set(codes(finding.file_warnings))


def test_a_project_among_the_files_is_found(files: Path, tmp_path: Path) -> None:
    assert find_project([files, files / "L1.laz"]) is None
    (tmp_path / "project.json").write_text("{}")
    assert find_project([files, tmp_path]) == tmp_path
    assert find_project([tmp_path / "project.json"]) == tmp_path / "project.json"


def test_missing_files_are_reported_in_order(files: Path, tmp_path: Path) -> None:
    assert InputFiles().import_problem("x") == note("import.no_files")
    waiting = InputFiles().with_files([files / "L1.laz"])
    assert waiting.import_problem("x") == note("import.being_examined")
    line = import_files(InputFiles(), files / "L1.laz")
    assert line.import_problem("x") == error("import.no_trajectory")
    track = import_files(InputFiles(), files / "pos.sbet")
    assert track.import_problem("x") == error("import.no_line")
    (tmp_path / "project.json").write_text("{}")
    both = import_files(line, files / "pos.sbet")
    assert both.import_problem(str(tmp_path)) == error("import.folder_has_project")
    assert both.import_problem(str(files / "L1.laz")) == error("import.folder_is_file")
    assert both.import_problem(str(tmp_path / "new")) is None
    assert proposed_folder(both) == files.parent / f"{files.name}-boresight"


def test_a_second_trajectory_is_an_error_until_it_is_skipped(
    whole: InputFiles, files: Path, tmp_path: Path
) -> None:
    second = write_records(tmp_path / "second.sbet", vessel(500))
    input_files = import_files(whole, second)
    problem = input_files.import_problem("x")
    assert problem is not None
    assert problem.code == "import.several_errors"
    first = problem.params["first"]
    assert isinstance(first, Message)
    assert (first.code, first.params["file"]) == ("import.several_trajectories", "pos.sbet")
    (leave_out,) = input_files.messages(named(input_files, "second.sbet"))[0].actions
    resolved = input_files.with_action(second, leave_out)
    assert resolved.state_of_file(resolved.file(second)) == "out"
    assert resolved.trajectory is not None
    assert resolved.trajectory.path == files / "pos.sbet"
    assert resolved.files_problem() is None


def test_ambiguous_text_is_a_line_if_a_trajectory_exists(files: Path, tmp_path: Path) -> None:
    rows = np.column_stack([START + np.linspace(3, 9, 200), fan(200), np.ones((200, 4))])
    text = tmp_path / "points.txt"
    np.savetxt(text, rows, fmt="%.4f")
    alone = import_files(InputFiles(), text)
    assert "points" in alone.files[0].roles
    beside = import_files(import_files(InputFiles(), files / "pos.sbet"), text)
    assert beside.file(text).role == "points"


def test_lines_with_the_same_name_are_named_by_their_folders(files: Path, tmp_path: Path) -> None:
    paths = []
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        paths.append(write_line(tmp_path / folder / "scan.laz", START + np.linspace(1, 2, 100)))
    input_files = import_files(InputFiles(), files / "pos.sbet", *paths)
    assert list(input_files.names.values()) == ["a_scan", "b_scan"]
    assert input_files.files_problem() is None


def test_a_damaged_line_is_an_error_until_it_is_skipped(
    whole: InputFiles, files: Path, tmp_path: Path
):
    damaged = tmp_path / "damaged.laz"
    content = (files / "L1.laz").read_bytes()
    damaged.write_bytes(content[: len(content) // 2])
    input_files = import_files(whole, damaged)
    assert input_files.state_of_file(input_files.file(damaged)) == "error"
    assert str(damaged) not in message_texts(input_files, "damaged.laz")
    assert input_files.import_problem("x") == input_files.messages(input_files.file(damaged))[0]
    assert input_files.with_role(damaged, None).files_problem() is None


# -- times ---------------------------------------------------------------------------------------


def test_the_shift_that_fits_seconds_of_the_day_is_proposed(
    whole: InputFiles, files: Path, tmp_path: Path
) -> None:
    late = write_line(tmp_path / "day.laz", START + np.linspace(20, 30, 3000) - 5 * 86_400)
    input_files = import_files(whole, late)
    message = input_files.messages(input_files.file(late))[0]
    assert (message.level, message.code) == (Level.ERROR, "import.outside_with_shift")
    assert message.params["points"] == note("time_base.gps_day")
    assert message.actions[0].params["shift"] == pytest.approx(432_000)
    assert [input_file.path for input_file, _ in input_files.proposed_shifts] == [late]
    for shifted in (
        input_files.with_action(late, message.actions[0]),
        input_files.with_shift_for_all(),
    ):
        assert shifted.files_problem() is None
        assert shifted.proposed_shifts == ()
        covered = shifted.coverage(shifted.file(late))
        assert covered is not None
        assert covered.usable == covered.count
    request = shifted.request(tmp_path / "made", Settings(lever_arm=LEVER))
    project, survey = new_project(
        request.folder, trajectory=request.trajectory, lines=request.lines,
        settings=request.settings, accuracy=request.accuracy,
        trajectory_reading=request.trajectory_reading, accuracy_reading=request.accuracy_reading,
    )  # fmt: skip
    assert survey.scans["day"].time.min() == pytest.approx(START + 20)
    assert len(survey.scans["day"]) == 3000
    again = load_survey(open_project(project.folder))
    assert again.scans["day"].time.max() == pytest.approx(START + 30)


def test_an_ambiguous_shift_is_a_warning(whole: InputFiles, tmp_path: Path) -> None:
    # The line ends 18 s or more before the trajectory: UTC and GPS seconds of the day both fit.
    late = write_line(tmp_path / "day.laz", START + np.linspace(1, 5, 500) - 5 * 86_400)
    input_files = import_files(whole, late)
    first = input_files.messages(input_files.file(late))[0]
    assert len({action.params.get("shift") for action in first.actions} - {None}) == 2
    shifted = input_files.with_action(late, first.actions[0])
    assert shifted.state_of_file(shifted.file(late)) == "warning"
    rivals = shifted.messages(shifted.file(late))[0]
    assert rivals.code == "import.other_bases_fit"
    assert (
        shifted.with_action(late, rivals.actions[-1]).state_of_file(input_files.file(late))
        == "error"
    )


def test_a_line_of_another_day_is_refused_with_the_distance(
    whole: InputFiles, tmp_path: Path
) -> None:
    other = write_line(tmp_path / "other.laz", START + 50_000 + np.linspace(0, 5, 500))
    input_files = import_files(whole, other)
    message = input_files.messages(input_files.file(other))[0]
    assert (message.level, message.code) == (Level.ERROR, "import.after_trajectory")
    assert message.params["distance"] == pytest.approx(49_960, abs=0.5)
    assert message.actions == (Action("leave_out"),)


def gaps_of(input_files: InputFiles, name: str) -> list[Message]:
    """Return the messages about the gaps of a trajectory."""
    return [
        each
        for each in input_files.messages(named(input_files, name))
        if each.code == "trajectory.gaps"
    ]


def test_points_in_gaps_are_reported_and_gaps_can_be_bridged(files: Path, tmp_path: Path) -> None:
    records = vessel(2000)
    time = records[:, 0] - START
    records = records[(time < 17) | (time > 19)]
    write_records(tmp_path / "gap.sbet", records)
    late = write_line(tmp_path / "late.laz", START + np.linspace(30, 45, 3000))
    input_files = import_files(InputFiles(), tmp_path / "gap.sbet", files / "L2.las", late)
    in_gaps = input_files.messages(named(input_files, "L2.las"))[0]
    assert (in_gaps.code, in_gaps.params["limit"]) == ("import.points_in_gaps", 1.5)
    assert "import.points_outside" in codes_about(input_files, "late.laz")
    (gaps,) = gaps_of(input_files, "gap.sbet")
    assert (gaps.params["count"], gaps.params["limit"]) == (1, 1.5)
    assert gaps.params["longest"] == pytest.approx(2.0, abs=0.05)
    covered = input_files.coverage(named(input_files, "L2.las"))
    assert covered is not None
    assert covered.share_in_gaps == pytest.approx(0.2, abs=0.01)
    request = input_files.request(tmp_path / "a", Settings(lever_arm=LEVER))
    _, survey = new_project(
        request.folder, trajectory=request.trajectory, lines=request.lines,
        settings=request.settings,
    )  # fmt: skip
    counts = {each.code: each.params.get("count") for each in survey.notes}
    assert counts["import.excluded_in_gaps"] == 3000 - len(survey.scans["L2"])
    assert counts["import.excluded_outside"] == 3000 - len(survey.scans["late"])

    (bridge,) = in_gaps.actions
    assert bridge.params["gap"] == pytest.approx(2.0, abs=0.11)
    bridged = input_files.with_action(files / "L2.las", bridge)
    assert bridged.state_of_file(named(bridged, "L2.las")) == "fine"
    assert gaps_of(bridged, "gap.sbet") == []
    (shorter,) = gaps_of(replace(input_files, longest_gap=0.5), "gap.sbet")
    assert (shorter.params["count"], shorter.params["limit"]) == (1, 0.5)
    request = bridged.request(tmp_path / "b", Settings(lever_arm=LEVER))
    project, survey = new_project(
        request.folder, trajectory=request.trajectory, lines=request.lines,
        settings=request.settings,
    )  # fmt: skip
    assert len(survey.scans["L2"]) == 3000
    assert read_project(project.folder).settings.longest_gap == bridge.params["gap"]


def test_a_project_file_without_the_longest_gap_has_the_default(
    files: Path, tmp_path: Path
) -> None:
    project, _ = new_project(
        tmp_path / "p", trajectory=files / "pos.sbet",
        lines=[LineSource("L1", files / "L1.laz")], settings=Settings(lever_arm=LEVER),
    )  # fmt: skip
    path = project.folder / "project.json"
    content = json.loads(path.read_text())
    assert content["settings"].pop("longest_gap") == DEFAULT_LONGEST_GAP_S
    path.write_text(json.dumps(content))
    assert open_project(project.folder).settings.longest_gap == DEFAULT_LONGEST_GAP_S


def test_a_long_line_is_sampled(files: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = read_line_times(files / "L1.laz", format_of("las"), {})
    monkeypatch.setattr(times_module, "MAX_POINTS_READ_WHOLE", 1000)
    monkeypatch.setattr(times_module, "POINTS_PER_BLOCK", 50)
    sampled = read_line_times(files / "L1.laz", format_of("las"), {})
    assert not sampled.whole
    assert whole.whole
    assert sampled.count == whole.count == 3000
    assert (sampled.start, sampled.end) == (whole.start, whole.end)
    assert len(sampled.sample) == 40 * 50


def test_the_reading_of_times_stops_at_a_time_limit(
    files: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(times_module, "TIME_LIMIT_S", -1.0)
    input_file = examine_file(files / "deeper" / "L9.txt")
    assert input_file.content is None  # the names of its columns are not given yet
    monkeypatch.setattr("lispac.io.las.las_chunks.POINTS_PER_CHUNK", 500)
    cut = read_line_times(files / "L1.laz", format_of("las"), {})
    assert not cut.reached_end
    assert cut.count == 3000
    assert cut.end < START + 12
