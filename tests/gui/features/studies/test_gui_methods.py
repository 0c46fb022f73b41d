"""Tests of the dialogue that compares alternative methods with the targets."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QTimer

from lispac.alternative_methods import AlternativeResult
from lispac.errors import AdjustmentError
from lispac.gui.features.studies.methods_dialog import MethodsDialog
from lispac.messages import note
from lispac.workflow.calibration import method_runs
from lispac.workflow.calibration.method_runs import adjust_natural_planes
from tests.gui.features.studies.test_gui_studies import use_next_dialog
from tests.gui.features.warnings.test_gui_warnings import listed
from tests.gui.support import Driver, Key, Left, wait_until_idle
from tests.support.correspondence_files import write_pairs


def result_of_the_scene(project, _survey, *, progress) -> AlternativeResult:
    """Stand-in for the slow targetless method: roll is 0.5 deg off the result of the targets."""
    progress(0.5, "Matching the lines: iteration 1")
    result = project.result
    turned = result.boresight + np.radians([0.5, 0.0, 0.0])
    lines = tuple(line.name for line in project.lines)
    return AlternativeResult(
        "targetless",
        turned,
        np.array(result.covariance),
        lines,
        30,
        (note("targetless.with_targets", targets=30),),
    )


def test_missing_methods_are_run_and_stored_as_one_undo_step(
    adjusted: Driver, monkeypatch: pytest.MonkeyPatch
) -> None:
    methods: list[str] = []

    def record_method(project, survey, method, *, progress):
        methods.append(method)
        if method == "natural planes":
            return adjust_natural_planes(project, survey, progress=progress)
        return replace(result_of_the_scene(project, survey, progress=progress), method=method)

    monkeypatch.setattr(method_runs, "run_method", record_method)
    action, before = adjusted.window.actions_["methods"], adjusted.project
    assert action.isEnabled()
    assert before.alternative_results == ()

    def first(dialog: MethodsDialog) -> None:
        assert isinstance(dialog, MethodsDialog)
        names = [dialog.table.item(row, 0).text() for row in range(dialog.table.rowCount())]
        assert names == ["Targets", "Natural planes", "Targetless", "Patch test"]
        assert dialog.table.item(2, 3).text() == "\N{EN DASH}"
        assert not dialog.message_label.isVisible()
        assert dialog.run_missing.isEnabled()
        adjusted.bot.mouseClick(dialog.run_missing, Left)

    compare(adjusted)
    use_next_dialog(adjusted, first)

    def second(dialog: MethodsDialog) -> None:
        assert isinstance(dialog, MethodsDialog)
        names = [dialog.table.item(row, 0).text() for row in range(dialog.table.rowCount())]
        assert names == ["Targets", "Targetless", "Patch test", "Natural planes"]
        assert float(dialog.table.item(1, 5).text()) > 3
        words = dialog.message_label.text()
        assert "Natural planes: " in words, "too few of them"
        differs = "Significant difference between the targetless method and the targets in roll"
        assert differs in words
        assert "natural surfaces: 30." in words
        assert not dialog.run_missing.isEnabled()

    use_next_dialog(adjusted, second)
    wait_until_idle(adjusted)
    assert methods == ["natural planes", "targetless", "patch test"]
    assert [each.method for each in adjusted.project.alternative_results] == [
        "targetless",
        "patch test",
    ]
    assert adjusted.window.document.undo_stack.undoText() == "results of alternative methods"
    assert adjusted.project.result is before.result
    # The difference is listed among the warnings, and one undo removes the results.
    assert "report.methods_differ" in {each.code for each in listed(adjusted)}
    adjusted.window.document.undo_stack.undo()
    assert adjusted.project.alternative_results == ()


def compare(driver: Driver) -> None:
    """Open the dialogue from the event loop, because the action blocks until it is closed."""
    QTimer.singleShot(0, driver.window.actions_["methods"].trigger)


def test_a_method_without_a_result_is_reported(
    adjusted: Driver, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(_project, _survey, method, *, progress):
        raise AdjustmentError(f"the lines share too little for {method}")

    monkeypatch.setattr(method_runs, "run_method", refuse)
    before = adjusted.project
    compare(adjusted)
    use_next_dialog(adjusted, lambda dialog: adjusted.bot.mouseClick(dialog.run_missing, Left))

    def inspect_dialog(dialog: MethodsDialog) -> None:
        assert (
            "Natural planes: the lines share too little for natural planes"
            in dialog.message_label.text()
        )
        assert not dialog.run_missing.isEnabled()

    use_next_dialog(adjusted, inspect_dialog)
    assert adjusted.project is before


def test_methods_cannot_be_compared_without_lines(driver: Driver) -> None:
    assert not driver.window.actions_["methods"].isEnabled()


def test_point_correspondences_from_a_file_are_compared(adjusted: Driver, tmp_path: Path) -> None:
    window, dialogs = adjusted.window, adjusted.dialogs
    before = adjusted.project
    dialogs.path = write_pairs(tmp_path / "pairs.txt", before, window.document.survey)

    def inspect_dialog(dialog: MethodsDialog) -> None:
        assert isinstance(dialog, MethodsDialog)
        names = [dialog.table.item(row, 0).text() for row in range(dialog.table.rowCount())]
        assert names[:2] == ["Targets", "Point correspondences"]
        assert "200 pairs of points were used" in dialog.message_label.text()
        adjusted.bot.keyClick(dialog, Key.Key_Escape)

    QTimer.singleShot(0, window.actions_["correspondences"].trigger)
    use_next_dialog(adjusted, inspect_dialog)
    wait_until_idle(adjusted)
    (found,) = adjusted.project.alternative_results
    assert found.method == "correspondences"
    off = found.boresight - np.radians(before.truth_deg)
    assert np.abs(off / found.sigma).max() < 4
    window.document.undo_stack.undo()
    assert adjusted.project is before


def test_a_wrong_file_of_correspondences_changes_nothing(adjusted: Driver, tmp_path: Path) -> None:
    dialogs, before = adjusted.dialogs, adjusted.project
    dialogs.path = tmp_path / "pairs.txt"
    dialogs.path.write_text("1 2 3\n", encoding="utf-8")
    adjusted.window.actions_["correspondences"].trigger()
    adjusted.rest()
    (failure,) = dialogs.errors
    assert failure.code == "correspondences.columns"
    assert adjusted.project is before
    dialogs.path = None
    adjusted.window.actions_["correspondences"].trigger()
    assert not adjusted.window.runner.busy
