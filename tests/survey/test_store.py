"""Tests of the store for large lines: contents, searches, and resumed imports."""

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from lispac.errors import Cancelled, ProjectError
from lispac.geometry.rotations import rotation_matrix
from lispac.survey.scan import Scan
from lispac.survey.store import column_writer, point_blocks, spatial_cells, spool
from lispac.survey.store.fingerprint import combine_crc32
from lispac.survey.store.layout import Manifest, SourceFile, write_manifest
from lispac.survey.store.line_import import ImportRecipe, write_store
from lispac.survey.store.row_runs import rows_of_runs
from lispac.survey.store.stored_line import StoredLine, open_store
from tests.support.long_runs import others_long
from tests.support.store_lines import (
    LINE,
    ORIGINAL,
    RECIPE,
    Line,
    files_of,
    place,
    small,
    stop_at,
    stored,
)

__all__ = ["small"]
pytestmark = pytest.mark.usefixtures("small")


def test_every_point_is_stored_once_with_all_its_columns(tmp_path: Path) -> None:
    found = stored(tmp_path / "L1")
    numbers = found.numbers(np.arange(len(found)))
    np.testing.assert_array_equal(np.sort(numbers), np.arange(len(LINE)))
    np.testing.assert_array_equal(found.rows(numbers), np.arange(len(LINE)))
    np.testing.assert_array_equal(found.time, LINE.time[numbers])
    np.testing.assert_array_equal(found.points_lidar, LINE.xyz[numbers].astype(np.float32))
    np.testing.assert_array_equal(found.indices_in_file(np.arange(7)), LINE.index[numbers[:7]])
    assert list(found.extra) == list(LINE.extra)
    for name, values in LINE.extra.items():
        assert found.extra[name].dtype == values.dtype, name
        np.testing.assert_array_equal(found.extra[name], values[numbers], name)
    assert found.intensity is found.extra["intensity"]
    assert found.manifest.excluded_points == LINE.index[-1] + 1 - len(LINE)
    found.require_sound()
    assert sorted(path.name for path in (tmp_path / "L1").iterdir()) == ["columns-1", "store.json"]


def test_the_manifest_has_the_extent_of_the_line(tmp_path: Path) -> None:
    line = Line(2_500)
    line.time = np.random.default_rng(2).permutation(line.time)
    manifest = stored(tmp_path, line).manifest
    local = place(line.xyz, line.time)
    assert manifest.low == tuple(local.min(axis=0))
    assert manifest.high == tuple(local.max(axis=0))
    assert (manifest.first_time, manifest.last_time) == (0.0, 20.0)
    assert manifest.reach == pytest.approx(np.linalg.norm(line.xyz, axis=1).max(), rel=1e-12)
    assert manifest.points == 2_500


def test_the_progress_counts_the_points_read_and_ordered(tmp_path: Path) -> None:
    steps: list[tuple[float, str]] = []
    write_store(
        tmp_path, RECIPE, LINE.pieces(1000), place,
        progress=lambda done, step=None: steps.append((done, str(step or ""))),
    )  # fmt: skip
    done = [part for part, _ in steps]
    assert done == sorted(done)
    reading = [(part, words) for part, words in steps if words.startswith("Reading L1")]
    whole = LINE.index[-1] + 1
    assert [part for part, _ in reading] == pytest.approx(
        [0.6 * min(1.0, 1000 * k / whole) for k in range(1, len(reading) + 1)]
    )
    assert reading[0][1] == f"Reading L1: 1,000 of {whole:,} points"
    ordering = [words for _, words in steps if words.startswith("Sorting the points of L1: ")]
    assert ordering[0] == "Sorting the points of L1: 0 of 6,300 points"
    assert steps[-1] == (1.0, "Sorting the points of L1: writing to disk")


def test_fingerprint_is_that_of_the_points_in_memory(tmp_path: Path) -> None:
    """Sightings of a project made from the file still refer to the same points."""
    assert stored(tmp_path).fingerprint == Scan(LINE.xyz, LINE.time).fingerprint


def test_coordinates_are_rounded_by_less_than_eight_micrometres(tmp_path: Path) -> None:
    far = replace(LINE, xyz=np.random.default_rng(1).uniform(-140, 140, LINE.xyz.shape))
    found = stored(tmp_path, far)
    off = np.abs(found.points_lidar - far.xyz[found.numbers(np.arange(len(far)))])
    assert off.max() < 8e-6


