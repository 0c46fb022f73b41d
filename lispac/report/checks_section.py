"""The sections on reliability and cross-checks: whether the data agree with each other."""

from collections.abc import Mapping, Sequence

from lispac.adjustment.diagnostics.reliability import CRITICAL_VALUE
from lispac.language import N_, gettext
from lispac.report.document_blocks import (
    Block,
    Bullets,
    Column,
    Paragraph,
    Table,
    UndrawnPictures,
    as_rows,
)
from lispac.report.report_values import (
    AdjustmentValues,
    CrossCheckPart,
    CrossCheckValues,
    ReportContent,
    SightingCheck,
)
from lispac.report.text_format import (
    UNKNOWN,
    angle_text,
    degrees_unit,
    fixed_number,
    format_known,
    grouped_number,
    millimetres,
    named_cross_check_parts,
    sentence_text,
    signed_number,
    title,
    title_with_unit,
)

STANDINGS: Mapping[str, str] = {
    "rejected": N_("rejected"),
    "not checked": N_("not checked"),
    "disagrees": N_("disagrees"),
    "agrees": N_("agrees"),
}
"""Result of the test of a sighting, by what the content calls it."""

SIGHTING_TEST = N_(
    "Each sighting is compared with the result of all others. Shift: distance of the sighting "
    "from the surface of its target, along the normal. w: shift divided by its sigma; above "
    "{limit} the sighting disagrees (1 % probability that any of {count:n} sightings without a "
    "blunder does so). Detectable shift: smallest shift that the test finds with 80 % "
    "probability. Effect: change of the angles caused by a shift of that size that is not found."
)
POINT_TEST = N_(
    "Single points are tested in the same way. Redundancy: control of each point by the other "
    "data, from 0 (none) to 1. Outliers: points farther from the surface than {limit} sigma; by "
    "chance, one point in a thousand exceeds this limit. Largest w of a point: distance of "
    "the farthest point divided by its sigma, with its time on the line; averaged points have the "
    "mean of their times."
)
POS_ERRORS = N_(
    "Estimated POS error of each sighting with its 2 sigma interval (bar); grey: the prior 2 "
    "sigma interval. Red: the error is outside the prior interval; the POS was less accurate than "
    "given, or another error was attributed to it."
)
CROSS_CHECKS = N_(
    "The adjustment is repeated with each line omitted in turn, with each target omitted in turn, "
    "and with each half of the lines in the order of the survey. The spread is the standard "
    "deviation of the angles computed from the results with one line omitted, or with one target "
    "omitted (jackknife). It does not depend on the given sigmas."
)
PARTS = N_(
    "The differences are also given divided by their expected sigma. Above 3, the subset "
    "disagrees with the full adjustment, or the two halves with each other, by more than chance "
    "explains."
)


