"""Search for a target of any shape in every line, starting from one seed.

The boresight is not yet known, so in the other lines the target may be a metre or more from the
seed. The target is first found in one line, the reference. For each other line, the translation of
the reference's surroundings onto this line predicts the position of the target. The search there
and the comparison with the reference depend on the shape.
"""

import os
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from lispac.errors import TargetNotFound
from lispac.geometry.radius_search import PointGrid, nearest_point, points_within
from lispac.language import gettext_lazy
from lispac.messages import Message, as_message, error, note
from lispac.progress import Progress
from lispac.targets.cloud_shift import CloudShift, find_shifts, voxel_numbers
from lispac.targets.finder_settings import FinderSettings

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Patch = TypeVar("Patch")

# Share of the patch in the total weight that determines the translation; its surroundings have the
# remainder.
PATCH_WEIGHT_SHARE = 0.5
# A seed within this distance of a point of a line, metres, is considered a point of that line:
# coordinates are often written with three decimals.
MAX_CLICK_DISTANCE = 0.002
# Largest number of translations tested, and ratio to the best score above which another patch is
# considered about as good.
MAX_TESTED_SHIFTS, AMBIGUOUS_SCORE_RATIO = 6, 0.97
# If the best match has a score below this share of the best translation's score, it differs from
# the reference, and more translations are tested.
MIN_MATCH_SCORE_RATIO = 0.9


@dataclass(frozen=True)
class ShapeSearch(Generic[Patch]):
    """Functions and messages that the search needs for one shape.

    Attributes
    ----------
    no_line : str
        Code of the message that there is no line.
    in_no_line : str
        Code of the message that no line has the target, with the reason for the nearest line.
    error : type of TargetNotFound
    find : callable of a line's name
        Finds the patch at the seed; raises TargetNotFound.
    distance : callable of a line's name and its patch
        Gives the distance of the patch from the seed, metres.
    follow : callable of a line's name and its patch
        Gives a function that finds this patch in another line, given by its name, and raises
        TargetNotFound.
    is_cut : callable of a line and a patch
        Whether the patch is cut by the search radius, so that it is part of a larger surface.
    """

    no_line: str
    in_no_line: str
    error: type[TargetNotFound]
    find: Callable[[str], Patch]
    distance: Callable[[str, Patch], float]
    follow: Callable[[str, Patch], Callable[[str], Patch]]
    is_cut: Callable[[str, Patch], bool] = lambda name, patch: False


@dataclass(frozen=True, eq=False)
class WeightedSurroundings:
    """Points around a patch, with weights for the determination of the shift.

    Attributes
    ----------
    points : ndarray of shape (n, 3), metres, local frame
    weights : ndarray of shape (n,)
    """

    points: Array
    weights: Array


def search_target_in_lines(
    clouds: Mapping[str, Array],
    grids: Mapping[str, PointGrid],
    seed: Array,
    shape: ShapeSearch[Patch],
    first_line: str | None,
    progress: Progress,
) -> tuple[dict[str, Patch], dict[str, Message]]:
    """Find the target at the seed in every line, or the reason why a line has none.

    Parameters
    ----------
    seed : ndarray of shape (3,), metres, local frame

    Raises
    ------
    TargetNotFound
        The error of the shape: the clicked line has no such target at the seed, or no line has.
    """
    if first_line is not None:
        if first_line not in clouds:
            raise shape.error(error("finder.unknown_line", line=first_line))
        return _search_from_reference(clouds, first_line, shape.find(first_line), shape, progress)
    patches, reasons = _search_each_line(clouds, shape.find)
    if not patches:
        # Only the reason for the nearest line is given; a list for all lines would not help.
        if not clouds:
            raise shape.error(error(shape.no_line))
        nearest_line = min(clouds, key=lambda name: nearest_point(clouds[name], seed)[1])
        raise shape.error(
            error(shape.in_no_line, line=nearest_line, reason=reasons[nearest_line].reason)
        )
    clicked = _clicked_line(clouds, grids, seed)
    if clicked in patches:
        nearest = [clicked]
    else:
        nearest = sorted(patches, key=lambda name: shape.distance(name, patches[name]))
        # A wall is seen in more lines than a board before it, which must not be replaced by it.
        if not shape.is_cut(nearest[0], patches[nearest[0]]):
            nearest = [name for name in nearest if not shape.is_cut(name, patches[name])]
    best: tuple[dict[str, Patch], dict[str, Message]] | None = None
    for name in nearest[:3]:
        both = _search_from_reference(clouds, name, patches[name], shape, progress)
        if best is None or len(both[0]) > len(best[0]):
            best = both
        if not both[1]:
            break
    assert best is not None
    return best


