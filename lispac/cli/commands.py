"""What each command does: read the arguments, call the workflow, print."""

import json
import math
import subprocess
import sys
from argparse import Namespace
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.adjustment.solver import adjust
from lispac.adjustment.stochastic import StochasticModel
from lispac.cli.console import ConsoleProgress, UsageError, has_display
from lispac.errors import InputError
from lispac.io.plane_file import read_plane_files
from lispac.project import LineSource, Project, Settings
from lispac.survey.georeferencing import Mounting
from lispac.workflow import calibration, export, picking, projects
from lispac.workflow import demo as demo_survey
from lispac.workflow.survey import Survey, load_survey
from lispac.workflow.validation import validate as compare

DEFAULT_LIDAR_SIGMA = 0.005


def demo(arguments: Namespace) -> None:
    """Simulate, calibrate, validate, report; then open the window where there is a screen."""
    with ConsoleProgress() as progress:
        project, survey = demo_survey.run_demo(arguments.output, progress=progress)
        report = project.folder / "report.pdf"
        export.write_report(project, survey, report)
        export.write_report(project, survey, report.with_suffix(".html"))
    if arguments.json:
        _print_json(_estimate_numbers(project) | {"truth_deg": _angles(project.truth_deg or ())}
                    | {"report": str(report), "project": str(project.folder)})  # fmt: skip
    else:
        _print_result(_result(project))
        if project.truth_deg is not None:
            print("truth      " + "".join(f"{angle:+12.4f}" for angle in project.truth_deg))
        _print_validation(project)
        print(f"project    {project.folder}")
        print(f"report     {report}")
    if not arguments.no_window and has_display():
        sys.stdout.flush()
        subprocess.run([sys.executable, "-m", "lispac.gui", str(project.folder)], check=False)


def new(arguments: Namespace) -> None:
    """Make a project; the lines are read once, so that what cannot be used is said now."""
    columns = tuple(arguments.columns.split(",")) if arguments.columns else ()
    given: dict[str, Any] = {
        "boresight_deg": arguments.boresight,
        "origin_deg_m": arguments.origin,
        "position_sigma": arguments.position_sigma,
        "attitude_sigma_deg": arguments.attitude_sigma,
    }
    triples: dict[str, Any] = {k: tuple(v) for k, v in given.items() if v is not None}
    settings = Settings(
        lever_arm=tuple(arguments.lever_arm),
        lidar_sigma=(
            DEFAULT_LIDAR_SIGMA if arguments.lidar_sigma is None else arguments.lidar_sigma
        ),
        **triples,
    )
    lines = [LineSource(name, path, columns) for name, path in _named(arguments.lines)]
    with ConsoleProgress() as progress:
        project, survey = projects.new_project(
            arguments.project,
            trajectory=arguments.trajectory,
            lines=lines,
            settings=settings,
            accuracy=arguments.trajectory_accuracy,
            progress=progress,
        )
    _notes(survey)
    points = {name: len(scan) for name, scan in survey.scans.items()}
    if arguments.json:
        _print_json({"project": str(project.folder), "points": points})
        return
    for name, count in points.items():
        heading = math.degrees(survey.heading[name]) % 360
        print(f"{name:20s} {count:12,} points, heading {heading:5.1f} deg")
    print(f"project    {project.folder}")


def pick(arguments: Namespace) -> None:
    """Find a plane in every line and save it."""
    project, survey = _open(arguments.project)
    with ConsoleProgress() as progress:
        project = picking.pick(
            project,
            survey,
            tuple(arguments.seed),
            name=arguments.name,
            role=arguments.role,
            line=arguments.line,
            threshold=arguments.threshold,
            radius=arguments.radius,
            progress=progress,
        )
    projects.save_project(project)
    target = project.target(arguments.name)
    usual = picking.DEFAULT_RADII[target.role][0]
    if arguments.radius is None and target.radius > usual:
        print(
            f"note: {target.name}: fewer than two lines have a plane within {usual:g} m of the "
            f"seed; sought within {target.radius:g} m",
            file=sys.stderr,
        )
    if arguments.json:
        _print_json(
            {
                "name": target.name,
                "role": target.role,
                "radius_m": target.radius,
                "lines": {
                    s.line: {"points": len(s.indices), "rms_m": s.rms} for s in target.sightings
                },
                "missing": dict(target.missing),
            }
        )
        return
    for sighting in target.sightings:
        print(
            f"{target.name} on {sighting.line:20s} {len(sighting.indices):8,} points, "
            f"RMS {sighting.rms * 1000:.1f} mm"
        )
    for line, reason in target.missing.items():
        print(f"{target.name} on {line:20s} not found: {reason}")


def estimate(arguments: Namespace) -> None:
    """Adjust the boresight of a project, or of plane files."""
    if arguments.planes:
        result = _estimate_planes(arguments)
        if arguments.json:
            _print_json(_numbers(result))
        else:
            _print_result(result)
        return
    if arguments.project is None:
        raise UsageError("estimate: name a project, or plane files with --planes.")
    for option in ("lever_arm", "boresight", "lidar_sigma"):
        if getattr(arguments, option) is not None:
            name = option.replace("_", "-")
            raise UsageError(f"estimate: --{name} goes with --planes; a project has its own.")
    project, survey = _open(arguments.project)
    with ConsoleProgress() as progress:
        project = calibration.estimate(
            project,
            survey,
            subsample=arguments.subsample,
            pos_errors=arguments.pos_errors,
            progress=progress,
        )
    projects.save_project(project)
    if arguments.json:
        _print_json(_estimate_numbers(project))
    else:
        _print_result(_result(project))


