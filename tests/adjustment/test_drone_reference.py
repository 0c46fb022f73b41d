"""Tests of the accuracy of the reference of two drone surveys, and of targetless results.

The reference was estimated from labelled points. These lie within 4 to 5 cm of one plane for each
label through both lines; the surfaces are thicker, up to 10 cm of cloth, grass and noise. So the
points were selected with a known boresight, and a selection reproduces its boresight.
"""

import json
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from scipy.spatial import KDTree

from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations, Sighting
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import AdjustmentResult
from lispac.geometry.planes import fit_plane, plane_axes
from lispac.project import LineSource, Settings
from lispac.survey.cloud import place_clouds
from lispac.workflow.calibration.targetless import TargetlessResult, targetless
from lispac.workflow.project.projects import create_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.long_runs import others_long

Labels = dict[str, np.ndarray]
NAMES = ("lanl_truck", "lanl_tent")
BAND = 0.15
"""Half width in metres of a band about the plane of a label that contains its whole surface."""
MIN_LABELLED_POINTS = 10
"""Minimum number of points of a label on each line."""


class Drone(NamedTuple):
    survey: Survey
    found: TargetlessResult
    reference: np.ndarray  # degrees
    labels: Labels
    inside: list[Labels]  # for each label, the points of each line within its outline


@pytest.fixture(scope="module")
def drone(shared_data: Path, tmp_path_factory: pytest.TempPathFactory):  # type: ignore[no-untyped-def]
    @cache
    def opened(name: str) -> Drone:
        data = shared_data / name
        site = json.loads((data / "site.json").read_text())
        project = create_project(
            tmp_path_factory.mktemp(name) / "p",
            trajectory=data / "trajectory.sbet",
            lines=[LineSource(path.stem, path) for path in sorted(data.glob("*.laz"))],
            settings=Settings(
                lever_arm=tuple(site["lever_arm_m"]),
                origin_deg_m=tuple(site["origin_deg_m"]),
                position_sigma=(0.02, 0.02, 0.02),
                attitude_sigma_deg=(0.015, 0.015, 0.015),
                lidar_sigma=0.02,
            ),
        )
        survey = load_survey(project)
        reference = json.loads((data / "reference.json").read_text())["boresight_deg"]
        labels = {line: values for line, values in np.load(data / "labels.npz").items()}
        placed = georeferenced_points(survey, np.array(reference))
        inside = [
            indices_in_outline(placed, {line: labels[line] == k for line in placed})
            for k in range(int(labels["line1"].max()) + 1)
            if min((labels[line] == k).sum() for line in placed) >= MIN_LABELLED_POINTS
        ]
        return Drone(survey, targetless(project, survey), np.array(reference), labels, inside)

    return opened


def georeferenced_points(survey: Survey, boresight_deg: np.ndarray) -> Labels:
    """All points of each line, georeferenced with a boresight."""
    one = next(iter(survey.clouds.values())).place.mounting
    clouds = place_clouds(survey.clouds, one.with_boresight(np.radians(boresight_deg)))
    return {line: cloud[np.arange(len(survey.scans[line].time))] for line, cloud in clouds.items()}


def indices_in_outline(placed: Labels, own: Labels) -> Labels:
    """Numbers of the points inside the outline of the labelled ones and near their plane."""
    labelled = np.concatenate([placed[line][own[line]] for line in placed])
    plane = fit_plane(labelled)
    axes = plane_axes(plane.normal).T
    tree, found = KDTree(labelled @ axes), {}
    for line, points in placed.items():
        near = np.flatnonzero(np.abs(plane.distances(points)) < 2 * BAND)
        along = points[near] @ axes
        around = np.zeros((len(near), 4), dtype=bool)
        for i, beside in enumerate(tree.query_ball_point(along, 0.12)):
            east, north = (tree.data[beside] > along[i]).T if beside else (np.zeros(0, int),) * 2
            around[i, 2 * east.astype(int) + north.astype(int)] = True
        found[line] = near[around.all(axis=1)]
    return found


