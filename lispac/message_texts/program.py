"""Texts of messages about the program itself: its folders, other computers."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    "cluster.plain_tcp": N_(
        "The connection to {address} is neither encrypted nor authenticated. Others in the network "
        "can run programs on this computer and on the workers. Use TLS certificates and tls://."
    ),
    "cache.not_writable": N_(
        "{folder} cannot be written, so the cache is kept in {used}. Compiled code, the settings "
        "of the window and recent projects may be lost when the computer restarts. Make the folder "
        "writable, or choose another cache folder in the settings."
    ),
    "cache.folder_not_writable": N_(
        "{folder}: the cache cannot be written here ({reason}). Choose another folder."
    ),
    "cache.not_removed": N_(
        "{folder}: cannot be removed ({reason}). Close other programs that may use it and try "
        "again."
    ),
    "installation.file_missing": N_(
        "{name} is missing from this installation. Install the program again."
    ),
}
