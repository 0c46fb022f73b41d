"""Tests of triangular systems of a banded matrix against SciPy."""

import hypothesis.strategies as st
import numpy as np
import pytest
import scipy.linalg
from hypothesis import given

from lispac.adjustment.solve.banded_cholesky import (
    back_substitution,
    cholesky_factor,
    forward_substitution,
)


def banded(n: int, width: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Positive definite matrix and its lower diagonals."""
    random = np.random.default_rng(seed)
    lower = np.tril(np.triu(random.normal(size=(n, n)), 1 - width), -1)
    lower += np.diag(random.uniform(1, 3, n))
    whole = lower @ lower.T
    band = np.zeros((width, n))
    for k in range(min(width, n)):
        band[k, : n - k] = np.diagonal(whole, -k)
    return whole, band


@given(
    n=st.integers(1, 40), width=st.integers(1, 13), many=st.integers(0, 5), seed=st.integers(0, 999)
)
def test_solutions_agree_with_those_of_the_dense_matrix(
    n: int, width: int, many: int, seed: int
) -> None:
    whole, band = banded(n, width, seed)
    right = np.random.default_rng(seed + 1).normal(size=(n, many))
    right_before = right.copy()
    factor, root = cholesky_factor(band), np.linalg.cholesky(whole)
    half = forward_substitution(factor, right)
    assert half == pytest.approx(scipy.linalg.solve_triangular(root, right, lower=True), rel=1e-6)
    solution = back_substitution(factor, half)
    assert solution == pytest.approx(np.linalg.solve(whole, right), rel=1e-6, abs=1e-9)
    assert solution == pytest.approx(
        scipy.linalg.cho_solve_banded((factor, True), right), rel=1e-9, abs=1e-12
    )
    assert np.array_equal(right, right_before)


def test_one_right_hand_side_and_any_memory_order_are_accepted() -> None:
    whole, band = banded(30, 12, seed=5)
    factor = cholesky_factor(band)
    right = np.random.default_rng(6).normal(size=(4, 30))
    all_at_once = back_substitution(factor, forward_substitution(factor, right.T))
    one = back_substitution(factor, forward_substitution(factor, right[2]))
    assert one.shape == (30,)
    assert one == pytest.approx(all_at_once[:, 2], rel=1e-12)
    assert whole @ one == pytest.approx(right[2])


def test_a_matrix_that_is_not_positive_definite_is_refused() -> None:
    _, band = banded(10, 3, seed=7)
    band[0, 4] = -1.0
    with pytest.raises(np.linalg.LinAlgError):
        cholesky_factor(band)
    band[0, 4] = np.nan
    with pytest.raises(ValueError, match="infs or NaNs"):
        cholesky_factor(band)
