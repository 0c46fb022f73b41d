"""``lispac campaign``: many simulated surveys of a plan, to check its predicted sigmas."""

from argparse import Namespace

import numpy as np

from lispac.adjustment.result import ANGLES
from lispac.cli.cluster_access import cluster_access
from lispac.cli.console import ConsoleProgress, print_json
from lispac.design.monte_carlo import MonteCarloResult
from lispac.io.config.plan_file import read_plan
from lispac.workflow.planning.parallel_map import choose_mapper
from lispac.workflow.planning.plan_checks import result_heading, simulate_surveys


def campaign(arguments: Namespace) -> None:
    """Print the scatter of the simulated results beside the formal and the predicted sigmas."""
    titled = read_plan(arguments.plan)
    with (
        ConsoleProgress() as progress,
        choose_mapper(arguments.workers, cluster_access(arguments)) as mapper,
    ):
        found = simulate_surveys(
            titled.plan, arguments.surveys, seed=arguments.seed,
            flatness_known=arguments.flatness_known, mapper=mapper, progress=progress,
        )  # fmt: skip
    if arguments.json:
        print_json(
            {
                "title": titled.title,
                "surveys": arguments.surveys,
                "seed": arguments.seed,
                "failed": found.failed,
                "scatter_deg": np.degrees(found.empirical_sigma).tolist(),
                "formal_sigma_deg": np.degrees(found.mean_formal_sigma).tolist(),
                "predicted_sigma_deg": np.degrees(found.predicted).tolist(),
                "coverage_95": found.interval_coverage.tolist(),
                "bias_deg": np.degrees(found.bias).tolist(),
                "bias_sigma_deg": np.degrees(found.sigma_bias).tolist(),
                "chi_square": found.chi_square,
                "chi_square_expected": list(found.chi_square_bounds),
                "messages": list(found.summary_texts),
            }
        )
        return
    print(result_heading(titled.title, found, arguments.surveys))
    print(scatter_table(found))
    for sentence in found.summary_texts:
        print(sentence)


def scatter_table(result: MonteCarloResult) -> str:
    """Table of sigmas and hits, one row each, with a column for each angle."""
    lines = [f"{name:22s}" + "".join(f"{cell:>9s}" for cell in row) for name, *row in result.rows]
    return "\n".join([" " * 22 + "".join(f"{angle:>9s}" for angle in ANGLES), *lines])
