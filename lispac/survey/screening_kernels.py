"""Compiled passes that screen the points of a line: usable values, copies, steps of time.

Times are counted and copies found by hashes, as the audit needs them
(`lispac.survey.line_audit`; hash by A. Appleby, MurmurHash3 (2011)).

Each function works on one chunk in the order of the file and carries its state in arrays, so that
a line of any length is screened in constant memory.
"""

import numpy as np
from numba import njit

KEPT, NOT_FINITE, NO_RANGE, TOO_FAR, DUPLICATE, EXCLUDED = range(6)
"""What became of a point."""

WINDOW_SLOTS = 1 << 17
"""Slots of a hash table of recent points; it is cleared when half full."""
GAP_BINS = 200
"""Bins of gaps between distinct times, eight to an octave from `GAP_LEAST`."""
GAP_LEAST = 1e-4
"""Seconds; shorter gaps between distinct times are fine in any case."""
GAP_MOST = 10.0
"""Seconds; longer gaps are pauses, not steps."""

# Numba has no types mypy could check, hence the marks.


@njit(nogil=True, cache=True)
def point_hash(t, x, y, z):  # type: ignore[no-untyped-def]
    """Hash of 64 bits of the bit patterns of a point; never zero.

    A multiply-xorshift mix of each value (the finalizer of MurmurHash3 by A. Appleby).
    """
    h = np.uint64(0x9E3779B97F4A7C15)
    for value in (t, x, y, z):
        h ^= value
        h *= np.uint64(0xFF51AFD7ED558CCD)
        h ^= h >> np.uint64(32)
        h *= np.uint64(0xC4CEB9FE1A85EC53)
        h ^= h >> np.uint64(29)
    return h | np.uint64(1)


@njit(nogil=True, cache=True)
def screen_values(time, xyz, nearest, farthest, largest, largest_time, status):  # type: ignore[no-untyped-def]
    """Mark points that are not numbers, have no range, or are too far; count them by status.

    ``status`` (n,) holds `EXCLUDED` where a point was excluded before, else `KEPT`. A negative
    ``farthest`` leaves ranges unchecked.
    """
    near, far = nearest * nearest, farthest * farthest
    counts = np.zeros(6, np.int64)
    for i in range(len(time)):
        t, x, y, z = time[i], xyz[i, 0], xyz[i, 1], xyz[i, 2]
        if status[i] == EXCLUDED:
            pass
        elif not (
            -largest <= x <= largest
            and -largest <= y <= largest
            and -largest <= z <= largest
            and -largest_time <= t <= largest_time
        ):
            status[i] = NOT_FINITE
        elif farthest >= 0:
            r2 = x * x + y * y + z * z
            if r2 <= near:
                status[i] = NO_RANGE
            elif r2 > far:
                status[i] = TOO_FAR
        counts[status[i]] += 1
    return counts


@njit(nogil=True, cache=True)
def _contains(table, h):  # type: ignore[no-untyped-def]
    """Whether an open-addressing table holds a hash."""
    mask = np.uint64(len(table) - 1)
    k = h & mask
    while table[k] != 0:
        if table[k] == h:
            return True
        k = (k + np.uint64(1)) & mask
    return False


@njit(nogil=True, cache=True)
def _insert(table, h):  # type: ignore[no-untyped-def]
    """Put a hash into an open-addressing table that has room."""
    mask = np.uint64(len(table) - 1)
    k = h & mask
    while table[k] != 0:
        k = (k + np.uint64(1)) & mask
    table[k] = h


@njit(nogil=True, cache=True)
def grown(table):  # type: ignore[no-untyped-def]
    """A table of twice the size with the same hashes."""
    larger = np.zeros(2 * len(table), np.uint64)
    for h in table:
        if h != 0:
            _insert(larger, h)
    return larger


@njit(nogil=True, cache=True)
def mark_duplicates(time_bits, xyz_bits, status, tables, fill, threshold, sampled):  # type: ignore[no-untyped-def]
    """Mark points equal to an earlier one, and collect the hashes below a threshold.

    ``tables`` (2, m) are hashes of recent points, the current and the former half; ``fill`` (2,)
    counts the current one and tells which it is. Returns the numbers of duplicates and of hashes
    written to ``sampled``.
    """
    count = found = 0
    room = tables.shape[1] // 2
    for i in range(len(status)):
        if status[i] != KEPT:
            continue
        h = point_hash(time_bits[i], xyz_bits[i, 0], xyz_bits[i, 1], xyz_bits[i, 2])
        if _contains(tables[fill[1]], h) or _contains(tables[1 - fill[1]], h):
            status[i] = DUPLICATE
            found += 1
            continue
        if fill[0] == room:
            fill[0], fill[1] = 0, 1 - fill[1]
            tables[fill[1]] = 0
        _insert(tables[fill[1]], h)
        fill[0] += 1
        if h <= threshold:
            sampled[count] = h
            count += 1
    return found, count


@njit(nogil=True, cache=True)
def time_steps(time, used, last, gaps, sums, seconds):  # type: ignore[no-untyped-def]
    """Count distinct times, gaps between them by length, and whole seconds that hold points.

    ``used`` (n,) tells which points count; ``last`` (1,) is the last time before. Gaps go to
    ``gaps`` and their lengths to ``sums``, both (GAP_BINS,). Returns the numbers of points used, of
    changes of the time, and of entries of ``seconds``.
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
        if GAP_LEAST <= gap < GAP_MOST:
            k = int(8 * np.log2(gap / GAP_LEAST))
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
