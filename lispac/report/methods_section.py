"""The section that compares alternative methods with the targets (table 4.4 of the thesis)."""

from lispac.language import N_, gettext
from lispac.present.methods import METHOD_RESULTS_TABLE, METHOD_TITLES, method_differences
from lispac.present.text_format import sentence_text
from lispac.report.document_blocks import Block, Bullets, Paragraph, report_table
from lispac.report.report_values import ReportContent

METHODS_TEXT = N_(
    "Other methods applied to the same lines: adjustment with the validation planes as targets "
    "(natural planes), adjustment with surfaces detected automatically in the scene (targetless), "
    "alignment of the lines on common objects (patch test). None of them uses the targets."
)


def method_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the results of all methods and their differences; none for a single method."""
    found = content.methods
    if len(found) < 2:
        return []
    messages = [
        gettext(
            "{name}: {text}", name=gettext(METHOD_TITLES[each.method]), text=sentence_text(message)
        )
        for each in found
        for message in each.messages
    ]
    blocks: list[Block] = [
        Paragraph(gettext(METHODS_TEXT)),
        report_table(METHOD_RESULTS_TABLE, found),
        report_table(*method_differences(found)),
        Bullets(tuple(map(sentence_text, content.method_messages))),
    ]
    return [*blocks, Bullets(tuple(messages))] if messages else blocks
