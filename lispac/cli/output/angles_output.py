"""Output of ``lispac angles``, as text and as JSON values."""

import json
import textwrap
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.survey.conventions.axes import Axes
from lispac.survey.conventions.conversion import (
    ConventionSetup,
    MountingInSystem,
    convert_to_system,
)
from lispac.survey.conventions.correction import SUM_TOLERANCE_RAD, BoresightCorrection
from lispac.survey.conventions.mounting_replacement import MountingReplacement
from lispac.survey.conventions.mounting_texts import (
    CHECK_FIRST,
    lever_arm_text,
    offsets_note,
    orientation_text,
)
from lispac.survey.conventions.systems import DIRECTION_WORDS, STATUS_WORDS, SYSTEMS, Status
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

TEXT_WIDTH = 92
LABEL_WIDTH = 12
"""Numbers of characters in a line of text, and in the labels at its beginning."""
_NEW_ANGLES_LABELS: dict[Status, str] = {
    "verified": "ENTER",
    "partly": "CHECK FIRST",
    "unverified": "CHECK FIRST",
}
"""Label of the new angles, by status of the convention; one that is not fully verified must be
checked first."""
PROJECT_INPUT_NAME = "estimated"
"""`ConversionInput.name` of the result of a project."""


@dataclass(frozen=True, eq=False)
class ConversionInput:
    """Mounting to convert, with its convention.

    Attributes
    ----------
    covariance : ndarray of shape (3, 3), radians squared, or None
        Covariance of the angles from an adjustment.
    warning : Message or None
        Warning about the covariance.
    name : str
        Label of the angles, which describes their source.
    typed : ndarray of shape (3,), radians, or None
        The angles as entered by the user.
    """

    setup: ConventionSetup
    mounting: Mounting
    has_lever_arm: bool
    covariance: Array | None = None
    warning: Message | None = None
    name: str = "given"
    typed: Array | None = None


def print_conversion(
    conversion_input: ConversionInput, new: MountingReplacement, *, matrices: bool
) -> None:
    """Print the given angles, and the angles to enter in the other program."""
    convention = new.in_system.setup.convention
    _print_input(conversion_input)
    print()
    if (
        conversion_input.name == PROJECT_INPUT_NAME
        and convention.key == "lispac"
        and new.correction is None
    ):
        _print_lever_arm(new)  # the angles were printed above
    else:
        _print_converted(conversion_input, new)
    if matrices or not convention.has_angles or new.transform is not None:
        _print_matrices(new)


def list_systems(as_json: bool) -> None:
    """Print all conventions with their rules."""
    if as_json:
        print(json.dumps([_system_values(ConventionSetup(each)) for each in SYSTEMS], indent=1))
        return
    _print_labelled(
        "",
        "Enter and read the angles of each system in the order given here, in degrees. "
        "LiDAR to body is the rotation that carries the body axes onto the "
        "scanner axes.",
    )
    print()
    for each in SYSTEMS:
        print(f"{each.key:{LABEL_WIDTH}s}{each.name}: {STATUS_WORDS[each.status]}")
        _print_labelled("", f"angles {', '.join(each.names)}" if each.has_angles else "matrix only")
        _print_rules(ConventionSetup(each))
        _print_labelled("", f"source: {each.source}")
        print()


def _print_rules(setup: ConventionSetup) -> None:
    convention = setup.convention
    if convention.has_angles:
        _print_labelled("", f"{convention.formula}, {DIRECTION_WORDS[convention.direction]}")
        _print_labelled("", str(setup.signs))
    _print_labelled("", f"body X {setup.axes[0]}, Y {setup.axes[1]}, Z {setup.axes[2]}")
    if setup.assumption is not None:
        _print_labelled("", f"ASSUMED: {setup.assumption}")


def _print_labelled(label: str, text: str) -> None:
    indent = " " * LABEL_WIDTH
    print(
        textwrap.fill(
            text, TEXT_WIDTH, initial_indent=f"{label:{LABEL_WIDTH}s}", subsequent_indent=indent
        )
    )


def _optional_text(message: Message | None) -> str:
    return "" if message is None else message_text(message)


def _angle_heads(setup: ConventionSetup) -> str:
    return f"{'degrees':{LABEL_WIDTH}s}" + "".join(
        f"{name:>14s}" for name in setup.convention.names
    )


def _angle_row(label: str, values: Array, *, signed: bool = True, decimals: int = 4) -> str:
    sign = "+" if signed else ""
    numbers = np.degrees(values)
    return f"{label:{LABEL_WIDTH}s}" + "".join(
        f"{value + 0.0:{sign}14.{decimals}f}" for value in np.round(numbers, decimals)
    )


