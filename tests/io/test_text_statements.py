"""Tests that names, units and hemispheres in the header of a text file are used."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lispac.errors import InputError
from lispac.io.formats import recognise_formats
from lispac.io.text.text_table import degrees_and_minutes, degrees_minutes_seconds
from lispac.survey.trajectory import Trajectory
from tests.io.test_text_units import points
from tests.support.error_codes import has_code

TIME = 1000.0 + 0.01 * np.arange(50)
XYZ = np.stack([0.1 * np.arange(50), 5 + 0.02 * np.arange(50), -2 + 0.03 * np.arange(50)], axis=1)
RANGE = np.linalg.norm(XYZ, axis=1)
AZIMUTH = np.degrees(np.arctan2(XYZ[:, 1], XYZ[:, 0]))
ELEVATION = np.degrees(np.arcsin(XYZ[:, 2] / RANGE))


@pytest.mark.parametrize(
    ("head", "order"),
    [
        ("time,range,azimuth,elevation,x,y,z", "traexyz"),
        ("time,x,y,elevation,azimuth,z", "txyeaz"),
        ("Time,X,Y,Elevation (deg),Z,Range", "txyezr"),
        ("elevation,azimuth,time,x,y,height", "eatxyz"),
    ],
)
def test_an_elevation_with_a_range_or_coordinates_is_an_angle(
    tmp_path: Path, head: str, order: str
) -> None:
    columns = {
        "t": TIME, "r": RANGE, "a": AZIMUTH, "e": ELEVATION,
        "x": XYZ[:, 0], "y": XYZ[:, 1], "z": XYZ[:, 2],
    }  # fmt: skip
    chunk = points(tmp_path / "a.csv", head, *(columns[letter] for letter in order))
    np.testing.assert_allclose(chunk.xyz, XYZ, atol=1e-8)


def test_an_elevation_without_another_height_is_a_height(tmp_path: Path) -> None:
    chunk = points(tmp_path / "a.csv", "time,x,y,elevation", TIME, *XYZ.T)
    np.testing.assert_allclose(chunk.xyz, XYZ, atol=1e-8)


def test_exact_names_take_precedence_over_synonyms(tmp_path: Path) -> None:
    chunk = points(tmp_path / "a.csv", "t,seconds,time,east,x,y,z", 0 * TIME, TIME + 5, TIME,
                   XYZ[:, 0] + 9, *XYZ.T)  # fmt: skip
    np.testing.assert_allclose(chunk.xyz, XYZ, atol=1e-8)
    np.testing.assert_allclose(chunk.time, TIME)


@pytest.mark.parametrize(
    ("name", "factor"),
    [("time [ms]", 1e3), ("Time (us)", 1e6), ("time_ms", 1e3), ("t [ns]", 1e9), ("time [s]", 1.0)],
)
def test_the_unit_of_the_time_is_used(tmp_path: Path, name: str, factor: float) -> None:
    chunk = points(tmp_path / "a.csv", f"{name},x,y,z", TIME * factor, *XYZ.T)
    np.testing.assert_allclose(chunk.time, TIME, rtol=1e-12)


@pytest.mark.parametrize(
    ("unit", "metres"),
    [("[mm]", 1e-3), ("(ft)", 0.3048), ("[m]", 1.0), ("[us-ft]", 1200 / 3937)],
)
def test_the_unit_of_coordinates_is_used(tmp_path: Path, unit: str, metres: float) -> None:
    head = f"time,x {unit},y {unit},z {unit}"
    chunk = points(tmp_path / "a.csv", head, TIME, *(XYZ / metres).T)
    np.testing.assert_allclose(chunk.xyz, XYZ, rtol=1e-6, atol=1e-8)


# -- trajectories ---------------------------------------------------------------------------------

LATITUDE, LONGITUDE = -33.85 + 1e-6 * np.arange(50), -69.25 - 1e-6 * np.arange(50)
OTHER_COLUMNS = "Height,Roll,Pitch,Heading"


def dm(value: float) -> str:
    degrees, minutes = divmod(round(abs(value) * 60, 9), 60)
    return f"{int(degrees) * 100 + minutes:.9f}"


def dms(value: float, sign: str) -> str:
    seconds = round(abs(value) * 3600, 7)
    return f"{sign}{int(seconds // 3600)}°{int(seconds % 3600 // 60)}'{seconds % 60:.7f}"


NOTATIONS = {
    "signed": ("Latitude,Longitude", lambda a, o: f"{a:.10f},{o:.10f}"),
    "columns N/S and E/W": (
        "Latitude,N/S,Longitude,E/W", lambda a, o: f"{-a:.10f},S,{-o:.10f},W",
    ),
    "columns of any name": (
        "Latitude,Hem,Longitude,Hem2", lambda a, o: f"{-a:.10f},S,{-o:.10f},W",
    ),
    "positive west in the header": (
        "Latitude,Longitude [deg W]", lambda a, o: f"{a:.10f},{-o:.10f}",
    ),
    "letters behind": ("Latitude,Longitude", lambda a, o: f"{-a:.10f}S,{-o:.10f}W"),
    "letters before": ("Latitude,Longitude", lambda a, o: f"S{-a:.10f},W{-o:.10f}"),
    "letters after a blank": ("Latitude,Longitude", lambda a, o: f"{-a:.10f} S,{-o:.10f} W"),
    "as NMEA": ("Latitude,N/S,Longitude,E/W", lambda a, o: f"{dm(a)},S,{dm(o)},W"),
    "degrees, minutes and seconds": (
        "Latitude,Longitude", lambda a, o: f"{dms(a, '-')},{dms(o, '-')}",
    ),
    "seconds and letters": ("Latitude,Longitude", lambda a, o: f"{dms(a, '')}S,{dms(o, '')}W"),
    "0 to 360": ("Latitude,Longitude", lambda a, o: f"{a:.10f},{o % 360:.10f}"),
}  # fmt: skip


def trajectory(path: Path) -> Trajectory:
    format = recognise_formats(path, "trajectory")[0][0]
    read = format.read(path, format.preview(path, {}).choice)
    assert isinstance(read, Trajectory)
    return read


@pytest.mark.parametrize("notation", NOTATIONS)
def test_positions_in_any_notation_are_read(tmp_path: Path, notation: str) -> None:
    names, row = NOTATIONS[notation]
    lines = [f"Time,{names},{OTHER_COLUMNS}"]
    lines += [
        f"{t:.3f},{row(a, o)},12.5,1.0,-2.0,200.0"
        for t, a, o in zip(TIME, LATITUDE, LONGITUDE, strict=True)
    ]
    path = tmp_path / "track.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    read = trajectory(path)
    np.testing.assert_allclose(np.degrees(read.latitude), LATITUDE, rtol=0, atol=1e-8)
    np.testing.assert_allclose(np.degrees(read.longitude), LONGITUDE, rtol=0, atol=1e-8)


def test_a_sign_and_a_hemisphere_contradict_each_other(tmp_path: Path) -> None:
    path = tmp_path / "track.csv"
    rows = [f"{t:.3f},-33.85,S,-69.25,W,12.5,1,2,200" for t in TIME]
    path.write_text("\n".join([f"Time,Latitude,N/S,Longitude,E/W,{OTHER_COLUMNS}", *rows]))
    contradiction = has_code("trajectory.sign_and_hemisphere", row=2, role="latitude")
    with pytest.raises(InputError, check=contradiction):
        trajectory(path)


@pytest.mark.parametrize(("name", "factor"), [("Time [ms]", 1e3), ("Time_us", 1e6)])
def test_the_time_of_a_trajectory_has_the_unit_of_its_name(
    tmp_path: Path, name: str, factor: float
) -> None:
    path = tmp_path / "track.csv"
    rows = [f"{t * factor:.3f},-33.85,-69.25,12.5,1,2,200" for t in TIME]
    path.write_text("\n".join([f"{name},Latitude,Longitude,{OTHER_COLUMNS}", *rows]))
    np.testing.assert_allclose(trajectory(path).time, TIME, rtol=1e-9)


@given(st.floats(-180, 180))
def test_angles_are_read_in_every_notation(value: float) -> None:
    sign = "-" if value < 0 else ""
    assert abs(degrees_and_minutes(sign + dm(value)) - value) < 1e-8
    assert abs(degrees_minutes_seconds(dms(value, sign)) - value) < 1e-8


def test_states_before_the_first_fix_are_skipped(tmp_path: Path) -> None:
    zero = np.arange(50) < 7
    read = Trajectory(
        TIME, np.radians(np.where(zero, 0, LATITUDE)), np.radians(np.where(zero, 0, LONGITUDE)),
        12.0 + 0 * TIME, np.zeros((50, 3)),
    ).with_positions_only()  # fmt: skip
    assert len(read.time) == 43
    assert read.mean_frame().latitude == pytest.approx(np.radians(LATITUDE[~zero].mean()))
    assert read.mean_frame().longitude == pytest.approx(np.radians(LONGITUDE[~zero].mean()))
    (message,) = read.messages
    assert (message.code, message.params["count"]) == ("trajectory.no_position", 7)
    with pytest.raises(InputError):
        Trajectory(TIME, 0 * TIME, 0 * TIME, 0 * TIME, np.zeros((50, 3))).with_positions_only()
