"""Tests of the audit of lines, for each format: unusable points, times, duplicates, splits."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.geometry.frames import LocalFrame
from lispac.io.formats import format_of
from lispac.messages import Level, Message
from lispac.project import LineSource, Project, Reading, Settings
from lispac.survey.audit_messages import line_messages
from lispac.survey.line_audit import LineAudit, shared_point_fraction
from lispac.survey.point_screening import PointScreen, PointSelection
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.importing.file_audit import audit_file
from lispac.workflow.importing.file_reading import check_file
from lispac.workflow.importing.line_import import import_lines
from lispac.workflow.output.georeferencing import georeference_project
from lispac.workflow.project.projects import new_project, open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.input_file_samples import LEVER, START, fan, write_line, write_survey
from tests.support.long_runs import LONG, others_long
from tests.support.trajectory_files import write_records

POINT_COUNT = 3000
TIMES = START + np.linspace(2, 12, POINT_COUNT)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "files").mkdir()
    return write_survey(tmp_path / "files")


def las(path: Path, times: np.ndarray, points: np.ndarray, **attributes: np.ndarray) -> Path:
    write_line(path, times, points)
    if attributes:
        data = laspy.read(path)
        for name, values in attributes.items():
            data[name] = values
        data.write(path)
    return path


def text(path: Path, times: np.ndarray, points: np.ndarray, **attributes: np.ndarray) -> Path:
    names = " ".join(("time", "x", "y", "z", *attributes))
    table = np.column_stack([times, points, *attributes.values()])
    np.savetxt(path, table, fmt="%.9f", header=names, comments="")
    return path


def ply(path: Path, times: np.ndarray, points: np.ndarray, **attributes: np.ndarray) -> Path:
    names = ("x", "y", "z", "time", *attributes)
    properties = "".join(f"property double {name}\n" for name in names)
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(times)}\n{properties}"
    table = np.column_stack([points, times, *attributes.values()]).astype("<f8")
    path.write_bytes(f"{head}end_header\n".encode() + table.tobytes())
    return path


Writer = Callable[..., Path]
WRITERS = {"L1.laz": las, "L1.csv": text, "L1.ply": ply}
every_format = pytest.mark.parametrize("name", WRITERS)


def open_lines(folder: Path, *paths: Path, options: tuple[tuple[str, str], ...] = ()) -> Survey:
    sources = [LineSource(path.stem, path, (), Reading("", options)) for path in paths]
    place = folder.parent / "project"
    _, survey = new_project(
        place, trajectory=folder / "pos.sbet", accuracy=folder / "smrmsg.out", lines=sources,
        settings=Settings(LEVER),
    )  # fmt: skip
    assert open_project(place).data_messages == survey.messages
    return survey


def by_code(survey: Survey) -> dict[str, Message]:
    return {message.code: message for message in survey.messages}


# -- valid lines ----------------------------------------------------------------------------------


@every_format
def test_a_valid_line_has_no_message(folder: Path, name: str) -> None:
    survey = open_lines(folder, WRITERS[name](folder / name, TIMES, fan(POINT_COUNT)))
    assert survey.messages == ()
    assert len(survey.scans["L1"]) == POINT_COUNT


# -- resolution of the times ----------------------------------------------------------------------


def test_positions_of_the_trajectory_that_are_held_are_reported(folder: Path) -> None:
    """The positions are measured once a second, on a circle at 4 m/s, and written 50 times."""
    records = np.fromfile(folder / "pos.sbet").reshape(-1, 17)
    measured = np.arange(len(records)) // 50 * 50
    records[:, 1:3] = records[measured, 1:3]
    write_records(folder / "pos.sbet", records)
    survey = open_lines(folder, las(folder / "L1.laz", TIMES, fan(POINT_COUNT)))
    message = by_code(survey)["trajectory.position_held"]
    assert (message.level, message.params["line"]) == (Level.WARNING, "L1")
    assert message.params["longest"] == pytest.approx(0.98)
    assert message.params["shift"] == pytest.approx(4 * 0.98, rel=0.01)


def test_no_position_of_the_built_in_survey_is_held(demo_project: Project) -> None:
    assert "trajectory.position_held" not in by_code(load_survey(demo_project))


@every_format
@pytest.mark.parametrize(
    "step", others_long([0.002, 0.01, 0.1, 1.0], lambda step: step in (0.01, 1.0))
)
def test_rounded_times_are_reported_with_their_effect(folder: Path, name: str, step: float) -> None:
    dense = START + np.arange(2, 12, 5e-5)
    times = np.round(dense / step) * step
    points = fan(len(times)) + np.linspace(0, 1, len(times))[:, None]
    survey = open_lines(folder, WRITERS[name](folder / name, times, points))
    message = by_code(survey)["audit.time_resolution"]
    assert message.level is Level.WARNING
    assert message.params["step"] == pytest.approx(step, rel=1e-3)
    assert message.params["points"] == pytest.approx(len(times) / len(np.unique(times)), rel=0.02)
    rates = survey.trajectory.rate_at(np.linspace(times[0], times[-1], 500))
    least = step / 2 * np.median(np.linalg.norm(rates[:, :3], axis=1))
    assert message.params["shift"] >= least


@pytest.mark.parametrize("step", [0.01, 1.0])
def test_the_time_resolution_of_points_in_short_bursts(folder: Path, step: float) -> None:
    """A board is scanned for 2 ms in each turn of 53 ms."""
    turns = START + 2 + 0.053 * np.arange(180)
    times = (turns[:, None] + np.linspace(0, 0.002, 20)).ravel()
    rounded = np.round(times / step) * step
    survey = open_lines(folder, las(folder / "L1.laz", rounded, fan(len(times))))
    assert by_code(survey)["audit.time_resolution"].params["step"] == pytest.approx(step)


def test_simultaneous_returns_and_lasers_are_not_reported_as_coarse_times(folder: Path) -> None:
    shots = np.repeat(START + np.arange(2, 12, 0.002), 2)
    returns = np.tile([1, 2], len(shots) // 2)
    path = las(
        folder / "L1.laz", shots, fan(len(shots)) * np.where(returns == 1, 1.0, 1.1)[:, None],
        return_number=returns, number_of_returns=np.full(len(shots), 2),
    )  # fmt: skip
    lasers = np.repeat(START + np.arange(2, 12, 5e-5 * 32), 32)[:60_000]
    spin = fan(len(lasers)) + 0.01 * (np.arange(len(lasers)) % 32)[:, None]
    fast = las(folder / "L2.laz", START + 2 + (lasers - START - 2) / 32, spin)
    assert open_lines(folder, path, fast).messages == ()


# -- duplicate points and lines -------------------------------------------------------------------


@every_format
@pytest.mark.parametrize("how", ["each twice", "appended", "packet again"])
def test_duplicate_points_are_excluded_and_counted(folder: Path, name: str, how: str) -> None:
    order = {
        "each twice": np.repeat(np.arange(POINT_COUNT), 2),
        "appended": np.tile(np.arange(POINT_COUNT), 2),
        "packet again": np.concatenate([np.arange(2000), np.arange(1500, POINT_COUNT)]),
    }[how]
    points = fan(POINT_COUNT)
    survey = open_lines(folder, WRITERS[name](folder / name, TIMES[order], points[order]))
    assert by_code(survey)["audit.duplicates"].params["count"] == len(order) - POINT_COUNT
    points_lidar, times = survey.scans["L1"].take(np.arange(POINT_COUNT))
    np.testing.assert_allclose(times, TIMES, atol=1e-6)
    np.testing.assert_allclose(points_lidar, points, atol=1e-4)


@LONG
def test_distant_duplicates_are_excluded(folder: Path) -> None:
    """A duplicate follows after more points than the table of recent points holds."""
    count = 200_000
    times = START + np.linspace(2, 12, count)
    points = fan(count) + np.arange(count)[:, None] * 1e-4
    path = las(folder / "L1.las", np.tile(times, 2), np.tile(points, (2, 1)))
    survey = open_lines(folder, path)
    assert by_code(survey)["audit.duplicates"].params["count"] == count
    assert len(survey.scans["L1"]) == count
    stored = stored_survey(folder)
    assert len(stored.scans["L1"]) == count
    assert stored.scans["L1"].fingerprint == survey.scans["L1"].fingerprint


def stored_survey(folder: Path) -> Survey:
    """Import the lines of the project and return its survey."""
    project = open_project(folder.parent / "project")
    import_lines(project)
    return load_survey(project)


def test_lines_with_points_in_common_are_named(folder: Path) -> None:
    points = fan(POINT_COUNT)
    one = las(folder / "one.laz", TIMES, points)
    copy = text(folder / "copy.csv", TIMES[: POINT_COUNT // 2], points[: POINT_COUNT // 2])
    same = las(folder / "same.laz", TIMES, points)
    half = las(folder / "half.laz", TIMES[: POINT_COUNT // 3], points[: POINT_COUNT // 3])
    survey = open_lines(folder, one, same, half)
    found = [each.params for each in survey.messages if each.code == "audit.shared_points"]
    pairs = {frozenset((str(each["line"]), str(each["other"]))) for each in found}
    assert pairs == {
        frozenset(pair) for pair in (("one", "same"), ("one", "half"), ("same", "half"))
    }
    assert all(each["share"] == pytest.approx(1.0) for each in found)
    assert {str(p["smaller"]) for p in found if "half" in (p["line"], p["other"])} == {"half"}
    assert copy.exists()


@pytest.mark.parametrize("name", ["copy.laz", "copy.csv", "copy.ply"])
def test_lines_that_overlap_in_time_are_named(folder: Path, name: str) -> None:
    """A line with rounded coordinates overlaps in time; a later line does not."""
    points = fan(POINT_COUNT)
    one = las(folder / "one.laz", TIMES, points)
    copy = WRITERS[f"L1{Path(name).suffix}"](
        folder / name, TIMES[1000:] + 1e-6, np.round(points[1000:], 2)
    )
    after = las(folder / "after.laz", TIMES + 10.001, points)
    survey = open_lines(folder, one, copy, after)
    found = [each for each in survey.messages if each.code == "audit.same_time"]
    assert [(each.params["line"], each.params["other"]) for each in found] == [("copy", "one")]
    assert found[0].params["seconds"] == pytest.approx(TIMES[-1] - TIMES[1000], abs=2)
    assert found[0].level is Level.WARNING
    assert stored_survey(folder).messages == survey.messages


def test_lines_split_by_scanner_overlap_in_time(folder: Path) -> None:
    values = (np.arange(POINT_COUNT) % 2).astype(np.uint8)
    path = las(folder / "L1.laz", TIMES, fan(POINT_COUNT), point_source_id=values)
    assert "audit.same_time" in by_code(import_split(folder, path, "point_source_id"))


def test_the_estimated_fraction_of_shared_points_is_accurate() -> None:
    rng = np.random.default_rng(3)
    points = rng.normal(size=(300_000, 3))
    times = np.sort(rng.uniform(0, 100, len(points)))
    audits = []
    for rows in (slice(0, 200_000), slice(150_000, 300_000), slice(200_000, 300_000)):
        screen = PointScreen(PointSelection(), ranged=True)
        screen(times[rows], points[rows], {})
        audits.append(screen.result())
    assert shared_point_fraction(audits[0], audits[1]) == pytest.approx(1 / 3, abs=0.03)
    assert shared_point_fraction(audits[0], audits[2]) == 0.0
    assert shared_point_fraction(audits[1], audits[2]) == pytest.approx(1.0, abs=0.01)
    assert shared_point_fraction(audits[0], LineAudit(0)) == 0.0


# -- points that cannot be used -------------------------------------------------------------------


@every_format
def test_points_without_range_not_finite_or_too_far_are_excluded(folder: Path, name: str) -> None:
    points = fan(POINT_COUNT)
    points[::7] = 0.0
    points[3] = [0.0, 2e5, 0.0]  # one such point does not make the frame georeferenced
    expected = {"no_range": len(points[::7]), "too_far": 1}
    if name != "L1.laz":  # LAS cannot store such coordinates
        points[5, 1], points[6, 2] = np.nan, np.inf
        expected["not_finite"] = 2
    survey = open_lines(folder, WRITERS[name](folder / name, TIMES, points))
    found = by_code(survey)
    assert {code.removeprefix("audit.") for code in found} == set(expected)
    for code, count in expected.items():
        assert found[f"audit.{code}"].params["count"] == count
        assert found[f"audit.{code}"].level is Level.NOTE
    assert len(survey.scans["L1"]) == POINT_COUNT - sum(expected.values())
    assert survey.excluded == {"L1": sum(expected.values())}


@every_format
@pytest.mark.parametrize("value", [-9999.0, -999.0, 655.35])
def test_points_with_one_value_for_all_coordinates_are_excluded(
    folder: Path, name: str, value: float
) -> None:
    """Seven per cent of the points; the frame of the file remains that of the scanner."""
    points = fan(POINT_COUNT)
    points[::14] = value
    path = WRITERS[name](folder / name, TIMES, points)
    (check, *_) = check_file(path)
    assert check.finding is not None
    assert check.finding.choice["frame"] == "scanner"
    assert not check.finding.file_warnings
    survey = open_lines(folder, path)
    found = by_code(survey)
    assert set(found) == {"audit.no_range"}
    assert found["audit.no_range"].params["count"] == len(points[::14])


@LONG
def test_distant_points_on_the_map_are_excluded(folder: Path) -> None:
    survey = open_lines(folder, las(folder / "L1.laz", TIMES, fan(POINT_COUNT)))
    project = open_project(folder.parent / "project")
    (written,) = georeference_project(project, folder / "out", "prior", system="EPSG:32618")
    cloud = laspy.read(written.path)
    cloud.x[7], cloud.y[8], cloud.z[9] = cloud.x[7] - 9e4, cloud.y[8] + 9e4, 12_000.0
    cloud.write(written.path)
    options = (("frame", "georeferenced"), ("crs", "EPSG:32618"))
    line = LineSource("map", written.path, (), Reading("las", options))
    again = replace(project, folder=folder.parent / "again", lines=(line,))
    again.folder.mkdir()
    read = load_survey(again)
    assert by_code(read)["audit.too_far"].params["count"] == 3
    assert len(read.scans["map"]) == POINT_COUNT - 3
    points, _ = read.scans["map"].take(np.arange(POINT_COUNT - 3))
    raw, _ = survey.scans["L1"].take(np.setdiff1d(np.arange(POINT_COUNT), [7, 8, 9]))
    np.testing.assert_allclose(points, raw, atol=3e-4)
    (back,) = georeference_project(again, folder / "back", "prior", system="EPSG:32618")
    assert (back.points, back.excluded) == (POINT_COUNT - 3, 3)


def test_points_without_range_are_excluded_with_a_range_offset(folder: Path) -> None:
    points = fan(POINT_COUNT)
    points[::10] = 0.0
    open_lines(folder, las(folder / "L1.laz", TIMES, points))
    project = open_project(folder.parent / "project")
    project = project.with_settings(replace(project.settings, range_offset=0.03))
    (written,) = georeference_project(project, folder / "out", "prior", system="EPSG:32618")
    assert written.points == POINT_COUNT - len(points[::10])
    assert np.isfinite(laspy.read(written.path).xyz).all()


# -- flags, classes, selection --------------------------------------------------------------------


def test_withheld_points_are_excluded_unless_they_are_kept(folder: Path) -> None:
    withheld = (np.arange(POINT_COUNT) % 5 == 0).astype(np.uint8)
    path = las(folder / "L1.laz", TIMES, fan(POINT_COUNT), withheld=withheld)
    survey = open_lines(folder, path)
    assert by_code(survey)["audit.withheld"].params["count"] == withheld.sum()
    assert len(survey.scans["L1"]) == POINT_COUNT - withheld.sum()
    kept = load_survey(with_options(folder, ("withheld", "keep")))
    assert kept.messages == ()
    assert len(kept.scans["L1"]) == POINT_COUNT


def with_options(folder: Path, *options: tuple[str, str]) -> Project:
    """Return the project with options for its first line."""
    project = open_project(folder.parent / "project")
    first = project.lines[0]
    format = first.reading.format or "las"
    reading = Reading(format, (*first.reading.options, *options))
    return replace(project, lines=(replace(first, reading=reading), *project.lines[1:]))


def test_noise_classes_are_a_warning_and_can_be_excluded(folder: Path) -> None:
    classes = np.where(np.arange(POINT_COUNT) % 100 == 0, 7, 2).astype(np.uint8)
    classes[:10] = 18
    survey = open_lines(
        folder, las(folder / "L1.laz", TIMES, fan(POINT_COUNT), classification=classes)
    )
    message = by_code(survey)["audit.noise_classes"]
    noise = np.isin(classes, (7, 18))
    assert message.level is Level.WARNING
    assert message.params["count"] == noise.sum()
    (action,) = message.actions
    option = (action.params["name"], action.params["value"])
    excluded = load_survey(with_options(folder, option))
    assert by_code(excluded)["audit.of_classes"].params["count"] == noise.sum()
    assert len(excluded.scans["L1"]) == POINT_COUNT - noise.sum()


@every_format
def test_points_are_selected_by_attribute_and_time(folder: Path, name: str) -> None:
    ring = (np.arange(POINT_COUNT) % 4).astype(np.uint8)
    key = "user_data" if name == "L1.laz" else "ring"
    path = WRITERS[name](folder / name, TIMES, fan(POINT_COUNT), **{key: ring})
    middle = START + 7
    only = f"{key}=1:2 time={middle!r}:1e9"
    survey = open_lines(folder, path, options=(("only", only),))
    chosen = np.isin(ring, (1, 2)) & (middle <= TIMES)
    assert len(survey.scans["L1"]) == chosen.sum()
    assert by_code(survey)["audit.not_selected"].params["count"] == POINT_COUNT - chosen.sum()


# -- several scanners or passes -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "attribute", "code"),
    [
        ("L1.laz", "scanner_channel", "several_scanners"),
        ("L1.laz", "user_data", "several_sources"),
        ("L1.laz", "point_source_id", "several_sources"),
        ("L1.csv", "scanner", "several_scanners"),
        ("L1.ply", "head_id", "several_scanners"),
    ],
)
def test_several_scanners_in_one_file_are_named(
    folder: Path, name: str, attribute: str, code: str
) -> None:
    values = (np.arange(POINT_COUNT) % 2).astype(np.uint8)
    survey = open_lines(
        folder, WRITERS[name](folder / name, TIMES, fan(POINT_COUNT), **{attribute: values})
    )
    message = by_code(survey)[f"audit.{code}"]
    assert message.params["attribute"] == attribute
    assert message.params["values"] == ("0", "1")
    assert message.level is Level.WARNING


def test_rings_are_not_reported_as_several_scanners(folder: Path) -> None:
    rings = (np.arange(POINT_COUNT) % 32).astype(np.uint8)
    assert (
        open_lines(
            folder, las(folder / "L1.laz", TIMES, fan(POINT_COUNT), user_data=rings)
        ).messages
        == ()
    )


def test_imported_lines_have_the_same_messages(folder: Path) -> None:
    points = fan(POINT_COUNT)
    points[::7] = 0.0
    channel = (np.arange(POINT_COUNT) % 2).astype(np.uint8)
    path = las(
        folder / "L1.laz", np.round(TIMES, 1), points, scanner_channel=channel, user_data=channel
    )
    survey = open_lines(folder, path)
    stored = stored_survey(folder)
    assert stored.messages == survey.messages
    assert {m.code for m in stored.messages} == {
        "audit.time_resolution", "audit.no_range", "audit.several_scanners",
        "audit.several_sources",
    }  # fmt: skip
    assert stored.scans["L1"].fingerprint == survey.scans["L1"].fingerprint


# -- splitting ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "by"),
    [("L1.laz", "point_source_id"), ("L1.laz", "scanner_channel"), ("L1.csv", "head")],
)
def test_a_file_is_split_into_lines_by_an_attribute(folder: Path, name: str, by: str) -> None:
    values = np.where(TIMES < START + 7, 1, 2).astype(np.uint8)
    path = WRITERS[name](folder / name, TIMES, fan(POINT_COUNT), **{by: values})
    survey = import_split(folder, path, by)
    assert survey.lines == ("L1_1", "L1_2")
    assert [len(survey.scans[line]) for line in survey.lines] == [
        np.count_nonzero(values == value) for value in (1, 2)
    ]
    assert not {"audit.several_scanners", "audit.several_sources"} & set(by_code(survey))
    assert survey.scans["L1_1"].last_time < survey.scans["L1_2"].first_time


def import_split(folder: Path, path: Path, by: str) -> Survey:
    _, survey = new_project(
        folder.parent / "project", trajectory=folder / "pos.sbet",
        accuracy=folder / "smrmsg.out", lines=[LineSource("L1", path)], settings=Settings(LEVER),
        split_by=by,
    )  # fmt: skip
    return survey


@every_format
def test_a_file_is_split_into_lines_at_pauses(folder: Path, name: str) -> None:
    times = np.concatenate([START + np.linspace(2, 8, 1000), START + np.linspace(20, 30, 1500)])
    path = WRITERS[name](folder / name, times, fan(len(times)))
    survey = import_split(folder, path, "gap")
    assert survey.lines == ("L1_1", "L1_2")
    assert [len(survey.scans[line]) for line in survey.lines] == [1000, 1500]
    stored = stored_survey(folder)
    assert [len(stored.scans[line]) for line in stored.lines] == [1000, 1500]


@pytest.mark.parametrize("period", [3600.0, 86_400.0, 604_800.0])
@pytest.mark.parametrize(("pause", "passes"), [(0.0, 0), (200.0, 2)])
def test_a_time_rollover_is_not_a_pause(
    folder: Path, period: float, pause: float, passes: int
) -> None:
    """A pause after the rollover is detected."""
    before, after = np.linspace(-30, -0.01, 1500), np.linspace(0.01, 20, 1000)
    later = after[-1] + pause + np.linspace(0.02, 15, 500)
    times = np.mod(np.concatenate([before, after, later]), period)
    path = las(folder / "L1.laz", times, fan(len(times)))
    messages = audit_file(path, format_of("las"), {}).messages
    counts = [each.params["count"] for each in messages if each.code == "audit.several_passes"]
    assert counts == [passes] * bool(passes)


def test_several_passes_with_a_turn_between_them_are_reported(folder: Path) -> None:
    records = np.fromfile(folder / "pos.sbet").reshape(-1, 17)
    turned = records[:, 0] > START + 15
    records[turned, 9] += np.pi * np.minimum(1, (records[turned, 0] - START - 15) / 3)
    records.tofile(folder / "pos.sbet")
    times = np.concatenate([START + np.linspace(2, 8, 1000), START + np.linspace(20, 30, 1500)])
    survey = open_lines(folder, las(folder / "L1.laz", times, fan(len(times))))
    assert by_code(survey)["audit.several_passes"].params["count"] == 2


@pytest.mark.parametrize("states_between", [True, False])
@pytest.mark.parametrize(("way", "passes"), [("on", 0), ("round", 2), ("back to the start", 2)])
def test_a_long_pause_ends_a_pass_if_the_vessel_turned_or_went_back(
    states_between: bool, way: str, passes: int
) -> None:
    """With trajectory states during the pause, or without them."""
    time = np.arange(0.0, 120.0, 0.05)
    north, heading = 2.0 * time, np.zeros(len(time))
    if way == "round":
        heading = 2 * np.pi * np.clip((time - 40) / 40, 0, 1)
    if way != "on":
        north = np.where(time > 80, 2.0 * (time - 80), np.clip(2.0 * time, 0, 80))
    position = np.stack([north, 0 * time, 0 * time], axis=1)
    attitude = np.stack([0 * time, 0 * time, heading], axis=1)
    kept = np.ones(len(time), bool) if states_between else (time <= 20) | (time >= 100)
    track = LocalTrajectory(
        LocalFrame(0.8, -1.2, 0.0), time[kept], position[kept], attitude[kept], 1.5
    )
    audit = LineAudit(1000, spans=[[0.0, 20.0], [100.0, 119.0]])
    own = np.concatenate([np.linspace(0.0, 19.9, 50), np.linspace(100.0, 118.9, 50)])
    found = [
        each.params["count"]
        for each in line_messages("L1", audit, track, own)
        if each.code == "audit.several_passes"
    ]
    assert found == [passes] * bool(passes)
