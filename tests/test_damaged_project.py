"""A project file that cannot be read: said in words, with what a library said in the details."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.errors import ProjectError
from lispac.io.project_file import (
    FILE_NAME,
    SIGHTINGS,
    keep_unsaved,
    read_project,
    read_unsaved,
    write_project,
)
from lispac.reverse_translation.catalogue import catalogue_of
from lispac.reverse_translation.translation import Translator
from tests.report_sample import sample_project

Damage = Callable[[dict[str, Any]], object]
JARGON = ("Error", "delimiter", "object", "NoneType", "subscript", "convert", "cattrs", "codec")


def refused(folder: Path) -> ProjectError:
    with pytest.raises(ProjectError) as caught:
        read_project(folder)
    said = str(caught.value)
    assert said.startswith(f"{folder / FILE_NAME}: the project file is damaged (")
    assert said.endswith("); restore it from a copy.")
    assert not [word for word in JARGON if word in said]
    assert caught.value.__cause__ is not None  # for the details
    french = Translator(catalogue_of("fr"), spoken_numbers=True)
    assert "est endommagé" in french.cell(said)
    assert not french.unknown
    return caught.value


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_project(sample_project(tmp_path / "p"))
    return tmp_path / "p"


@pytest.mark.parametrize(
    ("damage", "reason"),
    [
        (lambda content: content.pop("lines"), "lines is missing in it"),
        (lambda content: content["settings"].update(lever_arm="x"), "its settings cannot be read"),
        (lambda content: content["settings"].update(colour=3), "colour is not known"),
        (lambda content: content.update(lines=5), "something in it is of the wrong kind"),
        (lambda content: content["targets"][0].update(role="ghost"), "has the role 'ghost'"),
        (lambda content: content["targets"][0].update(seed=["a", 1, 2]), "not a number"),
        (lambda content: content["targets"][0].update(shape="cube"), "has the shape 'cube'"),
        (lambda content: content["targets"][0].update(threshold=-1), "threshold or radius of T1"),
        (lambda content: content["targets"][0].update(radius=0), "threshold or radius of T1"),
        (lambda content: content["result"]["model"].update(pos_errors="brownian"),
         "its adjustment result cannot be read"),
        (lambda content: content["lines"][0].update(name="L9"),
         "T1 is on a line L1 that is not listed"),
        (lambda content: content.update(schema_version="x"), "of the wrong kind"),
    ],
)  # fmt: skip
def test_a_value_that_does_not_fit(folder: Path, damage: Damage, reason: str) -> None:
    content = json.loads((folder / FILE_NAME).read_text())
    damage(content)
    (folder / FILE_NAME).write_text(json.dumps(content))
    assert reason in str(refused(folder))


def test_a_file_cut_short(folder: Path) -> None:
    text = (folder / FILE_NAME).read_text()
    (folder / FILE_NAME).write_text(text[: len(text) // 2])
    line = text[: len(text) // 2].count("\n") + 1
    said = str(refused(folder))
    assert f"it cannot be read from line {line} on" in said or f"line {line - 1} on" in said


def test_bytes_that_are_no_text(folder: Path) -> None:
    (folder / FILE_NAME).write_bytes(b"\xff\xfe\x00\xd8" * 10)
    assert "it is not text" in str(refused(folder))


def test_a_drive_that_is_lost(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def lost(path: Path) -> bytes:
        raise OSError(5, "Input/output error", str(path))

    monkeypatch.setattr(Path, "read_bytes", lost)
    with pytest.raises(ProjectError, match="Input/output error"):
        read_project(folder)


@pytest.mark.parametrize(
    ("numbers", "held"),
    [
        (np.array([-1, 4]), "it holds int64 of shape (2,)"),
        (np.array([[1, 4]]), "it holds int64 of shape (1, 2)"),
        (np.array([1.0, 4.0]), "it holds float64 of shape (2,)"),
    ],
)
def test_points_that_are_no_numbers_of_points(folder: Path, numbers: np.ndarray, held: str) -> None:
    (path,) = (folder / SIGHTINGS).glob("T1-*.npz")
    with np.load(path) as arrays:
        kept = dict(arrays)
    np.savez(path, **(kept | {"line1": numbers}))
    with pytest.raises(ProjectError) as told:
        read_project(folder)
    said = str(told.value)
    assert said.startswith(f"{path}: the points of target T1 are damaged (")
    assert said.endswith(
        f"{held}); restore the file from a copy of the project, or make the project again."
    )


def test_what_is_kept_against_a_crash_and_says_the_same_is_nothing(folder: Path) -> None:
    project = read_project(folder)
    assert read_unsaved(folder) is None
    keep_unsaved(project)
    assert read_unsaved(folder) is None
    keep_unsaved(replace(project, targets=project.targets[:1]))
    unsaved = read_unsaved(folder)
    assert unsaved is not None
    assert [target.name for target in unsaved.targets] == ["T1"]
