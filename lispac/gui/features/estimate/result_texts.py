"""Texts about a result besides its angles: other parameters and the goodness of fit."""

from collections.abc import Sequence
from html import escape

from lispac.adjustment.diagnostics.warnings import (
    has_form_errors,
    result_warnings,
    wrong_value_of,
)
from lispac.adjustment.result import AdjustmentResult, CrossChecks
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.estimate.adjust_parameters import MOUNTING_PARAMETERS, MountingParameter
from lispac.gui.widgets.result_tables import local_amount
from lispac.language import N_, Plural, gettext
from lispac.messages import Message
from lispac.present.calibration.adjustment import (
    agreement_template,
    agrees_by_construction,
    has_passed,
    large_residuals_text,
    small_residuals_template,
    targets_with_larger_noise,
)
from lispac.present.calibration.adjustment_fit import TEST_STATISTIC_FORMAT
from lispac.present.calibration.cross_checks import agreement_text, cross_check_values
from lispac.present.calibration.parameters import (
    COMPONENT_TITLES,
    component_values,
    parameter_values,
    significance_text,
)
from lispac.present.calibration.sigmas import component_text, sigma_text, sigmas_used
from lispac.present.tables import MILLIMETRES
from lispac.project import Project

MIN_SHOWN_FORM_ERROR_M = 5e-5
"""Smallest surface sigma, metres, that is not shown as 0.0 mm."""
_TENTH_MM_IN_M = 1e-4


def observation_counts(result: AdjustmentResult) -> str:
    """Number of points and sightings used, and of outliers: ``2,592 points, 12 sightings``."""
    points = gettext(Plural("{count:n} point", "{count:n} points"), count=result.points)
    sightings = gettext(
        Plural("{count:n} sighting", "{count:n} sightings"), count=len(result.sightings)
    )
    if not result.excluded_outliers:
        return f"{points}, {sightings}"
    outliers = gettext(
        Plural("{count:n} outlier excluded", "{count:n} outliers excluded"),
        count=result.excluded_outliers,
    )
    return f"{points}, {sightings}; {outliers}"


def form_error_text(result: AdjustmentResult) -> str:
    """Text of the standard deviation of the surfaces, or the reason why there is none."""
    if not result.model.correlated:
        return "–"
    if result.model.surface == 0:
        return gettext("fixed at 0")
    if result.surfaces.max() < MIN_SHOWN_FORM_ERROR_M:
        return gettext("no change from line to line detected")
    if result.offset is None:
        return _form_error_value_text(result.surface)
    return gettext(
        "offsets {offset}, tilts {tilt}",
        offset=_form_error_value_text(result.offset), tilt=_form_error_value_text(result.surface),
    )  # fmt: skip


def _form_error_value_text(metres: float) -> str:
    if metres < MIN_SHOWN_FORM_ERROR_M:
        return gettext("below {limit}", limit=local_amount(_TENTH_MM_IN_M, MILLIMETRES))
    return local_amount(metres, MILLIMETRES)


REALISTIC_TEXT = N_("The uncertainties are realistic.")
FORM_ERROR_TEXT = N_(
    "The surfaces of the targets vary by {most:mm.1} mm from line to line, which is taken into "
    "account."
)


def fit_verdict(
    result: AdjustmentResult, checks: CrossChecks | None, further: Sequence[Message] = ()
) -> str:
    """Text on the chi-square test and, without warnings, on the validity of the uncertainties.

    If the test is not judged, only the cross-checks can confirm them.
    """
    is_sure = not result_warnings(result, checks, further)
    if result.chi_square.passed:
        sentences = [gettext(agreement_template(result))]
        if has_form_errors(result):
            sentences.append(gettext(FORM_ERROR_TEXT, most=float(result.surfaces.max())))
        if is_sure and (has_passed(result) or checks is not None):
            sentences.append(gettext(REALISTIC_TEXT))
        return " ".join(sentences)
    if result.variance_factor > 1:
        return str(large_residuals_text(result))
    return gettext(small_residuals_template(result))


