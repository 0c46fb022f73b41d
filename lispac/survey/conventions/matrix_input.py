"""Parser of a matrix that is typed or pasted."""

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error
from lispac.survey.conventions.conversion import ConventionSetup, require_rotation

Array = NDArray[np.float64]


def matrix_of_text(text: str, where: str) -> tuple[Array, Array | None]:
    """Rotation and lever arm from a text with the 9 or 16 numbers of a matrix, row by row.

    Brackets, commas, semicolons, and text after ``#`` are ignored.

    Parameters
    ----------
    where : str
        Name for error messages, for example the file.

    Returns
    -------
    rotation : ndarray of shape (3, 3)
    lever_arm : ndarray of shape (3,), metres; None for a 3x3 matrix

    Raises
    ------
    InputError
        If the text does not contain 9 or 16 numbers, or they are not a rotation.
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
        Rotation of `MountingInSystem.transform`.

    Returns
    -------
    ndarray of shape (3, 3)
    """
    if setup.scanner_frame == "mounted":
        rotation = rotation @ setup.scanner_matrix().T
    return rotation if setup.convention.direction == "lidar_to_body" else rotation.T
