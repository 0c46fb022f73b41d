"""Tests of edge cases of coordinate systems, trajectories and time bases."""

from pathlib import Path

import numpy as np
import pytest
from pyproj import CRS

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame, ecef_to_geodetic, geodetic_to_ecef
from lispac.messages import note, warning
from lispac.survey.crs import coordinate_system, geoid_grid
from lispac.survey.crs_area import area_of_use_elsewhere
from lispac.survey.crs_operation import realizations
from lispac.survey.georeferencing import Mounting
from lispac.survey.known_time_base import KnownTimeBase, known_base_notes
from lispac.survey.point_mapping import ScannerPointConverter
from lispac.survey.scanner_frame_recovery import RecoverySetup, require_within_reach
from lispac.survey.time_base import (
    CURRENT_LEAP_SECONDS,
    TimeMatch,
    base_of_key,
    from_gps,
    plausible_bases,
    to_gps,
)
from lispac.survey.time_quality import (
    TrajectoryCoverage,
    accuracy_coverage_warning,
    exclusion_notes,
)
from lispac.survey.trajectory import LocalTrajectory
from tests.support.error_codes import has_code

ENGINEERING_CRS_WKT = 'ENGCRS["site",EDATUM["pegs"],CS[Cartesian,2],AXIS["x",east],AXIS["y",north],LENGTHUNIT["metre",1]]'  # fmt: skip # noqa: E501
ITRF2014 = CRS("EPSG:7912")
ZERO_MOUNTING = Mounting(np.zeros(3), np.zeros(3))


def _track(longest_gap: float = 1.0, latitude: float = 0.8, longitude: float = -1.2):
    """Return states every 0.5 s from 0 to 10 s, without 4 to 7 s, at 2 m/s to the north."""
    time = np.concatenate([np.arange(0.0, 4.1, 0.5), np.arange(7.0, 10.1, 0.5)])
    position = np.column_stack([2.0 * time, 0 * time, 0 * time])
    frame = LocalFrame(latitude, longitude, 0.0)
    return LocalTrajectory(frame, time, position, np.zeros((len(time), 3)), longest_gap)


# -- trajectories ----------------------------------------------------------------------------


def test_a_gap_is_not_bridged_but_its_ends_are_states() -> None:
    track = _track()
    assert track.has_gaps
    times = np.array([-0.1, 0.0, 3.9, 4.0, 4.1, 6.9, 7.0, 7.1, 10.0, 10.1])
    np.testing.assert_array_equal(
        track.covers(times),
        [False, True, True, True, False, False, True, True, True, False],
    )
    assert not _track(longest_gap=5.0).has_gaps
    assert _track(longest_gap=5.0).covers(times[1:-1]).all()


@pytest.mark.parametrize("times", [[-1.0, 2.0], [2.0, 11.0], [2.0, 5.0]])
def test_poses_outside_the_trajectory_are_refused(times: list[float]) -> None:
    expected = {"first": times[0], "last": times[1], "start": 0.0, "end": 10.0}
    with pytest.raises(InputError, check=has_code("survey.outside_trajectory", **expected)):
        _track().at(np.array(times))


def test_poses_are_interpolated_between_states() -> None:
    assert len(_track().at(np.zeros(0)).position) == 0
    np.testing.assert_allclose(_track().at(np.array([0.25, 7.2])).position[:, 0], [0.5, 14.4])


def test_rates_of_a_steady_motion_are_recovered() -> None:
    time = np.arange(0.0, 10.1, 0.5)
    turn = np.array([0.01, -0.02, 0.03])
    steady = LocalTrajectory(
        LocalFrame(0.8, -1.2, 0.0), time, time[:, None] * [2.0, -1.0, 0.5], time[:, None] * turn
    )
    found = steady.rate_at(np.array([0.0, 3.3, 10.0]))
    np.testing.assert_allclose(found, [[2.0, -1.0, 0.5, *turn]] * 3, rtol=0, atol=1e-12)


# -- coordinate systems ----------------------------------------------------------------------


def test_nan_coordinates_do_not_affect_other_points() -> None:
    place = geodetic_to_ecef(np.array([0.8]), np.array([-1.2]), np.array([30.0]))
    found = np.stack(ecef_to_geodetic(np.vstack([place, np.full((1, 3), np.nan)])), axis=-1)
    np.testing.assert_allclose(found[0], [0.8, -1.2, 30.0], rtol=1e-9)
    assert np.isnan(found[1]).all()


def test_a_height_system_with_geocentric_coordinates_is_refused() -> None:
    with pytest.raises(InputError, check=has_code("crs.geocentric_height")):
        coordinate_system("EPSG:4978", height="EPSG:5703")


