"""Tests of the tables and notes that commands print about given results."""

import subprocess
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from lispac.cli.calibration.estimate import print_weak_sightings
from lispac.cli.calibration.pick import search_notes
from lispac.cli.checking.validate import print_validation
from lispac.cli.planning import demo
from lispac.installation_paths import window_command
from lispac.io.config.plan_file import read_plan
from lispac.io.project.project_file import write_project
from lispac.io.text.plane_file import write_plane_file
from lispac.message_texts import english_text, message_text
from lispac.messages import Message, as_message, note
from lispac.picked_targets import Target
from lispac.present.angles import Angles
from lispac.present.calibration.error_budget import (
    BeamErrors,
    ErrorBudgetValues,
    ErrorSource,
    PointError,
)
from lispac.present.calibration.subsampling import SubsamplingValues
from lispac.simulation.thesis_site import MARINE_SITE
from lispac.survey.conventions.mounting_texts import UNCORRELATED_WARNING
from lispac.survey.georeferencing import Mounting
from lispac.targets.sighting_quality import SightingQuality
from lispac.workflow.planning import sensors
from tests.cli.test_cli import import_workflow, run, run_json
from tests.support.narrow_site import narrow_site
from tests.support.report_sample import sample_project
from tests.support.surveys import TARGETS, planar_survey

import_workflow()


def printed_by(capsys: pytest.CaptureFixture[str], *words: object) -> tuple[str, str]:
    """Output and notes of a command that succeeds."""
    code, out, err = run(capsys, *words)
    assert code == 0, err
    return out, err


def quality(light: str, *reasons: Message) -> SightingQuality:
    return SightingQuality(
        500, 0.003, 15.0, 900.0, 0.3, np.ones(2), 0.9, 0.0, False, 0.0, light, reasons  # type: ignore[arg-type]
    )  # fmt: skip


def test_only_weak_sightings_are_listed_the_poor_ones_first(
    capsys: pytest.CaptureFixture[str],
) -> None:
    few, sparse = note("quality.few_points", count=48), note("quality.sparse", share=0.4)
    found = {
        ("T1", "L1"): quality("good"),
        ("T1", "L2"): quality("doubtful", few),
        ("T2", "L1"): quality("poor", sparse),
    }
    print_weak_sightings(found)
    assert capsys.readouterr().out.splitlines()[2:] == [
        f"- T2 on L1: Poor. {message_text(sparse)}", f"- T1 on L2: Doubtful. {message_text(few)}",
    ]  # fmt: skip
    print_weak_sightings({("T1", "L1"): quality("good")})
    assert capsys.readouterr().out == ""


