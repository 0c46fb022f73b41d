"""Time and memory of the targetless method by number of points, with six lines on disk.

The lines are those of the built-in survey with additional points (`bench_seed_store`). Run with
``pytest -s tests/benchmarks/bench_targetless.py``; 20 million points a line with ``-m long`` (5 GB
of files). Aims: six lines of a million points in 20 s, of 20 million in 3 min and 4 GB.
"""

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
from tests.benchmarks.bench_seed_store import make_dense_demo


@pytest.mark.parametrize(
    "count", [10**6, pytest.param(2 * 10**7, marks=pytest.mark.long)], ids="{:.0e}".format
)
def test_the_scene_of_six_lines(count: int, tmp_path: Path) -> None:
    folder = make_dense_demo(tmp_path / "six", count)
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
    start = time.perf_counter()
    survey = load_survey(project)
    loaded = time.perf_counter()
    found = targetless(project, survey)
    ended = time.perf_counter()
    points = sum(len(cloud) for cloud in survey.clouds.values())
    kinds = {type(cloud).__name__ for cloud in survey.clouds.values()}
    off = np.degrees(found.result.boresight) - project.truth_deg
    print(
        f"{points / 1e6:.1f} M points ({', '.join(kinds)}): loaded {loaded - start:.1f} s, "
        f"found {ended - loaded:.1f} s, {1e6 * (ended - loaded) / points:.2f} s a million; "
        f"off {np.round(off, 4)} deg, sigma {np.round(np.degrees(found.result.sigma), 4)} deg; "
        f"most memory {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20:.2f} GB"
    )


if __name__ == "__main__":
    report(Path(sys.argv[1]))
