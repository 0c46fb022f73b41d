"""Tests of units in the column names of georeferenced points."""

from pathlib import Path

import pytest

from lispac.io.formats import format_of
from lispac.io.point_reader_common import crs_of_options
from tests.support.message_codes import codes

TEXT = format_of("text")
SURVEY_FOOT = 1200 / 3937


@pytest.mark.parametrize(
    ("across", "up", "crs", "height", "has_warning"),
    [
        ("[ftUS]", "[ftUS]", "EPSG:3424", SURVEY_FOOT, False),
        ("[ft]", "[ft]", "EPSG:3424", SURVEY_FOOT, False),
        ("[ft]", "[m]", "EPSG:3424", 1.0, False),
        ("[m]", "[m]", "EPSG:3424", 1.0, True),
        ("", "", "EPSG:3424", SURVEY_FOOT, False),
        ("[m]", "(ft)", "EPSG:32618", 0.3048, False),
        ("[ft]", "[m]", "EPSG:32618", 1.0, True),
    ],
)
def test_column_names_specify_units(
    tmp_path: Path, across: str, up: str, crs: str, height: float, has_warning: bool
) -> None:
    path = tmp_path / "a.csv"
    rows = [f"{300 + k / 10},{6e5 + k},{6.4e5},{10 + k}" for k in range(20)]
    path.write_text("\n".join([f"time,Easting{across},Northing{across},Height{up}", *rows]))
    finding = TEXT.preview(path, {"crs": crs, "frame": "georeferenced"})
    resolved = TEXT.complete_options({**finding.choice, "crs": crs, "frame": "georeferenced"})
    system = crs_of_options(resolved)
    assert system is not None
    assert system.metres[2] == pytest.approx(height, rel=1e-12)
    assert ("points.unit_of_column" in codes(finding.file_warnings)) == has_warning
