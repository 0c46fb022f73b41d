"""Texts of warnings on the first page of a report."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- calibration -------------------------------------------------------------------------
    "report.not_calibrated": N_(
        "Not calibrated: no boresight has been estimated. The angles in this report are the prior "
        "ones, and nothing is known about their uncertainty."
    ),
    "report.simulated": N_(
        "The survey is simulated. Its boresight was set by the program and says nothing about a "
        "real system."
    ),
    "report.truth_outside": N_(
        "The true value lies outside the 95 % confidence interval of {angles:names}."
    ),
    "report.no_redundancy": N_(
        "There are no more points than unknowns, so nothing checks the result."
    ),
    "report.chi_square_high": N_(
        "The chi-square test failed: the residuals are larger than the given standard deviations "
        "allow. Correct these, or look for outliers."
    ),
    "report.chi_square_high_noise": N_(
        "The chi-square test failed: the residuals are larger than the given standard deviations "
        "allow. The standard deviations of the angles are computed with the noise found. Correct "
        "the given ones, or look for outliers."
    ),
    "report.chi_square_high_classical": N_(
        "The chi-square test failed: the residuals are larger than the given standard deviations "
        "allow, and the standard deviations of the angles are too small."
    ),
    "report.chi_square_low": N_(
        "The chi-square test failed: the residuals are smaller than expected from the given "
        "standard deviations. If there is no other warning, the standard deviations of the angles "
        "are too large rather than too small."
    ),
    "report.parameter_not_seen": N_(
        "Not estimated ({parameter}): {reason} Turn its estimation off."
    ),
    "report.parameter_not_seen_uncertain": N_("Not estimated ({parameter}): {reason}"),
    "report.parameter_not_significant": N_(
        "The estimated change of the {parameter} ({change}) is not significant. Use the given "
        "value and turn its estimation off."
    ),
    # -- targets and sightings ---------------------------------------------------------------
    "report.left_out_target": N_("Target {target} is excluded."),
    "report.left_out_plane": N_("Validation plane {target} is excluded."),
    "report.left_out_target_on_lines": N_("Target {target} is excluded on {lines:names}."),
    "report.left_out_plane_on_lines": N_("Validation plane {target} is excluded on {lines:names}."),
    "report.target_on_no_line": N_(
        "Target {target} is used on none of {total:n} lines, so it has no effect on the boresight."
    ),
    "report.plane_on_no_line": N_(
        "Validation plane {target} is used on none of {total:n} lines, so it cannot be compared."
    ),
    "report.plane_on_one_line": N_(
        "Validation plane {target} is used on only one of {total:n} lines ({line}), so it cannot "
        "be compared."
    ),
    "report.target_on_few_lines": N_(
        "Target {target} is used on only {count:n} of {total:n} lines ({lines:names})."
    ),
    "report.plane_on_few_lines": N_(
        "Validation plane {target} is used on only {count:n} of {total:n} lines ({lines:names})."
    ),
    "report.not_found_target": Plural(
        "Target {names:names} was not found on {lines:names}. The section on targets gives the "
        "reasons.",
        "Targets {names:names} were not found on {lines:names}. The section on targets gives the "
        "reasons.",
    ),
    "report.not_found_plane": Plural(
        "Validation plane {names:names} was not found on {lines:names}. The section on targets "
        "gives the reasons.",
        "Validation planes {names:names} were not found on {lines:names}. The section on targets "
        "gives the reasons.",
    ),
    "report.sightings": N_(
        "Sightings used: {total:n}, of which poor: {poor:n}, doubtful: {doubtful:n}. The worst is "
        "{target} on {line}: {reasons:sentences} See the section on the quality of the sightings."
    ),
    # -- validation --------------------------------------------------------------------------
    "report.not_validated": N_(
        "Not validated: no validation plane has been compared between the lines."
    ),
    "report.not_compared": N_("Not compared: {reason}"),
    "report.validation_worse": N_(
        "On validation plane {target} the lines lie farther apart after the calibration (RMS "
        "{after:mm.1} mm) than before ({before:mm.1} mm)."
    ),
    "report.methods_differ": N_("Alternative method: {reason}"),
    "report.absolute_nearer": N_(
        "After the calibration all lines together lie {mean:mm.1} mm nearer to the vessel than the "
        "reference on average, ± {interval:mm.1} mm (95 %). This is more than reference, POS and "
        "boresight explain."
    ),
    "report.absolute_farther": N_(
        "After the calibration all lines together lie {mean:mm.1} mm farther from the vessel than "
        "the reference on average, ± {interval:mm.1} mm (95 %). This is more than reference, POS "
        "and boresight explain."
    ),
    "report.absolute_rms": N_(
        "Against the reference, the distances have an RMS of {rms:mm.1} mm after the calibration, "
        "{factor:x.1} times the {expected:mm.1} mm expected from reference, POS and boresight. See "
        "the section on the absolute check."
    ),
    "report.absolute_line_off": Plural(
        "After the calibration {count:n} of {total:n} lines is off by more than its errors "
        "explain, positive towards the vessel: {lines:names}.",
        "After the calibration {count:n} of {total:n} lines are off by more than their errors "
        "explain, positive towards the vessel: {lines:names}.",
    ),
    "report.absolute_line_off_by_chance": Plural(
        "After the calibration {count:n} of {total:n} lines is off by more than its errors "
        "explain, positive towards the vessel: {lines:names}. One in twenty is by chance.",
        "After the calibration {count:n} of {total:n} lines are off by more than their errors "
        "explain, positive towards the vessel: {lines:names}. One in twenty is by chance.",
    ),
    "report.absolute_point_off": N_(
        "After the calibration the mean of the lines deviates from {count:n} of {total:n} surveyed "
        "points or planes by more than reference, POS and boresight explain, positive towards the "
        "vessel: {points:names}."
    ),
    "report.absolute_point_off_by_chance": N_(
        "After the calibration the mean of the lines deviates from {count:n} of {total:n} surveyed "
        "points or planes by more than reference, POS and boresight explain, positive towards the "
        "vessel: {points:names}. One in twenty is by chance."
    ),
    "report.file_missing": N_(
        "The size and digest of {files:names} could not be read. Check that the files are there."
    ),
}
