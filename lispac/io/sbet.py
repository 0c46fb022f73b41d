"""Applanix SBET trajectories and smrmsg accuracies."""

from pathlib import Path

import numpy as np

from lispac.errors import InputError
from lispac.io.files import read_records, require_increasing, written_whole
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy

ASSUMPTIONS = (
    "SBET after Applanix: North-East-Down, roll positive starboard down, pitch positive bow up "
    "(its sign is turned here), true heading = platform heading - wander angle",
    "SBET times and point times share one time base",
)


def read_sbet(path: Path) -> Trajectory:
    """Read an SBET: 17 little-endian float64 a record.

    Raises
    ------
    InputError
        Where the file is missing, cut short, holds NaN, angles out of range or disordered times.
    """
    path = Path(path)
    records = read_records(path, 17, "SBET")
    if len(records) < 2:
        raise InputError(f"{path}: a trajectory needs at least two SBET records, this has one.")
    time, latitude, longitude, height = records[:, :4].T
    require_increasing(time, path, "SBET")
    if np.abs(latitude).max() > np.pi / 2 or np.abs(longitude).max() > 2 * np.pi:
        raise InputError(
            f"{path}: latitude or longitude is out of range for radians "
            f"(up to {np.abs(records[:, 1:3]).max():.3f}); this is not SBET in radians."
        )
    roll, pitch, heading, wander = records[:, 7:11].T
    attitude = np.stack([roll, -pitch, heading - wander], axis=1)
    return Trajectory(time, latitude, longitude, height, attitude, ASSUMPTIONS)


def write_sbet(path: Path, trajectory: Trajectory) -> None:
    """Write an SBET with wander 0 and zero velocities, accelerations and rates."""
    records = np.zeros((len(trajectory.time), 17), dtype="<f8")
    records[:, 0] = trajectory.time
    records[:, 1] = trajectory.latitude
    records[:, 2] = trajectory.longitude
    records[:, 3] = trajectory.height
    records[:, 7] = trajectory.attitude[:, 0]
    records[:, 8] = -trajectory.attitude[:, 1]
    records[:, 9] = trajectory.attitude[:, 2]
    with written_whole(path) as temporary:
        records.tofile(temporary)


def read_smrmsg(path: Path) -> TrajectoryAccuracy:
    """Read smrmsg: 10 float64 a record; attitude sigmas in arc minutes.

    Raises
    ------
    InputError
        Where the file is missing, cut short, holds NaN, negative sigmas or disordered times.
    """
    path = Path(path)
    records = read_records(path, 10, "smrmsg")
    require_increasing(records[:, 0], path, "smrmsg")
    position, attitude = records[:, 1:4], np.radians(records[:, 7:10] / 60)
    if (position < 0).any() or (attitude < 0).any():
        raise InputError(f"{path}: an accuracy is negative; this is not an smrmsg file.")
    return TrajectoryAccuracy(records[:, 0], position, attitude)


def write_smrmsg(path: Path, accuracy: TrajectoryAccuracy) -> None:
    """Write smrmsg with zero velocity accuracies."""
    records = np.zeros((len(accuracy.time), 10), dtype="<f8")
    records[:, 0] = accuracy.time
    records[:, 1:4] = accuracy.position
    records[:, 7:10] = np.degrees(accuracy.attitude) * 60
    with written_whole(path) as temporary:
        records.tofile(temporary)
