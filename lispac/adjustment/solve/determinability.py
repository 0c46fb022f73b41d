"""Determinability: parameters and angles that lines and targets do not determine."""

from contextlib import suppress
from dataclasses import replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import (
    MAX_PARAMETER_SIGMAS,
    ParameterEstimate,
    mounting_value_name,
)
from lispac.adjustment.model.target_shapes import points_local
from lispac.adjustment.result import ANGLES
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.errors import NotConverged, PlaneNotFound, RankDeficient
from lispac.geometry.planes import fit_plane
from lispac.geometry.rotations import rotation_matrix
from lispac.messages import Message, error, note
from lispac.survey.georeferencing import MOUNTING_VALUE_NAMES, Mounting

Array = NDArray[np.float64]

MAX_ANGLE_SIGMA = np.radians(1.0)
"""Largest sigma of a determined angle, radians; an inspection of the mounting is as precise."""

MAX_PARALLEL_ANGLE = np.radians(10.0)
"""Angle below which two lines, or two normals, are regarded as parallel, radians."""

_PLANE_LIMITS = np.array([MAX_ANGLE_SIGMA, MAX_ANGLE_SIGMA, 0.1])
"""Largest sigmas of a plane that is fixed by control: two rotations (radians), offset (metres)."""

ANGLE_CODES = {
    "roll": "adjustment.angle_roll",
    "pitch": "adjustment.angle_pitch",
    "yaw": "adjustment.angle_yaw",
}
"""Code of each angle's name as part of a message."""


def find_undetermined_parameters(linearised: LinearisedProblem) -> tuple[ParameterEstimate, ...]:
    """Find the parameters that the geometry does not determine, the worst first, with reasons.

    Parameters are removed one at a time, so that one of two parameters that cannot be separated
    from each other is kept.
    """
    problem = linearised.problem
    active = problem.active
    information = linearised.normal.information(len(active))
    limits = MAX_PARAMETER_SIGMAS[active]
    own = {p.index: p.sigma**-2 if p.sigma else 0.0 for p in problem.parameters}
    undetermined: list[ParameterEstimate] = []
    left = {p.index: p for p in problem.parameters}
    while left:
        free = information.copy()
        for index in left:
            k = int(np.searchsorted(active, index))
            free[k, k] -= own[index]
        fixed = {each.name for each in undetermined if each.prior_sigma is None}
        kept = np.array([MOUNTING_VALUE_NAMES[i] not in fixed for i in active])
        # Scaled by the limits; a weak prior keeps the matrix of unobserved values regular.
        scaled = (free * np.outer(limits, limits))[np.ix_(kept, kept)] + 1e-4 * np.eye(kept.sum())
        covariance = np.linalg.inv(scaled)
        sigmas = dict(zip(active[kept], np.sqrt(np.diag(covariance)), strict=True))
        worst = max(left, key=lambda index: sigmas[index])
        if sigmas[worst] <= 1:
            break
        k = int(np.searchsorted(active[kept], worst))
        undetermined.append(
            _undetermined_estimate(
                linearised, worst, covariance[k], active[kept], left[worst].sigma
            )
        )
        del left[worst]
    return tuple(undetermined)


def _undetermined_estimate(
    linearised: LinearisedProblem,
    index: int,
    row: Array,
    active: NDArray[np.int64],
    sigma: float | None,
) -> ParameterEstimate:
    name = MOUNTING_VALUE_NAMES[index]
    prior = float(linearised.problem.prior.values[index])
    shares = np.where(active == index, 0.0, np.abs(row))
    other = mounting_value_name(MOUNTING_VALUE_NAMES[int(active[np.argmax(shares)])])
    parameter = mounting_value_name(name)
    kept = note("parameter.kept_uncertain" if sigma else "parameter.kept")
    if name == "scan_angle_offset":
        reason = note("parameter.rotates_like_boresight", parameter=parameter, kept=kept)
    elif name == "lever_z":
        reason = note("parameter.raises_all_lines", parameter=parameter, kept=kept)
    else:
        reason = note("parameter.not_separated", parameter=parameter, other=other, kept=kept)
    return ParameterEstimate(name, prior, sigma, reason=reason)


