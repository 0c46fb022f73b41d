"""Coverage of the sigmas and frequency of false serious warnings in surveys without errors.

    python -m tests.studies.false_warnings [SURVEYS] [KIND ...]

A row for each kind of survey: boards on six, four, three and two lines, natural planes proposed by
the program, targetless, spinning scanner. It shows the share of 95 % intervals that contain the
truth, in all surveys and in those without a serious warning, the share of surveys with one, and how
often each warning is false or true. Only warnings that name an error are counted as false or true.
Those about the geometry (no redundancy, large standard deviations) are always true. Natural
surfaces may not be flat: this follows from the simulated surfaces.
"""

import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from csv import DictReader
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import cast

import numpy as np

from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.result import AdjustmentResult
from lispac.duplicate_targets import all_warnings
from lispac.errors import AdjustmentError, TargetNotFound
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.simulation.closed_form_survey import add_errors, error_free_survey, six_courses
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.picking import pick_target
from lispac.workflow.calibration.targetless import targetless
from lispac.workflow.planning.simulate import TARGET_LIST_FILE as TARGETS_LIST
from lispac.workflow.planning.simulate import simulate
from lispac.workflow.planning.simulated_setup import read_simulation
from lispac.workflow.project.survey import load_survey
from tests.natural.test_targetless_coverage import surveyed
from tests.studies.coverage_of_errors import MODEL, PRIOR, TARGETS, TRUTH
from tests.studies.coverage_of_errors import POINT_SPACING as SPACING
from tests.studies.natural_scenes import print_results, study

OF_GEOMETRY = {
    "adjustment.large_sigma", "adjustment.large_sigma_unseen", "adjustment.line_unchecked",
    "adjustment.target_unchecked", "adjustment.targets_clustered", "adjustment.carried_by_one",
    "adjustment.targets_act_as_one", "adjustment.one_facing", "targets.sigma_below_prediction",
}  # fmt: skip
"""Codes of warnings about the geometry or the prediction, which are true without errors too."""

PICKED = {"T1", "T2", "V1"}
"""Surfaces of the port used to calibrate the spinning scanner."""

NOT_FLAT = "adjustment.not_flat"
COMMON_POINTS = "targets.counted_twice"


@dataclass(frozen=True, eq=False)
class SurveyOutcome:
    """Error and sigmas of one survey, shape (3,), degrees, and its serious warnings.

    ``result`` is None if only these values were kept.
    """

    error: np.ndarray
    sigma: np.ndarray
    warnings: tuple[Message, ...]
    result: AdjustmentResult | None = None

    @classmethod
    def of(
        cls, result: AdjustmentResult, truth: np.ndarray, warnings: Iterable[Message]
    ) -> "SurveyOutcome":
        """Outcome from a result and the true boresight, shape (3,), radians."""
        serious = tuple(each for each in warnings if each.is_serious)
        error = np.degrees(result.boresight - truth)
        return cls(error, np.degrees(result.sigma), serious, result)


@dataclass(frozen=True)
class WarningCodes:
    """Codes of the false and the true serious warnings about errors in one survey."""

    false: tuple[str, ...]
    true: tuple[str, ...] = ()


def boards(seed: int, courses: int = 6) -> SurveyOutcome:
    chance = np.random.default_rng([36, seed])
    chosen = tuple(six_courses()[k] for k in sorted(chance.choice(6, courses, replace=False)))
    data = add_errors(
        error_free_survey(TRUTH, TARGETS, chosen, SPACING, chance, pos=HYDROGRAPHIC_INS),
        HYDROGRAPHIC_INS, chance,
    )  # fmt: skip
    data = average_points_in_cells(data, PRIOR, 0.1, longest=MODEL.knot_interval, no_outliers=True)
    result = adjust(data, PRIOR, MODEL)
    warnings = result_warnings(result, cross_checks(data, PRIOR, result))
    return SurveyOutcome.of(result, TRUTH.boresight, warnings)


def two_lines(seed: int) -> SurveyOutcome:
    return boards(seed, 2)


def three_lines(seed: int) -> SurveyOutcome:
    return boards(seed, 3)


def four_lines(seed: int) -> SurveyOutcome:
    return boards(seed, 4)


def without_targets(seed: int) -> SurveyOutcome:
    with TemporaryDirectory() as folder:
        project, survey, mounting = surveyed(Path(folder), seed)
        found = targetless(project, survey, count=16)
    return SurveyOutcome.of(found.result, mounting.boresight, result_warnings(found.result, None))


def spinning_boresight_deg(seed: int) -> np.ndarray:
    """True boresight of a survey with a spinning scanner, shape (3,), degrees."""
    return np.random.default_rng([37, seed]).normal(0, 1, 3)


