"""What the commands write with ``--json``: a dataclass for each, whose fields are the keys.

Lengths are in metres, angles in degrees, times in seconds, as the ends of the names say. What is
not known is None. ``python -m tests.documents`` writes the JSON schemas from `OUTPUTS`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Literal, TypeVar

from lispac.identity import Identity
from lispac.io.config.sensor_file import PosSpecification, ScannerSpecification
from lispac.language import LazyText
from lispac.messages import Message
from lispac.present.angles import Angles
from lispac.present.calibration.adjustment import AdjustmentValues
from lispac.present.calibration.batch import BatchRow
from lispac.present.calibration.calibrations import (
    CalibrationDifferenceValues,
    CalibrationValues,
    CombinedCalibrations,
)
from lispac.present.calibration.control import ControlValues
from lispac.present.calibration.correspondences import CorrespondenceValues
from lispac.present.calibration.cross_checks import CrossCheckValues
from lispac.present.calibration.error_budget import ErrorBudgetValues
from lispac.present.calibration.methods import MethodValues
from lispac.present.calibration.patch_test import PatchTestValues
from lispac.present.calibration.sigmas import SigmaValues
from lispac.present.calibration.subsampling import SubsamplingValues
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.present.checking.acceptance import AcceptanceValues
from lispac.present.checking.line_differences import LineDifferenceValues
from lispac.present.checking.validation import ValidationPlane
from lispac.present.output.conventions import ConventionRules, ConventionValues, CorrectionValues
from lispac.present.output.pos_corrections import PosCorrectionValues
from lispac.present.planning.design_results import (
    DesignValues,
    PlanComparison,
    PredictionValues,
    ScenarioValues,
    SimulationValues,
)
from lispac.present.planning.visibility import ConfigurationValues, ThesisValues
from lispac.present.survey.input_file import FormatCheckValues
from lispac.present.targets.sighting_quality import PickedSightingValues, SightingQualityValues
from lispac.workflow.checking.calibration_history import CalibrationHistory

OutputT = TypeVar("OutputT")


def extended(kind: type[OutputT], values: Any, **further: Any) -> OutputT:
    """Output of a kind that has the fields of ``values`` and further ones."""
    return kind(**{each.name: getattr(values, each.name) for each in fields(values)}, **further)


@dataclass(frozen=True, kw_only=True)
class AdjustmentOutput(AdjustmentValues):
    """Result of an adjustment, as ``adjustment`` in the JSON report, with its cross-checks.

    ``elapsed_s`` is the time of the computation.
    """

    elapsed_s: float
    cross_checks: CrossCheckValues | None
    warnings: tuple[Message, ...]


@dataclass(frozen=True, kw_only=True)
class ProjectAdjustmentOutput(AdjustmentOutput):
    """Result of the adjustment of a project.

    ``subsample_m`` is the point spacing; ``standard_deviations`` are as in ``settings`` of the JSON
    report.
    """

    subsample_m: float
    standard_deviations: tuple[SigmaValues, ...]


@dataclass(frozen=True, kw_only=True)
class EstimateOutput(ProjectAdjustmentOutput):
    """Result of ``lispac estimate PROJECT``.

    ``origin_deg_m`` contains latitude, longitude and ellipsoidal height of the origin of the local
    frame, ``control`` the surveyed points, used or not, with their residuals.
    """

    origin_deg_m: tuple[float, ...]
    qualities: tuple[SightingQualityValues, ...]
    control: ControlValues


@dataclass(frozen=True, kw_only=True)
class DemoOutput(ProjectAdjustmentOutput):
    """Result of ``lispac demo``.

    ``rms_truth_m`` is the RMS distance between the lines with the true boresight, by plane.
    """

    truth_deg: Angles
    rms_truth_m: Mapping[str, float]
    report: Path
    project: Path


@dataclass(frozen=True, kw_only=True)
class TargetlessOutput(AdjustmentOutput):
    """Result of ``lispac targetless``.

    ``candidates`` is the number of surfaces found, ``given_targets`` that of the project's own
    targets in the adjustment.
    """

    matching_iterations: int
    converged: bool
    candidates: int
    given_targets: int
    disagreeing_lines: tuple[str, ...]
    messages: tuple[Message, ...]


@dataclass(frozen=True)
class SightingOutput:
    """Points of a target in one line, and the RMS distance from the surface."""

    points: int
    rms_m: float


@dataclass(frozen=True)
class SharedPointsOutput:
    """Target with which a target shares points of a line, and the share of the smaller one."""

    name: str
    line: str
    share_of_the_smaller: float


@dataclass(frozen=True, kw_only=True)
class PickOutput:
    """Result of ``lispac pick --seed``: the target, its search options, and its sightings by line.

    ``missing`` contains the reasons why there is no sighting, by line.
    """

    name: str
    role: str
    shape: str
    sphere_radius_m: float | None
    radius_m: float
    threshold_m: float
    min_points: int
    max_tilt_deg: float
    stop: float
    random_seed: int
    lines: Mapping[str, PickedSightingValues]
    missing: Mapping[str, Message]
    same_points_as: SharedPointsOutput | None


@dataclass(frozen=True, kw_only=True)
class SeedOutput:
    """Search at one seed of a list; ``reason`` is why no target was found, or None.

    ``seed_m`` is north, west, up from the origin of the local frame.
    """

    row: int
    name: str
    role: str
    seed_m: tuple[float, ...]
    found: bool
    reason: Message | None
    lines: Mapping[str, PickedSightingValues]
    missing: Mapping[str, Message]


@dataclass(frozen=True)
class SeedListOutput:
    """Result of ``lispac pick --seeds``."""

    seeds: tuple[SeedOutput, ...]


@dataclass(frozen=True)
class ProposedTargetOutput:
    """Target proposed by ``lispac propose``.

    ``seed_m`` is north, west, up from the origin of the local frame.
    """

    name: str
    role: str
    seed_m: tuple[float, ...]
    lines: Mapping[str, SightingOutput]
    reason: Message


@dataclass(frozen=True)
class ProposeOutput:
    """Result of ``lispac propose``.

    ``sigma_deg`` is the predicted precision, None if the targets do not determine the angles;
    ``accepted`` is True if the targets were added.
    """

    targets: tuple[ProposedTargetOutput, ...]
    sigma_deg: Angles | None
    warnings: tuple[Message, ...]
    accepted: bool


@dataclass(frozen=True)
class ValidateOutput:
    """Result of ``lispac validate``; its keys are those of the JSON report.

    ``rms_truth_m`` is the RMS distance between the lines with the true boresight, by plane; empty
    for a real survey.
    """

    validation: tuple[ValidationPlane, ...]
    rms_truth_m: Mapping[str, float]
    not_compared: tuple[Message, ...]
    acceptance: AcceptanceValues
    warnings: tuple[Message, ...]


@dataclass(frozen=True)
class SubsampleOutput:
    """Result of ``lispac subsample``."""

    adjustments: tuple[SubsamplingValues, ...]


@dataclass(frozen=True)
class ComparedCalibrationsOutput:
    """Result of ``lispac compare`` for several projects."""

    calibrations: tuple[CalibrationValues, ...]
    differences: tuple[CalibrationDifferenceValues, ...]
    combined: CombinedCalibrations
    messages: tuple[Message, ...]


@dataclass(frozen=True)
class ComparedMethodsOutput:
    """Result of ``lispac compare`` for one project.

    ``missing`` names the methods without a result; ``refused`` gives the reason why a method has
    failed.
    """

    methods: tuple[MethodValues, ...]
    messages: tuple[Message, ...]
    missing: tuple[str, ...]
    refused: Mapping[str, Message]


@dataclass(frozen=True)
class HistoryOutput:
    """Result of ``lispac history``."""

    systems: tuple[CalibrationHistory, ...]
    messages: tuple[Message, ...]


@dataclass(frozen=True)
class QualityOutput:
    """Result of ``lispac quality``."""

    boresight: Literal["prior", "estimated"]
    differences: tuple[LineDifferenceValues, ...]
    not_compared: tuple[Message, ...]


@dataclass(frozen=True)
class BatchOutput:
    """Result of ``lispac batch``."""

    projects: tuple[BatchRow, ...]


@dataclass(frozen=True)
class WarningsOutput:
    """Result of ``lispac warnings``."""

    warnings: tuple[Message, ...]


@dataclass(frozen=True)
class InspectOutput:
    """Result of ``lispac inspect``: the possible formats, the most likely one first."""

    file: Path
    formats: tuple[FormatCheckValues, ...]


@dataclass(frozen=True)
class NewOutput:
    """Result of ``lispac new``: number of points by line, and messages about the lines."""

    project: Path
    points: Mapping[str, int]
    messages: tuple[Message, ...]


@dataclass(frozen=True)
class ImportedLineOutput:
    """A line imported by ``lispac import``; ``seconds`` is 0 if it was imported before."""

    folder: Path
    points: int
    excluded_points: int
    bytes: int
    seconds: float
    assumptions: tuple[str, ...]


@dataclass(frozen=True)
class ImportOutput:
    """Result of ``lispac import``, by line."""

    lines: Mapping[str, ImportedLineOutput]


@dataclass(frozen=True)
class GeoreferencedLineOutput:
    """A file written by ``lispac georeference``, and the numbers of points in it and omitted.

    ``outside`` points are outside the trajectory, ``in_gaps`` are in gaps of it.
    """

    file: Path
    points: int
    outside: int
    in_gaps: int


@dataclass(frozen=True)
class GeoreferenceOutput:
    """Result of ``lispac georeference``."""

    lines: tuple[GeoreferencedLineOutput, ...]
    notes: tuple[Message, ...]


@dataclass(frozen=True, kw_only=True)
class CorrectedTrajectoryOutput(PosCorrectionValues):
    """Result of ``lispac trajectory``: the corrections and the files written."""

    files: tuple[Path, ...]
    notes: tuple[Message, ...]


@dataclass(frozen=True)
class ExportOutput:
    """Result of ``lispac export``: the files written."""

    files: tuple[Path, ...]


@dataclass(frozen=True)
class ScriptOutput:
    """Result of ``lispac script``: its text, and how it differs from the project."""

    script: str
    messages: tuple[Message, ...]


@dataclass(frozen=True)
class ConversionOutput:
    """Result of ``lispac angles``.

    ``matrix`` is the rotation matrix in the other system; ``correction`` is that of the current
    settings, or None if they are not given; ``file`` was written for the other program, or None.
    """

    from_: ConventionValues
    to: ConventionValues
    matrix: tuple[tuple[float, ...], ...]
    orientation_text: LazyText
    correction: CorrectionValues | None
    file: Path | None


@dataclass(frozen=True)
class SystemsOutput:
    """Result of ``lispac angles`` without arguments: the systems with their conventions."""

    systems: tuple[ConventionRules, ...]


@dataclass(frozen=True)
class VisibilityOutput:
    """Result of ``lispac visibility``; ``thesis`` is the comparison with Shahraji's thesis."""

    site: str
    beams: str
    best: tuple[ConfigurationValues, ...]
    thesis: tuple[ThesisValues, ...]
    files: tuple[Path, ...]


