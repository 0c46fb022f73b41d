"""Processor time, memory and errors of the targetless method, with six lines on disk.

The lines are those of the built-in survey with additional points (`bench_seed_store`), or strips of
a simulated airborne block (`airborne_block`). Run with
``pytest -s tests/benchmarks/bench_targetless.py``; 20 million points a line (5 GB of files) and
nine more airborne blocks with ``-m long``. Aims: six lines of a million points in 10 s of processor
time, of 20 million in 3 min and 4 GB; an airborne block of 1.8 million points in 40 s.
"""

import os
import resource
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from lispac.workflow.calibration.targetless import targetless
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import load_survey
from tests.benchmarks.airborne_block import make_airborne_block
from tests.benchmarks.bench_seed_store import make_dense_demo


@pytest.mark.parametrize(
    "count", [10**6, pytest.param(2 * 10**7, marks=pytest.mark.long)], ids="{:.0e}".format
)
def test_the_scene_of_six_lines(count: int, tmp_path: Path) -> None:
    print_reports(make_dense_demo(tmp_path / "six", count))


@pytest.mark.parametrize(
    "seed", [1, *(pytest.param(seed, marks=pytest.mark.long) for seed in range(2, 11))]
)
def test_an_airborne_block(seed: int, tmp_path: Path) -> None:
    """The errors of all seeds, divided by their sigmas, show the coverage."""
    print_reports(make_airborne_block(tmp_path / "block", seed).folder)


def print_reports(folder: Path) -> None:
    """Print the measurements of two runs, each in a process of its own."""
    command = [sys.executable, "-m", "tests.benchmarks.bench_targetless", str(folder)]
    for _ in range(2):  # the first run also imports the lines and compiles
        run = subprocess.run(
            command, capture_output=True, text=True, check=False, cwd=Path(__file__).parents[2]
        )
        assert run.returncode == 0, run.stderr
        print(f"\n{run.stdout}")


def report(folder: Path) -> None:
    """Print the measurements; runs in a separate process so that its peak memory is measured."""
    project = open_project(folder)
    start = now()
    survey = load_survey(project)
    loaded = now()
    found = targetless(project, survey)
    ended = now()
    points = sum(len(cloud) for cloud in survey.clouds.values())
    kinds = {type(cloud).__name__ for cloud in survey.clouds.values()}
    off = np.degrees(found.result.boresight) - project.truth_deg
    sigma = np.degrees(found.result.sigma)
    (load_processor, load_wall), (processor, wall) = loaded - start, ended - loaded
    print(
        f"{points / 1e6:.1f} M points ({', '.join(kinds)}): loaded in {load_processor:.1f} s of "
        f"processor time ({load_wall:.1f} s), found in {processor:.1f} s ({wall:.1f} s), "
        f"{found.iterations} iterations; error {np.round(off, 4)} deg, sigma {np.round(sigma, 4)} "
        f"deg, ratio {np.round(off / sigma, 2)}; "
        f"most memory {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20:.2f} GB"
    )


def now() -> np.ndarray:
    """Processor time of this process and wall time, shape (2,), seconds."""
    times = os.times()
    return np.array([times.user + times.system, time.perf_counter()])


if __name__ == "__main__":
    report(Path(sys.argv[1]))
