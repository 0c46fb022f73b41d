"""Targets and validation planes proposed without a click: the user accepts, edits or rejects."""

from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.blas import one_thread
from lispac.adjustment.problem import Linearised, Problem
from lispac.adjustment.result import ANGLES
from lispac.adjustment.solver import adjust
from lispac.errors import AdjustmentError, TargetNotFound
from lispac.progress import Progress, no_progress, part
from lispac.project import PickedSighting, Project, Role, Target, Triple
from lispac.targets.detection import DetectedPlane, Found, detect_planes
from lispac.targets.finder import FinderSettings
from lispac.validation.comparison import reciprocal
from lispac.workflow.calibration import observations_of
from lispac.workflow.seeking import planes_in_lines
from lispac.workflow.survey import Survey

Array = NDArray[np.float64]

MOST_TARGETS, LEAST_VALIDATION = 4, 4
WORTH_IT = 0.85
"""A target that leaves more than this share of every sigma is left for validation."""
LARGE = 2.0
"""Square metres from which a plane is large enough for validation, where there are others."""
PLANAR = 3.0
"""Times the noise: a plane with a larger RMS is proposed for nothing."""


@dataclass(frozen=True, eq=False)
class Proposal:
    """What could be used, and why.

    Attributes
    ----------
    targets : tuple of Target
        Named T1, T2 ... and V1, V2 ..., with their sightings in every line.
    reasons : dict of name to str
    sigma : ndarray of shape (3,), radians
        Of roll, pitch, yaw that the proposed targets would give.
    """

    targets: tuple[Target, ...]
    reasons: dict[str, str]
    sigma: Array


def propose(project: Project, survey: Survey, *, progress: Progress = no_progress) -> Proposal:
    """Propose targets and validation planes; the project stays as it is.

    Planes are ranked by what they add to the adjustment, by its own model and derivatives: first
    the two that leave the least worst angle, then what improves any angle. The others that two
    opposite lines have seen are for validation, spread in height and range.

    Raises
    ------
    TargetNotFound
        Fewer than two planes on two lines or more.
    """
    threshold = project.settings.threshold
    noise = threshold / PLANAR
    settings = FinderSettings(threshold=threshold)

    def find(seed: Array, line: str, step: Progress) -> Found:
        return planes_in_lines(survey.clouds, seed, settings, first_line=line, progress=step)

    planes = [
        plane
        for plane in detect_planes(
            {name: cloud.sample for name, cloud in survey.clouds.items()},
            settings,
            lines=survey.clouds,
            find=find,
            progress=part(progress, 0.0, 0.9),
        )
        if np.median([patch.rms for patch in plane.found.values()]) <= PLANAR * noise
    ]
    if len(planes) < 2:
        raise TargetNotFound(
            f"{project.name}: only {len(planes)} flat surfaces are seen on two lines or more; "
            "set seeds on the targets, or put up boards."
        )
    names = [f"P{k + 1}" for k in range(len(planes))]
    everything = replace(
        project,
        targets=tuple(
            _target(survey, plane, name, "target", threshold)
            for plane, name in zip(planes, names, strict=True)
        ),
    )
    progress(0.9, "Weighing what each plane tells of the boresight")
    linearised = _linearised(everything, survey)
    chosen, reasons, sigma = _chosen(linearised, names, _is_whole(planes, names))
    left = [k for k, name in enumerate(names) if name not in chosen]
    validation = _validation([planes[k] for k in left], survey)
    proposed: list[Target] = []
    said: dict[str, str] = {}
    for number, name in enumerate(chosen, start=1):
        plane = planes[names.index(name)]
        proposed.append(_target(survey, plane, f"T{number}", "target", threshold))
        said[f"T{number}"] = f"Seen on {len(plane.found)} lines; {reasons[name]}"
    for number, plane in enumerate(validation, start=1):
        proposed.append(_target(survey, plane, f"V{number}", "validation", threshold))
        said[f"V{number}"] = (
            f"Flat over {plane.area:.1f} m2, seen on {len(plane.found)} lines"
            f"{', opposite ones among them' if _opposite(plane, survey) else ''}, "
            f"{plane.centre[2]:.0f} m high."
        )
    progress(1.0, f"Proposed {len(chosen)} targets and {len(validation)} validation planes")
    return Proposal(tuple(proposed), said, sigma)


def _target(
    survey: Survey, plane: DetectedPlane, name: str, role: Role, threshold: float
) -> Target:
    seed: Triple = (float(plane.seed[0]), float(plane.seed[1]), float(plane.seed[2]))
    sightings = tuple(
        PickedSighting(
            line,
            patch.indices,
            patch.rms,
            fingerprint=survey.scans[line].fingerprint,
            one_in=patch.one_in,
        )
        for line, patch in ((n, plane.found[n]) for n in survey.lines if n in plane.found)
    )
    radius = FinderSettings().radius
    return Target(name, role, seed, threshold, radius, sightings, missing=dict(plane.missing))


