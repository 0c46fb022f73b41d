"""Results of the targets and of alternative methods, as values and tables."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from lispac.adjustment.result import ANGLES
from lispac.language import N_, gettext, gettext_lazy
from lispac.messages import Message
from lispac.method_comparison import MethodResult
from lispac.present.angles import Angles, angles, degrees
from lispac.present.calibration.calibrations import (
    DIFFER_COLUMN,
    DIFFERENCE_COLUMNS,
    ESTIMATE_COLUMNS,
    estimate_columns,
    significance_column,
)
from lispac.present.tables import COUNT, DEGREES, Column, Fact, Table, ratio

METHOD_TITLES: Mapping[str, str] = {
    "targets": N_("Targets"),
    "natural planes": N_("Natural planes"),
    "targetless": N_("Targetless"),
    "patch test": N_("Patch test"),
    "correspondences": N_("Point correspondences"),
}


@dataclass(frozen=True)
class MethodValues:
    """Result of a method, and its differences from the first method (this minus the first).

    ``significance``: the differences divided by their sigmas; ``probability``: the probability of
    differences at least as large if both results are correct; ``differ``: whether they are
    significant. For the first method these values are None.
    """

    method: str
    lines: int
    surfaces: int
    boresight_deg: Angles
    sigma_deg: Angles
    difference_deg: Angles | None
    significance: Angles | None
    probability: float | None
    differ: bool | None
    messages: tuple[Message, ...]

    @classmethod
    def of(cls, result: MethodResult) -> "MethodValues":
        """Values of the result of a method."""
        calibration, against = result.calibration, result.against
        return cls(
            result.method,
            result.lines,
            result.surfaces,
            degrees(calibration.boresight),
            degrees(calibration.sigma),
            None if against is None else degrees(against.angles),
            None if against is None else angles(against.significance),
            None if against is None else against.probability,
            None if against is None else against.differ,
            result.messages,
        )


METHOD_COLUMN = Column[MethodValues](
    "method", N_("Method"), tip=N_("Method of estimation"), texts=METHOD_TITLES
)
LINES_COLUMN = Column[MethodValues]("lines", N_("Lines"), COUNT, N_("Number of lines used"))
SURFACES_COLUMN = Column[MethodValues](
    "surfaces", N_("Surfaces"), COUNT,
    N_("Number of targets, planes, natural surfaces, objects or pairs of points used"),
)  # fmt: skip


METHOD_RESULTS_TABLE = Table[MethodValues](
    N_("Boresight by each method"),
    (
        METHOD_COLUMN,
        LINES_COLUMN,
        SURFACES_COLUMN,
        *ESTIMATE_COLUMNS,
    ),
)
WINDOW_METHODS_TABLE = Table[MethodValues](
    N_("Results of all methods"),
    (
        METHOD_COLUMN, LINES_COLUMN, SURFACES_COLUMN,
        *(
            column
            for name in ANGLES
            for column in (*estimate_columns(name), significance_column(name))
        ),
    ),
)  # fmt: skip
"""Table of the window, with the significance of the differences, which the report has in the table
of `method_differences`."""


def method_differences(
    methods: Sequence[MethodValues],
) -> tuple[Table[MethodValues], list[MethodValues]]:
    """Table of the differences from the first method, and its rows."""
    first = gettext_lazy(METHOD_TITLES[methods[0].method])
    title = gettext_lazy("Differences from the first method, {method}", method=first)
    columns = (METHOD_COLUMN, *DIFFERENCE_COLUMNS, DIFFER_COLUMN)
    return Table(title, columns), [each for each in methods if each.difference_deg is not None]


def method_facts(methods: Sequence[MethodValues]) -> list[Fact]:
    """Differences of each other method from the first one with the verdict, in the language in use.

    The number in brackets is the difference divided by its standard deviation.
    """
    found = []
    for each in methods:
        if each.difference_deg is None or each.significance is None:
            continue
        values = {
            f"{name}{suffix}": form.text(getattr(of, name))
            for of, form, suffix in (
                (each.difference_deg, DEGREES.signed, ""),
                (each.significance, ratio(1).signed, "_ratio"),
            )
            for name in ANGLES
        }
        differences = gettext(
            "difference from the adjustment: roll {roll}° ({roll_ratio}\u00a0σ), pitch {pitch}° "
            "({pitch_ratio}\u00a0σ), yaw {yaw}° ({yaw_ratio}\u00a0σ)",
            **values,
        )
        verdict = gettext(
            N_("significant difference") if each.differ else N_("no significant difference")
        )
        name = gettext(METHOD_TITLES[each.method])
        found.append(Fact(name, f"{differences}; {verdict}"))
    return found
