"""Distances on a validation plane in words and as text: under the mouse, and to copy."""

import csv
from io import StringIO

import numpy as np

from lispac.foreign_values import as_cell
from lispac.gui import units
from lispac.validation.bins import BEYOND, merged
from lispac.validation.profile import Profile
from lispac.validation.results import PlaneComparison

TAB = "\t"
"""Between the columns: a spreadsheet takes them apart when pasted into."""


def histogram_words(comparison: PlaneComparison, low: float, high: float) -> str:
    """How many distances lie in a bar of the histogram, ``low`` to ``high`` metres.

    Here and in `profile_words` figures are in the unit shown, signs in millimetres: `units.signs`
    puts the others.
    """
    edges = comparison.bin_edges
    beyond = high >= float(edges[-1]) * (1.0 - 1e-9)
    said = []
    for state, counts in (("before", comparison.counts_before), ("after", comparison.counts_after)):
        middles = 0.5 * (edges[:-1] + edges[1:])
        inside = int(counts[(middles > low) & (middles < high)].sum())
        up_to = 100.0 * int(counts[middles < high].sum()) / max(int(counts.sum()), 1)
        said.append(f"{state} {inside:,} points ({up_to:.1f} % up to here)")
    start, end = (units.figure(1000 * edge, "mm", ".4g") for edge in (low, high))
    reach = f"{start} mm {BEYOND}" if beyond else f"{start}–{end} mm"
    return f"{reach}: {', '.join(said)}"


def profile_words(profile: Profile, what: str, place: float) -> str:
    """The distances at a height or range, metres."""
    k = int(np.clip(np.searchsorted(profile.edges, place) - 1, 0, len(profile.n) - 1))
    start, end = (units.figure(edge, "m", ".1f") for edge in profile.edges[k : k + 2])
    reach = f"{what} {start}–{end} m"
    if not np.isfinite(profile.median_before[k]):
        return f"{reach}: {profile.n[k]:,} distances, too few"
    change = [
        f"{word} {_mm(before[k])} → {_mm(after[k])} mm"
        for word, before, after in (
            ("median", profile.median_before, profile.median_after),
            ("95 %", profile.p95_before, profile.p95_after),
        )
    ]
    return f"{reach}: {', '.join(change)}, {profile.n[k]:,} distances"


def _mm(metres: float) -> str:
    return units.figure(1000 * metres, "mm", ".1f")


def histogram_text(comparison: PlaneComparison, shown: float, bars: int) -> str:
    """The bars as a table, tabs between the columns: edges (mm), points before and after.

    Parameters
    ----------
    shown : float, metres
        Width of what is seen, which takes no more than ``bars``.
    """
    edges, before = merged(comparison.bin_edges, comparison.counts_before, shown, bars)
    _, after = merged(comparison.bin_edges, comparison.counts_after, shown, bars)
    ends = [*(f"{1000 * edge:.6g}" for edge in edges[1:-1]), BEYOND]
    rows = zip(1000 * edges[:-1], ends, before, after, strict=True)
    return _text(
        ("From (mm)", "To (mm)", "Points before", "Points after"),
        [(f"{low:.6g}", end, str(b), str(a)) for low, end, b, a in rows],
    )


def profiles_text(comparison: PlaneComparison) -> str:
    """The distances against height and range as a table, tabs between the columns."""
    rows = []
    for what, profile in (("Height", comparison.by_height), ("Range", comparison.by_range)):
        if profile is None:
            continue
        values = (
            profile.median_before, profile.median_after, profile.p95_before, profile.p95_after
        )  # fmt: skip
        for k, n in enumerate(profile.n):
            low, high = profile.edges[k : k + 2]
            cells = ("" if np.isnan(each[k]) else f"{1000 * each[k]:.3f}" for each in values)
            rows.append((what, f"{low:.3f}", f"{high:.3f}", str(n), *cells))
    heads = (
        "Against", "From (m)", "To (m)", "Distances", "Median before (mm)", "Median after (mm)",
        "95 % before (mm)", "95 % after (mm)",
    )  # fmt: skip
    return _text(heads, rows)


def _text(heads: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    stream = StringIO()
    writer = csv.writer(stream, delimiter=TAB, lineterminator="\n")
    writer.writerows([as_cell(cell) for cell in row] for row in (heads, *rows))
    return stream.getvalue()
