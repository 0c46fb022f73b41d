"""Tests of seeds from a list of coordinates: preview, detection, table of results, undo."""

import re
import time
from pathlib import Path

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QLabel,
    QLineEdit,
    QPushButton,
    QTableWidget,
)

from lispac.gui.appearance.message_texts import message_text
from lispac.messages import note
from lispac.progress import Progress, Step
from lispac.workflow.calibration import seed_lists
from lispac.workflow.calibration.seed_lists import pick_seeds
from lispac.workflow.planning.demo import demo_seeds
from tests.gui.import_support import drop
from tests.gui.support import WAIT_MS, Driver, Key, Left, click, open_step, press, use_next_dialog
from tests.support.message_codes import is_shown

SEEDS = demo_seeds()
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def listed(tmp_path: Path) -> Path:
    """A list of two targets, a validation plane and a point without any surface."""
    path = tmp_path / "quay.csv"
    rows = [f"{name};{x:.3f};{y:.3f};{z:.3f}" for name, (_, (x, y, z)) in SEEDS.items()]
    path.write_text("\n".join([*rows[:3], "Lost;20;4;3"]))
    return path


def cells(dialog: QDialog, name: str) -> list[list[str]]:
    table = dialog.findChild(QTableWidget, name)
    return [
        [table.item(row, k).text() for k in range(table.columnCount())]
        for row in range(table.rowCount())
    ]


def use_both_dialogs(driver: Driver, before, after) -> None:
    """Answer the preview, then the table of results."""

    def first(dialog: QDialog) -> None:
        use_next_dialog(after)
        before(dialog)

    use_next_dialog(first)


def test_a_list_is_previewed_detected_and_undone_in_one_step(opened: Driver, listed: Path) -> None:
    open_step(opened, 1)
    before = opened.project
    opened.dialogs.path = listed
    shown_content = []

    def preview(dialog: QDialog) -> None:
        shown_content.append(cells(dialog, "seed_list_table"))
        table = dialog.findChild(QTableWidget, "seed_list_table")
        shown_content.append([table.horizontalHeaderItem(k).text() for k in (2, 3, 4)])
        shown_content.append(dialog.findChild(QLabel, "list_message").text())
        opened.bot.mouseClick(dialog.findChild(QPushButton, "pick_list"), Left)

    def table(dialog: QDialog) -> None:
        shown_content.append(cells(dialog, "seeds_found_table"))
        shown_content.append(dialog.findChild(QLabel, "seeds_found").text())
        opened.bot.keyClick(dialog, Key.Key_Return)

    use_both_dialogs(opened, preview, table)
    click(opened, opened.window.targets.list_seeds)
    opened.rest()
    read, titles, list_text, found, summary = shown_content
    names = [*list(SEEDS)[:3], "Lost"]
    assert [row[0] for row in read] == [row[0] for row in found] == names
    assert titles == ["East (m)", "North (m)", "Up (m)"]
    north, west, up = SEEDS[names[0]][1]
    east_north_up = (-west, north, up)
    assert read[0][2:5] == [f"{value:.3f}".replace("-", "−") for value in east_north_up]
    ordered = note("assumed.columns_by_order", columns=("name", "north", "west", "up"))
    assert message_text(ordered) in list_text
    assert [row[2] for row in found][3] == "none"
    assert found[0][2] == "6 of 6"
    assert found[3][4]
    assert re.findall(r"\d+", summary) == ["3", "4"]
    assert [target.name for target in opened.project.targets] == names[:3]
    assert opened.window.document.undo_stack.undoText() == "addition of targets from quay.csv"
    opened.window.document.undo_stack.undo()
    assert opened.project is before


