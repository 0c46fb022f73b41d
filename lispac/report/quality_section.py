"""The table of the quality of each sighting."""

from collections.abc import Mapping

from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.report.document_blocks import Block, Column, Paragraph, Table, as_rows
from lispac.report.report_values import ReportContent, SightingQualityValues
from lispac.report.text_format import (
    degrees_unit,
    fixed_number,
    format_known,
    grouped_number,
    millimetres,
    title_with_unit,
)

LIGHTS: Mapping[str, str] = {
    "good": N_("Good."),
    "doubtful": N_("Doubtful."),
    "poor": N_("Poor."),
}
"""Judgement of a sighting, by what the content calls it."""

COLUMNS = N_(
    "RMS: distance of the points from the surface fitted to this sighting alone. Incidence: angle "
    "between the beams and the normal of the surface."
)
EXTENT = N_(
    "Extent observed: size of the sighting, in percent of the size observed on all other lines "
    "together."
)
BEFORE_CALIBRATION = N_(
    "Before the calibration, the boresight error distorts the points measured from a moving "
    "vessel. Therefore only the part of RMS, curvature and flatness that this error does not "
    "explain is assessed."
)


def quality_blocks(content: ReportContent) -> list[Block]:
    """Every sighting with its statistics and its judgement; nothing where none was judged."""
    if not content.qualities:
        return []
    table = Table(
        gettext("Quality of each sighting"),
        (
            Column(gettext("Target"), "left"),
            Column(gettext("Line"), "left"),
            Column(gettext("Points")),
            Column(title_with_unit(gettext("RMS"), "mm")),
            Column(title_with_unit(gettext("Range"), "m")),
            Column(gettext("Points\nper m²")),
            Column(title_with_unit(gettext("Incidence"), degrees_unit())),
            Column(title_with_unit(gettext("Coverage"), "%")),
            Column(gettext("Extent\nobserved (%)")),
            Column(gettext("Quality"), "left", wide=True),
        ),
        as_rows(
            [
                each.target,
                each.line,
                grouped_number(each.points),
                millimetres(each.rms_m),
                fixed_number(each.range_m, 1),
                format_known(each.density_per_m2, grouped_number),
                format_known(each.incidence_deg, lambda value: fixed_number(value, 0)),
                fixed_number(100 * each.coverage, 0),
                format_known(each.visible_share, lambda value: fixed_number(100 * value, 0)),
                " ".join(
                    (
                        gettext(LIGHTS[each.rating]),
                        *map(message_text, each.reasons),
                        *_edited_note(each),
                    )
                ),
            ]
            for each in content.qualities
        ),
    )
    explained = [COLUMNS]
    if any(each.visible_share is not None for each in content.qualities):
        explained.append(EXTENT)
    if not content.calibrated:
        explained.append(BEFORE_CALIBRATION)
    return [table, *(Paragraph(gettext(each)) for each in explained)]


def _edited_note(sighting: SightingQualityValues) -> tuple[str, ...]:
    if not sighting.edited_by_hand:
        return ()
    return (gettext("The points of this sighting were edited manually."),)
