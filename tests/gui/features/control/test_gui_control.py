"""Tests of the surveyed control in the window: import, ticks, residuals, removal."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QApplication, QDialog, QWidget

from lispac.gui.features.control.control_dialog import ControlDialog
from lispac.gui.features.control.import_dialog import ControlImportDialog
from tests.cli.test_cli_control import control_list
from tests.gui.support import WAIT_MS, Driver, in_front, seed

Left = Qt.MouseButton.LeftButton


def use_dialogs(driver: Driver, *uses: Callable[[Any], None]) -> None:
    """Open the control and use one dialogue after the other, as one opens the next.

    A dialogue that is still open after its use is closed by its default button.
    """
    waiting, errors = list(uses), list[BaseException]()
    timer = QTimer(interval=50)

    def use_next() -> None:
        dialog = QApplication.activeModalWidget()
        if not isinstance(dialog, QDialog) or not in_front(dialog) or not waiting:
            return
        timer.stop()
        try:
            waiting.pop(0)(dialog)
        except BaseException as error:
            errors.append(error)
            waiting.clear()
        if dialog.isVisible():
            dialog.accept()
        if waiting:
            timer.start()

    timer.timeout.connect(use_next)
    timer.start()
    QTimer.singleShot(0, driver.window.actions_["control"].trigger)
    driver.bot.waitUntil(lambda: not waiting, timeout=WAIT_MS)
    timer.stop()
    driver.rest()
    if errors:
        raise errors[0]


def press(driver: Driver, button: QWidget) -> None:
    driver.bot.mouseClick(button, Left)


def test_control_is_imported_used_and_removed(adjusted: Driver, tmp_path: Path) -> None:
    """The import is one undo step; the result is estimated again after each change."""
    path = control_list(tmp_path / "control.csv", wrong=0.1)
    seen: list[str] = []

    def empty(dialog: ControlDialog) -> None:
        assert isinstance(dialog, ControlDialog)
        assert dialog.table.rowCount() == 0
        assert not dialog.remove_button.isEnabled()
        seen.append("empty")
        dialog.import_button.setFocus()
        press(adjusted, dialog.import_button)

    def fill(dialog: ControlImportDialog) -> None:
        assert isinstance(dialog, ControlImportDialog)
        assert not dialog.accept_button.isEnabled()
        dialog.file.setText(str(path))
        dialog.system.setCurrentIndex(dialog.system.findData("local"))
        dialog.common_sigma.setValue(1.0)
        seen.append("import")

    def imported(dialog: ControlDialog) -> None:
        assert dialog.table.rowCount() == 8
        assert len(dialog.choice.used) == 8
        seen.append("imported")

    use_dialogs(adjusted, empty, fill, imported)
    assert seen == ["empty", "import", "imported"]
    stack = adjusted.window.document.undo_stack
    assert stack.undoText() == "control of control.csv"
    adjusted.bot.waitUntil(lambda: adjusted.project.result is not None, timeout=WAIT_MS)
    adjusted.rest()
    (file,) = adjusted.project.control
    assert file.common_sigma == 0.001
    result = adjusted.project.result
    assert result is not None
    assert len(result.control) == 8
    assert result.without_control is not None

    def untick(dialog: ControlDialog) -> None:
        assert dialog.comparison.rowCount() >= 3
        assert dialog.comparison.isVisible()
        rows = {dialog.table.item(row, 0).text(): row for row in range(8)}
        assert dialog.table.item(rows["T2.4"], 8).text() == "contradicts the survey"
        dialog.table.item(rows["T2.4"], 0).setCheckState(Qt.CheckState.Unchecked)

    use_dialogs(adjusted, untick)
    adjusted.bot.waitUntil(lambda: adjusted.project.result is not None, timeout=WAIT_MS)
    adjusted.rest()
    used = {each.name for each in adjusted.project.control[0].used_points}
    assert "T2.4" not in used
    assert len(used) == 7
    assert adjusted.project.result is not None
    assert len(adjusted.project.result.control) == 7
    stack.undo()
    adjusted.rest()
    assert len(adjusted.project.control[0].used_points) == 8

    def remove(dialog: ControlDialog) -> None:
        dialog.table.setCurrentCell(0, 0)
        assert dialog.remove_button.isEnabled()
        press(adjusted, dialog.remove_button)

    use_dialogs(adjusted, remove)
    assert adjusted.project.control == ()


def test_control_follows_the_targets(picked: Driver, tmp_path: Path) -> None:
    """Removal, undo, renaming and a new seed, without another import."""

    def start(dialog: ControlDialog) -> None:
        press(picked, dialog.import_button)

    def fill(dialog: ControlImportDialog) -> None:
        dialog.file.setText(str(control_list(tmp_path / "control.csv")))

    def targets() -> dict[str, str]:
        picked.rest()
        (file,) = picked.project.control
        return {point.name: point.target for point in file.points}

    use_dialogs(picked, start, fill, lambda _dialog: None)
    first = {f"{name}.{k}": name for name in ("T1", "T2") for k in (1, 2, 3, 4)}
    assert targets() == first
    window = picked.window
    window.controller.remove("T2")
    assert targets() == {name: "T1" * (target == "T1") for name, target in first.items()}
    window.document.undo_stack.undo()
    assert targets() == first
    window.document.undo_stack.redo()
    steps = window.document.undo_stack.count()
    seed(picked, "T2")
    window.controller.accept()
    new = picked.project.targets[-1].name
    assert targets() == {name: t if t == "T1" else new for name, t in first.items()}
    assert window.document.undo_stack.count() == steps + 1  # not a step of its own
    window.controller.rename(new, "Board")
    assert targets() == {name: t if t == "T1" else "Board" for name, t in first.items()}
    window.document.undo_stack.undo()
    window.document.undo_stack.undo()
    assert targets() == {name: "T1" * (target == "T1") for name, target in first.items()}

    def shown(dialog: ControlDialog) -> None:
        assert dialog.table.rowCount() == 8
        assert len(dialog.choice.used) == 8

    seed(picked, "T2")
    window.controller.accept()
    use_dialogs(picked, shown)  # the assignment is finished before the dialogue opens


def test_a_missing_file_is_reported(adjusted: Driver, tmp_path: Path) -> None:
    def fill(dialog: ControlImportDialog) -> None:
        dialog.file.setText(str(tmp_path / "gone.csv"))

    def start(dialog: ControlDialog) -> None:
        press(adjusted, dialog.import_button)

    use_dialogs(adjusted, start, fill)
    (error,) = adjusted.dialogs.errors
    assert "gone.csv" in str(error)
    assert adjusted.project.control == ()
