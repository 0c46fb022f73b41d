"""E57 with time stamps: every scan of the file one after the other, by libE57.

pye57's own reader knows no time stamps and reads scans as a whole, so its binding of libE57 is
used directly. libE57 checks every page against its checksum, which keeps damaged bytes from its
decoders.
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
from lispac.io.points import (
    CHUNK,
    GEOREFERENCED,
    PLACE,
    PREVIEW,
    base_doubts,
    place_facts,
    plainly,
    require_filled,
    require_points,
    scale_of,
    sniffer,
    table,
    time_base,
    usable_points,
)
from lispac.io.registry import NOT, SURE, Choice, Finding, Format, Option, PointChunk
from lispac.io.sight import sight

Array = NDArray[np.float64]

START, ZERO = "start", "zero"
TIME_FROM = Option(
    "time_from", "Whether time stamps count from the start of their scan, as the standard says, or "
    "from zero", (START, ZERO), START,
)  # fmt: skip
CARTESIAN = ("cartesianX", "cartesianY", "cartesianZ")
SPHERICAL = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
INVALID = ("cartesianInvalidState", "sphericalInvalidState", "isTimeStampInvalid")
DAY = 86_400.0
PAGE = 1024


@dataclass(frozen=True, eq=False)
class _Scan:
    """One scan: its points are read through ``node``."""

    node: Any
    count: int
    fields: Mapping[str, np.dtype[Any]]
    start: float
    rotation: Array
    translation: Array

    @property
    def has_pose(self) -> bool:
        return bool((self.rotation != np.eye(3)).any() or self.translation.any())


@sniffer
def sniff(head: bytes, path: Path) -> float:
    """E57 starts with its name."""
    return SURE if head[:8] == b"ASTM-E57" else NOT


def look(path: Path, choice: Choice) -> Finding:
    """Read what the file says of its scans, and the first points.

    Raises
    ------
    InputError
        Where the file cannot be read or has no time stamps.
    """
    path = require_filled(path, "E57")
    with plainly(path, "E57"), _opened(path) as image:
        scans = _scans(image, path)
        system = _text(image.root(), "coordinateMetadata")
        writer = _text(image.root(), "e57LibraryVersion")
        # A scan of which no point is valid is passed over, as where points are read.
        looked = (
            (scan, columns) for scan in scans for columns in _stored(image, scan, path, PREVIEW, 0)
        )
        scan, stored = next(looked, (scans[0], None))
        looked.close()
    if stored is None:
        raise InputError(f"{path}: this line holds no points; leave it out.")
    count = sum(scan.count for scan in scans)
    stamps = stored["timeStamp"]
    doubts: list[str] = []
    found = {"time_from": START, "crs": system}
    if stamps.max() > DAY:
        found["time_from"] = ZERO
        doubts.append(
            f"Time stamps such as {stamps[0]:.3f} are too large for the time since the start of a "
            "scan: taken as they are."
        )
    elif not all(scan.start for scan in scans):
        found["time_from"] = ZERO
        doubts.append("The scans do not say when they started: time stamps are taken as they are.")
    if any(scan.has_pose for scan in scans):
        doubts.append(
            "The scans have poses: they are applied where points are georeferenced, "
            "not in the scanner frame."
        )
    base = "gps-full" if {**found, **choice}["time_from"] == START else ""
    found["time_base"] = base
    posed = usable_points(_chunk(stored, scan, {"frame": GEOREFERENCED, **found}, count))
    seen = sight(posed.xyz, posed.time, crs=system)
    found["frame"] = seen.frame
    settled = E57.settled({**found, **choice})
    time = posed.time
    facts = {
        "format": "E57",
        "points": f"{count:,} in {len(scans):,} scans",
        "coordinate system": system[:200] or "none",
        **place_facts(settled),
        "time base": time_base(time, settled["time_base"]),
        **seen.facts,
        "fields": ", ".join(scan.fields),
        "written by": writer or "not stated",
        "assumed": "time stamps counted from the start of their scan"
        if settled["time_from"] == START
        else "time stamps as they are; points and trajectory share one time base",
    }
    names = tuple(stored)
    return Finding(
        facts,
        table(names, tuple(stored.values())),
        {name: value for name, value in found.items() if value},
        (*doubts, *seen.doubts, *base_doubts(time, base)),
    )


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read scan by scan in chunks; points that the file marks as invalid are left out.

    In the scanner frame poses are not applied; georeferenced points have them applied.

    Raises
    ------
    InputError
        Where the file is missing, damaged, empty, or without time stamps.
    """
    path = require_filled(path, "E57")
    settled = E57.settled(choice)
    done = 0
    with plainly(path, "E57"), _opened(path) as image:
        scans = _scans(image, path)
        total = sum(scan.count for scan in scans)
        if settled["time_from"] == START and not all(scan.start for scan in scans):
            raise InputError(
                f"{path}: the scans do not say when they started; take the time stamps as they "
                "are (option time_from: zero)."
            )
        for scan in scans:
            for stored in _stored(image, scan, path, CHUNK, done):
                done += len(stored["timeStamp"])
                yield _chunk(stored, scan, settled, total)


