"""``lispac estimate``: adjust a project or plane files, and print the result."""

from argparse import Namespace
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from lispac.adjustment.crosscheck import cross_checks
from lispac.adjustment.display_text import OUTPUT_UNITS, number_with_noun, to_plain_text
from lispac.adjustment.parameters import OPTIONAL_NAMES, Parameter
from lispac.adjustment.result import AdjustmentResult, CrossChecks
from lispac.adjustment.solver import adjust
from lispac.adjustment.warnings import result_warnings
from lispac.cli.console import ConsoleProgress, UsageError, opened_project, print_json, print_table
from lispac.cli.estimate_options import noise_and_offset_settings
from lispac.cli.sighting_qualities import print_weak_sightings
from lispac.cli.warnings_json import warnings_as_json
from lispac.duplicate_targets import project_warnings
from lispac.io.text.plane_file import read_plane_files
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.present.adjustment import adjustment_values, angle_values, boresight_table
from lispac.present.angles import SIGMAS, angles
from lispac.present.cross_checks import cross_check_values, spread_rows
from lispac.present.json_values import json_values
from lispac.present.parameters import PARAMETERS, VARIANCE_COMPONENTS
from lispac.present.sighting_quality import quality_list
from lispac.progress import sub_progress
from lispac.project import Project, Settings, require_prior_sigma
from lispac.survey.conventions.mounting_texts import orientation_text
from lispac.survey.georeferencing import Mounting
from lispac.workflow.calibration import estimation as calibration
from lispac.workflow.calibration.sighting_assessment import sighting_qualities
from lispac.workflow.project import projects
from lispac.workflow.project.survey import load_survey


def estimate(arguments: Namespace) -> None:
    """Adjust the boresight of a project, or of plane files.

    Raises
    ------
    UsageError
        Where options do not go together.
    """
    if arguments.planes:
        result, checks = _estimate_planes(arguments)
        if arguments.json:
            print_json(result_values(result, checks))
        else:
            print_result(result, checks)
        return
    if arguments.project is None:
        raise UsageError("estimate: give a project, or plane files with --planes.")
    for option in ("lever_arm", "boresight"):
        if getattr(arguments, option) is not None:
            name = option.replace("_", "-")
            raise UsageError(f"estimate: --{name} requires --planes; a project contains its own.")
    with opened_project(arguments.project, change=True) as project:
        with ConsoleProgress() as progress:
            settings = settings_with_options(project.settings, arguments)
            settings.require_sound()
            if settings != project.settings:  # an offset moves the points that are loaded
                project = project.with_settings(settings)
            survey = load_survey(project, progress=progress)
            project = calibration.estimate(
                project,
                survey,
                cross_check=not arguments.no_cross_checks,
                progress=sub_progress(progress, 0.0, 0.9),
            )
            found = sighting_qualities(project, survey, progress=sub_progress(progress, 0.9, 1.0))
        projects.save_project(project)
    if arguments.json:
        print_json(project_result_values(project) | {"qualities": json_values(quality_list(found))})
    else:
        assert project.result is not None
        print_result(project.result, project.cross_checks, project_warnings(project))
        print_weak_sightings(found)


def settings_with_options(settings: Settings, arguments: Namespace) -> Settings:
    """Settings changed by the options of the command line."""
    changes: dict[str, Any] = {
        "subsample": arguments.subsample,
        "pos_errors": arguments.pos_errors,
        "position_time": arguments.position_time,
        "attitude_time": arguments.attitude_time,
        "parameters": parse_parameters(arguments.estimate),
        "variance_components": arguments.components,
        "accept_single_orientation": arguments.accept_single_orientation,
    }
    settings = replace(settings, **noise_and_offset_settings(arguments))
    if arguments.loss is not None:
        settings = replace(settings, loss=None if arguments.loss == "auto" else arguments.loss)
    if arguments.surface is not None:
        settings = replace(
            settings, surface=None if arguments.surface == "auto" else arguments.surface
        )
    return replace(settings, **{key: value for key, value in changes.items() if value is not None})


def parse_parameters(named: Iterable[str] | None) -> tuple[Parameter, ...] | None:
    """Parameters from ``NAME`` or ``NAME=SIGMA``; none at all from ``none``.

    Raises
    ------
    UsageError
        If a parameter is unknown or its sigma is not a number.
    """
    if named is None:
        return None
    found = []
    for text in named:
        if text == "none":
            continue
        name, _, sigma = text.partition("=")
        name = name.replace("-", "_")
        if name not in OPTIONAL_NAMES:
            choices = ", ".join(each.replace("_", "-") for each in OPTIONAL_NAMES)
            raise UsageError(f"estimate: there is no parameter {name}; give one of {choices}.")
        try:
            parameter = Parameter(name, float(sigma) / OUTPUT_UNITS[name][0] if sigma else None)
        except ValueError:
            raise UsageError(f"estimate: {sigma!r} in {text} is not a number.") from None
        if parameter.sigma is None or parameter.sigma > 0:
            require_prior_sigma(parameter)
        found.append(parameter)
    return tuple(found)


