"""What the user has to know before using the angles.

The command line, the window and the report tell the same doubts in the same words. One rule a
function, in `RULES`; what a new one yields is told in all three.
"""

from collections.abc import Callable, Iterable, Iterator

import numpy as np

from lispac.adjustment.doubt import Doubt, some
from lispac.adjustment.doubts_of_causes import Known, cause_doubts
from lispac.adjustment.doubts_of_sightings import contradicted, noise, strays
from lispac.adjustment.observability import one_facing
from lispac.adjustment.result import ANGLES, AdjustmentResult, CrossCheck, CrossChecks
from lispac.adjustment.shown import (
    amount,
    capitalised,
    listed,
    mm,
    named_parts,
    one_of,
    parameter,
    signed,
    surface_sigmas,
)
from lispac.causes import Cause

LARGE_SIGMA_DEG = 0.1
"""An angle known no better puts a point at 100 m off by 17 cm: no boresight to work with."""

RAISED = 1.05
"""Factor on a sigma from which a warning says that it was raised."""

HIGH_CORRELATION = 0.9
"""Beyond it two angles are told apart mostly by their sum or difference."""

FLAT = 0.005
"""Metres: sigma of the surfaces that no flat board has."""


def doubts(
    result: AdjustmentResult, checks: CrossChecks | None, also: Iterable[Doubt] = ()
) -> tuple[Doubt, ...]:
    """Everything to be told of an answer, serious things first; ``also`` comes from elsewhere."""
    also = tuple(also)
    found = [doubt for rule in RULES for doubt in rule(result, checks)]
    told = (*also, *cause_doubts(result, Known.among(also), found))
    return tuple(sorted(told, key=lambda doubt: not doubt.serious))


