"""Tests that surveys without errors are imported without warnings, from files and clouds."""

from collections import Counter
from itertools import product
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.io.las.las_crs_writer import OWN_USER_ID
from lispac.messages import Level
from lispac.project import LineSource, Project, Reading
from lispac.workflow.output.georeferencing import georeference_project
from lispac.workflow.planning.simulate import simulate
from lispac.workflow.planning.simulated_setup import read_simulation
from lispac.workflow.project.projects import new_project
from lispac.workflow.project.survey import Survey, load_survey

SURVEYS = list(
    product(
        ("marine", "port", "terrestrial"),
        ("launch", "van"),
        ("profiler", "riegl-vux-1", "zf-9012", "velodyne-hdl-32e", "ouster-os1-128"),
    )
)
"""Scene, vessel and scanner."""
POINTS_PER_SECOND = 20_000
UTM = "EPSG:32619"


def simulated(folder: Path, seed: int) -> Project:
    """Create a survey with a boresight of its own, as inaccurate as a rough mounting."""
    scene, vessel, scanner = SURVEYS[seed % len(SURVEYS)]
    boresight = np.random.default_rng(seed).uniform(-3, 3, 3)
    made = read_simulation(
        scene, vessel=vessel, scanner=scanner, points_per_second=POINTS_PER_SECOND,
        errors={"boresight_deg": tuple(boresight)},
    )  # fmt: skip
    return simulate(folder, made, seed=seed)[0]


def as_clouds(project: Project, folder: Path) -> Survey:
    """Import the lines as georeferenced clouds written by another program."""
    written = georeference_project(project, folder / "clouds", "prior", system=UTM)
    lines = []
    for each in written:
        cloud = laspy.read(each.path)
        cloud.header.vlrs[:] = [vlr for vlr in cloud.header.vlrs if vlr.user_id != OWN_USER_ID]
        cloud.write(each.path)
        options = (("frame", "georeferenced"), ("crs", UTM))
        lines.append(LineSource(each.path.stem, each.path, (), Reading("las", options)))
    return new_project(
        folder / "again", trajectory=project.trajectory, lines=lines, settings=project.settings
    )[1]


def warnings_of(folder: Path, seed: int) -> list[str]:
    """Codes of the warnings about the lines as simulated and as georeferenced clouds."""
    project = simulated(folder / "survey", seed)
    surveys = [load_survey(project), as_clouds(project, folder)]
    return [
        each.code for survey in surveys for each in survey.messages if each.level is Level.WARNING
    ]


def test_a_survey_without_errors_gives_no_warning(tmp_path: Path) -> None:
    assert warnings_of(tmp_path, 0) == []


@pytest.mark.long
def test_a_hundred_surveys_without_errors_give_no_warning(tmp_path: Path) -> None:
    found: Counter[str] = Counter()
    for seed in range(100):
        for code in set(warnings_of(tmp_path / str(seed), seed)):
            print(seed, SURVEYS[seed % len(SURVEYS)], code)
            found[code] += 1
    print(f"false warnings in 100 surveys: {dict(found)}")
    assert not found
