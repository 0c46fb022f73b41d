"""Normal equations: assembly from the sums, reduction and solution.

The unknowns are the estimated values of the mounting and the shapes of the targets. The correlated
model adds the deviation of each sighting from the shape of its target (its "surface"), and the POS
error at the knots. The POS error is eliminated first. Its normal matrix is banded, since a group of
points and the Gauss-Markov prior couple only neighbouring knots. With independent POS errors there
are neither surfaces nor knots; the equations are then thesis equation B.8, and the covariance is
B.12.
"""

from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np
import scipy
from numpy.typing import NDArray

from lispac.adjustment.solve.banded_cholesky import (
    back_substitution,
    cholesky_factor,
    forward_substitution,
    tridiagonal_inverse_blocks,
)
from lispac.adjustment.solve.group_sums import PointGroups
from lispac.adjustment.solve.surface_elimination import nonzero_spans, subtract_surfaces
from lispac.errors import RankDeficient
from lispac.messages import error

Array = NDArray[np.float64]

_LOWER_TRIANGLE = np.tril_indices(12)


@dataclass(frozen=True, eq=False)
class UnknownsOrder:
    """Order of the unknowns in the normal equations.

    Attributes
    ----------
    active : ndarray of shape (a,), int
        Indices of the estimated values of the mounting; they are the first unknowns, starting with
        the boresight.
    shapes : tuple of slice
        Unknowns of the shape of each target.
    surfaces : tuple of slice
        Unknowns of the surface of each sighting; empty with independent POS errors.
    size : int
        Number of unknowns.
    index : ndarray of shape (sightings, a + 7), int
        Unknowns of each sighting: mounting (a), shape (4), surface (3); ``size`` for those that do
        not exist.
    """

    active: NDArray[np.int64]
    shapes: tuple[slice, ...]
    surfaces: tuple[slice, ...]
    size: int
    index: NDArray[np.int64]

    @classmethod
    def of(
        cls,
        active: NDArray[np.int64],
        widths: list[int],
        target_of_sighting: NDArray[np.int64],
        *,
        surfaces: bool,
    ) -> "UnknownsOrder":
        """Arrange ``active`` (a,), shapes of the given widths, and three unknowns per sighting.

        Parameters
        ----------
        target_of_sighting : ndarray of shape (sightings,), int
        """
        ends = len(active) + np.cumsum([0, *widths])
        shapes = tuple(slice(int(a), int(b)) for a, b in pairwise(ends))
        count = len(target_of_sighting)
        first = int(ends[-1])
        size = first + (3 * count if surfaces else 0)
        index = np.full((count, len(active) + 7), size, dtype=np.int64)
        index[:, : len(active)] = np.arange(len(active))
        for s, k in enumerate(target_of_sighting):
            own = np.arange(shapes[k].start, shapes[k].stop)
            index[s, len(active) : len(active) + len(own)] = own
            if surfaces:
                index[s, len(active) + 4 :] = first + 3 * s + np.arange(3)
        slices = (slice(first + 3 * s, first + 3 * s + 3) for s in range(count if surfaces else 0))
        return cls(active, shapes, tuple(slices), size, index)


MAX_UNELIMINATED_SURFACES = 24
"""Largest number of sightings for which it is faster not to eliminate the surfaces first."""


