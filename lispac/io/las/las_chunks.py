"""Chunked reading of LAS and LAZ files with time and all attributes, in any frame."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.first_points import check_first_points
from lispac.io.format_types import (
    IMPOSSIBLE,
    SAME_TIME_BASE_NOTE,
    SURE,
    Choice,
    Fact,
    FileFormat,
    FilePreview,
    PointChunk,
)
from lispac.io.las.las_crs import HeaderCrs, read_header_crs
from lispac.io.las.las_crs_writer import is_in_local_frame
from lispac.io.las.las_header_check import require_sound_header
from lispac.io.las.mounting_record import MountingRecord
from lispac.io.point_reader_common import (
    COMMON_OPTIONS,
    GEOREFERENCED_FRAME,
    POINTS_PER_CHUNK,
    PREVIEW_POINTS,
    USE_FEET_ACTIONS,
    coordinate_scale,
    frame_facts,
    head_sniffer,
    preview_table,
    report_damage,
    require_not_empty,
    require_usable_points,
    time_base_message,
    time_base_warnings,
    usable_mask,
)
from lispac.messages import Message, error, note, warning
from lispac.survey.crs import local_frame_text
from lispac.survey.kernels import coordinates_from_integers
from lispac.survey.line_source import printable
from lispac.survey.point_screening import MAX_COORDINATE

if TYPE_CHECKING:
    import laspy

MAX_CHUNK_BYTES = 1 << 28
"""Largest number of bytes of point records read at once, whatever record size a header states."""
FOOT_CONVERSION_FACTORS = (0.3048, 1 / 0.3048)
WAVEFORM_POINT_FORMATS = (4, 5, 9, 10)
"""Point formats whose points refer to waveforms."""
MIXED_WAVEFORM_FORMATS = (9, 10)
"""Those of `WAVEFORM_POINT_FORMATS` whose waveform attributes lazrs 0.8 changes in LAZ with
several scanner channels."""
PREVIEW_COLUMNS = ("X", "Y", "Z", "gps_time", "intensity", "return_number", "classification")


class PackedColumns(Mapping[str, NDArray[Any]]):
    """Attributes of LAS points as a mapping of name to array, unpacked on access.

    A record packs several attributes into one byte and stores extra bytes as scaled integers. To
    copy points to another LAS file, use ``record``, which needs no unpacking and no rounding.

    Attributes
    ----------
    record : laspy.PackedPointRecord
        The points as stored in the file, with coordinates and time. Its coordinates may be
        overwritten when the points are written elsewhere; the chunk has its own coordinates.
    """

    def __init__(self, record: "laspy.PackedPointRecord", names: list[str]) -> None:
        self.record = record
        self._known: dict[str, NDArray[Any] | None] = dict.fromkeys(names)

    def __getitem__(self, name: str) -> NDArray[Any]:
        values = self._known[name]
        if values is None:
            values = self._known[name] = np.array(self.record[name])
        return values

    def rows(self, chosen: NDArray[np.bool_]) -> "PackedColumns":
        """Attributes of selected points, still packed; ``chosen`` has shape (n,)."""
        return PackedColumns(self.record[chosen], list(self._known))

    def __iter__(self) -> Iterator[str]:
        return iter(self._known)

    def __len__(self) -> int:
        return len(self._known)


@head_sniffer
def sniff(head: bytes, path: Path) -> float:
    """Likelihood by the signature: LAS and LAZ files start with ``LASF``."""
    return SURE if head[:4] == b"LASF" else IMPOSSIBLE


def preview_file(path: Path, choice: Choice) -> FilePreview:
    """Read the header and the first points.

    Raises
    ------
    InputError
        If the file cannot be read or has no time.
    """
    path = require_not_empty(path, "LAS")
    file = printable(path.name)
    with report_damage(path, "LAS or LAZ"), opened_las(path) as reader:
        header = reader.header
        record = MountingRecord.of(header)
        frame = None if record is None else record.frame
        if is_in_local_frame(header) and frame is None and "frame" not in choice:
            raise InputError(error("las.local_frame", file=str(path)))
        header_crs = read_header_crs(header, file)
        points = reader.read_points(min(PREVIEW_POINTS, _chunk_size(header)))
        xyz = np.stack([points.x, points.y, points.z], axis=1)
        time = np.asarray(points.gps_time)
        names = [name for name in header.point_format.dimension_names if name in PREVIEW_COLUMNS]
        values = [
            xyz[:, "XYZ".index(name)] if name in "XYZ" else np.asarray(points[name])
            for name in names
        ]
    require_usable_points(xyz, time, path)
    good = usable_mask(xyz, time)
    xyz, time = xyz[good], time[good]
    low, high = np.asarray(header.mins), np.asarray(header.maxs)
    bounded = bool((np.abs([low, high]) <= MAX_COORDINATE).all()) and bool(
        ((xyz >= low - 0.01) & (xyz <= high + 0.01)).all()
    )
    if not bounded:
        low, high = xyz.min(axis=0), xyz.max(axis=0)
    points_check = check_first_points(xyz, time, file=file, crs=header_crs.text, low=low, high=high)
    if frame is not None:  # the warnings on map coordinates do not apply there
        points_check = replace(points_check, frame=GEOREFERENCED_FRAME, file_warnings=())
    base = _time_base(header)
    found = {
        "frame": points_check.frame,
        "crs": header_crs.text if frame is None else local_frame_text(frame),
        "height_unit": header_crs.height_unit,
        "time_base": base,
    }
    resolved = LAS_FORMAT.complete_options({**found, **choice})
    compressed = "LAZ" if header.are_points_compressed else "LAS"
    facts: dict[str, Fact] = {
        "format": note(
            "fact.las", kind=compressed, version=str(header.version),
            number=int(header.point_format.id),
        ),
        "points": int(header.point_count),
        "coordinate system": header_crs.name or note("fact.none"),
        **frame_facts(resolved),
        "resolution": ", ".join(f"{scale:g}" for scale in header.scales),
        "time base": time_base_message(time, resolved["time_base"]),
        **points_check.facts,
        "attributes": ", ".join(header.point_format.dimension_names),
        "written by": _decode_text(header.generating_software) or note("fact.not_specified"),
    }  # fmt: skip
    return FilePreview(
        facts,
        preview_table(names, values),
        {name: value for name, value in found.items() if value},
        (
            *header_crs.file_warnings,
            *points_check.file_warnings,
            *(() if choice.get("time_base") else time_base_warnings(time, base, file)),
            *_header_warnings(header, header_crs.text, xyz, file),
        ),
        (SAME_TIME_BASE_NOTE, *_waveform_notes(header)),
        _header_messages(header_crs, choice, path),
    )


def read_messages(path: Path, choice: Choice) -> tuple[Message, ...]:
    """Messages of `preview_file`, from the header alone.

    Raises
    ------
    InputError
        If the header cannot be read or has no time.
    """
    path = require_not_empty(path, "LAS")
    with report_damage(path, "LAS or LAZ"), opened_las(path) as reader:
        header_crs = read_header_crs(reader.header, printable(path.name))
    return _header_messages(header_crs, choice, path)


def _header_messages(header_crs: HeaderCrs, choice: Choice, path: Path) -> tuple[Message, ...]:
    return (
        # A project stores the system that is used; the conflict is reported only with that one.
        *(header_crs.messages if choice.get("crs") in (None, "", header_crs.text) else ()),
        *require_sound_header(path).messages(path),
    )


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read a file in chunks; standard and extra dimensions keep their names and types.

    Raises
    ------
    InputError
        If the file is missing, damaged, cut short, empty, or without time.
    """
    return read_from_point(path, choice, 0)


