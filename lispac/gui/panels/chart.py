"""A plot in the window. Imported where the first one is made: Matplotlib takes half a second."""

from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPixmap

from lispac.gui.panels.ticks import spoken_ticks
from lispac.gui.turns import Turn

AFTER_MS = 20
"""A plot takes 0.2 s, half of it to find room for all texts. What else changes with it is painted
before, and keys are heard between."""


class Chart(FigureCanvasQTAgg):
    """Matplotlib's canvas, drawn when it is seen and once for all that changed in it meanwhile."""

    def __init__(self, width: int, height: int, ground: str = "white") -> None:
        """Make one that is at least so many pixels large, on a ground of this colour."""
        self._due: Turn | None = None
        self._stale = True
        super().__init__(Figure(layout="constrained", facecolor=ground))
        self._due = Turn(self._arrange, self, AFTER_MS)
        self._arranged = Turn(self._draw_arranged, self)
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

    def _arrange(self) -> None:
        """Find room for all texts, in a turn of its own."""
        if self._stale and self.width() > 0 and self.height() > 0:
            engine = self.figure.get_layout_engine()
            spoken_ticks(self.figure)
            engine.execute(self.figure)
            self._arranged.start()

    def _draw_arranged(self) -> None:
        """Draw with the room that was found."""
        if not self._stale:
            return
        engine = self.figure.get_layout_engine()
        self.figure.set_layout_engine("none")
        try:
            self.draw()
        finally:
            self.figure.set_layout_engine(engine)

    def picture(self) -> QPixmap:
        """Return what is or will be shown."""
        self._draw_due()
        return self.grab()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint what is drawn; until the new is, what was drawn last."""
        if not self._stale:
            super().paintEvent(event)
            return
        if self._due is not None and not self._due.isActive():
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
