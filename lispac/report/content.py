"""The content of a report as values, the same for PDF, HTML, JSON and tables."""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import lispac
from lispac.adjustment.diagnostics.error_budget import ErrorBudget
from lispac.adjustment.diagnostics.findings import critical_test_value
from lispac.adjustment.diagnostics.warnings import outdated_result_warning
from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.adjustment.solve.determinability import have_one_orientation
from lispac.duplicate_targets import all_warnings
from lispac.language import N_, LazyText, gettext_lazy
from lispac.messages import Message
from lispac.method_comparison import comparison_messages, method_results
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project, Target
from lispac.report.absolute_values import AbsoluteCheckValues
from lispac.report.alternative_method_values import MethodValues
from lispac.report.budget_values import ErrorBudgetValues
from lispac.report.convention_values import convention_values, scanner_to_body_matrix
from lispac.report.diagnostics import (
    component_values,
    cross_check_values,
    finite_or_none,
    observability_values,
    parameter_values,
    reliability_values,
)
from lispac.report.displacement import EFFECT_DISTANCES_M, angle_displacements, s44_contributions
from lispac.report.report_values import (
    AdjustmentValues,
    AngleValues,
    InputFile,
    LineValues,
    PickedPlane,
    ReportContent,
    SightingFit,
    SightingQualityValues,
    TargetFit,
    VarianceFactorTest,
)
from lispac.report.report_warnings import report_warnings
from lispac.report.settings_used import CONVENTION, role_of_line, settings_used
from lispac.report.trajectory_values import LineTrajectorySummary
from lispac.report.validation_values import ValidationPlane, swath_overlap
from lispac.survey.conventions.mounting_texts import orientation_text
from lispac.survey.line_source import printable
from lispac.targets.sighting_quality import SightingQuality

__all__ = ["CONVENTION", "ReportContent", "report_content"]

Array = NDArray[np.float64]

NORMAL_95 = 1.96
"""Half width of the 95 % interval of a normal variable, in standard deviations."""


def report_content(
    project: Project,
    *,
    headings_deg: Mapping[str, float],
    counts: Mapping[str, int],
    track_local: Mapping[str, Array],
    notes: Sequence[Message],
    generated: datetime,
    qualities: Mapping[tuple[str, str], SightingQuality] | None = None,
    convention: str = "",
    budget: ErrorBudget | None = None,
    trajectory: Sequence[LineTrajectorySummary] = (),
    refused: Message | str = "",
    digests: bool = True,
    progress: Progress = no_progress,
) -> ReportContent:
    """Content of the report of a project, calibrated or not.

    Parameters
    ----------
    headings_deg : degrees by name of the line
    counts : points by name of the line
    track_local : ndarray of shape (k, 2) by name of the line, metres, north and west
        Course of the vessel, coarse.
    notes : assumptions of the import
    generated : datetime
        Taken as UTC where it has no time zone.
    qualities : by the names of target and line
    convention : key of another program in whose convention the boresight is given; empty for none
    budget : of the system, where something was estimated
    trajectory : motion and precision on each line
    refused : reason why a later estimate than that of the project was refused
    digests : whether to read the input files for their digests; without, no files are listed

    Raises
    ------
    InputError
        Where there is no such program.

    Notes
    -----
    The input files are read once to state their digests.
    """
    stamp = generated if generated.tzinfo else generated.replace(tzinfo=UTC)
    lines = tuple(
        LineValues(
            line.name,
            printable(line.path.name),
            headings_deg.get(line.name),
            counts.get(line.name),
            tuple((float(n), float(w)) for n, w in track_local.get(line.name, ())),
        )
        for line in project.lines
    )
    edited = {(t.name, s.line) for t in project.targets for s in t.sightings if s.by_hand}
    methods = method_results(project) if project.alternative_results else ()
    content = ReportContent(
        program=f"LISPAC {lispac.__version__}",
        generated=stamp.isoformat(timespec="seconds"),
        project=project.name,
        identity=project.identity,
        calibrated=project.result is not None,
        simulated=project.truth_deg is not None,
        warnings=(),
        angles=_angle_values(project),
        adjustment=_adjustment_values(project.result, headings_deg) if project.result else None,
        cross_checks=cross_check_values(project.cross_checks),
        validation=tuple(ValidationPlane.of(plane) for plane in project.validation),
        swath_overlap=swath_overlap(project.validation),
        not_compared=tuple(project.not_compared.values()),
        planes=tuple(_picked_plane_values(target) for target in project.targets),
        lines=lines,
        settings=settings_used(project),
        files=_input_files(project, progress) if digests else (),
        notes=tuple(notes),
        qualities=tuple(
            _sighting_quality_values(*key, each, by_hand=key in edited)
            for key, each in (qualities or {}).items()
        ),
        in_convention=convention_values(project, convention) if convention else None,
        matrix=scanner_to_body_matrix(project),
        absolute=None if project.absolute is None else AbsoluteCheckValues.of(project.absolute),
        budget=None if budget is None else ErrorBudgetValues.of(budget),
        trajectory=tuple(trajectory),
        methods=tuple(MethodValues.of(each) for each in methods),
        method_messages=comparison_messages(methods),
    )
    also = (outdated_result_warning(refused),) if refused else ()
    return replace(content, warnings=report_warnings(content, all_warnings(project, also)))


