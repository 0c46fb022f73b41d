"""Columns and rows of the tables of the diagnostics."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QLocale

from lispac.adjustment.critical_values import critical_test_value
from lispac.adjustment.display_text import sighting_status
from lispac.adjustment.parameters import SIGNIFICANT, ParameterEstimate
from lispac.adjustment.reliability import CRITICAL_VALUE
from lispac.adjustment.result import (
    AdjustmentResult,
    CrossChecks,
    SightingReliability,
    SightingResidual,
)
from lispac.adjustment.sighting_warnings import NOISE_FACTOR_LIMIT
from lispac.gui.appearance import units
from lispac.gui.appearance.units import Base
from lispac.gui.features.estimate.adjust_parameters import KINDS
from lispac.gui.widgets.diagnostics_table import Cell, Column, Row, number_cell
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.report.diagnostics import cross_check_values
from lispac.report.text_format import named_cross_check_parts

MM, MDEG = 1e3, float(np.degrees(1e3))
ROW_HINT = N_("Double-click or press Enter to show the points of this row in the view")
ANGLE_TITLES = (N_("Roll"), N_("Pitch"), N_("Yaw"))


def sighting_columns() -> tuple[Column, ...]:
    """Columns of the table of sightings, in the user's language."""
    mm, mdeg = units.local_sign("mm"), units.local_sign("m°")
    return (
        Column(gettext("Target"), gettext("Target"), True),
        Column(gettext("Line"), gettext("Line"), True),
        Column(gettext("Points"), gettext("Points used, after averaging or thinning")),
        Column(
            gettext("Before ({unit})", unit=mm),
            gettext("RMS distance to the surface with the prior boresight"),
            base="mm",
        ),
        Column(
            gettext("After ({unit})", unit=mm),
            gettext("RMS distance to the adjusted surface; POS errors not removed"),
            base="mm",
        ),
        Column(
            gettext("Shift ({unit})", unit=mm),
            gettext("Shift of the sighting from the surface fitted to all other sightings"),
            base="mm",
        ),
        Column("w", gettext("Shift divided by its standard deviation (Baarda's test)")),
        Column(
            gettext("Detectable shift ({unit})", unit=mm),
            gettext("Smallest shift that the test detects with a power of 80 %"),
            base="mm",
        ),
        Column(
            gettext("Effect on angles ({unit})", unit=mdeg),
            gettext("Largest change of an angle that an undetected shift of this size can cause"),
            base="m°",
        ),
        Column(
            gettext("Outliers"),
            gettext("Number of points with a test value beyond {limit:x.2}", limit=CRITICAL_VALUE),
        ),
        Column(
            gettext("Largest w of a point"),
            gettext(
                "Largest test value of a point, and its time in the line. For averaged points: "
                "the mean of their times."
            ),
        ),
        Column(
            gettext("Redundancy"),
            gettext("Mean redundancy number of the points, from 0 (not checked) to 1"),
        ),
        Column(
            gettext("POS position ({unit})", unit=mm),
            gettext("Estimated position error and its prior σ (3D lengths)"),
            base="mm",
        ),
        Column(
            gettext("POS attitude ({unit})", unit=mdeg),
            gettext("Estimated attitude error and its prior σ (3D lengths)"),
            base="m°",
        ),
        Column(gettext("Note"), gettext("Finding that should be checked"), True),
    )


def target_columns() -> tuple[Column, ...]:
    """Columns of the table of targets, in the user's language."""
    mm = units.local_sign("mm")
    return (
        Column(gettext("Target"), gettext("Target"), True),
        Column(gettext("Shape"), gettext("Plane or sphere"), True),
        Column(gettext("Lines"), gettext("Number of lines with a sighting of the target")),
        Column(gettext("Points"), gettext("Points used, after averaging or thinning")),
        Column(
            gettext("Before ({unit})", unit=mm),
            gettext("RMS distance to the best-fitting surface with the prior boresight"),
            base="mm",
        ),
        Column(
            gettext("After ({unit})", unit=mm),
            gettext("RMS distance to the adjusted surface"),
            base="mm",
        ),
        Column(
            gettext("Noise factor"),
            gettext("Noise of the residuals divided by the given noise, at least 1"),
        ),
        Column(
            gettext("Largest w of a sighting"),
            gettext("Largest test value w of the sightings of the target"),
        ),
        Column(
            gettext("Outliers"),
            gettext("Number of points with a test value beyond {limit:x.2}", limit=CRITICAL_VALUE),
        ),
        Column(gettext("Note"), gettext("Finding that should be checked"), True),
    )


