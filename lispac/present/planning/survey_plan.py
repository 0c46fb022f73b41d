"""Targets and lines of a survey plan, as values and tables."""

from dataclasses import dataclass

from lispac.design.plan import Plan
from lispac.design.site import Wall, clearance_from_wall
from lispac.language import N_, gettext
from lispac.present.tables import COUNT, Column, Format, Table
from lispac.present.text_format import fixed_number, shortest_number, signed_number
from lispac.simulation.closed_form_survey import Ball

METRES = Format("", 2)
"""Format of metres without the unit, which the titles contain."""


@dataclass(frozen=True)
class PlannedTarget:
    """Target of a plan: position of its centre at the wall, and its shape.

    ``along_m`` is positive to the right as seen from the water, ``off_m`` towards the water,
    ``up_m`` above the POS. A board has width, height, inclination from level and azimuth; the
    azimuth is None for a level board. A sphere has a radius only.
    """

    name: str
    along_m: float
    off_m: float
    up_m: float
    width_m: float | None = None
    height_m: float | None = None
    inclination_deg: float | None = None
    facing_deg: float | None = None
    radius_m: float | None = None


@dataclass(frozen=True)
class PlannedLine:
    """Line of a plan.

    ``distance_m`` is that from the middle of the site, ``clearance_m`` the smallest distance from
    the wall. The straight part is given relative to the place where the middle is abeam.
    """

    number: int
    heading_deg: float
    distance_m: float
    site_on: str
    clearance_m: float
    speed_m_s: float
    straight_part_m: tuple[float, float]


def planned_targets(plan: Plan, wall: Wall) -> list[PlannedTarget]:
    """Targets of a plan, in wall coordinates."""
    rows = []
    for target in plan.targets:
        along, off, up = map(float, wall.wall_coordinates(target.centre))
        if isinstance(target, Ball):
            rows.append(PlannedTarget(target.name, along, off, up, radius_m=target.radius))
            continue
        lean, azimuth = wall.board_orientation(target)
        is_level = lean < 0.05 or lean > 179.95
        rows.append(
            PlannedTarget(
                target.name, along, off, up, target.width, target.height, lean,
                None if is_level else azimuth,
            )
        )  # fmt: skip
    return rows


def planned_lines(plan: Plan, wall: Wall) -> list[PlannedLine]:
    """Lines of a plan, in survey order."""
    parts = zip(plan.lines, plan.straight_extents, clearance_from_wall(plan, wall), strict=True)
    return [
        PlannedLine(
            k, line.heading_deg % 360, line.distance, "starboard" if line.starboard else "port",
            clearance, line.speed, (float(start), float(stop)),
        )
        for k, (line, (start, stop), clearance) in enumerate(parts, start=1)
    ]  # fmt: skip


def _signed_unless_zero(metres: float) -> Format:
    return METRES.signed if abs(metres) >= 0.005 else METRES


def _size_text(row: PlannedTarget) -> str:
    if row.radius_m is not None:
        return gettext("sphere, r {radius:m.3}", radius=row.radius_m)
    return f"{fixed_number(row.width_m or 0.0, 2)} x {fixed_number(row.height_m or 0.0, 2)}"


def _inclination_text(row: PlannedTarget) -> str | None:
    """Text of the inclination: 90 vertical, smaller tilted back, larger tilted forward."""
    degrees = row.inclination_deg
    if degrees is None:
        return None
    if abs(degrees - 90.0) < 0.5:
        return gettext("90, vertical")
    if degrees < 90.0:
        return gettext("{degrees}, tilted back", degrees=fixed_number(degrees, 0))
    return gettext("{degrees}, tilted forward", degrees=fixed_number(180 - degrees, 0))


def _straight_part_text(row: PlannedLine) -> str:
    start, stop = row.straight_part_m
    return f"{signed_number(start, 0)}, {signed_number(stop, 0)}"


PLANNED_TARGETS_TABLE = Table[PlannedTarget](
    N_("Targets"),
    (
        Column("name", N_("target")),
        Column("along_m", N_("along wall (m)"), lambda row: _signed_unless_zero(row.along_m)),
        Column("off_m", N_("from wall (m)"), lambda row: _signed_unless_zero(row.off_m)),
        Column("up_m", N_("above POS (m)"), METRES),
        Column(_size_text, N_("size (m)")),
        Column(_inclination_text, N_("inclination (°)")),
        Column("facing_deg", N_("azimuth (°)"), COUNT),
    ),
)
PLANNED_LINES_TABLE = Table[PlannedLine](
    N_("Lines in survey order"),
    (
        Column("number", N_("line"), COUNT),
        Column("heading_deg", N_("heading (°)"), COUNT),
        Column(lambda row: shortest_number(row.distance_m), N_("distance (m)")),
        Column(
            "site_on", N_("side facing site"),
            texts={"starboard": N_("starboard"), "port": N_("port")},
        ),
        Column("clearance_m", N_("clearance (m)"), Format("", 1)),
        Column(lambda row: shortest_number(row.speed_m_s), N_("speed (m/s)")),
        Column(_straight_part_text, N_("straight part (m)")),
    ),
)  # fmt: skip
