"""Output of ``lispac angles``, as text and for JSON."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from lispac.cli.console import print_facts, print_json, print_table
from lispac.language import to_plain_text
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.present.angles import matrix
from lispac.present.output.conventions import (
    SUM_ERROR_MILLIMETRES,
    ConventionRules,
    ConventionValues,
    CorrectionValues,
    angles_table,
    angles_title,
    convention_facts,
    lever_arm_text,
    matrix_text,
    rotation_text,
    signs_text,
)
from lispac.present.plain_text import TEXT_WIDTH
from lispac.present.tables import DEGREES, Fact
from lispac.project import Project
from lispac.survey.conventions.conversion import ConventionSetup, convert_to_system
from lispac.survey.conventions.mounting_replacement import MountingReplacement
from lispac.survey.conventions.mounting_texts import lever_arm_text as position_text
from lispac.survey.conventions.mounting_texts import orientation_text
from lispac.survey.conventions.systems import SYSTEMS
from lispac.survey.georeferencing import Mounting

if TYPE_CHECKING:
    from lispac.cli.json_outputs import ConversionOutput

Array = NDArray[np.float64]

PROJECT_INPUT_NAME = "Estimated angles"
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
        Title of the angles, which describes their source.
    typed : ndarray of shape (3,), radians, or None
        The angles as entered by the user.
    project : Project or None
        Project with the mounting.
    """

    setup: ConventionSetup
    mounting: Mounting
    has_lever_arm: bool
    covariance: Array | None = None
    warning: Message | None = None
    name: str = "Given angles"
    typed: Array | None = None
    project: Project | None = None

    @property
    def values(self) -> ConventionValues:
        """The mounting in its convention."""
        converted = convert_to_system(self.mounting, self.setup, self.covariance)
        if self.typed is not None:  # other angles may describe the same rotation
            converted = replace(converted, angles=self.typed)
        return ConventionValues.of_mounting(
            converted, self.mounting, has_lever_arm=self.has_lever_arm, warning=self.warning
        )

    def converted(self, new: MountingReplacement) -> ConventionValues:
        """The mounting that replaces the current one in the other program."""
        return ConventionValues.of_mounting(
            new.in_system, new.mounting, has_lever_arm=new.has_lever_arm, warning=self.warning
        )


def print_conversion(
    conversion_input: ConversionInput, new: MountingReplacement, *, matrices: bool
) -> None:
    """Print the given angles, and the angles to enter in the other program."""
    given, values = conversion_input.values, conversion_input.converted(new)
    correction = CorrectionValues.of(new)
    is_own = conversion_input.name == PROJECT_INPUT_NAME and values.system == given.system
    if not is_own or correction is not None:
        print_facts(f"From {given.name}", convention_facts(given))
        if given.angles:
            print_table(angles_table(given, conversion_input.name, name="Value"), given.angles)
    mounting = conversion_input.mounting
    sentences = [str(orientation_text(mounting.without_nominal_axes.boresight))]
    if conversion_input.has_lever_arm:
        sentences.append(str(position_text(mounting.lever_arm)))
    print(
        "\n".join(textwrap.fill(to_plain_text(each), TEXT_WIDTH) for each in sentences), end="\n\n"
    )
    print_facts(f"To {values.name}", convention_facts(values))
    if values.angles:
        print_table(
            angles_table(values, angles_title(values), correction=correction), values.angles
        )
    texts = [message_text(each) for each in values.notes]
    if correction is not None:
        texts += _correction_texts(values, correction)
    if values.lever_arm_m is not None:
        texts.append(
            "If the program uses another reference point, add its offset to the lever arm."
        )
    for text in texts:
        print(textwrap.fill(to_plain_text(text), TEXT_WIDTH))
    if matrices or not values.angles or new.transform is not None:
        _print_matrices(values, new.in_system.rotation, correction)


def list_systems(as_json: bool) -> None:
    """Print all conventions with their rules."""
    rules = tuple(ConventionRules.of(ConventionSetup(each)) for each in SYSTEMS)
    if as_json:
        from lispac.cli.json_outputs import SystemsOutput

        print_json(SystemsOutput(rules))
        return
    print("Enter and read the angles of each system in the order given here, in degrees.\n")
    for each in rules:
        signs = [Fact("Angles", signs_text(each))] if each.angles else []
        print_facts(f"{each.system} ({each.name})", [*signs, *convention_facts(each)])


def _correction_texts(values: ConventionValues, correction: CorrectionValues) -> list[str]:
    texts = []
    if values.angles:
        error = DEGREES.text(correction.sum_error_deg)
        distance = SUM_ERROR_MILLIMETRES.text(correction.sum_error_m)
        texts = [
            "Multiply the current matrix by the correction from the left: "
            "new = correction · current.",
            f"Do not add the angles: the sum would be wrong by {error} deg, {distance} mm at 100 m."
            if correction.is_sum_inaccurate
            else "Adding the angles instead would cause an error of less than 1 mm at 100 m here.",
        ]
    if correction.current_lever_arm_m is not None:
        current = lever_arm_text(values, correction.current_lever_arm_m)
        texts.append(f"Current lever arm: {current}")
    if correction.lever_arm_text is not None:
        texts.append(message_text(correction.lever_arm_text))
    return texts


def _print_matrices(
    values: ConventionValues, rotation: Array, correction: CorrectionValues | None
) -> None:
    """Print the product of the angles, the correction of the matrices, and the 4x4 matrix."""
    multiplied = "multiplied from the left: new = correction · current"
    found: dict[str, Any] = {}
    if correction is not None:
        found["Current 3x3 matrix"] = correction.current_matrix
        found[f"Correction of the 3x3 matrix, {multiplied}"] = correction.matrix
    if values.angles or correction is not None:
        found[f"New 3x3 matrix: {rotation_text(values)}"] = rotation
    if correction is not None and correction.transform is not None:
        found["Current 4x4 matrix"] = correction.current_transform
        found[f"Correction of the 4x4 matrix, {multiplied}"] = correction.transform
    title = f"New 4x4 matrix from scanner to body of {values.name}, "
    has_lever_arm = values.lever_arm_m is not None
    title += "lever arm in metres" if has_lever_arm else "no lever arm given, zeros used"
    found[title] = values.transform
    for title, rows in found.items():
        print(f"\n{to_plain_text(title)}\n{matrix_text(rows, 10)}")


def conversion_output(
    conversion_input: ConversionInput, new: MountingReplacement, file: Path | None
) -> ConversionOutput:
    """Result of the conversion for JSON; ``file`` was written for the other program."""
    from lispac.cli.json_outputs import ConversionOutput

    mounting = conversion_input.mounting
    return ConversionOutput(
        conversion_input.values,
        conversion_input.converted(new),
        matrix(new.in_system.rotation),
        orientation_text(mounting.without_nominal_axes.boresight),
        CorrectionValues.of(new),
        file,
    )
