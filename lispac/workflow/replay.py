"""A survey against the plan it was sailed by: what was foretold, what came, what was missing."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.result import ANGLES
from lispac.errors import ProjectError
from lispac.io.plan_file import TitledPlan
from lispac.project import Project
from lispac.simulation.plan import Line, Plan
from lispac.simulation.prediction import predict
from lispac.workflow.survey import Survey

Array = NDArray[np.float64]

SAME_HEADING = 22.5
"""Degrees by which a line may be sailed off its planned heading and still be that line."""


@dataclass(frozen=True, eq=False)
class Replay:
    """A survey against its plan.

    Attributes
    ----------
    planned : ndarray of shape (3,), radians
        Sigmas foretold for the whole plan.
    sailed : ndarray of shape (3,), radians
        Foretold for what of it was done.
    as_flat : ndarray of shape (3,), radians
        The same with the targets as flat as the survey found them.
    obtained : ndarray of shape (3,), radians
        Stated by the adjustment.
    flatness : tuple of float, metres
        Of the targets, as planned and as found.
    missing_targets : tuple of str
    missing_lines : tuple of Line
    costs : tuple of str
        What each that is missing cost, in sentences.
    """

    planned: Array
    sailed: Array
    as_flat: Array
    obtained: Array
    flatness: tuple[float, float]
    missing_targets: tuple[str, ...]
    missing_lines: tuple[Line, ...]
    costs: tuple[str, ...]


def replay(project: Project, survey: Survey, titled: TitledPlan) -> Replay:
    """Compare what a survey gave with what its plan promised.

    Targets are those of the same name, lines those of the same heading, in the order of time.

    Raises
    ------
    ProjectError
        The project has no result, or none of the plan's targets or lines.
    """
    result, plan = project.result, titled.plan
    if result is None:
        raise ProjectError(f"{project.name} has no result yet; estimate the boresight first.")
    used = [target.name for target in project.of_role("target")]
    missing_targets = tuple(t.name for t in plan.targets if t.name not in used)
    seen = {s.line for target in project.of_role("target") for s in target.sightings}
    headings = [float(np.degrees(survey.heading[name])) for name in survey.heading if name in seen]
    unsailed = _unsailed(plan.lines, headings)
    kept = plan.with_lines([line for k, line in enumerate(plan.lines) if k not in unsailed])
    kept = kept.with_targets([t for t in plan.targets if t.name not in missing_targets])
    if not kept.targets or not kept.lines:
        what = "target" if not kept.targets else "line"
        raise ProjectError(
            f"{project.name} has no {what} of this plan; targets go by their names "
            f"({', '.join(t.name for t in plan.targets)}), lines by their headings."
        )
    sailed = predict(kept).sigma
    found_flatness = float(result.surfaces[0])
    costs = [
        _cost(f"Line {k + 1} ({plan.lines[k].name})", "sailed", kept.with_lines(
            [line for j, line in enumerate(plan.lines) if j not in unsailed or j == k]
        ), sailed)
        for k in unsailed
    ]  # fmt: skip
    costs += [
        _cost(f"Target {name}", "used", kept.with_targets(
            [t for t in plan.targets if t.name not in missing_targets or t.name == name]
        ), sailed)
        for name in missing_targets
    ]  # fmt: skip
    return Replay(
        predict(plan).sigma,
        sailed,
        predict(_as_flat(kept, found_flatness)).sigma,
        np.asarray(result.sigma),
        (plan.flatness, found_flatness),
        missing_targets,
        tuple(plan.lines[k] for k in unsailed),
        tuple(costs),
    )


def _as_flat(plan: Plan, flatness: float) -> Plan:
    targets = [replace(target, flatness=None) for target in plan.targets]
    return replace(plan.with_targets(targets), flatness=flatness)


def _unsailed(lines: Sequence[Line], headings: Sequence[float]) -> list[int]:
    """Which planned lines no sailed one stands for, one sailed line for one planned."""
    left = list(headings)
    unsailed = []
    for k, line in enumerate(lines):
        off = [abs((line.heading_deg - heading + 180) % 360 - 180) for heading in left]
        if off and min(off) <= SAME_HEADING:
            del left[int(np.argmin(off))]
        else:
            unsailed.append(k)
    return unsailed


def _cost(what: str, verb: str, with_it: Plan, without: Array) -> str:
    found = predict(with_it)
    if not np.isfinite(without).all():
        told = (
            "with it the boresight would be determined" if found.determined else "more is missing"
        )
        return f"{what} was not {verb}; {told}."
    gain = found.sigma / without
    k = int(np.argmin(gain))
    return (
        f"{what} was not {verb}: with it the sigma of {ANGLES[k]} would be "
        f"{np.degrees(found.sigma[k]):.4f} instead of {np.degrees(without[k]):.4f} deg."
    )
