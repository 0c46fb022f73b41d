"""Import dialogues for a new project and for more lines: layout and connection of the parts."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QIcon, QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QHBoxLayout,
    QLineEdit,
    QProgressBar,
    QPushButton,
    QSplitter,
    QStackedLayout,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.app.settings import AppSettings
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.open_project.actions import ACTIONS
from lispac.gui.features.open_project.import_survey.drop_area import DropArea
from lispac.gui.features.open_project.import_survey.file_page import FilePage
from lispac.gui.features.open_project.import_survey.file_table import FileTable
from lispac.gui.features.open_project.import_survey.import_worker import ImportWorker
from lispac.gui.features.open_project.import_survey.mounting_page import MountingPage
from lispac.gui.features.open_project.import_survey.quality_page import QualityPage
from lispac.gui.features.open_project.import_survey.timeline_page import TimelinePage
from lispac.gui.widgets.error_box import error_text_and_details
from lispac.gui.widgets.file_drops import FileDrops
from lispac.gui.widgets.number_input import NumberDialog
from lispac.gui.widgets.reserved_label import ReservedLabel
from lispac.identity import EMPTY_IDENTITY
from lispac.installation_paths import expand_user
from lispac.io.formats import ACCURACY_FORMATS, POINT_FORMATS, TRAJECTORY_FORMATS
from lispac.language import Plural, gettext
from lispac.messages import Action, Message, note
from lispac.project import LineSource, Project
from lispac.survey.trajectory import TrajectoryAccuracy
from lispac.workflow.importing.input_files import ImportRequest, InputFiles, proposed_folder
from lispac.workflow.planning.sensors import read_library

FILE, TIMELINE, QUALITY, MOUNTING = range(4)
"""Indices of the tabs."""


def survey_file_filters() -> str:
    """Filters of the file dialogue: the suffixes of all formats, or all files."""
    formats = (*POINT_FORMATS, *TRAJECTORY_FORMATS, *ACCURACY_FORMATS)
    known = dict.fromkeys(f"*{ending}" for each in formats for ending in each.endings)
    return ";;".join(
        [
            gettext("Survey files ({patterns})", patterns=" ".join(known)),
            gettext("All files (*)"),
        ]
    )


class ImportDialog(NumberDialog):
    """Dialogue that reads the added files, checks their consistency, and defines the project.

    Parameters
    ----------
    settings : AppSettings
        Stores the columns chosen for text files.
    """

    def __init__(self, settings: AppSettings, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._settings = settings
        self.project: Path | None = None
        """Dropped project that is to be opened instead of an import; None if there is none."""
        self._folder_is_typed = False
        self._fitted_rows = 0
        self.setObjectName("import_dialog")
        self.setWindowTitle(dialog_title(ACTIONS["new"]))
        self.setWindowFlag(Qt.WindowType.WindowMaximizeButtonHint, True)
        self.work = ImportWorker(settings.column_mappings(), self)
        self._build()
        self._connect_signals()
        self._show()
        screen = self.screen().availableGeometry()
        self.resize(min(1240, screen.width() - 40), min(940, screen.height() - 60))
        table = min(290, self.height() * 3 // 10)
        self._split.setSizes([table, self.height() - table])

    @property
    def input_files(self) -> InputFiles:
        """The files and their settings."""
        return self.work.input_files

    def add(self, paths: Sequence[Path]) -> None:
        """Add files and folders."""
        if paths:
            self.work.add(paths)

    def request(self) -> ImportRequest:
        """The import as filled in."""
        folder = expand_user(Path(self.folder.text().strip()))
        identity = EMPTY_IDENTITY.changed(**self.mounting.sensors.identity_fields)
        return replace(
            self.input_files.request(folder, self.mounting.settings()), identity=identity
        )

    # -- assembly ----------------------------------------------------------------------------

    def _build(self) -> None:
        outer = QVBoxLayout(self)
        outer.setSpacing(theme.SPACING)
        outer.setContentsMargins(14, 12, 14, 12)
        self.empty = DropArea()
        self._stack = QStackedLayout()
        outer.addLayout(self._stack, 1)
        self._stack.addWidget(self.empty)
        # Built from the outside in, since Qt restyles all children with each new parent
        filled = QWidget(self)
        self._stack.addWidget(filled)
        self._fill_layout(filled)
        outer.addLayout(self._create_bottom())

    def _fill_layout(self, filled: QWidget) -> None:
        layout = QVBoxLayout(filled)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(theme.SPACING)
        layout.addLayout(self._create_bar())
        self._split = split = QSplitter(Qt.Orientation.Vertical, filled)
        layout.addWidget(split, 1)
        split.setChildrenCollapsible(False)
        self.table = FileTable()
        self.tabs = QTabWidget()
        self.tabs.setObjectName("import_tabs")
        split.addWidget(self.table)
        split.addWidget(self.tabs)
        split.setStretchFactor(1, 1)
        self.file_page, self.timeline = FilePage(), TimelinePage()
        self.quality, self.mounting = (
            QualityPage(),
            MountingPage(read_library(self._settings.sensors)),
        )
        self.mounting.sensors.choose(*self._settings.default_sensors)
        self.tabs.addTab(self.file_page, gettext("Selected file"))
        self.tabs.addTab(self.timeline, gettext("Timeline"))
        self.tabs.addTab(self.quality, gettext("Trajectory quality"))
        self.tabs.addTab(self.mounting, gettext("Mounting and accuracies"))

    def _create_bar(self) -> QHBoxLayout:
        row = QHBoxLayout()
        self.add_files = widgets.button(
            gettext("Add files…"), "import_add_files", icon="file-plus-outline"
        )
        self.add_folder = widgets.button(
            gettext("Add folder…"), "import_add_folder", icon="folder-plus-outline",
            tip=gettext("Add the files of a folder, without its subfolders"),
        )  # fmt: skip
        self.remove = widgets.button(
            gettext("Remove"), "import_remove",
            tip=gettext("Remove the selected file from the list (Delete)"),
        )  # fmt: skip
        self.progress = QProgressBar()
        self.progress.setRange(0, 1000)
        self.progress.setTextVisible(False)
        self.progress.setFixedWidth(180)
        self.progress.setAccessibleName(gettext("Progress of reading the files"))
        self.progress_label = widgets.label("", "muted", name="import_doing")
        self.stop = widgets.button(
            gettext("Stop"), "import_stop", tip=gettext("Stop reading files")
        )
        self.again = widgets.button(
            gettext("Read again"), "import_read_again",
            tip=gettext("Read the files that were skipped when reading was stopped"),
        )  # fmt: skip
        for each in (self.add_files, self.add_folder, self.remove):
            row.addWidget(each)
        row.addStretch(1)
        for each in (self.progress_label, self.progress, self.stop, self.again):
            row.addWidget(each)
        for each in (self.add_files, self.add_folder, self.remove, self.stop, self.again):
            each.setAutoDefault(False)
        return row

    def _create_bottom(self) -> QVBoxLayout:
        self.folder = QLineEdit()
        self.folder.setObjectName("new_folder")
        self.folder.setAccessibleName(gettext("Project folder"))
        self.folder.setToolTip(
            gettext("Folder of the new project; the survey files are not moved or copied")
        )
        self.browse = widgets.button(gettext("Browse…"), "new_folder_browse")
        self.browse.setAutoDefault(False)
        head = widgets.label(gettext("Project folder"))
        head.setBuddy(self.folder)
        self.place = QWidget()
        upper = QHBoxLayout(self.place)
        upper.setContentsMargins(0, 0, 0, 0)
        upper.addWidget(head)
        upper.addWidget(self.folder, 1)
        upper.addWidget(self.browse)
        self.reason = ReservedLabel("error", "new_reason", lines=2)
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.ok = self.buttons.button(QDialogButtonBox.StandardButton.Ok)
        self.ok.setText(gettext("Create project"))
        self.ok.setObjectName("new_ok")
        self.ok.setProperty("primary", True)
        for standard in self.buttons.buttons():
            standard.setIcon(QIcon())
        lower = QHBoxLayout()
        lower.addWidget(self.reason, 1)
        lower.addWidget(self.buttons, 0, Qt.AlignmentFlag.AlignBottom)
        bottom = QVBoxLayout()
        bottom.setSpacing(theme.SPACING)
        bottom.addWidget(self.place)
        bottom.addLayout(lower)
        return bottom

    def _connect_signals(self) -> None:
        work, edit = self.work, self.work.edit
        work.changed.connect(self._show)
        work.progress_changed.connect(self._show_progress)
        work.runner.failed.connect(self._show_failure)
        work.project_found.connect(self._open_found_project)
        FileDrops(self).dropped.connect(self.add)
        for files in (self.empty.files_requested, self.add_files.clicked):
            files.connect(lambda *_: self._ask_files())
        for folder in (self.empty.folder_requested, self.add_folder.clicked):
            folder.connect(lambda *_: self._ask_folder())
        self.remove.clicked.connect(self._remove)
        self.stop.clicked.connect(work.stop)
        self.again.clicked.connect(work.read_skipped)
        delete = QShortcut(QKeySequence(Qt.Key.Key_Delete), self.table)
        delete.setContext(Qt.ShortcutContext.WidgetShortcut)
        delete.activated.connect(self._remove)
        table = self.table
        table.file_selected.connect(lambda _path: self._show_selected())
        table.role_chosen.connect(lambda path, role: edit(self.input_files.with_role(path, role)))
        table.format_chosen.connect(lambda path, key: edit(self.input_files.with_format(path, key)))
        page = self.file_page
        page.action_chosen.connect(
            lambda chosen_action: self._apply_action(table.current, chosen_action)
        )
        page.sign_check_requested.connect(self._check_sign)
        page.option_edited.connect(
            lambda name, value: edit(self.input_files.with_option(table.current, name, value))
        )
        page.meaning_chosen.connect(
            lambda column, what: edit(self.input_files.with_column(table.current, column, what))
        )
        self.timeline.action_chosen.connect(self._apply_action)
        self.timeline.file_selected.connect(table.select)
        self.timeline.shift_all_requested.connect(
            lambda: edit(self.input_files.with_shift_for_all())
        )
        self.timeline.gap_changed.connect(
            lambda gap: edit(replace(self.input_files, longest_gap=gap))
        )
        self.mounting.changed.connect(self._show_reason)
        self.tabs.currentChanged.connect(self._show_reason)
        self.folder.textEdited.connect(self._on_folder_typed)
        self.browse.clicked.connect(self._ask_project_folder)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self._discard)

    # -- display -----------------------------------------------------------------------------

    def _show(self) -> None:
        input_files = self.input_files
        self._stack.setCurrentIndex(1 if input_files.files or self.work.busy else 0)
        self.table.show_files(input_files)
        self._fit_table()
        self._show_selected()
        self.quality.show_files(input_files)
        accuracy = input_files.accuracy
        found = None if accuracy is None else accuracy.content
        self.mounting.show_accuracy(
            "" if accuracy is None else accuracy.path.name,
            found if isinstance(found, TrajectoryAccuracy) else None,
        )
        content = input_files.trajectory_content
        self.mounting.set_mean_position(None if content is None else content.mean_frame())
        self.mounting.show_prior_needed(any(line.is_georeferenced for line in input_files.lines))
        if not self._folder_is_typed:
            proposed = proposed_folder(input_files)
            self.folder.setText("" if proposed is None else str(proposed))
        count = sum(bool(input_files.time_messages(line)) for line in input_files.lines)
        title = (
            gettext(
                Plural("Timeline ({count:n} line to check)", "Timeline ({count:n} lines to check)"),
                count=count,
            )
            if count
            else gettext("Timeline")
        )
        self.tabs.setTabText(TIMELINE, title)
        self._show_progress()
        self._show_reason()

    def _fit_table(self) -> None:
        """Make the table high enough for its rows, unless they need half of the dialogue."""
        rows, height = self.table.rowCount(), self._split.height()
        if rows != self._fitted_rows and height > 0:
            self._fitted_rows = rows
            table = min(max(self.table.rows_height, height * 3 // 10), height // 2)
            self._split.setSizes([table, height - table])

    def _show_selected(self) -> None:
        current = self.table.current
        file = next((e for e in self.input_files.files if e.path == current), None)
        self.file_page.show_file(self.input_files, file)
        self.timeline.show_files(self.input_files, current)
        self.remove.setEnabled(file is not None and file.project_reading is None)

    def _show_progress(self) -> None:
        busy = self.work.busy
        for each in (self.progress_label, self.progress, self.stop):
            each.setVisible(busy)
        self.again.setVisible(self.work.was_stopped and not busy)
        self.progress.setValue(round(1000 * self.work.fraction))
        self.progress_label.setText(self.work.progress_text)
        if not busy:
            self._show_reason()

    def _show_reason(self) -> None:
        problem = self._problem()
        waiting = any(file.pending for file in self.input_files.files)
        self.reason.setText(self._hint() if problem is None else message_text(problem))
        wrong = problem is not None and bool(self.input_files.files) and not waiting
        self.reason.setProperty("role", "error" if wrong else "muted")
        self.reason.style().polish(self.reason)
        self.ok.setEnabled(problem is None)

    def _problem(self) -> Message | None:
        """Reason why the files cannot be imported; None if they can."""
        return self.input_files.import_problem(self.folder.text())

    def _hint(self) -> str:
        """Warning about the mounting before the import."""
        warnings = self.mounting.mounting_warnings
        if not warnings or self.tabs.currentWidget() is self.mounting:  # which shows them
            return ""
        warning = message_text(warnings[0])
        if more := len(warnings) - 1:
            return gettext(
                Plural(
                    "{warning} See the tab Mounting and accuracies for this and {count:n} more "
                    "warning.",
                    "{warning} See the tab Mounting and accuracies for this and {count:n} more "
                    "warnings.",
                ),
                warning=warning, count=more,
            )  # fmt: skip
        return gettext("{warning} See the tab Mounting and accuracies.", warning=warning)

    # -- requests --------------------------------------------------------------------------

    def _apply_action(self, path: Path, action: Action) -> None:
        self.work.edit(self.input_files.with_action(path, action))

    def _check_sign(self, option: str) -> None:
        """Show the attitude, then focus the option of its sign."""
        # Matplotlib is imported late, so that the dialogue starts without it.
        from lispac.gui.features.open_project.import_survey.quality_figures import TrajectoryQuality
        from lispac.gui.features.open_project.import_survey.sign_check_dialog import SignCheckDialog

        record = TrajectoryQuality.of(self.input_files)
        if record is not None:
            run_dialog(SignCheckDialog(record, "import", self))
        self.file_page.options.focus_option(option, opens=record is None)

    def _remove(self) -> None:
        path = self.table.current
        if path is not None:
            self.work.edit(self.input_files.without_file(path))

    def _ask_files(self) -> None:
        names, _ = QFileDialog.getOpenFileNames(
            self, gettext("Survey files"), self._start_folder(), survey_file_filters()
        )
        self.add([Path(name) for name in names])

    def _ask_folder(self) -> None:
        name = QFileDialog.getExistingDirectory(
            self, gettext("Folder with survey files"), self._start_folder()
        )
        self.add([Path(name)] if name else [])

    def _ask_project_folder(self) -> None:
        name = QFileDialog.getExistingDirectory(self, gettext("Project folder"), self.folder.text())
        if name:
            self.folder.setText(name)
            self._on_folder_typed(name)

    def _start_folder(self) -> str:
        files = self.input_files.files
        return str(files[-1].path.parent) if files else ""

    def _on_folder_typed(self, text: str) -> None:
        self._folder_is_typed = bool(text.strip())
        self._show_reason()

    def _open_found_project(self, project: Path) -> None:
        self.project = project
        self._discard()

    def _show_failure(self, error: BaseException) -> None:
        """Show an error that does not belong to a file, such as a folder that cannot be listed."""
        self._show()
        self.reason.setText(error_text_and_details(error)[0])

    # -- closing -----------------------------------------------------------------------------

    def keyPressEvent(self, event) -> None:
        """Press the focused button with Enter; in a field, Enter must not close the dialogue."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            focused = self.focusWidget()
            if isinstance(focused, QPushButton):
                focused.click()
            return
        super().keyPressEvent(event)

    def reject(self) -> None:
        """Ask before the added files are discarded, on Escape or when the dialogue is closed."""
        if all(
            file.project_reading is not None for file in self.input_files.files
        ) or Questions.ask_to_leave_import(self):
            self._discard()

    def _discard(self) -> None:
        self.done(QDialog.DialogCode.Rejected)

    def done(self, result: int) -> None:
        """Stop the worker and, if the dialogue was accepted, store the meanings of columns."""
        self.work.close()
        if result == QDialog.DialogCode.Accepted:
            self._settings.save_column_mappings(self.input_files.column_mappings)
        super().done(result)


class AddLinesDialog(ImportDialog):
    """Dialogue that adds lines to a project and checks them against its trajectory.

    Parameters
    ----------
    project : Project
        The open project.
    """

    def __init__(
        self, settings: AppSettings, project: Project, parent: QWidget | None = None
    ) -> None:
        super().__init__(settings, parent)
        self.setWindowTitle(gettext("Add lines to {project}", project=project.name))
        self.ok.setText(gettext("Add to project"))
        self.place.hide()
        self.tabs.setTabVisible(MOUNTING, False)
        self.work.begin(InputFiles.of_project(project))

    def sources(self) -> tuple[LineSource, ...]:
        """The lines to add."""
        return self.input_files.sources()

    def _problem(self) -> Message | None:
        if self.input_files.files and not self.input_files.lines and not self.work.busy:
            return note("import.no_lines_added")
        return self.input_files.files_problem()

    def _hint(self) -> str:
        if any(line.is_georeferenced for line in self.input_files.lines):
            return gettext(
                "Georeferenced lines are transformed back to the scanner frame with the lever arm "
                "and prior boresight of the project. Add only lines that were georeferenced with "
                "these values."
            )
        return ""
