"""Packets of a Velodyne VLP-16 and captures of them, written from the published layouts.

Packets: Velodyne, VLP-16 User Manual, 63-9243 Rev. E, chapter 9. Captures: draft-ietf-opsawg-pcap
and draft-ietf-opsawg-pcapng.
"""

import struct
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import reduce
from operator import xor
from pathlib import Path

import numpy as np

VLP_16, STRONGEST, LAST, DUAL = 0x22, 0x37, 0x38, 0x39
BLOCKS, CHANNELS, LASERS = 12, 32, 16
CYCLE_S, FIRING_S = 55.296e-6, 2.304e-6
"""Durations of a firing sequence of 16 lasers with its recharge time, and of one firing."""
ELEVATION_DEG = np.array([-15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15.0])
"""Vertical angle of each laser (table 9-1)."""
VERTICAL_CORRECTION_M = 1e-3 * np.array(
    [11.2, -0.7, 9.7, -2.2, 8.1, -3.7, 6.6, -5.1, 5.1, -6.6, 3.7, -8.1, 2.2, -9.7, 0.7, -11.2]
)
"""Height of each laser (table 9-1)."""
RING = np.argsort(np.argsort(ELEVATION_DEG))
DISTANCE_STEP_M, AZIMUTH_STEP_DEG = 0.002, 0.01
UTC = 1_700_000_000.0  # 2023-11-14 22:13:20
TOP_OF_HOUR = 1_699_999_200.0
ADDRESS = "192.168.1.201"


@dataclass
class Sent:
    """A payload with the time at which a computer captures it, and its sender."""

    time: float
    payload: bytes
    sender: str = ADDRESS


def channel_times() -> np.ndarray:
    """Time of each channel of each block after the time stamp, shape (12, 32), seconds."""
    sequence = 2 * np.arange(BLOCKS)[:, None] + np.arange(CHANNELS) // LASERS
    return CYCLE_S * sequence + FIRING_S * (np.arange(CHANNELS) % LASERS)


def data_packet(
    seconds: float,
    azimuth_deg: np.ndarray,
    distance: np.ndarray,
    reflectivity: np.ndarray | int = 0,
    *,
    mode: int = STRONGEST,
    model: int = VLP_16,
    bank: int = 0xEEFF,
) -> bytes:
    """Payload of a data packet.

    Parameters
    ----------
    seconds : float
        Time of the first firing since the full hour.
    azimuth_deg : ndarray of shape (12,)
    distance : ndarray of shape (12, 32), metres
        0 for no return.
    reflectivity : ndarray of shape (12, 32), or int
    """
    packed = np.zeros(BLOCKS, [("bank", "<u2"), ("azimuth", "<u2"), ("returns", RETURN, CHANNELS)])
    packed["bank"] = bank
    packed["azimuth"] = np.round(azimuth_deg / AZIMUTH_STEP_DEG).astype(int) % 36_000
    packed["returns"]["distance"] = np.round(distance / DISTANCE_STEP_M)
    packed["returns"]["reflectivity"] = reflectivity
    return packed.tobytes() + struct.pack("<IBB", round(seconds % 3600 * 1e6), mode, model)


RETURN = np.dtype([("distance", "<u2"), ("reflectivity", "u1")])


def rmc(
    moment: str = "221320.00", date: str = "141123", status: str = "A", talker: str = "GP"
) -> bytes:
    """Sentence RMC of NMEA 0183, by default at `UTC`, of a vessel at rest without a course."""
    text = f"{talker}RMC,{moment},{status},4826.1234,N,06831.4321,W,0.0,,{date},,,A".encode()
    return b"$%b*%02X\r\n" % (text, reduce(xor, text))


def position_packet(seconds: float, sentence: bytes, *, pps: int = 2) -> bytes:
    """Payload of a position packet; ``pps`` is 2 if the clock follows the PPS signal."""
    head = bytes(198) + struct.pack("<IB", round(seconds % 3600 * 1e6), pps)
    return (head + bytes(3) + sentence).ljust(512, b"\0")


def frame(sent: Sent, *, vlan: bool = False) -> bytes:
    """Ethernet frame with IPv4 and UDP."""
    port = 2368 if len(sent.payload) > 1000 else 8308
    udp = struct.pack(">HHHH", port, port, 8 + len(sent.payload), 0) + sent.payload
    sender = bytes(int(part) for part in sent.sender.split("."))
    ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), 0, 0, 64, 17, 0, sender, b"\xff" * 4)
    tag = b"\x81\x00\x00\x05" if vlan else b""
    return b"\xff" * 6 + b"\x60\x76\x88\x00\x00\x01" + tag + b"\x08\x00" + ip + udp


def write_pcap(
    path: Path, packets: Iterable[Sent], *, order: str = "<", nano: bool = False, vlan: bool = False
) -> Path:
    """Write a PCAP file in either byte order, with times in microseconds or nanoseconds."""
    unit = 1e9 if nano else 1e6
    with path.open("wb") as file:
        magic = 0xA1B23C4D if nano else 0xA1B2C3D4
        file.write(struct.pack(f"{order}IHHIIII", magic, 2, 4, 0, 0, 65_535, 1))
        for sent in packets:
            data, whole = frame(sent, vlan=vlan), int(sent.time)
            part = int((sent.time - whole) * unit)
            file.write(struct.pack(f"{order}IIII", whole, part, len(data), len(data)) + data)
    return path


