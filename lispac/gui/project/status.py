"""State of the five steps of the workflow: a short status and the next action for each."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

from lispac.duplicate_targets import all_warnings, data_warnings
from lispac.gui.app.language import local_datetime
from lispac.gui.app.unavailable import Reason, Unavailable, first_reason
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.project.document import ExportedReport
from lispac.language import N_, Plural, gettext
from lispac.messages import Message, note
from lispac.present.checking.acceptance import AcceptanceValues, calibration_verdict_text
from lispac.project import Project
from lispac.workflow.calibration.orientation_check import have_targets_single_orientation
from lispac.workflow.project.survey import Survey

StepState = Literal["empty", "todo", "done", "warning", "failed"]

STEP_NAMES = (N_("Data"), N_("Targets"), N_("Adjustment"), N_("Validation"), N_("Report"))
STEP_KEYS = ("Data", "Targets", "Adjust", "Validate", "Report")
"""Names of the steps in the causes of warnings, which never change."""
"""Names of the steps, as in `Cause`."""
STEP_TITLES = (
    N_("1  Data"), N_("2  Targets"), N_("3  Adjust"), N_("4  Validate"), N_("5  Report"),
)  # fmt: skip
"""Headers of the steps, translated where they are shown."""
DATA, TARGETS, ADJUST, VALIDATE, REPORT = range(5)
"""Indices of the steps."""

POINT_COUNT_TEXT = Plural("{count:n} point", "{count:n} points")
VALIDATION_PLANE_COUNT_TEXT = Plural("{count:n} validation plane", "{count:n} validation planes")
USED_PLANES_TEXT = Plural(
    "{used:n} of {count:n} validation plane", "{used:n} of {count:n} validation planes"
)
"""Number of planes that are used, short enough for the header of the step."""


@dataclass(frozen=True)
class StepStatus:
    """Status of one step.

    Attributes
    ----------
    sentence : short status for the header of the step
    advice : next action, for the panel of the step
    reason : why the step cannot be run; None if it can be run
    """

    state: StepState
    sentence: str
    advice: str
    reason: Reason = None

    @property
    def ready(self) -> bool:
        """Whether the step can be run."""
        return self.reason is None


@dataclass(frozen=True)
class ProjectState:
    """State of the open project, as the panels show it.

    Attributes
    ----------
    project : Project or None
        None if no project is open.
    survey : Survey or None
        None while the data are being read.
    steps : tuple of StepStatus
        Status of the five steps in order.
    is_busy : bool
        Whether a task is running that must not be disturbed.
    is_waiting : bool
        Whether a result is computed automatically after the last edit.
    refusal : str
        Reason why the last estimate gave no result; empty if there is none.
    refused_since : Message or str
        Reason why an estimate after the present result failed; empty if there is none.
    estimate_reason : Unavailable or None
        Why no estimate can be requested; it starts when the lines are georeferenced.
    is_outdated : bool
        Whether an edit has removed the result.
    is_validating : bool
        Whether the lines are being compared on the validation planes.
    is_checking : bool
        Whether the checks of the result are not complete.
    report : ExportedReport or None
        Report that was last exported from the project.
    """

    project: Project | None
    survey: Survey | None
    steps: tuple[StepStatus, ...]
    is_busy: bool = False
    is_waiting: bool = False
    refusal: str = ""
    refused_since: Message | str = ""
    estimate_reason: Reason = Unavailable.NO_PROJECT
    is_outdated: bool = False
    is_validating: bool = False
    is_checking: bool = False
    report: ExportedReport | None = None


OUTDATED_RESULT_NOTE = note("project.out_of_date")
"""Note instead of values that an edit has removed."""


def point_count(number: int) -> str:
    """Text of a number of points: ``812 points``, ``4.9 M points``."""
    if number >= 1_000_000:
        return gettext("{millions:x.1} M points", millions=number / 1e6)
    return gettext(POINT_COUNT_TEXT, count=number)


def line_count(number: int) -> str:
    """Text of a number of lines in the language of the window."""
    return gettext(Plural("{count:n} line", "{count:n} lines"), count=number)


def step_statuses(
    project: Project | None,
    survey: Survey | None,
    *,
    waiting: bool = False,
    refusal: Message | str = "",
    report: ExportedReport | None = None,
    running: int | None = None,
    checking: bool = False,
    poor_sightings: Sequence[str] = (),
    opening: bool = False,
) -> tuple[StepStatus, ...]:
    """Status of the five steps in order.

    Parameters
    ----------
    survey : Survey or None
        None while data are not loaded.
    waiting : bool
        Whether a result is computed automatically after the last edit.
    refusal : Message or str
        Reason why the last estimate gave no result.
    report : ExportedReport or None
        Report that was last exported from the project; None if there is none.
    running : int or None
        Step whose task is running: `ADJUST` or `VALIDATE`.
    checking : bool
        Whether the checks of the result are not complete.
    poor_sightings : sequence of str
        Names of the sightings that are used in the adjustment and rated poor.
    opening : bool
        Whether a task runs without a project, which opens one.
    """
    if project is None:
        nothing = StepStatus(
            "empty",
            gettext("no project open"),
            gettext("Open or create a project first."),
            Unavailable.NO_PROJECT,
        )
        first = StepStatus(
            "todo",
            gettext("reading files …") if opening else gettext("no project open"),
            gettext("Create a project from a trajectory and lines, or open the demo survey."),
            Unavailable.NO_PROJECT,
        )
        return (first, *[nothing] * 4)
    return (
        _data_status(project, survey),
        _targets_status(project, survey, poor_sightings),
        _estimating_status()
        if running == ADJUST
        else _checking_status()
        if checking and project.result is not None
        else _adjust_status(project, survey, waiting, refusal),
        _validating_status() if running == VALIDATE else _validation_status(project, survey),
        _report_status(project, survey, report, is_validating=running == VALIDATE),
    )


def with_input_error(status: StepStatus, problem: Message | None) -> StepStatus:
    """Status of a step in which a typed text is not accepted; its results do not contain it."""
    if problem is None or status.state == "empty":
        return status
    return replace(
        status, state="warning", sentence=gettext("a typed value is not used"),
        advice=message_text(problem),
    )  # fmt: skip


def _data_status(project: Project, survey: Survey | None) -> StepStatus:
    lines = len(project.lines)
    if survey is None:
        reading = Plural("reading {count:n} line", "reading {count:n} lines")
        return StepStatus(
            "todo",
            gettext(reading, count=lines),
            gettext("The files are being read."),
            Unavailable.READING,
        )
    points = sum(len(scan) for scan in survey.scans.values())
    sentence = gettext("{lines}, {points}", lines=line_count(lines), points=point_count(points))
    if data_warnings(project.with_data_messages(survey.messages)):
        return StepStatus(
            "warning",
            sentence,
            gettext("The files have warnings; see the panel Messages (F12)."),
        )
    if wrong := [each for each in all_warnings(project) if _is_about_given_value(each)]:
        return StepStatus("warning", sentence, message_text(wrong[0]))
    return StepStatus(
        "done",
        sentence,
        gettext("Check the lever arm and its signs, then continue with the targets."),
    )


def _is_about_given_value(message: Message) -> bool:
    """Whether a warning is about a given value of the mounting, which step 1 shows."""
    cause = message.subject
    return message.is_serious and cause is not None and cause.kind == "parameter"


def _waiting_status() -> StepStatus:
    """Status of a step that needs the points while they are read or georeferenced again."""
    return StepStatus(
        "empty",
        gettext("waiting for data"),
        gettext("Wait until the data are read."),
        Unavailable.READING,
    )


def _targets_status(
    project: Project, survey: Survey | None, poor_sightings: Sequence[str]
) -> StepStatus:
    used = [target for target in project.targets_of_role("target") if target.used]
    planes = project.targets_of_role("validation")
    if survey is None:
        return _waiting_status()
    if not used:
        return StepStatus(
            "todo",
            gettext("no targets yet"),
            gettext("Hold Ctrl and click a target in the view."),
        )
    compared = project.compared_targets
    in_few_lines = [target.name for target in used if target not in compared]
    lines = {s.line for target in used for s in target.used_sightings}
    targets = gettext(Plural("{count:n} target", "{count:n} targets"), count=len(used))
    sentence = gettext("{targets} in {lines}", targets=targets, lines=line_count(len(lines)))
    used_planes = [plane for plane in planes if plane.used]
    excluded = len(planes) - len(used_planes)
    if planes:
        text = gettext(VALIDATION_PLANE_COUNT_TEXT, count=len(planes))
        if excluded:
            text = gettext(USED_PLANES_TEXT, used=len(used_planes), count=len(planes))
        sentence = gettext("{targets}, {planes}", targets=targets, planes=text)
    if in_few_lines:
        return StepStatus(
            "warning",
            sentence,
            gettext(
                "{target} was found in fewer than two lines. Pick it in another line, import its "
                "surveyed control, or exclude it.",
                target=in_few_lines[0],
            ),
        )
    if len(used) < 2:
        return StepStatus(
            "warning",
            gettext("{targets}: second target required", targets=targets),
            _single_target_text(),
        )
    if project.result is None and have_targets_single_orientation(project, survey):
        return StepStatus("warning", sentence, _single_orientation_text())
    if poor_sightings:
        poor = gettext(
            Plural("{count:n} poor sighting", "{count:n} poor sightings"),
            count=len(poor_sightings),
        )
        return StepStatus(
            "warning",
            gettext("{targets}, {sightings}", targets=targets, sightings=poor),
            gettext(
                Plural(
                    "The quality of {sightings:names} is poor. Exclude it, or pick the target at "
                    "another place. Its tip in the table Targets by line gives the reason.",
                    "The quality of {sightings:names} is poor. Exclude them, or pick the targets "
                    "at other places. Their tips in the table Targets by line give the reasons.",
                ),
                count=len(poor_sightings), sightings=tuple(poor_sightings),
            ),
        )  # fmt: skip
    return StepStatus("done", sentence, _planes_advice(len(used_planes), excluded))


def _planes_advice(used: int, excluded: int) -> str:
    """Advice if there are enough targets, for the numbers of validation planes."""
    if excluded:
        used_text = gettext(
            Plural("{count:n} validation plane used", "{count:n} validation planes used"),
            count=used,
        )
        return gettext("{planes}, {excluded:n} excluded.", planes=used_text, excluded=excluded)
    if used:
        return gettext("There are enough targets and planes for the adjustment and the validation.")
    return gettext(
        "There are enough targets for the adjustment. Pick validation planes as well, to "
        "check how well the lines agree."
    )


def _adjust_status(
    project: Project, survey: Survey | None, waiting: bool, refusal: Message | str
) -> StepStatus:
    used = [target for target in project.targets_of_role("target") if target.used]
    reason = first_reason((not used, Unavailable.NO_TARGET), (survey is None, Unavailable.READING))
    if project.result is not None:
        factor = project.result.variance_factor
        # A default that nobody entered may be wrong, which is no reason for a warning
        assumed = bool(project.result.unestimated_sigmas)
        fits = project.result.chi_square.outcome != "failed" or assumed
        serious = any(message.is_serious for message in all_warnings(project))
        if serious:
            sentence = gettext("done, with warnings (F12)")
            advice = gettext("Read the warnings (F12) before you use the angles.")
        else:
            sentence = gettext("done: variance factor {factor:x.3}", factor=factor)
            if not fits:
                sentence = gettext("done, chi-square test failed")
            advice = gettext("The result is in the panel Results.")
        if not serious and not fits:
            advice = gettext(
                "The residuals do not agree with the standard deviations used. See the test in "
                "the panel Results."
            )
        return StepStatus(
            "done" if fits and not serious else "warning",
            sentence,
            advice,
            reason=reason,
        )
    if refusal:
        text = message_text(refusal) if isinstance(refusal, Message) else refusal
        return StepStatus("warning", gettext("not estimated"), text, reason=reason)
    if waiting:
        return StepStatus(
            "todo",
            gettext("estimation in progress"),
            gettext("The result is updated automatically."),
            reason=reason,
        )
    if reason is Unavailable.READING:
        return _waiting_status()
    if reason is not None:
        return StepStatus(
            "empty",
            gettext("pick targets first"),
            gettext("Pick at least two targets first."),
            reason,
        )
    if len(used) < 2:
        sentence = gettext("second target required")
        return StepStatus("warning", sentence, _single_target_text())
    if survey is not None and have_targets_single_orientation(project, survey):
        sentence = gettext("target with another orientation required")
        return StepStatus("warning", sentence, _single_orientation_text())
    return StepStatus("todo", gettext("ready to estimate"), gettext("Press Estimate."))


def _validation_status(project: Project, survey: Survey | None) -> StepStatus:
    planes = [plane for plane in project.targets_of_role("validation") if plane.used]
    reason = first_reason(
        (not planes and not project.validation, Unavailable.NO_PLANE),
        (project.result is None, Unavailable.NO_RESULT),
        (survey is None, Unavailable.READING),
    )
    if project.validation:
        return _compared_status(project, reason)
    if not planes:
        return StepStatus(
            "empty",
            gettext("no validation planes"),
            gettext(
                "Pick planes that are not used in the adjustment: select Validation plane in "
                "step 2, then Ctrl+click."
            ),
            reason,
        )
    if project.result is None:
        return StepStatus(
            "empty",
            gettext(
                Plural("{count:n} plane, estimate first", "{count:n} planes, estimate first"),
                count=len(planes),
            ),
            gettext("Estimate the boresight first, to compare the lines before and after."),
            reason,
        )
    return StepStatus(
        "todo",
        gettext(
            Plural("{count:n} plane to compare", "{count:n} planes to compare"), count=len(planes)
        ),
        gettext("Press Validate to compare the lines on each plane."),
        reason=reason,
    )


def _compared_status(project: Project, reason: Reason) -> StepStatus:
    """Status after a validation: judged by the acceptance criteria, or only compared."""
    better = sum(c.after.rms < c.before.rms for c in project.validation)
    total = len(project.validation)
    judgement, not_compared = project.judgement, project.not_compared
    passed = sum(judgement.verdict_on(plane.name) == "pass" for plane in project.validation)
    advice = [gettext("The histograms below show the distances between the lines.")]
    state: StepState
    if judgement.verdict == "fail":
        state, sentence = "failed", gettext("acceptance criteria not met")
        advice = [gettext("The calibration is not accepted. Probable causes are below.")]
    elif judgement.verdict == "pass":
        verdict = calibration_verdict_text(AcceptanceValues.of(judgement))
        state, sentence = "done", gettext("acceptance: {verdict}", verdict=verdict)
        if passed:  # else there are only criteria for the angles
            sentence = gettext(
                Plural(
                    "{passed:n} of {count:n} plane passes", "{passed:n} of {count:n} planes pass"
                ),
                passed=passed, count=total,
            )  # fmt: skip
    else:
        state = "todo"
        sentence = gettext(
            Plural(
                "{count:n} plane compared, not judged", "{count:n} planes compared, not judged"
            ),
            count=total,
        )  # fmt: skip
        if judgement.criteria.is_empty:
            advice.append(
                gettext("Enter acceptance criteria, so that the calibration can be judged.")
            )
    if state != "failed" and (not_compared or (better < total and judgement.verdict != "pass")):
        state = "warning"
    if not_compared and judgement.verdict == "not judged":  # shorter, so that it is not cut off
        sentence = gettext(
            "{compared:n} of {count:n} planes compared",
            compared=total, count=total + len(not_compared),
        )  # fmt: skip
    return StepStatus(
        state,
        sentence,
        "\n".join([*advice, *map(message_text, not_compared.values())]),
        reason=reason,
    )


def _estimating_status() -> StepStatus:
    return StepStatus(
        "todo", gettext("estimating …"), gettext("The adjustment is running."), Unavailable.BUSY
    )


def _checking_status() -> StepStatus:
    """Status without a verdict, which the checks may change."""
    return StepStatus(
        "todo",
        gettext("estimated, being checked …"),
        gettext("The angles are in the panel Results. The checks of the result are running."),
    )


def _validating_status() -> StepStatus:
    return StepStatus(
        "todo",
        gettext("validating …"),
        gettext("The lines are being compared on the validation planes."),
        Unavailable.BUSY,
    )


def _report_status(
    project: Project, survey: Survey | None, report: ExportedReport | None, *, is_validating: bool
) -> StepStatus:
    reason = first_reason(
        (project.result is None, Unavailable.NO_RESULT), (survey is None, Unavailable.READING)
    )
    if project.result is None:
        return StepStatus(
            "empty",
            gettext("estimate first"),
            gettext("The report needs an estimated boresight."),
            reason,
        )
    if is_validating:
        return StepStatus(
            "todo",
            gettext("waiting for the validation"),
            gettext("The validation is running. Export the report when it has ended."),
            Unavailable.BUSY,
        )
    is_failed = project.judgement.verdict == "fail"
    if report is not None:
        return _exported_status(report, reason, is_failed=is_failed)
    if is_failed:
        return StepStatus(
            "failed", gettext("not accepted, ready to export"), _not_accepted_text(), reason
        )
    if project.validation:
        return StepStatus(
            "todo",
            gettext("ready to export"),
            gettext("Export the report as PDF or HTML, or its numbers as JSON."),
            reason=reason,
        )
    return StepStatus(
        "warning",
        gettext("ready, without validation"),
        gettext(
            "The report has no validation yet; run step 4 to add it. You can export the report "
            "as PDF or HTML, or its numbers as JSON."
        ),
        reason=reason,
    )


def _exported_status(report: ExportedReport, reason: Reason, *, is_failed: bool) -> StepStatus:
    file, date = report.path.name, local_datetime(report.exported)
    if report.is_current and report.has_other_options:
        return StepStatus(
            "failed" if is_failed else "todo",
            gettext("not accepted, report options changed")
            if is_failed
            else gettext("report options changed"),
            gettext(
                "The report {file} was exported with other options on {date}. Export it again to "
                "apply the present ones.",
                file=file, date=date,
            ),
            reason=reason,
        )  # fmt: skip
    if report.is_current and is_failed:
        return StepStatus(
            "failed",
            gettext("not accepted, exported: {file}", file=file),
            _not_accepted_text(),
            reason,
        )
    if report.is_current:
        return StepStatus(
            "done",
            gettext("exported: {file}", file=file),
            gettext(
                "The report of {date} is up to date. You can export it again in another format.",
                date=date,
            ),
            reason=reason,
        )
    return StepStatus(
        "failed" if is_failed else "todo",
        gettext("not accepted, report out of date")
        if is_failed
        else gettext("report out of date"),
        gettext(
            "The project has changed since the report {file} was exported on {date}. Export it "
            "again.",
            file=file, date=date,
        ),
        reason=reason,
    )  # fmt: skip


def _not_accepted_text() -> str:
    return gettext(
        "The acceptance criteria are not met, and the report says so. Step 4 gives the probable "
        "causes."
    )


def _single_target_text() -> str:
    return message_text(note("project.single_target"))


def _single_orientation_text() -> str:
    return message_text(note("project.one_facing"))
