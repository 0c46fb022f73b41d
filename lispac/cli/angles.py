"""``lispac angles``: a boresight and a lever arm in the convention of another program."""

import json
from argparse import Namespace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.cli.angles_output import (
    OF_PROJECT,
    ConversionInput,
    conversion_values,
    list_systems,
    print_conversion,
)
from lispac.cli.console import UsageError
from lispac.survey.conventions.conversion import (
    ConventionSetup,
    convert_from_system,
    mounting_of_angles,
)
from lispac.survey.conventions.matrix_input import angle_product_of_matrix, matrix_of_text
from lispac.survey.conventions.mounting_replacement import (
    CurrentMountingInSystem,
    current_mounting_of_matrix,
    replace_mounting,
)
from lispac.survey.conventions.mounting_texts import UNCORRELATED_WARNING
from lispac.survey.conventions.systems import convention_of_key
from lispac.workflow.project.projects import open_project

Array = NDArray[np.float64]


def angles(arguments: Namespace) -> None:
    """Convert a boresight, or list the systems.

    Raises
    ------
    UsageError
        Where options do not go together.
    """
    if not arguments.values and arguments.from_matrix is None:
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
    if arguments.json:
        print(json.dumps(conversion_values(conversion_input, new), indent=1, allow_nan=False))
    else:
        print_conversion(conversion_input, new, matrices=arguments.matrix)


def _convention_setup(arguments: Namespace, key: str) -> ConventionSetup:
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
        # Read as it is printed.
        mounting = convert_from_system(setup, angle_product_of_matrix(setup, rotation), lever_arm)
        return ConversionInput(
            setup, mounting, has_lever_arm or shift is not None, name="from matrix"
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
    project = open_project(folder)
    mounting = project.mounting("estimated")
    result = project.result
    assert result is not None  # mounting() has refused otherwise
    independent = result.model.pos_errors == "independent"
    return ConversionInput(
        setup,
        mounting,
        True,
        np.asarray(result.covariance)[:3, :3],
        UNCORRELATED_WARNING if independent else None,
        OF_PROJECT,
    )


def _read_matrix(path: Path) -> tuple[Array, Array | None]:
    return matrix_of_text(path.read_text(encoding="utf-8", errors="replace"), path.name)


def _current_settings(
    arguments: Namespace, target: ConventionSetup
) -> CurrentMountingInSystem | None:
    """Current settings of the system given by --to.

    Raises
    ------
    UsageError
        Where they are given twice.
    """
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
