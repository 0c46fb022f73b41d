"""The report for machines: every figure in full precision, keys with their units."""

import json
from dataclasses import asdict
from pathlib import Path

from lispac.installed import resource
from lispac.report.values import ReportContent

NAME = "lispac-report"
SCHEMA_VERSION = 2
SCHEMA_FILE = "report.schema.json"


def json_text(content: ReportContent) -> str:
    """The content as one JSON object; what is not known is null."""
    values = {"schema": NAME, "schema_version": SCHEMA_VERSION, **asdict(content)}
    return json.dumps(values, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def schema_text() -> str:
    """The JSON schema (draft 2020-12) that every report in JSON follows."""
    return resource(SCHEMA_FILE).read_text(encoding="utf-8")


def write_json(content: ReportContent, path: Path) -> None:
    """Write the content as one JSON file."""
    path.write_text(json_text(content), encoding="utf-8", errors="replace", newline="\n")
