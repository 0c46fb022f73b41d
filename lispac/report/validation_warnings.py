"""Warnings about the acceptance of a calibration, and about distributions of distances."""

from collections.abc import Iterator, Sequence
from math import pi, radians, sqrt
from statistics import NormalDist, fmean

import numpy as np

from lispac.adjustment.model.parameters import mounting_value_name
from lispac.adjustment.result import ANGLES
from lispac.messages import Message, note, warning
from lispac.present.calibration.cross_checks import (
    CrossCheckValues,
    halves_difference_deg,
    halves_sigma_deg,
)
from lispac.present.checking.acceptance import (
    AcceptanceValues,
    CriterionResult,
    criterion_results,
)
from lispac.present.checking.validation import LineShiftValues, ValidationPlane
from lispac.warning_causes import Cause

VALIDATE_STEP, TARGETS_STEP = Cause.of_step("Validate"), Cause.of_step("Targets")
MAX_OFFSET_SHARE = 0.5
"""Largest ratio of the offset of two lines to the RMS on a plane for which the scatter of the
points causes at least three quarters of the mean square."""
MIN_RMS_PER_OFFSET, MIN_OFFSET_M = 0.9, 0.005
"""Smallest plausible ratio of the RMS of the distances between two lines to their offset, and the
smallest offset, metres, for which it is checked. The RMS contains the offset and the scatter."""
FALSE_WARNING_LEVEL = 0.01
"""Probability of any warning about the distances on the planes of a project without errors."""

MIN_PEAK_PROMINENCE = 0.1
"""Smallest height of a peak of the smoothed histogram above the saddle beside it, as a share of its
height; smaller ones are hardly visible."""
MIN_PEAK_SIGMAS = 4.0
"""The same height in standard deviations of the smoothed histogram."""

HALVES_LIMIT = NormalDist().inv_cdf(1.0 - 0.05 / (2 * len(ANGLES)))
"""Half width of the joint 95 % confidence intervals of the differences of the three angles between
the halves, in their standard deviations (Bonferroni)."""


def acceptance_warnings(
    values: AcceptanceValues, planes: Sequence[ValidationPlane], checks: CrossCheckValues | None
) -> Iterator[Message]:
    """Warning about the criteria that are not met, their causes, and notes on what is not judged.

    Parameters
    ----------
    checks : cross-checks of the result; None if there are none
    """
    items = tuple(map(_failed_criterion, criterion_results(values, "fail")))
    if items:
        yield warning("acceptance.not_met", criteria=items, subject=VALIDATE_STEP)
    yield from _cause_notes(values, planes)
    yield from acceptance_notes(values, checks)


def acceptance_notes(
    values: AcceptanceValues, checks: CrossCheckValues | None
) -> Iterator[Message]:
    """Notes on halves that differ, and on criteria that could not be judged or are not given.

    Parameters
    ----------
    checks : cross-checks of the result; None if there are none
    """
    yield from _halves_note(values, checks)
    unknown = [check for check in values.checks if check.verdict == "not judged"]
    if unknown:
        planes = tuple(dict.fromkeys(check.plane for check in unknown if check.plane))
        if planes:
            yield note("acceptance.planes_not_judged", planes=planes, subject=VALIDATE_STEP)
        else:
            yield note("acceptance.not_judged", subject=VALIDATE_STEP)
    missing = values.criteria.missing
    if values.checks and missing:
        criteria = tuple(note(f"acceptance_value.{name}") for name in missing)
        yield note("acceptance.criteria_missing", criteria=criteria, subject=VALIDATE_STEP)


def _halves_note(values: AcceptanceValues, checks: CrossCheckValues | None) -> Iterator[Message]:
    """Note on angles by which the halves differ more than the criterion permits.

    A criterion limits the standard deviation of an angle. A difference that exceeds it, and its own
    confidence interval, shows that the angle may be less certain than its standard deviation says.
    """
    difference, sigma = (
        (None, None)
        if checks is None
        else (halves_difference_deg(checks), halves_sigma_deg(checks))
    )
    if difference is None or sigma is None:
        return
    limits = {each.quantity: each.limit for each in values.checks if each.unit == "deg"}
    items = tuple(
        note(
            "item.half_difference",
            angle=mounting_value_name(angle), difference=radians(apart),
            interval=radians(HALVES_LIMIT * own), limit=radians(limits[angle]),
        )
        for angle, apart, own in zip(ANGLES, difference, sigma, strict=True)
        if angle in limits and abs(apart) > max(limits[angle], HALVES_LIMIT * own)
    )  # fmt: skip
    if items:
        yield note(
            "acceptance.halves_differ",
            items=items, ratio=HALVES_LIMIT, subject=Cause.of_page("Cross-checks"),
        )  # fmt: skip


