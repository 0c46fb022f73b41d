"""Tests of the results of alternative methods: storage and comparison with the targets."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.model.parameters import mounting_value_names
from lispac.alternative_methods import AlternativeResult, Method
from lispac.errors import AdjustmentError, ProjectError
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.message_texts import english_text
from lispac.messages import Message, error, note
from lispac.method_comparison import comparison_messages, method_results, missing_methods
from lispac.project import Project, Settings
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.method_runs import adjust_natural_planes
from lispac.workflow.project.survey import Survey
from tests.cli.test_cli import run, run_json, run_refused
from tests.support.report_sample import sample_project


def alternative(
    project: Project, method: Method, difference_deg: tuple[float, float, float]
) -> AlternativeResult:
    """Return a result that differs from the targets' result and has the same covariance."""
    assert project.result is not None
    return AlternativeResult(
        method,
        project.result.boresight + np.radians(difference_deg),
        np.array(project.result.covariance),
        ("L1", "L2"),
        30,
        (note("patch_test.not_converged"),),
    )


def test_each_method_is_compared_with_the_targets(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    assert project.result is not None
    project = project.with_alternative_result(alternative(project, "targetless", (0.3, 0.0, 0.0)))
    project = project.with_alternative_result(
        alternative(project, "natural planes", (0.0, 0.001, 0.0))
    )
    found = method_results(project)
    assert [each.method for each in found] == ["targets", "natural planes", "targetless"]
    assert (found[0].lines, found[0].surfaces, found[0].against) == (6, 2, None)
    assert (found[2].lines, found[2].surfaces) == (2, 30)
    far = found[2].against
    assert far is not None
    assert np.degrees(far.angles) == pytest.approx([0.3, 0.0, 0.0])
    sigma = np.degrees(project.result.sigma[0])
    assert far.significance[0] == pytest.approx(0.3 / (np.sqrt(2) * sigma))
    near, differs, shared = comparison_messages(found)
    assert near.code == "methods.agree"
    assert near.params["method"] == note("method.natural_planes")
    assert (differs.code, differs.params["angles"]) == (
        "methods.differ",
        mounting_value_names(["roll"]),
    )
    assert differs.params["method"] == note("method.targetless")
    assert differs.params["displacement"] == pytest.approx(0.262, abs=5e-4)
    assert shared == note("methods.same_lines")
    assert missing_methods(project) == ("patch test",)
    assert comparison_messages(found[:1]) == ()
    # Without targets the first of the other methods is the reference.
    alone = method_results(replace(project, result=None))
    assert [each.method for each in alone] == ["natural planes", "targetless"]
    assert alone[0].against is None


def test_one_result_per_method_is_kept_until_its_basis_changes(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    for method, off in (("targetless", 1.0), ("natural planes", 0.0), ("targetless", 0.0)):
        project = project.with_alternative_result(alternative(project, method, (off, 0.0, 0.0)))  # type: ignore[arg-type]
    assert [each.method for each in project.alternative_results] == ["natural planes", "targetless"]
    assert project.result is not None
    kept = project.alternative_result("targetless")
    assert kept is not None
    np.testing.assert_array_equal(kept.boresight, project.result.boresight)
    without = project.without_target("V1")
    assert [each.method for each in without.alternative_results] == ["targetless"]
    assert len(project.without_target("T1").alternative_results) == 2
    assert project.with_settings(Settings((0.0, 0.0, 1.0))).alternative_results == ()


def test_results_are_saved_and_invalid_ones_are_refused(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    project = project.with_alternative_result(
        alternative(project, "patch test", (0.01, 0.02, 0.03))
    )
    write_project(project)
    (again,) = read_project(tmp_path).alternative_results
    (kept,) = project.alternative_results
    np.testing.assert_array_equal(again.covariance, kept.covariance)
    np.testing.assert_array_equal(again.boresight, kept.boresight)
    assert (again.method, again.lines, again.surfaces, again.messages) == (
        kept.method, kept.lines, kept.surfaces, kept.messages,
    )  # fmt: skip
    np.testing.assert_array_equal(again.sigma, np.sqrt(np.diag(kept.covariance)))
    path = tmp_path / PROJECT_FILE_NAME
    sound = json.loads(path.read_text())

    def refusal_reason(change: Callable[[dict[str, object]], None]) -> Message:
        content = json.loads(json.dumps(sound))
        change(content["alternative_results"][0])
        path.write_text(json.dumps(content))
        with pytest.raises(ProjectError) as caught:
            read_project(tmp_path)
        assert caught.value.code == "project.damaged"
        return caught.value.message.params["reason"]

    invalid = error("content.invalid_angles", method="patch test")
    assert refusal_reason(lambda one: one.update(covariance=[[0.0] * 3] * 3)) == invalid
    assert refusal_reason(lambda one: one.update(boresight=[0.0, 1.0])) == invalid
    assert refusal_reason(lambda one: one.update(method="guess")).code == "content.wrong_form"


@pytest.mark.long
def test_natural_planes_use_the_validation_planes(calibrated: tuple[Project, Survey]) -> None:
    """The result without boards agrees with the truth within its sigmas."""
    project, survey = calibrated
    assert project.truth_deg is not None
    found = adjust_natural_planes(project, survey)
    assert found.surfaces == len(project.targets_of_role("validation"))
    assert found.lines == tuple(survey.scans)
    off = np.degrees(found.boresight) - project.truth_deg
    assert (np.abs(off) < 3 * np.degrees(found.sigma)).all(), off
    planes = tuple(replace(each, role="target") for each in project.targets_of_role("validation"))
    alone = estimate(replace(project, targets=planes, result=None), survey, cross_check=False)
    assert alone.result is not None
    np.testing.assert_array_equal(found.boresight, alone.result.boresight)
    np.testing.assert_array_equal(found.sigma, alone.result.sigma)
    assert np.degrees(alone.result.with_formal_sigmas.sigma).max() < 0.02
    assert np.degrees(found.sigma).max() < 0.025, "raised by what single lines show"
    few = project
    for plane in project.targets_of_role("validation")[1:]:
        few = few.without_target(plane.name)
    with pytest.raises(AdjustmentError) as raised:
        adjust_natural_planes(few, survey)
    assert raised.value.code == "estimate.few_validation_planes"


def test_compare_command(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    write_project(project)
    code, out, err = run(capsys, "compare", tmp_path / "p")
    assert code == 0
    assert "Targetless" not in out, "the targets alone"
    assert err.count("note: not run yet: ") == 3
    project = project.with_alternative_result(alternative(project, "targetless", (0.3, 0.0, 0.0)))
    write_project(project)
    found = run_json(capsys, "compare", tmp_path / "p")
    assert [each["method"] for each in found["methods"]] == ["targets", "targetless"]
    assert found["methods"][0]["difference_deg"] is None
    assert found["methods"][1]["difference_deg"] == pytest.approx(
        {"roll": 0.3, "pitch": 0.0, "yaw": 0.0}
    )
    assert found["methods"][1]["differ"]
    assert found["missing"] == ["natural planes", "patch test"]
    _, out, _ = run(capsys, "compare", tmp_path / "p")
    assert "+0.3000" in out
    assert f"targetless: {english_text(note('patch_test.not_converged'))}" in out
    write_project(
        replace(project, result=None, alternative_results=(), validation=(), absolute=None)
    )
    assert "(lispac estimate p, or --compute)" in run_refused(capsys, "compare", tmp_path / "p")


def test_compare_with_compute_runs_and_saves_the_methods(
    capsys: pytest.CaptureFixture[str], demo_project: Project, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    from lispac.workflow.calibration import patch_test, targetless

    project = replace(demo_project, folder=tmp_path / "p")
    project.folder.mkdir()
    write_project(project)
    monkeypatch.setattr(targetless.targetless, "__kwdefaults__", {
        **(targetless.targetless.__kwdefaults__ or {}), "count": 12,
    })  # fmt: skip
    monkeypatch.setitem(patch_test.propose_objects.__kwdefaults__, "count", 8)
    found = run_json(capsys, "compare", project.folder, "--compute")
    assert [each["method"] for each in found["methods"]] == ["targetless", "patch test"]
    assert found["refused"]["natural planes"]["code"] == "estimate.few_validation_planes"
    kept = read_project(project.folder).alternative_results
    assert [each.method for each in kept] == ["targetless", "patch test"]
    for one, printed in zip(kept, found["methods"], strict=True):
        assert np.degrees(one.boresight) == pytest.approx([*printed["boresight_deg"].values()])
    code, out, err = run(capsys, "compare", project.folder, project.folder, "--compute")
    assert (code, out) == (2, "")
    assert "give one project" in err
