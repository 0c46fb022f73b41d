"""Tests of spheres in the adjustment and from a seed to a saved project."""

import json
from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.stochastic_model import POS_ERROR_MODELS, StochasticModel
from lispac.cli.main import main
from lispac.errors import ProjectError, SphereNotFound
from lispac.geometry.spheres import visible_share
from lispac.io.project.project_file import PROJECT_FILE_NAME
from lispac.messages import note
from lispac.present.targets.sightings import sighting_values
from lispac.project import Project
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    Ball,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting
from lispac.workflow.calibration import estimation as calibration
from lispac.workflow.calibration import picking
from lispac.workflow.project.projects import open_project, save_project
from tests.support.ball_survey import BALLS, BORESIGHT_DEG, NAMES, BallSurvey, make_ball_survey
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import is_shown

LEVER_ARM = np.array([-0.2, 0.04, 2.4])
TRUTH = Mounting(LEVER_ARM, np.radians([2.0, 2.0, 2.0]))
CENTRES = ((0.0, 15.0, 5.0), (1.5, 12.0, 3.0), (-1.5, 20.0, 7.0))


def three_balls(known):
    return [Ball(f"S{k + 1}", place, 0.1, known) for k, place in enumerate(CENTRES)]


def prior(angle_deg):
    return Mounting(LEVER_ARM, np.radians(np.full(3, angle_deg)))


# -- in closed form --------------------------------------------------------------------------


@pytest.mark.parametrize("scanner", [(0.0, 0.0, 2.0), (-15.0, 15.0, 30.0)])
def test_the_cap_of_a_ball_faces_the_scanner(scanner):
    ball = Ball("S1", CENTRES[0], 0.2)
    points = ball.points(0.004, np.random.default_rng(0), np.array(scanner))
    towards = np.array(scanner) - ball.centre
    from_centre = points - ball.centre
    np.testing.assert_allclose(np.linalg.norm(from_centre, axis=1), 0.2, atol=1e-12)
    cosine = from_centre @ towards / (0.2 * np.linalg.norm(towards))
    assert cosine.min() == pytest.approx(np.cos(np.radians(80.0)), abs=0.02)
    assert cosine.max() > 0.999


@pytest.mark.parametrize("model", POS_ERROR_MODELS)
@pytest.mark.parametrize(
    ("known", "with_board", "start_deg"),
    # Angles of zero displace the points by 0.7 m. With a board and balls of unknown radius (true
    # radius 0.1 m) the prior must be correct to a few tenths of a degree.
    others_long([(True, False, 0.0), (False, False, 0.0), (True, True, 0.0), (False, True, 1.7)]),
)
def test_true_boresight_is_recovered_without_noise(model, known, with_board, start_deg):
    targets = [*three_balls(known), *(THESIS_BOARDS[1:] if with_board else ())]
    exact = error_free_survey(TRUTH, targets, six_courses(), 0.03, np.random.default_rng(1))
    assert set(exact.radii.values()) == {0.1 if known else None}
    result = adjust(exact, prior(start_deg), StochasticModel(model))
    np.testing.assert_allclose(np.degrees(result.boresight), 2.0, rtol=0, atol=1e-6)
    for found, place in zip(result.targets, CENTRES, strict=False):
        np.testing.assert_allclose(found.plane, [*place, 0.1], atol=1e-8)
        assert found.sphere
    assert result.rms_after < 1e-9


@pytest.mark.parametrize("seed", others_long(range(4)))
@pytest.mark.parametrize(
    ("known", "with_board", "start_deg"),
    [
        (True, False, 0.0),
        (True, True, 0.0),
        (False, True, 1.95),
    ],  # near the true angles, for the reason given above
)
def test_error_is_within_the_given_sigma(seed, known, with_board, start_deg):
    """The data have drifting POS errors and LiDAR noise, as in the model."""
    targets = [*three_balls(known), *(THESIS_BOARDS[1:] if with_board else ())]
    exact = error_free_survey(TRUTH, targets, six_courses(), 0.03, np.random.default_rng(seed))
    noisy = add_errors(exact, HYDROGRAPHIC_INS, np.random.default_rng(100 + seed))
    result = adjust(noisy, prior(start_deg), StochasticModel())
    error = result.boresight - TRUTH.boresight
    assert (np.abs(error) < 4.0 * result.sigma).all(), error / result.sigma
    assert np.degrees(result.sigma).max() < 0.05
    assert np.abs(error).max() > 0.0


