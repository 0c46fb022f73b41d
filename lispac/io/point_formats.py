"""All formats of points, the surer ones first."""

from lispac.io.cidco import CIDCO
from lispac.io.e57 import E57
from lispac.io.format_types import FileFormat
from lispac.io.las_chunks import LAS
from lispac.io.pcd import PCD
from lispac.io.plane_points import PLANES
from lispac.io.ply import PLY
from lispac.io.target_points import TARGETS
from lispac.io.text_chunks import TEXT

POINTS: tuple[FileFormat, ...] = (LAS, E57, PLY, PCD, CIDCO, PLANES, TARGETS, TEXT)
