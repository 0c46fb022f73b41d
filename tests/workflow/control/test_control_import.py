"""Tests of control from its file to the result: import, assignment, storage, commands, scripts."""

import json
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import lispac
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.control_points import (
    ControlFile,
    ControlPoint,
    control_observations,
    with_control_use,
    without_control_file,
)
from lispac.duplicate_targets import single_line_notes
from lispac.errors import InputError, LispacError, ProjectError, RankDeficient
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.present.calibration.control import ControlValues
from lispac.project import Project
from lispac.workflow.calibration.edits import (
    set_line_use,
    set_sighting_use,
    set_target_use,
    with_renamed_target,
    with_switched_role,
)
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.control.control_assignment import (
    is_assignment_current,
    with_assigned_control,
)
from lispac.workflow.control.control_import import import_control
from lispac.workflow.output.script import script_of
from lispac.workflow.project.survey import Survey
from tests.support.few_lines import on_board, picked, site_of_few_lines
from tests.support.long_runs import LONG, others_long

CORNERS = ((-0.4, -0.3), (-0.4, 0.3), (0.4, -0.3), (0.4, 0.3))
SIGMA = 0.002


def surveyed(shift: np.ndarray | None = None) -> dict[str, np.ndarray]:
    """Four points on each board with errors of 2 mm, north, west, up."""
    generator = np.random.default_rng(3)
    off = np.zeros(3) if shift is None else shift
    return {
        f"{board}.{k}": on_board(board, *corner) + SIGMA * generator.normal(size=3) + off
        for board in ("T1", "T2")
        for k, corner in enumerate(CORNERS, start=1)
    }


def write_list(path: Path, points: dict[str, np.ndarray], *, plane: bool = True) -> Path:
    rows = ["name,north,west,up,sigma,plane" if plane else "name,north,west,up,sigma"]
    for name, (north, west, up) in points.items():
        row = f"{name},{north:.5f},{west:.5f},{up:.5f},{SIGMA}"
        rows.append(f"{row},{name[:2]}" if plane else row)
    path.write_text("\n".join(rows) + "\n")
    return path


def scan_points() -> np.ndarray:
    """Points of a static scan of both boards with noise of 1 mm, shape (8000, 3)."""
    generator = np.random.default_rng(1)
    parts = []
    for board in ("T1", "T2"):
        normal = site_of_few_lines().scene[board].normal
        places = np.array(
            [on_board(board, a, u) for a, u in generator.uniform(-0.5, 0.5, (4000, 2))]
        )
        parts.append(places + 0.001 * generator.normal(size=(4000, 1)) * normal)
    return np.concatenate(parts)


def write_scan(path: Path) -> Path:
    np.savetxt(path, scan_points(), fmt="%.5f")
    return path


@pytest.fixture
def known() -> tuple[Project, Survey]:
    return picked()


@pytest.fixture(scope="module")
def solved_known() -> tuple[Project, Survey]:
    """Project with an estimate, without control."""
    project, survey = picked()
    return estimate(project, survey, cross_check=False), survey


@pytest.fixture(scope="module")
def with_control(tmp_path_factory: pytest.TempPathFactory) -> tuple[Project, Survey]:
    folder = tmp_path_factory.mktemp("control")
    project, survey = picked()
    project, _ = import_control(project, survey, write_list(folder / "control.csv", surveyed()))
    return project, survey


@pytest.fixture(scope="module")
def solved_with_control(with_control: tuple[Project, Survey]) -> Project:
    return estimate(*with_control, cross_check=False)


# -- import ----------------------------------------------------------------------------------


def test_points_are_assigned_by_the_names_in_the_list(
    with_control: tuple[Project, Survey],
) -> None:
    (file,) = with_control[0].control
    assert [point.target for point in file.points] == ["T1"] * 4 + ["T2"] * 4
    assert {point.sigmas for point in file.points} == {(SIGMA,) * 3}
    assert file.kind == "points"
    assert file.common_sigma == 0.0
    assert len(file.sha256) == 64
    for point, place in zip(file.points, surveyed().values(), strict=True):
        np.testing.assert_allclose(point.position, place, atol=6e-6)


