"""Result of an adjustment."""

from collections import Counter
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import CommonCoverage, Sighting
from lispac.adjustment.model.parameters import ParameterEstimate
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.former_names import accept_script_names
from lispac.messages import Message
from lispac.survey.georeferencing import Mounting
from lispac.untrusted_values import ArrayShape

Array = NDArray[np.float64]

ANGLES = ("roll", "pitch", "yaw")


@dataclass(frozen=True)
class ChiSquare:
    """Two-sided test of the variance factor against 1 at 95 %."""

    statistic: float
    lower: float
    upper: float

    @property
    def passed(self) -> bool:
        """Whether the statistic lies within its bounds."""
        return self.lower <= self.statistic <= self.upper


@dataclass(frozen=True, eq=False)
class SightingResidual:
    """Distances of one sighting's points to the adjusted surface, and their statistics.

    Attributes
    ----------
    rms_before, rms_after, mean_after : float, metres
        Mounting and surface alone: no POS error is taken off.
    """

    sighting: Sighting
    points: int
    rms_before: float
    rms_after: float
    mean_after: float


@accept_script_names
@dataclass(frozen=True, eq=False)
class SightingReliability:
    """Reliability of a sighting, and whether it agrees (correlated model).

    Attributes
    ----------
    pos_error, pos_sigma, pos_sigma_after : ndarray of shape (6,), metres and radians
        Estimated POS error (north, west, up, roll, pitch, heading) in the middle of the sighting,
        its standard deviation before and after the adjustment.
    shift : float, metres
        Offset of the whole sighting from the result of all others, along the normal, without
        its own prior.
    w : float
        The shift over its standard deviation (Baarda's test); a unit normal variable where the
        sighting has no blunder.
    detectable : float, metres
        Smallest shift that the test finds with 80 % power (minimal detectable bias).
    effect : ndarray of shape (3,), radians
        What a shift of that size that stays unfound does to roll, pitch, yaw.
    redundancy : float
        Mean of the points' redundancy numbers, 0 (unchecked) to 1.
    outliers : int
        Points whose own test is beyond the critical value.
    largest_w : float
        Largest test value among the points.
    largest_at : float or None, seconds
        Time of the point that has it; of an average, the mean of its points. None in results of
        earlier versions.
    point_detectable : float, metres
        Median of the points' minimal detectable biases.
    weight : float
        Mean weight the loss left to the points.
    rejected : bool
        Whether it is a blunder: rejected, or without weight.
    """

    sighting: Sighting
    pos_error: Annotated[Array, ArrayShape(6)]
    pos_sigma: Annotated[Array, ArrayShape(6)]
    pos_sigma_after: Annotated[Array, ArrayShape(6)]
    shift: float
    w: float
    detectable: float
    effect: Annotated[Array, ArrayShape(3)]
    redundancy: float
    outliers: int
    largest_w: float
    point_detectable: float
    weight: float
    rejected: bool
    largest_at: float | None = None


@dataclass(frozen=True, eq=False)
class TargetResidual:
    """Distances of one target's points, over all lines, to one joint surface, metres.

    Before, the surface is the best one through the points placed with the prior boresight.

    Attributes
    ----------
    rms_before, rms_after : float, metres
    plane : ndarray of shape (4,), local frame
        Unit normal and offset (metres); of a sphere centre and radius.
    sphere : bool
    noise : float
        Noise found in the residuals over the given one, at least 1, with what neighbouring points
        have in common; the sigmas of the angles are computed with it (correlated model).
    noise_of_form : float or None
        Noise that form errors of the surface explain, over the given one, at least 1; of planes
        with more than the given noise only.
    """

    target: str
    points: int
    rms_before: float
    rms_after: float
    plane: Annotated[Array, ArrayShape(4)]
    sphere: bool = False
    noise: float = 1.0
    noise_of_form: float | None = None


@dataclass(frozen=True)
class RadiusDiscrepancy:
    """A ball whose radius differs from line to line by more than the noise explains.

    Attributes
    ----------
    target : str
    smallest, largest : float, metres
    cause : str
        With what changed the radii agree: ``roll_sign``, ``pitch_sign``, ``roll_pitch_signs``,
        ``latency`` or ``range_offset``; empty where nothing of that does.
    value : float, seconds or metres
        What has to be added to the latency or the range offset.
    """

    target: str
    smallest: float
    largest: float
    cause: str = ""
    value: float = 0.0


