"""K-d tree of points in space, for the nearest points of many places.

SciPy's k-d tree has the same results. This one is limited to three coordinates and compiled for
them, and stores its points in the order of its leaves; building it takes half the time and a search
a quarter (``tests/benchmarks/bench_cloud_distance.py``).
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lispac.compiled_code import njit

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

_LEAF_POINTS = 12
"""Largest number of points in a leaf, except for points that coincide."""
RELATIVE_MARGIN, SMALLEST_MARGIN = 1e-9, 1e-300
"""Share and length, squared metres, by which a bound of squared distances is increased: its terms
are rounded, and points at the bound itself are not found."""


_NODE = np.dtype(
    [("axis", "i8"), ("low", "f8"), ("high", "f8"),
     ("first", "i8"), ("last", "i8"), ("upper", "i8")]
)  # fmt: skip
"""Node of a tree; the next one is its lower part. Fields: coordinate at which it is divided, -1 for
a leaf; largest coordinate of the lower part and smallest of the upper part; range of its points;
index of the upper part."""
Nodes = NDArray[np.void]


class PointTree:
    """K-d tree of a cloud.

    The box around the points of a node is divided at the centre of its longest side (midpoint
    rule: Maneewongvatana and Mount 1999), as in SciPy's unbalanced tree.

    Parameters
    ----------
    points : array of shape (n, 3), metres, any frame

    Attributes
    ----------
    points : ndarray of shape (n, 3), metres
        Copy of the points, ordered so that points that are close in space are close in memory.
    order : ndarray of shape (n,), int64
        Index in the given array of each of ``points``.

    Raises
    ------
    ValueError
        If the array has another shape or contains NaN or infinity.
    """

    def __init__(self, points: ArrayLike) -> None:
        given = _finite_points(points)
        self.points, self.order, self._nodes, self._levels = _build(given, _LEAF_POINTS)

    def __len__(self) -> int:
        """Number of points."""
        return len(self.points)

    def nearest(self, places: ArrayLike, limit: float = np.inf) -> tuple[Array, Indices]:
        """Nearest point of each place.

        Parameters
        ----------
        places : array of shape (k, 3), metres, same frame
            The search is faster if consecutive places are close to each other.
        limit : float, metres
            Points at this distance or beyond are not found.

        Returns
        -------
        distances : ndarray of shape (k,), metres
            Infinite where no point is found.
        indices : ndarray of shape (k,), int64
            Index in the attribute ``points``; their number where no point is found.
        """
        distances, indices = self._search(places, 1, limit)
        return distances[:, 0], indices[:, 0]

    def neighbours(self, places: ArrayLike, count: int) -> tuple[Array, Indices]:
        """The ``count`` nearest points of each place, the nearest first.

        Parameters
        ----------
        places : array of shape (k, 3), metres, same frame

        Returns
        -------
        distances, indices : ndarrays of shape (k, count)
            As of `nearest`, infinite and the number of points where the cloud has fewer.
        """
        return self._search(places, count, np.inf)

    def _search(self, places: ArrayLike, count: int, limit: float) -> tuple[Array, Indices]:
        found: tuple[Array, Indices] = _search(
            self.points, self._nodes, self._levels, _finite_points(places), count, limit
        )
        return found

    def within(self, places: ArrayLike, radius: float) -> tuple[Indices, Indices]:
        """All points within a distance of each place.

        Parameters
        ----------
        places : array of shape (k, 3), metres, same frame
        radius : float, metres

        Returns
        -------
        indices : ndarray of shape (k, m), int64
            Indices in the attribute ``points``, in any order, then zeros.
        counts : ndarray of shape (k,), int64
            Number of valid entries in each row; ``m`` is the largest, at least one.
        """
        chosen = _finite_points(places)
        none = np.zeros((len(chosen), 0), dtype=np.int64)
        counts = _search_within(self.points, self._nodes, self._levels, chosen, radius, none)
        indices = np.zeros((len(chosen), int(counts.max(initial=1))), dtype=np.int64)
        _search_within(self.points, self._nodes, self._levels, chosen, radius, indices)
        return indices, counts


def _finite_points(points: ArrayLike) -> Array:
    """Points as a contiguous (n, 3) array of finite numbers.

    Raises
    ------
    ValueError
        If they are not.
    """
    array = np.ascontiguousarray(points, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 3 or not np.isfinite(array).all():
        raise ValueError(f"finite points of shape (n, 3) are needed, not {array.shape}")
    return array


@njit(nogil=True, cache=True)
def _widest_axis(
    points: Array, first: int, last: int
) -> tuple[int, float, float]:  # pragma: no cover - compiled
    """Longest side of the box around a range of points, and the coordinates of its ends."""
    axis, low, high = 0, points[first, 0], points[first, 0]
    for k in range(3):
        a = b = points[first, k]
        for i in range(first + 1, last):
            a = min(a, points[i, k])
            b = max(b, points[i, k])
        if k == 0 or b - a > high - low:
            axis, low, high = k, a, b
    return axis, low, high


@njit(nogil=True, cache=True)
def _divide(
    points: Array, order: Indices, first: int, last: int, axis: int, cut: float
) -> int:  # pragma: no cover - compiled
    """Move the points up to ``cut`` to the front of a range; returns where the others begin."""
    i, j = first, last - 1
    while True:
        while i <= j and points[i, axis] <= cut:
            i += 1
        while i <= j and points[j, axis] > cut:
            j -= 1
        if i > j:
            return i
        for k in range(3):
            points[i, k], points[j, k] = points[j, k], points[i, k]
        order[i], order[j] = order[j], order[i]


@njit(nogil=True, cache=True)
def _build(
    given: Array, leaf_points: int
) -> tuple[Array, Indices, Nodes, int]:  # pragma: no cover - compiled
    """Ordered points, their order, nodes, and the largest number of nodes down to a leaf."""
    points = given.copy()
    order = np.arange(len(points))
    nodes = np.empty(64 + 3 * (len(points) // leaf_points), _NODE)
    # Ranges to process: begin, end, node of which it is the upper part (or -1), level.
    pending = np.empty((64, 4), np.int64)
    pending[0] = np.array([0, len(points), -1, 1])
    waiting, count, levels = 1, 0, 1
    while waiting:
        waiting -= 1
        begin, end, parent, level = pending[waiting]
        levels = max(levels, level)
        if count == len(nodes):
            nodes = np.concatenate((nodes, np.empty_like(nodes)))
        if parent >= 0:
            nodes[parent].upper = count
        node = nodes[count]
        node.axis, node.low, node.high, node.upper = -1, 0.0, 0.0, -1
        node.first, node.last = begin, end
        count += 1
        if end - begin <= leaf_points:
            continue
        axis, lowest, highest = _widest_axis(points, begin, end)
        cut = 0.5 * lowest + 0.5 * highest
        if not lowest <= cut < highest:  # the ends are neighbouring numbers
            cut = lowest
        middle = _divide(points, order, begin, end, axis, cut)
        if middle == end:  # all points coincide
            continue
        node.axis, node.low, node.high = axis, lowest, highest
        for i in range(begin, middle):
            node.low = max(node.low, points[i, axis])
        for i in range(middle, end):
            node.high = min(node.high, points[i, axis])
        if waiting + 2 > len(pending):
            pending = np.concatenate((pending, np.empty_like(pending)))
        pending[waiting] = np.array([middle, end, count - 1, level + 1])
        pending[waiting + 1] = np.array([begin, middle, -1, level + 1])
        waiting += 2
    return points, order, nodes[:count].copy(), levels


@njit(nogil=True, cache=True)
def _descend(
    nodes: Nodes, place: Array, limit: float, nodes_left: Indices, gaps_left: Array, left: int
) -> tuple[int, int]:  # pragma: no cover - compiled
    """Take the last node from the stack and descend to the leaf nearest to the place.

    The other parts on the way are put on the stack, if their squared distance is below ``limit``.

    Parameters
    ----------
    nodes_left : ndarray of shape (levels,)
        Nodes on the stack, of which ``left`` are valid.
    gaps_left : ndarray of shape (levels, 4)
        Distances from the place to the box of each node, along each axis, and their sum of squares.

    Returns
    -------
    leaf : int
        -1 if the node is too far.
    left : int
    """
    left -= 1
    node = nodes_left[left]
    x, y, z, squared = (
        gaps_left[left, 0],
        gaps_left[left, 1],
        gaps_left[left, 2],
        gaps_left[left, 3],
    )
    if squared > limit:
        return -1, left
    while nodes[node].axis >= 0:
        k = nodes[node].axis
        below, above = place[k] - nodes[node].low, nodes[node].high - place[k]
        if below < above:
            gap, far, node_of_far = above, node + 1, nodes[node].upper
        else:
            gap, far, node_of_far = below, nodes[node].upper, node + 1
        former = x if k == 0 else (y if k == 1 else z)
        gap = max(gap, former)
        far_squared = squared + gap * gap - former * former
        if far_squared <= limit:
            nodes_left[left] = node_of_far
            gaps_left[left, 0] = gap if k == 0 else x
            gaps_left[left, 1] = gap if k == 1 else y
            gaps_left[left, 2] = gap if k == 2 else z
            gaps_left[left, 3] = far_squared
            left += 1
        node = far
    return node, left


@njit(nogil=True, cache=True)
def _search(
    points: Array, nodes: Nodes, levels: int, places: Array, count: int, limit: float
) -> tuple[Array, Indices]:  # pragma: no cover - compiled
    """Distances and indices (places, count) of the nearest points, see `PointTree.neighbours`."""
    distances = np.full((len(places), count), np.inf)
    indices = np.full((len(places), count), len(points), np.int64)
    nodes_left = np.zeros(levels + 1, np.int64)
    gaps_left = np.zeros((levels + 1, 4))
    for row in range(len(places)):
        nearest, which = distances[row], indices[row]
        place = places[row]
        x, y, z = place[0], place[1], place[2]
        furthest = limit * limit
        if row and count > 1:
            # As many points are within the last distance of the previous place, which is often near
            dx, dy, dz = x - places[row - 1, 0], y - places[row - 1, 1], z - places[row - 1, 2]
            bound = distances[row - 1, count - 1] + np.sqrt(dx * dx + dy * dy + dz * dz)
            furthest = min(furthest, bound * bound * (1.0 + RELATIVE_MARGIN) + SMALLEST_MARGIN)
        nodes_left[0] = 0
        gaps_left[0] = 0.0
        left = 1
        while left:
            leaf, left = _descend(nodes, place, furthest, nodes_left, gaps_left, left)
            if leaf < 0:
                continue
            for i in range(nodes[leaf].first, nodes[leaf].last):
                dx, dy, dz = points[i, 0] - x, points[i, 1] - y, points[i, 2] - z
                squared = dx * dx + dy * dy + dz * dz
                if squared < furthest:
                    k = count - 1
                    while k > 0 and nearest[k - 1] > squared:
                        nearest[k], which[k] = nearest[k - 1], which[k - 1]
                        k -= 1
                    nearest[k], which[k] = squared, i
                    furthest = min(furthest, nearest[count - 1])
        for k in range(count):
            nearest[k] = np.sqrt(nearest[k])
    return distances, indices


@njit(nogil=True, cache=True)
def _search_within(
    points: Array, nodes: Nodes, levels: int, places: Array, radius: float, indices: Indices
) -> Indices:  # pragma: no cover - compiled
    """Number of points within a radius of each place; ``indices`` are filled if it has columns."""
    counts = np.zeros(len(places), np.int64)
    nodes_left = np.zeros(levels + 1, np.int64)
    gaps_left = np.zeros((levels + 1, 4))
    limit = radius * radius
    for row in range(len(places)):
        place = places[row]
        nodes_left[0] = 0
        gaps_left[0] = 0.0
        left = 1
        while left:
            leaf, left = _descend(nodes, place, limit, nodes_left, gaps_left, left)
            if leaf < 0:
                continue
            for i in range(nodes[leaf].first, nodes[leaf].last):
                dx = points[i, 0] - place[0]
                dy = points[i, 1] - place[1]
                dz = points[i, 2] - place[2]
                if dx * dx + dy * dy + dz * dz <= limit:
                    if indices.shape[1]:
                        indices[row, counts[row]] = i
                    counts[row] += 1
    return counts
