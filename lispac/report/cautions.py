"""What the reader of a report must be told before the figures.

Doubts about the answer are those of the window and the command line; the rules here look at the
content only, so that a report and a test see the same. One rule a function; each says besides
where the cause lies, which the window goes to.
"""

from collections.abc import Iterator, Sequence

from lispac.adjustment.doubt import Doubt
from lispac.causes import RESULT, Cause
from lispac.report.absolute_cautions import absolute_cautions
from lispac.report.validation_values import ValidationPlane
from lispac.report.values import (
    Caution,
    Chi2,
    ExtraParameter,
    PickedPlane,
    ReportContent,
    SightingJudged,
    mild,
    serious,
)
from lispac.report.wording import listed, parameter, quantity, title

Told = tuple[Caution, Cause]
"""A caution, and where its cause lies."""

DATA, ADJUST, VALIDATE = (Cause.of_step(name) for name in ("Data", "Adjust", "Validate"))

ELSEWHERE = {"cross_check": "See the section on cross-checks."}
"""Where the report says more of a doubt, by its code."""

LARGER_RESIDUALS = {"noise", "not_flat", "cause_not_located"}
"""Codes beside which residuals that are small on average give no all-clear."""


def cautions_of(content: ReportContent, doubts: Sequence[Doubt]) -> tuple[Caution, ...]:
    """Everything to be told, serious things first: doubts about the answer, and the report's own.

    Parameters
    ----------
    doubts : of the answer, as the window and the command line tell them
    """
    return tuple(caution for caution, _ in told_of(content, doubts))


def told_of(content: ReportContent, doubts: Sequence[Doubt]) -> tuple[Told, ...]:
    """As `cautions_of`, each with its cause."""
    larger = any(each.code in LARGER_RESIDUALS for each in doubts)
    found = [
        *_calibration(content),
        *(each for each in _fit(content) if not (larger and each[0].code == "chi_square_low")),
        *_doubts(doubts),
        *_parameters(content),
        *_targets(content),
        *_sightings(content),
        *_validation(content),
        *_absolute(content),
        *_methods(content),
        *_files(content),
    ]
    return tuple(sorted(found, key=lambda told: told[0].severity != "serious"))


def _doubts(doubts: Sequence[Doubt]) -> Iterator[Told]:
    for doubt in doubts:
        words = f"{doubt.text} {ELSEWHERE.get(doubt.code, '')}".rstrip()
        yield (serious if doubt.serious else mild)(doubt.code, words), doubt.cause


def _calibration(content: ReportContent) -> Iterator[Told]:
    if not content.calibrated:
        yield (
            serious(
                "not_calibrated",
                "Not calibrated: no boresight has been estimated. The angles in this report are "
                "the prior ones, with nothing known about their uncertainty.",
            ),
            ADJUST,
        )
    if content.simulated:
        yield (
            mild(
                "simulated",
                "The survey is simulated: its boresight was put in by the program and says nothing "
                "about a real system.",
            ),
            RESULT,
        )
    outside = [
        angle.name
        for angle in content.angles
        if angle.error_deg is not None
        and angle.interval95_deg is not None
        and abs(angle.error_deg) > angle.interval95_deg
    ]
    if outside:
        words = f"The true value lies outside the 95 % interval of {listed(outside)}."
        yield mild("truth_outside", words), RESULT


def _fit(content: ReportContent) -> Iterator[Told]:
    if content.adjustment is None:
        return
    independent = content.settings.pos_errors == "independent"
    noisy = any(target.noise_factor > 1 for target in content.adjustment.targets)
    for caution in _chi_square(content.adjustment.chi_square, independent, noisy):
        yield caution, RESULT


def _parameters(content: ReportContent) -> Iterator[Told]:
    for found in content.adjustment.parameters if content.adjustment else ():
        for caution in _parameter(found):
            yield caution, Cause.of_parameter(found.name)


def _parameter(found: ExtraParameter) -> Iterator[Caution]:
    if found.value is None:
        advice = "" if found.prior_sigma is not None else " Do not estimate it."
        yield mild("parameter_not_seen", found.reason + advice)
    elif found.significant is False:
        change = quantity(found.name, found.value - found.prior, sign=True)
        yield mild(
            "parameter_not_significant",
            f"{title(parameter(found.name))} does not earn its place: its change of {change} is "
            "within what chance explains. Hold it at the stated value.",
        )


def _chi_square(test: Chi2, independent: bool, noisy: bool) -> Iterator[Caution]:
    used = "The sigmas of the angles are computed with the noise found. " if noisy else ""
    if test.passed is None:
        yield serious(
            "no_redundancy",
            "There are no more points than unknowns: nothing checks the answer.",
        )
    elif test.passed:
        return
    elif test.upper is not None and test.statistic > test.upper:
        if independent:
            yield serious(
                "chi_square_high",
                "The chi-square test failed: the residuals are larger than the stated sigmas "
                "allow, and the sigmas of the angles are too small.",
            )
        else:
            yield mild(
                "chi_square_high",
                "The chi-square test failed: the residuals are larger than the stated sigmas "
                f"allow. {used}Correct the stated ones, or look for stray points.",
            )
    else:
        yield mild(
            "chi_square_low",
            "The chi-square test failed: the residuals are smaller than the stated sigmas let one "
            "expect. Where nothing else is in doubt, the sigmas of the angles are on the large "
            "side.",
        )


