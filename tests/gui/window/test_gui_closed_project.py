"""Tests that panels and windows show nothing of a project that was closed."""

from dataclasses import replace

from PySide6.QtCore import QAbstractTableModel, QModelIndex
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QComboBox,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QWidget,
)

from lispac.gui.features.inspect.actions import COLOUR_ACTIONS
from lispac.gui.project.status import STEP_KEYS
from lispac.gui.window.actions import ALL_ACTIONS
from lispac.gui.window.main_window import MainWindow
from lispac.project import Project
from tests.gui.support import Demo, Driver, show_panel

SOON_MS = 60_000


def shown_texts(window: MainWindow) -> dict[str, list[object]]:
    """What all widgets of panels and windows show, by container and name of the widget."""
    found: dict[str, list[object]] = {}
    containers = {**window.docks, **window.panel_windows, "status bar": window.task_bar}
    for title, container in containers.items():
        if title == "Log":
            continue
        for widget in container.findChildren(QWidget):
            content = _content(widget)
            if content is not None and widget.isVisibleTo(container):
                key = f"{title}, {type(widget).__name__} {widget.objectName()}"
                found.setdefault(key, []).append(content)
    return found


def _content(widget: QWidget) -> object:
    if isinstance(widget, QLabel | QLineEdit | QAbstractSpinBox):
        return widget.text()
    if isinstance(widget, QComboBox):
        return widget.currentIndex(), widget.count()
    if isinstance(widget, QPlainTextEdit):
        return widget.toPlainText()
    if isinstance(widget, QAbstractButton):
        return widget.text(), widget.isChecked()
    if isinstance(widget, QAbstractItemView) and widget.model() is not None:
        model, top = widget.model(), QModelIndex()
        columns = model.columnCount(top) if isinstance(model, QAbstractTableModel) else 1
        return [
            [model.index(row, column).data() for column in range(columns)]
            for row in range(model.rowCount(top))
        ]
    return None


def open_everything(driver: Driver) -> None:
    window = driver.window
    for title in (*window.docks, *window.panel_windows):
        show_panel(window, title)
    driver.rest()
    driver.bot.waitUntil(lambda: window.warning_list.is_current, timeout=SOON_MS)


def all_texts(driver: Driver) -> dict[str, list[object]]:
    open_everything(driver)
    texts = {}
    for step, name in enumerate(STEP_KEYS):
        driver.window.workflow.open(step)
        driver.rest()
        texts |= {f"{name}: {key}": shown for key, shown in shown_texts(driver.window).items()}
    return texts


def checked_actions(driver: Driver) -> set[str]:
    actions = driver.window.actions_
    return {name for name in ALL_ACTIONS if actions[name].isChecked()}


def test_no_panel_shows_values_of_a_closed_project(
    driver: Driver, demo: Demo, validated: Project
) -> None:
    window = driver.window
    empty = all_texts(driver)
    window.document.open(validated, demo.survey)
    open_everything(driver)
    window._select("T1", "")
    convention = window.panels["convention"]
    convention.current.known.click()
    driver.bot.keyClicks(convention.current.fields.fields[0].lineEdit(), "1")
    convention.current.applied.click()
    driver.rest()
    assert "Estimated boresight" in convention.inputs.source.text()
    assert convention.replacement is not None
    window.actions_["close_project"].trigger()
    assert window.document.project is None
    closed = all_texts(driver)
    assert {
        key: (empty.get(key), shown) for key, shown in closed.items() if shown != empty.get(key)
    } == {}
    assert convention.replacement is None
    assert not convention.save.isEnabled()


def test_another_project_is_coloured_by_line(
    driver: Driver, demo: Demo, estimated: Project
) -> None:
    window = driver.window
    window.document.open(demo.picked, demo.survey)
    driver.rest()
    initial = checked_actions(driver)
    assert "colour_line" in initial
    for colouring in ("residual", "height"):
        window.document.open(estimated, demo.survey)
        driver.rest()
        window.actions_[COLOUR_ACTIONS[colouring]].trigger()
        driver.rest()
        assert window.scene.colouring == colouring
        assert driver.viewport.shading is not None
        window.document.open(demo.picked, demo.survey)
        driver.rest()
        assert window.scene.colouring == "line"
        assert driver.viewport.shading is None
        assert checked_actions(driver) == initial


def test_a_new_reading_of_the_lines_keeps_their_colours(
    driver: Driver, demo: Demo, estimated: Project
) -> None:
    window = driver.window
    window.document.open(estimated, demo.survey)
    driver.rest()
    window.actions_[COLOUR_ACTIONS["height"]].trigger()
    settings = replace(estimated.settings, lever_arm=(0.1, 0.2, 0.3))
    window.controller.change_settings(settings)
    driver.rest()
    assert window.document.is_survey_current
    assert window.scene.colouring == "height"
