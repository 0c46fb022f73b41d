"""Chunked writing of clouds as LAS or LAZ with all attributes of their source.

A `RecordLayout` describes the records: those of the source if it is LAS, otherwise point format 6
or 7 with the other columns of the source as extra bytes.
"""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from copy import deepcopy
from dataclasses import dataclass, field
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from lazrs import LazrsError
from numpy.typing import NDArray

from lispac.errors import InputError, failure_reason
from lispac.geometry.frames import LocalFrame
from lispac.io.format_types import PointChunk
from lispac.io.las.las_chunks import MIXED_WAVEFORM_FORMATS, PackedColumns
from lispac.io.las.las_crs_writer import write_crs
from lispac.io.las.las_header_check import require_sound_header
from lispac.io.las.mounting_record import MountingRecord
from lispac.io.point_reader_common import damaged_file_error
from lispac.messages import Message, error, note
from lispac.survey.crs import CoordinateSystem
from lispac.survey.georeferencing import Mounting
from lispac.survey.kernels import integers_from_coordinates
from lispac.survey.line_source import printable
from lispac.version import __version__

if TYPE_CHECKING:
    import laspy

COORDINATE_STEP_M = 1e-4
"""Resolution of stored coordinates, metres; the scanner's points can be recovered to 0.1 mm."""
COORDINATE_STEP_DEG = 1e-9
"""Resolution of stored coordinates in degrees: 0.11 mm of latitude."""
COORDINATE_AND_TIME_DIMENSIONS = ("X", "Y", "Z", "gps_time")
WAVEFORM_DIMENSIONS = ("wavepacket_index", "x_t")
STANDARD_DIMENSIONS = {
    "intensity": "u2", "return_number": "u1", "number_of_returns": "u1", "classification": "u1",
    "user_data": "u1", "point_source_id": "u2", "scan_angle": "i2", "red": "u2", "green": "u2",
    "blue": "u2", "scan_direction_flag": "u1", "edge_of_flight_line": "u1", "scanner_channel": "u1",
    "synthetic": "u1", "key_point": "u1", "withheld": "u1", "overlap": "u1", "nir": "u2",
}  # fmt: skip
"""Dimensions of point formats 6 to 8 and the NumPy types that hold them."""
DIMENSION_BITS = {
    "scan_direction_flag": 1, "edge_of_flight_line": 1, "scanner_channel": 2, "synthetic": 1,
    "key_point": 1, "withheld": 1, "overlap": 1, "return_number": 4, "number_of_returns": 4,
}  # fmt: skip
"""Number of bits of dimensions that are smaller than a byte."""
COLOUR_DIMENSIONS = ("red", "green", "blue")
MAX_DIMENSION_NAME_LENGTH = 31


@dataclass(frozen=True, eq=False)
class RecordLayout:
    """Header, columns and constants of the records of a written cloud.

    Attributes
    ----------
    header : laspy.LasHeader
        Version, point format, time type and records besides the points; no coordinate system yet.
    columns : mapping of str to (str, int or None)
        For each dimension, the column of the source and the index of its part; None if the column
        has one value for each point.
    notes : tuple of Message
        Notes on attributes that are not kept.
    constants : mapping of str to int
        Dimensions with one value for all points.
    """

    header: "laspy.LasHeader"
    columns: Mapping[str, tuple[str, int | None]]
    notes: tuple[Message, ...] = ()
    constants: Mapping[str, int] = field(default_factory=dict)


def write_header_copy(path: Path, to: Path) -> None:
    """Write the header and records of a LAS or LAZ file as a LAS file without points.

    Raises
    ------
    InputError
        If the file cannot be read.
    """  # noqa: DOC501 - `damaged_file_error` makes an InputError
    import laspy
    from laspy.errors import LaspyException

    try:
        with laspy.open(path) as reader:
            header = deepcopy(reader.header)
        source_record = _extra_bytes_record(header)
        for records in (header.vlrs, header.evlrs or []):
            records[:] = [record for record in records if not _is_file_specific(record)]
        with to.open("wb") as file, laspy.LasWriter(file, header, closefd=False) as writer:
            if header.evlrs and header.version.minor >= 4:
                writer.write_evlrs(header.evlrs)
        with laspy.open(to) as reader:
            written_record = _extra_bytes_record(reader.header)
        if written_record != source_record:  # without points, laspy's bounds are meaningless
            to.write_bytes(to.read_bytes().replace(written_record, source_record, 1))
    except (LaspyException, LazrsError, ValueError) as failure:
        raise damaged_file_error(path, "LAS or LAZ", failure) from failure


