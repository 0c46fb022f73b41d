"""Coverage of the sigmas with errors that the stochastic model does not contain.

    python -m tests.studies.coverage_of_errors [SURVEYS] [KIND ...]

simulates surveys with known truth and prints a row for each kind of error: the share of 95 %
intervals that contain the truth, for each angle, with the formal sigmas and with the reported ones;
the share of angles with an increased sigma; the share of surveys with a serious warning; and the
share of intervals that contain the truth in the surveys without one.
"""

import sys
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.geometry.rotations import rotation_matrix
from lispac.project import Settings
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    Board,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import Poses

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))
POINT_SPACING = 0.03
MODEL = Settings(lever_arm=(0.0, 0.0, 0.0)).stochastic_model
TARGETS = (
    *THESIS_BOARDS,
    Board("T5", (4.0, 15.0, 3.0), (1.0, -2.0, 0.5)),
    Board("T6", (-5.0, 14.0, 7.0), (-1.0, -2.0, -0.5)),
)
Change = Callable[[Observations, np.random.Generator], Observations]


def _along_beams(data: Observations, off: np.ndarray) -> Observations:
    """Move points along their beams by ``off`` (n,), metres."""
    beams = data.points_lidar / np.linalg.norm(data.points_lidar, axis=1)[:, None]
    return replace(data, points_lidar=data.points_lidar + off[:, None] * beams)


def _of_line(data: Observations, chance: np.random.Generator) -> np.ndarray:
    line = data.lines[chance.integers(len(data.lines))]
    return np.array([each.line == line for each in data.sightings])[data.sighting]


def curved(data: Observations, chance: np.random.Generator) -> Observations:
    """Boards bent by some 10 mm; each line shows another three fifths of their height.

    All lines show the same bent surface: points move along their beams according to the distance
    of the board from its plane along the normal.
    """
    boards = {each.name: each for each in TARGETS}
    poses = Poses(data.position, data.attitude)
    near = place_points(data.points_lidar, poses, TRUTH)
    beams = place_points(1.1 * data.points_lidar, poses, TRUTH) - near
    beams /= np.linalg.norm(beams, axis=1)[:, None]
    off, is_curved = np.zeros(len(data)), np.zeros(len(data), dtype=bool)
    bends = {name: chance.normal(0, 0.01) for name in boards}
    for k, sighting in enumerate(data.sightings):
        board, own = boards[sighting.target], data.sighting == k
        normal = board.facing
        up = np.cross(np.cross(normal, [0.0, 0.0, 1.0]), normal)
        height = (near[own] - board.centre) @ (up / np.linalg.norm(up)) / board.height
        bend = bends[board.name] * 4 * height**2
        off[own] = bend / (beams[own] @ normal)
        first = chance.uniform(-0.5, -0.1)
        is_curved[own] = (height >= first) & (height <= first + 0.6)
    return _along_beams(data, off).where(is_curved)


def displaced_target(data: Observations, target: str, size: float) -> Observations:
    """Move a target along the beams by ``size``, metres, on every second line."""
    own = [s.target == target and s.line in data.lines[::2] for s in data.sightings]
    return _along_beams(data, size * np.array(own)[data.sighting])


def rough(data: Observations, chance: np.random.Generator) -> Observations:
    """Surfaces displaced by 4 mm (1 sigma) on each line, like grass or cloth."""
    return _along_beams(data, chance.normal(0, 0.004, len(data.sightings))[data.sighting])


def heavy_tails(data: Observations, chance: np.random.Generator) -> Observations:
    """Range errors of Student's t with 3 degrees of freedom, and 1 % outliers of decimetres."""
    off = 0.004 * chance.standard_t(3, len(data))
    off += (chance.random(len(data)) < 0.01) * chance.normal(0, 0.2, len(data))
    return _along_beams(data, off)


def biased_line(data: Observations, chance: np.random.Generator) -> Observations:
    """Positions of one line wrong by 5 cm."""
    shift = chance.normal(size=3)
    shift *= 0.05 / np.linalg.norm(shift)
    return replace(data, position=data.position + _of_line(data, chance)[:, None] * shift)


