"""Tests of invalid trajectory files: refused with the file, the place and an action."""

import re
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import pytest
from hypothesis import strategies as st

from lispac.errors import InputError
from lispac.io.format_types import FilePreview
from lispac.io.formats import ACCURACY_FORMATS, TRAJECTORY_FORMATS, format_of, recognise_formats
from lispac.message_texts import message_text
from tests.support.message_codes import codes
from tests.support.trajectory_files import (
    VALID_FILES,
    vessel,
    write_records,
)

BINARY = ("sbet", "pof", "smrmsg")
TEXT = tuple(key for key in VALID_FILES if key not in BINARY and not key.startswith("cidco"))


def outcome(
    task: Callable[[Path, Mapping[str, str]], object], path: Path, choice: Mapping[str, str]
) -> tuple[object, str]:
    """Return the result of a reader or the text of its refusal; other errors are raised."""
    try:
        return task(path, choice), ""
    except InputError as error:
        return None, str(error)


def refusal_text(key: str, path: Path, choice: dict[str, str] | None = None) -> str:
    """Return code and text of the error of `error_of`."""
    error = error_of(key, path, choice)
    return f"{error.code} {error}".lstrip()


def error_of(key: str, path: Path, choice: dict[str, str] | None = None) -> InputError:
    """Return the error of a refused file, whose text names the file and an action."""
    with pytest.raises(InputError) as error:
        format_of(key).read(path, choice or {})
    text = str(error.value)
    assert str(path) in text
    assert "\n" not in text
    assert text.endswith((".", ".)"))
    assert re.search(
        r"export|choose|check|state|give|sort|copy|name |read the file as|does not exist",
        text, re.IGNORECASE,
    ), text  # fmt: skip
    return error.value


def examine(key: str, path: Path) -> None:
    """Preview a file, which must give warnings or a refusal and no other error."""
    finding, refusal = outcome(format_of(key).preview, path, {})
    file_warnings = finding.file_warnings if isinstance(finding, FilePreview) else ()
    assert finding is not None or str(path) in refusal
    assert all(message.params["file"] == path.name for message in file_warnings), file_warnings
    assert all(message_text(message).rstrip(")").endswith(".") for message in file_warnings), (
        file_warnings
    )


ALL_FORMATS = BINARY + TEXT


@pytest.mark.parametrize("key", ALL_FORMATS)
def test_a_valid_file_is_read(tmp_path: Path, key: str) -> None:
    path = VALID_FILES[key](tmp_path / "a.dat")
    format = format_of(key)
    assert format.sniff(path) > 0
    assert len(format.read(path, format.preview(path, {}).choice).time) == 200


@pytest.mark.parametrize("key", ALL_FORMATS)
def test_missing_and_empty_files_and_folders_are_refused(tmp_path: Path, key: str) -> None:
    (tmp_path / "empty").touch()
    for name, words in (("none", "not_found"), ("empty", "empty|nothing"), (".", "file.folder")):
        path = tmp_path / name
        assert re.search(words, refusal_text(key, path))
        assert format_of(key).sniff(path) == 0
        examine(key, path)


@pytest.mark.parametrize("key", BINARY)
def test_truncated_binary_files_are_refused(tmp_path: Path, key: str) -> None:
    path = VALID_FILES[key](tmp_path / "a.out")
    path.write_bytes(path.read_bytes()[:-20])
    assert "file.partial_record" in refusal_text(key, path)
    assert "file.partial_record" in codes(format_of(key).preview(path, {}).file_warnings)
    assert recognise_formats(path, format_of(key).kind)[0][0].key == key


@pytest.mark.parametrize("key", TEXT)
def test_truncated_text_names_the_row(tmp_path: Path, key: str) -> None:
    path = VALID_FILES[key](tmp_path / "a.txt")
    path.write_text(path.read_text()[:-75])
    rows = len(path.read_text().splitlines())
    assert f"row {rows}: " in refusal_text(key, path)
    assert any(
        each.params.get("row") == rows for each in format_of(key).preview(path, {}).file_warnings
    )


@pytest.mark.parametrize("key", ALL_FORMATS)
def test_files_of_other_content_are_refused(tmp_path: Path, key: str) -> None:
    rng = np.random.default_rng(3)
    contents = {
        "noise": rng.integers(0, 256, 136 * 80, dtype=np.uint8).tobytes(),
        "zeros": bytes(136 * 80),
        "ones": b"\xff" * (136 * 80),
        "prose": b"Dear all,\nthe survey went well.\n" * 50,
        "table": b"1 2 3\n4 5 6\n" * 340,
        "one line": b"7 " * 9000,
    }
    for name, content in contents.items():
        path = tmp_path / name
        path.write_bytes(content)
        assert format_of(key).sniff(path) < 0.7, name
        refusal_text(key, path)
        examine(key, path)


