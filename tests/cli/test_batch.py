"""Tests of the batch command: each project has a row; a refused one does not stop the others."""

import csv
import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest

import lispac
from lispac.cli.main import main
from lispac.errors import InputError, ProjectError
from lispac.message_texts import message_text
from lispac.messages import as_message, error
from lispac.present.calibration.batch import BatchRow
from lispac.project import Project
from lispac.workflow.output.batch import write_table
from lispac.workflow.planning.demo import demo_seeds
from tests.support.error_codes import has_code
from tests.support.message_codes import is_shown

TRUTH = (0.27, -1.14, 0.36)


@pytest.fixture(scope="module")
def projects(demo_project: Project, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Four projects: with targets, without targets, damaged, and with missing lines."""
    folder = tmp_path_factory.mktemp("projects")
    quay = lispac.open(demo_project.folder)
    for name in ("T1", "T2", "V1", "V2"):
        role, place = demo_seeds()[name]
        quay.seed(name, place, role=role)
    quay.identity(vessel="Saucier", dates="2026-03-04")
    quay.save_as(folder / "2026" / "good")
    quay.save_as(folder / "2027" / "good")
    quay.remove("V1")
    quay.remove("V2")
    quay.save_as(folder / "unvalidated")
    lispac.open(demo_project.folder).save_as(folder / "unpicked")
    shutil.copytree(folder / "unpicked", folder / "broken")
    (folder / "broken" / "project.json").write_text("{")
    shutil.copytree(folder / "unpicked", folder / "moved")
    text = (folder / "moved" / "project.json").read_text(encoding="utf-8")
    (folder / "moved" / "project.json").write_text(text.replace("L3_045.laz", "L3.laz"))
    return folder


def on_disk(folder: Path) -> dict[str, bytes]:
    return {str(path): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def table(path: Path) -> dict[str, dict[str, str]]:
    with path.open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0]) == [
        "folder", "project", "vessel", "dates", "verdict", "roll_deg", "pitch_deg", "yaw_deg",
        "sigma_roll_deg", "sigma_pitch_deg", "sigma_yaw_deg", "sigma_0", "chi_square_passed",
        "rms_before_m", "rms_after_m", "messages",
    ]  # fmt: skip
    return {str(Path(row["folder"])): row for row in rows}


def test_every_project_has_a_row(
    projects: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = on_disk(projects)
    words = ["--output", tmp_path / "table.csv", "--reports", tmp_path, "--report-format", "json"]
    assert main(["batch", str(projects), *map(str, words)]) == 1
    out, err = capsys.readouterr()
    assert on_disk(projects) == before
    failed = error("cli.projects_failed", count=3, total=6, names=("broken", "moved", "unpicked"))
    assert err == f"lispac: {message_text(failed)}\n"
    rows = table(tmp_path / "table.csv")
    assert len(rows) == 6
    for name, code in (
        ("broken", "project.damaged"), ("moved", "project_files.one_missing"),
        ("unpicked", "estimate.no_target"),
    ):  # fmt: skip
        row = rows[str(projects / name)]
        assert row["verdict"] == "refused"
        assert is_shown(code, row["messages"])
        assert row["roll_deg"] == row["sigma_0"] == row["rms_after_m"] == ""
        assert f"{name}: " in out

    good = rows[str(projects / "2026" / "good")]
    assert (good["vessel"], good["dates"]) == ("Saucier", "2026-03-04")
    quay = lispac.open(projects / "2026" / "good")
    quay.estimate()
    planes = quay.validate()
    for k, angle in enumerate(("roll", "pitch", "yaw")):
        value, sigma = float(good[f"{angle}_deg"]), float(good[f"sigma_{angle}_deg"])
        assert abs(value - TRUTH[k]) < 3 * sigma
        assert (value, sigma) == (quay.boresight_deg[k], quay.sigma_deg[k])
        assert re.search(rf"{re.escape(f'{value:+.4f}')} +{sigma:.4f}", out)
    for state in ("before", "after"):
        found = [getattr(plane, state) for plane in planes]
        square = sum(each.n * each.rms**2 for each in found) / sum(each.n for each in found)
        assert float(good[f"rms_{state}_m"]) == pytest.approx(np.sqrt(square), rel=1e-12)
    assert float(good["rms_after_m"]) < float(good["rms_before_m"])
    assert good["chi_square_passed"] in ("yes", "no")

    reports = sorted(path.name for path in tmp_path.glob("*.json"))
    assert reports == ["good-2.json", "good.json", "unvalidated.json"]
    report = json.loads((tmp_path / "good.json").read_text(encoding="utf-8"))
    assert good["verdict"] == (
        "warnings" if any(c["level"] != "note" for c in report["warnings"]) else "notes"
    )
    assert len(good["messages"].split(" | ")) == len(report["warnings"])
    unvalidated = rows[str(projects / "unvalidated")]
    assert unvalidated["rms_after_m"] == ""
    assert unvalidated["roll_deg"] == good["roll_deg"]


@pytest.mark.long
def test_results_are_saved_on_request(
    projects: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "one"
    lispac.open(projects / "2026" / "good").save_as(folder / "quay")
    assert main(["batch", str(folder), "--save", "--json"]) == 0
    (row,) = json.loads(capsys.readouterr().out)["projects"]
    saved = lispac.open(folder / "quay")
    assert list(saved.boresight_deg) == list(row["boresight_deg"].values())
    assert [plane.name for plane in saved.project.validation] == ["V1", "V2"]


def test_table_cells_keep_commas_quotes_and_newlines(tmp_path: Path) -> None:
    messages = tuple(map(as_message, ("one, two", "three")))
    row = BatchRow(Path("a,b"), 'the "first"', "refused", messages, vessel="Léonie,\nII")
    write_table([row], tmp_path / "table.csv")
    (read,) = table(tmp_path / "table.csv").values()
    assert read["project"] == 'the "first"'
    assert read["messages"] == "one, two | three"
    assert read["vessel"] == "Léonie,\nII"


def test_wrong_folders_and_formats_are_refused_before_the_work(
    projects: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(ProjectError) as raised:
        lispac.batch(tmp_path)
    assert raised.value.code == "history.no_project"
    with pytest.raises(ProjectError) as raised:
        lispac.batch(tmp_path / "nowhere")
    assert raised.value.code == "history.no_folder"
    with pytest.raises(InputError, check=has_code("report.format", format="doc")):
        lispac.batch(projects, form="doc")
    assert main(["batch", str(projects), "--report-format", "pdf"]) == 2
    assert "require --reports DIR" in capsys.readouterr().err
