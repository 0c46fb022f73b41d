"""Plan view of the site, in which lines are dragged and turned."""

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPen, QPolygonF

from lispac.design.plan import Line
from lispac.gui.appearance import theme, units
from lispac.gui.features.design import edits
from lispac.gui.features.design.canvas import GRAB_RADIUS_PX, Array, DesignCanvas
from lispac.gui.features.design.workspace import Workspace
from lispac.language import LazyText, gettext, gettext_lazy
from lispac.simulation.closed_form_survey import Board

LINE_OFFSET_PX = 6.0
"""Offset of a drawn line to starboard, pixels, which separates lines in opposite directions."""
BADGE_RADIUS_PX = 9.0
"""Radius of the disc with the number of a line, pixels."""

LINE_SNAP_STEP_M = 0.5
"""Approximate step of a dragged line, metres; a round length in the unit shown."""

Key = Qt.Key


class PlanView(DesignCanvas):
    """Plan view with north up; the number of a line is at its start."""

    def __init__(self, workspace: Workspace) -> None:
        unit = units.shown_unit("m").sign
        super().__init__(
            "plan_view", gettext("Plan view of the lines"), workspace,
            (gettext("east ({unit})", unit=unit), gettext("north ({unit})", unit=unit)),
        )  # fmt: skip
        self.setToolTip(
            gettext(
                "Drag a line to move it. Drag its arrow to turn it in steps of 5°, or "
                "continuously with Shift. Page Up/Down selects a line, Left/Right turns it, "
                "Up/Down moves it, Insert adds a line, Delete removes it."
            )
        )
        self._dragged_line: Line | None = None
        self._is_turning = False
        self._grab_position = np.zeros(2)

    # -- places ------------------------------------------------------------------------------

    @property
    def _middle(self) -> Array:
        north, west, _ = self.workspace.titled.plan.middle
        return np.array([-west, north])

    def _line_ends(self) -> list[tuple[Array, Array]]:
        """Start and end of each line, east and north, metres."""
        plan = self.workspace.titled.plan
        found = []
        runs = plan.straight_extents if plan.targets else [(-5.0, 5.0)] * len(plan.lines)
        for line, (start, stop) in zip(plan.lines, runs, strict=True):
            north, west = line.abeam(plan.middle)
            along = _line_direction(line)
            abeam = np.array([-west, north])
            found.append((abeam + start * along, abeam + stop * along))
        return found

    def _line_pixels(self, k: int, ends: tuple[Array, Array]) -> tuple[QPointF, QPointF]:
        along = _line_direction(self.workspace.titled.plan.lines[k])
        offset = LINE_OFFSET_PX * QPointF(along[1], along[0])  # to starboard; y points down
        return self.pixel(ends[0]) + offset, self.pixel(ends[1]) + offset

    def bounds(self) -> Array:
        """Centre of the site, ends of lines and targets: shape (n, 2), metres, east and north."""
        titled = self.workspace.titled
        places = [self._middle]
        places += [place for ends in self._line_ends() for place in ends]
        places += [np.array([-t.centre[1], t.centre[0]]) for t in titled.plan.targets]
        return np.stack(places)

    # -- drawing -----------------------------------------------------------------------------

    def draw(self, painter: QPainter) -> None:
        """Draw the site from above."""
        titled = self.workspace.titled
        wall = titled.wall
        right = np.array([-wall.rightward[1], wall.rightward[0]])
        water = np.array([-wall.outward[1], wall.outward[0]])
        reach = 1.2 * max((line.distance for line in titled.plan.lines), default=10.0) + 5.0
        corners = [
            self._middle - reach * right, self._middle + reach * right,
            self._middle + reach * right - 0.6 * water, self._middle - reach * right - 0.6 * water,
        ]  # fmt: skip
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QBrush(QColor(theme.WALL)))
        painter.drawPolygon(QPolygonF([self.pixel(corner) for corner in corners]))
        ends = self._line_ends()
        for k in sorted(range(len(ends)), key=lambda k: k == self.workspace.line):
            self._draw_line(painter, k, *self._line_pixels(k, ends[k]))
        for k, target in enumerate(titled.plan.targets):
            spot = self.pixel(np.array([-target.centre[1], target.centre[0]]))
            chosen = k == self.workspace.target
            painter.setPen(QPen(QColor(theme.TEXT), 1))
            painter.setBrush(QBrush(QColor(theme.MOVED if chosen else theme.AFTER)))
            draw = painter.drawRect if isinstance(target, Board) else painter.drawEllipse
            draw(round(spot.x()) - 4, round(spot.y()) - 4, 8, 8)
            if chosen or len(titled.plan.targets) <= 2:
                lower = 13.0 if k % 2 else -6.0
                self.draw_text(painter, spot + QPointF(8, lower), target.name)

    def _draw_line(self, painter: QPainter, k: int, first: QPointF, last: QPointF) -> None:
        chosen = k == self.workspace.line
        colour = QColor(theme.MOVED if chosen else theme.BEFORE)
        painter.setPen(QPen(colour, 2.6 if chosen else 1.6))
        painter.drawLine(first, last)
        along = last - first
        length = max(float(np.hypot(along.x(), along.y())), 1.0)
        along, offset = along / length, QPointF(-along.y(), along.x()) / length
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QBrush(colour))
        painter.drawPolygon(
            QPolygonF(
                [last + 4 * along, last - 9 * along + 5 * offset, last - 9 * along - 5 * offset]
            )
        )
        painter.drawEllipse(first, BADGE_RADIUS_PX, BADGE_RADIUS_PX)
        painter.setPen(QColor(theme.ON_SERIES))
        font = self.font()
        font.setPixelSize(11)
        font.setBold(True)
        painter.setFont(font)
        number = f"{k + 1}"
        wide = painter.fontMetrics().horizontalAdvance(number)
        painter.drawText(first + QPointF(-wide / 2, 4), number)
        if chosen:
            line = self.workspace.titled.plan.lines[k]
            distance = units.localised(units.limit_text(line.distance, "m"))
            label = f"{line.heading_deg:03.0f}°, {distance} {units.shown_unit('m').sign}"
            at = (first + last) / 2 + QPointF(8, -8)
            self.draw_text(painter, at, label, theme.MOVED)

    # -- mouse -------------------------------------------------------------------------------

    def _line_at(self, at: QPointF) -> tuple[int, bool] | None:
        """Line at a pixel, the selected one first, and whether the pixel is on its arrow."""
        drawn = [self._line_pixels(k, ends) for k, ends in enumerate(self._line_ends())]
        order = sorted(range(len(drawn)), key=lambda k: k != self.workspace.line)
        for k in order:
            if _segment_distance(at, drawn[k][1], drawn[k][1]) <= GRAB_RADIUS_PX:
                return k, True
        near = [(_segment_distance(at, *drawn[k]), k) for k in order]
        best = min(near, default=(np.inf, -1), key=lambda each: round(each[0]))
        return (best[1], False) if best[0] <= GRAB_RADIUS_PX else None

    def cursor_shape_at(self, at: QPointF) -> Qt.CursorShape:
        """Cross cursor where a line can be turned, hand cursor where it can be moved."""
        found = self._line_at(at)
        if found is None:
            return Qt.CursorShape.ArrowCursor
        return Qt.CursorShape.CrossCursor if found[1] else Qt.CursorShape.OpenHandCursor

    def start_drag(self, at: QPointF) -> bool:
        """Start to move or turn the line at a pixel."""
        found = self._line_at(at)
        if found is None:
            return False
        k, self._is_turning = found
        self.workspace.select(line=k)
        self._dragged_line = self.workspace.titled.plan.lines[k]
        self._grab_position = self.place(at) - self._middle
        return True

    def drag_to(self, at: QPointF, free: bool) -> None:
        """Move or turn the line."""
        if self._dragged_line is None:
            return
        line, position = self._dragged_line, self.place(at) - self._middle
        if self._is_turning:
            rotation_deg = np.degrees(
                np.arctan2(position[0], position[1])
                - np.arctan2(self._grab_position[0], self._grab_position[1])
            )
            heading = (line.heading_deg + float(rotation_deg)) % 360
            heading = round(heading, 1) if free else edits.snap_heading(heading)
            line = edits.with_heading(line, self.workspace.titled.wall, heading)
        else:
            along = _line_direction(line)
            away = np.array([-along[1], along[0]]) * (1 if line.starboard else -1)
            line = edits.with_distance(
                line, line.distance + float((position - self._grab_position) @ away)
            )
            if not free:
                line = edits.with_distance(
                    line, edits.round_to_step(line.distance, LINE_SNAP_STEP_M)
                )
        self.workspace.drag(edits.with_line(self.workspace.titled, self.workspace.line, line))

    def end_edit(self) -> LazyText:
        """Release the line and return the name of the undo step."""
        self._dragged_line = None
        return (
            _turn_edit_name(self.workspace.line)
            if self._is_turning
            else _move_edit_name(self.workspace.line)
        )

    # -- keys --------------------------------------------------------------------------------

    def handle_key(self, key: Qt.Key, free: bool) -> bool:
        """Select, turn, move, add or remove a line with a key."""
        work, wall = self.workspace, self.workspace.titled.wall
        count = len(work.titled.plan.lines)
        if key in (Key.Key_PageUp, Key.Key_PageDown) and count:
            work.select(line=(work.line + (1 if key == Key.Key_PageDown else -1)) % count)
        elif key in (Key.Key_Left, Key.Key_Right):
            rotation_deg = (1.0 if free else edits.HEADING_SNAP_DEG) * (
                1 if key == Key.Key_Right else -1
            )
            work.change_line(
                _turn_edit_name(work.line),
                lambda line: edits.with_heading(line, wall, line.heading_deg + rotation_deg),
                f"turn {work.line}",
            )
        elif key in (Key.Key_Up, Key.Key_Down):
            farther = units.shown_step(0.1 if free else 1.0, "m") * (1 if key == Key.Key_Up else -1)
            work.change_line(
                _move_edit_name(work.line),
                lambda line: edits.with_distance(line, line.distance + farther),
                f"move {work.line}",
            )
        elif key == Key.Key_Insert:
            work.add_line()
        elif key == Key.Key_Delete:
            work.remove_line()
        else:
            return False
        return True


def _turn_edit_name(k: int) -> LazyText:
    return gettext_lazy("Turn line {line:n}", line=k + 1)


def _move_edit_name(k: int) -> LazyText:
    return gettext_lazy("Move line {line:n}", line=k + 1)


def _line_direction(line: Line) -> Array:
    heading = np.radians(line.heading_deg)
    return np.array([np.sin(heading), np.cos(heading)])


def _segment_distance(at: QPointF, first: QPointF, last: QPointF) -> float:
    """Distance of a point from a line segment, pixels."""
    a, b, p = (np.array([q.x(), q.y()]) for q in (first, last, at))
    length = float((b - a) @ (b - a))
    share = 0.0 if length == 0 else float(np.clip((p - a) @ (b - a) / length, 0.0, 1.0))
    return float(np.hypot(*(p - a - share * (b - a))))
