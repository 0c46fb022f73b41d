"""``lispac campaign``: many simulated surveys of a plan, to check its predicted sigmas."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option, whole_number_from
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.planning.worker_options import add_worker_options, cluster_access

if TYPE_CHECKING:
    from lispac.design.monte_carlo import MonteCarloResult


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "plan", type=Path, metavar="PLAN", help="survey plan: TOML file with targets and lines"
    )
    parser.add_argument(
        "--surveys", type=whole_number_from(2), default=200, metavar="N",
        help="number of surveys to simulate and adjust (default 200)",
    )  # fmt: skip
    parser.add_argument(
        "--seed",
        type=whole_number_from(0),
        default=2027,
        help="seed of the random numbers (default 2027)",
    )
    parser.add_argument(
        "--flatness-known", action="store_true",
        help="give the form error of the targets to the adjustment (default: estimated from the "
             "data, as lispac estimate does)",
    )  # fmt: skip
    add_worker_options(parser)
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print the scatter of the simulated results, and the formal and predicted sigmas."""
    import numpy as np

    from lispac.io.config.plan_file import read_plan
    from lispac.workflow.planning.parallel_map import choose_mapper
    from lispac.workflow.planning.plan_checks import result_heading, simulate_surveys

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
    """Text table of the results of a simulation, with a column for each angle."""
    from lispac.adjustment.result import ANGLES

    lines = [f"{name:22s}" + "".join(f"{cell:>9s}" for cell in row) for name, *row in result.rows]
    return "\n".join([" " * 22 + "".join(f"{angle:>9s}" for angle in ANGLES), *lines])