def turned_line(data: Observations, chance: np.random.Generator) -> Observations:
    """Attitude of one line wrong by 0.05 deg."""
    turn = chance.normal(size=3)
    turn *= np.radians(0.05) / np.linalg.norm(turn)
    points = data.points_lidar @ rotation_matrix(*turn).T
    own = _of_line(data, chance)[:, None]
    return replace(data, points_lidar=np.where(own, points, data.points_lidar))


KINDS: dict[str, Change | None] = {
    "none": None, "curved": curved, "rough": rough, "POS time / 10": None, "POS time x 10": None,
    "heavy tails": heavy_tails, "biased line": biased_line, "turned line": turned_line,
    "lever arm 2 cm": None,
}  # fmt: skip


def survey(kind: str, seed: int) -> Observations:
    """Observations of a survey with one kind of error."""
    generator, chance = np.random.default_rng([34, seed]), np.random.default_rng([35, seed])
    pos, mounting = HYDROGRAPHIC_INS, TRUTH
    if kind.startswith("POS time"):
        factor = 0.1 if kind.endswith("/ 10") else 10.0
        times = factor * MODEL.position_time, factor * MODEL.attitude_time
        pos = replace(pos, time_position=times[0], time_attitude=times[1])
    if kind == "lever arm 2 cm":
        off = chance.normal(size=3)
        mounting = replace(TRUTH, lever_arm=TRUTH.lever_arm + 0.02 * off / np.linalg.norm(off))
    exact = error_free_survey(mounting, TARGETS, six_courses(), POINT_SPACING, generator, pos=pos)
    data = add_errors(exact, pos, generator)
    change = KINDS[kind]
    data = data if change is None else change(data, chance)
    return average_points_in_cells(data, PRIOR, 0.1, longest=MODEL.knot_interval, no_outliers=True)


@dataclass(frozen=True)
class SurveyResult:
    """Error and sigmas of one survey, degrees, and the codes of its serious warnings.

    ``shortened`` is True if the residuals required shorter correlation times.
    """

    error: np.ndarray
    sigma: np.ndarray
    formal: np.ndarray
    serious: tuple[str, ...]
    shortened: bool


def simulate_and_adjust(kind: str, seed: int) -> SurveyResult:
    data = survey(kind, seed)
    result = adjust(data, PRIOR, MODEL)
    messages = result_warnings(result, cross_checks(data, PRIOR, result))
    return SurveyResult(
        np.degrees(result.boresight - TRUTH.boresight),
        np.degrees(result.sigma),
        np.degrees(result.with_formal_sigmas.sigma),
        tuple(message.code for message in messages if message.is_serious),
        result.given_correlation_times is not None,
    )


def study(kind: str, surveys: int, workers: int = 2) -> list[SurveyResult]:
    if workers == 1:
        return [simulate_and_adjust(kind, seed) for seed in range(surveys)]
    with ProcessPoolExecutor(workers) as pool:
        return list(pool.map(simulate_and_adjust, [kind] * surveys, range(surveys), chunksize=4))


def hits(results: list[SurveyResult], which: str = "sigma") -> np.ndarray:
    """Share of the 95 % intervals that contain the truth, shape (3,)."""
    if not results:
        return np.full(3, np.nan)
    return np.mean([np.abs(a.error) < 1.96 * getattr(a, which) for a in results], axis=0)


def row(kind: str, results: list[SurveyResult]) -> str:
    """One row of the table."""
    without_warning = [each for each in results if not each.serious]

    def cells(values: np.ndarray) -> str:
        return " ".join(f"{100 * value:5.1f}" for value in values)

    raised = np.mean([each.sigma > 1.05 * each.formal for each in results], axis=0)
    codes = Counter(code for each in results for code in each.serious)
    return (
        f"{kind:16s} {cells(hits(results, 'formal'))}   {cells(hits(results))}   {cells(raised)}"
        f"   {100 * (1 - len(without_warning) / len(results)):5.1f}"
        f"   {cells(hits(without_warning))}   {dict(codes)}"
    )


def main() -> None:
    """Print the whole study."""
    surveys = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    print(f"{surveys} surveys a row; roll, pitch, yaw; per cent")
    print(f"{'error':16s} {'formal':18s}  {'stated':18s}  {'raised':18s} serious  without one")
    for kind in sys.argv[2:] or KINDS:
        print(row(kind, study(kind, surveys)), flush=True)


if __name__ == "__main__":
    main()
