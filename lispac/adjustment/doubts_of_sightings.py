"""Doubts about single sightings, lines and targets: what the others contradict, strays, noise."""

from collections.abc import Iterator

from lispac.adjustment.critical import critical_w, rarely_more
from lispac.adjustment.doubt import Doubt, some
from lispac.adjustment.observations import Sighting
from lispac.adjustment.result import (
    AdjustmentResult,
    CrossChecks,
    SightingReliability,
    TargetResidual,
)
from lispac.adjustment.shown import UNCHECKED, counted, mm, signed, standing, times
from lispac.causes import Cause

MUCH_NOISE = 2.0
"""Factor on the stated LiDAR noise that is no matter of a few tenths of a millimetre any more."""

ANOTHER_SURFACE = 30.0
"""Factor that no rough ground reaches; that has half of it at most."""

STRAY_CHANCE = 0.001
"""Share of points beyond the test's critical value by chance."""

FEW_STRAYS = 0.005
"""Share of strays that any survey has; fewer are not worth the reader's time."""

MOST_JUMPED = 0.2
"""Share of the lines beyond which lines that were let go of make the rest doubtful."""

SHIFTED = 2.0
"""Test value below which a sighting that was let go of is not off by its shift."""


def contradicted(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    """Sightings that the others contradict, rejected or not."""
    critical = critical_w(result)
    if critical is None:
        return
    found = [(standing(item, critical), item) for item in result.reliability]
    released = [item for finding, item in found if finding == "left out"]
    if released:
        yield Doubt(
            "released",
            False,
            f"Left out of the answer, because the other sightings contradict "
            f"{'it' if len(released) == 1 else 'them'}: {_named(released)}. Look at the points and "
            "the trajectory there.",
            _worst(released),
        )
    doubtful = [item for finding, item in found if finding == "disagrees"]
    if doubtful:
        one = len(doubtful) == 1
        yield Doubt(
            "sighting_disagrees",
            False,
            f"{'Takes' if one else 'Take'} part though the other sightings contradict "
            f"{'it' if one else 'them'}: {_named(doubtful)}.",
            _worst(doubtful),
        )


def _named(items: list[SightingReliability]) -> str:
    return some([_off(item) for item in sorted(items, key=lambda item: -abs(item.w))])


def _worst(items: list[SightingReliability]) -> Cause:
    return _at(max(items, key=lambda item: abs(item.w)).sighting)


def _at(sighting: Sighting) -> Cause:
    return Cause.of_sighting(sighting.target, sighting.line)


def _off(item: SightingReliability) -> str:
    where = _where(item.sighting)
    if not item.detectable < UNCHECKED or abs(item.w) < SHIFTED:
        return where  # not checked, or turned rather than shifted
    return f"{where} (off by {mm(abs(item.shift))}\u00a0mm, w\u00a0{signed(item.w, 1)})"


def _where(sighting: Sighting) -> str:
    return f"{sighting.target} on line {sighting.line}"


def strays(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    """More stray points than chance explains."""
    counts = {(s.sighting.target, s.sighting.line): s.points for s in result.sightings}
    tested = [
        (item.sighting, item.strays, counts[item.sighting.target, item.sighting.line])
        for item in result.reliability
    ]
    many, points = sum(each[1] for each in tested), sum(each[2] for each in tested)
    most = rarely_more(points, STRAY_CHANCE)
    if many <= max(float(most), FEW_STRAYS * points):
        return
    worst, here, of = max(tested, key=lambda each: each[1] / each[2])
    say = {
        "none": "They have full say: choose a loss.",
        "huber": "They have less say than the others.",
        "tukey": "They have little or no say in the answer.",
    }[result.model.loss]
    yield Doubt(
        "strays",
        False,
        f"{counted(many, 'stray point')} of {points:,}, where chance explains about "
        f"{max(1, round(STRAY_CHANCE * points))}; most on {_where(worst)} ({here} of {of:,}). "
        f"{say}",
        _at(worst),
    )


def noise(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    """Targets whose points scatter more than the LiDAR noise explains."""
    worst_first = sorted(result.targets, key=lambda target: -target.noise)
    other = [t for t in worst_first if t.noise > ANOTHER_SURFACE]
    if other:
        several = len(other) > 1
        yield Doubt(
            "another_surface",
            False,
            f"The points of {_noises(other)} the LiDAR noise off their surface and count for "
            f"little: {'are they' if several else 'is it'} the same "
            f"{'surfaces' if several else 'surface'} on every line?",
            Cause.of_target(other[0].target),
        )
    rough = [t for t in worst_first if MUCH_NOISE < t.noise <= ANOTHER_SURFACE]
    if not rough:
        return
    found = (
        "Residuals larger than the LiDAR noise, or correlated over the surface, on "
        f"{some([target.target for target in rough])}: in effect "
        f"{'' if len(rough) == 1 else 'up to '}{times(rough[0].noise)} the given noise. "
    )
    seen = result.observability
    # With such lines the cross-checks, which enlarge the sigmas elsewhere, show nothing of it.
    if seen is not None and any(each.kind == "line" for each in seen.unchecked):
        yield Doubt(
            "not_flat",
            True,
            f"{found}The targets are probably not flat, and these lines are too few to detect what "
            "that does to the angles: they may be off by more than their sigmas. Add lines, or use "
            "flat targets.",
            Cause.of_target(rough[0].target),
        )
        return
    yield Doubt(
        "noise",
        False,
        f"{found}The surface is rough or curved, or the given LiDAR sigma is too small. The sigmas "
        "of the angles are computed with the noise found.",
        Cause.of_target(rough[0].target),
    )


def _noises(targets: list[TargetResidual]) -> str:
    """``T1 and T2 are up to 4.1 times``; the largest noise first."""
    names = some([target.target for target in targets])
    if len(targets) == 1:
        return f"{names} are {times(targets[0].noise)}"
    return f"{names} are up to {times(targets[0].noise)}"
