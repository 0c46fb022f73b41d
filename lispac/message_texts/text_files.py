"""Texts of messages about files of text, lists of target coordinates, static scans, plane files."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    # -- formats and their options -----------------------------------------------------------
    "formats.unknown": N_("There is no format {format}. Choose {formats:choices}."),
    "formats.unknown_option": N_("{format} has no option {option}. Omit the option."),
    "formats.invalid_choice": N_(
        "{format}: the option {option} cannot be {value}. Choose {choices:choices}."
    ),
    # -- lines of any format -----------------------------------------------------------------
    "line.no_points": N_("{file}: this line contains no points. Exclude it."),
    "line.no_usable_time": N_(
        "{file}: none of the points that were checked has a usable time. Export the line again."
    ),
    # -- any text ----------------------------------------------------------------------------
    "text.empty": N_("{file}: the file is empty. Export it again."),
    "text.not_text": N_(
        "{file}, row {row:n}: the content is not text. Choose the format of the file."
    ),
    "text.not_read_to_end": N_(
        "{file}: the file cannot be read to its end ({reason}). Check the disk or network drive."
    ),
    "text.utf16": N_("{file}: the text is encoded in UTF-16. Export or save it as UTF-8."),
    "text.not_for_csv": N_(
        '{file}: "{text}" contains a comma, a quotation mark or a line break, which is not '
        "allowed in this CSV file. Change this name."
    ),
    # -- columns -----------------------------------------------------------------------------
    "text.columns_not_named": N_(
        "{file}: the file has no column names. Name the columns from the left; time, x, y and z "
        "are required."
    ),
    "text.columns_missing": N_(
        "{file}: these columns are missing in the given column names: {missing:names} (given: "
        "{names:names}). Name every column of the file from the left."
    ),
    "text.duplicate_columns": N_(
        "{file}: more than one column has the name {names:choices}. Give each name once."
    ),
    "text.no_rows": N_(
        "{file}: the file has no rows of data. Check the separator and the number of header rows, "
        "or export the file again."
    ),
    "text.no_number_rows": N_(
        "{file}: no row contains four or more numbers, so this is not a text file of points. "
        "Choose the format of the file, or export it again with times in seconds or as hh:mm:ss "
        "without a date."
    ),
    "text.no_rows_of_points": N_(
        "{file}: this is not a text file with one point in each row. Choose the format of the "
        "file, or export it again."
    ),
    "text.not_numbers": N_(
        "{file}: the rows cannot be read as numbers ({reason}). Export the file again."
    ),
    "text.not_a_number": N_(
        '{file}, row {row:n}: {column} is "{value}", which is not a number. Check the column names '
        "given, or export the file again."
    ),
    "text.not_a_clock_time": N_(
        '{file}, row {row:n}: {column} is "{value}", but the times in the rows above are in '
        "hh:mm:ss. Export the file again with all times in the same form."
    ),
    "text.unusable_value": N_(
        '{file}, row {row:n}: {column} is "{value}", which is not a usable value. Check the column '
        "names given, or export the file again."
    ),
    "text.row_too_short": N_(
        "{file}, row {row:n}: the row has {found:n} columns, but {needed:n} were named "
        "({names:names}). Copy or export the file again if the row is truncated, or name only the "
        "columns that the file has."
    ),
    "text.too_few_columns": N_(
        "{file}, row {row:n}: the row has {found:n} columns, but at least {needed:n} are needed. "
        "Copy or export the file again if the row is truncated, or correct the given column names."
    ),
    "text.uneven_row": N_(
        "{file}, row {row:n}: the row has {found:n} columns, but the header has {needed:n}. Export "
        "the file again."
    ),
    "text.not_a_target": N_(
        "{file}: the first row does not have the column names of an exported target. Export the "
        "target again."
    ),
    # -- units of columns --------------------------------------------------------------------
    "text.several_units": N_(
        "{file}: the column titles do not specify one common unit of length for x, y and z "
        "({titles:names}). Export them in one unit, or set the unit (option unit)."
    ),
    "text.not_degrees": N_(
        "{file}: column {column} is not in degrees positive to the east or north. Export longitude "
        "and latitude in such degrees."
    ),
    "text.polar_coordinates": N_(
        "{file}: the points are in polar coordinates ({columns:names}). Export x, y and z in the "
        "scanner frame."
    ),
    # -- lists of target coordinates ---------------------------------------------------------
    "seeds.no_coordinates": N_(
        "{file}: the file has no row of coordinates. Write each target as a row of name, x, y, z."
    ),
    "seeds.only_names": N_(
        "{file}: the row of column names is not followed by rows of coordinates. Export the list "
        "again."
    ),
    "seeds.too_many_rows": N_(
        "{file}: the file has more than {most:n} rows, so it is not a list of targets. Keep only "
        "the rows of targets."
    ),
    "seeds.other_axes": N_(
        "{file}: the local frame (north, west, up) has no axis {names:choices}. Give the "
        "coordinate system of the list."
    ),
    "seeds.other_axes_in_row": N_(
        "{file}, row {row:n}: the local frame (north, west, up) has no axis {names:choices}. Give "
        "the coordinate system of the list."
    ),
    "seeds.columns_missing": N_(
        "{file}: these columns are missing: {names:names}. Name the columns from the left, for "
        "example name, x, y, z, with - for a column that is not used."
    ),
    "seeds.columns_missing_in_row": N_(
        "{file}, row {row:n}: these columns are missing: {names:names}. Name the columns from the "
        "left, for example name, x, y, z, with - for a column that is not used."
    ),
    "seeds.duplicate_columns": N_(
        "{file}: more than one column has the name {names:choices}. Name the columns from the "
        "left, for example name, x, y, z, with - for a column that is not used."
    ),
    "seeds.duplicate_columns_in_row": N_(
        "{file}, row {row:n}: more than one column has the name {names:choices}. Name the columns "
        "from the left, for example name, x, y, z, with - for a column that is not used."
    ),
    "seeds.too_few_numbers": N_(
        "{file}, row {row:n}: only {found:n} of {total:n} columns are numbers, but three "
        "coordinates are needed. Insert a row of column names (name, x, y, z) at the top, or name "
        "the columns."
    ),
    "seeds.order_unclear": N_(
        "{file}, row {row:n}: {found:n} of {total:n} columns are numbers, so it is unclear which "
        "of them are x, y and z. Insert a row of column names (name, x, y, z) at the top, or name "
        "the columns."
    ),
    "seeds.hemispheres": N_(
        "{file}: column {column:n} contains hemispheres ({letters:names}), but they can be read "
        "only as part of the values. Write the hemisphere after each value (48.5N), or use signs."
    ),
    "seeds.not_an_angle": N_(
        "{file}: column {column} must be an angle in a known unit. Export the list again with the "
        "correct title or values."
    ),
    "seeds.not_a_length": N_(
        "{file}: column {column} must be a length in a known unit. Export the list again with the "
        "correct title or values."
    ),
    "seeds.row_too_short": N_(
        "{file}, row {row:n}: the row has {found:n} columns, but {needed:n} are needed "
        "({names:names}). Complete the row or remove it."
    ),
    "seeds.unusable_coordinate": N_(
        '{file}, row {row:n}: {axis} is "{value}", which is not a usable coordinate. Correct the '
        "row or remove it."
    ),
    "seeds.invalid_name": N_("{file}, row {row:n}: {reason}"),
    "seeds.unknown_role": N_(
        '{file}, row {row:n}: there is no role "{role}". Give target or validation (T or V), or '
        "leave the role empty."
    ),
    "seeds.invalid_sigma": N_(
        '{file}, row {row:n}: the standard deviation is "{value}", but it must be a number of '
        "metres, zero or more. Correct the row."
    ),
    "seeds.duplicate_name": N_(
        "{file}, row {row:n}: the name {name} is already in row {other:n}. Give each target a name "
        "of its own."
    ),
    "seeds.duplicate_place": N_(
        "{file}, row {row:n}: these coordinates are already in row {other:n}. List each target "
        "once."
    ),
    # -- static scans ------------------------------------------------------------------------
    "static_scan.other_format": N_(
        "{file}: this format cannot be read as a static scan. Export the scan as LAS, LAZ, E57, "
        "PTS or text (x, y, z)."
    ),
    "static_scan.no_points": N_("{file}: the static scan contains no points. Export it again."),
    "static_scan.unusable_coordinate": N_(
        "{file}: a coordinate of point {point:n} is not a usable number. Correct the static scan "
        "or export it again."
    ),
    "static_scan.no_coordinates": N_(
        "{file}: the file has no row of coordinates. Write each point as a row of x, y, z."
    ),
    "static_scan.too_few_coordinates": N_(
        "{file}, row {row:n}: three coordinates are needed. Insert a row of column names with x, y "
        "and z at the top."
    ),
    "static_scan.decimal_commas": N_(
        "{file}, row {row:n}: the numbers have decimal commas. Export the static scan with decimal "
        "points."
    ),
    # -- plane files -------------------------------------------------------------------------
    "planes.none_given": N_("No plane file was given. Give at least one."),
    "planes.not_numbers": N_(
        "{file}: this is not a plane file with {columns:n} columns of numbers ({reason}). Export "
        "the plane again."
    ),
    "planes.no_points": N_("{file}: the plane file contains no points. Exclude it."),
    "planes.other_columns": N_(
        "{file}: a plane file must have {columns:n} columns, but this file has {found:n}. Export "
        "the plane again."
    ),
    "planes.not_finite": N_(
        "{file}, row {row:n}: a value is NaN or infinite. Export the plane again."
    ),
    "planes.normal_length": N_(
        "{file}: the normal vector of the plane (columns 21 to 23) has length {length:x.4} instead "
        "of 1. Export the plane again."
    ),
}
