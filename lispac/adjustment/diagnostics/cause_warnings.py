"""Warnings about the possible causes of residuals that contradict the model."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from lispac.adjustment.diagnostics.findings import critical_test_value, sighting_status
from lispac.adjustment.diagnostics.sighting_warnings import MAX_WRONG_LINE_SHARE
from lispac.adjustment.model.parameters import (
    OPTIONAL_NAMES,
    amount_with_unit,
    change_text,
    changed_value,
    has_opposite_sign,
    mounting_value_name,
)
from lispac.adjustment.result import ANGLES, AdjustmentResult, ContradictedParameter, PossibleCause
from lispac.adjustment.solve.omitted_parameters import MIN_ANGLE_CHANGE_SIGMAS
from lispac.messages import Message, note, warning
from lispac.survey.georeferencing import MOUNTING_VALUE_NAMES
from lispac.warning_causes import RESULT_CAUSE, Cause

DATA_ERROR_CODES = {
    "audit.several_scanners": "cause.several_scanners",
    "audit.several_sources": "cause.several_sources",
    "audit.same_time": "cause.same_time",
    "audit.time_resolution": "cause.time_resolution",
    "recovery.height_offset": "cause.height_offset",
    "recovery.time_offset": "cause.time_offset",
    "recovery.lever_arm_x": "cause.lever_arm",
    "recovery.lever_arm_y": "cause.lever_arm",
    "recovery.lever_arm_z": "cause.lever_arm",
    "recovery.roll_sign": "cause.attitude_sign",
    "recovery.pitch_sign": "cause.attitude_sign",
    "recovery.roll_pitch_signs": "cause.attitude_sign",
    "recovery.several_causes": "cause.off_the_beams",
    "recovery.unexplained": "cause.off_the_beams",
    "trajectory.gap_interpolated": "cause.trajectory_gap",
    "trajectory.position_held": "cause.position_held",
    "trajectory.rate_too_low": "cause.rate_too_low",
}
"""Codes of warnings about errors in the imported data, and code of the name of each error."""
SAME_ON_LINES_CODE = "data.same_on_lines"
"""Code of a warning about several lines; its ``reason`` is the warning about the first line."""
EFFECT_PARAMETERS = ("effect", "shift", "misfit")
"""Names of message parameters with the displacement of points, metres."""
FORM_ERROR_CODES = ("adjustment.surfaces_differ", "adjustment.surfaces_displaced")
"""Codes of the notes that sightings deviate from the shape of their target."""
CONSEQUENCE_CODES = (
    "adjustment.large_sigma", "adjustment.sighting_disagrees", "adjustment.target_cut",
)  # fmt: skip
"""Codes of messages that recommend other points or targets. A wrong value of the mounting that
causes most of the residuals causes them too."""
EXPLAINED_CODES = frozenset(
    {
        "acceptance.cause_geometry", "acceptance.cause_pos", "acceptance.cause_scatter",
        "acceptance.halves_differ", "adjustment.cross_check", "adjustment.line_jumped",
        "adjustment.noise", "project.doubtful_sighting", "project.doubtful_sightings",
        "project.poor_sighting", "report.chi_square_high", "report.chi_square_high_assumed",
        "report.chi_square_high_noise", "report.noise_differs", "report.noise_differs_given",
        "report.sightings",
    }
)  # fmt: skip
"""Codes of notes on residuals, sightings, parts of the data and probable causes, which a wrong
value of the mounting that causes most of the residuals explains."""
CONTRADICTION_PREFIX = "adjustment.contradicted_"
"""Start of the codes of the warnings that the data contradict a given value of the mounting."""
MIN_EFFECT_RATIO = 0.5
"""Smallest ratio of the effect of a known error to that of a candidate which it explains."""


@dataclass(frozen=True)
class KnownError:
    """An error known from the imported data.

    Attributes
    ----------
    code : str
        Code of the name of the error, such as ``cause.height_offset``.
    effect : float, metres
        Displacement of points by the error; infinite if unknown.
    """

    code: str
    effect: float

    @classmethod
    def largest_among(cls, warnings: Iterable[Message]) -> Self | None:
        """Return the error with the largest effect among warnings about the data."""
        found = []
        for each in warnings:
            effect = point_displacement(each)
            first = each.params["reason"] if each.code == SAME_ON_LINES_CODE else each
            if isinstance(first, Message) and first.code in DATA_ERROR_CODES:
                code = DATA_ERROR_CODES[first.code]
                found.append(cls(code, np.inf if effect is None else effect))
        return max(found, key=lambda each: each.effect, default=None)

    def explains(self, effect: float) -> bool:
        """Whether the error is large enough to cause displacements of ``effect`` metres."""
        return self.effect >= MIN_EFFECT_RATIO * effect


def main_wrong_value(messages: Iterable[Message]) -> Message | None:
    """Warning about the given value of the mounting that causes most of the residuals, if any."""
    for each in messages:
        share = each.params.get("share_of_rms", 0.0)
        is_main = isinstance(share, float) and share >= MIN_EFFECT_RATIO
        if is_main and each.code.startswith(CONTRADICTION_PREFIX):
            return each
    return None


def without_explained(messages: Sequence[Message]) -> tuple[Message, ...]:
    """Messages without the notes that a wrong value of the mounting explains; a note names it.

    Warnings are never omitted.
    """
    if (wrong := main_wrong_value(messages)) is None:
        return tuple(messages)
    kept = tuple(each for each in messages if each.is_serious or each.code not in EXPLAINED_CODES)
    parameter = wrong.params["parameter"]
    explained = note("adjustment.explained_by_value", parameter=parameter, subject=wrong.subject)
    return kept if len(kept) == len(messages) or explained in kept else (*kept, explained)


def point_displacement(message: Message) -> float | None:
    """Displacement of points by the error that a message describes, metres; None if unknown."""
    known = (message.params[name] for name in EFFECT_PARAMETERS if name in message.params)
    value = next(known, None)
    return float(value) if isinstance(value, int | float) else None


def warnings_about_causes(
    result: AdjustmentResult, known: KnownError | None, others: Sequence[Message]
) -> tuple[Message, ...]:
    """Warnings about the causes of the residuals, and the other warnings that they do not replace.

    Parameters
    ----------
    known : KnownError or None
        Error that is known from the imported data.
    others : sequence of Message
        Other warnings about the result.
    """
    causes = _causes_of_earlier_version(result) if result.causes is None else result.causes
    explained = [each for each in causes if known is not None and known.explains(each[0].effect)]
    unexplained = [group for group in causes if group not in explained]
    if any(each.code == "adjustment.not_flat" for each in others):
        found = []  # the cause is known; with so few lines, others cannot be separated from it
    elif _has_too_few_lines(result):
        found = list(_unlocated_cause_notes(unexplained))
    else:
        found = [
            message
            for group in unexplained
            for message in (
                _single_cause_warning(result, group[0])
                if len(group) == 1
                else _ambiguous_cause_warning(group)
            )
        ]
    jumped = _line_jump_warnings(result, causes)
    wrong = [group[0] for group in causes if len(group) == 1 and group[0].kind in OPTIONAL_NAMES]
    if wrong:
        follows: tuple[str, ...] = FORM_ERROR_CODES
        if main_wrong_value(found) is not None:
            follows += CONSEQUENCE_CODES
        others = [each for each in others if each.code not in follows]
    if known is None:
        return (*found, *jumped, *others)
    # These warnings attribute residuals to the targets or the LiDAR; the known error explains them.
    effects = {
        **dict.fromkeys(FORM_ERROR_CODES, float(result.surfaces.max())),
        "adjustment.noise": result.rms_after,
        "adjustment.not_flat": result.rms_after,
        "adjustment.another_surface": result.rms_after,
    }
    kept = [
        each for each in others
        if each.code not in effects or not known.explains(effects[each.code])
    ]  # fmt: skip
    if explained or jumped or len(kept) < len(others):
        found.append(_known_error_warning(known, explained))
    return (*found, *kept)


def _has_too_few_lines(result: AdjustmentResult) -> bool:
    """Whether there are too few lines to detect or identify an error of one line."""
    geometry = result.observability
    return geometry is not None and any(each.kind == "line" for each in geometry.unchecked)


def _unlocated_cause_notes(causes: Sequence[Sequence[PossibleCause]]) -> Iterator[Message]:
    """Note on the possible causes if there are too few lines to locate an error.

    If several causes fit about equally well, none is named. For example, a POS error of a line that
    is not checked by another line has the same effect as a wrong lever arm.
    """
    clear = [group[0] for group in causes if len(group) == 1]
    if clear:
        yield note(
            "adjustment.cause_not_located",
            causes=_cause_phrases(clear),
            subject=_cause_subject(clear[0]),
        )
    elif causes:
        yield note("adjustment.cause_not_identified", subject=RESULT_CAUSE)


def _single_cause_warning(result: AdjustmentResult, cause: PossibleCause) -> Iterator[Message]:
    """Warning about a cause that is clearly more likely than all others."""
    line, target = Cause.of_line(cause.line), Cause.of_target(cause.target)
    of_line = warning if _are_many_lines_wrong(result, 1) else note
    if cause.kind in OPTIONAL_NAMES:
        yield _wrong_value_warning(result, cause)
    elif cause.kind == "line_boresight":
        differences = [
            note("item.angle_difference", angle=mounting_value_name(angle), difference=float(size))
            for angle, size in zip(ANGLES, cause.size, strict=True)
        ]
        yield warning(
            "adjustment.line_boresight", line=cause.line, differences=differences, subject=line
        )
    elif cause.kind == "line_position":
        yield of_line(
            "adjustment.line_position", line=cause.line, shift=_error_magnitude(cause), subject=line
        )
    elif cause.kind == "line_time":
        code = (
            "adjustment.line_times_early"
            if _are_point_times_early(cause)
            else "adjustment.line_times_late"
        )
        yield of_line(code, line=cause.line, offset=_error_magnitude(cause), subject=line)
    elif cause.kind == "target_surface":
        yield note("adjustment.target_not_flat", target=cause.target, subject=target)
    elif not _is_already_named(result, cause):
        yield note(
            "adjustment.sighting_cause", cause=_cause_phrase(cause), subject=_cause_subject(cause)
        )


def _wrong_value_warning(result: AdjustmentResult, cause: PossibleCause) -> Message:
    size, sigma = float(cause.size[0]), float(cause.sigma[0])
    moves = [
        note(
            "item.angle_changed",
            angle=mounting_value_name(angle),
            change=float(moved),
            ratio=float(abs(moved) / its_sigma),
        )
        for angle, moved, its_sigma in zip(ANGLES, cause.angle_change, result.sigma, strict=True)
        if abs(moved) > MIN_ANGLE_CHANGE_SIGMAS * its_sigma
    ]
    code = f"{CONTRADICTION_PREFIX}{cause.kind}"
    return warning(
        code if moves else f"{code}_alone",
        parameter=mounting_value_name(cause.kind),
        change=change_text(cause.kind, size, has_opposite_sign=_has_opposite_sign(result, cause)),
        sigma=amount_with_unit(cause.kind, sigma),
        w=size / sigma,
        angles=moves,
        share_of_rms=float(min(cause.effect / result.rms_after, 1.0)) if result.rms_after else 0.0,
        subject=Cause.of_parameter(cause.kind),
    )


def _has_opposite_sign(result: AdjustmentResult, cause: PossibleCause) -> bool:
    """Whether the corrected value agrees with the given one with the opposite sign."""
    given = float(result.mounting.values[MOUNTING_VALUE_NAMES.index(cause.kind)])
    return has_opposite_sign(given, float(cause.size[0]), float(cause.sigma[0]))


def _ambiguous_cause_warning(group: Sequence[PossibleCause]) -> Iterator[Message]:
    """Warning about causes that are about equally likely."""
    serious = any(each.kind in OPTIONAL_NAMES or each.kind == "line_boresight" for each in group)
    yield (warning if serious else note)(
        "adjustment.several_causes", causes=_cause_phrases(group), subject=_cause_subject(group[0])
    )


def _known_error_warning(
    known: KnownError, explained: Sequence[Sequence[PossibleCause]]
) -> Message:
    """Warning that the residuals follow from a known error of the data."""
    cause = note(known.code)
    if not explained:
        return note("adjustment.known_cause", cause=cause, subject=RESULT_CAUSE)
    causes = _cause_phrases([group[0] for group in explained])
    return note(
        "adjustment.known_cause_or_others", cause=cause, causes=causes, subject=RESULT_CAUSE
    )


def _line_jump_warnings(
    result: AdjustmentResult, causes: Sequence[Sequence[PossibleCause]]
) -> tuple[Message, ...]:
    """Warning about lines whose sightings were all rejected and that no cause explains."""
    named = {each.line for group in causes for each in group}
    jumped = sorted(set(result.rejected_lines) - named)
    if not jumped:
        return ()
    make = warning if _are_many_lines_wrong(result, len(jumped)) else note
    return (
        make(
            "adjustment.line_jumped",
            count=len(jumped), lines=jumped, subject=Cause.of_line(jumped[0]),
        ),
    )  # fmt: skip


def _are_many_lines_wrong(result: AdjustmentResult, count: int) -> bool:
    """Whether so many lines are wrong that the others are not reliable either."""
    return count > MAX_WRONG_LINE_SHARE * len({item.sighting.line for item in result.reliability})


def _is_already_named(result: AdjustmentResult, cause: PossibleCause) -> bool:
    """Whether another warning already names the sighting as rejected or as disagreeing."""
    critical = critical_test_value(result)
    return critical is not None and any(
        (item.sighting.target, item.sighting.line) == (cause.target, cause.line)
        and sighting_status(item, critical) in ("rejected", "disagrees")
        for item in result.reliability
    )


def _cause_phrases(causes: Sequence[PossibleCause]) -> tuple[Message, ...]:
    return tuple(dict.fromkeys(_cause_phrase(each) for each in causes))


def _cause_phrase(cause: PossibleCause) -> Message:
    """Cause as an item of a list, such as ``lever arm X smaller by 0.0951 m``."""
    if cause.kind in OPTIONAL_NAMES:
        return changed_value(cause.kind, float(cause.size[0]))
    if cause.kind == "line_boresight":
        return note("cause.line_boresight", line=cause.line)
    if cause.kind == "line_position":
        return note("cause.line_position", line=cause.line, shift=_error_magnitude(cause))
    if cause.kind == "line_time":
        code = "cause.times_early" if _are_point_times_early(cause) else "cause.times_late"
        return note(code, line=cause.line, offset=_error_magnitude(cause))
    if cause.kind == "sighting_surface":
        return note("cause.sighting_surface", target=cause.target, line=cause.line)
    if cause.kind == "target_surface":
        return note("cause.target_surface", target=cause.target)
    return note(
        "cause.sighting_shift", target=cause.target, line=cause.line, shift=_error_magnitude(cause)
    )


def _are_point_times_early(cause: PossibleCause) -> bool:
    """Whether the point times are early, so that a larger latency would correct them."""
    return float(cause.size[0]) > 0


def _error_magnitude(cause: PossibleCause) -> float:
    return float(np.linalg.norm(cause.size))


def _cause_subject(cause: PossibleCause) -> Cause:
    if cause.kind in OPTIONAL_NAMES:
        return Cause.of_parameter(cause.kind)
    if not cause.line:
        return Cause.of_target(cause.target)
    return (
        Cause.of_sighting(cause.target, cause.line) if cause.target else Cause.of_line(cause.line)
    )


def _causes_of_earlier_version(
    result: AdjustmentResult,
) -> tuple[tuple[PossibleCause, ...], ...]:
    """Causes from the contradictions stored in the result of an earlier version."""

    def cause(parameter: ContradictedParameter) -> PossibleCause:
        size, sigma = np.array([parameter.change]), np.array([parameter.sigma])
        return PossibleCause(
            parameter.name, "", "", size, sigma, parameter.angle_change, 0.0, parameter.w**2
        )

    return tuple((cause(found),) for found in result.contradictions)
