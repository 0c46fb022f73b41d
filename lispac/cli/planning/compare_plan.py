"""``lispac compare-plan``: comparison of a survey with its plan."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, print_json


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--plan", type=Path, required=True, metavar="FILE", help="survey plan (TOML file)"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print predicted and obtained standard deviations, and the deviations from the plan."""
    import numpy as np

    from lispac.adjustment.result import ANGLES
    from lispac.io.config.plan_file import read_plan
    from lispac.workflow.planning.plan_comparison import compare_with_plan
    from lispac.workflow.project.projects import open_project
    from lispac.workflow.project.survey import load_survey

    titled = read_plan(arguments.plan)
    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
    found = compare_with_plan(project, survey, titled)
    if arguments.json:
        rows = {
            "planned": found.planned,
            "surveyed": found.sailed,
            "surveyed_with_form_error": found.as_flat,
            "obtained": found.obtained,
        }
        values: dict[str, object] = {
            f"{name}_sigma_deg": np.degrees(row).tolist() if np.isfinite(row).all() else None
            for name, row in rows.items()
        }
        values["flatness_m"] = list(found.flatness)
        values["missing_targets"] = list(found.missing_targets)
        values["missing_lines"] = [line.name for line in found.missing_lines]
        print_json(values | {"messages": [str(each) for each in (*found.off_plan, *found.costs)]})
        return
    print(f"{'standard deviation (deg)':38s}" + "".join(f"{angle:>9s}" for angle in ANGLES))
    for name, *cells in found.rows:
        print(f"{name:38s}" + "".join(f"{cell:>9s}" for cell in cells))
    for sentence in found.summary_texts:
        print(sentence)