@LONG
def test_points_are_assigned_by_their_places(
    solved_known: tuple[Project, Survey], tmp_path: Path
) -> None:
    """The prior boresight of 0 displaces the surfaces; after an estimate they are near."""
    project, survey = solved_known
    points = surveyed()
    points["far"] = on_board("T1", 0.0, 0.0) + 20.0
    points["off"] = on_board("T1", 0.0, 0.0) + 0.7 * site_of_few_lines().scene["T1"].normal
    path = write_list(tmp_path / "control.csv", points, plane=False)
    project, notes = import_control(project, survey, path)
    found = {point.name: point for point in project.control[0].points}
    assert [found[name].target for name in surveyed()] == ["T1"] * 4 + ["T2"] * 4
    assert found["far"].target == found["off"].target == ""
    assert found["far"].reason is not None
    assert found["off"].reason is not None
    assert found["far"].reason.code == "control.beside_targets"
    assert found["off"].reason.code == "control.far_from_target"
    assert found["off"].reason.params["distance"] == pytest.approx(0.7, abs=0.05)
    assert [each.code for each in notes].count("control.far_from_target") == 1


def test_a_named_target_far_away_is_not_used(known: tuple[Project, Survey], tmp_path: Path) -> None:
    path = write_list(tmp_path / "c.csv", surveyed(np.array([0.0, 20.0, 40.0])))
    project, _ = import_control(*known, path)
    (file,) = project.control
    codes = {point.reason.code for point in file.points if point.reason is not None}
    assert codes == {"control.far_from_target"}
    assert file.used_points == ()


def test_three_sigmas_of_a_list(known: tuple[Project, Survey], tmp_path: Path) -> None:
    north, west, up = on_board("T1", 0.1, 0.2)
    path = tmp_path / "c.csv"
    path.write_text(
        f"name,north,west,up,sigma_x (mm),sigma_y (mm),sigma_z (mm)\nT1,{north},{west},{up},1,2,5\n"
    )
    project, _ = import_control(*known, path)
    assert project.control[0].points[0].sigmas == pytest.approx((0.001, 0.002, 0.005))
    assert project.control[0].points[0].target == "T1"


@LONG
def test_a_static_scan_gives_three_points_of_each_plane(
    solved_known: tuple[Project, Survey], tmp_path: Path
) -> None:
    path = write_scan(tmp_path / "tripod.txt")
    project, survey = solved_known
    project, notes = import_control(project, survey, path, sigma=0.003)
    (file,) = project.control
    assert file.kind == "scan"
    assert file.common_sigma == 0.003
    assert [point.name for point in file.points] == [
        f"{board}-{k}" for board in ("T1", "T2") for k in (1, 2, 3)
    ]
    assert any(each.code == "reference.points_used" for each in notes)
    for point in file.points:
        board = site_of_few_lines().scene[point.target]
        off = (np.array(point.position) - board.centre) @ board.normal
        assert abs(off) < 0.0003
        assert 1e-5 < point.sigmas[0] < 0.001
    result = estimate(project, survey, cross_check=False).result
    assert result is not None
    assert len(result.control) == 6
    # The common error is in the sigma of each point.
    assert all(0.003 < each.sigma < 0.0035 for each in result.control)


@pytest.mark.parametrize(
    ("how", "code"),
    [
        ({"sigma": 0.0}, "control.sigma"),
        ({"sigma": 50.0}, "control.sigma_out_of_range"),
        ({"common_sigma": -1.0}, "control.common_sigma_out_of_range"),
    ],
)
def test_impossible_sigmas_are_refused(
    known: tuple[Project, Survey], tmp_path: Path, how: dict[str, float], code: str
) -> None:
    path = tmp_path / "c.csv"
    north, west, up = on_board("T1", 0.1, 0.2)
    path.write_text(f"name,north,west,up\nT1,{north},{west},{up}\n")
    with pytest.raises(InputError) as failure:
        import_control(*known, path, **how)
    assert failure.value.reason.code == code