@pytest.mark.parametrize("size", [1, 7, 333, 1000, 5000, 10**6])
def test_store_does_not_depend_on_the_size_of_pieces(tmp_path: Path, size: int) -> None:
    line = Line(2_300)
    one = stored(tmp_path / "one", line, 450).manifest
    other = stored(tmp_path / "other", line, size).manifest
    assert files_of(one) == files_of(other)


def test_constant_columns_take_no_space(tmp_path: Path) -> None:
    manifest = stored(tmp_path).manifest
    without = {column.name for column in manifest.attributes if not column.file}
    assert without == {"return_number", "colour mode"}


def test_columns_have_the_smallest_sufficient_type(tmp_path: Path) -> None:
    manifest = stored(tmp_path).manifest
    assert {c.name: (c.dtype, c.shape) for c in manifest.columns} == {
        "xyz": ("<f4", (3,)), "time": ("<f8", ()), "number": ("<u4", ()), "before": ("<u4", ()),
        "row": ("<u4", ()), "octaves": ("<u8", ()), "starts": ("<u8", ()),
        "coarse_row": ("<u4", ()), "coarse_local": ("<f8", (3,)), "coarse_xyz": ("<f4", (3,)),
        "coarse_time": ("<f8", ()), "coarse_intensity": ("<u2", ()),
    }  # fmt: skip
    for column in manifest.files:
        values = np.prod(column.shape, dtype=int) * column.count
        assert column.size == 128 + values * np.dtype(column.dtype).itemsize
        assert column.size == (tmp_path / manifest.folder / column.file).stat().st_size
    assert manifest.bytes == sum(column.size for column in manifest.files)


def test_points_are_ordered_by_cell_in_few_runs(tmp_path: Path) -> None:
    found = stored(tmp_path)
    local = place(found.points_lidar.astype(float), found.time)
    side = found.manifest.side
    keys = spatial_cells.order_keys(local, found.numbers(np.arange(len(found))), side)
    # A coordinate rounded to float32 may fall into the neighbouring cell.
    assert np.count_nonzero(np.diff(keys.astype(np.int64)) < 0) <= 3


@settings(max_examples=60, deadline=None)
@given(centre=st.tuples(*(st.floats(-30, 60),) * 3), radius=st.floats(0.01, 30), far=st.booleans())
def test_points_in_a_region_equal_those_of_brute_force(
    region: StoredLine, centre, radius, far
) -> None:
    centre = np.array(centre) * (1000 if far else 1)
    rows, local = region.within(centre, radius, place)
    every = place(region.points_lidar.astype(float), region.time)
    expected = np.flatnonzero(((every - centre) ** 2).sum(axis=1) <= radius**2)
    np.testing.assert_array_equal(rows, expected)
    np.testing.assert_array_equal(local, every[expected])
    runs = region.near(centre, radius)
    assert (np.diff(runs.ravel()) > 0).all()


@settings(max_examples=40, deadline=None)
@given(
    centre=st.tuples(*(st.floats(-10, 40),) * 3), radius=st.floats(0.5, 8),
    turn=st.tuples(*(st.floats(-0.05, 0.05),) * 3),
)  # fmt: skip
def test_points_in_a_region_with_another_boresight(
    region: StoredLine, centre, radius, turn
) -> None:
    rotation = rotation_matrix(*turn)
    angle = np.arccos(np.clip((np.trace(rotation) - 1) / 2, -1, 1))
    margin = 2 * np.sin(angle / 2) * region.manifest.reach + 1e-6

    def turned(xyz: np.ndarray, time: np.ndarray) -> np.ndarray:
        return place(xyz @ rotation.T, time)

    every = turned(region.points_lidar.astype(float), region.time)
    expected = np.flatnonzero(((every - np.array(centre)) ** 2).sum(axis=1) <= radius**2)
    rows, _ = region.within(np.array(centre), radius, turned, margin=margin)
    np.testing.assert_array_equal(rows, expected)


@pytest.fixture(scope="module")
def region(tmp_path_factory) -> StoredLine:
    """A stored line that tests only read."""
    return stored(tmp_path_factory.mktemp("region") / "L1", Line(4_000, far_point=True))


def test_a_small_region_reads_few_points(tmp_path: Path) -> None:
    found = stored(tmp_path, Line(40_000))
    runs = found.near(np.array([10.0, 20.0, 3.0]), 1.0)
    rows, _ = found.within(np.array([10.0, 20.0, 3.0]), 1.0, place)
    assert 0 < len(rows) <= (runs[:, 1] - runs[:, 0]).sum() < 0.1 * len(found)


