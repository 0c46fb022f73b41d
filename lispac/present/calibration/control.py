"""Surveyed control as values and tables: its residuals, and the angles with and without it."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from lispac.adjustment.diagnostics.control_tests import contradicting_control
from lispac.adjustment.model.parameters import OUTPUT_UNITS
from lispac.adjustment.result import ANGLES, AdjustmentResult, ControlResidual
from lispac.control_points import ControlFile, ControlPoint
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.present.calibration.parameters import parameter_format
from lispac.present.tables import (
    COUNT,
    DEGREES,
    MILLIMETRES,
    PERCENT,
    YES_NO_TEXTS,
    Column,
    Format,
    Table,
    ratio,
)
from lispac.present.text_format import VALUE_TITLES
from lispac.project import Project

ControlKind = Literal["surface", "centre"]
KIND_TEXTS = {"surface": N_("point on the surface"), "centre": N_("centre of the sphere")}


@dataclass(frozen=True)
class ControlPointValues:
    """A surveyed point of a project, with its residual if the result contains it.

    ``target`` is None and ``reason`` is given if the point was not assigned. ``residual_m`` is
    positive on the side of the vessel; for a centre it is a distance. ``sigma_m`` is the standard
    deviation along the residual, ``redundancy`` from 0 (nothing checks the point) to 1, ``w`` the
    test value. ``contradicts``: the point contradicts the survey.
    """

    name: str
    source: str
    target: str | None
    kind: ControlKind
    north_m: float
    west_m: float
    up_m: float
    sigmas_m: tuple[float, ...]
    used: bool
    residual_m: float | None
    sigma_m: float | None
    redundancy: float | None
    w: float | None
    contradicts: bool | None
    reason: Message | None


@dataclass(frozen=True)
class ControlFileValues:
    """A file with control; ``kind`` is ``points`` or ``scan``."""

    file: str
    kind: str
    system: str
    sha256: str
    common_sigma_m: float
    points: int
    used_points: int


@dataclass(frozen=True)
class ValueWithoutControl:
    """A value of the mounting estimated with and without the control.

    Estimates and sigmas are in metres, degrees or seconds, as ``unit`` says. Those without control
    are None if lines and targets alone do not determine them.
    """

    name: str
    unit: str
    with_control: float | None
    sigma_with_control: float | None
    without_control: float | None
    sigma_without_control: float | None


@dataclass(frozen=True)
class ControlValues:
    """Control of a project; ``comparison`` is empty if the result contains no control."""

    files: tuple[ControlFileValues, ...]
    points: tuple[ControlPointValues, ...]
    comparison: tuple[ValueWithoutControl, ...]

    @classmethod
    def of(cls, project: Project) -> "ControlValues":
        """Control of a project and, if there is one, of its result."""
        result = project.result
        residuals = {} if result is None else {(c.source, c.name): c for c in result.control}
        wrong: set[tuple[str, str]] = set()
        if result is not None:
            points, moved = contradicting_control(result.control, result.control_translations)
            sources = {each.source for each in moved}
            wrong = {(c.source, c.name) for c in result.control
                     if c in points or c.source in sources}  # fmt: skip
        return cls(
            tuple(map(_file_values, project.control)),
            tuple(
                _point_values(
                    file, point, residuals.get((file.path.name, point.name)),
                    is_wrong=(file.path.name, point.name) in wrong,
                )
                for file in project.control
                for point in file.points
            ),
            () if result is None else tuple(_compared_values(result)),
        )  # fmt: skip


NO_CONTROL = ControlValues((), (), ())
"""Control of a project without any."""


def _file_values(file: ControlFile) -> ControlFileValues:
    return ControlFileValues(
        file.path.name, file.kind, file.system, file.sha256, file.common_sigma, len(file.points),
        len(file.used_points),
    )  # fmt: skip


def _point_values(
    file: ControlFile, point: ControlPoint, residual: ControlResidual | None, *, is_wrong: bool
) -> ControlPointValues:
    north, west, up = point.position
    return ControlPointValues(
        name=point.name,
        source=file.path.name,
        target=point.target or None,
        kind="centre" if point.is_centre else "surface",
        north_m=north,
        west_m=west,
        up_m=up,
        sigmas_m=point.sigmas,
        used=point.used and bool(point.target),
        residual_m=None if residual is None else residual.residual,
        sigma_m=None if residual is None else residual.sigma,
        redundancy=None if residual is None else residual.redundancy,
        w=None if residual is None else residual.w,
        contradicts=None if residual is None or residual.w is None else is_wrong,
        reason=point.reason,
    )


def _compared_values(result: AdjustmentResult) -> Iterator[ValueWithoutControl]:
    if not result.control:
        return
    other = result.without_control
    for k, name in enumerate(ANGLES):
        yield ValueWithoutControl(
            name, "deg", math.degrees(result.angles[k]), math.degrees(result.sigma[k]),
            None if other is None else math.degrees(other.angles[k]),
            None if other is None else math.degrees(other.sigma[k]),
        )  # fmt: skip
    for estimate in result.parameters:
        factor, unit = OUTPUT_UNITS[estimate.name]
        before = None
        if other is not None:
            before = next((e for e in other.parameters if e.name == estimate.name), None)
        numbers = (
            estimate.value,
            estimate.sigma,
            None if before is None else before.value,
            None if before is None else before.sigma,
        )
        first, second, third, fourth = (
            None if number is None else factor * number for number in numbers
        )
        yield ValueWithoutControl(estimate.name, unit, first, second, third, fourth)


def control_finding(point: ControlPointValues) -> str:
    """Finding about a control point in the language in use."""
    if point.contradicts:
        return gettext("contradicts the survey")
    if point.reason is not None and point.target is None:
        return gettext("not assigned")
    return ""


CONTROL_TABLE = Table[ControlPointValues](
    N_("Surveyed control"),
    (
        Column("name", N_("Point"), tip=N_("Name of the surveyed point")),
        Column("source", N_("File"), tip=N_("File from which the point was imported")),
        Column("target", N_("Target"), tip=N_("Target to which the point belongs"), unknown="-"),
        Column("kind", N_("Kind"), texts=KIND_TEXTS, tip=N_("What was surveyed")),
        Column("used", N_("Used"), texts=YES_NO_TEXTS, tip=N_("Whether the adjustment uses it")),
        Column(
            "residual_m", N_("Residual"), MILLIMETRES.signed,
            N_("Distance from the adjusted surface, positive on the side of the vessel"),
            unknown="-",
        ),
        Column(
            "sigma_m", N_("1 sigma"), MILLIMETRES,
            N_("Standard deviation of the surveyed point along the residual"), unknown="-",
        ),
        Column(
            "redundancy", N_("Redundancy"), PERCENT,
            N_("Share of an error of the point that its residual shows"), unknown="-",
        ),
        Column(
            "w", N_("w"), ratio(2).signed,
            N_("Test value, standard normal if the point is correct; control that contradicts the "
               "survey and the common uncertainty of a file are taken into account"), unknown="-",
        ),
        Column(control_finding, N_("Finding"), tip=N_("Finding that should be checked")),
    ),
)  # fmt: skip


LOCAL_FRAME_NAME = "the local frame"
"""Value of `ControlFileValues.system` for coordinates in the local frame."""


def _system_text(file: ControlFileValues) -> str:
    return gettext("local frame") if file.system == LOCAL_FRAME_NAME else file.system


FILE_KIND_TEXTS = {"points": N_("list of points"), "scan": N_("static scan")}
CONTROL_FILES_TABLE = Table[ControlFileValues](
    N_("Files of the control"),
    (
        Column("file", N_("File")),
        Column("kind", N_("Kind"), texts=FILE_KIND_TEXTS),
        Column(_system_text, N_("Coordinate system")),
        Column("common_sigma_m", N_("Common\n1 sigma"), MILLIMETRES),
        Column("points", N_("Points"), COUNT),
        Column("used_points", N_("Points\nused"), COUNT),
    ),
)


def _value_format(row: ValueWithoutControl) -> Format:
    if row.name in ANGLES:
        return DEGREES
    form = parameter_format(row.name)
    return Format(form.unit, form.decimals, form.factor / OUTPUT_UNITS[row.name][0])


def _signed_value_format(row: ValueWithoutControl) -> Format:
    return _value_format(row).signed


CONTROL_COMPARISON_TABLE = Table[ValueWithoutControl](
    N_("Estimates with and without the control"),
    (
        Column("name", N_("Value"), texts=VALUE_TITLES),
        Column(
            "with_control", N_("With control"), _signed_value_format,
            N_("Estimate with the control"), has_unit_in_cells=True, unknown=N_("not determined"),
        ),
        Column(
            "sigma_with_control", N_("1 sigma"), _value_format,
            N_("Standard deviation with the control"), has_unit_in_cells=True, unknown="-",
        ),
        Column(
            "without_control", N_("Without control"), _signed_value_format,
            N_("Estimate from lines and targets alone"), has_unit_in_cells=True,
            unknown=N_("not determined"),
        ),
        Column(
            "sigma_without_control", N_("1 sigma"), _value_format,
            N_("Standard deviation without the control"), has_unit_in_cells=True, unknown="-",
        ),
    ),
)  # fmt: skip
