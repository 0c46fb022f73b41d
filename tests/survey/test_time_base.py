"""Tests of time bases, their detection, and the coverage of lines by the trajectory."""

from datetime import UTC, datetime

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lispac.errors import InputError
from lispac.survey.time_base import (
    DAY,
    GPS_EPOCH,
    HOUR,
    LEAP_SECOND_DATES,
    TIME_BASES,
    WEEK,
    base_of_key,
    equally_good_matches,
    find_time_matches,
    from_gps,
    leap_seconds,
    leap_seconds_at_gps,
    plausible_bases,
    to_gps,
    unroll_times,
)
from lispac.survey.time_quality import (
    TrajectoryCoverage,
    assess_coverage,
    assess_times,
    join_coverages,
)
from lispac.survey.time_rollover import find_rollover, resolve_rollover
from tests.support.error_codes import has_code
from tests.support.message_codes import codes

EPOCH = datetime(1980, 1, 6, tzinfo=UTC)


def gps(year: int, month: int, day: int, second: float = 0.0) -> float:
    """Return GPS seconds of a UTC instant; the number of leap seconds is written out here."""
    date = datetime(year, month, day, tzinfo=UTC)
    leap = sum(changed <= date.date() for changed in LEAP_SECOND_DATES)
    return (date - EPOCH).total_seconds() + second + leap


SURVEY = gps(2023, 6, 27, 50_400)  # a Tuesday at 14:00


def times(start: float, seconds: float, rate: float = 10.0) -> np.ndarray:
    return start + np.arange(int(seconds * rate)) / rate


def test_known_instants_are_converted() -> None:
    """1 January 2017, 00:00 UTC is GPS 1167264018, week 1930, with 18 leap seconds (IGS, IERS)."""
    instant = np.array([1_167_264_018.0])
    assert from_gps(instant, base_of_key("unix"))[0] == 1_483_228_800
    assert from_gps(instant, base_of_key("gps-week"))[0] == 1_167_264_018 - 1930 * 604_800
    assert from_gps(instant, base_of_key("utc-day"))[0] == 0
    assert from_gps(instant, base_of_key("gps-day"))[0] == 18
    assert from_gps(instant, base_of_key("gps-adjusted"))[0] == 167_264_018
    assert leap_seconds_at_gps(1_167_264_018.0) == 18
    assert leap_seconds_at_gps(1_167_264_016.9) == 17
    assert leap_seconds_at_gps(0.0) == 0


def test_a_leap_second_applies_from_the_start_of_its_day() -> None:
    for count, date in enumerate(LEAP_SECOND_DATES, start=1):
        start = (datetime(date.year, date.month, date.day, tzinfo=UTC) - EPOCH).total_seconds()
        assert leap_seconds(np.array([start - 0.5, start, start + 0.5])).tolist() == [
            count - 1, count, count,
        ]  # fmt: skip
        at_gps = np.array([start + count - 0.5, start + count])
        assert leap_seconds_at_gps(at_gps).tolist() == [count - 1, count]


surveys = st.tuples(
    st.floats(gps(2000, 1, 2), gps(2044, 12, 1)), st.floats(1, 40_000), st.sampled_from(TIME_BASES)
)


def leaps_inside(sample: np.ndarray) -> bool:
    return bool(leap_seconds_at_gps(sample[0] - 2) != leap_seconds_at_gps(sample[-1] + 2))


@given(surveys)
def test_conversion_and_its_inverse_give_the_original_times(survey: tuple) -> None:
    start, span, base = survey
    sample = np.linspace(start, start + span, 50)
    if base.utc and leaps_inside(sample):
        return  # two instants have the same UTC time there
    back = to_gps(from_gps(sample, base), base, near=start)
    np.testing.assert_allclose(back, sample, atol=1e-6, rtol=0)


@given(surveys)
def test_own_base_is_always_plausible(survey: tuple) -> None:
    start, span, base = survey
    values = from_gps(np.linspace(start, start + span, 50), base)
    if base.key == "utc-hour" and values.max() >= 2 * HOUR:
        return  # hour-based times always restart at the full hour
    early = base.key == "gps-adjusted" and values.min() >= 0 and values.max() < WEEK
    assert early or base in plausible_bases(values)


