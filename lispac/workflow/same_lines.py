"""Whether two projects rest on the same lines, also where these are copies."""

import hashlib
from functools import lru_cache
from pathlib import Path

from lispac.project import Project


def shared_lines(first: Project, second: Project) -> list[str]:
    """Names of the lines of the second that the first rests on too; a line that is gone is none."""
    sizes: dict[int, list[Path]] = {}
    for line in first.lines:
        size = _size(line.path)
        if size is not None:
            sizes.setdefault(size, []).append(line.path)
    # Only files of one size can be the same: hardly ever is one read for nothing.
    return [
        line.name
        for line in second.lines
        if any(_same(line.path, other) for other in sizes.get(_size(line.path) or -1, ()))
    ]


def same_lines(first: Project, second: Project) -> bool:
    """Whether all lines of the second are those of the first: it adds no information."""
    return len(shared_lines(first, second)) == len(second.lines)


def _same(one: Path, other: Path) -> bool:
    if one.resolve() == other.resolve():
        return True
    try:
        return _digest(one, one.stat().st_mtime_ns) == _digest(other, other.stat().st_mtime_ns)
    except OSError:
        return False


def _size(path: Path) -> int | None:
    try:
        return path.stat().st_size
    except OSError:
        return None


@lru_cache(maxsize=1024)
def _digest(path: Path, _changed: int) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
