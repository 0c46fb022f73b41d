"""The store where files are damaged, disks are full, and folders cannot be written."""

import json
import os
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError, ProjectError
from lispac.survey.store.lock import locked
from lispac.survey.store.pieces import Piece
from lispac.survey.store.reading import open_store
from lispac.survey.store.writing import write_store
from tests.store_lines import LINE, RECIPE, files_of, place, small, stored

__all__ = ["small"]
pytestmark = pytest.mark.usefixtures("small")


@pytest.mark.parametrize("name", ["xyz", "time", "number", "row", "octaves", "coarse_xyz"])
@pytest.mark.parametrize("kept", [0.0, 0.5, None])
def test_column_cut_short_or_missing_is_refused(tmp_path: Path, name: str, kept) -> None:
    stored(tmp_path)
    path = tmp_path / "columns-1" / f"{name}.npy"
    if kept is None:
        path.unlink()
    else:
        os.truncate(path, int(kept * path.stat().st_size))
    with pytest.raises(ProjectError, match=rf"{name}\.npy.*(missing|bytes); import the line again"):
        open_store(tmp_path, "L1")


def test_flipped_bit_is_noticed(tmp_path: Path) -> None:
    found = stored(tmp_path)
    for column in found.manifest.files:
        path = tmp_path / "columns-1" / column.file
        content = bytearray(path.read_bytes())
        content[-3] ^= 4
        path.write_bytes(content)
        with pytest.raises(ProjectError, match="checksum"):
            found.require_sound()
        if column.name in ("octaves", "starts"):
            with pytest.raises(ProjectError, match="checksum"):
                open_store(tmp_path, "L1")
        content[-3] ^= 4
        path.write_bytes(content)
    found.require_sound()


@pytest.mark.parametrize(
    "harm",
    [
        lambda text: text[: len(text) // 2],
        lambda text: "",
        lambda text: text.replace('"points": 6300', '"points": 6301'),
        lambda text: json.dumps({"version": 1}),
        lambda text: "[]",
    ],
)
def test_damaged_manifest_is_refused_and_imported_again(tmp_path: Path, harm) -> None:
    whole = stored(tmp_path).manifest
    path = tmp_path / "store.json"
    path.write_text(harm(path.read_text()))
    with pytest.raises(ProjectError, match=r"damaged .*import the line again"):
        open_store(tmp_path, "L1")
    assert files_of(stored(tmp_path).manifest) == files_of(whole)


def test_newer_store_is_not_touched(tmp_path: Path) -> None:
    stored(tmp_path)
    path = tmp_path / "store.json"
    path.write_text(path.read_text().replace('"version": 1', '"version": 2'))
    content = path.read_text()
    with pytest.raises(ProjectError, match="newer version"):
        open_store(tmp_path, "L1")
    with pytest.raises(ProjectError, match="newer version"):
        stored(tmp_path)
    assert path.read_text() == content


def test_store_of_another_line_is_refused(tmp_path: Path) -> None:
    stored(tmp_path)
    with pytest.raises(ProjectError, match="this is the line L1, not L2"):
        open_store(tmp_path, "L2")


def test_not_imported(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="L1: this line is not imported yet"):
        open_store(tmp_path / "L1", "L1")


def test_one_import_of_a_line_at_a_time(tmp_path: Path) -> None:
    with locked(tmp_path), pytest.raises(ProjectError, match="imported already"):
        write_store(tmp_path, RECIPE, LINE.pieces(1000), place)
    stored(tmp_path)


def test_error_of_the_file_leaves_nothing(tmp_path: Path) -> None:
    def broken(first: int) -> Iterator[Piece]:
        yield from list(LINE.pieces(1000)(first))[:4]
        raise InputError("a.las: cut short; copy it again.")

    with pytest.raises(InputError, match="cut short"):
        write_store(tmp_path / "lines" / "L1", RECIPE, broken, place)
    assert not (tmp_path / "lines").exists()


def test_attributes_that_change_within_a_line_are_refused(tmp_path: Path) -> None:
    def mixed(first: int) -> Iterator[Piece]:
        one, two, *_ = LINE.pieces(1000)(first)
        yield one
        yield replace(two, extra={"intensity": two.extra["intensity"]})

    with pytest.raises(InputError, match=r"from point 1,001 on .* other attributes"):
        write_store(tmp_path / "L1", RECIPE, mixed, place)


def test_attribute_that_is_no_number_is_refused(tmp_path: Path) -> None:
    def words(first: int) -> Iterator[Piece]:
        for piece in LINE.pieces(1000)(first):
            yield replace(piece, extra={"label": np.array(["a"] * len(piece))})

    with pytest.raises(InputError, match="attribute label is not a number"):
        write_store(tmp_path / "L1", RECIPE, words, place)


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="mounts a small disk")
@pytest.mark.parametrize("size", ["100k", "350k", "500k", "650k"])
def test_full_disk_leaves_nothing(tmp_path: Path, size: str) -> None:
    """In a block, in the columns, and in the column whose values come in any order."""
    disk = tmp_path / "disk"
    disk.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(disk)]
    if subprocess.run(command, capture_output=True, check=False).returncode:
        pytest.skip("a small disk cannot be mounted here")
    try:
        (disk / "project.json").write_text("{}")
        with pytest.raises(ProjectError, match=r"the disk is full; make room \(about \d+ MB"):
            write_store(disk / "lines" / "L1", RECIPE, LINE.pieces(1000), place)
        assert [path.name for path in disk.rglob("*")] == ["project.json"]
    finally:
        subprocess.run(["umount", str(disk)], check=True)


def test_folder_that_cannot_be_made(tmp_path: Path) -> None:
    (tmp_path / "lines").write_text("a file in the way")
    with pytest.raises(ProjectError, match=r"cannot be written here.*choose a project folder"):
        write_store(tmp_path / "lines" / "L1", RECIPE, LINE.pieces(1000), place)
