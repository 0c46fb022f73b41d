"""Texts of messages about files of trajectories and of their accuracy."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    # -- times -------------------------------------------------------------------------------
    "trajectory.no_time_base": N_(
        "{file}: times from {start:s} to {end:s} s fit no known time base. Check which column or "
        "field contains the time."
    ),
    "trajectory.other_time_base": N_(
        "{file}: times from {start:s} to {end:s} s cannot be in the time base {base}. Choose "
        "{bases:choices}."
    ),
    "trajectory.dates": N_(
        "{file}: the rows contain dates, so the times cannot be in the time base {base}. Choose "
        "unix (UTC) or gps-full (GPS)."
    ),
    # -- values of states --------------------------------------------------------------------
    "trajectory.one_row": N_(
        "{file}: the file has only one row, but a trajectory needs at least two. Export the whole "
        "trajectory."
    ),
    "trajectory.height_in_row": N_(
        "{file}, row {number:n}: a height of {height:m} m is impossible. Check the columns and "
        "their unit."
    ),
    "trajectory.height_in_record": N_(
        "{file}, record {number:n}: a height of {height:m} m is impossible. Check the columns and "
        "their unit."
    ),
    "trajectory.attitude_in_row": N_(
        "{file}, row {number:n}: roll {roll:deg.2}, pitch {pitch:deg.2} and heading "
        "{heading:deg.2}° are impossible. Choose degrees if the angles were read as radians, or "
        "check the columns."
    ),
    "trajectory.attitude_in_record": N_(
        "{file}, record {number:n}: roll {roll:deg.2}, pitch {pitch:deg.2} and heading "
        "{heading:deg.2}° are impossible. Choose degrees if the angles were read as radians, or "
        "check the columns."
    ),
    "trajectory.negative_sigma": N_(
        "{file}, row {row:n}: a standard deviation is negative. Check that the column contains "
        "standard deviations, or export the file again."
    ),
    "trajectory.exchanged_position": N_(
        "{file}, row {row:n}: latitude {latitude:deg.3} and longitude {longitude:deg.3}° are "
        "impossible and may be swapped. Check the order of the two columns."
    ),
    "trajectory.position_in_degrees": N_(
        "{file}, row {row:n}: latitude {latitude:deg.3} and longitude {longitude:deg.3}° are "
        "impossible. The values are in degrees but were read as radians: choose degrees."
    ),
    "trajectory.not_on_earth": N_(
        "{file}, row {row:n}: latitude {latitude:deg.3} and longitude {longitude:deg.3}° are "
        "impossible. Check the columns and their unit."
    ),
    "trajectory.sign_and_hemisphere": N_(
        "{file}, row {row:n}: the {role} has both a minus sign and a hemisphere. Export only one "
        'of them, or name the hemisphere column "-" to ignore it.'
    ),
    # -- columns -----------------------------------------------------------------------------
    "trajectory.no_column": N_(
        "{file}: column {column} is missing. Export it as well, or choose another file."
    ),
    "trajectory.no_columns": N_(
        "{file}: none of the columns of a trajectory is named. Name time, latitude, longitude, "
        "height, roll, pitch and heading."
    ),
    "trajectory.columns_missing": N_(
        "{file}: these columns are missing: {missing:names} (found: {names:names}). Export the "
        "missing columns as well, or name the columns."
    ),
    "trajectory.position_missing": N_(
        "{file}: these columns are missing: {missing:names} (found: {names:names}). Export the "
        "missing columns as well (easting and northing can replace latitude and longitude), or "
        "name the columns."
    ),
    "trajectory.unknown_column": N_(
        '{file}: "{column}" is not a column name. Name the columns from the left with '
        "{known:choices}, and with - for a column that is not used."
    ),
    "trajectory.header_rows": N_(
        '{file}: "{value}" is not a number of header rows. Give a number, or auto.'
    ),
    "trajectory.several_columns": N_(
        "{file}: the {role} is split into several columns ({columns:names}). Export it in one "
        "column, in decimal degrees."
    ),
    "trajectory.unnamed_columns": N_(
        "{file}: the rows have {found:n} columns, but the header names {named:n}. Name the "
        "columns, or export decimal degrees: degrees, minutes and seconds separated by blanks "
        "count as three columns."
    ),
    "trajectory.letter_o": N_(
        "{file}: column {column:n} contains the letter O, which means west in French (ouest) and "
        "east in German (Ost). Name the column eo (O is west) or ow (O is east)."
    ),
    "trajectory.not_an_angle": N_(
        "{file}: according to the header, column {column} has the unit {unit}, but it must be an "
        "angle. Correct the header, or export the file again."
    ),
    "trajectory.not_a_length": N_(
        "{file}: according to the header, column {column} has the unit {unit}, but it must be a "
        "length. Correct the header, or export the file again."
    ),
    "trajectory.unknown_unit": N_(
        '{file}: the unit "{unit}" of column {column} in the header is unknown or ambiguous. '
        "Choose the unit, or correct the header and export the file again."
    ),
    "trajectory.ambiguous_title": N_(
        "{file}: the unit or direction of column {column} in the header is unknown or ambiguous. "
        "Choose the unit, or correct the header and export the file again."
    ),
    "trajectory.negative_west": N_(
        "{file}: according to its title, column {column} is positive to the west, but its values "
        "are negative. Correct the title or the signs and export the file again."
    ),
    "trajectory.negative_south": N_(
        "{file}: according to its title, column {column} is positive to the south, but its values "
        "are negative. Correct the title or the signs and export the file again."
    ),
    # -- coordinate systems ------------------------------------------------------------------
    "trajectory.no_system": N_(
        "{file}: the positions are eastings and northings without a coordinate system. Give the "
        "coordinate system (EPSG:32619 for example)."
    ),
    "trajectory.grid_heading": N_(
        "{file}: a heading from grid north can be used only with eastings, northings and their "
        "coordinate system. Give the coordinate system, or choose a true heading."
    ),
    "trajectory.outside_system": N_(
        "{file}: eastings and northings lie outside the area of {system} ({name}). Give their "
        "coordinate system, and check that they are not swapped."
    ),
    "trajectory.not_projected": N_(
        "{file}: {system} ({name}) is not a projected coordinate system. Give the coordinate "
        "system of the eastings and northings."
    ),
    "trajectory.unusable_system": N_(
        '{file}: the coordinate system "{system}" cannot be used ({reason}). Give an EPSG code '
        "(EPSG:32619 for example)."
    ),
    # -- text of other programs -------------------------------------------------------------
    "trajectory.pospac_header": N_(
        "{file}: the row of column names (TIME, ..., LATITUDE, LONGITUDE, ...) is missing. Export "
        "the file with its header, or choose the generic text format and name the columns."
    ),
    "trajectory.pospac_notation": N_(
        "{file}: {column} is in degrees, minutes and seconds, or in hours. Export decimal degrees "
        "and seconds."
    ),
    "trajectory.inertial_explorer_header": N_(
        "{file}: the row of column names (GPSTime, Latitude, Longitude, H-Ell, ...) is missing. "
        "Export the file with its header, or choose the generic text format and name the columns."
    ),
    "trajectory.not_a_row": N_(
        '{file}, row {row:n}: "{text}" is not a row of numbers. Export the file again.'
    ),
    "trajectory.uneven_row": N_(
        "{file}, row {row:n}: the number of columns differs from that of the header. Export the "
        "file again, with a value or a separator for each column."
    ),
    "trajectory.exail_header": N_(
        "{file}: the row of column names, which starts with #, is missing. Export the file with "
        "its header, or choose the generic text format and name the columns."
    ),
    # -- SBET and smrmsg ---------------------------------------------------------------------
    "trajectory.pof_header": N_(
        "{file}: this file is not a POF with a known header. Export the trajectory from RiPROCESS "
        "as text or SBET."
    ),
    "trajectory.pof_count": N_(
        "{file}: the file has {count:n} records, but its header specifies {expected:n}. Export "
        "the trajectory again."
    ),
    "trajectory.pof_one_record": N_(
        "{file}: the file has only one record, but a trajectory needs at least two. Export the "
        "whole trajectory."
    ),
    "trajectory.pof_not_on_earth": N_(
        "{file}: in record {record:n}, latitude {latitude:deg.3} and longitude {longitude:deg.3}° "
        "are impossible. Export the trajectory from RiPROCESS as text or SBET."
    ),
    "trajectory.pof_unknown_start": N_(
        "{file}: the times count from a start that the file does not specify. Choose the time "
        "base, or export the trajectory with the time of the day or week."
    ),
    "trajectory.pof_gps_assumed": N_(
        "{file}: the file does not specify whether its times are GPS time or UTC. GPS time is "
        "assumed; if this is wrong, choose the other time base."
    ),
    "sbet.not_readable": N_(
        "{file}: this SBET file cannot be read. Check the disk or network drive."
    ),
    "sbet.too_short": N_(
        "{file}: the file has {bytes:n} bytes, less than two SBET records. Export it again."
    ),
    "sbet.one_record": N_(
        "{file}: the file has only one SBET record, but a trajectory needs at least two. Export "
        "the whole trajectory."
    ),
    "sbet.not_degrees": N_(
        "{file}: from SBET record {record:n} on, latitude or longitude is too large for degrees "
        "(up to {largest:x}). Check the unit, and check that the file is an SBET."
    ),
    "sbet.exchanged_position": N_(
        "{file}: from SBET record {record:n} on, latitude or longitude is too large for radians "
        "(up to {largest:x}). They seem to be swapped: choose the order longitude-latitude."
    ),
    "sbet.in_degrees": N_(
        "{file}: from SBET record {record:n} on, latitude or longitude is too large for radians "
        "(up to {largest:x}). The angles seem to be in degrees: choose the unit degrees, or export "
        "the file in radians."
    ),
    "sbet.not_radians": N_(
        "{file}: from SBET record {record:n} on, latitude or longitude is too large for radians "
        "(up to {largest:x}). The file may have another byte order or another format: export it "
        "again."
    ),
    "sbet.big_endian_accuracy": N_(
        "{file}: the numbers are big-endian, but those of smrmsg files are little-endian. Export "
        "the file again with little-endian numbers."
    ),
    "sbet.negative_accuracy": N_(
        "{file}: a standard deviation is negative, so this is not an smrmsg file. Choose another "
        "file."
    ),
    # -- CIDCO binary ------------------------------------------------------------------------
    "cidco.cut_short": N_(
        "{file}: the file size, {bytes:n} bytes, is not a multiple of the point size, {record:n} "
        "bytes (remainder: {rest:n}), so the file is truncated or is not a CIDCO file. Copy or "
        "export it again."
    ),
    "cidco.inconsistent_point": N_(
        "{file}: point {point:n} has impossible values (distance to the POS, angles or standard "
        "deviations), so the file is not a CIDCO file or has another byte order. Export it again."
    ),
    "cidco.different_states": N_(
        "{file}: two points at the time {time:s.6} s have different POS states, so the points do "
        "not belong to one trajectory. Check that all files are from one survey."
    ),
    "cidco.one_state": N_(
        "{file}: the file has only one trajectory state, but a trajectory needs at least two. Add "
        "further files."
    ),
    "cidco.invalid_origin": N_(
        'The origin "{origin}" must be a latitude and longitude in degrees and a height in '
        "metres. Correct the origin, or omit it."
    ),
}
