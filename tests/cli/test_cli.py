"""Tests of the command line from raw files to the report, and of its refusals."""

import json
import pkgutil
import shutil
from importlib import import_module
from pathlib import Path
from typing import Any

import laspy
import numpy as np
import pytest

from lispac import scripting, workflow
from lispac.cli.main import main
from lispac.cli.output.report import NO_PICTURES_TEXT
from lispac.messages import error, note
from lispac.project import Project
from tests.documents.schemas import followed_output
from tests.support.command_errors import codes_of, command_error, refused_with
from tests.support.long_runs import others_long


@pytest.fixture(scope="module")
def raw(demo_project: Project) -> Path:
    """Raw files of the built-in survey."""
    return demo_project.folder / "raw"


def run(capsys: pytest.CaptureFixture[str], *words: object) -> tuple[int, str, str]:
    try:
        code = main([str(word) for word in words])
    except SystemExit as stop:
        code = int(stop.code or 0)
    out, err = capsys.readouterr()
    return code, out, err


def import_workflow() -> None:
    """Import the modules that commands import at run time, before a test replaces a function.

    A module that is imported while a function is replaced keeps the replacement.
    """
    for package in (workflow, scripting):
        for each in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            import_module(each.name)


def run_json(capsys: pytest.CaptureFixture[str], *words: object) -> dict[str, Any]:
    """Run a command with ``--json``; what it prints must follow the published schema."""
    code, out, err = run(capsys, *words, "--json")
    assert code == 0, err
    return followed_output(str(words[0]), out)  # type: ignore[no-any-return]


def run_refused(capsys: pytest.CaptureFixture[str], *words: object) -> str:
    """Run a command that must be refused: exit 1, one line, nothing on stdout."""
    code, out, err = run(capsys, *words)
    assert code == 1, (code, out, err)
    assert out == ""
    line, nothing = err.split("\n")
    assert nothing == ""
    assert line.startswith("lispac: ")
    return line


def new_words(project: Path, raw: Path, *lines: Path) -> list[object]:
    return [
        "new", project, "--trajectory", raw / "trajectory.sbet",
        "--trajectory-accuracy", raw / "smrmsg.out",
        "--lever-arm", -0.242, 0.061, 2.173, "--origin", 45.5189, -73.5390, -25.6,
        "--lidar-sigma", 0.0017, *(lines or sorted(raw.glob("*.laz"))),
    ]  # fmt: skip


def test_all_commands_from_raw_files_to_the_report(
    capsys: pytest.CaptureFixture[str], raw: Path, tmp_path: Path
) -> None:
    project = tmp_path / "quay"
    made = run_json(capsys, *new_words(project, raw, *sorted(raw.glob("*.laz"))[:4]))
    assert len(made["points"]) == 4
    seeds = {
        "T1": (1.15, -14.7, 8.1, "target"),
        "T2": (-1.1, -14.38, 7.7, "target"),
    }
    for name, (x, y, z, role) in seeds.items():
        picked = run_json(
            capsys, "pick", project, "--seed", x, y, z, "--name", name, "--role", role
        )
        assert len(picked["lines"]) == 4, picked["missing"]
    numbers = run_json(capsys, "estimate", project, "--pos-errors", "correlated")
    expected = {
        "boresight_deg", "sigma_deg", "correlation", "variance_factor", "chi_square", "iterations",
        "points", "sightings", "targets", "elapsed_s",
    }  # fmt: skip
    assert expected <= set(numbers)
    truth = {"roll": 0.27, "pitch": -1.14, "yaw": 0.36}
    for angle, value in truth.items():
        error = abs(numbers["boresight_deg"][angle] - value)
        assert error < 3 * numbers["sigma_deg"][angle], (angle, numbers)
    assert len(numbers["sightings"]) == 8
    assert len(numbers["targets"]) == 2
    assert set(numbers["chi_square"]) == {
        "statistic", "lower", "upper", "passed", "text", "outcome", "lidar_noise_ratio",
        "has_assumed_sigmas",
    }  # fmt: skip
    assert len(numbers["cross_checks"]["parts"]) > 2
    thesis = run_json(
        capsys, "estimate", project, "--pos-errors", "independent", "--no-cross-checks"
    )
    assert thesis["sigma_deg"]["roll"] < 0.5 * numbers["sigma_deg"]["roll"]
    code, out, _ = run(capsys, "estimate", project, "--subsample", 0.15, "--no-cross-checks")
    assert code == 0
    assert "Boresight" in out
    assert "Pitch" in out

    assert command_error("validate", project).code == "validate.no_planes"
    picked = run_json(
        capsys, "pick", project, "--seed", 29.75, -24.6, 5.0, "--name", "V1",
        "--role", "validation", "--radius", 3,
    )  # fmt: skip
    assert picked["role"] == "validation"
    rows = run_json(capsys, "subsample", project, "--distances", 0.3, 0.2)["adjustments"]
    assert [row["distance_m"] for row in rows] == [0.2, 0.3]
    assert rows[0]["points"] > rows[1]["points"] > 100
    words = ("--distance-to", "quadric", "--neighbours", 20)
    (bent,) = run_json(capsys, "validate", project, *words)["validation"]
    assert bent["model"] == {"kind": "quadric", "neighbours": 20, "radius_m": None}
    assert "at least 3 neighbouring" in run_refused(capsys, "validate", project, "--neighbours", 2)
    planes = run_json(capsys, "validate", project)["validation"]
    assert [plane["name"] for plane in planes] == ["V1"]
    assert planes[0]["model"]["kind"] == "plane"

    refusal = command_error("georeference", project, "--output", tmp_path / "out")
    assert refusal.code == "export.no_system"
    code, out, _ = run(
        capsys, "georeference", project, "--output", tmp_path / "out", "--crs", "EPSG:32619"
    )
    assert code == 0
    assert len(list((tmp_path / "out").glob("*_estimated.laz"))) == 4
    for ending in (".html", ".pdf", ".json"):
        code, _, err = run(capsys, "report", project, "--output", tmp_path / f"report{ending}")
        assert code == 0, err
        assert (tmp_path / f"report{ending}").stat().st_size > 1000
        assert (NO_PICTURES_TEXT in err) == (ending != ".json")
    french = tmp_path / "rapport.html"
    assert run(capsys, "report", project, "--output", french, "--language", "fr")[0] == 0
    assert "ÉTALONNÉ" in french.read_text(encoding="utf-8")


