"""Tests of the comparison of lines with a static scan or with surveyed points."""

import json
from dataclasses import replace
from pathlib import Path
from typing import cast

import laspy
import numpy as np
import pytest
from pyproj import CRS

from lispac.errors import InputError, NotComparable, ProjectError
from lispac.geometry.frames import LocalFrame
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.language import to_plain_text
from lispac.message_texts import english_text
from lispac.messages import Message, error, note, warning
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.present.json_values import json_values
from lispac.project import Project
from lispac.report.absolute_figure import reference_distance_figure
from lispac.report.document import report_document
from lispac.report.document_blocks import Table
from lispac.report.figures import svg_of
from lispac.report.json_report import json_text
from lispac.simulation.port_scene import LOCAL_ORIGIN
from lispac.simulation.simulated_survey import SimulatedSurvey, port_survey
from lispac.survey.crs import coordinate_system
from lispac.validation.absolute_check import AbsoluteCheck, LineCheck
from lispac.workflow.checking.absolute_check import check_absolute
from lispac.workflow.project.survey import Survey
from tests.cli.test_cli import run, run_json
from tests.conftest import DEMO_PULSES
from tests.documents.schemas import followed
from tests.support.absolute_sample import (
    check_against_points,
    project_with_true_boresight,
    true_offsets,
)
from tests.support.command_errors import is_refusal, refused_with
from tests.support.long_runs import LONG, others_long
from tests.support.report_sample import FULL_REPORT, sample_content, sample_project
from tests.support.static_scans import on_plane, tripod_scan, write_pts

SHIFTS = (0.0, 0.005, 0.020)


@pytest.fixture(scope="module")
def truth() -> SimulatedSurvey:
    return port_survey(points_per_second=DEMO_PULSES)


@pytest.fixture(scope="module")
def sample(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("sample"))


@pytest.fixture(scope="module")
def known(denser_project: Project, sample: Project) -> tuple[Project, Survey]:
    return project_with_true_boresight(denser_project, sample)


@pytest.fixture(scope="module")
def both(known: tuple[Project, Survey], tmp_path_factory: pytest.TempPathFactory) -> AbsoluteCheck:
    """Check against one scan of a near plane, dense with points, and a far one."""
    path = tmp_path_factory.mktemp("both") / "both.xyz"
    return check_against_points(known, path, near_and_far())


def near_and_far() -> np.ndarray:
    return np.concatenate([tripod_scan((name,)) for name in ("V1", "V5")])


@LONG
@pytest.mark.parametrize("shift", others_long(SHIFTS, lambda shift: shift == 0.020))
def test_a_known_shift_of_a_scan_is_measured(
    known: tuple[Project, Survey], truth: SimulatedSurvey, tmp_path: Path, shift: float
) -> None:
    """V5 faces west, the direction of the shift: its lines lie farther away by the shift."""
    expected = true_offsets(truth, known[1], "V5")
    scan = tripod_scan(("V5",), shift=(0.0, shift, 0.0))
    check = check_against_points(known, tmp_path / "scan.xyz", scan)
    assert {line.line for line in check.lines} <= set(expected)
    assert len(check.lines) >= 2
    for line in check.lines:
        off = expected[line.line] - shift
        assert line.after.signed.mean == pytest.approx(off, abs=0.001)
        # The 95 % interval of the mean contains the shift: 12 mm of the POS, 5 mm of the reference.
        assert abs(line.after.signed.mean + shift) <= line.after.interval_95
    assert check.all_lines.before.distances.rms > 5 * check.all_lines.after.distances.rms
    mean = check.all_lines.after.mean_sigma
    assert mean.reference == 0.005
    assert mean.scatter < 0.001


def test_offsets_larger_than_the_given_sigmas_are_significant(
    known: tuple[Project, Survey], tmp_path: Path
) -> None:
    check = check_against_points(
        known, tmp_path / "s.xyz", tripod_scan(("V5",), shift=(0.0, 0.08, 0.0))
    )
    assert check.all_lines.after.significant
    assert all(line.after.significant for line in check.lines)
    mean, _, lines, *_ = AbsoluteCheckValues.of(check).messages
    assert mean.code == "absolute.after_farther"
    assert mean.params["finding"] == note("absolute.not_explained")
    assert (lines.code, lines.params["count"]) == ("report.absolute_line_off", len(check.lines))