def _input_files(project: Project, progress: Progress) -> tuple[InputFile, ...]:
    inputs: list[tuple[str, Path]] = [("Trajectory", project.trajectory)]
    if project.accuracy is not None:
        inputs.append(("Trajectory accuracy", project.accuracy))
    inputs += [(role_of_line(line.name), line.path) for line in project.lines]
    files = []
    for k, (role, path) in enumerate(inputs):
        step = sub_progress(progress, k / len(inputs), (k + 1) / len(inputs))
        files.append(_input_file(role, path, step))
    if (check := project.absolute) is not None:  # as it was when the lines were compared with it
        files.append(InputFile("Reference", check.reference, check.size_bytes, check.sha256))
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
                progress(
                    min(1.0, done / size),
                    gettext_lazy("Computing the checksum of {file}", file=path.name),
                )
    except OSError:
        # The report says so in a warning; what was computed still stands.
        return InputFile(role, printable(path.name), None, None)
    return InputFile(role, printable(path.name), size, digest.hexdigest())


def _angle_values(project: Project) -> tuple[AngleValues, ...]:
    result, truth = project.result, project.truth_deg
    # The prior the adjustment started from, which is the one its residuals "before" belong to.
    prior = np.degrees(result.prior_angles) if result else project.settings.boresight_deg
    angles = []
    for k, name in enumerate(ANGLES):
        estimated = float(np.degrees(result.angles[k])) if result else None
        sigma = float(np.degrees(result.sigma[k])) if result else None
        angles.append(
            AngleValues(
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


def _adjustment_values(
    result: AdjustmentResult, headings_deg: Mapping[str, float]
) -> AdjustmentValues:
    per_target = [s.sighting.target for s in result.sightings]
    steep = result.mounting.axes is not None
    return AdjustmentValues(
        rotation_text=orientation_text(result.angles) if steep else LazyText(""),
        correlation=tuple(tuple(map(float, row)) for row in result.correlation),
        estimated=result.estimated,
        correlation_all=tuple(tuple(map(float, row)) for row in result.correlation_all),
        parameters=parameter_values(result),
        observability=observability_values(result.observability),
        components=component_values(result),
        critical_w=critical_test_value(result),
        reliability=reliability_values(result),
        variance_factor=finite_or_none(result.variance_factor),
        degrees_of_freedom=result.degrees_of_freedom,
        chi_square=_chi_square_values(result),
        iterations=result.iterations,
        points=result.points,
        excluded_outliers=result.excluded_outliers,
        rms_before_m=result.rms_before,
        rms_after_m=result.rms_after,
        effect_distances_m=EFFECT_DISTANCES_M,
        effects=angle_displacements(result),
        s44=s44_contributions(result),
        targets=tuple(
            TargetFit(
                t.target,
                "sphere" if t.sphere else "plane",
                float(t.plane[3]) if t.sphere else None,
                per_target.count(t.target),
                t.points,
                t.rms_before,
                t.rms_after,
                t.noise,
            )
            for t in result.targets
        ),
        single_orientation=have_one_orientation(
            np.array([t.plane[:3] for t in result.targets]),
            np.array([t.sphere for t in result.targets]),
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


def _sighting_quality_values(
    target: str, line: str, quality: SightingQuality, *, by_hand: bool
) -> SightingQualityValues:
    incidence = quality.incidence
    return SightingQualityValues(
        target,
        line,
        quality.rating,
        quality.reasons,
        quality.points,
        quality.rms,
        quality.range,
        quality.density,
        None if incidence is None else float(np.degrees(incidence)),
        quality.coverage,
        quality.visible_share,
        by_hand,
    )


NOT_TESTED = N_("Not tested: there are no more points than unknowns.")
PASSED = N_("Passed: the residuals agree with the given sigmas.")
TOO_LARGE = N_(
    "Failed: the residuals are larger than the given sigmas allow. Possible causes: the given "
    "LiDAR sigma is too small, a target is rough, or there are outliers."
)
TOO_LARGE_NOISE = N_(
    "Failed: the residuals are larger than the given sigmas allow. Possible causes: the given "
    "LiDAR sigma is too small, a target is rough, or there are outliers. The sigmas of the angles "
    "are computed with the noise found in the residuals."
)
TOO_LARGE_CLASSICAL = N_(
    "Failed: the residuals are larger than the given sigmas allow. Possible causes: the given "
    "sigmas are too small, or a target is not the same plane on all lines. The sigmas of the "
    "angles are then too small as well."
)
TOO_SMALL = N_(
    "Failed: the residuals are smaller than expected. The given LiDAR or POS sigmas are too "
    "large. If there is no other warning, the sigmas of the angles are too large as well."
)


def _chi_square_values(result: AdjustmentResult) -> VarianceFactorTest:
    test = result.chi_square
    if result.degrees_of_freedom <= 0:
        return VarianceFactorTest(test.statistic, None, None, None, NOT_TESTED)
    if test.passed:
        finding = PASSED
    elif test.statistic <= test.upper:
        finding = TOO_SMALL
    elif not result.model.correlated:
        finding = TOO_LARGE_CLASSICAL
    elif any(target.noise > 1 for target in result.targets):
        finding = TOO_LARGE_NOISE
    else:
        finding = TOO_LARGE
    return VarianceFactorTest(test.statistic, test.lower, test.upper, test.passed, finding)


def _picked_plane_values(target: Target) -> PickedPlane:
    return PickedPlane(
        name=target.name,
        role=target.role,
        shape=target.shape,
        sphere_radius_m=target.sphere_radius if target.shape == "sphere" else None,
        used=target.used,
        seed_local_m=target.seed,
        threshold_m=target.threshold,
        radius_m=target.radius,
        lines=tuple(s.line for s in target.sightings if s.used),
        excluded_lines=tuple(s.line for s in target.sightings if not s.used),
        missing=dict(target.missing),
    )
