"""Mismatch of two lines at an object as a function of the boresight.

Each point of one line is compared with the plane through the nearest points of the other line, and
the other way round (point to plane: Chen and Medioni 1992). The loss is the square of the distance
for distances below a scale and is bounded for larger ones (Geman and McClure 1987). Objects that
only one line shows, such as a passing car or the background of a pole, therefore have little
influence. Points without a match in the other line are not used; if nearly all points have no
match, the two lines are not compared.
"""

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.local_planes import local_planes
from lispac.geometry.point_tree import PointTree
from lispac.patchtest.line_pairs import LinePair
from lispac.patchtest.object_sample import ObjectPoints, ObjectSample

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Neighbours = NDArray[np.intp]

LOSS_SCALE = 0.10
"""Scale of the robust loss, metres; larger distances have little influence.

POS errors of a few centimetres lie below it. With half this value the errors of the angles in
simulated surveys were larger by a fifth.
"""
NEIGHBOUR_COUNT = 9
"""Number of points of the neighbourhood to which the plane of each point is fitted."""
MAX_ROUGHNESS_RATIO = 0.35
"""Largest RMS distance of a neighbourhood from its plane, as a fraction of the point spacing."""
MAX_LATERAL_DISTANCE_RATIO = 2.0
"""Largest distance between two matched points within the plane, in units of the point spacing."""
SLICE_LENGTH, MIN_SLICE_POINTS = 0.5, 4
"""Length of the slices of a pole, metres, and smallest number of points of each line in a slice."""
MIN_VIEW_COSINE = np.cos(np.radians(25.0))
"""Smallest cosine between the viewing directions of two lines that see the same side of a pole."""
MIN_NORMAL_COSINE = np.cos(np.radians(30.0))
"""Smallest cosine between the normals of two matched points."""
MIN_RISE_RATIO = 1.05
"""Smallest ratio of the maxima of the curve on both sides of a clear minimum to the minimum.

Ripples on the flat part of the curve are smaller.
"""
MIN_MATCHED_POINTS, MIN_MATCHED_SHARE = 20, 0.1
"""Smallest number and smallest share of matched points for which two lines are compared.

The share is of all points of both lines in the object's box; both limits apply.
"""


@dataclass(frozen=True, eq=False)
class ObjectSurface:
    """Surface of one object in one line, computed with one boresight.

    Attributes
    ----------
    points, centre, normal : ndarray of shape (n, 3), metres and unit vectors, local frame
        Each point, and the centre and the normal of the plane fitted to its neighbours.
    flat : ndarray of shape (n,), bool
        Whether the neighbours of the point lie close enough to this plane.
    inside : ndarray of shape (n,), bool
        Whether the point lies in the object's box. The other points only serve as matches for
        points of the other line.
    tree : PointTree
        Search tree of ``points``.
    """

    points: Array
    centre: Array
    normal: Array
    flat: NDArray[np.bool_]
    inside: NDArray[np.bool_]
    tree: PointTree


def neighbour_indices(points: Array) -> Neighbours:
    """Indices (n, k) of the nearest points of each point, itself included.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, any frame
    """
    tree = PointTree(points)
    _, found = tree.neighbours(points, min(NEIGHBOUR_COUNT, len(points)))
    return tree.order[found]


def fit_object_surface(
    observed: ObjectPoints, placed: Array, near: Neighbours | None = None
) -> ObjectSurface:
    """Fit a plane to the neighbours of each point of a line.

    Parameters
    ----------
    placed : ndarray of shape (n, 3), metres, local frame
        Points of ``observed``, georeferenced with one boresight.
    near : ndarray of shape (n, k), int, optional
        Neighbours of each point from `neighbour_indices`. They can be reused for other boresights,
        because the points of one line move together.
    """
    tree = PointTree(placed)
    near = neighbour_indices(placed) if near is None else near
    centre, normal = local_planes(placed, near)
    off = np.einsum("nkj,nj->nk", placed[near] - centre[:, None], normal)
    rough = np.sqrt((off**2).mean(axis=1))
    with np.errstate(invalid="ignore"):
        flat = rough <= MAX_ROUGHNESS_RATIO * observed.spacing
    return ObjectSurface(placed, centre, normal, flat, observed.inside, tree)


@dataclass(frozen=True, eq=False)
class SurfaceDistances:
    """Distances from the points of one line to the surface of another.

    Attributes
    ----------
    point, matched : ndarray of shape (m,), int
        Indices of the points of the first line that have a match, and of the matched points of the
        second line.
    off : ndarray of shape (m,), metres
        Distances along ``normal``.
    normal : ndarray of shape (m, 3), unit vectors, local frame
    compared : int
        Number of points of the first line in the object's box, with and without a match; 0 for the
        centres of a pole.
    weight : ndarray of shape (m,)
        Number of points that each distance represents.
    """

    point: Indices
    matched: Indices
    off: Array
    normal: Array
    compared: int
    weight: Array

    @property
    def matched_points(self) -> float:
        """Number of points that the distances represent."""
        return float(self.weight.sum())


