"""Texts of messages about imported lines in the project folder (`lispac.survey.store`)."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    # -- import ------------------------------------------------------------------------------
    "store.link": N_(
        "{folder}: this is a link to another folder, and the program does not write into linked "
        "folders. Replace the link by a folder, or save the project elsewhere."
    ),
    "store.locked": N_(
        "{folder}: this line is already being imported. Wait until the import has finished, or "
        "stop it."
    ),
    "store.no_points": N_("{file}: this file contains no usable points. Exclude the line."),
    "store.too_many_points": N_(
        "{file}: a line cannot have more than {limit:n} points. Split the file."
    ),
    "store.attribute": N_(
        "{file}: the attribute {attribute} cannot be imported, because it is not one number per "
        "point. Export the line without this attribute."
    ),
    "store.attributes_change": N_(
        "{file}: from point {point:n} on, the points have different attributes "
        "({attributes:names}). Import these points as a separate line."
    ),
    "store.attribute_types_change": N_(
        "{file}: from point {point:n} on, the attributes have different data types. Import these "
        "points as a separate line."
    ),
    "store.disk_full": N_(
        "{folder}: the disk is full. Free some disk space or move the project to a larger disk, "
        "then import the line again."
    ),
    "store.disk_full_size": N_(
        "{folder}: the disk is full; the import needs about {size:mb} MB. Free some disk space or "
        "move the project to a larger disk, then import the line again."
    ),
    "store.file_too_large": N_(
        "{folder}: the files of this line are larger than this disk allows. Move the project to a "
        "disk that allows large files, then import the line again."
    ),
    "store.file_too_large_size": N_(
        "{folder}: the files of this line (about {size:mb} MB) are larger than this disk allows. "
        "Move the project to a disk that allows large files, then import the line again."
    ),
    "store.not_read_back": N_(
        "{folder}: data written by the import cannot be read back ({reason}). Check the disk, then "
        "import the line again."
    ),
    "store.block_cut_short": N_(
        "{folder}: data written by the import cannot be read back (block {block:n} is truncated). "
        "Check the disk, then import the line again."
    ),
    "store.points_lost": N_(
        "{folder}: data written by the import cannot be read back ({read:n} of {points:n} points). "
        "Check the disk, then import the line again."
    ),
    "store.not_writable": N_(
        "{folder}: the line cannot be stored in this folder ({reason}). Choose a writable project "
        "folder, then import the line again."
    ),
    # -- opening an imported line ------------------------------------------------------------
    "store.not_imported": N_("{line}: this line has not been imported. Import it first."),
    "store.interrupted": N_(
        "{line}: the import of this line was interrupted. Import it again; the import continues "
        "where it stopped."
    ),
    "store.being_imported": N_(
        "{line}: another window or command is importing this line. Wait until the import has "
        "ended, then try again."
    ),
    "store.imported_again": N_(
        "{line}: another window or command has imported this line again since it was opened. Open "
        "the project again."
    ),
    "store.newer_version": N_(
        "{file}: this line was imported by a newer version of the program. Update the program."
    ),
    "store.part_not_readable": N_(
        "{file}: this file of an imported line cannot be read ({reason}). Check the disk, or "
        "import the line again."
    ),
    "store.import_again": N_("{reason} Import the line again."),
    # -- reasons to import a line again ------------------------------------------------------
    "store.other_line": N_(
        "{folder}: this folder contains the imported line {found} instead of line {line}."
    ),
    "store.manifest_damaged": N_("{file}: the imported line is damaged ({reason})."),
    "store.manifest_checksum": N_("{file}: the imported line is damaged (wrong checksum)."),
    "store.manifest_values": N_("{file}: the imported line is damaged (impossible values)."),
    "store.column_type": N_("{file}: the imported line is damaged (unknown column type {type})."),
    "store.part_missing": N_("{file}: this file of the imported line {line} is missing."),
    "store.part_size": N_(
        "{file}: this file of the imported line {line} has {size:n} bytes instead of {expected:n}."
    ),
    "store.part_damaged": N_("{file}: this file of an imported line is damaged ({reason})."),
    "store.part_type": N_(
        "{file}: this file of an imported line is damaged (data type {type}, array shape {shape})."
    ),
    "store.part_changed": N_(
        "{file}: this file of an imported line has changed since the import (wrong checksum)."
    ),
    "store.values": N_(
        "{line}: the imported line contains impossible values, so its files were changed after the "
        "import."
    ),
}
