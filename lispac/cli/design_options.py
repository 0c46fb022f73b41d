"""The commands that design a site before anybody sails."""

import argparse
from pathlib import Path

from lispac.cli.values import Commands, command, json_option, positive, whole

CRITERIA = ("largest", "roll", "pitch", "yaw", "A", "D")
SCENARIOS = (
    "lines", "inclination", "size", "targets", "distance", "height", "repeats", "speed", "POS",
)  # fmt: skip


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Describe them."""
    predict = command(commands, "predict", "foretell the sigmas of a plan, before anybody sails it")
    predict.add_argument("plan", type=Path, metavar="PLAN", help="TOML file of targets and lines")
    json_option(predict)
    _scenarios(commands)
    _design(commands)
    _campaign(commands)
    replay = command(commands, "replay", "compare a survey with the plan it was sailed by")
    replay.add_argument("project", type=Path, metavar="PROJECT")
    replay.add_argument("--plan", type=Path, required=True, metavar="FILE")
    json_option(replay)


def _scenarios(commands: "Commands[argparse.ArgumentParser]") -> None:
    scenarios = command(
        commands, "scenarios",
        "change one thing at a time: lines, boards, distance, height, repeats, speed, POS",
    )  # fmt: skip
    scenarios.add_argument(
        "plan", type=Path, nargs="?", metavar="PLAN",
        help="plan to change (default: one upright board and six lines, as in the thesis)",
    )  # fmt: skip
    scenarios.add_argument("--only", nargs="+", choices=SCENARIOS, metavar="SCENARIO",
                           help=f"among {', '.join(SCENARIOS)}")  # fmt: skip
    scenarios.add_argument(
        "--output", type=Path, metavar="DIR", help="folder for tables (CSV) and plots (SVG)"
    )
    json_option(scenarios)


def _design(commands: "Commands[argparse.ArgumentParser]") -> None:
    design = command(commands, "design", "find the best boards and lines that a site allows")
    design.add_argument(
        "site", metavar="SITE",
        help="TOML file of what is allowed, or the name of one that comes with the program: quay, "
        "quay-and-tower",
    )  # fmt: skip
    design.add_argument(
        "--for", dest="criterion", choices=CRITERIA, default="largest",
        help="what is to be small: the largest sigma (default), one angle's, or all (A, D)",
    )  # fmt: skip
    design.add_argument("--plans", type=whole(1), default=10_000, metavar="N",
                        help="about how many to look at (default 10000)")  # fmt: skip
    design.add_argument(
        "--pos-factors", type=positive, nargs="+", default=[1.0], metavar="F",
        help="the POS may be so many times as good or poor as stated: the mean over them counts",
    )  # fmt: skip
    design.add_argument("--seed", type=int, default=2019, help="of the search (default 2019)")
    _where(design)
    design.add_argument(
        "--output", type=Path, metavar="DIR",
        help="folder for plan.toml, the field plan (PDF), and what less time costs",
    )  # fmt: skip
    json_option(design)


def _campaign(commands: "Commands[argparse.ArgumentParser]") -> None:
    campaign = command(
        commands, "campaign", "simulate a plan many times over and say whether its sigmas hold"
    )
    campaign.add_argument("plan", type=Path, metavar="PLAN", help="TOML file of targets and lines")
    campaign.add_argument("--surveys", type=whole(2), default=200, metavar="N",
                          help="how many to simulate and adjust (default 200)")  # fmt: skip
    campaign.add_argument("--seed", type=whole(0), default=2027, help="of chance (default 2027)")
    campaign.add_argument(
        "--flatness-known", action="store_true",
        help="tell the adjustment how flat the targets are (default: it takes it from the data, "
        "as estimate does)",
    )  # fmt: skip
    _where(campaign)
    json_option(campaign)


def _where(parser: argparse.ArgumentParser) -> None:
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--workers", type=whole(1), metavar="N", help="processes (default: all cores)"
    )
    where.add_argument(
        "--cluster", metavar="ADDRESS",
        help="run on the workers of this dask scheduler instead, tls://HOST:PORT",
    )  # fmt: skip
    parser.add_argument(
        "--cluster-tls", nargs=3, type=Path, metavar=("CA", "CERTIFICATE", "KEY"),
        help="PEM files of the authority, of this computer and its key (default: those of dask's "
        "configuration)",
    )  # fmt: skip
    parser.add_argument(
        "--plain-tcp", action="store_true",
        help="accept tcp:// to another computer: others in the network can then run programs on "
        "this computer and on the workers",
    )  # fmt: skip
