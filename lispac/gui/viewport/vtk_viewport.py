"""Viewport drawn with OpenGL by VTK.

Changes of the scene request a repaint (`VtkCanvas.redraw`) and do not render directly, since Qt
combines requests and paints when the event loop is free.
"""

import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QWidget

from lispac.gui.appearance import theme
from lispac.gui.viewport.actors import (
    create_renderer,
    half_space,
    place_renderer,
    set_half_space,
    set_renderer_camera,
)
from lispac.gui.viewport.base import (
    Array,
    Colour,
    Highlight,
    LinkedView,
    Marker,
    MouseMode,
    Place,
    PointColouring,
    Sketch,
    Viewport,
    ViewportSignals,
)
from lispac.gui.viewport.camera import Camera
from lispac.gui.viewport.canvas import VtkCanvas
from lispac.gui.viewport.clipping import Box, dividing_plane
from lispac.gui.viewport.decimation import Budget
from lispac.gui.viewport.frame_times import SLICE_FRACTIONS, FrameTimes
from lispac.gui.viewport.highlights import HighlightLayer
from lispac.gui.viewport.line_layer import LineLayer, common_origin
from lispac.gui.viewport.linked_pictures import WHOLE, Picture
from lispac.gui.viewport.navigation import Navigator
from lispac.gui.viewport.overlay import OverlaidPicture, OverlaidView
from lispac.gui.viewport.sketches import SketchLayer
from lispac.gui.viewport.view_detail import ViewDetail
from lispac.language import gettext
from lispac.picked_targets import Role

MAX_MOVING_DETAIL_S = 0.03
"""Longest rendering time of detail that is also shown while the camera moves."""


class _Pane:
    """Picture of the lines in a part of the canvas, with its renderer, points and sightings.

    Attributes
    ----------
    view : the linked view that it shows; None for the view itself
    """

    def __init__(self, renderer: Any, view: LinkedView | None = None) -> None:
        self.renderer, self.view = renderer, view
        renderer.SetBackground(*theme.colour("ground").getRgbF()[:3])
        renderer.SetBackground2(*theme.colour("sky").getRgbF()[:3])
        renderer.GradientBackgroundOn()
        self.layer = LineLayer(renderer)
        self.sightings = HighlightLayer(renderer)
        self.picture = Picture(drawn=lambda: self.layer.detail or self.layer.sparse)

    def place(self, part: tuple[float, float, float, float]) -> None:
        """Set the part of the canvas."""
        self.picture.part = part
        place_renderer(self.renderer, part)

    def clear_references(self) -> None:
        """Clear all references to points and actors."""
        self.renderer.RemoveAllViewProps()
        self.layer.clear_references()
        self.sightings.clear_references()


