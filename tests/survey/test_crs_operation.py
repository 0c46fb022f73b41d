"""Tests of transformations between datums: none in PROJ, or only to a realization."""

import re

import numpy as np
import pytest
from pyproj import CRS, Transformer

from lispac.errors import InputError
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.survey.crs import coordinate_system
from tests.support.long_runs import others_long

ITRF = "EPSG:7912"


def refusal(text: str) -> Message:
    with pytest.raises(InputError) as refused:
        coordinate_system(text, trajectory_datum=ITRF)
    assert refused.value.message is not None
    return refused.value.message


@pytest.mark.parametrize(
    "text",
    others_long(
        ["EPSG:2949", "EPSG:2959", "EPSG:2949+6647", "EPSG:4617"],
        lambda text: text in ("EPSG:2949", "EPSG:2949+6647"),
    ),
)
def test_a_datum_ensemble_is_refused_with_its_realizations(text: str) -> None:
    message = refusal(text)
    compound = "+" in text
    assert message.code == ("crs.datum_ensemble_heights" if compound else "crs.datum_ensemble")
    codes = re.findall(
        r"(EPSG:\d+|urn:\S+) \((NAD83\(CSRS\)v\d[^)]*)", " ".join(message.params["systems"])
    )
    assert len(codes) == 2
    for code, name in codes:
        found = CRS.from_user_input(code)
        assert found.name == name
        # With the code named in the message and a date, the system can be used.
        coordinate_system(code, trajectory_datum=ITRF, epoch=2023.5)


def test_the_projection_is_the_same_on_a_named_realization() -> None:
    plain = coordinate_system("EPSG:2949")
    code = re.findall(r"urn:\S+", message_text(refusal("EPSG:2949")))[1]
    realized = coordinate_system(code)
    place = (np.radians([46.8]), np.radians([-71.2]), np.array([10.0]))
    np.testing.assert_allclose(
        realized.from_geodetic(*place), plain.from_geodetic(*place), atol=1e-6
    )


def test_the_shift_is_that_of_the_realization() -> None:
    """Reference: the PROJ pipeline from ITRF2014 to NAD83(CSRS)v7, then the projection."""
    code = re.findall(r"urn:\S+", message_text(refusal("EPSG:2949")))[1]
    shifted = coordinate_system(code, trajectory_datum=ITRF, epoch=2023.5)
    place = shifted.from_geodetic(np.radians([46.8]), np.radians([-71.2]), np.array([10.0]))[0]
    way = Transformer.from_crs(7912, 8254, always_xy=True)
    longitude, latitude, height, _ = way.transform(-71.2, 46.8, 10.0, 2023.5)
    east, north = Transformer.from_crs(4617, 2949, always_xy=True).transform(longitude, latitude)
    np.testing.assert_allclose(place, [east, north, height], rtol=0, atol=1e-4)


def test_without_a_transformation_no_grid_is_named() -> None:
    assert refusal("EPSG:2154").code == "crs.no_operation"


def test_a_missing_epoch_names_the_option() -> None:
    message = refusal("EPSG:22718")
    assert message.code == "crs.epoch_missing"
    assert "epoch=2024.5" in message_text(message)
