"""Result of an adjustment, as text and for JSON."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.result import AdjustmentResult, CrossChecks
from lispac.cli.console import print_facts, print_table
from lispac.cli.messages import console_text
from lispac.duplicate_targets import project_warnings
from lispac.geometry.frames import LocalFrame
from lispac.messages import Message
from lispac.present.angles import ROTATION_ENTRY, angles
from lispac.present.calibration.adjustment import adjustment_values, angle_values, boresight_table
from lispac.present.calibration.adjustment_fit import FIT_TITLE, fit_facts
from lispac.present.calibration.cross_checks import cross_check_values
from lispac.present.calibration.parameters import PARAMETERS_TABLE, VARIANCE_COMPONENTS_TABLE
from lispac.present.calibration.settings import origin_fact
from lispac.present.calibration.sigmas import SIGMAS_TITLE, sigma_facts, sigmas_used
from lispac.present.tables import COMPUTING_SECONDS, Fact
from lispac.project import Project
from lispac.survey.conventions.mounting_texts import orientation_text

if TYPE_CHECKING:
    from lispac.cli.json_outputs import AdjustmentOutput, ProjectAdjustmentOutput


def project_adjustment_output(
    project: Project, headings_deg: Mapping[str, float]
) -> ProjectAdjustmentOutput:
    """Result of a project for JSON; the headings are those of the lines, by name."""
    from lispac.cli.json_outputs import ProjectAdjustmentOutput, extended

    assert project.result is not None
    output = adjustment_output(
        project.result, project.cross_checks, project_warnings(project),
        headings_deg=headings_deg, picked_points=project.picked_points,
    )  # fmt: skip
    return extended(
        ProjectAdjustmentOutput, output, subsample_m=project.settings.subsample,
        standard_deviations=sigmas_used(project),
    )  # fmt: skip


def adjustment_output(
    result: AdjustmentResult,
    checks: CrossChecks | None,
    also: Sequence[Message] = (),
    *,
    headings_deg: Mapping[str, float] | None = None,
    picked_points: int | None = None,
) -> AdjustmentOutput:
    """Result of an adjustment for JSON, with the keys of the JSON report."""
    from lispac.cli.json_outputs import AdjustmentOutput, extended

    return extended(
        AdjustmentOutput, adjustment_values(result, headings_deg, picked_points),
        elapsed_s=result.elapsed,
        cross_checks=None if checks is None else cross_check_values(checks),
        warnings=tuple(result_warnings(result, checks, also)),
    )  # fmt: skip


def print_result(
    result: AdjustmentResult,
    checks: CrossChecks | None,
    also: Sequence[Message] = (),
    *,
    truth_deg: Sequence[float] | None = None,
    picked_points: int | None = None,
) -> None:
    """Print the result of an adjustment as text, with the true values of a simulated survey."""
    values = adjustment_values(result, picked_points=picked_points)
    true = None if truth_deg is None else angles(truth_deg)
    print_table(
        boresight_table(calibrated=True, simulated=true is not None),
        angle_values(values.prior_boresight_deg, values, true),
    )
    if result.mounting.axes is not None:
        print_steep_rotation(result)
    if values.parameters:
        print_table(PARAMETERS_TABLE, values.parameters)
    for parameter in values.parameters:
        if parameter.reason:
            print(console_text(parameter.reason))
    facts = [
        *fit_facts(values),
        Fact("Stochastic model", _error_model_text(result)),
        Fact("Targets", len(values.targets)),
        Fact("Sightings of targets", len(values.sightings)),
        Fact("Time of computation", f"{COMPUTING_SECONDS.text(result.elapsed)} s"),
    ]
    print_facts(FIT_TITLE, facts)
    if values.components:
        print_table(VARIANCE_COMPONENTS_TABLE, values.components)
    for each in result.observability.messages if result.observability else ():
        print(console_text(each))
    found = result_warnings(result, checks, also)
    if found:
        print("\nWarnings and notes:")
    for message in found:
        print(f"- {console_text(message)}")


def print_sigmas(project: Project) -> None:
    """Print the standard deviations used in the adjustment, and where they come from."""
    result = project.result
    sightings = () if result is None else adjustment_values(result).sightings
    model = project.settings.stochastic_model if result is None else result.model
    facts = sigma_facts(sigmas_used(project), model.lever_arm_sigma, sightings)
    print_facts(SIGMAS_TITLE, facts)


def print_origin(project: Project, frame: LocalFrame) -> None:
    """Print the position of the origin of the local frame."""
    is_given = project.settings.origin_deg_m is not None
    print_facts("Local frame", [origin_fact(frame.origin_deg_m, is_given=is_given)])


def print_steep_rotation(result: AdjustmentResult) -> None:
    """Print orientation and rotation matrix if the pitch is steep.

    Roll and yaw are then nearly dependent on each other.
    """
    print(
        "The pitch is near 90 deg: roll and yaw are hardly separable. The sigmas are those of "
        "small rotations about the body axes (forward, left, down)."
    )
    print(f"Orientation: {orientation_text(result.angles)}")
    print("Rotation matrix, LiDAR to body (forward, left, up):")
    for row in result.mounting.rotation_body_lidar:
        print("".join(f"{ROTATION_ENTRY.plain_text(value):>14s}" for value in row))


def _error_model_text(result: AdjustmentResult) -> str:
    model = result.model
    if not model.correlated:
        return f"uncorrelated (classical), loss {model.loss}"
    return (
        f"correlated over {model.position_time:g} s (position) and {model.attitude_time:g} s "
        f"(attitude), loss {model.loss}"
    )
