"""Tests of RIEGL POF trajectories, in the layout of the public reader ``pos``."""

from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.format_types import SURE
from lispac.io.formats import format_of, recognise_formats
from tests.support.error_codes import has_code
from tests.support.trajectory_files import truth, vessel, write_pof

FORMAT = format_of("pof")
SAMPLE = (
    5.380900320500246e4, -107.8941420696491, 3.852696630463423e1, 1721.1666764324254,
    -3.5218866203789795e-1, 2.3209047516182637, 359.62872162328546,
)  # fmt: skip
"""First record of a file of RiPROCESS: degrees and metres, from the tests of ``pos``."""


def codes(path: Path) -> list[str]:
    return [each.code for each in FORMAT.preview(path, {}).file_warnings]


@pytest.mark.parametrize("minor", [0, 1])
def test_the_trajectory_is_read(tmp_path: Path, minor: int) -> None:
    records = vessel(500, wander=0.02)
    path = write_pof(tmp_path / "a.pof", records, minor=minor)
    assert recognise_formats(path, "trajectory")[0] == (FORMAT, SURE)
    read, right = FORMAT.read(path, {}), truth(records)
    np.testing.assert_array_equal(read.time, records[:, 0])
    for name in ("latitude", "longitude", "height"):
        np.testing.assert_allclose(getattr(read, name), right[name], rtol=1e-15)
    turns = np.angle(np.exp(1j * (read.attitude - right["attitude"])))
    np.testing.assert_allclose(turns, 0, atol=1e-14)
    finding = FORMAT.preview(path, {})
    assert finding.facts["Date of mission"] == "2023-06-27"
    assert finding.facts["Records"] == 500
    # The signs are not documented, so the user has to check them.
    assert codes(path) == ["trajectory.roll_starboard_down", "trajectory.pitch_bow_up"]
    signs = {"roll": "port-down", "pitch": "bow-down"}
    assert FORMAT.preview(path, signs).file_warnings == ()
    reversed_ = FORMAT.read(path, signs)
    np.testing.assert_array_equal(reversed_.attitude, read.attitude * [-1, -1, 1])


def test_the_first_record_of_a_file_of_riprocess(tmp_path: Path) -> None:
    records = np.zeros((2, 17))
    records[:, [2, 1, 3, 7, 8, 9]] = SAMPLE[1:]
    records[:, [2, 1, 7, 8, 9]] = np.radians(records[:, [2, 1, 7, 8, 9]])
    records[:, 0] = SAMPLE[0] + np.array([0.0, 0.005])
    path = write_pof(tmp_path / "a.pof", records, unit=1)
    read = FORMAT.read(path, {})
    assert read.time[0] == SAMPLE[0]
    shown = np.degrees([read.longitude[0], read.latitude[0], *read.attitude[0] * [1, -1, 1]])
    np.testing.assert_allclose(shown, [SAMPLE[1], SAMPLE[2], *SAMPLE[4:]], rtol=1e-14)
    assert read.height[0] == SAMPLE[3]


@pytest.mark.parametrize(
    ("unit", "system", "start", "base", "code"),
    [
        (2, 0, 486_000.0, "gps-week", None),
        (2, 1, 486_000.0, "utc-week", None),
        (1, 0, 54_000.0, "gps-day", None),
        (1, 1, 54_000.0, "utc-day", None),
        (1, 2, 54_000.0, "gps-day", "trajectory.pof_gps_assumed"),
        (0, 0, 12.0, "gps-week", "trajectory.pof_unknown_start"),
    ],
)
def test_the_header_gives_the_time_base(
    tmp_path: Path, unit: int, system: int, start: float, base: str, code: str | None
) -> None:
    records = vessel(500)
    records[:, 0] += start - records[0, 0]
    path = write_pof(tmp_path / "a.pof", records, unit=unit, system=system)
    assert FORMAT.preview(path, {}).choice["time"] == base
    own = [each for each in codes(path) if each.startswith("trajectory.pof_")]
    assert own == ([] if code is None else [code])
    np.testing.assert_allclose(FORMAT.read(path, {}).time, records[:, 0], rtol=0, atol=1e-9)


def test_damaged_files_are_refused(tmp_path: Path) -> None:
    path = write_pof(tmp_path / "a.pof", vessel(200))
    content = path.read_bytes()

    def refused(data: bytes, code: str) -> None:
        path.write_bytes(data)
        with pytest.raises(InputError, check=has_code(code)):
            FORMAT.read(path, {})

    refused(content[:-64], "trajectory.pof_count")
    refused(b"\1" * 5000, "trajectory.pof_header")
    refused(content[:100], "trajectory.pof_header")
    refused(content[:27] + b"\7" + content[28:], "trajectory.pof_header")  # another major version
    far = bytearray(content)
    far[320 + 64 + 16 : 320 + 64 + 24] = np.float64(99.0).tobytes()
    refused(bytes(far), "trajectory.pof_not_on_earth")
    write_pof(path, vessel(200)[:1])
    refused(path.read_bytes(), "trajectory.pof_one_record")
