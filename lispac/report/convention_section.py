"""The section on other programs: the boresight in their convention, and as a matrix."""

from collections.abc import Mapping

from lispac.adjustment.shown import capitalised
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.report.blocks import Block, Column, Paragraph, Table, facts, rows
from lispac.report.convention_values import InConvention, ScannerToBody
from lispac.report.values import ReportContent
from lispac.report.wording import MINUS, degrees_unit, fixed, in_unit, known, signed

DIRECTIONS: Mapping[str, str] = {
    "LiDAR to body": N_("{formula}, LiDAR to body"),
    "body to LiDAR": N_("{formula}, body to LiDAR"),
}
EXACT = 8
"""Decimals of angles that change much for a small rotation."""


def other_programs(content: ReportContent) -> list[Block]:
    """Boresight and lever arm as other programs take them."""
    blocks: list[Block] = []
    if content.in_convention is not None:
        blocks += _convention(content.in_convention)
    if content.matrix is not None:
        blocks += _matrix(content.matrix)
    return blocks


def _convention(found: InConvention) -> list[Block]:
    blocks: list[Block] = [_angles(found)] if found.angles else []
    x, y, z = (signed(value, 4) for value in found.lever_arm_m)
    axes = found.body_axes
    source = gettext(
        "{status}; source: {source}", status=found.status_in_words, source=found.source
    )
    lever_arm = gettext(
        "X {x} m, Y {y} m, Z {z} m, from the POS centre to the LiDAR optical centre", x=x, y=y, z=z
    )
    values = [
        (gettext("Verification"), source),
        *([(gettext("Assumption"), str(found.assumption))] if found.assumption is not None else []),
        (gettext("Rotation"), _rotation(found)),
        (
            gettext("Body axes"),
            gettext("X {x}, Y {y}, Z {z}", x=axes[0], y=axes[1], z=axes[2]),
        ),
        (gettext("Scanner axes"), str(found.scanner_in_words)),
        (gettext("Lever arm"), lever_arm),
    ]
    blocks.append(facts(gettext("Convention of {program}", program=_program(found.name)), values))
    notes = (found.check_first, found.note, found.offsets_in_words, found.caution)
    blocks += [
        Paragraph(message_text(each).replace(" -", f" {MINUS}"))
        for each in notes
        if each is not None
    ]
    return blocks


def _angles(found: InConvention) -> Table:
    decimals = 4 if found.note is None else EXACT
    deg = degrees_unit()
    return Table(
        gettext(
            "Boresight for {program}: convention {status}",
            program=_program(found.name), status=found.status_in_words,
        ),
        (
            Column(gettext("Angle"), "left"),
            Column(in_unit(gettext("Value"), deg)),
            Column(in_unit(gettext("1 sigma"), deg)),
            Column(gettext("Sign"), "left", wide=True),
        ),
        rows(
            [
                capitalised(str(angle.name)),
                signed(angle.value_deg, decimals),
                known(angle.sigma_deg, lambda v: fixed(v, 4)),
                str(angle.meaning),
            ]
            for angle in found.angles
        ),
    )  # fmt: skip


def _program(name: str) -> str:
    """Name of a program: some of them have words to translate."""
    return gettext(name)


def _rotation(found: InConvention) -> str:
    if not found.angles:
        return gettext("this program imports a matrix, not angles")
    return gettext(
        DIRECTIONS[found.direction_in_words], formula=str(found.formula).replace("-", MINUS)
    )


def _matrix(found: ScannerToBody) -> list[Block]:
    axes = found.body_axes
    return [
        Table(
            gettext("Matrix from scanner to body for {program}", program=_program(found.name)),
            (
                Column(gettext("Scanner X")),
                Column(gettext("Scanner Y")),
                Column(gettext("Scanner Z")),
                Column(gettext("Lever arm (m)")),
            ),
            rows([fixed(value, 10) for value in row] for row in found.transform),
        ),
        Paragraph(
            gettext(
                "Rows 1 to 3: body axes X {x}, Y {y}, Z {z}. Row 4: constant last row of a 4x4 "
                "transformation matrix. The first three rows and columns are the 3x3 rotation.",
                x=axes[0], y=axes[1], z=axes[2],
            )
        ),
    ]  # fmt: skip
