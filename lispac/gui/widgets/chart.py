"""Matplotlib plot in the window; imported with the first plot, since this takes half a second."""

import threading
import time
from collections.abc import Callable

import numpy as np
from matplotlib.artist import Artist
from matplotlib.backend_bases import DrawEvent
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPixmap, QResizeEvent

from lispac.gui.appearance import theme
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.gui.widgets.ticks import localise_ticks

CALCULATION_SLICE_S = 0.03
"""Seconds after which a calculation pauses at the next possible point."""


class _CalculationAbandoned(BaseException):
    """Exception that ends an abandoned calculation."""


class SlicedCalculation:
    """Calculation that pauses after each slice until the caller continues it."""

    def __init__(self) -> None:
        self._may_continue, self._has_paused = threading.Semaphore(0), threading.Semaphore(0)
        self._thread: threading.Thread | None = None
        self._done = self._abandoned = False
        self._error: BaseException | None = None
        self._until = 0.0

    @property
    def is_running(self) -> bool:
        """Whether a calculation was begun and is not finished."""
        return self._thread is not None

    def begin(self, work: Callable[[], object]) -> None:
        """Set a calculation; it must call `pause` where it may pause, and `resume` starts it."""
        self.abandon()
        self._done = self._abandoned = False
        self._error = None

        def run() -> None:
            self._may_continue.acquire()
            self._until = time.perf_counter() + CALCULATION_SLICE_S
            try:
                if not self._abandoned:
                    work()
            except _CalculationAbandoned:
                pass
            except BaseException as error:
                self._error = error
            self._done = True
            self._has_paused.release()

        self._thread = threading.Thread(target=run, daemon=True, name="slices")
        self._thread.start()

    def resume(self) -> bool:
        """Calculate for one slice; return True if finished. Raises errors of the calculation."""
        if self._thread is None:
            return True
        self._may_continue.release()
        self._has_paused.acquire()
        if self._done:
            self._thread.join()
            self._thread = None
        if self._error is not None:
            raise self._error
        return self._done

    def pause(self) -> None:
        """Pause the calculation if its slice is over; called by the calculation."""
        if threading.current_thread() is not self._thread or time.perf_counter() < self._until:
            return
        self._has_paused.release()
        self._may_continue.acquire()
        if self._abandoned:
            raise _CalculationAbandoned
        self._until = time.perf_counter() + CALCULATION_SLICE_S

    def abandon(self) -> None:
        """Abandon the calculation."""
        self._abandoned = True
        self.resume()


LUMA_WEIGHTS = (77, 150, 29)
"""Weights of red, green and blue in the luma, in 1/256 (ITU-R BT.601)."""


