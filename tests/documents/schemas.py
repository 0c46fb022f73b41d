"""The JSON schemas of the report and of the commands, made from the dataclasses of their content.

``python -m tests.documents`` writes them again after a change of the dataclasses.
"""

import json
from dataclasses import fields
from pathlib import Path
from typing import Any

from jsonschema import Draft202012Validator
from pydantic import TypeAdapter

from lispac.cli.console import SCHEMA_FILE as COMMANDS_FILE
from lispac.cli.console import SCHEMA_VERSION as COMMANDS_VERSION
from lispac.cli.json_outputs import OUTPUTS
from lispac.present.json_values import NOT_IN_JSON, JsonMessage, json_key
from lispac.report.json_report import SCHEMA_FILE, SCHEMA_NAME, SCHEMA_VERSION
from lispac.report.report_values import ReportContent

RESOURCES = Path(__file__).resolve().parents[2] / "resources"
PATH = RESOURCES / SCHEMA_FILE
COMMANDS_PATH = RESOURCES / COMMANDS_FILE
DRAFT = "https://json-schema.org/draft/2020-12/schema"
NAMES_TEXT = (
    "Names end in the unit of their values: _m metres, _deg degrees, _s seconds. What is not known "
    "is null."
)
ABOUT = f"What `lispac report --output report.json` writes. {NAMES_TEXT}"
ABOUT_COMMANDS = (
    "What the commands of LISPAC write with `--json`: each property is the schema for the command "
    f"of its name, which `lispac COMMAND --schema` prints. {NAMES_TEXT}"
)

_EDGES = "Edges of the bins of the histogram, metres, one more than counts."
_COUNTS = "Number of distances in each bin."
_POSITION = (
    "North, west, up of the local frame, metres. The table of the report gives east, north, up; "
    "east has the opposite sign of west."
)
FIELD_TEXTS: dict[str, dict[str, str]] = {
    "AbsoluteCheckValues": {
        "bin_edges_m": _EDGES, "counts_before": _COUNTS, "counts_after": _COUNTS,
    },
    "AdjustmentValues": {
        "rotation_body_lidar": "Rotation matrix, by rows, from LiDAR axes to body axes (forward, "
        "left, up).",
        "correlation": "Correlations of roll, pitch, yaw, by rows.",
        "correlation_all": "Correlations of all parameters of `estimated`, by rows, in this order.",
        "effect_distances_m": "Distances from the scanner, metres, of the displacements in "
        "`effects`.",
    },
    "CauseValues": {
        "size": "Components in `unit`, in the order given above; west is the opposite of east.",
        "sigma": "Standard deviations of the components of `size`, in `unit`.",
    },
    "ControlPointValues": {
        "sigmas_m": "Standard deviations of north, west, up, metres.",
    },
    "ConventionValues": {
        "lever_arm_m": "Lever arm along the body axes of the other program, metres.",
        "transform": "4x4 matrix, by rows.",
    },
    "DisplacementByAngle": {
        "displacement_m": "Displacement at each of `effect_distances_m`, metres; not negative.",
    },
    "DistanceMapValues": {
        "across_m": "Place of each cell, metres: east on a horizontal plane, else along the "
        "horizontal axis of the plane, to the right as seen from the vessel.",
        "up_m": "Place of each cell, metres: north on a horizontal plane, else up its slope.",
        "before_m": "Distance before the calibration, metres; positive if the first line is nearer "
        "to the vessel.",
        "after_m": "Distance after the calibration, metres; positive if the first line is nearer "
        "to the vessel.",
    },
    "DistancesBySteps": {
        "edges_m": "Edges of the intervals of height or range, metres.",
        "n": "Number of distances in each interval.",
    },
    "ErrorBudgetValues": {"distances_m": "Distances from the scanner, metres."},
    "LineTrajectorySummary": {
        "motion_deg": "Standard deviations of roll and of pitch during the line, degrees.",
    },
    "LineValues": {
        "track_local_m": "Places of the vessel: north and west from the origin of the local frame, "
        "metres; west is the opposite of east.",
    },
    "ObservabilityValues": {
        "direction_sigma_deg": "Standard deviation along each direction, degrees, largest first.",
    },
    "PickedPlane": {
        "seed_local_m": "North, west, up from the origin of the local frame, metres; the table of "
        "the report gives east, north, up.",
    },
    "PosErrorValues": {
        "error_m": f"Reported minus true position. {_POSITION}",
        "error_deg": "Reported minus true roll, pitch, heading, degrees, as in the report.",
        "sigma_m": "Prior sigmas of north, west, up, metres.",
        "sigma_after_m": "Sigmas of north, west, up after the adjustment, metres.",
        "sigma_deg": "Prior sigmas of roll, pitch, heading, degrees.",
        "sigma_after_deg": "Sigmas of roll, pitch, heading after the adjustment, degrees.",
    },
    "ScannerToBodyMatrix": {
        "rotation": "3x3 rotation matrix, by rows.",
        "transform": "4x4 matrix, by rows; the last column is the lever arm, metres.",
    },
    "SettingsUsed": {
        "lever_arm_m": "Scanner from the POS along the body axes forward, left, up, metres.",
        "lever_arm_sigma_m": "Standard deviations forward, left, up, metres.",
        "origin_deg_m": "Latitude and longitude, degrees, and ellipsoidal height, metres.",
        "position_sigma_m": "Standard deviations north, east, down, metres.",
        "attitude_sigma_deg": "Standard deviations of roll, pitch, heading, degrees.",
        "lidar_sigma_xyz_m": "Standard deviations along the LiDAR axes x, y, z, metres.",
    },
    "SurfaceGeometryValues": {
        "centre_local_m": f"Position. {_POSITION}",
        "extent_m": "Width (level) and height (up the slope) of the points, metres; west and north "
        "on a horizontal plane.",
    },
    "SightingQualityValues": {
        "extent_m": "Width (level) and height (up the slope) of the sighting, metres.",
    },
    "SigmaValues": {
        "before": "Values before the estimate of variance components, in `units`.",
        "used": "Values in the adjustment, in `units`.",
    },
    "ValidationPlane": {
        "bin_edges_m": _EDGES, "counts_before": _COUNTS, "counts_after": _COUNTS,
    },
}  # fmt: skip
"""Axes, units and signs of the lists of numbers, by class and field."""

