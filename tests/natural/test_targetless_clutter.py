"""Test of the effect of foliage, water and a displaced line on many simulated surveys."""

from pathlib import Path

import numpy as np
import pytest

from lispac.workflow.calibration.targetless import targetless
from tests.natural.test_targetless import FEW_SURFACES, jumped, leaves_and_waves
from tests.natural.test_targetless_coverage import surveyed

SCENES = 60
"""Number that determines the ratio of two RMS values of three angles to 10 %."""

DETECTABLE_SHARE = 0.78
"""Share of jumps of five position sigmas that are distinguished from POS errors.

Of a jump, five sixths remain with its line. By a non-central chi-square distribution with three
degrees of freedom, at a level of 0.001.
"""


@pytest.mark.long
@pytest.mark.timeout(7200)
def test_clutter_has_little_effect_and_the_displaced_line_is_named(tmp_path: Path) -> None:
    """`test_targetless` does the same quickly with a single survey."""
    errors: dict[str, list[np.ndarray]] = {"clean": [], "clutter": [], "jump": []}
    named, others_named, clean = [], [], []
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
            found = targetless(*each, count=FEW_SURFACES)
            errors[name].append(found.result.boresight - truth.boresight)
            if name == "clean":
                clean.append(bool(found.disagreeing_lines))
        named.append(wrong in found.disagreeing_lines)
        others_named.append(bool({*found.disagreeing_lines} - {wrong}))
        rounded_errors = *(np.degrees(errors[name][-1]).round(4) for name in errors), clean[-1]
        print(seed, *rounded_errors, wrong, found.disagreeing_lines, flush=True)
    rms = {name: np.sqrt(np.mean(np.square(off), axis=0)) for name, off in errors.items()}
    cost = {name: np.sqrt(np.mean((own / rms["clean"]) ** 2)) for name, own in rms.items()}
    print(f"{SCENES} surveys, rms in deg:")
    for name, own in rms.items():
        print(f"  {name}: {np.degrees(own).round(4)}")
    print(
        f"of the clean error: {cost}; named {np.mean(named):.2f}, "
        f"another {np.mean(others_named):.2f}, any where nothing is wrong {np.mean(clean):.2f}"
    )
    assert cost["clutter"] < 1.5
    assert cost["jump"] < 1.5
    assert np.mean(named) > DETECTABLE_SHARE - 3 * np.sqrt(
        DETECTABLE_SHARE * (1 - DETECTABLE_SHARE) / SCENES
    )
    # Six of 1,000 surveys have a false alarm; more than four of 60 are very unlikely.
    assert np.mean(clean) <= 4 / SCENES
