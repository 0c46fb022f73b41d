"""Tests of LAS headers with both WKT and GeoTIFF keys: the used system and contradictions."""

from pathlib import Path

import laspy
import pytest
from laspy.vlrs.known import GeoKeyDirectoryVlr, GeoKeyEntryStruct, WktCoordinateSystemVlr
from pyproj import CRS

from lispac.io.formats import format_of
from lispac.io.las.las_crs import HeaderCrs, read_header_crs
from lispac.io.las.las_crs_writer import write_crs
from lispac.io.points.static_scan import open_static_scan
from lispac.messages import Level
from tests.support import point_files as files

LAS = format_of("las")
ZONE_18, ZONE_19, MTM = "EPSG:32618", "EPSG:32619", "EPSG:2949"
UNUSABLE_CODE = 32767


def header_of(
    wkt: str, keys: dict[int, int] | None, *, bit: bool, point_format: int = 6
) -> laspy.LasHeader:
    """A header with the WKT of a system, GeoTIFF keys and the WKT bit."""
    header = laspy.LasHeader(point_format=point_format, version="1.4")
    header.vlrs.clear()
    if wkt:
        header.vlrs.append(WktCoordinateSystemVlr(CRS(wkt).to_wkt("WKT1_GDAL")))
    if keys is not None:
        directory = GeoKeyDirectoryVlr()
        directory.geo_keys = [GeoKeyEntryStruct(key, 0, 1, value) for key, value in keys.items()]
        directory.geo_keys_header.number_of_keys = len(keys)
        header.vlrs.append(directory)
    header.global_encoding.wkt = bit
    return header


def projected(code: int, **more: int) -> dict[int, int]:
    return {1024: 1, 3072: code} | ({4096: more["heights"]} if more else {})


def codes(found: HeaderCrs) -> list[tuple[str, Level]]:
    return [(message.code, message.level) for message in found.messages]


@pytest.mark.parametrize("point_format", [1, 6])
@pytest.mark.parametrize(
    ("bit", "used", "other"), [(True, ZONE_18, ZONE_19), (False, ZONE_19, ZONE_18)]
)
def test_the_bit_decides_between_two_systems(
    bit: bool, used: str, other: str, point_format: int
) -> None:
    header = header_of(ZONE_18, projected(32619), bit=bit, point_format=point_format)
    found = read_header_crs(header, "a.las")
    assert found.text == used
    assert codes(found) == [("file.two_systems", Level.WARNING)]
    (message,) = found.messages
    assert used in str(message.params["used"])
    assert other in str(message.params["other"])
    assert message.params["file"] == "a.las"
    (action,) = message.actions
    assert (action.code, dict(action.params)) == ("set_option", {"name": "crs", "value": other})


@pytest.mark.parametrize("bit", [True, False])
@pytest.mark.parametrize(
    ("wkt", "keys", "text"),
    [
        (ZONE_19, None, ZONE_19),
        ("", projected(32619), ZONE_19),
        (ZONE_19, projected(32619), ZONE_19),
        (ZONE_19, {}, ZONE_19),
        (f"{MTM}+6647", projected(2949, heights=6647), f"{MTM}+6647"),
        # The same horizontal system, with heights in only one of the two
        (f"{MTM}+6647", projected(2949), f"{MTM}+6647"),
        (MTM, projected(2949, heights=6647), f"{MTM}+6647"),
    ],
)
def test_a_single_system_is_read_with_either_bit(
    wkt: str, keys: dict[int, int] | None, text: str, bit: bool
) -> None:
    found = read_header_crs(header_of(wkt, keys, bit=bit))
    assert CRS(found.text) == CRS(text)
    assert (codes(found), found.file_warnings) == ([], ())


@pytest.mark.parametrize("bit", [True, False])
def test_two_systems_of_heights_are_a_contradiction(bit: bool) -> None:
    found = read_header_crs(header_of(f"{MTM}+6647", projected(2949, heights=5713), bit=bit))
    assert CRS(found.text) == CRS(f"{MTM}+6647" if bit else f"{MTM}+5713")
    assert codes(found) == [("file.two_systems", Level.WARNING)]


def test_systems_with_different_datums_are_different() -> None:
    """NAD83 and WGS 84 in the same zone."""
    found = read_header_crs(header_of("EPSG:26919", projected(32619), bit=True))
    assert (found.text, codes(found)) == ("EPSG:26919", [("file.two_systems", Level.WARNING)])


def test_the_other_system_is_used_if_one_is_unusable() -> None:
    found = read_header_crs(header_of(ZONE_19, projected(UNUSABLE_CODE), bit=False), "a.las")
    assert (found.text, found.file_warnings) == (ZONE_19, ())
    assert codes(found) == [("file.unusable_system", Level.NOTE)]
    header = header_of("", projected(32619), bit=True)
    header.vlrs.append(WktCoordinateSystemVlr("LOCAL_CS[nothing"))
    found = read_header_crs(header, "a.las")
    assert (found.text, found.file_warnings) == (ZONE_19, ())
    assert codes(found) == [("file.unusable_system", Level.NOTE)]


def conflicting(path: Path) -> Path:
    """Write a file whose keys apply; its WKT is another zone."""
    data = laspy.read(files.las(path, 7, "1.4"))
    data.header.vlrs.extend(header_of(ZONE_18, projected(32619), bit=False).vlrs)
    data.header.global_encoding.wkt = False
    data.write(path)
    return path


@pytest.mark.parametrize("ending", ["las", "laz"])
def test_the_preview_of_a_line_reports_the_contradiction(tmp_path: Path, ending: str) -> None:
    path = conflicting(tmp_path / f"a.{ending}")
    found = LAS.preview(path, {})
    assert found.choice["crs"] == ZONE_19
    assert [message.code for message in found.messages] == ["file.two_systems"]
    with_option = LAS.preview(path, {"crs": ZONE_18})
    assert [message.code for message in with_option.messages] == []
    for choice, preview in (({}, found), ({"crs": ZONE_18}, with_option)):
        assert LAS.messages(path, choice) == preview.messages


def test_a_reference_reports_the_contradiction(tmp_path: Path) -> None:
    found = open_static_scan(conflicting(tmp_path / "a.las"))
    assert found.system == ZONE_19
    assert [message.code for message in found.messages] == ["file.two_systems"]


@pytest.mark.parametrize(
    "system", [ZONE_19, f"{MTM}+6647", "EPSG:2229+6360", "EPSG:4326", "EPSG:4978"]
)
@pytest.mark.parametrize(
    ("point_format", "version"), [(1, "1.2"), (3, "1.4"), (6, "1.4"), (7, "1.4")]
)
def test_written_systems_do_not_contradict_each_other(
    system: str, point_format: int, version: str
) -> None:
    """Also if the template of the file had another system."""
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.vlrs.extend(header_of(ZONE_18, projected(32618), bit=True).vlrs)
    write_crs(header, CRS(system))
    found = read_header_crs(header)
    assert CRS(found.text) == CRS(system)
    assert (codes(found), found.file_warnings) == ([], ())
    has_keys = bool(header.vlrs.get("GeoKeyDirectoryVlr"))
    assert header.global_encoding.wkt != has_keys
