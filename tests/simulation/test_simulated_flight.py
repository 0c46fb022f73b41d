"""Tests of replayed trajectories: a real flight with a spinning scanner, and one with gaps."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.result import ANGLES
from lispac.cli.main import main
from lispac.geometry.frames import LocalFrame
from lispac.installation_paths import resource_path
from lispac.simulation.motion_source import RecordedTrajectory, TrajectoryStretch
from lispac.simulation.pos_error_models import WhiteNoise
from lispac.simulation.scene import tilted_rectangle
from lispac.simulation.simulated_survey import simulate_survey
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.planning.simulated_setup import read_simulation
from lispac.workflow.project.projects import open_project
from tests.simulation.test_meshes import as_mesh, write_mesh

SITE_SCENE = """
title = "Boards under a recorded flight"
vessel = "van"
scanner = "scanner.toml"
trajectory = "{trajectory}"

[[lines]]
start_s = 410579.0
stop_s = 410583.8
side = "port"

[[lines]]
start_s = 410626.6
stop_s = 410634.3
side = "port"

[[surfaces]]
kind = "mesh"
name = "hut"
file = "hut.ply"

[[surfaces]]
kind = "board"
name = "ground"
centre_m = [0, 20, -22]
width_m = 200
height_m = 200
facing_deg = 0
elevation_deg = 90
"""
BOARD_SURFACE = """
[[surfaces]]
kind = "board"
name = "{name}"
role = "target"
centre_m = {centre}
width_m = 4
height_m = 3
facing_deg = {facing}
elevation_deg = {elevation}
"""
BOARDS = (
    ("T1", [2, 22, -18], 90, 45), ("T2", [-3, 18, -19], 270, 40), ("T3", [6, 20, -19], 0, 35),
    ("T4", [-8, 22, -19], 180, 35),
)  # fmt: skip


@pytest.mark.long
def test_a_real_flight_over_boards_and_a_mesh(
    shared_data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two lines of a drone survey with an HDL-32E on its side; the simulated boresight is found."""
    write_mesh(tmp_path / "hut.ply", as_mesh(tilted_rectangle("hut", (-6, 26, -16), 4, 4, 180, 80)))
    spinning = (resource_path("scanners") / "velodyne-hdl-32e.toml").read_text()
    (tmp_path / "scanner.toml").write_text(spinning.replace('axis = "z"', 'axis = "x"'))
    text = SITE_SCENE.format(trajectory=shared_data / "lanl_truck" / "trajectory.sbet")
    for name, centre, facing, elevation in BOARDS:
        text += BOARD_SURFACE.format(name=name, centre=centre, facing=facing, elevation=elevation)
    (tmp_path / "site.toml").write_text(text)
    folder = tmp_path / "flown"
    for words in (
        ("simulate", tmp_path / "site.toml", "--output", folder, "--points-per-second", 200_000),
        ("pick", folder, "--seeds", folder / "targets.csv"),
        ("estimate", folder),
    ):
        assert main([str(word) for word in words]) == 0, capsys.readouterr().err
    project = open_project(folder)
    assert project.result is not None
    truth = json.loads((folder / "truth" / "truth.json").read_text())["mounting"]
    error = project.result.mounting.boresight - np.radians(truth["boresight_deg"])
    for name, off, sigma in zip(ANGLES, error, project.result.sigma, strict=True):
        assert abs(off) < 3 * sigma, name
    assert np.degrees(project.result.sigma).max() < 0.05
    labels = np.load(folder / "truth" / "labels.npz")
    hut = list(labels["surfaces"]).index("hut")
    assert all(np.count_nonzero(labels[line.name] == hut) > 50 for line in project.lines)


def test_errors_on_a_trajectory_with_gaps_and_bursts_have_their_sigmas() -> None:
    """The states are uneven in time: a burst, a gap, and 50 per second."""
    time = np.concatenate(
        [np.arange(0, 60, 0.02), 60 + np.arange(500) * 1e-4, np.arange(100, 160, 0.02)]
    )
    position = np.stack([0.5 * time, np.zeros(len(time)), np.full(len(time), 2.0)], axis=1)
    states = LocalTrajectory(LocalFrame(0.8, -1.2, 0.0), time, position, np.zeros((len(time), 3)))
    noise = WhiteNoise((0.1, 0.2, 0.3), (0.001, 0.002, 0.003))
    stretches = (TrajectoryStretch(1.0, 1.5, True),)
    setup = replace(
        read_simulation("marine").setup,
        motion_source=RecordedTrajectory(states, stretches), pos=noise,
        origin=(0.8, -1.2, 0.0),
    )  # fmt: skip
    found = simulate_survey(setup, seed=4).trajectory
    local = LocalFrame(*setup.origin).to_local(found.latitude, found.longitude, found.height)
    even = (time < 60) | (time >= 100)
    off = (local - position)[even]
    np.testing.assert_allclose(off.std(axis=0), [0.1, 0.2, 0.3], rtol=0.05)
    np.testing.assert_allclose(found.sigma_position, np.tile([0.1, 0.2, 0.3], (len(time), 1)))
    assert np.ptp(found.height[(time >= 60) & (time < 60.0005)]) < 1e-6, "a burst errs as one"