def select_in_band(drone: Drone, boresight_deg: np.ndarray, band: float) -> list[Labels]:
    """Select the points of each outline in a band about the densest plane of both lines."""
    placed, found = georeferenced_points(drone.survey, boresight_deg), []
    for inside in drone.inside:
        points = np.concatenate([placed[line][own] for line, own in inside.items()])
        even = np.concatenate([np.full(len(own), 1 / len(own)) for own in inside.values()])
        weights = even
        for wide in (0.3, 0.2, 0.15, 0.12, 0.1, 0.08, 0.06, *(band,) * 10):
            off = fit_plane(points, weights).distances(points) / max(wide, band)
            weights = even * np.maximum(1 - off**2, 0.0) ** 2
        on = np.split(np.abs(off) < 1, np.cumsum([len(own) for own in inside.values()])[:-1])
        found.append(
            {line: own[kept] for (line, own), kept in zip(inside.items(), on, strict=True)}
        )
    return found


def adjusted_flight(drone: Drone, chosen: list[Labels], model: StochasticModel) -> AdjustmentResult:
    survey = drone.survey
    parts = [(k, line, own) for k, each in enumerate(chosen) for line, own in each.items()]
    points = np.concatenate([survey.scans[line].points_lidar[own] for _, line, own in parts])
    time = np.concatenate([survey.scans[line].time[own] for _, line, own in parts])
    poses, (position, attitude) = survey.trajectory.at(time), survey.accuracy.at(time)
    observations = Observations(
        points_lidar=points, position=poses.position, attitude=poses.attitude,
        sigma_lidar=np.full(points.shape, 0.02), sigma_position=position, sigma_attitude=attitude,
        time=time, sighting=np.repeat(np.arange(len(parts)), [len(own) for *_, own in parts]),
        sightings=tuple(Sighting(f"P{k}", line) for k, line, _ in parts),
    )  # fmt: skip
    start = next(iter(survey.clouds.values())).place.mounting
    start = start.with_boresight(np.radians(drone.reference))
    if model.correlated:
        observations = average_points_in_cells(observations, start, 0.10)
    return adjust(observations, start, model, diagnostics=False)


THESIS = StochasticModel("independent", loss="huber")
"""Stochastic model of the adjustments that gave the reference."""


@pytest.mark.parametrize("name", others_long(NAMES))
def test_labelled_points_were_selected_in_a_band(drone, name: str) -> None:  # type: ignore[no-untyped-def]
    here: Drone = drone(name)
    placed = georeferenced_points(here.survey, here.reference)
    beyond = 0
    for k, inside in enumerate(here.inside):
        own = {line: here.labels[line] == k for line in placed}
        plane = fit_plane(np.concatenate([placed[line][own[line]] for line in placed]))
        for line, numbers in inside.items():
            off = np.abs(plane.distances(placed[line]))
            assert off[own[line]].max() < 0.055
            beyond += int((~own[line][numbers] & (off[numbers] < BAND)).sum())
    total = sum(len(own) for inside in here.inside for own in inside.values())
    assert beyond / total > 0.15, beyond / total


@pytest.mark.parametrize(
    ("name", "follows"), others_long([("lanl_truck", 0.5), ("lanl_tent", 0.6)])
)
def test_a_narrow_selection_reproduces_its_boresight(drone, name: str, follows: float) -> None:  # type: ignore[no-untyped-def]
    """Points selected with another boresight reproduce most of its change."""
    here: Drone = drone(name)
    offset = np.array([0.0, 0.0, 0.1])
    ends = [
        adjusted_flight(
            here, select_in_band(here, here.reference + sign * offset, 0.04), THESIS
        ).boresight
        for sign in (1, -1)
    ]
    assert np.degrees(ends[0] - ends[1])[2] / 0.2 > follows
    wide = [
        adjusted_flight(
            here, select_in_band(here, here.reference + sign * offset, BAND), THESIS
        ).boresight
        for sign in (1, -1)
    ]
    assert abs(np.degrees(wide[0] - wide[1])[2]) / 0.2 < 0.2


@pytest.mark.parametrize("name", others_long(NAMES))
def test_the_targetless_result_agrees_with_the_whole_surfaces(drone, name: str) -> None:  # type: ignore[no-untyped-def]
    here: Drone = drone(name)
    whole = adjusted_flight(
        here, select_in_band(here, here.reference, BAND), StochasticModel(loss="tukey")
    )
    result = here.found.result
    off = np.abs(result.boresight - whole.boresight) / np.hypot(result.sigma, whole.sigma)
    assert (off < 3).all(), off
    assert np.degrees(np.abs(result.boresight - whole.boresight)).max() < 0.1
    assert here.found.raised > 1.3
    assert "adjustment.not_flat" in {each.code for each in result_warnings(result, None)}
