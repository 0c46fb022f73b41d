"""Options of ``lispac compare`` and ``lispac targetless``."""

import argparse
from pathlib import Path

from lispac.cli.argument_types import Commands, add_command, add_json_option


def add_commands(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Add the commands ``compare`` and ``targetless``."""
    _add_compare(commands)
    _add_targetless(commands)


def _add_compare(commands: "Commands[argparse.ArgumentParser]") -> None:
    compare = add_command(
        commands, "compare", "compare calibrations of one mounting, or methods on one survey"
    )
    compare.add_argument(
        "projects", type=Path, nargs="+", metavar="PROJECT",
        help="projects with the same mounting, the earliest first; with a single project its "
             "methods are compared",
    )  # fmt: skip
    compare.add_argument(
        "--compute",
        action="store_true",
        help="with a single project: run the methods without a result (natural planes, targetless, "
        "patch test) and save their results",
    )
    add_json_option(compare)


def _add_targetless(commands: "Commands[argparse.ArgumentParser]") -> None:
    targetless = add_command(
        commands, "targetless", "estimate the boresight from surfaces of the scene, without targets"
    )
    targetless.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    targetless.add_argument(
        "--save",
        action="store_true",
        help="save the result in the project: as its boresight if it has no targets, otherwise "
        "beside that of the targets",
    )
    targetless.add_argument(
        "--with-targets",
        action="store_true",
        help="also use the targets of the project in the adjustment",
    )
    add_json_option(targetless)
