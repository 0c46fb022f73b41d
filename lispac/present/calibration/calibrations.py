"""Calibrations of one mounting: their differences, combination and history, as values and tables.

A difference is that of the named calibration minus the one it is compared with.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import Any

from lispac.adjustment.result import ANGLES
from lispac.language import N_, gettext_lazy
from lispac.messages import Message
from lispac.present.angles import Angles, angles, degrees, degrees_or_none
from lispac.present.calibration.displacement import EFFECT_DISTANCES_M
from lispac.present.tables import DEGREES, Column, Format, Table, ratio
from lispac.present.text_format import VALUE_TITLES
from lispac.validation.control_chart import ChartedCalibration, control_limits
from lispac.validation.repeatability import (
    Calibration,
    CalibrationDifference,
    RepeatedCalibrations,
)

PROBABILITY = ratio(3)
"""Format of the probability of a test."""
HISTORY_DISTANCE_INDEX = 1
"""Index in `EFFECT_DISTANCES_M` of the distance for which the history gives displacements."""


@dataclass(frozen=True)
class CalibrationValues:
    """Boresight of a calibration with its standard deviations.

    The boresight is None in the row of the empirical standard deviation of several calibrations.
    """

    name: str
    boresight_deg: Angles | None
    sigma_deg: Angles

    @classmethod
    def of(cls, calibration: Calibration) -> "CalibrationValues":
        """Values of a calibration."""
        return cls(calibration.name, degrees(calibration.boresight), degrees(calibration.sigma))


@dataclass(frozen=True)
class CalibrationDifferenceValues:
    """Difference of the calibration ``second`` minus ``first``, with its test.

    ``significance``: the differences divided by their sigmas; ``significant_angles``: those that
    differ at the 95 % level; ``chi_square``, ``probability`` and ``differ``: joint test of the
    three angles at that level; ``displacement_m``: largest displacement of a point at each of the
    ``distances_m`` from the scanner.
    """

    first: str
    second: str
    difference_deg: Angles
    sigma_deg: Angles
    significance: Angles
    significant_angles: tuple[str, ...]
    chi_square: float
    probability: float
    differ: bool
    rotation_deg: float
    distances_m: tuple[float, ...]
    displacement_m: tuple[float, ...]

    @classmethod
    def of(cls, found: CalibrationDifference) -> "CalibrationDifferenceValues":
        """Values of a difference."""
        return cls(
            first=found.first,
            second=found.second,
            difference_deg=degrees(found.angles),
            sigma_deg=degrees(found.sigma),
            significance=angles(found.significance),
            significant_angles=tuple(
                name for name, is_so in zip(ANGLES, found.significant, strict=True) if is_so
            ),
            chi_square=found.statistic,
            probability=found.probability,
            differ=found.differ,
            rotation_deg=math.degrees(found.turn),
            distances_m=EFFECT_DISTANCES_M,
            displacement_m=tuple(map(found.largest_displacement, EFFECT_DISTANCES_M)),
        )


@dataclass(frozen=True)
class CombinedCalibrations:
    """Weighted mean of the calibrations named in ``counted``, and the test of their scatter.

    ``spread_deg``: empirical standard deviation of a calibration; None for a single one.
    """

    boresight_deg: Angles
    sigma_deg: Angles
    spread_deg: Angles | None
    chi_square: float
    probability: float
    differ: bool
    counted: tuple[str, ...]

    @classmethod
    def of(
        cls, combined: RepeatedCalibrations, counted: Sequence[Calibration]
    ) -> "CombinedCalibrations":
        """Values of the combination of the calibrations ``counted``."""
        return cls(
            boresight_deg=degrees(combined.boresight),
            sigma_deg=degrees(combined.sigma),
            spread_deg=degrees_or_none(combined.spread),
            chi_square=combined.statistic,
            probability=combined.probability,
            differ=combined.differ,
            counted=tuple(each.name for each in counted),
        )

    def rows(self) -> list[CalibrationValues]:
        """Rows below those of the calibrations: the mean, and the spread if it is known."""
        mean = CalibrationValues("all together", self.boresight_deg, self.sigma_deg)
        if self.spread_deg is None:
            return [mean]
        return [mean, CalibrationValues("spread", None, self.spread_deg)]


@dataclass(frozen=True)
class DatedCalibration:
    """A calibration in the history of its system.

    ``change``: difference from the mean of the earlier calibrations of its series; the limits are
    three sigmas of this difference on either side of that mean. All are None for the first.
    ``moved``: whether the mounting has moved since; the calibration then begins a new ``series``.
    ``message`` compares it with the earlier ones.
    """

    day: date
    name: str
    folder: Path
    boresight_deg: Angles
    sigma_deg: Angles
    series: int
    lower_limit_deg: Angles | None
    upper_limit_deg: Angles | None
    change: CalibrationDifferenceValues | None
    moved: bool
    message: Message

    @classmethod
    def of(
        cls, day: date, folder: Path, charted: ChartedCalibration, message: Message
    ) -> "DatedCalibration":
        """Values of a calibration in its control chart."""
        limits = control_limits(charted)
        return cls(
            day=day,
            name=charted.calibration.name,
            folder=folder,
            boresight_deg=degrees(charted.calibration.boresight),
            sigma_deg=degrees(charted.calibration.sigma),
            series=charted.series,
            lower_limit_deg=None if limits is None else degrees(limits[0]),
            upper_limit_deg=None if limits is None else degrees(limits[1]),
            change=(
                None if charted.change is None else CalibrationDifferenceValues.of(charted.change)
            ),
            moved=charted.has_moved,
            message=message,
        )


# -- tables ----------------------------------------------------------------------------------------


def estimate_columns(name: str) -> tuple[Column[Any], Column[Any]]:
    """Columns of an angle and its standard deviation."""
    return (
        Column(f"boresight_deg.{name}", VALUE_TITLES[name], DEGREES.signed),
        Column(
            f"sigma_deg.{name}", N_("1 sigma"), DEGREES,
            N_("Standard deviation of the angle to the left"),
        ),
    )  # fmt: skip


def significance_column(name: str) -> Column[Any]:
    """Column of the difference of an angle, divided by its standard deviation."""
    return Column(
        f"significance.{name}", N_("in σ"), ratio(1).signed,
        N_("Difference from the first row, divided by its standard deviation"),
    )  # fmt: skip


def _displacement_column(
    value: Callable[[Any], float | None], distance_m: float, tip: str = ""
) -> Column[Any]:
    title = gettext_lazy("Displacement at {distance:m.0} m (cm)", distance=distance_m)
    return Column(value, title, Format("", 1, 1e2), tip)


ESTIMATE_COLUMNS = tuple(column for name in ANGLES for column in estimate_columns(name))
DIFFERENCE_COLUMNS = tuple(
    column
    for name in ANGLES
    for column in (
        Column[Any](f"difference_deg.{name}", VALUE_TITLES[name], DEGREES.signed),
        significance_column(name),
    )
)
DIFFER_COLUMN = Column[Any](
    "differ", N_("Significant\ndifference"), texts={True: N_("yes"), False: N_("no")}
)
_NAME_COLUMN = Column[Any]("name", N_("Calibration"), tip=N_("Name of the calibration project"))
CALIBRATIONS_TABLE = Table[CalibrationValues](
    N_("Boresight of each calibration"), (_NAME_COLUMN, *ESTIMATE_COLUMNS)
)


def differences_table(first: str) -> Table[CalibrationDifferenceValues]:
    """Table of the differences from the calibration of this name."""
    displacements = (
        _displacement_column(lambda row, k=k: row.displacement_m[k], distance)  # type: ignore[misc]
        for k, distance in enumerate(EFFECT_DISTANCES_M)
    )
    probability = Column[Any]("probability", "Probability", PROBABILITY)
    name = Column[Any]("second", _NAME_COLUMN.title)
    return Table(
        f"Differences from {first}",
        (name, *DIFFERENCE_COLUMNS, *displacements, probability, DIFFER_COLUMN),
    )


_DATE_COLUMN = Column[DatedCalibration]("day", N_("Date"), tip=N_("First day of the survey"))
_CHANGE_COLUMNS = (
    Column[DatedCalibration](
        "change.significance.roll", N_("Δ roll (σ)"), ratio(1).signed,
        N_(
            "Roll minus the mean of earlier calibrations, divided by the standard deviation of the "
            "difference"
        ),
    ),
    Column[DatedCalibration](
        "change.significance.pitch", N_("Δ pitch (σ)"), ratio(1).signed,
        N_(
            "Pitch minus the mean of earlier calibrations, divided by the standard deviation of "
            "the difference"
        ),
    ),
    Column[DatedCalibration](
        "change.significance.yaw", N_("Δ yaw (σ)"), ratio(1).signed,
        N_(
            "Yaw minus the mean of earlier calibrations, divided by the standard deviation of the "
            "difference"
        ),
    ),
    _displacement_column(
        lambda row: (
            None if row.change is None else row.change.displacement_m[HISTORY_DISTANCE_INDEX]
        ),
        EFFECT_DISTANCES_M[HISTORY_DISTANCE_INDEX],
        N_(
            "Largest displacement of a point at this distance from the scanner, caused by the "
            "change of the boresight since the earlier calibrations"
        ),
    ),
    Column[DatedCalibration](
        lambda row: None if row.change is None else row.moved,
        N_("Result"),
        tip=N_(
            "The mounting is reported as moved if the change of one angle, or of the three angles "
            "together, exceeds 3 σ"
        ),
        texts={True: N_("mounting has moved"), False: N_("no significant change")},
        unknown=N_("first calibration"),
    ),
)  # fmt: skip
DATED_CALIBRATIONS_TABLE = Table[DatedCalibration](
    CALIBRATIONS_TABLE.title, (_DATE_COLUMN, _NAME_COLUMN, *ESTIMATE_COLUMNS)
)
CHANGES_TABLE = Table[DatedCalibration](
    N_("Change since the earlier calibrations"), (_DATE_COLUMN, _NAME_COLUMN, *_CHANGE_COLUMNS)
)
"""Tables of the command line, side by side in `HISTORY_TABLE`."""
HISTORY_TABLE = Table[DatedCalibration]("", (*DATED_CALIBRATIONS_TABLE.columns, *_CHANGE_COLUMNS))
