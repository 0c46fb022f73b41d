"""The boresight in the convention of another program, as values of a report."""

from dataclasses import dataclass

import numpy as np

from lispac.language import LazyText, gettext_lazy
from lispac.messages import Message
from lispac.project import Project
from lispac.survey.conventions.conversion import (
    ConventionSetup,
    MountingInSystem,
    convert_to_system,
)
from lispac.survey.conventions.mounting_texts import CHECK_FIRST, UNCORRELATED_WARNING, offsets_note
from lispac.survey.conventions.systems import (
    DIRECTION_WORDS,
    STATUS_WORDS,
    Status,
    convention_of_key,
)

MATRIX_PROGRAM = "pdal"
"""Key of the program whose matrix is in every report; other point cloud programs can apply this
matrix too."""


@dataclass(frozen=True)
class ConventionAngle:
    """Angle with its name and its sign convention (``meaning``) in the other program.

    The sigma is None if it would have no meaning.
    """

    name: LazyText
    meaning: LazyText
    value_deg: float
    sigma_deg: float | None


@dataclass(frozen=True)
class ConventionValues:
    """Boresight and lever arm in the convention of another program, and its status.

    ``transform`` is the 4x4 matrix from scanner to body coordinates of that program, metres;
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
    angles: tuple[ConventionAngle, ...]
    note: Message | None
    warning: Message | None
    formula: LazyText
    direction_text: str
    body_axes: tuple[LazyText, ...]
    scanner_text: LazyText
    offsets_text: Message | None
    lever_arm_m: tuple[float, ...]
    transform: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class ScannerToBodyMatrix:
    """Matrix from scanner to body coordinates.

    ``rotation`` is the 3x3 part of the 4x4 matrix ``transform``, whose last column is the lever arm
    in metres.
    """

    system: str
    name: str
    body_axes: tuple[LazyText, ...]
    rotation: tuple[tuple[float, ...], ...]
    transform: tuple[tuple[float, ...], ...]


def convention_values(project: Project, key: str) -> ConventionValues | None:
    """Values to enter in the other program; None if nothing is estimated yet.

    Raises
    ------
    InputError
        If the key of the convention is unknown.
    """
    setup = ConventionSetup(convention_of_key(key))
    converted = _mounting_in_convention(project, setup)
    if converted is None:
        return None
    assert project.result is not None
    mounting, convention = project.result.mounting, setup.convention
    return ConventionValues(
        system=convention.key,
        name=convention.name,
        status=setup.status,
        status_text=gettext_lazy(STATUS_WORDS[setup.status]),
        source=gettext_lazy(convention.source),
        assumption=setup.assumption,
        check_first=None if setup.status == "verified" else CHECK_FIRST,
        angles=_angle_values(converted),
        note=converted.note,
        warning=None if project.result.model.correlated else UNCORRELATED_WARNING,
        formula=convention.formula,
        direction_text=DIRECTION_WORDS[convention.direction],
        body_axes=tuple(map(gettext_lazy, setup.axes)),
        scanner_text=setup.scanner_axes(mounting.rotation_body_lidar),
        offsets_text=offsets_note(mounting),
        lever_arm_m=tuple(map(float, converted.lever_arm)),
        transform=_matrix_rows(converted.transform),
    )


def scanner_to_body_matrix(project: Project) -> ScannerToBodyMatrix | None:
    """Matrix for `MATRIX_PROGRAM`; None if nothing is estimated yet."""
    setup = ConventionSetup(convention_of_key(MATRIX_PROGRAM))
    converted = _mounting_in_convention(project, setup)
    if converted is None:
        return None
    return ScannerToBodyMatrix(
        system=setup.convention.key,
        name=setup.convention.name,
        body_axes=tuple(map(gettext_lazy, setup.axes)),
        rotation=_matrix_rows(converted.transform[:3, :3]),
        transform=_matrix_rows(converted.transform),
    )


def _mounting_in_convention(project: Project, setup: ConventionSetup) -> MountingInSystem | None:
    if project.result is None:
        return None
    covariance = np.asarray(project.result.covariance)[:3, :3]
    return convert_to_system(project.mounting("estimated"), setup, covariance)


def _angle_values(converted: MountingInSystem) -> tuple[ConventionAngle, ...]:
    if converted.angles is None:
        return ()
    sigmas = [None] * 3 if converted.sigmas is None else np.degrees(converted.sigmas).tolist()
    return tuple(
        ConventionAngle(
            gettext_lazy(turn.name), gettext_lazy(turn.meaning), float(np.degrees(value)), sigma
        )
        for turn, value, sigma in zip(
            converted.setup.convention.turns, converted.angles, sigmas, strict=True
        )
    )


def _matrix_rows(matrix: np.ndarray) -> tuple[tuple[float, ...], ...]:
    return tuple(tuple(float(value) + 0.0 for value in row) for row in matrix)
