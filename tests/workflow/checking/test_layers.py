"""Tests that the distance to the reference surface is measured if a line sees several."""

from pathlib import Path

import numpy as np
import pytest

from lispac.message_texts import english_text
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.project import Project
from lispac.simulation.simulated_survey import SimulatedSurvey, port_survey
from lispac.validation.reference_places import measure_to_surface
from lispac.workflow.checking.absolute_check import check_absolute
from lispac.workflow.project.survey import Survey
from tests.conftest import DEMO_PULSES
from tests.support.absolute_sample import project_with_true_boresight, true_offsets
from tests.support.report_sample import sample_project
from tests.support.static_scans import on_plane


@pytest.fixture(scope="module")
def truth() -> SimulatedSurvey:
    return port_survey(points_per_second=DEMO_PULSES)


@pytest.fixture(scope="module")
def known(
    demo_project: Project, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Project, Survey]:
    return project_with_true_boresight(
        demo_project, sample_project(tmp_path_factory.mktemp("sample"))
    )


def test_distances_to_a_board_ignore_the_wall_behind_it(
    known: tuple[Project, Survey], truth: SimulatedSurvey, tmp_path: Path
) -> None:
    """T2 leans by 45 deg, 62 cm in front of the wall at its middle; lines see both."""
    expected = true_offsets(truth, known[1], "T2", 50)
    path = tmp_path / "board.csv"
    corners = on_plane("T2", np.array([-0.4, 0.4, 0.4, -0.4]), np.array([-0.4, -0.4, 0.4, 0.4]))
    rows = [f"B{k},{x[0]},{x[1]},{x[2]},0.002,T2" for k, x in enumerate(corners)]
    path.write_text("\n".join(["name,north,west,up,sigma,plane", *rows]))
    project, _ = check_absolute(*known, path)
    check = project.absolute
    assert check is not None
    assert len(check.lines) >= 4
    for line in check.lines:
        # The true offset includes some more points at the edge of the board.
        assert line.after.signed.mean == pytest.approx(expected[line.line], abs=0.003)
        assert line.after.distances.p99 < abs(expected[line.line]) + 0.02
        assert line.before.distances.rms < 0.2
    assert check.other_surfaces
    assert all(0.2 < other.distance < 1.0 for other in check.other_surfaces)
    texts = map(english_text, AbsoluteCheckValues.of(check).messages)
    (message,) = (each for each in texts if "Another surface" in each)
    assert all(other.line in message for other in check.other_surfaces)


def test_the_board_is_found_after_a_large_shift() -> None:
    """Before the calibration the points are shifted by up to 0.9 m; a wall is 0.4 m behind."""
    rng = np.random.default_rng(2)

    def sheet(off: float, side: float, n: int) -> np.ndarray:
        return np.column_stack([rng.uniform(-side, side, (n, 2)), rng.normal(off, 0.004, n)])

    scanned = np.concatenate([sheet(0.01, 0.5, 3000), sheet(-0.39, 2.0, 48_000)])
    reference = sheet(0.0, 0.5, 9000)
    cores = np.column_stack([*rng.uniform(-0.35, 0.35, (2, 60)), np.zeros(60)])
    for away in (0.0, 0.3, 0.7, 0.9):
        found = measure_to_surface(
            scanned + (0.05, 0.0, away), scanned, reference, cores,
            facing=np.tile([0.0, 0.0, 1.0], (60, 1)), diameters=np.full(60, 0.15), reach=1.0,
            roughest=0.01,
        )  # fmt: skip
        assert len(found.after.distance) > 50
        assert np.abs(found.after.distance - 0.01).max() < 0.005
        assert np.abs(found.before.distance - 0.01 - away).max() < 0.005
        assert found.to_other_surface == pytest.approx(0.38, abs=0.02)


def test_outliers_in_front_of_a_surface_are_ignored() -> None:
    """A few outliers are in front of the wall everywhere, and a cluster of them at one place."""
    rng = np.random.default_rng(3)
    wall = np.column_stack([rng.uniform(-1, 1, (40_000, 2)), rng.normal(-0.2, 0.004, 40_000)])
    outliers = np.column_stack([rng.uniform(-1, 1, (1500, 2)), rng.uniform(-0.1, 0.1, 1500)])
    bird = rng.normal((0.3, 0.3, 0.0), 0.01, (200, 3))
    reference = np.column_stack([rng.uniform(-1, 1, (20_000, 2)), np.zeros(20_000)])
    cores = np.concatenate([reference[:80] * 0.8, [[0.3, 0.3, 0.0]]])
    points = np.concatenate([wall, outliers, bird])
    found = measure_to_surface(
        points, points, reference, cores, facing=np.tile([0.0, 0.0, 1.0], (81, 1)),
        diameters=np.full(81, 0.15), reach=0.5, roughest=0.01,
    )  # fmt: skip
    assert np.abs(found.after.distance + 0.2).max() < 0.005
