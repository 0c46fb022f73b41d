"""The JSON schema of the report, made from the dataclasses of its content.

``python -m tests.documents`` writes it again after a change of the dataclasses.
"""

import json
from dataclasses import MISSING, field, fields, make_dataclass
from pathlib import Path
from typing import Any, get_type_hints

from jsonschema import Draft202012Validator
from pydantic import TypeAdapter

from lispac.present.json_values import JsonMessage
from lispac.report.json_report import SCHEMA_FILE, SCHEMA_NAME, SCHEMA_VERSION
from lispac.report.report_values import ReportContent

PATH = Path(__file__).resolve().parents[2] / "resources" / SCHEMA_FILE
ABOUT = (
    "What `lispac report --output report.json` writes. Names end in the unit of their values: _m "
    "metres, _deg degrees, _s seconds. What is not known is null."
)


def schema_text() -> str:
    """Text of the schema file."""
    found = TypeAdapter(_in_json()).json_schema(mode="serialization")
    made = _plain(_with_texts(found))
    head = {
        "schema": {"const": SCHEMA_NAME},
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
    return json.dumps(schema, indent=1, ensure_ascii=False) + "\n"


def _in_json() -> type:
    """Type of the content with messages as in JSON."""
    hints = get_type_hints(ReportContent) | {"warnings": tuple[JsonMessage, ...]}
    each = [
        (it.name, hints[it.name], field(default=it.default))
        if it.default is not MISSING
        else (it.name, hints[it.name])
        for it in fields(ReportContent)
    ]
    return make_dataclass("ReportContent", each, namespace={"__doc__": ReportContent.__doc__})


def _with_texts(value: Any) -> Any:
    """Schema with texts and messages as they are in JSON."""
    if isinstance(value, list):
        return [_with_texts(item) for item in value]
    if not isinstance(value, dict):
        return value
    if value.get("$ref") == "#/$defs/Message":
        return {"$ref": "#/$defs/JsonMessage"}
    if value.get("$ref") == "#/$defs/LazyText":
        return {"type": "string"}
    unused = ("Message", "Cause", "Action", "Value", "LazyText", "Plural")
    return {
        key: _with_texts(
            {name: each for name, each in item.items() if name not in unused}
            if key == "$defs"
            else item
        )
        for key, item in value.items()
    }


def _plain(value: Any, *, named: bool = False) -> Any:
    """Schema without titles that only repeat names, and with the sentences of docstrings only.

    ``named`` is True if the keys are names of the content.
    """
    if isinstance(value, list):
        return [_plain(item) for item in value]
    if not isinstance(value, dict):
        return value
    kept = {}
    for key, item in value.items():
        if key == "title" and not named:
            continue
        if key == "description" and not named:
            item = " ".join(item.split("\n\nAttributes")[0].split())
        kept[key] = _plain(item, named=key in ("properties", "$defs") and not named)
    return kept


def followed(text: str) -> dict[str, Any]:
    """Read the report from a JSON text and check it against the published schema.

    Raises
    ------
    jsonschema.ValidationError
    """
    data = json.loads(text)
    Draft202012Validator(json.loads(PATH.read_text(encoding="utf-8"))).validate(data)
    return data  # type: ignore[no-any-return]


def main() -> None:
    """Write the schema."""
    PATH.write_text(schema_text(), encoding="utf-8", newline="\n")
