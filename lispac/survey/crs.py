"""Coordinate systems of georeferenced points and their conversion to the local frame by PROJ.

A map projection preserves neither north nor scale. Grid coordinates are therefore never converted
to the local frame by subtraction, but by latitude, longitude and height above the ellipsoid.

The trajectory has no datum of its own. A cloud is computed by adding vectors to the trajectory and
projecting the sum. Unless the user specifies another datum, the trajectory is therefore assumed to
be in the datum of the cloud, and no datum shift is applied, so that the conversion can be inverted
exactly. Network access of PROJ is disabled.
"""

import os
import re
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from pyproj import CRS, Transformer
from pyproj.crs import CompoundCRS, GeographicCRS
from pyproj.enums import TransformDirection
from pyproj.exceptions import CRSError, ProjError
from pyproj.network import set_network_enabled  # type: ignore[attr-defined]

from lispac.errors import InputError
from lispac.geometry.frames import (
    FLATTENING,
    SEMI_MAJOR_AXIS,
    LocalFrame,
    ecef_to_geodetic,
    geodetic_to_ecef,
)
from lispac.language import gettext
from lispac.messages import Message, error, note
from lispac.survey.crs_operation import best_operation

Array = NDArray[np.float64]
Geodetic = tuple[Array, Array, Array]
UNIT_CODES = {
    "metre": "unit.metres", "foot": "unit.feet", "US survey foot": "unit.us_survey_feet",
    "us-survey-foot": "unit.us_survey_feet",
}  # fmt: skip
"""Codes of the texts of units, by their names in PROJ and in options."""
METRES_PER_UNIT = {"metre": 1.0, "foot": 0.3048, "us-survey-foot": 1200 / 3937}
"""Length in metres of each unit."""
ELLIPSOID_HEIGHTS = "ellipsoid"
"""Height reference of heights above the ellipsoid."""
DATE_DEPENDENT_TEXTS = ("t_epoch=", "defmodel")
"""Text in PROJ operations whose result depends on the date."""
GEOID_GRID_SUFFIXES = (".gtx", ".tif", ".tiff")
HEIGHT_OFFSET_PATTERN = re.compile(r"[+-]\d+(\.\d+)?")
"""Pattern of an offset in metres to be added to heights; its sign distinguishes it from a code."""
Columns = tuple[Array, Array, Array]
BLOCK_POINTS = 1 << 17
"""Largest number of points per call, for example of PROJ; calls run on several cores."""


