"""Map projection and length units of a trajectory in eastings, northings and heights."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.units import (
    INTERNATIONAL_FOOT_M,
    LENGTH_UNIT_NAMES,
    METRES_PER_UNIT,
    US_SURVEY_FOOT_M,
)
from lispac.messages import Message, error, note, warning
from lispac.survey.crs_area import area_of_use_elsewhere
from lispac.survey.line_source import printable

if TYPE_CHECKING:
    from pyproj import CRS

Array = NDArray[np.float64]

UNSPECIFIED_UNIT = ""
"""Code for a length whose unit is not specified in the file."""


@dataclass(frozen=True)
class LengthUnit:
    """Unit of length of a column.

    Attributes
    ----------
    metres : float
    name : Message
        Name of the unit, with the source of the choice.
    reported : Message or None
        Warning that the user should check the unit.
    """

    metres: float
    name: Message
    reported: Message | None = None


@dataclass(frozen=True, eq=False)
class TrajectoryProjection:
    """A projected coordinate system of eastings and northings; made by `projection_of_text`.

    Attributes
    ----------
    text : str
        Coordinate system as given by the user.
    metres : float
        Metres in the unit of its axes.
    name : Message
        Name of the unit of its axes.
    in_feet : bool
        Whether the unit of its axes is a kind of foot.
    height_metres : float or None
        Metres in the unit of its heights; None if it has no heights.
    height_name : Message or None
        Name of the unit of its heights.
    """

    text: str
    system: "CRS"
    metres: float
    name: Message
    in_feet: bool
    height_metres: float | None
    height_name: Message | None

    def unit(self, name: str, title_unit: str, path: Path) -> LengthUnit:
        """Unit of a column of eastings or northings called ``name``."""
        if title_unit == UNSPECIFIED_UNIT:
            return LengthUnit(self.metres, note("unit.as_in_system", unit=self.name))
        if title_unit == "ft" and self.in_feet:
            return LengthUnit(self.metres, note("unit.feet_of_system", unit=self.name))
        if title_unit == "ft":
            return LengthUnit(
                METRES_PER_UNIT["ft"],
                LENGTH_UNIT_NAMES[METRES_PER_UNIT["ft"]],
                warning(
                    "trajectory.feet_not_specified", file=printable(path.name), column=name,
                    system=self.text, unit=self.name,
                ),
            )  # fmt: skip
        return LengthUnit(
            METRES_PER_UNIT[title_unit], LENGTH_UNIT_NAMES[METRES_PER_UNIT[title_unit]]
        )

    def place_warning(self, path: Path, latitude: Array, longitude: Array) -> Message | None:
        """Warning if positions are outside the area of use of the system.

        Parameters
        ----------
        latitude, longitude : ndarray of shape (n,), radians
        """
        middle = float(np.median(latitude)), float(np.median(longitude))
        area = area_of_use_elsewhere(self.system, *map(math.degrees, middle))
        if not area:
            return None
        return warning(
            "trajectory.other_area", file=printable(path.name), system=self.text,
            name=self.system.name, latitude=middle[0], longitude=middle[1], area=area,
        )  # fmt: skip

    def to_geodetic(self, path: Path, easting: Array, northing: Array) -> tuple[Array, ...]:
        """Latitude, longitude and meridian convergence, each of shape (n,), radians.

        Parameters
        ----------
        easting, northing : ndarray of shape (n,), metres

        Raises
        ------
        InputError
            If the coordinates are outside the coordinate system.
        """  # noqa: DOC501 - `_crs_error` makes an InputError
        from pyproj import Proj, Transformer
        from pyproj.exceptions import ProjError

        system = self.system
        try:
            to_geographic = Transformer.from_crs(system, system.geodetic_crs, always_xy=True)
            longitude, latitude = to_geographic.transform(
                easting / self.metres, northing / self.metres
            )
            bad = ~(np.isfinite(longitude) & np.isfinite(latitude))
            if bad.any():
                raise InputError(
                    error(
                        "trajectory.outside_system", file=str(path), system=self.text,
                        name=system.name,
                    )
                )  # fmt: skip
            factors = Proj(system).get_factors(longitude, latitude)
        except ProjError as failure:
            raise _crs_error(path, self.text, failure) from failure
        convergence = np.radians(np.asarray(factors.meridian_convergence, dtype=np.float64))
        return np.radians(latitude), np.radians(longitude), convergence


def projection_of_text(path: Path, text: str) -> TrajectoryProjection:
    """Coordinate system of eastings and northings given by the user.

    Raises
    ------
    InputError
        If it is not known or not a projected system.
    """  # noqa: DOC501 - `_crs_error` makes an InputError
    from pyproj import CRS
    from pyproj.exceptions import ProjError

    try:
        system = CRS.from_user_input(text)
    except ProjError as failure:
        raise _crs_error(path, text, failure) from failure
    if not system.is_projected or system.geodetic_crs is None:
        raise InputError(
            error("trajectory.not_projected", file=str(path), system=text, name=system.name)
        )
    horizontal = system.sub_crs_list[0] if system.is_compound else system
    across = horizontal.axis_info[0]
    up = [axis for axis in system.axis_info if axis.direction in ("up", "down")]
    return TrajectoryProjection(
        text,
        horizontal,
        across.unit_conversion_factor,
        _unit_name(across.unit_conversion_factor, across.unit_name),
        "foot" in across.unit_name
        or across.unit_conversion_factor in (INTERNATIONAL_FOOT_M, US_SURVEY_FOOT_M),
        up[0].unit_conversion_factor if up else None,
        _unit_name(up[0].unit_conversion_factor, up[0].unit_name) if up else None,
    )


def unit_of_heights(
    name: str, title_unit: str, grid: TrajectoryProjection | None, path: Path
) -> LengthUnit:
    """Unit of a column of heights called ``name``; metres by default."""
    own = None if grid is None else grid.height_metres
    if title_unit == UNSPECIFIED_UNIT:
        if grid is not None and own is not None and grid.height_name is not None:
            return LengthUnit(own, note("unit.as_in_system", unit=grid.height_name))
        reported = None
        if grid is not None and grid.in_feet:
            reported = warning(
                "trajectory.height_unit_not_stated", file=printable(path.name), column=name,
                unit=grid.name,
            )  # fmt: skip
        return LengthUnit(1.0, note("unit.metres_assumed"), reported)
    if title_unit == "ft" and grid is not None and grid.in_feet:
        return LengthUnit(grid.metres, note("unit.feet_of_system", unit=grid.name))
    return LengthUnit(METRES_PER_UNIT[title_unit], LENGTH_UNIT_NAMES[METRES_PER_UNIT[title_unit]])


def _unit_name(metres: float, name: str) -> Message:
    near = [known for si, known in LENGTH_UNIT_NAMES.items() if abs(metres / si - 1) < 1e-9]
    return near[0] if near else note("unit.other", name=name, metres=metres)


def _crs_error(path: Path, text: str, failure: Exception) -> InputError:
    reason = str(failure).splitlines()[0][:120] if str(failure) else type(failure).__name__
    return InputError(
        error("trajectory.unusable_system", file=str(path), system=text, reason=reason)
    )
