"""Detection of projects on the same lines, also as copies of the files."""

import hashlib
from functools import lru_cache
from pathlib import Path

from lispac.project import Project


def shared_lines(first: Project, second: Project) -> list[str]:
    """Names of the lines of the second project that are also lines of the first."""
    sizes: dict[int, list[Path]] = {}
    for line in first.lines:
        size = _file_size(line.path)
        if size is not None:
            sizes.setdefault(size, []).append(line.path)
    # Only files of the same size can be equal, so that hardly any file is read without need.
    return [
        line.name
        for line in second.lines
        if any(
            _is_same_file(line.path, other) for other in sizes.get(_file_size(line.path) or -1, ())
        )
    ]


def has_same_lines(first: Project, second: Project) -> bool:
    """True if all lines of the second project are lines of the first."""
    return len(shared_lines(first, second)) == len(second.lines)


def _is_same_file(one: Path, other: Path) -> bool:
    if one.resolve() == other.resolve():
        return True
    try:
        return _file_digest(one, one.stat().st_mtime_ns) == _file_digest(
            other, other.stat().st_mtime_ns
        )
    except OSError:
        return False


def _file_size(path: Path) -> int | None:
    try:
        return path.stat().st_size
    except OSError:
        return None


@lru_cache(maxsize=1024)
def _file_digest(path: Path, _changed: int) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
