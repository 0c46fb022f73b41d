"""The boresight in the convention of another program, as values and tables."""

from collections.abc import Mapping
from dataclasses import dataclass
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from lispac.language import N_, LazyText, capitalised, gettext, gettext_lazy, in_english, join_items
from lispac.messages import Message
from lispac.present.angles import matrix as matrix_rows
from lispac.present.tables import DEGREES, Column, Fact, Format, Table
from lispac.present.text_format import MINUS_SIGN, signed_number, with_unit
from lispac.project import Project
from lispac.survey.conventions.conversion import (
    ConventionSetup,
    MountingInSystem,
    convert_to_system,
)
from lispac.survey.conventions.correction import SUM_TOLERANCE_RAD
from lispac.survey.conventions.mounting_replacement import LeverArm, MountingReplacement
from lispac.survey.conventions.mounting_texts import (
    CHECK_FIRST_NOTE,
    UNCORRELATED_WARNING,
    offsets_note,
)
from lispac.survey.conventions.systems import (
    DIRECTION_WORDS,
    SCANNER_WORDS,
    STATUS_WORDS,
    Status,
    convention_of_key,
)
from lispac.survey.georeferencing import Mounting

Matrix = tuple[tuple[float, ...], ...]

MATRIX_PROGRAM = "pdal"
"""Key of the program whose matrix is in every report; other point cloud programs can apply this
matrix too."""


@dataclass(frozen=True)
class AngleRule:
    """Angle with its name and its sign convention (``meaning``) in the other program."""

    name: LazyText
    meaning: LazyText


@dataclass(frozen=True)
class ConventionAngle(AngleRule):
    """Angle with its name and its sign convention (``meaning``) in the other program.

    The sigma is None if it would have no meaning.
    """

    value_deg: float
    sigma_deg: float | None


@dataclass(frozen=True)
class ConventionRules:
    """Convention of another program, and its status.

    ``angles`` are in the order in which they are entered, and empty if the program accepts a matrix
    only.
    """

    system: str
    name: str
    status: Status
    status_text: LazyText
    source: LazyText
    assumption: LazyText | None
    check_first: Message | None
    angles: tuple[AngleRule, ...]
    formula: LazyText
    direction_text: str
    body_axes: tuple[LazyText, ...]
    scanner_text: LazyText

    @classmethod
    def of(cls, setup: ConventionSetup) -> "ConventionRules":
        """Rules of a convention."""
        convention = setup.convention
        return ConventionRules(
            system=convention.key,
            name=convention.name,
            status=setup.status,
            status_text=gettext_lazy(STATUS_WORDS[setup.status]),
            source=gettext_lazy(convention.source),
            assumption=setup.assumption,
            check_first=None if setup.status == "verified" else CHECK_FIRST_NOTE,
            angles=tuple(map(AngleRule, map(gettext_lazy, convention.names), setup.meanings)),
            formula=convention.formula,
            direction_text=DIRECTION_WORDS[convention.direction],
            body_axes=tuple(map(gettext_lazy, setup.axes)),
            scanner_text=gettext_lazy(SCANNER_WORDS[setup.scanner_frame]),
        )


@dataclass(frozen=True)
class ConventionValues(ConventionRules):
    """Boresight and lever arm in the convention of another program, and its status.

    ``transform`` is the 4x4 matrix from scanner to body coordinates of that program, metres, with
    zeros for an unknown lever arm; ``angles`` are empty if the program accepts a matrix only.
    """

    angles: tuple[ConventionAngle, ...]
    note: Message | None
    warning: Message | None
    offsets_text: Message | None
    lever_arm_m: tuple[float, ...] | None
    transform: Matrix

    @classmethod
    def of_mounting(
        cls,
        converted: MountingInSystem,
        mounting: Mounting,
        *,
        has_lever_arm: bool = True,
        warning: Message | None = None,
    ) -> "ConventionValues":
        """Values of a mounting that was converted to the convention.

        Parameters
        ----------
        mounting : Mounting
            The mounting in the convention of this program.
        """
        rules = vars(ConventionRules.of(converted.setup)) | {
            "angles": _angle_values(converted),
            "scanner_text": converted.setup.scanner_axes(mounting.rotation_body_lidar),
        }
        return cls(
            **rules,
            note=converted.note,
            warning=warning,
            offsets_text=offsets_note(mounting),
            lever_arm_m=tuple(map(float, converted.lever_arm)) if has_lever_arm else None,
            transform=_matrix(converted.transform),
        )

    @property
    def notes(self) -> tuple[Message, ...]:
        """Messages on the angles and on further values."""
        found = (self.check_first, self.note, self.offsets_text, self.warning)
        return tuple(each for each in found if each is not None)


SUM_ERROR_RANGE_M = 100.0
SUM_ERROR_MILLIMETRES = Format("mm", 0, 1e3)
"""Range for which the effect of `CorrectionValues.sum_error_deg` is given, and its format."""


