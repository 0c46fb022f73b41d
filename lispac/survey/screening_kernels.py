"""Compiled functions that screen the points of a line: usable values, copies, steps of time.

Copies are found by hashes (MurmurHash3 by A. Appleby, 2011). Distinct times are counted for the
audit (`lispac.survey.line_audit`).

Each function processes one chunk in the order of the file and keeps its state in arrays, so that a
line of any length is screened in constant memory.
"""

import numpy as np

from lispac.compiled_code import njit

KEPT, NOT_FINITE, NO_RANGE, TOO_FAR, DUPLICATE, EXCLUDED = range(6)
"""Result of the screening of a point."""

WINDOW_SLOTS = 1 << 17
"""Number of slots of a hash table of recent points, which is cleared when half full."""
MAX_RUN_POINTS = 64
"""Largest number of points with the same time that are compared individually."""
GAP_BINS = 200
"""Number of bins of gaps between distinct times: eight per doubling of the gap from `MIN_GAP_S`."""
MIN_GAP_S = 1e-4
"""Gap between distinct times below which their resolution is sufficient."""
MAX_GAP_S = 10.0
"""Gap from which times are separated by a pause."""

# mypy cannot check functions of Numba, hence the comments "type: ignore".


@njit(nogil=True, cache=True)
def point_hash(t, x, y, z):  # type: ignore[no-untyped-def]
    """Hash of 64 bits of the bit patterns of a point; never zero.

    A sum of multiples (Dietzfelbinger 1996), mixed by the finalizer of MurmurHash3 by A. Appleby.
    """
    h = (
        t * np.uint64(0x9E3779B97F4A7C15)
        + x * np.uint64(0xD6E8FEB86659FD93)
        + y * np.uint64(0xA0761D6478BD642F)
        + z * np.uint64(0xE7037ED1A0B428DB)
    )
    h ^= h >> np.uint64(33)
    h *= np.uint64(0xFF51AFD7ED558CCD)
    h ^= h >> np.uint64(33)
    h *= np.uint64(0xC4CEB9FE1A85EC53)
    h ^= h >> np.uint64(33)
    return h | np.uint64(1)


@njit(nogil=True, cache=True)
def screen_values(time, xyz, nearest, farthest, largest, largest_time, status):  # type: ignore[no-untyped-def]
    """Mark points that are not finite, have no range, or are too far; count points by status.

    ``status`` (n,) contains `EXCLUDED` for points that were excluded before, otherwise `KEPT`.
    Ranges are not checked if ``farthest`` is negative.
    """
    ranged = farthest >= 0
    near, far = nearest * nearest, farthest * farthest
    low, high = (near, far) if ranged else (-1.0, largest * largest)
    counts = np.zeros(6, np.int64)
    for i in range(len(time)):
        if status[i] == EXCLUDED:
            counts[EXCLUDED] += 1
            continue
        t, x, y, z = time[i], xyz[i, 0], xyz[i, 1], xyz[i, 2]
        r2 = x * x + y * y + z * z
        # Nearly all points are accepted here; for the others, the reason is determined below.
        if low < r2 <= high and -largest_time <= t <= largest_time and (x != y or y != z):
            continue
        if not (
            -largest <= x <= largest
            and -largest <= y <= largest
            and -largest <= z <= largest
            and -largest_time <= t <= largest_time
        ):
            status[i] = NOT_FINITE
        elif ranged and (r2 <= near or (x == y and y == z)):
            status[i] = NO_RANGE  # without an echo, scanners write one value, such as 0 or -9999
        elif ranged and r2 > far:
            status[i] = TOO_FAR
        if status[i] != KEPT:
            counts[status[i]] += 1
    counts[KEPT] = len(time) - counts.sum()
    return counts


@njit(nogil=True, cache=True)
def _table_contains(table, h):  # type: ignore[no-untyped-def]
    """Whether an open-addressing table contains a hash."""
    mask = np.uint64(len(table) - 1)
    k = h & mask
    while table[k] != 0:
        if table[k] == h:
            return True
        k = (k + np.uint64(1)) & mask
    return False


@njit(nogil=True, cache=True)
def _table_insert(table, h):  # type: ignore[no-untyped-def]
    """Put a hash into an open-addressing table that has free slots."""
    mask = np.uint64(len(table) - 1)
    k = h & mask
    while table[k] != 0:
        k = (k + np.uint64(1)) & mask
    table[k] = h


