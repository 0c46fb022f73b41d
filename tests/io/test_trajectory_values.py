"""Tests of trajectory values that are refused or give a warning."""

from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.formats import format_of
from lispac.io.trajectory import trajectory_preview
from lispac.io.trajectory.trajectory_checks import require_attitude
from lispac.io.trajectory.trajectory_facts import time_warnings
from lispac.io.trajectory.trajectory_preview import accuracy_facts
from lispac.messages import error, note, warning
from lispac.survey.trajectory import TrajectoryAccuracy
from tests.io.test_trajectory_bad_input import edited, error_of, field
from tests.support.message_codes import codes
from tests.support.trajectory_files import (
    VALID_FILES,
    vessel,
    write_delph,
    write_pospac,
    write_records,
)

ASCII, EXAIL, SBET = (format_of(key) for key in ("ascii-trajectory", "exail-text", "sbet"))


def test_a_negative_standard_deviation_in_text_is_refused(tmp_path: Path) -> None:
    path = edited("exail-sigmas", tmp_path / "a.txt", field(3, 9, "-0.02"))
    row = len(path.read_text().splitlines()) - 2
    message = error_of("exail-sigmas", path).message
    assert message == error("trajectory.negative_sigma", file=str(path), row=row)


def test_rows_with_a_date_are_not_in_a_time_of_the_week(tmp_path: Path) -> None:
    path = VALID_FILES["exail-text"](tmp_path / "a.txt")
    message = error_of("exail-text", path, {"time": "gps-week"}).message
    assert message == error("trajectory.dates", file=str(path), base="gps-week")


def test_times_are_continued_over_midnight(tmp_path: Path) -> None:
    """Seconds of the day over midnight, one row every half minute."""
    seconds = 86_000.0 + 30 * np.arange(40)
    path = tmp_path / "a.txt"
    path.write_text("".join(f"{s % 86_400:.1f} 45.5 -73.5 10 0 0 90\n" for s in seconds))
    read = ASCII.read(path, {"time": "utc-day"})
    np.testing.assert_allclose(read.time, seconds)
    assert note("assumed.time_rollover", count=1) in read.assumptions


@pytest.mark.parametrize(
    ("place", "code"),
    [
        ("400 -73.5", "trajectory.not_on_earth"),
        ("95 200", "trajectory.not_on_earth"),
        ("-123.5 45.5", "trajectory.exchanged_position"),
    ],
)
def test_positions_that_are_not_on_earth_are_refused(tmp_path: Path, place: str, code: str) -> None:
    path = tmp_path / "a.txt"
    path.write_text("".join(f"{k} {place} 10 0 0 90\n" for k in range(1000, 1010)))
    latitude, longitude = (float(word) for word in place.split())
    message = error_of("ascii-trajectory", path).message
    assert message is not None
    assert message.code == code
    assert message.params["row"] == 1
    assert message.params["latitude"] == pytest.approx(np.radians(latitude))
    assert message.params["longitude"] == pytest.approx(np.radians(longitude))


@pytest.mark.parametrize(
    ("latitude", "unit", "code"),
    [
        (100.0, "degrees", "sbet.not_degrees"),
        (100.0, "radians", "sbet.in_degrees"),
        (500.0, "radians", "sbet.not_radians"),
    ],
)
def test_impossible_latitudes_of_an_sbet_are_refused(
    tmp_path: Path, latitude: float, unit: str, code: str
) -> None:
    records = vessel(200)
    records[:, 1] = latitude
    path = write_records(tmp_path / "a.sbet", records)
    message = error_of("sbet", path, {"unit": unit}).message
    assert message is not None
    assert (message.code, message.params["record"]) == (code, 1)
    assert message.params["largest"] == pytest.approx(latitude)


def test_a_heading_of_many_turns_must_be_reached_by_turning() -> None:
    """Ten seconds are enough for the same headings, one second is not."""
    heading = np.linspace(12.5, 12.6, 11)
    level = np.zeros(11)
    require_attitude(Path("a"), np.arange(11.0), (level, level, heading))
    with pytest.raises(InputError) as caught:
        require_attitude(Path("a"), np.arange(11) / 10, (level, level, heading))
    first = int(np.argmax(heading > 4 * np.pi))
    assert caught.value.code == "trajectory.attitude_in_record"
    assert caught.value.message is not None
    assert caught.value.message.params == {
        "file": "a", "number": first + 1, "roll": 0.0, "pitch": 0.0, "heading": heading[first],
    }  # fmt: skip


