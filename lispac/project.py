"""Project: an immutable value with paths, settings, picked targets and results.

Every edit creates a new value without the results that are out of date, so that such a result can
never be shown. Undo restores the previous value.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray

from lispac.acceptance import NO_CRITERIA, Acceptance, AcceptanceCriteria, judge_calibration
from lispac.adjustment.model.parameters import OPTIONAL_NAMES, PRIOR_SIGMA_LIMITS, Parameter
from lispac.adjustment.model.robust_loss import LOSS_NAMES, LossName
from lispac.adjustment.model.stochastic_model import (
    ASSUMED_ATTITUDE_SIGMA_DEG,
    ASSUMED_LIDAR_SIGMA,
    ASSUMED_POSITION_SIGMA,
    POS_ERROR_MODELS,
    PosErrors,
    StochasticModel,
)
from lispac.adjustment.result import AdjustmentResult, CrossChecks, SigmaGroup
from lispac.alternative_methods import ALTERNATIVE_METHODS, AlternativeResult, Method
from lispac.control_points import (
    ControlFile,
    controlled_targets,
    with_renamed_target,
    without_assignment,
)
from lispac.errors import InputError, ProjectError
from lispac.former_names import accept_script_names
from lispac.identity import EMPTY_IDENTITY, Identity
from lispac.messages import Message, error, note
from lispac.picked_targets import ROLES as ROLES
from lispac.picked_targets import SHAPES as SHAPES
from lispac.picked_targets import PickedSighting as PickedSighting
from lispac.picked_targets import Role as Role
from lispac.picked_targets import Shape as Shape
from lispac.picked_targets import Target as Target
from lispac.picked_targets import Triple as Triple
from lispac.picked_targets import require_target_name as require_target_name
from lispac.picked_targets import require_valid_target as require_valid_target
from lispac.survey.georeferencing import Mounting
from lispac.survey.lidar_noise import LidarNoise
from lispac.survey.line_source import DEFAULT_READING
from lispac.survey.line_source import LineSource as LineSource
from lispac.survey.line_source import Reading as Reading
from lispac.survey.trajectory import DEFAULT_LONGEST_GAP_S
from lispac.untrusted_values import ArrayShape
from lispac.validation.absolute_check import AbsoluteCheck
from lispac.validation.plane_comparison import PlaneComparison

DEFAULT_THRESHOLD_M = 0.01
"""RANSAC distance threshold in metres (thesis 4.5.3)."""


BoresightChoice = Literal["prior", "estimated"]
"""Boresight with which points are placed."""
LidarNoiseSource = Literal["given", "residuals"]
"""Source of a LiDAR noise that is not assumed: the user, or residuals of an earlier adjustment."""
LIDAR_NOISE_SOURCES: tuple[LidarNoiseSource, ...] = ("given", "residuals")
Unit = Literal["m", "deg", "s"]
SETTING_LIMITS: Mapping[str, tuple[float, float, Unit]] = {
    "setting.position_sigma": (1e-6, 1e4, "m"), "setting.attitude_sigma": (1e-9, 180.0, "deg"),
    "setting.lidar_sigma": (1e-6, 100.0, "m"), "setting.lidar_sigma_xyz": (1e-6, 100.0, "m"),
    "setting.lever_arm_sigma": (1e-6, 100.0, "m"),
    "setting.subsample": (1e-6, 1e3, "m"), "setting.scan_angle_offset": (0.0, 360.0, "deg"),
    "setting.correlation_time": (1e-3, 1e7, "s"), "setting.surface": (1e-7, 100.0, "m"),
    "setting.longest_gap": (1e-3, 1e6, "s"),
}  # fmt: skip
"""Smallest and largest absolute value of each setting that is not zero, and the unit. Values
outside these limits are typing errors and would cause overflow in the adjustment."""
LIDAR_NOISE_FORMS = ("lidar_sigma", "lidar_sigma_xyz", "lidar_beam_sigma")
"""Settings of the LiDAR noise, of which only one is used."""
BEAM_SIGMA_LIMITS: tuple[tuple[float, float, Unit], ...] = (
    (1e-6, 100.0, "m"),
    (1e-9, 180.0, "deg"),
)
"""Limits, as in `SETTING_LIMITS`, of the standard deviations of range and direction of a beam."""
MAX_BEAM_DIVERGENCE_MRAD = 100.0
"""Largest beam divergence, milliradians."""
OUT_OF_RANGE_CODES: Mapping[Unit, str] = {
    "m": "settings.length_out_of_range", "deg": "settings.angle_out_of_range",
    "s": "settings.time_out_of_range",
}  # fmt: skip
"""Code of the message about a setting outside its limits, by the unit of the setting."""


@accept_script_names
@dataclass(frozen=True)
class Settings:
    """Settings of the system and the adjustment.

    Attributes
    ----------
    lever_arm : metres, body frame (forward, left, up)
    boresight_deg : prior roll, pitch, yaw in degrees
    origin_deg_m : latitude, longitude (degrees) and height (metres) of the local frame, or None
        for the mean of the trajectory
    position_sigma : north, east, down in metres, if no accuracy file is given
    attitude_sigma_deg : roll, pitch, heading in degrees, if no accuracy file is given
    lidar_sigma : metres on each axis; not used if one of the next two is given
        None in these three if nobody gave them: `used_position_sigma`, `used_attitude_sigma_deg`
        and `used_lidar_sigma` are then the assumed defaults.
    lidar_sigma_xyz : metres along x, y, z of the LiDAR
    lidar_beam_sigma : sigma of the range in metres and of the beam's direction in degrees
    lidar_noise_source : whether the user gave the LiDAR noise, or an earlier adjustment estimated
        it from its residuals
    lever_arm_sigma : metres, standard deviations of the lever arm, or None if it is assumed exact
    beam_divergence_mrad : milliradians, full angle, for the error budget, or None
    range_offset : metres
    scan_angle_offset_deg : degrees
    latency : seconds
        Known systematic errors of the scanner, as `Mounting` applies them.
    subsample : metres; points closer together than this are averaged, or with independent POS
        errors reduced to one of them; 0 keeps all points
    pos_errors, position_time, attitude_time, surface : see `StochasticModel`
    loss : None for the default: ``tukey`` with ``correlated``, ``none`` with ``independent``
    parameters : values of the mounting to estimate in addition to the boresight
    variance_components : True estimates the variances of LiDAR and POS errors, False none of them,
        None (automatic) those whose standard deviations are assumed
    accept_single_orientation : whether to adjust if all targets are planes that face the same way
    longest_gap : longest time in seconds between two states of the trajectory over which positions
        are interpolated; points in longer gaps are excluded
    """

    lever_arm: Triple
    boresight_deg: Triple = (0.0, 0.0, 0.0)
    origin_deg_m: Triple | None = None
    position_sigma: Triple | None = None
    attitude_sigma_deg: Triple | None = None
    lidar_sigma: float | None = None
    lidar_sigma_xyz: Triple | None = None
    lidar_beam_sigma: tuple[float, float] | None = None
    lidar_noise_source: LidarNoiseSource = "given"
    lever_arm_sigma: Triple | None = None
    beam_divergence_mrad: float | None = None
    range_offset: float = 0.0
    scan_angle_offset_deg: float = 0.0
    latency: float = 0.0
    subsample: float = 0.10
    pos_errors: PosErrors = "correlated"
    position_time: float = 300.0
    attitude_time: float = 600.0
    surface: float | None = None
    loss: LossName | None = None
    parameters: tuple[Parameter, ...] = ()
    variance_components: bool | None = None
    accept_single_orientation: bool = False
    longest_gap: float = DEFAULT_LONGEST_GAP_S

    @property
    def used_position_sigma(self) -> Triple:
        """Given or assumed standard deviations of north, east and down, metres."""
        return self.position_sigma or ASSUMED_POSITION_SIGMA

    @property
    def used_attitude_sigma_deg(self) -> Triple:
        """Given or assumed standard deviations of roll, pitch and heading, degrees."""
        return self.attitude_sigma_deg or ASSUMED_ATTITUDE_SIGMA_DEG

    @property
    def used_lidar_sigma(self) -> float:
        """Standard deviation of a LiDAR point as one number, metres, given or assumed.

        It is that of the range, or the root mean square of the axes, if these are given.
        """
        if self.lidar_beam_sigma is not None:
            return self.lidar_beam_sigma[0]
        if self.lidar_sigma_xyz is not None:
            return math.sqrt(sum(value * value for value in self.lidar_sigma_xyz) / 3)
        return self._single_lidar_sigma

    @property
    def _single_lidar_sigma(self) -> float:
        """Given or assumed standard deviation of the LiDAR on each axis, metres."""
        return ASSUMED_LIDAR_SIGMA if self.lidar_sigma is None else self.lidar_sigma

    @property
    def assumed_sigmas(self) -> tuple[SigmaGroup, ...]:
        """Groups of errors whose standard deviations are not given in the settings."""
        is_given: dict[SigmaGroup, bool] = {
            "LiDAR": any((self.lidar_sigma, self.lidar_sigma_xyz, self.lidar_beam_sigma)),
            "POS position": self.position_sigma is not None,
            "POS attitude": self.attitude_sigma_deg is not None,
        }
        return tuple(group for group, given in is_given.items() if not given)

    @property
    def lidar_noise(self) -> LidarNoise:
        """Given or assumed noise of the LiDAR points."""
        beam = self.lidar_beam_sigma
        return LidarNoise(
            self.lidar_sigma_xyz or (self.used_lidar_sigma,) * 3,
            None if beam is None else (beam[0], math.radians(beam[1])),
        )

    @property
    def is_lidar_noise_from_residuals(self) -> bool:
        """Whether the LiDAR noise is one that an earlier adjustment estimated."""
        return self.lidar_noise_source == "residuals" and "LiDAR" not in self.assumed_sigmas

    @property
    def stochastic_model(self) -> StochasticModel:
        """Stochastic model for these settings."""
        loss = self.loss or ("tukey" if self.pos_errors == "correlated" else "none")
        lever_arm = self.lever_arm_sigma if any(self.lever_arm_sigma or ()) else None
        return StochasticModel(
            self.pos_errors, self.position_time, self.attitude_time, self.surface, loss,
            lever_arm_sigma=lever_arm,
        )  # fmt: skip

    @property
    def threshold(self) -> float:
        """Default RANSAC threshold, metres: that of the thesis, or 3 LiDAR sigma if larger."""
        return max(DEFAULT_THRESHOLD_M, 3 * self.used_lidar_sigma)

    def with_values(self, **values: Any) -> "Settings":
        """Copy with other values; one form of the LiDAR noise replaces the others.

        A LiDAR noise is given unless ``lidar_noise_source`` is one of the values.
        """
        if any(values.get(name) is not None for name in LIDAR_NOISE_FORMS):
            former = {"lidar_sigma_xyz": None, "lidar_beam_sigma": None}
            values = {**former, "lidar_noise_source": "given", **values}
        return replace(self, **values)

    def with_lidar_sigma(self, sigma: float) -> "Settings":
        """Copy with this standard deviation of the LiDAR; a given beam angle is kept.

        Parameters
        ----------
        sigma : float, metres
        """
        beam = self.lidar_beam_sigma
        return self.with_values(
            lidar_sigma=sigma, lidar_beam_sigma=None if beam is None else (sigma, beam[1])
        )

    def with_lidar_noise_scaled(self, ratio: float) -> "Settings":
        """Copy with the LiDAR noise that an adjustment estimated from its residuals.

        Parameters
        ----------
        ratio : float
            Ratio of this noise to the present one. The values are rounded to three digits.
        """

        def scaled(value: float) -> float:
            return float(f"{ratio * value:.3g}")

        xyz, beam = self.lidar_sigma_xyz, self.lidar_beam_sigma
        return replace(
            self,
            lidar_sigma=scaled(self.used_lidar_sigma),
            lidar_sigma_xyz=xyz and (scaled(xyz[0]), scaled(xyz[1]), scaled(xyz[2])),
            lidar_beam_sigma=beam and (scaled(beam[0]), scaled(beam[1])),
            lidar_noise_source="residuals",
        )

    def require_sound(self) -> None:
        """Refuse invalid settings.

        Raises
        ------
        InputError
            If a setting is not finite, outside its limits or contradicts another one.
        """
        self._require_within_limits()
        self._require_sound_sigmas()
        self._require_sound_parameters()
        if self.pos_errors not in POS_ERROR_MODELS:
            raise InputError(
                error("settings.unknown_pos_errors", name=self.pos_errors, known=POS_ERROR_MODELS)
            )
        if self.lidar_noise_source not in LIDAR_NOISE_SOURCES:
            raise InputError(
                error(
                    "settings.unknown_noise_source",
                    name=self.lidar_noise_source, known=LIDAR_NOISE_SOURCES,
                )
            )  # fmt: skip
        if self.loss is not None and self.loss not in LOSS_NAMES:
            raise InputError(error("settings.unknown_loss", name=self.loss, known=LOSS_NAMES))
        if not min(self.position_time, self.attitude_time) > 0:
            raise InputError(error("settings.zero_correlation_time"))
        if not self.longest_gap > 0:
            raise InputError(error("settings.zero_longest_gap"))
        if not 0 <= (self.beam_divergence_mrad or 0.0) <= MAX_BEAM_DIVERGENCE_MRAD:
            raise InputError(error("adjustment.budget_divergence", most=MAX_BEAM_DIVERGENCE_MRAD))
        if abs(self.latency) > 10:
            raise InputError(error("settings.latency_too_large", value=self.latency))
        if abs(self.range_offset) > 10:
            raise InputError(error("settings.range_offset_too_large", value=self.range_offset))
        if np.abs(self.boresight_deg).max() > 360:
            largest = float(np.radians(np.abs(self.boresight_deg).max()))
            raise InputError(error("settings.boresight_too_large", value=largest))
        if np.linalg.norm(self.lever_arm) > 100:
            length = float(np.linalg.norm(self.lever_arm))
            raise InputError(error("settings.lever_arm_too_long", length=length))
        if self.origin_deg_m is not None and abs(self.origin_deg_m[0]) > 90:
            latitude = float(np.radians(self.origin_deg_m[0]))
            raise InputError(error("settings.latitude_out_of_range", latitude=latitude))

    def _require_within_limits(self) -> None:
        """Refuse numbers that are not finite or outside `SETTING_LIMITS`.

        Raises
        ------
        InputError
            If there is one.
        """
        numbers = {
            "setting.lever_arm": self.lever_arm,
            "setting.boresight": self.boresight_deg,
            "setting.origin": self.origin_deg_m or (0.0,),
            "setting.position_sigma": self.used_position_sigma,
            "setting.attitude_sigma": self.used_attitude_sigma_deg,
            "setting.lidar_sigma": (self._single_lidar_sigma,),
            "setting.subsample": (self.subsample,),
            "setting.lidar_sigma_xyz": self.lidar_sigma_xyz or (1.0,),
            "setting.lidar_beam_sigma": self.lidar_beam_sigma or (1.0,),
            "setting.lever_arm_sigma": self.lever_arm_sigma or (0.0,),
            "setting.beam_divergence": (self.beam_divergence_mrad or 0.0,),
            "setting.range_offset": (self.range_offset,),
            "setting.scan_angle_offset": (self.scan_angle_offset_deg,),
            "setting.latency": (self.latency,),
            "setting.correlation_time": (self.position_time, self.attitude_time),
            "setting.surface": (self.surface or 0.0,),
            "setting.longest_gap": (self.longest_gap,),
        }
        for name, values in numbers.items():
            if not np.isfinite(values).all():
                raise InputError(error("settings.not_finite", setting=note(name)))
            if name in SETTING_LIMITS:
                low, high, unit = SETTING_LIMITS[name]
                for value in values:
                    if value and not low <= abs(value) <= high:
                        raise InputError(_out_of_range(name, value, low, high, unit))
        for value, (low, high, unit) in zip(
            self.lidar_beam_sigma or (), BEAM_SIGMA_LIMITS, strict=False
        ):
            if value > 0 and not low <= value <= high:
                raise InputError(_out_of_range("setting.lidar_beam_sigma", value, low, high, unit))

    def _require_sound_sigmas(self) -> None:
        """Refuse standard deviations that are negative or contradict each other.

        Raises
        ------
        InputError
            If there is one.
        """
        smallest = min(*self.used_position_sigma, *self.used_attitude_sigma_deg, self.subsample)
        if smallest < 0:
            raise InputError(error("settings.negative"))
        lidar = (
            self._single_lidar_sigma,
            *(self.lidar_sigma_xyz or ()),
            *(self.lidar_beam_sigma or ()),
        )
        if min(lidar) <= 0:
            raise InputError(error("settings.zero_lidar_sigma"))
        if self.lidar_sigma_xyz and self.lidar_beam_sigma:
            raise InputError(error("settings.two_lidar_sigmas"))
        if min(self.lever_arm_sigma or (0.0,)) < 0:
            raise InputError(error("estimate.lever_arm_sigma"))
        if self.surface is not None and self.surface < 0:
            raise InputError(error("settings.negative_surface"))

    def _require_sound_parameters(self) -> None:
        """Refuse parameters that are unknown, given twice or have an impossible sigma.

        Raises
        ------
        InputError
            If there is one.
        """
        for parameter in self.parameters:
            if parameter.name not in OPTIONAL_NAMES:
                raise InputError(
                    error(
                        "settings.unknown_parameter",
                        name=parameter.name,
                        known=list(OPTIONAL_NAMES),
                    )
                )
            if parameter.sigma is not None and not parameter.sigma > 0:
                raise InputError(error("settings.zero_parameter_sigma", name=parameter.name))
            require_prior_sigma(parameter)
        if len({parameter.name for parameter in self.parameters}) < len(self.parameters):
            raise InputError(error("settings.parameter_twice"))


def require_prior_sigma(parameter: Parameter) -> None:
    """Refuse a prior standard deviation outside `PRIOR_SIGMA_LIMITS`.

    Raises
    ------
    InputError
        If the standard deviation is outside the limits.
    """
    low, high = PRIOR_SIGMA_LIMITS
    if parameter.sigma is not None and not low <= parameter.sigma <= high:
        raise InputError(error("settings.parameter_sigma_out_of_range", name=parameter.name))


def _out_of_range(name: str, value: float, low: float, high: float, unit: Unit) -> Message:
    """Message that a setting is outside its limits."""
    if unit == "deg":
        value, low, high = (math.radians(each) for each in (value, low, high))
    return error(OUT_OF_RANGE_CODES[unit], setting=note(name), value=value, least=low, most=high)


@dataclass(frozen=True, eq=False)
class ProposalPrediction:
    """Standard deviations that were predicted when targets were proposed.

    Attributes
    ----------
    targets : tuple of str
        Names of the proposed targets.
    sigma : ndarray of shape (3,), radians; roll, pitch, yaw
    """

    targets: tuple[str, ...]
    sigma: Annotated[NDArray[np.float64], ArrayShape(3)]


UNSAVED_FIELDS = ("folder", "file_digest", "excluded_comparisons")
"""Fields of a project that are not in its file."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Project:
    """Content of a project folder; paths are absolute here and relative in the project file.

    The file has the fields in the same order, except for `UNSAVED_FIELDS`.
    """

    folder: Path
    trajectory: Path
    trajectory_reading: Reading = DEFAULT_READING
    accuracy: Path | None = None
    accuracy_reading: Reading = DEFAULT_READING
    lines: tuple[LineSource, ...]
    identity: Identity = EMPTY_IDENTITY
    acceptance: AcceptanceCriteria = NO_CRITERIA
    settings: Settings
    targets: tuple[Target, ...] = ()
    control: tuple[ControlFile, ...] = ()
    """Files with surveyed points that the adjustment uses as observations."""
    result: AdjustmentResult | None = None
    cross_checks: CrossChecks | None = None
    validation: tuple[PlaneComparison, ...] = ()
    not_compared: Mapping[str, Message] = field(default_factory=dict)
    """Reason for each validation plane on which the lines are not compared."""
    absolute: AbsoluteCheck | None = None
    """Comparison of the lines with a static scan or surveyed points, if it has been made."""
    alternative_results: tuple[AlternativeResult, ...] = ()
    """Results of alternative methods for the same lines, at most one for each method."""
    data_messages: tuple[Message, ...] = ()
    """Warnings and notes about the imported files, from the last time they were read."""
    reading_warnings: tuple[Message, ...] = ()
    """Warnings from the import about how the files are read, such as assumed signs."""
    prediction: ProposalPrediction | None = None
    """Predicted standard deviations, if the targets are accepted proposals without edits."""
    truth_deg: Triple | None = None
    """True boresight of a simulated survey; None for a real one."""
    file_digest: str = field(default="", compare=False, repr=False)
    """Digest of the project file that was read; empty for a new project."""
    excluded_comparisons: Mapping[str, PlaneComparison | Message] = field(
        default_factory=dict, compare=False, repr=False
    )
    """Comparison of each excluded plane, or the reason why it has none, for when it is included
    again. It is used for nothing else and is not saved."""

    @property
    def name(self) -> str:
        """Name of the project, which is the name of its folder."""
        return self.folder.name

    def mounting(self, which: BoresightChoice) -> Mounting:
        """Prior or estimated mounting.

        Raises
        ------
        ProjectError
            If the boresight has not been estimated yet.
        """
        if which == "prior":
            settings = self.settings
            return Mounting.with_nearest_axes(
                np.array(settings.lever_arm, dtype=float),
                np.radians(settings.boresight_deg),
                settings.range_offset,
                float(np.radians(settings.scan_angle_offset_deg)),
                settings.latency,
            )
        if self.result is None:
            raise ProjectError(error("project.not_estimated", project=self.name))
        return self.result.mounting

    @property
    def assumed_sigmas(self) -> tuple[SigmaGroup, ...]:
        """Groups of errors whose standard deviations neither the settings nor a file give."""
        assumed = self.settings.assumed_sigmas
        return assumed if self.accuracy is None else tuple(g for g in assumed if g == "LiDAR")

    def targets_of_role(self, role: Role) -> tuple[Target, ...]:
        """Either the targets or the validation planes."""
        return tuple(target for target in self.targets if target.role == role)

    @property
    def compared_targets(self) -> tuple[Target, ...]:
        """Targets that are used on at least two lines, or on one line and with control."""
        controlled = controlled_targets(self.control)
        return tuple(
            target
            for target in self.targets_of_role("target")
            if len(target.used_sightings) >= (1 if target.name in controlled else 2)
        )

    @property
    def picked_points(self) -> int:
        """Number of points of all sightings of targets that are used."""
        targets = self.targets_of_role("target")
        return sum(len(s.indices) for target in targets for s in target.used_sightings)

    def target(self, name: str) -> Target:
        """Target or validation plane with this name.

        Raises
        ------
        ProjectError
            If there is no target with this name.
        """
        for target in self.targets:
            if target.name == name:
                return target
        raise ProjectError(error("project.no_target", project=self.name, name=name))

    def with_points_of(self, other: "Project") -> "Project":
        """Project whose sightings have the points that they have in ``other``."""
        return replace(
            self,
            targets=tuple(
                replace(
                    target,
                    sightings=tuple(
                        replace(own, indices=found.indices, rms=found.rms, one_in=found.one_in)
                        if (found := other.target(target.name).sighting(own.line))
                        else own
                        for own in target.sightings
                    ),
                )
                for target in self.targets
            ),
        )

    def with_target(self, target: Target) -> "Project":
        """Add a target, or replace the one with the same name.

        Raises
        ------
        ProjectError
            If its name or shape is invalid.
        """
        require_valid_target(target)
        kept = list(self.targets)
        names = [other.name for other in kept]
        old = kept[names.index(target.name)] if target.name in names else None
        if old is not None:
            kept[names.index(target.name)] = target
        else:
            kept.append(target)
        edited = self._edited(tuple(kept), {t.role for t in (target, old) if t is not None})
        if old is None or _is_same_place(target, old):
            return edited
        return edited._without_assigned_control(target.name)

    def without_target(self, name: str) -> "Project":
        """Remove a target or validation plane."""
        removed = self.target(name)
        edited = self._edited(tuple(t for t in self.targets if t.name != name), {removed.role})
        return edited._without_assigned_control(name)

    def _without_assigned_control(self, name: str) -> "Project":
        return replace(self, control=without_assignment(self.control, [name]))

    def with_identity(self, identity: Identity) -> "Project":
        """Change the details for the report; they are not used in computations."""
        return replace(self, identity=identity)

    def with_acceptance(self, criteria: AcceptanceCriteria) -> "Project":
        """Change the acceptance criteria; results are kept and judged by the new ones."""
        return replace(self, acceptance=criteria)

    @property
    def judgement(self) -> Acceptance:
        """Judgement of the result and the validation by the acceptance criteria."""
        sigma = None if self.result is None else self.result.sigma
        excluded = [each.name for each in self.targets_of_role("validation") if not each.used]
        return judge_calibration(
            self.acceptance, sigma, self.validation, self.not_compared, excluded
        )

    def with_settings(self, settings: Settings) -> "Project":
        """Change the settings; results that depend on them are removed."""
        divergence = settings.beam_divergence_mrad  # only for the error budget
        if replace(self.settings, beam_divergence_mrad=divergence) == settings:
            return replace(self, settings=settings)
        return replace(self.without_results(), settings=settings)

    def with_control(self, control: tuple[ControlFile, ...]) -> "Project":
        """Change the control.

        Results are removed if points are used, or were used, that are not the same now.
        """
        before, after = (
            [(file.path, file.common_sigma, file.used_points) for file in files if file.used_points]
            for files in (self.control, control)
        )
        kept = self if before == after else self._edited(self.targets, {"target"})
        return replace(kept, control=control)

    def without_results(self) -> "Project":
        """Remove all results, after a change of data or settings on which they depend."""
        return replace(
            self, result=None, cross_checks=None, validation=(), not_compared={}, absolute=None,
            alternative_results=(), prediction=None, excluded_comparisons={},
        )  # fmt: skip

    def with_result(self, result: AdjustmentResult) -> "Project":
        """Set the result of the adjustment; the validation of a previous result is removed."""
        return replace(
            self, result=result, cross_checks=None, validation=(), not_compared={}, absolute=None,
            excluded_comparisons={},
        )  # fmt: skip

    def with_cross_checks(self, checks: CrossChecks) -> "Project":
        """Set the cross-checks, which are results from parts of the data."""
        return replace(self, cross_checks=checks)

    def with_validation(
        self, validation: tuple[PlaneComparison, ...], not_compared: Mapping[str, Message]
    ) -> "Project":
        """Set the comparison on validation planes, and the reasons for those not compared."""
        return replace(
            self, validation=validation, not_compared=not_compared, excluded_comparisons={}
        )

    def with_data_messages(self, messages: tuple[Message, ...]) -> "Project":
        """Set the warnings and notes about the imported files."""
        return replace(self, data_messages=messages)

    def with_prediction(self, prediction: ProposalPrediction) -> "Project":
        """Set the standard deviations that were predicted for the targets."""
        return replace(self, prediction=prediction)

    def with_absolute(self, absolute: AbsoluteCheck) -> "Project":
        """Set the comparison with a reference."""
        return replace(self, absolute=absolute)

    def alternative_result(self, method: Method) -> AlternativeResult | None:
        """Result of an alternative method; None if it has not been run."""
        return next((each for each in self.alternative_results if each.method == method), None)

    @property
    def is_targetless(self) -> bool:
        """Whether the result is from the targetless method, whose surfaces are the targets."""
        messages = () if self.result is None else self.result.messages
        return any(message.code.startswith("targetless.") for message in messages)

    def with_alternative_result(self, alternative: AlternativeResult) -> "Project":
        """Set the result of an alternative method."""
        others = [each for each in self.alternative_results if each.method != alternative.method]
        kept = sorted(
            [*others, alternative], key=lambda each: ALTERNATIVE_METHODS.index(each.method)
        )
        return replace(self, alternative_results=tuple(kept))

    def with_renamed_target(self, old: str, new: str) -> "Project":
        """Rename a target without changing the order; a validation plane keeps its comparison.

        The results that depend on a target contain its name and are removed.
        """
        renamed = replace(self.target(old), name=new)
        require_valid_target(renamed)
        targets = tuple(renamed if target.name == old else target for target in self.targets)
        edited = self._edited(targets, {renamed.role})
        edited = replace(edited, control=with_renamed_target(self.control, old, new))
        if renamed.role == "target":
            return edited
        excluded = dict(edited.excluded_comparisons)
        if isinstance(comparison := self.excluded_comparisons.get(old), PlaneComparison):
            excluded[new] = replace(comparison, name=new)
        if old not in {plane.name for plane in self.validation}:
            return replace(edited, excluded_comparisons=excluded)
        comparisons = tuple(
            replace(plane, name=new) if plane.name == old else plane for plane in self.validation
        )
        kept = {name: reason for name, reason in self.not_compared.items() if name != new}
        return replace(
            edited, validation=comparisons, not_compared=kept, excluded_comparisons=excluded
        )

    def _edited(self, targets: tuple[Target, ...], roles: set[Role]) -> "Project":
        # Validation planes are not used in the adjustment, so the angles stay valid after an edit
        # of one. Only the method of natural planes uses them.
        kept = "target" not in roles
        edited = replace(
            self,
            targets=targets,
            result=self.result if kept else None,
            cross_checks=self.cross_checks if kept else None,
            validation=(),
            not_compared={},
            excluded_comparisons={},
            absolute=self.absolute if kept else None,
            prediction=self.prediction if kept else None,
            alternative_results=tuple(
                each
                for each in self.alternative_results
                if each.method != "natural planes" or "validation" not in roles
            ),
        )
        return edited._with_unchanged_comparisons_of(self) if kept else edited

    def _with_unchanged_comparisons_of(self, former: "Project") -> "Project":
        """Keep the comparisons of planes that have not changed, and give a reason for the others.

        A plane that was only excluded or included has not changed. The comparison of an excluded
        plane is in `excluded_comparisons`. None is shown if no plane that is used has one.
        """
        known: dict[str, PlaneComparison | Message] = {
            **former.excluded_comparisons,
            **former.not_compared,
            **{plane.name: plane for plane in former.validation},
        }
        before = {plane.name: plane for plane in former.targets_of_role("validation")}
        planes = self.targets_of_role("validation")
        kept = {
            plane.name: known[plane.name]
            for plane in planes
            if plane.name in known and _is_same_surface(plane, before.get(plane.name))
        }
        used = [plane.name for plane in planes if plane.used]
        excluded = {name: each for name, each in kept.items() if name not in used}
        outcomes = {
            name: kept.get(name, error("validation.plane_edited", plane=name)) for name in used
        }
        comparisons = tuple(o for o in outcomes.values() if isinstance(o, PlaneComparison))
        if not comparisons:
            return replace(self, excluded_comparisons=excluded)
        return replace(
            self,
            validation=comparisons,
            not_compared={n: o for n, o in outcomes.items() if isinstance(o, Message)},
            excluded_comparisons=excluded,
        )


def _is_same_place(target: Target, former: Target) -> bool:
    """Whether a target has the role, shape and seed that it had, so that it keeps its control."""
    return all(getattr(target, name) == getattr(former, name) for name in ("role", "shape", "seed"))


def _is_same_surface(plane: Target, former: Target | None) -> bool:
    """Whether a plane has the points that it had, with or without being used."""
    return former is not None and all(
        getattr(plane, each.name) is getattr(former, each.name)
        for each in fields(Target)
        if each.name != "used"
    )
