"""Interface of the 3D viewport, implemented with VTK and, for tests, without graphics."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget

from lispac.gui.appearance import theme
from lispac.gui.appearance.colour_schemes import Colour as Colour
from lispac.gui.viewport.clipping import Box
from lispac.picked_targets import Role

Array = NDArray[np.float64]
Place = Array | tuple[float, float, float]
"""Position of shape (3,), metres, local frame."""
SHADED_EDGE_COLOUR: Colour = (62, 70, 78)
"""Colour of the edges of points that have a colour for each point."""


@dataclass(frozen=True)
class PickedPoint:
    """Point under the mouse: its line and its local coordinates in metres."""

    line: str
    position: tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class Highlight:
    """Points of one sighting that are drawn over the clouds.

    Attributes
    ----------
    key : (target name, line name); a proposed target has a key instead of its name
    points : ndarray of shape (n, 3), metres, local frame
    colour : colour of the points: that of their line, so that differences of the lines stay visible
    halo : colour of the outline, which shows that the points belong to a target
    shades : uint8 ndarray of shape (n, 3), optional
        A colour of its own for each point.
    """

    key: tuple[str, str]
    points: Array
    colour: Colour
    halo: Colour
    shades: NDArray[np.uint8] | None = None


@dataclass(frozen=True, eq=False)
class PointColouring:
    """Colours of points that replace the colours of their lines, with a legend.

    Attributes
    ----------
    colours : mapping of line name to uint8 ndarray of shape (n, 3)
    title : name of the coloured quantity, with its unit
    low, high : texts at the ends of the scale
    scale : uint8 ndarray of shape (m, 3)
        Colours from low to high.
    metric : texts at the ends in the metric unit of the title, for pictures in files, if ``low``
        and ``high`` are in another unit
    ends : values at the ends of the scale, in the unit of the data
    """

    colours: Mapping[str, NDArray[np.uint8]]
    title: str
    low: str
    high: str
    scale: NDArray[np.uint8]
    metric: tuple[str, str] | None = None
    ends: tuple[float, float] = (0.0, 1.0)

    def of_values(self, values: Array) -> NDArray[np.uint8]:
        """Colours (n, 3) of values (n,)."""
        low, high = self.ends
        places = np.clip((values - low) * (len(self.scale) / (high - low or 1.0)), 0, None)
        shades: NDArray[np.uint8] = self.scale[
            np.minimum(places, len(self.scale) - 1).astype(np.int64)
        ]
        return shades


@dataclass(frozen=True)
class Marker:
    """Labelled point: a seed or the name of a target.

    Attributes
    ----------
    is_provisional : whether it is a seed, a candidate or a proposed target, whose label gives way
        to those of the targets
    is_selected : whether it is filled, because its target is selected
    """

    label: str
    position: tuple[float, float, float]
    colour: Colour
    is_provisional: bool = False
    is_selected: bool = False


@dataclass(frozen=True)
class DragHandle:
    """Dot that the mouse moves along an axis, a unit vector of shape (3,)."""

    position: tuple[float, float, float]
    axis: tuple[float, float, float]


@dataclass(frozen=True)
class Sketch:
    """Straight lines over the picture, with a label and handles.

    Attributes
    ----------
    points : metres, local frame
    edges : pairs of indices of ``points``, joined by a line
    dots : whether the points are marked
    label, label_point : text, and the point beside which it is placed
    metric : label in metres, for pictures in files, if ``label`` is in another unit
    """

    points: tuple[tuple[float, float, float], ...]
    edges: tuple[tuple[int, int], ...]
    colour: Colour
    dots: bool = False
    label: str = ""
    label_point: tuple[float, float, float] | None = None
    handles: tuple[DragHandle, ...] = ()
    metric: str = ""


Direction = Literal["same", "top", "side", "section"]
"""Direction of a linked view: that of the camera, from above, horizontally in the direction of the
camera, or along the third axis of a box."""


@dataclass(frozen=True, eq=False)
class LinkedView:
    """One of several views of the lines, beside each other in a viewport.

    Attributes
    ----------
    title : text in its corner
    part : left, top, width and height, shares of the size of the viewport
    direction : direction in which it looks; its centre and scale are those of the camera, except
        for "section"
    clouds : other placement of the lines, with the same points in the same order; None for the
        lines of the viewport
    highlights : sightings in that placement; None for those of the viewport
    box : what a "section" shows; None for all points
    """

    title: str
    part: tuple[float, float, float, float]
    direction: Direction = "same"
    clouds: Mapping[str, Array] | None = None
    highlights: Sequence[Highlight] | None = None
    box: Box | None = None


MouseMode = Literal["navigate", "point", "outline"]
"""Action of the left button: rotate the view; rotate it and pick points; draw an outline."""

HALO_PIXELS, SELECTED_HALO_PIXELS = 1, 2
"""Width of the outline of a sighting, and of a selected one, pixels."""
DIMMED_SHARE = 0.3
"""Share of its own colour that a dimmed point keeps; the rest is that of the background."""


@dataclass(frozen=True)
class SightingStyle:
    """Style in which a sighting is drawn.

    Attributes
    ----------
    colour : colour of its points, unless they have separate colours
    extra_pixels : difference between the size of its points and that of the points of lines, pixels
    halo_pixels : width of its outline; 0 for none
    above : whether it is drawn over the other sightings
    """

    colour: Colour
    extra_pixels: int
    halo_pixels: int = 0
    above: bool = False


def sighting_style(highlight: Highlight, selected: tuple[str, str] | None) -> SightingStyle:
    """Style of a sighting while ``selected``, (target, line), is selected.

    The selection has a wide halo. The other sightings of the target of a selected sighting are
    dimmed.
    """
    if selected is None or highlight.key[0] != selected[0]:
        return SightingStyle(highlight.colour, 2, HALO_PIXELS)
    if selected[1] in ("", highlight.key[1]):
        return SightingStyle(highlight.colour, 4, SELECTED_HALO_PIXELS, above=bool(selected[1]))
    return SightingStyle(dimmed_colour(highlight.colour), 1)


def dimmed_colour(colour: Colour) -> Colour:
    """Colour that is mixed with the background of the view."""
    red, green, blue = (
        round(DIMMED_SHARE * own + (1.0 - DIMMED_SHARE) * ground)
        for own, ground in zip(colour, theme.rgb("ground"), strict=True)
    )
    return red, green, blue


class ViewportSignals(QObject):
    """Signals that a viewport emits to the window."""

    seed_clicked = Signal(object)  # PickedPoint, on Ctrl+click on a point
    missed = Signal(object)  # QPoint on the screen: a click that picks a point, in empty space
    pointed = Signal(object)  # PickedPoint, on a click in the mode "point"; None in empty space
    outlined = Signal(object)  # pixels (n, 2) of the outline that was drawn
    hovered = Signal(object)  # PickedPoint under the resting mouse, or None
    copy_requested = Signal()  # Ctrl+C while the view has the focus
    menu_requested = Signal(object, object)  # right click: PickedPoint or None, and QPoint
    help_used = Signal()  # first use of the mouse while the help is shown
    handle_moved = Signal(str, int, float)  # sketch, index of the handle, metres moved
    handle_released = Signal(str)  # sketch
    history_changed = Signal(bool, bool)  # whether there is a previous view and a next one


class Viewport(Protocol):
    """A 3D view of lines, targets and seeds, in the local frame."""

    signals: ViewportSignals

    @property
    def widget(self) -> QWidget:
        """Widget of the viewport, for the window."""

    def create_empty_viewport(self) -> "Viewport":
        """Create an empty viewport of the same kind."""

    def show_clouds(
        self,
        clouds: Mapping[str, Array],
        colours: Mapping[str, Colour],
        shading: PointColouring | None = None,
    ) -> None:
        """Draw the lines, each in its colour or shaded, instead of those shown; keep the camera."""

    def set_line_visible(self, line: str, visible: bool) -> None:
        """Show or hide one line."""

    def is_line_hidden(self, line: str) -> bool:
        """Whether a line is hidden."""

    def show_highlights(self, highlights: Sequence[Highlight]) -> None:
        """Draw sightings over the lines, instead of those shown."""

    def show_markers(self, markers: Sequence[Marker]) -> None:
        """Draw seeds and labels, instead of those shown."""

    def clip(self, box: Box | None) -> None:
        """Draw only the points in a box; None for all points."""

    def show_wipe(
        self, clouds: Mapping[str, Array] | None, highlights: Sequence[Highlight] = ()
    ) -> None:
        """Draw another placement of the lines to the left of a movable line; None ends it.

        The points must be the same, in the same order; they keep their colours.

        Parameters
        ----------
        highlights : sightings drawn over the other placement
        """

    def show_linked(self, views: Sequence[LinkedView]) -> None:
        """Show several linked views, the first of which is the view itself; one if it is empty.

        A picked point has the position of the lines of the viewport, whatever placement its view
        shows; in the mode "point", it has the position that is shown.
        """

    def select(self, key: tuple[str, str] | None) -> None:
        """Highlight one sighting, (target, line), and dim the others of its target.

        Line "" means all lines of the target.
        """

    def set_station(self, position: tuple[float, float, float]) -> None:
        """Set the position of the observer, usually the middle of the trajectory.

        The view "front" looks from this position at the lines; the other standard views are
        relative to "front". The default is the origin of the local frame.
        """

    def fit(self, points: Array | None = None) -> None:
        """Bring everything, or the given points of shape (n, 3), into view."""

    def keep_picture(self) -> None:
        """Keep the scene in place while a panel that opens takes a part of the view.

        If the panel would cover the selected surface, the scene is shifted just enough to show it.
        """

    def view(self, name: str) -> None:
        """Show a standard view: "top", "front", "back", "left", "right" or "isometric"."""

    def view_along(self, direction: Array, points: Array) -> None:
        """Look at points (n, 3) along a direction (3,), from the station's side of them."""

    def step_view(self, steps: int) -> None:
        """Go back (negative) or forward in the history of views, if there are so many.

        A view is stored when it is commanded, and once the user has stopped moving it.
        """

    def copy_view_from(self, former: "Viewport") -> None:
        """Take over the camera, the former views and the emphasised sighting of a viewport.

        Both are of the same kind.
        """

    def set_parallel(self, parallel: bool) -> None:
        """Draw in parallel (orthographic) projection, or in perspective."""

    def set_fit_margins(self, strip_px: float, factor: float) -> None:
        """Set the space that fitted points leave free, for the next fit.

        Parameters
        ----------
        strip_px : height of the strip at the bottom, pixels
        factor : factor of the distance of the camera
        """

    def set_mouse(self, mode: MouseMode, hint: str = "") -> None:
        """Set the mode of the left mouse button and the hint above the picture."""

    def show_seed_role(self, role: Role) -> None:
        """Name the surface that Ctrl+click picks, by its role, in the help on the mouse."""

    def show_help(self, shown: bool) -> None:
        """Show the help on the mouse, which fades after its first use, or hide it."""

    def show_line_legend(self, shown: bool) -> None:
        """Show or hide the legend of the lines, which is shown at first."""

    def drawn_near(self, line: str, centre: Place, radius: float) -> Array:
        """Drawn points of a line within a sphere, shape (n, 3)."""

    def show_sketch(self, name: str, sketch: Sketch | None) -> None:
        """Draw a sketch over the picture; None removes it."""

    def to_pixels(self, points: Array) -> Array:
        """Pixels (x, y) of points (n, 3); NaN behind the camera."""

    def set_point_size(self, pixels: int) -> None:
        """Set the size of the drawn points."""

    def set_point_budget(self, points: int) -> None:
        """Set the largest number of points drawn while the view rests."""

    def prepare(self) -> None:
        """Load all detail of a picture, so that it only needs to be drawn."""

    def picture(self, label_scale: float = 1.0) -> QImage:
        """Picture of the view with all detail and labels, without the help text.

        Parameters
        ----------
        label_scale : size of labels, axes and scale bar relative to that on the screen
        """

    def clear(self) -> None:
        """Remove all content."""

    def close(self) -> None:
        """Release the graphics; called before the window closes."""
