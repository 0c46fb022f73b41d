"""Tests of the parts of the store with unusual input."""

import errno
import hashlib
import os
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac import locks
from lispac.errors import ProjectError
from lispac.messages import error, note
from lispac.survey.store import stored_line
from lispac.survey.store.column_files import map_column
from lispac.survey.store.column_writer import attribute_file_name
from lispac.survey.store.file_times import replace_manifest
from lispac.survey.store.import_lock import LOCK_FILE, is_import_running, lock_folder
from lispac.survey.store.layout import (
    DamagedStore,
    SourceFile,
    StoredColumn,
    has_complete_import,
    read_manifest,
    write_manifest,
    writing_errors_as_project_errors,
)
from lispac.survey.store.line_import import write_store
from lispac.survey.store.original_file import is_original_unchanged, source_file_of
from lispac.survey.store.point_blocks import MAX_POINTS_PER_LINE, PointPiece
from lispac.survey.store.read_ahead import read_ahead
from lispac.survey.store.row_runs import gather_values, rows_of_runs, split_runs
from lispac.survey.store.spatial_cells import is_in_coarse_sample, stable_order
from lispac.survey.store.stored_line import open_store
from tests.support.store_lines import RECIPE, Line, place, reason_code, small, stored

__all__ = ["small"]
pytestmark = pytest.mark.usefixtures("small")


@pytest.mark.parametrize("intensity", ["own", "shared", "none"])
def test_a_line_without_skipped_points_keeps_its_numbers(tmp_path: Path, intensity: str) -> None:
    """Numbers are those of the file; the sample has intensities if the file has them."""
    line = Line(80)
    if intensity == "shared":
        line.extra["intensity"] = np.full(80, 7, np.uint16)
    if intensity == "none":
        del line.extra["intensity"]
    found = stored(tmp_path, line)
    rows = np.arange(80)
    np.testing.assert_array_equal(found.indices_in_file(rows), found.numbers(rows))
    numbers, sample = np.array([5, 2]), found.coarse
    if intensity == "none":
        assert sample.intensity is None
        assert found.intensities(numbers) is None
    else:
        intensity_of_points = line.extra["intensity"]
        np.testing.assert_array_equal(
            sample.intensity, intensity_of_points[found.numbers(sample.rows)]
        )
        np.testing.assert_array_equal(found.intensities(numbers), intensity_of_points[numbers])


def test_all_points_of_a_small_sphere_in_crowded_cells_are_found(tmp_path: Path) -> None:
    """The cells around the small sphere have more points than the limit; the sphere has fewer."""
    found = stored(tmp_path)
    every = place(found.points_lidar.astype(float), found.time)
    centre = every[100]
    off = np.linalg.norm(every - centre, axis=1)
    radius = float(np.sort(off)[3]) + 1e-6
    rows, _, halvings = found.sampled_within(centre, radius, place, margin=20.0, limit=5)
    np.testing.assert_array_equal(rows, np.flatnonzero(off <= radius))
    assert halvings == 0
    rows, _, halvings = found.sampled_within(centre, 30.0, place, limit=50)
    assert 0 < len(rows) <= 50
    assert halvings > 0


def test_a_line_imported_again_during_opening_is_opened_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = stored(tmp_path, Line(80)).manifest
    original_check, again = stored_line.require_file_sizes, iter([True])

    def after_an_import(folder: Path, manifest: object) -> None:
        if next(again, False):
            write_store(folder, RECIPE, Line(500).pieces(900), place)
        original_check(folder, manifest)

    monkeypatch.setattr(stored_line, "require_file_sizes", after_an_import)
    found = open_store(tmp_path, "L1")
    assert len(found) == 500
    assert found.manifest.folder != first.folder


def test_a_newer_manifest_is_not_replaced(tmp_path: Path) -> None:
    old = stored(tmp_path, Line(80)).manifest
    now = stored(tmp_path, Line(90)).manifest
    replace_manifest(tmp_path, old, replace(old, reach=98.0))
    assert read_manifest(tmp_path) == now
    replace_manifest(tmp_path, now, replace(now, reach=99.0))
    assert read_manifest(tmp_path) == replace(now, reach=99.0)