def test_the_sources_of_the_sigma_of_the_mean(
    known: tuple[Project, Survey], tmp_path: Path
) -> None:
    """V5 faces west: only the west position sigma counts; the attitude counts by its lever arm."""
    check = check_against_points(known, tmp_path / "s.xyz", tripod_scan(("V5",)), sigma=0.01)
    _, survey = known
    for line in check.lines:
        position, attitude = survey.accuracy.at(np.array([survey.scans[line.line].first_time]))
        parts = line.after.mean_sigma
        assert parts.position == pytest.approx(position[0, 1], rel=0.01)
        # Heading moves the point along the normal by its distance fore or aft of the POS, roll
        # by its height above the POS: less than the distance times the largest of the sigmas.
        assert 0.0 < parts.attitude < 60.0 * attitude.max()
        assert parts.boresight is not None
        assert line.before.mean_sigma.boresight is None
        assert parts.total == pytest.approx(
            np.sqrt(0.01**2 + parts.position**2 + parts.attitude**2 + parts.boresight**2), rel=1e-3
        )
        assert line.after.reference_share == pytest.approx(
            min(1.0, (0.01 / line.after.distances.rms) ** 2)
        )


@LONG
def test_errors_average_out_between_lines_far_apart_in_time_only(
    known: tuple[Project, Survey], tmp_path: Path
) -> None:
    project, survey = known
    sigmas = []
    for seconds in (1e-3, 1e9):
        settings = replace(project.settings, position_time=seconds, attitude_time=seconds)
        one = (replace(project, settings=settings), survey)
        check = check_against_points(one, tmp_path / "s.xyz", tripod_scan(("V5",)))
        share = 1.0 / len(check.lines)
        own = np.array([line.after.mean_sigma.position for line in check.lines])
        sigmas.append((check.all_lines.after.mean_sigma.position, share, own))
    apart, share, own = sigmas[0]
    assert apart == pytest.approx(np.linalg.norm(share * own), rel=0.01)
    near, share, own = sigmas[1]
    assert near == pytest.approx(np.sum(share * own), rel=0.01)


@LONG
def test_a_near_plane_takes_no_places_from_a_far_one(
    known: tuple[Project, Survey], both: AbsoluteCheck, tmp_path: Path
) -> None:
    """The places of a line do not depend on the other plane, and all lines weigh the same."""
    alone: dict[str, list[LineCheck]] = {}
    for name in ("V1", "V5"):
        for line in check_against_points(
            known, tmp_path / f"{name}.xyz", tripod_scan((name,))
        ).lines:
            alone.setdefault(line.line, []).append(line)
    found = {line.line: line for line in both.lines}
    assert set(found) == set(alone)
    for name, apart in alone.items():
        counts = [line.after.signed.n for line in apart]
        assert found[name].after.signed.n == sum(counts)
        mean = np.average([line.after.signed.mean for line in apart], weights=counts)
        assert found[name].after.signed.mean == pytest.approx(mean, abs=1e-4)
    together = both.all_lines.after
    assert together.signed.n == sum(line.after.signed.n for line in both.lines)
    means = [line.after.signed.mean for line in both.lines]
    assert together.signed.mean == pytest.approx(np.mean(means))
    squares = [line.after.distances.rms**2 for line in both.lines]
    assert together.distances.rms == pytest.approx(np.sqrt(np.mean(squares)))
    scatters = [line.after.mean_sigma.scatter for line in both.lines]
    assert together.mean_sigma.scatter == pytest.approx(np.linalg.norm(scatters) / len(scatters))
    assert AbsoluteCheckValues.of(both).messages[-1].code == "absolute.lines_alike"


