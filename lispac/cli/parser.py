"""The commands and their options."""

import argparse
from pathlib import Path

from lispac import __version__
from lispac.cli import (
    design_options,
    estimate_options,
    method_options,
    patch_test_options,
    pick_options,
    quality_options,
    report_options,
    script_options,
    sensor_options,
    simulate_options,
)
from lispac.cli.argument_types import (
    Commands,
    add_command,
    add_crs_options,
    add_json_option,
    add_triple_option,
    finite_number,
    non_negative_number,
    picture_file,
    positive_number,
)
from lispac.cli.former_options import split_reading_option


def build_parser() -> argparse.ArgumentParser:
    """Parser of all commands; imports nothing heavy."""
    parser = argparse.ArgumentParser(
        prog="lispac",
        description="Boresight calibration of mobile LiDAR systems.",
        epilog="Angles: roll positive port side up, pitch positive bow down, yaw positive "
        "clockwise; rotation from LiDAR to body frame (forward, left, up). Lengths in "
        "metres, angles in degrees.",
    )
    parser.add_argument("--version", action="version", version=f"lispac {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    _add_demo(commands)
    simulate_options.add_simulate_command(commands)
    sensor_options.add_sensors_command(commands)
    _add_inspect(commands)
    _add_new(commands)
    _add_locate(commands)
    _add_import(commands)
    pick_options.add_pick_command(commands)
    _add_propose(commands)
    estimate_options.add_estimate_command(commands)
    _add_subsample(commands)
    _add_validate(commands)
    _add_check(commands)
    method_options.add_commands(commands)
    _add_history(commands)
    _add_budget(commands)
    patch_test_options.add_patchtest_command(commands)
    quality_options.add_quality_command(commands)
    _add_georeference(commands)
    _add_export(commands)
    report_options.add_commands(commands)
    script_options.add_commands(commands)
    _add_warnings(commands)
    _add_angles(commands)
    _add_visibility(commands)
    design_options.add_commands(commands)
    return parser


def _add_demo(commands: "Commands[argparse.ArgumentParser]") -> None:
    demo = add_command(
        commands, "demo", "simulate the built-in survey and run the complete calibration"
    )
    demo.add_argument(
        "--output", type=Path, required=True, metavar="DIR", help="project folder to create"
    )
    demo.add_argument(
        "--no-window", action="store_true", help="do not open the main window at the end"
    )
    add_json_option(demo)


def _add_warnings(commands: "Commands[argparse.ArgumentParser]") -> None:
    warnings = add_command(commands, "warnings", "list all warnings about a project")
    warnings.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    add_json_option(warnings)


def _add_locate(commands: "Commands[argparse.ArgumentParser]") -> None:
    locate = add_command(commands, "locate", "locate the files of a project that were moved")
    locate.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    locate.add_argument(
        "folder",
        type=Path,
        metavar="FOLDER",
        help="folder to search for the files, including its subfolders",
    )


def _add_inspect(commands: "Commands[argparse.ArgumentParser]") -> None:
    inspect = add_command(
        commands, "inspect", "show the format of a file, the assumptions made and any warnings"
    )
    inspect.add_argument(
        "file", type=Path, metavar="FILE", help="trajectory, trajectory accuracy or line file"
    )
    inspect.add_argument("--quick", action="store_true", help="read the first points only")
    add_json_option(inspect)


def _add_new(commands: "Commands[argparse.ArgumentParser]") -> None:
    new = add_command(commands, "new", "create a project from raw lines and a trajectory")
    new.add_argument("project", type=Path, metavar="PROJECT", help="project folder to create")
    new.add_argument(
        "lines",
        type=Path,
        nargs="+",
        metavar="LINE",
        help="scan file of one line (LAS, LAZ, E57, PLY, PCD, text)",
    )
    new.add_argument(
        "--trajectory", type=Path, required=True, metavar="FILE",
        help="trajectory: SBET, Exail or POSPac text, or text with named columns",
    )  # fmt: skip
    new.add_argument(
        "--trajectory-accuracy",
        type=Path,
        metavar="FILE",
        help="accuracy of the trajectory: smrmsg file, or a text export of it",
    )
    for file, what in (
        ("trajectory", "the trajectory"),
        ("accuracy", "the trajectory accuracy"),
        ("line", "the lines"),
    ):  # fmt: skip
        new.add_argument(
            f"--{file}-format", metavar="KEY", help=f"format of {what} (default: detected)"
        )
        new.add_argument(
            f"--{file}-option",
            type=split_reading_option,
            action="append",
            default=[],
            metavar="NAME=VALUE",
            help=f"option for reading {what}; `lispac inspect FILE` lists the options",
        )
    new.add_argument(
        "--time-shift", type=finite_number, default=0.0, metavar="SECONDS",
        help="seconds added to the times of the lines to obtain trajectory time (default 0)",
    )  # fmt: skip
    new.add_argument(
        "--split-by", default="", metavar="ATTRIBUTE",
        help="split each file into lines: one line for each value of an attribute "
             "(point_source_id, scanner_channel, user_data, ...), or, with gap, one line for each "
             "part between gaps in the times",
    )  # fmt: skip
    add_triple_option(
        new,
        "--lever-arm",
        ("X", "Y", "Z"),
        "lever arm from the POS to the LiDAR: forward, left, up (m)",
        required=True,
    )
    add_triple_option(
        new, "--boresight", ("ROLL", "PITCH", "YAW"), "prior boresight (deg; default 0 0 0)"
    )
    add_triple_option(
        new,
        "--origin",
        ("LAT", "LON", "HEIGHT"),
        "origin of the local frame (deg, m; default: mean position of the trajectory)",
    )
    add_triple_option(
        new,
        "--position-sigma",
        ("N", "E", "D"),
        "sigmas of the position without accuracy file (m; default 0.02 0.02 0.03)",
    )
    add_triple_option(
        new, "--attitude-sigma", ("ROLL", "PITCH", "HEADING"),
        "sigmas of the attitude without accuracy file (deg; default 0.01 0.01 0.015)",
    )  # fmt: skip
    sensor_options.add_pos_option(new)
    estimate_options.add_noise_options(new)
    estimate_options.add_offset_options(new)
    new.add_argument(
        "--longest-gap", type=positive_number, metavar="SECONDS",
        help="longest gap of the trajectory to interpolate across (s; default 1.5)",
    )  # fmt: skip
    new.add_argument(
        "--columns",
        metavar="NAMES",
        help="columns of text files with points, from the left, e.g. time,x,y,z,intensity",
    )
    add_json_option(new)


def _add_import(commands: "Commands[argparse.ArgumentParser]") -> None:
    imported = add_command(
        commands, "import", "store the lines of a project in its folder, sorted in space"
    )
    imported.set_defaults(command="import_lines")  # import is a word of the language
    imported.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    imported.add_argument(
        "--lines", nargs="+", default=[], metavar="NAME", help="use only these lines (default: all)"
    )
    imported.add_argument(
        "--again", action="store_true", help="import again lines that are already imported"
    )
    imported.add_argument(
        "--check", action="store_true", help="read all imported data and compare checksums"
    )
    add_json_option(imported)


def _add_propose(commands: "Commands[argparse.ArgumentParser]") -> None:
    propose = add_command(
        commands,
        "propose",
        "detect targets and validation planes automatically and give the reasons for each",
    )
    propose.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    propose.add_argument(
        "--accept", action="store_true", help="add the proposed targets to the project"
    )
    add_json_option(propose)


def _add_subsample(commands: "Commands[argparse.ArgumentParser]") -> None:
    subsample = add_command(
        commands, "subsample", "repeat the adjustment with different point spacings"
    )
    subsample.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    subsample.add_argument(
        "--distances", type=finite_number, nargs="+", metavar="M",
        help="point spacings to use (m; 0 uses all points; default 0 0.05 0.1 0.15 0.2)",
    )  # fmt: skip
    add_json_option(subsample)


def _add_validate(commands: "Commands[argparse.ArgumentParser]") -> None:
    validate = add_command(commands, "validate", "compare the lines on the validation planes")
    validate.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    validate.add_argument(
        "--distance-to", choices=("point", "plane", "quadric"), default="plane",
        help="distance to the nearest point of the other line, or to a plane or quadric fitted to "
             "that point and its neighbours (default plane)",
    )  # fmt: skip
    validate.add_argument(
        "--neighbours", type=int, default=None, metavar="N",
        help="number of points to which the plane or quadric is fitted (default 6 for a plane, 12 "
             "for a quadric)",
    )  # fmt: skip
    validate.add_argument(
        "--radius",
        type=finite_number,
        metavar="M",
        help="fit the plane or quadric to all points within this radius (m) instead",
    )
    add_json_option(validate)


def _add_check(commands: "Commands[argparse.ArgumentParser]") -> None:
    check = add_command(
        commands, "check", "compare the lines with a static scan or surveyed points and planes"
    )
    check.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    check.add_argument(
        "--reference", type=Path, required=True, metavar="FILE",
        help="static scan (LAS, LAZ, E57, PTS, text), or a list of check points: name, x, y, z, "
             "and optionally sigma and the name of the plane that contains them",
    )  # fmt: skip
    check.add_argument(
        "--reference-sigma", type=non_negative_number, default=0.005, metavar="M",
        help="1 sigma of the reference (m): error common to all points of a scan, or sigma of "
             "each check point without a sigma of its own (default 0.005)",
    )  # fmt: skip
    check.add_argument(
        "--search-distance", type=positive_number, default=1.0, metavar="M",
        help="largest distance between lines and reference (m; default 1)",
    )  # fmt: skip
    add_crs_options(check, "as given in the reference file, otherwise local")
    add_json_option(check)


def _add_history(commands: "Commands[argparse.ArgumentParser]") -> None:
    history = add_command(
        commands,
        "history",
        "list the calibrations of each system and test whether the mounting has moved",
    )
    history.add_argument(
        "folders",
        type=Path,
        nargs="+",
        metavar="FOLDER",
        help="folder to search for projects, including its subfolders",
    )
    history.add_argument("--vessel", metavar="NAME", help="show only the systems of this vessel")
    history.add_argument(
        "--picture", type=picture_file, metavar="FILE",
        help="file for the control chart of the system with most calibrations: .png, .svg or .pdf",
    )  # fmt: skip
    add_json_option(history)


def _add_budget(commands: "Commands[argparse.ArgumentParser]") -> None:
    budget = add_command(
        commands, "budget", "list the contribution of each error source to the error of a point"
    )
    budget.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    budget.add_argument(
        "--distance", type=positive_number, nargs="+", metavar="M",
        help="distances of the point from the scanner (m; default 10 50 100)",
    )  # fmt: skip
    add_triple_option(
        budget,
        "--lever-arm-sigma",
        ("X", "Y", "Z"),
        "1 sigma of the lever arm (m; default: not included)",
    )
    add_json_option(budget)


def _add_georeference(commands: "Commands[argparse.ArgumentParser]") -> None:
    georeference = add_command(
        commands,
        "georeference",
        "write the georeferenced lines as LAZ or LAS files with all attributes",
    )
    georeference.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    georeference.add_argument(
        "--output", type=Path, required=True, metavar="DIR", help="output folder"
    )
    georeference.add_argument(
        "--boresight",
        choices=("prior", "estimated"),
        default="estimated",
        help="boresight to use (default estimated)",
    )
    add_crs_options(georeference, "that of the lines if they are georeferenced")
    georeference.add_argument(
        "--lines", nargs="+", metavar="NAME", help="use only these lines (default: all)"
    )
    georeference.add_argument(
        "--format", choices=("laz", "las"), default="laz", help="file format (default laz)"
    )
    add_json_option(georeference)


def _add_export(commands: "Commands[argparse.ArgumentParser]") -> None:
    export = add_command(commands, "export", "export targets or the trajectory for other programs")
    export.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    export.add_argument(
        "--what",
        choices=("targets", "planes", "trajectory"),
        required=True,
        help="data to export: points of the targets, plane files, or the trajectory",
    )
    export.add_argument(
        "--output",
        type=Path,
        required=True,
        metavar="PATH",
        help="output folder; for the trajectory the output file",
    )
    export.add_argument(
        "--format", choices=("laz", "las", "csv", "sbet", "text"),
        help="targets: laz (default), las or csv; trajectory: sbet (default) or text; planes are "
             "always text with 25 columns",
    )  # fmt: skip
    export.add_argument(
        "--boresight",
        choices=("prior", "estimated"),
        default="estimated",
        help="boresight to use (default estimated)",
    )
    export.add_argument(
        "--targets", nargs="+", metavar="NAME", help="export only these targets (default: all)"
    )
    add_crs_options(export, "local")
    add_json_option(export)


def _add_angles(commands: "Commands[argparse.ArgumentParser]") -> None:
    angles = add_command(
        commands, "angles", "convert a boresight to the convention of another program"
    )
    angles.description = (
        "Convert a boresight and a lever arm to the convention of another program and list the "
        "assumptions made. Without arguments: list the systems with the order of their angles."
    )
    angles.add_argument(
        "values",
        nargs="*",
        metavar="A B C | PROJECT",
        help="three angles (deg) in the order of --from, or a project with an estimated boresight",
    )
    angles.add_argument(
        "--from",
        dest="from_system",
        default="lispac",
        metavar="SYSTEM",
        help="system of the given angles (default lispac)",
    )
    angles.add_argument(
        "--to", default="lispac", metavar="SYSTEM", help="system to convert to (default lispac)"
    )
    add_triple_option(
        angles,
        "--lever-arm",
        ("X", "Y", "Z"),
        "lever arm along the body axes of the --from system (m)",
    )
    add_triple_option(
        angles, "--current", ("A", "B", "C"),
        "current angles in the --to system (deg): also print the correction to them",
    )  # fmt: skip
    angles.add_argument(
        "--current-matrix",
        nargs="+", metavar="FILE | NUMBER",
        help="instead of --current: current 3x3 or 4x4 matrix from scanner to body of the --to "
             "system, as numbers or a text file; the lever arm of a 4x4 matrix is replaced by a "
             "given one, otherwise kept",
    )  # fmt: skip
    angles.add_argument(
        "--current-applied",
        action="store_true",
        help="the lines were georeferenced with the current angles, so the boresight is a "
        "correction to them",
    )
    angles.add_argument("--matrix", action="store_true", help="also print the matrices")
    angles.add_argument(
        "--from-matrix",
        type=Path,
        metavar="FILE",
        help="text file with the 3x3 or 4x4 matrix from scanner to body of the --from system",
    )
    angles.add_argument(
        "--scanner",
        choices=("turned", "kept", "mounted"),
        help="scanner axes of the other system: turned (named like its body axes), kept (as in the "
        "raw points), or mounted (mapped to the body axes by --mounting); default: as usual in "
        "that system",
    )
    for name, text in (
        (
            "--body-axes",
            "directions of the body axes of the other system, e.g. forward starboard down",
        ),
        ("--mounting", "nominal directions of the raw scanner axes, e.g. forward port up"),
    ):
        angles.add_argument(name, nargs=3, metavar=("X", "Y", "Z"), help=text)
    add_json_option(angles)


def _add_visibility(commands: "Commands[argparse.ArgumentParser]") -> None:
    visibility = add_command(
        commands, "visibility", "show the effect of systematic errors on a board for each line"
    )
    visibility.add_argument(
        "site", choices=("terrestrial", "marine"),
        help="terrestrial: vehicle 2.5 m above a board on the ground; marine: vessel 15 m from a "
             "quay 5 m high",
    )  # fmt: skip
    visibility.add_argument(
        "--output", type=Path, required=True, metavar="DIR", help="output folder"
    )
    visibility.add_argument(
        "--error", nargs="+", metavar="NAME",
        choices=(
            "roll", "pitch", "yaw", "lever-x", "lever-y", "lever-z", "range-offset",
            "scan-angle-offset",
        ),
        help="errors to simulate (default: all of the site): roll, pitch, yaw, lever-x, lever-y, "
             "lever-z, range-offset, scan-angle-offset",
    )  # fmt: skip
    visibility.add_argument(
        "--formats", nargs="+", choices=("png", "svg", "pdf"), default=["png"],
        help="formats of the figures (default png)",
    )  # fmt: skip
    visibility.add_argument(
        "--hit-beams", action="store_true",
        help="use the beams that hit the board in the presence of the error, as in a real survey, "
             "instead of the beams aimed at it, as in Shahraji's thesis",
    )  # fmt: skip
    add_json_option(visibility)
