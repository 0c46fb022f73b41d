"""Differences between the lines of a survey without calibration, as values and tables.

Field names are the keys of ``differences`` in JSON.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from operator import itemgetter

import numpy as np

from lispac.language import N_, gettext
from lispac.present.tables import COUNT, MILLIMETRES, Column, Format, Table
from lispac.validation.line_differences import DifferenceStatistics, Facing, LineDifference

FACING_TEXTS: Mapping[Facing, str] = {
    "all": N_("all surfaces"),
    "level": N_("horizontal surfaces"),
    "upright": N_("vertical surfaces"),
    "sloped": N_("inclined surfaces"),
}


@dataclass(frozen=True)
class LineDifferenceValues:
    """Statistics of one pair of lines, or of ``all``, as in `DifferenceStatistics`."""

    first: str
    second: str
    facing: Facing
    places: int
    median_m: float | None
    rmsd_m: float
    robust_sigma_m: float | None
    p95_m: float
    largest_m: float
    significant: float

    @classmethod
    def of(
        cls, first: str, second: str, facing: Facing, values: DifferenceStatistics
    ) -> "LineDifferenceValues":
        """Values of the statistics on surfaces of one orientation."""
        return cls(
            first, second, facing, values.places, values.median, values.rmsd, values.robust_sigma,
            values.p95, values.largest, values.significant,
        )  # fmt: skip


PAIR_TITLE, ALL_PAIRS_TITLE = N_("{first} − {second}, {facing}"), N_("All lines, {facing}")
"""Titles of the map of a row."""


def difference_title(row: LineDifferenceValues) -> str:
    """Lines and orientation of the surfaces of a row."""
    title = ALL_PAIRS_TITLE if row.first == row.second else PAIR_TITLE
    facing = gettext(FACING_TEXTS[row.facing])
    return gettext(title, first=row.first, second=row.second, facing=facing)


def _line_name(name: str) -> Callable[[LineDifferenceValues], str]:
    def text(row: LineDifferenceValues) -> str:
        return gettext("all lines") if row.first == row.second else getattr(row, name)

    return text


LINE_DIFFERENCES_TABLE = Table[LineDifferenceValues](
    N_("Differences between the lines along the normal of flat places"),
    (
        Column(
            _line_name("first"), N_("First line"), tip=N_("Line whose surface normals are used")
        ),
        Column(
            _line_name("second"), N_("Second line"), tip=N_("Line compared with the first line")
        ),
        Column(
            "facing", N_("Orientation"), texts=FACING_TEXTS,
            tip=N_(
                "Orientation of the surfaces: horizontal or vertical within 10°, inclined, or all"
            ),
        ),
        Column(
            "places", N_("Compared places"), COUNT,
            N_("Number of flat places observed in both lines"),
        ),
        Column(
            "median_m", N_("Median"), MILLIMETRES.signed,
            N_(
                "Median difference along the normal, positive if the first line is nearer to the "
                "vessel"
            ),
        ),
        Column("rmsd_m", N_("RMS"), MILLIMETRES, N_("Root mean square of the differences")),
        Column(
            "robust_sigma_m", N_("Robust σ"), MILLIMETRES,
            N_(
                "Robust standard deviation: 1.4826 times the median absolute deviation from the "
                "median"
            ),
        ),
        Column(
            "p95_m", N_("95th percentile"), MILLIMETRES,
            N_("95th percentile of the absolute differences"),
        ),
        Column("largest_m", N_("Maximum"), MILLIMETRES, N_("Largest absolute difference")),
    ),
)  # fmt: skip

PlaceRow = tuple[str, str, float, float, float, float, float, float]
"""Lines, place (north, west, up), difference, half its 95 % interval, upward part of the normal."""
_CSV_NUMBER = Format("", 4, is_grouped=False)
PLACES_CSV = Table[PlaceRow](
    "places",
    (
        Column(itemgetter(0), "first"),
        Column(itemgetter(1), "second"),
        *(
            Column[PlaceRow](itemgetter(k), key, _CSV_NUMBER)
            for k, key in enumerate(
                ("north_m", "west_m", "up_m", "difference_m", "interval_95_m", "upward"), start=2
            )
        ),
    ),
)
"""Table of all compared places as CSV; the titles are keys."""


def place_rows(pair: LineDifference) -> Iterator[PlaceRow]:
    """Rows of all compared places of a pair of lines."""
    columns = (*pair.place.T, pair.distance, pair.half_width, np.abs(pair.normal[:, 2]))
    for values in np.column_stack(columns).tolist():
        yield (pair.first, pair.second, *values)
