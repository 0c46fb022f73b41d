"""Tests of text exports of NovAtel Inertial Explorer."""

from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.format_types import LIKELY, SURE
from lispac.io.formats import format_of, recognise_formats
from lispac.message_texts import message_text
from lispac.messages import note
from tests.support.trajectory_files import SIGMAS, truth, vessel, write_inertial_explorer

FORMAT = format_of("inertial-explorer-text")
METRES_PER_RADIAN = 6.4e6


def require_agreement(path: Path, records: np.ndarray, choice: dict[str, str]) -> None:
    """Positions to 0.1 mm, heights and attitudes to the digits of the file."""
    read, right = FORMAT.read(path, choice), truth(records)
    for name in ("latitude", "longitude"):
        np.testing.assert_allclose(getattr(read, name), right[name], 0, 1e-4 / METRES_PER_RADIAN)
    np.testing.assert_allclose(read.height, right["height"], rtol=0, atol=1e-4)
    turns = np.angle(np.exp(1j * (read.attitude - right["attitude"])))
    np.testing.assert_allclose(turns, 0, atol=1e-11)


@pytest.mark.parametrize("separator", [" ", ",", "\t", ";"])
@pytest.mark.parametrize("dms", [True, False])
def test_the_export_is_read(tmp_path: Path, dms: bool, separator: str) -> None:
    records = vessel(500)
    path = write_inertial_explorer(tmp_path / "a.txt", records, dms=dms, separator=separator)
    assert recognise_formats(path, "trajectory")[0] == (FORMAT, SURE)
    finding = FORMAT.preview(path, {})
    assert finding.file_warnings == ()
    assert finding.choice == {"time": "gps-week"}
    assert finding.facts["Header"] == "Inertial Explorer Version 8.90.2428"
    assert finding.facts["Datum"] == "WGS84, (processing datum)"
    require_agreement(path, records, dict(finding.choice))
    np.testing.assert_allclose(FORMAT.read(path, {}).time, records[:, 0], rtol=0, atol=1e-6)
    ((accuracy_format, _),) = recognise_formats(path, "accuracy")
    accuracy = accuracy_format.read(path, {})
    np.testing.assert_allclose(accuracy.position[3], SIGMAS[:3])
    np.testing.assert_allclose(np.degrees(accuracy.attitude[3]), [SIGMAS[4], SIGMAS[5], SIGMAS[3]])


def test_an_export_without_the_lines_of_the_project_is_read(tmp_path: Path) -> None:
    """Separations and other columns between those of the program; signs of 0 degrees count."""
    path = tmp_path / "a.txt"
    path.write_text(
        "  CorrTime       Date         Latitude        Longitude        H-Ell        Heading"
        "        HdngSep         HdngSD          Pitch           Roll\n"
        "     (sec)      (MDY)       (+/-D M S)       (+/-D M S)          (m)          (Deg)"
        "          (Deg)          (Deg)          (Deg)          (Deg)\n"
        " 345600.01  6/27/2023  -45 30 12.25000 -173 29 47.75000       12.345  51.2500000000"
        " 359.9700000000   0.0200000000  -1.2500000000   0.0300000000\n"
        " 345600.02  6/27/2023   -0 30 12.25000   -0 29 47.75000       12.345  51.2500000000"
        " 359.9700000000   0.0200000000  -1.2500000000   0.0300000000\n"
    )
    assert recognise_formats(path, "trajectory")[0] == (FORMAT, LIKELY)
    read = FORMAT.read(path, {})
    latitude, longitude = 30 / 60 + 12.25 / 3600, 29 / 60 + 47.75 / 3600
    np.testing.assert_allclose(np.degrees(read.latitude), [-45 - latitude, -latitude])
    np.testing.assert_allclose(np.degrees(read.longitude), [-173 - longitude, -longitude])
    np.testing.assert_allclose(read.time, [345600.01, 345600.02])
    np.testing.assert_allclose(read.height, 12.345)
    np.testing.assert_allclose(np.degrees(read.attitude[0]), [0.03, 1.25, 51.25])


