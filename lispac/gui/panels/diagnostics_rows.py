"""What the tables of the diagnostics hold."""

from collections.abc import Sequence

import numpy as np

from lispac.adjustment.critical import critical_w
from lispac.adjustment.doubts_of_sightings import MUCH_NOISE
from lispac.adjustment.parameters import SIGNIFICANT, Estimate
from lispac.adjustment.result import (
    AdjustmentResult,
    CrossChecks,
    SightingReliability,
    SightingResidual,
)
from lispac.adjustment.shown import (
    SPREAD_LINES,
    SPREAD_TARGETS,
    named_parts,
    significance_words,
    standing,
)
from lispac.gui import units
from lispac.gui.panels.adjust_parameters import KINDS
from lispac.gui.panels.diagnostics_table import Cell, Column, Row, number
from lispac.gui.units import Base

MM, MDEG = 1e3, float(np.degrees(1e3))
FOLLOW = "Double click, or Enter, goes to its points in the view"

SIGHTINGS = (
    Column("Target", "Target", True),
    Column("Line", "Line", True),
    Column("Points", "Points that took part, after averaging or thinning"),
    Column("Before (mm)", "RMS distance to the surface with the prior boresight, mm", base="mm"),
    Column(
        "After (mm)",
        "RMS distance to the adjusted surface, mm; no POS error is taken off",
        base="mm",
    ),
    Column(
        "Shift (mm)",
        "By how much the sighting as a whole lies off what all others say, mm",
        base="mm",
    ),
    Column("w", "The shift over its standard deviation (Baarda's test)"),
    Column("Detectable (mm)", "Smallest shift the test finds with 80 % power, mm", base="mm"),
    Column(
        "Effect (0.001°)",
        "Largest change of an angle by a shift of that size that stays unfound, 0.001°",
        base="m°",
    ),
    Column("Outliers", "Points whose own test is beyond 3.29"),
    Column(
        "Largest point w",
        "Test value of the point farthest off, by its sigma, and its time in the line, s; of an "
        "average of points, the mean of their times",
    ),
    Column("Redundancy", "Mean of the points' redundancy numbers, 0 (unchecked) to 1"),
    Column(
        "POS position (mm)",
        "Estimated position error and its prior sigma, mm (3D length)",
        base="mm",
    ),
    Column(
        "POS attitude (0.001°)",
        "Estimated attitude error and its prior sigma, 0.001° (3D length)",
        base="m°",
    ),
    Column("Remark", "What to look at", True),
)
TARGETS = (
    Column("Target", "Target", True),
    Column("Shape", "Plane or sphere", True),
    Column("Lines", "Lines it was seen on"),
    Column("Points", "Points that took part, after averaging or thinning"),
    Column(
        "Before (mm)", "RMS distance to its best surface with the prior boresight, mm", base="mm"
    ),
    Column("After (mm)", "RMS distance to the adjusted surface, mm", base="mm"),
    Column("Noise factor", "Noise found in the residuals over the stated one, at least 1"),
    Column("Largest w", "Largest test value of its sightings"),
    Column("Outliers", "Points whose own test is beyond 3.29"),
    Column("Remark", "What to look at", True),
)
DIFFERENCE = "Difference from the answer of all points, or between the halves"
CHECKS = (
    Column("Part of the data", "What was left out, or which halves were compared", True),
    Column("Roll\ndifference (deg)", f"{DIFFERENCE}, degrees", base="°"),
    Column("in σ", "The difference over the standard deviation it should have"),
    Column("Pitch\ndifference (deg)", f"{DIFFERENCE}, degrees", base="°"),
    Column("in σ", "The difference over the standard deviation it should have"),
    Column("Yaw\ndifference (deg)", f"{DIFFERENCE}, degrees", base="°"),
    Column("in σ", "The difference over the standard deviation it should have"),
    Column("Verdict", "Whether it agrees, or why there is no answer", True),
    Column("Reason", "Why there is no answer, or what disagrees", True),
)
PARAMETERS = (
    Column("Parameter", "Value of the mounting", True),
    Column("Value", "As estimated"),
    Column("± 1 σ", "Standard deviation of the value"),
    Column("Prior", "What went in"),
    Column("Prior σ", "How well that was said to be known"),
    Column(
        "in σ",
        "Change from the prior over its standard deviation; significant beyond "
        f"{SIGNIFICANT}, which chance exceeds one time in twenty",
    ),
    Column("Remark", "Whether it earns its place, or why there is no number", True),
)


