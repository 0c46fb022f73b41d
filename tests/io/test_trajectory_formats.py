"""Tests of reading trajectories in all formats."""

import calendar
from pathlib import Path

import numpy as np
import pyproj
import pytest

from lispac.errors import InputError
from lispac.io.format_types import LIKELY, SURE
from lispac.io.formats import (
    ACCURACY_FORMATS,
    POINT_FORMATS,
    TRAJECTORY_FORMATS,
    format_of,
    formats_of,
    recognise_formats,
)
from lispac.io.text.text_table import clock_seconds, date_seconds, degrees_minutes_seconds
from lispac.io.trajectory.sbet import write_smrmsg
from lispac.message_texts import message_text
from lispac.messages import note, warning
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy
from tests.support.message_codes import codes
from tests.support.trajectory_files import (
    SIGMAS,
    truth,
    vessel,
    write_delph,
    write_pospac,
    write_records,
)

ASCII, EXAIL, POSPAC = (format_of(key) for key in ("ascii-trajectory", "exail-text", "pospac-text"))


def agrees(trajectory: Trajectory, records: np.ndarray, *, place: float = 2e-11) -> None:
    """Compare positions to 0.1 mm and attitudes to the digits of the file."""
    right = truth(records)
    np.testing.assert_allclose(trajectory.latitude, right["latitude"], rtol=0, atol=place)
    np.testing.assert_allclose(trajectory.longitude, right["longitude"], rtol=0, atol=place)
    np.testing.assert_allclose(trajectory.height, right["height"], rtol=0, atol=1e-4)
    turned = trajectory.attitude - right["attitude"]
    np.testing.assert_allclose(np.remainder(turned + np.pi, 2 * np.pi) - np.pi, 0, atol=2e-7)


def test_list_of_formats_is_consistent() -> None:
    every = (*TRAJECTORY_FORMATS, *ACCURACY_FORMATS, *POINT_FORMATS)
    assert len({format.key for format in every}) == len(every)
    for kind, formats in (("trajectory", TRAJECTORY_FORMATS), ("accuracy", ACCURACY_FORMATS)):
        assert formats_of(kind) == formats
        for format in formats:
            assert format.kind == kind
            assert format_of(format.key) is format
            assert all(ending == ending.lower() and ending[0] == "." for ending in format.endings)
            for option in format.options:
                assert option.meaning.endswith(".")
                assert not option.choices or option.default in option.choices
    with pytest.raises(InputError, match="sundial") as refused:
        format_of("sundial")
    assert refused.value.code == "formats.unknown"


def test_unknown_options_are_refused(tmp_path: Path) -> None:
    for format in (*TRAJECTORY_FORMATS, *ACCURACY_FORMATS):
        with pytest.raises(InputError, match="wheels") as refused:
            format.read(tmp_path / "a", {"wheels": "4"})
        assert refused.value.code == "formats.unknown_option"
    with pytest.raises(InputError, match=r"pitch.*sideways") as refused:
        EXAIL.preview(tmp_path / "a", {"pitch": "sideways"})
    assert refused.value.code == "formats.invalid_choice"


def test_smrmsg_is_recognised_and_shown(tmp_path: Path) -> None:
    time = 486_000 + np.arange(100.0)
    accuracy = TrajectoryAccuracy(time, np.full((100, 3), 0.02), np.full((100, 3), 2e-4))
    write_smrmsg(tmp_path / "smrmsg.out", accuracy)
    ((format, confidence),) = recognise_formats(tmp_path / "smrmsg.out", "accuracy")
    assert (format.key, confidence) == ("smrmsg", SURE)
    assert recognise_formats(tmp_path / "smrmsg.out", "trajectory") == []
    finding = format.preview(tmp_path / "smrmsg.out", {})
    assert finding.facts["Records"] == 100
    assert finding.facts["Sigma roll"] == note("fact.angles", low=2e-4, high=2e-4)
    assert finding.file_warnings == ()
    np.testing.assert_allclose(format.read(tmp_path / "smrmsg.out", {}).attitude, 2e-4)


def test_formats_of_real_files_are_distinguished(shared_data: Path) -> None:
    harbour = shared_data / "harbour"
    assert recognise_formats(harbour / "trajectory.sbet", "accuracy") == []
    assert recognise_formats(harbour / "smrmsg.out", "trajectory") == []
    assert recognise_formats(harbour / "smrmsg.out", "accuracy")[0][0].key == "smrmsg"
    assert recognise_formats(harbour / "site.json", "trajectory") == []
    assert recognise_formats(harbour / "pass1.laz", "trajectory") == []
    assert recognise_formats(harbour / "none", "trajectory") == []


