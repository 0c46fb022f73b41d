"""Errors that end a command, and the codes of their messages."""

import re
from typing import Any

import pytest

from lispac.cli.main import run
from lispac.errors import LispacError
from lispac.messages import Message
from tests.support.error_codes import has_code


def command_error(*words: object) -> LispacError:
    """The error that ends a command."""
    with pytest.raises(LispacError) as raised:
        run([str(word) for word in words])
    return raised.value


def refused_with(code: str, *words: object, **params: Any) -> LispacError:
    """The error that ends a command; checks its code and the given parameters."""
    failure = command_error(*words)
    assert has_code(code, **params)(failure)
    return failure


def codes_of(failure: LispacError) -> list[str]:
    """Codes of the message of an error and of the chain of its reasons."""
    found, message = [failure.code], failure.message
    while message is not None:
        reason = message.params.get("reason")
        message = reason if isinstance(reason, Message) else None
        if message is not None:
            found.append(message.code)
    return found


def is_refusal(failure: LispacError, expected: str) -> bool:
    """Whether an error has a code, or contains a text if it has no code."""
    return expected in codes_of(failure) or re.search(expected, str(failure)) is not None
