"""Tests of the differences between lines on flat surfaces."""

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from lispac.errors import InputError, NotComparable, ProjectError
from lispac.io.project.project_file import write_project
from lispac.project import Project
from lispac.report.line_map import line_difference_map
from lispac.validation.line_differences import (
    DifferenceStatistics,
    LineDifference,
    compare_lines,
)
from lispac.workflow.checking.line_quality import line_quality
from lispac.workflow.project.survey import Survey
from tests.cli.test_cli import run, run_json, run_refused
from tests.support.command_errors import command_error
from tests.support.error_codes import has_code
from tests.support.few_lines import picked
from tests.support.long_runs import LONG
from tests.support.message_codes import is_shown

VESSEL = np.array([0.0, 0.0, 3.0])


def scene(rng: np.random.Generator, shift: np.ndarray) -> np.ndarray:
    """Return points of a wall 20 m to the north, the ground and a ramp, with 3 mm of noise."""
    west, up = rng.uniform(-10, 10, 60_000), rng.uniform(0, 8, 60_000)
    wall = np.stack([np.full_like(west, 20.0), west, up], axis=1)
    ground = np.stack([rng.uniform(12, 20, 60_000), west, np.zeros_like(west)], axis=1)
    along = rng.uniform(6, 11, 30_000)
    ramp = np.stack([along, rng.uniform(-10, 10, 30_000), 0.5 * (along - 6)], axis=1)
    everything = np.concatenate([wall, ground, ramp])
    return everything + shift + rng.normal(0.0, 0.003, everything.shape)


@LONG
def test_a_shift_is_measured_along_each_normal() -> None:
    rng = np.random.default_rng(5)
    still, moved = scene(rng, np.zeros(3)), scene(rng, np.array([-0.05, 0.0, 0.03]))
    found = compare_lines(("L1", still), ("L2", moved), VESSEL, noise=0.003, reach=0.5)
    wall, ground, ramp = (found.facing(way) for way in ("upright", "level", "sloped"))
    assert len(wall.distance) + len(ground.distance) + len(ramp.distance) == len(found.distance)
    # The second line is 5 cm farther south and 3 cm higher, towards the vessel.
    assert np.median(wall.distance) == pytest.approx(-0.05, abs=5e-4)
    assert np.median(ground.distance) == pytest.approx(-0.03, abs=5e-4)
    normal = np.array([-0.5, 0.0, 1.0]) / np.hypot(0.5, 1.0)  # the ramp rises to the north
    assert np.median(ramp.distance) == pytest.approx(normal @ [0.05, 0.0, -0.03], abs=5e-4)
    assert np.median(np.abs(wall.normal[:, 2])) < 0.01
    same = compare_lines(("L1", still), ("L2", scene(rng, np.zeros(3))), VESSEL,
                           noise=0.003, reach=0.5)  # fmt: skip
    figures = DifferenceStatistics.of(same.distance, same.half_width)
    assert abs(figures.median) < 3e-4
    assert figures.rmsd < 0.0015
    assert 0.02 < figures.significant < 0.10, "95 % intervals, where nothing differs"


def test_statistics_of_given_differences() -> None:
    distance = np.array([-0.01, 0.0, 0.01, 0.02, 0.08])
    found = DifferenceStatistics.of(distance, np.full(5, 0.015))
    assert found.places == 5
    assert found.median == 0.01
    assert found.rmsd == pytest.approx(np.sqrt(np.mean(distance**2)))
    assert found.robust_sigma == pytest.approx(1.4826 * 0.01)
    assert (found.largest, found.significant) == (0.08, 0.4)
    assert found.p95 == pytest.approx(np.percentile(np.abs(distance), 95))


def test_differences_of_the_demo_before_and_after_the_calibration(
    denser_calibrated: tuple[Project, Survey],
) -> None:
    """The calibration reduces the differences to the POS errors of the simulation."""
    project, survey = denser_calibrated
    survey = replace(survey, clouds=dict(list(survey.clouds.items())[4:]))
    found = line_quality(project, survey)
    assert len(found.pairs) == 1
    again = line_quality(project, survey, which="estimated")
    before, after = (each.statistics_of_pair(each.pairs[0]) for each in (found, again))
    together = found.pooled_statistics()
    assert together is not None
    assert together.median is None, "which line comes second says nothing of several pairs"
    assert before is not None
    assert after is not None
    assert before.rmsd > 0.1
    assert after.rmsd < 0.03, "the simulated POS errors: 2 cm of position"
    assert after.robust_sigma < 0.005, "nothing is bent"


