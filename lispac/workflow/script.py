"""The script that makes a project from its raw files: the steps of the window as Python.

It follows from the project alone, so undo takes steps out of it, and a project made elsewhere has
one too. The script is tested here: whether seeds lead to the project's points, and an adjustment
to its angles.
"""

import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from hashlib import file_digest
from pathlib import Path

import numpy as np

import lispac
from lispac.adjustment.message_parts import quantity
from lispac.adjustment.result import ANGLES
from lispac.errors import LispacError
from lispac.io.files import written_whole
from lispac.io.values import encoded
from lispac.language import gettext_lazy
from lispac.message_texts import english_text
from lispac.messages import Message, note
from lispac.progress import Progress, no_progress, part
from lispac.project import LineSource, Project
from lispac.survey.source import USUAL
from lispac.survey.store.reading import StoredLine
from lispac.validation.absolute import AbsoluteCheck
from lispac.workflow.absolute import REACH, SIGMA, check_absolute
from lispac.workflow.calibration import estimate
from lispac.workflow.projects import settled_readings
from lispac.workflow.script_targets import steps_to
from lispac.workflow.script_text import Code, Files, call, differing, rows
from lispac.workflow.survey import Survey

WIDTH = 98


@dataclass(frozen=True)
class Script:
    """Python that makes a project again.

    Attributes
    ----------
    remarks : tuple of Message
        Where its numbers differ from the project's, and what it cannot know; they stand in the
        text too.
    """

    text: str
    remarks: tuple[Message, ...] = ()


def script_of(project: Project, survey: Survey, *, progress: Progress = no_progress) -> Script:
    """The script of a project as it stands, saved or not.

    Parameters
    ----------
    survey : Survey
        Loaded for it.
    """
    files = Files([project.trajectory, *(line.path for line in project.lines)])
    blocks = [[_new(project, files, settled=not _found_again(project, survey))]]
    stored = [name for name, scan in survey.scans.items() if isinstance(scan, StoredLine)]
    if stored:
        blocks.append([call("project.import_lines", stored)])
    if said := differing(project.identity):
        blocks.append([call("project.identity", **said)])
    picked, count = [], len(project.targets)
    for k, target in enumerate(project.targets):
        step = part(progress, 0.6 * k / count, 0.6 * (k + 1) / count)
        step(0.0, gettext_lazy("Checking the seed of {target}", target=target.name))
        picked += list(steps_to(project, survey, target, step))
    blocks.append(picked)
    remarks = _gone(project)
    if project.result is not None:
        checks = project.cross_checks is not None
        named = {} if checks else {"cross_check": False}
        blocks.append([call("project.estimate", **named), *_compared(project)])
        remarks += _other_angles(project, survey, part(progress, 0.6, 0.9))
    if project.absolute is not None:
        step = part(progress, 0.9, 1.0)
        lines, doubt = _checked(project, survey, project.absolute, files, step)
        blocks.append(lines)
        remarks += doubt
    name = project.name
    blocks.append([
        "project.save()",
        call("project.report", Code(f"folder / {f'{name}.json'!r}")),
        call("project.report", Code(f"folder / {f'{name}.pdf'!r}")),
    ])  # fmt: skip
    progress(1.0)
    steps = "\n\n".join("\n".join(block) for block in blocks if block)
    return Script(f"{_head(project, files, remarks)}\n{steps}\n", tuple(remarks))


def save_script(script: Script, path: Path) -> None:
    """Write a script.

    Raises
    ------
    InputError
        Where the file cannot be written.
    """
    with written_whole(path) as temporary:
        temporary.write_text(script.text, encoding="utf-8", errors="replace", newline="\n")


def _head(project: Project, files: Files, remarks: list[Message]) -> str:
    name = "".join(letter if letter.isprintable() else "?" for letter in project.name)
    said = [
        f"Steps of the project {name}, as LISPAC {lispac.__version__} wrote them.",
        "Run it with the Python in which LISPAC is installed: python SCRIPT FOLDER creates "
        "the project in FOLDER, python SCRIPT in the folder named below.",
        *map(english_text, remarks),
    ]
    comments = [
        row for words in said
        for row in textwrap.wrap(words, WIDTH, initial_indent="# ", subsequent_indent="# ")
    ]  # fmt: skip
    return "\n".join([
        *comments, "import sys", "from pathlib import Path", "", "import lispac", "",
        f"folder = Path(sys.argv[1] if len(sys.argv) > 1 else {f'{project.name}-again'!r})",
        f"data = Path({str(files.folder)!r})", "",
    ])  # fmt: skip