def _linearised(project: Project, survey: Survey) -> Linearised:
    """All planes together, linearised where the adjustment ends up with them."""
    observations = observations_of(project, survey)
    model = project.settings.stochastic_model
    prior = project.mounting("prior")
    result = adjust(observations, prior, model, diagnostics=False)
    shapes = np.stack([target.plane for target in result.targets])
    with one_thread():
        problem = Problem.of(observations, result.mounting, model)
        problem = replace(problem, noise=np.array([target.noise for target in result.targets]))
        if model.correlated:
            problem = problem.with_surface(np.maximum(result.surfaces, 1e-5))
        return problem.linearised(problem.start(result.mounting, shapes))


def _sigma(linearised: Linearised, names: tuple[str, ...]) -> Array:
    """Sigmas (radians) of roll, pitch, yaw from some of the planes."""
    sightings = linearised.problem.observations.sightings
    gone = np.array([sighting.target not in names for sighting in sightings])
    information = linearised.without(gone).information(3)
    if np.linalg.eigvalsh(information)[0] <= 0.0:
        return np.full(3, np.inf)
    return np.asarray(np.sqrt(np.diag(np.linalg.inv(information))))


def _is_whole(planes: list[DetectedPlane], names: list[str]) -> set[str]:
    """Names of the planes that end within the search radius: the same outline on every line."""
    radius = FinderSettings().radius
    return {
        name
        for plane, name in zip(planes, names, strict=True)
        if max(patch.extent.max() for patch in plane.found.values()) < 1.5 * radius
    }


def _chosen(
    linearised: Linearised, names: list[str], whole: set[str]
) -> tuple[list[str], dict[str, str], Array]:
    """The planes to adjust with, the reason of each, and the sigmas they give."""
    with one_thread():
        # Boards rather than walls, where there are enough: walls are wanted for validation.
        pool = [name for name in names if name in whole]
        pool = pool if len(pool) >= 2 else names
        pairs = {pair: _sigma(linearised, pair) for pair in combinations(pool, 2)}
        best = min(pairs, key=lambda pair: float(pairs[pair].max()))
        sigma, chosen = pairs[best], list(best)
        if not np.isfinite(sigma).all():
            raise AdjustmentError("No two of the planes found determine the boresight.")
        text = ", ".join(
            f"{angle} {np.degrees(value):.3f}" for angle, value in zip(ANGLES, sigma, strict=True)
        )
        first, second = best
        reasons = {
            first: f"together with the next it gives sigmas of {text} deg.",
            second: f"together with the one before it gives sigmas of {text} deg.",
        }
        spare = len(names) - LEAST_VALIDATION
        while len(chosen) < min(MOST_TARGETS, spare):
            added = {
                name: _sigma(linearised, (*chosen, name)) for name in pool if name not in chosen
            }
            if not added:
                break
            name = min(added, key=lambda name: float((added[name] / sigma).min()))
            k = int(np.argmin(added[name] / sigma))
            if added[name][k] > WORTH_IT * sigma[k]:
                break
            reasons[name] = (
                f"it brings the sigma of {ANGLES[k]} from {np.degrees(sigma[k]):.3f} to "
                f"{np.degrees(added[name][k]):.3f} deg."
            )
            chosen.append(name)
            sigma = added[name]
    return chosen, reasons, sigma


def _opposite(plane: DetectedPlane, survey: Survey) -> bool:
    return any(
        reciprocal(survey.heading[a], survey.heading[b]) for a, b in combinations(plane.found, 2)
    )


def _validation(planes: list[DetectedPlane], survey: Survey) -> list[DetectedPlane]:
    """The planes on opposite lines first, each next one the farthest from those before."""
    large = [plane for plane in planes if plane.area >= LARGE]
    planes = large if len(large) >= LEAST_VALIDATION else planes
    left = sorted(planes, key=lambda plane: (not _opposite(plane, survey), -plane.area))
    kept = left[:1]
    while len(left) > len(kept) and len(kept) < LEAST_VALIDATION + 1:
        rest = [plane for plane in left if plane not in kept]
        opposite = [plane for plane in rest if _opposite(plane, survey)] or rest
        kept.append(
            max(
                opposite,
                key=lambda plane: min(
                    float(np.linalg.norm(plane.centre - other.centre)) for other in kept
                ),
            )
        )
    return kept
