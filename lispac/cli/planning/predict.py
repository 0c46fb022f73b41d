"""``lispac predict``: predicted standard deviations of a survey plan."""

import math
from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import print_json
from lispac.message_texts import message_text


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "plan", type=Path, metavar="PLAN", help="survey plan: TOML file with targets and lines"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print sigmas, correlations, weaknesses, and the information gain of targets and lines."""
    import numpy as np

    from lispac.adjustment.result import ANGLES
    from lispac.design.objective import PlanObjective
    from lispac.design.plan_search import information_gains
    from lispac.design.prediction import predict as predicted
    from lispac.io.config.plan_file import read_plan
    from lispac.workflow.planning.plan_checks import observability_messages, plan_warnings

    titled = read_plan(arguments.plan)
    plan = titled.plan
    found, valued = predicted(plan), information_gains(plan, PlanObjective())
    messages = (*plan_warnings(titled), *observability_messages(plan))
    if arguments.json:
        determined = found.determined
        print_json(
            {
                "title": titled.title,
                "determined": determined,
                "sigma_deg": np.degrees(found.sigma).tolist() if determined else None,
                "correlation": found.correlation.tolist() if determined else None,
                "points": [
                    {"target": target, "line": line, "points": round(count)}
                    for (target, line), count in found.points.items()
                ],
                "largest_sigma_without_deg": {v.name: sigma_degrees(v.without) for v in valued},
                "messages": list(map(message_text, messages)),
            }
        )
        return
    print(titled.title)
    if found.determined:
        sigma = np.degrees(found.sigma)
        texts = (f"{angle} {value:.4f}" for angle, value in zip(ANGLES, sigma, strict=True))
        print(f"sigma      {', '.join(texts)} deg (1 sigma)")
        rows = found.correlation
        print(
            f"correlation roll-pitch {rows[0, 1]:+.2f}, roll-yaw {rows[0, 2]:+.2f}, "
            f"pitch-yaw {rows[1, 2]:+.2f}"
        )
    for message in messages:
        print(message_text(message))
    print(f"{'points':12s}" + "".join(f"{course.name:>8s}" for course in plan.courses))
    for target in plan.targets:
        counts = (found.points.get((target.name, c.name)) for c in plan.courses)
        cells = "".join(f"{'-' if n is None else f'{n:,.0f}':>8s}" for n in counts)
        print(f"{target.name:12s}{cells}")
    print(f"{'without':12s}{'largest sigma, deg':>20s}")
    for each in valued:
        print(f"{each.name:12s}{sigma_text(each.without):>20s}")


def sigma_text(radians: float) -> str:
    """Text of a sigma, given in radians: degrees, or "not determined"."""
    return f"{math.degrees(radians):.4f}" if math.isfinite(radians) else "not determined"


def sigma_degrees(radians: float) -> float | None:
    """Convert a sigma from radians to degrees; None if the angle is not determined."""
    return math.degrees(radians) if math.isfinite(radians) else None
