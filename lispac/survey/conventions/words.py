"""A boresight and a lever arm in a sentence."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.rotations import rotation_matrix
from lispac.survey.conventions.axes import axes_matrix, in_words, nearest_axes
from lispac.survey.georeferencing import Mounting, is_steep

Array = NDArray[np.float64]
Figures = Callable[[float, float, float], Sequence[str]]

CHECK_FIRST = (
    "These angles are right if the assumption above is: prove it on one line over a known "
    "surface before use."
)
THESIS_MODE = "The POS errors were taken as uncorrelated: these sigmas are several times too small."
LARGE_DEG = 10.0
"""From here on the order of the turns shows, and is said."""


def boresight_words(boresight: Array, figures: Figures | None = None) -> str:
    """Where the scanner looks, as a sentence; by its axes where the pitch is steep.

    Parameters
    ----------
    boresight : ndarray of shape (3,), radians; roll, pitch, yaw of this program
    figures : writes the sizes of three angles in degrees; empty where one is zero
    """
    if is_steep(boresight):
        return _axes_words(rotation_matrix(*boresight), figures or _amounts)
    roll, pitch, yaw = np.degrees(boresight)
    leans, looks, turned = (figures or _amounts)(roll, pitch, yaw)
    parts = []
    if looks:
        parts.append(f"looks {looks} deg bow {'down' if pitch > 0 else 'up'}")
    if turned:
        parts.append(f"is turned {turned} deg to {'starboard' if yaw > 0 else 'port'}")
    if leans:
        side = "left" if roll > 0 else "right"
        parts.append(f"leans {leans} deg with its {side} side up")
    if not parts:
        return "The scanner is parallel to the body."
    sentence = f"The scanner {_listed(parts)}"
    if len(parts) > 1 and np.abs([roll, pitch, yaw]).max() > LARGE_DEG:
        # The body's axes are carried onto the scanner's by yaw, then pitch, then roll.
        sentence += " (first turned, then pitched, then rolled)"
    return sentence + "."


def _axes_words(rotation: Array, figures: Figures) -> str:
    """Where the axes of the scanner point, to the nearest direction of the vessel.

    Parameters
    ----------
    rotation : ndarray of shape (3, 3)
        From the LiDAR to the body frame.
    """
    axes = nearest_axes(rotation)
    cosines = np.einsum("ij,ij->i", axes_matrix(axes), rotation.T)
    off = float(np.degrees(np.arccos(np.clip(cosines.min(), -1.0, 1.0))))
    apart = figures(off, 0.0, 0.0)[0]
    said = f"The scanner's axes point: {in_words(axes)}"
    return f"{said}, off by {apart} deg at most." if apart else f"{said}."


def lever_arm_words(lever_arm: Sequence[float] | Array, figures: Figures | None = None) -> str:
    """Where the optical centre is, as a sentence.

    Parameters
    ----------
    lever_arm : three numbers, metres, body (forward, left, up)
    figures : writes the sizes of three lengths in metres; empty where one is zero
    """
    forward, left, up = (float(value) for value in lever_arm)
    parts = []
    for value, amount, (ahead, behind) in zip(
        (forward, left, up),
        (figures or _amounts)(forward, left, up),
        (("forward of", "aft of"), ("to port of", "to starboard of"), ("above", "below")),
        strict=True,
    ):
        if amount:
            parts.append(f"{amount} m {ahead if value > 0 else behind}")
    if not parts:
        return "The scanner's optical centre is at the POS centre."
    return f"The scanner's optical centre is {_listed(parts)} the POS centre."


def offsets_words(mounting: Mounting) -> str:
    """What else the other program has to apply for the boresight to hold; may be empty."""
    offsets = (
        ("range offset", mounting.range_offset, 1.0, "m"),
        ("scan-angle offset", mounting.scan_angle_offset, float(np.degrees(1.0)), "deg"),
        ("latency", mounting.latency, 1000.0, "ms"),
    )
    parts = [
        f"{name} {value * scale:+.4f} {unit}"
        for name, value, scale, unit in offsets
        if round(value * scale, 4)
    ]
    if not parts:
        return ""
    return f"The boresight holds together with {_listed(parts)}: apply that there too."


def _amounts(*values: float) -> list[str]:
    """The sizes with three decimals, four where one is small; empty where it is zero.

    Zeros at the end go where they are nothing but that in every one of them: beside 1.178 it is
    0.300, for 0.3 would seem less certain.
    """
    texts = [f"{abs(v):.4f}" if abs(v) < 0.1 else f"{abs(v):.3f}" for v in values]
    decimals = [len(text.rstrip("0").partition(".")[2]) for text in texts]
    most = min(max(decimals), 3)
    return [
        "" if not float(text) else f"{float(text):.{max(own, most)}f}"
        for text, own in zip(texts, decimals, strict=True)
    ]


def _listed(parts: Sequence[str]) -> str:
    return parts[0] if len(parts) == 1 else f"{', '.join(parts[:-1])} and {parts[-1]}"
