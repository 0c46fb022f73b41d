"""The section on the quality of each sighting."""

from lispac.language import N_, gettext
from lispac.present.sighting_quality import QUALITY_TABLE
from lispac.report.document_blocks import Block, Paragraph, report_table
from lispac.report.report_values import ReportContent

COLUMNS_TEXT = N_(
    "RMS: distance of the points from the surface fitted to this sighting alone. Incidence: angle "
    "between the beams and the normal of the surface."
)
EXTENT_TEXT = N_(
    "Extent observed: size of the sighting, in percent of the size observed on all other lines "
    "together."
)
BEFORE_CALIBRATION_TEXT = N_(
    "Before the calibration, the boresight error distorts the points measured from a moving "
    "vessel. Therefore only the part of RMS, curvature and flatness that this error does not "
    "explain is assessed."
)


def quality_blocks(content: ReportContent) -> list[Block]:
    """Table of all sightings with statistics and rating, and explanations; none without ratings."""
    if not content.qualities:
        return []
    explained = [COLUMNS_TEXT]
    if any(each.visible_share is not None for each in content.qualities):
        explained.append(EXTENT_TEXT)
    if not content.calibrated:
        explained.append(BEFORE_CALIBRATION_TEXT)
    return [
        report_table(QUALITY_TABLE, content.qualities),
        *(Paragraph(gettext(each)) for each in explained),
    ]