def with_inverted_lightness(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Pixels of a picture with inverted lightness, in the colours of the scheme in use.

    Parameters
    ----------
    pixels : ndarray, shape (height, width, 4), 0 to 255
        Red, green, blue, alpha.
    """
    colours = pixels[..., :3].astype(np.int16)
    luma = (
        sum(colours[..., k].astype(np.int32) * share for k, share in enumerate(LUMA_WEIGHTS)) >> 8
    )
    colours += (255 - 2 * luma).astype(np.int16)[..., None]
    np.clip(colours, 0, 255, out=colours)
    result = pixels.copy()
    for k, (dark, light) in enumerate(zip(theme.rgb("paper"), theme.rgb("text"), strict=True)):
        result[..., k] = np.linspace(dark, light, 256).round().astype(np.uint8)[colours[..., k]]
    return result


DRAW_DELAY_MS = 20
"""Delay before drawing, so that other changes are painted first. A plot takes 0.2 to 0.5 s, half of
which is the layout of its texts; keys are handled between its parts."""


WHITE = "white"


class _Renderer(RendererAgg):
    """Agg renderer that can be interrupted during the layout of texts."""

    pause: Callable[[], None] | None = None

    def points_to_pixels(self, points: float) -> float:
        """Convert a length, and pause if it is time; Matplotlib calls this for every text."""
        if self.pause is not None:
            self.pause()
        pixels: float = super().points_to_pixels(points)
        return pixels


class Chart(FigureCanvasQTAgg):
    """Matplotlib canvas that is drawn when visible, once for all pending changes.

    In the dark theme, a plot with a white background is shown with inverted lightness, but copied
    with its original colours.
    """

    def __init__(self, width: int, height: int, ground: str = WHITE) -> None:
        """Set the minimum size in pixels and the background colour."""
        self._inverts_lightness = ground == WHITE and theme.current_scheme().is_dark
        self._drawing_task: IdleTask | None = None
        self._outdated = True
        self._layout = SlicedCalculation()
        """Layout of the texts, possibly in progress."""
        self._hurried = False
        """Whether the plot changed before the layout was complete."""
        self._remaining_artists: list[Artist] = []
        """Parts of an incomplete picture that are still to be drawn."""
        self._last_image: QImage | None = None
        """Last complete picture as shown; None if there is none."""
        self._drawn_with: tuple[float, float, float] | None = None
        super().__init__(Figure(layout="constrained", facecolor=ground))
        self.destroyed.connect(self._layout.abandon)
        self._drawing_task = IdleTask(self._begin_drawing, self, DRAW_DELAY_MS)
        self._next_step_task = IdleTask(self._continue_steps, self)
        self.setMinimumSize(width, height)

    def draw_idle(self) -> None:
        """Schedule a drawing for when Qt next paints the widget, hence not while it is hidden."""
        self._outdated = True
        self.update()

    def blank(self) -> None:
        """Show an empty picture until the next one is complete."""
        self._last_image = None
        self.draw_idle()

    def draw(self) -> None:
        """Draw immediately."""
        self._abandon_drawing()
        self._outdated = False
        localise_ticks(self.figure)
        super().draw()
        self._last_image = self._rendered_image(inverted=self._inverts_lightness)

    def get_renderer(self) -> _Renderer:
        """Renderer for the present size."""
        width, height = self.get_width_height(physical=True)
        key = width, height, self.figure.dpi
        if key != self._drawn_with:
            self._drawn_with = key
            self.renderer = _Renderer(*key)
            self.renderer.pause = self._layout.pause
        return self.renderer

    def _abandon_drawing(self) -> None:
        """Abandon an incomplete picture."""
        self._remaining_artists = []
        self._layout.abandon()

    def _begin_drawing(self) -> None:
        """Begin a picture with the layout of its texts, in several turns of the event loop."""
        if not self._outdated or self.width() <= 0 or self.height() <= 0:
            return
        self._abandon_drawing()
        self._outdated = False
        localise_ticks(self.figure)
        figure, layout = self.figure, self.figure.get_layout_engine()
        if not figure.axes:  # still empty
            self._begin_parts()
        elif self._hurried:  # else a changing plot would never be drawn
            layout.execute(figure)
            self._begin_parts()
        else:
            self._layout.begin(lambda: layout.execute(figure))
            self._continue_steps()

    def _begin_parts(self) -> None:
        self._hurried = False
        self.get_renderer().clear()
        self.figure.patch.draw(self.renderer)
        self._remaining_artists = self._artists()
        if self._remaining_artists:
            self._next_step_task.start()
        else:
            self._show_finished()

    def _artists(self) -> list[Artist]:
        """Artists in front of the background, in drawing order."""
        parts = [each for each in self.figure.get_children() if each is not self.figure.patch]
        return sorted(parts, key=lambda each: each.get_zorder())

    def _continue_steps(self) -> None:
        """Continue the layout or draw the next part.

        A change during the layout starts it again; a later change is drawn after this picture.
        """
        if self._layout.is_running:
            if self._outdated:
                self._abandon_drawing()
                self._hurried = True
                self.update()
            elif self._layout.resume():
                self._begin_parts()
            else:
                self._next_step_task.start()
            return
        if not self._remaining_artists:  # abandoned since the size has changed
            return
        if self._remaining_artists[0] not in self.figure.get_children():  # the figure was cleared
            self._remaining_artists, self._outdated = [], True
        else:
            self._remaining_artists.pop(0).draw(self.renderer)
            if self._remaining_artists:
                self._next_step_task.start()
                return
            self._show_finished()
        self.update()

    def _show_finished(self) -> None:
        """Show the complete picture."""
        self._last_image = self._rendered_image(inverted=self._inverts_lightness)
        self.callbacks.process("draw_event", DrawEvent("draw_event", self, self.renderer))
        self.update()

    @property
    def is_drawing(self) -> bool:
        """Whether a picture was started and is not complete."""
        return self._layout.is_running or bool(self._remaining_artists)

    def _rendered_image(self, *, inverted: bool = False) -> QImage:
        pixels = np.asarray(self.buffer_rgba())
        if inverted:
            pixels = with_inverted_lightness(pixels)
        height, width, _ = pixels.shape
        image = QImage(pixels.data, width, height, QImage.Format.Format_RGBA8888).copy()
        image.setDevicePixelRatio(self.devicePixelRatioF())
        return image

    def shown_colour(self, colour: str) -> str:
        """Name of the colour in which the plot shows a colour of its figure."""
        pixel = np.array(QColor(colour).getRgb(), dtype=np.uint8)
        if self._inverts_lightness:
            pixel = with_inverted_lightness(pixel)
        return QColor(*pixel.tolist()).name()

    def picture(self) -> QPixmap:
        """Up-to-date picture with the original colours."""
        if (self._outdated or self.is_drawing) and self.width() > 0 and self.height() > 0:
            self.draw()
        return QPixmap.fromImage(self._rendered_image()) if self._inverts_lightness else self.grab()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Draw again in the new size."""
        self._abandon_drawing()
        super().resizeEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the picture, or the last one until a new one is complete."""
        drawn = not self._outdated and not self.is_drawing
        if drawn and not self._inverts_lightness:
            super().paintEvent(event)
            return
        begins = not drawn and not self.is_drawing
        if begins and self._drawing_task is not None and not self._drawing_task.isActive():
            self._drawing_task.start()
        painter = QPainter(self)
        ground = QColor.fromRgbF(*self.figure.get_facecolor())
        painter.fillRect(self.rect(), theme.colour("paper") if self._inverts_lightness else ground)
        if self._last_image is not None:
            painter.drawImage(0, 0, self._last_image)
        painter.end()
