"""Error budget of a point by source and distance for one system (thesis table 1.3).

The derivatives are those of the adjustment (`adjustment.model.point_sensitivity`). The budget is
computed for given directions of the beam, because the effect of an angle depends on them: a
rotation about the beam itself does not move the point.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.point_sensitivity import Sensitivity, sensitivity
from lispac.errors import InputError
from lispac.language import N_
from lispac.messages import Message, error, note
from lispac.survey.georeferencing import (
    LEVER_ARM_NAMES,
    MOUNTING_VALUE_NAMES,
    Mounting,
    place_points,
    to_lidar,
)
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]

DEFAULT_DISTANCES = (10.0, 50.0, 100.0)
"""Default distances from the scanner, metres."""
DEFAULT_INCIDENCE = float(np.radians(45.0))
"""Default angle between the beam and the normal of the surface, radians."""
MAX_INCIDENCE = float(np.radians(85.0))
"""Largest angle of incidence, radians; beyond, the footprint is not limited by the surface."""
MAX_DIVERGENCE = 0.1
"""Largest beam divergence, radians."""
BEAM_DIRECTIONS: Mapping[str, tuple[float, float, float]] = {
    N_("horizontal, to starboard"): (0.0, -1.0, 0.0),
    N_("45 deg upwards, to starboard"): (0.0, -float(np.sqrt(0.5)), float(np.sqrt(0.5))),
}
"""Directions of the beam in the body frame (forward, left, up) of a level vessel heading north."""
POSITION_SOURCE, RANGE_SOURCE = N_("POS position"), N_("LiDAR range")
BEAM_ANGLE_SOURCE, LIDAR_NOISE_SOURCE = N_("LiDAR beam angle"), N_("LiDAR noise")
ATTITUDE_SOURCES = (N_("POS roll"), N_("POS pitch"), N_("POS heading"))
LEVER_ARM_SOURCE, LATENCY_SOURCE = N_("Lever arm"), N_("Latency")
FOOTPRINT_SOURCE = N_("Beam footprint")
OFFSET_SOURCES = {"range_offset": N_("Range offset"), "scan_angle_offset": N_("Scan-angle offset")}
PRIOR_BORESIGHT_SOURCE, ESTIMATED_BORESIGHT_SOURCE = (
    N_("Boresight before calibration"),
    N_("Boresight after calibration"),
)
TOTAL_BEFORE, TOTAL_AFTER = N_("Total before calibration"), N_("Total after calibration")
"""Names of the sources of error and of the totals, in English."""


@dataclass(frozen=True, eq=False)
class SystemErrors:
    """Standard deviations of one system, with the boresight before and after calibration.

    Attributes
    ----------
    position : ndarray of shape (3,), metres; north, west, up
    attitude : ndarray of shape (3,), radians; roll, pitch, heading
    lidar : float or pair of float
        Sigma on each axis of the LiDAR (metres), or sigmas of range (metres) and beam direction
        (radians).
    mounting : Mounting
        Estimated mounting.
    prior_boresight : ndarray of shape (3,), radians
    estimated : tuple of str
        Names of the values of the mounting with a covariance, from `MOUNTING_VALUE_NAMES`: those
        that were estimated, and the given lever arm if its sigmas are known.
    covariance : ndarray of shape (e, e), radians, metres, seconds
        Covariance of ``estimated``.
    speed : float, metres per second
    rates : ndarray of shape (3,), radians per second
        RMS rates of roll, pitch and heading; used only for the latency.
    divergence : float, radians, or None
        Full angle of the beam divergence; None if unknown.
    incidence : float, radians
        Angle between the beam and the normal of the surface; used only for the beam footprint.
    """

    position: Array
    attitude: Array
    lidar: float | tuple[float, float]
    mounting: Mounting
    prior_boresight: Array
    estimated: tuple[str, ...]
    covariance: Array
    speed: float
    rates: Array
    divergence: float | None = None
    incidence: float = DEFAULT_INCIDENCE


@dataclass(frozen=True)
class PointSigma:
    """Standard deviation of a point in several subspaces, metres.

    In two or three dimensions, it is the square root of the sum of the variances of the axes.

    Attributes
    ----------
    horizontal : float, metres
        In the horizontal plane.
    vertical : float, metres
    across : float, metres
        In the plane at right angles to the beam.
    total : float, metres
        In space.
    """

    horizontal: float
    vertical: float
    across: float
    total: float


@dataclass(frozen=True)
class SourceBudget:
    """Effect of one source at each distance; ``spreads`` is None if the source is unknown."""

    source: str
    spreads: tuple[PointSigma, ...] | None


@dataclass(frozen=True)
class BeamBudget:
    """All sources for one direction of the beam, and totals before and after calibration."""

    beam: str
    sources: tuple[SourceBudget, ...]
    before: SourceBudget
    after: SourceBudget


@dataclass(frozen=True)
class ErrorBudget:
    """Error budget of a system.

    Attributes
    ----------
    distances : tuple of float, metres
    beams : tuple of BeamBudget
    assumptions : tuple of Message
        Assumptions on which the budget is based.
    """

    distances: tuple[float, ...]
    beams: tuple[BeamBudget, ...]
    assumptions: tuple[Message, ...]


def error_budget(
    system: SystemErrors, distances: Sequence[float] = DEFAULT_DISTANCES
) -> ErrorBudget:
    """Compute the error of a point by source, at given distances from the scanner in metres.

    Raises
    ------
    InputError
        There is no distance, or a distance is not positive and finite, or the divergence or the
        angle of incidence is outside its limits.
    """
    if system.divergence is not None and not 0.0 <= system.divergence <= MAX_DIVERGENCE:
        raise InputError(error("adjustment.budget_divergence", most=1000 * MAX_DIVERGENCE))
    if not 0.0 <= system.incidence <= MAX_INCIDENCE:
        raise InputError(error("adjustment.budget_incidence", most=MAX_INCIDENCE))
    if not distances or not all(0.0 < each < np.inf for each in distances):
        raise InputError(error("adjustment.budget_distances"))
    chosen = tuple(sorted(set(map(float, distances))))
    beams = tuple(
        _beam_budget(name, np.array(beam_direction), system, chosen)
        for name, beam_direction in BEAM_DIRECTIONS.items()
    )
    return ErrorBudget(chosen, beams, tuple(_budget_assumptions(system)))


def _beam_budget(
    name: str, beam_direction: Array, system: SystemErrors, distances: Sequence[float]
) -> BeamBudget:
    found = [_covariance_by_source(beam_direction, system, distance) for distance in distances]
    sources = tuple(
        SourceBudget(source, _point_sigmas([each[source] for each in found], beam_direction))
        for source in found[0]
    )
    known = [{k: c for k, c in each.items() if c is not None} for each in found]
    totals = []
    for out in (ESTIMATED_BORESIGHT_SOURCE, PRIOR_BORESIGHT_SOURCE):
        # The other values are correlated with each other and with the estimated boresight.
        both = [
            sum((c for source, c in each.items() if source != out), np.zeros((3, 3)))
            + (
                _cross_covariance(beam_direction, system, far)
                if out == PRIOR_BORESIGHT_SOURCE
                else 0.0
            )
            for each, far in zip(known, distances, strict=True)
        ]
        totals.append(_point_sigmas(both, beam_direction))
    return BeamBudget(
        name, sources, SourceBudget(TOTAL_BEFORE, totals[0]), SourceBudget(TOTAL_AFTER, totals[1])
    )


def _point_pose_derivatives(
    beam_direction: Array, system: SystemErrors, distance: float
) -> tuple[Array, Poses, Sensitivity]:
    """Point in the LiDAR frame, pose, and derivatives of north, west and up of the point."""
    poses = Poses(np.zeros((3, 3)), np.zeros((3, 3)))
    local = np.tile(system.mounting.lever_arm + distance * beam_direction, (3, 1))
    points_lidar = to_lidar(local, poses, system.mounting)
    rate = np.tile([system.speed, 0.0, 0.0, *system.rates], (3, 1))
    moved = sensitivity(points_lidar, poses, system.mounting, np.eye(3), pose_rate=rate)
    return points_lidar, poses, moved


def _covariance_by_source(
    beam_direction: Array, system: SystemErrors, distance: float
) -> dict[str, Array | None]:
    """Covariance of the point by each source, shape (3, 3), square metres; None if unknown."""
    points_lidar, poses, moved = _point_pose_derivatives(beam_direction, system, distance)
    found: dict[str, Array | None] = {
        POSITION_SOURCE: _propagate_sigmas(moved.by_position, system.position)
    }
    for k, name in enumerate(ATTITUDE_SOURCES):
        found[name] = _propagate_sigmas(moved.by_attitude[:, [k]], system.attitude[[k]])
    if isinstance(system.lidar, tuple):
        reading = points_lidar[0]
        beam = reading / np.linalg.norm(reading)
        # The measured range, which differs from the distance by the range offset
        across = system.lidar[1] * float(np.linalg.norm(reading))
        along = np.outer(beam, beam)
        jacobian = moved.by_lidar
        found[RANGE_SOURCE] = system.lidar[0] ** 2 * (jacobian @ along @ jacobian.T)
        found[BEAM_ANGLE_SOURCE] = across**2 * (jacobian @ (np.eye(3) - along) @ jacobian.T)
    else:
        found[LIDAR_NOISE_SOURCE] = _propagate_sigmas(moved.by_lidar, np.full(3, system.lidar))
    found[FOOTPRINT_SOURCE] = (
        None
        if system.divergence is None
        else footprint_covariance(beam_direction, system.divergence, system.incidence, distance)
    )
    levers = [name for name in system.estimated if name in LEVER_ARM_NAMES]
    found[LEVER_ARM_SOURCE] = _estimated_covariance(moved, system, levers) if levers else None
    for name, words in OFFSET_SOURCES.items():
        if name in system.estimated:
            found[words] = _estimated_covariance(moved, system, [name])
    if "latency" in system.estimated:
        variance = system.covariance[(system.estimated.index("latency"),) * 2]
        # The correlation of speed and rates is unknown, so that their variances are added.
        rates = np.array([system.speed, *system.rates])
        moves = np.column_stack([moved.by_position[:, 0], moved.by_attitude])
        found[LATENCY_SOURCE] = _propagate_sigmas(moves, np.sqrt(variance) * rates)
    before = system.mounting.with_boresight(system.prior_boresight)
    # The actual error, not a standard deviation; it may be too large for a linearisation.
    off = (
        place_points(points_lidar, poses, before)
        - place_points(points_lidar, poses, system.mounting)
    )[0]
    found[PRIOR_BORESIGHT_SOURCE] = np.outer(off, off)
    found[ESTIMATED_BORESIGHT_SOURCE] = _estimated_covariance(
        moved, system, ["roll", "pitch", "yaw"]
    )
    return found


def footprint_covariance(
    beam_direction: Array, divergence: float, incidence: float, distance: float
) -> Array:
    """Covariance of a point by the size of the beam footprint, shape (3, 3), square metres.

    The place that reflects the pulse is anywhere in the footprint, while the point is put on the
    axis of the beam. With a uniform intensity over the cross-section, a disc of diameter
    ``d = divergence * distance``, the distance of this place from the axis has a variance of
    ``(d / 2)**2 / 4`` in each direction, so that ``sigma = d / 4``. (Lichti, Gordon and Tipdecho
    2005 include the width of the beam in an error budget as well.) On a surface at an angle of
    incidence ``i``, a place at a distance ``e`` from the axis in the plane of incidence has a range
    that differs by ``e * tan(i)``: along the beam, the standard deviation is ``tan(i) * d / 4``.
    The plane of incidence is unknown and all its directions are equally likely, so that the errors
    along and across the beam are not correlated.

    Parameters
    ----------
    beam_direction : ndarray of shape (3,), body frame
        Unit vector.
    divergence : float, radians
        Full angle.
    incidence : float, radians
        Angle between the beam and the normal of the surface.
    distance : float, metres
    """
    variance = (divergence * distance / 4) ** 2
    along = np.outer(beam_direction, beam_direction)
    return variance * (np.eye(3) - along + np.tan(incidence) ** 2 * along)


def _propagate_sigmas(jacobian: Array, sigma: Array) -> Array:
    """Covariance propagated from independent errors."""
    moves = jacobian * sigma
    return moves @ moves.T


def _estimated_covariance(
    sensitivity: Sensitivity, system: SystemErrors, names: Sequence[str]
) -> Array:
    """Covariance of the point from some of the estimated values."""
    chosen = [system.estimated.index(name) for name in names]
    jacobian = sensitivity.by_mounting[:, [MOUNTING_VALUE_NAMES.index(name) for name in names]]
    return jacobian @ system.covariance[np.ix_(chosen, chosen)] @ jacobian.T


def _cross_covariance(beam_direction: Array, system: SystemErrors, distance: float) -> Array:
    """Covariance of the point from correlations between groups of estimated values."""
    _, _, moved = _point_pose_derivatives(beam_direction, system, distance)
    names = [name for name in system.estimated if name != "latency"]
    groups = [["roll", "pitch", "yaw"], [n for n in names if n in LEVER_ARM_NAMES]]
    groups += [[name] for name in names if name in OFFSET_SOURCES]
    alone = sum(_estimated_covariance(moved, system, group) for group in groups if group)
    return _estimated_covariance(moved, system, names) - alone


def _point_sigmas(
    covariances: Sequence[Array | None], beam_direction: Array
) -> tuple[PointSigma, ...] | None:
    spreads = []
    for covariance in covariances:
        if covariance is None:
            return None
        # Because of rounding, a variance of zero may be slightly negative.
        north, west, up = np.maximum(np.diag(covariance), 0.0)
        total = north + west + up
        across = max(total - beam_direction @ covariance @ beam_direction, 0.0)
        spreads.append(PointSigma(*(float(np.sqrt(v)) for v in (north + west, up, across, total))))
    return tuple(spreads)


def _budget_assumptions(system: SystemErrors) -> list[Message]:
    north, east, up = map(float, system.position)
    roll, pitch, heading = map(float, system.attitude)
    found = [
        note("budget.geometry"),
        note(
            "budget.pos",
            north=north, east=east, up=up, roll=roll, pitch=pitch, heading=heading,
        ),
        note("budget.boresight"),
    ]  # fmt: skip
    if not isinstance(system.lidar, tuple):
        found.append(note("budget.lidar_per_axis"))
    if system.divergence is None:
        found.append(note("budget.footprint_unknown"))
    else:
        found.append(
            note(
                "budget.footprint",
                divergence=1000 * system.divergence,
                incidence=system.incidence,
            )
        )
    levers = len(set(LEVER_ARM_NAMES) & set(system.estimated))
    if levers == 0:
        found.append(note("budget.lever_arm_unknown"))
    elif levers < len(LEVER_ARM_NAMES):
        found.append(note("budget.lever_arm_estimated"))
    if "latency" in system.estimated:
        roll, pitch, heading = map(float, system.rates)
        found.append(
            note("budget.latency", speed=system.speed, roll=roll, pitch=pitch, heading=heading)
        )
    else:
        found.append(note("budget.no_latency"))
    return found
