"""Adjustment problem between two iterations: points, model, unknowns, and the next step."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.control import Control
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.robust_loss import Loss
from lispac.adjustment.model.stochastic_model import PosErrorKnots, StochasticModel
from lispac.adjustment.model.target_shapes import (
    apply_shape_changes,
    centres_and_extents,
    moments_by_sighting,
    plane_tangents,
    sphere_tangent,
    surface_tangents,
)
from lispac.adjustment.solve.control_equations import ControlEquations, linearise_control
from lispac.adjustment.solve.group_sums import (
    AdjustmentState,
    PointGroups,
    PointWeights,
    compute_residuals,
    group_points,
    sum_by_group,
)
from lispac.adjustment.solve.normal_equations import (
    NormalEquations,
    UnknownBases,
    UnknownsOrder,
    assemble_normal_equations,
    sum_by_sighting,
    unknown_directions,
)
from lispac.errors import TargetDisagrees
from lispac.messages import error
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

NO_LOSS = Loss("none")

ALL_COMPONENTS, TILT_COMPONENTS, OFFSET_COMPONENT = slice(0, 3), slice(0, 2), slice(2, 3)
"""Components of the deviation of a sighting from the shape of its target: two tilts, one offset."""

INITIAL_SURFACE_SIGMA = 0.003
"""Sigma of the form errors before it is estimated, metres."""

REJECTED_SIGMA = 10.0
"""Sigma of the tilts and the offset of a rejected sighting, metres.

