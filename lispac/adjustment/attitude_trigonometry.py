"""Cosines and sines of the attitudes, computed once for all iterations."""

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.parallel_chunks import run_in_chunks
from lispac.compiled_code import kernel

Array = NDArray[np.float64]


def attitude_cosines_sines(attitude: Array) -> Array:
    """Cosine and sine of roll, pitch and heading.

    Parameters
    ----------
    attitude : ndarray of shape (n, 3), radians

    Returns
    -------
    ndarray of shape (n, 6)
    """
    turns = np.empty((len(attitude), 6))
    run_in_chunks(
        lambda first, last: _fill_cosines_sines(first, last, attitude, turns),
        np.arange(1, len(attitude) + 1),
    )
    return turns


@kernel()
def _fill_cosines_sines(first, last, attitude, turns):  # type: ignore[no-untyped-def]
    for i in range(first, last):
        for k in range(3):
            turns[i, 2 * k] = np.cos(attitude[i, k])
            turns[i, 2 * k + 1] = np.sin(attitude[i, k])
