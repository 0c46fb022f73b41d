"""Tests of rejecting and restoring sightings when a wrong mounting value may explain them."""

from dataclasses import dataclass, field, replace
from types import SimpleNamespace

import numpy as np
import pytest

from lispac.adjustment.diagnostics import crosscheck
from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.solve import sighting_rejection
from lispac.adjustment.solve.blunders import Blunder
from lispac.errors import RankDeficient
from lispac.messages import error
from lispac.progress import no_progress
from tests.adjustment.test_robustness import PRIOR, survey

GIVEN_SIGMAS = np.full(4, 0.001)
REJECTED = np.array([False, True, False, True])


@dataclass(frozen=True)
class Case:
    """Stand-in for a problem, with the attributes `_reject_unexplained_sightings` uses."""

    parameters: tuple[Parameter, ...] = ()
    rejected: np.ndarray = field(default_factory=lambda: np.zeros(4, dtype=bool))
    surface_sigma: np.ndarray = field(default_factory=lambda: GIVEN_SIGMAS)
    default_surface_sigmas: np.ndarray = field(default_factory=lambda: GIVEN_SIGMAS)

    def with_parameters(self, parameters: tuple[Parameter, ...]) -> "Case":
        return replace(self, parameters=parameters)

    def with_surface_sigma(self, sigma: np.ndarray) -> "Case":
        return replace(self, surface_sigma=np.where(self.rejected, np.inf, sigma))


@dataclass(frozen=True)
class Found:
    """Stand-in for a solution, with the attributes `_reject_unexplained_sightings` uses."""

    problem: Case
    rejected_count: int
    state: None = None
    path: None = None

    @property
    def linearised(self) -> "Found":
        return self


@pytest.mark.parametrize(
    ("contradicted_names", "remaining_count", "is_accepted"),
    [
        ([("x", "y"), ("x",)], {("x", "y"): 0, ("x",): 3}, True),
        ([("x",), ("x", "y")], {("x",): 3, ("x", "y"): 0}, True),
        ([("x",), ("x", "y")], {("x",): 1, ("x", "y"): 3}, True),
        ([("hidden",), ("x", "y")], {("x", "y"): 0}, True),
        ([("x",), ("x", "y")], {("x",): 3, ("x", "y"): 2}, False),
        ([(), ()], {}, False),
    ],
)
def test_given_values_are_freed_if_that_rejects_fewer_sightings(
    contradicted_names: list[tuple[str, ...]], remaining_count: dict[tuple[str, ...], int],
    is_accepted: bool, monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    """Four sightings are rejected with the given values; each freed value counts as one."""
    start, rejected = Found(Case(), 0), Found(Case(rejected=REJECTED), 4)
    names = dict(zip((id(start), id(rejected)), contradicted_names, strict=True))

    def iterated(problem: Case, *_rest: object, **_more: object) -> Found:
        if any(each.name == "hidden" for each in problem.parameters):
            raise RankDeficient("hidden")
        return Found(problem, 0)

    def agreeing(solution: Found, *_rest: object) -> Found:
        if solution is start:
            return rejected
        estimated_names = tuple(each.name for each in solution.problem.parameters)
        return Found(replace(solution.problem, rejected=REJECTED), remaining_count[estimated_names])

    for name, stand_in in {
        "find_contradicted_parameters": lambda here, **_: [
            SimpleNamespace(name=n) for n in names[id(here)]
        ],
        "iterate": iterated,
        "_reject_blunders": agreeing,
        "_count_rejected_sightings": lambda solution: solution.rejected_count,
        "Parameter": lambda name: SimpleNamespace(name=name),
    }.items():
        monkeypatch.setattr(sighting_rejection, name, stand_in)
    found = sighting_rejection._reject_unexplained_sightings(start, [], no_progress)  # type: ignore[arg-type]
    assert (found is not rejected) == is_accepted
    if is_accepted:  # the given values themselves do not change
        problem = found.linearised.problem
        assert problem.parameters == ()
        assert problem.rejected.tolist() == REJECTED.tolist()
        assert problem.surface_sigma.tolist() == [0.001, np.inf, 0.001, np.inf]


def test_a_restored_sighting_is_not_rejected_again(monkeypatch: pytest.MonkeyPatch) -> None:
    found, known_blunders = Blunder("shift", (3,)), []
    todo, back = [found], [found]

    def worst(_here: object, known: set[Blunder]) -> Blunder | None:
        known_blunders.append(set(known))
        return todo.pop() if todo else None

    monkeypatch.setattr(sighting_rejection, "worst_blunder", worst)
    monkeypatch.setattr(
        sighting_rejection,
        "find_restorable_blunder",
        lambda _, rejected: back.pop() if rejected and back else None,
    )
    model = StochasticModel(loss="tukey")
    result = adjust(survey(2, 0.1), PRIOR, model)
    assert result.rejected_sightings == ()
    assert known_blunders[:2] == [set(), {found}]


def test_a_cross_check_without_a_result_has_a_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    points, model = survey(2, 0.3), StochasticModel()
    refused = error("adjustment.parallel_planes")
    whole = adjust(points, PRIOR, model, diagnostics=False)

    def refuse(*_arguments: object, **_more: object) -> None:
        raise RankDeficient(refused)

    monkeypatch.setattr(crosscheck, "estimate", refuse)
    parts = cross_checks(points, PRIOR, whole).parts
    assert {part.reason for part in parts} == {refused}
    assert all(part.boresight is None for part in parts)
