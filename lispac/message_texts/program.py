"""Texts of messages about the program: its folders, clusters, and errors of the system."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    "cluster.plain_tcp": N_(
        "The connection to {address} is neither encrypted nor authenticated, so other users of the "
        "network can run programs on this computer and on the workers. Use TLS certificates and "
        "tls://."
    ),
    "cache.not_writable": N_(
        "{folder} cannot be written, so the cache (compiled code, window settings, recent "
        "projects) is in {used} and may be lost when the computer restarts. Make the folder "
        "writable, or choose another cache folder in the settings."
    ),
    "cache.folder_not_writable": N_(
        "{folder}: the cache cannot be written here ({reason}). Choose another folder."
    ),
    "cache.not_removed": N_(
        "{folder}: the folder cannot be removed ({reason}). Close other programs that may use it "
        "and try again."
    ),
    "installation.file_missing": N_(
        "{name} is missing from this installation. Install the program again."
    ),
    # -- errors of the system ----------------------------------------------------------------------
    "system.not_found": N_("No such file or directory"),
    "system.input_output": N_("Input/output error"),
    "system.permission": N_("Permission denied"),
    "system.not_a_folder": N_("Not a directory"),
    "system.is_a_folder": N_("Is a directory"),
    "system.disk_full": N_("No space left on device"),
    "system.read_only": N_("Read-only file system"),
    "system.long_name": N_("File name too long"),
    "system.quota": N_("Disk quota exceeded"),
}
