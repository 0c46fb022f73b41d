"""Distances and angles measured with clicks on points."""

from collections.abc import Callable

import numpy as np
from PySide6.QtCore import QObject

from lispac.errors import InputError
from lispac.geometry import measuring
from lispac.gui import units
from lispac.gui.actions import Actions
from lispac.gui.pointing import Pointing
from lispac.gui.viewport.base import Array, Colour, PickedPoint, Sketch, Viewport

COLOUR: Colour = (0, 90, 200)
SKETCH = "measure"
HINTS = {
    "measure_distance": ("Click the first point", "Click the second point"),
    "measure_angle": (
        "Click a point on the first side", "Click the corner", "Click a point on the second side",
    ),
}  # fmt: skip
AGAIN = "Click to measure again"


class Measuring(QObject):
    """Two clicks give a distance, three an angle; the next click begins anew."""

    def __init__(
        self,
        viewport: Viewport,
        actions: Actions,
        pointing: Pointing,
        note: Callable[[str], None],
    ) -> None:
        super().__init__(actions)
        self._viewport, self._pointing, self._note = viewport, pointing, note
        self._points: list[Array] = []
        for tool in HINTS:
            actions[tool].triggered.connect(lambda on, tool=tool: self._switch(tool, on))

    def restart(self) -> None:
        """Forget the points: the lines lie elsewhere now."""
        self._points = []
        self._viewport.show_sketch(SKETCH, None)
        if self._pointing.tool in HINTS:
            self._pointing.hint(HINTS[self._pointing.tool][0])

    def _switch(self, tool: str, on: bool) -> None:
        if on:
            self._pointing.begin(tool, HINTS[tool][0], pointed=self._take, ended=self.restart)
        else:
            self._pointing.end()

    def _take(self, point: PickedPoint) -> None:
        tool = self._pointing.tool
        wanted = len(HINTS[tool])
        if len(self._points) == wanted:
            self._points = []
        self._points.append(np.array(point.position))
        words = metric = ""
        if len(self._points) == wanted:
            try:
                tell = angle_words if wanted == 3 else distance_words
                words = tell(*self._points)
                with units.standard():
                    metric = tell(*self._points)
            except InputError as error:
                self._note(str(error))
                self.restart()
                return
            self._note(words.replace("\n", ", "))
        hints = (*HINTS[tool], AGAIN)
        self._pointing.hint(hints[len(self._points)])
        self._viewport.show_sketch(SKETCH, _sketch(self._points, words, metric))


def distance_words(first: Array, second: Array) -> str:
    """A distance with its parts, a line each."""
    found = measuring.distance(first, second)
    slope, level = (units.figure(each, "m", ".3f") for each in (found.slope, found.horizontal))
    up = units.figure(found.vertical, "m", "+.3f").replace("-", "\N{MINUS SIGN}")
    sign = units.unit("m").sign
    return (
        f"Slope distance {slope} {sign}\nHorizontal {level} {sign}\n"
        f"Vertical {up} {sign}\nAzimuth {np.degrees(found.azimuth):.2f}°"
    )


def angle_words(first: Array, corner: Array, second: Array) -> str:
    """An angle and the lengths of its sides, a line each."""
    turned = np.degrees(measuring.angle(first, corner, second))
    sides = [measuring.distance(corner, end).slope for end in (first, second)]
    a, b = (units.figure(each, "m", ".3f") for each in sides)
    sign = units.unit("m").sign
    return f"Angle {turned:.2f}°\nSides {a} {sign} and {b} {sign}"


def _sketch(points: list[Array], words: str, metric: str) -> Sketch:
    places = tuple((float(p[0]), float(p[1]), float(p[2])) for p in points)
    edges = tuple((k, k + 1) for k in range(len(places) - 1))
    at = None
    if words:
        middle = points[1] if len(points) == 3 else 0.5 * (points[0] + points[1])
        at = (float(middle[0]), float(middle[1]), float(middle[2]))
    return Sketch(places, edges, COLOUR, dots=True, label=words, at=at, metric=metric)
