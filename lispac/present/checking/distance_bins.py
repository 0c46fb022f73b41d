"""Distances on a validation plane in bins: histogram, and intervals of height or range."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from lispac.language import N_
from lispac.present.tables import COUNT, Column, Format, Table
from lispac.validation.distance_profile import DistanceProfile


@dataclass(frozen=True)
class DistancesBySteps:
    """Distances by intervals of height or range; None for an interval with too few points."""

    edges_m: tuple[float, ...]
    n: tuple[int, ...]
    median_before_m: tuple[float | None, ...]
    median_after_m: tuple[float | None, ...]
    p95_before_m: tuple[float | None, ...]
    p95_after_m: tuple[float | None, ...]

    @classmethod
    def of(cls, profile: DistanceProfile) -> "DistancesBySteps":
        """Values of a profile of distances."""
        return cls(
            tuple(profile.edges.tolist()),
            tuple(profile.n.tolist()),
            *(
                tuple(None if np.isnan(each) else each for each in figures.tolist())
                for figures in (
                    profile.median_before, profile.median_after, profile.p95_before,
                    profile.p95_after,
                )
            ),
        )  # fmt: skip


BIN_EDGE = Format("", 4, 1e3, is_grouped=False)
STEP_EDGE = Format("", 3, is_grouped=False)
STEP_DISTANCE = Format("", 3, 1e3, is_grouped=False)


@dataclass(frozen=True)
class HistogramBin:
    """Bin of a histogram of distances; ``to_m`` is None for the last one, which has no end."""

    from_m: float
    to_m: float | None
    before: int
    after: int


def histogram_bins(
    edges_m: Sequence[float], before: Sequence[int], after: Sequence[int]
) -> list[HistogramBin]:
    """Bins of a histogram from its edges and the numbers of points in each bin."""
    ends = [*edges_m[1:-1], None]
    return [
        HistogramBin(*each) for each in zip(edges_m[:-1], ends, before, after, strict=True)
    ]  # fmt: skip


HISTOGRAM_TABLE = Table[HistogramBin](
    "",
    (
        Column("from_m", N_("From (mm)"), BIN_EDGE),
        Column("to_m", N_("To (mm)"), BIN_EDGE, unknown=N_("and beyond")),
        Column("before", N_("Points before calibration"), COUNT),
        Column("after", N_("Points after calibration"), COUNT),
    ),
)
"""Table of a histogram, for spreadsheets."""


@dataclass(frozen=True)
class DistanceStep:
    """Distances in one interval of height or range, as in `DistancesBySteps`."""

    quantity: Literal["height", "range"]
    from_m: float
    to_m: float
    n: int
    median_before_m: float | None
    median_after_m: float | None
    p95_before_m: float | None
    p95_after_m: float | None


def distance_steps(
    quantity: Literal["height", "range"], profile: DistancesBySteps | None
) -> list[DistanceStep]:
    """Intervals of a profile by height or range; none if it is unknown."""
    if profile is None:
        return []
    columns = (
        profile.edges_m[:-1], profile.edges_m[1:], profile.n, profile.median_before_m,
        profile.median_after_m, profile.p95_before_m, profile.p95_after_m,
    )  # fmt: skip
    return [DistanceStep(quantity, *each) for each in zip(*columns, strict=True)]


DISTANCE_STEPS_TABLE = Table[DistanceStep](
    "",
    (
        Column("from_m", N_("From (m)"), STEP_EDGE),
        Column("to_m", N_("To (m)"), STEP_EDGE),
        Column("n", N_("Distances"), COUNT),
        Column("median_before_m", N_("Median before (mm)"), STEP_DISTANCE),
        Column("median_after_m", N_("Median after (mm)"), STEP_DISTANCE),
        Column("p95_before_m", N_("95 % before (mm)"), STEP_DISTANCE),
        Column("p95_after_m", N_("95 % after (mm)"), STEP_DISTANCE),
    ),
)
"""Table of a profile by height or range, for spreadsheets."""
BOTH_PROFILES_TABLE = replace(
    DISTANCE_STEPS_TABLE,
    columns=(
        Column(
            "quantity", N_("Quantity"), texts={"height": N_("Height"), "range": N_("Range")}
        ),
        *DISTANCE_STEPS_TABLE.columns,
    ),
)  # fmt: skip
