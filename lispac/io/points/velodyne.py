"""Reading of packets of Velodyne scanners in captures of a network (PCAP and PCAPNG).

The packets are decoded by velodyne-decoder, with the angles and offsets of the lasers that the
manuals give for each model. A packet has the time since the full hour only. The hour comes from the
GPRMC sentences of the position packets, else from the clock of the computer, else from the
trajectory.

Layout of the packets: Velodyne, VLP-16 User Manual, 63-9243 Rev. E, chapter 9.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import reduce
from itertools import islice
from operator import xor
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.first_points import check_first_points
from lispac.io.format_types import (
    IMPOSSIBLE,
    LIKELY,
    SURE,
    Choice,
    Fact,
    FileFormat,
    FilePreview,
    FormatOption,
    PointChunk,
)
from lispac.io.point_reader_common import (
    COMMON_OPTIONS,
    PREVIEW_POINTS,
    SCANNER_FRAME,
    coordinate_scale,
    frame_facts,
    head_sniffer,
    preview_table,
    report_damage,
    time_base_message,
    time_base_warnings,
)
from lispac.io.points.packet_capture import CAPTURE_KIND, UdpPacket, is_capture, read_udp_packets
from lispac.language import N_
from lispac.messages import Message, error, note, warning
from lispac.survey.line_source import printable
from lispac.survey.time_base import HOUR, base_of_key, plausible_bases

Array = NDArray[np.float64]

DATA_BYTES, POSITION_BYTES = 1206, 512
"""Sizes of the payloads of data packets and position packets."""
BLOCK_BYTES, FIRST_BANK, SECOND_BANK = 100, b"\xff\xee", b"\xff\xdd"
"""Bytes of a data block, and its first bytes for lasers 0 to 31 and 32 to 63."""
STAMP = slice(1200, 1204)
RETURN_MODES = (0x37, 0x38, 0x39)
"""Values of the byte before the model: the strongest return, the last one, or both."""
MODELS: Mapping[int, str] = {
    0x21: "HDL-32E", 0x22: "VLP-16", 0x24: "Puck Hi-Res", 0x28: "VLP-32C", 0xA1: "VLS-128",
}  # fmt: skip
"""Models that can be decoded, by the last byte of a data packet."""
OTHER_MODELS: Mapping[int, str] = {0x23: "VLP-32A/B", 0x31: "Velarray"}
HDL_64E = "HDL-64E"
POSITION_STAMP, POSITION_PPS, NMEA = slice(198, 202), 202, slice(206, 334)
PPS_LOCKED = 2
"""Value of the byte for the PPS signal when the clock of the scanner follows it."""

FROM_GPRMC, FROM_CAPTURE, FROM_TRAJECTORY = "gprmc", "capture", "trajectory"
HOUR_FROM_OPTION = FormatOption(
    "hour_from",
    N_(
        "Source of the full hour: GPRMC in the position packets, clock of the recording computer, "
        "or trajectory. Empty: the first of them that the file has."
    ),
    ("", FROM_GPRMC, FROM_CAPTURE, FROM_TRAJECTORY),
)
FIRST_PACKETS = 20_000
"""Number of packets at the beginning that are examined: at least 3 s."""
PACKETS_PER_CHUNK = 2600
"""Number of data packets of a chunk: a million points, at most 4 s."""
MAX_GPRMC_DELAY_S = 5.0
"""Largest difference of the clock of the scanner from the time in a GPRMC sentence, which arrives
up to a second later, if both are of the same second."""
MAX_COMPUTER_CLOCK_ERROR_S = 60.0
"""Largest difference of the clock of the computer from that of the scanner, apart from full hours,
for which its hour is used."""
MAX_CLOCK_STEP_S = 10.0
"""Change of the difference of both clocks above which one of them has been set."""
MAX_DECODED_RANGE_M = 1000.0
"""Range beyond that of all models; the option for the maximum range is applied later."""
PACKETS_PER_BATCH, MAX_GAP_IN_BATCH_S = 250, 1.0
"""Largest number of packets that are decoded together, and the longest gap between two of them. The
decoder counts the times of their points from one of the packets, in single precision."""


@dataclass
class _Scanner:
    """Scanner in a capture, with its clock.

    Attributes
    ----------
    number : int
        Number by its first packet, from 0.
    model : int
        Key of `MODELS`.
    hour : float, seconds
        Full hour of the latest packet: Unix time, or counted from that of the first packet.
    last : (float, float), seconds
        Time of the computer and time since the full hour of the latest packet.
    decoder : Any
        Decoder, which has a state.
    """

    number: int
    model: int
    hour: float
    last: tuple[float, float]
    decoder: Any


@dataclass(frozen=True)
class _HourSource:
    """Source of the full hour of the times.

    Attributes
    ----------
    name : str
        Value of `HOUR_FROM_OPTION`.
    assumption : Message
    ahead : float, seconds
        Time of the source minus that of the computer. Without an hour, the first packet has hour 0.
    clock_warnings : tuple of Message
    """

    name: str
    assumption: Message
    ahead: float
    clock_warnings: tuple[Message, ...] = ()

    @property
    def base_key(self) -> str:
        """Key of the time base of the points."""
        return "utc-hour" if self.name == FROM_TRAJECTORY else "unix"


@head_sniffer
def sniff(head: bytes, path: Path) -> float:
    """Likelihood by the signature of a capture and by the first packet of a Velodyne scanner."""
    if not is_capture(head):
        return IMPOSSIBLE
    packets = read_udp_packets(path, (DATA_BYTES,))
    # The packets of other devices in the same network may come first.
    return SURE if any(map(_is_data, islice(packets, 100))) else LIKELY


def _is_data(packet: UdpPacket) -> bool:
    return len(packet.payload) == DATA_BYTES and packet.payload.startswith(FIRST_BANK)


def _seconds(stamp: bytes) -> float:
    """Seconds since the full hour of a time stamp, which counts microseconds."""
    return int.from_bytes(stamp, "little") * 1e-6


def _require_known_model(payload: bytes, path: Path) -> int:
    """Model of a data packet.

    Raises
    ------
    InputError
        If packets of this model, or with these returns, cannot be decoded.
    """
    model = payload[-1]
    if payload[BLOCK_BYTES:].startswith(SECOND_BANK) and model != 0xA1:
        name = HDL_64E
    elif model in MODELS:
        if payload[-2] not in RETURN_MODES:
            raise InputError(error("velodyne.returns", file=str(path), mode=f"0x{payload[-2]:02X}"))
        return model
    else:
        name = OTHER_MODELS.get(model, f"0x{model:02X}")
    raise InputError(error("velodyne.model", file=str(path), model=name, models=[*MODELS.values()]))


def utc_of_rmc(sentence: bytes) -> float | None:
    """Unix time of a GPRMC sentence with a valid position (NMEA 0183); None for others."""
    text, _, checksum = sentence.partition(b"*")
    fields = text.split(b",")
    try:
        if fields[0][:1] != b"$" or fields[0][3:] != b"RMC" or fields[2] != b"A":
            return None
        if reduce(xor, text[1:], 0) != int(checksum[:2], 16):
            return None
        digits = (fields[9] + fields[1][:6]).decode("ascii")
        moment = datetime.strptime(digits, "%d%m%y%H%M%S").replace(tzinfo=UTC)
        return moment.timestamp() + float(b"0" + fields[1][6:])
    except (IndexError, ValueError):
        return None


def _examine_start(path: Path, hour_from: str) -> tuple[_HourSource, list[UdpPacket]]:
    """Examine the first packets: source of the full hour, and the data packets.

    Parameters
    ----------
    hour_from : str
        Given source of the hour; empty for the first one that the file has.

    Raises
    ------
    InputError
        If the file cannot be read, has no packets of a scanner that can be decoded, or does not
        have the given source of the hour.
    """
    sizes = (DATA_BYTES, POSITION_BYTES)
    packets = list(islice(read_udp_packets(path, sizes), FIRST_PACKETS))
    data = [packet for packet in packets if _is_data(packet)]
    if not data:
        raise InputError(error("velodyne.no_packets", file=str(path)))
    _require_known_model(data[0].payload, path)
    fixes = [
        (packet, moment)
        for packet in packets
        if len(packet.payload) == POSITION_BYTES
        and (moment := utc_of_rmc(packet.payload[NMEA])) is not None
    ]
    return _hour_source(path, hour_from, data[0], fixes), data


def _hour_source(
    path: Path, hour_from: str, first: UdpPacket, fixes: list[tuple[UdpPacket, float]]
) -> _HourSource:
    """Source of the full hour.

    Parameters
    ----------
    hour_from : str
        Given source; empty for the first one that the file has.
    first : UdpPacket
        First data packet.
    fixes : list of (UdpPacket, float)
        Position packets with a valid position, and its Unix time, seconds.

    Raises
    ------
    InputError
        If the file does not have the given source.
    """
    file, stamp = printable(path.name), _seconds(first.payload[STAMP])
    by_trajectory = note("assumed.hour_trajectory")
    if fixes and hour_from in ("", FROM_GPRMC):
        packet, moment = fixes[0]
        difference = _beyond_hours(moment - _seconds(packet.payload[POSITION_STAMP]))
        if abs(difference) > MAX_GPRMC_DELAY_S:
            off = warning("velodyne.not_synchronised", file=file, difference=difference)
            return _HourSource(FROM_TRAJECTORY, by_trajectory, stamp - first.time, (off,))
        is_locked = all(each.payload[POSITION_PPS] == PPS_LOCKED for each, _ in fixes)
        return _HourSource(
            FROM_GPRMC, note("assumed.hour_gprmc"), moment - packet.time,
            () if is_locked else (warning("velodyne.no_pps", file=file),),
        )  # fmt: skip
    if hour_from == FROM_GPRMC:
        raise InputError(error("velodyne.no_gprmc", file=str(path)))
    has_date = base_of_key("unix") in plausible_bases(np.array([first.time]))
    if hour_from == FROM_CAPTURE and not has_date:
        raise InputError(error("velodyne.no_date", file=str(path)))
    difference = _beyond_hours(first.time - stamp)
    is_near = abs(difference) <= MAX_COMPUTER_CLOCK_ERROR_S
    if hour_from == FROM_CAPTURE or (not hour_from and has_date and is_near):
        return _HourSource(FROM_CAPTURE, note("assumed.hour_capture", difference=difference), 0.0)
    return _HourSource(FROM_TRAJECTORY, by_trajectory, stamp - first.time)


def _beyond_hours(seconds: float) -> float:
    """Difference in seconds from the nearest number of full hours."""
    return seconds - HOUR * round(seconds / HOUR)


def _times(scanner: _Scanner, packets: list[UdpPacket], path: Path) -> Array:
    """Times of the packets of a scanner, shape (n,), seconds, and its clock after them.

    The hours are counted by the clock of the computer, because a capture may have gaps.

    Raises
    ------
    InputError
        If the clock of the scanner was set during the capture.
    """
    captured = np.array([scanner.last[0], *(packet.time for packet in packets)])
    stamp = np.array([scanner.last[1], *(_seconds(packet.payload[STAMP]) for packet in packets)])
    passed, counted = np.diff(captured), np.diff(stamp)
    hours = np.round((passed - counted) / HOUR)
    differ = np.abs(passed - counted - HOUR * hours) > MAX_CLOCK_STEP_S
    hours[differ] = np.round(-counted[differ] / HOUR)
    steps = counted + HOUR * hours
    if (wrong := differ & (np.abs(steps) > MAX_GAP_IN_BATCH_S)).any():
        step = float((steps - passed)[wrong][0])
        raise InputError(error("velodyne.clock_set", file=str(path), step=step))
    hour = scanner.hour + HOUR * np.cumsum(hours)
    scanner.hour, scanner.last = float(hour[-1]), (float(captured[-1]), float(stamp[-1]))
    return np.asarray(hour + stamp[1:])


def _decode(
    scanner: _Scanner, packets: list[UdpPacket], path: Path
) -> Iterator[tuple[NDArray[Any], Array]]:
    """Decode data packets of one scanner: fields of the points, and their times, seconds.

    Raises
    ------
    InputError
        If a packet is of another model than the first one, or the clock was set.
    """
    from velodyne_decoder import PacketVector, VelodynePacket
    from velodyne_decoder.velodyne_decoder_pylib import TimePair

    for packet in packets:
        model = _require_known_model(packet.payload, path)
        if model != scanner.model:
            names = [MODELS[scanner.model], MODELS[model]]
            raise InputError(error("velodyne.several_models", file=str(path), models=names))
    times = _times(scanner, packets, path)
    breaks = np.flatnonzero(np.abs(np.diff(times)) > MAX_GAP_IN_BATCH_S) + 1
    full = np.arange(PACKETS_PER_BATCH, len(times), PACKETS_PER_BATCH)
    for rows in np.split(np.arange(len(times)), np.union1d(breaks, full)):
        batch, origin = PacketVector(), times[rows[0]]
        for k in rows:
            stamp = times[k] - origin
            batch.append(VelodynePacket(TimePair(stamp, stamp), packets[k].payload))
        counted_from, points = scanner.decoder.decode(batch, as_pcl_structs=True)
        yield points, origin + (counted_from.device + points["time"].astype(np.float64))


def _add_scanners(
    scanners: dict[bytes, _Scanner], packets: list[UdpPacket], source: _HourSource, path: Path
) -> None:
    """Add the scanners whose first packets are among these, by their addresses.

    Raises
    ------
    InputError
        If packets of this model cannot be decoded.
    """
    from velodyne_decoder import Config, ScanDecoder

    for packet in packets:
        if packet.sender not in scanners:
            model, stamp = _require_known_model(packet.payload, path), packet.payload[STAMP]
            seconds = _seconds(stamp)
            hour = HOUR * round((packet.time + source.ahead - seconds) / HOUR)
            decoder = ScanDecoder(Config(min_range=0.0, max_range=MAX_DECODED_RANGE_M))
            scanners[packet.sender] = _Scanner(
                len(scanners), model, hour, (packet.time, seconds), decoder
            )


def _chunk(
    scanners: dict[bytes, _Scanner], packets: list[UdpPacket], source: _HourSource,
    resolved: Choice, path: Path,
) -> PointChunk | None:  # fmt: skip
    """Points of data packets, in the frame of Velodyne's manuals; None without any point.

    Raises
    ------
    InputError
        As `_decode`.
    """
    _add_scanners(scanners, packets, source, path)
    parts = [
        (scanner.number, *part)
        for sender, scanner in scanners.items()
        if (own := [packet for packet in packets if packet.sender == sender])
        for part in _decode(scanner, own, path)
    ]
    points = np.concatenate([points for _, points, _ in parts])
    if not len(points):
        return None
    # The axes of the decoder are those of ROS: forward, left, up.
    xyz = np.stack([-points["y"], points["x"], points["z"]], axis=1).astype(np.float64)
    extra: dict[str, NDArray[Any]] = {
        "intensity": points["intensity"].astype(np.uint16),
        "ring": points["ring"].astype(np.uint8),
        "return_type": points["return_type"].astype(np.uint8),
        "scanner_channel": np.concatenate(
            [np.full(len(points), number, np.uint8) for number, points, _ in parts]
        ),
    }
    time = np.concatenate([time for *_, time in parts])
    return PointChunk(xyz * coordinate_scale(resolved), time, extra)


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read the points of a capture in chunks, in the scanner frame.

    Attributes: ``intensity``, ``ring`` from the lowest laser upwards, ``return_type`` (1 strongest,
    2 last, 3 both, which are one point), and ``scanner_channel``, which numbers the scanners of the
    capture from 0.

    Raises
    ------
    InputError
        If the file is missing, damaged or cut, or has no packets that can be decoded.
    """
    resolved = VELODYNE_FORMAT.complete_options(choice)
    source, _ = _examine_start(path, str(resolved[HOUR_FROM_OPTION.name]))
    scanners: dict[bytes, _Scanner] = {}
    packets = filter(_is_data, read_udp_packets(path, (DATA_BYTES,)))
    while batch := list(islice(packets, PACKETS_PER_CHUNK)):
        with report_damage(path, CAPTURE_KIND):
            chunk = _chunk(scanners, batch, source, resolved, path)
        if chunk is not None:
            yield chunk