def _extra_bytes_record(header: "laspy.LasHeader") -> bytes:
    """Record that describes the extra bytes; empty if there are none."""
    return b"".join(record.record_data_bytes() for record in header.vlrs.get("ExtraBytesVlr"))


def layout_of_las(path: Path, shown: Path | None = None) -> RecordLayout:
    """Record layout of a LAS or LAZ file: its own point format, extra bytes and records.

    Parameters
    ----------
    shown : Path, optional
        File named in notes, if the read file is a copy of it.

    Raises
    ------
    InputError
        If the file cannot be read.
    """  # noqa: DOC501 - `damaged_file_error` makes an InputError
    import laspy
    from laspy.errors import LaspyException

    path = Path(path)
    try:
        require_sound_header(path)
        with laspy.open(path) as reader:
            header = deepcopy(reader.header)
    except (LaspyException, LazrsError, OSError, ValueError) as failure:
        raise damaged_file_error(path, "LAS or LAZ", failure) from failure
    notes: tuple[Message, ...] = ()
    names = list(header.point_format.dimension_names)
    if all(name in names for name in WAVEFORM_DIMENSIONS):
        header.global_encoding.waveform_data_packets_internal = False
        header.global_encoding.waveform_data_packets_external = False
        header.start_of_waveform_data_packet_record = 0
        notes = (note("export.waveforms", file=printable((shown or path).name)),)
    for records in (header.vlrs, header.evlrs or []):
        records[:] = [record for record in records if not _is_file_specific(record)]
    header.creation_date = date.today()
    header.generating_software = f"LISPAC {__version__}"
    return RecordLayout(
        header,
        {name: (name, None) for name in names if name not in COORDINATE_AND_TIME_DIMENSIONS},
        notes,
    )


def _is_file_specific(record: Any) -> bool:
    """True if a record describes the storage of its own file: LAZ, COPC or waveforms."""
    waveforms = (record.user_id, record.record_id) == ("LASF_Spec", 65535)
    return waveforms or record.user_id in ("laszip encoded", "copc")


def layout_of_columns(chunk: PointChunk, *, standard_time: bool = False) -> RecordLayout:
    """Record layout of a source that is not LAS, from the names and types of its columns.

    A column is written to the LAS dimension of its name if all values of its type fit; otherwise it
    is written as extra bytes. An intensity that does not fit is written to both; in the dimension,
    real numbers are rounded and limited to 65535.

    Parameters
    ----------
    chunk : PointChunk
        A chunk of the source; only names and types are used.
    standard_time : bool
        Whether times are adjusted standard GPS time; otherwise GPS time of the week.
    """
    import laspy

    columns: dict[str, tuple[str, int | None]] = {}
    extra: list[laspy.ExtraBytesParams] = []
    notes: list[Message] = []
    used_names: set[str] = {*STANDARD_DIMENSIONS, *COORDINATE_AND_TIME_DIMENSIONS}
    for name, values in chunk.extra.items():
        if name in STANDARD_DIMENSIONS and _fits_dimension(name, values):
            columns[name] = (name, None)
            continue
        if values.dtype.kind not in "iufb" or values.dtype.itemsize > 8 or values.ndim > 2:
            notes.append(note("export.column_excluded", column=name))
            continue
        if name == "intensity" and values.ndim == 1:
            columns["intensity"] = (name, None)
        kind = "u1" if values.dtype.kind == "b" else "f4" if values.dtype == np.float16 else None
        parts = [None] if values.ndim == 1 else list(range(values.shape[1]))
        for part in parts:
            dimension = _free_dimension_name(
                name if part is None else f"{name}_{part + 1}", used_names
            )
            used_names.add(dimension)
            stored = np.dtype(kind or values.dtype.newbyteorder("="))
            extra.append(
                laspy.ExtraBytesParams(dimension, stored, name[:MAX_DIMENSION_NAME_LENGTH])
            )
            columns[dimension] = (name, part)
    number = (
        8 if "nir" in columns else 7 if any(name in columns for name in COLOUR_DIMENSIONS) else 6
    )
    header = laspy.LasHeader(point_format=number, version="1.4")
    header.add_extra_dims(extra)
    kinds = laspy.header.GpsTimeType
    header.global_encoding.gps_time_type = kinds.STANDARD if standard_time else kinds.WEEK_TIME
    header.generating_software = f"LISPAC {__version__}"
    constants = {name: 1 for name in ("return_number", "number_of_returns") if name not in columns}
    return RecordLayout(header, columns, tuple(notes), constants)


