"""Quality light for each line of a target, with the reason in its tooltip."""

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme, units
from lispac.gui.features.pick_targets.sightings_table import quality_text
from lispac.language import Plural, gettext
from lispac.project import PickedSighting, Target
from lispac.targets.sighting_quality import SightingQuality

ICON_SIZE, ICON_GAP = 16, 14
"""Pixels: side of a light, and between one line and the next."""
PENDING_ICON = "circle-outline"
POINTS = Plural("{line}: {count:n} point, {rms} RMS", "{line}: {count:n} points, {rms} RMS")


class LineQualityIndicators(QWidget):
    """Lights and names of the lines, in as many columns as fit."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(4)
        self._grid.setVerticalSpacing(3)
        self._cells: dict[str, tuple[PickedSighting, QLabel, QLabel]] = {}
        self._columns = 0

    def show_target(self, target: Target) -> None:
        """List the lines on which the target was found; their quality is not known yet."""
        for _, light, name in self._cells.values():
            for each in (light, name):
                each.hide()
                each.deleteLater()
        self._cells = {}
        for sighting in target.sightings:
            light, name = QLabel(self), QLabel(sighting.line, self)
            name.setTextFormat(Qt.TextFormat.PlainText)
            light.setObjectName(f"light_{sighting.line}")
            light.setFixedSize(ICON_SIZE, ICON_SIZE)
            name.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
            self._cells[sighting.line] = sighting, light, name
        self.show_qualities({})
        self._columns = 0
        self._arrange()

    def show_qualities(self, qualities: Mapping[str, SightingQuality]) -> None:
        """Show the quality of the lines where it is known."""
        for line, (sighting, light, name) in self._cells.items():
            quality = qualities.get(line)
            icon = (
                theme.icon(PENDING_ICON, theme.MUTED)
                if quality is None
                else theme.quality_icon(quality.rating)
            )
            light.setPixmap(icon.pixmap(ICON_SIZE, ICON_SIZE))
            if quality is None:
                judgement = gettext("The quality is being computed")
            else:
                judgement = quality_text(quality)
            rms = units.local_amount(1000 * sighting.rms, "mm", ".1f")
            points = gettext(POINTS, line=line, count=len(sighting.indices), rms=rms)
            for each in (light, name):
                each.setToolTip(widgets.plain_tip(f"{points}\n{judgement}"))
                each.setAccessibleName(f"{line}. {judgement}")

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Arrange the names for the new width."""
        super().resizeEvent(event)
        self._arrange()

    def _arrange(self) -> None:
        """Arrange the lines in rows, each column as wide as the longest name."""
        if not self._cells:
            return
        widest = max(name.sizeHint().width() for _, _, name in self._cells.values())
        columns = max(1, (self.width() + ICON_GAP) // (ICON_SIZE + 4 + widest + ICON_GAP))
        columns = min(columns, len(self._cells))
        if columns == self._columns:
            return
        for k in range(2 * self._columns + 1):
            self._grid.setColumnStretch(k, 0)
            self._grid.setColumnMinimumWidth(k, 0)
        self._columns = columns
        left = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        for k, (_, light, name) in enumerate(self._cells.values()):
            row, column = divmod(k, columns)
            self._grid.addWidget(light, row, 2 * column, left)
            self._grid.addWidget(name, row, 2 * column + 1, left)
            self._grid.setColumnMinimumWidth(2 * column + 1, widest + ICON_GAP - 8)
        self._grid.setColumnStretch(2 * columns, 1)