def test_coarse_level_is_an_even_sample(tmp_path: Path) -> None:
    line = Line(30_000)
    found = stored(tmp_path, line)
    coarse = found.coarse
    assert (
        0.85 * column_writer.MAX_COARSE_POINTS < len(coarse.rows) <= column_writer.MAX_COARSE_POINTS
    )
    np.testing.assert_array_equal(coarse.points_lidar, found.points_lidar[coarse.rows])
    np.testing.assert_array_equal(coarse.time, found.time[coarse.rows])
    np.testing.assert_array_equal(coarse.intensity, found.intensity[coarse.rows])
    local = place(coarse.points_lidar.astype(float), coarse.time)
    np.testing.assert_array_equal(coarse.points_local, local)
    assert is_fair(coarse.time, line.time)
    assert is_fair(local[:, 1], place(line.xyz, line.time)[:, 1])


@pytest.mark.parametrize("halvings", [1, 3])
def test_beginning_of_every_cell_is_an_even_sample(tmp_path: Path, halvings: int) -> None:
    line = Line(30_000)
    found = stored(tmp_path, line)
    runs = found.near(np.zeros(3), 1e6, halvings=halvings)
    rows = rows_of_runs(runs)
    assert abs(len(rows) / len(line) - 0.5**halvings) < 0.01
    assert is_fair(found.time[rows], line.time)
    assert is_fair(found.points_lidar[rows, 1], line.xyz[:, 1])
    every = found.near(np.zeros(3), 1e6)
    np.testing.assert_array_equal(every, [[0, len(line)]])
    assert len(runs) <= len(np.unique(found._octaves >> np.uint64(4))), "one run a cell"


def is_fair(sample: np.ndarray, whole: np.ndarray) -> bool:
    """Test whether the sample is distributed over the range like the whole."""
    edges = np.quantile(whole, np.linspace(0, 1, 21))
    edges[0], edges[-1] = -np.inf, np.inf
    counts = np.histogram(sample, edges)[0]
    expected = len(sample) / 20
    return bool(
        ((counts - expected) ** 2 / expected).sum() < 45
    )  # chi square with 19 degrees of freedom, 99.93 %


def test_points_of_one_cell_are_never_all_in_memory(tmp_path: Path, monkeypatch) -> None:
    """A stationary vessel: half of the points of a cell share one octave."""
    line = Line(9_000)
    line.xyz[:] = [1.2, 2.2, 3.2] + np.random.default_rng(0).normal(0, 1e-3, line.xyz.shape)
    line.time[:] = np.linspace(0, 1e-3, len(line))
    sizes = []
    merged = column_writer.merge_blocks

    def watched(source: spool.Spool) -> Iterator:
        for keys, values in merged(source):
            sizes.append(len(keys))
            yield keys, values

    monkeypatch.setattr(column_writer, "merge_blocks", watched)
    found = stored(tmp_path, line)
    assert max(sizes) <= column_writer.BUCKET_POINTS + point_blocks.BLOCK_POINTS
    assert len(np.unique(found._octaves >> np.uint64(4))) == 1
    np.testing.assert_array_equal(np.sort(found.numbers(np.arange(9_000))), np.arange(9_000))
    rows = rows_of_runs(found.near(np.zeros(3), 100.0, halvings=3))
    assert is_fair(found.time[rows], line.time)


def test_cells_are_larger_for_sparse_points(tmp_path: Path) -> None:
    sparse = Line(3_000)
    sparse.xyz *= 30
    assert stored(tmp_path, sparse).manifest.side > 2.0


@pytest.mark.parametrize("when", others_long(range(0, 24, 3), lambda when: when % 6 == 0))
def test_cancelled_import_is_resumed(tmp_path: Path, when: int) -> None:
    whole = stored(tmp_path / "whole").manifest
    folder = tmp_path / "L1"
    with pytest.raises(Cancelled):
        write_store(folder, RECIPE, LINE.pieces(300), place, progress=stop_at(when))
    with pytest.raises(ProjectError) as refused:
        open_store(folder, "L1")
    assert refused.value.code == "store.interrupted"
    assert not list(folder.glob("columns-*")), "columns that are not whole are gone"
    blocks = len(list((folder / "spool").glob("*.json"))) - 1
    source = LINE.pieces(300)
    write_store(folder, RECIPE, source, place)
    if when > 22:
        assert not source.requested, "all of it was spooled: the file is not read again"
    else:
        assert source.requested == [LINE.index[1000 * blocks - 1] + 1 if blocks else 0]
    assert files_of(open_store(folder, "L1").manifest) == files_of(whole)


