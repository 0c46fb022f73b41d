"""The one dialogue for everything that went wrong."""

import traceback

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialogButtonBox, QMessageBox, QWidget

from lispac.errors import LispacError
from lispac.gui.language import say
from lispac.gui.panels import widgets


def describe(error: BaseException) -> tuple[str, str]:
    """A plain sentence, and details where it tells of what a library or the system has said."""
    if isinstance(error, LispacError):
        foreign = error.__cause__ is not None and not isinstance(error.__cause__, LispacError)
        return str(error), "".join(traceback.format_exception(error)) if foreign else ""
    if isinstance(error, MemoryError):
        return "There is not enough memory for this; close other programs or use fewer lines.", ""
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename or 'A file'}: {error.strerror}.", ""
    details = "".join(traceback.format_exception(error))
    return (
        "Something went wrong that the program did not foresee. Your project is as it was before "
        "this step; save it, and send the details to the program's maintainers.",
        details,
    )


def error_box(parent: QWidget | None, error: BaseException) -> QMessageBox:
    """The dialogue, not yet shown."""
    sentence, details = describe(error)
    box = widgets.MessageBox(QMessageBox.Icon.Warning, "LISPAC", say(sentence), parent=parent)
    box.setObjectName("error_dialog")
    box.setStandardButtons(QMessageBox.StandardButton.Close)
    box.setDefaultButton(QMessageBox.StandardButton.Close)
    if details:
        box.setIcon(QMessageBox.Icon.Critical)
        box.setDetailedText(details)
        copy = box.addButton(say("Copy details"), QMessageBox.ButtonRole.ActionRole)
        copy.setObjectName("copy_details")
        # A message box closes with any of its buttons; this one is to leave it open.
        copy.clicked.disconnect()
        copy.clicked.connect(lambda: QGuiApplication.clipboard().setText(details))
    buttons = box.findChild(QDialogButtonBox)
    if buttons is not None:
        buttons.setCenterButtons(False)
    return box
