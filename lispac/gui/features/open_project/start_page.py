"""Start page, shown while no project is open: recent projects and links to begin."""

from collections.abc import Iterable
from pathlib import Path

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QCommandLinkButton,
    QFrame,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.app.language import local_datetime
from lispac.gui.appearance import theme
from lispac.gui.widgets.tab_order import set_tab_order
from lispac.io.project.project_file import PROJECT_FILE_NAME, UNSAVED_NAME
from lispac.language import N_, gettext

LINKS = (
    ("tour", "compass-outline", N_("Three-minute tour"),
     N_("Calibrate the demo survey step by step")),
    ("new", "folder-plus-outline", N_("New project…"), N_("Import a trajectory and lines")),
    ("open", "folder-open-outline", N_("Open project…"),
     N_("Choose the file project.json of a project")),
    ("demo", "ferry", N_("Demo survey"), N_("A quay with two boards, surveyed in six lines")),
    ("design", "vector-square", N_("Design a survey…"),
     N_("Plan boards and lines before the survey")),
)  # fmt: skip
"""Name of the action, icon, title and description of each link."""
SHORT_LINK_HEIGHT_PX = 36
"""Height of a link without its description, pixels."""
QWIDGETSIZE_MAX = (1 << 24) - 1
"""Largest height of a widget, pixels: a macro of Qt that PySide6 lacks."""


class StartPage(QScrollArea):
    """Page with recent projects and links to begin."""

    link_clicked = Signal(str)
    """Name of the link that was clicked."""
    project_chosen = Signal(object)
    """Folder of a recent project."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("start_page")
        self.setAccessibleName(gettext("Start page"))
        # Else it would have the initial focus invisibly; keys scroll it from the links as well
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        body = QWidget()
        self._outer = outer = QVBoxLayout(body)
        title = widgets.label(gettext("Boresight calibration"), "heading")
        title.setStyleSheet("font-size: 22px;")
        outer.addWidget(title)
        self._advice = widgets.label("", "muted", wrap=True, name="start_advice")
        outer.addWidget(self._advice)
        self.show_task("")
        outer.addSpacing(14)
        sides = QHBoxLayout()
        sides.setSpacing(36)
        self._begin, self._recent = QVBoxLayout(), QVBoxLayout()
        for side, head in (
            (self._begin, gettext("Get started")),
            (self._recent, gettext("Recent projects")),
        ):
            side.setSpacing(4)
            side.addWidget(widgets.label(head, "heading"))
            sides.addLayout(side, 1)
        self.links = {
            name: _link_button(icon, gettext(title), gettext(description))
            for name, icon, title, description in LINKS
        }
        for name, link in self.links.items():
            link.setObjectName(f"start_{name}")
            link.clicked.connect(lambda _=False, name=name: self.link_clicked.emit(name))
            self._begin.addWidget(link)
        self._begin.addStretch(1)
        self._projects: list[QWidget] = []
        self._reason = ""
        """Reason why no project can be opened; empty if one can."""
        self._recent.addStretch(1)
        outer.addLayout(sides)
        outer.addStretch(1)
        self.setWidget(body)

    def show_task(self, title: str) -> None:
        """Show the running task, after which a project is open; empty for none."""
        if title:
            text = gettext("{task} …", task=title)
        else:
            text = gettext(
                "Drop lines and a trajectory anywhere on this window, or choose an action."
            )
        self._advice.setText(text)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Show descriptions as tooltips in a low window, so that all links stay visible."""
        super().resizeEvent(event)
        self._show_descriptions(True)
        place = self._begin.geometry()
        lowest = place.top() + self._begin.heightForWidth(place.width())
        if lowest > self.viewport().height():
            self._show_descriptions(False)

    def _show_descriptions(self, whole: bool) -> None:
        """Show the descriptions below the titles, or as tooltips."""
        self._outer.setContentsMargins(40, 28 if whole else 12, 40, 28)
        for name, _, _, description in LINKS:
            link, text = self.links[name], gettext(description)
            link.setDescription(text if whole else "")
            link.setMaximumHeight(QWIDGETSIZE_MAX if whole else SHORT_LINK_HEIGHT_PX)
            link.updateGeometry()
        self._show_tips()
        self._begin.setSpacing(4 if whole else 2)
        self._outer.activate()

    def set_reason(self, reason: str) -> None:
        """Disable all links that open a project, with the reason in their tips."""
        self._reason = reason
        for name, link in self.links.items():
            if name != "design":
                link.setEnabled(not reason)
        for each in self._projects:
            if isinstance(each, QCommandLinkButton):
                each.setEnabled(not reason and _has_project(Path(each.property("folder"))))
        self._show_tips()

    def _show_tips(self) -> None:
        for name, _, _, description in LINKS:
            link = self.links[name]
            short = "" if link.description() else gettext(description)
            reason = "" if link.isEnabled() else self._reason
            link.setToolTip("\n".join(text for text in (short, reason) if text))
        for each in self._projects:
            if isinstance(each, QCommandLinkButton):
                texts = (each.property("folder"), self._reason)
                each.setToolTip(widgets.plain_tip("\n".join(text for text in texts if text)))

    def show_recent(self, folders: Iterable[Path]) -> None:
        """List projects, the one opened last first."""
        for old in self._projects:
            old.hide()  # else it is visible until it is deleted
            self._recent.removeWidget(old)
            old.deleteLater()
        self._projects = [self._project_button(folder) for folder in folders] or [
            _no_projects_label()
        ]
        for k, each in enumerate(self._projects):
            self._recent.insertWidget(k + 1, each)
        set_tab_order(self.links[LINKS[-1][0]], self._projects)
        self.set_reason(self._reason)

    def _project_button(self, folder: Path) -> QCommandLinkButton:
        made = _link_button("folder-outline", folder.name, _project_state_text(folder))
        made.setObjectName("start_recent")
        made.setProperty("folder", str(folder))
        made.clicked.connect(lambda: self.project_chosen.emit(folder))
        return made


def _link_button(icon: str, title: str, description: str) -> QCommandLinkButton:
    made = QCommandLinkButton(title, description)
    made.setIcon(theme.icon(icon, theme.ACCENT))
    made.setIconSize(QSize(24, 24))
    made.setCursor(Qt.CursorShape.PointingHandCursor)
    return made


def _has_project(folder: Path) -> bool:
    return (folder / PROJECT_FILE_NAME).is_file()


def _project_state_text(folder: Path) -> str:
    """Text with the time of the last save of a project, and its folder."""
    try:
        saved = local_datetime((folder / PROJECT_FILE_NAME).stat().st_mtime)
    except OSError:
        return gettext("Not found: {folder}", folder=folder)
    if (folder / UNSAVED_NAME).is_file():
        return gettext(
            "Saved {time}, with unsaved changes, in {folder}", time=saved, folder=folder.parent
        )
    return gettext("Saved {time} in {folder}", time=saved, folder=folder.parent)


def _no_projects_label() -> QLabel:
    return widgets.label(
        gettext("Projects appear here after you have opened them."), "muted", wrap=True
    )
