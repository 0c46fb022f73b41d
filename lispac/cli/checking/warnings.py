"""``lispac warnings``: all warnings about a project, as the window lists them."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.messages import console_text


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print the list, warnings before notes."""
    from lispac.progress import sub_progress
    from lispac.workflow.calibration.sighting_assessment import sighting_qualities
    from lispac.workflow.checking.warnings import warnings_of
    from lispac.workflow.project.projects import open_project
    from lispac.workflow.project.survey import load_survey

    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=sub_progress(progress, 0.0, 0.6))
        rated = sighting_qualities(project, survey, progress=sub_progress(progress, 0.6, 1.0))
    found = warnings_of(project, survey, rated)
    if arguments.json:
        from lispac.cli.json_outputs import WarningsOutput

        print_json(WarningsOutput(tuple(found)))
        return
    if not found:
        print("No warnings.")
    for each in found:
        print(f"{each.level}: {console_text(each)}")
