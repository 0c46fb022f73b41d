"""Number of points per frame on this computer, from the times of the last frames.

A graphics card draws the whole budget in no time. Software OpenGL draws one to three million points
a second, fewer where the processor has other work, so that a fixed number is too many or too few.
"""

from collections import deque
from typing import Literal

from lispac.gui.viewport.decimation import Budget

Kind = Literal["moving", "resting"]

TARGET_FRAME_S: dict[Kind, float] = {"moving": 0.07, "resting": 0.14}
"""Target time of a frame; selecting the points and Qt take a third as long again. Above 0.2 s the
window seems to hang each time the view comes to rest."""

MAX_PICTURE_S = 1.0
"""Longest time to draw a picture for a file."""

MIN_POINTS: dict[Kind, int] = {"moving": 20_000, "resting": 100_000}
"""Smallest number of points, drawn however long it takes: fewer show no shape."""

MIN_TIMED_POINTS = 10_000
"""Frames with fewer points are not timed: their time depends on other work."""

FRAMES_KEPT = 3
"""Number of stored frames; the fastest counts, as other work slows some of them."""

SLICE_FRACTIONS = (0.0625, 0.125, 0.25, 0.5, 1.0)
"""Shares of the points drawn while the camera moves, ascending."""

SLICE_HYSTERESIS = 0.7
"""Share of the time limit that a larger slice must meet: prevents switching back and forth."""


class FrameTimes:
    """Stores the times of frames and derives the number of points to draw.

    Attributes
    ----------
    slice : how many of `SLICE_FRACTIONS` are drawn while the camera moves, less one
    """

    def __init__(self, budget: Budget) -> None:
        self._budget = budget
        self._rates: dict[Kind, deque[float]] = {
            "moving": deque(maxlen=FRAMES_KEPT),
            "resting": deque(maxlen=FRAMES_KEPT),
        }
        self.slice = len(SLICE_FRACTIONS) - 1

    @property
    def rest_points(self) -> int:
        """Number of points for a frame at rest."""
        return self._points_within(TARGET_FRAME_S["resting"])

    @property
    def picture_points(self) -> int:
        """Number of points for a picture that is saved."""
        return self._points_within(MAX_PICTURE_S)

    def _points_within(self, seconds: float) -> int:
        rates = self._rates["resting"]
        # At rest each point is drawn twice, with its rim.
        rate = max(rates) if rates else 0.5 * max(self._rates["moving"], default=float("inf"))
        fitting = min(rate * seconds, self._budget.resting)
        return max(int(fitting), min(MIN_POINTS["resting"], self._budget.resting))

    def record(self, kind: Kind, points: int, seconds: float, whole: int = 0) -> None:
        """Record the time of a frame.

        Parameters
        ----------
        points : drawn in it
        whole : points drawn while the camera moves where all slices are
        """
        if points < MIN_TIMED_POINTS or seconds <= 0.0:
            return
        self._rates[kind].append(points / seconds)
        if kind == "moving":
            self.slice = self._fitting_slice(whole)

    def _fitting_slice(self, whole: int) -> int:
        fitting = max(self._rates["moving"]) * TARGET_FRAME_S["moving"]
        chosen = 0
        for k, part in enumerate(SLICE_FRACTIONS):
            limit = fitting if k <= self.slice else SLICE_HYSTERESIS * fitting
            if part * whole <= max(limit, MIN_POINTS["moving"]):
                chosen = k
        return chosen
