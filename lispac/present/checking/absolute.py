"""Comparison of the lines with a reference, as values and tables."""

from dataclasses import dataclass

from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.present.checking.validation import (
    STATE_TEXTS,
    DistanceValues,
    SignedDistances,
    spread_columns,
)
from lispac.present.tables import (
    COUNT,
    MILLIMETRES,
    PERCENT,
    PLAIN_MILLIMETRES,
    YES_NO_TEXTS,
    Column,
    Table,
)
from lispac.validation.absolute_check import (
    ALL_LINES,
    AbsoluteCheck,
    AbsoluteState,
    LineCheck,
    SigmaSources,
)
from lispac.validation.absolute_messages import absolute_check_messages


@dataclass(frozen=True)
class UncertaintyBySource:
    """Standard deviations by source of error; ``boresight_m`` is None for the prior boresight."""

    reference_m: float
    pos_position_m: float
    pos_attitude_m: float
    boresight_m: float | None
    scatter_m: float
    total_m: float

    @classmethod
    def of(cls, values: SigmaSources) -> "UncertaintyBySource":
        """Copy the standard deviations of a `SigmaSources`."""
        return cls(
            values.reference, values.position, values.attitude, values.boresight, values.scatter,
            values.total,
        )  # fmt: skip


@dataclass(frozen=True)
class ReferenceDistances:
    """Distances of the lines from the reference with one boresight, as in `AbsoluteState`."""

    distances: DistanceValues
    signed: SignedDistances
    mean_interval95_m: float
    mean_significant: bool
    mean_sigma: UncertaintyBySource
    rms_expected: UncertaintyBySource
    reference_share: float

    @classmethod
    def of(cls, state: AbsoluteState) -> "ReferenceDistances":
        """Values of a comparison with one boresight."""
        return cls(
            DistanceValues.of(state.distances),
            SignedDistances.of(state.signed),
            state.interval_95,
            state.significant,
            UncertaintyBySource.of(state.mean_sigma),
            UncertaintyBySource.of(state.rms_expected),
            state.reference_share,
        )


@dataclass(frozen=True)
class LineReferenceDistances:
    """Distances of one line, or of all lines, at the same places before and after calibration."""

    line: str
    before: ReferenceDistances
    after: ReferenceDistances

    @classmethod
    def of(cls, line: LineCheck) -> "LineReferenceDistances":
        """Values of the check of a line."""
        return cls(line.line, ReferenceDistances.of(line.before), ReferenceDistances.of(line.after))


@dataclass(frozen=True)
class SurveyedPoint:
    """Mean distance of the lines from a surveyed point, or from a plane through several points."""

    name: str
    lines: int
    sigma_m: float
    before_m: float
    after_m: float
    after_interval95_m: float | None

    @property
    def significant(self) -> bool:
        """Whether the mean distance is significant at 95 %; False if its interval is unknown."""
        half = self.after_interval95_m
        return half is not None and abs(self.after_m) > half


@dataclass(frozen=True)
class AbsoluteCheckValues:
    """Comparison of the lines with a static scan or with surveyed points.

    The first and the last bin of the histogram include all distances beyond them.
    """

    reference: str
    kind: str
    system: str
    reference_sigma_m: float
    search_distance_m: float
    lines: tuple[LineReferenceDistances, ...]
    all_lines: LineReferenceDistances
    points: tuple[SurveyedPoint, ...]
    not_compared: tuple[Message, ...]
    bin_edges_m: tuple[float, ...]
    counts_before: tuple[int, ...]
    counts_after: tuple[int, ...]
    messages: tuple[Message, ...]

    @classmethod
    def of(cls, check: AbsoluteCheck) -> "AbsoluteCheckValues":
        """Values of a check against a reference."""
        return cls(
            reference=check.reference,
            kind=check.kind,
            system=check.system,
            reference_sigma_m=check.sigma,
            search_distance_m=check.search_distance,
            lines=tuple(map(LineReferenceDistances.of, check.lines)),
            all_lines=LineReferenceDistances.of(check.all_lines),
            points=tuple(
                SurveyedPoint(p.name, p.lines, p.sigma, p.before, p.after, p.interval_95)
                for p in check.points
            ),
            not_compared=check.not_compared,
            bin_edges_m=check.bin_edges,
            counts_before=check.counts_before,
            counts_after=check.counts_after,
            messages=absolute_check_messages(check),
        )


# -- tables ----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class LineState:
    """Table row with the distances of one line, or of all lines, with one boresight."""

    line: str
    state: str
    distances: ReferenceDistances


def _line_name(row: "LineState | LineReferenceDistances") -> str:
    return gettext("all lines") if row.line == ALL_LINES else row.line


def lines_and_all(check: AbsoluteCheckValues) -> tuple[LineReferenceDistances, ...]:
    """Values of each line, then of all lines together."""
    return (*check.lines, check.all_lines)


def line_states(check: AbsoluteCheckValues) -> list[LineState]:
    """Rows of each line, then of all lines together, before and after the calibration."""
    return [
        LineState(line.line, state, getattr(line, state))
        for line in lines_and_all(check)
        for state in ("before", "after")
    ]


