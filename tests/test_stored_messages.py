"""Reasons in a project file are messages: they are shown in the language in use."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from lispac.causes import Cause
from lispac.io.project_file import read_project, write_project
from lispac.language import in_language
from lispac.message_texts import message_text
from lispac.messages import error, note
from lispac.workflow.warnings import warnings_of
from tests.report_sample import sample_project

DATA = Path(__file__).parent / "data"
PLACE = note("finder.place", north=0.6, west=-14.7, up=5.1)
MISSING = error("finder.few_points", count=12, radius=1.0, needed=50, place=PLACE)
ENGLISH = "Only 12 points"


@pytest.mark.parametrize("saved_in", ["en", "fr"])
def test_reasons_are_shown_in_the_language_in_use(tmp_path: Path, saved_in: str) -> None:
    project = sample_project(tmp_path / "p")
    target = replace(project.targets[0], missing={"L9": MISSING})
    with in_language(saved_in):
        write_project(
            project.with_target(target).with_validation(project.validation, {"V1": MISSING})
        )
    opened = read_project(project.folder)
    assert opened.target(target.name).missing == {"L9": MISSING}
    (found,) = [
        each for each in warnings_of(opened, None) if each.code == "project.not_found_on_line"
    ]
    assert found.subject == Cause.of_sighting(target.name, "L9")
    (not_compared,) = [
        each for each in warnings_of(opened, None) if each.code == "report.not_compared"
    ]
    for message in (found, not_compared):
        assert ENGLISH in message_text(message)
        with in_language("fr"):
            french = message_text(message)
        assert ENGLISH not in french
        assert "12" in french


def test_a_sentence_of_a_former_project_stays(tmp_path: Path) -> None:
    shutil.copytree(DATA / "project-8", tmp_path / "old")
    (reason,) = read_project(tmp_path / "old").targets[0].missing.values()
    text = "The line has no points within 4.5 m of the seed."
    assert reason == note("project.former_text", reason=text)
    assert message_text(reason) == text