@njit(nogil=True, cache=True)
def doubled_table(table):  # type: ignore[no-untyped-def]
    """A table of twice the size with the same hashes."""
    larger = np.zeros(2 * len(table), np.uint64)
    for h in table:
        if h != 0:
            _table_insert(larger, h)
    return larger


@njit(nogil=True, cache=True)
def _is_duplicate_in_run(i, start, tail, time_bits, xyz_bits):  # type: ignore[no-untyped-def]
    """Whether a point equals one of the same time before it, in this chunk or at its border."""
    for j in range(i - 1, start - 1, -1):
        if (
            xyz_bits[j, 0] == xyz_bits[i, 0]
            and xyz_bits[j, 1] == xyz_bits[i, 1]
            and xyz_bits[j, 2] == xyz_bits[i, 2]
        ):
            return True
    if start == 0:
        for j in range(len(tail)):
            if (
                tail[j, 0] == time_bits[i]
                and tail[j, 1] == xyz_bits[i, 0]
                and tail[j, 2] == xyz_bits[i, 1]
                and tail[j, 3] == xyz_bits[i, 2]
            ):
                return True
    return False


@njit(nogil=True, cache=True)
def mark_duplicates(  # type: ignore[no-untyped-def]
    time, time_bits, xyz_bits, status, latest, tail, tables, fill, threshold, sampled
):
    """Mark points equal to an earlier one, and collect the hashes up to a threshold.

    Copies have the same time. As long as times do not decrease, only the preceding points with the
    same time can be equal; ``tail`` (m, 4) contains the last points of the previous chunk.
    Otherwise, or if many points have the same time, hashes of recent points are kept in ``tables``
    (2, m), the current and the previous table. ``fill`` (3,) contains the number of hashes in the
    current table, its index, and whether tables are in use; ``latest`` (1,) is the latest time
    before this chunk. Hashes up to ``threshold`` are written to ``sampled``. Returns the numbers of
    duplicates and of these hashes.
    """
    count = found = 0
    capacity = tables.shape[1] // 2
    run, newest = 0, latest[0]
    for i in range(len(status)):
        if status[i] != KEPT:
            continue
        t = time[i]
        if fill[2] == 0:
            if not t <= newest:
                run, newest = i, t
            elif t < newest or i - run > MAX_RUN_POINTS:
                fill[2] = 1
                for j in range(max(0, i - capacity + 1), i):
                    if status[j] == KEPT:
                        before = xyz_bits[j]
                        _table_insert(
                            tables[fill[1]],
                            point_hash(time_bits[j], before[0], before[1], before[2]),
                        )
                        fill[0] += 1
            elif _is_duplicate_in_run(i, run, tail, time_bits, xyz_bits):
                status[i] = DUPLICATE
                found += 1
                continue
        h = point_hash(time_bits[i], xyz_bits[i, 0], xyz_bits[i, 1], xyz_bits[i, 2])
        if fill[2] != 0:
            if _table_contains(tables[fill[1]], h) or _table_contains(tables[1 - fill[1]], h):
                status[i] = DUPLICATE
                found += 1
                continue
            if fill[0] >= capacity:
                fill[0], fill[1] = 0, 1 - fill[1]
                tables[fill[1]] = 0
            _table_insert(tables[fill[1]], h)
            fill[0] += 1
        if h <= threshold:
            sampled[count] = h
            count += 1
    latest[0] = newest
    return found, count


@njit(nogil=True, cache=True)
def time_steps(time, used, last, gaps, sums, seconds):  # type: ignore[no-untyped-def]
    """Count distinct times and the gaps between them, and list the whole seconds with points.

    ``used`` (n,) is the mask of the points to be counted; ``last`` (1,) is the last time of the
    previous chunk. Gaps are added to ``gaps`` and their lengths to ``sums``, both (GAP_BINS,).
    Returns the numbers of points used, of changes of the time, and of entries of ``seconds``.
    """
    points = changes = entries = 0
    previous, second = last[0], np.nan
    for i in range(len(time)):
        if not used[i]:
            continue
        points += 1
        t = time[i]
        if t == previous:
            continue
        changes += 1
        gap = t - previous
        if MIN_GAP_S <= gap < MAX_GAP_S:
            k = int(8 * np.log2(gap / MIN_GAP_S))
            gaps[k] += 1
            sums[k] += gap
        previous = t
        whole = np.floor(t)
        if whole != second:
            second = whole
            seconds[entries] = np.int64(whole)
            entries += 1
    last[0] = previous
    return points, changes, entries
