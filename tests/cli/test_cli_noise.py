"""Tests of the options for LiDAR noise and prior offsets, of projects and of plane files."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.project import Project
from lispac.workflow.project import projects
from tests.cli.test_cli import new_words, run, run_json
from tests.support.long_runs import LONG

SEEDS = {"T1": (1.15, -14.7, 8.1), "T2": (-1.1, -14.38, 7.7)}
WITHOUT_DIAGNOSTICS = ("--no-cross-checks", "--surface", 0.0, "--loss", "none")


@pytest.fixture(scope="module")
def raw(denser_project: Project) -> Path:
    return denser_project.folder / "raw"


def picked(
    capsys: pytest.CaptureFixture[str], raw: Path, folder: Path, *words: object, lines: int = 6
) -> Path:
    """Folder of a new project with the first lines of the survey and two picked targets."""
    paths = sorted(raw.glob("*.laz"))[:lines]
    assert len(paths) == lines
    made = [word for word in new_words(folder, raw, *paths)
            if word not in ("--lidar-sigma", 0.0017)]  # fmt: skip
    run_json(capsys, *made, *words)
    seeds = folder.with_name("seeds.txt")
    seeds.write_text("".join(f"{name} {x} {y} {z}\n" for name, (x, y, z) in SEEDS.items()))
    run_json(capsys, "pick", folder, "--seeds", seeds, "--role", "target")
    return folder


def angles(numbers: dict[str, Any], what: str = "boresight_deg") -> np.ndarray:
    return np.array(list(numbers[what].values()))


@LONG
def test_noise_and_offsets_of_a_project(
    capsys: pytest.CaptureFixture[str], raw: Path, tmp_path: Path
) -> None:
    project = picked(capsys, raw, tmp_path / "quay", "--lidar-sigma-xyz", 0.003, 0.004, 0.005,
                     "--longest-gap", 2.5, lines=4)  # fmt: skip
    sensor_settings = projects.open_project(project).settings
    assert sensor_settings.lidar_sigma_xyz == (0.003, 0.004, 0.005)
    assert sensor_settings.longest_gap == 2.5

    def estimated(*words: object) -> dict[str, Any]:
        return run_json(capsys, "estimate", project, *WITHOUT_DIAGNOSTICS, *words)

    axis = estimated("--lidar-sigma", 0.004)
    settings = projects.open_project(project).settings
    assert (settings.lidar_sigma, settings.lidar_sigma_xyz) == (0.004, None)
    equal_axes = estimated("--lidar-sigma-xyz", 0.004, 0.004, 0.004)
    np.testing.assert_allclose(angles(equal_axes), angles(axis), rtol=0, atol=1e-9)
    # Pitch is determined by the ranges, whose given sigma is now fifteen times larger.
    beam = estimated("--lidar-beam-sigma", 0.06, 0.02)
    settings = projects.open_project(project).settings
    assert (settings.lidar_sigma_xyz, settings.lidar_beam_sigma) == (None, (0.06, 0.02))
    assert beam["sigma_deg"]["pitch"] > 3 * axis["sigma_deg"]["pitch"]

    # A rotation of the beams about the x axis of the scanner is a roll; the boresight absorbs it.
    turned = estimated("--lidar-sigma", 0.004, "--scan-angle-offset", 0.3)
    assert projects.open_project(project).settings.lidar_beam_sigma is None
    assert turned["boresight_deg"]["roll"] == pytest.approx(
        axis["boresight_deg"]["roll"] - 0.3, abs=0.01
    )
    longer = estimated("--scan-angle-offset", 0, "--range-offset", 0.05, "--latency", -0.02)
    settings = projects.open_project(project).settings
    assert (settings.range_offset, settings.latency) == (0.05, -0.02)
    assert settings.scan_angle_offset_deg == 0
    assert np.abs(angles(longer) - angles(axis)).max() > 0.01
    # If the latency is estimated too, its wrong prior is detected.
    found = estimated("--estimate", "latency")["parameters"][0]
    assert found["prior"] == -0.02
    assert abs(found["value"]) < 4 * found["sigma"] < 0.02
    assert found["significant"]


def test_noise_and_offsets_of_plane_files(
    capsys: pytest.CaptureFixture[str], shared_data: Path
) -> None:
    folder = shared_data / "prototype/c"
    words = ("estimate", "--planes", folder / "plane1.txt", folder / "plane2.txt",
             "--lever-arm", 0, 0, 0, "--boresight", 0, 45, 0, "--pos-errors", "independent",
             "--no-cross-checks")  # fmt: skip
    axis = run_json(capsys, *words, "--lidar-sigma", 0.0031)
    equal_axes = run_json(capsys, *words, "--lidar-sigma-xyz", 0.0031, 0.0031, 0.0031)
    np.testing.assert_array_equal(angles(equal_axes), angles(axis))
    beam = run_json(capsys, *words, "--lidar-beam-sigma", 0.0031, 0.2)
    assert (angles(beam, "sigma_deg") > angles(axis, "sigma_deg")).all()
    longer = run_json(capsys, *words, "--lidar-sigma", 0.0031, "--range-offset", 0.05)
    assert np.abs(angles(longer) - angles(axis)).max() > 0.001
    code, out, err = run(capsys, *words, "--latency", 0.01)
    assert (code, out) == (2, "")
    assert "--latency requires a project" in err


@pytest.mark.parametrize(
    "words",
    [
        ("--lidar-sigma", 0.01, "--lidar-beam-sigma", 0.01, 0.1),
        ("--lidar-beam-sigma", 0.01),
        ("--lidar-sigma-xyz", 0.01, 0.01, 0),
        ("--lidar-beam-sigma", 0.01, math.nan),
        ("--latency", "soon"),
    ],
)
def test_invalid_noise_options_are_refused(capsys: pytest.CaptureFixture[str], words: Any) -> None:
    code, out, err = run(capsys, "estimate", "p", *words)
    assert (code, out) == (2, "")
    assert err


@LONG
def test_assumed_noise_is_estimated_unless_refused(
    capsys: pytest.CaptureFixture[str], raw: Path, tmp_path: Path
) -> None:
    """The noise of the survey is about 1.7 mm on each axis, that assumed is 5 mm."""
    project = picked(capsys, raw, tmp_path / "quay", "--beam-divergence", 0.5,
                     "--lever-arm-sigma", 0.004, 0.005, 0.006)  # fmt: skip
    settings = projects.open_project(project).settings
    assert settings.assumed_sigmas == ("LiDAR", "POS position", "POS attitude")
    assert (settings.lidar_sigma, settings.variance_components) == (None, None)
    assert settings.lever_arm_sigma == (0.004, 0.005, 0.006)

    automatic = run_json(capsys, "estimate", project, "--no-cross-checks")
    lidar, position, attitude = automatic["standard_deviations"]
    assert (lidar["source"], lidar["source_before"]) == ("estimated", "assumed")
    assert lidar["before"] == [0.005]
    assert lidar["used"][0] == pytest.approx(0.0017, abs=0.0003)
    assert position["source"] == attitude["source"] == "file"
    assert position["used"] is None
    (component,) = automatic["components"]
    assert component["name"] == "LiDAR"
    assert 0.8 < component["lower"] / component["factor"] < 1.0
    assert 1.0 < component["upper"] / component["factor"] < 1.25
    words = ("estimate", project, "--no-cross-checks", "--lidar-sigma", lidar["used"][0])
    taken = run_json(capsys, *words, "--lidar-noise-source", "residuals")
    assert taken["standard_deviations"][0]["source"] == "estimated"
    assert taken["chi_square"]["outcome"] != "passed"
    assert projects.open_project(project).settings.is_lidar_noise_from_residuals
    given = run_json(capsys, *words)
    assert given["standard_deviations"][0]["source"] == "given"
    assert given["chi_square"]["statistic"] == pytest.approx(taken["chi_square"]["statistic"])
    assert given["chi_square"]["outcome"] == (
        "passed" if taken["chi_square"]["outcome"] == "not judged" else "conservative"
    )
    assumed = projects.open_project(project)
    projects.save_project(assumed.with_settings(settings))

    none = run_json(capsys, "estimate", project, "--no-cross-checks", "--no-components")
    assert none["components"] == []
    assert none["standard_deviations"][0]["source"] == "assumed"
    assert "adjustment.assumed_sigmas" in {each["code"] for each in none["warnings"]}
    assert projects.open_project(project).settings.variance_components is False
    code, out, _ = run(capsys, "estimate", project, "--no-cross-checks", "--auto-components")
    assert code == 0
    assert "assumed before: 5.0 mm on each axis" in " ".join(out.split())
    again = projects.open_project(project)
    assert again.settings.variance_components is None
    assert again.result is not None
    assert np.degrees(again.result.boresight) == pytest.approx(angles(automatic), abs=1e-12)

    budget = run_json(capsys, "budget", project, "--distance", 50)
    footprint, lever = (
        next(s for s in budget["beams"][0]["sources"] if s["source"] == name)["at_distance"][0]
        for name in ("Beam footprint", "Lever arm")
    )
    assert footprint["across_beam_m"] == pytest.approx(np.sqrt(2) * 0.0005 * 50 / 4)
    assert footprint["total_m"] == pytest.approx(np.sqrt(3) * 0.0005 * 50 / 4)  # tan(45 deg) = 1
    assert lever["total_m"] == pytest.approx(np.sqrt(0.004**2 + 0.005**2 + 0.006**2))
    flat = run_json(capsys, "budget", project, "--distance", 50, "--incidence", 0)
    (found,) = (s for s in flat["beams"][0]["sources"] if s["source"] == "Beam footprint")
    assert found["at_distance"][0]["total_m"] == pytest.approx(footprint["across_beam_m"])


def test_the_scanner_of_an_estimate_is_named_in_the_report(
    capsys: pytest.CaptureFixture[str], raw: Path, tmp_path: Path
) -> None:
    project = picked(capsys, raw, tmp_path / "quay", lines=4)
    assert projects.open_project(project).identity.scanner == ""
    words = ("estimate", project, *WITHOUT_DIAGNOSTICS, "--scanner", "zf-9012")
    run_json(capsys, *words)
    known = projects.open_project(project)
    assert known.identity.scanner == "Z+F PROFILER 9012"
    assert known.settings.lidar_beam_sigma == (0.0087, 0.02)
    run_json(capsys, "identity", project, "--scanner", "PROFILER 9012, second head")
    run_json(capsys, *words)  # a typed name is kept
    assert projects.open_project(project).identity.scanner == "PROFILER 9012, second head"
