"""Dialogues about the program and about its mouse and keyboard commands."""

import platform

from PySide6.QtCore import Qt, qVersion
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QHBoxLayout, QMessageBox, QWidget

import lispac
from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.view_actions import KEYS
from lispac.gui.appearance import theme
from lispac.gui.widgets.mounting_texts import convention_html
from lispac.language import gettext


def about_box(parent: QWidget | None) -> QMessageBox:
    """Message box with version, conventions and licence, not yet shown."""
    box = QMessageBox(parent)
    box.setObjectName("about_dialog")
    box.setWindowTitle(dialog_title("about"))
    box.setTextFormat(Qt.TextFormat.RichText)
    box.setText(f"<h3>LISPAC {lispac.__version__}</h3>")
    purpose = gettext(
        "LISPAC calibrates the boresight of a vessel-mounted LiDAR with respect to the INS/GNSS "
        "and estimates the uncertainty of the angles."
    )
    frame = gettext("Local coordinates are North, West and Up in metres.")
    licence = gettext("Licence: BSD 3-clause.")
    versions = f"Qt {qVersion()}, Python {platform.python_version()}. {licence}"
    box.setInformativeText(
        f"<p>{purpose}</p><p>{convention_html()}</p><p>{frame}</p>"
        f"<p style='color:{theme.MUTED}'>{versions}</p>"
    )
    box.setStandardButtons(QMessageBox.StandardButton.Close)
    return box


def shortcuts_box(parent: QWidget | None) -> QDialog:
    """Dialogue with the mouse and keyboard commands in two columns, not yet shown."""
    box = QDialog(parent)
    box.setObjectName("shortcuts_dialog")
    box.setWindowTitle(dialog_title("keys"))
    layout = widgets.vertical_layout(box, 16)
    columns = QHBoxLayout()
    columns.setSpacing(32)
    # The first two headings have about as many rows as the others together.
    for parts in (KEYS[:2], KEYS[2:]):
        column = widgets.label(rich=True)
        column.setText("".join(map(_commands_html, parts)))
        columns.addWidget(column, 0, Qt.AlignmentFlag.AlignTop)
    layout.addLayout(columns)
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    buttons.rejected.connect(box.reject)
    layout.addWidget(buttons)
    return box


def keys_text(keys: str) -> str:
    """Text of a key in the user's language; single letters are not translated."""
    return keys if len(keys) == 1 else gettext(keys)


def _commands_html(part: tuple[str, tuple[tuple[str, str], ...]]) -> str:
    rows = "".join(
        f"<tr><td style='white-space: nowrap'><b>{keys_text(keys)}</b>&nbsp;&nbsp;&nbsp;</td>"
        f"<td style='white-space: nowrap'>{gettext(what)}</td></tr>"
        for keys, what in part[1]
    )
    return f"<h4>{gettext(part[0])}</h4><table cellspacing='3'>{rows}</table>"
