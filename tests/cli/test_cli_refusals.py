"""Tests of refused options, which end a command with exit code 2, and of `lispac inspect`."""

from pathlib import Path

import numpy as np
import pytest

from tests.cli.test_cli import run

ESTIMATE_PLANES = ["estimate", "--planes", "a.txt", "--lever-arm", "0", "0", "0"]


@pytest.mark.parametrize(
    ("words", "refusal"),
    [
        (["patchtest", "p", "--object", "pole=1,2,3,4,5,6", "--object", "pole=1,2,3,4,5,7"],
         "patchtest: two objects have the same name."),
        (["patchtest", "p", "--count", "0"],
         "patchtest: give objects with --object, or detect some with --count."),
        (["patchtest", "p", "--object", "pole=here"],
         "patchtest: pole=here is not NAME=N,W,U,A,L,H or NAME=N,W,U,A,L,H,TURN."),
        ([*ESTIMATE_PLANES, "--latency", "0.01"],
         "estimate: --latency requires a project; plane files already contain interpolated "
         "positions."),
        ([*ESTIMATE_PLANES, "--estimate", "latency=soon"],
         "estimate: 'soon' in latency=soon is not a number."),
        (["angles", "1", "two", "3"], "angles: 1 two 3 are not three numbers."),
        (["angles", "1", "2", "inf"], "angles: an angle is not a finite number."),
    ],
)  # fmt: skip
def test_incompatible_options_are_refused(
    capsys: pytest.CaptureFixture[str], words: list[str], refusal: str
) -> None:
    assert run(capsys, *words) == (2, "", f"lispac: {refusal}\n")


def test_an_unknown_parameter_is_refused_with_a_list_of_the_known_ones(
    capsys: pytest.CaptureFixture[str],
) -> None:
    code, out, err = run(capsys, *ESTIMATE_PLANES, "--estimate", "none", "--estimate", "wobble")
    assert (code, out) == (2, "")
    assert err.startswith("lispac: estimate: there is no parameter wobble; ")
    assert "give one of " in err
    assert "latency" in err


@pytest.mark.parametrize(
    ("words", "refusal"),
    [
        (["patchtest", "p", "--object", "pole"], "'pole' is not NAME=VALUE"),
        (["patchtest", "p", "--object", "=1,2,3"], "'=1,2,3' is not NAME=VALUE"),
        (["quality", "p", "--map", "map.bmp"], "'map.bmp' does not end in .png, .svg or .pdf"),
    ],
)  # fmt: skip
def test_invalid_option_values_are_refused(
    capsys: pytest.CaptureFixture[str], words: list[str], refusal: str
) -> None:
    code, out, err = run(capsys, *words)
    assert (code, out) == (2, "")
    assert err.endswith(f"{refusal}\n")


def test_a_lever_arm_beside_a_matrix_that_contains_one_is_refused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    matrix = tmp_path / "m.txt"
    np.savetxt(matrix, np.eye(4))
    words = ("angles", "--from-matrix", matrix, "--to", "lispac")
    code, out, err = run(capsys, *words, "--lever-arm", 1, 2, 3)
    assert (code, out) == (2, "")
    assert err == "lispac: angles: the 4x4 matrix contains the lever arm; omit --lever-arm.\n"
    assert run(capsys, *words)[0] == 0


def test_a_file_that_is_cut_short_is_recognised_and_reported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """`lispac inspect` prints the format of the file and why it cannot be read."""
    path = tmp_path / "line.las"
    path.write_bytes(b"LASF" + bytes(40))
    code, out, _ = run(capsys, "inspect", path)
    assert code == 0
    assert "certainly LAS or LAZ (--line-format las)" in out
    assert "\n  cannot be read: " in out


def test_a_trajectory_is_not_reported_as_unreadable_points(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """Latitudes with letters are not coordinates of points; rows before the first fix are zero."""
    path = tmp_path / "track.txt"
    rows = [
        f"{t:.1f},0.0,0.0,0.0,0.1,0.1,0.1" if t < 2 else
        f"{t:.1f},{46.8 + t * 1e-5:.9f}N,{71.2:.9f}W,12.0,0.1,0.1,0.1"
        for t in (k / 10 for k in range(400))
    ]  # fmt: skip
    path.write_text("\n".join(["Time,Latitude,Longitude,Height,Roll,Pitch,Heading", *rows]))
    code, out, _ = run(capsys, "inspect", path)
    assert code == 0
    assert "(--trajectory-format " in out
    assert "cannot be read" not in out
    assert "jump" not in out
