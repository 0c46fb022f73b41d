"""Tests of text points with times of the form hh:mm:ss."""

import gzip
from pathlib import Path

import numpy as np
import pytest

from lispac.cli.main import run
from lispac.errors import InputError, LispacError
from lispac.io.formats import format_of
from lispac.project import LineSource, Reading, Settings
from lispac.survey.time_base import DAY
from lispac.workflow.importing.input_files import InputFiles
from lispac.workflow.project.projects import new_project
from tests.support.error_codes import has_code
from tests.support.input_file_samples import LEVER, START, codes_about, import_files
from tests.support.message_codes import codes
from tests.support.trajectory_files import vessel, write_records


def clock_texts(seconds: np.ndarray) -> list[str]:
    texts = []
    for t in np.mod(seconds, DAY):
        texts.append(f"{int(t // 3600):02d}:{int(t % 3600 // 60):02d}:{t % 60:09.6f}")
    return texts


@pytest.fixture
def times() -> np.ndarray:
    return np.round(START + np.linspace(5, 30, 2000), 6)


@pytest.fixture
def track(tmp_path: Path) -> Path:
    write_records(tmp_path / "pos.sbet", vessel(2000))
    return tmp_path / "pos.sbet"


def rows_of(times: np.ndarray) -> str:
    return "\n".join(f"{c},{k % 5},10.5,{k % 7}" for k, c in enumerate(clock_texts(times)))


def test_the_reader_gives_seconds_of_the_day(times, tmp_path) -> None:
    path = tmp_path / "L.csv.gz"
    path.write_bytes(gzip.compress(("Time,X,Y,Z\n" + rows_of(times)).encode()))
    text = format_of("text")
    assert text.sniff(path) > 0.5
    found = text.preview(path, {})
    assert found.choice["columns"] == "time x y z"
    assert "times.clock_without_base" in codes(found.file_warnings)
    assert codes(text.preview(path, {"time_base": "utc-day"}).file_warnings) == []
    (chunk,) = text.read(path, dict(found.choice))
    assert chunk.time == pytest.approx(np.mod(times, DAY), abs=1e-6)
    assert chunk.xyz[3] == pytest.approx([3, 10.5, 3])


@pytest.mark.parametrize("named", [(), ("time", "x", "y", "z")])
def test_a_project_reads_clock_times(named, times, track, tmp_path, capsys) -> None:
    (tmp_path / "L.csv").write_text("Time,X,Y,Z\n" + rows_of(times))
    day = START - START % DAY
    _, survey = new_project(
        tmp_path / "p", trajectory=track, settings=Settings(lever_arm=LEVER),
        lines=[LineSource("L", tmp_path / "L.csv", named, Reading("", (), day))],
    )  # fmt: skip
    assert survey.scans["L"].time == pytest.approx(times, abs=1e-6)
    assert "times.clock_without_base" in codes_about(
        import_files(InputFiles(), track, tmp_path / "L.csv"), "L.csv"
    )


def test_a_row_with_an_invalid_clock_time_is_named(times, tmp_path) -> None:
    rows = rows_of(times).split("\n")
    rows[1200] = "13:61:00.0,1,2,3"
    (tmp_path / "L.csv").write_text("Time,X,Y,Z\n" + "\n".join(rows))
    invalid = has_code("text.not_a_clock_time", row=1202, value="13:61:00.0")
    with pytest.raises(InputError, check=invalid):
        list(format_of("text").read(tmp_path / "L.csv", {}))


def test_times_of_another_form_are_refused(track, times, tmp_path, capsys) -> None:
    rows = [f"2023-05-09T{c}Z,1,2,3" for c in clock_texts(times)]
    (tmp_path / "L.csv").write_text("Time,X,Y,Z\n" + "\n".join(rows))
    command = ["new", str(tmp_path / "p"), str(tmp_path / "L.csv"), "--trajectory", str(track)]
    with pytest.raises(LispacError, match=r"L\.csv") as refused:
        run([*command, "--lever-arm", "0", "0", "0"])
    assert refused.value.code == "text.no_number_rows"
