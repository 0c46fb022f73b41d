"""Warnings as JSON, alike in all commands."""

from collections.abc import Iterable
from typing import Any

from lispac.cli.messages import message_values
from lispac.language import in_language
from lispac.message_texts.former_codes import former_code
from lispac.messages import Message


def warnings_as_json(messages: Iterable[Message]) -> list[dict[str, Any]]:
    """Values of each message with its text in English, and its former code."""
    with in_language("en"):
        return [message_values(each) | {"former_code": former_code(each)} for each in messages]
