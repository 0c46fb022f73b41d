"""Colours of the points: by line, or by a value of each point.

Module `lispac.gui.project.residuals` computes the colours of residuals at the points of targets.
"""

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from lispac.gui.appearance import units
from lispac.gui.viewport.base import Array, PointColouring
from lispac.language import N_, gettext
from lispac.survey.cloud import Cloud, Line, Numbers

Colouring = Literal["line", "height", "intensity", "range", "time", "residual"]
COLOURINGS: tuple[Colouring, ...] = get_args(Colouring)

Scale = Literal["viridis", "cividis", "gray", "turbo"]
COLOUR_SCALES: Mapping[Scale, tuple[float, float]] = MappingProxyType(
    {"viridis": (0.0, 0.94), "cividis": (0.0, 0.94), "gray": (0.30, 0.74), "turbo": (0.03, 0.97)}
)
"""Colour scales of measured values, and the range that is used of each, between 0 and 1.

The first scale varies uniformly in lightness, so that it can be read with any colour vision. The
ends of the scales are omitted where they have too little contrast with a light or dark background.
"""
END_COLOUR_PERCENT = 2.0
"""Percent of the points beyond each end of the scale, so that outliers have no effect on it; 0 for
times."""
MAX_SAMPLE_POINTS = 100_000
"""Largest number of points of each line that are used to determine the ends of the scale."""

LEGEND_TITLES: dict[Colouring, str] = {
    "height": N_("Height (m)"),
    "intensity": N_("Intensity"),
    "range": N_("Range (m)"),
    "time": N_("Time since the start of the first line (s)"),
}


_colour_scale: Scale = "viridis"


def set_colour_scale(scale: Scale) -> None:
    """Set the colour scale for the next window that is created."""
    global _colour_scale
    _colour_scale = scale


def point_shading(colouring: Colouring, clouds: Mapping[str, Cloud]) -> PointColouring | None:
    """Colours of the displayed points by a value; None if each line has its own colour.

    Raises
    ------
    ValueError
        If a line lacks the values; the text is in the language of the window.
    """
    if colouring == "line" or not clouds:
        return None
    values = {name: _point_values(colouring, name, cloud) for name, cloud in clouds.items()}
    sample = np.concatenate(
        [each[:: len(each) // MAX_SAMPLE_POINTS + 1] for each in values.values()]
    )
    outer = 0.0 if colouring == "time" else END_COLOUR_PERCENT
    low, high = (float(end) for end in np.percentile(sample, [outer, 100 - outer]))
    start = low if colouring == "time" else 0.0
    decimals = 0 if high - low >= 20 else 1 if high - low >= 2 else 2
    form, is_length = f",.{decimals}f", colouring in ("height", "range")
    metric = (
        units.localised(f"{low - start:{form}}"), units.localised(f"{high - start:{form}}")
    )  # fmt: skip
    shown = (
        (units.local_figure(low, "m", form), units.local_figure(high, "m", form))
        if is_length
        else metric
    )
    shading = PointColouring(
        {}, gettext(LEGEND_TITLES[colouring]), *shown, _colour_table(), metric, (low, high)
    )
    return replace(shading, colours={n: shading.of_values(each) for n, each in values.items()})


def sighting_shades(
    colouring: Colouring, shading: PointColouring, line: Line, points: Array, numbers: Numbers
) -> NDArray[np.uint8] | None:
    """Colours (n, 3) of points of a line, in the scale of the lines; None without values.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        The points as displayed.
    numbers : ndarray of shape (n,)
        Numbers of the points in their line.
    """
    values: Array | None
    if colouring == "height":
        values = points[:, 2]
    elif colouring == "intensity":
        values = line.intensities(numbers)
    else:
        points_lidar, time = line.take(numbers)
        values = time if colouring == "time" else np.linalg.norm(points_lidar, axis=1)
    return None if values is None else shading.of_values(values)


def _point_values(colouring: Colouring, name: str, cloud: Cloud) -> Array:
    if colouring == "height":
        return cloud.sample[:, 2]
    if colouring == "range":
        return cloud.sample_range
    if colouring == "time":
        return cloud.sample_time
    intensity = cloud.sample_intensity
    if intensity is None:
        raise ValueError(gettext("{line} has no intensities. Choose another colouring.", line=name))
    return intensity


def _colour_table() -> NDArray[np.uint8]:
    from matplotlib import colormaps

    shares = np.linspace(*COLOUR_SCALES[_colour_scale], 256)
    return np.asarray(np.round(255 * colormaps[_colour_scale](shares)[:, :3]), dtype=np.uint8)
