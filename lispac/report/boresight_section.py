"""The section on the boresight: its fit, what was estimated with it, and what the lines see."""

from lispac.adjustment.parameters import SIGNIFICANT
from lispac.report.blocks import Block, Bullets, Column, Drawing, Paragraph, Table, facts, rows
from lispac.report.budget_section import budget_blocks
from lispac.report.values import Adjustment, ExtraParameter, ReportContent, Seen
from lispac.report.wording import (
    UNKNOWN,
    count,
    known,
    mm,
    parameter,
    quantity,
    signed,
    title,
)


def boresight(content: ReportContent) -> list[Block]:
    """What was estimated, and how well it fits."""
    adjustment = content.adjustment
    if adjustment is None:
        return [Paragraph("No boresight has been estimated yet.")]
    blocks: list[Block] = [_fit(content, adjustment)]
    if adjustment.parameters:
        blocks += _parameters(adjustment)
    blocks += _correlations(content, adjustment)
    if adjustment.observability is not None:
        blocks += _observability(content, adjustment.observability)
    blocks.append(_effects(adjustment))
    if content.budget is not None:
        blocks += budget_blocks(content.budget)
    return blocks


def _fit(content: ReportContent, adjustment: Adjustment) -> Table:
    test = adjustment.chi_square
    bounds = (
        f", bounds {test.lower:,.1f} to {test.upper:,.1f}"
        if test.lower is not None and test.upper is not None
        else ""
    )
    stated = "from the stated sigmas"
    if any(component.applied for component in adjustment.components):
        stated += " times the variance components applied"
    if content.settings.pos_errors == "correlated":
        stated += ", before any noise was taken from the residuals"
    return facts(
        "Fit",
        [
            ("Points", _points(adjustment)),
            ("Iterations", str(adjustment.iterations)),
            ("Degrees of freedom", f"{adjustment.degrees_of_freedom:,}"),
            ("Variance factor", known(adjustment.variance_factor, lambda v: f"{v:.4f}, {stated}")),
            ("Chi-square test at 95 %", f"statistic {test.statistic:,.1f}{bounds}"),
            ("", test.in_words),
            ("RMS before", f"{mm(adjustment.rms_before_m)} mm"),
            ("RMS after", f"{mm(adjustment.rms_after_m)} mm; POS errors not removed"),
            ("Model of the POS errors", content.settings.pos_errors_in_words),
        ],
    )


def _parameters(adjustment: Adjustment) -> list[Block]:
    table = Table(
        "Estimated besides the boresight",
        (
            Column("Value", "left"),
            Column("Prior"),
            Column("Prior\n1 sigma"),
            Column("Estimated"),
            Column("1 sigma"),
            Column("Change over\nits sigma"),
            Column("Finding", "left"),
        ),
        rows(_parameter_row(p) for p in adjustment.parameters),
    )
    blocks: list[Block] = [table]
    reasons = tuple(p.reason for p in adjustment.parameters if p.reason)
    if reasons:
        blocks.append(Bullets(reasons))
    if any(p.value is not None for p in adjustment.parameters):
        blocks.append(
            Paragraph(
                f"A change earns its place where it exceeds {SIGNIFICANT} of its sigmas, which "
                "chance does one time in twenty. The boresight of this report goes with the "
                "estimated values; with the prior ones it would be another."
            )
        )
    return blocks


def _parameter_row(found: ExtraParameter) -> list[str]:
    def shown(value: float | None, *, sign: bool) -> str:
        return known(value, lambda v: quantity(found.name, v, sign=sign))

    finding = "held" if found.prior_sigma is None else "not seen"
    if found.value is not None and found.significant is None:
        finding = "not tested (uncorrelated POS errors)"
    elif found.significant is not None:
        finding = "significant" if found.significant else "not significant"
    return [
        title(parameter(found.name)),
        shown(found.prior, sign=True),
        "not stated" if found.prior_sigma is None else shown(found.prior_sigma, sign=False),
        shown(found.value, sign=True),
        shown(found.sigma, sign=False),
        known(found.significance, lambda v: signed(v, 1)),
        finding,
    ]


def _correlations(content: ReportContent, adjustment: Adjustment) -> list[Block]:
    names = [angle.name for angle in content.angles]
    blocks: list[Block] = [
        Table(
            "Correlations",
            (Column("", "left"), *(Column(name.capitalize()) for name in names)),
            rows(
                [name.capitalize(), *(signed(value, 3) for value in row)]
                for name, row in zip(names, adjustment.correlation, strict=True)
            ),
        )
    ]
    if len(adjustment.estimated) > len(names):
        from lispac.report.figures import correlation_figure_of

        caption = "Correlations of all estimated values."
        values = (adjustment.estimated, adjustment.correlation_all)
        blocks.append(Drawing(caption, correlation_figure_of, values, width=0.55))
    return blocks


def _observability(content: ReportContent, found: Seen) -> list[Block]:
    blocks: list[Block] = [
        Paragraph("What the lines see:"),
        Bullets(
            (
                *found.in_words,
                "Condition number of the angles' normal matrix: "
                f"{known(found.condition, lambda v: f'{v:,.1f}')} (1 would mean that all "
                "directions are known alike).",
            )
        ),
    ]
    if found.sigma_without_line_deg:
        columns = (
            Column("", "left"),
            *(Column(f"{angle.name.capitalize()}\n(deg)") for angle in content.angles),
        )
        all_lines = [known(angle.sigma_deg, lambda v: f"{v:.4f}") for angle in content.angles]
        without = [
            [f"Without {line}", *([UNKNOWN] * 3 if sigma is None else [f"{v:.4f}" for v in sigma])]
            for line, sigma in found.sigma_without_line_deg.items()
        ]
        head = "1 sigma of the angles with one line omitted"
        blocks.append(Table(head, columns, rows([["All lines", *all_lines], *without])))
    return blocks


def _effects(adjustment: Adjustment) -> Table:
    return Table(
        "Displacement of a point by 1 sigma of the boresight (cm)",
        (
            Column("Angle", "left"),
            *(Column(f"at {distance:.0f} m") for distance in adjustment.effect_distances_m),
        ),
        rows(
            [_effect_name(e.angle), *(f"{100 * value:.2f}" for value in e.displacement_m)]
            for e in adjustment.effects
        ),
    )


def _points(adjustment: Adjustment) -> str:
    if not adjustment.left_out:
        return f"{adjustment.points:,}"
    out = count(adjustment.left_out, "stray point")
    return f"{adjustment.points:,}; {out} stood out from the surface and were kept out of averages"


def _effect_name(angle: str) -> str:
    together = "All three together, in the direction where they show most"
    return together if angle == "worst direction" else angle.capitalize()