def check_columns() -> tuple[Column, ...]:
    """Columns of the table of cross-checks, in the user's language."""
    degrees = units.local_sign("°")
    columns = [
        Column(
            gettext("Subset"),
            gettext("Line or target that was omitted, or halves that were compared"),
            True,
        )
    ]
    for title in (
        gettext("Roll\ndifference ({unit})", unit=degrees),
        gettext("Pitch\ndifference ({unit})", unit=degrees),
        gettext("Yaw\ndifference ({unit})", unit=degrees),
    ):
        columns += [
            Column(
                title,
                gettext("Difference from the result with all points, or between the halves"),
                base="°",
            ),
            Column(gettext("in σ"), gettext("Difference divided by its standard deviation")),
        ]
    return (
        *columns,
        Column(
            gettext("Agreement"),
            gettext("Agreement with the result from all points, or between the halves"),
            True,
        ),
        Column(
            gettext("Reason"),
            gettext("Reason for the disagreement, or reason why there is no result"),
            True,
        ),
    )


def parameter_columns() -> tuple[Column, ...]:
    """Columns of the table of estimated values, in the user's language."""
    return (
        Column(gettext("Parameter"), gettext("Estimated parameter of the mounting"), True),
        Column(gettext("Value"), gettext("Estimated value")),
        Column(gettext("± 1 σ"), gettext("Standard deviation of the estimated value")),
        Column(gettext("Prior"), gettext("Value before the adjustment")),
        Column(gettext("Prior σ"), gettext("Standard deviation of the prior")),
        Column(
            gettext("in σ"),
            gettext(
                "Change from the prior divided by its standard deviation. Beyond {limit:x.2} it is "
                "significant at the 5 % level.",
                limit=SIGNIFICANT,
            ),
        ),
        Column(
            gettext("Note"),
            gettext("Significance of the parameter, or reason why it has no value"),
            True,
        ),
    )


def sighting_rows(result: AdjustmentResult) -> list[Row]:
    """One row for each sighting that was used."""
    tests = {(r.sighting.target, r.sighting.line): r for r in result.reliability}
    critical = critical_test_value(result) or np.inf
    return [
        _sighting_row(
            residual, tests.get((residual.sighting.target, residual.sighting.line)), critical
        )
        for residual in result.sightings
    ]


def _sighting_row(
    residual: SightingResidual, test: SightingReliability | None, critical: float
) -> Row:
    sighting = residual.sighting
    key = (sighting.target, sighting.line)
    fit = [
        number_cell(residual.points, ",.0f"),
        number_cell(residual.rms_before, ".1f", MM),
        number_cell(residual.rms_after, ".1f", MM),
    ]
    names = [Cell(sighting.target), Cell(sighting.line)]
    if test is None:
        cells = [*names, *fit, *[number_cell(None, "")] * 9, Cell(gettext("not tested"))]
        return Row(cells, key, tip=gettext(ROW_HINT))
    comment, disagrees = "", sighting_status(test, critical) == "disagrees"
    if test.rejected:
        comment = gettext("rejected: disagrees with other sightings")
    elif disagrees:
        comment = gettext("w beyond {limit:x.2}", limit=critical)
    elif test.outliers > 0.05 * residual.points:
        comment = gettext("many outliers")
    tests = (
        [number_cell(None, "")] * 3
        if test.rejected
        else [
            number_cell(test.w, "+.2f"),
            number_cell(test.detectable, ".1f", MM),
            number_cell(float(np.abs(test.effect).max()), ".1f", MDEG),
        ]
    )
    cells = [
        *names,
        *fit,
        number_cell(test.shift, "+.1f", MM),
        *tests,
        number_cell(test.outliers, ",.0f"),
        _worst_point_cell(test),
        number_cell(test.redundancy, ".2f"),
        _error_cell(test.pos_error[:3], test.pos_sigma[:3], MM, "mm"),
        _error_cell(test.pos_error[3:], test.pos_sigma[3:], MDEG, "m°"),
        Cell(comment),
    ]
    return Row(cells, key, marked=test.rejected or disagrees, tip=gettext(ROW_HINT))


def _worst_point_cell(test: SightingReliability) -> Cell:
    if test.largest_at is None:
        return number_cell(test.largest_w, ".1f")
    # Without separators of thousands, as in the file
    time = f"{test.largest_at:.3f}".replace(".", QLocale().decimalPoint())
    text = gettext("{w:x.1} at {time} s", w=test.largest_w, time=time)
    return Cell(text, test.largest_w)


def _error_cell(error: np.ndarray, sigma: np.ndarray, scale: float, base: Base) -> Cell:
    size, prior = float(np.linalg.norm(error)), float(np.linalg.norm(sigma))
    found, expected = (units.local_figure(each * scale, base, ".1f") for each in (size, prior))
    return Cell(gettext("{error} (σ {sigma})", error=found, sigma=expected), size)


