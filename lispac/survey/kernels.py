"""Compiled conversions of points: scanner frame to local frame to map, and back.

The conversion to the local frame is thesis equation 1.1, as in `lispac.survey.georeferencing`.

Each function processes a contiguous piece of a line and releases Python's global lock, so that
pieces are processed on all cores. Functions that combine several steps process the piece in tiles
that fit into the processor's cache, without arrays of intermediate results.
"""

import numpy as np

from lispac.compiled_code import njit

TILE_POINTS = 2048
"""Number of points of a tile, which fit into the cache of the processor."""
MAX_SERIES_ANGLE_RAD = 0.1
"""Largest angle for the series of sine and cosine; the first omitted term is 3e-17 there."""
CUBIC_TERMS = 20
"""Number of coefficients of a polynomial of third degree in three variables."""

# mypy cannot check functions of Numba, hence the comments "type: ignore".


@njit(nogil=True, cache=True)
def find_interval(t, knots, k):  # type: ignore[no-untyped-def]
    """Index of the interval of ``knots`` that contains ``t``; -1 outside.

    ``k`` is the interval of the previous point. Times mostly increase, so this interval or the next
    one is usually correct; otherwise the interval is found by bisection.
    """
    last = len(knots) - 2
    if not (knots[0] <= t <= knots[-1]):
        return -1
    if knots[k] <= t <= knots[k + 1]:
        return k
    if k < last and knots[k + 1] <= t <= knots[k + 2]:
        return k + 1
    return min(max(np.searchsorted(knots, t) - 1, 0), last)


@njit(nogil=True, cache=True, fastmath={"contract"})
def rotate_cosine_sine(cosine, sine, angle, turn):  # type: ignore[no-untyped-def]
    """Cosine and sine of ``angle + turn`` from those of ``angle``.

    Angles hardly change between two states of a POS. Up to `MAX_SERIES_ANGLE_RAD`, a short series
    is used, which is exact to rounding and takes a third of the time of the trigonometric
    functions.
    """
    if not -MAX_SERIES_ANGLE_RAD <= turn <= MAX_SERIES_ANGLE_RAD:
        return np.cos(angle + turn), np.sin(angle + turn)
    q = turn * turn
    s = turn * (1 - q * (1 / 6) * (1 - q * (1 / 20) * (1 - q * (1 / 42) * (1 - q * (1 / 72)))))
    c = 1 - q * (1 / 2) * (1 - q * (1 / 12) * (1 - q * (1 / 30) * (1 - q * (1 / 56))))
    return cosine * c - sine * s, sine * c + cosine * s


@njit(nogil=True, cache=True, fastmath={"contract"})
def georeference_in_place(  # type: ignore[no-untyped-def]
    points_lidar, time, latency, knots, states, rotation, lever_arm, points_local
):
    """Convert from the scanner frame to the local frame; False if a time is not in the trajectory.

    ``states`` contains position and attitude at ``knots``, shape (m, 6).
    """
    k, known = 0, -1
    for i in range(len(time)):
        t = time[i] + latency
        k = find_interval(t, knots, k)
        if k < 0:
            return False
        low, high = states[k], states[k + 1]
        if k != known:
            known = k
            cos_r, sin_r = np.cos(low[3]), np.sin(low[3])
            cos_p, sin_p = np.cos(low[4]), np.sin(low[4])
            cos_h, sin_h = np.cos(low[5]), np.sin(low[5])
        u = (t - knots[k]) / (knots[k + 1] - knots[k])
        x, y, z = points_lidar[i, 0], points_lidar[i, 1], points_lidar[i, 2]
        bx = rotation[0, 0] * x + rotation[0, 1] * y + rotation[0, 2] * z + lever_arm[0]
        by = rotation[1, 0] * x + rotation[1, 1] * y + rotation[1, 2] * z + lever_arm[1]
        bz = rotation[2, 0] * x + rotation[2, 1] * y + rotation[2, 2] * z + lever_arm[2]
        # Rx(roll), Ry(pitch), Rz(-heading), one after the other
        c, s = rotate_cosine_sine(cos_r, sin_r, low[3], u * (high[3] - low[3]))
        by, bz = c * by - s * bz, s * by + c * bz
        c, s = rotate_cosine_sine(cos_p, sin_p, low[4], u * (high[4] - low[4]))
        bx, bz = c * bx + s * bz, -s * bx + c * bz
        c, s = rotate_cosine_sine(cos_h, sin_h, low[5], u * (high[5] - low[5]))
        bx, by = c * bx + s * by, -s * bx + c * by
        points_local[i, 0] = low[0] + u * (high[0] - low[0]) + bx
        points_local[i, 1] = low[1] + u * (high[1] - low[1]) + by
        points_local[i, 2] = low[2] + u * (high[2] - low[2]) + bz
    return True


