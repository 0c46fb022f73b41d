"""The section on uncertainty as defined in IHO S-44 and the USGS Lidar Base Specification."""

from lispac.language import N_, gettext
from lispac.present.displacement import S44_TABLE
from lispac.present.validation import swath_overlap_table
from lispac.report.document_blocks import Block, Paragraph, report_table
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


def standards_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the uncertainty by IHO S-44 and the swath overlap difference."""
    blocks: list[Block] = []
    if content.adjustment is not None:
        blocks += [
            report_table(S44_TABLE, content.adjustment.s44),
            Paragraph(gettext(S44_TEXT)),
        ]
    if content.swath_overlap:
        table = swath_overlap_table(len(content.swath_overlap) - 1)
        blocks += [
            report_table(table, content.swath_overlap),
            Paragraph(gettext(OVERLAP_TEXT)),
        ]
    return blocks
