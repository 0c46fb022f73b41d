"""Tests of targets picked from a list of coordinates, by workflow and command line."""

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.errors import Cancelled, InputError, ProjectError
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project
from lispac.message_texts import message_text
from lispac.messages import error, note
from lispac.progress import Step
from lispac.project import Project
from lispac.survey.crs import coordinate_system
from lispac.workflow.calibration.picking import find_target
from lispac.workflow.calibration.seed_lists import pick_seeds, read_seeds, role_by_name
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.survey import Survey, load_survey
from tests.cli.test_cli import run
from tests.support.command_errors import command_error
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG
from tests.support.message_codes import is_shown

SEEDS = demo_seeds()
UTM = "EPSG:32618"


@pytest.fixture(scope="module")
def survey(demo_project: Project) -> Survey:
    """The built-in survey."""
    return load_survey(demo_project)


@pytest.fixture
def folder(demo_project: Project, tmp_path: Path) -> Path:
    """A copy of the project of the built-in survey without targets."""
    return Path(shutil.copytree(demo_project.folder, tmp_path / "demo"))


def rows(*names: str, offset: float = 0.0) -> str:
    return "".join(
        f"{name};{x + offset:.4f};{y:.4f};{z:.4f}\n".replace(".", ",")
        for name, (_, (x, y, z)) in ((name, SEEDS[name]) for name in names)
    )


def run_refused(capsys: pytest.CaptureFixture[str], folder: Path, text: str, *words: object) -> str:
    """Pick from a list that must be refused: exit 1, one line, and an unchanged project."""
    path = folder.parent / "targets.txt"
    path.write_text(text)
    before = (folder / PROJECT_FILE_NAME).read_bytes()
    code, out, err = run(capsys, "pick", folder, "--seeds", path, *words)
    assert (code, out) == (1, ""), err
    assert err.count("\n") == 1
    assert err.startswith(f"lispac: {path}")
    assert (folder / PROJECT_FILE_NAME).read_bytes() == before
    return err


def test_picking_from_a_list_equals_single_picks(
    capsys: pytest.CaptureFixture[str], folder: Path, survey: Survey, demo_project: Project
) -> None:
    path = folder.parent / "targets.csv"
    path.write_text("# quay wall\nname;x;y;z\n" + rows("T1", "T2", "V1") + "Lost;20;4;3\n")
    code, out, err = run(capsys, "pick", folder, "--seeds", path)
    assert code == 1
    not_found = error(
        "pick.some_not_found", file=str(path), count=1, total=4, seeds=("Lost",), rows=("6",)
    )
    assert err.splitlines()[-1] == f"lispac: {message_text(not_found)}"
    named = note("assumed.columns_as_named", columns=("name", "north", "west", "up"))
    assert f"note: {message_text(named)}" in err
    rows_printed = (line.split() for line in out.splitlines() if line[:5].strip().isdigit())
    table = {name: rest for _, name, *rest in rows_printed}
    assert set(table) == {"T1", "T2", "V1", "Lost"}
    assert table["T1"][:4] == ["Target", "6", "of", "6"]
    assert table["V1"][:2] == ["Validation", "plane"]
    assert table["Lost"] == ["Target", "none", "-", "-"]
    assert out.endswith("Targets found for 3 of 4 seeds\n")
    project = read_project(folder)
    assert [t.name for t in project.targets] == ["T1", "T2", "V1"]
    assert [t.role for t in project.targets] == ["target", "target", "validation"]
    x, y, z = (float(f"{value:.4f}") for value in SEEDS["T2"][1])
    alone = find_target(demo_project, survey, (x, y, z), name="T2")
    for sighting, other in zip(project.target("T2").sightings, alone.sightings, strict=True):
        np.testing.assert_array_equal(sighting.indices, other.indices)


@LONG
def test_seeds_in_a_coordinate_system_are_picked_with_json_output(
    capsys: pytest.CaptureFixture[str], folder: Path, survey: Survey
) -> None:
    places = np.array([SEEDS[name][1] for name in ("T1", "T2")])
    on_map = coordinate_system(UTM).from_local(places, survey.trajectory.frame)
    path = folder.parent / "targets.txt"
    path.write_text(
        "".join(f"B{k} {n:.4f} {e:.4f} {h:.4f}\n" for k, (e, n, h) in enumerate(on_map))
    )
    words = ["pick", folder, "--seeds", path, "--crs", UTM]
    refusal = command_error(*words)
    assert refusal.code == "coordinates.swapped_projected"
    row = note("item.list_row", file=str(path), row=1, name="B0")
    assert refusal.message.params["name"] == row
    code, out, err = run(capsys, *words, "--columns", "name,y,x,z", "--role", "target", "--json")
    assert code == 0, err
    assert is_shown("assumed.list_system", err)
    assert "(EPSG:32618)" in err
    found: list[dict[str, Any]] = json.loads(out)["seeds"]
    np.testing.assert_allclose([seed["seed_m"] for seed in found], places, atol=2e-4)
    assert all(len(seed["lines"]) == 6 for seed in found)
    # The same for a typed seed
    east, north, height = on_map[0]
    typed = ["--seed", east, north, height, "--crs", UTM, "--name", "S1", "--json"]
    code, out, err = run(capsys, "pick", folder, *typed)
    assert code == 0, err
    assert {k: v["points"] for k, v in json.loads(out)["lines"].items()} == {
        k: v["points"] for k, v in found[0]["lines"].items()
    }


