"""Modification times of the files of a store, to detect changes without reading.

The modification time of a file that was changed or copied differs from that in the manifest. Only
in this case, the store is read completely when it is opened, and compared with its checksums. If
they agree, the new times are stored, so that the check is made only once.
"""

from dataclasses import replace
from pathlib import Path

from lispac.errors import ProjectError
from lispac.survey.store.import_lock import lock_folder
from lispac.survey.store.layout import (
    Manifest,
    StoredColumn,
    read_manifest,
    require_no_link,
    write_manifest,
)


def with_file_times(folder: Path, manifest: Manifest) -> Manifest:
    """Manifest with the current modification times of its files (`OSError` if one is missing)."""

    def with_time(column: StoredColumn) -> StoredColumn:
        if not column.file:
            return column
        path = folder / manifest.folder / column.file
        return replace(column, modified=path.stat().st_mtime_ns)

    return replace(
        manifest,
        columns=tuple(with_time(column) for column in manifest.columns),
        attributes=tuple(with_time(column) for column in manifest.attributes),
    )


def replace_manifest(folder: Path, old: Manifest, new: Manifest) -> None:
    """Replace the manifest ``old`` by ``new`` unless the line was imported again meanwhile."""
    try:
        require_no_link(folder, folder.parent)
        with lock_folder(folder):
            if read_manifest(folder) == old:
                write_manifest(folder, new)
    except (OSError, ProjectError):
        return  # a read-only folder is checked each time it is opened
