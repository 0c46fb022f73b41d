"""The local frame: North, West, Up at one origin (thesis equations 1.2-1.5 and B.1-B.3)."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

SEMI_MAJOR_AXIS = 6378137.0  # WGS84, metres
FLATTENING = 1 / 298.257223563
ECCENTRICITY_SQUARED = FLATTENING * (2 - FLATTENING)


def east_north_up(points_local: ArrayLike) -> Array:
    """Convert coordinates in the local frame to east, north, up, as all positions are shown.

    Parameters
    ----------
    points_local : array_like of shape (..., 3), metres, local frame

    Returns
    -------
    ndarray of shape (..., 3), metres, axes of the local frame east, north, up
    """
    north, west, up = np.moveaxis(np.asarray(points_local, dtype=float), -1, 0)
    return np.stack([0.0 - west, north, up], axis=-1)  # 0.0 - 0.0 has no sign, unlike -0.0


def north_west_up(points: ArrayLike) -> Array:
    """Convert east, north, up, as positions are shown, to coordinates in the local frame.

    Parameters
    ----------
    points : array_like of shape (..., 3), metres

    Returns
    -------
    ndarray of shape (..., 3), metres, local frame
    """
    east, north, up = np.moveaxis(np.asarray(points, dtype=float), -1, 0)
    return np.stack([north, 0.0 - east, up], axis=-1)


def geodetic_to_ecef(latitude: Array, longitude: Array, height: Array) -> Array:
    """Convert geodetic to earth-centred coordinates (thesis equation B.2).

    Parameters
    ----------
    latitude, longitude : ndarray of shape (...), radians
    height : ndarray of shape (...), metres above the ellipsoid

    Returns
    -------
    ndarray of shape (..., 3), metres, earth-centred
    """
    sin, cos = np.sin(latitude), np.cos(latitude)
    prime_vertical = SEMI_MAJOR_AXIS / np.sqrt(1 - ECCENTRICITY_SQUARED * sin**2)
    return np.stack(
        [
            (prime_vertical + height) * cos * np.cos(longitude),
            (prime_vertical + height) * cos * np.sin(longitude),
            (prime_vertical * (1 - ECCENTRICITY_SQUARED) + height) * sin,
        ],
        axis=-1,
    )


def ecef_to_geodetic(ecef: Array) -> tuple[Array, Array, Array]:
    """Latitude, longitude (radians) and height (metres) of earth-centred coordinates.

    The latitude is iterated until it changes by less than 1e-14 rad, which takes four or five
    iterations near the surface of the earth (Hofmann-Wellenhof, GNSS, 8.2).

    Parameters
    ----------
    ecef : ndarray of shape (..., 3), metres, earth-centred
    """
    x, y, z = np.moveaxis(np.asarray(ecef, dtype=float), -1, 0)
    distance = np.hypot(x, y)
    latitude = np.arctan2(z, distance * (1 - ECCENTRICITY_SQUARED))
    for _ in range(20):
        sin = np.sin(latitude)
        prime_vertical = SEMI_MAJOR_AXIS / np.sqrt(1 - ECCENTRICITY_SQUARED * sin**2)
        previous = latitude
        latitude = np.arctan2(z + ECCENTRICITY_SQUARED * prime_vertical * sin, distance)
        if np.all(np.abs(latitude - previous) < 1e-14):
            break
    sin, cos = np.sin(latitude), np.cos(latitude)
    height = distance * cos + z * sin - SEMI_MAJOR_AXIS * np.sqrt(1 - ECCENTRICITY_SQUARED * sin**2)
    return latitude, np.arctan2(y, x), height


def rotation_nwu_ecef(latitude: Array | float, longitude: Array | float) -> Array:
    """Rotation from earth-centred axes to North-West-Up (thesis equation B.1).

    Parameters
    ----------
    latitude, longitude : float or ndarray of shape (...), radians

    Returns
    -------
    ndarray of shape (..., 3, 3)
    """
    latitude, longitude = np.broadcast_arrays(latitude, longitude)
    sin_lat, cos_lat = np.sin(latitude), np.cos(latitude)
    sin_lon, cos_lon = np.sin(longitude), np.cos(longitude)
    rows = (
        (-cos_lon * sin_lat, -sin_lon * sin_lat, cos_lat),
        (sin_lon, -cos_lon, np.zeros_like(cos_lon)),
        (cos_lon * cos_lat, sin_lon * cos_lat, sin_lat),
    )
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


@dataclass(frozen=True)
class LocalFrame:
    """North-West-Up frame tangent to the ellipsoid at an origin.

    Attributes
    ----------
    latitude, longitude : float, radians
    height : float, metres
        Above the ellipsoid.
    """

    latitude: float
    longitude: float
    height: float

    @property
    def origin_deg_m(self) -> tuple[float, float, float]:
        """Origin of the frame: latitude, longitude (degrees), ellipsoidal height (metres)."""
        return (
            float(np.degrees(self.latitude)),
            float(np.degrees(self.longitude)),
            float(self.height),
        )

    @cached_property
    def _origin_ecef(self) -> Array:
        return geodetic_to_ecef(
            np.asarray(self.latitude), np.asarray(self.longitude), np.asarray(self.height)
        )

    @cached_property
    def _rotation_local_ecef(self) -> Array:
        return rotation_nwu_ecef(self.latitude, self.longitude)

    def to_local(self, latitude: Array, longitude: Array, height: Array) -> Array:
        """Convert geodetic to local coordinates, shape (n, 3), metres.

        Parameters
        ----------
        latitude, longitude : ndarray of shape (n,), radians
        height : ndarray of shape (n,), metres
            Above the ellipsoid.
        """
        offset = geodetic_to_ecef(latitude, longitude, height) - self._origin_ecef
        return offset @ self._rotation_local_ecef.T

    def to_geodetic(self, points_local: Array) -> tuple[Array, Array, Array]:
        """Latitude, longitude (radians) and height (metres) of ``points_local``, shape (n, 3)."""
        return ecef_to_geodetic(points_local @ self._rotation_local_ecef + self._origin_ecef)

    def rotation_local_level(self, latitude: Array, longitude: Array) -> Array:
        """Rotation from the North-West-Up frame at other places into this frame.

        An INS reports its attitude relative to the north and the vertical at the vessel, not at the
        origin. At a latitude of 45 deg, the directions of north at two places 1 km apart, east and
        west, differ by 0.009 deg.

        Parameters
        ----------
        latitude, longitude : ndarray of shape (n,), radians

        Returns
        -------
        ndarray of shape (n, 3, 3)
        """
        rotation_ecef_level = np.swapaxes(rotation_nwu_ecef(latitude, longitude), -1, -2)
        return self._rotation_local_ecef @ rotation_ecef_level
