"""Tests of reading text trajectories: decimal commas, quotes, UTF-16."""

from pathlib import Path

import numpy as np
import pytest

from lispac.io.formats import format_of, recognise_formats
from lispac.io.text.text_table import split_fields
from lispac.messages import Level
from lispac.workflow.importing.input_file import examine_file
from lispac.workflow.importing.input_file_messages import option_to_choose
from lispac.workflow.importing.input_files import InputFiles
from tests.support.trajectory_files import vessel, write_pospac

ASCII, POSPAC = format_of("ascii-trajectory"), format_of("pospac-text")
NAMES = ("Time", "Latitude", "Longitude", "Height", "Roll", "Pitch", "Heading")


def text_of(records: np.ndarray, separator: str, sign: str) -> str:
    table = np.column_stack([records[:, [0]], np.degrees(records[:, [1, 2]]), records[:, [3]]])
    table = np.column_stack([table, np.degrees(records[:, [7, 8, 9]])])
    rows = [[f"{value:.10f}".replace(".", sign) for value in row] for row in table]
    return "\n".join(separator.join(row) for row in (NAMES, *rows)) + "\n"


def same(path: Path, records: np.ndarray) -> None:
    trajectory = ASCII.read(path, ASCII.preview(path, {}).choice)
    np.testing.assert_allclose(trajectory.time, records[:, 0], rtol=0, atol=1e-6)
    np.testing.assert_allclose(trajectory.latitude, records[:, 1], rtol=0, atol=1e-11)
    np.testing.assert_allclose(trajectory.attitude[:, 2], records[:, 9], rtol=0, atol=1e-9)


@pytest.mark.parametrize("separator", [";", "\t", " ", "  "])
def test_decimal_commas_are_read(tmp_path: Path, separator: str) -> None:
    records = vessel(200)
    path = tmp_path / "a.txt"
    path.write_text(text_of(records, separator, ","), encoding="utf-8")
    assert recognise_formats(path, "trajectory")[0][0] is ASCII
    same(path, records)
    input_file = examine_file(path)
    assert (input_file.role, input_file.error) == ("trajectory", None)


@pytest.mark.parametrize(("separator", "sign"), [(",", "."), (",", ","), (";", ","), ("\t", ".")])
def test_quoted_fields_are_read(tmp_path: Path, separator: str, sign: str) -> None:
    records = vessel(200)
    path = tmp_path / "a.csv"
    rows = text_of(records, "|", sign).splitlines()
    quoted = [separator.join(f'"{field}"' for field in row.split("|")) for row in rows]
    path.write_text("\n".join(quoted) + "\n", encoding="utf-8")
    assert recognise_formats(path, "trajectory")[0][0] is ASCII
    same(path, records)


def test_a_quote_can_mean_seconds_of_arc() -> None:
    assert split_fields('1.0,45 31 08.5",-73 32 20.1"') == ["1.0", '45 31 08.5"', '-73 32 20.1"']


def test_commas_between_columns_are_separators() -> None:
    assert split_fields("1,2,3") == ["1", "2", "3"]
    assert split_fields("1.5, 2.5, 3") == ["1.5", "2.5", "3"]
    assert split_fields("1, 2, 3") == ["1", "2", "3"]
    assert split_fields("1,5 -2,5 3") == ["1,5", "-2,5", "3"]


def test_pospac_text_with_decimal_commas_is_read(tmp_path: Path) -> None:
    records = vessel(100)
    path = write_pospac(tmp_path / "a.txt", records)
    head, body = path.read_text().split("position SD in Meters)\n\n")
    path.write_text(f"{head}position SD in Meters)\n\n{body.replace('.', ',')}", encoding="utf-8")
    right = POSPAC.read(write_pospac(tmp_path / "b.txt", records), {})
    np.testing.assert_array_equal(POSPAC.read(path, {}).latitude, right.latitude)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-be"])
@pytest.mark.parametrize("count", [200, 8000])
def test_utf_16_is_read(tmp_path: Path, encoding: str, count: int) -> None:
    records = vessel(count)
    path = tmp_path / "a.csv"
    mark = "\ufeff" if encoding == "utf-16-be" else ""
    path.write_bytes((mark + text_of(records, ",", ".")).encode(encoding))
    assert recognise_formats(path, "trajectory")[0][0] is ASCII
    same(path, records)
    facts = ASCII.preview(path, {}).facts
    assert facts["End"].params["time"] == pytest.approx(records[-1, 0])
    assert facts["Rows"].params["count"] == pytest.approx(count, rel=0.05)


def test_a_refused_trajectory_is_reported_once_without_its_path(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    head = "TIME, EASTING, NORTHING, ELLIPSOID HEIGHT, ROLL, PITCH, HEADING\n(time in Sec, "
    head += "position in Meters, orientation in Degrees)\n"
    rows = [f"{300 + k / 10} {4e5 + k} 5e6 10 0 0 90" for k in range(50)]
    path.write_text("POS Export Utility\n" + head + "\n".join(rows), encoding="utf-8")
    input_files = InputFiles().with_files([path]).with_changed_file(examine_file(path))
    messages = input_files.messages(input_files.files[0])
    about = [message for message in messages if message.code == "trajectory.no_system"]
    assert [message.level for message in about] == [Level.ERROR]
    assert about[0].params["file"] == path.name
    assert option_to_choose(about[0].actions[0]) == "crs"
    assert all(each.params["file"] == path.name for each in POSPAC.preview(path, {}).file_warnings)