NO_DISTANCES = SurfaceDistances(
    np.empty(0, np.int64), np.empty(0, np.int64), np.empty(0), np.empty((0, 3)), 0, np.empty(0)
)


def distances_to_surface(
    first: ObjectSurface, second: ObjectSurface, spacing: float
) -> SurfaceDistances:
    """Distances from the points of the first line to the surface of the second.

    Parameters
    ----------
    spacing : float, metres
        Spacing of the points.
    """
    point = np.flatnonzero(first.inside)
    _, found = second.tree.nearest(first.points[point])
    matched = second.tree.order[found]
    normal = second.normal[matched]
    off = ((first.points[point] - second.centre[matched]) * normal).sum(axis=1)
    difference = first.points[point] - second.points[matched]
    beside = difference - (difference * normal).sum(axis=1)[:, None] * normal
    with np.errstate(invalid="ignore"):
        parallel = np.abs((first.normal[point] * normal).sum(axis=1)) >= MIN_NORMAL_COSINE
        near = (beside**2).sum(axis=1) <= (MAX_LATERAL_DISTANCE_RATIO * spacing) ** 2
        good = second.flat[matched] & first.flat[point] & parallel & near
    return SurfaceDistances(
        point[good], matched[good], off[good], normal[good], len(point), np.ones(len(off[good]))
    )


def pole_distances(
    first: ObjectSurface, second: ObjectSurface, one: ObjectPoints, other: ObjectPoints
) -> SurfaceDistances:
    """Distances between the centres of a pole in two lines, in slices along the pole.

    Point-to-plane distances on the front of a pole hardly depend on its position along the course,
    so they hardly respond to yaw. The mean of the points of a slice does. Since both lines see only
    the front of the pole, this mean lies nearer to the vessel than the axis. It is therefore
    compared only at right angles to the viewing direction and to the pole, and only between lines
    that see the same side.
    """
    assert one.axis is not None
    across = np.cross(one.view + other.view, one.axis)
    across /= max(float(np.linalg.norm(across)), 1e-9)
    if one.view @ other.view < MIN_VIEW_COSINE or np.linalg.norm(across) < 0.5:
        return NO_DISTANCES
    rows = []
    sides = [_pole_slices(surface, each) for surface, each in ((first, one), (second, other))]
    for k in sorted(set(sides[0]) & set(sides[1])):
        a, b = sides[0][k], sides[1][k]
        if min(len(a), len(b)) < MIN_SLICE_POINTS:
            continue
        middles = first.points[a].mean(axis=0), second.points[b].mean(axis=0)
        nearest = [
            group[np.argmin(((surface.points[group] - middle) ** 2).sum(axis=1))]
            for surface, group, middle in zip((first, second), (a, b), middles, strict=True)
        ]
        rows.append((*nearest, (middles[0] - middles[1]) @ across, min(len(a), len(b))))
    if not rows:
        return NO_DISTANCES
    point, matched, off, weight = (np.array(column) for column in zip(*rows, strict=True))
    return SurfaceDistances(
        point, matched, off, np.repeat(across[None], len(off), axis=0), 0, weight.astype(float)
    )


def _pole_slices(surface: ObjectSurface, pole: ObjectPoints) -> dict[int, Indices]:
    """Indices of the points of a pole in its box, by number of the slice along the pole."""
    assert pole.axis is not None
    rows = np.flatnonzero(surface.inside)
    along = (surface.points[rows] - pole.object.box.centre) @ pole.axis
    number = np.floor(along / SLICE_LENGTH).astype(np.int64)
    return {int(k): rows[number == k] for k in np.unique(number)}


def has_enough_overlap(both: Sequence[SurfaceDistances]) -> bool:
    """Whether two lines overlap enough to be compared."""
    matched = sum(each.matched_points for each in both)
    return matched >= max(
        MIN_MATCHED_POINTS, MIN_MATCHED_SHARE * sum(each.compared for each in both)
    )


def robust_mean_square(both: Sequence[SurfaceDistances], scale: float) -> float:
    """Mean of the robust loss of the distances, square metres; NaN if there are too few."""
    if not has_enough_overlap(both):
        return float("nan")
    off, weight = (np.concatenate([getattr(d, n) for d in both]) for n in ("off", "weight"))
    return float((weight * off**2 / (1.0 + (off / scale) ** 2)).sum() / weight.sum())


@dataclass(frozen=True, eq=False)
class PairBlock:
    """Points of two lines at one object.

    Attributes
    ----------
    first, second : ObjectPoints
    pair : LinePair
    """

    first: ObjectPoints
    second: ObjectPoints
    pair: LinePair


def pair_blocks(sample: ObjectSample, pairs: Sequence[LinePair]) -> list[PairBlock]:
    """Find all given pairs of lines that see the same object, sorted by object."""
    chosen = {frozenset(pair.lines): pair for pair in pairs}
    found = []
    for k, first in enumerate(sample.observed):
        for second in sample.observed[k + 1 :]:
            if second.object is not first.object:
                break
            pair = chosen.get(frozenset((first.line, second.line)))
            if pair is not None:
                found.append(PairBlock(first, second, pair))
    return found


