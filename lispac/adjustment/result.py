"""Result of an adjustment."""

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import CommonCoverage, Sighting
from lispac.adjustment.model.parameters import ParameterEstimate
from lispac.adjustment.model.pos_corrections import PosCorrections
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.former_names import accept_script_names
from lispac.messages import Message
from lispac.survey.georeferencing import LEVER_ARM_NAMES, Mounting
from lispac.untrusted_values import ArrayShape

Array = NDArray[np.float64]

ANGLES = ("roll", "pitch", "yaw")


SigmaGroup = Literal["LiDAR", "POS position", "POS attitude"]
"""Group of errors with one variance component."""
SIGMA_GROUPS: tuple[SigmaGroup, ...] = ("LiDAR", "POS position", "POS attitude")
FitOutcome = Literal["passed", "conservative", "failed"]
"""Outcome of the chi-square test."""


@dataclass(frozen=True)
class ChiSquare:
    """Two-sided chi-square test of the variance factor against 1, at a level of 5 %."""

    statistic: float
    lower: float
    upper: float

    @property
    def passed(self) -> bool:
        """Whether the statistic lies within its bounds."""
        return self.lower <= self.statistic <= self.upper

    @property
    def outcome(self) -> FitOutcome:
        """Outcome; with smaller residuals than predicted, the given sigmas are conservative."""
        if self.passed:
            return "passed"
        return "conservative" if self.statistic < self.lower else "failed"


@dataclass(frozen=True, eq=False)
class SightingResidual:
    """Distances of one sighting's points to the adjusted surface, and their statistics.

    Attributes
    ----------
    points : int
    rms_before, rms_after, mean_after : float, metres
        RMS and mean distance before and after the adjustment. Estimated POS errors are not removed.
        The mean is positive on the side to which the normal of the surface points, or outside a
        sphere.
    incidence : float or None, radians
        Mean angle between the beams and the normals of the surface. None in results of earlier
        versions.
    """

    sighting: Sighting
    points: int
    rms_before: float
    rms_after: float
    mean_after: float
    incidence: float | None = None