@LONG
def test_a_line_that_is_not_compared_has_a_suggested_action(
    known: tuple[Project, Survey], tmp_path: Path
) -> None:
    scan = check_against_points(known, tmp_path / "s.xyz", tripod_scan(("V5",)))
    assert scan.not_compared
    (tmp_path / "p.csv").write_text("A,{},{},{}\n".format(*on_plane("V5", *np.zeros((2, 1)))[0]))
    project, _ = check_absolute(*known, tmp_path / "p.csv")
    assert project.absolute is not None
    assert project.absolute.not_compared
    for reason, check in (
        (error("check.no_reference_near", distance=1.0), scan),
        (error("check.no_surveyed_point_near", distance=1.0), project.absolute),
    ):
        lines = set(known[1].clouds) - {line.line for line in check.lines}
        codes = [each.code for each in check.not_compared]
        assert codes == ["check.line_not_compared"] * len(lines)
        assert {each.params["line"] for each in check.not_compared} == lines
        assert all(each.params["reason"] == reason for each in check.not_compared)
    # A patch with enough places on near lines and too few on far ones.
    patch = tripod_scan(("V5",), density=2000.0)
    patch = patch[np.linalg.norm(patch - on_plane("V5", *np.zeros((2, 1))), axis=1) < 1.6]
    small = check_against_points(known, tmp_path / "few.xyz", patch)
    assert {line.line for line in small.lines} == {"L1_000", "L2_180"}
    (found,) = (each for each in small.not_compared if each.params["line"] == "L3_045")
    reason = found.params["reason"]
    assert isinstance(reason, Message)
    assert (reason.code, reason.params["least"]) == ("check.few_places", 30)
    assert cast(int, reason.params["places"]) <= cast(int, reason.params["tried"]) < 30


def test_a_sigma_in_millimetres_gives_one_warning(
    known: tuple[Project, Survey], tmp_path: Path
) -> None:
    path = tmp_path / "p.csv"
    where = on_plane("V5", np.array([0.0, 0.1, 0.2]), np.zeros(3))

    def noted(*sigmas: str) -> list[Message]:
        rows = [f"A{k},{x[0]},{x[1]},{x[2]},{sigmas[k]}" for k, x in enumerate(where)]
        path.write_text("name,north,west,up,sigma\n" + "\n".join(rows))
        _, notes = check_absolute(*known, path)
        return [each for each in notes if each.code.startswith("reference.")]

    assert noted("0.003", "0.2", "") == []
    (found,) = noted("0.003", "3", "4")
    assert found == warning("reference.large_sigma", count=2, name="A1", sigma=3.0, limit=0.2)


def test_surveyed_points_and_planes(
    known: tuple[Project, Survey], sample: Project, truth: SimulatedSurvey, tmp_path: Path
) -> None:
    expected = true_offsets(truth, known[1], "V1")
    corner = np.array([-0.4, 0.4, 0.4, -0.4])
    plane = on_plane("V1", corner, np.array([-0.4, -0.4, 0.4, 0.4])) + (0.0, 0.01, 0.0)
    alone = on_plane("V1", np.zeros(2), np.array([-0.2, 0.1])) + (0.0, 0.01, 0.0)
    rows = ["name,north,west,up,sigma,plane"]
    rows += [f"B{k},{x[0]},{x[1]},{x[2]},0.004,BOARD" for k, x in enumerate(plane)]
    rows += [f"A{k},{x[0]},{x[1]},{x[2]},0.003," for k, x in enumerate(alone)]
    rows.append("AWAY,0,40,3,0.003,")
    path = tmp_path / "points.csv"
    path.write_text("\n".join(rows))
    project, notes = check_absolute(*known, path)
    check = project.absolute
    assert check is not None
    (columns,) = [each for each in notes if each.code == "assumed.columns_as_named"]
    assert columns.params["columns"][-2:] == (note("list_column.sigma"), note("list_column.plane"))
    assert check.kind == "points"
    found = {point.name: point for point in check.points}
    assert set(found) == {"BOARD", "A0", "A1"}
    assert note("check.points_not_compared", distance=1.0, points=["AWAY"]) in check.not_compared
    # Four points of 4 mm each determine a plane with 2 mm at their centroid.
    assert found["BOARD"].sigma == pytest.approx(0.002, rel=1e-6)
    assert found["A0"].sigma == 0.003
    distances = [expected[line.line] for line in check.lines]
    assert found["BOARD"].lines == len(distances)
    assert found["BOARD"].after == pytest.approx(np.mean(distances) - 0.01, abs=0.001)
    for name in ("A0", "A1"):
        assert 2 <= found[name].lines <= len(distances)
        assert min(distances) - 0.012 <= found[name].after <= max(distances) - 0.008
    assert check.all_lines.before.distances.rms > 2 * check.all_lines.after.distances.rms

    content = sample_content(sample.with_absolute(check))
    (section,) = (
        s
        for s in report_document(content, {}, FULL_REPORT).sections
        if s.title == "Check against the reference"
    )
    (listed,) = (b for b in section.blocks if isinstance(b, Table) and "surveyed points" in b.title)
    assert [row[0] for row in listed.rows] == ["A0", "A1", "BOARD"]
    assert listed.rows[2][2] == "2.0"
    assert listed.rows[2][4].replace("\N{MINUS SIGN}", "-") == f"{1000 * found['BOARD'].after:+.1f}"


