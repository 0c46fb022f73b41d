"""English texts of messages by code; translations are in the catalogues of ``resources/i18n``.

A text has at most two short sentences. They name the problem (with the number and the object), its
effect on the result, and the action to take. Each module contains the texts of one topic;
`lispac.language` describes the placeholders.
"""

from collections.abc import Mapping
from typing import Any

from lispac.language import N_, Template, format_text, in_language, number, with_advice
from lispac.message_texts import (
    adjustment,
    adjustment_warnings,
    calibration,
    checking,
    commands,
    control,
    conventions,
    file_checks,
    file_contents,
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

CONTROL_CHARACTERS_TO_SPACES = dict.fromkeys([*range(0x20), *range(0x7F, 0xA0)], " ")
"""Table for `str.translate` that replaces control characters (Unicode Cc) by spaces."""

TOPIC_MODULES = (
    adjustment,
    adjustment_warnings,
    calibration,
    checking,
    commands,
    control,
    conventions,
    file_checks,
    file_contents,
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
"""Modules whose ``TEXTS`` contain the English texts."""

TEXTS: Mapping[str, Template] = {
    code: text for topic in TOPIC_MODULES for code, text in topic.TEXTS.items()
}
"""English text of each message code."""

ACTIONS: Mapping[str, Template] = {
    "set_option": N_("Set {name} to {value}"),
    "exclude_line": N_("Exclude {line}"),
    "split_line": N_("Split {line} into lines by {by}"),
    "use_lidar_noise": N_("Use LiDAR noise {measured:mm.2} mm instead of {given:mm.2} mm"),
    "scale_lidar_noise": N_("Multiply the LiDAR noise by {ratio:x.2}"),
    # -- options of a file -------------------------------------------------------------------
    "use_degrees": N_("Use degrees"),
    "use_feet": N_("Use feet of 0.3048 m"),
    "use_us_survey_feet": N_("Use US survey feet"),
    "swap_coordinates": N_("Swap latitude and longitude"),
    "clear_time_base": N_("Clear the time base"),
    "ignore_rollover": N_("Ignore the time rollover (midnight or week)"),
    "choose_system": N_("Choose the coordinate system"),
    "check_system": N_("Check the coordinate system"),
    "choose_vertical_reference": N_("Choose the vertical reference"),
    "choose_frame": N_("Choose the frame"),
    "choose_time_base": N_("Choose the time base"),
    "check_sign": N_("Check the sign"),
    "detect_columns": N_("Detect the columns again"),
    # -- files of a survey -------------------------------------------------------------------
    "leave_out": N_("Exclude the file"),
    "keep_one_line": N_("Keep as one line"),
    "shift_times": N_("Add {shift:s.0+} s"),
    "clear_shift": N_("Clear the time shift"),
    "bridge_gaps": N_("Interpolate gaps up to {gap:s.1} s"),
}
"""English label of each action code, as on a button."""

ACTION_TIPS: Mapping[str, Template] = {
    "shift_times": N_("Points in {points}, trajectory in {trajectory}"),
}
"""English tooltip of an action code, for actions that have one."""


CAUSE_PREFIX = "acceptance.cause_"
"""Start of the codes of the causes of a failed calibration."""


def message_text(message: Message) -> str:
    """Text of a message in the language in use; in `without_advice`, notes have no advice.

    The cause of a failed calibration keeps its advice, which the reader of the report needs too.
    """
    if message.is_serious or message.code.startswith(CAUSE_PREFIX):
        with with_advice():
            return _text(message)
    return _text(message)


def _text(message: Message) -> str:
    return _one_line(format_text(TEXTS[message.code], _params_as_text(message.params)))


def english_text(message: Message) -> str:
    """Text of a message in English, as in JSON output."""
    with in_language("en"):
        return message_text(message)


def fact_text(fact: str | int | Message) -> str:
    """Text of a fact about a file in the language in use; texts from the file are unchanged."""
    if isinstance(fact, Message):
        return message_text(fact)
    return number(fact, 0) if isinstance(fact, int) else fact


def has_text(message: Message) -> bool:
    """True if a message from a file has a known code and parameters that fit its text."""
    try:
        message_text(message)
        return all(action.code in ACTIONS and action_text(action) for action in message.actions)
    except (KeyError, ValueError, TypeError, AttributeError, IndexError, OverflowError):
        return False


def action_text(action: Action) -> str:
    """Label of an action in the language in use, as on a button."""
    return _one_line(format_text(ACTIONS[action.code], _params_as_text(action.params)))


def action_tip(action: Action) -> str:
    """Tooltip of an action in the language in use; empty if it has none."""
    template = ACTION_TIPS.get(action.code)
    return _one_line(format_text(template, _params_as_text(action.params))) if template else ""


def _params_as_text(params: Mapping[str, Value]) -> dict[str, Any]:
    """Parameters of a message, with nested messages converted to texts."""
    return {name: _value_as_text(value) for name, value in params.items()}


def _value_as_text(value: Value) -> Any:
    if isinstance(value, Message):
        return _text(value)  # with or without advice, as the message that contains it
    if isinstance(value, list | tuple):
        return [_value_as_text(each) for each in value]
    return value


def _one_line(text: str) -> str:
    """Replace control characters, which names of files may contain, by spaces."""
    return text.translate(CONTROL_CHARACTERS_TO_SPACES)