def test_delph_export_is_read(tmp_path: Path) -> None:
    records = vessel(500)
    path = write_delph(tmp_path / "nav.txt", records)
    assert recognise_formats(path, "trajectory")[0] == (EXAIL, SURE)
    finding = EXAIL.preview(path, {})
    assert finding.choice == {"pitch": "bow-down", "roll": "starboard-down", "time": "unix"}
    assert finding.facts["Header"] == "DELPH INS Navigation export"
    assert "trajectory.pitch_bow_down" in codes(finding.file_warnings)
    assert "times.utc_assumed" in codes(finding.file_warnings)
    trajectory = EXAIL.read(path, finding.choice)
    agrees(trajectory, records)
    start = calendar.timegm((2023, 6, 27, 14, 0, 0))
    np.testing.assert_allclose(trajectory.time, start + np.arange(500) / 50, atol=1e-4)
    degrees = note("assumed.column_unit", column="latitude", unit=note("unit.degrees"))
    unix = note("assumed.time_base", base=note("time_base.unix"))
    assert {"assumed.pitch_bow_down"} <= set(codes(trajectory.assumptions))
    assert degrees in trajectory.assumptions
    assert unix in trajectory.assumptions


def test_delph_columns_are_found_by_name(tmp_path: Path) -> None:
    records = vessel(50)
    lines = write_delph(tmp_path / "nav.txt", records).read_text().splitlines()
    moved = []
    for line in lines:
        if line.startswith("# "):
            moved.append(line)
        else:
            fields = line.lstrip("#").split("\t")
            mark = "#" if line.startswith("#") and len(fields) > 1 else ""
            moved.append(mark + "\t".join(reversed(fields)) if len(fields) > 1 else line)
    (tmp_path / "moved.txt").write_text("\n".join(moved) + "\n")
    agrees(EXAIL.read(tmp_path / "moved.txt", {}), records)


def test_delph_units_and_signs_come_from_the_header(tmp_path: Path) -> None:
    records = vessel(50)
    text = write_delph(tmp_path / "nav.txt", records).read_text()
    text = text.replace("# pitch: Pitch, degree", "# pitch: Pitch, degree, positive bow up")
    text = text.replace("# ellipsoidHeight: Height, meter", "# ellipsoidHeight: Height, feet")
    text = text.replace("# roll: Roll, degree\n", "")
    (tmp_path / "nav.txt").write_text(text)
    finding = EXAIL.preview(tmp_path / "nav.txt", {})
    assert finding.choice["pitch"] == "bow-up"
    assert (
        warning("trajectory.degrees_assumed", file="nav.txt", column="roll")
        in finding.file_warnings
    )
    trajectory = EXAIL.read(tmp_path / "nav.txt", finding.choice)
    right = truth(records)["attitude"][:, 1]
    np.testing.assert_allclose(trajectory.attitude[:, 1], -right, atol=2e-7)
    np.testing.assert_allclose(trajectory.height, records[:, 3] * 0.3048, rtol=0, atol=1e-4)


def test_delph_standard_deviations_are_read(tmp_path: Path) -> None:
    path = write_delph(tmp_path / "nav.txt", vessel(50), sigmas=True)
    ((format, _),) = recognise_formats(path, "accuracy")
    assert format.key == "exail-sigmas"
    accuracy = format.read(path, {})
    np.testing.assert_allclose(accuracy.position[7], SIGMAS[:3])
    np.testing.assert_allclose(np.degrees(accuracy.attitude[7]), [SIGMAS[4], SIGMAS[5], SIGMAS[3]])
    assert message_text(format.preview(path, {}).facts["Sigma roll"]) == "0.0080 to 0.0080°"
    assert recognise_formats(write_delph(tmp_path / "bare.txt", vessel(50)), "accuracy") == []


