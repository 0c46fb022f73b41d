"""``lispac targetless``: the boresight from the scene itself, and what to think of it."""

from argparse import Namespace

from lispac.cli.console import ConsoleProgress, UsageError, opened, print_json
from lispac.cli.estimate import numbers, print_result
from lispac.message_texts import english_text, message_text
from lispac.progress import part
from lispac.workflow.opinions import of_the_scene
from lispac.workflow.projects import save_project
from lispac.workflow.survey import load_survey
from lispac.workflow.targetless import targetless as find


def targetless(arguments: Namespace) -> None:
    """Find the boresight of a project from natural surfaces; with ``--keep`` it is kept.

    Raises
    ------
    UsageError
        Where options do not go together.
    """
    if arguments.keep and arguments.with_targets:
        raise UsageError(
            "targetless: a result that uses the targets is not independent of them; omit --keep "
            "or --with-targets."
        )
    with opened(arguments.project, change=arguments.keep) as project:
        with ConsoleProgress() as progress:
            survey = load_survey(project, progress=part(progress, 0.0, 0.3))
            found = find(
                project, survey, with_targets=arguments.with_targets,
                progress=part(progress, 0.3, 1.0),
            )  # fmt: skip
        if arguments.keep:
            save_project(project.with_opinion(of_the_scene(found)))
    if arguments.json:
        print_json(
            numbers(found.result, None)
            | {
                "rounds": found.rounds,
                "settled": found.settled,
                "candidates": found.candidates,
                "targets": found.targets,
                "disagreeing_lines": list(found.disagreeing),
                "remarks": [english_text(each) for each in found.remarks],
            }
        )
        return
    print_result(found.result, None)
    for remark in found.remarks:
        print(message_text(remark))
