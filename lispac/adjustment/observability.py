"""What the geometry sees: eigenvalues, weak directions, and refusals."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.message_parts import quantity
from lispac.adjustment.parameters import LIMITS, Estimate
from lispac.adjustment.problem import Linearised, Problem
from lispac.adjustment.result import ANGLES, Observability, Unchecked
from lispac.adjustment.scatter import sigmas_without
from lispac.errors import RankDeficient
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import CALIBRATION

Array = NDArray[np.float64]

WORST_SIGMA = np.radians(1.0)
"""An angle that the geometry cannot tell to better than this is not determined by it: a look at
the mounting knows it as well."""

PARALLEL = np.radians(10.0)
"""Lines, or normals, that differ by less count as one direction."""

CARRIED = 4.0
"""Factor by which a sigma grows without a sighting that carries the angle alone."""
CLUSTERED = 0.05
"""Distance of targets, over that from the scanner, below which they act as one: POS errors, the
direction of the beams and what is wrong with a line are the same for all of them."""
MOST_SIGHTINGS = 100
"""Of more, none carries an angle."""
MATTERS = 1.25
"""Factor of increase of a sigma without a line, from which the line is reported."""

ANGLE_CODES = {
    "roll": "adjustment.angle_roll",
    "pitch": "adjustment.angle_pitch",
    "yaw": "adjustment.angle_yaw",
}
"""Code of each angle's name as part of a message."""


def unseen(linearised: Linearised) -> tuple[Estimate, ...]:
    """Parameters that the geometry does not see, the worst first, each with the reason.

    One at a time: of two that cannot be separated from each other, one stays.
    """
    problem = linearised.problem
    active = problem.active
    information = linearised.normal.information(len(active))
    limits = LIMITS[active]
    own = {p.index: p.sigma**-2 if p.sigma else 0.0 for p in problem.parameters}
    hidden: list[Estimate] = []
    left = {p.index: p for p in problem.parameters}
    while left:
        free = information.copy()
        for index in left:
            k = int(np.searchsorted(active, index))
            free[k, k] -= own[index]
        kept = np.array([
            CALIBRATION[i] not in {h.name for h in hidden if h.prior_sigma is None} for i in active
        ])  # fmt: skip
        # Scaled to the limits; a trace of a prior keeps what is wholly unseen finite.
        scaled = (free * np.outer(limits, limits))[np.ix_(kept, kept)] + 1e-4 * np.eye(kept.sum())
        covariance = np.linalg.inv(scaled)
        sigmas = dict(zip(active[kept], np.sqrt(np.diag(covariance)), strict=True))
        worst = max(left, key=lambda index: sigmas[index])
        if sigmas[worst] <= 1:
            break
        k = int(np.searchsorted(active[kept], worst))
        hidden.append(_hidden(linearised, worst, covariance[k], active[kept], left[worst].sigma))
        del left[worst]
    return tuple(hidden)


def _hidden(
    linearised: Linearised, index: int, row: Array, active: NDArray[np.int64], sigma: float | None
) -> Estimate:
    name = CALIBRATION[index]
    prior = float(linearised.problem.prior.values[index])
    shares = np.where(active == index, 0.0, np.abs(row))
    other = quantity(CALIBRATION[int(active[np.argmax(shares)])])
    parameter = quantity(name)
    kept = note("parameter.kept_uncertain" if sigma else "parameter.kept")
    if name == "scan_angle_offset":
        reason = note("parameter.rotates_like_boresight", parameter=parameter, kept=kept)
    elif name == "lever_z":
        reason = note("parameter.raises_all_lines", parameter=parameter, kept=kept)
    else:
        reason = note("parameter.not_separated", parameter=parameter, other=other, kept=kept)
    return Estimate(name, prior, sigma, reason=reason)


def require_determined(linearised: Linearised) -> None:
    """Refuse a geometry that leaves an angle open, in thesis mode as in the correlated model.

    Raises
    ------
    RankDeficient
        With the reason: one line, parallel lines, one target, parallel normals.
    """
    problem = linearised.problem
    lines = problem.observations.lines
    if len(lines) < 2 and _one_course(linearised):
        raise RankDeficient(error("adjustment.one_line", line=lines[0]))
    information = _with_shared_errors(linearised).normal.information(3)
    eigenvalues, directions = np.linalg.eigh(information)
    if eigenvalues[0] >= max(WORST_SIGMA**-2, 1e-12 * eigenvalues[2]):
        return
    # A sphere has no orientation that another could differ from.
    spheres = bool(problem.observations.is_sphere.all())
    action = note("adjustment.add_target" if spheres else "adjustment.add_orientation")
    direction, reason = _combination(directions[:, 0]), _reason_undetermined(linearised)
    if reason is None:
        raise RankDeficient(error("adjustment.undetermined", direction=direction, action=action))
    raise RankDeficient(
        error("adjustment.undetermined_because", direction=direction, reason=reason, action=action)
    )


