"""What a result says besides its angles, in words: extra parameters, the fit."""

from collections.abc import Sequence

from lispac.adjustment.doubts import FLAT, doubts
from lispac.adjustment.result import AdjustmentResult, CrossChecks
from lispac.adjustment.shown import component_shown, counted, significance_words, surface_sigmas
from lispac.gui import theme
from lispac.gui.panels.adjust_parameters import KINDS
from lispac.language import N_, gettext
from lispac.messages import Message

LEAST_SURFACE = 5e-5
"""Metres: below it a surface sigma shows as 0.0 mm."""


def taking_part(result: AdjustmentResult) -> str:
    """``2,592 points, 12 sightings``, and the strays that were kept out."""
    words = f"{counted(result.points, 'point')}, {counted(len(result.sightings), 'sighting')}"
    strays = counted(result.left_out, "outlier")
    return f"{words}; {strays} left out" if result.left_out else words


def surface_words(result: AdjustmentResult) -> str:
    """The surface sigma, or why there is none."""
    if not result.model.correlated:
        return "–"
    if result.model.surface == 0:
        return "held at 0"
    if result.surfaces.max() < LEAST_SURFACE:
        return "not detected"
    return surface_sigmas(result.surface, result.offset)


FIT = (
    N_("The residuals agree with the given standard deviations. The uncertainties can be used."),
    N_("The residuals agree with the given standard deviations."),
)
"""Text where there is no warning, and where there is one; so the others."""
FIT_WITH_SURFACES = (
    N_(
        "The residuals agree with the given standard deviations if the targets differ by "
        "{most:mm.1} mm from line to line. The uncertainties can be used."
    ),
    N_(
        "The residuals agree with the given standard deviations if the targets differ by "
        "{most:mm.1} mm from line to line."
    ),
)
SMALL_RESIDUALS = (
    N_(
        "The residuals are smaller than expected: the given standard deviations of LiDAR or POS "
        "are too large, and the uncertainties are conservative."
    ),
    N_(
        "The residuals are smaller than expected: the given standard deviations of LiDAR or POS "
        "are too large."
    ),
)


def verdict(
    result: AdjustmentResult, checks: CrossChecks | None, also: Sequence[Message] = ()
) -> str:
    """What the chi-square test means, in words; no more than that where something is in doubt."""
    is_sure = not doubts(result, checks, also)
    if result.chi_square.passed:
        if result.model.surface is None and (most := float(result.surfaces.max())) > FLAT:
            sure, unsure = FIT_WITH_SURFACES
            return gettext(sure if is_sure else unsure, most=most)
        return gettext(FIT[0] if is_sure else FIT[1])
    if result.variance_factor > 1:
        return gettext(
            "The residuals are larger than expected from the given standard deviations. Look for a "
            "target that is not flat or a sighting with points of something else, or give larger "
            "standard deviations."
        )
    return gettext(SMALL_RESIDUALS[0] if is_sure else SMALL_RESIDUALS[1])


def test_words(result: AdjustmentResult) -> str:
    """The chi-square test with its bounds, as rich text."""
    test = result.chi_square
    word, colour, where = (
        ("passed", theme.DONE, "in") if test.passed else ("failed", theme.WARNING, "not in")
    )
    return (
        f'<b style="color:{colour}">{word}</b>: {test.statistic:.4g} {where} '
        f"[{test.lower:.4g}, {test.upper:.4g}]"
    )


def parameter_rows(result: AdjustmentResult) -> str:
    """The values estimated besides the boresight, as rich text; empty where there are none."""
    rows = []
    for estimate in result.parameters:
        kind = KINDS[estimate.name]
        if estimate.value is None or estimate.sigma is None:
            rows.append(f"<tr><td colspan='2'>{kind.title}: {estimate.reason}</td></tr>")
            continue
        rows.append(
            f"<tr><td>{kind.title}</td><td align='right' style='padding-left:14px'>"
            f"<b>{kind.text(estimate.value)}</b> ± {kind.text(estimate.sigma, signed=False)}"
            f"</td></tr><tr><td colspan='2' align='right' style='color:{theme.MUTED}'>"
            f"prior {kind.text(estimate.prior)}, {significance_words(estimate)}</td></tr>"
        )
    return f"<table width='100%'>{''.join(rows)}</table>" if rows else ""


def component_words(result: AdjustmentResult) -> str:
    """How large the errors are by the data; empty where that was not asked for."""
    return "; ".join(component_shown(each).sentence for each in result.components)
