"""Distances on a validation plane: text under the mouse, and tables to copy."""

import csv
from io import StringIO
from typing import Literal

import numpy as np

from lispac.gui.appearance import units
from lispac.language import gettext
from lispac.untrusted_values import as_csv_cell
from lispac.validation.comparison_results import PlaneComparison
from lispac.validation.distance_bins import BEYOND, merge_bins
from lispac.validation.distance_profile import DistanceProfile

TAB = "\t"
"""Separates the columns, so that a spreadsheet splits them."""

Against = Literal["height", "range"]
"""Abscissa of the distances of a profile."""


def histogram_bar_text(comparison: PlaneComparison, low: float, high: float) -> str:
    """Text on the distances in a bar of the histogram, from ``low`` to ``high`` metres."""
    edges = comparison.bin_edges
    beyond = high >= float(edges[-1]) * (1.0 - 1e-9)
    middles = 0.5 * (edges[:-1] + edges[1:])
    inside, up_to = [], []
    for counts in (comparison.counts_before, comparison.counts_after):
        inside.append(int(counts[(middles > low) & (middles < high)].sum()))
        up_to.append(int(counts[middles < high].sum()) / max(int(counts.sum()), 1))
    if beyond:
        reach = gettext("{start} and beyond", start=units.local_amount(1000 * low, "mm", ".4g"))
    else:
        start = units.local_figure(1000 * low, "mm", ".4g")
        reach = f"{start}–{units.local_amount(1000 * high, 'mm', '.4g')}"
    return gettext(
        "{reach}: {before:n} points before ({up_to_before:percent.1} % cumulative), {after:n} "
        "points after ({up_to_after:percent.1} % cumulative)",
        reach=reach, before=inside[0], up_to_before=up_to[0], after=inside[1],
        up_to_after=up_to[1],
    )  # fmt: skip


def profile_bin_text(profile: DistanceProfile, against: Against, place: float) -> str:
    """Text on the distances at a height or range, metres."""
    k = int(np.clip(np.searchsorted(profile.edges, place) - 1, 0, len(profile.n) - 1))
    low, high = profile.edges[k : k + 2]
    start, end = units.local_figure(low, "m", ".1f"), units.local_amount(high, "m", ".1f")
    if against == "height":
        reach = gettext("Height {start}–{end}", start=start, end=end)
    else:
        reach = gettext("Range {start}–{end}", start=start, end=end)
    count = int(profile.n[k])
    if not np.isfinite(profile.median_before[k]):
        return gettext("{reach}: too few distances ({count:n})", reach=reach, count=count)
    return gettext(
        "{reach}: median {median_before} → {median_after}, 95th percentile {p95_before} → "
        "{p95_after}, {count:n} distances",
        reach=reach,
        median_before=_millimetres(profile.median_before[k]),
        median_after=_millimetres_with_unit(profile.median_after[k]),
        p95_before=_millimetres(profile.p95_before[k]),
        p95_after=_millimetres_with_unit(profile.p95_after[k]),
        count=count,
    )


def _millimetres(metres: float) -> str:
    return units.local_figure(1000 * metres, "mm", ".1f")


def _millimetres_with_unit(metres: float) -> str:
    return units.local_amount(1000 * metres, "mm", ".1f")


def histogram_text(comparison: PlaneComparison, shown: float, bars: int) -> str:
    """Bars as tab-separated table: edges (mm), points before and after.

    Parameters
    ----------
    shown : float, metres
        Width of the visible part, which has at most ``bars`` bars.
    """
    edges, before = merge_bins(comparison.bin_edges, comparison.counts_before, shown, bars)
    _, after = merge_bins(comparison.bin_edges, comparison.counts_after, shown, bars)
    ends = [*(f"{1000 * edge:.6g}" for edge in edges[1:-1]), BEYOND]
    rows = zip(1000 * edges[:-1], ends, before, after, strict=True)
    return _tabbed_text(
        ("From (mm)", "To (mm)", "Points before calibration", "Points after calibration"),
        [(f"{low:.6g}", end, str(b), str(a)) for low, end, b, a in rows],
    )


def profiles_text(comparison: PlaneComparison) -> str:
    """Distances against height and range as tab-separated table."""
    rows = []
    for title, profile in (("Height", comparison.by_height), ("Range", comparison.by_range)):
        if profile is None:
            continue
        values = (
            profile.median_before, profile.median_after, profile.p95_before, profile.p95_after
        )  # fmt: skip
        for k, n in enumerate(profile.n):
            low, high = profile.edges[k : k + 2]
            cells = ("" if np.isnan(each[k]) else f"{1000 * each[k]:.3f}" for each in values)
            rows.append((title, f"{low:.3f}", f"{high:.3f}", str(n), *cells))
    heads = (
        "Quantity", "From (m)", "To (m)", "Distances", "Median before (mm)", "Median after (mm)",
        "95 % before (mm)", "95 % after (mm)",
    )  # fmt: skip
    return _tabbed_text(heads, rows)


def _tabbed_text(heads: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    stream = StringIO()
    writer = csv.writer(stream, delimiter=TAB, lineterminator="\n")
    writer.writerows([as_csv_cell(cell) for cell in row] for row in (heads, *rows))
    return stream.getvalue()
