"""Scenarios that change one property of a plan at a time (thesis 4.4.1.2, figure 4.12).

The first four are those of the thesis: combination of lines, inclination, size, and combination of
targets. The others are additional: distance of the lines, height of the targets, repeated lines,
speed, and POS.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.stochastic_model import PosErrors
from lispac.design.plan import SIX_HEADINGS_DEG, Plan, System, line_pattern
from lispac.design.prediction import predict
from lispac.language import N_, LazyText, Plural, gettext_lazy, in_english
from lispac.progress import Progress, no_progress
from lispac.simulation.closed_form_survey import Board
from lispac.simulation.pos_errors import PosErrorModel

Array = NDArray[np.float64]
Case = tuple[LazyText, Plan]

HEADING_COMBINATIONS: dict[str, tuple[int, ...]] = {
    "0, 180": (0, 180),
    "45, 225": (45, 225),
    "315, 135": (315, 135),
    "45, 135": (45, 135),
    "315, 225": (315, 225),
    "0, 180, 45, 225": (0, 180, 45, 225),
    "0, 180, 315, 135": (0, 180, 315, 135),
    "0, 180, 45, 135": (0, 180, 45, 135),
    "0, 180, 315, 225": (0, 180, 315, 225),
    "45, 225, 315, 135": (45, 225, 315, 135),
    N_("all six"): SIX_HEADINGS_DEG,
}
"""Combinations of headings, degrees, for a wall in the east."""

INCLINATIONS_DEG = (0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0)
"""Inclinations of boards from level, degrees.

The boards are above the vessel and lean forward, towards it. A board that leans back by the same
angle would hardly be visible.
"""
BOARD_SIZES = (0.25, 0.50, 0.75, 1.00)
"""Sides of square boards, metres."""
INCLINATION_COMBINATIONS_DEG: tuple[tuple[float, ...], ...] = (
    (90.0,), (90.0, 60.0), (90.0, 45.0), (90.0, 30.0), (60.0, 30.0), (90.0, 60.0, 30.0),
)  # fmt: skip
"""Inclinations from level of boards used together, degrees."""
LINE_DISTANCES = (5.0, 10.0, 15.0, 20.0, 30.0, 40.0, 60.0, 80.0)
"""Distances of the lines from the site, metres."""
TARGET_HEIGHTS = (0.0, 2.5, 5.0, 10.0, 15.0, 20.0, 30.0)
"""Mean heights of the targets in the local frame, metres."""
REPEAT_COUNTS = (1, 2, 3, 4)
"""Numbers of times that all lines are run."""
VESSEL_SPEEDS = (0.5, 1.0, 2.0, 3.0, 4.0)
"""Speeds of the vessel on the lines, metres per second."""

POS_CLASSES: dict[str, PosErrorModel] = {
    name: PosErrorModel((level, level, 1.7 * level), tuple(np.radians(attitude)))
    for name, level, attitude in (
        (N_("navigation, post-processed"), 0.008, (0.005, 0.005, 0.008)),
        (N_("survey, post-processed"), 0.012, (0.008, 0.008, 0.012)),
        (N_("survey, RTK"), 0.020, (0.010, 0.010, 0.020)),
        (N_("tactical, post-processed"), 0.020, (0.015, 0.015, 0.035)),
        (N_("tactical, RTK"), 0.030, (0.025, 0.025, 0.080)),
    )
}
"""Sigmas of north, east and up (metres) and of roll, pitch and heading (radians) by class of POS.

