"""What the user has to know before using the angles.

The command line, the window and the report tell the same doubts in the same words. One rule a
function, in `RULES`; what a new one yields is told in all three.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from lispac.adjustment.critical import critical_w, rarely_more
from lispac.adjustment.observability import one_facing
from lispac.adjustment.observations import Sighting
from lispac.adjustment.omitted import OF_CONSEQUENCE
from lispac.adjustment.result import (
    ANGLES,
    AdjustmentResult,
    CrossCheck,
    CrossChecks,
    SightingReliability,
    TargetResidual,
)
from lispac.adjustment.shown import (
    UNCHECKED,
    amount,
    capitalised,
    counted,
    listed,
    mm,
    named_parts,
    parameter,
    plain,
    signed,
    standing,
    surface_sigmas,
    times,
)

LARGE_SIGMA_DEG = 0.1
"""An angle known no better puts a point at 100 m off by 17 cm: no boresight to work with."""

WIDE_SPREAD = 2.0
"""Spread by lines over the formal sigma: of six lines, chance makes it this wide once in a
thousand."""

HIGH_CORRELATION = 0.9
"""Beyond it two angles are told apart mostly by their sum or difference."""

FLAT = 0.005
"""Metres: sigma of the surfaces that no flat board has."""

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

MOST_NAMED = 4
"""Sightings, parts or targets named one by one; more are counted."""


@dataclass(frozen=True)
class Doubt:
    """Something to know before using the angles.

    Attributes
    ----------
    code : str
        Names the rule, whatever the words.
    serious : bool
        Whether it makes the answer doubtful, or is to be kept in mind.
    text : str
        One or two sentences, with true minus signs and fixed spaces.
    """

    code: str
    serious: bool
    text: str

    @property
    def plain(self) -> str:
        """The text in plain characters, for a terminal."""
        return plain(self.text)


def doubts(
    result: AdjustmentResult, checks: CrossChecks | None, also: Iterable[Doubt] = ()
) -> tuple[Doubt, ...]:
    """Everything to be told of an answer, serious things first; ``also`` comes from elsewhere."""
    found = [*also, *(doubt for rule in RULES for doubt in rule(result, checks))]
    return tuple(sorted(found, key=lambda doubt: not doubt.serious))


def _thesis_mode(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    if not result.model.correlated:
        yield Doubt(
            "independent_pos_errors",
            True,
            "Thesis mode: every point is taken to have a POS error of its own, while in truth "
            "neighbouring points share theirs. The sigmas of the angles are several times too "
            "small; choose the correlated model for sigmas to rely on.",
        )


def _contradictions(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    """What a wrong lever arm does to the answer passes every other test."""
    for found in result.contradictions:
        moves = [
            f"{angle} by {signed(float(np.degrees(moved)), 3)}\u00a0deg "
            f"({abs(moved) / sigma:.1f}\u00a0of its sigmas)"
            for angle, moved, sigma in zip(ANGLES, found.moved, result.sigma, strict=True)
            if abs(moved) > OF_CONSEQUENCE * sigma
        ]
        so = f", which would move {listed(moves)}" if moves else ""
        larger = "larger" if found.change > 0 else "smaller"
        yield Doubt(
            f"contradicted_{found.name}",
            True,
            f"The data contradict the stated {parameter(found.name)}: they want it "
            f"{amount(found.name, abs(found.change))} {larger} "
            f"(\u00b1\u00a0{amount(found.name, found.sigma)}, w\u00a0{signed(found.w, 1)})"
            f"{so}. Measure it again, or have it estimated.",
        )


def _surfaces(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    most = float(result.surfaces.max())
    if result.model.surface is not None or most <= FLAT:
        return
    told = ""
    why = "Rough or bent targets do that, and so does an error the model lacks; flat boards do not."
    if result.offset == most:
        told = f", displaced rather than bent or turned ({surface_sigmas(result.surface, most)})"
        why = "Targets that moved do that, and so does an error the model lacks."
    yield Doubt(
        "surfaces_differ",
        False,
        f"From line to line the targets seem to lie {mm(most)}\u00a0mm (1 sigma) off their common "
        f"shape{told}, beyond what the stated sigmas explain; the chi-square test allows for it. "
        f"{why}",
    )


def _large_sigmas(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    large = [
        f"{angle} to {sigma:.2f}\u00a0deg"
        for angle, sigma in zip(ANGLES, np.degrees(result.sigma), strict=True)
        if sigma > LARGE_SIGMA_DEG
    ]
    if not large:
        return
    unseen = [
        parameter(each.name)
        for each in result.parameters
        if each.value is None and each.prior_sigma is not None
    ]
    because = (
        f"What these lines and targets do not see goes into it: {listed(unseen)}. Know it better, "
        "or hold it."
        if unseen
        else "Add targets of other inclinations, or lines in other directions."
    )
    known = f"Known only with a large sigma: {listed(large)} (1 sigma)."
    yield Doubt("large_sigma", True, f"{known} {because}")


def _one_facing(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    targets = result.targets
    if not one_facing(
        np.array([target.plane[:3] for target in targets]),
        np.array([target.sphere for target in targets]),
    ):
        return
    headings = "the headings of the lines alone tell the angles apart"
    remedy = "Add a target of another inclination."
    if len(targets) == 1:
        yield Doubt(
            "one_target",
            True,
            f"{targets[0].target} is the only target: {headings}, and nothing shows whether it is "
            f"bent or moved. {remedy}",
        )
    else:
        yield Doubt("one_facing", True, f"All targets face the same way: {headings}. {remedy}")


def _correlations(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    matrix, names = result.correlation_all, result.estimated
    for i, first in enumerate(names):
        for j in range(i + 1, len(names)):
            if abs(matrix[i, j]) > HIGH_CORRELATION:
                advice = (
                    "a target of another inclination or lines in other directions would help"
                    if j < len(ANGLES)
                    else "state how well the prior value is known, or hold it"
                )
                yield Doubt(
                    "high_correlation",
                    False,
                    f"{capitalised(parameter(first))} and {parameter(names[j])} are hardly told "
                    f"apart (correlation {signed(matrix[i, j], 2)}): {advice}.",
                )


def _surface_held(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    if result.model.correlated and result.model.surface == 0:
        yield Doubt(
            "surface_held",
            False,
            "The surface sigma is held at 0, so no sighting is tested against the others; take it "
            "from the data to have them tested.",
        )


def _sightings(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
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
        )
    if result.suspect_lines:
        jumped, lines = sorted(result.suspect_lines), {item.sighting.line for _, item in found}
        yield Doubt(
            "line_jumped",
            len(jumped) > MOST_JUMPED * len(lines),
            f"Every target is off on {'line' if len(jumped) == 1 else 'lines'} {listed(jumped)}: "
            "the position may have jumped there, targets are mixed up, or a stated value of the "
            "mounting is wrong.",
        )
    doubtful = [item for finding, item in found if finding == "disagrees"]
    if doubtful:
        one = len(doubtful) == 1
        yield Doubt(
            "sighting_disagrees",
            False,
            f"{'Takes' if one else 'Take'} part though the other sightings contradict "
            f"{'it' if one else 'them'}: {_named(doubtful)}.",
        )


def _named(items: list[SightingReliability]) -> str:
    return _some([_off(item) for item in sorted(items, key=lambda item: -abs(item.w))])


def _off(item: SightingReliability) -> str:
    where = _where(item.sighting)
    if not item.detectable < UNCHECKED or abs(item.w) < SHIFTED:
        return where  # not checked, or turned rather than shifted
    return f"{where} (off by {mm(abs(item.shift))}\u00a0mm, w\u00a0{signed(item.w, 1)})"


def _where(sighting: Sighting) -> str:
    return f"{sighting.target} on line {sighting.line}"


def _some(named: list[str]) -> str:
    """The first few, and how many more there are."""
    rest = len(named) - MOST_NAMED
    return listed([*named[:MOST_NAMED], f"{rest} more"] if rest > 0 else named)


def _strays(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    counts = {(s.sighting.target, s.sighting.line): s.points for s in result.sightings}
    tested = [
        (item.sighting, item.strays, counts[item.sighting.target, item.sighting.line])
        for item in result.reliability
    ]
    strays, points = sum(each[1] for each in tested), sum(each[2] for each in tested)
    most = rarely_more(points, STRAY_CHANCE)
    if strays <= max(float(most), FEW_STRAYS * points):
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
        f"{counted(strays, 'stray point')} of {points:,}, where chance explains about "
        f"{max(1, round(STRAY_CHANCE * points))}; most on {_where(worst)} ({here} of {of:,}). "
        f"{say}",
    )


def _noise(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
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
        )
    rough = [t for t in worst_first if MUCH_NOISE < t.noise <= ANOTHER_SURFACE]
    if len(rough) == 1:
        target = rough[0]
        shape = "sphere" if target.sphere else "plane"
        what = f"of {target.target} are {times(target.noise)} the LiDAR noise"
        why = f"{target.target} is rougher than a {shape}"
    elif rough:
        what, why = f"of {_noises(rough)} the LiDAR noise", "these targets are rough"
    else:
        return
    yield Doubt(
        "noise",
        False,
        f"The residuals {what}: either {why}, or the LiDAR sigma is stated too small. The sigmas "
        "of the angles are computed with the noise found.",
    )


def _noises(targets: list[TargetResidual]) -> str:
    """``T1 and T2 are up to 4.1 times``; the largest noise first."""
    names = _some([target.target for target in targets])
    if len(targets) == 1:
        return f"{names} are {times(targets[0].noise)}"
    return f"{names} are up to {times(targets[0].noise)}"


def _parts(_: AdjustmentResult, checks: CrossChecks | None) -> Iterator[Doubt]:
    apart = [
        f"{name[0].lower()}{name[1:]} ({_worst_angle(part)})"
        for name, part in (named_parts(checks) if checks else ())
        if part.disagrees
    ]
    if apart:
        yield Doubt(
            "cross_check",
            False,
            f"Parts of the data disagree by more than chance explains: {_some(apart)}.",
        )


def _worst_angle(part: CrossCheck) -> str:
    assert part.significance is not None
    assert part.difference is not None
    k = int(np.abs(part.significance).argmax())
    return (
        f"{ANGLES[k]} {signed(float(np.degrees(part.difference[k])), 4)}\u00a0deg, "
        f"{abs(part.significance[k]):.1f}\u00a0of its sigmas"
    )


def _spread(_: AdjustmentResult, checks: CrossChecks | None) -> Iterator[Doubt]:
    if checks is None or checks.spread_lines is None:
        return
    spreads, sigmas = np.degrees(checks.spread_lines), np.degrees(checks.sigma)
    for angle, spread, sigma in zip(ANGLES, spreads, sigmas, strict=True):
        if spread > WIDE_SPREAD * sigma:
            yield Doubt(
                "spread",
                False,
                f"The answers without one line each spread {times(spread / sigma)} as widely in "
                f"{angle} as its sigma says: rely on {spread:.4f}\u00a0deg (1 sigma) rather than "
                f"on {sigma:.4f}\u00a0deg.",
            )


RULES: tuple[Callable[[AdjustmentResult, CrossChecks | None], Iterator[Doubt]], ...] = (
    _thesis_mode,
    _contradictions,
    _large_sigmas,
    _one_facing,
    _correlations,
    _surface_held,
    _surfaces,
    _sightings,
    _strays,
    _noise,
    _parts,
    _spread,
)
