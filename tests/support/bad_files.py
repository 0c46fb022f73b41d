"""Cases of bad input files, one function for each row of the table in the manual.

Each function changes a small valid survey and returns the command that detects the error.
"""

import os
import subprocess
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.cli.main import main
from lispac.io.project.project_file import read_project, write_project
from tests.support import point_files
from tests.support.input_file_samples import START, fan, write_line
from tests.support.report_sample import sample_project
from tests.support.trajectory_files import vessel, write_delph, write_records

Words = list[str]
COUNT = 3000
TIMES = START + np.linspace(2, 12, COUNT)


@dataclass
class Scene:
    """A valid survey in a folder, which a case then damages.

    Attributes
    ----------
    folder : Path
        Contains ``pos.sbet``, ``L1.las`` and the output of commands.
    patch : pytest.MonkeyPatch
    stack : ExitStack
        Undoes the changes that a case makes to the system.
    changed_files : set of str
        Names of files that the case itself changes while the command runs.
    """

    folder: Path
    patch: pytest.MonkeyPatch
    stack: ExitStack
    changed_files: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        write_records(self / "pos.sbet", vessel(2000))
        write_line(self / "L1.las", TIMES)

    def __truediv__(self, name: str) -> Path:
        return self.folder / name

    def new(
        self, line: str = "L1.las", *more: str, trajectory: str = "pos.sbet", to: str = "quay"
    ) -> Words:
        """Command that makes a project."""
        return [
            "new", str(self / to), str(self / line), "--trajectory", str(self / trajectory),
            "--lever-arm", "0.2", "-0.1", "1.5", "--position-sigma", "0.02", "0.02", "0.03",
            "--attitude-sigma", "0.01", "0.01", "0.02", *more,
        ]  # fmt: skip

    def make_project(self, *words: str, to: str = "quay") -> str:
        """Make the project and return its folder."""
        assert main(self.new(*words, to=to)) == 0
        return str(self / to)

    def georeference(self, output: str = "out", *more: str, project: str = "quay") -> Words:
        """Command that georeferences the lines."""
        return [
            "georeference", str(self / project), "--output", str(self / output),
            "--boresight", "prior", "--format", "las", *(more or ("--crs", "EPSG:32618")),
        ]  # fmt: skip

    def inspect(self, name: str) -> Words:
        """Command that inspects a file."""
        return ["inspect", str(self / name)]

    def cut(self, name: str, size: int) -> None:
        """Keep the first bytes of a file."""
        os.truncate(self / name, size)

    def mount_disk(self, size: str) -> Path:
        """Mount a small disk at ``disk``."""
        place = self / "disk"
        place.mkdir()
        if not hasattr(os, "geteuid") or os.geteuid() != 0:
            pytest.skip("only root may mount a small disk")
        words = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(place)]
        if subprocess.run(words, capture_output=True, check=False).returncode:
            pytest.skip("this system lets nobody mount a small disk")
        self.stack.callback(subprocess.run, ["umount", str(place)], check=True)
        return place

    def make_disk_read_only(self, size: str = "1m") -> None:
        """Make ``disk`` read-only, for root too."""
        words = ["mount", "-o", f"remount,ro,size={size}", str(self / "disk")]
        subprocess.run(words, check=True)

    def fill_disk(self) -> None:
        """Fill ``disk`` completely."""
        with (self / "disk" / "other").open("wb", buffering=0) as file:
            try:
                while file.write(bytes(512)):
                    pass
            except OSError:
                return


Case = Callable[[Scene], Words]
REFUSED: dict[str, Case] = {}
"""Cases that are refused with exit code 1 and one sentence, by the name of the row."""
WITH_WARNING: dict[str, Case] = {}
"""Cases of files that are read with a warning or a note, by the name of the row."""


def refused(name: str) -> Callable[[Case], Case]:
    return lambda case: REFUSED.setdefault(name, case)


def with_warning(name: str) -> Callable[[Case], Case]:
    return lambda case: WITH_WARNING.setdefault(name, case)


