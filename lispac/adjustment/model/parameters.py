"""Values of the mounting other than the boresight: priors, estimates, names and units."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message, note
from lispac.survey.georeferencing import MOUNTING_VALUE_NAMES

Array = NDArray[np.float64]

OPTIONAL_NAMES = MOUNTING_VALUE_NAMES[3:]
"""Parameters that are estimated only on request."""

MAX_PARAMETER_SIGMAS = np.array([*np.radians([5.0] * 3), 0.1, 0.1, 0.1, 0.1, np.radians(1.0), 0.02])
"""Largest sigma of a determined parameter, in the order of `MOUNTING_VALUE_NAMES`; rad, m, s.

A parameter with a larger sigma counts as not determined, because a tape measure or an inspection is
more precise.
"""

MIN_SIGN_ERROR_SIGMAS = 10.0
"""Smallest ratio of a value to the sigma of its correction for which its sign is checked."""

SIGN_TOLERANCE = 0.05
"""Largest difference of the corrected value from the one with the opposite sign, as a ratio."""

CRITICAL_TEST_VALUE = 1.96
"""Critical value of the two-sided test of a change at a level of 5 %, in standard deviations."""

PRIOR_SIGMA_LIMITS = (1e-9, 1e3)
"""Smallest and largest standard deviation of a prior value, radians, metres or seconds."""


@dataclass(frozen=True)
class Parameter:
    """A value of the mounting to estimate.

    Attributes
    ----------
    name : str
        One of `OPTIONAL_NAMES`.
    sigma : float or None, radians, metres or seconds
        Standard deviation of the prior value in the mounting; None to estimate it without a prior.
    """

    name: str
    sigma: float | None = None

    @property
    def index(self) -> int:
        """Index in `MOUNTING_VALUE_NAMES`."""
        return MOUNTING_VALUE_NAMES.index(self.name)


@dataclass(frozen=True)
class ParameterEstimate:
    """Result of a parameter: prior, estimate and sigmas, or why it was not estimated.

    Attributes
    ----------
    name : str
    value, sigma : float or None, radians, metres or seconds
        Estimate and its standard deviation; None if the geometry does not determine it.
    prior : float, in the same unit
        Given value.
    prior_sigma : float or None, in the same unit
        Standard deviation of the prior value; None if none was given.
    significance : float or None
        Difference between the value from the data alone and the prior value, in standard deviations
        of the former. None if there is no estimate, and with independent POS errors, since the
        sigmas of that model are too small.
    reason : Message or None
        Reason why there is no estimate; None if there is one.
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
        """Whether the change is significant by a two-sided test at 5 %; None if not tested.

        The command line, the window and the report all use this limit.
        """
        return None if self.significance is None else abs(self.significance) > CRITICAL_TEST_VALUE


@dataclass(frozen=True)
class ParameterDisplay:
    """Title, unit and decimals of a value estimated besides the boresight.

    Attributes
    ----------
    title : str
        Name with a capital letter.
    factor : float
        Displayed units per metre, radian or second.
    unit : {"m", "deg", "ms"}
        Displayed unit.
    decimals : int
        Decimals of the displayed value.
    """

    title: str
    factor: float
    unit: Literal["m", "deg", "ms"]
    decimals: int


_DEGREES_PER_RADIAN = math.degrees(1.0)
PARAMETER_DISPLAYS: Mapping[str, ParameterDisplay] = {
    "lever_x": ParameterDisplay("Lever arm X", 1.0, "m", 4),
    "lever_y": ParameterDisplay("Lever arm Y", 1.0, "m", 4),
    "lever_z": ParameterDisplay("Lever arm Z", 1.0, "m", 4),
    "range_offset": ParameterDisplay("Range offset", 1.0, "m", 4),
    "scan_angle_offset": ParameterDisplay("Scan-angle offset", _DEGREES_PER_RADIAN, "deg", 4),
    "latency": ParameterDisplay("Latency", 1e3, "ms", 2),
}

OUTPUT_UNITS: Mapping[str, tuple[float, str]] = {
    name: (1.0, "s") if name == "latency" else (each.factor, each.unit)
    for name, each in PARAMETER_DISPLAYS.items()
}
"""Unit of each value on the command line and in JSON, and factor from the SI unit to it."""


def mounting_value_name(name: str) -> Message:
    """Name of an angle or of another value of the mounting."""
    return note(f"quantity.{name}")


def mounting_value_names(names: Iterable[str]) -> tuple[Message, ...]:
    """Names of several values of the mounting."""
    return tuple(map(mounting_value_name, names))


def amount_with_unit(name: str, value: float) -> Message:
    """Format a value of the mounting (metres, radians or seconds) with its unit."""
    return note(f"amount.{PARAMETER_DISPLAYS[name].unit}", value=float(value))


def has_opposite_sign(given: float, change: float, sigma: float) -> bool:
    """Whether a corrected value agrees with the given value with the opposite sign.

    Parameters
    ----------
    given, change, sigma : float, metres, radians or seconds
        Given value, its correction, and the standard deviation of the correction.
    """
    tolerance = max(CRITICAL_TEST_VALUE * sigma, SIGN_TOLERANCE * abs(given))
    is_clear = abs(given) > MIN_SIGN_ERROR_SIGMAS * sigma
    return is_clear and abs(change + 2 * given) < tolerance


def change_text(name: str, change: float, *, has_opposite_sign: bool = False) -> Message:
    """Change of a value (metres, radians or seconds), such as ``larger by 0.0951 m``."""
    size = amount_with_unit(name, abs(change))
    if has_opposite_sign:
        return note("change.opposite_sign", amount=size)
    return note("change.larger" if change > 0 else "change.smaller", amount=size)


def changed_value(name: str, change: float, *, has_opposite_sign: bool = False) -> Message:
    """Value of the mounting with its change, such as ``lever arm X larger by 0.0951 m``."""
    parameter = mounting_value_name(name)
    size = amount_with_unit(name, abs(change))
    if has_opposite_sign:
        return note("cause.opposite_sign", parameter=parameter, amount=size)
    return note("cause.larger" if change > 0 else "cause.smaller", parameter=parameter, amount=size)


def signed_change(name: str, value: float) -> Message:
    """Format a change of a mounting value (metres, radians or seconds) with its sign and unit."""
    return note(f"change.{PARAMETER_DISPLAYS[name].unit}", value=float(value))