@LONG
def test_a_scan_in_map_coordinates_without_times_is_compared(
    known: tuple[Project, Survey], both: AbsoluteCheck, tmp_path: Path
) -> None:
    scan, local = near_and_far(), both
    crs = CRS.from_epsg(32618)
    header = laspy.LasHeader(version="1.2", point_format=0)
    header.scales, header.offsets = np.full(3, 1e-5), np.array([600_000.0, 5_041_000.0, 0.0])
    header.add_crs(crs)
    las = laspy.LasData(header)
    las.xyz = coordinate_system("EPSG:32618").from_local(scan, LocalFrame(*LOCAL_ORIGIN))
    path = tmp_path / "scan.laz"
    las.write(path)
    project, _ = check_absolute(*known, path)
    mapped = project.absolute
    assert mapped is not None
    assert "UTM zone 18N" in mapped.system
    for one, other in zip(local.lines, mapped.lines, strict=True):
        assert other.after.signed.mean == pytest.approx(one.after.signed.mean, abs=2e-4)
    # The user's system overrides that of the file; a scan far from the survey is refused.
    with pytest.raises(InputError) as raised:
        check_absolute(*known, path, crs="EPSG:32619")
    assert raised.value.code == "coordinates.too_far"


@pytest.mark.parametrize(
    ("name", "text", "code"),
    [
        ("p.csv", "name,north,west,up,plane\na,1,2,3,P\nb,2,2,3,P\n", "check.few_plane_points"),
        (
            "p.csv",
            "name,north,west,up,plane\na,1,2,3,P\nb,2,2,3,P\nc,3,2,3,P\n",
            "check.points_in_one_row",
        ),
        ("p.csv", "name,north,west,up,sigma\na,1,2,3,-1\n", "seeds.invalid_sigma"),
        ("p.csv", "a,1,2\n", "seeds.too_few_numbers"),
        ("p.ply", "ply\n", "static_scan.other_format"),
        ("p.csv", "a,90000,2,3\n", "coordinates.too_far_local"),
    ],
)
def test_unusable_references_are_refused(
    known: tuple[Project, Survey], tmp_path: Path, name: str, text: str, code: str
) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(InputError) as raised:
        check_absolute(*known, tmp_path / name)
    assert is_refusal(raised.value, code)