def test_control_needs_targets(known: tuple[Project, Survey], tmp_path: Path) -> None:
    project, survey = known
    empty = replace(project, targets=())
    with pytest.raises(ProjectError) as failure:
        import_control(empty, survey, write_list(tmp_path / "c.csv", surveyed()))
    assert failure.value.reason.code == "control.no_targets"


# -- estimate --------------------------------------------------------------------------------


def test_the_estimate_uses_the_control(
    solved_with_control: Project, solved_known: tuple[Project, Survey]
) -> None:
    solved, plain = solved_with_control, solved_known[0]
    assert solved.result is not None
    assert plain.result is not None
    result, alone = solved.result, solved.result.without_control
    assert len(result.control) == 8
    assert alone is not None
    # The points were selected with an estimate that contains the control.
    assert (np.abs(alone.angles - plain.result.angles) < 0.2 * alone.sigma).all()
    np.testing.assert_allclose(alone.sigma, plain.result.sigma, rtol=0.15)
    assert (result.sigma <= 1.01 * alone.sigma).all()
    truth = site_of_few_lines().boresight
    assert (np.abs(result.angles - truth) < 4 * result.sigma).all()
    values = ControlValues.of(solved)
    assert [row.name for row in values.comparison] == ["roll", "pitch", "yaw"]
    assert all(point.contradicts is False for point in values.points)
    # An excluded target takes its control along.
    assert plain.result.without_control is None
    assert plain.result.control == ()


def test_excluded_points_and_targets_are_not_used(with_control: tuple[Project, Survey]) -> None:
    project, survey = with_control
    project = project.with_control(with_control_use(project.control, ["T1.1", "T2.4"], used=False))
    solved = estimate(project, survey, cross_check=False)
    assert solved.result is not None
    names = [each.name for each in solved.result.control]
    assert names == ["T1.2", "T1.3", "T1.4", "T2.1", "T2.2", "T2.3"]
    without = set_target_use(project, "T1", False)
    origin = survey.trajectory.frame.origin_deg_m
    used = control_observations(without.control, {"T2"}, origin)
    assert used is not None
    assert set(used.targets) == {"T2"}


@LONG
def test_a_wrong_point_is_named(known: tuple[Project, Survey], tmp_path: Path) -> None:
    points = surveyed()
    points["T2.3"] = points["T2.3"] + 0.05 * site_of_few_lines().scene["T2"].normal
    project, _ = import_control(*known, write_list(tmp_path / "c.csv", points))
    solved = estimate(project, known[1], cross_check=False)
    assert solved.result is not None
    found = [each for each in result_warnings(solved.result, None)
             if each.code == "adjustment.control_contradicts"]  # fmt: skip
    assert [each.params["name"] for each in found] == ["T2.3"]
    wrong = {point.name for point in ControlValues.of(solved).points if point.contradicts}
    assert wrong == {"T2.3"}


def test_control_of_another_origin_is_refused(with_control: tuple[Project, Survey]) -> None:
    project, _ = with_control
    origin = project.control[0].origin_deg_m
    with pytest.raises(InputError) as failure:
        control_observations(project.control, {"T1"}, (origin[0], origin[1], origin[2] + 1.0))
    assert failure.value.reason.code == "control.other_origin"


# -- a single line ---------------------------------------------------------------------------


def on_lines(project: Project, *lines: str) -> Project:
    for line in {"L1", "L2", "L3"} - {*lines}:
        project = set_line_use(project, line, False)
    return project


