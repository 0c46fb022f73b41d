"""Distances between lines on a validation plane before and after the calibration.

This is the assessment of relative accuracy of thesis sections 4.4.6 and 4.5.4: cloud-to-cloud
distances with a local plane between all pairs of lines with points on the same plane, as histograms
before and after.

A point of line A is compared with line B if it lies inside the footprint of B in the plane **both**
before and after the calibration. The condition after the calibration ensures that both lines show
this place. The condition before it excludes points that the wrong boresight has moved past the edge
of B: their distance to the edge would exaggerate the effect of the calibration. Both statistics
are therefore computed from the same points, and only the boresight differs.
"""

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError, NotComparable
from lispac.geometry.point_tree import PointTree
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress
from lispac.validation.cloud_distance import cloud_to_cloud
from lispac.validation.comparison_results import (
    DistanceStatistics,
    PairComparison,
    PairState,
    PlaneComparison,
    SignedStatistics,
    TwoModes,
)
from lispac.validation.distance_bins import histogram_counts, shared_bin_edges
from lispac.validation.distance_map import DistanceMap, distance_map
from lispac.validation.distance_profile import DistanceProfile
from lispac.validation.line_overlap import Bools, LineOverlap
from lispac.validation.line_shifts import PlaneErrors, line_shifts
from lispac.validation.local_models import DEFAULT_MODEL, LocalModel, LocalSurfaces
from lispac.validation.normal_distance import NormalDistances, distances_along_normal
from lispac.validation.plane_offset import PlaneOffset, plane_offset
from lispac.validation.two_modes import find_two_modes

__all__ = [
    "DistanceStatistics",
    "PairComparison",
    "PlaneComparison",
    "are_reciprocal",
    "comparable_pairs",
    "compare_plane",
]
Array = NDArray[np.float64]
RECIPROCAL_TOLERANCE_RAD = np.radians(20.0)
"""Largest deviation of two headings from opposite directions for reciprocal lines."""
MAX_POINTS_PER_LINE = 100_000
"""Largest number of points of a line on a plane that are compared."""
MAX_MAPS = 4
"""Largest number of pairs of lines with a map of distances on one plane."""
MIN_OVERLAP_POINTS = 30
"""Smallest number of points of a line in the overlap with another one; fewer do not represent a
surface, and their percentiles have no meaning."""
MAX_CORES_PER_LINE = 200
"""Largest number of places of each line at which distances along the normal are measured."""
CYLINDER_DIAMETER_PER_SPACING = 4.0
"""Diameter of a cylinder as a multiple of the point spacing of the sparser line, so that it
contains about twelve points of this line."""
NORMAL_SPHERE_FACTOR = 2.0
"""Diameter of the sphere of points used for a normal, as a multiple of the cylinder diameter."""


def are_reciprocal(heading_a: float, heading_b: float) -> bool:
    """Whether two headings are opposite within 20 degrees.

    Parameters
    ----------
    heading_a, heading_b : float, radians
    """
    turn = np.remainder(heading_a - heading_b, 2.0 * np.pi)
    return bool(abs(turn - np.pi) <= RECIPROCAL_TOLERANCE_RAD)


def comparable_pairs(
    before: Mapping[str, Array], after: Mapping[str, Array]
) -> tuple[tuple[str, str], ...]:
    """Pairs of lines that `compare_plane` compares on a plane.

    Parameters
    ----------
    before, after : mapping of line name to ndarray of shape (n, 3), metres, local frame
        As in `compare_plane`.
    """
    observed = _lines_with_enough_points(before)
    if len(observed) < 2:
        return ()
    overlap = LineOverlap(*_thinned_states(before, after, observed))
    return tuple(
        (a, b) for a, b in combinations(observed, 2) if _common_points(overlap, a, b) is not None
    )


