"""Calibrations of one mounting from several surveys, read from their projects."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from lispac.errors import ProjectError
from lispac.messages import Message, error, note
from lispac.project import Project
from lispac.validation.repeatability import Calibration
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.shared_lines import has_same_lines, shared_lines


@dataclass(frozen=True, eq=False)
class ComparedProjects:
    """Calibrations of several projects.

    Attributes
    ----------
    each : all calibrations, the earliest first
    counted : calibrations used for the combined result, each survey once
    messages : messages on the comparison
    """

    each: tuple[Calibration, ...]
    counted: tuple[Calibration, ...]
    messages: tuple[Message, ...]


def calibrations_of(folders: Sequence[Path]) -> ComparedProjects:
    """Read the calibration of each project, with notes on their comparison.

    Parameters
    ----------
    folders : projects, the earliest first

    Raises
    ------
    ProjectError
        If a project has no result yet, or one is given twice.
    """
    projects = [open_project(folder) for folder in folders]
    seen: set[Path] = set()
    for project in projects:
        where = project.folder.resolve()
        if where in seen:
            raise ProjectError(error("repeat.given_twice", folder=str(project.folder)))
        seen.add(where)
        if project.result is None:
            raise ProjectError(error("estimate.needed", project=project.name))
    names = distinct_names(projects)
    found = [
        # An error of the lever arm is the same in all of them.
        Calibration(name, project.result.boresight, project.result.with_exact_lever_arm.covariance)
        for name, project in zip(names, projects, strict=True)
        if project.result is not None
    ]
    counted: list[int] = []
    messages: list[Message] = []
    for k, project in enumerate(projects):
        first = next((j for j in counted if has_same_lines(projects[j], project)), None)
        if first is None:
            counted.append(k)
        else:
            messages.append(note("repeat.same_lines", name=names[k], other=names[first]))
    messages += comparability_notes(names, projects)
    return ComparedProjects(tuple(found), tuple(found[k] for k in counted), tuple(messages))


def distinct_names(projects: Sequence[Project]) -> list[str]:
    """Distinct names of projects: their folder names, if needed with parent folders."""
    paths = [project.folder.resolve() for project in projects]
    kinds = [
        [project.name for project in projects],
        [
            f"{path.parent.name}/{project.name}"
            for path, project in zip(paths, projects, strict=True)
        ],
        [str(path) for path in paths],
    ]
    return [
        next((kind[k] for kind in kinds if kind.count(kind[k]) == 1), kinds[-1][k])
        for k in range(len(projects))
    ]


def comparability_notes(names: Sequence[str], projects: Sequence[Project]) -> list[Message]:
    """Notes on differences that limit the comparison with the first project."""
    messages = []
    first = projects[0]
    for name, project in zip(names[1:], projects[1:], strict=True):
        shared = shared_lines(first, project)
        if shared and not has_same_lines(first, project):
            messages.append(
                note("repeat.shared_lines", name=name, other=names[0], count=len(shared))
            )
        if project.settings.lever_arm != first.settings.lever_arm:
            messages.append(note("repeat.lever_arm", name=name, other=names[0]))
        if project.settings.pos_errors != first.settings.pos_errors:
            messages.append(note("repeat.pos_errors", name=name, other=names[0]))
    return messages