@dataclass(frozen=True)
class CorrectionValues:
    """Correction from the current settings of another program to new ones.

    The new matrix is ``matrix`` times ``current_matrix``; ``sum_error_deg`` is the error of adding
    the angles instead. The angles are by name, and None if the program accepts a matrix only; the
    4x4 matrices ``current_transform`` and ``transform`` are None if the current lever arm is
    unknown. ``lever_arm`` is the origin of the new lever arm.
    """

    current_deg: Mapping[str, float] | None
    correction_deg: Mapping[str, float] | None
    new_deg: Mapping[str, float] | None
    current_matrix: Matrix
    matrix: Matrix
    side: str
    sum_error_deg: float
    current_transform: Matrix | None
    transform: Matrix | None
    lever_arm: LeverArm
    lever_arm_text: Message | None

    @classmethod
    def of(cls, new: MountingReplacement) -> "CorrectionValues | None":
        """Values of a replacement; None without current settings."""
        found, current, names = new.correction, new.current, new.in_system.setup.convention.names
        if found is None or current is None:
            return None

        def by_name(values: NDArray[np.float64] | None) -> Mapping[str, float] | None:
            if values is None:
                return None
            return dict(zip(names, np.degrees(values).tolist(), strict=True))

        return cls(
            current_deg=by_name(found.current),
            correction_deg=by_name(found.correction),
            new_deg=by_name(found.new),
            current_matrix=_matrix(found.current_rotation),
            matrix=_matrix(found.rotation),
            side="left",
            sum_error_deg=float(np.degrees(found.sum_error)),
            current_transform=None if current.transform is None else _matrix(current.transform),
            transform=None if new.transform is None else _matrix(new.transform),
            lever_arm=new.lever_arm,
            lever_arm_text=new.lever_arm_note,
        )

    @property
    def is_sum_inaccurate(self) -> bool:
        """Whether a sum of the angles differs from the new angles by 1 mm at 100 m or more."""
        return self.sum_error_deg > np.degrees(SUM_TOLERANCE_RAD)

    @property
    def sum_error_m(self) -> float:
        """Effect of `sum_error_deg` on a point at a range of `SUM_ERROR_RANGE_M`."""
        return SUM_ERROR_RANGE_M * float(np.radians(self.sum_error_deg))

    @property
    def current_lever_arm_m(self) -> tuple[float, ...] | None:
        """Lever arm of the current 4x4 matrix."""
        matrix = self.current_transform
        return None if matrix is None else tuple(row[3] for row in matrix[:3])


@dataclass(frozen=True)
class ScannerToBodyMatrix:
    """Matrix from scanner to body coordinates.

    ``rotation`` is the 3x3 part of the 4x4 matrix ``transform``, whose last column is the lever arm
    in metres.
    """

    system: str
    name: str
    body_axes: tuple[LazyText, ...]
    rotation: Matrix
    transform: Matrix


def convention_values(project: Project, key: str) -> ConventionValues | None:
    """Values to enter in the other program; None if nothing is estimated yet.

    Raises
    ------
    InputError
        If the key of the convention is unknown.
    """
    converted = _mounting_in_convention(project, key)
    if converted is None:
        return None
    assert project.result is not None
    warning = None if project.result.model.correlated else UNCORRELATED_WARNING
    return ConventionValues.of_mounting(converted, project.result.mounting, warning=warning)


def scanner_to_body_matrix(project: Project) -> ScannerToBodyMatrix | None:
    """Matrix for `MATRIX_PROGRAM`; None if nothing is estimated yet."""
    converted = _mounting_in_convention(project, MATRIX_PROGRAM)
    if converted is None:
        return None
    setup = converted.setup
    return ScannerToBodyMatrix(
        system=setup.convention.key,
        name=setup.convention.name,
        body_axes=tuple(map(gettext_lazy, setup.axes)),
        rotation=_matrix(converted.transform[:3, :3]),
        transform=_matrix(converted.transform),
    )


def _mounting_in_convention(project: Project, key: str) -> MountingInSystem | None:
    setup = ConventionSetup(convention_of_key(key))
    if project.result is None:
        return None
    covariance = np.asarray(project.result.covariance)[:3, :3]
    return convert_to_system(project.mounting("estimated"), setup, covariance)


def _angle_values(converted: MountingInSystem) -> tuple[ConventionAngle, ...]:
    if converted.angles is None:
        return ()
    setup = converted.setup
    sigmas = [None] * 3 if converted.sigmas is None else np.degrees(converted.sigmas).tolist()
    return tuple(
        ConventionAngle(gettext_lazy(name), meaning, float(np.degrees(value)), sigma)
        for name, meaning, value, sigma in zip(
            setup.convention.names, setup.meanings, converted.angles, sigmas, strict=True
        )
    )


def _matrix(values: NDArray[np.float64]) -> Matrix:
    return matrix_rows(values + 0.0)  # no negative zeros


# -- tables ----------------------------------------------------------------------------------------

ROTATION_TEXTS: Mapping[str, str] = {
    "LiDAR to body": N_("{formula}, LiDAR to body"),
    "body to LiDAR": N_("{formula}, body to LiDAR"),
}
NEW_ANGLES_TITLES: Mapping[bool, str] = {True: N_("New angles"), False: N_("Assumed angles")}
"""Titles of the angles to enter, by whether the convention is verified."""


