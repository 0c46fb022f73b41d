"""Warnings that name the error behind residuals that contradict the model."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from lispac.adjustment.critical import critical_w
from lispac.adjustment.doubt import Doubt
from lispac.adjustment.doubts_of_sightings import MOST_JUMPED
from lispac.adjustment.omitted import OF_CONSEQUENCE
from lispac.adjustment.parameters import SWITCHED
from lispac.adjustment.result import ANGLES, AdjustmentResult, CandidateCause, Contradiction
from lispac.adjustment.shown import amount, listed, mm, parameter, signed, standing
from lispac.causes import Cause

KNOWN_FROM_DATA = {
    "audit.several_scanners": "points of several scanners in one line",
    "audit.several_sources": "points of several sources in one line",
    "audit.same_time": "lines with points of the same time",
    "audit.time_resolution": "coarse point times",
    "recovery.height_offset": "an offset of the heights",
    "recovery.time_offset": "an offset of the point times",
    "recovery.lever_arm_x": "another lever arm behind the cloud",
    "recovery.lever_arm_y": "another lever arm behind the cloud",
    "recovery.lever_arm_z": "another lever arm behind the cloud",
    "recovery.roll_sign": "a wrong sign of the attitude",
    "recovery.pitch_sign": "a wrong sign of the attitude",
    "recovery.roll_pitch_signs": "a wrong sign of the attitude",
    "recovery.several_causes": "points that do not lie where the scanner measures",
    "recovery.unexplained": "points that do not lie where the scanner measures",
    "trajectory.rate_too_low": "a trajectory with too few states",
}
"""Warnings about the imported data that explain residuals, and the error each of them finds."""
EXPLAINS = 0.5
"""Effect of an error known from the data over that of a candidate from which it explains it."""


@dataclass(frozen=True)
class Known:
    """An error known from the imported data.

    Attributes
    ----------
    name : str
    effect : float, metres
        By how much it displaces points; infinite where that is not known.
    """

    name: str
    effect: float

    @classmethod
    def among(cls, doubts: Iterable[Doubt]) -> Self | None:
        """The one with the largest effect among warnings about the data."""
        found = [
            cls(KNOWN_FROM_DATA[each.code], np.inf if each.effect is None else each.effect)
            for each in doubts
            if each.code in KNOWN_FROM_DATA
        ]
        return max(found, key=lambda each: each.effect, default=None)

    def explains(self, effect: float) -> bool:
        """Whether it is large enough to be behind residuals of ``effect`` metres."""
        return self.effect >= EXPLAINS * effect


def cause_doubts(
    result: AdjustmentResult, known: Known | None, others: Sequence[Doubt]
) -> tuple[Doubt, ...]:
    """Warnings about the errors behind the residuals, and the others that remain beside them.

    Parameters
    ----------
    known : Known or None
        What the imported data show.
    others : sequence of Doubt
        What else there is to warn of.
    """
    causes = _causes_of_earlier_version(result) if result.causes is None else result.causes
    explained = [each for each in causes if known is not None and known.explains(each[0].effect)]
    unexplained = [group for group in causes if group not in explained]
    if any(each.code == "not_flat" for each in others):
        found = []  # the reason has a name, and too few lines tell any other one from it
    elif _has_too_few_lines(result):
        found = list(_not_located(unexplained))
    else:
        found = [
            doubt
            for group in unexplained
            for doubt in (_one(result, group[0]) if len(group) == 1 else _several(group))
        ]
    jumped = _jumped(result, causes)
    if any(len(group) == 1 and group[0].kind in SWITCHED for group in causes):
        others = [each for each in others if each.code != "surfaces_differ"]
    if known is None:
        return (*found, *jumped, *others)
    # These blame the targets or the LiDAR for residuals, which such an error explains.
    effects = {
        "surfaces_differ": float(result.surfaces.max()),
        "noise": result.rms_after,
        "not_flat": result.rms_after,
        "another_surface": result.rms_after,
    }
    kept = [
        each for each in others
        if each.code not in effects or not known.explains(effects[each.code])
    ]  # fmt: skip
    if explained or jumped or len(kept) < len(others):
        found.append(_consequence(known, explained))
    return (*found, *kept)


def _has_too_few_lines(result: AdjustmentResult) -> bool:
    """Whether an error of one line would show nowhere, or as an error of anything else."""
    seen = result.observability
    return seen is not None and any(each.kind == "line" for each in seen.unchecked)


def _not_located(causes: Sequence[Sequence[CandidateCause]]) -> Iterator[Doubt]:
    if causes:
        every = [cause for group in causes for cause in group]
        yield Doubt(
            "cause_not_located",
            False,
            "The residuals contradict the model. There are too few lines to tell the cause; "
            f"possible causes: {_phrases(every)}. Add lines.",
            _place(every[0]),
        )


def _one(result: AdjustmentResult, cause: CandidateCause) -> Iterator[Doubt]:
    """The warning about a cause that is clearly better than all others."""
    if cause.kind in SWITCHED:
        yield _wrong_value(result, cause)
    elif cause.kind == "line_boresight":
        angles = listed(
            [
                f"{angle} {signed(float(np.degrees(size)), 2)}\u00a0deg"
                for angle, size in zip(ANGLES, cause.size, strict=True)
            ]
        )
        yield Doubt(
            "line_boresight",
            True,
            f"Line {cause.line} fits another boresight than the other lines ({angles}): it may be "
            "of a second scanner, or the mounting moved. Calibrate it apart from the others, or "
            "exclude it.",
            Cause.of_line(cause.line),
        )
    elif cause.kind == "line_position":
        yield Doubt(
            "line_jumped",
            _many_lines(result, 1),
            f"The position on line {cause.line} is off by {mm(_length(cause))}\u00a0mm. Look at "
            "the trajectory there, or exclude the line.",
            Cause.of_line(cause.line),
        )
    elif cause.kind == "line_time":
        yield Doubt(
            "line_time",
            _many_lines(result, 1),
            f"The point times of line {cause.line} are {_off(cause)}. Check the time base and the "
            "time shift of the line, or exclude it.",
            Cause.of_line(cause.line),
        )
    elif cause.kind == "target_surface":
        yield Doubt(
            "target_not_flat",
            False,
            f"The residuals contradict the model, and the likeliest cause is that target "
            f"{cause.target} is not one flat surface for all lines. Exclude it, or pick a smaller "
            "part of it.",
            Cause.of_target(cause.target),
        )
    elif not _named_already(result, cause):
        yield Doubt(
            "sighting_disagrees",
            False,
            f"The residuals contradict the model, and the likeliest cause is {_phrase(cause)}. "
            "Look at the points and the trajectory there.",
            Cause.of_sighting(cause.target, cause.line),
        )


def _wrong_value(result: AdjustmentResult, cause: CandidateCause) -> Doubt:
    size, sigma = float(cause.size[0]), float(cause.sigma[0])
    moves = [
        f"{angle} by {signed(float(np.degrees(moved)), 3)}\u00a0deg "
        f"({abs(moved) / sigma:.1f}\u00a0of its sigmas)"
        for angle, moved, sigma in zip(ANGLES, cause.moved, result.sigma, strict=True)
        if abs(moved) > OF_CONSEQUENCE * sigma
    ]
    so = f", which would move {listed(moves)}" if moves else ""
    return Doubt(
        f"contradicted_{cause.kind}",
        True,
        f"The data contradict the stated {parameter(cause.kind)}: they want it "
        f"{_larger(cause)} (\u00b1\u00a0{amount(cause.kind, sigma)}, "
        f"w\u00a0{signed(size / sigma, 1)}){so}. Measure it again, or have it estimated.",
        Cause.of_parameter(cause.kind),
    )


def _several(group: Sequence[CandidateCause]) -> Iterator[Doubt]:
    """The warning about causes that fit about equally well."""
    yield Doubt(
        "several_causes",
        any(each.kind in SWITCHED or each.kind == "line_boresight" for each in group),
        "The residuals contradict the model. These causes explain them about equally well, the "
        f"first one best: {_phrases(group)}. Check each of them.",
        _place(group[0]),
    )


def _consequence(known: Known, explained: Sequence[Sequence[CandidateCause]]) -> Doubt:
    """The warning that residuals follow from an error that the data show."""
    also = ""
    if explained:
        phrases = _phrases([group[0] for group in explained])
        also = f" Without it they would be explained by: {phrases}."
    return Doubt(
        "known_cause",
        False,
        f"The residuals contradict the model, which is explained by {known.name}: see the warning "
        f"about it.{also} Correct the data first.",
    )


def _jumped(
    result: AdjustmentResult, causes: Sequence[Sequence[CandidateCause]]
) -> tuple[Doubt, ...]:
    """Lines all of whose sightings were rejected and that no cause names."""
    named = {each.line for group in causes for each in group}
    jumped = sorted(set(result.suspect_lines) - named)
    if not jumped:
        return ()
    return (
        Doubt(
            "line_jumped",
            _many_lines(result, len(jumped)),
            f"Every target is off on {'line' if len(jumped) == 1 else 'lines'} {listed(jumped)}: "
            "the position may have jumped there, targets are mixed up, or a stated value of the "
            "mounting is wrong.",
            Cause.of_line(jumped[0]),
        ),
    )


def _many_lines(result: AdjustmentResult, count: int) -> bool:
    """Whether so many lines are wrong that the others are doubtful as well."""
    return count > MOST_JUMPED * len({item.sighting.line for item in result.reliability})


def _named_already(result: AdjustmentResult, cause: CandidateCause) -> bool:
    """Whether another warning names the sighting as rejected or as one that disagrees."""
    critical = critical_w(result)
    return critical is not None and any(
        (item.sighting.target, item.sighting.line) == (cause.target, cause.line)
        and standing(item, critical) in ("left out", "disagrees")
        for item in result.reliability
    )


def _phrases(causes: Sequence[CandidateCause]) -> str:
    return ", ".join(dict.fromkeys(_phrase(each) for each in causes))


def _phrase(cause: CandidateCause) -> str:
    """A cause in a list: ``lever arm X 0.0951 m smaller``."""
    if cause.kind in SWITCHED:
        return f"{parameter(cause.kind)} {_larger(cause)}"
    if cause.kind == "line_boresight":
        return f"another boresight of line {cause.line}"
    if cause.kind == "line_position":
        return f"position on line {cause.line} off by {mm(_length(cause))}\u00a0mm"
    if cause.kind == "line_time":
        return f"point times of line {cause.line} {_off(cause)}"
    if cause.kind == "sighting_surface":
        return f"another surface under {cause.target} on line {cause.line}"
    if cause.kind == "target_surface":
        return f"target {cause.target} not one flat surface"
    return f"target {cause.target} off by {mm(_length(cause))}\u00a0mm on line {cause.line}"


def _larger(cause: CandidateCause) -> str:
    size = float(cause.size[0])
    return f"{amount(cause.kind, abs(size))} {'larger' if size > 0 else 'smaller'}"


def _off(cause: CandidateCause) -> str:
    """How point times are off: they are late where the latency would have to be smaller."""
    size = float(cause.size[0])
    return f"{amount('latency', abs(size))} {'early' if size > 0 else 'late'}"


def _length(cause: CandidateCause) -> float:
    return float(np.linalg.norm(cause.size))


def _place(cause: CandidateCause) -> Cause:
    if cause.kind in SWITCHED:
        return Cause.of_parameter(cause.kind)
    if not cause.line:
        return Cause.of_target(cause.target)
    return (
        Cause.of_sighting(cause.target, cause.line) if cause.target else Cause.of_line(cause.line)
    )


def _causes_of_earlier_version(
    result: AdjustmentResult,
) -> tuple[tuple[CandidateCause, ...], ...]:
    """What a result kept by an earlier version says of the mounting."""

    def cause(found: Contradiction) -> CandidateCause:
        size, sigma = np.array([found.change]), np.array([found.sigma])
        return CandidateCause(found.name, "", "", size, sigma, found.moved, 0.0, found.w**2)

    return tuple((cause(found),) for found in result.contradictions)