@dataclass(frozen=True)
class UncontrolledObservations:
    """Observations without redundancy: a blunder in them changes the angles and is not detected.

    Attributes
    ----------
    kind : {"line", "target", "sighting", "clustered"}
        A line or a target without which the angles are not determined, a sighting without which
        some of them are known much worse, or targets that stand together as one.
    target, line : str
        Empty where it is not one.
    angles : tuple of str
        That hang on a sighting.
    size : float
        Of ``together``: the largest distance of two targets over their distance from the scanner.
    """

    kind: str
    target: str = ""
    line: str = ""
    angles: tuple[str, ...] = ()
    size: float = 0.0


@dataclass(frozen=True, eq=False)
class Observability:
    """How well the geometry determines the boresight.

    Attributes
    ----------
    eigenvalues : ndarray of shape (3,), per square radian, ascending
        Of the normal matrix of the three angles, all else eliminated.
    directions : ndarray of shape (3, 3)
        Their directions in (roll, pitch, yaw), one a column.
    condition : float
        Largest over smallest eigenvalue.
    sigma_without_line : dict of str to ndarray of shape (3,) or None, radians
        Sigmas of roll, pitch, yaw without a line; None if they could not be computed.
    messages : tuple of Message
        The weakest and the strongest direction first, then what each angle depends on.
    unchecked : tuple of UncontrolledObservations
        What an error of would not show.
    """

    eigenvalues: Annotated[Array, ArrayShape(3)]
    directions: Annotated[Array, ArrayShape(3, 3)]
    condition: float
    sigma_without_line: dict[str, Array | None]
    messages: tuple[Message, ...]
    unchecked: tuple[UncontrolledObservations, ...] = ()


@dataclass(frozen=True)
class VarianceComponent:
    """Variance component: factor on the given sigmas of a group of errors.

    Attributes
    ----------
    name : {"LiDAR", "POS position", "POS attitude"}
    factor : float
    lower, upper : float
        95 % interval by the likelihood.
    applied : bool
        Whether the sigmas were changed by it: raised if the data show larger errors, lowered
        if the whole interval is below 1.
    used : float or None
        Factor by which the sigmas were changed, if any; the adjustment converges a little off
        the one found with it. None in results of earlier versions.
    """

    name: str
    factor: float
    lower: float
    upper: float
    applied: bool = False
    used: float | None = None


@dataclass(frozen=True, eq=False)
class ContradictedParameter:
    """A value of the mounting that is not estimated and that the data contradict.

    Attributes
    ----------
    name : str
        A value of the mounting other than its angles.
    change, sigma : float, radians, metres or seconds
        What the data would add to the given value.
    angle_change : ndarray of shape (3,), radians
        What roll, pitch, yaw would change by with it.
    surface_sigma : float, metres
        Sigma of the surfaces that would be left.
    """

    name: str
    change: float
    sigma: float
    angle_change: Annotated[Array, ArrayShape(3)]
    surface_sigma: float

    @property
    def w(self) -> float:
        """Test value, standard normal where the value is right."""
        return self.change / self.sigma


@dataclass(frozen=True, eq=False)
class PossibleCause:
    """An error that may cause residuals that contradict the model.

    Attributes
    ----------
    kind : str
        A value of the mounting other than its angles (`OPTIONAL_NAMES`), ``line_position``,
        ``line_boresight``, ``line_time``, ``sighting_shift`` or ``sighting_surface``.
    target, line : str
        Where it is; empty where it is everywhere.
    size, sigma : ndarray of shape (k,), radians, metres or seconds
        What the data would add to the given value; of a line's position north, west, up, of a
        boresight roll, pitch, yaw, of a surface two tilts (at its border) and the offset.
    angle_change : ndarray of shape (3,), radians
        What roll, pitch, yaw would change by with it.
    effect : float, metres
        Root mean square of what it does to the distances of all points from their surfaces.
    evidence : float
        Twice the logarithm of the Bayes factor against a model without it.
    """

    kind: str
    target: str
    line: str
    size: Annotated[Array, ArrayShape("k")]
    sigma: Annotated[Array, ArrayShape("k")]
    angle_change: Annotated[Array, ArrayShape(3)]
    effect: float
    evidence: float


