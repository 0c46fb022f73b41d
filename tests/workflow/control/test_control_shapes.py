"""Tests of control on planes and spheres, from total stations and from scans of each format."""

from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.control_points import ControlPoint
from lispac.project import Project
from lispac.workflow.calibration import picking
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.control.control_assignment import (
    TargetSurface,
    assigned_points,
    scanned_points,
    target_surfaces,
)
from lispac.workflow.control.control_import import import_control
from lispac.workflow.project.survey import Survey
from tests.support.ball_survey import BALLS, BOARD, BORESIGHT_DEG, BallSurvey, make_ball_survey
from tests.support.long_runs import others_long

RADII = {"S1": 0.15, "S2": None}
TRIPOD = np.array([3.0, 6.0, 2.0])
SCAN_NOISE = 0.001


def cap(name: str, count: int, generator: np.random.Generator) -> np.ndarray:
    """Points of a ball that the tripod sees, with noise along the radius, shape (count, 3)."""
    centre, radius = BALLS[name]
    outward = generator.normal(size=(20 * count, 3))
    outward /= np.linalg.norm(outward, axis=1)[:, None]
    towards = (TRIPOD - centre) / np.linalg.norm(TRIPOD - centre)
    outward = outward[outward @ towards > 0.3][:count]
    return centre + outward * (radius + SCAN_NOISE * generator.normal(size=(count, 1)))


def on_the_board(count: int, generator: np.random.Generator, noise: float) -> np.ndarray:
    centre, normal, half = BOARD
    across = np.cross(normal, [1.0, 0.0, 0.0])
    a, b = generator.uniform(-half, half, (2, count, 1))
    off = noise * generator.normal(size=(count, 1))
    return centre + a * [1.0, 0.0, 0.0] + b * across + off * normal


def write_scan(path: Path, points: np.ndarray) -> Path:
    if path.suffix == ".e57":
        pye57 = pytest.importorskip("pye57")
        with pye57.E57(str(path), mode="w") as file:
            columns = {f"cartesian{axis}": points[:, k].copy() for k, axis in enumerate("XYZ")}
            file.write_scan_raw(columns)
    elif path.suffix in (".las", ".laz"):
        header = laspy.LasHeader(version="1.2", point_format=2)
        header.scales = np.full(3, 1e-5)
        data = laspy.LasData(header)
        data.xyz = points
        data.write(path)
    else:
        np.savetxt(path, points, fmt="%.5f")
    return path


@pytest.fixture(scope="module")
def balls(tmp_path_factory: pytest.TempPathFactory) -> BallSurvey:
    return make_ball_survey(tmp_path_factory.mktemp("balls"))


@pytest.fixture(scope="module")
def solved(balls: BallSurvey) -> tuple[Project, Survey]:
    """Two balls, the radius of the second is unknown, and the board, with an estimate."""
    project = balls.project
    for name, radius in RADII.items():
        project = picking.pick_target(
            project, balls.survey, balls.seed(name), name=name, shape="sphere", sphere_radius=radius
        )
    project = picking.pick_target(project, balls.survey, balls.seed("board"), name="T1")
    return estimate(project, balls.survey, cross_check=False), balls.survey


