"""The section on other programs: the boresight in their convention, and as a matrix."""

from collections.abc import Mapping

from lispac.language import N_, capitalised, gettext
from lispac.message_texts import message_text
from lispac.present.conventions import ConventionValues, ScannerToBodyMatrix
from lispac.present.text_format import (
    MINUS_SIGN,
    degrees_unit,
    fixed_number,
    format_known,
    signed_number,
    title_with_unit,
)
from lispac.report.document_blocks import Block, Column, Paragraph, Table, as_rows, facts_table
from lispac.report.report_values import ReportContent

ROTATION_TEXTS: Mapping[str, str] = {
    "LiDAR to body": N_("{formula}, LiDAR to body"),
    "body to LiDAR": N_("{formula}, body to LiDAR"),
}
PRECISE_DECIMALS = 8
"""Decimals of angles in degrees if they change much with a small rotation (steep pitch)."""


def convention_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the boresight and lever arm in the conventions of other programs."""
    blocks: list[Block] = []
    if content.in_convention is not None:
        blocks += _convention_tables(content.in_convention)
    if content.matrix is not None:
        blocks += _matrix_tables(content.matrix)
    return blocks


def _convention_tables(convention: ConventionValues) -> list[Block]:
    blocks: list[Block] = [_angle_table(convention)] if convention.angles else []
    x, y, z = (signed_number(value, 4) for value in convention.lever_arm_m)
    axes = convention.body_axes
    source = gettext(
        "{status}; source: {source}", status=convention.status_text, source=convention.source
    )
    lever_arm = gettext(
        "X {x} m, Y {y} m, Z {z} m, from the POS centre to the LiDAR optical centre", x=x, y=y, z=z
    )
    values = [
        (gettext("Verification of the convention"), source),
        *(
            [(gettext("Assumption"), str(convention.assumption))]
            if convention.assumption is not None
            else []
        ),
        (gettext("Rotation"), _rotation_text(convention)),
        (
            gettext("Body axes"),
            gettext("X {x}, Y {y}, Z {z}", x=axes[0], y=axes[1], z=axes[2]),
        ),
        (gettext("Scanner axes"), str(convention.scanner_text)),
        (gettext("Lever arm"), lever_arm),
    ]
    blocks.append(
        facts_table(
            gettext("Convention of {program}", program=_program_name(convention.name)), values
        )
    )
    notes = (
        convention.check_first,
        convention.note,
        convention.offsets_text,
        convention.warning,
    )
    blocks += [
        Paragraph(message_text(each).replace(" -", f" {MINUS_SIGN}"))
        for each in notes
        if each is not None
    ]
    return blocks


def _angle_table(convention: ConventionValues) -> Table:
    decimals = 4 if convention.note is None else PRECISE_DECIMALS
    deg = degrees_unit()
    return Table(
        gettext(
            "Boresight for {program}: convention {status}",
            program=_program_name(convention.name), status=convention.status_text,
        ),
        (
            Column(gettext("Angle"), "left"),
            Column(title_with_unit(gettext("Value"), deg)),
            Column(title_with_unit(gettext("1 sigma"), deg)),
            Column(gettext("Sign"), "left", wide=True),
        ),
        as_rows(
            [
                capitalised(str(angle.name)),
                signed_number(angle.value_deg, decimals),
                format_known(angle.sigma_deg, lambda v: fixed_number(v, 4)),
                str(angle.meaning),
            ]
            for angle in convention.angles
        ),
    )  # fmt: skip


def _program_name(name: str) -> str:
    """Name of a program in the language in use; some names contain translated words."""
    return gettext(name)


def _rotation_text(convention: ConventionValues) -> str:
    if not convention.angles:
        return gettext("this program imports a matrix, not angles")
    return gettext(
        ROTATION_TEXTS[convention.direction_text],
        formula=str(convention.formula).replace("-", MINUS_SIGN),
    )


def _matrix_tables(matrix: ScannerToBodyMatrix) -> list[Block]:
    axes = matrix.body_axes
    return [
        Table(
            gettext(
                "Matrix from scanner to body for {program}", program=_program_name(matrix.name)
            ),
            (
                Column(gettext("Scanner X")),
                Column(gettext("Scanner Y")),
                Column(gettext("Scanner Z")),
                Column(gettext("Lever arm (m)")),
            ),
            as_rows([fixed_number(value, 10) for value in row] for row in matrix.transform),
        ),
        Paragraph(
            gettext(
                "Rows 1 to 3: body axes X {x}, Y {y}, Z {z}. Row 4: constant last row of a 4x4 "
                "transformation matrix. The first three rows and columns are the 3x3 rotation.",
                x=axes[0], y=axes[1], z=axes[2],
            )
        ),
    ]  # fmt: skip
