"""Tests of the messages of a patch test result."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.model.parameters import mounting_value_name
from lispac.messages import Message, note
from lispac.patchtest.bootstrap_precision import MIN_OBJECTS
from lispac.patchtest.line_mismatch import LOSS_SCALE
from lispac.patchtest.patch_test_result import PatchTestResult

GOOD_RESULT = PatchTestResult(
    boresight=np.radians([1.0, 2.0, -1.0]),
    separate_boresight=np.radians([1.0, 2.0, -1.0]),
    covariance=np.diag([1e-8, 4e-8, 9e-8]),
    curvature=np.ones(3),
    mismatch_before=0.2041,
    mismatch=0.0123,
    lines=("L1", "L2"),
    objects=(),
    iterations=4,
    converged=True,
)
BASIS_NOTE = note("patch_test.basis", count=0, lines=2)
REDUCTION_NOTE = note("patch_test.mismatch_reduced", limit=LOSS_SCALE, before=0.2041, after=0.0123)


def test_a_good_result_has_no_further_notes() -> None:
    assert GOOD_RESULT.messages == (BASIS_NOTE, REDUCTION_NOTE)
    np.testing.assert_allclose(GOOD_RESULT.sigma, [1e-4, 2e-4, 3e-4])


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({"covariance": None}, note("patch_test.no_sigma", count=0, needed=MIN_OBJECTS)),
        ({"converged": False}, note("patch_test.not_converged")),
        (
            {"separate_boresight": np.radians([1.005, 2.0, -1.05])},
            note(
                "patch_test.order_matters",
                angle=mounting_value_name("yaw"), difference=pytest.approx(np.radians(0.05)),
            ),
        ),
        (
            {"objects_without_pairs": ("mast", "wall")},
            note("patch_test.not_met", objects=("mast", "wall")),
        ),
    ],
)  # fmt: skip
def test_each_limitation_adds_a_note(change: dict[str, object], expected: Message) -> None:
    *first, last = replace(GOOD_RESULT, **change).messages
    assert first == [BASIS_NOTE, REDUCTION_NOTE]
    assert (last.code, dict(last.params)) == (expected.code, dict(expected.params))


def test_without_a_covariance_there_is_no_sigma() -> None:
    assert replace(GOOD_RESULT, covariance=None).sigma is None


def test_without_a_mismatch_before_no_reduction_is_reported() -> None:
    mismatch = note("patch_test.mismatch", limit=LOSS_SCALE, after=0.0123)
    assert replace(GOOD_RESULT, mismatch_before=float("nan")).messages == (BASIS_NOTE, mismatch)
