"""``lispac demo``: calibration of a simulated survey, from the lines to the report."""

import subprocess
import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.checking.validate import print_validation, rms_with_truth
from lispac.cli.console import ConsoleProgress, has_display, print_json
from lispac.installation_paths import window_command


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "--output", type=Path, required=True, metavar="DIR", help="project folder to create"
    )
    parser.add_argument(
        "--no-window", action="store_true", help="do not open the main window at the end"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Simulate, calibrate, validate and report; then open the window if there is a display."""
    from lispac.cli.calibration.result_output import (
        print_result,
        print_sigmas,
        project_adjustment_output,
    )
    from lispac.duplicate_targets import project_warnings
    from lispac.workflow.output.export import write_report
    from lispac.workflow.planning import demo as demo_survey

    with ConsoleProgress() as progress:
        project, survey = demo_survey.run_demo(arguments.output, progress=progress)
        true = rms_with_truth(project, survey)
        report = project.folder / "report.pdf"
        write_report(project, survey, report)
        write_report(project, survey, report.with_suffix(".html"))
    truth_deg = project.truth_deg
    assert truth_deg is not None  # the survey is simulated
    if arguments.json:
        from lispac.cli.json_outputs import DemoOutput, extended
        from lispac.present.angles import angles

        print_json(
            extended(
                DemoOutput, project_adjustment_output(project, survey.headings_deg),
                truth_deg=angles(truth_deg), rms_truth_m=true, report=report,
                project=project.folder,
            )
        )  # fmt: skip
    else:
        assert project.result is not None
        print_result(
            project.result, project.cross_checks, project_warnings(project),
            truth_deg=truth_deg, picked_points=project.picked_points,
        )  # fmt: skip
        print_sigmas(project)
        print_validation(project, true)
        print(f"project    {project.folder}")
        print(f"report     {report}")
    if not arguments.no_window and has_display():
        sys.stdout.flush()
        subprocess.run([*window_command(), str(project.folder)], check=False)
