"""Writing a coordinate system into a LAS header.

WKT version 1 is written if it can express the system: the LAS specification requires it, and much
software reads no other version. Point formats before 6 require GeoTIFF keys. They are made here
because laspy writes keys without heights and units.
"""

import warnings
from typing import TYPE_CHECKING

from pyproj import CRS
from pyproj.exceptions import CRSError

from lispac.io.las.las_crs import (
    GEOCENTRIC_MODEL,
    GEOGRAPHIC_CITATION_KEY,
    GEOGRAPHIC_KEY,
    MODEL_KEY,
    PROJECTED_CITATION_KEY,
    PROJECTED_KEY,
    UNITS_BY_EPSG_CODE,
    UNITS_BY_PROJ_NAME,
    VERTICAL_KEY,
    VERTICAL_UNIT_KEY,
)

if TYPE_CHECKING:
    import laspy

VALUE_IN_KEY, VALUE_IN_TEXTS = 0, 34737
"""Location of a key's value: in the key itself, or among the texts."""
PROJECTED_MODEL, GEOGRAPHIC_MODEL = 1, 2
CRS_RECORD_NAMES = ("WktCoordinateSystemVlr", "WktMathTransformVlr", "GeoKeyDirectoryVlr",
           "GeoAsciiParamsVlr", "GeoDoubleParamsVlr")  # fmt: skip
OWN_USER_ID, LOCAL_FRAME_RECORD_ID = "LISPAC", 1
"""User and record ID of the record that marks a cloud in the local frame of a project."""


def is_in_local_frame(header: "laspy.LasHeader") -> bool:
    """True if a cloud was written in the local frame of a project."""
    return any(
        each.user_id == OWN_USER_ID and each.record_id == LOCAL_FRAME_RECORD_ID
        for each in header.vlrs
    )


def write_crs(header: "laspy.LasHeader", crs: CRS | None) -> None:
    """Write a coordinate system (None for the local frame) into a header, replacing any other.

    If the version of the header allows neither WKT nor keys for the system, it is changed to 1.4.
    """
    import laspy
    from laspy.vlrs.known import (
        GeoAsciiParamsVlr,
        GeoKeyDirectoryVlr,
        GeoKeyEntryStruct,
        WktCoordinateSystemVlr,
    )

    for name in CRS_RECORD_NAMES:
        header.vlrs.extract(name)
        if header.evlrs is not None:
            header.evlrs.extract(name)
    header.vlrs[:] = [each for each in header.vlrs if each.user_id != OWN_USER_ID]
    header.global_encoding.wkt = header.point_format.id >= 6
    if crs is None:
        return
    header.vlrs.append(WktCoordinateSystemVlr(_crs_wkt(crs)))
    if header.point_format.id >= 6:
        return
    numbers, text = _geotiff_keys(crs)
    if not numbers:
        header.version = laspy.header.Version(1, 4)
        header.global_encoding.wkt = True
        return
    directory = GeoKeyDirectoryVlr()
    citation = PROJECTED_CITATION_KEY if PROJECTED_KEY in numbers else GEOGRAPHIC_CITATION_KEY
    keys = [GeoKeyEntryStruct(key, VALUE_IN_KEY, 1, value) for key, value in numbers.items()]
    keys.append(GeoKeyEntryStruct(citation, VALUE_IN_TEXTS, len(text), 0))
    directory.geo_keys = sorted(keys, key=lambda key: key.id)
    directory.geo_keys_header.number_of_keys = len(keys)
    texts = GeoAsciiParamsVlr()
    texts.strings = [text]
    header.vlrs.extend([directory, texts])


def _crs_wkt(crs: CRS) -> str:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # PROJ's warnings about omissions in version 1
        try:
            wkt = crs.to_wkt("WKT1_GDAL")
            same = CRS.from_wkt(wkt)
        except CRSError:
            return str(crs.to_wkt())
    # WKT version 1 omits a third axis, and the system then differs.
    return str(wkt) if len(same.axis_info) == len(crs.axis_info) else str(crs.to_wkt())


def _geotiff_keys(crs: CRS) -> tuple[dict[int, int], str]:
    """GeoTIFF keys with numbers, and the citation; no keys if a part of the system has no code."""
    parts = crs.sub_crs_list if crs.is_compound else [crs]
    horizontal = parts[0]
    if horizontal.is_geocentric:
        model, key, code = GEOCENTRIC_MODEL, GEOGRAPHIC_KEY, horizontal.to_epsg()
    elif horizontal.is_geographic:
        model, key, code = GEOGRAPHIC_MODEL, GEOGRAPHIC_KEY, horizontal.to_2d().to_epsg()
    else:
        model, key, code = PROJECTED_MODEL, PROJECTED_KEY, horizontal.to_epsg()
    if not code or code > 32766:
        return {}, ""
    numbers = {MODEL_KEY: model, key: code}
    if len(parts) > 1:
        heights = parts[1].to_epsg()
        if not heights or heights > 32766:
            return {}, ""
        numbers[VERTICAL_KEY] = heights
        unit = UNITS_BY_PROJ_NAME.get(parts[1].axis_info[0].unit_name, "")
        known = {name: code for code, name in UNITS_BY_EPSG_CODE.items()}
        if unit:
            numbers[VERTICAL_UNIT_KEY] = known[unit]
    text = str(crs.name).encode("ascii", "replace").decode() + "|"
    return numbers, text
