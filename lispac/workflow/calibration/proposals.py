"""Automatic detection of targets and validation planes, proposed to the user."""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.sighting_warnings import probably_not_flat
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.parameters import mounting_value_name
from lispac.adjustment.model.threads import single_blas_thread
from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.determinability import have_one_orientation
from lispac.errors import AdjustmentError, TargetNotFound
from lispac.geometry.planes import fit_plane
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note, warning
from lispac.progress import Progress, Step, no_progress, progress_of_rounds, sub_progress
from lispac.project import PickedSighting, Project, Role, Target, Triple
from lispac.survey.cloud import Cloud, place_clouds
from lispac.targets.boresight_smear import ROUGH_BORESIGHT_SIGMA
from lispac.targets.occlusion import does_plane_end_within
from lispac.targets.plane_detection import DetectedPlane, PatchesAndReasons, detect_planes
from lispac.targets.plane_finder import FinderSettings
from lispac.targets.rough_alignment import Alignment
from lispac.targets.sighting_quality import SightingQuality
from lispac.validation.plane_comparison import are_reciprocal, comparable_pairs
from lispac.warning_causes import RESULT_CAUSE, Cause
from lispac.workflow.calibration.estimation import estimate, observations_of
from lispac.workflow.calibration.method_errors import replace_suggested_actions
from lispac.workflow.calibration.sighting_assessment import sighting_qualities
from lispac.workflow.calibration.target_choice import (
    MIN_TARGETS,
    MIN_VALIDATION_PLANES,
    CandidatePlanes,
    choose_targets,
)
from lispac.workflow.calibration.target_search import ALIGNED_MAX_SHIFT, find_planes_in_lines
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

MIN_VALIDATION_AREA = 2.0
"""Smallest area of a validation plane, square metres, if there are enough planes of that size."""
MAX_POOR_SHARE = 0.5
"""Limit for the share of a plane's sightings with poor quality.

A plane is not proposed if the flatness is not good in this share of its sightings or more. If the
rating is poor in exactly this share, the plane is proposed only if there are too few others; if it
is poor in more, the plane is not proposed."""
MAX_SHARED_POINT_SHARE = 0.01
"""Largest share of the points of a plane in common with another one that is not an overlap."""
OBLIQUE_CODE = "quality.oblique"
"""Code of the reason of a rating that the beams are oblique."""
_Use = Literal["any", "at need", "not flat", "poor"]
UNCHECKED_TARGET_CODES = {
    "adjustment.target_unchecked", "adjustment.targets_clustered", "adjustment.targets_act_as_one",
    "adjustment.carried_by_one",
}  # fmt: skip
"""Codes of warnings that the targets do not check each other."""
MIN_SIGMA_INCREASE = 0.02
"""Relative increase of a predicted sigma without a target, below which the target is said to check
the others instead of to improve the angle."""

MOVABLE_OBJECTS_NOTE = note("propose.check_movable")
"""Note for every proposal: an object that moved between two lines is not recognised."""


@dataclass(frozen=True, eq=False)
class Proposal:
    """Proposed targets and validation planes, with reasons.

    Attributes
    ----------
    targets : tuple of Target
        Named T1, T2 ... and V1, V2 ..., with their sightings in every line.
    reasons : dict of name to Message
    predict : callable
        From names of targets, proposed or ``picked``, to the predicted sigmas of roll, pitch, yaw,
        ndarray of shape (3,), radians: from the geometry of these targets, with the given standard
        deviations and the noise observed on all flat planes. Infinite if the targets do not
        determine the angles.
    picked : tuple of str
        Targets of the project that would have been proposed.
    warnings : tuple of Message
        Warnings of an adjustment of the proposed targets, without notes, and a warning if no
        validation plane is proposed.
    notes : tuple of Message
        What the user has to check.
    """

    targets: tuple[Target, ...]
    reasons: dict[str, Message]
    predict: Callable[[Collection[str]], Array]
    picked: tuple[str, ...] = ()
    warnings: tuple[Message, ...] = ()
    notes: tuple[Message, ...] = (MOVABLE_OBJECTS_NOTE,)

    @property
    def sigma(self) -> Array:
        """Predicted sigmas with all proposed and picked targets, as in `predict`."""
        return self.predicted_sigma(target.name for target in self.targets)

    def predicted_sigma(self, names: Iterable[str]) -> Array:
        """Predicted sigmas with the proposed targets of given names and the picked ones.

        Validation planes among the names are ignored. As in `predict`.
        """
        chosen = set(names)
        used = [t.name for t in self.targets if t.role == "target" and t.name in chosen]
        return self.predict((*used, *self.picked))


