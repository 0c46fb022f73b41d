"""Distances and angles measured with clicks on points."""

from collections.abc import Callable

import numpy as np
from PySide6.QtCore import QObject

from lispac.errors import InputError
from lispac.geometry import point_measurements
from lispac.gui.app.actions import Actions
from lispac.gui.app.mouse_tool import MouseTool
from lispac.gui.appearance import theme, units
from lispac.gui.viewport.base import Array, PickedPoint, Sketch, Viewport
from lispac.gui.widgets.error_box import exception_text
from lispac.language import N_, gettext

SKETCH_NAME = "measure"
HINTS = {
    "measure_distance": (N_("Click the first point"), N_("Click the second point")),
    "measure_angle": (
        N_("Click a point on the first side of the angle"),
        N_("Click the vertex of the angle"),
        N_("Click a point on the second side of the angle"),
    ),
}
"""Hint for each click, by the name of the tool."""
REPEAT_HINT = N_("Click to measure again")


class Measurements(QObject):
    """Measures a distance with two clicks or an angle with three."""

    def __init__(
        self,
        viewport: Viewport,
        actions: Actions,
        mouse_tool: MouseTool,
        note: Callable[[str], None],
    ) -> None:
        super().__init__(actions)
        self._viewport, self._mouse_tool, self._note = viewport, mouse_tool, note
        self._points: list[Array] = []
        for tool in HINTS:
            actions[tool].triggered.connect(lambda on, tool=tool: self._toggle_tool(tool, on))

    def restart(self) -> None:
        """Clear the points, because the lines have moved."""
        self._points = []
        self._viewport.show_sketch(SKETCH_NAME, None)
        if self._mouse_tool.tool in HINTS:
            self._mouse_tool.hint(gettext(HINTS[self._mouse_tool.tool][0]))

    def _toggle_tool(self, tool: str, on: bool) -> None:
        if on:
            hint = gettext(HINTS[tool][0])
            self._mouse_tool.begin(tool, hint, pointed=self._add_point, ended=self.restart)
        else:
            self._mouse_tool.end()

    def _add_point(self, point: PickedPoint) -> None:
        tool = self._mouse_tool.tool
        needed = len(HINTS[tool])
        if len(self._points) == needed:
            self._points = []
        self._points.append(np.array(point.position))
        self._show_points()

    def copy_state_from(self, former: "Measurements") -> None:
        """Take over the clicked points of a former window, for the same tool."""
        if former._points and self._mouse_tool.tool in HINTS:
            self._points = list(former._points)
            self._show_points()

    def _show_points(self) -> None:
        tool = self._mouse_tool.tool
        needed = len(HINTS[tool])
        text = metric = ""
        if len(self._points) == needed:
            try:
                measure = angle_text if needed == 3 else distance_text
                text = measure(*self._points)
                with units.standard_units():
                    metric = measure(*self._points)
            except InputError as error:
                self._note(exception_text(error))
                self.restart()
                return
            one_line = text.replace("\n", ", ")
            self._note(one_line)
        hints = (*HINTS[tool], REPEAT_HINT)
        self._mouse_tool.hint(gettext(hints[len(self._points)]))
        self._viewport.show_sketch(SKETCH_NAME, _measurement_sketch(self._points, text, metric))


def distance_text(first: Array, second: Array) -> str:
    """Text of a distance and its components, one on each line."""
    found = point_measurements.measure_distance(first, second)
    vertical = units.local_amount(found.vertical, "m", "+.3f")
    return gettext(
        "Slope distance {slope}\nHorizontal {horizontal}\nVertical {vertical}\n"
        "Azimuth {azimuth:deg.2}°",
        slope=units.local_amount(found.slope, "m", ".3f"),
        horizontal=units.local_amount(found.horizontal, "m", ".3f"),
        vertical=vertical,
        azimuth=found.azimuth,
    )


def angle_text(first: Array, vertex: Array, second: Array) -> str:
    """Text of an angle and the lengths of its sides, one on each line."""
    sides = [point_measurements.measure_distance(vertex, end).slope for end in (first, second)]
    one, other = (units.local_amount(each, "m", ".3f") for each in sides)
    return gettext(
        "Angle {angle:deg.2}°\nSides {first} and {second}",
        angle=point_measurements.measure_angle(first, vertex, second),
        first=one,
        second=other,
    )


def _measurement_sketch(points: list[Array], text: str, metric: str) -> Sketch:
    places = tuple((float(p[0]), float(p[1]), float(p[2])) for p in points)
    edges = tuple((k, k + 1) for k in range(len(places) - 1))
    label_point = None
    if text:
        middle = points[1] if len(points) == 3 else 0.5 * (points[0] + points[1])
        label_point = (float(middle[0]), float(middle[1]), float(middle[2]))
    return Sketch(
        places, edges, theme.rgb("accent"), dots=True, label=text, label_point=label_point,
        metric=metric,
    )  # fmt: skip