@dataclass(frozen=True, eq=False)
class CoordinateSystem:
    """Conversion of the coordinates of a cloud to latitude, longitude and height.

    Created by `coordinate_system`.

    Attributes
    ----------
    crs : pyproj.CRS
        System as given by the user.
    height : str
        Description of the height reference.
    unit : str
        Unit of the horizontal coordinates.
    assumptions : tuple of Message
        Assumptions about the system.
    metres : three of float
        Length in metres of the units of x, y and height; for a degree, its length at the equator.
    written : pyproj.CRS
        System to be written to files: includes the chosen heights if they have a code.
    """

    crs: CRS
    height: str
    unit: str
    assumptions: tuple[Message, ...]
    metres: tuple[float, float, float]
    written: CRS
    _height_factor: float
    _to_geographic: Transformer
    _to_ellipsoid: Transformer | None
    _epoch: float | None
    _height_offset: float = 0.0
    frame: LocalFrame | None = None

    @property
    def name(self) -> str:
        """Name, with the EPSG code if there is one."""
        if self.frame is not None:
            return gettext("local frame (north, west, up)")
        code = self.crs.to_epsg()
        return f"{self.crs.name} (EPSG:{code})" if code else str(self.crs.name)

    @property
    def pipeline(self) -> tuple[str, ...]:
        """PROJ pipeline; equal for two systems that give the same numbers."""
        steps = (self._to_geographic, self._to_ellipsoid)
        definitions = tuple(str(step.definition) for step in steps if step is not None)
        if self.frame is not None:
            return (repr(self.frame),)
        dated = any(word in step for step in definitions for word in DATE_DEPENDENT_TEXTS)
        heights = f"{self._height_factor!r} {self._height_offset!r}"
        return (*definitions, heights, repr(self._epoch) if dated else "")

    @property
    def is_geographic(self) -> bool:
        """Whether horizontal coordinates are longitude and latitude in degrees."""
        return bool(self.crs.is_geographic) and self.frame is None

    def to_geodetic(self, points_crs: Array, *, strict: bool = True) -> Geodetic:
        """Latitude, longitude (radians) and ellipsoidal height (metres) of points.

        Parameters
        ----------
        points_crs : ndarray of shape (n, 3)
            East, north (or longitude, latitude in degrees) and height, as LAS stores them.
        strict : bool
            Whether points outside raise an error; otherwise their results are not finite.

        Raises
        ------
        InputError
            If points are outside the area covered by the system or its geoid grid.
        """
        run = partial(self._to_geodetic_block, strict=strict)
        return run_in_blocks(run, *np.asarray(points_crs, dtype=float).T)

    def to_ecef(self, points_crs: Array) -> Array:
        """Earth-centred coordinates of points, shape (n, 3), metres."""
        return geodetic_to_ecef(*self.to_geodetic(points_crs))

    def to_local(self, points_crs: Array, frame: LocalFrame, *, strict: bool = True) -> Array:
        """Points in the local frame, shape (n, 3), metres; see `to_geodetic`."""
        return frame.to_local(*self.to_geodetic(points_crs, strict=strict))

    def from_geodetic(
        self, latitude: Array, longitude: Array, height: Array, *, strict: bool = True
    ) -> Array:
        """The inverse of `to_geodetic`, shape (n, 3); not finite outside unless ``strict``."""
        run = partial(self._from_geodetic_block, strict=strict)
        return np.stack(run_in_blocks(run, latitude, longitude, height), axis=-1)

    def from_ecef(self, points_ecef: Array) -> Array:
        """The inverse of `to_ecef`, shape (n, 3)."""
        return self.from_geodetic(*ecef_to_geodetic(points_ecef))

    def from_local(self, points_local: Array, frame: LocalFrame, *, strict: bool = True) -> Array:
        """The inverse of `to_local`, shape (n, 3); not finite outside unless ``strict``."""
        return self.from_geodetic(*frame.to_geodetic(points_local), strict=strict)

    def _to_geodetic_block(self, x: Array, y: Array, z: Array, *, strict: bool = True) -> Geodetic:
        if self.frame is not None:
            return self.frame.to_geodetic(np.stack([x, y, z], axis=-1))
        place = self._transform(self._to_geographic, (x, y, z * self._height_factor))
        if self._to_ellipsoid is not None:
            place = self._transform(self._to_ellipsoid, place)
        longitude, latitude, height = place
        if strict:
            self._require_inside(place, (x, y, z))
        else:  # PROJ returns infinity, whose sine would cause a warning
            inside = np.isfinite(np.stack(place)).all(axis=0)
            latitude, longitude, height = (
                np.where(inside, each, np.nan) for each in (latitude, longitude, height)
            )
        return np.radians(latitude), np.radians(longitude), height + self._height_offset

    def _from_geodetic_block(
        self, latitude: Array, longitude: Array, height: Array, *, strict: bool = True
    ) -> Geodetic:
        if self.frame is not None:
            x, y, z = self.frame.to_local(latitude, longitude, height).T
            return x, y, z
        given = (np.degrees(longitude), np.degrees(latitude), height - self._height_offset)
        back = TransformDirection.INVERSE
        place = given
        if self._to_ellipsoid is not None:
            place = self._transform(self._to_ellipsoid, place, back)
        x, y, z = self._transform(self._to_geographic, place, back)
        if strict:
            self._require_inside((x, y, z), given)
        return x, y, z / self._height_factor

    def _transform(
        self,
        transformer: Transformer,
        place: Geodetic,
        direction: TransformDirection = TransformDirection.FORWARD,
    ) -> Geodetic:
        epoch = None if self._epoch is None else np.full(len(place[0]), self._epoch)
        set_network_enabled(active=False)
        moved = transformer.transform(*place, tt=epoch, direction=direction)
        return moved[0], moved[1], moved[2]

    def _require_inside(self, converted: Geodetic, original: Geodetic) -> None:
        outside = ~np.isfinite(np.stack(converted)).all(axis=0)
        if outside.any():
            first = int(np.argmax(outside))
            x, y, z = (float(axis[first]) for axis in original)
            raise InputError(
                error(
                    "crs.points_outside", count=int(outside.sum()), system=self.name, x=x, y=y, z=z
                )
            )


