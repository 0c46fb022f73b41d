"""Tests of the boresight from a file of point correspondences."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from lispac import open as open_project
from lispac.cli.main import main
from lispac.errors import AdjustmentError, InputError
from lispac.io.project.project_file import read_project
from lispac.io.text.correspondence_file import read_correspondences
from lispac.method_comparison import method_results
from lispac.project import Project
from lispac.workflow.calibration.correspondences import correspondences
from lispac.workflow.output.export import write_report
from lispac.workflow.project.survey import Survey, load_survey
from tests.cli.test_cli import run_json
from tests.support.correspondence_files import write_pairs
from tests.support.error_codes import has_code


def run_command(capsys: pytest.CaptureFixture[str], *words: object) -> str:
    assert main([str(word) for word in words]) == 0
    return capsys.readouterr().out


@pytest.fixture
def demo_copy(demo_project: Project, tmp_path: Path) -> Path:
    """A folder of the demo project that the test may change."""
    return Path(shutil.copytree(demo_project.folder, tmp_path / "harbour"))


@pytest.fixture(scope="module")
def survey(demo_project: Project) -> Survey:
    return load_survey(demo_project)


@pytest.fixture(scope="module")
def pairs_file(
    demo_project: Project, survey: Survey, tmp_path_factory: pytest.TempPathFactory
) -> Path:
    return write_pairs(tmp_path_factory.mktemp("pairs") / "pairs.txt", demo_project, survey)


def assert_true(project: Project, boresight: np.ndarray, sigma: np.ndarray) -> None:
    off = boresight - np.radians(project.truth_deg)
    assert np.abs(off / sigma).max() < 4
    assert np.degrees(sigma).max() < 0.05


def test_the_true_boresight_is_found(
    demo_project: Project, survey: Survey, pairs_file: Path
) -> None:
    found = correspondences(demo_project, survey, pairs_file)
    assert_true(demo_project, found.estimate.boresight, found.estimate.sigma)
    assert found.lines == survey.lines
    assert found.alternative.is_sound()
    assert {each.code for each in found.messages} == {
        "correspondences.basis", "correspondences.distance", "correspondences.noise",
    }  # fmt: skip


def test_other_layouts_of_the_file_are_read(
    demo_project: Project, survey: Survey, pairs_file: Path, tmp_path: Path
) -> None:
    given = read_correspondences(pairs_file)
    assert len(given) == 200
    row = ",".join(["{:.6f}"] * 2 + ["{:.5f}"] * 6)
    for header in ("t_i,t_j,x_i,y_i,z_i,x_j,y_j,z_j\n", "# pairs\n\n"):
        path = write_pairs(tmp_path / "p.csv", demo_project, survey, header=header, row=row)
        again = read_correspondences(path)
        assert np.array_equal(again.time, given.time)
        assert np.array_equal(again.points_lidar, given.points_lidar)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "text.empty"),
        ("t_i t_j x_i\n", "text.no_rows"),
        ("1 2 3 4 5 6 7\n", "correspondences.columns"),
        ("1 2 3 4 5 6 7 8 9\n", "correspondences.columns"),
        ("1 2 3 4 nan 6 7 8\n", "text.unusable_value"),
    ],
)
def test_unreadable_files_are_refused(tmp_path: Path, text: str, code: str) -> None:
    path = tmp_path / "pairs.txt"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, check=has_code(code)):
        read_correspondences(path)


def test_unusable_and_repeated_pairs_are_counted(
    demo_project: Project, survey: Survey, pairs_file: Path, tmp_path: Path
) -> None:
    rows = pairs_file.read_text(encoding="utf-8").splitlines()
    first, second = rows[0].split(), rows[1].split()
    exchanged = [second[1], second[0], *second[5:], *second[2:5]]
    at_scanner = [*first[:5], "0", "0", "0"]
    late = [str(float(first[0]) + 1e5), *first[1:]]
    path = tmp_path / "more.txt"
    path.write_text(
        "\n".join([*rows, rows[0], *map(" ".join, (exchanged, at_scanner, late))]) + "\n",
        encoding="utf-8",
    )
    found = correspondences(demo_project, survey, path)
    (note,) = [each for each in found.messages if each.code == "correspondences.not_used"]
    counts = {name: note.params[name] for name in ("count", "outside", "repeated", "origin")}
    assert counts == {"count": 4, "outside": 1, "repeated": 2, "origin": 1}
    alone = correspondences(demo_project, survey, pairs_file)
    assert found.estimate.boresight == pytest.approx(alone.estimate.boresight, abs=1e-9)


def test_times_of_another_base_are_refused_until_they_are_shifted(
    demo_project: Project, survey: Survey, pairs_file: Path, tmp_path: Path
) -> None:
    path = write_pairs(tmp_path / "p.txt", demo_project, survey, time_shift=86_400.0)
    with pytest.raises(InputError, check=has_code("correspondences.outside")):
        correspondences(demo_project, survey, path)
    found = correspondences(demo_project, survey, path, time_shift=86_400.0)
    alone = correspondences(demo_project, survey, pairs_file)
    assert found.estimate.boresight == pytest.approx(alone.estimate.boresight, abs=1e-8)


def test_a_given_noise_is_checked(demo_project: Project, survey: Survey, pairs_file: Path) -> None:
    found = correspondences(demo_project, survey, pairs_file, noise=0.012)
    assert "correspondences.noise_too_small" in {
        each.code for each in found.messages if each.is_serious
    }
    for noise in (0.0, 20.0):
        with pytest.raises(InputError, check=has_code("correspondences.noise_range")):
            correspondences(demo_project, survey, pairs_file, noise=noise)


def test_points_in_another_frame_give_no_boresight(
    demo_project: Project, survey: Survey, pairs_file: Path, tmp_path: Path
) -> None:
    """Points that are already georeferenced differ by metres from any boresight."""
    values = np.loadtxt(pairs_file)
    values[:, 2:5] += np.array([[10.0, -7.0, 3.0]]) * np.sign(values[:, 3:4])
    path = tmp_path / "p.txt"
    np.savetxt(path, values, fmt="%.6f")
    with pytest.raises(AdjustmentError):
        correspondences(demo_project, survey, path, noise=0.02)


def test_the_command_saves_the_result_beside_that_of_the_targets(
    demo_copy: Path, pairs_file: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    values = run_json(capsys, "correspondences", demo_copy, pairs_file, "--save")
    assert values["pairs_used"] <= values["pairs"] == 200
    project = read_project(demo_copy)
    (kept,) = project.alternative_results
    assert kept.method == "correspondences"
    assert np.degrees(kept.boresight) == pytest.approx(list(values["boresight_deg"].values()))
    assert [each.method for each in method_results(project)] == ["correspondences"]
    text = run_command(capsys, "correspondences", demo_copy, pairs_file)
    assert "deg" in text
    text = run_command(capsys, "compare", demo_copy)
    assert "Point correspondences" in text


def test_the_report_compares_the_result(demo_copy: Path, pairs_file: Path, tmp_path: Path) -> None:
    project = open_project(demo_copy)
    found = project.correspondences(pairs_file)
    assert project.project.alternative_results[0].boresight is found.estimate.boresight
    path = tmp_path / "report.json"
    write_report(project.project, project.survey, path)
    methods = json.loads(path.read_text(encoding="utf-8"))["methods"]
    assert [each["method"] for each in methods] == ["correspondences"]