def probable_causes(
    values: AcceptanceValues, planes: Sequence[ValidationPlane], wrong: Message | None = None
) -> tuple[Message, ...]:
    """Probable causes of the criteria that are not met; the subject is where to correct each.

    Parameters
    ----------
    wrong : warning about the given value of the mounting that causes most of the residuals
    """
    if wrong is not None:
        return (
            note(
                "acceptance.cause_given_value",
                parameter=wrong.params["parameter"], subject=wrong.subject,
            ),
        )  # fmt: skip
    failed = _failed_planes(values)
    shifted = [each for each in distribution_warnings(planes) if each.params["target"] in failed]
    return (*shifted, *_cause_notes(values, planes))


def _failed_planes(values: AcceptanceValues) -> set[str]:
    return {each.plane for each in values.checks if each.plane and each.verdict == "fail"}


def _cause_notes(values: AcceptanceValues, planes: Sequence[ValidationPlane]) -> Iterator[Message]:
    """Causes of the failures that no warning about the distributions explains."""
    angles = [each for each in values.checks if not each.plane and each.verdict == "fail"]
    if angles:
        names = tuple(mounting_value_name(each.quantity) for each in angles)
        yield note("acceptance.cause_geometry", angles=names, subject=TARGETS_STEP)
    unexplained = _failed_planes(values) - _planes_with_distribution_warnings(planes)
    failed = [plane for plane in planes if plane.name in unexplained]
    for plane in failed:
        offset = _largest_pooled_offset(plane)
        if offset is not None and _has_scatter(plane, values):
            yield note(
                "acceptance.cause_scatter",
                target=plane.name, rms=plane.after.rms_m, offset=offset,
                subject=Cause.of_target(plane.name),
            )  # fmt: skip
    if known := planes_with_pos_errors(values, planes):
        yield note(
            "acceptance.cause_pos",
            planes=tuple(map(_shifts_on_plane, known)),
            ratio=max(_significance(each) for plane in known for each in plane.shifts),
            limit=shift_limit(planes), subject=Cause.of_field("position_sigma"),
        )  # fmt: skip
    unknown = tuple(
        plane.name for plane in failed if not (plane.shifts or _has_scatter(plane, values))
    )
    if unknown:
        yield note("acceptance.cause_unknown", planes=unknown, subject=VALIDATE_STEP)


def planes_with_pos_errors(
    values: AcceptanceValues, planes: Sequence[ValidationPlane]
) -> list[ValidationPlane]:
    """Planes with a failed criterion whose shifts the errors of POS and boresight explain."""
    unexplained = _failed_planes(values) - _planes_with_distribution_warnings(planes)
    return [
        plane
        for plane in planes
        if plane.name in unexplained and plane.shifts and not _has_scatter(plane, values)
    ]


def _planes_with_distribution_warnings(planes: Sequence[ValidationPlane]) -> set[str]:
    return {str(each.params["target"]) for each in distribution_warnings(planes)}


def _shifts_on_plane(plane: ValidationPlane) -> Message:
    """Plane with the shifts of the two lines whose offset is the largest."""
    pair = plane.largest_offset
    lines = () if pair is None else (pair.line_a, pair.line_b)
    shifts = {each.lines[0]: each.offset_m for each in plane.shifts if len(each.lines) == 1}
    items = tuple(
        note("validation.shift_of_line", line=line, shift=shifts[line])
        for line in lines
        if line in shifts
    )
    return note("validation.shifts_on_plane", target=plane.name, lines=items)


def _has_scatter(plane: ValidationPlane, values: AcceptanceValues) -> bool:
    """Whether RMS and 95 % fail because of the scatter of the points, not of offsets of lines."""
    offset = _largest_pooled_offset(plane)
    if offset is None:
        return False
    quantities = {
        each.quantity
        for each in values.checks
        if each.plane == plane.name and each.verdict == "fail"
    }
    return quantities <= {"rms", "p95"} and offset < MAX_OFFSET_SHARE * plane.after.rms_m


def _largest_pooled_offset(plane: ValidationPlane) -> float | None:
    """Largest offset of the pairs of lines in the RMS, metres; None if it is not known."""
    offsets = [
        abs(pair.after.signed.median_m)
        for pair in plane.pairs
        if pair.after.signed is not None and (pair.reciprocal or plane.pooled_from == "all pairs")
    ]
    return max(offsets, default=None)


def _failed_criterion(result: CriterionResult) -> Message:
    """Criterion that is not met, with its largest value and all planes on which it fails."""
    assert result.value is not None
    if result.unit == "deg":
        return note(
            "acceptance_failure.angle",
            angle=mounting_value_name(result.quantity), value=radians(result.value),
            limit=radians(result.limit),
        )  # fmt: skip
    return note(
        f"acceptance_failure.{result.quantity}",
        planes=result.planes, value=result.value, limit=result.limit,
    )  # fmt: skip


