"""Positions relative to an origin, computed by PROJ from latitude, longitude and height."""

import numpy as np
from pyproj import Transformer

from lispac.geometry.frames import LocalFrame


def _pipeline(frame: LocalFrame) -> Transformer:
    latitude, longitude, height = frame.origin_deg_m
    return Transformer.from_pipeline(
        "+proj=pipeline +step +proj=cart +ellps=WGS84 "
        f"+step +proj=topocentric +ellps=WGS84 +lon_0={longitude!r} +lat_0={latitude!r} "
        f"+h_0={height!r}"
    )


def east_north_up_by_proj(points_local: np.ndarray, frame: LocalFrame) -> np.ndarray:
    """East, north, up of georeferenced points relative to the origin, shape (n, 3), metres."""
    latitude, longitude, height = frame.to_geodetic(np.atleast_2d(points_local))
    pipeline = _pipeline(frame)
    return np.stack(pipeline.transform(longitude, latitude, height, radians=True), axis=-1)


def local_by_proj(east_north_up: np.ndarray, frame: LocalFrame) -> np.ndarray:
    """The inverse of `east_north_up_by_proj`."""
    longitude, latitude, height = _pipeline(frame).transform(
        *np.atleast_2d(east_north_up).T, direction="INVERSE", radians=True
    )
    return frame.to_local(latitude, longitude, height)