def _new(project: Project, files: Files, *, settled: bool) -> str:
    settings = project.settings
    named: dict[str, object] = {
        "lines": rows([_line(line, files) for line in project.lines]),
        "trajectory": files(project.trajectory),
    }
    if project.accuracy is not None:
        named["accuracy"] = files(project.accuracy)
    for name in ("trajectory_reading", "accuracy_reading"):
        if (reading := getattr(project, name)) != USUAL:
            named[name] = reading
    named |= {"lever_arm": settings.lever_arm, **differing(settings, but=("lever_arm",))}
    if project.truth_deg is not None:
        named["truth_deg"] = project.truth_deg
    if settled:
        named["settled"] = True
    return f"project = {call('lispac.new', Code('folder'), **named)}"


def _found_again(project: Project, survey: Survey) -> bool:
    """Whether the examination of the files gives the project's readings, and notes.

    This applies to a project that was just created; an opened one does not show these notes.
    """
    stated = project.lines, project.trajectory_reading, project.accuracy_reading
    try:
        *found, notes = settled_readings(
            project.lines, project.trajectory, stated[1], project.accuracy, stated[2]
        )
    except LispacError:
        return False
    return bool(notes) and tuple(found) == stated and set(notes) <= set(survey.notes)


def _gone(project: Project) -> list[Message]:
    """Files that the script needs and that are not there."""
    paths = [project.trajectory, project.accuracy, *(line.path for line in project.lines)]
    gone = [str(path) for path in paths if path is not None and not path.exists()]
    return [note("script.missing_files", files=gone)] if gone else []


def _line(line: LineSource, files: Files) -> Code:
    path = files(line.path)
    if line.name == line.path.stem and not line.columns and line.reading == USUAL:
        return path
    more = {"columns": line.columns} if line.columns else {}
    if line.reading != USUAL:
        more["reading"] = line.reading  # type: ignore[assignment]
    return Code(call("lispac.LineSource", line.name, path, **more))


def _compared(project: Project) -> Iterator[str]:
    """The comparison of the lines that the project holds."""
    if not project.validation:
        return
    model = project.validation[0].model
    named = {} if model.radius is None else {"radius": model.radius}
    yield call("project.validate", model.kind, neighbours=model.neighbours, **named)


def _other_angles(project: Project, survey: Survey, progress: Progress) -> list[Message]:
    """Remark on steps that give other angles than those of the project."""
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
    angle = quantity(ANGLES[worst])
    return [note("script.other_angles", difference=float(off[worst]), angle=angle)]


def _checked(
    project: Project, survey: Survey, check: AbsoluteCheck, files: Files, progress: Progress
) -> tuple[list[str], list[Message]]:
    """The check against a reference, and what is not known of it."""
    # Of a list the project keeps the usual sigma of its points, not that which was asked for.
    sigmas = (check.sigma,) if check.kind == "scan" else (SIGMA, check.sigma)
    path = _reference(check, [files.folder, project.folder, project.folder.parent])
    if path is None:
        step = _check_step(check.reference, sigmas[0], check.reach)
        return [f"# {row}" for row in step.splitlines()], [
            note("script.no_reference", file=check.reference)
        ]
    for sigma in sigmas:
        try:
            again, _ = check_absolute(
                project, survey, path, sigma=sigma, reach=check.reach, progress=progress
            )
        except LispacError:
            continue
        if encoded(again.absolute) == encoded(check):
            return [_check_step(files(path), sigma, check.reach)], []
    return [_check_step(files(path), sigmas[0], check.reach)], [
        note("script.other_check", file=check.reference, system=check.system)
    ]


def _check_step(path: str, sigma: float, reach: float) -> str:
    said = {"sigma": (sigma, SIGMA), "reach": (reach, REACH)}
    named = {name: value for name, (value, usual) in said.items() if value != usual}
    return call("project.check", path, **named)


def _reference(check: AbsoluteCheck, folders: list[Path]) -> Path | None:
    for folder in folders:
        path = folder / check.reference
        if path.is_file() and path.stat().st_size == check.size_bytes:
            with path.open("rb") as file:
                if file_digest(file, "sha256").hexdigest() == check.sha256:
                    return path
    return None
