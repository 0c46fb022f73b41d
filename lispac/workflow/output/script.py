"""Python script that makes a project from its raw files with the steps of the window.

The script is derived from the state of the project, not from a history of steps. It therefore
contains no undone steps, and can be written for a project that was made on another computer. Its
steps are tried before it is written: a target whose seed does not lead to the points of the project
is written with all its points, and a note reports different angles of the adjustment.
"""

import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from hashlib import file_digest
from pathlib import Path
from typing import Any

import numpy as np

from lispac.adjustment.model.parameters import mounting_value_name
from lispac.adjustment.result import ANGLES
from lispac.control_points import ControlFile
from lispac.errors import LispacError
from lispac.io.files import atomic_write
from lispac.language import gettext_lazy
from lispac.message_texts import english_text
from lispac.messages import Message, note
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import LineSource, PickedSighting, Project, Target
from lispac.survey.line_source import DEFAULT_READING
from lispac.survey.store.stored_line import StoredLine
from lispac.targets.finder_settings import DEFAULT_CHOICES
from lispac.targets.line_search import MAX_CLICK_DISTANCE
from lispac.validation.absolute_check import AbsoluteCheck
from lispac.value_conversion import encode_value
from lispac.version import __version__
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.picking import find_target
from lispac.workflow.calibration.point_index_text import numbers_text
from lispac.workflow.calibration.target_search import TargetSearch
from lispac.workflow.checking.absolute_check import DEFAULT_SIGMA, SEARCH_DISTANCE, check_absolute
from lispac.workflow.output.script_text import (
    FilePaths,
    PythonCode,
    call_text,
    non_default_fields,
    rows,
    split_text_code,
)
from lispac.workflow.project.projects import complete_readings
from lispac.workflow.project.survey import Survey

COMMENT_WIDTH = 98
"""Largest number of characters of a line of comment."""
MANUAL_EDIT_REASON = "its points were edited manually"
"""Reason to write a target with all its points, as a comment in the script."""
OTHER_POINTS_REASON = (
    "the search from its seed now gives other points, because it was found with other lines or "
    "another prior boresight, or proposed automatically"
)
"""Reason to write a target with all its points although they were not edited manually."""


@dataclass(frozen=True)
class Script:
    """Python script that makes a project again.

    Attributes
    ----------
    text : str
        Code of the script.
    messages : tuple of Message
        Notes on differences from the numbers of the project and on unknown values; they are also
        included in the text.
    """

    text: str
    messages: tuple[Message, ...] = ()


def script_of(project: Project, survey: Survey, *, progress: Progress = no_progress) -> Script:
    """Script of the present state of a project.

    Parameters
    ----------
    survey : Survey
        Survey loaded for the project.
    """
    files = FilePaths([project.trajectory, *(line.path for line in project.lines)])
    blocks = [
        [_new_project_step(project, files, resolved=not _are_readings_detected(project, survey))]
    ]
    stored = [name for name, scan in survey.scans.items() if isinstance(scan, StoredLine)]
    if stored:
        blocks.append([call_text("project.import_lines", stored)])
    if identity_fields := non_default_fields(project.identity):
        blocks.append([call_text("project.identity", **identity_fields)])
    if criteria := non_default_fields(project.acceptance):
        blocks.append([call_text("project.acceptance", **criteria)])
    picked, count = [], len(project.targets)
    for k, target in enumerate(project.targets):
        step = sub_progress(progress, 0.6 * k / count, 0.6 * (k + 1) / count)
        step(0.0, gettext_lazy("Checking the seed of {target}", target=target.name))
        picked += list(target_steps(project, survey, target, step))
    blocks.append(picked)
    blocks.append([_control_step(file, files) for file in project.control])
    messages = _missing_file_notes(project)
    if project.result is not None:
        checks = project.cross_checks is not None
        named = {} if checks else {"cross_check": False}
        blocks.append([call_text("project.estimate", **named), *_validation_steps(project)])
        messages += _angle_difference_notes(project, survey, sub_progress(progress, 0.6, 0.9))
    if project.absolute is not None:
        step = sub_progress(progress, 0.9, 1.0)
        lines, reported = _reference_check_steps(project, survey, project.absolute, files, step)
        blocks.append(lines)
        messages += reported
    name = project.name
    blocks.append([
        "project.save()",
        call_text("project.report", PythonCode(f"folder / {f'{name}.json'!r}")),
        call_text("project.report", PythonCode(f"folder / {f'{name}.pdf'!r}")),
    ])  # fmt: skip
    progress(1.0)
    steps = "\n\n".join("\n".join(block) for block in blocks if block)
    return Script(f"{_script_head(project, files, messages)}\n{steps}\n", tuple(messages))


