"""Scans of an E57 file, read with libE57: their fields, poses and valid points.

pye57's reader does not support time stamps and reads each scan as a whole, so its binding of libE57
is used directly. libE57 checks the checksum of every page, so that its decoders receive no damaged
bytes.
"""

import struct
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.files import library_path
from lispac.io.point_reader_common import POINTS_PER_CHUNK, require_usable_points
from lispac.io.points.e57_packets import excess_records
from lispac.messages import error

Array = NDArray[np.float64]

CARTESIAN_FIELDS = ("cartesianX", "cartesianY", "cartesianZ")
SPHERICAL_FIELDS = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
CARTESIAN_STATE, SPHERICAL_STATE = "cartesianInvalidState", "sphericalInvalidState"
TIME_STATE = "isTimeStampInvalid"
STATE_FIELDS = (CARTESIAN_STATE, SPHERICAL_STATE, TIME_STATE)
"""Fields that are 0 if the Cartesian coordinates, spherical coordinates or time are valid."""
PAGE_BYTES = 1024


@dataclass(frozen=True, eq=False)
class Scan:
    """One scan; its points are read through ``node``.

    Attributes
    ----------
    node : libe57.StructureNode
    count : int
        Number of points, valid or not.
    fields : mapping of str to numpy.dtype
    start : float, seconds since the GPS epoch
        Start of the acquisition; 0 if it is not given.
    rotation : ndarray of shape (3, 3)
        Rotation from the frame of the scan to that of the file.
    translation : ndarray of shape (3,), metres, frame of the file
        Origin of the scan.
    """

    node: Any
    count: int
    fields: Mapping[str, np.dtype[Any]]
    start: float
    rotation: Array
    translation: Array

    @property
    def has_pose(self) -> bool:
        """True if the file rotates or translates the scan."""
        return bool((self.rotation != np.eye(3)).any() or self.translation.any())


@contextmanager
def opened_e57(path: Path) -> Iterator[Any]:
    """Open a file after a check of its header.

    Raises
    ------
    InputError
        If the file is damaged or its version is not supported.
    """
    _require_sound_header(path)
    try:
        from pye57 import libe57
    except ImportError as failure:
        raise InputError(error("e57.not_supported", file=str(path))) from failure
    with library_path(path) as name:
        image = libe57.ImageFile(str(name), "r")
        try:
            yield image
        finally:
            image.close()