def propose_targets(
    project: Project, survey: Survey, *, progress: Progress = no_progress
) -> Proposal:
    """Propose targets and validation planes, without changing the project.

    The targets are the flat planes that determine the angles best and check each other (see
    `target_choice`). They are adjusted. Planes that are not flat with the estimated boresight, or
    with a sighting that the adjustment rejects, are replaced. So are planes that the adjustment
    calls probably not flat, if enough others remain. Validation planes are chosen from the other
    flat planes on which lines can be compared, at positions far from each other.

    Raises
    ------
    TargetNotFound
        If there are fewer than two flat planes on two or more lines.
    AdjustmentError
        If the planes do not determine the boresight.
    """
    threshold = project.settings.threshold
    progress(0.0, gettext_lazy("Aligning the lines"))
    named = _detect_planes(survey.alignment, threshold, sub_progress(progress, 0.05, 0.4))
    progress(0.4, gettext_lazy("Fitting the planes"))
    targets = tuple(
        _proposed_target(survey, plane, name, "target", threshold) for name, plane in named.items()
    )
    judged = _assess_planes(replace(project, targets=targets, result=None), survey)
    flat = [target for target in targets if judged[target.name].use == "any"]
    if len(flat) < 2:
        raise TargetNotFound(_too_few_planes_message(project, len(flat), list(judged.values())))
    progress(0.45, gettext_lazy("Selecting the targets"))
    rounds = progress_of_rounds(_without_steps(sub_progress(progress, 0.45, 0.8)))
    with replace_suggested_actions(project.name, "propose"):
        chosen, solved, planes = _choose_flat_targets(project, survey, flat, named, judged, rounds)
    if len(chosen) < MIN_TARGETS:
        spare = [target for target in targets if judged[target.name].use == "at need"]
        flat = [target for target in targets if judged[target.name].use == "any"]
        with suppress(AdjustmentError, TargetNotFound):
            others = _choose_flat_targets(project, survey, [*flat, *spare], named, judged, rounds)
            if len(others[0]) > len(chosen):
                chosen, solved, planes = others
    assert solved.result is not None
    left = [target for target in targets if target.name not in chosen]
    progress(0.8, gettext_lazy("Selecting the validation planes"))
    compared = _comparable_planes(
        solved, survey, left, judged, progress=sub_progress(progress, 0.8, 0.95)
    )
    progress(0.95)
    separate = {
        name: pairs
        for name, pairs in compared.items()
        if not any(_do_planes_overlap(named[name], named[other]) for other in chosen)
    }
    proposed: list[Target] = []
    reasons: dict[str, Message] = {}
    for number, name in enumerate(chosen, start=1):
        proposed.append(_proposed_target(survey, named[name], f"T{number}", "target", threshold))
        reasons[f"T{number}"] = _target_reason(
            planes, chosen, name, len(named[name].found), judged[name]
        )
    ordered = _choose_validation_planes({name: named[name] for name in separate}, separate, survey)
    for number, name in enumerate(ordered, start=1):
        plane, is_reciprocal = named[name], _has_reciprocal_lines(separate[name], survey)
        proposed.append(_proposed_target(survey, plane, f"V{number}", "validation", threshold))
        reasons[f"V{number}"] = _validation_plane_reason(plane, is_reciprocal, judged[name])
    warnings = _adjustment_warnings(solved.result)
    if not ordered:
        warnings += (warning("targets.no_validation_plane", subject=RESULT_CAUSE),)
    progress(1.0)
    surfaces = {f"T{number}": name for number, name in enumerate(chosen, start=1)}

    def predict(names: Collection[str]) -> Array:
        return planes.predicted_sigma(surfaces[name] for name in names)

    return Proposal(tuple(proposed), reasons, predict, (), warnings)


