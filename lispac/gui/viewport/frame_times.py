"""Number of points per frame on this computer, from the times of the last frames.

A graphics card draws the whole budget immediately. Software OpenGL draws one to three million
points a second, or fewer if the processor is busy, so that no fixed number would be suitable.
"""

from collections import deque
from typing import Literal

from lispac.gui.viewport.decimation import Budget

Kind = Literal["moving", "resting"]

TARGET_FRAME_S: dict[Kind, float] = {"moving": 0.07, "resting": 0.14}
"""Target time for drawing a frame. The selection of points and the work of Qt add a third. If the
total exceeds 0.2 s, the window seems to hang each time the view comes to rest."""

MAX_PICTURE_S = 1.0
"""Longest time to draw a picture for a file."""

MIN_POINTS: dict[Kind, int] = {"moving": 20_000, "resting": 100_000}
"""Smallest number of drawn points, independent of the time: fewer points show no shapes."""

MIN_TIMED_POINTS = 10_000
"""Frames with fewer points are not timed, since other work dominates their time."""

FRAMES_KEPT = 3
"""Number of stored frame times; the fastest is used, since other work slows some frames."""

SLICE_FRACTIONS = (0.0625, 0.125, 0.25, 0.5, 1.0)
"""Shares of the coarse points that can be drawn while the camera moves, ascending."""

SLICE_HYSTERESIS = 0.7
"""Factor on the limit for a change to a larger slice, which prevents repeated switching."""


class FrameTimes:
    """Stores the times of frames and derives the number of points to draw.

    Attributes
    ----------
    slice : index of the fraction in `SLICE_FRACTIONS` that is drawn while the camera moves
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
        # At rest, each point is drawn twice: with its rim.
        rate = max(rates) if rates else 0.5 * max(self._rates["moving"], default=float("inf"))
        fitting = min(rate * seconds, self._budget.resting)
        return max(int(fitting), min(MIN_POINTS["resting"], self._budget.resting))

    def record(self, kind: Kind, points: int, seconds: float, whole: int = 0) -> None:
        """Record the time of a frame.

        Parameters
        ----------
        points : number of points drawn in the frame
        whole : number of points in all slices that can be drawn while the camera moves
        """
        if points < MIN_TIMED_POINTS or seconds <= 0.0:
            return
        self._rates[kind].append(points / seconds)
        if kind == "moving":
            self.slice = self._fitting_slice(whole)

    def _fitting_slice(self, whole: int) -> int:
        fitting = max(self._rates["moving"]) * TARGET_FRAME_S["moving"]
        chosen = 0
        for k, fraction in enumerate(SLICE_FRACTIONS):
            limit = fitting if k <= self.slice else SLICE_HYSTERESIS * fitting
            if fraction * whole <= max(limit, MIN_POINTS["moving"]):
                chosen = k
        return chosen
