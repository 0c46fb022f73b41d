"""``lispac estimate``: adjust a project or plane files, and print the result."""

from __future__ import annotations

import argparse
from argparse import ArgumentParser, Namespace
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lispac.cli.argument_types import (
    add_json_option,
    add_triple_option,
    non_negative_number,
    positive_number,
)
from lispac.cli.console import ConsoleProgress, UsageError, opened_project, print_json
from lispac.cli.noise_options import (
    add_lever_arm_sigma_option,
    add_noise_options,
    add_offset_options,
    noise_and_offset_settings,
)

if TYPE_CHECKING:
    from lispac.adjustment.model.parameters import Parameter
    from lispac.adjustment.result import AdjustmentResult, CrossChecks
    from lispac.project import Project, Settings
    from lispac.targets.sighting_quality import SightingQuality
    from lispac.workflow.project.survey import Survey


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, nargs="?", metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--subsample",
        type=non_negative_number,
        metavar="METRES",
        help="point spacing (m): closer points are averaged, or with uncorrelated POS errors "
        "thinned to one (default 0.10; 0 keeps all points)",
    )
    _add_model_options(parser)
    parser.add_argument(
        "--estimate",
        action="append",
        metavar="NAME[=SIGMA]",
        help="additional parameter to estimate: lever-x, lever-y, lever-z, range-offset (m), "
        "scan-angle-offset (deg) or latency (s), optionally with the 1 sigma of its prior "
        "value; none estimates no additional parameter (default: as saved in the project)",
    )
    parser.add_argument(
        "--components",
        action=argparse.BooleanOptionalAction,
        help="estimate the sigmas of LiDAR and POS from the data (variance components); with "
        "--no-components, none is estimated",
    )
    parser.add_argument(
        "--auto-components",
        dest="components",
        action="store_const",
        const="auto",
        help="estimate only the sigmas that are assumed because nobody gave them (default of a "
        "new project)",
    )
    parser.add_argument(
        "--accept-single-orientation",
        action=argparse.BooleanOptionalAction,
        help="allow targets that all face the same way; the angles are then separated by the "
        "headings of the lines alone",
    )
    parser.add_argument(
        "--no-cross-checks",
        action="store_true",
        help="do not repeat the adjustment with subsets of the data",
    )
    _add_plane_file_options(parser)
    add_noise_options(parser)
    add_lever_arm_sigma_option(parser, "that of the project; 0 0 0 assumes an exact one")
    parser.add_argument(
        "--lidar-noise-source",
        choices=("given", "residuals"),
        help="where the LiDAR noise comes from: given (by the data sheet) or residuals (estimated "
        "by an earlier adjustment, so that the chi-square test cannot confirm it); default given "
        "with a LiDAR noise, otherwise unchanged",
    )
    add_offset_options(parser)
    add_json_option(parser)


def _add_plane_file_options(parser: ArgumentParser) -> None:
    """Add the options for plane files."""
    parser.add_argument(
        "--planes",
        type=Path,
        nargs="+",
        metavar="FILE",
        help="plane files with 25 columns, instead of a project",
    )
    add_triple_option(parser, "--lever-arm", ("X", "Y", "Z"), "with --planes: lever arm (m)")
    add_triple_option(
        parser,
        "--boresight",
        ("R", "P", "Y"),
        "with --planes: prior boresight (deg; default 0 0 0)",
    )


def _add_model_options(parser: ArgumentParser) -> None:
    """Add the options of the stochastic model."""
    parser.add_argument(
        "--pos-errors",
        choices=("independent", "correlated"),
        help="model of the POS errors: correlated between neighbouring points (default), or "
        "uncorrelated (classical model, one error for each point; its sigmas are too small)",
    )
    for name, default in (("position", 300), ("attitude", 600)):
        parser.add_argument(
            f"--{name}-time",
            type=positive_number,
            metavar="SECONDS",
            help=f"correlation time of the {name} error of the POS (s; default {default}); use the "
            "value of the processing report; too short is safer than too long",
        )
    parser.add_argument(
        "--surface",
        type=_surface_sigma,
        metavar="METRES",
        help="form error of the targets (m): standard deviation of the offset of a whole sighting "
        "from the common surface of all lines (default auto: estimated from the data)",
    )
    parser.add_argument(
        "--loss",
        choices=("auto", "none", "huber", "tukey"),
        help="loss function for outliers (default auto: tukey; with uncorrelated POS errors none)",
    )


def run(arguments: Namespace) -> None:
    """Adjust the boresight of a project, or of plane files.

    Raises
    ------
    UsageError
        If options cannot be combined.
    """
    from lispac.cli.calibration.result_output import adjustment_output, print_result
    from lispac.progress import sub_progress
    from lispac.workflow.calibration import estimation as calibration
    from lispac.workflow.calibration.sighting_assessment import sighting_qualities
    from lispac.workflow.project import projects
    from lispac.workflow.project.survey import load_survey

    if arguments.planes:
        result, checks = _estimate_planes(arguments)
        if arguments.json:
            print_json(adjustment_output(result, checks))
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
            settings = _settings_with_options(project.settings, arguments)
            settings.require_sound()
            if settings != project.settings:  # an offset changes the loaded points
                project = project.with_settings(settings)
            project = _with_scanner_name(project, arguments)
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
        _print_json_of_project(project, survey, found)
    else:
        _print_result_of_project(project, survey, found)


