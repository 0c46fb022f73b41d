"""Boresight of a project from a file of point correspondences."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations, Sighting
from lispac.alternative_methods import AlternativeResult
from lispac.correspondences.adjustment import CorrespondenceEstimate, adjust_correspondences
from lispac.correspondences.point_pairs import PointPairs
from lispac.errors import InputError
from lispac.io.text.correspondence_file import read_correspondences
from lispac.messages import Message, error, note, warning
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

MAX_UNUSABLE_SHARE = 0.25
"""Share of pairs outside the trajectory from which a file is refused: its times are then probably
in another time base."""
NOISE_LIMITS_M = 1e-4, 10.0
"""Smallest and largest noise that may be given, metres."""
MAX_VARIANCE_FACTOR = 1.5
"""Variance factor of a given noise above which a warning says that it is too small."""


@dataclass(frozen=True, eq=False)
class CorrespondenceResult:
    """Boresight from point correspondences.

    Attributes
    ----------
    estimate : CorrespondenceEstimate
    count : int
        Number of adjusted pairs, rejected ones included.
    lines : tuple of str
        Lines of the project during which points of used pairs were measured.
    messages : tuple of Message
        Data used for the result, and its limitations.
    """

    estimate: CorrespondenceEstimate
    count: int
    lines: tuple[str, ...]
    messages: tuple[Message, ...]

    @property
    def alternative(self) -> AlternativeResult:
        """The result as that of an alternative method."""
        found = self.estimate
        return AlternativeResult(
            "correspondences", found.boresight, found.covariance, self.lines,
            int(found.used.sum()), self.messages,
        )  # fmt: skip


def correspondences(
    project: Project,
    survey: Survey,
    path: Path,
    *,
    time_shift: float = 0.0,
    noise: float | None = None,
    progress: Progress = no_progress,
) -> CorrespondenceResult:
    """Estimate the boresight from a file of point correspondences.

    Parameters
    ----------
    path : Path
        File as in `read_correspondences`, with coordinates in the frame of the raw lines.
    time_shift : float, seconds
        Added to the times of the file to bring them into the trajectory's time base.
    noise : float, metres, optional
        Standard deviation of a coordinate difference of a pair; estimated by default.

    Raises
    ------
    InputError
        If the file cannot be read, many of its times are outside the trajectory, or the noise is
        outside its limits.
    AdjustmentError
        If the pairs are too few or wrong, or do not determine the boresight.
    """
    low, high = NOISE_LIMITS_M
    if noise is not None and not low <= noise <= high:
        raise InputError(error("correspondences.noise_range", low=low, high=high))
    project.settings.require_sound()
    pairs = read_correspondences(path)
    pairs = PointPairs(pairs.time + time_shift, pairs.points_lidar)
    pairs, excluded = _usable_pairs(project, survey, path, pairs)
    ends = _end_observations(project, survey, pairs)
    found = adjust_correspondences(
        ends, project.mounting("prior"), project.settings.stochastic_model, noise=noise,
        progress=sub_progress(progress, 0.1, 1.0),
    )  # fmt: skip
    times = pairs.time[found.used].ravel()
    lines = tuple(
        name
        for name, scan in survey.scans.items()
        if ((times >= scan.first_time) & (times <= scan.last_time)).any()
    )
    messages = (*_messages(found, len(pairs), len(lines)), *excluded)
    return CorrespondenceResult(found, len(pairs), lines, messages)


def _usable_pairs(
    project: Project, survey: Survey, path: Path, pairs: PointPairs
) -> tuple[PointPairs, tuple[Message, ...]]:
    """Pairs that can be adjusted, and a note on the others.

    Raises
    ------
    InputError
        If many pairs are outside the trajectory.
    """
    track = survey.trajectory
    inside = track.covers(pairs.time + project.settings.latency).all(axis=1)
    outside = int((~inside).sum())
    if outside > MAX_UNUSABLE_SHARE * len(pairs):
        raise InputError(
            error(
                "correspondences.outside", file=str(path), count=outside, total=len(pairs),
                first=float(pairs.time.min()), last=float(pairs.time.max()),
                start=float(track.time[0]), end=float(track.time[-1]),
            )
        )  # fmt: skip
    away = (np.linalg.norm(pairs.points_lidar, axis=2) > 0).all(axis=1)
    first = pairs.first_of_each()
    kept = inside & away & first
    if kept.all():
        return pairs, ()
    omitted = note(
        "correspondences.not_used", file=path.name, count=int((~kept).sum()), total=len(pairs),
        outside=outside, origin=int((inside & ~away).sum()),
        repeated=int((inside & away & ~first).sum()),
    )  # fmt: skip
    return pairs.where(kept), (omitted,)


def _end_observations(project: Project, survey: Survey, pairs: PointPairs) -> Observations:
    """First points of all pairs, then their second points, with the poses and their accuracies."""
    time = pairs.time.T.ravel()
    points = np.ascontiguousarray(pairs.points_lidar.transpose(1, 0, 2).reshape(-1, 3))
    latency = project.settings.latency
    poses = survey.trajectory.at(time + latency)
    sigma_position, sigma_attitude = survey.accuracy.at(time)
    ends = Observations(
        points_lidar=points,
        position=poses.position,
        attitude=poses.attitude,
        sigma_lidar=np.zeros_like(points),
        sigma_position=sigma_position,
        sigma_attitude=sigma_attitude,
        latency=latency,
        time=time,
        sighting=np.zeros(len(time), dtype=np.int64),
        sightings=(Sighting("", ""),),
    )
    # Coordinates near the origin, so that differences lose no digits
    return replace(ends, origins={"": poses.position.mean(axis=0)})


def _messages(found: CorrespondenceEstimate, count: int, lines: int) -> tuple[Message, ...]:
    used = int(found.used.sum())
    messages = [
        note("correspondences.basis", used=used, count=count, lines=lines),
        note("correspondences.distance", before=found.rms_before, after=found.rms_after),
    ]
    if found.is_noise_estimated:
        messages.append(note("correspondences.noise", noise=found.noise))
    elif found.variance_factor > MAX_VARIANCE_FACTOR:
        ratio = float(np.sqrt(found.variance_factor))
        messages.append(warning("correspondences.noise_too_small", noise=found.noise, ratio=ratio))
    return tuple(messages)
