"""``lispac compare``: agreement of calibrations of one mounting, or of methods of one survey."""

import sys
from argparse import Namespace
from collections.abc import Sequence
from typing import Any

import numpy as np

from lispac.adjustment.result import ANGLES
from lispac.cli.compare_methods import compare_methods
from lispac.cli.console import UsageError, print_json
from lispac.message_texts import message_text
from lispac.validation.repeatability import (
    Calibration,
    CalibrationDifference,
    RepeatedCalibrations,
    combine_calibrations,
    compare_calibrations,
    single_calibration,
)
from lispac.workflow.checking.repeated_surveys import calibrations_of

DISTANCES_M = (10.0, 50.0, 100.0)


def compare(arguments: Namespace) -> None:
    """Compare calibrations with the first and combine them; for one project, its methods.

    Raises
    ------
    UsageError
        Where options do not go together.
    """
    if len(arguments.projects) == 1:
        compare_methods(arguments)
        return
    if arguments.compute:
        raise UsageError(
            "compare: --compute runs the other methods on a single project; give one project only."
        )
    compared = calibrations_of(arguments.projects)
    found, counted = compared.each, compared.counted
    only = len(found) > len(counted) == 1
    together = single_calibration(counted[0]) if only else combine_calibrations(counted)
    against = [compare_calibrations(found[0], each) for each in found[1:]]
    if arguments.json:
        print_json(
            {
                "calibrations": [_calibration_values(each) for each in found],
                "differences": [_difference_values(each) for each in against],
                "combined": _combined_values(together)
                | {"counted": [each.name for each in counted]},
                "messages": list(map(message_text, compared.messages)),
            }
        )
        return
    _print_comparison(found, against, together, len(counted))
    sys.stdout.flush()
    for message in compared.messages:
        print(f"note: {message_text(message)}", file=sys.stderr)


def _print_comparison(
    calibrations: Sequence[Calibration],
    against: Sequence[CalibrationDifference],
    together: RepeatedCalibrations,
    counted: int,
) -> None:
    width = max(12, *(len(each.name) for each in calibrations)) + 2
    heads = "".join(f"{f'{angle}, 1 sigma':>20s}" for angle in ANGLES)
    print(f"{'calibration':{width}s}{heads}  deg")
    for each in calibrations:
        print(f"{each.name:{width}s}{_angle_cells(each.boresight, each.sigma)}")
    print(f"{'all together':{width}s}{_angle_cells(together.boresight, together.sigma)}")
    if together.spread is not None:
        print(f"{'spread':{width}s}" + "".join(f"{v:20.4f}" for v in np.degrees(together.spread)))
    print(f"\ndifference from {calibrations[0].name}, and (difference / sigma)")
    for change in against:
        cells = "".join(
            f"{np.degrees(angle):+12.4f} {f'({significance:+.1f})':>7s}"
            for angle, significance in zip(change.angles, change.significance, strict=True)
        )
        print(f"{change.second:{width}s}{cells}")
        effects = ", ".join(
            f"{100 * change.largest_displacement(far):.1f} cm at {far:.0f} m" for far in DISTANCES_M
        )
        verdict = "DIFFER" if change.differ else "agree"
        print(
            f"{'':{width}s}  {verdict} ({_probability_text(change.probability)}); "
            f"point shift {effects}"
        )
    if counted > 2:
        relation = "MORE than" if together.differ else "as"
        words = f"scatter {relation} expected from their sigmas"
        print(f"\nall calibrations {words} ({_probability_text(together.probability)})")


def _probability_text(probability: float) -> str:
    return f"p = {probability:.3f}" if probability >= 0.001 else "p < 0.001"


def _angle_cells(angles: np.ndarray, sigmas: np.ndarray) -> str:
    return "".join(
        f"{angle:+12.4f} {sigma:7.4f}"
        for angle, sigma in zip(np.degrees(angles), np.degrees(sigmas), strict=True)
    )


def _calibration_values(each: Calibration) -> dict[str, Any]:
    return {
        "name": each.name,
        "boresight_deg": np.degrees(each.boresight).tolist(),
        "sigma_deg": np.degrees(each.sigma).tolist(),
    }


def _difference_values(each: CalibrationDifference) -> dict[str, Any]:
    return {
        "first": each.first,
        "second": each.second,
        "angles_deg": np.degrees(each.angles).tolist(),
        "sigma_deg": np.degrees(each.sigma).tolist(),
        "significance": each.significance.tolist(),
        "significant": list(each.significant),
        "chi_square": each.statistic,
        "probability": each.probability,
        "differ": each.differ,
        "rotation_deg": float(np.degrees(each.turn)),
        "distances_m": list(DISTANCES_M),
        "displacement_m": [each.largest_displacement(d) for d in DISTANCES_M],
    }


def _combined_values(each: RepeatedCalibrations) -> dict[str, Any]:
    return {
        "boresight_deg": np.degrees(each.boresight).tolist(),
        "sigma_deg": np.degrees(each.sigma).tolist(),
        "spread_deg": None if each.spread is None else np.degrees(each.spread).tolist(),
        "chi_square": each.statistic,
        "probability": each.probability,
        "differ": each.differ,
    }
