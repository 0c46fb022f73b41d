"""Tests of the detection of conventions, units and errors of SBET files."""

from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.format_types import IMPOSSIBLE, LIKELY, POSSIBLE, SURE, FilePreview
from lispac.io.formats import format_of, recognise_formats
from lispac.io.trajectory.sbet_formats import detect_sbet, sample_blocks
from lispac.io.trajectory.sbet_motion import velocity_in_axes
from lispac.message_texts import message_text
from lispac.messages import error, note, warning
from tests.support.message_codes import codes
from tests.support.trajectory_files import truth, vessel, write_records

SBET = format_of("sbet")


def preview_of(path: Path) -> FilePreview:
    return SBET.preview(path, {})


def has(finding: FilePreview, code: str) -> bool:
    return code in codes(finding.file_warnings)


def test_leeward_survey_is_detected_with_its_documented_conventions(shared_data: Path) -> None:
    path = shared_data / "leeward" / "sbet.out"
    assert recognise_formats(path, "trajectory")[0][0].key == "sbet"
    assert recognise_formats(path, "trajectory")[0][1] == SURE
    finding = preview_of(path)
    assert finding.choice["axes"] == "wander-nwu"
    assert finding.choice["heading"] == "minus-wander"
    assert finding.choice["time"] == "gps-week"
    assert finding.facts["Records"] == 200
    assert "1.02" in message_text(finding.facts["Wander angle"])
    assert finding.rows[0][0] == "time"
    assert len(finding.rows) == 6


def test_leeward_course_agrees_to_a_hundredth_of_a_degree(shared_data: Path) -> None:
    """The course is computed here from the azimuth of the velocities less the wander angle."""
    records = np.fromfile(shared_data / "leeward" / "sbet.out").reshape(-1, 17)
    north, east, _ = velocity_in_axes("wander-nwu", records[:, 4:7], records[:, 10]).T
    step = records[-1] - records[0]
    course = np.arctan2(step[2] * np.cos(records[0, 1]) * 6388837, step[1] * 6358089)
    assert np.degrees(abs(np.median(np.arctan2(east, north)) - course)) < 0.02
    other = velocity_in_axes("ned", records[:, 4:7], records[:, 10])
    assert np.degrees(abs(np.median(np.arctan2(other[:, 1], other[:, 0])) - course)) > 0.5


def test_real_surveys_are_read_as_before(shared_data: Path) -> None:
    for name, axes in (("harbour", "ned"), ("lanl_tent", "unknown"), ("lanl_truck", "unknown")):
        path = shared_data / name / "trajectory.sbet"
        finding = preview_of(path)
        assert finding.choice["axes"] == axes
        assert not has(finding, "trajectory.exchanged")
        trajectory = SBET.read(path, finding.choice)
        records = np.fromfile(path).reshape(-1, 17)
        np.testing.assert_array_equal(trajectory.latitude, records[:, 1])
        np.testing.assert_allclose(trajectory.attitude, truth(records)["attitude"])


VELOCITY_AXES = ["wander-nwu", "wander-ned", "ned", "enu", "nwu", "neu"]


def in_axes(records: np.ndarray, axes: str) -> np.ndarray:
    """Return the records with velocities in other axes, computed from course and speed alone."""
    records = records.copy()
    forward, left, up = records[:, 4:7].T.copy()
    azimuth, speed = np.arctan2(-left, forward), np.hypot(forward, left)
    if not axes.startswith("wander"):
        azimuth = azimuth - records[:, 10]
    north, east = speed * np.cos(azimuth), speed * np.sin(azimuth)
    columns = {
        "wander-nwu": (north, -east, up), "wander-ned": (north, east, -up),
        "ned": (north, east, -up), "enu": (east, north, up),
        "nwu": (north, -east, up), "neu": (north, east, up),
    }[axes]  # fmt: skip
    records[:, 4:7] = np.stack(columns, axis=1)
    return records


@pytest.mark.parametrize("axes", VELOCITY_AXES)
def test_velocity_frame_is_detected(tmp_path: Path, axes: str) -> None:
    records = in_axes(vessel(wander=np.radians(3)), axes)
    finding = preview_of(write_records(tmp_path / "a.sbet", records))
    assert finding.choice["axes"] == axes
    assert finding.choice["heading"] == "minus-wander"
    assert has(finding, "sbet.heading_uncertain") == (not axes.startswith("wander"))


