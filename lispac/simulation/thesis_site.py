"""The two sites of the thesis for the visibility of errors (sections 3.5 and 3.9).

A profiler passes one board on six straight lines, at constant speed and level, without noise. The
measurement contains one of eight systematic errors: the range is that at which the beam with the
error hits the plane of the board (3.4.2). The points are then georeferenced without the error.

Assumptions, because the thesis specifies them only in figures or not at all:

- An inclination is counted from the upright board, positive where its upper edge leans towards the
  vessel. With this sign, boards at +60 deg are parallel to the beams (figure 3.9), and boards of
  the marine site between 0 and 90 deg face the vessel.
- A board turns about its lower edge, which lies on the ground or on the edge of the quay: the 19
  inclinations of the terrestrial site cover the half circle above ground, and the 28 of the marine
  site cover 270 deg about the edge of a quay.
- All lines pass through one point abeam of the board, 5 m (terrestrial) or 15 m (marine) from the
  edge. The thesis gives no distance for the terrestrial site. With 5 m, boards at +60 deg are
  parallel to the beams, and the type I criterion accepts nearly the same inclinations as in the
  appendix. With 2 or 10 m, it does not.
- ``aimed`` beams are those that would hit the board without the error, and the plane of the board
  is unlimited. Only then are points displaced far if the board is nearly parallel to the beams, as
  described in 3.4.4.1. On a real board (``struck``), a point is displaced by at most its range
  times the error.
- A board is visible only from the front.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.planes import Plane, plane_axes, plane_through
from lispac.simulation.closed_form_survey import Board, Course, six_courses
from lispac.survey.georeferencing import MOUNTING_VALUE_NAMES, Mounting, place_points
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]
Beams = Literal["aimed", "struck"]

BOARD_SIDE = 1.0
"""Side of a board, metres."""

ERROR_SIZES: Mapping[str, float] = {
    "roll": np.radians(2.0),
    "pitch": np.radians(2.0),
    "yaw": np.radians(2.0),
    "lever_x": 0.1,
    "lever_y": 0.1,
    "lever_z": 0.1,
    "range_offset": 0.1,
    "scan_angle_offset": np.radians(2.0),
}
"""The eight errors of table 3.2, radians and metres."""

PROFILE_MARGINS: Mapping[Beams, float] = {"aimed": 0.0, "struck": np.radians(2.5)}
"""Extension of the profiles beyond the board, radians.

