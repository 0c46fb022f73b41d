"""Warnings about the comparison with a reference, for the first page of the report."""

from collections.abc import Iterator, Sequence
from statistics import NormalDist

from lispac.messages import Message, note, warning
from lispac.present.absolute import AbsoluteCheckValues
from lispac.validation.absolute_messages import NamedMean, list_items_with_means
from lispac.warning_causes import Cause

NORMAL_95 = NormalDist().inv_cdf(0.975)
RMS_RATIOS, TOO_LARGE = 2.0, 3.0
"""Ratios of the RMS to its expected value for a note and for a warning. Errors common to the lines
make the RMS vary about as much as a single error."""
VALIDATE = Cause.of_step("Validate")


def absolute_check_warnings(values: AbsoluteCheckValues | None) -> Iterator[Message]:
    """Warnings about significant mean distances and a large RMS.

    The means tested are those of all lines, of single lines, and of surveyed points and planes.
    Among many correct lines, some differ significantly at 95 % by chance. The message is a warning
    only if the largest offset exceeds the 95 % limit for the largest of so many lines.
    """
    if values is None:
        return
    after = values.all_lines.after
    if after.mean_significant:
        mean = after.signed.mean_m
        yield warning(
            "report.absolute_nearer" if mean > 0 else "report.absolute_farther",
            mean=abs(mean), interval=after.mean_interval95_m, subject=VALIDATE,
        )  # fmt: skip
    elif after.distances.rms_m > RMS_RATIOS * after.rms_expected.total_m:
        yield _rms_message(after.distances.rms_m, after.rms_expected.total_m)
    yield from _line_warnings(
        [(x.line, x.after.signed.mean_m, x.after.mean_interval95_m) for x in values.lines]
    )
    yield from _point_warnings(
        [
            (x.name, x.after_m, x.after_interval95_m)
            for x in values.points
            if x.after_interval95_m is not None
        ]
    )


def _line_warnings(each: Sequence[NamedMean]) -> Iterator[Message]:
    """Message about lines with a significant offset; its subject is the line farthest off."""
    if off := _significant_offsets(each):
        farthest = max(off, key=lambda one: abs(one[1]))
        beyond = _is_beyond_chance(each)
        yield (warning if beyond else note)(
            "report.absolute_line_off" if beyond else "report.absolute_line_off_by_chance",
            count=len(off),
            total=len(each),
            lines=list_items_with_means(off),
            subject=Cause.of_line(farthest[0]),
        )


def _point_warnings(each: Sequence[NamedMean]) -> Iterator[Message]:
    """Message about surveyed points and planes from which the lines differ significantly."""
    if off := _significant_offsets(each):
        beyond = _is_beyond_chance(each)
        yield (warning if beyond else note)(
            "report.absolute_point_off" if beyond else "report.absolute_point_off_by_chance",
            count=len(off), total=len(each), points=list_items_with_means(off), subject=VALIDATE,
        )  # fmt: skip


def _significant_offsets(each: Sequence[NamedMean]) -> list[NamedMean]:
    return [one for one in each if abs(one[1]) > one[2]]


def _is_beyond_chance(each: Sequence[NamedMean]) -> bool:
    from scipy.special import ndtri

    largest = -float(ndtri(0.025 / len(each))) / NORMAL_95
    return any(abs(mean) > largest * half for _, mean, half in each)


def _rms_message(rms: float, expected: float) -> Message:
    return (warning if rms > TOO_LARGE * expected else note)(
        "report.absolute_rms",
        rms=rms, factor=rms / expected, expected=expected, subject=VALIDATE,
    )  # fmt: skip
