"""The dialogue before any file is in it: what to bring."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QLabel, QVBoxLayout

from lispac.gui import theme
from lispac.gui.panels import widgets

_WANTED = (
    ("ferry", "Trajectory", "SBET, POSPac or Exail (iXblue) text, or any text with columns"),
    ("chart-bell-curve", "Its accuracies, if there are any", "smrmsg, or a text export of them"),
    ("dots-hexagon", "A scan file for each line",
     "LAS, LAZ, E57, PLY, PCD, text or CIDCO; in the scanner's frame or on the map"),
)  # fmt: skip


class EmptyState(QFrame):
    """Where files are to be dropped, and which."""

    files_asked = Signal()
    folder_asked = Signal()

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
        head = widgets.label("Drop the survey's files or their folder here", "heading")
        head.setStyleSheet("font-size: 17px;")
        outer.addWidget(head, 0, Qt.AlignmentFlag.AlignHCenter)
        outer.addSpacing(6)
        grid = QGridLayout()
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(8)
        for row, (icon, what, how) in enumerate(_WANTED):
            picture = QLabel()
            picture.setPixmap(theme.icon(icon, theme.MUTED).pixmap(20, 20))
            grid.addWidget(picture, row, 0)
            grid.addWidget(widgets.label(what, "heading"), row, 1)
            grid.addWidget(widgets.label(how, "muted"), row, 2)
        middle = QHBoxLayout()
        middle.addStretch(1)
        middle.addLayout(grid)
        middle.addStretch(1)
        outer.addLayout(middle)
        outer.addSpacing(12)
        row = QHBoxLayout()
        row.addStretch(1)
        self.files = widgets.button(
            "Add files…", "import_first_files", icon="file-plus-outline", primary=True
        )
        self.folder = widgets.button(
            "Add folder…", "import_first_folder", icon="folder-plus-outline"
        )
        for made, signal in ((self.files, self.files_asked), (self.folder, self.folder_asked)):
            made.clicked.connect(signal)
            row.addWidget(made)
        row.addStretch(1)
        outer.addLayout(row)
        outer.addSpacing(8)
        outer.addWidget(
            widgets.label(
                "Nothing is copied or changed: each file is looked into, and you see what it is "
                "before the project is made.",
                "muted",
            ),
            0, Qt.AlignmentFlag.AlignHCenter,
        )  # fmt: skip
        outer.addStretch(2)
