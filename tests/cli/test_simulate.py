"""Tests of ``lispac simulate``: usable survey files, and the truth beside them."""

import errno
import json
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.result import ANGLES
from lispac.cli.main import main
from lispac.geometry.frames import LocalFrame
from lispac.installation_paths import resource_path
from lispac.io.las.las_format import read_scan
from lispac.io.trajectory.sbet import read_sbet, read_smrmsg
from lispac.survey.georeferencing import Mounting, georeference
from lispac.survey.trajectory import LocalTrajectory, Trajectory
from lispac.workflow.planning.simulated_setup import read_simulation
from lispac.workflow.project.projects import open_project
from tests.support.command_errors import command_error
from tests.support.long_runs import LONG
from tests.support.message_codes import is_shown

BORESIGHT_DEG = (0.8, -0.5, 1.1)


def run(capsys: pytest.CaptureFixture[str], *words: object) -> tuple[int, str, str]:
    try:
        code = main([str(word) for word in words])
    except SystemExit as stop:
        code = int(stop.code or 0)
    out, err = capsys.readouterr()
    return code, out, err


def done(capsys: pytest.CaptureFixture[str], *words: object) -> str:
    code, out, err = run(capsys, *words)
    assert code == 0, err
    return out


def run_refused(capsys: pytest.CaptureFixture[str], *words: object) -> str:
    code, _, err = run(capsys, *words)
    assert code == 1
    assert err.count("\n") == 1
    return err


def truth_of(folder: Path) -> dict:
    return json.loads((folder / "truth" / "truth.json").read_text())


def true_mounting(folder: Path) -> Mounting:
    found = truth_of(folder)["mounting"]
    return Mounting(
        np.array(found["lever_arm_m"]), np.radians(found["boresight_deg"]),
        found["range_offset_m"], np.radians(found["scan_angle_offset_deg"]), found["latency_s"],
    )  # fmt: skip


