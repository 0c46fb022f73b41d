"""Warnings about the comparison with a reference, for the first page of the report."""

from collections.abc import Iterator, Sequence
from statistics import NormalDist

from lispac.messages import Message, note, warning
from lispac.present.absolute import AbsoluteCheckValues
from lispac.validation.absolute_messages import NamedMean, list_items_with_means
from lispac.warning_causes import Cause

NORMAL_FACTOR_95 = NormalDist().inv_cdf(0.975)
"""Half the width of the 95 % interval of a normal variable, in standard deviations."""
NOTE_RMS_RATIO, WARNING_RMS_RATIO = 2.0, 3.0
"""Ratios of the RMS to its expected value above which a note and a warning are given. Errors common
to the lines make the RMS vary about as much as a single error."""
VALIDATE_STEP = Cause.of_step("Validate")


def absolute_check_warnings(values: AbsoluteCheckValues | None) -> Iterator[Message]:
    """Warnings about significant mean distances from the reference, and about a large RMS.

    Three kinds of means are tested at 95 %: that of all lines, that of each line, and that at each
    surveyed point or plane. The RMS is tested only if the mean of all lines is not significant.

    Among many correct lines or points, some means are significant by chance. The message about them
    is therefore a warning only if at least one mean also exceeds the 95 % limit for the largest of
    all; otherwise it is a note.
    """
    if values is None:
        return
    after = values.all_lines.after
    if after.mean_significant:
        mean = after.signed.mean_m
        yield warning(
            "report.absolute_nearer" if mean > 0 else "report.absolute_farther",
            mean=abs(mean), interval=after.mean_interval95_m, subject=VALIDATE_STEP,
        )  # fmt: skip
    elif after.distances.rms_m > NOTE_RMS_RATIO * after.rms_expected.total_m:
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


def _line_warnings(means: Sequence[NamedMean]) -> Iterator[Message]:
    """Message about lines with a significant mean; its subject is the line with the largest one."""
    if significant := _significant_means(means):
        farthest = max(significant, key=lambda each: abs(each[1]))
        is_warning = _exceeds_joint_limit(means)
        yield (warning if is_warning else note)(
            "report.absolute_line_off" if is_warning else "report.absolute_line_off_by_chance",
            count=len(significant),
            total=len(means),
            lines=list_items_with_means(significant),
            subject=Cause.of_line(farthest[0]),
        )


def _point_warnings(means: Sequence[NamedMean]) -> Iterator[Message]:
    """Message about surveyed points and planes from which the lines differ significantly."""
    if significant := _significant_means(means):
        is_warning = _exceeds_joint_limit(means)
        yield (warning if is_warning else note)(
            "report.absolute_point_off" if is_warning else "report.absolute_point_off_by_chance",
            count=len(significant),
            total=len(means),
            points=list_items_with_means(significant),
            subject=VALIDATE_STEP,
        )


def _significant_means(means: Sequence[NamedMean]) -> list[NamedMean]:
    """Means whose absolute value exceeds half their own 95 % interval."""
    return [each for each in means if abs(each[1]) > each[2]]


def _exceeds_joint_limit(means: Sequence[NamedMean]) -> bool:
    """True if a mean exceeds the 95 % limit for the largest of all means (Bonferroni)."""
    from scipy.special import ndtri

    ratio = -float(ndtri(0.025 / len(means))) / NORMAL_FACTOR_95
    return any(abs(mean) > ratio * half for _, mean, half in means)


def _rms_message(rms: float, expected: float) -> Message:
    return (warning if rms > WARNING_RMS_RATIO * expected else note)(
        "report.absolute_rms",
        rms=rms, factor=rms / expected, expected=expected, subject=VALIDATE_STEP,
    )  # fmt: skip
