"""The content of a report as values, the same for PDF, HTML, JSON and tables."""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.error_budget import ErrorBudget
from lispac.adjustment.diagnostics.warnings import outdated_result_warning
from lispac.duplicate_targets import all_warnings
from lispac.language import gettext_lazy
from lispac.messages import Message
from lispac.method_comparison import comparison_messages, method_results
from lispac.present.angles import angles
from lispac.present.calibration.adjustment import adjustment_values, angle_errors
from lispac.present.calibration.control import ControlValues
from lispac.present.calibration.cross_checks import cross_check_values
from lispac.present.calibration.error_budget import ErrorBudgetValues
from lispac.present.calibration.methods import MethodValues
from lispac.present.calibration.settings import CONVENTION_TEXT, settings_used
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.present.checking.acceptance import AcceptanceValues
from lispac.present.checking.validation import ValidationPlane, swath_overlap
from lispac.present.output.conventions import convention_values, scanner_to_body_matrix
from lispac.present.output.pos_corrections import PosCorrectionValues, pos_correction_values
from lispac.present.survey.survey_data import (
    LINE_ROLE,
    InputFile,
    LineTrajectorySummary,
    LineValues,
    PickedPlane,
)
from lispac.present.targets.sighting_quality import quality_list
from lispac.present.targets.surface_geometry import PlaneSection, SurfaceGeometryValues
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project, Target
from lispac.report.report_values import (
    ReportContent,
)
from lispac.report.report_warnings import report_warnings
from lispac.survey.line_source import printable
from lispac.targets.sighting_quality import SightingQuality
from lispac.targets.surface_geometry import SurfaceGeometry
from lispac.version import __version__

__all__ = ["CONVENTION_TEXT", "ReportContent", "report_content"]

Array = NDArray[np.float64]


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
    origin_deg_m: tuple[float, ...] | None = None,
    digests: bool = True,
    also: Sequence[Message] = (),
    geometries: Mapping[str, SurfaceGeometry] | None = None,
    plane_sections: Sequence[PlaneSection] = (),
    progress: Progress = no_progress,
) -> ReportContent:
    """Content of the report of a project, calibrated or not.

    Parameters
    ----------
    headings_deg : degrees by name of the line
    counts : points by name of the line
    track_local : ndarray of shape (k, 2) by name of the line, metres, north and west
        Track of the vessel with few points.
    notes : assumptions of the import
    generated : datetime
        Interpreted as UTC if it has no time zone.
    qualities : quality of each sighting, by the names of target and line
    convention : key of another program in whose convention the boresight is given; empty for none
    budget : error budget of the system, if the boresight was estimated
    trajectory : motion and precision on each line
    refused : reason why a later estimate failed, so that the project still has the older result;
        empty if none failed
    origin_deg_m : latitude, longitude and ellipsoidal height of the origin of the local frame
    digests : whether to read all input files once and compute their digests; if not, no files are
        listed
    also : further warnings and notes about the project
    geometries : geometry by the name of the target or validation plane
    plane_sections : points of validation planes for pictures

    Raises
    ------
    InputError
        If the key of the convention is unknown.
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
    adjustment = (
        adjustment_values(project.result, headings_deg, project.picked_points)
        if project.result
        else None
    )
    # The prior that the adjustment started from, since the residuals "before" refer to it.
    prior = adjustment.prior_boresight_deg if adjustment else angles(project.settings.boresight_deg)
    true = None if project.truth_deg is None else angles(project.truth_deg)
    error = None if adjustment is None or true is None else angle_errors(adjustment, true)
    methods = method_results(project) if project.alternative_results else ()
    content = ReportContent(
        program=f"LISPAC {__version__}",
        generated=stamp.isoformat(timespec="seconds"),
        project=project.name,
        identity=project.identity,
        calibrated=project.result is not None,
        simulated=project.truth_deg is not None,
        warnings=(),
        prior_boresight_deg=prior,
        truth_deg=true,
        error_deg=error,
        adjustment=adjustment,
        cross_checks=cross_check_values(project.cross_checks) if project.cross_checks else None,
        validation=tuple(ValidationPlane.of(plane) for plane in project.validation),
        swath_overlap=swath_overlap(project.validation),
        not_compared=tuple(project.not_compared.values()),
        acceptance=AcceptanceValues.of(project.judgement),
        planes=tuple(
            _picked_plane_values(target, (geometries or {}).get(target.name))
            for target in project.targets
        ),
        lines=lines,
        settings=settings_used(project, origin_deg_m),
        files=_input_files(project, progress) if digests else (),
        notes=tuple(notes),
        qualities=quality_list(qualities or {}, project.targets),
        in_convention=convention_values(project, convention) if convention else None,
        matrix=scanner_to_body_matrix(project),
        absolute=None if project.absolute is None else AbsoluteCheckValues.of(project.absolute),
        budget=None if budget is None else ErrorBudgetValues.of(budget),
        trajectory=tuple(trajectory),
        methods=tuple(MethodValues.of(each) for each in methods),
        method_messages=comparison_messages(methods),
        control=ControlValues.of(project),
        trajectory_corrections=_trajectory_corrections(project),
        plane_sections=tuple(plane_sections),
    )
    also = (*also, outdated_result_warning(refused)) if refused else also
    return replace(content, warnings=report_warnings(content, all_warnings(project, also)))


def _trajectory_corrections(project: Project) -> PosCorrectionValues | None:
    found = None if project.result is None else project.result.pos_corrections
    return None if found is None or not found.determined.any() else pos_correction_values(found)


def _input_files(project: Project, progress: Progress) -> tuple[InputFile, ...]:
    inputs: list[tuple[str, Path]] = [("Trajectory", project.trajectory)]
    if project.accuracy is not None:
        inputs.append(("Trajectory accuracy", project.accuracy))
    inputs += [(f"{LINE_ROLE}{line.name}", line.path) for line in project.lines]
    files = []
    for k, (role, path) in enumerate(inputs):
        step = sub_progress(progress, k / len(inputs), (k + 1) / len(inputs))
        files.append(_input_file(role, path, step))
    for file in project.control:  # size and digest at the time of the import
        name = printable(file.path.name)
        files.append(InputFile("Control", name, file.size_bytes, file.sha256))
    if (check := project.absolute) is not None:  # size and digest at the time of the comparison
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
        # The report contains a warning about the missing file; the results remain valid.
        return InputFile(role, printable(path.name), None, None)
    return InputFile(role, printable(path.name), size, digest.hexdigest())


def _picked_plane_values(target: Target, geometry: SurfaceGeometry | None) -> PickedPlane:
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
        geometry=None if geometry is None else SurfaceGeometryValues.of(geometry),
    )
