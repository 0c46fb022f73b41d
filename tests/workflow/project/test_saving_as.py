"""Tests of saving a project in another folder, after failed and interrupted saves too."""

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError, ProjectError
from lispac.io.las.las_format import write_points
from lispac.io.project import project_file
from lispac.io.project.project_file import write_project
from lispac.messages import error
from lispac.progress import Progress
from lispac.project import LineSource, Project
from lispac.survey.store.import_lock import lock_folder
from lispac.survey.store.stored_line import StoredLine
from lispac.workflow.importing.line_import import LINES_FOLDER, import_lines, line_folder
from lispac.workflow.project.project_copy import UNFINISHED_MARK, save_project_as
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.error_codes import has_code
from tests.support.few_lines import picked
from tests.support.long_runs import others_long

KILLED_SAVE_SCRIPT = """
import os, signal, sys
from pathlib import Path
from lispac.io.project.project_file import read_project
from lispac.workflow.project import project_copy
from lispac.workflow.project.survey import load_survey

def die(*_, **named):
    os.kill(os.getpid(), signal.SIGKILL)

def copying(fraction, step=""):
    if str(step).startswith("Copying two"):
        die()

project = read_project(Path(sys.argv[1]))
survey = load_survey(project)
if sys.argv[3] == "copying":
    project_copy.save_project_as(project, survey, Path(sys.argv[2]), progress=copying)
else:
    project_copy.write_project = die
    project_copy.save_project_as(project, survey, Path(sys.argv[2]))
"""


@pytest.fixture
def project(calibrated: tuple[Project, Survey], tmp_path: Path) -> Project:
    """A project of two imported lines."""
    source, survey = calibrated
    points, times = survey.scans[survey.lines[0]].take(np.arange(3000))
    lines = []
    for name in ("one", "two"):
        path = tmp_path / f"{name}.laz"
        write_points(path, points, times, np.arange(3000))
        lines.append(LineSource(name, path))
    made = replace(source, folder=tmp_path / "quay", lines=tuple(lines), targets=(), result=None)
    made.folder.mkdir()
    write_project(made)
    import_lines(made)
    return made


def names(folder: Path) -> set[str]:
    """Return the relative paths of everything in a folder."""
    return {str(path.relative_to(folder)) for path in folder.rglob("*")}


@pytest.mark.skipif(sys.platform == "win32", reason="ends itself by a signal")
@pytest.mark.parametrize(
    "when", others_long(["copying", "writing"], lambda when: when == "writing")
)
def test_files_of_a_killed_save_are_replaced(project: Project, tmp_path: Path, when: str) -> None:
    there = tmp_path / "office"
    command = [sys.executable, "-c", KILLED_SAVE_SCRIPT, str(project.folder), str(there), when]
    assert subprocess.run(command, check=False).returncode == -9
    assert not (there / "project.json").exists()
    assert (there / LINES_FOLDER / "one" / UNFINISHED_MARK).exists()
    (there / "minutes.txt").write_text("not ours")
    (there / LINES_FOLDER / "one" / "notes.txt").write_text("not ours either")
    with pytest.raises(ProjectError) as raised:
        save_project_as(project, load_survey(project), there)
    assert raised.value.code == "project_folder.has_files"
    assert (there / LINES_FOLDER / "one" / "notes.txt").read_text() == "not ours either"
    (there / LINES_FOLDER / "one" / "notes.txt").unlink()
    moved, _ = save_project_as(project, load_survey(project), there)
    plain, _ = save_project_as(project, load_survey(project), tmp_path / "plain")
    assert names(moved.folder) - names(plain.folder) == {"minutes.txt"}
    assert names(plain.folder) <= names(moved.folder)
    found = load_survey(open_project(there))
    for scan in found.scans.values():
        assert isinstance(scan, StoredLine)
        scan.require_sound()


def test_a_folder_with_a_save_in_progress_is_refused(project: Project, tmp_path: Path) -> None:
    lines = tmp_path / "office" / LINES_FOLDER
    lines.mkdir(parents=True)
    with lock_folder(lines), pytest.raises(ProjectError) as raised:
        save_project_as(project, load_survey(project), tmp_path / "office")
    assert raised.value.code == "project_folder.being_saved"


