"""Duplicate targets, which have points in common, and all other warnings about a project.

Points shared by two targets count twice in the adjustment. A validation plane that has the points
of a target is not an independent check.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.cause_warnings import SAME_ON_LINES_CODE, point_displacement
from lispac.adjustment.diagnostics.sign_check import ASSUMED_SIGN_CODES, SIGNS_AGREE_CODE
from lispac.adjustment.diagnostics.warnings import has_raised_sigmas, result_warnings
from lispac.adjustment.model.parameters import mounting_value_name
from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.messages import Action, Level, Message, error, note, shortened_list, warning
from lispac.picked_targets import PickedSighting, Target
from lispac.project import Project, ProposalPrediction
from lispac.warning_causes import RESULT_CAUSE, Cause

MIN_SHARED_FRACTION = 0.1
"""Smallest share of common points for which two targets are reported."""
SAME_SURFACE_FRACTION = 0.3
"""Targets with a larger share of common points are considered the same surface."""
MAX_SAMPLE_SIZE = 1000
"""Largest number of points of a sighting that are first compared with another one."""
MAX_SIGMA_DIFFERENCE = 0.2
"""Largest relative difference of a sigma from the predicted one that is not reported."""


@dataclass(frozen=True)
class TargetOverlap:
    """Two targets that have points in common.

    Attributes
    ----------
    one, other : str
        Names of the targets, in the order given.
    line : str
        Line on which they have the largest share of common points.
    share : float
        Share of the points of the smaller target on this line that are common.
    smaller : str
        Name of the target with fewer points on this line.
    """

    one: str
    other: str
    line: str
    share: float
    smaller: str

    @property
    def is_same_surface(self) -> bool:
        """True if both targets are the same surface."""
        return self.share > SAME_SURFACE_FRACTION


def find_overlaps(targets: Iterable[Target]) -> tuple[TargetOverlap, ...]:
    """Pairs of used targets that share at least `MIN_SHARED_FRACTION` of their points on a line."""
    used = [_TargetPoints.of(target, target.used_sightings) for target in targets]
    found = (_largest_overlap(one, other) for one, other in combinations(used, 2))
    return tuple(each for each in found if each is not None)


def find_overlap(target: Target, others: Iterable[Target]) -> TargetOverlap | None:
    """Largest overlap of a target with another one; None if there is no overlap.

    A target with the same name is skipped, since the new target replaces it.
    """
    own = _TargetPoints.of(target, target.sightings)
    found = (
        _largest_overlap(own, _TargetPoints.of(other, other.sightings))
        for other in others
        if other.name != target.name
    )
    overlapping = [each for each in found if each is not None]
    return max(overlapping, key=lambda each: each.share, default=None)


_OVERLAP_CODES = {
    (True, "twice"): "overlap.same_surface_twice",
    (True, "unchecked"): "overlap.same_surface_unchecked",
    (True, ""): "overlap.same_surface",
    (False, "twice"): "overlap.points_shared_twice",
    (False, "unchecked"): "overlap.points_shared_unchecked",
    (False, ""): "overlap.points_shared",
}
"""Code of the warning, by whether both targets are the same surface and by the consequence."""


def overlap_warning(target: Target, others: Iterable[Target]) -> Message | None:
    """Warning that a new target shares points with another one; None if it shares none."""
    others = tuple(others)
    found = find_overlap(target, others)
    if found is None:
        return None
    other = next(each for each in others if each.name == found.other)
    effect = "twice" if target.role == other.role else "unchecked"
    if target.role == other.role == "validation":
        effect = ""
    return warning(
        _OVERLAP_CODES[found.is_same_surface, effect], target=target.name, other=found.other,
        share=found.share, smaller=found.smaller, line=found.line,
    )  # fmt: skip


def duplicate_warnings(project: Project) -> tuple[Message, ...]:
    """Warnings about targets that share points, then notes."""
    return _duplicate_warnings(project.targets)


# The window requests the warnings for the same targets at every update of a progress bar.
@lru_cache(maxsize=2)
def _duplicate_warnings(targets: tuple[Target, ...]) -> tuple[Message, ...]:
    role = {target.name: target.role for target in targets}
    found = find_overlaps(targets)
    twice = [each for each in found if role[each.one] == role[each.other] == "target"]
    mixed = [each for each in found if role[each.one] != role[each.other]]
    messages = []
    if twice:
        messages.append(
            warning(
                "targets.counted_twice",
                count=len(twice), pairs=_overlap_items(twice), subject=_overlap_cause(twice[0]),
            )
        )  # fmt: skip
    if mixed:
        turned = [
            each if role[each.one] == "validation" else _swapped_overlap(each) for each in mixed
        ]
        messages.append(
            note(
                "targets.no_independent_check",
                count=len(mixed), pairs=_overlap_items(turned), subject=_overlap_cause(mixed[0]),
            )
        )  # fmt: skip
    return tuple(messages)


def all_warnings(project: Project, also: Iterable[Message] = ()) -> tuple[Message, ...]:
    """All warnings and notes about a project; sorted by level if it has a result."""
    also = (*project_warnings(project), *also)
    return result_warnings(project.result, project.cross_checks, also) if project.result else also


def project_warnings(project: Project) -> tuple[Message, ...]:
    """Warnings about the targets, the predicted sigmas and the files of a project."""
    return (
        *duplicate_warnings(project),
        *prediction_warnings(project),
        *lidar_noise_notes(project),
        *single_line_notes(project),
        *data_warnings(project),
    )


def prediction_warnings(project: Project) -> tuple[Message, ...]:
    """Messages on sigmas that differ from those predicted when the targets were proposed.

    Larger sigmas give a note. Smaller sigmas give a warning, since they may be too optimistic. The
    prediction assumes an exact lever arm.
    """
    result, prediction = project.result, project.prediction
    if result is None or prediction is None:
        return ()
    ratio = result.with_exact_lever_arm.sigma / prediction.sigma
    found = []
    if (ratio < 1 - MAX_SIGMA_DIFFERENCE).any():
        angles = _predicted_angles(result, prediction, ratio < 1 - MAX_SIGMA_DIFFERENCE)
        found.append(
            warning(
                "targets.sigma_below_prediction",
                limit=MAX_SIGMA_DIFFERENCE,
                angles=angles,
                subject=RESULT_CAUSE,
            )
        )
    if (ratio > 1 + MAX_SIGMA_DIFFERENCE).any():
        angles = _predicted_angles(result, prediction, ratio > 1 + MAX_SIGMA_DIFFERENCE)
        found.append(
            note(
                "targets.sigma_above_prediction",
                limit=MAX_SIGMA_DIFFERENCE,
                angles=angles,
                subject=RESULT_CAUSE,
            )
        )
    return tuple(found)


NOISE_ACTIONS = ("use_lidar_noise", "scale_lidar_noise")
"""Codes of the actions that give the LiDAR the noise found in the residuals."""


def lidar_noise_notes(project: Project) -> tuple[Message, ...]:
    """Note on the LiDAR noise in the residuals if it differs from the given one, with an action."""
    result, settings = project.result, project.settings
    if result is None or (ratio := result.lidar_noise_ratio) is None:
        return ()
    # With a smaller noise the angles are more precise, unless their sigmas were raised anyway.
    is_conservative = ratio < 1 and not has_raised_sigmas(result)
    field = Cause.of_field("lidar_sigma")
    if settings.lidar_sigma_xyz is None and settings.lidar_beam_sigma is None:
        is_assumed = "LiDAR" in project.assumed_sigmas
        code = "adjustment.lidar_noise_assumed" if is_assumed else "adjustment.lidar_noise"
        if is_conservative and is_assumed:
            code = "adjustment.lidar_noise_assumed_conservative"
        elif is_conservative:
            code = "adjustment.lidar_noise_conservative"
        values = {"given": settings.used_lidar_sigma, "measured": ratio * settings.used_lidar_sigma}
        return (note(code, **values, subject=field, actions=(Action("use_lidar_noise", values),)),)
    code = "adjustment.lidar_noise_ratio"
    if is_conservative:
        code = "adjustment.lidar_noise_ratio_conservative"
    scale = Action("scale_lidar_noise", {"ratio": ratio})
    return (note(code, ratio=ratio, subject=field, actions=(scale,)),)


def _predicted_angles(
    result: AdjustmentResult, prediction: ProposalPrediction, named: NDArray[np.bool_]
) -> list[Message]:
    """Predicted and estimated sigmas of the selected angles, as items of a message."""
    return [
        note(
            "item.angle_predicted", angle=mounting_value_name(angle),
            predicted=float(prediction.sigma[k]),
            sigma=float(result.with_exact_lever_arm.sigma[k]),
        )
        for k, angle in enumerate(ANGLES) if named[k]
    ]  # fmt: skip


def single_line_notes(project: Project) -> tuple[Message, ...]:
    """Note on targets that are not used because they were found on only one line."""
    compared = project.compared_targets
    alone = [
        target
        for target in project.targets_of_role("target")
        if target.used_sightings and target not in compared
    ]
    if not alone:
        return ()
    sightings = [
        note("item.sighting", target=target.name, line=target.used_sightings[0].line)
        for target in alone
    ]
    first = Cause.of_target(alone[0].name)
    return (
        note("targets.single_line_targets", sightings=shortened_list(sightings), subject=first),
    )


def data_warnings(project: Project) -> tuple[Message, ...]:
    """Warnings about the imported files, which apply to every result computed from them.

    Warnings with the same code about several lines become one message, with the text of the first
    and the names of the other lines. Warnings that a sign is assumed are omitted if the residuals
    agree with this sign only, which a note about the result says.
    """
    groups: dict[str, list[Message]] = {}
    result = project.result
    confirmed = result is not None and any(m.code == SIGNS_AGREE_CODE for m in result.messages)
    for message in project.data_messages:
        is_answered = confirmed and message.code in ASSUMED_SIGN_CODES
        if message.level is not Level.NOTE and not is_answered:
            groups.setdefault(message.code, []).append(message)
    found = []
    for first, *others in groups.values():
        lines = [each.subject.name for each in others if each.subject is not None]
        if not lines:
            found.append(replace(first, subject=first.subject or RESULT_CAUSE))
            continue
        params: dict[str, Any] = {"reason": first, "lines": lines}
        effects = [point_displacement(each) for each in (first, *others)]
        known = [each for each in effects if each is not None]
        if len(known) == len(effects):
            params["effect"] = max(known)
        make = error if first.level is Level.ERROR else warning
        found.append(make(SAME_ON_LINES_CODE, subject=first.subject or RESULT_CAUSE, **params))
    return tuple(found)


def _overlap_cause(overlap: TargetOverlap) -> Cause:
    return Cause.of_sighting(overlap.smaller, overlap.line)


def _swapped_overlap(overlap: TargetOverlap) -> TargetOverlap:
    return replace(overlap, one=overlap.other, other=overlap.one)


def _overlap_items(overlaps: Sequence[TargetOverlap]) -> tuple[str | Message, ...]:
    """Pairs of targets for a message."""
    return shortened_list(
        [
            note(
                "item.points_in_common",
                one=each.one, other=each.other, share=each.share, line=each.line,
            )
            for each in overlaps
        ]
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class _TargetPoints:
    """Sorted indices of the points of a target on each line."""

    name: str
    lines: dict[str, NDArray[np.int64]]

    @classmethod
    def of(cls, target: Target, sightings: Iterable[PickedSighting]) -> "_TargetPoints":
        # The indices are usually sorted already, which a stable sort detects quickly.
        return cls(target.name, {s.line: np.sort(s.indices, kind="stable") for s in sightings})


def _largest_overlap(one: _TargetPoints, other: _TargetPoints) -> TargetOverlap | None:
    """Overlap of two targets on the line where it is largest; None if there is none."""
    found = []
    for line, first in one.lines.items():
        second = other.lines.get(line)
        share = 0.0 if second is None else _shared_fraction(first, second)
        if second is not None and share >= MIN_SHARED_FRACTION:
            smaller = one if len(first) <= len(second) else other
            found.append(TargetOverlap(one.name, other.name, line, share, smaller.name))
    return max(found, key=lambda each: each.share, default=None)


def _shared_fraction(first: NDArray[np.int64], second: NDArray[np.int64]) -> float:
    """Share of the smaller target's points that the other has too, in [0, 1]; both sorted."""
    small, large = sorted((first, second), key=len)
    if not len(small):
        return 0.0
    # Most pairs have no common points; a sample of the points is enough to detect that.
    share = _fraction_among(small[:: 1 + len(small) // MAX_SAMPLE_SIZE], large)
    return share if share < MIN_SHARED_FRACTION / 2 else _fraction_among(small, large)


def _fraction_among(numbers: NDArray[np.int64], among: NDArray[np.int64]) -> float:
    """Share of the numbers that are in ``among``, which is sorted."""
    places = np.minimum(np.searchsorted(among, numbers), len(among) - 1)
    return float(np.mean(among[places] == numbers))
