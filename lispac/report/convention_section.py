"""The section on other programs: the boresight in their convention, and as a matrix."""

from lispac.language import gettext, gettext_lazy
from lispac.present.conventions import (
    ConventionValues,
    ScannerToBodyMatrix,
    angles_table,
    convention_facts,
    matrix_table,
)
from lispac.present.text_format import sentence_text
from lispac.report.document_blocks import Block, Paragraph, facts_table, report_table
from lispac.report.report_values import ReportContent


def convention_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the boresight and lever arm in the conventions of other programs."""
    blocks: list[Block] = []
    if content.in_convention is not None:
        blocks += _convention_tables(content.in_convention)
    if content.matrix is not None:
        blocks += _matrix_tables(content.matrix)
    return blocks


def _convention_tables(convention: ConventionValues) -> list[Block]:
    # Some names of programs contain translated words.
    program = gettext(convention.name)
    blocks: list[Block] = []
    if convention.angles:
        title = gettext_lazy(
            "Boresight for {program}: convention {status}",
            program=program, status=convention.status_text,
        )  # fmt: skip
        blocks.append(report_table(angles_table(convention, title), convention.angles))
    blocks.append(
        facts_table(
            gettext("Convention of {program}", program=program), convention_facts(convention)
        )
    )
    return [*blocks, *(Paragraph(sentence_text(each)) for each in convention.notes)]


def _matrix_tables(matrix: ScannerToBodyMatrix) -> list[Block]:
    x, y, z = matrix.body_axes
    return [
        report_table(matrix_table(matrix.name), matrix.transform),
        Paragraph(
            gettext(
                "Rows 1 to 3: body axes X {x}, Y {y}, Z {z}. Row 4: constant last row of a 4x4 "
                "transformation matrix. The first three rows and columns are the 3x3 rotation.",
                x=x, y=y, z=z,
            )
        ),
    ]  # fmt: skip
