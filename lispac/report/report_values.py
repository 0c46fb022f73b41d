"""Values of a report, not formatted.

Names end with the unit of their values and are also the keys of the JSON report, so that all
formats contain the same numbers. Texts are messages and labels, which `lispac.report.document`
translates into the language of the report.
"""

from dataclasses import dataclass

from lispac.identity import Identity
from lispac.messages import Message
from lispac.present.absolute import AbsoluteCheckValues
from lispac.present.adjustment import AdjustmentValues, AngleValues, angle_values
from lispac.present.angles import Angles
from lispac.present.conventions import ConventionValues, ScannerToBodyMatrix
from lispac.present.cross_checks import CrossCheckValues
from lispac.present.error_budget import ErrorBudgetValues
from lispac.present.methods import MethodValues
from lispac.present.sighting_quality import SightingQualityValues
from lispac.present.survey_data import (
    InputFile,
    LineTrajectorySummary,
    LineValues,
    PickedPlane,
)
from lispac.present.validation import SwathDifference, ValidationPlane


@dataclass(frozen=True)
class SettingsUsed:
    """Settings of a result; the POS sigmas are None if an accuracy file was given.

    The LiDAR noise is given along x, y, z, or for range and angle; if both are None,
    ``lidar_sigma_m`` applies to each axis. ``averaged``: close points are averaged, not thinned.
    ``surface_sigma_m`` is the value used; it is None before it is estimated and with uncorrelated
    POS errors. ``surface_from_data`` is None with uncorrelated POS errors. ``offset_sigma_m`` is
    None if it equals the surface sigma.
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
class ReportContent:
    """Content of a report.

    The true boresight is known for a simulated survey only; ``error_deg`` is the estimated
    boresight minus the true one.
    """

    program: str
    generated: str
    project: str
    identity: Identity
    calibrated: bool
    simulated: bool
    warnings: tuple[Message, ...]
    prior_boresight_deg: Angles
    truth_deg: Angles | None
    error_deg: Angles | None
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

    @property
    def angles(self) -> tuple[AngleValues, ...]:
        """Prior, estimated and true value of each boresight angle."""
        return angle_values(self.prior_boresight_deg, self.adjustment, self.truth_deg)