def _targets(content: ReportContent) -> Iterator[Told]:
    total = len(content.lines)
    for plane in content.planes:
        for caution in _target(plane, total):
            yield caution, Cause.of_target(plane.name)
    yield from _not_found(content)


def _target(plane: PickedPlane, total: int) -> Iterator[Caution]:
    what = "Target" if plane.role == "target" else "Validation plane"
    if not plane.used:
        yield mild("left_out", f"{what} {plane.name} is left out.")
        return
    seen = len(plane.lines)
    if plane.role == "target" and seen == 1:
        pass  # told among the warnings of the project, as excluded
    elif seen < 2:
        where = f"one line only ({plane.lines[0]})" if seen else "no line"
        so = (
            "it says nothing about the boresight"
            if plane.role == "target"
            else "it cannot be compared"
        )
        yield serious("few_lines", f"{what} {plane.name} is used on {where} of {total}: {so}.")
    elif 2 * seen < total:
        yield mild(
            "few_lines",
            f"{what} {plane.name} is used on {seen} of {total} lines only "
            f"({', '.join(plane.lines)}).",
        )
    if plane.left_out:
        yield mild("left_out", f"{what} {plane.name} is left out on {listed(plane.left_out)}.")


def _not_found(content: ReportContent) -> Iterator[Told]:
    """Planes that are missing on the same lines in one sentence."""
    together: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    for plane in content.planes:
        if plane.used and plane.missing:
            together.setdefault((plane.role, tuple(plane.missing)), []).append(plane.name)
    for (role, lines), names in together.items():
        many = len(names) > 1
        what = "target" if role == "target" else "validation plane"
        words = (
            f"{title(what)}{'s' if many else ''} {listed(names)} {'were' if many else 'was'} not "
            f"found on {listed(lines)}; the reasons stand in the section on targets."
        )
        yield mild("not_found", words), Cause.of_target(names[0])


def _sightings(content: ReportContent) -> Iterator[Told]:
    """How many that are used are not good, and the worst; of targets rather than of others."""
    target = {plane.name: plane.role == "target" for plane in content.planes}
    used = {(p.name, line) for p in content.planes if p.used for line in p.lines}
    judged = [each for each in content.qualities if (each.target, each.line) in used]
    poor, doubtful = (
        [each for each in judged if each.light == light] for light in ("poor", "doubtful")
    )
    if not poor and not doubtful:
        return

    def bad(each: SightingJudged) -> tuple[bool, bool, int, float]:
        is_poor, oblique = each.light == "poor", each.incidence_deg or 0.0
        return is_poor, target[each.target], len(each.reasons), oblique

    worst = max((*poor, *doubtful), key=bad)
    words = (
        f"Of {len(judged)} sightings used, poor: {len(poor)}, doubtful: {len(doubtful)}. The "
        f"worst, {worst.target} on {worst.line}: {' '.join(worst.reasons)} See the section on the "
        "quality of the sightings."
    )
    yield mild("sightings", words), Cause.of_sighting(worst.target, worst.line)


def _validation(content: ReportContent) -> Iterator[Told]:
    if content.calibrated and not content.validation:
        words = (
            "Not validated: no plane outside the adjustment has been compared between the lines."
        )
        yield mild("not_validated", words), VALIDATE
    for reason in content.not_compared:
        yield mild("not_compared", reason), VALIDATE
    for plane in content.validation:
        if plane.after.rms_m > plane.before.rms_m:
            yield _worse(plane), Cause.of_target(plane.name)


def _absolute(content: ReportContent) -> Iterator[Told]:
    """The line that is farthest off is where the cause of single ones lies."""
    for caution in absolute_cautions(content.absolute):
        cause = VALIDATE
        if caution.code == "absolute_line_off" and content.absolute is not None:
            farthest = max(content.absolute.lines, key=lambda each: abs(each.after.signed.mean_m))
            cause = Cause.of_line(farthest.line)
        yield caution, cause


def _methods(content: ReportContent) -> Iterator[Told]:
    """Of the first sentences one is on each method but the first."""
    for each, words in zip(content.methods[1:], content.methods_in_words, strict=False):
        if each.differ:
            yield mild("methods_differ", words), ADJUST


def _worse(plane: ValidationPlane) -> Caution:
    return serious(
        "validation_worse",
        f"On validation plane {plane.name} the lines lie farther apart after the calibration "
        f"(RMS {1000 * plane.after.rms_m:.1f} mm) than before "
        f"({1000 * plane.before.rms_m:.1f} mm).",
    )


def _files(content: ReportContent) -> Iterator[Told]:
    lost = [file.name for file in content.files if file.sha256 is None]
    if lost:
        words = f"The input {listed(lost)} could not be read for its size and digest."
        yield serious("file_missing", words), DATA
