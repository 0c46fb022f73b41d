"""Tests of searches for targets and surfaces that match no object or several objects."""

import numpy as np
import pytest

from lispac.errors import InputError, SphereNotFound, TargetNotFound
from lispac.geometry.spheres import fit_sphere
from lispac.messages import note
from lispac.natural.flat_regions import Regions
from lispac.natural.line_planes import LinePlanes
from lispac.natural.patches import is_water
from lispac.patchtest import mismatch_minimisation
from lispac.patchtest.line_mismatch import Mismatch
from lispac.patchtest.object_boxes import ObjectBox, object_of_box
from lispac.patchtest.object_sample import ObjectSample
from lispac.survey.georeferencing import Mounting
from lispac.survey.trajectory import Poses
from lispac.targets.cloud_shift import CloudShift, find_shifts
from lispac.targets.expected_target import ExpectedTarget, deviations_from_expected
from lispac.targets.finder_settings import FinderSettings
from lispac.targets.line_search import WeightedSurroundings, best_match, find_shifts_into_line
from lispac.targets.planes_across_lines import find_in_lines
from lispac.targets.sphere_finder import RadiusRange, SpherePatch, find_sphere
from lispac.targets.sphere_ransac import draw_spheres
from lispac.targets.spheres_across_lines import _two_spheres_error, find_spheres_in_lines
from tests.support.error_codes import has_code


def test_an_unknown_inclination_is_not_compared() -> None:
    upright, size = np.array([0.0, 1.0, 0.0]), np.array([1.2, 1.0])
    assert deviations_from_expected(ExpectedTarget(1.2, 1.0), size, upright) == ()
    assert deviations_from_expected(ExpectedTarget(1.2, 1.0, np.radians(45.0)), size, upright) == (
        note("quality.steeper", tilt=np.pi / 2, off=np.pi / 4, expected=np.pi / 4),
    )


def _cube(seed: int, off: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-0.5, 0.5, (400, 3)) + off


def test_clouds_too_far_apart_have_no_shift() -> None:
    first = _cube(1)
    assert find_shifts(first, np.ones(400), _cube(1, (30.0, 0.0, 0.0)), 0.5) == []
    (found, *_) = find_shifts(first, np.ones(400), first + [0.2, 0.0, 0.0], 0.5)
    np.testing.assert_allclose(found.vector, [0.2, 0.0, 0.0], atol=0.05)


def test_a_line_without_similar_surroundings_is_reported() -> None:
    """Points are within the search radius, but none where the target could have moved."""
    settings = FinderSettings(radius=2.0, max_shift=0.3)
    reference = WeightedSurroundings(_cube(1), np.ones(400))
    for off, code in (
        ((0.0, 1.7, 0.0), "finder.not_alike"),
        ((9.0, 0.0, 0.0), "finder.line_no_points"),
    ):
        with pytest.raises(TargetNotFound, check=has_code(code)):
            find_shifts_into_line(_cube(2, off), None, reference, np.zeros(3), settings)


def test_two_contradicting_matches_are_refused() -> None:
    shifts = [CloudShift(np.array([k, 0.0, 0.0]), 0.9) for k in (0.0, 1.0)]

    def match(shift: CloudShift) -> tuple[str, float]:
        return f"at {shift.vector[0]:g}", 0.9

    def contradiction(best: str, other: str) -> str | None:
        return f"{best} or {other}"

    with pytest.raises(TargetNotFound, match=r"^at 0 or at 1$"):
        best_match(shifts, match, contradiction)
    assert best_match(shifts, match, lambda best, other: None) == "at 0"
    assert best_match(shifts[:1], match, contradiction) == "at 0"


def _ball(centre: tuple[float, float, float], radius: float = 0.15) -> np.ndarray:
    """Return points of the half of a ball that is visible from the east."""
    away = np.random.default_rng(3).normal(size=(3000, 3))
    away /= np.linalg.norm(away, axis=1, keepdims=True)
    return centre + radius * away[away[:, 1] < -0.2]


def _balls(second: np.ndarray) -> dict[str, str]:
    clouds = {"L1": _ball((0.0, 15.0, 5.0)), "L2": second}
    found, missing = find_spheres_in_lines(
        clouds,
        np.array([0.0, 15.0, 5.0]),
        RadiusRange(0.1, 0.5),
        FinderSettings(),
        first_line="L1",
    )
    assert set(found) | set(missing) == {"L1", "L2"}
    return missing


def test_two_equal_balls_near_the_target_are_ambiguous() -> None:
    assert _balls(_ball((0.4, 15.0, 5.0))) == {}
    similar = np.vstack([_ball((0.6, 15.0, 5.0)), _ball((-0.6, 15.0, 5.0))])
    (reason,) = _balls(similar).values()
    assert reason.code == "finder.two_spheres"
    assert reason.params["distance"] == pytest.approx(1.2, abs=0.01)


def test_a_ball_of_another_size_is_not_the_target() -> None:
    (reason,) = _balls(_ball((0.0, 15.0, 5.0), 0.4)).values()
    assert reason.code == "finder.radius_differs"
    assert reason.params["radius"] == pytest.approx(0.4, abs=0.002)
    assert reason.params["expected"] == pytest.approx(0.15, abs=0.002)


