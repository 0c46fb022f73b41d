"""What the reader of a report must be told before the figures.

One rule a function; each looks at the content only, so that a report and a test see the same.
"""

from collections.abc import Iterator

from lispac.report.quality_cautions import cross_check_cautions, quality_cautions
from lispac.report.values import (
    Caution,
    Chi2,
    ReportContent,
    TargetFit,
    ValidationPlane,
    mild,
    serious,
)
from lispac.report.wording import listed, parameter, signed, title

LARGE_SIGMA_DEG = 0.1
"""An angle known no better puts a point at 100 m off by 17 cm: no boresight to work with."""

HIGH_CORRELATION = 0.9
"""Beyond it two angles are told apart mostly by their sum or difference."""


def cautions_of(content: ReportContent) -> tuple[Caution, ...]:
    """Everything to be told, serious things first."""
    found = [
        *_calibration(content),
        *_fit(content),
        *quality_cautions(content),
        *cross_check_cautions(content),
        *_targets(content),
        *_validation(content),
        *_files(content),
    ]
    return tuple(sorted(found, key=lambda caution: caution.severity != "serious"))


def _calibration(content: ReportContent) -> Iterator[Caution]:
    if not content.calibrated:
        yield serious(
            "not_calibrated",
            "Not calibrated: no boresight has been estimated. The angles in this report are the "
            "prior ones, with nothing known about their uncertainty.",
        )
    if content.simulated:
        yield mild(
            "simulated",
            "The survey is simulated: its boresight was put in by the program and says nothing "
            "about a real system.",
        )
    outside = [
        angle.name
        for angle in content.angles
        if angle.error_deg is not None
        and angle.interval95_deg is not None
        and abs(angle.error_deg) > angle.interval95_deg
    ]
    if outside:
        yield mild(
            "truth_outside",
            f"The true value lies outside the 95 % interval of {listed(outside)}.",
        )


def _fit(content: ReportContent) -> Iterator[Caution]:
    if content.adjustment is None:
        return
    independent = content.settings.pos_errors == "independent"
    noisy = any(target.noise_factor > 1 for target in content.adjustment.targets)
    yield from _chi_square(content.adjustment.chi_square, independent, noisy)
    yield from _large_sigmas(content)
    if content.adjustment.one_facing:
        yield _one_facing(content.adjustment.targets)
    if independent:
        yield serious(
            "independent_pos_errors",
            "The stated sigmas of the angles are too small: every point was given POS errors of "
            "its own, while in truth neighbouring points share theirs. Choose the correlated "
            "model for sigmas to rely on.",
        )
    matrix, names = content.adjustment.correlation_all, content.adjustment.estimated
    for i, first in enumerate(names):
        for j in range(i + 1, len(names)):
            if abs(matrix[i][j]) > HIGH_CORRELATION:
                advice = (
                    "a target of another inclination or lines in other directions would help"
                    if j < len(content.angles)
                    else "state how well the prior value is known, or hold it"
                )
                yield mild(
                    "high_correlation",
                    f"{title(parameter(first))} and {parameter(names[j])} are hardly told apart "
                    f"(correlation {signed(matrix[i][j], 2)}): {advice}.",
                )


def _one_facing(targets: tuple[TargetFit, ...]) -> Caution:
    headings = "the headings of the lines alone tell the angles apart"
    remedy = "Add a target of another inclination."
    if len(targets) == 1:
        return serious(
            "one_target",
            f"{targets[0].target} is the only target: {headings}, and nothing shows whether it is "
            f"bent or moved. {remedy}",
        )
    return serious("one_facing", f"All targets face the same way: {headings}. {remedy}")


def _large_sigmas(content: ReportContent) -> Iterator[Caution]:
    large = [
        f"{angle.name} to {angle.sigma_deg:.2f} deg"
        for angle in content.angles
        if angle.sigma_deg is not None and angle.sigma_deg > LARGE_SIGMA_DEG
    ]
    if not large:
        return
    assert content.adjustment is not None
    unseen = [
        parameter(each.name)
        for each in content.adjustment.parameters
        if each.value is None and each.prior_sigma is not None
    ]
    because = (
        f" What these lines and targets do not see goes into it: {listed(unseen)}. Know it better, "
        "or hold it."
        if unseen
        else " Add targets of other inclinations, or lines in other directions."
    )
    known = listed(large)
    yield serious("large_sigma", f"Known only with a large sigma: {known} (1 sigma).{because}")


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
            "The chi-square test failed on the safe side: the residuals are smaller than the "
            "stated sigmas let one expect, and the sigmas of the angles are on the large side.",
        )


def _targets(content: ReportContent) -> Iterator[Caution]:
    total = len(content.lines)
    for plane in content.planes:
        what = "Target" if plane.role == "target" else "Validation plane"
        if not plane.used:
            yield mild("left_out", f"{what} {plane.name} is left out.")
            continue
        seen = len(plane.lines)
        if seen < 2:
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
    yield from _not_found(content)


def _not_found(content: ReportContent) -> Iterator[Caution]:
    """Planes that are missing on the same lines in one sentence."""
    together: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    for plane in content.planes:
        if plane.used and plane.missing:
            together.setdefault((plane.role, tuple(plane.missing)), []).append(plane.name)
    for (role, lines), names in together.items():
        many = len(names) > 1
        what = "target" if role == "target" else "validation plane"
        yield mild(
            "not_found",
            f"{title(what)}{'s' if many else ''} {listed(names)} {'were' if many else 'was'} not "
            f"found on {listed(lines)}; the reasons stand in the section on targets.",
        )


def _validation(content: ReportContent) -> Iterator[Caution]:
    if content.calibrated and not content.validation:
        yield mild(
            "not_validated",
            "Not validated: no plane outside the adjustment has been compared between the lines.",
        )
    for reason in content.not_compared:
        yield mild("not_compared", reason)
    for plane in content.validation:
        if plane.after.rms_m > plane.before.rms_m:
            yield _worse(plane)


def _worse(plane: ValidationPlane) -> Caution:
    return serious(
        "validation_worse",
        f"On validation plane {plane.name} the lines lie farther apart after the calibration "
        f"(RMS {1000 * plane.after.rms_m:.1f} mm) than before "
        f"({1000 * plane.before.rms_m:.1f} mm).",
    )


def _files(content: ReportContent) -> Iterator[Caution]:
    lost = [file.name for file in content.files if file.sha256 is None]
    if lost:
        yield serious(
            "file_missing",
            f"The input {listed(lost)} could not be read for its size and digest.",
        )