def places(path: Path) -> Iterator[Array]:
    """Coordinates alone, shape (n, 3), with the poses applied; valid points, timed or not.

    Raises
    ------
    InputError
        Where the file is missing, damaged or empty.
    """
    path = require_filled(path, "E57")
    with plainly(path, "E57"), _opened(path) as image:
        for scan in _scans(image, path, timed=False):
            for stored in _stored(image, scan, path, CHUNK, 0):
                xyz = np.stack([stored[axis] for axis in "xyz"], axis=1)
                yield xyz @ scan.rotation.T + scan.translation


def stated_of(path: Path) -> str:
    """Coordinate system as the file states it; empty where it does not.

    Raises
    ------
    InputError
    """
    path = require_filled(path, "E57")
    with plainly(path, "E57"), _opened(path) as image:
        return _text(image.root(), "coordinateMetadata")


@contextmanager
def _opened(path: Path) -> Iterator[Any]:
    _require_sound_header(path)
    try:
        from pye57 import libe57
    except ImportError as error:
        raise InputError(
            f"{path}: E57 cannot be read on this system (pye57 has no build for it); "
            "convert the file to LAZ."
        ) from error
    image = libe57.ImageFile(str(path), "r")
    try:
        yield image
    finally:
        image.close()


def _require_sound_header(path: Path) -> None:
    """Refuse a header that does not fit the file (ASTM E2807, table 1).

    Raises
    ------
    InputError
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        header = file.read(48)
    if len(header) < 48 or header[:8] != b"ASTM-E57":
        raise InputError(f"{path}: this is not E57: its header is missing or damaged.")
    length, xml_start, xml_length, page = struct.unpack_from("<4Q", header, 16)
    if length != size or page != PAGE or not 48 <= xml_start < size or xml_length > size:
        raise InputError(
            f"{path}: the header of this E57 file speaks of {length:,} bytes, it has {size:,}; "
            "it is cut short or damaged: copy or export it again."
        )


def _scans(image: Any, path: Path, *, timed: bool = True) -> list[_Scan]:
    nodes = image.root()["data3D"]
    scans = [_scan(nodes[k], path, timed) for k in range(len(nodes))]
    scans = [scan for scan in scans if scan.count]
    if not scans:
        raise InputError(f"{path}: this file holds no points; leave it out.")
    for before, after in pairwise(scans):
        if set(before.fields) != set(after.fields):
            raise InputError(f"{path}: its scans have different fields; export them one by one.")
    return scans


def _scan(node: Any, path: Path, timed: bool) -> _Scan:
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
    if timed and "timeStamp" not in fields:
        raise InputError(
            f"{path}: the points have no timeStamp (fields: {', '.join(fields) or 'none'}), so "
            "they cannot be put on the trajectory; export with time stamps."
        )
    if single_time:
        fields["timeStamp"] = np.dtype(np.float32)
    if not any(set(axes) <= set(fields) for axes in (CARTESIAN, SPHERICAL)):
        raise InputError(f"{path}: the points have no coordinates; export the file again.")
    rotation, translation = _pose(node)
    start = 0.0
    if node.isDefined("acquisitionStart"):
        start = float(node["acquisitionStart"]["dateTimeValue"].value())
    return _Scan(node, int(points.childCount()), fields, start, rotation, translation)


def _pose(node: Any) -> tuple[Array, Array]:
    """Rotation matrix and translation from the scan to the file; a part left out is zero.

    Raises
    ------
    ValueError
        Where its quaternion is no rotation.
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
            raise ValueError(f"the quaternion of a pose has length {norm:.3f}")
        w, x, y, z = w / norm, x / norm, y / norm, z / norm
        rotation = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )
    return rotation, translation


