"""Tests of the loading of a survey after an edit: only what depends on the edit is read again."""

import os
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.project import Project, Reading
from lispac.workflow.project import survey as module
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import Survey, load_survey


@pytest.fixture(scope="module")
def copied(demo_project: Project, tmp_path_factory: pytest.TempPathFactory) -> Project:
    folder = tmp_path_factory.mktemp("reloaded") / "copy"
    return open_project(Path(shutil.copytree(demo_project.folder, folder)))


@pytest.fixture
def read_files(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of the files that are read; filled while the test runs."""
    names: list[str] = []

    def noting(function: Callable, name_of: Callable) -> Callable:
        def call(*arguments: object) -> object:
            names.append(name_of(arguments[0]))
            return function(*arguments)

        return call

    for name, name_of in (
        ("local_trajectory", lambda project: project.trajectory.name),
        ("read_line", lambda line: line.path.name),
    ):
        monkeypatch.setattr(module, name, noting(getattr(module, name), name_of))
    return names


def same_values(one: Survey, other: Survey) -> bool:
    """Whether two surveys have the same content, bit by bit."""
    return (
        (one.notes, one.messages, one.heading, one.excluded)
        == (other.notes, other.messages, other.heading, other.excluded)
        and one.lines == other.lines
        and np.array_equal(one.trajectory.position, other.trajectory.position)
        and np.array_equal(one.accuracy.position, other.accuracy.position)
        and all(
            np.array_equal(one.clouds[name].sample, other.clouds[name].sample)
            and one.scans[name].fingerprint == other.scans[name].fingerprint
            for name in one.lines
        )
    )


@pytest.mark.parametrize(
    "edit",
    [
        {"lever_arm": (0.2, -0.1, 2.0)},
        {"boresight_deg": (1.0, -2.0, 3.0)},
        {"position_sigma": (0.5, 0.5, 0.5)},
        {"range_offset": 0.1},
    ],
    ids=lambda edit: next(iter(edit)),
)
def test_a_change_of_the_mounting_or_of_sigmas_reads_no_file(
    copied: Project, read_files: list[str], edit: dict[str, object]
) -> None:
    project = replace(copied, accuracy=None)
    first = load_survey(project)
    read_files.clear()
    edited = project.with_settings(replace(project.settings, **edit))
    reused = load_survey(edited, former=first)
    assert read_files == []
    assert same_values(reused, load_survey(edited))
    assert not same_values(reused, first)


def test_other_origin_or_latency_is_applied(copied: Project, read_files: list[str]) -> None:
    first = load_survey(copied)
    latitude, longitude, height = first.trajectory.frame.origin_deg_m
    for edit in ({"origin_deg_m": (latitude, longitude, height + 1.0)}, {"latency": 0.01}):
        edited = copied.with_settings(replace(copied.settings, **edit))
        assert same_values(load_survey(edited, former=first), load_survey(edited))


def test_an_edit_of_one_line_reads_only_this_line(copied: Project, read_files: list[str]) -> None:
    first = load_survey(copied)
    read_files.clear()
    shifted = replace(copied.lines[1], reading=Reading(time_shift=0.001))
    edited = replace(copied, lines=(copied.lines[0], shifted, *copied.lines[2:]))
    reused = load_survey(edited, former=first)
    assert read_files == [shifted.path.name]
    assert same_values(reused, load_survey(edited))


def test_a_line_that_may_be_georeferenced_is_read_again_with_another_mounting(
    copied: Project, read_files: list[str]
) -> None:
    chosen = replace(copied.lines[0], reading=Reading(format="las"))
    project = replace(copied, lines=(chosen, *copied.lines[1:]))
    first = load_survey(project)
    read_files.clear()
    settings = replace(project.settings, lever_arm=(0.2, -0.1, 2.0))
    load_survey(project.with_settings(settings), former=first)
    assert read_files == [chosen.path.name]


def test_a_file_that_has_changed_is_read_again(copied: Project, read_files: list[str]) -> None:
    first = load_survey(copied)
    read_files.clear()
    path = copied.lines[0].path
    written = path.stat().st_mtime_ns
    shutil.copyfile(copied.lines[1].path, path.with_suffix(".new"))
    path.with_suffix(".new").replace(path)
    os.utime(path, ns=(written, written))
    reused = load_survey(copied, former=first)
    assert read_files == [path.name]
    name = copied.lines[1].name
    assert reused.scans[copied.lines[0].name].fingerprint == reused.scans[name].fingerprint


def test_another_trajectory_needs_all_files(copied: Project, read_files: list[str]) -> None:
    first = load_survey(copied)
    read_files.clear()
    os.utime(copied.trajectory)
    load_survey(copied, former=first)
    assert read_files == [copied.trajectory.name, *(each.path.name for each in copied.lines)]
