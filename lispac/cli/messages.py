"""Messages on the command line, with suggested options."""

import sys
from collections.abc import Iterable
from typing import TextIO

from lispac.language import to_plain_text
from lispac.message_texts import message_text
from lispac.messages import Action, Message

OPTION_HINTS = {
    "adjustment.only_plane": "--accept-single-orientation",
    "adjustment.parallel_planes": "--accept-single-orientation",
    "cli.has_targets": "without --accept",
    "cli.no_results": "lispac estimate {project}, or --compute",
    "cluster.no_certificates": "--cluster-tls CA CERTIFICATE KEY",
    "cluster.plain_tcp_refused": "--plain-tcp",
    "history.no_date": "lispac identity {project} --dates",
    "history.no_day": "lispac identity {project} --dates",
    "import.points_without_time": "lispac check",
    "import.unknown_accuracy_format": "lispac inspect FILE",
    "import.unknown_line_format": "lispac inspect FILE",
    "import.unknown_trajectory_format": "lispac inspect FILE",
    "plan_survey.process_ended": "--workers",
    "project_files.many_missing": "lispac locate PROJECT FOLDER",
    "project_files.one_missing": "lispac locate PROJECT FOLDER",
    "project_files.several_missing": "lispac locate PROJECT FOLDER",
    "simulate.no_trajectory": "--trajectory",
}
"""Suggested option or command by message code; the text of the message contains none."""


def option_hint(message: Message | None) -> str:
    """Suggested option for a message or for a message within it; empty if there is none."""
    if message is None:
        return ""
    if message.code in OPTION_HINTS:
        return OPTION_HINTS[message.code].format(**message.params)
    parts = [each for each in message.params.values() if isinstance(each, Message)]
    return next(filter(None, map(option_hint, parts)), "")


def console_text(message: Message) -> str:
    """Text of a message with characters that every terminal shows."""
    return to_plain_text(message_text(message))


def print_messages(messages: Iterable[Message], file: TextIO | None = None) -> None:
    """Print each message with its level and its suggested options, on stderr by default."""
    file = file or sys.stderr
    for message in messages:
        print(f"{message.level}: {console_text(message)}", file=file)
        if option := option_hint(message):
            print(f"    {option}", file=file)
        for option in filter(None, map(_action_option, message.actions)):
            print(f"    {option}", file=file)


ACTION_OPTIONS = {
    "split_line": "--split-by {by}",
    "shift_times": "--time-shift {shift:g}",
    "bridge_gaps": "--longest-gap {gap:g}",
    "use_lidar_noise": "--lidar-sigma {measured:.3g} --lidar-noise-source residuals",
}
"""Option by the code of an action that is not about an option of a file."""
TRAJECTORY_ACTION_CODES = {"use_degrees", "swap_coordinates", "check_sign"}
"""Codes of actions on options of a trajectory; the others are on options of a line."""


def _action_option(action: Action) -> str:
    """Option for a suggested action; empty if only the window has the action."""
    params = action.params
    if action.code in ACTION_OPTIONS:
        return ACTION_OPTIONS[action.code].format(**params)
    if "name" not in params:
        return ""
    is_trajectory = action.code in TRAJECTORY_ACTION_CODES or params["name"] == "time"
    switch = params.get("switch", "trajectory" if is_trajectory else "line")
    value = params.get("value", "VALUE")
    return f"--{switch}-option {params['name']}={value}"