def test_complete_stores_are_not_overwritten(project: Project, tmp_path: Path) -> None:
    there, survey = tmp_path / "office", load_survey(project)
    save_project_as(project, survey, there)
    (there / "project.json").unlink()
    before = names(there)
    with pytest.raises(ProjectError) as raised:
        save_project_as(project, survey, there)
    assert raised.value.code == "project_folder.has_files"
    assert names(there) == before


def import_during_copy(project: Project) -> Progress:
    """Return a progress function that imports a line again during its copy, like another window."""
    done: list[str] = []

    def report_progress(_fraction: float, step: object = "") -> None:
        if str(step).startswith("Copying one") and not done:
            done.append(str(step))
            import_lines(project, again=True)

    return report_progress


@pytest.mark.parametrize("meanwhile", [False, True])
def test_a_line_imported_again_meanwhile_is_reported(
    project: Project, tmp_path: Path, meanwhile: bool
) -> None:
    survey = load_survey(project)
    if not meanwhile:
        import_lines(project, again=True)
    with pytest.raises(ProjectError) as refused:
        save_project_as(
            project, survey, tmp_path / "office",
            progress=import_during_copy(project) if meanwhile else lambda fraction, words="": None,
        )  # fmt: skip
    assert refused.value.code == "store.imported_again"
    assert not (tmp_path / "office").exists()


def test_a_damaged_column_is_not_copied(project: Project, tmp_path: Path) -> None:
    survey = load_survey(project)
    (column,) = line_folder(project, project.lines[1]).glob("columns-*/xyz.npy")
    content = bytearray(column.read_bytes())
    content[1000] ^= 0x40
    column.write_bytes(content)
    with pytest.raises(ProjectError) as raised:
        save_project_as(project, survey, tmp_path / "office")
    assert raised.value.code == "import.part_changed"
    assert "xyz.npy" in str(raised.value)
    assert not (tmp_path / "office").exists()


def test_a_failed_save_leaves_its_folder_usable(
    calibrated: tuple[Project, Survey], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """When the disk has room again, the same folder can be chosen."""
    project, survey = calibrated
    real = project_file.atomic_write

    @contextmanager
    def full(path: Path) -> Iterator[Path]:
        if path.name == "project.json":
            raise InputError(error("file.disk_full", file=str(path)))
        with real(path) as temporary:
            yield temporary

    with monkeypatch.context() as patched:
        patched.setattr(project_file, "atomic_write", full)
        with pytest.raises(InputError, check=has_code("file.disk_full")):
            save_project_as(project, survey, tmp_path / "kept")
    assert list(tmp_path.iterdir()) == []
    save_project_as(project, survey, tmp_path / "kept")
    assert open_project(tmp_path / "kept").targets


def test_saving_in_a_file_is_refused(calibrated: tuple[Project, Survey], tmp_path: Path) -> None:
    file = tmp_path / "notes.txt"
    file.write_text("mine")
    with pytest.raises(ProjectError) as raised:
        save_project_as(*calibrated, file)
    assert raised.value.code == "project_folder.is_file"
    assert file.read_text() == "mine"


def test_a_folder_with_a_project_is_not_overwritten(tmp_path: Path) -> None:
    project, survey = picked()
    moved, _ = save_project_as(project, survey, tmp_path / "quay")
    before = (moved.folder / "project.json").read_bytes()
    with pytest.raises(ProjectError) as caught:
        save_project_as(replace(project, targets=()), survey, tmp_path / "quay")
    assert caught.value.code == "project_folder.exists"
    assert str(caught.value).startswith(f"{tmp_path / 'quay'}: ")
    assert (moved.folder / "project.json").read_bytes() == before


def test_a_failed_save_keeps_points_that_were_there_before(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A folder of points without a project may be all that remains of one."""
    project, survey = picked()
    kept = tmp_path / "kept" / "sightings"
    kept.mkdir(parents=True)
    (kept / "theirs.npz").write_bytes(b"points")

    @contextmanager
    def full(path: Path) -> Iterator[Path]:
        raise InputError(error("file.disk_full", file=str(path)))
        yield path

    monkeypatch.setattr(project_file, "atomic_write", full)
    with pytest.raises(InputError, check=has_code("file.disk_full")):
        save_project_as(project, survey, tmp_path / "kept")
    assert (kept / "theirs.npz").read_bytes() == b"points"
