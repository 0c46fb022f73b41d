"""The values of a report's error budget."""

from dataclasses import dataclass

from lispac.adjustment.error_budget import BeamBudget, ErrorBudget, SourceBudget, Spread
from lispac.language import LazyText, gettext_lazy
from lispac.messages import Message


@dataclass(frozen=True)
class PointError:
    """1 sigma of a point; see `lispac.adjustment.error_budget.Spread`."""

    horizontal_m: float
    vertical_m: float
    across_beam_m: float
    total_m: float

    @classmethod
    def of(cls, values: Spread) -> "PointError":
        """The same figures."""
        return cls(values.horizontal, values.vertical, values.across, values.total)


@dataclass(frozen=True)
class ErrorSource:
    """One source, or all together, at each distance; None where it is not known."""

    source: LazyText
    at_distance: tuple[PointError, ...] | None

    @classmethod
    def of(cls, values: SourceBudget) -> "ErrorSource":
        """The same figures."""
        spreads = values.spreads
        return cls(
            gettext_lazy(values.source),
            None if spreads is None else tuple(map(PointError.of, spreads)),
        )


@dataclass(frozen=True)
class BeamErrors:
    """All sources for one direction of the beam."""

    beam: LazyText
    sources: tuple[ErrorSource, ...]
    before: ErrorSource
    after: ErrorSource

    @classmethod
    def of(cls, values: BeamBudget) -> "BeamErrors":
        """The same figures."""
        return cls(
            gettext_lazy(values.beam),
            tuple(map(ErrorSource.of, values.sources)),
            ErrorSource.of(values.before),
            ErrorSource.of(values.after),
        )


@dataclass(frozen=True)
class Budget:
    """What every source of error does to a point at some distances from the scanner."""

    distances_m: tuple[float, ...]
    beams: tuple[BeamErrors, ...]
    in_words: tuple[Message, ...]

    @classmethod
    def of(cls, values: ErrorBudget) -> "Budget":
        """The same figures."""
        beams = tuple(map(BeamErrors.of, values.beams))
        return cls(values.distances, beams, values.assumptions)
