"""``lispac compare-plan``: comparison of a survey with its plan."""

from argparse import ArgumentParser, Namespace
from dataclasses import replace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, print_json, print_table


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--plan", type=Path, required=True, metavar="FILE", help="survey plan (TOML file)"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print predicted and obtained standard deviations, and the deviations from the plan."""
    from lispac.io.config.plan_file import read_plan
    from lispac.present.planning.design_results import ANGLES_BY_ROW_TABLE
    from lispac.workflow.planning.plan_comparison import compare_with_plan
    from lispac.workflow.project.projects import open_project
    from lispac.workflow.project.survey import load_survey

    titled = read_plan(arguments.plan)
    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
    found = compare_with_plan(project, survey, titled)
    if arguments.json:
        print_json(found)
        return
    title = f"Standard deviations of {project.name} compared with {titled.title}"
    print_table(replace(ANGLES_BY_ROW_TABLE, title=title), found.rows)
    for sentence in found.summary_texts:
        print(sentence)
