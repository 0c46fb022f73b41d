"""Warnings on the first page of a report.

Warnings about the result are the same as in the window and on the command line. The rules in this
module use the report content only, with one function for each rule.
"""

from collections.abc import Iterator, Sequence
from statistics import NormalDist

from lispac.adjustment.diagnostics.cause_warnings import without_explained
from lispac.adjustment.diagnostics.warnings import LARGE_RESIDUAL_CODES
from lispac.adjustment.model.parameters import (
    OUTPUT_UNITS,
    mounting_value_name,
    mounting_value_names,
    signed_change,
)
from lispac.message_texts import english_text
from lispac.messages import Message, Value, note, sort_by_importance, warning
from lispac.present.calibration.adjustment import (
    AdjustmentValues,
    is_lidar_noise_estimated,
    targets_with_larger_noise,
)
from lispac.present.calibration.parameters import ParameterValues
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.present.survey.survey_data import PickedPlane
from lispac.present.targets.sighting_quality import SightingQualityValues
from lispac.report.report_values import ReportContent
from lispac.report.validation_warnings import (
    acceptance_warnings,
    distribution_warnings,
    larger_distances_messages,
    offset_notes,
    peak_notes,
    planes_with_pos_errors,
    surface_model_warnings,
)
from lispac.validation.absolute_messages import NamedMean, list_items_with_means
from lispac.warning_causes import RESULT_CAUSE, Cause

DATA_STEP, ADJUST_STEP, VALIDATE_STEP = (
    Cause.of_step(name) for name in ("Data", "Adjust", "Validate")
)

CHI_SQUARE_LOW_CODES = {"report.chi_square_low", "report.chi_square_low_estimated"}
SMALL_RESIDUAL_CODES = {
    "adjustment.sigmas_raised_conservative", "adjustment.lidar_noise_conservative",
    "adjustment.lidar_noise_ratio_conservative", "adjustment.lidar_noise_assumed_conservative",
}  # fmt: skip
"""Codes of messages that say what small residuals mean for the sigmas of the angles. If there is
one of them, or one on large residuals of a target, the note on the chi-square test is omitted."""
NORMAL_FACTOR_95 = NormalDist().inv_cdf(0.975)
"""Half the width of the 95 % interval of a normal variable, in standard deviations."""
NOTE_RMS_RATIO, WARNING_RMS_RATIO = 2.0, 3.0
"""Ratios of the RMS to its expected value above which a note and a warning are given. Errors common
to the lines make the RMS vary about as much as a single error."""


def report_warnings(
    content: ReportContent, warnings_found: Sequence[Message]
) -> tuple[Message, ...]:
    """All warnings, then notes by importance: about the result, and those of the report only.

    Parameters
    ----------
    warnings_found : about the result, as the window and the command line show them
    """
    has_small_residuals_explained = any(
        each.code in SMALL_RESIDUAL_CODES | LARGE_RESIDUAL_CODES for each in warnings_found
    )
    others = list(content.validation)
    if content.calibrated:  # the warnings on the acceptance give the shifts on the other planes
        explained = planes_with_pos_errors(content.acceptance, content.validation)
        others = [plane for plane in content.validation if plane not in explained]
    found = [
        *_calibration_warnings(content),
        *(
            each
            for each in _fit_warnings(content)
            if not (has_small_residuals_explained and each.code in CHI_SQUARE_LOW_CODES)
        ),
        *warnings_found,
        *_parameter_warnings(content),
        *_sighting_warnings(content),
        *_target_warnings(content),
        *_validation_warnings(content),
        *(
            acceptance_warnings(content.acceptance, content.validation, content.cross_checks)
            if content.calibrated
            else ()
        ),
        *distribution_warnings(content.validation),
        *offset_notes(content.validation, others),
        *peak_notes(content.validation, others),
        *surface_model_warnings(content.validation),
        *absolute_check_warnings(content.absolute),
        *_method_warnings(content),
        *_file_warnings(content),
    ]
    return sort_by_importance(without_explained(found))


