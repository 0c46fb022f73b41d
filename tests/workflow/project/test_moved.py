"""Tests of finding the files of a project that was moved to another disk."""

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import lispac
from lispac.cli.main import main
from lispac.errors import InputError
from lispac.io.project.project_file import read_project, write_unsaved
from lispac.message_texts import message_text
from lispac.messages import note
from lispac.project import Project
from lispac.workflow.planning import demo
from lispac.workflow.project import moved_files
from lispac.workflow.project.moved_files import (
    missing_files,
    with_files_beside,
    with_files_in,
    with_files_of,
)
from lispac.workflow.project.projects import (
    create_project,
    open_project,
    open_project_with_notes,
    read_unsaved_project,
)
from lispac.workflow.project.survey import load_survey
from tests.support.command_errors import command_error


@pytest.fixture(scope="module")
def survey_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with files in ``survey`` and their project in ``projects/quay``."""
    root = tmp_path_factory.mktemp("made")
    simulated = demo.make_demo(root / "simulated", points_per_second=4000.0)
    for sub, paths in (
        ("nav", (simulated.trajectory, simulated.accuracy)),
        ("lines", [line.path for line in simulated.lines]),
    ):
        (root / "disk" / "survey" / sub).mkdir(parents=True)
        for path in paths:
            shutil.copy(path, root / "disk" / "survey" / sub / path.name)
    nav, lines = (root / "disk" / "survey" / sub for sub in ("nav", "lines"))
    assert simulated.accuracy is not None
    create_project(
        root / "disk" / "projects" / "quay",
        trajectory=nav / simulated.trajectory.name,
        accuracy=nav / simulated.accuracy.name,
        lines=[replace(line, path=lines / line.path.name) for line in simulated.lines],
        settings=simulated.settings,
        trajectory_reading=simulated.trajectory_reading,
        accuracy_reading=simulated.accuracy_reading,
    )
    return root / "disk"


@pytest.fixture
def disk(survey_folder: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(survey_folder, tmp_path / "disk"))


def files(project: Project) -> set[Path]:
    assert project.accuracy is not None
    return {project.trajectory, project.accuracy, *(line.path for line in project.lines)}


def test_no_file_is_missing_after_moving_project_and_files(disk: Path) -> None:
    moved = disk.rename(disk.with_name("other"))
    project, notes = open_project_with_notes(moved / "projects" / "quay")
    assert (missing_files(project), notes) == ((), ())


@pytest.mark.parametrize("place", [".", "raw", "..", "../survey"])
def test_files_in_or_beside_the_project_folder_are_found(disk: Path, place: str) -> None:
    """The files are in folders of the same names, or directly in the folder."""
    home = disk / "projects" / "quay"
    other = home / "survey" if place == "raw" else home / place
    if place == "raw":
        shutil.move(disk / "survey", other)
    else:
        other.mkdir(exist_ok=True)
        for path in [*(disk / "survey").rglob("*.*")]:
            shutil.move(path, other / path.name)
        shutil.rmtree(disk / "survey")
    if place == "../survey":
        assert missing_files(open_project(home))  # not searched by default
        project = with_files_in(open_project(home), home.parent)
    else:
        project, notes = open_project_with_notes(home)
        assert len(notes) == len(files(project))
        assert {each.code for each in notes} == {"project_files.moved"}
    assert missing_files(project) == ()
    assert {path.parent.resolve() for path in files(project)} <= {
        other.resolve(), other.resolve() / "nav", other.resolve() / "lines",
    }  # fmt: skip
    assert len(load_survey(project).lines) == len(project.lines)


def test_files_are_found_below_a_given_folder(disk: Path, tmp_path: Path) -> None:
    project = read_project(disk / "projects" / "quay")
    (tmp_path / "usb" / "2026").mkdir(parents=True)
    shutil.move(disk / "survey", tmp_path / "usb" / "2026" / "harbour")
    assert set(missing_files(project)) == files(project)
    found = with_files_in(project, tmp_path / "usb")
    assert missing_files(found) == ()
    assert with_files_in(found, tmp_path) is found
    assert files(with_files_of(project, found)) == files(found)


def test_ambiguous_files_are_not_used(disk: Path, tmp_path: Path) -> None:
    project = read_project(disk / "projects" / "quay")
    for day in ("monday", "tuesday"):
        shutil.copytree(disk / "survey" / "lines", tmp_path / "usb" / day)
    shutil.copytree(disk / "survey" / "nav", tmp_path / "usb" / "day")
    shutil.rmtree(disk / "survey")
    found = with_files_in(project, tmp_path / "usb")
    assert set(missing_files(found)) == {line.path for line in project.lines}
    again = with_files_in(found, tmp_path / "usb" / "tuesday")
    assert missing_files(again) == ()
    assert {line.path.parent.name for line in again.lines} == {"tuesday"}


def test_a_folder_without_the_files_is_refused(disk: Path, tmp_path: Path) -> None:
    project = read_project(disk / "projects" / "quay")
    shutil.rmtree(disk / "survey")
    (tmp_path / "empty").mkdir()
    with pytest.raises(InputError) as raised:
        with_files_in(project, tmp_path / "empty")
    assert raised.value.code == "project_files.none_of_many_found"
    with pytest.raises(InputError) as raised:
        load_survey(project)
    assert raised.value.code == "project_files.many_missing"


def test_files_of_unsaved_work_are_found(disk: Path) -> None:
    home = disk / "projects" / "quay"
    project = read_project(home)
    write_unsaved(replace(project, settings=replace(project.settings, subsample=0.2)))
    shutil.move(disk / "survey", home / "survey")
    found = read_unsaved_project(home)
    assert found is not None
    assert missing_files(found.project) == ()
    assert with_files_beside(found.project) == (found.project, ())


def test_files_are_located_by_command_and_script(
    disk: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    home, usb = disk / "projects" / "quay", tmp_path / "usb"
    shutil.move(disk / "survey", usb / "quay")
    assert command_error("warnings", home).code == "project_files.many_missing"
    assert missing_files(lispac.open(home, files=usb).project) == ()
    assert command_error("locate", home, usb / "nowhere").code == "cli.no_folder"
    assert command_error("locate", home, usb / "quay" / "nav").code == "cli.files_not_found"
    moved = message_text(note("project_files.moved", file="|", folder="|")).split("|")[1]
    assert capsys.readouterr().out.count(moved) == 2
    assert main(["locate", str(home), str(usb)]) == 0
    capsys.readouterr()
    assert main(["locate", str(home), str(usb)]) == 0
    (answer,) = capsys.readouterr().out.splitlines()
    assert str(usb) not in answer, "no file is missing"
    assert np.isfinite(load_survey(open_project(home)).trajectory.time).all()


def test_an_older_state_of_a_project_gets_the_found_files(disk: Path) -> None:
    """After an undo the paths of the older state are obsolete."""
    opened = read_project(disk / "projects" / "quay")
    assert with_files_of(opened, opened) is opened
    bare = replace(opened, accuracy=None)
    shutil.move(disk / "survey", disk / "elsewhere")
    found = with_files_in(bare, disk / "elsewhere")
    assert missing_files(found) == ()
    again = with_files_of(bare, found)
    assert (again.trajectory, again.lines) == (found.trajectory, found.lines)
    assert again.accuracy is None
    fewer = replace(found, lines=found.lines[1:])
    assert missing_files(with_files_of(bare, fewer)) == (bare.lines[0].path,)


def test_the_search_for_files_is_limited(
    disk: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each file is in a folder of another name and found by its own name, up to the limit."""
    opened = read_project(disk / "projects" / "quay")
    usb = tmp_path / "usb"
    for k, path in enumerate(files(opened)):
        (usb / f"{k}").mkdir(parents=True)
        shutil.move(path, usb / f"{k}" / path.name)
    assert missing_files(with_files_in(opened, usb)) == ()
    monkeypatch.setattr(
        moved_files, "MAX_SEARCHED_FILES", len(files(opened)) + 1
    )  # folders, two files
    assert len(missing_files(with_files_in(opened, usb))) == len(files(opened)) - 2
