"""A typical file of each format, for the list of assumptions of its reader."""

from pathlib import Path

import numpy as np

from lispac.io.formats import format_of
from lispac.messages import Message
from lispac.survey.trajectory import TrajectoryAccuracy
from tests.support import point_files
from tests.support.trajectory_files import vessel, write_delph, write_pospac, write_records


def samples(folder: Path) -> dict[str, Path]:
    """Write a file of each format; returns the paths by the key of the format."""
    from lispac.io.trajectory.sbet import write_smrmsg

    records = vessel(400)
    degrees = np.degrees(records[:, [1, 2, 7, 8, 9]])
    np.savetxt(
        folder / "columns.txt",
        np.column_stack([records[:, 0], degrees[:, :2], records[:, 3], degrees[:, 2:]]),
        fmt="%.9f",
        header="Time Lat(deg) Lon(deg) H Roll Pitch Heading",
        comments="",
    )
    sigmas = np.full((len(records), 3), 0.01)
    write_smrmsg(
        folder / "smrmsg.out", TrajectoryAccuracy(records[:, 0], sigmas, np.radians(sigmas))
    )
    cidco = point_files.cidco(folder / "cidco.bin")
    delph = write_delph(folder / "delph.txt", records)
    pospac = write_pospac(folder / "pospac.txt", records)
    return {
        "sbet": write_records(folder / "a.sbet", records),
        "exail-text": delph,
        "exail-sigmas": write_delph(folder / "sigmas.txt", records, sigmas=True),
        "pospac-text": pospac,
        "pospac-sigmas": pospac,
        "ascii-trajectory": folder / "columns.txt",
        "smrmsg": folder / "smrmsg.out",
        "cidco-states": cidco,
        "cidco-sigmas": cidco,
        "cidco": cidco,
        "planes": point_files.planes(folder / "planes.txt"),
        "target": point_files.target(folder / "target.csv"),
        "las": point_files.las(folder / "a.las"),
        "e57": point_files.e57(folder / "a.e57"),
        "ply": point_files.cloud(folder / "a.ply"),
        "pcd": point_files.cloud(folder / "a.pcd"),
        "text": point_files.text(folder / "a.csv", head="time,x,y,z,ring\n"),
    }


def assumed(key: str, file: Path) -> tuple[Message, ...]:
    """Assumptions about a file that the reader of its format reports."""
    if key == "pospac-sigmas":
        return ()  # the sample file has none
    return format_of(key).preview(file, {}).assumptions
