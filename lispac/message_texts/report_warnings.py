"""Texts of warnings on the first page of a report."""

from collections.abc import Mapping

from lispac.language import N_, Advised, Plural, Template

NOISE_DIFFERS_TEXT = N_(
    "The chi-square test failed because the residuals of {targets:names} are up to {factor:x.2} "
    "times as large as the LiDAR noise that was estimated from all targets. The standard "
    "deviations of the angles are computed with the larger noise."
)

NOISE_DIFFERS_GIVEN_TEXT = N_(
    "The chi-square test failed because the residuals of {targets:names} are up to {factor:x.2} "
    "times as large as the given LiDAR noise, with which those of the other targets agree. The "
    "standard deviations of the angles are computed with the larger noise."
)

TEXTS: Mapping[str, Template] = {
    # -- calibration -------------------------------------------------------------------------
    "report.not_calibrated": N_(
        "The boresight has not been estimated, so the angles in this report are the prior angles, "
        "with unknown uncertainty. Estimate the boresight."
    ),
    "report.file_moved": N_(
        "The report {file} was moved or deleted. Export it again, or open it from its new folder."
    ),
    "report.not_opened": N_(
        "No program is set up to open {file}. Open it in another program, or clear the box in step "
        "5 that opens the report."
    ),
    "report.simulated": N_(
        "The survey is simulated. Its boresight was chosen by the program and does not describe a "
        "real system."
    ),
    "report.truth_outside": N_(
        "The true values of these angles lie outside their 95 % confidence intervals: "
        "{angles:names}."
    ),
    "report.no_redundancy": N_(
        "The adjustment has no redundancy (no more points than unknowns), so errors in the data "
        "cannot be detected. Add targets or lines."
    ),
    "report.chi_square_high": Advised(
        N_(
            "The chi-square test failed: the residuals are larger than the standard deviations "
            "used allow."
        ),
        N_("Correct the standard deviations, or look for outliers."),
    ),
    "report.chi_square_high_noise": Advised(
        N_(
            "The chi-square test failed: the residuals are larger than the standard deviations "
            "used allow, so those of the angles are computed with the larger noise."
        ),
        N_("Correct the standard deviations, or look for outliers."),
    ),
    "report.noise_differs": NOISE_DIFFERS_TEXT,
    "report.noise_differs_given": NOISE_DIFFERS_GIVEN_TEXT,
    "report.chi_square_high_classical": N_(
        "The chi-square test failed: the residuals are larger than the given standard deviations "
        "allow, so the standard deviations of the angles are too small. Correct the given standard "
        "deviations, or look for outliers."
    ),
    "report.chi_square_high_assumed": Advised(
        N_("The residuals are larger than the assumed standard deviations allow."),
        N_(
            "Enter the standard deviations of the data sheet or of the processing report, or look "
            "for outliers."
        ),
    ),
    "report.chi_square_low": N_(
        "The residuals are smaller than the standard deviations used predict, so the tests detect "
        "errors less well."
    ),
    "report.chi_square_low_estimated": N_(
        "The LiDAR noise was estimated from all targets and then increased for targets with a "
        "noise factor above 1, so the residuals are smaller than predicted."
    ),
    "report.parameter_not_seen": Advised(
        N_("The {parameter} was not estimated: {reason}"),
        N_("Turn off its estimation."),
    ),
    "report.parameter_not_seen_uncertain": N_("The {parameter} was not estimated. {reason}"),
    "report.parameter_not_significant": Advised(
        N_("The estimated change of the {parameter} ({change}) is not significant."),
        N_("Use the given value and do not estimate it."),
    ),
    # -- targets and sightings ---------------------------------------------------------------
    "report.left_out_target": N_("Target {target} is excluded."),
    "report.left_out_plane": N_(
        "Validation plane {target} is excluded; the verdict does not include it."
    ),
    "report.left_out_target_on_lines": N_("Target {target} is excluded on {lines:names}."),
    "report.left_out_plane_on_lines": N_("Validation plane {target} is excluded on {lines:names}."),
    "report.target_on_no_line": N_(
        "Target {target} is not used on any of the {total:n} lines, so it has no effect on the "
        "boresight. Pick it again, or remove it."
    ),
    "report.plane_on_no_line": N_(
        "Validation plane {target} is not used on any of the {total:n} lines, so it cannot be "
        "compared. Pick it again, or remove it."
    ),
    "report.plane_on_one_line": N_(
        "Validation plane {target} is used on only one of {total:n} lines ({line}), so it cannot "
        "be compared. Pick it on another line."
    ),
    "report.target_on_few_lines": N_(
        "Target {target} is used on only {count:n} of {total:n} lines ({lines:names})."
    ),
    "report.plane_on_few_lines": N_(
        "Validation plane {target} is used on only {count:n} of {total:n} lines ({lines:names})."
    ),
    "report.not_found": N_(
        "Targets and validation planes that were not found on some lines: {items:names}. {reason}"
    ),
    "report.not_found_on": N_("{target} on {lines:names}"),
    "report.sightings": N_(
        "Quality of {sightings:names}: {ratings:names}; the worst is {target} on {line}. "
        "{reasons:sentences}"
    ),
    # -- validation --------------------------------------------------------------------------
    "report.not_validated": N_(
        "The calibration is not validated, because no validation plane has been compared between "
        "the lines."
    ),
    "report.not_compared": N_("The lines were not compared on a validation plane. {reason}"),
    "report.validation_worse": N_(
        "On validation plane {target} the distances between the lines are larger after the "
        "calibration (RMS {after:mm.1|before} mm) than before ({before:mm.1|after} mm). Check the "
        "targets and the lever arm."
    ),
    "report.validation_worse_explained": N_(
        "The distances between the lines are larger after the calibration than before on "
        "{items:names}. No line is shifted significantly there (largest test value "
        "w = {ratio:x.1|limit}, limit {limit:x.1|ratio}): the uncertainties of POS and boresight "
        "explain the distances."
    ),
    "report.validation_on_plane": N_(
        "{target} (RMS {before:mm.1|after} mm before, {after:mm.1|before} mm after)"
    ),
    "validation.directions_shifted": N_(
        "On validation plane {target}, {lines:names} and the opposite direction ({others:names}) "
        "form two groups {offset:mm.1|limit} mm apart, but the uncertainties of POS and boresight "
        "explain only {limit:mm.1|offset} mm. The boresight may be wrong: check the targets and "
        "the lever arm."
    ),
    "validation.groups_shifted": N_(
        "On validation plane {target}, {lines:names} and {others:names} form two groups "
        "{offset:mm.1|limit} mm apart, but the uncertainties of POS and boresight explain only "
        "{limit:mm.1|offset} mm. The boresight or the trajectory may be wrong: check targets, "
        "lever arm and trajectory."
    ),
    "validation.line_shifted": N_(
        "On validation plane {target}, line {line} is shifted from the mean of {others:names} by "
        "{offset:mm.1|limit} mm, but the uncertainties of POS and boresight explain only "
        "{limit:mm.1|offset} mm. Check the trajectory during this line."
    ),
    "validation.offset_not_smaller": N_(
        "The two lines with the largest offset after the calibration are not closer to each other "
        "than before on {items:names}. No line is shifted significantly there (the largest shift "
        "is {ratio:x.1|limit} σ, the limit for all planes together {limit:x.1|ratio} σ): the "
        "uncertainties of POS and boresight explain the offsets."
    ),
    "validation.offset_not_smaller_shifted": N_(
        "The two lines with the largest offset after the calibration are not closer to each other "
        "than before on {items:names}. Lines are shifted significantly there (the largest shift is "
        "{ratio:x.1|limit} σ, the limit for all planes together {limit:x.1|ratio} σ): the "
        "uncertainties of POS and boresight do not explain the offsets."
    ),
    "validation.offset_not_smaller_unknown": Advised(
        N_(
            "The two lines with the largest offset after the calibration are not closer to each "
            "other than before on {items:names}."
        ),
        N_("Validate again to compare the offset with the uncertainties of POS and boresight."),
    ),
    "validation.shifts_on_plane": N_("{target} ({lines:names})"),
    "validation.shift_of_line": N_("{line} {shift:mm.1+} mm"),
    "validation.offset_on_plane": N_(
        "{target} ({lines}: {before:mm.1} mm before, {after:mm.1} mm after)"
    ),
    "validation.peaks_on_plane": N_("{target} ({smaller:mm.0} and {larger:mm.0} mm)"),
    "validation.several_peaks": N_(
        "The distances have several peaks on {items:names}, because the offsets of the pairs of "
        "lines differ by more than their scatter. The uncertainties of POS and boresight explain "
        "the shifts of the lines there (limit for all planes together {limit:x.1} σ)."
    ),
    "validation.several_peaks_unknown": Advised(
        N_(
            "The distances have several peaks on {items:names}, because the offsets of the pairs "
            "of lines differ by more than their scatter."
        ),
        N_("Validate again to compare the shifts with the uncertainties of POS and boresight."),
    ),
    "validation.rms_below_offset": N_(
        "On validation plane {target}, the RMS of the distances between {line} and {other} after "
        "the calibration ({rms:mm.1} mm) is too small, because their offset is {offset:mm.1} mm. "
        "Increase the points per fit and validate again."
    ),
    "validation.two_modes": N_(
        "On validation plane {target}, the distances between {line} and {other} are bimodal: two "
        "groups {distance:mm.1|limit} mm apart ({share:percent.0} % of the places in the smaller "
        "one), but the uncertainties explain only {limit:mm.1|distance} mm. Check whether the "
        "plane is one surface, and the trajectory for a jump."
    ),
    # -- acceptance --------------------------------------------------------------------------
    "acceptance.not_met": N_("Acceptance criteria not met: {criteria:names}."),
    "acceptance_failure.angle": N_(
        "standard deviation of {angle} ({value:deg.4|limit}°, limit {limit:deg.4|value}°)"
    ),
    "acceptance_failure.rms": N_(
        "RMS on {planes:names} (up to {value:mm.1|limit} mm, limit {limit:mm.1|value} mm)"
    ),
    "acceptance_failure.p95": N_(
        "95 % of the distances on {planes:names} (up to {value:mm.1|limit} mm, limit "
        "{limit:mm.1|value} mm)"
    ),
    "acceptance_failure.offset": N_(
        "offset of two lines on {planes:names} (up to {value:mm.1|limit} mm, limit "
        "{limit:mm.1|value} mm)"
    ),
    "acceptance.cause_given_value": Advised(
        N_("Probable cause: the given {parameter} disagrees with the data."),
        N_("Correct or estimate it, then estimate again."),
    ),
    "acceptance.cause_geometry": Advised(
        N_(
            "Probable cause: the targets and lines do not determine {angles:names} precisely "
            "enough."
        ),
        N_("Add targets in another orientation or farther away, or more lines."),
    ),
    "acceptance.cause_pos": Advised(
        N_(
            "Probable cause: errors of the POS and of the boresight, which explain the shift of "
            "each line, its mean distance from all other lines, positive towards the vessel: "
            "{planes:names} (at most {ratio:x.1|limit} σ, limit {limit:x.1|ratio} σ)."
        ),
        N_(
            "Process the trajectory again with a more accurate solution, or check the given POS "
            "accuracy."
        ),
    ),
    "acceptance.cause_scatter": Advised(
        N_(
            "Probable cause on {target}: the scatter of the points, because the offset of two "
            "lines is at most {offset:mm.1} mm, but the RMS is {rms:mm.1} mm; the surface may be "
            "rough or curved."
        ),
        N_("Pick a plane on a smooth surface."),
    ),
    "acceptance.cause_unknown": Advised(
        N_(
            "The cause on {planes:names} is not known, because an earlier version of LISPAC has "
            "compared the lines."
        ),
        N_("Validate again."),
    ),
    "acceptance.halves_differ": Advised(
        N_(
            "The two halves of the survey differ by more than the criterion for the standard "
            "deviation and by more than {ratio:x.1} standard deviations of the difference (95 % "
            "for three angles), so that the angles may be less certain than their standard "
            "deviations say: {items:names}."
        ),
        N_("Check the trajectory and the targets of both halves."),
    ),
    "acceptance.not_judged": Advised(
        N_(
            "The acceptance criteria for validation planes could not be judged, because no plane "
            "has been compared."
        ),
        N_("Validate on at least one plane."),
    ),
    "acceptance.planes_not_judged": N_(
        "Acceptance criteria could not be judged on {planes:names}, because the lines could not be "
        "compared there. The calibration is not accepted without them."
    ),
    "acceptance.criteria_missing": Advised(
        N_(
            "The verdict does not include these values, because no criterion is given for them: "
            "{criteria:names}."
        ),
        N_("Enter the criteria if the contract or standard has them."),
    ),
    "acceptance_value.roll_sigma": N_("standard deviation of roll"),
    "acceptance_value.pitch_sigma": N_("standard deviation of pitch"),
    "acceptance_value.yaw_sigma": N_("standard deviation of yaw"),
    "acceptance_value.rms": N_("RMS on a validation plane"),
    "acceptance_value.p95": N_("95 % of the distances on a validation plane"),
    "acceptance_value.offset": N_("largest offset of two lines"),
    "acceptance_field.roll_sigma": N_("Largest standard deviation of roll"),
    "acceptance_field.pitch_sigma": N_("Largest standard deviation of pitch"),
    "acceptance_field.yaw_sigma": N_("Largest standard deviation of yaw"),
    "acceptance_field.rms": N_("Largest RMS on a validation plane"),
    "acceptance_field.p95": N_("95 % of the distances on a validation plane"),
    "acceptance_field.offset": N_("Largest offset of two lines"),
    "acceptance_field.source": N_("Source of the criteria"),
    "report.methods_differ": N_("Comparison with an alternative method: {reason}"),
    "report.absolute_nearer": N_(
        "After the calibration the lines are on average {mean:mm.1} mm (± {interval:mm.1} mm, 95 "
        "%) nearer to the vessel than the reference. The uncertainties of reference, POS and "
        "boresight do not explain this difference: check the coordinates of the reference, the "
        "lever arm and the range offset."
    ),
    "report.absolute_farther": N_(
        "After the calibration the lines are on average {mean:mm.1} mm (± {interval:mm.1} mm, 95 "
        "%) farther from the vessel than the reference. The uncertainties of reference, POS and "
        "boresight do not explain this difference: check the coordinates of the reference, the "
        "lever arm and the range offset."
    ),
    "report.absolute_rms": Advised(
        N_(
            "The distances to the reference have an RMS of {rms:mm.1} mm after the calibration, "
            "{factor:x.1} times the {expected:mm.1} mm expected from reference, POS and boresight."
        ),
        N_("Check the reference and the trajectory."),
    ),
    "report.absolute_line_off": Advised(
        Plural(
            "After the calibration {count:n} of {total:n} lines deviates from the reference by "
            "more than its uncertainty explains (positive towards the vessel): {lines:names}.",
            "After the calibration {count:n} of {total:n} lines deviate from the reference by more "
            "than their uncertainty explains (positive towards the vessel): {lines:names}.",
        ),
        N_("Check the trajectory."),
    ),
    "report.absolute_line_off_by_chance": Plural(
        "After the calibration {count:n} of {total:n} lines deviates from the reference by more "
        "than its uncertainty explains (positive towards the vessel): {lines:names}. One line in "
        "twenty is expected to do so by chance.",
        "After the calibration {count:n} of {total:n} lines deviate from the reference by more "
        "than their uncertainty explains (positive towards the vessel): {lines:names}. One line "
        "in twenty is expected to do so by chance.",
    ),
    "report.absolute_point_off": Advised(
        N_(
            "After the calibration the lines deviate on average from {count:n} of {total:n} "
            "surveyed points or planes by more than the uncertainties of reference, POS and "
            "boresight explain (positive towards the vessel): {points:names}."
        ),
        N_("Check the coordinates of these points."),
    ),
    "report.absolute_point_off_by_chance": N_(
        "After the calibration the lines deviate on average from {count:n} of {total:n} surveyed "
        "points or planes by more than the uncertainties of reference, POS and boresight explain "
        "(positive towards the vessel): {points:names}. One in twenty is expected to do so by "
        "chance."
    ),
    "report.file_missing": N_(
        "The size and checksum of {files:names} could not be read. Check that these files exist."
    ),
}
