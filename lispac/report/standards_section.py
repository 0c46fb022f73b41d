"""The section on uncertainty as defined in IHO S-44 and the USGS Lidar Base Specification."""

from lispac.language import N_, Plural, gettext
from lispac.present.displacement import S44Contribution
from lispac.present.text_format import (
    centimetres,
    fixed_number,
    grouped_number,
    millimetres,
    title_with_unit,
)
from lispac.present.validation import SwathDifference
from lispac.report.document_blocks import Block, Column, Paragraph, Table, as_rows
from lispac.report.report_values import ReportContent

S44_TEXT = N_(
    "Total horizontal and vertical uncertainty (THU, TVU) as defined in IHO S-44, edition 6.1.0, "
    "at 95 % confidence: 2.45 standard deviations along the longest axis of the horizontal error "
    "ellipse, 1.96 standard deviations of the height. The table gives the contribution of the "
    "boresight to the uncertainty of a point at that distance from the scanner, for the most "
    "unfavourable beam and a level vessel. It is not the total uncertainty of a survey, which "
    "also includes position, attitude, range, lever arm and the reduction of heights. The orders "
    "of the standard limit the total uncertainty; the table is not compared with them."
)
OVERLAP_TEXT = N_(
    "The swath overlap difference of the USGS Lidar Base Specification (2024 rev. A) is the root "
    "mean square of the height differences of overlapping swaths (RMSDz) on open ground. The "
    "validation planes are vertical or inclined, so the differences are computed along their "
    "normal, between the means of both lines within cylinders, for every pair of overlapping "
    "lines. Averaging reduces the noise of single points; after the calibration, the POS error of "
    "each line remains. The quality levels of the specification apply to heights on the ground; "
    "the differences are not compared with them."
)
ALL_PLANES_TEXT = Plural("All ({count:n} plane)", "All ({count:n} planes)")


def standards_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the uncertainty by IHO S-44 and the swath overlap difference."""
    blocks: list[Block] = []
    if content.adjustment is not None:
        blocks += _s44_tables(content.adjustment.s44)
    if content.swath_overlap:
        blocks += _swath_overlap_tables(content.swath_overlap)
    return blocks


def _s44_tables(contributions: tuple[S44Contribution, ...]) -> list[Block]:
    return [
        Table(
            gettext("Uncertainty by IHO S-44: contribution of the boresight alone, 95 %"),
            (
                Column(title_with_unit(gettext("Distance"), "m")),
                Column(title_with_unit("THU", "cm")),
                Column(title_with_unit("TVU", "cm")),
            ),
            as_rows(
                [fixed_number(at.distance_m, 0), centimetres(at.thu95_m), centimetres(at.tvu95_m)]
                for at in contributions
            ),
        ),
        Paragraph(gettext(S44_TEXT)),
    ]


def _swath_overlap_tables(differences: tuple[SwathDifference, ...]) -> list[Block]:
    return [
        Table(
            gettext("Swath overlap difference (RMSDn, along the normal of the surface)"),
            (
                Column(gettext("Plane"), "left"),
                Column(gettext("Pairs of\nlines")),
                Column(gettext("Compared\nplaces")),
                Column(gettext("RMSDn before\n(mm)")),
                Column(gettext("RMSDn after\n(mm)")),
            ),
            as_rows(
                [
                    each.plane or gettext(ALL_PLANES_TEXT, count=len(differences) - 1),
                    fixed_number(each.pairs, 0),
                    grouped_number(each.places),
                    millimetres(each.rmsd_before_m),
                    millimetres(each.rmsd_after_m),
                ]
                for each in differences
            ),
        ),
        Paragraph(gettext(OVERLAP_TEXT)),
    ]
