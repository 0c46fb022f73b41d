"""Histogram of the signed distances from a reference, before and after overlaid."""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from lispac.language import N_, gettext
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.present.text_format import grouped_number, signed_number
from lispac.report.figures import (
    AFTER_COLOUR,
    BEFORE_COLOUR,
    HEADROOM_RATIO,
    blank_figure,
    draw_title_and_legend,
    short_name,
    style_axes,
)

_BEFORE_LEGEND = N_(
    "before: n {count:n}\nmedian {median} mm, RMS {rms:mm.1} mm, 95 % {p95:mm.1} mm"
)
_AFTER_LEGEND = N_("after: n {count:n}\nmedian {median} mm, RMS {rms:mm.1} mm, 95 % {p95:mm.1} mm")


def reference_distance_figure(check: AbsoluteCheckValues, figure: Figure | None = None) -> Figure:
    """Histogram of all lines together; the first and last bins include all larger distances."""
    figure = blank_figure(figure, (6.3, 2.5))
    axes = figure.subplots()
    edges = 1000 * np.asarray(check.bin_edges_m)
    legend: list[str] = []
    bars: list[Artist] = []
    for template, colour, counts, each in (
        (_BEFORE_LEGEND, BEFORE_COLOUR, check.counts_before, check.all_lines.before),
        (_AFTER_LEGEND, AFTER_COLOUR, check.counts_after, check.all_lines.after),
    ):
        values = np.asarray(counts)
        legend.append(
            gettext(
                template,
                count=each.distances.n, median=signed_number(1000 * each.signed.median_m, 1),
                rms=each.distances.rms_m, p95=each.distances.p95_m,
            )
        )  # fmt: skip
        bars.append(axes.stairs(values, edges, fill=True, color=colour, alpha=0.5))
        axes.stairs(values, edges, color=colour, linewidth=1.0)
    axes.set_xlim(edges[0], edges[-1])
    across = gettext(
        "Distance from the reference (mm), positive towards the vessel; end bins include larger "
        "values"
    )
    style_axes(axes, across, gettext("Compared places"))
    axes.yaxis.set_major_locator(MaxNLocator(nbins="auto", steps=[1, 2, 5, 10], integer=True))
    axes.yaxis.set_major_formatter(lambda value, _: grouped_number(value))
    title = gettext(
        "{reference}: distances of all lines along the normal",
        reference=short_name(check.reference),
    )
    highest = float(max(*check.counts_before, *check.counts_after))
    axes.set_ylim(0.0, HEADROOM_RATIO * highest or 1.0)
    draw_title_and_legend(figure, title, bars, legend)
    return figure
