"""Survey plan for the field on one page: positions of the targets, and the lines in order."""

from collections.abc import Sequence
from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from lispac.design.plan import Line, Plan
from lispac.design.prediction import predict
from lispac.design.site import Wall
from lispac.language import N_, Plural, gettext
from lispac.present.planning.survey_plan import (
    PLANNED_LINES_TABLE,
    PLANNED_TARGETS_TABLE,
    planned_lines,
    planned_targets,
)
from lispac.present.text_format import fixed_number, localised_number, shortest_number
from lispac.report.document_blocks import Table, report_table
from lispac.report.figures import (
    GRID_COLOUR,
    INK_COLOUR,
    MAIN_COLOUR,
    OTHER_COLOUR,
    SMALL_TEXT_SIZE,
    TEXT_SIZE,
    LocalisedFormatter,
    draw_north_arrow,
)
from lispac.simulation.closed_form_survey import Ball, Board

Array = NDArray[np.float64]

PAGE_SIZE = (8.27, 11.69)
"""Width and height of an A4 page, inches."""

WALL_COLOUR, WARNING_COLOUR = "#8a8f98", "#b3261e"
EXPLANATION_TEXT = N_(
    "Heights are relative to the POS of the vessel. Along wall: distance to the right of the "
    "middle of the site; mark the middle on the wall first. From wall: positive towards the "
    "water. Azimuth: direction that the board faces. Distance: from the middle of the site to the "
    "line. Clearance: smallest distance between line and wall. Straight part: to be run at "
    "constant course and speed, in metres before (−) and after (+) the middle of the site is "
    "abeam. Run the lines in the given order. Headings and azimuths are from true north. Fix the "
    "boards flat and firmly: the predicted sigmas assume that they do not move."
)
ROW_HEIGHT, MIN_ROW_HEIGHT, TABLES_HEIGHT, MAX_REDUCTION = 0.019, 0.0115, 0.24, 0.26
"""Shares of the page height: usual and smallest height of a row, space for the rows below drawings
of the usual height, and largest reduction of the drawings if there are many rows."""
MAX_PRINTED_WARNINGS, MAX_LINE_LENGTH = 3, 140
"""Largest number of printed warnings, and of characters in a line of text."""
OMITTED_WARNINGS_TEXT = Plural(
    "{count:n} more warning is not shown.", "{count:n} more warnings are not shown."
)
SCALE_BAR_LENGTHS_M = (1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0)
"""Possible lengths of the scale bar, metres."""


def field_plan_figure(
    plan: Plan, wall: Wall, title: str, notes: Sequence[str] = (), *, warnings: Sequence[str] = ()
) -> Figure:
    """Figure of one page with drawings, targets, lines and predicted sigmas.

    Parameters
    ----------
    wall : Wall
        Wall of the site, to which the positions of the targets refer.
    notes : sequence of str
        Further assumptions of the plan, printed at the end.
    warnings : sequence of str
        Warnings about parts of the plan that cannot be realised.
    """
    if len(warnings) > MAX_PRINTED_WARNINGS:
        rest = gettext(OMITTED_WARNINGS_TEXT, count=len(warnings) - MAX_PRINTED_WARNINGS)
        warnings = (*warnings[:MAX_PRINTED_WARNINGS], rest)
    rows = len(plan.targets) + len(plan.lines) + 4.6 + len(warnings)
    reduction = (
        float(np.clip(rows * MIN_ROW_HEIGHT - TABLES_HEIGHT, 0.0, MAX_REDUCTION))
        if rows * ROW_HEIGHT > TABLES_HEIGHT
        else 0.0
    )
    row_height = min(ROW_HEIGHT, (TABLES_HEIGHT + reduction) / rows)
    figure = Figure(figsize=PAGE_SIZE)
    figure.text(0.07, 0.955, title, fontsize=15, weight="bold", color=INK_COLOUR)
    figure.text(0.07, 0.933, _predicted_sigma_text(plan), fontsize=TEXT_SIZE + 1, color=INK_COLOUR)
    _draw_plan_view(figure.add_axes((0.09, 0.52 + reduction, 0.85, 0.39 - reduction)), plan, wall)
    _draw_front_view(figure.add_axes((0.09, 0.365 + reduction, 0.85, 0.105)), plan, wall)
    low = 0.325 + reduction
    targets = report_table(PLANNED_TARGETS_TABLE, planned_targets(plan, wall))
    _draw_table(figure, low, row_height, targets)
    low -= row_height * (len(plan.targets) + 2.3)
    lines = report_table(PLANNED_LINES_TABLE, planned_lines(plan, wall))
    _draw_table(figure, low, row_height, lines)
    low -= row_height * (len(plan.lines) + 2.3)
    for warning in warnings:
        figure.text(
            0.07, low, warning, fontsize=TEXT_SIZE, color=WARNING_COLOUR, va="top", weight="bold"
        )
        low -= row_height
    text = "\n".join(
        fill(note, MAX_LINE_LENGTH)
        for note in (
            gettext(EXPLANATION_TEXT),
            *_control_texts(plan),
            _assumptions_text(plan),
            *notes,
        )
    )
    figure.text(
        0.07, low, text, fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR, va="top", linespacing=1.4
    )
    return figure


