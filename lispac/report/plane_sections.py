"""Sections across validation planes: the points of all lines, before and after the calibration."""

import numpy as np
from matplotlib.figure import Figure

from lispac.language import gettext
from lispac.present.targets.surface_geometry import PlaneSection
from lispac.report.figures import (
    INK_COLOUR,
    SMALL_TEXT_SIZE,
    blank_figure,
    line_colour,
    short_name,
    style_axes,
)

SIZE_INCHES = 6.3, 1.5
POINT_SIZE, LEGEND_SCALE = 2.0, 5.0
"""Size of a point, and that of the points in the legend relative to it."""
SHOWN_PERCENTILES = 0.5, 99.5
"""Percentiles of the distances between which a panel extends, besides its margins."""


def section_figure_of(section: PlaneSection) -> Figure:
    """Draw the points of a section before and after, each with its own scale."""
    figure = blank_figure(None, SIZE_INCHES)
    panels = figure.subplots(1, 2)
    for axes, state in zip(panels, ("before", "after"), strict=True):
        title = gettext("before") if state == "before" else gettext("after")
        style_axes(
            axes,
            gettext(section.axis_title),
            gettext("Distance (mm)") if axes is panels[0] else "",
        )
        axes.set_title(title, fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR)
        distances = []
        for line in section.lines:
            points = np.array(getattr(line, f"{state}_m"), dtype=float).reshape(-1, 2)
            axes.plot(
                points[:, 0], 1000.0 * points[:, 1], ".", color=line_colour(line.place),
                markersize=POINT_SIZE, markeredgewidth=0.0,
            )  # fmt: skip
            distances.append(1000.0 * points[:, 1])
        shown = np.concatenate(distances)
        if len(shown):
            low, high = np.percentile(shown, SHOWN_PERCENTILES)
            margin = 0.1 * (high - low) + 1.0
            axes.set_ylim(low - margin, high + margin)
    figure.legend(
        list(panels[0].lines), [short_name(line.line) for line in section.lines],
        loc="outside right center", fontsize=SMALL_TEXT_SIZE, frameon=False, labelcolor=INK_COLOUR,
        markerscale=LEGEND_SCALE,
    )  # fmt: skip
    return figure