@pytest.mark.long
def test_boresight_of_a_simulation_is_estimated(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "marine"
    shown = json.loads(done(
        capsys, "simulate", "marine", "--output", folder, "--seed", 7,
        "--points-per-second", 60_000, "--boresight", *BORESIGHT_DEG, "--json",
    ))  # fmt: skip
    assert len(shown["points"]) == 6
    assert min(shown["points"].values()) > 20_000
    assert "4 of 4 seeds" in done(capsys, "pick", folder, "--seeds", shown["seeds"])
    done(capsys, "estimate", folder)
    project = open_project(folder)
    assert project.result is not None
    assert project.truth_deg == pytest.approx(BORESIGHT_DEG)
    error = project.result.mounting.boresight - np.radians(BORESIGHT_DEG)
    for name, off, sigma in zip(ANGLES, error, project.result.sigma, strict=True):
        assert abs(off) < 3 * sigma, name
    assert np.degrees(project.result.sigma).max() < 0.05
    assert {target.role for target in project.targets} == {"target", "validation"}


def test_true_mounting_reproduces_the_surfaces_with_all_errors(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """With data from the files alone, every labelled point is on its surface."""
    folder = tmp_path / "exact"
    done(
        capsys, "simulate", "marine", "--output", folder, "--points-per-second", 20_000,
        "--no-noise", "--no-pos-errors", "--boresight", *BORESIGHT_DEG,
        "--lever-arm-error", 0.1, -0.2, 0.3,
        "--range-offset", -0.05, "--scan-angle-offset", 0.4, "--latency", 0.02,
    )  # fmt: skip
    mounting, project = true_mounting(folder), open_project(folder)
    written_down = np.array(read_simulation("marine").lever_arm)
    np.testing.assert_allclose(project.settings.lever_arm, written_down)
    np.testing.assert_allclose(mounting.lever_arm - written_down, [0.1, -0.2, 0.3])
    assert (mounting.range_offset, mounting.latency) == (-0.05, 0.02)
    assert np.degrees(mounting.scan_angle_offset) == pytest.approx(0.4)
    setup = read_simulation("marine").setup
    trajectory = LocalTrajectory.of(read_sbet(project.trajectory), LocalFrame(*setup.origin))
    labels = np.load(folder / "truth" / "labels.npz")
    assert tuple(labels["surfaces"]) == setup.scene.names
    prior = project.mounting("prior")
    for line in project.lines:
        scan, label = read_scan(line.path), labels[line.name]
        assert len(scan) == len(label)
        right, wrong = (
            georeference(scan.points_lidar, scan.time, trajectory, each)
            for each in (mounting, prior)
        )
        for k in np.unique(label):
            own = label == k
            off = setup.scene.surfaces[k].distance(right[own])
            assert np.abs(off).max() < 1.5e-4, "coordinates are stored to 0.1 mm"
        assert np.linalg.norm(right - wrong, axis=1).min() > 0.1
    for row in (folder / "targets.csv").read_text().splitlines()[1:]:
        name, *place, role = row.split(",")
        assert role == ("validation" if name[0] == "V" else "target")
        assert abs(setup.scene[name].distance(np.array([place], float))[0]) < 1e-4


BALL_SURFACE = """
[[surfaces]]
kind = "sphere"
name = "B{k}"
role = "target"
centre_m = [{north}, -12.5, {up}]
radius_m = 0.25
reflectance = 0.85
"""


@pytest.mark.long
def test_balls_of_a_scene_are_used_in_the_adjustment(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene, folder = tmp_path / "balls.toml", tmp_path / "balls"
    text = (resource_path("scenes") / "marine.toml").read_text()
    for k, (north, up) in enumerate(((-2.5, 6.0), (3.0, 7.5), (0.2, 10.5))):
        text += BALL_SURFACE.format(k=k + 1, north=north, up=up)
    scene.write_text(text)
    shown = json.loads(done(
        capsys, "simulate", scene, "--output", folder, "--points-per-second", 60_000, "--json"
    ))  # fmt: skip
    done(capsys, "pick", folder, "--seeds", shown["seeds"])
    done(
        capsys, "pick", folder, "--seeds", shown["ball_seeds"], "--shape", "sphere",
        "--sphere-radius", 0.25,
    )  # fmt: skip
    done(capsys, "estimate", folder)
    project = open_project(folder)
    assert project.result is not None
    assert sum(target.sphere for target in project.result.targets) == 3
    error = np.degrees(project.result.mounting.boresight) - project.truth_deg
    assert (np.abs(error) < 3 * np.degrees(project.result.sigma)).all()


def test_balls_of_a_scene_have_their_own_list_of_seeds(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene, folder = tmp_path / "balls.toml", tmp_path / "balls"
    text = (resource_path("scenes") / "marine.toml").read_text()
    scene.write_text(text + BALL_SURFACE.format(k=1, north=-2.5, up=6.0))
    rows = done(
        capsys, "simulate", scene, "--output", folder, "--points-per-second", 2_000
    ).splitlines()  # fmt: skip
    seeds, balls = folder / "targets.csv", folder / "balls.csv"
    assert rows[-2] == f"seeds      {seeds} (for lispac pick --seeds)"
    assert rows[-1] == f"spheres    {balls} (for lispac pick --shape sphere --seeds)"
    assert "B1" not in seeds.read_text()
    name, *place, _ = balls.read_text().splitlines()[1].split(",")
    assert name == "B1"
    assert [float(value) for value in place] == pytest.approx([-2.5, -12.5, 6.0], abs=0.26)


REPLAY_SCENE = """
title = "A wall beside a recorded trajectory"
vessel = "launch"
scanner = "{scanner}"
trajectory = "true.sbet"
[origin]
latitude_deg = 46.8
longitude_deg = -71.2
height_m = -27.0
[[lines]]
start_s = {start}
stop_s = {stop}
side = "starboard"
[[surfaces]]
kind = "board"
name = "wall"
centre_m = [0, -15, 6]
width_m = 30
height_m = 12
facing_deg = 270
"""


def recorded(folder: Path, capsys: pytest.CaptureFixture[str]) -> tuple[Trajectory, float]:
    """Simulate a trajectory to be replayed; return it and the start time of its first line."""
    done(
        capsys, "simulate", "marine", "--output", folder / "first", "--points-per-second", 5_000,
        "--no-pos-errors",
    )  # fmt: skip
    project = open_project(folder / "first")
    (folder / "true.sbet").write_bytes(project.trajectory.read_bytes())
    return read_sbet(project.trajectory), float(read_scan(project.lines[0].path).time[0])


@LONG
def test_a_recorded_trajectory_is_replayed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    states, start = recorded(tmp_path, capsys)
    text = REPLAY_SCENE.format(scanner="velodyne-hdl-32e", start=start, stop=start + 4.0)
    (tmp_path / "wall.toml").write_text(text)
    folder = tmp_path / "replayed"
    options = ("--points-per-second", 20_000, "--output", folder)
    done(capsys, "simulate", tmp_path / "wall.toml", *options, "--no-pos-errors", "--no-noise")
    project = open_project(folder)
    again = read_sbet(project.trajectory)
    np.testing.assert_array_equal(again.time, states.time)
    np.testing.assert_allclose(again.height, states.height, atol=2e-9)
    np.testing.assert_allclose(again.attitude, states.attitude, atol=1e-11)
    setup = read_simulation(str(tmp_path / "wall.toml")).setup
    trajectory = LocalTrajectory.of(again, setup.motion_source.trajectory.frame)
    (line,) = project.lines
    assert line.name == "L1_000"
    scan = read_scan(line.path)
    assert start <= scan.first_time < scan.last_time < start + 4.0
    points = georeference(scan.points_lidar, scan.time, trajectory, true_mounting(folder))
    assert len(points) > 1000
    assert np.abs(setup.scene["wall"].distance(points)).max() < 1.5e-4
    done(capsys, "simulate", tmp_path / "wall.toml", *options)
    erring = read_sbet(project.trajectory)
    off = np.abs(erring.height - states.height)
    assert 0.001 < off.max() < 0.2
    sigma = read_smrmsg(project.accuracy)
    np.testing.assert_allclose(sigma.position, np.tile([0.012, 0.012, 0.020], (len(sigma.time), 1)))


def test_unsuitable_trajectories_are_not_replayed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    _, start = recorded(tmp_path, capsys)
    scene = tmp_path / "wall.toml"
    for text, reason in (
        (REPLAY_SCENE.format(scanner="profiler", start=10, stop=20), "Correct start_s and stop_s"),
        (
            REPLAY_SCENE.format(scanner="profiler", start=start, stop=start + 1).replace(
                "46.8", "40"
            ),
            "km from",
        ),
        (
            REPLAY_SCENE.format(scanner="profiler", start=start, stop=start + 1).replace(
                "true", "no"
            ),
            "does not exist",
        ),
    ):
        scene.write_text(text)
        assert reason in run_refused(capsys, "simulate", scene, "--output", tmp_path / "no")
        assert not (tmp_path / "no").exists()
    refusal = command_error(
        "simulate", "marine", "--trajectory", tmp_path / "true.sbet", "--output", tmp_path / "no"
    )
    assert refusal.code == "simulate.lines_by_heading"


def test_wrong_options_of_simulate_are_reported(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    refusal = command_error("simulate", "prot", "--output", tmp_path / "a")
    assert refusal.code == "simulate.no_scene"
    assert refusal.message is not None
    assert refusal.message.params["known"] == ("marine", "port", "terrestrial")
    refusal = command_error("simulate", "port", "--vessel", "barge", "--output", tmp_path / "a")
    assert refusal.code == "simulate.no_vessel"
    for option, value, reason in (
        ("--latency", 100, "latency of 100 s is larger than 10.0 s"),
        ("--range-offset", -50, "range offset of 50.0 m is larger than 10.0 m"),
        ("--scan-angle-offset", 400, "scan-angle offset of 400° is larger than 180°"),
    ):  # fmt: skip
        printed = run_refused(capsys, "simulate", "port", option, value, "--output", tmp_path / "a")
        assert reason in printed
    hurried = tmp_path / "hurried.toml"
    hurried.write_text(
        (resource_path("vessels") / "van.toml")
        .read_text()
        .replace("ramp_s = 4", "ramp_s = 1\nwait_s = 1")
    )
    printed = run_refused(
        capsys, "simulate", "marine", "--vessel", hurried, "--latency", -5, "--output",
        tmp_path / "a", "--points-per-second", 5_000,
    )  # fmt: skip
    assert is_shown("simulation.latency", printed)
    full = tmp_path / "full"
    full.mkdir()
    (full / "thesis.doc").write_text("mine")
    refusal = command_error("simulate", "marine", "--output", full)
    assert refusal.code == "simulate.folder_in_use"
    assert [path.name for path in full.iterdir()] == ["thesis.doc"]
    assert run(capsys, "simulate", "--output", tmp_path / "a")[0] == 2
    distant_scene = tmp_path / "blind.toml"
    text = (resource_path("scenes") / "marine.toml").read_text()
    distant_scene.write_text(text.replace("distance_m = 15", "distance_m = 400"))
    refusal = command_error("simulate", distant_scene, "--output", tmp_path / "a")
    assert refusal.code == "simulate.line_without_points"
    assert not (tmp_path / "a").exists()


def test_list_names_scenes_vessels_and_scanners(capsys: pytest.CaptureFixture[str]) -> None:
    shown = done(capsys, "simulate", "--list")
    for name in ("port", "terrestrial", "marine", "launch", "van", "zf-9012", "velodyne-hdl-32e"):
        assert f"  {name} " in shown
    assert set(json.loads(done(capsys, "simulate", "--list", "--json"))) == {
        "schema_version", "scenes", "vessels", "scanners",
    }  # fmt: skip


def test_the_same_seed_gives_the_same_files(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def files(name: str, seed: int) -> dict[str, bytes]:
        done(
            capsys, "simulate", "marine", "--output", tmp_path / name, "--seed", seed,
            "--points-per-second", 5_000,
        )  # fmt: skip
        raw = tmp_path / name / "raw"
        return {path.name: path.read_bytes() for path in raw.iterdir()}

    first = files("a", 3)
    assert files("a", 3) == first, "made anew in the same folder"
    other = files("b", 4)
    assert other.keys() == first.keys()
    assert other["trajectory.sbet"] != first["trajectory.sbet"]


def test_a_failed_simulation_keeps_the_earlier_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    words = ("simulate", "port", "--points-per-second", 2000, "--output")
    done(capsys, *words, tmp_path / "survey")
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("lispac.workflow.planning.simulate.write_smrmsg", full)
    run_refused(capsys, *words, tmp_path / "survey", "--seed", 7)
    run_refused(capsys, *words, tmp_path / "new" / "survey")
    after = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    assert after == before
    assert not (tmp_path / "new").exists()
    monkeypatch.undo()
    killed = tmp_path / "survey" / ".survey-abcdefgh.part"
    killed.mkdir()
    done(capsys, *words, tmp_path / "survey", "--seed", 7)
    assert not killed.exists()


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("position_m = [0.012, 0.012, 0.020]", "position_m = [1e7, 1e7, 1e7]"),
        ("position_m = [0.4, 0.4, 0.2]", "position_m = [1e308, 1, 1]"),
        ("attitude_deg = [0.008, 0.008, 0.012]", "attitude_deg = [1e200, 1, 1]"),
        ("duration_s = 60", "duration_s = 1e308"), ("duration_s = 60", "duration_s = 1e-320"),
        ("position_s = 300", "position_s = 1e308"), ("start_s = 100", "start_s = 1e308"),
    ],
)  # fmt: skip
def test_vessels_with_impossible_pos_errors_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], old: str, new: str
) -> None:
    sound = resource_path("vessels/launch-outage.toml").read_text(encoding="utf-8")
    assert old in sound
    vessel = tmp_path / "vessel.toml"
    vessel.write_text(sound.replace(old, new, 1), encoding="utf-8")
    run_refused(capsys, "simulate", "port", "--vessel", vessel, "--output", tmp_path / "survey")
    assert not (tmp_path / "survey").exists()
