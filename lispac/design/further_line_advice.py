"""Advice on a further line over the same targets: its predicted effect on the sigmas."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.lever_arm_uncertainty import lever_arm_effect
from lispac.adjustment.model.observations import Observations, Sighting
from lispac.adjustment.model.parameters import Parameter, mounting_value_name, mounting_value_names
from lispac.adjustment.model.target_shapes import points_local
from lispac.adjustment.model.threads import single_blas_thread
from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem
from lispac.messages import Message, note
from lispac.simulation.closed_form_survey import MIN_INCIDENCE_COSINE
from lispac.survey.georeferencing import to_lidar
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]

CANDIDATE_HEADINGS = np.radians(np.arange(0, 360, 15))
"""Headings of the further lines that are compared, radians."""
LINE_SPEED = 1.0
"""Speed of the vessel on a further line, metres per second."""
MAX_SIGMA_RATIO = 0.85
"""Largest ratio of an angle's sigma with a further line to that without, for a useful line."""


@dataclass(frozen=True, eq=False)
class FurtherLine:
    """A possible further line, and the sigmas predicted with it.

    Attributes
    ----------
    heading : float, radians clockwise from north
    sigma : ndarray of shape (3,), radians
        Predicted sigmas of roll, pitch and yaw with the line added.
    distance : float, metres
        Horizontal distance from the middle of the targets when abeam.
    to_starboard : bool
        Whether the targets lie to starboard; to port otherwise.
    """

    heading: float
    sigma: Array
    distance: float
    to_starboard: bool


def further_lines(observations: Observations, result: AdjustmentResult) -> tuple[FurtherLine, ...]:
    """Predict the sigmas with a further line, for every heading from which a target is visible.

    The line passes on the same side of the targets as the existing lines, at their usual distance
    and height. The sigmas follow from the geometry alone, with the model and the Jacobians of the
    adjustment. The observations must have the sigmas with which the result was computed
    (`AdjustmentResult.sigma_factors`).
    """
    found = []
    with single_blas_thread():
        for heading in CANDIDATE_HEADINGS:
            added = _add_simulated_line(observations, result, float(heading))
            if added is not None:
                every, distance, to_starboard = added
                sigma = _predicted_sigmas(every, result, _parameters_with_sigmas(result))
                found.append(FurtherLine(float(heading), sigma, distance, to_starboard))
    return tuple(found)


def _parameters_with_sigmas(result: AdjustmentResult) -> tuple[Parameter, ...]:
    """Parameters with their prior sigmas; values fixed without a sigma are omitted."""
    if not result.model.correlated:
        return ()  # the model of independent POS errors estimates the angles alone
    return tuple(
        Parameter(each.name, each.prior_sigma)
        for each in result.parameters
        if each.value is not None or each.prior_sigma is not None
    )


def _predicted_sigmas(
    observations: Observations, result: AdjustmentResult, parameters: tuple[Parameter, ...]
) -> Array:
    """Predicted sigmas of roll, pitch and yaw from the observations, shape (3,), radians."""
    shapes = np.stack([target.plane for target in result.targets])
    excluded = set(result.rejected_sightings)
    rejected = [k for k, s in enumerate(observations.sightings) if s in excluded]
    problem = AdjustmentProblem.of(observations, result.mounting, result.model, parameters)
    noise = np.array([target.noise for target in result.targets])
    problem = replace(problem, noise=noise).with_surface_sigma(np.maximum(result.surfaces, 1e-5))
    problem = problem.with_rejected(rejected)
    state = problem.start(result.mounting, shapes)
    linearised = problem.linearised(state)
    variance = np.diag(np.linalg.inv(linearised.normal.information(3))).copy()
    if (sigma := result.model.lever_arm_sigma) is not None:
        variance += ((lever_arm_effect(linearised, ANGLES) * sigma) ** 2).sum(axis=1)
    return np.asarray(np.sqrt(variance))


