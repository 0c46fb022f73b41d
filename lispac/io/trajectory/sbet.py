"""Reading and writing of Applanix SBET trajectories and smrmsg accuracies."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame
from lispac.io.files import atomic_write, read_records, require_file, require_increasing
from lispac.io.format_types import SAME_TIME_BASE_NOTE
from lispac.io.trajectory.trajectory_checks import (
    require_attitude,
    require_heights,
    require_time_base,
)
from lispac.io.trajectory.trajectory_columns import sign_note
from lispac.messages import Message, error, note
from lispac.survey.known_time_base import base_message
from lispac.survey.state_densification import attitude_rates, body_rates
from lispac.survey.time_base import base_of_key, plausible_bases, unroll_times
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy

Array = NDArray[np.float64]

SMRMSG_RECORD_BYTES = 80
"""Bytes of a record of smrmsg."""
APPLANIX_ASSUMPTIONS = (note("assumed.applanix"), SAME_TIME_BASE_NOTE)


@dataclass(frozen=True)
class SbetOptions:
    """Reading options for the conventions that an SBET does not specify."""

    heading: str = "minus-wander"
    pitch: str = "bow-up"
    roll: str = "starboard-down"
    axes: str = "unknown"
    time: str = "gps-week"
    unit: str = "radians"
    order: str = "latitude-longitude"
    byte_order: str = "little-endian"

    def assumptions(self) -> tuple[Message, ...]:
        """Notes on the assumed conventions."""
        return (
            note(_HEADING_NOTE_CODES[self.heading]),
            sign_note(self.roll),
            sign_note(self.pitch),
            note("assumed.fitting_velocity_axes")
            if self.axes == "unknown"
            else note("assumed.velocity_axes", axes=VELOCITY_AXES[self.axes]),
            note("assumed.time_base", base=base_message(base_of_key(self.time))),
            note(_UNIT_NOTE_CODES[self.unit]),
            note(_ORDER_NOTE_CODES[self.order]),
            note(_BYTE_ORDER_NOTE_CODES[self.byte_order]),
            note("assumed.ellipsoidal_heights"),
        )


_HEADING_NOTE_CODES = {
    "minus-wander": "assumed.heading_less_wander",
    "as-is": "assumed.heading_as_is",
}
_UNIT_NOTE_CODES = {"radians": "assumed.angles_in_radians", "degrees": "assumed.angles_in_degrees"}
_ORDER_NOTE_CODES = {
    "latitude-longitude": "assumed.latitude_first",
    "longitude-latitude": "assumed.longitude_first",
}
_BYTE_ORDER_NOTE_CODES = {
    "little-endian": "assumed.little_endian",
    "big-endian": "assumed.big_endian",
}
"""Codes of the notes on the byte order, by the value of the option."""
VELOCITY_AXES = {
    "wander-nwu": note("axes.wander_nwu"),
    "wander-ned": note("axes.wander_ned"),
    "ned": note("axes.ned"),
    "enu": note("axes.enu"),
    "nwu": note("axes.nwu"),
    "neu": note("axes.neu"),
}
"""Names of the axes of the velocities, by the value of the option."""


def read_sbet(path: Path, options: SbetOptions | None = None) -> Trajectory:
    """Read an SBET with 17 float64 per record.

    Times are continued across a time rollover at midnight or at the end of the week, which the
    assumptions then mention.

    Parameters
    ----------
    options : SbetOptions, optional
        Applanix's conventions by default.

    Raises
    ------
    InputError
        If the file is missing, cut short, contains NaN, angles out of range or disordered times.
    """
    path = Path(path)
    chosen = options or SbetOptions()
    byte_order = "<" if chosen.byte_order == "little-endian" else ">"
    records = read_records(path, 17, "SBET", byte_order=byte_order)
    if len(records) < 2:
        raise InputError(error("sbet.one_record", file=str(path)))
    time, latitude, longitude, height = np.ascontiguousarray(records[:, :4].T)
    roll, pitch, heading, wander = np.ascontiguousarray(records[:, 7:11].T)
    time, starts = unroll_times(time)
    assumptions = APPLANIX_ASSUMPTIONS if options is None else options.assumptions()
    if starts:
        assumptions += (note("assumed.time_rollover", count=starts),)
    require_increasing(time, path, "SBET")
    if options is not None:
        require_time_base(path, time, base_of_key(options.time))
    if chosen.unit == "degrees":
        latitude, longitude, roll, pitch, heading, wander = (
            np.radians(angle) for angle in (latitude, longitude, roll, pitch, heading, wander)
        )
    if chosen.order == "longitude-latitude":
        latitude, longitude = longitude, latitude
    _require_on_earth(path, latitude, longitude, chosen)
    require_attitude(path, time, (roll, pitch, heading - wander))
    require_heights(path, height)
    attitude = np.stack(
        [
            -roll if chosen.roll == "port-down" else roll,
            -pitch if chosen.pitch == "bow-up" else pitch,
            heading - wander if chosen.heading == "minus-wander" else heading,
        ],
        axis=1,
    )
    velocity, rates = _derivatives(records, chosen)
    trajectory = Trajectory(
        time, latitude, longitude, height, attitude, assumptions, attitude_rate=rates
    )
    return trajectory if velocity is None else _with_velocity(trajectory, velocity, wander, chosen)


def velocity_in_axes(axes: str, velocity: Array, wander: Array) -> Array:
    """Velocities to the north, east and up, shape (n, 3), from those in other axes.

    Parameters
    ----------
    axes : str
        Axes of the velocities, a key of `VELOCITY_AXES`.
    velocity : ndarray of shape (n, 3), metres a second, frame of ``axes``
    wander : ndarray of shape (n,), radians
    """
    x, y, z = velocity.T
    if axes.startswith("wander"):
        right = -y if axes == "wander-nwu" else y
        sin, cos = np.sin(wander), np.cos(wander)
        north, east = x * cos + right * sin, right * cos - x * sin
        return np.stack([north, east, z if axes.endswith("u") else -z], axis=1)
    named = {"n": 1.0, "s": -1.0, "e": 1.0, "w": -1.0, "u": 1.0, "d": -1.0}
    place = {"n": 0, "e": 1, "w": 1, "u": 2, "d": 2}
    turned = np.empty_like(velocity)
    for axis, values in zip(axes, (x, y, z), strict=True):
        turned[:, place[axis]] = named[axis] * values
    return turned


MAX_STATES_COMPARED = 20_000
"""Largest number of states whose velocities are compared with the positions to find their axes."""


def _derivatives(records: Array, chosen: SbetOptions) -> tuple[Array | None, Array | None]:
    """Velocities and attitude rates from the records; None for either if its values are zero."""
    velocity = records[:, 4:7] if records[:, 4:7].any() else None
    rates = records[:, 14:17]
    if not rates.any():
        return velocity, None
    factor = float(np.radians(1.0)) if chosen.unit == "degrees" else 1.0
    # Signs of the kinematic equations: roll positive starboard down, pitch positive bow up.
    signs = np.array(
        [-1.0 if chosen.roll == "port-down" else 1.0, -1.0 if chosen.pitch == "bow-down" else 1.0,
         1.0]
    )  # fmt: skip
    angles = factor * records[:, 7:10]
    compared = slice(0, MAX_STATES_COMPARED)
    numerical_rates = np.gradient(np.unwrap(angles[compared], axis=0), records[compared, 0], axis=0)

    def rates_about(axes: list[float], part: slice) -> Array:
        return attitude_rates(angles[part] * signs, factor * rates[part] * axes)

    def residual(axes: list[float]) -> float:
        return float(np.abs(rates_about(axes, compared) - numerical_rates * signs).sum())

    # Axes forward, starboard, down; the rates may instead be about forward, port, up.
    axes = min(([1.0, 1.0, 1.0], [1.0, -1.0, -1.0]), key=residual)
    return velocity, rates_about(axes, slice(None)) * [1.0, -1.0, 1.0]  # pitch bow down


def _with_velocity(
    trajectory: Trajectory, velocity: Array, wander: Array, chosen: SbetOptions
) -> Trajectory:
    """Add velocities to the trajectory, in the given axes or those that fit the positions best."""
    keys = [chosen.axes] if chosen.axes != "unknown" else list(VELOCITY_AXES)
    compared = slice(0, MAX_STATES_COMPARED)
    place = LocalFrame(
        float(trajectory.latitude[0]), float(trajectory.longitude[0]), float(trajectory.height[0])
    ).to_local(
        trajectory.latitude[compared], trajectory.longitude[compared], trajectory.height[compared]
    )
    velocity_of_positions = np.diff(place, axis=0) / np.diff(trajectory.time[compared])[:, None]

    def local(key: str, part: slice) -> Array:
        turned = velocity_in_axes(key, velocity[part], wander[part])
        return turned * [1.0, -1.0, 1.0]  # north, west, up

    def residual(key: str) -> float:
        own = local(key, compared)
        return float(np.abs(0.5 * (own[1:] + own[:-1]) - velocity_of_positions).sum())

    best = min(keys, key=residual) if len(keys) > 1 else keys[0]
    return replace(trajectory, velocity=local(best, slice(None)))


def _require_on_earth(
    path: Path,
    latitude: NDArray[np.float64],
    longitude: NDArray[np.float64],
    chosen: SbetOptions,
) -> None:
    # The bounds allow for rounding of the last digit.
    limit, around = np.pi / 2 + 1e-9, 2 * np.pi + 1e-9
    if np.abs(latitude).max() <= limit and np.abs(longitude).max() <= around:
        return
    largest = max(np.abs(latitude).max(), np.abs(longitude).max())
    first = int(np.argmax((np.abs(latitude) > limit) | (np.abs(longitude) > around))) + 1
    if chosen.unit == "degrees":
        code, largest = "sbet.not_degrees", np.degrees(largest)
    elif np.abs(longitude).max() <= limit and np.abs(latitude).max() <= np.pi:
        code = "sbet.exchanged_position"
    elif 1e-300 < largest <= 360:
        code = "sbet.in_degrees"
    else:
        code = "sbet.not_radians"
    raise InputError(error(code, file=str(path), record=first, largest=float(largest)))


def write_sbet(path: Path, trajectory: Trajectory) -> None:
    """Write an SBET with wander 0 and zero accelerations.

    Velocities (along the axes of the wander frame: north, west, up) and angular rates are zero if
    the trajectory does not contain them.
    """
    records = np.zeros((len(trajectory.time), 17), dtype="<f8")
    records[:, 0] = trajectory.time
    records[:, 1] = trajectory.latitude
    records[:, 2] = trajectory.longitude_within_half_turn
    records[:, 3] = trajectory.height
    bow_up = np.array([1.0, -1.0, 1.0])
    records[:, 7:10] = trajectory.attitude * bow_up
    if trajectory.velocity is not None:
        records[:, 4:7] = trajectory.velocity
    if trajectory.attitude_rate is not None:
        records[:, 14:17] = body_rates(records[:, 7:10], trajectory.attitude_rate * bow_up)
    with atomic_write(path) as temporary:
        temporary.write_bytes(records.data)  # tofile hides the error of the system


def read_smrmsg(path: Path) -> TrajectoryAccuracy:
    """Read smrmsg with 10 float64 per record; attitude sigmas are in arc minutes.

    Raises
    ------
    InputError
        If the file is missing, cut short, contains NaN, negative sigmas or disordered times.
    """
    path = Path(path)
    require_file(path, "smrmsg")
    size = path.stat().st_size // SMRMSG_RECORD_BYTES
    head = np.fromfile(path, "<f8", count=10 * min(size, 1000)).reshape(-1, 10)
    if not is_smrmsg(head) and is_smrmsg(head.byteswap()):
        raise InputError(error("sbet.big_endian_accuracy", file=str(path)))
    records = read_records(path, 10, "smrmsg")
    # Times continue through midnight or the end of the week as in the trajectory.
    time, _ = unroll_times(records[:, 0])
    require_increasing(time, path, "smrmsg")
    position, attitude = records[:, 1:4], np.radians(records[:, 7:10] / 60)
    if (position < 0).any() or (attitude < 0).any():
        raise InputError(error("sbet.negative_accuracy", file=str(path)))
    return TrajectoryAccuracy(time, position, attitude)


def is_smrmsg(head: NDArray[np.float64]) -> bool:
    """True if ``head``, records of shape (n, 10), may contain times and accuracies."""
    if not len(head) or not np.isfinite(head).all() or not plausible_bases(head[:, 0]):
        return False
    sound = (head[:, 1:] >= 0).all() and head[:, 1:].max() < 1e4 and head[:, 1:].max() > 1e-9
    return bool(sound and (np.diff(head[:, 0]) > 0).all())


def write_smrmsg(path: Path, accuracy: TrajectoryAccuracy) -> None:
    """Write smrmsg with zero velocity accuracies."""
    records = np.zeros((len(accuracy.time), 10), dtype="<f8")
    records[:, 0] = accuracy.time
    records[:, 1:4] = accuracy.position
    records[:, 7:10] = np.degrees(accuracy.attitude) * 60
    with atomic_write(path) as temporary:
        temporary.write_bytes(records.data)  # tofile hides the error of the system