def _print_input(conversion_input: ConversionInput) -> None:
    setup, mounting = conversion_input.setup, conversion_input.mounting
    convention = setup.convention
    _print_labelled("FROM", f"{convention.name}: {STATUS_WORDS[setup.status]}")
    _print_rules(setup)
    if convention.has_angles:
        own = convert_to_system(mounting, setup, conversion_input.covariance)
        assert own.angles is not None
        print(_angle_heads(setup))
        # The angles are printed as entered, since other angles may describe the same rotation.
        print(
            _angle_row(
                conversion_input.name,
                own.angles if conversion_input.typed is None else conversion_input.typed,
            )
        )
        _print_sigmas(own, conversion_input)
    if convention.key != "lispac":
        _print_labelled("", str(setup.scanner_axes(mounting.rotation_body_lidar)))
    print()
    _print_labelled("ORIENTATION", str(orientation_text(mounting.without_nominal_axes.boresight)))
    if conversion_input.has_lever_arm:
        _print_labelled("", str(lever_arm_text(mounting.lever_arm)))
    if offsets := offsets_note(mounting):
        _print_labelled("", message_text(offsets))


def _print_converted(conversion_input: ConversionInput, new: MountingReplacement) -> None:
    mounting, correction = new.in_system, new.correction
    setup = mounting.setup
    convention = setup.convention
    _print_labelled("TO", f"{convention.name}: {STATUS_WORDS[setup.status]}")
    _print_rules(setup)
    if convention.key != "lispac":
        _print_labelled("", str(setup.scanner_axes(new.mounting.rotation_body_lidar)))
    if mounting.angles is not None:
        decimals = 4 if mounting.note is None else 8
        print(_angle_heads(setup))
        if correction is None:
            print(_angle_row(_NEW_ANGLES_LABELS[setup.status], mounting.angles, decimals=decimals))
        else:
            _print_correction(correction, _NEW_ANGLES_LABELS[setup.status], decimals)
        _print_sigmas(mounting, conversion_input)
        if setup.status != "verified":
            _print_labelled("", message_text(CHECK_FIRST))
        if mounting.note is not None:
            _print_labelled("note", message_text(mounting.note))
    _print_lever_arm(new)


def _print_lever_arm(new: MountingReplacement) -> None:
    if not new.has_lever_arm:
        return
    axes = new.in_system.setup.axes
    if new.current is not None and new.current.lever_arm is not None:
        _print_labelled("lever arm", f"now {_lever_arm_text(axes, new.current.lever_arm)}")
        _print_labelled("", f"new {_lever_arm_text(axes, new.in_system.lever_arm)}")
    else:
        _print_labelled("lever arm", _lever_arm_text(axes, new.in_system.lever_arm))
    if new.lever_arm_note is not None:
        _print_labelled("", message_text(new.lever_arm_note))
    _print_labelled(
        "",
        "From the POS centre to the LiDAR optical centre. If the program uses another "
        "reference point, add the offset of that point.",
    )


def _lever_arm_text(axes: Axes, values: Array) -> str:
    return ", ".join(
        f"{letter} {axis} {value + 0.0:+.4f} m"
        for letter, axis, value in zip("XYZ", axes, np.round(values, 4), strict=True)
    )


def _print_sigmas(mounting: MountingInSystem, conversion_input: ConversionInput) -> None:
    if mounting.sigmas is not None:
        print(_angle_row("sigma", mounting.sigmas, signed=False))
        if conversion_input.warning:
            _print_labelled("", message_text(conversion_input.warning))


def _print_correction(correction: BoresightCorrection, label: str, decimals: int) -> None:
    assert correction.current is not None
    assert correction.correction is not None
    assert correction.new is not None
    print(_angle_row("current", correction.current, decimals=decimals))
    print(_angle_row("correction", correction.correction, decimals=decimals))
    print(_angle_row(label, correction.new, decimals=decimals) + "  (replaces the current angles)")
    _print_labelled(
        "", "new matrix = correction matrix · current matrix (correction multiplied from the left)"
    )
    error = correction.sum_error
    if error > SUM_TOLERANCE_RAD:
        _print_labelled(
            "",
            f"Do not add the angles: the sum would be wrong by {np.degrees(error):.4f} deg, "
            f"{error * 1e5:.0f} mm at 100 m.",
        )
    else:
        _print_labelled(
            "", "Adding the angles instead would cause an error of less than 1 mm at 100 m here."
        )