def require_determined(linearised: LinearisedProblem) -> None:
    """Raise an error if the geometry does not determine an angle, in either stochastic model.

    Raises
    ------
    RankDeficient
        An angle is not determined; the message gives the reason: one line, parallel lines, one
        target or parallel normals.
    """
    problem = linearised.problem
    lines = problem.observations.lines
    if len(lines) < 2 and linearised.control is None and _is_single_heading(linearised):
        raise RankDeficient(error("adjustment.one_line", line=lines[0]))
    information = _with_correlated_pos_errors(linearised).normal.information(3)
    eigenvalues, directions = np.linalg.eigh(information)
    if eigenvalues[0] >= max(MAX_ANGLE_SIGMA**-2, 1e-12 * eigenvalues[2]):
        return
    # Spheres have no orientation.
    spheres = bool(problem.observations.is_sphere.all())
    action = note("adjustment.add_target" if spheres else "adjustment.add_orientation")
    direction, reason = angle_combination(directions[:, 0]), _reason_undetermined(linearised)
    if reason is None:
        raise RankDeficient(error("adjustment.undetermined", direction=direction, action=action))
    raise RankDeficient(
        error("adjustment.undetermined_because", direction=direction, reason=reason, action=action)
    )


def _reason_undetermined(linearised: LinearisedProblem) -> Message | None:
    """Reason why an angle is undetermined; None if there is no simple one."""
    targets = linearised.problem.observations.targets
    lines = linearised.problem.observations.lines
    parallel = _are_lines_parallel(linearised)
    if len(lines) == 1:
        return note("adjustment.single_line", line=lines[0])
    if len(targets) == 1:
        return note(
            "adjustment.parallel_lines_one_target" if parallel else "adjustment.single_target",
            target=targets[0],
        )
    if have_targets_one_orientation(linearised):
        return note(
            "adjustment.parallel_lines_one_orientation"
            if parallel
            else "adjustment.one_orientation"
        )
    return note("adjustment.parallel_lines") if parallel else None


def _with_correlated_pos_errors(linearised: LinearisedProblem) -> LinearisedProblem:
    """Equations of the correlated model at the same state.

    With independent POS errors, any angle would seem determined if there are enough points.
    """
    problem, state = linearised.problem, linearised.state
    if problem.model.correlated:
        return linearised
    model = replace(problem.model, pos_errors="correlated")
    problem = AdjustmentProblem.of(
        problem.observations, problem.prior, model, problem.parameters, problem.moments
    )
    return problem.linearised(problem.start(state.mounting, state.shapes))


def require_two_orientations(linearised: LinearisedProblem) -> None:
    """Raise an error if all targets are planes of one orientation, which cannot check the angles.

    Raises
    ------
    RankDeficient
        There is only one plane, or all planes are parallel, and no plane is fixed by control.
    """
    if not have_targets_one_orientation(linearised) or is_plane_fixed_by_control(linearised):
        return
    targets = linearised.problem.observations.targets
    raise RankDeficient(
        error("adjustment.only_plane", target=targets[0])
        if len(targets) == 1
        else error("adjustment.parallel_planes")
    )


def require_orientations_kept(linearised: LinearisedProblem) -> None:
    """Raise an error if the solution gives targets of different orientations the same normal.

    An iteration from a prior mounting that is far off may end where all points lie near one plane.
    The angle between two planes measured on one line hardly depends on the mounting, and shows
    that this is not the solution.

    Raises
    ------
    NotConverged
        All adjusted planes have one orientation, but two of them differ on single lines.
    """
    if not have_targets_one_orientation(linearised):
        return
    problem, state = linearised.problem, linearised.state
    observations, adjusted = problem.observations, state.shapes[:, :3]
    on_lines = _angles_on_single_lines(observations, problem.prior)
    excess = on_lines - np.arccos(np.minimum(np.abs(adjusted @ adjusted.T), 1.0))
    first, second = map(int, np.unravel_index(np.argmax(excess), excess.shape))
    if excess[first, second] <= MAX_PARALLEL_ANGLE:
        return
    raise NotConverged(
        error(
            "adjustment.orientations_lost",
            first=observations.targets[first],
            second=observations.targets[second],
            angle=float(on_lines[first, second]),
            change=_rotation_between(problem.prior.boresight, state.mounting.boresight),
        )
    )


def _rotation_between(first: Array, second: Array) -> float:
    """Angle of the rotation between two boresights, of roll, pitch and yaw, radians."""
    rotation = rotation_matrix(*first).T @ rotation_matrix(*second)
    return float(np.arccos(np.clip((np.trace(rotation) - 1) / 2, -1.0, 1.0)))


