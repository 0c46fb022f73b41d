"""Tests of messages stored in project files and shown in the current language."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from lispac.adjustment.diagnostics.observability import largest_increases_note
from lispac.errors import ProjectError
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.language import in_language
from lispac.message_texts import message_text
from lispac.messages import error, note
from lispac.warning_causes import Cause
from lispac.workflow.checking.warnings import warnings_of
from tests.support.report_sample import sample_project

DATA = Path(__file__).parents[1] / "data"
SEARCH_PLACE = note("finder.seed_position", east=14.7, north=0.6, up=5.1)
MISSING_REASON = error("finder.few_points", count=12, radius=1.0, needed=50, place=SEARCH_PLACE)
ENGLISH_TEXT = "Only 12 points"


@pytest.mark.parametrize("saved_in", ["en", "fr"])
def test_reasons_are_shown_in_the_language_in_use(tmp_path: Path, saved_in: str) -> None:
    project = sample_project(tmp_path / "p")
    target = replace(project.targets[0], missing={"L9": MISSING_REASON})
    with in_language(saved_in):
        write_project(
            project.with_target(target).with_validation(project.validation, {"V1": MISSING_REASON})
        )
    opened = read_project(project.folder)
    assert opened.target(target.name).missing == {"L9": MISSING_REASON}
    (found,) = [
        each for each in warnings_of(opened, None) if each.code == "project.not_found_on_line"
    ]
    assert found.subject == Cause.of_sighting(target.name, "L9")
    (not_compared,) = [
        each for each in warnings_of(opened, None) if each.code == "report.not_compared"
    ]
    for message in (found, not_compared):
        assert ENGLISH_TEXT in message_text(message)
        with in_language("fr"):
            french = message_text(message)
        assert ENGLISH_TEXT not in french
        assert "12" in french


def test_the_seed_in_a_message_of_a_former_version_is_converted(tmp_path: Path) -> None:
    place = note("finder.place", north=0.6, west=-14.7, up=5.1)
    former = replace(MISSING_REASON, params={**MISSING_REASON.params, "place": place})
    project = sample_project(tmp_path / "p")
    target = replace(project.targets[0], missing={"L9": former})
    write_project(project.with_target(target).with_validation(project.validation, {"V1": former}))
    assert '"finder.place"' in (project.folder / PROJECT_FILE_NAME).read_text()
    opened = read_project(project.folder)
    assert opened.target(target.name).missing == {"L9": MISSING_REASON}
    assert opened.target(target.name).missing["L9"].params == MISSING_REASON.params
    assert opened.not_compared["V1"].params == MISSING_REASON.params
    assert "(east 14.70 m; north 0.60 m; up 5.10 m)" in message_text(MISSING_REASON)


def test_a_text_of_a_former_project_is_kept(tmp_path: Path) -> None:
    shutil.copytree(DATA / "project-8", tmp_path / "old")
    (reason,) = read_project(tmp_path / "old").targets[0].missing.values()
    text = "The line has no points within 4.5 m of the seed."
    assert reason == note("project.former_text", reason=text)
    assert message_text(reason) == text


def test_results_of_a_former_project_keep_their_texts() -> None:
    content = json.loads((DATA / "project-8" / PROJECT_FILE_NAME).read_text(encoding="utf-8"))
    project = read_project(DATA / "project-8")
    assert project.result is not None
    assert project.result.observability is not None
    assert project.cross_checks is not None
    assert project.absolute is not None
    former = content["result"]["observability"]["sentences"]
    assert project.result.observability.messages == tuple(
        note("project.former_text", reason=text) for text in former
    )
    assert project.absolute.not_compared == tuple(
        note("project.former_text", reason=text) for text in content["absolute"]["unseen"]
    )
    for part, before in zip(project.cross_checks.parts, content["cross_checks"]["parts"],
                            strict=True):  # fmt: skip
        text = before["reason"]
        assert part.reason == (note("project.former_text", reason=text) if text else None)


def test_removed_messages_on_the_observability_are_replaced(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    write_project(project)
    path = project.folder / PROJECT_FILE_NAME
    content = json.loads(path.read_text())
    messages = content["result"]["observability"]["messages"]
    former = {**messages[0], "code": "observability.no_main_lines", "params": {"angles": ["roll"]}}
    messages.insert(1, former)
    path.write_text(json.dumps(content))
    result = read_project(project.folder).result
    assert result is not None
    assert project.result is not None
    assert result.observability is not None
    assert project.result.observability is not None
    present = project.result.observability
    expected = largest_increases_note(project.result.sigma, present.sigma_without_line)
    first, *others = present.messages
    assert result.observability.messages == (first, *expected, *others)


def test_a_message_with_an_unknown_code_is_refused(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    write_project(project.with_validation(project.validation, {"V1": MISSING_REASON}))
    path = project.folder / PROJECT_FILE_NAME
    path.write_text(path.read_text().replace("finder.few_points", "finder.no_such_code"))
    with pytest.raises(ProjectError) as raised:
        read_project(project.folder)
    assert raised.value.message is not None
    assert raised.value.message.params["reason"] == error(
        "content.unknown_message", code="finder.no_such_code"
    )