def test_control_determines_the_angles_of_a_single_line(
    with_control: tuple[Project, Survey],
) -> None:
    """The third line is oblique to the boards."""
    project, survey = with_control
    alone = on_lines(project, "L3")
    solved = estimate(alone, survey)
    result = solved.result
    assert result is not None
    truth = site_of_few_lines().boresight
    assert (np.abs(result.angles - truth) < 4 * result.sigma).all()
    assert (result.sigma < np.radians(0.5)).all()
    assert len(result.control) == 8
    assert result.without_control is None
    assert single_line_notes(solved) == ()
    warned = {each.code for each in result_warnings(result, solved.cross_checks)}
    assert "adjustment.line_unchecked" in warned
    with pytest.raises(RankDeficient) as failure:
        estimate(alone.with_control(()), survey)
    # Followed by the note that no target is on two lines
    assert failure.value.reason.params["reason"].code == "estimate.one_line"


def test_a_single_line_along_the_boards_is_refused(with_control: tuple[Project, Survey]) -> None:
    project, survey = with_control
    with pytest.raises(RankDeficient) as failure:
        estimate(on_lines(project, "L1"), survey)
    assert failure.value.reason.code == "adjustment.undetermined_because"
    assert failure.value.reason.params["direction"].code == "adjustment.angle_pitch"
    assert failure.value.reason.params["reason"].code == "adjustment.single_line"


def test_a_target_on_one_line_is_used_if_it_has_control(
    with_control: tuple[Project, Survey],
) -> None:
    project, survey = with_control
    for line in ("L1", "L2"):
        project = set_sighting_use(project, "T2", line, False)
    assert single_line_notes(project) == ()
    solved = estimate(project, survey, cross_check=False)
    assert solved.result is not None
    assert {(each.sighting.target, each.sighting.line) for each in solved.result.sightings} == {
        ("T1", "L1"), ("T1", "L2"), ("T1", "L3"), ("T2", "L3"),
    }  # fmt: skip
    (found,) = single_line_notes(project.with_control(()))
    assert found.code == "targets.single_line_targets"


def test_new_targets_of_a_single_line_take_their_control(
    with_control: tuple[Project, Survey],
) -> None:
    """The control is assigned before the first adjustment, which needs it."""
    project, survey = with_control
    late = on_lines(project, "L3").targets
    empty = project.without_target("T1").without_target("T2")
    assert empty.control[0].used_points == ()
    again = empty.with_target(late[0]).with_target(late[1])
    solved = estimate(again, survey, cross_check=False)
    assert solved.result is not None
    assert len(solved.result.control) == 8


# -- edits and storage -----------------------------------------------------------------------


def test_edits_of_control_remove_dependent_results(solved_with_control: Project) -> None:
    solved = solved_with_control
    same = solved.with_control(solved.control)
    assert same.result is solved.result
    excluded = solved.with_control(with_control_use(solved.control, ["T1.1"], used=False))
    assert excluded.result is None
    unused = solved.with_control(without_control_file(solved.control, "control.csv"))
    assert unused.control == ()
    assert unused.result is None


def test_a_renamed_target_keeps_its_control(with_control: tuple[Project, Survey]) -> None:
    renamed = with_renamed_target(with_control[0], "T1", "Wall")
    assert [p.target for p in renamed.control[0].points] == ["Wall"] * 4 + ["T2"] * 4


# -- the assignment follows the targets --------------------------------------------------------


def assignment(project: Project) -> dict[str, str]:
    """Target of each control point by its name."""
    return {point.name: point.target for file in project.control for point in file.points}


