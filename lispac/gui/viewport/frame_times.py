"""Number of points per frame on this computer, from the times of the last frames.

A graphics card draws the whole budget in no time. Software OpenGL draws one to three million points
a second, fewer where the processor has other work, so that a fixed number is too many or too few.
"""

from collections import deque
from typing import Literal

from lispac.gui.viewport.decimation import Budget

Kind = Literal["moving", "resting"]

AIM_S: dict[Kind, float] = {"moving": 0.07, "resting": 0.14}
"""What drawing a frame is to take; choosing the points and Qt take a third as long again. Longer
than 0.2 s and the window is felt to hang each time the view comes to rest."""

PICTURE_S = 1.0
"""What drawing a picture for a file may take: there is one of them, and it stays."""

LEAST: dict[Kind, int] = {"moving": 20_000, "resting": 100_000}
"""Points below which nothing could be made out; they are drawn however long it takes."""

JUDGED = 10_000
"""Frames of fewer points are not used: their time depends on other work."""

LAST = 3
"""Frames remembered; the fastest counts, for what else the processor does slows some of them."""

SLICES = (0.0625, 0.125, 0.25, 0.5, 1.0)
"""Parts of the points for moving that are drawn, the least first."""

EASE = 0.7
"""Part of the time a larger slice has to fit into before it is drawn: it is not to come and go."""


class FrameTimes:
    """Stores the times of frames and derives the number of points to draw.

    Attributes
    ----------
    slice : how many of `SLICES` are drawn while the camera moves, less one
    """

    def __init__(self, budget: Budget) -> None:
        self._budget = budget
        self._rates: dict[Kind, deque[float]] = {
            "moving": deque(maxlen=LAST),
            "resting": deque(maxlen=LAST),
        }
        self.slice = len(SLICES) - 1

    @property
    def resting(self) -> int:
        """Number of points for a frame at rest."""
        return self._points_within(AIM_S["resting"])

    @property
    def picture(self) -> int:
        """Number of points for a picture that is saved."""
        return self._points_within(PICTURE_S)

    def _points_within(self, seconds: float) -> int:
        rates = self._rates["resting"]
        # At rest each point is drawn twice, with its rim.
        rate = max(rates) if rates else 0.5 * max(self._rates["moving"], default=float("inf"))
        fitting = min(rate * seconds, self._budget.resting)
        return max(int(fitting), min(LEAST["resting"], self._budget.resting))

    def took(self, kind: Kind, points: int, seconds: float, whole: int = 0) -> None:
        """Record the time of a frame.

        Parameters
        ----------
        points : drawn in it
        whole : points drawn while the camera moves where all slices are
        """
        if points < JUDGED or seconds <= 0.0:
            return
        self._rates[kind].append(points / seconds)
        if kind == "moving":
            self.slice = self._fitting_slice(whole)

    def _fitting_slice(self, whole: int) -> int:
        fitting = max(self._rates["moving"]) * AIM_S["moving"]
        chosen = 0
        for k, part in enumerate(SLICES):
            room = fitting if k <= self.slice else EASE * fitting
            if part * whole <= max(room, LEAST["moving"]):
                chosen = k
        return chosen
