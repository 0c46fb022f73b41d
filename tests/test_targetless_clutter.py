"""What leaves, water and a line that jumped cost the scene's answer, on many simulated surveys."""

from pathlib import Path

import numpy as np
import pytest

from lispac.workflow.calibration.targetless import targetless
from tests.test_targetless import FEW, jumped, leaves_and_waves
from tests.test_targetless_coverage import surveyed

SCENES = 60
"""The ratio of two root mean squares of three angles each is known to 10 % by so many."""

SURPRISING = 0.78
"""Share of jumps of five sigmas of the position that are told from POS errors, five sixths of them
left to the line: a non-central chi-square, three directions, 0.001 by chance."""


@pytest.mark.long
@pytest.mark.timeout(7200)
def test_clutter_costs_little_and_the_line_is_named(tmp_path: Path) -> None:
    """In short `test_targetless` asks the same of one survey."""
    errors: dict[str, list[np.ndarray]] = {"clean": [], "clutter": [], "jump": []}
    named, innocent, clean = [], [], []
    for seed in range(1, 1 + SCENES):
        folder = tmp_path / str(seed)
        folder.mkdir()
        project, survey, truth = surveyed(folder, seed)
        opened = project, survey
        wrong = list(survey.scans)[seed % len(survey.scans)]
        for name, each in (
            ("clean", opened),
            ("clutter", leaves_and_waves(opened, truth)),
            ("jump", jumped(opened, truth, wrong)),
        ):
            found = targetless(*each, count=FEW)
            errors[name].append(found.result.boresight - truth.boresight)
            if name == "clean":
                clean.append(bool(found.disagreeing))
        named.append(wrong in found.disagreeing)
        innocent.append(bool({*found.disagreeing} - {wrong}))
        told = *(np.degrees(errors[name][-1]).round(4) for name in errors), clean[-1]
        print(seed, *told, wrong, found.disagreeing, flush=True)
    rms = {name: np.sqrt(np.mean(np.square(off), axis=0)) for name, off in errors.items()}
    cost = {name: np.sqrt(np.mean((own / rms["clean"]) ** 2)) for name, own in rms.items()}
    print(f"{SCENES} surveys, rms in deg:")
    for name, own in rms.items():
        print(f"  {name}: {np.degrees(own).round(4)}")
    print(
        f"of the clean error: {cost}; named {np.mean(named):.2f}, another {np.mean(innocent):.2f}, "
        f"any where nothing is wrong {np.mean(clean):.2f}"
    )
    assert cost["clutter"] < 1.5
    assert cost["jump"] < 1.5
    assert np.mean(named) > SURPRISING - 3 * np.sqrt(SURPRISING * (1 - SURPRISING) / SCENES)
    # By chance in six of a thousand surveys: more than four of sixty do not come by chance
    assert np.mean(clean) <= 4 / SCENES
