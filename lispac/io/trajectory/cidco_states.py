"""Reading of the POS states in CIDCO's binary points as a trajectory.

Every point contains the state at its time: position in a local frame (north, west, up), roll, pitch
and heading relative to this frame, and the sigmas. The file contains only the times at which the
extracted objects were scanned, and not the position of the local frame on Earth. Files of several
lines can be concatenated, because they have no header.
"""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame
from lispac.geometry.rotations import rotation_angles, rotation_matrix
from lispac.io.files import require_numbers
from lispac.io.format_types import IMPOSSIBLE, POSSIBLE, Choice, Fact, FilePreview, FormatOption
from lispac.io.point_reader_common import (
    POINTS_PER_CHUNK,
    PREVIEW_POINTS,
    preview_table,
    report_damage,
    require_not_empty,
)
from lispac.io.trajectory.cidco import COLUMN_NAMES, record_chunks
from lispac.io.trajectory.cidco import sniff as sniff_points
from lispac.io.trajectory.trajectory_checks import require_attitude, require_heights
from lispac.io.trajectory.trajectory_facts import span_facts
from lispac.io.trajectory.trajectory_options import (
    TIME_OPTION,
    trajectory_format,
)
from lispac.io.trajectory.trajectory_preview import accuracy_facts
from lispac.language import N_
from lispac.messages import Message, error, note, warning
from lispac.survey.line_source import printable
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy

Array = NDArray[np.float64]

ORIGIN_OPTION = FormatOption(
    "origin",
    N_(
        "Origin of the local frame of the file: latitude and longitude in degrees, height in "
        "metres above the ellipsoid, as in 46.8 -71.2 20."
    ),
    (),
    "0 0 0",
)
STATE_COLUMNS = slice(10, 22)
SAME_STATE_TOLERANCE = 1e-6
"""Largest difference of states with the same time, metres or radians."""


def sniff_states(path: Path) -> float:
    """Likelihood that a file contains CIDCO's states, not greater than that of its points."""
    return POSSIBLE if sniff_points(path) > IMPOSSIBLE else IMPOSSIBLE


def preview_states(path: Path, choice: Choice) -> FilePreview:
    """Preview a file, which is read completely because it is small.

    Raises
    ------
    InputError
        If the file is damaged.
    """
    states = _state_table(path)
    return FilePreview(
        _state_facts(states),
        _preview_rows(path),
        {},
        _origin_warnings(path, choice),
        _assumptions(choice),
    )


def read_states(path: Path, choice: Choice) -> Trajectory:
    """Read the states and convert them to geographic coordinates with the given origin.

    Raises
    ------
    InputError
        If the file cannot be read, the origin is not valid, or states with the same time differ.
    """
    states = _state_table(path)
    frame = _origin_frame(choice)
    require_attitude(path, states[:, 0], tuple(states[:, 1:4].T))
    latitude, longitude, height = frame.to_geodetic(states[:, 7:10])
    require_heights(path, height)
    rotation_level_local = np.swapaxes(frame.rotation_local_level(latitude, longitude), -1, -2)
    attitude = rotation_angles(rotation_level_local @ rotation_matrix(*states[:, 1:4].T))
    return Trajectory(states[:, 0], latitude, longitude, height, attitude, _assumptions(choice))


def preview_sigmas(path: Path, choice: Choice) -> FilePreview:
    """Preview the standard deviations of the states; the file is read completely."""
    facts, file_warnings = accuracy_facts(read_sigmas(path, choice), printable(path.name))
    return FilePreview(
        _state_facts(_state_table(path)) | facts, _preview_rows(path), {}, file_warnings
    )


def read_sigmas(path: Path, choice: Choice) -> TrajectoryAccuracy:
    """Read the sigmas of the states; those of north, west, up are used for north, east, down.

    Raises
    ------
    InputError
        If the file is damaged.
    """
    states = _state_table(path)
    return TrajectoryAccuracy(states[:, 0], states[:, 10:13], states[:, 4:7])


def _state_table(path: Path) -> Array:
    """Table of time, attitude, its sigmas, position, its sigmas; shape (n, 13), each time once.

    Raises
    ------
    InputError
        If the states are not those of one trajectory.
    """
    path = require_not_empty(path, "CIDCO")
    with report_damage(path, "CIDCO binary"):
        records = np.concatenate(list(record_chunks(path, POINTS_PER_CHUNK)))
    states = np.column_stack([records[:, 3], records[:, STATE_COLUMNS]])
    require_numbers(states, path, "CIDCO binary")
    states = states[np.argsort(states[:, 0], kind="stable")]
    repeated = np.diff(states[:, 0]) == 0
    differs = repeated & (np.abs(np.diff(states[:, 1:], axis=0)) > SAME_STATE_TOLERANCE).any(axis=1)
    if differs.any():
        time = float(states[int(np.argmax(differs)), 0])
        raise InputError(error("cidco.different_states", file=str(path), time=time))
    states = states[np.concatenate([[True], ~repeated])]
    if len(states) < 2:
        raise InputError(error("cidco.one_state", file=str(path)))
    return np.ascontiguousarray(states)


def _origin_frame(choice: Choice) -> LocalFrame:
    text = choice.get("origin", ORIGIN_OPTION.default) or ORIGIN_OPTION.default
    try:
        latitude, longitude, height = (float(word) for word in text.replace(",", " ").split())
    except ValueError:
        latitude = longitude = height = np.nan
    if not (abs(latitude) < 89 and abs(longitude) <= 360 and abs(height) < 1e5):
        raise InputError(error("cidco.invalid_origin", origin=text))
    return LocalFrame(float(np.radians(latitude)), float(np.radians(longitude)), height)


def _preview_rows(path: Path) -> tuple[tuple[str, ...], ...]:
    records = next(record_chunks(path, PREVIEW_POINTS))
    return preview_table(COLUMN_NAMES, tuple(records.T))


def _state_facts(states: Array) -> dict[str, Fact]:
    low, high = states[:, 7:10].min(axis=0), states[:, 7:10].max(axis=0)
    facts: dict[str, Fact] = {"Records": note("fact.states", count=len(states))}
    facts |= span_facts(states[:, 0])
    for axis, a, b in zip(("north", "west", "up"), low, high, strict=True):
        facts[f"Position {axis}"] = note("fact.lengths", low=a, high=b)
    return facts


def _origin_warnings(path: Path, choice: Choice) -> tuple[Message, ...]:
    if choice.get("origin", ORIGIN_OPTION.default) not in ("", ORIGIN_OPTION.default):
        return ()
    return (warning("cidco.no_origin", file=printable(path.name)),)


def _assumptions(choice: Choice) -> tuple[Message, ...]:
    origin = choice.get("origin", ORIGIN_OPTION.default) or ORIGIN_OPTION.default
    return (
        note("assumed.cidco_positions", origin=str(origin)),
        note("assumed.cidco_attitude"),
        note("assumed.times_of_points"),
    )


CIDCO_STATES_FORMAT = trajectory_format(
    note("format.cidco_states"),
    "cidco-states",
    "trajectory",
    (),
    (ORIGIN_OPTION, TIME_OPTION),
    sniff_states,
    preview_states,
    read_states,
)
CIDCO_ACCURACY_FORMAT = trajectory_format(
    note("format.cidco_sigmas"),
    "cidco-sigmas",
    "accuracy",
    (),
    (),
    sniff_states,
    preview_sigmas,
    read_sigmas,
)
