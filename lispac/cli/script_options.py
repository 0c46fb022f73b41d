"""Options of the command that writes a project's script."""

import argparse
from pathlib import Path

from lispac.cli.values import Commands, command, json_option


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Describe it."""
    script = command(
        commands, "script", "write the Python script that makes a project again from its raw files"
    )
    script.add_argument("project", type=Path, metavar="PROJECT")
    script.add_argument("--output", type=Path, metavar="FILE", help="default: print it")
    json_option(script)
