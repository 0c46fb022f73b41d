"""Values of a report, not formatted.

Names end with the unit of their values and are also the keys of the JSON report, so that all
formats contain the same numbers. Texts are messages and labels, which `lispac.report.document`
translates into the language of the report.
"""

from dataclasses import dataclass, field

from lispac.identity import Identity
from lispac.messages import Message
from lispac.present.angles import Angles
from lispac.present.calibration.adjustment import AdjustmentValues, AngleValues, angle_values
from lispac.present.calibration.control import NO_CONTROL, ControlValues
from lispac.present.calibration.cross_checks import CrossCheckValues
from lispac.present.calibration.error_budget import ErrorBudgetValues
from lispac.present.calibration.methods import MethodValues
from lispac.present.calibration.settings import SettingsUsed
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.present.checking.acceptance import AcceptanceValues
from lispac.present.checking.validation import SwathDifference, ValidationPlane
from lispac.present.json_values import NOT_IN_JSON
from lispac.present.output.conventions import ConventionValues, ScannerToBodyMatrix
from lispac.present.output.pos_corrections import PosCorrectionValues
from lispac.present.survey.survey_data import (
    InputFile,
    LineTrajectorySummary,
    LineValues,
    PickedPlane,
)
from lispac.present.targets.sighting_quality import SightingQualityValues
from lispac.present.targets.surface_geometry import PlaneSection


@dataclass(frozen=True)
class ReportContent:
    """Content of a report.

    The true boresight is known for a simulated survey only; ``error_deg`` is the estimated
    boresight minus the true one. ``trajectory_corrections`` is null if the adjustment determines
    none. ``plane_sections`` are points for pictures, which the report in JSON does not contain.
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
    acceptance: AcceptanceValues
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
    control: ControlValues = NO_CONTROL
    trajectory_corrections: PosCorrectionValues | None = None
    plane_sections: tuple[PlaneSection, ...] = field(default=(), metadata=NOT_IN_JSON)

    @property
    def angles(self) -> tuple[AngleValues, ...]:
        """Prior, estimated and true value of each boresight angle."""
        return angle_values(self.prior_boresight_deg, self.adjustment, self.truth_deg)
