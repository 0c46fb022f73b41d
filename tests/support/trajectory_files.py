"""Trajectory files as written by other programs, made with struct and as plain text."""

import struct
from collections.abc import Callable
from pathlib import Path

import numpy as np

from tests.support.point_files import cidco

RADIUS = 6378137.0


def vessel(count: int = 2000, *, rate: float = 50.0, wander: float = 0.0) -> np.ndarray:
    """SBET records, shape (n, 17), of a vessel on a wide circle.

    The motion reveals wrong frames and signs. Velocities are along the wander azimuth, left, up;
    rates are those of forward, starboard, down.
    """
    t = np.arange(count) / rate
    speed, turn = 4.0, np.radians(4.0)
    course = 0.3 + turn * t
    north = speed / turn * (np.sin(course) - np.sin(0.3))
    east = speed / turn * (np.cos(0.3) - np.cos(course))
    up = 0.4 * np.sin(0.8 * t)
    roll, pitch = np.radians(3) * np.sin(0.9 * t), np.radians(2) * np.sin(0.7 * t + 0.4)
    heading = course + np.radians(2)
    latitude = np.radians(45.5) + north / (RADIUS * 0.9983)
    longitude = np.radians(-73.5) + east / (RADIUS * 1.0017 * np.cos(np.radians(45.5)))
    azimuth = course + wander
    rates = [
        np.gradient(roll, t) - np.gradient(heading, t) * np.sin(pitch),
        np.gradient(pitch, t) * np.cos(roll) + np.gradient(heading, t) * np.sin(roll),
        np.gradient(heading, t) * np.cos(roll) - np.gradient(pitch, t) * np.sin(roll),
    ]
    velocity = [speed * np.cos(azimuth), -speed * np.sin(azimuth), np.gradient(up, t)]
    zero = np.zeros(count)
    columns = [486_000 + t, latitude, longitude, 10 + up, *velocity, roll, pitch, heading + wander]
    return np.stack([*columns, zero + wander, zero, zero, zero, *rates], axis=1)


def write_records(path: Path, records: np.ndarray, *, order: str = "<") -> Path:
    """Write records as float64, one after the other, with struct."""
    width = records.shape[1]
    path.write_bytes(b"".join(struct.pack(f"{order}{width}d", *row) for row in records))
    return path


DELPH_HEADER = """# DELPH INS Navigation export
#
# date: Date of validity (yyyy/mm/dd)
# time: Time of validity (hh:mm:ss.ssss)
# latitude: Latitude, decimal degree
# longitude: Longitude, decimal degree
# ellipsoidHeight: Height, meter positive upward
# heading: Heading, degree
# roll: Roll, degree
# pitch: Pitch, degree
# heave: Heave, meter positive upward
{extra}#
#date\ttime\tlatitude\tlongitude\tellipsoidHeight\theading\troll\tpitch\theave{names}
"""
DELPH_SIGMAS = """# latitudeSd: Standard deviation on latitude, meter
# longitudeSd: Standard deviation on longitude, meter
# altitudeSd: Standard deviation on altitude, meter
# headingSd: Standard deviation on heading, degree
# rollSd: Standard deviation on roll, degree
# pitchSd: Standard deviation on pitch, degree
"""
SIGMAS = (0.012, 0.013, 0.021, 0.015, 0.008, 0.009)


def write_delph(path: Path, records: np.ndarray, *, sigmas: bool = False) -> Path:
    """Write a navigation export of Delph INS, pitch positive bow down, 2023-06-27 from 14:00."""
    names = ["latitudeSd", "longitudeSd", "altitudeSd", "headingSd", "rollSd", "pitchSd"]
    text = DELPH_HEADER.format(
        extra=DELPH_SIGMAS if sigmas else "",
        names="".join(f"\t{name}" for name in names) if sigmas else "",
    )
    for row in records:
        seconds = row[0] - records[0, 0]
        clock = f"14:{int(seconds // 60):02d}:{seconds % 60:07.4f}"
        lat, lon, roll, pitch, heading = np.degrees([row[1], row[2], row[7], -row[8], row[9]])
        fields = [
            "2023/06/27", clock, f"{lat:.9f}", f"{lon:.9f}", f"{row[3]:.4f}",
            f"{heading % 360:.5f}", f"{roll:.5f}", f"{pitch:.5f}", "0.0",
        ]  # fmt: skip
        fields += [f"{value:.4f}" for value in SIGMAS] if sigmas else []
        text += "\t".join(fields) + "\n"
    path.write_text(text, encoding="utf-8")
    return path