def _estimate_planes(arguments: Namespace) -> tuple[AdjustmentResult, CrossChecks | None]:
    if arguments.project is not None:
        raise UsageError("estimate: give a project or plane files, not both.")
    if arguments.lever_arm is None:
        raise UsageError("estimate: --planes requires --lever-arm X Y Z (0 0 0 if there is none).")
    if arguments.latency is not None:
        raise UsageError(
            "estimate: --latency requires a project; plane files already contain interpolated "
            "positions."
        )
    if len({path.resolve() for path in arguments.planes}) < len(arguments.planes):
        raise UsageError("estimate: a plane file is given twice; give each file once.")
    settings = settings_with_options(Settings(lever_arm=tuple(arguments.lever_arm)), arguments)
    settings.require_sound()
    observations, planes = read_plane_files(arguments.planes, settings.lidar_sigma)
    observations = calibration.with_lidar_noise(observations, settings)
    mounting = Mounting.with_nearest_axes(
        np.array(arguments.lever_arm),
        np.radians(arguments.boresight or (0.0, 0.0, 0.0)),
        settings.range_offset,
        float(np.radians(settings.scan_angle_offset_deg)),
    )
    observations = calibration.thin_observations(observations, mounting, settings)
    with ConsoleProgress() as progress:
        result = adjust(
            observations, mounting, settings.stochastic_model, parameters=settings.parameters,
            shapes=planes, components=settings.variance_components,
            accept_single_orientation=settings.accept_single_orientation, progress=progress,
        )  # fmt: skip
        if arguments.no_cross_checks:
            return result, None
        observations = observations.with_sigmas(*result.sigma_factors)
        return result, cross_checks(
            observations, mounting, result, settings.parameters, progress=progress
        )


def project_result_values(project: Project) -> dict[str, Any]:
    """Result of a project as plain values, in degrees and metres."""
    assert project.result is not None
    values = result_values(project.result, project.cross_checks, project_warnings(project))
    return values | {"subsample_m": project.settings.subsample}


def result_values(
    result: AdjustmentResult, checks: CrossChecks | None, also: Sequence[Message] = ()
) -> dict[str, Any]:
    """Result of an adjustment as plain values: the keys of the JSON report."""
    values: dict[str, Any] = json_values(adjustment_values(result))
    return values | {
        "cross_checks": None if checks is None else json_values(cross_check_values(checks)),
        "warnings": warnings_as_json(result_warnings(result, checks, also)),
    }


def print_result(
    result: AdjustmentResult,
    checks: CrossChecks | None,
    also: Sequence[Message] = (),
    *,
    truth_deg: Sequence[float] | None = None,
) -> None:
    """Print the result of an adjustment as text, of a simulated survey beside the truth."""
    values = adjustment_values(result)
    chi_square = result.chi_square
    size = "large" if chi_square.statistic < chi_square.lower else "small"
    verdict = "passed" if chi_square.passed else f"failed, the given sigmas are too {size}"
    true = None if truth_deg is None else angles(truth_deg)
    print_table(
        boresight_table(calibrated=True, simulated=true is not None),
        angle_values(values.prior_boresight_deg, values, true),
    )
    if result.mounting.axes is not None:
        print_steep_rotation(result)
    if checks is not None:
        print_table(SIGMAS, spread_rows(cross_check_values(checks)))
    if values.parameters:
        print_table(PARAMETERS, values.parameters)
    for parameter in values.parameters:
        if parameter.reason:
            print(to_plain_text(message_text(parameter.reason)))
    outliers = (
        f" ({number_with_noun(result.excluded_outliers, 'outlier')} excluded)"
        if result.excluded_outliers
        else ""
    )
    print(
        f"POS errors {_error_model_text(result)}; "
        f"{number_with_noun(result.points, 'point')}{outliers}, "
        f"{number_with_noun(len(result.sightings), 'sighting')}, "
        f"{number_with_noun(len(result.targets), 'target')}, "
        f"{number_with_noun(result.iterations, 'iteration')}, {result.elapsed:.3f} s"
    )
    print(
        f"variance factor {result.variance_factor:.3f}, chi-square {chi_square.statistic:.1f} "
        f"({chi_square.lower:.1f} to {chi_square.upper:.1f}: {verdict})"
    )
    print(
        f"RMS distance from the target surfaces {result.rms_before * 1000:.1f} mm before, "
        f"{result.rms_after * 1000:.1f} mm after"
    )
    if values.components:
        print_table(VARIANCE_COMPONENTS, values.components)
    for each in result.observability.messages if result.observability else ():
        print(to_plain_text(message_text(each)))
    found = result_warnings(result, checks, also)
    if found:
        print("\nWarnings and notes:")
    for message in found:
        print(f"- {to_plain_text(message_text(message))}")


def print_steep_rotation(result: AdjustmentResult) -> None:
    """Print the rotation matrix for a steep pitch, where roll and yaw are nearly dependent."""
    print(
        "The pitch is near 90 deg: roll and yaw are hardly separable. The sigmas are those of "
        "small rotations about the body axes (forward, left, down)."
    )
    print(f"Orientation: {orientation_text(result.angles)}")
    print("Rotation matrix, LiDAR to body (forward, left, up):")
    for row in result.mounting.rotation_body_lidar:
        print("".join(f"{value:+14.8f}" for value in row))


def _error_model_text(result: AdjustmentResult) -> str:
    model = result.model
    if not model.correlated:
        return f"uncorrelated (classical), loss {model.loss}"
    return (
        f"correlated over {model.position_time:g} s (position) and {model.attitude_time:g} s "
        f"(attitude), loss {model.loss}"
    )
