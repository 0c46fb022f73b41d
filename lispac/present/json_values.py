"""Conversion of results to plain values for JSON."""

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from datetime import date
from pathlib import Path
from typing import Any

from lispac.language import LazyText, in_english
from lispac.message_texts import english_text
from lispac.messages import Message


def json_values(value: Any) -> Any:
    """Convert to values that `json` writes: dataclasses to dicts, messages to English texts."""
    if isinstance(value, Message):
        return english_text(value)
    if isinstance(value, LazyText):
        return in_english(value)
    if isinstance(value, date | Path):
        return str(value)
    if is_dataclass(value) and not isinstance(value, type):
        return {each.name: json_values(getattr(value, each.name)) for each in fields(value)}
    if isinstance(value, tuple | list):
        return [json_values(each) for each in value]
    if isinstance(value, Mapping):
        return {name: json_values(each) for name, each in value.items()}
    return value
