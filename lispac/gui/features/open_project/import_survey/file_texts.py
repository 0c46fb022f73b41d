"""Texts of the import dialogue for a file: its role, contents, state and options."""

from PySide6.QtGui import QIcon

from lispac.gui.appearance import theme
from lispac.io.format_types import Kind
from lispac.io.points.line_times import LineTimes
from lispac.language import N_, Plural, gettext, number
from lispac.message_texts import fact_text, message_text
from lispac.messages import Level
from lispac.survey.known_time_base import base_message
from lispac.survey.time_base import TIME_BASE_KEYS, TimeBase, base_of_key
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy
from lispac.workflow.importing.input_file import InputFile
from lispac.workflow.importing.input_files import InputFiles

ROLE_NAMES: dict[Kind | None, str] = {
    "trajectory": N_("Trajectory"), "accuracy": N_("Accuracy"), "points": N_("Line"),
    None: N_("Not imported"),
}  # fmt: skip
_COUNT_FACTS = ("points", "Points", "Records", "Rows")
"""Names of the facts with the number of points or states of a file, in order of preference."""
_OPTION_LABELS = {
    "attitude": N_("Unit of attitude"),
    "axes": N_("Axes"),
    "byte_order": N_("Byte order"),
    "columns": N_("Columns"),
    "crs": N_("Coordinate system"),
    "decimal": N_("Decimal separator"),
    "epoch": N_("Epoch"),
    "exclude_classes": N_("Excluded classes"),
    "frame": N_("Frame"),
    "grid_unit": N_("Unit of grid coordinates"),
    "header": N_("Header"),
    "heading": N_("Heading"),
    "height": N_("Height"),
    "height_unit": N_("Unit of heights"),
    "heights": N_("Unit of heights"),
    "max_range": N_("Maximum range (m)"),
    "only": N_("Attribute filter"),
    "order": N_("Coordinate order"),
    "origin": N_("Origin"),
    "pitch": N_("Pitch"),
    "position": N_("Unit of latitude and longitude"),
    "roll": N_("Roll"),
    "separator": N_("Column separator"),
    "time": N_("Time"),
    "time_base": N_("Time base"),
    "time_field": N_("Time field"),
    "time_rollover": N_("Time rollover (midnight or week)"),
    "time_from": N_("Time origin"),
    "time_unit": N_("Time unit"),
    "trajectory_datum": N_("Trajectory datum"),
    "unit": N_("Unit"),
    "withheld": N_("Withheld points"),
}
"""Labels of the options."""
_FACT_LABELS = {
    "attributes": N_("Attributes"),
    "columns": N_("Columns"),
    "Columns": N_("Columns"),
    "comments": N_("Comments"),
    "coordinate system": N_("Coordinate system"),
    "Date of mission": N_("Date of the survey"),
    "decimal": N_("Decimal separator"),
    "Duration": N_("Duration"),
    "End": N_("End"),
    "fields": N_("Fields"),
    "format": N_("Format"),
    "frame": N_("Frame"),
    "Header": N_("Header"),
    "Height": N_("Height"),
    "Latitude": N_("Latitude"),
    "Longitude": N_("Longitude"),
    "Made from": N_("Source file"),
    "Mapping frame": N_("Map projection frame"),
    "points": N_("Points"),
    "Position north": N_("Position north"),
    "Position west": N_("Position west"),
    "Position up": N_("Position up"),
    "Rate": N_("Rate"),
    "Records": N_("Records"),
    "resolution": N_("Resolution"),
    "Roll and pitch": N_("Roll and pitch"),
    "Rows": N_("Rows"),
    "separator": N_("Column separator"),
    "Sigma north": N_("Standard deviation north"),
    "Sigma east": N_("Standard deviation east"),
    "Sigma height": N_("Standard deviation of height"),
    "Sigma roll": N_("Standard deviation of roll"),
    "Sigma pitch": N_("Standard deviation of pitch"),
    "Sigma heading": N_("Standard deviation of heading"),
    "Sign of roll": N_("Sign of roll"),
    "Sign of pitch": N_("Sign of pitch"),
    "Speed": N_("Speed"),
    "Start": N_("Start"),
    "time base": N_("Time base"),
    "time from, to": N_("Time"),
    "unit": N_("Unit"),
    "Velocities": N_("Velocities"),
    "viewpoint": N_("Scanner viewpoint"),
    "Wander angle": N_("Wander angle"),
    "written by": N_("Written by software"),
    "x from, to": N_("X"),
    "y from, to": N_("Y"),
    "z from, to": N_("Z"),
}
"""Labels of the facts about a file."""
_EMPTY_VALUE_TEXTS = {
    "time_rollover": N_("automatic"),
    "grid_unit": N_("same as the coordinate system"),
    "heights": N_("same as the coordinate system"),
}
"""Texts of an empty value, for options whose default is not the value in the file."""
_OPTION_VALUE_TEXTS = {
    ("time_rollover", "none"): N_("none"),
    ("frame", "scanner"): N_("Scanner"),
    ("axes", "unknown"): N_("unknown"),
    ("header", "auto"): N_("automatic"),
}
"""Texts of values that differ between options, by option and value."""
_VALUE_TEXTS = {
    "as-is": N_("as in the file"),
    "auto": N_("automatic"),
    "big-endian": N_("big-endian"),
    "blank": N_("space"),
    "bow-down": N_("positive with bow down"),
    "bow-up": N_("positive with bow up"),
    "centimetre": N_("centimetres"),
    "comma": N_("comma (,)"),
    "degrees": N_("degrees"),
    "degrees-minutes": N_("degrees and minutes"),
    "dms": N_("degrees, minutes, seconds"),
    "enu": N_("east, north, up"),
    "exclude": N_("exclude"),
    "fathom": N_("fathoms"),
    "feet": N_("feet"),
    "foot": N_("feet"),
    "full-hour": N_("at every full hour"),
    "georeferenced": N_("Georeferenced"),
    "grid": N_("grid north"),
    "header": N_("as in the header"),
    "hour": N_("hours"),
    "inch": N_("inches"),
    "international-feet": N_("international feet"),
    "keep": N_("include"),
    "kilometre": N_("kilometres"),
    "latitude-longitude": N_("latitude, longitude"),
    "little-endian": N_("little-endian"),
    "longitude-latitude": N_("longitude, latitude"),
    "metre": N_("metres"),
    "metres": N_("metres"),
    "microsecond": N_("microseconds"),
    "midnight": N_("at midnight"),
    "millimetre": N_("millimetres"),
    "millisecond": N_("milliseconds"),
    "minus-wander": N_("subtract the wander angle"),
    "minute": N_("minutes"),
    "nanosecond": N_("nanoseconds"),
    "ned": N_("north, east, down"),
    "neu": N_("north, east, up"),
    "nwu": N_("north, west, up"),
    "point": N_("point (.)"),
    "port-down": N_("positive with port side down"),
    "radians": N_("radians"),
    "second": N_("seconds"),
    "semicolon": N_("semicolon (;)"),
    "starboard-down": N_("positive with starboard side down"),
    "start": N_("start of the scan"),
    "tab": N_("tab"),
    "true": N_("true north"),
    "us-survey-feet": N_("US survey feet"),
    "us-survey-foot": N_("US survey feet"),
    "wander-ned": N_("north, east, down, rotated by the wander angle"),
    "wander-nwu": N_("north, west, up, rotated by the wander angle"),
    "week-end": N_("at the end of the week"),
    "yard": N_("yards"),
    "zero": N_("zero"),
}
"""Texts of the values that are the same for all options."""
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
        return f"{number(content.start, 1)} – {number(content.end, 1)}"
    if isinstance(content, Trajectory | TrajectoryAccuracy):
        return f"{number(content.time[0], 1)} – {number(content.time[-1], 1)}"
    return NO_VALUE


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
            return gettext("Waiting to be read"), theme.MUTED
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


def option_name(name: str) -> str:
    """Label of an option."""
    return gettext(_OPTION_LABELS.get(name, name))


def fact_name(name: str) -> str:
    """Label of a fact about a file."""
    return gettext(_FACT_LABELS.get(name, name))


def option_value(name: str, value: str) -> str:
    """Text of a value of an option."""
    if not value:
        return (
            gettext(_EMPTY_VALUE_TEXTS[name])
            if name in _EMPTY_VALUE_TEXTS
            else gettext("as in the file")
        )
    if (name, value) in _OPTION_VALUE_TEXTS:
        return gettext(_OPTION_VALUE_TEXTS[name, value])
    if value in TIME_BASE_KEYS:
        return message_text(base_message(base_of_key(value)))
    return gettext(_VALUE_TEXTS[value]) if value in _VALUE_TEXTS else value


def time_axis_title(base: TimeBase | None) -> str:
    """Title of an axis of time."""
    if base is None:
        return gettext("Time (s)")
    text = message_text(base_message(base))
    return f"{text[:1].upper()}{text[1:]}"
