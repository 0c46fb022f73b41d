"""Tests that the format of a file follows from its content, and that special files are refused."""

import bz2
import gzip
import io
import json
import lzma
import os
import shutil
import socket
import tarfile
import threading
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.compressed_files import ARCHIVE_FORMATS
from lispac.io.format_types import Kind
from lispac.io.formats import is_las, recognise_formats
from lispac.io.points.mesh_file import MeshReader, read_mesh
from lispac.io.points.static_scan import open_static_scan
from lispac.io.text.plane_file import read_plane_table
from lispac.io.text.seed_file import is_point_list, read_point_list
from lispac.messages import error
from lispac.project import LineSource
from lispac.workflow.importing.file_reading import check_file, format_of_line
from lispac.workflow.importing.line_chunks import LineChunks
from tests.cli.test_cli import run, run_refused
from tests.support import point_files as files
from tests.support.error_codes import has_code
from tests.support.input_file_samples import write_survey
from tests.support.static_scans import write_pts

ENDINGS = (".las", ".txt", ".e57", ".ply", ".csv", ".sbet", "")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Folder with trajectory, accuracies and lines of a small survey."""
    return write_survey(tmp_path)


def point_counts_of_project(
    capsys: pytest.CaptureFixture[str], folder: Path, *lines: Path, more: tuple[object, ...] = ()
):
    """Number of points of each line of a new project."""
    out = run(
        capsys, "new", folder / "project", *lines, "--trajectory", folder / "pos.sbet",
        "--lever-arm", 0.2, -0.1, 1.5, "--json", *more,
    )  # fmt: skip
    assert out[0] == 0, out[2]
    return dict(json.loads(out[1])["points"])


@pytest.mark.parametrize("ending", [".txt", ".csv", ".e57", ""])
def test_a_las_file_with_another_ending_is_a_line(
    folder: Path, capsys: pytest.CaptureFixture[str], ending: str
) -> None:
    for name in ("L1.laz", "L2.las"):
        (folder / name).rename(folder / f"{name[:2]}{ending}")
    lines = [folder / f"L1{ending}", folder / f"L2{ending}"]
    assert point_counts_of_project(capsys, folder, *lines) == {"L1": 3000, "L2": 3000}


@pytest.mark.parametrize("ending", [".las", ".laz", ".ply"])
def test_a_text_file_with_another_ending_is_a_line(
    folder: Path, capsys: pytest.CaptureFixture[str], ending: str
) -> None:
    """The columns are named in the file or by the user."""
    las = laspy.read(folder / "L2.las")
    rows = np.column_stack([las.gps_time, las.xyz])
    named, bare = folder / f"L3{ending}", folder / f"L4{ending}"
    np.savetxt(named, rows, fmt="%.6f", header="time x y z", comments="")
    np.savetxt(bare, rows, fmt="%.6f")
    assert point_counts_of_project(capsys, folder, named) == {"L3": 3000}
    columns = ("--columns", "time,x,y,z")
    shutil.rmtree(folder / "project")
    assert point_counts_of_project(capsys, folder, bare, more=columns) == {"L4": 3000}


def test_a_trajectory_and_accuracies_with_other_endings_are_recognised(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "pos.sbet").rename(folder / "pos.las")
    (folder / "smrmsg.out").rename(folder / "smrmsg.csv")
    code, out, err = run(
        capsys, "new", folder / "project", folder / "L1.laz", "--trajectory", folder / "pos.las",
        "--trajectory-accuracy", folder / "smrmsg.csv", "--lever-arm", 0.2, -0.1, 1.5, "--json",
    )  # fmt: skip
    assert code == 0, err
    assert json.loads(out)["points"] == {"L1": 3000}


@pytest.mark.parametrize("ending", ENDINGS)
@pytest.mark.parametrize("name", files.VALID_FILES)
def test_every_point_format_is_recognised_with_any_ending(
    tmp_path: Path, name: str, ending: str
) -> None:
    key, write = files.VALID_FILES[name]
    path = write(tmp_path / name).rename(tmp_path / f"line{ending}")
    assert recognise_formats(path, "points")[0][0].key == key
    assert check_file(path)[0].format.key == key
    assert is_las(path) == (key == "las")


def test_the_format_of_a_line_is_recognised(tmp_path: Path) -> None:
    """LAS or text by the content, or by the ending if the file is missing or damaged."""
    las = LineSource("a", files.las(tmp_path / "a.las").rename(tmp_path / "a.txt"), ())
    text = LineSource("b", files.text(tmp_path / "b.las", head=files.CSV_HEAD), ())
    for line, key in ((las, "las"), (text, "text")):
        assert format_of_line(line)[0].key == LineChunks.of(line).format.key == key
    (tmp_path / "c.laz").write_bytes(bytes(4000))
    assert is_las(tmp_path / "c.laz")
    assert is_las(tmp_path / "none.LAZ")
    assert not is_las(tmp_path / "none.txt")


def places(path: Path) -> np.ndarray:
    return np.concatenate(list(open_static_scan(path).coordinate_chunks(local=True)))


@pytest.mark.parametrize("ending", [".pts", ".ply", ".txt", ".las", ".ptx"])
def test_references_are_recognised_by_their_content(tmp_path: Path, ending: str) -> None:
    for write in (files.las, files.e57, lambda path: write_pts(path, [files.XYZ], more=4)):
        path = tmp_path / "as-written.laz"
        write(path)
        path = path.rename(tmp_path / f"scan{ending}")
        np.testing.assert_allclose(places(path), files.XYZ, atol=1e-4)
    for delimiter in (" ", ","):
        np.savetxt(path, files.XYZ, fmt="%.4f", delimiter=delimiter)
        np.testing.assert_allclose(places(path), files.XYZ, atol=1e-4)
        head = delimiter.join("xyz")
        np.savetxt(path, files.XYZ, fmt="%.4f", delimiter=delimiter, header=head, comments="")
        np.testing.assert_allclose(places(path), files.XYZ, atol=1e-4)


def ptx(path: Path) -> Path:
    pose = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"
    path.write_text(f"2\n1\n{pose}1.0 2.0 3.0 0.5\n4.0 5.0 6.0 0.5\n")
    return path


@pytest.mark.parametrize("ending", [".txt", ".pts", ".las"])
@pytest.mark.parametrize("write", [ptx, files.padded_pcd, files.big_endian_ply])
def test_references_of_other_formats_are_refused_with_any_ending(
    tmp_path: Path, write: Callable[[Path], Path], ending: str
) -> None:
    with pytest.raises(InputError, check=has_code("static_scan.other_format")):
        list(open_static_scan(write(tmp_path / f"scan{ending}")).coordinate_chunks(local=True))


def test_lists_and_plane_files_with_other_endings_are_recognised(tmp_path: Path) -> None:
    path = tmp_path / "seeds.las"
    path.write_text("T1,1.0,2.0,3.0\nT2,4.0,5.0,6.0\n")
    assert [point.name for point in read_point_list(path).points] == ["T1", "T2"]
    assert is_point_list(path)
    for ending in (".las", ".gz", ".bz2", ".npy"):
        assert read_plane_table(files.planes(tmp_path / f"plane{ending}")).shape == (
            files.COUNT,
            25,
        )


@pytest.fixture(scope="module")
def reader() -> Iterator[MeshReader]:
    """Reader of meshes whose process serves all tests; starting one takes seconds."""
    with MeshReader() as started:
        yield started


@pytest.mark.parametrize("ending", [".ply", ".obj", ".stl", ".txt"])
@pytest.mark.parametrize("kind", ["ply", "obj", "stl"])
def test_meshes_are_recognised_by_their_content(
    reader: MeshReader, tmp_path: Path, kind: str, ending: str
) -> None:
    import open3d as o3d

    box = o3d.geometry.TriangleMesh.create_box()
    box.compute_triangle_normals()
    assert o3d.io.write_triangle_mesh(str(tmp_path / f"box.{kind}"), box)
    path = (tmp_path / f"box.{kind}").rename(tmp_path / f"mesh{ending}")
    assert len(read_mesh(path, "box", 0.5, reader=reader).triangles) == 12


def tar(data: bytes) -> bytes:
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w") as archive:
        entry = tarfile.TarInfo("a")
        entry.size = len(data)
        archive.addfile(entry, io.BytesIO(data))
    return packed.getvalue()


def zipped(data: bytes, name: str = "line.las") -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        archive.writestr(name, data)
    return packed.getvalue()


PACKINGS: dict[str, Callable[[bytes], bytes]] = {
    "gzip": gzip.compress,
    "bzip2": bz2.compress,
    "xz": lzma.compress,
    "ZIP": zipped,
    "TAR": tar,
    "7z": lambda data: b"7z\xbc\xaf\x27\x1c\x00\x04" + data,
    "RAR": lambda data: b"Rar!\x1a\x07\x01\x00" + data,
}


@pytest.mark.parametrize("packing", PACKINGS)
def test_compressed_files_are_refused_with_a_suggestion(
    folder: Path, capsys: pytest.CaptureFixture[str], packing: str
) -> None:
    """Compressed lines, trajectories and lists with any name."""
    pack = PACKINGS[packing]
    lines, trajectory = folder / "L1.laz", folder / "pos.sbet"
    packed = folder / "packed.laz"
    for source in (lines, trajectory):
        packed.write_bytes(pack(source.read_bytes()))
        refusal = run_refused(capsys, "inspect", packed)
        assert packing in refusal
    new = ("new", folder / "p", "--lever-arm", 0, 0, 0)
    assert packing in run_refused(capsys, *new, packed, "--trajectory", trajectory)
    assert packing in run_refused(capsys, *new, lines, "--trajectory", packed)
    for read in (open_static_scan, read_point_list):
        with pytest.raises(InputError) as raised:
            read(packed)
        assert raised.value.code == (
            "file.archive" if packing in ARCHIVE_FORMATS else "file.compressed"
        )
        assert raised.value.message is not None
        assert raised.value.message.params == {"file": str(packed), "format": packing}


def test_gzip_compressed_points_are_read_and_other_text_is_refused(tmp_path: Path) -> None:
    path = files.text(tmp_path / "a.csv.gz", head=files.CSV_HEAD)
    assert check_file(path.rename(tmp_path / "line.txt"))[0].format.key == "text"
    path.write_bytes(gzip.compress(b"T1,1.0,2.0,3.0\n"))
    with pytest.raises(InputError) as raised:
        read_point_list(path)
    assert raised.value.message == error("file.compressed", file=str(path), format="gzip")


def test_a_workbook_is_refused_with_a_suggestion(tmp_path: Path) -> None:
    path = tmp_path / "seeds.csv"
    path.write_bytes(zipped(b"<Types/>", "[Content_Types].xml"))
    with pytest.raises(InputError) as raised:
        read_point_list(path)
    assert raised.value.code == "file.office_document"


def test_records_that_begin_like_gzip_are_read(tmp_path: Path) -> None:
    """The first bytes of the times are by chance those of gzip."""
    records = np.frombuffer((write_survey(tmp_path) / "pos.sbet").read_bytes(), np.uint8).copy()
    records[:3] = (0x1F, 0x8B, 0x08)
    path = tmp_path / "pos.out"
    path.write_bytes(records.tobytes())
    kinds: tuple[Kind, ...] = ("trajectory",)
    assert check_file(path, kinds)[0].format.key == "sbet"


@pytest.fixture(params=["fifo", "socket", "device", "folder"])
def special(request: pytest.FixtureRequest, tmp_path: Path):
    """A path that is not a regular file, and the name of its kind."""
    path = tmp_path / "special.las"
    name = {"fifo": "named pipe", "socket": "socket", "device": "device", "folder": "folder"}
    listening = None
    if request.param in ("fifo", "socket") and not hasattr(os, "mkfifo"):
        pytest.skip("there are none on this system")
    if request.param == "fifo":
        os.mkfifo(path)
    elif request.param == "socket":
        listening = socket.socket(socket.AF_UNIX)
        here = os.getcwd()
        os.chdir(tmp_path)  # socket paths have a maximum length
        listening.bind(path.name)
        os.chdir(here)
    elif request.param == "device":
        path = Path(os.devnull)
    else:
        path.mkdir()
    yield path, name[request.param]
    if listening is not None:
        listening.close()


def ends_within(seconds: float, task: Callable[[], object]) -> str:
    """Error text of a task; the test fails if the task does not end in time."""
    texts: list[str] = []

    def run_it() -> None:
        try:
            texts.append(f"no error: {task()}")
        except InputError as error:
            texts.append(str(error))

    thread = threading.Thread(target=run_it, daemon=True)
    thread.start()
    thread.join(seconds)
    assert texts, "it waits"
    return texts[0]


@pytest.mark.parametrize(
    "task",
    [
        check_file,
        open_static_scan,
        read_point_list,
        read_plane_table,
        lambda path: read_mesh(path, "a", 0.5),
    ],
)
def test_special_files_are_refused_with_their_kind(
    special: tuple[Path, str], task: Callable[[Path], object]
) -> None:
    path, name = special
    refusal = ends_within(20, lambda: task(path))
    assert name in refusal
    assert str(path) in refusal


def test_special_files_are_not_opened_for_recognition(special: tuple[Path, str]) -> None:
    path, _ = special
    kinds: tuple[Kind, ...] = ("points", "trajectory", "accuracy")
    for kind in kinds:
        assert "no error: []" in ends_within(20, lambda kind=kind: recognise_formats(path, kind))
    assert "no error: False" in ends_within(20, lambda: is_point_list(path))
