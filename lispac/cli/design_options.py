"""Options of the commands for survey design."""

import argparse
from pathlib import Path

from lispac.cli.argument_types import (
    Commands,
    add_command,
    add_json_option,
    positive_number,
    whole_number_from,
)

CRITERIA = ("largest", "roll", "pitch", "yaw", "A", "D")
SCENARIOS = (
    "lines", "inclination", "size", "targets", "distance", "height", "repeats", "speed", "POS",
)  # fmt: skip


def add_commands(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Add the commands for survey design."""
    predict = add_command(commands, "predict", "predict the sigmas of a survey plan")
    predict.add_argument(
        "plan", type=Path, metavar="PLAN", help="survey plan: TOML file with targets and lines"
    )
    add_json_option(predict)
    _add_scenarios(commands)
    _add_design(commands)
    _add_campaign(commands)
    compared = add_command(commands, "compare-plan", "compare a survey with its survey plan")
    compared.set_defaults(command="compare_plan")
    compared.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    compared.add_argument(
        "--plan", type=Path, required=True, metavar="FILE", help="survey plan (TOML file)"
    )
    add_json_option(compared)


def _add_scenarios(commands: "Commands[argparse.ArgumentParser]") -> None:
    scenarios = add_command(
        commands, "scenarios",
        "predict the sigmas while one factor changes: lines, boards, distance, height, repeats, "
        "speed, POS",
    )  # fmt: skip
    scenarios.add_argument(
        "plan", type=Path, nargs="?", metavar="PLAN",
        help="survey plan to vary (default: one vertical board and six lines, as in Shahraji's "
             "thesis)",
    )  # fmt: skip
    scenarios.add_argument(
        "--only", nargs="+", choices=SCENARIOS, metavar="SCENARIO",
        help=f"factors to change (default: all): {', '.join(SCENARIOS)}",
    )  # fmt: skip
    scenarios.add_argument(
        "--output", type=Path, metavar="DIR", help="output folder for tables (CSV) and plots (SVG)"
    )
    add_json_option(scenarios)


def _add_design(commands: "Commands[argparse.ArgumentParser]") -> None:
    design = add_command(
        commands, "design", "find the best boards and lines within the limits of a site"
    )
    design.add_argument(
        "site", metavar="SITE",
        help="TOML file with the limits of the site, or the name of a built-in site: quay, "
             "quay-and-tower",
    )  # fmt: skip
    design.add_argument(
        "--for", dest="criterion", choices=CRITERIA, default="largest",
        help="criterion to minimise: the largest sigma (default), the sigma of one angle, or the "
             "root mean square of the sigmas (A) or the mean radius of their confidence ellipsoid "
             "(D)",
    )  # fmt: skip
    design.add_argument(
        "--plans", type=whole_number_from(1), default=10_000, metavar="N",
        help="approximate number of survey plans to evaluate (default 10000)",
    )  # fmt: skip
    design.add_argument(
        "--pos-factors", type=positive_number, nargs="+", default=[1.0], metavar="F",
        help="factors on the POS sigmas; the criterion is averaged over them (default 1)",
    )  # fmt: skip
    design.add_argument(
        "--seed", type=int, default=2019, help="seed of the random search (default 2019)"
    )
    _add_worker_options(design)
    design.add_argument(
        "--output", type=Path, metavar="DIR",
        help="output folder for plan.toml, the field plan (PDF) and the sigmas of shorter surveys",
    )  # fmt: skip
    add_json_option(design)


def _add_campaign(commands: "Commands[argparse.ArgumentParser]") -> None:
    campaign = add_command(
        commands,
        "campaign",
        "simulate a survey plan many times and compare the scatter with the predicted sigmas",
    )
    campaign.add_argument(
        "plan", type=Path, metavar="PLAN", help="survey plan: TOML file with targets and lines"
    )
    campaign.add_argument(
        "--surveys", type=whole_number_from(2), default=200, metavar="N",
        help="number of surveys to simulate and adjust (default 200)",
    )  # fmt: skip
    campaign.add_argument(
        "--seed",
        type=whole_number_from(0),
        default=2027,
        help="seed of the random numbers (default 2027)",
    )
    campaign.add_argument(
        "--flatness-known", action="store_true",
        help="give the form error of the targets to the adjustment (default: estimated from the "
             "data, as lispac estimate does)",
    )  # fmt: skip
    _add_worker_options(campaign)
    add_json_option(campaign)


def _add_worker_options(parser: argparse.ArgumentParser) -> None:
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--workers",
        type=whole_number_from(1),
        metavar="N",
        help="number of parallel processes (default: all cores)",
    )
    where.add_argument(
        "--cluster", metavar="ADDRESS",
        help="run on the workers of this Dask scheduler instead of this computer: tls://HOST:PORT",
    )  # fmt: skip
    parser.add_argument(
        "--cluster-tls", nargs=3, type=Path, metavar=("CA", "CERTIFICATE", "KEY"),
        help="PEM files: certificate of the authority, certificate of this computer and its key "
             "(default: from the dask configuration)",
    )  # fmt: skip
    parser.add_argument(
        "--plain-tcp", action="store_true",
        help="allow unencrypted tcp:// connections to another computer; others in the network can "
             "then run programs on this computer and on the workers",
    )  # fmt: skip
