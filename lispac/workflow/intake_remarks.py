"""What there is to say about a file on its way in: a sentence each, and what would mend it."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

import numpy as np

from lispac.geometry.frames import geodetic_to_ecef
from lispac.io.line_times import LineTimes
from lispac.io.registry import Kind
from lispac.io.trajectory_facts import UNUSABLE, gap_doubts
from lispac.message_texts import action_text, message_text
from lispac.messages import Action, Message
from lispac.messages import Level as MessageLevel
from lispac.project import LineSource
from lispac.survey.source import RESTART, printable
from lispac.survey.time_base import Match, TimeBase, rival_matches, sentence
from lispac.survey.time_quality import Coverage, short_of_trajectory
from lispac.survey.time_restart import NONE, restart_words
from lispac.survey.time_stated import Known, contradiction, following, following_words
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy
from lispac.workflow.intake_entry import Entry
from lispac.workflow.intake_times import (
    SHARE_NEEDED,
    fitting,
    line_base,
    line_coverage,
    offered_shift,
    trajectory_base,
)

Level = Literal["error", "doubt", "note"]

FARTHEST = 20_000.0
"""Metres between a line's points and the trajectory; no scanner sees farther."""


@dataclass(frozen=True)
class Remedy:
    """What a button beside a sentence does to the file.

    Attributes
    ----------
    words : str
        On the button.
    shift : float or None, seconds
        Added to the line's times.
    role : {"trajectory", "accuracy", "points", "none"} or None
        What the file becomes; none leaves it out.
    option : (str, str) or None
        Option and value to state.
    ask : str
        Option that the user has to fill in: the window goes to its field.
    longest_gap : float or None, seconds
        Of the trajectory that may be bridged.
    split_by : str or None
        What makes several lines of the file, as `split_line` has it; empty for one line.
    found_columns : bool
        Takes back the remembered columns.
    tip : str
        What stands behind it, for the button's tip.
    """

    words: str
    shift: float | None = None
    role: Kind | Literal["none"] | None = None
    option: tuple[str, str] | None = None
    ask: str = ""
    longest_gap: float | None = None
    split_by: str | None = None
    found_columns: bool = False
    tip: str = ""


@dataclass(frozen=True)
class Remark:
    """A sentence about a file.

    Attributes
    ----------
    level : {"error", "doubt", "note"}
        An error keeps the project from being made; a note needs no look.
    """

    level: Level
    text: str
    remedies: tuple[Remedy, ...] = ()


_LEVELS: Mapping[MessageLevel, Level] = {
    MessageLevel.ERROR: "error", MessageLevel.WARNING: "doubt", MessageLevel.NOTE: "note",
}  # fmt: skip


def remark_of(message: Message) -> Remark:
    """A message about a file, with a button for each of its actions."""
    remedies = tuple(_remedy_of(each) for each in message.actions if each.code in _REMEDIES)
    return Remark(_LEVELS[message.level], message_text(message), remedies)


_REMEDIES = ("set_option", "split_line")
"""Actions that apply to a file."""


def _remedy_of(action: Action) -> Remedy:
    if action.code == "split_line":
        return Remedy(action_text(action), split_by=action.params["by"])
    return Remedy(action_text(action), option=(action.params["name"], action.params["value"]))


LEAVE_OUT = Remedy("Leave it out", role="none")


def already_there(entry: Entry, lines: Mapping[Path, str]) -> tuple[Remark, ...]:
    """What there is to say where a file is a line of the open project; ``lines`` are names."""
    name = lines.get(entry.path)
    if name is None or entry.role != "points":
        return ()
    return (Remark("error", f"This is the line {name} of the project already.", (LEAVE_OUT,)),)


def without_changes(entry: Entry, remarks: tuple[Remark, ...]) -> tuple[Remark, ...]:
    """Remarks without the remedies that would change the open project lines are added to."""
    return tuple(
        replace(
            remark,
            remedies=tuple(
                remedy
                for remedy in remark.remedies
                if entry.given is None and remedy.longest_gap is None
            ),
        )
        for remark in remarks
    )


