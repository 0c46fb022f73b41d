"""``lispac warnings``: all there is to be warned of in a project, as the window lists it."""

from argparse import Namespace
from dataclasses import asdict

from lispac.adjustment.shown import plain
from lispac.cli.console import ConsoleProgress, print_json
from lispac.progress import part
from lispac.workflow.projects import open_project
from lispac.workflow.qualities import qualities
from lispac.workflow.survey import load_survey
from lispac.workflow.warnings import concerns


def warnings(arguments: Namespace) -> None:
    """Print the list, serious things first."""
    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=part(progress, 0.0, 0.6))
        judged = qualities(project, survey, progress=part(progress, 0.6, 1.0))
    found = concerns(project, survey, judged)
    if arguments.json:
        print_json(
            {"warnings": [{**asdict(each), "text": plain(each.text)} for each in found]},
        )
        return
    if not found:
        print("Nothing to warn of.")
    for each in found:
        print(f"{each.severity}: {plain(each.text)}")