def _calibration_warnings(content: ReportContent) -> Iterator[Message]:
    if not content.calibrated:
        yield warning("report.not_calibrated", subject=ADJUST_STEP)
    if content.simulated:
        yield note("report.simulated", subject=RESULT_CAUSE)
    outside = [
        angle.name
        for angle in content.angles
        if angle.error_deg is not None
        and angle.interval95_deg is not None
        and abs(angle.error_deg) > angle.interval95_deg
    ]
    if outside:
        yield note(
            "report.truth_outside", angles=mounting_value_names(outside), subject=RESULT_CAUSE
        )


def _fit_warnings(content: ReportContent) -> Iterator[Message]:
    if content.adjustment is None:
        return
    independent = content.settings.pos_errors == "independent"
    yield from _chi_square_warnings(content.adjustment, independent)


def _parameter_warnings(content: ReportContent) -> Iterator[Message]:
    for found in content.adjustment.parameters if content.adjustment else ():
        yield from _single_parameter_warnings(found)


def _single_parameter_warnings(parameter: ParameterValues) -> Iterator[Message]:
    name, field = mounting_value_name(parameter.name), Cause.of_parameter(parameter.name)
    if parameter.value is None:
        yield note(
            "report.parameter_not_seen"
            if parameter.prior_sigma is None
            else "report.parameter_not_seen_uncertain",
            parameter=name, reason=parameter.reason, subject=field,
        )  # fmt: skip
    elif parameter.significant is False:
        factor, _ = OUTPUT_UNITS[parameter.name]
        yield note(
            "report.parameter_not_significant",
            parameter=name,
            change=signed_change(parameter.name, (parameter.value - parameter.prior) / factor),
            subject=field,
        )


def _chi_square_warnings(adjustment: AdjustmentValues, independent: bool) -> Iterator[Message]:
    test = adjustment.chi_square
    factors = {target.target: target.noise_factor or 1.0 for target in adjustment.targets}
    is_estimated = is_lidar_noise_estimated(adjustment.components)
    if test.outcome is None:
        yield warning("report.no_redundancy", subject=RESULT_CAUSE)
    elif test.outcome in ("passed", "not judged"):
        return
    elif test.outcome == "conservative":
        yield note(
            "report.chi_square_low_estimated" if is_estimated else "report.chi_square_low",
            subject=RESULT_CAUSE,
        )
    elif test.has_assumed_sigmas:
        yield note("report.chi_square_high_assumed", subject=Cause.of_field("lidar_sigma"))
    elif independent:
        yield warning("report.chi_square_high_classical", subject=RESULT_CAUSE)
    elif noisy := targets_with_larger_noise(adjustment):
        yield note(
            "report.noise_differs" if is_estimated else "report.noise_differs_given",
            targets=noisy, factor=factors[noisy[0]], subject=Cause.of_target(noisy[0]),
        )  # fmt: skip
    elif any(factor > 1 for factor in factors.values()):
        yield note("report.chi_square_high_noise", subject=RESULT_CAUSE)
    else:
        yield note("report.chi_square_high", subject=RESULT_CAUSE)


def _target_warnings(content: ReportContent) -> Iterator[Message]:
    total = len(content.lines)
    for plane in content.planes:
        yield from (
            _single_target_warnings if plane.role == "target" else _validation_plane_warnings
        )(plane, total)
    yield from _not_found_warnings(content)


def _single_target_warnings(target: PickedPlane, total: int) -> Iterator[Message]:
    where, line_count = Cause.of_target(target.name), len(target.lines)
    if not target.used:
        yield note("report.left_out_target", target=target.name, subject=where)
        return
    if line_count == 0:
        yield warning("report.target_on_no_line", target=target.name, total=total, subject=where)
    elif 1 < line_count < total / 2:  # planes on a single line have a warning of the project
        yield note(
            "report.target_on_few_lines",
            target=target.name, count=line_count, total=total, lines=target.lines, subject=where,
        )  # fmt: skip
    if target.excluded_lines:
        yield note(
            "report.left_out_target_on_lines",
            target=target.name, lines=target.excluded_lines, subject=where,
        )  # fmt: skip