def _detect_planes(
    aligned: Alignment, threshold: float, progress: Progress
) -> dict[str, DetectedPlane]:
    """Detect planes on the aligned lines, named P1, P2 ..."""
    settings = FinderSettings(threshold=threshold)
    if aligned.is_aligned:
        settings = replace(settings, max_shift=ALIGNED_MAX_SHIFT)

    def find(seed: Array, line: str, step: Progress) -> PatchesAndReasons:
        return find_planes_in_lines(
            aligned.clouds, seed, settings,
            first_line=line, accuracy=aligned.accuracy, progress=step,
        )  # fmt: skip

    detected = detect_planes(
        {name: cloud.sample for name, cloud in aligned.clouds.items()},
        settings,
        lines=aligned.clouds,
        find=find,
        progress=progress,
    )
    return {f"P{k + 1}": plane for k, plane in enumerate(detected)}


def _comparable_planes(
    solved: Project,
    survey: Survey,
    left: Sequence[Target],
    judged: Mapping[str, "_PlaneAssessment"],
    *,
    progress: Progress,
) -> dict[str, tuple[tuple[str, str], ...]]:
    """Candidate validation planes, with the pairs of lines that can be compared on them.

    They pass the same flatness test as the targets. Poorly observed planes come last, and are
    included only until there are `MIN_VALIDATION_PLANES` planes.
    """
    assert solved.result is not None
    usable = [target for target in left if judged[target.name].use in ("any", "at need")]
    if _is_boresight_known(solved.result):
        now = _assess_planes(replace(solved, targets=tuple(usable)), survey, progress=progress)
        usable = [target for target in usable if now[target.name].flat]
    placed = place_clouds(survey.clouds, solved.result.mounting)
    found: dict[str, tuple[tuple[str, str], ...]] = {}
    for target in sorted(usable, key=lambda target: judged[target.name].use == "at need"):
        if judged[target.name].use == "at need" and len(found) >= MIN_VALIDATION_PLANES:
            break
        before, after = (
            {
                sighting.line: clouds[sighting.line][sighting.indices]
                for sighting in target.sightings
            }
            for clouds in (survey.clouds, placed)
        )
        if pairs := comparable_pairs(before, after):
            found[target.name] = pairs
    return found


def _is_boresight_known(result: AdjustmentResult) -> bool:
    """True if the boresight is precise enough to attribute a bend of a plane to the surface."""
    return float(result.sigma.max()) <= ROUGH_BORESIGHT_SIGMA


def _choose_flat_targets(
    project: Project,
    survey: Survey,
    flat: Sequence[Target],
    named: Mapping[str, DetectedPlane],
    judged: dict[str, "_PlaneAssessment"],
    rounds: Iterator[Progress],
) -> tuple[list[str], Project, CandidatePlanes]:
    """Choose the targets without those that their adjustment calls probably not flat.

    As `_choose_targets`. Such targets are kept if fewer than `MIN_TARGETS` others can be chosen.
    """
    found = _choose_targets(project, survey, flat, named, judged, rounds)
    while True:
        chosen, solved, _ = found
        assert solved.result is not None
        bent = probably_not_flat(solved.result)
        marked = judged | {
            name: replace(judged[name], use="not flat")
            for name, target in zip(chosen, solved.targets, strict=True)
            if target.name in bent
        }
        left = [each for each in flat if marked[each.name].use != "not flat"]
        if not bent or len(left) < MIN_TARGETS:
            return found
        try:
            others = _choose_targets(project, survey, left, named, marked, rounds)
        except (AdjustmentError, TargetNotFound):
            return found
        if len(others[0]) < MIN_TARGETS:
            return found
        judged |= marked
        found = others


