"""``lispac script``: the steps of a project as a Python script."""

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.messages import print_messages


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--output", type=Path, metavar="FILE", help="script file (default: print it)"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print or write the script, and report how it differs from the project."""
    from lispac.workflow.output.script import save_script, script_of
    from lispac.workflow.project.projects import open_project
    from lispac.workflow.project.survey import load_survey

    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
        made = script_of(project, survey, progress=progress)
    if arguments.output is not None:
        save_script(made, arguments.output)
    if arguments.json:
        from lispac.cli.json_outputs import ScriptOutput

        print_json(ScriptOutput(made.text, tuple(made.messages)))
    else:
        print(made.text if arguments.output is None else arguments.output, end="")
        if arguments.output is not None:
            print()
    sys.stdout.flush()
    print_messages(made.messages)
