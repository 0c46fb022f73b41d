"""Texts of messages about the contents of survey files, and about georeferenced lines."""

from collections.abc import Mapping

from lispac.language import N_, Advised, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- trajectory accuracy -----------------------------------------------------------------
    "accuracy.too_large": N_(
        "{file}: {count:n} records ({share:percent.2} %) have standard deviations over 10,000 m or "
        "180°, so points at these times have no weight in the adjustment. Export the file "
        "again, or check the solution at these times."
    ),
    # -- points of a line --------------------------------------------------------------------
    "audit.time_resolution": N_(
        "{line}: the point times have a resolution of only {step:ms} ms, which causes systematic "
        "errors of up to {shift:mm} mm and {turn:deg}° (about {points:n} points share one "
        "time). Export the line with exact times (64 bits)."
    ),
    "audit.time_steps": N_(
        "{line}: the point times have a resolution of only {step:ms} ms, so about {points:n} "
        "points share one time, with systematic errors in position and attitude. Export the line "
        "with exact times (64 bits)."
    ),
    "audit.first_points": N_(
        "{file}: only the first {count:n} points were checked. All points are checked at the "
        "import."
    ),
    "file.split": N_("The file is split into {count:n} lines: {lines:names}."),
    "audit.not_finite": N_(
        "{line}: {count:n} points ({share:percent.2} %) have values that are NaN or infinite. They "
        "are excluded."
    ),
    "audit.no_range": N_(
        "{line}: {count:n} points ({share:percent.2} %) are pulses without an echo (no range, or "
        "the same value for x, y and z). They are excluded."
    ),
    "audit.too_far": N_(
        "{line}: {count:n} points ({share:percent.2} %) lie beyond the maximum range of the "
        "scanner. They are excluded: check the maximum range."
    ),
    "audit.duplicates": N_(
        "{line}: {count:n} points ({share:percent.2} %) are exact copies of other points. "
        "They are excluded."
    ),
    "audit.withheld": N_(
        "{line}: {count:n} points ({share:percent.2} %) are flagged as withheld in the LAS file. "
        "They are excluded."
    ),
    "audit.of_classes": N_(
        "{line}: {count:n} points ({share:percent.2} %) belong to classes that are excluded from "
        "the import. They are not used."
    ),
    "audit.not_selected": N_(
        "{line}: {count:n} points ({share:percent.2} %) do not meet the selection conditions of "
        "the line. They are excluded."
    ),
    "audit.beyond_range": N_(
        "{line}: imported points lie up to {distance:km.1} km from the scanner, beyond its maximum "
        "range of {limit:km.1} km, so results from them are wrong. Check the file of the line, "
        "then import the line again."
    ),
    "audit.not_checked": Advised(
        N_("{line} was imported by an earlier version, which did not check its points."),
        N_("Import the line again."),
    ),
    "audit.noise_classes": N_(
        "{line}: {count:n} points are classified as noise (class {classes:names}) and may not be "
        "on the surfaces of the targets. Exclude these classes."
    ),
    "audit.several_scanners": N_(
        "{line}: the file contains points of {count:n} scanners ({attribute} {values:names}), for "
        "which a common boresight is wrong. Split the line, or use one scanner."
    ),
    "audit.several_sources": N_(
        "{line}: the file contains several passes, which are not compared with each other, or "
        "several scanners, for which a common boresight is wrong: {count:n} sources ({attribute} "
        "{values:names}). Split the line, or use one source."
    ),
    "audit.several_passes": N_(
        "{line}: the file contains {count:n} passes, separated by pauses in which the vessel "
        "turned, and these are not compared with each other. Split the line."
    ),
    "trajectory.rate_too_low": N_(
        "{line}: the trajectory has only {rate:hz} states per second, so its interpolation has "
        "errors of up to {shift:mm} mm and {turn:deg}° ({share:percent} % of the given "
        "accuracy). Export the trajectory at a higher rate."
    ),
    "trajectory.gap_interpolated": Plural(
        "{line}: the trajectory has {count:n} gap of {longest:s.2} s, which is interpolated with "
        "an error of up to {shift:mm} mm and {turn:deg}°, more than its accuracy. Export the "
        "trajectory without gaps, or import it with a shorter longest gap, so that these points "
        "are not used.",
        "{line}: the trajectory has {count:n} gaps of up to {longest:s.2} s, which are "
        "interpolated with errors of up to {shift:mm} mm and {turn:deg}°, more than its accuracy. "
        "Export the trajectory without gaps, or import it with a shorter longest gap, so that "
        "these points are not used.",
    ),
    "trajectory.position_held": N_(
        "{line}: the trajectory repeats the same position for up to {longest:s.2} s while the "
        "vessel moves, so points are displaced by up to {shift:m.2} m. Export the trajectory "
        "again, with the position at the time of each state."
    ),
    # -- recovery of georeferenced lines -----------------------------------------------------
    "recovery.height_offset": N_(
        "{line}: heights above sea level seem to be combined with an ellipsoidal trajectory "
        "(difference {offset:m.1} m, deviation from the beams {misfit:mm} mm), so the angles will "
        "be wrong. Give the vertical reference, or a height offset of {value:m.1} m."
    ),
    "recovery.time_offset": N_(
        "{line}: the scanner points recovered from the cloud deviate from the beams by {misfit:mm} "
        "mm and agree only with {value:s} s added to the times, so the angles will be wrong. Check "
        "the time base of the line."
    ),
    "recovery.lever_arm_x": N_(
        "{line}: the scanner points recovered from the cloud deviate from the beams by {misfit:mm} "
        "mm, but agree if {value:m.2} m are added to the lever arm in the forward direction. Give "
        "the lever arm with which the cloud was computed."
    ),
    "recovery.lever_arm_y": N_(
        "{line}: the scanner points recovered from the cloud deviate from the beams by {misfit:mm} "
        "mm, but agree if {value:m.2} m are added to the lever arm to the left. Give the lever arm "
        "with which the cloud was computed."
    ),
    "recovery.lever_arm_z": N_(
        "{line}: the scanner points recovered from the cloud deviate from the beams by {misfit:mm} "
        "mm, but agree if {value:m.2} m are added to the lever arm upwards. Give the lever arm "
        "with which the cloud was computed."
    ),
    "recovery.roll_sign": N_(
        "{line}: the scanner points recovered from the cloud deviate from the beams by {misfit:mm} "
        "mm and agree only with the opposite sign of roll, so the angles will be wrong. Check the "
        "signs of the trajectory."
    ),
    "recovery.pitch_sign": N_(
        "{line}: the scanner points recovered from the cloud deviate from the beams by {misfit:mm} "
        "mm and agree only with the opposite sign of pitch, so the angles will be wrong. Check the "
        "signs of the trajectory."
    ),
    "recovery.roll_pitch_signs": N_(
        "{line}: the scanner points recovered from the cloud deviate from the beams by {misfit:mm} "
        "mm and agree only with the opposite signs of roll and pitch, so the angles will be wrong. "
        "Check the signs of the trajectory."
    ),
    "recovery.several_causes": N_(
        "{line}: the scanner points recovered from the cloud deviate from the beams by {misfit:mm} "
        "mm, so the angles will be wrong. Check the possible causes: {causes:names}."
    ),
    "recovery.unexplained": N_(
        "{line}: the scanner points recovered from the cloud deviate from the beams by {misfit:mm} "
        "mm, which no single error explains, so the angles may be wrong. Check whether the cloud "
        "was computed with another trajectory, or adjusted."
    ),
    "recovery.recorded_mounting": N_(
        "{line}: the file records the boresight with which the cloud was computed (roll "
        "{roll:deg.4}, pitch {pitch:deg.4}, yaw {yaw:deg.4}°). It is used to recover the "
        "scanner points from the cloud."
    ),
    "recovery.corrected_trajectory": N_(
        "{line}: the cloud was computed with a corrected trajectory, so with another trajectory "
        "the scanner points are displaced by the corrections. Use the corrected trajectory (SBET) "
        "as the trajectory of the project."
    ),
    "recovery.other_lever_arm": N_(
        "{line}: the cloud was computed with the lever arm {x:m.3}, {y:m.3}, {z:m.3} m, but the "
        "boresight is estimated with the prior one ({off:mm} mm away). If both refer to the same "
        "scanner, correct the prior lever arm."
    ),
    "recovery.boresight_used": Advised(
        N_(
            "{line}: the beams recovered from the cloud lie in a plane that is rotated by "
            "{turn:deg.1}° from the scanner axes."
        ),
        N_(
            "If the scanner measures along its axes, give the boresight of the cloud as the prior "
            "boresight."
        ),
    ),
    # -- several lines ---------------------------------------------------------------------
    "audit.shared_points": N_(
        "{line} and {other} have points in common ({share:percent.1} % of the smaller line), which "
        "count twice, so the standard deviations are too small. Exclude {smaller}."
    ),
    "audit.same_time": N_(
        "{line} and {other} overlap in time by {seconds:n} s: one is a copy of the other (standard "
        "deviations too small), or they come from two scanners with different boresight angles. "
        "Exclude one of the two lines."
    ),
    # -- columns of text -------------------------------------------------------------------
    "text.unit_overridden": N_(
        "{file}: the column titles specify a unit ({stated:names}), but the values are read in "
        "that of the option {option}, {given}. Check the option."
    ),
    "text.two_columns": N_(
        "{file}: the columns {columns:names} have the same meaning; column {used} is used. If this "
        "is wrong, name the columns."
    ),
    "text.magnetic_heading": N_(
        "{file}: according to its title, column {column} is a magnetic heading, so all headings "
        "are wrong by the magnetic declination. Export the true heading."
    ),
    "text.unknown_unit": N_(
        "{file}: the unit in the title of column {column} is not known, so the values are read in "
        "{used}. Check the unit."
    ),
    # -- trajectories ----------------------------------------------------------------------
    "trajectory.angles_in_radians": N_(
        "{file}: the angles are read as degrees, but heading and course differ by "
        "{difference:deg.0}° and agree only in radians. Choose radians."
    ),
    "trajectory.angles_in_degrees": N_(
        "{file}: the angles are read as radians, but heading and course differ by "
        "{difference:deg.0}° and agree only in degrees. Choose degrees."
    ),
    "trajectory.rates_not_used": Advised(
        N_(
            "The velocities or angular rates of the trajectory do not agree with its "
            "{names:names}, for which linear interpolation is used."
        ),
        N_("Check the export of velocities and rates."),
    ),
    "trajectory.no_position": N_(
        "{count:n} states of the trajectory have no position (latitude and longitude 0, as before "
        "the first GNSS fix) and are excluded. Start the export at the first fix."
    ),
    # -- any file --------------------------------------------------------------------------
    "las.scale": N_(
        "{file}: the scale factors of the coordinates, {scale:names}, are impossible. Export the "
        "file again."
    ),
    "file.is_folder": N_("{file}: a folder already has this name. Choose another name."),
    "file.is_device": N_(
        "{file}: this is a device or a pipe and cannot be replaced by a file. Choose another name."
    ),
    "file.bad_name": N_(
        "{file}: this file name contains a character that is not allowed. Choose another name."
    ),
    "store.audit_damaged": N_(
        "{line}: the stored results of the point checks are damaged. Import the line again."
    ),
    "file.header_count": N_(
        "{file}: according to the header the file has {header:n} points, but it contains {held:n}, "
        "which are all read. Export the file again before you use it in another program."
    ),
    "file.legacy_count": N_(
        "{file}: the two point counts in the header differ ({header:n} and {legacy:n}). The file "
        "contains {held:n} points, and all are read."
    ),
    "file.unread_bytes": N_(
        "{file}: the {held:n} points are followed by {bytes:n} bytes that are not point records "
        "and are not read. Export the file again if points are missing."
    ),
    "file.two_systems": N_(
        "{file}: the header specifies two coordinate systems, {used} (used, as the WKT bit "
        "requires) and {other}. If the points are in {other}, set it as the coordinate system "
        "(option crs)."
    ),
    "file.unusable_system": Advised(
        N_(
            "{file}: of the two coordinate systems in the header, the one that the WKT bit "
            "requires cannot be used, so {system} is used."
        ),
        N_("Check the coordinate system."),
    ),
    "file.invalid_points": N_(
        "{file}: {count:n} of {total:n} points are marked as invalid in the file. They are not "
        "used."
    ),
}
