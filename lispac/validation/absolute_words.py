"""What a comparison with a reference says, alike at the command line and in the report."""

from collections.abc import Sequence

from lispac.adjustment.shown import signed
from lispac.validation.absolute import AbsoluteCheck, AbsoluteState

Off = tuple[str, float, float]
"""A name, a mean, and half its 95 % interval, metres."""
ALIKE = (
    "Of all lines together, means and RMS count each line alike, however many places it has: its "
    "places share its POS error. Medians and percentiles are of all places."
)

OF_BEFORE = (
    "This check is of an earlier version, which took the mean of all surfaces within reach: where "
    "a wall stands behind what the reference shows, it is wrong. Repeat it."
)


def absolute_words(check: AbsoluteCheck) -> tuple[str, ...]:
    """Sentences: the mean and what it may be off by, the lines that stand out, and the RMS."""
    before, after = check.together.before, check.together.after
    return (
        f"After the calibration all lines together lie {_said(after)}.",
        f"Before, they lay {_said(before)}; nothing is known of the uncertainty of the prior "
        "boresight, so it is not counted here.",
        lines_off(
            [
                (line.line, line.after.signed.mean, line.after.interval_95)
                for line in check.lines
                if line.after.significant
            ],
            len(check.lines),
        ),
        *_points(check),
        f"The RMS of all distances is {_mm(before.distances.rms)} before and "
        f"{_mm(after.distances.rms)} after. Of the latter the reference's own uncertainty "
        f"({_mm(after.rms_expected.reference)}) explains "
        f"{100 * after.reference_share:.0f} %; reference, POS and boresight together let one "
        f"expect {_mm(after.rms_expected.total)}.",
        *_others(check),
        _shared(check),
        *((ALIKE,) if len(check.lines) > 1 else ()),
    )


def _said(state: AbsoluteState) -> str:
    """Where the lines lie on the mean, and whether that can be chance."""
    mean = state.signed.mean
    side = "nearer to the vessel" if mean > 0 else "farther from the vessel"
    verdict = (
        "more than reference, POS and boresight explain"
        if state.significant
        else "no more than reference, POS and boresight explain"
    )
    return (
        f"{_mm(abs(mean))} {side} than the reference on the mean, \u00b1 "
        f"{_mm(state.interval_95)} (95 %): {verdict}"
    )


def lines_off(off: Sequence[Off], of: int) -> str:
    """Which lines are off by more than their errors explain.

    Parameters
    ----------
    off : their names, means and half the 95 % intervals of these, metres
    of : of how many
    """
    if not off:
        return "After the calibration no single line is off by more than its own errors explain."
    verb = "lines are off by more than their" if len(off) > 1 else "lines is off by more than its"
    return (
        f"After the calibration {len(off)} of {of} {verb} own errors explain, positive towards the "
        f"vessel: {_named(off)}."
    )


def points_off(off: Sequence[Off], of: int) -> str:
    """From which surveyed points and planes the lines are off; as `lines_off`."""
    return (
        "After the calibration the mean of the lines is off surveyed points or planes by more than "
        f"reference, POS and boresight explain ({len(off)} of {of}), positive towards the vessel: "
        f"{_named(off)}."
    )


def _named(off: Sequence[Off]) -> str:
    return ", ".join(f"{name} ({_signed(mean)}, ± {_mm(half)})" for name, mean, half in off)


def _points(check: AbsoluteCheck) -> tuple[str, ...]:
    off = [
        (point.name, point.after, point.interval_95)
        for point in check.points
        if point.interval_95 is not None and abs(point.after) > point.interval_95
    ]
    return (points_off(off, len(check.points)),) if off else ()


def _others(check: AbsoluteCheck) -> tuple[str, ...]:
    """What may have been taken for the surface that the reference shows."""
    if check.others is None:
        return (OF_BEFORE,)
    if not check.others:
        return ()
    places = {line.line: line.after.signed.n for line in check.lines}
    named = ", ".join(
        f"{other.line} ({other.places:,} of {places[other.line]:,} places, {other.distance:.2f} m "
        "away)"
        for other in check.others
    )
    return (
        f"Another surface lies behind or before the one measured, within {check.reach:g} m of the "
        f"reference: {named}. The nearest to the reference was taken; of a line that is off by "
        "more than half that distance it would be the wrong one.",
    )


def _shared(check: AbsoluteCheck) -> str:
    if check.kind == "scan":
        return (
            "The reference sigma counts as one error that all points of the scan share, such as "
            "that of its registration; the noise of its single points averages out."
        )
    return "Each surveyed point counts with an error of its own."


def _mm(value: float) -> str:
    return f"{1000 * value:.1f} mm"


def _signed(value: float) -> str:
    return f"{signed(1000 * value, 1)} mm"
