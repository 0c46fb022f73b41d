"""Tests of coordinate systems: known places, units, heights, headers and refusals."""

import struct
import time
from pathlib import Path

import laspy
import numpy as np
import pytest
from pyproj import CRS, Geod, Transformer

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame, geodetic_to_ecef
from lispac.io.las.las_chunks import LAS_FORMAT
from lispac.io.las.las_crs import read_header_crs
from lispac.io.point_reader_common import crs_of_options
from lispac.messages import note
from lispac.survey.crs import coordinate_system
from tests.support.error_codes import has_code
from tests.support.long_runs import others_long
from tests.support.message_codes import codes


def test_utm_points_and_the_same_points_in_ecef_agree(
    shared_data: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A real airborne file with the CRS of its header; both files are stored to 10 mm."""
    points, clouds = [], []
    for name in ("points.las", "points_ecef.las"):
        path = shared_data / "leeward" / name
        choice = LAS_FORMAT.preview(path, {}).choice
        system = crs_of_options(LAS_FORMAT.complete_options(choice))
        assert system is not None
        cloud = laspy.read(path).xyz
        clouds.append(cloud)
        points.append(system.to_ecef(cloud))
    apart = np.abs(points[0] - points[1])
    with capsys.disabled():
        print(f"\nUTM against ECEF, {len(apart):,} points: at most {1000 * apart.max():.3f} mm")
    assert apart.max() < 0.005
    np.testing.assert_allclose(points[1], clouds[1], rtol=0, atol=1e-6)  # no conversion is needed


@pytest.mark.parametrize("code", [32619, 32755, 2949, 2193, 3857, 4326, 4979, 4978, 2229])
def test_conversion_there_and_back_gives_the_same_coordinates(code: int) -> None:
    system = coordinate_system(f"EPSG:{code}")
    place = system.crs.area_of_use or CRS(4326).area_of_use
    latitude = np.radians((place.south + place.north) / 2 + np.linspace(-0.01, 0.01, 50))
    longitude = np.radians((place.west + place.east) / 2 + np.linspace(-0.01, 0.01, 50))
    height = np.linspace(-20, 40, 50)
    points = system.from_geodetic(latitude, longitude, height)
    back = system.to_geodetic(points)
    expected = geodetic_to_ecef(latitude, longitude, height)
    np.testing.assert_allclose(geodetic_to_ecef(*back), expected, atol=1e-6)
    off = (system.from_ecef(expected) - points) * np.array(system.metres)
    np.testing.assert_allclose(off, 0.0, atol=1e-6)


FOOT = 1200 / 3937


@pytest.mark.parametrize(
    ("text", "options", "metres"),
    [
        ("EPSG:32619", {}, (1.0, 1.0, 1.0)),
        ("EPSG:2229", {}, (FOOT, FOOT, FOOT)),
        ("EPSG:2229", {"height_unit": "metre"}, (FOOT, FOOT, 1.0)),
        ("EPSG:32619", {"height_unit": "foot"}, (1.0, 1.0, 0.3048)),
        ("EPSG:4979", {}, (111_319.4908, 111_319.4908, 1.0)),
        ("EPSG:4978", {}, (1.0, 1.0, 1.0)),
    ],
)
def test_the_units_of_a_system_in_metres(text: str, options: dict[str, str], metres) -> None:
    assert coordinate_system(text, **options).metres == pytest.approx(metres, rel=1e-9)


def test_grid_north_and_scale_are_applied() -> None:
    """100 m along the grid's east axis, 2.9 deg off the central meridian: turned and scaled."""
    system = coordinate_system("EPSG:32619")
    start = system.from_geodetic(
        np.radians(np.array([47.0])), np.radians(np.array([-66.1])), np.zeros(1)
    )[0]
    latitude, longitude, _ = system.to_geodetic(np.array([start, start + [100.0, 0, 0]]))
    azimuth, _, distance = Geod(ellps="WGS84").inv(
        *np.degrees([longitude[0], latitude[0], longitude[1], latitude[1]])
    )
    convergence = np.degrees(np.arctan(np.tan(np.radians(2.9)) * np.sin(np.radians(47.0))))
    assert azimuth - 90 == pytest.approx(convergence, abs=0.01)
    assert distance == pytest.approx(100 / 1.0002, abs=0.005)
    frame = LocalFrame(latitude[0], longitude[0], 0.0)
    local = system.to_local(np.array([start + [100.0, 0, 0]]), frame)[0]
    assert np.hypot(*local[:2]) == pytest.approx(distance, abs=1e-4)
    assert abs(local[0]) > 3  # the error of adding grid offsets instead


def test_local_frame_agrees_with_proj() -> None:
    system = coordinate_system("EPSG:2949")
    frame = LocalFrame(np.radians(46.8), np.radians(-71.2), 5.0)
    topocentric = Transformer.from_pipeline(
        "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad "
        "+step +proj=cart +ellps=WGS84 "
        "+step +proj=topocentric +ellps=WGS84 +lon_0=-71.2 +lat_0=46.8 +h_0=5"
    )
    longitude, latitude = np.array([-71.19, -71.21]), np.array([46.81, 46.79])
    height = np.array([20.0, -3.0])
    east, north, up = topocentric.transform(longitude, latitude, height)
    points = system.from_geodetic(np.radians(latitude), np.radians(longitude), height)
    np.testing.assert_allclose(
        system.to_local(points, frame), np.stack([north, -east, up], axis=1), atol=1e-4
    )
    np.testing.assert_allclose(system.from_local(system.to_local(points, frame), frame), points)


def test_systems_in_feet_and_metres_agree() -> None:
    metres = coordinate_system("EPSG:26945")  # California zone 5
    feet = coordinate_system("EPSG:2229")
    points = np.array([[1_900_000.0, 560_000.0, 30.0]])
    np.testing.assert_allclose(
        feet.to_ecef(points / (1200 / 3937)), metres.to_ecef(points), atol=1e-5
    )
    mixed = coordinate_system("EPSG:2229", height_unit="metre")
    only_horizontal = points / [1200 / 3937, 1200 / 3937, 1]
    np.testing.assert_allclose(mixed.to_ecef(only_horizontal), metres.to_ecef(points), atol=1e-5)
    unit = note("assumed.height_unit_as_horizontal", unit=note("unit.us_survey_feet"))
    assert unit in feet.assumptions


def geoid(path: Path, undulation: float) -> Path:
    """Write a constant geoid, 10 x 10 deg about Quebec, in the format of NOAA (GTX)."""
    head = struct.pack(">4d2i", 40.0, -80.0, 1.0, 1.0, 11, 11)
    path.write_bytes(head + np.full(121, undulation, ">f4").tobytes())
    return path


def test_heights_above_a_geoid_file(tmp_path: Path) -> None:
    grid = geoid(tmp_path / "my geoid.gtx", -27.5)
    system = coordinate_system("EPSG:2949", height=str(grid))
    plain = coordinate_system("EPSG:2949")
    point = plain.from_geodetic(
        np.radians(np.array([46.8])), np.radians(np.array([-71.2])), np.array([10.0])
    )
    _, _, height = system.to_geodetic(point)
    np.testing.assert_allclose(height, -17.5, rtol=0, atol=1e-6)
    np.testing.assert_allclose(system.from_geodetic(*system.to_geodetic(point)), point)
    assert "geoid" in system.height
    far = plain.from_geodetic(
        np.radians(np.array([55.0])), np.radians(np.array([-71.2])), np.zeros(1)
    )
    with pytest.raises(InputError, check=has_code("crs.points_outside")):
        system.to_geodetic(far)


@pytest.mark.parametrize(
    ("text", "options", "code"),
    others_long(
        [
            ("", {}, "crs.none_given"),
            ("EPSG:999999", {}, "crs.unknown"),
            ("nowhere", {}, "crs.unknown"),
            ('LOCAL_CS["site",UNIT["metre",1]]', {}, "crs.not_tied_to_earth"),
            ("EPSG:6347+5703", {}, "crs.grids_missing_geoid"),
            ("EPSG:2949", {"height": "6647"}, "crs.grid_missing_geoid"),
            ("EPSG:32619", {"height": "EPSG:32619"}, "crs.not_vertical"),
            ("EPSG:32619", {"height": "absent.gtx"}, "crs.geoid_not_found"),
            ("EPSG:32619", {"height_unit": "fathom"}, "crs.unknown_unit"),
            ("EPSG:27700", {}, "crs.other_ellipsoid"),
            ("EPSG:27700", {"trajectory_datum": "EPSG:4979"}, "crs.grids_missing"),
            ("EPSG:6347", {"trajectory_datum": "EPSG:7912"}, "crs.epoch_missing"),
            ("EPSG:6347", {"trajectory_datum": "EPSG:32618"}, "crs.not_geographic"),
        ]
    ),
)
def test_unusable_systems_are_refused(text: str, options: dict[str, str], code: str) -> None:
    with pytest.raises(InputError, check=has_code(code)) as refused:
        coordinate_system(text, **options)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("text", "datum", "grid"),
    [("EPSG:6347+5703", "", "us_noaa_g2018u0.tif"), ("EPSG:27700", "EPSG:4979", "OSTN15")],
)
def test_a_missing_grid_is_named(text: str, datum: str, grid: str) -> None:
    with pytest.raises(InputError) as refused:
        coordinate_system(text, trajectory_datum=datum)
    assert refused.value.message is not None
    assert grid in " ".join(refused.value.message.params["grids"])