class VtkViewport:
    """`Viewport` on a `VtkCanvas`.

    Attributes
    ----------
    canvas : widget that shows the scene and receives the mouse events
    """

    def __init__(self, parent: QWidget | None = None, budget: Budget | None = None) -> None:
        self._budget = budget or Budget()
        self._times = FrameTimes(self._budget)
        self._view = OverlaidView(parent)
        # Deleted with the widget; otherwise its connections would keep the window alive.
        self.signals = ViewportSignals(self._view)
        self.canvas = VtkCanvas(self._view)
        self.canvas.setAcceptDrops(False)  # the window handles dropped files
        self.canvas.setAccessibleName(gettext("Lines in 3D"))
        self._view.set_canvas(self.canvas)
        self._overlay = self._view.overlay
        self._main = _Pane(self.canvas.renderer)
        self._layer = self._main.layer
        self._panes = [self._main]
        self._wipe_layer: LineLayer | None = None
        self._wipe_sightings = HighlightLayer(self._main.renderer)
        self._box: Box | None = None
        self._hidden: set[str] = set()
        self._point_size = 2
        self._closed = self._keeps_view = False
        self._shows_detail = False
        self._detail_render_s = np.inf
        self._frame_start = 0.0

        self._observers = [
            self.canvas.ren_win.AddObserver(event, slot)
            for event, slot in (
                ("StartEvent", self._on_frame_start),
                ("EndEvent", self._on_frame_end),
            )
        ]
        self._view_detail = ViewDetail(
            self._view, lambda: self._refinement_steps(self._times.rest_points), self._show_detail
        )
        self._view.resized.connect(self._on_resized)
        self._navigator = Navigator(self.canvas)
        self._navigator.show_pictures([self._main.picture])
        self._navigator.moved.connect(self._on_moved)
        self._navigator.move_ended.connect(self._view_detail.schedule)
        self._navigator.picked.connect(self.signals.seed_clicked)
        self._navigator.view_restored.connect(self._refine_later)
        self._navigator.history.changed.connect(self.signals.history_changed)
        self._navigator.missed.connect(self.signals.missed)
        self._navigator.pointed.connect(self.signals.pointed)
        self._navigator.menu_requested.connect(self.signals.menu_requested)
        self._navigator.mouse.copy_requested.connect(self.signals.copy_requested)
        for used in (self._navigator.moved, self._navigator.picked):
            used.connect(self._overlay.fade_help)
        self._overlay.help_used.connect(self.signals.help_used)
        self._sketch_layer = SketchLayer(self._navigator, self._overlay, self.signals)
        self._sketch_layer.divider_moved.connect(self._camera_moved)

    # Interface of `Viewport`

    @property
    def widget(self) -> QWidget:
        """Widget of the viewport, for the window."""
        return self._view

    @property
    def camera(self) -> Camera:
        """Camera of the view."""
        return self._navigator.camera

    def to_pixels(self, points: Array) -> Array:
        """Pixels (x, y) of the canvas where points (n, 3) of the local frame are drawn."""
        corner = self._main.picture.rect(self._navigator.widget_size).topLeft()
        pixels = self.camera.project(points, self._navigator.size)[:, :2]
        return pixels + np.array([corner.x(), corner.y()])

    def show_clouds(
        self,
        clouds: Mapping[str, Array],
        colours: Mapping[str, Colour],
        shading: PointColouring | None = None,
    ) -> None:
        """Draw the lines, each in its colour or shaded, instead of those shown.

        The first lines are shown in the view "isometric", unless the camera was copied; later ones
        do not change the camera.
        """
        first = not self._layer.clouds
        self._overlay.shading = shading
        self._layer.set_lines(clouds, colours, shading)
        self._show_legend_lines()
        for pane in self._panes[1:]:
            if pane.view is not None and pane.view.clouds is None:
                pane.layer.set_lines(clouds, colours, shading)
        if first:
            origin = common_origin(self._layer.clouds)
            for pane in self._panes:
                pane.layer.origin = origin
        self._draw_clouds()
        if first:
            self.show_highlights(self._main.sightings.highlights)  # relative to the new origin
            if not self._keeps_view:
                self.view("isometric")
            self._keeps_view = False

    def set_line_visible(self, line: str, visible: bool) -> None:
        """Show or hide one line; the visible lines share the budget."""
        if visible == (line not in self._hidden):
            return
        (self._hidden.discard if visible else self._hidden.add)(line)
        self._show_legend_lines()
        self._draw_clouds()

    def _show_legend_lines(self) -> None:
        """Show the visible lines in the legend."""
        colours = self._layer.colours
        self._overlay.lines = {
            line: colours[line]
            for line in self._layer.clouds
            if line in colours and line not in self._hidden
        }

    def is_line_hidden(self, line: str) -> bool:
        """Whether a line is hidden."""
        return line in self._hidden

    def show_highlights(self, highlights: Sequence[Highlight]) -> None:
        """Draw sightings over the lines, instead of those shown."""
        for pane in self._panes:
            if pane.view is None or pane.view.highlights is None:
                self._set_highlights(pane, highlights)
        self._style_points()

    def _set_highlights(self, pane: _Pane, highlights: Sequence[Highlight]) -> None:
        layer, box = pane.layer, pane.picture.box or self._box
        pane.sightings.set_highlights(highlights, layer.origin, box, layer.half)

    def show_markers(self, markers: Sequence[Marker]) -> None:
        """Draw seeds and labels, instead of those shown."""
        self._overlay.markers = tuple(markers)
        self._overlay.update()

    def clip(self, box: Box | None) -> None:
        """Draw only the points in a box; None for all points."""
        self._box = box
        self._draw_clouds()
        self._redraw_highlights()

    def _redraw_highlights(self) -> None:
        for pane in self._panes:
            self._set_highlights(pane, pane.sightings.highlights)
        layer, sightings = self._wipe_layer, self._wipe_sightings
        if layer is not None:
            box = self._main.picture.box or self._box
            sightings.set_highlights(sightings.highlights, layer.origin, box, layer.half)
        self._style_points()

    def show_wipe(
        self, clouds: Mapping[str, Array] | None, highlights: Sequence[Highlight] = ()
    ) -> None:
        """Draw another placement of the lines to the left of a movable line; None ends it.

        The points must be the same, in the same order; they keep their colours.
        """
        if self._wipe_layer is None and clouds is None:
            return
        if clouds is None:
            self._end_wipe()
        elif self._wipe_layer is None:
            self._wipe_layer = LineLayer(self._main.renderer)
            self._wipe_layer.origin = self._layer.origin
            self._layer.half, self._wipe_layer.half = half_space(), half_space()
            self._wipe_sightings.selected = self._main.sightings.selected
            self._sketch_layer.show_dividing_line(True)
        if self._wipe_layer is not None and clouds is not None:
            self._set_layer_lines(self._wipe_layer, clouds)
        self._wipe_sightings.highlights = tuple(highlights)
        self._draw_clouds()
        self._redraw_highlights()

    def _end_wipe(self) -> None:
        if self._wipe_layer is not None:
            self._wipe_layer.remove()
        self._wipe_layer = None
        self._layer.half = None
        self._wipe_sightings.remove()
        self._sketch_layer.show_dividing_line(False)

    def show_linked(self, views: Sequence[LinkedView]) -> None:
        """Show several linked views, the first of which is the view itself; one if it is empty."""
        if not views and len(self._panes) == 1:
            return
        former, self._panes = self._panes[1:], [self._main]
        self._main.place(views[0].part if views else WHOLE)
        self._main.picture.title = views[0].title if views else ""
        for view in views[1:]:
            found = (pane for pane in former if pane.view is not None and _fits(pane.view, view))
            pane = next(found, None) or self._create_pane(view)
            if pane in former:
                former.remove(pane)
            pane.view, pane.picture.title = view, view.title
            pane.picture.show_box(view.box)
            self._set_pane_lines(pane)
            self._panes.append(pane)
        for pane in former:
            self._remove_pane(pane)
        self._navigator.show_pictures([pane.picture for pane in self._panes])
        self._draw_clouds()
        for pane in self._panes[1:]:
            own = None if pane.view is None else pane.view.highlights
            pane.sightings.selected = self._main.sightings.selected
            self._set_highlights(pane, self._main.sightings.highlights if own is None else own)
        self._style_points()

    def _set_pane_lines(self, pane: _Pane) -> None:
        """Show the lines of the view, or their other placement, with the colours of the view."""
        own = None if pane.view is None else pane.view.clouds
        self._set_layer_lines(pane.layer, self._layer.clouds if own is None else own)

    def _set_layer_lines(self, layer: LineLayer, clouds: Mapping[str, Array]) -> None:
        """Set the lines of a layer with the colours of the view, unless it has them."""
        main = self._layer
        is_same = all(layer.clouds.get(line) is points for line, points in clouds.items())
        if not (is_same and layer.colours == main.colours and layer.shading is main.shading):
            layer.set_lines(clouds, main.colours, main.shading)

    def _remove_pane(self, pane: _Pane) -> None:
        pane.clear_references()
        self.canvas.ren_win.RemoveRenderer(pane.renderer)

    def _create_pane(self, view: LinkedView) -> _Pane:
        pane = _Pane(create_renderer(self.canvas.ren_win), view)
        pane.place(view.part)
        pane.picture.direction = view.direction
        pane.layer.origin = self._layer.origin
        if view.clouds is not None:
            pane.picture.place_in_view = partial(_corresponding_place, pane.layer, self._layer)
        return pane

    def select(self, key: tuple[str, str] | None) -> None:
        """Highlight one sighting, (target, line), and dim the others of its target."""
        for sightings in self._sightings:
            sightings.selected = key
        self._style_points()

    def set_station(self, position: tuple[float, float, float]) -> None:
        """Set the position from which the standard views look."""
        self._navigator.station = np.asarray(position, dtype=np.float64)

    def fit(self, points: Array | None = None) -> None:
        """Bring everything, or the given points of shape (n, 3), into view."""
        self._navigator.fit(points)
        self._refine_later()

    def keep_picture(self) -> None:
        """Keep the scene in place while a panel that opens takes a part of the view."""
        self._navigator.keep_picture()

    def view(self, name: str) -> None:
        """Show a standard view: "top", "front", "back", "left", "right" or "isometric"."""
        self._navigator.view(name)
        self._refine_later()

    def view_along(self, direction: Array, points: Array) -> None:
        """Look at points (n, 3) along a direction (3,), from the station's side of them."""
        self._navigator.view_along(direction, points)
        self._refine_later()

    def step_view(self, steps: int) -> None:
        """Go back (negative) or forward in the history of views, if there are so many."""
        self._navigator.step_view(steps)

    def copy_view_from(self, former: Viewport) -> None:
        """Take over camera, former views, emphasis and dividing line of another `VtkViewport`."""
        assert isinstance(former, VtkViewport)
        if not former._layer.clouds:
            return
        self._keeps_view = True
        self._navigator.copy_view_from(former._navigator)
        self.select(former._main.sightings.selected)
        self._sketch_layer.share = former._sketch_layer.share

    def set_parallel(self, parallel: bool) -> None:
        """Draw in parallel (orthographic) projection, or in perspective."""
        self._navigator.project_parallel(parallel)
        self._refine_later()

    def set_fit_margins(self, strip_px: float, factor: float) -> None:
        """Set the space that fitted points leave free, for the next fit."""
        self._navigator.free_strip_px, self._navigator.fit_margin = strip_px, factor

    def set_mouse(self, mode: MouseMode, hint: str = "") -> None:
        """Set the mode of the left mouse button and the hint above the picture."""
        self._navigator.mouse.set_mode(mode)
        self._overlay.hint = hint
        self._overlay.update()

    def show_seed_role(self, role: Role) -> None:
        """Name the surface that Ctrl+click picks, by its role, in the help on the mouse."""
        self._overlay.seed_role = role
        self._overlay.update()

    def show_help(self, shown: bool) -> None:
        """Show the help on the mouse, which fades after its first use, or hide it."""
        self._overlay.show_help(shown)

    def show_line_legend(self, shown: bool) -> None:
        """Show or hide the legend of the lines."""
        self._overlay.has_line_legend = shown
        self._overlay.update()

    def drawn_near(self, line: str, centre: Place, radius: float) -> Array:
        """Drawn points of a line within a sphere, shape (n, 3)."""
        points = self._main.picture.drawn().get(line, np.empty((0, 3)))
        points = points[np.abs(points[:, 0] - centre[0]) <= radius]  # excludes nearly all at once
        offsets = points - np.asarray(centre)
        return points[np.einsum("ij,ij->i", offsets, offsets) <= radius**2]

    def show_sketch(self, name: str, sketch: Sketch | None) -> None:
        """Draw a sketch over the picture; None removes it."""
        self._sketch_layer.show(name, sketch)

    def set_point_size(self, pixels: int) -> None:
        """Set the size of the drawn points."""
        self._point_size = pixels
        self._style_points()

    def set_point_budget(self, points: int) -> None:
        """Set the largest number of points drawn at rest; no more are drawn during movements."""
        budget = Budget(points, min(Budget().moving, points))
        if budget != self._budget:
            self._budget = budget
            self._times = FrameTimes(budget)
            self._draw_clouds()

    def prepare(self) -> None:
        """Load all detail of a picture, so that it only needs to be drawn."""
        self._view_detail.compute_now(self._refinement_steps(self._times.picture_points))

    def picture(self, label_scale: float = 1.0) -> QImage:
        """Picture of the view with all detail and labels, without the help text."""
        self.prepare()
        image: QImage = self.canvas.grabFramebuffer()
        painter = QPainter(image)
        self._overlay.paint(painter, label_scale)
        painter.end()
        self._view_detail.schedule()  # back to the number of points for the screen
        return image

    def clear(self) -> None:
        """Remove all content."""
        self._navigator.clear_fit()
        self._sketch_layer.clear()
        self._box = None
        self.show_wipe(None)
        self.show_linked(())
        self._hidden.clear()
        self._main.sightings.selected = None
        self._overlay.markers = ()
        self._overlay.shading, self._overlay.lines = None, {}
        self._layer.set_lines({}, {})
        self.show_highlights([])
        self._draw_clouds()

    def create_empty_viewport(self) -> "VtkViewport":
        """New empty viewport."""
        return VtkViewport()

    def close(self) -> None:
        """Release the graphics before the window closes; may be called repeatedly."""
        if self._closed:
            return
        self._closed = True
        for observer in self._observers:
            self.canvas.ren_win.RemoveObserver(observer)
        self._view_detail.stop()
        self._sketch_layer.clear()
        self.canvas.removeEventFilter(self._navigator.mouse)
        if self._wipe_layer is not None:
            self._wipe_layer.clear_references()
        self._wipe_sightings.clear_references()
        self._main.clear_references()
        for pane in self._panes[1:]:
            self._remove_pane(pane)
        self.canvas.close()

    # Drawing

    def _draw_clouds(self) -> None:
        """Draw the visible lines coarsely; the detail is drawn later."""
        budget = self._budget.moving // len(self._layers)
        for layer, picture in self._layers:
            layer.draw(self._hidden, budget, picture.box or self._box)
            layer.show_detail(fine=False, coarse=self._times.slice)
        for pane in self._panes:
            pane.picture.clouds, pane.picture.coarse = pane.layer.visible, pane.layer.sparse
        self._shows_detail = False
        self._style_points()
        self._view_detail.schedule()

    def _style_points(self) -> None:
        scale = self.canvas.devicePixelRatioF()
        for layer, _ in self._layers:
            layer.style(self._point_size, scale)
        for sightings in self._sightings:
            sightings.style(self._point_size, scale, self._hidden)
        self._camera_moved()

    def _camera_moved(self) -> None:
        for layer, picture in self._layers:
            layer.update_depth(self._navigator.camera_of(picture))
        self._place_dividing_plane()
        for pane in self._panes:
            camera, origin = self._navigator.camera_of(pane.picture), pane.layer.origin
            pane.sightings.update_depth(camera, origin)
            if pane is self._main:
                self._wipe_sightings.update_depth(camera, origin)
            set_renderer_camera(pane.renderer, camera, origin)
        self._update()

    def _update(self) -> None:
        navigator = self._navigator
        self._overlay.pictures = [
            OverlaidPicture(
                each.rect(navigator.widget_size), navigator.camera_of(each), each.title, each.box,
                navigator.scale_depth(each),
            )
            for each in (navigator.pictures if self._layer.clouds else ())
        ]  # fmt: skip
        self.canvas.redraw()
        self._overlay.update()

    def _on_frame_start(self, *_: object) -> None:
        self._frame_start = time.perf_counter()

    def _on_frame_end(self, *_: object) -> None:
        """Record the time of a complete frame, including software rendering."""
        seconds = time.perf_counter() - self._frame_start
        if self._shows_detail:
            self._detail_render_s = seconds
            points = _count_points(layer.detail for layer, _ in self._layers)
            self._times.record("resting", points, seconds)
        else:
            whole = _count_points(layer.sparse for layer, _ in self._layers)
            drawn = int(SLICE_FRACTIONS[self._times.slice] * whole)
            self._times.record("moving", drawn, seconds, whole)

    def _refinement_steps(self, points: int) -> Iterator[None]:
        navigator, budget = self._navigator, points // len(self._layers)
        for layer, picture in self._layers:
            camera, size = navigator.camera_of(picture), navigator.size_of(picture)
            yield from layer.refinement_steps(camera, size, budget)

    def _show_detail(self) -> None:
        self._shows_detail = True
        for layer, _ in self._layers:
            layer.show_detail(fine=True, coarse=None)
        self._navigator.find_centres()
        self._style_points()

    def _on_moved(self) -> None:
        self._view_detail.abandon()
        if self._detail_render_s > MAX_MOVING_DETAIL_S:
            self._shows_detail = False
        for layer, _ in self._layers:
            # The detail was selected for the camera at its last rest.
            layer.show_detail(fine=self._shows_detail, coarse=self._times.slice)
        self._camera_moved()

    @property
    def _layers(self) -> list[tuple[LineLayer, Picture]]:
        """All drawn lines, each with its picture."""
        layers = [(pane.layer, pane.picture) for pane in self._panes]
        if self._wipe_layer is not None:
            layers.append((self._wipe_layer, self._main.picture))
        return layers

    @property
    def _sightings(self) -> list[HighlightLayer]:
        """All drawn sightings."""
        return [*(pane.sightings for pane in self._panes), self._wipe_sightings]

    def _place_dividing_plane(self) -> None:
        """Place the clipping planes of both placements at the dividing line."""
        if self._wipe_layer is None:
            return
        size = self._navigator.size
        point, normal = dividing_plane(self.camera, self._sketch_layer.share * size.width, size)
        set_half_space(self._layer.half, point - self._layer.origin, normal)
        set_half_space(self._wipe_layer.half, point - self._layer.origin, -normal)

    def _on_resized(self) -> None:
        if not self._closed:
            self._navigator.on_resized(self._main.sightings.selected_points())
            self._refine_later()

    def _refine_later(self) -> None:
        """Show a coarse picture immediately and schedule the detail."""
        self._on_moved()
        self._view_detail.schedule()


def _fits(shown: LinkedView, view: LinkedView) -> bool:
    """Whether a linked view is in the same place as another, with the same kind of content."""
    return (shown.part, shown.direction, shown.clouds is None) == (
        view.part, view.direction, view.clouds is None
    )  # fmt: skip


def _corresponding_place(layer: LineLayer, other: LineLayer, line: str, place: Array) -> Array:
    """Position, in another placement of a line, of its point at ``place``."""
    points = layer.clouds[line]
    rows = np.flatnonzero(points[:, 0] == place[0])  # few, so that the rest takes no time
    found: Array = other.clouds[line][rows[(points[rows] == place).all(axis=1)][0]]
    return found


def _count_points(drawn: Iterable[Mapping[str, Array]]) -> int:
    return sum(len(points) for lines in drawn for points in lines.values())