def test_lines_without_common_or_flat_places_are_refused() -> None:
    rng = np.random.default_rng(6)
    one = scene(rng, np.zeros(3))
    with pytest.raises(
        NotComparable,
        check=has_code("validation.no_place_in_common", line="A", other="B", reach=0.5),
    ):
        compare_lines(("A", one), ("B", one + 100.0), VESSEL, noise=0.003, reach=0.5)
    rubble = rng.uniform(0, 5, (50_000, 3))
    with pytest.raises(NotComparable, check=has_code("validation.no_flat_place")):
        compare_lines(("A", rubble), ("B", rubble), VESSEL, noise=0.003, reach=0.5)


def test_the_quality_command_writes_map_and_table(
    capsys: pytest.CaptureFixture[str], demo_project: Project, tmp_path: Path
) -> None:
    project = replace(
        demo_project, folder=tmp_path / "p", lines=demo_project.lines[:2], targets=()
    )  # fmt: skip
    project.folder.mkdir()
    write_project(project)
    picture, table = tmp_path / "map.png", tmp_path / "places.csv"
    found = run_json(capsys, "quality", project.folder, "--map", picture, "--csv", table)
    assert found["boresight"] == "prior"
    rows = {each["facing"]: each for each in found["differences"]}
    assert rows["all"]["first"], rows["all"]["second"] == [line.name for line in project.lines]
    assert rows["all"]["places"] >= rows["upright"]["places"] > 100
    assert picture.read_bytes().startswith(b"\x89PNG")
    with table.open(encoding="utf-8") as file:
        listed = list(csv.DictReader(file))
    assert len(listed) == rows["all"]["places"]
    values = np.array([float(each["difference_m"]) for each in listed])
    assert np.sqrt(np.mean(values**2)) == pytest.approx(rows["all"]["rmsd_m"], abs=1e-4)
    code, out, _ = run(capsys, "quality", project.folder)
    assert code == 0
    assert "prior boresight" in out
    assert "RMS" in out
    assert is_shown(
        "project.not_estimated",
        run_refused(capsys, "quality", project.folder, "--boresight", "estimated"),
    )
    refusal = command_error("quality", project.folder, "--search-distance", "11")
    assert refusal.code == "check.search_distance"


@pytest.mark.parametrize("longer", ["north", "east"])
def test_the_map_fills_a_wide_figure(longer: str) -> None:
    """A quay from north to south is drawn with north at the right, not as a narrow strip."""
    rng = np.random.default_rng(1)
    north, west = (90.0, 20.0) if longer == "north" else (20.0, 90.0)
    place = np.column_stack([rng.uniform(0, north, 500), rng.uniform(0, west, 500), np.zeros(500)])
    size = rng.uniform(0, 0.02, 500)
    pair = LineDifference("L1", "L2", place, size, np.zeros(500), np.tile([0, 0, 1.0], (500, 1)))
    figure = line_difference_map([pair], Figure(figsize=(8.0, 3.0)), shown=[pair], title="L1 − L2")
    FigureCanvasAgg(figure).draw()
    axes = figure.axes[0]
    drawn = axes.collections[0].get_offsets()
    assert np.ptp(drawn[:, 0]) > 0.8 * np.ptp(axes.get_xlim())
    assert axes.get_aspect() == 1.0
    if longer == "north":
        np.testing.assert_allclose(np.sort(drawn[:, 0]), np.sort(place[:, 0]))
        assert (axes.get_xlabel(), axes.get_ylabel()) == ("North (m)", "West (m)")
    else:
        np.testing.assert_allclose(np.sort(drawn[:, 0]), np.sort(-place[:, 1]))
        assert (axes.get_xlabel(), axes.get_ylabel()) == ("East (m)", "North (m)")


def test_a_zero_distance_and_a_missing_result_are_refused(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    with pytest.raises(InputError) as raised:
        line_quality(project, survey, search_distance=0.0)
    assert raised.value.code == "check.search_distance"
    bare = Project(
        folder=project.folder,
        trajectory=project.trajectory,
        lines=project.lines,
        settings=project.settings,
    )
    with pytest.raises(ProjectError, check=lambda e: e.code == "project.not_estimated"):
        line_quality(bare, survey, which="estimated")


def test_one_pair_has_no_row_for_all_pairs() -> None:
    project, survey = picked()
    found = line_quality(project, survey, search_distance=0.5)
    assert {(row.first, row.second) for row in found.rows()} >= {("L1", "L2"), ("all", "all")}
    two = {name: survey.clouds[name] for name in ("L1", "L2")}
    pair = line_quality(project, replace(survey, clouds=two), search_distance=0.5)
    assert {(row.first, row.second) for row in pair.rows()} == {("L1", "L2")}


def test_a_single_line_is_refused() -> None:
    project, survey = picked()
    alone = replace(survey, clouds={"L1": survey.clouds["L1"]})
    with pytest.raises(NotComparable) as caught:
        line_quality(project, alone, search_distance=0.25)
    assert caught.value.code == "check.no_common_place"
    assert caught.value.message is not None
    assert caught.value.message.params == {"project": "site", "distance": 0.25}