def _predicted_sigma_text(plan: Plan) -> str:
    found = predict(plan)
    if not found.determined:
        return gettext("This survey plan does not determine the boresight angles.")
    roll, pitch, yaw = found.sigma
    return gettext(
        "Predicted (1 sigma): roll {roll:deg.4}, pitch {pitch:deg.4}, yaw {yaw:deg.4}°. Time on "
        "site: {minutes} min.",
        roll=roll, pitch=pitch, yaw=yaw, minutes=fixed_number(plan.duration / 60, 0),
    )  # fmt: skip


def _assumptions_text(plan: Plan) -> str:
    pos, lever_arm = plan.system.pos, plan.system.lever_arm_sigma
    sentence = gettext(
        "Prediction for POS sigmas of {position} mm (north, east, up) and {attitude}° (roll, "
        "pitch, heading), and for targets with a form error of {flatness} mm.",
        position=_triple_text([shortest_number(1000 * value) for value in pos.sigma_position]),
        attitude=_triple_text(
            [localised_number(f"{value:.3g}") for value in np.degrees(pos.sigma_attitude)]
        ),
        flatness=shortest_number(1000 * plan.flatness),
    )
    if not any(lever_arm):
        return sentence
    sigmas = _triple_text([shortest_number(1000 * value) for value in lever_arm])
    also = gettext(
        "It contains the lever arm with a sigma of {sigma} mm (forward, left, up).", sigma=sigmas
    )
    return f"{sentence} {also}"


def _control_texts(plan: Plan) -> list[str]:
    """Instruction to survey the targets; empty without control."""
    targets = [
        gettext(
            "{target} ({sigma} mm)", target=target.name,
            sigma=shortest_number(1000 * target.control_sigma),
        )
        for target in plan.targets
        if target.control_sigma is not None
    ]  # fmt: skip
    if not targets:
        return []
    return [
        gettext(
            "Survey the four corners of the boards, and the centres of the spheres, in the "
            "reference frame of the trajectory, with a standard deviation of at most (on each "
            "axis): {targets:names}.",
            targets=targets,
        )
    ]


def _triple_text(numbers: Sequence[str]) -> str:
    x, y, z = numbers
    return gettext("{x}, {y}, {z}", x=x, y=y, z=z)


def _draw_plan_view(axes: Axes, plan: Plan, wall: Wall) -> None:
    """Draw wall, targets and numbered lines in plan view, north up."""
    middle = np.array(plan.middle[:2])
    offset = 0.02 * max(line.distance for line in plan.lines)  # opposite lines side by side
    begins: dict[tuple[float, float], list[int]] = {}
    reach = max(line.distance for line in plan.lines) + 5.0
    ends = middle + np.outer([-reach, reach], wall.rightward)
    axes.plot(*_east_north(ends), color=WALL_COLOUR, linewidth=3, zorder=1)
    for k, (line, (start, stop)) in enumerate(
        zip(plan.lines, plan.straight_extents, strict=True), start=1
    ):
        direction, abeam = _direction(line), np.array(line.abeam(plan.middle))
        abeam = abeam + offset * np.array([direction[1], -direction[0]])
        first, last = abeam + start * direction, abeam + stop * direction
        (x0, x1), (y0, y1) = _east_north(np.stack([first, last]))
        axes.annotate(
            "",
            (x1, y1),
            (x0, y0),
            arrowprops={"arrowstyle": "-|>", "color": MAIN_COLOUR, "lw": 1.3},
        )
        axes.plot([x0, x1], [y0, y1], linewidth=0)
        begins.setdefault((round(x0, 1), round(y0, 1)), []).append(k)
    for (x0, y0), numbers in begins.items():
        axes.text(
            x0, y0, ", ".join(map(str, numbers)), fontsize=TEXT_SIZE, color="white", ha="center",
            va="center", bbox={"boxstyle": "round,pad=0.25", "fc": MAIN_COLOUR, "ec": "none"},
        )  # fmt: skip
    places: dict[tuple[float, float], list[str]] = {}
    for target in plan.targets:
        east, north = -target.centre[1], target.centre[0]
        axes.plot(east, north, "s" if isinstance(target, Board) else "o", color=OTHER_COLOUR, ms=5)
        places.setdefault((round(east, 1), round(north, 1)), []).append(target.name)
    for place, names in places.items():  # targets above each other share one label
        axes.annotate(", ".join(names), place, xytext=(5, 4), textcoords="offset points",
                      fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR)  # fmt: skip
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(True, color=GRID_COLOUR, linewidth=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=SMALL_TEXT_SIZE, colors=INK_COLOUR)
    axes.xaxis.set_major_formatter(LocalisedFormatter())
    axes.yaxis.set_major_formatter(LocalisedFormatter())
    axes.set_xlabel(gettext("East (m)"), fontsize=TEXT_SIZE, color=INK_COLOUR)
    axes.set_ylabel(gettext("North (m)"), fontsize=TEXT_SIZE, color=INK_COLOUR)
    _draw_north_and_scale(axes)
    axes.set_title(
        gettext(
            "Plan view. A number marks the start of a line; reciprocal lines are drawn side by side"
        ),
        fontsize=TEXT_SIZE,
        color=INK_COLOUR,
        loc="left",
    )


