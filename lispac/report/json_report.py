"""The report as JSON: numbers in full precision, keys with their units."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields, is_dataclass, replace
from pathlib import Path
from typing import Any

from lispac.installation_paths import resource_path
from lispac.language import LazyText, in_english
from lispac.message_texts import english_text
from lispac.message_texts.former_codes import former_code
from lispac.messages import Level, Message, plain_params
from lispac.report.report_values import ReportContent

NAME = "lispac-report"
SCHEMA_VERSION = 4
SCHEMA_FILE = "report.schema.json"


@dataclass(frozen=True)
class JsonWarning:
    """A typed message in English; ``code`` names the condition.

    ``former_code`` is what versions before typed messages called it.
    """

    code: str
    former_code: str
    level: Level
    text: str
    params: Mapping[str, Any]


def json_text(content: ReportContent) -> str:
    """The content as one JSON object in English; what is not known is null."""
    values = {
        "schema": NAME,
        "schema_version": SCHEMA_VERSION,
        **asdict(english_values(content)),
        "warnings": [asdict(_json_warning(each)) for each in content.warnings],
    }
    return json.dumps(values, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def english_values(value: Any) -> Any:
    """Values with each message replaced by its English text."""
    if isinstance(value, Message):
        return english_text(value)
    if isinstance(value, LazyText):
        return in_english(value)
    if is_dataclass(value) and not isinstance(value, type):
        items = ((each.name, getattr(value, each.name)) for each in fields(value))
        return replace(value, **{name: english_values(each) for name, each in items})
    if isinstance(value, tuple):
        return tuple(map(english_values, value))
    if isinstance(value, Mapping):
        return {name: english_values(each) for name, each in value.items()}
    return value


def _json_warning(message: Message) -> JsonWarning:
    text = english_text(message)
    return JsonWarning(
        message.code, former_code(message), message.level, text, plain_params(message)
    )


def schema_text() -> str:
    """The JSON schema (draft 2020-12) that every report in JSON follows."""
    return resource_path(SCHEMA_FILE).read_text(encoding="utf-8")


def write_json(content: ReportContent, path: Path) -> None:
    """Write the content as one JSON file."""
    path.write_text(json_text(content), encoding="utf-8", errors="replace", newline="\n")
