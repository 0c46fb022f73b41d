"""Tests of the values of single points: coordinates, range, incidence."""

from pathlib import Path

import numpy as np
import pytest

from lispac.geometry.rotations import rotation_matrix
from lispac.language import in_language
from lispac.present.survey.measured_point import (
    Coordinate,
    MeasuredPoint,
    copied_point,
    point_facts,
)
from lispac.project import LineSource, Project, Reading, Settings
from lispac.survey.cloud import CloudInMemory
from lispac.survey.crs import coordinate_system
from lispac.survey.georeferencing import to_lidar
from lispac.survey.scan import Scan
from lispac.workflow.project.measured_points import PointReader, incidence_angle
from tests.support.cloud_files import MOUNTING, sweep, track
from tests.support.topocentric import east_north_up_by_proj

NONE_NEAR = np.empty((0, 3))


def plate(tilt_deg: float, noise: float) -> np.ndarray:
    """Points on a plate of 0.4 m whose normal is tilted from north."""
    generator = np.random.default_rng(4)
    flat = generator.uniform(-0.2, 0.2, (300, 3))
    flat[:, 0] = generator.normal(0.0, noise, 300)
    return flat @ rotation_matrix(0.0, 0.0, np.radians(tilt_deg)).T + [8.0, 1.0, 2.0]


@pytest.mark.parametrize("tilt_deg", [0.0, 35.0, 80.0])
def test_incidence_is_the_angle_between_beam_and_normal(tilt_deg: float) -> None:
    for beam in ([5.0, 0.0, 0.0], [-5.0, 0.0, 0.0]):
        angle = incidence_angle(plate(tilt_deg, 0.005), np.array(beam))
        assert angle is not None
        # The normal of 300 points over 0.4 m with noise of 5 mm has a sigma of 0.15 degrees
        assert np.degrees(angle) == pytest.approx(tilt_deg, abs=0.6)


def test_there_is_no_incidence_without_a_plane() -> None:
    beam = np.array([5.0, 0.0, 0.0])
    points = plate(0.0, 0.005)
    assert incidence_angle(points[:5], beam) is None
    assert incidence_angle(plate(0.0, 0.08), beam) is None
    wire = points * [0.0, 0.0, 1.0] + [8.0, 1.0, 0.0]
    assert incidence_angle(wire, beam) is None
    thin = points * [1.0, 0.01, 1.0]
    assert incidence_angle(thin, beam) is None


@pytest.mark.parametrize("system", ["", "local:46.8,-71.2,20", "EPSG:32619", "EPSG:4326"])
def test_coordinates_are_in_the_system_of_the_file(system: str, tmp_path: Path) -> None:
    trajectory = track()
    points, time = sweep(trajectory, 200)
    cloud = CloudInMemory.of(Scan(points_lidar=points, time=time), trajectory, MOUNTING)
    options = (("frame", "georeferenced"), ("crs", system)) if system else ()
    line = LineSource("L1", tmp_path / "line.laz", (), Reading("las", options))
    project = Project(
        folder=tmp_path,
        trajectory=tmp_path / "sbet.out",
        lines=(line,),
        settings=Settings((0.0,) * 3, (0.0,) * 3),
    )
    read = PointReader(project, trajectory).values("L1", cloud, 7, NONE_NEAR)
    values = [each.value for each in read.coordinates]
    if not system.startswith("EPSG"):
        expected = east_north_up_by_proj(cloud.sample[7], trajectory.frame)[0]
        np.testing.assert_allclose(values, expected, atol=1e-6)
        assert [each.axis for each in read.coordinates] == ["east", "north", "up"]
    else:
        assert system in read.system
        back = coordinate_system(system).to_local(np.array([values]), trajectory.frame)[0]
        np.testing.assert_allclose(back, cloud.sample[7], atol=1e-6)
    assert read.range_m == pytest.approx(float(np.linalg.norm(points[7])))
    assert read.time_s == time[7]
    assert (read.incidence_rad, read.intensity) == (None, None)


