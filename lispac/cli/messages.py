"""Messages on the command line, with suggested options."""

import sys
from collections.abc import Iterable
from typing import TextIO

from lispac.language import to_plain_text
from lispac.message_texts import action_text, message_text
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
        for action in message.actions:
            print(f"    {_action_text(action)}", file=file)


def _action_text(action: Action) -> str:
    """Suggested action of a message, as an option of the command line if there is one."""
    if action.code == "set_option":
        switch = action.params.get("switch", "line")
        return f"--{switch}-option {action.params['name']}={action.params['value']}"
    if action.code == "split_line":
        return f"--split-by {action.params['by']}"
    return action_text(action)
