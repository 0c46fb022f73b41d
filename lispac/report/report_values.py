"""Values of a report, not formatted.

Names end with the unit of their values and are also the keys of the JSON report, so that every
document shows the same numbers. Texts are messages and labels, which
`lispac.report.document` writes in the language of the report.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from lispac.identity import Identity
from lispac.language import LazyText
from lispac.messages import Message
from lispac.report.absolute_values import AbsoluteCheckValues
from lispac.report.alternative_method_values import MethodValues
from lispac.report.budget_values import ErrorBudgetValues
from lispac.report.convention_values import ConventionValues, ScannerToBodyMatrix
from lispac.report.trajectory_values import LineTrajectorySummary
from lispac.report.validation_values import SwathDifference, ValidationPlane


@dataclass(frozen=True)
class InputFile:
    """An input file of the result; size and digest are None where it could not be found."""

    role: str
    name: str
    size_bytes: int | None
    sha256: str | None


@dataclass(frozen=True)
class SettingsUsed:
    """Settings; the POS sigmas are None where an accuracy file was given.

    The LiDAR noise is that along x, y, z, or of range and angle, where one of these is known, and
    ``lidar_sigma_m`` on each axis otherwise. The surface sigma is the value used. It is None
    where it is still to be estimated and with uncorrelated POS errors; so is its source. The offset
    sigma is None where it is the same.
    """

    lever_arm_m: tuple[float, ...]
    origin_deg_m: tuple[float, ...] | None
    position_sigma_m: tuple[float, ...] | None
    attitude_sigma_deg: tuple[float, ...] | None
    lidar_sigma_m: float
    lidar_sigma_xyz_m: tuple[float, ...] | None
    lidar_range_sigma_m: float | None
    lidar_angle_sigma_deg: float | None
    range_offset_m: float
    scan_angle_offset_deg: float
    latency_s: float
    subsample_m: float
    accept_single_orientation: bool
    averaged: bool
    pos_errors: str
    position_correlation_time_s: float | None
    attitude_correlation_time_s: float | None
    pos_errors_text: str
    surface_sigma_m: float | None
    offset_sigma_m: float | None
    surface_from_data: bool | None
    loss: str
    loss_text: str
    convention: str


@dataclass(frozen=True)
class AngleValues:
    """One boresight angle; unknown values are None."""

    name: str
    prior_deg: float
    estimated_deg: float | None
    sigma_deg: float | None
    interval95_deg: float | None
    truth_deg: float | None
    error_deg: float | None


@dataclass(frozen=True)
class VarianceFactorTest:
    """Two-sided test of the variance factor at 95 %; bounds are None without redundancy."""

    statistic: float
    lower: float | None
    upper: float | None
    passed: bool | None
    text: str


@dataclass(frozen=True)
class DisplacementByAngle:
    """Displacement of a point caused by one sigma of an angle, or of all in the worst direction."""

    angle: str
    displacement_m: tuple[float, ...]


@dataclass(frozen=True)
class S44Contribution:
    """Contribution of the boresight to the uncertainty of a point, for the worst beam.

    Horizontal (THU) and vertical (TVU), at 95 % as IHO S-44 has it, for a level vessel.
    """

    distance_m: float
    thu95_m: float
    tvu95_m: float


@dataclass(frozen=True)
class TargetFit:
    """Fit of one target's points, over all lines, to their joint surface.

    ``noise_factor`` is the LiDAR noise found in the residuals over the given one, at least 1.
    """

    target: str
    shape: str
    radius_m: float | None
    sightings: int
    points: int
    rms_before_m: float
    rms_after_m: float
    noise_factor: float


@dataclass(frozen=True)
class SightingFit:
    """Fit of one sighting's points to the adjusted surface of its target."""

    target: str
    line: str
    heading_deg: float | None
    points: int
    rms_before_m: float
    rms_after_m: float
    mean_after_m: float


@dataclass(frozen=True)
class AdditionalParameterValues:
    """Additional parameter estimated with the boresight, or the reason why it was not.

    ``prior``, ``prior_sigma``, ``value`` and ``sigma`` are in its own unit. ``significance`` is
    the change from the prior over its standard deviation; ``significant`` at 95 %.
    """

    name: str
    unit: str
    prior: float
    prior_sigma: float | None
    value: float | None
    sigma: float | None
    significance: float | None
    significant: bool | None
    reason: Message | Literal[""]


@dataclass(frozen=True)
class ObservabilityValues:
    """Observability of the angles by lines and targets.

    The directions are combinations of roll, pitch and yaw, the weakest first. The sigmas without a
    line are None where the other lines do not determine the angles.
    """

    direction_sigma_deg: tuple[float, ...]
    directions: tuple[tuple[float, ...], ...]
    condition: float | None
    sigma_without_line_deg: Mapping[str, tuple[float, ...] | None]
    messages: tuple[Message, ...]