@pytest.mark.parametrize(
    ("name", "unit", "value", "base", "seconds"),
    [
        ("UTCTime", "(sec)", "{:.3f}", "utc-week", 486_000.0),
        ("GPSTime", "(HMS)", "15:00:{:06.3f}", "gps-day", 54_000.0),
        ("UTCTime", "(HMS)", "15:00:{:06.3f}", "utc-day", 54_000.0),
    ],
)
def test_the_name_of_the_time_gives_its_base(
    tmp_path: Path, name: str, unit: str, value: str, base: str, seconds: float
) -> None:
    records = vessel(200)
    path = write_inertial_explorer(tmp_path / "a.txt", records)
    text = path.read_text().replace("GPSTime", name).replace("(sec)", unit)
    for time in records[:, 0]:
        shown = value.format(time if unit == "(sec)" else time - 486_000)
        text = text.replace(f"{time:.3f}", shown, 1)
    path.write_text(text)
    finding = FORMAT.preview(path, {})
    assert finding.choice["time"] == base
    read = FORMAT.read(path, {})
    assert note("assumed.time_base", base=note(f"time_base.{base.replace('-', '_')}")) in (
        read.assumptions
    )
    np.testing.assert_allclose(read.time - seconds, records[:, 0] - 486_000, atol=1e-6)


def test_a_given_time_base_is_used(tmp_path: Path) -> None:
    path = write_inertial_explorer(tmp_path / "a.txt", vessel(50))
    assert FORMAT.preview(path, {"time": "utc-week"}).choice["time"] == "utc-week"
    assert note("assumed.time_base", base=note("time_base.utc_week")) in (
        FORMAT.read(path, {"time": "utc-week"}).assumptions
    )


@pytest.mark.parametrize("separator", [" ", ","])
def test_a_row_without_a_value_is_refused(tmp_path: Path, separator: str) -> None:
    """A missing value between blanks would move the following ones by a column."""
    path = write_inertial_explorer(tmp_path / "a.txt", vessel(50), separator=separator)
    lines = path.read_text().splitlines()
    fields = lines[-3].split(None if separator == " " else separator)
    del fields[-7]
    lines[-3] = separator.join(fields)
    path.write_text("\n".join(lines) + "\n")
    with pytest.raises(InputError) as refused:
        FORMAT.read(path, {})
    assert refused.value.code == "trajectory.uneven_row"
    assert refused.value.message.params["row"] == len(lines) - 2


def test_units_are_those_below_the_names(tmp_path: Path) -> None:
    records = vessel(50)
    path = write_inertial_explorer(tmp_path / "a.txt", records)
    text = path.read_text()
    path.write_text(text.replace("               (m)", "              (ft)", 1))
    np.testing.assert_allclose(FORMAT.read(path, {}).height, records[:, 3] * 0.3048, atol=1e-4)
    path.write_text(text.replace("(+/-D M S)", "(furlongs)", 1))
    with pytest.raises(InputError) as refused:
        FORMAT.read(path, {})
    assert refused.value.code == "trajectory.unknown_unit"


def test_the_rows_of_a_long_file_are_read_at_both_ends(tmp_path: Path) -> None:
    """The preview counts the rows by their length with blanks, and reads the last ones."""
    path = write_inertial_explorer(tmp_path / "a.txt", vessel(6000))
    finding = FORMAT.preview(path, {})
    assert finding.file_warnings == ()
    assert message_text(finding.facts["End"]) == "486119.980 s"
    rows = finding.facts["Rows"]
    assert abs(rows.params["count"] - 6000) < 60
    path.write_text(path.read_text()[:-75])
    assert [each.code for each in FORMAT.preview(path, {}).file_warnings] == [
        "trajectory.last_rows"
    ]
