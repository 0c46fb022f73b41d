"""LiDAR patch test of a project: proposed objects and pairs, angles, assessment.

The patch test is an alternative to the adjustment of targets. It uses other objects and another
measure of mismatch, but the same georeferencing and POS errors. The project's targets are not used.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from lispac.errors import AdjustmentError
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.patchtest.bootstrap_precision import bootstrap_precision
from lispac.patchtest.line_mismatch import Mismatch, PairBlock, pair_blocks
from lispac.patchtest.line_pairs import Kind, LinePair, pairs_of_lines
from lispac.patchtest.mismatch_minimisation import (
    MismatchMinimum,
    minimise_angle_by_angle,
    minimise_mismatch,
)
from lispac.patchtest.object_boxes import PatchObject
from lispac.patchtest.object_proposal import MAX_OBJECTS, find_objects
from lispac.patchtest.object_sample import BOX_MARGIN, ObjectSample
from lispac.patchtest.patch_test_result import PatchTestResult
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project
from lispac.survey.cloud import Cloud, place_clouds
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

RESELECT_ANGLE = np.radians(0.05)
"""Change of an angle, radians, above which the points in the boxes are selected again: the lines
were misaligned before, so that a box contained different parts of the object in each line."""


@dataclass(frozen=True, eq=False)
class PlacedObjects:
    """Objects of a survey, with the points of each line in their boxes.

    Attributes
    ----------
    objects : tuple of PatchObject
    placings : tuple of ndarray of shape (3,), radians
        For each object, the boresight with which the lines were placed to select its points.
    sample : ObjectSample
    """

    objects: tuple[PatchObject, ...]
    placings: tuple[Array, ...]
    sample: ObjectSample = field(repr=False)

    @property
    def boresight(self) -> Array:
        """Boresight in `placings` of all objects, shape (3,), radians; NaN if they differ."""
        first, *others = self.placings or (np.full(3, np.nan),)
        same = all(np.array_equal(first, each) for each in others)
        return first if same else np.full(3, np.nan)

    def blocks(self, objects: Collection[str], pairs: Sequence[LinePair]) -> list[PairBlock]:
        """Blocks of points that are compared for some objects and pairs of lines."""
        return [b for b in pair_blocks(self.sample, pairs) if b.first.object.name in objects]

    def select_objects(self, names: Collection[str]) -> "PlacedObjects":
        """Select some of the objects."""
        kept = [k for k, each in enumerate(self.objects) if each.name in names]
        return PlacedObjects(
            tuple(self.objects[k] for k in kept),
            tuple(self.placings[k] for k in kept),
            self.sample.of_objects(names),
        )

    def joined_with(self, other: "PlacedObjects") -> "PlacedObjects":
        """Combine these objects with others; all names must differ."""
        return PlacedObjects(
            self.objects + other.objects,
            self.placings + other.placings,
            self.sample.joined_with(other.sample),
        )

    def moved_to_boresight(self, boresight: Array) -> tuple[PatchObject, ...]:
        """Objects with their boxes moved with the lines for another boresight.

        A box moves by the mean displacement of its points in the line with the most points in it.

        Parameters
        ----------
        boresight : ndarray of shape (3,), radians
        """
        after = self.sample.placed_points(boresight)
        before = {at.tobytes(): self.sample.placed_points(at) for at in self.placings}
        found = []
        for each, at in zip(self.objects, self.placings, strict=True):
            parts = [
                np.arange(seen.begin, seen.end)[seen.inside]
                for seen in self.sample.observed
                if seen.object.name == each.name
            ]
            own = max(parts, key=len, default=np.arange(0))
            if len(own):
                move = (after[own] - before[at.tobytes()][own]).mean(axis=0)
                each = replace(each, box=replace(each.box, centre=each.box.centre + move))
            found.append(each)
        return tuple(found)


def line_pairs(survey: Survey, kinds: Collection[Kind] = ()) -> tuple[LinePair, ...]:
    """Pairs of lines, reciprocal ones first; all pairs, or those of the given kinds."""
    return tuple(p for p in pairs_of_lines(survey.heading) if not kinds or p.kind in kinds)


def place_lines(project: Project, survey: Survey, boresight: Array) -> dict[str, Cloud]:
    """Place the lines with a boresight, shape (3,), radians."""
    return place_clouds(survey.clouds, project.mounting("prior").with_boresight(boresight))


def propose_objects(
    project: Project, survey: Survey, *, count: int = MAX_OBJECTS, progress: Progress = no_progress
) -> PlacedObjects:
    """Find objects that lines share, independent of the error of the prior boresight.

    Raises
    ------
    AdjustmentError
        If the lines share no object.
    """
    if len(survey.clouds) < 2:
        raise AdjustmentError(error("patch_test.single_line", project=project.name))
    progress(0.0, gettext_lazy("Aligning the lines"))
    boresight = survey.alignment.mounting.boresight
    clouds = place_lines(project, survey, boresight)
    progress(0.4, gettext_lazy("Detecting objects"))
    objects = find_objects(
        clouds, survey.accuracy, survey.lidar_sigma(project.settings), count=count,
        progress=sub_progress(progress, 0.4, 0.6),
    )  # fmt: skip
    if not objects:
        raise AdjustmentError(error("patch_test.nothing_shared", project=project.name))
    return place_objects(
        project, survey, objects, boresight, progress=sub_progress(progress, 0.6, 1.0)
    )


def place_objects(
    project: Project,
    survey: Survey,
    objects: Sequence[PatchObject],
    boresight: Array,
    *,
    margin: float = BOX_MARGIN,
    progress: Progress = no_progress,
) -> PlacedObjects:
    """Select the points of each line in the boxes of the objects.

    Parameters
    ----------
    boresight : ndarray of shape (3,), radians
        Boresight with which the lines are placed; the boxes must contain the objects then.
    """
    progress(0.0, gettext_lazy("Selecting the points around the objects"))
    clouds = place_lines(project, survey, boresight)
    sample = ObjectSample.of(objects, clouds, survey.scans, margin=margin, progress=progress)
    at = np.array(boresight, dtype=float)
    return PlacedObjects(tuple(objects), (at,) * len(objects), sample)


def find_boresight(
    project: Project,
    survey: Survey,
    placed: PlacedObjects,
    *,
    pairs: Sequence[LinePair] | None = None,
    start: Array | None = None,
    progress: Progress = no_progress,
) -> PatchTestResult:
    """Find the three angles with the smallest mismatch, and assess the result.

    Parameters
    ----------
    pairs : sequence of LinePair, optional
        Pairs of lines to compare; all pairs by default.
    start : ndarray of shape (3,), radians, optional
        Initial boresight; by default that with which the objects were placed.

    Raises
    ------
    AdjustmentError
        If lines do not overlap at the objects, or do not determine an angle.
    """
    project.settings.require_sound()
    chosen = line_pairs(survey) if pairs is None else tuple(pairs)
    names = {each.name for each in placed.objects}
    at = np.asarray(placed.boresight if start is None else start, dtype=float)
    all_angles = minimise_mismatch(
        placed.sample, placed.blocks(names, chosen), at, progress=sub_progress(progress, 0.0, 0.4)
    )
    if not np.abs(all_angles.boresight - placed.boresight).max() <= RESELECT_ANGLE:
        placed = place_objects(
            project,
            survey,
            placed.moved_to_boresight(all_angles.boresight),
            all_angles.boresight,
            progress=sub_progress(progress, 0.4, 0.5),
        )
        step = sub_progress(progress, 0.5, 0.7)
        all_angles = minimise_mismatch(
            placed.sample, placed.blocks(names, chosen), all_angles.boresight, progress=step
        )
    blocks = placed.blocks(names, chosen)
    angle_by_angle = minimise_angle_by_angle(
        placed.sample, blocks, at, progress=sub_progress(progress, 0.7, 1.0)
    )
    return _assess_patch_test(project, survey, placed, blocks, all_angles, angle_by_angle)


def find_angle(
    placed: PlacedObjects, blocks: Sequence[PairBlock], start: Array, angle: int,
    *, progress: Progress = no_progress,
) -> MismatchMinimum:  # fmt: skip
    """Find one angle with the smallest mismatch while the others are fixed.

    Parameters
    ----------
    start : ndarray of shape (3,), radians
    angle : int
        0 roll, 1 pitch, 2 yaw.

    Raises
    ------
    AdjustmentError
        If lines do not overlap at the objects, or do not determine the angle.
    """
    return minimise_mismatch(placed.sample, blocks, start, (angle,), progress=progress)


def _assess_patch_test(
    project: Project, survey: Survey, placed: PlacedObjects, blocks: Sequence[PairBlock],
    all_angles: MismatchMinimum, angle_by_angle: MismatchMinimum,
) -> PatchTestResult:  # fmt: skip
    model, mismatch = project.settings.stochastic_model, Mismatch(placed.sample, blocks)
    precision = bootstrap_precision(
        mismatch, all_angles.boresight, survey.accuracy, model.position_time, model.attitude_time
    )
    used_names = {each.name for each in precision.objects}
    used = [b for b in blocks if b.first.object.name in used_names]
    return PatchTestResult(
        boresight=all_angles.boresight,
        separate_boresight=angle_by_angle.boresight,
        covariance=precision.covariance,
        curvature=precision.curvature,
        mismatch_before=mismatch(project.mounting("prior").boresight),
        mismatch=mismatch(all_angles.boresight),
        lines=tuple(
            line for line in survey.lines if any(line in block.pair.lines for block in used)
        ),
        objects=precision.objects,
        iterations=angle_by_angle.iterations,
        converged=all_angles.converged and angle_by_angle.converged,
        objects_without_pairs=tuple(
            each.name for each in placed.objects if each.name not in used_names
        ),
    )
