"""List of all warnings about an open project, each with its cause.

The list collects the messages about the files, the sightings, the adjustment, the validation and
the checks. Only the gaps of the trajectory and, before the estimation, the number and orientation
of the targets are checked here.
"""

from collections.abc import Iterator, Mapping
from datetime import UTC, datetime

import numpy as np

from lispac.adjustment.diagnostics.cause_warnings import without_explained
from lispac.adjustment.diagnostics.warnings import outdated_result_warning
from lispac.duplicate_targets import all_warnings
from lispac.messages import Level, Message, note, sort_by_importance, warning
from lispac.project import Project
from lispac.report.content import report_content
from lispac.report.report_warnings import report_warnings
from lispac.survey.lever_arm_warnings import lever_arm_warnings
from lispac.targets.sighting_quality import SightingQuality
from lispac.warning_causes import Cause
from lispac.workflow.calibration.orientation_check import (
    have_targets_single_orientation,
    validation_planes_on_targets,
)
from lispac.workflow.project.survey import Survey, file_cause

DATA_STEP, ADJUST_STEP = Cause.of_step("Data"), Cause.of_step("Adjust")

SUMMARY_CODES = {"report.sightings", "report.not_found", "report.not_compared"}
"""Codes of summaries in a report; the list contains the summarised messages instead."""
REPORT_ONLY_CODES = {"report.not_calibrated"}
"""Codes used only in a report: in the window, the steps show what remains to be done."""


def warnings_of(
    project: Project,
    survey: Survey | None,
    qualities: Mapping[tuple[str, str], SightingQuality] | None = None,
    *,
    refusal: Message | str = "",
    refused_since: Message | str = "",
    outdated: bool = False,
    storage: Message | None = None,
) -> tuple[Message, ...]:
    """All messages by level (errors, warnings, notes), then by importance and step of the workflow.

    Parameters
    ----------
    survey : Survey or None
        None while the data are not loaded.
    qualities : known qualities of the sightings, by the names of target and line
    refusal : reason why there is no result after the last edit
    refused_since : reason why an estimation after the result failed
    outdated : whether an edit has cleared a result
    storage : reason why no recovery copy of unsaved changes is written
    """
    if survey is not None:
        project = project.with_data_messages(survey.messages)
    found = [
        *_storage_warning(storage),
        *lever_arm_warnings(project.settings.lever_arm),
        *_trajectory_gaps(project, survey),
        *_poor_sightings(project, qualities or {}),
        *_target_notes(project, survey),
        *_refusal_warning(refusal, outdated and project.result is None),
        *_result_warnings(
            project,
            (outdated_result_warning(refused_since),) if refused_since else (),
        ),
        *_planes_not_compared(project),
        *_reading_notes(project, survey),
        *_targets_not_found(project),
    ]
    return sort_by_importance(without_explained(found))


def _storage_warning(storage: Message | None) -> Iterator[Message]:
    if storage is not None:
        yield warning("project.storage", reason=storage, subject=DATA_STEP)


def _trajectory_gaps(project: Project, survey: Survey | None) -> Iterator[Message]:
    """Messages on gaps of the trajectory that are not interpolated."""
    if survey is None:
        return
    steps, limit = np.diff(survey.trajectory.time), project.settings.longest_gap
    if count := int((steps > limit).sum()):
        longest = float(steps.max())
        yield note(
            "project.trajectory_gaps", count=count, limit=limit, longest=longest, subject=DATA_STEP
        )


def _reading_notes(project: Project, survey: Survey | None) -> Iterator[Message]:
    """Notes on assumptions and excluded data from the reading of the files."""
    if survey is None:
        return
    for each in survey.notes:
        yield note("project.import_note", reason=each, subject=file_cause(project, each))
    for message in survey.messages:  # warnings are listed with those about the result
        if message.level is Level.NOTE:
            yield message