@dataclass(frozen=True, kw_only=True)
class PredictOutput(PredictionValues):
    """Result of ``lispac predict``.

    ``largest_sigma_without_deg`` is the largest predicted sigma without each target and each line.
    """

    title: str
    largest_sigma_without_deg: Mapping[str, float | None]
    messages: tuple[Message, ...]


@dataclass(frozen=True)
class ScenariosOutput:
    """Result of ``lispac scenarios``."""

    outcomes: tuple[ScenarioValues, ...]


@dataclass(frozen=True, kw_only=True)
class DesignOutput(DesignValues):
    """Result of ``lispac design``."""

    title: str


@dataclass(frozen=True, kw_only=True)
class CampaignOutput(SimulationValues):
    """Result of ``lispac campaign``."""

    title: str
    surveys: int
    seed: int


@dataclass(frozen=True, kw_only=True)
class ScannerOutput(ScannerSpecification):
    """Scanner of the library."""

    user_defined: bool


@dataclass(frozen=True, kw_only=True)
class PosOutput(PosSpecification):
    """INS/GNSS of the library."""

    user_defined: bool


@dataclass(frozen=True)
class SensorsOutput:
    """Result of ``lispac sensors``, by name; ``folder`` contains the sensors of the user."""

    folder: Path
    scanners: Mapping[str, ScannerOutput]
    pos: Mapping[str, PosOutput]


