"""Message box for errors."""

import traceback

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialogButtonBox, QMessageBox, QWidget

from lispac.errors import LispacError, system_reason
from lispac.gui import widgets
from lispac.gui.appearance.message_texts import message_text
from lispac.language import gettext, minus_signs
from lispac.messages import Message


def exception_text(error: LispacError) -> str:
    """Text of an error in the language of the user, with minus signs as in tables."""
    with minus_signs():
        return str(error)


def error_text_and_details(error: BaseException) -> tuple[str, str]:
    """Text of an error in the user's language, and the traceback if its cause is unexpected."""
    if isinstance(error, LispacError):
        cause = error.__cause__
        has_other_cause = cause is not None and not isinstance(cause, LispacError)
        details = "".join(traceback.format_exception(error)) if has_other_cause else ""
        return exception_text(error), details
    if isinstance(error, MemoryError):
        return gettext("Not enough memory. Close other programs or use fewer lines."), ""
    if isinstance(error, OSError) and error.strerror:
        found = system_reason(error)
        reason = message_text(found) if isinstance(found, Message) else found
        if not error.filename:
            return gettext("A file cannot be read or written: {reason}.", reason=reason), ""
        return gettext("{file}: {reason}.", file=error.filename, reason=reason), ""
    details = "".join(traceback.format_exception(error))
    return (
        gettext(
            "An unexpected error has stopped this step; the project is unchanged. Save the "
            "project and send the details to the developers of LISPAC."
        ),
        details,
    )


def error_box(parent: QWidget | None, error: BaseException) -> QMessageBox:
    """Create the message box for an error without showing it."""
    text, details = error_text_and_details(error)
    box = widgets.MessageBox(QMessageBox.Icon.Warning, "LISPAC", text, parent=parent)
    box.setObjectName("error_dialog")
    box.setStandardButtons(QMessageBox.StandardButton.Close)
    box.setDefaultButton(QMessageBox.StandardButton.Close)
    if details:
        box.setIcon(QMessageBox.Icon.Critical)
        box.setDetailedText(details)
        copy = box.addButton(gettext("Copy details"), QMessageBox.ButtonRole.ActionRole)
        copy.setObjectName("copy_details")
        # Any button closes a message box; disconnected, so that this one does not.
        copy.clicked.disconnect()
        copy.clicked.connect(lambda: QGuiApplication.clipboard().setText(details))
    buttons = box.findChild(QDialogButtonBox)
    if buttons is not None:
        buttons.setCenterButtons(False)
    return box
