"""Messages about a file that is to be imported, with the actions that resolve them."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from lispac.geometry.frames import geodetic_to_ecef
from lispac.io.point_reader_common import CHOOSE_SYSTEM_ACTION
from lispac.io.points.line_times import LineTimes
from lispac.io.trajectory.ascii_trajectory import COLUMNS_ASSUMED_CODE
from lispac.io.trajectory.trajectory_facts import GAPS_CODE, gap_warnings
from lispac.messages import Action, Level, Message, Value, error, note, sort_by_importance, warning
from lispac.project import LineSource
from lispac.survey.known_time_base import (
    KnownTimeBase,
    base_message,
    known_base_notes,
    matches_of_known_bases,
    time_base_error,
)
from lispac.survey.line_source import TIME_ROLLOVER_OPTION, printable
from lispac.survey.time_base import TimeBase, TimeMatch, equally_good_matches
from lispac.survey.time_quality import TrajectoryCoverage, accuracy_coverage_warning
from lispac.survey.time_rollover import NO_ROLLOVER, rollover_note
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy
from lispac.workflow.importing.file_reading import NOT_OF_ITS_FORMAT_CODE
from lispac.workflow.importing.input_file import COLUMNS_NOT_CHOSEN_CODE, InputFile
from lispac.workflow.importing.input_times import (
    MIN_SHARE_ON_TRAJECTORY,
    line_coverage,
    line_time_base,
    matching_shifts,
    proposed_shift,
    trajectory_time_base,
)

MAX_LINE_DISTANCE = 20_000.0
"""Largest plausible distance of a line from the trajectory, metres; no scanner has such a range."""

OPTION_SETTING_ACTIONS = {
    "set_option", "use_degrees", "use_feet", "use_us_survey_feet", "swap_coordinates",
    "clear_time_base", "ignore_rollover",
}  # fmt: skip
"""Codes of actions that give an option (parameter ``name``) a value (parameter ``value``)."""
CHECK_SIGN_CODE = "check_sign"
"""Code of the action that shows the attitude, so that the user can check its signs."""
OPTION_CHOICE_ACTIONS = {
    "choose_system", "check_system", "choose_vertical_reference", "choose_frame",
    "choose_time_base", CHECK_SIGN_CODE,
}  # fmt: skip
"""Codes of actions by which the user chooses the value of an option (parameter ``name``)."""
BRIDGE_GAPS_CODE = "bridge_gaps"
"""Code of the action that changes the longest gap of the project."""
FILE_ACTION_CODES = {
    "split_line", "keep_one_line", "leave_out", "shift_times", "clear_shift", "detect_columns",
    BRIDGE_GAPS_CODE, *OPTION_SETTING_ACTIONS, *OPTION_CHOICE_ACTIONS,
}  # fmt: skip
"""Codes of all actions that apply to a file as a whole."""

EXCLUDE_FILE_ACTION = Action("leave_out")
CLEAR_TIME_BASE_ACTION = Action("clear_time_base", {"name": "time_base", "value": ""})
IGNORE_ROLLOVER_ACTION = Action(
    "ignore_rollover", {"name": TIME_ROLLOVER_OPTION, "value": NO_ROLLOVER}
)

COORDINATE_SYSTEM_ERROR_CODES = {
    "trajectory.no_system", "trajectory.grid_heading", "trajectory.outside_system",
    "trajectory.not_projected", "trajectory.unusable_system", "file.coordinate_system",
    "las.local_frame",
}  # fmt: skip
"""Codes of errors that another coordinate system may resolve."""
COLUMN_WARNING_CODES = {
    "text.columns_not_named", "trajectory.columns_missing", "trajectory.position_missing",
    "trajectory.no_columns", COLUMNS_ASSUMED_CODE,
}  # fmt: skip
"""Codes of warnings that are redundant if an error requests the columns."""


def option_to_choose(action: Action) -> str:
    """Name of the option whose value an action asks the user to choose; empty for other actions."""
    return str(action.params["name"]) if action.code in OPTION_CHOICE_ACTIONS else ""


def already_in_project_error(
    input_file: InputFile, lines: Mapping[Path, str]
) -> tuple[Message, ...]:
    """Error that a file is already a line of the open project; ``lines`` are names by path."""
    name = lines.get(input_file.path)
    if name is None or input_file.role != "points":
        return ()
    file = printable(input_file.path.name)
    return (
        error("import.already_in_project", file=file, line=name, actions=(EXCLUDE_FILE_ACTION,)),
    )


def without_project_changes(
    input_file: InputFile, messages: tuple[Message, ...]
) -> tuple[Message, ...]:
    """Messages without the actions that would change the open project to which lines are added."""
    return tuple(
        replace(
            message,
            actions=tuple(
                action
                for action in message.actions
                if input_file.project_reading is None and action.code != BRIDGE_GAPS_CODE
            ),
        )
        for message in messages
    )


def file_messages(
    input_file: InputFile,
    trajectory: InputFile | None,
    trajectories: int,
    accuracies: int,
    longest_gap: float,
) -> tuple[Message, ...]:
    """All messages about a file, errors first.

    Parameters
    ----------
    trajectory : InputFile or None
        First file with the role of the trajectory.
    trajectories, accuracies : int
        Number of files with these roles.
    longest_gap : float, seconds
    """
    if input_file.pending:
        return ()
    if input_file.role is None:
        reason = input_file.error
        if reason is None:
            return ()
        # A file that its name announces is missed in the import; others may be anything
        return (reason if reason.code == NOT_OF_ITS_FORMAT_CODE else as_note(reason),)
    messages = _own_messages(input_file, longest_gap)
    file, actions = printable(input_file.path.name), (EXCLUDE_FILE_ACTION,)
    if input_file.role == "trajectory":
        if trajectories > 1:
            messages.append(error("import.several_trajectories", file=file, actions=actions))
    elif input_file.role == "accuracy":
        if accuracies > 1:
            messages.append(error("import.several_accuracies", file=file, actions=actions))
        messages += _accuracy_time_messages(input_file, trajectory)
    elif trajectory is not None and isinstance(trajectory.content, Trajectory):
        base = trajectory_time_base(trajectory)
        messages += time_messages(input_file, trajectory.content, longest_gap, base)
        messages += _location_messages(input_file, trajectory.content)
    return sort_by_importance(with_possible_actions(input_file, messages))


def as_note(message: Message) -> Message:
    """Change a message about an excluded file into a note."""
    return replace(message, level=Level.NOTE)


def with_possible_actions(
    input_file: InputFile, messages: Iterable[Message]
) -> tuple[Message, ...]:
    """Messages with only those actions for which the file has an option."""
    return tuple(
        replace(message, actions=tuple(a for a in message.actions if _is_possible(input_file, a)))
        for message in messages
    )


def _is_possible(input_file: InputFile, action: Action) -> bool:
    if action.code not in FILE_ACTION_CODES:
        return False
    if action.code not in OPTION_SETTING_ACTIONS | OPTION_CHOICE_ACTIONS:
        return True
    options, name = input_file.options, str(action.params["name"])
    return name in options and options[name] != action.params.get("value")


def _own_messages(input_file: InputFile, longest_gap: float) -> list[Message]:
    """Messages about a single file, independent of the others."""
    file = printable(input_file.path.name)
    messages: list[Message] = []
    if input_file.error:
        about_system = input_file.error.code in COORDINATE_SYSTEM_ERROR_CODES
        actions = (
            (CHOOSE_SYSTEM_ACTION, EXCLUDE_FILE_ACTION) if about_system else (EXCLUDE_FILE_ACTION,)
        )
        messages.append(replace(input_file.error, actions=(*input_file.error.actions, *actions)))
    elif input_file.place is not None and input_file.place.error:
        messages.append(
            replace(input_file.place.error, actions=(CHOOSE_SYSTEM_ACTION, EXCLUDE_FILE_ACTION))
        )
    if input_file.remembered and input_file.finding is not None:
        actions = (Action("detect_columns"),)
        messages.append(note("import.columns_remembered", file=file, actions=actions))
    if input_file.finding is not None:
        messages += [
            each
            for each in input_file.finding.file_warnings
            if not _is_superseded(input_file, each)
        ]
        messages += [
            message
            for message in input_file.finding.messages
            if not (input_file.split_by and _is_resolved_by_split(message, input_file.split_by))
        ]
    if input_file.split_by:
        parts = input_file.parts(LineSource(printable(input_file.path.stem), input_file.path))
        names, actions = tuple(each.name for each in parts), (Action("keep_one_line"),)
        messages.append(note("file.split", count=len(parts), lines=names, actions=actions))
    if isinstance(input_file.content, Trajectory):
        messages += gap_warnings(input_file.content.time, longest_gap, file)
    if isinstance(input_file.content, LineTimes) and not input_file.content.reached_end:
        messages.append(note("import.first_times", file=file, count=len(input_file.content.sample)))
    return messages


def _is_superseded(input_file: InputFile, reported: Message) -> bool:
    """True if another message about the file reports the same with better information."""
    if reported.code == GAPS_CODE and isinstance(input_file.content, Trajectory):
        return True  # the reader does not know the longest gap that is bridged
    if input_file.error is None:
        return False
    is_same = (reported.code, reported.params) == (input_file.error.code, input_file.error.params)
    is_about_columns = input_file.error.code in COLUMN_WARNING_CODES | {COLUMNS_NOT_CHOSEN_CODE}
    return is_same or (is_about_columns and reported.code in COLUMN_WARNING_CODES)


def _is_resolved_by_split(message: Message, by: str) -> bool:
    """True if the file is already split into lines as proposed by a message."""
    return any(each.code == "split_line" and each.params["by"] == by for each in message.actions)


def _accuracy_time_messages(input_file: InputFile, trajectory: InputFile | None) -> list[Message]:
    if trajectory is None or not isinstance(trajectory.content, Trajectory):
        return []
    if not isinstance(input_file.content, TrajectoryAccuracy):
        return []
    file = printable(input_file.path.name)
    own, track = input_file.content.time, trajectory.content.time
    if own[-1] < track[0] or own[0] > track[-1]:
        return [
            error(
                "import.accuracy_times", file=file, first=float(own[0]), last=float(own[-1]),
                start=float(track[0]), end=float(track[-1]), actions=(EXCLUDE_FILE_ACTION,),
            )
        ]  # fmt: skip
    too_short = accuracy_coverage_warning(own, track, file)
    return [] if too_short is None else [too_short]


def time_messages(
    input_file: InputFile, track: Trajectory, longest_gap: float, known: KnownTimeBase
) -> list[Message]:
    """Messages on the coverage of a line; ``known`` is the time base of the trajectory."""
    times, covered = input_file.content, line_coverage(input_file, track, longest_gap)
    if covered is None or not isinstance(times, LineTimes):
        return []
    file = printable(input_file.path.name)
    own, base = line_time_base(input_file), known.base
    if wrong := time_base_error(times.sample, own, file):
        return [replace(wrong, actions=(CLEAR_TIME_BASE_ACTION, EXCLUDE_FILE_ACTION))]
    if input_file.shift_follows_bases:
        messages = _given_base_notes(input_file, times, track, own, known)
    else:
        messages = _shift_messages(input_file, times, track, base)
    if times.rollover:
        rollover = rollover_note(times.sample, times.rollover, file)
        messages.append(replace(rollover, actions=(IGNORE_ROLLOVER_ACTION,)))
    if covered.usable == covered.count:
        return messages
    if covered.usable == 0 and covered.outside:
        return [*messages, *_outside_errors(input_file, times, track, base)]
    messages += _coverage_warnings(
        covered, file, longest_gap, whole=len(times.sample) == times.count
    )
    if better := proposed_shift(input_file, track, longest_gap, base):
        messages.append(
            warning(
                "import.shift_offered", file=file, shift=better.shift, share=better.share,
                base=base_message(better.points), actions=(_shift_action(better),),
            )
        )  # fmt: skip
    return messages


def _given_base_notes(
    input_file: InputFile,
    times: LineTimes,
    track: Trajectory,
    line_base: KnownTimeBase,
    other: KnownTimeBase,
) -> list[Message]:
    """Notes on the time shift that follows from the given time bases."""
    found = matches_of_known_bases(times.sample, track.time, line_base, other)
    if not found or not input_file.shift:
        return []
    first, *others = known_base_notes(found, line_base, other, printable(input_file.path.name))
    actions = (CLEAR_TIME_BASE_ACTION,) if line_base.is_given else ()
    return [replace(first, actions=actions), *others]


def _shift_messages(
    input_file: InputFile, times: LineTimes, track: Trajectory, base: TimeBase | None
) -> list[Message]:
    """Messages on the time shift in use, with a warning if another one also fits."""
    if not input_file.shift:
        return []
    file, undo = printable(input_file.path.name), Action("clear_shift")
    found = matching_shifts(times, track, base)
    rivals = [] if not found else [
        match for match in (found[0], *equally_good_matches(found)[:2])
        if abs(match.shift - input_file.shift) > 1e-6
    ]  # fmt: skip
    messages = [note("import.shifted", file=file, shift=input_file.shift, actions=(undo,))]
    if rivals:
        actions = (*map(_shift_action, rivals), undo)
        messages = [replace(messages[0], actions=()), _other_shifts_warning(file, rivals, actions)]
    return messages


def _other_shifts_warning(
    file: str, rivals: Iterable[TimeMatch], actions: tuple[Action, ...]
) -> Message:
    """Warning that other time shifts also fit the times."""
    shifts = tuple(
        note("import.shift_from", shift=match.shift, base=base_message(match.points))
        for match in rivals
    )
    return warning("import.other_bases_fit", file=file, shifts=shifts, actions=actions)


def _shift_action(match: TimeMatch) -> Action:
    return Action(
        "shift_times",
        {
            "shift": match.shift,
            "points": base_message(match.points),
            "trajectory": base_message(match.trajectory),
        },
    )


def _coverage_warnings(
    covered: TrajectoryCoverage, file: str, longest_gap: float, *, whole: bool
) -> list[Message]:
    """Warnings about points outside the time span or in gaps of the trajectory."""
    found = []
    if covered.outside:
        code = "import.points_outside" if whole else "import.points_outside_sampled"
        found.append(warning(code, file=file, share=covered.share_outside))
    if covered.in_gaps:
        code = "import.points_in_gaps" if whole else "import.points_in_gaps_sampled"
        share, limit = covered.share_in_gaps, covered.longest_gap
        in_gaps = warning(code, file=file, share=share, limit=limit)
        widest = max((close - open_ for open_, close in covered.gaps), default=0.0)
        if widest <= 10 * longest_gap:
            bridged = float(np.ceil(widest * 10) / 10)
            in_gaps = replace(in_gaps, actions=(Action(BRIDGE_GAPS_CODE, {"gap": bridged}),))
        found.append(in_gaps)
    return found


def _outside_errors(
    input_file: InputFile, times: LineTimes, track: Trajectory, base: TimeBase | None
) -> list[Message]:
    """Error that no point of a line lies within the trajectory."""
    file = printable(input_file.path.name)
    start, end = float(times.start + input_file.shift), float(times.end + input_file.shift)
    first, last = float(track.time[0]), float(track.time[-1])
    found = matching_shifts(times, track, base)
    if (
        found
        and found[0].share >= MIN_SHARE_ON_TRAJECTORY
        and abs(found[0].shift - input_file.shift) > 1e-9
    ):
        best, rivals = found[0], equally_good_matches(found)[:2]
        actions = (*map(_shift_action, (best, *rivals)), EXCLUDE_FILE_ACTION)
        span: dict[str, Value] = {
            "file": file, "first": start, "last": end, "start": first, "end": last,
            "share": best.share,
        }  # fmt: skip
        if abs(best.shift) < 1e-9:
            code = "import.outside_without_shift"
            actions = (Action("clear_shift"), *map(_shift_action, rivals), EXCLUDE_FILE_ACTION)
        else:
            code = "import.outside_with_shift"
            span |= {
                "shift": best.shift, "points": base_message(best.points),
                "trajectory": base_message(best.trajectory),
            }  # fmt: skip
        outside = Message(code, Level.ERROR, span, actions=actions)
        return [outside, *([_other_shifts_warning(file, rivals, ())] if rivals else [])]
    is_before = end < first
    return [
        error(
            "import.before_trajectory" if is_before else "import.after_trajectory", file=file,
            first=start, last=end, start=first, end=last,
            distance=first - end if is_before else start - last, actions=(EXCLUDE_FILE_ACTION,),
        )
    ]  # fmt: skip


def _location_messages(input_file: InputFile, track: Trajectory) -> list[Message]:
    place = input_file.place
    if place is None or place.error:
        return []
    points = geodetic_to_ecef(np.array([place.latitude]), np.array([place.longitude]), np.zeros(1))
    path = geodetic_to_ecef(track.latitude[::50], track.longitude[::50], 0 * track.height[::50])
    distance = float(np.linalg.norm(path - points, axis=1).min())
    if distance < MAX_LINE_DISTANCE:
        return []
    return [
        error(
            "import.far_from_trajectory", file=printable(input_file.path.name), system=place.system,
            distance=distance, actions=(CHOOSE_SYSTEM_ACTION, EXCLUDE_FILE_ACTION),
        )
    ]  # fmt: skip
