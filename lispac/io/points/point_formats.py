"""All formats of points, those with the most reliable detection first."""

from lispac.io.format_types import FileFormat
from lispac.io.las.las_chunks import LAS
from lispac.io.points.e57 import E57
from lispac.io.points.pcd import PCD
from lispac.io.points.ply import PLY
from lispac.io.text.plane_points import PLANES
from lispac.io.text.target_points import TARGETS
from lispac.io.text.text_chunks import TEXT
from lispac.io.trajectory.cidco import CIDCO

POINTS: tuple[FileFormat, ...] = (LAS, E57, PLY, PCD, CIDCO, PLANES, TARGETS, TEXT)
