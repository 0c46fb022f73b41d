"""All there is to be warned of in an open project, in one list, each with where its cause lies.

Nothing is judged or worded here that is judged elsewhere: the list holds what reading the files,
the sightings, the adjustment, the validation and the checks have to say.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Literal

from lispac.adjustment import older
from lispac.adjustment.doubt import Doubt
from lispac.causes import Cause
from lispac.doubles import doubts_of
from lispac.io.trajectory_facts import gap_doubts
from lispac.message_texts import message_text
from lispac.messages import Level
from lispac.project import Project
from lispac.report.cautions import told_of
from lispac.report.content import report_content
from lispac.survey.lever_arm import lever_arm_doubts
from lispac.survey.time_quality import LEFT_OUT
from lispac.targets.quality import SightingQuality
from lispac.workflow.facing import ONE_FACING, face_one_way
from lispac.workflow.survey import Survey

Severity = Literal["serious", "caution", "note"]
SEVERITIES: tuple[Severity, ...] = ("serious", "caution", "note")

DATA, ADJUST = Cause.of_step("Data"), Cause.of_step("Adjust")

TOLD_ONE_BY_ONE = {"sightings", "not_found", "not_compared"}
"""Codes that sum up what stands here as a warning each."""
SINGLE = "Nothing checks a single target: pick another that faces elsewhere."
"""Said before an adjustment; after it, it is one of its doubts."""
STALE = "There is no boresight any more: an edit changed what it rested on. Press Estimate for it."
OF_A_REPORT = {"not_calibrated"}
"""Codes that tell of a report only: in the window the steps say what is still to do."""


@dataclass(frozen=True)
class Concern:
    """Something to be warned of.

    Attributes
    ----------
    severity : {"serious", "caution", "note"}
        Whether it makes the answer doubtful, is to be looked at, or was only assumptions.
    text : str
        A sentence or two.
    cause : Cause
    """

    severity: Severity
    text: str
    cause: Cause


def concerns(
    project: Project,
    survey: Survey | None,
    qualities: Mapping[tuple[str, str], SightingQuality] | None = None,
    *,
    refusal: str = "",
    refused_since: str = "",
    stale: bool = False,
    storage: str = "",
) -> tuple[Concern, ...]:
    """Everything to be warned of, serious things first, then in the order of the work.

    Parameters
    ----------
    survey : Survey or None
        None while the data are not loaded.
    qualities : of the sightings, by the names of target and line, as far as they are known
    refusal : why no result follows from the last edit, in words
    refused_since : why an estimate was refused that was asked for after the result, in words
    stale : whether there was a result that an edit has dropped
    storage : what is wrong with keeping the project, in words
    """
    if survey is not None:
        project = project.with_data_messages(survey.messages)
    found = [
        *_storage(storage),
        *_system(project),
        *_data(project, survey),
        *_sightings(project, qualities or {}),
        *_targets(project, survey),
        *_refusal(refusal, stale and project.result is None),
        *_answer(project, (older.refused_since(refused_since),) if refused_since else ()),
        *_not_compared(project),
    ]
    return tuple(sorted(found, key=lambda concern: SEVERITIES.index(concern.severity)))


def _storage(storage: str) -> Iterator[Concern]:
    if storage:
        yield Concern("serious", storage, DATA)


def _system(project: Project) -> Iterator[Concern]:
    for text in lever_arm_doubts(project.settings.lever_arm):
        yield Concern("caution", text, Cause.of_field("lever_arm"))


def _data(project: Project, survey: Survey | None) -> Iterator[Concern]:
    """What was assumed or left out while the files were read."""
    if survey is None:
        return
    for doubt in gap_doubts(survey.trajectory.time, project.settings.longest_gap):
        yield Concern("caution", doubt, DATA)
    for note in survey.notes:
        severity: Severity = "caution" if LEFT_OUT in note else "note"
        yield Concern(severity, note, _file(project, note))
    for message in survey.messages:  # warnings come with the doubts about the answer
        if message.level is Level.NOTE:
            yield Concern("note", message_text(message), message.subject or DATA)


def _file(project: Project, note: str) -> Cause:
    """The line whose file a note begins with, where it is one."""
    lines = [
        line for line in project.lines if note.startswith((f"{line.path.name}:", f"{line.path} "))
    ]
    return Cause.of_line(lines[0].name) if len(lines) == 1 else DATA


def _sightings(
    project: Project, qualities: Mapping[tuple[str, str], SightingQuality]
) -> Iterator[Concern]:
    for target in project.targets:
        for line, reason in target.missing.items() if target.used else ():
            where = Cause.of_sighting(target.name, line)
            yield Concern("note", f"{target.name} on {line}: {reason}", where)
        for sighting in target.used_sightings:
            quality = qualities.get((target.name, sighting.line))
            if quality is not None and quality.light != "good":
                where = Cause.of_sighting(target.name, sighting.line)
                text = f"{target.name} on {sighting.line}: {quality.words}"
                yield Concern("caution", text, where)


def _targets(project: Project, survey: Survey | None) -> Iterator[Concern]:
    """What an estimate would not get along with; afterwards it speaks for itself."""
    if project.result is not None:
        return
    used = [target for target in project.of_role("target") if target.used]
    if len(used) == 1:
        yield Concern("caution", SINGLE, Cause.of_target(used[0].name))
    if survey is not None and face_one_way(project, survey):
        yield Concern("caution", ONE_FACING, Cause.of_target(used[-1].name))


def _refusal(refusal: str, stale: bool) -> Iterator[Concern]:
    if refusal:
        yield Concern("serious", refusal, ADJUST)
    elif stale:
        yield Concern("caution", STALE, ADJUST)


def _answer(project: Project, also: tuple[Doubt, ...]) -> Iterator[Concern]:
    """What the report tells on its first page, but for what only a report needs."""
    content = report_content(
        project, headings_deg={}, counts={}, track_local={}, notes=(),
        generated=datetime.now(UTC), digests=False,
    )  # fmt: skip
    for doubt in doubts_of(project, also):  # without what a report says of its own sections
        yield Concern("serious" if doubt.serious else "caution", doubt.text, doubt.cause)
    for caution, cause in told_of(content, ()):
        if caution.code not in TOLD_ONE_BY_ONE | OF_A_REPORT:
            yield Concern(caution.severity, caution.text, cause)


def _not_compared(project: Project) -> Iterator[Concern]:
    for name, reason in project.not_compared.items():
        yield Concern("caution", reason, Cause.of_target(name))
