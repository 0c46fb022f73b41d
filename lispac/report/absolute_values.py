"""Values of a report from the comparison with a reference."""

from dataclasses import dataclass

from lispac.messages import Message
from lispac.report.validation_values import Distances, SignedDistances
from lispac.validation.absolute import AbsoluteCheck, AbsoluteState, LineCheck, SigmaSources
from lispac.validation.absolute_remarks import remarks_on


@dataclass(frozen=True)
class Uncertainty:
    """Standard deviations by source; that of the prior boresight is unknown."""

    reference_m: float
    pos_position_m: float
    pos_attitude_m: float
    boresight_m: float | None
    scatter_m: float
    total_m: float

    @classmethod
    def of(cls, values: SigmaSources) -> "Uncertainty":
        """The same figures."""
        return cls(
            values.reference, values.position, values.attitude, values.boresight, values.scatter,
            values.total,
        )  # fmt: skip


@dataclass(frozen=True)
class AgainstReference:
    """Lines against the reference with one boresight; see `AbsoluteState`."""

    distances: Distances
    signed: SignedDistances
    mean_interval95_m: float
    mean_significant: bool
    mean_sigma: Uncertainty
    rms_expected: Uncertainty
    reference_share: float

    @classmethod
    def of(cls, state: AbsoluteState) -> "AgainstReference":
        """The same figures."""
        return cls(
            Distances.of(state.distances),
            SignedDistances.of(state.signed),
            state.interval_95,
            state.significant,
            Uncertainty.of(state.mean_sigma),
            Uncertainty.of(state.rms_expected),
            state.reference_share,
        )


@dataclass(frozen=True)
class LineAgainstReference:
    """A line, or all of them, before and after at the same places."""

    line: str
    before: AgainstReference
    after: AgainstReference

    @classmethod
    def of(cls, line: LineCheck) -> "LineAgainstReference":
        """The same figures."""
        return cls(line.line, AgainstReference.of(line.before), AgainstReference.of(line.after))


@dataclass(frozen=True)
class SurveyedPoint:
    """A check point, or a plane through several, on the mean of the lines that saw it."""

    name: str
    lines: int
    sigma_m: float
    before_m: float
    after_m: float
    after_interval95_m: float | None

    @property
    def significant(self) -> bool:
        """Whether the lines differ from it at 95 %; not where the interval is unknown."""
        half = self.after_interval95_m
        return half is not None and abs(self.after_m) > half


@dataclass(frozen=True)
class Absolute:
    """Lines against a static scan or surveyed points; the end bins hold what lies beyond."""

    reference: str
    kind: str
    system: str
    reference_sigma_m: float
    reach_m: float
    lines: tuple[LineAgainstReference, ...]
    together: LineAgainstReference
    points: tuple[SurveyedPoint, ...]
    not_compared: tuple[Message, ...]
    bin_edges_m: tuple[float, ...]
    counts_before: tuple[int, ...]
    counts_after: tuple[int, ...]
    in_words: tuple[Message, ...]

    @classmethod
    def of(cls, check: AbsoluteCheck) -> "Absolute":
        """The same figures."""
        return cls(
            reference=check.reference,
            kind=check.kind,
            system=check.system,
            reference_sigma_m=check.sigma,
            reach_m=check.reach,
            lines=tuple(map(LineAgainstReference.of, check.lines)),
            together=LineAgainstReference.of(check.together),
            points=tuple(
                SurveyedPoint(p.name, p.lines, p.sigma, p.before, p.after, p.interval_95)
                for p in check.points
            ),
            not_compared=check.not_compared,
            bin_edges_m=check.bin_edges,
            counts_before=check.counts_before,
            counts_after=check.counts_after,
            in_words=remarks_on(check),
        )
