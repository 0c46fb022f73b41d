"""Lines for tests of the store, and progress functions that cancel an import."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import Cancelled, LispacError
from lispac.messages import Message
from lispac.progress import Progress, Step
from lispac.survey.store import column_files, column_writer, point_blocks, spool
from lispac.survey.store.layout import Manifest, SourceFile
from lispac.survey.store.line_import import ImportRecipe, write_store
from lispac.survey.store.point_blocks import PointPiece
from lispac.survey.store.stored_line import StoredLine, open_store

ORIGINAL = SourceFile("a.las", 1, 2, "c")
RECIPE = ImportRecipe("L1", ORIGINAL, {}, {})


def place(xyz: np.ndarray, time: np.ndarray) -> np.ndarray:
    """Georeference points of a vessel that moves straight ahead with 1 m/s."""
    local = np.array(xyz)
    local[:, 0] += time
    return local


@dataclass(eq=False)
class Line:
    """A wall and a quay along the course of the vessel; some points of the file have no pose."""

    count: int
    seed: int = 3
    far_point: bool = False
    xyz: np.ndarray = field(default=None)  # type: ignore[assignment]

    def __post_init__(self) -> None:
        rng = np.random.default_rng(self.seed)
        n = self.count
        self.time = np.linspace(0.0, 20.0, n)
        if self.xyz is None:
            self.xyz = np.column_stack(
                [rng.normal(0, 0.01, n), rng.uniform(5, 20, n), rng.uniform(0, 3, n)]
            )
            self.xyz[1::2, 1] = 20 + rng.normal(0, 0.01, n // 2)
            self.xyz[1::2, 2] = rng.uniform(3, 12, n // 2)
            if self.far_point:  # beyond the grid cells
                self.xyz[::50] *= rng.uniform(1, 5000, (len(self.xyz[::50]), 1))
        # Every tenth point after a hundred has no pose.
        self.index = np.arange(n) + np.maximum(0, np.arange(n) - 100) // 9
        self.extra = {
            "intensity": rng.integers(0, 65536, n).astype(np.uint16),
            "return_number": np.ones(n, np.uint8),
            "flight": (np.arange(n) // 2500).astype(np.int64) - 2**62,  # one in a block, or two
            "rgb": rng.integers(0, 256, (n, 3)).astype(np.uint8),
            "colour mode": np.full((n, 2), -0.5),
            "Größe/δ": np.where(rng.random(n) < 0.1, np.nan, rng.normal(0, 1, n)).astype("<f4"),
            "synthetic": rng.random(n) < 0.5,
        }

    def __len__(self) -> int:
        return self.count

    def pieces(self, size: int) -> "Source":
        """Points of the line in chunks."""
        return Source(self, size)


class Source:
    """Reader of the points of a line from an index on, which records the requested indices."""

    def __init__(self, line: Line, size: int) -> None:
        self._line, self._size, self.requested = line, size, []

    def __call__(self, first: int) -> Iterator[PointPiece]:
        """The points from an index of the file on."""
        self.requested.append(first)
        line, end = self._line, int(self._line.index[-1]) + 1
        for start in range(first, end, self._size):
            read = min(end, start + self._size)
            rows = slice(*np.searchsorted(line.index, [start, read]))
            extra = {name: values[rows] for name, values in line.extra.items()}
            yield PointPiece(line.xyz[rows], line.time[rows], line.index[rows], extra, read, end)


def stop_at(call: int) -> Progress:
    """Progress function that cancels at the call with this number, counted from 0."""
    calls = 0

    def progress(fraction: float, step: Step | None = None) -> None:
        nonlocal calls
        if calls == call:
            raise Cancelled
        calls += 1

    return progress


LINE = Line(6_300)


def stored(folder: Path, line: Line = LINE, size: int = 900) -> StoredLine:
    """Import the line in pieces of a size."""
    write_store(folder, RECIPE, line.pieces(size), place)
    return open_store(folder, "L1")


def files_of(manifest: Manifest) -> dict[str, int]:
    """Checksum of every file."""
    return {column.file: column.checksum for column in manifest.files}


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make blocks, buckets and coarse level small, so that a few thousand points are large."""
    for module in (point_blocks, spool):
        monkeypatch.setattr(module, "BLOCK_POINTS", 1000)
    monkeypatch.setattr(column_writer, "BUCKET_POINTS", 700)
    monkeypatch.setattr(column_writer, "KEY_SAMPLING_STEP", 16)
    monkeypatch.setattr(column_writer, "MAX_COARSE_POINTS", 1500)
    monkeypatch.setattr(column_files, "WINDOW_VALUES", 2048)


def reason_code(error: LispacError) -> str:
    """Code of the reason for which a line has to be imported again."""
    assert error.code == "store.import_again"
    assert error.message is not None
    reason = error.message.params["reason"]
    assert isinstance(reason, Message)
    return reason.code
