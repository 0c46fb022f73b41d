"""Test of the sigmas from natural surfaces, on many simulated surveys.

All are of the same quay, each with its own noise and POS errors.
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
"""Range noise of the simulated scanner, metres."""
SCENES = 200


def surveyed(folder: Path, seed: int) -> tuple[Project, Survey, Mounting]:
    """Simulate a survey of the quay; return it with its true mounting."""
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
    """Return the errors of roll, pitch and yaw divided by their sigmas."""
    *opened, truth = surveyed(folder, seed)
    found = targetless(*opened, count=16).result
    return (found.boresight - truth.boresight) / found.sigma


@pytest.mark.long
@pytest.mark.timeout(7200)
def test_confidence_intervals_have_their_nominal_coverage(tmp_path: Path) -> None:
    """`test_targetless` does the same quickly with a single survey."""
    found = []
    for seed in range(1, 1 + SCENES):
        folder = tmp_path / str(seed)
        folder.mkdir()
        found.append(significance(folder, seed))
        print(seed, np.round(found[-1], 2), flush=True)
        rmtree(folder)
    off = np.array(found)
    coverage = (np.abs(off) < 1.96).mean(axis=0)
    rms = np.sqrt((off**2).mean(axis=0))
    print(f"\n{SCENES} scenes: 95 % intervals hold {np.round(coverage, 3)}, rms {np.round(rms, 2)}")
    assert ((coverage >= 0.90) & (coverage <= 0.98)).all(), coverage
