"""Record in a LAS or LAZ file with the parameters of the georeferencing.

The record contains the mounting with which the points were georeferenced and the origin of the
local frame. With them the scanner coordinates can be recovered, so that the cloud can be read as a
line again.
"""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Self

import numpy as np

from lispac.geometry.frames import LocalFrame
from lispac.io.las.las_crs_writer import LOCAL_FRAME_RECORD_ID, OWN_USER_ID
from lispac.survey.georeferencing import Mounting
from lispac.untrusted_values import json_values
from lispac.value_conversion import decode_value, encode_value
from lispac.version import __version__

if TYPE_CHECKING:
    import laspy

RECORD_ID, CONTENT_VERSION = 2, 1
"""Record ID, and version of the record's content."""
CORRECTED_TRAJECTORY_RECORD_ID = 3
"""Record ID of the record, without content, of a cloud made with a corrected trajectory."""
MAX_LEVER_ARM_M, MAX_RANGE_OFFSET_M, MAX_LATENCY_S, MAX_HEIGHT_M = 200.0, 10.0, 60.0, 1e5
"""Largest accepted absolute values; a record with larger ones is ignored."""

Triple = tuple[float, float, float]


@dataclass(frozen=True)
class RecordContent:
    """Content of the record, as JSON.

    Attributes
    ----------
    version, program : of the content, and that wrote it
    lever_arm_m : three numbers, metres, body frame (forward, port, up)
    boresight_deg : three numbers, degrees
    axes : three rows of three numbers, or None
    range_offset_m, scan_angle_offset_deg, latency_s : metres, degrees, seconds
    origin_deg_m : latitude and longitude in degrees and height in metres, or None
        Origin of the local frame; None if the coordinates are in a coordinate system.
    """

    version: int
    program: str
    lever_arm_m: Triple
    boresight_deg: Triple
    axes: tuple[Triple, Triple, Triple] | None
    range_offset_m: float
    scan_angle_offset_deg: float
    latency_s: float
    origin_deg_m: Triple | None


@dataclass(frozen=True, eq=False)
class MountingRecord:
    """Mounting and frame with which a cloud was georeferenced, as a LAS record.

    Attributes
    ----------
    mounting : Mounting
        Mounting with which the points were georeferenced.
    frame : LocalFrame or None
        Local frame of the coordinates; None if they are in a coordinate system.
    is_trajectory_corrected : bool
        Whether the cloud was made with the trajectory corrected by the adjustment.
    """

    mounting: Mounting
    frame: LocalFrame | None = None
    is_trajectory_corrected: bool = False

    def vlrs(self) -> "list[laspy.VLR]":
        """Variable length records for the header."""
        import laspy

        mounting, frame = self.mounting, self.frame
        content = RecordContent(
            CONTENT_VERSION,
            f"LISPAC {__version__}",
            mounting.lever_arm.tolist(),
            np.degrees(mounting.boresight).tolist(),
            None if mounting.axes is None else mounting.axes.tolist(),
            mounting.range_offset,
            float(np.degrees(mounting.scan_angle_offset)),
            mounting.latency,
            None if frame is None else (
                float(np.degrees(frame.latitude)), float(np.degrees(frame.longitude)),
                float(frame.height),
            ),
        )  # fmt: skip
        data = json.dumps(encode_value(content)).encode()
        records = [laspy.VLR(OWN_USER_ID, RECORD_ID, "georeferenced_with", data)]
        if frame is not None:
            records.append(laspy.VLR(OWN_USER_ID, LOCAL_FRAME_RECORD_ID, "local_frame", b""))
        if self.is_trajectory_corrected:
            records.append(
                laspy.VLR(OWN_USER_ID, CORRECTED_TRAJECTORY_RECORD_ID, "corrected_trajectory", b"")
            )
        return records

    @classmethod
    def of(cls, header: "laspy.LasHeader") -> Self | None:
        """Get the record in a header; None if there is none or its content is not valid."""
        is_corrected = any(
            each.user_id == OWN_USER_ID and each.record_id == CORRECTED_TRAJECTORY_RECORD_ID
            for each in header.vlrs
        )
        for each in header.vlrs:
            if each.user_id == OWN_USER_ID and each.record_id == RECORD_ID:
                try:
                    content = json_values(bytes(each.record_data))
                    known = _mounting_and_frame(decode_value(content, RecordContent))
                    return cls(*known, is_trajectory_corrected=is_corrected)
                except ValueError:
                    return None
        return None

    @classmethod
    def read(cls, path: Path) -> Self | None:
        """Read the record in a LAS or LAZ file; None for other files and files without it."""
        import laspy
        from laspy.errors import LaspyException

        try:
            with path.open("rb") as file:
                if file.read(4) != b"LASF":
                    return None
            with laspy.open(path) as reader:
                return cls.of(reader.header)
        except (OSError, LaspyException, ValueError):
            return None


def _mounting_and_frame(content: RecordContent) -> tuple[Mounting, LocalFrame | None]:
    """Mounting and frame from the content of a record.

    Raises
    ------
    ValueError
        If a value is out of range, or the content is of another version.
    """
    if content.version != CONTENT_VERSION:
        raise ValueError(content.version)
    for values, limit in (
        (content.lever_arm_m, MAX_LEVER_ARM_M), (content.boresight_deg, 360.0),
        ((content.range_offset_m,), MAX_RANGE_OFFSET_M), ((content.scan_angle_offset_deg,), 360.0),
        ((content.latency_s,), MAX_LATENCY_S),
    ):  # fmt: skip
        if any(abs(value) > limit for value in values):
            raise ValueError(values)
    axes = None if content.axes is None else np.array(content.axes)
    if axes is not None and not np.allclose(axes @ axes.T, np.eye(3), atol=1e-9):
        raise ValueError(content.axes)
    mounting = Mounting(
        np.array(content.lever_arm_m), np.radians(content.boresight_deg),
        range_offset=content.range_offset_m,
        scan_angle_offset=float(np.radians(content.scan_angle_offset_deg)),
        latency=content.latency_s, axes=axes,
    )  # fmt: skip
    if content.origin_deg_m is None:
        return mounting, None
    latitude, longitude, height = content.origin_deg_m
    if not (abs(latitude) <= 90 and abs(longitude) <= 360 and abs(height) <= MAX_HEIGHT_M):
        raise ValueError(content.origin_deg_m)
    frame = LocalFrame(float(np.radians(latitude)), float(np.radians(longitude)), height)
    return mounting, frame
