"""The port scene: a pier head with two boards, a 40 m tower and a warehouse (thesis 4.4, 4.5).

The local origin is on the water surface, on the course of the line along the quay wall, whose face
is 15 m to the east. The pier is short, so that the oblique courses pass its corners. Height 0 is
the water surface; the scanner is a little more than 3 m above it.
"""

import numpy as np

from lispac.simulation.scene import (
    Cylinder,
    Rectangle,
    Scene,
    Surface,
    box_faces,
    tilted_rectangle,
    upright_rectangle,
)
from lispac.simulation.vessel_motion import SailedLine

LOCAL_ORIGIN = (np.radians(45.5189), np.radians(-73.5390), -25.6)  # latitude, longitude, height
WALL_WEST = -15.0  # metres, local: the face of the quay wall
WALL_TOP_HEIGHT = 9.4
CONCRETE, STEEL, WHITE, BRICK = 0.35, 0.2, 0.85, 0.45
"""Reflectances of surfaces."""

TARGET_NAMES = ("T1", "T2")
VALIDATION_NAMES = ("V1", "V2", "V3", "V4", "V5")


def port_scene() -> Scene:
    """Scene with two targets, five validation planes and the surrounding structures."""
    surfaces: list[Surface] = [
        *_target_boards(),
        *_pier_surfaces(),
        *_tower_surfaces(),
        *_warehouse_door(),
    ]
    return Scene.of(surfaces)


def _target_boards() -> list[Rectangle]:
    """Vertical target T1 and target T2, inclined by 45 deg, about 4 to 5.5 m above the scanner."""
    return [
        upright_rectangle("T1", (1.15, WALL_WEST + 0.30), 7.5, 8.72, 1.23, 270, WHITE),
        tilted_rectangle("T2", (-1.1, WALL_WEST + 0.62, 7.5), 1.23, 0.76, 270, 45, WHITE),
    ]


def _pier_surfaces() -> list[Surface]:
    fenders = [
        Cylinder("fender", north, WALL_WEST + 0.2, 0.4, 5.2, 0.35, STEEL)
        for north in (-9.5, -5.0, 5.0, 9.5)
    ]
    bollards = [
        Cylinder(
            "bollard", north, WALL_WEST - 0.4, WALL_TOP_HEIGHT, WALL_TOP_HEIGHT + 0.7, 0.22, STEEL
        )
        for north in (-7.0, 7.0)
    ]
    return [
        *box_faces("pier", (-11, 11), (-60, WALL_WEST), -1, WALL_TOP_HEIGHT, CONCRETE),
        *fenders,
        *bollards,
        Cylinder("mast", 9.0, WALL_WEST - 2.0, WALL_TOP_HEIGHT, 21.0, 0.12, STEEL),
    ]


def _tower_surfaces() -> list[Surface]:
    """An open steel tower.

    V1 is on its base at the height of the vessel, V2 extends from the water to 40 m, V3 and V4 are
    on the cabin at the top.
    """
    legs = [
        Cylinder("tower leg", north, west, 8.5, 42.0, 0.25, STEEL)
        for north in (27.0, 32.5)
        for west in (-24.8, -32.0)
    ]
    return [
        *box_faces("tower base", (25, 38), (-38, -22), -1, 8.5, CONCRETE),
        *legs,
        *box_faces("tower cabin", (26.5, 33.0), (-32.5, -24.5), 30.0, 42.0, STEEL),
        upright_rectangle("V1", (28.5, -21.75), 3.8, 7.8, 5.0, 270, WHITE),
        upright_rectangle("V2", (35.0, -21.2), 0.0, 40.0, 3.0, 270, CONCRETE),
        upright_rectangle("V3", (29.75, -24.2), 37.2, 41.2, 5.5, 270, BRICK),
        tilted_rectangle("V4", (29.75, -23.5, 33.2), 5.0, 3.5, 250, -12, WHITE),
    ]


def _warehouse_door() -> list[Rectangle]:
    """V5, a warehouse door at the height of the vessel, beside and behind the pier."""
    return [
        *box_faces("south quay", (-60, -20), (-80, -29), -1, 2.6, CONCRETE),
        *box_faces("warehouse", (-46, -27), (-55, -33), 2.6, 9.5, STEEL),
        upright_rectangle("V5", (-37.0, -32.7), 4.0, 8.4, 14.0, 270, BRICK),
    ]


def six_lines(distance: float = 15.0) -> tuple[SailedLine, ...]:
    """The six lines of the thesis (figure 3.3), which all pass the boards at ``distance``, metres.

    Two lines run along the wall, four at 45 deg to it. The oblique ones are recorded up to 3 m
    before the line of the wall and continue past the corner of the pier.
    """
    # Heading, bearing of the boards when abeam, recorded metres before and after abeam
    pattern = (
        (0, 90, 44, 40),
        (180, 90, 40, 44),
        (45, 135, 27, 10),
        (225, 135, 10, 27),
        (315, 45, 10, 27),
        (135, 45, 27, 10),
    )
    lines = []
    for heading_deg, bearing_deg, run_in, run_out in pattern:
        bearing = np.radians(bearing_deg)
        abeam = (-distance * np.cos(bearing), WALL_WEST + distance * np.sin(bearing))
        starboard = (bearing_deg - heading_deg) % 360 < 180
        lines.append(SailedLine(float(np.radians(heading_deg)), abeam, run_in, run_out, starboard))
    return tuple(lines)