def distribution_warnings(planes: Sequence[ValidationPlane]) -> Iterator[Message]:
    """Warnings about shifted lines and distances with two modes on validation planes.

    All tests together have the significance level `FALSE_WARNING_LEVEL` (Bonferroni). Of the shifts
    on a plane, which are caused by the same errors, only the most significant one is reported.
    """
    level = _test_level(planes)
    limit = shift_limit(planes)
    for plane in planes:
        where = Cause.of_target(plane.name)
        significant = [each for each in plane.shifts if abs(each.offset_m) > limit * each.sigma_m]
        if significant:
            yield _shift_warning(plane.name, max(significant, key=_significance), limit)
        for pair in plane.pairs:
            modes = pair.modes
            if modes is not None and (
                modes.probability < level and modes.distance_m > limit * modes.sigma_m
            ):
                yield warning(
                    "validation.two_modes",
                    target=plane.name, line=pair.line_a, other=pair.line_b,
                    distance=modes.distance_m, share=modes.share, limit=limit * modes.sigma_m,
                    subject=where,
                )  # fmt: skip


def offset_notes(
    planes: Sequence[ValidationPlane], noted: Sequence[ValidationPlane] | None = None
) -> Iterator[Message]:
    """Note on planes on which the lines with the largest offset are not closer than before.

    The note says whether POS and boresight explain the shifts of the lines on these planes.

    Parameters
    ----------
    noted : planes that may be in the note; None for all
    """
    found = []
    for plane in planes if noted is None else noted:
        before, after = plane.former_offset_m, plane.largest_offset_m
        if before is not None and after is not None and after > MIN_OFFSET_M and after >= before:
            found.append((plane, before, after))
    if not found:
        return
    items = tuple(
        note(
            "validation.offset_on_plane",
            target=plane.name, lines=plane.largest_offset_lines, before=before, after=after,
        )
        for plane, before, after in found
    )  # fmt: skip
    where = Cause.of_target(found[0][0].name)
    if not all(plane.shifts for plane, _, _ in found):
        yield note("validation.offset_not_smaller_unknown", items=items, subject=where)
        return
    limit = shift_limit(planes)
    ratio = max(_significance(shift) for plane, _, _ in found for shift in plane.shifts)
    is_explained = ratio <= limit
    yield note(
        "validation.offset_not_smaller"
        if is_explained
        else "validation.offset_not_smaller_shifted",
        items=items, ratio=ratio, limit=limit, subject=where,
    )  # fmt: skip


def peak_notes(
    planes: Sequence[ValidationPlane], noted: Sequence[ValidationPlane] | None = None
) -> Iterator[Message]:
    """Note on planes whose pooled distances have several peaks because the offsets of pairs differ.

    The distances of all pairs are pooled without their signs. Planes with a warning about their
    distribution are omitted, because it names the lines.

    Parameters
    ----------
    noted : planes that may be in the note; None for all
    """
    warned = _planes_with_distribution_warnings(planes)
    found = [
        (plane, peaks)
        for plane in (planes if noted is None else noted)
        if plane.name not in warned and (peaks := _separate_peaks(plane)) is not None
    ]
    if not found:
        return
    where = Cause.of_target(found[0][0].name)
    items = tuple(
        note("validation.peaks_on_plane", target=plane.name, smaller=low, larger=high)
        for plane, (low, high) in found
    )
    if all(plane.shifts for plane, _ in found):
        limit = shift_limit(planes)
        yield note("validation.several_peaks", items=items, limit=limit, subject=where)
    else:
        yield note("validation.several_peaks_unknown", items=items, subject=where)


def _separate_peaks(plane: ValidationPlane) -> tuple[float, float] | None:
    """Places of the two highest peaks of the pooled distances, metres; None if there is one.

    The histogram is smoothed by a quarter of the scatter of a pair about its offset.
    """
    pairs = [
        (signed.median_m, pair.after.distances.rms_m)
        for pair in plane.pairs
        if (signed := pair.after.signed) is not None
        and (pair.reciprocal or plane.pooled_from == "all pairs")
    ]
    if len(pairs) < 2 or len(plane.counts_after) < 2:
        return None
    from scipy.ndimage import gaussian_filter1d
    from scipy.signal import find_peaks

    scatter = sqrt(fmean(max(rms**2 - offset**2, 0.0) for offset, rms in pairs))
    edges = np.array(plane.bin_edges_m)
    # The last bin includes all distances beyond it, which are no peak.
    counts = np.array([*plane.counts_after[:-1], 0], dtype=float)
    width = float(edges[1] - edges[0])
    kernel = max(scatter / 4.0, width)
    density = gaussian_filter1d(counts / np.diff(edges), kernel / width, mode="reflect")
    # Reflected, so that a maximum at zero is a peak too.
    whole = np.concatenate([density[::-1], density])
    peaks, found = find_peaks(whole, prominence=0.0)
    # Silverman (1986): variance of a density estimated with a Gaussian kernel
    chance = MIN_PEAK_SIGMAS * np.sqrt(whole[peaks] / (2.0 * sqrt(pi) * kernel))
    limits = np.maximum(MIN_PEAK_PROMINENCE * whole[peaks], chance)
    clear = peaks[found["prominences"] >= limits] - len(density)
    kept = [max(int(k), 0) for k in clear if k >= -1]  # at zero, -1 and 0 form one maximum
    if len(kept) < 2:
        return None
    first, second = sorted(sorted(kept, key=lambda k: density[k])[-2:])
    middles = (edges[:-1] + edges[1:]) / 2.0
    return float(middles[first]), float(middles[second])