def further_line_advice(
    observations: Observations, result: AdjustmentResult
) -> tuple[Message, ...]:
    """Advise on the further line that reduces the largest standard deviation most.

    If no line reduces it because given values with a standard deviation limit it, a message names
    these values, and the advice is for the angle with the next largest standard deviation.
    """
    lines = further_lines(observations, result)
    if not lines:
        return ()
    limiting = _limiting_parameters(observations, result)
    found = []
    for k in np.argsort(-result.sigma, kind="stable"):
        best = min(lines, key=lambda line: float(line.sigma[k]))
        helps = best.sigma[k] <= MAX_SIGMA_RATIO * result.sigma[k]
        if not helps and limiting[k]:
            parameters = mounting_value_names(limiting[k])
            found.append(
                note(
                    "further_line.prior",
                    angle=mounting_value_name(ANGLES[k]),
                    parameters=parameters,
                )
            )
            continue
        found.append(_advice_for_angle(result, best, int(k), helps=bool(helps)))
        break
    return tuple(found)


def _advice_for_angle(
    result: AdjustmentResult, best: FurtherLine, angle: int, *, helps: bool
) -> Message:
    now, then = float(result.sigma[angle]), float(best.sigma[angle])
    common: dict[str, Any] = {
        "angle": mounting_value_name(ANGLES[angle]), "distance": best.distance, "now": now,
    }  # fmt: skip
    if not helps:
        return note("further_line.insufficient", limit=MAX_SIGMA_RATIO * now, **common)
    common |= {"heading": best.heading, "then": then}
    if (face := _angle_to_upright_plane(result, best)) is None:
        code = "further_line.starboard" if best.to_starboard else "further_line.port"
        return note(code, **common)
    target, off = face
    starboard, port = "further_line.starboard_of_face", "further_line.port_of_face"
    return note(starboard if best.to_starboard else port, target=target, off=off, **common)


def _limiting_parameters(
    observations: Observations, result: AdjustmentResult
) -> tuple[list[str], ...]:
    """Names of the given values, not determined by the data, that limit the sigma of each angle.

    They are named only for angles whose sigma is mainly due to such values together. The sigma of
    such an angle is predicted with each value known exactly. The value limits the angle if the
    sigma then falls below `MAX_SIGMA_RATIO` times its former value, or if no other value reduces it
    more.
    """
    everything = _parameters_with_sigmas(result)
    values = {each.name: each.value for each in result.parameters}
    undetermined = [each.name for each in everything if values[each.name] is None]
    if not undetermined:
        return [], [], []

    def sigmas_with_known(names: Collection[str]) -> Array:
        others = tuple(each for each in everything if each.name not in names)
        return _predicted_sigmas(observations, result, others)

    with single_blas_thread():
        now, known = sigmas_with_known(()), sigmas_with_known(undetermined)
        alone = {name: sigmas_with_known([name]) for name in undetermined}
    contribution = np.sqrt(np.maximum(now**2 - known**2, 0.0))
    found: list[list[str]] = [[], [], []]
    for k in np.flatnonzero(contribution > MAX_SIGMA_RATIO * now):
        least = min(sigma[k] for sigma in alone.values())
        found[k] = [
            name
            for name, sigma in alone.items()
            if sigma[k] == least or sigma[k] < MAX_SIGMA_RATIO * now[k]
        ]
    return found[0], found[1], found[2]


def _angle_to_upright_plane(
    result: AdjustmentResult, line: FurtherLine
) -> tuple[str, float] | None:
    """Name of the most upright plane, and its horizontal angle to the line, radians.

    None if all targets are spheres.
    """
    planes = [target for target in result.targets if not target.sphere]
    if not planes:
        return None
    upright = min(planes, key=lambda target: abs(float(target.plane[2])))
    north, west = upright.plane[:2]
    along = np.arctan2(north, west)  # heading parallel to the plane
    off = abs((line.heading - along + np.pi / 2) % np.pi - np.pi / 2)
    return upright.target, float(off)


