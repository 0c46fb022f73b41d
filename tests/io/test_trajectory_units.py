"""Tests of units in text trajectories, and of the detection of wrong units."""

from pathlib import Path

import numpy as np
import pyproj
import pytest

from lispac.errors import InputError
from lispac.io.formats import format_of, recognise_formats
from lispac.io.trajectory.exail import parse_unit
from lispac.messages import Message, error, note, warning
from lispac.survey.trajectory import Trajectory
from tests.support.message_codes import codes
from tests.support.trajectory_files import vessel, write_records

ASCII, EXAIL, POSPAC = (format_of(key) for key in ("ascii-trajectory", "exail-text", "pospac-text"))
SBET = format_of("sbet")
FOOT, SURVEY_FOOT = 0.3048, 1200 / 3937
NEW_JERSEY = "EPSG:3424"  # in US survey feet
UTM = "EPSG:32618"  # in metres
MICHIGAN = "EPSG:2251"  # in feet of 0.3048 m
IN_METRES = {
    NEW_JERSEY: "+proj=tmerc +lat_0=38.83333333333334 +lon_0=-74.5 +k=0.9999 +x_0=150000 "
    "+ellps=GRS80",
    UTM: "+proj=utm +zone=18 +ellps=WGS84",
    MICHIGAN: "+proj=lcc +lat_0=44.78333333333333 +lon_0=-87 +lat_1=47.08333333333334 "
    "+lat_2=45.48333333333333 +x_0=7999999.999968001 +ellps=GRS80",
}
POSPAC_HEAD = (
    "POS Export Utility\n\nTIME, DISTANCE, EASTING, NORTHING, ELLIPSOID HEIGHT, ROLL, PITCH, "
    "HEADING, EAST VELOCITY, NORTH VELOCITY\n(time in Sec, distance in Meters, position in {0}, "
    "orientation in Degrees, velocity in Meter/Sec)\n\n"
)
EXAIL_HEAD = (
    "# Delph INS export\n# time: UTC time, second\n# easting: Easting, {0}\n"
    "# northing: Northing, {0}\n# ellipsoidHeight: Ellipsoid height, meter\n"
    "# heading: Heading, degree\n# roll: Roll, degree\n# pitch: Pitch, degree\n"
    "#time\teasting\tnorthing\tellipsoidHeight\theading\troll\tpitch\n"
)


FEET, US_FEET = note("unit.feet"), note("unit.us_survey_feet")


def name_of_unit(trajectory: Trajectory, column: str) -> object:
    """Return the unit in which a column was read."""
    return next(
        each.params["unit"] for each in trajectory.assumptions
        if each.params.get("column") == column
    )  # fmt: skip


def gridded(crs: str, unit: float) -> tuple[np.ndarray, np.ndarray]:
    """Return records, and rows of time, easting, northing, height and attitude by PROJ."""
    records = vessel(1000)
    lon, lat = np.degrees(records[:, 2]), np.degrees(records[:, 1])
    east, north = pyproj.Proj(IN_METRES[crs])(lon, lat)
    angles = np.degrees(records[:, [7, 8, 9]])
    rows = [records[:, 0], east / unit, north / unit, records[:, 3], *angles.T]
    return records, np.stack(rows, axis=1)


def write(path: Path, head: str, rows: np.ndarray, separator: str) -> Path:
    body = "\n".join(separator.join(f"{value:.9f}" for value in row) for row in rows)
    path.write_text(head + body + "\n", encoding="utf-8")
    return path


def largest_position_error(trajectory: Trajectory, records: np.ndarray) -> float:
    """Return the largest error of positions in metres."""
    north = (trajectory.latitude - records[:, 1]) * 6.4e6
    east = (trajectory.longitude - records[:, 2]) * 6.4e6 * np.cos(records[:, 1])
    return float(np.abs([north, east, trajectory.height - records[:, 3]]).max())


@pytest.mark.parametrize("crs", [NEW_JERSEY, UTM, MICHIGAN])
@pytest.mark.parametrize(
    ("word", "unit"),
    [("Meters", 1.0), ("US Survey Feet", SURVEY_FOOT), ("International Feet", FOOT)],
)
def test_pospac_positions_are_converted_to_the_unit_of_the_system(
    tmp_path: Path, word: str, unit: float, crs: str
) -> None:
    records, rows = gridded(crs, unit)
    rows[:, 3] /= unit
    rows = np.insert(np.column_stack([rows, rows[:, :2]]), 1, 0.0, axis=1)
    path = write(tmp_path / "a.txt", POSPAC_HEAD.format(word), rows, " ")
    assert recognise_formats(path, "trajectory")[0][0] is POSPAC
    assert largest_position_error(POSPAC.read(path, {"crs": crs}), records) < 1e-4


