"""Window on the screen, and its replacement when language, theme, units or colours change.

Widgets get their texts and colours when they are created. Therefore the window is rebuilt with the
same document and with everything the user has in it (`copy_window_state`).
"""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import TracebackType

from PySide6.QtCore import (
    QItemSelectionModel,
    QModelIndex,
    QObject,
    Qt,
    QTimer,
    Signal,
)
from PySide6.QtWidgets import QAbstractItemView, QApplication, QWidget

from lispac.gui.app.docks import show_with_owned_windows
from lispac.gui.app.garbage_collection import collect_all
from lispac.gui.app.language import set_language
from lispac.gui.app.point_colours import set_colour_scale
from lispac.gui.app.settings import AppSettings
from lispac.gui.appearance import theme, units
from lispac.gui.features.inspect.actions import COLOUR_ACTIONS
from lispac.gui.project.features import StateCopier
from lispac.gui.viewport.base import Viewport
from lispac.gui.widgets.field_transfer import copy_fields, copy_scroll_positions
from lispac.gui.widgets.number_input import NumberEntry
from lispac.gui.window.dialogs import Dialogs
from lispac.gui.window.features import panel_records
from lispac.gui.window.main_window import MainWindow
from lispac.io.project.project_file import UNSAVED_NAME

THEME_DELAY_MS = 500
"""Delay after a change of the system theme; systems send several signals."""


class Session(QObject):
    """Shows one window at a time.

    Parameters
    ----------
    viewport : function that creates the 3D view of a window
    settings, dialogs : if None, the stored settings and the dialogues of the program
    """

    _uncaught = Signal(object)

    def __init__(
        self,
        application: QApplication,
        viewport: Callable[[], Viewport],
        settings: AppSettings | None = None,
        dialogs: Dialogs | None = None,
    ) -> None:
        super().__init__(application)
        # Queued, since only the GUI thread may open a dialogue
        self._uncaught.connect(self._show_error, Qt.ConnectionType.QueuedConnection)
        self._application, self._viewport = application, viewport
        self._settings, self._dialogs = settings or AppSettings(), dialogs or Dialogs()
        self.window = self._create_window(None)
        self._shown = self._settings.appearance, theme.current_scheme()
        self._theme_timer = QTimer(self, singleShot=True, interval=THEME_DELAY_MS)
        self._theme_timer.timeout.connect(self._follow_system_theme)
        application.styleHints().colorSchemeChanged.connect(self._delay_theme_change)

    def _create_window(self, former: MainWindow | None) -> MainWindow:
        in_front = QApplication.activeWindow()
        self._apply_appearance(is_window_next=True)
        window = MainWindow(self._viewport(), self._settings, self._dialogs, former)
        try:
            if former is not None:
                copy_window_state(former, window)
            show_with_owned_windows(window)
            if former is not None and former.dock_layout.is_maximised:
                window.actions_["maximise"].trigger()
            if former is None:
                window.activateWindow()
            else:
                _restore_focus(window)
                copy_scroll_positions(former, window)
                window.scene.draw_now()
                window.site_design.copy_state_from(former.site_design)
                # Once only: a window manager may handle two requests in any order
                _window_in_front(former, window, in_front).activateWindow()
        except BaseException:
            window.discard()
            raise
        # Queued, since the action that emits it belongs to the window that is replaced
        window.renewal_requested.connect(self.rebuild_window, Qt.ConnectionType.QueuedConnection)
        return window

    def _apply_appearance(self, *, is_window_next: bool = False) -> None:
        """Apply the settings that widgets use when they are created."""
        chosen = self._settings.appearance
        set_language(chosen.language)
        units.set_units(*chosen.units)
        set_colour_scale(chosen.colour_scale)
        theme.apply_theme(self._application, chosen.theme, is_window_next=is_window_next)

    @property
    def log_folder(self) -> Path:
        """Folder of the log file."""
        return self._settings.folder

    def report_uncaught(self, error: BaseException) -> None:
        """Show an uncaught exception of any thread."""
        if isinstance(error, KeyboardInterrupt):
            self._application.quit()
        else:
            self._uncaught.emit(error)

    def crashed_project(self) -> Path | None:
        """Project with unsaved changes that was open at a crash; None if there is none."""
        folder = self._settings.last_project
        if folder is None or not (folder / UNSAVED_NAME).is_file():
            return None
        return folder

    def _show_error(self, error: BaseException) -> None:
        self.window.dialogs.show_error(error)

    def _delay_theme_change(self, _scheme: Qt.ColorScheme) -> None:
        self._theme_timer.start()

    def _follow_system_theme(self) -> None:
        """Apply the theme of the system, unless a dialogue is open or a site plan is dragged."""
        if theme.choose_scheme(self._application, self._settings.theme) is theme.current_scheme():
            return
        if (
            QApplication.activeModalWidget()
            or QApplication.activePopupWidget()
            or self.window.site_design.workspace.is_dragging
        ):
            self._theme_timer.start()
        else:
            self.window.rebuild_window()

    def rebuild_window(self) -> None:
        """Replace the window by a new one with the present settings.

        If an error occurs, the window is kept, with its settings.
        """
        former, in_front = self.window, QApplication.activeWindow()
        existing = set(QApplication.topLevelWidgets())
        former.save_layout()
        with _collected_errors() as errors:
            try:
                # Shown before the former one is closed: Qt ends when the last window is closed
                window = self._create_window(former)
            except Exception as error:
                errors.insert(0, error)
            else:
                if errors:
                    window.discard()
        if errors:
            for each in set(QApplication.topLevelWidgets()) - existing:
                each.deleteLater()  # panels that were not yet in the new window
            self._dialogs.parent = former
            self._restore_appearance()
            former.preferences.show_choices()
            (in_front or former).activateWindow()
            self._uncaught.emit(errors[0])
            return
        existing.clear()
        window.recovery_copies.take_lock_from(former.recovery_copies)
        self.window = window
        self._shown = self._settings.appearance, theme.current_scheme()
        former.discard()
        # Frees the points and graphics of the former window immediately.
        del former
        collect_all()

    def _restore_appearance(self) -> None:
        """Restore the settings of the window, and its colours if the system has changed them."""
        self._settings.appearance, scheme = self._shown
        self._apply_appearance()
        if theme.current_scheme() is not scheme:
            theme.apply_theme(self._application, "dark" if scheme.is_dark else "light")


