"""Tests of the script of a project, which reproduces it from its raw files."""

import shutil
from dataclasses import replace
from math import radians
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lispac
from lispac.cli.main import main
from lispac.errors import InputError
from lispac.io.trajectory.sbet import read_sbet, write_sbet
from lispac.message_texts import english_text
from lispac.messages import note
from lispac.project import Project
from lispac.workflow.calibration.point_edits import without_points
from lispac.workflow.calibration.point_index_text import numbers_text, point_numbers
from lispac.workflow.output.script import Script, script_of
from lispac.workflow.output.script_text import (
    MAX_PIECE_LENGTH,
    call_text,
    python_literal,
    split_text_code,
)
from lispac.workflow.planning.demo import demo_seeds
from tests.support.long_runs import LONG
from tests.support.script_runs import run, run_in_process, same_part


@given(st.lists(st.integers(0, 10**12), max_size=60))
def test_point_numbers_keep_their_order(numbers: list[int]) -> None:
    text = numbers_text(np.array(numbers, dtype=np.int64))
    assert point_numbers(text).tolist() == numbers
    assert "".join(map(eval, split_text_code(text).split("\n"))) == text
    assert all(len(piece) <= MAX_PIECE_LENGTH + 24 for piece in split_text_code(text).split("\n"))


def test_runs_of_point_numbers_are_written_briefly() -> None:
    assert numbers_text(np.array([7, 8, 9, 20, 3, 4])) == "7+3 20 3+2"


@pytest.mark.parametrize(
    "text", ["7+", "a", "-3", "1.5", "1+2+3", "9" * 40, "1+999999999 1+999999999"]
)
def test_invalid_point_numbers_are_refused(text: str) -> None:
    with pytest.raises(InputError) as raised:
        point_numbers(text)
    assert raised.value.code in ("pick.not_a_number", "pick.too_many_numbers")


@given(st.text(), st.floats(allow_nan=False, allow_infinity=False), st.integers())
def test_values_are_written_as_python_literals(text: str, number: float, whole: int) -> None:
    values = (text, number, np.float64(number), whole, None, True, (text,), [number], {text: whole})
    assert eval(python_literal(values)) == values
    reading = lispac.Reading("las", ((text, text),), number)
    assert eval(call_text("lispac.LineSource", text, Path(text or "a"), reading=reading)) == (
        lispac.LineSource(text, Path(text or "a"), reading=reading)
    )


@pytest.fixture
def quay(demo_project: Project) -> lispac.OpenProject:
    return lispac.open(demo_project.folder)


def seed_targets(quay: lispac.OpenProject, *names: str) -> lispac.OpenProject:
    for name in names:
        role, place = demo_seeds()[name]
        quay.seed(name, place, role=role)
    return quay


@pytest.fixture(scope="module")
def estimated(demo_project: Project) -> Project:
    quay = seed_targets(lispac.open(demo_project.folder), "T1", "T2")
    quay.estimate(cross_check=False)
    return quay.project


@pytest.fixture
def estimated_quay(quay: lispac.OpenProject, estimated: Project) -> lispac.OpenProject:
    """A project with two targets and an estimated boresight."""
    quay.project = estimated
    return quay


def project_script(quay: lispac.OpenProject) -> Script:
    return script_of(quay.project, quay.survey)


def same_numbers(quay: lispac.OpenProject, script: Script, folder: Path) -> lispac.OpenProject:
    """Run the script, check that its report equals that of `quay`, and open its project."""
    quay.report(folder / "wanted.json")
    found = run_in_process(script.text, folder / "again")
    assert found == same_part(folder / "wanted.json")
    return lispac.open(folder / "again")