# -- from a seed to a saved project ----------------------------------------------------------


@pytest.fixture(scope="module")
def balls(tmp_path_factory) -> BallSurvey:
    return make_ball_survey(tmp_path_factory.mktemp("balls"))


@pytest.fixture(scope="module")
def picked(balls) -> Project:
    """A project with three balls (the radius of the second is unknown) and the board."""
    project = balls.project
    for name, radius in (("S1", 0.15), ("S2", None), ("S3", 0.2)):
        project = picking.pick_target(
            project, balls.survey, balls.seed(name), name=name, shape="sphere", sphere_radius=radius
        )
    return picking.pick_target(project, balls.survey, balls.seed("board"), name="T1")


def test_mean_and_shift_on_a_ball_are_presented_positive_if_nearer_to_the_vessel() -> None:
    generator = np.random.default_rng(3)
    targets = [*three_balls(0.1), *THESIS_BOARDS[1:]]
    exact = error_free_survey(TRUTH, targets, six_courses(), 0.01, generator)
    data = add_errors(exact, HYDROGRAPHIC_INS, generator)
    own = data.sighting == 0
    points = data.points_lidar.copy()
    points[own] *= 1.0 - 0.03 / np.linalg.norm(points[own], axis=1, keepdims=True)
    clean, nearer = (
        sighting_values(adjust(each, prior(2.0), StochasticModel(surface=0.002)))[0]
        for each in (data, replace(data, points_lidar=points))
    )
    assert nearer.mean_after_m > clean.mean_after_m + 0.01
    assert nearer.shift_m > clean.shift_m + 0.01
    assert nearer.w > clean.w + 3.0


@LONG
def test_a_ball_is_picked_in_every_line(balls, picked):
    for name, (_, radius) in BALLS.items():
        target = picked.target(name)
        assert target.shape == "sphere"
        assert target.threshold == 0.03
        assert {s.line for s in target.sightings} == set(balls.survey.lines), target.missing
        spheres = picking.spheres_of(target, balls.survey)
        for sighting in target.sightings:
            on = balls.labels[sighting.line] == NAMES.index(name)
            assert on[sighting.indices].all()
            assert len(sighting.indices) > 0.85 * np.count_nonzero(on)
            patch = spheres[sighting.line]
            assert patch.sphere.radius == pytest.approx(radius, abs=0.003)
            points = balls.survey.clouds[sighting.line][sighting.indices]
            assert patch.share == visible_share(patch.sphere, points)


@pytest.mark.parametrize("board", others_long([False, True]))
def test_balls_determine_the_boresight_and_are_saved(balls, picked, board):
    project = picked if board else picked.without_target("T1")
    project = calibration.estimate(project, balls.survey, reselections=1, cross_check=False)
    assert project.result is not None
    error = np.degrees(project.result.boresight) - BORESIGHT_DEG
    assert (np.abs(error) < 4.0 * np.degrees(project.result.sigma)).all(), error
    assert np.abs(error).max() < 0.01
    found = {target.target: target for target in project.result.targets}
    for name, (centre, radius) in BALLS.items():
        np.testing.assert_allclose(found[name].plane, [*centre, radius], atol=0.001)
    assert [t.sphere for t in project.result.targets] == [True] * 3 + [False] * board
    save_project(project)
    again = open_project(project.folder)
    for ours, theirs in zip(project.targets, again.targets, strict=True):
        assert (theirs.shape, theirs.sphere_radius) == (ours.shape, ours.sphere_radius)
    assert again.result is not None
    np.testing.assert_array_equal(again.result.boresight, project.result.boresight)
    observations = calibration.observations_of(again, balls.survey)
    assert observations.radii == {"S1": 0.15, "S2": None, "S3": 0.2}


