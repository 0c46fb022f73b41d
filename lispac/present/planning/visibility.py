"""Visibility of systematic errors on a board, and the best configurations, as values and tables.

The best configurations are compared with those of Shahraji's thesis.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from lispac.language import N_, gettext, gettext_lazy, join_items
from lispac.messages import Message
from lispac.present.angles import finite_or_none
from lispac.present.tables import COUNT, YES_NO_TEXTS, Column, Format, Table, cell_text
from lispac.present.text_format import fixed_number, title
from lispac.simulation.thesis_comparison import (
    SUFFICIENT_HEADINGS_DEG,
    ThesisComparison,
    compare_with_thesis,
    do_fewest_lines_agree,
)
from lispac.simulation.thesis_site import ERROR_SIZES, HEADINGS_DEG
from lispac.simulation.visibility_study import (
    BestConfiguration,
    VisibilityStudy,
    fewest_sufficient_lines,
)

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Criterion:
    """One of three criteria of the visibility of an error.

    Attributes
    ----------
    title, label : str
        English texts: name of the criterion, and quantity with its unit.
    decimals : int
        Decimals of the values.
    least : float
        Smallest height of the axis of a plot, so that rounding errors are not enlarged.
    values : function of a `VisibilityStudy`
        Shape (errors, lines, inclinations), in the unit of the label.
    """

    title: str
    label: str
    decimals: int
    least: float
    values: Callable[[VisibilityStudy], Array]


CRITERIA: Mapping[str, Criterion] = {
    "type-one": Criterion(
        N_("Type I criterion: planarity and position of the board"),
        N_("Type I criterion (0 to 1)"), 3, 1.0, lambda v: v.type_one,
    ),
    "orthogonal-distance": Criterion(
        N_("Type II criterion: shift of the board"),
        N_("Signed orthogonal distance (m)"), 4, 0.02, lambda v: v.orthogonal_distance,
    ),
    "angular-deviation": Criterion(
        N_("Type II criterion: rotation of the board"),
        N_("Angular deviation (°)"), 3, 0.2, lambda v: np.degrees(v.angular_deviation),
    ),
}  # fmt: skip


def systematic_error_label(error: str) -> str:
    """Name of a systematic error with its size, as ``Roll 2 deg`` or ``Lever arm X 10 cm``."""
    size = ERROR_SIZES[error]
    if error.startswith(("lever", "range")):
        return gettext("{error} {size} cm", error=title(error), size=fixed_number(100 * size, 0))
    return gettext("{error} {size:deg.0}°", error=title(error), size=size)


def _whole_degrees(angle: float) -> int:
    return round(float(np.degrees(angle)))


# -- all values of a site --------------------------------------------------------------------------


@dataclass(frozen=True)
class ErrorOnBoard:
    """Criteria of an error on a line and a board; None without points on the board."""

    error: str
    heading_deg: int
    inclination_deg: int
    points: int
    planarity: float | None
    centroidal_distance_m: float | None
    type_one: float | None
    accepted: bool
    orthogonal_distance_m: float | None
    angular_deviation_deg: float | None


def errors_on_boards(study: VisibilityStudy, errors: Sequence[str]) -> list[ErrorOnBoard]:
    """Criteria of each error, line and inclination."""
    made = []
    for error in errors:
        e, kept = study.site.errors.index(error), study.kept_inclinations(error)
        for k, heading in enumerate(HEADINGS_DEG):
            for j, inclination in enumerate(study.site.inclinations):
                place = (e, k, j)
                made.append(
                    ErrorOnBoard(
                        error, heading, _whole_degrees(inclination), int(study.points[place]),
                        finite_or_none(study.planarity[place]),
                        finite_or_none(study.centroidal_distance[place]),
                        finite_or_none(study.type_one[place]), inclination in kept,
                        finite_or_none(study.orthogonal_distance[place]),
                        finite_or_none(np.degrees(study.angular_deviation[place])),
                    )
                )  # fmt: skip
    return made


ERRORS_ON_BOARDS_TABLE = Table[ErrorOnBoard](
    N_("Effects of systematic errors on a board"),
    (
        Column("error", N_("Error")),
        Column("heading_deg", N_("Line (deg)"), COUNT),
        Column("inclination_deg", N_("Inclination (deg)"), COUNT),
        Column("points", N_("Points"), COUNT),
        Column("planarity", N_("Planarity"), Format("", 4)),
        Column("centroidal_distance_m", N_("Centroidal distance (m)"), Format("", 5)),
        Column("type_one", N_("Type I criterion (0 to 1)"), Format("", 4)),
        Column("accepted", N_("Accepted"), texts=YES_NO_TEXTS),
        Column("orthogonal_distance_m", N_("Signed orthogonal distance (m)"), Format("", 6)),
        Column("angular_deviation_deg", N_("Angular deviation (deg)"), Format("", 5)),
    ),
)


# -- values of one plot ----------------------------------------------------------------------------


CriterionRow = tuple[float | None, ...]
"""Inclination in degrees, and a criterion on each line, in the order of `HEADINGS_DEG`."""


def criterion_table(
    study: VisibilityStudy, error: str, criterion: str, decimals: int = 6
) -> tuple[Table[CriterionRow], list[CriterionRow]]:
    """Table of a criterion for an error, by inclination and line, and its rows."""
    shown = CRITERIA[criterion]
    columns = [Column[CriterionRow](itemgetter(0), N_("Inclination (°)"), COUNT)]
    columns += [
        Column(
            itemgetter(k), gettext_lazy("{heading:n}°", heading=heading),
            Format("", decimals), unknown=N_("no points"),
        )
        for k, heading in enumerate(HEADINGS_DEG, start=1)
    ]  # fmt: skip
    title = gettext_lazy(
        "{error}: {quantity}",
        error=systematic_error_label(error), quantity=gettext_lazy(shown.label),
    )  # fmt: skip
    values = shown.values(study)[study.site.errors.index(error)]
    return Table(title, tuple(columns)), [
        (_whole_degrees(each), *map(finite_or_none, values[:, j]))
        for j, each in enumerate(study.site.inclinations)
    ]


def values_at_inclination(
    study: VisibilityStudy, error: str, criterion: str, inclination_deg: float
) -> str:
    """Text with the values of all lines at the studied inclination nearest to the given one."""
    shown = CRITERIA[criterion]
    j = int(np.argmin(np.abs(np.degrees(study.site.inclinations) - inclination_deg)))
    table, rows = criterion_table(study, error, criterion, shown.decimals)
    return gettext(
        "{quantity} with targets inclined by {inclination:deg.0}°, by heading of the line: "
        "{values}",
        quantity=gettext(shown.label), inclination=study.site.inclinations[j],
        values=join_items(
            gettext("{name}: {text}", name=each.title, text=cell_text(each, rows[j]))
            for each in table.columns[1:]
        ),
    )  # fmt: skip


# -- best configurations ---------------------------------------------------------------------------


@dataclass(frozen=True)
class ConfigurationValues:
    """Best configuration for an error; the inclination is None if the error is invisible.

    ``groups_of_lines_deg``: headings of lines that show the error equally well; one line of each
    group is needed.
    """

    error: str
    suitable_inclinations_deg: tuple[int, ...]
    inclination_deg: int | None
    groups_of_lines_deg: tuple[tuple[int, ...], ...]

    @classmethod
    def of(cls, best: BestConfiguration) -> "ConfigurationValues":
        """Values of the best configuration for an error."""
        return cls(
            best.error,
            tuple(map(_whole_degrees, best.kept)),
            None if best.inclination is None else _whole_degrees(best.inclination),
            best.groups,
        )


@dataclass(frozen=True)
class ThesisValues:
    """Configuration of the thesis for an error, and whether the best one agrees with it.

    The inclinations are the lowest and the highest; None if the error is invisible.
    """

    error: str
    lines: tuple[int, ...]
    inclination_deg: tuple[int, int] | None
    suitable_inclinations_deg: tuple[int, int]
    lines_agree: bool
    inclination_agrees: bool
    reason: Message | None

    @classmethod
    def of(cls, found: ThesisComparison) -> "ThesisValues":
        """Values of the comparison for an error."""
        return cls(
            found.best.error, found.thesis.lines, found.thesis.inclination_deg,
            found.thesis.suitable_inclinations_deg, found.lines_agree, found.inclination_agrees,
            found.reason,
        )  # fmt: skip


@dataclass(frozen=True)
class ComparedConfiguration:
    """Table row with the best configuration for an error and that of the thesis."""

    best: ConfigurationValues
    thesis: ThesisValues

    @property
    def name(self) -> str:
        """Name of the error with its size, in the language in use."""
        return systematic_error_label(self.best.error)


def compared_configurations(
    study: VisibilityStudy, errors: Sequence[str]
) -> list[ComparedConfiguration]:
    """Best configuration for each error, here and in the thesis, and their agreement."""
    return [
        ComparedConfiguration(ConfigurationValues.of(each.best), ThesisValues.of(each))
        for each in compare_with_thesis(study)
        if each.best.error in errors
    ]


def _range_text(low: int, high: int) -> str:
    return gettext("{low} to {high}", low=fixed_number(low, 0), high=fixed_number(high, 0))


def _accepted_text(row: ComparedConfiguration) -> str:
    kept = row.best.suitable_inclinations_deg
    return _range_text(kept[0], kept[-1]) if kept else gettext("none")


def _thesis_inclination_text(row: ComparedConfiguration) -> str | None:
    if row.thesis.inclination_deg is None:
        return None
    low, high = row.thesis.inclination_deg
    if low == high:
        return fixed_number(low, 0)
    return gettext("about {inclination}", inclination=fixed_number((low + high) / 2, 0))


def _groups_text(row: ComparedConfiguration) -> str | None:
    if row.best.inclination_deg is None:
        return None
    return ", ".join("/".join(map(str, group)) for group in row.best.groups_of_lines_deg)


def _headings_text(lines: Sequence[int]) -> str:
    return ", ".join(map(str, lines))


NOT_VISIBLE_TEXT = N_("not visible")
AGREEMENT_TEXTS = {True: N_("the same"), False: N_("different")}
CONFIGURATIONS_TABLE = Table[ComparedConfiguration](
    N_("Best inclination and lines for each error"),
    (
        Column("name", N_("Error"), tip=N_("Systematic error and its size")),
        Column(
            _accepted_text, N_("Accepted inclinations (°)"),
            tip=N_(
                "Inclinations at which the points still form the board (type I criterion of "
                "Shahraji's thesis)"
            ),
        ),
        Column(
            lambda row: _range_text(*row.thesis.suitable_inclinations_deg),
            N_("Accepted, Shahraji (°)"),
            tip=N_("Accepted inclinations in appendix C and section 3.9 of Shahraji's thesis"),
        ),
        Column(
            "best.inclination_deg", N_("Best inclination (°)"), COUNT,
            N_("Inclination at which the lines differ most"), unknown=NOT_VISIBLE_TEXT,
        ),
        Column(
            _thesis_inclination_text, N_("Best, Shahraji (°)"),
            tip=N_("Best inclination in table 3.2 and section 3.9 of Shahraji's thesis"),
            unknown=NOT_VISIBLE_TEXT,
        ),
        Column(
            _groups_text, N_("Headings (°)"),
            tip=N_(
                "Headings of the lines that show the error. Lines joined by / show the same, so "
                "one of them is sufficient."
            ),
            unknown=NOT_VISIBLE_TEXT,
        ),
        Column(
            lambda row: _headings_text(row.thesis.lines) or None, N_("Headings, Shahraji (°)"),
            tip=N_("Headings of the lines in table 3.2 and section 4.4.1.1 of Shahraji's thesis"),
            unknown=NOT_VISIBLE_TEXT,
        ),
        Column(
            "thesis.inclination_agrees", N_("Inclination (vs. thesis)"),
            tip=N_(
                "Whether the best inclination is the same as in Shahraji's thesis; the tooltip of "
                "the row gives the reason for a difference"
            ),
            texts=AGREEMENT_TEXTS,
        ),
        Column(
            "thesis.lines_agree", N_("Lines (vs. thesis)"),
            tip=N_(
                "Whether the headings of the required lines are the same as in Shahraji's thesis"
            ),
            texts=AGREEMENT_TEXTS,
        ),
    ),
)  # fmt: skip
CONFIGURATIONS_WITH_REASONS_TABLE = replace(
    CONFIGURATIONS_TABLE,
    columns=(
        *CONFIGURATIONS_TABLE.columns,
        Column[ComparedConfiguration]("thesis.reason", N_("Reason"), is_wide=True),
    ),
)


def fewest_lines_text(study: VisibilityStudy) -> str:
    """Text on the smallest sets of lines that reveal all errors, compared with thesis table 3.3."""
    sets = fewest_sufficient_lines([study.best_configuration(error) for error in study.site.errors])
    if study.site.name != "terrestrial":
        template = N_("Smallest sets of lines that reveal all errors: {lines}.")
    elif do_fewest_lines_agree(study):
        template = N_(
            "Smallest sets of lines that reveal all errors: {lines} (the same as the {count:n} "
            "sets in table 3.3 of Shahraji's thesis)."
        )
    else:
        template = N_(
            "Smallest sets of lines that reveal all errors: {lines} (different from the {count:n} "
            "sets in table 3.3 of Shahraji's thesis)."
        )
    return gettext(
        template, lines=join_items(map(_headings_text, sets)), count=len(SUFFICIENT_HEADINGS_DEG)
    )
