"""A project file that cannot be read: said in words, with what a library said in the details."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from lispac.errors import ProjectError
from lispac.io.project_file import FILE_NAME, read_project, write_project
from lispac.language.catalogue import catalogue_of
from lispac.language.translation import Translator
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
        (lambda content: content["targets"][0].update(seed=["a", 1, 2]), "of the wrong kind"),
        (lambda content: content.update(schema_version="x"), "of the wrong kind"),
    ],
)
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