def coordinate_system(
    text: str,
    *,
    height: str = "",
    height_unit: str = "",
    trajectory_datum: str = "",
    epoch: float | None = None,
) -> CoordinateSystem:
    """Resolve a coordinate system from its text.

    Parameters
    ----------
    text : str
        An EPSG code (``EPSG:32619``, ``32619``, ``EPSG:6347+5703``), WKT, a name known to PROJ, or
        ``local:`` followed by latitude, longitude (degrees) and height (metres above the ellipsoid)
        of the origin of a North-West-Up frame, separated by commas.
    height : str
        Height reference: ``ellipsoid``, the EPSG code of a vertical system, the path of a geoid
        grid (.gtx, .tif), or metres with a sign (``+31.2``, ``-28.4``) to be added to obtain
        heights above the ellipsoid. If empty, that of the system, or else the ellipsoid.
    height_unit : str
        A key of `METRES_PER_UNIT`; if empty, that of the system, or else that of the horizontal
        coordinates.
    trajectory_datum : str
        Geographic system of the trajectory, if it differs from that of the points.
    epoch : float or None, decimal year
        Required if the shift between the datums depends on time.

    Raises
    ------
    InputError
        If PROJ does not know the system, it has no relation to the earth, or a grid is missing.
    """
    if text.startswith(LOCAL_FRAME_PREFIX):
        return _local_system(text)
    try:
        return _resolve_heights(
            _without_datum_shift(_parse_system(text)), height, height_unit, trajectory_datum, epoch
        )
    except (CRSError, ProjError, IndexError) as reason:  # error of pyproj for inconsistent systems
        raise InputError(
            error("crs.unusable", system=_shorten(text), reason=_shorten(str(reason)))
        ) from reason


def local_frame_text(frame: LocalFrame) -> str:
    """Text of a local frame for `coordinate_system`."""
    latitude, longitude = np.degrees(frame.latitude), np.degrees(frame.longitude)
    return f"{LOCAL_FRAME_PREFIX}{float(latitude)!r},{float(longitude)!r},{float(frame.height)!r}"


def _local_system(text: str) -> CoordinateSystem:
    """Coordinate system of a local frame.

    Raises
    ------
    InputError
        If the text is not latitude, longitude and height.
    """
    try:
        latitude, longitude, height = (
            float(part) for part in text.removeprefix(LOCAL_FRAME_PREFIX).split(",")
        )
    except ValueError as reason:
        raise InputError(error("crs.local_frame", system=_shorten(text))) from reason
    wgs = CRS.from_epsg(4979)
    frame = LocalFrame(float(np.radians(latitude)), float(np.radians(longitude)), height)
    return CoordinateSystem(
        wgs, ELLIPSOID_HEIGHTS, "metre", (note("assumed.local_frame_of_cloud"),),
        (1.0, 1.0, 1.0), wgs, 1.0, Transformer.from_crs(wgs, wgs), None, None, frame=frame,
    )  # fmt: skip


