"""Main window: creates its parts and connects their signals."""

from collections.abc import Mapping
from contextlib import ExitStack
from functools import partial
from pathlib import Path

from PySide6.QtCore import (
    QCoreApplication,
    QEvent,
    QObject,
    QPoint,
    QSize,
    Qt,
    QTimer,
    QUrl,
    Signal,
)
from PySide6.QtGui import QCloseEvent, QCursor, QDesktopServices, QKeyEvent
from PySide6.QtWidgets import QMainWindow, QToolTip, QWidget

from lispac.duplicate_targets import NOISE_ACTIONS
from lispac.gui.app import docks
from lispac.gui.app.actions import Actions
from lispac.gui.app.log_file import LOG_NAME as LOG_NAME
from lispac.gui.app.log_file import LOGGER
from lispac.gui.app.panel_window import PanelWindow
from lispac.gui.app.settings import AppSettings
from lispac.gui.app.status_bar import TaskStatusBar
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.appearance.theme import without_style_sheet
from lispac.gui.features.design.controller import SiteDesign
from lispac.gui.features.estimate.estimation import Estimation
from lispac.gui.features.help.manual import Manual
from lispac.gui.features.help.tour import Tour
from lispac.gui.features.inspect.actions import COLOUR_ACTIONS
from lispac.gui.features.inspect.point_readout import NO_POINT_TEXT
from lispac.gui.features.inspect.section_panel import TITLE as SECTION
from lispac.gui.features.inspect.view_menu import ViewMenu, with_help_until_used
from lispac.gui.features.open_project.project_lifecycle import ProjectLifecycle
from lispac.gui.features.pick_targets.hover_preview import HoverPreviewSettings
from lispac.gui.features.pick_targets.proposals import ProposedTargets
from lispac.gui.features.pick_targets.seeds import SeedActions
from lispac.gui.features.pick_targets.target_actions import TargetActions, TargetTools
from lispac.gui.features.preferences.controller import PreferencesController
from lispac.gui.features.report.report_export import ReportExport
from lispac.gui.features.validate.validation import Validation
from lispac.gui.features.warnings.warning_list import WarningList
from lispac.gui.features.warnings.warnings_panel import WarningsButton
from lispac.gui.project import status
from lispac.gui.project.computations import Computations
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.features import WindowParts
from lispac.gui.project.recovery_copies import RecoveryCopies
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import PickedPoint, Viewport
from lispac.gui.widgets import tab_order
from lispac.gui.widgets.file_drops import FileDrops
from lispac.gui.widgets.number_input import NumberEntry, commit_focused_field, first_input_error
from lispac.gui.window.actions import ALL_ACTIONS, MENUS, STEP_ACTIONS
from lispac.gui.window.cause_navigation import CauseNavigation
from lispac.gui.window.central_widget import CentralWidget
from lispac.gui.window.desktop_notifications import DesktopNotifications
from lispac.gui.window.dialogs import Dialogs
from lispac.gui.window.features import FEATURES
from lispac.gui.window.panel_refresh import PanelRefresh
from lispac.gui.window.panels import Panels, accompanying_docks, automatic_docks
from lispac.gui.window.tools import InspectionTools
from lispac.language import N_, gettext
from lispac.messages import Action, Message
from lispac.picked_targets import Role
from lispac.project import Project, Settings
from lispac.warning_causes import Cause
from lispac.workflow.importing.input_file_messages import CHECK_SIGN_CODE
from lispac.workflow.project.attitude_signs import reversible_angles

MENU_CLOSING_MS = 50
"""Time in which the menu of an action disappears, before the window is built again."""
NOTE_DURATION_MS = 6000
"""Time for which a note is shown in the status bar."""
MAX_TITLE_BAR_HEIGHT_PX = 40
"""Largest height of a title bar, pixels, which the size of a window does not include."""


