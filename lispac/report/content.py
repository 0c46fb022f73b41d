"""What a report says, as numbers: the one content behind PDF, HTML and JSON."""

import hashlib
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import lispac
from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.geometry.rotations import rotation_derivatives, rotation_matrix
from lispac.progress import Progress, no_progress, part
from lispac.project import Project, Target
from lispac.report.cautions import cautions_of
from lispac.report.values import (
    Adjustment,
    Angle,
    Chi2,
    Distances,
    Effect,
    InputFile,
    Line,
    Pair,
    PickedPlane,
    ReportContent,
    SettingsUsed,
    SightingFit,
    TargetFit,
    ValidationPlane,
)
from lispac.validation.comparison import DistanceStatistics, PlaneComparison

__all__ = ["CONVENTION", "ReportContent", "report_content"]

Array = NDArray[np.float64]

NORMAL_95 = 1.96
"""Half width of the 95 % interval of a normal variable, in standard deviations."""

EFFECT_DISTANCES_M = (10.0, 50.0, 100.0)

CONVENTION = (
    "Local frame: north, west, up. Body frame: forward, left, up. Roll is positive with the left "
    "side up, pitch positive with the bow down, yaw positive clockwise seen from above. The "
    "boresight turns LiDAR axes into body axes: R = Rz(−yaw)·Ry(pitch)·Rx(roll). Other programs "
    "use other signs and orders: convert before typing these angles into one."
)

POS_ERROR_WORDS = {
    "correlated": (
        "All points of one sighting share the errors of position and attitude they were placed "
        "with, and sightings close in time share part of them (first-order Gauss-Markov process)."
    ),
    "independent": (
        "Every point has errors of position and attitude of its own, independent of all others."
    ),
}


def report_content(
    project: Project,
    *,
    headings_deg: Mapping[str, float],
    counts: Mapping[str, int],
    track_local: Mapping[str, Array],
    notes: Sequence[str],
    generated: datetime,
    progress: Progress = no_progress,
) -> ReportContent:
    """Gather what a report says about a project, finished or not.

    Parameters
    ----------
    headings_deg : degrees by name of the line
    counts : points by name of the line
    track_local : ndarray of shape (k, 2) by name of the line, metres, north and west
        Course of the vessel, coarse.
    notes : what was assumed while reading, in words
    generated : datetime
        Taken as UTC where it has no time zone.

    Notes
    -----
    The input files are read once to state their digests.
    """
    stamp = generated if generated.tzinfo else generated.replace(tzinfo=UTC)
    lines = tuple(
        Line(
            line.name,
            line.path.name,
            headings_deg.get(line.name),
            counts.get(line.name),
            tuple((float(n), float(w)) for n, w in track_local.get(line.name, ())),
        )
        for line in project.lines
    )
    content = ReportContent(
        program=f"LISPAC {lispac.__version__}",
        generated=stamp.isoformat(timespec="seconds"),
        project=project.name,
        calibrated=project.result is not None,
        simulated=project.truth_deg is not None,
        cautions=(),
        angles=_angles(project),
        adjustment=_adjustment(project.result, headings_deg) if project.result else None,
        validation=tuple(_validation_plane(plane) for plane in project.validation),
        not_compared=tuple(project.not_compared.values()),
        planes=tuple(_picked(target) for target in project.targets),
        lines=lines,
        settings=_settings(project),
        files=_files(project, progress),
        notes=tuple(notes),
    )
    return replace(content, cautions=cautions_of(content))


def _settings(project: Project) -> SettingsUsed:
    settings = project.settings
    typed = project.accuracy is None
    model = project.result.model if project.result else None
    # The answer on the page belongs to the model it was computed with.
    pos_errors = model.pos_errors if model else settings.pos_errors
    correlated = model if model and pos_errors == "correlated" else None
    return SettingsUsed(
        lever_arm_m=settings.lever_arm,
        origin_deg_m=settings.origin_deg_m,
        position_sigma_m=settings.position_sigma if typed else None,
        attitude_sigma_deg=settings.attitude_sigma_deg if typed else None,
        lidar_sigma_m=settings.lidar_sigma,
        subsample_m=settings.subsample,
        pos_errors=pos_errors,
        position_correlation_time_s=correlated.position_time if correlated else None,
        attitude_correlation_time_s=correlated.attitude_time if correlated else None,
        pos_errors_in_words=POS_ERROR_WORDS[pos_errors],
        convention=CONVENTION,
    )


def _files(project: Project, progress: Progress) -> tuple[InputFile, ...]:
    inputs: list[tuple[str, Path]] = [("Trajectory", project.trajectory)]
    if project.accuracy is not None:
        inputs.append(("Trajectory accuracy", project.accuracy))
    inputs += [(f"Line {line.name}", line.path) for line in project.lines]
    files = []
    for k, (role, path) in enumerate(inputs):
        step = part(progress, k / len(inputs), (k + 1) / len(inputs))
        files.append(_input_file(role, path, step))
    return tuple(files)


def _input_file(role: str, path: Path, progress: Progress) -> InputFile:
    try:
        size = path.stat().st_size
        digest = hashlib.sha256()
        done = 0
        with path.open("rb") as stream:
            while block := stream.read(1 << 22):
                digest.update(block)
                done += len(block)
                progress(min(1.0, done / size), f"Reading {path.name} for its digest")
    except OSError:
        # The report says so in a warning; what was computed still stands.
        return InputFile(role, path.name, None, None)
    return InputFile(role, path.name, size, digest.hexdigest())


