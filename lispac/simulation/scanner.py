"""The 2D profiler: which pulses it sends, what they meet, and what it says it measured.

The misalignment is put into the beams themselves, not added to finished points: a pulse leaves
along ``R_local_body R_body_lidar u`` and stops at the first surface (thesis 3.4.2).
"""

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from lispac.geometry.rotations import rotation_matrix
from lispac.simulation.scene import Scene, heights_above, nearest_hit

Array = NDArray[np.float64]

# Echoes of one pulse closer than this melt into one wrong range; farther ones are told apart.
PULSE_LENGTH = 1.0  # metres
# Two surfaces meeting at an edge within this are no mixed echo.
SMALLEST_MIX = 0.01  # metres


@dataclass(frozen=True)
class Profiler:
    """A scanner that turns about its x axis: ``x_lidar = 0`` for every point.

    Attributes
    ----------
    pulses_per_second : float
        Over the whole turn, as a data sheet states it; the window keeps a part of them.
    profiles_per_second : float
    window : pair of float, radians
        Lowest and highest elevation recorded, on the side of the quay.
    max_range : float, metres
    range_sigma, angle_sigma : float, metres and radians
    divergence : float, radians
        Full width of the beam, which smears echoes at edges.
    """

    pulses_per_second: float
    profiles_per_second: float = 50.0
    window: tuple[float, float] = (np.radians(-1.0), np.radians(67.0))
    max_range: float = 90.0
    range_sigma: float = 0.0025
    angle_sigma: float = np.radians(0.005)
    divergence: float = 0.0005

    def pulses(self, start: float, stop: float, starboard: bool) -> tuple[Array, Array]:
        """Pulses of all whole profiles in a stretch of time.

        Parameters
        ----------
        start, stop : float, seconds
        starboard : bool
            Which side the window looks to.

        Returns
        -------
        time : ndarray of shape (n,), seconds
        angle : ndarray of shape (n,), radians
            From left (+y) over up (+z, pi/2) to right (pi).
        """
        turn = 2 * np.pi * self.profiles_per_second  # rad/s
        low, high = self.window
        first, last = (np.pi - high, np.pi - low) if starboard else (low, high)
        angle = np.arange(first, last, turn / self.pulses_per_second)
        profiles = np.arange(int((stop - start) * self.profiles_per_second))
        time = start + profiles[:, None] / self.profiles_per_second + (angle - first) / turn
        return time.ravel(), np.tile(angle, len(profiles))


@dataclass(frozen=True, eq=False)
class Echoes:
    """What came back from one pass.

    Attributes
    ----------
    time : ndarray of shape (n,), seconds
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame, with the scanner's errors
    true_points_local : ndarray of shape (n, 3), metres, local
        Where the middle of the beam met the surface.
    intensity : ndarray of shape (n,)
    label : ndarray of shape (n,)
        Index of the surface; -1 where the beam met an edge and the range is of neither.
    """

    time: Array
    points_lidar: Array
    true_points_local: Array
    intensity: NDArray[np.uint16]
    label: NDArray[np.int16]


def scan(
    profiler: Profiler,
    scene: Scene,
    states: tuple[Array, Array, Array],
    recorded: tuple[float, float],
    starboard: bool,
    lever_arm: Array,
    boresight: Array,
    generator: np.random.Generator | None,
) -> Echoes:
    """Scan the scene during one pass.

    Parameters
    ----------
    states : tuple of ndarray of shape (n,), (n, 3), (n, 3)
        True time, position (local) and attitude against the local axes. Between two samples the
        vessel is where linear interpolation puts it, which is all that a sampled POS can know.
    recorded : pair of float, seconds
    starboard : bool
        On which side the quay lies.
    lever_arm : ndarray of shape (3,), metres, body
    boresight : ndarray of shape (3,), radians; roll, pitch, yaw
    generator : numpy Generator or None
        None for a scanner without noise and without width of beam.
    """
    time, angle = profiler.pulses(*recorded, starboard)
    knots, position, attitude = states
    # Only the samples around the pass: the kernel walks through them pulse by pulse.
    first = max(int(np.searchsorted(knots, time[0])) - 1, 0)
    last = int(np.searchsorted(knots, time[-1])) + 1
    half_width = 0.0 if generator is None else profiler.divergence / 2
    true_points, measured = np.empty((len(time), 3)), np.empty((len(time), 3))
    label = np.empty(len(time), dtype=np.int16)
    _scan(
        time, angle, knots[first:last], np.hstack([position, attitude])[first:last],
        rotation_matrix(*boresight), lever_arm, profiler.max_range, half_width,
        scene.rectangles, scene.cylinders, true_points, measured, label,
    )  # fmt: skip
    hit = label >= 0
    time, angle, label = time[hit], angle[hit], label[hit]
    distance, edge_distance, cosine = measured[hit].T
    brightness = 60000 * scene.reflectances[label] * cosine
    if generator is not None:
        gap = np.abs(edge_distance - distance)
        mixed = (gap > SMALLEST_MIX) & (gap < PULSE_LENGTH)
        share = generator.uniform(0, 1, len(time))
        distance = np.where(mixed, distance + share * (edge_distance - distance), distance)
        label = np.where(mixed, np.int16(-1), label)
        distance = distance + profiler.range_sigma * generator.standard_normal(len(time))
        angle = angle + profiler.angle_sigma * generator.standard_normal(len(time))
        brightness = brightness * (1 + 0.05 * generator.standard_normal(len(time)))
    points_lidar = np.stack(
        [np.zeros(len(time)), distance * np.cos(angle), distance * np.sin(angle)], axis=1
    )
    intensity = np.clip(np.round(brightness), 0, 65535).astype(np.uint16)
    return Echoes(time, points_lidar, true_points[hit], intensity, label)