@pytest.mark.parametrize(
    ("crs", "unit"), [(NEW_JERSEY, SURVEY_FOOT), (MICHIGAN, FOOT), (UTM, FOOT)]
)
def test_feet_without_a_name_are_the_feet_of_the_system(
    tmp_path: Path, crs: str, unit: float
) -> None:
    records, rows = gridded(crs, unit)
    rows[:, 3] /= unit
    rows = np.insert(np.column_stack([rows, rows[:, :2]]), 1, 0.0, axis=1)
    path = write(tmp_path / "a.txt", POSPAC_HEAD.format("Feet"), rows, " ")
    trajectory = POSPAC.read(path, {"crs": crs})
    assert largest_position_error(trajectory, records) < 1e-4
    easting = name_of_unit(trajectory, "EASTING")
    of_system = {
        NEW_JERSEY: note("unit.feet_of_system", unit=US_FEET),
        MICHIGAN: note("unit.feet_of_system", unit=FEET),
    }
    assert easting == of_system.get(crs, FEET)
    file_warnings = POSPAC.preview(path, {"crs": crs}).file_warnings
    assert ("trajectory.feet_not_specified" in codes(file_warnings)) == (crs == UTM)


@pytest.mark.parametrize(
    ("mark", "unit", "name"),
    [
        ("[ft]", SURVEY_FOOT, note("unit.feet_of_system", unit=US_FEET)),
        ("[m]", 1.0, note("unit.metres")),
        ("(ftUS)", SURVEY_FOOT, US_FEET),
        ("[US ft]", SURVEY_FOOT, US_FEET),
        ("[ift]", FOOT, FEET),
        ("", SURVEY_FOOT, note("unit.as_in_system", unit=US_FEET)),
    ],
)
def test_generic_text_uses_the_unit_in_the_names(
    tmp_path: Path, mark: str, unit: float, name: Message
) -> None:
    records, rows = gridded(NEW_JERSEY, unit)
    head = f"Time[s],Easting{mark},Northing{mark},Height[m],Roll[deg],Pitch[deg],Heading[deg]\n"
    path = write(tmp_path / "a.csv", head, rows, ",")
    finding = ASCII.preview(path, {"crs": NEW_JERSEY})
    trajectory = ASCII.read(path, finding.choice)
    assert largest_position_error(trajectory, records) < 1e-4
    assert name_of_unit(trajectory, "easting") == name


def test_a_given_unit_takes_precedence_over_the_names(tmp_path: Path) -> None:
    records, rows = gridded(NEW_JERSEY, FOOT)
    head = "Time,Easting[m],Northing[m],Height[m],Roll[deg],Pitch[deg],Heading[deg]\n"
    path = write(tmp_path / "a.csv", head, rows, ",")
    options = {"crs": NEW_JERSEY, "grid_unit": "international-feet"}
    assert (
        largest_position_error(ASCII.read(path, ASCII.preview(path, options).choice), records)
        < 1e-4
    )


def test_heights_without_unit_are_metres_unless_the_system_has_heights(tmp_path: Path) -> None:
    records, rows = gridded(NEW_JERSEY, SURVEY_FOOT)
    head = "Time,Easting,Northing,Height,Roll[deg],Pitch[deg],Heading[deg]\n"
    path = write(tmp_path / "a.csv", head, rows, ",")
    finding = ASCII.preview(path, {"crs": NEW_JERSEY})
    assert largest_position_error(ASCII.read(path, finding.choice), records) < 1e-4
    assert "trajectory.height_unit_not_stated" in codes(finding.file_warnings)
    rows[:, 3] /= SURVEY_FOOT
    write(path, head, rows, ",")
    finding = ASCII.preview(path, {"crs": f"{NEW_JERSEY}+6360"})  # NAVD88 height (ftUS)
    trajectory = ASCII.read(path, finding.choice)
    assert largest_position_error(trajectory, records) < 1e-4
    assert name_of_unit(trajectory, "height") == note("unit.as_in_system", unit=US_FEET)
    assert "trajectory.height_unit_not_stated" not in codes(finding.file_warnings)


@pytest.mark.parametrize(("word", "unit"), [("US survey feet", SURVEY_FOOT), ("meter", 1.0)])
def test_exail_text_may_be_in_a_projected_system(tmp_path: Path, word: str, unit: float) -> None:
    records, rows = gridded(NEW_JERSEY, unit)
    rows[:, 5] *= -1
    path = write(tmp_path / "a.txt", EXAIL_HEAD.format(word), rows[:, [0, 1, 2, 3, 6, 4, 5]], "\t")
    assert recognise_formats(path, "trajectory")[0][0] is EXAIL
    assert (
        largest_position_error(EXAIL.read(path, {"crs": NEW_JERSEY, "time": "gps-week"}), records)
        < 1e-4
    )
    with pytest.raises(InputError, match=r"a\.txt") as refused:
        EXAIL.read(path, {"time": "gps-week"})
    assert refused.value.code == "trajectory.no_system"


@pytest.mark.parametrize(
    ("words", "unit"),
    [
        ("US Survey Feet", "us-ft"), ("U.S. Survey Foot", "us-ft"), ("survey feet", "us-ft"),
        ("Easting[ftUS]", "us-ft"), ("East (us-ft)", "us-ft"), ("International feet", "int-ft"),
        ("[ift]", "int-ft"), ("Height(ft)", "ft"), ("feet", "ft"), ("Easting [m]", "m"),
    ],
)  # fmt: skip
def test_names_of_feet_are_recognised(words: str, unit: str) -> None:
    assert parse_unit(words) == unit


