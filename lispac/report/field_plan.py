"""One page for the field: where the boards hang, which lines to sail in which order."""

from collections.abc import Sequence
from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from lispac.design.plan import Line, Plan
from lispac.design.prediction import predict
from lispac.design.site import Wall, least_off
from lispac.report.figures import AFTER, BEFORE, GRID, INK, SMALL, TEXT
from lispac.simulation.closed_form import Ball, Board

Array = NDArray[np.float64]

PAGE = (8.27, 11.69)
"""Inches: A4."""

WALL, WRONG = "#8a8f98", "#b3261e"
ASSUMED = (
    "Heights are above the vessel's POS. The distance is from the middle of the site to the line; "
    "off wall: the least on the way; straight from, to: metres along the line before and after the "
    "middle is abeam. Keep course "
    "and speed there. The order of the lines counts. Hang the boards flat and firm: the sigmas "
    "rest on their not moving by a millimetre. Headings are from true north. Along is counted to "
    "the right from the middle of the site: mark it on the wall first."
)
PITCH, CLOSEST, ROOM, LIFT = 0.019, 0.0115, 0.24, 0.26
"""Shares of the page: height of a row, the least of it, what rows have beside usual drawings, and
what drawings give of theirs where there are many."""
MOST_CAUTIONS, WIDE = 3, 140
"""Cautions that are printed, and letters in a line."""
BARS = (1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0)
"""Metres: lengths of the scale."""


def field_plan(
    plan: Plan, wall: Wall, title: str, notes: Sequence[str] = (), *, cautions: Sequence[str] = ()
) -> Figure:
    """Drawing, boards, lines and what is to be expected, on one page.

    Parameters
    ----------
    wall : Wall
        On the water.
    notes : sequence of str
        Printed below: what the plan rests on.
    cautions : sequence of str
        What of the plan cannot be done.
    """
    if len(cautions) > MOST_CAUTIONS:
        others = len(cautions) - MOST_CAUTIONS
        cautions = (*cautions[:MOST_CAUTIONS], f"And {others} more like these.")
    rows = len(plan.targets) + len(plan.lines) + 4.6 + len(cautions)
    lift = float(np.clip(rows * CLOSEST - ROOM, 0.0, LIFT)) if rows * PITCH > ROOM else 0.0
    pitch = min(PITCH, (ROOM + lift) / rows)
    figure = Figure(figsize=PAGE)
    figure.text(0.07, 0.955, title, fontsize=15, weight="bold", color=INK)
    figure.text(0.07, 0.933, _expected(plan), fontsize=TEXT + 1, color=INK)
    _from_above(figure.add_axes((0.09, 0.52 + lift, 0.85, 0.39 - lift)), plan, wall)
    _front(figure.add_axes((0.09, 0.365 + lift, 0.85, 0.105)), plan, wall)
    low = 0.325 + lift
    _table(figure, low, pitch, "Targets", TARGET_HEADS, _target_rows(plan, wall))
    low -= pitch * (len(plan.targets) + 2.3)
    _table(figure, low, pitch, "Lines, in this order", LINE_HEADS, _line_rows(plan, wall))
    low -= pitch * (len(plan.lines) + 2.3)
    for caution in cautions:
        figure.text(0.07, low, caution, fontsize=TEXT, color=WRONG, va="top", weight="bold")
        low -= pitch
    text = "\n".join(fill(note, WIDE) for note in (ASSUMED, _rests_on(plan), *notes))
    figure.text(0.07, low, text, fontsize=SMALL, color=INK, va="top", linespacing=1.4)
    return figure


def _expected(plan: Plan) -> str:
    found = predict(plan)
    if not found.determined:
        return "This plan does not determine the boresight."
    sigma = np.degrees(found.sigma)
    return (
        f"Expected (1 sigma): roll {sigma[0]:.4f}, pitch {sigma[1]:.4f}, yaw {sigma[2]:.4f} deg; "
        f"{plan.duration / 60:.0f} minutes of lines"
    )


