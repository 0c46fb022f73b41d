"""The commands and their options."""

import argparse
from pathlib import Path

from lispac import __version__
from lispac.cli import (
    design_options,
    estimate_options,
    opinion_options,
    patch_test_options,
    pick_options,
    quality_options,
    report_options,
    script_options,
    sensor_options,
    simulate_options,
)
from lispac.cli.values import (
    Commands,
    command,
    finite,
    json_option,
    named_value,
    not_negative,
    picture_file,
    positive,
    system_options,
    triple,
)


def build_parser() -> argparse.ArgumentParser:
    """Describe every command; imports nothing heavy."""
    parser = argparse.ArgumentParser(
        prog="lispac",
        description="Boresight calibration of mobile LiDAR systems.",
        epilog="Angles: roll positive left side up, pitch positive bow down, yaw clockwise; "
        "LiDAR to body frame (forward, left, up). Lengths in metres, angles in degrees.",
    )
    parser.add_argument("--version", action="version", version=f"lispac {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    _demo(commands)
    simulate_options.add(commands)
    sensor_options.add(commands)
    _look(commands)
    _new(commands)
    _locate(commands)
    _import(commands)
    pick_options.add(commands)
    _propose(commands)
    estimate_options.add(commands)
    _subsample(commands)
    _validate(commands)
    _check(commands)
    opinion_options.add(commands)
    _history(commands)
    _budget(commands)
    patch_test_options.add(commands)
    quality_options.add(commands)
    _georeference(commands)
    _export(commands)
    report_options.add(commands)
    script_options.add(commands)
    _warnings(commands)
    _angles(commands)
    _visibility(commands)
    design_options.add(commands)
    return parser


def _demo(commands: "Commands[argparse.ArgumentParser]") -> None:
    demo = command(commands, "demo", "simulate the built-in survey and calibrate it, all the way")
    demo.add_argument("--output", type=Path, required=True, metavar="DIR", help="project folder")
    demo.add_argument("--no-window", action="store_true", help="do not open the window at the end")
    json_option(demo)


def _warnings(commands: "Commands[argparse.ArgumentParser]") -> None:
    warnings = command(commands, "warnings", "list all there is to be warned of in a project")
    warnings.add_argument("project", type=Path, metavar="PROJECT")
    json_option(warnings)


def _locate(commands: "Commands[argparse.ArgumentParser]") -> None:
    locate = command(commands, "locate", "say where the files of a project that was moved are now")
    locate.add_argument("project", type=Path, metavar="PROJECT")
    locate.add_argument(
        "folder", type=Path, metavar="FOLDER", help="they are in it, or in folders below it"
    )


def _look(commands: "Commands[argparse.ArgumentParser]") -> None:
    look = command(commands, "look", "say what a file is, what is assumed, and any warnings")
    look.add_argument("file", type=Path, metavar="FILE", help="trajectory, accuracies or points")
    look.add_argument(
        "--quick", action="store_true", help="look at the first points only, not at all of them"
    )
    json_option(look)


def _new(commands: "Commands[argparse.ArgumentParser]") -> None:
    new = command(commands, "new", "make a project from raw lines and a trajectory")
    new.add_argument("project", type=Path, metavar="PROJECT", help="folder to make")
    new.add_argument(
        "lines",
        type=Path,
        nargs="+",
        metavar="LINE",
        help="scan file (LAS, LAZ, E57, PLY, PCD, text)",
    )
    new.add_argument(
        "--trajectory", type=Path, required=True, metavar="FILE",
        help="SBET, Exail or POSPac text, or text with named columns",
    )  # fmt: skip
    new.add_argument(
        "--trajectory-accuracy", type=Path, metavar="FILE", help="smrmsg, or a text that holds it"
    )
    for file, what in (
        ("trajectory", "the trajectory"), ("accuracy", "its accuracies"), ("line", "the lines"),
    ):  # fmt: skip
        new.add_argument(
            f"--{file}-format", metavar="KEY", help=f"format of {what} (default: as found in it)"
        )
        new.add_argument(
            f"--{file}-option", type=named_value, action="append", default=[], metavar="NAME=VALUE",
            help=f"what the files do not say of {what}; `lispac look FILE` lists the options",
        )  # fmt: skip
    new.add_argument(
        "--time-shift", type=finite, default=0.0, metavar="SECONDS",
        help="added to the times of the lines to bring them into the trajectory's",
    )  # fmt: skip
    new.add_argument(
        "--split-by", default="", metavar="ATTRIBUTE",
        help="make a line of each value of an attribute (point_source_id, scanner_channel, "
        "user_data, ...) of a file, or with gap of each part between pauses",
    )  # fmt: skip
    triple(
        new, "--lever-arm", ("X", "Y", "Z"), "LiDAR from POS: forward, left, up (m)", required=True
    )
    triple(new, "--boresight", ("ROLL", "PITCH", "YAW"), "prior boresight (deg), default 0 0 0")
    triple(new, "--origin", ("LAT", "LON", "HEIGHT"), "origin of the local frame (deg, m)")
    triple(new, "--position-sigma", ("N", "E", "D"), "position sigmas without accuracy file (m)")
    triple(
        new, "--attitude-sigma", ("ROLL", "PITCH", "HEADING"),
        "attitude sigmas without accuracy file (deg)",
    )  # fmt: skip
    sensor_options.pos_option(new)
    estimate_options.lidar_noise(new)
    estimate_options.offsets(new)
    new.add_argument(
        "--longest-gap", type=positive, metavar="SECONDS",
        help="longest gap between two states of the trajectory that is bridged",
    )  # fmt: skip
    new.add_argument(
        "--columns",
        metavar="NAMES",
        help="columns of text lines from the left, e.g. time,x,y,z,intensity",
    )
    json_option(new)


def _import(commands: "Commands[argparse.ArgumentParser]") -> None:
    imported = command(
        commands, "import", "keep the lines of a project in its folder, ordered in space"
    )
    imported.set_defaults(command="import_lines")  # import is a word of the language
    imported.add_argument("project", type=Path, metavar="PROJECT")
    imported.add_argument(
        "--lines", nargs="+", default=[], metavar="NAME", help="these lines only (default all)"
    )
    imported.add_argument(
        "--again", action="store_true", help="import lines that are imported already, too"
    )
    imported.add_argument(
        "--check", action="store_true", help="read all of what is imported and compare checksums"
    )
    json_option(imported)


def _propose(commands: "Commands[argparse.ArgumentParser]") -> None:
    propose = command(commands, "propose", "propose targets and validation planes, with reasons")
    propose.add_argument("project", type=Path, metavar="PROJECT")
    propose.add_argument("--accept", action="store_true", help="add them to the project")
    json_option(propose)


def _subsample(commands: "Commands[argparse.ArgumentParser]") -> None:
    subsample = command(
        commands, "subsample", "adjust with points nearer together and farther apart"
    )
    subsample.add_argument("project", type=Path, metavar="PROJECT")
    subsample.add_argument(
        "--distances", type=finite, nargs="+", metavar="M",
        help="between points that take part, 0 for all of them (default 0 0.05 0.1 0.15 0.2)",
    )  # fmt: skip
    json_option(subsample)


def _validate(commands: "Commands[argparse.ArgumentParser]") -> None:
    validate = command(commands, "validate", "compare the lines on the validation planes")
    validate.add_argument("project", type=Path, metavar="PROJECT")
    validate.add_argument(
        "--distance-to", choices=("point", "plane", "quadric"), default="plane",
        help="measure to the nearest point of the other line, or to a plane (default) or quadric "
        "through it and its neighbours",
    )  # fmt: skip
    validate.add_argument(
        "--neighbours", type=int, default=None, metavar="N",
        help="points of the plane or quadric (default 6, 12 for a quadric)",
    )  # fmt: skip
    validate.add_argument(
        "--radius", type=finite, metavar="M", help="all points within this radius instead"
    )
    json_option(validate)


def _check(commands: "Commands[argparse.ArgumentParser]") -> None:
    check = command(
        commands, "check", "compare the lines with a static scan or surveyed points and planes"
    )
    check.add_argument("project", type=Path, metavar="PROJECT")
    check.add_argument(
        "--reference", type=Path, required=True, metavar="FILE",
        help="static scan (LAS, LAZ, E57, PTS, text), or a list of check points: name, x, y, z, "
        "and perhaps sigma and the name of the plane they lie on",
    )  # fmt: skip
    check.add_argument(
        "--reference-sigma", type=not_negative, default=0.005, metavar="M",
        help="1 sigma of the reference: what all points of a scan share, or that of each check "
        "point whose own is not listed (default 0.005)",
    )  # fmt: skip
    check.add_argument(
        "--reach", type=positive, default=1.0, metavar="M",
        help="how far from the reference lines are looked for (default 1)",
    )  # fmt: skip
    system_options(check, "as the reference states it, else local")
    json_option(check)


def _history(commands: "Commands[argparse.ArgumentParser]") -> None:
    history = command(
        commands, "history", "list the calibrations of each system, and whether its mounting moved"
    )
    history.add_argument(
        "folders", type=Path, nargs="+", metavar="FOLDER", help="searched for projects at any depth"
    )
    history.add_argument("--vessel", metavar="NAME", help="of this vessel only")
    history.add_argument(
        "--picture", type=picture_file, metavar="FILE",
        help="control chart of the system with most calibrations, .png, .svg or .pdf",
    )  # fmt: skip
    json_option(history)


def _budget(commands: "Commands[argparse.ArgumentParser]") -> None:
    budget = command(
        commands, "budget", "say what every source of error does to a point at a distance"
    )
    budget.add_argument("project", type=Path, metavar="PROJECT")
    budget.add_argument(
        "--distance", type=positive, nargs="+", metavar="M",
        help="from the scanner (default 10 50 100)",
    )  # fmt: skip
    triple(budget, "--lever-sigma", ("X", "Y", "Z"), "how well the lever arm is known, 1 sigma (m)")
    json_option(budget)


def _georeference(commands: "Commands[argparse.ArgumentParser]") -> None:
    georeference = command(
        commands, "georeference", "write the lines on the map as LAZ with all their attributes"
    )
    georeference.add_argument("project", type=Path, metavar="PROJECT")
    georeference.add_argument("--output", type=Path, required=True, metavar="DIR")
    georeference.add_argument("--boresight", choices=("prior", "estimated"), default="estimated")
    system_options(georeference, "that of the lines where they are georeferenced")
    georeference.add_argument(
        "--lines", nargs="+", metavar="NAME", help="these lines only (default all)"
    )
    georeference.add_argument("--format", choices=("laz", "las"), default="laz")
    json_option(georeference)


def _export(commands: "Commands[argparse.ArgumentParser]") -> None:
    export = command(commands, "export", "write targets or the trajectory for other programs")
    export.add_argument("project", type=Path, metavar="PROJECT")
    export.add_argument("--what", choices=("targets", "planes", "trajectory"), required=True)
    export.add_argument(
        "--output", type=Path, required=True, metavar="PATH", help="folder; file for the trajectory"
    )
    export.add_argument(
        "--format", choices=("laz", "las", "csv", "sbet", "text"),
        help="of targets laz (default), las or csv; of the trajectory sbet (default) or text; "
        "planes are text of 25 columns",
    )  # fmt: skip
    export.add_argument("--boresight", choices=("prior", "estimated"), default="estimated")
    export.add_argument("--targets", nargs="+", metavar="NAME", help="these only (default all)")
    system_options(export, "local")
    json_option(export)


def _angles(commands: "Commands[argparse.ArgumentParser]") -> None:
    angles = command(commands, "angles", "give a boresight in another program's convention")
    angles.description = (
        "Give a boresight and a lever arm in another program's convention, with the assumptions "
        "made. Without arguments: list the systems and the order in which each types its angles."
    )
    angles.add_argument(
        "values",
        nargs="*",
        metavar="A B C | PROJECT",
        help="three angles (deg) in the order of --from, or a project with an estimated boresight",
    )
    angles.add_argument(
        "--from", dest="from_system", default="lispac", metavar="SYSTEM", help="default lispac"
    )
    angles.add_argument("--to", default="lispac", metavar="SYSTEM", help="default lispac")
    triple(angles, "--lever", ("X", "Y", "Z"), "lever arm along the body axes of --from (m)")
    triple(
        angles, "--current", ("A", "B", "C"),
        "present settings in the --to system (deg): also print the correction to them",
    )  # fmt: skip
    angles.add_argument(
        "--current-matrix",
        nargs="+", metavar="FILE | NUMBER",
        help="instead: the present 3x3 or 4x4 matrix from scanner to body of --to, its numbers or "
        "a file; of a 4x4 the lever arm is replaced too, or taken over where none is given",
    )  # fmt: skip
    angles.add_argument(
        "--current-applied",
        action="store_true",
        help="the lines were already turned by the present settings, so what was found comes on "
        "top of them",
    )
    angles.add_argument("--matrix", action="store_true", help="print the matrices too")
    angles.add_argument(
        "--from-matrix",
        type=Path,
        metavar="FILE",
        help="text file with the 3x3 or 4x4 matrix from scanner to body of --from",
    )
    angles.add_argument(
        "--scanner",
        choices=("turned", "kept", "mounted"),
        help="scanner axes of the other system: turned as its body axes, kept as in the raw "
        "points, or laid on the body axes by a mounting (default: as that system usually does)",
    )
    for name, text in (
        ("--body-axes", "where the other system's body axes point, e.g. forward starboard down"),
        ("--mounting", "where the raw scanner axes nominally point, e.g. forward port up"),
    ):
        angles.add_argument(name, nargs=3, metavar=("X", "Y", "Z"), help=text)
    json_option(angles)


def _visibility(commands: "Commands[argparse.ArgumentParser]") -> None:
    visibility = command(
        commands, "visibility", "say what systematic errors do to a board, line by line"
    )
    visibility.add_argument(
        "site", choices=("terrestrial", "marine"),
        help="a vehicle 2.5 m above a board on the ground, or a vessel 15 m from a quay 5 m high",
    )  # fmt: skip
    visibility.add_argument("--output", type=Path, required=True, metavar="DIR")
    visibility.add_argument(
        "--error", nargs="+", metavar="NAME",
        choices=(
            "roll", "pitch", "yaw", "lever-x", "lever-y", "lever-z", "range-offset",
            "scan-angle-offset",
        ),
        help="these only (default all of the site): roll, pitch, yaw, lever-x, lever-y, lever-z, "
        "range-offset, scan-angle-offset",
    )  # fmt: skip
    visibility.add_argument(
        "--formats", nargs="+", choices=("png", "svg", "pdf"), default=["png"],
        help="of the figures (default png)",
    )  # fmt: skip
    visibility.add_argument(
        "--struck", action="store_true",
        help="take the beams that meet the board with the error, as a real one would have them, "
        "instead of those aimed at it; the thesis has the latter",
    )  # fmt: skip
    json_option(visibility)
