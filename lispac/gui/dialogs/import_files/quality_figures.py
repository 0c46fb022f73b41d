"""What a trajectory looks like: accuracies, track, speed and attitude, with the lines marked."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MultipleLocator
from numpy.typing import NDArray

from lispac.gui import theme
from lispac.gui.dialogs.import_files.envelope import envelope
from lispac.gui.language import say
from lispac.gui.panels.ticks import in_units
from lispac.io.line_times import LineTimes
from lispac.io.trajectory_facts import motion_of
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy
from lispac.workflow.intake import Intake

Array = NDArray[np.float64]
STYLES = ("-", (0, (6, 3)), (0, (2, 2)))
"""Two of the same value, as north and east often are, stay visible."""
TEXT, SMALL = 9, 8
MOST_STATES = 10_000
"""Of a track that are drawn."""
LETTER = 0.0065
"""Width of a small letter as part of an axis's width, in a figure as narrow as they come."""


@dataclass(frozen=True, eq=False)
class Quality:
    """What the figures show.

    Attributes
    ----------
    lines : tuple of (str, float, float, str)
        Name, start and end in the trajectory's time base, colour.
    axis : str
        Name of the time base.
    """

    track: Trajectory
    sigmas: TrajectoryAccuracy | None
    lines: tuple[tuple[str, float, float, str], ...]
    longest_gap: float
    axis: str

    @classmethod
    def of(cls, intake: Intake) -> "Quality | None":
        """Of an intake; None before its trajectory is read."""
        if intake.track is None:
            return None
        colours = theme.line_colours([str(line.path) for line in intake.lines])
        lines = tuple(
            (
                intake.names[line.path],
                line.content.start + line.shift,
                line.content.end + line.shift,
                "#{:02x}{:02x}{:02x}".format(*colours[str(line.path)]),
            )
            for line in intake.lines
            if isinstance(line.content, LineTimes)
        )
        base = intake.time_base
        axis = "Time, s" if base is None else f"{base.name[:1].upper()}{base.name[1:]}"
        return cls(intake.track, intake.sigmas, lines, intake.longest_gap, axis)


def accuracies(quality: Quality, figure: Figure) -> None:
    """Standard deviations of position and attitude over time (thesis figures 4.17 and 4.18)."""
    sigmas = quality.sigmas
    if sigmas is None:
        _say(
            figure,
            "No accuracy file: the sigmas typed under Mounting and accuracies hold at all times.\n"
            "With smrmsg, or the standard deviations of a text export, their course appears here.",
        )
        return
    upper, lower = _axes(quality, figure, 2)
    for k, name in enumerate(("North", "East", "Down")):
        _draw(upper, quality, sigmas.time, sigmas.position[:, k], k, name)
    for k, name in enumerate(("Roll", "Pitch", "Heading")):
        values = np.degrees(sigmas.attitude[:, k])
        _draw(lower, quality, sigmas.time, values, k, name)
    upper.set_ylabel(say("Position\nσ, m"), fontsize=TEXT)
    lower.set_ylabel(say("Attitude\nσ, °"), fontsize=TEXT)
    in_units(upper.yaxis, "m")
    in_units(lower.yaxis, "°")
    for axes in (upper, lower):
        axes.set_ylim(0, 1.15 * axes.dataLim.y1 or 1.0)
        _legend(axes)


