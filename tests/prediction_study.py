"""Are the foretold sigmas those of many simulated surveys?

    python -m tests.prediction_study [SURVEYS]

Every survey has all points the scanner would measure, boards that lie off their shape, LiDAR noise
and POS errors that drift, on a rolling vessel; it is adjusted like any other. Nothing of it comes
from `lispac.simulation.prediction` but how many points a sighting has.
"""

import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass

import numpy as np

from lispac.adjustment.observations import Observations, Sighting
from lispac.adjustment.solver import adjust
from lispac.adjustment.stochastic import StochasticModel
from lispac.simulation.closed_form import Board, Sea, abeam, drift
from lispac.simulation.plan import Plan, pattern
from lispac.simulation.prediction import count_of_points, predict
from lispac.survey.georeferencing import Mounting, to_lidar
from lispac.survey.trajectory import Poses

BOARDS = (
    Board("T1", (0.8, -15.0, 5.0), (0.0, 1.0, 0.0)),
    Board("T2", (-0.8, -15.0, 5.0), (0.0, 1.0, 1.0)),
)
PLAN = Plan(BOARDS, pattern(), (0.0, -15.0, 5.0))


def survey(
    plan: Plan, generator: np.random.Generator, *, errors: float = 1.0, sea: float = 1.0
) -> Observations:
    """One survey as it could come out, or with errors or sea so many times as large."""
    system, rows, sightings = plan.system, [], []
    waves = Sea.draw(generator)
    for target in plan.targets:
        assert isinstance(target, Board)
        for course in plan.courses:
            count = count_of_points(system, target, course, abeam(system.mounting, target, course))
            if count < 1:
                continue
            # One in each field of an even grid, as a scanner lays them
            side = round(np.sqrt(count))
            fields = np.stack(np.divmod(np.arange(side**2), side))
            u, v = (fields + generator.uniform(0, 1, fields.shape)) / side - 0.5
            points = target._placed(u * target.width, v * target.height)
            along = (points - [*course.abeam, 0.0]) @ course.direction
            along -= system.mounting.lever_arm[0]
            time = course.time + along / course.speed
            motion = sea * waves.at(time)
            position = along[:, None] * course.direction + motion[:, :3]
            position[:, :2] += course.abeam
            attitude = motion[:, 3:] + [0.0, 0.0, course.heading]
            # Its borders lifted and the whole set off, for this line alone
            tilts = errors * generator.standard_normal(3) * plan.flatness
            bent = 2 * u * tilts[0] + 2 * v * tilts[1] + tilts[2]
            points = points + bent[:, None] * target.facing
            scan = to_lidar(points, Poses(position, attitude), system.mounting)
            rows.append(np.column_stack([scan, position, attitude, time]))
            sightings.append(Sighting(target.name, course.name))
    table = np.concatenate(rows)
    scan, position, attitude, time = table[:, :3], table[:, 3:6], table[:, 6:9], table[:, 9].copy()
    ranges = np.linalg.norm(scan, axis=1)[:, None]
    beam = scan / ranges
    noise = generator.standard_normal(scan.shape) * system.scanner.angle_sigma * ranges
    along_beam = np.einsum("ni,ni->n", noise, beam)[:, None]
    noise += (
        generator.standard_normal(ranges.shape) * system.scanner.range_sigma - along_beam
    ) * beam
    pos, count = system.pos, len(table)
    drifted = [
        errors * np.array(sigma) * drift(time, correlation_time, generator)
        for sigma, correlation_time in (
            (pos.sigma_position, pos.time_position),
            (pos.sigma_attitude, pos.time_attitude),
        )
    ]
    across = system.scanner.angle_sigma * ranges
    return Observations(
        points_lidar=scan + errors * noise,
        position=position + drifted[0],
        attitude=attitude + drifted[1],
        sigma_lidar=np.hstack([np.full((count, 1), system.scanner.range_sigma), across, across]),
        sigma_position=np.tile(pos.sigma_position, (count, 1)),
        sigma_attitude=np.tile(pos.sigma_attitude, (count, 1)),
        time=time,
        sighting=np.repeat(np.arange(len(sightings)), [len(part) for part in rows]),
        sightings=tuple(sightings),
        beam_sigmas=True,
    )


@dataclass(frozen=True, eq=False)
class Compared:
    """Standard deviations of many answers, and what was foretold, degrees, shape (3,)."""

    surveys: int
    empirical: np.ndarray
    stated: np.ndarray
    foretold: np.ndarray


def _one(plan: Plan, surface: float | None, seed: int) -> tuple[np.ndarray, np.ndarray]:
    observations = survey(plan, np.random.default_rng([2027, seed]))
    pos = plan.system.pos
    model = StochasticModel("correlated", pos.time_position, pos.time_attitude, surface)
    prior = Mounting(plan.system.mounting.lever_arm, np.zeros(3))
    result = adjust(observations, prior, model, diagnostics=False)
    return result.boresight - plan.system.mounting.boresight, result.sigma


def compared(plan: Plan, surveys: int, *, stated: bool, workers: int = 2) -> Compared:
    """Many surveys of a plan; ``stated``: the adjustment is told how flat the boards are."""
    surface = plan.flatness if stated else None
    arguments = ([plan] * surveys, [surface] * surveys, range(surveys))
    if workers == 1:
        runs = list(map(_one, *arguments))
    else:
        with ProcessPoolExecutor(workers) as pool:
            runs = list(pool.map(_one, *arguments, chunksize=4))
    errors, sigmas = np.degrees(np.array(runs)).transpose(1, 0, 2)
    return Compared(
        surveys,
        np.sqrt((errors**2).mean(axis=0)),
        sigmas.mean(axis=0),
        np.degrees(predict(plan).sigma),
    )


def printed(found: Compared) -> str:
    """The comparison in three lines."""
    rows = {
        "empirical": found.empirical, "stated": found.stated, "foretold": found.foretold,
        "empirical / foretold": found.empirical / found.foretold,
    }  # fmt: skip
    lines = [f"{found.surveys} surveys: roll, pitch, yaw (deg)"]
    lines += [f"{name:22s}" + "".join(f"{v:9.4f}" for v in row) for name, row in rows.items()]
    return "\n".join(lines)


if __name__ == "__main__":
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    for told in (True, False):
        print("flatness stated" if told else "flatness from the data")
        print(printed(compared(PLAN, number, stated=told)))