def _print_json_of_project(
    project: Project, survey: Survey, qualities: Mapping[tuple[str, str], SightingQuality]
) -> None:
    from lispac.cli.calibration.result_output import project_adjustment_output
    from lispac.cli.json_outputs import EstimateOutput, extended
    from lispac.present.calibration.control import ControlValues
    from lispac.present.targets.sighting_quality import quality_list

    print_json(
        extended(
            EstimateOutput, project_adjustment_output(project, survey.headings_deg),
            origin_deg_m=survey.trajectory.frame.origin_deg_m,
            qualities=quality_list(qualities, project.targets),
            control=ControlValues.of(project),
        )
    )  # fmt: skip


def _print_result_of_project(
    project: Project, survey: Survey, qualities: Mapping[tuple[str, str], SightingQuality]
) -> None:
    from lispac.cli.calibration.control import print_control
    from lispac.cli.calibration.result_output import print_origin, print_result, print_sigmas
    from lispac.duplicate_targets import project_warnings

    assert project.result is not None
    print_result(
        project.result, project.cross_checks, project_warnings(project),
        picked_points=project.picked_points,
    )  # fmt: skip
    if project.control:
        print_control(project)
    print_sigmas(project)
    print_origin(project, survey.trajectory.frame)
    print_weak_sightings(qualities)


def _with_scanner_name(project: Project, arguments: Namespace) -> Project:
    """Project with the name of the scanner of the option for the report, unless it has a name."""
    if arguments.scanner is None or project.identity.scanner:
        return project
    from lispac.workflow.planning.sensors import read_library, user_sensors_folder

    title = read_library(user_sensors_folder()).scanner(arguments.scanner).title
    return project.with_identity(project.identity.changed(scanner=title))


def _settings_with_options(settings: Settings, arguments: Namespace) -> Settings:
    """Settings changed by the options of the command line."""
    changes: dict[str, Any] = {
        "subsample": arguments.subsample,
        "pos_errors": arguments.pos_errors,
        "position_time": arguments.position_time,
        "attitude_time": arguments.attitude_time,
        "parameters": parse_parameters(arguments.estimate),
        "accept_single_orientation": arguments.accept_single_orientation,
    }
    settings = settings.with_values(**noise_and_offset_settings(arguments))
    if arguments.lever_arm_sigma is not None:
        settings = replace(settings, lever_arm_sigma=tuple(arguments.lever_arm_sigma))
    if arguments.lidar_noise_source is not None:
        settings = replace(settings, lidar_noise_source=arguments.lidar_noise_source)
    if arguments.loss is not None:
        settings = replace(settings, loss=None if arguments.loss == "auto" else arguments.loss)
    if arguments.components is not None:
        chosen = None if arguments.components == "auto" else arguments.components
        settings = replace(settings, variance_components=chosen)
    if arguments.surface is not None:
        settings = replace(
            settings, surface=None if arguments.surface == "auto" else arguments.surface
        )
    return replace(settings, **{key: value for key, value in changes.items() if value is not None})


def parse_parameters(named: Iterable[str] | None) -> tuple[Parameter, ...] | None:
    """Parse parameters given as ``NAME`` or ``NAME=SIGMA``; ``none`` gives an empty result.

    Raises
    ------
    UsageError
        If a parameter is unknown or its sigma is not a number.
    """
    from lispac.adjustment.model.parameters import OPTIONAL_NAMES, OUTPUT_UNITS, Parameter
    from lispac.project import require_prior_sigma

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
    import numpy as np

    from lispac.adjustment.diagnostics.crosscheck import cross_checks
    from lispac.adjustment.least_squares import adjust
    from lispac.io.text.plane_file import read_plane_files
    from lispac.project import Settings
    from lispac.survey.georeferencing import Mounting
    from lispac.workflow.calibration import estimation as calibration

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
    settings = _settings_with_options(Settings(lever_arm=tuple(arguments.lever_arm)), arguments)
    settings.require_sound()
    observations, planes = read_plane_files(arguments.planes, settings.used_lidar_sigma)
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
            assumed=tuple(g for g in settings.assumed_sigmas if g == "LiDAR"),
            accept_single_orientation=settings.accept_single_orientation, progress=progress,
        )  # fmt: skip
        result = replace(result, lidar_noise_from_residuals=settings.is_lidar_noise_from_residuals)
        if arguments.no_cross_checks:
            return result, None
        observations = observations.with_scaled_sigmas(*result.sigma_factors)
        return result, cross_checks(
            observations, mounting, result, settings.parameters, progress=progress
        )


def _surface_sigma(text: str) -> float | str:
    """Parse the sigma of a surface, metres, or ``auto``."""
    return text if text == "auto" else non_negative_number(text)


def print_weak_sightings(qualities: Mapping[tuple[str, str], SightingQuality]) -> None:
    """Print the sightings that are not good, the poor ones first."""
    from lispac.language import to_plain_text
    from lispac.present.targets.sighting_quality import rating_text, sighting_quality_values

    listed = [(key, quality) for key, quality in qualities.items() if quality.rating != "good"]
    if not listed:
        return
    print("\nSightings of targets and validation planes of doubtful or poor quality:")
    for (target, line), quality in sorted(listed, key=lambda each: each[1].rating != "poor"):
        text = rating_text(sighting_quality_values(target, line, quality))
        print(f"- {target} on {line}: {to_plain_text(text)}")