def _choose_targets(
    project: Project,
    survey: Survey,
    flat: Sequence[Target],
    named: Mapping[str, DetectedPlane],
    judged: dict[str, "_PlaneAssessment"],
    rounds: Iterator[Progress],
) -> tuple[list[str], Project, CandidatePlanes]:
    """Choose the targets; returns their names, a project with their adjustment, and all planes.

    Planes that turn out not to be flat, and those with a rejected sighting, are marked as not flat
    in ``judged``.

    Raises
    ------
    TargetNotFound
        If fewer than two planes remain.
    AdjustmentError
        If the planes do not determine the angles.
    """
    candidates = list(flat)
    while True:
        progress = next(rounds)
        everything = replace(project, targets=tuple(candidates), result=None)
        planes = _candidate_planes(
            everything, survey, {each.name: named[each.name] for each in candidates},
            progress=sub_progress(progress, 0.0, 0.3),
        )  # fmt: skip
        chosen = choose_targets(planes)
        targets = tuple(
            replace(each, name=f"T{number}")
            for number, name in enumerate(chosen, start=1)
            for each in candidates
            if each.name == name
        )
        solved = estimate(
            replace(project, targets=targets, result=None), survey,
            cross_check=False, progress=sub_progress(progress, 0.3, 0.8),
        )  # fmt: skip
        result = solved.result
        assert result is not None
        suspects = {sighting.target for sighting in result.rejected_sightings} | set(
            result.excluded_targets
        )
        known = _is_boresight_known(result)
        step = sub_progress(progress, 0.8, 1.0)
        now = _assess_planes(solved, survey, progress=step) if known else {}
        rejected = {
            name
            for name, target in zip(chosen, targets, strict=True)
            if target.name in suspects or (known and not now[target.name].flat)
        }
        if not rejected:
            return chosen, solved, planes
        judged |= {name: replace(judged[name], use="not flat") for name in rejected}
        candidates = [each for each in candidates if each.name not in rejected]
        if len(candidates) < 2:
            raise TargetNotFound(
                _too_few_planes_message(project, len(candidates), list(judged.values()))
            )


def _candidate_planes(
    project: Project, survey: Survey, named: Mapping[str, DetectedPlane], *, progress: Progress
) -> CandidatePlanes:
    """Candidate planes for the choice, from the project's targets."""
    linearised = _linearise_planes(project, survey, progress)
    form_errors = _form_errors(project, place_clouds(survey.clouds, linearised.state.mounting))
    named = {name: named[name] for name in linearised.problem.observations.targets}
    return CandidatePlanes(
        _with_form_errors(linearised, form_errors),
        linearised,
        {name: plane.centre for name, plane in named.items()},
        _complete_planes(named),
        _parallel_pairs(project, named),
    )


def _target_reason(
    planes: CandidatePlanes,
    chosen: Sequence[str],
    name: str,
    lines: int,
    judged: "_PlaneAssessment",
) -> Message:
    """Reason for a target, with the lines on which its beams are oblique."""
    found = _precision_reason(planes, chosen, name, lines)
    if not judged.oblique:
        return found
    return note(
        "propose.target_oblique", target=found, lines=judged.oblique, angle=judged.incidence
    )


def _precision_reason(
    planes: CandidatePlanes, chosen: Sequence[str], name: str, lines: int
) -> Message:
    """Reason for a target: the angle whose sigma would increase most without it."""
    without = planes.predicted_sigma(set(chosen) - {name})
    now = planes.predicted_sigma(chosen)
    k = int(np.argmax(without / now))
    if len(chosen) < MIN_TARGETS or not np.isfinite(without[k]):
        return note("propose.target_needed", lines=lines)
    if without[k] < (1.0 + MIN_SIGMA_INCREASE) * now[k]:
        return note("propose.target_checks", lines=lines, share=MIN_SIGMA_INCREASE)
    return note(
        "propose.target",
        lines=lines, angle=mounting_value_name(ANGLES[k]),
        without=float(without[k]), sigma=float(now[k]),
    )  # fmt: skip


def _validation_plane_reason(
    plane: DetectedPlane, is_reciprocal: bool, judged: "_PlaneAssessment"
) -> Message:
    """Reason for a validation plane, with the lines that observe it poorly."""
    found = note(
        "propose.validation_plane_reciprocal"
        if is_reciprocal
        else "propose.validation_plane",
        area=plane.area, lines=len(plane.found), height=float(plane.centre[2]),
    )  # fmt: skip
    if not judged.poor:
        return found
    reason = judged.reason
    return note("propose.validation_plane_poor", plane=found, lines=judged.poor, reason=reason)


def _adjustment_warnings(result: AdjustmentResult) -> tuple[Message, ...]:
    """Warnings of the adjustment of the chosen targets."""
    found = [message for message in result_warnings(result, None) if message.is_serious]
    if any(message.code in UNCHECKED_TARGET_CODES for message in found):
        found.append(warning("targets.proposal_unchecked", subject=RESULT_CAUSE))
    if bent := sorted(probably_not_flat(result)):
        found.append(
            warning(
                "targets.proposal_not_flat",
                count=len(bent), targets=bent, subject=Cause.of_target(bent[0]),
            )
        )  # fmt: skip
    return tuple(found)