With this large value, the sighting remains in the equations but has no influence.
"""


@dataclass(frozen=True, eq=False)
class AdjustmentProblem:
    """Data and model that stay the same from iteration to iteration.

    Attributes
    ----------
    observations : Observations
        Observations sorted by group.
    groups : PointGroups
    model : StochasticModel
    prior : Mounting
    parameters : tuple of Parameter
        Values to estimate besides the boresight.
    surface_sigma : ndarray of shape (sightings, 3), metres
        Sigmas of the two tilts (at the border) and of the offset of each sighting;
        `REJECTED_SIGMA` for rejected ones.
    rejected : ndarray of shape (sightings, 3), bool
        Whether each tilt and offset is rejected: the offset of a shifted sighting, all three of a
        sighting on another surface. A sighting with a rejected offset is a rejected sighting.
    scale : ndarray of shape (targets,)
        Robust scale of the standardised residuals, used by the loss function.
    noise : ndarray of shape (targets,)
        Ratio of the noise of the points to the given one.
    blocks : ndarray of shape (n,), int
        Block of each point on the surface of its sighting; empty if not computed.
    moments : ndarray of shape (sightings, 4, 4)
        Sums of the products of (x, y, z, 1), metres, with the prior mounting. They give the centre
        and the extent of each sighting. All points have equal weights, so that the definition of a
        tilt does not depend on the weights.
    own_offsets : bool
        Whether a sigma of the offsets is estimated separately from that of the tilts.
    known_noise : bool
        Whether the noise is given; otherwise it is estimated from the residuals.
    """

    observations: Observations
    groups: PointGroups
    model: StochasticModel
    prior: Mounting
    parameters: tuple[Parameter, ...]
    surface_sigma: Array
    rejected: NDArray[np.bool_]
    scale: Array
    noise: Array
    blocks: NDArray[np.int64]
    moments: Array
    own_offsets: bool = False
    known_noise: bool = False

    @classmethod
    def of(
        cls,
        observations: Observations,
        prior: Mounting,
        model: StochasticModel,
        parameters: tuple[Parameter, ...] = (),
        moments: Array | None = None,
    ) -> "AdjustmentProblem":
        """Create the problem: sort the points and create the knots of the POS error.

        Parameters
        ----------
        moments : ndarray of shape (sightings, 4, 4), optional
            Result of `moments_by_sighting`, if already computed.
        """
        if moments is None:
            moments = moments_by_sighting(observations, prior)
        knots = PosErrorKnots.of(observations, model) if model.correlated else None
        ordered, groups = group_points(observations, knots)
        surface = INITIAL_SURFACE_SIGMA if model.surface is None else model.surface
        sigma = np.full((len(observations.sightings), 3), surface)
        if model.offset is not None:
            sigma[:, 2] = model.offset
        ones = np.ones(len(observations.targets))
        return cls(
            ordered, groups, model, prior, parameters, sigma,
            rejected=np.zeros(sigma.shape, dtype=bool), scale=ones, noise=ones,
            blocks=np.zeros(0, dtype=np.int64), moments=moments,
        )  # fmt: skip

    def with_observations(self, observations: Observations) -> "AdjustmentProblem":
        """Problem with other points of the same sightings; their blocks are not computed."""
        problem = AdjustmentProblem.of(
            observations, self.prior, self.model, self.parameters, self.moments
        )
        return replace(
            problem,
            surface_sigma=self.surface_sigma,
            rejected=self.rejected,
            scale=self.scale,
            noise=self.noise,
            own_offsets=self.own_offsets,
            known_noise=self.known_noise,
        )

    @cached_property
    def active(self) -> NDArray[np.int64]:
        """Indices of the estimated values of the mounting, shape (a,)."""
        return np.array([0, 1, 2, *sorted(p.index for p in self.parameters)], dtype=np.int64)

    @cached_property
    def layout(self) -> UnknownsOrder:
        """Order of the unknowns."""
        radii = self.observations.radii
        widths = [
            4 if target in radii and radii[target] is None else 3
            for target in self.observations.targets
        ]
        owners = self.observations.target_of_sighting
        has_surfaces = self.model.correlated and self.model.surface != 0
        return UnknownsOrder.of(self.active, widths, owners, surfaces=has_surfaces)

    def with_known_noise(self, noise: Mapping[str, float] | None) -> "AdjustmentProblem":
        """Problem with a given noise of each target, as in `TargetResidual`; unchanged if None."""
        if noise is None:
            return self
        factors = np.array([noise[target] for target in self.observations.targets])
        return replace(self, noise=factors, known_noise=True)

    @property
    def rejected_sightings(self) -> NDArray[np.bool_]:
        """Whether each sighting is rejected, shape (sightings,)."""
        return self.rejected[:, 2]

    @property
    def default_surface_sigmas(self) -> Array:
        """Sigmas of tilts and offset of sightings that are not rejected, shape (3,), metres."""
        return np.asarray(self.surface_sigma.min(axis=0, where=~self.rejected, initial=np.inf))

    @property
    def has_own_offsets(self) -> bool:
        """Whether the offsets have a sigma different from that of the tilts."""
        return self.own_offsets or self.model.offset is not None

    def with_surface_sigma(self, sigma: float | Array) -> "AdjustmentProblem":
        """Problem with another surface sigma for all tilts and offsets that are not rejected.

        Parameters
        ----------
        sigma : float or ndarray of shape (3,), metres
            One sigma for tilts and offset, or one for each.
        """
        return replace(self, surface_sigma=np.where(self.rejected, REJECTED_SIGMA, sigma))

    def with_sighting_surface_sigma(
        self, sightings: Sequence[int], sigma: float | Array
    ) -> "AdjustmentProblem":
        """Problem with another surface sigma for some sightings.

        Parameters
        ----------
        sigma : float or ndarray of shape (3,), metres
            One sigma for tilts and offset, or one for each.
        """
        changed = self.surface_sigma.copy()
        changed[list(sightings)] = sigma
        return replace(self, surface_sigma=changed)

    def with_rejected(
        self, sightings: Sequence[int], directions: slice = ALL_COMPONENTS
    ) -> "AdjustmentProblem":
        """Problem with the tilts (0, 1) and/or the offset (2) of some sightings rejected."""
        return self._with_rejection(sightings, directions, REJECTED_SIGMA, rejected=True)

    def with_restored(
        self, sightings: Sequence[int], directions: slice = ALL_COMPONENTS
    ) -> "AdjustmentProblem":
        """Problem with the rejected tilts (0, 1) and/or offset (2) of some sightings restored."""
        usual = self.default_surface_sigmas[directions]
        return self._with_rejection(sightings, directions, usual, rejected=False)

    def _with_rejection(
        self, sightings: Sequence[int], directions: slice, sigma: float | Array, *, rejected: bool
    ) -> "AdjustmentProblem":
        mask, sigmas = self.rejected.copy(), self.surface_sigma.copy()
        mask[list(sightings), directions], sigmas[list(sightings), directions] = rejected, sigma
        return replace(self, rejected=mask, surface_sigma=sigmas)

    def start(self, mounting: Mounting, shapes: Array) -> AdjustmentState:
        """Initial state without form and POS errors; ``shapes`` of shape (targets, 4)."""
        knots = 0 if self.groups.knots is None else len(self.groups.knots.time)
        sightings = len(self.observations.sightings)
        return AdjustmentState(mounting, shapes, np.zeros((sightings, 4)), np.zeros((knots, 6)))

    def resume_state(self, state: AdjustmentState, of: "AdjustmentProblem") -> AdjustmentState:
        """Transfer the state of another problem of the same sightings to this one."""
        here, there = self.groups.knots, of.groups.knots
        pos_corrections = state.pos_corrections
        if here is not None and there is not None:
            columns = [np.interp(here.time, there.time, column) for column in pos_corrections.T]
            pos_corrections = np.stack(columns, axis=1)
        return replace(state, pos_corrections=pos_corrections)

    def with_scaled_sigmas(
        self, lidar: float, position: float, attitude: float
    ) -> "AdjustmentProblem":
        """Problem with factors applied to the given sigmas.

        Parameters
        ----------
        lidar, position, attitude : float
            Factors, no unit.
        """
        return self.with_observations(
            self.observations.with_scaled_sigmas(lidar, position, attitude)
        )

    def with_control(self, control: Control | None) -> "AdjustmentProblem":
        """Problem with other control, or without control."""
        return replace(self, observations=replace(self.observations, control=control))

    def with_parameters(self, parameters: tuple[Parameter, ...]) -> "AdjustmentProblem":
        """Problem with other values to estimate."""
        return replace(self, parameters=parameters)

    def linearised(
        self, state: AdjustmentState, loss: Loss = NO_LOSS, *, tangent: bool = False
    ) -> "LinearisedProblem":
        """Linearise at ``state``; ``tangent`` as in `PointWeights`."""
        weights = PointWeights(loss, self.scale, self.noise, tangent)
        sums = sum_by_group(self.observations, self.groups, state, self.active, weights)
        bases = self._unknown_bases(state, self.sums_by_sighting(sums))
        # Deviation of each sighting in the basis of this state
        departures = np.einsum("sij,sj->si", np.linalg.pinv(bases.surfaces), state.surface)
        return LinearisedProblem(self, state, loss, sums, bases, departures)

    def build_equations(
        self, state: AdjustmentState, sums: Array, bases: UnknownBases, departures: Array
    ) -> NormalEquations:
        """Build the normal equations from sums over groups, with all priors.

        Parameters
        ----------
        sums : ndarray of shape (groups, width, width)
            From `sum_by_group`.
        departures : ndarray of shape (sightings, 3), metres
            As in `LinearisedProblem`.
        """
        owners = self.observations.target_of_sighting
        summed = self.sums_by_sighting(sums)
        normal = assemble_normal_equations(
            sums, summed, self.groups, self.layout, owners, bases, state.pos_corrections
        )
        matrix, right, quadratic = normal.matrix, normal.right, normal.quadratic
        for parameter in self.parameters:
            if parameter.sigma is None:
                continue
            k = int(np.searchsorted(self.active, parameter.index))
            off = state.mounting.values[parameter.index] - self.prior.values[parameter.index]
            matrix[k, k] += parameter.sigma**-2
            right[k] -= off * parameter.sigma**-2
            quadratic += (off / parameter.sigma) ** 2
        if self.layout.surfaces:
            places = np.arange(self.layout.surfaces[0].start, self.layout.size)
            precision = self.surface_sigma.reshape(-1) ** -2.0
            found = departures.reshape(-1)
            matrix[places, places] += precision
            right[places] -= found * precision
            quadratic += float((found * precision) @ found)
        if (control := self.control_equations(state, summed, bases)) is not None:
            matrix += control.matrix
            right += control.right
            quadratic += control.quadratic
        return replace(normal, quadratic=quadratic)

    def control_equations(
        self, state: AdjustmentState, summed: Array, bases: UnknownBases
    ) -> ControlEquations | None:
        """Equations of the control of all targets that have points; None if there are none.

        Parameters
        ----------
        summed : ndarray of shape (sightings, a + 5, a + 5)
            From `sums_by_sighting`.
        """
        if self.observations.control is None:
            return None
        offset = len(self.active) + 3  # the column whose square is the weight of a point
        weights = np.bincount(
            self.observations.target_of_sighting,
            summed[:, offset, offset],
            len(self.observations.targets),
        )
        return linearise_control(
            self.observations, state.shapes, bases.shapes, self.layout.shapes, self.layout.size,
            weights > 0,
        )  # fmt: skip

    def sums_by_sighting(self, sums: Array) -> Array:
        """Sum the groups of each sighting, without the columns of the POS error.

        Parameters
        ----------
        sums : ndarray of shape (groups, width, width)

        Returns
        -------
        ndarray of shape (sightings, a + 5, a + 5)
        """
        own = len(self.active) + 4
        return sum_by_sighting(sums, self.groups, len(self.observations.sightings), own)

    def _unknown_bases(self, state: AdjustmentState, summed: Array) -> UnknownBases:
        observations, own = self.observations, slice(len(self.active), len(self.active) + 4)
        owners = observations.target_of_sighting
        whole = np.zeros((len(state.shapes), 4, 4))
        np.add.at(whole, owners, summed[:, own, own])
        without = np.flatnonzero(whole[:, 3, 3] <= 0)
        if len(without):
            name = observations.targets[without[0]]
            raise TargetDisagrees(error("adjustment.target_disagrees", target=name), name)
        planes = plane_tangents(state.shapes[:, :3], centres_and_extents(whole)[0])
        shapes = [
            sphere_tangent(known_radius=observations.radii[target] is not None)
            if target in observations.radii
            else plane
            for target, plane in zip(observations.targets, planes, strict=True)
        ]
        normals, spheres = state.shapes[owners, :3], observations.is_sphere[owners]
        return UnknownBases(shapes, surface_tangents(normals, self.moments, spheres))

    def residuals(self, state: AdjustmentState) -> Array:
        """Distances (metres) and standardised residuals, shape (2, n), in the sorted order."""
        return compute_residuals(self.observations, self.groups, state)


@dataclass(frozen=True, eq=False)
class LinearisedProblem:
    """Problem linearised at one state: sums over its points, and normal equations.

    Attributes
    ----------
    sums : ndarray of shape (groups, width, width)
        From `sum_by_group`.
    departures : ndarray of shape (sightings, 3), metres
        Current tilts (at the border) and offset of each sighting.
    """

    problem: AdjustmentProblem
    state: AdjustmentState
    loss: Loss
    sums: Array
    bases: UnknownBases
    departures: Array

    @cached_property
    def normal(self) -> NormalEquations:
        """Normal equations of all points."""
        return self.problem.build_equations(self.state, self.sums, self.bases, self.departures)

    @cached_property
    def control(self) -> ControlEquations | None:
        """Equations of the control, which are part of ``normal``; None without control."""
        summed = self.problem.sums_by_sighting(self.sums)
        return self.problem.control_equations(self.state, summed, self.bases)

    @cached_property
    def directions(self) -> Array:
        """Matrix from unknowns to columns of the sums; see `unknown_directions`."""
        owners = self.problem.observations.target_of_sighting
        return unknown_directions(self.normal.layout, owners, self.bases)

    @cached_property
    def tangent(self) -> "LinearisedProblem":
        """Same state linearised with updated weights (``tangent`` of `PointWeights`)."""
        return self.problem.linearised(self.state, self.loss, tangent=True)

    def normal_without_sightings(self, sightings: NDArray[np.bool_]) -> NormalEquations:
        """Normal equations without some sightings, shape (sightings,)."""
        return self.normal_without_groups(sightings[self.problem.groups.sighting])

    def normal_without_groups(self, groups: NDArray[np.bool_]) -> NormalEquations:
        """Normal equations without some groups of points, shape (groups,)."""
        kept = self.sums * ~groups[:, None, None]
        return self.problem.build_equations(self.state, kept, self.bases, self.departures)

    def of(self, problem: AdjustmentProblem) -> "LinearisedProblem":
        """Use the same sums with the surface sigmas of another problem of the same points."""
        return replace(self, problem=problem)

    def next_state(self) -> tuple[AdjustmentState, Array]:
        """Solve the equations, and return the next state and the corrections, shape (u,).

        Raises
        ------
        LinAlgError
            The corrections are not finite, because the iteration diverges.
        """
        problem, state, layout = self.problem, self.state, self.normal.layout
        correction, change = self.normal.solve()
        if not (np.isfinite(correction).all() and np.isfinite(change).all()):
            raise np.linalg.LinAlgError
        values = state.mounting.values
        values[layout.active] += correction[: len(layout.active)]
        pairs = zip(self.bases.shapes, layout.shapes, strict=True)
        changes = np.stack([basis @ correction[place] for basis, place in pairs])
        surface = state.surface
        if layout.surfaces:
            departures = self.departures + correction[layout.surfaces[0].start :].reshape(-1, 3)
            surface = np.einsum("sij,sj->si", self.bases.surfaces, departures)
        new = AdjustmentState(
            state.mounting.with_values(values),
            apply_shape_changes(state.shapes, changes, problem.observations.is_sphere),
            surface,
            state.pos_corrections + change,
        )
        return new, correction
