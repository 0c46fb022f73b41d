"""Geoid grids of the user's own, by PROJ."""

from pathlib import Path

from pyproj import Transformer
from pyproj.exceptions import ProjError

from lispac.errors import InputError


def geoid_grid(grid: Path) -> Transformer:
    """From heights above the geoid to those above the ellipsoid; longitude, latitude in degrees.

    Raises
    ------
    InputError
        Where there is no such grid, or it cannot be read.
    """
    if not grid.is_file():
        raise InputError(f"{grid}: there is no such geoid grid; check the path.")
    if "," in str(grid) or '"' in str(grid):
        raise InputError(f"{grid}: PROJ takes no commas or quotes in a path; rename the grid.")
    try:  # pyproj turns degrees into the radians of the shift, and back
        return Transformer.from_pipeline(
            f'+proj=vgridshift +grids="{grid.resolve()}" +multiplier=1'
        )
    except ProjError as error:
        raise InputError(
            f"{grid}: cannot be read as a geoid grid; give a .gtx or GeoTIFF grid of PROJ."
        ) from error