def _do_planes_overlap(plane: DetectedPlane, other: DetectedPlane) -> bool:
    """True if two planes have points in common."""
    return any(
        np.isin(plane.found[line].indices, other.found[line].indices).mean()
        > MAX_SHARED_POINT_SHARE
        for line in plane.found
        if line in other.found
    )


def _proposed_target(
    survey: Survey, plane: DetectedPlane, name: str, role: Role, threshold: float
) -> Target:
    # Placed with the prior boresight, like a clicked seed.
    line = plane.line if plane.line in plane.found else next(iter(plane.found))
    indices, aligned = plane.found[line].indices, survey.alignment
    distances = np.linalg.norm(aligned.clouds[line][indices] - plane.seed, axis=1)
    clicked = survey.clouds[line][indices[np.argmin(distances)][None]][0]
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
class _PlaneAssessment:
    """Possible use of a plane, from the quality of its sightings.

    Attributes
    ----------
    use : "any"; "at need" if there are too few others; "not flat" and "poor" planes are not used
    poor : lines with a sighting of poor quality
    reason : reason for the rating of the first of these
    oblique : lines with a sighting that is rated lower because the beams are oblique
    incidence : largest angle between beams and surface normal on these lines, radians
    """

    use: _Use
    poor: tuple[str, ...]
    reason: Message | str
    oblique: tuple[str, ...] = ()
    incidence: float = 0.0

    @property
    def flat(self) -> bool:
        return self.use != "not flat"


def _assess_planes(
    project: Project, survey: Survey, *, progress: Progress = no_progress
) -> dict[str, _PlaneAssessment]:
    """Assess each plane by the quality of its sightings."""
    found: dict[str, dict[str, SightingQuality]] = {target.name: {} for target in project.targets}
    qualities = sighting_qualities(project, survey, progress=_without_steps(progress))
    for (name, line), quality in qualities.items():
        found[name][line] = quality
    return {name: _assess_plane(lines) for name, lines in found.items()}


def _without_steps(progress: Progress) -> Progress:
    """Report fractions only.

    Steps of an adjustment, or names of planes that are not those of the proposal, would confuse.
    """

    def report(fraction: float, step: Step | None = None) -> None:
        progress(fraction)

    return report


def _assess_plane(lines: Mapping[str, SightingQuality]) -> _PlaneAssessment:
    poor = tuple(line for line, quality in lines.items() if quality.rating == "poor")
    uneven = [line for line, quality in lines.items() if quality.flatness != "good"]
    reason = lines[poor[0]].reasons[0] if poor else ""
    angles = {
        line: quality.incidence or 0.0
        for line, quality in lines.items()
        if any(isinstance(each, Message) and each.code == OBLIQUE_CODE for each in quality.reasons)
    }
    use: _Use
    if len(uneven) >= MAX_POOR_SHARE * len(lines):
        use = "not flat"
    elif len(poor) < MAX_POOR_SHARE * len(lines):
        use = "any"
    else:
        use = "at need" if len(poor) == MAX_POOR_SHARE * len(lines) else "poor"
    return _PlaneAssessment(use, poor, reason, tuple(angles), max(angles.values(), default=0.0))


def _too_few_planes_message(
    project: Project, flat: int, judged: Sequence[_PlaneAssessment]
) -> Message:
    """Error that there are too few planes, with the numbers of uneven and poorly observed ones."""
    uneven = sum(not each.flat for each in judged)
    poor = len(judged) - flat - uneven
    return error(
        "propose.few_flat_surfaces", project=project.name, count=flat, uneven=uneven, poor=poor
    )


def _linearise_planes(project: Project, survey: Survey, progress: Progress) -> LinearisedProblem:
    """Linearised adjustment of all planes together, at its solution."""
    observations = observations_of(project, survey)
    model = project.settings.stochastic_model
    prior = project.mounting("prior")
    # Planes of one orientation are checked later, by pairs.
    result = adjust(
        observations, prior, model,
        accept_single_orientation=True, diagnostics=False, progress=progress,
    )  # fmt: skip
    observations = observations.without_targets(result.excluded_targets)
    shapes = np.stack([target.plane for target in result.targets])
    with single_blas_thread():
        problem = AdjustmentProblem.of(observations, result.mounting, model)
        problem = replace(problem, noise=np.array([target.noise for target in result.targets]))
        if model.correlated:
            problem = problem.with_surface_sigma(np.maximum(result.surfaces, 1e-5))
        return problem.linearised(problem.start(result.mounting, shapes))


