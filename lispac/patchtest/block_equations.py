"""Normal equations of the distances in blocks, and effects of POS errors on them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.patchtest.line_mismatch import Mismatch, SurfaceDistances, has_enough_overlap

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class BlockEquations:
    """Of each block, at one boresight; half the mean square is ``g x + x' N x / 2`` near it.

    Attributes
    ----------
    normal : ndarray of shape (b, 3, 3), square metres per square radian
    gradient : ndarray of shape (b, 3), square metres per radian
    sways : ndarray of shape (b, 2, 3, 6)
        How the gradient changes with the POS errors of the first and the second line: position
        (metres, local frame), roll, pitch and heading (radians).
    meets : ndarray of shape (b,), bool
        Whether enough of the block's points meet the other line; other blocks are not used.
    """

    normal: Array
    gradient: Array
    sways: Array
    meets: NDArray[np.bool_]


def linearise_blocks(
    mismatch: Mismatch, boresight: Array, *, pos_errors: bool = False
) -> BlockEquations:
    """Linearise all blocks.

    Parameters
    ----------
    boresight : ndarray of shape (3,), radians
    pos_errors : bool
        Work out how the gradients change with POS errors; zeros stand for that where not.
    """
    sample = mismatch.sample
    moves = sample.boresight_derivatives(boresight).transpose(1, 2, 0)
    sways = sample.pos_error_derivatives(boresight).transpose(1, 2, 0) if pos_errors else None
    many = len(mismatch.blocks)
    normal, gradient = np.zeros((many, 3, 3)), np.zeros((many, 3))
    swayed, meets = np.zeros((many, 2, 3, 6)), np.zeros(many, dtype=bool)
    for k, (block, both) in enumerate(
        zip(mismatch.blocks, mismatch.block_distances(boresight), strict=True)
    ):
        total = sum(each.matched_points for each in both)
        if not has_enough_overlap(both):
            continue
        meets[k] = True
        for way, found in enumerate(both):
            side = way % 2
            own, other = (block.second, block.first) if side else (block.first, block.second)
            point, met = found.point + own.begin, found.met + other.begin
            move = np.einsum("nj,njk->nk", found.normal, moves[point] - moves[met])
            weight = _robust_weights(found, mismatch.scale) / total
            normal[k] += (move * weight[:, None]).T @ move
            gradient[k] += (weight * found.off) @ move
            if sways is not None:
                for moved_side, sign, rows in ((side, 1.0, point), (1 - side, -1.0, met)):
                    tilt = np.einsum("nj,njk->nk", found.normal, sways[rows])
                    by = sign * np.hstack([found.normal, tilt])
                    swayed[k, moved_side] += (move * weight[:, None]).T @ by
    return BlockEquations(normal, gradient, swayed, meets)


def _robust_weights(distances: SurfaceDistances, scale: float) -> Array:
    return np.asarray(distances.weight / (1.0 + (distances.off / scale) ** 2) ** 2)
