"""Tests of project files that cannot be read: plain messages without the words of libraries."""

import errno
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.errors import ProjectError
from lispac.io.project.project_file import (
    PROJECT_FILE_NAME,
    SIGHTINGS_FOLDER,
    read_project,
    read_unsaved,
    write_project,
    write_unsaved,
)
from lispac.messages import Message, error, note
from lispac.value_conversion import encode_value
from tests.support.error_codes import has_code
from tests.support.report_sample import sample_project

Damage = Callable[[dict[str, Any]], object]
JARGON = ("Error", "delimiter", "object", "NoneType", "subscript", "convert", "cattrs", "codec")


def opening_error(folder: Path) -> ProjectError:
    with pytest.raises(ProjectError) as caught:
        read_project(folder)
    text = str(caught.value)
    assert caught.value.code == "project.damaged"
    assert text.startswith(f"{folder / PROJECT_FILE_NAME}: ")
    assert not [word for word in JARGON if word in text]
    assert caught.value.__cause__ is not None  # shown in the details
    return caught.value


def reason_of(refusal: ProjectError) -> Message:
    """The reason that the error gives for the damage of the content."""
    return refusal.message.params["reason"]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_project(sample_project(tmp_path / "p"))
    return tmp_path / "p"


@pytest.mark.parametrize(
    ("damage", "reason"),
    [
        (lambda content: content.pop("lines"), error("content.missing_field", field="lines")),
        (lambda content: content["settings"].update(lever_arm="x"),
         error("content.invalid_part", part="Settings", reason=error("content.not_list"))),
        (lambda content: content["settings"].update(colour=3),
         error("content.unknown_fields", part="Settings", names=["colour"])),
        (lambda content: content.update(lines=5),
         error("content.invalid_part", part="list", reason=error("content.not_list"))),
        (lambda content: content.update(targets=5), error("content.wrong_type")),
        *(
            (lambda content, place=place: place(content).update(colour=3),
             error("content.unknown_fields", part="list", names=["colour"]))
            for place in (
                lambda content: content["lines"][0],
                lambda content: content["targets"][0],
                lambda content: content["targets"][0]["sightings"][0],
            )
        ),
        (lambda content: content["targets"][0].update(role="ghost"),
         error("content.unknown_role", target="T1", role="ghost")),
        (lambda content: content["targets"][0].update(seed=["a", 1, 2]),
         error("content.invalid_part", part="list", reason=error("content.not_number"))),
        (lambda content: content["targets"][0].update(shape="cube"),
         error("content.unknown_shape", target="T1", shape="cube")),
        (lambda content: content["targets"][0].update(threshold=-1),
         error("content.invalid_search", target="T1")),
        (lambda content: content["targets"][0].update(radius=0),
         error("content.invalid_search", target="T1")),
        (lambda content: content["result"]["model"].update(pos_errors="brownian"),
         error("content.wrong_form", part="AdjustmentResult")),
        (lambda content: content["lines"][0].update(name="L9"),
         error("content.unknown_line", target="T1", line="L1")),
        (
            lambda content: content.update(schema_version="x"),
            error("content.invalid_version", version="'x'"),
        ),
        (
            lambda content: content.update(schema_version=-5),
            error("content.invalid_version", version="-5"),
        ),
    ],
)  # fmt: skip
def test_a_wrong_value_is_refused_with_the_reason(
    folder: Path, damage: Damage, reason: Message
) -> None:
    content = json.loads((folder / PROJECT_FILE_NAME).read_text())
    damage(content)
    (folder / PROJECT_FILE_NAME).write_text(json.dumps(content))
    assert reason_of(opening_error(folder)) == reason