def compare_plane(
    name: str,
    before: Mapping[str, Array],
    after: Mapping[str, Array],
    headings: Mapping[str, float],
    *,
    model: LocalModel = DEFAULT_MODEL,
    facing: Array | None = None,
    ranges: Mapping[str, Array] | None = None,
    errors: PlaneErrors | None = None,
    progress: Progress = no_progress,
) -> PlaneComparison:
    """Compare the lines on one validation plane, before and after.

    Parameters
    ----------
    name : str
        Name of the plane, for messages and the result.
    before, after : mapping of line name to ndarray of shape (n, 3), metres, local frame
        Points of each line on the plane, georeferenced with the prior and the estimated boresight:
        the same points in the same order. If a line has more than 100 000, only every second,
        third, ... point is used, the same ones in both states.
    headings : mapping of line name to float, radians
        Used to find reciprocal lines, which are the most sensitive to the boresight.
    model : LocalModel
        Model of the surface between the points of the other line.
    facing : ndarray of shape (3,), optional
        Direction towards the vessel, in which signed distances are positive. If omitted, the
        direction of the plane's normal whose largest component is positive.
    ranges : mapping of line name to ndarray of shape (n,), metres, optional
        Ranges of the same points; without them there is no profile against range.
    errors : PlaneErrors, optional
        Errors of the lines with the estimated boresight; without them neither shifts of lines nor
        two modes are found.

    Returns
    -------
    PlaneComparison
        Contains every pair of lines that overlaps, reciprocal pairs first. The pooled statistics
        and the histograms use all of them.
        The histograms extend from zero to the 99.5th percentile of the state with larger distances;
        the last bin includes larger distances, so that the counts add up to n.

    Raises
    ------
    NotComparable
        If fewer than two lines have enough points on the plane, or no two of them overlap.
    InputError
        If the two states have different points, a heading is missing, or points are not finite.
    """
    _require_same_points(name, before, after, headings)
    observed = _lines_with_enough_points(before)
    _require_two_lines(name, observed)
    lines = _ComparedLines.of(before, after, observed, model, ranges, facing)
    couples = sorted(
        combinations(observed, 2),
        key=lambda pair: not are_reciprocal(headings[pair[0]], headings[pair[1]]),
    )
    pairs: list[PairComparison] = []
    measured: list[_MeasuredDistances] = []
    for i, (a, b) in enumerate(couples):
        progress(
            i / len(couples),
            gettext_lazy("Comparing {one} and {other} on {target}", one=a, other=b, target=name),
        )
        if (a, b) not in lines.common:
            continue
        distances, signed, states = lines.compare(a, b)
        reciprocal = are_reciprocal(headings[a], headings[b])
        modes = _modes_of_pair(signed[-1], a, b, errors)
        pairs.append(PairComparison(a, b, reciprocal, states[0], states[1], modes))
        measured.append(lines.with_heights_and_ranges(a, b, distances))
    if not pairs:
        raise NotComparable(error("validation.no_overlap", plane=name, needed=MIN_OVERLAP_POINTS))
    progress(1.0)

    pool = _MeasuredDistances.of(measured)
    edges = shared_bin_edges(pool.before, pool.after)
    return PlaneComparison(
        name=name,
        pairs=tuple(pairs),
        not_compared=tuple(couple for couple in couples if couple not in lines.common),
        pooled_from="all pairs",
        bin_edges=edges,
        counts_before=histogram_counts(pool.before, edges),
        counts_after=histogram_counts(pool.after, edges),
        before=DistanceStatistics.of(pool.before),
        after=DistanceStatistics.of(pool.after),
        model=model,
        by_height=DistanceProfile.of(pool.height, pool.before, pool.after),
        by_range=None
        if pool.range is None
        else DistanceProfile.of(pool.range, pool.before, pool.after),
        maps=lines.distance_maps(pairs),
        shifts=() if errors is None else line_shifts(pairs, errors),
    )


