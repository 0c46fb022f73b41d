"""The section on alternative methods, beside the targets (as the thesis's table 4.4)."""

from lispac.adjustment.result import ANGLES
from lispac.report.blocks import Block, Bullets, Column, Paragraph, Table, rows
from lispac.report.opinion_values import MethodAnswer
from lispac.report.values import ReportContent
from lispac.report.wording import angle, signed


def second_opinions(content: ReportContent) -> list[Block]:
    """The answers side by side, and what they differ by."""
    found = content.methods
    if len(found) < 2:
        return []
    remarks = [f"{each.method.capitalize()}: {remark}" for each in found for remark in each.remarks]
    blocks: list[Block] = [
        Paragraph(
            "What other methods say of the same lines: the validation planes adjusted as if they "
            "were targets (natural planes), surfaces of the scene that no one picked (targetless), "
            "lines turned until they meet on objects (patch test). The targets take part in none "
            "of them."
        ),
        _answers(found),
        _differences(found),
        Bullets(content.methods_in_words),
    ]
    return [*blocks, Bullets(tuple(remarks))] if remarks else blocks


def _answers(found: tuple[MethodAnswer, ...]) -> Table:
    columns = [Column("Method", "left"), Column("Lines"), Column("Surfaces")]
    for name in ANGLES:
        columns += [Column(name.capitalize()), Column("1 sigma")]
    cells = []
    for each in found:
        row = [each.method.capitalize(), str(each.lines), str(each.surfaces)]
        for value, sigma in zip(each.boresight_deg, each.sigma_deg, strict=True):
            row += [angle(value), f"{sigma:.4f}"]
        cells.append(row)
    return Table("The boresight by each method (deg)", tuple(columns), rows(cells))


def _differences(found: tuple[MethodAnswer, ...]) -> Table:
    columns = [Column("Method", "left")]
    for name in ANGLES:
        columns += [Column(name.capitalize()), Column("over its\nsigma")]
    cells = []
    for each in found:
        if each.difference_deg is None or each.over_sigma is None:
            continue
        row = [each.method.capitalize()]
        for value, over in zip(each.difference_deg, each.over_sigma, strict=True):
            row += [angle(value), signed(over, 1)]
        cells.append([*row, "yes" if each.differ else "no"])
    columns.append(Column("Differs"))
    return Table(f"Differences from the {found[0].method} (deg)", tuple(columns), rows(cells))
