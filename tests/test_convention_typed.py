"""A matrix as it is typed or pasted."""

import re

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.geometry.rotations import rotation_matrix
from lispac.survey.conventions.typed import matrix_of_text

ROTATION = rotation_matrix(*np.radians([1.0, -2.0, 80.0]))
LEVER_ARM = np.array([-0.19, 0.04, 2.42])
WHOLE = np.vstack([np.column_stack([ROTATION, LEVER_ARM]), [0, 0, 0, 1]])


def rows(matrix: np.ndarray, between: str = " ", end: str = "\n") -> str:
    return end.join(between.join(repr(float(number)) for number in row) for row in matrix)


@pytest.mark.parametrize(
    "text",
    [
        rows(ROTATION),
        rows(ROTATION, ", ", ";"),
        "[" + rows(ROTATION, ",", "],\n[") + "]",
        "# from 3 lines\n(" + rows(ROTATION, "  ") + ") # scanner to body 4 5",
        rows(ROTATION).replace("-", "−"),  # of a word processor
    ],
)
def test_a_rotation_is_read_however_its_rows_are_parted(text: str) -> None:
    found, lever_arm = matrix_of_text(text, "pasted")
    np.testing.assert_allclose(found, ROTATION, rtol=0, atol=1e-15)
    assert lever_arm is None


def test_a_whole_matrix_has_the_lever_arm_in_its_last_column() -> None:
    found, lever_arm = matrix_of_text(rows(WHOLE), "pasted")
    np.testing.assert_allclose(found, ROTATION, rtol=0, atol=1e-15)
    np.testing.assert_array_equal(lever_arm, LEVER_ARM)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "1 0 0 zero",
            "could not convert string to float: 'zero'; give a matrix of 3x3 or 4x4 numbers.",
        ),
        ("1 0 0 1", "4 numbers are no 3x3 or 4x4 matrix; give 9 or 16."),
        (
            rows(WHOLE.T),
            "the last row of a 4x4 matrix is 0 0 0 1; give rows, not columns.",
        ),
        (
            rows(WHOLE).replace("2.42", "nan"),
            "a number of the lever arm is not finite; correct it.",
        ),
    ],
)
def test_what_is_no_matrix_is_refused(text: str, said: str) -> None:
    with pytest.raises(InputError) as refused:
        matrix_of_text(text, "m.txt")
    assert str(refused.value) == f"m.txt: {said}"
    with pytest.raises(InputError, match=re.escape("not a rotation")):
        matrix_of_text("2 0 0 0 2 0 0 0 2", "m.txt")
