"""A plot under the mouse: the wheel zooms, a drag moves, a double click shows all of it again."""

from matplotlib.axes import Axes
from matplotlib.backend_bases import FigureCanvasBase, MouseEvent

STEP = 0.8
"""Width left after one notch of the wheel."""


class Zooming:
    """Joined to a canvas whose axes share their limits."""

    def __init__(self, canvas: FigureCanvasBase) -> None:
        self._canvas = canvas
        self._whole: tuple[tuple[float, float], tuple[float, float]] | None = None
        self._moved: Axes | None = None
        canvas.mpl_connect("scroll_event", self._zoom)
        canvas.mpl_connect("button_press_event", self._press)
        canvas.mpl_connect("motion_notify_event", self._move)
        canvas.mpl_connect("button_release_event", self._release)

    def keep(self) -> None:
        """Take the present limits for all of it."""
        axes = self._canvas.figure.axes
        self._moved = None
        self._whole = (axes[0].get_xlim(), axes[0].get_ylim()) if axes else None

    def _zoom(self, event: MouseEvent) -> None:
        if event.inaxes is None or event.xdata is None or event.ydata is None:
            return
        factor = STEP**event.step
        axes = event.inaxes
        axes.set_xlim(*(event.xdata + factor * (x - event.xdata) for x in axes.get_xlim()))
        axes.set_ylim(*(event.ydata + factor * (y - event.ydata) for y in axes.get_ylim()))
        self._canvas.draw_idle()

    def _press(self, event: MouseEvent) -> None:
        if event.inaxes is None or event.button != 1:
            return
        if event.dblclick:
            if self._whole is not None:
                event.inaxes.set_xlim(*self._whole[0])
                event.inaxes.set_ylim(*self._whole[1])
                self._canvas.draw_idle()
            return
        self._moved = event.inaxes
        self._moved.start_pan(event.x, event.y, 1)

    def _move(self, event: MouseEvent) -> None:
        if self._moved is not None:
            self._moved.drag_pan(1, None, event.x, event.y)
            self._canvas.draw_idle()

    def _release(self, _event: MouseEvent) -> None:
        if self._moved is not None:
            self._moved.end_pan()
            self._moved = None
