"""Viewport without graphics that records its calls, for tests of the window."""

from collections.abc import Mapping, Sequence

import numpy as np
from PySide6.QtCore import QPoint
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget

from lispac.gui.viewport.base import (
    Array,
    Colour,
    Highlight,
    LinkedView,
    Marker,
    MouseMode,
    PickedPoint,
    Place,
    PointColouring,
    SightingStyle,
    Sketch,
    Viewport,
    ViewportSignals,
    sighting_style,
)
from lispac.gui.viewport.clipping import Box
from lispac.picked_targets import Role


class RecordingViewport:
    """`Viewport` on a plain widget that records the calls of its methods.

    Attributes
    ----------
    calls : list of (method name, arguments)
        Calls in order, except those that only return a value.
    clouds, colours, shading, hidden, highlights, markers, selected, point_size, parallel, station,
    mouse_mode, hint, seed_role, help_shown, sketches, box, wipe_clouds, wipe_highlights, linked
        Content and state that a real viewport would show.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        self._widget = QWidget(parent)
        self.signals = ViewportSignals(self._widget)
        self.calls: list[tuple[str, tuple[object, ...]]] = []
        self.clouds: dict[str, Array] = {}
        self.colours: dict[str, Colour] = {}
        self.shading: PointColouring | None = None
        self.hidden: set[str] = set()
        self.highlights: list[Highlight] = []
        self.markers: list[Marker] = []
        self.selected: tuple[str, str] | None = None
        self.point_size = 2
        self.parallel = False
        self.mouse_mode: MouseMode = "navigate"
        self.hint = ""
        self.seed_role: Role = "target"
        self.help_shown = True
        self.box: Box | None = None
        self.wipe_clouds: dict[str, Array] | None = None
        self.wipe_highlights: tuple[Highlight, ...] = ()
        self.linked: tuple[LinkedView, ...] = ()
        self.sketches: dict[str, Sketch] = {}
        self.station: tuple[float, float, float] = (0.0, 0.0, 0.0)
        self.closed = False

    @property
    def widget(self) -> QWidget:
        """A plain widget."""
        return self._widget

    def click(self, line: str, index: int) -> None:
        """Simulate a Ctrl+click on a point of a line."""
        if line in self.hidden:
            raise KeyError(f"line {line} is hidden and cannot be clicked")
        x, y, z = (float(v) for v in self.clouds[line][index])
        self.signals.seed_clicked.emit(PickedPoint(line, (x, y, z)))

    def click_empty(self) -> None:
        """Simulate a Ctrl+click into empty space."""
        self.signals.missed.emit(QPoint())

    def show_clouds(
        self,
        clouds: Mapping[str, Array],
        colours: Mapping[str, Colour],
        shading: PointColouring | None = None,
    ) -> None:
        """Remember the lines."""
        self._record("show_clouds", clouds, colours, shading)
        self.clouds, self.colours, self.shading = dict(clouds), dict(colours), shading

    def set_line_visible(self, line: str, visible: bool) -> None:
        """Remember which lines are hidden."""
        self._record("set_line_visible", line, visible)
        if visible:
            self.hidden.discard(line)
        else:
            self.hidden.add(line)

    def is_line_hidden(self, line: str) -> bool:
        """Whether a line is hidden."""
        return line in self.hidden

    def show_highlights(self, highlights: Sequence[Highlight]) -> None:
        """Remember the sightings."""
        self._record("show_highlights", highlights)
        self.highlights = list(highlights)

    def show_markers(self, markers: Sequence[Marker]) -> None:
        """Remember the markers."""
        self._record("show_markers", markers)
        self.markers = list(markers)

    def select(self, key: tuple[str, str] | None) -> None:
        """Remember the selection."""
        self._record("select", key)
        self.selected = key

    def clip(self, box: Box | None) -> None:
        """Remember the box."""
        self._record("clip", box)
        self.box = box

    def show_wipe(
        self, clouds: Mapping[str, Array] | None, highlights: Sequence[Highlight] = ()
    ) -> None:
        """Remember the other placement."""
        self._require_colours(clouds or {})
        self._record("show_wipe", clouds, highlights)
        self.wipe_clouds = None if clouds is None else dict(clouds)
        self.wipe_highlights = tuple(highlights)

    def show_linked(self, views: Sequence[LinkedView]) -> None:
        """Remember the linked views."""
        for view in views:
            self._require_colours(view.clouds or {})
        self._record("show_linked", views)
        self.linked = tuple(views)

    def set_station(self, position: tuple[float, float, float]) -> None:
        """Remember the position of the observer."""
        self._record("set_station", position)
        self.station = position

    def fit(self, points: Array | None = None) -> None:
        """Remember the call."""
        self._record("fit", points)

    def keep_picture(self) -> None:
        """Remember the call."""
        self._record("keep_picture")

    def view(self, name: str) -> None:
        """Remember the call."""
        self._record("view", name)

    def view_along(self, direction: Array, points: Array) -> None:
        """Remember the call."""
        self._record("view_along", direction, points)

    def step_view(self, steps: int) -> None:
        """Remember the call."""
        self._record("step_view", steps)

    def copy_view_from(self, former: Viewport) -> None:
        """Copy the emphasised sighting, and remember the call without the former viewport."""
        assert isinstance(former, RecordingViewport)
        self._record("copy_view_from")
        self.selected = former.selected

    def set_parallel(self, parallel: bool) -> None:
        """Remember the projection."""
        self._record("set_parallel", parallel)
        self.parallel = parallel

    def set_fit_margins(self, strip_px: float, factor: float) -> None:
        """Remember the call."""
        self._record("set_fit_margins", strip_px, factor)

    def set_mouse(self, mode: MouseMode, hint: str = "") -> None:
        """Remember the mode of the left button and the hint."""
        self._record("set_mouse", mode, hint)
        self.mouse_mode, self.hint = mode, hint

    def show_seed_role(self, role: Role) -> None:
        """Remember the role."""
        self._record("show_seed_role", role)
        self.seed_role = role

    def show_help(self, shown: bool) -> None:
        """Remember the call."""
        self._record("show_help", shown)
        self.help_shown = shown

    def show_line_legend(self, shown: bool) -> None:
        """Remember the call."""
        self._record("show_line_legend", shown)

    def drawn_near(self, line: str, centre: Place, radius: float) -> Array:
        """Points of a line within a sphere."""
        points = self.clouds[line]
        return points[np.linalg.norm(points - centre, axis=1) <= radius]

    def show_sketch(self, name: str, sketch: Sketch | None) -> None:
        """Remember the sketches."""
        self._record("show_sketch", name, sketch)
        self.sketches.pop(name, None)
        if sketch is not None:
            self.sketches[name] = sketch

    def to_pixels(self, points: Array) -> Array:
        """Pixels as seen from above: a metre is a pixel, north is up."""
        return np.column_stack([-points[:, 1], -points[:, 0]])

    def point_at(self, line: str, index: int) -> None:
        """Simulate a click on a point of a line in pointing mode."""
        if self.mouse_mode != "point":
            raise RuntimeError("the mouse does not point now")
        x, y, z = (float(v) for v in self.clouds[line][index])
        self.signals.pointed.emit(PickedPoint(line, (x, y, z)))

    def set_point_size(self, pixels: int) -> None:
        """Remember the size."""
        self._record("set_point_size", pixels)
        self.point_size = pixels

    def set_point_budget(self, points: int) -> None:
        """Remember the budget."""
        self._record("set_point_budget", points)
        self.point_budget = points

    def prepare(self) -> None:
        """Do nothing, as there is no detail."""

    def picture(self, label_scale: float = 1.0) -> QImage:
        """Picture of the plain widget."""
        self._record("picture")
        return self._widget.grab().toImage()

    def clear(self) -> None:
        """Clear the content."""
        self._record("clear")
        self.clouds, self.colours, self.hidden = {}, {}, set()
        self.highlights, self.markers, self.selected = [], [], None
        self.sketches, self.box, self.wipe_clouds, self.linked = {}, None, None, ()

    def create_empty_viewport(self) -> "RecordingViewport":
        """New empty viewport."""
        return RecordingViewport()

    def close(self) -> None:
        """Remember that the graphics are released."""
        self._record("close")
        self.closed = True

    @property
    def highlight_styles(self) -> dict[tuple[str, str], SightingStyle]:
        """Style of each sighting."""
        return {each.key: sighting_style(each, self.selected) for each in self.highlights}

    def _require_colours(self, clouds: Mapping[str, Array]) -> None:
        """Raise an error if lines are shown in another placement before `show_clouds`."""
        if missing := clouds.keys() - self.colours:
            raise KeyError(*missing)

    def _record(self, name: str, *arguments: object) -> None:
        self.calls.append((name, arguments))
