"""Rough boresight from the whole scene, so that targets are found in all lines.

With the prior boresight a target stands up to a metre and more elsewhere in each line, and where
the platform turns or the range changes along it, it is bent as well. Both are the work of three
angles, which the whole scene determines to a tenth of a degree before anything is picked:
nearest points that face alike are drawn together along their normals (iterative closest point,
point to plane: Chen and Medioni 1992), with a reach that shrinks.

What comes out is no calibration: it has no sigma, and nothing but the search for targets uses it.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations, product
from math import radians

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.nearest_neighbours import build_tree, local_planes
from lispac.geometry.radius_search import cell_keys, finite_bounds
from lispac.survey.cloud import Cloud, place_clouds
from lispac.survey.georeferencing import Georeferencer, Mounting
from lispac.targets.boresight_smear import ROUGHLY_OFF
from lispac.targets.sighting_agreement import PlacementAccuracy

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]

EXAMINED_POINTS, MAX_POINTS = 200_000, 3_000
"""Points of a line that are examined, and largest number of these that are used: spread evenly over
the scene, a few hold as much information as all."""
FINEST = 0.1
"""Least spacing of these points, metres."""
NEIGHBOURS = 10
"""Points whose plane is a point's own."""
UNEVEN, ROUGH = 0.25, 0.08
"""Largest departure of a neighbourhood from its plane: a share of the spacing, or metres where that
is more. A wall smeared by the boresight is used, a shrub is not."""
MIN_COSINE = 0.94
"""Least cosine between the normals of two points that belong together."""
REACHES = (2.5, 1.5, 1.0, 0.7, 0.5, 0.35, 0.25, 0.18, 0.15)
"""Farthest that two such points may be apart, metres, from stage to stage."""
ROUNDS, STEP_TOLERANCE = 2, radians(0.02)
"""Steps of a stage, and how small a step ends it."""
STEP = radians(0.01)
"""Turn of the boresight by which points are moved; over so little they move straight."""
LIKELY, SPREAD = radians(1.0), 0.01
"""Usual error of a boresight, and of surfaces (metres) with the right one: an angle that
the scene leaves open stays near its prior value."""
MIN_LEVERAGE = 2.0
"""Metres that surfaces move along their normals for a radian of a direction of the angles, in the
root mean square, below which that direction counts as open: 5 cm between the lines for another
reason, a jump of the GNSS, would turn it by a degree and a half. A quay wall or a floor alone have
less than one in their open directions, harbours and vehicles four and more."""
STARTS, REFINED, COARSE_POINTS = radians(1.2), 3, 800
"""Where the lines do not meet from the prior boresight on, each angle is also tried so much larger
and smaller, by so many points of a line; so many of these starts, the likeliest, are followed."""
MAX_GAP, MAX_DISTANCE = 0.15, 1.0
"""Two lines match at a point where their surfaces are this near to each other, metres, and it is
not farther than that from a point of the other line."""
MIN_SEPARATION = 0.02
"""Standard deviation of the distance between the surfaces of two lines, metres, at least."""
NORMAL_MAD = 1.4826
"""Standard deviation of a normal distribution over its median absolute deviation."""
MIN_MATCHED = 0.75
"""Share of the points that must match another line."""


@dataclass(frozen=True, eq=False)
class Alignment:
    """Lines placed with a rough boresight.

    Attributes
    ----------
    clouds : mapping of line name to Cloud
        With the rough boresight; with the prior one where no other does better.
    before : mapping of line name to Cloud
        With the prior boresight.
    matched_share, matched_share_before : float, in [0, 1]
        Share of the points that match the surface of another line, of those that have one nearby.
    determined : bool
        All three angles are determined. One wall alone does not: its lines also meet where they
        are shifted along it.
    apart : float, metres
        Standard deviation of the distance between the surfaces of two lines, a robust one.
    """

    clouds: Mapping[str, Cloud]
    before: Mapping[str, Cloud]
    matched_share: float
    matched_share_before: float
    determined: bool = False
    separation: float = 0.0

    @property
    def mounting(self) -> Mounting:
        """Mounting with the rough boresight."""
        return next(iter(self.clouds.values())).place.mounting

    @property
    def is_aligned(self) -> bool:
        """Whether a target is expected at about the same place on every line."""
        return self.determined and self.matched_share >= MIN_MATCHED

    @property
    def accuracy(self) -> PlacementAccuracy:
        """Relative accuracy of the positions of these lines."""
        if not self.is_aligned:
            return PlacementAccuracy()
        return PlacementAccuracy(ROUGHLY_OFF, max(self.separation, MIN_SEPARATION))


