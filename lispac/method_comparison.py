"""Comparison of the boresight angles from several methods (table 4.4 of the thesis)."""

from collections.abc import Mapping
from dataclasses import dataclass

from lispac.adjustment.model.parameters import mounting_value_names
from lispac.adjustment.result import ANGLES
from lispac.alternative_methods import COMPUTED_METHODS, Method
from lispac.messages import Message, note
from lispac.project import Project
from lispac.validation.repeatability import Calibration, CalibrationDifference, compare_calibrations

TARGETS_METHOD, TARGETLESS_METHOD = "targets", "targetless"
EFFECT_DISTANCE_M = 50.0
"""Distance in metres at which the effect of a difference on a point is given."""

METHOD_NAME_CODES: Mapping[str, str] = {
    TARGETS_METHOD: "method.targets",
    "natural planes": "method.natural_planes",
    "targetless": "method.targetless",
    "patch test": "method.patch_test",
    "correspondences": "method.correspondences",
}
"""Message code of the name of each method."""


@dataclass(frozen=True, eq=False)
class MethodResult:
    """Result of one method, compared with the first result.

    Attributes
    ----------
    calibration : Calibration
        Angles with their covariance; its name is that of the method.
    lines, surfaces : int
        Number of lines and surfaces used for the result.
    against : CalibrationDifference or None
        Difference from the first result to this one; None for the first.
    messages : tuple of Message
    """

    calibration: Calibration
    lines: int
    surfaces: int
    against: CalibrationDifference | None
    messages: tuple[Message, ...]

    @property
    def method(self) -> str:
        """Name of the method."""
        return self.calibration.name


def method_results(project: Project) -> tuple[MethodResult, ...]:
    """Results of all methods, starting with that of the project, each compared with the first."""
    found: list[MethodResult] = []

    def add(
        calibration: Calibration, lines: int, surfaces: int, messages: tuple[Message, ...]
    ) -> None:
        against = compare_calibrations(found[0].calibration, calibration) if found else None
        found.append(MethodResult(calibration, lines, surfaces, against, messages))

    result = project.result
    if result is not None:
        sightings = [each.sighting for each in result.sightings]
        method = TARGETLESS_METHOD if project.is_targetless else TARGETS_METHOD
        add(
            # All methods use the same lever arm.
            Calibration(method, result.boresight, result.with_exact_lever_arm.covariance),
            len({each.line for each in sightings}), len({each.target for each in sightings}),
            result.messages,
        )  # fmt: skip
    for each in project.alternative_results:
        add(
            Calibration(each.method, each.boresight, each.covariance),
            len(each.lines), each.surfaces, each.messages,
        )  # fmt: skip
    return tuple(found)


def missing_methods(project: Project) -> tuple[Method, ...]:
    """Methods without a result, of those that need only the lines."""
    return tuple(
        method
        for method in COMPUTED_METHODS
        if project.alternative_result(method) is None
        and not (method == TARGETLESS_METHOD and project.is_targetless)
    )


def comparison_messages(results: tuple[MethodResult, ...]) -> tuple[Message, ...]:
    """Notes on the agreement of each method with the first, and on its meaning; empty for one."""
    if len(results) < 2:
        return ()
    compared = [_agreement_note(each.against) for each in results if each.against is not None]
    return (*compared, note("methods.same_lines"))


def _agreement_note(against: CalibrationDifference) -> Message:
    angles = [name for name, yes in zip(ANGLES, against.significant, strict=True) if yes]
    code = "methods.differ" if angles else "methods.differ_together"
    return note(
        code if against.differ else "methods.agree",
        method=note(METHOD_NAME_CODES[against.second]),
        other=note(METHOD_NAME_CODES[against.first]),
        angles=mounting_value_names(angles),
        distance=EFFECT_DISTANCE_M,
        displacement=against.largest_displacement(EFFECT_DISTANCE_M),
    )