@njit(nogil=True, cache=True, fastmath={"contract"})
def to_scanner_in_place(  # type: ignore[no-untyped-def]
    points_local, time, latency, knots, states, rotation, lever_arm, points_lidar
):
    """The inverse of `georeference_in_place`; both arrays may be the same one."""
    k, known = 0, -1
    for i in range(len(time)):
        t = time[i] + latency
        k = find_interval(t, knots, k)
        if k < 0:
            return False
        low, high = states[k], states[k + 1]
        if k != known:
            known = k
            cos_r, sin_r = np.cos(low[3]), np.sin(low[3])
            cos_p, sin_p = np.cos(low[4]), np.sin(low[4])
            cos_h, sin_h = np.cos(low[5]), np.sin(low[5])
        u = (t - knots[k]) / (knots[k + 1] - knots[k])
        bx = points_local[i, 0] - (low[0] + u * (high[0] - low[0]))
        by = points_local[i, 1] - (low[1] + u * (high[1] - low[1]))
        bz = points_local[i, 2] - (low[2] + u * (high[2] - low[2]))
        # Inverse rotations of `georeference_in_place`, in reverse order
        c, s = rotate_cosine_sine(cos_h, sin_h, low[5], u * (high[5] - low[5]))
        bx, by = c * bx - s * by, s * bx + c * by
        c, s = rotate_cosine_sine(cos_p, sin_p, low[4], u * (high[4] - low[4]))
        bx, bz = c * bx - s * bz, s * bx + c * bz
        c, s = rotate_cosine_sine(cos_r, sin_r, low[3], u * (high[3] - low[3]))
        by, bz = c * by + s * bz, -s * by + c * bz
        bx, by, bz = bx - lever_arm[0], by - lever_arm[1], bz - lever_arm[2]
        points_lidar[i, 0] = rotation[0, 0] * bx + rotation[1, 0] * by + rotation[2, 0] * bz
        points_lidar[i, 1] = rotation[0, 1] * bx + rotation[1, 1] * by + rotation[2, 1] * bz
        points_lidar[i, 2] = rotation[0, 2] * bx + rotation[1, 2] * by + rotation[2, 2] * bz
    return True


@njit(nogil=True, cache=True, fastmath={"contract"})
def evaluate_cubic(c, x, y, z):  # type: ignore[no-untyped-def]
    """Value of a cubic polynomial; the order of ``c`` is that of `lispac.survey.smooth_map`."""
    return (
        c[0]
        + z * (c[1] + z * (c[2] + z * c[3]))
        + y * (c[4] + z * (c[5] + z * c[6]) + y * (c[7] + z * c[8] + y * c[9]))
        + x
        * (
            c[10]
            + z * (c[11] + z * c[12])
            + y * (c[13] + z * c[14] + y * c[15])
            + x * (c[16] + z * c[17] + y * c[18] + x * c[19])
        )
    )


