"""The report as JSON: numbers in full precision, keys with their units."""

import json
from pathlib import Path

from lispac.installation_paths import resource_path
from lispac.present.json_values import json_values
from lispac.report.report_values import ReportContent

SCHEMA_NAME = "lispac-report"
SCHEMA_VERSION = 11
SCHEMA_FILE = "report.schema.json"


def json_text(content: ReportContent) -> str:
    """Report content as one JSON object in English; unknown values are null."""
    head = {"schema": SCHEMA_NAME, "schema_version": SCHEMA_VERSION}
    values = head | json_values(content)
    return json.dumps(values, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def schema_text() -> str:
    """The JSON schema (draft 2020-12) that every report in JSON follows."""
    return resource_path(SCHEMA_FILE).read_text(encoding="utf-8")


def write_json(content: ReportContent, path: Path) -> None:
    """Write the content as one JSON file."""
    path.write_text(json_text(content), encoding="utf-8", errors="replace", newline="\n")
