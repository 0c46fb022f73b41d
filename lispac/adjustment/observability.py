"""Observability of the angles: eigenvalues, weak directions, and refusal of poor geometry."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.excess_scatter import sigmas_without
from lispac.adjustment.message_parts import mounting_value_name
from lispac.adjustment.normal_equations import scaled_inverse
from lispac.adjustment.parameters import LIMITS, ParameterEstimate
from lispac.adjustment.result import ANGLES, Observability, UncontrolledObservations
from lispac.errors import RankDeficient
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import CALIBRATION

Array = NDArray[np.float64]

WORST_SIGMA = np.radians(1.0)
"""Radians: an angle that the geometry determines no better is undetermined; an inspection of the
mounting gives as much."""

PARALLEL_LIMIT = np.radians(10.0)
"""Lines, or normals, that differ by less count as one direction."""

MAX_SIGMA_RATIO = 4.0
"""Factor by which a sigma grows without a sighting that carries the angle alone."""
CLUSTER_RATIO = 0.05
"""Distance of targets, over that from the scanner, below which they act as one: POS errors, the
direction of the beams and what is wrong with a line are the same for all of them."""
MAX_SIGHTINGS = 100
"""Above this number, no single sighting determines an angle."""
MIN_RATIO = 1.25
"""Factor of increase of a sigma without a line, from which the line is reported."""

ANGLE_CODES = {
    "roll": "adjustment.angle_roll",
    "pitch": "adjustment.angle_pitch",
    "yaw": "adjustment.angle_yaw",
}
"""Code of each angle's name as part of a message."""


def find_undetermined_parameters(linearised: LinearisedProblem) -> tuple[ParameterEstimate, ...]:
    """Find the parameters that the geometry does not determine, the worst first, with reasons.

    One at a time: of two that cannot be separated from each other, one stays.
    """
    problem = linearised.problem
    active = problem.active
    information = linearised.normal.information(len(active))
    limits = LIMITS[active]
    own = {p.index: p.sigma**-2 if p.sigma else 0.0 for p in problem.parameters}
    undetermined: list[ParameterEstimate] = []
    left = {p.index: p for p in problem.parameters}
    while left:
        free = information.copy()
        for index in left:
            k = int(np.searchsorted(active, index))
            free[k, k] -= own[index]
        fixed = {each.name for each in undetermined if each.prior_sigma is None}
        kept = np.array([CALIBRATION[i] not in fixed for i in active])
        # Scaled to the limits; a trace of a prior keeps what is wholly unseen finite.
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
    name = CALIBRATION[index]
    prior = float(linearised.problem.prior.values[index])
    shares = np.where(active == index, 0.0, np.abs(row))
    other = mounting_value_name(CALIBRATION[int(active[np.argmax(shares)])])
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
    """Refuse a geometry that leaves an angle undetermined, in either stochastic model.

    Raises
    ------
    RankDeficient
        With the reason: one line, parallel lines, one target, parallel normals.
    """
    problem = linearised.problem
    lines = problem.observations.lines
    if len(lines) < 2 and _is_single_heading(linearised):
        raise RankDeficient(error("adjustment.one_line", line=lines[0]))
    information = _with_correlated_pos_errors(linearised).normal.information(3)
    eigenvalues, directions = np.linalg.eigh(information)
    if eigenvalues[0] >= max(WORST_SIGMA**-2, 1e-12 * eigenvalues[2]):
        return
    # A sphere has no orientation that another could differ from.
    spheres = bool(problem.observations.is_sphere.all())
    action = note("adjustment.add_target" if spheres else "adjustment.add_orientation")
    direction, reason = _angle_combination(directions[:, 0]), _reason_undetermined(linearised)
    if reason is None:
        raise RankDeficient(error("adjustment.undetermined", direction=direction, action=action))
    raise RankDeficient(
        error("adjustment.undetermined_because", direction=direction, reason=reason, action=action)
    )


def _reason_undetermined(linearised: LinearisedProblem) -> Message | None:
    """Simple reason why an angle is undetermined; None where there is none."""
    targets = linearised.problem.observations.targets
    parallel = _are_lines_parallel(linearised)
    if len(targets) == 1:
        return note(
            "adjustment.parallel_lines_one_target" if parallel else "adjustment.single_target",
            target=targets[0],
        )
    if _have_targets_one_orientation(linearised):
        return note(
            "adjustment.parallel_lines_one_orientation"
            if parallel
            else "adjustment.one_orientation"
        )
    return note("adjustment.parallel_lines") if parallel else None


