"""Calibration of many projects one after the other, with a table row for each."""

import math
from collections.abc import Iterator, Sequence
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path

from lispac.errors import InputError, LispacError, NotComparable, system_reason
from lispac.io.files import atomic_write
from lispac.language import gettext_lazy
from lispac.messages import Message, as_message, error
from lispac.present.angles import degrees
from lispac.present.calibration.adjustment import has_passed
from lispac.present.calibration.batch import BATCH_CSV, BatchRow
from lispac.present.csv_text import BYTE_ORDER_MARK, keyed_csv_text
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project
from lispac.report.options import DEFAULT_OPTIONS, ReportOptions
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.checking.calibration_history import find_projects
from lispac.workflow.checking.validation import validate
from lispac.workflow.output.export import report_content_of, write_report
from lispac.workflow.project.projects import locked_project, open_project, save_project
from lispac.workflow.project.survey import load_survey
from lispac.workflow.project.survey_dates import survey_dates

REPORT_FORMATS = ("pdf", "html", "json", "zip")
"""File types of a report, without the dot."""


def batch(
    *folders: str | Path,
    save: bool = False,
    reports: str | Path | None = None,
    form: str = "pdf",
    options: ReportOptions = DEFAULT_OPTIONS,
    progress: Progress = no_progress,
) -> tuple[BatchRow, ...]:
    """Estimate and validate every project in the given folders with its picked targets.

    A project that cannot be calibrated also gets a row, and the next project follows.

    Parameters
    ----------
    folders : searched at any depth
    save : bool
        Whether to save the results in the projects; otherwise these remain unchanged on disk.
    reports : path, optional
        Folder in which the report of each project is written.
    form : {"pdf", "html", "json", "zip"}
        File type of the reports.
    options : ReportOptions
        Options of the reports; see `lispac.workflow.output.report_options`.

    Raises
    ------
    ProjectError
        If a folder does not exist, or none of them contains a project.
    InputError
        If ``form`` is not valid.
    """
    return tuple(
        calibrate_each(
            *folders, save=save, reports=reports, form=form, options=options, progress=progress
        )
    )


def calibrate_each(
    *folders: str | Path,
    save: bool,
    reports: str | Path | None,
    form: str,
    options: ReportOptions,
    progress: Progress,
) -> Iterator[BatchRow]:
    """Calibrate the projects one after the other, and yield the row of each.

    Raises
    ------
    InputError
        If the file type of the reports is not valid.
    """
    if form not in REPORT_FORMATS:
        raise InputError(error("report.format", formats=tuple(REPORT_FORMATS), format=form))
    found, unreadable = find_projects([Path(folder) for folder in folders])
    files = [f"{name}.{form}" for name in _report_names(found)]
    for k, (folder, file) in enumerate(zip(found, files, strict=True)):
        step = sub_progress(progress, k / len(found), (k + 1) / len(found))
        step(
            0.0,
            gettext_lazy(
                "{project} ({number:n} of {count:n})",
                project=folder.name,
                number=k + 1,
                count=len(found),
            ),
        )
        report = None if reports is None else Path(reports) / file
        yield _calibrate_folder(folder, save, report, options, step)
    for message in unreadable:
        folder = Path(str(message.params["folder"]))
        yield BatchRow(folder, folder.name, "refused", (message,))
    progress(1.0)


def _calibrate_folder(
    folder: Path, save: bool, report: Path | None, options: ReportOptions, progress: Progress
) -> BatchRow:
    known = BatchRow(folder, folder.name, "refused", ())
    try:
        with locked_project(folder) if save else nullcontext(open_project(folder)) as project:
            known = replace(
                known, vessel=project.identity.vessel,
                dates=project.identity.dates or survey_dates(project),
            )  # fmt: skip
            return _calibrate_project(known, project, save, report, options, progress)
    except LispacError as failure:
        return replace(known, messages=(as_message(failure.reason),))
    except OSError as failure:
        file, reason = str(failure.filename or folder), system_reason(failure)
        return replace(known, messages=(error("cli.file_failed", file=file, reason=reason),))
    except MemoryError:
        return replace(known, messages=(error("cli.no_memory"),))


def _calibrate_project(
    known: BatchRow,
    project: Project,
    save: bool,
    report: Path | None,
    options: ReportOptions,
    progress: Progress,
) -> BatchRow:
    survey = load_survey(project, progress=sub_progress(progress, 0.0, 0.3))
    project = estimate(project, survey, progress=sub_progress(progress, 0.3, 0.7))
    failures: tuple[Message, ...] = ()
    if any(plane.used for plane in project.targets_of_role("validation")):
        try:
            project = validate(project, survey, progress=sub_progress(progress, 0.7, 0.9))
        except NotComparable as failure:
            failures = (as_message(failure.reason),)
    if save:
        save_project(project)
    if report is not None:
        write_report(
            project, survey, report, options=options, progress=sub_progress(progress, 0.9, 0.95)
        )
    warnings = report_content_of(
        project, survey, progress=sub_progress(progress, 0.95, 1.0)
    ).warnings
    serious = any(message.is_serious for message in warnings)
    result = project.result
    assert result is not None
    return replace(
        known,
        verdict="warnings" if serious else "notes" if warnings or failures else "good",
        messages=(*failures, *warnings),
        boresight_deg=degrees(result.angles),
        sigma_deg=degrees(result.sigma),
        sigma_0=None if result.variance_factor is None else math.sqrt(result.variance_factor),
        chi_square_passed=has_passed(result),
        rms_before_m=_pooled_rms(
            [(plane.before.rms, plane.before.n) for plane in project.validation]
        ),
        rms_after_m=_pooled_rms([(plane.after.rms, plane.after.n) for plane in project.validation]),
    )


def _pooled_rms(planes: Sequence[tuple[float, int]]) -> float | None:
    count = sum(n for _, n in planes)
    return math.sqrt(sum(n * rms**2 for rms, n in planes) / count) if count else None


def _report_names(folders: Sequence[Path]) -> Iterator[str]:
    """Name of the report of each folder: that of the folder, with a number if it is not unique."""
    used_names: set[str] = set()
    for folder in folders:
        name, k = folder.name, 1
        while name.lower() in used_names:
            k += 1
            name = f"{folder.name}-{k}"
        used_names.add(name.lower())
        yield name


def write_table(rows: Sequence[BatchRow], path: Path) -> None:
    """Write the rows as CSV with full precision.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    text = BYTE_ORDER_MARK + keyed_csv_text(BATCH_CSV, rows, line_end="\r\n")
    with atomic_write(path) as temporary:
        temporary.write_text(text, encoding="utf-8", errors="replace", newline="")
