"""What each of the five steps has, lacks and asks for next, in words."""

from dataclasses import dataclass
from typing import Literal

from lispac.doubles import doubts_of
from lispac.gui.language import say_message
from lispac.message_texts import message_text
from lispac.messages import note
from lispac.project import Project
from lispac.workflow.facing import face_one_way
from lispac.workflow.survey import Survey

State = Literal["empty", "todo", "done", "warning"]

STEPS = ("Data", "Targets", "Adjust", "Validate", "Report")
DATA, TARGETS, ADJUST, VALIDATE, REPORT = range(5)


@dataclass(frozen=True)
class StepStatus:
    """State of one step.

    Attributes
    ----------
    sentence : short, for the step's header
    advice : what to do next, for the step's panel
    ready : whether the step can be run
    """

    state: State
    sentence: str
    advice: str
    ready: bool = False


def counted(number: int, word: str, many: str = "") -> str:
    """``1 line``, ``6 lines``."""
    return f"{number:,} {word if number == 1 else many or word + 's'}"


def point_count(number: int) -> str:
    """A large count as one reads it: ``812``, ``26,104``, ``4.9 M points``."""
    return f"{number / 1e6:.1f} M points" if number >= 1_000_000 else counted(number, "point")


def steps(
    project: Project | None,
    survey: Survey | None,
    *,
    waiting: bool = False,
    refusal: str = "",
    reported: str = "",
) -> tuple[StepStatus, ...]:
    """Status of the five steps in order.

    Parameters
    ----------
    survey : Survey or None
        None while data are not loaded.
    waiting : bool
        Whether a result is to follow from the last edit by itself.
    refusal : str
        Why none follows, in words.
    reported : str
        Name of the file a report of the project as it stands was written to.
    """
    if project is None:
        nothing = StepStatus("empty", "no project", "Open or make a project first.")
        first = StepStatus(
            "todo",
            "no project open",
            "Make a project from a trajectory and raw lines, or open the built-in demo survey.",
        )
        return (first, *[nothing] * 4)
    return (
        _data(project, survey),
        _targets(project, survey),
        _adjust(project, survey, waiting, refusal),
        _validate(project, survey),
        _report(project, survey, reported),
    )


def _data(project: Project, survey: Survey | None) -> StepStatus:
    lines = counted(len(project.lines), "line")
    if survey is None:
        return StepStatus("todo", f"{lines}, being read", "The files are being read.")
    points = sum(len(scan) for scan in survey.scans.values())
    return StepStatus(
        "done",
        f"{lines}, {point_count(points)}",
        "Check the lever arm and its signs, then go on to the targets.",
        ready=True,
    )


def _targets(project: Project, survey: Survey | None) -> StepStatus:
    used = [target for target in project.of_role("target") if target.used]
    planes = project.of_role("validation")
    if survey is None:
        return StepStatus("empty", "data first", "Wait until the data are read.")
    if not used:
        return StepStatus(
            "todo", "no targets yet", "Hold Ctrl and click a target in the view.", ready=True
        )
    thin = [target.name for target in used if len(target.used_sightings) < 2]
    lines = {s.line for target in used for s in target.used_sightings}
    sentence = f"{counted(len(used), 'target')} in {counted(len(lines), 'line')}"
    if planes:
        sentence += f", {counted(len(planes), 'validation plane')}"
    if thin:
        return StepStatus(
            "warning",
            sentence,
            f"{thin[0]} is seen on fewer than two lines: seed it on another, or leave it out.",
            ready=True,
        )
    if len(used) < 2:
        return StepStatus(
            "warning",
            f"{sentence}: second target required",
            _single_target(),
            ready=True,
        )
    if project.result is None and face_one_way(project, survey):
        return StepStatus("warning", sentence, _one_facing(), ready=True)
    advice = (
        "Enough to adjust. Pick validation planes too, to show how well the lines agree."
        if not planes
        else "Enough to adjust and to validate."
    )
    return StepStatus("done", sentence, advice, ready=True)


def _adjust(project: Project, survey: Survey | None, waiting: bool, refusal: str) -> StepStatus:
    used = [target for target in project.of_role("target") if target.used]
    ready = survey is not None and bool(used)
    if project.result is not None:
        factor = project.result.variance_factor
        passed = project.result.chi_square.passed
        serious = any(message.is_serious for message in doubts_of(project))
        if serious:
            advice = "Do not use the angles before you have read the warnings on the right."
        elif passed:
            advice = "The result stands on the right."
        else:
            advice = "The residuals do not match the stated sigmas: see the test on the right."
        return StepStatus(
            "done" if passed and not serious else "warning",
            f"done{', in doubt' if serious else ''}: variance factor {factor:.2f}",
            advice,
            ready=ready,
        )
    if refusal:
        return StepStatus("warning", "not estimated", refusal, ready=ready)
    if waiting:
        return StepStatus("todo", "estimating again", "The result follows at once.", ready=ready)
    if not ready:
        return StepStatus("empty", "pick targets first", "Pick at least two targets first.")
    if len(used) < 2:
        return StepStatus("warning", "a second target is missing", _single_target(), ready=True)
    if survey is not None and face_one_way(project, survey):
        return StepStatus("warning", "another inclination is missing", _one_facing(), ready=True)
    return StepStatus("todo", "ready to estimate", "Press Estimate.", ready=True)


def _validate(project: Project, survey: Survey | None) -> StepStatus:
    planes = [plane for plane in project.of_role("validation") if plane.used]
    if project.validation:
        better = sum(c.after.rms < c.before.rms for c in project.validation)
        total = len(project.validation)
        sentence = f"{better} of {total} {'plane' if total == 1 else 'planes'} closer than before"
        left_out = project.not_compared
        if left_out:
            sentence += f", {len(left_out)} not compared"
        return StepStatus(
            "done" if better == total and not left_out else "warning",
            sentence,
            "\n".join(["The histograms stand below.", *map(say_message, left_out.values())]),
            ready=project.result is not None and survey is not None,
        )
    if not planes:
        return StepStatus(
            "empty",
            "no validation planes",
            "Pick planes that take no part in the adjustment: choose Validation plane in step 2, "
            "then Ctrl+click.",
        )
    if project.result is None:
        return StepStatus(
            "empty",
            f"{counted(len(planes), 'plane')}, estimate first",
            "Estimate the boresight first; then the lines are compared before and after.",
        )
    return StepStatus(
        "todo",
        f"{counted(len(planes), 'plane')} to compare",
        "Press Validate to compare the lines on each plane.",
        ready=survey is not None,
    )


def _report(project: Project, survey: Survey | None, reported: str) -> StepStatus:
    if project.result is None:
        return StepStatus("empty", "estimate first", "The report needs an estimated boresight.")
    if reported:
        return StepStatus(
            "done",
            f"exported: {reported}",
            "The report tells of the project as it stands; export it again in another form.",
            ready=survey is not None,
        )
    missing = "" if project.validation else " It will have no validation: run step 4 for it."
    return StepStatus(
        "todo" if project.validation else "warning",
        "ready to export" if project.validation else "ready, without validation",
        "Export the report as PDF or HTML, or its numbers as JSON." + missing,
        ready=survey is not None,
    )


def _single_target() -> str:
    return message_text(note("project.single_target"))


def _one_facing() -> str:
    return message_text(note("project.one_facing"))