@dataclass(frozen=True, eq=False)
class NormalEquations:
    """Normal equations at one point of linearisation.

    Attributes
    ----------
    layout : UnknownsOrder
    matrix : ndarray of shape (u, u)
        Normal matrix of all unknowns except the POS error, including their priors.
    right : ndarray of shape (u,)
        Right-hand side of these unknowns.
    quadratic : float
        ``v' P v`` at the point of linearisation, including the priors.
    band : ndarray of shape (12, 6 knots)
        Lower diagonals of the normal matrix of the POS error, in the format of LAPACK.
    mixed : ndarray of shape (u, 6 knots)
        Block of the normal matrix between these unknowns and the POS error.
    pos_right : ndarray of shape (6 knots,)
        Right-hand side of the POS error.
    """

    layout: UnknownsOrder
    matrix: Array
    right: Array
    quadratic: float
    band: Array
    mixed: Array
    pos_right: Array

    @cached_property
    def factor(self) -> Array:
        """Cholesky factor ``L`` of ``band``, in the same shape."""
        return cholesky_factor(self.band)

    @cached_property
    def whitened_mixed(self) -> Array:
        """``L^-1 mixed'``, shape (6 knots, u); its product with itself reduces the matrix."""
        return forward_substitution(self.factor, self.mixed.T)

    @cached_property
    def whitened_pos_right(self) -> Array:
        """``L^-1`` times ``pos_right``, shape (6 knots,)."""
        return forward_substitution(self.factor, self.pos_right)

    @cached_property
    def pos_error_by_unknowns(self) -> Array:
        """Minus the derivative of the POS error by each other unknown, shape (6 knots, u)."""
        return back_substitution(self.factor, self.whitened_mixed)

    @cached_property
    def reduced_matrix(self) -> Array:
        """Normal matrix with the POS error eliminated, shape (u, u)."""
        if not len(self.pos_right):
            return self.matrix
        reduced = self.matrix - self.whitened_mixed.T @ self.whitened_mixed
        return np.asarray((reduced + reduced.T) / 2)

    @cached_property
    def reduced_right_side(self) -> Array:
        """Right-hand side with the POS error eliminated, shape (u,)."""
        return (
            self.right - self.whitened_mixed.T @ self.whitened_pos_right
            if len(self.pos_right)
            else self.right
        )

    @cached_property
    def covariance(self) -> Array:
        """Covariance of all unknowns except the POS error, shape (u, u).

        Raises
        ------
        RankDeficient
            The points do not determine the unknowns.
        """
        return self._scaled_factor.inverse()

    @cached_property
    def knot_covariance(self) -> tuple[Array, Array]:
        """Covariance of the POS error for known other unknowns; `tridiagonal_inverse_blocks`.

        The band must be that of neighbouring knots, as before `eliminate_surfaces`.
        """
        return tridiagonal_inverse_blocks(self.band)

    @cached_property
    def pos_error_variances(self) -> tuple[Array, Array]:
        """Variance of the POS error at each knot, and covariance with the next one.

        Both are per component and include the uncertainty of all other unknowns.

        Returns
        -------
        own : ndarray of shape (knots, 6), metres and radians squared
        beside : ndarray of shape (knots - 1, 6), metres and radians squared
        """
        own, beside = (np.diagonal(each, axis1=1, axis2=2) for each in self.knot_covariance)
        by_unknowns = self.pos_error_by_unknowns
        spread = by_unknowns @ self.covariance
        return (
            own + (spread * by_unknowns).sum(axis=1).reshape(-1, 6),
            beside + (spread[6:] * by_unknowns[:-6]).sum(axis=1).reshape(-1, 6),
        )

    @cached_property
    def _scaled_factor(self) -> "_ScaledFactor":
        return _ScaledFactor.of(self.reduced_matrix)

    @cached_property
    def eliminate_surfaces(self) -> "NormalEquations":
        """Equations with the surfaces eliminated first; unchanged if that is not faster.

        A surface is coupled only to the knots of its own sighting. The normal matrix of the POS
        error therefore remains banded, with the width of the longest sighting.
        """
        layout = self.layout
        if len(layout.surfaces) <= MAX_UNELIMINATED_SURFACES:
            return self
        first = layout.surfaces[0].start
        spans = nonzero_spans(self.mixed[first:])
        wide = max(len(self.band), int((spans[:, 1] - spans[:, 0]).max()))
        if wide > len(self.matrix):
            return self
        matrix, right = self.matrix[:first, :first].copy(), self.right[:first].copy()
        mixed, pos_right = self.mixed[:first].copy(), self.pos_right.copy()
        band = np.zeros((wide, self.band.shape[1]))
        band[: len(self.band)] = self.band
        quadratic = self.quadratic - subtract_surfaces(
            self.matrix, self.right, self.mixed, spans, matrix, right, mixed, pos_right, band
        )
        layout = replace(layout, surfaces=(), size=first, index=np.minimum(layout.index, first))
        return NormalEquations(layout, matrix, right, quadratic, band, mixed, pos_right)

    def information(self, count: int) -> Array:
        """Normal matrix of the first unknowns, (count, count), with all others eliminated.

        Parameters
        ----------
        count : int
            Number of first unknowns to keep; surfaces are always eliminated.

        Raises
        ------
        RankDeficient
            The points do not determine the shape of a target.
        """
        reduced = self.eliminate_surfaces.reduced_matrix
        rest = reduced[count:, count:].copy()
        without_points = np.flatnonzero(np.diag(rest) <= 0)
        rest[without_points, without_points] = 1.0  # a target without points
        mixed = reduced[:count, count:]
        scale = 1 / np.sqrt(np.maximum(np.diag(rest), np.finfo(float).tiny))
        try:
            factor = scipy.linalg.cho_factor(rest * np.outer(scale, scale))
        except np.linalg.LinAlgError as reason:
            raise RankDeficient(error("adjustment.shape_undetermined")) from reason
        solved = scipy.linalg.cho_solve(factor, (mixed * scale).T)
        information = reduced[:count, :count] - (mixed * scale) @ solved
        return np.asarray((information + information.T) / 2)

    def solve(self) -> tuple[Array, Array]:
        """Corrections of the unknowns, shape (u,), and of the POS error, shape (knots, 6)."""
        return self._solved_corrections

    @cached_property
    def _solved_corrections(self) -> tuple[Array, Array]:
        # Cached, because every blunder test uses it.
        correction = self._scaled_factor.solve(self.reduced_right_side)
        if not len(self.pos_right):
            return correction, np.zeros((0, 6))
        half = self.whitened_pos_right - self.whitened_mixed @ correction
        return correction, back_substitution(self.factor, half).reshape(-1, 6)