def align_lines(clouds: Mapping[str, Cloud]) -> Alignment:
    """Find the boresight with which lines nearly meet.

    The search starts from the prior boresight; where the lines do not meet then, from the likeliest
    of others about it.

    Parameters
    ----------
    clouds : mapping of line name to Cloud
        All with the same mounting, the prior one.
    """
    if len(clouds) < 2:
        return Alignment(clouds, clouds, 0.0, 0.0)
    scene = _SceneLines.of(clouds)
    prior = scene.boresight
    best, before = prior, scene.matched_share(prior)
    matched = before
    for start in scene.starting_boresights(clouds):
        boresight = scene.refine_boresight(start)
        share = scene.matched_share(boresight)
        if share > matched:
            best, matched = boresight, share
        if matched >= MIN_MATCHED:
            break
    determined, separation = scene.determines(best), scene.separation(best)
    if best is prior:
        return Alignment(clouds, clouds, matched, before, determined, separation)
    nearer = scene.place.mounting.with_boresight(best)
    placed = place_clouds(clouds, nearer)
    return Alignment(placed, clouds, matched, before, determined, separation)


@dataclass(frozen=True, eq=False)
class _LineSample:
    """Some points of a line in the scanner frame, with data for their normals."""

    points_lidar: Array
    time: Array
    neighbours: Indices
    rough: float

    @classmethod
    def of(cls, cloud: Cloud, count: int) -> "_LineSample":
        numbers = np.arange(0, len(cloud.sample), -(-len(cloud.sample) // EXAMINED_POINTS) or 1)
        numbers = numbers[_thin_to_count(cloud.sample[numbers], count)]
        points = cloud.sample[numbers]
        # Points keep their neighbours, whatever the boresight.
        distance, neighbours = build_tree(points).query(points, min(NEIGHBOURS, len(points)))
        rough = max(UNEVEN * float(np.median(distance[:, 1])), ROUGH)
        return cls(
            *cloud.sample_lidar(numbers), np.ascontiguousarray(neighbours, dtype=np.int64), rough
        )

    def faces(self, placed: Array) -> tuple[Array, Flags]:
        """The normal at each point, and whether its surroundings are flat enough to have one."""
        centroids, normals = local_planes(placed, self.neighbours)
        off = np.einsum("nmk,nk->nm", placed[self.neighbours] - centroids[:, None], normals)
        return normals, np.sqrt((off * off).mean(axis=1)) < self.rough


@dataclass(frozen=True, eq=False)
class _PointPairs:
    """Points of two lines, shape (n,), that may belong together; normals (n, 3) of the second."""

    first: int
    second: int
    here: Indices
    there: Indices
    normals: Array


@dataclass(frozen=True, eq=False)
class _SceneLines:
    """All lines, to be placed with one boresight after another."""

    lines: tuple[_LineSample, ...]
    place: Georeferencer

    @classmethod
    def of(cls, clouds: Mapping[str, Cloud], count: int = MAX_POINTS) -> "_SceneLines":
        lines = [
            _LineSample.of(cloud, count)
            for cloud in clouds.values()
            if len(cloud.sample) >= NEIGHBOURS
        ]
        return cls(tuple(lines), next(iter(clouds.values())).place)

    @property
    def boresight(self) -> Array:
        """The prior one, shape (3,), radians."""
        return self.place.mounting.boresight

    def placed(self, boresight: Array) -> list[Array]:
        """The points of each line."""
        mounting = self.place.mounting.with_boresight(boresight)
        place = Georeferencer.of(self.place.trajectory, mounting)
        return [place(line.points_lidar, line.time) for line in self.lines]

    def starting_boresights(self, clouds: Mapping[str, Cloud]) -> Iterator[Array]:
        """The prior boresight; then those about it that bring the lines nearest to each other.

        Parameters
        ----------
        clouds : mapping of line name to Cloud
            Of the scene; the others are found by fewer of their points.
        """
        yield self.boresight
        coarse = _SceneLines.of(
            clouds, COARSE_POINTS
        )  # spread only where the prior boresight was not enough
        turns = [STARTS * np.array(turn) for turn in product((-1, 0, 1), repeat=3) if any(turn)]
        stepped = [coarse.gauss_newton_step(self.boresight + turn, REACHES[0]) for turn in turns]
        shares = np.array([coarse.matched_share(boresight) for boresight in stepped])
        for k in np.argsort(-shares, kind="stable")[:REFINED]:
            yield stepped[k]

    def refine_boresight(self, boresight: Array) -> Array:
        """Where the search ends that starts from a boresight."""
        for reach in REACHES:
            for _ in range(ROUNDS):
                before, boresight = boresight, self.gauss_newton_step(boresight, reach)
                if np.abs(boresight - before).max() < STEP_TOLERANCE:
                    break
        return boresight

    def gauss_newton_step(self, boresight: Array, reach: float) -> Array:
        """One step of Gauss and Newton, with weights that fall off within the reach."""
        information, gradient = self._normal_equations(boresight, reach)
        # Thousands of points have a common error: they count as one, the prior keeps its weight.
        prior = (SPREAD / LIKELY) ** 2
        gradient = gradient + prior * (boresight - self.boresight)
        return np.asarray(boresight - np.linalg.solve(information + prior * np.eye(3), gradient))

    def determines(self, boresight: Array) -> bool:
        """Whether the scene determines all three angles where lines overlap."""
        information, _ = self._normal_equations(boresight, REACHES[-1])
        return bool(np.linalg.eigvalsh(information)[0] >= MIN_LEVERAGE**2)

    def _normal_equations(self, boresight: Array, reach: float) -> tuple[Array, Array]:
        """Information of point pairs on the angles, weighted mean.

        Returns
        -------
        information : ndarray of shape (3, 3), (metres / radian)^2
        gradient : ndarray of shape (3,), metres^2 / radian
        """
        placed = self.placed(boresight)
        turned = [self.placed(boresight + STEP * axis) for axis in np.eye(3)]
        moves = [
            np.stack([(other[k] - points) / STEP for other in turned], axis=-1)
            for k, points in enumerate(placed)
        ]
        information, gradient, total = np.zeros((3, 3)), np.zeros(3), 0.0
        for pair in self._pairs(placed, reach):
            off = _distances_to_plane(placed, pair)
            moved = moves[pair.first][pair.here] - moves[pair.second][pair.there]
            rows = np.einsum("nk,nkb->nb", pair.normals, moved)
            weights = 1.0 / (1.0 + (4.0 * off / reach) ** 2) ** 2
            information += (weights[:, None] * rows).T @ rows
            gradient += (weights * off) @ rows
            total += float(weights.sum())
        return information / max(total, 1.0), gradient / max(total, 1.0)

    def matched_share(self, boresight: Array) -> float:
        """See `Alignment`."""
        placed = self.placed(boresight)
        matched = count = 0
        for pair in self._pairs(placed, REACHES[0]):
            difference = placed[pair.first][pair.here] - placed[pair.second][pair.there]
            near = np.linalg.norm(difference, axis=1) < MAX_DISTANCE
            near &= np.abs(_distances_to_plane(placed, pair)) < MAX_GAP
            matched += int(np.count_nonzero(near))
            count += len(pair.here)
        return matched / max(count, 1)

    def separation(self, boresight: Array) -> float:
        """Distance between the lines in metres, as in `Alignment`; 0 without common surfaces."""
        placed = self.placed(boresight)
        off = [_distances_to_plane(placed, pair) for pair in self._pairs(placed, MAX_DISTANCE)]
        every = np.concatenate([np.empty(0), *off])
        return NORMAL_MAD * float(np.median(np.abs(every))) if len(every) else 0.0

    def _pairs(self, placed: list[Array], reach: float) -> Iterator[_PointPairs]:
        faces = [line.faces(points) for line, points in zip(self.lines, placed, strict=True)]
        trees = [build_tree(points) for points in placed]
        for first, second in combinations(range(len(placed)), 2):
            (own, own_flat), (normals, flat) = faces[first], faces[second]
            here = np.flatnonzero(own_flat)
            distance, nearest = trees[second].query(placed[first][here], distance_upper_bound=reach)
            near = np.isfinite(distance)
            here, there = here[near], nearest[near]
            facing = np.abs((own[here] * normals[there]).sum(axis=1)) > MIN_COSINE
            alike = facing & flat[there]
            yield _PointPairs(first, second, here[alike], there[alike], normals[there[alike]])


def _distances_to_plane(placed: list[Array], pair: _PointPairs) -> Array:
    """Distance of the first points from the surface at the second, shape (n,), metres."""
    difference = placed[pair.first][pair.here] - placed[pair.second][pair.there]
    return np.asarray((difference * pair.normals).sum(axis=1))


def _thin_to_count(points: Array, count: int) -> Indices:
    """Indices of few points (n, 3), evenly spread: one of each voxel."""
    kept = np.flatnonzero(np.isfinite(points).all(axis=1))
    low, voxel = finite_bounds(points[kept])[0], FINEST
    while True:
        _, first = np.unique(cell_keys(points[kept], low, voxel)[0], return_index=True)
        kept = kept[np.sort(first)]
        if len(kept) <= count:
            return kept
        voxel *= 1.25
