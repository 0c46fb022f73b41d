"""Coverage of the sigmas of both stochastic models in simulated surveys with known truth.

    python -m tests.studies.coverage_study [SURVEYS]

prints the table for each correlation time and subsampling distance;
`tests/adjustment/test_coverage.py` runs a short form of it always and the long one on request.
"""

import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.target_shapes import points_local
from lispac.project import Settings
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting
from lispac.targets.thinning import thin_points

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))
POINT_SPACING = 0.02  # metres between the points of the scanner
CORRELATION_TIMES = ((300.0, 600.0), (3600.0, 3600.0), (5.0, 5.0))
DISTANCES = (0.02, 0.05, 0.10, 0.20)
SUBSAMPLED_SURVEYS = 20
"""Number of surveys for the effect of subsampling on the sigmas. Each is compared with itself, so
that few surveys are sufficient; `sigma_ratios` returns the standard error."""


@dataclass(frozen=True, eq=False)
class ErrorsAndSigmas:
    """Errors and estimated sigmas of many surveys, each of shape (surveys, 3), degrees."""

    errors: np.ndarray
    sigmas: np.ndarray

    @property
    def ratios(self) -> np.ndarray:
        """Error over sigma."""
        return self.errors / self.sigmas

    @property
    def hits(self) -> np.ndarray:
        """Share of the 95 % intervals that contain the truth."""
        return (np.abs(self.ratios) < 1.96).mean(axis=0)

    @property
    def spread(self) -> np.ndarray:
        """Root mean square of error over sigma."""
        return np.sqrt((self.ratios**2).mean(axis=0))

    @property
    def rmse(self) -> np.ndarray:
        """Root mean square error, degrees."""
        return np.sqrt((self.errors**2).mean(axis=0))

    @property
    def sigma(self) -> np.ndarray:
        """Mean estimated sigma, degrees."""
        return self.sigmas.mean(axis=0)


def models(times: tuple[float, float]) -> dict[str, StochasticModel]:
    """Default model of the program, and uncorrelated POS errors (classical)."""
    settings = Settings(lever_arm=(0.0, 0.0, 0.0), position_time=times[0], attitude_time=times[1])
    return {
        "correlated": settings.stochastic_model,
        "independent": replace(settings, pos_errors="independent").stochastic_model,
    }


def thinned_per_cube(survey: Observations, distance: float) -> Observations:
    """Thin the points of each sighting to one per cube, as for uncorrelated POS errors."""
    places = points_local(survey, PRIOR)
    own = [np.flatnonzero(survey.sighting == k) for k in range(len(survey.sightings))]
    return survey.reordered(np.concatenate([i[thin_points(places[i], distance)] for i in own]))


def _one(
    times: tuple[float, float], distances: tuple[float, ...], seed: int
) -> list[tuple[np.ndarray, np.ndarray]]:
    pos = replace(HYDROGRAPHIC_INS, time_position=times[0], time_attitude=times[1])
    generator = np.random.default_rng([2026, seed])
    exact = error_free_survey(
        TRUTH, THESIS_BOARDS, six_courses(), POINT_SPACING, generator, pos=pos
    )
    survey = add_errors(exact, pos, generator)
    found = []
    for distance in distances:
        for model in models(times).values():
            if model.correlated:
                points = average_points_in_cells(
                    survey, PRIOR, distance, longest=model.knot_interval, no_outliers=True
                )
            else:
                points = thinned_per_cube(survey, distance)
            result = adjust(points, PRIOR, model, diagnostics=False)
            error = np.degrees(result.boresight - TRUTH.boresight)
            found.append((error, np.degrees(result.sigma)))
    return found


def study(
    times: tuple[float, float], distances: tuple[float, ...], surveys: int, workers: int = 2
) -> dict[tuple[str, float], ErrorsAndSigmas]:
    """Errors and sigmas by model and subsampling distance."""
    arguments = ([times] * surveys, [distances] * surveys, range(surveys))
    if workers == 1:
        runs = list(map(_one, *arguments))
    else:
        with ProcessPoolExecutor(workers) as pool:
            runs = list(pool.map(_one, *arguments, chunksize=4))
    table = np.array(runs)  # surveys, distances x models, error and sigma, angles
    keys = [(name, distance) for distance in distances for name in models(times)]
    return {key: ErrorsAndSigmas(table[:, k, 0], table[:, k, 1]) for k, key in enumerate(keys)}


def sigma_ratios(
    results: dict[tuple[str, float], ErrorsAndSigmas],
) -> tuple[np.ndarray, np.ndarray]:
    """Ratios of sigmas of the correlated model to those at the smallest distance.

    Returns
    -------
    ratio, standard_error : ndarray of shape (distances, 3)
    """
    sigmas = [a.sigmas for (name, _), a in results.items() if name == "correlated"]
    ratios = np.array([each / sigmas[0] for each in sigmas])
    return ratios.mean(axis=1), ratios.std(axis=1, ddof=1) / np.sqrt(ratios.shape[1])


def table_text(
    times: tuple[float, float], results: dict[tuple[str, float], ErrorsAndSigmas]
) -> str:
    """The table of one pair of correlation times."""
    count = len(next(iter(results.values())).errors)
    lines = [
        f"correlation times {times[0]:g} s, {times[1]:g} s; {count} surveys; roll, pitch, yaw",
        "  cm  model         RMSE (deg)              sigma (deg)             sd(e/s)           95%",
    ]
    for (name, distance), a in results.items():
        cells = [" ".join(f"{v:.4f}" for v in a.rmse), " ".join(f"{v:.4f}" for v in a.sigma)]
        cells.append(" ".join(f"{v:5.2f}" for v in a.spread))
        cells.append(" ".join(f"{100 * v:5.1f}" for v in a.hits))
        lines.append(f"{100 * distance:4.0f}  {name:12s}  " + "   ".join(cells))
    return "\n".join(lines)


def main() -> None:
    """Print the whole study."""
    surveys = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    for times in CORRELATION_TIMES:
        print(table_text(times, study(times, (0.10,), surveys)), flush=True)
    for times in CORRELATION_TIMES:
        results = study(times, DISTANCES, min(SUBSAMPLED_SURVEYS, max(surveys, 2)))
        print(table_text(times, results))
        print("sigma by that at the first, +-", *sigma_ratios(results), sep="\n", flush=True)


if __name__ == "__main__":
    main()
