"""Fit of an adjustment: numbers of points and iterations, variance factor, RMS distances."""

from lispac.language import N_, Plural, gettext
from lispac.present.calibration.adjustment import AdjustmentValues
from lispac.present.calibration.parameters import COMPONENT_TITLES
from lispac.present.tables import Fact, Format, ratio
from lispac.present.text_format import grouped_number

VARIANCE_FACTOR_FORMAT, TEST_STATISTIC_FORMAT = ratio(4), Format("", 1)
"""Formats of the variance factor, and of the statistic of its test with its bounds."""
FIT_TITLE = N_("Fit of the adjustment")
VARIANCE_FACTOR_TEXT = N_(
    "{factor} = a posteriori variance / a priori variance (that of the LiDAR and POS sigmas used)"
)
ESTIMATED_VARIANCE_FACTOR_TEXT = N_(
    "{factor} = a posteriori variance / a priori variance (estimated sigmas: {groups:names})"
)
AVERAGED_POINTS_TEXT = N_("{points:n}, averaged from {picked:n} points of the targets")
THINNED_POINTS_TEXT = N_("{points:n}, thinned from {picked:n} points of the targets")
EXCLUDED_OUTLIERS_TEXT = Plural(
    "{points}; {count:n} outlier excluded from the averages",
    "{points}; {count:n} outliers excluded from the averages",
)


def fit_facts(values: AdjustmentValues) -> list[Fact]:
    """Facts about the fit, in the language in use."""
    return [
        Fact(gettext("Points used"), points_used_text(values)),
        Fact(gettext("Iterations"), values.iterations),
        Fact(gettext("Degrees of freedom"), values.degrees_of_freedom),
        *chi_square_facts(values),
        Fact(gettext("RMS before calibration"), gettext("{rms:mm.1} mm", rms=values.rms_before_m)),
        Fact(
            gettext("RMS after calibration"),
            gettext("{rms:mm.1} mm; POS errors not removed", rms=values.rms_after_m),
        ),
    ]


def chi_square_facts(values: AdjustmentValues) -> list[Fact]:
    """Facts about the variance factor and its test, in the language in use."""
    return [
        Fact(gettext("Variance factor"), _variance_factor_text(values)),
        Fact(gettext("Expected interval at 95 %"), _interval_text(values)),
        Fact(gettext("Chi-square test at 95 %"), _chi_square_text(values)),
        Fact("", str(values.chi_square.text)),
    ]


def points_used_text(values: AdjustmentValues) -> str:
    """Number of points used, and that of the points from which they were averaged or thinned."""
    text = grouped_number(values.points)
    if values.picked_points is not None and values.picked_points > values.points:
        text = gettext(
            AVERAGED_POINTS_TEXT if values.pos_errors == "correlated" else THINNED_POINTS_TEXT,
            points=values.points, picked=values.picked_points,
        )  # fmt: skip
    if not values.excluded_outliers:
        return text
    return gettext(EXCLUDED_OUTLIERS_TEXT, points=text, count=values.excluded_outliers)


def _variance_factor_text(values: AdjustmentValues) -> str | None:
    if values.variance_factor is None:
        return None
    factor = _variance_factor_format(values).text(values.variance_factor)
    groups = [gettext(COMPONENT_TITLES[c.name]) for c in values.components if c.applied]
    if groups:
        return gettext(ESTIMATED_VARIANCE_FACTOR_TEXT, factor=factor, groups=groups)
    return gettext(VARIANCE_FACTOR_TEXT, factor=factor)


def _interval_text(values: AdjustmentValues) -> str | None:
    """Interval of the variance factor of correct sigmas: the bounds of the test per degree."""
    test = values.chi_square
    if test.lower is None or test.upper is None:
        return None
    form = _variance_factor_format(values)
    lower, upper = (
        form.text(bound / values.degrees_of_freedom) for bound in (test.lower, test.upper)
    )
    return gettext("{lower} to {upper}", lower=lower, upper=upper)


def _variance_factor_format(values: AdjustmentValues) -> Format:
    """Format with which the variance factor differs from the bounds of its interval."""
    bounds = (values.chi_square.lower, values.chi_square.upper)
    if values.variance_factor is None:
        return VARIANCE_FACTOR_FORMAT
    return VARIANCE_FACTOR_FORMAT.apart(
        values.variance_factor,
        *(bound / values.degrees_of_freedom for bound in bounds if bound is not None),
    )


def _chi_square_text(values: AdjustmentValues) -> str:
    test = values.chi_square
    form = TEST_STATISTIC_FORMAT.apart(test.statistic, test.lower, test.upper)
    statistic = form.text(test.statistic)
    if test.lower is None or test.upper is None:
        return gettext("test statistic {statistic}", statistic=statistic)
    return gettext(
        "test statistic {statistic}, bounds {lower} to {upper}",
        statistic=statistic,
        lower=form.text(test.lower),
        upper=form.text(test.upper),
    )
