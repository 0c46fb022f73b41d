"""Detection of velocity frame, heading reference and signs of an SBET from its motion.

The frame of the velocities is detected by comparison with the positions; it also shows whether the
heading is measured from the wander azimuth. The signs of roll and pitch are detected from the
angular rates, if there are any. Roll in turns and the relation of pitch to vertical velocity are
not used: a vessel may heel to either side in a turn, and pitch and heave differ in phase by a
quarter of a wave.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.io.trajectory.sbet import VELOCITY_AXES, SbetOptions, velocity_in_axes
from lispac.io.trajectory.trajectory_columns import SIGN_NAMES
from lispac.io.trajectory.trajectory_facts import (
    MIN_SPEED_FOR_COURSE,
    MIN_TIME_STEP_S,
    TrajectoryMotion,
    wrap_angle,
)
from lispac.messages import Action, Message, note, warning

Array = NDArray[np.float64]

MAX_VELOCITY_RESIDUAL, MIN_RESIDUAL_RATIO = 0.02, 3.0
"""Largest residual of the velocities relative to the speed, and smallest ratio of the residual of
the second-best frame to that of the best."""

MIN_WANDER_RAD = 1e-4
"""Smallest wander angle that has an effect, radians."""


def detect_velocity_frame(
    blocks: Sequence[Array],
    motions: Sequence[tuple[TrajectoryMotion, TrajectoryMotion]],
    options: SbetOptions,
    file: str,
) -> tuple[SbetOptions, Message, list[Message]]:
    """Detect the frame of the velocities by comparison with the motion of the positions.

    Returns
    -------
    SbetOptions
    Message
        Fact about the velocities for the preview.
    list of Message
        Warnings.
    """
    velocity, wander, own, exchanged = _moving_states(blocks, motions)
    largest_wander = float(np.abs(np.concatenate([block[:, 10] for block in blocks])).max())
    has_wander = largest_wander >= MIN_WANDER_RAD
    unchecked = [warning("sbet.wander_assumed", file=file)] if has_wander else []
    if not any(np.any(block[:, 4:7]) for block in blocks):
        zero = warning("sbet.zero_velocities", file=file)
        return options, note("fact.velocities_zero"), [zero, *unchecked]
    if len(velocity) < 20:
        slow = warning("sbet.too_slow", file=file)
        return options, note("fact.velocities_not_checked"), [slow, *unchecked]
    residuals = {
        key: _velocity_residual(velocity_in_axes(key, velocity, wander), own)
        for key in VELOCITY_AXES
    }
    exchanged_residual = min(
        _velocity_residual(velocity_in_axes(key, velocity, wander), exchanged) for key in residuals
    )
    best = min(residuals, key=lambda key: residuals[key])
    if residuals[best] > MAX_VELOCITY_RESIDUAL:
        if exchanged_residual <= MAX_VELOCITY_RESIDUAL and options.order == "latitude-longitude":
            chosen = replace(options, order="longitude-latitude")
            again = [(other, first) for first, other in motions]
            chosen, fact, found = detect_velocity_frame(blocks, again, chosen, file)
            order = warning("sbet.longitude_first_by_velocity", file=file)
            return chosen, fact, [order, *found]
        disagree = warning(
            "sbet.velocities_disagree", file=file, axes=VELOCITY_AXES[best], share=residuals[best],
        )  # fmt: skip
        return options, note("fact.velocities_in_no_frame"), [disagree, *unchecked]
    share = residuals[best]
    fact = note("fact.velocity_axes", axes=VELOCITY_AXES[best], share=share)
    chosen = replace(options, axes=best)
    limit = max(MIN_RESIDUAL_RATIO * residuals[best], residuals[best] + 0.003)
    rivals = [key for key in residuals if key != best and residuals[key] < limit]
    if not rivals and largest_wander >= MIN_WANDER_RAD:
        return _detect_heading(chosen, blocks, motions, largest_wander, fact, file)
    if largest_wander < MIN_WANDER_RAD:
        # Without a wander angle, its frames are identical to those relative to north.
        plain = [key for key in (best, *rivals) if not key.startswith("wander")]
        chosen = replace(chosen, axes=plain[0])
        fact = note("fact.velocity_axes", axes=VELOCITY_AXES[plain[0]], share=share)
        rivals = plain[1:]
        if not rivals:
            return chosen, fact, []
    others = tuple(VELOCITY_AXES[key] for key in rivals)
    several = warning("sbet.several_axes", file=file, axes=others)
    return chosen, fact, [several, *unchecked]


def _detect_heading(
    chosen: SbetOptions,
    blocks: Sequence[Array],
    motions: Sequence[tuple[TrajectoryMotion, TrajectoryMotion]],
    largest_wander: float,
    fact: Message,
    file: str,
) -> tuple[SbetOptions, Message, list[Message]]:
    """Detect the heading reference with an unambiguous velocity frame and a wander angle."""
    if chosen.axes.startswith("wander"):
        return replace(chosen, heading="minus-wander"), fact, []
    offsets = []
    for kept in (1.0, 0.0):
        found = [
            wrap_angle(own.course - block[own.index, 9] + kept * block[own.index, 10])[
                own.speed > MIN_SPEED_FOR_COURSE
            ]
            for block, (own, _) in zip(blocks, motions, strict=True)
        ]
        offsets.append(abs(float(np.median(np.concatenate(found)))))
    offset_less_wander, offset_as_is = offsets
    # A vessel's drift angle rarely exceeds 15 deg; smaller wander angles cannot be separated.
    used, other = min(offsets), max(offsets)
    if largest_wander > np.radians(30) and used < np.radians(15) < other:
        if offset_less_wander < offset_as_is:
            resolved = warning("sbet.heading_less_wander", file=file, used=used, other=other)
            return replace(chosen, heading="minus-wander"), fact, [resolved]
        resolved = warning("sbet.heading_as_is", file=file, used=used, other=other)
        return replace(chosen, heading="as-is"), fact, [resolved]
    return chosen, fact, [warning("sbet.heading_uncertain", file=file, wander=largest_wander)]


def _moving_states(
    blocks: Sequence[Array], motions: Sequence[tuple[TrajectoryMotion, TrajectoryMotion]]
) -> tuple[Array, Array, Array, Array]:
    """Velocities, wander, and velocities from positions (as read, exchanged) of moving states."""
    rows: list[tuple[Array, Array, Array, Array]] = []
    for block, (own, exchanged) in zip(blocks, motions, strict=True):
        common, first, second = np.intersect1d(own.index, exchanged.index, return_indices=True)
        fast = np.hypot(block[common, 4], block[common, 5]) > MIN_SPEED_FOR_COURSE
        rows.append(
            (
                block[common, 4:7][fast],
                block[common, 10][fast],
                _velocity_columns(own, first[fast]),
                _velocity_columns(exchanged, second[fast]),
            )
        )
    velocity, wander, own_all, exchanged_all = (
        np.concatenate([row[k] for row in rows]) for k in range(4)
    )
    return velocity, wander, own_all, exchanged_all


def _velocity_columns(motion: TrajectoryMotion, rows: NDArray[np.int64]) -> Array:
    return np.stack([motion.north[rows], motion.east[rows], motion.up[rows]], axis=1)


def _velocity_residual(velocity: Array, truth: Array) -> float:
    """Median difference of the velocities from those of the positions, relative to the speed.

    The speed is horizontal. Small vertical motion has little effect, because the three components
    of the difference are combined in one length.
    """
    speed = float(np.median(np.hypot(velocity[:, 0], velocity[:, 1])))
    return float(np.median(np.linalg.norm(velocity - truth, axis=1))) / max(speed, 1e-9)


def detect_signs(
    blocks: Sequence[Array], options: SbetOptions, file: str
) -> tuple[SbetOptions, Message, list[Message]]:
    """Detect the signs of roll and pitch from the angular rates of the body.

    A positive rate about the forward axis lowers the starboard side, whether y points to starboard
    or to port. A positive rate about y raises the bow in the first case and lowers it in the
    second. The rate about z, compared with the heading, distinguishes the two cases.
    """
    check = (Action("check_sign", {"name": "pitch"}),)
    if not any(np.any(block[:, 14:17]) for block in blocks):
        zero = warning("sbet.zero_rates", file=file, actions=check)
        return options, note("fact.signs_not_checked"), [zero]
    roll, pitch, heading = (_rate_correlation(blocks, 7 + k, 14 + k) for k in range(3))
    signs, file_warnings = [], []
    if roll is not None:
        options = replace(options, roll="starboard-down" if roll > 0 else "port-down")

        signs.append(SIGN_NAMES[options.roll])
    if pitch is not None and heading is not None:
        options = replace(options, pitch="bow-up" if pitch * heading > 0 else "bow-down")

        signs.append(SIGN_NAMES[options.pitch])
    if len(signs) < 2:
        unknown = []
        if roll is None:
            unknown.append(note("quantity.roll"))
        if pitch is None or heading is None:
            unknown.append(note("quantity.pitch"))
        file_warnings.append(
            warning("sbet.signs_not_checked", file=file, angles=tuple(unknown), actions=check)
        )
    if signs and (options.roll == "port-down" or options.pitch == "bow-down"):
        file_warnings.append(warning("sbet.other_signs", file=file, signs=signs, actions=check))
    fact = note("fact.signs", signs=signs) if signs else note("fact.signs_not_checked")
    return options, fact, file_warnings


def _rate_correlation(blocks: Sequence[Array], angle: int, rate: int) -> float | None:
    """Correlation of changes of an angle with its integrated rate; None if undetermined.

    Changes over half a second of at least a tenth of a degree are used; smaller ones are noise and
    vibration.
    """
    changes, rate_integrals = [], []
    for block in blocks:
        time = block[:, 0]
        steps = np.diff(time)
        if len(time) < 3 or (steps < MIN_TIME_STEP_S).any() or (steps > 1).any():
            continue
        lag = max(1, round(0.5 / float(np.median(steps))))
        values = np.unwrap(block[:, angle])
        integrated_rate = np.concatenate(
            [[0.0], np.cumsum((block[1:, rate] + block[:-1, rate]) / 2 * steps)]
        )
        changes.append((values[lag:] - values[:-lag])[::lag])
        rate_integrals.append((integrated_rate[lag:] - integrated_rate[:-lag])[::lag])
    if not changes:
        return None
    change, turn = np.concatenate(changes), np.concatenate(rate_integrals)
    if len(change) < 10:
        return None
    # Correlation about zero instead of the mean, so that a steady turn also gives the sign.
    size = float(np.sqrt(np.mean(change**2)))
    length = float(np.linalg.norm(change) * np.linalg.norm(turn))
    if size < np.radians(0.1) or length == 0:
        return None
    agreement = float(change @ turn) / length
    return agreement if abs(agreement) > 0.9 else None