@dataclass(frozen=True, eq=False)
class _ComparedLines:
    """Points of the lines on one plane, before and after the calibration.

    Attributes
    ----------
    clouds : tuple of two dicts of line name to ndarray of shape (n, 3), metres, local frame
        Thinned points, before and after.
    references : tuple of two dicts of line name to _Reference
        Search trees and surfaces of these points.
    ranges : dict of line name to ndarray of shape (n,), metres, or None
    overlap : LineOverlap
    common : dict of two line names to two ndarrays of shape (n,), bool
        Points of each line inside the footprint of the other, for the pairs that have enough.
    facing : ndarray of shape (3,), direction in which signed distances are positive
    """

    clouds: tuple[dict[str, Array], dict[str, Array]]
    references: "tuple[dict[str, _Reference], dict[str, _Reference]]"
    ranges: dict[str, Array] | None
    overlap: LineOverlap
    common: dict[tuple[str, str], tuple[Bools, Bools]]
    facing: Array

    @classmethod
    def of(
        cls,
        before: Mapping[str, Array],
        after: Mapping[str, Array],
        observed: Sequence[str],
        model: LocalModel,
        ranges: Mapping[str, Array] | None,
        facing: Array | None,
    ) -> "_ComparedLines":
        """Thin the points of the observed lines; ``facing`` as for `compare_plane`."""
        clouds = _thinned_states(before, after, observed)
        with ThreadPoolExecutor(len(clouds)) as pool:
            references = pool.map(lambda cloud: _references(cloud, model), clouds)
            overlap = LineOverlap(*clouds)
            first, second = references
        if facing is None:
            facing = overlap.normal * np.sign(overlap.normal[np.argmax(np.abs(overlap.normal))])
        thinned = None
        if ranges is not None:
            thinned = {line: _thin_evenly(ranges[line]) for line in observed}
        masks = {(a, b): _common_points(overlap, a, b) for a, b in combinations(observed, 2)}
        common = {pair: both for pair, both in masks.items() if both is not None}
        return cls(clouds, (first, second), thinned, overlap, common, facing)

    def compare(
        self, a: str, b: str
    ) -> tuple[list[Array], list[list[NormalDistances]], list[PairState]]:
        """Unsigned and signed distances and statistics of a pair, each before and after."""
        with ThreadPoolExecutor(len(self.clouds)) as pool:
            tasks = [
                pool.submit(
                    _compare_state, (cloud[a], cloud[b]), (references[a], references[b]),
                    self.common[a, b],
                    facing=self.facing, spacing=self.overlap.spacing(a, b),
                )
                for cloud, references in zip(self.clouds, self.references, strict=True)
            ]  # fmt: skip
            results = [task.result() for task in tasks]
        unsigned, signed, states = map(list, zip(*results, strict=True))
        return unsigned, signed, states

    def with_heights_and_ranges(
        self, a: str, b: str, distances: Sequence[Array]
    ) -> "_MeasuredDistances":
        """Distances of a pair with the heights, after the calibration, and ranges of its points."""
        masks = self.common[a, b]
        after = self.clouds[1]
        height = [after[line][mask, 2] for line, mask in zip((a, b), masks, strict=True)]
        return _MeasuredDistances(
            distances[0],
            distances[1],
            np.concatenate(height),
            None
            if self.ranges is None
            else np.concatenate(
                [self.ranges[line][mask] for line, mask in zip((a, b), masks, strict=True)]
            ),
        )

    def distance_maps(self, pairs: Sequence[PairComparison]) -> tuple[DistanceMap, ...]:
        """Maps of up to `MAX_MAPS` pairs, the largest offset after the calibration first."""
        maps: list[DistanceMap] = []
        for pair in sorted(pairs, key=_offset_after, reverse=True):
            if len(maps) == MAX_MAPS:
                break
            a, b = pair.line_a, pair.line_b
            before, after = self.clouds
            mapped = distance_map(
                (a, b), (before[a], after[a]), (before[b], after[b]), self.common[a, b][1],
                facing=self.facing, spacing=self.overlap.spacing(a, b),
                reach=(pair.before.distances.maximum, pair.after.distances.maximum),
            )  # fmt: skip
            maps += [] if mapped is None else [mapped]
        return tuple(maps)


