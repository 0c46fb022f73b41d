"""The site in 3D: the wall, targets with handles to move them, and the lines."""

from dataclasses import replace

import numpy as np
from PySide6.QtCore import QObject

from lispac.gui.appearance import theme
from lispac.gui.features.design import edits
from lispac.gui.features.design.canvas import Array
from lispac.gui.features.design.edits import PlacedTarget
from lispac.gui.features.design.wall_view import FINE_STEP_M, SNAP_STEP_M, moved_target
from lispac.gui.features.design.workspace import Workspace
from lispac.gui.viewport.base import DragHandle, PickedPoint, Sketch, Viewport
from lispac.io.config.plan_file import TitledPlan
from lispac.language import gettext_lazy
from lispac.simulation.closed_form_survey import Ball, Board

SQUARE_EDGES = ((0, 1), (1, 2), (2, 3), (3, 0))
RING_CORNERS = 16
"""Number of corners of the circles that represent a ball."""
WALL_SPACING_M, TARGET_SPACING_M = 0.15, 0.03
"""Spacing of the points that represent the wall or a target, metres."""
ARROW_LENGTH_M = 1.5
"""Length of an arrow, metres."""


class View3D(QObject):
    """Draws the plan into a viewport, with handles to move a target in three directions."""

    def __init__(self, workspace: Workspace, viewport: Viewport) -> None:
        super().__init__(workspace)
        self._work, self.viewport = workspace, viewport
        self._names: set[str] = set()
        self._dragged: PlacedTarget | None = None
        self._plan_was_replaced = False  # the dragged object belonged to a replaced plan
        self._shift = np.zeros(3)
        self._clouds: dict[str, Array] = {}
        viewport.signals.seed_clicked.connect(self._place_target)
        viewport.signals.handle_moved.connect(self._drag_target)
        viewport.signals.handle_released.connect(self._on_handle_released)
        workspace.changed.connect(self._on_plan_changed)
        workspace.selected.connect(self.show)

    def _on_plan_changed(self) -> None:
        """Redraw the plan; a drag ends if the plan was replaced."""
        if self._dragged is not None and not self._work.is_dragging:
            self._dragged, self._plan_was_replaced = None, True
        self.show()

    def show(self) -> None:
        """Draw wall, targets and lines."""
        clouds = plan_surfaces(self._work.titled)
        if any(
            name not in self._clouds or not np.array_equal(cloud, self._clouds[name])
            for name, cloud in clouds.items()
        ):
            self._clouds = clouds
            colours = {"wall": theme.rgb("edge_strong"), "targets": theme.rgb("after")}
            self.viewport.show_clouds(clouds, colours)
        drawn = plan_sketches(self._work.titled, self._work.line, self._work.target)
        for name in self._names - set(drawn):
            self.viewport.show_sketch(name, None)
        self._names = set(drawn)
        for name, sketch in drawn.items():
            self.viewport.show_sketch(name, sketch)

    def fit(self) -> None:
        """Bring the whole site into view from the water side."""
        plan, wall = self._work.titled.plan, self._work.titled.wall
        points = [np.array(plan.middle), *(np.array(t.centre) for t in plan.targets)]
        points += [end for ends in _line_ends(self._work.titled) for end in ends]
        everything = np.stack(points)
        out = np.array([*wall.outward, 0.0])
        station = np.array(plan.middle) + 20.0 * out
        self.viewport.set_station((float(station[0]), float(station[1]), float(station[2])))
        side = np.array([*wall.rightward, 0.0])
        self.viewport.view_along(-out + 0.5 * side - 0.55 * np.array([0.0, 0.0, 1.0]), everything)

    def _place_target(self, at: PickedPoint) -> None:
        """Select the clicked target, or move the selected one to the clicked point of the wall.

        If no target is selected, a new target is added there.
        """
        titled = self._work.titled
        if at.line == "targets":
            relative_distances = [
                float(np.linalg.norm(np.array(target.centre) - at.position))
                / (target.radius if isinstance(target, Ball) else max(target.width, target.height))
                for target in titled.plan.targets
            ]
            self._work.select(target=int(np.argmin(relative_distances)))
            return
        along, _, up = (
            edits.round_to_step(metres, SNAP_STEP_M)
            for metres in titled.wall.wall_coordinates(at.position)
        )
        if self._work.target < 0:
            self._work.add_target(place=(along, up))
        else:
            self._work.change_target(
                gettext_lazy("Move target"), lambda each: replace(each, along=along, up=up)
            )

    def _drag_target(self, name: str, handle: int, metres: float) -> None:
        if self._plan_was_replaced or name != f"target {self._work.target}":
            return
        if self._dragged is None:
            self._dragged, self._shift = (
                edits.placed_targets(self._work.titled)[self._work.target],
                np.zeros(3),
            )
        self._shift[handle] += metres
        along, up, off = self._shift
        moved = moved_target(self._dragged, float(along), float(up), FINE_STEP_M)
        moved = replace(moved, off=edits.round_to_step(self._dragged.off + float(off), FINE_STEP_M))
        self._work.drag(edits.with_target(self._work.titled, self._work.target, moved))

    def _on_handle_released(self, _name: str) -> None:
        self._plan_was_replaced = False
        if self._dragged is not None:
            name, self._dragged = self._dragged.name, None
            self._work.end_drag(gettext_lazy("Move {target}", target=name))