def angles_title(values: ConventionRules) -> str:
    """Title of the angles to enter, in the language in use."""
    if not values.angles:
        return gettext("This program uses a matrix instead of angles: see below")
    if values.status == "verified":
        return gettext("Angles to enter, degrees")
    return gettext("Angles to enter if the assumption is correct, degrees")


def angle_format(values: ConventionValues) -> Format:
    """Format of the angles, with more decimals if they change much with a small rotation."""
    return DEGREES.signed if values.note is None else Format("deg", 8, is_signed=True)


def angles_table(
    values: ConventionValues,
    title: str | LazyText,
    *,
    name: str | LazyText = "",
    correction: CorrectionValues | None = None,
) -> Table[ConventionAngle]:
    """Table of the angles, with the current ones and the correction if there are any.

    Parameters
    ----------
    name : str or LazyText
        Title of the column of the angles, if they are not angles to enter.
    """
    form = angle_format(values)
    columns: list[Column[ConventionAngle]] = []
    if correction is not None:
        current, change = correction.current_deg or {}, correction.correction_deg or {}
        columns = [
            Column(lambda angle: current[in_english(angle.name)], N_("Current angles"), form),
            Column(lambda angle: change[in_english(angle.name)], N_("Correction"), form),
        ]
    columns.append(
        Column("value_deg", name or NEW_ANGLES_TITLES[values.status == "verified"], form)
    )
    if any(angle.sigma_deg is not None for angle in values.angles):
        columns.append(Column("sigma_deg", N_("1 sigma"), DEGREES))
    return Table(
        title,
        (
            Column(lambda angle: capitalised(str(angle.name)), N_("Angle")),
            *columns,
            Column(lambda angle: str(angle.meaning), N_("Sign"), is_wide=True),
        ),
    )


def convention_facts(values: ConventionRules) -> list[Fact]:
    """Rules of a convention, and the lever arm, as names and texts in the language in use."""
    source = gettext("{status}; source: {source}", status=values.status_text, source=values.source)
    facts = [Fact(gettext("Verification of the convention"), source)]
    if values.assumption is not None:
        facts.append(Fact(gettext("Assumption"), str(values.assumption)))
    facts += rotation_facts(values)
    if isinstance(values, ConventionValues) and values.lever_arm_m is not None:
        text = gettext(
            "{lever_arm}, from the POS centre to the LiDAR optical centre",
            lever_arm=lever_arm_text(values, values.lever_arm_m),
        )
        facts.append(Fact(gettext("Lever arm"), text))
    return facts


def rotation_facts(values: ConventionRules) -> list[Fact]:
    """Formula and axes of a convention, as names and texts in the language in use."""
    x, y, z = values.body_axes
    return [
        Fact(gettext("Rotation"), rotation_text(values)),
        Fact(gettext("Body axes"), gettext("X {x}, Y {y}, Z {z}", x=x, y=y, z=z)),
        Fact(gettext("Scanner axes"), str(values.scanner_text)),
    ]


def rotation_text(values: ConventionRules) -> str:
    """Product of the rotations by the angles, in the language in use."""
    if not values.angles:
        return gettext("this program imports a matrix, not angles")
    formula = str(values.formula).replace("-", MINUS_SIGN)
    return gettext(ROTATION_TEXTS[values.direction_text], formula=formula)


def signs_text(values: ConventionRules) -> str:
    """Names and signs of the angles, in the language in use."""
    return join_items(
        gettext("{angle} {meaning}", angle=angle.name, meaning=angle.meaning)
        for angle in values.angles
    )


def lever_arm_text(values: ConventionRules, lever_arm_m: tuple[float, ...]) -> str:
    """A lever arm along the body axes of a program, in the language in use."""
    # Lines are broken between two axes only.
    return ", ".join(
        f"{letter} {axis} {with_unit(signed_number(value, 4), 'm')}".replace(" ", "\u00a0")
        for letter, axis, value in zip(
            "XYZ", values.body_axes, np.round(lever_arm_m, 4) + 0.0, strict=True
        )
    )


def matrix_table(program: str) -> Table[tuple[float, ...]]:
    """Table of the 4x4 matrix from scanner to body of a program."""
    titles = (N_("Scanner X"), N_("Scanner Y"), N_("Scanner Z"), N_("Lever arm (m)"))
    form = Format("", 10, is_grouped=False)
    return Table(
        gettext_lazy("Matrix from scanner to body for {program}", program=gettext_lazy(program)),
        tuple(Column(itemgetter(k), title, form) for k, title in enumerate(titles)),
    )


def matrix_text(matrix: Matrix | NDArray[np.float64], decimals: int) -> str:
    """Rows of a matrix as text that can be read back.

    Parameters
    ----------
    matrix : ndarray or tuples of shape (3, 3) or (4, 4)
    """
    return "\n".join(
        " ".join(f"{value + 0.0:{decimals + 4}.{decimals}f}" for value in np.round(row, decimals))
        for row in matrix
    )