def test_planes_that_were_not_compared_are_reported_with_the_reason(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    project = replace(
        sample_project(tmp_path), not_compared={"V4": as_message("V4: seen on one line.")}
    )
    print_validation(project, {"V1": 0.0123})
    rows = capsys.readouterr().out.splitlines()
    assert rows[1].split()[-2:] == ["with", "truth"]
    one, two = (row.split() for row in rows[2:4])
    assert (one[0], one[-1]) == ("V1", "12.3")
    assert (two[0], two[-1]) == ("V2", "-"), "no truth is known of it"
    assert "not compared: V4: seen on one line." in rows


@pytest.mark.parametrize(
    ("given_radius", "radius", "notes"),
    [
        (None, 1.0, ()),
        (None, 3.0, (note("finder.radius_increased", target="T1", usual=2.0, radius=3.0),)),
        (3.0, 3.0, ()),
    ],
)  # fmt: skip
def test_a_wider_search_for_a_target_is_noted(
    given_radius: float | None, radius: float, notes: tuple[Message, ...]
) -> None:
    assert (
        search_notes(Target("T1", "target", (0.0, 0.0, 0.0), 0.01, radius, ()), given_radius)
        == notes
    )


def one_line(path: Path) -> Path:
    """Make a plan with only one line, which does not determine the angles."""
    text = (Path(__file__).parents[1] / "data" / "port-plan.toml").read_text()
    path.write_text(text[: text.index("[[lines]]", text.index("[[lines]]") + 1)])
    return path


def test_undetermined_angles_of_a_plan_have_no_sigma(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    plan = one_line(tmp_path / "plan.toml")
    out, _ = printed_by(capsys, "predict", plan)
    assert message_text(note("design.undetermined")) in " ".join(out.split())
    assert "sigma      " not in out
    assert "roll-pitch" not in out
    assert "Omitted" in out


def test_a_new_project_has_no_identity(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    write_project(project)
    before = (project.folder / "project.json").read_bytes()
    out, err = printed_by(capsys, "identity", project.folder)
    assert {row.split()[-1] for row in out.splitlines()} == {"-"}
    assert err == ""
    assert (project.folder / "project.json").read_bytes() == before, "nothing is written"
    out, _ = printed_by(capsys, "identity", project.folder, "--remarks", "First.\nSecond.")
    first, second = out.splitlines()[-2:]
    assert first.split() == ["Remarks", "First."]
    assert second == second.strip().rjust(len(second))
    assert second.index("Second.") == first.index("First.")


def test_files_found_beside_a_project_that_was_moved_are_reported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    raw = tmp_path / "raw"
    project = replace(sample_project(raw), folder=tmp_path / "home")
    write_project(project)
    raw.rename(project.folder / "raw")
    out, err = printed_by(capsys, "locate", project.folder, tmp_path)
    rows = out.splitlines()
    assert len(rows) == 8, "a trajectory, its accuracy and six lines"
    assert all(str(project.folder / "raw") in row for row in rows)
    assert err == ""
    (answer,) = printed_by(capsys, "locate", project.folder, tmp_path)[0].splitlines()
    assert "raw" not in answer, "no file is missing"


def test_an_unreadable_user_defined_sensor_is_a_warning(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sensors, "user_folder", lambda: tmp_path)
    damaged = tmp_path / "sensors" / "scanners" / "mine.toml"
    damaged.parent.mkdir(parents=True)
    damaged.write_text("title = ")
    out, err = printed_by(capsys, "sensors")
    assert err.startswith(f"warning: {damaged}: ")
    assert "mine" not in out.replace(str(tmp_path), "")
    assert "Z+F PROFILER 9012" in out


def test_plane_files_are_adjusted_and_reported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    true = Mounting(np.array([0.1, -0.2, 0.3]), np.radians([0.27, -1.14, 0.36]))
    observations = planar_survey(true, points=40)
    files = [tmp_path / f"{name}.txt" for name in ("T1", "T2")]
    nowhere = np.zeros_like(observations.points_lidar)  # georeferenced points are not read
    for path in files:
        centre, normal = TARGETS[path.stem]
        plane = np.append(normal, -normal @ centre)
        write_plane_file(path, observations, path.stem, nowhere, plane)
    words = ("estimate", "--planes", *files, "--lever-arm", 0.1, -0.2, 0.3, "--no-cross-checks")
    out, _ = printed_by(capsys, *words)
    numbers = run_json(capsys, *words)
    rows = [line.split() for line in out.splitlines()[2:5]]
    assert [row[0] for row in rows] == ["Roll", "Pitch", "Yaw"]
    np.testing.assert_allclose([float(row[2]) for row in rows], [0.27, -1.14, 0.36], atol=1e-4)
    assert list(numbers["boresight_deg"].values()) == pytest.approx([0.27, -1.14, 0.36], abs=1e-4)


def test_the_window_opens_at_the_end_of_the_demo_where_there_is_a_screen(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    project = replace(sample_project(tmp_path / "demo"), truth_deg=(0.27, -1.14, 0.36))
    started: list[list[str]] = []
    made = (project, SimpleNamespace(headings_deg={}))
    monkeypatch.setattr("lispac.workflow.planning.demo.run_demo", lambda *_, **__: made)
    monkeypatch.setattr("lispac.workflow.output.export.write_report", lambda *_: None)
    monkeypatch.setattr(demo, "rms_with_truth", lambda *_: {"V1": 0.0123})
    monkeypatch.setattr(subprocess, "run", lambda words, **_: started.append(words))
    monkeypatch.setattr(demo, "has_display", lambda: True)
    out, _ = printed_by(capsys, "demo", "--output", project.folder)
    assert started == [[*window_command(), str(project.folder)]]
    rows = [line.split() for line in out.splitlines()[2:5]]
    assert [row[6] for row in rows] == ["+0.2700", "-1.1400", "+0.3600"]
    printed_by(capsys, "demo", "--output", project.folder, "--no-window")
    monkeypatch.setattr(demo, "has_display", lambda: False)
    numbers = run_json(capsys, "demo", "--output", project.folder)
    assert len(started) == 1
    assert numbers["report"] == str(project.folder / "report.pdf")
    assert numbers["truth_deg"] == {"roll": 0.27, "pitch": -1.14, "yaw": 0.36}
    assert numbers["rms_truth_m"] == {"V1": 0.0123}


def test_the_visibility_study_is_reported_beside_the_thesis(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    few = replace(MARINE_SITE, inclinations=tuple(np.radians([0.0, 30.0, 60.0, 90.0]).tolist()))
    monkeypatch.setattr("lispac.simulation.thesis_site.SITES", {"marine": few})
    monkeypatch.setattr(
        "lispac.workflow.planning.visibility.write_visibility",
        lambda *_, **__: [tmp_path / "a.csv"],
    )
    words = ("visibility", "marine", "--output", tmp_path, "--error", "roll", "yaw")
    rows = printed_by(capsys, *words)[0].splitlines()
    assert rows[1].split()[0] == "Error"
    assert [row.split("  ")[1] for row in rows[2:4]] == ["Roll 2 deg", "Yaw 2 deg"]
    assert rows[4] == ""
    assert any(row.startswith("Yaw 2 deg: ") for row in rows[5:])
    assert not any(row.startswith("Roll 2 deg: ") for row in rows[5:]), "it is as in the thesis"
    assert not any(row.startswith("Pitch") for row in rows), "it is not asked for"
    assert rows[-1] == f"1 files in {tmp_path}"
    assert printed_by(capsys, *words, "--hit-beams")[0] == f"1 files in {tmp_path}\n"


def test_offsets_and_warnings_are_printed_with_the_angles_of_a_project(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    project = sample_project(tmp_path, model="independent")
    assert project.result is not None
    mounting = replace(project.result.mounting, range_offset=-0.05, latency=0.02)
    write_project(replace(project, result=replace(project.result, mounting=mounting)))
    out, _ = printed_by(capsys, "angles", project.folder)
    words = " ".join(out.split())
    assert "range offset -0.0500 m" in words
    assert "latency +20.0000 ms" in words
    assert words.count(" ".join(message_text(UNCORRELATED_WARNING).split())) == 1, (
        "the sigmas are told to be too small"
    )
    write_project(sample_project(tmp_path))
    words = " ".join(printed_by(capsys, "angles", project.folder)[0].split())
    assert message_text(UNCORRELATED_WARNING) not in words
    assert "range offset" not in words


def test_a_system_with_a_matrix_only_shows_no_angles(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    matrix = tmp_path / "matrix.txt"
    np.savetxt(matrix, np.eye(3))
    words = ("angles", "--from-matrix", matrix, "--from", "pdal", "--to", "lispac")
    out, _ = printed_by(capsys, *words)
    before, after = out.split("\nTo ")
    assert before.startswith("From PDAL")
    assert "(deg)" not in before
    assert "(deg)" in after
    assert "Lever arm" not in out, "none was given"


def test_a_budget_shows_sources_of_unknown_size(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    known = ErrorSource("POS position", (PointError(0.012, 0.02, 0.01, 0.03),))
    unknown = ErrorSource("Lever arm", None)
    beam = BeamErrors("horizontal, to starboard", (known, unknown), known, known)
    found = ErrorBudgetValues((50.0,), (beam,), (note("budget.no_latency"),))
    monkeypatch.setattr("lispac.workflow.project.survey.load_survey", lambda *_, **__: None)
    monkeypatch.setattr("lispac.workflow.checking.budget.error_budget_of", lambda *_, **__: None)
    monkeypatch.setattr(ErrorBudgetValues, "of", lambda _: found)
    write_project(sample_project(tmp_path))
    rows = printed_by(capsys, "budget", tmp_path)[0].splitlines()
    assert rows[0].endswith("beam horizontal, to starboard")
    assert rows[2].split() == ["POS", "position", "1.20", "2.00", "1.00"]
    assert rows[3].split() == ["Lever", "arm", "not", "given", "-", "-"]
    assert len(rows[3]) == len(rows[2])
    assert rows[-1] == english_text(note("budget.no_latency"))


def test_the_table_has_a_row_for_each_distance_and_one_for_all_points(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    angles, sigma = Angles(0.27, -1.14, 0.36), Angles(0.01, 0.02, 0.03)
    rows = (
        SubsamplingValues(0.0, 12_345, angles, sigma, 1.5),
        SubsamplingValues(0.1, 2_345, angles, sigma, 0.25),
    )
    monkeypatch.setattr("lispac.workflow.project.survey.load_survey", lambda *_, **__: None)
    monkeypatch.setattr(
        "lispac.workflow.checking.subsampling.subsampling_study", lambda *_, **__: rows
    )
    write_project(sample_project(tmp_path))
    _, heads, every, some, _ = (
        row.split() for row in printed_by(capsys, "subsample", tmp_path)[0].splitlines()
    )
    assert heads[:4] == ["Point", "spacing", "(m)", "Points"]
    of_all = ["+0.2700", "0.0100", "-1.1400", "0.0200", "+0.3600", "0.0300"]
    assert every == ["all", "points", "12,345", *of_all, "1.50"]
    assert some == ["0.10", "2,345", *of_all, "0.25"]


def test_a_design_is_compared_with_a_usual_plan_that_is_undetermined(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    site, folder = tmp_path / "site.toml", tmp_path / "out"
    site.write_text(narrow_site({"up_m = [2, 5, 8]": "up_m = [5]"}))
    usual = read_plan(one_line(tmp_path / "plan.toml")).plan
    monkeypatch.setattr("lispac.design.plan_choices.thesis_plan", lambda _: usual)
    written: list[Path] = []
    monkeypatch.setattr(
        "lispac.workflow.planning.plan_checks.write_design",
        lambda folder, *_: written.append(folder),
    )
    out, _ = printed_by(capsys, "design", site, "--workers", 1, "--output", folder)
    rows = out.splitlines()
    assert rows[3].split()[:2] == ["this", "plan"]
    assert rows[4].split("  ")[1:3] == ["reference plan", "not determined"]
    assert rows[-1] == str(folder)
    assert written == [folder]
    numbers = run_json(capsys, "design", site, "--workers", 1)
    assert numbers["thesis_sigma_deg"] is None
    assert len(written) == 1, "nothing is written where no folder is named"