def _rests_on(plan: Plan) -> str:
    pos = plan.system.pos
    mm = ", ".join(f"{1000 * value:g}" for value in pos.sigma_position)
    deg = ", ".join(f"{value:.3g}" for value in np.degrees(pos.sigma_attitude))
    return (
        f"Expected with a POS of {mm} mm (north, east, up) and {deg} deg (roll, pitch, heading), "
        f"and targets flat to {1000 * plan.flatness:g} mm."
    )


def _from_above(axes: Axes, plan: Plan, wall: Wall) -> None:
    """East to the right, north up; the wall, the targets and the lines with their numbers."""
    middle = np.array(plan.middle[:2])
    aside = 0.02 * max(line.distance for line in plan.lines)  # opposite lines beside each other
    begins: dict[tuple[float, float], list[int]] = {}
    reach = max(line.distance for line in plan.lines) + 5.0
    ends = middle + np.outer([-reach, reach], wall.right)
    axes.plot(*_east_north(ends), color=WALL, linewidth=3, zorder=1)
    for k, (line, (start, stop)) in enumerate(zip(plan.lines, plan.runs, strict=True), start=1):
        direction, abeam = _direction(line), np.array(line.abeam(plan.middle))
        abeam = abeam + aside * np.array([direction[1], -direction[0]])
        first, last = abeam + start * direction, abeam + stop * direction
        (x0, x1), (y0, y1) = _east_north(np.stack([first, last]))
        axes.annotate(
            "", (x1, y1), (x0, y0), arrowprops={"arrowstyle": "-|>", "color": BEFORE, "lw": 1.3}
        )
        axes.plot([x0, x1], [y0, y1], linewidth=0)
        begins.setdefault((round(x0, 1), round(y0, 1)), []).append(k)
    for (x0, y0), numbers in begins.items():
        axes.text(
            x0, y0, ", ".join(map(str, numbers)), fontsize=TEXT, color="white", ha="center",
            va="center", bbox={"boxstyle": "round,pad=0.25", "fc": BEFORE, "ec": "none"},
        )  # fmt: skip
    places: dict[tuple[float, float], list[str]] = {}
    for target in plan.targets:
        east, north = -target.centre[1], target.centre[0]
        axes.plot(east, north, "s" if isinstance(target, Board) else "o", color=AFTER, ms=5)
        places.setdefault((round(east, 1), round(north, 1)), []).append(target.name)
    for place, names in places.items():  # boards above each other are one mark from above
        axes.annotate(", ".join(names), place, xytext=(5, 4), textcoords="offset points",
                      fontsize=SMALL, color=INK)  # fmt: skip
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(True, color=GRID, linewidth=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=SMALL, colors=INK)
    axes.set_xlabel("East (m)", fontsize=TEXT, color=INK)
    axes.set_ylabel("North (m)", fontsize=TEXT, color=INK)
    _north_and_scale(axes)
    axes.set_title(
        "From above; numbers stand where a line begins, opposite lines are drawn beside each other",
        fontsize=TEXT,
        color=INK,
        loc="left",
    )


def _north_and_scale(axes: Axes) -> None:
    """An arrow to the north, which is up, and a bar as long as is written on it."""
    axes.apply_aspect()
    axes.autoscale(False)
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    wide, tall = right - left, high - low
    x, y = right - 0.04 * wide, high - 0.22 * tall
    axes.arrow(
        x, y, 0.0, 0.1 * tall, width=0.003 * wide, head_width=0.016 * wide,
        head_length=0.04 * tall, length_includes_head=True, color=INK,
    )  # fmt: skip
    axes.text(x, y + 0.11 * tall, "N", fontsize=TEXT + 2, weight="bold", color=INK, ha="center")
    bar = max((each for each in BARS if each <= 0.2 * wide), default=BARS[0])
    x, y = left + 0.03 * wide, low + 0.05 * tall
    axes.plot([x, x + bar], [y, y], color=INK, linewidth=3, solid_capstyle="butt")
    axes.text(x + bar / 2, y + 0.015 * tall, f"{bar:g} m", fontsize=TEXT, color=INK, ha="center")