@njit(nogil=True, cache=True)
def _scan(  # type: ignore[no-untyped-def]
    time, angle, knots, states, rotation_body_lidar, lever_arm, max_range, half_width,
    rectangles, cylinders, true_points, measured, label,
):  # fmt: skip
    rotation, heights = np.empty((3, 3)), np.empty(len(rectangles))
    k = 0
    for i in range(len(time)):
        while k < len(knots) - 2 and time[i] > knots[k + 1]:
            k += 1
        u = (time[i] - knots[k]) / (knots[k + 1] - knots[k])
        low, high = states[k], states[k + 1]
        cr, sr = _cos_sin(low[3] + u * (high[3] - low[3]))
        cp, sp = _cos_sin(low[4] + u * (high[4] - low[4]))
        cy, sy = _cos_sin(low[5] + u * (high[5] - low[5]))
        # The rows of `lispac.geometry.rotations.rotation_matrix`
        rotation[0, 0], rotation[0, 1], rotation[0, 2] = (
            cy * cp, cr * sy + cy * sp * sr, cy * cr * sp - sy * sr,
        )  # fmt: skip
        rotation[1, 0], rotation[1, 1], rotation[1, 2] = (
            -cp * sy, cy * cr - sy * sp * sr, -cy * sr - cr * sy * sp,
        )  # fmt: skip
        rotation[2, 0], rotation[2, 1], rotation[2, 2] = -sp, cp * sr, cp * cr
        ox, oy, oz = _turn(rotation, lever_arm[0], lever_arm[1], lever_arm[2])
        ox += low[0] + u * (high[0] - low[0])
        oy += low[1] + u * (high[1] - low[1])
        oz += low[2] + u * (high[2] - low[2])
        heights_above(ox, oy, oz, rectangles, heights)
        dx, dy, dz = _beam(rotation, rotation_body_lidar, angle[i])
        distance, label[i], cosine = nearest_hit(
            ox, oy, oz, dx, dy, dz, max_range, rectangles, cylinders, heights
        )
        if label[i] < 0:
            continue
        true_points[i, 0] = ox + distance * dx
        true_points[i, 1] = oy + distance * dy
        true_points[i, 2] = oz + distance * dz
        measured[i, 0], measured[i, 1], measured[i, 2] = distance, distance, cosine
        if half_width > 0:
            # One more ray on the rim of the beam, on either side in turn
            side = half_width if i % 2 == 0 else -half_width
            dx, dy, dz = _beam(rotation, rotation_body_lidar, angle[i] + side)
            edge, edge_label, _ = nearest_hit(
                ox, oy, oz, dx, dy, dz, max_range, rectangles, cylinders, heights
            )
            if edge_label >= 0 and edge_label != label[i]:
                measured[i, 1] = edge


@njit(nogil=True, cache=True)
def _cos_sin(angle):  # type: ignore[no-untyped-def]
    return np.cos(angle), np.sin(angle)


@njit(nogil=True, cache=True)
def _turn(rotation, x, y, z):  # type: ignore[no-untyped-def]
    return (
        rotation[0, 0] * x + rotation[0, 1] * y + rotation[0, 2] * z,
        rotation[1, 0] * x + rotation[1, 1] * y + rotation[1, 2] * z,
        rotation[2, 0] * x + rotation[2, 1] * y + rotation[2, 2] * z,
    )


@njit(nogil=True, cache=True)
def _beam(rotation_local_body, rotation_body_lidar, angle):  # type: ignore[no-untyped-def]
    bx, by, bz = _turn(rotation_body_lidar, 0.0, np.cos(angle), np.sin(angle))
    return _turn(rotation_local_body, bx, by, bz)