@accept_script_names
@dataclass(frozen=True, eq=False)
class AdjustmentResult:
    """Boresight, its uncertainty, and how well the model fits.

    Attributes
    ----------
    mounting : Mounting
        As estimated; values that were not estimated are as they went in.
    prior_boresight : ndarray of shape (3,), radians; roll, pitch, yaw
    estimated : tuple of str
        Names of the estimated values: boresight, and those of ``parameters`` with a number.
    covariance_all : ndarray of shape (e, e), radians, metres, seconds
        Covariance of ``estimated``. Not scaled by the variance factor.
    parameters : tuple of ParameterEstimate
        What became of every value that was switched on besides the boresight.
    path : ndarray of shape (iterations, 3), radians
        Roll, pitch, yaw after each iteration.
    variance_factor : float
        From the given sigmas, times the applied ``components``, before any noise was taken from
        the residuals.
    rms_before, rms_after : float, metres
    surface : float, metres
        Sigma of how the sightings depart from their target's shape; 0 with
        independent POS errors.
    reliability : tuple of SightingReliability
        Empty with independent POS errors.
    components : tuple of VarianceComponent
        Empty if they were not requested.
    elapsed : float, seconds
    excluded_outliers : int
        Points that stood out from their sighting and went into no average.
    contradictions : tuple of ContradictedParameter
        Given values that the data contradict; empty with independent POS errors.
    causes : tuple of tuple of PossibleCause, or None
        Errors behind residuals that contradict the model, from `possible_causes`; None in results
        of earlier versions.
    offset : float or None, metres
        That of their offsets, where the data insist on another one; ``surface`` is that of the
        tilts then.
    angle_sigma_factors : ndarray of shape (3,), or None
        Factors by which the sigmas of the angles were multiplied, because parts of the data scatter
        by more than the model predicts; None where that is not known.
    given_correlation_times : tuple of float, seconds, or None
        Given correlation times of position and attitude, if the residuals required
        the shorter ones of ``model``.
    radius_discrepancies : tuple of RadiusDiscrepancy
        Of the balls.
    excluded_targets : tuple of str
        Targets no point of which agrees with the others. They take no part in the result.
    common_parts : tuple of CommonCoverage
        Targets of which the lines show different parts.
    messages : tuple of Message
        Of the method that found the targets: what the result is based on, and what limits it.
    """

    mounting: Mounting
    prior_boresight: Annotated[Array, ArrayShape(3)]
    estimated: tuple[str, ...]
    covariance_all: Annotated[Array, ArrayShape("e", "e")]
    parameters: tuple[ParameterEstimate, ...]
    path: Annotated[Array, ArrayShape("n", 3)]
    model: StochasticModel
    variance_factor: float
    degrees_of_freedom: int
    chi_square: ChiSquare
    iterations: int
    targets: tuple[TargetResidual, ...]
    sightings: tuple[SightingResidual, ...]
    rms_before: float
    rms_after: float
    surface: float
    observability: Observability | None
    reliability: tuple[SightingReliability, ...]
    components: tuple[VarianceComponent, ...]
    elapsed: float
    excluded_outliers: int = 0
    contradictions: tuple[ContradictedParameter, ...] = ()
    offset: float | None = None
    causes: tuple[tuple[PossibleCause, ...], ...] | None = None
    angle_sigma_factors: Annotated[Array, ArrayShape(3)] | None = None
    given_correlation_times: tuple[float, float] | None = None
    radius_discrepancies: tuple[RadiusDiscrepancy, ...] = ()
    excluded_targets: tuple[str, ...] = ()
    common_parts: tuple[CommonCoverage, ...] = ()
    messages: tuple[Message, ...] = ()

    @property
    def surfaces(self) -> Array:
        """Sigmas of a sighting's two tilts and its offset, shape (3,), metres."""
        return np.array(
            [self.surface, self.surface, self.surface if self.offset is None else self.offset]
        )

    @property
    def noise_factors(self) -> dict[str, float]:
        """Noise of each target over the given one, as in `TargetResidual`."""
        return {target.target: target.noise for target in self.targets}

    @property
    def boresight(self) -> Array:
        """Estimated roll, pitch, yaw, shape (3,), radians; see `Mounting`."""
        return self.mounting.boresight

    @property
    def angles(self) -> Array:
        """Roll, pitch, yaw of the whole rotation, shape (3,), radians."""
        return self.mounting.without_nominal_axes.boresight

    @property
    def prior_angles(self) -> Array:
        """Roll, pitch, yaw of the prior rotation, shape (3,), radians."""
        return self.mounting.with_boresight(self.prior_boresight).without_nominal_axes.boresight

    @property
    def with_formal_sigmas(self) -> "AdjustmentResult":
        """Result with the formal sigmas of the model, none of them raised."""
        if self.angle_sigma_factors is None:
            return self
        whole = np.ones(len(self.covariance_all))
        whole[:3] = 1.0 / self.angle_sigma_factors
        return replace(
            self,
            covariance_all=self.covariance_all * np.outer(whole, whole),
            angle_sigma_factors=None,
        )

    @property
    def covariance(self) -> Array:
        """Covariance of roll, pitch, yaw, shape (3, 3), radians squared."""
        return self.covariance_all[:3, :3]

    @property
    def points(self) -> int:
        """Number of points used."""
        return sum(sighting.points for sighting in self.sightings)

    @property
    def sigma(self) -> Array:
        """Standard deviations of roll, pitch, yaw, shape (3,), radians."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))

    @property
    def correlation(self) -> Array:
        """Correlations between roll, pitch and yaw, shape (3, 3)."""
        return self.correlation_all[:3, :3]

    @property
    def correlation_all(self) -> Array:
        """Correlations between all of ``estimated``, shape (e, e)."""
        sigma = np.sqrt(np.diag(self.covariance_all))
        return np.asarray(self.covariance_all / np.outer(sigma, sigma))

    @property
    def sigma_factors(self) -> tuple[float, float, float]:
        """Factors applied to the given sigmas of LiDAR, POS position and attitude."""
        if not self.components:
            return 1.0, 1.0, 1.0
        lidar, position, attitude = (
            (c.used or c.factor) if c.applied else 1.0 for c in self.components
        )
        return lidar, position, attitude

    def is_model_rejected(self, level: float = 0.025) -> bool:
        """Whether the one-sided chi-square test rejects the model (Baarda 1968).

        Parameters
        ----------
        level : float
            Probability that it rejects a right model.
        """
        from scipy.special import chdtri

        freedom = self.degrees_of_freedom
        return freedom > 0 and bool(self.chi_square.statistic > chdtri(freedom, level))

    @property
    def rejected_sightings(self) -> tuple[Sighting, ...]:
        """Sightings rejected as blunders."""
        return tuple(item.sighting for item in self.reliability if item.rejected)

    @property
    def rejected_lines(self) -> tuple[str, ...]:
        """Lines whose sightings were all rejected: their position jumped."""
        count = Counter(item.sighting.line for item in self.reliability)
        named = Counter(sighting.line for sighting in self.rejected_sightings)
        return tuple(line for line in named if named[line] == count[line] > 1)


@dataclass(frozen=True, eq=False)
class CrossCheck:
    """Result of a part of the data compared with that of all.

    Attributes
    ----------
    kind : {"line", "target", "half"}
    part : str
        Omitted line or target, or the half of the survey (in time) that was used.
    boresight, sigma : ndarray of shape (3,) or None, radians
        None where the part does not determine the angles.
    difference : ndarray of shape (3,) or None, radians
        This part minus the result of all points, or a half minus the other half.
    significance : ndarray of shape (3,) or None
        The difference over the standard deviation it should have.
    reason : Message or None
        Why there is no result; None where there is one.
    """

    kind: str
    part: str
    boresight: Annotated[Array, ArrayShape(3)] | None = None
    sigma: Annotated[Array, ArrayShape(3)] | None = None
    difference: Annotated[Array, ArrayShape(3)] | None = None
    significance: Annotated[Array, ArrayShape(3)] | None = None
    reason: Message | None = None

    @property
    def disagrees(self) -> bool:
        """Whether an angle differs by more than 3 standard deviations."""
        return self.significance is not None and bool(np.abs(self.significance).max() > 3)


@dataclass(frozen=True, eq=False)
class CrossChecks:
    """All cross-checks, and the spread of their results beside the formal sigmas.

    Attributes
    ----------
    spread_lines, spread_targets : ndarray of shape (3,) or None, radians
        Jackknife standard deviation from omitting one line, or one target, at a time.
    sigma : ndarray of shape (3,), radians
        Formal, of the result of all points.
    """

    parts: tuple[CrossCheck, ...]
    spread_lines: Annotated[Array, ArrayShape(3)] | None
    spread_targets: Annotated[Array, ArrayShape(3)] | None
    sigma: Annotated[Array, ArrayShape(3)]

    @property
    def disagreements(self) -> tuple[CrossCheck, ...]:
        """Parts that disagree with the whole."""
        return tuple(part for part in self.parts if part.disagrees)