def _thesis_mode(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    if not result.model.correlated:
        yield Doubt(
            "independent_pos_errors",
            True,
            "Thesis mode: every point is taken to have a POS error of its own, while in truth "
            "neighbouring points share theirs. The sigmas of the angles are several times too "
            "small; choose the correlated model for sigmas to rely on.",
            Cause.of_field("pos_errors"),
        )


def _steep_pitch(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    if result.mounting.axes is not None:
        yield Doubt(
            "steep_pitch",
            False,
            "The pitch of the boresight is steep, where roll and yaw can hardly be told apart: the "
            "standard deviations are those of small rotations about the body axes. Use the "
            "rotation matrix rather than the three angles.",
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
        Cause.of_page("Sightings"),
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
            Cause.of_target(targets[0].target),
        )
    else:
        yield Doubt(
            "one_facing",
            True,
            f"All targets face the same way: {headings}. {remedy}",
            Cause.of_target(targets[0].target),
        )


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
                    Cause.of_page("Correlations")
                    if j < len(ANGLES)
                    else Cause.of_parameter(names[j]),
                )


def _surface_held(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    if result.model.correlated and result.model.surface == 0:
        yield Doubt(
            "surface_held",
            False,
            "The surface sigma is held at 0, so no sighting is tested against the others; take it "
            "from the data to have them tested.",
            Cause.of_field("surface"),
        )


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
            f"Parts of the data disagree by more than chance explains: {some(apart)}.",
            Cause.of_page("Cross-checks"),
        )


def _worst_angle(part: CrossCheck) -> str:
    assert part.significance is not None
    assert part.difference is not None
    k = int(np.abs(part.significance).argmax())
    return (
        f"{ANGLES[k]} {signed(float(np.degrees(part.difference[k])), 4)}\u00a0deg, "
        f"{abs(part.significance[k]):.1f}\u00a0of its sigmas"
    )


def _unchecked(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    """Lines, targets and sightings whose errors cannot be detected."""
    if result.observability is None:
        return
    found = result.observability.unchecked
    lines = [each.line for each in found if each.kind == "line"]
    targets = [each.target for each in found if each.kind == "target"]
    if lines:
        yield Doubt(
            "line_unchecked",
            True,
            f"Without {one_of('line', lines)} the angles are not determined, so that its "
            "errors cannot be detected. Add lines.",
            Cause.of_line(lines[0]),
        )
    if targets:
        yield Doubt(
            "target_unchecked",
            True,
            f"Without {one_of('target', targets)} the angles are not determined, so that its "
            "errors cannot be detected. Add targets.",
            Cause.of_target(targets[0]),
        )
    for each in found:
        if each.kind == "clustered":
            yield Doubt(
                "targets_clustered",
                True,
                f"All targets lie within {100 * each.size:.0f}\u00a0% of their distance from the "
                "scanner, so that an error of a line cannot be detected. Add targets at other "
                "places.",
            )
    carried = [each for each in found if each.kind == "sighting"]
    if carried:
        named = [f"{each.target} on line {each.line} ({listed(each.angles)})" for each in carried]
        yield Doubt(
            "carried_by_one",
            True,
            "The angles depend on one sighting, of which an error cannot be detected: "
            f"{some(named)}. Add targets or lines.",
            Cause.of_sighting(carried[0].target, carried[0].line),
        )


def _excluded_targets(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    if result.excluded_targets:
        named = some(list(result.excluded_targets))
        yield Doubt(
            "target_excluded",
            False,
            f"Excluded, because no point of them agrees with the other targets and lines: {named}. "
            "Pick them again, or remove them.",
            Cause.of_target(result.excluded_targets[0]),
        )


def _common_parts(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    """Targets of which the lines show different parts that are not shown to be one plane."""
    cut = [each for each in result.common_parts if each.share > 0.0]
    excluded = [each.target for each in result.common_parts if each.share == 0.0]
    if cut:
        named = some(
            [f"{100 * each.share:.0f}\u00a0% of the points of {each.target}" for each in cut]
        )
        yield Doubt(
            "target_cut",
            False,
            "Lines show different parts of a surface that is not shown to be flat, so only the "
            f"common part is used: {named}. Pick smaller targets.",
            Cause.of_target(cut[0].target),
        )
    if excluded:
        yield Doubt(
            "target_parts",
            False,
            f"Excluded, because lines show different parts of it and it is not shown to be flat: "
            f"{some(excluded)}. Pick a part that two lines show.",
            Cause.of_target(excluded[0]),
        )


RADII_AGREE = {
    "roll_sign": "with the sign of roll turned",
    "pitch_sign": "with the sign of pitch turned",
    "roll_pitch_signs": "with the signs of roll and pitch turned",
}
"""What makes radii agree, by the cause of `RadiusDiscrepancy`; not the values of the mounting."""


def _radii(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    for each in result.radius_discrepancies:
        said = (
            f"The radius of {each.target} differs from line to line, from {mm(each.smallest)} to "
            f"{mm(each.largest)}\u00a0mm"
        )
        if not each.cause:
            so = "Check the attitude signs, the latency and the points of the target."
            text = f"{said}, and no single error explains it. {so}"
        elif each.cause in RADII_AGREE:
            agree = RADII_AGREE[each.cause]
            text = f"{said}. They agree {agree}: check the sign convention of the file."
        else:
            larger = "larger" if each.value > 0 else "smaller"
            value = f"{parameter(each.cause)} {amount(each.cause, abs(each.value))} {larger}"
            text = f"{said}. They agree with {value}: measure it again."
        yield Doubt("radii_differ", True, text, Cause.of_target(each.target))


def _shorter_times(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    if result.stated_times is not None:
        position, attitude = result.stated_times
        model = result.model
        yield Doubt(
            "shorter_times",
            False,
            f"With the stated correlation times of the POS errors ({position:g}\u00a0s for "
            f"position, {attitude:g}\u00a0s for attitude) the residuals are too large for the "
            f"chi-square test. With {model.position_time:g}\u00a0s and {model.attitude_time:g}"
            "\u00a0s they pass it, and the standard deviations are computed with these.",
            Cause.of_field("position_time"),
        )


def _raised(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Doubt]:
    if result.raised is None:
        return
    told = [
        f"{angle} from {before:.4f} to {after:.4f}\u00a0deg"
        for angle, before, after, factor in zip(
            ANGLES, np.degrees(result.with_formal_sigmas.sigma), np.degrees(result.sigma),
            result.raised, strict=True,
        )
        if factor > RAISED
    ]  # fmt: skip
    if told:
        yield Doubt(
            "sigmas_raised",
            False,
            "Parts of the data scatter by more than the model of errors predicts. The standard "
            f"deviations are raised: {listed(told)}.",
            Cause.of_page("Cross-checks"),
        )


RULES: tuple[Callable[[AdjustmentResult, CrossChecks | None], Iterator[Doubt]], ...] = (
    _thesis_mode,
    _large_sigmas,
    _one_facing,
    _correlations,
    _surface_held,
    _surfaces,
    _steep_pitch,
    contradicted,
    strays,
    noise,
    _parts,
    _unchecked,
    _excluded_targets,
    _common_parts,
    _radii,
    _shorter_times,
    _raised,
)
