"""Files of point correspondences of a project."""

from pathlib import Path

import numpy as np

from lispac.project import Project
from lispac.survey.georeferencing import to_lidar
from lispac.survey.trajectory import Poses
from lispac.workflow.project.survey import Survey


def write_pairs(
    path: Path,
    project: Project,
    survey: Survey,
    *,
    count: int = 200,
    noise: float = 0.02,
    time_shift: float = 0.0,
    header: str = "",
    row: str = "{:.6f} {:.6f} {:.5f} {:.5f} {:.5f} {:.5f} {:.5f} {:.5f}",
) -> Path:
    """Write pairs of places around the vessel, measured with the true boresight of the project.

    The poses are those of the trajectory with errors of 5 mm and 0.002 deg that change slowly.
    """
    generator = np.random.default_rng(7)
    assert project.truth_deg is not None
    mounting = project.mounting("prior").with_boresight(np.radians(project.truth_deg))
    scans = list(survey.scans.values())
    first = generator.integers(0, len(scans), count)
    second = (first + generator.integers(1, len(scans), count)) % len(scans)
    spans = np.array([(scan.first_time, scan.last_time) for scan in scans])
    time = np.stack(
        [low + (high - low) * generator.uniform(0.01, 0.99, count)
         for low, high in (spans[line].T for line in (first, second))]
    )  # fmt: skip
    middle = survey.trajectory.at(spans.ravel()).position.mean(axis=0)
    places = middle + generator.uniform([-30, -30, -10], [30, 30, -2], (count, 3))
    points = []
    for k in range(2):
        poses = survey.trajectory.at(time[k] + project.settings.latency)
        drift = np.sin(2 * np.pi * time[k][:, None] / 200.0 + np.arange(3))
        true = Poses(poses.position + 0.005 * drift, poses.attitude + np.radians(0.002) * drift)
        noise_of_point = noise / np.sqrt(2) * generator.standard_normal((count, 3))
        points.append(to_lidar(places, true, mounting) + noise_of_point)
    rows = np.column_stack([*(time - time_shift), *points])
    path.write_text(header + "".join(f"{row.format(*each)}\n" for each in rows), encoding="utf-8")
    return path
