"""Distances between lines as a function of height and range, before and after the calibration."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullLocator

from lispac.language import N_, gettext
from lispac.present.checking.distance_bins import DistancesBySteps
from lispac.present.checking.validation import ValidationPlane
from lispac.report.figures import (
    AFTER_COLOUR,
    BEFORE_COLOUR,
    INK_COLOUR,
    SMALL_TEXT_SIZE,
    TEXT_SIZE,
    LocalisedFormatter,
    blank_figure,
    is_wide,
    short_name,
    style_axes,
)
from lispac.validation.comparison_results import PlaneComparison

CURVE_LABELS: Mapping[tuple[str, str], str] = {
    ("median", "before"): N_("median before"),
    ("p95", "before"): N_("95 % before"),
    ("median", "after"): N_("median after"),
    ("p95", "after"): N_("95 % after"),
}
"""Texts of the legend, by statistic and state."""
MIN_PROFILE_SPAN_M = 0.25
"""Smallest range of heights, or of ranges, for which a profile is drawn: less than the smallest
boards and more than the deviations of a horizontal surface."""
STATE_COLOURS = {"before": BEFORE_COLOUR, "after": AFTER_COLOUR}
LINE_STYLES = {"median": "-", "p95": "--"}


def profile_figure(comparison: PlaneComparison, figure: Figure | None = None) -> Figure:
    """Median (solid) and 95th percentile (dashed) of the distances, by height and by range.

    The scale is logarithmic, since the distances before may be 100 times larger than those after.
    """
    profiles = [
        None if each is None else DistancesBySteps.of(each)
        for each in (comparison.by_height, comparison.by_range)
    ]
    if any(map(is_drawn, profiles)):
        profiles = [each if is_drawn(each) else None for each in profiles]
    return _draw_profiles(figure, comparison.name, profiles)


def profile_figure_of(plane: ValidationPlane) -> Figure:
    """Draw `profile_figure` from the values of a report, whose caption has the name."""
    profiles = (plane.by_height, plane.by_range)
    return _draw_profiles(None, "", [each if is_drawn(each) else None for each in profiles])


def is_drawn(profile: DistancesBySteps | None) -> bool:
    """Whether a profile is known and spans at least `MIN_PROFILE_SPAN_M`."""
    return profile is not None and profile.edges_m[-1] - profile.edges_m[0] >= MIN_PROFILE_SPAN_M


def _draw_profiles(
    figure: Figure | None, name: str, profiles: Sequence[DistancesBySteps | None]
) -> Figure:
    figure = blank_figure(figure, (6.3, 1.9))
    drawn = [
        (each, across)
        for each, across in zip(
            profiles, (gettext("Height (m)"), gettext("Range (m)")), strict=True
        )
        if each is not None
    ]
    places = figure.subplots(1, max(len(drawn), 1), sharey=True, squeeze=False)[0]
    for axes, (profile, across) in zip(places, drawn, strict=False):
        _draw_profile(axes, profile)
        style_axes(axes, across, gettext("Distance (mm, log)") if axes is places[0] else "")
        axes.set_yscale("log")
        axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axes.yaxis.set_minor_locator(NullLocator())
        axes.yaxis.set_major_formatter(LocalisedFormatter())
    if drawn:
        figure.legend(
            *places[0].get_legend_handles_labels(), loc="outside upper right",
            ncols=4 if is_wide(figure) else 2, fontsize=SMALL_TEXT_SIZE, frameon=False,
            labelcolor=INK_COLOUR,
        )  # fmt: skip
    else:
        places[0].set_axis_off()
        places[0].text(
            0.5, 0.5,
            gettext("This result is from an earlier version. Run the validation again."),
            ha="center", va="center", fontsize=TEXT_SIZE, color=INK_COLOUR,
            transform=places[0].transAxes,
        )  # fmt: skip
    figure.suptitle(short_name(name), x=0.01, ha="left", fontsize=TEXT_SIZE + 1, color=INK_COLOUR)
    return figure


def _draw_profile(axes: Axes, profile: DistancesBySteps) -> None:
    edges = np.array(profile.edges_m)
    middles = 0.5 * (edges[:-1] + edges[1:])
    for (statistic, state), label in CURVE_LABELS.items():
        values = np.array(getattr(profile, f"{statistic}_{state}_m"), dtype=float)
        axes.plot(
            middles, 1000 * values, LINE_STYLES[statistic], color=STATE_COLOURS[state],
            linewidth=1.2, marker="o", markersize=2.5, label=gettext(label),
        )  # fmt: skip
