"""``lispac angles``: a boresight and a lever arm in the convention of another program."""

import json
import textwrap
from argparse import Namespace
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.cli.console import UsageError
from lispac.survey.conventions.conversion import (
    Setup,
    Stated,
    mounting_of,
    mounting_of_angles,
    state,
)
from lispac.survey.conventions.correction import SUM_MATTERS, Correction, correct, on_top_of
from lispac.survey.conventions.systems import DIRECTION_WORDS, STATUS_WORDS, SYSTEMS, Status, system
from lispac.survey.conventions.typed import matrix_of_text, product_of_matrix
from lispac.survey.conventions.words import boresight_words, lever_arm_words, offsets_words
from lispac.survey.georeferencing import Mounting
from lispac.workflow.projects import open_project

Array = NDArray[np.float64]

WIDTH = 92
LABEL = 12
_NEW: dict[Status, str] = {
    "verified": "TYPE IN",
    "partly": "IF SO",
    "unverified": "IF SO",
}
"""What the new angles are called: nobody should type in an assumption without reading it."""
CHECK_FIRST = (
    "These angles are right if the assumption above is: prove it on one line over a known "
    "surface before use."
)
OF_PROJECT = "estimated"
THESIS_MODE = (
    "The POS errors were taken as independent (thesis mode): these sigmas are several times too "
    "small."
)


@dataclass(frozen=True, eq=False)
class _Given:
    """What is to be converted; covariance in radians squared where an adjustment gave one."""

    setup: Setup
    mounting: Mounting
    has_lever_arm: bool
    covariance: Array | None = None
    caution: str = ""
    name: str = "given"
    typed: Array | None = None


def angles(arguments: Namespace) -> None:
    """Convert a boresight, or list the systems."""
    if not arguments.values and arguments.from_matrix is None:
        _list_systems(arguments.json)
        return
    given = _given(arguments)
    target = _setup(arguments, arguments.to)
    current = _current(arguments, target)
    if current is None and arguments.current_applied:
        raise UsageError("angles: --current-applied goes with --current or --current-matrix.")
    mounting, covariance = given.mounting, given.covariance
    if current is not None and arguments.current_applied:
        mounting, covariance = on_top_of(target, current, mounting, covariance)
    stated = state(mounting, target, covariance)
    correction = None
    if current is not None:
        correction = correct(target.convention, current, stated.rotation)
    if arguments.json:
        print(json.dumps(_numbers(given, stated, correction), indent=1, allow_nan=False))
        return
    _print_given(given)
    print()
    if given.name == OF_PROJECT and target.convention.key == "lispac" and correction is None:
        _print_lever_arm(given, stated)  # the rest stands above
    else:
        _print_stated(given, mounting, stated, correction)
    if arguments.matrix or not target.convention.has_angles:
        _print_matrices(given, stated, correction)


def _setup(arguments: Namespace, key: str) -> Setup:
    convention = system(key)
    if convention.key == "lispac":
        return Setup(convention)
    return Setup(
        convention,
        tuple(arguments.body_axes) if arguments.body_axes else None,
        arguments.scanner,
        tuple(arguments.mounting) if arguments.mounting else None,
    )


def _given(arguments: Namespace) -> _Given:
    values, count = arguments.values, len(arguments.values)
    setup = _setup(arguments, arguments.from_system)
    lever_arm = np.array(arguments.lever or (0.0, 0.0, 0.0), dtype=float)
    has_lever_arm = arguments.lever is not None
    if arguments.from_matrix is not None:
        if values:
            raise UsageError("angles: give angles, a project or --from-matrix, one of them.")
        rotation, shift = _read_matrix(arguments.from_matrix)
        if shift is not None and has_lever_arm:
            raise UsageError("angles: the 4x4 matrix holds the lever arm; leave --lever out.")
        lever_arm = lever_arm if shift is None else shift
        # Read as it is printed.
        mounting = mounting_of(setup, product_of_matrix(setup, rotation), lever_arm)
        return _Given(setup, mounting, has_lever_arm or shift is not None, name="from matrix")
    if count == 1:
        if has_lever_arm or setup.convention.key != "lispac":
            raise UsageError("angles: a project has its own lever arm and convention.")
        return _of_project(Path(values[0]), setup)
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
    return _Given(setup, mounting_of_angles(setup, typed, lever_arm), has_lever_arm, typed=typed)


def _of_project(folder: Path, setup: Setup) -> _Given:
    project = open_project(folder)
    mounting = project.mounting("estimated")
    result = project.result
    assert result is not None  # mounting() has refused otherwise
    independent = result.model.pos_errors == "independent"
    return _Given(
        setup,
        mounting,
        True,
        np.asarray(result.covariance)[:3, :3],
        THESIS_MODE if independent else "",
        OF_PROJECT,
    )


