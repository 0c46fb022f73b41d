"""``lispac targetless``: boresight from natural surfaces of the scene."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, UsageError, opened_project, print_json
from lispac.cli.messages import console_text
from lispac.messages import Message, note

if TYPE_CHECKING:
    from lispac.project import Project
    from lispac.workflow.calibration.targetless import TargetlessResult


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--save",
        action="store_true",
        help="save the result in the project: as its boresight if it has no targets, otherwise "
        "beside that of the targets",
    )
    parser.add_argument(
        "--with-targets",
        action="store_true",
        help="also use the targets of the project in the adjustment",
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Estimate the boresight from natural surfaces; ``--save`` stores it.

    Raises
    ------
    UsageError
        If options cannot be combined.
    """
    from lispac.cli.calibration.result_output import adjustment_output, print_result, print_sigmas
    from lispac.progress import sub_progress
    from lispac.workflow.calibration.method_runs import with_targetless_result
    from lispac.workflow.calibration.targetless import targetless as find
    from lispac.workflow.project.projects import save_project
    from lispac.workflow.project.survey import load_survey

    if arguments.save and arguments.with_targets:
        raise UsageError(
            "targetless: a result that uses the targets is not independent of them; omit --save "
            "or --with-targets."
        )
    with opened_project(arguments.project, change=arguments.save) as project:
        with ConsoleProgress() as progress:
            survey = load_survey(project, progress=sub_progress(progress, 0.0, 0.3))
            found = find(
                project, survey, with_targets=arguments.with_targets,
                progress=sub_progress(progress, 0.3, 1.0),
            )  # fmt: skip
        if arguments.save:
            project = with_targetless_result(project, found)
            save_project(project)
    if arguments.json:
        from lispac.cli.json_outputs import TargetlessOutput, extended

        print_json(
            extended(
                TargetlessOutput,
                adjustment_output(found.result, None, headings_deg=survey.headings_deg),
                matching_iterations=found.iterations,
                converged=found.converged,
                candidates=found.candidates,
                given_targets=found.targets,
                disagreeing_lines=found.disagreeing_lines,
                messages=found.messages,
            )
        )
        return
    print_result(found.result, None)
    print_sigmas(found.project)
    for message in found.messages:
        print(console_text(message))
    if arguments.save:
        print(console_text(_kept_note(project, found)))


def _kept_note(project: Project, found: TargetlessResult) -> Message:
    """Note on how the result was saved in the project."""
    if project.is_targetless:
        return note("targetless.kept", count=len(found.project.targets))
    return note("targetless.kept_beside")