def _add_simulated_line(
    observations: Observations, result: AdjustmentResult, heading: float
) -> tuple[Observations, float, bool] | None:
    """Observations with a simulated line, its distance, and whether targets are to starboard.

    None if no target is visible from the line.
    """
    places = points_local(observations, result.mounting)
    excluded = set(result.rejected_sightings)
    best = [_best_sighting(observations, k, excluded) for k in range(len(observations.targets))]
    vessel = np.stack([observations.position[own].mean(axis=0) for own in best])
    centres = np.stack([places[own].mean(axis=0) for own in best])
    reach = float(np.median(np.linalg.norm((vessel - centres)[:, :2], axis=1)))
    course = np.array([np.cos(heading), -np.sin(heading), 0.0])
    abeam = np.array([-course[1], course[0], 0.0])
    middle = centres.mean(axis=0)
    to_starboard = bool((vessel.mean(axis=0) - middle) @ abeam >= 0)
    if not to_starboard:
        abeam = -abeam
    start = middle + reach * abeam
    start[2] = float(vessel[:, 2].mean())
    parts: list[Observations] = []
    sightings: list[Sighting] = []
    begin = float(observations.time.max()) + _usual_time_between_lines(observations)
    for k, (own, target) in enumerate(zip(best, result.targets, strict=True)):
        points = places[own]
        along = (points - start) @ course
        position = start + along[:, None] * course
        rays = centres[k] - position.mean(axis=0)
        incidence = abs(float(rays @ target.plane[:3])) / float(np.linalg.norm(rays))
        faces = rays @ target.plane[:3] * ((centres[k] - vessel[k]) @ target.plane[:3]) > 0
        if not target.sphere and (incidence < MIN_INCIDENCE_COSINE or not faces):
            continue
        attitude = observations.attitude[own].copy()
        attitude[:] = [0.0, 0.0, heading]
        scan = to_lidar(points, Poses(position, attitude), result.mounting)
        part = observations.reordered(own)
        rate = np.broadcast_to([*(LINE_SPEED * course), 0.0, 0.0, 0.0], (len(own), 6))
        parts.append(
            replace(
                part, points_lidar=scan, position=position, attitude=attitude,
                pose_rate=None if part.pose_rate is None else rate.copy(),
                time=begin + along / LINE_SPEED,
                sighting=np.full(len(own), len(observations.sightings) + len(sightings)),
            )
        )  # fmt: skip
        sightings.append(Sighting(target.target, "further line"))
    if not parts:
        return None
    return _append_observations(observations, parts, sightings), reach, to_starboard


def _append_observations(
    observations: Observations, parts: Sequence[Observations], sightings: list[Sighting]
) -> Observations:
    columns = {
        column.name: np.concatenate([values, *(getattr(part, column.name) for part in parts)])
        for column in fields(observations)
        if isinstance(values := getattr(observations, column.name), np.ndarray)
    }
    every = {"sightings": (*observations.sightings, *sightings)}
    return Observations(
        **{column.name: getattr(observations, column.name) for column in fields(observations)}
        | columns
        | every
    )


def _best_sighting(
    observations: Observations, target: int, excluded: Collection[Sighting]
) -> NDArray[np.intp]:
    own = np.flatnonzero(observations.target_of_sighting == target)
    good = [k for k in own if observations.sightings[k] not in excluded]
    own = np.array(good) if good else own
    densest = own[int(np.argmax(observations.counts[own]))]
    return np.flatnonzero(observations.sighting == densest)


def _usual_time_between_lines(observations: Observations) -> float:
    """Median time from one line to the next, seconds."""
    times = observations.mean_by_sighting(observations.time)
    lines = [s.line for s in observations.sightings]
    middles = [
        np.mean([t for t, name in zip(times, lines, strict=True) if name == line])
        for line in observations.lines
    ]
    return float(np.median(np.diff(np.sort(middles)))) if len(middles) > 1 else 60.0