def _read_matrix(path: Path) -> tuple[Array, Array | None]:
    return matrix_of_text(path.read_text(encoding="utf-8", errors="replace"), path.name)


def _current(arguments: Namespace, target: Setup) -> Array | None:
    """Present settings of the --to system: three angles, or their product of shape (3, 3)."""
    if arguments.current_matrix is None:
        return None if arguments.current is None else np.radians(arguments.current)
    if arguments.current is not None:
        raise UsageError("angles: give --current or --current-matrix, one of them.")
    words = arguments.current_matrix
    if len(words) == 1:
        rotation, _ = _read_matrix(Path(words[0]))
    else:
        rotation, _ = matrix_of_text(" ".join(words), "--current-matrix")
    return product_of_matrix(target, rotation)


# -- printing ------------------------------------------------------------------------------------


def _list_systems(as_json: bool) -> None:
    if as_json:
        print(json.dumps([_system_numbers(Setup(each)) for each in SYSTEMS], indent=1))
        return
    _line("", "Type and read the angles of each system in the order given here, in degrees. LiDAR "
              "to body is the turn that carries the body's axes onto the scanner's.")  # fmt: skip
    print()
    for each in SYSTEMS:
        print(f"{each.key:{LABEL}s}{each.name}: {STATUS_WORDS[each.status]}")
        _line("", f"angles {', '.join(each.names)}" if each.has_angles else "matrix only")
        _print_rules(Setup(each))
        _line("", f"source: {each.source}")
        print()


def _print_rules(setup: Setup) -> None:
    convention = setup.convention
    if convention.has_angles:
        _line("", f"{convention.formula}, {DIRECTION_WORDS[convention.direction]}")
        _line("", setup.signs)
    _line("", f"body X {setup.axes[0]}, Y {setup.axes[1]}, Z {setup.axes[2]}")
    if setup.assumption:
        _line("", f"ASSUMED: {setup.assumption}")


def _line(label: str, text: str) -> None:
    indent = " " * LABEL
    print(textwrap.fill(text, WIDTH, initial_indent=f"{label:{LABEL}s}", subsequent_indent=indent))


def _heads(setup: Setup) -> str:
    return f"{'degrees':{LABEL}s}" + "".join(f"{name:>14s}" for name in setup.convention.names)


def _row(label: str, values: Array, *, signed: bool = True, decimals: int = 4) -> str:
    sign = "+" if signed else ""
    numbers = np.degrees(values)
    return f"{label:{LABEL}s}" + "".join(
        f"{value + 0.0:{sign}14.{decimals}f}" for value in np.round(numbers, decimals)
    )


def _print_given(given: _Given) -> None:
    setup, mounting = given.setup, given.mounting
    convention = setup.convention
    _line("FROM", f"{convention.name}: {STATUS_WORDS[setup.status]}")
    _print_rules(setup)
    if convention.has_angles:
        own = state(mounting, setup, given.covariance)
        assert own.angles is not None
        print(_heads(setup))
        # What was typed is shown as typed; another triple may stand for the same rotation.
        print(_row(given.name, own.angles if given.typed is None else given.typed))
        _print_sigmas(own, given)
    if convention.key != "lispac":
        _line("", setup.scanner_words(mounting.rotation_body_lidar))
    print()
    _line("IN WORDS", boresight_words(mounting.boresight))
    if given.has_lever_arm:
        _line("", lever_arm_words(mounting.lever_arm))
    if offsets := offsets_words(mounting):
        _line("", offsets)


def _print_stated(
    given: _Given, mounting: Mounting, stated: Stated, correction: Correction | None
) -> None:
    setup = stated.setup
    convention = setup.convention
    _line("TO", f"{convention.name}: {STATUS_WORDS[setup.status]}")
    _print_rules(setup)
    if convention.key != "lispac":
        _line("", setup.scanner_words(mounting.rotation_body_lidar))
    if stated.angles is not None:
        decimals = 4 if not stated.note else 8
        print(_heads(setup))
        if correction is None:
            print(_row(_NEW[setup.status], stated.angles, decimals=decimals))
        else:
            _print_correction(correction, _NEW[setup.status], decimals)
        _print_sigmas(stated, given)
        if setup.status != "verified":
            _line("", CHECK_FIRST)
        if stated.note:
            _line("note", stated.note)
    _print_lever_arm(given, stated)