def _stored(
    image: Any, scan: _Scan, path: Path, rows: int, before: int
) -> Iterator[dict[str, NDArray[Any]]]:
    """Columns of the valid points of a scan, coordinates as ``x``, ``y``, ``z``.

    Raises
    ------
    InputError
        Where the scan holds fewer points than it promises.
    """
    from pye57 import libe57

    rows = min(rows, scan.count)
    # Whole numbers too are read as float64: pye57 takes NumPy's int64 for 32 bits on Linux.
    columns = {
        name: np.empty(rows, np.float32 if dtype == np.float32 else np.float64)
        for name, dtype in scan.fields.items()
    }
    buffers = libe57.VectorSourceDestBuffer()
    for name, column in columns.items():
        buffers.append(libe57.SourceDestBuffer(image, name, column, rows, True, True))
    reader = scan.node["points"].reader(buffers)
    done = 0
    try:
        while held := reader.read():
            done += held
            some = {
                name: column[:held].astype(scan.fields[name]) for name, column in columns.items()
            }
            valid = np.ones(held, dtype=bool)
            for name in INVALID:
                if name in some:
                    valid &= some.pop(name) == 0
            some = {name: column[valid] for name, column in some.items()}
            if not valid.any():
                continue
            xyz = _cartesian(some)
            if "timeStamp" in some:
                require_points(xyz, some["timeStamp"], path, before + done - held)
            yield dict(zip("xyz", xyz.T, strict=True)) | some
    finally:
        reader.close()
    if done != scan.count:
        raise InputError(
            f"{path}: a scan promises {scan.count:,} points and holds {done:,}; "
            "copy or export it again."
        )


def _cartesian(columns: dict[str, NDArray[Any]]) -> Array:
    """Coordinates, taken out of ``columns``."""
    if set(CARTESIAN) <= set(columns):
        return np.stack([columns.pop(name) for name in CARTESIAN], axis=1)
    distance, azimuth, elevation = (columns.pop(name) for name in SPHERICAL)
    flat = distance * np.cos(elevation)
    return np.stack(
        [flat * np.cos(azimuth), flat * np.sin(azimuth), distance * np.sin(elevation)], axis=1
    )


def _chunk(
    stored: Mapping[str, NDArray[Any]], scan: _Scan, settled: Choice, total: int
) -> PointChunk:
    xyz = np.stack([stored[axis] for axis in "xyz"], axis=1)
    if settled["frame"] == GEOREFERENCED:
        xyz = xyz @ scan.rotation.T + scan.translation
    else:
        xyz = xyz * scale_of(settled)
    time = stored["timeStamp"].astype(np.float64)
    if settled["time_from"] == START:
        time = time + scan.start
    own = (*"xyz", "timeStamp")
    extra = {name: values for name, values in stored.items() if name not in own}
    return PointChunk(xyz, time, extra, total)


def _text(root: Any, name: str) -> str:
    return str(root[name].value()).strip() if root.isDefined(name) else ""


E57 = Format("E57", "e57", "points", (".e57",), (TIME_FROM, *PLACE), sniff, look, read)