POSPAC_HEADER = """****************************************************************
 POS Export Utility
 Copyright (C) 1997-2018 by Applanix Corporation      [May 17 2018]
 All rights reserved.
****************************************************************

 Parameter setup:
 POSPROC SBET file: D:\\harbour\\sbet_Mission 1.out
 Mission Start Time:
   Date of Mission: 2018-08-07
   Start Time: 06:38:26
 Mapping frame epoch: 2018.597260
 Mapping frame datum: WGS84  ; Mapping frame projection : TM;
 central meridian = 9.000000 deg;
 Boresight values: tx =        0.0000 arc min, ty =        0.0000 arc min, tz = 0.0000 arc min.
 TIME, DISTANCE, EASTING, NORTHING, ELLIPSOID HEIGHT, LATITUDE, LONGITUDE, ELLIPSOID HEIGHT, ROLL, \
PITCH, HEADING, EAST VELOCITY, NORTH VELOCITY, UP VELOCITY, EAST SD, NORTH SD, HEIGHT SD, ROLL SD, \
PITCH SD, HEADING SD

  (time in Sec, distance in Meters, position in Meters, lat, long in Degrees, orientation angles \
and SD in Degrees, velocity in Meter/Sec, position SD in Meters)

"""


def write_pospac(path: Path, records: np.ndarray) -> Path:
    """Write an export of the POS Export Utility of POSPac, with columns separated by blanks."""
    text = POSPAC_HEADER
    for row in records:
        lat, lon, roll, pitch, heading = np.degrees([row[1], row[2], row[7], row[8], row[9]])
        place = f"{0:12.3f} {4e5:14.3f} {5e6:14.3f} {row[3]:10.4f} {lat:15.9f} {lon:15.9f}"
        angles = f"{roll:11.6f} {pitch:11.6f} {heading % 360:11.6f}"
        north, east, height, of_heading, of_roll, of_pitch = SIGMAS
        sigmas = f"{east} {north} {height} {of_roll} {of_pitch} {of_heading}"
        text += f"{row[0]:14.5f} {place} {row[3]:10.4f} {angles} 0 0 0 {sigmas}\n"
    path.write_text(text, encoding="utf-8")
    return path


INERTIAL_EXPLORER_HEADER = """
Project:     harbour
Program:     Inertial Explorer Version 8.90.2428
Profile:     Survey
Source:      GNSS/INS Epochs(Smoothed TC Combined)

Datum:       WGS84, (processing datum)
Master 1:    Name quay, Status ENABLED
             Antenna height 0.055 m, to L1-PC (Generic)
             Position 45 30 00.00000, -73 30 00.00000, 31.000 m (WGS84, Ellipsoidal hgt)
UTC Offset:  18 s

"""


def write_inertial_explorer(
    path: Path, records: np.ndarray, *, dms: bool = True, separator: str = " "
) -> Path:
    """Write a text export of NovAtel Inertial Explorer; blanks as separator align the columns."""
    place = "(+/-D M S)" if dms else "(deg)"
    titles = [
        ("GPSTime", "(sec)"), ("Date", "(MDY)"), ("Latitude", place), ("Longitude", place),
        ("H-Ell", "(m)"), ("VEast", "(m/s)"), ("VNorth", "(m/s)"), ("Roll", "(Deg)"),
        ("Pitch", "(Deg)"), ("Heading", "(Deg)"), ("Q", ""), ("SDNorth", "(m)"), ("SDEast", "(m)"),
        ("SDHeigh", "(m)"), ("RollSD", "(Deg)"), ("PitchSD", "(Deg)"), ("HdngSD", "(Deg)"),
    ]  # fmt: skip
    north, east, height, of_heading, of_roll, of_pitch = SIGMAS
    rows = [[name for name, _ in titles], [unit for _, unit in titles]]
    for row in records:
        lat, lon, roll, pitch, heading = np.degrees([row[1], row[2], row[7], row[8], row[9]])
        rows.append([
            f"{row[0]:.3f}", "6/27/2023", *(_angle(value, dms=dms) for value in (lat, lon)),
            f"{row[3]:.4f}", f"{-row[5]:.4f}", f"{row[4]:.4f}", f"{roll:.10f}", f"{pitch:.10f}",
            f"{heading % 360:.10f}", "1",
            *(str(value) for value in (north, east, height, of_roll, of_pitch, of_heading)),
        ])  # fmt: skip
    lines = [
        "".join(f"{value:>18}" for value in fields) if separator == " " else separator.join(fields)
        for fields in rows
    ]
    path.write_text(INERTIAL_EXPLORER_HEADER + "\n".join(lines) + "\n", encoding="utf-8")
    return path


