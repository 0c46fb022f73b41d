"""Check whether the file from which a line was imported is unchanged."""

import os
from hashlib import file_digest
from pathlib import Path

from lispac.survey.store.layout import SourceFile


def source_file_of(path: Path) -> SourceFile:
    """Size, time and fingerprint of a file (`OSError` if it cannot be read)."""
    status = path.stat()
    return SourceFile(str(path), status.st_size, status.st_mtime_ns, _file_fingerprint(path))


def is_original_unchanged(original: SourceFile, path: Path) -> bool:
    """Whether the file at ``path`` is the imported one; it may have been moved or copied.

    A file with the same size and time is assumed to be unchanged. If the time differs, as after a
    copy, the whole content is compared, since an edited file may have the same size.
    """
    status = os.stat(path)
    if status.st_size != original.size:
        return False
    return (
        status.st_mtime_ns == original.modified or _file_fingerprint(path) == original.fingerprint
    )


def _file_fingerprint(path: Path) -> str:
    with path.open("rb") as file:
        return file_digest(file, "sha256").hexdigest()[:32]