def test_demo_prints_the_result_the_truth_and_the_report(
    printed_demo: tuple[Path, int, str, str],
) -> None:
    folder, code, out, err = printed_demo
    assert code == 0, err
    assert laspy.read(folder / "raw" / "L1_000.laz").header.point_count > 10_000
    for word in ("Boresight", "sigma", "True value", "V5", str(folder / "report.pdf")):
        assert word in out
    assert (folder / "report.pdf").exists()


def test_prototype_plane_files(capsys: pytest.CaptureFixture[str], shared_data: Path) -> None:
    folder = shared_data / "prototype"
    expected = json.loads((folder / "expected.json").read_text())["c"]
    numbers = run_json(
        capsys, "estimate", "--planes", folder / "c/plane1.txt", folder / "c/plane2.txt",
        "--lever-arm", *expected["lever_arm_m"], "--boresight", 0, 45, 0, "--lidar-sigma", 0.0031,
        "--pos-errors", "independent", "--subsample", 0,
    )  # fmt: skip
    boresight, sigma = numbers["boresight_deg"].values(), numbers["sigma_deg"].values()
    np.testing.assert_allclose(list(boresight), expected["boresight_deg"], rtol=0, atol=1e-6)
    np.testing.assert_allclose(list(sigma), expected["sigma_deg"], rtol=0, atol=1e-6)
    assert numbers["points"] == 600


def test_one_plane_file_is_refused_unless_accepted(
    capsys: pytest.CaptureFixture[str], shared_data: Path
) -> None:
    plane = shared_data / "prototype/a/plane2.txt"
    words = ("estimate", "--planes", plane, "--lever-arm", 0, 0, 0)
    assert "--accept-single-orientation" in run_refused(capsys, *words)
    assert "adjustment.only_plane" in codes_of(command_error(*words))
    numbers = run_json(capsys, *words, "--accept-single-orientation", "--no-cross-checks")
    assert numbers["observability"]["messages"][-1]["code"] == "adjustment.one_target"


@pytest.mark.parametrize(
    "command",
    ["", "demo", "new", "pick", "estimate", "validate", "georeference", "report"],
)
def test_help(capsys: pytest.CaptureFixture[str], command: str) -> None:
    code, out, _ = run(capsys, *([command] if command else []), "--help")
    assert code == 0
    assert "usage: lispac" in out


@pytest.mark.parametrize(
    "words",
    [
        [],
        ["nonsense"],
        ["pick", "p", "--name", "T1"],
        ["pick", "p", "--name", "T1", "--seed", "1", "2"],
        ["pick", "p", "--name", "T1", "--seed", "1", "2", "nan"],
        ["pick", "p", "--name", "T1", "--seed", "1", "2", "3", "--threshold", "-1"],
        ["estimate"],
        ["estimate", "--planes", "a.txt"],
        ["estimate", "p", "--planes", "a.txt", "--lever-arm", "0", "0", "0"],
        ["estimate", "p", "--lever-arm", "0", "0", "0"],
        ["estimate", "p", "--subsample", "-0.1"],
        ["estimate", "p", "--pos-errors", "none"],
    ],
)
def test_wrong_usage(capsys: pytest.CaptureFixture[str], words: list[str]) -> None:
    code, out, err = run(capsys, *words)
    assert code == 2
    assert out == ""
    assert err