def test_true_heading_is_detected_with_a_large_wander_angle(tmp_path: Path) -> None:
    records = in_axes(vessel(wander=np.radians(50)), "ned")
    records[:, 9] -= records[:, 10]
    finding = preview_of(write_records(tmp_path / "a.sbet", records))
    assert finding.choice["heading"] == "as-is"
    trajectory = SBET.read(tmp_path / "a.sbet", finding.choice)
    np.testing.assert_allclose(trajectory.attitude[:, 2], records[:, 9])
    assert "assumed.heading_as_is" in codes(trajectory.assumptions)


def test_frame_without_wander_angle_needs_no_choice(tmp_path: Path) -> None:
    finding = preview_of(write_records(tmp_path / "a.sbet", in_axes(vessel(), "nwu")))
    assert finding.choice["axes"] == "nwu"
    assert not any("wander" in code for code in codes(finding.file_warnings))


def test_straight_level_course_does_not_determine_the_vertical_axis(tmp_path: Path) -> None:
    records = vessel()
    records[:, 6] = 0
    records[:, 3] = 10
    finding = preview_of(write_records(tmp_path / "a.sbet", in_axes(records, "ned")))
    assert finding.choice["axes"] in ("ned", "neu")
    assert has(finding, "sbet.several_axes")


def test_straight_level_course_with_a_wander_angle_is_ambiguous_too(tmp_path: Path) -> None:
    records = vessel(wander=0.5)
    records[:, 6] = 0
    records[:, 3] = 10
    finding = preview_of(write_records(tmp_path / "a.sbet", in_axes(records, "ned")))
    assert finding.choice["axes"] in ("ned", "neu")
    assert has(finding, "sbet.several_axes")
    assert has(finding, "sbet.wander_assumed")


def test_unknown_frame_is_reported(tmp_path: Path) -> None:
    records = vessel()
    records[:, 4:6] = records[:, 4:6] @ np.array([[0.6, 0.8], [-0.8, 0.6]])
    finding = preview_of(write_records(tmp_path / "a.sbet", records))
    assert finding.choice["axes"] == "unknown"
    assert has(finding, "sbet.velocities_disagree")


def test_zero_velocities_are_reported(tmp_path: Path) -> None:
    records = vessel(wander=0.1)
    records[:, 4:7] = 0
    finding = preview_of(write_records(tmp_path / "a.sbet", records))
    assert finding.choice["axes"] == "unknown"
    assert has(finding, "sbet.zero_velocities")
    assert has(finding, "sbet.wander_assumed")


@pytest.mark.parametrize("roll", ["starboard-down", "port-down"])
@pytest.mark.parametrize("pitch", ["bow-up", "bow-down"])
@pytest.mark.parametrize("rates", [(1, 1, 1), (1, -1, -1)])
def test_signs_are_detected_from_the_rates(
    tmp_path: Path, roll: str, pitch: str, rates: tuple[int, int, int]
) -> None:
    records = vessel()
    records[:, 14:17] *= rates  # forward-starboard-down, and forward-port-up
    records[:, 7] *= 1 if roll == "starboard-down" else -1
    records[:, 8] *= 1 if pitch == "bow-up" else -1
    finding = preview_of(write_records(tmp_path / "a.sbet", records))
    assert (finding.choice["roll"], finding.choice["pitch"]) == (roll, pitch)
    assert has(finding, "sbet.other_signs") == ((roll, pitch) != ("starboard-down", "bow-up"))
    trajectory = SBET.read(tmp_path / "a.sbet", finding.choice)
    np.testing.assert_allclose(trajectory.attitude, truth(vessel())["attitude"])


def test_signs_are_not_derived_from_noise(tmp_path: Path) -> None:
    records = vessel()
    records[:, 14:17] = np.random.default_rng(1).normal(0, 0.01, (len(records), 3))
    finding = preview_of(write_records(tmp_path / "a.sbet", records))
    assert (finding.choice["roll"], finding.choice["pitch"]) == ("starboard-down", "bow-up")
    assert finding.facts["Roll and pitch"] == note("fact.signs_not_checked")


@pytest.mark.parametrize("wander", [0.0, 0.05])
def test_exchanged_latitude_and_longitude_are_detected(tmp_path: Path, wander: float) -> None:
    records = vessel(wander=wander)
    records[:, [1, 2]] = records[:, [2, 1]]
    finding = preview_of(write_records(tmp_path / "a.sbet", records))
    assert finding.choice["order"] == "longitude-latitude"
    trajectory = SBET.read(tmp_path / "a.sbet", finding.choice)
    np.testing.assert_array_equal(trajectory.latitude, records[:, 2])
    assert "assumed.longitude_first" in codes(trajectory.assumptions)


def test_exchanged_positions_are_detected_from_the_heading(tmp_path: Path) -> None:
    records = vessel()
    records[:, [1, 2]] = records[:, [2, 1]]
    records[:, 4:7] = 0
    assert has(preview_of(write_records(tmp_path / "a.sbet", records)), "trajectory.exchanged")