With an error, beams beside the board may hit it.
"""


@dataclass(frozen=True)
class ThesisSite:
    """Position of the board and geometry of the scan.

    Attributes
    ----------
    distance, rise : float, metres
        Horizontal distance when abeam, and height, of the board's lower edge from the scanner.
    inclinations : tuple of float, radians
    errors : tuple of str
        Studied errors, names of `ERROR_SIZES`.
    angle_step : float, radians
        Angle between the beams of a profile.
    profile_spacing : float, metres
        Distance between profiles along the line.
    """

    name: str
    distance: float
    rise: float
    inclinations: tuple[float, ...]
    errors: tuple[str, ...]
    angle_step: float
    profile_spacing: float

    def board(self, inclination: float) -> Board:
        """Board with an inclination, radians; its normal points to the side of its face."""
        cosine, sine = np.cos(inclination), np.sin(inclination)
        centre = (0.0, self.distance - BOARD_SIDE / 2 * sine, self.rise + BOARD_SIDE / 2 * cosine)
        return Board(
            f"{np.degrees(inclination):.0f}", centre, (0.0, -cosine, -sine), BOARD_SIDE, BOARD_SIDE
        )


def _angle_steps(first: int, last: int) -> tuple[float, ...]:
    return tuple(float(np.radians(degrees)) for degrees in range(first, last + 1, 10))


TERRESTRIAL_SITE = ThesisSite(
    "terrestrial",
    5.0,
    -2.5,
    _angle_steps(-90, 90),
    tuple(ERROR_SIZES),
    float(np.radians(0.2)),
    0.03,
)
MARINE_SITE = ThesisSite(
    "marine",
    15.0,
    5.0,
    _angle_steps(-90, 180),
    ("roll", "pitch", "yaw"),
    float(np.radians(0.1)),
    0.03,
)
SITES: Mapping[str, ThesisSite] = {site.name: site for site in (TERRESTRIAL_SITE, MARINE_SITE)}

LINES: tuple[Course, ...] = six_courses()
"""The six lines of the thesis."""
HEADINGS_DEG = tuple(round(float(np.degrees(course.heading))) for course in LINES)
"""Headings of the six lines, in the order of the thesis."""

ERROR_FREE_MOUNTING = Mounting(np.zeros(3), np.zeros(3))


def mounting_with_error(error: str, share: float = 1.0) -> Mounting:
    """True mounting with one of the eight errors, scaled by ``share``."""
    values = np.zeros(len(MOUNTING_VALUE_NAMES))
    values[MOUNTING_VALUE_NAMES.index(error)] = share * ERROR_SIZES[error]
    return Mounting.of_values(values)


def board_plane(board: Board) -> Plane:
    """Plane of a board, with the normal of its face."""
    return plane_through(np.array(board.centre), np.array(board.normal))


def is_on_board(points: Array, board: Board) -> NDArray[np.bool_]:
    """Whether each point of the plane of a board lies on the board, shape (n,).

    The thesis (3.4.3) compares the areas of four triangles instead.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local
    """
    along = (points - np.array(board.centre)) @ plane_axes(np.array(board.normal)).T
    inside: NDArray[np.bool_] = (np.abs(along) <= (board.width / 2, board.height / 2)).all(axis=1)
    return inside


def simulate_board(
    site: ThesisSite, course: Course, inclination: float, error: Mounting, beams: Beams = "aimed"
) -> Array:
    """Points of the board, georeferenced with a mounting without the error.

    Parameters
    ----------
    error : Mounting
        The true mounting.
    beams : {"aimed", "struck"}
        Beams that would hit the board without the error, or beams that hit it with the error.

    Returns
    -------
    ndarray of shape (n, 3), metres, local
        No points (``n`` = 0) if the board is visible only from behind.
    """
    board = site.board(inclination)
    directions, poses = _beams_and_poses(site, board, course, PROFILE_MARGINS[beams])
    ranges, hits = _intersect_board(directions, poses, error, board)
    is_hit = np.isfinite(ranges)
    if beams == "aimed":
        error_free, hits = _intersect_board(directions, poses, ERROR_FREE_MOUNTING, board)
        is_hit &= np.isfinite(error_free)
    is_hit[is_hit] = is_on_board(hits[is_hit], board)
    measured = directions[is_hit] * ranges[is_hit, None]
    return place_points(
        measured, Poses(poses.position[is_hit], poses.attitude[is_hit]), ERROR_FREE_MOUNTING
    )


def _beams_and_poses(
    site: ThesisSite, board: Board, course: Course, margin: float
) -> tuple[Array, Poses]:
    """Beams around the board, as unit vectors in the LiDAR frame, and the poses at their times."""
    ahead = course.direction
    left = np.array([np.sin(course.heading), np.cos(course.heading), 0.0])
    across, up = plane_axes(np.array(board.normal))
    corners = np.array(board.centre) + [
        (u * across + v * up) * BOARD_SIDE / 2 for u in (-1, 1) for v in (-1, 1)
    ]
    # Both grids are the same for lines run in opposite directions.
    edge = float(np.array([0.0, site.distance, 0.0]) @ ahead)
    angles = np.arctan2(corners[:, 2], corners @ left)
    middle = float(np.angle(np.exp(1j * angles).mean()))
    offsets = np.angle(np.exp(1j * (angles - middle)))
    reach = margin * float(np.linalg.norm(corners, axis=1).max())
    step = site.angle_step
    scan = step * np.arange(
        np.floor((middle + offsets.min() - margin) / step),
        np.ceil((middle + offsets.max() + margin) / step) + 1,
    )
    far = float(np.abs(corners @ ahead - edge).max()) + reach
    count = int(np.ceil(far / site.profile_spacing))
    along = edge + site.profile_spacing * (np.arange(-count, count) + 0.5)
    along, scan = (grid.ravel() for grid in np.meshgrid(along, scan))
    directions = np.column_stack([np.zeros_like(scan), np.cos(scan), np.sin(scan)])
    attitude = np.tile([0.0, 0.0, course.heading], (len(scan), 1))
    return directions, Poses(along[:, None] * ahead, attitude)


def _intersect_board(
    directions: Array, poses: Poses, mounting: Mounting, board: Board
) -> tuple[Array, Array]:
    """Intersections of beams with the front of a board's plane: ranges (n,), points (n, 3), metres.

    Recorded ranges of beams that come from behind, or do not hit the plane, are NaN.
    """
    # With any mounting, a range longer by one metre gives a point one metre farther on the beam.
    near, far = (
        place_points(directions, poses, mounting),
        place_points(2 * directions, poses, mounting),
    )
    plane = board_plane(board)
    rate = (far - near) @ plane.normal
    with np.errstate(divide="ignore", invalid="ignore"):
        readings = 1.0 - plane.distances(near) / rate
    readings = np.where((rate < 0) & (readings > 0), readings, np.nan)
    return readings, near + (readings - 1.0)[:, None] * (far - near)
