"""Search for a target (plane or sphere) in one line or in all lines."""

import os
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from lispac.errors import ProjectError
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress
from lispac.project import Role, Shape, Target
from lispac.survey.cloud import MAX_REGION_POINTS, Cloud, SphereRegion
from lispac.targets.line_search import MAX_CLICK_DISTANCE
from lispac.targets.plane_finder import (
    FinderSettings,
    PlanePatch,
    extend_sample_patch,
    find_plane,
    patch_of,
    require_seed,
)
from lispac.targets.planes_across_lines import find_in_lines
from lispac.targets.rough_alignment import Alignment
from lispac.targets.sighting_agreement import PRIOR_ACCURACY, PlacementAccuracy, split_by_agreement
from lispac.targets.sphere_finder import RadiusRange, SpherePatch, find_sphere, patch_on_sphere
from lispac.targets.spheres_across_lines import find_spheres_in_lines

Array = NDArray[np.float64]
Patch = PlanePatch | SpherePatch
PatchT = TypeVar("PatchT", PlanePatch, SpherePatch)

DEFAULT_RADII: dict[Role, tuple[float, ...]] = {"target": (2.0,), "validation": (4.0, 10.0, 20.0)}
"""Search radii about the seed by role, metres, tried in turn until the plane is found in two lines.

A board fits into a radius of two metres. A validation plane is a part of a wall or a tower: more
points improve the fit, and its centre may be occluded or out of the range of the lines.
"""

SPHERE_THRESHOLD, MAX_THRESHOLD_SHARE = 0.03, 0.3
"""Default threshold for spheres, metres, and its largest share of a known radius.

A ball is crossed in a tenth of a second, during which the roll of the vessel displaces its profiles
by up to a centimetre relative to each other. A smaller threshold is enough for planes, because they
are crossed for longer and only the displacement along the normal has an effect. A threshold close
to the radius would include points beside a small ball.
"""

SPHERE_RADIUS_FACTOR = 3.0
"""Search radius about the seed in radii of a known sphere, if that is more than the default. The
seed may be on the far side of the ball, and the surroundings help to find it in other lines."""

MAX_SAMPLE_POINTS = 50_000
"""Largest number of points about a seed in which a plane is searched for. If a line has more, the
plane is found in a sample, and then all points on it are selected."""

CLICK_RADIUS = 0.1
"""Metres from a clicked point within which its neighbours are searched for."""

UP_VECTOR = np.array([0.0, 0.0, 1.0])
"""Direction to which the normal of a fitted plane is turned."""

ALIGNED_MAX_SHIFT = 0.5
"""Largest displacement of a target between approximately aligned lines, metres, due to the errors
of the POS and of the approximate boresight."""


