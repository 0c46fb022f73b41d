"""Message boxes with a question, and the message box for errors."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Literal

from PySide6.QtWidgets import (
    QAbstractButton,
    QDialog,
    QFileDialog,
    QMessageBox,
    QPushButton,
    QWidget,
)

from lispac.errors import LispacError
from lispac.gui import widgets
from lispac.gui.app.log_file import LOGGER
from lispac.gui.widgets.error_box import error_box, error_text_and_details
from lispac.language import Plural, gettext

SaveChoice = Literal["save", "discard", "cancel"]
CandidateChoice = Literal["accept", "reject", "cancel"]
DropChoice = Literal["add", "new", "cancel"]
MAX_NAMED_FILES = 8
"""Largest number of files that are listed by name."""


def run_dialog(dialog: QDialog) -> bool:
    """Show a dialogue until it is closed, and delete it; return whether it was accepted."""
    accepted = dialog.exec() == QDialog.DialogCode.Accepted
    dialog.deleteLater()
    return accepted


def ask_to_replace(paths: Sequence[Path], parent: QWidget | None) -> bool:
    """Ask whether to replace existing files."""
    box = widgets.MessageBox(
        QMessageBox.Icon.Question, "LISPAC",
        gettext(
            Plural(
                "{count:n} file exists already and would be replaced.",
                "{count:n} files exist already and would be replaced.",
            ),
            count=len(paths),
        ),
        QMessageBox.StandardButton.Cancel, parent,
    )  # fmt: skip
    box.setObjectName("replace_dialog")
    box.setInformativeText("\n".join(_limited_list([str(path) for path in paths])))
    replace = box.addButton(gettext("Replace"), QMessageBox.ButtonRole.DestructiveRole)
    cancel = box.button(QMessageBox.StandardButton.Cancel)
    box.setDefaultButton(cancel)
    box.exec()
    chosen = box.clickedButton()
    box.deleteLater()
    return chosen is replace


def _limited_list(names: Sequence[str]) -> list[str]:
    """Names, with a number instead of those after the first ones."""
    shown = list(names[:MAX_NAMED_FILES])
    if more := len(names) - len(shown):
        shown.append(
            gettext(Plural("and {count:n} more file", "and {count:n} more files"), count=more)
        )
    return shown


class Questions:
    """Questions to the user, asked in message boxes."""

    def __init__(self) -> None:
        self.parent: QWidget | None = None
        self._error_open = False

    def ask_to_add(self, name: str) -> DropChoice:
        """Ask whether dropped files are added to the open project or form a new project."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC",
            gettext("Add the files to {project}?", project=name),
            QMessageBox.StandardButton.Cancel, self.parent,
        )  # fmt: skip
        box.setObjectName("drop_dialog")
        box.setInformativeText(
            gettext(
                "Added lines are checked against the trajectory of the project, and its targets "
                "are kept. Create a new project for files of another survey."
            )
        )
        add = box.addButton(
            gettext("Add to {project}", project=name), QMessageBox.ButtonRole.AcceptRole
        )
        new = box.addButton(gettext("New project"), QMessageBox.ButtonRole.ActionRole)
        return {add: "add", new: "new"}.get(self._clicked(box, add), "cancel")

    def ask_to_save_changes(self, name: str) -> SaveChoice:
        """Ask whether to save a changed project before it is closed."""
        buttons = QMessageBox.StandardButton
        box = widgets.MessageBox(
            QMessageBox.Icon.Question,
            "LISPAC",
            gettext("{project} has changes that are not saved.", project=name),
            buttons.Save | buttons.Discard | buttons.Cancel,
            self.parent,
        )
        box.setInformativeText(
            gettext(
                "If you discard them, {project} stays as it was last saved. Cancel keeps the "
                "project open with its changes.",
                project=name,
            )
        )
        # Qt's own labels differ between systems, and its French ones are poor
        box.button(buttons.Save).setText(gettext("Save the changes"))
        box.button(buttons.Discard).setText(gettext("Discard the changes"))
        box.setDefaultButton(buttons.Save)
        chosen = box.exec()
        box.deleteLater()
        if chosen == buttons.Save:
            return "save"
        return "discard" if chosen == buttons.Discard else "cancel"

    def ask_about_candidate(self, name: str, *, is_search: bool = False) -> CandidateChoice:
        """Ask whether to accept or reject the candidate before the adjustment or another search."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC",
            gettext("{target} has been found but not accepted yet.", target=name),
            QMessageBox.StandardButton.Cancel, self.parent,
        )  # fmt: skip
        box.setObjectName("candidate_dialog")
        if is_search:
            text = gettext("The search for another target would replace it.")
            accept_text, reject_text = gettext("Accept and search"), gettext("Reject and search")
        else:
            text = gettext("The adjustment uses accepted targets only.")
            accept_text = gettext("Accept and estimate")
            reject_text = gettext("Estimate without this target")
        box.setInformativeText(text)
        accept = box.addButton(accept_text, QMessageBox.ButtonRole.AcceptRole)
        reject = box.addButton(reject_text, QMessageBox.ButtonRole.DestructiveRole)
        return {accept: "accept", reject: "reject"}.get(self._clicked(box, accept), "cancel")

    def ask_to_recover(self, name: str, when: str) -> bool:
        """Ask whether to restore unsaved changes after a crash."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC",
            gettext("{project} has changes that were not saved when the program ended.",
                    project=name),
            parent=self.parent,
        )  # fmt: skip
        box.setObjectName("recover_dialog")
        box.setInformativeText(
            gettext(
                "Time of the automatic copy: {when}. One undo step removes the restored changes.",
                when=when,
            )
        )
        restore = box.addButton(gettext("Restore"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(gettext("Discard"), QMessageBox.ButtonRole.DestructiveRole)
        return self._is_confirmed(box, restore)

    def ask_files_folder(self, name: str, missing: Sequence[Path], start: Path) -> Path | None:
        """Ask for the folder of the missing files; None if the project stays closed."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC",
            gettext(
                Plural(
                    "{project}: {count:n} input file is missing.",
                    "{project}: {count:n} input files are missing.",
                ),
                project=name, count=len(missing),
            ),
            QMessageBox.StandardButton.Cancel, self.parent,
        )  # fmt: skip
        box.setObjectName("files_dialog")
        shown = _limited_list([str(path) for path in missing])
        advice = gettext(
            "Choose the folder that contains the files now, or one of its parent folders."
        )
        box.setInformativeText("\n".join([*shown, "", advice]))
        choose = box.addButton(gettext("Choose folder…"), QMessageBox.ButtonRole.AcceptRole)
        if not self._is_confirmed(box, choose):
            return None
        folder = QFileDialog.getExistingDirectory(
            self.parent, gettext("Folder with the input files of the project"), str(start)
        )
        return Path(folder) if folder else None

    def ask_to_open_locked(self, name: str, where: str) -> bool:
        """Ask whether to open a project that is open in another window."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Warning, "LISPAC",
            gettext("{project} is already open in another window.", project=name),
            parent=self.parent,
        )  # fmt: skip
        box.setObjectName("elsewhere_dialog")
        place = gettext("The project is open in: {place}.", place=where)
        effect = gettext(
            "If both windows save the project, the later save overwrites the earlier one. Unsaved "
            "changes of this window cannot be restored after a crash."
        )
        box.setInformativeText(f"{place}\n{effect}")
        stay = box.addButton(gettext("Do not open"), QMessageBox.ButtonRole.RejectRole)
        open_it = box.addButton(gettext("Open anyway"), QMessageBox.ButtonRole.DestructiveRole)
        box.setDefaultButton(stay)
        box.setEscapeButton(stay)
        return self._is_confirmed(box, open_it, default=stay)

    def ask_to_overwrite(self, name: str) -> bool:
        """Ask whether to overwrite a project that another program has changed."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Warning, "LISPAC",
            gettext("{project} was changed by another program after it was opened.", project=name),
            QMessageBox.StandardButton.Cancel, self.parent,
        )  # fmt: skip
        box.setObjectName("overwrite_dialog")
        box.setInformativeText(
            gettext(
                "If you overwrite the project, the changes of the other program are lost. To keep "
                "both, save the project in another folder with File > Save as…."
            )
        )
        anyway = box.addButton(gettext("Overwrite"), QMessageBox.ButtonRole.DestructiveRole)
        cancel = box.button(QMessageBox.StandardButton.Cancel)
        return self._is_confirmed(box, anyway, default=cancel)

    def file_to_save(
        self,
        title: str,
        start: Path,
        filters: Mapping[str, str],
        *,
        keeps_other_endings: bool = True,
    ) -> tuple[Path, str] | None:
        """Ask for a file to write; None if cancelled.

        A name without a known ending gets that of the chosen filter. Qt asks before it returns the
        name of an existing file; this method asks if the name with its ending is that of a file.

        Parameters
        ----------
        filters : mapping of the text of each filter to its ending
        keeps_other_endings : bool
            Whether an ending of another filter is kept, instead of adding that of the chosen one.

        Returns
        -------
        path : Path
        chosen : str
            Text of the chosen filter.
        """
        while True:
            name, chosen = QFileDialog.getSaveFileName(
                self.parent, title, str(start), ";;".join(filters)
            )
            if not name:
                return None
            chosen = chosen if chosen in filters else next(iter(filters))
            typed = Path(name)
            known = filters.values() if keeps_other_endings else (filters[chosen],)
            path = typed
            if typed.suffix.lower() not in known:
                path = typed.with_name(typed.name + filters[chosen])
            if path == typed or not path.exists() or ask_to_replace([path], self.parent):
                return path, chosen
            start = path

    def ask_to_remove_targets(self, count: int) -> bool:
        """Ask whether to remove the targets of the demo project for the tour."""
        return self._may_leave(
            self.parent,
            "remove_targets_dialog",
            gettext(
                Plural(
                    "The demo project contains {count:n} target or validation plane.",
                    "The demo project contains {count:n} targets and validation planes.",
                ),
                count=count,
            ),
            gettext(
                "The tour starts without them. Undo (Ctrl+Z) restores them, and the saved project "
                "changes only when you save it."
            ),
            stay=gettext("Keep them"),
            leave=gettext("Start the tour"),
        )

    def ask_to_stop(self, task: str) -> bool:
        """Ask whether to close the program although a task is running."""
        return self._may_leave(
            self.parent,
            "stop_dialog",
            gettext("A task is running: {task}.", task=task),
            gettext("If you close the program, the task is stopped without a result."),
            stay=gettext("Continue the task"),
            leave=gettext("Stop and close"),
        )

    @staticmethod
    def ask_to_leave_import(dialog: QWidget) -> bool:
        """Ask whether to close the import dialogue without importing its files."""
        return Questions._may_leave(
            dialog,
            "leave_dialog",
            gettext("Close without importing the files?"),
            gettext("The import settings will be lost. The files are not changed."),
            stay=gettext("Continue importing"),
            leave=gettext("Close without importing"),
        )

    @staticmethod
    def ask_to_discard_input(dialog: QWidget) -> bool:
        """Ask whether to close a dialogue although its fields were changed."""
        return Questions._may_leave(
            dialog,
            "discard_dialog",
            gettext("Close without keeping what you typed?"),
            gettext("The fields stay as they were before this dialogue was opened."),
            stay=gettext("Continue typing"),
            leave=gettext("Close without keeping"),
        )

    @staticmethod
    def _may_leave(
        parent: QWidget | None, name: str, question: str, effect: str, *, stay: str, leave: str
    ) -> bool:
        box = widgets.MessageBox(QMessageBox.Icon.Question, "LISPAC", question, parent=parent)
        box.setObjectName(name)
        box.setInformativeText(effect)
        stay_button = box.addButton(stay, QMessageBox.ButtonRole.RejectRole)
        leave_button = box.addButton(leave, QMessageBox.ButtonRole.DestructiveRole)
        box.setEscapeButton(stay_button)
        return Questions._is_confirmed(box, leave_button, default=stay_button)

    @staticmethod
    def _is_confirmed(
        box: QMessageBox, yes: QPushButton, default: QPushButton | None = None
    ) -> bool:
        return Questions._clicked(box, default or yes) is yes

    @staticmethod
    def _clicked(box: QMessageBox, default: QPushButton) -> QAbstractButton:
        box.setDefaultButton(default)
        box.exec()
        chosen = box.clickedButton()
        box.deleteLater()
        return chosen

    def show_error(self, error: BaseException) -> None:
        """Log an error, and show it unless another one is being shown."""
        LOGGER.error(
            error_text_and_details(error)[0],
            exc_info=None if isinstance(error, LispacError) else error,
        )
        if self._error_open:
            return
        self._error_open = True
        try:
            box = error_box(self.parent, error)
            box.exec()
            box.deleteLater()
        finally:
            self._error_open = False
