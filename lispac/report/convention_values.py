"""The boresight in the convention of another program, as values of a report."""

from dataclasses import dataclass

import numpy as np

from lispac.language import LazyText, gettext_lazy
from lispac.messages import Message
from lispac.project import Project
from lispac.survey.conventions.conversion import MountingInSystem, Setup, state
from lispac.survey.conventions.systems import DIRECTION_WORDS, STATUS_WORDS, Status, system
from lispac.survey.conventions.words import CHECK_FIRST, THESIS_MODE, offsets_note

MATRIX_OF = "pdal"
"""The program whose matrix is in every report: any point cloud software can apply it."""


@dataclass(frozen=True)
class StatedAngle:
    """One angle as the other program names it; its sigma is None where it has no meaning."""

    name: LazyText
    meaning: LazyText
    value_deg: float
    sigma_deg: float | None


@dataclass(frozen=True)
class InConvention:
    """Boresight and lever arm in the convention of another program, and its verification.

    ``transform`` is the 4x4 matrix from scanner to body coordinates of that program, metres;
    ``angles`` are in the order in which they are typed, none where it takes a matrix only.
    """

    system: str
    name: str
    status: Status
    status_in_words: LazyText
    source: LazyText
    assumption: LazyText | None
    check_first: Message | None
    angles: tuple[StatedAngle, ...]
    note: Message | None
    caution: Message | None
    formula: LazyText
    direction_in_words: str
    body_axes: tuple[LazyText, ...]
    scanner_in_words: LazyText
    offsets_in_words: Message | None
    lever_arm_m: tuple[float, ...]
    transform: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class ScannerToBody:
    """The matrix from scanner to body coordinates: ``transform`` with the lever arm in metres."""

    system: str
    name: str
    body_axes: tuple[LazyText, ...]
    rotation: tuple[tuple[float, ...], ...]
    transform: tuple[tuple[float, ...], ...]


def in_convention(project: Project, key: str) -> InConvention | None:
    """Values to enter in the other program; None where nothing is estimated yet.

    Raises
    ------
    InputError
        Where there is no such program.
    """
    setup = Setup(system(key))
    stated = _stated(project, setup)
    if stated is None:
        return None
    assert project.result is not None
    mounting, convention = project.result.mounting, setup.convention
    return InConvention(
        system=convention.key,
        name=convention.name,
        status=setup.status,
        status_in_words=gettext_lazy(STATUS_WORDS[setup.status]),
        source=gettext_lazy(convention.source),
        assumption=setup.assumption,
        check_first=None if setup.status == "verified" else CHECK_FIRST,
        angles=_angles(stated),
        note=stated.note,
        caution=None if project.result.model.correlated else THESIS_MODE,
        formula=convention.formula,
        direction_in_words=DIRECTION_WORDS[convention.direction],
        body_axes=tuple(map(gettext_lazy, setup.axes)),
        scanner_in_words=setup.scanner_axes(mounting.rotation_body_lidar),
        offsets_in_words=offsets_note(mounting),
        lever_arm_m=tuple(map(float, stated.lever_arm)),
        transform=_rows(stated.transform),
    )


def scanner_to_body(project: Project) -> ScannerToBody | None:
    """The matrix for PDAL; None where nothing is estimated yet."""
    setup = Setup(system(MATRIX_OF))
    stated = _stated(project, setup)
    if stated is None:
        return None
    return ScannerToBody(
        system=setup.convention.key,
        name=setup.convention.name,
        body_axes=tuple(map(gettext_lazy, setup.axes)),
        rotation=_rows(stated.transform[:3, :3]),
        transform=_rows(stated.transform),
    )


def _stated(project: Project, setup: Setup) -> MountingInSystem | None:
    if project.result is None:
        return None
    covariance = np.asarray(project.result.covariance)[:3, :3]
    return state(project.mounting("estimated"), setup, covariance)


def _angles(stated: MountingInSystem) -> tuple[StatedAngle, ...]:
    if stated.angles is None:
        return ()
    sigmas = [None] * 3 if stated.sigmas is None else np.degrees(stated.sigmas).tolist()
    return tuple(
        StatedAngle(
            gettext_lazy(turn.name), gettext_lazy(turn.meaning), float(np.degrees(value)), sigma
        )
        for turn, value, sigma in zip(
            stated.setup.convention.turns, stated.angles, sigmas, strict=True
        )
    )


def _rows(matrix: np.ndarray) -> tuple[tuple[float, ...], ...]:
    return tuple(tuple(float(value) + 0.0 for value in row) for row in matrix)
