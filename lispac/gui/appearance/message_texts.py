"""Texts of messages in the window."""

from lispac import message_texts
from lispac.language import minus_signs
from lispac.messages import Message


def message_text(message: Message) -> str:
    """Text of a message in the language in use, with minus signs as in tables and status bar."""
    with minus_signs():
        return message_texts.message_text(message)
