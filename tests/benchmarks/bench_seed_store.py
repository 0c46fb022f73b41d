"""Time to find a target from a seed in six lines on disk.

The lines are those of the built-in survey with additional points, interpolated between neighbours
on the same surface, with independent noise and with labels. Run with
``pytest -s tests/benchmarks/bench_seed_store.py``; 20 million points a line with ``-m long`` (5 GB
of files).
"""

import resource
import subprocess
import sys
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.io.project.project_file import PROJECT_FILE_NAME
from lispac.simulation.simulated_survey import SimulatedLine, port_survey
from lispac.workflow.calibration.picking import find_target
from lispac.workflow.planning.demo import make_demo
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import load_survey
from tests.benchmarks.bench_store import least, now, since

NOISE = 0.0017
CHUNK = 20_000
ROUNDS = 5


def write_densified_line(line: SimulatedLine, count: int, path: Path) -> None:
    """Write a line with about ``count`` points, and a file with their labels beside it."""
    rng = np.random.default_rng(len(line.time))
    times = -(-count // len(line.time))
    labels = []
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = np.full(3, 1e-4)
    with laspy.open(path, mode="w", header=header) as writer:
        for start in range(0, len(line.time) - 1, CHUNK):
            here = np.arange(start, min(start + CHUNK, len(line.time) - 1))
            same = line.label[here] == line.label[here + 1]
            share = np.sort(rng.uniform(0.0, 1.0, (len(here), times)), axis=1) * same[:, None]
            points = (
                line.points_lidar[here, None, :]
                + share[:, :, None]
                * (line.points_lidar[here + 1] - line.points_lidar[here])[:, None, :]
            )
            points += rng.normal(0.0, NOISE, points.shape)
            moments = line.time[here, None] + share * np.diff(line.time)[here, None]
            record = laspy.ScaleAwarePointRecord.zeros(moments.size, header=header)
            record.x, record.y, record.z = points.reshape(-1, 3).T
            record.gps_time = moments.ravel()
            record.return_number[:] = record.number_of_returns[:] = 1
            writer.write_points(record)
            labels.append(np.repeat(line.label[here].astype(np.int8), times))
    np.save(path.with_suffix(".npy"), np.concatenate(labels))


def make_dense_demo(folder: Path, count: int) -> Path:
    """Make the project of the built-in survey, with about ``count`` points a line."""
    project = make_demo(folder)
    for line, source in zip(port_survey().lines, project.lines, strict=True):
        write_densified_line(line, count, source.path.with_suffix(".las"))
        source.path.unlink()
    written = project.folder / PROJECT_FILE_NAME
    written.write_text(written.read_text().replace(".laz", ".las"))
    return project.folder


@pytest.mark.parametrize(
    "count", [10**6, pytest.param(2 * 10**7, marks=pytest.mark.long)], ids="{:.0e}".format
)
def test_seed_to_six_lines_of_a_store(count: int, tmp_path: Path) -> None:
    folder = make_dense_demo(tmp_path / "six", count)
    command = [sys.executable, "-m", "tests.benchmarks.bench_seed_store", str(folder)]
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
    opened = since(start)
    total = sum(len(scan) for scan in survey.scans.values())
    start = now()
    matched_share = survey.alignment.matched_share
    aligned = since(start)
    print(
        f"six lines, {total:,} points, opened (or imported) {least([opened])}; "
        f"laid onto each other {least([aligned])}, {100 * matched_share:.0f} % meet"
    )
    truth = port_survey()
    for name, centre in truth.targets.items():
        number = truth.surface_names.index(name)
        line = survey.lines[0]
        labels = {
            source.name: np.load(source.path.with_suffix(".npy"), mmap_mode="r")
            for source in project.lines
        }
        on = np.flatnonzero(labels[line] == number)
        clicked = survey.clouds[line][on[len(on) // 2][None]][0]
        for word, seed, first in (("clicked", clicked, line), ("typed", centre, None)):
            find_target(project, survey, seed, name=name, first_line=first)
            rounds = []
            for _ in range(ROUNDS):
                start = now()
                target = find_target(project, survey, seed, name=name, first_line=first)
                rounds.append(since(start))
            print(
                f"{name} {word}: {len(target.sightings)} sightings, "
                f"{sum(len(s.indices) for s in target.sightings):,} points, {least(rounds)}, "
                f"median {1e3 * float(np.median(rounds, axis=0)[0]):.0f} ms"
            )
            for s in target.sightings:
                right = np.asarray(labels[s.line][s.indices] == number)
                there = np.count_nonzero(np.asarray(labels[s.line]) == number) / s.one_in
                print(
                    f"  {s.line}: precision {right.mean():.4f}, recall {right.sum() / there:.4f}"
                    + (f", one in {s.one_in}" if s.one_in > 1 else "")
                )
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(f"memory at most {peak:.2f} GB")


if __name__ == "__main__":
    report(Path(sys.argv[1]))
