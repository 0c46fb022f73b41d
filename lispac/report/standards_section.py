"""The section that says the figures in the words of published standards, as far as they go."""

from lispac.report.blocks import Block, Column, Paragraph, Table, rows
from lispac.report.validation_values import SwathDifference
from lispac.report.values import ReportContent, S44Contribution
from lispac.report.wording import count, mm


def standards(content: ReportContent) -> list[Block]:
    """What the standards say of it: S-44, and the overlap of swaths."""
    blocks: list[Block] = []
    if content.adjustment is not None:
        blocks += _s44(content.adjustment.s44)
    if content.swath_overlap:
        blocks += _overlap(content.swath_overlap)
    return blocks


def _s44(found: tuple[S44Contribution, ...]) -> list[Block]:
    return [
        Table(
            "Uncertainty in the wording of IHO S-44: contribution of the boresight alone, 95 %",
            (Column("Distance\n(m)"), Column("THU\n(cm)"), Column("TVU\n(cm)")),
            rows(
                [f"{at.distance_m:.0f}", f"{100 * at.thu95_m:.2f}", f"{100 * at.tvu95_m:.2f}"]
                for at in found
            ),
        ),
        Paragraph(
            "Total horizontal and vertical uncertainty (THU, TVU) as IHO S-44, edition 6.1.0, "
            "states them, at 95 % confidence: 2.45 standard deviations along the longest axis of "
            "the horizontal error ellipse, 1.96 standard deviations of the height. Given is what "
            "the uncertainty of the boresight adds to a point at that distance from the scanner, "
            "for the beam where it shows most and a level vessel. It is not the total of a survey, "
            "to which position, attitude, range, lever arm and the reduction of heights add; the "
            "orders of the standard limit the total and are not compared."
        ),
    ]


def _overlap(found: tuple[SwathDifference, ...]) -> list[Block]:
    return [
        Table(
            "Swath overlap difference (RMSDn, along the surface's normal)",
            (
                Column("Plane", "left"),
                Column("Pairs of\nlines"),
                Column("Places"),
                Column("RMSDn before\n(mm)"),
                Column("RMSDn after\n(mm)"),
            ),
            rows(
                [
                    each.plane or f"All {count(len(found) - 1, 'plane')}",
                    str(each.pairs),
                    f"{each.places:,}",
                    mm(each.rmsd_before_m),
                    mm(each.rmsd_after_m),
                ]
                for each in found
            ),
        ),
        Paragraph(
            "After the swath overlap difference of the USGS Lidar Base Specification (2024 "
            "rev. A), the root mean square of the differences in height of overlapping swaths "
            "(RMSDz) on open ground. The validation planes stand upright or lean, so the "
            "differences are taken along their normal: between the means of both lines within "
            "cylinders, at places of either, for every pair of lines that overlaps. The noise of "
            "single points averages out; what remains after the calibration is the POS error of "
            "each line. The quality levels of the specification hold for heights on the ground and "
            "are not compared."
        ),
    ]