def indices_near(cloud: Array, grid: PointGrid | None, centre: Array, radius: float) -> Indices:
    """Indices of a line's points within a sphere, using prepared cells if there are any.

    Parameters
    ----------
    cloud : ndarray of shape (n, 3), metres, local frame
    centre : ndarray of shape (3,), metres, local frame
    radius : float, metres

    Returns
    -------
    ndarray of shape (k,), int
    """
    return points_within(cloud, centre, radius) if grid is None else grid.within(centre, radius)


def surroundings_of_patch(
    cloud: Array,
    grid: PointGrid | None,
    patch: Indices,
    centre: Array,
    seed: Array,
    settings: FinderSettings,
) -> WeightedSurroundings:
    """Points within the search radius of the seed, with weights that favour those near the patch.

    Parameters
    ----------
    cloud : ndarray of shape (n, 3), metres, local frame
    patch : ndarray of shape (k,), int
        Indices of the patch.
    centre, seed : ndarray of shape (3,), metres, local frame
    """
    around = indices_near(cloud, grid, seed, settings.radius)
    on_patch = np.isin(around, patch, assume_unique=True)
    # Surroundings near the patch have the same displacement; farther away it differs slightly.
    distance = np.linalg.norm(cloud[around] - centre, axis=1)
    weights = 1.0 / (1.0 + (distance / (0.5 * settings.radius)) ** 2)
    beside = ~on_patch
    if beside.any() and on_patch.any():
        # Weights are per voxel, as in the comparison; otherwise a dense patch would dominate.
        ratio = _count_filled_voxels(cloud[around[on_patch]]) / max(
            1, _count_filled_voxels(cloud[around[beside]])
        )
        weights[beside] *= (
            ratio * (1.0 - PATCH_WEIGHT_SHARE) / PATCH_WEIGHT_SHARE / weights[beside].mean()
        )
        weights[on_patch] = 1.0
    return WeightedSurroundings(cloud[around], weights)


def find_shifts_into_line(
    cloud: Array,
    grid: PointGrid | None,
    reference: WeightedSurroundings,
    seed: Array,
    settings: FinderSettings,
) -> list[CloudShift]:
    """Translations of the reference's surroundings onto another line, the best first.

    Parameters
    ----------
    cloud : ndarray of shape (n, 3), metres, local frame
    seed : ndarray of shape (3,), metres, local frame

    Raises
    ------
    TargetNotFound
        If there are none.
    """
    reach = settings.radius + settings.max_shift
    around = cloud[indices_near(cloud, grid, seed, reach)]
    if len(around) < settings.min_points:
        raise TargetNotFound(
            error("finder.line_few_points", count=len(around), radius=reach)
            if len(around)
            else error("finder.line_no_points", radius=reach)
        )
    shifts = find_shifts(reference.points, reference.weights, around, settings.max_shift)
    if not shifts:
        raise TargetNotFound(error("finder.not_alike"))
    return shifts[:MAX_TESTED_SHIFTS]


def best_match(
    shifts: list[CloudShift],
    match: Callable[[CloudShift], tuple[Patch, float]],
    contradiction: Callable[[Patch, Patch], Message | str | None],
    more_shifts: Callable[[], list[CloudShift]] = list,
    finer_scores: Callable[[list[CloudShift]], list[float]] | None = None,
    is_same: Callable[[Patch, Patch], bool] = lambda best, other: False,
) -> Patch:
    """Patch that matches the reference best, among those at the most likely translations.

    Parameters
    ----------
    shifts : list of CloudShift, the best first
    match : callable of a CloudShift
        Gives the patch at a translation and its score, which is at most the score of the
        translation; raises TargetNotFound.
    contradiction : callable of the best patch and another
        Gives a message if only one of the two can be the target, otherwise None.
    more_shifts : callable
        Gives more translations, the best first; used if no match at ``shifts`` resembles the
        reference.
    finer_scores : callable of translations, optional
        Gives scores by a finer comparison; used if several matches are about equally good.
    is_same : callable of the best patch and another
        Whether both are the same patch, so that no decision is needed.

    Raises
    ------
    TargetNotFound
        If there is no patch at any translation, or two patches contradict each other.
    """
    refused: list[TargetNotFound] = []
    matches = _match_shifts(shifts, match, refused)
    if (
        max((score for _, score, _ in matches), default=0.0)
        < MIN_MATCH_SCORE_RATIO * shifts[0].score
    ):
        matches += _match_shifts(more_shifts(), match, refused)
    if not matches:
        raise TargetNotFound(refused[0].reason)
    matches = _matches_close_to_best(matches)
    if finer_scores is not None and not all(
        is_same(matches[0][0], other) for other, _, _ in matches[1:]
    ):
        scores = finer_scores([shift for _, _, shift in matches])
        matches = _matches_close_to_best([
            (patch, score * fine_score / shift.score, shift)
            for (patch, score, shift), fine_score in zip(matches, scores, strict=True)
        ])  # fmt: skip
    best = matches[0][0]
    for other, _, _ in matches[1:]:
        message = contradiction(best, other)
        if message is not None:
            raise TargetNotFound(message)
    return best