def remarks_of(
    entry: Entry,
    trajectory: Entry | None,
    trajectories: int,
    accuracies: int,
    longest_gap: float,
) -> tuple[Remark, ...]:
    """All there is to say about a file, the worst first.

    Parameters
    ----------
    trajectory : Entry or None
        The first file whose role is the trajectory.
    trajectories, accuracies : int
        Files of these roles.
    longest_gap : float, seconds
    """
    if entry.pending:
        return ()
    if entry.role is None:
        return (Remark("note", entry.error),) if entry.error else ()
    told = _own(entry, longest_gap)
    if entry.role == "trajectory":
        if trajectories > 1:
            told.append(_one_too_many("trajectory"))
    elif entry.role == "accuracy":
        if accuracies > 1:
            told.append(_one_too_many("accuracy"))
        told += _accuracy_in_time(entry, trajectory)
    elif trajectory is not None and isinstance(trajectory.content, Trajectory):
        base = trajectory_base(trajectory)
        told += time_remarks(entry, trajectory.content, longest_gap, base)
        told += _place_remarks(entry, trajectory.content)
    order = {"error": 0, "doubt": 1, "note": 2}
    return tuple(sorted(told, key=lambda remark: order[remark.level]))


def _one_too_many(role: str) -> Remark:
    return Remark(
        "error",
        f"More than one file has the role {role}, and a project has one; leave the others out.",
        (LEAVE_OUT,),
    )


SYSTEM_ERRORS = {
    "trajectory.no_system", "trajectory.grid_heading", "trajectory.outside_system",
    "trajectory.not_projected", "trajectory.unusable_system",
}  # fmt: skip
"""Codes of errors that another coordinate system may end."""


def _own(entry: Entry, longest_gap: float) -> list[Remark]:
    """What the file says by itself."""
    told: list[Remark] = []
    if entry.error:
        ask = Remedy("State the coordinate system", ask="crs")
        about_system = entry.error_code in SYSTEM_ERRORS or "coordinate system" in entry.error
        wanted = about_system and "crs" in entry.options
        told.append(Remark("error", entry.error, (ask, LEAVE_OUT) if wanted else (LEAVE_OUT,)))
    elif entry.place is not None and entry.place.error:
        ask = Remedy("State the coordinate system", ask="crs")
        told.append(Remark("error", entry.place.error, (ask, LEAVE_OUT)))
    if entry.remembered and entry.finding is not None:
        back = Remedy("Choose anew", found_columns=True)
        told.append(
            Remark(
                "note", "The columns are those chosen for the last file laid out alike.", (back,)
            )
        )
    # The columns that an error asks for need no doubt beside it.
    said = "" if entry.finding is None else " ".join(entry.finding.doubts)
    unnamed = "does not name its columns" in said or "columns lack" in said
    if entry.finding is not None:
        for doubt in entry.finding.doubts:
            if entry.error and (doubt == entry.error or (unnamed and "columns" in doubt)):
                continue
            if UNUSABLE in doubt and isinstance(entry.content, Trajectory):
                continue  # the reader does not know which gaps are to be bridged
            told.append(Remark("doubt", doubt, _remedies_of(entry, doubt)))
    if entry.finding is not None:
        told += [
            remark_of(message)
            for message in entry.finding.messages
            if not (entry.split_by and _is_split(message, entry.split_by))
        ]
    if entry.split_by:
        parts = entry.parts(LineSource(printable(entry.path.stem), entry.path))
        names = tuple(each.name for each in parts)
        message = Message("file.split", MessageLevel.NOTE, {"count": len(parts), "lines": names})
        told.append(replace(remark_of(message), remedies=(Remedy("One line", split_by=""),)))
    if isinstance(entry.content, Trajectory):
        told += [Remark("doubt", doubt) for doubt in gap_doubts(entry.content.time, longest_gap)]
    if isinstance(entry.content, LineTimes) and not entry.content.reached_end:
        told.append(
            Remark(
                "note",
                f"The file is long: the first {len(entry.content.sample):,} times looked at stand "
                "for it here, the rest is checked when the project is made.",
            )
        )
    return told


def _is_split(message: Message, by: str) -> bool:
    """Whether the lines that a file is split into do what a message proposes."""
    return any(each.code == "split_line" and each.params["by"] == by for each in message.actions)