def _angles(project: Project) -> tuple[Angle, ...]:
    result, truth = project.result, project.truth_deg
    # The prior the adjustment started from, which is the one its residuals "before" belong to.
    prior = np.degrees(result.prior_boresight) if result else project.settings.boresight_deg
    angles = []
    for k, name in enumerate(ANGLES):
        estimated = float(np.degrees(result.boresight[k])) if result else None
        sigma = float(np.degrees(result.sigma[k])) if result else None
        angles.append(
            Angle(
                name,
                float(prior[k]),
                estimated,
                sigma,
                None if sigma is None else NORMAL_95 * sigma,
                truth[k] if truth else None,
                estimated - truth[k] if truth and estimated is not None else None,
            )
        )
    return tuple(angles)


def _adjustment(result: AdjustmentResult, headings_deg: Mapping[str, float]) -> Adjustment:
    per_target = [s.sighting.target for s in result.sightings]
    return Adjustment(
        correlation=tuple(tuple(map(float, row)) for row in result.correlation),
        variance_factor=_number(result.variance_factor),
        degrees_of_freedom=result.degrees_of_freedom,
        chi_square=_chi_square(result),
        iterations=result.iterations,
        points=result.points,
        rms_before_m=result.rms_before,
        rms_after_m=result.rms_after,
        effect_distances_m=EFFECT_DISTANCES_M,
        effects=_effects(result),
        targets=tuple(
            TargetFit(t.target, per_target.count(t.target), t.points, t.rms_before, t.rms_after)
            for t in result.targets
        ),
        sightings=tuple(
            SightingFit(
                s.sighting.target,
                s.sighting.line,
                headings_deg.get(s.sighting.line),
                s.points,
                s.rms_before,
                s.rms_after,
                s.mean_after,
            )
            for s in result.sightings
        ),
    )


def _chi_square(result: AdjustmentResult) -> Chi2:
    test = result.chi_square
    if result.degrees_of_freedom <= 0:
        words = "Not tested: there are no more points than unknowns."
        return Chi2(test.statistic, None, None, None, words)
    if test.passed:
        words = "Passed: the residuals are as large as the stated accuracies let one expect."
    elif test.statistic > test.upper:
        words = (
            "Failed: the residuals are larger than the stated accuracies allow. Either those are "
            "too small, or a target is not one plane on all lines; the sigmas of the angles are "
            "then too small as well."
        )
    else:
        words = (
            "Failed: the residuals are smaller than the stated accuracies let one expect; the "
            "accuracies stated for LiDAR or POS are larger than the true ones, and so are the "
            "sigmas of the angles."
        )
    return Chi2(test.statistic, test.lower, test.upper, test.passed, words)


def _effects(result: AdjustmentResult) -> tuple[Effect, ...]:
    """Displacements by each angle's sigma, and by all together where they add up worst.

    A small change of the angles turns the cloud by a vector w with covariance W = J C J'. It moves
    a point at distance d in direction u by d (w x u), whose mean square length is
    d^2 (trace W - u' W u): largest along the eigenvector of W's smallest eigenvalue.
    """
    rotation = rotation_matrix(*result.boresight)
    turning = rotation_derivatives(*result.boresight) @ rotation.T  # skew matrices of J's columns
    jacobian = np.stack([turning[:, 2, 1], turning[:, 0, 2], turning[:, 1, 0]])
    eigenvalues = np.linalg.eigvalsh(jacobian @ result.covariance @ jacobian.T)
    rates = [*result.sigma, math.sqrt(eigenvalues[1] + eigenvalues[2])]
    return tuple(
        Effect(name, tuple(float(rate * distance) for distance in EFFECT_DISTANCES_M))
        for name, rate in zip((*ANGLES, "worst direction"), rates, strict=True)
    )


def _validation_plane(plane: PlaneComparison) -> ValidationPlane:
    return ValidationPlane(
        name=plane.name,
        pooled_from=plane.pooled_from,
        before=_distances(plane.before),
        after=_distances(plane.after),
        pairs=tuple(
            Pair(p.line_a, p.line_b, p.reciprocal, _distances(p.before), _distances(p.after))
            for p in plane.pairs
        ),
        not_compared=plane.not_compared,
        bin_edges_m=tuple(map(float, plane.bin_edges)),
        counts_before=tuple(map(int, plane.counts_before)),
        counts_after=tuple(map(int, plane.counts_after)),
    )


def _distances(values: DistanceStatistics) -> Distances:
    return Distances(
        values.n,
        values.mean,
        values.median,
        values.rms,
        values.p68,
        values.p95,
        values.p99,
        values.maximum,
    )


def _picked(target: Target) -> PickedPlane:
    return PickedPlane(
        name=target.name,
        role=target.role,
        used=target.used,
        seed_local_m=target.seed,
        threshold_m=target.threshold,
        radius_m=target.radius,
        lines=tuple(s.line for s in target.sightings if s.used),
        left_out=tuple(s.line for s in target.sightings if not s.used),
        missing=dict(target.missing),
    )


def _number(value: float) -> float | None:
    """The value, or None where it is not a number: JSON has no NaN."""
    return float(value) if math.isfinite(value) else None