def test_existing_names_are_not_ticked_and_columns_can_be_chosen(
    picked: Driver, listed: Path
) -> None:
    picked.dialogs.path = listed
    ticked = []

    def preview(dialog: QDialog) -> None:
        pick = dialog.findChild(QPushButton, "pick_list")
        table = dialog.findChild(QTableWidget, "seed_list_table")
        ticked.append([seed.name for seed in dialog.ticked_entries])
        assert "tick to replace" in table.item(0, 6).text()
        columns = dialog.findChild(QLineEdit, "list_columns")
        picked.bot.keyClicks(columns, "name,x,y")
        assert "columns are missing: z" in dialog.findChild(QLabel, "list_message").text()
        assert not pick.isEnabled()
        assert table.rowCount() == 0
        picked.bot.keyClicks(columns, ",z")
        message = dialog.findChild(QLabel, "list_message")
        assert is_shown("assumed.columns_as_named", message.text())
        box = dialog.findChild(QComboBox, "list_system")
        box.setFocus()
        picked.bot.keyClick(box, Key.Key_Down)
        assert "EPSG:32618" in box.currentText()
        picked.bot.waitUntil(
            lambda: "Check the coordinate system" in message.text(),
            timeout=WAIT_MS,
        )
        picked.bot.keyClick(dialog, Key.Key_Escape)

    dialogs = use_next_dialog(preview)
    before = picked.project
    press(picked, Key.Key_F3, SHIFT)
    picked.rest()
    assert dialogs
    existing_names = {target.name for target in before.targets}
    assert ticked == [[name for name in [*list(SEEDS)[:3], "Lost"] if name not in existing_names]]
    assert picked.project is before
    assert not picked.window.document.undo_stack.canUndo()


def test_a_dropped_list_can_be_cancelled_during_detection(
    opened: Driver, listed: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = opened.project
    titles = []

    def waits(*args, progress: Progress) -> tuple:
        """Pick the seeds, but wait before the second one until the task is cancelled."""

        def report(fraction: float, step: Step | None = None) -> None:
            late = time.monotonic() + WAIT_MS / 1000
            while fraction and time.monotonic() < late:
                progress(fraction, step)
                time.sleep(0.01)
            progress(fraction, step)

        return pick_seeds(*args, progress=report)

    monkeypatch.setattr(seed_lists, "pick_seeds", waits)

    def stop() -> None:
        task = opened.window.runner.current
        if not opened.window.isActiveWindow():
            opened.window.activateWindow()  # there is no window manager to do it
        if task is None or not task.fraction or not opened.window.isActiveWindow():
            QTimer.singleShot(10, stop)
            return
        titles.append(task.title)
        press(opened, Key.Key_Period, Qt.KeyboardModifier.ControlModifier)

    def preview(dialog: QDialog) -> None:
        QTimer.singleShot(10, stop)
        opened.bot.mouseClick(dialog.findChild(QPushButton, "pick_list"), Left)

    dialogs = use_next_dialog(preview)
    drop(opened.window, [listed])
    opened.bot.waitUntil(lambda: bool(titles), timeout=WAIT_MS)
    opened.rest()
    assert len(dialogs) == 1
    assert titles == ["Searching for the targets of 4 seeds of quay.csv"]
    assert opened.project is before
    assert not opened.dialogs.requests
    assert (
        "Searching for the targets of 4 seeds of quay.csv: cancelled"
        in opened.window.log.toPlainText()
    )
    assert opened.window.targets.list_seeds.isEnabled()


def test_a_list_without_any_found_target_changes_nothing(opened: Driver, tmp_path: Path) -> None:
    path = tmp_path / "far.txt"
    path.write_text("A 300 300 300\n")
    before = opened.project
    texts = []

    def table(dialog: QDialog) -> None:
        texts.append(dialog.findChild(QLabel, "seeds_found").text())
        opened.bot.keyClick(dialog, Key.Key_Return)

    use_both_dialogs(opened, lambda dialog: opened.bot.keyClick(dialog, Key.Key_Return), table)
    opened.window.lifecycle.list_dropped.emit(path)
    opened.rest()
    assert len(texts) == 1
    assert not re.search(r"\d", texts[0]), "no target was found"
    assert opened.project is before
