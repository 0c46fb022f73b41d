"""Camera movements: rotate, pan, zoom, fit, standard views; picking of points by the mouse."""

import time
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QObject, QPoint, Signal
from PySide6.QtGui import QCursor
from PySide6.QtWidgets import QWidget

from lispac.gui.viewport.base import Array, PickedPoint
from lispac.gui.viewport.camera import Camera, ViewportSize
from lispac.gui.viewport.decimation import trimmed_points
from lispac.gui.viewport.linked_pictures import Picture
from lispac.gui.viewport.mouse import ViewportMouse
from lispac.gui.viewport.point_picker import central_point, pick_point
from lispac.gui.viewport.view_history import StoredView, ViewHistory

WHEEL_FACTOR = 0.85
"""Factor on the distance for one notch of the wheel."""

SNAP_RADII_PX = (3.0, 8.0, 20.0)
"""Search radii for the point about which a drag rotates or the wheel zooms, or that is hovered."""

MAX_FIT_POINTS = 60_000
"""Largest number of points that determine the extent: the first coarse points, in random order."""

MAX_CENTRAL_POINTS = 250_000
"""Largest number of drawn points among which the surface in the middle is searched for; of more,
the thinned ones are dense enough."""

KEPT_TIME_S = 0.5
"""Time after `Navigator.keep_picture` in which the layout of the window settles."""

REVEALED_MARGIN_PX = 36.0
"""Distance from the edges of a selected surface that a panel would have covered, pixels."""

FREE_STRIP_PX, MAX_FREE_SHARE = 42.0, 0.35
"""Height of the strip at the bottom with the help on the mouse, pixels, which fitted points leave
free, and its largest share of the height of the picture."""
FIT_MARGIN = 1.06
"""Factor of the distance at which the camera shows fitted points."""

VIEWS_DEG = {
    "front": (0.0, 0.0),
    "back": (180.0, 0.0),
    "left": (90.0, 0.0),
    "right": (-90.0, 0.0),
    "isometric": (30.0, 26.0),
}
"""Azimuth relative to the view "front", and elevation; the view "top" always has north up."""


