"""All formats of points, those with the most reliable detection first."""

from lispac.io.format_types import FileFormat
from lispac.io.las.las_chunks import LAS_FORMAT
from lispac.io.points.e57 import E57_FORMAT
from lispac.io.points.pcd import PCD_FORMAT
from lispac.io.points.ply import PLY_FORMAT
from lispac.io.text.plane_points import PLANE_FORMAT
from lispac.io.text.target_points import TARGET_FORMAT
from lispac.io.text.text_chunks import TEXT_FORMAT
from lispac.io.trajectory.cidco import CIDCO_FORMAT

POINT_FORMATS: tuple[FileFormat, ...] = (
    LAS_FORMAT,
    E57_FORMAT,
    PLY_FORMAT,
    PCD_FORMAT,
    CIDCO_FORMAT,
    PLANE_FORMAT,
    TARGET_FORMAT,
    TEXT_FORMAT,
)