def reliability_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the reliability of each sighting and each point."""
    adjustment = content.adjustment
    if adjustment is None:
        return []
    if not adjustment.reliability or adjustment.critical_w is None:
        if content.settings.pos_errors == "independent":
            untested = gettext(
                "Sightings are not tested: in this stochastic model the points of a sighting have "
                "no common error."
            )
        else:
            untested = gettext("Sightings are not tested: the surface roughness was set to zero.")
        return [Paragraph(untested)]
    found = adjustment.reliability
    return [
        Paragraph(
            gettext(SIGHTING_TEST, limit=fixed_number(adjustment.critical_w, 2), count=len(found))
        ),
        _test_table(found),
        *_sighting_notes(found),
        Paragraph(gettext(POINT_TEST, limit=fixed_number(CRITICAL_VALUE, 2))),
        _point_table(found),
        *_pos_error_blocks(adjustment),
    ]


def _test_table(sightings: Sequence[SightingCheck]) -> Table:
    deg = degrees_unit()
    return Table(
        gettext("Agreement of the sightings"),
        (
            Column(gettext("Target"), "left"),
            Column(gettext("Line"), "left"),
            Column(title_with_unit(gettext("Shift"), "mm")),
            Column("w"),
            Column(title_with_unit(gettext("Detectable\nshift"), "mm")),
            Column(title_with_unit(gettext("Effect on\nroll"), deg)),
            Column(title_with_unit(gettext("Pitch"), deg)),
            Column(title_with_unit(gettext("Yaw"), deg)),
            Column(gettext("Finding"), "left"),
        ),
        as_rows(
            [
                s.target,
                s.line,
                format_known(s.shift_m, lambda v: signed_number(1000 * v, 1)),
                format_known(s.w, lambda v: signed_number(v, 1)),
                format_known(s.detectable_m, millimetres),
                *([UNKNOWN] * 3 if s.effect_deg is None else [angle_text(v) for v in s.effect_deg]),
                gettext(STANDINGS[s.status]),
            ]
            for s in sightings
        ),
    )


def _point_table(sightings: Sequence[SightingCheck]) -> Table:
    return Table(
        gettext("Tests of single points"),
        (
            Column(gettext("Target"), "left"),
            Column(gettext("Line"), "left"),
            Column(gettext("Points")),
            Column(gettext("Redundancy")),
            Column(gettext("Outliers")),
            Column(gettext("Largest w\nof a point")),
            Column(gettext("Time of\nlargest w (s)")),
        ),
        as_rows(
            [
                s.target,
                s.line,
                grouped_number(s.points),
                fixed_number(s.redundancy, 2),
                fixed_number(s.outliers, 0),
                fixed_number(s.largest_w, 1),
                format_known(s.largest_w_time_s, lambda v: fixed_number(v, 3)),
            ]
            for s in sightings
        ),
    )


def _sighting_notes(sightings: Sequence[SightingCheck]) -> list[Block]:
    messages = []
    for sighting in sightings:
        if sighting.rejected:
            template = N_(
                "{target} on line {line} disagrees with all other sightings. It was rejected and "
                "does not affect the result."
            )
        elif sighting.status == "disagrees":
            template = N_(
                "{target} on line {line} disagrees but was not rejected: the target has too few "
                "other sightings, or no loss function is used."
            )
        else:
            continue
        messages.append(gettext(template, target=sighting.target, line=sighting.line))
    unchecked = [
        gettext("{target} on line {line}", target=s.target, line=s.line)
        for s in sightings
        if s.status == "not checked"
    ]
    if unchecked:
        messages.append(
            gettext("Not checked by other data: {sightings:names}.", sightings=unchecked)
        )
    return [Bullets(tuple(messages))] if messages else []


def _pos_error_blocks(adjustment: AdjustmentValues) -> list[Block]:
    from lispac.report.figures import POS_COMPONENTS, pos_error_figures_of

    found = adjustment.reliability
    count = len(found)

    def mean(values: Sequence[float]) -> float:
        return sum(values) / count

    prior = [
        *(millimetres(mean([s.pos_sigma_m[k] for s in found])) for k in range(3)),
        *(fixed_number(mean([s.pos_sigma_deg[k] for s in found]), 4) for k in range(3)),
    ]
    deg = degrees_unit()
    table = Table(
        gettext("Estimated POS error at the middle of each sighting"),
        (
            Column(gettext("Target"), "left"),
            Column(gettext("Line"), "left"),
            *(
                Column(title_with_unit(gettext(name), "mm" if k < 3 else deg))
                for k, name in enumerate(POS_COMPONENTS)
            ),
        ),
        as_rows(
            [
                # Rounded first, plus zero: no minus sign before a zero
                *(
                    [
                        s.target,
                        s.line,
                        *(signed_number(round(1000 * v, 1) + 0.0, 1) for v in s.pos_error_m),
                        *(angle_text(round(v, 4) + 0.0) for v in s.pos_error_deg),
                    ]
                    for s in found
                ),
                [gettext("Given 1 σ"), gettext("mean"), *prior],
            ]
        ),
    )
    return [table, UndrawnPictures(gettext(POS_ERRORS), pos_error_figures_of, (found,))]


def cross_check_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the results of parts of the data."""
    if content.adjustment is None:
        return []
    checks = content.cross_checks
    if checks is None:
        return [Paragraph(gettext("The adjustment was not repeated with subsets of the data."))]
    blocks: list[Block] = [Paragraph(gettext(CROSS_CHECKS)), _spread_table(content, checks)]
    if checks.spread_lines_deg is None:
        blocks.append(
            Paragraph(
                gettext(
                    "The spread with one line omitted requires at least three lines, and a result "
                    "with each of them omitted."
                )
            )
        )
    if checks.spread_targets_deg is None:
        blocks.append(
            Paragraph(
                gettext(
                    "The spread with one target omitted requires at least three targets, and a "
                    "result with each of them omitted."
                )
            )
        )
    blocks += [
        _parts_table(content, checks),
        Paragraph(gettext(PARTS)),
    ]
    reasons = tuple(
        gettext("{name}: {reason}", name=name, reason=sentence_text(part.reason))
        for name, part in named_cross_check_parts(checks)
        if part.reason
    )
    if reasons:
        blocks += [Paragraph(gettext("Subsets without a result:")), Bullets(reasons)]
    return blocks


def _spread_table(content: ReportContent, checks: CrossCheckValues) -> Table:
    spreads = (
        (gettext("Adjustment"), checks.sigma_deg),
        (gettext("Spread, one line omitted"), checks.spread_lines_deg),
        (gettext("Spread, one target omitted"), checks.spread_targets_deg),
    )
    deg = degrees_unit()
    return Table(
        gettext(
            "Standard deviations of the angles, from the adjustment and from the scatter of "
            "the subsets"
        ),
        (
            Column("", "left"),
            *(Column(title_with_unit(title(a.name), deg)) for a in content.angles),
        ),
        as_rows(
            [name, *([UNKNOWN] * 3 if values is None else [fixed_number(v, 4) for v in values])]
            for name, values in spreads
        ),
    )


def _parts_table(content: ReportContent, checks: CrossCheckValues) -> Table:
    angles = [title(angle.name) for angle in content.angles]
    deg = degrees_unit()
    return Table(
        gettext("Results of subsets of the data: differences from the full adjustment"),
        (
            Column(gettext("Subset"), "left"),
            *(Column(title_with_unit(name, deg)) for name in angles),
            *(Column(gettext("{angle}\n/ sigma", angle=name)) for name in angles),
            Column(gettext("Finding"), "left"),
        ),
        as_rows(
            [
                name,
                *_value_cells(part.difference_deg, 4),
                *_value_cells(part.significance, 1),
                _agreement_text(part),
            ]
            for name, part in named_cross_check_parts(checks)
        ),
    )


def _value_cells(values: tuple[float, ...] | None, decimals: int) -> list[str]:
    return [UNKNOWN] * 3 if values is None else [signed_number(value, decimals) for value in values]


def _agreement_text(part: CrossCheckPart) -> str:
    if part.boresight_deg is None:
        return gettext("no result")
    return gettext("disagrees") if part.disagrees else gettext("agrees")
