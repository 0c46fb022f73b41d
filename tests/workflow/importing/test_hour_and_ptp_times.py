"""Tests of lines with times in seconds of the hour (Velodyne) and in TAI (PTP)."""

from pathlib import Path

import numpy as np
import pytest

from lispac.cli.main import main
from lispac.survey.time_base import GPS_EPOCH, WEEK
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import load_survey
from tests.support.input_file_samples import START, fan, write_line, write_survey

POINT_COUNT = 2000
TIMES = START + np.linspace(10, 25, POINT_COUNT)
HOUR_TIMES = np.mod(TIMES - 18.0, 3600.0)
TAI_TIMES = TIMES + 2300 * WEEK + GPS_EPOCH + 19.0


def line(path: Path, times: np.ndarray) -> Path:
    if path.suffix == ".csv":
        table = np.column_stack([times, fan(len(times))])
        np.savetxt(path, table, fmt="%.6f", header="time,x,y,z", comments="", delimiter=",")
        return path
    return write_line(path, times)


@pytest.mark.parametrize("name", ["a.las", "a.csv"])
@pytest.mark.parametrize(("base", "times"), [("utc-hour", HOUR_TIMES), ("tai", TAI_TIMES)])
def test_a_line_with_a_given_base_is_shifted_to_the_trajectory(
    tmp_path: Path, name: str, base: str, times: np.ndarray
) -> None:
    """The line crosses a full hour of UTC."""
    assert (np.diff(HOUR_TIMES) < 0).any()
    folder = write_survey(tmp_path)
    path = line(folder / name, times)
    command = [
        "new", str(tmp_path / "p"), str(path), "--trajectory", str(folder / "pos.sbet"),
        "--lever-arm", "0", "0", "0", "--line-option", f"time_base={base}",
        "--trajectory-option", "time=gps-week",
    ]  # fmt: skip
    assert main(command) == 0
    survey = load_survey(open_project(tmp_path / "p"))
    _, found = survey.scans["a"].take(np.arange(POINT_COUNT))
    np.testing.assert_allclose(found, TIMES, rtol=0, atol=2e-6)


def test_the_base_that_fits_is_suggested(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = write_survey(tmp_path)
    path = line(folder / "a.csv", TAI_TIMES)
    command = ["new", str(tmp_path / "p"), str(path), "--trajectory", str(folder / "pos.sbet"),
               "--lever-arm", "0", "0", "0"]  # fmt: skip
    assert main(command) == 1
    shift = TIMES[0] - TAI_TIMES[0]
    errors = capsys.readouterr().err
    assert f"add {shift:+.3f} s" in errors  # as UTC it would be 37 s off, outside the trajectory
