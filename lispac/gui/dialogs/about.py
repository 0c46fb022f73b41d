"""What the program is, and how its numbers are meant."""

import platform

from PySide6.QtCore import qVersion
from PySide6.QtWidgets import QMessageBox, QWidget

import lispac
from lispac.gui.panels.results import CONVENTION
from lispac.gui.viewing_actions import KEYS


def about_box(parent: QWidget | None) -> QMessageBox:
    """The dialogue, not yet shown."""
    box = QMessageBox(parent)
    box.setObjectName("about_dialog")
    box.setWindowTitle("About LISPAC")
    box.setText(f"<h3>LISPAC {lispac.__version__}</h3>")
    box.setInformativeText(
        "<p>Boresight calibration of a LiDAR and an INS/GNSS on a vessel, with honest "
        f"uncertainties.</p><p>{CONVENTION}</p><p>Local coordinates are North, West, Up in metres."
        f"</p><p style='color:#586573'>Qt {qVersion()}, Python {platform.python_version()}. "
        "BSD 3-clause licence.</p>"
    )
    box.setStandardButtons(QMessageBox.StandardButton.Close)
    return box


def shortcuts_box(parent: QWidget | None) -> QMessageBox:
    """Mouse and keys, not yet shown."""
    rows = (
        ("Ctrl + click", "set a seed on a target"),
        ("Enter, Esc", "accept or reject the plane just found"),
        ("F6, F7", "next seed is an adjustment target, a validation plane"),
        ("F9, F10", "estimate, validate"),
        ("B", "switch the view between before and after"),
        *KEYS,
        ("Ctrl + E, Ctrl + Shift + E", "export the report, the georeferenced lines"),
        ("Ctrl + Z, Ctrl + Y", "undo, redo"),
    )
    table = "".join(f"<tr><td><b>{a}</b>&nbsp;&nbsp;</td><td>{b}</td></tr>" for a, b in rows)
    box = QMessageBox(parent)
    box.setObjectName("shortcuts_dialog")
    box.setWindowTitle("Mouse and keys")
    box.setText(f"<table cellspacing='6'>{table}</table>")
    box.setStandardButtons(QMessageBox.StandardButton.Close)
    return box
