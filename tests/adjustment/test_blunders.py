"""Tests of the classification of blunders: shifted sighting or other surface."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.target_shapes import fit_shapes
from lispac.adjustment.solve import sighting_rejection
from lispac.adjustment.solve.blunders import Blunder
from lispac.geometry.planes import plane_axes
from lispac.survey.georeferencing import place_points
from lispac.survey.trajectory import Poses
from tests.adjustment.test_robustness import PRIOR, TRUTH, shifted, survey


def turned(clean: Observations, sighting: int, degrees: float) -> Observations:
    """Rotate one sighting about an axis in the plane of its target, through its centre."""
    own = clean.sighting == sighting
    normal = fit_shapes(clean, TRUTH)[clean.target_of_sighting[sighting], :3]
    level = plane_axes(normal)[0]
    poses = Poses(clean.position[own], clean.attitude[own])
    across = place_points(clean.points_lidar[own], poses, TRUTH) @ level
    position = clean.position.copy()
    position[own] += np.outer((across - across.mean()) * np.radians(degrees), normal)
    return replace(clean, position=position)


@pytest.mark.parametrize(("change", "kind"), [(turned, "surface"), (shifted, "shift")])
def test_a_blunder_has_the_right_kind(change, kind, monkeypatch: pytest.MonkeyPatch) -> None:
    blunders: list[Blunder | None] = []
    worst = sighting_rejection.worst_blunder

    def find(*arguments: object) -> Blunder | None:
        blunders.append(worst(*arguments))  # type: ignore[arg-type]
        return blunders[-1]

    monkeypatch.setattr(sighting_rejection, "worst_blunder", find)
    amount = 3.0 if kind == "surface" else 0.1
    found = adjust(change(survey(24, 0.1), 4, amount), PRIOR, StochasticModel(loss="tukey"))
    first = blunders[0]
    assert first is not None
    assert (first.kind, first.sightings) == (kind, (4,))
    assert survey(24, 0.1).sightings[4] in found.rejected_sightings


def test_variance_factors_follow_from_the_remaining_sightings() -> None:
    """Position sigmas two and a half times too small, and one sighting displaced by 10 cm."""
    scaled = shifted(survey(24, 0.1), 4, 0.1).with_scaled_sigmas(1.0, 0.4, 1.0)
    model = StochasticModel(loss="tukey")
    found = adjust(scaled, PRIOR, model, components=True)
    assert [scaled.sightings.index(each) for each in found.rejected_sightings] == [4]
    position = found.components[1]
    assert position.lower < 2.5 < position.upper
