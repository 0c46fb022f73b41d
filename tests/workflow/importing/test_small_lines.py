"""Tests of lines with few points along a short trajectory: reading, writing and refusals."""

from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.errors import InputError, ProjectError
from lispac.messages import error
from lispac.progress import Step
from lispac.project import LineSource, Project, Reading, Settings
from lispac.survey.store.original_file import source_file_of
from lispac.workflow.importing.file_reading import (
    default_or_detected_reading,
    detect_reading,
    local_trajectory,
)
from lispac.workflow.importing.line_import import _LineFileReader, import_line
from lispac.workflow.importing.line_points import LinePoints
from lispac.workflow.output.georeferencing import georeference_project
from lispac.workflow.project.projects import (
    create_project,
    read_unsaved_project,
    require_folder,
    with_lines_added,
)
from lispac.workflow.project.survey import load_survey
from tests.support.error_codes import has_code
from tests.support.input_file_samples import LEVER, START, fan, write_line, write_survey
from tests.support.trajectory_files import write_records


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A trajectory of 40 s with its accuracies, and lines from 2 to 12 and from 15 to 25 s."""
    (tmp_path / "files").mkdir()
    return write_survey(tmp_path / "files")


@pytest.fixture
def project(folder: Path, tmp_path: Path) -> Project:
    return create_project(
        tmp_path / "quay", trajectory=folder / "pos.sbet", accuracy=folder / "smrmsg.out",
        lines=[LineSource("L1", folder / "L1.laz")], settings=Settings(LEVER),
    )  # fmt: skip


# -- importing ------------------------------------------------------------------------------------


@pytest.mark.parametrize("latency", [0.0, 4.0, -4.0])
def test_points_outside_the_trajectory_by_the_latency_are_skipped(
    project: Project, folder: Path, latency: float
) -> None:
    """All times of the line are within the trajectory, but not with the latency added."""
    times = START + np.linspace(1, 39, 3801)
    line = LineSource("all", write_line(folder / "all.las", times))
    project = project.with_settings(replace(project.settings, latency=latency))
    project = replace(project, lines=(line,))
    trajectory, _ = local_trajectory(project)
    stored = import_line(project, line, trajectory).stored
    moved = times + latency
    inside = (moved >= trajectory.time[0]) & (moved <= trajectory.time[-1])
    assert stored.manifest.excluded_points == np.count_nonzero(~inside)
    assert len(stored) == np.count_nonzero(inside)
    assert (stored.manifest.excluded_points > 0) == (latency != 0)
    survey = load_survey(project)
    assert survey.scans["all"].first_time == times[inside][0]


@pytest.mark.parametrize("first", [0, 3, 4, 700, 1000])
def test_a_resumed_import_has_the_remaining_points_and_positions(
    project: Project, first: int
) -> None:
    (line,) = project.lines
    trajectory, _ = local_trajectory(project)
    points = LinePoints(line, trajectory, project.mounting("prior"))
    source = _LineFileReader(points, source_file_of(line.path))
    index = np.concatenate([piece.index for piece in source.pieces(first)])
    assert index.tolist() == list(range(first, points.audit.read))


def test_a_line_without_points_is_not_imported(project: Project, folder: Path) -> None:
    path = folder / "empty.las"
    laspy.LasData(laspy.LasHeader(point_format=6, version="1.4")).write(path)
    line = LineSource("empty", path)
    project = replace(project, lines=(line,))
    trajectory, _ = local_trajectory(project)
    with pytest.raises(InputError) as caught:
        import_line(project, line, trajectory)
    assert caught.value.message == error("file.no_points", file=str(path))
    assert not (project.folder / "lines").exists() or not any((project.folder / "lines").iterdir())


# -- projects -------------------------------------------------------------------------------------


def test_an_existing_line_is_not_added_again(project: Project, folder: Path) -> None:
    again = LineSource("again", folder / "L1.laz")
    with pytest.raises(ProjectError) as caught:
        with_lines_added(project, [again])
    assert caught.value.code == "project_line.known"
    assert caught.value.message is not None
    assert caught.value.message.params == {"file": str(folder / "L1.laz"), "line": "L1"}
    more, survey = with_lines_added(project, [LineSource("L2", folder / "L2.las")])
    assert survey.lines == ("L1", "L2")
    assert more.lines[0] == project.lines[0]


def test_no_unsaved_project_is_found_where_there_is_none(project: Project) -> None:
    assert read_unsaved_project(project.folder) is None


def test_a_deleted_folder_is_not_created_again(project: Project) -> None:
    require_folder(project)
    project.folder.rename(project.folder.with_name("elsewhere"))
    with pytest.raises(InputError) as caught:
        require_folder(project)
    assert caught.value.code == "project_folder.gone"
    assert str(project.folder) in str(caught.value)
    assert not project.folder.exists()


# -- reading --------------------------------------------------------------------------------------


def test_a_file_without_a_matching_format_is_refused(folder: Path) -> None:
    path = folder / "letter.md"
    with pytest.raises(InputError) as caught:
        detect_reading(path, "trajectory", Reading())
    assert caught.value.code == "import.unknown_trajectory_format"
    assert str(path) in str(caught.value)
    assert default_or_detected_reading(path, "trajectory", Reading()) == (Reading(), ())


def test_accuracies_of_another_day_are_refused(project: Project, folder: Path) -> None:
    rows = np.tile([0, 0.01, 0.01, 0.02, 0.1, 0.1, 0.1, 0.5, 0.5, 0.7], (41, 1))
    for first in (START - 1000, START + 1000):
        rows[:, 0] = first + np.arange(41)
        path = write_records(folder / "other.out", rows)
        with pytest.raises(InputError) as caught:
            load_survey(replace(project, accuracy=path))
        assert caught.value.code == "import.accuracy_times"
        assert caught.value.message is not None
        assert caught.value.message.params == {
            "file": str(path), "first": first, "last": first + 40,
            "start": pytest.approx(START), "end": pytest.approx(START + 1999 / 50),
        }  # fmt: skip


def test_named_columns_apply_to_text_files_only(folder: Path) -> None:
    """No format is detected for a table whose columns the user named; LAS files have no columns."""
    table = folder / "L3.txt"
    np.savetxt(table, [[START + 1, 1.0, 2.0, 3.0], [START + 2, 1.0, 2.0, 3.0]], fmt="%.4f")
    assert default_or_detected_reading(table, "points", Reading(), columns=True) == (Reading(), ())
    found = default_or_detected_reading(folder / "L1.laz", "points", Reading(), columns=True)
    assert found == default_or_detected_reading(folder / "L1.laz", "points", Reading())


def test_displayed_clouds_are_the_georeferenced_clouds(project: Project) -> None:
    survey = load_survey(project)
    steps: list[Step | None] = []
    shown = survey.displayed_clouds(
        project, "prior", progress=lambda _share, step=None: steps.append(step)
    )
    assert list(map(str, steps)) == ["Computing the point positions of L1"]
    assert dict(shown) == dict(survey.clouds)
    with pytest.raises(ProjectError, check=lambda e: e.code == "project.not_estimated"):
        survey.displayed_clouds(project, "estimated")


# -- writing --------------------------------------------------------------------------------------


def test_a_table_with_named_columns_is_written_like_a_las_line(
    project: Project, folder: Path, tmp_path: Path
) -> None:
    """The results differ only by the rounding of the two files."""
    times, points = START + np.linspace(2, 12, 300), fan(300)
    table = folder / "table.txt"
    np.savetxt(table, np.column_stack([points[:, 2], times, points[:, :2]]), fmt="%.6f")
    las = write_line(folder / "las.las", times, points)
    lines = (LineSource("table", table, ("Z", " time", "x", "y")), LineSource("las", las))
    both = replace(project, lines=lines)
    written = georeference_project(both, tmp_path / "out", "prior", system="local", ending="las")
    assert [(each.points, each.outside) for each in written] == [(300, 0), (300, 0)]
    one, other = (laspy.read(each.path) for each in written)
    np.testing.assert_allclose(one.xyz, other.xyz, atol=3e-4)
    np.testing.assert_allclose(one.gps_time, other.gps_time, atol=1e-6)


@pytest.mark.parametrize("there", [False, True])
def test_a_failed_export_leaves_no_new_folder(
    project: Project, folder: Path, tmp_path: Path, there: bool
) -> None:
    """A line of another day is refused; a folder that existed before is kept."""
    late = write_line(folder / "late.las", START + 9000 + np.linspace(0, 1, 50))
    lines = (LineSource("late", late),)
    out = tmp_path / "new" / "out"
    if there:
        out.mkdir(parents=True)
    outside = has_code("export.outside_trajectory", line="late_prior", count=50)
    with pytest.raises(InputError, check=outside):
        georeference_project(
            replace(project, lines=lines), out, "prior", system="local", ending="las"
        )
    assert out.exists() == there