def _matches_close_to_best(
    matches: list[tuple[Patch, float, CloudShift]],
) -> list[tuple[Patch, float, CloudShift]]:
    """Matches that are about as good as the best one, which comes first."""
    ranked = sorted(matches, key=lambda scored: -scored[1])
    return [scored for scored in ranked if scored[1] > AMBIGUOUS_SCORE_RATIO * ranked[0][1]]


def _match_shifts(
    shifts: list[CloudShift],
    match: Callable[[CloudShift], tuple[Patch, float]],
    refused: list[TargetNotFound],
) -> list[tuple[Patch, float, CloudShift]]:
    found: list[tuple[Patch, float, CloudShift]] = []
    for shift in shifts:
        if found and shift.score < AMBIGUOUS_SCORE_RATIO * max(score for _, score, _ in found):
            break  # a match never has a higher score than its translation: no better one can follow
        try:
            found.append((*match(shift), shift))
        except TargetNotFound as reason:
            refused.append(reason)
    return found


def _search_each_line(
    clouds: Mapping[str, Array],
    search: Callable[[str], Patch],
    done: Callable[[int, str], None] = lambda count, name: None,
) -> tuple[dict[str, Patch], dict[str, TargetNotFound]]:
    """Search each line on all cores: the patches found, and the reasons for the other lines."""
    found: dict[str, Patch] = {}
    missing: dict[str, TargetNotFound] = {}

    def attempt(name: str) -> Patch | TargetNotFound:
        try:
            return search(name)
        except TargetNotFound as reason:
            return reason

    pool = ThreadPoolExecutor(max(1, min(os.cpu_count() or 1, len(clouds))))
    try:
        results = pool.map(attempt, clouds)
        for count, (name, result) in enumerate(zip(clouds, results, strict=True), start=1):
            if isinstance(result, TargetNotFound):
                missing[name] = result
            else:
                found[name] = result
            done(count, name)
    finally:  # cancelled inside the progress call: remaining searches are not started
        pool.shutdown(cancel_futures=True)
    return found, missing


def _search_from_reference(
    clouds: Mapping[str, Array],
    first_line: str,
    first: Patch,
    shape: ShapeSearch[Patch],
    progress: Progress,
) -> tuple[dict[str, Patch], dict[str, Message]]:
    again = shape.follow(first_line, first)
    found, missing = _search_each_line(
        clouds,
        lambda name: first if name == first_line else again(name),
        lambda count, name: progress(
            count / len(clouds),
            gettext_lazy("Search for the target in {line} finished", line=name),
        ),
    )
    return found, {name: _at_prediction(as_message(each.reason)) for name, each in missing.items()}


def _at_prediction(reason: Message) -> Message:
    """Reason why a line has no target, with the place where it was searched for.

    This place is predicted from the surroundings of the target and differs from the seed.
    """
    if "place" not in reason.params:
        return reason
    place = note("finder.predicted_position")
    return replace(reason, params={**reason.params, "place": place})


def _clicked_line(
    clouds: Mapping[str, Array], grids: Mapping[str, PointGrid], seed: Array
) -> str | None:
    """Line with a point within `MAX_CLICK_DISTANCE` of the seed, the nearest; None without one."""
    nearest: tuple[float, str] | None = None
    for name, cloud in clouds.items():
        at_seed = indices_near(cloud, grids.get(name), seed, MAX_CLICK_DISTANCE)
        if len(at_seed):
            off = float(np.linalg.norm(cloud[at_seed] - seed, axis=1).min())
            nearest = min(nearest, (off, name)) if nearest else (off, name)
    return nearest[1] if nearest else None


def _count_filled_voxels(points: Array) -> int:
    return len(np.unique(voxel_numbers(points, 0.1)))