def _fits_dimension(name: str, values: NDArray[Any]) -> bool:
    if values.ndim != 1 or not np.can_cast(values.dtype, STANDARD_DIMENSIONS[name]):
        return False
    return name not in DIMENSION_BITS or int(values.max(initial=0)) < 1 << DIMENSION_BITS[name]


def _free_dimension_name(name: str, used_names: set[str]) -> str:
    plain = name.encode("ascii", "replace").decode().strip() or "column"
    if plain in STANDARD_DIMENSIONS or plain in COORDINATE_AND_TIME_DIMENSIONS:
        plain = f"source_{plain}"
    short, number = plain[:MAX_DIMENSION_NAME_LENGTH], 2
    while short in used_names:
        ending = f"_{number}"
        short = plain[: MAX_DIMENSION_NAME_LENGTH - len(ending)] + ending
        number += 1
    return short


class CloudWriter:
    """A LAS or LAZ file being written; made by `open_cloud_writer`."""

    def __init__(
        self, writer: "laspy.LasWriter", pattern: RecordLayout, header: "laspy.LasHeader",
        path: Path, *, one_channel: bool,
    ) -> None:  # fmt: skip
        self._writer = writer
        self._pattern = pattern
        self._header = header
        self._path = path
        self._one_channel = one_channel
        self._channels: set[int] = set()

    def records(
        self, points: NDArray[np.float64], time: NDArray[np.float64],
        extra: Mapping[str, NDArray[Any]], chosen: NDArray[np.bool_] | None = None,
    ) -> "laspy.ScaleAwarePointRecord":  # fmt: skip
        """Make records; may be called by several threads at once.

        Parameters
        ----------
        points : ndarray of shape (n, 3), in the file's coordinate system
        time : ndarray of shape (n,), seconds, as in the source
        extra : mapping of str to ndarray of shape (m, ...)
            The columns of the source.
        chosen : ndarray of bool, shape (m,), optional
            Flags of the n rows of ``extra`` that belong to these points; all by default.

        Raises
        ------
        InputError
            If a point lies too far from the others to be stored.
        """
        import laspy

        header = self._header
        packed = isinstance(extra, PackedColumns) and (
            extra.record.point_format == header.point_format
        )
        if packed:
            assert isinstance(extra, PackedColumns)
            array = extra.record.array
            record = laspy.ScaleAwarePointRecord(
                array if chosen is None else array[chosen], header.point_format,
                header.scales, header.offsets,
            )  # fmt: skip
        else:
            record = laspy.ScaleAwarePointRecord.zeros(len(points), header=header)
        raw = record.array
        if not integers_from_coordinates(
            points, np.asarray(header.offsets), np.asarray(header.scales),
            raw["X"], raw["Y"], raw["Z"],
        ):  # fmt: skip
            limit = round(2**31 * float(header.scales[0]))
            raise InputError(error("las.too_far", file=self._path.name, limit=limit))
        if packed:
            return record
        raw["gps_time"] = time
        bits: dict[str, NDArray[np.uint8]] = {}
        for dimension, (name, part) in self._pattern.columns.items():
            values = extra[name]
            if part is not None:
                values = values[:, part]
            if chosen is not None:
                values = values[chosen]
            if dimension == "intensity" and values.dtype.kind == "f":
                values = np.clip(np.rint(np.nan_to_num(values)), 0, 65535).astype(np.uint16)
            if dimension in record.sub_fields_dict:
                self._add_bits(bits, record, dimension, values)
            else:
                record[dimension][:] = values
        for dimension, value in self._pattern.constants.items():
            self._add_bits(bits, record, dimension, np.full(len(points), value, np.uint8))
        for field_name, byte in bits.items():
            raw[field_name] = byte
        return record

    def _add_bits(
        self, bits: dict[str, NDArray[np.uint8]], record: "laspy.ScaleAwarePointRecord",
        dimension: str, values: NDArray[Any],
    ) -> None:  # fmt: skip
        """Write values into their bits of the byte that several dimensions share.

        laspy's own method passes over the records four times for each dimension.

        Raises
        ------
        InputError
            If a value exceeds the bits of its dimension.
        """
        byte, place = record.sub_fields_dict[dimension]
        shift = (place.mask & -place.mask).bit_length() - 1
        largest = int(values.max(initial=0))
        if largest > place.mask >> shift:
            raise InputError(
                error(
                    "las.value_too_large", file=self._path.name, column=dimension, value=largest,
                    limit=int(place.mask >> shift),
                )
            )  # fmt: skip
        moved = values.astype(np.uint8) << np.uint8(shift)
        bits[byte] = bits[byte] | moved if byte in bits else moved

    def write(self, record: "laspy.ScaleAwarePointRecord") -> None:
        """Append records.

        Raises
        ------
        InputError
            If LAZ cannot store their waveform data.
        """
        if self._one_channel:
            self._channels |= set(np.unique(np.asarray(record["scanner_channel"])).tolist())
            if len(self._channels) > 1:
                number = self._header.point_format.id
                raise InputError(
                    error("las.waveform_channels", file=str(self._path), format=number)
                )
        self._writer.write_points(record)

    @property
    def count(self) -> int:
        """Number of points written so far."""
        return int(self._writer.header.point_count)


