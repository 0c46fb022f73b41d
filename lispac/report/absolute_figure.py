"""The histogram of signed distances from a reference, before and after over each other."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from lispac.report.absolute_values import Absolute
from lispac.report.figures import AFTER, BEFORE, INK, TEXT, blank, dress, short_name
from lispac.report.legends import USUAL, top_below_legend
from lispac.reverse_translation.translation import Say, unchanged


def absolute_figure(found: Absolute, say: Say = unchanged, figure: Figure | None = None) -> Figure:
    """All lines together; the bins at both ends hold all beyond."""
    figure = blank(figure, (6.3, 2.5))
    axes = figure.subplots(gridspec_kw=USUAL)
    edges = 1000 * np.asarray(found.bin_edges_m)
    told: list[str] = []
    for state, colour, counts, each in (
        ("before", BEFORE, found.counts_before, found.together.before),
        ("after", AFTER, found.counts_after, found.together.after),
    ):
        values = np.asarray(counts)
        words = (
            f"{state}: n {each.distances.n:,}\nmedian {1000 * each.signed.median_m:+.1f}, "
            f"RMS {1000 * each.distances.rms_m:.1f}, 95 % {1000 * each.distances.p95_m:.1f} mm"
        ).replace("-", "\u2212")
        told.append(say(words))
        axes.stairs(values, edges, fill=True, color=colour, alpha=0.5, label=told[-1])
        axes.stairs(values, edges, color=colour, linewidth=1.0)
    axes.set_xlim(edges[0], edges[-1])
    dress(
        axes,
        say(
            "Distance from the reference (mm), positive towards the vessel; the end bins hold all "
            "beyond"
        ),
        say("Places"),
    )
    axes.yaxis.set_major_locator(MaxNLocator(nbins="auto", steps=[1, 2, 5, 10], integer=True))
    axes.yaxis.set_major_formatter(lambda value, _: say(f"{value:,.0f}"))
    title = f"{short_name(found.reference)}, {say('all lines, along the normal')}"
    axes.set_title(title, fontsize=TEXT + 1, color=INK, loc="left")
    highest = np.maximum(found.counts_before, found.counts_after).astype(np.float64)
    axes.set_ylim(0.0, top_below_legend(axes, edges, highest, told, TEXT))
    axes.legend(loc="upper right", fontsize=TEXT, frameon=False, labelcolor=INK)
    return figure
