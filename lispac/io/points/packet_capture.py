"""UDP packets in captures of a network (PCAP and PCAPNG), read one after the other by dpkt."""

from collections.abc import Iterator
from pathlib import Path
from typing import IO, NamedTuple

from lispac.errors import InputError
from lispac.io.point_reader_common import report_damage, require_not_empty
from lispac.messages import error

CAPTURE_KIND = "packet capture"
"""Word for these files in `lispac.io.files.require_file`."""
PCAPNG_SIGNATURE = b"\n\r\r\n"
SIGNATURES = (
    b"\xd4\xc3\xb2\xa1", b"\xa1\xb2\xc3\xd4", b"\x4d\x3c\xb2\xa1", b"\xa1\xb2\x3c\x4d",
    PCAPNG_SIGNATURE,
)  # fmt: skip
"""First bytes of captures: PCAP with microseconds and nanoseconds in either byte order, PCAPNG."""
MAX_RECORD_BYTES = 1 << 20
"""Largest accepted size of a record; the packets of a network have at most 65,535 bytes."""
PCAP_HEADER_BYTES, BLOCK_HEADER_BYTES = 16, 8
"""Bytes of the header of a record in PCAP, and of a block in PCAPNG."""
UDP_HEADER_BYTES, IP_HEADER_BYTES, UDP = 8, 20, 17


class UdpPacket(NamedTuple):
    """Contents of a UDP packet.

    Attributes
    ----------
    time : float, seconds
        Unix time at which the packet was captured, by the clock of the computer.
    sender : bytes
        IPv4 address of the sender; empty if it is not known.
    payload : bytes
    """

    time: float
    sender: bytes
    payload: bytes


def is_capture(head: bytes) -> bool:
    """Whether the first bytes of a file are those of a capture."""
    return head.startswith(SIGNATURES)


def read_udp_packets(path: Path, sizes: tuple[int, ...]) -> Iterator[UdpPacket]:
    """Read the UDP packets whose payloads have one of the given sizes in bytes, in file order.

    The payload is found from the end of a record by the length in its UDP header, so that the kind
    of network does not matter.

    Raises
    ------
    InputError
        If the file is missing, empty, damaged or cut, or not a capture.
    """
    import dpkt

    path = require_not_empty(path, CAPTURE_KIND)
    with path.open("rb") as file:
        head = file.read(len(PCAPNG_SIGNATURE))
        if not is_capture(head):
            raise InputError(error("capture.header", file=str(path)))
        file.seek(0)
        block = BLOCK_HEADER_BYTES if head == PCAPNG_SIGNATURE else PCAP_HEADER_BYTES
        with report_damage(path, CAPTURE_KIND):
            for time, record in dpkt.pcap.UniversalReader(_CheckedFile(file, path, block)):
                for size in sizes:
                    if packet := _udp_packet(float(time), record, size):
                        yield packet


def _udp_packet(time: float, record: bytes, size: int) -> UdpPacket | None:
    start = len(record) - size
    udp = start - UDP_HEADER_BYTES
    if udp < 0 or int.from_bytes(record[udp + 4 : udp + 6], "big") != UDP_HEADER_BYTES + size:
        return None
    ip = record[max(udp - IP_HEADER_BYTES, 0) : udp]
    is_ipv4 = len(ip) == IP_HEADER_BYTES and ip[0] == 0x45 and ip[9] == UDP
    return UdpPacket(time, ip[12:16] if is_ipv4 else b"", record[start:])


class _CheckedFile:
    """File for dpkt, which does not notice a cut record and trusts any size.

    Parameters
    ----------
    header_bytes : int
        Size of the header of a record, before which the file may end.
    """

    def __init__(self, file: IO[bytes], path: Path, header_bytes: int) -> None:
        self._file, self._path, self._header_bytes = file, path, header_bytes
        self.name = path.name

    def seek(self, position: int) -> None:
        self._file.seek(position)

    def read(self, size: int) -> bytes:
        """Read ``size`` bytes, or none at the end of the file.

        Raises
        ------
        InputError
            If the file ends earlier, or no record has this size.
        """
        if not 0 <= size <= MAX_RECORD_BYTES:
            raise InputError(error("capture.record_size", file=str(self._path), size=size))
        data = self._file.read(size)
        if len(data) < size and (data or size != self._header_bytes):
            raise InputError(
                error("capture.cut", file=str(self._path), size=self._path.stat().st_size)
            )
        return data
