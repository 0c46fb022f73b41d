"""Coverage of the intervals of angles and lever-arm height with surveyed control.

    python -m tests.studies.control_coverage [SURVEYS]

simulates surveys with correlated POS errors and control on every board, and prints the share of
95 % intervals that contain the truth. The standard deviations are those of the model, without the
increase by the scatter of the results without parts of the data.
"""

import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.control import Control
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    Board,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))
MODEL = StochasticModel(
    position_time=HYDROGRAPHIC_INS.time_position, attitude_time=HYDROGRAPHIC_INS.time_attitude
)
BOARDS = (*THESIS_BOARDS, Board("T5", (4.0, 15.0, 3.0), (1.0, -2.0, 0.5)))
SINGLE_LINE_BOARDS = (*THESIS_BOARDS, Board("T5", (9.0, 13.0, -1.0), (1.0, -2.0, 0.5)))
"""Boards with control on which a single line determines all angles."""
SIGMA = 0.003
"""Standard deviation of the control, metres."""


@dataclass(frozen=True, eq=False)
class Coverage:
    """Share of intervals that contain the truth, and RMS of the errors in their sigmas.

    Attributes
    ----------
    hits, spread : ndarray of shape (4,)
        Of roll, pitch, yaw and the height of the lever arm; of a single line, the angles alone.
    sigma : ndarray of shape (4,), degrees and metres
        Mean standard deviations.
    """

    hits: np.ndarray
    spread: np.ndarray
    sigma: np.ndarray


def control_on(
    boards: tuple[Board, ...],
    *,
    generator: np.random.Generator | None = None,
    common: float = 0.0,
) -> Control:
    """Control in the four corners of each board, with errors if there is a generator.

    Parameters
    ----------
    common : float, metres
        Standard deviation of a translation of all control.
    """
    corners = np.array([[-0.5, -0.5, 0.5, 0.5], [-0.5, 0.5, -0.5, 0.5]])
    positions = np.concatenate([board.points_on_board(*corners) for board in boards])
    if generator is not None:
        positions = positions + SIGMA * generator.normal(size=positions.shape)
        positions += common * generator.normal(size=3)
    targets = [board.name for board in boards for _ in range(4)]
    return Control.of(
        [f"{board.name}-{k}" for board in boards for k in range(1, 5)], targets, positions,
        np.tile(SIGMA**2 * np.eye(3), (len(targets), 1, 1)), common_sigmas={"": common},
    )  # fmt: skip


def normalised_errors(
    seed: int, common: float, *, single_line: bool = False
) -> tuple[np.ndarray, np.ndarray]:
    """Errors of the angles and the lever-arm height in their sigmas, and the sigmas, (4,) each.

    Of a single line, the height of the lever arm is not estimated, and the arrays have 3 values.
    """
    generator = np.random.default_rng([seed, 40])
    boards, courses = BOARDS, six_courses()
    parameters: tuple[Parameter, ...] = (Parameter("lever_z"),)
    if single_line:
        boards, courses, parameters = SINGLE_LINE_BOARDS, six_courses()[:1], ()
    exact = error_free_survey(TRUTH, boards, courses, 0.1, generator)
    data = add_errors(exact, HYDROGRAPHIC_INS, generator)
    control = control_on(boards, generator=generator, common=common)
    result = adjust(
        replace(data, control=control), PRIOR, MODEL, parameters=parameters, diagnostics=False
    )
    errors = result.boresight - TRUTH.boresight
    if not single_line:
        errors = np.append(errors, result.mounting.lever_arm[2] - TRUTH.lever_arm[2])
    sigma = np.sqrt(np.diag(result.covariance_all))
    return errors / sigma, sigma


def study(
    count: int, *, common: float = 0.0, single_line: bool = False, workers: int | None = None
) -> Coverage:
    """Simulate surveys and count the intervals that contain the truth."""
    one = partial(normalised_errors, common=common, single_line=single_line)
    if workers == 1:
        found = [one(seed) for seed in range(count)]
    else:
        with ProcessPoolExecutor(workers) as pool:
            found = list(pool.map(one, range(count), chunksize=4))
    errors, sigmas = (np.array(column) for column in zip(*found, strict=True))
    mean = sigmas.mean(axis=0)
    mean[:3] = np.degrees(mean[:3])
    return Coverage((np.abs(errors) < 1.96).mean(axis=0), np.sqrt((errors**2).mean(axis=0)), mean)


if __name__ == "__main__":
    surveys = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    for shared in (0.0, 0.01):
        print(f"common sigma {shared} m", study(surveys, common=shared))
    print("single line, common sigma 0.005 m", study(surveys, common=0.005, single_line=True))