def _angles_on_single_lines(observations: Observations, mounting: Mounting) -> Array:
    """Median over the lines of the angle between two targets, shape (targets, targets), radians.

    The angle is 0 for targets without a line in common.
    """
    points, count = points_local(observations, mounting), len(observations.targets)
    normals: dict[tuple[str, int], Array] = {}
    for s, sighting in enumerate(observations.sightings):
        with suppress(PlaneNotFound):  # a single straight line of points has no normal
            k = int(observations.target_of_sighting[s])
            normals[sighting.line, k] = fit_plane(points[observations.sighting == s]).normal
    angles = np.zeros((count, count))
    for i, j in combinations(range(count), 2):
        cosines = [
            abs(float(normals[line, i] @ normals[line, j]))
            for line in observations.lines
            if (line, i) in normals and (line, j) in normals
        ]
        if cosines:
            angles[i, j] = angles[j, i] = np.median(np.arccos(np.minimum(cosines, 1.0)))
    return angles


def is_plane_fixed_by_control(linearised: LinearisedProblem) -> bool:
    """Whether the control of a plane alone determines its normal and offset.

    Such control shows whether the plane was moved or is bent, like a plane of another orientation.
    """
    control = linearised.control
    if control is None:
        return False
    for place in linearised.normal.layout.shapes:
        information = control.matrix[place, place] * np.outer(_PLANE_LIMITS, _PLANE_LIMITS)
        if np.linalg.eigvalsh(information)[0] > 1:
            return True
    return False


def have_one_orientation(normals: Array, spheres: NDArray[np.bool_]) -> bool:
    """Whether all targets are planes with the same normal, up to `MAX_PARALLEL_ANGLE`.

    Parameters
    ----------
    normals : ndarray of shape (targets, 3), unit vectors, local
    spheres : ndarray of shape (targets,), bool
        Whether each target is a sphere.
    """
    return not spheres.any() and bool(
        (np.abs(normals @ normals.T) > np.cos(MAX_PARALLEL_ANGLE)).all()
    )


def line_headings(linearised: LinearisedProblem) -> dict[str, float]:
    """Mean heading of each line over its points, radians."""
    observations = linearised.problem.observations
    sines = observations.mean_by_sighting(np.sin(observations.attitude[:, 2]))
    cosines = observations.mean_by_sighting(np.cos(observations.attitude[:, 2]))
    found = {}
    for line in observations.lines:
        own = [k for k, s in enumerate(observations.sightings) if s.line == line]
        found[line] = float(np.arctan2(sines[own].sum(), cosines[own].sum()))
    return found


def _is_single_heading(linearised: LinearisedProblem) -> bool:
    """Whether all points were measured on one heading; a line may contain several headings."""
    heading = linearised.problem.observations.attitude[:, 2]
    middle = np.angle(np.exp(1j * heading).mean())
    return bool((np.abs(np.angle(np.exp(1j * (heading - middle)))) < 2 * MAX_PARALLEL_ANGLE).all())


def _are_lines_parallel(linearised: LinearisedProblem) -> bool:
    doubled = 2 * np.array(
        list(line_headings(linearised).values())
    )  # 0 and 180 deg are one direction
    differences = np.angle(np.exp(1j * (doubled - doubled[0]))) / 2
    return bool((np.abs(differences) < MAX_PARALLEL_ANGLE).all())


def have_targets_one_orientation(linearised: LinearisedProblem) -> bool:
    """Evaluate `have_one_orientation` for the targets of a linearised problem."""
    return have_one_orientation(
        linearised.state.shapes[:, :3], linearised.problem.observations.is_sphere
    )


def angle_combination(direction: Array) -> Message:
    """Name of a combination of angles as part of a message, the largest share first.

    Parameters
    ----------
    direction : ndarray of shape (3,), no unit
        Shares of roll, pitch, yaw.
    """
    share = direction**2
    names = [ANGLES[k] for k in np.argsort(-share) if share[k] > 0.15]
    first, *rest = (note(ANGLE_CODES[name]) for name in names)
    if not rest:
        return first
    if len(rest) == 1:
        return note("adjustment.angle_with_one", first=first, second=rest[0])
    return note("adjustment.angle_with_two", first=first, second=rest[0], third=rest[1])
