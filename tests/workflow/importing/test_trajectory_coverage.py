"""Tests of messages about points, accuracies and time bases that do not match the trajectory."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.messages import Message
from lispac.project import LineSource, Reading, Settings
from lispac.survey.crs import coordinate_system
from lispac.survey.time_base import GPS_EPOCH, WEEK
from lispac.workflow.importing.input_files import InputFiles
from lispac.workflow.project.projects import new_project
from lispac.workflow.project.survey import Survey
from tests.support.command_errors import codes_of
from tests.support.input_file_samples import LEVER, START, fan, import_files, named, write_line
from tests.support.trajectory_files import vessel, write_records

SYSTEM = "EPSG:32619"


def make_project(folder: Path, track: Path, line: Path, reading=Reading(), **more):  # noqa: B008
    return new_project(
        folder, trajectory=track, lines=[LineSource("L", line, reading=reading)],
        settings=Settings(lever_arm=LEVER), **more,
    )  # fmt: skip


def test_gaps_and_ends_are_distinguished_for_georeferenced_lines(tmp_path: Path) -> None:
    records = vessel(2000)
    time = records[:, 0] - START
    write_records(tmp_path / "gap.sbet", records[(time < 10) | (time > 14)])
    system = coordinate_system(SYSTEM, height="ellipsoid")
    place = system.from_geodetic(*(records[:1, k] for k in (1, 2, 3)))[0]
    times = START + np.linspace(5, 45, 4001)
    line = write_line(tmp_path / "utm.las", times, place + fan(4001), SYSTEM)
    _, survey = make_project(tmp_path / "p", tmp_path / "gap.sbet", line)
    found = {each.code: each.params for each in survey.notes}
    outside, in_gaps = found["import.excluded_outside"], found["import.excluded_in_gaps"]
    end = float(records[-1, 0])
    assert (outside["count"], outside["total"]) == ((times > end).sum(), 4001)
    opens, closes = time[time < 10].max() + START, time[time > 14].min() + START
    count = ((times > opens) & (times < closes)).sum()
    assert (in_gaps["count"], in_gaps["limit"]) == (count, 1.5)


def too_short_of(survey: Survey) -> list[Message]:
    """Return the messages that the accuracies do not cover the whole trajectory."""
    return [each for each in survey.messages if each.code == "import.accuracy_too_short"]


def test_accuracies_that_cover_half_the_trajectory_are_reported(tmp_path: Path) -> None:
    write_records(tmp_path / "pos.sbet", vessel(2000))
    accuracy = np.tile([0, 0.01, 0.01, 0.02, 0.1, 0.1, 0.1, 0.5, 0.5, 0.7], (41, 1))
    accuracy[:, 0] = START + np.arange(41)
    write_records(tmp_path / "half.out", accuracy[:21])
    write_records(tmp_path / "whole.out", accuracy)
    line = write_line(tmp_path / "L.las", START + np.linspace(5, 30, 3000))
    track = tmp_path / "pos.sbet"
    _, survey = make_project(tmp_path / "p", track, line, accuracy=tmp_path / "half.out")
    (too_short,) = too_short_of(survey)
    assert too_short.params["file"] == "half.out"
    assert (too_short.params["first"], too_short.params["last"]) == (START, START + 20)
    assert replace(too_short, subject=None) in (
        input_files := import_files(InputFiles(), track, tmp_path / "half.out")
    ).messages(named(input_files, "half.out"))
    _, survey = make_project(tmp_path / "q", track, line, accuracy=tmp_path / "whole.out")
    assert too_short_of(survey) == []


def test_a_time_base_derived_from_the_values_is_reported_as_such(tmp_path: Path) -> None:
    records = vessel(2000)
    gps = 2278 * WEEK + records[:, 0]
    records[:, 0] = gps - 18 + GPS_EPOCH
    write_records(tmp_path / "unix.sbet", records)
    line = write_line(tmp_path / "L.las", gps[0] - 1e9 + np.linspace(5, 30, 3000))
    reading = Reading("", (("time_base", "gps-adjusted"),))
    with pytest.raises(InputError) as caught:
        make_project(tmp_path / "p", tmp_path / "unix.sbet", line, reading)
    text = str(caught.value)
    assert "GPS seconds since 1980-01-06 (as its values suggest)" in text
    assert "time_base.other_trajectory_base" in codes_of(caught.value)
    assert "--trajectory-option time=unix" in text
    _, survey = make_project(
        tmp_path / "p", tmp_path / "unix.sbet", line, reading,
        trajectory_reading=Reading("", (("time", "unix"),)),
    )  # fmt: skip
    assert len(survey.scans["L"]) == 3000