def _reason_undetermined(linearised: Linearised) -> Message | None:
    """Why the geometry does not determine an angle; None if there is no simple reason."""
    targets = linearised.problem.observations.targets
    parallel = _parallel_lines(linearised)
    if len(targets) == 1:
        return note(
            "adjustment.parallel_lines_one_target" if parallel else "adjustment.single_target",
            target=targets[0],
        )
    if _one_facing(linearised):
        return note(
            "adjustment.parallel_lines_one_orientation"
            if parallel
            else "adjustment.one_orientation"
        )
    return note("adjustment.parallel_lines") if parallel else None


def _with_shared_errors(linearised: Linearised) -> Linearised:
    """The equations of the correlated model at the same state.

    Where every point has a POS error of its own, any angle is known if only the points are many.
    """
    problem, state = linearised.problem, linearised.state
    if problem.model.correlated:
        return linearised
    model = replace(problem.model, pos_errors="correlated")
    problem = Problem.of(
        problem.observations, problem.prior, model, problem.parameters, problem.moments
    )
    return problem.linearised(problem.start(state.mounting, state.shapes))


def require_two_facings(linearised: Linearised) -> None:
    """Refuse planes that all face one way: there is no check of the angles.

    Raises
    ------
    RankDeficient
    """
    if not _one_facing(linearised):
        return
    targets = linearised.problem.observations.targets
    raise RankDeficient(
        error("adjustment.only_plane", target=targets[0])
        if len(targets) == 1
        else error("adjustment.parallel_planes")
    )


def one_facing(normals: Array, spheres: NDArray[np.bool_]) -> bool:
    """Whether all targets are planes with the same normal, up to `PARALLEL`.

    Parameters
    ----------
    normals : ndarray of shape (targets, 3), unit vectors, local
    spheres : ndarray of shape (targets,), bool
        Which of them are spheres.
    """
    return not spheres.any() and bool((np.abs(normals @ normals.T) > np.cos(PARALLEL)).all())


def headings(linearised: Linearised) -> dict[str, float]:
    """Mean heading of each line over its points, radians."""
    observations = linearised.problem.observations
    sines = observations.mean_by_sighting(np.sin(observations.attitude[:, 2]))
    cosines = observations.mean_by_sighting(np.cos(observations.attitude[:, 2]))
    found = {}
    for line in observations.lines:
        own = [k for k, s in enumerate(observations.sightings) if s.line == line]
        found[line] = float(np.arctan2(sines[own].sum(), cosines[own].sum()))
    return found


def _one_course(linearised: Linearised) -> bool:
    """Whether all points were seen on one heading; what is called a line may hold several."""
    heading = linearised.problem.observations.attitude[:, 2]
    middle = np.angle(np.exp(1j * heading).mean())
    return bool((np.abs(np.angle(np.exp(1j * (heading - middle)))) < 2 * PARALLEL).all())


def _parallel_lines(linearised: Linearised) -> bool:
    doubled = 2 * np.array(list(headings(linearised).values()))  # 0 and 180 deg are one direction
    apart = np.angle(np.exp(1j * (doubled - doubled[0]))) / 2
    return bool((np.abs(apart) < PARALLEL).all())


def _one_facing(linearised: Linearised) -> bool:
    return one_facing(linearised.state.shapes[:, :3], linearised.problem.observations.is_sphere)


def observability(
    linearised: Linearised,
    *,
    raised: Array | None = None,
    origins: Array | None = None,
    progress: Progress = no_progress,
) -> Observability:
    """How well lines and targets see the three angles.

    Parameters
    ----------
    raised : ndarray of shape (3,), optional
        Factors by which the sigmas of the angles are raised.
    origins : ndarray of shape (targets, 3), metres, local, optional
        Where the targets are.
    """
    factors = np.ones(3) if raised is None else raised
    information = linearised.normal.information(3) / np.outer(factors, factors)
    eigenvalues, directions = np.linalg.eigh(information)
    sigma = np.sqrt(np.diag(np.linalg.inv(information)))
    observations = linearised.problem.observations
    without = {}
    for k, line in enumerate(observations.lines):
        progress(k / len(observations.lines))
        gone = np.array([sighting.line == line for sighting in observations.sightings])
        own = _sigma(linearised, gone)
        without[line] = None if own is None else factors * own
    remarks = (
        _strongest_and_weakest(eigenvalues, directions), *_main_lines(sigma, without),
        *_one_sided(linearised),
    )  # fmt: skip
    condition = float(eigenvalues[2] / eigenvalues[0])
    unchecked = (
        tuple(_unchecked(linearised, without, origins))
        if linearised.problem.model.correlated
        else ()
    )
    return Observability(eigenvalues, directions, condition, without, remarks, unchecked)


