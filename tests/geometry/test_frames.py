"""Tests of geodetic and local coordinates against PROJ."""

import numpy as np
import pyproj
import pytest

from lispac.geometry.frames import LocalFrame, ecef_to_geodetic, geodetic_to_ecef

PLACES = np.radians([[45.5, -73.5], [-33.9, 151.2], [0.0, 0.0], [78.2, 15.6], [-89.0, -179.9]])


@pytest.mark.parametrize("height", [-50.0, 0.0, 6991.6, 2e6])
def test_earth_centred_coordinates_agree_with_proj(height: float) -> None:
    to_ecef = pyproj.Transformer.from_crs("EPSG:4979", "EPSG:4978")
    latitude, longitude = PLACES.T
    heights = np.full(len(PLACES), height)
    expected = np.stack(to_ecef.transform(*np.degrees(PLACES.T), heights), axis=1)
    ecef = geodetic_to_ecef(latitude, longitude, heights)
    np.testing.assert_allclose(ecef, expected, rtol=0, atol=2e-9)
    back = np.stack(ecef_to_geodetic(ecef), axis=1)
    np.testing.assert_allclose(back[:, :2], PLACES, rtol=0, atol=1e-13)
    np.testing.assert_allclose(back[:, 2], heights, rtol=0, atol=1e-8)


def test_local_axes_are_north_west_up() -> None:
    frame = LocalFrame(np.radians(45.5), np.radians(-73.5), 20.0)
    step = 1e-6
    moved = frame.to_local(
        np.array([frame.latitude + step, frame.latitude, frame.latitude]),
        np.array([frame.longitude, frame.longitude - step, frame.longitude]),
        np.array([20.0, 20.0, 26.0]),
    )
    assert np.argmax(moved, axis=1).tolist() == [0, 1, 2]
    np.testing.assert_allclose(moved[2], [0, 0, 6], atol=1e-8)


def test_local_coordinates_agree_with_proj_topocentric() -> None:
    frame = LocalFrame(np.radians(45.5), np.radians(-73.5), 20.0)
    latitude = frame.latitude + np.linspace(-1e-3, 1e-3, 5)
    longitude = frame.longitude + np.linspace(1e-3, -2e-3, 5)
    height = np.linspace(0, 90, 5)
    pipeline = pyproj.Transformer.from_pipeline(
        "+proj=pipeline +step +proj=cart +ellps=WGS84 "
        "+step +proj=topocentric +ellps=WGS84 +lon_0=-73.5 +lat_0=45.5 +h_0=20"
    )
    east, north, up = pipeline.transform(longitude, latitude, height, radians=True)
    local = frame.to_local(latitude, longitude, height)
    np.testing.assert_allclose(local, np.stack([north, -east, up], axis=1), rtol=0, atol=1e-8)
    back = np.stack(frame.to_geodetic(local), axis=1)
    expected = np.stack([latitude, longitude, height], axis=1)
    np.testing.assert_allclose(back[:, :2], expected[:, :2], rtol=0, atol=1e-14)
    np.testing.assert_allclose(back[:, 2], expected[:, 2], rtol=0, atol=1e-8)


def test_level_north_rotates_with_the_meridian() -> None:
    frame = LocalFrame(np.radians(45.0), 0.0, 0.0)
    east = np.array([1000 / (6378137 * np.cos(np.radians(45)))])
    rotation = frame.rotation_local_level(np.array([frame.latitude]), east)[0]
    north_at_vessel = rotation @ [1, 0, 0]
    convergence = np.degrees(np.arctan2(north_at_vessel[1], north_at_vessel[0]))
    assert convergence == pytest.approx(np.degrees(east[0]) * np.sin(frame.latitude), rel=1e-3)
    assert 0.008 < convergence < 0.010
