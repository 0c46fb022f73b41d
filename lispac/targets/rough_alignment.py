"""Rough boresight from the whole scene, used to find targets in all lines.

With the prior boresight, the positions of a target in different lines may differ by a metre. If
the platform turns or the range changes along the target, it also appears bent. Both effects depend
on the three boresight angles, which can be determined from the whole scene to a tenth of a degree
before targets are picked. The method is the iterative closest point algorithm with point-to-plane
distances (Chen and Medioni 1992): distances between nearest points with similar normals are
minimised along the normals, with a decreasing search distance.

The result is no calibration: it has no standard deviations and is used only to search for targets.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations, product
from math import radians

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.local_planes import local_planes
from lispac.geometry.point_tree import PointTree
from lispac.geometry.radius_search import cell_keys, finite_bounds
from lispac.survey.cloud import Cloud, place_clouds
from lispac.survey.georeferencing import Georeferencer, Mounting
from lispac.targets.boresight_smear import ROUGH_BORESIGHT_SIGMA
from lispac.targets.sighting_agreement import PlacementAccuracy

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]

MAX_READ_POINTS, MAX_USED_POINTS = 200_000, 3_000
"""Largest number of points of a line that are read, and largest number that are used. The points
used are spread evenly over the scene and contain nearly the same information as all."""
MIN_POINT_SPACING = 0.1
"""Smallest spacing of the points used, metres."""
NEIGHBOURS_PER_NORMAL = 10
"""Number of nearest points from which the normal of a point is computed."""
MAX_RELATIVE_ROUGHNESS, MAX_ROUGHNESS = 0.25, 0.08
"""Largest RMS distance of a neighbourhood from its plane: a fraction of the point spacing, or a
length in metres, whichever is larger. A wall smeared by the boresight is accepted, a shrub not."""
MIN_NORMAL_COSINE = 0.94
"""Smallest cosine of the angle between the normals of corresponding points."""
STAGE_DISTANCES = (2.5, 1.5, 1.0, 0.7, 0.5, 0.35, 0.25, 0.18, 0.15)
"""Largest distance between corresponding points in each stage, metres."""
MAX_STEPS_PER_STAGE, STEP_TOLERANCE = 2, radians(0.02)
"""Largest number of steps of a stage, and the step size in radians at which a stage ends."""
DERIVATIVE_STEP = radians(0.01)
"""Step of the boresight angles, radians, for numerical derivatives of the points; small enough for
a linear change."""
PRIOR_ANGLE_SIGMA, SURFACE_DISTANCE_SIGMA = radians(1.0), 0.01
"""Prior standard deviation of each boresight angle (radians), and standard deviation of the
distance between surfaces with the correct boresight (metres). With this prior, an angle that the
scene does not determine stays near its prior value."""
MIN_SENSITIVITY = 2.0
"""Smallest sensitivity, metres per radian, for which a combination of the boresight angles counts
as determined. The sensitivity is the RMS of the shifts of surfaces along their normals per radian.
At this limit, an offset of 5 cm between lines for another reason, such as a GNSS jump, changes the
angles by 1.5 degrees. For a quay wall or a floor alone, the sensitivity is below one for the
undetermined combinations; in harbours and for vehicles it is four or more."""
START_ANGLE_CHANGE, REFINED_STARTS, COMPARISON_POINTS = radians(1.2), 3, 800
"""Alternative starts, used if the lines do not coincide after the search from the prior boresight:
change of each angle in both directions (radians), number of the best starts that are refined, and
number of points of a line with which all starts are compared."""
MAX_SURFACE_DISTANCE, MAX_POINT_DISTANCE = 0.15, 1.0
"""Criteria for a match of two lines at a point, metres: largest distance between their surfaces,
and largest distance from the nearest point of the other line."""
MIN_SEPARATION_SIGMA = 0.02
"""Smallest standard deviation assumed for the distance between surfaces of two lines, metres."""
SIGMA_PER_MAD = 1.4826
"""Ratio of the standard deviation of a normal distribution to its median absolute deviation."""
MIN_MATCHED_SHARE = 0.75
"""Smallest share of points that match another line for lines to count as aligned."""


@dataclass(frozen=True, eq=False)
class Alignment:
    """Lines placed with a rough boresight.

    Attributes
    ----------
    clouds : mapping of line name to Cloud
        With the rough boresight, or with the prior one if no other is better.
    before : mapping of line name to Cloud
        With the prior boresight.
    matched_share, matched_share_before : float, in [0, 1]
        Share of points that match the surface of another line, among those near another line.
    determined : bool
        Whether all three angles are determined. A single wall is not enough, since lines shifted
        along it also coincide.
    separation : float, metres
        Robust standard deviation of the distance between the surfaces of two lines.
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
        """Whether targets are expected at about the same position in every line."""
        return self.determined and self.matched_share >= MIN_MATCHED_SHARE

    @property
    def accuracy(self) -> PlacementAccuracy:
        """Relative accuracy of the positions of the lines."""
        if not self.is_aligned:
            return PlacementAccuracy()
        return PlacementAccuracy(ROUGH_BORESIGHT_SIGMA, max(self.separation, MIN_SEPARATION_SIGMA))


