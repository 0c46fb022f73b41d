"""Whether the sigmas of the scene's answer hold, on many simulated surveys.

They are of one quay, each with noise and POS errors of its own.
"""

from pathlib import Path
from shutil import rmtree

import numpy as np
import pytest

from lispac.project import Project, Settings
from lispac.simulation.simulated_survey import port_survey
from lispac.survey.georeferencing import Mounting
from lispac.workflow.calibration.targetless import targetless
from lispac.workflow.planning.simulate import RAW_FOLDER, as_triple, write_lines, write_trajectory
from lispac.workflow.project.projects import create_project
from lispac.workflow.project.survey import Survey, load_survey

NOISE = 0.0019
"""Metres: of the simulated scanner."""
SCENES = 200


def surveyed(folder: Path, seed: int) -> tuple[Project, Survey, Mounting]:
    """A quay, and the mounting that it was surveyed with."""
    made = port_survey(points_per_second=20_000.0, seed=seed)
    trajectory, accuracy = write_trajectory(made, folder / RAW_FOLDER)
    latitude, longitude, height = made.origin
    project = create_project(
        folder, trajectory=trajectory, lines=write_lines(made, folder / RAW_FOLDER),
        accuracy=accuracy,
        settings=Settings(
            lever_arm=as_triple(made.lever_arm), lidar_sigma=NOISE,
            origin_deg_m=(float(np.degrees(latitude)), float(np.degrees(longitude)), height),
        ),
    )  # fmt: skip
    truth = project.mounting("prior").with_boresight(np.asarray(made.boresight))
    return project, load_survey(project), truth


def significance(folder: Path, seed: int) -> np.ndarray:
    """Errors of roll, pitch, yaw over their sigmas."""
    *opened, truth = surveyed(folder, seed)
    found = targetless(*opened, count=16).result
    return (found.boresight - truth.boresight) / found.sigma


@pytest.mark.long
@pytest.mark.timeout(7200)
def test_intervals_hold_what_they_say(tmp_path: Path) -> None:
    """In short `test_targetless` asks the same of one survey."""
    found = []
    for seed in range(1, 1 + SCENES):
        folder = tmp_path / str(seed)
        folder.mkdir()
        found.append(significance(folder, seed))
        print(seed, np.round(found[-1], 2), flush=True)
        rmtree(folder)
    off = np.array(found)
    held = (np.abs(off) < 1.96).mean(axis=0)
    rms = np.sqrt((off**2).mean(axis=0))
    print(f"\n{SCENES} scenes: 95 % intervals hold {np.round(held, 3)}, rms {np.round(rms, 2)}")
    assert ((held >= 0.90) & (held <= 0.98)).all(), held