@contextmanager
def open_cloud_writer(
    path: Path,
    pattern: RecordLayout,
    system: CoordinateSystem | None,
    centre: NDArray[np.float64],
    *,
    mounting: Mounting,
    frame: LocalFrame,
    compressed: bool,
    shown: Path | None = None,
    is_trajectory_corrected: bool = False,
) -> Iterator[CloudWriter]:
    """Open a cloud for writing; on exit, its header and bounds are completed.

    Parameters
    ----------
    path : Path
        File to write, for example under a temporary name.
    system : CoordinateSystem or None
        None for the local frame.
    centre : ndarray of shape (3,), in the coordinate system
        A position among the points, used as the offset of the stored coordinates.
    mounting : Mounting
        Mounting with which the points are georeferenced; stored in the file.
    frame : LocalFrame
        Local frame of the project.
    compressed : bool
        Whether to write LAZ instead of LAS.
    shown : Path, optional
        File name given in errors.
    is_trajectory_corrected : bool
        Whether the points are georeferenced with the corrected trajectory; stored in the file.

    Raises
    ------
    InputError
        If the disk is full, or LAZ cannot store the waveform data of the points.
    """
    import laspy
    from laspy.errors import LaspyException

    shown = shown or path
    header = deepcopy(pattern.header)
    header.scales = coordinate_resolution(system)
    header.offsets = np.round(centre, 0)
    local = frame if system is None else system.frame
    write_crs(header, None if system is None or local is not None else system.written)
    header.vlrs.extend(MountingRecord(mounting, local, is_trajectory_corrected).vlrs())
    try:
        with (
            path.open("wb") as file,
            laspy.LasWriter(
                file,
                header,
                do_compress=compressed,
                closefd=False,
                laz_backend=laspy.LazBackend.LazrsParallel if compressed else None,
            ) as writer,
        ):
            mixes_up = compressed and header.point_format.id in MIXED_WAVEFORM_FORMATS
            yield CloudWriter(writer, pattern, header, shown, one_channel=mixes_up)
            if header.evlrs and header.version.minor >= 4:
                writer.write_evlrs(header.evlrs)
    except (LazrsError, OSError, LaspyException) as failure:
        reason = failure_reason(failure)
        raise InputError(error("las.not_writable", file=str(shown), reason=reason)) from failure


def coordinate_resolution(system: CoordinateSystem | None) -> NDArray[np.float64]:
    """Resolution of stored coordinates in their own units, shape (3,): 0.1 mm or finer."""
    if system is None:
        return np.full(3, COORDINATE_STEP_M)
    metres = np.array(system.metres)
    found = 10.0 ** np.floor(np.log10(COORDINATE_STEP_M / metres) + 1e-9)
    if system.is_geographic:
        found[:2] = COORDINATE_STEP_DEG
    return np.asarray(found)
