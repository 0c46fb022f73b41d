"""``lispac design``: the best boards and lines that a site allows."""

from argparse import Namespace

import numpy as np

from lispac.adjustment.result import ANGLES
from lispac.cli.cluster_access import cluster_access
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.sigma_format import sigma_degrees, sigma_text
from lispac.design.objective import CRITERIA, PlanObjective
from lispac.design.plan import Plan
from lispac.design.plan_choices import thesis_plan
from lispac.design.plan_search import DesignResult, search
from lispac.design.prediction import predict
from lispac.design.site import Site
from lispac.io.config.plan_file import read_site
from lispac.message_texts import message_text
from lispac.simulation.closed_form_survey import Board
from lispac.workflow.planning.parallel_map import choose_mapper
from lispac.workflow.planning.plan_checks import observability_messages, write_design
from lispac.workflow.planning.simulated_setup import setup_file


def design(arguments: Namespace) -> None:
    """Print the best plan, the contribution of each part and the effect of less time."""
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
    print(f"{title}: smallest {CRITERIA[objective.criterion]}")
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
