"""Coverage of the sigmas of the angles if standard deviations are assumed, not given.

    python -m tests.studies.assumed_sigmas [SURVEYS]

simulates surveys with a LiDAR noise other than the assumed one and prints the coverage without an
estimate of the variance components and with the automatic one;
`tests/adjustment/test_assumed_sigmas.py` runs a short form.
"""

import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import (
    ASSUMED_ATTITUDE_SIGMA_DEG,
    ASSUMED_LIDAR_SIGMA,
    ASSUMED_POSITION_SIGMA,
)
from lispac.adjustment.result import SIGMA_GROUPS, SigmaGroup
from lispac.project import Settings
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from tests.studies.coverage_study import POINT_SPACING, PRIOR, TRUTH, ErrorsAndSigmas

TRUE_NOISE = (0.002, 0.005, 0.012)
"""True LiDAR noise, metres; 0.005 is also the assumed one."""
ASSUMED: tuple[tuple[SigmaGroup, ...], ...] = (("LiDAR",), SIGMA_GROUPS)
"""Groups with assumed sigmas; those of the other groups are the true ones."""
MODEL = Settings(lever_arm=(0.0, 0.0, 0.0)).stochastic_model


@dataclass(frozen=True, eq=False)
class AssumedSigmasResult:
    """Errors and sigmas of the angles, and the factors and sigmas found.

    Attributes
    ----------
    angles : ErrorsAndSigmas
    lidar : ndarray of shape (surveys,), metres
        LiDAR noise used.
    passed : float
        Share of the surveys whose chi-square test does not fail.
    """

    angles: ErrorsAndSigmas
    lidar: np.ndarray
    passed: float


def with_assumed_sigmas(survey: Observations, groups: tuple[SigmaGroup, ...]) -> Observations:
    """Survey with the assumed sigmas of some groups."""
    if "LiDAR" in groups:
        survey = replace(survey, sigma_lidar=np.full_like(survey.sigma_lidar, ASSUMED_LIDAR_SIGMA))
    if "POS position" in groups:
        position = np.tile(ASSUMED_POSITION_SIGMA, (len(survey), 1))
        survey = replace(survey, sigma_position=position)
    if "POS attitude" in groups:
        attitude = np.tile(np.radians(ASSUMED_ATTITUDE_SIGMA_DEG), (len(survey), 1))
        survey = replace(survey, sigma_attitude=attitude)
    return survey


def _one(
    noise: float, groups: tuple[SigmaGroup, ...], components: bool | None, seed: int
) -> tuple[np.ndarray, np.ndarray, float, bool]:
    generator = np.random.default_rng([2027, seed])
    exact = error_free_survey(
        TRUTH, THESIS_BOARDS, six_courses(), POINT_SPACING, generator, pos=HYDROGRAPHIC_INS,
        lidar_sigma=noise,
    )  # fmt: skip
    survey = with_assumed_sigmas(add_errors(exact, HYDROGRAPHIC_INS, generator), groups)
    points = average_points_in_cells(
        survey, PRIOR, 0.1, longest=MODEL.knot_interval, no_outliers=True
    )
    result = adjust(points, PRIOR, MODEL, components=components, assumed=groups, diagnostics=False)
    return (
        np.degrees(result.boresight - TRUTH.boresight), np.degrees(result.sigma),
        result.sigma_factors[0] * float(survey.sigma_lidar[0, 0]),
        result.chi_square.outcome != "failed",
    )  # fmt: skip


def study(
    noise: float, groups: tuple[SigmaGroup, ...], components: bool | None, surveys: int,
    workers: int = 2,
) -> AssumedSigmasResult:  # fmt: skip
    """Errors and sigmas of surveys with a true LiDAR noise, metres, and assumed sigmas."""
    arguments = (
        [noise] * surveys, [groups] * surveys, [components] * surveys, range(surveys),
    )  # fmt: skip
    if workers == 1:
        runs = list(map(_one, *arguments))
    else:
        with ProcessPoolExecutor(workers) as pool:
            runs = list(pool.map(_one, *arguments, chunksize=4))
    errors, sigmas, lidar, passed = map(np.array, zip(*runs, strict=True))
    return AssumedSigmasResult(ErrorsAndSigmas(errors, sigmas), lidar, float(passed.mean()))


def row(
    noise: float, groups: tuple[SigmaGroup, ...], components: bool | None, a: AssumedSigmasResult
) -> str:
    """Row of the table."""
    cells = [
        " ".join(f"{v:.4f}" for v in a.angles.rmse), " ".join(f"{v:.4f}" for v in a.angles.sigma),
        " ".join(f"{100 * v:5.1f}" for v in a.angles.hits), f"{1000 * a.lidar.mean():5.2f}",
        f"{100 * a.passed:4.0f}",
    ]  # fmt: skip
    name = "automatic" if components is None else "none"
    return f"{1000 * noise:4.0f}  {len(groups)}  {name:9s}  " + "   ".join(cells)


def main() -> None:
    """Print the table."""
    surveys = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    print(f"{surveys} surveys; roll, pitch, yaw; LiDAR 5 mm assumed")
    print("true groups components RMSE (deg)   sigma (deg)   95 %   LiDAR used (mm)   not failed %")
    for groups in ASSUMED:
        for noise in TRUE_NOISE:
            for components in (False, None):
                found = study(noise, groups, components, surveys)
                print(row(noise, groups, components, found), flush=True)


if __name__ == "__main__":
    main()
