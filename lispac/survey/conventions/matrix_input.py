"""Parse a matrix that is typed or pasted."""

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error
from lispac.survey.conventions.conversion import ConventionSetup, require_rotation

Array = NDArray[np.float64]


def matrix_of_text(text: str, where: str) -> tuple[Array, Array | None]:
    """The rotation in 9 or 16 numbers, row by row, and the lever arm of a 4x4 matrix.

    Brackets, commas, semicolons and what stands behind ``#`` are passed over.

    Parameters
    ----------
    where : str
        Name for error messages, for example the file.

    Returns
    -------
    rotation : ndarray of shape (3, 3)
    lever_arm : ndarray of shape (3,), metres, or None

    Raises
    ------
    InputError
        If there are not 9 or 16 numbers, or they are no rotation.
    """
    words = " ".join(line.partition("#")[0] for line in text.splitlines())
    for mark in ",;[]()":
        words = words.replace(mark, " ")
    words = words.replace("−", "-")
    numbers = np.array([_parse_number(word, where) for word in words.split()])
    if numbers.size not in (9, 16):
        raise InputError(error("survey.matrix_count", where=where, count=numbers.size))
    if numbers.size == 9:
        return require_rotation(numbers.reshape(3, 3)), None
    matrix = numbers.reshape(4, 4)
    if not np.array_equal(matrix[3], [0, 0, 0, 1]):
        raise InputError(error("survey.matrix_last_row", where=where))
    if not np.isfinite(matrix).all():
        raise InputError(error("survey.lever_arm_not_finite", where=where))
    return require_rotation(matrix[:3, :3]), matrix[:3, 3]


def _parse_number(word: str, where: str) -> float:
    try:
        return float(word)
    except ValueError:
        raise InputError(error("survey.matrix_not_numbers", where=where, word=word)) from None


def angle_product_of_matrix(setup: ConventionSetup, rotation: Array) -> Array:
    """Product of a system's angles from its scanner-to-body matrix, shape (3, 3), no unit.

    Parameters
    ----------
    rotation : ndarray of shape (3, 3)
        As in `MountingInSystem.transform`: from the scanner axes that a mounting keeps.

    Returns
    -------
    ndarray of shape (3, 3)
    """
    if setup.scanner_frame == "mounted":
        rotation = rotation @ setup.scanner_matrix().T
    return rotation if setup.convention.direction == "lidar_to_body" else rotation.T
