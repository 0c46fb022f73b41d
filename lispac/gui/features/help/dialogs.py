"""Dialogues about the program and about its mouse and keyboard commands."""

import platform
from collections.abc import Sequence

from PySide6.QtCore import Qt, qVersion
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QHBoxLayout, QLabel, QMessageBox, QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.appearance import theme
from lispac.gui.features.help.actions import ACTIONS
from lispac.gui.widgets.mounting_texts import convention_html
from lispac.language import N_, gettext
from lispac.version import __version__

KEYS = (
    (N_("View"), (
        (N_("Drag, arrows"), N_("rotate about the point under the mouse or the centre")),
        (N_("Shift + drag, Shift + arrows"),
         N_("pan the view; or drag with the middle or right button")),
        (N_("Wheel, Page up and down"), N_("zoom in and out")),
        (N_("Double click"), N_("centre the view on the point")),
        (N_("F, Shift + F"), N_("zoom to all points, zoom to the selected target")),
        (N_("Double click in a table"), N_("zoom to the target or sighting")),
        ("1, 2, 3, 4, 5, 6", N_("isometric view, from the top, front, left, back, right")),
        ("7", N_("view along the normal of the selected target")),
        ("O", N_("switch between orthographic and perspective view")),
        ("+, −", N_("larger, smaller points")),
        ("C", N_("colour by line, height, intensity, range, time, residual")),
        ("B", N_("switch between before and after")),
        ("W", N_("split view before and after; Ctrl + arrows move the divider")),
        (N_("Alt + 1, 2, 4"), N_("one view, two or four linked views")),
        (N_("Alt + Left, Right"), N_("previous, next view; or the side buttons of the mouse")),
        (N_("Ctrl + C"), N_("copy the values of the point under the mouse")),
        (N_("Right click"), N_("menu to copy the point or the picture")),
        ("F11", N_("maximise the view and hide all panels, or restore them")),
        (N_("P, Shift + P"), N_("save the picture of the view, copy it")),
    )),
    (N_("Designing a survey (Ctrl + Shift + D)"), (
        (N_("Drag a line or its arrow"),
         N_("move or turn the line; with Shift continuously")),
        (N_("Drag a target"),
         N_("move the target along the wall and in height")),
        (N_("Page up and down"), N_("select a line or target")),
        (N_("Arrows, Shift + arrows"), N_("move or turn the selection in small steps")),
        (N_("Insert, Delete"), N_("add or remove a line or target")),
        (N_("Ctrl + D, Alt + Up, Down"), N_("duplicate the line, move it up or down in the "
                                            "order")),
        (N_("Ctrl + L, Ctrl + B"), N_("add a line, a board")),
        (N_("Ctrl + Shift + B"), N_("add a sphere")),
        ("F9", N_("compare scenarios")),
        ("F10", N_("simulate surveys to check the standard deviations")),
        ("F11", N_("compare the survey design with the open project")),
    )),
    (N_("Inspection"), (
        (N_("S, Shift + S"), N_("cut a section across the selected target, between two points")),
        (N_("Alt + Up, Down"), N_("move the section by its thickness; or drag its dots")),
        (N_("Ctrl + P, Ctrl + Shift + P"), N_("save the picture of the section, copy it")),
        (N_("M, Shift + M"), N_("measure a distance, an angle")),
        ("X", N_("show or remove the clip box around the selected target")),
        ("H", N_("outline the plane that a Ctrl+click would pick")),
        (N_("Ctrl + T, Ctrl + Shift + T"), N_("show the patch test, add a box around an object")),
        (N_("Esc"), N_("end the measurement, the section, the lasso or the linked views")),
    )),
    (N_("Targets"), (
        (N_("Ctrl + click"), N_("pick a target")),
        (N_("F3, Shift + F3"), N_("enter the coordinates of a seed, read a list of seeds")),
        (N_("Enter, Esc"), N_("accept or reject the detected target")),
        (N_("F5, Shift + F5"), N_("propose targets, search for the selected target again")),
        ("F6, F7", N_("next Ctrl + click picks a target, a validation plane")),
        ("F8", N_("turn the target into a validation plane, or the reverse")),
        (N_("L, Shift + L"), N_("lasso: add points to the selected target, remove points")),
    )),
    (N_("Project"), (
        (N_("Ctrl + 1, 2, 3, 4, 5"), N_("go to a step of the workflow")),
        ("F9, F10", N_("estimate the boresight, validate")),
        (N_("Shift + F9"), N_("run the point spacing study")),
        (N_("Shift + F10, Ctrl + F11"), N_("check against a reference, compare calibrations")),
        ("F12", N_("show the messages")),
        (N_("Ctrl + D"), N_("show the diagnostics of the adjustment")),
        (N_("Ctrl + ."), N_("cancel the running task")),
        (N_("Ctrl + E, Ctrl + Shift + E"), N_("export the report, the georeferenced lines")),
        (N_("Ctrl + Z, Ctrl + Y"), N_("undo, redo")),
        (N_("Ctrl + N, Ctrl + O, Ctrl + S"), N_("new project, open, save")),
    )),
)  # fmt: skip
"""Headings of the list of keys, and the rows below each."""
COLUMNS = ((0, 2), (3, 4, 1))
"""Indices in `KEYS` of the headings in each column, which are about equally high."""
SCREEN_MARGIN_PX = 80
"""Width of the screen that the columns of keys do not use, pixels."""