def test_an_engineering_crs_has_no_realization() -> None:
    assert realizations(CRS(ENGINEERING_CRS_WKT), ITRF2014) == []


def test_a_user_defined_projection_has_no_realization() -> None:
    """Neither EPSG nor PROJ has a code for it in another realization."""
    own = CRS(
        "+proj=tmerc +lat_0=0 +lon_0=-71 +k=0.9999 +x_0=304800 +ellps=GRS80 +units=m +type=crs"
    ).to_json_dict()
    own["base_crs"] = CRS("EPSG:4617").to_json_dict()
    own["name"] = "my own"
    assert realizations(CRS.from_json_dict(own), ITRF2014) == []


def test_a_crs_without_an_area_of_use_is_valid_everywhere() -> None:
    assert CRS("+proj=utm +zone=19 +type=crs").area_of_use is None
    assert area_of_use_elsewhere(CRS("+proj=utm +zone=19 +type=crs"), -40.0, 170.0) == ""
    assert area_of_use_elsewhere(CRS("EPSG:32619"), 46.0, -71.0) == ""


def test_area_of_use_has_a_tolerance_of_three_degrees() -> None:
    zone = CRS("EPSG:32619")  # 72 to 66 degrees west, 0 to 84 north
    area_name = zone.area_of_use.name.split(".")[0]
    assert area_name.startswith("Between 72°W and 66°W")
    for latitude, longitude, elsewhere in (
        (-2.9, -69, False), (-3.1, -69, True), (86.9, -69, False), (87.1, -69, True),
        (46, -74.9, False), (46, -75.1, True), (46, -63.1, False), (46, -62.9, True),
        (46, 111, True),
    ):  # fmt: skip
        assert area_of_use_elsewhere(zone, latitude, longitude) == (area_name if elsewhere else "")


def test_area_of_use_across_the_antimeridian() -> None:
    fiji = CRS("EPSG:3460")  # 176.81 degrees east to 178.15 west
    for longitude, elsewhere in (
        (173.7, True), (173.9, False), (180, False), (-180, False), (-175.2, False), (-175.1, True),
        (0, True),
    ):  # fmt: skip
        assert bool(area_of_use_elsewhere(fiji, -17.0, longitude)) == elsewhere
    assert area_of_use_elsewhere(CRS("EPSG:4326"), 10.0, 179.0) == ""


@pytest.mark.parametrize("name", ["a,b.gtx", 'a"b.gtx'])
def test_a_geoid_path_with_a_comma_or_quote_is_refused(tmp_path: Path, name: str) -> None:
    grid = tmp_path / name
    grid.write_bytes(b"grid")
    with pytest.raises(InputError, check=has_code("crs.geoid_path", file=str(grid))):
        geoid_grid(grid)


@pytest.mark.parametrize(
    ("make", "code"),
    [
        (False, "crs.geoid_not_found"),
        (True, "crs.geoid_unreadable"),
    ],
)
def test_a_missing_or_invalid_geoid_grid_is_refused(tmp_path: Path, make: bool, code: str) -> None:
    grid = tmp_path / "geoid.gtx"
    if make:
        grid.write_bytes(b"no grid")
    with pytest.raises(InputError, check=has_code(code, file=str(grid))):
        geoid_grid(grid)


def test_the_converter_extends_to_distant_points() -> None:
    """Points near the trajectory, then points 3 km away, then near points again."""
    system = coordinate_system("EPSG:32619")
    track = _track(longest_gap=5.0, latitude=np.radians(46.0), longitude=np.radians(-69.0))
    mapper = ScannerPointConverter(system, track, ZERO_MOUNTING)
    time = np.array([1.0, 8.0])
    for metres in (20.0, 3000.0, 25.0):
        points = np.array([[1.0, metres, 2.0], [3.0, -metres, 1.0]])
        found = mapper.to_scanner(mapper.to_map(points, time), time)
        np.testing.assert_allclose(found, points, atol=1e-4)


def test_a_site_outside_the_map_projection_gives_distant_points() -> None:
    """A gnomonic projection covers half of the Earth, and the vessel is on the other half."""
    system = coordinate_system("+proj=gnom +lat_0=-46 +lon_0=110 +datum=WGS84 +type=crs")
    track = _track(longest_gap=5.0, latitude=np.radians(46.0), longitude=np.radians(-69.0))
    time, points = np.array([1.0, 8.0]), np.array([[1.0, 2.0, 3.0], [5e5, -4e5, 20.0]])
    found = ScannerPointConverter(system, track, ZERO_MOUNTING).to_scanner(points, time)
    local = system.to_local(points, track.frame)
    np.testing.assert_allclose(
        found, ScannerPointConverter(None, track, ZERO_MOUNTING).to_scanner(local, time), atol=1e-3
    )
    assert np.linalg.norm(found, axis=1).min() > 1e7, "the other side of the earth"


