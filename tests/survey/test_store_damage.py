"""Tests of the store with damaged files, full disks and read-only folders."""

import errno
import json
import os
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError, ProjectError
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.survey.store import layout
from lispac.survey.store.import_lock import lock_folder
from lispac.survey.store.layout import MANIFEST_VERSION, write_manifest
from lispac.survey.store.line_import import write_store
from lispac.survey.store.point_blocks import PointPiece
from lispac.survey.store.stored_line import open_store
from tests.io.test_fuzz import reseal
from tests.support.error_codes import has_code
from tests.support.long_runs import others_long
from tests.support.store_lines import LINE, RECIPE, files_of, place, reason_code, small, stored

__all__ = ["small"]
pytestmark = pytest.mark.usefixtures("small")


@pytest.mark.parametrize(
    "name", others_long(["xyz", "time", "number", "row", "octaves", "coarse_xyz"])
)
@pytest.mark.parametrize("kept", [0.0, 0.5, None])
def test_a_truncated_or_missing_column_is_refused(tmp_path: Path, name: str, kept) -> None:
    stored(tmp_path)
    path = tmp_path / "columns-1" / f"{name}.npy"
    if kept is None:
        path.unlink()
    else:
        os.truncate(path, int(kept * path.stat().st_size))
    with pytest.raises(ProjectError, match=rf"{name}\.npy") as refused:
        open_store(tmp_path, "L1")
    assert reason_code(refused.value) == (
        "store.part_missing" if kept is None else "store.part_size"
    )


def test_a_flipped_bit_is_detected(tmp_path: Path) -> None:
    found = stored(tmp_path)
    for column in found.manifest.files:
        path = tmp_path / "columns-1" / column.file
        content = bytearray(path.read_bytes())
        content[-3] ^= 4
        path.write_bytes(content)
        with pytest.raises(ProjectError) as refused:
            found.require_sound()
        assert reason_code(refused.value) == "store.part_changed"
        with pytest.raises(ProjectError) as refused:
            open_store(tmp_path, "L1")
        assert reason_code(refused.value) == "store.part_changed"
        content[-3] ^= 4
        path.write_bytes(content)
    fractions: list[float] = []
    found.require_sound(fractions.append)
    sizes = [column.size for column in found.manifest.files]
    assert fractions == [sum(sizes[: k + 1]) / sum(sizes) for k in range(len(sizes))]


@pytest.mark.parametrize("name", ["octaves", "starts"])
def test_files_used_by_searches_are_always_checked(tmp_path: Path, name: str) -> None:
    """Errors in these files make searches return wrong points without notice."""
    stored(tmp_path)
    open_store(tmp_path, "L1")
    path = tmp_path / "columns-1" / f"{name}.npy"
    status, content = path.stat(), bytearray(path.read_bytes())
    content[-3] ^= 4
    path.write_bytes(content)
    os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))
    with pytest.raises(ProjectError, match=rf"{name}\.npy") as refused:
        open_store(tmp_path, "L1")
    assert reason_code(refused.value) == "store.part_changed"