def read_from_point(path: Path, choice: Choice, first: int) -> Iterator[PointChunk]:
    """Read in chunks from the point with index ``first``.

    LAZ is decoded from the beginning of the compressed chunk that contains the point, usually
    50,000 points.

    Raises
    ------
    InputError
        If the file is damaged or ends too early.
    """
    scale = coordinate_scale(LAS_FORMAT.complete_options(choice))
    path = require_not_empty(path, "LAS")
    with report_damage(path, "LAS or LAZ"), opened_las(path) as reader:
        header = reader.header
        others = [
            name for name in header.point_format.dimension_names
            if name not in ("X", "Y", "Z", "gps_time")
        ]  # fmt: skip
        done = min(first, header.point_count)
        if 0 < done < header.point_count:
            reader.seek(done)
        for points in _record_chunks(reader, path) if done < header.point_count else ():
            xyz = np.empty((len(points), 3))
            steps = (points.array[axis] for axis in "XYZ")
            coordinates_from_integers(
                *steps, np.asarray(header.scales), np.asarray(header.offsets), xyz
            )
            time = np.array(points.gps_time)
            require_usable_points(xyz, time, path, done)
            done += len(time)
            extra = PackedColumns(points, others)
            yield PointChunk(xyz * scale if scale != 1 else xyz, time, extra, header.point_count)
        if done != header.point_count:
            raise InputError(
                error("file.points_missing", file=str(path), header=header.point_count, held=done)
            )


