"""Opening, saving and leaving a project, with the questions to the user."""

import itertools
import os
from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QMenu

from lispac.errors import InputError
from lispac.gui.app.actions import Actions
from lispac.gui.app.settings import AppSettings
from lispac.gui.app.unavailable import Unavailable
from lispac.gui.features.open_project.dialogs import ProjectDialogs
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.installation_paths import home_folder
from lispac.io.text.seed_file import is_point_list
from lispac.language import gettext
from lispac.project import Project
from lispac.workflow.importing.input_files import find_project
from lispac.workflow.project.moved_files import missing_files, with_files_in


class ProjectLifecycle(QObject):
    """Asks for files and folders, and asks before changes would be lost."""

    list_dropped = Signal(object)
    """Path of a list of target coordinates."""

    def __init__(
        self,
        document: Document,
        controller: Controller,
        dialogs: ProjectDialogs,
        settings: AppSettings,
        actions: Actions,
    ) -> None:
        super().__init__(controller)
        self._document, self._controller = document, controller
        self._dialogs, self._settings, self._actions = dialogs, settings, actions
        controller.files_missing.connect(self._find_missing_files)
        actions.connect_slots(
            {
                "new": self.new,
                "open": self.open,
                "demo": self.demo,
                "add_lines": self.add_lines,
                "save": controller.save,
                "save_as": self.save_as,
                "close_project": self.close,
            }
        )
        actions.submenus["Recent"].aboutToShow.connect(
            lambda: self._list_recent(actions.submenus["Recent"])
        )

    def may_leave(self) -> bool:
        """Whether the project may be closed; asks if there are unsaved changes or wrong texts."""
        project = self._document.project
        problem = self._actions.find_input_error()
        if project is None or not (self._document.is_modified or problem):
            return True
        choice = self._dialogs.ask_to_save_changes(project.name)
        if choice == "save" and problem is not None:
            self._dialogs.show_error(InputError(problem))
            return False
        if choice == "save":
            return self._controller.save()
        return choice == "discard"

    def open_project(self, path: Path) -> None:
        """Open a project, after asking about unsaved changes to the current one."""
        if self.may_leave():
            self._controller.open(path)

    def new(self, paths: Sequence[Path] = ()) -> None:
        """Show the import dialogue and create a project; ``paths`` are added at once."""
        if self.may_leave():
            choice = self._dialogs.new_project(self._settings, paths)
            if isinstance(choice, Path):
                self._controller.open(choice)
            elif choice is not None:
                self._controller.create(choice)

    def add_lines(self, paths: Sequence[Path] = ()) -> None:
        """Show the import dialogue for more lines; ``paths`` are added at once.

        Unsaved changes are kept without a question, since the addition is a further change.
        """
        project = self._document.project
        if project is None:
            return
        choice = self._dialogs.add_lines(self._settings, project, paths)
        if isinstance(choice, Path):
            self.open_project(choice)
        elif choice and self._document.project is project:
            self._controller.add_lines(choice)

    def open_dropped(self, paths: Sequence[Path]) -> None:
        """Open or import files that were dropped on the window.

        A project is opened. A list of target coordinates provides seeds for the open project. Other
        files become lines of the open project, or a new project.
        """
        if self._controller.busy:
            self._controller.logged.emit(
                gettext("Wait until the running task has ended, then drop the files again.")
            )
            return
        project = find_project(paths)
        current = self._document.project
        if project is not None:
            self.open_project(project)
        elif current is None:
            self.new(paths)
        elif len(paths) == 1 and is_point_list(paths[0]):
            self.list_dropped.emit(paths[0])
        else:
            choice = self._dialogs.ask_to_add(current.name)
            if choice == "add":
                self.add_lines(paths)
            elif choice == "new":
                self.new(paths)

    def open(self) -> None:
        """Ask for a project, and open it."""
        if self.may_leave():
            recent = self._settings.recent()
            path = self._dialogs.project_to_open(recent[0].parent if recent else home_folder())
            if path is not None:
                self._controller.open(path)

    def _find_missing_files(self, project: Project) -> None:
        """Ask for the folder of the project's files until all are found."""
        while True:
            folder = self._dialogs.ask_files_folder(
                project.name, missing_files(project), project.folder
            )
            if folder is None:
                self._controller.logged.emit(
                    gettext("{project} was not opened: files are missing", project=project.name)
                )
                return
            try:
                found = with_files_in(project, folder)
            except InputError as error:
                self._dialogs.show_error(error)
                continue
            self._controller.open_relocated(found)
            return

    def save_as(self) -> None:
        """Ask for another folder, save the project there and continue with it."""
        project = self._document.project
        if project is not None and self._document.is_survey_current:
            folder = self._dialogs.folder_to_save_in(_free_folder(project.folder))
            if folder is not None:
                self._controller.save_as(folder)

    def close(self) -> None:
        """Close the project, after asking about unsaved changes."""
        if self.may_leave():
            self._document.open(None, None)

    def demo(self) -> None:
        """Open the demo survey."""
        if self.may_leave():
            self._controller.open_demo()

    def _list_recent(self, menu: QMenu) -> None:
        """Fill the menu of recent projects."""
        menu.clear()
        for folder in self._settings.recent():
            action = menu.addAction(str(folder))
            action.triggered.connect(lambda _=False, folder=folder: self.open_project(folder))
        if menu.isEmpty():
            none = menu.addAction(gettext("No project yet"))
            none.setEnabled(False)
            none.setToolTip(Unavailable.NO_RECENT.text)
        else:
            menu.addSeparator()
            menu.addAction(gettext("Clear recent projects")).triggered.connect(
                self._settings.clear_recent
            )


def _free_folder(folder: Path) -> Path:
    """Unused folder name beside the project, or in the home folder if that is not writable."""
    parent = folder.parent
    if not os.access(parent, os.W_OK):
        parent = home_folder()
    names = (f"{folder.name}-{k}" for k in itertools.count(2))
    return next(parent / name for name in names if not (parent / name).exists())
