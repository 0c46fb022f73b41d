"""Zoom and pan of a plot: wheel zooms, drag moves, double-click shows all."""

from matplotlib.axes import Axes
from matplotlib.backend_bases import FigureCanvasBase, MouseEvent

ZOOM_STEP = 0.8
"""Factor on the width for one notch of the wheel."""

Limits = tuple[tuple[float, float], tuple[float, float]]


class PlotZoom:
    """Zoom and pan for the axes of a canvas."""

    def __init__(self, canvas: FigureCanvasBase) -> None:
        self._canvas = canvas
        self._whole: list[Limits] = []
        self._upright = True
        self._moved: Axes | None = None
        canvas.mpl_connect("scroll_event", self._zoom)
        canvas.mpl_connect("button_press_event", self._press)
        canvas.mpl_connect("motion_notify_event", self._move)
        canvas.mpl_connect("button_release_event", self._release)

    def set_home(self, *, upright: bool = True) -> None:
        """Store the present limits as those that show the whole plot.

        Parameters
        ----------
        upright : bool
            Whether the vertical axis is also zoomed; False for bar charts.
        """
        self._moved, self._upright = None, upright
        self._whole = [(a.get_xlim(), a.get_ylim()) for a in self._canvas.figure.axes]

    def _zoom(self, event: MouseEvent) -> None:
        if event.inaxes is None or event.xdata is None or event.ydata is None:
            return
        factor = ZOOM_STEP**event.step
        axes = event.inaxes
        axes.set_xlim(*(event.xdata + factor * (x - event.xdata) for x in axes.get_xlim()))
        if self._upright:
            axes.set_ylim(*(event.ydata + factor * (y - event.ydata) for y in axes.get_ylim()))
        self._canvas.draw_idle()

    def _press(self, event: MouseEvent) -> None:
        if event.inaxes is None or event.button != 1:
            return
        if event.dblclick:
            shown = self._canvas.figure.axes
            if len(self._whole) == len(shown):
                across, up = self._whole[shown.index(event.inaxes)]
                event.inaxes.set_xlim(*across)
                if self._upright:
                    event.inaxes.set_ylim(*up)
                self._canvas.draw_idle()
            return
        self._moved = event.inaxes
        self._moved.start_pan(event.x, event.y, 1)

    def _move(self, event: MouseEvent) -> None:
        if self._moved is not None:
            self._moved.drag_pan(1, None if self._upright else "x", event.x, event.y)
            self._canvas.draw_idle()

    def _release(self, _event: MouseEvent) -> None:
        if self._moved is not None:
            self._moved.end_pan()
            self._moved = None
