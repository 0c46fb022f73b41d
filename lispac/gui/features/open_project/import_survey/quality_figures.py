"""Figures of a trajectory: accuracies, track, speed and attitude, with the lines marked."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MultipleLocator
from numpy.typing import NDArray

from lispac.gui.appearance import theme, units
from lispac.gui.appearance.colour_schemes import Colour
from lispac.gui.features.open_project.import_survey.file_texts import time_axis_title
from lispac.gui.widgets.ticks import (
    FONT_SIZE,
    SMALL_SIZE,
    convert_axis_units,
    style_axes,
)
from lispac.io.points.line_times import LineTimes
from lispac.io.trajectory.trajectory_facts import motion_of
from lispac.language import gettext
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy
from lispac.workflow.importing.input_files import InputFiles
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]
LINE_STYLES = ("-", (0, (6, 3)), (0, (2, 2)))
"""Line styles of three curves, which stay visible where they coincide, such as north and east."""
MAX_TRACK_POINTS = 10_000
"""A longer track is thinned to between one and two times this number of points."""
FULL_TURN_DEG = 360.0
LETTER_WIDTH_SHARE = 0.0065
"""Width of a small letter as a share of the axis width, in the narrowest figure."""


@dataclass(frozen=True, eq=False)
class AttitudeRecord:
    """Attitude of the vessel over time, with the times of the lines.

    Attributes
    ----------
    time : ndarray of shape (n,), seconds
    attitude : ndarray of shape (n, 3), radians
        Roll, pitch (positive bow down), heading.
    lines : tuple of (str, float, float, str)
        Name, start and end in the trajectory's time base, colour.
    axis : str
        Title of the time axis.
    """

    time: Array
    attitude: Array
    lines: tuple[tuple[str, float, float, str], ...]
    longest_gap: float
    axis: str

    @classmethod
    def of_survey(cls, survey: Survey) -> "AttitudeRecord":
        """Collect the data of the survey of a project."""
        path = survey.trajectory
        colours = theme.line_colours(list(survey.lines))
        lines = tuple(
            (name, scan.first_time, scan.last_time, _hexadecimal(colours[name]))
            for name, scan in survey.scans.items()
        )
        return cls(path.time, path.attitude, lines, path.longest_gap, time_axis_title(None))


@dataclass(frozen=True, eq=False)
class TrajectoryQuality(AttitudeRecord):
    """Data of the figures of a trajectory in an import."""

    track: Trajectory
    sigmas: TrajectoryAccuracy | None

    @classmethod
    def of(cls, input_files: InputFiles) -> "TrajectoryQuality | None":
        """Collect the data of an import; None before its trajectory is read."""
        if input_files.trajectory_content is None:
            return None
        colours = theme.line_colours([str(line.path) for line in input_files.lines])
        lines = tuple(
            (
                input_files.names[line.path],
                line.content.start + line.shift,
                line.content.end + line.shift,
                _hexadecimal(colours[str(line.path)]),
            )
            for line in input_files.lines
            if isinstance(line.content, LineTimes)
        )
        path = input_files.trajectory_content
        axis = time_axis_title(input_files.time_base)
        return cls(
            path.time, path.attitude, lines, input_files.longest_gap, axis, path,
            input_files.accuracy_content,
        )  # fmt: skip


def draw_accuracies(quality: TrajectoryQuality, figure: Figure) -> None:
    """Draw standard deviations of position and attitude over time (thesis figures 4.17, 4.18)."""
    sigmas = quality.sigmas
    if sigmas is None:
        _show_text(
            figure,
            gettext(
                "There is no accuracy file. The standard deviations on the page Mounting and "
                "accuracies apply at all times.\nAdd an smrmsg file or a text export with "
                "standard deviations to plot them here."
            ),
        )
        return
    upper, lower = _time_axes(quality, figure, 2)
    for k, name in enumerate((gettext("North"), gettext("East"), gettext("Down"))):
        _draw_series(upper, quality, sigmas.time, sigmas.position[:, k], k, name)
    for k, name in enumerate((gettext("Roll"), gettext("Pitch"), gettext("Heading"))):
        values = np.degrees(sigmas.attitude[:, k])
        _draw_series(lower, quality, sigmas.time, values, k, name)
    upper.set_ylabel(gettext("Position\nσ (m)"), fontsize=FONT_SIZE)
    lower.set_ylabel(gettext("Attitude\nσ (°)"), fontsize=FONT_SIZE)
    convert_axis_units(upper.yaxis, "m")
    convert_axis_units(lower.yaxis, "°")
    for axes in (upper, lower):
        axes.set_ylim(0, 1.15 * axes.dataLim.y1 or 1.0)
        _add_legend(axes)


def draw_track(quality: TrajectoryQuality, figure: Figure) -> None:
    """Draw the track of the vessel as a map, with the lines in their colours."""
    figure.clear()
    axes = figure.add_subplot()
    style_axes(axes)
    path = quality.track
    frame, step = path.mean_frame(), max(1, len(path.time) // MAX_TRACK_POINTS)

    def plot_states(states: NDArray[np.int64], **style: object) -> None:
        north, west, _ = frame.to_local(
            path.latitude[states], path.longitude[states], path.height[states]
        ).T
        breaks = np.flatnonzero(np.diff(path.time[states]) > max(quality.longest_gap, gap)) + 1
        axes.plot(np.insert(-west, breaks, np.nan), np.insert(north, breaks, np.nan), **style)

    gap = 2.0 * step * float(np.median(np.diff(path.time[:1000])))
    gap_ends = np.flatnonzero(np.diff(path.time) > quality.longest_gap) + 1
    thinned = np.arange(0, len(path.time), step)
    states = np.unique(np.concatenate([thinned, gap_ends, gap_ends - 1]))
    plot_states(states, color=theme.WAITING, linewidth=1.2, label=gettext("Trajectory"))
    for k, (name, start, end, colour) in enumerate(quality.lines):
        # Lines on the same course overlap; earlier ones are wider and remain visible.
        width = min(3 + 1.8 * (len(quality.lines) - 1 - k), 12)
        first, last = np.searchsorted(path.time, (start, end))
        if last > first:
            states = np.arange(first, last, max(1, (last - first) // MAX_TRACK_POINTS))
            plot_states(states, color=colour, linewidth=width, solid_capstyle="butt",
                        label=_escape_dollars(name))  # fmt: skip
    plot_states(np.zeros(1, dtype=np.int64), marker="o", color=theme.TEXT, markersize=5,
                linestyle="none", label=gettext("Start"))  # fmt: skip
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel(gettext("East (m)"), fontsize=FONT_SIZE)
    axes.set_ylabel(gettext("North (m)"), fontsize=FONT_SIZE)
    for axis in (axes.xaxis, axes.yaxis):
        convert_axis_units(axis, "m")
    axes.grid(color=theme.GRID, linewidth=0.8)
    axes.legend(fontsize=SMALL_SIZE, frameon=False, labelcolor=theme.TEXT, loc="center left",
                bbox_to_anchor=(1.01, 0.5))  # fmt: skip


def draw_motion(quality: TrajectoryQuality, figure: Figure) -> None:
    """Draw speed, roll and pitch, and heading over time."""
    path = quality.track
    top, middle, bottom = _time_axes(quality, figure, 3)
    motion = motion_of(path.time, path.latitude, path.longitude, path.height)
    _draw_series(top, quality, path.time[motion.index], motion.speed, 0, "")
    for k, name in enumerate((gettext("Roll"), gettext("Pitch"))):
        _draw_series(middle, quality, path.time, np.degrees(path.attitude[:, k]), k, name)
    _draw_heading(bottom, quality)
    top.set_ylabel(gettext("Speed\n(m/s)"), fontsize=FONT_SIZE)
    top.set_ylim(bottom=0)
    middle.set_ylabel(gettext("Roll, pitch\n(°)"), fontsize=FONT_SIZE)
    convert_axis_units(middle.yaxis, "°")
    _add_legend(middle)


def draw_signs(record: AttitudeRecord, figure: Figure) -> None:
    """Draw roll, pitch and heading over time, with the motion that each positive sign means."""
    top, middle, bottom = _time_axes(record, figure, 3)
    for axes, angle, sign in ((top, 0, 1.0), (middle, 1, -1.0)):
        values = sign * np.degrees(record.attitude[:, angle])
        axes.axhline(0.0, color=theme.MUTED, linewidth=0.8)
        _draw_series(axes, record, record.time, values, angle, "")
        convert_axis_units(axes.yaxis, "°")
    top.set_ylabel(gettext("Roll (°)\n+ starboard down"), fontsize=FONT_SIZE)
    middle.set_ylabel(gettext("Pitch (°)\n+ bow up"), fontsize=FONT_SIZE)
    _draw_heading(bottom, record)


def _draw_heading(axes: Axes, record: AttitudeRecord) -> None:
    """Draw the heading without jumps at north, on an axis of at most one turn."""
    heading = np.degrees(np.unwrap(record.attitude[:, 2]))
    _draw_series(axes, record, record.time, heading, 0, "")
    span = float(np.ptp(heading))
    if span > FULL_TURN_DEG:
        step, curve = 90, axes.lines[-1]
        curve.set_data(*_in_one_turn(*map(np.asarray, curve.get_data())))
        axes.set_ylim(0, FULL_TURN_DEG)
    else:
        step = next((s for s in (1, 5, 10, 30, 45) if span / s <= 5), 90)
        axes.yaxis.set_major_formatter(
            FuncFormatter(lambda value, _: units.localised(f"{value % FULL_TURN_DEG:.3g}"))
        )
    axes.yaxis.set_major_locator(MultipleLocator(step))
    axes.set_ylabel(gettext("Heading\n(°)"), fontsize=FONT_SIZE)


def _in_one_turn(time: Array, heading: Array) -> tuple[Array, Array]:
    """Curve with the part of each turn from 0 to 360 degrees and the points next to it."""
    times, headings = [], []
    known = heading[np.isfinite(heading)]
    first, last = np.floor_divide([known.min(), known.max()], FULL_TURN_DEG)
    for turn in np.arange(first, last + 1):
        shifted = heading - turn * FULL_TURN_DEG
        inside = (shifted >= 0) & (shifted <= FULL_TURN_DEG)
        near = np.convolve(inside, [1, 1, 1], "same") > 0
        shown = np.convolve(near, [1, 1, 1], "same") > 0  # with a break after each part
        # Each part ends with a break: the next one may begin at an earlier time
        times.append(np.append(time[shown], np.nan))
        headings.append(np.append(np.where(near, shifted, np.nan)[shown], np.nan))
    return np.concatenate(times), np.concatenate(headings)


DRAW_FUNCTIONS: dict[str, Callable[[TrajectoryQuality, Figure], None]] = {
    "accuracies": draw_accuracies, "track": draw_track, "motion": draw_motion,
}  # fmt: skip


def _time_axes(quality: AttitudeRecord, figure: Figure, count: int) -> Sequence[Axes]:
    figure.clear()
    all_axes = list(np.atleast_1d(figure.subplots(count, 1, sharex=True)))
    for axes in all_axes:
        style_axes(axes)
        axes.grid(axis="y", color=theme.GRID, linewidth=0.8)
        for _, start, end, colour in quality.lines:
            axes.axvspan(start, end, color=colour, alpha=0.16, linewidth=0)
    start, end = float(quality.time[0]), float(quality.time[-1])
    last = all_axes[-1]
    last.set_xlim(start, end)
    last.xaxis.set_major_formatter(FuncFormatter(lambda value, _: units.localised(f"{value:.10g}")))
    last.set_xlabel(quality.axis, fontsize=FONT_SIZE)
    first, end_of_names = all_axes[0], -np.inf
    for name, begin, finish, _ in sorted(quality.lines, key=lambda line: line[1]):
        middle = (begin + finish) / 2
        half = LETTER_WIDTH_SHARE * (end - start) * len(name) / 2
        # Names that would overlap are omitted; the timeline shows them.
        if start <= middle <= end and middle - half > end_of_names:
            end_of_names = middle + half
            first.annotate(
                _escape_dollars(name),
                (middle, 1),
                xycoords=("data", "axes fraction"),
                xytext=(0, 2),
                textcoords="offset points",
                ha="center",
                va="bottom",
                fontsize=SMALL_SIZE,
                color=theme.MUTED,
            )
    return all_axes


def _draw_series(
    axes: Axes, quality: AttitudeRecord, time: Array, values: Array, k: int, name: str
) -> None:
    shown = envelope(
        time, values, longest_gap=max(quality.longest_gap, _longest_regular_step(time))
    )
    # Dashes of an envelope would be invisible and slow to draw.
    style = LINE_STYLES[k] if len(shown[0]) >= len(time) else "-"
    axes.plot(
        *shown, color=theme.current_scheme().series[k], linestyle=style, linewidth=1.2, label=name
    )


def _longest_regular_step(time: Array) -> float:
    """Longest time step that is not a gap: three times the median, seconds.

    Accuracies are often given at 1 Hz only, so the limit of gaps of the trajectory may be shorter.
    """
    return 3 * float(np.median(np.diff(time))) if len(time) > 1 else 0.0


def _show_text(figure: Figure, text: str) -> None:
    figure.clear()
    figure.text(0.5, 0.5, text, ha="center", va="center", fontsize=FONT_SIZE + 1, color=theme.MUTED)


def _hexadecimal(colour: Colour) -> str:
    return "#{:02x}{:02x}{:02x}".format(*colour)


def _escape_dollars(name: str) -> str:
    return name.replace("$", r"\$")


def _add_legend(axes: Axes) -> None:
    axes.legend(fontsize=SMALL_SIZE, frameon=False, labelcolor=theme.TEXT, loc="center left",
                bbox_to_anchor=(1.005, 0.5), borderaxespad=0.1)  # fmt: skip


ENVELOPE_INTERVALS = 1500
"""Number of time intervals of an envelope; more than an axis has pixels."""


def envelope(
    time: Array, values: Array, *, bins: int = ENVELOPE_INTERVALS, longest_gap: float = np.inf
) -> tuple[Array, Array]:
    """Smallest and largest value of each of ``bins`` time intervals, with NaN at gaps.

    A short series, of at most ``4 * bins`` values, is returned as it is, with NaN at gaps.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds, increasing
    values : ndarray of shape (n,)
    longest_gap : float, seconds
        Longer gaps break the line.

    Returns
    -------
    time, values : ndarray of shape (m,)
    """
    breaks = np.flatnonzero(np.diff(time) > longest_gap) + 1
    if len(time) > 4 * bins:
        edges = np.linspace(time[0], time[-1], bins + 1)
        starts = np.unique(np.concatenate([np.searchsorted(time, edges[:-1]), breaks]))
        starts = starts[starts < len(time)]
        low = np.minimum.reduceat(values, starts)
        high = np.maximum.reduceat(values, starts)
        ends = np.append(starts[1:], len(time)) - 1
        time_out = np.stack([time[starts], time[ends]], axis=1).ravel()
        values_out = np.stack([low, high], axis=1).ravel()
        places = 2 * np.searchsorted(starts, breaks)
    else:
        time_out, values_out, places = time, values, breaks
    if len(places):
        time_out = np.insert(time_out, places, time_out[places])
        values_out = np.insert(values_out, places, np.nan)
    return time_out, values_out
