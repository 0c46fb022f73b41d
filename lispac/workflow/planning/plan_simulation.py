"""Simulation of a plan, to check its predicted precision before the survey."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from lispac.design.plan import Plan
from lispac.io.config.plan_file import read_plan
from lispac.io.config.vessel_file import Vessel, read_vessel
from lispac.project import Triple
from lispac.simulation.closed_form_survey import Ball, Board
from lispac.simulation.motion_source import SailedTrajectory
from lispac.simulation.scene import Rectangle, Scene, Sphere
from lispac.simulation.simulated_survey import SurveySetup
from lispac.simulation.vessel_motion import SailedLine
from lispac.untrusted_values import InvalidContentError, toml_values
from lispac.workflow.planning.simulated_setup import SimulatedSetup, setup_file

SITE_ORIGIN = (float(np.radians(46.8)), float(np.radians(-71.2)), 0.0)
"""Latitude, longitude (radians) and height (metres) of the site, because a plan has no position."""

WHITE_REFLECTANCE = 0.85
"""Reflectance of white targets, no unit; a plan does not specify it."""
LINE_MARGIN = 3.0
"""Length recorded before and after the straight part of a line, metres."""

ELEVATION_WINDOW = (float(np.radians(-60.0)), float(np.radians(80.0)))
"""Range of elevations recorded on the side of the site, radians; a plan does not specify it."""

MIN_TURN_TIME = 15.0
"""Smallest time from one line to the next, seconds."""


def is_plan(path: Path) -> bool:
    """True if a file is a plan and not a scene; an unreadable file is neither."""
    try:
        keys = toml_values(Path(path).read_bytes()).keys()
    except (OSError, InvalidContentError):
        return False
    return bool({"boards", "balls"} & keys)


def simulation_of_plan(
    path: Path,
    *,
    vessel: str | None = None,
    points_per_second: float | None = None,
    errors: Mapping[str, Any] | None = None,
) -> SimulatedSetup:
    """Simulation setup of a plan, whose scene contains only its targets.

    Lever arm, POS and scanner are those of the plan; the motion and the mounting errors are those
    of the vessel.

    Parameters
    ----------
    vessel : str, optional
        Name of a vessel supplied with the program, or a file; the launch by default.
    points_per_second : float, optional
        Pulses per second of the scanner, instead of the plan's.
    errors : mapping, optional
        Fields of `MountingErrors` that replace those of the vessel.

    Raises
    ------
    InputError
        If the plan is not valid or cannot be simulated.
    """
    path = Path(path)
    titled = read_plan(path)
    plan, file = titled.plan, setup_file("vessel", vessel or "launch", None)
    vessel_data = read_vessel(file)
    lever: Triple = tuple(float(v) for v in plan.system.mounting.lever_arm)  # type: ignore[assignment]
    rate = points_per_second or plan.system.scanner.pulses_per_second
    scanner = replace(plan.system.scanner, pulses_per_second=rate, window=ELEVATION_WINDOW)
    setup = SurveySetup(
        SITE_ORIGIN,
        Scene.of([_target_surface(target) for target in plan.targets]),
        tuple(target.name for target in plan.targets),
        (),
        SailedTrajectory(_sailed_lines(plan, vessel_data), 0.0),
        plan.system.pos,
        scanner,
        replace(vessel_data.errors, **(errors or {})).mounting(lever),
    )
    titles = {"scene": titled.title, "vessel": vessel_data.title, "scanner": "as planned"}
    return SimulatedSetup(setup, lever, titles, {"scene": path, "vessel": file, "scanner": path})


def _target_surface(target: Board | Ball) -> Rectangle | Sphere:
    centre = np.array(target.centre)
    if isinstance(target, Ball):
        return Sphere(target.name, centre, target.radius, WHITE_REFLECTANCE)
    return Rectangle(
        target.name,
        centre,
        target.facing,
        target.across,
        target.width,
        target.height,
        WHITE_REFLECTANCE,
    )


def _sailed_lines(plan: Plan, vessel_data: Vessel) -> tuple[SailedLine, ...]:
    lines = []
    for line, course, (start, stop) in zip(
        plan.lines, plan.courses, plan.straight_extents, strict=True
    ):
        before, after = LINE_MARGIN - start, LINE_MARGIN + stop
        sailing = (before + after) / line.speed + 2 * vessel_data.handling.ramp
        handling = replace(
            vessel_data.handling,
            speed=line.speed,
            speed_abeam=line.speed,
            transit=max(plan.interval - sailing, MIN_TURN_TIME),
        )
        lines.append(
            SailedLine(course.heading, course.abeam, before, after, line.starboard, handling)
        )
    return tuple(lines)
