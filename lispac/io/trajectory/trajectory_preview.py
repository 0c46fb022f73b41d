"""Preview of a text trajectory: facts and warnings from its first and last rows."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, islice
from pathlib import Path

import numpy as np

from lispac.errors import InputError
from lispac.io.files import message_with_file_name
from lispac.io.format_types import Choice, Fact, FilePreview
from lispac.io.text.text_table import encoding_of, is_data_row, last_lines
from lispac.io.trajectory.trajectory_columns import (
    SIGMA_ROLES,
    Column,
    Rows,
    TrajectoryConventions,
    accuracy_of,
    is_complete,
    map_warnings,
    missing_columns,
    trajectory_of,
)
from lispac.io.trajectory.trajectory_facts import (
    TrajectoryMotion,
    angle_unit_messages,
    course_warnings,
    motion_of,
    span_facts,
    time_warnings,
    trajectory_facts,
)
from lispac.io.trajectory.trajectory_velocities import speed_warnings
from lispac.io.units import UNITS
from lispac.messages import Action, Level, Message, note, warning
from lispac.survey.line_source import printable
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy

HEAD_ROWS, TAIL_BYTES = 5000, 64 * 1024
"""Rows at the beginning and bytes at the end of a file that are read for its preview."""


@dataclass(frozen=True)
class TextLayout:
    """Columns of a text file, detected from its beginning or given by the user.

    Attributes
    ----------
    columns : tuple of Column
        Columns that the program uses.
    names : tuple of str
        All columns from the left, for the preview.
    split : callable
        Function that splits a row into the fields of the columns.
    rows : callable
        Function of the path that returns the rows of data, each with its number in the file.
    facts : dict of str to Fact
    file_warnings : tuple of Message
    velocities : tuple of Column
        East and north velocity, each with the unit of its length; empty if there are none.
    signs : mapping of str to str
        Signs of roll and pitch specified in the file, as option values, by the angle.
    """

    columns: tuple[Column, ...]
    names: tuple[str, ...]
    split: Callable[[str], list[str]]
    rows: Callable[[Path], Rows]
    facts: dict[str, Fact]
    file_warnings: tuple[Message, ...] = ()
    velocities: tuple[Column, ...] = ()
    signs: Mapping[str, str] = field(default_factory=dict)

    @property
    def column_facts(self) -> dict[str, Fact]:
        """Facts of the layout, with the names of all columns."""
        return {**self.facts, "Columns": ", ".join(self.names) or note("fact.not_known")}


def preview_text(
    path: Path, layout: TextLayout, conventions: TrajectoryConventions, choice: Choice
) -> FilePreview:
    """Facts, first rows and warnings of a text trajectory, from its first and last rows."""
    file = printable(path.name)
    head, unread = _first_rows(path, layout)
    rows_about = note("fact.about", count=_estimate_row_count(path, head))
    facts = {**layout.column_facts, "Rows": rows_about}
    rows = (layout.names, *(tuple(fields) for _, fields in head[:5]))
    file_warnings = [*layout.file_warnings, *unread]
    if not is_complete(layout.columns):
        missing = missing_columns(path, layout.columns)
        file_warnings.append(replace(missing, level=Level.WARNING))
        return FilePreview(facts, rows, choice, tuple(file_warnings))
    try:
        first = trajectory_of(path, iter(head), layout.columns, conventions, ())
    except InputError as refused:
        file_warnings.append(refusal_warning(refused, path))
        return FilePreview(facts, rows, choice, tuple(file_warnings))
    file_warnings += map_warnings(path, layout.columns, conventions, first)
    whole, tail_warnings = _with_last_rows(path, layout, conventions, first, head)
    motion, exchanged = _motion_variants(first)
    speed = motion.speed
    facts |= trajectory_facts(whole.time, whole.latitude, whole.longitude, whole.height, speed)
    file_warnings += tail_warnings
    file_warnings += time_warnings(first.time, conventions.time, file)
    file_warnings += course_warnings([(motion, exchanged)], [first.attitude[:, 2]], file)
    file_warnings += speed_warnings(path, head, layout.velocities, motion)
    unit = next(column.unit for column in layout.columns if column.role == "heading")
    messages = angle_unit_messages(path, motion, first.attitude[:, 2], UNITS[unit].si)
    return FilePreview(facts, rows, choice, tuple(file_warnings), first.assumptions, messages)


def _motion_variants(first: Trajectory) -> tuple[TrajectoryMotion, TrajectoryMotion]:
    """Motion as read and with latitude and longitude exchanged, from the first fix on."""
    fixed = np.flatnonzero((first.latitude != 0) | (first.longitude != 0))
    time, height = first.time[fixed], first.height[fixed]
    latitude, longitude = first.latitude[fixed], first.longitude[fixed]
    motion = motion_of(time, latitude, longitude, height)
    exchanged = motion_of(time, longitude, latitude, height)
    return (
        replace(motion, index=fixed[motion.index]),
        replace(exchanged, index=fixed[exchanged.index]),
    )


def preview_accuracy(
    path: Path, layout: TextLayout, conventions: TrajectoryConventions
) -> FilePreview:
    """Facts and warnings about standard deviations in text, from the first rows."""
    head, unread = _first_rows(path, layout)
    rows = (layout.names, *(tuple(fields) for _, fields in head[:5]))
    facts = layout.column_facts
    try:
        accuracy = accuracy_of(path, iter(head), layout.columns, conventions)
    except InputError as refused:
        return FilePreview(
            facts,
            rows,
            {"time": conventions.time},
            (*layout.file_warnings, *unread, refusal_warning(refused, path)),
        )
    found, file_warnings = accuracy_facts(accuracy, printable(path.name))
    return FilePreview(
        facts | found, rows, {"time": conventions.time},
        (*layout.file_warnings, *unread, *file_warnings),
    )  # fmt: skip


def accuracy_facts(
    accuracy: TrajectoryAccuracy, file: str
) -> tuple[dict[str, Fact], tuple[Message, ...]]:
    """Time span, size and warnings for the standard deviations in the file called ``file``."""
    facts, file_warnings = span_facts(accuracy.time), []
    position, attitude = accuracy.position, accuracy.attitude
    for name, values in zip(("north", "east", "height"), position.T, strict=True):
        facts[f"Sigma {name}"] = note("fact.fine_lengths", low=values.min(), high=values.max())
    for name, values in zip(("roll", "pitch", "heading"), attitude.T, strict=True):
        facts[f"Sigma {name}"] = note("fact.angles", low=values.min(), high=values.max())
    if not position.any() or not attitude.any():
        file_warnings.append(warning("accuracy.all_zero", file=file))
    if np.median(np.degrees(attitude)) > 1 or np.median(position) > 100:
        file_warnings.append(
            warning(
                "accuracy.large", file=file, position=float(np.median(position)),
                attitude=float(np.median(attitude)),
            )
        )  # fmt: skip
    return facts, tuple(file_warnings)


_SIGN_ASSUMED_CODES = {
    ("roll", "starboard-down"): "trajectory.roll_starboard_down",
    ("roll", "port-down"): "trajectory.roll_port_down",
    ("pitch", "bow-up"): "trajectory.pitch_bow_up",
    ("pitch", "bow-down"): "trajectory.pitch_bow_down",
}
"""Code of the warning that a sign is assumed, by the angle and the value of its option."""


def sign_assumed_warning(path: Path, angle: str, sign: str) -> Message:
    """Warning that a file does not specify the sign of roll or pitch."""
    code, actions = _SIGN_ASSUMED_CODES[angle, sign], (Action("check_sign", {"name": angle}),)
    return Message(code, Level.WARNING, {"file": printable(path.name)}, actions=actions)


def refusal_warning(refused: InputError, path: Path) -> Message:
    """Convert an error into a warning, with the name of the file instead of its path."""
    return replace(message_with_file_name(refused, path), level=Level.WARNING)


def has_sigmas(columns: Sequence[Column]) -> bool:
    """True if the columns contain all six standard deviations."""
    return {column.role for column in columns}.issuperset(SIGMA_ROLES)


def _first_rows(
    path: Path, layout: TextLayout
) -> tuple[list[tuple[int, list[str]]], tuple[Message, ...]]:
    """First rows, and a warning if a row among them does not have the columns of the header.

    Raises
    ------
    InputError
        If a row is not a row of data.
    """
    head = []
    try:
        for row in islice(layout.rows(path), HEAD_ROWS):
            head.append(row)
    except InputError as refused:
        if not head or refused.code != "trajectory.uneven_row":
            raise
        return head, (refusal_warning(refused, path),)
    return head, ()


def _with_last_rows(
    path: Path,
    layout: TextLayout,
    conventions: TrajectoryConventions,
    first: Trajectory,
    head: Sequence[tuple[int, list[str]]],
) -> tuple[Trajectory, list[Message]]:
    """First and last rows as one trajectory; only the first rows if the last do not fit."""
    if len(head) < HEAD_ROWS:
        return first, []
    tail = list(_last_rows(path, layout))
    # In a short file, the last rows overlap the first ones.
    repeated = [k for k, (_, fields) in enumerate(tail) if fields == head[-1][1]]
    rows = chain(head, tail[repeated[-1] + 1 :] if repeated else tail)
    try:
        return trajectory_of(path, rows, layout.columns, conventions, ()), []
    except InputError:
        return first, [warning("trajectory.last_rows", file=printable(path.name))]


def _last_rows(path: Path, layout: TextLayout) -> Rows:
    for row, line in enumerate(last_lines(path, TAIL_BYTES), start=1):
        fields = layout.split(line)
        if is_data_row(fields):
            yield row, fields


def _estimate_row_count(path: Path, head: Sequence[tuple[int, list[str]]]) -> int:
    if len(head) < HEAD_ROWS:
        return len(head)
    lines = last_lines(path, TAIL_BYTES)
    length = sum(len(line) + 1 for line in lines) / max(len(lines), 1)
    if encoding_of(path) == "utf-16":
        length *= 2
    return int(path.stat().st_size / max(length, 1.0))
