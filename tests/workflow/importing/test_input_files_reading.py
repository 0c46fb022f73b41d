"""Tests of columns, coordinate systems, options and accuracies of input files."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.io.trajectory.sbet import read_sbet
from lispac.language import LANGUAGES, in_language
from lispac.messages import Level, Message, note
from lispac.project import Settings
from lispac.survey.crs import coordinate_system
from lispac.survey.georeferencing import Mounting, georeference
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.importing.input_file_messages import option_to_choose
from lispac.workflow.importing.input_files import InputFiles
from lispac.workflow.project.projects import new_project
from tests.support.input_file_samples import (
    LEVER,
    START,
    codes_about,
    fan,
    import_files,
    message_texts,
    write_line,
)
from tests.support.trajectory_files import vessel, write_records

# -- columns -------------------------------------------------------------------------------------


def write_unnamed(path: Path, seconds: float = 3.0) -> Path:
    rows = np.column_stack([fan(400), START + np.linspace(seconds, seconds + 5, 400)])
    np.savetxt(path, rows, fmt="%.6f")
    return path


def test_chosen_columns_are_used_for_the_next_file(files: Path, tmp_path: Path) -> None:
    text = write_unnamed(tmp_path / "one.txt")
    input_files = import_files(InputFiles(), files / "pos.sbet", text)
    assert input_files.state_of_file(input_files.file(text)) == "error"
    (missing,) = input_files.messages(input_files.file(text))
    assert missing.code == "import.columns_not_chosen"
    names = [note(f"column.{name}") for name in ("time", "x", "y", "z")]
    assert list(missing.params["columns"]) == names  # type: ignore[arg-type]
    for column, meaning in enumerate(("y", "y", "z", "time")):
        input_files = import_files(input_files.with_column(text, column, meaning))
    assert tuple(input_files.messages(input_files.file(text))[0].params["columns"]) == (  # type: ignore[arg-type]
        note("column.x"),
    )
    assert input_files.file(text).columns == ("-", "y", "z", "time")
    input_files = import_files(input_files.with_column(text, 0, "x"))
    assert input_files.state_of_file(input_files.file(text)) == "fine", message_texts(
        input_files, "one.txt"
    )
    request = input_files.request(tmp_path / "p", Settings(lever_arm=LEVER))
    _, survey = new_project(
        request.folder, trajectory=request.trajectory, lines=request.lines,
        settings=request.settings,
    )  # fmt: skip
    np.testing.assert_allclose(survey.scans["one"].points_lidar, fan(400), atol=1e-6)

    second = write_unnamed(tmp_path / "two.txt", 20.0)
    after = import_files(
        InputFiles(), files / "pos.sbet", second, mappings=input_files.column_mappings
    )
    assert after.file(second).remembered
    assert after.file(second).columns == ("x", "y", "z", "time")
    assert after.state_of_file(after.file(second)) == "fine"
    (action,) = after.messages(after.file(second))[0].actions
    assert action.code == "detect_columns"
    anew = import_files(after.with_action(second, action))
    assert anew.state_of_file(anew.file(second)) == "error"


def test_columns_of_another_layout_are_not_reused(files: Path, tmp_path: Path) -> None:
    first = write_unnamed(tmp_path / "one.txt")
    input_files = import_files(InputFiles(), first)
    for column, meaning in enumerate(("x", "y", "z", "time")):
        input_files = import_files(input_files.with_column(first, column, meaning))
    wider = tmp_path / "wider.txt"
    np.savetxt(wider, np.column_stack([np.loadtxt(first), np.arange(400) % 50]), fmt="%.6f")
    assert (
        not import_files(InputFiles(), wider, mappings=input_files.column_mappings)
        .files[0]
        .remembered
    )


def test_columns_of_a_text_trajectory_can_be_chosen(tmp_path: Path) -> None:
    records = vessel(300)
    rows = np.column_stack(
        [records[:, 0], np.degrees(records[:, 1:3]), records[:, 3], np.degrees(records[:, 7:10])]
    )
    rows = rows[:, [1, 2, 3, 0, 4, 5, 6]]  # time is the fourth column
    path = tmp_path / "track.csv"
    np.savetxt(path, rows, fmt="%.9f", delimiter=",")
    input_files = import_files(InputFiles(), path)
    assert input_files.file(path).role == "trajectory"
    order = ("latitude", "longitude", "height", "time", "roll", "pitch", "heading")
    for column, meaning in enumerate(order):
        input_files = import_files(input_files.with_column(path, column, meaning))
    assert input_files.file(path).error is None
    assert input_files.trajectory_content is not None
    np.testing.assert_allclose(input_files.trajectory_content.time, records[:, 0])


# -- coordinate systems and options --------------------------------------------------------------


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_trajectory_on_the_map_needs_its_coordinate_system(tmp_path: Path, language: str) -> None:
    path = tmp_path / "track.txt"
    rows = [f"{START + k},600000,5040000,10,0,0,90" for k in range(40)]
    path.write_text("\n".join(["time,easting,northing,height,roll,pitch,heading", *rows]))
    with in_language(language):
        input_files = import_files(InputFiles(), path)
    input_file = input_files.file(path)
    assert input_file.error is not None
    assert input_file.error.code == "trajectory.no_system"
    errors = [each for each in input_files.messages(input_file) if each.level is Level.ERROR]
    assert [option_to_choose(each.actions[0]) for each in errors] == ["crs"]


def test_a_line_on_the_map_needs_its_coordinate_system(
    whole: InputFiles, files: Path, tmp_path: Path
) -> None:
    raw = read_sbet(files / "pos.sbet")
    frame = raw.mean_frame()
    times = START + np.linspace(2, 8, 1500)
    mounting = Mounting(np.array(LEVER), np.zeros(3))
    local = georeference(fan(1500), times, LocalTrajectory.of(raw, frame), mounting)
    points = coordinate_system("EPSG:32618").from_local(local, frame)

    with_system = write_line(tmp_path / "stated.laz", times, points, "EPSG:32618")
    input_files = import_files(whole, with_system)
    place = input_files.file(with_system).place
    assert place is not None
    assert place.system.startswith("WGS 84 / UTM zone 18N")
    assert input_files.state_of_file(input_files.file(with_system)) == "fine", message_texts(
        input_files, "stated.laz"
    )

    bare = write_line(tmp_path / "bare.laz", times, points)
    input_files = import_files(whole, bare)
    message = input_files.messages(input_files.file(bare))[0]
    assert (message.level, option_to_choose(message.actions[0])) == (Level.ERROR, "crs")
    assert input_files.coverage(input_files.file(bare)) is not None
    wrong = import_files(input_files.with_option(bare, "crs", "EPSG:32617"))
    assert "import.far_from_trajectory" in codes_about(wrong, "bare.laz")
    nonsense = import_files(input_files.with_option(bare, "crs", "EPSG:1"))
    unknown = nonsense.messages(nonsense.file(bare))[0].params["reason"]
    assert isinstance(unknown, Message)
    assert unknown.code == "crs.unknown"
    right = import_files(wrong.with_option(bare, "crs", "32618"))
    assert right.files_problem() is None
    request = right.request(tmp_path / "p", Settings(lever_arm=LEVER))
    _, survey = new_project(
        request.folder, trajectory=request.trajectory, lines=request.lines,
        settings=request.settings,
    )  # fmt: skip
    np.testing.assert_allclose(survey.scans["bare"].points_lidar, fan(1500), atol=1e-3)


def test_a_given_option_is_part_of_the_request(whole: InputFiles, files: Path) -> None:
    pos = files / "pos.sbet"
    usual = whole.request(Path("p"), Settings(lever_arm=LEVER)).trajectory_reading
    assert usual.format == ""
    turned = import_files(whole.with_option(pos, "pitch", "bow-down"))
    reading = turned.request(Path("p"), Settings(lever_arm=LEVER)).trajectory_reading
    assert (reading.format, dict(reading.options)) == ("sbet", {"pitch": "bow-down"})
    assert whole.trajectory_content is not None
    assert turned.trajectory_content is not None
    np.testing.assert_allclose(
        turned.trajectory_content.attitude[:, 1], -whole.trajectory_content.attitude[:, 1]
    )


def test_an_accuracy_of_another_time_is_an_error(whole: InputFiles, files: Path, tmp_path: Path):
    other = np.fromfile(files / "smrmsg.out").reshape(-1, 10)
    other[:, 0] += 5000
    write_records(tmp_path / "other.out", other)
    input_files = import_files(whole.without_file(files / "smrmsg.out"), tmp_path / "other.out")
    assert "import.accuracy_times" in codes_about(input_files, "other.out")
    assert replace(input_files, files=whole.files).files_problem() is None