@pytest.mark.parametrize(("value", "count"), [(np.nan, None), (np.nan, 1), (3e38, 1)])
def test_impossible_coordinates_with_right_checksums_are_refused(
    tmp_path: Path, value: float, count: int | None
) -> None:
    """They are found by the check of the import, anywhere in the line."""
    stored(tmp_path / "L1")
    manifest = layout.read_manifest(tmp_path / "L1")
    assert manifest is not None
    (column,) = (each for each in manifest.files if each.name == "xyz")
    path = tmp_path / "L1" / manifest.folder / column.file
    xyz = np.load(path)
    xyz[len(xyz) // 2 :][:count] = value
    np.save(path, xyz)
    reseal(tmp_path / "L1", manifest)
    with pytest.raises(ProjectError):
        open_store(tmp_path / "L1", "L1").require_sound()


def test_a_copied_store_is_checked_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    stored(tmp_path / "L1")
    copy = Path(shutil.copytree(tmp_path / "L1", tmp_path / "copy", copy_function=shutil.copyfile))
    steps: list[object] = []

    def opening(folder: Path) -> list[object]:
        steps.clear()
        open_store(folder, "L1", progress=lambda done, words="": steps.append(words))
        return steps

    assert opening(tmp_path / "L1") == []
    assert set(opening(copy)) == {gettext_lazy("Checking {line}", line="L1")}
    assert opening(copy) == []
    os.utime(copy / "columns-1" / "time.npy", ns=(0, 5))
    monkeypatch.setattr(layout, "write_text_atomically", refuse)
    for _ in range(2):  # a read-only folder
        assert opening(copy)


def refuse(*_: object) -> None:
    """Raise the error of a read-only folder."""
    raise OSError(errno.EROFS, "Read-only file system")


def test_a_store_without_times_is_checked_and_then_has_them(tmp_path: Path) -> None:
    manifest = stored(tmp_path).manifest
    bare = replace(
        manifest,
        columns=tuple(replace(column, modified=0) for column in manifest.columns),
        attributes=tuple(replace(column, modified=0) for column in manifest.attributes),
    )
    write_manifest(tmp_path, bare)
    assert open_store(tmp_path, "L1").manifest == bare
    assert open_store(tmp_path, "L1").manifest == manifest


def test_a_line_imported_again_meanwhile_is_refused(tmp_path: Path) -> None:
    opened = stored(tmp_path)
    assert len(opened.time)
    stored(tmp_path)
    assert (tmp_path / "columns-2").is_dir()
    for read in (lambda: opened.points_lidar, lambda: opened.extra, opened.require_sound):
        with pytest.raises(ProjectError) as refused:
            read()
        assert refused.value.code == "store.imported_again"
    assert len(opened.time)


def test_a_line_that_is_being_imported_is_refused(tmp_path: Path) -> None:
    (tmp_path / "spool").mkdir()
    with lock_folder(tmp_path), pytest.raises(ProjectError) as refused:
        open_store(tmp_path, "L1")
    assert refused.value.code == "store.being_imported"
    with pytest.raises(ProjectError) as refused:
        open_store(tmp_path, "L1")
    assert refused.value.code == "store.interrupted"


@pytest.mark.parametrize(
    ("harm", "code"),
    [
        (lambda text: text[: len(text) // 2], "store.manifest_damaged"),
        (lambda text: "", "store.manifest_damaged"),
        (
            lambda text: text.replace('"points": 6300', '"points": 6301'),
            "store.manifest_checksum",
        ),
        (lambda text: json.dumps({"version": 1}), "store.manifest_damaged"),
        (lambda text: "[]", "store.manifest_damaged"),
    ],
)
def test_damaged_manifest_is_refused_and_imported_again(tmp_path: Path, harm, code: str) -> None:
    whole = stored(tmp_path).manifest
    path = tmp_path / "store.json"
    path.write_text(harm(path.read_text()))
    with pytest.raises(ProjectError, match=r"store\.json") as refused:
        open_store(tmp_path, "L1")
    assert reason_code(refused.value) == code
    assert files_of(stored(tmp_path).manifest) == files_of(whole)


def test_a_store_of_a_newer_version_is_not_changed(tmp_path: Path) -> None:
    stored(tmp_path)
    path = tmp_path / "store.json"
    path.write_text(
        path.read_text().replace(
            f'"version": {MANIFEST_VERSION}', f'"version": {MANIFEST_VERSION + 1}'
        )
    )
    content = path.read_text()
    with pytest.raises(ProjectError) as refused:
        open_store(tmp_path, "L1")
    assert refused.value.code == "store.newer_version"
    with pytest.raises(ProjectError) as refused:
        stored(tmp_path)
    assert refused.value.code == "store.newer_version"
    assert path.read_text() == content


def test_store_of_another_line_is_refused(tmp_path: Path) -> None:
    stored(tmp_path)
    with pytest.raises(ProjectError) as refused:
        open_store(tmp_path, "L2")
    assert reason_code(refused.value) == "store.other_line"


def test_a_line_that_is_not_imported_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="L1: ") as refused:
        open_store(tmp_path / "L1", "L1")
    assert refused.value.code == "store.not_imported"


def test_one_import_of_a_line_at_a_time(tmp_path: Path) -> None:
    with lock_folder(tmp_path), pytest.raises(ProjectError) as refused:
        write_store(tmp_path, RECIPE, LINE.pieces(1000), place)
    assert refused.value.code == "store.locked"
    stored(tmp_path)


def test_an_error_of_the_file_leaves_no_store(tmp_path: Path) -> None:
    def broken(first: int) -> Iterator[PointPiece]:
        yield from list(LINE.pieces(1000)(first))[:4]
        raise InputError(error("file.no_points", file="a.las"))

    with pytest.raises(InputError, check=has_code("file.no_points", file="a.las")):
        write_store(tmp_path / "lines" / "L1", RECIPE, broken, place)
    assert not (tmp_path / "lines").exists()


def test_attributes_that_change_within_a_line_are_refused(tmp_path: Path) -> None:
    def mixed(first: int) -> Iterator[PointPiece]:
        one, two, *_ = LINE.pieces(1000)(first)
        yield one
        yield replace(two, extra={"intensity": two.extra["intensity"]})

    with pytest.raises(InputError) as refused:
        write_store(tmp_path / "L1", RECIPE, mixed, place)
    assert refused.value.message == error(
        "store.attributes_change",
        file="a.las",
        point=1001,
        attributes=tuple(sorted(LINE.extra.keys() - {"intensity"})),
    )


def test_attributes_that_are_not_numbers_are_refused(tmp_path: Path) -> None:
    def words(first: int) -> Iterator[PointPiece]:
        for piece in LINE.pieces(1000)(first):
            yield replace(piece, extra={"label": np.array(["a"] * len(piece))})

    with pytest.raises(InputError, match="label") as refused:
        write_store(tmp_path / "L1", RECIPE, words, place)
    assert refused.value.code == "store.attribute"


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="mounts a small disk")
@pytest.mark.parametrize("size", ["100k", "350k", "500k", "650k"])
def test_a_full_disk_leaves_no_store(tmp_path: Path, size: str) -> None:
    """The disk fills in a block, in the columns, or in the column written in random order."""
    disk = tmp_path / "disk"
    disk.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(disk)]
    if subprocess.run(command, capture_output=True, check=False).returncode:
        pytest.skip("a small disk cannot be mounted here")
    try:
        (disk / "project.json").write_text("{}")
        with pytest.raises(ProjectError) as refused:
            write_store(disk / "lines" / "L1", RECIPE, LINE.pieces(1000), place)
        assert refused.value.code == "store.disk_full_size"
        assert [path.name for path in disk.rglob("*")] == ["project.json"]
    finally:
        subprocess.run(["umount", str(disk)], check=True)


def test_a_folder_that_cannot_be_created_is_reported(tmp_path: Path) -> None:
    (tmp_path / "lines").write_text("a file in the way")
    with pytest.raises(ProjectError) as refused:
        write_store(tmp_path / "lines" / "L1", RECIPE, LINE.pieces(1000), place)
    assert refused.value.code == "store.not_writable"


@pytest.mark.parametrize(
    "changes",
    [
        {"folder": ".."}, {"folder": "columns-abc"}, {"folder": "columns-\u00b2"},
        {"placed_with": {"mounting": [[[]]]}}, {"placed_with": {"mounting": [0.0]}},
        {"first_time": -1e308, "last_time": 1e308}, {"reach": 1e300}, {"reach": -1.0},
    ],
)  # fmt: skip
def test_invalid_manifests_are_refused(tmp_path: Path, changes) -> None:
    found = stored(tmp_path)
    write_manifest(tmp_path, replace(found.manifest, **changes))
    with pytest.raises(ProjectError):
        open_store(tmp_path, "L1")
    assert list((tmp_path / "columns-1").glob("*.npy"))