@dataclass(frozen=True, eq=False)
class _Reference:
    """Points of a line in one state, to which distances are measured.

    The surfaces of a line are the same for all lines that are compared with it, and are therefore
    fitted once. They are None if distances are measured to the points.
    """

    tree: PointTree
    model: LocalModel
    surfaces: LocalSurfaces | None

    def distances(self, points: Array) -> Array:
        """Unsigned distances of points (n, 3), metres, local frame."""
        return cloud_to_cloud(
            points, self.tree, model=self.model, surfaces=self.surfaces, up_to_nearest=False
        )


def _references(cloud: Mapping[str, Array], model: LocalModel) -> dict[str, _Reference]:
    """References of the lines of one state; points of shape (n, 3), metres, local frame."""
    trees = {line: PointTree(points) for line, points in cloud.items()}
    return {
        line: _Reference(
            tree, model, None if model.kind == "point" else model.surfaces(tree, tree.points)
        )
        for line, tree in trees.items()
    }


def _compare_state(
    lines: tuple[Array, Array], references: tuple[_Reference, _Reference],
    common: tuple[Bools, Bools], *, facing: Array, spacing: float,
) -> tuple[Array, list[NormalDistances], PairState]:  # fmt: skip
    """Distances of two lines in one state: unsigned and along the normal, and their statistics.

    Parameters
    ----------
    lines : tuple of two ndarrays of shape (n, 3), metres, local frame
        All points of each line on the plane.
    references : tuple of two _Reference
        The same points, as references of the other line.
    common : tuple of two ndarrays of shape (n,), bool
        Points of each line inside the footprint of the other.
    """
    first, second = (line[mask] for line, mask in zip(lines, common, strict=True))
    unsigned = np.concatenate((references[1].distances(first), references[0].distances(second)))
    along_normal = signed_distances(
        *lines, (first, second), facing=facing, spacing=spacing, reach=unsigned.max()
    )
    state = PairState(
        DistanceStatistics.of(unsigned),
        SignedStatistics.of(along_normal) if along_normal else None,
        _plane_offset_between_lines(first, second, facing),
    )
    return unsigned, along_normal, state


def _modes_of_pair(
    distances: Sequence[NormalDistances], a: str, b: str, errors: PlaneErrors | None
) -> TwoModes | None:
    """Two modes of the distances of a pair of lines after the calibration, if there are any."""
    if errors is None or not distances or not {a, b} <= errors.lines.keys():
        return None
    # Measured from one line only; from the other, nearly the same distances are measured again.
    most = max(distances, key=lambda each: len(each.distance))
    return find_two_modes(most, float(np.hypot(errors.variation(a), errors.variation(b))))


def _offset_after(pair: PairComparison) -> float:
    """Absolute offset of the lines after the calibration, metres; -1 if it is not known."""
    return -1.0 if pair.after.signed is None else abs(pair.after.signed.median)


@dataclass(frozen=True, eq=False)
class _MeasuredDistances:
    """Distances of points before and after, and their heights and ranges; shape (n,), metres."""

    before: Array
    after: Array
    height: Array
    range: Array | None

    @classmethod
    def of(cls, several: "list[_MeasuredDistances]") -> "_MeasuredDistances":
        """Join several sets of distances."""
        ranges = [one.range for one in several if one.range is not None]
        return cls(
            np.concatenate([one.before for one in several]),
            np.concatenate([one.after for one in several]),
            np.concatenate([one.height for one in several]),
            np.concatenate(ranges) if ranges else None,
        )


