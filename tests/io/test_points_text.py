"""Tests of points as text: invalid rows, units of columns, warnings about first points."""

import gzip
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.first_points import check_first_points
from lispac.io.formats import format_of
from lispac.io.point_reader_common import crs_of_options
from lispac.io.text import text_chunks
from lispac.io.text.text_export import write_table
from lispac.io.text.text_layout import RowLayout, guess_layout
from lispac.io.text.text_table import clock_seconds, find_coordinates, last_lines
from lispac.io.text.text_units import easting_unit_warnings, height_unit_of
from lispac.messages import Message, error, note, warning
from lispac.survey.crs import coordinate_system
from tests.support import point_files as files
from tests.support.error_codes import has_code
from tests.support.message_codes import codes

TEXT = format_of("text")
HEADER = "time x y z\n1 2 3 4\n"


def refusal_text(path: Path, choice: dict[str, str] | None = None) -> str:
    return str(error_of(path, choice)).removeprefix(str(path))


def error_of(path: Path, choice: dict[str, str] | None = None) -> InputError:
    with pytest.raises(InputError) as caught:
        list(TEXT.read(path, choice or {}))
    return caught.value


@pytest.mark.parametrize(
    ("rows", "code", "params"),
    [
        ("2 1_5 3 4", "text.not_a_number", {"row": 3, "column": "x", "value": "1_5"}),
        ("2 3 \N{ARABIC-INDIC DIGIT THREE} 4", "text.not_a_number",
         {"row": 3, "column": "y", "value": "\N{ARABIC-INDIC DIGIT THREE}"}),
        ("\n# a remark\n2 3 x 4", "text.not_a_number", {"row": 5, "column": "y", "value": "x"}),
        ("\n2 3 4", "text.row_too_short",
         {"row": 4, "found": 3, "needed": 4, "names": ("time", "x", "y", "z")}),
    ],
)  # fmt: skip
def test_the_invalid_row_is_named(
    tmp_path: Path, rows: str, code: str, params: dict[str, object]
) -> None:
    """Rows are counted as in an editor, with empty rows."""
    path = tmp_path / "a.txt"
    path.write_text(f"{HEADER}{rows}\n", encoding="utf-8")
    message = error_of(path).message
    assert message is not None
    assert message.code == code
    assert message.params == {"file": str(path), **params}


def test_a_wrong_separator_is_refused(tmp_path: Path) -> None:
    path = files.text(tmp_path / "a.csv", head=files.CSV_HEAD)
    choice = {"separator": "semicolon"}
    assert error_of(path, choice).message == error("line.no_points", file=str(path))
    with pytest.raises(InputError, match=r"a\.csv") as caught:
        TEXT.preview(path, choice)
    assert caught.value.code == "line.no_points"