@dataclass(frozen=True, eq=False)
class _ScaledFactor:
    """Cholesky factor of a symmetric matrix of mixed units, scaled to a diagonal of ones.

    An iteration only needs the solution, which takes a seventh of the time of the inverse.
    """

    scale: Array
    factor: tuple[Array, bool]

    @classmethod
    def of(cls, matrix: Array) -> "_ScaledFactor":
        """Factor of a matrix of shape (u, u).

        Raises
        ------
        RankDeficient
            If the matrix is singular to working precision.
        """
        diagonal = np.diag(matrix)
        scale = 1 / np.sqrt(np.maximum(diagonal, np.finfo(float).tiny))
        if np.all(diagonal > 0.0):  # with rounding, undetermined unknowns may have zero or less
            with suppress(np.linalg.LinAlgError):
                return cls(scale, scipy.linalg.cho_factor(matrix * np.outer(scale, scale)))
        raise RankDeficient(error("adjustment.singular"))

    def solve(self, right: Array) -> Array:
        """Solution for a right-hand side of shape (u,)."""
        with np.errstate(over="ignore"):  # the caller examines the corrections
            solved = scipy.linalg.cho_solve(self.factor, right * self.scale, check_finite=False)
            return np.asarray(solved * self.scale)

    def inverse(self) -> Array:
        """Inverse of the matrix, shape (u, u).

        Raises
        ------
        RankDeficient
            If it is not finite.
        """
        solved = scipy.linalg.cho_solve(self.factor, np.diag(self.scale))
        with np.errstate(over="ignore"):  # of diverging unknowns, whose elements are nearly zero
            inverse = np.asarray(solved * self.scale[:, None])
        if not np.isfinite(inverse).all():
            raise RankDeficient(error("adjustment.singular"))
        return inverse


def scaled_inverse(matrix: Array) -> Array:
    """Inverse of a symmetric positive definite matrix of mixed units, both of shape (u, u).

    Raises
    ------
    RankDeficient
        If the matrix is singular to working precision.
    """
    return _ScaledFactor.of(matrix).inverse()


@dataclass(frozen=True, eq=False)
class UnknownBases:
    """Tangent vectors that define the unknowns of shapes and surfaces.

    Attributes
    ----------
    shapes : list of ndarray of shape (4, 3) or (4, 4)
        Tangent vectors of the shape of each target, in columns.
    surfaces : ndarray of shape (sightings, 4, 3)
        Tangent vectors of the surface of each sighting, in columns.
    """

    shapes: list[Array]
    surfaces: Array