def track(quality: Quality, figure: Figure) -> None:
    """The way of the vessel on a map, with the lines in their colours."""
    figure.clear()
    axes = figure.add_subplot()
    _dress(axes)
    path = quality.track
    frame, step = path.mean_frame(), max(1, len(path.time) // MOST_STATES)

    def plotted(states: NDArray[np.int64], **looks: object) -> None:
        north, west, _ = frame.to_local(
            path.latitude[states], path.longitude[states], path.height[states]
        ).T
        breaks = np.flatnonzero(np.diff(path.time[states]) > max(quality.longest_gap, gap)) + 1
        axes.plot(np.insert(-west, breaks, np.nan), np.insert(north, breaks, np.nan), **looks)

    gap = 2.0 * step * float(np.median(np.diff(path.time[:1000])))
    wide = np.flatnonzero(np.diff(path.time) > quality.longest_gap) + 1
    every = np.unique(np.concatenate([np.arange(0, len(path.time), step), wide, wide - 1]))
    plotted(every, color=theme.WAITING, linewidth=1.2, label=say("Trajectory"))
    for k, (name, start, end, colour) in enumerate(quality.lines):
        # Lines of one course lie over each other: the earlier ones are wider and show beside.
        width = min(3 + 1.8 * (len(quality.lines) - 1 - k), 12)
        first, last = np.searchsorted(path.time, (start, end))
        if last > first:
            states = np.arange(first, last, max(1, (last - first) // MOST_STATES))
            plotted(states, color=colour, linewidth=width, solid_capstyle="butt",
                    label=_plain(name))  # fmt: skip
    plotted(np.zeros(1, dtype=np.int64), marker="o", color=theme.TEXT, markersize=5,
            linestyle="none", label=say("Start"))  # fmt: skip
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel(say("East, m"), fontsize=TEXT)
    axes.set_ylabel(say("North, m"), fontsize=TEXT)
    for axis in (axes.xaxis, axes.yaxis):
        in_units(axis, "m")
    axes.grid(color=theme.GRID, linewidth=0.8)
    axes.legend(fontsize=SMALL, frameon=False, labelcolor=theme.TEXT, loc="center left",
                bbox_to_anchor=(1.01, 0.5))  # fmt: skip


def motion(quality: Quality, figure: Figure) -> None:
    """Speed, roll and pitch, heading over time."""
    path = quality.track
    top, middle, bottom = _axes(quality, figure, 3)
    moved = motion_of(path.time, path.latitude, path.longitude, path.height)
    _draw(top, quality, path.time[moved.index], moved.speed, 0, "")
    for k, name in enumerate(("Roll", "Pitch")):
        _draw(middle, quality, path.time, np.degrees(path.attitude[:, k]), k, name)
    # Unwrapped, so that no line runs across the figure where north is passed.
    heading = np.degrees(np.unwrap(path.attitude[:, 2]))
    _draw(bottom, quality, path.time, heading, 0, "")
    reach = float(np.ptp(heading))
    step = next((s for s in (1, 5, 10, 30, 45, 90, 180) if reach / s <= 5), 360)
    bottom.yaxis.set_major_locator(MultipleLocator(step))
    bottom.yaxis.set_major_formatter(FuncFormatter(lambda value, _: say(f"{value % 360:.3g}")))
    top.set_ylabel(say("Speed\nm/s"), fontsize=TEXT)
    top.set_ylim(bottom=0)
    middle.set_ylabel(say("Roll, pitch\n°"), fontsize=TEXT)
    in_units(middle.yaxis, "°")
    _legend(middle)
    bottom.set_ylabel(say("Heading\n°"), fontsize=TEXT)


PAGES: dict[str, Callable[[Quality, Figure], None]] = {
    "Accuracies": accuracies, "Track": track, "Speed and attitude": motion,
}  # fmt: skip


def _axes(quality: Quality, figure: Figure, count: int) -> Sequence[Axes]:
    figure.clear()
    all_axes = list(np.atleast_1d(figure.subplots(count, 1, sharex=True)))
    for axes in all_axes:
        _dress(axes)
        axes.grid(axis="y", color=theme.GRID, linewidth=0.8)
        for _, start, end, colour in quality.lines:
            axes.axvspan(start, end, color=colour, alpha=0.16, linewidth=0)
    start, end = float(quality.track.time[0]), float(quality.track.time[-1])
    last = all_axes[-1]
    last.set_xlim(start, end)
    last.xaxis.set_major_formatter(FuncFormatter(lambda value, _: say(f"{value:,.10g}")))
    last.set_xlabel(say(quality.axis), fontsize=TEXT)
    first, free = all_axes[0], -np.inf
    for name, begin, finish, _ in sorted(quality.lines, key=lambda line: line[1]):
        middle = (begin + finish) / 2
        half = LETTER * (end - start) * len(name) / 2
        # Names that would lie over each other are left to the timeline.
        if start <= middle <= end and middle - half > free:
            free = middle + half
            first.annotate(
                _plain(name), (middle, 1), xycoords=("data", "axes fraction"), xytext=(0, 2),
                textcoords="offset points", ha="center", va="bottom", fontsize=SMALL,
                color=theme.MUTED,
            )  # fmt: skip
    return all_axes


def _draw(axes: Axes, quality: Quality, time: Array, values: Array, k: int, name: str) -> None:
    shown = envelope(time, values, longest_gap=max(quality.longest_gap, _usual_step(time)))
    # Dashes mean nothing, and take long to draw, where a line runs up and down in each column.
    style = STYLES[k] if len(shown[0]) >= len(time) else "-"
    axes.plot(
        *shown, color=theme.scheme().series[k], linestyle=style, linewidth=1.2, label=say(name)
    )


def _usual_step(time: Array) -> float:
    """Accuracies come at 1 Hz or slower: several of their steps are no gap."""
    return 3 * float(np.median(np.diff(time))) if len(time) > 1 else 0.0


def _say(figure: Figure, text: str) -> None:
    figure.clear()
    figure.text(0.5, 0.5, say(text), ha="center", va="center", fontsize=TEXT + 1, color=theme.MUTED)


def _plain(name: str) -> str:
    return name.replace("$", r"\$")


def _dress(axes: Axes) -> None:
    axes.set_facecolor(theme.PAPER)
    axes.tick_params(labelsize=SMALL, colors=theme.TEXT)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["left", "bottom"]].set_color(theme.MUTED)
    for label in (axes.xaxis.label, axes.yaxis.label):
        label.set_color(theme.TEXT)


def _legend(axes: Axes) -> None:
    axes.legend(fontsize=SMALL, frameon=False, labelcolor=theme.TEXT, loc="center left",
                bbox_to_anchor=(1.005, 0.5), borderaxespad=0.1)  # fmt: skip