def sighting_rows(result: AdjustmentResult) -> list[Row]:
    """One row for each sighting that took part."""
    tests = {(r.sighting.target, r.sighting.line): r for r in result.reliability}
    critical = critical_w(result) or np.inf
    return [
        _sighting(residual, tests.get((residual.sighting.target, residual.sighting.line)), critical)
        for residual in result.sightings
    ]


def _sighting(residual: SightingResidual, test: SightingReliability | None, critical: float) -> Row:
    sighting = residual.sighting
    key = (sighting.target, sighting.line)
    fit = [
        number(residual.points, ",.0f"),
        number(residual.rms_before, ".1f", MM),
        number(residual.rms_after, ".1f", MM),
    ]
    names = [Cell(sighting.target), Cell(sighting.line)]
    if test is None:
        return Row([*names, *fit, *[number(None, "")] * 9, Cell("no test")], key, tip=FOLLOW)
    remark, odd = "", standing(test, critical) == "disagrees"
    if test.released:
        remark = "released: disagrees"
    elif odd:
        remark = f"w beyond {critical:.2f}"
    elif test.strays > 0.05 * residual.points:
        remark = "many outliers"
    tests = (
        [number(None, "")] * 3
        if test.released
        else [
            number(test.w, "+.2f"),
            number(test.detectable, ".1f", MM),
            number(float(np.abs(test.effect).max()), ".1f", MDEG),
        ]
    )
    cells = [
        *names,
        *fit,
        number(test.shift, "+.1f", MM),
        *tests,
        number(test.strays, ",.0f"),
        _worst_point(test),
        number(test.redundancy, ".2f"),
        _against_prior(test.pos_error[:3], test.pos_sigma[:3], MM, "mm"),
        _against_prior(test.pos_error[3:], test.pos_sigma[3:], MDEG, "m°"),
        Cell(remark),
    ]
    return Row(cells, key, marked=test.released or odd, tip=FOLLOW)


def _worst_point(test: SightingReliability) -> Cell:
    when = "" if test.largest_at is None else f" at {test.largest_at:.3f} s"
    return Cell(f"{test.largest_w:.1f}{when}", test.largest_w)


def _against_prior(error: np.ndarray, sigma: np.ndarray, scale: float, base: Base) -> Cell:
    size, prior = float(np.linalg.norm(error)), float(np.linalg.norm(sigma))
    found, known = (units.figure(each * scale, base, ".1f") for each in (size, prior))
    return Cell(f"{found} (σ {known})", size)


def target_rows(result: AdjustmentResult) -> list[Row]:
    """One row for each target."""
    rows = []
    for target in result.targets:
        tests = [r for r in result.reliability if r.sighting.target == target.target]
        released = [r.sighting.line for r in tests if r.released]
        lines = sum(s.sighting.target == target.target for s in result.sightings)
        rough = target.noise > MUCH_NOISE
        remark = "rougher than stated" if rough else ""
        if released:
            remark = f"released on {', '.join(released)}"
        held = [abs(r.w) for r in tests if not r.released]
        cells = [
            Cell(target.target),
            Cell("sphere" if target.sphere else "plane"),
            number(lines, ",.0f"),
            number(target.points, ",.0f"),
            number(target.rms_before, ".1f", MM),
            number(target.rms_after, ".1f", MM),
            number(target.noise, ".2f") if result.model.correlated else number(None, ""),
            number(max(held, default=None), ".2f"),
            number(sum(r.strays for r in tests), ",.0f") if tests else number(None, ""),
            Cell(remark),
        ]
        rows.append(Row(cells, (target.target, ""), marked=bool(released), tip=FOLLOW))
    return rows