def test_an_empty_cloud_passes_the_check_of_the_range() -> None:
    system = coordinate_system("EPSG:32619")
    recovery = RecoverySetup(system, _track(), ZERO_MOUNTING, Path("a.las"))
    require_within_reach(np.zeros((0, 3)), recovery)
    with pytest.raises(InputError, check=has_code("survey.points_of_file_too_far", file="a.las")):
        require_within_reach(np.full((3, 3), 1e6), recovery)


# -- times -----------------------------------------------------------------------------------


def test_empty_or_nan_times_have_no_plausible_base() -> None:
    week, nothing = base_of_key("gps-week"), np.zeros(0)
    assert plausible_bases(nothing) == ()
    assert plausible_bases(np.array([1.0, np.nan])) == ()
    assert week in plausible_bases(np.array([1.0, 2.0]))
    assert to_gps(nothing, week).shape == (0,)
    assert from_gps(nothing, week).shape == (0,)


def _covered(count: int, outside: int = 0, in_gaps: int = 0) -> TrajectoryCoverage:
    return TrajectoryCoverage(0.0, 10.0, count, outside, in_gaps, (), 1.0)


@pytest.mark.parametrize(
    ("covered", "excluded_count", "found"),
    [
        (_covered(2000, 1500), 1500, {"import.excluded_outside": 1500}),
        (
            _covered(2000, 0, 20), 27,
            {"import.excluded_in_gaps": 20, "import.excluded_steep": 7},
        ),
    ],
)  # fmt: skip
def test_excluded_points_are_reported(
    covered: TrajectoryCoverage, excluded_count: int, found: dict[str, int]
) -> None:
    notes = exclusion_notes(covered, excluded_count, "a")
    assert {each.code: each.params["count"] for each in notes} == found


def test_shares_without_points_are_zero() -> None:
    assert (_covered(0).share_outside, _covered(0).share_in_gaps) == (0.0, 0.0)
    assert (_covered(8, 2, 4).share_outside, _covered(8, 2, 4).share_in_gaps) == (0.25, 0.5)


def test_accuracies_may_lack_two_seconds_at_either_end() -> None:
    track = np.array([10.0, 20.0, 30.0])
    assert accuracy_coverage_warning(np.array([12.0, 28.0]), track, "a") is None
    for first, last in ((12.1, 30.0), (10.0, 27.9)):
        assert accuracy_coverage_warning(np.array([first, last]), track, "a") == warning(
            "import.accuracy_too_short", file="a", first=first, last=last, start=10.0, end=30.0
        )


def test_assumed_leap_seconds_are_reported() -> None:
    week, utc = base_of_key("gps-week"), base_of_key("utc-week")
    own, other = KnownTimeBase(utc, is_given=True), KnownTimeBase(week)
    match = TimeMatch(((utc, week),), 18.0, 1.0)
    follows = note(
        "import.shift_follows", file="a", shift=18.0,
        base=note("time_base.given", base=note("time_base.utc_week")),
        trajectory_base=note("time_base.of_file", base=note("time_base.gps_week")),
    )  # fmt: skip
    assert known_base_notes((match,), own, other, "a") == (follows,)
    assumed = TimeMatch(((utc, week),), 18.0, 1.0, leap_assumed=True)
    leap = note("import.leap_seconds_assumed", file="a", leap=CURRENT_LEAP_SECONDS)
    assert known_base_notes((assumed,), own, other, "a") == (follows, leap)


def test_other_shifts_that_fit_as_well_are_reported() -> None:
    """A shift of one more day fits as many points; a shift of two more days fits fewer."""
    day = base_of_key("utc-day")
    pair = ((day, base_of_key("gps-week")),)
    ways = tuple(TimeMatch(pair, 86400.0 * k + 18.0, share) for k, share in ((1, 1.0), (2, 0.998)))
    own, other = KnownTimeBase(day, is_given=True), KnownTimeBase(pair[0][1])
    found = known_base_notes((*ways, TimeMatch(pair, 259218.0, 0.9)), own, other, "a")
    follows, rivals = found
    assert follows.params["shift"] == 86_418.0
    assert rivals.code == "import.other_shifts_fit"
    assert rivals.params["shifts"] == (note("import.shift", shift=172_818.0),)


def test_messages_of_unknown_and_suggested_time_bases() -> None:
    week = base_of_key("gps-week")
    assert KnownTimeBase().message == note("time_base.unknown")
    suggested = note("time_base.suggested", base=note("time_base.gps_week"))
    assert KnownTimeBase(week, suggested=True).message == suggested
