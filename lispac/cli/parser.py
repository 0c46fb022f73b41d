"""The commands; the module of each command defines its options and runs it."""

from argparse import ArgumentParser
from collections.abc import Sequence
from importlib import import_module
from typing import NamedTuple

from lispac.version import __version__


class Command(NamedTuple):
    """A command of ``lispac``.

    Attributes
    ----------
    package : str
        Package of `lispac.cli` that contains the module of the command. The module has
        ``add_arguments(parser)`` and ``run(arguments)``. It imports NumPy, and modules that need
        NumPy, inside its functions only, so that ``--help`` is fast.
    help : str
        What the command does, in one line.
    """

    name: str
    package: str
    help: str

    @property
    def module(self) -> str:
        """Full name of the module."""
        name = "import_lines" if self.name == "import" else self.name.replace("-", "_")
        return f"lispac.cli.{self.package}.{name}"


COMMANDS = (
    Command("demo", "planning", "simulate the built-in survey and run the complete calibration"),
    Command("simulate", "planning",
            "simulate a survey of a scene and write it as a project with known true values"),
    Command("sensors", "planning",
            "list scanners and INS/GNSS with their sigmas and the source of each value"),
    Command("inspect", "project",
            "show the format of a file, the assumptions made and any warnings"),
    Command("new", "project", "create a project from raw lines and a trajectory"),
    Command("locate", "project", "locate the files of a project that were moved"),
    Command("import", "project", "store the lines of a project in its folder, sorted in space"),
    Command("pick", "calibration", "find the plane or sphere at a seed point in every line"),
    Command("propose", "calibration",
            "detect targets and validation planes automatically and give the reasons for each"),
    Command("control", "calibration",
            "import surveyed points or a static scan as observations of the adjustment, or list "
            "them"),
    Command("estimate", "calibration",
            "estimate the boresight of a project or of plane files; the options are saved in the "
            "project"),
    Command("subsample", "checking", "repeat the adjustment with different point spacings"),
    Command("validate", "checking", "compare the lines on the validation planes"),
    Command("check", "checking",
            "compare the lines with a static scan or surveyed points and planes"),
    Command("compare", "calibration",
            "compare calibrations of one mounting, or methods on one survey"),
    Command("targetless", "calibration",
            "estimate the boresight from surfaces of the scene, without targets"),
    Command("history", "checking",
            "list the calibrations of each system and test whether the mounting has moved"),
    Command("budget", "checking",
            "list the contribution of each error source to the error of a point"),
    Command("patchtest", "calibration",
            "estimate the boresight by aligning lines on common objects (patch test)"),
    Command("correspondences", "calibration",
            "estimate the boresight from a file of pairs of points of the same place"),
    Command("quality", "checking",
            "compare the lines of a survey with each other, without a calibration"),
    Command("georeference", "output",
            "write the georeferenced lines as LAZ or LAS files with all attributes"),
    Command("trajectory", "output",
            "write the trajectory corrected by the adjustment, with its accuracies"),
    Command("export", "output", "export targets or the trajectory for other programs"),
    Command("identity", "project",
            "set or show the details of the survey for the report (surveyor, dates, instruments)"),
    Command("acceptance", "project",
            "set or show the acceptance criteria and judge the calibration by them"),
    Command("report", "output", "write the calibration report"),
    Command("script", "output",
            "write a Python script that recreates a project from its raw files"),
    Command("batch", "checking",
            "calibrate all projects in folders with their picked targets and list the results"),
    Command("warnings", "checking", "list all warnings about a project"),
    Command("angles", "output", "convert a boresight to the convention of another program"),
    Command("visibility", "planning",
            "show the effect of systematic errors on a board for each line"),
    Command("predict", "planning", "predict the sigmas of a survey plan"),
    Command("scenarios", "planning",
            "predict the sigmas while one factor changes: lines, boards, distance, height, "
            "repeats, speed, POS"),
    Command("design", "planning", "find the best boards and lines within the limits of a site"),
    Command("campaign", "planning",
            "simulate a survey plan many times and compare the scatter with the predicted sigmas"),
    Command("compare-plan", "planning", "compare a survey with its survey plan"),
)  # fmt: skip
"""All commands, in the order of ``lispac --help``."""


def build_parser(words: Sequence[str] | None = None) -> ArgumentParser:
    """Build the parser of all commands without importing NumPy.

    Parameters
    ----------
    words : sequence of str, optional
        Words of the command line. Only the options of the command that they contain are added; by
        default those of all commands.
    """
    names = {each.name for each in COMMANDS}
    if words is not None:
        names = {next((word for word in words if word in names), "")}
    parser = ArgumentParser(
        prog="lispac",
        usage="%(prog)s [-h] [--version] COMMAND ...\n       lispac-gui (starts the window)",
        description="Boresight calibration of mobile LiDAR systems.",
        epilog="Angles: roll positive port side up, pitch positive bow down, yaw positive "
        "clockwise; rotation from LiDAR to body frame (forward, left, up). Lengths in "
        "metres, angles in degrees.",
    )
    parser.add_argument("--version", action="version", version=f"lispac {__version__}")
    commands = parser.add_subparsers(
        prog="lispac", dest="command", required=True, metavar="COMMAND"
    )
    for each in COMMANDS:
        description = each.help[0].upper() + each.help[1:] + "."
        added = commands.add_parser(each.name, help=each.help, description=description)
        if each.name in names:
            module = import_module(each.module)
            module.add_arguments(added)
            added.set_defaults(run=module.run)
    return parser