def _print_matrices(new: MountingReplacement) -> None:
    mounting, correction = new.in_system, new.correction
    setup = mounting.setup
    print()
    if mounting.angles is not None:
        _print_labelled(
            "3x3", f"{setup.convention.formula}, {DIRECTION_WORDS[setup.convention.direction]}"
        )
        _print_matrix(mounting.rotation)
    if correction is not None:
        _print_labelled("current", "3x3")
        _print_matrix(correction.current_rotation)
        _print_labelled("correction", "3x3, multiplied from the left: new = correction · current")
        _print_matrix(correction.rotation)
        if mounting.angles is None:
            _print_labelled(_NEW_ANGLES_LABELS[setup.status], "3x3, replaces the current matrix")
            _print_matrix(mounting.rotation)
    lever = "lever arm in metres" if new.has_lever_arm else "no lever arm given, zeros used"
    if new.current is not None and new.current.transform is not None and new.transform is not None:
        _print_labelled("current", "4x4, scanner to body")
        _print_matrix(new.current.transform)
        _print_labelled("correction", "4x4, multiplied from the left: new = correction · current")
        _print_matrix(new.transform)
        lever += "; replaces the current matrix"
    _print_labelled("4x4", f"scanner to body of {setup.convention.name}; {lever}")
    _print_matrix(mounting.transform)


def _print_matrix(matrix: Array) -> None:
    for row in matrix:
        print(" " * LABEL_WIDTH + " ".join(f"{value + 0.0:14.10f}" for value in np.round(row, 10)))


def _system_values(setup: ConventionSetup) -> dict[str, Any]:
    convention = setup.convention
    return {
        "system": convention.key,
        "name": convention.name,
        "status": setup.status,
        "assumption": str(setup.assumption or ""),
        "source": convention.source,
        "angles": [{"name": turn.name, "meaning": turn.meaning} for turn in convention.turns],
        "formula": str(convention.formula),
        "direction": convention.direction,
        "body_axes": list(setup.axes),
        "scanner_axes": setup.scanner_frame,
    }


def _mounting_values(mounting: MountingInSystem, has_lever_arm: bool) -> dict[str, Any]:
    content = _system_values(mounting.setup) | {
        "angles_deg": _degrees_by_angle(mounting.setup, mounting.angles),
        "sigma_deg": _degrees_by_angle(mounting.setup, mounting.sigmas),
        "matrix": mounting.rotation.tolist(),
        "note": _optional_text(mounting.note),
    }
    if has_lever_arm:
        content |= {
            "lever_arm_m": mounting.lever_arm.tolist(),
            "transform": mounting.transform.tolist(),
        }
    return content


def conversion_values(
    conversion_input: ConversionInput, new: MountingReplacement
) -> dict[str, Any]:
    """Result of the conversion as values for JSON."""
    own = convert_to_system(
        conversion_input.mounting, conversion_input.setup, conversion_input.covariance
    )
    mounting, correction = new.in_system, new.correction
    content: dict[str, Any] = {
        "from": _mounting_values(own, conversion_input.has_lever_arm),
        "to": _mounting_values(mounting, new.has_lever_arm),
        "orientation_text": str(
            orientation_text(conversion_input.mounting.without_nominal_axes.boresight)
        ),
        "offsets": _optional_text(offsets_note(conversion_input.mounting)),
        "warning": _optional_text(conversion_input.warning),
    }
    if correction is not None:
        content["correction"] = {
            "current_deg": _degrees_by_angle(mounting.setup, correction.current),
            "new_deg": _degrees_by_angle(mounting.setup, correction.new),
            "correction_deg": _degrees_by_angle(mounting.setup, correction.correction),
            "current_matrix": correction.current_rotation.tolist(),
            "matrix": correction.rotation.tolist(),
            "side": "left",
            "sum_error_deg": float(np.degrees(correction.sum_error)),
        }
    if new.current is not None and new.current.transform is not None and new.transform is not None:
        content["correction"] |= {
            "current_transform": new.current.transform.tolist(),
            "transform": new.transform.tolist(),
            "lever_arm": new.lever_arm,
            "lever_arm_text": _optional_text(new.lever_arm_note),
        }
    return content


def _degrees_by_angle(setup: ConventionSetup, values: Array | None) -> dict[str, float] | None:
    if values is None:
        return None
    return dict(zip(setup.convention.names, np.degrees(values).tolist(), strict=True))
