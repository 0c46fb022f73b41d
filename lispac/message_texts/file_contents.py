"""Texts about the contents of files, and about assumptions of the file readers."""

from collections.abc import Mapping

from lispac.language import N_, Advised, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- formats -----------------------------------------------------------------------------------
    "format.sbet": N_("Applanix SBET"),
    "format.smrmsg": N_("Applanix smrmsg"),
    "format.exail": N_("Exail (iXblue) APPS or Delph INS text"),
    "format.pospac": N_("Applanix POSPac text"),
    "format.inertial_explorer": N_("NovAtel Inertial Explorer text"),
    "format.pof": N_("RIEGL POF"),
    "format.ascii": N_("Text with given columns"),
    "format.cidco_states": N_("CIDCO binary, states of the points"),
    "format.cidco_sigmas": N_("CIDCO binary, standard deviations of the states"),
    "format.exail_sigmas": N_("Exail (iXblue) text, standard deviations"),
    "format.pospac_sigmas": N_("Applanix POSPac text, standard deviations"),
    "format.inertial_explorer_sigmas": N_("NovAtel Inertial Explorer text, standard deviations"),
    "format.las": N_("LAS or LAZ"),
    "format.e57": N_("E57"),
    "format.ply": N_("PLY"),
    "format.pcd": N_("PCD"),
    "format.velodyne": N_("Velodyne packets (PCAP)"),
    "format.text": N_("Text (CSV, also .gz)"),
    "format.cidco": N_("CIDCO binary (22 columns)"),
    "format.planes": N_("Plane file (25 columns)"),
    "format.target": N_("Target (CSV)"),
    # -- facts about a file ------------------------------------------------------------------------
    "fact.none": N_("none"),
    "fact.not_specified": N_("not specified"),
    "fact.not_named": N_("not named"),
    "fact.not_known": N_("not known"),
    "fact.text": N_("text"),
    "fact.text_gzipped": N_("text, compressed with gzip"),
    "fact.las": N_("{kind} {version}, point format {number:n}"),
    "fact.cidco": N_("CIDCO binary, 22 numbers per point"),
    "fact.planes": N_("plane file, 25 columns"),
    "fact.target": N_("target as CSV"),
    "fact.velodyne": Plural(
        N_("packets of Velodyne {models:names}"),
        N_("packets of {count:n} Velodyne scanners ({models:names})"),
    ),
    "fact.returns_single": N_("one for each laser pulse"),
    "fact.returns_dual": N_("strongest and last; equal ones are one point"),
    "fact.no_title": N_("without a title"),
    "fact.pospac": N_("POSPac text export"),
    "fact.points_in_scans": N_("{points:n} in {scans:n} scans"),
    "fact.states": N_("{count:n} trajectory states at different times"),
    "fact.about": N_("about {count:n}"),
    "fact.scanner_frame": N_("scanner frame"),
    "fact.georeferenced": N_("georeferenced"),
    "fact.unit_of_system": N_("as in the coordinate system"),
    "fact.converted_unit": N_("{unit}, converted to metres"),
    "fact.viewpoint": N_("{values} (not applied)"),
    "fact.time_base_specified": N_("{base}, as specified"),
    "fact.time_bases_fitting": N_("not specified; the values fit {bases:choices}"),
    "fact.interval": N_("{low:x.3} to {high:x.3}"),
    "fact.times": N_("{low:s.6} to {high:s.6} s (first {count:n} points)"),
    "fact.time": N_("{time:s.3} s"),
    "fact.hours": N_("{duration:h.2} h"),
    "fact.seconds": N_("{duration:s.1} s"),
    "fact.rate": N_("{rate:hz} per second"),
    "fact.geographic": N_("{low:deg.6} to {high:deg.6}°"),
    "fact.angles": N_("{low:deg.4} to {high:deg.4}°"),
    "fact.lengths": N_("{low:m.2} to {high:m.2} m"),
    "fact.fine_lengths": N_("{low:m.3} to {high:m.3} m"),
    "fact.speeds": N_("{low:m.2} to {high:m.2} m/s"),
    "fact.velocities_zero": N_("all zero"),
    "fact.velocities_not_checked": N_("not checked (speed too low)"),
    "fact.velocities_in_no_frame": N_("do not agree with the positions in any known frame"),
    "fact.velocity_axes": N_(
        "{axes} (agree with the positions to {share:percent.1} % of the speed)"
    ),
    "fact.signs": N_("{signs:names} (from the angular rates)"),
    "fact.signs_not_checked": N_("signs could not be checked with the angular rates"),
    # -- assumptions about packets -----------------------------------------------------------------
    "assumed.velodyne_frame": N_(
        "The axes are those of Velodyne: x to the right (azimuth 90°), y forward (azimuth 0°), z "
        "up."
    ),
    "assumed.velodyne_angles": N_(
        "Angles, offsets and firing times of the lasers are those of the manual for the model."
    ),
    "assumed.hour_gprmc": N_(
        "The full hour of the times comes from GPRMC in the position packets (UTC)."
    ),
    "assumed.hour_capture": N_(
        "The full hour of the times comes from the clock of the recording computer, which differs "
        "by {difference:s.1} s from the minutes and seconds of the scanner (UTC)."
    ),
    "assumed.hour_trajectory": N_(
        "The times have no full hour (UTC). It follows from the trajectory if only one fits."
    ),
    # -- assumptions about trajectories ------------------------------------------------------------
    "assumed.applanix": N_(
        "Conventions of Applanix in the file: roll positive starboard down, pitch positive bow up, "
        "true heading = platform heading minus wander angle. In the program and the report, pitch "
        "is positive bow down."
    ),
    "assumed.pof": N_(
        "RIEGL does not publish the format POF. The layout is that of a public reader: degrees, "
        "longitude before latitude."
    ),
    "assumed.heading_less_wander": N_(
        "The true heading is the platform heading minus the wander angle."
    ),
    "assumed.heading_as_is": N_(
        "The platform heading is used as the true heading; the wander angle is not subtracted."
    ),
    "assumed.heading_true": N_("The heading is measured clockwise from true north."),
    "assumed.heading_grid": N_(
        "The heading is measured clockwise from grid north. The meridian convergence is added to "
        "it."
    ),
    "assumed.roll_starboard_down": N_("Roll is positive starboard down."),
    "assumed.roll_port_down": N_(
        "In the file, roll is positive port down. LISPAC reverses its sign when reading it."
    ),
    "assumed.pitch_bow_up": N_(
        "In the file, pitch is positive bow up. In the program and the report, it is positive bow "
        "down."
    ),
    "assumed.pitch_bow_down": N_("Pitch is positive bow down."),
    "assumed.velocity_axes": N_("The axes of the velocities are {axes}."),
    "assumed.fitting_velocity_axes": N_(
        "The axes of the velocities are those that fit the positions best."
    ),
    "assumed.time_base": N_("The times are {base}."),
    "assumed.angles_in_radians": N_("Angles are in radians."),
    "assumed.angles_in_degrees": N_("Angles are in degrees."),
    "assumed.latitude_first": N_("The latitude comes before the longitude."),
    "assumed.longitude_first": N_("The longitude comes before the latitude."),
    "assumed.little_endian": N_("The byte order is little-endian."),
    "assumed.big_endian": N_("The byte order is big-endian."),
    "assumed.ellipsoidal_heights": N_(
        "Heights are ellipsoidal. The file does not specify the datum."
    ),
    "assumed.heights_above_sea": N_(
        "Heights above sea level are used as ellipsoidal heights. Absolute heights are therefore "
        "wrong by the geoid height."
    ),
    "assumed.time_rollover": Plural(
        "The times restart from zero once (at midnight or at the end of the week). A day or a "
        "week is added to the later times.",
        "The times restart from zero {count:n} times (at midnight or at the end of the week). A "
        "day or a week is added to the later times each time.",
    ),
    "assumed.dates_utc": N_("Date and time of day are UTC."),
    "assumed.dates_gps": N_("Date and time of day are GPS time."),
    "assumed.header_columns": N_("{format}: columns and units are read from the header."),
    "assumed.given_columns": N_("The file is text with the columns {columns:names}."),
    "assumed.column_unit": N_("Column {column}: {unit}."),
    "assumed.grid_positions": N_(
        "Eastings and northings are in {system}. Latitude and longitude refer to its datum."
    ),
    "assumed.cidco_positions": N_(
        "Positions are in metres north, west and up from the origin {origin} (deg, deg, m)."
    ),
    "assumed.cidco_attitude": N_(
        "Roll is positive starboard down, pitch is positive bow down, and the heading is clockwise "
        "from north of the local frame. All angles are in radians."
    ),
    "assumed.times_of_points": N_("The times are in the time base of the points."),
    "assumed.constant_accuracy": N_("The POS standard deviations entered are used for all times."),
    "assumed.accuracy": Advised(
        N_(
            "Not all standard deviations of the POS were given; those assumed by the program are "
            "used at all times."
        ),
        N_("Enter them in step 1, or add the accuracy file of the trajectory."),
    ),
    # -- assumptions about points ------------------------------------------------------------------
    "assumed.format": N_("{file}: {format}."),
    "assumed.scanner_frame": N_("Points are in the scanner frame."),
    "assumed.metres_in_scanner_frame": N_("Coordinates are metres in the scanner frame."),
    "assumed.las_time": N_("The time of a point is its LAS field gps_time."),
    "assumed.same_time_base": N_("Points and trajectory have the same time base."),
    "assumed.same_time_base_shifted": N_(
        "After the time shifts are added, points and trajectory have the same time base."
    ),
    "assumed.time_shift": N_("{file}: {shift:s.3+} s are added to the times."),
    "assumed.cidco_columns": N_("The columns are in the order defined by CIDCO."),
    "assumed.scanner_coordinates": N_("The coordinates of the file in the scanner frame are used."),
    "assumed.other_columns_kept": N_(
        "The local coordinates and the POS states are stored as attributes of the points."
    ),
    "assumed.time_stamps_from_scan": N_("Time stamps are seconds since the start of the scan."),
    "assumed.time_stamps_as_they_are": N_("Time stamps are used unchanged."),
    "assumed.time_field": N_("The time is read from the field {field}, in {unit}."),
    "assumed.time_unit": N_("The times are in {unit}."),
    "assumed.waveforms": N_(
        "Waveforms are not read; only the references from the points to their waveforms are read."
    ),
    "assumed.waveforms_mixed_up": N_(
        "In compressed files with several scanner channels, the references from points to their "
        "waveforms may have a wrong size, position and direction."
    ),
    "assumed.cloud_made_with": N_(
        "The cloud was computed with this trajectory, lever arm and boresight and was not adjusted "
        "afterwards."
    ),
    # -- assumptions about coordinate systems ------------------------------------------------------
    "assumed.system": N_("The coordinate system is {system}."),
    "assumed.local_frame": N_("Coordinates are in metres north, west and up in the local frame."),
    "assumed.local_frame_of_cloud": N_("Coordinates are in the local frame of the cloud."),
    "assumed.height_offset": N_("{offset:m.3+} m are added to the heights."),
    "assumed.heights_not_named": N_(
        "The coordinate system has no vertical reference. Heights are assumed to be ellipsoidal."
    ),
    "assumed.height_unit": N_("The unit of heights is {unit}."),
    "assumed.height_unit_as_horizontal": N_(
        "The unit of heights is that of the horizontal coordinates: {unit}."
    ),
    "assumed.datum": N_("The trajectory is in {datum}. No datum transformation is applied."),
    "assumed.datum_shift": N_(
        "The trajectory is in {datum}. The points are transformed from {source} to this datum."
    ),
    # -- assumptions about lists of points ---------------------------------------------------------
    "assumed.columns_as_named": N_("Columns identified by their names: {columns:names}."),
    "assumed.columns_by_order": N_("Columns identified by their order: {columns:names}."),
    "assumed.list_system": N_("The coordinates are in {system}."),
    "list_column.name": N_("name"),
    "list_column.role": N_("role"),
    "list_column.plane": N_("plane"),
    "list_column.sigma": N_("standard deviation"),
    "list_column.sigma_x": N_("standard deviation of the first coordinate"),
    "list_column.sigma_y": N_("standard deviation of the second coordinate"),
    "list_column.sigma_z": N_("standard deviation of the third coordinate"),
    "list_column.unused": N_("not used"),
    "axis.east": N_("east"),
    "axis.north": N_("north"),
    "axis.west": N_("west"),
    "axis.up": N_("up"),
    "axis.longitude": N_("longitude"),
    "axis.latitude": N_("latitude"),
    "axis.height": N_("height"),
    "axis.x": N_("X coordinate"),
    "axis.y": N_("Y coordinate"),
    "axis.z": N_("Z coordinate"),
    "axis.easting": N_("easting"),
    "axis.northing": N_("northing"),
}
