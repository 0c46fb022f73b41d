"""Parameters estimated with the boresight, and variance components, as values and tables."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

from lispac.adjustment.diagnostics.findings import variance_component_finding
from lispac.adjustment.model.parameters import (
    CRITICAL_TEST_VALUE,
    OUTPUT_UNITS,
    PARAMETER_DISPLAYS,
    ParameterEstimate,
)
from lispac.adjustment.result import (
    ANGLES,
    AdjustmentResult,
)
from lispac.language import N_, gettext, gettext_lazy
from lispac.messages import Message
from lispac.present.angles import degrees, finite_or_none
from lispac.present.tables import (
    DEGREES,
    Column,
    Format,
    Table,
    ratio,
)
from lispac.present.text_format import VALUE_TITLES


@dataclass(frozen=True)
class ParameterValues:
    """An estimated value of the mounting, or the reason why it was not estimated.

    ``prior``, ``prior_sigma``, ``value`` and ``sigma`` are in the unit of ``unit``.
    ``significance`` is the change from the prior divided by its standard deviation;
    ``significant``: whether the change is significant at 95 %.
    """

    name: str
    unit: str
    prior: float
    prior_sigma: float | None
    value: float | None
    sigma: float | None
    significance: float | None
    significant: bool | None
    reason: Message | Literal[""]


def parameter_values(result: AdjustmentResult) -> tuple[ParameterValues, ...]:
    """Parameters that were selected for estimation besides the boresight."""
    return tuple(_parameter_values(each) for each in result.parameters)


def _parameter_values(estimate: ParameterEstimate) -> ParameterValues:
    factor, unit = OUTPUT_UNITS[estimate.name]

    def in_unit(value: float | None) -> float | None:
        return None if value is None else factor * value

    significance = estimate.significance
    return ParameterValues(
        name=estimate.name,
        unit=unit,
        prior=factor * estimate.prior,
        prior_sigma=in_unit(estimate.prior_sigma),
        value=in_unit(estimate.value),
        sigma=in_unit(estimate.sigma),
        significance=None if significance is None else finite_or_none(significance),
        significant=estimate.significant,
        reason=estimate.reason or "",
    )


def angle_parameters(result: AdjustmentResult) -> tuple[ParameterValues, ...]:
    """The boresight angles as further rows of the table of parameters."""
    return tuple(
        ParameterValues(name, "deg", prior, None, value, sigma, (value - prior) / sigma, None, "")
        for name, prior, value, sigma in zip(
            ANGLES, degrees(result.prior_angles), degrees(result.angles), degrees(result.sigma),
            strict=True,
        )
    )  # fmt: skip


def significance_text(parameter: ParameterValues) -> str:
    """Text on whether a parameter was determined and differs significantly from its prior."""
    if parameter.name in ANGLES:
        return gettext("always estimated")
    if parameter.significant is not None:
        return gettext("significant") if parameter.significant else gettext("not significant")
    if parameter.value is not None:
        return gettext("not tested (uncorrelated POS errors)")
    if parameter.prior_sigma is None:
        return gettext("not estimated, given value used")
    return gettext("not determined")


def parameter_format(name: str) -> Format:
    """Format of a value of the mounting in metres, radians or seconds."""
    shown = PARAMETER_DISPLAYS[name]
    return Format(shown.unit, shown.decimals, shown.factor)


def _parameter_format(parameter: ParameterValues) -> Format:
    if parameter.name in ANGLES:
        return DEGREES
    form, (stored, _) = parameter_format(parameter.name), OUTPUT_UNITS[parameter.name]
    return replace(form, factor=form.factor / stored)


def _signed_parameter_format(parameter: ParameterValues) -> Format:
    return _parameter_format(parameter).signed


PARAMETERS_TABLE = Table[ParameterValues](
    N_("Parameters estimated together with the boresight"),
    (
        Column(
            "name", N_("Parameter"), texts=VALUE_TITLES,
            tip=N_("Estimated parameter of the mounting"),
        ),
        Column(
            "prior", N_("Prior"), _signed_parameter_format, N_("Value before the adjustment"),
            has_unit_in_cells=True,
        ),
        Column(
            "prior_sigma", N_("Prior\n1 sigma"), _parameter_format,
            N_("Standard deviation of the prior"), has_unit_in_cells=True, unknown=N_("not given"),
        ),
        Column(
            "value", N_("Estimated"), _signed_parameter_format, N_("Estimated value"),
            has_unit_in_cells=True,
        ),
        Column(
            "sigma", N_("1 sigma"), _parameter_format,
            N_("Standard deviation of the estimated value"), has_unit_in_cells=True,
        ),
        Column(
            "significance", N_("Change /\nsigma"), ratio(1).signed,
            gettext_lazy(
                "Change from the prior divided by its standard deviation. Beyond {limit:x.2} it is "
                "significant at the 5 % level.",
                limit=CRITICAL_TEST_VALUE,
            ),
        ),
        Column(significance_text, N_("Finding"), tip=N_("Significance of the parameter")),
    ),
)  # fmt: skip

WINDOW_PARAMETERS_TABLE = replace(
    PARAMETERS_TABLE,
    columns=(
        *PARAMETERS_TABLE.columns, Column("reason", N_("Reason"), tip=N_("Why there is no value")),
    ),
)  # fmt: skip
"""Table of the window, with a column of reasons, which the report lists below its table."""

COMPONENT_TITLES: Mapping[str, str] = {
    "LiDAR": N_("LiDAR"),
    "POS position": N_("POS position"),
    "POS attitude": N_("POS attitude"),
}


@dataclass(frozen=True)
class VarianceComponentValues:
    """Variance component of a group of errors, with its 95 % interval.

    ``factor`` is the ratio of the estimated to the given or assumed sigma; ``applied`` is True if
    this sigma was multiplied by it in the adjustment.
    """

    name: str
    factor: float
    lower: float
    upper: float
    applied: bool
    text: Message


def component_values(result: AdjustmentResult) -> tuple[VarianceComponentValues, ...]:
    """Variance components of the groups of errors."""
    return tuple(
        VarianceComponentValues(
            c.name,
            c.factor,
            c.lower,
            c.upper,
            c.applied,
            variance_component_finding(c, is_assumed=c.name in result.assumed_sigmas),
        )
        for c in result.components
    )


def interval_text(component: VarianceComponentValues) -> str:
    """95 % interval of a variance component in the language in use."""
    return gettext(
        "{lower} to {upper}",
        lower=ratio(2).text(component.lower),
        upper=ratio(2).text(component.upper),
    )


VARIANCE_COMPONENTS_TABLE = Table[VarianceComponentValues](
    N_("Variance components: ratio of estimated to given or assumed sigmas"),
    (
        Column("name", N_("Source"), texts=COMPONENT_TITLES),
        Column("factor", N_("Factor"), ratio(2)),
        Column(interval_text, N_("95 % interval")),
        Column("text", N_("Finding")),
    ),
)
