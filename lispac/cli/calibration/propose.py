"""``lispac propose``: proposed targets and validation planes."""

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, opened_project, print_json, print_table
from lispac.cli.messages import console_text, print_messages
from lispac.errors import ProjectError
from lispac.messages import error


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--accept", action="store_true", help="add the proposed targets to the project"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Detect planes in all lines, propose targets with reasons, and add them on request.

    Raises
    ------
    ProjectError
        If targets are to be added to a project that already has some.
    """
    from lispac.present.angles import AnglesRow
    from lispac.present.planning.design_results import PREDICTED_SIGMAS_TABLE, known_degrees
    from lispac.present.targets.seeds import SEED_METRES
    from lispac.workflow.calibration.proposal_acceptance import with_accepted_targets
    from lispac.workflow.calibration.proposals import propose_targets as proposal_for
    from lispac.workflow.calibration.target_search import thinned_notes
    from lispac.workflow.project import projects
    from lispac.workflow.project.survey import load_survey

    with opened_project(arguments.project, change=arguments.accept) as project:
        if arguments.accept and project.targets:
            raise ProjectError(
                error("cli.has_targets", project=project.name, count=len(project.targets))
            )
        with ConsoleProgress() as progress:
            survey = load_survey(project, progress=progress)
        with ConsoleProgress() as progress:
            proposal = proposal_for(project, survey, progress=progress)
        print_messages(each for target in proposal.targets for each in thinned_notes(target))
        if arguments.accept:
            names = [target.name for target in proposal.targets]
            projects.save_project(with_accepted_targets(project, proposal, names)[0])
    sigma = known_degrees(proposal.sigma)
    if arguments.json:
        from lispac.cli.json_outputs import ProposedTargetOutput, ProposeOutput, SightingOutput

        targets = tuple(
            ProposedTargetOutput(
                target.name, target.role, target.seed,
                {s.line: SightingOutput(len(s.indices), s.rms) for s in target.sightings},
                proposal.reasons[target.name],
            )
            for target in proposal.targets
        )  # fmt: skip
        print_json(ProposeOutput(targets, sigma, proposal.warnings, arguments.accept))
        return
    from lispac.geometry.frames import east_north_up

    for target in proposal.targets:
        east, north, up = map(SEED_METRES.plain_text, east_north_up(target.seed))
        print(f"{target.name:4s} {target.role:10s} at east {east}, north {north}, up {up} m")
        print(f"     {console_text(proposal.reasons[target.name])}")
    print_table(PREDICTED_SIGMAS_TABLE, [AnglesRow("all targets", sigma)])
    print_messages((*proposal.warnings, *proposal.notes), sys.stdout)