def test_a_column_of_text_is_damage(tmp_path: Path) -> None:
    manifest = stored(tmp_path, Line(80)).manifest
    odd = replace(manifest.attributes[0], dtype="<U4")
    write_manifest(tmp_path, replace(manifest, attributes=(odd, *manifest.attributes[1:])))
    with pytest.raises(DamagedStore, match="<U4") as refused:
        open_store(tmp_path, "L1")
    assert reason_code(refused.value) == "store.column_type"


def test_a_column_of_another_type_than_given_is_damage(tmp_path: Path) -> None:
    np.save(tmp_path / "time.npy", np.zeros(5, np.float32))
    with pytest.raises(ProjectError) as refused:
        map_column(tmp_path, StoredColumn("time", "<f8", file="time.npy", count=5), 5)
    assert reason_code(refused.value) == "store.part_type"
    assert "time.npy" in str(refused.value)
    assert "float32" in str(refused.value)


@pytest.mark.parametrize(
    ("failure", "size", "code", "params"),
    [
        (
            OSError(errno.EFBIG, "File too large"), 3_300_000_000,
            "store.file_too_large_size", {"size": 3_300_000_000},
        ),
        (OSError(errno.EFBIG, "File too large"), None, "store.file_too_large", {}),
        (
            OSError("not as written"), 40_000_000,
            "store.not_read_back", {"reason": "not as written"},
        ),
        (
            OSError(errno.ENOSPC, "No space left"), 40_000_000,
            "store.disk_full_size", {"size": 40_000_000},
        ),
        (OSError(errno.EDQUOT, "Disk quota exceeded"), None, "store.disk_full", {}),
        (
            OSError(errno.EROFS, "Read-only file system"), None,
            "store.not_writable", {"reason": note("system.read_only")},
        ),
    ],
)  # fmt: skip
def test_system_errors_during_writing_have_codes(
    tmp_path: Path, failure: OSError, size: int | None, code: str, params: dict[str, object]
) -> None:
    with (
        pytest.raises(ProjectError) as refused,
        writing_errors_as_project_errors(tmp_path, lambda: size),
    ):
        raise failure
    assert refused.value.code == code
    assert refused.value.message is not None
    assert refused.value.message.params == {"folder": str(tmp_path), **params}


def test_space_needed_by_an_import_is_shown_in_megabytes(tmp_path: Path) -> None:
    with (
        pytest.raises(ProjectError) as refused,
        writing_errors_as_project_errors(tmp_path, lambda: 40_000_000),
    ):
        raise OSError(errno.ENOSPC, "No space left")
    assert " 40.0 MB" in str(refused.value)


def test_a_truncated_block_is_detected(tmp_path: Path) -> None:
    """The block is truncated after its check; the import reports that it cannot be read back."""
    line = Line(4000)

    def cutting(xyz: np.ndarray, time: np.ndarray) -> np.ndarray:
        block = tmp_path / "spool" / "block-00002.columns"
        if block.is_file():
            block.write_bytes(block.read_bytes()[:-40])
        return place(xyz, time)

    with pytest.raises(ProjectError) as refused:
        write_store(tmp_path, RECIPE, line.pieces(1000), cutting)
    assert refused.value.message == error("store.block_cut_short", folder=str(tmp_path), block=2)
    assert len(stored(tmp_path, line)) == 4000


def test_a_file_without_a_point_is_refused_and_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(ProjectError) as refused:
        write_store(tmp_path / "L1", RECIPE, lambda first: iter(()), place)
    assert refused.value.message == error("store.no_points", file="a.las")
    assert not has_complete_import(tmp_path / "L1")
    with pytest.raises(ProjectError) as refused:
        open_store(tmp_path / "L1", "L1")
    assert refused.value.message == error("store.not_imported", line="L1")


def test_too_many_points_to_be_numbered_are_refused(tmp_path: Path) -> None:
    def far_on(first: int) -> Iterator[PointPiece]:
        yield PointPiece(
            np.ones((1, 3)),
            np.zeros(1),
            np.array([MAX_POINTS_PER_LINE]),
            {},
            MAX_POINTS_PER_LINE + 1,
        )

    with pytest.raises(ProjectError) as refused:
        write_store(tmp_path, RECIPE, far_on, place)
    assert refused.value.message == error(
        "store.too_many_points", file="a.las", limit=4_294_967_295
    )


