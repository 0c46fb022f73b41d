"""A plot in the window. Imported where the first one is made: Matplotlib takes half a second."""

from matplotlib.artist import Artist
from matplotlib.backend_bases import DrawEvent
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPixmap, QResizeEvent

from lispac.gui.panels.ticks import spoken_ticks
from lispac.gui.turns import Turn

AFTER_MS = 20
"""A plot takes 0.2 s, half of it to find room for all texts. What else changes with it is painted
before, and keys are heard between its parts."""


class Chart(FigureCanvasQTAgg):
    """Matplotlib's canvas, drawn when it is seen and once for all that changed in it meanwhile."""

    def __init__(self, width: int, height: int, ground: str = "white") -> None:
        """Make one that is at least so many pixels large, on a ground of this colour."""
        self._due: Turn | None = None
        self._stale = True
        self._left: list[Artist] = []
        """What is still to be drawn of a picture that was begun."""
        self._last: QImage | None = None
        """What was drawn last as a whole, of the size it had then."""
        super().__init__(Figure(layout="constrained", facecolor=ground))
        self._due = Turn(self._begin, self, AFTER_MS)
        self._next = Turn(self._go_on, self)
        self.setMinimumSize(width, height)

    def draw_idle(self) -> None:
        """Draw soon after Qt wants to paint it: never while it lies behind another."""
        self._stale = True
        self.update()

    def draw(self) -> None:
        """Draw now."""
        self._stale, self._left = False, []
        spoken_ticks(self.figure)
        super().draw()
        self._last = self._drawn()

    def _begin(self) -> None:
        """Find room for all texts, in a turn of its own; each plot has one, too."""
        if not self._stale or self.width() <= 0 or self.height() <= 0:
            return
        self._stale = False
        spoken_ticks(self.figure)
        self.figure.get_layout_engine().execute(self.figure)
        self.renderer = self.get_renderer()
        self.renderer.clear()
        self.figure.patch.draw(self.renderer)
        self._left = self._parts()
        self._next.start()

    def _parts(self) -> list[Artist]:
        """All that is drawn on the ground, in the order in which it is."""
        parts = [each for each in self.figure.get_children() if each is not self.figure.patch]
        return sorted(parts, key=lambda each: each.get_zorder())

    def _go_on(self) -> None:
        """Draw one more part; what was changed meanwhile is drawn once this picture is there."""
        if not self._left:  # begun again, in another size
            return
        if self._left[0] not in self.figure.get_children():  # taken away with the rest
            self._left, self._stale = [], True
        else:
            self._left.pop(0).draw(self.renderer)
            if self._left:
                self._next.start()
                return
            self._last = self._drawn()
            self.callbacks.process("draw_event", DrawEvent("draw_event", self, self.renderer))
        self.update()

    def _drawn(self) -> QImage:
        pixels = self.buffer_rgba()
        height, width, _ = pixels.shape
        image = QImage(pixels, width, height, QImage.Format.Format_RGBA8888).copy()
        image.setDevicePixelRatio(self.devicePixelRatioF())
        return image

    def picture(self) -> QPixmap:
        """Return what is or will be shown."""
        if (self._stale or self._left) and self.width() > 0 and self.height() > 0:
            self.draw()
        return self.grab()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Begin again what was begun in another size."""
        self._left = []
        super().resizeEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint what is drawn; until the new is, what was drawn last."""
        if not self._stale and not self._left:
            super().paintEvent(event)
            return
        if self._due is not None and not self._left and not self._due.isActive():
            self._due.start()
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor.fromRgbF(*self.figure.get_facecolor()))
        if self._last is not None:
            painter.drawImage(0, 0, self._last)
        painter.end()