def changed_trajectory(change: Callable[[np.ndarray], object], count: int = 2000) -> Case:
    """A case with changed records of the trajectory."""

    def case(scene: Scene) -> Words:
        records = vessel(count)
        change(records)
        write_records(scene / "pos.sbet", records)
        return scene.new()

    return case


def put(rows: object, columns: object, value: object) -> Callable[[np.ndarray], None]:
    def change(records: np.ndarray) -> None:
        records[rows, columns] = value

    return change


def las(path: Path, change: Callable[[laspy.LasData], object]) -> None:
    """Change a LAS file."""
    data = laspy.read(path)
    change(data)
    data.write(path)


def ply(path: Path, values: np.ndarray, kind: str = "double", order: str = "little") -> Path:
    """Write a binary PLY file with x, y, z and time."""
    head = f"ply\nformat binary_{order}_endian 1.0\nelement vertex {len(values)}\n"
    head += "".join(f"property {kind} {name}\n" for name in ("x", "y", "z", "time"))
    size = {"double": "f8", "float": "f4"}[kind]
    path.write_bytes(f"{head}end_header\n".encode() + values.astype(f"<{size}").tobytes())
    return path


def points() -> np.ndarray:
    return np.column_stack([fan(COUNT), TIMES])


# Truncated, empty and foreign files.


@refused("Trajectory cut short")
def _(scene: Scene) -> Words:
    scene.cut("pos.sbet", 200_000)
    return scene.new()


@refused("Line cut short")
def _(scene: Scene) -> Words:
    scene.cut("L1.las", 60_000)
    return scene.new()


@refused("Text line cut short")
def _(scene: Scene) -> Words:
    path = point_files.text(scene / "L1.csv", head=point_files.CSV_HEAD)
    path.write_text(path.read_text()[:-20])
    return scene.new("L1.csv")


@refused("Text trajectory cut short")
def _(scene: Scene) -> Words:
    path = write_delph(scene / "nav.txt", vessel(200))
    path.write_text(path.read_text()[:-40])
    return scene.new(trajectory="nav.txt")


def reference_case(name: str, text: str) -> Case:
    """A case that checks a calibrated project against a reference with this text."""

    def case(scene: Scene) -> Words:
        project = scene.make_project()
        result = sample_project(scene / "sample").result
        write_project(replace(read_project(Path(project)), result=result))
        (scene / name).write_text(text)
        return ["check", project, "--reference", str(scene / name)]

    return case


refused("Reference cut short")(reference_case("scan.pts", "3\n1.5 2.5 3.5\n1.6 2.5 3.5\n"))
refused("Reference with more points than its count")(
    reference_case("scan.pts", "1\n1.5 2.5 3.5\n1.6 2.5 3.5\n")
)


@refused("Empty trajectory")
def _(scene: Scene) -> Words:
    (scene / "pos.sbet").write_bytes(b"")
    return scene.new()


@refused("Empty line")
def _(scene: Scene) -> Words:
    (scene / "L1.las").write_bytes(b"")
    return scene.new()


@refused("Line without points")
def _(scene: Scene) -> Words:
    las(scene / "L1.las", lambda data: setattr(data, "points", data.points[:0]))
    return scene.new()


@refused("Wrong file signature: only the extension is .las")
def _(scene: Scene) -> Words:
    data = (scene / "L1.las").read_bytes()
    (scene / "L1.las").write_bytes(b"XXXX" + data[4:])
    return scene.new()


@refused("File of an unknown format")
def _(scene: Scene) -> Words:
    (scene / "letter.txt").write_text("Dear all,\nthe survey went well.\n" * 20)
    return scene.inspect("letter.txt")


@refused("Line without GPS time")
def _(scene: Scene) -> Words:
    header = laspy.LasHeader(point_format=0, version="1.2")
    data = laspy.LasData(header)
    data.x, data.y, data.z = fan(50).T
    data.write(scene / "L1.las")
    return scene.new()