def write_pcapng(path: Path, packets: Iterable[Sent]) -> Path:
    """Write a PCAPNG file as Wireshark does, with times in microseconds."""

    def block(kind: int, body: bytes) -> bytes:
        body += bytes(-len(body) % 4)
        size = struct.pack("<I", 12 + len(body))
        return struct.pack("<I", kind) + size + body + size

    parts = [block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1))]
    parts.append(block(1, struct.pack("<HHI", 1, 0, 65_535)))
    for sent in packets:
        data, ticks = frame(sent), round(sent.time * 1e6)
        head = struct.pack("<IIIII", 0, ticks >> 32, ticks & 0xFFFFFFFF, len(data), len(data))
        parts.append(block(6, head + data))
    path.write_bytes(b"".join(parts))
    return path


@dataclass
class Turning:
    """Packets of a rotating scanner, with the points that the manual gives for their contents.

    Parameters
    ----------
    rng : numpy.random.Generator
    start : float
        Unix time of the first packet.
    count : int
        Number of packets.
    mode : int
        Return mode of the packets.
    rate_deg : float
        Rotation, degrees per second.
    """

    rng: np.random.Generator
    start: float = UTC
    count: int = 30
    mode: int = STRONGEST
    rate_deg: float = 3600.0
    packets: list[Sent] = field(default_factory=list)
    xyz: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    time: np.ndarray = field(default_factory=lambda: np.zeros(0))
    ring: np.ndarray = field(default_factory=lambda: np.zeros(0, int))
    intensity: np.ndarray = field(default_factory=lambda: np.zeros(0, int))

    def __post_init__(self) -> None:
        parts: list[Sequence[np.ndarray]] = []
        step = 1 if self.mode != DUAL else 2
        after = channel_times()[np.arange(BLOCKS) // step]
        duration = 2 * CYCLE_S * BLOCKS / step
        for k in range(self.count):
            stamp = round((self.start + k * duration) * 1e6) / 1e6
            first = self.rate_deg * (stamp - self.start + after[:, 0])
            sent_azimuth = np.round(first / AZIMUTH_STEP_DEG) * AZIMUTH_STEP_DEG
            azimuth = sent_azimuth[:, None] + self.rate_deg * (after - after[:, :1])
            distance = DISTANCE_STEP_M * self.rng.integers(500, 50_000, (BLOCKS, CHANNELS))
            distance[self.rng.random(distance.shape) < 0.1] = 0
            reflectivity = self.rng.integers(0, 256, distance.shape)
            if step == 2:  # a third of the returns are both the last and the strongest
                same = self.rng.random((BLOCKS // 2, CHANNELS)) < 0.3
                distance[1::2][same] = distance[::2][same]
                reflectivity[1::2][same] = reflectivity[::2][same]
            payload = data_packet(stamp, sent_azimuth, distance, reflectivity, mode=self.mode)
            self.packets.append(Sent(stamp + 0.02, payload))
            kept = distance > 0
            if step == 2:
                kept[1::2] &= ~(same & (distance[::2] > 0))
            laser = np.broadcast_to(np.arange(CHANNELS) % LASERS, kept.shape)
            points = point_of(azimuth, distance, laser)
            values = (points, stamp + after, RING[laser], reflectivity)
            parts.append([each[kept] for each in values])
        columns = [np.concatenate(each) for each in zip(*parts, strict=True)]
        self.xyz, self.time, self.ring, self.intensity = columns


def point_of(azimuth_deg: np.ndarray, distance: np.ndarray, laser: np.ndarray) -> np.ndarray:
    """Point of a return in the frame of the manual, shape (..., 3), metres."""
    azimuth, elevation = np.radians(azimuth_deg), np.radians(ELEVATION_DEG[laser])
    horizontal = distance * np.cos(elevation)
    up = distance * np.sin(elevation) + VERTICAL_CORRECTION_M[laser]
    return np.stack([horizontal * np.sin(azimuth), horizontal * np.cos(azimuth), up], axis=-1)


def sorted_rows(time: np.ndarray, ring: np.ndarray, xyz: np.ndarray) -> np.ndarray:
    """Order of points by time, laser and distance."""
    return np.lexsort([np.linalg.norm(xyz, axis=1).round(2), ring, time.round(6)])


RESTING_COUNT = 60


def resting_points() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Coordinates, times and rings of the points of `write_resting`."""
    distance, azimuth = _resting_returns()
    packet, laser = np.divmod(np.arange(RESTING_COUNT), CHANNELS // 2)
    after = channel_times()[0, laser]
    return (
        point_of(azimuth[packet], distance, laser), TOP_OF_HOUR + 800.0 + packet * 0.01 + after,
        RING[laser],
    )  # fmt: skip


def _resting_returns() -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(5)
    return DISTANCE_STEP_M * rng.integers(500, 20_000, RESTING_COUNT), np.array([0.0, 90, 200, 300])


def write_resting(path: Path) -> Path:
    """Write few points, one for each laser and packet, of a scanner that does not rotate."""
    distance, azimuth = _resting_returns()
    packets = []
    for k in range(4):
        returns = np.zeros((BLOCKS, CHANNELS))
        own = distance[LASERS * k : LASERS * (k + 1)]
        returns[0, : len(own)] = own
        seconds = 800.0 + 0.01 * k
        payload = data_packet(seconds, np.full(BLOCKS, azimuth[k]), returns, 100)
        packets.append(Sent(TOP_OF_HOUR + seconds, payload))
    return write_pcap(path, packets)