def test_a_file_that_is_cut_short_is_refused(folder: Path) -> None:
    text = (folder / PROJECT_FILE_NAME).read_text()
    (folder / PROJECT_FILE_NAME).write_text(text[: len(text) // 2])
    line = text[: len(text) // 2].count("\n") + 1
    reason = reason_of(opening_error(folder))
    assert reason.code == "content.not_json"
    assert reason.params["line"] in (line - 1, line)


def test_a_file_that_is_not_text_is_refused(folder: Path) -> None:
    (folder / PROJECT_FILE_NAME).write_bytes(b"\xff\xfe\x00\xd8" * 10)
    assert reason_of(opening_error(folder)) == error("content.not_utf8")


def test_a_read_error_of_the_drive_is_reported(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def raise_read_error(path: Path) -> bytes:
        raise OSError(errno.EIO, "Input/output error", str(path))

    monkeypatch.setattr(Path, "read_bytes", raise_read_error)
    unreadable = has_code("project.unreadable", reason=note("system.input_output"))
    with pytest.raises(ProjectError, check=unreadable):
        read_project(folder)


@pytest.mark.parametrize(
    ("numbers", "code"),
    [
        (np.array([-1, 4]), "content.not_indices"),
        (np.array([[1, 4]]), "content.not_indices"),
        (np.array([1.0, 4.0]), "content.not_indices"),
        (np.array([1]), "content.too_few_points"),
        (np.arange(10_000), "content.too_many_bytes"),
    ],
)
def test_invalid_point_numbers_are_refused(folder: Path, numbers: np.ndarray, code: str) -> None:
    (path,) = (folder / SIGHTINGS_FOLDER).glob("T1-*.npz")
    with np.load(path) as arrays:
        kept = dict(arrays)
    np.savez(path, **(kept | {"line1": numbers}))
    with pytest.raises(ProjectError) as caught:
        read_project(folder)
    assert caught.value.code == "project.points_damaged"
    params = caught.value.message.params
    assert (params["file"], params["target"]) == (str(path), "T1")
    assert params["reason"].code == code


def test_a_recovery_file_without_changes_is_ignored(folder: Path) -> None:
    project = read_project(folder)
    assert read_unsaved(folder) is None
    write_unsaved(project)
    assert read_unsaved(folder) is None
    write_unsaved(replace(project, targets=project.targets[:1]))
    unsaved = read_unsaved(folder)
    assert unsaved is not None
    assert [target.name for target in unsaved.targets] == ["T1"]


def test_values_that_could_not_be_read_again_are_not_written(folder: Path) -> None:
    project = read_project(folder)
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    first = project.targets[0]
    for wrong in (
        replace(first, threshold=1e31), replace(first, radius=1e31),
        replace(first, threshold=1e-320),
        replace(first, seed=(1e31, 0.0, 0.0)),
        replace(first, sightings=(replace(first.sightings[0], rms=float("nan")),)),
    ):  # fmt: skip
        for write in (write_project, write_unsaved):
            with pytest.raises(ProjectError) as caught:
                write(replace(project, targets=(wrong,)))
            assert caught.value.code == "project.cannot_be_read_again"
    twice = replace(project, targets=(first, replace(project.targets[1], name=first.name)))
    with pytest.raises(ProjectError) as caught:
        write_project(twice)
    assert caught.value.code == "project.cannot_be_read_again"
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before


@pytest.mark.parametrize("kind", ["targets", "lines"])
def test_duplicate_names_are_refused(folder: Path, kind: str) -> None:
    content = json.loads((folder / PROJECT_FILE_NAME).read_text())
    content[kind][1]["name"] = content[kind][0]["name"]
    (folder / PROJECT_FILE_NAME).write_text(json.dumps(content))
    assert reason_of(opening_error(folder)).code == f"content.duplicate_{kind[:-1]}"


@pytest.mark.parametrize(
    ("place", "values"),
    [
        ("not_compared", [{"V1": 3}, ["V1"], "V1"]),
        ("lines/0/columns", [[1, {}], "time"]),
        ("targets/0/sightings/0/one_in", [0, -1, "7", 1e300, True]),
        ("targets/0/sightings/0/by_hand", [1, "yes"]),
        ("targets/0/sightings/0/rms", [-1.0, float("inf"), 1e30]),
        ("targets/0/radius", [1e30, 1e-320]),
        ("targets/0/threshold", [1e30, 1e-320]),
        ("truth_deg", [[1e30, 0.0, 0.0], [float("inf"), 0.0, 0.0]]),
        ("data_messages", [[{"code": "store.locked", "level": "warning", "params": [1]}], "x"]),
        ("schema_version", [True, 8.0, 0]),
    ],
)  # fmt: skip
def test_values_that_only_a_manual_edit_can_cause_are_refused(
    folder: Path, place: str, values: list[object]
) -> None:
    sound = (folder / PROJECT_FILE_NAME).read_text()
    *outer, last = place.split("/")
    for value in values:
        content = inner = json.loads(sound)
        for name in outer:
            inner = inner[int(name) if name.isdigit() else name]
        inner[last] = value
        (folder / PROJECT_FILE_NAME).write_text(json.dumps(content))
        opening_error(folder)


def test_messages_that_cannot_be_shown_are_skipped(folder: Path) -> None:
    content = json.loads((folder / PROJECT_FILE_NAME).read_text())
    sound = encode_value(error("store.locked", folder="a"))
    content["data_messages"] = [
        sound, sound | {"code": "no.such"},
        encode_value(error("store.disk_full_size", folder="a", size="much")),
    ]  # fmt: skip
    (folder / PROJECT_FILE_NAME).write_text(json.dumps(content))
    assert [each.code for each in read_project(folder).data_messages] == ["store.locked"]
