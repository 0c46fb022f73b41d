"""``lispac subsample``: boresight angles for several point spacings."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option, finite_number
from lispac.cli.console import ConsoleProgress, print_json


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--distances", type=finite_number, nargs="+", metavar="M",
        help="point spacings to use (m; 0 uses all points; default 0 0.05 0.1 0.15 0.2)",
    )  # fmt: skip
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print one row for each point spacing."""
    import numpy as np

    from lispac.adjustment.result import ANGLES
    from lispac.workflow.checking.subsampling import DEFAULT_DISTANCES, subsampling_study
    from lispac.workflow.project.projects import open_project
    from lispac.workflow.project.survey import load_survey

    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
        distances = arguments.distances or DEFAULT_DISTANCES
        found = subsampling_study(project, survey, distances, progress=progress)
    if arguments.json:
        print_json(
            {
                "adjustments": [
                    {
                        "distance_m": each.distance,
                        "points": each.points,
                        "boresight_deg": np.degrees(each.boresight).tolist(),
                        "sigma_deg": np.degrees(each.sigma).tolist(),
                        "seconds": each.seconds,
                    }
                    for each in found
                ]
            }
        )
        return
    heads = "".join(f"{f'{angle}, 1 sigma':>20s}" for angle in ANGLES)
    print(f"{'distance m':>10s}{'points':>10s}{heads}{'s':>8s}  deg")
    for each in found:
        angles = "".join(
            f"{angle:+12.4f} {sigma:7.4f}"
            for angle, sigma in zip(np.degrees(each.boresight), np.degrees(each.sigma), strict=True)
        )
        name = f"{each.distance:.2f}" if each.distance else "all"
        print(f"{name:>10s}{each.points:10,}{angles}{each.seconds:8.2f}")