class Navigator(QObject):
    """Camera of a widget, moved by its mouse.

    Attributes
    ----------
    camera : the present camera
    pictures : pictures of the widget; the first is that of the camera
    history : views to which the user can go back
    station : ndarray of shape (3,), metres, local frame
        Position from which the view "front" looks.
    free_strip_px, fit_margin : as in `FREE_STRIP_PX` and `FIT_MARGIN`
    """

    moved = Signal()  # the user moves the camera
    move_ended = Signal()  # the user has stopped moving it
    view_restored = Signal()  # a former view is shown
    picked = Signal(object)  # PickedPoint
    missed = Signal(object)  # QPoint on the screen
    pointed = Signal(object)  # PickedPoint or None
    menu_requested = Signal(object, object)  # PickedPoint or None, and QPoint on the screen

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self.camera = Camera(np.zeros(3), 0.0, float(np.radians(VIEWS_DEG["isometric"][1])), 50.0)
        self.pictures = [Picture()]
        self.station: Array = np.zeros(3)
        self.free_strip_px, self.fit_margin = FREE_STRIP_PX, FIT_MARGIN
        self._widget = widget
        self._dragged = self.pictures[0]
        self._pivot: Array = np.zeros(3)
        self._fitted_points: Array | None = None
        self._kept_size, self._kept_until = self.widget_size, 0.0
        self._extent_sample: tuple[Mapping[str, Array], Array] | None = None
        self.history = ViewHistory(lambda: StoredView(self.camera, self._fitted_points), self)
        self.move_ended.connect(self.history.store_later)
        self.mouse = ViewportMouse(widget)
        self.mouse.key_position = self._middle_of_view
        self.mouse.history_requested.connect(self.step_view)
        self.mouse.drag_started.connect(self._on_drag_started)
        self.mouse.rotated.connect(self._on_rotated)
        self.mouse.panned.connect(self._on_panned)
        self.mouse.drag_ended.connect(self.move_ended)
        self.mouse.zoomed.connect(self._on_zoomed)
        self.mouse.picked.connect(self._on_picked)
        self.mouse.centred.connect(self._on_centred)
        self.mouse.pointed.connect(self._on_pointed)
        self.mouse.menu_requested.connect(
            lambda x, y: self.menu_requested.emit(self.point_at(x, y), self._screen_place(x, y))
        )

    @property
    def coarse(self) -> Mapping[str, Array]:
        """Thinned points (n, 3) of the visible lines."""
        return self.pictures[0].coarse

    @property
    def widget_size(self) -> ViewportSize:
        """Size of the widget; at least one pixel."""
        return ViewportSize(max(self._widget.width(), 1), max(self._widget.height(), 1))

    @property
    def size(self) -> ViewportSize:
        """Size of the picture of the camera."""
        return self.size_of(self.pictures[0])

    def size_of(self, picture: Picture) -> ViewportSize:
        """Size of a picture."""
        return picture.size(self.widget_size)

    def camera_of(self, picture: Picture) -> Camera:
        """Camera of a picture."""
        return picture.camera(self.camera, self.widget_size)

    def find_centres(self) -> None:
        """Find the surface in the middle of each picture, at whose depth its scale bar is valid."""
        for each in self.pictures:
            camera, size = self.camera_of(each), self.size_of(each)
            # All points in a close view, in which the thinned ones are sparse
            points = each.drawn()
            if sum(map(len, points.values())) > MAX_CENTRAL_POINTS:
                points = each.coarse
            each.centre = None if camera.parallel else central_point(points, camera, size)

    def scale_depth(self, picture: Picture) -> float | None:
        """Depth at which the scale bar of a picture is valid, metres; None if it has no surface.

        It does not depend on clicks: while the camera moves, it is the depth of the surface that
        was in the middle before. In a parallel projection, the scale is the same at all depths.
        """
        camera = self.camera_of(picture)
        if camera.parallel:
            return camera.distance
        if picture.centre is None:
            return None
        depth = float((picture.centre - camera.position) @ camera.axes[2])
        return depth if depth > 0.0 else None

    def picture_at(self, x: float, y: float) -> Picture:
        """Picture at a pixel of the widget."""
        found = (each for each in self.pictures if each.contains(x, y, self.widget_size))
        return next(found, self.pictures[0])

    def local(self, picture: Picture, x: float, y: float) -> tuple[float, float]:
        """Pixel of a picture at a pixel of the widget."""
        return picture.local(x, y, self.widget_size)

    def show_pictures(self, pictures: list[Picture]) -> None:
        """Divide the widget into pictures; the first is that of the camera."""
        self.pictures, self._dragged = pictures, pictures[0]
        self.refit()

    def fit(self, points: Array | None = None) -> None:
        """Bring everything, or points of shape (n, 3), into view.

        The points remain in view when the size of the widget changes, until the camera is moved.
        """
        target = self._extent_points() if points is None else np.asarray(points, dtype=np.float64)
        if len(target):
            self.history.store_pending()
            self._fitted_points = target
            self.refit()
            self.history.store()

    def refit(self) -> None:
        """Bring the fitted points into view again after a change of size."""
        if self._fitted_points is not None:
            bottom = min(self.free_strip_px, MAX_FREE_SHARE * self.size.height)
            self.camera = self.camera.fitted(
                self._fitted_points, self.size, self.fit_margin, bottom
            )

    def keep_picture(self) -> None:
        """Keep the scene in place while a panel that opens takes a part of the widget.

        Exactly in place are the points as far away as the surface under the mouse, or as the one in
        the middle of the picture. If the panel would cover a selected surface, the scene is shifted
        just enough for it to remain visible.
        """
        place = self._widget.mapFromGlobal(QCursor.pos())
        inside = self._widget.rect().contains(place)
        x, y = (place.x(), place.y()) if inside else self._middle_of_view()
        depth = float(self.camera.project(self._surface_at(x, y), self.size)[0, 2])
        self.camera = self.camera.with_focal_depth(depth)
        self._kept_size, self._kept_until = self.size, time.monotonic() + KEPT_TIME_S

    def on_resized(self, selected: Array) -> None:
        """Bring the fitted points into view again, unless the scene stays in place.

        Parameters
        ----------
        selected : ndarray of shape (n, 3), metres, local frame
            Points of the selected surface; see `keep_picture`.
        """
        if time.monotonic() > self._kept_until:
            self.refit()
        elif self.size != self._kept_size:
            was_visible = self._is_visible(selected, self._kept_size)
            self.camera = self.camera.resized(self._kept_size, self.size)
            if was_visible:
                self.camera = self.camera.revealing(selected, self.size, REVEALED_MARGIN_PX)
            self._kept_size, self._fitted_points = self.size, None

    def _is_visible(self, points: Array, size: ViewportSize) -> bool:
        """Whether the middle of points (n, 3) is in a picture of a size."""
        if len(points) == 0:
            return False
        x, y, _ = self.camera.project(points.mean(axis=0), size)[0]
        return bool(0.0 <= x <= size.width and 0.0 <= y <= size.height)  # NaN behind the eye

    def clear_fit(self) -> None:
        """Stop keeping the fitted points in view, and discard the former views."""
        self._fitted_points = self._extent_sample = None
        self.history.clear()

    def step_view(self, steps: int) -> None:
        """Show a former or later view, in the present projection."""
        view = self.history.step(steps)
        if view is not None:
            self._show_view(view)

    def copy_view_from(self, former: "Navigator") -> None:
        """Take over the camera and the former views of another navigator."""
        self.history.copy_from(former.history)
        self.camera = former.camera
        self._show_view(StoredView(former.camera, former._fitted_points))

    def _show_view(self, view: StoredView) -> None:
        self.camera = view.camera.with_projection(parallel=self.camera.parallel)
        self._fitted_points = view.fitted
        self.refit()
        self.view_restored.emit()

    def view(self, name: str) -> None:
        """Look at everything from a standard direction."""
        self.history.store_pending()
        if name == "top":
            azimuth, elevation = 0.0, 0.5 * np.pi
        else:
            turn, elevation = np.radians(VIEWS_DEG[name])
            azimuth = self._front_azimuth() + turn
        self.camera = replace(self.camera, azimuth=float(azimuth), elevation=float(elevation))
        self.fit()

    def view_along(self, direction: Array, points: Array) -> None:
        """Look at points (n, 3) along a direction, shape (3,), from the station's side of them."""
        self.history.store_pending()
        from_station = points.mean(axis=0) - self.station
        self.camera = self.camera.along(direction if direction @ from_station >= 0 else -direction)
        self.fit(points)

    def project_parallel(self, parallel: bool) -> None:
        """Change to a parallel projection, or back to perspective."""
        self.camera = self.camera.with_projection(parallel=parallel)
        self.refit()

    def _extent_points(self) -> Array:
        """Sample of the coarse points without the outermost ones, cached."""
        if self._extent_sample is None or self._extent_sample[0] is not self.coarse:
            self._extent_sample = self.coarse, self._thinned_points()
        return self._extent_sample[1]

    def _thinned_points(self) -> Array:
        total = sum(map(len, self.coarse.values()))
        share = min(1.0, MAX_FIT_POINTS / total) if total else 1.0
        parts = [points[: int(np.ceil(share * len(points)))] for points in self.coarse.values()]
        return trimmed_points(np.concatenate(parts)) if parts else np.empty((0, 3))

    def _front_azimuth(self) -> float:
        everything = self._extent_points()
        if len(everything) == 0:
            return 0.0
        north, west, _ = np.median(everything, axis=0) - self.station
        return float(np.arctan2(-west, north)) if np.hypot(north, west) > 1.0 else 0.0

    def _middle_of_view(self) -> tuple[float, float]:
        """Pixel of the widget in the middle of the picture of the camera."""
        middle = self.pictures[0].rect(self.widget_size).center()
        return middle.x(), middle.y()

    def _on_drag_started(self, x: float, y: float) -> None:
        self._dragged = self.picture_at(x, y)
        if self._dragged.turns:
            self._pivot = self._surface_at(x, y)
            depth = self.camera.project(self._pivot, self.size)[0, 2]
            self.camera = self.camera.with_focal_depth(float(depth))

    def _on_rotated(self, dx: float, dy: float) -> None:
        if self._dragged.turns:
            self._set_camera(self.camera.orbited(dx, dy, self._pivot))
        else:
            self._on_panned(dx, dy)

    def _on_panned(self, dx: float, dy: float) -> None:
        picture = self._dragged
        camera = self.camera_of(picture)
        self._move(picture, camera.panned(dx, dy, camera.focal_depth, self.size_of(picture)))

    def _on_zoomed(self, notches: float, x: float, y: float) -> None:
        picture = self.picture_at(x, y)
        camera, factor = self.camera_of(picture), WHEEL_FACTOR**notches
        self._move(picture, camera.zoomed(factor, self._surface_at(x, y)))
        self.move_ended.emit()

    def _on_centred(self, x: float, y: float) -> None:
        picture = self.picture_at(x, y)
        camera, size = self.camera_of(picture), self.size_of(picture)
        hit = pick_point(picture.clouds, camera, *self.local(picture, x, y), size)
        if hit is not None:
            focal = picture.clouds[hit.line][hit.index]
            self._move(picture, camera.centred(focal, 0.6, hit.depth))
            self.move_ended.emit()

    def _on_picked(self, x: float, y: float) -> None:
        point = self.point_at(x, y)
        if point is None:
            self.missed.emit(self._screen_place(x, y))
        else:
            self.picked.emit(point)

    def _on_pointed(self, x: float, y: float) -> None:
        point = self.point_at(x, y, as_shown=True)
        self.pointed.emit(point)
        if point is None:
            self.missed.emit(self._screen_place(x, y))

    def _screen_place(self, x: float, y: float) -> QPoint:
        return self._widget.mapToGlobal(QPoint(round(x), round(y)))

    def point_at(self, x: float, y: float, *, as_shown: bool = False) -> PickedPoint | None:
        """Point at a pixel of the widget, in the placement of the view or as it is shown."""
        picture = self.picture_at(x, y)
        hit = pick_point(
            picture.clouds, self.camera_of(picture), *self.local(picture, x, y),
            self.size_of(picture),
        )  # fmt: skip
        if hit is None:
            return None
        place = picture.clouds[hit.line][hit.index]
        if not as_shown:
            place = picture.place_in_view(hit.line, place)
        north, west, up = (float(v) for v in place)
        return PickedPoint(hit.line, (north, west, up))

    def _surface_at(self, x: float, y: float) -> Array:
        """Surface point at a pixel, or the point behind it at the focal depth."""
        picture = self.picture_at(x, y)
        camera, size = self.camera_of(picture), self.size_of(picture)
        x, y = self.local(picture, x, y)
        hit = pick_point(picture.coarse, camera, x, y, size, SNAP_RADII_PX)
        if hit is not None:
            surface: Array = picture.coarse[hit.line][hit.index]
            return surface
        return camera.point_at(x, y, camera.focal_depth, size)

    def _move(self, picture: Picture, camera: Camera) -> None:
        """Set the camera of a picture."""
        if picture.is_separate:
            picture.move_separately(camera)
            self.moved.emit()
        else:
            self._set_camera(picture.moved_view(self.camera, camera))

    def _set_camera(self, camera: Camera) -> None:
        self.camera = camera
        self._fitted_points = None
        self.moved.emit()
