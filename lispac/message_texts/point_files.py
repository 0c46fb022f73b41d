"""Texts of messages about files that cannot be read or written, and about files of points."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- kinds of files ----------------------------------------------------------------------
    "file.kind_line": N_("line"),
    "file.kind_trajectory": N_("trajectory"),
    "file.kind_accuracy": N_("trajectory accuracy"),
    "file.kind_survey": N_("survey"),
    "file.kind_text": N_("text"),
    "file.kind_exail_text": N_("Exail text"),
    "file.kind_pospac_text": N_("POSPac text"),
    "file.kind_cidco": N_("CIDCO binary"),
    "file.kind_las": N_("LAS or LAZ"),
    "file.kind_plane": N_("plane"),
    "file.kind_target": N_("target"),
    "file.kind_target_csv": N_("target CSV"),
    "file.kind_coordinate_list": N_("coordinate list"),
    "file.kind_static_scan": N_("static scan"),
    "file.kind_static_scan_text": N_("static scan text"),
    "file.kind_mesh": N_("mesh"),
    "file.kind_scene": N_("scene"),
    "file.kind_scanner": N_("scanner"),
    "file.kind_vessel": N_("vessel"),
    "file.kind_plan": N_("plan"),
    "file.kind_report_template": N_("report template"),
    "file.kind_logo": N_("logo"),
    "file.kind_certificate": N_("certificate"),
    # -- any file ----------------------------------------------------------------------------
    "file.not_found": N_("{file}: this {kind} file does not exist. Check the path."),
    "file.folder": N_("{file}: this is a folder, not a {kind} file. Choose a file."),
    "file.pipe": N_("{file}: this is a named pipe (FIFO), not a {kind} file. Choose a file."),
    "file.socket": N_("{file}: this is a socket, not a {kind} file. Choose a file."),
    "file.device": N_("{file}: this is a device, not a {kind} file. Choose a file."),
    "file.disk": N_("{file}: this is a disk device, not a {kind} file. Choose a file."),
    "file.no_permission": N_(
        "{file}: there is no permission to read this {kind} file. Check its permissions."
    ),
    "file.empty": N_("{file}: this {kind} file is empty. Copy or export it again."),
    "file.office_document": N_(
        "{file}: this is a spreadsheet or another office document. Save it as text (CSV)."
    ),
    "file.archive": N_(
        "{file}: this is a {format} archive. Extract it and choose the file it contains."
    ),
    "file.compressed": N_(
        "{file}: this file is compressed ({format}). Decompress it and choose the resulting file."
    ),
    "file.not_readable": N_(
        "{file}: cannot be read to its end ({reason}). Check the disk or network drive, and that "
        "no other program writes to the file, or copy it again."
    ),
    "file.damaged": N_("{file}: cannot be read as {kind} ({reason}). Copy or export it again."),
    "file.disk_full": N_(
        "{file}: cannot be written because the disk is full. Make room on the disk, or "
        "choose another folder."
    ),
    "file.not_writable": N_("{file}: cannot be written ({reason}). Choose another folder."),
    "file.coordinate_system": N_("{file}: {reason}"),
    "file.refused": N_("{file}: {reason}"),
    "file.epoch": N_("{epoch} is not a decimal year. Give the date as in this example: 2024.5."),
    # -- records of numbers ------------------------------------------------------------------
    "file.partial_record": N_(
        "{file}: the size of {size:n} bytes is not a whole number of {kind} records of {record:n} "
        "bytes (the last one has {rest:n}). The file is cut short or not {kind}. Copy or export "
        "it again."
    ),
    "file.record_too_large": N_(
        "{file}: {kind} record {record:n} contains a number larger than any quantity of a survey. "
        "Export the file again."
    ),
    "file.record_not_finite": Plural(
        "{file}: {kind} record {record:n} contains NaN or infinity (1 such record). Export the "
        "file again.",
        "{file}: {kind} record {record:n} contains NaN or infinity ({count:n} such records). "
        "Export the file again.",
    ),
    "file.time_steps_record": N_(
        "{file}: from {kind} record {record:n} on, times are in steps of {step:s} s, as if they "
        "had been stored with 32 bits. Export the file with 64-bit times."
    ),
    "file.time_steps_row": N_(
        "{file}: from row {row:n} on, times are in steps of {step:s} s, as if they had been stored "
        "with 32 bits. Export the file with 64-bit times."
    ),
    "file.time_order_record": N_(
        "{file}: times do not increase at {kind} record {record:n} ({before:s.6} s, then "
        "{after:s.6} s). Repeated times: {repeated:n}, decreasing times: {backward:n}, of "
        "{total:n}. Sort the file or export it again."
    ),
    "file.time_order_row": N_(
        "{file}: times do not increase at row {row:n} ({before:s.6} s, then {after:s.6} s). "
        "Repeated times: {repeated:n}, decreasing times: {backward:n}, of {total:n}. Sort the file "
        "or export it again."
    ),
    # -- points of any format ----------------------------------------------------------------
    "file.no_points": N_("{file}: this file contains no points. Exclude it from the survey."),
    "file.points_missing": N_(
        "{file}: the header counts {header:n} points, but the file ends after {held:n}. It is cut "
        "short. Copy or export it again."
    ),
    "file.points_no_room": N_(
        "{file}: the header counts {header:n} points, but the file has room for {room:n} only. It "
        "is cut short. Copy or export it again."
    ),
    "file.point_not_numbers": N_(
        '{file}: point {point:n} is "{text}", but the header specifies {values:n} numbers. Copy or '
        "export the file again."
    ),
    "file.points_not_usable": Plural(
        "{file}: point {point:n} has a coordinate or time that is not a usable number (1 such "
        "point up to here). Clean the file or export it again.",
        "{file}: point {point:n} has a coordinate or time that is not a usable number ({count:n} "
        "such points up to here). Clean the file or export it again.",
    ),
    "file.points_byte_order": N_(
        "{file}: point {point:n} has a coordinate or time that is not a usable number ({count:n} "
        "such points up to here). The byte order may be another one than the file specifies. Clean "
        "the file or export it again."
    ),
    "file.no_coordinates": N_(
        "{file}: the points have no {axes:names} (fields: {fields:names}). Export them with "
        "coordinates and time."
    ),
    "file.no_such_field": N_(
        "{file}: there is no field {field}. Choose one of its fields: {fields:names}."
    ),
    "file.several_values": N_(
        "{file}: the field {field} has more than one value per point and cannot be the time. "
        "Choose another field."
    ),
    "file.no_time": N_(
        "{file}: no field contains a time (fields: {fields:names}), so the points cannot be placed "
        "on the trajectory. Export the points with time, or name the field."
    ),
    "file.time_32_bits": N_(
        "{file}: times around {time:s.0} s are stored with 32 bits, in steps of {step:s} s. This "
        "is too coarse to place points on the trajectory. Export them with 64-bit times."
    ),
    "file.one_time": N_(
        "{file}: {count:n} points share the time {time:s.6} s, so the file was written without "
        "times. Export it with the time of each point."
    ),
    # -- LAS and LAZ -------------------------------------------------------------------------
    "las.signature": N_(
        "{file}: this is not LAS or LAZ, because it does not begin with LASF. Check what it is, or "
        "export it again."
    ),
    "las.header": N_(
        "{file}: the LAS header does not fit the file size of {size:n} bytes. Copy or export the "
        "file again."
    ),
    "las.no_gps_time": N_(
        "{file}: point format {format:n} has no GPS time, so the points cannot be placed on the "
        "trajectory. Export the line with GPS time."
    ),
    "las.local_frame": N_(
        "{file}: this cloud is in the local frame of a project (north, west, up), and its origin "
        "is not in the file. To use it as a line, export it again, or export it with a coordinate "
        "system."
    ),
    "las.not_finite": Plural(
        "{file}: point {point:n} has a coordinate or time that is NaN or infinity (1 such point). "
        "Clean the file or export it again.",
        "{file}: point {point:n} has a coordinate or time that is NaN or infinity ({count:n} such "
        "points). Clean the file or export it again.",
    ),
    "las.too_far": N_(
        "{file}: points lie more than {limit:n} units from the trajectory, too far to be stored "
        "with the others. Remove them from the line."
    ),
    "las.value_too_large": N_(
        "{file}: the column {column} contains {value:n}, but the largest value in LAS is "
        "{limit:n}. Correct it in the source."
    ),
    "las.waveform_channels": N_(
        "{file}: LAZ would lose the waveform data of points from several scanner channels (point "
        "format {format:n}). Write LAS instead."
    ),
    "las.not_writable": N_(
        "{file}: cannot be written ({reason}). The incomplete file is removed. Make room on the "
        "disk, or choose another folder."
    ),
    # -- E57 ---------------------------------------------------------------------------------
    "e57.not_supported": N_(
        "{file}: E57 cannot be read on this system, for which pye57 is not available. Convert the "
        "file to LAZ."
    ),
    "e57.header": N_(
        "{file}: this is not E57, or its header is damaged. Check what it is, or copy it again."
    ),
    "e57.size": N_(
        "{file}: the E57 header specifies {header:n} bytes, but the file has {size:n}. It is cut "
        "short or damaged. Copy or export it again."
    ),
    "e57.points_not_counted": N_(
        "{file}: a scan counts {header:n} points but contains {held:n}. Only the points that are "
        "counted can be read. Export the file again."
    ),
    "e57.points_missing": N_(
        "{file}: a scan counts {header:n} points but contains {held:n}. Copy or export the file "
        "again."
    ),
    "e57.different_fields": N_(
        "{file}: the scans have different fields. Export each scan to a file of its own."
    ),
    "e57.no_time": N_(
        "{file}: the points have no timeStamp (fields: {fields:names}), so they cannot be placed "
        "on the trajectory. Export them with time stamps."
    ),
    "e57.no_start": N_(
        "{file}: the scans do not specify when they started. Use the time stamps as they are "
        "(option time_from: zero)."
    ),
    "e57.no_coordinates": N_("{file}: the points have no coordinates. Export the file again."),
    "e57.pose": N_(
        "{file}: the pose of a scan is not a rotation (length of its quaternion: {norm:x.3}). Copy "
        "or export the file again."
    ),
    # -- PCD ---------------------------------------------------------------------------------
    "pcd.header": N_(
        "{file}: this is not PCD, or its header is damaged. Check what it is, or copy it again."
    ),
    "pcd.header_incomplete": N_(
        "{file}: the PCD header has no {entries:names}, so it is damaged. Export the file again."
    ),
    "pcd.header_damaged": N_(
        "{file}: the PCD header is damaged ({reason}). Export the file again."
    ),
    "pcd.data_kind": N_(
        "{file}: the PCD data type {kind} is not known. Export the file as ascii, binary or "
        "binary_compressed."
    ),
    "pcd.field_type": N_(
        "{file}: the PCD header is damaged (field {field} of type {type}, size {size}, count "
        "{number}). Export the file again."
    ),
    "pcd.duplicate_field": N_(
        "{file}: the PCD header is damaged (two fields have the same name). Export the file again."
    ),
    "pcd.point_count": N_(
        "{file}: the PCD header is damaged (number of points: {header:n}). Export the file again."
    ),
    "pcd.compressed_size": N_(
        "{file}: the compressed points do not fit the {header:n} points that the header counts "
        "(file size: {size:n} bytes). Copy or export the file again."
    ),
    "pcd.compressed_damaged": N_(
        "{file}: the compressed points are damaged. Copy or export the file again."
    ),
    # -- PLY ---------------------------------------------------------------------------------
    "ply.header": N_(
        "{file}: this is not PLY, or its header is damaged. Check what it is, or copy it again."
    ),
    "ply.no_format": N_(
        "{file}: the PLY header does not specify a format. Copy or export the file again."
    ),
    "ply.format": N_(
        "{file}: the PLY format {format} is not known. Export the file as ascii, "
        "binary_little_endian or binary_big_endian."
    ),
    "ply.no_vertices": N_("{file}: this PLY file has no vertices. Export it with points."),
    "ply.count": N_(
        '{file}: the PLY header is damaged (number of elements: "{text}"). Copy or export the file '
        "again."
    ),
    "ply.property_type": N_(
        "{file}: {element} has the property {property} of type {type}, which points cannot have. "
        "Export points only, without faces."
    ),
    "ply.property_without_type": N_(
        "{file}: {element} has the property {property} without a type. Export the file again."
    ),
    "ply.duplicate_property": N_(
        "{file}: {element} has two properties named {property}. Export the file again."
    ),
    "ply.no_properties": N_("{file}: {element} has no properties. Export the file again."),
    # -- PTS ---------------------------------------------------------------------------------
    "pts.points_missing": N_(
        "{file}: the file ends after point {held:n} of the {points:n} that row {head:n} counts, so "
        "it is cut short. Copy or export it again."
    ),
    "pts.count_expected": N_(
        "{file}, row {row:n}: this row should be a number of points, because the block that begins "
        "in row {head:n} ends above it (points in the block: {points:n}). Copy or export the file "
        "again."
    ),
    "pts.no_count": N_(
        "{file}, row {row:n}: a PTS file begins with its number of points, but this row is "
        '"{text}". Export the file again, or rename a text file of x, y, z to .txt.'
    ),
    "pts.early_count": N_(
        "{file}, row {row:n}: a new number of points follows after {held:n} of the {points:n} "
        "points that row {head:n} counts. Copy or export the file again."
    ),
    "pts.separators": N_(
        "{file}, row {row:n}: this row contains commas or semicolons, but PTS has decimal points, "
        "and blanks between columns. Export the file again."
    ),
    "pts.columns": Plural(
        "{file}, row {row:n}: 1 column, but {width:n} are needed. Copy or export the file again.",
        "{file}, row {row:n}: {count:n} columns, but {width:n} are needed. Copy or export the file "
        "again.",
    ),
    # -- meshes ------------------------------------------------------------------------------
    "mesh.damaged": N_(
        "{file}: this mesh file is damaged and cannot be read. Export the mesh again."
    ),
    "mesh.format": N_(
        "{file}: the format of this mesh file is not known. Export the mesh as PLY, OBJ or STL."
    ),
    "mesh.no_triangles": N_(
        "{file}: this file contains no triangles. Export the mesh, not its points."
    ),
    "mesh.missing_vertex": N_(
        "{file}: a triangle refers to a vertex that is not in the file. Export the mesh again."
    ),
    "mesh.not_finite": N_("{file}: a vertex contains NaN or infinity. Export the mesh again."),
    "mesh.no_area": N_("{file}: all triangles have zero area. Export the mesh again."),
    "mesh.vertex": N_(
        '{file}: row {row:n} is not a valid vertex ("{text}"). Export the mesh again.'
    ),
    "mesh.face": N_('{file}: row {row:n} is not a valid face ("{text}"). Export the mesh again.'),
}