def test_the_same_ball_found_twice_is_no_contradiction() -> None:
    def found(centre: tuple[float, float, float]) -> SpherePatch:
        return find_sphere(_ball(centre), np.array(centre), RadiusRange(0.1, 0.5), FinderSettings())

    here = found((0.0, 15.0, 5.0))
    assert _two_spheres_error(here, found((0.02, 15.0, 5.0))) is None
    message = _two_spheres_error(here, found((0.5, 15.0, 5.0)))
    assert message is not None
    assert message.code == "finder.two_spheres"
    assert message.params["distance"] == pytest.approx(0.5, abs=0.005)


def test_points_in_a_plane_determine_no_ball() -> None:
    level = np.random.default_rng(1).uniform(-5.0, 5.0, (300, 3)) * [1.0, 1.0, 0.0]
    assert draw_spheres(level, np.ones(300), 0.05, 0.5, FinderSettings()) == []


def _board(centre: tuple[float, float, float]) -> np.ndarray:
    """Return points of a board of one square metre that faces east."""
    rng = np.random.default_rng(5)
    flat = rng.uniform(-0.5, 0.5, (2500, 2))
    return np.column_stack([flat[:, 0], rng.normal(0.0, 0.002, 2500), flat[:, 1]]) + centre


def test_two_equal_boards_at_different_depths_are_ambiguous() -> None:
    place = (0.0, 15.0, 5.0)
    similar = np.vstack([_board((0.8, 15.2, 5.0)), _board((-0.8, 14.8, 5.0))])
    _, missing = find_in_lines(
        {"L1": _board(place), "L2": similar}, np.array(place), FinderSettings(), first_line="L1"
    )
    assert set(missing) == {"L2"}
    assert missing["L2"].code == "finder.two_planes"
    assert missing["L2"].params["distance"] == pytest.approx(1.65, abs=0.01)


def test_a_tiny_part_of_a_ball_does_not_determine_its_position() -> None:
    """Four points 0.1 micrometres apart on a ball with a radius of 1 m."""
    speck = 1e-7 * np.array([(0.0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 1e-3)])
    with pytest.raises(SphereNotFound, check=has_code("target.sphere_small_part")):
        fit_sphere(speck, 1.0)


# -- surfaces of the scene -------------------------------------------------------------------


def test_a_scene_without_surfaces_has_no_region() -> None:
    leaves = np.random.default_rng(1).uniform(0.0, 2.0, (600, 3))
    found = Regions.of(leaves, 0.02)
    assert found.count == 0
    np.testing.assert_array_equal(found.at(leaves[:5]), np.full(5, -1))


def test_no_planes_contain_no_water() -> None:
    fields = dict.fromkeys(LinePlanes.__dataclass_fields__, np.zeros(0))
    none = LinePlanes(**{**fields, "centre": np.zeros((0, 3)), "normal": np.zeros((0, 3))})
    assert is_water(none).shape == (0,)
    assert is_water(none).dtype == bool


@pytest.mark.parametrize(
    ("centre", "size", "code"),
    [
        ([0.0, np.nan, 0.0], [1.0, 1.0, 1.0], "patch_test.box_not_finite"),
        ([0.0, 0.0, 0.0], [1.0, 0.0, 1.0], "patch_test.box_size"),
    ],
)
def test_an_invalid_box_is_refused(centre: list, size: list, code: str) -> None:
    with pytest.raises(InputError, check=has_code(code, name="mast")):
        object_of_box("mast", ObjectBox(np.array(centre), np.array(size)))
    sound = ObjectBox(np.zeros(3), np.ones(3))
    assert object_of_box("mast", sound).box is sound


# -- the patch test --------------------------------------------------------------------------

EMPTY_SAMPLE = ObjectSample(
    (), np.zeros((0, 3)), Poses(np.zeros((0, 3)), np.zeros((0, 3))),
    Mounting(np.zeros(3), np.zeros(3)),
)  # fmt: skip


def test_lines_without_overlap_have_no_mismatch() -> None:
    mismatch = Mismatch(EMPTY_SAMPLE, ())
    assert np.isnan(mismatch(np.zeros(3)))
    assert np.isnan(mismatch.mismatch_curve(np.zeros(3), 0, np.radians([-1.0, 1.0]))).all()


def test_angles_that_never_converge_are_reported(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Every step is one degree, so the maximum number of steps is taken."""
    monkeypatch.setattr(
        mismatch_minimisation, "_angle_step", lambda _, __, turned: np.radians(np.ones(len(turned)))
    )
    found = mismatch_minimisation.minimise_mismatch(EMPTY_SAMPLE, (), np.zeros(3), (0, 2))
    assert not found.converged
    steps = mismatch_minimisation.MAX_STEPS * len(mismatch_minimisation.LOSS_SCALES)
    np.testing.assert_allclose(np.degrees(found.boresight), [steps, 0.0, steps])
    angle_by_angle = mismatch_minimisation.minimise_angle_by_angle(EMPTY_SAMPLE, (), np.zeros(3))
    assert (angle_by_angle.iterations, angle_by_angle.converged) == (
        mismatch_minimisation.MAX_ITERATIONS,
        False,
    )
    np.testing.assert_allclose(
        np.degrees(angle_by_angle.boresight), [mismatch_minimisation.MAX_ITERATIONS] * 3
    )