def spinning(
    seed: int, *, points_per_second: float = 60_000, cross_check: bool = True
) -> SurveyOutcome:
    made = read_simulation(
        "port", vessel="launch", scanner="velodyne-hdl-32e", points_per_second=points_per_second,
        errors={"boresight_deg": tuple(spinning_boresight_deg(seed))},
    )  # fmt: skip
    with TemporaryDirectory() as folder:
        project, _ = simulate(Path(folder) / "survey", made, seed=seed)
        survey = load_survey(project)
        with (project.folder / TARGETS_LIST).open() as rows:
            seeds = [row for row in DictReader(rows) if row["name"] in PICKED]
        for row in seeds:
            place = np.array([float(row[axis]) for axis in "xyz"])
            project = pick_target(project, survey, place, name=row["name"])
        solved = estimate(project, survey, cross_check=cross_check)
    assert solved.result is not None
    truth = np.radians(spinning_boresight_deg(seed))
    return SurveyOutcome.of(solved.result, truth, all_warnings(solved))


KINDS: dict[str, Callable[[int], SurveyOutcome]] = {
    "boards": boards, "four lines": four_lines, "three lines": three_lines,
    "two lines": two_lines, "targetless": without_targets, "spinning": spinning,
}  # fmt: skip
NATURAL = "natural"
"""Kind of surveys with proposed natural planes in scenes without boards."""


def survey_outcome(kind: str, seed: int) -> SurveyOutcome | None:
    """Result of a survey, or None without one."""
    try:
        return replace(KINDS[kind](seed), result=None)
    except (AdjustmentError, TargetNotFound) as error:
        print(kind, seed, str(error)[:100])
        return None


def separate_warnings(
    survey: str, warnings: Iterable[Message], bent: frozenset[str]
) -> WarningCodes:
    """Separate false and true warnings among the serious ones that name an error.

    Common points of two targets are counted, not inferred, so that a warning about them is true.

    Parameters
    ----------
    bent : frozenset of str
        Targets that are not flat by the simulated surface.
    """
    true, false = [], []
    for each in warnings:
        if each.code in OF_GEOMETRY:
            continue
        is_true = each.code == COMMON_POINTS or (
            each.code == NOT_FLAT and bent.issuperset(cast(tuple[str, ...], each.params["targets"]))
        )
        (true if is_true else false).append(each.code)
        word = "true" if is_true else "false"
        print(survey, word, each.code, message_text(each)[:260], flush=True)
    return WarningCodes(tuple(set(false)), tuple(set(true)))


def row(kind: str, surveys: int) -> str:
    """Row of the table."""
    bent: list[frozenset[str]] = []
    known: list[SurveyOutcome] = []
    if kind == NATURAL:
        scenes = study(surveys)
        print_results(scenes)
        for each in scenes:
            if each.error is not None and each.sigma is not None:
                known.append(SurveyOutcome(each.error, each.sigma, each.warnings))
                bent.append(each.bent)
    else:
        with ProcessPoolExecutor(2) as pool:
            results = pool.map(survey_outcome, [kind] * surveys, range(surveys), chunksize=2)
            known = [each for each in results if each is not None]
        bent = [frozenset()] * len(known)
    codes = [
        separate_warnings(kind, each.warnings, own) for each, own in zip(known, bent, strict=True)
    ]
    return table_row(kind, known, codes)


def table_row(kind: str, known: list[SurveyOutcome], codes: list[WarningCodes]) -> str:
    """Row of the table from the outcomes of one kind and the codes of their warnings."""

    def hits(some: list[SurveyOutcome]) -> str:
        if not some:
            return "    -     -     -"
        share = np.mean([np.abs(each.error) < 1.96 * each.sigma for each in some], axis=0)
        return " ".join(f"{100 * value:5.1f}" for value in share)

    def shares(each: Iterator[str]) -> str:
        return ", ".join(
            f"{code} {100 * n / len(known):.1f} %" for code, n in Counter(each).most_common()
        ) or "none"  # fmt: skip

    without = [each for each in known if not each.warnings]
    serious = 100 * (1 - len(without) / len(known))
    false = shares(code for each in codes for code in each.false)
    true = shares(code for each in codes for code in each.true)
    return (
        f"{kind:12s} {len(known):4d} surveys   {hits(known)}   {serious:5.1f}   {hits(without)}   "
        f"false: {false}   true: {true}"
    )


def main() -> None:
    """Print the table."""
    print(
        "95 % intervals that contain the truth: roll, pitch, yaw; surveys with a serious warning; "
        "without one"
    )
    surveys = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    for kind in sys.argv[2:] or [*KINDS, NATURAL]:
        print(row(kind, surveys), flush=True)


if __name__ == "__main__":
    main()
