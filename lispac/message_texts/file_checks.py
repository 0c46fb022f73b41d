"""Texts of messages from the examination of files, to be checked by the user."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- times -------------------------------------------------------------------------------
    "times.coarse": N_(
        "{file}: the times have a resolution of only {step:s} s (32 bits), so points are assigned "
        "the position and attitude of another time. Export the file with 64-bit times."
    ),
    "times.decreasing": N_(
        "{file}: {count:n} of {total:n} times are earlier than the preceding time. Sort the file "
        "or export it again."
    ),
    "times.repeated": N_(
        "{file}: {count:n} of {total:n} times are equal to the preceding time. Sort the file or "
        "export it again."
    ),
    "times.decreasing_points": N_(
        "{file}: {count:n} of the first {total:n} points have an earlier time than the preceding "
        "point. The points are read in the order of the file; check their times."
    ),
    "times.whole_numbers": N_(
        "{file}: the times are whole numbers. Check whether they are in seconds."
    ),
    "times.all_equal": N_(
        "{file}: all points that were checked have the same time, so the file may contain no "
        "times. Check the time column."
    ),
    "times.several_bases": N_(
        "{file}: the times are read as {base}, but their values also fit {bases:choices}. Check "
        "the time base."
    ),
    "times.clock_without_base": N_(
        "{file}: the times are written as hh:mm:ss, and the file does not specify whether they are "
        "UTC. Choose the time base (utc-day or gps-day)."
    ),
    "times.utc_assumed": N_(
        "{file}: the file does not specify whether its times are UTC. UTC is assumed; if this is "
        "wrong, choose the time base."
    ),
    "times.base_contradicted": N_(
        "{file}: the time base specified in the file is {base}, but times such as {time:s.3} s fit "
        "{bases:choices}. Choose the time base."
    ),
    "times.base_impossible": N_(
        "{file}: the time base specified in the file is {base}, but times such as {time:s.3} s fit "
        "no known time base. Choose the time base."
    ),
    # -- points ------------------------------------------------------------------------------
    "points.no_system": N_(
        "{file}: coordinates reach {largest:x.0}, too large for the scanner frame, and the file "
        "does not specify a coordinate system. Give its EPSG code."
    ),
    "points.around_origin": N_(
        "{file}: the points lie all around the origin, as in the scanner frame. If the coordinates "
        "are in millimetres, choose the scanner frame and the unit millimetres."
    ),
    "points.small_coordinates": N_(
        "{file}: the file specifies a coordinate system, but its coordinates are small enough for "
        "the scanner frame. Check the frame."
    ),
    "points.far_from_origin": N_(
        "{file}: points lie up to {distance:x.0} from the origin, beyond the range of a vessel's "
        "scanner. Check the frame and the unit (feet or millimetres)."
    ),
    "points.away_from_origin": N_(
        "{file}: all points are {distance:x.0} or more from the origin, so the origin is probably "
        "not the scanner. Check whether the points are in the scanner frame."
    ),
    "points.degrees": N_(
        "{file}: the first two coordinates vary by less than 0.02 and may be degrees of longitude "
        "and latitude. Check the frame."
    ),
    "points.unused_system": N_(
        "{file}: the coordinate system {system} is given, but the points are in the scanner frame, "
        "which has no coordinate system. Remove the coordinate system, or check the frame."
    ),
    "points.coarse_coordinates": N_(
        "{file}: coordinates are stored in steps of {step:mm.0} mm ({axis}), which limits the "
        "precision of the points. Export the file in steps of 0.1 mm."
    ),
    "points.coordinates_32_bits": N_(
        "{file}: coordinates are stored with 32 bits, in steps of {step:mm.0} mm at "
        "{largest:x.0}, which limits the precision of the points. Export the file with 64-bit "
        "coordinates."
    ),
    "points.resolution_in_feet": N_(
        "{file}: the coordinate resolution {resolution:x.8} is a round value in feet, so the "
        "coordinates may be in feet. Check the unit."
    ),
    "points.feet_in_header": N_("{file}: the header mentions feet. Check the unit."),
    "points.unit_of_column": N_(
        "{file}: according to its title, column x is in {unit}, but {system} is in {system_unit}. "
        "Choose the same system in the unit of the file, or export the file in the unit of the "
        "system."
    ),
    "points.of_one_target": N_(
        "{file}: the file contains the points of one target on all lines, not the points of one "
        "line. Choose the file of a line."
    ),
    # -- E57 and LAS -------------------------------------------------------------------------
    "e57.large_time_stamps": N_(
        "{file}: time stamps such as {time:s.3} s are too large to be seconds since the start of "
        "a scan. They are used unchanged, so choose the time base."
    ),
    "e57.start_not_stated": N_(
        "{file}: the start times of the scans are not specified. The time stamps are used "
        "unchanged, so choose the time base."
    ),
    "e57.poses": N_(
        "{file}: the scans have poses. They are applied to georeferenced points, but not to "
        "points in the scanner frame: check the frame of the points."
    ),
    "velodyne.not_synchronised": N_(
        "{file}: the clock of the scanner differs by {difference:s.1} s from GPRMC, so it does "
        "not show UTC. Check the PPS signal and the cable of the GNSS receiver."
    ),
    "velodyne.no_pps": N_(
        "{file}: the scanner reports no PPS signal, so its times may be wrong by up to a second. "
        "Check the cable of the GNSS receiver, and compare the lines."
    ),
    "las.unknown_wkt": N_(
        "{file}: the WKT of the header is not a coordinate system that PROJ knows. Choose the "
        "coordinate system."
    ),
    "las.system_by_name": N_(
        "{file}: the header specifies the coordinate system {name} without an EPSG code; it is "
        "read as {system}. Check the coordinate system."
    ),
    "las.system_without_code": N_(
        "{file}: the coordinate system of the header ({name}) has no known code. Choose the "
        "coordinate system."
    ),
    "las.system_not_named": N_(
        "{file}: the coordinate system of the header has no known code and no name. Choose the "
        "coordinate system."
    ),
    "las.unit_contradicts_system": N_(
        "{file}: the header specifies the unit {unit}, but {system} is in {system_unit}. Choose "
        "the coordinate system of the points."
    ),
    "las.unknown_vertical": N_(
        "{file}: the vertical reference of the header (code {code}) is not known. Choose the "
        "vertical reference."
    ),
    # -- motion of a trajectory --------------------------------------------------------------
    "trajectory.gaps": Plural(
        "{file}: the trajectory has {count:n} gap longer than {limit:s.1} s; it lasts "
        "{longest:s.1} s. Points recorded in the gap cannot be used: interpolate short gaps, or "
        "export the trajectory again.",
        "{file}: the trajectory has {count:n} gaps longer than {limit:s.1} s; the longest lasts "
        "{longest:s.1} s. Points recorded in the gaps cannot be used: interpolate short gaps, or "
        "export the trajectory again.",
    ),
    "trajectory.impossible_speed": N_(
        "{file}: the positions move at {speed:m.0} m/s, so angles or times may have been read in "
        "the wrong unit. Check the units."
    ),
    "trajectory.fast": N_(
        "{file}: the positions move at {speed:m.0} m/s (median), faster than a vessel. Check the "
        "unit of the positions and of the times, and the coordinate system."
    ),
    "trajectory.jumps": N_(
        "{file}: the positions jump, with speeds up to {largest:m.0} m/s (median {speed:m.1} m/s). "
        "Check the track and process the trajectory again."
    ),
    "trajectory.too_slow": N_(
        "{file}: the vessel hardly moves in the part of the file that was checked. The heading "
        "and the order of latitude and longitude could not be compared with the course: check "
        "them."
    ),
    "trajectory.exchanged": N_(
        "{file}: latitude and longitude seem to be swapped, because the course agrees with the "
        "heading only if they are. Check their order."
    ),
    "trajectory.heading_backward": N_(
        "{file}: the heading is opposite to the course. Check that it is the direction of the bow, "
        "clockwise from north."
    ),
    "trajectory.heading_differs": N_(
        "{file}: heading and course over ground differ by {difference:deg.0}° (median). Check "
        "the heading, its unit and its sign."
    ),
    "trajectory.other_area": N_(
        "{file}: in {system} ({name}) the positions lie at latitude {latitude:deg.1} and longitude "
        "{longitude:deg.1}°, outside the area of this system: {area}. Check the coordinate "
        "system, and the unit and order of eastings and northings."
    ),
    "trajectory.speed_differs": N_(
        "{file}: the positions move at {ratio:x.2} times the speed in columns {east} and {north}. "
        "Check the unit of the positions and the coordinate system."
    ),
    "trajectory.speed_differs_by_feet": N_(
        "{file}: the positions move at {ratio:x.2} times the speed in columns {east} and {north}, "
        "as when feet are read as metres or metres as feet. Check the unit of the positions and "
        "the coordinate system."
    ),
    # -- trajectories of text ----------------------------------------------------------------
    "trajectory.last_rows": N_(
        "{file}: the last rows do not continue the first ones; the file may be truncated, or its "
        "times may decrease. Only the first rows are described here: check the end of the file."
    ),
    "trajectory.columns_assumed": N_(
        "{file}: the file has no row of column names, so the columns are read as {columns:names}. "
        "If this is wrong, name the columns."
    ),
    "trajectory.position_in_radians": N_(
        "{file}: the first latitudes and longitudes are small enough to be radians, so they are "
        "read as radians. If they are in degrees, choose degrees."
    ),
    "trajectory.attitude_in_radians": N_(
        "{file}: the first headings are small enough to be radians, so the attitude is read as "
        "radians. If it is in degrees, choose degrees."
    ),
    "trajectory.roll_starboard_down": N_(
        "{file}: the file does not specify the sign of roll. Roll is assumed positive with "
        "starboard down; if this is wrong, choose the other sign."
    ),
    "trajectory.roll_port_down": N_(
        "{file}: the file does not specify the sign of roll. Roll is assumed positive with port "
        "down; if this is wrong, choose the other sign."
    ),
    "trajectory.pitch_bow_up": N_(
        "{file}: the file does not specify the sign of pitch. Pitch is assumed positive with bow "
        "up; if this is wrong, choose the other sign."
    ),
    "trajectory.pitch_bow_down": N_(
        "{file}: the file does not specify the sign of pitch. Pitch is assumed positive with bow "
        "down; if this is wrong, choose the other sign."
    ),
    "trajectory.seconds_assumed": N_(
        "{file}: the header does not specify the unit of {column}. Seconds are assumed; if this "
        "is wrong, choose the generic text format."
    ),
    "trajectory.dates_assumed": N_(
        "{file}: the header does not specify the format of {column}. Dates are assumed; if this "
        "is wrong, choose the generic text format."
    ),
    "trajectory.degrees_assumed": N_(
        "{file}: the header does not specify the unit of {column}. Degrees are assumed; if this "
        "is wrong, choose the generic text format."
    ),
    "trajectory.metres_assumed": N_(
        "{file}: the header does not specify the unit of {column}. Metres are assumed; if this is "
        "wrong, choose the generic text format."
    ),
    "trajectory.unit_of_system_assumed": N_(
        "{file}: the header does not specify the unit of {column}. The unit of the coordinate "
        "system is assumed, or metres for heights without a coordinate system; if this is wrong, "
        "choose the generic text format."
    ),
    "trajectory.feet_not_specified": N_(
        "{file}: column {column} is in feet of an unspecified kind, read as feet of 0.3048 m, and "
        "{system} is in {unit}. Choose the unit: with US survey feet the positions would differ by "
        "metres."
    ),
    "trajectory.height_unit_not_stated": N_(
        "{file}: the unit of the heights in column {column} is not specified; metres are used, but "
        "eastings and northings are in {unit}. If the heights are in feet, choose feet."
    ),
    "accuracy.all_zero": N_(
        "{file}: all standard deviations are zero, so the file contains no accuracies. Choose "
        "another file."
    ),
    "accuracy.large": N_(
        "{file}: the standard deviations are large (median {position:m} m and {attitude:deg}°"
        "). Check their unit."
    ),
    # -- SBET and CIDCO binary ---------------------------------------------------------------
    "sbet.big_endian": N_(
        "{file}: the numbers are big-endian, unlike those of an SBET. Check which program wrote "
        "the file."
    ),
    "sbet.not_finite": N_(
        "{file}: {count:n} of the records that were checked contain NaN or infinity. Export the "
        "file again."
    ),
    "sbet.other_format": N_(
        "{file}: the numbers are not plausible values of an SBET file. Choose the format of the "
        "file."
    ),
    "sbet.not_angles": N_(
        "{file}: latitude and longitude reach {largest:x} and can be neither radians nor degrees. "
        "Choose the format of the file."
    ),
    "sbet.degrees_assumed": N_(
        "{file}: latitude and longitude seem to be in degrees. All angles are read as degrees; if "
        "this is wrong, choose radians."
    ),
    "sbet.heading_in_radians": N_(
        "{file}: the heading stays below 6.3 and may be in radians, although the positions are in "
        "degrees. Export the file in radians."
    ),
    "sbet.longitude_first": N_(
        "{file}: the first coordinate exceeds 90°, so longitude is read before latitude. Check "
        "that the positions lie in the survey area."
    ),
    "sbet.longitude_first_by_velocity": N_(
        "{file}: longitude is read before latitude, because the velocities agree with the "
        "positions only in this order. Check that the positions lie in the survey area."
    ),
    "sbet.zero_velocities": N_(
        "{file}: all velocities are zero. Their axes and the wander angle could not be compared "
        "with the course: check the heading."
    ),
    "sbet.too_slow": N_(
        "{file}: the vessel hardly moves in the part of the file that was checked. The velocities "
        "could not be compared with the course: check the heading."
    ),
    "sbet.velocities_disagree": N_(
        "{file}: the velocities do not agree with the positions in any known frame (the "
        "best-fitting one, {axes}, differs by {share:percent.0} % of the speed). Check axes, unit "
        "and heading."
    ),
    "sbet.several_axes": N_(
        "{file}: the velocities fit the axes {axes:choices} almost as well as the axes used. The "
        "motion in the part of the file that was checked is too small to distinguish them: check "
        "the axes."
    ),
    "sbet.wander_assumed": N_(
        "{file}: the true heading is computed as the platform heading minus the wander angle, as "
        "defined by Applanix. This could not be checked: ask the producer of the file."
    ),
    "sbet.heading_less_wander": N_(
        "{file}: the wander angle is subtracted from the heading. The heading then agrees with "
        "the course within {used:deg.1}° instead of {other:deg.1}°; if this is wrong, "
        "choose as-is."
    ),
    "sbet.heading_as_is": N_(
        "{file}: the heading is read as true heading, without subtracting the wander angle. It "
        "then agrees with the course within {used:deg.1}° instead of {other:deg.1}°; if "
        "this is wrong, choose minus-wander."
    ),
    "sbet.heading_uncertain": N_(
        "{file}: the wander angle (up to {wander:deg.2}°) is subtracted from the heading, as "
        "defined by Applanix, but the velocities refer to true north. Ask the producer of the file "
        "whether the heading does too."
    ),
    "sbet.zero_rates": N_(
        "{file}: all angular rates are zero, so the signs of roll and pitch could not be checked "
        "and those of Applanix are assumed. To check them: while the vessel heels to starboard, "
        "roll must be positive; while its bow rises, pitch must be positive (manual, page "
        "Conventions)."
    ),
    "sbet.signs_not_checked": N_(
        "{file}: the motion in the part of the file that was checked is too small to check the "
        "sign of {angles:names} with the angular rates, so the signs of Applanix are assumed. To "
        "check them: while the vessel heels to starboard, roll must be positive; while its bow "
        "rises, pitch must be positive (manual, page Conventions)."
    ),
    "sbet.other_signs": N_(
        "{file}: if the angular rates refer to the axes of the vessel (x forward), the signs "
        "differ from those of Applanix: {signs:names}. Ask the producer of the file."
    ),
    "sign.roll_starboard_down": N_("roll positive starboard down"),
    "sign.roll_port_down": N_("roll positive port down"),
    "sign.pitch_bow_up": N_("pitch positive bow up"),
    "sign.pitch_bow_down": N_("pitch positive bow down"),
    "axes.wander_nwu": N_("x along the wander azimuth, y to its left, z up"),
    "axes.wander_ned": N_("x along the wander azimuth, y to its right, z down"),
    "axes.ned": N_("north-east-down"),
    "axes.enu": N_("east-north-up"),
    "axes.nwu": N_("north-west-up"),
    "axes.neu": N_("north-east-up"),
    "cidco.no_origin": N_(
        "{file}: the file does not specify the origin of its local frame, so latitude 0 and "
        "longitude 0 are used. Give the origin before you export georeferenced clouds; the "
        "boresight does not depend on it."
    ),
    "unit.metres": N_("metres"),
    "unit.millimetres": N_("millimetres"),
    "unit.centimetres": N_("centimetres"),
    "unit.kilometres": N_("kilometres"),
    "unit.feet": N_("feet of 0.3048 m"),
    "unit.us_survey_feet": N_("US survey feet"),
    "unit.inches": N_("inches"),
    "unit.yards": N_("yards of 0.9144 m"),
    "unit.fathoms": N_("fathoms"),
    "unit.other": N_("{name} (1 unit = {metres:m.9} m)"),
    "unit.as_in_system": N_("{unit}, as in the coordinate system (the file specifies no unit)"),
    "unit.feet_of_system": N_("{unit}, as in the coordinate system"),
    "unit.metres_assumed": N_("metres (the file specifies no unit)"),
    "unit.positive_west": N_("{unit}, positive to the west"),
    "unit.positive_south": N_("{unit}, positive to the south"),
    "unit.radians": N_("radians"),
    "unit.milliradians": N_("milliradians"),
    "unit.degrees": N_("degrees"),
    "unit.gons": N_("gons"),
    "unit.arc_minutes": N_("arc minutes"),
    "unit.arc_seconds": N_("arc seconds"),
    "unit.dms": N_("degrees, minutes and seconds"),
    "unit.ddmm": N_("degrees and minutes without a separator"),
    "unit.seconds": N_("seconds"),
    "unit.milliseconds": N_("milliseconds"),
    "unit.microseconds": N_("microseconds"),
    "unit.nanoseconds": N_("nanoseconds"),
    "unit.minutes": N_("minutes"),
    "unit.hours": N_("hours"),
    "unit.clock": N_("hours, minutes and seconds"),
    "unit.date": N_("date"),
}
