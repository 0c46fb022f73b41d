"""Values of the mounting estimated besides the boresight: priors, estimates, names and units."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message, note
from lispac.survey.georeferencing import CALIBRATION

Array = NDArray[np.float64]

BORESIGHT = CALIBRATION[:3]
OPTIONAL_NAMES = CALIBRATION[3:]
"""Parameters that are estimated only on request."""

LIMITS = np.array([*np.radians([5.0] * 3), 0.1, 0.1, 0.1, 0.1, np.radians(1.0), 0.02])
"""Radians, metres, seconds, in the order of `CALIBRATION`. A parameter that the geometry cannot
determine to better than this is fixed: a tape measure, or an inspection, is more precise."""

SIGNIFICANT = 1.96
"""Standard deviations that a change by chance exceeds one time in twenty, up or down."""

PRIOR_SIGMAS = (1e-9, 1e3)
"""Least and largest standard deviation of a prior value, radians, metres or seconds."""


@dataclass(frozen=True)
class Parameter:
    """A value to estimate.

    Attributes
    ----------
    name : str
        One of `OPTIONAL_NAMES`.
    sigma : float or None, radians, metres or seconds
        How well the value in the mounting is known; None where it is not to be relied on.
    """

    name: str
    sigma: float | None = None

    @property
    def index(self) -> int:
        """Index in `CALIBRATION`."""
        return CALIBRATION.index(self.name)


@dataclass(frozen=True)
class ParameterEstimate:
    """Result of a parameter: prior, estimate and sigmas, or why it was not estimated.

    Attributes
    ----------
    name : str
    value, sigma : float or None, radians, metres or seconds
        None where the geometry does not see it.
    prior, prior_sigma : float, None; in the same unit
        What went in.
    significance : float or None
        How far off the prior the data alone want the value, in standard deviations of theirs; None
        where there is no value, and with independent POS errors, whose sigmas are too small.
    reason : Message or None
        Why there is no value; None where there is one.
    """

    name: str
    prior: float
    prior_sigma: float | None
    value: float | None = None
    sigma: float | None = None
    significance: float | None = None
    reason: Message | None = None

    @property
    def significant(self) -> bool | None:
        """Whether the change is significant: two-sided test at 5 %; None where not tested.

        The one limit of the command line, the window and the report.
        """
        return None if self.significance is None else abs(self.significance) > SIGNIFICANT


@dataclass(frozen=True)
class ParameterDisplay:
    """Title, unit and decimals of a value estimated besides the boresight.

    Attributes
    ----------
    title : begins a sentence
    factor : shown units to one metre, radian or second
    decimals : of the value in its unit
    """

    title: str
    factor: float
    unit: Literal["m", "deg", "ms"]
    decimals: int


_DEG = math.degrees(1.0)
QUANTITIES: Mapping[str, ParameterDisplay] = {
    "lever_x": ParameterDisplay("Lever arm X", 1.0, "m", 4),
    "lever_y": ParameterDisplay("Lever arm Y", 1.0, "m", 4),
    "lever_z": ParameterDisplay("Lever arm Z", 1.0, "m", 4),
    "range_offset": ParameterDisplay("Range offset", 1.0, "m", 4),
    "scan_angle_offset": ParameterDisplay("Scan-angle offset", _DEG, "deg", 4),
    "latency": ParameterDisplay("Latency", 1e3, "ms", 2),
}

OUTPUT_UNITS: Mapping[str, tuple[float, str]] = {
    name: (1.0, "s") if name == "latency" else (each.factor, each.unit)
    for name, each in QUANTITIES.items()
}
"""Factor from what is stored to what is typed in a terminal and written as JSON, and its unit."""


def mounting_value_name(name: str) -> Message:
    """Name of an angle or of another value of the mounting."""
    return note(f"quantity.{name}")


def mounting_value_names(names: Iterable[str]) -> tuple[Message, ...]:
    """Names of several values of the mounting."""
    return tuple(map(mounting_value_name, names))


def amount_with_unit(name: str, value: float) -> Message:
    """A value of the mounting (metres, radians or seconds) with its unit."""
    return note(f"amount.{QUANTITIES[name].unit}", value=float(value))


def signed_change(name: str, value: float) -> Message:
    """A change of a value of the mounting with its sign and unit."""
    return note(f"change.{QUANTITIES[name].unit}", value=float(value))
