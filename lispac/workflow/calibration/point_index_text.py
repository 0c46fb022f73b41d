"""Point indices as compact text: ``12+40 60`` means 12 to 51 and 60."""

import re
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error

_RUN_PATTERN = re.compile(r"(\d{1,15})(?:\+(\d{1,9}))?")
"""First index and, after a plus sign, the number of consecutive indices."""
MAX_POINTS = 10**9
"""Largest number of points that a text may list."""


def numbers_text(indices: NDArray[np.int64]) -> str:
    """Convert indices to text in their order; runs of consecutive indices as first and count.

    Parameters
    ----------
    indices : ndarray of shape (n,), int64
    """
    if not len(indices):
        return ""
    starts = np.flatnonzero(np.concatenate([[True], np.diff(indices) != 1]))
    counts = np.diff([*starts, len(indices)])
    return " ".join(
        f"{first}+{count}" if count > 1 else f"{first}"
        for first, count in zip(indices[starts].tolist(), counts.tolist(), strict=True)
    )


def point_numbers(text: str) -> NDArray[np.int64]:
    """Parse a text written by `numbers_text`.

    Returns
    -------
    ndarray of shape (n,), int64

    Raises
    ------
    InputError
        If the text lists too many points or is not valid.
    """
    runs = list(_parse_runs(text))
    if sum(count for _, count in runs) > MAX_POINTS:
        raise InputError(error("pick.too_many_numbers", limit=MAX_POINTS))
    ranges = [np.arange(first, first + count, dtype=np.int64) for first, count in runs]
    return np.concatenate([np.zeros(0, np.int64), *ranges])


def _parse_runs(text: str) -> Iterator[tuple[int, int]]:
    for word in text.split():
        found = _RUN_PATTERN.fullmatch(word)
        if found is None:
            raise InputError(error("pick.not_a_number", text=word[:40]))
        yield int(found[1]), int(found[2] or 1)
