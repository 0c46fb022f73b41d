"""Tests of the comparison of the extent of a target between lines."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.geometry.planes import fit_plane
from lispac.gui.features.pick_targets.sightings_table import quality_text
from lispac.project import Project
from lispac.targets.occlusion import ObservedExtent, compare_observed_extents, does_plane_end_within
from lispac.targets.sighting_quality import plane_quality
from lispac.workflow.calibration.sighting_assessment import assess_sightings, assess_target
from lispac.workflow.project.survey import Survey
from tests.support.message_codes import codes
from tests.targets.test_quality import NOISE


def board_points(
    *, wide: tuple[float, float] = (-0.6, 0.6), high: tuple[float, float] = (-0.5, 0.5),
    beside: float = 0.0, seed: int = 0,
) -> np.ndarray:  # fmt: skip
    """Return points of a board 20 m to the west, cut to the given edges, moved by ``beside``."""
    rng = np.random.default_rng(seed)
    north, up = rng.uniform(*np.transpose([wide, high]), (2000, 2)).T
    return np.stack([north + beside, 20.0 + rng.normal(0, NOISE, 2000), up], axis=1)


def shares(*sightings: np.ndarray, apart: float = 0.05) -> list[ObservedExtent]:
    found = compare_observed_extents(sightings, [True] * len(sightings), apart)
    assert all(each is not None for each in found)
    return [each for each in found if each is not None]


def test_equal_extents_have_a_full_share():
    for each in shares(*(board_points(seed=k, beside=0.02 * k) for k in range(4))):
        assert each.share > 0.98
        assert not each.is_far_larger
        np.testing.assert_allclose(each.size, [1.2, 1.0], atol=0.01)
        np.testing.assert_allclose(each.size_in_others, [1.2, 1.0], atol=0.01)


def test_half_a_board_has_half_the_share_despite_an_offset():
    half, whole = shares(board_points(wide=(0.0, 0.6), beside=0.3), board_points())
    assert half.share == pytest.approx(0.5, abs=0.01)
    assert half.message.code == "quality.shows_less"
    assert half.message.params["share"] == pytest.approx(0.5, abs=0.01)
    assert codes(half.message.params["sides"]) == ["quality.width_of"]
    assert whole.share > 0.999


def test_a_quarter_is_reported_in_width_and_height():
    quarter, _ = shares(board_points(wide=(0.0, 0.6), high=(-0.5, 0.0)), board_points())
    assert quarter.share == pytest.approx(0.25, abs=0.01)
    assert codes(quarter.message.params["sides"]) == ["quality.width_of", "quality.height_of"]


def test_extents_of_several_lines_are_joined():
    """A post hides the middle: one line shows the left part, another one the right part."""
    left, right, middle = shares(
        board_points(wide=(-0.6, 0.0)),
        board_points(wide=(0.0, 0.6)),
        board_points(wide=(-0.1, 0.1)),
        apart=0.01,
    )
    assert middle.share == pytest.approx(0.2 / 1.18, abs=0.01)
    # The other two lines show -0.1 to 0.6 m together, less twice the separation.
    assert left.share == pytest.approx(0.6 / 0.68, abs=0.01)
    assert right.share == left.share or right.share == pytest.approx(left.share, abs=0.02)


def test_an_extent_larger_than_on_several_other_lines_is_reported():
    """One sighting extends beyond the edge; the other lines are not occluded."""
    grown, *others = shares(
        board_points(wide=(-0.6, 1.8)), *(board_points(seed=k) for k in range(1, 5))
    )
    assert grown.is_far_larger
    assert grown.message.code == "quality.shows_more"
    assert grown.message.params["sides"][0].code == "quality.width_alone"
    assert all(each.share > 0.98 and not each.is_far_larger for each in others)
    assert shares(board_points(wide=(-0.6, 1.8)), board_points())[1].share == pytest.approx(
        0.5, abs=0.01
    )


def test_only_used_sightings_are_compared():
    points = [board_points(wide=(0.0, 0.6)), board_points()]
    assert compare_observed_extents(points, [True, False], 0.05)[0] is None
    assert compare_observed_extents(points, [False, True], 0.05)[0].share < 0.51
    assert compare_observed_extents(points[:1], [True], 0.05) == (None,)


@pytest.mark.parametrize(("part", "rating"), [(0.75, "good"), (0.6, "doubtful"), (0.4, "poor")])
def test_rating_limits_of_the_visible_share(part, rating):
    points = board_points(wide=(0.0, 1.2 * part))
    (shown, _) = shares(points, board_points())
    quality = plane_quality(
        points, points, np.arange(len(points)), fit_plane(points), NOISE, observed_extent=shown
    )
    assert quality.rating == rating
    assert quality.visible_share == pytest.approx(part, abs=0.01)
    assert ("quality.shows_less" in codes(quality.reasons)) == (rating != "good")
    assert f"{100 * shown.share:.0f} % of the extent in the other lines" in quality_text(quality)


def test_a_wall_cut_by_the_search_radius_is_not_compared():
    assert does_plane_end_within(2.0, [np.array([1.23, 1.22]), np.array([0.6, 1.22])])
    assert not does_plane_end_within(2.0, [np.array([3.9, 1.2]), np.array([0.6, 1.2])])


def narrowed(project: Project, survey: Survey, name: str, line: str) -> Project:
    """Return the project with one sighting reduced to the northern half of its points."""
    target = project.target(name)
    sighting = target.sighting(line)
    north = survey.clouds[line][sighting.indices][:, 0]
    half = replace(sighting, indices=sighting.indices[north > np.median(north)])
    return project.with_target(
        replace(target, sightings=tuple(half if s.line == line else s for s in target.sightings))
    )


def test_a_halved_sighting_of_the_demo_is_reported(
    denser_calibrated: tuple[Project, Survey],
) -> None:
    project, survey = denser_calibrated
    project = replace(project, result=None)
    line = project.target("T1").sightings[0].line
    whole = assess_sightings(project, survey)
    assert whole["T1", line].quality.visible_share > 0.95
    assert whole["V5", line].quality.visible_share is None  # cut by the search radius
    half = narrowed(project, survey, "T1", line)
    assessed = assess_sightings(half, survey, known=whole)
    quality = assessed["T1", line].quality
    assert quality.rating != "good"
    assert "quality.shows_less" in codes(quality.reasons)
    # The other sightings are assessed again, because their reference has changed.
    assert all(each is not whole[key] for key, each in assessed.items() if key[0] == "T1")
    assert all(each is whole[key] for key, each in assessed.items() if key[0] != "T1")
    # Without other sightings there is no comparison.
    target = half.target("T1")
    alone = replace(
        target, sightings=tuple(replace(s, used=s.line == line) for s in target.sightings)
    )
    assert assess_target(half, survey, alone)[line].visible_share is None