def test_degrees_are_detected_and_read(tmp_path: Path) -> None:
    records = vessel()
    angles = [1, 2, 7, 8, 9, 10]
    records[:, angles] = np.degrees(records[:, angles])
    path = write_records(tmp_path / "a.sbet", records)
    finding = preview_of(path)
    assert finding.choice["unit"] == "degrees"
    assert has(finding, "sbet.degrees_assumed")
    trajectory = SBET.read(path, finding.choice)
    np.testing.assert_allclose(trajectory.latitude, vessel()[:, 1], rtol=1e-15)
    assert recognise_formats(path, "trajectory")[0][0].key == "sbet"


def test_big_endian_is_detected_and_read(tmp_path: Path) -> None:
    path = write_records(tmp_path / "a.sbet", vessel(), order=">")
    assert recognise_formats(path, "trajectory")[0] == (SBET, LIKELY)
    finding = preview_of(path)
    assert finding.choice["byte_order"] == "big-endian"
    assert has(finding, "sbet.big_endian")
    np.testing.assert_array_equal(SBET.read(path, finding.choice).latitude, vessel()[:, 1])


RNG = np.random.default_rng(5)
OTHER_BINARIES = {
    "noise": RNG.integers(0, 256, 136 * 300, dtype=np.uint8).tobytes(),
    "float64 of a size": RNG.uniform(0, 1, 17 * 300).astype("<f8").tobytes(),
    "counting": np.arange(17.0 * 300).astype("<f8").tobytes(),
    "float32": RNG.normal(0, 10, 34 * 300).astype("<f4").tobytes(),
    "whole numbers": np.arange(34 * 300, dtype="<i4").tobytes(),
    "accuracies": np.column_stack(
        [486_000 + np.arange(340) / 50, RNG.uniform(0, 0.1, (340, 9))]
    ).astype("<f8").tobytes(),
    "times and zeros": np.column_stack(
        [486_000 + np.arange(300) / 50, np.zeros((300, 16))]
    ).astype("<f8").tobytes(),
}  # fmt: skip
"""Content of files that are as long as some SBET is."""


@pytest.mark.parametrize("name", OTHER_BINARIES)
def test_other_binaries_of_fitting_length_are_not_called_sbet(tmp_path: Path, name: str) -> None:
    path = tmp_path / "a.out"
    path.write_bytes(OTHER_BINARIES[name])
    assert path.stat().st_size % 136 == 0
    assert SBET.sniff(path) == IMPOSSIBLE


