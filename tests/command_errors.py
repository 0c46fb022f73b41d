"""What stops a command, and the codes of its messages."""

import re
from typing import Any

import pytest

from lispac.cli.main import run
from lispac.errors import LispacError
from lispac.messages import Message
from tests.error_codes import has_code


def command_error(*words: object) -> LispacError:
    """The error that stops a command."""
    with pytest.raises(LispacError) as raised:
        run([str(word) for word in words])
    return raised.value


def refused_with(code: str, *words: object, **params: Any) -> LispacError:
    """The error that stops a command; it has this code, and these among its parameters."""
    failure = command_error(*words)
    assert has_code(code, **params)(failure)
    return failure


def codes_of(failure: LispacError) -> list[str]:
    """Code of the message of an error, and those of the messages that it gives as reasons."""
    found, message = [failure.code], failure.message
    while message is not None:
        reason = message.params.get("reason")
        message = reason if isinstance(reason, Message) else None
        if message is not None:
            found.append(message.code)
    return found


def is_refusal(failure: LispacError, expected: str) -> bool:
    """Whether an error has a code, or words where it has none yet."""
    return expected in codes_of(failure) or re.search(expected, str(failure)) is not None
