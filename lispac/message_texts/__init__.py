"""Texts of messages: English by code here, translations in the catalogues of ``resources/i18n``.

A text has up to three sentences: what is wrong (with the number and the object), what it means for
the result, what to do. A module holds the texts of one topic; `lispac.language` explains the
placeholders.
"""

from collections.abc import Mapping
from typing import Any

from lispac.language import N_, Template, text_of
from lispac.message_texts import (
    adjustment,
    adjustment_warnings,
    calibration,
    checking,
    commands,
    importing,
    importing_steps,
    items,
    output,
    planning,
    planning_steps,
    point_files,
    program,
    project_warnings,
    projects,
    report_warnings,
    settings_files,
    store,
    survey,
    targets,
    text_files,
    trajectories,
    workflow,
)
from lispac.messages import Action, Message, Value

CONTROL = dict.fromkeys([*range(0x20), *range(0x7F, 0xA0)], " ")
"""Characters of Unicode's category Cc, with what replaces them."""

TOPICS = (
    adjustment,
    adjustment_warnings,
    calibration,
    checking,
    commands,
    importing,
    importing_steps,
    items,
    output,
    planning,
    planning_steps,
    point_files,
    program,
    project_warnings,
    projects,
    report_warnings,
    settings_files,
    store,
    survey,
    targets,
    text_files,
    trajectories,
    workflow,
)

TEXTS: Mapping[str, Template] = {
    code: text for topic in TOPICS for code, text in topic.TEXTS.items()
}
"""English text of each message code."""

ACTIONS: Mapping[str, Template] = {
    "set_option": N_("Set {name} to {value}"),
    "exclude_line": N_("Exclude {line}"),
    "split_line": N_("Split {line} into lines by {by}"),
}
"""English label of each action code, as on a button."""


def message_text(message: Message) -> str:
    """Text of a message in the language in use."""
    return _one_line(text_of(TEXTS[message.code], _rendered(message.params)))


def has_text(message: Message) -> bool:
    """Whether a message read from a file has a known code and parameters that fit its text."""
    try:
        message_text(message)
        return all(action.code in ACTIONS and action_text(action) for action in message.actions)
    except (KeyError, ValueError, TypeError, AttributeError, IndexError, OverflowError):
        return False


def action_text(action: Action) -> str:
    """Label of an action in the language in use, as on a button."""
    return _one_line(text_of(ACTIONS[action.code], dict(action.params)))


def _rendered(params: Mapping[str, Value]) -> dict[str, Any]:
    """The parameters with messages among them as texts."""
    return {name: _with_text(value) for name, value in params.items()}


def _with_text(value: Value) -> Any:
    if isinstance(value, Message):
        return message_text(value)
    if isinstance(value, list | tuple):
        return [_with_text(each) for each in value]
    return value


def _one_line(text: str) -> str:
    """The text with control characters, as names of files may have them, replaced by spaces."""
    return text.translate(CONTROL)
