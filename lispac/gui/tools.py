"""The tools that look into the lines: made here, and joined to the window's parts."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QDockWidget, QWidget

from lispac.gui.measuring import Measuring
from lispac.gui.panels.section import TITLE as SECTION
from lispac.gui.pointing import Pointing
from lispac.gui.sections import Sections

if TYPE_CHECKING:
    from lispac.gui.main_window import MainWindow


class Tools(QObject):
    """Sections and measurements."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        view, actions, note = window.viewport, window.actions_, window.controller.noted.emit
        self.pointing = Pointing(view, actions)
        self.measuring = Measuring(view, actions, self.pointing, note)
        self.sections = Sections(
            window.document, window.runner, window.scene, view, actions, self.pointing, bring
        )
        window.scene.which_changed.connect(lambda _which: self.measuring.restart())
        window.document.opened.connect(self.pointing.end)

    def make_docks(self, beside: QDockWidget) -> dict[str, QDockWidget]:
        """Put the tools' panels into docks, as tabs beside another; by their titles."""
        window, sections = self._window, self.sections
        dock = window._dock(SECTION, sections.panel, Qt.DockWidgetArea.BottomDockWidgetArea)
        window.tabifyDockWidget(beside, dock)
        # A dock behind another counts as visible; only this signal tells.
        dock.visibilityChanged.connect(sections.be_seen)
        return {SECTION: dock}


def bring(panel: QWidget) -> None:
    """Show the dock of a panel in front of its neighbours."""
    dock = panel.parentWidget()
    assert isinstance(dock, QDockWidget)
    dock.show()
    dock.raise_()
