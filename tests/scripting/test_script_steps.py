"""Tests of single steps of a project's script: lines, edited targets and repeated checks."""

from dataclasses import replace
from math import radians
from pathlib import Path

import numpy as np
import pytest

import lispac
from lispac.messages import error, note
from lispac.progress import no_progress
from lispac.project import LineSource, PickedSighting, Project, Reading, Target
from lispac.targets.expected_target import ExpectedTarget
from lispac.targets.finder_settings import FinderChoices
from lispac.workflow.checking.absolute_check import check_absolute
from lispac.workflow.output.script import script_of, target_steps
from lispac.workflow.output.script_text import call_text
from lispac.workflow.project.survey import Survey
from tests.support.few_lines import on_board, picked, picked_and_estimated
from tests.support.long_runs import others_long


class Steps:
    """Recorder of the targets that a script puts and rejects."""

    def __init__(self) -> None:
        self.put_there: list[Target] = []
        self.rejected: list[tuple[str, ...]] = []

    def put(self, target: Target) -> None:
        self.put_there.append(target)

    def reject(self, *names: str) -> None:
        self.rejected.append(names)


SEARCH_PLACE = note("finder.seed_position", east=15.0, north=0.5, up=8.25)
PLANE_TARGET = Target(
    "T1", "target", (0.5, -15.0, 8.25), 0.012, 1.5,
    (
        PickedSighting("L1", np.arange(40, 90), 0.0021, fingerprint="90-a", by_hand=True),
        PickedSighting("L2", np.array([3, 9]), 0.0019, used=False, fingerprint="12-b", one_in=4),
    ),
    missing={"L3": error("finder.no_plane", place=SEARCH_PLACE, threshold=0.012)},
    expected=ExpectedTarget(1.2, 1.0, radians(45.0)), choices=FinderChoices(min_points=45),
)  # fmt: skip


@pytest.mark.parametrize(
    "target",
    [
        PLANE_TARGET,
        replace(PLANE_TARGET, missing={}, expected=None, used=False),
        replace(PLANE_TARGET, expected=None, shape="sphere", sphere_radius=0.145),
        replace(PLANE_TARGET, expected=None, shape="sphere", choices=FinderChoices()),
    ],
)
def test_a_target_edited_by_hand_is_reproduced_completely(target: Target) -> None:
    """The step is executed as Python code and needs nothing of the survey."""
    project, survey = picked()
    steps = Steps()
    for step in target_steps(project, survey, target, no_progress):
        exec(step, {"lispac": lispac, "project": steps})
    (again,) = steps.put_there
    for name in (
        "name", "role", "seed", "threshold", "radius", "missing", "shape", "sphere_radius",
        "expected", "choices",
    ):  # fmt: skip
        assert getattr(again, name) == getattr(target, name), name
    for one, other in zip(again.sightings, target.sightings, strict=True):
        assert one.indices.tolist() == other.indices.tolist()
        for name in ("line", "rms", "fingerprint", "one_in", "by_hand"):
            assert getattr(one, name) == getattr(other, name), name
    rejected = [("T1", "L2"), *([] if target.used else [("T1",)])]
    assert steps.rejected == rejected


def test_script_gives_the_reading_of_each_line(tmp_path: Path) -> None:
    project, survey = picked()
    data = tmp_path / "data"
    shifted = Reading("las", (("crs", "EPSG:32619"),), -18.0)
    lines = (
        LineSource("L1", data / "L1.laz"),
        LineSource("first pass", data / "L2.laz"),
        LineSource("L3", data / "L3.txt", ("time", "x", "y", "z")),
        LineSource("L4", data / "L4.las", reading=shifted),
    )
    text = Reading("ascii-trajectory", (("columns", "time north"),))
    read = replace(
        project, trajectory=data / "pos.txt", lines=lines, targets=(), trajectory_reading=text
    )
    script = script_of(read, survey)
    arguments: dict[str, object] = {}

    class Recorder:
        LineSource, Reading = LineSource, Reading

        @staticmethod
        def new(folder: Path, **named: object) -> "Recorder":
            arguments.update(named)
            return Recorder()

        def save(self) -> None: ...

        def report(self, path: Path) -> None: ...

    steps = script.text.replace("import lispac\n", "")
    exec(steps, {"lispac": Recorder})
    assert arguments["trajectory"] == data / "pos.txt"
    assert arguments["trajectory_reading"] == text
    assert "accuracy_reading" not in arguments
    assert arguments["resolved"] is True
    lines_of_call = arguments["lines"]
    assert isinstance(lines_of_call, list)
    assert lines_of_call[0] == data / "L1.laz"  # default name and reading
    assert lines_of_call[1:] == list(lines[1:])
    (message,) = script.messages
    assert message.code == "script.missing_files"
    assert str(data / "L3.txt") in message.params["files"]


@pytest.fixture
def checked(tmp_path: Path) -> tuple[Project, Survey, Path]:
    """A project checked against a list of points in its own folder."""
    project, survey = picked_and_estimated()
    project = replace(project, folder=tmp_path / "quay", trajectory=tmp_path / "raw" / "pos.sbet")
    project = replace(
        project, lines=tuple(replace(n, path=tmp_path / "raw" / n.path) for n in project.lines)
    )
    for folder in (project.folder, tmp_path / "raw"):
        folder.mkdir()
    path = project.folder / "board.csv"
    places = [on_board("T2", a, u) for a, u in ((-0.4, -0.4), (0.4, -0.4), (0.4, 0.4), (-0.4, 0.4))]
    rows = [f"B{k},{x[0]:.4f},{x[1]:.4f},{x[2]:.4f},T2" for k, x in enumerate(places)]
    path.write_text("\n".join(["name,north,west,up,plane", *rows]) + "\n")
    project, _ = check_absolute(project, survey, path, search_distance=0.8)
    return project, survey, path


@pytest.mark.parametrize("beside", others_long([True, False]))
def test_a_check_is_repeated_with_the_original_file(
    checked: tuple[Project, Survey, Path], beside: bool
) -> None:
    """The folder of the lines has another list of the same name, in one case of the same size."""
    project, survey, path = checked
    other = path.read_text().replace("B0", "C0") if beside else "another list"
    (project.trajectory.parent / "board.csv").write_text(other)
    script = script_of(project, survey)
    assert call_text("project.check", path, search_distance=0.8) in script.text
    assert not any(message.params.get("file") == "board.csv" for message in script.messages)


def test_a_check_is_not_repeated_with_a_changed_list(
    checked: tuple[Project, Survey, Path],
) -> None:
    project, survey, path = checked
    path.write_text(path.read_text().replace("B0", "C0"))
    script = script_of(project, survey)
    assert "# project.check('board.csv', search_distance=0.8)" in script.text
    assert note("script.no_reference", file="board.csv") in script.messages
