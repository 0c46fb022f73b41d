"""Search for a target, plane or sphere, in one line or in all."""

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
from lispac.survey.cloud import MAX_POINTS, Cloud, SphereRegion
from lispac.targets.line_search import CLICK_GAP
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
OnePatch = TypeVar("OnePatch", PlanePatch, SpherePatch)

DEFAULT_RADII: dict[Role, tuple[float, ...]] = {"target": (2.0,), "validation": (4.0, 10.0, 20.0)}
"""Metres about the seed, tried in turn until two lines have the plane.

A board fits into two metres. A validation plane is a piece of a wall or a tower: more points make
the fit better, and its centre may be hidden from the lines or out of their reach.
"""

SPHERE_THRESHOLD, LARGEST_SHARE = 0.03, 0.3
"""Metres, and share of a known radius: default threshold for spheres.

A ball is small and crossed in a tenth of a second, in which a rolling vessel displaces its profiles
against each other by up to a centimetre. Planes get by with less, for they are crossed for longer
and only what lies across them counts. A threshold near the radius would take what is beside a small
ball for its surface.
"""

SPHERE_FACTOR = 3.0
"""Search radius about the seed in radii of a known sphere, where that is more than usual: the seed
may lie on the far side, and what is around the ball gives its place in the other lines."""

SEARCH_SAMPLE = 50_000
"""Points about a seed that are searched for a plane; where a line has more there, a fair sample
shows where the plane is, and then all points that lie on it are taken."""

CLICK_RADIUS = 0.1
"""Metres from a clicked point within which its neighbours are searched for."""

UP = np.array([0.0, 0.0, 1.0])

ALIGNED_MAX_SHIFT = 0.5
"""Metres that a target may be from one line to another where the lines are nearly aligned: what is
left is the error of the POS and of the rough boresight."""