@pytest.mark.parametrize(
    "name", others_long(["tripod.e57", "tripod.laz", "tripod.las", "tripod.txt"], 2)
)
def test_planes_and_spheres_of_a_static_scan(
    solved: tuple[Project, Survey], tmp_path: Path, name: str
) -> None:
    generator = np.random.default_rng(2)
    points = [*(cap(ball, 3000, generator) for ball in RADII),
              on_the_board(6000, generator, SCAN_NOISE)]  # fmt: skip
    path = write_scan(tmp_path / name, np.concatenate(points))
    project, survey = solved
    project, _ = import_control(project, survey, path, sigma=0.0005, crs="local")
    (file,) = project.control
    assert file.kind == "scan"
    found = {point.name: point for point in file.points}
    assert list(found) == ["S1-centre", "S2-centre", "T1-1", "T1-2", "T1-3"]
    for ball in RADII:
        point = found[f"{ball}-centre"]
        assert point.is_centre
        off = np.array(point.position) - BALLS[ball][0]
        assert off @ np.linalg.solve(point.covariance, off) < 16.3  # chi-square, 0.1 %
        assert np.abs(off).max() < 0.0005
    # One side of the ball does not separate its radius from the distance to the tripod.
    towards = TRIPOD - BALLS["S2"][0]
    towards /= np.linalg.norm(towards)
    _, directions = np.linalg.eigh(found["S2-centre"].covariance)
    assert abs(directions[:, 2] @ towards) > 0.95
    assert abs(found["S2-centre"].correlations[0]) > 0.1
    for k in (1, 2, 3):
        assert abs((np.array(found[f"T1-{k}"].position) - BOARD[0]) @ BOARD[1]) < 0.0003
    result = estimate(project, survey, cross_check=False).result
    assert result is not None
    assert {each.name for each in result.control} == set(found)
    assert (np.abs(result.angles - np.radians(BORESIGHT_DEG)) < 4 * result.sigma).all()
    assert all(each.p_value is None or each.p_value > 0.001 for each in result.control)


def test_total_station_points_of_planes_and_spheres(
    solved: tuple[Project, Survey], tmp_path: Path
) -> None:
    """A single point of a ball is its centre; several lie on its surface."""
    generator = np.random.default_rng(4)
    rows = {"S1": BALLS["S1"][0][None], "S2": cap("S2", 4, generator),
            "T1": on_the_board(4, generator, 0.0)}  # fmt: skip
    lines = ["name,north,west,up,sigma,plane"]
    for target, points in rows.items():
        for k, place in enumerate(points, start=1):
            north, west, up = place + SCAN_NOISE * generator.normal(size=3)
            lines.append(f"{target}.{k},{north:.5f},{west:.5f},{up:.5f},{SCAN_NOISE},{target}")
    path = tmp_path / "points.csv"
    path.write_text("\n".join(lines) + "\n")
    project, _ = import_control(*solved, path)
    (file,) = project.control
    assert [p.target for p in file.points] == ["S1", *["S2"] * 4, *["T1"] * 4]
    assert [p.is_centre for p in file.points] == [True, *[False] * 8]
    result = estimate(project, solved[1], cross_check=False).result
    assert result is not None
    assert len(result.control) == 9
    assert all(abs(each.residual) < 5 * each.sigma for each in result.control)


@pytest.mark.parametrize("radius", [0.15, None])
def test_the_covariance_of_a_fitted_centre_is_that_of_its_scatter(
    solved: tuple[Project, Survey], radius: float | None
) -> None:
    """Points of one cell have one error, so that the covariance is larger by their number."""
    target = replace(solved[0].target("S1"), sphere_radius=radius)
    generator = np.random.default_rng(9)
    errors, ratios = [], []
    for _ in range(120):
        points = cap("S1", 400, generator)
        surface = TargetSurface(target, points, BALLS["S1"][0], np.zeros(3), BALLS["S1"][1])
        (found,) = scanned_points(points, [surface])
        off = np.array(found.position) - BALLS["S1"][0]
        errors.append(off @ np.linalg.solve(found.covariance, off))
        ratios.append(off)
    # With cells of half the radius, about 20 of them have the weight of 400 points.
    empirical = np.cov(np.array(ratios).T)
    share = np.mean(errors) / 3
    assert 1 / 40 < share < 1 / 8
    predicted = found.covariance * share
    values = np.linalg.eigvals(np.linalg.solve(predicted, empirical)).real
    assert 0.6 < values.min() < values.max() < 1.6


def test_points_by_place_on_a_ball(solved: tuple[Project, Survey]) -> None:
    """Near the centre it is the centre, near the surface a point on it."""
    project, survey = solved
    centre, radius = BALLS["S1"]
    places = [centre + [0.01, 0.0, 0.0], centre + [0.0, -radius - 0.01, 0.0]]
    points = [
        ControlPoint(f"P{k}", "", tuple(map(float, place)), (0.001,) * 3)
        for k, place in enumerate(places)
    ]
    found = assigned_points(points, target_surfaces(project, survey))
    assert [(p.target, p.is_centre) for p in found] == [("S1", True), ("S1", False)]
