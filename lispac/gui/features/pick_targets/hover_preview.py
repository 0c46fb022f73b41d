"""Preview of the plane that a click would pick, fitted to the points drawn in the view."""

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject

from lispac.errors import LispacError
from lispac.geometry.planes import plane_axes
from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.appearance.theme import CANDIDATE_COLOUR
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.viewport.base import Array, PickedPoint, Sketch, Viewport
from lispac.language import gettext
from lispac.progress import Progress
from lispac.targets.plane_finder import FinderSettings, PlanePatch, find_plane

SKETCH_NAME = "hover"
MAX_POINTS = 2_000
"""Largest number of points passed to the finder, for a short response time."""
MIN_POINTS = 30
"""Smallest number of points for a plane."""


@dataclass(frozen=True)
class HoverPreviewSettings:
    """Search settings of step 2 that the preview under the mouse uses.

    Attributes
    ----------
    threshold : float or None, metres
        Largest distance of a point from the plane; None for the default.
    radius : float or None, metres
        Largest distance of a point from the point under the mouse; None for the default.
    is_plane : bool
        Whether planes are picked; spheres have no preview.
    """

    threshold: float | None
    radius: float | None
    is_plane: bool


class HoverPreview(QObject):
    """Outlines the plane under the mouse, with approximate sizes from the drawn points.

    Attributes
    ----------
    seconds : duration of the last preview
    """

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        viewport: Viewport,
        actions: Actions,
        settings: Callable[[], HoverPreviewSettings],
        controller: Controller,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner, self._settings = document, runner, settings
        self._viewport, self._action = viewport, actions["hover"]
        self._controller = controller
        self._is_prepared = self._is_on = False
        self.seconds = 0.0
        viewport.signals.hovered.connect(self._show_preview)
        self._action.triggered.connect(lambda _on: self._toggle_tool())
        runner.idle.connect(self._toggle_tool)  # if the preparation was interrupted by other work
        controller.candidate_changed.connect(lambda: viewport.show_sketch(SKETCH_NAME, None))

    def _toggle_tool(self) -> None:
        on = self._action.isChecked()
        if on and not self._is_prepared:
            self._runner.run(
                gettext("Preparing the preview"),
                _prepare_finder,
                self._on_prepared,
                quiet=True,
                key="hover",
            )
        elif on != self._is_on:
            self._is_on = on
            if not on:
                self._viewport.show_sketch(SKETCH_NAME, None)

    def _on_prepared(self, _nothing: object) -> None:
        self._is_prepared = True
        self._toggle_tool()

    def _show_preview(self, point: PickedPoint | None) -> None:
        if not self._is_on:
            return
        start = time.perf_counter()
        self._viewport.show_sketch(SKETCH_NAME, None if point is None else self._preview(point))
        self.seconds = time.perf_counter() - start

    def _preview(self, point: PickedPoint) -> Sketch | None:
        project, hover_settings = self._document.project, self._settings()
        if project is None or not hover_settings.is_plane or self._is_on_candidate(point):
            return None
        usual = FinderSettings()
        radius = hover_settings.radius or usual.radius
        seed = np.array(point.position)
        near = self._viewport.drawn_near(point.line, seed, radius)
        # Contiguous, since the finder would be compiled in this thread for other memory layouts
        near = np.ascontiguousarray(near[:: -(-len(near) // MAX_POINTS) or 1])
        settings = FinderSettings(
            threshold=hover_settings.threshold or project.settings.threshold, radius=radius,
            min_points=min(MIN_POINTS, usual.min_points),
        )  # fmt: skip
        try:
            patch = find_plane(near, seed, settings)
        except LispacError:
            return None
        return patch_sketch(near, patch, point.line)

    def _is_on_candidate(self, point: PickedPoint) -> bool:
        """Whether the point is near the candidate, whose label would overlap the preview."""
        candidate = self._controller.candidate
        if candidate is None:
            return False
        return float(np.linalg.norm(np.subtract(point.position, candidate.seed))) < candidate.radius


def _prepare_finder(_progress: Progress) -> None:
    """Load the compiled parts of the finder, which takes seconds the first time."""
    across = np.linspace(-0.5, 0.5, 30)
    board = np.stack(np.meshgrid(across, [0.0], across, indexing="ij"), axis=-1).reshape(-1, 3)
    patch = find_plane(board, np.zeros(3), FinderSettings())
    patch_sketch(board, patch, "")


def patch_sketch(points: Array, patch: PlanePatch, line: str) -> Sketch:
    """Sketch of the outline of a patch with its size."""
    from scipy.spatial import ConvexHull

    axes = plane_axes(patch.plane.normal)
    flat = (points[patch.indices] - patch.centre) @ axes.T
    corners = patch.centre + flat[ConvexHull(flat).vertices] @ axes
    places = tuple((float(x), float(y), float(z)) for x, y, z in corners)
    count = len(places)
    width, height = patch.extent[:2]
    text = gettext(
        "Plane of about {width:m.1} × {height:m.1} m in {line}",
        width=width,
        height=height,
        line=line,
    )
    top = places[int(np.argmax(corners[:, 2]))]
    edges = tuple((k, (k + 1) % count) for k in range(count))
    return Sketch(places, edges, CANDIDATE_COLOUR, label=text, label_point=top)