def _with_correlated_pos_errors(linearised: LinearisedProblem) -> LinearisedProblem:
    """Equations of the correlated model at the same state.

    Where every point has a POS error of its own, any angle is known if only the points are many.
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
    """Refuse planes that all face one way, because nothing checks the angles then.

    Raises
    ------
    RankDeficient
        If there is one plane only, or all planes are parallel.
    """
    if not _have_targets_one_orientation(linearised):
        return
    targets = linearised.problem.observations.targets
    raise RankDeficient(
        error("adjustment.only_plane", target=targets[0])
        if len(targets) == 1
        else error("adjustment.parallel_planes")
    )


def have_one_orientation(normals: Array, spheres: NDArray[np.bool_]) -> bool:
    """Whether all targets are planes with the same normal, up to `PARALLEL_LIMIT`.

    Parameters
    ----------
    normals : ndarray of shape (targets, 3), unit vectors, local
    spheres : ndarray of shape (targets,), bool
        Which of them are spheres.
    """
    return not spheres.any() and bool((np.abs(normals @ normals.T) > np.cos(PARALLEL_LIMIT)).all())


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
    """Whether all points were measured on one heading; a line may hold several."""
    heading = linearised.problem.observations.attitude[:, 2]
    middle = np.angle(np.exp(1j * heading).mean())
    return bool((np.abs(np.angle(np.exp(1j * (heading - middle)))) < 2 * PARALLEL_LIMIT).all())


def _are_lines_parallel(linearised: LinearisedProblem) -> bool:
    doubled = 2 * np.array(
        list(line_headings(linearised).values())
    )  # 0 and 180 deg are one direction
    differences = np.angle(np.exp(1j * (doubled - doubled[0]))) / 2
    return bool((np.abs(differences) < PARALLEL_LIMIT).all())


def _have_targets_one_orientation(linearised: LinearisedProblem) -> bool:
    return have_one_orientation(
        linearised.state.shapes[:, :3], linearised.problem.observations.is_sphere
    )


def assess_observability(
    linearised: LinearisedProblem,
    *,
    angle_sigma_factors: Array | None = None,
    covariance: Array | None = None,
    origins: Array | None = None,
    progress: Progress = no_progress,
) -> Observability:
    """Assess how well lines and targets determine the three angles.

    Parameters
    ----------
    angle_sigma_factors : ndarray of shape (3,), no unit, optional
        Factors by which the sigmas of the angles are raised.
    covariance : ndarray of shape (3, 3), radians squared, optional
        Covariance of the estimated angles, if it is not that of ``linearised`` with the factors.
    origins : ndarray of shape (targets, 3), metres, local, optional
        Where the targets are.
    """
    factors = np.ones(3) if angle_sigma_factors is None else angle_sigma_factors
    information = linearised.normal.information(3) / np.outer(factors, factors)
    if covariance is not None:
        information = scaled_inverse(covariance)
    eigenvalues, directions = np.linalg.eigh(information)
    sigma = np.sqrt(np.diag(np.linalg.inv(information)))
    observations = linearised.problem.observations
    without = {}
    for k, line in enumerate(observations.lines):
        progress(k / len(observations.lines))
        omitted = np.array([sighting.line == line for sighting in observations.sightings])
        own = _sigmas_without_groups(linearised, omitted)
        without[line] = None if own is None else factors * own
    notes = (
        _extreme_directions_note(eigenvalues, directions), *_main_lines_by_angle(sigma, without),
        *_one_orientation_notes(linearised),
    )  # fmt: skip
    condition = float(eigenvalues[2] / eigenvalues[0])
    unchecked = (
        tuple(_find_unchecked_parts(linearised, without, origins))
        if linearised.problem.model.correlated
        else ()
    )
    return Observability(eigenvalues, directions, condition, without, notes, unchecked)


def _find_unchecked_parts(
    linearised: LinearisedProblem, without: dict[str, Array | None], origins: Array | None
) -> Iterator[UncontrolledObservations]:
    """Find lines, targets and sightings whose errors the others would not reveal."""
    observations = linearised.problem.observations
    needed = [line for line, sigma in without.items() if sigma is None]
    yield from (UncontrolledObservations("line", line=line) for line in needed)
    targets = observations.targets
    if len(targets) > 1:
        for k, target in enumerate(targets):
            sigma = sigmas_without(linearised, observations.target_of_sighting == k)
            if sigma is None or sigma.max() > WORST_SIGMA:
                yield UncontrolledObservations("target", target)
        if (
            origins is not None
            and (reach := _relative_target_spacing(linearised, origins)) < CLUSTER_RATIO
        ):
            yield UncontrolledObservations("clustered", size=reach)
    if needed or len(observations.sightings) > MAX_SIGHTINGS:
        return
    whole = sigmas_without(linearised, np.zeros(len(observations.sightings), dtype=bool))
    for k, sighting in enumerate(observations.sightings):
        own = sigmas_without(linearised, np.arange(len(observations.sightings)) == k)
        if whole is None or own is None:
            continue
        carried = tuple(np.array(ANGLES)[own > MAX_SIGMA_RATIO * whole].tolist())
        if carried:
            yield UncontrolledObservations("sighting", sighting.target, sighting.line, carried)


def _relative_target_spacing(linearised: LinearisedProblem, origins: Array) -> float:
    """Largest distance between targets over their mean distance from the scanner."""
    largest = np.linalg.norm(origins[:, None] - origins[None], axis=-1).max()
    points = linearised.problem.observations.points_lidar
    return float(largest / np.linalg.norm(points, axis=1).mean())


def _one_orientation_notes(linearised: LinearisedProblem) -> Iterator[Message]:
    """Notes on values that are determined but checked by nothing."""
    observations = linearised.problem.observations
    targets = observations.targets
    if len(targets) == 1:
        if observations.is_sphere[0]:
            yield note("observability.one_sphere", target=targets[0])
        else:
            yield note("adjustment.one_target", target=targets[0])
    elif _have_targets_one_orientation(linearised):
        yield note("adjustment.one_facing")


def _sigmas_without_groups(linearised: LinearisedProblem, mask: NDArray[np.bool_]) -> Array | None:
    if len({s.line for s, g in zip(linearised.problem.observations.sightings, mask, strict=True)
            if not g}) < 2:  # fmt: skip
        return None
    information = linearised.normal_without_sightings(mask).information(3)
    if np.linalg.eigvalsh(information)[0] < WORST_SIGMA**-2:
        return None
    return np.asarray(np.sqrt(np.diag(np.linalg.inv(information))))


def _angle_combination(direction: Array) -> Message:
    """A direction in angle space as part of a message: angles in order of their share."""
    share = direction**2
    names = [ANGLES[k] for k in np.argsort(-share) if share[k] > 0.15]
    first, *rest = (note(ANGLE_CODES[name]) for name in names)
    if not rest:
        return first
    if len(rest) == 1:
        return note("adjustment.angle_with_one", first=first, second=rest[0])
    return note("adjustment.angle_with_two", first=first, second=rest[0], third=rest[1])


def _extreme_directions_note(eigenvalues: Array, directions: Array) -> Message:
    return note(
        "observability.directions",
        weakest=_angle_combination(directions[:, 0]),
        weakest_sigma=float(eigenvalues[0] ** -0.5),
        strongest=_angle_combination(directions[:, 2]),
        strongest_sigma=float(eigenvalues[2] ** -0.5),
    )


def _main_lines_by_angle(sigma: Array, without: dict[str, Array | None]) -> Iterator[Message]:
    """Lines that each angle depends on most."""
    for k, angle in enumerate(ANGLES):
        name = note(ANGLE_CODES[angle])
        grown = {line: value[k] / sigma[k] for line, value in without.items() if value is not None}
        lines = sorted((line for line in grown if grown[line] > MIN_RATIO), key=lambda x: -grown[x])
        if lines:
            now = float(sigma[k])
            yield note(
                "observability.main_lines",
                count=len(lines), lines=lines, angle=name, line=lines[0],
                without=float(grown[lines[0]]) * now, sigma=now,
            )  # fmt: skip
        elif len(grown) == len(without):
            yield note("observability.no_main_line", angle=name)