def unknown_directions(
    layout: UnknownsOrder, target_of_sighting: NDArray[np.int64], bases: UnknownBases
) -> Array:
    """Matrix from the unknowns in ``layout.index`` to the columns of the sums, per sighting.

    Parameters
    ----------
    target_of_sighting : ndarray of shape (sightings,), int

    Returns
    -------
    ndarray of shape (sightings, a + 4, a + 7)
    """
    a = len(layout.active)
    basis = np.zeros((len(layout.index), a + 4, a + 7))
    basis[:, :a, :a] = np.eye(a)
    for s, k in enumerate(target_of_sighting):
        basis[s, a:, a : a + bases.shapes[k].shape[1]] = bases.shapes[k]
    if layout.surfaces:
        basis[:, a:, a + 4 :] = bases.surfaces
    return basis


def _sum_by_place(places: NDArray[np.int64], values: Array, size: int) -> Array:
    """Sum of the values at each place, shape (size,)."""
    return np.bincount(places.reshape(-1), values.reshape(-1), size).astype(float, copy=False)


def sum_by_sighting(sums: Array, groups: PointGroups, sightings: int, unknowns: int) -> Array:
    """Sums of the first ``unknowns`` columns and the misclosure, shape (sightings, n + 1, n + 1).

    Parameters
    ----------
    sums : ndarray of shape (groups, width, width)
        From `sum_by_group`.
    """
    kept = np.r_[:unknowns, sums.shape[1] - 1]
    many = len(kept) ** 2
    places = groups.sighting[:, None] * many + np.arange(many)
    values = sums[:, kept[:, None], kept]
    return _sum_by_place(places, values, sightings * many).reshape(
        sightings, unknowns + 1, unknowns + 1
    )


def assemble_normal_equations(
    sums: Array, summed: Array, groups: PointGroups, layout: UnknownsOrder,
    target_of_sighting: NDArray[np.int64], bases: UnknownBases, pos_corrections: Array,
) -> NormalEquations:  # fmt: skip
    """Assemble the normal equations with the prior of the POS error, but without other priors.

    Parameters
    ----------
    sums : ndarray of shape (groups, width, width)
        From `sum_by_group`.
    summed : ndarray of shape (sightings, a + 5, a + 5)
        The same sums from `sum_by_sighting`.
    target_of_sighting : ndarray of shape (sightings,), int
    pos_corrections : ndarray of shape (knots, 6), metres and radians
        Current POS error.
    """
    own = len(layout.active) + 4
    wide, unknowns = layout.size + 1, pos_corrections.size
    basis = unknown_directions(layout, target_of_sighting, bases)
    transposed_basis = np.swapaxes(basis, 1, 2)
    index = layout.index
    squares = index[:, :, None] * wide + index[:, None, :]
    matrix = _sum_by_place(
        squares, transposed_basis @ summed[:, :own, :own] @ basis, wide**2
    ).reshape(wide, wide)
    right = _sum_by_place(index, -(transposed_basis @ summed[:, :own, own, None])[..., 0], wide)
    quadratic = float(summed[:, own, own].sum())
    band, pos_right = np.zeros((12, unknowns)), np.zeros(unknowns)
    mixed = np.zeros((wide, unknowns))
    if groups.knots is not None:
        prior = groups.knots.apply_prior_precision(pos_corrections)
        own_knots = 6 * groups.knot[:, None] + np.arange(12)
        pose = slice(own, own + 12)
        lower, upper = _LOWER_TRIANGLE
        places = (lower - upper) * unknowns + own_knots[:, upper]
        products = sums[:, pose, pose][:, lower, upper]
        band = _sum_by_place(places, products, 12 * unknowns).reshape(12, unknowns)
        band[0] += groups.knots.precision_diagonal.reshape(-1)
        band[6, : unknowns - 6] += groups.knots.precision_beside.reshape(-1)
        pos_right = _sum_by_place(own_knots, -sums[:, pose, -1], unknowns) - prior.reshape(-1)
        quadratic += float((prior * pos_corrections).sum())
        shared = index[groups.sighting][:, :, None] * unknowns + own_knots[:, None, :]
        crossed = transposed_basis[groups.sighting] @ sums[:, :own, pose]
        mixed = _sum_by_place(shared, crossed, wide * unknowns).reshape(wide, unknowns)
    return NormalEquations(
        layout, matrix[:-1, :-1], right[:-1], quadratic, band, mixed[:-1], pos_right
    )