def about_box(parent: QWidget | None) -> QMessageBox:
    """Create the message box with version, conventions and licence, without showing it."""
    box = QMessageBox(parent)
    box.setObjectName("about_dialog")
    box.setWindowTitle(dialog_title(ACTIONS["about"]))
    box.setTextFormat(Qt.TextFormat.RichText)
    box.setText(f"<h3>LISPAC {__version__}</h3>")
    purpose = gettext(
        "LISPAC calibrates the boresight of a vessel-mounted LiDAR with respect to the INS/GNSS "
        "and estimates the uncertainty of the angles."
    )
    frame = gettext(
        "The window and the report show positions as east, north and up from the origin of the "
        "local frame. In files and scripts, local coordinates are north, west and up in metres."
    )
    licence = gettext("Licence: BSD 3-clause.")
    versions = f"Qt {qVersion()}, Python {platform.python_version()}. {licence}"
    box.setInformativeText(
        f"<p>{purpose}</p><p>{convention_html()}</p><p>{frame}</p>"
        f"<p style='color:{theme.MUTED}'>{versions}</p>"
    )
    box.setStandardButtons(QMessageBox.StandardButton.Close)
    return box


def shortcuts_box(parent: QWidget | None) -> QDialog:
    """Create the dialogue with mouse and keyboard commands in two columns, without showing it."""
    box = QDialog(parent)
    box.setObjectName("shortcuts_dialog")
    box.setWindowTitle(dialog_title(ACTIONS["keys"]))
    layout = widgets.vertical_layout(box, 16)
    columns = QHBoxLayout()
    columns.setSpacing(24)
    labels = [widgets.label(rich=True) for _ in COLUMNS]
    for column, parts in zip(labels, COLUMNS, strict=True):
        column.setText("".join(_commands_html(KEYS[k]) for k in parts))
        columns.addWidget(column, 0, Qt.AlignmentFlag.AlignTop)
    _wrap_to_screen(labels, box.screen().availableGeometry().width() - SCREEN_MARGIN_PX)
    layout.addLayout(columns)
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    buttons.rejected.connect(box.reject)
    layout.addWidget(buttons)
    return box


def _wrap_to_screen(columns: Sequence[QLabel], available: int) -> None:
    """Wrap the texts of columns that together are wider than the screen."""
    widths = [column.sizeHint().width() for column in columns]
    for column, width in zip(columns, widths, strict=True):
        if sum(widths) > available:
            narrowed = width * available // sum(widths)
            column.setWordWrap(True)
            column.setFixedWidth(narrowed)
            column.setMinimumHeight(column.heightForWidth(narrowed))


def keys_text(keys: str) -> str:
    """Text of a key in the user's language; single letters are not translated."""
    return keys if len(keys) == 1 else gettext(keys)


def _commands_html(part: tuple[str, tuple[tuple[str, str], ...]]) -> str:
    rows = "".join(
        f"<tr><td style='white-space: nowrap'><b>{keys_text(keys)}</b>&nbsp;&nbsp;&nbsp;</td>"
        f"<td>{gettext(what)}</td></tr>"
        for keys, what in part[1]
    )
    return f"<h4>{gettext(part[0])}</h4><table cellspacing='3'>{rows}</table>"


class HelpDialogs(Questions):
    """Dialogues about the program."""

    def about(self) -> None:
        """Show version, conventions and licence of the program."""
        run_dialog(about_box(self.parent))

    def shortcuts(self) -> None:
        """Show the mouse and keyboard commands."""
        run_dialog(shortcuts_box(self.parent))
