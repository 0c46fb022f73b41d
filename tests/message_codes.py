"""Codes and texts of messages, for tests."""

from collections.abc import Iterable

from lispac.message_texts import message_text
from lispac.messages import Message


def codes(messages: Iterable[Message]) -> list[str]:
    """Code of each message."""
    return [message.code for message in messages]


def texts(messages: Iterable[Message | str]) -> str:
    """Texts of messages, and what is a text already, in one line."""
    return " ".join(each if isinstance(each, str) else message_text(each) for each in messages)