def test_times_that_contradict_the_given_base_are_reported() -> None:
    time = 486_000 + np.arange(200) / 50
    assert time_warnings(time, "gps-week", "a") == ()
    (other,) = time_warnings(time, "utc-day", "a")
    assert (other.code, other.params["base"]) == ("trajectory.other_time_base", "utc-day")
    assert "gps-week" in other.params["bases"]  # type: ignore[operator]
    start, end = time[0] + 1e10, time[-1] + 1e10
    assert time_warnings(time + 1e10, "gps-week", "a") == (
        warning("trajectory.no_time_base", file="a", start=start, end=end),
    )


def test_a_heading_across_the_course_gives_a_warning(tmp_path: Path) -> None:
    """The heading of the valid file is two degrees to starboard of its course."""
    records = vessel()
    assert not SBET.preview(write_records(tmp_path / "a.sbet", records), {}).file_warnings
    records[:, 9] += np.radians(80)
    (message,) = SBET.preview(write_records(tmp_path / "a.sbet", records), {}).file_warnings
    assert message.code == "trajectory.heading_differs"
    assert message.params["difference"] == pytest.approx(np.radians(82), abs=np.radians(0.5))


@pytest.mark.parametrize(
    ("position", "attitude_deg", "file_warnings"),
    [
        (0.02, 0.01, []),
        (0.0, 0.01, ["accuracy.all_zero"]),
        (0.02, 0.0, ["accuracy.all_zero"]),
        (0.02, 2.0, ["accuracy.large"]),
        (200.0, 0.01, ["accuracy.large"]),
    ],
)
def test_implausible_standard_deviations_give_warnings(
    position: float, attitude_deg: float, file_warnings: list[str]
) -> None:
    sigmas = np.full((5, 3), position), np.full((5, 3), np.radians(attitude_deg))
    found = accuracy_facts(TrajectoryAccuracy(np.arange(5.0), *sigmas), "a")[1]
    assert codes(found) == file_warnings
    for each in found:
        if each.code == "accuracy.large":
            assert each.params["position"] == position
            assert each.params["attitude"] == pytest.approx(np.radians(attitude_deg))


def test_comments_at_the_end_of_text_are_skipped(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trajectory_preview, "HEAD_ROWS", 50)
    path = VALID_FILES["exail-text"](tmp_path / "a.txt")
    plain = EXAIL.preview(path, {})
    with path.open("a") as file:
        file.write("# end of the export\n\n")
    found = EXAIL.preview(path, {})
    assert found.facts["End"] == plain.facts["End"]
    assert found.file_warnings == plain.file_warnings
    assert len(EXAIL.read(path, found.choice).time) == 200


def test_an_altitude_above_the_ellipsoid_is_a_height(tmp_path: Path) -> None:
    """Both kinds are named altitude; only the description distinguishes them."""
    records = vessel(200)
    path = write_delph(tmp_path / "a.txt", records)
    text = path.read_text().replace("ellipsoidHeight", "altitude")
    at_sea = []
    for words in ("Altitude above the ellipsoid, meter", "Altitude above mean sea, meter"):
        path.write_text(text.replace("Height, meter positive upward", words, 1))
        found = EXAIL.preview(path, {})
        read = EXAIL.read(path, found.choice)
        at_sea.append("assumed.heights_above_sea" in codes(read.assumptions))
        np.testing.assert_allclose(read.height, records[:, 3], atol=1e-4)
    assert at_sea == [False, True]


def test_times_of_day_without_a_date_are_utc(tmp_path: Path) -> None:
    path = write_delph(tmp_path / "a.txt", vessel(200))
    path.write_text(
        path.read_text().replace("#date\ttime", "#time").replace("2023/06/27\t", "")
    )  # fmt: skip
    found = EXAIL.preview(path, {})
    assert found.choice["time"] == "utc-day"
    np.testing.assert_allclose(
        EXAIL.read(path, found.choice).time, 14 * 3600 + np.arange(200) / 50, atol=1e-4
    )


def test_text_among_the_rows_of_pospac(tmp_path: Path) -> None:
    """A line of the header that begins like the names is not read as the names."""
    records = vessel(200)
    path = write_pospac(tmp_path / "a.txt", records)
    text = path.read_text()
    path.write_text(text.replace(" Parameter setup:", " TIME, place, weather, crew, mood: fine"))
    read = format_of("pospac-text").read(path, {})
    np.testing.assert_allclose(read.time, records[:, 0], atol=1e-5)
    path.write_text(f"{text}End of the export, of 200 rows\n")
    row = len(text.splitlines()) + 1
    message = error_of("pospac-text", path).message
    text = "End of the export, of 200 rows"
    assert message == error("trajectory.not_a_row", file=str(path), row=row, text=text)
