"""Reading of the coordinate system in a LAS header: WKT or GeoTIFF keys.

If a header has both, a bit of the global encoding selects the one that applies (LAS 1.4 R15, 2.4).
laspy reads both, but from the keys only the codes of horizontal systems. It does not read heights,
units, earth-centred coordinates or systems that are named without a code (for example by PDAL).
"""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from pyproj import CRS
from pyproj.exceptions import CRSError

from lispac.io.point_reader_common import CHOOSE_SYSTEM_ACTION
from lispac.messages import Action, Level, Message, warning

if TYPE_CHECKING:
    from laspy import LasHeader
    from laspy.vlrs.known import GeoKeyDirectoryVlr

CHECK_SYSTEM_ACTION = Action("check_system", {"name": "crs"})
CHOOSE_VERTICAL_REFERENCE_ACTION = Action("choose_vertical_reference", {"name": "height"})
UNITS_BY_EPSG_CODE = {9001: "metre", 9002: "foot", 9003: "us-survey-foot"}
UNITS_BY_PROJ_NAME = {"metre": "metre", "foot": "foot", "US survey foot": "us-survey-foot"}
MODEL_KEY, CITATION_KEY, GEOGRAPHIC_KEY, GEOGRAPHIC_CITATION_KEY = 1024, 1026, 2048, 2049
PROJECTED_KEY, PROJECTED_CITATION_KEY, PROJECTION_KEY, LINEAR_UNIT_KEY = 3072, 3073, 3074, 3076
VERTICAL_KEY, VERTICAL_UNIT_KEY = 4096, 4099
GEOCENTRIC_MODEL = 3
UTM_PROJECTION_CODES = (16000, 16100)
"""GeoTIFF codes of UTM projections, north and south, to which the zone number is added."""


@dataclass(frozen=True)
class HeaderCrs:
    """Coordinate system specified in a LAS header.

    Attributes
    ----------
    text : str
        Argument of `lispac.survey.crs.coordinate_system`; empty if the header has no usable system.
    name, height_unit : str
        Name of the system and unit of its heights; empty if the header has no usable system.
    file_warnings : tuple of Message
        Warnings about a system that cannot be used, or is used with an assumption.
    messages : tuple of Message
        Warnings about WKT and keys that contradict each other.
    """

    text: str = ""
    name: str = ""
    height_unit: str = ""
    file_warnings: tuple[Message, ...] = ()
    messages: tuple[Message, ...] = ()

    @property
    def label(self) -> str:
        """Name of the system, with its code if it has one."""
        return f"{self.name} ({self.text})" if self.text.startswith("EPSG:") else self.name


def read_header_crs(header: "LasHeader", file: str = "") -> HeaderCrs:
    """Read the coordinate system of a LAS header.

    Parameters
    ----------
    header : laspy.LasHeader
    file : str
        Name of the file, for messages.
    """
    from laspy.vlrs.known import GeoKeyDirectoryVlr, WktCoordinateSystemVlr

    records = list(header.vlrs) + list(header.evlrs or ())
    by_wkt = by_keys = None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # PROJ's warnings about old WKT
        for record in records:
            if isinstance(record, WktCoordinateSystemVlr) and record.string.strip("\0 \n"):
                by_wkt = by_wkt or _crs_from_wkt(record.string.strip("\0 \n"), file)
            elif isinstance(record, GeoKeyDirectoryVlr) and record.geo_keys:
                by_keys = by_keys or _crs_from_keys(*_geotiff_keys(record, records), file)
        if by_wkt is None or by_keys is None:
            return by_wkt or by_keys or HeaderCrs()
        pair = (by_wkt, by_keys) if header.global_encoding.wkt else (by_keys, by_wkt)
        return _reconcile_systems(*pair, file)


def _reconcile_systems(used: HeaderCrs, other: HeaderCrs, file: str) -> HeaderCrs:
    """System to use, with a warning if the other one in the header contradicts it.

    The other one is used if the first is not usable, or is the same without heights.
    """
    if not other.text:
        return used
    if not used.text:
        note = Message("file.unusable_system", Level.NOTE, {"file": file, "system": other.label})
        return replace(other, messages=(note,))
    place, heights = _horizontal_and_vertical(used.text)
    other_place, other_heights = _horizontal_and_vertical(other.text)
    if place.equals(other_place, ignore_axis_order=True):
        if heights is None and other_heights is not None:
            return other
        if heights is None or other_heights is None or heights == other_heights:
            return used
    conflict = Message(
        "file.two_systems", Level.WARNING,
        {"file": file, "used": used.label, "other": other.label},
        actions=(Action("set_option", {"name": "crs", "value": other.text}),),
    )  # fmt: skip
    return replace(used, messages=(conflict,))


def _horizontal_and_vertical(text: str) -> tuple[CRS, CRS | None]:
    """Horizontal (or complete earth-centred) system, and the vertical system or None."""
    crs = CRS.from_user_input(text)
    crs = crs.source_crs if crs.is_bound and crs.source_crs is not None else crs
    parts = crs.sub_crs_list if crs.is_compound else [crs]
    place = parts[0].source_crs if parts[0].is_bound and parts[0].source_crs else parts[0]
    if place.is_geocentric:
        return place, None
    return place.to_2d(), parts[1] if len(parts) > 1 else None


