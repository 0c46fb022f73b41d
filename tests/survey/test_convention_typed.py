"""Tests of reading a matrix that is typed or pasted."""

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.geometry.rotations import rotation_matrix
from lispac.survey.conventions.matrix_input import matrix_of_text
from tests.support.error_codes import has_code

ROTATION = rotation_matrix(*np.radians([1.0, -2.0, 80.0]))
LEVER_ARM = np.array([-0.19, 0.04, 2.42])
TRANSFORM = np.vstack([np.column_stack([ROTATION, LEVER_ARM]), [0, 0, 0, 1]])


def rows(matrix: np.ndarray, between: str = " ", end: str = "\n") -> str:
    return end.join(between.join(repr(float(number)) for number in row) for row in matrix)


@pytest.mark.parametrize(
    "text",
    [
        rows(ROTATION),
        rows(ROTATION, ", ", ";"),
        "[" + rows(ROTATION, ",", "],\n[") + "]",
        "# from 3 lines\n(" + rows(ROTATION, "  ") + ") # scanner to body 4 5",
        rows(ROTATION).replace("-", "−"),  # minus sign of a word processor
    ],
)
def test_a_rotation_is_read_with_any_separator(text: str) -> None:
    found, lever_arm = matrix_of_text(text, "pasted")
    np.testing.assert_allclose(found, ROTATION, rtol=0, atol=1e-15)
    assert lever_arm is None


def test_a_4x4_matrix_has_the_lever_arm_in_its_last_column() -> None:
    found, lever_arm = matrix_of_text(rows(TRANSFORM), "pasted")
    np.testing.assert_allclose(found, ROTATION, rtol=0, atol=1e-15)
    np.testing.assert_array_equal(lever_arm, LEVER_ARM)


@pytest.mark.parametrize(
    ("text", "code", "params"),
    [
        ("1 0 0 zero", "survey.matrix_not_numbers", {"word": "zero"}),
        ("1 0 0 1", "survey.matrix_count", {"count": 4}),
        (rows(TRANSFORM.T), "survey.matrix_last_row", {}),
        (rows(TRANSFORM).replace("2.42", "nan"), "survey.lever_arm_not_finite", {}),
    ],
)
def test_invalid_matrix_texts_are_refused(text: str, code: str, params: dict[str, object]) -> None:
    with pytest.raises(InputError, check=has_code(code, where="m.txt", **params)):
        matrix_of_text(text, "m.txt")
    with pytest.raises(InputError, check=has_code("survey.not_a_rotation")):
        matrix_of_text("2 0 0 0 2 0 0 0 2", "m.txt")
