"""`Scan.fingerprint` of a stored line, computed without reading it into memory as a whole.

The fingerprint is a checksum of all coordinates followed by all times. Since CRC-32 is linear, the
checksums of both can be computed separately while points are read, and combined at the end.
"""

from dataclasses import dataclass
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

CRC32_POLYNOMIAL = 0xEDB88320
"""Generator polynomial of CRC-32, least significant bit first."""


@dataclass(frozen=True)
class RunningFingerprint:
    """Number of points so far, and the checksums of their coordinates and of their times."""

    points: int = 0
    coordinates: int = 0
    times: int = 0

    def after(
        self, points_lidar: NDArray[np.float64], time: NDArray[np.float64]
    ) -> "RunningFingerprint":
        """Fingerprint including the next points.

        Parameters
        ----------
        points_lidar : ndarray of shape (n, 3), metres
        time : ndarray of shape (n,), seconds
        """
        return RunningFingerprint(
            self.points + len(time),
            crc32(np.ascontiguousarray(points_lidar, dtype=np.float64).data, self.coordinates),
            crc32(np.ascontiguousarray(time, dtype=np.float64).data, self.times),
        )

    @property
    def fingerprint(self) -> str:
        """Fingerprint of all points so far; see `Scan.fingerprint`."""
        checksum = combine_crc32(self.coordinates, self.times, 8 * self.points)
        return f"{self.points}-{checksum:08x}"


def combine_crc32(first: int, second: int, length: int) -> int:
    """CRC-32 of two pieces of data one after the other; the second has ``length`` bytes.

    Appending a zero byte is a linear map of the bits of the first checksum. The map of ``length``
    zero bytes is a power of it, computed by repeated squaring.
    """
    one_bit = [CRC32_POLYNOMIAL] + [1 << k for k in range(31)]
    power = _square_gf2(_square_gf2(_square_gf2(one_bit)))  # one byte
    while length:
        if length & 1:
            first = _multiply_gf2(power, first)
        power = _square_gf2(power)
        length >>= 1
    return first ^ second


def _multiply_gf2(matrix: list[int], vector: int) -> int:
    total = 0
    for column in matrix:
        if vector & 1:
            total ^= column
        vector >>= 1
    return total


def _square_gf2(matrix: list[int]) -> list[int]:
    return [_multiply_gf2(matrix, column) for column in matrix]
