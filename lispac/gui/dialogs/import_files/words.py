"""How the dialogue words what a file is and how it stands."""

from PySide6.QtGui import QIcon

from lispac.gui import theme
from lispac.io.line_times import LineTimes
from lispac.io.registry import Kind
from lispac.messages import Level
from lispac.survey.time_base import KEYS, base_of
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy
from lispac.workflow.intake import Intake
from lispac.workflow.intake_entry import Entry

ROLES: dict[Kind | None, str] = {
    "trajectory": "Trajectory", "accuracy": "Accuracy", "points": "Line", None: "Leave out",
}  # fmt: skip
_COUNTS = ("points", "Points", "Records", "Rows")
_OPTIONS = {
    "crs": "Coordinate system", "byte_order": "Order of bytes", "restart": "Time rollover",
    "withheld": "Withheld points", "exclude_classes": "Excluded classes",
    "only": "Only points with", "max_range": "Largest range (m)",
}  # fmt: skip
_WITHHELD = {"exclude": "excluded", "keep": "used"}
_RESTARTS = {
    "none": "nowhere", "midnight": "at midnight", "week-end": "at the end of the week",
    "full-hour": "at the full hour",
}  # fmt: skip
_UNSTATED = {
    "restart": "automatic", "grid_unit": "by the system", "heights": "by the system",
}  # fmt: skip
_FRAMES = {"scanner": "Scanner", "georeferenced": "On the map"}


def count(entry: Entry) -> str:
    """How many points or states."""
    content = entry.content
    if isinstance(content, LineTimes) and content.count is not None:
        return f"{content.count:,}"
    if isinstance(content, Trajectory | TrajectoryAccuracy):
        return f"{len(content.time):,}"
    facts = {} if entry.finding is None else entry.finding.facts
    return next((facts[name] for name in _COUNTS if name in facts), "–")


def span(entry: Entry) -> str:
    """First and last time."""
    content = entry.content
    if isinstance(content, LineTimes):
        return f"{content.start:,.1f} – {content.end:,.1f}"
    if isinstance(content, Trajectory | TrajectoryAccuracy):
        return f"{content.time[0]:,.1f} – {content.time[-1]:,.1f}"
    return "–"


def frame(entry: Entry) -> str:
    """What the coordinates refer to."""
    if entry.role == "points":
        if not entry.georeferenced:
            return "Scanner"
        place = entry.place
        return place.system if place is not None and place.system else "System not stated"
    if entry.role == "trajectory":
        return entry.options.get("crs") or "Latitude, longitude"
    return "North, east, down" if entry.role == "accuracy" else "–"


def state(intake: Intake, entry: Entry) -> tuple[str, str]:
    """State in words, and the colour that goes with it."""
    now = intake.state(entry)
    remarks = intake.remarks(entry)
    if now == "doubt":
        doubts = sum(remark.level is Level.WARNING for remark in remarks)
        return ("1 doubt" if doubts == 1 else f"{doubts} doubts"), theme.WARNING
    unknown = not entry.looks and not entry.pending
    return {
        "pending": ("Waiting", theme.MUTED),
        "fine": ("OK", theme.DONE),
        "error": ("Error", theme.ERROR),
        "out": ("Not known" if unknown else "Left out", theme.MUTED),
    }[now]


def state_icon(intake: Intake, entry: Entry) -> QIcon:
    """A mark beside the word."""
    name = {
        "pending": "timer-sand", "fine": "check-circle-outline", "doubt": "alert-outline",
        "error": "close-octagon-outline", "out": "minus-circle-outline",
    }[intake.state(entry)]  # fmt: skip
    return theme.icon(name, state(intake, entry)[1])


def option_name(name: str) -> str:
    """An option as its label shows it."""
    return _OPTIONS.get(name, name.replace("_", " ").capitalize())


def option_value(name: str, value: str) -> str:
    """A choice of an option as its list shows it."""
    if not value:
        return _UNSTATED.get(name, "as the file says")
    if name == "restart":
        return _RESTARTS[value]
    if name == "withheld":
        return _WITHHELD[value]
    if value in KEYS:
        return base_of(value).name
    if name == "frame":
        return _FRAMES[value]
    return value.replace("-", " ") if name not in ("axes",) else value
