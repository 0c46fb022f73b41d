"""Tests of two programs on one project: no accepted change is lost."""

import errno
import multiprocessing
import os
import signal
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest

import lispac
from lispac import locks
from lispac.errors import ProjectChanged, ProjectError
from lispac.io.project import project_lock as locking
from lispac.io.project.project_file import (
    PROJECT_FILE_NAME,
    SIGHTINGS_FOLDER,
    read_project,
    read_unsaved,
    write_project,
    write_unsaved,
)
from lispac.io.project.project_lock import LOCK_NAME, project_lock
from lispac.project import Project
from tests.support.concurrent_commands import (
    SerialRuns,
    commands,
    copy_of,
    pool,
    random_pairs,
    run,
    state,
)
from tests.support.long_runs import LONG


@pytest.fixture
def folder(copy: Project) -> Path:
    """The folder of a project with targets and a result."""
    return copy.folder


@pytest.fixture(scope="module")
def processes() -> Iterator[ProcessPoolExecutor]:
    with pool() as made:
        yield made


def require_serial(
    project: Path, tmp_path: Path, processes: ProcessPoolExecutor, pairs: list[tuple[str, str]]
) -> None:
    """Check that two simultaneous commands have the result of running them in some order."""
    words, serial = commands(), SerialRuns(project, tmp_path)
    for first, second in pairs:
        place = copy_of(project, tmp_path / "both")
        runs = [processes.submit(run, words[name], place) for name in (first, second)]
        status = [each.result()[0] for each in runs]
        in_order = serial.after(words[first], words[second])
        reverse_status, reverse = serial.after(words[second], words[first])
        orders = [in_order, (reverse_status[::-1], reverse)]
        assert (status, state(place)) in orders, f"{first} and {second}: a change is lost"
        assert not (place / LOCK_NAME).exists()
        read_project(place)


def test_simultaneous_commands_lose_no_change(
    folder: Path, tmp_path: Path, processes: ProcessPoolExecutor
) -> None:
    pairs = [("vessel", "site"), ("pick T1", "estimate")]
    require_serial(folder, tmp_path, processes, pairs)


@pytest.mark.long
def test_random_pairs_of_commands_lose_no_change(
    folder: Path, tmp_path: Path, processes: ProcessPoolExecutor
) -> None:
    require_serial(folder, tmp_path, processes, random_pairs(200))


def test_a_project_written_meanwhile_is_not_overwritten(folder: Path) -> None:
    first, second = lispac.open(folder), lispac.open(folder)
    second.identity(vessel="Other")
    second.save()
    first.identity(site="Mine")
    with pytest.raises(ProjectChanged):
        first.save()
    saved = read_project(folder)
    assert (saved.identity.vessel, saved.identity.site) == ("Other", "")
    second.identity(site="Again")
    second.save()
    assert read_project(folder).identity.site == "Again", "its own save is no news"


def test_a_project_created_meanwhile_is_not_overwritten(folder: Path) -> None:
    with pytest.raises(ProjectError, check=lambda e: e.code == "project.exists"):
        write_project(read_project(folder), expected="")


def test_points_of_unsaved_work_are_kept_when_another_program_saves(folder: Path) -> None:
    project = read_project(folder)
    target = project.targets[0]
    fewer = replace(target, name="Fewer", sightings=target.sightings[:-1])
    write_unsaved(project.with_target(fewer))
    write_project(project)
    unsaved = read_unsaved(folder)
    assert unsaved is not None
    assert unsaved.target("Fewer").sightings[0].line == target.sightings[0].line


@LONG
def test_a_reader_gets_a_consistent_state(folder: Path) -> None:
    """Each save removes the points to which the previous state refers."""
    project = read_project(folder)
    targets = project.targets
    states = [
        replace(project, targets=tuple(replace(t, sightings=t.sightings[k:]) for t in targets))
        for k in (0, 1)
    ]
    counts = [sum(len(t.sightings) for t in each.targets) for each in states]
    ended = threading.Event()

    def save() -> None:
        for k in range(8):
            write_project(states[k % 2])
        ended.set()

    writer = threading.Thread(target=save)
    writer.start()
    while not ended.is_set():
        found = read_project(folder)
        assert sum(len(t.sightings) for t in found.targets) in counts
    writer.join()


def test_a_project_locked_by_another_program_is_waited_for_or_refused(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    is_locked, end = threading.Event(), threading.Event()

    def hold() -> None:
        with project_lock(folder):
            is_locked.set()
            end.wait(60)

    other = threading.Thread(target=hold)
    other.start()
    is_locked.wait(60)
    before = (folder / PROJECT_FILE_NAME).read_bytes()
    with pytest.raises(ProjectError) as refused, project_lock(folder, wait=0.1):
        pass
    assert refused.value.code == "project.locked"
    monkeypatch.setattr(locking, "SAVE_WAIT_S", 0.1)
    calls: list[str] = []
    threading.Timer(0.3, end.set).start()
    with project_lock(folder, wait=60.0, waiting=lambda: calls.append("waits")):
        assert calls == ["waits"]
    other.join()
    assert (folder / PROJECT_FILE_NAME).read_bytes() == before
    assert not (folder / LOCK_NAME).exists()


def test_a_lock_is_reentrant(folder: Path) -> None:
    with project_lock(folder), project_lock(folder):
        write_project(read_project(folder))
        assert (folder / LOCK_NAME).exists()
    assert not (folder / LOCK_NAME).exists()


def hold_lock(folder: Path, is_locked: "multiprocessing.synchronize.Event") -> None:
    with project_lock(folder):
        is_locked.set()
        time.sleep(600)


@pytest.mark.skipif(sys.platform == "win32", reason="signals of Unix")
def test_the_lock_of_a_killed_program_is_released(folder: Path) -> None:
    context = multiprocessing.get_context("spawn")
    is_locked = context.Event()
    holder = context.Process(target=hold_lock, args=(folder, is_locked))
    holder.start()
    assert is_locked.wait(60)
    with pytest.raises(ProjectError), project_lock(folder, wait=0.0):
        pass
    os.kill(holder.pid, signal.SIGKILL)
    holder.join()
    assert (folder / LOCK_NAME).exists()
    with project_lock(folder, wait=0.0):
        pass
    assert not (folder / LOCK_NAME).exists(), "the next run removes what is left"


def test_changes_are_detected_on_disks_without_locks(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def unsupported(handle: int) -> None:
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr(locks, "_lock", unsupported)
    project = read_project(folder)
    write_project(project.with_identity(project.identity.changed(vessel="Other")))
    with pytest.raises(ProjectChanged):
        write_project(project, expected=project.file_digest)


@pytest.mark.skipif(sys.platform == "win32", reason="links need a right there")
def test_a_lock_does_not_follow_a_link(folder: Path, tmp_path: Path) -> None:
    (folder / LOCK_NAME).symlink_to(tmp_path / "elsewhere")
    with pytest.raises(lispac.LispacError):
        write_project(read_project(folder))
    assert not (tmp_path / "elsewhere").exists()


@LONG
def test_a_read_only_folder_is_refused_before_the_computation(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    opened = os.open

    def read_only(path: str, flags: int, *more: int) -> int:
        if Path(path).name == LOCK_NAME:
            raise PermissionError(errno.EACCES, "Permission denied", str(path))
        return opened(path, flags, *more)

    monkeypatch.setattr(os, "open", read_only)
    assert run(("estimate",), folder)[0] == 1
    assert not list(folder.glob(f"{SIGHTINGS_FOLDER}/.*"))