def _require_sound_header(path: Path) -> None:
    """Refuse a header that does not fit the file (ASTM E2807, table 1).

    Raises
    ------
    InputError
        If the file has no E57 signature, or its size differs from that in the header.
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        header = file.read(48)
    if len(header) < 48 or header[:8] != b"ASTM-E57":
        raise InputError(error("e57.header", file=str(path)))
    length, xml_start, xml_length, page = struct.unpack_from("<4Q", header, 16)
    if length != size or page != PAGE_BYTES or not 48 <= xml_start < size or xml_length > size:
        raise InputError(error("e57.size", file=str(path), header=length, size=size))


def find_scans(image: Any, path: Path, *, timed: bool = True) -> list[Scan]:
    """Scans that contain points.

    Parameters
    ----------
    timed : bool
        Whether points without time are refused.

    Raises
    ------
    InputError
        If no scan has points, counts disagree, scans have different fields, or fields are missing.
    """
    nodes = image.root()["data3D"]
    for header, total in excess_records(path, [nodes[k]["points"] for k in range(len(nodes))]):
        raise InputError(error("e57.points_not_counted", file=str(path), header=header, held=total))
    scans = [_read_scan(nodes[k], path, timed) for k in range(len(nodes))]
    scans = [scan for scan in scans if scan.count]
    if not scans:
        raise InputError(error("file.no_points", file=str(path)))
    for before, after in pairwise(scans):
        if set(before.fields) != set(after.fields):
            raise InputError(error("e57.different_fields", file=str(path)))
    return scans


def _read_scan(node: Any, path: Path, timed: bool) -> Scan:
    from pye57 import libe57

    points = node["points"]
    prototype = libe57.StructureNode(points.prototype())
    fields: dict[str, np.dtype[Any]] = {}
    single_time = False
    for k in range(prototype.childCount()):
        field = prototype.get(k)
        kind, name = field.type(), field.elementName()
        if kind == libe57.E57_INTEGER:
            fields[name] = np.dtype(np.int64)
        elif kind in (libe57.E57_FLOAT, libe57.E57_SCALED_INTEGER):
            fields[name] = np.dtype(np.float64)
        if name == "timeStamp" and kind == libe57.E57_FLOAT:
            single_time = libe57.FloatNode(field).precision() == libe57.E57_SINGLE
    if timed and fields and "timeStamp" not in fields:
        raise InputError(error("e57.no_time", file=str(path), fields=tuple(fields)))
    if single_time:
        fields["timeStamp"] = np.dtype(np.float32)
    if not any(set(axes) <= set(fields) for axes in (CARTESIAN_FIELDS, SPHERICAL_FIELDS)):
        raise InputError(error("e57.no_coordinates", file=str(path)))
    rotation, translation = _scan_pose(node, path)
    start = 0.0
    if node.isDefined("acquisitionStart"):
        start = float(node["acquisitionStart"]["dateTimeValue"].value())
    return Scan(node, int(points.childCount()), fields, start, rotation, translation)


def _scan_pose(node: Any, path: Path) -> tuple[Array, Array]:
    """Rotation matrix and translation from the scan to the file; the identity if not given.

    Raises
    ------
    InputError
        If its quaternion is not a unit quaternion.
    """
    rotation, translation = np.eye(3), np.zeros(3)
    if not node.isDefined("pose"):
        return rotation, translation
    pose = node["pose"]
    if pose.isDefined("translation"):
        translation = np.array([pose["translation"][axis].value() for axis in "xyz"], dtype=float)
    if pose.isDefined("rotation"):
        w, x, y, z = (float(pose["rotation"][axis].value()) for axis in "wxyz")
        norm = np.sqrt(w * w + x * x + y * y + z * z)
        if not 0.99 < norm < 1.01:
            raise InputError(error("e57.pose", file=str(path), norm=float(norm)))
        w, x, y, z = w / norm, x / norm, y / norm, z / norm
        rotation = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )
    return rotation, translation


def stored_points(
    image: Any, scan: Scan, path: Path, rows: int, before: int, *, timed: bool = True
) -> Iterator[dict[str, NDArray[Any]]]:
    """Columns of the valid points of a scan; the coordinates are named ``x``, ``y``, ``z``.

    Parameters
    ----------
    rows : int
        Largest number of points of a block.
    before : int
        Number of points of the scans before, for messages.
    timed : bool
        Whether a point needs a valid time.

    Raises
    ------
    InputError
        If the number of points differs from that of the header, or times are not usable.
    """
    done = 0
    for block in _read_columns(image, scan, tuple(scan.fields), rows):
        done += len(next(iter(block.values())))
        xyz, valid = _cartesian_coordinates(block)
        if timed:
            valid &= block.get(TIME_STATE, 0) == np.zeros(len(valid))
        block = {name: column[valid] for name, column in block.items() if name not in STATE_FIELDS}
        if not valid.any():
            continue
        if "timeStamp" in block:
            require_usable_points(xyz[valid], block["timeStamp"], path, before + done - len(valid))
        yield dict(zip("xyz", xyz[valid].T, strict=True)) | block
    if done != scan.count:
        raise InputError(error("e57.points_missing", file=str(path), header=scan.count, held=done))


def _read_columns(
    image: Any, scan: Scan, names: tuple[str, ...], rows: int
) -> Iterator[dict[str, NDArray[Any]]]:
    """Read the fields of all points of a scan, in blocks of points."""
    from pye57 import libe57

    rows = min(rows, scan.count)
    # Integers are also read as float64: on Linux, pye57 treats NumPy's int64 as 32 bits.
    columns = {
        name: np.empty(rows, np.float32 if scan.fields[name] == np.float32 else np.float64)
        for name in names
    }
    buffers = libe57.VectorSourceDestBuffer()
    for name, column in columns.items():
        buffers.append(libe57.SourceDestBuffer(image, name, column, rows, True, True))
    reader = scan.node["points"].reader(buffers)
    try:
        while count := reader.read():
            yield {
                name: column[:count].astype(scan.fields[name]) for name, column in columns.items()
            }
    finally:
        reader.close()


def invalid_count(image: Any, scan: Scan, *, timed: bool = True) -> int:
    """Number of points that a scan marks as invalid."""
    needed = (
        CARTESIAN_STATE,
        SPHERICAL_STATE,
        SPHERICAL_FIELDS[0],
        *((TIME_STATE,) if timed else ()),
    )
    names = tuple(name for name in needed if name in scan.fields)
    if not names:
        return 0
    count = 0
    for block in _read_columns(image, scan, names, POINTS_PER_CHUNK):
        cartesian, spherical = _valid_coordinates(block, set(scan.fields))
        valid = (cartesian | spherical) & (block.get(TIME_STATE, 0) == np.zeros(len(cartesian)))
        count += int((~valid).sum())
    return count


def _valid_coordinates(
    columns: Mapping[str, NDArray[Any]], fields: set[str]
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Flags (n,) of points with valid Cartesian and with valid spherical coordinates.

    Each type of coordinates has its own state (ASTM E2807, table 12). Spherical columns may be
    present without values, so a range of zero is not valid.
    """
    no_flags = np.zeros(len(next(iter(columns.values()))), dtype=bool)
    cartesian = spherical = no_flags
    if set(CARTESIAN_FIELDS) <= fields:
        cartesian = columns.get(CARTESIAN_STATE, no_flags) == 0
    if set(SPHERICAL_FIELDS) <= fields:
        spherical = (columns.get(SPHERICAL_STATE, no_flags) == 0) & (
            columns[SPHERICAL_FIELDS[0]] > 0
        )
    return cartesian, spherical


def _cartesian_coordinates(columns: dict[str, NDArray[Any]]) -> tuple[Array, NDArray[np.bool_]]:
    """Remove the coordinates (n, 3) from ``columns``; return them and flags (n,) of valid ones."""
    cartesian, spherical = _valid_coordinates(columns, set(columns))
    xyz = np.zeros((len(cartesian), 3))
    if set(CARTESIAN_FIELDS) <= set(columns):
        xyz = np.stack([columns.pop(name) for name in CARTESIAN_FIELDS], axis=1).astype(np.float64)
    if set(SPHERICAL_FIELDS) <= set(columns):
        used = spherical & ~cartesian
        distance, azimuth, elevation = (columns.pop(name)[used] for name in SPHERICAL_FIELDS)
        flat = distance * np.cos(elevation)
        xyz[used] = np.stack(
            [flat * np.cos(azimuth), flat * np.sin(azimuth), distance * np.sin(elevation)], axis=1
        )
    return xyz, cartesian | spherical