def plan_sketches(titled: TitledPlan, line: int, target: int) -> dict[str, Sketch]:
    """Sketches of wall, lines and targets, by name."""
    plan, wall = titled.plan, titled.wall
    drawn = {"wall": _wall_sketch(titled)}
    for k, (first, last) in enumerate(_line_ends(titled)):
        along = (last - first) / max(float(np.linalg.norm(last - first)), 1e-9)
        lateral = np.array([-along[1], along[0], 0.0])
        barbs = [
            last - ARROW_LENGTH_M * along + 0.5 * s * ARROW_LENGTH_M * lateral for s in (1, -1)
        ]
        drawn[f"line {k}"] = Sketch(
            tuple(map(_as_tuple, (first, last, *barbs))), ((0, 1), (1, 2), (1, 3)),
            theme.rgb("moved" if k == line else "before"), label=f"{k + 1}",
            label_point=_as_tuple(first),
        )  # fmt: skip
    right, out, up = np.array([*wall.rightward, 0.0]), np.array([*wall.outward, 0.0]), np.eye(3)[2]
    for k, each in enumerate(plan.targets):
        corners, edges = _target_outline(each)
        handles: tuple[DragHandle, ...] = ()
        middle = np.array(each.centre)
        if k == target:
            half = each.radius if isinstance(each, Ball) else max(each.width, each.height) / 2
            handles = tuple(
                DragHandle(_as_tuple(middle + (half + 0.4) * axis), _as_tuple(axis))
                for axis in (right, up, out)
            )
        drawn[f"target {k}"] = Sketch(
            tuple(map(_as_tuple, corners)), edges, theme.rgb("moved" if k == target else "after"),
            label=each.name, label_point=_as_tuple(middle), handles=handles,
        )  # fmt: skip
    return drawn


def plan_surfaces(titled: TitledPlan) -> dict[str, Array]:
    """Points (n, 3), metres, of the wall and of the targets, which are drawn and can be clicked."""
    wide, high = _wall_extent(titled)
    along, up = np.meshgrid(
        np.arange(-wide, wide, WALL_SPACING_M), np.arange(-1.0, high, WALL_SPACING_M)
    )
    wall = titled.wall
    right, out = np.array([*wall.rightward, 0.0]), np.array([*wall.outward, 0.0])
    face = np.array(wall.middle) - 0.05 * out + along.reshape(-1, 1) * right
    face[:, 2] += up.ravel()
    generator = np.random.default_rng(1)
    scanner = np.array(wall.middle) + 15.0 * out
    targets = [t.points(TARGET_SPACING_M, generator, scanner) for t in titled.plan.targets]
    return {"wall": face, "targets": np.concatenate([np.empty((0, 3)), *targets])}


def _wall_extent(titled: TitledPlan) -> tuple[float, float]:
    """Half width and height of the drawn wall, metres."""
    targets = edits.placed_targets(titled)
    # Whole metres, so that the wall does not flicker while a target is dragged.
    wide = max([abs(t.along) + 3.0 for t in targets] + [8.0])
    high = max([t.up + 2.0 for t in targets] + [4.0])
    return float(np.ceil(wide)), float(np.ceil(high))


def _wall_sketch(titled: TitledPlan) -> Sketch:
    wide, high = _wall_extent(titled)
    place = titled.wall.local_point
    corners = [place(-wide, 0, -1.0), place(wide, 0, -1.0), place(wide, 0, high),
               place(-wide, 0, high)]  # fmt: skip
    return Sketch(tuple(corners), SQUARE_EDGES, theme.rgb("wall"))


def _target_outline(target: Board | Ball) -> tuple[Array, tuple[tuple[int, int], ...]]:
    if isinstance(target, Board):
        # The points of `grid` reproduce the second moments of the board and are not its corners.
        grid = target.grid(2)
        middle = grid.mean(axis=0)
        corners = middle + (grid - middle) * (0.5 / np.sqrt(1 / 12))
        return corners[[0, 1, 3, 2]], SQUARE_EDGES
    turn = np.linspace(0, 2 * np.pi, RING_CORNERS, endpoint=False)
    level = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    circles = np.concatenate([level, level[:, [0, 2, 1]], level[:, [2, 0, 1]]])
    edges = tuple(
        (RING_CORNERS * c + k, RING_CORNERS * c + (k + 1) % RING_CORNERS)
        for c in range(3)
        for k in range(RING_CORNERS)
    )
    return np.array(target.centre) + target.radius * circles, edges


def _line_ends(titled: TitledPlan) -> list[tuple[Array, Array]]:
    plan = titled.plan
    if not plan.targets:
        return []
    found = []
    for line, (start, stop) in zip(plan.lines, plan.straight_extents, strict=True):
        heading = np.radians(line.heading_deg)
        along = np.array([np.cos(heading), -np.sin(heading), 0.0])
        abeam = np.array([*line.abeam(plan.middle), 0.0])
        found.append((abeam + start * along, abeam + stop * along))
    return found


def _as_tuple(point: Array) -> tuple[float, float, float]:
    return float(point[0]), float(point[1]), float(point[2])
