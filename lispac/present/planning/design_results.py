"""Results of survey planning as values and tables: predictions, searches, simulated surveys.

Standard deviations are those of roll, pitch and yaw; None if the angles are not determined.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from operator import itemgetter

import numpy as np
from numpy.typing import ArrayLike

from lispac.adjustment.result import ANGLES
from lispac.design.monte_carlo import MonteCarloResult
from lispac.design.objective import CRITERION_TEXTS, Criterion
from lispac.design.plan import Plan
from lispac.design.plan_search import DesignResult, InformationGain, ReductionStep
from lispac.design.prediction import Prediction, predict
from lispac.design.scenarios import ScenarioOutcome
from lispac.design.site import Wall
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.present.angles import (
    Angles,
    AnglesRow,
    angle_columns,
    angles,
    degrees,
    finite_or_none,
    floats,
    matrix,
)
from lispac.present.planning.survey_plan import (
    PlannedLine,
    PlannedTarget,
    planned_lines,
    planned_targets,
)
from lispac.present.tables import COUNT, DEGREES, Column, Format, Row, Table, ratio

NOT_DETERMINED_TEXT = N_("not determined")
CSV_DEGREES = Format("", 6)
"""Format of degrees in CSV."""


def known_degrees(sigma: ArrayLike) -> Angles | None:
    """Convert standard deviations, shape (3,), radians; None unless all are finite."""
    return degrees(sigma) if np.isfinite(sigma).all() else None


# -- prediction ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class SightingPoints:
    """Expected number of points of a sighting."""

    target: str
    line: str
    points: int


@dataclass(frozen=True)
class PredictionValues:
    """Predicted precision of a plan, and the expected points of its sightings."""

    determined: bool
    sigma_deg: Angles | None
    correlation: tuple[tuple[float, ...], ...] | None
    points: tuple[SightingPoints, ...]

    @classmethod
    def of(cls, found: Prediction) -> "PredictionValues":
        """Values of a prediction."""
        return cls(
            found.determined,
            known_degrees(found.sigma),
            matrix(found.correlation) if found.determined else None,
            tuple(
                SightingPoints(target, line, round(count))
                for (target, line), count in found.points.items()
            ),
        )


NOTHING_PREDICTED = PredictionValues(False, None, None, ())
"""Values of a plan without targets or lines."""

PLAN_TITLES = N_("this plan"), N_("reference plan")
PREDICTED_SIGMAS_TABLE = Table[AnglesRow](
    N_("Predicted standard deviations"),
    (Column("name", ""), *angle_columns("values", DEGREES, unknown=NOT_DETERMINED_TEXT)),
)


def predicted_sigma_rows(*plans: PredictionValues) -> list[AnglesRow]:
    """Rows with the standard deviations of a plan, and of that of the thesis if it is given."""
    return [
        AnglesRow(gettext(title), each.sigma_deg)
        for title, each in zip(PLAN_TITLES, plans, strict=False)
    ]


def _correlation_column(row: int, column: int, title: str) -> Column[PredictionValues]:
    return Column(
        lambda found: None if found.correlation is None else found.correlation[row][column],
        title, ratio(2).signed,
    )  # fmt: skip


PREDICTED_CORRELATIONS_TABLE = Table[PredictionValues](
    N_("Correlations"),
    (
        _correlation_column(0, 1, N_("roll–pitch")),
        _correlation_column(0, 2, N_("roll–yaw")),
        _correlation_column(1, 2, N_("pitch–yaw")),
    ),
)


PointsRow = tuple[str | int | None, ...]
"""Name of a line, and the expected points on each target."""


def points_table(plan: Plan, found: PredictionValues) -> tuple[Table[PointsRow], list[PointsRow]]:
    """Table of the expected points and its rows; plans rarely have more targets than lines."""
    names = [target.name for target in plan.targets]
    counts = {(each.line, each.target): each.points for each in found.points}
    columns = [Column[PointsRow](itemgetter(0), N_("Line"))]
    columns += [Column(itemgetter(k), name, COUNT) for k, name in enumerate(names, start=1)]
    return Table(N_("Points per sighting"), tuple(columns)), [
        (line.name, *(counts.get((line.name, name)) for name in names))
        for line in (plan.courses if names else ())
    ]


@dataclass(frozen=True)
class GainRow:
    """Table row with the precision of a plan without a target or line.

    ``without_deg`` is the value of the objective; ``factors`` are the standard deviations of the
    angles divided by those of the whole plan.
    """

    name: str
    without_deg: float | None
    factors: Angles | None


def gain_rows(gains: Iterable[InformationGain], sigma_deg: Angles | None) -> list[GainRow]:
    """Rows of the information gain of each target and line.

    Parameters
    ----------
    sigma_deg : Angles or None
        Standard deviations of the whole plan; None if they are not determined.
    """
    rows = []
    for each in gains:
        without, factors = finite_or_none(np.degrees(each.without)), None
        if without is not None and sigma_deg is not None:
            factors = angles(np.degrees(each.sigma) / list(sigma_deg))
        rows.append(GainRow(each.name, without, factors))
    return rows


FACTOR_TIP = N_(
    "Standard deviation of this angle if the target or line is omitted, divided by that of the "
    "whole plan; ∞ if the angles are not determined without it"
)
INFINITE_TEXT = "∞"


GAINS_TABLE = Table[GainRow](
    N_("Information gain of each target and line"),
    (
        Column(
            "name", N_("Omitted"),
            tip=N_("Target or line omitted from the survey plan"),
        ),
        Column(
            "without_deg", N_("Largest σ"), DEGREES,
            N_("Largest of the three standard deviations if this target or line is omitted"),
            unknown=NOT_DETERMINED_TEXT,
        ),
        Column("factors.roll", N_("Factor\nroll"), ratio(2), FACTOR_TIP, unknown=INFINITE_TEXT),
        Column("factors.pitch", N_("Factor\npitch"), ratio(2), FACTOR_TIP, unknown=INFINITE_TEXT),
        Column("factors.yaw", N_("Factor\nyaw"), ratio(2), FACTOR_TIP, unknown=INFINITE_TEXT),
    ),
)  # fmt: skip

WINDOW_GAINS_TABLE = GAINS_TABLE.without("Largest σ")
"""Table of the window, which shows the standard deviations of the whole plan above it."""


# -- search ----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ShorterPlan:
    """One of the plans with successively fewer targets and lines."""

    minutes: float
    value_deg: float
    targets: tuple[str, ...]
    lines: int

    @classmethod
    def of(cls, step: ReductionStep) -> "ShorterPlan":
        """Values of a plan of the search."""
        names = tuple(target.name for target in step.plan.targets)
        return cls(step.minutes, float(np.degrees(step.value)), names, len(step.plan.lines))


@dataclass(frozen=True)
class DesignValues:
    """Result of the search for a plan; ``value_deg`` is the value of the objective.

    ``exact``: all possible plans were evaluated. ``without_deg``: value without a target or line.
    """

    sigma_deg: Angles | None
    value_deg: float
    thesis_sigma_deg: Angles | None
    exact: bool
    plans_evaluated: int
    targets: tuple[PlannedTarget, ...]
    lines: tuple[PlannedLine, ...]
    without_deg: Mapping[str, float | None]
    pareto_front: tuple[ShorterPlan, ...]

    @classmethod
    def of(cls, found: DesignResult, wall: Wall, thesis: Prediction) -> "DesignValues":
        """Values of a search at a wall, and the prediction for the plan of the thesis."""
        return cls(
            sigma_deg=known_degrees(found.prediction.sigma),
            value_deg=float(np.degrees(found.value)),
            thesis_sigma_deg=known_degrees(thesis.sigma),
            exact=found.exact,
            plans_evaluated=found.evaluated,
            targets=tuple(planned_targets(found.plan, wall)),
            lines=tuple(planned_lines(found.plan, wall)),
            without_deg={each.name: each.without_deg for each in gain_rows(found.gains, None)},
            pareto_front=tuple(map(ShorterPlan.of, found.front)),
        )  # fmt: skip


SHORTER_PLANS_TABLE = Table[ShorterPlan](
    N_("Shorter surveys"),
    (
        Column("minutes", N_("Minutes on site"), COUNT),
        Column("value_deg", N_("Largest σ"), DEGREES),
        Column(lambda row: len(row.targets), N_("Targets"), COUNT),
        Column("lines", N_("Lines"), COUNT),
    ),
)


@dataclass(frozen=True)
class ShorterPlanPrecision:
    """A shorter plan with its predicted standard deviations."""

    plan: ShorterPlan
    sigma_deg: Angles | None

    @classmethod
    def of(cls, step: ReductionStep) -> "ShorterPlanPrecision":
        """Predict the standard deviations of a plan of the search."""
        return cls(ShorterPlan.of(step), known_degrees(predict(step.plan).sigma))


SHORTER_PLANS_CSV = Table[ShorterPlanPrecision](
    "front.csv",
    (
        Column("plan.minutes", "minutes", Format("", 1)),
        Column("plan.value_deg", "value_deg", CSV_DEGREES),
        *(Column(f"sigma_deg.{name}", f"{name}_deg", CSV_DEGREES) for name in ANGLES),
        Column(lambda row: " ".join(row.plan.targets), "targets"),
        Column("plan.lines", "lines", COUNT),
    ),
)
"""Table of the shorter plans as CSV; the titles are keys."""


def with_objective(table: Table[Row], criterion: Criterion) -> Table[Row]:
    """Copy of `GAINS_TABLE` or `SHORTER_PLANS_TABLE` for another criterion than the largest σ."""
    return replace(
        table,
        columns=tuple(
            each.with_title(CRITERION_TEXTS[criterion]) if each.format is DEGREES else each
            for each in table.columns
        ),
    )


# -- scenarios -------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ScenarioValues:
    """Predicted standard deviations of one case of a scenario with one model of POS errors."""

    scenario: str
    case: str
    pos_errors: str
    sigma_deg: Angles | None
    points: int

    @classmethod
    def of(cls, found: ScenarioOutcome) -> "ScenarioValues":
        """Values of one case."""
        return cls(
            found.scenario, found.case, found.pos_errors, known_degrees(found.sigma),
            round(found.points),
        )  # fmt: skip


SCENARIOS_TABLE = Table[ScenarioValues](
    N_("Predicted standard deviations"),
    (
        Column("case", N_("Case")),
        Column(
            "pos_errors", N_("POS errors"),
            texts={"correlated": N_("correlated"), "independent": N_("uncorrelated")},
        ),
        *angle_columns("sigma_deg", DEGREES, unknown=NOT_DETERMINED_TEXT),
        Column("points", N_("Points"), COUNT),
    ),
)  # fmt: skip

SCENARIOS_CSV = Table[ScenarioValues](
    "scenarios.csv",
    (
        Column("scenario", "scenario"),
        Column("case", "case"),
        Column("pos_errors", "pos_errors"),
        *(Column(f"sigma_deg.{name}", f"{name}_deg", CSV_DEGREES) for name in ANGLES),
        Column("points", "points", COUNT),
    ),
)
"""Table of all cases as CSV; the titles are keys."""


# -- simulated surveys, and comparison with a survey -----------------------------------------------


@dataclass(frozen=True)
class FormattedAnglesRow(AnglesRow):
    """Table row with its own format of the values."""

    format: Format


ANGLES_BY_ROW_TABLE = Table[FormattedAnglesRow](
    "", (Column("name", ""), *angle_columns("values", lambda row: row.format))
)
"""Table whose title contains the survey plan."""


DEGREES_WITHOUT_UNIT = replace(DEGREES, unit="")
"""Format of degrees without the unit, which the names of the rows contain."""


def _formatted_rows(*rows: tuple[str, Angles | None, Format]) -> list[FormattedAnglesRow]:
    return [FormattedAnglesRow(gettext(name), values, form) for name, values, form in rows]


def _quotient(one: Angles, other: Angles) -> Angles:
    return angles(np.divide([*one], [*other]))


@dataclass(frozen=True)
class SimulationValues:
    """Results of many simulated surveys of a plan, as in `MonteCarloResult`.

    ``adjusted`` and ``failed`` are numbers of surveys; ``scatter_deg`` is the RMS error;
    ``coverage_95`` is the share of the 95 % intervals that contain the true angle;
    ``chi_square_expected`` has the bounds of the central 95 % of ``chi_square``.
    """

    adjusted: int
    failed: int
    scatter_deg: Angles
    formal_sigma_deg: Angles
    predicted_sigma_deg: Angles
    coverage_95: Angles
    bias_deg: Angles
    bias_sigma_deg: Angles
    chi_square: float
    chi_square_expected: tuple[float, ...]
    messages: tuple[Message, ...]

    @classmethod
    def of(cls, found: MonteCarloResult) -> "SimulationValues":
        """Values of simulated surveys."""
        return cls(
            len(found.errors), found.failed, degrees(found.empirical_sigma),
            degrees(found.mean_formal_sigma), degrees(found.predicted),
            angles(found.interval_coverage), degrees(found.bias), degrees(found.sigma_bias),
            found.chi_square, floats(found.chi_square_bounds), found.messages,
        )  # fmt: skip

    @property
    def rows(self) -> list[FormattedAnglesRow]:
        """Rows with the scatter, and the standard deviations to compare it with."""
        quotient = _quotient(self.scatter_deg, self.predicted_sigma_deg)
        sigma = angles(np.divide([*quotient], np.sqrt(2 * self.adjusted)))
        return _formatted_rows(
            (N_("RMS error (°)"), self.scatter_deg, DEGREES_WITHOUT_UNIT),
            (N_("σ from the adjustment (°)"), self.formal_sigma_deg, DEGREES_WITHOUT_UNIT),
            (N_("predicted σ (°)"), self.predicted_sigma_deg, DEGREES_WITHOUT_UNIT),
            (N_("RMS error / predicted σ"), quotient, ratio(2)),
            (N_("σ of this ratio"), sigma, ratio(2)),
            (N_("coverage of the 95 % intervals (%)"), self.coverage_95, Format("", 1, 100.0)),
            (N_("mean error (°)"), self.bias_deg, DEGREES_WITHOUT_UNIT.signed),
            (N_("σ of mean error (°)"), self.bias_sigma_deg, DEGREES_WITHOUT_UNIT),
        )

    @property
    def summary_texts(self) -> Sequence[str]:
        """Conclusions as sentences in the language in use."""
        return tuple(map(message_text, self.messages))


@dataclass(frozen=True)
class PlanComparison:
    """Comparison of a survey with its plan.

    Attributes
    ----------
    planned_sigma_deg : predicted for the whole plan
    surveyed_sigma_deg : predicted for the lines as sailed, with the targets that were used
    surveyed_with_form_error_sigma_deg : the same with the form error estimated from the data
    obtained_sigma_deg : from the adjustment
    flatness_m : form error of the targets as planned and as estimated
    missing_targets, missing_lines : names
    messages : lines surveyed at another distance, and loss of precision by what is missing
    """

    planned_sigma_deg: Angles | None
    surveyed_sigma_deg: Angles | None
    surveyed_with_form_error_sigma_deg: Angles | None
    obtained_sigma_deg: Angles
    flatness_m: tuple[float, float]
    missing_targets: tuple[str, ...]
    missing_lines: tuple[str, ...]
    messages: tuple[Message, ...]

    @property
    def rows(self) -> list[FormattedAnglesRow]:
        """Rows with the standard deviations, and the ratio of obtained to predicted ones."""
        predicted, obtained = self.surveyed_with_form_error_sigma_deg, self.obtained_sigma_deg
        quotient = None if predicted is None else _quotient(obtained, predicted)
        return _formatted_rows(
            (N_("predicted for the survey plan"), self.planned_sigma_deg, DEGREES_WITHOUT_UNIT),
            (N_("predicted for the actual survey"), self.surveyed_sigma_deg, DEGREES_WITHOUT_UNIT),
            (N_("predicted with estimated form error"), predicted, DEGREES_WITHOUT_UNIT),
            (N_("from the adjustment"), obtained, DEGREES_WITHOUT_UNIT),
            (N_("adjustment / predicted"), quotient, ratio(2)),
        )

    @property
    def summary_texts(self) -> Sequence[str]:
        """Deviations from the plan and their effect, as sentences."""
        planned, estimated = self.flatness_m
        found = []
        if self.surveyed_sigma_deg is None:
            found.append(gettext("The surveyed part of the survey plan does not determine the "
                                 "boresight angles."))  # fmt: skip
        found.append(
            gettext(
                "Form error of the targets: {planned:mm.2} mm planned, {estimated:mm.2} mm "
                "estimated.",
                planned=planned,
                estimated=estimated,
            )
        )
        return (*found, *map(message_text, self.messages))
