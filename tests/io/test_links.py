"""Tests that nothing is written or deleted through links inside a project folder."""

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError, ProjectError
from lispac.io.las.las_format import write_points
from lispac.io.project.project_file import SIGHTINGS_FOLDER, read_project, write_project
from lispac.io.project.project_lock import LOCK_NAME
from lispac.project import LineSource, Project
from lispac.survey.store.layout import is_link
from lispac.workflow.importing.line_import import LINES_FOLDER, import_lines, line_folder
from lispac.workflow.planning.demo import MARKER_FILE, make_demo
from lispac.workflow.project.project_copy import UNFINISHED_MARK, save_project_as
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.error_codes import has_code


@pytest.fixture
def project(calibrated: tuple[Project, Survey], tmp_path: Path) -> Project:
    """Return a saved project with one line of few points, without targets."""
    source, survey = calibrated
    points, times = survey.scans[survey.lines[0]].take(np.arange(3000))
    path = tmp_path / "one.laz"
    write_points(path, points, times, np.arange(3000))
    made = replace(
        source, folder=tmp_path / "project", lines=(LineSource("one", path),),
        targets=(), result=None, cross_checks=None, validation=(), data_messages=(),
    )  # fmt: skip
    made.folder.mkdir()
    write_project(made)
    return made


def contents(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file()
    }


def linked(folder: Path, elsewhere: Path) -> dict[str, bytes]:
    """Replace ``folder`` by a link to a folder with files of another owner."""
    elsewhere.mkdir()
    for name in ("T1-0123456789abcdef.npz", "other.npz", "store.json", "columns-1"):
        (elsewhere / name).write_bytes(b"not of this project")
    folder.parent.mkdir(exist_ok=True)
    folder.symlink_to(elsewhere, target_is_directory=True)
    return contents(elsewhere)


def with_target(project: Project, calibrated: tuple[Project, Survey]) -> Project:
    target = calibrated[0].target("T1")
    sightings = tuple(replace(s, line="one") for s in target.sightings[:1])
    return replace(project, targets=(replace(target, sightings=sightings),))


def test_a_linked_folder_of_sightings_is_not_changed(
    project: Project, calibrated: tuple[Project, Survey], tmp_path: Path
) -> None:
    before = linked(project.folder / SIGHTINGS_FOLDER, tmp_path / "elsewhere")
    write_project(project)  # there are no sightings to write, and nothing is deleted
    assert contents(tmp_path / "elsewhere") == before
    saved = (project.folder / "project.json").read_bytes()
    with pytest.raises(ProjectError, check=has_code("store.link")):
        write_project(with_target(project, calibrated))
    assert contents(tmp_path / "elsewhere") == before
    assert (project.folder / "project.json").read_bytes() == saved


def test_only_sightings_of_the_project_are_removed(
    project: Project, calibrated: tuple[Project, Survey], tmp_path: Path
) -> None:
    write_project(with_target(project, calibrated))
    folder = project.folder / SIGHTINGS_FOLDER
    (own,) = folder.glob("T1-*.npz")
    outside = tmp_path / "outside.npz"
    outside.write_bytes(own.read_bytes())
    (folder / own.name.replace("T1", "T2")).symlink_to(outside)
    (folder / "mine.npz").write_bytes(own.read_bytes())
    (folder / "T1-0123456789abcdef.npz").write_bytes(own.read_bytes())
    write_project(project)
    assert not own.exists()
    assert {path.name for path in folder.iterdir()} == {
        own.name.replace("T1", "T2"), "mine.npz", "T1-0123456789abcdef.npz",
    }  # fmt: skip
    assert outside.exists()
    assert read_project(project.folder).targets == ()


@pytest.mark.parametrize("place", ["line", "lines"])
def test_no_line_is_imported_through_a_link(project: Project, tmp_path: Path, place: str) -> None:
    store = line_folder(project, project.lines[0])
    folder = store if place == "line" else project.folder / LINES_FOLDER
    before = linked(folder, tmp_path / "elsewhere")
    with pytest.raises(ProjectError, check=has_code("store.link")):
        import_lines(project)
    assert contents(tmp_path / "elsewhere") == before
    assert is_link(folder)


def test_a_simulation_writes_nothing_through_a_link(tmp_path: Path) -> None:
    folder, elsewhere = tmp_path / "demo", tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / MARKER_FILE).write_text("an earlier demo, moved away")
    folder.mkdir()
    (folder / "raw").symlink_to(elsewhere, target_is_directory=True)
    before = contents(elsewhere)
    with pytest.raises(ProjectError, check=has_code("store.link")):
        make_demo(folder, points_per_second=1000.0)
    assert contents(elsewhere) == before


def test_reading_writes_nothing_through_a_link(project: Project, tmp_path: Path) -> None:
    import_lines(project)
    store = line_folder(project, project.lines[0])
    elsewhere = tmp_path / "elsewhere"
    store.rename(elsewhere)
    store.symlink_to(elsewhere, target_is_directory=True)
    for path in (elsewhere / "columns-1").iterdir():
        os.utime(path, (1e9, 1e9))
    before = contents(elsewhere)
    load_survey(project)
    assert contents(elsewhere) == before