def save_script(script: Script, path: Path) -> None:
    """Write a script.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    with atomic_write(path) as temporary:
        temporary.write_text(script.text, encoding="utf-8", errors="replace", newline="\n")


def _script_head(project: Project, files: FilePaths, messages: list[Message]) -> str:
    name = "".join(letter if letter.isprintable() else "?" for letter in project.name)
    statements = [
        f"Steps of the project {name}, as LISPAC {__version__} wrote them.",
        "Run it with the Python in which LISPAC is installed: python SCRIPT FOLDER creates "
        "the project in FOLDER, python SCRIPT in the folder named below.",
        *map(english_text, messages),
    ]
    comments = [
        row for words in statements
        for row in textwrap.wrap(words, COMMENT_WIDTH, initial_indent="# ", subsequent_indent="# ")
    ]  # fmt: skip
    return "\n".join([
        *comments, "import sys", "from pathlib import Path", "", "import lispac", "",
        f"folder = Path(sys.argv[1] if len(sys.argv) > 1 else {f'{project.name}-again'!r})",
        f"data = Path({str(files.folder)!r})", "",
    ])  # fmt: skip


def _new_project_step(project: Project, files: FilePaths, *, resolved: bool) -> str:
    settings = project.settings
    named: dict[str, object] = {
        "lines": rows([_line_code(line, files) for line in project.lines]),
        "trajectory": files(project.trajectory),
    }
    if project.accuracy is not None:
        named["accuracy"] = files(project.accuracy)
    for name in ("trajectory_reading", "accuracy_reading"):
        if (reading := getattr(project, name)) != DEFAULT_READING:
            named[name] = reading
    named |= {"lever_arm": settings.lever_arm, **non_default_fields(settings, but=("lever_arm",))}
    if project.truth_deg is not None:
        named["truth_deg"] = project.truth_deg
    if resolved:
        named["resolved"] = True
    return f"project = {call_text('lispac.new', PythonCode('folder'), **named)}"


def _are_readings_detected(project: Project, survey: Survey) -> bool:
    """True if the detection of reading options gives those of the project, and the same messages.

    Only the survey of a newly created project has the notes of the detection. The script of an
    opened project with such notes therefore contains the complete reading options.
    """
    readings = project.lines, project.trajectory_reading, project.accuracy_reading
    try:
        *found, notes = complete_readings(
            project.lines, project.trajectory, readings[1], project.accuracy, readings[2]
        )
    except LispacError:
        return False
    known = {*survey.notes, *project.reading_warnings}
    return bool(notes) and tuple(found) == readings and set(notes) <= known


def _missing_file_notes(project: Project) -> list[Message]:
    """Note on missing files that the script needs, if there are any."""
    paths = [project.trajectory, project.accuracy, *(line.path for line in project.lines)]
    missing = [str(path) for path in paths if path is not None and not path.exists()]
    return [note("script.missing_files", files=missing)] if missing else []


def _line_code(line: LineSource, files: FilePaths) -> PythonCode:
    path = files(line.path)
    if line.name == line.path.stem and not line.columns and line.reading == DEFAULT_READING:
        return path
    options = {"columns": line.columns} if line.columns else {}
    if line.reading != DEFAULT_READING:
        options["reading"] = line.reading  # type: ignore[assignment]
    return PythonCode(call_text("lispac.LineSource", line.name, path, **options))


def _control_step(file: ControlFile, files: FilePaths) -> str:
    """Step that adds the control of a file with its points."""
    named = non_default_fields(file, but=("path", "points"))
    code = call_text("lispac.ControlFile", path=files(file.path), **named, points=rows(file.points))
    return call_text("project.put_control", PythonCode(code))


def _validation_steps(project: Project) -> Iterator[str]:
    """Step of the validation, if the project has one."""
    if not project.validation:
        return
    model = project.validation[0].model
    named = {} if model.radius is None else {"radius": model.radius}
    yield call_text("project.validate", model.kind, neighbours=model.neighbours, **named)


def _angle_difference_notes(project: Project, survey: Survey, progress: Progress) -> list[Message]:
    """Note if the angles of a new adjustment differ from those of the project, or it fails."""
    assert project.result is not None
    try:
        again = estimate(project, survey, cross_check=False, progress=progress).result
    except LispacError as error:
        return [note("script.estimate_refused", reason=error.reason)]
    assert again is not None
    off = np.abs(again.boresight - project.result.boresight)
    if not off.any():
        return []
    worst = int(np.argmax(off))
    angle = mounting_value_name(ANGLES[worst])
    return [note("script.other_angles", difference=float(off[worst]), angle=angle)]


def _reference_check_steps(
    project: Project, survey: Survey, check: AbsoluteCheck, files: FilePaths, progress: Progress
) -> tuple[list[str], list[Message]]:
    """Step of the check against a reference, as a comment if the reference is not found.

    A note is added if the reference is not found, or the step does not give the check of the
    project, which depends on options that are not stored.
    """
    # For a list, the project stores the median sigma of the points and planes, not the given one.
    sigmas = (check.sigma,) if check.kind == "scan" else (DEFAULT_SIGMA, check.sigma)
    path = _find_reference(check, [files.folder, project.folder, project.folder.parent])
    if path is None:
        step = _reference_check_call(check.reference, sigmas[0], check.search_distance)
        return [f"# {row}" for row in step.splitlines()], [
            note("script.no_reference", file=check.reference)
        ]
    for sigma in sigmas:
        try:
            again, _ = check_absolute(
                project,
                survey,
                path,
                sigma=sigma,
                search_distance=check.search_distance,
                progress=progress,
            )
        except LispacError:
            continue
        if encode_value(again.absolute) == encode_value(check):
            return [_reference_check_call(files(path), sigma, check.search_distance)], []
    return [_reference_check_call(files(path), sigmas[0], check.search_distance)], [
        note("script.other_check", file=check.reference, system=check.system)
    ]


def _reference_check_call(path: str, sigma: float, search_distance: float) -> str:
    """Python call of `project.check` with the options that differ from their defaults.

    Parameters
    ----------
    sigma, search_distance : float, metres
        Standard deviation of the reference, and search distance.
    """
    values = {
        "sigma": (sigma, DEFAULT_SIGMA),
        "search_distance": (search_distance, SEARCH_DISTANCE),
    }
    named = {name: value for name, (value, usual) in values.items() if value != usual}
    return call_text("project.check", path, **named)


def _find_reference(check: AbsoluteCheck, folders: list[Path]) -> Path | None:
    """File in one of the folders with the name and content of the reference of a check."""
    for folder in folders:
        path = folder / check.reference
        if path.is_file() and path.stat().st_size == check.size_bytes:
            with path.open("rb") as file:
                if file_digest(file, "sha256").hexdigest() == check.sha256:
                    return path
    return None


def target_steps(
    project: Project, survey: Survey, target: Target, progress: Progress
) -> Iterator[str]:
    """Steps of a script that add this target to a project."""
    by_hand = any(sighting.by_hand for sighting in target.sightings)
    seeded = None if by_hand else _seed_arguments(project, survey, target, progress)
    if seeded is not None:
        yield call_text("project.seed", target.name, target.seed, **seeded)
    else:
        yield f"# {target.name}: {MANUAL_EDIT_REASON if by_hand else OTHER_POINTS_REASON}."
        yield call_text("project.put", _target_code(target))
    for sighting in target.sightings:
        if not sighting.used:
            yield call_text("project.reject", target.name, sighting.line)
    if not target.used:
        yield call_text("project.reject", target.name)


def _seed_arguments(
    project: Project, survey: Survey, target: Target, progress: Progress
) -> dict[str, Any] | None:
    """Arguments with which the search from the seed gives the target; None if there are none."""
    search = TargetSearch.for_target(target)
    named: dict[str, Any] = {
        "role": (target.role, "target"),
        "shape": (target.shape, "plane"),
        "sphere_radius": (target.sphere_radius, None),
        "threshold": (target.threshold, search.threshold(project.settings.threshold)),
        "radius": (target.radius, search.search_radii(target.role)[0]),
        "expected": (target.expected, None),
        "choices": (target.choices, DEFAULT_CHOICES),
    }
    given = {name: value for name, (value, usual) in named.items() if value != usual}
    # The clicked line, which is not stored, affects the result if several lines or no line have a
    # point at the seed.
    place = np.array(target.seed)
    clicked = [
        line
        for line in survey.lines
        if len(survey.clouds[line].within(place, MAX_CLICK_DISTANCE).points)
    ]
    for line in (None, *(clicked or [sighting.line for sighting in target.sightings])):
        try:
            found = find_target(
                project, survey, target.seed, name=target.name, first_line=line,
                progress=progress, **given,
            )  # fmt: skip
        except LispacError:
            continue
        if _is_same_target(found, target):
            return given if line is None else {**given, "clicked_on": line}
    return None


def _is_same_target(picked: Target, target: Target) -> bool:
    def properties(each: Target) -> tuple[object, ...]:
        return each.threshold, each.radius, dict(each.missing), len(each.sightings)

    return properties(picked) == properties(target) and all(
        (one.line, one.rms, one.one_in) == (other.line, other.rms, other.one_in)
        and np.array_equal(one.indices, other.indices)
        for one, other in zip(picked.sightings, target.sightings, strict=True)
    )


def _target_code(target: Target) -> PythonCode:
    """Code of a target with all its points; `target_steps` excludes sightings that are not used."""
    named: dict[str, Any] = {
        "name": target.name, "role": target.role, "seed": target.seed,
        "threshold": target.threshold, "radius": target.radius,
        "sightings": rows([_sighting_code(sighting) for sighting in target.sightings]),
    }  # fmt: skip
    if target.missing:
        named["missing"] = dict(target.missing)
    if target.shape != "plane":
        named |= {"shape": target.shape, "sphere_radius": target.sphere_radius}
    if target.expected is not None:
        named["expected"] = target.expected
    if target.choices != DEFAULT_CHOICES:
        named["choices"] = target.choices
    return PythonCode(call_text("lispac.Target", **named))


def _sighting_code(sighting: PickedSighting) -> PythonCode:
    points = PythonCode(
        call_text("lispac.point_numbers", split_text_code(numbers_text(sighting.indices)))
    )
    named: dict[str, Any] = {"rms": sighting.rms, "fingerprint": sighting.fingerprint}
    if sighting.one_in != 1:
        named["one_in"] = sighting.one_in
    if sighting.by_hand:
        named["by_hand"] = True
    return PythonCode(call_text("lispac.PickedSighting", sighting.line, points, **named))
