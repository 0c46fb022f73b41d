"""The report as JSON: numbers in full precision, keys with their units."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from lispac.installation_paths import resource_path
from lispac.message_texts import english_text
from lispac.message_texts.former_codes import former_code
from lispac.messages import Level, Message, plain_params
from lispac.present.json_values import json_values
from lispac.report.report_values import ReportContent

SCHEMA_NAME = "lispac-report"
SCHEMA_VERSION = 5
SCHEMA_FILE = "report.schema.json"


@dataclass(frozen=True)
class JsonWarning:
    """Message of the report in English; ``former_code`` is its code in reports of old versions."""

    code: str
    former_code: str
    level: Level
    text: str
    params: Mapping[str, Any]


def json_text(content: ReportContent) -> str:
    """Report content as one JSON object in English; unknown values are null."""
    values = {
        "schema": SCHEMA_NAME,
        "schema_version": SCHEMA_VERSION,
        **json_values(content),
        "warnings": [asdict(_json_warning(each)) for each in content.warnings],
    }
    return json.dumps(values, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


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