def read_coordinates(path: Path) -> Iterator[NDArray[np.float64]]:
    """Read the coordinates, shape (n, 3), as stored in the file, of any point format.

    Raises
    ------
    InputError
        If the file is missing, damaged or empty.
    """
    path = require_not_empty(path, "LAS")
    with report_damage(path, "LAS or LAZ"), opened_las(path, timed=False) as reader:
        for points in _record_chunks(reader, path):
            yield np.stack([points.x, points.y, points.z], axis=1)


def read_file_crs(path: Path) -> HeaderCrs:
    """Coordinate system specified in the header, with messages about the header.

    Raises
    ------
    InputError
        If the file is damaged.
    """
    path = require_not_empty(path, "LAS")
    with report_damage(path, "LAS or LAZ"), opened_las(path, timed=False) as reader:
        header_crs = read_header_crs(reader.header, path.name)
    counts = require_sound_header(path).messages(path)
    return replace(header_crs, messages=(*header_crs.messages, *counts))


def point_count(path: Path) -> int:
    """Number of points in a LAS or LAZ file.

    Raises
    ------
    InputError
        If the file is damaged.
    """
    with report_damage(path, "LAS or LAZ"):
        return require_sound_header(path).stored


def opened_las(path: Path, *, timed: bool = True) -> "laspy.LasReader":
    """Open a file to read all points in it, even if its header states another number.

    Parameters
    ----------
    timed : bool
        Whether a point format without gps_time is refused.

    Raises
    ------
    InputError
        If the file is damaged, empty, or has no GPS time although ``timed``.
    """
    import laspy

    counts = require_sound_header(path)
    reader = laspy.open(path)
    header = reader.header
    header.point_count = counts.stored
    if timed and "gps_time" not in set(header.point_format.dimension_names):
        reader.close()
        raise InputError(error("las.no_gps_time", file=str(path), format=header.point_format.id))
    if header.point_count == 0:
        reader.close()
        raise InputError(error("file.no_points", file=str(path)))
    return reader


def _record_chunks(
    reader: "laspy.LasReader", path: Path
) -> Iterator["laspy.ScaleAwarePointRecord"]:
    """Points in chunks; raises an error if the file is truncated while it is read."""
    chunks = reader.chunk_iterator(_chunk_size(reader.header))
    while True:
        try:
            points = next(chunks, None)
        except Exception:  # laspy and its decoders raise errors of many types; all are re-raised
            if path.exists():
                require_sound_header(path)
            raise
        if points is None:
            return
        yield points


def _chunk_size(header: "laspy.LasHeader") -> int:
    return max(1, min(POINTS_PER_CHUNK, MAX_CHUNK_BYTES // header.point_format.size))


def _time_base(header: "laspy.LasHeader") -> str:
    import laspy

    if header.global_encoding.gps_time_type == laspy.header.GpsTimeType.STANDARD:
        return "gps-adjusted"
    return "gps-week"


def _waveform_notes(header: "laspy.LasHeader") -> Iterator[Message]:
    if header.point_format.id in WAVEFORM_POINT_FORMATS:
        yield note("assumed.waveforms")
        if header.are_points_compressed and header.point_format.id in MIXED_WAVEFORM_FORMATS:
            yield note("assumed.waveforms_mixed_up")


def _header_warnings(
    header: "laspy.LasHeader", crs: str, xyz: np.ndarray, file: str
) -> Iterator[Message]:
    """Warnings about coordinate scales that are too coarse or converted from feet."""
    geographic = bool(crs) and np.abs(xyz[:, :2]).max() <= 360
    for axis, scale in zip("xyz", header.scales, strict=True):
        metres = scale * 111_000 if geographic and axis != "z" else scale
        if metres > 0.002:
            yield warning("points.coarse_coordinates", file=file, step=float(metres), axis=axis)
            break
    for factor in FOOT_CONVERSION_FACTORS:
        power = np.log10(header.scales[0] / factor)
        if abs(power - round(power)) < 1e-4:
            yield warning(
                "points.resolution_in_feet", file=file, resolution=float(header.scales[0]),
                actions=USE_FEET_ACTIONS,
            )  # fmt: skip


def _decode_text(value: str | bytes) -> str:
    text = value.decode("ascii", "replace") if isinstance(value, bytes) else value
    return text.strip("\0 ")


LAS_FORMAT = FileFormat(
    note("format.las"),
    "las",
    "points",
    (".las", ".laz"),
    COMMON_OPTIONS,
    sniff,
    preview_file,
    read,
    read_from_point,
    read_messages,
)