def validate(arguments: Namespace) -> None:
    """Compare the lines on the validation planes and save the figures."""
    project, survey = _open(arguments.project)
    with ConsoleProgress() as progress:
        project = compare(project, survey, progress=progress)
    projects.save_project(project)
    if arguments.json:
        _print_json(
            {
                "planes": [comparison.to_dict() for comparison in project.validation],
                "not_compared": dict(project.not_compared),
            }
        )
    else:
        _print_validation(project)


def georeference(arguments: Namespace) -> None:
    """Write the lines in the local frame."""
    project, survey = _open(arguments.project)
    with ConsoleProgress() as progress:
        paths = export.georeference_lines(
            project, survey, arguments.output, arguments.boresight, progress=progress
        )
    for path in paths:
        print(path)


def report(arguments: Namespace) -> None:
    """Write the report."""
    project, survey = _open(arguments.project)
    with ConsoleProgress() as progress:
        export.write_report(project, survey, arguments.output, progress=progress)
    print(arguments.output)


def _open(folder: Path) -> tuple[Project, Survey]:
    project = projects.open_project(folder)
    with ConsoleProgress() as progress:
        return project, load_survey(project, progress=progress)


def _named(paths: Iterable[Path]) -> list[tuple[str, Path]]:
    return [(path.stem, path) for path in paths]


def _notes(survey: Survey) -> None:
    for note in survey.notes:
        print(f"note: {note}", file=sys.stderr)


def _estimate_planes(arguments: Namespace) -> AdjustmentResult:
    if arguments.project is not None:
        raise UsageError("estimate: give a project or plane files, not both.")
    if arguments.lever_arm is None:
        raise UsageError("estimate: --planes needs --lever-arm X Y Z (0 0 0 where there is none).")
    sigma = DEFAULT_LIDAR_SIGMA if arguments.lidar_sigma is None else arguments.lidar_sigma
    if arguments.subsample:
        raise UsageError("estimate: --subsample goes with a project; plane files are thinned.")
    if len({path.resolve() for path in arguments.planes}) < len(arguments.planes):
        raise UsageError("estimate: a plane file is given twice; its points would count double.")
    observations, planes = read_plane_files(arguments.planes, sigma)
    mounting = Mounting(
        np.array(arguments.lever_arm), np.radians(arguments.boresight or (0.0, 0.0, 0.0))
    )
    model = StochasticModel(arguments.pos_errors or "independent")
    with ConsoleProgress() as progress:
        return adjust(observations, mounting, model, planes=planes, progress=progress)


def _result(project: Project) -> AdjustmentResult:
    if project.result is None:
        raise InputError(f"{project.name}: nothing has been estimated yet.")
    return project.result


def _angles(values: Iterable[float]) -> dict[str, float]:
    return {name: float(value) for name, value in zip(ANGLES, values, strict=True)}


def _estimate_numbers(project: Project) -> dict[str, Any]:
    return _numbers(_result(project)) | {"subsample_m": project.settings.subsample}


def _numbers(result: AdjustmentResult) -> dict[str, Any]:
    chi_square = result.chi_square
    return {
        "boresight_deg": _angles(np.degrees(result.boresight)),
        "sigma_deg": _angles(np.degrees(result.sigma)),
        "correlation": result.correlation.tolist(),
        "variance_factor": result.variance_factor,
        "chi_square": {
            "statistic": chi_square.statistic,
            "lower": chi_square.lower,
            "upper": chi_square.upper,
            "passed": chi_square.passed,
        },
        "iterations": result.iterations,
        "points": result.points,
        "sightings": len(result.sightings),
        "planes": len(result.targets),
        "elapsed_s": result.elapsed,
        "pos_errors": result.model.pos_errors,
        "prior_boresight_deg": _angles(np.degrees(result.prior_boresight)),
        "joint_plane_rms_m": {"before": result.rms_before, "after": result.rms_after},
    }


def _print_json(content: dict[str, Any]) -> None:
    print(json.dumps(content, indent=1, allow_nan=False))


def _print_result(result: AdjustmentResult) -> None:
    chi_square = result.chi_square
    verdict = "passed" if chi_square.passed else "FAILED"
    print("degrees    " + "".join(f"{name:>12s}" for name in ANGLES))
    rows = {
        "prior": np.degrees(result.prior_boresight),
        "boresight": np.degrees(result.boresight),
        "sigma": np.degrees(result.sigma),
        "95 %": 1.96 * np.degrees(result.sigma),
    }
    for name, values in rows.items():
        sign = "+" if name in ("prior", "boresight") else ""
        print(f"{name:11s}" + "".join(f"{value:{sign}12.4f}" for value in values))
    print(
        f"POS errors {result.model.pos_errors}; {result.points:,} points, "
        f"{len(result.sightings)} sightings, {len(result.targets)} planes, "
        f"{result.iterations} iterations, {result.elapsed:.3f} s"
    )
    print(
        f"variance factor {result.variance_factor:.3f}, chi-square {chi_square.statistic:.1f} "
        f"({chi_square.lower:.1f} to {chi_square.upper:.1f}: {verdict})"
    )
    if result.model.pos_errors == "independent":
        print("POS errors are taken as independent (thesis mode): the sigmas are too small")
    print(
        f"RMS to the joint planes {result.rms_before * 1000:.1f} mm before, "
        f"{result.rms_after * 1000:.1f} mm after"
    )


def _print_validation(project: Project) -> None:
    print(
        f"{'validation':12s}{'points':>10s}{'RMS before':>14s}{'RMS after':>14s}  mm, line to line"
    )
    for comparison in project.validation:
        print(
            f"{comparison.name:12s}{comparison.after.n:10,}"
            f"{comparison.before.rms * 1000:14.1f}{comparison.after.rms * 1000:14.1f}"
        )
    for reason in project.not_compared.values():
        print(f"not compared: {reason}")
