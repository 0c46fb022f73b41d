"""Folders that are proposed for files of the user."""

from pathlib import Path

from PySide6.QtCore import QStandardPaths

from lispac.caches import usable_cache_folder
from lispac.installation_paths import home_folder


def folder_outside_cache(folder: Path) -> Path:
    """The folder, or the user's documents if it lies in the cache, which may be emptied."""
    if not folder.is_relative_to(usable_cache_folder()):
        return folder
    documents = QStandardPaths.StandardLocation.DocumentsLocation
    return Path(QStandardPaths.writableLocation(documents) or home_folder())