def test_a_lock_whose_file_was_removed_meanwhile_is_acquired_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The previous holder removes the file just after this one has opened it."""
    take, is_removed = locks._lock, iter([True])

    def too_late(handle: int) -> None:
        take(handle)
        if next(is_removed, False):
            (tmp_path / LOCK_FILE).unlink()

    monkeypatch.setattr(locks, "_lock", too_late)
    with lock_folder(tmp_path):
        assert is_import_running(tmp_path)
        with pytest.raises(ProjectError) as refused, lock_folder(tmp_path):
            pass
        assert refused.value.code == "store.locked"
    assert not is_import_running(tmp_path)


def test_a_lock_file_of_an_ended_process_is_not_locked(tmp_path: Path) -> None:
    assert not is_import_running(tmp_path)
    (tmp_path / LOCK_FILE).touch()
    assert not is_import_running(tmp_path)
    with lock_folder(tmp_path):
        assert is_import_running(tmp_path)


def test_the_original_is_identified_by_its_time_or_its_content(tmp_path: Path) -> None:
    path, content = tmp_path / "a.las", bytes(range(256)) * 300
    path.write_bytes(content)
    os.utime(path, ns=(0, 10**18))
    original = source_file_of(path)
    assert original == SourceFile(
        str(path), 76_800, 10**18, hashlib.sha256(content).hexdigest()[:32]
    )
    copy = tmp_path / "copy.las"
    copy.write_bytes(content)
    assert is_original_unchanged(original, copy)
    for changed in (content[:40_000] + b"x" + content[40_001:], content + b"x", content[:-1]):
        copy.write_bytes(changed)
        assert not is_original_unchanged(original, copy)
    # An unchanged size and time are trusted.
    copy.write_bytes(content[::-1])
    os.utime(copy, ns=(5, 10**18))
    assert is_original_unchanged(original, copy)


def test_equal_keys_keep_their_order() -> None:
    keys = np.random.default_rng(4).integers(0, 5, 3000).astype(np.uint64)
    np.testing.assert_array_equal(stable_order(keys), np.lexsort([np.arange(3000), keys]))


def test_a_sample_is_never_larger_than_requested() -> None:
    numbers = np.arange(40)
    assert is_in_coarse_sample(numbers, 40, 40).all()
    assert not is_in_coarse_sample(np.arange(1000), 1000, 0).any()
    many = np.arange(100_000)
    assert 4000 < np.count_nonzero(is_in_coarse_sample(many, 100_000, 5000)) <= 5000


def test_any_iterable_is_read_ahead() -> None:
    assert list(read_ahead(iter([3, 1, 2]), depth=2)) == [3, 1, 2]


def test_no_item_is_lost_with_a_slow_consumer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lispac.survey.store.read_ahead.POLL_INTERVAL_S", 0.001)
    found = []
    for piece in read_ahead(iter(range(5))):
        time.sleep(0.02)  # longer than many polls of the full queue
        found.append(piece)
    assert found == [0, 1, 2, 3, 4]


def test_no_runs_have_no_rows() -> None:
    rows = rows_of_runs(np.zeros((0, 2), dtype=np.int64))
    assert (rows.shape, rows.dtype) == ((0,), np.int64)


def test_file_names_of_columns_are_portable() -> None:
    assert attribute_file_name(3, "Ring / angle é") == "attribute-03-Ring___angle__.npy"
    assert attribute_file_name(12, "a" * 60) == f"attribute-12-{'a' * 40}.npy"


@pytest.mark.parametrize("rows", [1, 7, 64, 1000])
def test_runs_are_split_into_a_number_of_rows(rows: int) -> None:
    ends = np.cumsum(np.random.default_rng(rows).integers(1, 30, 40))
    runs = ends.reshape(-1, 2)
    some = list(split_runs(runs, rows))
    assert [len(rows_of_runs(each)) for each in some[:-1]] == [rows] * (len(some) - 1)
    assert 0 < len(rows_of_runs(some[-1])) <= rows
    np.testing.assert_array_equal(
        np.concatenate([rows_of_runs(each) for each in some]), rows_of_runs(runs)
    )
    assert list(split_runs(runs[:0], rows)) == []


def test_no_runs_have_no_values() -> None:
    none = gather_values(np.arange(12).reshape(4, 3), np.zeros((0, 2), np.int64))
    assert none.shape == (0, 3)
