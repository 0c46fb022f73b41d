"""Parameters of tests that are tested in long runs only."""

from collections.abc import Callable, Iterable
from typing import Any

import pytest

LONG = pytest.mark.long


def others_long(values: Iterable[Any], short: int | Callable[[Any], bool] = 1) -> list[Any]:
    """Parameters of which every run tests some, and long runs the others.

    Parameters
    ----------
    values : iterable
        Values of a parameter; a tuple has one value for each of several parameters.
    short : int or callable, default 1
        Number of first values that every run tests, or whether a value is one of them.
    """
    made = []
    for k, value in enumerate(values):
        is_short = short(value) if callable(short) else k < short
        each = value if isinstance(value, tuple) else (value,)
        made.append(pytest.param(*each, marks=() if is_short else LONG))
    return made