LOCAL_FRAME_PREFIX = "local:"


def _resolve_heights(
    crs: CRS, height: str, height_unit: str, trajectory_datum: str, epoch: float | None
) -> CoordinateSystem:
    horizontal, vertical = _split_compound(crs)
    if not (horizontal.is_projected or horizontal.is_geographic or horizontal.is_geocentric):
        raise InputError(error("crs.not_tied_to_earth", system=_shorten(crs.name)))
    assumptions = [note("assumed.system", system=crs.name)]
    grid: Path | None = None
    offset = 0.0
    if HEIGHT_OFFSET_PATTERN.fullmatch(height.strip()):
        offset, vertical = float(height), None
        assumptions.append(note("assumed.height_offset", offset=offset))
    elif height.lower().endswith(GEOID_GRID_SUFFIXES):
        grid, vertical = Path(height), None
    elif height == ELLIPSOID_HEIGHTS:
        vertical = None
    elif height:
        vertical = _parse_vertical_system(height)
    elif vertical is None and len(crs.axis_info) < 3:
        assumptions.append(note("assumed.heights_not_named"))
    if horizontal.is_geocentric:
        if height:
            raise InputError(error("crs.geocentric_height", system=_shorten(crs.name)))
        grid = vertical = None
    source = (
        horizontal.to_3d() if vertical is None
        else CompoundCRS(crs.name, [horizontal.to_2d(), vertical])
    )  # fmt: skip
    factor, unit = _height_factor(crs, source, height_unit)
    if not height_unit and len(crs.axis_info) < 3:
        code = "assumed.height_unit"
        if not crs.is_geographic:
            code = "assumed.height_unit_as_horizontal"
        shown = note(UNIT_CODES[unit]) if unit in UNIT_CODES else unit
        assumptions.append(note(code, unit=shown))
    target = _ellipsoidal_system(horizontal, trajectory_datum)
    geographic = horizontal.geodetic_crs
    assumptions.append(
        note("assumed.datum_shift", datum=target.name, source=horizontal.name)
        if trajectory_datum
        else note("assumed.datum", datum=target.name if geographic is None else geographic.name)
    )
    to_geographic = best_operation(source, target, epoch)
    above = grid.name if grid else vertical.name if vertical else ELLIPSOID_HEIGHTS
    return CoordinateSystem(
        crs=crs,
        height=f"{above} ({unit})",
        unit=horizontal.axis_info[0].unit_name,
        assumptions=tuple(assumptions),
        metres=_metres_per_unit(horizontal, source, factor),
        written=crs if not height else horizontal if vertical is None else source,
        _height_factor=factor,
        _to_geographic=to_geographic,
        _to_ellipsoid=None if grid is None else geoid_grid(grid),
        _epoch=epoch,
        _height_offset=offset,
    )


def _parse_system(text: str) -> CRS:
    if not text.strip():
        raise InputError(error("crs.none_given"))
    plain = text.strip()
    try:
        return CRS.from_user_input(f"EPSG:{plain}" if plain.isdigit() else plain)
    except CRSError as reason:
        raise InputError(error("crs.unknown", system=_shorten(text))) from reason