def _remedies_of(entry: Entry, doubt: str) -> tuple[Remedy, ...]:
    """What the options of the format offer against a doubt of its reader."""
    options = entry.options
    if "look exchanged" in doubt and options.get("order") == "latitude-longitude":
        return (Remedy("Exchange them", option=("order", "longitude-latitude")),)
    if "radians are taken" in doubt:
        name = "position" if "position" in doubt else "attitude"
        return (Remedy("They are degrees", option=(name, "degrees")),)
    if "give its EPSG code" in doubt and "crs" in options:
        return (Remedy("State the coordinate system", ask="crs"),)
    if "comes from feet" in doubt or "speaks of feet" in doubt:
        return (
            Remedy("They are feet", option=("unit", "foot")),
            Remedy("US survey feet", option=("unit", "us-survey-foot")),
        )
    if "taken as EPSG" in doubt and "crs" in options:
        return (Remedy("Look at the coordinate system", ask="crs"),)
    if "sign" in doubt and "pitch" in doubt and "pitch" in options:
        return (Remedy("Look at the signs", ask="pitch"),)
    if "could also be" in doubt and "time" in options:
        return (Remedy("Choose the time base", ask="time"),)
    if "choose the time base" in doubt and "time_base" in options:
        return (Remedy("Choose the time base", ask="time_base"),)
    if "check the frame" in doubt and "frame" in options:
        return (Remedy("Choose the frame", ask="frame"),)
    return ()


def _accuracy_in_time(entry: Entry, trajectory: Entry | None) -> list[Remark]:
    if trajectory is None or not isinstance(trajectory.content, Trajectory):
        return []
    if not isinstance(entry.content, TrajectoryAccuracy):
        return []
    own, track = entry.content.time, trajectory.content.time
    if own[-1] < track[0] or own[0] > track[-1]:
        return [
            Remark(
                "error",
                f"Its times ({own[0]:,.1f} to {own[-1]:,.1f} s) do not meet those of the "
                f"trajectory ({track[0]:,.1f} to {track[-1]:,.1f} s); give the file that belongs "
                "to it, or leave it out and type the accuracies.",
                (LEAVE_OUT,),
            )
        ]
    words = short_of_trajectory(own, track)
    return [Remark("doubt", f"{words[:1].upper()}{words[1:]}.")] if words else []


def time_remarks(entry: Entry, track: Trajectory, longest_gap: float, known: Known) -> list[Remark]:
    """How the trajectory covers a line, where there is something to say; ``known`` is its base."""
    times, covered = entry.content, line_coverage(entry, track, longest_gap)
    if covered is None or not isinstance(times, LineTimes):
        return []
    own, base = line_base(entry), known.base
    if wrong := contradiction(times.sample, own):
        back = Remedy("Take it back", option=("time_base", ""))
        return [Remark("error", message_text(wrong), (back, LEAVE_OUT))]
    if entry.follows:
        told = _stated_remarks(entry, times, track, own, known)
    else:
        told = _shift_remarks(entry, times, track, base)
    if times.restart:
        told.append(_restart_remark(times))
    if covered.usable == covered.count:
        return told
    if covered.usable == 0 and covered.outside:
        return [*told, _outside(entry, times, track, base)]
    remedies = []
    if covered.in_gaps:
        widest = max((close - open_ for open_, close in covered.gaps), default=0.0)
        if widest <= 10 * longest_gap:
            bridged = float(np.ceil(widest * 10) / 10)
            remedies.append(Remedy(f"Bridge up to {bridged:g} s", longest_gap=bridged))
    words = _not_usable(covered, len(times.sample) == times.count)
    if more := offered_shift(entry, track, longest_gap, base):
        remedies.insert(0, _adding(more))
        words += (
            f" With {more.shift:+,.3f} s added, {100 * more.share:.1f} % lie inside: make sure "
            f"whether the scanner wrote {more.points.name}."
        )
    told.append(Remark("doubt", words, (*remedies,)))
    return told


def _restart_remark(times: LineTimes) -> Remark:
    """That the line's own times start again, and what was made of it."""
    words = restart_words(times.sample, times.restart)
    back = Remedy("They do not restart", option=(RESTART, NONE))
    return Remark("note", f"{words[:1].upper()}{words[1:]}.", (back,))