def _front(axes: Axes, plan: Plan, wall: Wall) -> None:
    """The wall as it is seen from the water."""
    for target in plan.targets:
        along = wall.seen(target.centre)[0]
        up = target.centre[2]
        if isinstance(target, Ball):
            wide = tall = 2 * target.radius
        else:
            wide, tall = target.width, target.height * float(np.hypot(*target.facing[:2]))
        axes.fill_between(
            [along - wide / 2, along + wide / 2], up - max(tall, 0.1) / 2, up + max(tall, 0.1) / 2,
            color=AFTER, alpha=0.8, linewidth=0,
        )  # fmt: skip
        axes.annotate(target.name, (along + wide / 2, up), xytext=(3, 0), fontsize=SMALL,
                      textcoords="offset points", va="center", color=INK)  # fmt: skip
    axes.margins(0.12, 0.25)
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(True, color=GRID, linewidth=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=SMALL, colors=INK)
    axes.set_xlabel(
        "Along the wall, to the right as seen from the water (m)", fontsize=TEXT, color=INK
    )
    axes.set_ylabel("Above POS (m)", fontsize=TEXT, color=INK)


TARGET_HEADS = (
    "target", "along (m)", "off the wall (m)", "above POS (m)", "size (m)", "from level (deg)",
    "faces (deg)",
)  # fmt: skip
AT = (0.07, 0.165, 0.29, 0.425, 0.555, 0.67, 0.82)
"""Where columns begin."""
LINE_HEADS = (
    "line", "heading (deg)", "distance (m)", "site on", "off wall (m)", "speed (m/s)",
    "straight from, to (m)",
)  # fmt: skip


def _target_rows(plan: Plan, wall: Wall) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = []
    for target in plan.targets:
        along, off, up = wall.seen(target.centre)
        place = (target.name, _signed(along), _signed(off), f"{up:.2f}")
        if isinstance(target, Ball):
            rows.append((*place, f"ball, r {target.radius:.3f}", "", ""))
            continue
        lean, azimuth = wall.facing_of(target)
        faces = "" if lean < 0.05 or lean > 179.95 else f"{azimuth:.0f}"
        rows.append((*place, f"{target.width:.2f} x {target.height:.2f}", _leans(lean), faces))
    return rows


def _signed(metres: float) -> str:
    return f"{metres:+.2f}" if abs(metres) >= 0.005 else "0.00"


def _leans(degrees: float) -> str:
    """Inclination from level in words: 90 is upright."""
    if abs(degrees - 90.0) < 0.5:
        return "90, upright"
    return f"{degrees:.0f}, leans back" if degrees < 90.0 else f"{180 - degrees:.0f}, leans forward"


def _line_rows(plan: Plan, wall: Wall) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = []
    each = zip(plan.lines, plan.runs, least_off(plan, wall), strict=True)
    for k, (line, (start, stop), off) in enumerate(each, start=1):
        rows.append(
            (
                f"{k}", f"{line.heading_deg % 360:.0f}", f"{line.distance:g}",
                "starboard" if line.starboard else "port", f"{off:.1f}", f"{line.speed:g}",
                f"{start:+.0f}, {stop:+.0f}",
            )
        )  # fmt: skip
    return rows


def _table(
    figure: Figure, top: float, pitch: float, title: str, heads: Sequence[str],
    rows: Sequence[Sequence[str]],
) -> None:  # fmt: skip
    figure.text(0.07, top, title, fontsize=TEXT + 1, weight="bold", color=INK, va="top")
    for k, row in enumerate([heads, *rows]):
        for x, value in zip(AT, row, strict=True):
            figure.text(x, top - pitch * (k + 1), value, fontsize=TEXT, color=INK, va="top",
                        weight="bold" if k == 0 else "normal")  # fmt: skip


def _direction(line: Line) -> Array:
    heading = np.radians(line.heading_deg)
    return np.array([np.cos(heading), -np.sin(heading)])


def _east_north(places: Array) -> tuple[Array, Array]:
    return -places[:, 1], places[:, 0]
