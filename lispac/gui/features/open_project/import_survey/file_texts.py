"""Texts of the import dialogue for a file: its role, contents, state and options."""

from PySide6.QtGui import QIcon

from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.io.format_types import Kind
from lispac.io.points.line_times import LineTimes
from lispac.language import N_, Plural, gettext, number
from lispac.message_texts import fact_text
from lispac.messages import Level
from lispac.survey.known_time_base import base_message
from lispac.survey.time_base import TimeBase
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy
from lispac.workflow.importing.input_file import InputFile
from lispac.workflow.importing.input_files import InputFiles

ROLE_NAMES: dict[Kind | None, str] = {
    "trajectory": N_("Trajectory"), "accuracy": N_("Accuracy"), "points": N_("Line"),
    None: N_("Not imported"),
}  # fmt: skip
_COUNT_FACTS = ("points", "Points", "Records", "Rows")
"""Names of the facts with the number of points or states of a file, in order of preference."""
NO_VALUE = "–"


def count_text(file: InputFile) -> str:
    """Text of the number of points or states of a file."""
    content = file.content
    if isinstance(content, LineTimes) and content.count is not None:
        return number(content.count)
    if isinstance(content, Trajectory | TrajectoryAccuracy):
        return number(len(content.time))
    facts = {} if file.finding is None else file.finding.facts
    return next((fact_text(facts[name]) for name in _COUNT_FACTS if name in facts), NO_VALUE)


def time_span_text(file: InputFile) -> str:
    """Text of the first and last time of a file."""
    content = file.content
    if isinstance(content, LineTimes):
        return f"{_seconds(content.start)} – {_seconds(content.end)}"
    if isinstance(content, Trajectory | TrajectoryAccuracy):
        return f"{_seconds(content.time[0])} – {_seconds(content.time[-1])}"
    return NO_VALUE


def _seconds(value: float) -> str:
    """Seconds of a time base; as everywhere, groups of three digits are not separated."""
    return number(value, 1, is_grouped=False)


def frame_text(file: InputFile) -> str:
    """Text of the frame of the coordinates of a file."""
    if file.role == "points":
        if not file.is_georeferenced:
            return gettext("Scanner")
        place = file.place
        return (
            place.system
            if place is not None and place.system
            else gettext("Coordinate system not given")
        )
    if file.role == "trajectory":
        return file.options.get("crs") or gettext("Latitude, longitude")
    return gettext("North, east, down") if file.role == "accuracy" else NO_VALUE


def state_text(input_files: InputFiles, file: InputFile) -> tuple[str, str]:
    """Text and colour of the state of a file."""
    match input_files.state_of_file(file):
        case "pending":
            return gettext("Waiting"), theme.MUTED
        case "fine":
            return gettext("OK"), theme.DONE
        case "error":
            return gettext("Error"), theme.ERROR
        case "warning":
            warnings = sum(message.level is Level.WARNING for message in input_files.messages(file))
            text = gettext(Plural("{count:n} warning", "{count:n} warnings"), count=warnings)
            return text, theme.WARNING
    is_unknown = not file.checks and not file.pending
    return gettext("Unknown") if is_unknown else gettext("Not imported"), theme.MUTED


def state_icon(input_files: InputFiles, file: InputFile) -> QIcon:
    """Icon of the state of a file."""
    name = {
        "pending": "timer-sand", "fine": "check-circle-outline", "warning": "alert-outline",
        "error": "close-octagon-outline", "out": "minus-circle-outline",
    }[input_files.state_of_file(file)]  # fmt: skip
    return theme.icon(name, state_text(input_files, file)[1])


def time_axis_title(base: TimeBase | None) -> str:
    """Title of an axis of time."""
    if base is None:
        return gettext("Time (s)")
    text = message_text(base_message(base))
    return f"{text[:1].upper()}{text[1:]}"