def _stated_remarks(
    entry: Entry, times: LineTimes, track: Trajectory, own: Known, other: Known
) -> list[Remark]:
    """What the stated time bases do to a line."""
    found = following(times.sample, track.time, own, other)
    if not found or not entry.shift:
        return []
    words = following_words(found, own, other)
    back = (Remedy("Take it back", option=("time_base", "")),) if own.stated else ()
    return [Remark("note", f"{words}.", back)]


def _shift_remarks(
    entry: Entry, times: LineTimes, track: Trajectory, base: TimeBase | None
) -> list[Remark]:
    """What a time shift in use rests on; a doubt where another one fits as well."""
    if not entry.shift:
        return []
    told = f"{entry.shift:+,.3f} s are added to its times"
    undo = Remedy("Take it back", shift=0.0)
    found = fitting(times, track, base)
    rivals = [] if not found else [
        match for match in (found[0], *rival_matches(found)[:2])
        if abs(match.shift - entry.shift) > 1e-6
    ]  # fmt: skip
    if not rivals:
        return [Remark("note", f"{told}.", (undo,))]
    others = " or ".join(f"{match.shift:+,.3f} s ({match.points.name})" for match in rivals)
    return [
        Remark(
            "doubt",
            f"{told}. By the times alone {others} would fit as well: make sure which time base "
            "the scanner wrote.",
            (*(_adding(match) for match in rivals), undo),
        )
    ]


def _adding(match: Match) -> Remedy:
    return Remedy(
        f"Add {match.shift:+,.0f} s",
        shift=match.shift,
        tip=f"Points in {match.points.name}, trajectory in {match.trajectory.name}",
    )


def _not_usable(covered: Coverage, whole: bool) -> str:
    parts = []
    if covered.outside:
        parts.append(f"{_share(covered.share_outside, whole)} lie before or after the trajectory")
    if covered.in_gaps:
        gaps = "gaps" if len(covered.gaps) > 1 else "a gap"
        parts.append(
            f"{_share(covered.share_in_gaps, whole)} lie in {gaps} of the trajectory longer than "
            f"{covered.longest_gap:g} s"
        )
    said = " and ".join(parts)
    return f"{said[:1].upper()}{said[1:]}: these points will be left out."


def _share(share: float, whole: bool) -> str:
    about = "" if whole else "about "
    return f"{about}{100 * share:.{1 if share >= 0.001 else 3}f} % of the points"


def _outside(entry: Entry, times: LineTimes, track: Trajectory, base: TimeBase | None) -> Remark:
    start, end = times.start + entry.shift, times.end + entry.shift
    span = f"{start:,.1f} to {end:,.1f} s"
    reach = f"{track.time[0]:,.1f} to {track.time[-1]:,.1f} s"
    found = fitting(times, track, base)
    if found and found[0].share >= SHARE_NEEDED and abs(found[0].shift - entry.shift) > 1e-9:
        offered = (found[0], *rival_matches(found)[:2])
        return Remark(
            "error",
            f"No point lies within the trajectory (line {span}, trajectory {reach}). "
            f"{sentence(found)}",
            (*(_adding(match) for match in offered), LEAVE_OUT),
        )
    apart = track.time[0] - end if end < track.time[0] else start - track.time[-1]
    where = "before it starts" if end < track.time[0] else "after it ends"
    return Remark(
        "error",
        f"No point lies within the trajectory: the line is {span}, the trajectory {reach}, "
        f"{apart:,.0f} s {where}. No known time base brings them together; give the trajectory of "
        "the same survey, or leave the line out.",
        (LEAVE_OUT,),
    )


def _place_remarks(entry: Entry, track: Trajectory) -> list[Remark]:
    place = entry.place
    if place is None or place.error:
        return []
    points = geodetic_to_ecef(np.array([place.latitude]), np.array([place.longitude]), np.zeros(1))
    path = geodetic_to_ecef(track.latitude[::50], track.longitude[::50], 0 * track.height[::50])
    distance = float(np.linalg.norm(path - points, axis=1).min())
    if distance < FARTHEST:
        return []
    return [
        Remark(
            "error",
            f"In {place.system} the points lie {distance / 1000:,.0f} km from the trajectory; "
            "state the coordinate system that they are in.",
            (Remedy("State the coordinate system", ask="crs"), LEAVE_OUT),
        )
    ]
