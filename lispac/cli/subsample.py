"""``lispac subsample``: boresight angles for several subsampling distances."""

from argparse import Namespace

import numpy as np

from lispac.adjustment.result import ANGLES
from lispac.cli.console import ConsoleProgress, print_json
from lispac.workflow.checking.subsampling import DISTANCES, subsampling_study
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import load_survey


def subsample(arguments: Namespace) -> None:
    """Print one row for each distance."""
    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
        distances = arguments.distances or DISTANCES
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
