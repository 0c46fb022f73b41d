"""The sections on the boresight, and on its values for other programs.

The first has the fit, other estimated values, observability, displacements and the error budget.
"""

from lispac.adjustment.model.parameters import CRITICAL_TEST_VALUE
from lispac.adjustment.result import ANGLES
from lispac.language import gettext, gettext_lazy
from lispac.message_texts import message_text
from lispac.present.angles import CORRELATIONS_TABLE, correlation_rows
from lispac.present.calibration.adjustment import (
    SIGMAS_WITHOUT_LINE_TABLE,
    AdjustmentValues,
    ObservabilityValues,
    sigma_without_line_rows,
)
from lispac.present.calibration.adjustment_fit import FIT_TITLE, fit_facts
from lispac.present.calibration.displacement import DISPLACEMENTS_TABLE
from lispac.present.calibration.error_budget import ErrorBudgetValues, budget_table
from lispac.present.calibration.parameters import PARAMETERS_TABLE
from lispac.present.calibration.sigmas import sigma_facts
from lispac.present.output.conventions import (
    ConventionValues,
    ScannerToBodyMatrix,
    angles_table,
    convention_facts,
    matrix_table,
)
from lispac.present.text_format import (
    format_known,
    grouped_number,
    sentence_text,
    shortest_number,
)
from lispac.report.document_blocks import (
    Block,
    Bullets,
    Paragraph,
    UndrawnPictures,
    facts_table,
    report_table,
)
from lispac.report.report_values import ReportContent
from lispac.report.section_summaries import precision_summary


def boresight_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the estimated values and their fit."""
    adjustment = content.adjustment
    if adjustment is None:
        missing = Paragraph(gettext("No boresight has been estimated yet."))
        return [missing, convention_paragraph(content)]
    # The variance factor and its test depend on the LiDAR noise used.
    used = content.settings
    lidar, *_ = sigma_facts(used.standard_deviations, used.lever_arm_sigma_m, adjustment.sightings)
    blocks: list[Block] = [
        *precision_summary(adjustment),
        convention_paragraph(content),
        facts_table(gettext(FIT_TITLE), [*fit_facts(adjustment), lidar]),
    ]
    if adjustment.parameters:
        blocks += _parameter_blocks(adjustment)
    blocks += _correlation_blocks(adjustment)
    if adjustment.observability is not None:
        blocks += _observability_blocks(adjustment, adjustment.observability)
    blocks.append(report_table(DISPLACEMENTS_TABLE, adjustment.effects))
    if content.budget is not None:
        blocks += budget_blocks(content.budget)
    return blocks


def convention_paragraph(content: ReportContent) -> Paragraph:
    """Description of the convention of the angles."""
    # The formula may be broken between its factors only
    convention = gettext(content.settings.convention).replace(" = ", "\u00a0=\u00a0")
    return Paragraph(convention.replace("·", "·\u200b"))


def _parameter_blocks(adjustment: AdjustmentValues) -> list[Block]:
    blocks: list[Block] = [report_table(PARAMETERS_TABLE, adjustment.parameters)]
    reasons = tuple(sentence_text(p.reason) for p in adjustment.parameters if p.reason)
    if reasons:
        blocks.append(Bullets(reasons))
    if any(p.value is not None for p in adjustment.parameters):
        blocks.append(
            Paragraph(
                gettext(
                    "A change is significant if it exceeds {limit} times its sigma; by chance, "
                    "this happens once in twenty cases. The boresight of this report is valid "
                    "only together with the estimated parameters, not with the prior ones.",
                    limit=shortest_number(CRITICAL_TEST_VALUE),
                )
            )
        )
    return blocks


def _correlation_blocks(adjustment: AdjustmentValues) -> list[Block]:
    blocks: list[Block] = [
        report_table(CORRELATIONS_TABLE, correlation_rows(adjustment.correlation))
    ]
    if len(adjustment.estimated) > len(ANGLES):
        from lispac.report.figures import correlation_figure_of

        caption = gettext("Correlations of all estimated parameters.")
        values = (adjustment.estimated, adjustment.correlation_all)
        blocks.append(UndrawnPictures(caption, correlation_figure_of, values, width=0.55))
    return blocks


def _observability_blocks(
    adjustment: AdjustmentValues, observability: ObservabilityValues
) -> list[Block]:
    condition = gettext(
        "Condition number of the normal matrix of the angles: {number} (1 means that all "
        "combinations of the angles have the same sigma).",
        number=format_known(observability.condition, lambda v: grouped_number(v, 1)),
    )
    blocks: list[Block] = [
        Paragraph(gettext("Observability of the angles on these lines:")),
        Bullets((*map(sentence_text, observability.messages), condition)),
    ]
    if observability.sigma_without_line_deg:
        blocks.append(report_table(SIGMAS_WITHOUT_LINE_TABLE, sigma_without_line_rows(adjustment)))
    return blocks


def budget_blocks(budget: ErrorBudgetValues) -> list[Block]:
    """A table for each direction of the beam, and the assumptions."""
    return [
        *(report_table(*budget_table(budget, beam)) for beam in budget.beams),
        Paragraph(gettext("Assumptions of the error budget:")),
        Bullets(tuple(map(message_text, budget.messages))),
    ]


def convention_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the boresight and lever arm in the conventions of other programs."""
    blocks: list[Block] = []
    if content.in_convention is not None:
        blocks += rule_tables(content.in_convention)  # the angles are on the first page
    if content.matrix is not None:
        blocks += _matrix_tables(content.matrix)
    return blocks


def angle_tables(convention: ConventionValues) -> list[Block]:
    """Table of the boresight in the convention of one program; none if it uses a matrix."""
    if not convention.angles:
        return []
    # Some names of programs contain translated words.
    title = gettext_lazy(
        "Boresight for {program}: convention {status}",
        program=gettext(convention.name), status=convention.status_text,
    )  # fmt: skip
    return [report_table(angles_table(convention, title), convention.angles)]


def rule_tables(convention: ConventionValues) -> list[Block]:
    """Table of the rules and of the lever arm of one program, and its notes."""
    program = gettext(convention.name)
    rules = facts_table(
        gettext("Convention of {program}", program=program), convention_facts(convention)
    )
    return [rules, *(Paragraph(sentence_text(each)) for each in convention.notes)]


def _matrix_tables(matrix: ScannerToBodyMatrix) -> list[Block]:
    x, y, z = matrix.body_axes
    return [
        Paragraph(
            gettext(
                "Rows 1 to 3: body axes X {x}, Y {y}, Z {z}. Row 4: constant last row of a 4x4 "
                "transformation matrix. The first three rows and columns are the 3x3 rotation.",
                x=x, y=y, z=z,
            )
        ),
        report_table(matrix_table(matrix.name), matrix.transform),
    ]  # fmt: skip
