"""What each command does: read the arguments, call the workflow, print."""

import math
import subprocess
import sys
from argparse import Namespace
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from lispac.adjustment.result import ANGLES
from lispac.cli.angles import angles as angles
from lispac.cli.budget import budget as budget
from lispac.cli.check import check as check
from lispac.cli.compare import compare as compare
from lispac.cli.console import ConsoleProgress, UsageError, has_display, print_json
from lispac.cli.estimate import estimate as estimate
from lispac.cli.estimate import print_result, project_numbers
from lispac.cli.estimate_options import noise_and_offsets
from lispac.cli.export import export as export
from lispac.cli.georeference import georeference as georeference
from lispac.cli.history import history as history
from lispac.cli.identity import identity as identity
from lispac.cli.import_lines import import_lines as import_lines
from lispac.cli.look import look as look
from lispac.cli.pick import pick as pick
from lispac.cli.propose import propose as propose
from lispac.cli.subsample import subsample as subsample
from lispac.doubles import doubles
from lispac.project import LineSource, Project, Reading, Settings
from lispac.report.json_report import schema_text
from lispac.validation.local_models import USUAL_NEIGHBOURS, LocalModel
from lispac.workflow import demo as demo_survey
from lispac.workflow import projects
from lispac.workflow.export import write_report
from lispac.workflow.report_options import report_options
from lispac.workflow.survey import Survey, load_survey
from lispac.workflow.validation import validate as validated
from lispac.workflow.validation import validate_with_truth


def demo(arguments: Namespace) -> None:
    """Simulate, calibrate, validate, report; then open the window where there is a screen."""
    with ConsoleProgress() as progress:
        project, survey = demo_survey.run_demo(arguments.output, progress=progress)
        true = rms_with_truth(project, survey)
        report = project.folder / "report.pdf"
        write_report(project, survey, report)
        write_report(project, survey, report.with_suffix(".html"))
    if arguments.json:
        truth = dict(zip(ANGLES, project.truth_deg or (), strict=True))
        print_json(project_numbers(project) | {"truth_deg": truth, "rms_truth_m": true}
                    | {"report": str(report), "project": str(project.folder)})  # fmt: skip
    else:
        assert project.result is not None
        print_result(project.result, project.cross_checks, doubles(project))
        if project.truth_deg is not None:
            print("truth      " + "".join(f"{angle:+12.4f}" for angle in project.truth_deg))
        _print_validation(project, true)
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
        lever_arm=tuple(arguments.lever_arm), **triples, **noise_and_offsets(arguments)
    )
    if arguments.longest_gap is not None:
        settings = replace(settings, longest_gap=arguments.longest_gap)
    reading = Reading(
        arguments.line_format or "", tuple(arguments.line_option), arguments.time_shift
    )
    lines = [LineSource(name, path, columns, reading) for name, path in _named(arguments.lines)]
    with ConsoleProgress() as progress:
        project, survey = projects.new_project(
            arguments.project,
            trajectory=arguments.trajectory,
            lines=lines,
            settings=settings,
            accuracy=arguments.trajectory_accuracy,
            trajectory_reading=Reading(
                arguments.trajectory_format or "", tuple(arguments.trajectory_option)
            ),
            accuracy_reading=Reading(
                arguments.accuracy_format or "", tuple(arguments.accuracy_option)
            ),
            progress=progress,
        )
    _notes(survey)
    points = {name: len(scan) for name, scan in survey.scans.items()}
    if arguments.json:
        print_json({"project": str(project.folder), "points": points})
        return
    for name, count in points.items():
        heading = math.degrees(survey.heading[name]) % 360
        print(f"{name:20s} {count:12,} points, heading {heading:5.1f} deg")
    print(f"project    {project.folder}")


def validate(arguments: Namespace) -> None:
    """Compare the lines on the validation planes and save the figures."""
    kind = arguments.distance_to
    if kind == "point" and not (arguments.radius is None and arguments.neighbours is None):
        raise UsageError(
            "validate: the distance to the nearest point knows no --radius and no --neighbours; "
            "leave them out, or take --distance-to plane."
        )
    usual = USUAL_NEIGHBOURS[kind]
    model = LocalModel(
        kind, usual if arguments.neighbours is None else arguments.neighbours, arguments.radius
    )
    project, survey = _open(arguments.project)
    with ConsoleProgress() as progress:
        project = validated(project, survey, model=model, progress=progress)
    projects.save_project(project)
    true = rms_with_truth(project, survey)
    if arguments.json:
        print_json(
            {
                "planes": [comparison.to_dict() for comparison in project.validation],
                "rms_truth_m": true,
                "not_compared": dict(project.not_compared),
                "doubts": [doubt.plain for doubt in doubles(project)],
            }
        )
    else:
        _print_validation(project, true)


def report(arguments: Namespace) -> None:
    """Write the report, or print the schema of its JSON."""
    if arguments.schema:
        print(schema_text(), end="")
        return
    if arguments.project is None or arguments.output is None:
        raise UsageError("report: give a project and --output FILE, or --schema alone.")
    options = report_options(
        arguments.template,
        arguments.page or "",
        arguments.convention or "",
        arguments.language or "",
    )
    project, survey = _open(arguments.project)
    with ConsoleProgress() as progress:
        write_report(project, survey, arguments.output, options=options, progress=progress)
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


def rms_with_truth(project: Project, survey: Survey) -> dict[str, float]:
    """RMS distance between the lines on each plane with the simulated boresight, metres."""
    if project.truth_deg is None:
        return {}
    return {each.name: each.after.rms for each in validate_with_truth(project, survey)}


def _print_validation(project: Project, true: Mapping[str, float]) -> None:
    last = f"{'with truth':>14s}" if true else ""
    heads = f"{'points':>10s}{'RMS before':>14s}{'RMS after':>14s}{last}"
    print(f"{'validation':12s}{heads}  mm, line to line")
    for each in project.validation:
        values = [each.before.rms, each.after.rms]
        if each.name in true:
            values.append(true[each.name])
        figures = "".join(f"{1000 * value:14.1f}" for value in values)
        print(f"{each.name:12s}{each.after.n:10,}{figures}")
    for reason in project.not_compared.values():
        print(f"not compared: {reason}")
    for doubt in doubles(project):
        print(f"note: {doubt.plain}")