def test_pospac_export_is_read(tmp_path: Path) -> None:
    records = vessel(500)
    path = write_pospac(tmp_path / "export.txt", records)
    assert recognise_formats(path, "trajectory")[0] == (POSPAC, SURE)
    finding = POSPAC.preview(path, {})
    assert finding.facts["Date of mission"] == "2018-08-07"
    assert finding.file_warnings == ()
    trajectory = POSPAC.read(path, finding.choice)
    agrees(trajectory, records)
    np.testing.assert_allclose(trajectory.time, records[:, 0], rtol=0, atol=1e-5)
    degrees = note("assumed.column_unit", column="LATITUDE", unit=note("unit.degrees"))
    assert degrees in trajectory.assumptions
    assert "assumed.roll_starboard_down" in codes(trajectory.assumptions)
    ((format, _),) = recognise_formats(path, "accuracy")
    accuracy = format.read(path, {})
    np.testing.assert_allclose(accuracy.position[3], SIGMAS[:3])
    np.testing.assert_allclose(np.degrees(accuracy.attitude[3]), [SIGMAS[4], SIGMAS[5], SIGMAS[3]])


def test_pospac_units_come_from_the_header(tmp_path: Path) -> None:
    text = write_pospac(tmp_path / "a.txt", vessel(50)).read_text()
    (tmp_path / "a.txt").write_text(
        text.replace("position in Meters, lat", "position in Feet, lat")
    )
    trajectory = POSPAC.read(tmp_path / "a.txt", {})
    np.testing.assert_allclose(trajectory.height, vessel(50)[:, 3] * 0.3048, atol=1e-4)
    (tmp_path / "a.txt").write_text(text.replace("lat, long in Degrees", "lat, long in DMS"))
    with pytest.raises(InputError, match=r"a\.txt") as refused:
        POSPAC.read(tmp_path / "a.txt", {})
    assert refused.value.code == "trajectory.pospac_notation"
    without = "\n".join(line for line in text.splitlines() if "(time in" not in line)
    (tmp_path / "a.txt").write_text(without)
    finding = POSPAC.preview(tmp_path / "a.txt", {})
    assert "trajectory.degrees_assumed" in codes(finding.file_warnings)


def table(records: np.ndarray, factor: float = 180 / np.pi) -> np.ndarray:
    """Return rows of time, latitude, longitude, height, roll, pitch and heading."""
    angles = records[:, [1, 2, 7, 8, 9]] * factor
    return np.column_stack([records[:, 0], angles[:, :2], records[:, 3], angles[:, 2:]])


@pytest.mark.parametrize("separator", [" ", ",", ";", "\t", ", "])
@pytest.mark.parametrize(
    "header", ["", "Time{0}Lat (deg){0}Lon (deg){0}H{0}Roll{0}Pitch{0}Heading"]
)
def test_generic_text_is_read(tmp_path: Path, separator: str, header: str) -> None:
    records = vessel(100)
    path = tmp_path / "a.txt"
    if separator == " ":
        header = header.replace(" (deg)", "(deg)")
    np.savetxt(
        path, table(records), "%.12f", separator, header=header.format(separator), comments="# "
    )
    format, confidence = recognise_formats(path, "trajectory")[0]
    assert format is ASCII
    assert confidence == (LIKELY if header else 0.3)
    finding = ASCII.preview(path, {})
    assert finding.choice["columns"] == "time latitude longitude height roll pitch heading"
    assert ("trajectory.columns_assumed" in codes(finding.file_warnings)) == (not header)
    trajectory = ASCII.read(path, finding.choice)
    agrees(trajectory, records)
    assert "assumed.given_columns" in codes(trajectory.assumptions)


def test_saved_column_mapping_is_used(tmp_path: Path) -> None:
    records = vessel(100)
    columns = table(records, 1.0)[:, [6, 5, 4, 0, 3, 2, 1, 0]]
    columns[:, 7] = 99
    np.savetxt(tmp_path / "a.csv", columns, "%.14f", ",")
    saved = {
        "columns": "heading pitch roll time height longitude latitude -",
        "position": "radians",
        "attitude": "radians",
    }
    agrees(ASCII.read(tmp_path / "a.csv", saved), records)
    found = ASCII.preview(tmp_path / "a.csv", saved)
    assert found.choice | saved == found.choice
    assert message_text(found.facts["Rate"]) == "50.0 per second"


def test_given_signs_are_applied(tmp_path: Path) -> None:
    np.savetxt(tmp_path / "a.txt", table(vessel(50)), "%.12f")
    up = ASCII.read(tmp_path / "a.txt", {}).attitude
    other = ASCII.read(tmp_path / "a.txt", {"pitch": "bow-down", "roll": "port-down"})
    np.testing.assert_array_equal(other.attitude, up * [-1, -1, 1])
    assert "assumed.roll_port_down" in codes(other.assumptions)