def records_with(change: Callable[[np.ndarray], None]) -> Callable[[Path], Path]:
    def write(path: Path) -> Path:
        records = vessel(200)
        change(records)
        return write_records(path, records)

    return write


def put(rows: object, columns: object, value: object) -> Callable[[np.ndarray], None]:
    def change(records: np.ndarray) -> None:
        records[rows, columns] = value

    return change


def exchange(records: np.ndarray) -> None:
    records[:, [1, 2]] = records[:, [2, 1]]
    records[:, 1] -= np.radians(50)  # beyond a latitude of 90 deg


def in_degrees(records: np.ndarray) -> None:
    angles = [1, 2, 7, 8, 9, 10]
    records[:, angles] = np.degrees(records[:, angles])


def through_32_bits(records: np.ndarray) -> None:
    records[:, 0] = records[:, 0].astype(np.float32)


SBET_OUTCOMES = {
    "not a number": (put(4, 8, np.nan), "file.record_not_finite .* record 5 "),
    "infinite": (put(6, 1, np.inf), "file.record_not_finite .* record 7 "),
    "duplicate time": (
        put(5, 0, 486_000.08),
        "file.time_order_record .* record 6 .* 1 repeated and 0 ",
    ),
    "backward time": (
        put(5, 0, 486_000.0),
        "file.time_order_record .* record 6 .* 0 repeated and 1 ",
    ),
    "32-bit time": (through_32_bits, "file.time_steps_record .* only 0.0312 s"),
}
SBET_CODES: dict[str, tuple[Callable[[np.ndarray], None], str, dict[str, object]]] = {
    "degrees": (in_degrees, "sbet.in_degrees", {"record": 1}),
    "exchanged": (exchange, "sbet.exchanged_position", {"record": 1}),
    "roll in degrees": (put(3, 7, 4.0), "trajectory.attitude_in_record",
                        {"number": 4, "roll": 4.0}),
    "height": (put(9, 3, 1e7), "trajectory.height_in_record", {"number": 10, "height": 1e7}),
    "other time base": (put(slice(None), 0, 4e8 + np.arange(200)), "trajectory.other_time_base",
                        {"base": "gps-week", "bases": ("gps-adjusted",)}),
    "no time base": (put(slice(None), 0, 1e15 + np.arange(200)), "trajectory.no_time_base",
                     {"start": 1e15}),
}  # fmt: skip


@pytest.mark.parametrize("case", SBET_OUTCOMES)
def test_changed_sbet_records_are_read_refused_or_reported(tmp_path: Path, case: str) -> None:
    change, words = SBET_OUTCOMES[case]
    path = records_with(change)(tmp_path / "a.sbet")
    assert re.search(words, refusal_text("sbet", path))
    examine("sbet", path)


@pytest.mark.parametrize("case", SBET_CODES)
def test_impossible_states_of_an_sbet_are_refused(tmp_path: Path, case: str) -> None:
    change, code, params = SBET_CODES[case]
    path = records_with(change)(tmp_path / "a.sbet")
    message = error_of("sbet", path).message
    assert message is not None
    assert message.code == code
    assert dict(message.params).items() >= params.items()
    examine("sbet", path)


def test_an_sbet_of_the_other_byte_order(tmp_path: Path) -> None:
    path = write_records(tmp_path / "a.sbet", vessel(200), order=">")
    refusal_text("sbet", path)
    assert "sbet.big_endian" in codes(format_of("sbet").preview(path, {}).file_warnings)


def test_a_single_record_is_refused(tmp_path: Path) -> None:
    path = write_records(tmp_path / "a.sbet", vessel(200)[:1])
    assert error_of("sbet", path).code == "sbet.one_record"


def test_negative_accuracies_of_an_smrmsg_are_refused(tmp_path: Path) -> None:
    path = VALID_FILES["smrmsg"](tmp_path / "a.out")
    records = np.fromfile(path).reshape(-1, 10)
    records[3, 2] = -1
    records.tofile(path)
    assert error_of("smrmsg", path).code == "sbet.negative_accuracy"
    assert format_of("smrmsg").sniff(path) == 0


