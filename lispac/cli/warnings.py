"""``lispac warnings``: all warnings about a project, as the window lists them."""

from argparse import Namespace
from dataclasses import asdict

from lispac.adjustment.shown import plain
from lispac.causes import RESULT
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.warnings_json import warnings_as_json
from lispac.message_texts import message_text
from lispac.progress import part
from lispac.workflow.projects import open_project
from lispac.workflow.qualities import qualities
from lispac.workflow.survey import load_survey
from lispac.workflow.warnings import warnings_of


def warnings(arguments: Namespace) -> None:
    """Print the list, warnings before notes."""
    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=part(progress, 0.0, 0.6))
        judged = qualities(project, survey, progress=part(progress, 0.6, 1.0))
    found = warnings_of(project, survey, judged)
    if arguments.json:
        values = [
            {
                "severity": "serious" if each.is_serious else "caution",
                "cause": asdict(each.subject or RESULT),
                **as_json,
            }
            for each, as_json in zip(found, warnings_as_json(found), strict=True)
        ]
        print_json({"warnings": values})
        return
    if not found:
        print("No warnings.")
    for each in found:
        print(f"{each.level}: {plain(message_text(each))}")
