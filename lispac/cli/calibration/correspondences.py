"""``lispac correspondences``: boresight from a file of pairs of points of the same place."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option, finite_number
from lispac.cli.console import ConsoleProgress, opened_project, print_json, print_table
from lispac.cli.messages import console_text


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "file", type=Path, metavar="FILE",
        help="text file with a pair of points in each row: t_i t_j x_i y_i z_i x_j y_j z_j (s, m; "
             "in the frame of the raw lines)",
    )  # fmt: skip
    parser.add_argument(
        "--noise", type=finite_number, metavar="METRES",
        help="standard deviation of a coordinate difference of a pair, without POS errors "
             "(default: estimated from the residuals)",
    )  # fmt: skip
    parser.add_argument(
        "--time-shift", type=finite_number, default=0.0, metavar="SECONDS",
        help="added to the times of the file (default 0)",
    )  # fmt: skip
    parser.add_argument(
        "--save",
        action="store_true",
        help="save the result in the project, beside that of the targets",
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Estimate the boresight from point correspondences; ``--save`` stores it."""
    from lispac.present.calibration.correspondences import (
        CORRESPONDENCES_TABLE,
        CorrespondenceValues,
    )
    from lispac.progress import sub_progress
    from lispac.workflow.calibration.correspondences import correspondences
    from lispac.workflow.project.projects import save_project
    from lispac.workflow.project.survey import load_survey

    with opened_project(arguments.project, change=arguments.save) as project:
        with ConsoleProgress() as progress:
            survey = load_survey(project, progress=sub_progress(progress, 0.0, 0.3))
            found = correspondences(
                project, survey, arguments.file, time_shift=arguments.time_shift,
                noise=arguments.noise, progress=sub_progress(progress, 0.3, 1.0),
            )  # fmt: skip
        if arguments.save:
            save_project(project.with_alternative_result(found.alternative))
    values = CorrespondenceValues.of(found.estimate, found.lines, found.messages)
    if arguments.json:
        print_json(values)
        return
    print_table(CORRESPONDENCES_TABLE, [values])
    for message in values.messages:
        print(console_text(message))
