"""Area for dropped files, shown in the import dialogue until files are added."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QLabel, QVBoxLayout

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.language import N_, gettext

_FILE_KINDS = (
    (
        "ferry",
        N_("Trajectory"),
        N_("SBET, POF; POSPac, Exail (iXblue) or Inertial Explorer text; other text with columns"),
    ),
    (
        "chart-bell-curve",
        N_("Accuracies of the trajectory, if available"),
        N_("smrmsg file or its text export"),
    ),
    (
        "dots-hexagon",
        N_("One scan file for each line"),
        N_(
            "LAS, LAZ, E57, PLY, PCD, text or CIDCO file, in the scanner frame or georeferenced; "
            "Velodyne packets (PCAP)"
        ),
    ),
)
"""Icon, kind and formats of the files to add."""


class DropArea(QFrame):
    """Area for dropped files, with a list of the files to add."""

    files_requested = Signal()
    folder_requested = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("import_empty")
        self.setProperty("role", "drop")
        outer = QVBoxLayout(self)
        outer.setContentsMargins(24, 20, 24, 20)
        outer.addStretch(1)
        mark = QLabel()
        mark.setPixmap(theme.icon("tray-arrow-down", theme.ACCENT).pixmap(44, 44))
        outer.addWidget(mark, 0, Qt.AlignmentFlag.AlignHCenter)
        head = widgets.label(gettext("Drop the survey files or their folder here"), "heading")
        head.setStyleSheet("font-size: 17px;")
        outer.addWidget(head, 0, Qt.AlignmentFlag.AlignHCenter)
        outer.addSpacing(6)
        grid = QGridLayout()
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(8)
        for row, (icon, kind, formats) in enumerate(_FILE_KINDS):
            picture = QLabel()
            picture.setPixmap(theme.icon(icon, theme.MUTED).pixmap(20, 20))
            grid.addWidget(picture, row, 0)
            grid.addWidget(widgets.label(gettext(kind), "heading"), row, 1)
            grid.addWidget(widgets.label(gettext(formats), "muted"), row, 2)
        middle = QHBoxLayout()
        middle.addStretch(1)
        middle.addLayout(grid)
        middle.addStretch(1)
        outer.addLayout(middle)
        outer.addSpacing(12)
        row = QHBoxLayout()
        row.addStretch(1)
        self.files = widgets.button(
            gettext("Add files…"), "import_first_files", icon="file-plus-outline", primary=True
        )
        self.folder = widgets.button(
            gettext("Add folder…"), "import_first_folder", icon="folder-plus-outline"
        )
        for made, signal in (
            (self.files, self.files_requested),
            (self.folder, self.folder_requested),
        ):
            made.clicked.connect(signal)
            row.addWidget(made)
        row.addStretch(1)
        outer.addLayout(row)
        outer.addSpacing(8)
        outer.addWidget(
            widgets.label(
                gettext(
                    "The files are not changed. Their contents are shown before the project is "
                    "created."
                ),
                "muted",
            ),
            0,
            Qt.AlignmentFlag.AlignHCenter,
        )
        outer.addStretch(2)
