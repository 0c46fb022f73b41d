"""History of the calibrations of a vessel's system, read from projects."""

import os
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import date
from pathlib import Path

import numpy as np

from lispac.adjustment.model.parameters import mounting_value_name
from lispac.adjustment.result import ANGLES
from lispac.errors import LispacError, ProjectError
from lispac.io.project.project_file import PROJECT_FILE_NAME
from lispac.language import gettext, gettext_lazy
from lispac.messages import Message, error, note, warning
from lispac.present.calibration.calibrations import DatedCalibration
from lispac.progress import Progress, no_progress
from lispac.project import Project
from lispac.validation.control_chart import ChartedCalibration, control_chart
from lispac.validation.repeatability import Calibration
from lispac.workflow.checking.repeated_surveys import comparability_notes, distinct_names
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.shared_lines import has_same_lines
from lispac.workflow.project.survey_dates import survey_dates

_DATE_PATTERN = re.compile(r"(\d{4})-(\d{2})-(\d{2})")
"""Year, month and day of a date such as 2026-03-04."""
SYSTEM_FIELDS = ("vessel", "scanner", "scanner_serial", "pos", "pos_serial")
"""Fields of the identity that distinguish systems."""


@dataclass(frozen=True)
class CalibratedSystem:
    """A scanner and an INS/GNSS on a vessel, as named in projects; unknown fields are empty."""

    vessel: str = ""
    scanner: str = ""
    scanner_serial: str = ""
    pos: str = ""
    pos_serial: str = ""

    @classmethod
    def of(cls, project: Project) -> "CalibratedSystem":
        """System of a project."""
        return cls(*(getattr(project.identity, name) for name in SYSTEM_FIELDS))

    @property
    def full_name(self) -> str:
        """Vessel, scanner and INS/GNSS with their serial numbers."""
        parts = [
            self.vessel,
            f"{self.scanner} {self.scanner_serial}",
            f"{self.pos} {self.pos_serial}",
        ]
        names = ", ".join(part.strip() for part in parts if part.strip())
        return names or gettext("unnamed system")

    def is_same_system(self, other: "CalibratedSystem") -> bool:
        """True if both systems have the same names, regardless of capitals and blanks."""
        return [_normalised_name(getattr(self, name)) for name in SYSTEM_FIELDS] == [
            _normalised_name(getattr(other, name)) for name in SYSTEM_FIELDS
        ]


@dataclass(frozen=True)
class CalibrationHistory:
    """Calibrations of one system, the earliest first, with notes."""

    system: CalibratedSystem
    calibrations: tuple[DatedCalibration, ...]
    messages: tuple[Message, ...] = ()


def find_projects(folders: Sequence[Path]) -> tuple[list[Path], list[Message]]:
    """Find the folders of all projects in given folders, at any depth.

    Returns
    -------
    projects : list of Path
    unreadable : list of Message
        Messages about subfolders that cannot be read.

    Raises
    ------
    ProjectError
        If one of the folders does not exist or cannot be read, or none contains a project.
    """
    found: dict[Path, None] = {}
    unreadable: list[Message] = []

    def add_unreadable(failure: OSError) -> None:
        unreadable.append(note("history.no_permission", folder=str(failure.filename)))

    for folder in folders:
        if not folder.is_dir():
            raise ProjectError(error("history.no_folder", folder=str(folder)))
        if not os.access(folder, os.R_OK | os.X_OK):
            raise ProjectError(error("history.no_permission", folder=str(folder)))
        for place, inner, files in os.walk(folder, onerror=add_unreadable):
            inner.sort()
            if PROJECT_FILE_NAME in files:
                found[Path(place)] = None
    if not found:
        raise ProjectError(error("history.no_project", folders=[str(folder) for folder in folders]))
    return list(found), unreadable


def read_histories(
    folders: Sequence[Path],
    *,
    vessel: str | None = None,
    also: Iterable[Project] = (),
    progress: Progress = no_progress,
) -> tuple[tuple[CalibrationHistory, ...], tuple[Message, ...]]:
    """Read the history of each system with a calibration in given folders.

    Parameters
    ----------
    folders : folders searched at any depth
    vessel : vessel whose systems are read; all vessels if None
    also : open projects to include, in their present state instead of the saved one

    Returns
    -------
    histories : histories, those with most calibrations first
    messages : excluded calibrations, with the reason

    Raises
    ------
    ProjectError
        If the folders contain no project, or none with a result and a date.
    """
    open_ones = {project.folder.resolve(): project for project in also}
    inside, unreadable = find_projects(folders)
    paths = [path for path in inside if path.resolve() not in open_ones]
    known: list[tuple[date, Project]] = []
    excluded: list[Message | str] = [*unreadable]
    projects = list(open_ones.values())
    for k, path in enumerate(paths):
        progress(k / len(paths), gettext_lazy("Reading {file}", file=path.name))
        try:
            projects.append(open_project(path))
        except LispacError as failure:
            excluded.append(failure.reason)
    for project in projects:
        if vessel is not None and _normalised_name(project.identity.vessel) != _normalised_name(
            vessel
        ):
            continue
        day = _calibration_date(project)
        if isinstance(day, Message):
            excluded.append(day)
        else:
            known.append((day, project))
    if not known:
        raise ProjectError(_no_calibration_message(vessel, excluded))
    # Of two projects with the same lines and date, the open one is used.
    known.sort(
        key=lambda each: (
            each[0], each[1].folder.resolve() not in open_ones, str(each[1].folder)
        )
    )  # fmt: skip
    found = sorted(
        (_system_history(group) for group in _by_system(known)),
        key=lambda each: -len(each.calibrations),
    )
    progress(1.0)
    messages = tuple(note("history.excluded", reason=each) for each in excluded)
    return tuple(found), messages