def test_the_incidence_is_that_of_all_points_if_few_are_drawn(tmp_path: Path) -> None:
    """A horizontal plane, on which the beams have an angle of incidence of 45°."""
    trajectory = track()
    time = np.linspace(trajectory.time[0] + 1.0, trajectory.time[0] + 1.2, 400)
    poses = trajectory.at(time)
    offsets = np.random.default_rng(1).uniform(-0.25, 0.25, (len(time), 2))
    places = poses.position.mean(axis=0) + [20.0, 0.0, -20.0]
    places = places + np.column_stack([offsets, np.zeros(len(time))])
    points = to_lidar(places, poses, MOUNTING)
    cloud = CloudInMemory.of(Scan(points_lidar=points, time=time), trajectory, MOUNTING)
    line = LineSource("L1", tmp_path / "line.laz", (), Reading("las", ()))
    project = Project(
        folder=tmp_path, trajectory=tmp_path / "sbet.out", lines=(line,),
        settings=Settings((0.0,) * 3, (0.0,) * 3),
    )  # fmt: skip
    reader = PointReader(project, trajectory)
    places = np.asarray(cloud.sample, dtype=float)
    middle = int(np.linalg.norm(places - np.median(places, axis=0), axis=1).argmin())
    drawn = places[np.linalg.norm(places - places[middle], axis=1) <= 0.3]
    seen = reader.values("L1", cloud, middle, drawn)
    assert np.degrees(seen.incidence_rad) == pytest.approx(45.0, abs=3.0)
    overview = reader.values("L1", cloud, middle, drawn[:3])
    assert overview.incidence_rad == pytest.approx(seen.incidence_rad, abs=1e-6)
    assert overview.plane_points == len(drawn)


@pytest.mark.parametrize("language", ["en", "fr"])
@pytest.mark.parametrize(
    ("axes", "unit", "system"),
    [
        (("east", "north", "up"), "local", "local frame"),
        (("easting", "northing", "height"), "US survey foot", "NAD83 / New York East (ftUS)"),
        (("longitude", "latitude", "height"), "degree", "WGS 84"),
        (("X", "Y", "Z"), "metre", "WGS 84"),
    ],
)
def test_coordinates_are_found_in_copied_values(
    language: str, axes: tuple[str, ...], unit: str, system: str
) -> None:
    place = tuple(Coordinate(axis, k - 1.5, unit) for k, axis in enumerate(axes))
    read = MeasuredPoint("East 3", place, system, 1.0, None, 2.0, None, None, None)
    with in_language(language):
        facts = {fact.name: fact.text for fact in point_facts(read)}
        found = copied_point("\n".join(f"{name}\t{text}" for name, text in facts.items()))
        reordered = copied_point("\n".join(f"{n}\t{t}" for n, t in reversed(facts.items())))
        assert copied_point("\n".join(facts.values())) is None
    assert found is not None
    assert found == reordered
    assert found.system == system
    assert [facts[name] for name in list(facts)[1:4]] == [found.coordinates[axis] for axis in axes]


def test_unknown_values_are_left_out_and_units_are_named() -> None:
    place = (
        Coordinate("longitude", -68.5, "degree"),
        Coordinate("latitude", 48.25, "degree"),
        Coordinate("height", 12.3456, "US survey foot"),
    )
    read = MeasuredPoint("L1", place, "NAD83", 345612.12345, None, 23.4567, None, None, None)
    with in_language("en"):
        shown = {fact.name: fact.text for fact in point_facts(read)}
    assert shown == {
        "Line": "L1", "Longitude (°)": "\N{MINUS SIGN}68.50000000", "Latitude (°)": "48.25000000",
        "Height (ftUS)": "12.346", "Time": "345612.123", "Range": "23.457",
        "Coordinate system": "NAD83",
    }  # fmt: skip
