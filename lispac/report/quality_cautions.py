"""What the reader must be told of the adjustment's own checks."""

from collections.abc import Iterator

import scipy.stats

from lispac.report.values import (
    Adjustment,
    Caution,
    CheckedPart,
    ExtraParameter,
    ReportContent,
    SightingCheck,
    mild,
)
from lispac.report.wording import (
    count,
    listed,
    mm,
    named_parts,
    parameter,
    quantity,
    signed,
    times,
    title,
)

MUCH_NOISE = 2.0
"""Factor on the stated LiDAR noise that is no matter of a few tenths of a millimetre any more."""

WIDE_SPREAD = 2.0
"""Spread by lines over the formal sigma: of six lines, chance makes it this wide once in a
thousand."""

STRAY_CHANCE = 0.001
"""Share of points beyond the test's critical value by chance."""

FEW_STRAYS = 0.005
"""Share of strays that any survey has; fewer are not worth the reader's time."""

MOST_NAMED = 4
"""Sightings or parts named one by one; more are counted."""


def quality_cautions(content: ReportContent) -> Iterator[Caution]:
    """Rules on sightings, points, noise and extra parameters."""
    adjustment = content.adjustment
    if adjustment is None:
        return
    yield from _sightings(adjustment)
    yield from _strays(content, adjustment)
    yield from _noise(adjustment)
    for found in adjustment.parameters:
        yield from _parameter(found)


def _sightings(adjustment: Adjustment) -> Iterator[Caution]:
    released = [s for s in adjustment.reliability if s.released]
    if released:
        yield mild(
            "released",
            f"Left out of the answer, because the other sightings contradict "
            f"{'it' if len(released) == 1 else 'them'}: {_named(released)}. Look at the points and "
            "the trajectory there.",
        )
    lines = {s.line for s in released}
    jumped = [
        line
        for line in sorted(lines)
        if all(s.released for s in adjustment.reliability if s.line == line)
        and sum(s.line == line for s in released) > 1
    ]
    if jumped:
        yield mild(
            "line_jumped",
            f"Every target is off on line {listed(jumped)}: the position may have jumped there, or "
            "targets are mixed up.",
        )
    doubtful = [s for s in adjustment.reliability if s.in_words == "disagrees"]
    if doubtful:
        yield mild(
            "sighting_disagrees",
            f"Takes part though the other sightings contradict it: {_named(doubtful)}."
            if len(doubtful) == 1
            else f"Take part though the other sightings contradict them: {_named(doubtful)}.",
        )


def _named(sightings: list[SightingCheck]) -> str:
    ordered = sorted(sightings, key=lambda s: -abs(s.w or 0.0))
    said = [_sighting(s) for s in ordered[:MOST_NAMED]]
    rest = len(ordered) - MOST_NAMED
    return listed([*said, f"{rest} more"] if rest > 0 else said)


def _sighting(found: SightingCheck) -> str:
    where = f"{found.target} on line {found.line}"
    if found.shift_m is None or found.w is None:
        return where
    return f"{where} (off by {mm(abs(found.shift_m))}\u00a0mm, w\u00a0{signed(found.w, 1)})"


def _strays(content: ReportContent, adjustment: Adjustment) -> Iterator[Caution]:
    strays = sum(s.strays for s in adjustment.reliability)
    points = sum(s.points for s in adjustment.reliability)
    most = scipy.stats.binom.isf(STRAY_CHANCE, points, STRAY_CHANCE) if points else 0.0
    if strays <= max(float(most), FEW_STRAYS * points):
        return
    worst = max(adjustment.reliability, key=lambda s: s.strays / s.points)
    say = {
        "none": "They have full say: choose a loss.",
        "huber": "They have less say than the others.",
        "tukey": "They have little or no say in the answer.",
    }[content.settings.loss]
    yield mild(
        "strays",
        f"{count(strays, 'stray point')} of {points:,}, where chance explains about "
        f"{max(1, round(STRAY_CHANCE * points))}; most on {worst.target} on line {worst.line} "
        f"({worst.strays} of {worst.points:,}). {say}",
    )


def _noise(adjustment: Adjustment) -> Iterator[Caution]:
    for target in adjustment.targets:
        if target.noise_factor > MUCH_NOISE:
            yield mild(
                "noise",
                f"The residuals of {target.target} are {times(target.noise_factor)} the LiDAR "
                f"noise: either {target.target} is rougher than a {target.shape}, or the LiDAR "
                "sigma is stated too small. The sigmas of the angles are computed with the noise "
                "found.",
            )


def _parameter(found: ExtraParameter) -> Iterator[Caution]:
    if found.value is None:
        advice = "" if found.prior_sigma is not None else " Do not estimate it."
        yield mild("parameter_not_seen", found.reason + advice)
    elif not found.significant:
        change = quantity(found.name, found.value - found.prior, sign=True)
        yield mild(
            "parameter_not_significant",
            f"{title(parameter(found.name))} does not earn its place: its change of {change} is "
            "within what chance explains. Hold it at the stated value.",
        )


def cross_check_cautions(content: ReportContent) -> Iterator[Caution]:
    """Rules on what parts of the data say by themselves."""
    checks = content.cross_checks
    if checks is None:
        return
    names = [angle.name for angle in content.angles]
    apart = [(name, part) for name, part in named_parts(checks) if part.disagrees]
    if apart:
        said = [f"{name[0].lower()}{name[1:]} ({_worst(names, part)})" for name, part in apart]
        rest = len(said) - MOST_NAMED
        named = listed([*said[:MOST_NAMED], f"{rest} more"] if rest > 0 else said)
        yield mild(
            "cross_check",
            f"Parts of the data disagree by more than chance explains: {named}. See the section on "
            "cross-checks.",
        )
    if checks.spread_lines_deg is None:
        return
    for name, spread, sigma in zip(names, checks.spread_lines_deg, checks.sigma_deg, strict=True):
        if spread > WIDE_SPREAD * sigma:
            yield mild(
                "spread",
                f"The answers without one line each spread {times(spread / sigma)} as widely in "
                f"{name} as its sigma says: rely on {spread:.4f}\u00a0deg (1 sigma) rather than on "
                f"{sigma:.4f}\u00a0deg.",
            )


def _worst(names: list[str], part: CheckedPart) -> str:
    assert part.significance is not None
    assert part.difference_deg is not None
    significance = [abs(value) for value in part.significance]
    k = significance.index(max(significance))
    return (
        f"{names[k]} {signed(part.difference_deg[k], 4)}\u00a0deg, "
        f"{significance[k]:.1f}\u00a0of its sigmas"
    )
