"""The sections on reliability, cross-checks and alternative methods: whether the data agree."""

from collections.abc import Mapping, Sequence

from lispac.adjustment.diagnostics.reliability import CRITICAL_VALUE
from lispac.alternative_methods import Method
from lispac.language import N_, gettext
from lispac.present.calibration.control import (
    CONTROL_COMPARISON_TABLE,
    CONTROL_FILES_TABLE,
    CONTROL_TABLE,
)
from lispac.present.calibration.cross_checks import SUBSETS_TABLE, halves_sigma_deg, subset_rows
from lispac.present.calibration.methods import (
    METHOD_RESULTS_TABLE,
    METHOD_TITLES,
    method_differences,
)
from lispac.present.output.pos_corrections import (
    POS_CORRECTIONS_TABLE,
    SIGHTED_INTERVALS_TABLE,
    PosCorrectionValues,
)
from lispac.present.targets.sightings import (
    MEAN_POS_SIGMAS_TABLE,
    POINT_TESTS_TABLE,
    POS_ERRORS_TABLE,
    SIGHTING_TESTS_TABLE,
    UNDETERMINED_POS_ERRORS_TEXT,
    SightingValues,
    has_undetermined_pos_errors,
    mean_pos_sigmas,
    pos_error_caption,
)
from lispac.present.text_format import fixed_number, sentence_text
from lispac.report.document_blocks import (
    Block,
    Bullets,
    Paragraph,
    UndrawnPictures,
    report_table,
    with_rows_below,
)
from lispac.report.report_values import ReportContent
from lispac.report.section_summaries import cross_check_summary, reliability_summary

SIGHTING_TEST_TEXT = N_(
    "Each sighting of a target is compared with the result of all others. Shift: distance of the "
    "sighting from the surface of its target, without the estimated POS error of the line, which "
    "the mean of the residuals contains; positive if nearer to the vessel. w: shift divided "
    "by its sigma; above {limit} the sighting disagrees (1 % probability that any of {count:n} "
    "sightings of targets without a blunder does so). Detectable shift: smallest shift that the "
    "test finds with 80 % probability. Effect: change of the angles caused by a positive shift of "
    "that size that is not found."
)
POINT_TEST_TEXT = N_(
    "Single points are tested in the same way. Redundancy: control of each point by the other "
    "data, from 0 (none) to 1. Outliers: points farther from the surface than {limit} sigma; by "
    "chance, one point in a thousand exceeds this limit. Largest w of a point: distance of "
    "the farthest point divided by its sigma. Time: that of this point, in seconds as in the "
    "trajectory file; averaged points have the mean of their times."
)
CROSS_CHECKS_TEXT = N_(
    "The adjustment is repeated with each line omitted in turn, with each target omitted in turn, "
    "and with each half of the lines in the order of the survey."
)
SUBSET_DIFFERENCES_TEXT = N_(
    "The differences are also given divided by their expected sigma. Above 3, the subset "
    "disagrees with the full adjustment, or the two halves with each other, by more than chance "
    "explains."
)
HALVES_TEXT = N_(
    "Each half determines the angles less precisely than all data: the sigma of the difference "
    "between the halves is {roll}° in roll, {pitch}° in pitch and {yaw}° in yaw."
)
CONTROL_TEXT = N_(
    "Surveyed points entered the adjustment as observations. Residual: distance of the point from "
    "the adjusted surface, positive if it is nearer to the vessel; of a centre, its distance from "
    "the adjusted centre. 1 sigma: standard deviation of the point in the direction of the "
    "residual, with the error that all points of its file share. Redundancy: share of an error of "
    "the point that its residual shows. w: error of the point according to all other observations "
    "except contradicting control, divided by its standard deviation."
)
TRAJECTORY_CORRECTIONS_TEXT = N_(
    "The adjustment also estimates the POS error as a function of time, so that a corrected "
    "trajectory can be exported. Largest correction: largest absolute value in the intervals with "
    "sightings. Given sigma: mean of the accuracy of the POS there; the other sigma is the "
    "smallest one after the correction. Outside the intervals the corrections decay to zero, with "
    "correlation times of {position} s for the position and {attitude} s for the attitude."
)
METHODS_TEXT = N_("Other methods were applied to the same lines. None of them uses the targets.")
METHOD_DESCRIPTIONS: Mapping[Method, str] = {
    "natural planes": N_("Natural planes: adjustment with the validation planes as targets."),
    "targetless": N_("Targetless: adjustment with surfaces detected automatically in the scene."),
    "patch test": N_("Patch test: alignment of the lines on common objects."),
    "correspondences": N_(
        "Point correspondences: adjustment of pairs of points of the same place, from a file."
    ),
}


