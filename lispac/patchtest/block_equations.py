"""Normal equations of each block of points, and their derivatives by errors of the POS."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.patchtest.line_mismatch import Mismatch, SurfaceDistances, has_enough_overlap

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class BlockEquations:
    """Normal equations of each block, linearised at one boresight.

    For a small change ``x`` of the boresight (radians), half the robust mean square distance of a
    block changes by ``g' x + x' N x / 2``, with the gradient ``g`` and the normal matrix ``N``.

    Attributes
    ----------
    normal : ndarray of shape (b, 3, 3), square metres per square radian
    gradient : ndarray of shape (b, 3), square metres per radian
    pos_derivatives : ndarray of shape (b, 2, 3, 6)
        Derivatives of the gradient by the POS errors of the first and of the second line: position
        (metres, local frame), roll, pitch and heading (radians).
    overlaps : ndarray of shape (b,), bool
        Whether enough points of the block have a match in the other line. Blocks without enough
        matches are not used, and their equations are zero.
    """

    normal: Array
    gradient: Array
    pos_derivatives: Array
    overlaps: NDArray[np.bool_]


def linearise_blocks(
    mismatch: Mismatch, boresight: Array, *, pos_errors: bool = False
) -> BlockEquations:
    """Compute the normal equations of all blocks at one boresight.

    Parameters
    ----------
    boresight : ndarray of shape (3,), radians
    pos_errors : bool
        Also compute the derivatives by the POS errors; they are zero otherwise.
    """
    sample = mismatch.sample
    moves = sample.boresight_derivatives(boresight).transpose(1, 2, 0)
    pos_moves = sample.pos_error_derivatives(boresight).transpose(1, 2, 0) if pos_errors else None
    block_count = len(mismatch.blocks)
    normal, gradient = np.zeros((block_count, 3, 3)), np.zeros((block_count, 3))
    by_pos, overlaps = np.zeros((block_count, 2, 3, 6)), np.zeros(block_count, dtype=bool)
    for k, (block, both) in enumerate(
        zip(mismatch.blocks, mismatch.block_distances(boresight), strict=True)
    ):
        total = sum(each.matched_points for each in both)
        if not has_enough_overlap(both):
            continue
        overlaps[k] = True
        for way, found in enumerate(both):
            side = way % 2
            own, other = (block.second, block.first) if side else (block.first, block.second)
            point, matched = found.point + own.begin, found.matched + other.begin
            move = np.einsum("nj,njk->nk", found.normal, moves[point] - moves[matched])
            weight = _robust_weights(found, mismatch.scale) / total
            normal[k] += (move * weight[:, None]).T @ move
            gradient[k] += (weight * found.off) @ move
            if pos_moves is not None:
                for moved_side, sign, rows in ((side, 1.0, point), (1 - side, -1.0, matched)):
                    tilt = np.einsum("nj,njk->nk", found.normal, pos_moves[rows])
                    by = sign * np.hstack([found.normal, tilt])
                    by_pos[k, moved_side] += (move * weight[:, None]).T @ by
    return BlockEquations(normal, gradient, by_pos, overlaps)


def _robust_weights(distances: SurfaceDistances, scale: float) -> Array:
    return np.asarray(distances.weight / (1.0 + (distances.off / scale) ** 2) ** 2)