@pytest.mark.parametrize("chunk", [15, 60])
def test_a_file_that_ends_with_a_full_chunk_is_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, chunk: int
) -> None:
    monkeypatch.setattr(text_chunks, "POINTS_PER_CHUNK", chunk)
    chunks = list(TEXT.read(files.text(tmp_path / "a.csv", head=files.CSV_HEAD), {}))
    assert [len(each.time) for each in chunks] == [chunk] * (files.COUNT // chunk)
    np.testing.assert_array_equal(np.concatenate([each.xyz for each in chunks]), files.XYZ)


def test_a_compressed_file_with_a_wrong_checksum_is_refused(tmp_path: Path) -> None:
    content = bytearray(gzip.compress(f"{HEADER}2 3 4 5\n".encode()))
    content[-8] ^= 1
    path = tmp_path / "a.csv.gz"
    path.write_bytes(content)
    with pytest.raises(InputError, check=has_code("file.damaged")):
        list(TEXT.read(path, {}))


def test_an_invalid_epoch_is_refused() -> None:
    choice = TEXT.complete_options({"frame": "georeferenced", "crs": "EPSG:32619", "epoch": "May"})
    with pytest.raises(InputError) as caught:
        crs_of_options(choice)
    assert caught.value.message == error("file.epoch", epoch="May")


def test_units_are_read_from_column_names() -> None:
    lines = ["Quay of May [m]", "time,Easting[ftUS],Northing[ftUS],Height[m],ring[x]", "1,2,3,4,5"]
    units = guess_layout(lines).units()
    assert {axis: units[axis] for axis in "xyz"} == {"x": "us-ft", "y": "us-ft", "z": "m"}
    assert guess_layout(lines[2:]).units() == {}  # the row of names is not part of the preview
    assert RowLayout("comma", False).units() == {}
    assert height_unit_of(units, "EPSG:2229") == "metre"
    assert height_unit_of({"z": "ft"}, "EPSG:2229") == ""


@pytest.mark.parametrize(
    ("units", "crs", "has_warning"),
    [
        ({"x": "m"}, "EPSG:2229", True),
        ({"x": "us-ft"}, "EPSG:2229", False),
        ({"x": "ft"}, "EPSG:2229", False),  # any foot matches the foot of the system
        ({"x": "m"}, "EPSG:4326", False),  # degrees: the unit of the name is ignored
        ({"x": "m"}, "EPSG:999999", False),  # an unknown system is reported elsewhere
        ({"x": "m"}, "", False),
        ({}, "EPSG:2229", False),
    ],
)
def test_another_unit_than_that_of_the_system_is_reported(
    units: dict[str, str], crs: str, has_warning: bool
) -> None:
    file_warnings = easting_unit_warnings(units, crs, "a.txt")
    assert bool(file_warnings) == has_warning
    if has_warning:
        unit, system = note("unit.metres"), coordinate_system(crs)
        expected = warning(
            "points.unit_of_column", file="a.txt", unit=unit, system=system.name,
            system_unit="US survey foot",
        )  # fmt: skip
        assert file_warnings == (expected,)


NEAR_POINTS = np.random.default_rng(4).normal(0, 10, (200, 3))
SECONDS = 5000 + np.arange(200) / 100


@pytest.mark.parametrize(
    ("time", "file_warnings"),
    [
        (SECONDS, ()),
        (SECONDS.astype(np.float32), (warning("times.coarse", file="a", step=2.0**-11),)),
        (SECONDS.astype(np.int64), (warning("times.whole_numbers", file="a"),)),
        (np.full(200, 5000.25), (warning("times.all_equal", file="a"),)),
        (SECONDS[::-1],
         (warning("times.decreasing_points", file="a", count=199, total=200),)),
    ],
)  # fmt: skip
def test_warnings_about_times(time: np.ndarray, file_warnings: tuple[Message, ...]) -> None:
    """A 32-bit float has steps of 2**-11 s near 5,000 s."""
    assert check_first_points(NEAR_POINTS, time, file="a", crs="").file_warnings == file_warnings


@pytest.mark.parametrize(("crs", "has_warning"), [("EPSG:4326", False), ("EPSG:999999", True)])
def test_small_coordinates_are_reported_unless_the_system_is_geographic(
    crs: str, has_warning: bool
) -> None:
    """Degrees are small numbers; the axes of an unknown system are not known."""
    found = check_first_points(NEAR_POINTS, SECONDS, file="a", crs=crs)
    assert found.frame == "georeferenced"
    assert codes(found.file_warnings) == (["points.small_coordinates"] if has_warning else [])


@pytest.mark.parametrize("value", [1e300, -1e200, np.nan, np.inf])
def test_unusable_points_do_not_determine_the_frame(value: float) -> None:
    """One such point among others changes no warning; alone it causes no overflow."""
    xyz = NEAR_POINTS.copy()
    xyz[3, 1] = value
    assert check_first_points(xyz, SECONDS, file="a", crs="") == check_first_points(
        np.delete(NEAR_POINTS, 3, axis=0), np.delete(SECONDS, 3), file="a", crs=""
    )
    check_first_points(xyz[3:4], SECONDS[3:4], file="a", crs="")


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("12.5 -3.25 1", ("12.5", "-3.25", "1")),
        ("12.5; \N{MINUS SIGN}3.25; 1", ("12.5", "-3.25", "1")),
        ("12.5 -3.25", None),
        ("T1 12.5 -3.25 1", None),
        ("north west up", None),
    ],
)
def test_coordinates_are_found_in_a_text(text: str, found: tuple[str, str, str] | None) -> None:
    assert find_coordinates(text) == found


@pytest.mark.parametrize("text", ["14h03", "25:00:00", "14:60:00", "14:03:61", ""])
def test_an_invalid_time_of_day_is_refused(text: str) -> None:
    assert clock_seconds("14:03:07.250") == 14 * 3600 + 3 * 60 + 7.25
    with pytest.raises(ValueError, match="is not a time as hh:mm:ss"):
        clock_seconds(text)


def test_last_lines_of_a_file_and_of_a_missing_file(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("one\ntwo\nthree\n")
    assert last_lines(tmp_path / "a.txt", 12) == ["two", "three"]
    assert last_lines(tmp_path / "absent", 12) == []


def test_texts_that_need_quotes_in_csv_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    one = np.array([1.0])
    write_table(path, ["a"], [one], [".1f"])
    assert path.read_text() == "a\n1.0\n"
    for names, column in ((["a,b"], one), (["a"], np.array(['L"1']))):
        with pytest.raises(InputError) as caught:
            write_table(path, names, [column], ["s"])
        wrong = names[0] if "," in names[0] else 'L"1'
        assert caught.value.message == error("text.not_for_csv", file="a.csv", text=wrong)
    assert path.read_text() == "a\n1.0\n"
