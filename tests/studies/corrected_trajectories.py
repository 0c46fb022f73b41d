"""Corrected trajectories of simulated surveys with known POS errors.

    python -m tests.studies.corrected_trajectories [SURVEYS]

prints, for each correlation time: the share of the 95 % intervals of the corrections that contain
the true correction, and the ratio of the RMS error of points with the corrected trajectory to that
with the given one. Both are given within the sighted intervals and elsewhere.
`tests/adjustment/test_pos_corrections.py` runs a short form of it always and the long one on
request.
"""

import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.project import Settings
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    Board,
    error_free_survey,
    gauss_markov_drift,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import Poses

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))
POINT_SPACING = 0.05
CORRELATION_TIMES = ((300.0, 600.0), (3600.0, 3600.0), (30.0, 60.0))
TARGETS = (
    *THESIS_BOARDS,
    Board("T3", (4.0, 15.0, 3.0), (1.0, -2.0, 0.5)),
    Board("T4", (-5.0, 14.0, 7.0), (-1.0, -2.0, -0.5)),
)
"""Boards of several orientations, so that all components of the position are determined."""
TIMES = np.arange(-400.0, 1000.0, 2.5)
"""Times at which the corrections are compared; the lines are passed from 40 to 510 s."""
POINTS_LIDAR = np.array([[0.0, 15.0, 5.0], [0.0, 12.0, -2.0], [0.0, 40.0, 10.0]])
"""Points whose errors are compared at each time, metres, LiDAR frame."""


@dataclass(frozen=True, eq=False)
class Corrected:
    """Corrections of one survey at `TIMES`, their errors, and errors of points.

    Attributes
    ----------
    error, sigma : ndarray of shape (times, 6), metres and radians
        Estimated less true correction, and its standard deviation.
    sighted : ndarray of shape (times,), bool
    determined : ndarray of shape (6,), bool
    before, after : ndarray of shape (times, points), metres
        Distances of points from their true places with the given and the corrected trajectory,
        both with the estimated boresight.
    """

    error: np.ndarray
    sigma: np.ndarray
    sighted: np.ndarray
    determined: np.ndarray
    before: np.ndarray
    after: np.ndarray

    @property
    def hits(self) -> np.ndarray:
        """Whether the 95 % intervals contain the true corrections, shape (times, 6)."""
        return np.abs(self.error) < 1.96 * self.sigma


def corrected(times: tuple[float, float], seed: int) -> Corrected:
    """Simulate and adjust a survey, and compare its corrections with the true ones."""
    pos = replace(HYDROGRAPHIC_INS, time_position=times[0], time_attitude=times[1])
    generator = np.random.default_rng([404, seed])
    exact = error_free_survey(TRUTH, TARGETS, six_courses(), POINT_SPACING, generator, pos=pos)
    every = np.concatenate([exact.time, TIMES])
    sigmas = np.array([*pos.sigma_position, *pos.sigma_attitude])
    errors = sigmas * np.hstack([gauss_markov_drift(every, time, generator) for time in times])
    noise = exact.sigma_lidar * generator.standard_normal(exact.points_lidar.shape)
    count = len(exact)
    data = replace(
        exact,
        points_lidar=exact.points_lidar + noise,
        position=exact.position + errors[:count, :3],
        attitude=exact.attitude + errors[:count, 3:],
    )
    settings = Settings(lever_arm=(0.0, 0.0, 0.0), position_time=times[0], attitude_time=times[1])
    model = settings.stochastic_model
    points = average_points_in_cells(data, PRIOR, 0.1, longest=model.knot_interval)
    result = adjust(points, PRIOR, model)
    assert result.pos_corrections is not None
    found = result.pos_corrections.at(TIMES, np.tile(sigmas, (len(TIMES), 1)))
    true = -errors[count:]
    heading = np.radians(37.0)
    pose = np.array([0.0, 0.0, 0.0, 0.0, 0.0, heading]) + np.zeros((len(TIMES), 1))

    def places(off: np.ndarray, mounting: Mounting) -> np.ndarray:
        return np.stack(
            [
                place_points(
                    np.tile(point, (len(TIMES), 1)),
                    Poses((pose + off)[:, :3], (pose + off)[:, 3:]),
                    mounting,
                )
                for point in POINTS_LIDAR
            ],
            axis=1,
        )

    truth = places(np.zeros_like(pose), TRUTH)
    before, after = (
        np.linalg.norm(places(off, result.mounting) - truth, axis=2)
        for off in (errors[count:], errors[count:] + found.correction)
    )
    return Corrected(
        found.correction - true,
        found.sigma,
        found.sighted,
        result.pos_corrections.determined,
        before,
        after,
    )


def study(times: tuple[float, float], surveys: int, workers: int = 2) -> list[Corrected]:
    """Corrections of several surveys."""
    if workers == 1:
        return [corrected(times, seed) for seed in range(surveys)]
    with ProcessPoolExecutor(workers) as pool:
        return list(pool.map(corrected, [times] * surveys, range(surveys), chunksize=4))


def hits(results: list[Corrected], *, sighted: bool) -> np.ndarray:
    """Share of the 95 % intervals that contain the true correction, shape (6,)."""
    return np.concatenate([each.hits[each.sighted == sighted] for each in results]).mean(axis=0)


def rms_ratio(results: list[Corrected], *, sighted: bool) -> float:
    """RMS error of the points with the corrected trajectory, divided by that with the given one."""
    squares = [
        [(errors[each.sighted == sighted] ** 2).mean() for errors in (each.before, each.after)]
        for each in results
    ]
    before, after = np.mean(squares, axis=0)
    return float(np.sqrt(after / before))


def main() -> None:
    """Print the whole study."""
    surveys = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    print(f"{surveys} surveys a row; coverage in per cent: north west up roll pitch heading")
    for times in CORRELATION_TIMES:
        results = study(times, surveys)
        for sighted in (True, False):
            shares = " ".join(f"{100 * share:5.1f}" for share in hits(results, sighted=sighted))
            ratios = [rms_ratio([each], sighted=sighted) for each in results]
            print(
                f"{times[0]:5g} s {times[1]:5g} s  {'sighted' if sighted else 'elsewhere':9s}  "
                f"{shares}   RMS ratio {rms_ratio(results, sighted=sighted):.3f}, "
                f"below 1 in {100 * np.mean(np.array(ratios) < 1):.0f} % of the surveys",
                flush=True,
            )


if __name__ == "__main__":
    main()