def check_rows(checks: CrossChecks) -> list[Row]:
    """One row for each part of the data."""
    rows = []
    for name, check in named_parts(checks):
        title = Cell(name)
        if check.difference is None or check.significance is None:
            cells = [title, *[number(None, "")] * 6, Cell("no answer"), Cell(check.reason)]
            rows.append(Row(cells, tip=check.reason))
            continue
        cells = [title]
        for off, sigmas in zip(check.difference, check.significance, strict=True):
            cells += [number(float(np.degrees(off)), "+.4f"), number(float(sigmas), "+.1f")]
        tip = "An angle differs by more than chance explains" if check.disagrees else ""
        cells += [Cell("disagrees" if check.disagrees else "agrees"), Cell(tip)]
        rows.append(Row(cells, marked=check.disagrees, tip=tip))
    return rows


def spread_words(checks: CrossChecks) -> str:
    """The jackknife's spread beside the formal sigmas, as rich text."""

    def row(title: str, values: Sequence[float] | None) -> str:
        numbers = (
            ["–"] * 3
            if values is None
            else [units.figure(float(np.degrees(v)), "°", ".4f") for v in values]
        )
        cells = "".join(f"<td align='right' style='padding-left:10px'>{n}</td>" for n in numbers)
        return f"<tr><td>{title}</td>{cells}</tr>"

    return (
        "<table><tr><td><b>1 σ, degrees</b></td>"
        + "".join(
            f"<td align='right' style='padding-left:10px'><b>{a}</b></td>"
            for a in ("Roll", "Pitch", "Yaw")
        )
        + "</tr>"
        + row("Formal sigma", checks.sigma)
        + row(SPREAD_LINES.replace(", ", ",<br>"), checks.spread_lines)
        + row(SPREAD_TARGETS.replace(", ", ",<br>"), checks.spread_targets)
        + "</table>"
    )


def parameter_rows(result: AdjustmentResult) -> list[Row]:
    """The angles, then every value that was switched on."""
    rows = []
    for k, angle in enumerate(("Roll", "Pitch", "Yaw")):
        value, prior = result.angles[k], result.prior_angles[k]
        rows.append(
            Row(
                [
                    Cell(angle),
                    _angle(float(value), "+.4f"),
                    _angle(float(result.sigma[k]), ".4f"),
                    _angle(float(prior), "+.4f"),
                    number(None, ""),
                    number(float((value - prior) / result.sigma[k]), "+.1f"),
                    Cell("always estimated"),
                ]
            )
        )
    for estimate in result.parameters:
        kind = KINDS[estimate.name]

        def shown(value: float | None, kind=kind, signed: bool = True) -> Cell:
            if value is None:
                return Cell("–")
            return Cell(kind.text(value, signed=signed), value, bases=kind.bases)

        remark = estimate.reason or _earns(estimate)
        cells = [
            Cell(kind.title),
            shown(estimate.value),
            shown(estimate.sigma, signed=False),
            shown(estimate.prior),
            Cell("not known")
            if estimate.prior_sigma is None
            else shown(estimate.prior_sigma, signed=False),
            number(estimate.significance, "+.1f"),
            Cell(remark),
        ]
        rows.append(Row(cells, marked=estimate.value is None, tip=remark))
    return rows


def _angle(value: float, form: str) -> Cell:
    return Cell(f"{units.figure(np.degrees(value), '°', form)} °", value, bases=("°",))


def _earns(estimate: Estimate) -> str:
    words = significance_words(estimate)
    if estimate.significant is None:
        return words
    return f"{words}: {'keep it' if estimate.significant else 'can be left out'}"
