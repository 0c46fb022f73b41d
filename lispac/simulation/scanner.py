"""Simulation of rotating scanners: emitted pulses, surfaces hit, and recorded points.

Errors of the mounting are applied to the beams, not added to computed points. A pulse starts at the
position of the scanner according to the true lever arm, in the direction
``R_local_body R_body_lidar R_x u``, at its time plus the latency, and ends at the first surface.
The range offset is subtracted from the recorded range (thesis 3.4.2).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.geometry.rotations import rotation_matrix
from lispac.simulation.scene import Scene
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]
Axis = Literal["x", "z"]

# Largest distance between the two echoes of a pulse at an edge for which they merge into one wrong
# range.
MAX_MIXED_ECHO_DISTANCE = 1.0  # metres
# Smallest distance between these echoes for which the range counts as mixed.
MIN_MIXED_ECHO_DISTANCE = 0.01  # metres
PULSES_PER_BLOCK = 1 << 16  # pulses cast together


@dataclass(frozen=True)
class Scanner:
    """A scanner that rotates about an axis of the LiDAR frame; by default a 2D profiler.

    The direction of a beam with elevation ``e`` at angle ``a`` is
    ``(sin e, cos e cos a, cos e sin a)`` if the axis is x, and
    ``(cos e cos a, cos e sin a, sin e)`` if it is z. A profiler has the single elevation 0 and the
    axis x, so that ``x_lidar = 0`` for every point.

    The direction of a beam has two random errors. The recorded angle of rotation differs from the
    true one, and the beam leaves at an elevation that differs from its nominal, recorded elevation.

    Attributes
    ----------
    pulses_per_second : float
        Pulses of all beams over the whole rotation, as in data sheets; only those in the window
        are recorded.
    turns_per_second : float
    window : pair of float, radians
        First and last recorded angle if the site is to port; mirrored if it is to starboard.
    max_range : float, metres
    range_sigma, angle_sigma : float, metres and radians
        The sigma of the angle applies in the direction of rotation and perpendicular to it.
    divergence : float, radians
        Full angular width of the beam, which causes mixed ranges at edges.
    elevations : tuple of float, radians
        Elevations of the beams, in the order in which they fire.
    axis : {"x", "z"}
        Axis of rotation.
    min_range : float, metres
        Shorter ranges are not recorded.
    incidence_growth : float
        The sigma of a range is ``range_sigma / cos(incidence) ** incidence_growth``.
    grazing : float, radians
        Largest angle of incidence that gives an echo.
    """

    pulses_per_second: float
    turns_per_second: float = 50.0
    window: tuple[float, float] = (np.radians(-1.0), np.radians(67.0))
    max_range: float = 90.0
    range_sigma: float = 0.0025
    angle_sigma: float = np.radians(0.005)
    divergence: float = 0.0005
    elevations: tuple[float, ...] = (0.0,)
    axis: Axis = "x"
    min_range: float = 0.0
    incidence_growth: float = 0.0
    grazing: float = np.pi / 2

    def pulses(
        self, start: float, stop: float, starboard: bool
    ) -> tuple[Array, Array, NDArray[np.intp]]:
        """Pulses of all whole rotations in a time span, in order of time.

        Parameters
        ----------
        start, stop : float, seconds
        starboard : bool
            Whether the window faces starboard instead of port.

        Returns
        -------
        time : ndarray of shape (n,), seconds
        angle : ndarray of shape (n,), radians
            Axis x: from left (+y) over up (+z, pi/2) to right (pi). Axis z: from ahead (+x) to
            left (+y).
        beam : ndarray of shape (n,)
            Index into the elevations.
        """
        angle, delay, beam = self.turn(starboard)
        turns = np.arange(self.turns(start, stop))
        time = start + turns[:, None] / self.turns_per_second + delay
        return time.ravel(), np.tile(angle, len(turns)), np.tile(beam, len(turns))

    def turn(self, starboard: bool) -> tuple[Array, Array, NDArray[np.intp]]:
        """Angle, time from the first pulse in seconds, and beam of the pulses of one rotation."""
        speed = 2 * np.pi * self.turns_per_second  # rad/s
        first, last = self.window
        if starboard:
            first, last = (np.pi - last, np.pi - first) if self.axis == "x" else (-last, -first)
        angle = np.arange(first, last, speed / self.pulses_per_second)
        return angle, (angle - first) / speed, np.arange(len(angle)) % len(self.elevations)

    def turns(self, start: float, stop: float) -> int:
        """Number of whole rotations of the scanner in a time span; at least one."""
        return max(int((stop - start) * self.turns_per_second), 1)

    def directions(self, angle: Array, elevation: Array | float) -> Array:
        """Unit vectors in the direction of the beams, shape (n, 3), LiDAR frame.

        Parameters
        ----------
        angle : ndarray of shape (n,), radians
        elevation : float or ndarray of shape (n,), radians
        """
        level = np.cos(elevation)
        lateral = np.sin(elevation) * np.ones(len(angle))
        first, second = level * np.cos(angle), level * np.sin(angle)
        parts = (lateral, first, second) if self.axis == "x" else (first, second, lateral)
        return np.stack(parts, axis=1)


@dataclass(frozen=True, eq=False)
class Echoes:
    """Echoes of one line.

    Attributes
    ----------
    time : ndarray of shape (n,), seconds
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame, with the scanner's errors
    true_points_local : ndarray of shape (n, 3), metres, local
        Intersection of the centre of the beam with the surface.
    intensity : ndarray of shape (n,)
    label : ndarray of shape (n,)
        Index of the surface; -1 for a mixed range of two surfaces at an edge.
    """

    time: Array
    points_lidar: Array
    true_points_local: Array
    intensity: NDArray[np.uint16]
    label: NDArray[np.int16]


@dataclass(frozen=True, eq=False)
class _PulseHits:
    """Pulses that hit a surface, before range errors and recording."""

    time: Array
    angle: Array
    beam: NDArray[np.intp]
    distance: Array
    edge_distance: Array
    cosine: Array
    true_points_local: Array
    label: NDArray[np.int16]

    @classmethod
    def joined(cls, parts: Sequence["_PulseHits"]) -> "_PulseHits":
        columns = zip(*(vars(part).values() for part in parts), strict=True)
        return cls(*(np.concatenate(column) for column in columns))


class _RayIntersections(NamedTuple):
    """Rays and their intersections; label -1 if a ray hits nothing."""

    origins: Array
    directions: Array
    distance: Array
    label: NDArray[np.int16]
    cosine: Array

    @property
    def points_local(self) -> Array:
        """Intersections, shape (n, 3), metres, local."""
        return np.asarray(self.origins + self.distance[:, None] * self.directions)

    def of(self, chosen: NDArray[np.intp]) -> "_RayIntersections":
        """The rays with the indices ``chosen``."""
        return _RayIntersections(
            self.origins[chosen], self.directions[chosen], self.distance[chosen],
            self.label[chosen], self.cosine[chosen],
        )  # fmt: skip

    def filled_from(self, other: "_RayIntersections") -> "_RayIntersections":
        """Replace the rays that hit nothing, beside an edge, by the rays of ``other``."""
        is_hit = self.label >= 0
        return _RayIntersections(
            np.where(is_hit[:, None], self.origins, other.origins),
            np.where(is_hit[:, None], self.directions, other.directions),
            np.where(is_hit, self.distance, other.distance),
            np.where(is_hit, self.label, other.label),
            np.where(is_hit, self.cosine, other.cosine),
        )


def scan_scene(
    scanner: Scanner,
    scene: Scene,
    states: tuple[Array, Array, Array],
    recorded: tuple[float, float],
    starboard: bool,
    mounting: Mounting,
    generator: np.random.Generator | None,
) -> Echoes:
    """Scan the scene on one line.

    Parameters
    ----------
    states : tuple of ndarray of shape (n,), (n, 3), (n, 3)
        True time, position (local) and attitude relative to the local axes. They are interpolated
        linearly between two samples, as in georeferencing.
    recorded : pair of float, seconds
        Start and end of recording.
    starboard : bool
        Whether the site is to starboard.
    mounting : Mounting
        The true mounting. The recorded times do not include its latency, and the recorded ranges
        do not include its range offset.
    generator : numpy Generator or None
        None for a scanner without noise and beam divergence.
    """
    direction_generator = None if generator is None else generator.spawn(1)[0]
    hits = _intersect_pulses(
        scanner, scene, states, recorded, starboard, mounting, direction_generator
    )
    angle, distance, label = hits.angle, hits.distance, hits.label
    elevation = np.array(scanner.elevations)[hits.beam]
    brightness = 60000 * scene.reflectances[label] * hits.cosine
    if generator is not None:
        gap = np.abs(hits.edge_distance - distance)
        mixed = (gap > MIN_MIXED_ECHO_DISTANCE) & (gap < MAX_MIXED_ECHO_DISTANCE)
        share = generator.uniform(0, 1, len(angle))
        distance = np.where(mixed, distance + share * (hits.edge_distance - distance), distance)
        label = np.where(mixed, np.int16(-1), label)
        sigma = scanner.range_sigma / hits.cosine**scanner.incidence_growth
        distance = distance + sigma * generator.standard_normal(len(angle))
        angle = angle + scanner.angle_sigma * generator.standard_normal(len(angle))
        brightness = brightness * (1 + 0.05 * generator.standard_normal(len(angle)))
    reading = distance - mounting.range_offset
    points_lidar = reading[:, None] * scanner.directions(angle, elevation)
    intensity = np.clip(np.round(brightness), 0, 65535).astype(np.uint16)
    kept = np.flatnonzero(reading > scanner.min_range)
    return Echoes(
        hits.time[kept], points_lidar[kept], hits.true_points_local[kept],
        intensity[kept], label[kept],
    )  # fmt: skip


def _intersect_pulses(
    scanner: Scanner,
    scene: Scene,
    states: tuple[Array, Array, Array],
    recorded: tuple[float, float],
    starboard: bool,
    mounting: Mounting,
    direction_generator: np.random.Generator | None,
) -> _PulseHits:
    """Intersections of the pulses; with a generator, with errors of direction and divergence."""
    elevations = np.array(scanner.elevations)
    rotation_body_lidar = mounting.rotation_body_lidar
    if mounting.scan_angle_offset:
        turn = rotation_matrix(mounting.scan_angle_offset, 0.0, 0.0)
        rotation_body_lidar = rotation_body_lidar @ turn
    knots, position, attitude = states
    poses = np.hstack([position, attitude])

    def intersect(time: Array, angle: Array, elevation: Array) -> _RayIntersections:
        """Rays of the given pulses and their intersections."""
        at = time + mounting.latency
        # Only the samples around these pulses are passed, because the kernel steps through them.
        first = max(int(np.searchsorted(knots, at[0])) - 1, 0)
        last = int(np.searchsorted(knots, at[-1])) + 1
        origins, directions = np.empty((len(at), 3)), np.empty((len(at), 3))
        _emit_beams(
            at, angle, elevation, scanner.axis == "x", knots[first:last], poses[first:last],
            rotation_body_lidar, mounting.lever_arm, origins, directions,
        )  # fmt: skip
        return _RayIntersections(
            origins, directions, *scene.intersect(origins, directions, scanner.max_range)
        )

    parts = []
    angles, delay, beams = scanner.turn(starboard)
    count = scanner.turns(*recorded)
    turns_per_block = max(PULSES_PER_BLOCK // len(angles), 1)
    for begin in range(0, count, turns_per_block):
        # Pulses are cast in blocks: a scanner with many beams emits a hundred million in a minute.
        turns = np.arange(begin, min(begin + turns_per_block, count))
        time = (recorded[0] + turns[:, None] / scanner.turns_per_second + delay).ravel()
        angle, beam = np.tile(angles, len(turns)), np.tile(beams, len(turns))
        found = intersect(time, angle, elevations[beam])
        hit = np.flatnonzero((found.label >= 0) & (found.cosine >= np.cos(scanner.grazing)))
        found = found.of(hit)
        elevation, edge_distance = elevations[beam[hit]], found.distance
        if direction_generator is not None and len(hit):
            draws = direction_generator.standard_normal(len(hit))
            elevation = elevation + scanner.angle_sigma * draws
            found = intersect(time[hit], angle[hit], elevation).filled_from(found)
            edge_distance = found.distance
        if direction_generator is not None and scanner.divergence > 0 and len(hit):
            # One more ray at the edge of the beam, alternating between both sides
            half = scanner.divergence / 2
            side = np.where((begin * len(angles) + hit) % 2 == 0, half, -half)
            rim = intersect(time[hit], angle[hit] + side, elevation)
            other = (rim.label >= 0) & (rim.label != found.label)
            edge_distance = np.where(other, rim.distance, found.distance)
        parts.append(
            _PulseHits(
                time[hit],
                angle[hit],
                beam[hit],
                found.distance,
                edge_distance,
                found.cosine,
                found.points_local,
                found.label,
            )
        )
    return _PulseHits.joined(parts)


@njit(nogil=True, cache=True)
def _emit_beams(  # type: ignore[no-untyped-def]
    time, angle, elevation, about_x, knots, states, rotation_body_lidar, lever_arm,
    origins, directions,
):  # fmt: skip
    rotation = np.empty((3, 3))
    k = 0
    for i in range(len(time)):
        while k < len(knots) - 2 and time[i] > knots[k + 1]:
            k += 1
        u = (time[i] - knots[k]) / (knots[k + 1] - knots[k])
        low, high = states[k], states[k + 1]
        cr, sr = _cosine_sine(low[3] + u * (high[3] - low[3]))
        cp, sp = _cosine_sine(low[4] + u * (high[4] - low[4]))
        cy, sy = _cosine_sine(low[5] + u * (high[5] - low[5]))
        # The rows of `lispac.geometry.rotations.rotation_matrix`
        rotation[0, 0], rotation[0, 1], rotation[0, 2] = (
            cy * cp, cr * sy + cy * sp * sr, cy * cr * sp - sy * sr,
        )  # fmt: skip
        rotation[1, 0], rotation[1, 1], rotation[1, 2] = (
            -cp * sy, cy * cr - sy * sp * sr, -cy * sr - cr * sy * sp,
        )  # fmt: skip
        rotation[2, 0], rotation[2, 1], rotation[2, 2] = -sp, cp * sr, cp * cr
        ox, oy, oz = _rotate(rotation, lever_arm[0], lever_arm[1], lever_arm[2])
        origins[i, 0] = ox + (low[0] + u * (high[0] - low[0]))
        origins[i, 1] = oy + (low[1] + u * (high[1] - low[1]))
        origins[i, 2] = oz + (low[2] + u * (high[2] - low[2]))
        ce, se = _cosine_sine(elevation[i])
        ca, sa = _cosine_sine(angle[i])
        if about_x:
            bx, by, bz = _rotate(rotation_body_lidar, se, ce * ca, ce * sa)
        else:
            bx, by, bz = _rotate(rotation_body_lidar, ce * ca, ce * sa, se)
        directions[i] = _rotate(rotation, bx, by, bz)


@njit(nogil=True, cache=True)
def _cosine_sine(angle):  # type: ignore[no-untyped-def]
    return np.cos(angle), np.sin(angle)


@njit(nogil=True, cache=True)
def _rotate(rotation, x, y, z):  # type: ignore[no-untyped-def]
    return (
        rotation[0, 0] * x + rotation[0, 1] * y + rotation[0, 2] * z,
        rotation[1, 0] * x + rotation[1, 1] * y + rotation[1, 2] * z,
        rotation[2, 0] * x + rotation[2, 1] * y + rotation[2, 2] * z,
    )