def test_files_of_points_are_not_called_sbet(tmp_path: Path, shared_data: Path) -> None:
    points = b"".join(p.read_bytes() for p in sorted(shared_data.glob("cidco/q*/*/target*")))
    whole = 17 * 176
    (tmp_path / "points").write_bytes(points[: len(points) // whole * whole])
    (tmp_path / "a.las").write_bytes((shared_data / "leeward/points.las").read_bytes()[: 136 * 500])
    assert SBET.sniff(tmp_path / "points") == SBET.sniff(tmp_path / "a.las") == IMPOSSIBLE


@pytest.mark.parametrize("change", ["degrees", "exchanged", "disorder", "end"])
def test_the_last_record_has_to_be_one_of_an_sbet(tmp_path: Path, change: str) -> None:
    records = vessel()
    if change == "degrees":
        records[:, [1, 2, 7, 8, 9, 10]] = np.degrees(records[:, [1, 2, 7, 8, 9, 10]])
    elif change == "exchanged":
        records[:, 2] -= 1  # out of the range of a latitude
        records[:, [1, 2]] = records[:, [2, 1]]
    elif change == "disorder":
        records[[5, 50]] = records[[50, 5]]
    else:
        records[-50:] = 1e9
    path = write_records(tmp_path / "a.sbet", records)
    assert SBET.sniff(path) == (LIKELY if change == "end" else POSSIBLE)
    if change != "end":
        records[-50:] = 1e9
        assert SBET.sniff(write_records(path, records)) == IMPOSSIBLE


@pytest.mark.parametrize("shift", [0.0, -400_000.0, 1e9, 315_964_800 + 1e9])
def test_time_base_is_reported(tmp_path: Path, shift: float) -> None:
    records = vessel(300)
    records[:, 0] += shift
    path = write_records(tmp_path / "a.sbet", records)
    finding = preview_of(path)
    trajectory = SBET.read(path, finding.choice)
    assert "assumed.time_base" in codes(trajectory.assumptions)
    assert has(finding, "times.several_bases") == (shift != 0.0)


def test_a_long_file_is_detected_from_a_part(tmp_path: Path) -> None:
    records = np.tile(vessel(2000), (40, 1))
    records[:, 0] = 486_000 + np.arange(len(records)) / 50.0
    records.tofile(tmp_path / "a.sbet")
    detection = detect_sbet(tmp_path / "a.sbet")
    assert detection.facts["Records"] == 80_000
    assert detection.facts["End"].params["time"] == pytest.approx(records[-1, 0])
    assert detection.options.axes == "nwu"


def test_gap_and_backward_times_are_counted(tmp_path: Path) -> None:
    records = vessel()
    records[1000:, 0] += 30
    found = preview_of(write_records(tmp_path / "a.sbet", records)).file_warnings
    (gaps,) = (each for each in found if each.code == "trajectory.gaps")
    assert gaps.params["count"] == 1
    assert gaps.params["limit"] == 1.5
    records[500, 0] = records[400, 0]
    found = preview_of(write_records(tmp_path / "b.sbet", records)).file_warnings
    (backward,) = (each for each in found if each.code == "times.decreasing")
    assert (backward.params["count"], backward.params["total"]) == (1, 2000)


def test_the_week_rollover_is_resolved_and_reported(tmp_path: Path) -> None:
    records = vessel(200)
    records[:, 0] = (604_798 + np.arange(200) / 50.0) % 604_800
    path = write_records(tmp_path / "a.sbet", records)
    trajectory = SBET.read(path, {})
    np.testing.assert_allclose(np.diff(trajectory.time), 0.02, atol=1e-9)
    assert note("assumed.time_rollover", count=1) in trajectory.assumptions
    assert not has(preview_of(path), "times.decreasing")


def test_records_without_a_usable_time_are_counted_and_skipped(tmp_path: Path) -> None:
    records = vessel(200)
    records[7, 0] = np.nan
    finding = preview_of(write_records(tmp_path / "a.sbet", records))
    assert warning("sbet.not_finite", file="a.sbet", count=1) in finding.file_warnings
    assert finding.facts["Start"] == note("fact.time", time=486_000.0)
    assert finding.facts["End"].params["time"] == pytest.approx(486_000 + 199 / 50)


def test_times_that_fit_no_base_give_a_warning(tmp_path: Path) -> None:
    """1e10 s after 1970 is the year 2286."""
    records = vessel(200)
    records[:, 0] += 1e10
    finding = preview_of(write_records(tmp_path / "a.sbet", records))
    first, last = records[[0, -1], 0]
    expected = warning("trajectory.no_time_base", file="a.sbet", start=first, end=last)
    assert expected in finding.file_warnings


def test_degrees_of_position_alone_give_a_warning(tmp_path: Path) -> None:
    records = vessel(200)
    records[:, [1, 2]] = np.degrees(records[:, [1, 2]])
    finding = preview_of(write_records(tmp_path / "a.sbet", records))
    assert has(finding, "sbet.heading_in_radians")
    records[:, 2] = -400.0
    not_angles = warning("sbet.not_angles", file="b.sbet", largest=400.0)
    assert not_angles in preview_of(write_records(tmp_path / "b.sbet", records)).file_warnings


def test_a_file_that_is_lost_during_detection_is_reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """For example on a network drive that disconnects between two reads."""
    path = write_records(tmp_path / "a.sbet", vessel(200))
    assert len(sample_blocks(path)[0][0]) == sample_blocks(path)[1] == 200
    assert sample_blocks(tmp_path / "absent") == ([], 0)
    monkeypatch.setattr("lispac.io.trajectory.sbet_formats.np.memmap", raise_io_error)
    with pytest.raises(InputError) as refused:
        detect_sbet(path)
    assert refused.value.message == error("sbet.not_readable", file=str(path))


def raise_io_error(*_: object, **__: object) -> np.ndarray:
    raise OSError(5, "Input/output error")


def test_messages_of_a_file_are_those_of_its_preview(shared_data: Path, tmp_path: Path) -> None:
    """They are returned without the preview, which takes as long as the reading."""
    exchanged = tmp_path / "exchanged.sbet"
    records = np.fromfile(shared_data / "harbour" / "trajectory.sbet").reshape(-1, 17)[:2000]
    write_records(exchanged, records[:, [0, 2, 1, *range(3, 17)]])
    for format, path in (
        (SBET, shared_data / "harbour" / "trajectory.sbet"),
        (SBET, exchanged),
        (format_of("smrmsg"), shared_data / "harbour" / "smrmsg.out"),
    ):
        assert format.messages(path, {}) == format.preview(path, {}).messages
