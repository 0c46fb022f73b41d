"""Geoid grids of the user's own, by PROJ."""

from pathlib import Path

from pyproj import Transformer
from pyproj.exceptions import ProjError

from lispac.errors import InputError
from lispac.messages import error


def geoid_grid(grid: Path) -> Transformer:
    """Grid from heights above the geoid to ellipsoidal heights; longitude, latitude in degrees.

    Raises
    ------
    InputError
        Where there is no such grid, or it cannot be read.
    """
    if not grid.is_file():
        raise InputError(error("crs.geoid_not_found", file=str(grid)))
    if "," in str(grid) or '"' in str(grid):
        raise InputError(error("crs.geoid_path", file=str(grid)))
    try:  # pyproj turns degrees into the radians of the shift, and back
        return Transformer.from_pipeline(
            f'+proj=vgridshift +grids="{grid.resolve()}" +multiplier=1'
        )
    except ProjError as reason:
        raise InputError(error("crs.geoid_unreadable", file=str(grid))) from reason
