"""Conversion of results to plain values for JSON."""

from collections.abc import Mapping
from dataclasses import dataclass, fields, is_dataclass
from datetime import date
from pathlib import Path
from typing import Any

from lispac.language import LazyText, in_english
from lispac.message_texts import english_text
from lispac.message_texts.former_codes import former_code
from lispac.messages import Level, Message, plain_params

NOT_IN_JSON: Mapping[str, Any] = {"in_json": False}
"""Metadata of a field that JSON does not contain."""


@dataclass(frozen=True)
class JsonAction:
    """Suggested action of a message in JSON."""

    code: str
    params: Mapping[str, Any]


@dataclass(frozen=True)
class JsonSubject:
    """What a message in JSON is about; ``line`` is the line of a sighting, else empty."""

    kind: str
    name: str
    line: str


@dataclass(frozen=True)
class JsonMessage:
    """Message in JSON with its text in English.

    ``params`` are in SI units, with nested messages as code and parameters. ``former_code`` is the
    code in reports of old versions.
    """

    code: str
    former_code: str
    level: Level
    text: str
    params: Mapping[str, Any]
    subject: JsonSubject | None
    actions: tuple[JsonAction, ...]

    @classmethod
    def of(cls, message: Message) -> "JsonMessage":
        """Values of a message."""
        subject = message.subject
        return cls(
            message.code, former_code(message), message.level, english_text(message),
            plain_params(message),
            None if subject is None else JsonSubject(subject.kind, subject.name, subject.line),
            tuple(JsonAction(each.code, plain_params(each)) for each in message.actions),
        )  # fmt: skip


def json_key(name: str) -> str:
    """Key of a field in JSON: its name, without the underscore after a word of Python."""
    return name.removesuffix("_")


def json_values(value: Any) -> Any:
    """Convert to values that `json` writes: dataclasses to dicts, texts to English."""
    if isinstance(value, Message):
        return json_values(JsonMessage.of(value))
    if isinstance(value, LazyText):
        return in_english(value)
    if isinstance(value, date | Path):
        return str(value)
    if is_dataclass(value) and not isinstance(value, type):
        return {
            json_key(each.name): json_values(getattr(value, each.name))
            for each in fields(value)
            if each.metadata != NOT_IN_JSON
        }
    if isinstance(value, tuple | list):
        return [json_values(each) for each in value]
    if isinstance(value, Mapping):
        return {name: json_values(each) for name, each in value.items()}
    return value
