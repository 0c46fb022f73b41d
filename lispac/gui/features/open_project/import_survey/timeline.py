"""Timeline of an import: bars of the trajectory and of the lines over a time axis."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from lispac.gui.appearance import theme
from lispac.gui.features.open_project.import_survey.file_texts import time_axis_title
from lispac.io.points.line_times import LineTimes
from lispac.language import Plural, gettext, number
from lispac.survey.time_quality import TrajectoryCoverage
from lispac.workflow.importing.input_files import InputFiles

NAME_WIDTH_PX, TEXT_WIDTH_PX, ROW_HEIGHT_PX, AXIS_HEIGHT_PX, TOP_MARGIN_PX = 170, 190, 26, 44, 8
MIN_ROW_HEIGHT_PX = 17
"""Widths of the names and of the texts, heights of a row and of the axis, and margin at the top."""
MIN_BAR_WIDTH_PX = 4.0


@dataclass(frozen=True)
class TimelineBar:
    """A row of the timeline.

    Attributes
    ----------
    path : Path
    name : str
    colour : str
    start, end : float, seconds, in the time base of the trajectory
    gaps : tuple of (float, float), seconds
        Unusable parts: gaps of the trajectory, and times outside it.
    text : str
        Text beside the bar.
    is_usable : bool
        Whether the trajectory covers all points of the line; True for the trajectory itself.
    is_line : bool
    """

    path: Path
    name: str
    colour: str
    start: float
    end: float
    gaps: tuple[tuple[float, float], ...]
    text: str
    is_usable: bool
    is_line: bool


def timeline_bars(input_files: InputFiles) -> tuple[TimelineBar, ...]:
    """Bars of a timeline, the trajectory first."""
    bars = []
    track, file = input_files.trajectory_content, input_files.trajectory
    if track is not None and file is not None:
        time = track.time
        wide = np.flatnonzero(np.diff(time) > input_files.longest_gap)
        gaps = tuple((float(time[k]), float(time[k + 1])) for k in wide)
        text = (
            gettext(Plural("{count:n} gap", "{count:n} gaps"), count=len(gaps))
            if gaps
            else gettext("no gaps in time")
        )
        bars.append(TimelineBar(file.path, gettext("Trajectory"), theme.MUTED, float(time[0]),
                        float(time[-1]), gaps, text, True, False))  # fmt: skip
    colours = theme.line_colours([str(line.path) for line in input_files.lines])
    for line in input_files.lines:
        if not isinstance(line.content, LineTimes):
            continue
        start, end = line.content.start + line.shift, line.content.end + line.shift
        covered = input_files.coverage(line)
        gaps: tuple[tuple[float, float], ...] = ()
        is_usable = False
        if covered is not None and track is not None:
            first, last = float(track.time[0]), float(track.time[-1])
            if start < first:
                gaps += ((start, min(end, first)),)
            if end > last:
                gaps += ((max(start, last), end),)
            gaps += covered.gaps
            is_usable = covered.usable == covered.count
        text = _coverage_text(covered, line.shift if track is not None else 0.0)
        colour = QColor(*colours[str(line.path)]).name()
        name = input_files.names[line.path]
        bars.append(TimelineBar(line.path, name, colour, start, end, gaps, text, is_usable, True))
    return tuple(bars)


def _coverage_text(covered: TrajectoryCoverage | None, shift: float) -> str:
    """Text on the part of a line that the trajectory covers, and on the shift of its times."""
    if covered is None:
        return gettext("no trajectory")
    if covered.usable == covered.count:
        text = gettext("fully covered")
    elif covered.outside and covered.in_gaps:
        text = gettext(
            "{outside:percent.1} % outside, {gaps:percent.1} % in gaps",
            outside=covered.share_outside, gaps=covered.share_in_gaps,
        )  # fmt: skip
    elif covered.outside:
        text = gettext("{outside:percent.1} % outside trajectory", outside=covered.share_outside)
    else:
        text = gettext("{gaps:percent.1} % in trajectory gaps", gaps=covered.share_in_gaps)
    if not shift:
        return text
    return gettext("{text} ({shift:s.0+} s)", text=text, shift=shift)


def axis_time_span(bars: tuple[TimelineBar, ...]) -> tuple[float, float]:
    """Time span of the axis: the trajectory and the lines near it, with a margin."""
    track = next((bar for bar in bars if not bar.is_line), None)
    if track is None:
        start, end = min(b.start for b in bars), max(b.end for b in bars)
    else:
        length = track.end - track.start
        near = [b for b in bars if b.start < track.end + length and b.end > track.start - length]
        start, end = min(b.start for b in near), max(b.end for b in near)
    margin = 0.03 * max(end - start, 1e-3)
    return start - margin, end + margin


def round_ticks(start: float, end: float, max_ticks: int) -> list[float]:
    """Round values between two times, at most ``max_ticks + 1``."""
    rough = (end - start) / max(max_ticks, 1)
    power = 10.0 ** np.floor(np.log10(rough))
    step = next(k * power for k in (1, 2, 5, 10) if k * power >= rough)
    ticks = np.arange(np.ceil(start / step), np.floor(end / step) + 1) * step
    return [float(t) for t in ticks + 0.0]  # adding zero removes the sign of a negative zero


class TimelineView(QWidget):
    """Draws the rows; a click or the arrow keys select one."""

    file_selected = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("import_timeline")
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Maximum)
        self.setAccessibleName(gettext("Timeline of the lines and the trajectory"))
        self.bars: tuple[TimelineBar, ...] = ()
        self._axis = ""
        self._current: Path | None = None

    def show_files(self, input_files: InputFiles, current: Path | None) -> None:
        """Draw the rows of an import."""
        self.bars = timeline_bars(input_files)
        self._axis = time_axis_title(input_files.time_base)
        self._current = current
        self.setAccessibleDescription("\n".join(map(_bar_description, self.bars)))
        self.setToolTip("" if self.bars else gettext("No file with times has been added yet"))
        self.updateGeometry()
        self.update()

    def sizeHint(self) -> QSize:
        """Preferred size in pixels."""
        return QSize(600, self._height_of_rows(ROW_HEIGHT_PX))

    def minimumSizeHint(self) -> QSize:
        """Smallest size in pixels, with lower rows than the preferred ones."""
        return QSize(480, self._height_of_rows(MIN_ROW_HEIGHT_PX))

    def _height_of_rows(self, row_height: int) -> int:
        return TOP_MARGIN_PX + max(len(self.bars), 1) * row_height + AXIS_HEIGHT_PX

    @property
    def row_height(self) -> int:
        """Height of a row in pixels, lower if this keeps the axis visible."""
        fitting = (self.height() - TOP_MARGIN_PX - AXIS_HEIGHT_PX) // max(len(self.bars), 1)
        return min(max(fitting, MIN_ROW_HEIGHT_PX), ROW_HEIGHT_PX)

    def mousePressEvent(self, event) -> None:
        """Select the file of the clicked bar."""
        row = int((event.position().y() - TOP_MARGIN_PX) // self.row_height)
        if 0 <= row < len(self.bars):
            self.file_selected.emit(self.bars[row].path)

    def keyPressEvent(self, event) -> None:
        """Select the file above or below with the arrow keys."""
        step = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}.get(event.key())
        if step is None or not self.bars:
            super().keyPressEvent(event)
            return
        paths = [bar.path for bar in self.bars]
        now = paths.index(self._current) if self._current in paths else -step
        self.file_selected.emit(paths[min(max(now + step, 0), len(paths) - 1)])

    def focusInEvent(self, event) -> None:
        """Draw the frame of the focus."""
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event) -> None:
        """Remove the frame of the focus."""
        super().focusOutEvent(event)
        self.update()

    def paintEvent(self, event) -> None:
        """Paint a time axis and a bar for each file."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(theme.PAPER))
        if not self.bars:
            painter.setPen(QColor(theme.MUTED))
            text = gettext("Add the trajectory and the lines to see their times.")
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, text)
            return
        start, end = axis_time_span(self.bars)
        width = max(self.width() - NAME_WIDTH_PX - TEXT_WIDTH_PX, 50)

        def x(time: float) -> float:
            return NAME_WIDTH_PX + (time - start) / (end - start) * width

        bottom = TOP_MARGIN_PX + len(self.bars) * self.row_height
        self._draw_axis(painter, start, end, x, bottom)
        for row, bar in enumerate(self.bars):
            self._draw_bar(painter, bar, TOP_MARGIN_PX + row * self.row_height, x, width)
        if self.hasFocus():
            painter.setPen(QPen(QColor(theme.ACCENT), 1))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(QRectF(0.5, 0.5, self.width() - 1, self.height() - 1))

    def _draw_axis(self, painter: QPainter, start: float, end: float, x, bottom: int) -> None:
        metrics = self.fontMetrics()
        label = metrics.horizontalAdvance(number(end, 1, is_grouped=False)) + 24
        ticks = round_ticks(
            start, end, max(int((self.width() - NAME_WIDTH_PX - TEXT_WIDTH_PX) / label), 2)
        )
        fine = len(ticks) > 1 and ticks[1] - ticks[0] < 1
        painter.setFont(theme.tabular_font(self.font()))
        for tick in ticks:
            painter.setPen(QColor(theme.GRID))
            painter.drawLine(QPointF(x(tick), TOP_MARGIN_PX), QPointF(x(tick), bottom + 4))
            painter.setPen(QColor(theme.TEXT))
            text = number(tick, 2 if fine else 0, is_grouped=False)
            box = QRectF(x(tick) - label / 2, bottom + 4, label, 18)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
        painter.setPen(QColor(theme.MUTED))
        box = QRectF(NAME_WIDTH_PX, bottom + 22, self.width() - NAME_WIDTH_PX - TEXT_WIDTH_PX, 18)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self._axis)

    def _draw_bar(self, painter: QPainter, bar: TimelineBar, top: int, x, width: int) -> None:
        middle = Qt.AlignmentFlag.AlignVCenter
        inset = self.row_height // 5
        if bar.path == self._current:
            painter.fillRect(QRectF(0, top, self.width(), self.row_height), QColor(theme.CURRENT))
        painter.setPen(QColor(theme.TEXT))
        name = self.fontMetrics().elidedText(
            bar.name, Qt.TextElideMode.ElideMiddle, NAME_WIDTH_PX - 24
        )
        painter.drawText(QRectF(12, top, NAME_WIDTH_PX - 20, self.row_height), middle, name)
        painter.setPen(QColor(theme.MUTED if bar.is_usable else theme.ERROR))
        box = QRectF(NAME_WIDTH_PX + width + 12, top, TEXT_WIDTH_PX - 16, self.row_height)
        painter.drawText(box, middle, self.fontMetrics().elidedText(
            bar.text, Qt.TextElideMode.ElideRight, TEXT_WIDTH_PX - 16))  # fmt: skip
        left, right = x(bar.start), x(bar.end)
        if right < NAME_WIDTH_PX or left > NAME_WIDTH_PX + width:
            edge = NAME_WIDTH_PX if right < NAME_WIDTH_PX else NAME_WIDTH_PX + width
            self._draw_distant_line(painter, bar, top, edge)
            return
        left, right = (
            max(left, NAME_WIDTH_PX),
            min(max(right, left + MIN_BAR_WIDTH_PX), NAME_WIDTH_PX + width),
        )
        whole = QRectF(left, top + inset, right - left, self.row_height - 2 * inset)
        painter.fillRect(whole, QColor(bar.colour))
        for first, last in bar.gaps:
            a, b = max(x(first), left), min(max(x(last), x(first) + 2), right)
            if b <= a:
                continue
            gap = QRectF(a, top + inset, b - a, self.row_height - 2 * inset)
            painter.fillRect(gap, QColor(theme.PAPER))
            painter.fillRect(gap, _hatch_brush())
            painter.setPen(QPen(QColor(theme.ERROR), 1))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(gap)
            text = gettext("{duration:s.1} s gap", duration=last - first)
            if not bar.is_line and self.fontMetrics().horizontalAdvance(text) + 8 < b - a:
                painter.fillRect(gap.adjusted(2, 2, -2, -2), QColor(theme.PAPER))
                painter.drawText(gap, Qt.AlignmentFlag.AlignCenter, text)

    def _draw_distant_line(
        self, painter: QPainter, bar: TimelineBar, top: int, edge: float
    ) -> None:
        """Draw an arrow for a line beyond the axis, and its distance in time."""
        before = edge == NAME_WIDTH_PX
        track = next(each for each in self.bars if not each.is_line)
        seconds = track.start - bar.end if before else bar.start - track.end
        side, y = (1 if before else -1), top + self.row_height / 2
        tip = edge + side * 4
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(bar.colour))
        painter.drawPolygon(QPolygonF([
            QPointF(tip, y), QPointF(tip + side * 11, y - 7), QPointF(tip + side * 11, y + 7)
        ]))  # fmt: skip
        painter.setPen(QColor(theme.ERROR))
        text = (
            gettext("{duration:s.0} s before the trajectory", duration=seconds)
            if before
            else gettext("{duration:s.0} s after the trajectory", duration=seconds)
        )
        align = Qt.AlignmentFlag.AlignLeft if before else Qt.AlignmentFlag.AlignRight
        box = (
            QRectF(tip + 18, top, 400, self.row_height)
            if before
            else QRectF(tip - 418, top, 400, self.row_height)
        )
        painter.drawText(box, align | Qt.AlignmentFlag.AlignVCenter, text)


def _bar_description(bar: TimelineBar) -> str:
    return gettext(
        "{name}: {start:s.1} to {end:s.1} s, {text}",
        name=bar.name, start=bar.start, end=bar.end, text=bar.text,
    )  # fmt: skip


def _hatch_brush() -> QBrush:
    return QBrush(QColor(theme.HATCH), Qt.BrushStyle.BDiagPattern)
