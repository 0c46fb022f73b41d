"""Comparison of a survey with its plan: predicted and obtained precision, and deviations."""

from collections.abc import Mapping
from dataclasses import replace
from math import radians

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.result import ANGLES
from lispac.adjustment.solve.determinability import ANGLE_CODES
from lispac.design.plan import Line, Plan
from lispac.design.prediction import predict
from lispac.errors import ProjectError
from lispac.io.config.plan_file import TitledPlan
from lispac.messages import Message, error, note
from lispac.present.angles import degrees
from lispac.present.planning.design_results import PlanComparison, known_degrees
from lispac.project import Project
from lispac.simulation.closed_form_survey import Ball, Board, Course, scanner_position_abeam
from lispac.workflow.calibration.estimation import observations_of
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

MAX_HEADING_DIFFERENCE_DEG = 22.5
"""Largest difference of the heading of a line from that of the planned line, degrees."""

MAX_DISTANCE_CHANGE, MAX_DISTANCE_CHANGE_SHARE = 2.0, 0.2
"""Largest difference from the planned distance of a line that is not reported, in metres and as a
share of the distance."""


def compare_with_plan(project: Project, survey: Survey, titled: TitledPlan) -> PlanComparison:
    """Compare the precision of a survey with the precision predicted for its plan.

    Targets are matched by name. Planned lines are matched with sailed lines by heading and by the
    distance of the targets. The precision of sailed lines is predicted with their actual distances.

    Raises
    ------
    ProjectError
        If the project has no result, or none of the plan's targets or lines.
    """
    result, plan = project.result, titled.plan
    if result is None:
        raise ProjectError(error("estimate.needed", project=project.name))
    used = [target.name for target in project.targets_of_role("target")]
    missing_targets = tuple(t.name for t in plan.targets if t.name not in used)
    sailed_as = _sailed_lines(plan, project, survey)
    unsailed = [k for k in range(len(plan.lines)) if k not in sailed_as]
    kept = plan.with_lines([sailed_as[k] for k in sorted(sailed_as)])
    kept = kept.with_targets([t for t in plan.targets if t.name not in missing_targets])
    if not kept.targets or not kept.lines:
        code = "plan_survey.no_line_measured" if kept.targets else "plan_survey.no_target_measured"
        raise ProjectError(
            error(code, project=project.name, targets=tuple(t.name for t in plan.targets))
        )
    controlled = {each.target for each in result.control}
    missing_control = [t.name for t in kept.surveyed_targets if t.name not in controlled]
    with_planned_control, kept = kept, kept.without_control(missing_control)
    sailed = predict(kept).sigma
    found_flatness = float(result.surfaces[0])
    costs = [
        _precision_cost(note("plan_survey.line_not_surveyed", line=k + 1,
                             heading=radians(plan.lines[k].heading_deg)), kept.with_lines(
            [sailed_as.get(j, line) for j, line in enumerate(plan.lines)
             if j in sailed_as or j == k]
        ), sailed)
        for k in unsailed
    ]  # fmt: skip
    costs += [
        _precision_cost(
            note("plan_survey.target_not_used", target=name),
            kept.with_targets(
                [t for t in plan.targets if t.name not in missing_targets or t.name == name]
            ).without_control(missing_control),
            sailed,
        )
        for name in missing_targets
    ]
    if missing_control:
        missing = note("plan_survey.control_not_used", targets=tuple(missing_control))
        costs.append(_precision_cost(missing, with_planned_control, sailed))
    # The lever arm has sigmas in both, or in neither.
    obtained = result if any(plan.system.lever_arm_sigma) else result.with_exact_lever_arm
    return PlanComparison(
        planned_sigma_deg=known_degrees(predict(plan).sigma),
        surveyed_sigma_deg=known_degrees(sailed),
        surveyed_with_form_error_sigma_deg=known_degrees(
            predict(_with_flatness(kept, found_flatness)).sigma
        ),
        obtained_sigma_deg=degrees(obtained.sigma),
        flatness_m=(plan.flatness, found_flatness),
        missing_targets=missing_targets,
        missing_lines=tuple(plan.lines[k].name for k in unsailed),
        messages=(*_distance_notes(plan, sailed_as), *costs),
    )


