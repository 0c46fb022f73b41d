"""What is said of points, accuracies and time bases that do not fit the trajectory."""

from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.message_texts import note_text
from lispac.project import LineSource, Reading, Settings
from lispac.survey.crs import coordinate_system
from lispac.survey.time_base import GPS_EPOCH, WEEK
from lispac.workflow.intake import Intake
from lispac.workflow.projects import new_project
from tests.command_errors import codes_of
from tests.intake_files import LEVER, START, fan, said, taken_in, write_line
from tests.trajectory_files import vessel, write_records

SYSTEM = "EPSG:32619"


def made(folder: Path, track: Path, line: Path, reading=Reading(), **more):  # noqa: B008
    return new_project(
        folder, trajectory=track, lines=[LineSource("L", line, reading=reading)],
        settings=Settings(lever_arm=LEVER), **more,
    )  # fmt: skip


def test_gaps_are_told_from_the_ends_for_lines_on_the_map_too(tmp_path: Path) -> None:
    records = vessel(2000)
    time = records[:, 0] - START
    write_records(tmp_path / "gap.sbet", records[(time < 10) | (time > 14)])
    system = coordinate_system(SYSTEM, height="ellipsoid")
    place = system.from_geodetic(*(records[:1, k] for k in (1, 2, 3)))[0]
    times = START + np.linspace(5, 45, 4001)
    line = write_line(tmp_path / "utm.las", times, place + fan(4001), SYSTEM)
    _, survey = made(tmp_path / "p", tmp_path / "gap.sbet", line)
    note = next(each for each in map(note_text, survey.notes) if "are left out" in each)
    end = float(records[-1, 0])
    assert f"{(times > end).sum():,} points outside the trajectory's time" in note
    assert "points in a gap of the trajectory longer than 1.5 s, of 4,001, are left out" in note
    opens, closes = time[time < 10].max() + START, time[time > 14].min() + START
    assert f"and {((times > opens) & (times < closes)).sum():,} points in a gap" in note


def test_accuracies_that_cover_half_the_trajectory_are_said(tmp_path: Path) -> None:
    write_records(tmp_path / "pos.sbet", vessel(2000))
    accuracy = np.tile([0, 0.01, 0.01, 0.02, 0.1, 0.1, 0.1, 0.5, 0.5, 0.7], (41, 1))
    accuracy[:, 0] = START + np.arange(41)
    write_records(tmp_path / "half.out", accuracy[:21])
    write_records(tmp_path / "whole.out", accuracy)
    line = write_line(tmp_path / "L.las", START + np.linspace(5, 30, 3000))
    told = "the first and last values are used"
    track = tmp_path / "pos.sbet"
    _, survey = made(tmp_path / "p", track, line, accuracy=tmp_path / "half.out")
    notes = " ".join(map(note_text, survey.notes))
    assert "486,000.0" in notes
    assert "486,020.0" in notes
    assert told in notes
    assert told in said(taken_in(Intake(), track, tmp_path / "half.out"), "half.out")
    _, survey = made(tmp_path / "q", track, line, accuracy=tmp_path / "whole.out")
    assert told not in " ".join(map(note_text, survey.notes))


def test_a_base_that_the_values_suggested_is_said_to_be_that(tmp_path: Path) -> None:
    records = vessel(2000)
    gps = 2278 * WEEK + records[:, 0]
    records[:, 0] = gps - 18 + GPS_EPOCH
    write_records(tmp_path / "unix.sbet", records)
    line = write_line(tmp_path / "L.las", gps[0] - 1e9 + np.linspace(5, 30, 3000))
    stated = Reading("", (("time_base", "gps-adjusted"),))
    with pytest.raises(InputError) as caught:
        made(tmp_path / "p", tmp_path / "unix.sbet", line, stated)
    told = str(caught.value)
    assert "GPS seconds since 1980-01-06 (as its values suggest)" in told
    assert "time_base.other_trajectory_base" in codes_of(caught.value)
    assert "--trajectory-option time=unix" in told
    _, survey = made(
        tmp_path / "p", tmp_path / "unix.sbet", line, stated,
        trajectory_reading=Reading("", (("time", "unix"),)),
    )  # fmt: skip
    assert len(survey.scans["L"]) == 3000
