"""Error budget of a point by source of error, as values and tables."""

from collections.abc import Callable
from dataclasses import dataclass

from lispac.adjustment.diagnostics.error_budget import (
    BeamBudget,
    ErrorBudget,
    PointSigma,
    SourceBudget,
)
from lispac.language import N_, LazyText, gettext_lazy
from lispac.messages import Message
from lispac.present.tables import PLAIN_CENTIMETRES, Column, Table


@dataclass(frozen=True)
class PointError:
    """Standard deviations of a point, as in `PointSigma` of the error budget."""

    horizontal_m: float
    vertical_m: float
    across_beam_m: float
    total_m: float

    @classmethod
    def of(cls, values: PointSigma) -> "PointError":
        """Values of the standard deviations of a point."""
        return cls(values.horizontal, values.vertical, values.across, values.total)


@dataclass(frozen=True)
class ErrorSource:
    """Effect of one source, or of all together, at each distance; None if it is unknown."""

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
    """Errors by source for one direction of the beam.

    ``before`` and ``after`` are the sums of all sources with the prior and the estimated boresight.
    """

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


# -- table -----------------------------------------------------------------------------------------

COMPONENT_COLUMNS = (
    (
        "horizontal_m",
        N_("Horizontal\nat {distance:m.0} m"),
        N_("Horizontal error, 1 σ, {distance:m.0} m from the scanner"),
    ),
    (
        "vertical_m",
        N_("Vertical\nat {distance:m.0} m"),
        N_("Vertical error, 1 σ, {distance:m.0} m from the scanner"),
    ),
    (
        "across_beam_m",
        N_("Across beam\nat {distance:m.0} m"),
        N_("Error across the beam, 1 σ, {distance:m.0} m from the scanner"),
    ),
)
"""Fields of a `PointError`, with title and tooltip of their columns."""


def budget_table(
    budget: ErrorBudgetValues, beam: BeamErrors
) -> tuple[Table[ErrorSource], tuple[ErrorSource, ...]]:
    """Table of one direction of the beam, and its rows: each source, then the sums."""
    columns = [Column[ErrorSource]("source", N_("Source"), tip=N_("Source of error"))]
    for k, distance in enumerate(budget.distances_m):
        columns += [
            Column(
                _component(k, name), gettext_lazy(title, distance=distance), PLAIN_CENTIMETRES,
                gettext_lazy(tip, distance=distance),
                unknown=N_("not given") if k == i == 0 else "",
            )
            for i, (name, title, tip) in enumerate(COMPONENT_COLUMNS)
        ]  # fmt: skip
    title = gettext_lazy("Error of a point, 1 sigma (cm); beam {beam}", beam=beam.beam)
    return Table(title, tuple(columns)), (*beam.sources, beam.before, beam.after)


def _component(k: int, name: str) -> Callable[[ErrorSource], float | None]:
    def component(source: ErrorSource) -> float | None:
        return None if source.at_distance is None else getattr(source.at_distance[k], name)

    return component
