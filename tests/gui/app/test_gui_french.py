"""Tests that all texts of the window are French in French."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QDialog, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.app.language import set_language
from lispac.gui.app.settings import AppSettings
from lispac.gui.appearance import theme
from lispac.gui.features.design import edits
from lispac.gui.features.export.export_dialog import ExportDialog
from lispac.gui.features.help.dialogs import about_box, shortcuts_box
from lispac.gui.features.open_project.import_survey.file_page import FilePreview
from lispac.gui.features.open_project.import_survey.import_dialog import (
    AddLinesDialog,
    ImportDialog,
)
from lispac.gui.features.pick_targets.dialogs import FindAgainDialog
from lispac.gui.features.pick_targets.seed_coordinates import SeedCoordinatesDialog
from lispac.gui.features.report.identity_dialog import IdentityDialog
from lispac.gui.features.studies.check_dialog import CheckDialog
from lispac.gui.features.studies.study_dialog import BudgetDialog
from lispac.gui.features.studies.visibility_dialog import VisibilityDialog
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.gui.widgets.error_box import error_box
from lispac.io.project.project_file import write_project
from lispac.language import gettext
from lispac.present.calibration.error_budget import ErrorBudgetValues
from lispac.project import Project
from lispac.simulation.visibility_study import VisibilityStudy
from lispac.workflow.checking.budget import error_budget_of
from lispac.workflow.checking.validation import validate
from tests.gui.design_support import opened_by_keys, type_cell, wait_for_plan
from tests.gui.french_support import english
from tests.gui.import_support import drop, raw, rest
from tests.gui.support import WAIT_MS, Demo, Driver, Key, open_step, seed, show_panel, type_into
from tests.support.long_runs import LONG


@pytest.fixture
def french(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[Driver]:
    """An empty window in French."""
    theme.apply_theme(qapp)
    set_language("fr")
    try:
        made = Driver(qtbot, RecordingViewport(), tmp_path)
        yield made
        made.leave()
    finally:
        set_language("en")


def all_french(*shown: QWidget) -> None:
    """Check that no text of these windows is English."""
    for each in shown:
        assert english(each) == set()


def test_the_empty_window_is_french(french: Driver) -> None:
    all_french(french.window)
    assert french.window.windowTitle() == "LISPAC"
    assert french.window.actions_["open"].text() == "&Ouvrir un projet…"
    assert french.window.adjust.estimate.text() == "Estimer les angles de visée"


def test_the_window_with_a_result_is_french(french: Driver, demo: Demo, estimated: Project) -> None:
    window = french.window
    window.document.open(validate(estimated, demo.survey), demo.survey)
    french.rest()
    for step in range(5):
        open_step(french, step)
    for title in (*window.docks, *window.panel_windows):
        show_panel(window, title)
        french.rest()
    for page in range(window.diagnostics.list.count()):
        show_panel(window, "Diagnostics")
        window.diagnostics.list.setCurrentRow(page)
    window.targets.select("T1")
    for switch in window.adjust.parameters.switches.values():
        switch.setChecked(True)
    for noise in range(3):
        window.adjust.model.noise.setCurrentIndex(noise)
    for tool in ("measure_distance", "measure_angle", "section", "clip", "lasso_add"):
        window.actions_[tool].trigger()
        french.rest()
        window.actions_["end_tool"].trigger()
    all_french(window)


def test_candidates_and_edits_are_french(french: Driver, demo: Demo) -> None:
    window = french.window
    window.document.open(demo.project, demo.survey)
    seed(french, "T1")
    assert window.targets.candidate.accept.isVisible()
    assert window.targets.candidate.title.text() == "Cible T1"
    all_french(window)
    window.controller.accept()
    french.rest()
    assert window.actions_["undo"].text() == "&Annuler\u00a0: ajout de T1"
    all_french(window)


def test_dialogues_are_french(french: Driver, demo: Demo, estimated: Project) -> None:
    window, track = french.window, demo.survey.trajectory
    window.document.open(estimated, demo.survey)
    french.rest()
    made: list[QDialog] = [
        about_box(window),
        shortcuts_box(window),
        error_box(window, ZeroDivisionError("by zero")),
        BudgetDialog(ErrorBudgetValues.of(error_budget_of(estimated, demo.survey)), window),
        CheckDialog(estimated, track, window),
        FindAgainDialog(estimated.target("T1"), window),
        IdentityDialog(estimated.identity, str, {}, {}, window),
        SeedCoordinatesDialog(estimated, track, window.targets.seed_options, "T9", window),
        *(
            ExportDialog(what, "estimated", estimated, track, window)
            for what in ("lines", "targets", "planes", "trajectory")
        ),
    ]
    try:
        all_french(*made)
    finally:
        for each in made:
            each.close()
            each.deleteLater()


@LONG
def test_the_import_dialogue_is_french(french: Driver, demo: Demo, tmp_path: Path) -> None:
    settings = AppSettings(tmp_path / "other.ini")
    dialog = ImportDialog(settings, french.window)
    more = AddLinesDialog(settings, demo.project, french.window)
    for each in (more, dialog):
        each.show()
    drop(dialog, raw(demo))
    rest(french.bot, dialog)
    for tab in range(dialog.tabs.count()):
        dialog.tabs.setCurrentIndex(tab)
    heads = set()
    for row in range(dialog.table.rowCount()):
        dialog.table.selectRow(row)
        head = dialog.findChild(FilePreview).horizontalHeader().model()
        heads |= {head.headerData(k, Qt.Orientation.Horizontal) for k in range(head.columnCount())}
    try:
        assert {"intensity", "return_number", "classification"} <= heads  # names from the file
        assert english(dialog) <= {"intensity"}
        all_french(more)
    finally:
        for each in (dialog, more):
            each.done(QDialog.DialogCode.Rejected)
            each.deleteLater()


def test_numbers_are_accepted_with_comma_or_point(french: Driver, demo: Demo) -> None:
    french.window.document.open(demo.project, demo.survey)
    french.rest()
    field = french.window.data.lever_arm.fields[0]
    open_step(french, 0)
    for typed in ("-0,1234", "-0.1234"):
        type_into(french, field, typed)
        french.bot.keyClick(field, Key.Key_Tab)
        assert field.value() == -0.1234
        assert field.text() == "−0,1234 m"


def test_the_design_window_is_french(french: Driver) -> None:
    design = opened_by_keys(french)
    wait_for_plan(design)
    french.bot.waitUntil(lambda: not design.results.predictor.active, timeout=WAIT_MS)
    for view in range(design.views.count()):
        design.views.setCurrentIndex(view)
    for tab in range(design.tabs.count()):
        design.tabs.setCurrentIndex(tab)
        french.rest()
    all_french(design)
    design.tabs.setCurrentIndex(1)
    editor = type_cell(french, design.targets.table, 0, 1, "1,25")
    french.bot.keyClick(editor, Key.Key_Return)
    french.rest()
    assert edits.placed_targets(design.workspace.titled)[0].along == pytest.approx(1.25)
    assert design.targets.table.item(0, 1).text() == "1,25"
    undo = "&Annuler\u00a0: T1\u00a0: Position"
    assert design.actions_["undo"].text() == undo
    sides = design.lines.table
    assert {sides.item(row, 3).text() for row in range(sides.rowCount())} <= {"bâbord", "tribord"}
    limits = design.search.limits
    limits.lists["heights"].setText("4,5; 6")
    assert limits.site(design.workspace.titled)[1].heights == (4.5, 6.0)
    limits.lists["heights"].setText("4,5,6")
    assert "n'est pas un nombre" in design.search.error_label.text().replace("’", "'")
    limits.lists["heights"].setText("4,5; 6")
    design.actions_["add_ball"].trigger()
    french.bot.waitUntil(lambda: not design.results.predictor.active, timeout=WAIT_MS)
    all_french(design)
    design.workspace.history.mark_saved()


def test_files_are_identical_in_both_languages(
    french: Driver, estimated: Project, tmp_path: Path
) -> None:
    written = []
    for code in ("fr", "en"):
        set_language(code)
        folder = tmp_path / code
        folder.mkdir()
        write_project(replace(estimated, folder=folder))
        written.append((folder / "project.json").read_bytes())
    assert written[0] == written[1]


@LONG
def test_the_study_of_visibility_is_french_throughout(
    qtbot: QtBot, qapp: QApplication, visibility_studies: list[VisibilityStudy]
) -> None:
    set_language("fr")
    try:
        dialog = VisibilityDialog(visibility_studies)
        qtbot.addWidget(dialog)
        for site in range(dialog.site.count()):
            dialog.site.setCurrentIndex(site)
            for error in range(dialog.error.count()):
                dialog.error.setCurrentIndex(error)
            dialog.numbers()
            assert english(dialog) == set()
    finally:
        set_language("en")


def test_another_program_or_window_is_named_in_french() -> None:
    set_language("fr")
    try:
        place = gettext("{host}, process {process}", host="bridge-2", process=4711)
        assert gettext("The project is open in: {place}.", place=place) == (
            "Le projet est ouvert dans\N{NO-BREAK SPACE}: bridge-2, processus 4711."
        )
        assert gettext("another program") == "un autre programme"
    finally:
        set_language("en")
