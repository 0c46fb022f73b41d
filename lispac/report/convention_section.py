"""The section on other programs: the boresight in their convention, and as a matrix."""

from lispac.report.blocks import Block, Column, Paragraph, Table, facts, rows
from lispac.report.convention_values import InConvention, ScannerToBody
from lispac.report.values import ReportContent
from lispac.report.wording import UNKNOWN, known, minus, signed, title

EXACT = 8
"""Decimals of angles that change much for a small turn."""


def other_programs(content: ReportContent) -> list[Block]:
    """Boresight and lever arm as other programs want them."""
    blocks: list[Block] = []
    if content.in_convention is not None:
        blocks += _convention(content.in_convention)
    if content.matrix is not None:
        blocks += _matrix(content.matrix)
    return blocks


def _convention(found: InConvention) -> list[Block]:
    blocks: list[Block] = []
    if found.angles:
        decimals = EXACT if found.note else 4
        blocks.append(
            Table(
                f"Boresight for {found.name}: convention {found.status_in_words}",
                (
                    Column("Angle", "left"),
                    Column("Value\n(deg)"),
                    Column("1 sigma\n(deg)"),
                    Column("Sign", "left", wide=True),
                ),
                rows(
                    [
                        title(angle.name),
                        signed(angle.value_deg, decimals),
                        known(angle.sigma_deg, lambda v: f"{v:.4f}", UNKNOWN),
                        angle.meaning,
                    ]
                    for angle in found.angles
                ),
            )
        )
    x, y, z = (signed(value, 4) for value in found.lever_arm_m)
    axes = found.body_axes
    said = [
        ("How well this is known", f"{found.status_in_words}; source: {found.source}"),
        *([("Assumed", found.assumption)] if found.assumption else []),
        ("Rotation", _rotation(found)),
        ("Body axes", f"X {axes[0]}, Y {axes[1]}, Z {axes[2]}"),
        ("Scanner axes", found.scanner_in_words),
        ("Lever arm", f"X {x} m, Y {y} m, Z {z} m: LiDAR optical centre from the POS centre"),
    ]
    blocks.append(facts(f"Convention of {found.name}", said))
    sentences = (found.check_first, found.note, found.offsets_in_words, found.caution)
    blocks += [Paragraph(sentence.strip()) for sentence in sentences if sentence]
    return blocks


def _rotation(found: InConvention) -> str:
    if not found.angles:
        return "taken as a matrix only"
    return f"{minus(found.formula)}, {found.direction_in_words}"


def _matrix(found: ScannerToBody) -> list[Block]:
    axes = found.body_axes
    return [
        Table(
            f"Matrix from scanner to body for {found.name}",
            (
                Column("Scanner X"),
                Column("Scanner Y"),
                Column("Scanner Z"),
                Column("Lever arm (m)"),
            ),
            rows([minus(f"{value:.10f}") for value in row] for row in found.transform),
        ),
        Paragraph(
            f"Rows: the body's X {axes[0]}, Y {axes[1]}, Z {axes[2]}, and the last row of any 4x4 "
            "matrix. The first three columns of the first three rows are the 3x3 rotation."
        ),
    ]
