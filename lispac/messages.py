"""Messages to the user as values: a code, a level, parameters, a subject and actions.

A message contains numbers in SI units and names, never formatted text. `lispac.message_texts`
creates its text; no other code depends on the wording of a message.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from math import isfinite
from typing import Any, Union

from lispac.warning_causes import Cause

Value = Union[str, int, float, "Message", Sequence[Union[str, "Message"]]]
"""Parameter of a message: a name, a count, an SI quantity (metres, seconds, radians, ratios), a
list of names, or messages that are part of the message."""

MAX_LISTED_ITEMS = 4
"""Largest number of items of a list that are named; for the others only their number is given."""


class Level(StrEnum):
    """Severity of a message."""

    ERROR = "error"
    """The result cannot be used, or a file cannot be read."""
    WARNING = "warning"
    """The result may be wrong or less precise than given."""
    NOTE = "note"
    """Information, or something to check; the result can be used."""


@dataclass(frozen=True)
class Action:
    """Suggested action of a message.

    Attributes
    ----------
    code : str
        Kind of action, such as ``set_option``, ``exclude_line`` or ``split_line``.
    params : mapping of str to Value
        Parameters of the action: name and value of an option, name of a line, shift in seconds.
    """

    code: str
    params: Mapping[str, Value] = field(default_factory=dict, hash=False)


@dataclass(frozen=True)
class Message:
    """Message to the user.

    Attributes
    ----------
    code : str
        Permanent name of the condition, such as ``audit.time_step``.
    level : Level
    params : mapping of str to Value
        Values for the placeholders of the text, in SI units.
    subject : Cause or None
        Line, target, field or step that the message is about.
    actions : tuple of Action
    """

    code: str
    level: Level
    params: Mapping[str, Value] = field(default_factory=dict, hash=False)
    subject: Cause | None = None
    actions: tuple[Action, ...] = ()

    def __post_init__(self) -> None:
        """Convert numbers of NumPy to those of Python, which all users of parameters accept."""
        params = {name: _python_value(value) for name, value in self.params.items()}
        object.__setattr__(self, "params", params)
        object.__setattr__(self, "level", Level(self.level))  # scripts may give "note"

    @property
    def is_serious(self) -> bool:
        """True if the result cannot be used or may be wrong: more than a note."""
        return self.level is not Level.NOTE


def _python_value(value: Any) -> Any:
    if isinstance(value, list | tuple):
        return type(value)(map(_python_value, value))
    return value.tolist() if hasattr(value, "tolist") else value


IMPORTANT_NOTES = (
    "acceptance.", "validation.", "report.validation_", "report.noise_differs",
    "report.chi_square_high", "adjustment.sigmas_raised", "adjustment.shorter_times",
    "adjustment.cross_check",
)  # fmt: skip
"""Beginnings of the codes of notes that precede all others, the most important first."""
ROUTINE_NOTES = (
    "project.import_note", "report.sightings", "project.doubtful_sighting", "report.not_found",
    "project.not_found_on_line", "adjustment.signs_agree", "report.simulated",
)  # fmt: skip
"""Beginnings of the codes of notes that follow all others, the least important last."""


def sort_by_importance(messages: Iterable[Message]) -> tuple[Message, ...]:
    """Sort messages: errors, warnings, then notes with the most important ones first.

    The order of errors, of warnings and of notes of the same importance is kept.
    """
    order = list(Level)
    return tuple(
        sorted(messages, key=lambda each: (order.index(each.level), _importance_rank(each)))
    )


def _importance_rank(message: Message) -> int:
    """Rank of a note by its code; 0 for errors, warnings and all other notes."""
    if message.is_serious:
        return 0
    for rank, beginning in enumerate(IMPORTANT_NOTES, -len(IMPORTANT_NOTES)):
        if message.code.startswith(beginning):
            return rank
    for rank, beginning in enumerate(ROUTINE_NOTES, 1):
        if message.code.startswith(beginning):
            return rank
    return 0


def shortened_list(items: Sequence[str | Message]) -> tuple[str | Message, ...]:
    """First items of a list, with a note on the number of the others."""
    rest = len(items) - MAX_LISTED_ITEMS
    return (*items[:MAX_LISTED_ITEMS], note("item.more", count=rest)) if rest > 0 else tuple(items)


def is_routine(message: Message) -> bool:
    """Whether a message is a note for the record, which follows all others."""
    return _importance_rank(message) > 0


def plain_params(message: Message | Action) -> dict[str, Any]:
    """Parameters as values for JSON; nested messages as code and parameters."""
    return {name: _plain_value(value) for name, value in message.params.items()}


def _plain_value(value: Value) -> Any:
    if isinstance(value, Message):
        return {"code": value.code, "params": plain_params(value)}
    if isinstance(value, float):
        return value if isfinite(value) else None
    if isinstance(value, str | int):
        return value
    return [_plain_value(each) for each in value]


def as_message(reason: Message | str) -> Message:
    """Return a message unchanged; a text of a former project or script becomes a message."""
    return note("project.former_text", reason=reason) if isinstance(reason, str) else reason


def error(
    code: str, /, *, subject: Cause | None = None, actions: Sequence[Action] = (), **params: Value
) -> Message:
    """Message that a result cannot be used or a file cannot be read."""
    return Message(code, Level.ERROR, params, subject, tuple(actions))


def warning(
    code: str, /, *, subject: Cause | None = None, actions: Sequence[Action] = (), **params: Value
) -> Message:
    """Message that a result may be wrong or less precise than given."""
    return Message(code, Level.WARNING, params, subject, tuple(actions))


def note(
    code: str, /, *, subject: Cause | None = None, actions: Sequence[Action] = (), **params: Value
) -> Message:
    """Message with information, or something to check; the result can be used."""
    return Message(code, Level.NOTE, params, subject, tuple(actions))