def test_all_edits_of_targets_are_reproduced(quay: lispac.OpenProject, tmp_path: Path) -> None:
    seed_targets(quay, "T1", "V2")
    usual = demo_seeds()
    quay.seed(
        "Board 'two' \"", usual["T2"][1], radius=1.5, threshold=0.012,
        expected=lispac.ExpectedTarget(1.2, 1.2, radians(45.0)),
        choices=lispac.FinderChoices(min_points=50, seed=3),
    )  # fmt: skip
    quay.seed("V1", usual["V1"][1])
    quay.set_role("V1", "validation")
    quay.seed("T3", usual["V5"][1], line="L2_180")
    quay.seed("T3", usual["V5"][1], line="L1_000")
    quay.reject("T3")
    quay.reject("T1", "L3_045")

    target = quay.project.target("T1")
    cut, removed_count = without_points(
        target, quay.survey.clouds, lambda points: points[:, 2] > points[:, 2].mean() + 0.3
    )
    assert removed_count > 100
    quay.project = quay.project.with_target(cut)
    quay.identity(remarks='It\'s "new"\nand \\ odd', vessel="Léonie")
    quay.change(
        lidar_sigma=0.0021, subsample=0.12, parameters=(lispac.Parameter("latency", 0.001),)
    )
    quay.estimate(cross_check=False)
    quay.validate("quadric", neighbours=15)

    script = project_script(quay)
    assert script.messages == ()
    assert "its points were edited manually" in script.text
    # A target with one seed per line cannot be written as a single seed.
    assert script.text.count("project.put(") == 2
    assert script.text.count("project.seed(") == 3
    again = same_numbers(quay, script, tmp_path)
    assert again.project.identity == quay.project.identity
    assert again.project.settings == quay.project.settings
    for one, other in zip(quay.project.targets, again.project.targets, strict=True):
        assert (one.name, one.role, one.used, one.seed, one.expected, one.choices) == (
            other.name, other.role, other.used, other.seed, other.expected, other.choices
        )  # fmt: skip
        for a, b in zip(one.sightings, other.sightings, strict=True):
            assert (a.line, a.used, a.rms, a.by_hand) == (b.line, b.used, b.rms, b.by_hand)
            assert a.indices.tolist() == b.indices.tolist()


@pytest.mark.long
def test_points_of_proposed_targets_and_of_another_prior_are_kept(
    quay: lispac.OpenProject, tmp_path: Path
) -> None:
    seed_targets(quay, "T1", "T2")
    quay.accept(quay.propose(), ["V1"])
    quay.change(boresight_deg=(0.3, -1.1, 0.4))
    quay.estimate(cross_check=False)
    script = project_script(quay)
    assert "project.put(" in script.text
    assert "boresight_deg=(0.3, -1.1, 0.4)" in script.text
    same_numbers(quay, script, tmp_path)


@LONG
def test_script_has_no_steps_that_were_not_done(quay: lispac.OpenProject, tmp_path: Path) -> None:
    before = quay.project
    seed_targets(quay, "T1")
    quay.project = before
    script = project_script(quay)
    for step in ("seed", "put", "estimate", "validate", "check", "identity", "import_lines"):
        assert f"project.{step}(" not in script.text
    same_numbers(quay, script, tmp_path)


@LONG
def test_imported_lines_are_imported(demo_project: Project, tmp_path: Path) -> None:
    raw = demo_project.folder / "raw"
    quay = lispac.new(
        tmp_path / "quay", lines=sorted(raw.glob("L[12]*.laz")), lever_arm=(-0.242, 0.061, 2.173),
        trajectory=raw / "trajectory.sbet", lidar_sigma=0.0017,
    )  # fmt: skip
    quay.import_lines(["L2_180"])
    seed_targets(quay, "T1", "T2")
    script = project_script(quay)
    assert "project.import_lines(['L2_180'])" in script.text
    assert "project.put(" not in script.text
    same_numbers(quay, script, tmp_path)
    assert (tmp_path / "again" / "lines").is_dir()


def test_the_script_detects_the_reading_options_if_the_warnings_are_the_same(
    demo_project: Project, tmp_path: Path
) -> None:
    """An opened project still has the warnings of its import."""
    raw = demo_project.folder / "raw"
    states = read_sbet(raw / "trajectory.sbet")
    without_rates = tmp_path / "trajectory.sbet"
    write_sbet(without_rates, replace(states, attitude_rate=None))
    quay = lispac.new(
        tmp_path / "quay", lines=[raw / "L1_000.laz"], trajectory=without_rates,
        lever_arm=(0, 0, 0),
    )  # fmt: skip
    again = lispac.open(quay.project.folder)
    assert again.project.reading_warnings == quay.project.reading_warnings != ()
    for k, each in enumerate((quay, again)):
        assert "resolved=True" not in project_script(each).text
        same_numbers(each, project_script(each), tmp_path / f"made{k}")