def test_radians_are_detected(tmp_path: Path) -> None:
    np.savetxt(tmp_path / "a.txt", table(vessel(100), 1.0), "%.14f")
    finding = ASCII.preview(tmp_path / "a.txt", {})
    assert (finding.choice["position"], finding.choice["attitude"]) == ("radians", "radians")
    assert "trajectory.position_in_radians" in codes(finding.file_warnings)
    agrees(ASCII.read(tmp_path / "a.txt", finding.choice), vessel(100))


def test_text_with_degrees_minutes_seconds_clock_and_feet(tmp_path: Path) -> None:
    rows = [
        "06/27,14:00:00.0,45 30 00.000 N,73 30 36.000 W,32.80839895,1,2,359",
        "06/27,14:00:00.5,45 30 00.036 N,73 30 36.000 W,32.80839895,1,2,1",
    ]
    (tmp_path / "a.csv").write_text("\n".join(row.replace("06/27", "x") for row in rows))
    choice = {
        "columns": "- time latitude longitude height roll pitch heading",
        "position": "dms",
        "heights": "feet",
        "time": "utc-day",
        "header": "0",
    }
    trajectory = ASCII.read(tmp_path / "a.csv", choice)
    np.testing.assert_allclose(np.degrees(trajectory.latitude), [45.5, 45.50001])
    np.testing.assert_allclose(np.degrees(trajectory.longitude), -73.51)
    np.testing.assert_allclose(trajectory.height, 10)
    np.testing.assert_allclose(trajectory.time, [50_400, 50_400.5])


def test_date_and_clock_continue_over_midnight(tmp_path: Path) -> None:
    rows = ["date time lat lon h roll pitch heading"]
    rows += [f"2024-02-{d} {c} 45 -73 9 0 0 90" for d, c in ((28, "23:59:59.5"), (29, "00:00:00"))]
    (tmp_path / "a.txt").write_text("\n".join(rows))
    finding = ASCII.preview(tmp_path / "a.txt", {"attitude": "degrees"})
    assert finding.choice["time"] == "unix"
    trajectory = ASCII.read(tmp_path / "a.txt", finding.choice)
    midnight = calendar.timegm((2024, 2, 29, 0, 0, 0))
    np.testing.assert_allclose(trajectory.time, [midnight - 0.5, midnight])
    gps = ASCII.read(tmp_path / "a.txt", dict(finding.choice) | {"time": "gps-full"})
    np.testing.assert_allclose(gps.time, trajectory.time - 315_964_800)


@pytest.mark.parametrize("heading", ["true", "grid"])
def test_eastings_and_northings_are_read(tmp_path: Path, heading: str) -> None:
    records = vessel(200)
    lon, lat = np.degrees(records[:, 2]), np.degrees(records[:, 1])
    utm = pyproj.Transformer.from_crs("EPSG:4326", "EPSG:32618", always_xy=True)
    east, north = utm.transform(lon, lat)
    columns = table(records)
    columns[:, 1], columns[:, 2] = east, north
    if heading == "grid":  # compared with the grid azimuth of the meridian over 100 m
        east_up, north_up = utm.transform(lon, lat + 0.001)
        columns[:, 6] += np.degrees(np.arctan2(east_up - east, north_up - north))
    np.savetxt(tmp_path / "a.txt", columns, "%.12f")
    choice = {
        "columns": "time easting northing height roll pitch heading",
        "crs": "EPSG:32618",
        "heading": heading,
    }
    trajectory = ASCII.read(tmp_path / "a.txt", choice)
    np.testing.assert_allclose(trajectory.latitude, records[:, 1], rtol=0, atol=1e-12)
    turned = trajectory.attitude[:, 2] - truth(records)["attitude"][:, 2]
    np.testing.assert_allclose(np.degrees(turned), 0, atol=1e-4)
    assert note("assumed.grid_positions", system="EPSG:32618") in trajectory.assumptions


def test_feet_in_a_row_of_names_are_detected(tmp_path: Path) -> None:
    header = "Time,Lat(rad),Lon(rad),Height(ft),Roll(deg),Pitch(deg),Heading(deg)"
    columns = table(vessel(50))
    columns[:, 1:3] = vessel(50)[:, 1:3]
    columns[:, 3] /= 0.3048
    np.savetxt(tmp_path / "a.csv", columns, "%.14f", ",", header=header, comments="")
    finding = ASCII.preview(tmp_path / "a.csv", {})
    assert finding.choice["heights"] == "feet"
    assert (finding.choice["position"], finding.choice["attitude"]) == ("radians", "degrees")
    agrees(ASCII.read(tmp_path / "a.csv", finding.choice), vessel(50))


