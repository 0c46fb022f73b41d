"""Modification times of the files of a store: detect changes without reading the files.

A file that was written to has another time than the manifest says, whatever its size; so has a
copy. Only such a store is read and compared by its checksums on opening, and only once: where they
hold, the times are remembered.
"""

from dataclasses import replace
from pathlib import Path

from lispac.errors import ProjectError
from lispac.survey.store.layout import (
    Column,
    Manifest,
    read_manifest,
    require_no_link,
    write_manifest,
)
from lispac.survey.store.lock import locked


def stamped(folder: Path, manifest: Manifest) -> Manifest:
    """The manifest with the times that its files have now (`OSError`)."""

    def with_time(column: Column) -> Column:
        if not column.file:
            return column
        path = folder / manifest.folder / column.file
        return replace(column, modified=path.stat().st_mtime_ns)

    return replace(
        manifest,
        columns=tuple(with_time(column) for column in manifest.columns),
        attributes=tuple(with_time(column) for column in manifest.attributes),
    )


def remember(folder: Path, old: Manifest, new: Manifest) -> None:
    """Put ``new`` in the place of ``old``, where nobody has imported the line meanwhile."""
    try:
        require_no_link(folder, folder.parent)
        with locked(folder):
            if read_manifest(folder) == old:
                write_manifest(folder, new)
    except (OSError, ProjectError):
        return  # a folder that may only be read is checked whenever it is opened
