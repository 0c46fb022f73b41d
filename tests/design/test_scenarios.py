"""Tests of the scenarios of figure 4.12 of the thesis, with independent and correlated errors."""

from functools import cache
from itertools import pairwise

import numpy as np
import pytest

from lispac.design.scenarios import (
    LINE_DISTANCES,
    POS_CLASSES,
    SCENARIOS,
    ScenarioOutcome,
    predict_scenarios,
    thesis_setting,
)
from lispac.errors import Cancelled
from lispac.progress import Step


@cache
def everything() -> tuple[ScenarioOutcome, ...]:
    return predict_scenarios(thesis_setting())


def sigmas(scenario: str, model: str) -> dict[str, np.ndarray]:
    """Return sigmas of the angles in degrees by case, and print them."""
    found = {
        each.case: np.degrees(each.sigma)
        for each in everything()
        if (each.scenario, each.pos_errors) == (scenario, model)
    }
    for case, sigma in found.items():
        print(f"{scenario:12s} {model:12s} {case:28s}" + "".join(f"{v:9.4f}" for v in sigma))
    return found


@pytest.mark.parametrize("model", ["independent", "correlated"])
def test_six_lines_are_best(model: str) -> None:
    """Figure 4.12 (a). Two lines with an upright board do not determine all angles."""
    found = sigmas("lines", model)
    best = found.pop("all six")
    for case, sigma in found.items():
        assert (best <= sigma).all(), case
        assert np.isinf(sigma).all() == (case.count(",") == 1), case


def test_an_upright_board_is_best_for_pitch_and_yaw() -> None:
    """Figure 4.12 (b). Level boards above the vessel are not seen."""
    found = sigmas("inclination", "independent")
    upright = found.pop("90 deg")
    for case, sigma in found.items():
        assert (upright[1:] < sigma[1:]).all(), case
    assert np.isinf(found["0 deg"]).all()


def test_with_correlated_errors_a_tilted_board_is_better_for_roll() -> None:
    """The thesis finds upright boards best; that holds here for pitch and yaw, but not for roll."""
    found = sigmas("inclination", "correlated")
    assert (found["90 deg"][1:] <= found["60 deg"][1:]).all()
    assert found["60 deg"][0] < found["90 deg"][0]


@pytest.mark.parametrize("model", ["independent", "correlated"])
def test_larger_boards_are_better(model: str) -> None:
    """Figure 4.12 (c)."""
    ordered = list(sigmas("size", model).values())
    for smaller, larger in pairwise(ordered):
        assert (larger < smaller).all()
    if model == "correlated":
        # The effect of the position error on yaw does not depend on the size.
        assert ordered[-1][2] > 0.95 * ordered[0][2]


def test_three_inclinations_are_best_and_two_almost_as_good() -> None:
    """Figure 4.12 (d)."""
    found = sigmas("targets", "independent")
    three, two = found.pop("90 + 60 + 30"), found["90 + 30"]
    for case, sigma in found.items():
        assert (three <= sigma).all(), case
    assert (two < 1.3 * three).all()
    assert (found["90"] > two).all()


def test_with_correlated_errors_a_second_board_improves_roll_only() -> None:
    found = sigmas("targets", "correlated")
    assert found["90 + 30"][0] < 0.55 * found["90"][0]
    assert found["90 + 60 + 30"][2] > 0.9 * found["90"][2]


def test_distant_boards_are_better_for_yaw() -> None:
    """A position error is a smaller angle at a distant target; independent errors average out."""
    found = sigmas("distance", "correlated")
    yaw = [found[f"{d:g} m"][2] for d in LINE_DISTANCES]
    assert yaw == sorted(yaw, reverse=True)
    assert yaw[-1] < yaw[2] / 1.9
    roll = sigmas("distance", "independent")
    assert roll["80 m"][0] > 2 * roll["15 m"][0]


def test_high_boards_are_better_for_roll_and_pitch() -> None:
    found = sigmas("height", "correlated")
    assert (found["20.0 m"][:2] < found["5.0 m"][:2] / 2).all()


def test_sigmas_decrease_with_the_root_of_the_repetitions() -> None:
    found = sigmas("repeats", "correlated")
    assert (found["4 times"] < 0.6 * found["once"]).all()
    assert (found["4 times"] >= 0.5 * found["once"]).all()
    thesis = sigmas("repeats", "independent")
    assert thesis["4 times"] == pytest.approx(thesis["once"] / 2, rel=1e-6)


def test_lower_speed_only_adds_points() -> None:
    found = sigmas("speed", "independent")
    assert found["4.0 m/s"] == pytest.approx(found["1.0 m/s"] * 2, rel=1e-6)
    correlated = sigmas("speed", "correlated")
    assert (correlated["4.0 m/s"] < 1.06 * correlated["1.0 m/s"]).all()


def test_a_more_accurate_pos_gives_smaller_sigmas() -> None:
    for model in ("independent", "correlated"):
        by_name = sigmas("POS", model)
        found = [by_name[name] for name in POS_CLASSES]
        for better, worse in pairwise(found):
            assert (better < worse).all()


def test_sigmas_of_the_classical_model_are_several_times_too_small() -> None:
    """The ratio is printed, because the correlated model exists for this reason."""
    correlated, thesis = (sigmas("targets", m)["90 + 30"] for m in ("correlated", "independent"))
    print("correlated over independent", (correlated / thesis).round(1))
    assert (correlated > 5 * thesis).all()


def test_selected_scenarios_are_predicted_and_can_be_cancelled() -> None:
    steps: list[str] = []
    found = predict_scenarios(
        thesis_setting(), ("size",), progress=lambda done, step=None: steps.append(str(step or ""))
    )
    assert {each.scenario for each in found} == {"size"}
    assert steps == ["Scenario: size", ""]
    assert {each.scenario for each in everything()} == set(SCENARIOS)

    def stop(fraction: float, step: Step | None = None) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        predict_scenarios(thesis_setting(), ("size",), progress=stop)
