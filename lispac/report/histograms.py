"""Histograms of the distances on a validation plane, before and after the calibration."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import StepPatch
from numpy.typing import ArrayLike, NDArray

from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.present.checking.validation import ValidationPlane
from lispac.present.text_format import grouped_number, localised_number
from lispac.report.figures import (
    AFTER_COLOUR,
    BEFORE_COLOUR,
    HEADROOM_RATIO,
    INK_COLOUR,
    SMALL_TEXT_SIZE,
    TEXT_SIZE,
    blank_figure,
    draw_title_and_legend,
    is_wide,
    set_fitting_ticks,
    short_name,
    style_axes,
)
from lispac.validation.comparison_results import PlaneComparison
from lispac.validation.distance_bins import merge_bins

Array = NDArray[np.float64]

MAX_BARS = 60
"""Largest number of bars in a histogram."""
ENLARGED_WIDTH, MAX_ENLARGED_SHARE = 1.6, 0.4
"""Ratio of the range of the enlarged view to the 95th percentile of the distances after the
calibration, and the largest share of the full range for which an enlarged view is drawn."""
STATE_COLOURS = (BEFORE_COLOUR, AFTER_COLOUR)
_FULL_VIEW_LABEL = N_("Distance between lines (mm);\nlast bin includes larger values")
_ENLARGED_VIEW_TITLE = N_("Enlarged view")
_PLANE_TITLES: Mapping[str, str] = {
    "reciprocal pairs": N_("{plane}, reciprocal pairs of lines, {model}"),
    "all pairs": N_("{plane}, all pairs of lines, {model}"),
}
"""Titles, by the pairs of lines whose distances are pooled on a plane."""


@dataclass(frozen=True, eq=False)
class _BinnedDistances:
    """Distances before and after the calibration, counted in fine bins.

    Attributes
    ----------
    edges : edges of the bins, metres
    counts : numbers of distances in the bins, before and after
    legend : text of the legend for each state
    total : number of distances
    near : range of the enlarged view, metres
    """

    edges: ArrayLike
    counts: Sequence[ArrayLike]
    legend: Sequence[str]
    total: int
    near: float


def histogram_figure(
    comparison: PlaneComparison,
    figure: Figure | None = None,
    *,
    share: bool = False,
    titled: bool = True,
) -> Figure:
    """Histogram of the distances between lines on one validation plane, before and after.

    Parameters
    ----------
    share : bool
        Draw the share of the points per millimetre instead of their number in each bin.
    titled : bool
        Draw a title and a legend, for which a low figure has no space.
    """
    before, after = comparison.before, comparison.after
    counted = _BinnedDistances(
        comparison.bin_edges,
        (comparison.counts_before, comparison.counts_after),
        [
            _legend_text(template, each.n, each.median, each.rms, each.p95)
            for template, each in ((_BEFORE_LEGEND, before), (_AFTER_LEGEND, after))
        ],
        before.n,
        ENLARGED_WIDTH * after.p95,
    )
    title = _plane_title(
        comparison.name, comparison.pooled_from, message_text(comparison.model.name)
    )
    return _draw_histogram(figure, title, counted, share, titled)


def validation_figure(plane: ValidationPlane) -> Figure:
    """Draw `histogram_figure` from the values of a report."""
    title = _plane_title(plane.name, plane.pooled_from, message_text(plane.measured_to))
    return _draw_histogram(None, title, _binned_distances(plane), share=False)


def small_histograms_figure_of(planes: Sequence[ValidationPlane], *, is_narrow: bool) -> Figure:
    """Draw a small histogram for each of a few validation planes, side by side.

    Parameters
    ----------
    is_narrow : whether the figure has half the width of the text, or a third for one plane
    """
    # The sizes on paper, so that texts are not reduced
    narrow = (2.05, 1.5) if len(planes) == 1 else (3.2, 2.35)
    figure = blank_figure(None, narrow if is_narrow else (6.3, 1.6))
    places = figure.subplots(1, len(planes), squeeze=False)[0]
    for axes, plane in zip(places, planes, strict=True):
        counted = _binned_distances(plane)
        amount = gettext("Share of points\n(% per mm)") if axes is places[0] else ""
        style_axes(axes, "", amount)
        _HistogramBars(axes, counted, share=True).show(float(np.asarray(counted.edges)[-1]))
        for axis in (axes.xaxis, axes.yaxis):
            set_fitting_ticks(axis, _count_text)
        axes.set_title(short_name(plane.name), fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR)
    # One label for all, which would not fit below each of them
    figure.supxlabel(gettext("Distance (mm)"), fontsize=TEXT_SIZE, color=INK_COLOUR)
    handles = [patch for patch in places[0].patches if patch.get_fill()]
    figure.legend(
        handles, [gettext("before"), gettext("after")],
        loc="outside upper right" if is_narrow else "outside right center",
        ncols=2 if is_narrow else 1, fontsize=SMALL_TEXT_SIZE, frameon=False,
        labelcolor=INK_COLOUR,
    )  # fmt: skip
    return figure


def _binned_distances(plane: ValidationPlane) -> _BinnedDistances:
    before, after = plane.before, plane.after
    return _BinnedDistances(
        plane.bin_edges_m,
        (plane.counts_before, plane.counts_after),
        [
            _legend_text(template, each.n, each.median_m, each.rms_m, each.p95_m)
            for template, each in ((_BEFORE_LEGEND, before), (_AFTER_LEGEND, after))
        ],
        before.n,
        ENLARGED_WIDTH * after.p95_m,
    )


def _plane_title(name: str, pooled_from: str, model: str) -> str:
    return gettext(_PLANE_TITLES[pooled_from], plane=short_name(name), model=model)


_BEFORE_LEGEND = N_("before: n {count:n}\nmedian {median:mm.1}, RMS {rms:mm.1}, 95 % {p95:mm.1} mm")
_AFTER_LEGEND = N_("after: n {count:n}\nmedian {median:mm.1}, RMS {rms:mm.1}, 95 % {p95:mm.1} mm")


def _legend_text(template: str, count: int, median: float, rms: float, p95: float) -> str:
    return gettext(template, count=count, median=median, rms=rms, p95=p95)


def _draw_histogram(
    figure: Figure | None,
    title: str,
    counted: _BinnedDistances,
    share: bool,
    titled: bool = True,
) -> Figure:
    figure = blank_figure(figure, (6.3, 2.1))
    top = float(np.asarray(counted.edges)[-1])
    enlarged = counted.near < MAX_ENLARGED_SHARE * top
    places = list(figure.subplots(1, 2, width_ratios=(3, 2))) if enlarged else [figure.subplots()]
    amount = gettext("Share of points\n(% per mm)") if share else gettext("Points")
    for axes, reach in zip(places, (top, counted.near), strict=False):
        is_first = axes is places[0]
        # A narrow window has no space for the quantity in the second label.
        short = gettext("Distance (mm)") if is_first or is_wide(figure) else "(mm)"
        across = gettext(_FULL_VIEW_LABEL) if titled and is_first else short
        style_axes(axes, across, amount if is_first else "")
        _HistogramBars(axes, counted, share).show(reach)
    if not titled:
        return figure
    if enlarged:
        places[1].set_title(
            gettext(_ENLARGED_VIEW_TITLE), fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR
        )
    handles = [patch for patch in places[0].patches if patch.get_fill()]
    draw_title_and_legend(figure, title, handles, counted.legend)
    return figure


def _count_text(value: float) -> str:
    """Text of a number of points or of a share, with as many decimals as it has."""
    whole, _, decimals = f"{value:.12g}".partition(".")
    return (
        grouped_number(value, len(decimals))
        if whole.lstrip("-").isdigit()
        else localised_number(whole)
    )


class _HistogramBars:
    """Histogram bars of both states in one set of axes, with bins that fit the visible range."""

    def __init__(self, axes: Axes, counted: _BinnedDistances, share: bool) -> None:
        self._axes, self._counted, self._share = axes, counted, share
        self._patches = [
            [
                StepPatch([0.0], [0.0, 1.0], facecolor=colour, alpha=0.5, edgecolor="none"),
                StepPatch([0.0], [0.0, 1.0], fill=False, edgecolor=colour, linewidth=1.0),
            ]
            for colour in STATE_COLOURS
        ]
        for patch in (each for pair in self._patches for each in pair):
            axes.add_patch(patch)
        axes.yaxis.set_major_formatter(lambda value, _: _count_text(value))
        axes.callbacks.connect("xlim_changed", lambda _axes: self._follow())

    def show(self, reach: float) -> None:
        """Show the distances from 0 to ``reach``, metres."""
        self._axes.set_xlim(0.0, 1000.0 * reach)

    def _follow(self) -> None:
        """Fit the bins and the vertical axis to the visible range."""
        low, high = sorted(self._axes.get_xlim())
        shown = min(max(high - low, 1e-9), 1000.0 * float(np.asarray(self._counted.edges)[-1]))
        highest, edges = np.zeros(0), np.zeros(1)
        for patches, counts in zip(self._patches, self._counted.counts, strict=True):
            edges, heights = merge_bins(self._counted.edges, counts, shown / 1000.0, MAX_BARS)
            edges = 1000.0 * edges
            values = heights.astype(np.float64)
            if self._share:
                values *= 100.0 / self._counted.total / np.diff(edges)
            for patch in patches:
                patch.set_data(values, edges)
            highest = np.maximum(highest, values) if highest.size else values
        visible = (edges[:-1] < high) & (edges[1:] > low)
        self._axes.set_ylim(0.0, HEADROOM_RATIO * float(highest[visible].max(initial=0.0)) or 1.0)