def align_lines(clouds: Mapping[str, Cloud]) -> Alignment:
    """Find a rough boresight with which the lines nearly coincide.

    The search starts from the prior boresight. If the lines do not coincide afterwards, it is
    repeated from the most promising alternative starts.

    Parameters
    ----------
    clouds : mapping of line name to Cloud
        All placed with the same prior mounting.
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
        if matched >= MIN_MATCHED_SHARE:
            break
    determined, separation = scene.determines_all_angles(best), scene.separation(best)
    if best is prior:
        return Alignment(clouds, clouds, matched, before, determined, separation)
    nearer = scene.place.mounting.with_boresight(best)
    placed = place_clouds(clouds, nearer)
    return Alignment(placed, clouds, matched, before, determined, separation)


@dataclass(frozen=True, eq=False)
class _LineSample:
    """Sample of the points of a line in the scanner frame.

    ``neighbours`` has shape (n, k) and contains the indices of the points from which the normal of
    each point is computed. ``max_roughness`` is the largest RMS distance of such points from their
    plane, metres, for which the normal is used.
    """

    points_lidar: Array
    time: Array
    neighbours: Indices
    max_roughness: float

    @classmethod
    def of(cls, cloud: Cloud, count: int) -> "_LineSample":
        numbers = np.arange(0, len(cloud.sample), -(-len(cloud.sample) // MAX_READ_POINTS) or 1)
        numbers = numbers[_thin_to_count(cloud.sample[numbers], count)]
        points = cloud.sample[numbers]
        # The neighbours are determined once and used for every boresight.
        tree = PointTree(points)
        distance, neighbours = tree.neighbours(points, min(NEIGHBOURS_PER_NORMAL, len(points)))
        max_roughness = max(
            MAX_RELATIVE_ROUGHNESS * float(np.median(distance[:, 1])), MAX_ROUGHNESS
        )
        return cls(
            *cloud.sample_lidar(numbers),
            tree.order[neighbours],
            max_roughness,
        )

    def normals_and_flatness(self, placed: Array) -> tuple[Array, Flags]:
        """Normal at each point, and whether its neighbourhood is flat enough for a normal."""
        centroids, normals = local_planes(placed, self.neighbours)
        off = np.einsum("nmk,nk->nm", placed[self.neighbours] - centroids[:, None], normals)
        return normals, np.sqrt((off * off).mean(axis=1)) < self.max_roughness


@dataclass(frozen=True, eq=False)
class _PointPairs:
    """Corresponding points of two lines, with the normals (n, 3) at the points of the second line.

    ``first`` and ``second`` are the indices of the lines, ``here`` and ``there`` (n,) those of the
    points in these lines.
    """

    first: int
    second: int
    here: Indices
    there: Indices
    normals: Array


@dataclass(frozen=True, eq=False)
class _SceneLines:
    """Samples of all lines, which can be placed with any boresight."""

    lines: tuple[_LineSample, ...]
    place: Georeferencer

    @classmethod
    def of(cls, clouds: Mapping[str, Cloud], count: int = MAX_USED_POINTS) -> "_SceneLines":
        lines = [
            _LineSample.of(cloud, count)
            for cloud in clouds.values()
            if len(cloud.sample) >= NEIGHBOURS_PER_NORMAL
        ]
        return cls(tuple(lines), next(iter(clouds.values())).place)

    @property
    def boresight(self) -> Array:
        """Prior boresight, shape (3,), radians."""
        return self.place.mounting.boresight

    def place_points(self, boresight: Array) -> list[Array]:
        """Points of each line placed with a boresight, shape (n, 3), metres, local frame."""
        mounting = self.place.mounting.with_boresight(boresight)
        place = Georeferencer.of(self.place.trajectory, mounting)
        return [place(line.points_lidar, line.time) for line in self.lines]

    def starting_boresights(self, clouds: Mapping[str, Cloud]) -> Iterator[Array]:
        """Yield the prior boresight, then the alternative starts with most matching points.

        The alternative starts are yielded after one Gauss-Newton step.

        Parameters
        ----------
        clouds : mapping of line name to Cloud
            Lines of the scene; fewer of their points are used to compare the alternative starts.
        """
        yield self.boresight
        coarse = _SceneLines.of(
            clouds, COMPARISON_POINTS
        )  # computed only if the search from the prior boresight failed
        turns = [
            START_ANGLE_CHANGE * np.array(turn)
            for turn in product((-1, 0, 1), repeat=3)
            if any(turn)
        ]
        stepped = [
            coarse.gauss_newton_step(self.boresight + turn, STAGE_DISTANCES[0]) for turn in turns
        ]
        shares = np.array([coarse.matched_share(boresight) for boresight in stepped])
        for k in np.argsort(-shares, kind="stable")[:REFINED_STARTS]:
            yield stepped[k]

    def refine_boresight(self, boresight: Array) -> Array:
        """Refine a boresight in stages with decreasing distances between corresponding points."""
        for reach in STAGE_DISTANCES:
            for _ in range(MAX_STEPS_PER_STAGE):
                before, boresight = boresight, self.gauss_newton_step(boresight, reach)
                if np.abs(boresight - before).max() < STEP_TOLERANCE:
                    break
        return boresight

    def gauss_newton_step(self, boresight: Array, reach: float) -> Array:
        """Boresight after one Gauss-Newton step, with weights that decrease with the residuals."""
        information, gradient = self._normal_equations(boresight, reach)
        # Errors of the points are correlated: together they have the weight of one observation, so
        # that the prior keeps its influence.
        prior = (SURFACE_DISTANCE_SIGMA / PRIOR_ANGLE_SIGMA) ** 2
        gradient = gradient + prior * (boresight - self.boresight)
        return np.asarray(boresight - np.linalg.solve(information + prior * np.eye(3), gradient))

    def determines_all_angles(self, boresight: Array) -> bool:
        """Whether the overlapping parts of the lines determine all three angles."""
        information, _ = self._normal_equations(boresight, STAGE_DISTANCES[-1])
        return bool(np.linalg.eigvalsh(information)[0] >= MIN_SENSITIVITY**2)

    def _normal_equations(self, boresight: Array, reach: float) -> tuple[Array, Array]:
        """Normal equations of the angles: weighted mean over the pairs of points.

        Returns
        -------
        information : ndarray of shape (3, 3), (metres / radian)^2
        gradient : ndarray of shape (3,), metres^2 / radian
        """
        placed = self.place_points(boresight)
        turned = [self.place_points(boresight + DERIVATIVE_STEP * axis) for axis in np.eye(3)]
        moves = [
            np.stack([(other[k] - points) / DERIVATIVE_STEP for other in turned], axis=-1)
            for k, points in enumerate(placed)
        ]
        information, gradient, total = np.zeros((3, 3)), np.zeros(3), 0.0
        for pair in self._find_pairs(placed, reach):
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
        placed = self.place_points(boresight)
        matched = count = 0
        for pair in self._find_pairs(placed, STAGE_DISTANCES[0]):
            difference = placed[pair.first][pair.here] - placed[pair.second][pair.there]
            near = np.linalg.norm(difference, axis=1) < MAX_POINT_DISTANCE
            near &= np.abs(_distances_to_plane(placed, pair)) < MAX_SURFACE_DISTANCE
            matched += int(np.count_nonzero(near))
            count += len(pair.here)
        return matched / max(count, 1)

    def separation(self, boresight: Array) -> float:
        """Distance between the lines in metres, as in `Alignment`; 0 without common surfaces."""
        placed = self.place_points(boresight)
        off = [
            _distances_to_plane(placed, pair)
            for pair in self._find_pairs(placed, MAX_POINT_DISTANCE)
        ]
        every = np.concatenate([np.empty(0), *off])
        return SIGMA_PER_MAD * float(np.median(np.abs(every))) if len(every) else 0.0

    def _find_pairs(self, placed: list[Array], reach: float) -> Iterator[_PointPairs]:
        faces = [
            line.normals_and_flatness(points)
            for line, points in zip(self.lines, placed, strict=True)
        ]
        trees = [PointTree(points) for points in placed]
        for first, second in combinations(range(len(placed)), 2):
            (own, own_flat), (normals, flat) = faces[first], faces[second]
            here = np.flatnonzero(own_flat)
            distance, nearest = trees[second].nearest(placed[first][here], reach)
            near = np.isfinite(distance)
            here, there = here[near], trees[second].order[nearest[near]]
            facing = np.abs((own[here] * normals[there]).sum(axis=1)) > MIN_NORMAL_COSINE
            alike = facing & flat[there]
            yield _PointPairs(first, second, here[alike], there[alike], normals[there[alike]])


def _distances_to_plane(placed: list[Array], pair: _PointPairs) -> Array:
    """Distances of the first points from the planes at the second points, shape (n,), metres."""
    difference = placed[pair.first][pair.here] - placed[pair.second][pair.there]
    return np.asarray((difference * pair.normals).sum(axis=1))


def _thin_to_count(points: Array, count: int) -> Indices:
    """Indices of at most ``count`` points, spread evenly: the first one in each voxel."""
    kept = np.flatnonzero(np.isfinite(points).all(axis=1))
    low, voxel = finite_bounds(points[kept])[0], MIN_POINT_SPACING
    while True:
        _, first = np.unique(cell_keys(points[kept], low, voxel)[0], return_index=True)
        kept = kept[np.sort(first)]
        if len(kept) <= count:
            return kept
        voxel *= 1.25
