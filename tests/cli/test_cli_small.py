"""Tests of the text and JSON output of commands on a small survey.

Computations that take long and are tested elsewhere are replaced by small given results.
"""

import json
import shutil
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import lispac
from lispac.cli.calibration import patchtest
from lispac.errors import ProjectError
from lispac.io.project.project_file import read_project, write_project
from lispac.message_texts import english_text
from lispac.messages import note
from lispac.patchtest.bootstrap_precision import ObjectAgreement
from lispac.patchtest.line_pairs import LinePair
from lispac.patchtest.object_boxes import ObjectBox, PatchObject
from lispac.patchtest.patch_test_result import PatchTestResult
from lispac.picked_targets import PickedSighting, Target
from lispac.present.calibration.patch_test import PatchTestValues
from lispac.present.json_values import json_values
from lispac.project import LineSource, Project
from lispac.targets.sighting_quality import undetermined_quality
from lispac.validation.absolute_check import PointCheck
from lispac.workflow.calibration import patch_test
from lispac.workflow.calibration.proposals import Proposal
from lispac.workflow.calibration.seed_lists import ListedSeed, SeedOutcome
from lispac.workflow.calibration.targetless import TargetlessResult
from lispac.workflow.project.survey import Survey, load_survey
from tests.cli.test_cli import import_workflow, run, run_json, run_refused
from tests.support.report_sample import sample_project
from tests.support.sharing import make_once
from tests.validation.test_absolute_warnings import check as against_reference

import_workflow()

TWO_METRE_BOX = ObjectBox(np.array([0.0, -15.0, 5.0]), np.array([2.0, 2.0, 2.0]))