@with_warning("Trajectory with another byte order")
def _(scene: Scene) -> Words:
    write_records(scene / "pos.sbet", vessel(2000), order=">")
    return scene.inspect("pos.sbet")


@refused("Line with another byte order")
def _(scene: Scene) -> Words:
    ply(scene / "L1.ply", points(), order="big")
    return scene.new("L1.ply")


# Invalid numbers.

refused("NaN in the trajectory")(changed_trajectory(put(4, 8, np.nan)))
refused("Infinity in the trajectory")(changed_trajectory(put(6, 1, np.inf)))


@refused("NaN or infinity in a line")
def _(scene: Scene) -> Words:
    values = points()
    values[41::2, 2] = np.inf
    ply(scene / "L1.ply", values)
    return scene.new("L1.ply")


# Times.

refused("Duplicate time in the trajectory")(changed_trajectory(put(5, 0, START + 0.08)))
refused("Decreasing time in the trajectory")(changed_trajectory(put(5, 0, START)))
refused("Non-monotonic SBET: two missions in one file")(
    changed_trajectory(
        lambda records: records.__setitem__((slice(1000, None), 0), records[:1000, 0])
    )
)
refused("Trajectory times converted from 32 bits")(
    changed_trajectory(
        lambda records: records.__setitem__((..., 0), records[:, 0].astype(np.float32))
    )
)


@refused("Decreasing time in a text trajectory")
def _(scene: Scene) -> Words:
    path = write_delph(scene / "nav.txt", vessel(200))
    lines = path.read_text().splitlines()
    lines[-3] = lines[-3].replace(lines[-3].split("\t")[1], "14:00:01.0000")
    path.write_text("\n".join(lines) + "\n")
    return scene.new(trajectory="nav.txt")


@with_warning("Decreasing times in a line")
def _(scene: Scene) -> Words:
    write_line(scene / "L1.las", TIMES[::-1])
    return scene.inspect("L1.las")


@refused("Line times stored with 32 bits")
def _(scene: Scene) -> Words:
    ply(scene / "L1.ply", points(), "float")
    return scene.new("L1.ply")


@with_warning("Line times converted from 32 bits")
def _(scene: Scene) -> Words:
    write_line(scene / "L1.las", TIMES.astype(np.float32).astype(np.float64))
    return scene.inspect("L1.las")


@refused("Line before or after the trajectory")
def _(scene: Scene) -> Words:
    write_line(scene / "L1.las", TIMES + 5000)
    return scene.new()


@with_warning("Line partly outside the trajectory")
def _(scene: Scene) -> Words:
    write_line(scene / "L1.las", TIMES - 5)
    return scene.new()


@refused("Mixed time bases: line in time of day, trajectory in time of week")
def _(scene: Scene) -> Words:
    write_line(scene / "L1.las", TIMES % 86400)
    return scene.new()


@refused("Mixed time bases: trajectory in adjusted standard GPS time")
def _(scene: Scene) -> Words:
    records = vessel(2000)
    records[:, 0] += 2200 * 604_800 - 1e9
    write_records(scene / "pos.sbet", records)
    return scene.new()


@refused("Given time base that contradicts the times")
def _(scene: Scene) -> Words:
    return scene.new("L1.las", "--line-option", "time_base=utc-day")


@refused("Given time base and a different time shift")
def _(scene: Scene) -> Words:
    return scene.new("L1.las", "--line-option", "time_base=utc-week", "--time-shift", "5")


@refused("Accuracies with another byte order")
def _(scene: Scene) -> Words:
    rows = np.tile([0, 0.01, 0.01, 0.02, 0.1, 0.1, 0.1, 0.5, 0.5, 0.7], (41, 1))
    rows[:, 0] = 486_000 + np.arange(41)
    (scene / "smrmsg.out").write_bytes(rows.astype(">f8").tobytes())
    return scene.new("L1.las", "--trajectory-accuracy", str(scene / "smrmsg.out"))
