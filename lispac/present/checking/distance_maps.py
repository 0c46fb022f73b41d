"""Maps of the distances between two lines on a validation plane, as values and tables."""

from dataclasses import dataclass
from operator import itemgetter

from lispac.language import N_
from lispac.present.tables import Column, Format, Table
from lispac.validation.distance_map import DistanceMap

MAP_AXES = N_("Horizontal (m)"), N_("Up (m)")
HORIZONTAL_MAP_AXES = N_("East (m)"), N_("North (m)")
"""Titles of the axes of a map on a vertical or inclined plane, and on a horizontal one."""
PLACE, CELL_DISTANCE = Format("", 3, is_grouped=False), Format("", 2, 1e3, is_grouped=False)


@dataclass(frozen=True)
class DistanceMapValues:
    """Distances of the first line from the second in each cell, as in `DistanceMap`."""

    line_a: str
    line_b: str
    cell_m: float
    across_m: tuple[float, ...]
    up_m: tuple[float, ...]
    before_m: tuple[float, ...]
    after_m: tuple[float, ...]
    is_horizontal: bool

    @classmethod
    def of(cls, values: DistanceMap) -> "DistanceMapValues":
        """Values of a map of distances."""
        across, up, before, after = (
            tuple(each.tolist()) for each in (values.across, values.up, values.before, values.after)
        )
        return cls(
            values.line_a, values.line_b, values.cell, across, up, before, after,
            values.is_horizontal,
        )  # fmt: skip

    @property
    def axis_titles(self) -> tuple[str, str]:
        """Titles of the axes of ``across_m`` and ``up_m``, in English."""
        return HORIZONTAL_MAP_AXES if self.is_horizontal else MAP_AXES


def map_cells_table(values: DistanceMapValues) -> Table[tuple[float, ...]]:
    """Table of the cells of a map of distances, for spreadsheets."""
    across, up = values.axis_titles
    return Table(
        "",
        (
            Column(itemgetter(0), across, PLACE),
            Column(itemgetter(1), up, PLACE),
            Column(itemgetter(2), N_("Before (mm)"), CELL_DISTANCE),
            Column(itemgetter(3), N_("After (mm)"), CELL_DISTANCE),
        ),
    )


def map_cells(values: DistanceMapValues) -> list[tuple[float, ...]]:
    """Place and distances of each cell of a map."""
    return list(
        zip(values.across_m, values.up_m, values.before_m, values.after_m, strict=True)
    )  # fmt: skip
