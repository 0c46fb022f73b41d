"""Record in a LAS or LAZ file with the parameters of the georeferencing.

The record contains the mounting with which the points were georeferenced and the origin of the
local frame. With them the scanner coordinates can be recovered, so that the cloud can be read as a
line again.
"""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

import laspy
import numpy as np
from laspy.errors import LaspyException

from lispac import __version__
from lispac.geometry.frames import LocalFrame
from lispac.io.las.las_crs_writer import LOCAL_FRAME_RECORD_ID, OWN_USER_ID
from lispac.survey.georeferencing import Mounting
from lispac.untrusted_values import json_values

RECORD_ID, CONTENT_VERSION = 2, 1
"""Record ID, and version of the record's content."""
MAX_VALUES = {"lever_arm_m": 200.0, "boresight_deg": 360.0, "range_offset_m": 10.0,
        "scan_angle_offset_deg": 360.0, "latency_s": 60.0}  # fmt: skip
"""Largest accepted absolute values; a record with larger ones is ignored."""


@dataclass(frozen=True, eq=False)
class MountingRecord:
    """Mounting and frame with which a cloud was georeferenced, as a LAS record.

    Attributes
    ----------
    mounting : Mounting
        Mounting with which the points were georeferenced.
    frame : LocalFrame or None
        Local frame of the coordinates; None if they are in a coordinate system.
    """

    mounting: Mounting
    frame: LocalFrame | None = None

    def vlrs(self) -> list[laspy.VLR]:
        """Variable length records for the header."""
        mounting, frame = self.mounting, self.frame
        content = {
            "version": CONTENT_VERSION,
            "program": f"LISPAC {__version__}",
            "lever_arm_m": mounting.lever_arm.tolist(),
            "boresight_deg": np.degrees(mounting.boresight).tolist(),
            "axes": None if mounting.axes is None else mounting.axes.tolist(),
            "range_offset_m": mounting.range_offset,
            "scan_angle_offset_deg": float(np.degrees(mounting.scan_angle_offset)),
            "latency_s": mounting.latency,
            "origin_deg_m": None if frame is None else [
                float(np.degrees(frame.latitude)), float(np.degrees(frame.longitude)),
                float(frame.height),
            ],
        }  # fmt: skip
        data = json.dumps(content).encode()
        records = [laspy.VLR(OWN_USER_ID, RECORD_ID, "georeferenced_with", data)]
        if frame is not None:
            records.append(laspy.VLR(OWN_USER_ID, LOCAL_FRAME_RECORD_ID, "local_frame", b""))
        return records

    @classmethod
    def of(cls, header: laspy.LasHeader) -> Self | None:
        """Get the record in a header; None if there is none or its content is not valid."""
        for each in header.vlrs:
            if each.user_id == OWN_USER_ID and each.record_id == RECORD_ID:
                try:
                    return cls(*_parse_content(json_values(bytes(each.record_data))))
                except (ValueError, TypeError, KeyError):
                    return None
        return None

    @classmethod
    def read(cls, path: Path) -> Self | None:
        """Read the record in a LAS or LAZ file; None for other files and files without it."""
        try:
            with path.open("rb") as file:
                if file.read(4) != b"LASF":
                    return None
            with laspy.open(path) as reader:
                return cls.of(reader.header)
        except (OSError, LaspyException, ValueError):
            return None


def _parse_content(content: Any) -> tuple[Mounting, LocalFrame | None]:
    """Mounting and frame from the content of a record.

    Raises
    ------
    ValueError
        If it is damaged or of another version; `TypeError` and `KeyError` have the same causes.
    """
    if content["version"] != CONTENT_VERSION:
        raise ValueError(content["version"])
    values = {name: np.asarray(content[name], dtype=np.float64) for name in MAX_VALUES}
    for name, limit in MAX_VALUES.items():
        if values[name].shape != ((3,) if name in ("lever_arm_m", "boresight_deg") else ()):
            raise ValueError(name)
        if not (np.abs(values[name]) <= limit).all():
            raise ValueError(name)
    axes = content["axes"]
    if axes is not None:
        axes = np.asarray(axes, dtype=np.float64)
        if axes.shape != (3, 3) or not np.allclose(axes @ axes.T, np.eye(3), atol=1e-9):
            raise ValueError("axes")
    mounting = Mounting(
        values["lever_arm_m"], np.radians(values["boresight_deg"]),
        range_offset=float(values["range_offset_m"]),
        scan_angle_offset=float(np.radians(values["scan_angle_offset_deg"])),
        latency=float(values["latency_s"]), axes=axes,
    )  # fmt: skip
    origin = content["origin_deg_m"]
    if origin is None:
        return mounting, None
    latitude, longitude, height = (float(value) for value in origin)
    if not (abs(latitude) <= 90 and abs(longitude) <= 360 and abs(height) <= 1e5):
        raise ValueError("origin_deg_m")
    frame = LocalFrame(float(np.radians(latitude)), float(np.radians(longitude)), height)
    return mounting, frame
