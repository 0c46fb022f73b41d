"""Transfer of everything the user has in a window to the window that replaces it.

Theme, language and units are applied by a new window, which gets the document with all undo steps,
and here the state of the view, of the tools and of the panels.
"""

from PySide6.QtCore import QItemSelectionModel, QModelIndex
from PySide6.QtWidgets import QAbstractItemView

from lispac.gui.features.inspect.actions import COLOUR_ACTIONS
from lispac.gui.widgets.field_transfer import copy_fields
from lispac.gui.window.main_window import MainWindow


def copy_window_state(former: MainWindow, window: MainWindow) -> None:
    """Give a window all that the user has in a former one, except the document."""
    window.log.copy_state_from(former.log)
    for before, after in (
        (former.data, window.data),
        (former.targets, window.targets),
        (former.adjust, window.adjust),
        (former.validate, window.validate),
        (former.convention, window.convention),
        (former.histograms, window.histograms),
        (former.tools.sections.panel, window.tools.sections.panel),
    ):
        copy_fields(before, after)
    window.workflow.open(former.workflow.opened)
    if former.controller.candidate is not None:
        window.controller.set_candidate(former.controller.candidate)
    _copy_view(former, window)
    _copy_selection(former, window)
    _copy_tools(former, window)
    for title, panel_window in window.panel_windows.items():
        panel_window.copy_state_from(former.panel_windows[title])
    if former.tour.is_running:
        window.tour.resume()
    window.dock_layout.copy_front_from(former.dock_layout)


def _copy_view(former: MainWindow, window: MainWindow) -> None:
    """Copy camera, former views, hidden lines, colours and number of views."""
    for name in ("orthographic", "hover"):
        if former.actions_[name].isChecked():
            window.actions_[name].trigger()
    window.viewport.copy_view_from(former.viewport)
    window.data.copy_hidden_lines_from(former.data)
    window.actions_[COLOUR_ACTIONS[former.scene.colouring]].setChecked(True)
    window.actions_["seed_validation"].setChecked(former.actions_["seed_validation"].isChecked())
    if former.actions_["wipe"].isChecked():
        window.actions_["wipe"].trigger()
    if former.tools.linked_views.count > 1:
        window.tools.linked_views.choose(former.tools.linked_views.count)


def _copy_selection(former: MainWindow, window: MainWindow) -> None:
    """Copy the selected target or sighting and the current rows of the tables."""
    if former.scene.selected is not None:
        window.scene.select(*former.scene.selected)
        window.diagnostics.select(*former.scene.selected)
    if former.targets.current is not None:
        window.targets.select(former.targets.current)
    if former.histograms.current is not None:
        window.histograms.select(former.histograms.current)
    window.histograms.tabs.setCurrentIndex(former.histograms.tabs.currentIndex())
    window.diagnostics.list.setCurrentRow(former.diagnostics.list.currentRow())
    for before, after in ((former.table, window.table), (former.data.lines, window.data.lines)):
        _copy_current_cell(before, after)


def _copy_current_cell(before: QAbstractItemView, after: QAbstractItemView) -> None:
    cell = before.currentIndex()
    if cell.isValid():
        selection = after.selectionModel()
        selection.blockSignals(True)  # the view and the other panels are set already
        selection.setCurrentIndex(
            after.model().index(cell.row(), cell.column(), QModelIndex()),
            QItemSelectionModel.SelectionFlag.ClearAndSelect,
        )
        selection.blockSignals(False)


def _copy_tools(former: MainWindow, window: MainWindow) -> None:
    """Copy the clip box, the section, the patch test, and the active tool with its points."""
    before, after = former.tools, window.tools
    if before.mouse_tool.tool:
        window.actions_[before.mouse_tool.tool].trigger()
    after.measurements.copy_state_from(before.measurements)
    after.clipping.copy_state_from(before.clipping)
    after.sections.copy_state_from(before.sections)
    after.patch_test_controller.copy_state_from(before.patch_test_controller)
