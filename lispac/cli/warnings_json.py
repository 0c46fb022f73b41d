"""Warnings as JSON, alike in all commands."""

from collections.abc import Iterable
from typing import Any

from lispac.adjustment.display_text import to_plain_text
from lispac.language import in_language
from lispac.message_texts import message_text
from lispac.message_texts.former_codes import former_code
from lispac.messages import Message, plain_params


def warnings_as_json(messages: Iterable[Message]) -> list[dict[str, Any]]:
    """Code, former code, text in English and parameters of each message."""
    with in_language("en"):
        return [
            {
                "code": each.code,
                "former_code": former_code(each),
                "serious": each.is_serious,
                "text": to_plain_text(message_text(each)),
                "params": plain_params(each),
            }
            for each in messages
        ]