def test_missing_raw_files_are_reported(demo_project: Project, tmp_path: Path) -> None:
    raw = Path(shutil.copytree(demo_project.folder / "raw", tmp_path / "raw"))
    quay = lispac.new(
        tmp_path / "quay", lines=[raw / "L1_000.laz", raw / "L2_180.laz"], lever_arm=(0, 0, 0),
        trajectory=raw / "trajectory.sbet",
    )  # fmt: skip
    quay.import_lines()
    (raw / "L2_180.laz").unlink()
    quay.survey  # noqa: B018  imported lines no longer need their files
    (message,) = project_script(quay).messages
    assert message == note("script.missing_files", files=[str(raw / "L2_180.laz")])


def reference(folder: Path) -> Path:
    """Write surveyed points on T2, which is inclined by 45 deg about the west axis."""
    from tests.support.static_scans import on_plane

    corners = on_plane("T2", np.array([-0.4, 0.4, 0.4, -0.4]), np.array([-0.4, -0.4, 0.4, 0.4]))
    rows = [f"B{k},{x[0]},{x[1]},{x[2]},0.002,T2" for k, x in enumerate(corners)]
    path = folder / "board.csv"
    path.write_text("\n".join(["name,north,west,up,sigma,plane", *rows]))
    return path


@LONG
@pytest.mark.parametrize("beside", [pytest.param(True, marks=pytest.mark.long), False])
def test_a_check_is_repeated_if_its_reference_exists(
    estimated_quay: lispac.OpenProject, tmp_path: Path, beside: bool
) -> None:
    quay = estimated_quay
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    quay.check(reference(elsewhere), search_distance=0.8)
    if beside:
        quay.save_as(elsewhere / "quay")
        assert not project_script(quay).messages
        same_numbers(quay, project_script(quay), tmp_path)
        reference(elsewhere).write_text("another list")
    script = project_script(quay)
    assert "# project.check('board.csv', search_distance=0.8)" in script.text
    (message,) = script.messages
    assert message == note("script.no_reference", file="board.csv")


@LONG
def test_a_check_that_cannot_be_repeated_from_its_file_is_reported(
    estimated_quay: lispac.OpenProject, tmp_path: Path
) -> None:
    quay = estimated_quay
    found = quay.check(reference(tmp_path))
    quay.project = quay.project.with_absolute(replace(found, system="a system of one's own"))
    quay.save_as(tmp_path / "quay")
    (message,) = project_script(quay).messages
    assert message.code == "script.other_check"
    assert message.params["system"] == "a system of one's own"


@LONG
def test_a_result_that_the_steps_do_not_reproduce_is_reported(
    estimated_quay: lispac.OpenProject,
) -> None:
    quay, result = estimated_quay, estimated_quay.result
    off = result.mounting.with_boresight(result.boresight + np.radians([0.0, 0.004, 0.0]))
    quay.project = quay.project.with_result(replace(result, mounting=off))
    (message,) = project_script(quay).messages
    assert message.code == "script.other_angles"
    assert message.params["angle"] == note("quantity.pitch")
    assert english_text(message).split(":")[0] in project_script(quay).text.replace("\n# ", " ")


@LONG
def test_names_cannot_inject_code(quay: lispac.OpenProject, tmp_path: Path) -> None:
    """The name of the folder is written into comments and strings of the script."""
    quay.save_as(tmp_path / "a'b\"\nimport nothing_of_the_kind\n#")
    run(project_script(quay).text, tmp_path / "again")


def test_the_command_prints_and_writes_the_script(
    demo_project: Project, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "steps.py"
    assert main(["script", str(demo_project.folder), "--output", str(path)]) == 0
    assert capsys.readouterr().out == f"{path}\n"
    assert main(["script", str(demo_project.folder)]) == 0
    assert capsys.readouterr().out == path.read_text(encoding="utf-8")
    compile(path.read_text(encoding="utf-8"), "steps.py", "exec")
    assert main(["script", str(tmp_path / "nowhere")]) == 1