def velocity_warnings(path: Path, word: str, unit: float, factor: float) -> tuple[Message, ...]:
    """Return the warnings about positions in a unit named ``word`` in the header.

    The unit is `unit` metres long, and the velocities are scaled by `factor`.
    """
    records, rows = gridded(NEW_JERSEY, unit)
    course = records[:, 9] - np.radians(2)
    speed = factor * np.stack([4 * np.sin(course), 4 * np.cos(course)], axis=1)
    rows = np.insert(np.column_stack([rows, speed]), 1, 0.0, axis=1)
    write(path, POSPAC_HEAD.format(word), rows, " ")
    return POSPAC.preview(path, {"crs": NEW_JERSEY}).file_warnings


def test_a_wrong_unit_is_detected_from_the_velocities(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    right = codes(velocity_warnings(path, "Meters", 1.0, 1.0))
    assert not any("speed_differs" in code for code in right)
    (wrong,) = (
        each for each in velocity_warnings(path, "US Survey Feet", 1.0, 1.0)
        if each.code == "trajectory.speed_differs_by_feet"
    )  # fmt: skip
    assert wrong.params["ratio"] == pytest.approx(0.305, abs=5e-4)
    assert wrong.params["east"] == "EAST VELOCITY"
    (knots,) = (
        each for each in velocity_warnings(path, "Meters", 1.0, 1.9438)
        if each.code == "trajectory.speed_differs"
    )  # fmt: skip
    assert knots.params["ratio"] == pytest.approx(0.514, abs=5e-4)


def test_an_implausible_speed_gives_a_warning(tmp_path: Path) -> None:
    for times, has_warning in ((1, False), (20, True)):
        records = vessel(1000)
        rows = np.column_stack([records[:, 0], np.degrees(records[:, [1, 2]]), records[:, 3]])
        rows[:, 1:3] = rows[0, 1:3] + times * (rows[:, 1:3] - rows[0, 1:3])
        rows = np.column_stack([rows, np.degrees(records[:, [7, 8, 9]])])
        head = "Time,Latitude,Longitude,Height,Roll,Pitch,Heading\n"
        path = write(tmp_path / "a.csv", head, rows, ",")
        file_warnings = ASCII.preview(path, {}).file_warnings
        assert ("trajectory.fast" in codes(file_warnings)) == has_warning


def test_a_jump_of_an_sbet_gives_a_warning(tmp_path: Path) -> None:
    records = vessel(2000)
    path = write_records(tmp_path / "a.sbet", records)
    assert "trajectory.jumps" not in codes(SBET.preview(path, {}).file_warnings)
    records[1200:, 1] += 300 / 6.4e6
    write_records(path, records)
    assert "trajectory.jumps" in codes(SBET.preview(path, {}).file_warnings)


@pytest.mark.parametrize(("unit", "is_warned"), [(FOOT, True), (1.0, False)])
def test_positions_outside_the_area_of_the_system_give_a_warning(
    tmp_path: Path, unit: float, is_warned: bool
) -> None:
    """The positions are in feet without a statement, in a system in metres."""
    _, rows = gridded(UTM, unit)
    path = write(tmp_path / "a.csv", "time,easting,northing,height,roll,pitch,heading\n", rows, ",")
    found = [
        (each.params["system"], each.params["name"])
        for each in ASCII.preview(path, {"crs": UTM}).file_warnings
        if each.code == "trajectory.other_area"
    ]
    assert found == ([(UTM, "WGS 84 / UTM zone 18N")] if is_warned else [])


@pytest.mark.parametrize("with_preview", [True, False])
def test_heights_in_degrees_are_refused(tmp_path: Path, with_preview: bool) -> None:
    _, rows = gridded(UTM, 1.0)
    head = EXAIL_HEAD.format("meter").replace("Ellipsoid height, meter", "Ellipsoid height, degree")
    path = write(tmp_path / "a.txt", head, rows[:, [0, 1, 2, 3, 6, 4, 5]], "\t")
    with pytest.raises(InputError) as refused:
        EXAIL.read(path, {"crs": UTM})
    column = {"file": str(path), "column": "ellipsoidHeight", "unit": "deg"}
    assert refused.value.message == error("trajectory.not_a_length", **column)
    if with_preview:
        named = warning("trajectory.not_a_length", **{**column, "file": path.name})
        assert named in EXAIL.preview(path, {"crs": UTM}).file_warnings


def test_angles_in_metres_are_refused(tmp_path: Path) -> None:
    _, rows = gridded(UTM, 1.0)
    head = EXAIL_HEAD.format("meter").replace("Roll, degree", "Roll, meter")
    path = write(tmp_path / "a.txt", head, rows[:, [0, 1, 2, 3, 6, 4, 5]], "\t")
    with pytest.raises(InputError) as refused:
        EXAIL.read(path, {"crs": UTM})
    column = {"file": str(path), "column": "roll", "unit": "m"}
    assert refused.value.message == error("trajectory.not_an_angle", **column)
