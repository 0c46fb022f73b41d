"""Tests of the position, size and orientation of targets, and of sections across planes."""

import numpy as np
import pytest
from numpy.typing import NDArray

from lispac.targets.surface_geometry import (
    MAX_SECTION_POINTS,
    SECTION_THICKNESS_M,
    plane_geometry,
    section_points,
    sphere_geometry,
)

CENTRE = np.array([10.0, -20.0, 5.0])


def _plane(normal: NDArray[np.float64], width: float, height: float) -> NDArray[np.float64]:
    """Grid of points on a plane around `CENTRE`."""
    level = np.array([-normal[1], normal[0], 0.0])
    level = level / np.linalg.norm(level) if level.any() else np.array([0.0, 1.0, 0.0])
    slope = np.cross(normal, level)
    u, v = (
        x.ravel() for x in np.meshgrid(*(s * np.linspace(-0.5, 0.5, 41) for s in (width, height)))
    )
    return CENTRE + u[:, None] * level + v[:, None] * slope


@pytest.mark.parametrize(
    ("normal", "inclination", "azimuth"),
    [
        ((1.0, 0.0, 0.0), 90.0, 0.0),  # towards north
        ((0.0, -1.0, 0.0), 90.0, 90.0),  # towards east
        ((0.0, 1.0, 0.0), 90.0, 270.0),
        ((-1.0, -1.0, 0.0), 90.0, 135.0),
        ((-1.0, 0.0, 1.0), 45.0, 180.0),
        ((-1.0, 0.0, -1.0), 45.0, 180.0),  # overhanging
        ((0.0, 0.0, 1.0), 0.0, None),
    ],
)
def test_orientation_of_a_plane(
    normal: tuple[float, ...], inclination: float, azimuth: float | None
) -> None:
    unit = np.array(normal) / np.linalg.norm(normal)
    points = _plane(unit, 3.0, 1.0)
    geometry = plane_geometry({"a": points, "b": points[::2]}, CENTRE + 30.0 * unit)
    assert geometry.inclination is not None
    assert geometry.normal == pytest.approx(unit, abs=1e-9)
    assert geometry.centre == pytest.approx(CENTRE, abs=0.02)
    assert geometry.extent == pytest.approx([3.0, 1.0], abs=1e-9)
    assert np.degrees(geometry.inclination) == pytest.approx(inclination, abs=1e-9)
    if azimuth is None:
        assert geometry.azimuth is None
    else:
        assert geometry.azimuth is not None
        assert np.degrees(geometry.azimuth) == pytest.approx(azimuth)


def test_a_sphere_has_a_position_only() -> None:
    points = np.random.default_rng(1).normal(size=(200, 3))
    points = CENTRE + 0.15 * points / np.linalg.norm(points, axis=1, keepdims=True)
    geometry = sphere_geometry({"a": points[points[:, 1] > CENTRE[1]]}, 0.15)
    assert geometry.centre == pytest.approx(CENTRE, abs=1e-6)
    assert geometry.extent is None
    assert geometry.inclination is None
    assert geometry.azimuth is None


def test_a_section_shows_the_offset_of_the_lines_along_the_normal() -> None:
    towards_east = np.array([0.0, -1.0, 0.0])
    points = _plane(towards_east, 1.0, 3.0)
    groups = {"a": points + 0.01 * towards_east, "b": points - 0.01 * towards_east}
    geometry = plane_geometry(groups, CENTRE + 30.0 * towards_east)
    section = section_points(groups, geometry)
    for line, offset in (("a", 0.01), ("b", -0.01)):
        assert 0 < len(section[line]) <= MAX_SECTION_POINTS
        along, distance = section[line].T
        assert distance == pytest.approx(np.full(len(along), offset), abs=1e-9)
        assert np.ptp(along) == pytest.approx(3.0, abs=1e-9)  # the longer axis
        assert np.all(np.diff(along) >= 0.0)
    strip = np.abs(points[:, 0] - CENTRE[0]) <= 0.5 * SECTION_THICKNESS_M
    assert strip.sum() > MAX_SECTION_POINTS


def test_a_section_of_a_horizontal_plane_is_along_east_or_north() -> None:
    points = _plane(np.array([0.0, 0.0, 1.0]), 3.0, 1.0)
    up_to_the_east = points - 0.01 * (points[:, 1:2] - CENTRE[1]) * np.array([0.0, 0.0, 1.0])
    geometry = plane_geometry({"a": points}, CENTRE + np.array([0.0, 0.0, 30.0]))
    along, distance = section_points({"a": up_to_the_east}, geometry)["a"].T
    assert distance == pytest.approx(0.01 * along, abs=1e-9)