NOT_IN_JSON_CLASSES = ("PlaneSection", "LineSection")
"""Classes of the fields of the content that JSON does not contain."""

VERSION_SCHEMA = {
    "type": "object",
    "properties": {"schema_version": {"const": COMMANDS_VERSION}},
    "required": ["schema_version"],
}
"""Schema of the version, which the output of each command contains."""


def schema_text() -> str:
    """Text of the schema file of the report."""
    head = {
        "schema": {"const": SCHEMA_NAME},
        "schema_version": {"const": SCHEMA_VERSION},
    }
    _, definitions = _schemas({"report": ReportContent})
    made = definitions.pop("ReportContent")
    kept = [each.name for each in fields(ReportContent) if each.metadata != NOT_IN_JSON]
    return _as_text({
        "$schema": DRAFT,
        "title": "LISPAC boresight report",
        "description": ABOUT,
        "type": "object",
        "properties": head | {name: made["properties"][name] for name in kept},
        "required": [*head, *kept],
        "$defs": definitions,
    })  # fmt: skip


def commands_schema_text() -> str:
    """Text of the schema file of the commands."""
    properties, definitions = _schemas(OUTPUTS)
    return _as_text({
        "$schema": DRAFT,
        "title": "Output of the commands of LISPAC",
        "description": ABOUT_COMMANDS,
        "type": "object",
        "properties": {name: {**VERSION_SCHEMA, **each} for name, each in properties.items()},
        "$defs": definitions,
    })  # fmt: skip


def _as_text(schema: dict[str, Any]) -> str:
    return json.dumps(schema, indent=1, ensure_ascii=False) + "\n"


def _schemas(kinds: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    """Schemas of types by name, and the definitions that they use."""
    inputs = [(name, "serialization", TypeAdapter(kind)) for name, kind in kinds.items()]
    inputs.append(("", "serialization", TypeAdapter(JsonMessage)))
    found, whole = TypeAdapter.json_schemas(inputs)  # type: ignore[arg-type]
    made = _plain(_in_json({"$defs": whole["$defs"]}))
    for name, texts in FIELD_TEXTS.items():
        for field, text in texts.items():
            if name in made["$defs"]:
                made["$defs"][name]["properties"][field]["description"] = text
    return {
        name: _plain(_in_json(found[name, "serialization"])) for name in kinds
    }, made["$defs"]  # fmt: skip


def _in_json(value: Any) -> Any:
    """Schema with texts, messages and keys as they are in JSON."""
    if isinstance(value, list):
        return [_in_json(item) for item in value]
    if isinstance(value, str):
        return json_key(value)
    if not isinstance(value, dict):
        return value
    if value.get("$ref") == "#/$defs/Message":
        return {"$ref": "#/$defs/JsonMessage"}
    if value.get("$ref") == "#/$defs/LazyText":
        return {"type": "string"}
    unused = (
        "Message",
        "Cause",
        "Action",
        "Value",
        "LazyText",
        "Plural",
        "Advised",
        *NOT_IN_JSON_CLASSES,
    )
    return {
        json_key(key): _in_json(
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


def followed_output(command: str, text: str) -> Any:
    """Read the output of a command from a JSON text and check it against the published schema.

    Keys that are not in the schema are errors too.

    Raises
    ------
    jsonschema.ValidationError
    """
    data = json.loads(text)
    published = json.loads(COMMANDS_PATH.read_text(encoding="utf-8"))
    definitions = {
        name: {**each, "additionalProperties": False} if "properties" in each else each
        for name, each in published["$defs"].items()
    }
    schema = published["properties"][command]
    Draft202012Validator({**schema, "$defs": published["$defs"]}).validate(data)
    content = {name: each for name, each in schema.items() if name not in VERSION_SCHEMA}
    values = {name: each for name, each in data.items() if name != "schema_version"}
    Draft202012Validator({**content, "$defs": definitions}).validate(values)
    return data


def main() -> None:
    """Write the schemas."""
    for path, text in ((PATH, schema_text()), (COMMANDS_PATH, commands_schema_text())):
        path.write_text(text, encoding="utf-8", newline="\n")
