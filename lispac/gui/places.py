"""Where files of the user's own are proposed."""

from pathlib import Path

from PySide6.QtCore import QStandardPaths

from lispac.caches import cache_place
from lispac.installed import home_folder


def kept(folder: Path) -> Path:
    """The folder, or the user's documents where it is in the cache, which may be emptied."""
    if not folder.is_relative_to(cache_place()):
        return folder
    documents = QStandardPaths.StandardLocation.DocumentsLocation
    return Path(QStandardPaths.writableLocation(documents) or home_folder())
