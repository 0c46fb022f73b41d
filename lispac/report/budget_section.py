"""The tables of the error budget of a point at a distance."""

from lispac.language import gettext
from lispac.message_texts import message_text
from lispac.present.error_budget import ErrorBudgetValues, budget_table
from lispac.report.document_blocks import Block, Bullets, Paragraph, report_table


def budget_blocks(budget: ErrorBudgetValues) -> list[Block]:
    """A table for each direction of the beam, and the assumptions."""
    return [
        *(report_table(*budget_table(budget, beam)) for beam in budget.beams),
        Paragraph(gettext("Assumptions of the error budget:")),
        Bullets(tuple(map(message_text, budget.messages))),
    ]
