"""The JSON schema of the report, made from the dataclasses of its content.

``python -m tests.report_schema`` writes it anew after a change of these.
"""

import json
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from lispac.report.json_report import NAME, SCHEMA_FILE, SCHEMA_VERSION
from lispac.report.values import ReportContent

PATH = Path(__file__).resolve().parents[1] / "resources" / SCHEMA_FILE
ABOUT = (
    "What `lispac report --output report.json` writes. Names end in the unit of their values: _m "
    "metres, _deg degrees, _s seconds. What is not known is null."
)


def schema_text() -> str:
    """The schema as the file holds it."""
    made = TypeAdapter(ReportContent).json_schema(mode="serialization")
    head = {
        "schema": {"const": NAME},
        "schema_version": {"const": SCHEMA_VERSION},
    }
    schema: dict[str, Any] = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "LISPAC boresight report",
        "description": ABOUT,
        "type": "object",
        "properties": head | made["properties"],
        "required": [*head, *made["required"]],
        "$defs": made["$defs"],
    }
    return json.dumps(_without_titles(schema), indent=1, ensure_ascii=False) + "\n"


def _without_titles(value: Any, *, named: bool = False) -> Any:
    """Without titles that only repeat the names, and with docstrings as one line."""
    if isinstance(value, dict):
        return {
            key: " ".join(item.split("\n\nAttributes")[0].split()) if key == "description" and not named
            else _without_titles(item, named=key in ("properties", "$defs"))
            for key, item in value.items()
            if named or key != "title" or item == "LISPAC boresight report"
        }  # fmt: skip
    return [_without_titles(item) for item in value] if isinstance(value, list) else value


if __name__ == "__main__":
    PATH.write_text(schema_text(), encoding="utf-8", newline="\n")
    print(PATH)