def test_numbers_with_an_exponent_are_accepted(capsys: pytest.CaptureFixture[str]) -> None:
    missing = command_error(
        "estimate", "--planes", "none.txt", "--lever-arm", "-1e-3", "-.5E-2", "1e-3"
    )
    assert missing.message == error("file.not_found", file="none.txt", kind=note("file.kind_plane"))


def test_a_plane_file_given_twice_is_wrong_usage(capsys: pytest.CaptureFixture[str]) -> None:
    code, _, err = run(capsys, "estimate", "--planes", "a", "./a", "--lever-arm", 0, 0, 0)
    assert code == 2
    assert "given twice" in err


def test_a_folder_without_a_project_is_refused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    for command in ("estimate", "validate"):
        assert command_error(command, tmp_path / "none").code == "project.not_found"


def one_line(raw: Path) -> Path:
    return sorted(raw.glob("*.laz"))[0]


def damaged(kind: str, raw: Path, folder: Path) -> tuple[Path, Path]:
    """A copy of the raw files with one of them damaged: the copy, and the line to use."""
    shutil.copytree(raw, folder, ignore=lambda _, names: [n for n in names if n.startswith("L2")])
    trajectory, line = folder / "trajectory.sbet", one_line(folder)
    if kind == "truncated trajectory":
        trajectory.write_bytes(trajectory.read_bytes()[:-40])
    elif kind == "empty trajectory":
        trajectory.write_bytes(b"")
    elif kind == "nan in trajectory":
        records = np.fromfile(trajectory).reshape(-1, 17)
        records[7, 3] = np.nan
        records.tofile(trajectory)
    elif kind == "no gps_time":
        las = laspy.read(line)
        plain = laspy.LasData(laspy.LasHeader(point_format=0, version="1.2"))
        plain.x, plain.y, plain.z = las.x[:100], las.y[:100], las.z[:100]
        line = folder / "plain.las"
        plain.write(line)
    elif kind == "outside the trajectory":
        las = laspy.read(line)
        las.gps_time = np.asarray(las.gps_time) + 1e5
        las.write(line)
    elif kind == "empty line":
        empty = laspy.LasData(laspy.LasHeader(point_format=6, version="1.4"))
        line = folder / "empty.las"
        empty.write(line)
    elif kind == "missing column":
        line = folder / "line.txt"
        line.write_text("1 2 3\n")
    return folder, line


@pytest.mark.parametrize(
    ("kind", "code"),
    others_long(
        [
            ("truncated trajectory", "file.partial_record"),
            ("empty trajectory", "file.empty"),
            ("nan in trajectory", "file.record_not_finite"),
            ("no gps_time", "las.no_gps_time"),
            ("outside the trajectory", "import.after_trajectory"),
            ("empty line", "file.no_points"),
            ("missing column", "text.no_number_rows"),
        ]
    ),
)
def test_bad_input_is_refused_and_no_project_is_left(
    capsys: pytest.CaptureFixture[str], raw: Path, tmp_path: Path, kind: str, code: str
) -> None:
    folder, line = damaged(kind, raw, tmp_path / "raw")
    words = new_words(tmp_path / "project", folder, line)
    failure = command_error(*words)
    assert code in codes_of(failure)
    assert str(failure) in run_refused(capsys, *words)
    assert not (tmp_path / "project").exists()


def test_text_line_with_named_columns(
    capsys: pytest.CaptureFixture[str], raw: Path, tmp_path: Path
) -> None:
    las = laspy.read(one_line(raw))
    rows = np.column_stack([las.gps_time, las.x, las.y, las.z])[:5000]
    np.savetxt(tmp_path / "line.csv", rows, delimiter=",", fmt="%.7f")
    words = new_words(tmp_path / "project", raw, tmp_path / "line.csv")
    assert run_json(capsys, *words, "--columns", "time,x,y,z")["points"] == {"line": 5000}
    other = new_words(tmp_path / "other", raw, tmp_path / "line.csv")
    refused_with("text.columns_missing", *other, "--columns", "time,x,y", missing=("z",))


def test_a_refused_pick_does_not_change_the_project(
    capsys: pytest.CaptureFixture[str], raw: Path, tmp_path: Path
) -> None:
    project = tmp_path / "project"
    run_json(capsys, *new_words(project, raw, one_line(raw)))
    before = (project / "project.json").read_bytes()
    run_refused(capsys, "pick", project, "--seed", 900, 900, 900, "--name", "T1")
    run_refused(capsys, "pick", project, "--seed", 1, 1, 1, "--name", "T1", "--line", "L77")
    assert (project / "project.json").read_bytes() == before
    # With one line the target is found, but there is nothing to compare it with.
    run_json(capsys, "pick", project, "--seed", 1.15, -14.7, 8.1, "--name", "T1")
    picked = (project / "project.json").read_bytes()
    assert "estimate.one_line" in codes_of(command_error("estimate", project))
    assert (project / "project.json").read_bytes() == picked
