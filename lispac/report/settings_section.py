"""The section on settings: system, points, stochastic model and input files."""

from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.present.parameters import VARIANCE_COMPONENTS_TABLE
from lispac.present.settings import model_facts, system_facts
from lispac.present.survey_data import FILES_TABLE
from lispac.report.document_blocks import (
    Block,
    Bullets,
    Paragraph,
    facts_table,
    report_table,
)
from lispac.report.report_values import ReportContent

SURFACE_SIGMA_TEXT = N_(
    "Form error of the targets: standard deviation of the offset of a whole sighting from the "
    "common surface of all lines."
)
VARIANCE_COMPONENTS_TEXT = N_(
    "Variance components are estimated from the residuals and the estimated POS errors by "
    "restricted maximum likelihood. A sigma is increased if the data show a larger one, and "
    "decreased only if the whole interval is below the given value; otherwise the given value is "
    "used. Few sightings give little information on the POS: if the interval is wide, the given "
    "sigma may be as reliable as the estimated one."
)


def settings_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the settings of system, points and stochastic model, and on the input files."""
    used, adjustment = content.settings, content.adjustment
    blocks: list[Block] = [
        facts_table(gettext("System and points"), system_facts(used, adjustment)),
        facts_table(gettext("Stochastic model"), model_facts(used, adjustment)),
    ]
    if used.surface_from_data is not None:
        blocks.append(Paragraph(gettext(SURFACE_SIGMA_TEXT)))
    if adjustment is not None and adjustment.components:
        blocks += [
            report_table(VARIANCE_COMPONENTS_TABLE, adjustment.components),
            Paragraph(gettext(VARIANCE_COMPONENTS_TEXT)),
        ]
    blocks.append(report_table(FILES_TABLE, content.files))
    if content.notes:
        blocks += [
            Paragraph(gettext("Input assumptions:")),
            Bullets(tuple(map(message_text, content.notes))),
        ]
    return blocks