@dataclass(frozen=True)
class SimulateOutput:
    """Result of ``lispac simulate``: number of points by line, files, and titles of the parts."""

    project: Path
    points: Mapping[str, int]
    truth: Path
    seeds: Path | None
    ball_seeds: Path | None
    scene: str
    vessel: str
    scanner: str


@dataclass(frozen=True)
class SuppliedPartsOutput:
    """Result of ``lispac simulate --list``: titles by name."""

    scenes: Mapping[str, str]
    vessels: Mapping[str, str]
    scanners: Mapping[str, str]


OUTPUTS: Mapping[str, Any] = {
    "demo": DemoOutput,
    "simulate": SimulateOutput | SuppliedPartsOutput,
    "sensors": SensorsOutput,
    "inspect": InspectOutput,
    "new": NewOutput,
    "import": ImportOutput,
    "pick": PickOutput | SeedListOutput,
    "propose": ProposeOutput,
    "control": ControlValues,
    "estimate": EstimateOutput | AdjustmentOutput,
    "subsample": SubsampleOutput,
    "validate": ValidateOutput,
    "check": AbsoluteCheckValues,
    "compare": ComparedCalibrationsOutput | ComparedMethodsOutput,
    "targetless": TargetlessOutput,
    "history": HistoryOutput,
    "budget": ErrorBudgetValues,
    "patchtest": PatchTestValues,
    "correspondences": CorrespondenceValues,
    "quality": QualityOutput,
    "georeference": GeoreferenceOutput,
    "trajectory": CorrectedTrajectoryOutput,
    "export": ExportOutput,
    "identity": Identity,
    "acceptance": AcceptanceValues,
    "script": ScriptOutput,
    "batch": BatchOutput,
    "warnings": WarningsOutput,
    "angles": ConversionOutput | SystemsOutput,
    "visibility": VisibilityOutput,
    "predict": PredictOutput,
    "scenarios": ScenariosOutput,
    "design": DesignOutput,
    "campaign": CampaignOutput,
    "compare-plan": PlanComparison,
}
"""Types of the output of each command with ``--json``."""