def _validation_plane_warnings(plane: PickedPlane, total: int) -> Iterator[Message]:
    where, line_count = Cause.of_target(plane.name), len(plane.lines)
    if not plane.used:
        yield note("report.left_out_plane", target=plane.name, subject=where)
        return
    if line_count == 0:
        yield warning("report.plane_on_no_line", target=plane.name, total=total, subject=where)
    elif line_count == 1:
        yield warning(
            "report.plane_on_one_line",
            target=plane.name, total=total, line=plane.lines[0], subject=where,
        )  # fmt: skip
    elif line_count < total / 2:
        yield note(
            "report.plane_on_few_lines",
            target=plane.name, count=line_count, total=total, lines=plane.lines, subject=where,
        )  # fmt: skip
    if plane.excluded_lines:
        yield note(
            "report.left_out_plane_on_lines",
            target=plane.name, lines=plane.excluded_lines, subject=where,
        )  # fmt: skip


def _not_found_warnings(content: ReportContent) -> Iterator[Message]:
    """Notes on targets that were not found on some lines, one note for each reason."""
    found: dict[str, tuple[Message, list[tuple[str, list[str]]]]] = {}
    for plane in content.planes:
        lines: dict[str, list[str]] = {}
        for line, reason in plane.missing.items() if plane.used else ():
            text = english_text(reason)
            found.setdefault(text, (reason, []))
            lines.setdefault(text, []).append(line)
        for text, names in lines.items():
            found[text][1].append((plane.name, names))
    for reason, targets in found.values():
        items = tuple(
            note("report.not_found_on", target=name, lines=tuple(lines)) for name, lines in targets
        )
        yield note(
            "report.not_found", items=items, reason=reason, subject=Cause.of_target(targets[0][0])
        )


def _sighting_warnings(content: ReportContent) -> Iterator[Message]:
    """Note with the number of poor and doubtful sightings in use, and the worst of them.

    Sightings of targets and of validation planes are counted separately.
    """
    is_target = {plane.name: plane.role == "target" for plane in content.planes}
    used = {(p.name, line) for p in content.planes if p.used for line in p.lines}
    rated = [each for each in content.qualities if (each.target, each.line) in used]
    poor, doubtful = (
        [each for each in rated if each.rating == rating] for rating in ("poor", "doubtful")
    )
    if not poor and not doubtful:
        return

    def severity(each: SightingQualityValues) -> tuple[bool, bool, int, float]:
        is_poor, incidence = each.rating == "poor", each.incidence_deg or 0.0
        return is_poor, is_target[each.target], len(each.reasons), incidence

    worst = max((*poor, *doubtful), key=severity)
    targets = sum(is_target[each.target] for each in rated)
    planes = len(rated) - targets
    yield note(
        "report.sightings", targets=targets, planes=planes,
        sightings=_counts(("item.target_sightings", targets), ("item.plane_sightings", planes)),
        ratings=_counts(("item.doubtful", len(doubtful)), ("item.poor", len(poor))),
        poor=len(poor), doubtful=len(doubtful), target=worst.target, line=worst.line,
        reasons=worst.reasons,
        subject=Cause.of_sighting(worst.target, worst.line),
    )  # fmt: skip


def _counts(*counts: tuple[str, int]) -> tuple[Message, ...]:
    """Items of a list for the counts, by message code, that are not zero."""
    return tuple(note(code, count=count) for code, count in counts if count)


def _validation_warnings(content: ReportContent) -> Iterator[Message]:
    if content.calibrated and not content.validation:
        yield note("report.not_validated", subject=VALIDATE_STEP)
    for reason in content.not_compared:
        yield note("report.not_compared", reason=reason, subject=VALIDATE_STEP)
    yield from larger_distances_messages(content.validation)


def _method_warnings(content: ReportContent) -> Iterator[Message]:
    """Notes on methods that differ from the first."""
    # The messages on the comparisons are in the order of the methods; then there are general ones.
    for each, message in zip(content.methods[1:], content.method_messages, strict=False):
        if each.differ:
            yield note("report.methods_differ", reason=message, subject=ADJUST_STEP)


def _file_warnings(content: ReportContent) -> Iterator[Message]:
    missing: Value = [file.name for file in content.files if file.sha256 is None]
    if missing:
        yield warning("report.file_missing", files=missing, subject=DATA_STEP)


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
