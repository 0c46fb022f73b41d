"""Sentences at the start of the long sections of a report, each with the numbers that matter."""

from lispac.language import Plural, gettext
from lispac.present.calibration.adjustment import AdjustmentValues
from lispac.present.calibration.cross_checks import agreement_text
from lispac.present.text_format import fixed_number
from lispac.report.document_blocks import Block, Paragraph
from lispac.report.report_values import ReportContent


def precision_summary(adjustment: AdjustmentValues) -> list[Block]:
    """Standard deviations of the angles."""
    sigma = adjustment.sigma_deg
    return [
        Paragraph(
            gettext(
                "Standard deviations of the angles: roll {roll}°, pitch {pitch}°, yaw {yaw}°.",
                roll=fixed_number(sigma.roll, 4),
                pitch=fixed_number(sigma.pitch, 4),
                yaw=fixed_number(sigma.yaw, 4),
            )
        )
    ]


def residuals_summary(adjustment: AdjustmentValues) -> list[Block]:
    """Smallest and largest RMS of the sightings after the calibration."""
    rms = [(each.rms_after_m, each) for each in adjustment.sightings]
    if not rms:
        return []
    largest = max(rms, key=lambda each: each[0])
    return [
        Paragraph(
            gettext(
                "The RMS of the sightings is {least:mm.1} to {largest:mm.1} mm after the "
                "calibration; the largest is that of {target} on {line}.",
                least=min(value for value, _ in rms), largest=largest[0],
                target=largest[1].target, line=largest[1].line,
            )
        )
    ]  # fmt: skip


def quality_summary(content: ReportContent) -> list[Block]:
    """Numbers of good, doubtful and poor sightings."""
    ratings = [each.rating for each in content.qualities]
    return [
        Paragraph(
            gettext(
                Plural(
                    "{count:n} sighting: {good:n} good, {doubtful:n} doubtful, {poor:n} poor.",
                    "{count:n} sightings: {good:n} good, {doubtful:n} doubtful, {poor:n} poor.",
                ),
                count=len(ratings), good=ratings.count("good"),
                doubtful=ratings.count("doubtful"), poor=ratings.count("poor"),
            )
        )
    ]  # fmt: skip


def reliability_summary(adjustment: AdjustmentValues) -> list[Block]:
    """Number of sightings that agree, and the largest test value."""
    tested = [each for each in adjustment.sightings if each.is_tested]
    known = [(abs(each.w), each) for each in tested if each.w is not None]
    if not known:
        return []
    largest, worst = max(known, key=lambda each: each[0])
    return [
        Paragraph(
            gettext(
                "{agreeing:n} of {count:n} sightings agree with the others. The largest test value "
                "w is {w:x.2}, that of {target} on {line}.",
                agreeing=sum(each.status == "agrees" for each in tested), count=len(tested),
                w=largest, target=worst.target, line=worst.line,
            )
        )
    ]  # fmt: skip


def cross_check_summary(content: ReportContent) -> list[Block]:
    """Number of subsets that agree."""
    if content.cross_checks is None:
        return []
    return [
        Paragraph(gettext("Subsets: {agreement}.", agreement=agreement_text(content.cross_checks)))
    ]


def validation_summary(content: ReportContent) -> list[Block]:
    """Range of the RMS on the validation planes before and after, and the largest offset."""
    planes = content.validation
    if not planes:
        return []
    before, after = ([p.before.rms_m for p in planes], [p.after.rms_m for p in planes])
    text = gettext(
        Plural(
            "{count:n} validation plane: RMS {before:mm.1} mm before and {after:mm.1} mm after the "
            "calibration.",
            "{count:n} validation planes: RMS up to {before:mm.1} mm before and up to {after:mm.1} "
            "mm after the calibration.",
        ),
        count=len(planes), before=max(before), after=max(after),
    )  # fmt: skip
    known = [(p.largest_offset_m, p) for p in planes if p.largest_offset_m is not None]
    if known:
        offset, plane = max(known, key=lambda each: each[0])
        largest = gettext(
            "Largest offset of two lines after it: {offset:mm.1} mm, on {plane} ({lines}).",
            offset=offset, plane=plane.name, lines=plane.largest_offset_lines,
        )  # fmt: skip
        text = f"{text} {largest}"
    return [Paragraph(text)]