def _make_small_demo(folder: Path) -> Project:
    return lispac.demo(folder, points_per_second=5_000.0).project


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The built-in survey with few points; tests must not change it on disk."""
    return make_once(tmp_path_factory, "small", _make_small_demo)


@pytest.fixture
def project(small: Project, tmp_path: Path) -> Project:
    """A project of the same files in a separate folder."""
    copy_of_project = replace(small, folder=tmp_path / "mine")
    write_project(copy_of_project)
    return copy_of_project


@pytest.fixture(scope="module")
def survey(small: Project) -> Survey:
    """Its lines, aligned once."""
    return load_survey(small)


@pytest.fixture
def loaded(survey: Survey, monkeypatch: pytest.MonkeyPatch) -> None:
    """Make commands use the survey that is already loaded."""
    monkeypatch.setattr("lispac.workflow.project.survey.load_survey", lambda *_, **__: survey)


def printed_by(capsys: pytest.CaptureFixture[str], *words: object) -> tuple[str, str]:
    """Output and notes of a command that succeeds."""
    code, out, err = run(capsys, *words)
    assert code == 0, err
    return out, err


def test_a_script_creates_and_changes_a_project(small: Project, project: Project) -> None:
    assert small.targets == ()
    assert read_project(small.folder).lines == small.lines
    opened = lispac.open(project.folder)
    before, survey = opened.project, opened.survey
    opened.change(subsample=before.settings.subsample)
    assert opened.project is before, "a setting as it was changes nothing"
    opened.change(subsample=0.3)
    assert opened.project.settings.subsample == 0.3
    with pytest.raises(ProjectError) as error:
        opened.seed("T1")
    assert error.value.code == "script.place_or_point"
    assert error.value.message.params == {"name": "T1"}
    again = project.folder.parent / "again"
    first, *others = small.lines
    made = lispac.new(
        again, lines=[replace(first, name="first")], trajectory=small.trajectory,
        lever_arm=small.settings.lever_arm, origin_deg_m=small.settings.origin_deg_m,
    )  # fmt: skip
    made.add_lines(others[0].path, LineSource("third", others[1].path))
    assert [line.name for line in made.project.lines] == ["first", others[0].path.stem, "third"]
    for name, line in zip(made.survey.lines, small.lines, strict=False):
        added, usual = made.survey.scans[name], survey.scans[line.name]
        assert len(added) == len(usual)
        assert (added.first_time, added.last_time) == (usual.first_time, usual.last_time)


class FakePatchTest:
    """Stand-in for the patch test that records its pairs and returns a given result."""

    def __init__(self) -> None:
        self.pairs: tuple[LinePair, ...] = ()
        self.line_pairs = patch_test.line_pairs

    def propose_objects(self, *_: object, count: int, **__: object) -> SimpleNamespace:
        found = tuple(PatchObject(f"A0{k + 1}", TWO_METRE_BOX) for k in range(count))
        return self.place_objects(None, None, found, np.radians([0.2, -1.0, 0.3]))

    def place_objects(
        self, _: object, __: object, objects: Sequence[PatchObject], boresight: np.ndarray
    ) -> SimpleNamespace:
        return SimpleNamespace(objects=objects, boresight=boresight)

    def find_boresight(
        self, _: object, __: object, laid: SimpleNamespace, *, pairs: tuple[LinePair, ...],
        **___: object,
    ) -> PatchTestResult:  # fmt: skip
        self.pairs = pairs
        named = [each.name for each in laid.objects]
        objects = tuple(ObjectAgreement(name, ("L1 L2",), 0.01, 0, 0.0, 0.001) for name in named)
        return patch_test_result(laid.boresight, objects)


def patch_test_result(angles: np.ndarray, objects: tuple[ObjectAgreement, ...]) -> PatchTestResult:
    return PatchTestResult(
        angles, angles, np.diag(np.radians([0.01, 0.02, 0.03]) ** 2), np.array([10.0, 20.0, 30.0]),
        0.05, 0.01, ("L1", "L2", "L3"), objects, 3, True,
    )  # fmt: skip


def test_a_patch_test_uses_the_given_objects_and_pairs(
    capsys: pytest.CaptureFixture[str], project: Project, survey: Survey,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    bench = FakePatchTest()
    monkeypatch.setattr("lispac.workflow.calibration.patch_test", bench)
    placed = SimpleNamespace(mounting=project.mounting("prior"))
    shown = SimpleNamespace(heading=survey.heading, clouds=survey.clouds, alignment=placed)
    monkeypatch.setattr("lispac.workflow.project.survey.load_survey", lambda *_, **__: shown)

    def objects(*words: object) -> list[str]:
        found = run_json(capsys, "patchtest", project.folder, *words)
        return [each["name"] for each in found["objects"]]

    object_options = ("--object", "pole=0,-15,5,1,1,4", "edge=3,-15,5,1,1,4,20")
    assert objects(*object_options) == ["pole", "edge"], "none is looked for besides"
    assert len(bench.pairs) == 15
    assert objects(*object_options, "--count", 2) == ["pole", "edge", "A01", "A02"]
    assert objects("--count", 1, "--pairs", "reciprocal", "crossing") == ["A01"]
    assert {pair.kind for pair in bench.pairs} == {"reciprocal", "crossing"}
    assert objects("--lines", "L1_000", "L2_180", "L3_045", "--count", 1) == ["A01"]
    assert len(bench.pairs) == 3
    rows = printed_by(capsys, "patchtest", project.folder, *object_options)[0].splitlines()
    objects_title = rows.index("Objects")
    assert [row.split()[0] for row in rows[objects_title + 2 : objects_title + 4]] == [
        "pole", "edge",
    ]  # fmt: skip
    assert english_text(note("patch_test.basis", count=2, lines=3)) in rows


def test_an_object_that_differs_is_marked(capsys: pytest.CaptureFixture[str]) -> None:
    angles = np.radians([0.25, -1.1, 0.4])
    objects = (
        ObjectAgreement("pole", ("L1 L2",), 0.012, 0, np.radians(0.01), np.radians(0.05)),
        ObjectAgreement("moved", ("L1 L2", "L1 L3"), 0.04, 2, np.radians(-0.2), np.radians(0.05)),
        ObjectAgreement("ball", ("L1 L2",), 0.02, None, 0.0, 0.0),
    )
    patchtest.print_patch_test(PatchTestValues.of(patch_test_result(angles, objects)))
    rows = capsys.readouterr().out.splitlines()
    assert rows[2].split() == ["+0.2500", "0.0100", "-1.1000", "0.0200", "+0.4000", "0.0300"]
    assert rows[6].split() == ["+0.2500", "-1.1000", "+0.4000"]
    assert rows[10].split() == ["1.7", "3.5", "5.2"]
    rows = rows[rows.index("Objects") :]
    assert rows[2].split() == ["pole", "1", "12.0", "Roll", "+0.0100", "0.0500", "agrees"]
    assert rows[3].split() == ["moved", "2", "40.0", "Yaw", "-0.2000", "0.0500", "DIFFERS"]
    assert rows[4].split() == ["ball", "1", "20.0", "-", "-", "-", "-"], "not judged"
    assert rows[-1].startswith("Object moved disagrees ")


def _target(name: str, role: str, north: float, one_in: int = 1) -> Target:
    sightings = tuple(
        PickedSighting(line, np.arange(50) + len(name), 0.003, one_in=one_in)
        for line in ("L1_000", "L2_180")
    )
    return Target(name, role, (north, -15.0, 5.0), 0.01, 1.5, sightings)  # type: ignore[arg-type]


def test_proposed_targets_are_shown_with_reasons_and_added_on_request(
    capsys: pytest.CaptureFixture[str], project: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    targets = (_target("T1", "target", 1.25), _target("V1", "validation", -4.0, one_in=3))
    reasons = {
        "T1": note("propose.target_needed", lines=2),
        "V1": note("propose.validation_plane", area=2.0, lines=2, height=3.0),
    }
    needed, flat = map(english_text, reasons.values())
    proposal = Proposal(targets, reasons, lambda _names: np.radians([0.01, 0.02, 0.03]))
    monkeypatch.setattr(
        "lispac.workflow.calibration.proposals.propose_targets", lambda *_, **__: proposal
    )
    out, err = printed_by(capsys, "propose", project.folder)
    assert out.splitlines() == [
        "T1   target     at east 15.000, north 1.250, up 5.000 m", f"     {needed}",
        "V1   validation at east 15.000, north -4.000, up 5.000 m",
        f"     {flat.replace('²', '2')}",
        "Predicted standard deviations",
        "               Roll (deg)  Pitch (deg)  Yaw (deg)",
        "  all targets      0.0100       0.0200     0.0300", "",
        f"note: {english_text(note('propose.check_movable'))}",
    ]  # fmt: skip
    assert [row.split(":")[1] for row in err.splitlines()] == [" V1 on L1_000", " V1 on L2_180"]
    assert "one in 3 of them" in err
    assert read_project(project.folder).targets == ()
    numbers = run_json(capsys, "propose", project.folder, "--accept")
    assert numbers["accepted"] is True
    assert numbers["sigma_deg"] == pytest.approx({"roll": 0.01, "pitch": 0.02, "yaw": 0.03})
    assert numbers["targets"][0] == {
        "name": "T1", "role": "target", "seed_m": [1.25, -15.0, 5.0],
        "reason": json_values(reasons["T1"]),
        "lines": {line: {"points": 50, "rms_m": 0.003} for line in ("L1_000", "L2_180")},
    }  # fmt: skip
    kept = read_project(project.folder).targets
    assert [(each.name, each.role) for each in kept] == [("T1", "target"), ("V1", "validation")]


def test_the_result_of_the_scene_is_printed_and_saved_on_request(
    capsys: pytest.CaptureFixture[str], project: Project, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    """The project has a target, so the result of the scene is saved as an alternative method."""
    sighting = PickedSighting("L1_000", np.arange(50), 0.003)
    project = replace(
        project, targets=(Target("A", "target", (1.25, -15.0, 5.0), 0.015, 1.0, (sighting,)),)
    )
    write_project(project)
    found = TargetlessResult(sample_project(tmp_path / "sample"), 3, False, 40, ("L6",))
    monkeypatch.setattr("lispac.workflow.calibration.targetless.targetless", lambda *_, **__: found)
    out, _ = printed_by(capsys, "targetless", project.folder)
    texts = list(map(english_text, found.messages))
    assert out.splitlines()[-len(texts) :] == texts
    assert out.startswith("Boresight\n")
    assert read_project(project.folder).alternative_results == ()
    numbers = run_json(capsys, "targetless", project.folder, "--save")
    assert list(numbers["boresight_deg"].values()) == pytest.approx(
        np.degrees(found.result.boresight).tolist()
    )
    assert numbers["messages"] == json_values(found.messages)
    expected = {"matching_iterations": 3, "converged": False, "candidates": 40, "given_targets": 0}
    assert {key: numbers[key] for key in expected} == expected
    assert numbers["disagreeing_lines"] == ["L6"]
    kept = read_project(project.folder).alternative_result("targetless")
    assert kept is not None
    np.testing.assert_allclose(kept.boresight, found.result.boresight)


@pytest.mark.usefixtures("loaded")
def test_lines_without_common_surfaces_are_noted_by_name(
    capsys: pytest.CaptureFixture[str], project: Project
) -> None:
    out, err = printed_by(capsys, "quality", project.folder)
    apart = note("validation.no_flat_place", line="L1_000", other="L4_225")
    assert err == f"note: {english_text(apart)}\n"
    rows = [row.split()[:2] for row in out.splitlines()[2:] if row]
    compared = {(one, other) for one, other in rows if one != "all"}
    assert compared
    assert ("L1_000", "L4_225") not in compared


@pytest.mark.usefixtures("loaded")
def test_surveyed_points_have_a_separate_table(
    capsys: pytest.CaptureFixture[str], project: Project,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    points = (PointCheck("A1", 6, 0.003, -0.2, 0.0041, 0.025), PointCheck("OLD", 2, 0.01, 0.1, 0.1))
    found = against_reference({"L1": 0.004}, points=points)
    notes = (note("assumed.local_frame"),)
    monkeypatch.setattr(
        "lispac.workflow.checking.absolute_check.check_absolute",
        lambda project, *_, **__: (project.with_absolute(found), notes),
    )
    out, err = printed_by(capsys, "check", project.folder, "--reference", "points.csv")
    assert err == f"note: {english_text(notes[0])}\n"
    _heads, *rows = out[out.index("Distances from surveyed points") :].splitlines()[1:4]
    assert [row.split() for row in rows] == [
        ["A1", "6", "3.0", "-200.0", "+4.1", "+/-", "25.0", "no"],
        ["OLD", "2", "10.0", "+100.0", "+100.0", "-", "no"],
    ]
    assert read_project(project.folder).absolute == found


def test_a_script_reports_a_missing_file(
    capsys: pytest.CaptureFixture[str], project: Project, tmp_path: Path
) -> None:
    line = Path(shutil.copy(project.lines[0].path, tmp_path / "L1_000.laz"))
    moved = replace(project, lines=(replace(project.lines[0], path=line), *project.lines[1:]))
    write_project(moved)
    printed_by(capsys, "import", project.folder, "--lines", "L1_000")
    line.unlink()
    out, err = printed_by(capsys, "script", project.folder)
    missing = note("script.missing_files", files=(str(line),))
    assert err == f"note: {english_text(missing)}\n"
    assert "project.import_lines(['L1_000'])" in out
    numbers = run_json(capsys, "script", project.folder)
    assert numbers == {"schema_version": 1, "script": out, "messages": json_values([missing])}


def test_a_line_with_a_damaged_store_is_imported_again(
    capsys: pytest.CaptureFixture[str], project: Project
) -> None:
    words = ("import", project.folder, "--lines", "L1_000")
    out, err = printed_by(capsys, *words)
    assert "points/s" in out
    assert "imported again" not in err
    (manifest,) = project.folder.rglob("store.json")
    manifest.write_text("{")
    out, err = printed_by(capsys, *words)
    assert "points/s" in out
    beginning, _ = english_text(note("import.repeated", line="L1_000", reason="|")).split("|")
    assert err.startswith(f"note: {beginning}")
    assert "imported already" in printed_by(capsys, *words)[0]


@pytest.mark.usefixtures("loaded")
def test_a_seed_without_a_target_has_a_reason_in_json(
    capsys: pytest.CaptureFixture[str], project: Project, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    seeds = tmp_path / "seeds.csv"
    seeds.write_text("T1,-1.1,-14.38,7.7\nAIR,0.0,-14.4,60.0\n")

    def picked(
        project: Project, _: Survey, listed: Sequence[ListedSeed], *__: object, **___: object
    ) -> tuple[Project, tuple[SeedOutcome, ...]]:
        there, none = listed
        target = _target(there.name, there.role, -1.1)
        found = (SeedOutcome(there, target), SeedOutcome(none, None, note("finder.not_alike")))
        return project.with_target(target), found

    quality = undetermined_quality(50, 0.003, note("quality.few_points", count=50))
    monkeypatch.setattr(
        "lispac.workflow.calibration.sighting_assessment.assess_target",
        lambda *_: {"L1_000": quality, "L2_180": quality},
    )
    monkeypatch.setattr("lispac.workflow.calibration.seed_lists.pick_seeds", picked)
    code, out, err = run(capsys, "pick", project.folder, "--seeds", seeds, "--json")
    assert code == 1
    good, none = json.loads(out)["seeds"]
    assert (good["name"], good["found"], good["reason"]) == ("T1", True, None)
    assert set(good["lines"]) == {"L1_000", "L2_180"}
    assert good["lines"]["L1_000"]["quality"]["reasons"] == json_values(
        [note("quality.few_points", count=50)]
    )
    assert none == {
        "row": 2, "name": "AIR", "role": "target", "seed_m": [0.0, -14.4, 60.0], "found": False,
        "reason": json_values(note("finder.not_alike")), "lines": {}, "missing": {},
    }  # fmt: skip
    assert "AIR" in err
    assert [target.name for target in read_project(project.folder).targets] == ["T1"]


@pytest.mark.usefixtures("loaded")
def test_the_absence_of_warnings_is_reported(
    capsys: pytest.CaptureFixture[str], project: Project,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    monkeypatch.setattr(
        "lispac.workflow.calibration.sighting_assessment.sighting_qualities", lambda *_, **__: {}
    )
    monkeypatch.setattr("lispac.workflow.checking.warnings.warnings_of", lambda *_: ())
    assert printed_by(capsys, "warnings", project.folder) == ("No warnings.\n", "")
    assert run_json(capsys, "warnings", project.folder) == {
        "schema_version": 1, "warnings": [],
    }  # fmt: skip


def test_methods_without_a_result_are_noted_with_the_reason(
    capsys: pytest.CaptureFixture[str], small: Project, tmp_path: Path
) -> None:
    """With one line, only the method of targets has a result."""
    sample = sample_project(tmp_path / "sample")
    project = replace(small, folder=tmp_path / "p", result=sample.result, lines=small.lines[:1])
    write_project(project)
    out, err = printed_by(capsys, "compare", project.folder, "--compute")
    assert out.splitlines()[2].startswith("  Targets ")
    notes = dict(row.removeprefix("note: ").split(": ", 1) for row in err.splitlines())
    assert set(notes) == {"natural planes", "targetless", "patch test"}
    alone = note("patch_test.single_line", project=project.name)
    assert english_text(alone) in notes["targetless"]
    assert "not run yet" not in err
    _, err = printed_by(capsys, "compare", project.folder)
    assert err.count("not run yet") == 3
    bare = replace(project, result=None)
    write_project(bare)
    assert "or --compute" in run_refused(capsys, "compare", project.folder)


def test_the_trajectory_is_exported_as_text(
    capsys: pytest.CaptureFixture[str], project: Project, tmp_path: Path
) -> None:
    path = tmp_path / "track.txt"
    words = ("export", project.folder, "--what", "trajectory", "--format", "text", "--output", path)
    found = run_json(capsys, *words)
    assert found == {"schema_version": 1, "files": [str(path)]}
    out, err = printed_by(capsys, *words)
    assert out == f"{path}\n"
    assert "SBET" not in err, "what an SBET lacks is not said of a text"
    assert "datum" in err
