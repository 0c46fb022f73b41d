"""Small surveys as input files, examined and imported in one thread."""

from pathlib import Path

import laspy
import numpy as np
from pyproj import CRS

from lispac.workflow.importing.input_file import InputFile, examine_file, reexamine_file
from lispac.workflow.importing.input_files import InputFiles, collect_files
from tests.support.message_codes import codes, texts
from tests.support.trajectory_files import vessel, write_records

START = 486_000.0
LEVER = (0.2, -0.1, 1.5)


def import_files(
    input_files: InputFiles, *paths: Path, mappings: dict[str, str] | None = None
) -> InputFiles:
    """Examine and import input files like the window, in one thread."""
    input_files = input_files.with_files(collect_files(paths))
    while waiting := [input_file for input_file in input_files.files if input_file.pending]:
        input_file = waiting[0]
        found = (
            reexamine_file(input_file)
            if input_file.checks
            else examine_file(input_file.path, mappings)
        )
        input_files = input_files.with_changed_file(found).with_resolved_role(input_file.path)
    return input_files


def write_line(path: Path, times: np.ndarray, points: np.ndarray | None = None, crs: str = ""):
    """Write a line as another program would, with laspy only."""
    points = fan(len(times)) if points is None else points
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = np.full(3, 1e-4), np.floor(points.mean(axis=0))
    if crs:
        header.add_crs(CRS.from_user_input(crs))
    header.global_encoding.gps_time_type = laspy.header.GpsTimeType.WEEK_TIME
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    las.gps_time = times
    las.write(path)
    return path


def write_long_line(path: Path, count: int) -> Path:
    """Write 20 s of a profiler within the trajectory of `write_survey`, in parts."""
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = np.full(3, 1e-4)
    header.global_encoding.gps_time_type = laspy.header.GpsTimeType.WEEK_TIME
    with laspy.open(path, mode="w", header=header) as writer:
        for first in range(0, count, 1_000_000):
            k = np.arange(first, min(count, first + 1_000_000))
            angle, ranges = 2 * np.pi * (k % 5000) / 5000, 10 + 5 * np.sin(k / 700)
            points = laspy.ScaleAwarePointRecord.zeros(len(k), header=header)
            points.x, points.y = 0 * ranges, ranges * np.cos(angle)
            points.z, points.gps_time = ranges * np.sin(angle), START + 5 + 20 * k / count
            writer.write_points(points)
    return path


def fan(count: int) -> np.ndarray:
    """Points 5 to 20 m to the side of the scanner."""
    k = np.arange(count)
    return np.stack([0.0 * k, 5 + 15 * (k % 100) / 100, -2 + 4 * (k % 37) / 37], axis=1)


def write_survey(folder: Path) -> Path:
    """Write a trajectory of 40 s, its accuracies, two lines and a letter."""
    write_records(folder / "pos.sbet", vessel(2000))
    accuracy = np.tile([0, 0.01, 0.01, 0.02, 0.1, 0.1, 0.1, 0.5, 0.5, 0.7], (41, 1))
    accuracy[:, 0] = START + np.arange(41)
    write_records(folder / "smrmsg.out", accuracy)
    write_line(folder / "L1.laz", START + np.linspace(2, 12, 3000))
    write_line(folder / "L2.las", START + np.linspace(15, 25, 3000))
    (folder / "letter.md").write_text("Dear surveyor, these are the files.\n")
    (folder / ".hidden").write_text("x")
    (folder / "deeper").mkdir()
    (folder / "deeper" / "L9.txt").write_text("1 2 3 4\n")
    return folder


def named(input_files: InputFiles, name: str) -> InputFile:
    """The input file of that name."""
    return next(input_file for input_file in input_files.files if input_file.path.name == name)


def message_texts(input_files: InputFiles, name: str) -> str:
    """Texts of the messages about a file."""
    return texts(input_files.messages(named(input_files, name)))


def codes_about(input_files: InputFiles, name: str) -> list[str]:
    """Codes of the messages about a file."""
    return codes(input_files.messages(named(input_files, name)))