def test_a_damaged_block_is_read_again(tmp_path: Path) -> None:
    whole = stored(tmp_path / "whole").manifest
    folder = tmp_path / "L1"
    with pytest.raises(Cancelled):
        write_store(folder, RECIPE, LINE.pieces(1000), place, progress=stop_at(6))
    block = folder / "spool" / "block-00002.columns"
    content = bytearray(block.read_bytes())
    content[77] ^= 1
    block.write_bytes(content)
    source = LINE.pieces(1000)
    write_store(folder, RECIPE, source, place)
    assert source.requested == [LINE.index[1999] + 1]
    assert files_of(open_store(folder, "L1").manifest) == files_of(whole)


def test_blocks_of_another_file_are_not_used(tmp_path: Path) -> None:
    with pytest.raises(Cancelled):
        write_store(tmp_path, RECIPE, LINE.pieces(1000), place, progress=stop_at(5))
    changed = replace(RECIPE, original=replace(ORIGINAL, modified=99))
    source = LINE.pieces(1000)
    write_store(tmp_path, changed, source, place)
    assert source.requested == [0]


def test_a_new_import_replaces_the_old_one_only_when_complete(tmp_path: Path) -> None:
    old = stored(tmp_path)
    other = Line(1_200, seed=9)
    with pytest.raises(Cancelled):
        write_store(tmp_path, RECIPE, other.pieces(1000), place, progress=stop_at(4))
    assert files_of(open_store(tmp_path, "L1").manifest) == files_of(old.manifest)
    write_store(tmp_path, RECIPE, other.pieces(1000), place)
    assert len(open_store(tmp_path, "L1")) == 1_200
    assert sorted(path.name for path in tmp_path.iterdir()) == ["columns-2", "store.json"]


def test_import_stopped_after_writing_the_manifest_is_complete(tmp_path: Path, monkeypatch) -> None:
    def write_and_stop(folder: Path, manifest: Manifest) -> None:
        write_manifest(folder, manifest)
        raise KeyboardInterrupt

    monkeypatch.setattr("lispac.survey.store.line_import.write_manifest", write_and_stop)
    with pytest.raises(KeyboardInterrupt):
        write_store(tmp_path, RECIPE, LINE.pieces(1000), place)
    open_store(tmp_path, "L1").require_sound()


@given(st.binary(max_size=300), st.binary(max_size=300))
def test_checksums_of_pieces_are_combined(first: bytes, second: bytes) -> None:
    from zlib import crc32

    joined = combine_crc32(crc32(first), crc32(second), len(second))
    assert joined == crc32(first + second)


def test_the_names_in_a_manifest_are_those_of_version_3(tmp_path: Path) -> None:
    """A renamed field needs a new version and an alias in `layout`, or stores become unreadable."""
    write_store(tmp_path, RECIPE, LINE.pieces(1000), place)
    content = json.loads((tmp_path / "store.json").read_text())
    store = content["store"]
    assert content["version"] == 3
    assert set(store) == {
        "assumptions", "attributes", "audit", "columns", "excluded_points", "fingerprint",
        "first_time", "folder", "high", "last_time", "line", "low", "made_with", "original",
        "placed_with", "points", "reach", "side",
    }  # fmt: skip
    column = {"checksum", "count", "dtype", "file", "modified", "name", "shape", "size", "value"}
    assert [set(each) for each in store["columns"]] == [column] * len(store["columns"])
    assert set(store["original"]) == {"fingerprint", "modified", "path", "size"}


def test_recipe_and_original_are_kept(tmp_path: Path) -> None:
    placed_with = {"mounting": [0.1] * 9}
    recipe = ImportRecipe(
        "L1", SourceFile("/a/b.las", 1, 2, "c"), {"reading": {"options": [["x", "1"]]}}, placed_with
    )
    write_store(
        tmp_path, recipe, LINE.pieces(1000), place, lambda: (("read as it is",), {"read": 3})
    )
    manifest = open_store(tmp_path, "L1").manifest
    assert (manifest.original, manifest.made_with) == (recipe.original, recipe.made_with)
    assert manifest.placed_with == recipe.placed_with
    assert manifest.assumptions == ("read as it is",)
    assert manifest.audit == {"read": 3}
    assert manifest.excluded_points == LINE.index[-1] + 1 - len(LINE)