def test_an_inconsistent_system_is_refused() -> None:
    wkt = CRS("EPSG:32619").to_wkt()
    damaged = wkt.replace('Mercator",ID["EPSG",9807]', 'Mercator"-ID["EPSG",9807]')
    assert damaged != wkt
    with pytest.raises(InputError, check=has_code("crs.unusable")):
        coordinate_system(damaged)


def test_datums_are_shifted_on_request_only() -> None:
    same = coordinate_system("EPSG:6347")
    shifted = coordinate_system("EPSG:6347", trajectory_datum="EPSG:7912", epoch=2024.5)
    point = np.array([[500_000.0, 4_500_000.0, 0.0]])
    apart = np.linalg.norm(same.to_ecef(point) - shifted.to_ecef(point))
    assert 1.0 < apart < 2.5  # NAD83 is about 2 m off the ITRF
    assert "assumed.datum" in codes(same.assumptions)


def test_points_outside_the_coordinate_system_are_refused() -> None:
    with pytest.raises(
        InputError,
        check=has_code("crs.points_outside", count=1, system="WGS 84 / UTM zone 19N (EPSG:32619)"),
    ):
        coordinate_system("EPSG:32619").to_geodetic(np.array([[1e9, 1e9, 0.0]]))


@pytest.mark.parametrize(
    ("version", "point_format", "keep"), [("1.2", 1, False), ("1.4", 6, True), ("1.4", 6, False)]
)
def test_the_system_of_a_las_header_is_read(
    tmp_path: Path, version: str, point_format: int, keep: bool
) -> None:
    """GeoTIFF keys and WKT as laspy writes them."""
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.add_crs(CRS("EPSG:2949"), keep_compatibility=keep)
    las = laspy.LasData(header)
    las.x = np.array([1.0])
    las.write(tmp_path / "a.las")
    with laspy.open(tmp_path / "a.las") as reader:
        header_crs = read_header_crs(reader.header)
    assert (header_crs.text, header_crs.file_warnings) == ("EPSG:2949", ())


def test_blocks_in_several_threads_give_the_same_coordinates(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Prints the times; checks that blocks in several threads give the result of one call."""
    system = coordinate_system("EPSG:32619")
    points = np.random.default_rng(0).uniform([3e5, 5e6, 0], [3.1e5, 5.01e6, 50], (1_000_000, 3))
    started = time.perf_counter()
    ecef = system.to_ecef(points)
    seconds = time.perf_counter() - started
    with capsys.disabled():
        print(f"\nUTM to ECEF, one million points: {seconds:.2f} s")
    np.testing.assert_array_equal(ecef[-1000:], system.to_ecef(points[-1000:]))