@dataclass(frozen=True)
class TargetSearch:
    """Shape and size of the target to search for.

    Attributes
    ----------
    shape : {"plane", "sphere"}
    sphere_radius : float or None, metres
        None if it is unknown, and for planes.
    """

    shape: Shape = "plane"
    sphere_radius: float | None = None

    @classmethod
    def for_target(cls, target: Target) -> "TargetSearch":
        """Make the search for a picked target, with its shape and radius."""
        return cls(target.shape, target.sphere_radius)

    @property
    def radius_range(self) -> RadiusRange:
        """Smallest and largest radius that a sphere may have."""
        if self.sphere_radius is None:
            return RadiusRange()
        return RadiusRange.of_known_radius(self.sphere_radius)

    def search_radii(self, role: Role) -> tuple[float, ...]:
        """Default search radii about the seed, metres, tried in turn."""
        usual = DEFAULT_RADII[role]
        return tuple(
            max(radius, SPHERE_RADIUS_FACTOR * (self.sphere_radius or 0.0)) for radius in usual
        )

    def threshold(self, usual: float) -> float:
        """Default threshold, metres, from ``usual``, the one for planes."""
        if self.shape == "plane":
            return usual
        if self.sphere_radius is None:
            return max(usual, SPHERE_THRESHOLD)
        return max(usual, min(SPHERE_THRESHOLD, MAX_THRESHOLD_SHARE * self.sphere_radius))

    def require_same(self, known: Target) -> None:
        """Refuse to add a sighting of another shape, or of another known radius, to a target.

        Raises
        ------
        ProjectError
            If the shape or the known radius differs.
        """
        if known.shape != self.shape:
            raise ProjectError(
                error(
                    "pick.is_plane" if known.shape == "plane" else "pick.is_sphere",
                    target=known.name,
                )
            )
        if known.sphere_radius != self.sphere_radius:
            raise ProjectError(
                error("pick.radius_unknown", target=known.name)
                if known.sphere_radius is None
                else error("pick.other_radius", target=known.name, radius=known.sphere_radius)
            )

    def find_at_seed(self, cloud: Cloud, seed: Array, settings: FinderSettings) -> Patch:
        """Find the target at the seed in one line.

        Parameters
        ----------
        seed : ndarray of shape (3,), metres, local frame

        Raises
        ------
        TargetNotFound
            If there is none.
        """
        if self.shape == "sphere":
            region = cloud.within(require_seed(seed), settings.radius)
            return _with_point_numbers(
                find_sphere(region.points, seed, self.radius_range, settings), region
            )
        region = cloud.within(require_seed(seed), settings.radius, limit=MAX_SAMPLE_POINTS)
        points_at_seed = _points_near_click(region, cloud, require_seed(seed))
        return _complete_plane(
            find_plane(region.points, seed, settings, points_at_seed=points_at_seed), region, cloud
        )

    def patch_of_points(self, cloud: Cloud, indices: NDArray[np.int64]) -> Patch:
        """Fit the target to selected points of a line.

        Parameters
        ----------
        indices : ndarray of shape (n,), int

        Raises
        ------
        TargetNotFound
            If the points do not determine a target.
        """
        points = cloud[indices]
        every = np.arange(len(points))
        if self.shape == "plane":
            return replace(patch_of(points, every, UP_VECTOR), indices=indices)
        patch = patch_on_sphere(points, every, self.radius_range)
        return replace(patch, indices=indices[patch.indices])

    def find_in_lines(
        self,
        clouds: Mapping[str, Cloud],
        seed: Array,
        settings: FinderSettings,
        *,
        first_line: str | None = None,
        accuracy: PlacementAccuracy = PRIOR_ACCURACY,
        progress: Progress = no_progress,
    ) -> tuple[Mapping[str, Patch], dict[str, Message]]:
        """Find the target at the seed in every line, with the reasons for lines without it.

        Only the part of each line that may contain the target is read. A surface that differs from
        the target by more than the accuracy of the placement is considered another one.

        Parameters
        ----------
        seed : ndarray of shape (3,), metres, local frame
        accuracy : PlacementAccuracy
            Accuracy of the placement of the lines relative to each other.

        Raises
        ------
        TargetNotFound
            If the target is found in no line.
        """
        if self.shape == "plane":
            return find_planes_in_lines(
                clouds, seed, settings, first_line=first_line, accuracy=accuracy, progress=progress
            )
        regions, points = _search_regions(clouds, seed, settings)
        found, missing = find_spheres_in_lines(
            points, seed, self.radius_range, settings, first_line=first_line, progress=progress
        )
        numbered = {
            name: _with_point_numbers(patch, regions[name]) for name, patch in found.items()
        }
        kept, rejected = split_by_agreement(
            numbered,
            clouds,
            accuracy,
            settings.radius,
            _clicked_line(first_line, numbered, seed, clouds),
        )
        return kept, missing | rejected


def find_planes_in_lines(
    clouds: Mapping[str, Cloud],
    seed: Array,
    settings: FinderSettings,
    *,
    first_line: str | None = None,
    accuracy: PlacementAccuracy = PRIOR_ACCURACY,
    progress: Progress = no_progress,
) -> tuple[dict[str, PlanePatch], dict[str, Message]]:
    """Find the plane at the seed in every line, with the reasons for lines without it.

    Parameters and errors as for `TargetSearch.find_in_lines`.
    """
    regions, points = _search_regions(clouds, seed, settings, limit=MAX_SAMPLE_POINTS)
    points_at_seed = {
        name: _points_near_click(regions[name], cloud, seed) for name, cloud in clouds.items()
    }
    found, missing = find_in_lines(
        points, seed, settings, first_line=first_line, progress=progress,
        points_at_seed={name: close for name, close in points_at_seed.items() if close is not None},
    )  # fmt: skip
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        every = pool.map(
            lambda name: _complete_plane(found[name], regions[name], clouds[name]), found
        )
        whole = dict(zip(found, every, strict=True))
    kept, rejected = split_by_agreement(
        whole, clouds, accuracy, settings.radius, _clicked_line(first_line, whole, seed, clouds)
    )
    return kept, missing | rejected


def _clicked_line(
    first_line: str | None, lines: Iterable[str], seed: Array, clouds: Mapping[str, Cloud]
) -> str | None:
    """Line in which the seed was clicked; None if it is not given and no line has a point there."""
    if first_line is not None:
        return first_line
    return next(
        (name for name in lines if len(clouds[name].within(seed, MAX_CLICK_DISTANCE).numbers)), None
    )


