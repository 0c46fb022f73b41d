"""Texts of messages that hold English sentences of code without typed messages."""

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

from lispac.language import current_language
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.reverse_translation.catalogue import catalogue_of
from lispac.reverse_translation.translation import Translator

REASON = "reason"
"""Parameter that is such a sentence where it is a text."""


def translated_text(message: Message, say: Callable[[str], str] | None = None) -> str:
    """Text of a message in the language in use; ``say`` translates sentences within it."""
    return message_text(_with_reasons(message, say or _translator(current_language())))


@lru_cache
def _translator(code: str) -> Translator:
    return Translator(catalogue_of(code), spoken_numbers=True)


def _with_reasons(message: Message, say: Callable[[str], str]) -> Message:
    params = dict(message.params)
    for name, value in params.items():
        if isinstance(value, Message):
            params[name] = _with_reasons(value, say)
        elif name == REASON and isinstance(value, str):
            params[name] = say(value)
    return replace(message, params=params)