def test_the_format_of_the_reference_does_not_matter(
    known: tuple[Project, Survey], tmp_path: Path
) -> None:
    scan = near_and_far().round(5)
    header = laspy.LasHeader(version="1.2", point_format=0)
    header.scales, header.offsets = np.full(3, 1e-5), np.zeros(3)
    las = laspy.LasData(header)
    las.xyz = scan
    las.write(tmp_path / "scan.las")
    half = len(scan) // 2
    write_pts(tmp_path / "scan.pts", [scan[:half], scan[half:]])
    expected = check_against_points(known, tmp_path / "scan.xyz", scan)
    for name in ("scan.las", "scan.pts"):
        found = check_absolute(*known, tmp_path / name)[0].absolute
        assert found is not None
        assert [line.line for line in found.lines] == [line.line for line in expected.lines]
        for one, other in zip(found.lines, expected.lines, strict=True):
            assert one.after.distances.n == other.after.distances.n
            assert one.after.signed.mean == pytest.approx(other.after.signed.mean, abs=1e-9)
            assert one.after.interval_95 == pytest.approx(other.after.interval_95, abs=1e-9)
            assert one.before.distances.rms == pytest.approx(other.before.distances.rms, abs=1e-9)


def test_points_that_no_line_shows_and_a_missing_result_are_refused(
    known: tuple[Project, Survey], tmp_path: Path
) -> None:
    (tmp_path / "p.csv").write_text("a,0,30,3\n")
    with pytest.raises(NotComparable) as refused:
        check_absolute(*known, tmp_path / "p.csv")
    assert refused.value.code == "check.no_flat_place"
    project, survey = known
    with pytest.raises(ProjectError) as raised:
        check_absolute(replace(project, result=None), survey, tmp_path / "p.csv")
    assert raised.value.code == "estimate.needed"


def test_the_project_stores_the_check_and_the_report_shows_it(
    sample: Project, both: AbsoluteCheck, tmp_path: Path
) -> None:
    check = both
    project = replace(sample, folder=tmp_path / "p").with_absolute(check)
    write_project(project)
    again = read_project(project.folder)
    assert again.absolute == check
    assert again.result is not None
    assert again.with_result(again.result).absolute is None
    content = sample_content(again)
    assert content.files[-1].sha256 == check.sha256
    assert followed(json_text(content))["absolute"]["reference"] == check.reference
    (section,) = (
        s
        for s in report_document(content, {}, FULL_REPORT).sections
        if s.title == "Check against the reference"
    )
    tables = [block for block in section.blocks if isinstance(block, Table)]
    shown = tables[0].rows[-1]
    together = check.all_lines.after
    assert shown[:3] == ("all lines", "after", f"{together.signed.n:,}")
    assert shown[3].replace("\N{MINUS SIGN}", "-") == f"{1000 * together.signed.mean:+.1f}"
    assert shown[6] == f"{1000 * together.distances.rms:.1f}"
    assert content.absolute is not None
    assert len(svg_of(reference_distance_figure(content.absolute))) > 1000
    # A file of an earlier version has no such entry, and the report has no such section.
    path = project.folder / PROJECT_FILE_NAME
    stored = json.loads(path.read_text())
    del stored["absolute"]
    path.write_text(json.dumps(stored))
    without_check = read_project(project.folder)
    assert without_check.absolute is None
    titles = [
        s.title for s in report_document(sample_content(without_check), {}, FULL_REPORT).sections
    ]
    assert "Check against the reference" not in titles


@LONG
def test_the_command(
    capsys: pytest.CaptureFixture[str], known: tuple[Project, Survey], tmp_path: Path
) -> None:
    project = replace(known[0], folder=tmp_path / "p")
    write_project(project)
    path = tmp_path / "s.xyz"
    np.savetxt(path, tripod_scan(("V5",)), fmt="%.5f")
    found = run_json(capsys, "check", project.folder, "--reference", path)
    check = read_project(project.folder).absolute
    assert check is not None
    values = json.loads(json.dumps(json_values(AbsoluteCheckValues.of(check))))
    assert found == {"schema_version": 1, **values}
    code, out, err = run(capsys, "check", project.folder, "--reference", path)
    assert code == 0
    assert english_text(note("assumed.local_frame")) in err
    for message in found["messages"]:
        assert to_plain_text(message["text"]) in out
    assert read_project(project.folder).absolute == check
    none = tmp_path / "none.laz"
    words = ("check", project.folder, "--reference", none)
    refused_with("file.not_found", *words, file=str(none))
