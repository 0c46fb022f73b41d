"""Results of subsets of the data, as values and tables."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

from lispac.adjustment.result import (
    MAX_SUBSET_SIGNIFICANCE,
    CrossCheck,
    CrossChecks,
)
from lispac.language import N_, Plural, gettext
from lispac.messages import Message
from lispac.present.angles import Angles, angles, degrees_or_none
from lispac.present.tables import (
    DEGREES,
    Column,
    Table,
    ratio,
)


@dataclass(frozen=True)
class SubsetValues:
    """Result of a subset of the data; values are None if the subset does not determine the angles.

    ``kind`` is line, target or half; ``part`` is the omitted line or target, or the half that was
    used. The difference is the result of this subset minus that of all points; that of the second
    half is its result minus that of the first half, which itself has no difference.
    """

    kind: str
    part: str
    boresight_deg: Angles | None
    sigma_deg: Angles | None
    difference_deg: Angles | None
    significance: Angles | None
    disagrees: bool
    reason: Message | Literal[""]


@dataclass(frozen=True)
class CrossCheckValues:
    """Results of subsets of the data."""

    parts: tuple[SubsetValues, ...]


def cross_check_values(checks: CrossChecks) -> CrossCheckValues:
    """Results of the cross-checks with subsets of the data."""
    return CrossCheckValues(
        tuple(
            replace(values, difference_deg=None, significance=None)
            if (values.kind, values.part) == ("half", "first")
            else values
            for values in map(_subset_values, checks.parts)
        )
    )


def _subset_values(part: CrossCheck) -> SubsetValues:
    return SubsetValues(
        kind=part.kind,
        part=part.part,
        boresight_deg=degrees_or_none(part.boresight),
        sigma_deg=degrees_or_none(part.sigma),
        difference_deg=degrees_or_none(part.difference),
        significance=None if part.significance is None else angles(part.significance),
        disagrees=part.disagrees,
        reason=part.reason or "",
    )


@dataclass(frozen=True)
class SubsetRow:
    """Table row with a subset and its name; the comparison of two halves is one row."""

    name: str
    subset: SubsetValues


def subset_rows(checks: CrossCheckValues) -> list[SubsetRow]:
    """Rows of the subsets without a line or a target, then of the halves."""
    named = [
        SubsetRow(
            gettext("Without line {name}", name=each.part)
            if each.kind == "line"
            else gettext("Without target {name}", name=each.part),
            each,
        )
        for each in checks.parts
        if each.kind != "half"
    ]
    halves = [each for each in checks.parts if each.kind == "half"]
    if halves and all(half.boresight_deg is not None for half in halves):
        return [*named, SubsetRow(gettext("Second minus first half"), halves[1])]
    names = {
        "first": gettext("First half of the lines only"),
        "second": gettext("Second half of the lines only"),
    }
    return [*named, *(SubsetRow(names[half.part], half) for half in halves)]


def halves_difference_deg(checks: CrossCheckValues) -> tuple[float, ...] | None:
    """Roll, pitch and yaw of the second half minus those of the first, degrees.

    None if the halves were not compared.
    """
    halves = [each for each in checks.parts if each.kind == "half"]
    if not halves or halves[-1].difference_deg is None:
        return None
    return tuple(halves[-1].difference_deg)


def halves_sigma_deg(checks: CrossCheckValues) -> tuple[float, ...] | None:
    """Standard deviations of roll, pitch and yaw of the difference between the halves, degrees.

    None if the halves were not compared, or an angle does not differ.
    """
    halves = [each for each in checks.parts if each.kind == "half"]
    if not halves or halves[-1].difference_deg is None or halves[-1].significance is None:
        return None
    pairs = list(zip(halves[-1].difference_deg, halves[-1].significance, strict=True))
    if any(significance == 0.0 for _, significance in pairs):
        return None
    return tuple(difference / significance for difference, significance in pairs)


def agreement_text(checks: CrossCheckValues) -> str:
    """Number of subsets that agree, and the tolerance: ``9 of 9 agree within 3 σ``."""
    found = [_agreement(row) for row in subset_rows(checks)]
    missing = found.count("no result")
    text = gettext(
        Plural(
            "{agreeing:n} of {count:n} agrees within {limit:n} σ",
            "{agreeing:n} of {count:n} agree within {limit:n} σ",
        ),
        agreeing=found.count("agrees"), count=len(found) - missing, limit=MAX_SUBSET_SIGNIFICANCE,
    )  # fmt: skip
    if not missing:
        return text
    without = gettext("{count:n} without a result", count=missing)
    return f"{text}; {without}"


def _agreement(row: SubsetRow) -> str:
    if row.subset.boresight_deg is None:
        return "no result"
    return "disagrees" if row.subset.disagrees else "agrees"


FINDING_TEXTS: Mapping[str, str] = {
    "no result": N_("no result"), "disagrees": N_("disagrees"), "agrees": N_("agrees"),
}  # fmt: skip
_DIFFERENCE_TIP = N_("Difference from the result with all points, or between the halves")
_SIGNIFICANCE_TIP = N_("Difference divided by its standard deviation")
SUBSETS_TABLE = Table[SubsetRow](
    N_("Results of subsets of the data: differences from the full adjustment"),
    (
        Column(
            "name", N_("Subset"),
            tip=N_("Line or target that was omitted, or halves that were compared"),
        ),
        Column(
            "subset.difference_deg.roll", N_("Roll\ndifference"), DEGREES.signed,
            _DIFFERENCE_TIP,
        ),
        Column("subset.significance.roll", N_("in σ"), ratio(1).signed, _SIGNIFICANCE_TIP),
        Column(
            "subset.difference_deg.pitch", N_("Pitch\ndifference"), DEGREES.signed,
            _DIFFERENCE_TIP,
        ),
        Column("subset.significance.pitch", N_("in σ"), ratio(1).signed, _SIGNIFICANCE_TIP),
        Column(
            "subset.difference_deg.yaw", N_("Yaw\ndifference"), DEGREES.signed,
            _DIFFERENCE_TIP,
        ),
        Column("subset.significance.yaw", N_("in σ"), ratio(1).signed, _SIGNIFICANCE_TIP),
        Column(
            _agreement, N_("Finding"), texts=FINDING_TEXTS,
            tip=N_("Agreement with the result from all points, or between the halves"),
        ),
    ),
)  # fmt: skip

WINDOW_SUBSETS_TABLE = replace(
    SUBSETS_TABLE,
    columns=(
        *SUBSETS_TABLE.columns,
        Column("subset.reason", N_("Reason"), tip=N_("Why there is no result")),
    ),
)
"""Table of the window, with a column of reasons; the report lists them below its table."""
