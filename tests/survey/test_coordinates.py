"""Tests of typed or listed coordinates: axis names, and messages about implausible ones."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.message_texts import message_text
from lispac.survey.crs import coordinate_system
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.project.coordinates import (
    LocalAxes,
    axis_names,
    distances_from_trajectory,
    require_near_trajectory,
    to_local_frame,
    too_far_message,
)
from tests.support.cloud_files import track
from tests.support.topocentric import local_by_proj

UTM, GEOGRAPHIC, GEOCENTRIC = "EPSG:32619", "EPSG:4326", "EPSG:4978"


@pytest.fixture(scope="module")
def circle() -> LocalTrajectory:
    """Trajectory on a circle of 800 m about a place in Quebec."""
    return track()


@pytest.mark.parametrize(
    ("code", "axes"),
    [
        ("", ("north", "west", "up")),
        (UTM, ("easting", "northing", "height")),
        (GEOGRAPHIC, ("longitude", "latitude", "height")),
        (GEOCENTRIC, ("X", "Y", "Z")),
    ],
)
def test_axis_names_are_those_of_the_coordinate_system(code: str, axes: tuple[str, ...]) -> None:
    assert axis_names(coordinate_system(code) if code else None) == axes


@pytest.mark.parametrize("code", ["", "local:46.8,-71.2,20"])
def test_coordinates_in_the_local_frame_are_in_the_order_of_the_axes(
    circle: LocalTrajectory, code: str
) -> None:
    system = coordinate_system(code) if code else None
    frame = circle.frame
    if system is not None and system.frame is not None:
        frame = system.frame
    shown = np.array([14.7, 1.15, 8.11])
    assert axis_names(system, "east, north, up") == ("east", "north", "up")
    assert axis_names(system) == ("north", "west", "up")
    place = require_near_trajectory(shown, system, circle, "P1", "east, north, up")
    latitude, longitude, height = frame.to_geodetic(local_by_proj(shown, frame))
    expected = circle.frame.to_local(latitude, longitude, height)[0]
    np.testing.assert_allclose(place, expected, atol=1e-6)
    same = require_near_trajectory(np.array([1.15, -14.7, 8.11]), system, circle, "P1")
    np.testing.assert_allclose(same, place, atol=1e-9)


def test_invalid_coordinates_have_an_infinite_distance(circle: LocalTrajectory) -> None:
    start = circle.position[0]
    places = np.array([start, [np.nan, 0.0, 0.0], start + [0.0, 0.0, 900.0]])
    found = distances_from_trajectory(places, circle)
    assert found[0] == pytest.approx(0.0, abs=1e-6)
    assert found[1] == np.inf
    assert found[2] == pytest.approx(900.0, abs=2.0)  # the vessel moves vertically by a metre
    assert (distances_from_trajectory(places[1:2], circle) == np.inf).all()


def test_coordinates_near_the_trajectory_are_converted(circle: LocalTrajectory) -> None:
    system = coordinate_system(GEOGRAPHIC)
    near = np.array([-71.2, 46.8, 5.0])
    assert too_far_message(near, system, circle, "P1") is None
    place = require_near_trajectory(near, system, circle, "P1")
    np.testing.assert_allclose(place, to_local_frame(near, system, circle)[0])
    assert np.linalg.norm(place[:2]) < 1000


@pytest.mark.parametrize(
    ("code", "point", "message_code"),
    [
        (
            GEOGRAPHIC, (46.8, -71.2, 5.0),
            "coordinates.swapped_geographic",
        ),
        (
            GEOGRAPHIC, (-71.2, 20.0, 5.0),
            "coordinates.too_far",
        ),
        (UTM, (3e10, 5_000_000.0, 5.0), "coordinates.outside_system"),
        (
            "", (90_000.0, 0.0, 0.0),
            "coordinates.too_far_local",
        ),
    ],
)  # fmt: skip
def test_implausible_coordinates_are_reported_with_a_possible_cause(
    circle: LocalTrajectory, code: str, point: tuple[float, ...], message_code: str
) -> None:
    system = coordinate_system(code) if code else None
    message = too_far_message(np.array(point), system, circle, "P1")
    assert message is not None
    assert message.code == message_code
    with pytest.raises(InputError) as caught:
        require_near_trajectory(np.array(point), system, circle, "P1")
    assert caught.value.message == message
    assert str(caught.value).startswith("P1: ")


@pytest.mark.parametrize(
    ("local_axes", "names"),
    [("north, west, up", "north, west and up"), ("east, north, up", "east, north and up")],
)
def test_implausible_local_coordinates_name_their_order(
    circle: LocalTrajectory, local_axes: LocalAxes, names: str
) -> None:
    first, second = local_axes.split(", ")[:2]
    for point, text in (
        ([90_000.0, 0.0, 0.0], f"Give metres {names} from its origin"),
        ([np.inf, 0.0, 0.0], f"Give metres {names} from its origin"),
    ):
        message = too_far_message(np.array(point), None, circle, "P1", local_axes)
        assert message is not None
        assert text in message_text(message)
    moved = replace(circle, position=circle.position + [20_000.0, 0.0, 0.0])
    swapped = np.array([0.0, 20_000.0, 0.0])
    if first == "east":
        swapped = swapped[[1, 0, 2]]
    message = too_far_message(swapped, None, moved, "P1", local_axes)
    assert message is not None
    assert message.code == "coordinates.swapped_local"
    assert f"Give {first} first, then {second}." in message_text(message)
