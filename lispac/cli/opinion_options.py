"""Options of ``lispac compare`` and ``lispac targetless``."""

import argparse
from pathlib import Path

from lispac.cli.values import Commands, command, json_option


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """The commands."""
    _compare(commands)
    _targetless(commands)


def _compare(commands: "Commands[argparse.ArgumentParser]") -> None:
    compare = command(commands, "compare", "say whether calibrations, or methods, agree")
    compare.add_argument(
        "projects", type=Path, nargs="+", metavar="PROJECT",
        help="calibrations of one mounting, the earliest first; of a single one its methods",
    )  # fmt: skip
    compare.add_argument(
        "--compute", action="store_true", help="of a single one: ask other methods, and keep it"
    )
    json_option(compare)


def _targetless(commands: "Commands[argparse.ArgumentParser]") -> None:
    targetless = command(
        commands, "targetless", "find the boresight from the scene itself, without a target"
    )
    targetless.add_argument("project", type=Path, metavar="PROJECT")
    targetless.add_argument(
        "--keep", action="store_true", help="keep the answer beside that of the targets"
    )
    targetless.add_argument(
        "--with-targets", action="store_true", help="adjust the project's targets with the scene"
    )
    json_option(targetless)
