"""Messages about files at the command line, as text and as JSON."""

import sys
from collections.abc import Iterable
from typing import Any, TextIO

from lispac.cli.option_hints import option_hint
from lispac.language import to_plain_text
from lispac.message_texts import action_text, message_text
from lispac.messages import Action, Message, plain_params


def print_messages(messages: Iterable[Message], file: TextIO | None = None) -> None:
    """Print each message with its level and the options that act on it, on stderr by default."""
    file = file or sys.stderr
    for message in messages:
        print(f"{message.level}: {to_plain_text(message_text(message))}", file=file)
        if option := option_hint(message):
            print(f"    {option}", file=file)
        for action in message.actions:
            print(f"    {_action_text(action)}", file=file)


def message_values(message: Message) -> dict[str, Any]:
    """A message for JSON: code, level, parameters in SI units, subject, actions and text."""
    subject = message.subject
    return {
        "code": message.code,
        "level": message.level.value,
        "params": plain_params(message),
        "subject": subject and {"kind": subject.kind, "name": subject.name, "line": subject.line},
        "actions": [{"code": each.code, "params": plain_params(each)} for each in message.actions],
        "text": to_plain_text(message_text(message)),
    }


def _action_text(action: Action) -> str:
    """Action of a message as an option of the command line."""
    if action.code == "set_option":
        switch = action.params.get("switch", "line")
        return f"--{switch}-option {action.params['name']}={action.params['value']}"
    if action.code == "split_line":
        return f"--split-by {action.params['by']}"
    return action_text(action)
