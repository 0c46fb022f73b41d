"""List of all supported file formats."""

from pathlib import Path

from lispac.errors import InputError
from lispac.io.format_types import IMPOSSIBLE, FileFormat, Kind
from lispac.io.las.las_chunks import LAS_FORMAT
from lispac.io.points.e57 import E57_FORMAT
from lispac.io.points.pcd import PCD_FORMAT
from lispac.io.points.ply import PLY_FORMAT
from lispac.io.points.velodyne import VELODYNE_FORMAT
from lispac.io.text.plane_points import PLANE_FORMAT
from lispac.io.text.target_points import TARGET_FORMAT
from lispac.io.text.text_chunks import TEXT_FORMAT
from lispac.io.trajectory.ascii_trajectory import ASCII_FORMAT
from lispac.io.trajectory.cidco import CIDCO_FORMAT
from lispac.io.trajectory.cidco_states import CIDCO_ACCURACY_FORMAT, CIDCO_STATES_FORMAT
from lispac.io.trajectory.exail import EXAIL_ACCURACY_FORMAT, EXAIL_FORMAT
from lispac.io.trajectory.inertial_explorer import (
    INERTIAL_EXPLORER_ACCURACY_FORMAT,
    INERTIAL_EXPLORER_FORMAT,
)
from lispac.io.trajectory.pof import POF_FORMAT
from lispac.io.trajectory.pospac_text import POSPAC_ACCURACY_FORMAT, POSPAC_FORMAT
from lispac.io.trajectory.sbet_formats import SBET_FORMAT, SMRMSG_FORMAT
from lispac.messages import error

POINT_FORMATS: tuple[FileFormat, ...] = (
    LAS_FORMAT,
    E57_FORMAT,
    PLY_FORMAT,
    PCD_FORMAT,
    VELODYNE_FORMAT,
    CIDCO_FORMAT,
    PLANE_FORMAT,
    TARGET_FORMAT,
    TEXT_FORMAT,
)
TRAJECTORY_FORMATS: tuple[FileFormat, ...] = (
    SBET_FORMAT,
    EXAIL_FORMAT,
    POSPAC_FORMAT,
    INERTIAL_EXPLORER_FORMAT,
    POF_FORMAT,
    ASCII_FORMAT,
    CIDCO_STATES_FORMAT,
)
ACCURACY_FORMATS: tuple[FileFormat, ...] = (
    SMRMSG_FORMAT,
    EXAIL_ACCURACY_FORMAT,
    POSPAC_ACCURACY_FORMAT,
    INERTIAL_EXPLORER_ACCURACY_FORMAT,
    CIDCO_ACCURACY_FORMAT,
)

__all__ = [
    "ACCURACY_FORMATS",
    "POINT_FORMATS",
    "TRAJECTORY_FORMATS",
    "format_of",
    "formats_of",
    "is_las",
    "recognise_formats",
]


def formats_of(kind: Kind) -> tuple[FileFormat, ...]:
    """All formats of a kind, in the order of preference at equal likelihood."""
    return {
        "trajectory": TRAJECTORY_FORMATS,
        "accuracy": ACCURACY_FORMATS,
        "points": POINT_FORMATS,
    }[kind]


def format_of(key: str) -> FileFormat:
    """Format with a given key.

    Raises
    ------
    InputError
        If no format has that key.
    """
    known = {
        format.key: format for format in (*TRAJECTORY_FORMATS, *ACCURACY_FORMATS, *POINT_FORMATS)
    }
    if key not in known:
        raise InputError(error("formats.unknown", format=key, formats=tuple(known)))
    return known[key]


def is_las(path: Path) -> bool:
    """True if a line without a given format is LAS or LAZ and not text.

    Determined from the content, or from the file name extension if the file is missing or of an
    unknown format.
    """
    path, las = Path(path), format_of("las")
    if las.sniff(path) > IMPOSSIBLE:
        return True
    return path.suffix.lower() in las.endings and not recognise_formats(path, "points")


def recognise_formats(path: Path, kind: Kind) -> list[tuple[FileFormat, float]]:
    """Formats that a file may have, with their likelihoods, the most likely first.

    At equal likelihood, formats with the extension of the file come first, then the order is that
    of `formats_of`.
    """
    path = Path(path)
    if not path.is_file():
        return []  # a named pipe would wait for a writer
    found = [(format, format.sniff(path)) for format in formats_of(kind)]
    ending = path.suffix.lower()
    return sorted(
        ((format, confidence) for format, confidence in found if confidence > IMPOSSIBLE),
        key=lambda pair: (-pair[1], ending not in pair[0].endings),
    )