@njit(nogil=True, cache=True, fastmath={"contract"})
def evaluate_smooth_map(points, root, children, leaf_of, boxes, coefficients, missed):  # type: ignore[no-untyped-def]
    """Apply the polynomial of its cell to each point, in place.

    ``root`` contains low x, low y, low z, side and high z. ``children``, shape (nodes, 4), is -1
    for a leaf; ``leaf_of`` gives the number of the leaf, or -1 if the exact conversion is needed.
    ``boxes``, shape (leaves, 6), contains the centre and the inverse of half the size. Points
    without a cell are not changed but marked in ``missed``; their number is returned.
    """
    count = 0
    leaf = -1
    low_x = high_x = low_y = high_y = 0.0
    for i in range(len(points)):
        x, y, z = points[i, 0], points[i, 1], points[i, 2]
        if leaf < 0 or not (low_x <= x < high_x and low_y <= y < high_y):
            leaf = -1
            side = root[3]
            low_x, low_y = root[0], root[1]
            if low_x <= x < low_x + side and low_y <= y < low_y + side:
                node = 0
                while children[node, 0] >= 0:
                    side *= 0.5
                    quarter = 0
                    if x >= low_x + side:
                        low_x += side
                        quarter = 1
                    if y >= low_y + side:
                        low_y += side
                        quarter += 2
                    node = children[node, quarter]
                leaf = leaf_of[node]
                high_x, high_y = low_x + side, low_y + side
        if leaf < 0 or not (root[2] <= z <= root[4]):
            missed[i] = True
            count += 1
            continue
        box = boxes[leaf]
        c = coefficients[leaf]
        sx, sy, sz = (x - box[0]) * box[3], (y - box[1]) * box[4], (z - box[2]) * box[5]
        points[i, 0] = evaluate_cubic(c[0], sx, sy, sz)
        points[i, 1] = evaluate_cubic(c[1], sx, sy, sz)
        points[i, 2] = evaluate_cubic(c[2], sx, sy, sz)
    return count


@njit(nogil=True, cache=True)
def georeference_to_map(  # type: ignore[no-untyped-def]
    points_lidar, time, latency, knots, states, rotation, lever_arm,
    root, children, leaf_of, boxes, coefficients, points_map, missed,
):  # fmt: skip
    """Convert from scanner frame to map; points marked in ``missed`` stay in the local frame.

    Returns the number of missed points, or -1 if a time lies outside the trajectory.
    """
    count = 0
    for start in range(0, len(time), TILE_POINTS):
        stop = min(start + TILE_POINTS, len(time))
        tile = points_map[start:stop]
        if not georeference_in_place(
            points_lidar[start:stop], time[start:stop], latency, knots, states, rotation,
            lever_arm, tile,
        ):  # fmt: skip
            return -1
        count += evaluate_smooth_map(
            tile, root, children, leaf_of, boxes, coefficients, missed[start:stop]
        )
    return count


@njit(nogil=True, cache=True)
def coordinates_from_integers(x, y, z, scales, offsets, points):  # type: ignore[no-untyped-def]
    """Coordinates from integers, with exactly the same result as laspy."""
    for i in range(len(x)):
        points[i, 0] = x[i] * scales[0] + offsets[0]
        points[i, 1] = y[i] * scales[1] + offsets[1]
        points[i, 2] = z[i] * scales[2] + offsets[2]


@njit(nogil=True, cache=True)
def integers_from_coordinates(points, offsets, scales, x, y, z):  # type: ignore[no-untyped-def]
    """Integers ``x``, ``y``, ``z`` in units of ``scales``; False if 32 bits are not enough."""
    fx, fy, fz = 1 / scales[0], 1 / scales[1], 1 / scales[2]
    for i in range(len(points)):
        a = np.rint((points[i, 0] - offsets[0]) * fx)
        b = np.rint((points[i, 1] - offsets[1]) * fy)
        c = np.rint((points[i, 2] - offsets[2]) * fz)
        if not (abs(a) < 2147483647.0 and abs(b) < 2147483647.0 and abs(c) < 2147483647.0):
            return False
        x[i], y[i], z[i] = np.int32(a), np.int32(b), np.int32(c)
    return True


@njit(nogil=True, cache=True)
def bounds_and_reach(points):  # type: ignore[no-untyped-def]
    """Lowest and highest corner of points, and largest squared distance from the origin."""
    low, high, farthest = np.full(3, np.inf), np.full(3, -np.inf), 0.0
    for i in range(len(points)):
        square = 0.0
        for axis in range(3):
            value = points[i, axis]
            low[axis] = min(low[axis], value)
            high[axis] = max(high[axis], value)
            square += value * value
        farthest = max(farthest, square)
    return low, high, farthest