def block_weights(blocks: Sequence[PairBlock]) -> Array:
    """Weight of each block, shape (b,): independent comparisons at its object per block.

    Lines at an object that are connected by pairs form a group; a group of ``n`` lines has
    ``n - 1`` independent comparisons. The six pairs of four lines thus have a total weight of
    three, and two pairs without a common line have a total weight of two.
    """
    groups: dict[str, list[set[str]]] = {}
    block_counts: dict[str, int] = {}
    for block in blocks:
        name, lines = block.first.object.name, {block.first.line, block.second.line}
        separate = groups.setdefault(name, [])
        joined = [group for group in separate if group & lines]
        groups[name] = [g for g in separate if not g & lines] + [lines.union(*joined)]
        block_counts[name] = block_counts.get(name, 0) + 1
    independent = {
        name: sum(len(group) - 1 for group in separate) for name, separate in groups.items()
    }
    return np.array(
        [independent[n] / block_counts[n] for n in (b.first.object.name for b in blocks)]
    )


class Mismatch:
    """Mismatch of the lines in some blocks as a function of the boresight.

    Parameters
    ----------
    sample : ObjectSample
    blocks : sequence of PairBlock
    scale : float, metres
        Scale of the robust loss.
    """

    def __init__(
        self, sample: ObjectSample, blocks: Sequence[PairBlock], scale: float = LOSS_SCALE
    ) -> None:
        self.sample, self.blocks, self.scale = sample, tuple(blocks), scale
        self.weights = block_weights(blocks)
        self._needed = {id(each): each for b in blocks for each in (b.first, b.second)}
        self._near: dict[int, Neighbours] = {}

    def with_scale(self, scale: float) -> "Mismatch":
        """Mismatch of the same blocks with another scale of the robust loss, metres."""
        other = copy(self)
        other.scale = scale
        return other

    def block_distances(self, boresight: Array) -> list[tuple[SurfaceDistances, ...]]:
        """Distances of each block: first to second line, second to first, and centres of a pole.

        Parameters
        ----------
        boresight : ndarray of shape (3,), radians
        """
        placed = self.sample.placed_points(boresight)
        if not self._near:
            for k, each in self._needed.items():
                self._near[k] = neighbour_indices(placed[each.points])
        surface = {
            k: fit_object_surface(each, placed[each.points], self._near[k])
            for k, each in self._needed.items()
        }
        found: list[tuple[SurfaceDistances, ...]] = []
        for block in self.blocks:
            a, b = surface[id(block.first)], surface[id(block.second)]
            spacing = block.first.spacing
            both = [distances_to_surface(a, b, spacing), distances_to_surface(b, a, spacing)]
            if block.first.axis is not None:
                both.append(pole_distances(a, b, block.first, block.second))
            found.append(tuple(both))
        return found

    def mean_squares(self, boresight: Array) -> Array:
        """Robust mean square distance of each block, shape (b,), square metres; NaN if too few.

        Parameters
        ----------
        boresight : ndarray of shape (3,), radians
        """
        return np.array(
            [robust_mean_square(both, self.scale) for both in self.block_distances(boresight)]
        )

    def __call__(self, boresight: Array) -> float:
        """Robust RMS distance of all blocks, metres; NaN if no block has enough points.

        Parameters
        ----------
        boresight : ndarray of shape (3,), radians
        """
        squares = self.mean_squares(boresight)
        good = np.isfinite(squares)
        if not good.any():
            return float("nan")
        return float(np.sqrt((self.weights * squares)[good].sum() / self.weights[good].sum()))

    def mismatch_curve(self, boresight: Array, angle: int, values: Array) -> Array:
        """Mismatch as a function of one angle, shape (k,), metres.

        Parameters
        ----------
        boresight : ndarray of shape (3,), radians
        angle : int
            0 roll, 1 pitch, 2 yaw.
        values : ndarray of shape (k,), radians
        """
        turned = np.repeat(np.asarray(boresight, dtype=float)[None], len(values), axis=0)
        turned[:, angle] = values
        return np.array([self(each) for each in turned])


def curve_minimum(values: Array, mismatch: Array) -> float | None:
    """Position of the minimum of a mismatch curve, radians; None if it has no clear minimum.

    The minimum is interpolated by a parabola. Far from the minimum the curve is flat, because the
    robust loss is bounded.

    Parameters
    ----------
    values : ndarray of shape (n,), radians, equally spaced
    mismatch : ndarray of shape (n,), metres
    """
    if len(values) < 3 or not np.isfinite(mismatch).all():
        return None
    k = int(mismatch.argmin())
    rise = min(mismatch[:k].max(initial=0.0), mismatch[k:].max()) / mismatch[k]
    if k in (0, len(values) - 1) or rise < MIN_RISE_RATIO:
        return None
    before, at, after = mismatch[k - 1 : k + 2]
    bend = before - 2 * at + after
    step = values[k + 1] - values[k]
    return float(values[k] + (0.5 * step * (before - after) / bend if bend else 0.0))
