"""Reading and writing of survey plans, and reading of sites, as TOML.

Positions are given for an observer on the water who faces the wall: along the wall to the right,
away from the wall towards the water, and up from the vessel's POS. The centre of the site is 0, 0.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from lispac.adjustment.model.stochastic_model import POS_ERROR_MODELS
from lispac.design.plan import Line, Plan, System
from lispac.design.site import Site, Wall
from lispac.io.config.toml_table import TomlTable, toml_string
from lispac.io.files import atomic_write
from lispac.simulation.closed_form_survey import Ball, Board
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS, PosErrorModel
from lispac.simulation.scanner import Scanner
from lispac.survey.georeferencing import Mounting

SIDES = ("starboard", "port")
DEFAULT_INTERVAL_MIN = 1.5
"""Default time between two lines, minutes."""


@dataclass(frozen=True, eq=False)
class TitledPlan:
    """A plan with the title and the wall of its file.

    Attributes
    ----------
    wall : Wall
        Wall relative to which the positions are given.
    """

    title: str
    plan: Plan
    wall: Wall


def read_plan(path: Path) -> TitledPlan:
    """Read the targets, lines and system of a plan.

    Raises
    ------
    InputError
        If the content is not valid; the message names the file, the key and the action.
    """
    with TomlTable.read(path, "plan") as table:
        title = table.text("title", path.stem)
        wall = Wall((0.0, 0.0, 0.0), table.number("facing_deg", 270.0))
        system, flatness = _read_system(table)
        targets = _read_targets(table, wall)
        lines = tuple(_read_line(each) for each in table.tables("lines"))
        if not targets:
            raise table.refuse("boards", "plan.no_targets")
        if not lines:
            raise table.refuse("lines", "plan.no_lines")
        names = [target.name for target in targets]
        for name in names:
            if names.count(name) > 1:
                raise table.refuse("boards", "plan.name_twice", name=name)
        interval = 60.0 * table.number("minutes_per_line", DEFAULT_INTERVAL_MIN, over=0.0)
        return TitledPlan(
            title, Plan(targets, lines, wall.middle, system, interval, flatness), wall
        )


def read_site(path: Path) -> tuple[str, Site]:
    """Read the title of a site and its limits on targets and lines.

    Raises
    ------
    InputError
        If the content is not valid; the message names the file, the key and the action.
    """
    with TomlTable.read(path, "site") as table:
        title = table.text("title", path.stem)
        wall = Wall((0.0, 0.0, 0.0), table.number("facing_deg", 270.0))
        system, flatness = _read_system(table)
        natural = _read_targets(table, wall, "natural", "natural_balls")
        with table.table("board_choices") as boards:
            count = _read_whole_number(boards, "boards", 2, low=0, high=6)
            along = boards.numbers("along_m", None, Site.along)
            heights = boards.numbers("up_m", None, Site.heights)
            leans = boards.numbers(
                "inclination_deg", None, Site.inclinations_deg, low=0.0, high=180.0
            )
            width = boards.numbers("width_m", None, (Site.sizes[0][0],), low=0.05)
            tall = boards.numbers("height_m", None, (Site.sizes[0][1],), low=0.05)
            control_sigma = boards.number("control_sigma_m", None, over=0.0)
            if len(width) != len(tall):
                raise boards.refuse(
                    "height_m", "plan.sizes_differ", widths=len(width), heights=len(tall)
                )
        with table.table("line_choices") as choices:
            lines = _read_whole_number(choices, "lines", 6, low=2, high=12)
            headings = choices.numbers("headings_deg", None, Site.headings_deg)
            distances = choices.numbers("distances_m", None, Site.distances, low=1.0)
            speeds = choices.numbers("speeds_m_s", None, Site.speeds, low=0.05)
            closest = choices.number("closest_m", Site.closest, low=0.0)
        with table.table("time") as time:
            on_site = time.number("on_site_min", Site.time_on_site, over=0.0)
            per_line = time.number("per_line_min", Site.minutes_per_line, over=0.0)
            per_board = time.number("per_board_min", Site.minutes_per_board, low=0.0)
        return title, Site(
            wall.middle, wall.facing_deg, along, heights, leans,
            tuple(zip(width, tall, strict=True)), natural, headings, distances, speeds, count,
            lines, closest, on_site, per_line, per_board, system, flatness, control_sigma,
        )  # fmt: skip


def _read_whole_number(table: TomlTable, key: str, usual: int, *, low: int, high: int) -> int:
    value = table.number(key, float(usual), low=float(low), high=float(high))
    if value != int(value):
        raise table.refuse(key, "plan.not_whole", value=f"{value:g}")
    return int(value)


def _read_system(table: TomlTable) -> tuple[System, float]:
    """Read the system and the flatness of the targets, metres."""
    usual, scanner = HYDROGRAPHIC_INS, Scanner(150_000.0)
    with table.table("system") as own:
        lever = own.three_numbers("lever_arm_m", (0.0, 0.0, 2.0))
        lever_sigma = own.three_numbers("lever_arm_sigma_m", (0.0, 0.0, 0.0), low=0.0)
        pos = PosErrorModel(
            own.three_numbers("position_sigma_m", usual.sigma_position, low=1e-6),
            _to_radians(
                own.three_numbers("attitude_sigma_deg", _to_degrees(usual.sigma_attitude), low=1e-6)
            ),
            own.number("position_time_s", usual.time_position, over=0.0),
            own.number("attitude_time_s", usual.time_attitude, over=0.0),
        )
        profiler = Scanner(
            own.number("pulses_per_second", scanner.pulses_per_second, over=0.0),
            own.number("profiles_per_second", scanner.turns_per_second, over=0.0),
            max_range=own.number("max_range_m", scanner.max_range, over=0.0),
            range_sigma=own.number("range_sigma_m", scanner.range_sigma, over=0.0),
            angle_sigma=float(
                np.radians(own.number("angle_sigma_deg", np.degrees(scanner.angle_sigma), low=0.0))
            ),
        )
        errors = own.one_of("pos_errors", POS_ERROR_MODELS, "correlated")
        flatness = own.number("flatness_m", Site.flatness, low=0.0)
    mounting = Mounting(np.array(lever), np.zeros(3))
    chosen = next(each for each in POS_ERROR_MODELS if each == errors)
    return System(mounting, profiler, pos, chosen, lever_sigma), flatness


def _read_targets(
    table: TomlTable, wall: Wall, boards: str = "boards", balls: str = "balls"
) -> tuple[Board | Ball, ...]:
    found: list[Board | Ball] = []
    for each in table.tables(boards):
        found.append(
            wall.board(
                each.text("name"),
                each.number("along_m"),
                each.number("up_m"),
                each.number("inclination_deg", 90.0, low=0.0, high=180.0),
                (
                    each.number("width_m", 1.23, low=0.05),
                    each.number("height_m", 1.22, low=0.05),
                ),
                off=each.number("off_m", 0.0),
                facing_deg=each.number("facing_deg", wall.facing_deg),
                flatness=each.number("flatness_m", None, low=0.0),
                control_sigma=each.number("control_sigma_m", None, over=0.0),
            )
        )
    for each in table.tables(balls):
        found.append(
            Ball(
                each.text("name"),
                wall.local_point(
                    each.number("along_m"), each.number("off_m", 0.0), each.number("up_m")
                ),
                each.number("radius_m", low=0.02),
                each.boolean("radius_known", True),
                each.number("flatness_m", None, low=0.0),
                each.number("control_sigma_m", None, over=0.0),
            )
        )
    return tuple(found)


def _read_line(table: TomlTable) -> Line:
    return Line(
        table.number("heading_deg", low=-360.0, high=360.0),
        table.number("distance_m", over=0.0),
        table.one_of("site_on", SIDES) == "starboard",
        table.number("speed_m_s", 1.0, low=0.05),
    )


def write_plan(path: Path, titled: TitledPlan) -> None:
    """Write a plan in the form that `read_plan` reads."""
    with atomic_write(Path(path)) as temporary:
        temporary.write_text(_plan_text(titled), encoding="utf-8")


def _plan_text(titled: TitledPlan) -> str:
    plan, wall = titled.plan, titled.wall
    system, scanner, pos = plan.system, plan.system.scanner, plan.system.pos
    rows = [
        "# A plan. Along the wall to the right as seen from the water, off it towards the water,",
        "# up from the vessel's POS; inclination_deg 90 is upright, less leans back.",
        f"title = {toml_string(titled.title)}",
        f"facing_deg = {_number_text(wall.facing_deg)}",
        f"minutes_per_line = {_number_text(plan.interval / 60)}",
        "",
        "[system]",
        f"lever_arm_m = {_numbers_text(system.mounting.lever_arm)}",
        f"lever_arm_sigma_m = {_numbers_text(system.lever_arm_sigma)}",
        f"position_sigma_m = {_numbers_text(pos.sigma_position)}",
        f"attitude_sigma_deg = {_numbers_text(np.degrees(pos.sigma_attitude))}",
        f"position_time_s = {_number_text(pos.time_position)}",
        f"attitude_time_s = {_number_text(pos.time_attitude)}",
        f"pulses_per_second = {_number_text(scanner.pulses_per_second)}",
        f"profiles_per_second = {_number_text(scanner.turns_per_second)}",
        f"range_sigma_m = {_number_text(scanner.range_sigma)}",
        f"angle_sigma_deg = {_number_text(np.degrees(scanner.angle_sigma))}",
        f"max_range_m = {_number_text(scanner.max_range)}",
        f"pos_errors = {toml_string(system.pos_errors)}",
        f"flatness_m = {_number_text(plan.flatness)}",
    ]
    for target in plan.targets:
        along, off, up = wall.wall_coordinates(target.centre)
        board = isinstance(target, Board)
        rows += ["", "[[boards]]" if board else "[[balls]]", f"name = {toml_string(target.name)}"]
        rows += [
            f"along_m = {_number_text(along)}",
            f"off_m = {_number_text(off)}",
            f"up_m = {_number_text(up)}",
        ]
        if isinstance(target, Board):
            lean, azimuth = wall.board_orientation(target)
            rows += [
                f"inclination_deg = {_number_text(lean)}",
                f"facing_deg = {_number_text(azimuth)}",
            ]
            rows += [
                f"width_m = {_number_text(target.width)}",
                f"height_m = {_number_text(target.height)}",
            ]
        else:
            rows += [f"radius_m = {_number_text(target.radius)}"]
            rows += [f"radius_known = {str(target.radius_known).lower()}"]
        if target.flatness is not None:
            rows.append(f"flatness_m = {_number_text(target.flatness)}")
        if target.control_sigma is not None:
            rows.append(f"control_sigma_m = {_number_text(target.control_sigma)}")
    for line in plan.lines:
        rows += [
            "", "[[lines]]", f"heading_deg = {_number_text(line.heading_deg)}",
            f"distance_m = {_number_text(line.distance)}",
            f'site_on = "{SIDES[0] if line.starboard else SIDES[1]}"',
            f"speed_m_s = {_number_text(line.speed)}",
        ]  # fmt: skip
    return "\n".join([*rows, ""])


def _number_text(value: float) -> str:
    return f"{round(float(value), 9):.12g}"


def _numbers_text(values: Sequence[float] | np.ndarray) -> str:
    return f"[{', '.join(_number_text(float(v)) for v in values)}]"


def _to_degrees(values: Sequence[float]) -> tuple[float, float, float]:
    a, b, c = (float(v) for v in np.degrees(values))
    return a, b, c


def _to_radians(values: Sequence[float]) -> tuple[float, float, float]:
    a, b, c = (float(v) for v in np.radians(values))
    return a, b, c
