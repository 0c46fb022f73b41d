"""RMS of the distances between two dense noisy lines, by the number of points of a local plane.

``python -m tests.studies.surface_models`` prints the ratio of the RMS to the true one for an offset
of 21 mm, with and without CloudCompare's limit to the distance to the nearest point.
"""

from itertools import product

import numpy as np
from numpy.typing import NDArray

from lispac.validation.cloud_distance import cloud_to_cloud
from lispac.validation.local_models import LocalModel

OFFSET, SIDE = 0.021, 1.0
"""Distance between the lines and side of the square they observe, metres."""
DENSITIES, NOISES = (500.0, 2000.0, 10_000.0, 40_000.0), (0.002, 0.005)
"""Points per square metre, and sigmas of each coordinate, metres."""
PROFILE_RATIOS = (1.0, 5.0, 20.0)
"""Distance between profiles divided by that between points of a profile."""
COUNTS = (6, 12, 20, 40, 80)
"""Numbers of points of a plane."""


def line(
    rng: np.random.Generator, density: float, ratio: float, noise: float, height: float
) -> NDArray[np.float64]:
    """Points of a line on a horizontal square, shape (n, 3), metres."""
    along, across = 1.0 / np.sqrt(density * ratio), np.sqrt(ratio / density)
    x, y = np.meshgrid(
        np.arange(0.0, SIDE, along), np.arange(rng.uniform(0.0, across), SIDE, across)
    )
    points = np.column_stack([x.ravel(), y.ravel(), np.full(x.size, height)])
    points[:, 0] += rng.uniform(0.0, along, x.size)
    points[:, 1] += 0.05 * across * rng.standard_normal(x.size)
    return points + noise * rng.standard_normal(points.shape)


def main() -> None:
    """Print a row for each density, ratio and noise."""
    rng = np.random.default_rng(1)
    ratios: dict[tuple[int, bool], list[float]] = {}
    for density, ratio, noise in product(DENSITIES, PROFILE_RATIOS, NOISES):
        compared = line(rng, density, ratio, noise, 0.0)
        reference = line(rng, density, ratio, noise, OFFSET)
        for count, limited in product(COUNTS, (True, False)):
            distances = cloud_to_cloud(
                compared, reference, model=LocalModel("plane", count), up_to_nearest=limited
            )
            rms = float(np.sqrt(np.mean(distances**2)))
            ratios.setdefault((count, limited), []).append(rms / float(np.hypot(OFFSET, noise)))
        row = " ".join(f"{ratios[count, False][-1]:.2f}" for count in COUNTS)
        print(f"{density:8.0f} {ratio:4.0f} {noise:.3f}   {row}")
    for (count, limited), found in ratios.items():
        limit = "with limit" if limited else "without limit"
        print(f"{count:3d} points {limit:13s}: {min(found):.2f} to {max(found):.2f}")


if __name__ == "__main__":
    main()