@contextmanager
def _collected_errors() -> Iterator[list[Exception]]:
    """Context that collects the exceptions of slots, which do not reach their callers."""
    errors: list[Exception] = []
    former = sys.excepthook

    def collect(
        kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        if isinstance(error, Exception):
            errors.append(error)
        else:
            former(kind, error, trace)

    sys.excepthook = collect
    try:
        yield errors
    finally:
        sys.excepthook = former
        for name in ("last_exc", "last_type", "last_value", "last_traceback"):
            vars(sys).pop(name, None)  # would keep the discarded window in memory


def copy_window_state(former: MainWindow, window: MainWindow) -> None:
    """Give a window all that the user has in a former one, except the document."""
    window.log.copy_state_from(former.log)
    for before, after in (
        (former.data, window.data),
        (former.targets, window.targets),
        (former.adjust, window.adjust),
        (former.validate, window.validate),
        (former.histograms, window.histograms),
        (former.tools.sections.panel, window.tools.sections.panel),
    ):
        copy_fields(before, after)
    window.workflow.open(former.workflow.opened)
    if former.controller.candidate is not None:
        window.controller.set_candidate(former.controller.candidate)
    _copy_selection(former, window)
    window.proposed_targets.copy_state_from(former.proposed_targets)
    _copy_view(former, window)  # last, since a selection may move the view
    _copy_tools(former, window)
    _copy_features(former, window)
    for title, panel_window in window.panel_windows.items():
        panel_window.copy_state_from(former.panel_windows[title])
    if former.tour.is_running:
        window.tour.resume()
    window.dock_layout.copy_state_from(former.dock_layout)


def _restore_focus(window: MainWindow) -> None:
    """Focus the field in which a number is being typed, or else the header of the open step."""
    window.workflow.focus_open_step()
    typed = (each for each in window.findChildren(QWidget) if isinstance(each, NumberEntry))
    for field in typed:
        if field.is_typing:
            field.setFocus(Qt.FocusReason.OtherFocusReason)


def _window_in_front(former: MainWindow, window: MainWindow, in_front: QWidget | None) -> QWidget:
    """Window that continues the one in front before the change."""
    pairs = [
        (former.site_design.window, window.site_design.window),
        *((former.panel_windows[title], each) for title, each in window.panel_windows.items()),
    ]
    for before, after in pairs:
        if after is not None and before is in_front and in_front is not None:
            return after
    return window


def _copy_view(former: MainWindow, window: MainWindow) -> None:
    """Copy camera, former views, hidden lines, colours and number of views.

    The lines are drawn before they are shown several times, in split or linked views.
    """
    for name in ("orthographic", "hover"):
        if former.actions_[name].isChecked():
            window.actions_[name].trigger()
    window.viewport.copy_view_from(former.viewport)
    window.data.copy_hidden_lines_from(former.data)
    window.scene.draw_now()
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
    """Copy the clip box, the section, and the active tool with its points."""
    before, after = former.tools, window.tools
    if before.mouse_tool.tool:
        window.actions_[before.mouse_tool.tool].trigger()
    after.measurements.copy_state_from(before.measurements)
    after.clipping.copy_state_from(before.clipping)
    after.sections.copy_state_from(before.sections)


def _copy_features(former: MainWindow, window: MainWindow) -> None:
    """Copy the state of the features and of the panels that they have registered."""
    for before, after in zip(former.feature_controllers, window.feature_controllers, strict=True):
        if isinstance(after, StateCopier):
            after.copy_state_from(before)
    for each in panel_records():
        controller = window.panel_controllers.get(each.name)
        if isinstance(controller, StateCopier):
            controller.copy_state_from(former.panel_controllers[each.name])
        else:
            copy_fields(former.panels[each.name], window.panels[each.name])