def _calibration_date(project: Project) -> date | Message:
    """Date of the survey of a project; else the reason why it has no calibration of a date."""
    day = _survey_date(project)
    if project.result is None:
        return note("history.no_result", project=project.name)
    if day is not None:
        return day
    dates = project.identity.dates
    if dates:
        return note("history.no_day", project=project.name, dates=dates)
    return note("history.no_date", project=project.name)


def _by_system(known: Iterable[tuple[date, Project]]) -> list[list[tuple[date, Project]]]:
    """Calibrations in groups of the same system, in the given order."""
    groups: list[list[tuple[date, Project]]] = []
    for each in known:
        system = CalibratedSystem.of(each[1])
        group = next(
            (g for g in groups if CalibratedSystem.of(g[0][1]).is_same_system(system)), None
        )
        if group is None:
            groups.append(group := [])
        group.append(each)
    return groups


def _change_message(charted: ChartedCalibration) -> Message:
    """Comparison of a calibration with the earlier ones."""
    name, change = charted.calibration.name, charted.change
    if change is None:
        return note("history.first", name=name)
    largest = int(np.argmax(np.abs(change.significance)))
    difference = note(
        "item.angle_changed",
        angle=mounting_value_name(ANGLES[largest]), change=float(change.angles[largest]),
        ratio=float(abs(change.significance[largest])),
    )  # fmt: skip
    if charted.has_moved:
        return warning("history.moved", name=name, difference=difference)
    return note("history.within_limits", name=name, difference=difference)


def _system_history(group: Sequence[tuple[date, Project]]) -> CalibrationHistory:
    group, messages = _without_repeated_surveys(group)
    projects = [project for _, project in group]
    names = distinct_names(projects)
    chart = control_chart([
        # An error of the lever arm is the same in all of them.
        Calibration(
            name, project.result.boresight, project.result.with_exact_lever_arm.covariance
        )
        for name, project in zip(names, projects, strict=True)
        if project.result is not None
    ])  # fmt: skip
    for k in range(1, len(projects)):
        messages += comparability_notes(names[k - 1 : k + 1], projects[k - 1 : k + 1])
    system = CalibratedSystem.of(projects[0])
    if not any(getattr(system, name) for name in SYSTEM_FIELDS):
        messages.append(note("history.unnamed_system"))
    calibrations = tuple(
        DatedCalibration.of(day, project.folder, charted, _change_message(charted))
        for (day, project), charted in zip(group, chart, strict=True)
    )
    return CalibrationHistory(system, calibrations, tuple(messages))


def _without_repeated_surveys(
    group: Sequence[tuple[date, Project]],
) -> tuple[list[tuple[date, Project]], list[Message]]:
    """Exclude projects with the same lines as an earlier one; returns notes on them, too."""
    kept: list[tuple[date, Project]] = []
    messages = []
    for day, project in group:
        same = [known for _, known in kept if has_same_lines(known, project)]
        if same:
            messages.append(
                note("history.same_lines", folder=str(project.folder), other=str(same[0].folder))
            )
        else:
            kept.append((day, project))
    return kept, messages


def first_date_in(text: str) -> date | None:
    """First date in a text, in the form 2026-03-04."""
    for found in _DATE_PATTERN.finditer(text):
        try:
            return date(*map(int, found.groups()))
        except ValueError:
            continue
    return None


def _survey_date(project: Project) -> date | None:
    """First day of the survey: the given one, or that of the times of the lines."""
    return first_date_in(project.identity.dates or survey_dates(project))


def _no_calibration_message(vessel: str | None, excluded: Sequence[Message | str]) -> Message:
    """Error that no calibration was found, with the reasons for excluded projects."""
    found = error("history.none") if vessel is None else error(
        "history.none_of_vessel", vessel=vessel
    )  # fmt: skip
    for each in excluded:
        found = error("history.none_and_excluded", reason=found, excluded=each)
    return found


def _normalised_name(text: str) -> str:
    return " ".join(text.casefold().split())