def _print_lever_arm(given: _Given, stated: Stated) -> None:
    if given.has_lever_arm:
        values = (
            f"{letter} {axis} {value + 0.0:+.4f} m"
            for letter, axis, value in zip(
                "XYZ", stated.setup.axes, np.round(stated.lever_arm, 4), strict=True
            )
        )
        _line("lever arm", ", ".join(values))
        _line("", "LiDAR optical centre from the POS centre; where the program measures from "
                  "another reference point, add that point's offset.")  # fmt: skip


def _print_sigmas(stated: Stated, given: _Given) -> None:
    if stated.sigmas is not None:
        print(_row("sigma", stated.sigmas, signed=False))
        if given.caution:
            _line("", given.caution)


def _print_correction(correction: Correction, label: str, decimals: int) -> None:
    assert correction.current is not None
    assert correction.correction is not None
    assert correction.new is not None
    print(_row("current", correction.current, decimals=decimals))
    print(_row("correction", correction.correction, decimals=decimals))
    print(_row(label, correction.new, decimals=decimals) + "  (replaces the current angles)")
    _line("", "new matrix = correction matrix · current matrix (the correction on the left)")
    error = correction.sum_error
    if error > SUM_MATTERS:
        _line("", f"Do not add the angles: current + correction would be {np.degrees(error):.4f} "
                  f"deg off, {error * 1e5:.0f} mm at 100 m.")  # fmt: skip
    else:
        _line("", "Adding the angles would be less than 1 mm off at 100 m here.")


def _print_matrices(given: _Given, stated: Stated, correction: Correction | None) -> None:
    setup = stated.setup
    print()
    if stated.angles is not None:
        _line("3x3", f"{setup.convention.formula}, {DIRECTION_WORDS[setup.convention.direction]}")
        _print_rows(stated.rotation)
    if correction is not None:
        _line("current", "3x3")
        _print_rows(correction.present)
        _line("correction", "3x3, on the left of the current one: new = correction · current")
        _print_rows(correction.rotation)
        if stated.angles is None:
            _line(_NEW[setup.status], "3x3, replaces the current one")
            _print_rows(stated.rotation)
    lever = "lever arm in metres" if given.has_lever_arm else "no lever arm given: zeros"
    _line("4x4", f"scanner to body of {setup.convention.name}; {lever}")
    _print_rows(stated.transform)


def _print_rows(matrix: Array) -> None:
    for row in matrix:
        print(" " * LABEL + " ".join(f"{value + 0.0:14.10f}" for value in np.round(row, 10)))


# -- numbers -------------------------------------------------------------------------------------


def _system_numbers(setup: Setup) -> dict[str, Any]:
    convention = setup.convention
    return {
        "system": convention.key,
        "name": convention.name,
        "status": setup.status,
        "assumption": setup.assumption,
        "source": convention.source,
        "angles": [{"name": turn.name, "meaning": turn.meaning} for turn in convention.turns],
        "formula": convention.formula,
        "direction": convention.direction,
        "body_axes": list(setup.axes),
        "scanner_axes": setup.scanner_frame,
    }


def _stated_numbers(stated: Stated, has_lever_arm: bool) -> dict[str, Any]:
    content = _system_numbers(stated.setup) | {
        "angles_deg": _named(stated.setup, stated.angles),
        "sigma_deg": _named(stated.setup, stated.sigmas),
        "matrix": stated.rotation.tolist(),
        "note": stated.note,
    }
    if has_lever_arm:
        content |= {
            "lever_arm_m": stated.lever_arm.tolist(),
            "transform": stated.transform.tolist(),
        }
    return content


def _numbers(given: _Given, stated: Stated, correction: Correction | None) -> dict[str, Any]:
    own = state(given.mounting, given.setup, given.covariance)
    words = boresight_words(given.mounting.boresight)
    content: dict[str, Any] = {
        "from": _stated_numbers(own, given.has_lever_arm),
        "to": _stated_numbers(stated, given.has_lever_arm),
        "in_words": words,
        "offsets": offsets_words(given.mounting),
        "caution": given.caution,
    }
    if correction is not None:
        content["correction"] = {
            "current_deg": _named(stated.setup, correction.current),
            "new_deg": _named(stated.setup, correction.new),
            "correction_deg": _named(stated.setup, correction.correction),
            "current_matrix": correction.present.tolist(),
            "matrix": correction.rotation.tolist(),
            "side": "left",
            "sum_error_deg": float(np.degrees(correction.sum_error)),
        }
    return content


def _named(setup: Setup, values: Array | None) -> dict[str, float] | None:
    if values is None:
        return None
    return dict(zip(setup.convention.names, np.degrees(values).tolist(), strict=True))
