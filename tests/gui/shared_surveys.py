"""Surveys that the windows of a test process share instead of reading equal files again."""

import pickle
from collections import OrderedDict
from dataclasses import replace
from pathlib import Path
from threading import Lock

from lispac.progress import Progress, no_progress
from lispac.project import Project
from lispac.workflow.importing.line_import import LINES_FOLDER
from lispac.workflow.project.survey import Survey, load_survey

MAX_SURVEYS = 6
"""Number of the last surveys that are kept, some megabytes each."""

_surveys: OrderedDict[bytes, Survey] = OrderedDict()
_lock = Lock()


def load_once(
    project: Project, *, former: Survey | None = None, progress: Progress = no_progress
) -> Survey:
    """Survey of a project, read only if no project with copies of the same files was read before.

    Copies have the size and the time of the original. Projects with imported lines, and surveys
    whose messages contain their folder, are always read.
    """
    key = _key(project)
    with _lock:
        known = None if key is None else _surveys.get(key)
    if known is not None:
        progress(1.0)
        return known
    survey = load_survey(project, former=former, progress=progress)
    if key is not None and str(project.folder) not in repr((survey.notes, survey.messages)):
        with _lock:
            _surveys[key] = survey
            if len(_surveys) > MAX_SURVEYS:
                _surveys.popitem(last=False)
    return survey


def _key(project: Project) -> bytes | None:
    """Bytes that identify files and settings; None if a file is missing or a line is imported."""
    if (project.folder / LINES_FOLDER).exists():
        return None
    paths = [project.trajectory, *(each.path for each in project.lines)]
    paths += [] if project.accuracy is None else [project.accuracy]
    try:
        files = [(path.name, path.stat().st_size, path.stat().st_mtime_ns) for path in paths]
    except OSError:
        return None
    same = replace(
        project,
        folder=Path(),
        trajectory=Path(),
        accuracy=None if project.accuracy is None else Path(),
        lines=tuple(replace(each, path=Path(each.path.name)) for each in project.lines),
        result=None, cross_checks=None, validation=(), not_compared={}, absolute=None,
        alternative_results=(), file_digest="", excluded_comparisons={},
    )  # fmt: skip
    return pickle.dumps((files, same))
