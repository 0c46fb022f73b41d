"""What leaves the program: georeferenced lines, plane files, the report."""

from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import Literal

import numpy as np

from lispac.errors import InputError
from lispac.io.files import written_whole
from lispac.io.las import write_points
from lispac.progress import Progress, no_progress, part
from lispac.project import Project
from lispac.report.content import ReportContent, report_content
from lispac.survey.georeferencing import georeference
from lispac.workflow.survey import Survey

REPORT_ENDINGS = (".pdf", ".html", ".json")


def georeference_lines(
    project: Project,
    survey: Survey,
    output: Path,
    which: Literal["prior", "estimated"] = "estimated",
    *,
    progress: Progress = no_progress,
) -> list[Path]:
    """Write every line as LAZ in the local frame (North, West, Up), one file a line.

    Raises
    ------
    ProjectError
        Where the estimated boresight is asked for before an adjustment.
    InputError
        Where the folder cannot be written.
    """
    mounting = project.mounting(which)
    paths = []
    for k, (name, scan) in enumerate(survey.scans.items()):
        step = part(progress, k / len(survey.scans), (k + 1) / len(survey.scans))
        step(0.0, f"Georeferencing {name}")
        points = georeference(scan.points_lidar, scan.time, survey.trajectory, mounting)
        path = output / f"{name}_{which}.laz"
        step(0.3, f"Writing {path.name}")
        write_points(path, points, scan.time, scan.intensity, scale=0.001)
        paths.append(path)
    progress(1.0, "Lines written")
    return paths


def content_of(
    project: Project, survey: Survey, *, generated: datetime | None = None
) -> ReportContent:
    """Numbers of the report."""
    tracks = {}
    for name, scan in survey.scans.items():
        times = np.linspace(scan.time.min(), scan.time.max(), 50)
        tracks[name] = survey.trajectory.at(times).position[:, :2]
    return report_content(
        project,
        headings_deg={n: float(np.degrees(h)) % 360 for n, h in survey.heading.items()},
        counts={name: len(scan) for name, scan in survey.scans.items()},
        track_local=tracks,
        notes=survey.notes,
        generated=generated or datetime.now(UTC),
    )


def write_report(
    project: Project,
    survey: Survey,
    path: Path,
    *,
    pictures: Mapping[str, Path] | None = None,
    progress: Progress = no_progress,
) -> None:
    """Write the report as PDF, HTML or JSON by the ending of ``path``.

    Parameters
    ----------
    pictures : mapping of caption to PNG file, optional

    Raises
    ------
    InputError
        Where the ending is none of these or the file cannot be written.
    """
    ending = path.suffix.lower()
    if ending not in REPORT_ENDINGS:
        raise InputError(
            f"{path}: a report is written as {', '.join(REPORT_ENDINGS)}; end its name so."
        )
    progress(0.0, "Collecting the report")
    content = content_of(project, survey)
    progress(0.3, f"Writing {path.name}")
    with written_whole(path) as temporary:
        if ending == ".json":
            from lispac.report.json_report import write_json

            write_json(content, temporary)
        elif ending == ".html":
            from lispac.report.html import write_html

            write_html(content, temporary, pictures or {})
        else:
            from lispac.report.pdf import write_pdf

            write_pdf(content, temporary, pictures or {})
    progress(1.0, "Report written")