def reliability_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the reliability of each sighting and each point."""
    adjustment = content.adjustment
    if adjustment is None:
        return []
    if not adjustment.are_sightings_tested or adjustment.critical_w is None:
        if content.settings.pos_errors == "independent":
            untested = gettext(
                "Sightings are not tested: in this stochastic model the points of a sighting have "
                "no common error."
            )
        else:
            untested = gettext(
                "Sightings are not tested: the form error of the targets was set to zero."
            )
        return [Paragraph(untested)]
    found = [each for each in adjustment.sightings if each.is_tested]
    return [
        *reliability_summary(adjustment),
        Paragraph(
            gettext(
                SIGHTING_TEST_TEXT, limit=fixed_number(adjustment.critical_w, 2), count=len(found)
            )
        ),
        report_table(SIGHTING_TESTS_TABLE, found),
        *_sighting_notes(found),
        Paragraph(gettext(POINT_TEST_TEXT, limit=fixed_number(CRITICAL_VALUE, 2))),
        report_table(POINT_TESTS_TABLE, found),
        *_pos_error_blocks(found),
        *_trajectory_correction_blocks(content.trajectory_corrections),
    ]


def _sighting_notes(sightings: Sequence[SightingValues]) -> list[Block]:
    messages = []
    for sighting in sightings:
        if sighting.status == "rejected":
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


def _pos_error_blocks(sightings: Sequence[SightingValues]) -> list[Block]:
    from lispac.report.figures import pos_error_figures_of

    table = report_table(POS_ERRORS_TABLE, sightings)
    blocks: list[Block] = []
    if has_undetermined_pos_errors(sightings):
        blocks.append(Paragraph(gettext(UNDETERMINED_POS_ERRORS_TEXT)))
    return [
        *blocks,
        with_rows_below(table, report_table(MEAN_POS_SIGMAS_TABLE, [mean_pos_sigmas(sightings)])),
        UndrawnPictures(pos_error_caption(sightings), pos_error_figures_of, (tuple(sightings),)),
    ]


def _trajectory_correction_blocks(values: PosCorrectionValues | None) -> list[Block]:
    if values is None:
        return []
    text = gettext(
        TRAJECTORY_CORRECTIONS_TEXT,
        position=fixed_number(values.position_time_s, 0),
        attitude=fixed_number(values.attitude_time_s, 0),
    )
    return [
        Paragraph(text),
        report_table(POS_CORRECTIONS_TABLE, values.components),
        report_table(SIGHTED_INTERVALS_TABLE, values.sighted_intervals),
    ]


def cross_check_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the results of subsets of the data."""
    if content.adjustment is None:
        return []
    checks = content.cross_checks
    if checks is None:
        return [Paragraph(gettext("The adjustment was not repeated with subsets of the data."))]
    rows = subset_rows(checks)
    blocks: list[Block] = [
        *cross_check_summary(content),
        Paragraph(gettext(CROSS_CHECKS_TEXT)),
        Paragraph(gettext(SUBSET_DIFFERENCES_TEXT)),
    ]
    if (sigma := halves_sigma_deg(checks)) is not None:
        roll, pitch, yaw = (fixed_number(each, 4) for each in sigma)
        blocks.append(Paragraph(gettext(HALVES_TEXT, roll=roll, pitch=pitch, yaw=yaw)))
    blocks.append(report_table(SUBSETS_TABLE, rows))
    reasons = tuple(
        gettext("{name}: {reason}", name=row.name, reason=sentence_text(row.subset.reason))
        for row in rows
        if row.subset.reason
    )
    if reasons:
        blocks += [Paragraph(gettext("Subsets without a result:")), Bullets(reasons)]
    return blocks


def control_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the surveyed control, and on the angles with and without it."""
    control = content.control
    if not control.points:
        return []
    blocks: list[Block] = [
        Paragraph(gettext(CONTROL_TEXT)),
        report_table(CONTROL_FILES_TABLE, control.files),
        report_table(CONTROL_TABLE, control.points),
    ]
    if reasons := [sentence_text(each.reason) for each in control.points if each.reason]:
        blocks.append(Bullets(tuple(reasons)))
    return [*blocks, *control_comparison(content)]


def control_comparison(content: ReportContent) -> list[Block]:
    """Table of the estimates with and without the control; none without control."""
    if not content.control.comparison:
        return []
    return [report_table(CONTROL_COMPARISON_TABLE, content.control.comparison)]


def method_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the results of all methods and their differences; none for a single method."""
    found = content.methods
    if len(found) < 2:
        return []
    messages = [
        gettext(
            "{name}: {text}", name=gettext(METHOD_TITLES[each.method]), text=sentence_text(message)
        )
        for each in found
        for message in each.messages
    ]
    described = [
        gettext(text)
        for method, text in METHOD_DESCRIPTIONS.items()
        if any(each.method == method for each in found)
    ]
    blocks: list[Block] = [
        Paragraph(" ".join([gettext(METHODS_TEXT), *described])),
        report_table(METHOD_RESULTS_TABLE, found),
        report_table(*method_differences(found)),
        Bullets(tuple(map(sentence_text, content.method_messages))),
    ]
    return [*blocks, Bullets(tuple(messages))] if messages else blocks
