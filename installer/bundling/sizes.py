"""Table of the disk space used by each part of a bundle."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

SMALL_PART_BYTES = 2e6
"""Size in bytes below which parts are summed in one row of the table."""


def by_part(folder: Path) -> dict[str, int]:
    """Size in bytes of each part of a bundle: programs, packages with libraries, other files.

    A file with several hard links is counted once; symbolic links are not counted.
    """
    sizes: dict[str, int] = {}
    seen: set[tuple[int, int]] = set()
    for place, _folders, files in os.walk(folder):
        for file in files:
            path = Path(place) / file
            state = path.lstat()
            if path.is_symlink() or (state.st_ino and (state.st_dev, state.st_ino) in seen):
                continue
            seen.add((state.st_dev, state.st_ino))
            parts = path.relative_to(folder).parts
            inside = parts[1:] if parts[0] == "_internal" else parts
            name = inside[0].removesuffix(".libs") if len(inside) > 1 else inside[0]
            if len(inside) == 1 and parts[0] == "_internal" and not name.startswith("libpython"):
                name = "system libraries"
            sizes[name] = sizes.get(name, 0) + state.st_size
    return sizes


def table(sizes: Mapping[str, int]) -> list[str]:
    """Lines of a table in megabytes: large parts in descending order, all others, and the sum."""
    large = sorted(
        (item for item in sizes.items() if item[1] >= SMALL_PART_BYTES), key=lambda item: -item[1]
    )
    rest = [item for item in sizes.items() if item[1] < SMALL_PART_BYTES]
    rows = [(name, size) for name, size in large]
    if rest:
        rows.append((f"{len(rest)} smaller parts", sum(size for _name, size in rest)))
    rows.append(("whole", sum(sizes.values())))
    return [f"{name:<28}{size / 1e6:8.1f} MB" for name, size in rows]
