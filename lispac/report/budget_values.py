"""The values of a report's error budget."""

from dataclasses import dataclass

from lispac.adjustment.diagnostics.error_budget import (
    BeamBudget,
    ErrorBudget,
    PointSigma,
    SourceBudget,
)
from lispac.language import LazyText, gettext_lazy
from lispac.messages import Message


@dataclass(frozen=True)
class PointError:
    """1 sigma of a point; see `lispac.adjustment.diagnostics.error_budget.PointSigma`."""

    horizontal_m: float
    vertical_m: float
    across_beam_m: float
    total_m: float

    @classmethod
    def of(cls, values: PointSigma) -> "PointError":
        """Values of the spread of a point."""
        return cls(values.horizontal, values.vertical, values.across, values.total)


@dataclass(frozen=True)
class ErrorSource:
    """One source, or all together, at each distance; None where it is not known."""

    source: LazyText
    at_distance: tuple[PointError, ...] | None

    @classmethod
    def of(cls, values: SourceBudget) -> "ErrorSource":
        """Values of one source of the error budget."""
        spreads = values.spreads
        return cls(
            gettext_lazy(values.source),
            None if spreads is None else tuple(map(PointError.of, spreads)),
        )


@dataclass(frozen=True)
class BeamErrors:
    """All sources of error for one direction of the beam."""

    beam: LazyText
    sources: tuple[ErrorSource, ...]
    before: ErrorSource
    after: ErrorSource

    @classmethod
    def of(cls, values: BeamBudget) -> "BeamErrors":
        """Values of one direction of the beam."""
        return cls(
            gettext_lazy(values.beam),
            tuple(map(ErrorSource.of, values.sources)),
            ErrorSource.of(values.before),
            ErrorSource.of(values.after),
        )


@dataclass(frozen=True)
class ErrorBudgetValues:
    """Error budget of a point by source, at some distances from the scanner."""

    distances_m: tuple[float, ...]
    beams: tuple[BeamErrors, ...]
    messages: tuple[Message, ...]

    @classmethod
    def of(cls, values: ErrorBudget) -> "ErrorBudgetValues":
        """Values of an error budget."""
        beams = tuple(map(BeamErrors.of, values.beams))
        return cls(values.distances, beams, values.assumptions)
