"""Targets and validation planes proposed without a click: the user accepts, edits or rejects."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.blas import one_thread
from lispac.adjustment.observability import one_facing
from lispac.adjustment.problem import Linearised, Problem
from lispac.adjustment.result import ANGLES
from lispac.adjustment.shown import listed
from lispac.adjustment.solver import adjust
from lispac.errors import AdjustmentError, TargetNotFound
from lispac.geometry.planes import fit_plane
from lispac.progress import Progress, no_progress, part
from lispac.project import PickedSighting, Project, Role, Target, Triple
from lispac.survey.cloud import Cloud, placed_with
from lispac.targets.detection import DetectedPlane, Found, detect_planes
from lispac.targets.finder import FinderSettings
from lispac.targets.hidden import ends_within
from lispac.targets.quality import SightingQuality
from lispac.validation.comparison import reciprocal
from lispac.workflow.calibration import observations_of
from lispac.workflow.qualities import qualities
from lispac.workflow.seeking import MET_SHIFT, planes_in_lines
from lispac.workflow.survey import Survey

Array = NDArray[np.float64]

MOST_TARGETS, LEAST_VALIDATION = 4, 4
WORTH_IT = 0.85
"""A target that leaves more than this share of every sigma is left for validation."""
FAR_WORSE = 2.0
"""Times the worst sigma that any two planes leave: beyond it two boards are not kept to."""
LARGE = 2.0
"""Square metres from which a plane is large enough for validation, where there are others."""
MOSTLY = 0.5
"""Share of its sightings: a plane whose flatness is poor on so many is proposed for nothing. An RMS
of more than three times the LiDAR noise is poor, and so are ripples and bends. One whose light is
poor on so many is proposed for validation at most, where there are too few others."""


@dataclass(frozen=True, eq=False)
class Proposal:
    """What could be used, and why.

    Attributes
    ----------
    targets : tuple of Target
        Named T1, T2 ... and V1, V2 ..., with their sightings in every line.
    reasons : dict of name to str
    sigma : ndarray of shape (3,), radians
        Of roll, pitch, yaw that the proposed targets would give, with those picked already.
    picked : tuple of str
        Targets of the project that would have been proposed.
    """

    targets: tuple[Target, ...]
    reasons: dict[str, str]
    sigma: Array
    picked: tuple[str, ...] = ()


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
    progress(0.0, "Laying the lines roughly onto each other")
    aligned = survey.aligned
    settings = FinderSettings(threshold=threshold)
    if aligned.nearly_meets:
        settings = replace(settings, max_shift=MET_SHIFT)

    def find(seed: Array, line: str, step: Progress) -> Found:
        return planes_in_lines(
            aligned.clouds, seed, settings,
            first_line=line, accuracy=aligned.accuracy, progress=step,
        )  # fmt: skip

    detected = detect_planes(
        {name: cloud.sample for name, cloud in aligned.clouds.items()},
        settings,
        lines=aligned.clouds,
        find=find,
        progress=part(progress, 0.1, 0.85),
    )
    progress(0.85, "Looking how flat they are")
    names = [f"P{k + 1}" for k in range(len(detected))]
    targets = tuple(
        _target(survey, plane, name, "target", threshold)
        for plane, name in zip(detected, names, strict=True)
    )
    everything = replace(project, targets=targets, result=None)
    judged = _judged(everything, survey)
    spare = [p for p, n in zip(detected, names, strict=True) if judged[n].use == "at need"]
    said_of = {id(p): judged[n].words for p, n in zip(detected, names, strict=True)}
    planes = [p for p, n in zip(detected, names, strict=True) if judged[n].use == "any"]
    names = [name for name in names if judged[name].use == "any"]
    if len(planes) < 2:
        raise TargetNotFound(_too_few(project, len(planes), list(judged.values())))
    everything = replace(everything, targets=tuple(t for t in targets if t.name in names))
    progress(0.9, "Weighing what each plane tells of the boresight")
    linearised = _linearised(everything, survey)
    uneven = _unevenness(everything, placed_with(survey.clouds, linearised.state.mounting))
    linearised = _with_unevenness(linearised, uneven)
    one_way = _facing_one_way(project, planes, names)
    chosen, reasons, sigma = _chosen(linearised, names, _is_whole(planes, names), one_way)
    left = [plane for plane, name in zip(planes, names, strict=True) if name not in chosen]
    validation = _validation([*left, *spare[: max(LEAST_VALIDATION - len(left), 0)]], survey)
    proposed: list[Target] = []
    said: dict[str, str] = {}
    for number, name in enumerate(chosen, start=1):
        plane = planes[names.index(name)]
        proposed.append(_target(survey, plane, f"T{number}", "target", threshold))
        said[f"T{number}"] = f"Seen on {len(plane.found)} lines; {reasons[name]}"
    for number, plane in enumerate(validation, start=1):
        proposed.append(_target(survey, plane, f"V{number}", "validation", threshold))
        said[f"V{number}"] = (
            f"Flat over {plane.area:.1f}\u00a0m², seen on {len(plane.found)} lines"
            f"{', opposite ones among them' if _opposite(plane, survey) else ''}, "
            f"{plane.centre[2]:.0f} m high.{said_of[id(plane)]}"
        )
    progress(1.0, f"Proposed {len(chosen)} targets and {len(validation)} validation planes")
    return Proposal(tuple(proposed), said, sigma)


def _target(
    survey: Survey, plane: DetectedPlane, name: str, role: Role, threshold: float
) -> Target:
    # Where the prior boresight puts it, as if it had been clicked.
    line = plane.line if plane.line in plane.found else next(iter(plane.found))
    indices, aligned = plane.found[line].indices, survey.aligned
    apart = np.linalg.norm(aligned.clouds[line][indices] - plane.seed, axis=1)
    clicked = survey.clouds[line][indices[np.argmin(apart)][None]][0]
    seed: Triple = (float(clicked[0]), float(clicked[1]), float(clicked[2]))
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


@dataclass(frozen=True)
class _Judged:
    """What a plane is good for: anything, validation at need, or nothing; and why, in words."""

    use: Literal["any", "at need", "not flat", "poor"]
    words: str


def _judged(project: Project, survey: Survey) -> dict[str, _Judged]:
    """How good the lines show each target, by the judgement that its table shows."""
    found: dict[str, dict[str, SightingQuality]] = {target.name: {} for target in project.targets}
    for (name, line), quality in qualities(project, survey).items():
        found[name][line] = quality
    return {name: _judged_by(lines) for name, lines in found.items()}


def _judged_by(lines: Mapping[str, SightingQuality]) -> _Judged:
    poor = [line for line, quality in lines.items() if quality.light == "poor"]
    rough = [line for line, quality in lines.items() if quality.flatness == "poor"]
    words = f" Poor on {listed(poor)}: {lines[poor[0]].reasons[0]}" if poor else ""
    if len(rough) >= MOSTLY * len(lines):
        return _Judged("not flat", words)
    if len(poor) < MOSTLY * len(lines):
        return _Judged("any", words)
    return _Judged("at need" if len(poor) == MOSTLY * len(lines) else "poor", words)


def _too_few(project: Project, few: int, judged: Sequence[_Judged]) -> str:
    """That there are too few planes, and why others do not count."""
    rough = sum(each.use == "not flat" for each in judged)
    poor = len(judged) - few - rough
    others = [
        f"{count} more {'is' if count == 1 else 'are'} {what}"
        for count, what in ((rough, "not flat"), (poor, "seen poorly"))
        if count
    ]
    why = f" ({', '.join(others)})" if others else ""
    return (
        f"{project.name}: only {few} flat surface{'' if few == 1 else 's'} "
        f"{'is' if few == 1 else 'are'} seen on two lines or more{why}; "
        "set seeds on the targets, or put up boards."
    )


def _linearised(project: Project, survey: Survey) -> Linearised:
    """All planes together, linearised where the adjustment ends up with them."""
    observations = observations_of(project, survey)
    model = project.settings.stochastic_model
    prior = project.mounting("prior")
    # Planes that all face one way are refused, or accepted, where the pairs of them are known.
    result = adjust(observations, prior, model, accept_one_facing=True, diagnostics=False)
    shapes = np.stack([target.plane for target in result.targets])
    with one_thread():
        problem = Problem.of(observations, result.mounting, model)
        problem = replace(problem, noise=np.array([target.noise for target in result.targets]))
        if model.correlated:
            problem = problem.with_surface(np.maximum(result.surfaces, 1e-5))
        return problem.linearised(problem.start(result.mounting, shapes))


def _unevenness(project: Project, clouds: Mapping[str, Cloud]) -> dict[str, float]:
    """By how much the planes that lines show of one surface differ within it, metres, rms.

    A board is the same from everywhere. A tarpaulin or a bonnet shows each line another part of
    itself, or is no plane at all, and that is the most it can tell the adjustment.
    """
    uneven: dict[str, float] = {}
    for target in project.targets:
        placed = [clouds[sighting.line][sighting.indices] for sighting in target.sightings]
        everywhere = np.concatenate([points[:: 1 + len(points) // 1000] for points in placed])
        everywhere -= everywhere.mean(axis=0)
        normals = np.stack([fit_plane(points).normal for points in placed])
        normals *= np.sign(normals @ normals[0])[:, None]
        departed = everywhere @ (normals - normals.mean(axis=0)).T
        uneven[target.name] = float(np.sqrt((departed**2).mean() * len(placed) / (len(placed) - 1)))
    return uneven


def _with_unevenness(linearised: Linearised, uneven: dict[str, float]) -> Linearised:
    """The same with no surface said to be evener than it is."""
    problem = linearised.problem
    if not problem.model.correlated:
        return linearised
    for k, sighting in enumerate(problem.observations.sightings):
        sigma = np.maximum(problem.surface_sigma[k], uneven[sighting.target])
        problem = problem.with_surface_of([k], slice(0, 3), sigma)
    return problem.linearised(linearised.state)


def _facing_one_way(
    project: Project, planes: list[DetectedPlane], names: list[str]
) -> set[tuple[str, str]]:
    """Pairs of planes that face one way, which the adjustment would refuse."""
    if project.settings.accept_one_facing:
        return set()
    normals = {
        name: next(iter(plane.found.values())).plane.normal
        for name, plane in zip(names, planes, strict=True)
    }
    free = np.zeros(2, dtype=bool)
    return {
        (a, b)
        for a, b in combinations(names, 2)
        if one_facing(np.stack([normals[a], normals[b]]), free)
    }


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
        if ends_within(radius, [patch.extent for patch in plane.found.values()])
    }


def _chosen(
    linearised: Linearised, names: list[str], whole: set[str], one_way: set[tuple[str, str]]
) -> tuple[list[str], dict[str, str], Array]:
    """The planes to adjust with, the reason of each, and the sigmas they give.

    Raises
    ------
    AdjustmentError
        Where no two planes determine the boresight.
    """
    with one_thread():
        pairs = {
            pair: _sigma(linearised, pair) for pair in combinations(names, 2) if pair not in one_way
        }
        if not pairs:
            raise AdjustmentError(
                "All flat surfaces found face one way, and that leaves the boresight open; put up "
                "a board of another inclination, or set seeds by hand."
            )
        worst = {pair: float(sigma.max()) for pair, sigma in pairs.items()}
        best, pool = min(worst, key=worst.__getitem__), names
        # Boards rather than walls, where they tell enough: walls are wanted for validation.
        boards = {pair: sigma for pair, sigma in worst.items() if whole.issuperset(pair)}
        if boards and min(boards.values()) <= FAR_WORSE * worst[best]:
            best, pool = min(boards, key=boards.__getitem__), [n for n in names if n in whole]
        sigma, chosen = pairs[best], list(best)
        if not np.isfinite(sigma).all():
            raise AdjustmentError("No two of the planes found determine the boresight.")
        text = ", ".join(
            f"{angle} {np.degrees(value):.3f}°" for angle, value in zip(ANGLES, sigma, strict=True)
        )
        words = f"one of the two that tell most of the boresight, with sigmas of {text}."
        reasons = dict.fromkeys(best, words)
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
                f"it brings the sigma of {ANGLES[k]} from {np.degrees(sigma[k]):.3f}° to "
                f"{np.degrees(added[name][k]):.3f}°."
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