def _draw_north_and_scale(axes: Axes) -> None:
    """Draw a north arrow, which points up, and a scale bar."""
    axes.apply_aspect()
    axes.autoscale(False)
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    wide, tall = right - left, high - low
    draw_north_arrow(axes)
    bar = max(
        (each for each in SCALE_BAR_LENGTHS_M if each <= 0.2 * wide), default=SCALE_BAR_LENGTHS_M[0]
    )
    x, y = left + 0.03 * wide, low + 0.05 * tall
    axes.plot([x, x + bar], [y, y], color=INK_COLOUR, linewidth=3, solid_capstyle="butt")
    axes.text(
        x + bar / 2,
        y + 0.015 * tall,
        gettext("{length} m", length=shortest_number(bar)),
        fontsize=TEXT_SIZE,
        color=INK_COLOUR,
        ha="center",
    )


def _draw_front_view(axes: Axes, plan: Plan, wall: Wall) -> None:
    """Draw the targets as seen from the water, in the plane of the wall."""
    for target in plan.targets:
        along = wall.wall_coordinates(target.centre)[0]
        up = target.centre[2]
        if isinstance(target, Ball):
            wide = tall = 2 * target.radius
        else:
            wide, tall = target.width, target.height * float(np.hypot(*target.facing[:2]))
        axes.fill_between(
            [along - wide / 2, along + wide / 2], up - max(tall, 0.1) / 2, up + max(tall, 0.1) / 2,
            color=OTHER_COLOUR, alpha=0.8, linewidth=0,
        )  # fmt: skip
        axes.annotate(target.name, (along + wide / 2, up), xytext=(3, 0), fontsize=SMALL_TEXT_SIZE,
                      textcoords="offset points", va="center", color=INK_COLOUR)  # fmt: skip
    axes.margins(0.12, 0.25)
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(True, color=GRID_COLOUR, linewidth=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=SMALL_TEXT_SIZE, colors=INK_COLOUR)
    axes.xaxis.set_major_formatter(LocalisedFormatter())
    axes.yaxis.set_major_formatter(LocalisedFormatter())
    axes.set_xlabel(
        gettext("Along the wall, to the right as seen from the water (m)"),
        fontsize=TEXT_SIZE,
        color=INK_COLOUR,
    )
    axes.set_ylabel(gettext("Above POS (m)"), fontsize=TEXT_SIZE, color=INK_COLOUR)


COLUMN_LEFT_EDGES = (0.07, 0.165, 0.29, 0.425, 0.555, 0.67, 0.82)
"""Left edges of the columns, as shares of the page width."""


def _draw_table(figure: Figure, top: float, row_height: float, table: Table) -> None:
    figure.text(
        0.07, top, table.title, fontsize=TEXT_SIZE + 1, weight="bold", color=INK_COLOUR, va="top"
    )
    heads = [column.title for column in table.columns]
    for k, row in enumerate([heads, *table.rows]):
        for x, value in zip(COLUMN_LEFT_EDGES, row, strict=True):
            figure.text(x, top - row_height * (k + 1), value, fontsize=TEXT_SIZE, color=INK_COLOUR,
                        va="top", weight="bold" if k == 0 else "normal")  # fmt: skip


def _direction(line: Line) -> Array:
    heading = np.radians(line.heading_deg)
    return np.array([np.cos(heading), -np.sin(heading)])


def _east_north(places: Array) -> tuple[Array, Array]:
    return -places[:, 1], places[:, 0]