def test_heights_above_the_sea_are_reported(tmp_path: Path) -> None:
    np.savetxt(tmp_path / "a.txt", table(vessel(50)), "%.12f")
    columns = "time latitude longitude altitude roll pitch heading"
    trajectory = ASCII.read(tmp_path / "a.txt", {"columns": columns})
    assert "assumed.heights_above_sea" in codes(trajectory.assumptions)


def test_exchanged_columns_are_detected_from_the_course(tmp_path: Path) -> None:
    np.savetxt(tmp_path / "a.txt", table(vessel(2000))[:, [0, 2, 1, 3, 4, 5, 6]], "%.12f")
    assert "trajectory.exchanged" in codes(ASCII.preview(tmp_path / "a.txt", {}).file_warnings)


def test_preview_of_a_long_file_reads_head_and_tail(tmp_path: Path) -> None:
    np.savetxt(tmp_path / "a.txt", table(vessel(5200)), "%.12f")
    finding = ASCII.preview(tmp_path / "a.txt", {})
    assert "trajectory.last_rows" not in codes(finding.file_warnings)
    assert finding.facts["End"].params["time"] == pytest.approx(vessel(5200)[-1, 0])
    records = vessel(12_000, rate=200)
    np.savetxt(tmp_path / "a.txt", table(records), "%.12f")
    finding = ASCII.preview(tmp_path / "a.txt", {})
    assert finding.facts["End"].params["time"] == pytest.approx(records[-1, 0])
    assert finding.facts["Rows"].params["count"] == pytest.approx(12_000, rel=0.05)
    assert "trajectory.gaps" not in codes(finding.file_warnings)


@pytest.mark.parametrize(
    ("text", "degrees"),
    [
        ("45 30 00 N", 45.5), ("73°30'36\"W", -73.51), ("-73:30:36", -73.51), ("S12 15", -12.25),
        ("12D30M36S", 12.51), ("0 0 36 S", -0.01), ("45.5", 45.5), ("-0 30 0", -0.5),
    ],
)  # fmt: skip
def test_degrees_minutes_seconds_are_parsed(text: str, degrees: float) -> None:
    assert degrees_minutes_seconds(text) == pytest.approx(degrees)


@pytest.mark.parametrize("text", ["", "N", "45 61 0", "1 2 3 4", "-45 0 0 S", "abc", "45 -3 0"])
def test_invalid_degrees_minutes_seconds_are_refused(text: str) -> None:
    with pytest.raises(ValueError):
        degrees_minutes_seconds(text)


def test_clock_times_and_days_are_parsed() -> None:
    assert clock_seconds("14:03:07.25") == 14 * 3600 + 3 * 60 + 7.25
    assert date_seconds("2024/02/29") == calendar.timegm((2024, 2, 29, 0, 0, 0))
    for parse, text in (
        (clock_seconds, "25:00:00"),
        (clock_seconds, "12:61:00"),
        (date_seconds, "2024-13-01"),
        (date_seconds, "x"),
    ):
        with pytest.raises(ValueError):
            parse(text)


def test_heading_may_exceed_a_full_turn(tmp_path: Path) -> None:
    records = vessel(12_000)  # 240 s at 4 deg/s
    assert records[-1, 9] > 5 * np.pi
    np.savetxt(tmp_path / "a.txt", table(records), "%.12f")
    for path in (write_records(tmp_path / "a.sbet", records), tmp_path / "a.txt"):
        format = recognise_formats(path, "trajectory")[0][0]
        heading = format.read(path, format.preview(path, {}).choice).attitude[:, 2]
        np.testing.assert_allclose(heading, records[:, 9])
    with pytest.raises(InputError, match=r"a\.txt") as refused:
        ASCII.read(tmp_path / "a.txt", {"attitude": "radians"})
    assert refused.value.code == "trajectory.attitude_in_row"


def test_an_smrmsg_is_not_a_trajectory(tmp_path: Path) -> None:
    write_records(tmp_path / "a.out", vessel(100))
    assert recognise_formats(tmp_path / "a.out", "accuracy") == []
