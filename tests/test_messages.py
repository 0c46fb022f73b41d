"""Messages: every code has a text, and messages come back from a project file as they were."""

import json
from pathlib import Path

from lispac.causes import Cause
from lispac.doubles import data_warnings
from lispac.io.project_file import FILE_NAME, read_project, write_project
from lispac.io.values import decoded, encoded
from lispac.message_texts import TEXTS, MessageFormatter
from lispac.messages import Action, Level, Message
from tests.report_sample import sample_project


def test_si_values_are_formatted_in_the_units_of_the_text() -> None:
    text = (
        "{name}: {count:n} points, {step:ms} ms, {turn:deg.2} deg, {share:percent} %, {lines:names}"
    )
    values = {
        "name": "L1", "count": 12_345, "step": 0.01, "turn": 0.0349065850, "share": 0.25,
        "lines": ("L1", "L2", "L3"),
    }  # fmt: skip
    formatted = MessageFormatter().vformat(text, (), values)
    assert formatted == "L1: 12,345 points, 10.0 ms, 2.00 deg, 25.0 %, L1, L2 and L3"


def test_messages_are_kept_with_the_project(tmp_path: Path) -> None:
    message = Message(
        "audit.example",
        Level.WARNING,
        {"step": 0.01, "count": 3, "lines": ("L1", "L2"), "name": "L1"},
        Cause.of_line("L1"),
        (Action("set_option", {"name": "withheld", "value": "keep"}),),
    )
    assert decoded(json.loads(json.dumps(encoded(message))), Message) == message
    project = sample_project(tmp_path / "p").with_data_messages((message,))
    write_project(project)
    assert read_project(project.folder).data_messages == (message,)
    path = project.folder / FILE_NAME  # a project of an older version has none
    content = json.loads(path.read_text())
    del content["data_messages"]
    path.write_text(json.dumps(content))
    assert read_project(project.folder).data_messages == ()


def test_lines_with_the_same_warning_are_named_together(tmp_path: Path) -> None:
    messages = tuple(
        Message(
            "recovery.unexplained", level, {"line": name, "misfit": 0.05}, Cause.of_line(name)
        )
        for name, level in (
            ("L1", Level.WARNING), ("L2", Level.WARNING), ("L3", Level.WARNING), ("L4", Level.NOTE)
        )
    )  # fmt: skip
    (doubt,) = data_warnings(sample_project(tmp_path / "p").with_data_messages(messages))
    assert (doubt.code, doubt.serious, doubt.cause) == (
        "recovery.unexplained", True, Cause.of_line("L1"),
    )  # fmt: skip
    assert "L2 and L3" in doubt.text
    assert "L4" not in doubt.text


def test_every_text_names_only_units_that_are_known() -> None:
    known = {"", "n", "names", *MessageFormatter.SCALES}
    for code, text in TEXTS.items():
        for _, _, spec, _ in MessageFormatter().parse(text):
            assert (spec or "").partition(".")[0] in known, code