@accept_script_names
@dataclass(frozen=True, eq=False)
class SightingReliability:
    """Reliability of a sighting, and test of its agreement (correlated model).

    Attributes
    ----------
    pos_error, pos_sigma, pos_sigma_after : ndarray of shape (6,), metres and radians
        Estimated POS error (north, west, up, roll, pitch, heading) in the middle of the sighting,
        reported minus true value, and its standard deviation before and after the adjustment.
    shift : float, metres
        Offset of the whole sighting from the result of all others, estimated without a prior;
        positive against the direction of the normal, or inside a sphere.
    w : float
        ``shift`` divided by its standard deviation (Baarda's test); standard normal if the sighting
        has no blunder.
    detectable : float, metres
        Minimal detectable bias: smallest shift that the test detects with a power of 80 %.
    effect : ndarray of shape (3,), radians
        Change of roll, pitch and yaw by an undetected shift of that size.
    redundancy : float
        Mean redundancy number of the points, from 0 (not controlled) to 1.
    outliers : int
        Number of points whose test value exceeds the critical value.
    largest_w : float
        Largest test value of the points.
    largest_at : float or None, seconds
        Time of the point with the largest test value; for an averaged point, the mean time. None in
        results of earlier versions.
    point_detectable : float, metres
        Median of the minimal detectable biases of the points.
    weight : float
        Mean weight of the points by the loss function.
    rejected : bool
        Whether the sighting is a blunder: rejected, or without weight.
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
    """Distances of the points of one target, in all lines, from one common surface.

    Attributes
    ----------
    rms_before, rms_after : float, metres
        RMS distance from the surface fitted to the points with the prior boresight, and from the
        adjusted surface.
    plane : ndarray of shape (4,), local frame
        Unit normal and offset (metres); of a sphere centre and radius.
    sphere : bool
    noise : float
        Ratio of the noise estimated from the residuals to the given one, at least 1. It includes
        the correlation of neighbouring points, and the sigmas of the angles are computed with it
        (correlated model).
    noise_of_form : float or None
        Ratio of the noise explained by form errors of the surface to the given one, at least 1;
        only for planes with more than the given noise.
    vessel_side : int or None
        1 if the normal points towards the vessel, -1 if it points away from it; 1 for a sphere.
        None in results of earlier versions.
    """

    target: str
    points: int
    rms_before: float
    rms_after: float
    plane: Annotated[Array, ArrayShape(4)]
    sphere: bool = False
    noise: float = 1.0
    noise_of_form: float | None = None
    vessel_side: int | None = None


@dataclass(frozen=True)
class RadiusDiscrepancy:
    """A sphere whose radius differs from line to line by more than the noise explains.

    Attributes
    ----------
    target : str
    smallest, largest : float, metres
    cause : str
        Change with which the radii agree: ``roll_sign``, ``pitch_sign``, ``roll_pitch_signs``,
        ``latency`` or ``range_offset``; empty if there is none.
    value : float, seconds or metres
        Correction to add to the latency or the range offset.
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
        A line or a target without which the angles are not determined, a sighting (or a target, if
        ``line`` is empty) without which some angles have much larger sigmas, or targets so close
        together that they act as one.
    target, line : str
        Names; empty if they do not apply.
    angles : tuple of str
        Angles that depend on a sighting, a target or close targets.
    size : float
        For ``clustered``: largest distance of two targets divided by their distance from the
        scanner.
    targets : tuple of str
        For ``clustered``: names of the targets that act as one; empty for all targets.
    """

    kind: str
    target: str = ""
    line: str = ""
    angles: tuple[str, ...] = ()
    size: float = 0.0
    targets: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Observability:
    """How well the geometry determines the boresight.

    Attributes
    ----------
    eigenvalues : ndarray of shape (3,), per square radian, ascending
        Eigenvalues of the normal matrix of the three angles, with all other unknowns eliminated.
    directions : ndarray of shape (3, 3)
        Eigenvectors in (roll, pitch, yaw), in columns.
    condition : float
        Ratio of the largest to the smallest eigenvalue.
    sigma_without_line : dict of str to ndarray of shape (3,) or None, radians
        Sigmas of roll, pitch and yaw without each line; None if the other lines do not determine
        the angles.
    messages : tuple of Message
        First the weakest and the strongest direction, then the lines on which each angle depends.
    unchecked : tuple of UncontrolledObservations
        Observations in which a blunder would not be detected.
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
        95 % confidence interval from the likelihood.
    applied : bool
        Whether the sigmas were changed: raised if the data show larger errors, lowered if the whole
        interval is below 1.
    used : float or None
        Factor by which the sigmas were changed; ``factor``, estimated with these sigmas, may differ
        slightly. None in results of earlier versions.
    is_determined : bool
        Whether the data determine the factor.
    """

    name: str
    factor: float
    lower: float
    upper: float
    applied: bool = False
    used: float | None = None
    is_determined: bool = True


@dataclass(frozen=True, eq=False)
class ContradictedParameter:
    """A value of the mounting that is not estimated and that the data contradict.

    Attributes
    ----------
    name : str
        Name of a value of the mounting other than the angles.
    change, sigma : float, radians, metres or seconds
        Correction of the given value according to the data, and its standard deviation.
    angle_change : ndarray of shape (3,), radians
        Change of roll, pitch and yaw if the value were corrected.
    surface_sigma : float, metres
        Sigma of the form errors if the value were corrected.
    """

    name: str
    change: float
    sigma: float
    angle_change: Annotated[Array, ArrayShape(3)]
    surface_sigma: float

    @property
    def w(self) -> float:
        """Test value, standard normal if the given value is correct."""
        return self.change / self.sigma


@dataclass(frozen=True, eq=False)
class PossibleCause:
    """An error that may cause residuals that contradict the model.

    Attributes
    ----------
    kind : str
        A value of the mounting other than its angles (`OPTIONAL_NAMES`), ``line_position``,
        ``line_boresight``, ``line_time``, ``sighting_shift``, ``sighting_surface``, or
        ``target_surface`` for a target that is not flat.
    target, line : str
        Target and line with the error; empty if it affects several.
    size, sigma : ndarray of shape (k,), radians, metres or seconds
        Size of the error according to the data, and its standard deviation. The components are
        north, west, up for the position of a line; roll, pitch, yaw for a boresight; two tilts (at
        the border) and the offset for the surface of a sighting, and those of each line for the
        surface of a target.
    angle_change : ndarray of shape (3,), radians
        Change of roll, pitch and yaw if the error were corrected.
    effect : float, metres
        RMS effect of the error on the distances of all points from their surfaces.
    evidence : float
        Twice the logarithm of the Bayes factor against a model without the error.
    """

    kind: str
    target: str
    line: str
    size: Annotated[Array, ArrayShape("k")]
    sigma: Annotated[Array, ArrayShape("k")]
    angle_change: Annotated[Array, ArrayShape(3)]
    effect: float
    evidence: float


@dataclass(frozen=True)
class ControlResidual:
    """Residual and test of one surveyed point, after the adjustment.

    Attributes
    ----------
    name, target, source : str
        Name of the point, its target, and the survey from which it comes.
    is_centre : bool
        Whether the point is the centre of a sphere; the residual and ``shift`` are then distances.
    residual : float, metres
        Distance of the surveyed point from the adjusted surface, positive on the side of the vessel
        and outside a sphere.
    sigma : float, metres
        Standard deviation of the surveyed point along the residual, including the common error of
        its source.
    redundancy : float
        Redundancy number, from 0 (nothing checks the point) to 1; the mean of the three coordinates
        of a centre.
    shift, shift_sigma : float or None, metres
        Error of the point according to all other observations, and its standard deviation; None if
        nothing checks the point.
    w : float or None
        Test value (Baarda 1968) besides the control that contradicts the survey, standard normal
        if the point is correct. For a centre, the value with the same probability as the chi-square
        test of its coordinates.
    contradicts : bool
        Whether the point contradicts the survey.
    """

    name: str
    target: str
    source: str
    is_centre: bool
    residual: float
    sigma: float
    redundancy: float
    shift: float | None = None
    shift_sigma: float | None = None
    w: float | None = None
    contradicts: bool = False

    @property
    def p_value(self) -> float | None:
        """Probability of a larger test value if the point is correct; None without a test."""
        return None if self.w is None else math.erfc(abs(self.w) / math.sqrt(2.0))


@dataclass(frozen=True, eq=False)
class ControlTranslation:
    """Common translation of the surveyed points of one source relative to all other observations.

    Attributes
    ----------
    source : str
    translation, sigma : ndarray of shape (3,), metres; north, west, up
        Translation, and its standard deviation; infinite for a component that is not determined.
    p_value : float
        Probability of a larger translation if the points have no common error beyond the given one.
    contradicts : bool
        Whether the control of the source contradicts the survey as a whole.
    """

    source: str
    translation: Annotated[Array, ArrayShape(3)]
    sigma: Annotated[Array, ArrayShape(3)]
    p_value: float
    contradicts: bool = False


@dataclass(frozen=True, eq=False)
class EstimateWithoutControl:
    """Estimate from the same observations without the control.

    Attributes
    ----------
    angles, sigma : ndarray of shape (3,), radians; roll, pitch, yaw
    parameters : tuple of ParameterEstimate
    """

    angles: Annotated[Array, ArrayShape(3)]
    sigma: Annotated[Array, ArrayShape(3)]
    parameters: tuple[ParameterEstimate, ...]


@accept_script_names
@dataclass(frozen=True, eq=False)
class AdjustmentResult:
    """Boresight, its uncertainty, and the fit of the model.

    Attributes
    ----------
    mounting : Mounting
        Estimated mounting; values that were not estimated are the given ones.
    prior_boresight : ndarray of shape (3,), radians; roll, pitch, yaw
    estimated : tuple of str
        Names of the estimated values: the boresight, and those of ``parameters`` with a value.
    covariance_all : ndarray of shape (e, e), radians, metres, seconds
        Covariance of ``estimated``, not scaled by the variance factor. It contains the variance of
        the lever arm (``lever_arm_covariance``).
    parameters : tuple of ParameterEstimate
        Result of each value that was to be estimated besides the boresight.
    path : ndarray of shape (iterations, 3), radians
        Roll, pitch, yaw after each iteration.
    variance_factor : float
        Variance factor with the given sigmas, multiplied by the applied ``components`` but not by
        the noise estimated from the residuals.
    rms_before, rms_after : float, metres
        RMS distance of all points from their surfaces before and after the adjustment.
    surface : float, metres
        Sigma of the form errors: deviations of the sightings from the shape of their target. Zero
        with independent POS errors.
    reliability : tuple of SightingReliability
        Empty with independent POS errors.
    components : tuple of VarianceComponent
        Those that were estimated; empty if none were requested.
    elapsed : float, seconds
    excluded_outliers : int
        Number of points that are outliers of their sighting and were excluded before averaging.
    contradictions : tuple of ContradictedParameter
        Given values that the data contradict; empty with independent POS errors.
    causes : tuple of tuple of PossibleCause, or None
        Possible causes of residuals that contradict the model, from `find_possible_causes`; None in
        results of earlier versions.
    offset : float or None, metres
        Sigma of the offsets of the sightings if it is estimated or given separately; ``surface`` is
        then that of their tilts.
    angle_sigma_factors : ndarray of shape (3,), or None
        Factors by which the sigmas of the angles were raised, because results without parts of the
        data scatter more than predicted; None if they were not computed.
    given_correlation_times : tuple of float, seconds, or None
        Given correlation times of position and attitude, if the residuals required
        the shorter ones of ``model``.
    sigma_at_given_times : ndarray of shape (3,), radians, or None
        Standard deviations of the angles with ``given_correlation_times``; None without these, and
        in results of earlier versions.
    radius_discrepancies : tuple of RadiusDiscrepancy
        Spheres whose radius differs between lines.
    excluded_targets : tuple of str
        Targets all of whose points have no weight, because they disagree with the other targets;
        they are not used.
    common_parts : tuple of CommonCoverage
        Targets of which the lines show different parts.
    messages : tuple of Message
        Messages of the method that found the targets, on the data used and on the limitations.
    lidar_noise_ratio : float or None
        Ratio of the LiDAR noise in the residuals to the given one, if they differ; from
        `lidar_noise_ratio`.
    assumed_sigmas : tuple of {"LiDAR", "POS position", "POS attitude"}
        Groups of errors whose standard deviations were assumed because nobody gave them.
    lidar_noise_from_residuals : bool
        Whether the given LiDAR noise was estimated from the residuals of an earlier adjustment.
    control : tuple of ControlResidual
        Surveyed points that were used; empty without control.
    control_translations : tuple of ControlTranslation
        Tests of a common translation of the points of each source.
    without_control : EstimateWithoutControl or None
        Estimate without the control; None without control, or if lines and targets alone do not
        determine the angles.
    pos_corrections : PosCorrections or None
        Corrections of the POS as a function of time; None with independent POS errors, and in
        results of earlier versions.
    lever_arm_effect : ndarray of shape (e, 3), or None
        Change of ``estimated`` per metre of the lever arm forward, left and up; None without
        diagnostics, and in results of earlier versions.
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
    lidar_noise_ratio: float | None = None
    assumed_sigmas: tuple[SigmaGroup, ...] = ()
    lidar_noise_from_residuals: bool = False
    sigma_at_given_times: Annotated[Array, ArrayShape(3)] | None = None
    control: tuple[ControlResidual, ...] = ()
    control_translations: tuple[ControlTranslation, ...] = ()
    without_control: EstimateWithoutControl | None = None
    pos_corrections: PosCorrections | None = None
    lever_arm_effect: Annotated[Array, ArrayShape("e", 3)] | None = None

    @property
    def surfaces(self) -> Array:
        """Sigmas of the two tilts and of the offset of a sighting, shape (3,), metres."""
        return np.array(
            [self.surface, self.surface, self.surface if self.offset is None else self.offset]
        )

    @property
    def noise_factors(self) -> dict[str, float]:
        """Ratio of the noise of each target to the given one, as in `TargetResidual`."""
        return {target.target: target.noise for target in self.targets}

    @property
    def are_sigmas_too_small(self) -> bool:
        """Whether residuals larger than predicted show that the sigmas of the angles are too small.

        With correlated POS errors, these sigmas contain the noise found in the residuals. Nothing
        follows from sigmas that are only assumed.
        """
        failed = self.chi_square.outcome == "failed"
        return failed and not (self.model.correlated or self.unestimated_sigmas)

    @property
    def boresight(self) -> Array:
        """Estimated roll, pitch, yaw, shape (3,), radians; see `Mounting`."""
        return self.mounting.boresight

    @property
    def angles(self) -> Array:
        """Roll, pitch, yaw of the estimated rotation with nominal axes included, (3,), radians."""
        return self.mounting.without_nominal_axes.boresight

    @property
    def prior_angles(self) -> Array:
        """Roll, pitch, yaw of the prior rotation with nominal axes included, (3,), radians."""
        return self.mounting.with_boresight(self.prior_boresight).without_nominal_axes.boresight

    @property
    def lever_arm_covariance(self) -> Array:
        """Covariance of ``estimated`` by the sigmas of the given lever arm.

        Returns
        -------
        ndarray of shape (e, e), radians, metres, seconds
        """
        sigma = self.model.lever_arm_sigma
        if sigma is None or self.lever_arm_effect is None:
            return np.zeros_like(self.covariance_all)
        moves = self.lever_arm_effect * sigma
        return np.asarray(moves @ moves.T)

    @property
    def with_exact_lever_arm(self) -> "AdjustmentResult":
        """Result with the sigmas that follow if the given lever arm has no error."""
        return replace(
            self,
            covariance_all=self.covariance_all - self.lever_arm_covariance,
            model=replace(self.model, lever_arm_sigma=None),
        )

    @property
    def with_formal_sigmas(self) -> "AdjustmentResult":
        """Result with the formal sigmas of the model and an exact lever arm.

        They are not raised by `angle_sigma_factors`.
        """
        exact = self.with_exact_lever_arm
        if self.angle_sigma_factors is None:
            return exact
        whole = np.ones(len(self.covariance_all))
        whole[:3] = 1.0 / self.angle_sigma_factors
        return replace(
            exact,
            covariance_all=exact.covariance_all * np.outer(whole, whole),
            angle_sigma_factors=None,
        )

    def mounting_covariance(
        self, lever_arm_sigma: Sequence[float] | None = None
    ) -> tuple[tuple[str, ...], Array]:
        """Joint covariance of the estimated values and of the given lever arm.

        Parameters
        ----------
        lever_arm_sigma : three of float, metres, optional
            Sigmas of the lever arm (forward, left, up) instead of those of the model.

        Returns
        -------
        names : tuple of str
            ``estimated``, and the components of the lever arm that have a sigma and are not
            estimated.
        covariance : ndarray of shape (n, n), radians, metres, seconds
        """
        own, exact = self.model.lever_arm_sigma, self.with_exact_lever_arm.covariance_all
        sigma = own if lever_arm_sigma is None else lever_arm_sigma
        if sigma is None:
            return self.estimated, exact
        effect = self.lever_arm_effect
        if effect is None:
            effect = np.zeros((len(self.estimated), len(LEVER_ARM_NAMES)))
        given = [k for k, name in enumerate(LEVER_ARM_NAMES) if name not in self.estimated]
        moves = np.vstack([effect, np.eye(len(LEVER_ARM_NAMES))[given]])[:, given]
        moves = moves * np.array(sigma)[given]
        covariance = moves @ moves.T
        covariance[: len(exact), : len(exact)] += exact
        return (*self.estimated, *(LEVER_ARM_NAMES[k] for k in given)), covariance

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
        used = {c.name: c.used or c.factor for c in self.components if c.applied}
        lidar, position, attitude = (used.get(group, 1.0) for group in SIGMA_GROUPS)
        return lidar, position, attitude

    @property
    def unestimated_sigmas(self) -> tuple[SigmaGroup, ...]:
        """Groups with assumed standard deviations that were used without an estimate."""
        estimated = {c.name for c in self.components if c.is_determined}
        return tuple(group for group in self.assumed_sigmas if group not in estimated)

    def is_model_rejected(self, level: float = 0.025) -> bool:
        """Whether the one-sided chi-square test rejects the model (Baarda 1968).

        Parameters
        ----------
        level : float
            Significance level: probability that a correct model is rejected.
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
        """Lines with several sightings that were all rejected, as after a jump of the position."""
        count = Counter(item.sighting.line for item in self.reliability)
        named = Counter(sighting.line for sighting in self.rejected_sightings)
        return tuple(line for line in named if named[line] == count[line] > 1)


MAX_SUBSET_SIGNIFICANCE = 3
"""Largest difference of a subset that agrees, in standard deviations of the difference."""


@dataclass(frozen=True, eq=False)
class CrossCheck:
    """Comparison of the result of a part of the data with that of all data.

    Attributes
    ----------
    kind : {"line", "target", "half"}
    part : str
        Omitted line or target, or the half of the survey (in time) that was used.
    boresight, sigma : ndarray of shape (3,) or None, radians
        Result of the part; None if it does not determine the angles.
    difference : ndarray of shape (3,) or None, radians
        Result of this part minus that of all points, or of one half minus the other.
    significance : ndarray of shape (3,) or None
        The difference divided by its predicted standard deviation.
    reason : Message or None
        Reason why there is no result; None if there is one.
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
        """Whether an angle differs by more than `MAX_SUBSET_SIGNIFICANCE`."""
        significance = self.significance
        return significance is not None and bool(
            np.abs(significance).max() > MAX_SUBSET_SIGNIFICANCE
        )


@dataclass(frozen=True, eq=False)
class CrossChecks:
    """Results of all subsets of the data."""

    parts: tuple[CrossCheck, ...]

    @property
    def disagreements(self) -> tuple[CrossCheck, ...]:
        """Parts whose result disagrees with that of all data."""
        return tuple(part for part in self.parts if part.disagrees)
