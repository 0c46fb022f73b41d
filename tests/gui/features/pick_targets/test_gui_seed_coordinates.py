"""Tests of the dialogue in which the coordinates of a seed are typed."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QComboBox, QLabel, QLineEdit, QPushButton
from pytestqt.qtbot import QtBot

from lispac.gui.app.language import set_language
from lispac.gui.app.questions import CandidateChoice
from lispac.gui.appearance import theme
from lispac.gui.features.pick_targets.seed_coordinates import SeedCoordinatesDialog
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.gui.widgets.result_tables import fact_text
from lispac.present.survey.measured_point import point_facts
from lispac.project import Reading
from lispac.survey.crs import coordinate_system
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.measured_points import PointReader
from tests.gui.french_support import english
from tests.gui.support import (
    WAIT_MS,
    Demo,
    Driver,
    Key,
    click,
    open_step,
    press,
    seed,
    use_next_dialog,
)
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import is_shown

TARGETS_STEP = 1
"""Index of the step of the workflow."""
T1 = demo_seeds()["T1"][1]


def as_shown(place: tuple[float, ...]) -> tuple[float, float, float]:
    """East, north, up of a place given as north, west, up."""
    north, west, up = place
    return -west, north, up


def fill(driver: Driver, dialog: SeedCoordinatesDialog, name: str, text: str) -> None:
    field = dialog.findChild(QLineEdit, name)
    driver.bot.mouseClick(field, Qt.MouseButton.LeftButton)
    field.selectAll()
    driver.bot.keyClick(field, Key.Key_Delete)
    driver.bot.keyClicks(field, text)


def shown_result(dialog: SeedCoordinatesDialog) -> str:
    return dialog.findChild(QLabel, "seed_message").text()


def find(dialog: SeedCoordinatesDialog) -> QPushButton:
    return dialog.findChild(QPushButton, "seed_find")


def test_coordinates_are_read_as_in_all_number_fields(opened: Driver) -> None:
    def use_dialog(dialog: SeedCoordinatesDialog) -> None:
        east, north, up = as_shown(T1)
        texts = (f"{east:.3f} m", f"{100 * north:.1f} cm", f"{up / 10:.4f}e1".replace(".", ","))
        for field, text in zip(dialog.fields, texts, strict=True):
            field.setFocus()
            opened.bot.keyClicks(field, text)
        assert dialog.seed is not None
        assert dialog.seed[1] == pytest.approx(T1, abs=1e-3)
        opened.bot.keyClicks(dialog.fields[2], " kg")
        assert dialog.fields[2].property("wrong")
        assert not find(dialog).isEnabled()

    use_next_dialog(use_dialog)
    press(opened, Key.Key_F3)


def test_the_dialogue_of_the_key_is_french_in_french(
    qtbot: QtBot, qapp: QApplication, demo: Demo, tmp_path: Path
) -> None:
    theme.apply_theme(qapp)
    set_language("fr")
    try:
        driver = Driver(qtbot, RecordingViewport(), tmp_path)
        driver.window.document.open(demo.project, demo.survey)
        driver.rest()
        found: list[set[str]] = []

        def use_dialog(dialog: SeedCoordinatesDialog) -> None:
            assert isinstance(dialog, SeedCoordinatesDialog)
            dialog.fields[0].setFocus()
            driver.bot.keyClicks(dialog.fields[0], "12 kg")
            found.append(english(dialog))

        use_next_dialog(use_dialog)
        press(driver, Key.Key_F3)
        assert found == [set()]
        driver.leave()
    finally:
        set_language("en")


def test_a_seed_is_typed_by_keys_and_undone_in_one_step(opened: Driver) -> None:
    before = opened.project

    def use_dialog(dialog: SeedCoordinatesDialog) -> None:
        assert not find(dialog).isEnabled()
        assert all(name in shown_result(dialog) for name in ("East", "North", "Up"))
        assert dialog.focusWidget() is dialog.fields[0]
        for value in as_shown(T1):
            opened.bot.keyClicks(dialog.focusWidget(), f"{value:.3f}")
            opened.bot.keyClick(dialog.focusWidget(), Key.Key_Tab)
        assert re.search(r"\d+\.\d m", shown_result(dialog))
        assert dialog.focusWidget() is find(dialog)
        opened.bot.keyClick(dialog.focusWidget(), Key.Key_Return)

    dialogs = use_next_dialog(use_dialog)
    press(opened, Key.Key_F3)
    opened.rest()
    assert len(dialogs) == 1
    candidate = opened.window.controller.candidate
    assert candidate.name == "T1"
    assert candidate.seed == pytest.approx(T1, abs=1e-3)
    assert len(candidate.sightings) == 6
    assert opened.project is before
    opened.window.activateWindow()  # there is no window manager to do it
    opened.bot.waitUntil(opened.window.isActiveWindow, timeout=WAIT_MS)
    press(opened, Key.Key_Return)
    assert opened.window.document.undo_stack.undoText() == "addition of T1"
    opened.window.document.undo_stack.undo()
    assert opened.project is before


def search_at(driver: Driver, place: tuple[float, ...]) -> None:
    """Open the dialogue with the button of step 2, type coordinates and search there."""

    def use_dialog(dialog: SeedCoordinatesDialog) -> None:
        for field, value in zip(dialog.fields, as_shown(place), strict=True):
            field.setFocus()
            driver.bot.keyClicks(field, f"{value:.3f}")
        driver.bot.mouseClick(find(dialog), Qt.MouseButton.LeftButton)

    use_next_dialog(use_dialog)
    click(driver, driver.window.targets.type_seed)
    driver.rest()


def test_enter_accepts_a_target_found_with_the_button_for_coordinates(opened: Driver) -> None:
    open_step(opened, TARGETS_STEP)
    search_at(opened, T1)
    assert opened.window.controller.candidate is not None
    focused = opened.window.focusWidget()
    assert focused is opened.window.targets.candidate.accept
    opened.bot.keyClick(focused, Key.Key_Return)
    opened.rest()
    assert [target.name for target in opened.project.targets] == ["T1"]


@pytest.mark.parametrize(
    ("choice", "names"), others_long([("accept", ["T1"]), ("reject", []), ("cancel", [])])
)
def test_a_waiting_target_is_not_discarded_by_another_search(
    opened: Driver, choice: CandidateChoice, names: list[str]
) -> None:
    open_step(opened, TARGETS_STEP)
    search_at(opened, T1)
    first = opened.window.controller.candidate
    opened.dialogs.candidate_choice = choice
    if choice == "cancel":
        click(opened, opened.window.targets.type_seed)
        assert opened.window.controller.candidate is first
        return
    search_at(opened, demo_seeds()["T2"][1])
    assert [target.name for target in opened.project.targets] == names
    second = opened.window.controller.candidate
    assert second is not None
    assert second.name == f"T{len(names) + 1}"
    assert np.linalg.norm(np.subtract(second.seed, demo_seeds()["T2"][1])) < 1


def test_a_click_at_another_place_waits_for_the_detected_target(opened: Driver) -> None:
    seed(opened, "T1")
    first = opened.window.controller.candidate
    assert first is not None
    seed(opened, "V1")
    assert opened.window.controller.candidate is first
    press(opened, Key.Key_Return)
    opened.rest()
    assert [target.name for target in opened.project.targets] == ["T1"]
    second = opened.window.controller.candidate
    assert second is not None
    assert np.linalg.norm(np.subtract(second.seed, demo_seeds()["V1"][1])) < 1


def test_invalid_coordinates_are_reported_while_typing(picked: Driver) -> None:
    open_step(picked, TARGETS_STEP)
    results: list[str] = []

    def use_dialog(dialog: SeedCoordinatesDialog) -> None:
        def typed(name: str, text: str) -> str:
            fill(picked, dialog, name, text)
            results.append(shown_result(dialog))
            return results[-1]

        assert dialog.name.text() == "T3"
        assert is_shown("window.not_a_number", typed("seed_coordinate_0", "abc"))
        assert dialog.fields[0].property("wrong")
        missing = typed("seed_coordinate_0", "1,15")
        assert [name in missing for name in ("East", "North", "Up")] == [False, True, True]
        assert not dialog.fields[0].property("wrong")
        typed("seed_coordinate_1", "-14.7")
        assert re.search(r"\d+\.\d m", typed("seed_coordinate_2", "8.1"))
        assert find(dialog).isEnabled()
        assert "The name T1 is already used" in typed("seed_name", "T1")
        assert not find(dialog).isEnabled()
        assert "printable" in typed("seed_name", " ")
        assert "slash" in typed("seed_name", "a/b")
        typed("seed_name", "T9")
        assert is_shown("coordinates.too_far_local", typed("seed_coordinate_0", "5041234"))
        assert not find(dialog).isEnabled()

    dialogs = use_next_dialog(use_dialog)
    before = picked.project
    click(picked, picked.window.targets.type_seed)
    picked.rest()
    assert len(results) == 9
    assert dialogs
    assert picked.project is before
    assert picked.window.controller.candidate is None


@LONG
def test_three_projected_coordinates_are_pasted_at_once(opened: Driver) -> None:
    open_step(opened, TARGETS_STEP)
    trajectory = opened.window.document.survey.trajectory
    zone = coordinate_system("EPSG:32619")
    east, north, height = zone.from_local(np.array([T1]), trajectory.frame)[0]

    def use_dialog(dialog: SeedCoordinatesDialog) -> None:
        box = dialog.findChild(QComboBox, "seed_system")
        box.setFocus()
        opened.bot.keyClick(box, Key.Key_Down)
        assert "EPSG:32618" in box.currentText()
        labels = [dialog._form.labelForField(field).text() for field in dialog.fields]
        assert labels == ["Easting (m)", "Northing (m)", "Height (m)"]
        box.lineEdit().selectAll()
        opened.bot.keyClicks(box.lineEdit(), "EPSG:99999")
        opened.bot.waitUntil(lambda: is_shown("crs.unknown", shown_result(dialog)), timeout=WAIT_MS)
        box.lineEdit().selectAll()
        opened.bot.keyClicks(box.lineEdit(), "EPSG:32619")
        opened.bot.waitUntil(lambda: "Enter" in shown_result(dialog), timeout=WAIT_MS)
        QApplication.clipboard().setText(f"{north:.4f}; {east:.4f}; {height:.4f}")
        first = dialog.fields[0]
        opened.bot.mouseClick(first, Qt.MouseButton.LeftButton)
        opened.bot.keyClick(first, Key.Key_V, Qt.KeyboardModifier.ControlModifier)
        assert is_shown("coordinates.swapped_projected", shown_result(dialog))
        first.selectAll()
        QApplication.clipboard().setText(f"{east:.4f}\t{north:.4f}\t−0{-height:.4f}")
        opened.bot.keyClick(first, Key.Key_V, Qt.KeyboardModifier.ControlModifier)
        assert "Local frame: " in shown_result(dialog)
        opened.bot.mouseClick(find(dialog), Qt.MouseButton.LeftButton)

    use_next_dialog(use_dialog)
    click(opened, opened.window.targets.type_seed)
    opened.rest()
    candidate = opened.window.controller.candidate
    assert candidate.seed == pytest.approx(T1, abs=1e-3)
    click(opened, opened.window.targets.candidate.accept)
    assert len(opened.project.target("T1").sightings) == 6


@pytest.mark.parametrize(
    ("code", "units"),
    others_long(
        [
            ("EPSG:32618", ("m", "m", "m")),
            ("EPSG:2260", ("ftUS", "ftUS", "ftUS")),
            ("EPSG:4326", ("°", "°", "m")),
        ]
    ),
)
def test_a_copied_point_of_georeferenced_lines_is_read_in_their_system(
    opened: Driver, code: str, units: tuple[str, ...]
) -> None:
    reading = Reading("las", (("frame", "georeferenced"), ("crs", code)))
    lines = tuple(replace(line, reading=reading) for line in opened.project.lines)
    project = replace(opened.project, lines=lines)
    trajectory = opened.window.document.survey.trajectory
    name, cloud = next(iter(opened.window.scene.clouds.items()))
    point = PointReader(project, trajectory).values(name, cloud, 7, np.empty((0, 3)))
    rows = [f"{fact.name}\t{fact_text(fact)}" for fact in point_facts(point)]
    options = opened.window.targets.seed_options
    dialog = SeedCoordinatesDialog(project, trajectory, options, "T1", opened.window)
    dialog.show()
    opened.bot.waitUntil(dialog.isVisible, timeout=WAIT_MS)
    first = dialog.fields[0]
    for copied in ("\n".join(rows), "\n".join(rows[1:4])):
        box = dialog.findChild(QComboBox, "seed_system")
        box.setCurrentIndex(0)
        first.setFocus()
        first.selectAll()
        QApplication.clipboard().setText(copied)
        opened.bot.keyClick(first, Key.Key_V, Qt.KeyboardModifier.ControlModifier)
        assert code in box.currentText()
        labels = [dialog._form.labelForField(field).text() for field in dialog.fields]
        assert [label.split("(")[1] for label in labels] == [f"{unit})" for unit in units]
        assert dialog.seed is not None
        # Longitude and latitude are copied with 8 decimals, which are 1.1 mm
        assert dialog.seed[1] == pytest.approx(cloud.sample[7].tolist(), abs=1e-3)
    other = "\n".join(rows).replace(point.system, "NAD83 / MTM zone 8 (EPSG:32188)")
    first.selectAll()
    QApplication.clipboard().setText(other)
    opened.bot.keyClick(first, Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    assert dialog.seed is None, "the point is in another system"
    opened.bot.keyClick(dialog, Key.Key_Escape)
    dialog.deleteLater()


def test_a_seed_for_one_line_belongs_to_the_selected_target(picked: Driver) -> None:
    open_step(picked, TARGETS_STEP)
    line = picked.project.lines[2].name
    picked.window.targets.select("T1")
    picked.window.targets.line_choice.setCurrentText(line)

    def use_dialog(dialog: SeedCoordinatesDialog) -> None:
        assert dialog.name.text() == "T1"
        assert not dialog.name.isEnabled()
        for k, value in enumerate(as_shown(T1)):
            fill(picked, dialog, f"seed_coordinate_{k}", f"{value:.3f}")
        picked.bot.mouseClick(find(dialog), Qt.MouseButton.LeftButton)

    use_next_dialog(use_dialog)
    click(picked, picked.window.targets.type_seed)
    picked.rest()
    candidate = picked.window.controller.candidate
    assert candidate.name == "T1"
    others = {s.line: s for s in picked.project.target("T1").sightings if s.line != line}
    assert all(candidate.sighting(name) is sighting for name, sighting in others.items())


def test_no_seed_can_be_typed_without_a_survey(driver: Driver) -> None:
    assert not driver.window.actions_["seed_coordinates"].isEnabled()
    assert not driver.window.targets.type_seed.isEnabled()