def _form_errors(project: Project, clouds: Mapping[str, Cloud]) -> dict[str, float]:
    """RMS difference of the planes of different lines on each surface, metres.

    A board has the same plane in all lines. Of a tarpaulin or a car bonnet, each line observes a
    different part, or it is not plane, which limits its information for the adjustment.
    """
    form_errors: dict[str, float] = {}
    for target in project.targets:
        placed = [clouds[sighting.line][sighting.indices] for sighting in target.sightings]
        everywhere = np.concatenate([points[:: 1 + len(points) // 1000] for points in placed])
        everywhere -= everywhere.mean(axis=0)
        normals = np.stack([fit_plane(points).normal for points in placed])
        normals *= np.sign(normals @ normals[0])[:, None]
        departed = everywhere @ (normals - normals.mean(axis=0)).T
        variance = (departed**2).mean() * len(placed) / (len(placed) - 1)
        form_errors[target.name] = float(np.sqrt(variance))
    return form_errors


def _with_form_errors(
    linearised: LinearisedProblem, form_errors: dict[str, float]
) -> LinearisedProblem:
    """Linearised problem with surface sigmas not smaller than the observed form errors."""
    problem = linearised.problem
    if not problem.model.correlated:
        return linearised
    for k, sighting in enumerate(problem.observations.sightings):
        sigma = np.maximum(problem.surface_sigma[k], form_errors[sighting.target])
        problem = problem.with_sighting_surface_sigma([k], sigma)
    return problem.linearised(linearised.state)


def _parallel_pairs(project: Project, planes: Mapping[str, DetectedPlane]) -> set[tuple[str, str]]:
    """Pairs of planes of the same orientation, which the adjustment would refuse."""
    if project.settings.accept_single_orientation:
        return set()
    normals = {
        name: next(iter(plane.found.values())).plane.normal for name, plane in planes.items()
    }
    free = np.zeros(2, dtype=bool)
    return {
        (a, b)
        for a, b in combinations(planes, 2)
        if have_one_orientation(np.stack([normals[a], normals[b]]), free)
    }


def _complete_planes(planes: Mapping[str, DetectedPlane]) -> set[str]:
    """Names of planes that lie completely within the search radius, with the same outline."""
    radius = FinderSettings().radius
    return {
        name
        for name, plane in planes.items()
        if does_plane_end_within(radius, [patch.extent for patch in plane.found.values()])
    }


def _has_reciprocal_lines(pairs: Sequence[tuple[str, str]], survey: Survey) -> bool:
    return any(are_reciprocal(survey.heading[a], survey.heading[b]) for a, b in pairs)


def _choose_validation_planes(
    planes: Mapping[str, DetectedPlane],
    compared: Mapping[str, Sequence[tuple[str, str]]],
    survey: Survey,
) -> list[str]:
    """Choose up to `MIN_VALIDATION_PLANES` + 1 validation planes, in the order of their use.

    Planes smaller than `MIN_VALIDATION_AREA` are used only if there are too few larger ones. The
    first is the largest one, with reciprocal lines if there are any. Each further one is the
    farthest from those already chosen; planes with reciprocal lines come first.
    """
    large = [name for name, plane in planes.items() if plane.area >= MIN_VALIDATION_AREA]
    names = large if len(large) >= MIN_VALIDATION_PLANES else list(planes)
    is_reciprocal = {name: _has_reciprocal_lines(compared[name], survey) for name in names}
    left = sorted(names, key=lambda name: (not is_reciprocal[name], -planes[name].area))
    kept = left[:1]
    while len(left) > len(kept) and len(kept) < MIN_VALIDATION_PLANES + 1:
        rest = [name for name in left if name not in kept]
        opposite = [name for name in rest if is_reciprocal[name]] or rest
        kept.append(
            max(
                opposite,
                key=lambda name: min(
                    float(np.linalg.norm(planes[name].centre - planes[other].centre))
                    for other in kept
                ),
            )
        )
    return kept
