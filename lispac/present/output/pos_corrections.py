"""Corrections of the trajectory, as values and tables."""

from dataclasses import dataclass

import numpy as np

from lispac.adjustment.model.pos_corrections import PosCorrections
from lispac.language import N_
from lispac.present.tables import DEGREES, MILLIMETRES, SECONDS, YES_NO_TEXTS, Column, Format, Table

COMPONENT_TITLES = {
    "north": N_("North"), "east": N_("East"), "down": N_("Down"), "roll": N_("Roll"),
    "pitch": N_("Pitch"), "heading": N_("Heading"),
}  # fmt: skip
ANGLE_COMPONENTS = ("roll", "pitch", "heading")


@dataclass(frozen=True)
class CorrectedComponentValues:
    """Corrections of one component, metres for the position and degrees for the attitude.

    ``component``: ``north``, ``east``, ``down``, ``roll``, ``pitch`` or ``heading``;
    ``is_corrected``: whether the data determine it, otherwise its corrections are zero;
    ``largest_correction``: largest absolute correction in a sighted interval; ``given_sigma``: mean
    standard deviation of the given trajectory there; ``smallest_sigma``: smallest one after the
    correction.
    """

    component: str
    is_corrected: bool
    largest_correction: float
    given_sigma: float
    smallest_sigma: float


@dataclass(frozen=True)
class SightedIntervalValues:
    """First and last time of an interval with sightings, in the time base of the trajectory."""

    first_s: float
    last_s: float


@dataclass(frozen=True)
class PosCorrectionValues:
    """Corrections of the trajectory: components, sighted intervals and correlation times.

    Between and outside the intervals, the corrections are predicted with these correlation times.
    """

    components: tuple[CorrectedComponentValues, ...]
    sighted_intervals: tuple[SightedIntervalValues, ...]
    position_time_s: float
    attitude_time_s: float


def pos_correction_values(found: PosCorrections) -> PosCorrectionValues:
    """Values of the corrections of a result."""
    units = np.repeat([1.0, np.degrees(1.0)], 3)
    largest = units * np.abs(found.correction).max(axis=0)
    given = units * found.prior_sigma.mean(axis=0)
    smallest = units * found.sigma.min(axis=0)
    return PosCorrectionValues(
        tuple(
            CorrectedComponentValues(
                name,
                bool(found.determined[k]),
                float(largest[k]) if found.determined[k] else 0.0,
                float(given[k]),
                float(smallest[k] if found.determined[k] else given[k]),
            )
            for k, name in enumerate(COMPONENT_TITLES)
        ),
        tuple(
            SightedIntervalValues(float(first), float(last))
            for first, last in found.sighted_intervals
        ),
        found.position_time,
        found.attitude_time,
    )


def _format(row: CorrectedComponentValues) -> Format:
    return DEGREES if row.component in ANGLE_COMPONENTS else MILLIMETRES


POS_CORRECTIONS_TABLE = Table[CorrectedComponentValues](
    N_("Corrections of the trajectory"),
    (
        Column("component", N_("Component"), texts=COMPONENT_TITLES),
        Column(
            "is_corrected", N_("Corrected"), texts=YES_NO_TEXTS,
            tip=N_("Whether the data determine the component; otherwise it is not corrected"),
        ),
        Column("largest_correction", N_("Largest correction"), _format, has_unit_in_cells=True),
        Column("given_sigma", N_("Given 1 σ"), _format, has_unit_in_cells=True),
        Column(
            "smallest_sigma", N_("Smallest 1 σ after the correction"), _format,
            has_unit_in_cells=True,
        ),
    ),
)  # fmt: skip
SIGHTED_INTERVALS_TABLE = Table[SightedIntervalValues](
    N_("Intervals with sightings, which support the corrections"),
    (
        Column("first_s", N_("First time"), SECONDS),
        Column("last_s", N_("Last time"), SECONDS),
        Column(lambda row: row.last_s - row.first_s, N_("Duration"), SECONDS),
    ),
)