def _crs_from_wkt(wkt: str, file: str) -> HeaderCrs:
    crs = _parse_crs(wkt)
    if crs is None:
        return HeaderCrs(
            file_warnings=(warning("las.unknown_wkt", file=file, actions=(CHOOSE_SYSTEM_ACTION,)),)
        )
    code = crs.to_epsg()
    return HeaderCrs(f"EPSG:{code}" if code and CRS(code) == crs else wkt, crs.name)


def _geotiff_keys(
    directory: "GeoKeyDirectoryVlr", records: list[Any]
) -> tuple[Mapping[int, int], Mapping[int, str]]:
    """Read the GeoTIFF keys with numbers and those with texts."""
    from laspy.vlrs.known import GeoAsciiParamsVlr

    ascii_text = "".join(
        "\0".join(record.strings) for record in records if isinstance(record, GeoAsciiParamsVlr)
    )
    numbers: dict[int, int] = {}
    texts: dict[int, str] = {}
    for key in directory.geo_keys:
        if key.tiff_tag_location == 0:
            numbers[key.id] = key.value_offset
        elif key.tiff_tag_location == 34737:
            text = ascii_text[key.value_offset : key.value_offset + key.count]
            texts[key.id] = text.strip("|\0 ")
    return numbers, texts


def _crs_from_keys(numbers: Mapping[int, int], texts: Mapping[int, str], file: str) -> HeaderCrs:
    file_warnings: list[Message] = []
    crs: CRS | None = None
    if numbers.get(MODEL_KEY) == GEOCENTRIC_MODEL:
        crs = _geocentric_crs(numbers.get(GEOGRAPHIC_KEY, 0))
    else:
        crs = _crs_by_epsg(numbers.get(PROJECTED_KEY, 0))
        if crs is None and PROJECTED_KEY not in numbers:
            crs = _crs_by_epsg(numbers.get(GEOGRAPHIC_KEY, 0))
    if crs is None:
        crs = _crs_by_citation(numbers, texts)
        if crs is not None:
            file_warnings.append(
                warning(
                    "las.system_by_name", file=file, name=crs.name,
                    system=f"EPSG:{crs.to_epsg()}", actions=(CHECK_SYSTEM_ACTION,),
                )
            )  # fmt: skip
    if crs is None:
        name, actions = (
            texts.get(PROJECTED_CITATION_KEY) or texts.get(CITATION_KEY),
            (CHOOSE_SYSTEM_ACTION,),
        )
        if name:
            unknown = warning("las.system_without_code", file=file, name=name, actions=actions)
        else:
            unknown = warning("las.system_not_named", file=file, actions=actions)
        return HeaderCrs(file_warnings=(unknown,))
    unit = UNITS_BY_EPSG_CODE.get(numbers.get(LINEAR_UNIT_KEY, 0), "")
    axis_unit = UNITS_BY_PROJ_NAME.get(crs.axis_info[0].unit_name, "")
    if unit and axis_unit and unit != axis_unit:
        file_warnings.append(
            warning(
                "las.unit_contradicts_system", file=file, unit=unit, system=crs.name,
                system_unit=axis_unit, actions=(CHOOSE_SYSTEM_ACTION,),
            )
        )  # fmt: skip
        return HeaderCrs(file_warnings=tuple(file_warnings))
    text = f"EPSG:{crs.to_epsg()}"
    name = crs.name
    vertical = numbers.get(VERTICAL_KEY, 0)
    if 5001 <= vertical <= 5033:
        pass  # GeoTIFF codes for heights above an ellipsoid
    elif vertical and (heights := _crs_by_epsg(vertical)) is not None and heights.is_vertical:
        text, name = f"{text}+{vertical}", f"{name} + {heights.name}"
    elif 0 < vertical < 32767:
        file_warnings.append(
            warning(
                "las.unknown_vertical", file=file, code=str(vertical),
                actions=(CHOOSE_VERTICAL_REFERENCE_ACTION,),
            )
        )  # fmt: skip
    height_unit = UNITS_BY_EPSG_CODE.get(numbers.get(VERTICAL_UNIT_KEY, 0), "")
    return HeaderCrs(text, name, height_unit, tuple(file_warnings))


def _geocentric_crs(code: int) -> CRS | None:
    crs = _crs_by_epsg(code)
    if crs is None or crs.is_geocentric:
        return crs
    # Programs write the code of the geographic system with the same datum.
    return CRS.from_epsg(4978) if code in (4326, 4979) else None


def _crs_by_citation(numbers: Mapping[int, int], texts: Mapping[int, str]) -> CRS | None:
    for key in (PROJECTED_CITATION_KEY, CITATION_KEY, GEOGRAPHIC_CITATION_KEY):
        name = texts.get(key, "").split("|")[0].strip()
        crs = _parse_crs(name) if name else None
        # PROJ also finds similar names; only an exact match is accepted.
        if crs is None or crs.name != name or crs.to_epsg() is None:
            continue
        if crs.is_projected and crs.utm_zone is not None:
            base = UTM_PROJECTION_CODES[crs.utm_zone.endswith("S")]
            projection = numbers.get(PROJECTION_KEY, 32767)
            if projection not in (32767, base + int(crs.utm_zone[:-1])):
                continue
        return crs
    return None


def _crs_by_epsg(code: int) -> CRS | None:
    return _parse_crs(f"EPSG:{code}") if 1024 <= code <= 32766 else None


def _parse_crs(text: str) -> CRS | None:
    try:
        return CRS.from_user_input(text)
    except CRSError:
        return None
