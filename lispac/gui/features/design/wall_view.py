"""View of the wall from the water, in which targets are dragged."""

from dataclasses import replace

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPen

from lispac.gui.appearance import theme, units
from lispac.gui.features.design import edits
from lispac.gui.features.design.canvas import Array, DesignCanvas
from lispac.gui.features.design.edits import PlacedTarget
from lispac.gui.features.design.workspace import Workspace
from lispac.language import LazyText, current_language, gettext, gettext_lazy, number

MIN_BOARD_PX = 8.0
"""Smallest drawn size of a board, pixels."""
SNAP_STEP_M, FINE_STEP_M = 0.1, 0.01
"""Approximate steps of a moved target, metres; round lengths in the unit shown."""
VIEW_MARGIN_M = 2.0
"""Height above and below the centre of each target that is visible, metres."""

Key = Qt.Key


class WallView(DesignCanvas):
    """View of the wall from the water; height zero is that of the vessel's POS."""

    def __init__(self, workspace: Workspace) -> None:
        unit = units.shown_unit("m").sign
        super().__init__(
            "wall_view", gettext("Front view of the wall and its targets"), workspace,
            (
                gettext("position along the wall ({unit})", unit=unit),
                gettext("height above the POS ({unit})", unit=unit),
            ),
        )  # fmt: skip
        wide, fine = (
            f"{units.localised(units.limit_text(units.shown_step(step, 'm'), 'm'))} {unit}"
            for step in (SNAP_STEP_M, FINE_STEP_M)
        )
        self.setToolTip(
            gettext(
                "Drag a target to move it in steps of {coarse}, or of {fine} with Shift. Page "
                "Up/Down selects a target, the arrow keys move it, Insert adds a board, Delete "
                "removes the target.",
                coarse=wide,
                fine=fine,
            )
        )
        self._dragged: PlacedTarget | None = None
        self._grab_position = np.zeros(2)

    def bounds(self) -> Array:
        """Points around the targets, shape (n, 2), metres, along the wall and up."""
        places = [(0.0, 0.0), (-4.0, 0.0), (4.0, 4.0)]
        for each in edits.placed_targets(self.workspace.titled):
            places += [(each.along - each.width, each.up - VIEW_MARGIN_M)]
            places += [(each.along + each.width, each.up + VIEW_MARGIN_M)]
        return np.array(places)

    def _target_rect(self, each: PlacedTarget) -> QRectF:
        scale, _ = self._view
        tall = each.height if each.ball else each.height * abs(np.sin(np.radians(each.lean)))
        wide, tall = max(scale * each.width, MIN_BOARD_PX), max(scale * float(tall), MIN_BOARD_PX)
        spot = self.pixel(np.array([each.along, each.up]))
        return QRectF(spot.x() - wide / 2, spot.y() - tall / 2, wide, tall)

    def draw(self, painter: QPainter) -> None:
        """Draw the targets on the wall, and the height of the POS."""
        level = self.pixel(np.zeros(2)).y()
        painter.setPen(QPen(QColor(theme.LEVEL), 1.5, Qt.PenStyle.DashLine))
        painter.drawLine(QPointF(0, level), QPointF(self.width(), level))
        painter.setPen(QColor(theme.MUTED))
        painter.drawText(QPointF(30, level - 4), gettext("height of the POS"))
        targets = edits.placed_targets(self.workspace.titled)
        for k in sorted(range(len(targets)), key=lambda k: k == self.workspace.target):
            each, box = targets[k], self._target_rect(targets[k])
            colour = QColor(theme.MOVED if k == self.workspace.target else theme.AFTER)
            painter.setPen(QPen(colour, 2))
            colour.setAlpha(120)
            painter.setBrush(QBrush(colour))
            (painter.drawEllipse if each.ball else painter.drawRect)(box)
            label = each.name if each.ball else f"{each.name} {number(each.lean, 0)}°"
            self.draw_text(painter, box.topLeft() + QPointF(0, -3), label)
            if k == self.workspace.target:
                along, up = (
                    units.localised(units.figure(v, "m", "+.2f")) for v in (each.along, each.up)
                )
                separator = ", " if current_language() == "en" else "\u202f; "
                place = f"{along}{separator}{up} {units.shown_unit('m').sign}".replace("-", "−")
                self.draw_text(painter, box.bottomLeft() + QPointF(0, 14), place, theme.MOVED)

    # -- mouse -------------------------------------------------------------------------------

    def _target_at(self, at: QPointF) -> int | None:
        targets = edits.placed_targets(self.workspace.titled)
        order = sorted(range(len(targets)), key=lambda k: k != self.workspace.target)
        return next((k for k in order if self._target_rect(targets[k]).contains(at)), None)

    def cursor_shape_at(self, at: QPointF) -> Qt.CursorShape:
        """Hand cursor over a target."""
        is_on_target = self._target_at(at) is not None
        return Qt.CursorShape.OpenHandCursor if is_on_target else Qt.CursorShape.ArrowCursor

    def start_drag(self, at: QPointF) -> bool:
        """Start to drag the target at a pixel."""
        k = self._target_at(at)
        if k is None:
            return False
        self.workspace.select(target=k)
        self._dragged = edits.placed_targets(self.workspace.titled)[k]
        self._grab_position = self.place(at)
        return True

    def drag_to(self, at: QPointF, free: bool) -> None:
        """Move the target along the wall and up."""
        if self._dragged is None:
            return
        along, up = self.place(at) - self._grab_position
        step = FINE_STEP_M if free else SNAP_STEP_M
        moved = moved_target(self._dragged, float(along), float(up), step)
        self.workspace.drag(edits.with_target(self.workspace.titled, self.workspace.target, moved))

    def end_edit(self) -> LazyText:
        """Release the target and return the name of the undo step."""
        name = "" if self._dragged is None else self._dragged.name
        self._dragged = None
        return gettext_lazy("Move {target}", target=name)

    # -- keys --------------------------------------------------------------------------------

    def handle_key(self, key: Qt.Key, free: bool) -> bool:
        """Select, move, add or remove a target with a key."""
        work, step = self.workspace, units.shown_step(FINE_STEP_M if free else SNAP_STEP_M, "m")
        count = len(work.titled.plan.targets)
        arrows = {
            Key.Key_Left: (-step, 0.0), Key.Key_Right: (step, 0.0),
            Key.Key_Down: (0.0, -step), Key.Key_Up: (0.0, step),
        }  # fmt: skip
        if key in (Key.Key_PageUp, Key.Key_PageDown) and count:
            work.select(target=(work.target + (1 if key == Key.Key_PageDown else -1)) % count)
        elif key in arrows:
            work.change_target(
                gettext_lazy("Move target"),
                lambda each: moved_target(each, *arrows[key], FINE_STEP_M),
                f"hang {work.target}",
            )
        elif key == Key.Key_Insert:
            work.add_target()
        elif key == Key.Key_Delete:
            work.remove_target()
        else:
            return False
        return True


def moved_target(target: PlacedTarget, along: float, up: float, step: float) -> PlacedTarget:
    """Target moved along the wall and up, metres, to multiples of about ``step``."""
    return replace(
        target,
        along=edits.round_to_step(target.along + along, step),
        up=edits.round_to_step(target.up + up, step),
    )
