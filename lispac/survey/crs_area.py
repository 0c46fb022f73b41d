"""Area of use of a coordinate system."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pyproj import CRS

AREA_MARGIN_DEG = 3.0
"""Tolerance in degrees around the area of use of a coordinate system: half a UTM zone."""


def area_of_use_elsewhere(crs: "CRS", latitude_deg: float, longitude_deg: float) -> str:
    """Area of use of a system if a place is far outside; empty otherwise."""
    area = crs.area_of_use
    if area is None:
        return ""
    width = (area.east - area.west) % 360 or 360.0
    inside = (longitude_deg - area.west + AREA_MARGIN_DEG) % 360 <= width + 2 * AREA_MARGIN_DEG
    if inside and area.south - AREA_MARGIN_DEG <= latitude_deg <= area.north + AREA_MARGIN_DEG:
        return ""
    return str(area.name.split(".")[0])
