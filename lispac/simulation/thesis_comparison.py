"""Comparison of values chosen visually in the thesis with those of the same rule in this program.

The values are from tables 3.2 and 3.3 and appendix C for the terrestrial site, and from sections
3.9 and 4.4.1.1 for the marine site.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from lispac.messages import Message, note
from lispac.simulation.visibility_study import (
    BestConfiguration,
    VisibilityStudy,
    fewest_sufficient_lines,
)


@dataclass(frozen=True)
class ThesisValue:
    """Lines and target inclinations at which the thesis detects one error.

    Attributes
    ----------
    lines : tuple of int, degrees
        Headings; empty if the error is invisible according to the thesis.
    inclination_deg : tuple of int
        Lowest and highest of the best inclinations.
    suitable_inclinations_deg : tuple of int
        Lowest and highest inclination that the thesis keeps by the type I criterion.
    """

    lines: tuple[int, ...]
    inclination_deg: tuple[int, int] | None
    suitable_inclinations_deg: tuple[int, int]


THESIS_VALUES: Mapping[str, Mapping[str, ThesisValue]] = {
    "terrestrial": {
        "roll": ThesisValue((0, 180, 45, 225), (-40, -40), (-60, 30)),
        "pitch": ThesisValue((0, 45, 225), (0, 0), (-90, 20)),
        "yaw": ThesisValue((0, 45, 315), (0, 0), (-60, 30)),
        "lever_x": ThesisValue((0, 45, 225), (0, 0), (-90, 30)),
        "lever_y": ThesisValue((0, 180, 45, 225), (0, 0), (-90, 30)),
        "lever_z": ThesisValue((), None, (-90, 30)),
        "range_offset": ThesisValue((180, 225), (-60, -60), (-40, 10)),
        "scan_angle_offset": ThesisValue((0, 180, 45, 225), (-50, -50), (-50, 10)),
    },
    # Boards that are vertical or nearly so, and the pair of lines of 4.4.1.1 that shows the angle.
    "marine": {
        "roll": ThesisValue((0, 180), (-10, 10), (0, 90)),
        "pitch": ThesisValue((45, 225), (-10, 10), (0, 90)),
        "yaw": ThesisValue((45, 135), (-10, 10), (0, 90)),
    },
}

SUFFICIENT_HEADINGS_DEG = frozenset(
    frozenset((0, 180, *side)) for side in combinations((45, 225, 315, 135), 3)
)
"""Headings (deg) of the sets of lines that show every error (table 3.3)."""

REASON_CODES: Mapping[tuple[str, str], str] = {
    ("terrestrial", "roll"): "visibility.roll_facing",
    ("terrestrial", "scan_angle_offset"): "visibility.offset_as_roll",
    ("terrestrial", "range_offset"): "visibility.offset_not_kept",
    ("marine", "roll"): "visibility.leaning_back",
}
"""Code of the message with the reason for a best configuration different from the thesis."""


@dataclass(frozen=True)
class ThesisComparison:
    """Comparison of the best configuration for one error with that of the thesis.

    Attributes
    ----------
    lines_agree : bool
        Whether the lines of the thesis contain exactly one line of each group (marine site:
        whether they belong to different groups).
    reason : Message or None
        Reason if the lines or the inclination do not agree.
    """

    best: BestConfiguration
    thesis: ThesisValue
    lines_agree: bool
    inclination_agrees: bool
    reason: Message | None


def compare_with_thesis(study: VisibilityStudy) -> tuple[ThesisComparison, ...]:
    """Compare the best configuration for every error of a site with that of the thesis."""
    rows = []
    for error in study.site.errors:
        best, thesis = study.best_configuration(error), THESIS_VALUES[study.site.name][error]
        if thesis.inclination_deg is None or best.inclination is None:
            lines = inclination = thesis.inclination_deg is None and best.inclination is None
        else:
            matched = [sum(heading in group for heading in thesis.lines) for group in best.groups]
            pair = study.site.name == "marine"
            lines = max(matched) == 1 and (pair or min(matched) == 1)
            low, high = thesis.inclination_deg
            inclination = low <= round(float(np.degrees(best.inclination))) <= high
        reason = None if lines and inclination else _disagreement_reason(study, best, thesis)
        rows.append(ThesisComparison(best, thesis, lines, inclination, reason))
    return tuple(rows)


def do_fewest_lines_agree(study: VisibilityStudy) -> bool:
    """Whether the fewest lines that show all errors are those of table 3.3."""
    sets = fewest_sufficient_lines([study.best_configuration(error) for error in study.site.errors])
    return {frozenset(lines) for lines in sets} == SUFFICIENT_HEADINGS_DEG


def _disagreement_reason(
    study: VisibilityStudy, best: BestConfiguration, thesis: ThesisValue
) -> Message:
    """Visibility of the error at both inclinations, and the reason for the difference if known."""
    degrees = np.round(np.degrees(study.site.inclinations)).astype(int)
    places = []
    if best.inclination is not None:
        places.append(int(np.round(np.degrees(best.inclination))))
    if thesis.inclination_deg is not None:
        places.append(int(np.mean(thesis.inclination_deg)))
    rows = [int(np.argmax(degrees == place)) for place in places]
    spreads = [spread[rows] for spread in study.visibility_spread(best.error)]
    differences = tuple(
        note("item.apart", distance=float(metres), angle=float(turn), inclination=np.radians(place))
        for place, metres, turn in zip(places, *spreads, strict=True)
    )
    code = REASON_CODES.get((study.site.name, best.error), "visibility.unknown_reason")
    return note("visibility.differs", reason=note(code), differences=differences)