def _shorten(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= 60 else f"{line[:57]}..."


def _split_compound(crs: CRS) -> tuple[CRS, CRS | None]:
    """Horizontal system, and the vertical one if heights are not above the ellipsoid."""
    if not crs.is_compound:
        return crs, None
    horizontal, vertical = crs.sub_crs_list[:2]
    return _without_datum_shift(horizontal), _without_datum_shift(vertical)


def _without_datum_shift(crs: CRS) -> CRS:
    """System without a shift to another datum that its definition may contain."""
    return crs.source_crs if crs.is_bound and crs.source_crs is not None else crs


def _parse_vertical_system(height: str) -> CRS:
    vertical = _parse_system(height)
    if not vertical.is_vertical:
        raise InputError(error("crs.not_vertical", height=height, system=vertical.name))
    return vertical


def _height_factor(crs: CRS, source: CRS, height_unit: str) -> tuple[float, str]:
    """Factor of heights to the unit of ``source``, and the name of their unit.

    Raises
    ------
    InputError
        If the unit is unknown.
    """
    own = source.axis_info[-1].unit_conversion_factor
    if height_unit:
        if height_unit not in METRES_PER_UNIT:
            raise InputError(
                error("crs.unknown_unit", unit=height_unit, units=tuple(METRES_PER_UNIT))
            )
        return METRES_PER_UNIT[height_unit] / own, height_unit
    first = crs.axis_info[0]
    if len(crs.axis_info) < 3 and not crs.is_geographic:
        return first.unit_conversion_factor / own, first.unit_name
    return 1.0, source.axis_info[-1].unit_name


def _metres_per_unit(horizontal: CRS, source: CRS, factor: float) -> tuple[float, float, float]:
    horizontal_unit = horizontal.axis_info[0].unit_conversion_factor
    if horizontal.is_geographic:
        horizontal_unit *= SEMI_MAJOR_AXIS
    return horizontal_unit, horizontal_unit, factor * source.axis_info[-1].unit_conversion_factor


def _ellipsoidal_system(horizontal: CRS, trajectory_datum: str) -> CRS:
    """Longitude, latitude and ellipsoidal height in the datum of the trajectory.

    Raises
    ------
    InputError
        If the datum cannot be determined or is not geographic.
    """
    if trajectory_datum:
        datum = _parse_system(trajectory_datum)
        if datum.is_geographic:
            return datum.to_3d()
        raise InputError(error("crs.not_geographic", datum=_shorten(trajectory_datum)))
    ellipsoid, own = horizontal.ellipsoid, horizontal.datum
    if ellipsoid is None or own is None:
        raise InputError(error("crs.no_datum", system=horizontal.name))
    polar = SEMI_MAJOR_AXIS * (1 - FLATTENING)
    if (
        abs(ellipsoid.semi_major_metre - SEMI_MAJOR_AXIS) > 0.001
        or abs(ellipsoid.semi_minor_metre - polar) > 0.001
    ):
        raise InputError(
            error("crs.other_ellipsoid", system=horizontal.name, ellipsoid=ellipsoid.name)
        )
    return GeographicCRS(name=own.name, datum=own).to_3d()


def geoid_grid(grid: Path) -> Transformer:
    """Conversion of heights above the geoid to ellipsoidal ones; longitude, latitude in degrees.

    Raises
    ------
    InputError
        If the grid does not exist or cannot be read.
    """
    if not grid.is_file():
        raise InputError(error("crs.geoid_not_found", file=str(grid)))
    if "," in str(grid) or '"' in str(grid):
        raise InputError(error("crs.geoid_path", file=str(grid)))
    try:  # pyproj converts degrees to radians for the shift, and back
        return Transformer.from_pipeline(
            f'+proj=vgridshift +grids="{grid.resolve()}" +multiplier=1'
        )
    except ProjError as reason:
        raise InputError(error("crs.geoid_unreadable", file=str(grid))) from reason


def run_in_blocks(run: Callable[[Array, Array, Array], Columns], *axes: Array) -> Columns:
    """Apply a function to blocks of three columns; returns three columns."""
    count = len(axes[0])
    if count <= BLOCK_POINTS:
        return run(*(np.ascontiguousarray(axis) for axis in axes))
    result = tuple(np.empty(count) for _ in range(3))

    def one(start: int) -> None:
        rows = slice(start, start + BLOCK_POINTS)
        for whole, block in zip(
            result, run(*(np.ascontiguousarray(axis[rows]) for axis in axes)), strict=True
        ):
            whole[rows] = block

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for _ in pool.map(one, range(0, count, BLOCK_POINTS)):
            pass
    return result[0], result[1], result[2]
