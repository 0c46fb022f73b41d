"""Tests of the agreement of a single object with the result of a patch test."""

from types import SimpleNamespace

import numpy as np
import pytest

from lispac.patchtest.bootstrap_precision import (
    ObjectAgreement,
    _object_agreement,
    _ObjectEquations,
)


def agreement(stiff: float, gradient: float) -> ObjectAgreement:
    """Return the agreement of an object on one pair of lines, with equal stiffness per angle."""
    part = _ObjectEquations(
        "deck", [0], stiff * np.eye(3), np.full(3, gradient), {0: np.zeros((3, 6))}, np.full(3, 1.0)
    )
    mismatch = SimpleNamespace(blocks=[SimpleNamespace(pair=SimpleNamespace(name="1-2"))])
    found: ObjectAgreement = _object_agreement(
        part, mismatch, {0: 0}, np.ones((6, 1, 1)), np.array([0.04]), np.array([2.0])
    )  # type: ignore[arg-type]
    return found


def test_an_object_that_determines_no_angle_is_not_judged() -> None:
    """An object with little effect on the angles would seem to disagree by any amount."""
    found = agreement(stiff=1.0, gradient=50.0)
    assert found.angle is None
    assert not found.disagrees
    assert found.mismatch == pytest.approx(0.2)


def test_an_object_that_determines_angles_is_judged_by_its_disagreement() -> None:
    assert agreement(stiff=1000.0, gradient=1.0).angle == 0
    assert not agreement(stiff=1000.0, gradient=1.0).disagrees
    assert agreement(stiff=1000.0, gradient=50.0).disagrees