@dataclass(frozen=True)
class SightingCheck:
    """Test of a sighting against all others, and its estimated POS error.

    Shift, test value, detectable shift and its effect are None where no other data check the
    sighting. ``largest_w`` is the largest test value of a point, at ``largest_w_time_s``; that is
    None in results of earlier versions. POS errors are north, west, up and roll, pitch, heading.
    """

    target: str
    line: str
    points: int
    shift_m: float | None
    w: float | None
    detectable_m: float | None
    effect_deg: tuple[float, ...] | None
    redundancy: float
    outliers: int
    largest_w: float
    largest_w_time_s: float | None
    point_detectable_m: float | None
    weight: float
    rejected: bool
    status: str
    pos_error_m: tuple[float, ...]
    pos_sigma_m: tuple[float, ...]
    pos_sigma_after_m: tuple[float, ...]
    pos_error_deg: tuple[float, ...]
    pos_sigma_deg: tuple[float, ...]
    pos_sigma_after_deg: tuple[float, ...]


@dataclass(frozen=True)
class VarianceComponent:
    """Variance component: ``factor`` on the given sigma of a group of errors, 95 % interval.

    ``applied``: whether the sigmas were changed by it.
    """

    name: str
    factor: float
    lower: float
    upper: float
    applied: bool
    text: Message


@dataclass(frozen=True)
class CrossCheckPart:
    """Result of a part of the data; None where the part does not determine the angles.

    The difference is this part minus what it is compared with: a half minus the other half, any
    other part minus the result of all points.
    """

    kind: str
    part: str
    boresight_deg: tuple[float, ...] | None
    sigma_deg: tuple[float, ...] | None
    difference_deg: tuple[float, ...] | None
    significance: tuple[float, ...] | None
    disagrees: bool
    reason: Message | Literal[""]


@dataclass(frozen=True)
class CrossCheckValues:
    """Results of parts of the data, and their spread beside the formal sigmas."""

    sigma_deg: tuple[float, ...]
    spread_lines_deg: tuple[float, ...] | None
    spread_targets_deg: tuple[float, ...] | None
    parts: tuple[CrossCheckPart, ...]


@dataclass(frozen=True)
class AdjustmentValues:
    """Fit, reliability and estimated values of the adjustment.

    ``correlation`` is that of the three angles, ``correlation_all`` that of all ``estimated``.
    ``critical_w`` is the test value beyond which a sighting disagrees. ``single_orientation``: all
    targets are planes with the same normal. ``rotation_text`` is empty except where the pitch is
    steep, so that roll, pitch and yaw do not describe the rotation well.
    """

    rotation_text: LazyText
    correlation: tuple[tuple[float, ...], ...]
    estimated: tuple[str, ...]
    correlation_all: tuple[tuple[float, ...], ...]
    parameters: tuple[AdditionalParameterValues, ...]
    observability: ObservabilityValues | None
    components: tuple[VarianceComponent, ...]
    critical_w: float | None
    reliability: tuple[SightingCheck, ...]
    variance_factor: float | None
    degrees_of_freedom: int
    chi_square: VarianceFactorTest
    iterations: int
    points: int
    excluded_outliers: int
    rms_before_m: float
    rms_after_m: float
    effect_distances_m: tuple[float, ...]
    effects: tuple[DisplacementByAngle, ...]
    s44: tuple[S44Contribution, ...]
    targets: tuple[TargetFit, ...]
    single_orientation: bool
    sightings: tuple[SightingFit, ...]


@dataclass(frozen=True)
class SightingQualityValues:
    """Quality of a sighting; None where a value does not apply or is not known."""

    target: str
    line: str
    rating: str
    reasons: tuple[Message, ...]
    points: int
    rms_m: float
    range_m: float
    density_per_m2: float | None
    incidence_deg: float | None
    coverage: float
    visible_share: float | None = None
    edited_by_hand: bool = False


@dataclass(frozen=True)
class PickedPlane:
    """A target or validation plane as picked; a sphere's radius is None where it is unknown."""

    name: str
    role: str
    shape: str
    sphere_radius_m: float | None
    used: bool
    seed_local_m: tuple[float, ...]
    threshold_m: float
    radius_m: float
    lines: tuple[str, ...]
    excluded_lines: tuple[str, ...]
    missing: Mapping[str, Message]


@dataclass(frozen=True)
class LineValues:
    """One line of the survey."""

    name: str
    file: str
    heading_deg: float | None
    points: int | None
    track_local_m: tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class ReportContent:
    """Content of a report."""

    program: str
    generated: str
    project: str
    identity: Identity
    calibrated: bool
    simulated: bool
    warnings: tuple[Message, ...]
    angles: tuple[AngleValues, ...]
    adjustment: AdjustmentValues | None
    cross_checks: CrossCheckValues | None
    validation: tuple[ValidationPlane, ...]
    swath_overlap: tuple[SwathDifference, ...]
    not_compared: tuple[Message, ...]
    planes: tuple[PickedPlane, ...]
    lines: tuple[LineValues, ...]
    settings: SettingsUsed
    files: tuple[InputFile, ...]
    notes: tuple[Message, ...]
    qualities: tuple[SightingQualityValues, ...] = ()
    in_convention: ConventionValues | None = None
    matrix: ScannerToBodyMatrix | None = None
    absolute: AbsoluteCheckValues | None = None
    budget: ErrorBudgetValues | None = None
    trajectory: tuple[LineTrajectorySummary, ...] = ()
    methods: tuple[MethodValues, ...] = ()
    method_messages: tuple[Message, ...] = ()
