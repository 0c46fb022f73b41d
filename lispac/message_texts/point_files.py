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
    "file.kind_inertial_explorer_text": N_("Inertial Explorer text"),
    "file.kind_cidco": N_("CIDCO binary"),
    "file.kind_las": N_("LAS or LAZ"),
    "file.kind_capture": N_("packet capture"),
    "file.kind_plane": N_("plane"),
    "file.kind_target": N_("target"),
    "file.kind_target_csv": N_("target CSV"),
    "file.kind_coordinate_list": N_("coordinate list"),
    "file.kind_correspondences": N_("point correspondences"),
    "file.kind_static_scan": N_("static scan"),
    "file.kind_static_scan_text": N_("static scan (text file)"),
    "file.kind_mesh": N_("mesh"),
    "file.kind_scene": N_("scene description"),
    "file.kind_scanner": N_("scanner description"),
    "file.kind_vessel": N_("vessel description"),
    "file.kind_plan": N_("survey plan"),
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
        "{file}: you do not have permission to read this {kind} file. Check its permissions."
    ),
    "file.empty": N_("{file}: this {kind} file is empty. Copy or export it again."),
    "file.office_document": N_(
        "{file}: this is a spreadsheet or another office document. Save it as text (CSV) and "
        "choose the text file."
    ),
    "file.archive": N_(
        "{file}: this is a {format} archive. Extract it and choose the file it contains."
    ),
    "file.compressed": N_(
        "{file}: this file is compressed ({format}). Decompress it and choose the resulting file."
    ),
    "file.not_readable": N_(
        "{file}: the file cannot be read to its end ({reason}). Check the disk or network drive "
        "and that no other program is writing to the file, or copy it again."
    ),
    "file.damaged": N_(
        "{file}: the file cannot be read as {kind} ({reason}). Copy or export it again."
    ),
    "file.disk_full": N_(
        "{file}: the file cannot be written because the disk is full. Free some disk space, or "
        "choose another folder."
    ),
    "file.not_writable": N_(
        "{file}: the file cannot be written ({reason}). Choose another folder."
    ),
    "file.coordinate_system": N_("{file}: {reason}"),
    "file.refused": N_("{file}: {reason}"),
    "file.epoch": N_("{epoch} is not a decimal year. Give the date as in this example: 2024.5."),
    # -- records of numbers ------------------------------------------------------------------
    "file.partial_record": N_(
        "{file}: the file size, {size:n} bytes, is not a multiple of the {kind} record size, "
        "{record:n} bytes (remainder: {rest:n}), so the file is truncated or is not {kind}. Copy "
        "or export it again."
    ),
    "file.record_too_large": N_(
        "{file}: {kind} record {record:n} contains an impossibly large number. Export the file "
        "again."
    ),
    "file.record_not_finite": Plural(
        "{file}: {kind} record {record:n} contains NaN or infinity. Export the file again.",
        "{file}: {count:n} {kind} records contain NaN or infinity, the first is record "
        "{record:n}. Export the file again.",
    ),
    "file.time_steps_record": N_(
        "{file}: from {kind} record {record:n} on, the times have a resolution of only {step:s} s, "
        "as if they had been stored with 32 bits. Export the file with 64-bit times."
    ),
    "file.time_steps_row": N_(
        "{file}: from row {row:n} on, the times have a resolution of only {step:s} s, as if they "
        "had been stored with 32 bits. Export the file with 64-bit times."
    ),
    "file.time_order_record": N_(
        "{file}: the times do not increase at {kind} record {record:n} ({before:s.6} s, then "
        "{after:s.6} s), with {repeated:n} repeated and {backward:n} decreasing times among "
        "{total:n}. Sort the file or export it again."
    ),
    "file.time_order_row": N_(
        "{file}: the times do not increase at row {row:n} ({before:s.6} s, then {after:s.6} s), "
        "with {repeated:n} repeated and {backward:n} decreasing times among {total:n}. Sort the "
        "file or export it again."
    ),
    # -- points of any format ----------------------------------------------------------------
    "file.no_points": N_("{file}: this file contains no points. Exclude it from the survey."),
    "file.points_missing": N_(
        "{file}: the file ends after {held:n} of the {header:n} points given in its header, so it "
        "is truncated. Copy or export it again."
    ),
    "file.points_no_room": N_(
        "{file}: the size of the file allows only {room:n} of the {header:n} points given in its "
        "header, so it is truncated. Copy or export it again."
    ),
    "file.point_not_numbers": N_(
        '{file}: the row of point {point:n} is "{text}", but the header specifies {values:n} '
        "numbers per point. Copy or export the file again."
    ),
    "file.points_not_usable": Plural(
        "{file}: the coordinates or the time of point {point:n} are not usable numbers (1 such "
        "point so far). Correct the file or export it again.",
        "{file}: the coordinates or the time of point {point:n} are not usable numbers ({count:n} "
        "such points so far). Correct the file or export it again.",
    ),
    "file.points_byte_order": N_(
        "{file}: the coordinates or the time of point {point:n} are not usable numbers ({count:n} "
        "such points so far), perhaps because the specified byte order is wrong. Correct the file "
        "or export it again."
    ),
    "file.no_coordinates": N_(
        "{file}: the points have no coordinates {axes:names} (fields: {fields:names}). Export them "
        "with coordinates and time."
    ),
    "file.no_such_field": N_(
        "{file}: there is no field {field}. Choose one of its fields: {fields:names}."
    ),
    "file.several_values": N_(
        "{file}: the field {field} has more than one value per point and cannot be the time. "
        "Choose another field."
    ),
    "file.no_time": N_(
        "{file}: no field contains a time (fields: {fields:names}), so the points cannot be "
        "assigned to the trajectory. Export the points with time, or name the field."
    ),
    "file.time_32_bits": N_(
        "{file}: times around {time:s.0} s are stored with 32 bits, and their resolution of "
        "{step:s} s is too coarse to assign the points to the trajectory. Export them with 64-bit "
        "times."
    ),
    "file.one_time": N_(
        "{file}: {count:n} points have the same time, {time:s.6} s, so the file was written "
        "without times. Export it with the time of each point."
    ),
    # -- LAS and LAZ -------------------------------------------------------------------------
    "las.signature": N_(
        "{file}: this is not a LAS or LAZ file, because it does not begin with LASF. Check the "
        "file type, or export the file again."
    ),
    "las.header": N_(
        "{file}: the LAS header does not fit the file size of {size:n} bytes. Copy or export the "
        "file again."
    ),
    "las.no_gps_time": N_(
        "{file}: point format {format:n} has no GPS time, so the points cannot be assigned to the "
        "trajectory. Export the line with GPS time."
    ),
    "las.local_frame": N_(
        "{file}: this cloud is in the local frame of a project (north, west, up), and its origin "
        "is not in the file. To use it as a line, export it with a coordinate system."
    ),
    "las.too_far": N_(
        "{file}: points lie more than {limit:n} units from the trajectory and cannot be stored in "
        "a LAS file with the others. Remove them from the line."
    ),
    "las.value_too_large": N_(
        "{file}: the column {column} contains {value:n}, but the largest value in LAS is "
        "{limit:n}. Correct the source file."
    ),
    "las.waveform_channels": N_(
        "{file}: LAZ would lose the waveform data of points from several scanner channels (point "
        "format {format:n}). Write LAS instead."
    ),
    "las.not_writable": N_(
        "{file}: the file cannot be written ({reason}), and the incomplete file is removed. Free "
        "some disk space, or choose another folder."
    ),
    # -- E57 ---------------------------------------------------------------------------------
    "e57.not_supported": N_(
        "{file}: E57 files cannot be read on this computer, because the package pye57 is not "
        "available for it. Convert the file to LAZ."
    ),
    "e57.header": N_(
        "{file}: this is not an E57 file, or its header is damaged. Check the file type, or copy "
        "the file again."
    ),
    "e57.size": N_(
        "{file}: the file has {size:n} bytes instead of the {header:n} given in its E57 header, so "
        "it is truncated or damaged. Copy or export it again."
    ),
    "e57.points_not_counted": N_(
        "{file}: a scan contains {held:n} points, of which only the {header:n} given in the header "
        "can be read. Export the file again."
    ),
    "e57.points_missing": N_(
        "{file}: according to the header a scan has {header:n} points, but it contains only "
        "{held:n}. Copy or export the file again."
    ),
    "e57.different_fields": N_(
        "{file}: the scans have different fields. Export each scan to a file of its own."
    ),
    "e57.no_time": N_(
        "{file}: the points have no timeStamp field (fields: {fields:names}), so they cannot be "
        "assigned to the trajectory. Export them with time stamps."
    ),
    "e57.no_start": N_(
        "{file}: the start times of the scans are not specified. Use the time stamps unchanged "
        "(option time_from: zero)."
    ),
    "e57.no_coordinates": N_("{file}: the points have no coordinates. Export the file again."),
    "e57.pose": N_(
        "{file}: the pose of a scan is not a rotation (norm of its quaternion: {norm:x.3} instead "
        "of 1). Copy or export the file again."
    ),
    # -- packet captures ---------------------------------------------------------------------
    "capture.header": N_(
        "{file}: this is not a packet capture (PCAP or PCAPNG), or its header is damaged. Check "
        "the file type, or copy the file again."
    ),
    "capture.record_size": N_(
        "{file}: the capture is damaged (a record of {size:n} bytes). Copy the file again."
    ),
    "capture.cut": N_(
        "{file}: the capture ends within a packet after {size:n} bytes, so it is cut. Copy the "
        "file again, or save its complete packets with Wireshark."
    ),
    "velodyne.no_packets": N_(
        "{file}: the first packets of the capture contain no data of a Velodyne scanner. Check "
        "the file, or export the points of another scanner as LAS."
    ),
    "velodyne.model": N_(
        "{file}: packets of the model {model} cannot be decoded (known models: {models:names}). "
        "Export the points as LAS."
    ),
    "velodyne.returns": N_(
        "{file}: packets with the return mode {mode} cannot be decoded. Export the points as LAS."
    ),
    "velodyne.several_models": N_(
        "{file}: the packets from one address are of several models ({models:names}). Save the "
        "packets of each scanner in a file of its own."
    ),
    "velodyne.no_gprmc": N_(
        "{file}: the first packets contain no GPRMC sentence with a valid position. Choose "
        "another source of the hour (hour_from)."
    ),
    "velodyne.no_date": N_(
        "{file}: the packets have no date of the recording computer. Choose another source of the "
        "hour (hour_from)."
    ),
    "velodyne.clock_set": N_(
        "{file}: the clock of the scanner was set by {step:s.3} s during the recording, so the "
        "times before are wrong. Save the packets after that in a file of their own."
    ),
    # -- PCD ---------------------------------------------------------------------------------
    "pcd.header": N_(
        "{file}: this is not a PCD file, or its header is damaged. Check the file type, or copy "
        "the file again."
    ),
    "pcd.header_incomplete": N_(
        "{file}: the PCD header is damaged (missing entries: {entries:names}). Export the file "
        "again."
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
        "{file}: the size of the compressed points does not match the {header:n} points of the "
        "header (file size: {size:n} bytes). Copy or export the file again."
    ),
    "pcd.compressed_damaged": N_(
        "{file}: the compressed points are damaged. Copy or export the file again."
    ),
    # -- PLY ---------------------------------------------------------------------------------
    "ply.header": N_(
        "{file}: this is not a PLY file, or its header is damaged. Check the file type, or copy "
        "the file again."
    ),
    "ply.no_format": N_(
        "{file}: the PLY header does not specify a format. Copy or export the file again."
    ),
    "ply.format": N_(
        "{file}: the PLY format {format} is not known. Export the file as ascii, "
        "binary_little_endian or binary_big_endian."
    ),
    "ply.no_vertices": N_("{file}: this PLY file has no vertices. Export the file with points."),
    "ply.count": N_(
        '{file}: the PLY header is damaged (number of elements: "{text}"). Copy or export the file '
        "again."
    ),
    "ply.property_type": N_(
        "{file}: the PLY element {element} has the property {property} of type {type}, which is "
        "not allowed for points. Export points only, without faces."
    ),
    "ply.property_without_type": N_(
        "{file}: the PLY element {element} has the property {property} without a type. Export the "
        "file again."
    ),
    "ply.duplicate_property": N_(
        "{file}: the PLY element {element} has two properties named {property}. Export the file "
        "again."
    ),
    "ply.no_properties": N_(
        "{file}: the PLY element {element} has no properties. Export the file again."
    ),
    # -- PTS ---------------------------------------------------------------------------------
    "pts.points_missing": N_(
        "{file}: the file ends after point {held:n} of the {points:n} given in row {head:n}, so it "
        "is truncated. Copy or export it again."
    ),
    "pts.count_expected": N_(
        "{file}, row {row:n}: a number of points is expected here, because the block that begins "
        "in row {head:n} is complete (points in the block: {points:n}). Copy or export the file "
        "again."
    ),
    "pts.no_count": N_(
        "{file}, row {row:n}: a PTS file begins with its number of points, but this row is "
        '"{text}". Export the file again, or, if it is plain text with x, y, z, rename it to '
        ".txt."
    ),
    "pts.early_count": N_(
        "{file}, row {row:n}: a new number of points appears after only {held:n} of the {points:n} "
        "points given in row {head:n}. Copy or export the file again."
    ),
    "pts.separators": N_(
        "{file}, row {row:n}: this row contains commas or semicolons, but a PTS file must have "
        "decimal points and columns separated by blanks. Export the file again."
    ),
    "pts.columns": Plural(
        "{file}, row {row:n}: the row has 1 column, but {width:n} are needed. Copy or export the "
        "file again.",
        "{file}, row {row:n}: the row has {count:n} columns, but {width:n} are needed. Copy or "
        "export the file again.",
    ),
    # -- meshes ------------------------------------------------------------------------------
    "mesh.damaged": N_(
        "{file}: this mesh file is damaged and cannot be read. Export the mesh again."
    ),
    "mesh.faces_missing": N_(
        "{file}: the file header specifies {expected:n} faces, but only {count:n} can be read, so "
        "part of the scene is missing. Export the mesh again."
    ),
    "mesh.no_end": N_(
        "{file}: the file does not end with “endsolid”, so part of the scene is missing. Export "
        "the mesh again."
    ),
    "mesh.format": N_(
        "{file}: the format of this mesh file is not known. Export the mesh as PLY, OBJ or STL."
    ),
    "mesh.no_triangles": N_(
        "{file}: this file contains no triangles. Export the mesh instead of its points."
    ),
    "mesh.missing_vertex": N_(
        "{file}: a triangle refers to a vertex that is not in the file. Export the mesh again."
    ),
    "mesh.not_finite": N_("{file}: a vertex contains NaN or infinity. Export the mesh again."),
    "mesh.too_far": N_(
        "{file}: a vertex is more than {limit:km.0} km from the origin. Export the mesh again."
    ),
    "mesh.no_area": N_("{file}: all triangles have zero area. Export the mesh again."),
    "mesh.vertex": N_(
        '{file}: row {row:n} is not a valid vertex ("{text}"). Export the mesh again.'
    ),
    "mesh.face": N_('{file}: row {row:n} is not a valid face ("{text}"). Export the mesh again.'),
}