def _distance_notes(plan: Plan, sailed_as: Mapping[int, Line]) -> list[Message]:
    """Notes on the planned lines that were sailed at another distance."""
    return [
        note(
            "plan_survey.other_distance",
            line=k + 1,
            heading=radians(plan.lines[k].heading_deg),
            distance=line.distance,
            planned=plan.lines[k].distance,
        )
        for k, line in sorted(sailed_as.items())
        if abs(line.distance - plan.lines[k].distance)
        > max(MAX_DISTANCE_CHANGE, MAX_DISTANCE_CHANGE_SHARE * plan.lines[k].distance)
    ]


def _with_flatness(plan: Plan, flatness: float) -> Plan:
    targets = [replace(target, flatness=None) for target in plan.targets]
    return replace(plan.with_targets(targets), flatness=flatness)


def _sailed_lines(plan: Plan, project: Project, survey: Survey) -> dict[int, Line]:
    """Planned lines that were sailed, by their index in the plan, each at its actual distance."""
    ranges = _median_ranges(project, survey)
    names = sorted({line for _, line in ranges})
    cost = np.full((len(plan.lines), len(names)), np.inf)
    moved = np.zeros_like(cost)
    for k, (line, course) in enumerate(zip(plan.lines, plan.courses, strict=True)):
        for j, name in enumerate(names):
            heading = float(np.degrees(survey.heading[name]))
            off = abs((line.heading_deg - heading + 180) % 360 - 180)
            farther = [
                _extra_distance(plan, target, course, ranges[target.name, name])
                for target in plan.targets
                if (target.name, name) in ranges
            ]
            if off <= MAX_HEADING_DIFFERENCE_DEG and farther:
                moved[k, j] = float(np.median(farther))
                cost[k, j] = off + abs(moved[k, j])
    from scipy.optimize import linear_sum_assignment

    # An impossible pair costs more than all possible pairs together
    impossible = 1.0 + 2.0 * np.where(np.isfinite(cost), cost, 0.0).sum()
    rows, columns = linear_sum_assignment(np.where(np.isfinite(cost), cost, impossible))
    return {
        int(k): replace(plan.lines[k], distance=max(plan.lines[k].distance + moved[k, j], 0.1))
        for k, j in zip(rows, columns, strict=True)
        if np.isfinite(cost[k, j])
    }


def _median_ranges(project: Project, survey: Survey) -> dict[tuple[str, str], float]:
    """Median range (metres) at which each target was measured on each line."""
    observations = observations_of(project, survey)
    ranges = np.linalg.norm(observations.points_lidar, axis=1)
    return {
        (each.target, each.line): float(np.median(ranges[observations.sighting == k]))
        for k, each in enumerate(observations.sightings)
    }


def _extra_distance(plan: Plan, target: Board | Ball, course: Course, measured: float) -> float:
    """Additional horizontal distance of a target compared with the plan, metres."""
    ray = np.array(target.centre) - scanner_position_abeam(plan.system.mounting, target, course)
    planned = float(np.hypot(ray[0], ray[1]))
    return float(np.sqrt(max(measured**2 - ray[2] ** 2, 0.0)) - planned)


def _precision_cost(missing: Message, with_it: Plan, without: Array) -> Message:
    """Message on the precision if a missing line, target or control had been used.

    Parameters
    ----------
    missing : message that names what is missing
    with_it : plan with it
    without : sigmas without it, shape (3,), radians
    """
    found = predict(with_it)
    if not np.isfinite(without).all():
        if not found.determined:
            return missing
        return note("plan_survey.would_be_determined", missing=missing)
    k = int(np.argmin(found.sigma / without))
    return note(
        "plan_survey.smaller_sigma", missing=missing, angle=note(ANGLE_CODES[ANGLES[k]]),
        sigma=float(found.sigma[k]), without=float(without[k]),
    )  # fmt: skip
