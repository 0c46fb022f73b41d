"""What the program is, and how its numbers are meant."""

import platform

from PySide6.QtCore import Qt, qVersion
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QHBoxLayout, QMessageBox, QWidget

import lispac
from lispac.gui import theme
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.results import CONVENTION
from lispac.gui.viewing_actions import KEYS
from lispac.language import gettext


def about_box(parent: QWidget | None) -> QMessageBox:
    """The dialogue, not yet shown."""
    box = QMessageBox(parent)
    box.setObjectName("about_dialog")
    box.setWindowTitle(say("About LISPAC"))
    box.setTextFormat(Qt.TextFormat.RichText)
    box.setText(f"<h3>LISPAC {lispac.__version__}</h3>")
    box.setInformativeText(
        say(
            "<p>Boresight calibration of a LiDAR and an INS/GNSS on a vessel, with honest "
            f"uncertainties.</p><p>{CONVENTION}</p><p>Local coordinates are North, West, "
            "Up in metres."
            f"</p><p style='color:{theme.MUTED}'>Qt {qVersion()}, "
            f"Python {platform.python_version()}. "
            "BSD 3-clause licence.</p>"
        )
    )
    box.setStandardButtons(QMessageBox.StandardButton.Close)
    return box


def shortcuts_box(parent: QWidget | None) -> QDialog:
    """Mouse and keys in two columns, not yet shown; a message box would cut them off."""
    box = QDialog(parent)
    box.setObjectName("shortcuts_dialog")
    box.setWindowTitle(say("Mouse and keys"))
    layout = widgets.column(box, 16)
    columns = QHBoxLayout()
    columns.setSpacing(32)
    # The first two headings have about as many rows as the others together.
    for parts in (KEYS[:2], KEYS[2:]):
        column = widgets.label(rich=True)
        column.setText("".join(map(_keys, parts)))
        columns.addWidget(column, 0, Qt.AlignmentFlag.AlignTop)
    layout.addLayout(columns)
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    buttons.rejected.connect(box.reject)
    layout.addWidget(buttons)
    return box


def keys_said(keys: str) -> str:
    """Keys in the user's language; a letter is that on its key: W is not west."""
    return keys if len(keys) == 1 else gettext(keys)


def _keys(part: tuple[str, tuple[tuple[str, str], ...]]) -> str:
    rows = "".join(
        f"<tr><td style='white-space: nowrap'><b>{keys_said(keys)}</b>&nbsp;&nbsp;&nbsp;</td>"
        f"<td style='white-space: nowrap'>{gettext(what)}</td></tr>"
        for keys, what in part[1]
    )
    return f"<h4>{gettext(part[0])}</h4><table cellspacing='3'>{rows}</table>"