def _thin_evenly(points: Array) -> Array:
    """Every n-th point, so that at most 100 000 remain."""
    step = -(-len(points) // MAX_POINTS_PER_LINE)
    return np.ascontiguousarray(points[::step], dtype=np.float64)


def _require_two_lines(plane: str, observed: Sequence[str]) -> None:
    """Refuse a plane that fewer than two lines observe.

    Raises
    ------
    NotComparable
        If there are fewer.
    """
    if not observed:
        raise NotComparable(
            error("validation.plane_in_no_line", plane=plane, needed=MIN_OVERLAP_POINTS)
        )
    if len(observed) < 2:
        raise NotComparable(
            error(
                "validation.plane_in_one_line",
                plane=plane,
                line=observed[0],
                needed=MIN_OVERLAP_POINTS,
            )
        )


def _lines_with_enough_points(points: Mapping[str, Array]) -> list[str]:
    return [line for line in points if len(points[line]) >= MIN_OVERLAP_POINTS]


def _thinned_states(
    before: Mapping[str, Array], after: Mapping[str, Array], lines: Sequence[str]
) -> tuple[dict[str, Array], dict[str, Array]]:
    """Points of some lines in both states, thinned to the number that is compared."""
    return (
        {line: _thin_evenly(before[line]) for line in lines},
        {line: _thin_evenly(after[line]) for line in lines},
    )


def _common_points(overlap: LineOverlap, a: str, b: str) -> tuple[Bools, Bools] | None:
    """Masks of the points of each line inside the other's footprint; None if too few."""
    masks = overlap.of(a, b), overlap.of(b, a)
    return masks if min(map(np.count_nonzero, masks)) >= MIN_OVERLAP_POINTS else None


def _require_same_points(
    name: str,
    before: Mapping[str, Array],
    after: Mapping[str, Array],
    headings: Mapping[str, float],
) -> None:
    """Refuse two states that do not have the same points.

    Raises
    ------
    InputError
        If lines, shapes or numbers of points differ, or a point is not finite.
    """
    if set(before) != set(after):
        only = tuple(sorted(set(before) ^ set(after)))
        raise InputError(error("validation.other_lines", plane=name, lines=only))
    for line in before:
        for shape, not_finite, points in (
            ("validation.shape_before", "validation.not_finite_before", before[line]),
            ("validation.shape_after", "validation.not_finite_after", after[line]),
        ):
            if points.ndim != 2 or points.shape[1] != 3:
                raise InputError(error(shape, plane=name, line=line, shape=str(points.shape)))
            if not np.isfinite(points).all():
                raise InputError(error(not_finite, plane=name, line=line))
        if len(before[line]) != len(after[line]):
            raise InputError(
                error(
                    "validation.other_points",
                    line=line,
                    plane=name,
                    before=len(before[line]),
                    after=len(after[line]),
                )
            )
        if line not in headings:
            raise InputError(error("validation.no_heading", line=line, plane=name))


def signed_distances(
    a: Array, b: Array, common: tuple[Array, Array], *, facing: Array, spacing: float, reach: float
) -> list[NormalDistances]:
    """Distances from the second line to the first along the normal, measured at places of both.

    Parameters
    ----------
    a, b : ndarrays of shape (n, 3) and (m, 3), metres, local frame
        All points of the two lines on the plane.
    common : tuple of two ndarrays of shape (k, 3) and (l, 3), metres, local frame
        Points of each line in the common part, at some of which distances are measured.
    facing : ndarray of shape (3,)
        Direction towards the vessel.
    spacing : float, metres
        Distance between the points of the sparser line in its sparse direction.
    reach : float, metres
        Largest distance between the two lines.

    Returns
    -------
    list of NormalDistances
        At the places of each line; empty if no place has enough points of both lines.
    """
    diameter = CYLINDER_DIAMETER_PER_SPACING * spacing
    parts = []
    for compared, reference, places, sign in ((a, b, common[1], 1.0), (b, a, common[0], -1.0)):
        step = -(-len(places) // MAX_CORES_PER_LINE)
        try:
            found = distances_along_normal(
                compared, reference, places[::step], facing=facing,
                normal_scale=NORMAL_SPHERE_FACTOR * diameter, diameter=diameter,
                depth=reach + diameter,
            )  # fmt: skip
        except NotComparable:
            continue
        parts.append(replace(found, distance=sign * found.distance))
    return parts


def _plane_offset_between_lines(a: Array, b: Array, facing: Array) -> PlaneOffset | None:
    """Offset from the plane of the second line to that of the first; None if one has no plane.

    Parameters
    ----------
    a, b : ndarray of shape (n, 3) and (m, 3), metres, same frame
        Points of the two lines.
    facing : ndarray of shape (3,)
        Direction towards the vessel.
    """
    try:
        return plane_offset(a, b, facing)
    except NotComparable:
        return None
