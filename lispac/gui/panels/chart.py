"""A plot in the window. Imported where the first one is made: Matplotlib takes half a second."""

from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from PySide6.QtCore import QTimer
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPixmap

from lispac.gui.panels.ticks import spoken_ticks

AFTER_MS = 20
"""A plot takes 0.1 s. What else changes with it is painted before, and keys are heard between."""


class Chart(FigureCanvasQTAgg):
    """Matplotlib's canvas, drawn when it is seen and once for all that changed in it meanwhile."""

    def __init__(self, width: int, height: int, ground: str = "white") -> None:
        """Make one that is at least so many pixels large, on a ground of this colour."""
        self._due = QTimer(singleShot=True, interval=AFTER_MS)
        self._stale = True
        super().__init__(Figure(layout="constrained", facecolor=ground))
        self._due.setParent(self)
        self._due.timeout.connect(self._draw_due)
        self.setMinimumSize(width, height)

    def draw_idle(self) -> None:
        """Draw soon after Qt wants to paint it: never while it lies behind another."""
        self._stale = True
        self.update()

    def draw(self) -> None:
        """Draw now."""
        self._stale = False
        spoken_ticks(self.figure)
        super().draw()

    def picture(self) -> QPixmap:
        """Return what is or will be shown."""
        self._draw_due()
        return self.grab()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint what is drawn; until the new is, what was drawn last."""
        if not self._stale:
            super().paintEvent(event)
            return
        if not self._due.isActive():
            self._due.start()
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor.fromRgbF(*self.figure.get_facecolor()))
        if hasattr(self, "renderer"):  # what was drawn last, of the size it had then
            pixels = self.buffer_rgba()
            height, width, _ = pixels.shape
            image = QImage(pixels, width, height, QImage.Format.Format_RGBA8888)
            image.setDevicePixelRatio(self.devicePixelRatioF())
            painter.drawImage(0, 0, image)
        painter.end()

    def _draw_due(self) -> None:
        if self._stale and self.width() > 0 and self.height() > 0:
            self.draw()
