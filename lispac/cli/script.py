"""``lispac script``: a project's steps as Python."""

import sys
from argparse import Namespace

from lispac.cli.console import ConsoleProgress, print_json
from lispac.message_texts import message_text
from lispac.workflow.output.script import save_script, script_of
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import load_survey


def script(arguments: Namespace) -> None:
    """Print or write the script, and report where it differs from the project."""
    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
        made = script_of(project, survey, progress=progress)
    if arguments.output is not None:
        save_script(made, arguments.output)
    if arguments.json:
        print_json({"script": made.text, "messages": list(map(message_text, made.messages))})
    else:
        print(made.text if arguments.output is None else arguments.output, end="")
        if arguments.output is not None:
            print()
    sys.stdout.flush()
    for message in made.messages:
        print(f"note: {message_text(message)}", file=sys.stderr)