MISSED_TEXTS: Mapping[Role, str] = {
    "target": N_("No point under the cursor. Ctrl+click on a target."),
    "validation": N_("No point under the cursor. Ctrl+click on a validation plane."),
}
"""Notes on a click beside the points, by the role of the surface to pick."""

CLOSED_TEXT = N_("{panel} stays closed. Open it with View > Panels.")
"""Note after the user has closed a panel, which then no longer opens by itself."""


class MainWindow(QMainWindow):
    """Main window, assembled from document, tasks, viewport and panels.

    Parameters
    ----------
    viewport : Viewport
        View of the lines, which the window owns from then on.
    settings, dialogs
        If None, the stored settings and the dialogues of the program.
    former : MainWindow, optional
        Window that this one replaces, which stays usable.
    """

    renewal_requested = Signal()
    """Language, theme, units or colour scale were changed; a new window must replace this one."""

    def __init__(
        self,
        viewport: Viewport,
        settings: AppSettings | None = None,
        dialogs: Dialogs | None = None,
        former: "MainWindow | None" = None,
    ) -> None:
        super().__init__()
        self.setObjectName("main_window")
        self.settings = settings or AppSettings()
        self.dialogs = dialogs or Dialogs()
        self.dialogs.parent = self
        self.viewport = viewport
        self.docks: dict[str, docks.Dock] = {}
        self.panel_windows: dict[str, PanelWindow] = {}
        self._stops = ExitStack()  # in the reverse order of the creation of the parts
        self._stops.callback(viewport.close)
        try:
            self._assemble(former)
        except BaseException:
            self.discard()
            raise

    # -- assembly ----------------------------------------------------------------------------

    def _assemble(self, former: "MainWindow | None") -> None:
        viewport = self.viewport
        self.document = Document() if former is None else former.document.copy_for_new_window()
        self.document.setParent(self)
        self._noted_project: Project | None = None
        self.runner = TaskRunner(self)
        self._stops.callback(self.runner.close)
        self.scene = Scene(self.document, viewport, self)
        self.controller = Controller(self.document, self.runner, self.scene, self.settings, self)
        self.computations = Computations(self.document, self.runner, self.scene, self.controller)
        self.estimation = Estimation(
            self.document, self.runner, self.scene, self.controller, self.dialogs
        )
        self._stops.callback(self.estimation.stop)
        self.actions_ = Actions(self, ALL_ACTIONS, MENUS)
        self.actions_.submenus["Recent"].setObjectName("recent_menu")
        self.actions_.connect_undo_stack(self.document.undo_stack)
        self.lifecycle = ProjectLifecycle(
            self.document, self.controller, self.dialogs, self.settings, self.actions_
        )
        self.actions_.find_input_error = self._find_input_error
        self.actions_.refused.connect(self.dialogs.show_error)
        self.view_menu = ViewMenu(
            viewport, self.scene, self.controller, self.computations, self.actions_, self.settings
        )
        self.tools = InspectionTools(
            self.document, self.runner, self.scene, viewport, self.computations, self.controller,
            self.dialogs, self.actions_, self._preview_settings,
        )  # fmt: skip
        with without_style_sheet():
            self._build()
        self._restore_layout()
        self._connect_panels()
        self._connect_actions()
        self._connect_tasks()
        self._create_controllers(former)
        self._connect_features()
        if former is None:
            self.panel_refresh.refresh()
            self._set_title()
        else:
            self.scene.continue_from(former.scene)
            self.document.notify_opened()

    def _name_panels(self) -> None:
        panels = self.panels
        self.data, self.targets, self.adjust = panels.data, panels.targets, panels.adjust
        self.validate, self.report = panels.validate, panels.report
        self.workflow, self.results, self.log = panels.workflow, panels.results, panels.log
        self.table, self.histograms = panels.table, panels.histograms
        self.diagnostics, self.warnings = panels.diagnostics, panels.warnings

    def _create_controllers(self, former: "MainWindow | None") -> None:
        """Create the controllers that are connected with each other."""
        document, runner, scene, control = (
            self.document, self.runner, self.scene, self.controller
        )  # fmt: skip
        viewport, dialogs, actions, settings = (
            self.viewport, self.dialogs, self.actions_, self.settings
        )  # fmt: skip
        panels, computations = self.panels, self.computations
        self.panel_refresh = PanelRefresh(
            document, runner, control, computations, scene, settings, actions, panels,
            self.central_widget, self.dock_layout,
        )  # fmt: skip
        document.about_to_open.connect(self._discard_typed_texts)
        document.about_to_open.connect(panels.targets.reset_seed_options)
        document.about_to_open.connect(self._restore_panel_height)
        document.changed.connect(self._set_title)
        document.modified.connect(lambda _modified: self._set_title())
        tools = TargetTools(document, runner, control, dialogs, actions, panels.targets)
        self.target_actions = TargetActions(tools, panels.table)
        self.proposed_targets = ProposedTargets(tools, scene)
        self.proposed_targets.shown.connect(
            lambda: self._show_in_targets_step(panels.targets.proposal)
        )
        control.accepted.connect(self._select_accepted)
        self.validation = Validation(document, runner, control, actions, panels.validate)
        self.validation.validated.connect(partial(self.dock_layout.present, docks.HISTOGRAMS))
        self.validation.validated.connect(partial(panels.workflow.open, status.VALIDATE))
        self.validation.model_differs.connect(panels.histograms.show_model_difference)
        seeds = SeedActions(tools)
        self.lifecycle.list_dropped.connect(seeds.list_seeds)
        panels.report.lines_requested.connect(actions["lines"].trigger)
        report = ReportExport(
            document, runner, scene, viewport, control, computations, dialogs, settings, actions,
            panels.report,
        )  # fmt: skip
        panels.data.details_requested.connect(report.ask_details)
        self.preferences = PreferencesController(
            viewport, control, dialogs, settings, actions, self.rebuild_window
        )
        self.preferences.report_choice_changed.connect(report.show_choice)
        self.manual = Manual(runner, control, actions, lambda: panels.workflow.opened)
        self.site_design = SiteDesign(
            document,
            lambda: with_help_until_used(viewport.create_empty_viewport(), settings),
            dialogs, settings, actions,
            dialogs.shortcuts, self,
        )  # fmt: skip
        self._stops.callback(self.site_design.end)
        self.recovery_copies = RecoveryCopies(
            document, control, dialogs, settings, None if former is None else former.recovery_copies
        )
        self._stops.callback(self.recovery_copies.stop)
        self.warning_list = WarningList(
            document, runner, panels.warnings, self.warnings_button, actions,
            lambda: self.recovery_copies.problem,
        )  # fmt: skip
        self._stops.callback(self.warning_list.stop)
        self.warning_list.shown.connect(panels.validate.show_messages)
        self.recovery_copies.problem_changed.connect(self.warning_list.update)
        quality = self.target_actions.quality_computation
        quality.qualities_changed.connect(self.warning_list.set_qualities)
        quality.qualities_changed.connect(self.panel_refresh.show_qualities)
        self.cause_navigation = CauseNavigation(document, scene, viewport, panels, self._go_to)
        actions.connect_slots(
            {"acceptance_criteria": self.cause_navigation.go_to_acceptance_criteria}
        )
        panels.warnings.cause_activated.connect(self.cause_navigation.show_cause)
        panels.data.noise_model_requested.connect(self.cause_navigation.go_to_noise_model)
        panels.validate.cause_requested.connect(self.cause_navigation.show_cause)
        panels.results.cross_checks_requested.connect(
            lambda: self.cause_navigation.show_cause(Cause.of_page("Cross-checks"))
        )
        panels.warnings.action_requested.connect(self._run_message_action)
        self.notifications = DesktopNotifications(self, runner)
        self.tour = Tour(
            document, scene, viewport, control, self.central_widget.card,
            self.lifecycle.may_leave, dialogs.ask_to_remove_targets, panels.workflow.open,
            lambda colouring: self.actions_[COLOUR_ACTIONS[colouring]].trigger(),
        )  # fmt: skip
        self.tools.point_readout.may_show_tooltip = lambda: (
            not (self.tour.is_running or runner.busy or control.candidate is not None)
        )
        FileDrops(self).dropped.connect(self.lifecycle.open_dropped)

    def _connect_features(self) -> None:
        """Create the controllers of the features that are independent of others."""
        tools = self.tools
        parts = WindowParts(
            self.document, self.runner, self.scene, self.viewport, self.controller,
            self.computations, self.dialogs, self.settings, self.actions_, tools.mouse_tool,
            lambda: tools.clipping.box,
        )  # fmt: skip
        self.feature_controllers: list[object] = []
        self.panel_controllers: dict[str, QObject] = {}
        for feature in FEATURES:
            if feature.connect is not None:
                self.feature_controllers.append(feature.connect(parts))
            for each in feature.panels:
                if each.connect is not None:
                    panel = self.panels[each.name]
                    self.panel_controllers[each.name] = each.connect(panel, parts)

    def _build(self) -> None:
        self.panels = Panels()
        self._name_panels()
        self._stops.callback(self.adjust.stop)
        self.central_widget = CentralWidget(self.viewport)
        self.setCentralWidget(self.central_widget)
        self.task_bar = TaskStatusBar()
        self.warnings_button = WarningsButton()
        self.task_bar.insertPermanentWidget(1, self.warnings_button)  # after `point`
        self.warnings_button.hide()
        self.setStatusBar(self.task_bar)
        self.actions_.create_toolbar("toolbar")
        self.docks = docks.create_docks(self, self.panels.docks(self.tools.panels))
        self.tools.point_readout.shown.connect(self.task_bar.point.setText)
        self.dock_layout = docks.DockLayout(
            self, self.docks, automatic_docks(), accompanying_docks()
        )
        self.panel_windows = {
            place.title: PanelWindow(
                place.title,
                panel,
                place.size,
                self,
                self.settings,
                self.central_widget if place.spares_view else None,
                place.narrow_width,
            )
            for panel, place in self.panels.windows()
        }
        # `isVisible` is also True for a dock behind another; only this signal is reliable
        self.docks[SECTION].visibilityChanged.connect(self.tools.sections.set_panel_visible)
        self.actions_.fill_menus(docks.dock_actions(self.docks))
        screen = self.screen().availableGeometry()
        self.resize(min(1600, screen.width()), min(1000, screen.height()))
        if self.settings.layout() is None:
            if screen.height() < self.height() + MAX_TITLE_BAR_HEIGHT_PX:
                self.setWindowState(Qt.WindowState.WindowMaximized)
            self.dock_layout.set_initial_sizes()

    def _restore_layout(self) -> None:
        """Restore the stored layout of an earlier window.

        The style sheet must be set: Qt keeps a copy of the restored layout with the width of the
        separators, and uses it if the size of the window changes within the next 150 ms.
        """
        if (stored := self.settings.layout()) is not None:
            self.restoreGeometry(stored[0])
            self.dock_layout.restore(
                stored[1],
                self.settings.open_panels,
                has_strip_height=self.settings.has_panel_height,
            )

    def sizeHint(self) -> QSize:
        """Preferred size, in pixels."""
        return QSize(1600, 1000)

    def focusNextPrevChild(self, forward: bool) -> bool:
        """Move the focus with Tab and Shift+Tab."""
        return tab_order.focus_next(self, forward)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Press the focused button with Enter."""
        if not tab_order.press_focused_button(self, event):
            super().keyPressEvent(event)

    def _connect_panels(self) -> None:
        data, targets, control = self.data, self.targets, self.controller
        data.line_shown.connect(self.viewport.set_line_visible)
        data.settings_edited.connect(control.change_settings)
        targets.renamed.connect(self._rename)
        targets.selected.connect(lambda name: self._select(name, ""))
        targets.activated.connect(lambda name: self._go_to(name, ""))
        self.table.sighting_selected.connect(self._select)
        self.table.sighting_activated.connect(self._go_to)
        self.diagnostics.row_activated.connect(self._go_to)
        self.histograms.plane_selected.connect(lambda name: self._select(name, ""))
        self.histograms.plane_activated.connect(lambda name: self._go_to(name, ""))
        self.histograms.used_changed.connect(self.controller.use_target)
        enlargeable = (self.results, self.histograms, self.tools.sections.panel)
        for panel in enlargeable:
            panel.enlarged.connect(partial(self.dock_layout.set_enlarged, panel))
            for other in enlargeable:  # in the same dock area
                panel.enlarged.connect(other.enlarge.setChecked)
        self.adjust.subsample_changed.connect(self.computations.count)
        self.adjust.settings_edited.connect(control.change_settings)
        self.results.estimate_requested.connect(self._estimate_with)
        self.adjust.estimate_requested.connect(self.actions_["estimate"].trigger)
        self.adjust.cancel_requested.connect(self.runner.cancel)
        self.central_widget.start.link_clicked.connect(lambda name: self.actions_[name].trigger())
        self.central_widget.start.project_chosen.connect(self.open_project)

    def _connect_actions(self) -> None:
        actions = self.actions_
        self.dock_layout.opens_by_itself.connect(self.viewport.keep_picture)
        self.dock_layout.closed_by_user.connect(
            lambda title: self._note(gettext(CLOSED_TEXT, panel=gettext(title)))
        )
        self.dock_layout.maximised_changed.connect(actions["maximise"].setChecked)
        for each in self.panel_windows.values():
            each.share_actions(actions.all)
        actions.connect_slots(
            {
                "quit": self.close,
                "seed_target": lambda: self._set_seed_role("target"),
                "seed_validation": lambda: self._set_seed_role("validation"),
                "estimate": self._estimate,
                "cancel": self.runner.cancel,
                **{name: partial(self.workflow.go_to, k) for k, name in enumerate(STEP_ACTIONS)},
                "arrange": self.dock_layout.restore_default,
                "maximise": lambda: self.dock_layout.set_maximised(actions["maximise"].isChecked()),
                **{
                    place.action: partial(docks.raise_panel, panel)
                    for panel, place in self.panels.windows()
                },
                "keys": self.dialogs.shortcuts,
                "tour": lambda: self.tour.start(),
                "log_file": self._open_log_file,
                "about": self.dialogs.about,
            }
        )

    def _connect_tasks(self) -> None:
        self.document.changed.connect(self._clear_outdated_note)
        self.document.reverted.connect(self._select_reverted)
        for bar in self._task_bars:
            bar.cancel_requested.connect(self.runner.cancel)
            self.runner.progress_changed.connect(lambda bar=bar: bar.show_task(self.runner.current))
        self.runner.failed.connect(self.dialogs.show_error)
        self.runner.stopped.connect(self._note_cancelled)
        self.runner.cancelled_too_late.connect(self._note)
        self.controller.refused.connect(self.dialogs.show_error)
        self.controller.logged.connect(self._note)
        self.actions_.stepped.connect(self._note)
        self.estimation.estimated.connect(partial(self.workflow.open, status.ADJUST))
        self.estimation.checking.connect(self.results.show_checking)
        self.scene.placement_requested.connect(lambda: self.computations.show("estimated"))
        self.viewport.signals.seed_clicked.connect(self._on_seed_clicked)
        self.viewport.signals.missed.connect(self._on_missed)
        self.targets.role_changed.connect(self.viewport.show_seed_role)
        self.controller.seed_refused.connect(self._on_seed_refused)

    def _note_cancelled(self, task: str) -> None:
        self._note(gettext("{task}: cancelled", task=task))

    def _clear_outdated_note(self) -> None:
        """Clear the note in the status bar if it referred to another state of the project."""
        if self.document.project is not self._noted_project:
            self.task_bar.clearMessage()

    def _note(self, text: str) -> None:
        self._noted_project = self.document.project
        LOGGER.info(text)
        self.log.note(text)
        for bar in self._task_bars:
            bar.showMessage(text, NOTE_DURATION_MS)

    @property
    def _task_bars(self) -> list[TaskStatusBar]:
        """Status bars of this window and of the windows of its panels."""
        return [self.task_bar, *(each.task_bar for each in self.panel_windows.values())]

    # -- requests --------------------------------------------------------------------------

    def open_project(self, path: Path) -> None:
        """Open a project, after asking about changes to the present one."""
        self.lifecycle.open_project(path)

    def _open_log_file(self) -> None:
        file = self.settings.folder / LOG_NAME
        if not QDesktopServices.openUrl(QUrl.fromLocalFile(str(file))):
            self._note(gettext("No program is set up to open {file}.", file=file))

    def _set_seed_role(self, role: str) -> None:
        self.targets.set_role(role)
        self.workflow.open(status.TARGETS)

    def _show_in_targets_step(self, widget: QWidget) -> None:
        self.workflow.open(status.TARGETS)
        self.workflow.scroll_to(widget)

    def _on_seed_clicked(self, point: PickedPoint) -> None:
        def seed() -> None:
            self.controller.seed(point, self.targets.seed_options)

        self.actions_.guarded(seed, self.targets)()

    def _on_missed(self, place: QPoint) -> None:
        QToolTip.showText(place, gettext(NO_POINT_TEXT), self.viewport.widget)
        if not self.tools.mouse_tool.tool:
            self._note(gettext(MISSED_TEXTS[self.targets.role]))

    def _on_seed_refused(self, reason: str) -> None:
        QToolTip.showText(QCursor.pos(), reason, self.viewport.widget)
        self._note(reason)

    def _estimate(self) -> None:
        settings = self.adjust.settings()
        if settings is not None:
            self._estimate_with(settings)

    def _estimate_with(self, settings: Settings) -> None:
        self.estimation.request_estimate(settings, self.adjust.cross_check.isChecked())

    def _find_input_error(self) -> Message | None:
        """Reason why a value typed for a workflow step is not accepted; None if there is none."""
        return first_input_error(self.panels.workflow) or self.adjust.input_error

    def _discard_typed_texts(self) -> None:
        for field in self.panels.workflow.findChildren(QWidget):
            if isinstance(field, NumberEntry):
                field.restore()

    def _restore_panel_height(self) -> None:
        """Restore the height of the panels at the bottom if one of them is enlarged."""
        self.results.enlarge.setChecked(False)  # the buttons of all panels change together

    def _select(self, name: str, line: str) -> None:
        """Select a sighting, or a target if ``line`` is empty, without moving the view."""
        self.scene.select(name, line)
        self._select_in_panels(name, line)
        reasons = self.table.sightings.quality_sentences(name, line)
        self.task_bar.showMessage(reasons, NOTE_DURATION_MS)

    def _go_to(self, name: str, line: str) -> None:
        """Select a sighting, or a target if ``line`` is empty, and move the view to it."""
        self.scene.focus_on(name, line)
        self._select_in_panels(name, line)

    def _select_in_panels(self, name: str, line: str) -> None:
        self.targets.select(name)
        self.table.select(name)
        self.diagnostics.select(name, line)
        self.histograms.select(name)

    def _select_accepted(self, name: str) -> None:
        """Select the accepted target without moving the view."""
        self.scene.select(name)
        self.table.select(name)
        self.histograms.select(name)
        if self.targets.line is None:  # else the next seed would add to it
            self.targets.select(name)

    def _select_reverted(self, name: str) -> None:
        """Select the target of the edit that was undone or redone; the status bar names the edit.

        A restored validation would otherwise select its worst plane.
        """
        self.scene.select(name)
        self._select_in_panels(name, "")

    def _preview_settings(self) -> HoverPreviewSettings:
        targets = self.targets
        return HoverPreviewSettings(targets.threshold, targets.radius, targets.shape == "plane")

    def _run_message_action(self, action: Action) -> None:
        """Use the LiDAR noise found in the residuals, or show the signs of the attitude."""
        if action.code == CHECK_SIGN_CODE:
            self._check_signs()
            return
        project = self.document.project
        if project is None or project.result is None:
            return
        ratio = project.result.lidar_noise_ratio
        if action.code in NOISE_ACTIONS and ratio is not None:
            self._estimate_with(project.settings.with_lidar_noise_scaled(ratio))

    def _check_signs(self) -> None:
        """Show the signs of the attitude, and correct those that the user finds reversed."""
        project, survey = self.document.current_data
        if project is None or survey is None:
            return
        angles = self.dialogs.check_signs(survey, reversible_angles(project))
        if self.document.project is project:
            self.controller.reverse_signs(angles)

    def _set_title(self) -> None:
        project = self.document.project
        self.setWindowTitle("LISPAC" if project is None else f"{project.name}[*] – LISPAC")
        self.setWindowModified(self.document.is_modified)

    def _rename(self, old: str, new: str) -> None:
        if self.controller.rename(old, new):
            self._select(new.strip(), "")
        else:
            self._select(old, "")
            # Later, since the table closes the field of the refused name only now
            QTimer.singleShot(0, self.targets, partial(self.targets.edit_name, new))

    def rebuild_window(self) -> None:
        """Request a new window with the present settings, after tasks that are not quiet."""
        for runner in (self.runner, *self.site_design.runners):
            if runner.busy:
                self._note(gettext("A task is running. The change takes effect when it has ended."))
                runner.idle.connect(self.rebuild_window, Qt.ConnectionType.SingleShotConnection)
                return
        QTimer.singleShot(MENU_CLOSING_MS, self, self._request_renewal)

    def _request_renewal(self) -> None:
        if not self.isHidden():  # closed in the meantime
            self.renewal_requested.emit()

    # -- closing -----------------------------------------------------------------------------

    def closeEvent(self, event: QCloseEvent) -> None:
        """Close the window, unless the user keeps unsaved changes."""
        commit_focused_field()
        if not (self._may_stop_tasks() and self.lifecycle.may_leave() and self.site_design.leave()):
            event.ignore()
            return
        self._restore_panel_height()
        self.save_layout()
        self.recovery_copies.discard()
        self.settings.last_project = None
        self.stop_and_hide()
        event.accept()

    def _may_stop_tasks(self) -> bool:
        """Whether no task is running, or the user agrees that it is stopped."""
        titles = [
            runner.current.title
            for runner in (self.runner, *self.site_design.runners)
            if runner.busy and runner.current is not None
        ]
        return not titles or self.dialogs.ask_to_stop(titles[0])

    def save_layout(self) -> None:
        """Store the layout of window and panels in the settings."""
        layout, self.settings.open_panels = self.dock_layout.state()
        self.settings.has_panel_height = self.dock_layout.has_strip_height
        self.settings.save_layout(self.saveGeometry(), layout)
        for each in self.panel_windows.values():
            each.save_geometry()
        self.settings.sync()

    def stop_and_hide(self) -> None:
        """Hide the window and stop all work without asking.

        The window is hidden first, since running work may take seconds to stop.
        """
        docks.hide_floating_docks(self.docks)
        for each in self.panel_windows.values():
            each.hide()
        self.hide()
        self._stops.close()

    def discard(self) -> None:
        """Stop all work and delete the window, which may be incomplete, at once."""
        self.stop_and_hide()
        self.deleteLater()
        QCoreApplication.sendPostedEvents(self, QEvent.Type.DeferredDelete)