@dataclass(frozen=True, eq=False)
class SearchPlace:
    """Approximately aligned lines, and the seed in them, for the search of a target.

    Attributes
    ----------
    clouds : mapping of line name to Cloud
        Aligned lines.
    seed : ndarray of shape (3,), metres, local frame
        Seed, moved by the alignment of the line from which it was taken.
    line : str or None
        Line from which the seed was taken; None if it is not known.
    max_shift : float, metres
        Largest displacement of the target between lines.
    accuracy : PlacementAccuracy
        Accuracy of the placement of the lines.
    """

    clouds: Mapping[str, Cloud]
    seed: Array
    line: str | None
    max_shift: float
    accuracy: PlacementAccuracy

    @classmethod
    def of(cls, aligned: Alignment, seed: Array, line: str | None, radius: float) -> "SearchPlace":
        """Search place of a seed that was clicked or typed in the lines with the prior boresight.

        Parameters
        ----------
        aligned : Alignment
        seed : ndarray of shape (3,), metres, local frame
        line : str or None
            Line from which the seed was taken; if None, a line with a point at the seed is used.
        radius : float, metres
            Search radius about the seed.
        """
        seed = require_seed(seed)
        reach = ALIGNED_MAX_SHIFT if aligned.is_aligned else FinderSettings().max_shift
        reaches = (MAX_CLICK_DISTANCE,) if line is None else (MAX_CLICK_DISTANCE, 0.1, radius)
        nearest: list[tuple[float, str, Array]] = []
        for name in aligned.before if line is None else (line,):
            nearest += _nearest_point(aligned, name, seed, reaches)
        if not nearest:
            return cls(aligned.clouds, seed, line, reach, aligned.accuracy)
        _, line, move = min(nearest, key=lambda found: found[:2])
        return cls(aligned.clouds, seed + move, line, reach, aligned.accuracy)


def _nearest_point(
    aligned: Alignment, line: str, seed: Array, reaches: tuple[float, ...]
) -> list[tuple[float, str, Array]]:
    """Distance of the line's point nearest to the seed, the line, and the shift of the point."""
    before = aligned.before.get(line)
    if before is None:
        return []
    for reach in reaches:
        region = before.within(seed, reach)
        if len(region.points):
            distances = np.linalg.norm(region.points - seed, axis=1)
            own = region.numbers[np.argmin(distances)][None]
            return [(float(distances.min()), line, (aligned.clouds[line][own] - before[own])[0])]
    return []


def thinned_notes(target: Target) -> tuple[Message, ...]:
    """Notes on the sightings for which not all points around the seed were used."""
    return tuple(
        note(
            "finder.points_thinned", target=target.name, line=sighting.line, most=MAX_REGION_POINTS,
            one_in=sighting.one_in,
        )
        for sighting in target.sightings
        if sighting.one_in > 1
    )  # fmt: skip


def _search_regions(
    clouds: Mapping[str, Cloud], seed: Array, settings: FinderSettings, *, limit: int | None = None
) -> tuple[dict[str, SphereRegion], dict[str, Array]]:
    """Search region of each line around the seed, and its points."""
    seed, reach = require_seed(seed), settings.radius + settings.max_shift

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        read = pool.map(lambda cloud: cloud.within(seed, reach, limit=limit), clouds.values())
        regions = dict(zip(clouds, read, strict=True))
    return regions, {name: region.points for name, region in regions.items()}


def _points_near_click(region: SphereRegion, cloud: Cloud, seed: Array) -> Array | None:
    """Points close to a click in a line that is sampled, the nearest first.

    The sample may contain none of these points. A click on the edge of a board would then appear to
    be in front of the wall behind it.
    """
    if region.one_in == 1 or len(cloud.within(seed, MAX_CLICK_DISTANCE).numbers) == 0:
        return None
    points = cloud.within(seed, CLICK_RADIUS).points
    return points[np.argsort(np.linalg.norm(points - seed, axis=1), kind="stable")]


def _with_point_numbers(patch: PatchT, region: SphereRegion) -> PatchT:
    """Patch with the indices of its points in the line instead of in the search region."""
    return replace(patch, indices=region.numbers[patch.indices], one_in=region.one_in)


def _complete_plane(patch: PlanePatch, region: SphereRegion, cloud: Cloud) -> PlanePatch:
    """Patch with all points of the line on a plane that was found in a sample."""
    if region.one_in == 1:
        return _with_point_numbers(patch, region)
    some = region.points[patch.indices]
    reach = float(np.linalg.norm(some - patch.centre, axis=1).max())
    there = cloud.within(patch.centre, reach)
    complete = extend_sample_patch(there.points, some, patch.plane)
    return replace(complete, indices=there.numbers[complete.indices], one_in=there.one_in)