Rounded values of data sheets; those of the actual POS should be used where they are known.
"""


def thesis_board(inclination_deg: float = 90.0, size: float = 1.0, height: float = 5.0) -> Board:
    """Square board on a wall 15 m east of the lines, facing them (thesis figure 4.2).

    Parameters
    ----------
    inclination_deg : float, degrees from level
    size, height : float, metres
        Side of the square, and height of its middle in the local frame.
    """
    lean = np.radians(inclination_deg)
    normal = (0.0, float(np.sin(lean)), -float(np.cos(lean)))
    return Board(f"{inclination_deg:g} deg", (0.0, -15.0, height), normal, size, size)


def thesis_setting(pos_errors: PosErrors = "independent") -> Plan:
    """Plan with one upright board of 1 x 1 m, 15 m away and 5 m up, and six lines (thesis 4.4.1.2).

    The stochastic model is that of the thesis unless ``pos_errors`` is given.
    """
    return Plan((thesis_board(),), line_pattern(), (0.0, -15.0, 0.0), System(pos_errors=pos_errors))


def line_combinations(plan: Plan) -> list[Case]:
    """Scenarios of thesis figure 4.12 (a): combinations of the six lines."""
    line_of_heading = dict(zip(SIX_HEADINGS_DEG, plan.lines, strict=False))
    return [
        (gettext_lazy(name), plan.with_lines([line_of_heading[heading] for heading in headings]))
        for name, headings in HEADING_COMBINATIONS.items()
        if set(headings) <= set(line_of_heading)
    ]


def board_inclinations(plan: Plan) -> list[Case]:
    """Scenarios of thesis figure 4.12 (b): one board, from level to upright."""
    return [
        (gettext_lazy("{angle:x.0} deg", angle=lean), plan.with_targets([thesis_board(lean)]))
        for lean in INCLINATIONS_DEG
    ]


def board_sizes(plan: Plan) -> list[Case]:
    """Scenarios of thesis figure 4.12 (c): one upright board, from small to large."""
    return [
        (
            gettext_lazy("{size:x.0} cm", size=100 * size),
            plan.with_targets([thesis_board(size=size)]),
        )
        for size in BOARD_SIZES
    ]


def target_combinations(plan: Plan) -> list[Case]:
    """Scenarios of thesis figure 4.12 (d): boards of different inclinations, 1.6 m apart."""
    cases = []
    for leans in INCLINATION_COMBINATIONS_DEG:
        boards = [
            replace(board, centre=(1.6 * (k - (len(leans) - 1) / 2), *board.centre[1:]))
            for k, board in enumerate(map(thesis_board, leans))
        ]
        name = " + ".join(f"{lean:g}" for lean in leans)
        cases.append((gettext_lazy(name), plan.with_targets(boards)))
    return cases


def line_distances(plan: Plan) -> list[Case]:
    """Scenarios with all lines at different distances."""
    return [
        (
            gettext_lazy("{distance:m.0} m", distance=d),
            plan.with_lines([replace(line, distance=d) for line in plan.lines]),
        )
        for d in LINE_DISTANCES
    ]


def target_heights(plan: Plan) -> list[Case]:
    """Scenarios with all targets moved to a different mean height."""
    middle = float(np.mean([target.centre[2] for target in plan.targets]))
    return [
        (
            gettext_lazy("{distance:m.1} m", distance=h),
            plan.with_targets(
                [replace(t, centre=(*t.centre[:2], t.centre[2] - middle + h)) for t in plan.targets]
            ),
        )
        for h in TARGET_HEIGHTS
    ]


def line_repeats(plan: Plan) -> list[Case]:
    """Scenarios with all lines run one to four times, one series after the other."""
    return [
        (gettext_lazy(Plural("once", "{count:n} times"), count=n), plan.with_lines(plan.lines * n))
        for n in REPEAT_COUNTS
    ]


def vessel_speeds(plan: Plan) -> list[Case]:
    """Scenarios with all lines at different speeds, which changes the number of points."""
    return [
        (
            gettext_lazy("{speed:x.1} m/s", speed=v),
            plan.with_lines([replace(line, speed=v) for line in plan.lines]),
        )
        for v in VESSEL_SPEEDS
    ]


def pos_classes(plan: Plan) -> list[Case]:
    """Scenarios with POS of different classes."""
    return [
        (gettext_lazy(name), replace(plan, system=replace(plan.system, pos=pos)))
        for name, pos in POS_CLASSES.items()
    ]


SCENARIOS: dict[str, Callable[[Plan], list[Case]]] = {
    N_("lines"): line_combinations,
    N_("inclination"): board_inclinations,
    N_("size"): board_sizes,
    N_("targets"): target_combinations,
    N_("distance"): line_distances,
    N_("height"): target_heights,
    N_("repeats"): line_repeats,
    N_("speed"): vessel_speeds,
    N_("POS"): pos_classes,
}
THESIS_SCENARIOS = ("lines", "inclination", "size", "targets")
"""Scenarios that use the boards and lines of the thesis instead of those of the plan."""

POS_ERROR_MODELS: Sequence[PosErrors] = ("independent", "correlated")
"""Models of the POS errors for which every case is predicted."""


@dataclass(frozen=True, eq=False)
class ScenarioOutcome:
    """Predicted sigmas of one case.

    Attributes
    ----------
    scenario : str
    label : LazyText
        Value of the changed property.
    pos_errors : {"independent", "correlated"}
    sigma : ndarray of shape (3,), radians
        Predicted sigmas of roll, pitch and yaw; infinite if not all three are determined.
    points : float
        Expected number of points on all targets.
    """

    scenario: str
    label: LazyText
    pos_errors: PosErrors
    sigma: Array
    points: float

    @property
    def case(self) -> str:
        """Name of the case in English, as used in files."""
        return in_english(self.label)


def predict_scenarios(
    plan: Plan,
    scenarios: Sequence[str] = tuple(SCENARIOS),
    *,
    progress: Progress = no_progress,
) -> tuple[ScenarioOutcome, ...]:
    """Predict the sigmas of every case of some scenarios, with both stochastic models.

    Parameters
    ----------
    plan : Plan
        Plan that the scenarios change. The scenarios of the thesis use its boards and lines, with
        the system and the flatness of this plan.
    scenarios : sequence of str
        Names of scenarios in `SCENARIOS`.
    """
    found = []
    for k, scenario in enumerate(scenarios):
        name = gettext_lazy(scenario)
        progress(k / len(scenarios), gettext_lazy("Scenario: {scenario}", scenario=name))
        base = plan
        if scenario in THESIS_SCENARIOS:
            base = replace(thesis_setting(), system=plan.system, flatness=plan.flatness)
        for label, changed in SCENARIOS[scenario](base):
            for errors in POS_ERROR_MODELS:
                predicted = predict(
                    replace(changed, system=replace(changed.system, pos_errors=errors))
                )
                points = sum(predicted.points.values())
                found.append(ScenarioOutcome(scenario, label, errors, predicted.sigma, points))
    progress(1.0)
    return tuple(found)
