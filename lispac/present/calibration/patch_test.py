"""Result of a patch test, as values and tables."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from lispac.adjustment.result import ANGLES
from lispac.language import N_, gettext_lazy
from lispac.messages import Message
from lispac.patchtest.bootstrap_precision import ObjectAgreement
from lispac.patchtest.patch_test_result import PatchTestResult
from lispac.present.angles import (
    Angles,
    angle_columns,
    angles,
    degrees,
    degrees_or_none,
    finite_or_none,
    matrix,
)
from lispac.present.calibration.calibrations import ESTIMATE_COLUMNS
from lispac.present.tables import COUNT, DEGREES, MILLIMETRES, Column, Format, Table
from lispac.present.text_format import VALUE_TITLES

CURVE_ANGLE = Format("deg", 3).signed
CURVE_MISMATCH = Format("mm", 0, 1e3)
"""Formats of the axes of the curve of the mismatch."""
EFFECT_ANGLE_DEG = 0.01
"""Error of an angle for which the misalignment of the lines is given."""


@dataclass(frozen=True)
class PatchObjectValues:
    """Agreement of an object with the result.

    ``difference_deg``: minimum of this object alone minus the result, for the ``angle`` with the
    most significant difference; None if the object determines no angle.
    """

    name: str
    pairs: tuple[str, ...]
    mismatch_m: float
    angle: str | None
    difference_deg: float
    limit_deg: float
    disagrees: bool

    @classmethod
    def of(cls, found: ObjectAgreement) -> "PatchObjectValues":
        """Values of an object."""
        return cls(
            name=found.name,
            pairs=found.pairs,
            mismatch_m=found.mismatch,
            angle=None if found.angle is None else ANGLES[found.angle],
            difference_deg=float(np.degrees(found.difference)),
            limit_deg=float(np.degrees(found.limit)),
            disagrees=found.disagrees,
        )


@dataclass(frozen=True)
class PatchTestValues:
    """Result of a patch test.

    ``separate_boresight_deg``: angles estimated one after another; ``curvature_m_per_deg``: RMS
    distance that opens between the lines by a change of each angle.
    """

    boresight_deg: Angles
    sigma_deg: Angles | None
    covariance_deg2: tuple[tuple[float, ...], ...] | None
    separate_boresight_deg: Angles
    curvature_m_per_deg: Angles
    mismatch_before_m: float | None
    mismatch_m: float
    iterations: int
    converged: bool
    lines: tuple[str, ...]
    objects: tuple[PatchObjectValues, ...]
    objects_without_pairs: tuple[str, ...]
    messages: tuple[Message, ...]

    @classmethod
    def of(cls, result: PatchTestResult) -> "PatchTestValues":
        """Values of a result."""
        covariance = result.covariance
        return cls(
            boresight_deg=degrees(result.boresight),
            sigma_deg=degrees_or_none(result.sigma),
            covariance_deg2=(
                None if covariance is None else matrix(np.degrees(1.0) ** 2 * covariance)
            ),
            separate_boresight_deg=degrees(result.separate_boresight),
            curvature_m_per_deg=angles(np.radians(1.0) * result.curvature),
            mismatch_before_m=finite_or_none(result.mismatch_before),
            mismatch_m=result.mismatch,
            iterations=result.iterations,
            converged=result.converged,
            lines=result.lines,
            objects=tuple(map(PatchObjectValues.of, result.objects)),
            objects_without_pairs=result.objects_without_pairs,
            messages=result.messages,
        )

    @property
    def misalignment_m(self) -> Angles:
        """Misalignment of the lines by an error of `EFFECT_ANGLE_DEG` of each angle."""
        return angles([EFFECT_ANGLE_DEG * each for each in self.curvature_m_per_deg])


def _if_tested(field: str) -> Callable[[PatchObjectValues], Any]:
    return lambda row: None if row.angle is None else getattr(row, field)


PATCH_TEST_TABLES = (
    Table[PatchTestValues](N_("LiDAR patch test"), ESTIMATE_COLUMNS),
    Table[PatchTestValues](
        N_("Angles estimated one after another"),
        angle_columns("separate_boresight_deg", DEGREES.signed),
    ),
    Table[PatchTestValues](
        gettext_lazy("Misalignment of the lines by {angle:x}°", angle=EFFECT_ANGLE_DEG),
        angle_columns("misalignment_m", MILLIMETRES),
    ),
)
"""Tables with one row, that of the result."""
PATCH_OBJECTS_TABLE = Table[PatchObjectValues](
    "Objects",
    (
        Column("name", "Object"),
        Column(lambda row: len(row.pairs), "Pairs", COUNT),
        Column("mismatch_m", "Mismatch", MILLIMETRES),
        Column("angle", "Angle", texts=VALUE_TITLES),
        Column(_if_tested("difference_deg"), "Difference", DEGREES.signed),
        Column(_if_tested("limit_deg"), "Limit", DEGREES),
        Column(_if_tested("disagrees"), "Agreement", texts={True: "DIFFERS", False: "agrees"}),
    ),
)