def chi_square_text(result: AdjustmentResult) -> str:
    """Text of the chi-square test with its bounds, as rich text."""
    test = result.chi_square
    statistic, lower, upper = (
        TEST_STATISTIC_FORMAT.text(value) for value in (test.statistic, test.lower, test.upper)
    )
    interval = N_("{value}, outside {lower} to {upper}")
    if test.outcome == "passed":
        title = gettext("passed")
        colour = theme.MUTED if agrees_by_construction(result) else theme.DONE
        interval = N_("{value}, within {lower} to {upper}")
        if not has_passed(result):
            # Agreement with standard deviations estimated from the residuals is no confirmation
            title = gettext("not judged")
            interval = N_("{value}, LiDAR noise from the same residuals")
    elif test.outcome == "conservative":
        title, colour = gettext("conservative"), theme.MUTED
        interval = N_("{value}, below {lower} to {upper}: residuals smaller than expected")
    elif wrong_value_of(result) is not None:
        title, colour = gettext("failed, a given value disagrees"), theme.WARNING
    elif result.unestimated_sigmas:
        title, colour = gettext("assumed values too small"), theme.MUTED
    elif targets_with_larger_noise(result):
        title, colour = gettext("failed, noise differs between targets"), theme.MUTED
    else:
        colour = theme.WARNING if result.are_sigmas_too_small else theme.MUTED
        title = gettext("failed")
    values = gettext(interval, value=statistic, lower=lower, upper=upper)
    bold = f'<b style="color:{colour}">{title}</b>'
    return gettext("{name}: {text}", name=bold, text=values)


def parameters_html(result: AdjustmentResult) -> str:
    """Parameters estimated besides the boresight, as rich text; empty if there are none."""
    rows = []
    for estimate, values in zip(result.parameters, parameter_values(result), strict=True):
        kind = MOUNTING_PARAMETERS[estimate.name]
        title = escape(gettext(kind.title))
        if estimate.value is None or estimate.sigma is None:
            reason = "" if estimate.reason is None else escape(message_text(estimate.reason))
            text = gettext("{name}: {text}", name=title, text=reason)
            rows.append(f"<tr><td colspan='2'>{text}</td></tr>")
            continue
        prior = gettext("prior {value}", value=_parameter_text(kind, estimate.prior))
        significance = escape(significance_text(values))
        rows.append(
            f"<tr><td>{title}</td><td align='right' style='padding-left:14px'>"
            f"<b>{_parameter_text(kind, estimate.value)}</b> ± "
            f"{_parameter_text(kind, estimate.sigma, signed=False)}"
            f"</td></tr><tr><td colspan='2' align='right' style='color:{theme.MUTED}'>"
            f"{escape(prior)}, {significance}</td></tr>"
        )
    return f"<table width='100%'>{''.join(rows)}</table>" if rows else ""


def _parameter_text(kind: MountingParameter, value: float, *, signed: bool = True) -> str:
    return kind.amount(value, signed=signed)


def sigmas_html(project: Project) -> str:
    """Standard deviations used in the adjustment and their sources, as rich text."""
    return "<br>".join(
        escape(
            gettext(
                "{name}: {text}", name=gettext(COMPONENT_TITLES[each.group]), text=sigma_text(each)
            )
        )
        for each in sigmas_used(project)
    )


def variance_component_texts(project: Project, result: AdjustmentResult) -> tuple[str, ...]:
    """Texts of the variance components of the result of a project."""
    sigmas = {each.group: each for each in sigmas_used(project)}
    return tuple(component_text(each, sigmas[each.name]) for each in component_values(result))


def cross_checks_text(checks: CrossChecks | None) -> str:
    """Number of subsets of the data that agree with the result."""
    if checks is None:
        return gettext("not computed")
    return agreement_text(cross_check_values(checks))
