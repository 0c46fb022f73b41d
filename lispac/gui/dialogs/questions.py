"""Short questions, and what went wrong."""

from collections.abc import Sequence
from pathlib import Path
from typing import Literal

from PySide6.QtWidgets import QFileDialog, QMessageBox, QPushButton, QWidget

from lispac.errors import LispacError
from lispac.gui.dialogs.error import describe, error_box
from lispac.gui.language import say
from lispac.gui.logbook import LOG
from lispac.gui.panels import widgets
from lispac.gui.status import counted

Answer = Literal["save", "discard", "cancel"]
CandidateAnswer = Literal["accept", "reject", "cancel"]
DropAnswer = Literal["add", "new", "cancel"]
MOST_NAMED = 8
"""Missing files that are named one by one."""


class Questions:
    """Asks what a box with a few buttons can ask."""

    def __init__(self) -> None:
        self.parent: QWidget | None = None
        self._error_open = False

    def add_or_new(self, name: str) -> DropAnswer:
        """What to do with files dropped while a project is open."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC", say(f"Add the files to {name}?"),
            QMessageBox.StandardButton.Cancel, self.parent,
        )  # fmt: skip
        box.setObjectName("drop_dialog")
        box.setInformativeText(
            say(
                "Lines are added to the open project and checked against its trajectory; "
                "what has been "
                "picked stays. Files of another survey make a new project."
            )
        )
        add = box.addButton(say(f"Add to {name}"), QMessageBox.ButtonRole.AcceptRole)
        new = box.addButton(say("New project"), QMessageBox.ButtonRole.ActionRole)
        box.setDefaultButton(add)
        box.exec()
        chosen = box.clickedButton()
        box.deleteLater()
        if chosen is add:
            return "add"
        return "new" if chosen is new else "cancel"

    def save_changes(self, name: str) -> Answer:
        """What to do with a changed project that is to be closed."""
        buttons = QMessageBox.StandardButton
        box = widgets.MessageBox(
            QMessageBox.Icon.Question,
            "LISPAC",
            say(f"Save the changes to {name}?"),
            buttons.Save | buttons.Discard | buttons.Cancel,
            self.parent,
        )
        box.setInformativeText(say("Unsaved changes will be lost."))
        # Qt's own word is another one in each language, and a clumsy one in French
        box.button(buttons.Discard).setText(say("Do not save"))
        box.setDefaultButton(buttons.Save)
        chosen = box.exec()
        box.deleteLater()
        if chosen == buttons.Save:
            return "save"
        return "discard" if chosen == buttons.Discard else "cancel"

    def candidate_waits(self, name: str) -> CandidateAnswer:
        """What to do with a plane that was found and not yet accepted, before estimating."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC", say(f"{name} was found and is not accepted yet."),
            QMessageBox.StandardButton.Cancel, self.parent,
        )  # fmt: skip
        box.setObjectName("candidate_dialog")
        box.setInformativeText(say("Only accepted targets take part in the adjustment."))
        accept = box.addButton(say("Accept and estimate"), QMessageBox.ButtonRole.AcceptRole)
        reject = box.addButton(say("Estimate without it"), QMessageBox.ButtonRole.DestructiveRole)
        box.setDefaultButton(accept)
        box.exec()
        chosen = box.clickedButton()
        box.deleteLater()
        if chosen is accept:
            return "accept"
        return "reject" if chosen is reject else "cancel"

    def recover(self, name: str, when: str) -> bool:
        """Whether unsaved work that a crash left is wanted back."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC",
            say(f"{name} has work that was not saved when the program ended."),
            parent=self.parent,
        )  # fmt: skip
        box.setObjectName("recover_dialog")
        box.setInformativeText(
            say(f"It was written down last on {when}. One undo step takes it back again.")
        )
        back = box.addButton(say("Restore"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(say("Discard"), QMessageBox.ButtonRole.DestructiveRole)
        return self._asked(box, back)

    def files_now(self, name: str, missing: Sequence[Path], start: Path) -> Path | None:
        """Where the files of a project that was moved are now; None where it stays closed."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC",
            say(f"{name} cannot find {counted(len(missing), 'file')} it was made from."),
            QMessageBox.StandardButton.Cancel, self.parent,
        )  # fmt: skip
        box.setObjectName("files_dialog")
        shown = [str(path) for path in missing[:MOST_NAMED]]
        more = len(missing) - len(shown)
        box.setInformativeText(
            "\n".join([*shown, *([say(f"and {more} more")] if more else []), "",
                       say("Choose the folder that they are in now, or one above it.")])
        )  # fmt: skip
        choose = box.addButton(say("Choose the folder…"), QMessageBox.ButtonRole.AcceptRole)
        if not self._asked(box, choose):
            return None
        folder = QFileDialog.getExistingDirectory(
            self.parent, say("Folder with the files of the project"), str(start)
        )
        return Path(folder) if folder else None

    def open_elsewhere(self, name: str, where: str) -> bool:
        """Whether a project that another window has is to be opened all the same."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Warning, "LISPAC", say(f"{name} is open in another window already."),
            parent=self.parent,
        )  # fmt: skip
        box.setObjectName("elsewhere_dialog")
        box.setInformativeText(
            say(
                f"It is open in {where}. Of two windows the one that saves last overwrites "
                "the other, and unsaved work of the second is not kept against a crash."
            )
        )
        stay = box.addButton(say("Close it here"), QMessageBox.ButtonRole.RejectRole)
        open_it = box.addButton(say("Open it all the same"), QMessageBox.ButtonRole.DestructiveRole)
        box.setDefaultButton(stay)
        box.setEscapeButton(stay)
        return self._asked(box, open_it, default=stay)

    def overwrite(self, name: str) -> bool:
        """Whether a project that somebody else wrote meanwhile is to be overwritten."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Warning, "LISPAC",
            say(f"{name} was written by another program since it was opened here."),
            QMessageBox.StandardButton.Cancel, self.parent,
        )  # fmt: skip
        box.setObjectName("overwrite_dialog")
        box.setInformativeText(
            say("Saving overwrites that. File > Save as… keeps both, in another folder.")
        )
        anyway = box.addButton(say("Overwrite it"), QMessageBox.ButtonRole.DestructiveRole)
        return self._asked(box, anyway, default=box.button(QMessageBox.StandardButton.Cancel))

    @staticmethod
    def leave(dialog: QWidget) -> bool:
        """Whether a dialogue in which files were put is to be left without them."""
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC", say("Leave without these files?"), parent=dialog
        )
        box.setObjectName("leave_dialog")
        box.setInformativeText(
            say("What was set for them here is forgotten. The files themselves stay as they are.")
        )
        stay = box.addButton(say("Stay here"), QMessageBox.ButtonRole.RejectRole)
        leave = box.addButton(say("Leave"), QMessageBox.ButtonRole.DestructiveRole)
        box.setEscapeButton(stay)
        return Questions._asked(box, leave, default=stay)

    @staticmethod
    def _asked(box: QMessageBox, yes: QPushButton, default: QPushButton | None = None) -> bool:
        box.setDefaultButton(default or yes)
        box.exec()
        chosen = box.clickedButton() is yes
        box.deleteLater()
        return chosen

    def show_error(self, error: BaseException) -> None:
        """Say what went wrong; a second error while one is shown does not pile up."""
        LOG.error(describe(error)[0], exc_info=None if isinstance(error, LispacError) else error)
        if self._error_open:
            return
        self._error_open = True
        try:
            box = error_box(self.parent, error)
            box.exec()
            box.deleteLater()
        finally:
            self._error_open = False
