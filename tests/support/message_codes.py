"""Codes and texts of messages, for tests."""

import re
from collections.abc import Iterable
from string import Formatter

from lispac.message_texts import TEXTS, message_text
from lispac.messages import Message


def codes(messages: Iterable[Message]) -> list[str]:
    """Code of each message."""
    return [message.code for message in messages]


def texts(messages: Iterable[Message | str]) -> str:
    """Texts of messages in one line; strings are accepted too."""
    return " ".join(each if isinstance(each, str) else message_text(each) for each in messages)


def is_shown(code: str, text: str) -> bool:
    """Whether a text contains the English message of a code with any parameters."""
    template = TEXTS[code]
    forms = [template] if isinstance(template, str) else [template.singular, template.plural]
    return any(re.search(_pattern(form), text) is not None for form in forms)


def _pattern(form: str) -> str:
    fields = Formatter().parse(form)
    return "".join(re.escape(words) + (".+?" if name else "") for words, name, _, _ in fields)