def larger_distances_messages(planes: Sequence[ValidationPlane]) -> Iterator[Message]:
    """Messages on planes on which the distances are larger after the calibration than before.

    There is one note on all planes on which POS and boresight explain the shifts of the lines, and
    a warning on each other plane.
    """
    limit, ratios, items = shift_limit(planes), [], []
    for plane in planes:
        before, after, where = plane.before.rms_m, plane.after.rms_m, Cause.of_target(plane.name)
        if after <= before:
            continue
        ratio = max(map(_significance, plane.shifts), default=float("inf"))
        if ratio > limit:
            yield warning(
                "report.validation_worse",
                target=plane.name, after=after, before=before, subject=where,
            )  # fmt: skip
            continue
        item = note("report.validation_on_plane", target=plane.name, before=before, after=after)
        items.append(item)
        ratios.append((ratio, where))
    if items:
        ratio, where = max(ratios, key=lambda each: each[0])
        yield note(
            "report.validation_worse_explained",
            items=tuple(items), ratio=ratio, limit=limit, subject=where,
        )  # fmt: skip


def surface_model_warnings(planes: Sequence[ValidationPlane]) -> Iterator[Message]:
    """Warning on each plane on which the RMS of two lines is too small for their offset.

    This happens if the local surfaces are fitted to too few points (see `DEFAULT_NEIGHBOURS`).
    """
    for plane in planes:
        low = [
            (pair.after.distances.rms_m / abs(pair.after.signed.median_m), pair)
            for pair in plane.pairs
            if pair.after.signed is not None and abs(pair.after.signed.median_m) > MIN_OFFSET_M
        ]
        ratio, pair = min(low, key=lambda each: each[0], default=(1.0, None))
        if pair is None or pair.after.signed is None or ratio >= MIN_RMS_PER_OFFSET:
            continue
        yield warning(
            "validation.rms_below_offset",
            target=plane.name, line=pair.line_a, other=pair.line_b, rms=pair.after.distances.rms_m,
            offset=abs(pair.after.signed.median_m), subject=VALIDATE_STEP,
        )  # fmt: skip


def shift_limit(planes: Sequence[ValidationPlane]) -> float:
    """Number of standard deviations above which a shift on any of the planes is significant."""
    from scipy.special import ndtri

    return -float(ndtri(_test_level(planes) / 2.0))


def _test_level(planes: Sequence[ValidationPlane]) -> float:
    """Significance level of each of the tests on all planes."""
    tests = sum(_possible_groups(plane) + len(plane.pairs) for plane in planes if plane.shifts)
    return FALSE_WARNING_LEVEL / max(tests, 1)


def _possible_groups(plane: ValidationPlane) -> int:
    """Number of ways to divide the lines of a plane into two groups, of which some were tested."""
    lines = {line for shift in plane.shifts for line in (*shift.lines, *shift.others)}
    return int(2 ** (len(lines) - 1)) - 1


def _significance(shift: LineShiftValues) -> float:
    return abs(shift.offset_m) / shift.sigma_m if shift.sigma_m else float("inf")


def _shift_warning(plane: str, shift: LineShiftValues, limit: float) -> Message:
    offset, explained = abs(shift.offset_m), limit * shift.sigma_m
    if len(shift.lines) > 1 or shift.reciprocal:
        return warning(
            "validation.directions_shifted" if shift.reciprocal else "validation.groups_shifted",
            target=plane, lines=shift.lines, others=shift.others, offset=offset, limit=explained,
            subject=Cause.of_page("Cross-checks"),
        )  # fmt: skip
    (line,) = shift.lines
    return warning(
        "validation.line_shifted",
        target=plane, line=line, others=shift.others, offset=offset, limit=explained,
        subject=Cause.of_line(line),
    )  # fmt: skip
