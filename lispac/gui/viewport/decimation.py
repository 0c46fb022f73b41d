"""Random selection of the points of large lines that are drawn, within a budget of points.

While the camera moves, a coarse sample of each line is drawn. At rest, the drawn points are
selected from all points in view, so that a close view shows every point.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.gui.viewport.camera import Camera, ViewportSize

Array = NDArray[np.float64]

CHUNK_POINTS = 1 << 14
"""Number of points processed at a time, whose intermediate results fit in the processor cache."""


@dataclass(frozen=True)
class Budget:
    """Largest total number of drawn points, at rest and while the camera moves.

    Fewer points are drawn if drawing takes too long.
    """

    resting: int = 1_000_000
    moving: int = 250_000


def line_budgets(counts: Mapping[str, int], budget: int) -> dict[str, int]:
    """Number of points for each line, in proportion to its size, at least one.

    All points are drawn if their total is within the budget.
    """
    total = sum(counts.values())
    if total <= budget:
        return dict(counts)
    return {name: min(n, max(1, n * budget // total)) for name, n in counts.items()}


def random_ranks(count: int) -> NDArray[np.float32]:
    """Random ranks from 0 to 1 of ``count`` points.

    The ranks depend on the number only, so that the same points are drawn before and after. Points
    are selected at random, since every n-th point would form stripes with the scanner profiles.
    """
    return np.random.default_rng(count).random(count, dtype=np.float32)


def lowest_ranked(ranks: NDArray[np.float32], number: int) -> NDArray[np.int64]:
    """Indices, ascending, of the ``number`` points of lowest rank."""
    # A smaller number gives a subset, so that points do not flicker when the number changes
    count = len(ranks)
    if number >= count:
        return np.arange(count)
    # Ranks are uniformly distributed, so a threshold excludes nearly all points at once.
    chosen = np.flatnonzero(ranks < (number + 6.0 * np.sqrt(number) + 6.0) / count)
    if len(chosen) < number:
        chosen = np.arange(count)
    if len(chosen) > number:
        last = np.partition(ranks[chosen], number - 1)[number - 1]
        chosen = chosen[ranks[chosen] <= last][:number]
    return chosen


def points_in_view(points: Array, camera: Camera, size: ViewportSize) -> NDArray[np.int64]:
    """Indices of the points (n, 3) in the picture, with a margin of a tenth."""
    half = 0.55 * np.array([size.width, size.height]) / size.pixels_per_tangent
    axes, shift = camera.axes.T, camera.axes @ camera.position
    found = []
    for start in range(0, len(points), CHUNK_POINTS):
        xyz = points[start : start + CHUNK_POINTS] @ axes - shift
        reach = camera.scale_depth(xyz[:, 2])
        inside = (np.abs(xyz[:, 0]) <= half[0] * reach) & (np.abs(xyz[:, 1]) <= half[1] * reach)
        found.append(np.flatnonzero(inside) + start)
    return np.concatenate(found) if found else np.empty(0, np.int64)


def trimmed_points(points: Array, percent: float = 0.05) -> Array:
    """Points without the outermost ``percent`` on each side of each axis.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres

    Returns
    -------
    ndarray of shape (m, 3)
        All points if there are fewer than 100, since percentiles are then meaningless.
    """
    if len(points) < 100:
        return points
    low, high = np.percentile(points, [percent, 100.0 - percent], axis=0)
    inside = np.all((points >= low) & (points <= high), axis=1)
    return points[inside] if inside.any() else points
