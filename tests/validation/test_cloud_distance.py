"""Tests of cloud-to-cloud distances against a brute-force reference and CloudCompare."""

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from lispac.errors import Cancelled, InputError
from lispac.message_texts import english_text
from lispac.progress import Step
from lispac.validation.cloud_distance import cloud_to_cloud
from lispac.validation.local_models import NEAREST_POINT_MODEL, SIX_POINT_PLANE, LocalModel
from lispac.value_conversion import decode_value, encode_value
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG

Array = NDArray[np.float64]


def brute_force(compared: Array, reference: Array, model: LocalModel = SIX_POINT_PLANE) -> Array:
    """Distances by their definition, point by point and without a search structure."""
    distances = np.empty(len(compared))
    for i, point in enumerate(compared):
        to_point = np.linalg.norm(reference - point, axis=1)
        nearest = reference[np.argmin(to_point)]
        away = np.linalg.norm(reference - nearest, axis=1)
        group = reference[np.argsort(away, kind="stable")[: model.neighbours]]
        if model.radius is not None:
            group = reference[away <= model.radius]
        distances[i] = to_point.min()
        if len(group) < 3:
            continue
        values, vectors = np.linalg.eigh(np.cov(group.T))
        if values[1] <= 1e-12 * values[2]:
            continue
        h, y, x = ((group - group.mean(axis=0)) @ vectors).T
        h_of, y_of, x_of = (point - group.mean(axis=0)) @ vectors
        if model.kind == "quadric":
            if len(group) < 6:
                continue
            terms = np.column_stack((np.ones_like(x), x, y, x * x, x * y, y * y))
            bent, _, rank, _ = np.linalg.lstsq(terms, h, rcond=1e-9)
            if rank < 6:
                continue
            h_of -= bent @ [1, x_of, y_of, x_of * x_of, x_of * y_of, y_of * y_of]
        distances[i] = min(distances[i], abs(h_of))
    return distances


def tower(n: int, seed: int, offset: float = 0.0) -> Array:
    """Noisy points on the four walls of a tower, 6 x 6 x 40 m, each wall moved outwards."""
    rng = np.random.default_rng(seed)
    wall, along, height = rng.integers(0, 4, n), rng.uniform(0, 6, n), rng.uniform(0, 40, n)
    depth = rng.normal(offset, 0.005, n)
    x = np.choose(wall, [along, along, -depth, 6 + depth])
    y = np.choose(wall, [-depth, 6 + depth, along, along])
    return np.column_stack((x, y, height))


@LONG
def test_distances_agree_with_brute_force_on_a_surface_and_in_a_volume() -> None:
    rng = np.random.default_rng(5)
    for compared, reference in (
        (tower(1500, 1, 0.02), tower(3000, 2)),
        (rng.uniform(0, 1, (1500, 3)), rng.uniform(0, 1, (2000, 3))),
    ):
        expected = brute_force(compared, reference)
        np.testing.assert_allclose(cloud_to_cloud(compared, reference), expected, atol=1e-9)


MODELS = [
    LocalModel("plane", 12),
    LocalModel("plane", radius=0.8),
    LocalModel("quadric", 12),
    LocalModel("quadric", radius=1.2),
]


@pytest.mark.parametrize("model", MODELS, ids=lambda model: english_text(model.name))
def test_distances_of_other_models_agree_with_brute_force(model: LocalModel) -> None:
    compared, reference = tower(700, 1, 0.02), tower(3000, 2)
    np.testing.assert_allclose(
        cloud_to_cloud(compared, reference, model=model),
        brute_force(compared, reference, model),
        atol=1e-9,
    )


def test_a_quadric_is_more_accurate_than_a_plane_on_a_curved_surface() -> None:
    """On a cylinder of 0.5 m radius, planes through sparse points lie inside the surface."""
    rng = np.random.default_rng(4)

    def pole(n: int, radius: float) -> Array:
        turn, height = rng.uniform(0, 2 * np.pi, n), rng.uniform(0, 3, n)
        return np.column_stack((radius * np.cos(turn), radius * np.sin(turn), height))

    compared, reference = pole(3000, 0.51), pole(6000, 0.5)
    bent = cloud_to_cloud(compared, reference, model=LocalModel("quadric", 20))
    cut = cloud_to_cloud(compared, reference, model=LocalModel("plane", 20))
    assert np.median(bent) == pytest.approx(0.01, abs=0.0002)
    assert np.median(cut) > 0.0115


def test_a_model_survives_json() -> None:
    for model in (*MODELS, NEAREST_POINT_MODEL, SIX_POINT_PLANE):
        assert decode_value(encode_value(model), LocalModel) == model


