"""Eastings, northings and heights of a trajectory: their unit, and their way to latitude."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.units import UNITS
from lispac.messages import error
from lispac.survey.crs_area import meant_elsewhere

if TYPE_CHECKING:
    from pyproj import CRS

Array = NDArray[np.float64]

LENGTHS = {code: unit.si for code, unit in UNITS.items() if unit.kind == "length"}
"""Metres in each unit; ``ft`` are feet of which the file does not say which."""
UNSTATED = ""
"""Unit of a length of which the file says none."""
LENGTH_WORDS = {unit.si: unit.words for unit in UNITS.values() if unit.kind == "length"}
"""Names of the units by the metres in them."""


@dataclass(frozen=True)
class Length:
    """A unit of a column.

    Attributes
    ----------
    metres : float
    words : str
        Its name, and how it was settled.
    doubt : str
        What the user should look at; empty where nothing.
    """

    metres: float
    words: str
    doubt: str = ""


@dataclass(frozen=True, eq=False)
class Grid:
    """A projected coordinate system of eastings and northings; made by `grid_of`.

    Attributes
    ----------
    text : str
        As the user states it.
    metres : float
        In a unit of its axes.
    words : str
        Name of that unit.
    height_metres : float or None
        In a unit of its heights; None where it has none.
    """

    text: str
    system: "CRS"
    metres: float
    words: str
    height_metres: float | None
    height_words: str

    @property
    def in_feet(self) -> bool:
        """Whether its axes count feet of some kind."""
        return "foot" in self.words or "feet" in self.words

    def unit(self, name: str, stated: str) -> Length:
        """Unit of a column of eastings or northings called ``name``."""
        if stated == UNSTATED:
            return Length(
                self.metres,
                f"{self.words}, as in the coordinate system (the file names no unit)",
            )
        if stated == "ft" and self.in_feet:
            return Length(self.metres, f"{self.words}, the feet of the coordinate system")
        if stated == "ft":
            return Length(
                LENGTHS["ft"],
                LENGTH_WORDS[LENGTHS["ft"]],
                f"Column {name} is in feet, the file does not say which, and {self.text} is in "
                f"{self.words}; feet of 0.3048 m are taken. US survey feet would put the "
                "positions metres elsewhere: make sure which they are, and state it or name it in "
                "the header.",
            )
        return Length(LENGTHS[stated], LENGTH_WORDS[LENGTHS[stated]])

    def doubt_of_place(self, latitude: Array, longitude: Array) -> str:
        """That positions lie where the system is not meant for; empty where they do.

        Parameters
        ----------
        latitude, longitude : ndarray of shape (n,), radians
        """
        middle = np.degrees(np.median(latitude)), np.degrees(np.median(longitude))
        elsewhere = meant_elsewhere(self.system, float(middle[0]), float(middle[1]))
        if not elsewhere:
            return ""
        return (
            f"In {self.text} ({self.system.name}) the positions lie at latitude {middle[0]:.1f}, "
            f"longitude {middle[1]:.1f} deg, and it is meant for {elsewhere}: check the coordinate "
            "system, the unit of eastings and northings (feet, metres), and their order."
        )

    def to_geodetic(self, path: Path, easting: Array, northing: Array) -> tuple[Array, ...]:
        """Latitude, longitude and meridian convergence, each of shape (n,), radians.

        Parameters
        ----------
        easting, northing : ndarray of shape (n,), metres

        Raises
        ------
        InputError
            Where the coordinates lie outside.
        """  # noqa: DOC501 - `_unusable` makes an InputError
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
            raise _unusable(path, self.text, failure) from failure
        convergence = np.radians(np.asarray(factors.meridian_convergence, dtype=np.float64))
        return np.radians(latitude), np.radians(longitude), convergence


def grid_of(path: Path, text: str) -> Grid:
    """The coordinate system of eastings and northings that the user states.

    Raises
    ------
    InputError
        Where it is not known, or is not a projected one.
    """  # noqa: DOC501 - `_unusable` makes an InputError
    from pyproj import CRS
    from pyproj.exceptions import ProjError

    try:
        system = CRS.from_user_input(text)
    except ProjError as failure:
        raise _unusable(path, text, failure) from failure
    if not system.is_projected or system.geodetic_crs is None:
        raise InputError(
            error("trajectory.not_projected", file=str(path), system=text, name=system.name)
        )
    horizontal = system.sub_crs_list[0] if system.is_compound else system
    across = horizontal.axis_info[0]
    up = [axis for axis in system.axis_info if axis.direction in ("up", "down")]
    return Grid(
        text,
        horizontal,
        across.unit_conversion_factor,
        _named(across.unit_conversion_factor, across.unit_name),
        up[0].unit_conversion_factor if up else None,
        _named(up[0].unit_conversion_factor, up[0].unit_name) if up else "",
    )


def unit_of_heights(name: str, stated: str, grid: Grid | None) -> Length:
    """Unit of a column of heights called ``name``; metres where nobody says otherwise."""
    own = None if grid is None else grid.height_metres
    if stated == UNSTATED:
        if grid is not None and own is not None:
            return Length(
                own, f"{grid.height_words}, as in the coordinate system (the file names no unit)"
            )
        doubt = ""
        if grid is not None and grid.in_feet:
            doubt = (
                f"No unit is stated for the heights in column {name}, and eastings and northings "
                f"are in {grid.words}; metres are taken: make sure, and state feet if they are, "
                "or name them in the header."
            )
        return Length(1.0, "metres (no unit is stated)", doubt)
    if stated == "ft" and grid is not None and grid.in_feet:
        return Length(grid.metres, f"{grid.words}, the feet of the coordinate system")
    return Length(LENGTHS[stated], LENGTH_WORDS[LENGTHS[stated]])


def _named(metres: float, name: str) -> str:
    near = [words for known, words in LENGTH_WORDS.items() if abs(metres / known - 1) < 1e-9]
    return near[0] if near else f"{name} ({metres:.9g} m each)"


def _unusable(path: Path, text: str, failure: Exception) -> InputError:
    reason = str(failure).splitlines()[0][:120] if str(failure) else type(failure).__name__
    return InputError(
        error("trajectory.unusable_system", file=str(path), system=text, reason=reason)
    )
