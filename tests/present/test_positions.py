"""Tests of positions in tables: east, north, up."""

import pytest

from lispac.geometry.frames import LocalFrame, east_north_up, north_west_up
from lispac.present.survey.survey_data import PickedPlane, planes_table
from lispac.present.tables import Column, cell_text, title_text
from lispac.present.targets.sighting_quality import (
    PICKED_SPHERES_TABLE,
    PickedSightingValues,
    SightingQualityValues,
)
from lispac.present.targets.surface_geometry import SurfaceGeometryValues
from tests.support.topocentric import east_north_up_by_proj

FRAME = LocalFrame(0.81, -1.24, 12.0)
PLACE = (1.15, -14.7, 8.11)


def cells(columns: tuple[Column, ...], row: object) -> dict[str, str]:
    return {title_text(column.title).split()[0]: cell_text(column, row) for column in columns}


def test_tables_give_positions_as_proj_does() -> None:
    east, north, up = east_north_up_by_proj(PLACE, FRAME)[0]
    plane = PickedPlane(
        "T1", "target", "plane", None, True, (0.0, 0.0, 0.0), 0.01, 2.0, ("L1",), (), {},
        SurfaceGeometryValues(PLACE, (1.2, 0.8), 45.0, 90.0),
    )  # fmt: skip
    found = cells(planes_table(1).columns, plane)
    assert [found[name] for name in ("East", "North", "Up")] == [
        f"{value:.2f}" for value in (east, north, up)
    ]
    quality = SightingQualityValues(**dict.fromkeys(SightingQualityValues.__dataclass_fields__))
    sphere = PickedSightingValues(50, 0.002, quality, PLACE, 0.1, 0.4)
    columns = PICKED_SPHERES_TABLE.columns[1:4]
    assert cells(columns, sphere) == {
        "East": f"{east:.3f}", "North": f"{north:.3f}", "Up": f"{up:.3f}"
    }  # fmt: skip


def test_positions_are_converted_back_without_loss() -> None:
    assert north_west_up(east_north_up(PLACE)) == pytest.approx(PLACE, abs=0.0)
    assert str(east_north_up((2.0, 0.0, 1.0))[0]) == "0.0"
    assert str(north_west_up((0.0, 2.0, 1.0))[1]) == "0.0"
