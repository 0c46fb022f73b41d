"""Orientation and position of a scanner as texts."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.rotations import rotation_matrix
from lispac.language import N_, LazyText, gettext_lazy
from lispac.messages import Message, note, warning
from lispac.survey.conventions.axes import axes_matrix, axes_text, nearest_axes
from lispac.survey.georeferencing import Mounting, is_steep

Array = NDArray[np.float64]
Amounts = Callable[[Sequence[float]], Sequence[LazyText | str]]
"""Function from angles (radians) or lengths (metres) to texts of their absolute values with units.
The text of a value that rounds to zero is empty."""

CHECK_FIRST_NOTE = note("convention.check_first")
UNCORRELATED_WARNING = warning("convention.uncorrelated")
_DEGREES_TEXTS = {3: N_("{value:deg.3}°"), 4: N_("{value:deg.4}°")}
_METRES_TEXTS = {3: N_("{value:m.3} m"), 4: N_("{value:m.4} m")}
"""Texts of an angle or a length by the number of decimals."""
LARGE_ANGLE_RAD = np.radians(10.0)
"""Angle above which the text gives the order of the rotations."""


def angle_amounts(values: Sequence[float]) -> list[LazyText | str]:
    """Texts of absolute angles (radians) in degrees; see `common_decimals` for their decimals."""
    return _formatted_amounts(values, float(np.degrees(1.0)), _DEGREES_TEXTS)


def length_amounts(values: Sequence[float]) -> list[LazyText | str]:
    """Texts of absolute lengths in metres; see `common_decimals` for their decimals."""
    return _formatted_amounts(values, 1.0, _METRES_TEXTS)


def orientation_text(boresight: Array, amounts: Amounts = angle_amounts) -> LazyText:
    """Orientation of the scanner by roll, pitch and yaw, or by its axes if the pitch is steep.

    Parameters
    ----------
    boresight : ndarray of shape (3,), radians; roll, pitch, yaw of this program
    """
    if is_steep(boresight):
        return _axis_directions_text(rotation_matrix(*boresight), amounts)
    roll, pitch, yaw = (float(value) for value in boresight)
    rolled, pitched, yawed = amounts((roll, pitch, yaw))
    parts = []
    if pitched:
        template = (
            N_("is pitched {angle} bow down") if pitch > 0 else N_("is pitched {angle} bow up")
        )
        parts.append(gettext_lazy(template, angle=pitched))
    if yawed:
        template = (
            N_("is yawed {angle} to starboard") if yaw > 0 else N_("is yawed {angle} to port")
        )
        parts.append(gettext_lazy(template, angle=yawed))
    if rolled:
        template = (
            N_("is rolled {angle} port side up")
            if roll > 0
            else N_("is rolled {angle} starboard side up")
        )
        parts.append(gettext_lazy(template, angle=rolled))
    if not parts:
        return gettext_lazy("The scanner is parallel to the body.")
    if len(parts) > 1 and max(abs(roll), abs(pitch), abs(yaw)) > LARGE_ANGLE_RAD:
        # Rotations by yaw, then pitch, then roll move the body axes to the scanner axes.
        return gettext_lazy(
            "The scanner {parts:names} (order of rotations: yaw, pitch, roll).", parts=parts
        )
    return gettext_lazy("The scanner {parts:names}.", parts=parts)


def _axis_directions_text(rotation: Array, amounts: Amounts) -> LazyText:
    """Directions of the scanner axes, as the nearest directions on the vessel.

    Parameters
    ----------
    rotation : ndarray of shape (3, 3)
        From the LiDAR to the body frame.
    """
    axes = nearest_axes(rotation)
    cosines = np.einsum("ij,ij->i", axes_matrix(axes), rotation.T)
    largest = float(np.arccos(np.clip(cosines.min(), -1.0, 1.0)))
    deviation = amounts((largest, 0.0, 0.0))[0]
    if not deviation:
        return gettext_lazy("Directions of the scanner axes: {axes}.", axes=axes_text(axes))
    return gettext_lazy(
        "Directions of the scanner axes: {axes}, with deviations up to {angle}.",
        axes=axes_text(axes), angle=deviation,
    )  # fmt: skip


def lever_arm_text(
    lever_arm: Sequence[float] | Array, amounts: Amounts = length_amounts
) -> LazyText:
    """Position of the optical centre of the scanner relative to the POS centre.

    Parameters
    ----------
    lever_arm : three numbers, metres, body frame (forward, port, up)
    """
    forward, left, up = (float(value) for value in lever_arm)
    parts = [
        gettext_lazy(ahead if value > 0 else behind, distance=amount)
        for value, amount, (ahead, behind) in zip(
            (forward, left, up), amounts((forward, left, up)), _SIDE_TEXTS, strict=True
        )
        if amount
    ]
    if not parts:
        return gettext_lazy("The scanner's optical centre is at the POS centre.")
    return gettext_lazy(
        "The scanner's optical centre is {parts:names} the POS centre.", parts=parts
    )


_SIDE_TEXTS = (
    (N_("{distance} forward of"), N_("{distance} aft of")),
    (N_("{distance} to port of"), N_("{distance} to starboard of")),
    (N_("{distance} above"), N_("{distance} below")),
)


def offsets_note(mounting: Mounting) -> Message | None:
    """Message on the other corrections that the other program must apply with the boresight."""
    offsets = (
        ("item.range_offset", mounting.range_offset, 1.0),
        ("item.scan_angle_offset", mounting.scan_angle_offset, float(np.degrees(1.0))),
        ("item.latency", mounting.latency, 1000.0),
    )
    parts = tuple(
        note(code, value=float(value)) for code, value, scale in offsets if round(value * scale, 4)
    )
    return note("convention.offsets", offsets=parts) if parts else None


def common_decimals(sizes: Sequence[float]) -> int:
    """Number of decimals of values in one sentence: four if one that is shown is below 0.1."""
    return 4 if any(size < 0.1 for size in sizes if round(size, 4)) else 3


def _formatted_amounts(
    values: Sequence[float], factor: float, templates: Mapping[int, str]
) -> list[LazyText | str]:
    sizes = [abs(value) * factor for value in values]
    decimals = common_decimals(sizes)
    return [
        gettext_lazy(templates[decimals], value=abs(value)) if round(size, 4) else ""
        for value, size in zip(values, sizes, strict=True)
    ]
