"""``lispac design``: the best boards and lines for a site."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option, positive_number, whole_number_from
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.planning.predict import sigma_degrees, sigma_text
from lispac.cli.planning.worker_options import add_worker_options, cluster_access
from lispac.message_texts import message_text

if TYPE_CHECKING:
    from lispac.design.plan import Plan
    from lispac.design.plan_search import DesignResult
    from lispac.design.site import Site

CRITERION_NAMES = ("largest", "roll", "pitch", "yaw", "A", "D")
"""Names of `lispac.design.objective.CRITERION_TEXTS`."""


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "site", metavar="SITE",
        help="TOML file with the limits of the site, or the name of a built-in site: quay, "
             "quay-and-tower",
    )  # fmt: skip
    parser.add_argument(
        "--for", dest="criterion", choices=CRITERION_NAMES, default="largest",
        help="criterion to minimise: the largest sigma (default), the sigma of one angle, or the "
             "root mean square of the sigmas (A) or the mean radius of their confidence ellipsoid "
             "(D)",
    )  # fmt: skip
    parser.add_argument(
        "--plans", type=whole_number_from(1), default=10_000, metavar="N",
        help="approximate number of survey plans to evaluate (default 10000)",
    )  # fmt: skip
    parser.add_argument(
        "--pos-factors", type=positive_number, nargs="+", default=[1.0], metavar="F",
        help="factors on the POS sigmas; the criterion is averaged over them (default 1)",
    )  # fmt: skip
    parser.add_argument(
        "--seed", type=int, default=2019, help="seed of the random search (default 2019)"
    )
    add_worker_options(parser)
    parser.add_argument(
        "--output", type=Path, metavar="DIR",
        help="output folder for plan.toml, the field plan (PDF) and the sigmas of shorter surveys",
    )  # fmt: skip
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print the best plan, the sigma without each of its parts, and the sigmas of shorter plans."""
    import numpy as np

    from lispac.adjustment.result import ANGLES
    from lispac.design.objective import CRITERION_TEXTS, PlanObjective
    from lispac.design.plan_choices import thesis_plan
    from lispac.design.plan_search import search
    from lispac.design.prediction import predict
    from lispac.io.config.plan_file import read_site
    from lispac.simulation.closed_form_survey import Board
    from lispac.workflow.planning.parallel_map import choose_mapper
    from lispac.workflow.planning.plan_checks import observability_messages, write_design
    from lispac.workflow.planning.simulated_setup import setup_file

    title, site = read_site(setup_file("site", arguments.site, None))
    objective = PlanObjective(arguments.criterion, tuple(arguments.pos_factors))
    with (
        ConsoleProgress() as progress,
        choose_mapper(arguments.workers, cluster_access(arguments)) as mapper,
    ):
        found = search(
            site, objective, plans=arguments.plans, seed=arguments.seed, mapper=mapper,
            progress=progress,
        )  # fmt: skip
    if arguments.output is not None:
        write_design(arguments.output, title, site, found, objective)
    usual = thesis_plan(site)
    if arguments.json:
        print_json(_design_values(title, site, found, usual))
        return
    print(f"{title}: smallest {CRITERION_TEXTS[objective.criterion]}")
    for name, plan in (("best plan", found.plan), ("Shahraji", usual)):
        prediction = predict(plan)
        text = "not determined"
        if prediction.determined:
            sigma = np.degrees(prediction.sigma)
            text = ", ".join(f"{a} {v:.4f}" for a, v in zip(ANGLES, sigma, strict=True)) + " deg"
        print(f"{name:12s}{text}")
    plans = f"{found.evaluated:,} survey plans evaluated"
    print(f"{plans}, all that are possible" if found.exact else f"{plans}, out of many more")
    for message in observability_messages(found.plan):
        print(message_text(message))
    print(f"{'target':12s}{'along m':>9s}{'off m':>9s}{'up m':>9s}{'inclination deg':>16s}")
    for target in found.plan.targets:
        along, off, up = site.wall.wall_coordinates(target.centre)
        lean = (
            f"{site.wall.board_orientation(target)[0]:16.0f}" if isinstance(target, Board) else ""
        )
        print(f"{target.name:12s}{along:9.2f}{off:9.2f}{up:9.2f}{lean}")
    for k, line in enumerate(found.plan.lines, start=1):
        print(f"line {k}      {line.name}, {line.speed:g} m/s")
    print(f"{'without':12s}{'deg':>16s}")
    for each in found.gains:
        print(f"{each.name:12s}{sigma_text(each.without):>16s}")
    print(f"{'minutes':12s}{'deg':>10s}  targets x lines")
    for step in found.front:
        size = f"{len(step.plan.targets)} x {len(step.plan.lines)}"
        print(f"{step.minutes:<12.0f}{np.degrees(step.value):10.4f}  {size}")
    if arguments.output is not None:
        print(arguments.output)


def _design_values(title: str, site: Site, result: DesignResult, usual: Plan) -> dict[str, object]:
    import numpy as np

    from lispac.design.prediction import predict

    thesis = predict(usual)
    return {
        "title": title,
        "sigma_deg": np.degrees(result.prediction.sigma).tolist(),
        "value_deg": float(np.degrees(result.value)),
        "thesis_sigma_deg": np.degrees(thesis.sigma).tolist() if thesis.determined else None,
        "exact": result.exact,
        "plans_evaluated": result.evaluated,
        "targets": [
            {"name": t.name, "along_off_up_m": list(site.wall.wall_coordinates(t.centre))}
            for t in result.plan.targets
        ],
        "lines": [vars(line) for line in result.plan.lines],
        "without_deg": {each.name: sigma_degrees(each.without) for each in result.gains},
        "pareto_front": [
            {
                "minutes": step.minutes,
                "value_deg": float(np.degrees(step.value)),
                "targets": [t.name for t in step.plan.targets],
                "lines": len(step.plan.lines),
            }
            for step in result.front
        ],
    }
