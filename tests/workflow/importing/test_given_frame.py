"""Tests of a given frame or coordinate system that the coordinates contradict."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.cli.main import main
from lispac.errors import InputError
from lispac.io.formats import format_of
from lispac.io.point_reader_common import CHOOSE_FRAME_ACTION
from lispac.io.points.line_times import read_line_times
from lispac.messages import warning
from lispac.project import LineSource, Project, Reading, Settings
from lispac.survey.crs import coordinate_system
from lispac.survey.scanner_frame_recovery import MAX_PLAUSIBLE_RANGE_M
from lispac.warning_causes import Cause
from lispac.workflow.importing.input_files import InputFiles
from lispac.workflow.importing.line_import import import_lines
from lispac.workflow.output.georeferencing import georeference_project
from lispac.workflow.project.projects import create_project, new_project
from tests.support.command_errors import codes_of, command_error
from tests.support.error_codes import has_code
from tests.support.input_file_samples import (
    LEVER,
    START,
    codes_about,
    fan,
    import_files,
    named,
    write_line,
)
from tests.support.trajectory_files import vessel, write_records

UTM = "EPSG:32619"


@pytest.fixture
def track(tmp_path: Path) -> Path:
    write_records(tmp_path / "pos.sbet", vessel(2000))
    return tmp_path / "pos.sbet"


def on_map(folder: Path, crs: str = "") -> Path:
    """Write a line near the trajectory, in UTM."""
    states = vessel(2000)
    system = coordinate_system(UTM, height="ellipsoid")
    place = system.from_geodetic(*(states[:1, k] for k in (1, 2, 3)))[0]
    return write_line(folder / "utm.las", START + np.linspace(5, 20, 3000), place + fan(3000), crs)


def options(**values: str) -> Reading:
    return Reading("", tuple(values.items()))


def make_project(folder: Path, track: Path, line: Path, reading: Reading):
    return new_project(
        folder, trajectory=track, lines=[LineSource("L", line, reading=reading)],
        settings=Settings(lever_arm=LEVER),
    )  # fmt: skip


def test_map_coordinates_given_as_scanner_frame_are_refused(track, tmp_path) -> None:
    line = on_map(tmp_path, UTM)
    too_far = has_code("survey.not_scanner_frame", limit=5000.0)
    with pytest.raises(InputError, check=too_far):
        make_project(tmp_path / "p", track, line, options(frame="scanner"))
    input_files = import_files(
        import_files(InputFiles(), track, line).with_option(line, "frame", "scanner")
    )
    problem = input_files.files_problem()
    assert problem is not None
    assert problem.code == "survey.not_scanner_frame"
    assert input_files.state_of_file(named(input_files, "utm.las")) == "error"
    project: Project = create_project(
        tmp_path / "old", trajectory=track, settings=Settings(lever_arm=LEVER),
        lines=[LineSource("L", line, reading=Reading("las", (("frame", "scanner"),)))],
    )  # fmt: skip
    with pytest.raises(InputError, check=too_far):
        import_lines(project)
    with pytest.raises(InputError, check=too_far):
        georeference_project(project, tmp_path / "out", "prior", system="local")
    usual = replace(project, lines=(replace(project.lines[0], reading=Reading()),))
    with pytest.raises(InputError, check=too_far):
        georeference_project(usual, tmp_path / "out", "prior", system="local")


def test_the_frame_of_a_long_line_is_checked_by_points_of_all_parts(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr("lispac.io.points.line_times.MAX_POINTS_READ_WHOLE", 100)
    with pytest.raises(InputError, check=has_code("survey.not_scanner_frame")):
        read_line_times(on_map(tmp_path), format_of("las"), {"frame": "scanner"})
    points = fan(3000)
    points[0] += [0, 2 * MAX_PLAUSIBLE_RANGE_M, 0]  # a single outlier at the beginning
    line = write_line(tmp_path / "stray.las", START + np.linspace(5, 20, 3000), points)
    times = read_line_times(line, format_of("las"), {"frame": "scanner"})
    assert times.count == 3000


def test_distant_points_are_excluded_and_the_line_is_accepted(track, tmp_path) -> None:
    points = fan(3000)
    points[::3] += [0, 2 * MAX_PLAUSIBLE_RANGE_M, 0]
    line = write_line(tmp_path / "noise.las", START + np.linspace(5, 20, 3000), points)
    _, survey = make_project(tmp_path / "p", track, line, options(frame="scanner"))
    assert len(survey.scans["L"]) == 2000  # points beyond the largest range are excluded


def test_a_given_system_ends_the_request_for_one(track, tmp_path, capsys) -> None:
    line = on_map(tmp_path)
    command = ["new", str(tmp_path / "p"), str(line), "--trajectory", str(track)]
    command += ["--lever-arm", "0", "0", "0"]
    assert "crs.none_given" in codes_of(command_error(*command))
    assert main([*command, "--line-option", f"crs={UTM}"]) == 0
    capsys.readouterr()
    input_files = import_files(InputFiles(), track, line)
    assert "points.no_system" in codes_about(input_files, "utm.las")
    input_files = import_files(input_files.with_option(line, "crs", UTM))
    assert input_files.state_of_file(named(input_files, "utm.las")) == "fine"


def test_an_unused_system_is_reported(track, tmp_path) -> None:
    line = write_line(tmp_path / "near.las", START + np.linspace(5, 20, 3000))
    project, survey = make_project(tmp_path / "p", track, line, options(crs=UTM))
    unused = warning(
        "points.unused_system", file="near.las", system=UTM, actions=(CHOOSE_FRAME_ACTION,)
    )
    assert unused in project.reading_warnings
    assert replace(unused, subject=Cause.of_line("L")) in survey.messages
    input_files = import_files(
        import_files(InputFiles(), track, line).with_option(line, "crs", UTM)
    )
    assert unused in input_files.messages(named(input_files, "near.las"))
    assert input_files.state_of_file(named(input_files, "near.las")) == "warning"
