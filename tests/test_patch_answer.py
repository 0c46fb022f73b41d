"""What is said of the answer of a patch test, by what it says in numbers."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.patchtest.answer import PatchTest
from lispac.patchtest.mismatch import SCALE
from lispac.patchtest.sigmas import FEWEST

SOUND = PatchTest(
    boresight=np.radians([1.0, 2.0, -1.0]),
    one_by_one=np.radians([1.0, 2.0, -1.0]),
    covariance=np.diag([1e-8, 4e-8, 9e-8]),
    curvature=np.ones(3),
    mismatch_before=0.2041,
    mismatch=0.0123,
    lines=("L1", "L2"),
    objects=(),
    rounds=4,
    settled=True,
)
WORDS = f"The mismatch (robust RMS distance between lines, at most {1000 * SCALE:.0f} mm)"
FIRST = "The answer rests on 0 objects and 2 lines."
FALL = f"{WORDS} falls from 204.1 mm with the prior boresight to 12.3 mm."


def test_of_a_sound_answer_nothing_more_is_said() -> None:
    assert SOUND.sentences == (FIRST, FALL)
    np.testing.assert_allclose(SOUND.sigma, [1e-4, 2e-4, 3e-4])


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            {"covariance": None},
            "A sigma cannot be stated: 0 objects are too few to tell how far the answer would "
            f"move with others; at least {FEWEST} are needed.",
        ),
        ({"settled": False}, "The angles still moved when the search ended."),
        (
            {"one_by_one": np.radians([1.005, 2.0, -1.05])},
            "Turned one after another, the angles end elsewhere: the yaw by 0.050 deg.",
        ),
        ({"unmet": ("mast", "wall")}, "No two of the lines meet at: mast and wall."),
    ],
)
def test_each_doubt_is_said(change: dict[str, object], said: str) -> None:
    assert replace(SOUND, **change).sentences == (FIRST, FALL, said)


def test_without_a_covariance_there_is_no_sigma() -> None:
    assert replace(SOUND, covariance=None).sigma is None


def test_lines_that_do_not_meet_with_the_prior_boresight_have_no_fall() -> None:
    assert replace(SOUND, mismatch_before=float("nan")).sentences == (
        FIRST, f"{WORDS} is 12.3 mm; with the prior boresight the lines do not meet there.",
    )  # fmt: skip
