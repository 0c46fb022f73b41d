"""What page one says of the comparison with a reference."""

from collections.abc import Callable, Iterator, Sequence
from statistics import NormalDist

from lispac.report.absolute_values import Absolute
from lispac.report.values import Caution, mild, serious
from lispac.report.wording import mm
from lispac.validation.absolute_words import Off, lines_off, points_off

NORMAL_95 = NormalDist().inv_cdf(0.975)
LARGE, TOO_LARGE = 2.0, 3.0
"""RMS over the one expected, from which it is told, and from which it is serious: what lines share
makes an RMS scatter about as much as a single error does."""


def absolute_cautions(found: Absolute | None) -> Iterator[Caution]:
    """The mean of all lines, single lines, surveyed points and planes, and the RMS, where off.

    Of many good lines some are off at 95 %; it is serious where one is off by more than the largest
    of as many is in 95 of 100 checks.
    """
    if found is None:
        return
    after = found.together.after
    if after.mean_significant:
        yield serious("absolute_off", found.in_words[0])
    elif after.distances.rms_m > LARGE * after.rms_expected.total_m:
        yield _rms(after.distances.rms_m, after.rms_expected.total_m)
    yield from _single(
        "absolute_line_off",
        lines_off,
        [(x.line, x.after.signed.mean_m, x.after.mean_interval95_m) for x in found.lines],
    )
    yield from _single(
        "absolute_point_off",
        points_off,
        [
            (x.name, x.after_m, x.after_interval95_m)
            for x in found.points
            if x.after_interval95_m is not None
        ],
    )


def _single(
    code: str, words: Callable[[Sequence[Off], int], str], each: Sequence[Off]
) -> Iterator[Caution]:
    from scipy.special import ndtri

    off = [one for one in each if abs(one[1]) > one[2]]
    if not off:
        return
    largest = -float(ndtri(0.025 / len(each))) / NORMAL_95
    if any(abs(mean) > largest * half for _, mean, half in off):
        yield serious(code, words(off, len(each)))
    else:
        yield mild(code, f"{words(off, len(each))} One in twenty is by chance.")


def _rms(found: float, expected: float) -> Caution:
    text = (
        f"Against the reference the distances have an RMS of {mm(found)} mm after the calibration, "
        f"{found / expected:.1f} times the {mm(expected)} mm that reference, POS and boresight let "
        "one expect. See the section on the absolute check."
    )
    return (serious if found > TOO_LARGE * expected else mild)("absolute_rms", text)
