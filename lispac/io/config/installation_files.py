"""Files with a boresight and a lever arm that other programs read: PDAL pipelines, Kluster vessels.

Sources, read as code and documentation and not run: PDAL (``doc/pipeline.md``,
``TransformationFilter.cpp``, ``GeoreferenceFilter.cpp``) and Kluster (``fqpr_vessel.py``,
``kluster_variables.py``, ``gui/dialog_vesselview.py``).
"""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from lispac.io.files import atomic_write
from lispac.present.output.conventions import ConventionValues, Matrix
from lispac.version import __version__

KLUSTER_SYSTEM = "LiDAR"
"""Name of the scanner in a Kluster vessel, in the place of the serial number of a sonar, so that no
sonar gets the angles of a scanner."""
KLUSTER_TIME = "86400"
"""Time from which the values hold, seconds since 1970. Kluster takes 0 for no time."""
PROGRAM_TEXT = f"LISPAC {__version__}"


def pdal_transformation(values: ConventionValues, remarks: Sequence[str]) -> list[dict[str, Any]]:
    """PDAL pipeline from points in the scanner's frame to the body frame of PDAL.

    Parameters
    ----------
    remarks : sequence of str
        Texts for people who read the file; PDAL ignores them.
    """
    return [
        {
            "type": "filters.transformation",
            "matrix": _matrix_option(values.transform),
            "user_data": _remarks(remarks),
        }
    ]


def pdal_georeference(
    values: ConventionValues, trajectory: Path, latency: float, remarks: Sequence[str]
) -> list[dict[str, Any]]:
    """PDAL pipeline from points in the scanner's frame to earth-centred coordinates.

    Parameters
    ----------
    trajectory : Path
        SBET in Applanix's conventions, with the time base of the points.
    latency : float, seconds
        Added to the times of the points.
    remarks : sequence of str
        Texts for people who read the file; PDAL ignores them.
    """
    return [
        {
            "type": "filters.georeference",
            "trajectory_file": str(trajectory),
            "trajectory_options": {"type": "readers.sbet", "angles_as_degrees": False},
            "scan2imu": _matrix_option(values.transform),
            "coordinate_system": "NED",
            "time_offset": latency,
            "user_data": _remarks(remarks),
        }
    ]


def kluster_vessel(
    values: ConventionValues, remarks: Sequence[str]
) -> dict[str, dict[str, dict[str, Any]]]:
    """Kluster vessel (.kfc) with one system, whose reference point is the POS centre.

    The scanner has the values of transmitter and receiver of a sonar with one head.

    Parameters
    ----------
    remarks : sequence of str
        Texts for people who read the file; Kluster shows them as the source of the values.
    """
    assert values.lever_arm_m is not None
    entry: dict[str, float | str] = {}
    for sensor in ("tx", "rx"):
        for axis, metres in zip("xyz", values.lever_arm_m, strict=True):
            entry[f"{sensor}_{axis}"] = metres
        for letter, angle in zip("rph", values.angles, strict=True):
            entry[f"{sensor}_{letter}"] = angle.value_deg
        entry[f"{sensor}_opening_angle"] = 0.0
    for name, angle in zip(("roll", "pitch", "heading"), values.angles, strict=True):
        if angle.sigma_deg is not None:
            entry[f"{name}_patch_error"] = angle.sigma_deg
    entry |= {f"imu_{axis}": 0.0 for axis in "xyzrph"}
    entry |= {"waterline": 0.0, "latency": 0.0, "sonar_type": "LiDAR"}
    entry["source"] = " ".join((PROGRAM_TEXT, *remarks))
    return {KLUSTER_SYSTEM: {name: {KLUSTER_TIME: value} for name, value in entry.items()}}


def write_json_file(path: Path, content: Sequence[Any] | Mapping[str, Any]) -> None:
    """Write a JSON file.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    write_text_file(path, json.dumps(content, indent=4, ensure_ascii=False) + "\n")


def write_text_file(path: Path, text: str) -> None:
    """Write a text file in UTF-8.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    with atomic_write(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def _matrix_option(matrix: Matrix) -> str:
    """Matrix with all digits, row by row."""
    return " ".join(repr(float(value)) for row in matrix for value in row)


def _remarks(remarks: Sequence[str]) -> dict[str, Any]:
    return {"program": PROGRAM_TEXT, "remarks": list(remarks)}
