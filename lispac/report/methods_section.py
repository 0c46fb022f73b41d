"""The section on alternative methods, beside the targets (as table 4.4 of the thesis)."""

from collections.abc import Mapping

from lispac.adjustment.result import ANGLES
from lispac.language import N_, gettext
from lispac.present.methods import MethodValues
from lispac.present.text_format import angle_text, fixed_number, sentence_text, signed_number, title
from lispac.report.document_blocks import Block, Bullets, Column, Paragraph, Table, as_rows
from lispac.report.report_values import ReportContent

METHODS: Mapping[str, str] = {
    "targets": N_("Targets"),
    "natural planes": N_("Natural planes"),
    "targetless": N_("Targetless"),
    "patch test": N_("Patch test"),
}
"""Names of the methods, as they begin a row of a table."""

EXPLAINED = N_(
    "Other methods applied to the same lines: adjustment with the validation planes as targets "
    "(natural planes), adjustment with surfaces detected automatically in the scene (targetless), "
    "alignment of the lines on common objects (patch test). None of them uses the targets."
)


def method_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the results of the methods side by side, and their differences."""
    found = content.methods
    if len(found) < 2:
        return []
    messages = [
        gettext("{name}: {text}", name=_method_name(each), text=sentence_text(message))
        for each in found
        for message in each.messages
    ]
    blocks: list[Block] = [
        Paragraph(gettext(EXPLAINED)),
        _results_table(found),
        _differences_table(found),
        Bullets(tuple(map(sentence_text, content.method_messages))),
    ]
    return [*blocks, Bullets(tuple(messages))] if messages else blocks


def _method_name(each: MethodValues) -> str:
    return gettext(METHODS[each.method])


def _results_table(methods: tuple[MethodValues, ...]) -> Table:
    columns = [
        Column(gettext("Method"), "left"), Column(gettext("Lines")), Column(gettext("Surfaces"))
    ]  # fmt: skip
    for name in ANGLES:
        columns += [Column(title(name)), Column(gettext("1 sigma"))]
    cells = []
    for each in methods:
        row = [_method_name(each), fixed_number(each.lines, 0), fixed_number(each.surfaces, 0)]
        for value, sigma in zip(each.boresight_deg, each.sigma_deg, strict=True):
            row += [angle_text(value), fixed_number(sigma, 4)]
        cells.append(row)
    return Table(gettext("Boresight by each method (deg)"), tuple(columns), as_rows(cells))


def _differences_table(methods: tuple[MethodValues, ...]) -> Table:
    columns = [Column(gettext("Method"), "left")]
    for name in ANGLES:
        columns += [Column(title(name)), Column(gettext("Difference\n/ sigma"))]
    cells = []
    for each in methods:
        if each.difference_deg is None or each.significance is None:
            continue
        row = [_method_name(each)]
        for value, over in zip(each.difference_deg, each.significance, strict=True):
            row += [angle_text(value), signed_number(over, 1)]
        cells.append([*row, gettext("yes") if each.differ else gettext("no")])
    columns.append(Column(gettext("Significant\ndifference")))
    head = gettext(
        "Differences from the first method, {method} (deg)", method=_method_name(methods[0])
    )
    return Table(head, tuple(columns), as_rows(cells))
