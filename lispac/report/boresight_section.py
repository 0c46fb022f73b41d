"""The section on the boresight: fit, other estimated values, observability, displacements."""

from lispac.adjustment.parameters import SIGNIFICANT
from lispac.language import N_, Plural, gettext
from lispac.report.blocks import Block, Bullets, Column, Drawing, Paragraph, Table, facts, rows
from lispac.report.budget_section import budget_blocks
from lispac.report.values import Adjustment, ExtraParameter, ObservabilityValues, ReportContent
from lispac.report.wording import (
    UNKNOWN,
    cm,
    degrees_unit,
    fixed,
    grouped,
    in_unit,
    known,
    quantity,
    sentence,
    shortest,
    signed,
    title,
)

VARIANCE_FACTOR = N_("{factor}, computed with the given sigmas")
VARIANCE_FACTOR_COMPONENTS = N_(
    "{factor}, computed with the given sigmas multiplied by the applied variance components"
)
VARIANCE_FACTOR_BEFORE_NOISE = N_(
    "{factor}, computed with the given sigmas, without the LiDAR noise estimated from the residuals"
)
VARIANCE_FACTOR_COMPONENTS_BEFORE_NOISE = N_(
    "{factor}, computed with the given sigmas multiplied by the applied variance components, "
    "without the LiDAR noise estimated from the residuals"
)
OUTLIERS_LEFT_OUT = Plural(
    "{points:n}; {count:n} outlier excluded from the averages",
    "{points:n}; {count:n} outliers excluded from the averages",
)


def boresight(content: ReportContent) -> list[Block]:
    """Estimated values and their fit."""
    adjustment = content.adjustment
    if adjustment is None:
        return [Paragraph(gettext("No boresight has been estimated yet."))]
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
    statistic = grouped(test.statistic, 1)
    if test.lower is None or test.upper is None:
        statistic = gettext("statistic {statistic}", statistic=statistic)
    else:
        statistic = gettext(
            "statistic {statistic}, bounds {lower} to {upper}",
            statistic=statistic, lower=grouped(test.lower, 1), upper=grouped(test.upper, 1),
        )  # fmt: skip
    return facts(
        gettext("Fit of the adjustment"),
        [
            (gettext("Points"), _points(adjustment)),
            (gettext("Iterations"), fixed(adjustment.iterations, 0)),
            (gettext("Degrees of freedom"), grouped(adjustment.degrees_of_freedom)),
            (gettext("Variance factor"), _variance_factor(content, adjustment)),
            (gettext("Chi-square test at 95 %"), statistic),
            ("", gettext(test.in_words)),
            (
                gettext("RMS before calibration"),
                gettext("{rms:mm.1} mm", rms=adjustment.rms_before_m),
            ),
            (
                gettext("RMS after calibration"),
                gettext("{rms:mm.1} mm; POS errors not removed", rms=adjustment.rms_after_m),
            ),
            (gettext("Model of the POS errors"), gettext(content.settings.pos_errors_in_words)),
        ],
    )


def _variance_factor(content: ReportContent, adjustment: Adjustment) -> str:
    if adjustment.variance_factor is None:
        return UNKNOWN
    applied = any(component.applied for component in adjustment.components)
    if content.settings.pos_errors == "correlated":
        template = (
            VARIANCE_FACTOR_COMPONENTS_BEFORE_NOISE if applied else VARIANCE_FACTOR_BEFORE_NOISE
        )
    else:
        template = VARIANCE_FACTOR_COMPONENTS if applied else VARIANCE_FACTOR
    return gettext(template, factor=fixed(adjustment.variance_factor, 4))


def _parameters(adjustment: Adjustment) -> list[Block]:
    table = Table(
        gettext("Parameters estimated together with the boresight"),
        (
            Column(gettext("Value"), "left"),
            Column(gettext("Prior")),
            Column(gettext("Prior\n1 sigma")),
            Column(gettext("Estimated")),
            Column(gettext("1 sigma")),
            Column(gettext("Change /\nsigma")),
            Column(gettext("Finding"), "left"),
        ),
        rows(_parameter_row(p) for p in adjustment.parameters),
    )
    blocks: list[Block] = [table]
    reasons = tuple(sentence(p.reason) for p in adjustment.parameters if p.reason)
    if reasons:
        blocks.append(Bullets(reasons))
    if any(p.value is not None for p in adjustment.parameters):
        blocks.append(
            Paragraph(
                gettext(
                    "A change is significant if it exceeds {limit} times its sigma; by chance, "
                    "this happens once in twenty cases. The boresight of this report is valid "
                    "only together with the estimated parameters, not with the prior ones.",
                    limit=shortest(SIGNIFICANT),
                )
            )
        )
    return blocks


