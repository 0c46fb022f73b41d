"""The section on uncertainty in the terms of published standards, as far as they apply."""

from lispac.language import N_, Plural, gettext
from lispac.report.blocks import Block, Column, Paragraph, Table, rows
from lispac.report.validation_values import SwathDifference
from lispac.report.values import ReportContent, S44Contribution
from lispac.report.wording import cm, fixed, grouped, in_unit, mm

S44 = N_(
    "Total horizontal and vertical uncertainty (THU, TVU) as defined in IHO S-44, edition 6.1.0, "
    "at 95 % confidence: 2.45 standard deviations along the longest axis of the horizontal error "
    "ellipse, 1.96 standard deviations of the height. The table gives the contribution of the "
    "boresight to the uncertainty of a point at that distance from the scanner, for the most "
    "unfavourable beam and a level vessel. It is not the total uncertainty of a survey, which "
    "also includes position, attitude, range, lever arm and the reduction of heights. The orders "
    "of the standard limit the total uncertainty; the table is not compared with them."
)
OVERLAP = N_(
    "The swath overlap difference of the USGS Lidar Base Specification (2024 rev. A) is the root "
    "mean square of the height differences of overlapping swaths (RMSDz) on open ground. The "
    "validation planes are vertical or inclined, so the differences are computed along their "
    "normal, between the means of both lines within cylinders, for every pair of overlapping "
    "lines. Averaging reduces the noise of single points; after the calibration, the POS error of "
    "each line remains. The quality levels of the specification apply to heights on the ground; "
    "the differences are not compared with them."
)
ALL_PLANES = Plural("All ({count:n} plane)", "All ({count:n} planes)")


def standards(content: ReportContent) -> list[Block]:
    """Uncertainty by IHO S-44, and the swath overlap difference."""
    blocks: list[Block] = []
    if content.adjustment is not None:
        blocks += _s44(content.adjustment.s44)
    if content.swath_overlap:
        blocks += _overlap(content.swath_overlap)
    return blocks


def _s44(found: tuple[S44Contribution, ...]) -> list[Block]:
    return [
        Table(
            gettext("Uncertainty by IHO S-44: contribution of the boresight alone, 95 %"),
            (
                Column(in_unit(gettext("Distance"), "m")),
                Column(in_unit("THU", "cm")),
                Column(in_unit("TVU", "cm")),
            ),
            rows([fixed(at.distance_m, 0), cm(at.thu95_m), cm(at.tvu95_m)] for at in found),
        ),
        Paragraph(gettext(S44)),
    ]


def _overlap(found: tuple[SwathDifference, ...]) -> list[Block]:
    return [
        Table(
            gettext("Swath overlap difference (RMSDn, along the normal of the surface)"),
            (
                Column(gettext("Plane"), "left"),
                Column(gettext("Pairs of\nlines")),
                Column(gettext("Places")),
                Column(gettext("RMSDn before\n(mm)")),
                Column(gettext("RMSDn after\n(mm)")),
            ),
            rows(
                [
                    each.plane or gettext(ALL_PLANES, count=len(found) - 1),
                    fixed(each.pairs, 0),
                    grouped(each.places),
                    mm(each.rmsd_before_m),
                    mm(each.rmsd_after_m),
                ]
                for each in found
            ),
        ),
        Paragraph(gettext(OVERLAP)),
    ]
