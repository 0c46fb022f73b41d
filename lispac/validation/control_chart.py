"""Control chart of calibrations of one system in order of time.

Each calibration is compared with the mean of the calibrations before it, as in a control chart
(Shewhart 1931). The limits are three standard deviations of this difference, since calibrations
differ in precision. A calibration beyond the limits starts a new series, whose mean does not
include the calibrations before it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np
from numpy.typing import NDArray

from lispac.validation.repeatability import (
    Calibration,
    CalibrationDifference,
    compare_calibrations,
    mean_calibration,
)

Array = NDArray[np.float64]

CONTROL_LIMIT_SIGMAS = 3.0
"""Number of sigmas of the difference from the mean beyond which the mounting has moved."""
FALSE_ALARM_PROBABILITY = 2.0 * NormalDist().cdf(-CONTROL_LIMIT_SIGMAS)
"""Probability of a false alarm in the test of one angle, 0.27 %, and in the joint test of all three
angles."""


@dataclass(frozen=True, eq=False)
class ChartedCalibration:
    """A calibration in a control chart.

    Attributes
    ----------
    calibration : Calibration
    series : int
        Number of the series it belongs to, from 0.
    before : Calibration, optional
        Mean of the calibrations before it in the current series; None for the first calibration.
    change : CalibrationDifference, optional
        Difference from that mean.
    """

    calibration: Calibration
    series: int
    before: Calibration | None = None
    change: CalibrationDifference | None = None

    @property
    def has_moved(self) -> bool:
        """Whether the mounting has moved since the calibrations before.

        True if one angle lies beyond its limits, or if the probability of the joint difference of
        all three angles is below `FALSE_ALARM_PROBABILITY`.
        """
        if self.change is None:
            return False
        beyond = bool((np.abs(self.change.significance) > CONTROL_LIMIT_SIGMAS).any())
        return beyond or self.change.probability < FALSE_ALARM_PROBABILITY


def control_chart(calibrations: Sequence[Calibration]) -> tuple[ChartedCalibration, ...]:
    """Compare each calibration with the mean of those before it.

    Parameters
    ----------
    calibrations : of one system, the earliest first
    """
    charted: list[ChartedCalibration] = []
    running: list[Calibration] = []
    for calibration in calibrations:
        number = charted[-1].series if charted else 0
        if not running:
            each = ChartedCalibration(calibration, number)
        else:
            mean = mean_calibration(running)
            each = ChartedCalibration(
                calibration, number, mean, compare_calibrations(mean, calibration)
            )
        if each.has_moved:
            each = ChartedCalibration(calibration, number + 1, each.before, each.change)
            running = []
        running.append(calibration)
        charted.append(each)
    return tuple(charted)


def control_limits(charted: ChartedCalibration) -> Array | None:
    """Lower and upper limits of the three angles, shape (2, 3), radians; None for the first."""
    if charted.before is None or charted.change is None:
        return None
    reach = CONTROL_LIMIT_SIGMAS * charted.change.sigma
    return np.array([charted.before.boresight - reach, charted.before.boresight + reach])