def test_distances_agree_with_brute_force_for_duplicate_points() -> None:
    reference = tower(1000, 2)
    reference = np.vstack((reference, reference[:400], reference[:100], reference[:3].repeat(8, 0)))
    compared = np.vstack((tower(500, 1), reference[:50]))
    np.testing.assert_allclose(
        cloud_to_cloud(compared, reference), brute_force(compared, reference), atol=1e-9
    )


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5])
def test_distances_agree_with_brute_force_for_few_reference_points(count: int) -> None:
    reference, compared = tower(count, 2), tower(100, 1)
    np.testing.assert_allclose(
        cloud_to_cloud(compared, reference), brute_force(compared, reference), atol=1e-9
    )


def test_more_points_than_one_chunk_keep_their_order() -> None:
    compared, reference = tower(120_000, 1, 0.01), tower(60_000, 2)
    some = np.arange(0, 120_000, 997)
    np.testing.assert_allclose(
        cloud_to_cloud(compared, reference)[some],
        brute_force(compared[some], reference),
        atol=1e-9,
    )


def test_the_nearest_point_model_gives_point_distances() -> None:
    compared, reference = tower(300, 1, 0.05), tower(500, 2)
    nearest = np.linalg.norm(compared[:, None] - reference[None], axis=2).min(axis=1)
    alone = cloud_to_cloud(compared, reference, model=NEAREST_POINT_MODEL)
    np.testing.assert_allclose(alone, nearest, atol=1e-12)
    assert np.all(cloud_to_cloud(compared, reference) <= alone)
    assert np.mean(cloud_to_cloud(compared, reference)) < 0.9 * np.mean(alone)


def test_points_on_one_straight_line_determine_no_plane() -> None:
    row = np.column_stack((np.linspace(0, 1, 50), np.zeros(50), np.zeros(50)))
    distances = cloud_to_cloud(row + np.array([0.0, 0.3, 0.4]), row)
    np.testing.assert_allclose(distances, 0.5, atol=1e-12)


def test_large_coordinates_lose_no_precision() -> None:
    compared, reference = tower(500, 1, 0.01), tower(2000, 2)
    shift = np.array([500_000.0, 5_040_000.0, 100.0])
    # Shifted coordinates have a precision of a nanometre; the distances must be as precise.
    rounded, rounded_reference = (compared + shift) - shift, (reference + shift) - shift
    np.testing.assert_allclose(
        cloud_to_cloud(compared + shift, reference + shift),
        cloud_to_cloud(rounded, rounded_reference),
        atol=1e-8,
    )


def test_points_beyond_the_maximum_distance_have_no_distance() -> None:
    reference = tower(2000, 2)
    near, far = tower(50, 1), tower(50, 3) + np.array([100.0, 0.0, 0.0])
    distances = cloud_to_cloud(np.vstack((near, far)), reference, max_distance=2.0)
    np.testing.assert_array_equal(distances[:50], cloud_to_cloud(near, reference))
    assert np.isnan(distances[50:]).all()


def test_without_compared_points_there_are_no_distances() -> None:
    assert cloud_to_cloud(np.empty((0, 3)), tower(10, 1)).shape == (0,)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
@pytest.mark.parametrize("which", ["compared", "reference"])
def test_points_that_are_not_finite_are_refused(bad: float, which: str) -> None:
    clouds = {"compared": tower(20, 1), "reference": tower(20, 2)}
    clouds[which][7, 1] = bad
    with pytest.raises(
        InputError, check=has_code(f"validation.{which}_not_finite", count=1, total=20)
    ):
        cloud_to_cloud(clouds["compared"], clouds["reference"])


def test_invalid_arrays_and_settings_are_refused() -> None:
    cloud = tower(20, 1)
    with pytest.raises(InputError, check=has_code("validation.empty_reference")):
        cloud_to_cloud(cloud, np.empty((0, 3)))
    with pytest.raises(InputError, check=has_code("validation.compared_shape")):
        cloud_to_cloud(cloud[:, :2], cloud)
    with pytest.raises(
        InputError, check=has_code("validation.model_neighbours", kind="plane", needed=3)
    ):
        LocalModel("plane", 2)
    with pytest.raises(
        InputError, check=has_code("validation.model_neighbours", kind="quadric", needed=6)
    ):
        LocalModel("quadric", 5)
    with pytest.raises(InputError, check=has_code("validation.model_radius", kind="plane")):
        LocalModel(radius=0.0)
    with pytest.raises(InputError, check=has_code("validation.max_distance")):
        cloud_to_cloud(cloud, cloud, max_distance=0.0)