@dataclass(frozen=True)
class TargetSearch:
    """Shape and size of the target to search for.

    Attributes
    ----------
    shape : {"plane", "sphere"}
    sphere_radius : float or None, metres
        None where it is unknown, and for planes.
    """

    shape: Shape = "plane"
    sphere_radius: float | None = None

    @classmethod
    def for_target(cls, target: Target) -> "TargetSearch":
        """Search for a target that is already picked, with its shape and radius."""
        return cls(target.shape, target.sphere_radius)

    @property
    def radius_range(self) -> RadiusRange:
        """Radii a sphere may have."""
        if self.sphere_radius is None:
            return RadiusRange()
        return RadiusRange.of_known_radius(self.sphere_radius)

    def search_radii(self, role: Role) -> tuple[float, ...]:
        """Default search radii about the seed, metres, tried in turn."""
        usual = DEFAULT_RADII[role]
        return tuple(max(radius, SPHERE_FACTOR * (self.sphere_radius or 0.0)) for radius in usual)

    def threshold(self, usual: float) -> float:
        """Default threshold, metres, where that for planes is ``usual``."""
        if self.shape == "plane":
            return usual
        if self.sphere_radius is None:
            return max(usual, SPHERE_THRESHOLD)
        return max(usual, min(SPHERE_THRESHOLD, LARGEST_SHARE * self.sphere_radius))

    def require_same(self, known: Target) -> None:
        """Refuse to add a sighting of another shape, or of another known radius, to a target.

        Raises
        ------
        ProjectError
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
        region = cloud.within(require_seed(seed), settings.radius, limit=SEARCH_SAMPLE)
        beside = _points_near_click(region, cloud, require_seed(seed))
        return _complete_plane(
            find_plane(region.points, seed, settings, beside=beside), region, cloud
        )

    def patch_of_points(self, cloud: Cloud, indices: NDArray[np.int64]) -> Patch:
        """The target that chosen points of a line form.

        Parameters
        ----------
        indices : ndarray of shape (n,), int

        Raises
        ------
        TargetNotFound
            Where they do not determine one.
        """
        points = cloud[indices]
        every = np.arange(len(points))
        if self.shape == "plane":
            return replace(patch_of(points, every, UP), indices=indices)
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
        """The target at the seed in every line, and why it is missing in the others.

        Of each line no more is read than what the target may be in. A surface that differs from
        the target by more than the accuracy of the placement allows is another one.

        Parameters
        ----------
        seed : ndarray of shape (3,), metres, local frame
        accuracy : PlacementAccuracy
            How well these lines are placed relative to each other.

        Raises
        ------
        TargetNotFound
            If it is in no line.
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
    """Find the plane at ``seed`` (3,), local frame, in every line, or why it is missing."""
    regions, points = _search_regions(clouds, seed, settings, limit=SEARCH_SAMPLE)
    beside = {
        name: _points_near_click(regions[name], cloud, seed) for name, cloud in clouds.items()
    }
    found, missing = find_in_lines(
        points, seed, settings, first_line=first_line, progress=progress,
        beside={name: close for name, close in beside.items() if close is not None},
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
    """Name of the clicked line; None if it is not known."""
    if first_line is not None:
        return first_line
    return next((name for name in lines if len(clouds[name].within(seed, CLICK_GAP).numbers)), None)


@dataclass(frozen=True, eq=False)
class SearchPlace:
    """Seed in the aligned lines, where a target is searched for.

    Attributes
    ----------
    clouds : mapping of line name to Cloud
    seed : ndarray of shape (3,), metres, local frame
        Moved as the line was that it was taken from.
    line : str or None
        The line that is.
    max_shift : float, metres
        Farthest the target may be from one line to another.
    accuracy : PlacementAccuracy
        Of the lines.
    """

    clouds: Mapping[str, Cloud]
    seed: Array
    line: str | None
    max_shift: float
    accuracy: PlacementAccuracy

    @classmethod
    def of(cls, aligned: Alignment, seed: Array, line: str | None, radius: float) -> "SearchPlace":
        """A seed as it was clicked or typed, with the lines as the prior boresight places them.

        Parameters
        ----------
        aligned : Alignment
        seed : ndarray of shape (3,), metres, local frame
        line : str or None
            The line it was taken from. Where that is not known, a line with a point at the seed.
        radius : float, metres
            Search radius about the seed.
        """
        seed = require_seed(seed)
        reach = ALIGNED_MAX_SHIFT if aligned.is_aligned else FinderSettings().max_shift
        reaches = (CLICK_GAP,) if line is None else (CLICK_GAP, 0.1, radius)
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
    """The line's point nearest to the seed: how far off, the line, how the point was moved."""
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
            "finder.points_thinned", target=target.name, line=sighting.line, most=MAX_POINTS,
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
    """A sampled line's points close to a click in it, the nearest first.

    The sample may lack all of them, and a click on the edge of a board would then seem to float
    before the wall behind.
    """
    if region.one_in == 1 or len(cloud.within(seed, CLICK_GAP).numbers) == 0:
        return None
    points = cloud.within(seed, CLICK_RADIUS).points
    return points[np.argsort(np.linalg.norm(points - seed, axis=1), kind="stable")]


def _with_point_numbers(patch: OnePatch, region: SphereRegion) -> OnePatch:
    """The patch with the numbers of its points in the line, not in the region it was found in."""
    return replace(patch, indices=region.numbers[patch.indices], one_in=region.one_in)


def _complete_plane(patch: PlanePatch, region: SphereRegion, cloud: Cloud) -> PlanePatch:
    """All of the line's points on a plane that was found among some of them."""
    if region.one_in == 1:
        return _with_point_numbers(patch, region)
    some = region.points[patch.indices]
    reach = float(np.linalg.norm(some - patch.centre, axis=1).max())
    there = cloud.within(patch.centre, reach)
    complete = extend_sample_patch(there.points, some, patch.plane)
    return replace(complete, indices=there.numbers[complete.indices], one_in=there.one_in)
