"""Tests of the file that opens a project by a double click, and of the window command."""

import shutil
import sys
from pathlib import Path

import pytest

from lispac.errors import ProjectError
from lispac.installation_paths import window_command
from lispac.io.project.project_file import OPENER_NAME, OPENER_TEXT, read_project, write_project
from lispac.project import Project
from lispac.workflow.importing.input_files import find_project
from tests.support.error_codes import has_code


@pytest.fixture
def saved(demo_project: Project, tmp_path: Path) -> Project:
    """Return a copy of the calibrated survey without an opener file."""
    folder = shutil.copytree(demo_project.folder, tmp_path / "harbour")
    (folder / OPENER_NAME).unlink(missing_ok=True)
    return read_project(folder)


def test_saving_writes_a_file_that_opens_the_project(saved: Project) -> None:
    write_project(saved)
    opener = saved.folder / OPENER_NAME
    assert opener.read_text() == OPENER_TEXT
    assert read_project(opener).folder == saved.folder
    renamed = opener.rename(opener.with_name("quay.lispac"))
    assert read_project(renamed).targets == saved.targets


def test_an_existing_file_of_that_name_is_kept(saved: Project) -> None:
    (saved.folder / OPENER_NAME).write_text("mine")
    write_project(saved)
    assert (saved.folder / OPENER_NAME).read_text() == "mine"


def test_a_dropped_opener_is_recognised_as_a_project(saved: Project, tmp_path: Path) -> None:
    write_project(saved)
    assert (
        find_project([tmp_path / "a.las", saved.folder / OPENER_NAME]) == saved.folder / OPENER_NAME
    )


def test_an_opener_without_a_project_is_refused(tmp_path: Path) -> None:
    (tmp_path / OPENER_NAME).write_text(OPENER_TEXT)
    folder = str(tmp_path / OPENER_NAME)
    with pytest.raises(ProjectError, check=has_code("project.not_found", folder=folder)):
        read_project(tmp_path / OPENER_NAME)


def test_a_project_folder_may_have_the_ending_of_the_opener(saved: Project) -> None:
    folder = saved.folder.rename(saved.folder.with_suffix(".lispac"))
    assert read_project(folder).folder == folder


def test_window_command_of_python_and_of_the_bundle(monkeypatch: pytest.MonkeyPatch) -> None:
    assert window_command() == [sys.executable, "-m", "lispac.gui"]
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    for program, window in (
        ("/opt/lispac/lispac", "/opt/lispac/lispac-gui"),
        ("/c/LISPAC/lispac.exe", "/c/LISPAC/lispac-gui.exe"),
    ):
        monkeypatch.setattr(sys, "executable", program)
        assert window_command() == [window]
