"""Zoom and pan of a plot: wheel zooms, drag moves, double-click shows all."""

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.backend_bases import FigureCanvasBase, MouseEvent

ZOOM_STEP = 0.8
"""Factor on the width for one notch of the wheel."""

Range = tuple[float, float]
Limits = tuple[Range, Range]


class PlotZoom:
    """Zoom and pan for the axes of a canvas."""

    def __init__(self, canvas: FigureCanvasBase) -> None:
        self._canvas = canvas
        self._home_limits: list[Limits] = []
        self._outer_ranges: Sequence[Range] = ()
        self._zooms_vertically = True
        self._dragged_axes: Axes | None = None
        canvas.mpl_connect("scroll_event", self._zoom)
        canvas.mpl_connect("button_press_event", self._press)
        canvas.mpl_connect("motion_notify_event", self._move)
        canvas.mpl_connect("button_release_event", self._release)

    def set_home(self, *, zooms_vertically: bool = True, limits: Sequence[Range] = ()) -> None:
        """Store the present limits as those that show the whole plot.

        Parameters
        ----------
        zooms_vertically : bool
            Whether the vertical axis is also zoomed; False for bar charts.
        limits : for each plot, range of its data, beyond which the horizontal axis is not shown
        """
        self._outer_ranges = limits
        self._dragged_axes, self._zooms_vertically = None, zooms_vertically
        self._home_limits = [(a.get_xlim(), a.get_ylim()) for a in self._canvas.figure.axes]

    def _zoom(self, event: MouseEvent) -> None:
        if event.inaxes is None or event.xdata is None or event.ydata is None:
            return
        factor = ZOOM_STEP**event.step
        axes = event.inaxes
        axes.set_xlim(*(event.xdata + factor * (x - event.xdata) for x in axes.get_xlim()))
        if self._zooms_vertically:
            axes.set_ylim(*(event.ydata + factor * (y - event.ydata) for y in axes.get_ylim()))
        self._keep_inside(axes)
        self._canvas.draw_idle()

    def _press(self, event: MouseEvent) -> None:
        if event.inaxes is None or event.button != 1:
            return
        if event.dblclick:
            shown = self._canvas.figure.axes
            if len(self._home_limits) == len(shown):
                across, up = self._home_limits[shown.index(event.inaxes)]
                event.inaxes.set_xlim(*across)
                if self._zooms_vertically:
                    event.inaxes.set_ylim(*up)
                self._canvas.draw_idle()
            return
        self._dragged_axes = event.inaxes
        self._dragged_axes.start_pan(event.x, event.y, 1)

    def _move(self, event: MouseEvent) -> None:
        if self._dragged_axes is not None:
            self._dragged_axes.drag_pan(
                1, None if self._zooms_vertically else "x", event.x, event.y
            )
            self._keep_inside(self._dragged_axes)
            self._canvas.draw_idle()

    def _keep_inside(self, axes: Axes) -> None:
        """Shift and shorten the horizontal axis so that it shows no range without data."""
        shown = self._canvas.figure.axes
        if len(self._outer_ranges) != len(shown):
            return
        least, most = self._outer_ranges[shown.index(axes)]
        low, high = axes.get_xlim()
        width = min(high - low, most - least)
        start = min(max(low, least), most - width)
        if (low, high) != (start, start + width):
            axes.set_xlim(start, start + width)

    def _release(self, _event: MouseEvent) -> None:
        if self._dragged_axes is not None:
            self._dragged_axes.end_pan()
            self._dragged_axes = None