def _poor_sightings(
    project: Project, qualities: Mapping[tuple[str, str], SightingQuality]
) -> Iterator[Message]:
    """Notes on every poor sighting, and one for all doubtful sightings of a target."""
    for target in project.targets:
        doubtful: dict[str, SightingQuality] = {}
        for line in (sighting.line for sighting in target.used_sightings):
            quality = qualities.get((target.name, line))
            if quality is None or quality.rating == "good":
                continue
            if quality.rating == "doubtful":
                doubtful[line] = quality
                continue
            yield note(
                "project.poor_sighting", target=target.name, line=line, reasons=quality.reasons,
                subject=Cause.of_sighting(target.name, line),
            )  # fmt: skip
        if not doubtful:
            continue
        line = max(doubtful, key=lambda each: _severity(doubtful[each]))
        worst, subject = doubtful[line], Cause.of_sighting(target.name, line)
        if len(doubtful) == 1:
            yield note(
                "project.doubtful_sighting",
                target=target.name, line=line, reasons=worst.reasons, subject=subject,
            )  # fmt: skip
        else:
            yield note(
                "project.doubtful_sightings",
                target=target.name, lines=tuple(doubtful), line=line, reasons=worst.reasons,
                subject=subject,
            )  # fmt: skip


def _severity(quality: SightingQuality) -> tuple[int, float, float]:
    """Rank of a doubtful quality; the larger one is worse."""
    is_oblique = any(each.code == "quality.oblique" for each in quality.reasons)
    incidence = quality.incidence or 0.0
    return len(quality.reasons), incidence if is_oblique else 0.0, -quality.coverage


def _targets_not_found(project: Project) -> Iterator[Message]:
    """One note for all lines on which a target was not found for the same reason."""
    for target in project.targets:
        lines: dict[Message, list[str]] = {}
        for line, reason in target.missing.items() if target.used else ():
            lines.setdefault(reason, []).append(line)
        for reason, found in lines.items():
            subject = Cause.of_sighting(target.name, found[0])
            if len(found) == 1:
                yield note(
                    "project.not_found_on_line",
                    target=target.name, line=found[0], reason=reason, subject=subject,
                )  # fmt: skip
            else:
                yield note(
                    "project.not_found_on_lines",
                    target=target.name, lines=tuple(found), reason=reason, subject=subject,
                )  # fmt: skip


def _target_notes(project: Project, survey: Survey | None) -> Iterator[Message]:
    """Notes on planes that check or determine less than the user may expect.

    Targets with which an estimation would fail are named if there is no result yet.
    """
    if survey is not None:
        yield from validation_planes_on_targets(project, survey)
    if project.result is not None:
        return
    used = [target for target in project.targets_of_role("target") if target.used]
    if len(used) == 1:
        yield note("project.single_target", subject=Cause.of_target(used[0].name))
    if survey is not None and have_targets_single_orientation(project, survey):
        yield note("project.one_facing", subject=Cause.of_target(used[-1].name))


def _refusal_warning(refusal: Message | str, outdated: bool) -> Iterator[Message]:
    if refusal:
        found = refusal.subject if isinstance(refusal, Message) else None
        yield warning("project.refused", reason=refusal, subject=found or ADJUST_STEP)
    elif outdated:
        yield note("project.out_of_date", subject=ADJUST_STEP)


def _result_warnings(project: Project, also: tuple[Message, ...]) -> Iterator[Message]:
    """Warnings about the result, without those that only a report needs."""
    content = report_content(
        project, headings_deg={}, counts={}, track_local={}, notes=(),
        generated=datetime.now(UTC), digests=False,
    )  # fmt: skip
    found = all_warnings(project, also)
    yield from found
    for message in report_warnings(content, found):
        if message not in found and message.code not in SUMMARY_CODES | REPORT_ONLY_CODES:
            yield message


def _planes_not_compared(project: Project) -> Iterator[Message]:
    for name, reason in project.not_compared.items():
        yield note("report.not_compared", reason=reason, subject=Cause.of_target(name))