@pytest.mark.parametrize("plane", others_long([False, True]))
def test_control_is_assigned_to_a_target_that_is_added_later(
    known: tuple[Project, Survey], tmp_path: Path, plane: bool
) -> None:
    """Named or by their places, at the next estimate and without another import."""
    project, survey = known
    late = project.target("T2")
    first, _ = import_control(
        project.without_target("T2"), survey,
        write_list(tmp_path / "c.csv", surveyed(), plane=plane),
    )  # fmt: skip
    assert assignment(first) == {name: "T1" * (name[:2] == "T1") for name in surveyed()}
    assert is_assignment_current(first)
    added = first.with_target(late)
    assert not is_assignment_current(added)
    expected = {name: name[:2] for name in surveyed()}
    assert assignment(with_assigned_control(added, survey)) == expected
    solved = estimate(added, survey, cross_check=False)
    assert is_assignment_current(solved)
    assert assignment(solved) == expected
    assert all(point.reason is None for point in solved.control[0].points)
    assert solved.result is not None
    assert {each.target for each in solved.result.control} == {"T1", "T2"}


def test_a_removed_target_leaves_its_control(with_control: tuple[Project, Survey]) -> None:
    project, _ = with_control
    removed = project.without_target("T2")
    assert assignment(removed) == {name: "T1" * (name[:2] == "T1") for name in surveyed()}
    codes = {p.reason.code for p in removed.control[0].points if p.reason is not None}
    assert codes == {"control.target_removed"}
    # Both targets in turn, before the control is assigned again
    assert set(assignment(removed.without_target("T1")).values()) == {""}
    assert not is_assignment_current(removed)
    # A validation plane has no control.
    assert set(assignment(with_switched_role(project, "T2")).values()) == {"T1", ""}


def test_a_new_target_of_the_same_name_elsewhere_does_not_take_the_control(
    known: tuple[Project, Survey], tmp_path: Path
) -> None:
    project, survey = known
    points = {name.replace("T", "P"): place for name, place in surveyed().items()}
    project, _ = import_control(*known, write_list(tmp_path / "c.csv", points, plane=False))
    one, two = project.target("T1"), project.target("T2")
    swapped = project.without_target("T1").without_target("T2")
    swapped = swapped.with_target(replace(one, name="T2")).with_target(replace(two, name="T1"))
    swapped = with_assigned_control(swapped, survey)
    other = {"P1": "T2", "P2": "T1"}
    assert assignment(swapped) == {name: other[name[:2]] for name in points}
    # Also if the target is picked again, with its name, at another place
    moved = project.without_target("T1").with_target(replace(one, name="T2"))
    assert assignment(moved) == dict.fromkeys(points, "")
    found = assignment(with_assigned_control(moved, survey))
    assert found == {name: "T2" * (name[:2] == "P1") for name in points}


def test_edits_of_a_target_keep_its_control(
    with_control: tuple[Project, Survey], solved_with_control: Project
) -> None:
    project, survey = with_control
    before = project.control
    line = project.target("T1").sightings[0].line
    for edited in (
        set_target_use(project, "T1", False),
        set_sighting_use(project, "T1", line, False),
        solved_with_control,
    ):
        assert edited.control == before
        assert with_assigned_control(edited, survey).control is edited.control


def test_excluded_points_stay_excluded_when_control_is_assigned_again(
    with_control: tuple[Project, Survey],
) -> None:
    project, survey = with_control
    late = project.target("T2")
    project = project.with_control(with_control_use(project.control, ["T2.3"], used=False))
    again = with_assigned_control(project.without_target("T2").with_target(late), survey)
    assert set(assignment(again).values()) == {"T1", "T2"}
    assert [point.name for point in again.control[0].points if not point.used] == ["T2.3"]


def test_a_scan_is_read_again_for_a_new_target(
    known: tuple[Project, Survey], tmp_path: Path
) -> None:
    project, survey = known
    path = write_scan(tmp_path / "tripod.txt")
    whole, _ = import_control(project, survey, path, sigma=0.003)
    late = project.target("T2")
    first, _ = import_control(project.without_target("T2"), survey, path, sigma=0.003)
    assert {point.target for point in first.control[0].points} == {"T1"}
    added = with_assigned_control(first.with_target(late), survey)
    assert added.control == whole.control
    removed = added.without_target("T2")
    assert removed.control == first.control
    assert is_assignment_current(removed)
    with path.open("a") as file:
        file.write("0 0 0\n")
    changed = with_assigned_control(first.with_target(late), survey)
    path.unlink()
    missing = with_assigned_control(first.with_target(late), survey)
    for found, code in ((changed, "control.scan_changed"), (missing, "control.scan_not_readable")):
        last = found.control[0].points[-1]
        assert last.target == ""
        assert last.reason is not None
        assert last.reason.code == "control.not_in_scan"
        assert last.reason.params["reason"].code == code
        assert is_assignment_current(found)


