"""Control chart of a system: its calibrations over time, angle by angle."""

from collections.abc import Mapping, Sequence
from operator import attrgetter

import numpy as np
from matplotlib.dates import AutoDateLocator, ConciseDateFormatter, date2num
from matplotlib.figure import Figure

from lispac.adjustment.result import ANGLES
from lispac.language import N_, gettext
from lispac.present.calibration.calibrations import DatedCalibration
from lispac.report.figures import (
    INK_COLOUR,
    MAIN_COLOUR,
    OTHER_COLOUR,
    SMALL_TEXT_SIZE,
    TEXT_SIZE,
    blank_figure,
    short_name,
    style_axes,
)
from lispac.validation.repeatability import NORMAL_QUANTILE_975

AXIS_LABELS: Mapping[str, str] = {
    "roll": N_("Roll (°)"), "pitch": N_("Pitch (°)"), "yaw": N_("Yaw (°)")
}  # fmt: skip
LIMITS_COLOUR = "#dbe4ee"
"""Colour of the band between the control limits of a calibration."""
BAND_HALF_WIDTH = 0.35
"""Width of this band to either side, as a share of the time to the neighbouring calibration."""
DATE_FORMATS = ["%Y", "%Y-%m", "%Y-%m-%d", "%m-%d %H:%M", "%H:%M", "%S.%f"]
"""Formats of the dates at the axis, for steps from years to seconds, the same in all languages."""


def control_chart_figure(
    calibrations: Sequence[DatedCalibration], figure: Figure | None = None
) -> Figure:
    """Control chart of each angle, with 95 % intervals and the limits from earlier calibrations.

    Parameters
    ----------
    calibrations : the earliest first, with the earlier ones they are compared with
    """
    figure = blank_figure(figure, (6.3, 4.6))
    panels = figure.subplots(3, 1, sharex=True)
    # Calibrations of the same day are drawn side by side.
    days = [each.day for each in calibrations]
    at = np.array(date2num(days), dtype=np.float64)  # type: ignore[no-untyped-call]
    for k in range(1, len(at)):
        at[k] = max(at[k], at[k - 1] + 0.03 * max(at[-1] - at[0], 1.0))
    # Margin at both ends: the mean interval between two calibrations, at least three days.
    between = max(3.0, (at[-1] - at[0]) / max(len(at) - 1, 1))
    spacing = np.diff(at, prepend=at[0] - between, append=at[-1] + between)
    has_moved = np.array([each.moved for each in calibrations])
    for axes, angle in zip(panels, ANGLES, strict=True):
        of_angle = attrgetter(angle)
        for j, each in enumerate(calibrations):
            if each.lower_limit_deg is not None and each.upper_limit_deg is not None:
                low, high = of_angle(each.lower_limit_deg), of_angle(each.upper_limit_deg)
                sides = (
                    at[j] - BAND_HALF_WIDTH * spacing[j],
                    at[j] + BAND_HALF_WIDTH * spacing[j + 1],
                )
                axes.fill_between(sides, low, high, color=LIMITS_COLOUR, linewidth=0)
                axes.hlines((low + high) / 2.0, *sides, color=MAIN_COLOUR, lw=1.0)
        values = np.array([of_angle(each.boresight_deg) for each in calibrations])
        half_widths = NORMAL_QUANTILE_975 * np.array(
            [of_angle(each.sigma_deg) for each in calibrations]
        )
        for own, colour in ((~has_moved, INK_COLOUR), (has_moved, OTHER_COLOUR)):
            axes.errorbar(
                at[own], values[own], yerr=half_widths[own], fmt="o", markersize=4, color=colour,
                elinewidth=1.0, capsize=2.5,
            )  # fmt: skip
        style_axes(axes, "", gettext(AXIS_LABELS[angle]))
    for x, each in zip(at, calibrations, strict=True):
        panels[0].annotate(
            short_name(each.name), (x, 1.0), xycoords=("data", "axes fraction"),
            xytext=(0, 3), textcoords="offset points", fontsize=SMALL_TEXT_SIZE,
            color=INK_COLOUR, rotation=25, ha="left", va="bottom",
        )  # fmt: skip
    panels[-1].set_xlim(at[0] - BAND_HALF_WIDTH * between, at[-1] + BAND_HALF_WIDTH * between)
    locator = AutoDateLocator(minticks=2)  # type: ignore[no-untyped-call]
    panels[-1].xaxis.set_major_locator(locator)
    formatter = ConciseDateFormatter(  # type: ignore[no-untyped-call]
        locator, formats=DATE_FORMATS, zero_formats=DATE_FORMATS, show_offset=False
    )
    panels[-1].xaxis.set_major_formatter(formatter)
    figure.supxlabel(
        gettext(
            "Dot and bar: one calibration with its 95 % interval (brown: the mounting has moved). "
            "Line and band:\nmean of the earlier calibrations and three sigmas of the difference "
            "from it."
        ),
        fontsize=TEXT_SIZE, color=INK_COLOUR,
    )  # fmt: skip
    return figure