def edited(key: str, path: Path, edit: Callable[[list[str]], list[str]]) -> Path:
    """Write a valid text file with its rows changed."""
    VALID_FILES[key](path)
    path.write_text("\n".join(edit(path.read_text().splitlines())) + "\n")
    return path


def field(row: int, column: int, value: str) -> Callable[[list[str]], list[str]]:
    """Return an edit that sets a field of a row counted from the end."""

    def edit(lines: list[str]) -> list[str]:
        fields = lines[-row].split("\t" if "\t" in lines[-row] else None)
        fields[column] = value
        lines[-row] = ("\t" if "\t" in lines[-row] else " ").join(fields)
        return lines

    return edit


@pytest.mark.parametrize("value", ["nan", "inf", "-inf", "1e999", "", "x", "12:30"])
@pytest.mark.parametrize(
    ("key", "column"),
    [
        ("exail-text", 2),
        ("pospac-text", 5),
        ("inertial-explorer-text", 8),
        ("ascii-trajectory", 1),
    ],
)
def test_a_value_that_is_not_a_number_is_refused(
    tmp_path: Path, key: str, column: int, value: str
) -> None:
    path = edited(key, tmp_path / "a.txt", field(3, column, value or "-"))
    row = len(path.read_text().splitlines()) - 2
    assert f"row {row}: " in refusal_text(key, path)


@pytest.mark.parametrize(
    ("key", "column", "value"),
    [
        ("exail-text", 1, "14:00:01.0000"),
        ("pospac-text", 0, "486001.0"),
        ("inertial-explorer-text", 0, "486001.0"),
        ("ascii-trajectory", 0, "486001"),
    ],
)
def test_backward_times_in_text_are_reported(
    tmp_path: Path, key: str, column: int, value: str
) -> None:
    path = edited(key, tmp_path / "a.txt", field(3, column, value))
    row = len(path.read_text().splitlines()) - 2
    refusal = refusal_text(key, path)
    assert "file.time_order_row" in refusal
    assert f"row {row} " in refusal
    assert "0 repeated and 1 decreasing times among 200" in refusal


@pytest.mark.parametrize(
    ("key", "name"),
    [("exail-text", "pitch"), ("pospac-text", "PITCH"), ("inertial-explorer-text", "Pitch")],
)
def test_a_missing_column_is_refused(tmp_path: Path, key: str, name: str) -> None:
    def edit(lines: list[str]) -> list[str]:
        return [line.replace(name, "other") for line in lines]

    path = edited(key, tmp_path / "a.txt", edit)
    message = error_of(key, path).message
    assert message is not None
    assert (message.code, message.params["missing"]) == ("trajectory.columns_missing", ("pitch",))
    lacking = [
        each for each in format_of(key).preview(path, {}).file_warnings if each.code == message.code
    ]
    assert [each.params["missing"] for each in lacking] == [("pitch",)]


@pytest.mark.parametrize("key", ["exail-text", "pospac-text", "inertial-explorer-text"])
def test_text_without_its_header_is_refused(tmp_path: Path, key: str) -> None:
    path = edited(key, tmp_path / "a.txt", lambda lines: lines[-200:])
    assert (
        error_of(key, path).code
        == f"trajectory.{key.removesuffix('-text').replace('-', '_')}_header"
    )


def test_missing_standard_deviations_are_refused(tmp_path: Path) -> None:
    path = VALID_FILES["exail-text"](tmp_path / "a.txt")
    message = error_of("exail-sigmas", path).message
    assert message is not None
    assert (message.code, message.params["column"]) == ("trajectory.no_column", "north_sd")