def _angle(degrees: float, *, dms: bool) -> str:
    """Decimal degrees, or degrees, minutes and seconds with one sign: ``-73 29 59.87650``."""
    if not dms:
        return f"{degrees:.10f}"
    seconds = round(abs(degrees) * 3600, 6)
    minutes, seconds = divmod(seconds, 60)
    sign = "-" if degrees < 0 else ""
    return f"{sign}{int(minutes // 60)} {int(minutes % 60):02d} {seconds:09.6f}"


def write_pof(
    path: Path, records: np.ndarray, *, minor: int = 1, unit: int = 2, system: int = 0
) -> Path:
    """Write a RIEGL POF, as the public reader ``pos`` (docs.rs/pos) reads it, of 2023-06-27.

    Parameters
    ----------
    minor : minor version; from 1 on, the records contain the distance
    unit : 0 for times from some start, 1 for those of the day, 2 for those of the week
    system : 0 for GPS time, 1 for UTC, 2 for an unknown time
    """
    lon, lat = np.degrees(records[:, 2]), np.degrees(records[:, 1])
    steps = np.diff(records[:, 0])
    head = struct.pack("<27sHHIHHHq", b"RIEGL POF", 1, minor, 320, 2023, 6, 27, len(records))
    for values in (lon, lat, records[:, 3]):
        head += struct.pack("<2d", values.min(), values.max())
    head += struct.pack("<3d", steps.mean(), steps.max(), steps.std()) if len(steps) else bytes(24)
    head += struct.pack("<BB", unit, system) + struct.pack("<16s16s32s32s32s32s32s", *[b""] * 7)
    rows = [head.ljust(320, b"\0")]
    for k, row in enumerate(records):
        roll, pitch, yaw = np.degrees([row[7], row[8], row[9] - row[10]])
        values = [row[0], lon[k], lat[k], row[3], roll, pitch, yaw % 360, 0.0]
        rows.append(struct.pack(f"<{7 + min(minor, 1)}d", *values[: 7 + min(minor, 1)]))
    path.write_bytes(b"".join(rows))
    return path


def truth(records: np.ndarray) -> dict[str, np.ndarray]:
    """Position and attitude in the convention of the program."""
    attitude = np.stack([records[:, 7], -records[:, 8], records[:, 9] - records[:, 10]], axis=1)
    return {
        "latitude": records[:, 1],
        "longitude": records[:, 2],
        "height": records[:, 3],
        "attitude": attitude,
    }


def _write_smrmsg(path: Path) -> Path:
    sigmas = np.full((200, 10), 0.02)
    sigmas[:, 0] = vessel(200)[:, 0]
    return write_records(path, sigmas)


def _write_columns(path: Path) -> Path:
    """Write text with the default columns of the program, without their names."""
    records = vessel(200)
    degrees = np.degrees(records[:, [1, 2, 7, 8, 9]])
    np.savetxt(
        path,
        np.column_stack([records[:, 0], degrees[:, :2], records[:, 3], degrees[:, 2:]]),
        "%.12f",
    )
    return path


VALID_FILES: dict[str, Callable[[Path], Path]] = {
    "sbet": lambda path: write_records(path, vessel(200)),
    "exail-text": lambda path: write_delph(path, vessel(200)),
    "exail-sigmas": lambda path: write_delph(path, vessel(200), sigmas=True),
    "pospac-text": lambda path: write_pospac(path, vessel(200)),
    "pospac-sigmas": lambda path: write_pospac(path, vessel(200)),
    "inertial-explorer-text": lambda path: write_inertial_explorer(path, vessel(200)),
    "inertial-explorer-sigmas": lambda path: write_inertial_explorer(path, vessel(200)),
    "pof": lambda path: write_pof(path, vessel(200)),
    "ascii-trajectory": _write_columns,
    "smrmsg": _write_smrmsg,
    "cidco-states": cidco,
    "cidco-sigmas": cidco,
}
"""Writer of a valid file of each format of trajectories and accuracies, by its key."""
