"""Histograms of the distances on a validation plane, before and after over each other."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import StepPatch
from numpy.typing import ArrayLike, NDArray

from lispac.report.figures import AFTER, BEFORE, INK, SMALL, TEXT, blank, dress, short_name
from lispac.report.legends import USUAL, top_below_legend
from lispac.report.validation_values import ValidationPlane
from lispac.reverse_translation.translation import Say, unchanged
from lispac.validation.bins import merged
from lispac.validation.results import PlaneComparison

Array = NDArray[np.float64]

BARS = 60
"""Drawn across the picture, at the most."""
NEAR, WORTH_IT = 1.6, 0.4
"""What came after is enlarged beside the whole: so many of its 95th percentiles, where that is less
than this share of the whole."""
COLOURS = (BEFORE, AFTER)
_WHOLE, _NEAR = "Distance between lines (mm); the last bin holds all beyond", "Enlarged (mm)"


@dataclass(frozen=True, eq=False)
class _Counted:
    """What is drawn: fine bins of both states, and words for each."""

    edges: ArrayLike
    counts: Sequence[ArrayLike]
    words: Sequence[str]
    total: int
    near: float


def histogram_figure(
    comparison: PlaneComparison,
    figure: Figure | None = None,
    *,
    share: bool = False,
    say: Say = unchanged,
) -> Figure:
    """Distances between lines on one validation plane, before and after over each other.

    Parameters
    ----------
    share : bool
        Draw the share of the points in each millimetre instead of their number in each bin.
    """
    before, after = comparison.before, comparison.after
    counted = _Counted(
        comparison.bin_edges,
        (comparison.counts_before, comparison.counts_after),
        [
            _words(state, each.n, each.median, each.rms, each.p95)
            for state, each in (("before", before), ("after", after))
        ],
        before.n,
        NEAR * after.p95,
    )
    told = f"{comparison.pooled_from}, {comparison.model.in_words}"
    return _drawn(figure, comparison.name, told, counted, share, say)


def validation_figure(plane: ValidationPlane, say: Say = unchanged) -> Figure:
    """`histogram_figure` of a report's content."""
    before, after = plane.before, plane.after
    counted = _Counted(
        plane.bin_edges_m,
        (plane.counts_before, plane.counts_after),
        [
            _words(state, each.n, each.median_m, each.rms_m, each.p95_m)
            for state, each in (("before", before), ("after", after))
        ],
        before.n,
        NEAR * after.p95_m,
    )
    told = f"{plane.pooled_from}, {plane.measured_to}"
    return _drawn(None, plane.name, told, counted, False, say)


def _words(state: str, n: int, median: float, rms: float, p95: float) -> str:
    return (
        f"{state}: n {n:,}\nmedian {1000 * median:.1f}, RMS {1000 * rms:.1f}, "
        f"95 % {1000 * p95:.1f} mm"
    )


def _drawn(
    figure: Figure | None,
    name: str,
    told: str,
    counted: _Counted,
    share: bool,
    say: Say = unchanged,
) -> Figure:
    figure = blank(figure, (6.3, 2.5))
    top = float(np.asarray(counted.edges)[-1])
    enlarged = counted.near < WORTH_IT * top
    if enlarged:
        places = list(figure.subplots(1, 2, width_ratios=(3, 2), gridspec_kw=USUAL))
    else:
        places = [figure.subplots(gridspec_kw=USUAL)]
    said, size = [say(words) for words in counted.words], SMALL if enlarged else TEXT
    amount = "Share of the points\n(% per mm)" if share else "Points"
    for axes, reach, across in zip(places, (top, counted.near), (_WHOLE, _NEAR), strict=False):
        dress(axes, say(across), say(amount) if axes is places[0] else "")
        told_there = said if axes is places[0] else ()
        _Bars(axes, counted, share, told_there, size, say).show(reach)
    places[0].set_title(
        f"{short_name(name)}, {say(told)}", fontsize=TEXT + 1, color=INK, loc="left"
    )
    patches = [patch for patch in places[0].patches if patch.get_fill()]
    places[-1 if enlarged else 0].set_title("")
    places[0].legend(
        patches, said, loc="upper right", fontsize=size, frameon=False, labelcolor=INK,
    )  # fmt: skip
    return figure


class _Bars:
    """Both states in one set of axes, in bins that suit what is seen of them."""

    def __init__(
        self, axes: Axes, counted: _Counted, share: bool, words: Sequence[str], size: float,
        say: Say,
    ) -> None:  # fmt: skip
        self._axes, self._counted, self._share = axes, counted, share
        self._words, self._size = words, size
        self._patches = [
            [
                StepPatch([0.0], [0.0, 1.0], facecolor=colour, alpha=0.5, edgecolor="none"),
                StepPatch([0.0], [0.0, 1.0], fill=False, edgecolor=colour, linewidth=1.0),
            ]
            for colour in COLOURS
        ]
        for patch in (each for pair in self._patches for each in pair):
            axes.add_patch(patch)
        axes.yaxis.set_major_formatter(lambda value, _: say(f"{value:,.12g}"))
        axes.callbacks.connect("xlim_changed", lambda _axes: self._follow())

    def show(self, reach: float) -> None:
        """The distances from 0 to ``reach``, metres."""
        self._axes.set_xlim(0.0, 1000.0 * reach)

    def _follow(self) -> None:
        low, high = sorted(self._axes.get_xlim())
        shown = min(max(high - low, 1e-9), 1000.0 * float(np.asarray(self._counted.edges)[-1]))
        highest, edges = np.zeros(0), np.zeros(1)
        for patches, counts in zip(self._patches, self._counted.counts, strict=True):
            edges, heights = merged(self._counted.edges, counts, shown / 1000.0, BARS)
            edges = 1000.0 * edges
            values = heights.astype(np.float64)
            if self._share:
                values *= 100.0 / self._counted.total / np.diff(edges)
            for patch in patches:
                patch.set_data(values, edges)
            highest = np.maximum(highest, values) if highest.size else values
        top = top_below_legend(self._axes, edges, highest, self._words, self._size)
        self._axes.set_ylim(0.0, top)