def preview_file(path: Path, choice: Choice) -> FilePreview:
    """Examine the first packets.

    Raises
    ------
    InputError
        If the file cannot be read or has no packets that can be decoded.
    """
    path = Path(path)
    resolved = VELODYNE_FORMAT.complete_options(choice)
    source, packets = _examine_start(path, str(resolved[HOUR_FROM_OPTION.name]))
    packets = packets[:PACKETS_PER_CHUNK]
    scanners: dict[bytes, _Scanner] = {}
    with report_damage(path, CAPTURE_KIND):
        chunk = _chunk(scanners, packets, source, {**resolved, "unit": "metre"}, path)
    if chunk is None:
        raise InputError(error("file.no_points", file=str(path)))
    file = printable(path.name)
    first = PointChunk(chunk.xyz[:PREVIEW_POINTS], chunk.time[:PREVIEW_POINTS], {})
    points_check = check_first_points(first.xyz, first.time, file=file, crs="")
    found = {
        "frame": SCANNER_FRAME, "time_base": source.base_key,
        HOUR_FROM_OPTION.name: source.name,
    }  # fmt: skip
    resolved = VELODYNE_FORMAT.complete_options({**found, **choice})
    base_key = str(resolved["time_base"])
    names = sorted({MODELS[scanner.model] for scanner in scanners.values()})
    is_dual = any(packet.payload[-2] == RETURN_MODES[-1] for packet in packets)
    record_bytes = DATA_BYTES + 58  # with the headers of record, Ethernet, IP and UDP
    estimate = len(chunk.time) / len(packets) * path.stat().st_size / record_bytes
    facts: dict[str, Fact] = {
        "format": note("fact.velodyne", models=names, count=len(scanners)),
        "points": note("fact.about", count=round(estimate)),
        "returns": note("fact.returns_dual" if is_dual else "fact.returns_single"),
        **frame_facts(resolved),
        "time base": time_base_message(first.time, base_key),
        **points_check.facts,
    }
    columns = {"x": chunk.xyz[:, 0], "y": chunk.xyz[:, 1], "z": chunk.xyz[:, 2],
               "time": chunk.time, **chunk.extra}  # fmt: skip
    return FilePreview(
        facts,
        preview_table(tuple(columns), tuple(columns.values())),
        found,
        (
            *source.clock_warnings,
            *points_check.file_warnings,
            *time_base_warnings(first.time, base_key, file),
        ),
        (
            note("assumed.velodyne_frame"), note("assumed.velodyne_angles"),
            source.assumption,
        ),
    )  # fmt: skip


VELODYNE_FORMAT = FileFormat(
    note("format.velodyne"),
    "velodyne",
    "points",
    (".pcap", ".pcapng"),
    (HOUR_FROM_OPTION, *COMMON_OPTIONS),
    sniff,
    preview_file,
    read,
    has_time_base=True,
)
