"""Tests of units, axis directions and hemispheres in text: used or refused, never ignored."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.format_types import FilePreview, PointChunk
from lispac.io.formats import format_of, recognise_formats
from lispac.io.text.seed_file import read_point_list
from lispac.io.units import UNKNOWN, direction_of, is_units_row, split_title, title_unit
from lispac.messages import Level
from lispac.survey.trajectory import Trajectory
from lispac.workflow.importing.line_points import read_chunks

COUNT = 80
TIME = 1000 + 0.1 * np.arange(COUNT)
LATITUDE, LONGITUDE = -33.85 + 1e-6 * np.arange(COUNT), -69.25 - 2e-6 * np.arange(COUNT)
HEADING = float(np.degrees(np.arctan2(-2 * np.cos(np.radians(33.85)), 1))) % 360
HEIGHT, ROLL, PITCH = 12.5, 1.0, -2.0
OTHERS = f"{HEIGHT},{ROLL},{PITCH},{HEADING:.6f}"
XYZ = np.stack([0.1 * np.arange(COUNT), 5 + 0.02 * np.arange(COUNT), -2 + 0.0 * TIME], axis=1)
Row = Callable[[float, float, float], str]


def minutes(value: float, digits: int) -> str:
    degrees, rest = divmod(round(abs(value) * 60, 9), 60)
    return f"{int(degrees):0{digits}d}{rest:012.9f}"


def seconds(value: float, between: str) -> str:
    whole = round(abs(value) * 3600, 7)
    return between.join(
        (f"{int(whole // 3600)}", f"{int(whole % 3600 // 60)}", f"{whole % 60:.7f}")
    )


def write(path: Path, head: str, row: Row) -> Path:
    rows = [row(t, a, o) for t, a, o in zip(TIME, LATITUDE, LONGITUDE, strict=True)]
    path.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    return path


def preview_of(path: Path) -> FilePreview:
    return recognise_formats(path, "trajectory")[0][0].preview(path, {})


def read(path: Path) -> Trajectory:
    format = recognise_formats(path, "trajectory")[0][0]
    found = format.read(path, format.preview(path, {}).choice)
    assert isinstance(found, Trajectory)
    return found.with_positions_only()


HEAD = "Time,Latitude,Longitude,Height,Roll,Pitch,Heading"
ACCEPTED: dict[str, tuple[str, Row]] = {
    "E/O is French": (
        "Time,Latitude,N/S,Longitude,E/O,Height,Roll,Pitch,Heading",
        lambda t, a, o: f"{t:.2f},{-a:.9f},S,{-o:.9f},O,{OTHERS}",
    ),
    "O/W is German": (
        "Time,Latitude,N/S,Longitude,O/W,Height,Roll,Pitch,Heading",
        lambda t, a, o: f"{t:.2f},{-a:.9f},S,{-o:.9f},W,{OTHERS}",
    ),
    "words": (
        "Time,Latitude,A,Longitude,B,Height,Roll,Pitch,Heading",
        lambda t, a, o: f"{t:.2f},{-a:.9f},Sud,{-o:.9f},Ouest,{OTHERS}",
    ),
    "row of units": (
        f"{HEAD}\ns,deg,deg,ft,rad,rad,rad",
        lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{HEIGHT / 0.3048:.6f},"
        f"{np.radians(ROLL):.9f},{np.radians(PITCH):.9f},{np.radians(HEADING):.9f}",
    ),
    "row of units with directions": (
        f"{HEAD}\n[ms],[deg S],[deg W],[m],[deg],[deg],[deg]",
        lambda t, a, o: f"{1000 * t:.1f},{-a:.9f},{-o:.9f},{OTHERS}",
    ),
    "LongitudeW": (
        HEAD.replace("Longitude", "LongitudeW"),
        lambda t, a, o: f"{t:.2f},{a:.9f},{-o:.9f},{OTHERS}",
    ),
    "LatitudeS and LongitudeW": (
        HEAD.replace("Longitude", "LongitudeW").replace("Latitude", "LatitudeS"),
        lambda t, a, o: f"{t:.2f},{-a:.9f},{-o:.9f},{OTHERS}",
    ),
    "an elevation in degrees beside a height": (
        f"{HEAD},Elevation [deg]", lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{OTHERS},45.0",
    ),
    "an altitude": (
        HEAD.replace("Height", "Altitude"), lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{OTHERS}",
    ),
    "gons": (
        "Time,Latitude [deg],Longitude [deg],Height [m],Roll [gon],Pitch [gon],Heading [gon]",
        lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{HEIGHT},{ROLL / 0.9:.9f},{PITCH / 0.9:.9f},"
        f"{HEADING / 0.9:.9f}",
    ),
    "a unit for each column": (
        "Time,Latitude [arcmin],Longitude [deg],Height [cm],Roll [deg],Pitch [mrad],Heading [rad]",
        lambda t, a, o: f"{t:.2f},{60 * a:.9f},{o:.9f},{100 * HEIGHT},{ROLL},"
        f"{1000 * np.radians(PITCH):.9f},{np.radians(HEADING):.9f}",
    ),
    "suffixes": (
        "time_ms,lat_deg,lon_deg,height_ft,roll_deg,pitch_deg,heading_deg",
        lambda t, a, o: f"{1000 * t:.1f},{a:.9f},{o:.9f},{HEIGHT / 0.3048:.6f},{ROLL},{PITCH},"
        f"{HEADING:.6f}",
    ),
    "fathoms": (
        HEAD.replace("Height", "Height [fathoms]"),
        lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{HEIGHT / 1.8288:.9f},{ROLL},{PITCH},"
        f"{HEADING:.6f}",
    ),
    "NMEA with its zeros": (
        "Time,Latitude,N/S,Longitude,E/W,Height,Roll,Pitch,Heading",
        lambda t, a, o: f"{t:.2f},{minutes(a, 2)},S,{minutes(o, 3)},W,{OTHERS}",
    ),
    "NMEA with letters behind": (
        HEAD, lambda t, a, o: f"{t:.2f},{minutes(a, 2)}S,{minutes(o, 3)}W,{OTHERS}",
    ),
    "hyphens between degrees, minutes and seconds": (
        HEAD, lambda t, a, o: f"{t:.2f},-{seconds(a, '-')},-{seconds(o, '-')},{OTHERS}",
    ),
    "French": (
        "Temps;Latitude;N/S;Longitude;E/O;Hauteur;Roulis;Tangage;Cap",
        lambda t, a, o: f"{t:.2f};{-a:.9f};S;{-o:.9f};O;{OTHERS.replace(',', ';')}",
    ),
    "minutes of time": (
        HEAD.replace("Time", "Time [min]"),
        lambda t, a, o: f"{t / 60:.9f},{a:.9f},{o:.9f},{OTHERS}",
    ),
}  # fmt: skip


@pytest.mark.parametrize("notation", ACCEPTED)
def test_units_and_hemispheres_of_the_header_are_used(tmp_path: Path, notation: str) -> None:
    found = read(write(tmp_path / "track.csv", *ACCEPTED[notation]))
    np.testing.assert_allclose(found.time - found.time[0], TIME - TIME[0], rtol=0, atol=1e-5)
    np.testing.assert_allclose(np.degrees(found.latitude), LATITUDE, rtol=0, atol=1e-8)
    np.testing.assert_allclose(np.degrees(found.longitude), LONGITUDE, rtol=0, atol=1e-8)
    np.testing.assert_allclose(found.height, HEIGHT, atol=1e-5)
    turned = np.degrees(found.attitude) * [1, -1, 1]
    np.testing.assert_allclose(turned, np.tile([ROLL, PITCH, HEADING], (COUNT, 1)), atol=1e-5)


def test_degrees_and_minutes_near_the_origin_are_recognised(tmp_path: Path) -> None:
    """Below 3 degrees, such values differ from decimal degrees only by their leading zeros."""
    head = "Time,Latitude,N/S,Longitude,E/W,Height,Roll,Pitch,Heading"
    path = write(
        tmp_path / "track.csv", head,
        lambda t, a, o: f"{t:.2f},{minutes(a + 34, 2)},N,{minutes(o + 70, 3)},E,{OTHERS}",
    )  # fmt: skip
    found = read(path)
    np.testing.assert_allclose(np.degrees(found.latitude), LATITUDE + 34, rtol=0, atol=1e-8)
    np.testing.assert_allclose(np.degrees(found.longitude), LONGITUDE + 70, rtol=0, atol=1e-8)


REFUSED: dict[str, tuple[str, Row, str]] = {
    "O alone": (
        "Time,Latitude,N/S,Longitude,Hemisphere of longitude,Height,Roll,Pitch,Heading",
        lambda t, a, o: f"{t:.2f},{-a:.9f},S,{-o:.9f},O,{OTHERS}", "trajectory.letter_o",
    ),
    "degrees that count to O": (
        HEAD.replace("Longitude", "Longitude [deg O]"),
        lambda t, a, o: f"{t:.2f},{a:.9f},{-o:.9f},{OTHERS}", "trajectory.unknown_unit",
    ),
    "grad": (
        HEAD.replace("Heading", "Heading [grad]"),
        lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{OTHERS}", "trajectory.unknown_unit",
    ),
    "a unit that nobody knows": (
        HEAD.replace("Height", "Height [cubits]"),
        lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{OTHERS}", "trajectory.unknown_unit",
    ),
    "three columns": (
        "Time,LatDeg,LatMin,LatSec,LonDeg,LonMin,LonSec,Height,Roll,Pitch,Heading",
        lambda t, a, o: f"{t:.2f},{seconds(a, ',')},{seconds(o, ',')},{OTHERS}",
        "trajectory.several_columns",
    ),
    "letters of the other coordinate": (
        HEAD, lambda t, a, o: f"{t:.2f},{-a:.9f}W,{-o:.9f}S,{OTHERS}", "text.unusable_value",
    ),
    "west by the title and negative": (
        HEAD.replace("Longitude", "LongitudeW"),
        lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{OTHERS}", "trajectory.negative_west",
    ),
    "seconds of arc between blanks": (
        HEAD.replace(",", " "),
        lambda t, a, o: f"{t:.2f} -{seconds(a, ' ')} -{seconds(o, ' ')} {OTHERS.replace(',', ' ')}",
        "trajectory.unnamed_columns",
    ),
    "an angle in metres": (
        HEAD.replace("Roll", "Roll [m]"),
        lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{OTHERS}", "trajectory.not_an_angle",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_ambiguous_columns_are_refused_with_the_cause(tmp_path: Path, case: str) -> None:
    head, row, code = REFUSED[case]
    with pytest.raises(InputError, match=r"track\.csv") as refused:
        read(write(tmp_path / "track.csv", head, row))
    assert refused.value.code == code


@pytest.mark.parametrize(("name", "sign"), [("eo", -1), ("ow", 1)])
def test_the_hemisphere_letter_o_has_an_option(tmp_path: Path, name: str, sign: int) -> None:
    path = write(
        tmp_path / "track.csv", "Time,Latitude,N/S,Longitude,Hem,Height,Roll,Pitch,Heading",
        lambda t, a, o: f"{t:.2f},{-a:.9f},S,{-o:.9f},O,{OTHERS}",
    )  # fmt: skip
    columns = f"time latitude latitude_hemisphere longitude {name} height roll pitch heading"
    format = format_of("ascii-trajectory")
    found = format.read(path, format.preview(path, {"columns": columns}).choice)
    assert isinstance(found, Trajectory)
    np.testing.assert_allclose(np.degrees(found.longitude), -sign * LONGITUDE, rtol=0, atol=1e-8)


@pytest.mark.parametrize("rows", [5, 90, 5000])
def test_rows_before_the_first_fix_are_counted(tmp_path: Path, rows: int) -> None:
    head = "\n".join([HEAD, *(f"{100 + 0.1 * k:.1f},0.0,0,0,0,0,0" for k in range(rows))])
    path = write(tmp_path / "track.csv", head, lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{OTHERS}")
    found = read(path)
    np.testing.assert_allclose(np.degrees(found.latitude), LATITUDE, rtol=0, atol=1e-8)
    (message,) = found.messages
    assert (message.code, message.level) == ("trajectory.no_position", Level.NOTE)
    assert message.params["count"] == rows


@pytest.mark.parametrize(
    ("head", "angle", "codes"),
    [
        (HEAD, HEADING, []),
        (f"{HEAD},Yaw", HEADING, []),  # the exact name takes precedence over its synonym
        (f"{HEAD.replace('Heading', 'Yaw')},Azimuth", HEADING, ["text.two_columns"]),
        (
            HEAD.replace("Heading", "Heading [deg]"), np.radians(HEADING),
            ["trajectory.angles_in_radians"],
        ),
        (HEAD.replace("Time", "Time [ticks]"), HEADING, ["text.unknown_unit"]),
        (HEAD.replace("Heading", "Heading (mag)"), HEADING, ["text.magnetic_heading"]),
    ],
)  # fmt: skip
def test_contradicting_titles_give_warnings(
    tmp_path: Path, head: str, angle: float, codes: list[str]
) -> None:
    path = write(
        tmp_path / "track.csv", head,
        lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},12.5,1,2,{angle:.6f},{angle:.6f}",
    )  # fmt: skip
    messages = preview_of(path).messages
    assert [each.code for each in messages] == codes
    assert all(each.level is Level.WARNING for each in messages)


def test_an_option_that_contradicts_the_header_gives_a_warning(tmp_path: Path) -> None:
    head = HEAD.replace("Height", "Height [ft]")
    path = write(tmp_path / "track.csv", head, lambda t, a, o: f"{t:.2f},{a:.9f},{o:.9f},{OTHERS}")
    format = format_of("ascii-trajectory")
    (message,) = format.preview(path, {"heights": "metres"}).messages
    assert (message.code, message.params["option"]) == ("text.unit_overridden", "heights")
    assert message.actions[0].params == {"name": "heights", "value": "feet"}
    assert not format.preview(path, {"heights": "us-survey-feet"}).messages
    np.testing.assert_allclose(read(path).height, HEIGHT * 0.3048, atol=1e-6)


# -- points ---------------------------------------------------------------------------------------


def points(path: Path, head: str, *columns: np.ndarray) -> PointChunk:
    """Write columns of points below ``head``, and read them with the detected options."""
    np.savetxt(path, np.column_stack(columns), fmt="%.9f", delimiter=",", header=head, comments="")
    text = format_of("text")
    (chunk,) = text.read(path, text.preview(path, {}).choice)
    assert isinstance(chunk, PointChunk)
    return chunk


@pytest.mark.parametrize(
    ("head", "second", "metre"),
    [
        ("time,x,y,z\ns,m,m,m", 1, 1),
        ("time,x,y,z\nms,mm,mm,mm", 1e3, 1e3),
        ("time ms,x_mm,y_mm,z_mm", 1e3, 1e3),
        ("time,x [cm],y [cm],z [cm]", 1, 100),
        ("time,x (in),y (in),z (in)", 1, 1 / 0.0254),
        ("time,x [US survey feet],y [US survey feet],z [US survey feet]", 1, 3937 / 1200),
    ],
)
def test_units_of_points_are_used(tmp_path: Path, head: str, second: float, metre: float) -> None:
    chunk = points(tmp_path / "a.csv", head, TIME * second, *(XYZ * metre).T)
    np.testing.assert_allclose(chunk.xyz, XYZ, rtol=1e-7, atol=1e-8)
    np.testing.assert_allclose(chunk.time, TIME, rtol=1e-10)


def test_an_elevation_in_degrees_is_not_a_height(tmp_path: Path) -> None:
    head = "time,x,y,elevation [deg],h"
    chunk = points(tmp_path / "a.csv", head, TIME, XYZ[:, 0], XYZ[:, 1], 0 * TIME + 7, XYZ[:, 2])
    np.testing.assert_allclose(chunk.xyz, XYZ, atol=1e-8)


@pytest.mark.parametrize(
    ("head", "code"),
    [
        ("time,x,y,z[ft]", "text.several_units"),
        ("time,x [m],y [m],z [cm]", "text.several_units"),
        ("time,x [cubits],y [cubits],z [cubits]", "text.several_units"),
        ("time,range,azimuth,elevation", "text.polar_coordinates"),
    ],
)
def test_different_units_of_one_point_are_refused(tmp_path: Path, head: str, code: str) -> None:
    with pytest.raises(InputError, match=r"a\.csv") as refused:
        points(tmp_path / "a.csv", head, TIME, *XYZ.T)
    assert refused.value.code == code


@pytest.mark.parametrize(
    ("head", "choice", "codes"),
    [
        ("time,x,y,height,h", {}, ["text.two_columns"]),
        ("time,x,y,height,up", {}, ["text.two_columns"]),
        ("time,x,y,z,up", {}, []),
        ("time [ms],x [mm],y [mm],z [mm],i", {"unit": "metre", "time_unit": "second"},
         ["text.unit_overridden"] * 2),
        ("time [ticks],x,y,z,i", {}, ["text.unknown_unit"]),
    ],
)  # fmt: skip
def test_contradicting_titles_of_points_give_warnings(
    tmp_path: Path, head: str, choice: dict[str, str], codes: list[str]
) -> None:
    path = tmp_path / "a.csv"
    np.savetxt(path, np.column_stack([TIME, XYZ, TIME]), delimiter=",", header=head, comments="")
    messages = format_of("text").preview(path, choice).messages
    assert [each.code for each in messages] == codes


# -- seeds ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("head", "factor"),
    [
        ("name,x,y,z", 1.0),
        ("name,x [mm],y [mm],z [mm]", 1e-3),
        ("name,x_ft,y_ft,z_ft", 0.3048),
        ("name,north (cm),west (cm),up (cm)", 0.01),
    ],
)
def test_units_of_seeds_are_used(tmp_path: Path, head: str, factor: float) -> None:
    path = tmp_path / "seeds.csv"
    path.write_text(f"{head}\nT1,100,200,50\n")
    (point,) = read_point_list(path).points
    assert point.coordinates == pytest.approx((100 * factor, 200 * factor, 50 * factor))


def test_feet_of_seeds_are_the_feet_of_the_coordinate_system(tmp_path: Path) -> None:
    path, foot = tmp_path / "seeds.csv", 1200 / 3937
    path.write_text("name,easting [ft],northing [ft],height [m]\nT1,100,200,50\n")
    (point,) = read_point_list(path, local=False, metres=(foot, foot, foot)).points
    assert point.coordinates == pytest.approx((100, 200, 50 / foot))


def test_seeds_in_degrees_west_and_radians_are_read(tmp_path: Path) -> None:
    path = tmp_path / "seeds.csv"
    path.write_text("name,latitude [rad],longitude [deg W],h\nT1,0.5,70.5,3\n")
    (point,) = read_point_list(path, local=False, degrees=True).points
    assert point.coordinates == pytest.approx((-70.5, np.degrees(0.5), 3))


@pytest.mark.parametrize(
    ("head", "row", "code"),
    [
        ("name,latitude,N/S,longitude,E/W,h", "T1,33.85,S,69.25,W,5", "seeds.hemispheres"),
        ("name,latitude,a,longitude,b,h", "T1,33.85,S,69.25,O,5", "seeds.hemispheres"),
        ("name,latitude,longitude,h", "T1,48.5W,4.5N,5", "seeds.unusable_coordinate"),
        ("name,latitude,longitude,h", "T1,4830.25N,00430.5W,5", "seeds.unusable_coordinate"),
    ],
)
def test_hemispheres_of_seeds_are_not_ignored(
    tmp_path: Path, head: str, row: str, code: str
) -> None:
    path = tmp_path / "seeds.csv"
    path.write_text(f"{head}\n{row}\n")
    with pytest.raises(InputError, match=r"seeds\.csv") as refused:
        read_point_list(path, local=False, degrees=True)
    assert refused.value.code == code


@pytest.mark.parametrize("title", ["lon [deg W]", "lon [rad]"])
def test_longitudes_of_points_in_other_notations_are_refused(tmp_path: Path, title: str) -> None:
    with pytest.raises(InputError) as refused:
        points(tmp_path / "a.csv", f"time,{title},lat,h", TIME, *XYZ.T)
    assert refused.value.code == "text.not_degrees"
    assert title in str(refused.value)


@pytest.mark.parametrize("title", ["x [cubits]", "x [deg]", "x [s]"])
def test_seeds_in_another_unit_are_refused(tmp_path: Path, title: str) -> None:
    path = tmp_path / "seeds.csv"
    path.write_text(f"name,{title},y,z\nT1,100,200,50\n")
    with pytest.raises(InputError) as refused:
        read_point_list(path)
    assert refused.value.code == "seeds.not_a_length"
    assert title in str(refused.value)


@pytest.mark.parametrize(
    ("title", "name", "unit", "direction"),
    [
        ("Latitude [deg]", "Latitude", "deg", ""),
        ("Longitude (deg W)", "Longitude", "deg", "west"),
        ("Longitude_W", "Longitude_W", "", "west"),
        ("Latitude [deg S]", "Latitude", "deg", "south"),
        ("Time (GPS s)", "Time", "s", "south"),
        ("Height (ellipsoidal)", "Height", "", ""),
        ("Heading (true)", "Heading", "", ""),
        ("height in m", "height", "m", ""),
        ("Easting_ftUS", "Easting", "us-ft", ""),
        ("RollDeg", "Roll", "deg", ""),
        ("Dir [grad]", "Dir", UNKNOWN, ""),
        ("lon [O]", "lon", UNKNOWN, UNKNOWN),
        ("intensity_raw", "intensity_raw", "", ""),
        ("E", "E", "", ""),
    ],
)
def test_titles_are_parsed(title: str, name: str, unit: str, direction: str) -> None:
    assert split_title(title)[0] == name
    assert title_unit(title) == unit
    assert direction_of(title) == direction


@pytest.mark.parametrize(
    ("row", "units"),
    [
        (["s", "deg", "deg W", "m"], True), (["[s]", "[°]", "", "[m]"], True),
        (["(sec)", "(ft)", "-", "(rad)"], True), (["time", "x", "y", "z"], False),
        (["Time [s]", "X [m]", "Y [m]", "Z [m]"], False), (["US ft", "survey feet"], True),
        (["time s", "x m", "y m", "z m"], False), (["GPS seconds", "m (ellipsoidal)"], True),
        (["E", "N", "h", "s"], False), (["", "", ""], False), (["1", "2", "3"], False),
    ],
)  # fmt: skip
def test_a_row_of_units_is_recognised(row: list[str], units: bool) -> None:
    assert is_units_row(row) == units


@pytest.mark.parametrize(
    ("title", "base"),
    [("time_tai [s]", "tai"), ("TAI", "tai"), ("Unix_Time", "unix"), ("time [s]", None)],
)
def test_the_name_of_a_time_column_gives_its_base(
    tmp_path: Path, title: str, base: str | None
) -> None:
    path = tmp_path / "L1.csv"
    rows = np.column_stack([1_707_304_867.2 + np.linspace(0, 10, 500), np.eye(500, 3) + 5])
    np.savetxt(path, rows, fmt="%.6f", delimiter=",", header=f"{title},x [m],y [m],z [m]",
               comments="")  # fmt: skip
    finding = format_of("text").preview(path, {})
    assert finding.choice.get("time_base") == base
    (chunk,) = read_chunks(format_of("text").read(path, {}))
    assert len(chunk.time) == 500