@LONG
def test_a_list_with_errors_is_refused_as_a_whole(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    good = rows("T1")
    short = run_refused(capsys, folder, good + "T2;1\n")
    assert is_shown("seeds.row_too_short", short)
    assert "row 2: " in short
    assert "row 2: the name T1 is already in row 1" in run_refused(
        capsys, folder, good + "T1;1;2;3\n"
    )
    far = run_refused(capsys, folder, good + "T2;5041234;614000;8\n")
    assert "row 2: T2: " in far
    assert "5.04123e+06" in far or "5041234.0" in far
    assert is_shown("coordinates.too_far_local", far)
    unnamed = run_refused(capsys, folder, good, "--columns", "name,x,y")
    assert is_shown("seeds.columns_missing", unnamed)
    none = run_refused(capsys, folder, "A;300;300;300\nB;310;300;300\n")
    assert is_shown("pick.none_found", none)
    assert "A (row 1): " in none


@LONG
def test_an_existing_name_is_refused_or_replaced(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    path = folder.parent / "first.txt"
    path.write_text(rows("T1", "V1"))
    assert run(capsys, "pick", folder, "--seeds", path)[0] == 0
    again = rows("T2", "T1", offset=0.05)
    name_error = error(
        "pick.name_taken", file=str(folder.parent / "targets.txt"), row=2, target="T1"
    )
    assert message_text(name_error) in run_refused(capsys, folder, again)
    path.write_text(again)
    assert run(capsys, "pick", folder, "--seeds", path, "--replace")[0] == 0
    project = read_project(folder)
    assert [t.name for t in project.targets] == ["T1", "V1", "T2"]
    assert project.target("T1").seed[0] == pytest.approx(SEEDS["T1"][1][0] + 0.05, abs=1e-4)


@pytest.mark.parametrize(
    "words",
    [
        ["--seeds", "f", "--seed", 1, 2, 3],
        ["--seeds", "f", "--name", "T1"],
        ["--seeds", "f", "--line", "L1"],
        ["--seed", 1, 2, 3, "--name", "T1", "--columns", "x,y,z"],
        ["--seed", 1, 2, 3, "--name", "T1", "--replace"],
        ["--seed", 1, 2, 3],
        [],
    ],
)
def test_incompatible_options_are_refused(
    capsys: pytest.CaptureFixture[str], words: list[object]
) -> None:
    assert run(capsys, "pick", "nowhere", *words)[0] == 2


def test_missing_names_and_roles_get_defaults(
    demo_project: Project, survey: Survey, tmp_path: Path
) -> None:
    path = tmp_path / "targets.txt"
    path.write_text("x y z role\n1 -15 8 T\n2 -15 8 V\n3 -15 8\n")
    read = read_seeds(path, demo_project, survey.trajectory)
    assert [(seed.name, seed.role) for seed in read.seeds] == [
        ("T1", "target"), ("V1", "validation"), ("T2", "target")
    ]  # fmt: skip
    assert [role_by_name(name) for name in ("V1", "v-2", "T1", "Wall", "7")] == [
        "validation", "validation", "target", "target", "target"
    ]  # fmt: skip


def test_a_duplicate_target_in_a_list_is_reported(
    demo_project: Project, survey: Survey, tmp_path: Path
) -> None:
    path = tmp_path / "targets.txt"
    path.write_text(rows("T1") + rows("T1", offset=0.2).replace("T1", "Double"))
    read = read_seeds(path, demo_project, survey.trajectory)
    _, outcomes = pick_seeds(demo_project, survey, read.seeds, {})
    assert outcomes[0].message is None
    assert outcomes[1].message is not None
    assert outcomes[1].message.code == "overlap.same_surface_twice"


def test_cancelled_lists_and_seeds_that_cannot_be_searched(
    demo_project: Project, survey: Survey, tmp_path: Path
) -> None:
    path = tmp_path / "targets.txt"
    path.write_text(rows("T1", "T2"))
    read = read_seeds(path, demo_project, survey.trajectory)
    steps: list[tuple[float, str]] = []

    def stop(fraction: float, step: Step | None = None) -> None:
        steps.append((fraction, str(step)))
        if "T2" in str(step):
            raise Cancelled

    with pytest.raises(Cancelled):
        pick_seeds(demo_project, survey, read.seeds, {}, progress=stop)
    assert steps[0] == (0.0, "Searching for T1 (1 of 2)")
    assert steps[-1] == (0.5, "Searching for T2 (2 of 2)")
    assert demo_project.targets == ()
    with pytest.raises(InputError, check=has_code("finder.setting", name="threshold")):
        pick_seeds(demo_project, survey, read.seeds, {"threshold": -1.0})
    with pytest.raises(ProjectError, check=has_code("target.invalid_radius")):
        pick_seeds(demo_project, survey, read.seeds, {"shape": "sphere", "sphere_radius": -1.0})