def test_the_computation_reports_progress_and_can_be_cancelled() -> None:
    fractions: list[float] = []

    def listen(fraction: float, step: Step | None = None) -> None:
        fractions.append(fraction)

    cloud = tower(110_000, 1)
    cloud_to_cloud(cloud, cloud, progress=listen)
    assert fractions == sorted(fractions)
    assert fractions[-1] == pytest.approx(1.0)
    assert len(fractions) > 2

    def cancel(fraction: float, step: Step | None = None) -> None:
        if fraction > 0.3:
            raise Cancelled

    with pytest.raises(Cancelled):
        cloud_to_cloud(cloud, cloud, progress=cancel)


def by_cloudcompare(program: str, folder: Path, clouds: dict[str, Array], *model: str) -> Array:
    """CloudCompare's distances (n,), in the order of the compared points.

    CloudCompare holds coordinates in single precision: 4 micrometres at 40 m.
    """
    for name, points in clouds.items():
        np.savetxt(folder / f"{name}.asc", points, fmt="%.9g")
    subprocess.run(
        [program, "-SILENT", "-C_EXPORT_FMT", "ASC", "-PREC", "9", "-NO_TIMESTAMP",
         "-O", "compared.asc", "-O", "reference.asc", "-C2C_DIST", *model],
        cwd=folder,
        env=os.environ | {"QT_QPA_PLATFORM": "offscreen", "XDG_RUNTIME_DIR": str(folder)},
        check=True,
        capture_output=True,
        timeout=60,
    )  # fmt: skip
    theirs = np.loadtxt(folder / "compared_C2C_DIST.asc")
    np.testing.assert_allclose(theirs[:, :3], clouds["compared"], atol=1e-6)
    return np.asarray(theirs[:, 3])


def single(**clouds: Array) -> dict[str, Array]:
    return {name: points.astype(np.float32).astype(np.float64) for name, points in clouds.items()}


COMMANDS = {
    NEAREST_POINT_MODEL: (),
    SIX_POINT_PLANE: ("-MODEL", "LS", "KNN", "6"),
    LocalModel("plane", 12): ("-MODEL", "LS", "KNN", "12"),
    LocalModel("plane", radius=0.5): ("-MODEL", "LS", "SPHERE", "0.5"),
}


@pytest.mark.parametrize("model", COMMANDS, ids=lambda model: english_text(model.name))
def test_distances_agree_with_cloudcompare(
    model: LocalModel, cloudcompare: str, tmp_path: Path
) -> None:
    clouds = single(compared=tower(20_000, 1, 0.01), reference=tower(20_000, 2))
    theirs = by_cloudcompare(cloudcompare, tmp_path, clouds, *COMMANDS[model])
    ours = cloud_to_cloud(clouds["compared"], clouds["reference"], model=model)
    np.testing.assert_allclose(ours.mean(), theirs.mean(), atol=1e-6)
    np.testing.assert_allclose(ours.std(), theirs.std(), atol=1e-6)
    difference = np.abs(ours - theirs)
    # Neighbours at the same distance in single precision may swap, which changes a few planes.
    assert np.quantile(difference, 0.999) < 1e-5
    assert difference.max() < 0.02


def test_quadrics_agree_with_cloudcompare(cloudcompare: str, tmp_path: Path) -> None:
    """On a nearly level sheet, where the height along the normal is that along an axis.

    CloudCompare stops its solver (conjugate gradients from the plane on) before the least squares
    are reached: with 6 points, through which a quadric goes exactly, its distances scatter as those
    to a plane do. With 40 the two differ by a tenth of the noise at most points.
    """
    rng = np.random.default_rng(6)

    def sheet(n: int, lift: float) -> Array:
        x, y = rng.uniform(0, 4, (2, n))
        return np.column_stack((x, y, lift + 0.02 * np.sin(2 * x) + rng.normal(0, 0.001, n)))

    clouds = single(compared=sheet(10_000, 0.01), reference=sheet(10_000, 0.0))
    theirs = by_cloudcompare(cloudcompare, tmp_path, clouds, "-MODEL", "HF", "KNN", "40")
    ours = cloud_to_cloud(clouds["compared"], clouds["reference"], model=LocalModel("quadric", 40))
    np.testing.assert_allclose(ours.mean(), theirs.mean(), rtol=2e-3)
    np.testing.assert_allclose(ours.std(), theirs.std(), rtol=2e-2)
    assert np.median(np.abs(ours - theirs)) < 1e-4
