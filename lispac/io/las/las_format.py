"""Reading of lines in the scanner frame from LAS and LAZ, and writing of clouds."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.io.files import atomic_write
from lispac.io.las.las_chunks import read
from lispac.messages import note
from lispac.survey.scan import Scan

SCANNER_FRAME_ASSUMPTIONS = (note("assumed.metres_in_scanner_frame"), note("assumed.las_time"))


def read_scan(path: Path) -> Scan:
    """Read one line in the LiDAR frame from LAS or LAZ.

    Raises
    ------
    InputError
        If the file is missing, damaged, without gps_time, or empty.
    """
    count = done = 0
    for chunk in read(Path(path), {}):
        if not done:
            count = chunk.total or 0
            points, time, intensity = np.empty((count, 3)), np.empty(count), np.empty(count)
        rows = slice(done, done + len(chunk.time))
        points[rows], time[rows] = chunk.xyz, chunk.time
        intensity[rows] = chunk.extra["intensity"]
        done = rows.stop
    return Scan(points, time, intensity, SCANNER_FRAME_ASSUMPTIONS)


def write_points(
    path: Path,
    points: NDArray[np.float64],
    time: NDArray[np.float64],
    intensity: NDArray[np.float64] | None = None,
    *,
    scale: float = 0.0001,
) -> None:
    """Write points with time as LAS 1.4 (LAZ by the ending), point format 6.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, any frame
    time : ndarray of shape (n,), seconds
    intensity : ndarray of shape (n,), 0 to 65535
    scale : float, metres
        Resolution of the stored coordinates.
    """
    import laspy

    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = np.full(3, scale)
    header.offsets = np.floor(points.min(axis=0)) if len(points) else np.zeros(3)
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    las.gps_time = time
    las.return_number[:] = 1
    las.number_of_returns[:] = 1
    if intensity is not None:
        las.intensity = intensity.astype(np.uint16)
    with atomic_write(path) as temporary:
        las.write(temporary)