def _parameter_row(found: ExtraParameter) -> list[str]:
    def shown(value: float | None, *, sign: bool) -> str:
        return known(value, lambda v: quantity(found.name, v, sign=sign))

    no_prior = found.prior_sigma is None
    return [
        title(found.name),
        shown(found.prior, sign=True),
        gettext("not given") if no_prior else shown(found.prior_sigma, sign=False),
        shown(found.value, sign=True),
        shown(found.sigma, sign=False),
        known(found.significance, lambda v: signed(v, 1)),
        _finding(found),
    ]


def _finding(found: ExtraParameter) -> str:
    if found.significant is not None:
        return gettext("significant") if found.significant else gettext("not significant")
    if found.value is not None:
        return gettext("not tested (uncorrelated POS errors)")
    if found.prior_sigma is None:
        return gettext("not estimated, given value used")
    return gettext("not determined")


def _correlations(content: ReportContent, adjustment: Adjustment) -> list[Block]:
    names = [title(angle.name) for angle in content.angles]
    blocks: list[Block] = [
        Table(
            gettext("Correlations"),
            (Column("", "left"), *map(Column, names)),
            rows(
                [name, *(signed(value, 3) for value in row)]
                for name, row in zip(names, adjustment.correlation, strict=True)
            ),
        )
    ]
    if len(adjustment.estimated) > len(names):
        from lispac.report.figures import correlation_figure_of

        caption = gettext("Correlations of all estimated parameters.")
        values = (adjustment.estimated, adjustment.correlation_all)
        blocks.append(Drawing(caption, correlation_figure_of, values, width=0.55))
    return blocks


def _observability(content: ReportContent, found: ObservabilityValues) -> list[Block]:
    condition = gettext(
        "Condition number of the normal matrix of the angles: {number} (1 means that all "
        "combinations of the angles have the same sigma).",
        number=known(found.condition, lambda v: grouped(v, 1)),
    )
    blocks: list[Block] = [
        Paragraph(gettext("Observability of the angles on these lines:")),
        Bullets((*map(sentence, found.in_words), condition)),
    ]
    if found.sigma_without_line_deg:
        deg = degrees_unit()
        columns = (
            Column("", "left"),
            *(Column(in_unit(title(angle.name), deg)) for angle in content.angles),
        )
        all_lines = [known(angle.sigma_deg, lambda v: fixed(v, 4)) for angle in content.angles]
        without = [
            [
                gettext("Without line {name}", name=line),
                *([UNKNOWN] * 3 if sigma is None else [fixed(v, 4) for v in sigma]),
            ]
            for line, sigma in found.sigma_without_line_deg.items()
        ]
        cells = rows([[gettext("All lines"), *all_lines], *without])
        blocks.append(Table(gettext("1 sigma of the angles with one line omitted"), columns, cells))
    return blocks


def _effects(adjustment: Adjustment) -> Table:
    return Table(
        gettext("Displacement of a point caused by a boresight error of 1 sigma (cm)"),
        (
            Column(gettext("Angle"), "left"),
            *(
                Column(gettext("at {distance:m.0} m", distance=distance))
                for distance in adjustment.effect_distances_m
            ),
        ),
        rows([_effect_name(e.angle), *map(cm, e.displacement_m)] for e in adjustment.effects),
    )


def _points(adjustment: Adjustment) -> str:
    if not adjustment.left_out:
        return grouped(adjustment.points)
    return gettext(OUTLIERS_LEFT_OUT, points=adjustment.points, count=adjustment.left_out)


def _effect_name(angle: str) -> str:
    if angle == "worst direction":
        return gettext("All three angles together, worst case")
    return title(angle)
