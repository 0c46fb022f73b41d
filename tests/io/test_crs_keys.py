"""Tests of coordinate systems given by GeoTIFF keys in LAS headers."""

import laspy
import pytest
from laspy.vlrs.known import GeoAsciiParamsVlr, GeoKeyDirectoryVlr, GeoKeyEntryStruct
from pyproj import CRS

from lispac.io.las.las_crs import HeaderCrs, read_header_crs
from lispac.io.las.las_crs_writer import write_crs
from tests.support.message_codes import codes

MODEL, CITATION, GEOGRAPHIC, PROJECTED, PROJECTED_CITATION = 1024, 1026, 2048, 3072, 3073
PROJECTION, LINEAR_UNIT, VERTICAL, VERTICAL_UNIT = 3074, 3076, 4096, 4099
"""Numbers of GeoTIFF keys (OGC 19-008)."""
UTM = {MODEL: 1, PROJECTED: 32619}


def header_crs(numbers: dict[int, int], texts: dict[int, str] | None = None) -> HeaderCrs:
    """Coordinate system of a header with these keys."""
    header = laspy.LasHeader(point_format=1, version="1.2")
    directory, ascii_texts = GeoKeyDirectoryVlr(), GeoAsciiParamsVlr()
    keys = [GeoKeyEntryStruct(key, 0, 1, value) for key, value in numbers.items()]
    joined = ""
    for key, text in (texts or {}).items():
        keys.append(GeoKeyEntryStruct(key, 34737, len(text) + 1, len(joined)))
        joined += f"{text}|"
    directory.geo_keys = sorted(keys, key=lambda key: key.id)
    ascii_texts.strings = [joined]
    header.vlrs.extend([directory, ascii_texts])
    return read_header_crs(header, "a.las")


def test_a_contradictory_unit_key_leaves_the_system_unknown() -> None:
    """California zone 5 in US survey feet, with a key for metres."""
    name = CRS(2229).name
    assert header_crs({MODEL: 1, PROJECTED: 2229, LINEAR_UNIT: 9003}).text == "EPSG:2229"
    found = header_crs({MODEL: 1, PROJECTED: 2229, LINEAR_UNIT: 9001})
    assert (found.text, found.name) == ("", "")
    (message,) = found.file_warnings
    assert message.code == "las.unit_contradicts_system"
    assert message.params == {
        "file": "a.las", "unit": "metre", "system": name, "system_unit": "us-survey-foot",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("heights", "text", "unknown"),
    [
        (0, "EPSG:32619", ()),
        (5030, "EPSG:32619", ()),  # above the ellipsoid of WGS 84
        (6647, "EPSG:32619+6647", ()),
        (32767, "EPSG:32619", ()),  # user-defined
        (1234, "EPSG:32619", ("1234",)),
        (4326, "EPSG:32619", ("4326",)),
    ],
)
def test_heights_are_read_from_the_keys(heights: int, text: str, unknown: tuple[str, ...]) -> None:
    found = header_crs(UTM | ({VERTICAL: heights} if heights else {}))
    assert found.text == text
    assert codes(found.file_warnings) == ["las.unknown_vertical"] * len(unknown)
    assert tuple(each.params["code"] for each in found.file_warnings) == unknown
    assert found.name == CRS(text).name


def test_the_height_unit_has_a_separate_key() -> None:
    assert header_crs(UTM | {VERTICAL: 6360, VERTICAL_UNIT: 9003}).height_unit == "us-survey-foot"
    assert header_crs(UTM | {VERTICAL_UNIT: 9999}).height_unit == ""


@pytest.mark.parametrize(("code", "text"), [(4978, "EPSG:4978"), (4326, "EPSG:4978")])
def test_earth_centred_coordinates(code: int, text: str) -> None:
    """The code is that of the geocentric system or of the geographic system of its datum."""
    assert header_crs({MODEL: 3, GEOGRAPHIC: code}).text == text


@pytest.mark.parametrize("code", [4269, 1025])
def test_earth_centred_coordinates_of_another_datum_are_not_guessed(code: int) -> None:
    found = header_crs({MODEL: 3, GEOGRAPHIC: code})
    assert found.text == ""
    assert codes(found.file_warnings) == ["las.system_not_named"]


@pytest.mark.parametrize(
    ("name", "code", "projection"),
    [
        ("NAD83(CSRS) / MTM zone 7", 2949, None),
        ("WGS 84 / UTM zone 19N", 32619, None),
        ("WGS 84 / UTM zone 19N", 32619, 16019),
        ("WGS 84 / UTM zone 19S", 32719, 16119),
        ("WGS 84 / UTM zone 19N", None, 16018),
        ("WGS 84 / UTM zone 19S", None, 16019),
        ("Utm 19", None, None),
    ],
)
def test_a_system_is_found_by_its_name(name: str, code: int | None, projection: int | None) -> None:
    """The name is used if it is exactly an EPSG name and the projection is of the same zone."""
    numbers = {MODEL: 1, PROJECTED: 32767}
    found = header_crs(
        numbers | ({PROJECTION: projection} if projection else {}), {PROJECTED_CITATION: name}
    )
    assert found.text == ("" if code is None else f"EPSG:{code}")
    (message,) = found.file_warnings
    assert message.params["name"] == name
    if code is None:
        assert message.code == "las.system_without_code"
    else:
        assert (message.code, message.params["system"]) == ("las.system_by_name", f"EPSG:{code}")


@pytest.mark.parametrize(
    ("system", "unit"),
    [("EPSG:2949+6647", "metre"), ("EPSG:2229+6360", "us-survey-foot"), ("EPSG:2157+5754", "")],
)
def test_written_keys_can_be_read_back(system: str, unit: str) -> None:
    """The feet of the heights above Poolbeg, EPSG:5754, have no key: the code implies them."""
    header = laspy.LasHeader(point_format=1, version="1.2")
    write_crs(header, CRS(system))
    header.vlrs.extract("WktCoordinateSystemVlr")
    found = read_header_crs(header)
    assert (found.text, found.height_unit, found.file_warnings) == (system, unit, ())
    assert str(header.version) == "1.2"


def test_heights_without_a_code_are_written_as_wkt_alone() -> None:
    """The version is 1.4, which allows WKT with any point format."""
    wkt = CRS("EPSG:2949+6647").to_wkt("WKT1_GDAL")
    own = wkt.replace("CGVD2013(CGG2013) height", "tide gauge").replace("CGVD2013", "gauge")
    start = own.index("VERT_CS")
    own = own[:start] + own[start:].replace(',AUTHORITY["EPSG","6647"]', "").replace(
        ',AUTHORITY["EPSG","1127"]', ""
    )
    system = CRS(own)
    assert system.sub_crs_list[1].to_epsg() is None
    header = laspy.LasHeader(point_format=1, version="1.2")
    write_crs(header, system)
    assert str(header.version) == "1.4"
    assert not header.vlrs.get("GeoKeyDirectoryVlr")
    assert "gauge" in read_header_crs(header).name
