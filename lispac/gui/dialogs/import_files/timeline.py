"""Lines as bars under the trajectory's bar, over one time axis."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from lispac.gui import theme
from lispac.gui.language import say
from lispac.io.line_times import LineTimes
from lispac.workflow.intake import Intake

NAMES, WORDS, ROW, AXIS, TOP = 170, 190, 26, 44, 8
"""Pixels: left and right of the bars, a row, under and over them."""
SHORTEST = 4.0


@dataclass(frozen=True)
class Bar:
    """One row.

    Attributes
    ----------
    path : Path
    name : str
    colour : str
    start, end : float, seconds, in the trajectory's time base
    holes : tuple of (float, float), seconds
        Parts that cannot be used: gaps, or what lies outside the trajectory.
    words : str
        Beside the bar.
    sound : bool
    is_line : bool
    """

    path: Path
    name: str
    colour: str
    start: float
    end: float
    holes: tuple[tuple[float, float], ...]
    words: str
    sound: bool
    is_line: bool


def bars_of(intake: Intake) -> tuple[Bar, ...]:
    """Rows of a timeline, the trajectory first."""
    bars = []
    track, entry = intake.track, intake.trajectory
    if track is not None and entry is not None:
        time = track.time
        wide = np.flatnonzero(np.diff(time) > intake.longest_gap)
        gaps = tuple((float(time[k]), float(time[k + 1])) for k in wide)
        said = f"{len(gaps)} gap{'s' if len(gaps) != 1 else ''}" if gaps else "no gap"
        bars.append(Bar(entry.path, "Trajectory", theme.MUTED, float(time[0]), float(time[-1]),
                        gaps, said, True, False))  # fmt: skip
    colours = theme.line_colours([str(line.path) for line in intake.lines])
    for line in intake.lines:
        if not isinstance(line.content, LineTimes):
            continue
        start, end = line.content.start + line.shift, line.content.end + line.shift
        covered = intake.coverage(line)
        holes: tuple[tuple[float, float], ...] = ()
        said, sound = "no trajectory yet", False
        if covered is not None and track is not None:
            first, last = float(track.time[0]), float(track.time[-1])
            if start < first:
                holes += ((start, min(end, first)),)
            if end > last:
                holes += ((max(start, last), end),)
            holes += covered.gaps
            sound = covered.usable == covered.count
            parts = []
            if covered.outside:
                parts.append(f"{100 * covered.share_outside:.1f} % outside")
            if covered.in_gaps:
                parts.append(f"{100 * covered.share_in_gaps:.1f} % in gaps")
            said = "covered" if sound else ", ".join(parts)
            if line.shift:
                said += f" ({line.shift:+,.0f} s)"
        colour = QColor(*colours[str(line.path)]).name()
        name = intake.names[line.path]
        bars.append(Bar(line.path, name, colour, start, end, holes, said, sound, True))
    return tuple(bars)


def span_of(bars: tuple[Bar, ...]) -> tuple[float, float]:
    """What the axis shows: the trajectory and the lines near it, with a margin."""
    track = next((bar for bar in bars if not bar.is_line), None)
    if track is None:
        start, end = min(b.start for b in bars), max(b.end for b in bars)
    else:
        length = track.end - track.start
        near = [b for b in bars if b.start < track.end + length and b.end > track.start - length]
        start, end = min(b.start for b in near), max(b.end for b in near)
    margin = 0.03 * max(end - start, 1e-3)
    return start - margin, end + margin


def ticks_of(start: float, end: float, most: int) -> list[float]:
    """Round numbers between, no more than ``most``."""
    rough = (end - start) / max(most, 1)
    power = 10.0 ** np.floor(np.log10(rough))
    step = next(k * power for k in (1, 2, 5, 10) if k * power >= rough)
    ticks = np.arange(np.ceil(start / step), np.floor(end / step) + 1) * step
    return [float(t) for t in ticks + 0.0]  # what is added makes a zero of a minus zero


class TimelineView(QWidget):
    """Draws the rows; a click or the arrow keys select one."""

    file_selected = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("import_timeline")
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(say("Timeline of the lines over the trajectory"))
        self.bars: tuple[Bar, ...] = ()
        self._axis = ""
        self._current: Path | None = None

    def show_intake(self, intake: Intake, current: Path | None) -> None:
        """Draw the rows of an intake."""
        self.bars = bars_of(intake)
        base = intake.time_base
        self._axis = "Time, s" if base is None else f"{base.name[:1].upper()}{base.name[1:]}"
        self._current = current
        self.setAccessibleDescription(
            "; ".join(
                say(f"{b.name} {b.start:,.1f} to {b.end:,.1f} s, {b.words}") for b in self.bars
            )
        )
        self.setToolTip(say("" if self.bars else "No file with times yet"))
        self.updateGeometry()
        self.update()

    def sizeHint(self) -> QSize:
        """The size it likes best, in pixels."""
        return QSize(600, TOP + max(len(self.bars), 1) * ROW + AXIS)

    def minimumSizeHint(self) -> QSize:
        """The least size it is of use at, in pixels."""
        return QSize(480, self.sizeHint().height())

    def mousePressEvent(self, event) -> None:
        """Choose the file whose bar was clicked."""
        row = int((event.position().y() - TOP) // ROW)
        if 0 <= row < len(self.bars):
            self.file_selected.emit(self.bars[row].path)

    def keyPressEvent(self, event) -> None:
        """Choose the file above or below with the arrows."""
        step = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}.get(event.key())
        if step is None or not self.bars:
            super().keyPressEvent(event)
            return
        paths = [bar.path for bar in self.bars]
        now = paths.index(self._current) if self._current in paths else -step
        self.file_selected.emit(paths[min(max(now + step, 0), len(paths) - 1)])

    def focusInEvent(self, event) -> None:
        """Show that it has the focus."""
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event) -> None:
        """Show that it has the focus no more."""
        super().focusOutEvent(event)
        self.update()

    def paintEvent(self, event) -> None:
        """Paint an axis of time and a bar for each file."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(theme.PAPER))
        if not self.bars:
            painter.setPen(QColor(theme.MUTED))
            text = "Add the trajectory and the lines: their times appear here."
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, say(text))
            return
        start, end = span_of(self.bars)
        width = max(self.width() - NAMES - WORDS, 50)

        def x(time: float) -> float:
            return NAMES + (time - start) / (end - start) * width

        bottom = TOP + len(self.bars) * ROW
        self._draw_axis(painter, start, end, x, bottom)
        for row, bar in enumerate(self.bars):
            self._draw_bar(painter, bar, TOP + row * ROW, x, width)
        if self.hasFocus():
            painter.setPen(QPen(QColor(theme.ACCENT), 1))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(QRectF(0.5, 0.5, self.width() - 1, self.height() - 1))

    def _draw_axis(self, painter: QPainter, start: float, end: float, x, bottom: int) -> None:
        metrics = self.fontMetrics()
        label = metrics.horizontalAdvance(f"{end:,.1f}") + 24
        ticks = ticks_of(start, end, max(int((self.width() - NAMES - WORDS) / label), 2))
        fine = len(ticks) > 1 and ticks[1] - ticks[0] < 1
        painter.setFont(theme.tabular(self.font()))
        for tick in ticks:
            painter.setPen(QColor(theme.GRID))
            painter.drawLine(QPointF(x(tick), TOP), QPointF(x(tick), bottom + 4))
            painter.setPen(QColor(theme.TEXT))
            text = f"{tick:,.{2 if fine else 0}f}"
            box = QRectF(x(tick) - label / 2, bottom + 4, label, 18)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, say(text))
        painter.setPen(QColor(theme.MUTED))
        box = QRectF(NAMES, bottom + 22, self.width() - NAMES - WORDS, 18)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, say(self._axis))

    def _draw_bar(self, painter: QPainter, bar: Bar, top: int, x, width: int) -> None:
        middle = Qt.AlignmentFlag.AlignVCenter
        if bar.path == self._current:
            painter.fillRect(QRectF(0, top, self.width(), ROW), QColor(theme.CURRENT))
        painter.setPen(QColor(theme.TEXT))
        name = self.fontMetrics().elidedText(
            say(bar.name), Qt.TextElideMode.ElideMiddle, NAMES - 24
        )
        painter.drawText(QRectF(12, top, NAMES - 20, ROW), middle, name)
        painter.setPen(QColor(theme.MUTED if bar.sound else theme.ERROR))
        box = QRectF(NAMES + width + 12, top, WORDS - 16, ROW)
        painter.drawText(box, middle, self.fontMetrics().elidedText(
            say(bar.words), Qt.TextElideMode.ElideRight, WORDS - 16))  # fmt: skip
        left, right = x(bar.start), x(bar.end)
        if right < NAMES or left > NAMES + width:
            self._draw_far(painter, bar, top, NAMES if right < NAMES else NAMES + width)
            return
        left, right = max(left, NAMES), min(max(right, left + SHORTEST), NAMES + width)
        whole = QRectF(left, top + 5, right - left, ROW - 10)
        painter.fillRect(whole, QColor(bar.colour))
        for first, last in bar.holes:
            a, b = max(x(first), left), min(max(x(last), x(first) + 2), right)
            if b <= a:
                continue
            hole = QRectF(a, top + 5, b - a, ROW - 10)
            painter.fillRect(hole, QColor(theme.PAPER))
            painter.fillRect(hole, _hatch())
            painter.setPen(QPen(QColor(theme.ERROR), 1))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(hole)
            text = say(f"gap {last - first:,.1f} s")
            if not bar.is_line and self.fontMetrics().horizontalAdvance(text) + 8 < b - a:
                painter.fillRect(hole.adjusted(2, 2, -2, -2), QColor(theme.PAPER))
                painter.drawText(hole, Qt.AlignmentFlag.AlignCenter, text)

    def _draw_far(self, painter: QPainter, bar: Bar, top: int, edge: float) -> None:
        """An arrow for a line that lies beyond the axis, and how far."""
        before = edge == NAMES
        track = next(each for each in self.bars if not each.is_line)
        apart = track.start - bar.end if before else bar.start - track.end
        side, y = (1 if before else -1), top + ROW / 2
        tip = edge + side * 4
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(bar.colour))
        painter.drawPolygon(QPolygonF([
            QPointF(tip, y), QPointF(tip + side * 11, y - 7), QPointF(tip + side * 11, y + 7)
        ]))  # fmt: skip
        painter.setPen(QColor(theme.ERROR))
        where = "before the trajectory" if before else "after the trajectory"
        align = Qt.AlignmentFlag.AlignLeft if before else Qt.AlignmentFlag.AlignRight
        box = QRectF(tip + 18, top, 400, ROW) if before else QRectF(tip - 418, top, 400, ROW)
        painter.drawText(box, align | Qt.AlignmentFlag.AlignVCenter, say(f"{apart:,.0f} s {where}"))


def _hatch() -> QBrush:
    return QBrush(QColor(theme.HATCH), Qt.BrushStyle.BDiagPattern)