def test_an_import_removes_only_files_that_imports_write(project: Project) -> None:
    import_lines(project)
    store = line_folder(project, project.lines[0])
    for name in ("columns-backup", "columns-7", "spool"):
        (store / name).mkdir(exist_ok=True)
        (store / name / "mine.txt").write_text("mine")
    import_lines(project, again=True)
    remaining = sorted(path.parent.name for path in store.rglob("mine.txt"))
    assert remaining == ["columns-7", "columns-backup", "spool"]


@pytest.mark.parametrize("kind", ["link", "folder"])
def test_a_lock_that_is_a_link_or_folder_is_refused(
    project: Project, tmp_path: Path, kind: str
) -> None:
    lock = project.folder / LOCK_NAME
    if kind == "link":
        lock.symlink_to(tmp_path / "elsewhere")
    else:
        lock.mkdir()
    with pytest.raises(InputError, check=has_code("lock.not_a_file")):
        write_project(project)
    assert not (tmp_path / "elsewhere").exists()


def test_a_manifest_is_not_written_through_a_link(project: Project, tmp_path: Path) -> None:
    import_lines(project)
    store = line_folder(project, project.lines[0])
    linked_file = tmp_path / "victim"
    linked_file.write_text("precious")
    (store / "store.json.part").symlink_to(linked_file)
    for path in (store / "columns-1").iterdir():
        os.utime(path, (1e9, 1e9))
    load_survey(project)
    import_lines(project, again=True)
    assert linked_file.read_text() == "precious"
    assert not linked_file.is_symlink()


def test_no_columns_are_written_or_removed_through_a_link(project: Project, tmp_path: Path) -> None:
    store = line_folder(project, project.lines[0])
    elsewhere = tmp_path / "elsewhere"
    store.mkdir(parents=True)
    before = linked(store / "columns-1", elsewhere)
    (elsewhere / "xyz.npy").write_bytes(b"mine")
    with pytest.raises(ProjectError, check=has_code("store.link")):
        import_lines(project)
    assert contents(elsewhere) == before | {"xyz.npy": b"mine"}


def test_an_import_keeps_files_of_the_user_among_columns(project: Project) -> None:
    folder = line_folder(project, project.lines[0]) / "columns-1"
    folder.mkdir(parents=True)
    for name in ("mine.npy", "notes.txt"):
        (folder / name).write_bytes(b"mine")
    import_lines(project)
    assert contents(folder) == {"mine.npy": b"mine", "notes.txt": b"mine"}
    assert len(load_survey(project).scans["one"]) > 0


def test_a_file_with_the_name_of_a_columns_folder_is_kept(project: Project) -> None:
    store = line_folder(project, project.lines[0])
    store.mkdir(parents=True)
    (store / "columns-1").write_bytes(b"mine")
    import_lines(project)
    assert (store / "columns-1").read_bytes() == b"mine"


def test_a_failed_save_removes_only_what_the_program_wrote(
    project: Project, tmp_path: Path
) -> None:
    store = tmp_path / "copy" / LINES_FOLDER / "old"
    for name in ("columns-backup", "columns-3"):
        (store / name).mkdir(parents=True)
        (store / name / "mine.npy").write_bytes(b"mine")
    (store / "columns-3" / "xyz.npy").write_bytes(b"of a save that was killed")
    (store / UNFINISHED_MARK).touch()
    import_lines(project)
    save_project_as(project, load_survey(project), tmp_path / "copy")
    assert contents(store) == {"columns-backup/mine.npy": b"mine", "columns-3/mine.npy": b"mine"}


def test_no_line_is_copied_through_a_link(project: Project, tmp_path: Path) -> None:
    import_lines(project)
    survey = load_survey(project)
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "copy" / LINES_FOLDER).mkdir(parents=True)
    there = tmp_path / "copy" / LINES_FOLDER / line_folder(project, project.lines[0]).name
    there.symlink_to(tmp_path / "elsewhere", target_is_directory=True)
    with pytest.raises(ProjectError, check=has_code("store.link")):
        save_project_as(project, survey, tmp_path / "copy")
    assert not contents(tmp_path / "elsewhere")
    assert not (tmp_path / "copy" / "project.json").exists()


def test_a_new_demo_keeps_the_files_of_the_user(tmp_path: Path) -> None:
    folder = tmp_path / "demo"
    make_demo(folder, points_per_second=1000.0)
    files_of_user = {
        f"{place}/{name}": b"mine"
        for place in ("raw", "truth", "sightings")
        for name in ("mine.laz", "mine.npz", "notes/mine.txt")
    }
    for name, content in files_of_user.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    before = contents(folder)
    make_demo(folder, points_per_second=1000.0)
    after = contents(folder)
    assert {name: after.get(name) for name in files_of_user} == files_of_user
    assert after.keys() == before.keys()
    assert read_project(folder).lines