def target_rows(result: AdjustmentResult) -> list[Row]:
    """One row for each target."""
    rows = []
    for target in result.targets:
        tests = [r for r in result.reliability if r.sighting.target == target.target]
        rejected = [r.sighting.line for r in tests if r.rejected]
        lines = sum(s.sighting.target == target.target for s in result.sightings)
        rough = target.noise > NOISE_FACTOR_LIMIT
        comment = gettext("noise larger than given") if rough else ""
        if rejected:
            comment = gettext("rejected in {lines:names}", lines=rejected)
        test_values = [abs(r.w) for r in tests if not r.rejected]
        cells = [
            Cell(target.target),
            Cell(gettext("sphere") if target.sphere else gettext("plane")),
            number_cell(lines, ",.0f"),
            number_cell(target.points, ",.0f"),
            number_cell(target.rms_before, ".1f", MM),
            number_cell(target.rms_after, ".1f", MM),
            number_cell(target.noise, ".2f") if result.model.correlated else number_cell(None, ""),
            number_cell(max(test_values, default=None), ".2f"),
            number_cell(sum(r.outliers for r in tests), ",.0f") if tests else number_cell(None, ""),
            Cell(comment),
        ]
        rows.append(Row(cells, (target.target, ""), marked=bool(rejected), tip=gettext(ROW_HINT)))
    return rows


def check_rows(checks: CrossChecks) -> list[Row]:
    """One row for each part of the data."""
    rows = []
    for name, check in named_cross_check_parts(cross_check_values(checks)):
        title = Cell(name)
        if check.difference_deg is None or check.significance is None:
            reason = message_text(check.reason) if check.reason else ""
            verdict = Cell(gettext("no result"))
            cells = [title, *[number_cell(None, "")] * 6, verdict, Cell(reason)]
            rows.append(Row(cells, tip=reason))
            continue
        cells = [title]
        for off, sigmas in zip(check.difference_deg, check.significance, strict=True):
            cells += [number_cell(off, "+.4f"), number_cell(sigmas, "+.1f")]
        tip = gettext("An angle differs significantly") if check.disagrees else ""
        verdict = gettext("disagrees") if check.disagrees else gettext("agrees")
        cells += [Cell(verdict), Cell(tip)]
        rows.append(Row(cells, marked=check.disagrees, tip=tip))
    return rows


def spread_text(checks: CrossChecks) -> str:
    """Spread of the jackknife beside the standard deviations from the adjustment, as rich text."""

    def row(title: str, values: Sequence[float] | None) -> str:
        numbers = (
            ["–"] * 3
            if values is None
            else [units.local_figure(float(np.degrees(v)), "°", ".4f") for v in values]
        )
        cells = "".join(f"<td align='right' style='padding-left:10px'>{n}</td>" for n in numbers)
        return f"<tr><td>{title}</td>{cells}</tr>"

    title = gettext("1 σ, {unit}", unit=units.local_sign("°"))
    return (
        f"<table><tr><td><b>{title}</b></td>"
        + "".join(
            f"<td align='right' style='padding-left:10px'><b>{gettext(angle)}</b></td>"
            for angle in ANGLE_TITLES
        )
        + "</tr>"
        + row(gettext("Adjustment"), checks.sigma)
        + row(_break_at_commas(gettext("Spread, one line omitted")), checks.spread_lines)
        + row(_break_at_commas(gettext("Spread, one target omitted")), checks.spread_targets)
        + "</table>"
    )


def _break_at_commas(text: str) -> str:
    return text.replace(", ", ",<br>")


def parameter_rows(result: AdjustmentResult) -> list[Row]:
    """Rows of the angles and of all other estimated parameters."""
    rows = []
    for k, title in enumerate(ANGLE_TITLES):
        value, prior = result.angles[k], result.prior_angles[k]
        rows.append(
            Row(
                [
                    Cell(gettext(title)),
                    _angle_cell(float(value), "+.4f"),
                    _angle_cell(float(result.sigma[k]), ".4f"),
                    _angle_cell(float(prior), "+.4f"),
                    number_cell(None, ""),
                    number_cell(float((value - prior) / result.sigma[k]), "+.1f"),
                    Cell(gettext("always estimated")),
                ]
            )
        )
    for estimate in result.parameters:
        kind = KINDS[estimate.name]

        def cell(value: float | None, kind=kind, signed: bool = True) -> Cell:
            if value is None:
                return Cell("–")
            return Cell(kind.amount(value, signed=signed), value)

        reason = estimate.reason
        comment = _significance_text(estimate) if reason is None else message_text(reason)
        cells = [
            Cell(gettext(kind.title)),
            cell(estimate.value),
            cell(estimate.sigma, signed=False),
            cell(estimate.prior),
            Cell(gettext("unknown"))
            if estimate.prior_sigma is None
            else cell(estimate.prior_sigma, signed=False),
            number_cell(estimate.significance, "+.1f"),
            Cell(comment),
        ]
        rows.append(Row(cells, marked=estimate.value is None, tip=comment))
    return rows


def _angle_cell(value: float, form: str) -> Cell:
    return Cell(units.local_amount(float(np.degrees(value)), "°", form), value)


def _significance_text(estimate: ParameterEstimate) -> str:
    """Text on the significance of a parameter; empty if it has no value."""
    if estimate.value is None:
        return ""
    if estimate.significant is None:
        return gettext(
            "not tested: with uncorrelated POS errors the standard deviations are too small"
        )
    if estimate.significant:
        return gettext("significant: keep it")
    return gettext("not significant: can be omitted")
