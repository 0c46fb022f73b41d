"""Texts of messages about projects: their files, settings, targets and descriptions."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    # -- files of a project --------------------------------------------------------------------
    "project.not_found": N_(
        "{folder}: this folder does not contain a project ({missing} is missing). Choose the "
        "folder of a project."
    ),
    "project.exists": N_("{folder}: the folder already contains a project. Choose another folder."),
    "project.changed_on_disk": N_(
        "{folder}: nothing was saved, because another program has changed this project since it "
        "was opened. Open it again and repeat your changes, or save to another folder."
    ),
    "project.locked": N_(
        "{folder}: nothing was saved, because another program is changing this project. Wait until "
        "it has finished, then try again."
    ),
    "lock.not_a_file": N_(
        "{file}: nothing was changed, because the lock file of the project is a link or a folder. "
        "Remove it, then try again."
    ),
    "project.unreadable": N_(
        "{file}: the project file cannot be read ({reason}). Check the disk and the permissions."
    ),
    "project.newer_version": N_(
        "{file}: the project was saved by a newer version of the program (schema {version}). "
        "Update the program."
    ),
    "project.invalid_value": N_("{file}: a value of the project file cannot be used. {reason}"),
    "project.damaged": N_(
        "{file}: the project file is damaged: {reason} Restore the file from a copy."
    ),
    "project.points_missing": N_(
        "{file}: the file with the points of target {target} is missing. Restore the file from a "
        "copy of the project, or create the project again."
    ),
    "project.points_damaged": N_(
        "{file}: the points of target {target} are damaged: {reason} Restore the file from a copy "
        "of the project, or create the project again."
    ),
    "project.former_text": N_("{reason}"),
    "project.not_estimated": N_(
        "{project}: the boresight angles have not been estimated. Run Estimate first."
    ),
    "project.no_target": N_(
        "{project}: the project has no target or validation plane named {name}. Check the name."
    ),
    # -- targets -------------------------------------------------------------------------------
    "target.invalid_name": N_(
        "The name of a target must have 1 to {longest:n} printable characters; {name} is not "
        "allowed. Choose another name."
    ),
    "target.name_with_separator": N_(
        "{name}: a slash, backslash or colon is not allowed in the name of a target. Choose "
        "another name."
    ),
    "target.plane_with_radius": N_(
        "{target}: a plane cannot have a radius. Remove the radius, or choose the shape sphere."
    ),
    "target.invalid_radius": N_(
        "{target}: a sphere radius of {radius:m} m is not possible. Give a radius larger than 0 m, "
        "or none if it is unknown."
    ),
    "target.validation_sphere": N_(
        "{target}: a sphere cannot be used for validation, because only planes are compared "
        "between lines. Use the sphere as a target."
    ),
    # -- settings ------------------------------------------------------------------------------
    "settings.not_finite": N_("{setting}: the value is NaN or infinite. Correct it."),
    "settings.parameter_sigma_out_of_range": N_(
        "The standard deviation of the prior {name} is not plausible for a survey. Correct it."
    ),
    "project.cannot_be_read_again": N_(
        "The project was not saved, because the saved file could not be opened again: {reason} "
        "Undo the last change, or correct the value."
    ),
    "settings.length_out_of_range": N_(
        "{setting}: {value:m} m is outside the allowed range from {least:m} to {most:m} m. Correct "
        "the value."
    ),
    "settings.angle_out_of_range": N_(
        "{setting}: {value:deg}° is outside the allowed range from {least:deg} to {most:deg}°"
        ". Correct the value."
    ),
    "settings.time_out_of_range": N_(
        "{setting}: {value:s} s is outside the allowed range from {least:s} to {most:s} s. Correct "
        "the value."
    ),
    "settings.negative": N_(
        "A standard deviation or the point spacing is negative. Give values of zero or more."
    ),
    "settings.unknown_noise_source": N_(
        "There is no source {name} of the LiDAR noise. Choose {known:choices}."
    ),
    "settings.unknown_pos_errors": N_(
        "There is no POS error model {name}. Choose {known:choices}."
    ),
    "settings.zero_lidar_sigma": N_(
        "A LiDAR standard deviation is zero or negative. Give values larger than zero."
    ),
    "settings.two_lidar_sigmas": N_(
        "The LiDAR standard deviations are given both along x, y, z and in range and angle. Give "
        "only one of the two sets."
    ),
    "settings.zero_correlation_time": N_(
        "A correlation time of the POS errors is zero or negative. Give times longer than 0 s."
    ),
    "settings.negative_surface": N_(
        "The form error of the targets is negative. Give zero or more."
    ),
    "settings.zero_longest_gap": N_(
        "The longest trajectory gap to interpolate is zero or negative. Give a time longer than 0 "
        "s."
    ),
    "settings.unknown_loss": N_("There is no robust loss function {name}. Choose {known:choices}."),
    "settings.latency_too_large": N_(
        "A latency of {value:s} s is larger than the limit of 10 s. Check the value and its unit."
    ),
    "settings.range_offset_too_large": N_(
        "A range offset of {value:m} m is larger than the limit of 10 m. Check the value and its "
        "unit."
    ),
    "settings.unknown_parameter": N_(
        "{name} is not a parameter of the adjustment. Choose {known:choices}."
    ),
    "settings.zero_parameter_sigma": N_(
        "The standard deviation of {name} is zero or negative. Give a value larger than zero."
    ),
    "settings.parameter_twice": N_(
        "A parameter to be estimated is given twice. Give each parameter once."
    ),
    "settings.boresight_too_large": N_(
        "A prior boresight angle of {value:deg}° exceeds 360°. Check that the angles are in "
        "degrees."
    ),
    "settings.lever_arm_too_long": N_(
        "A lever arm of {length:m} m exceeds the limit of 100 m. Check that the lever arm is in "
        "metres."
    ),
    "settings.latitude_out_of_range": N_(
        "The latitude of the origin, {latitude:deg}°, exceeds 90°. Give latitude and "
        "longitude in degrees, then the height in metres."
    ),
    # -- names of settings, before a colon -----------------------------------------------------
    "setting.lever_arm": N_("Lever arm"),
    "setting.boresight": N_("Prior boresight angles"),
    "setting.origin": N_("Origin of the local frame"),
    "setting.position_sigma": N_("Standard deviation of the position"),
    "setting.attitude_sigma": N_("Standard deviation of the attitude"),
    "setting.lever_arm_sigma": N_("Standard deviation of the lever arm"),
    "setting.beam_divergence": N_("Beam divergence"),
    "setting.lidar_sigma": N_("Standard deviation of the LiDAR"),
    "setting.subsample": N_("Point spacing"),
    "setting.lidar_sigma_xyz": N_("Standard deviation of the LiDAR along x, y, z"),
    "setting.lidar_beam_sigma": N_("Standard deviation of the LiDAR in range and angle"),
    "setting.range_offset": N_("Range offset"),
    "setting.scan_angle_offset": N_("Scan-angle offset"),
    "setting.latency": N_("Latency"),
    "setting.correlation_time": N_("Correlation time of the POS errors"),
    "setting.surface": N_("Form error of the targets"),
    "setting.longest_gap": N_("Longest trajectory gap to interpolate"),
    # -- description of the calibration --------------------------------------------------------
    "identity.several_lines": N_(
        "{field}: the text has several lines, but only one is allowed. Move the rest to the "
        "remarks."
    ),
    "identity.not_printable": N_(
        "{field}: the text contains a character that cannot be printed. Enter the text again."
    ),
    "identity.too_long": N_(
        "{field}: the text has {held:n} characters, but at most {longest:n} are allowed. Shorten "
        "it."
    ),
    "identity.no_date": N_("{field}: {text} is not a date. Enter dates as in 2026-03-04."),
    "identity_field.report_number": N_("Report number"),
    "identity_field.revision": N_("Revision"),
    "identity_field.client": N_("Client"),
    "identity_field.contract": N_("Contract"),
    "identity_field.company": N_("Company"),
    "identity_field.surveyor": N_("Surveyor"),
    "identity_field.processed_by": N_("Processed by"),
    "identity_field.checked_by": N_("Checked by"),
    "identity_field.vessel": N_("Vessel"),
    "identity_field.site": N_("Survey site"),
    "identity_field.dates": N_("Survey dates"),
    "identity_field.datum": N_("Datum"),
    "identity_field.epoch": N_("Epoch"),
    "identity_field.gnss_base": N_("GNSS base"),
    "identity_field.lever_arm_origin": N_("Source of the lever arm"),
    "identity_field.scanner": N_("Scanner"),
    "identity_field.scanner_serial": N_("Scanner serial number"),
    "identity_field.pos": N_("INS/GNSS model"),
    "identity_field.pos_serial": N_("INS/GNSS serial number"),
    "identity_field.processing_software": N_("Processing software"),
    "identity_field.remarks": N_("Remarks"),
}
