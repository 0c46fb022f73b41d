"""What is said of the answer of a patch test, by what it says in numbers."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.model.parameters import mounting_value_name
from lispac.messages import Message, note
from lispac.patchtest.bootstrap_precision import MIN_OBJECTS
from lispac.patchtest.line_mismatch import LOSS_SCALE
from lispac.patchtest.patch_test_result import PatchTestResult

SOUND = PatchTestResult(
    boresight=np.radians([1.0, 2.0, -1.0]),
    one_by_one=np.radians([1.0, 2.0, -1.0]),
    covariance=np.diag([1e-8, 4e-8, 9e-8]),
    curvature=np.ones(3),
    mismatch_before=0.2041,
    mismatch=0.0123,
    lines=("L1", "L2"),
    objects=(),
    rounds=4,
    converged=True,
)
FIRST = note("patch_test.basis", count=0, lines=2)
FALL = note("patch_test.mismatch_reduced", limit=LOSS_SCALE, before=0.2041, after=0.0123)


def test_a_sound_result_has_no_further_notes() -> None:
    assert SOUND.messages == (FIRST, FALL)
    np.testing.assert_allclose(SOUND.sigma, [1e-4, 2e-4, 3e-4])


@pytest.mark.parametrize(
    ("change", "remark"),
    [
        ({"covariance": None}, note("patch_test.no_sigma", count=0, needed=MIN_OBJECTS)),
        ({"converged": False}, note("patch_test.not_converged")),
        (
            {"one_by_one": np.radians([1.005, 2.0, -1.05])},
            note(
                "patch_test.order_matters",
                angle=mounting_value_name("yaw"), difference=pytest.approx(np.radians(0.05)),
            ),
        ),
        ({"without_pairs": ("mast", "wall")}, note("patch_test.not_met", objects=("mast", "wall"))),
    ],
)  # fmt: skip
def test_each_limit_is_a_note(change: dict[str, object], remark: Message) -> None:
    *first, last = replace(SOUND, **change).messages
    assert first == [FIRST, FALL]
    assert (last.code, dict(last.params)) == (remark.code, dict(remark.params))


def test_without_a_covariance_there_is_no_sigma() -> None:
    assert replace(SOUND, covariance=None).sigma is None


def test_lines_that_do_not_meet_with_the_prior_boresight_have_no_fall() -> None:
    mismatch = note("patch_test.mismatch", limit=LOSS_SCALE, after=0.0123)
    assert replace(SOUND, mismatch_before=float("nan")).messages == (FIRST, mismatch)