def test_a_line_can_have_its_own_seed(balls, picked):
    target = picked.target("S1")
    without_sighting = replace(
        target,
        sightings=tuple(s for s in target.sightings if s.line != "L3"),
        missing={"L3": note("finder.not_alike")},
    )
    project = picked.with_target(without_sighting)
    how = {"name": "S1", "line": "L3", "shape": "sphere"}
    seed = balls.seed("S1", "L3")
    found = picking.find_target(project, balls.survey, seed, sphere_radius=0.15, **how)
    assert [s.line for s in found.sightings] == list(balls.survey.lines)
    assert found.missing == {}
    with pytest.raises(ProjectError) as raised:
        picking.find_target(project, balls.survey, seed, **how)
    assert raised.value.code == "pick.other_radius"
    with pytest.raises(ProjectError) as raised:
        picking.find_target(project, balls.survey, seed, name="S1", line="L3")
    assert raised.value.code == "pick.is_sphere"


def test_a_wall_is_not_picked_as_a_ball(balls):
    with pytest.raises(SphereNotFound):
        picking.pick_target(
            balls.project, balls.survey, balls.seed("wall"), name="S9", shape="sphere"
        )


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ({"shape": "sphere", "role": "validation"}, "target.validation_sphere"),
        ({"shape": "plane", "sphere_radius": 0.1}, "target.plane_with_radius"),
        ({"shape": "sphere", "sphere_radius": 0.0}, "target.invalid_radius"),
        ({"shape": "sphere", "sphere_radius": float("nan")}, "target.invalid_radius"),
    ],
)
def test_invalid_import_options_are_refused(balls, options, code):
    with pytest.raises(ProjectError, check=lambda e: e.code == code):
        picking.pick_target(balls.project, balls.survey, balls.seed("S1"), name="S1", **options)


@pytest.mark.parametrize("wrong", [-0.1, 0.0, "plane"])
def test_a_project_edited_by_hand_is_checked(balls, picked, wrong):
    save_project(picked)
    path = balls.project.folder / PROJECT_FILE_NAME
    content = json.loads(path.read_text())
    content["targets"][0]["shape" if wrong == "plane" else "sphere_radius"] = wrong
    path.write_text(json.dumps(content))
    with pytest.raises(ProjectError, match="S1"):
        open_project(balls.project.folder)


@LONG
def test_the_command_line_picks_balls(balls, capsys):
    save_project(balls.project)
    words = ["pick", str(balls.project.folder), "--seed", *map(str, balls.seed("S1"))]
    words += ["--name", "S1"]
    assert main([*words, "--shape", "sphere", "--sphere-radius", "0.15", "--json"]) == 0
    picked = json.loads(capsys.readouterr().out)
    assert (picked["shape"], picked["sphere_radius_m"]) == ("sphere", 0.15)
    assert set(picked["lines"]) == set(balls.survey.lines)
    for line in picked["lines"].values():
        # Georeferenced without a boresight: an error of one degree at 15 m
        assert np.linalg.norm(np.array(line["centre_m"]) - BALLS["S1"][0]) < 0.5
        assert line["sphere_radius_m"] == 0.15
        assert 0.3 < line["visible_share"] < 0.5
    assert main([*words, "--shape", "sphere"]) == 0
    out = capsys.readouterr().out
    assert "Sphere in each line, radius estimated\n" in out
    rows = [line.split() for line in out.splitlines()]
    heads = ["Line", "East", "(m)", "North", "(m)", "Up", "(m)", "Radius", "(m)", "Surface", "seen"]
    start = rows.index(heads) + 1
    lines = list(balls.survey.lines)
    assert [row[0] for row in rows[start : start + len(lines)]] == lines
    assert all(0.14 < float(row[4]) < 0.16 for row in rows[start : start + len(lines)])
    assert open_project(balls.project.folder).target("S1").sphere_radius is None
    assert main([*words, "--sphere-radius", "0.1"]) == 2
    assert "--shape sphere" in capsys.readouterr().err
    assert main([*words, "--shape", "sphere", "--role", "validation"]) == 1
    assert is_shown("target.validation_sphere", capsys.readouterr().err)