@given(surveys, st.sampled_from(TIME_BASES), st.floats(0.1, 0.9))
def test_points_of_any_time_base_match_the_trajectory(survey, other, where) -> None:
    start, span, base = survey
    track = np.linspace(start, start + span + 600, 500)
    line = np.linspace(start + where * span, start + where * span + 60, 20)
    if leaps_inside(track) or ("utc-hour" in (base.key, other.key) and span > HOUR / 2):
        return  # times alone match several hours of a longer survey
    found = find_time_matches(
        from_gps(line, base), from_gps(track, other), point_bases=[base], trajectory_bases=[other]
    )
    right = from_gps(track, other) - track
    known = base.period is None or other.period is None or base.utc == other.utc
    if known or leap_seconds_at_gps(start) == 18:
        shifts = [match.shifted_times(from_gps(line, base)) - line for match in found]
        assert any(np.allclose(shift, right[0], atol=1e-5, rtol=0) for shift in shifts)
        assert found[0].share == 1


@given(st.floats(0, WEEK - 1), st.sampled_from([DAY, WEEK]), st.floats(0.01, 20))
def test_wrapped_times_are_made_continuous(start: float, period: float, step: float) -> None:
    true = start + step * np.arange(300)
    back, count = unroll_times(true % period)
    np.testing.assert_allclose(back - back[0], true - true[0], rtol=0, atol=1e-6)
    assert count == int(true[-1] // period - true[0] // period)


def test_other_backward_steps_are_not_unrolled() -> None:
    disordered = np.array([1000.0, 1001.0, 900.0, 1002.0, 90_000.0, 500.0])
    np.testing.assert_array_equal(unroll_times(disordered)[0], disordered)


@pytest.mark.parametrize(
    ("points", "track", "shift"),
    [
        ("gps-week", "gps-week", 0.0),
        ("gps-adjusted", "gps-week", 1e9 - 2268 * WEEK),
        ("gps-week", "gps-adjusted", 2268 * WEEK - 1e9),
        ("utc-day", "gps-week", 2 * DAY + 18),
        ("gps-day", "unix", None),
        ("unix", "gps-week", None),
    ],
)
def test_common_pairs_of_time_bases_are_matched(
    points: str, track: str, shift: float | None
) -> None:
    trajectory = from_gps(times(SURVEY, 3600), base_of_key(track))
    line = from_gps(times(SURVEY + 900, 120), base_of_key(points))
    found = find_time_matches(line, trajectory)
    right = trajectory[0] - SURVEY - (line[0] - SURVEY - 900)
    assert any(abs(match.shift - right) < 1e-5 for match in found if match.share == 1)
    if shift is not None:
        assert right == pytest.approx(shift)
    if points == track:
        assert found[0].shift == 0


def test_an_ambiguous_time_base_is_reported() -> None:
    found = find_time_matches(times(50_400, 60), times(50_000, 3600))
    assert found[0].shift == 0
    assert 18.0 in [match.shift for match in equally_good_matches(found)]
    assert not equally_good_matches(find_time_matches(times(50_400, 60), times(50_400, 60)))


def test_use_of_the_current_leap_seconds_is_reported() -> None:
    day, week = base_of_key("utc-day"), base_of_key("gps-week")
    found = find_time_matches(
        times(50_400, 60), times(2 * DAY + 50_000, 3600), point_bases=[day], trajectory_bases=[week]
    )
    assert found[0].leap_assumed
    np.testing.assert_allclose(found[0].shifted_times(np.array([50_400.0])), 2 * DAY + 50_418)


def test_a_line_after_midnight_matches_the_trajectory() -> None:
    track = times(2 * DAY - 600, 1200)  # seconds of the week, over the midnight of Monday
    after = find_time_matches(times(60, 30), track)
    np.testing.assert_allclose(after[0].shifted_times(np.array([60.0])), 2 * DAY + 60)
    before = find_time_matches(times(DAY - 60, 30), track)
    np.testing.assert_allclose(before[0].shifted_times(np.array([DAY - 60])), 2 * DAY - 60)


def test_a_line_after_the_end_of_the_week_matches_the_trajectory() -> None:
    track = times(WEEK - 600, 1200)
    found = find_time_matches(times(60, 30), track)
    assert found[0].shift in (WEEK, WEEK - 18, WEEK + 18)
    assert any(match.shift == WEEK for match in found)


def test_missing_matches_are_reported() -> None:
    assert find_time_matches(np.array([5e13]), times(0, 60)) == ()
    assert find_time_matches(np.zeros(0), times(0, 60)) == ()


def test_an_unknown_date_is_refused() -> None:
    with pytest.raises(InputError, check=has_code("time.no_date")):
        to_gps(np.array([5.0]), base_of_key("gps-week"))
    with pytest.raises(InputError, check=has_code("time.unknown_base")):
        base_of_key("sundial")


def through_32_bits(values: np.ndarray) -> np.ndarray:
    return values.astype(np.float32).astype(np.float64)


def test_lost_precision_is_detected() -> None:
    quality = assess_times(through_32_bits(times(400_825, 20, 200)))
    assert quality.resolution == 1 / 32
    assert quality.duplicates > 3000
    assert "times.coarse" in codes(quality.messages("a"))
    assert assess_times(through_32_bits(times(50_400.0, 20, 30))).resolution == 1 / 256


@pytest.mark.parametrize(
    "sound",
    [
        times(400_825, 60, 1),
        times(400_825, 60, 2),
        times(400_825, 20, 200),
        np.array([400_825.0, 400_826.0, 400_831.0]),
        np.array([5.0]),
        times(0, 3, 10),
        np.array([1e39, 2e39, 4e39]),  # out of the range of 32 bits
        np.array([1.0, 2.0, np.inf]),
    ],
)
def test_valid_times_have_no_warnings(sound: np.ndarray) -> None:
    assert assess_times(sound).messages("a") == ()


def test_duplicate_and_backward_times_are_counted() -> None:
    quality = assess_times(np.array([0.1, 0.2, 0.2, 0.3, 0.15, 0.4, 0.4, np.nan]))
    assert (quality.duplicates, quality.backward, quality.first_disorder) == (2, 1, 2)


def test_coverage_of_a_small_example() -> None:
    track = np.array([0.0, 1.0, 2.0, 10.0, 11.0, 20.0, 21.0])
    line = np.array([-1.0, 0.5, 2.0, 5.0, 9.0, 10.0, 10.5, 15.0, 20.5, 25.0])
    found = assess_coverage(line, track, 1.5)
    assert (found.start, found.end, found.count) == (-1, 25, 10)
    assert (found.outside, found.in_gaps, found.usable) == (2, 3, 5)
    assert found.gaps == ((2.0, 10.0), (11.0, 20.0))
    assert found.share_in_gaps == 0.3
    assert assess_coverage(np.array([0.5]), track, 1.5).gaps == ()


@given(
    st.lists(st.floats(-10, 110), min_size=1, max_size=60),
    st.lists(st.floats(0.01, 8), min_size=1, max_size=40),
    st.integers(0, 60),
)
def test_coverage_counts_every_point_once(line, steps, cut) -> None:
    track, sample = np.cumsum([0.0, *steps]), np.array(line)
    found = assess_coverage(sample, track, 2.0)
    for k, time in enumerate(sample):  # by definition, point by point
        outside = time < track[0] or time > track[-1]
        gap = any(
            track[j] < time < track[j + 1] and track[j + 1] - track[j] > 2
            for j in range(len(track) - 1)
        )
        alone = assess_coverage(sample[k : k + 1], track, 2.0)
        assert (alone.outside, alone.in_gaps) == (int(outside), int(gap))
    parts = join_coverages(
        [assess_coverage(sample[:cut], track, 2.0), assess_coverage(sample[cut:], track, 2.0)]
    )
    assert (parts.count, parts.outside, parts.in_gaps) == (
        found.count, found.outside, found.in_gaps,
    )  # fmt: skip


def test_coverage_of_empty_arrays() -> None:
    empty = assess_coverage(np.zeros(0), times(0, 5), 1)
    assert np.isnan([empty.start, empty.end]).all()
    assert (empty.count, empty.outside, empty.in_gaps, empty.gaps) == (0, 0, 0, ())
    assert (empty.longest_gap, join_coverages([empty, empty]).longest_gap) == (1, 1)
    alone = assess_coverage(np.array([7.0, 3.0, 4.0]), np.zeros(0), 1)
    assert alone == TrajectoryCoverage(3.0, 7.0, 3, 3, 0, (), 1)
    none = join_coverages([])
    assert np.isnan([none.start, none.end, none.longest_gap]).all()
    assert (none.count, none.outside, none.in_gaps, none.gaps) == (0, 0, 0, ())


def test_times_outside_2000_to_2045_are_not_plausible() -> None:
    def known(*when: int) -> bool:
        second = datetime(*when, tzinfo=UTC).timestamp()
        return base_of_key("unix") in plausible_bases(np.array([second]))

    assert known(2000, 1, 1)
    assert known(2044, 12, 31, 23, 59, 59)
    assert not known(1999, 12, 31, 23, 59, 59)
    assert not known(2045, 1, 1)


# -- PTP and the full hour ------------------------------------------------------------------------


@given(st.floats(gps(2018, 1, 2), gps(2044, 12, 1)))
def test_tai_is_37_s_ahead_of_utc_and_19_s_ahead_of_gps(start: float) -> None:
    moment = np.array([start])
    tai, unix, full = (from_gps(moment, base_of_key(key)) for key in ("tai", "unix", "gps-full"))
    np.testing.assert_allclose(tai - unix, 37.0, atol=1e-5)
    np.testing.assert_allclose(tai - full, GPS_EPOCH + 19.0, atol=1e-5)


def test_times_that_may_be_unix_or_ptp_have_both_matches() -> None:
    track = gps(2024, 5, 31) + np.linspace(3000, 4000, 500)
    line = track[200:260]
    for key in ("unix", "tai"):
        found = find_time_matches(
            from_gps(line, base_of_key(key)), from_gps(track, base_of_key("gps-week")),
            trajectory_bases=[base_of_key("gps-week")],
        )  # fmt: skip
        shifts = {match.points.key: match.shift for match in found if match.share == 1}
        assert {"unix", "tai"} <= set(shifts)
        assert shifts["unix"] - shifts["tai"] == pytest.approx(37.0)
        own = base_of_key(key)
        right = from_gps(track, base_of_key("gps-week"))[0] - from_gps(track, own)[0]
        assert shifts[key] == pytest.approx(right)


@given(st.integers(0, 167), st.floats(60, 3000), st.floats(10, 1500))
def test_seconds_of_the_hour_match_the_trajectory(hour: int, begin: float, span: float) -> None:
    """Within one hour and over its end, in the times of a Velodyne."""
    start = gps(2024, 6, 2) + hour * HOUR + 18 + begin
    track = start + np.linspace(-60, span + 60, 800)
    line = start + np.linspace(0, span, 300)
    raw = np.mod(from_gps(line, base_of_key("unix")), HOUR)
    rollover = find_rollover(raw)
    assert rollover == ("full-hour" if raw[-1] < raw[0] and span < 0.9 * HOUR / 2 else "") or (
        raw[-1] < raw[0]
    )
    counted = np.where(raw < raw[0], raw + HOUR, raw)
    if rollover:
        np.testing.assert_allclose(
            resolve_rollover(raw, rollover) - counted, counted[0] * 0, atol=1e-6
        )
    found = find_time_matches(
        counted, from_gps(track, base_of_key("gps-week")),
        point_bases=[base_of_key("utc-hour")], trajectory_bases=[base_of_key("gps-week")],
    )  # fmt: skip
    assert found[0].share == 1
    right = from_gps(track, base_of_key("gps-week"))[0] - track[0]
    assert any(np.allclose(m.shifted_times(counted) - line, right, atol=1e-5) for m in found)