def _unchecked(
    linearised: Linearised, without: dict[str, Array | None], origins: Array | None
) -> Iterator[Unchecked]:
    """Lines, targets and sightings of which an error would not show in the others."""
    observations = linearised.problem.observations
    needed = [line for line, sigma in without.items() if sigma is None]
    yield from (Unchecked("line", line=line) for line in needed)
    targets = observations.targets
    if len(targets) > 1:
        for k, target in enumerate(targets):
            sigma = sigmas_without(linearised, observations.target_of_sighting == k)
            if sigma is None or sigma.max() > WORST_SIGMA:
                yield Unchecked("target", target)
        if origins is not None and (reach := _reach(linearised, origins)) < CLUSTERED:
            yield Unchecked("clustered", size=reach)
    if needed or len(observations.sightings) > MOST_SIGHTINGS:
        return
    whole = sigmas_without(linearised, np.zeros(len(observations.sightings), dtype=bool))
    for k, sighting in enumerate(observations.sightings):
        own = sigmas_without(linearised, np.arange(len(observations.sightings)) == k)
        if whole is None or own is None:
            continue
        carried = tuple(np.array(ANGLES)[own > CARRIED * whole].tolist())
        if carried:
            yield Unchecked("sighting", sighting.target, sighting.line, carried)


def _reach(linearised: Linearised, origins: Array) -> float:
    """Largest distance of two targets over their mean distance from the scanner."""
    apart = np.linalg.norm(origins[:, None] - origins[None], axis=-1).max()
    points = linearised.problem.observations.points_lidar
    return float(apart / np.linalg.norm(points, axis=1).mean())


def _one_sided(linearised: Linearised) -> Iterator[Message]:
    """What the data determine, and nothing checks."""
    observations = linearised.problem.observations
    targets = observations.targets
    if len(targets) == 1:
        if observations.is_sphere[0]:
            yield note("observability.one_sphere", target=targets[0])
        else:
            yield note("adjustment.one_target", target=targets[0])
    elif _one_facing(linearised):
        yield note("adjustment.one_facing")


def _sigma(linearised: Linearised, gone: NDArray[np.bool_]) -> Array | None:
    if len({s.line for s, g in zip(linearised.problem.observations.sightings, gone, strict=True)
            if not g}) < 2:  # fmt: skip
        return None
    information = linearised.without(gone).information(3)
    if np.linalg.eigvalsh(information)[0] < WORST_SIGMA**-2:
        return None
    return np.asarray(np.sqrt(np.diag(np.linalg.inv(information))))


def _combination(direction: Array) -> Message:
    """A direction in angle space as part of a message: its angles, the largest first."""
    share = direction**2
    names = [ANGLES[k] for k in np.argsort(-share) if share[k] > 0.15]
    first, *rest = (note(ANGLE_CODES[name]) for name in names)
    if not rest:
        return first
    if len(rest) == 1:
        return note("adjustment.angle_with_one", first=first, second=rest[0])
    return note("adjustment.angle_with_two", first=first, second=rest[0], third=rest[1])


def _strongest_and_weakest(eigenvalues: Array, directions: Array) -> Message:
    return note(
        "observability.directions",
        weakest=_combination(directions[:, 0]), weakest_sigma=float(eigenvalues[0] ** -0.5),
        strongest=_combination(directions[:, 2]), strongest_sigma=float(eigenvalues[2] ** -0.5),
    )  # fmt: skip


def _main_lines(sigma: Array, without: dict[str, Array | None]) -> Iterator[Message]:
    """The lines that each angle depends on most."""
    for k, angle in enumerate(ANGLES):
        name = note(ANGLE_CODES[angle])
        grown = {line: value[k] / sigma[k] for line, value in without.items() if value is not None}
        lines = sorted((line for line in grown if grown[line] > MATTERS), key=lambda x: -grown[x])
        if lines:
            now = float(sigma[k])
            yield note(
                "observability.main_lines",
                count=len(lines), lines=lines, angle=name, line=lines[0],
                without=float(grown[lines[0]]) * now, sigma=now,
            )  # fmt: skip
        elif len(grown) == len(without):
            yield note("observability.no_main_line", angle=name)
