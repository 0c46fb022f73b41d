"""What the reader of a report must be told before the figures.

One rule a function; each looks at the content only, so that a report and a test see the same.
"""

from collections.abc import Iterator

from lispac.report.values import Caution, Chi2, ReportContent, ValidationPlane

HIGH_CORRELATION = 0.9
"""Beyond it two angles are told apart mostly by their sum or difference."""


def cautions_of(content: ReportContent) -> tuple[Caution, ...]:
    """Everything to be told, serious things first."""
    found = [
        *_calibration(content),
        *_fit(content),
        *_targets(content),
        *_validation(content),
        *_files(content),
    ]
    return tuple(sorted(found, key=lambda caution: caution.severity != "serious"))


def _serious(code: str, text: str) -> Caution:
    return Caution(code, "serious", text)


def _mild(code: str, text: str) -> Caution:
    return Caution(code, "caution", text)


def _calibration(content: ReportContent) -> Iterator[Caution]:
    if not content.calibrated:
        yield _serious(
            "not_calibrated",
            "Not calibrated: no boresight has been estimated. The angles in this report are the "
            "prior ones, with nothing known about their uncertainty.",
        )
    if content.simulated:
        yield _mild(
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
        yield _mild(
            "truth_outside",
            f"The true value lies outside the 95 % interval of {_listed(outside)}.",
        )


def _fit(content: ReportContent) -> Iterator[Caution]:
    if content.adjustment is None:
        return
    yield from _chi_square(content.adjustment.chi_square)
    if content.settings.pos_errors == "independent":
        yield _serious(
            "independent_pos_errors",
            "The stated sigmas of the angles are too small: every point was given POS errors of "
            "its own, while in truth neighbouring points share theirs. Choose the correlated "
            "model for sigmas to rely on.",
        )
    matrix, names = content.adjustment.correlation, [angle.name for angle in content.angles]
    for i, j in ((0, 1), (0, 2), (1, 2)):
        if abs(matrix[i][j]) > HIGH_CORRELATION:
            yield _mild(
                "high_correlation",
                f"{names[i].capitalize()} and {names[j]} are hardly told apart (correlation "
                f"{matrix[i][j]:+.2f}): a target of another inclination or lines in other "
                "directions would help.",
            )


def _chi_square(test: Chi2) -> Iterator[Caution]:
    if test.passed is None:
        yield _serious(
            "no_redundancy",
            "There are no more points than unknowns: nothing checks the answer.",
        )
    elif test.passed:
        return
    elif test.upper is not None and test.statistic > test.upper:
        yield _serious(
            "chi_square_high",
            "The chi-square test failed: the residuals are larger than the stated accuracies "
            "allow, and the sigmas of the angles are too small.",
        )
    else:
        yield _mild(
            "chi_square_low",
            "The chi-square test failed on the safe side: the residuals are smaller than the "
            "stated accuracies let one expect, and the sigmas of the angles are too large.",
        )


def _targets(content: ReportContent) -> Iterator[Caution]:
    total = len(content.lines)
    for plane in content.planes:
        what = "Target" if plane.role == "target" else "Validation plane"
        if not plane.used:
            yield _mild("left_out", f"{what} {plane.name} is left out.")
            continue
        seen = len(plane.lines)
        if seen < 2:
            where = f"one line only ({plane.lines[0]})" if seen else "no line"
            so = (
                "it says nothing about the boresight"
                if plane.role == "target"
                else "it cannot be compared"
            )
            yield _serious("few_lines", f"{what} {plane.name} is used on {where} of {total}: {so}.")
        elif 2 * seen < total:
            yield _mild(
                "few_lines",
                f"{what} {plane.name} is used on {seen} of {total} lines only "
                f"({', '.join(plane.lines)}).",
            )
        if plane.left_out:
            yield _mild(
                "left_out", f"{what} {plane.name} is left out on {_listed(plane.left_out)}."
            )
        if plane.missing:
            yield _mild(
                "not_found",
                f"{what} {plane.name} was not found on {_listed(tuple(plane.missing))}; the "
                "reasons stand in the section on targets.",
            )


def _validation(content: ReportContent) -> Iterator[Caution]:
    if content.calibrated and not content.validation:
        yield _mild(
            "not_validated",
            "Not validated: no plane outside the adjustment has been compared between the lines.",
        )
    for reason in content.not_compared:
        yield _mild("not_compared", reason)
    for plane in content.validation:
        if plane.after.rms_m > plane.before.rms_m:
            yield _worse(plane)


def _worse(plane: ValidationPlane) -> Caution:
    return _serious(
        "validation_worse",
        f"On validation plane {plane.name} the lines lie farther apart after the calibration "
        f"(RMS {1000 * plane.after.rms_m:.1f} mm) than before "
        f"({1000 * plane.before.rms_m:.1f} mm).",
    )


def _files(content: ReportContent) -> Iterator[Caution]:
    lost = [file.name for file in content.files if file.sha256 is None]
    if lost:
        yield _serious(
            "file_missing",
            f"The input {_listed(lost)} could not be read for its size and digest.",
        )


def _listed(names: tuple[str, ...] | list[str]) -> str:
    """Names as in a sentence: a, b and c."""
    *head, last = names
    return f"{', '.join(head)} and {last}" if head else last
