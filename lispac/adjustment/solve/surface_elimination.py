"""Elimination of the surfaces of the sightings from the normal equations, compiled.

A surface has three unknowns. It is coupled only to the knots of its own sighting, to the mounting
and to the shape of its target, so that few products remain for each.
"""

import numpy as np

from lispac.compiled_code import kernel


@kernel()
def nonzero_spans(mixed):  # type: ignore[no-untyped-def]
    """First and one past the last column other than zero of each surface, (surfaces, 2), int.

    ``mixed`` has three rows for each surface.
    """
    spans = np.zeros((len(mixed) // 3, 2), dtype=np.int64)
    for s in range(len(spans)):
        first, last = mixed.shape[1], 0
        for row in range(3 * s, 3 * s + 3):
            for k in range(mixed.shape[1]):
                if mixed[row, k] != 0.0:
                    first, last = min(first, k), max(last, k + 1)
        if last > 0:
            spans[s, 0], spans[s, 1] = first, last
    return spans


@kernel()
def _whiten_surface(a, row, spans, full, full_mixed, full_right, rest, crossed):  # type: ignore[no-untyped-def]
    """Multiply the three rows of a surface by the inverse Cholesky factor of its block ``a``.

    ``rest`` (3, others) and ``crossed`` (3, knots) are written; returns the three right-hand sides.
    """
    l00 = np.sqrt(a[0, 0])
    l10, l20 = a[1, 0] / l00, a[2, 0] / l00
    l11 = np.sqrt(a[1, 1] - l10 * l10)
    l21 = (a[2, 1] - l20 * l10) / l11
    l22 = np.sqrt(a[2, 2] - l20 * l20 - l21 * l21)
    for k in range(rest.shape[1]):
        x = full[row, k] / l00
        y = (full[row + 1, k] - l10 * x) / l11
        rest[0, k], rest[1, k] = x, y
        rest[2, k] = (full[row + 2, k] - l20 * x - l21 * y) / l22
    for k in range(spans[1] - spans[0]):
        column = spans[0] + k
        x = full_mixed[row, column] / l00
        y = (full_mixed[row + 1, column] - l10 * x) / l11
        crossed[0, k], crossed[1, k] = x, y
        crossed[2, k] = (full_mixed[row + 2, column] - l20 * x - l21 * y) / l22
    x = full_right[row] / l00
    y = (full_right[row + 1] - l10 * x) / l11
    return x, y, (full_right[row + 2] - l20 * x - l21 * y) / l22


@kernel()
def subtract_surfaces(  # type: ignore[no-untyped-def]
    full, full_right, full_mixed, spans, matrix, right, mixed, pos_right, band
):
    """Subtract the share of each surface from the equations of the other unknowns.

    Returns the share of ``v' P v``. A surface is coupled to few of the other unknowns: the mounting
    and the shape of its target.
    """
    others, quadratic = len(right), 0.0
    rest, crossed = np.empty((3, others)), np.empty((3, len(band)))
    coupled = np.empty(others, dtype=np.int64)
    for s in range(len(spans)):
        row, start, width = others + 3 * s, spans[s, 0], spans[s, 1] - spans[s, 0]
        block = full[row : row + 3, row : row + 3]
        x, y, z = _whiten_surface(block, row, spans[s], full, full_mixed, full_right, rest, crossed)
        quadratic += x * x + y * y + z * z
        count = 0
        for k in range(others):
            if rest[0, k] != 0.0 or rest[1, k] != 0.0 or rest[2, k] != 0.0:
                coupled[count] = k
                count += 1
        for p in range(count):
            i = coupled[p]
            r0, r1, r2 = rest[0, i], rest[1, i], rest[2, i]
            right[i] -= r0 * x + r1 * y + r2 * z
            for q in range(count):
                j = coupled[q]
                matrix[i, j] -= r0 * rest[0, j] + r1 * rest[1, j] + r2 * rest[2, j]
            for k in range(width):
                mixed[i, start + k] -= r0 * crossed[0, k] + r1 * crossed[1, k] + r2 * crossed[2, k]
        for j in range(width):
            c0, c1, c2 = crossed[0, j], crossed[1, j], crossed[2, j]
            pos_right[start + j] -= c0 * x + c1 * y + c2 * z
            for i in range(j, width):
                band[i - j, start + j] -= (
                    c0 * crossed[0, i] + c1 * crossed[1, i] + c2 * crossed[2, i]
                )
    return quadratic
