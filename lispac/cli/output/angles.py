"""``lispac angles``: a boresight and a lever arm in the convention of another program."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option, add_triple_option
from lispac.cli.console import UsageError, print_json
from lispac.cli.messages import print_messages

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from lispac.cli.output.angles_output import ConversionInput
    from lispac.messages import Message
    from lispac.survey.conventions.conversion import ConventionSetup
    from lispac.survey.conventions.mounting_replacement import (
        CurrentMountingInSystem,
        MountingReplacement,
    )

    Array = NDArray[np.float64]


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.description = (
        "Convert a boresight and a lever arm to the convention of another program and list the "
        "assumptions made. Without arguments: list the systems with the order of their angles."
    )
    parser.add_argument(
        "values",
        nargs="*",
        metavar="A B C | PROJECT",
        help="three angles (deg) in the order of --from, or a project with an estimated boresight",
    )
    parser.add_argument(
        "--from",
        dest="from_system",
        default="lispac",
        metavar="SYSTEM",
        help="system of the given angles (default lispac)",
    )
    parser.add_argument(
        "--to", default="lispac", metavar="SYSTEM", help="system to convert to (default lispac)"
    )
    add_triple_option(
        parser,
        "--lever-arm",
        ("X", "Y", "Z"),
        "lever arm along the body axes of the --from system (m)",
    )
    add_triple_option(
        parser, "--current", ("A", "B", "C"),
        "current angles in the --to system (deg): also print the correction to them",
    )  # fmt: skip
    parser.add_argument(
        "--current-matrix",
        nargs="+", metavar="FILE | NUMBER",
        help="instead of --current: current 3x3 or 4x4 matrix from scanner to body of the --to "
             "system, as numbers or a text file; the lever arm of a 4x4 matrix is replaced by a "
             "given one, otherwise kept",
    )  # fmt: skip
    parser.add_argument(
        "--current-applied",
        action="store_true",
        help="the lines were georeferenced with the current angles, so the boresight is a "
        "correction to them",
    )
    parser.add_argument("--matrix", action="store_true", help="also print the matrices")
    parser.add_argument(
        "--from-matrix",
        type=Path,
        metavar="FILE",
        help="text file with the 3x3 or 4x4 matrix from scanner to body of the --from system",
    )
    parser.add_argument(
        "--output",
        type=Path,
        metavar="FILE",
        help="also write a file for the --to program: .json (a pipeline for pdal), .kfc (a vessel "
        "for kluster), or .txt (the values to enter, for any program)",
    )
    parser.add_argument(
        "--trajectory",
        type=Path,
        metavar="SBET",
        help="trajectory of the pipeline for pdal: it then georeferences the points of the "
        "scanner; without it, it converts them to the body frame",
    )
    _add_axes_options(parser)
    add_json_option(parser)


def _add_axes_options(parser: ArgumentParser) -> None:
    """Add the options for the axes of the other system."""
    parser.add_argument(
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
        parser.add_argument(name, nargs=3, metavar=("X", "Y", "Z"), help=text)


def run(arguments: Namespace) -> None:
    """Convert a boresight, or list the systems.

    Raises
    ------
    UsageError
        If options cannot be combined.
    """
    from lispac.cli.output.angles_output import conversion_output, list_systems, print_conversion
    from lispac.survey.conventions.mounting_replacement import replace_mounting

    if arguments.trajectory is not None and arguments.output is None:
        raise UsageError("angles: --trajectory requires --output.")
    if not arguments.values and arguments.from_matrix is None:
        if arguments.output is not None:
            raise UsageError("angles: --output requires angles, a project or --from-matrix.")
        list_systems(arguments.json)
        return
    conversion_input = _conversion_input(arguments)
    target = _convention_setup(arguments, arguments.to)
    current = _current_settings(arguments, target)
    if current is None and arguments.current_applied:
        raise UsageError("angles: --current-applied requires --current or --current-matrix.")
    new = replace_mounting(
        target, conversion_input.mounting, conversion_input.covariance, current,
        applied=arguments.current_applied, has_lever_arm=conversion_input.has_lever_arm,
    )  # fmt: skip
    notes = _write_file(arguments, conversion_input, new)
    if arguments.json:
        print_json(conversion_output(conversion_input, new, arguments.output))
    else:
        print_conversion(conversion_input, new, matrices=arguments.matrix)
        if arguments.output is not None:
            print(f"\nFile: {arguments.output}")
    print_messages(notes)


def _write_file(
    arguments: Namespace, conversion_input: ConversionInput, new: MountingReplacement
) -> Sequence[Message]:
    """Write the file for the other program if one is requested; return the notes on it."""
    from lispac.workflow.output.installation import format_of_path, write_installation

    if arguments.output is None:
        return ()
    form = format_of_path(
        arguments.output, new.in_system.setup.convention,
        with_trajectory=arguments.trajectory is not None,
    )  # fmt: skip
    notes = write_installation(
        arguments.output, new, form, trajectory=arguments.trajectory,
        sigma_warning=conversion_input.warning, project=conversion_input.project,
    )  # fmt: skip
    shown = conversion_input.converted(new).notes
    return [each for each in notes if each not in shown]


def _convention_setup(arguments: Namespace, key: str) -> ConventionSetup:
    from lispac.survey.conventions.conversion import ConventionSetup
    from lispac.survey.conventions.systems import convention_of_key

    convention = convention_of_key(key)
    if convention.key == "lispac":
        return ConventionSetup(convention)
    return ConventionSetup(
        convention,
        tuple(arguments.body_axes) if arguments.body_axes else None,
        arguments.scanner,
        tuple(arguments.mounting) if arguments.mounting else None,
    )


def _conversion_input(arguments: Namespace) -> ConversionInput:
    import numpy as np

    from lispac.cli.output.angles_output import ConversionInput
    from lispac.survey.conventions.conversion import convert_from_system, mounting_of_angles
    from lispac.survey.conventions.matrix_input import angle_product_of_matrix

    values, count = arguments.values, len(arguments.values)
    setup = _convention_setup(arguments, arguments.from_system)
    lever_arm = np.array(arguments.lever_arm or (0.0, 0.0, 0.0), dtype=float)
    has_lever_arm = arguments.lever_arm is not None
    if arguments.from_matrix is not None:
        if values:
            raise UsageError("angles: give only one of angles, a project or --from-matrix.")
        rotation, shift = _read_matrix(arguments.from_matrix)
        if shift is not None and has_lever_arm:
            raise UsageError("angles: the 4x4 matrix contains the lever arm; omit --lever-arm.")
        lever_arm = lever_arm if shift is None else shift
        # Interpreted in the same way as the printed matrix.
        mounting = convert_from_system(setup, angle_product_of_matrix(setup, rotation), lever_arm)
        return ConversionInput(
            setup, mounting, has_lever_arm or shift is not None, name="Angles of the matrix"
        )
    if count == 1:
        if has_lever_arm or setup.convention.key != "lispac":
            raise UsageError(
                "angles: a project contains its lever arm and convention; omit --lever-arm and "
                "--from."
            )
        return _input_of_project(Path(values[0]), setup)
    if count != 3:
        raise UsageError(
            "angles: give three angles in degrees, or a project; `lispac angles` lists the systems."
        )
    try:
        typed = np.radians([float(value) for value in values])
    except ValueError:
        raise UsageError(f"angles: {' '.join(values)} are not three numbers.") from None
    if not np.isfinite(typed).all():
        raise UsageError("angles: an angle is not a finite number.")
    return ConversionInput(
        setup, mounting_of_angles(setup, typed, lever_arm), has_lever_arm, typed=typed
    )


def _input_of_project(folder: Path, setup: ConventionSetup) -> ConversionInput:
    import numpy as np

    from lispac.cli.output.angles_output import PROJECT_INPUT_NAME, ConversionInput
    from lispac.survey.conventions.mounting_texts import UNCORRELATED_WARNING
    from lispac.workflow.project.projects import open_project

    project = open_project(folder)
    mounting = project.mounting("estimated")
    result = project.result
    assert result is not None  # else mounting() has raised an error
    independent = result.model.pos_errors == "independent"
    return ConversionInput(
        setup,
        mounting,
        True,
        np.asarray(result.covariance)[:3, :3],
        UNCORRELATED_WARNING if independent else None,
        PROJECT_INPUT_NAME,
        project=project,
    )


def _read_matrix(path: Path) -> tuple[Array, Array | None]:
    from lispac.survey.conventions.matrix_input import matrix_of_text

    return matrix_of_text(path.read_text(encoding="utf-8", errors="replace"), path.name)


def _current_settings(
    arguments: Namespace, target: ConventionSetup
) -> CurrentMountingInSystem | None:
    """Current settings of the system given by --to.

    Raises
    ------
    UsageError
        If they are given both as angles and as a matrix.
    """
    import numpy as np

    from lispac.survey.conventions.matrix_input import matrix_of_text
    from lispac.survey.conventions.mounting_replacement import (
        CurrentMountingInSystem,
        current_mounting_of_matrix,
    )

    if arguments.current_matrix is None:
        if arguments.current is None:
            return None
        return CurrentMountingInSystem(np.radians(arguments.current))
    if arguments.current is not None:
        raise UsageError("angles: give only one of --current and --current-matrix.")
    words = arguments.current_matrix
    if len(words) == 1:
        return current_mounting_of_matrix(target, *_read_matrix(Path(words[0])))
    return current_mounting_of_matrix(target, *matrix_of_text(" ".join(words), "--current-matrix"))