def test_an_imported_file_replaces_the_one_of_its_name(
    with_control: tuple[Project, Survey], tmp_path: Path
) -> None:
    """Points that were excluded stay excluded."""
    project, survey = with_control
    project = project.with_control(with_control_use(project.control, ["T1.2"], used=False))
    path = write_list(tmp_path / "control.csv", surveyed())
    again, _ = import_control(project, survey, path, common_sigma=0.01)
    (file,) = again.control
    assert file.common_sigma == 0.01
    assert [point.name for point in file.points if not point.used] == ["T1.2"]


def test_control_is_stored_in_the_project(solved_with_control: Project, tmp_path: Path) -> None:
    solved = solved_with_control
    stored = replace(solved, folder=tmp_path / "stored", file_digest="")
    write_project(stored)
    read = read_project(stored.folder)
    assert read.control == stored.control
    assert read.result is not None
    assert solved.result is not None
    assert read.result.control == solved.result.control
    assert read.result.without_control is not None
    path = stored.folder / PROJECT_FILE_NAME
    content = json.loads(path.read_text())
    place = Path(os.path.relpath(solved.control[0].path, stored.folder)).as_posix()
    assert content["control"][0]["path"] == place
    content["control"][0]["points"][0]["sigmas"][1] = 0.0
    path.write_text(json.dumps(content))
    with pytest.raises(ProjectError) as failure:
        read_project(stored.folder)
    assert failure.value.reason.code == "project.invalid_value"


def test_unknown_names_are_refused(with_control: tuple[Project, Survey]) -> None:
    control = with_control[0].control
    for change, code in (
        (lambda: with_control_use(control, ["X"], used=False), "control.unknown_point"),
        (lambda: without_control_file(control, "X"), "control.unknown_file"),
    ):
        with pytest.raises(LispacError) as failure:
            change()
        assert failure.value.reason.code == code


# -- scripts --------------------------------------------------------------------


def test_scripts_import_and_repeat_the_control(
    with_control: tuple[Project, Survey], tmp_path: Path
) -> None:
    project, survey = with_control
    opened = lispac.OpenProject(project.with_control(()), survey)
    path = write_list(tmp_path / "control.csv", surveyed())
    file = opened.control(path, common_sigma=0.001)
    assert file.common_sigma == 0.001
    opened.exclude_control("T1.1")
    assert len(opened.project.control[0].used_points) == 7
    text = script_of(opened.project, survey).text
    assert "project.put_control(" in text
    other = lispac.OpenProject(project.with_control(()), survey)
    start = text.index("project.put_control(")
    step = text[start : text.index("\n\n", start)]
    exec(step, {"project": other, "lispac": lispac, "data": tmp_path, "Path": Path})
    assert other.project.control == opened.project.control
    opened.use_control("T1.1")
    assert len(opened.project.control[0].used_points) == 8
    opened.remove_control("control.csv")
    assert opened.project.control == ()


def test_public_values_are_those_of_the_project() -> None:
    point = lispac.ControlPoint("A", "T1", (0.0, 0.0, 0.0), (0.001,) * 3)
    file = lispac.ControlFile(Path("a.csv"), 1, "", "points", "local", (0.0,) * 3, 0.0, (point,))
    assert isinstance(point, ControlPoint)
    assert isinstance(file, ControlFile)
    assert file.used_points == (point,)
