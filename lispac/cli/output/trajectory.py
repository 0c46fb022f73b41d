"""``lispac trajectory``: the trajectory corrected by the adjustment."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, print_json, print_table
from lispac.cli.messages import print_messages


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--output", type=Path, required=True, metavar="FILE",
        help="corrected trajectory (SBET)",
    )  # fmt: skip
    parser.add_argument(
        "--accuracy", type=Path, metavar="FILE",
        help="smrmsg with the standard deviations after the adjustment (default: beside the SBET, "
             "NAME_smrmsg.out)",
    )  # fmt: skip
    parser.add_argument(
        "--corrections", type=Path, metavar="FILE",
        help="also write the corrections and their standard deviations as text (CSV)",
    )  # fmt: skip
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Write the files and print where the corrections are supported."""
    from lispac.present.output.pos_corrections import (
        POS_CORRECTIONS_TABLE,
        SIGHTED_INTERVALS_TABLE,
        pos_correction_values,
    )
    from lispac.workflow.output.corrected_trajectory import write_corrected_trajectory
    from lispac.workflow.project.projects import open_project

    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        written = write_corrected_trajectory(
            project,
            arguments.output,
            accuracy=arguments.accuracy,
            corrections=arguments.corrections,
            progress=progress,
        )
    print_messages(written.messages)
    values = pos_correction_values(written.estimate)
    if arguments.json:
        from lispac.cli.json_outputs import CorrectedTrajectoryOutput, extended

        print_json(
            extended(CorrectedTrajectoryOutput, values, files=written.paths, notes=written.messages)
        )
        return
    print_table(POS_CORRECTIONS_TABLE, values.components)
    print_table(SIGHTED_INTERVALS_TABLE, values.sighted_intervals)
    for path in written.paths:
        print(path)