REFERENCE_DISTANCES_TABLE = Table[LineState](
    N_("Distances of the lines from the reference (mm)"),
    (
        Column(_line_name, N_("Line")),
        Column("state", N_("State"), texts=STATE_TEXTS),
        Column("distances.distances.n", N_("Compared\nplaces"), COUNT),
        Column("distances.signed.mean_m", N_("Mean"), PLAIN_MILLIMETRES.signed),
        Column(
            "distances.mean_interval95_m", N_("95 %\ninterval\nof mean"),
            PLAIN_MILLIMETRES.half_interval,
        ),
        Column("distances.signed.median_m", N_("Median"), PLAIN_MILLIMETRES.signed),
        *spread_columns("distances.distances"),
        Column("distances.signed.robust_sigma_m", N_("Robust\nsigma"), PLAIN_MILLIMETRES),
        Column("distances.mean_significant", N_("Mean\nsignificant"), texts=YES_NO_TEXTS),
    ),
)  # fmt: skip
LINE_CHECKS_TABLE = Table[LineReferenceDistances](
    N_("Lines and reference"),
    (
        Column(
            _line_name, N_("Line"),
            tip=N_("Line compared with the reference, or all lines together"),
        ),
        Column(
            "after.distances.n", N_("Compared places"), COUNT,
            N_(
                "Number of places where line and reference are compared, the same before and after "
                "calibration"
            ),
        ),
        Column(
            "before.signed.mean_m", N_("Mean before calibration"), MILLIMETRES.signed,
            N_(
                "Mean distance of the line from the reference before calibration, positive towards "
                "the vessel"
            ),
        ),
        Column(
            "before.mean_interval95_m", N_("± 95 % before calibration"), MILLIMETRES,
            N_(
                "Half-width of the 95 % confidence interval of the mean before calibration. It "
                "includes the uncertainties of the POS and the reference."
            ),
        ),
        Column(
            "before.distances.rms_m", N_("RMS before calibration"), MILLIMETRES,
            N_("Root mean square distance of the line from the reference before calibration"),
        ),
        Column(
            "after.signed.mean_m", N_("Mean after calibration"), MILLIMETRES.signed,
            N_(
                "Mean distance of the line from the reference after calibration, positive towards "
                "the vessel"
            ),
        ),
        Column(
            "after.mean_interval95_m", N_("± 95 % after calibration"), MILLIMETRES,
            N_(
                "Half-width of the 95 % confidence interval of the mean after calibration. It "
                "includes the uncertainties of the POS, the reference and the boresight."
            ),
        ),
        Column(
            "after.distances.rms_m", N_("RMS after calibration"), MILLIMETRES,
            N_("Root mean square distance of the line from the reference after calibration"),
        ),
        Column(
            "after.mean_significant", N_("Result"),
            tip=N_(
                "The line agrees with the reference if the 95 % confidence interval of the mean "
                "after calibration includes zero"
            ),
            texts={True: N_("differs from reference"), False: N_("agrees with reference")},
        ),
    ),
)  # fmt: skip
"""Table of the window, with a row for each line."""
MEAN_UNCERTAINTY_TABLE = Table[LineReferenceDistances](
    N_("Uncertainty of the mean distance after the calibration, 1 sigma (mm)"),
    (
        Column(_line_name, N_("Line")),
        Column("after.mean_sigma.reference_m", N_("Reference"), PLAIN_MILLIMETRES),
        Column("after.mean_sigma.pos_position_m", N_("POS\nposition"), PLAIN_MILLIMETRES),
        Column("after.mean_sigma.pos_attitude_m", N_("POS\nattitude"), PLAIN_MILLIMETRES),
        Column("after.mean_sigma.boresight_m", N_("Boresight"), PLAIN_MILLIMETRES),
        Column("after.mean_sigma.scatter_m", N_("Scatter"), PLAIN_MILLIMETRES),
        Column("after.mean_sigma.total_m", N_("Total"), PLAIN_MILLIMETRES),
        Column("after.rms_expected.total_m", N_("Expected\nRMS"), PLAIN_MILLIMETRES),
        Column(
            "after.reference_share", N_("RMS share due\nto the reference"), PERCENT,
            has_unit_in_cells=True,
        ),
    ),
)  # fmt: skip
SURVEYED_POINTS_TABLE = Table[SurveyedPoint](
    N_("Distances from surveyed points and planes, mean of the lines (mm)"),
    (
        Column("name", N_("Name")),
        Column("lines", N_("Lines"), COUNT),
        Column("sigma_m", N_("Sigma"), PLAIN_MILLIMETRES),
        Column("before_m", N_("Before"), PLAIN_MILLIMETRES.signed),
        Column("after_m", N_("After"), PLAIN_MILLIMETRES.signed),
        Column(
            "after_interval95_m", N_("95 %\ninterval\nof mean"), PLAIN_MILLIMETRES.half_interval
        ),
        Column("significant", N_("Mean\nsignificant"), texts=YES_NO_TEXTS),
    ),
)  # fmt: skip
