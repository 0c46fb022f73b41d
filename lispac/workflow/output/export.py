"""Writing and previewing the report."""

from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from lispac.errors import InputError
from lispac.io.files import atomic_write
from lispac.language import LazyText, gettext_lazy
from lispac.messages import Level, Message, error
from lispac.present.survey.survey_data import LineTrajectorySummary
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project
from lispac.report.content import ReportContent, report_content
from lispac.report.options import DEFAULT_OPTIONS, ReportOptions
from lispac.workflow.calibration.orientation_check import validation_planes_on_targets
from lispac.workflow.calibration.sighting_assessment import (
    AssessedQuality,
    SightingKey,
    sighting_qualities,
)
from lispac.workflow.checking.budget import error_budget_of
from lispac.workflow.output.surfaces import plane_sections, surface_geometries
from lispac.workflow.project.survey import Survey

if TYPE_CHECKING:
    from lispac.report.pdf import Preview

REPORT_ENDINGS = (".pdf", ".html", ".json", ".zip")


def report_content_of(
    project: Project,
    survey: Survey,
    *,
    generated: datetime | None = None,
    convention: str = "",
    refused: Message | str = "",
    known: Mapping[SightingKey, AssessedQuality] | None = None,
    progress: Progress = no_progress,
) -> ReportContent:
    """Content of the report, with all its numbers; valid ``known`` qualities are used."""
    project = project.with_data_messages(survey.messages)
    read = [each for each in survey.messages if each.level is Level.NOTE]
    tracks = {}
    for name, scan in survey.scans.items():
        times = np.linspace(scan.first_time, scan.last_time, 50)
        tracks[name] = survey.trajectory.at(times).position[:, :2]
    geometries = surface_geometries(project, survey)
    return report_content(
        project,
        headings_deg=survey.headings_deg,
        counts={name: len(scan) for name, scan in survey.scans.items()},
        track_local=tracks,
        notes=(*survey.notes, *read),
        generated=generated or datetime.now(UTC),
        qualities=sighting_qualities(project, survey, known=known, progress=progress),
        convention=convention,
        budget=None if project.result is None else error_budget_of(project, survey),
        trajectory=trajectory_on_lines(survey),
        refused=refused,
        origin_deg_m=survey.trajectory.frame.origin_deg_m,
        also=tuple(validation_planes_on_targets(project, survey)),
        geometries=geometries,
        plane_sections=plane_sections(project, survey, geometries),
    )


def write_report(
    project: Project,
    survey: Survey,
    path: Path,
    *,
    pictures: Mapping[str | LazyText, Path] | None = None,
    options: ReportOptions = DEFAULT_OPTIONS,
    refused: Message | str = "",
    generated: datetime | None = None,
    known: Mapping[SightingKey, AssessedQuality] | None = None,
    progress: Progress = no_progress,
) -> None:
    """Write the report as PDF, HTML, JSON or CSV tables (.zip), by the suffix of ``path``.

    Parameters
    ----------
    pictures : mapping of caption to PNG file, optional
    options : language (JSON stays English), page, convention and letterhead; see
        `lispac.workflow.output.report_options`
    refused : reason why an estimation after that of the report failed; empty if none did
    generated : date and time given in the report; now by default
    known : qualities of sightings that need not be assessed again

    Raises
    ------
    InputError
        If the suffix is not one of these or the file cannot be written.
    """
    ending = path.suffix.lower()
    if ending not in REPORT_ENDINGS:
        raise InputError(error("report.ending", file=str(path), formats=REPORT_ENDINGS))
    progress(0.0, gettext_lazy("Collecting the values of the report"))
    content = report_content_of(
        project, survey, generated=generated, convention=options.convention,
        refused=refused, known=known, progress=sub_progress(progress, 0.0, 0.3),
    )  # fmt: skip
    progress(0.3, gettext_lazy("Writing {file}", file=path.name))
    with atomic_write(path) as temporary:
        if ending == ".json":
            from lispac.report.json_report import write_json

            write_json(content, temporary)
        elif ending == ".zip":
            from lispac.report.csv_tables import write_tables

            write_tables(content, temporary, options)
        elif ending == ".html":
            from lispac.report.html import write_html

            write_html(content, temporary, pictures or {}, options)
        else:
            from lispac.report.pdf import write_pdf

            write_pdf(content, temporary, pictures or {}, options)
    progress(1.0)


def preview_report(
    project: Project,
    survey: Survey,
    *,
    pictures: Mapping[str | LazyText, Path] | None = None,
    options: ReportOptions = DEFAULT_OPTIONS,
    refused: Message | str = "",
    ppi: float = 96.0,
    known: Mapping[SightingKey, AssessedQuality] | None = None,
    progress: Progress = no_progress,
) -> "Preview":
    """Make the report like `write_report` for display: images of the pages, and the PDF.

    Parameters
    ----------
    pictures : mapping of caption to PNG file, optional
    options : page, convention and letterhead
    refused, known : as for `write_report`
    ppi : pixels per inch of the pages

    Raises
    ------
    InputError
        If a picture or the logo cannot be read.
    """
    from lispac.report.pdf import preview_of

    progress(0.0, gettext_lazy("Collecting the values of the report"))
    content = report_content_of(
        project, survey, convention=options.convention, refused=refused, known=known,
        progress=sub_progress(progress, 0.0, 0.5),
    )  # fmt: skip
    progress(0.5, gettext_lazy("Laying out the pages"))
    preview = preview_of(content, pictures or {}, options, ppi=ppi)
    progress(1.0)
    return preview


def save_preview(preview: "Preview", path: Path) -> None:
    """Write the PDF of a preview.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    with atomic_write(path) as temporary:
        temporary.write_bytes(preview.pdf)


def trajectory_on_lines(survey: Survey) -> tuple[LineTrajectorySummary, ...]:
    """Motion and accuracy of the trajectory on each line with at least two trajectory states."""
    found = []
    for name, scan in survey.scans.items():
        times = survey.trajectory.time
        # The states just before the first and after the last time of the line are included.
        first = max(int(np.searchsorted(times, scan.first_time, side="right")) - 1, 0)
        last = min(int(np.searchsorted(times, scan.last_time)) + 1, len(times))
        own = slice(first, last)
        if last - first < 2:
            continue
        times = times[own]
        steps = np.diff(times)
        way = np.linalg.norm(np.diff(survey.trajectory.position[own], axis=0), axis=1).sum()
        motion = np.degrees(survey.trajectory.attitude[own, :2]).std(axis=0)
        position, attitude = survey.accuracy.at(times)
        angles = np.degrees(attitude)
        found.append(
            LineTrajectorySummary(
                line=name,
                duration_s=scan.last_time - scan.first_time,
                speed_m_s=float(way / (times[-1] - times[0])),
                interval_s=float(np.median(steps)),
                longest_gap_s=float(steps.max()),
                motion_deg=(float(motion[0]), float(motion[1])),
                sigma_horizontal_m=float(np.hypot(position[:, 0], position[:, 1]).max()),
                sigma_vertical_m=float(position[:, 2].max()),
                sigma_roll_pitch_deg=float(angles[:, :2].max()),
                sigma_heading_deg=float(angles[:, 2].max()),
            )
        )
    return tuple(found)