@pytest.mark.parametrize(
    ("choice", "code", "params"),
    [
        ({"position": "radians", "attitude": "radians"}, "trajectory.position_in_degrees",
         {"row": 1}),
        ({"attitude": "radians"}, "trajectory.attitude_in_row", {"number": 1}),
        ({"columns": "time longitude latitude height roll pitch heading"}, None, {}),
        ({"columns": "time latitude longitude height roll pitch"}, "trajectory.columns_missing",
         {"missing": ("heading",)}),
        ({"columns": "time height roll pitch"}, "trajectory.position_missing",
         {"missing": ("latitude", "longitude", "heading")}),
        ({"columns": ""}, "trajectory.no_columns", {}),
        ({"columns": "time latitude sundial"}, "trajectory.unknown_column", {"column": "sundial"}),
        ({"columns": "time time latitude"}, "text.duplicate_columns", {"names": ("time",)}),
        ({"columns": "- - time latitude longitude height roll pitch heading"},
         "text.too_few_columns", {"row": 1, "found": 7, "needed": 9}),
        ({"columns": "time easting northing height roll pitch heading"}, "trajectory.no_system",
         {}),
        ({"header": "few"}, "trajectory.header_rows", {"value": "few"}),
        ({"header": "500"}, "text.no_rows", {}),
        ({"separator": "comma"}, "text.no_rows", {}),
        ({"time": "gps-full"}, "trajectory.other_time_base",
         {"base": "gps-full", "bases": ("gps-week", "utc-week")}),
        ({"time": "utc-day"}, "trajectory.other_time_base",
         {"base": "utc-day", "bases": ("gps-week", "utc-week")}),
        ({"heading": "grid"}, "trajectory.grid_heading", {}),
    ],
)  # fmt: skip
def test_invalid_choices_are_refused(
    tmp_path: Path, choice: dict[str, str], code: str | None, params: dict[str, object]
) -> None:
    path = VALID_FILES["ascii-trajectory"](tmp_path / "a.txt")
    if code is None:  # both are on Earth: only the course shows the exchange
        assert format_of("ascii-trajectory").read(path, choice)
        return
    message = error_of("ascii-trajectory", path, choice).message
    assert message is not None
    assert message.code == code
    assert dict(message.params).items() >= params.items()


def test_exchanged_positions_beyond_the_pole_are_refused(tmp_path: Path) -> None:
    rows = "\n".join(f"{k} -123.5 45.5 10 0 0 90" for k in range(1000, 1010))
    (tmp_path / "a.txt").write_text(rows)
    message = error_of("ascii-trajectory", tmp_path / "a.txt").message
    assert message is not None
    assert (message.code, message.params["row"]) == ("trajectory.exchanged_position", 1)


@pytest.mark.parametrize(
    ("crs", "code"),
    [
        ("EPSG:4326", "trajectory.not_projected"),
        ("EPSG:999999", "trajectory.unusable_system"),
        ("sundial", "trajectory.unusable_system"),
        ("EPSG:32618", None),
    ],
)
def test_wrong_coordinate_systems_of_trajectories_are_refused(
    tmp_path: Path, crs: str, code: str | None
) -> None:
    rows = "\n".join(f"{k} 600000 5040000 10 0 0 90" for k in range(1000, 1010))
    (tmp_path / "a.txt").write_text(rows)
    columns = "time easting northing height roll pitch heading"
    choice = {"columns": columns, "crs": crs}
    if code is None:
        assert format_of("ascii-trajectory").read(tmp_path / "a.txt", choice)
        (tmp_path / "a.txt").write_text(rows.replace("600000", "1e30"))
        code = "trajectory.outside_system"
    assert error_of("ascii-trajectory", tmp_path / "a.txt", choice).code == code


def test_a_file_without_permission_is_refused(tmp_path: Path) -> None:
    path = VALID_FILES["sbet"](tmp_path / "a.sbet")
    path.chmod(0)
    try:
        path.read_bytes()
    except PermissionError:
        for format in (*TRAJECTORY_FORMATS, *ACCURACY_FORMATS):
            assert "permission" in refusal_text(format.key, path)
            assert format.sniff(path) == 0
    else:
        pytest.skip("this user may read everything")


numbers = st.floats() | st.sampled_from([0.0, 486_000.0, 0.79, -1.28, 45.5, 1e300, 5e-324])
binary = st.lists(numbers, max_size=60).map(lambda values: np.array(values, "<f8").tobytes())
pieces = st.sampled_from(
    ["1", "45.5", "-73.5", "nan", "1e999", "14:00:01", "2024-02-30", "12 30 61 N", "#", "(", ",",
     "\t", ";", "\n", "\r", " ", "time in Sec", "TIME, LATITUDE, LONGITUDE, ELLIPSOID HEIGHT, ROLL,"
     " PITCH, HEADING\n", "(time in Sec, lat, long in Degrees)\n", "486000 45 -73 9 0 0 90\n",
     "486001 45 -73 9 0 0 90\n", "486001,45,-73,9,0,0,90\n", "# DELPH INS\n", "# roll: degree\n",
     "#time\tlatitude\tlongitude\theight\troll\tpitch\theading\n", "1\t45\t-73\t9\t0\t0\t90\n",
     "2\t45\t-73\t9\t0\t0\t90\n", "time lat lon h roll pitch heading date\n", "\x00", "\x1c", "٣"]
)  # fmt: skip
text = st.lists(pieces, max_size=40).map(lambda parts: "".join(parts).encode())
anything = st.binary(max_size=600) | binary | text
